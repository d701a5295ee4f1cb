//! Certificates of surfaces that were cut open.

use crate::surface::{Piece, Step, Surface};
use coface_check::claims::{Claims, cells, count, equal, keys};
use coface_check::json::{field, index, list, optional};
use coface_check::{Fault, Verdict};
use serde_json::{Value, json};
use std::collections::BTreeSet;

const PIECE_KEYS: [&str; 11] = [
    "surface",
    "cut_edges",
    "boundary_edges",
    "euler_characteristic",
    "f_vector",
    "base",
    "generators",
    "relator",
    "seams",
    "word",
    "canonical",
];
const SEAM_KEYS: [&str; 7] = ["number", "name", "kind", "glued", "edges", "length", "vertices"];

/// Checks a certificate of a cut.
pub(crate) fn check(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let surface = Surface::read(inputs[0])?;
    let answer = field(whole, "answer", "answer")?;
    let mut claims = Claims::of(answer);
    match optional(whole, "along") {
        None => disks(&surface, field(whole, "proof", "proof")?, answer, &mut claims)?,
        Some(path) => along(&surface, path, field(whole, "proof", "proof")?, answer, &mut claims)?,
    }
    claims.know(&["file", "components", "f_vector", "path"]);
    Ok(claims.verdict())
}

/// Vertices of a list.
pub fn vertices(value: &Value, what: &str, step: &str) -> Result<Vec<u32>, Fault> {
    list(value, what, step)?.iter().map(|vertex| index(vertex, "a vertex", step)).collect()
}

/// The edges along a path of vertices.
pub(crate) fn edges_along(surface: &Surface, path: &[u32], step: &str) -> Result<Vec<u32>, Fault> {
    let edge = |pair: &[u32]| {
        let found = surface.edge([pair[0], pair[1]]);
        found.ok_or_else(|| Fault::new(step, format!("no edge joins vertices {} and {}", pair[0], pair[1])))
    };
    path.windows(2).map(edge).collect()
}

/// Marks edges that are cut: inner ones, each once.
fn mark(surface: &Surface, edges: &[u32], step: &str) -> Result<Vec<bool>, Fault> {
    let mut is_cut = vec![false; surface.edge_count()];
    for &edge in edges {
        if !surface.is_inner(edge) || std::mem::replace(&mut is_cut[edge as usize], true) {
            return Err(Fault::new(step, "an edge of the cut is on the boundary, or twice there"));
        }
    }
    Ok(is_cut)
}

/// What the answer counts of a piece is what was found.
fn counted(said: &Value, piece: &Piece) -> Result<(), Fault> {
    keys(said, &PIECE_KEYS, "a component")?;
    let sides: usize = piece.loops.iter().map(Vec::len).sum();
    equal(said, "boundary_edges", &json!(sides), "a component")?;
    equal(said, "euler_characteristic", &json!(piece.euler_characteristic()), "a component")?;
    equal(said, "f_vector", &json!(piece.counts), "a component")
}

/// The counts of all pieces together, and of vertices in no face, are those of the answer.
fn all_counted(surface: &Surface, pieces: &[Piece], claims: &mut Claims<'_>) -> Result<(), Fault> {
    let mut sum = [surface.isolated, 0, 0];
    pieces.iter().for_each(|piece| sum.iter_mut().zip(piece.counts).for_each(|(sum, count)| *sum += count));
    claims.equal("f_vector", &json!(sum))
}

/// Each component was cut to a disk.
fn disks(surface: &Surface, proof: &Value, answer: &Value, claims: &mut Claims<'_>) -> Result<(), Fault> {
    let step = "cut";
    if optional(answer, "path").is_some() {
        return Err(Fault::new("answer", "\"path\" is there, and the certificate has no key \"along\""));
    }
    let listed = list(field(proof, "edges", step)?, "\"edges\"", step)?.iter().map(|ends| {
        let ends = vertices(ends, "an edge", step)?;
        match (ends.len(), edges_along(surface, &ends, step)?.first()) {
            (2, Some(edge)) => Ok(*edge),
            _ => Err(Fault::new(step, "an edge has not two vertices")),
        }
    });
    let is_cut = mark(surface, &listed.collect::<Result<Vec<u32>, Fault>>()?, step)?;
    let (below_of, below) = surface.pieces(&vec![false; surface.edge_count()]);
    let (piece_of, pieces) = surface.pieces(&is_cut);
    let said = list(field(answer, "components", "answer")?, "\"components\"", "answer")?;
    if said.len() != below.len() || pieces.len() != below.len() {
        let message = format!("{} components are cut to {} pieces", below.len(), pieces.len());
        return Err(Fault::new(step, format!("{message}, and the answer has {}", said.len())));
    }
    let mut is_met = vec![false; below.len()];
    let mut passed = Passed { is_seam: vec![false; surface.edge_count()], numbers: Vec::new() };
    for (i, said) in said.iter().enumerate() {
        let base = index(field(said, "base", "answer")?, "\"base\"", "answer")?;
        let face = surface.face_at(base);
        let face =
            face.ok_or_else(|| Fault::new("answer", format!("vertex {base} lies in no face")))? as usize;
        let (piece, below) = (&pieces[piece_of[face]], &below[below_of[face]]);
        if std::mem::replace(&mut is_met[below_of[face]], true) {
            return Err(Fault::new("answer", format!("two components have vertex {base}")));
        }
        // A connected surface with a boundary and Euler characteristic 1 is a disk.
        if piece.counts[2] != below.counts[2] || piece.euler_characteristic() != 1 || piece.loops.is_empty() {
            return Err(Fault::new(step, format!("component {i} is not cut to a disk")));
        }
        counted(said, piece)?;
        let cut = piece.loops.iter().flatten().filter(|step| is_cut[surface.edge_of(step.side) as usize]);
        // Both sides of a cut edge are on the boundary of the disk.
        let cut = cut.count() / 2;
        // A tree of edges and one of the edges between faces leave so many.
        let generators = if below.loops.is_empty() { 2 } else { 1 } - below.euler_characteristic();
        equal(said, "surface", &json!(below.name()), "a component")?;
        equal(said, "cut_edges", &json!(cut), "a component")?;
        equal(said, "generators", &json!(generators), "a component")?;
        // Of the base it is known that the component has it, not that loops start there.
        claims.leave(true, "components.base");
        let edges = count(cut, "edge", "edges");
        let name = below.name();
        claims.prove(format!("a component, {name}, cut along {edges} to a disk of {}", cells(piece.counts)));
        if let number @ 1.. = seams(surface, said, piece, &mut passed, claims)? {
            let seams = count(number, "seam", "seams");
            claims.prove(format!(
                "the way around this disk passes {seams} twice, as the word says: glued there it is the component again"
            ));
        }
    }
    passed.numbers.sort_unstable();
    if !passed.numbers.iter().copied().eq(1..=passed.numbers.len() as u64) {
        return Err(Fault::new("answer", "the seams are not numbered from 1 on"));
    }
    all_counted(surface, &pieces, claims)
}

/// The seams of all components.
struct Passed {
    /// For each edge whether a seam runs along it.
    is_seam: Vec<bool>,
    /// Their numbers.
    numbers: Vec<u64>,
}

/// The seams of a component, and their word: how many they are.
fn seams(
    surface: &Surface,
    said: &Value,
    disk: &Piece,
    passed: &mut Passed,
    claims: &mut Claims<'_>,
) -> Result<usize, Fault> {
    let step = "seams";
    let mut paths = Vec::new();
    let own = list(field(said, "seams", step)?, "\"seams\"", step)?;
    let on_disk: BTreeSet<u32> = disk.loops.iter().flatten().map(|step| surface.edge_of(step.side)).collect();
    let mut is_own = BTreeSet::new();
    for seam in own {
        keys(seam, &SEAM_KEYS, "a seam")?;
        let path = vertices(field(seam, "vertices", step)?, "\"vertices\"", step)?;
        let edges = edges_along(surface, &path, step)?;
        for &edge in &edges {
            let is_cut = surface.is_inner(edge) && on_disk.contains(&edge);
            if !is_cut || std::mem::replace(&mut passed.is_seam[edge as usize], true) {
                return Err(Fault::new(
                    step,
                    "a seam runs along an edge that is not cut, or that another passes",
                ));
            }
            is_own.insert(edge);
        }
        passed.numbers.push(index(field(seam, "number", step)?, "\"number\"", step)?.into());
        if edges.is_empty() {
            return Err(Fault::new(step, "a seam has no edge"));
        }
        equal(seam, "edges", &json!(edges.len()), "a seam")?;
        paths.push(path);
    }
    // The way around the disk along seams alone, and what the word says.
    let around = disk.loops.iter().flatten().filter(|step| is_own.contains(&surface.edge_of(step.side)));
    let around: Vec<[u32; 2]> = around.map(|&step| surface.ends_of(step)).collect();
    let (mut spelled, mut signs) = (Vec::with_capacity(around.len()), vec![Vec::new(); paths.len()]);
    for letter in list(field(said, "word", step)?, "\"word\"", step)? {
        let letter = letter.as_i64().unwrap_or(0);
        let place = usize::try_from(letter.unsigned_abs()).unwrap_or(0).wrapping_sub(1);
        let Some(path) = paths.get(place).filter(|_| spelled.len() <= around.len()) else {
            return Err(Fault::new(step, format!("the word has a letter {letter} too much, or of no seam")));
        };
        signs[place].push(letter > 0);
        let steps = path.windows(2).map(|pair| [pair[0], pair[1]]);
        match letter > 0 {
            true => spelled.extend(steps),
            false => spelled.extend(steps.rev().map(|[a, b]| [b, a])),
        }
    }
    if !is_rotated(&around, &spelled) {
        let back: Vec<[u32; 2]> = around.iter().rev().map(|[a, b]| [*b, *a]).collect();
        if !is_rotated(&back, &spelled) {
            return Err(Fault::new(step, "the word does not spell the way around the disk"));
        }
    }
    for (seam, signs) in own.iter().zip(signs) {
        // Passed twice in one direction, the disk is glued to itself with a turn.
        let found = if signs.windows(2).all(|pair| pair[0] == pair[1]) { "moebius" } else { "annulus" };
        equal(seam, "glued", &json!(found), "a seam")?;
        for key in ["name", "kind", "length"] {
            claims.leave(optional(seam, key).is_some(), &format!("components.seams.{key}"));
        }
    }
    for key in ["relator", "canonical"] {
        claims.leave(optional(said, key).is_some(), &format!("components.{key}"));
    }
    Ok(own.len())
}

/// Whether two cyclic sequences are the same, where each item of the first occurs at most twice.
fn is_rotated(around: &[[u32; 2]], spelled: &[[u32; 2]]) -> bool {
    if around.len() != spelled.len() {
        return false;
    }
    let Some(first) = spelled.first() else { return true };
    let starts = (0..around.len()).filter(|&start| around[start] == *first);
    // An edge is passed twice, so there are not more places to start from.
    starts.take(2).any(|start| around[start..].iter().chain(&around[..start]).eq(spelled))
}

/// The surface was cut along a path.
fn along(
    surface: &Surface,
    path: &Value,
    proof: &Value,
    answer: &Value,
    claims: &mut Claims<'_>,
) -> Result<(), Fault> {
    let step = "along";
    let path = vertices(path, "\"along\"", step)?;
    let edges = edges_along(surface, &path, step)?;
    let is_cut = mark(surface, &edges, step)?;
    let is_closed = path.len() > 2 && path.first() == path.last();
    let mut once = path[usize::from(is_closed).min(path.len())..].to_vec();
    once.sort_unstable();
    if edges.is_empty() || once.windows(2).any(|pair| pair[0] == pair[1]) {
        return Err(Fault::new(step, "the path has no edge, or meets itself"));
    }
    let (piece_of, pieces) = surface.pieces(&is_cut);
    let has_cut = |way: &&Vec<Step>| way.iter().any(|step| is_cut[surface.edge_of(step.side) as usize]);
    let sides = pieces.iter().flat_map(|piece| &piece.loops).filter(has_cut).count();
    let kind = match (is_closed, sides) {
        (false, _) => "open",
        (true, 2) => "two-sided",
        (true, _) => "one-sided",
    };
    let said = field(answer, "path", "answer")?;
    keys(said, &["kind", "edges"], "\"path\"")?;
    if *said != json!({"kind": kind, "edges": edges.len()}) {
        return Err(Fault::new("answer", format!("the path is {kind} and has {} edges", edges.len())));
    }
    let way: Vec<String> = path.iter().map(u32::to_string).collect();
    claims.prove(format!("the path {} is {kind} and cut, each edge of it once", way.join(" ")));
    let said = list(field(answer, "components", "answer")?, "\"components\"", "answer")?;
    let faces = list(field(proof, "faces", step)?, "\"faces\"", step)?;
    if said.len() != pieces.len() || faces.len() != pieces.len() {
        return Err(Fault::new(
            "answer",
            format!("cut along the path the surface has {} components", pieces.len()),
        ));
    }
    let mut is_met = vec![false; pieces.len()];
    for (said, face) in said.iter().zip(faces) {
        let face = surface.face(vertices(face, "a face", step)?);
        let number = face.map(|face| piece_of[face as usize]).filter(|&number| !is_met[number]);
        let number =
            number.ok_or_else(|| Fault::new(step, "a face is not there, or of another's component"))?;
        is_met[number] = true;
        let piece = &pieces[number];
        counted(said, piece)?;
        equal(said, "surface", &json!(piece.name()), "a component")?;
        for key in ["base", "generators", "relator", "seams", "word", "canonical", "cut_edges"] {
            claims.leave(optional(said, key).is_some(), &format!("components.{key}"));
        }
        claims.prove(format!("a component, {}, of {}", piece.name(), cells(piece.counts)));
    }
    all_counted(surface, &pieces, claims)
}
