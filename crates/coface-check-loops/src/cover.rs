//! Certificates of universal covers and of orientation double covers.

use crate::cut::vertices;
use crate::surface::{Surface, name};
use coface_check::claims::{Claims, cells, count};
use coface_check::json::{field, list};
use coface_check::{Fault, Verdict};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};

/// Checks a certificate of a part of a universal cover.
pub(crate) fn universal(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let below = Surface::read(inputs[0])?;
    let (answer, proof) = (field(whole, "answer", "answer")?, field(whole, "proof", "proof")?);
    let sheets = Sheets::read(&below, proof)?;
    let mut claims = Claims::of(answer);
    let no_cut = vec![false; below.edge_count()];
    let (piece_of, pieces) = below.pieces(&no_cut);
    let (_, above) = sheets.cover.pieces(&vec![false; sheets.cover.edge_count()]);
    let [cover] = &above[..] else {
        return Err(Fault::new("cover", format!("the faces are {} pieces, not one", above.len())));
    };
    let number = sheets.faces.first().map_or(0, |&face| piece_of[face as usize]);
    let component = &pieces[number];
    let faces = component.counts[2];
    // Each copy has each face of the component once.
    let copies = sheets.faces.len() / faces;
    let of_component = (0u32..).zip(&piece_of).filter(|(_, piece)| **piece == number).map(|(face, _)| face);
    let of_component: Vec<u32> = of_component.collect();
    for copy in sheets.faces.chunks(faces) {
        let mut copy = copy.to_vec();
        copy.sort_unstable();
        if copy != of_component {
            return Err(Fault::new("cover", "a copy has not each face of the component once"));
        }
    }
    sheets.check_copies(faces)?;
    let characteristic = cover.euler_characteristic();
    // A connected surface is a disk or a sphere by these numbers, and both are simply connected.
    let is_disk = characteristic == 1 && !cover.loops.is_empty();
    if !is_disk && characteristic != 2 {
        return Err(Fault::new(
            "cover",
            format!("the Euler characteristic is {characteristic}: it is no disk or sphere"),
        ));
    }
    let shape = if is_disk { "disk" } else { "sphere" };
    let component = component.name();
    claims.equal("surface", &json!(component))?;
    claims.equal("components", &json!(pieces.len()))?;
    claims.equal("copies", &json!(copies))?;
    claims.equal("f_vector", &json!(cover.counts))?;
    claims.equal("euler_characteristic", &json!(characteristic))?;
    claims.prove(format!(
        "{}, glued to a {shape} of {}, on which the way down to the {component} is a local isomorphism",
        count(copies, "copy", "copies"),
        cells(cover.counts)
    ));
    let is_complete = sheets.is_complete(&below);
    claims.equal("complete", &json!(is_complete))?;
    if is_complete {
        claims.prove(format!(
            "it is the universal cover: a covering of degree {copies} that is simply connected"
        ));
    }
    if sheets.words(&below, answer, proof, faces)? {
        claims.know(&["letters"]);
    }
    if copies > 1 {
        claims.prove("each word crosses letters from the first copy to its own copy".to_owned());
    }
    claims.know(&["file", "words"]);
    Ok(claims.verdict())
}

/// The faces of a cover and what they lie over.
struct Sheets {
    cover: Surface,
    /// For each face of the cover the face below.
    faces: Vec<u32>,
    /// For each edge of the cover the edge below.
    edges: Vec<u32>,
}

impl Sheets {
    /// Reads the faces of a cover, and tests that they lie over faces, next to each other if they are so below, and that no vertex has two over one face.
    fn read(below: &Surface, proof: &Value) -> Result<Self, Fault> {
        let step = "cover";
        let sources = vertices(field(proof, "vertices", step)?, "\"vertices\"", step)?;
        let polygons = list(field(proof, "faces", step)?, "\"faces\"", step)?;
        let polygons = polygons.iter().map(|polygon| vertices(polygon, "a face", step));
        let polygons = polygons.collect::<Result<Vec<_>, Fault>>()?;
        let views: Vec<&[u32]> = polygons.iter().map(Vec::as_slice).collect();
        let cover = Surface::of(&views)?;
        let source = |vertex: u32| {
            let found = sources.get(vertex as usize).copied();
            found.ok_or_else(|| Fault::new(step, format!("vertex {vertex} lies over none")))
        };
        let (mut faces, mut edges) = (Vec::new(), vec![0; cover.edge_count()]);
        for (number, polygon) in polygons.iter().enumerate() {
            let over = polygon.iter().map(|&vertex| source(vertex)).collect::<Result<Vec<u32>, Fault>>()?;
            let fault = || Fault::new(step, format!("face {number} lies over no face"));
            let face = below.face(over.clone()).ok_or_else(fault)?;
            for i in 0..over.len() {
                let j = (i + 1) % over.len();
                let edge =
                    below.edge([over[i], over[j]]).filter(|&edge| below.faces_of(edge).any(|of| of == face));
                let edge = edge.ok_or_else(fault)?;
                if let Some(above) = cover.edge([polygon[i], polygon[j]]) {
                    edges[above as usize] = edge;
                }
            }
            faces.push(face);
        }
        let corners = cover.corners_of_faces().map(|(vertex, face)| (vertex, faces[face as usize]));
        let mut corners: Vec<(u32, u32)> = corners.collect();
        corners.sort_unstable();
        if corners.windows(2).any(|pair| pair[0] == pair[1]) {
            return Err(Fault::new(step, "a vertex has two faces over one face: it is a branch point"));
        }
        Ok(Self { cover, faces, edges })
    }

    /// Each copy, of so many faces, is connected, and all are glued inside along the same edges.
    fn check_copies(&self, faces: usize) -> Result<(), Fault> {
        let (mut is_between, mut inside) = (Vec::new(), BTreeMap::<usize, BTreeSet<u32>>::new());
        for (above, &edge) in (0u32..).zip(&self.edges) {
            let copies: Vec<usize> = self.cover.faces_of(above).map(|face| face as usize / faces).collect();
            is_between.push(copies.windows(2).any(|pair| pair[0] != pair[1]));
            if let [a, b] = copies[..]
                && a == b
            {
                inside.entry(a).or_default().insert(edge);
            }
        }
        let (_, pieces) = self.cover.pieces(&is_between);
        let mut glued = inside.values();
        let first = glued.next();
        let is_alike =
            glued.all(|edges| Some(edges) == first) && (inside.is_empty() || inside.len() == pieces.len());
        match is_alike && pieces.len() * faces == self.faces.len() {
            true => Ok(()),
            false => Err(Fault::new("cover", "the copies are not connected, or not glued alike inside")),
        }
    }

    /// Whether an edge over one of two faces has two faces itself, always.
    fn is_complete(&self, below: &Surface) -> bool {
        (0u32..).zip(&self.edges).all(|(above, &edge)| self.cover.is_inner(above) || !below.is_inner(edge))
    }

    /// Each word ends with a letter that is crossed from the copy of the word without it. Whether each letter is the last one of a word: then all
    /// are what they are said to be.
    fn words(&self, below: &Surface, answer: &Value, proof: &Value, faces: usize) -> Result<bool, Fault> {
        let step = "words";
        let letters = list(field(answer, "letters", step)?, "\"letters\"", step)?.iter().map(|ends| {
            let ends = vertices(ends, "a letter", step)?;
            let edge = <[u32; 2]>::try_from(ends).ok().and_then(|ends| below.edge(ends));
            edge.ok_or_else(|| Fault::new(step, "a letter is no edge"))
        });
        let letters = letters.collect::<Result<Vec<u32>, Fault>>()?;
        let from = list(field(proof, "from", step)?, "\"from\"", step)?;
        // The copies between which each edge over a letter lies, by the face below on the side of the first one.
        let mut crossings: BTreeSet<(u32, u32, usize, usize)> = BTreeSet::new();
        for (above, &edge) in (0u32..).zip(&self.edges) {
            let sides: Vec<u32> = self.cover.faces_of(above).collect();
            if let ([a, b], true) = (&sides[..], letters.contains(&edge)) {
                for [a, b] in [[*a, *b], [*b, *a]] {
                    let [here, there] = [a, b].map(|face| face as usize / faces);
                    crossings.insert((edge, self.faces[a as usize], here, there));
                }
            }
        }
        let mut is_crossed = vec![false; letters.len()];
        let mut copies: BTreeMap<Vec<i64>, usize> = BTreeMap::new();
        let words = list(field(answer, "words", step)?, "\"words\"", step)?;
        if words.len() != self.faces.len() / faces {
            return Err(Fault::new(step, "there is not a word for each copy"));
        }
        for (copy, word) in words.iter().enumerate() {
            let letter =
                |letter: &Value| letter.as_i64().ok_or_else(|| Fault::new(step, "a letter is no number"));
            let word = list(word, "a word", step)?.iter().map(letter).collect::<Result<Vec<i64>, Fault>>()?;
            let is_reached = match word.split_last() {
                None => copy == 0,
                Some((letter, before)) => {
                    let place = usize::try_from(letter.unsigned_abs()).unwrap_or(0).wrapping_sub(1);
                    if let Some(is_crossed) = is_crossed.get_mut(place) {
                        *is_crossed = true;
                    }
                    let start =
                        from.get(place).and_then(|face| below.face(vertices(face, "a face", step).ok()?));
                    match (copies.get(before), letters.get(place), start) {
                        (Some(&here), Some(&edge), Some(start)) if *letter > 0 => {
                            crossings.contains(&(edge, start, here, copy))
                        }
                        (Some(&here), Some(&edge), Some(start)) => {
                            crossings.contains(&(edge, start, copy, here))
                        }
                        _ => false,
                    }
                }
            };
            if !is_reached || copies.insert(word, copy).is_some() {
                return Err(Fault::new(
                    step,
                    format!("the word of copy {copy} does not lead there, or is there twice"),
                ));
            }
        }
        Ok(is_crossed.into_iter().all(|is_crossed| is_crossed))
    }
}

/// Checks a certificate of an orientation double cover. An orientable component has two copies of itself above it; another one has one orientable
/// component, with twice its Euler characteristic and its boundary loops twice.
pub(crate) fn orientation(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let surface = Surface::read(inputs[0])?;
    let answer = field(whole, "answer", "answer")?;
    let (_, pieces) = surface.pieces(&vec![false; surface.edge_count()]);
    let (mut below, mut above, mut counts) = (Vec::new(), Vec::new(), [2 * surface.isolated, 0, 0]);
    for piece in &pieces {
        below.push(piece.name());
        match piece.is_orientable {
            true => above.extend([piece.name(), piece.name()]),
            false => above.push(name(true, 2 * piece.euler_characteristic(), 2 * piece.loops.len())),
        }
        counts.iter_mut().zip(piece.counts).for_each(|(sum, count)| *sum += 2 * count);
    }
    let mut claims = Claims::of(answer);
    for (key, mut found) in [("surfaces_below", below), ("surfaces", above)] {
        let said = list(field(answer, key, "answer")?, key, "answer")?
            .iter()
            .map(|name| name.as_str().unwrap_or(""));
        let mut said: Vec<&str> = said.collect();
        said.sort_unstable();
        found.sort_unstable();
        if said != found {
            return Err(Fault::new("answer", format!("\"{key}\" is {found:?} in some order")));
        }
        claims.know(&[key]);
        claims.prove(format!("{key}, in some order: {}", found.join(", ")));
    }
    let [v, e, f] = counts.map(|count| count as i64);
    claims.equal("copies", &json!(2))?;
    claims.equal("f_vector", &json!(counts))?;
    claims.equal("euler_characteristic", &json!(v - e + f))?;
    claims.know(&["file"]);
    Ok(claims.verdict())
}
