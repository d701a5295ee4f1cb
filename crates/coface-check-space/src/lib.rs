//! A checker of the certificates of arrangements and Booleans in space. It shares no code with what computed them: it reads surfaces by itself, and decides everything
//! in fractions of integers of any length, by doubles where these suffice.
//!
//! A certificate has exact vertices, and for each polygon of the inputs triangles that fill it. [`check`] tests that they do, and that no triangle
//! meets the inside of another. Then all points in front of a triangle are alike, and a ray from one of them says in which inputs they are. So it
//! finds the boundary of the result, and its volume. `docs/certificates.md` has each rule and why it proves the claim. Certificates of other
//! kinds are handed to [`coface_check_plane`].

mod cells;
mod meeting;
mod pieces;
mod point;
mod solids;
mod tree;
mod volume;
mod winding;

use cells::{Cells, side};
use coface_check::json::{field, index, list, optional, text};
use coface_check::{Fault, Verdict};
use coface_check_plane::{Formula, Rule};
use pieces::Pieces;
use point::{Plane, Point};
use serde_json::{Value, json};
use solids::Solids;
use std::collections::BTreeMap;
use tree::Tree;

/// Checks a certificate of any kind against the bytes of its inputs, in their order.
///
/// # Errors
/// A [`Fault`] with the first step that fails.
///
/// # Complexity
/// O(n log n) decisions for n triangles whose boxes meet few others; certificates of other kinds as [`coface_check_plane::check`].
///
/// # Examples
/// A tetrahedron of volume 1, as it is.
/// ```
/// let input = b"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 6\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
/// let hash = coface_check::sha256(input);
/// let certificate = |volume: f64| format!(
///     r#"{{"coface_certificate":1,"kind":"solids","inputs":[{{"name":"a.off","sha256":"{hash}"}}],"rule":"nonzero","formula":"0",
///         "answer":{{"dimension":3,"measure":{volume:?},"closed":true,"unbounded":false}},
///         "proof":{{"vertices":[[0,0,0,1],[1,0,0,1],[0,1,0,1],[0,0,6,1]],"polygons":[[0,2,1],[0,1,3],[1,2,3],[2,0,3]]}}}}"#
/// );
/// let verdict = coface_check_space::check(certificate(1.0).as_bytes(), &[input]).expect("a sixth of 6");
/// assert_eq!(verdict.proved()[0], "4 triangles that fill the 4 polygons of the inputs and meet the insides of others in single points at most");
/// assert!(coface_check_space::check(certificate(1.1).as_bytes(), &[input]).is_err());
/// ```
pub fn check(certificate: &[u8], inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    check_opened(&coface_check::opened(certificate, inputs)?, inputs)
}

/// The same for a certificate that [`coface_check::opened`] gave for these inputs.
///
/// # Errors
/// A [`Fault`] with the first step that fails.
///
/// # Complexity
/// That of [`check`].
///
/// # Examples
/// See [`check`].
pub fn check_opened(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    match text(field(whole, "kind", "certificate")?, "\"kind\"", "certificate")? {
        "solids" => boolean(whole, inputs),
        "space" => arrangement(whole, inputs),
        _ => coface_check_plane::check_opened(whole, inputs),
    }
}

/// The corners of the polygons of all inputs, one input after the other, as the checker reads them.
///
/// # Errors
/// A [`Fault`] for a file that the checker does not read.
///
/// # Examples
/// ```
/// let corners = coface_check_space::corners(&[b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 0.5 0\n3 0 1 2\n"]).expect("a triangle");
/// assert_eq!(corners, [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.5, 0.0]]]);
/// ```
pub fn corners(inputs: &[&[u8]]) -> Result<Vec<Vec<[f64; 3]>>, Fault> {
    Ok(Solids::read(inputs)?.polygons.into_iter().map(|polygon| polygon.corners).collect())
}

/// The pieces of a certificate, in a tree and with their planes.
struct Arrangement {
    all: Pieces,
    tree: Tree,
    planes: Vec<Plane>,
    title: String,
}

impl Arrangement {
    /// Reads the inputs and the proof of a certificate, and tests that no piece meets the inside of another.
    fn read(whole: &Value, inputs: &[&[u8]]) -> Result<Self, Fault> {
        let solids = Solids::read(inputs)?;
        let all = Pieces::read(field(whole, "proof", "certificate")?, &solids)?;
        let planes: Vec<Plane> = all.pieces.iter().map(|piece| Plane::of(all.points(piece))).collect();
        let tree = Tree::new(all.pieces.iter().map(|piece| meeting::bounds(&all, piece)));
        meeting::apart(&all, &tree, &planes)?;
        let [pieces, polygons] = [all.pieces.len(), solids.polygons.len()];
        let title = format!(
            "{pieces} triangles that fill the {polygons} polygons of the inputs and meet the insides of others in single points at most"
        );
        Ok(Self { all, tree, planes, title })
    }

    /// How often each input winds around what is in front of a piece, and around what is behind it.
    fn windings(&self, number: usize, inputs: usize) -> Result<[Vec<i64>; 2], Fault> {
        winding::both_sides(&self.all, &self.tree, &self.planes, number, inputs)
    }

    /// The corners of a piece as seen from one side.
    fn seen(&self, side: u32) -> [&Point; 3] {
        let [a, b, c] = self.all.points(&self.all.pieces[side as usize / 2]);
        if side.is_multiple_of(2) { [a, b, c] } else { [a, c, b] }
    }
}

/// Compares claims of the answer, where there are some, with what was found.
fn claimed(proved: &mut Vec<String>, answer: &Value, found: &[(&str, Value)]) -> Result<(), Fault> {
    for (key, found) in found {
        match optional(answer, key) {
            Some(said) if said == found => proved.push(format!("{key} = {found}")),
            Some(said) => {
                return Err(Fault::new(
                    "answer",
                    format!("\"{key}\" is {found}, and the answer says {said}"),
                ));
            }
            None => {}
        }
    }
    Ok(())
}

fn boolean(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let step = "certificate";
    let formula = Formula::read(text(field(whole, "formula", step)?, "\"formula\"", step)?, inputs.len())?;
    let rule = Rule::of(whole)?;
    let answer = field(whole, "answer", step)?;
    let space = Arrangement::read(whole, inputs)?;
    winding::closed(&space.all, rule)?;
    let holds = |windings: &[i64]| formula.holds(|input| rule.holds(windings[input as usize]));
    // What is on one side of the boundary only, turned so that the result is behind it.
    let mut boundary = Vec::new();
    for number in 0..space.all.pieces.len() {
        let [front, back] = space.windings(number, inputs.len())?;
        match (holds(&front), holds(&back)) {
            (false, true) => boundary.push(space.seen(side(number as u32, true))),
            (true, false) => boundary.push(space.seen(side(number as u32, false))),
            _ => {}
        }
    }
    let is_unbounded = holds(&vec![0; inputs.len()]);
    let (shown, count) = (formula.shown(), boundary.len());
    let of_triangles = format!(
        "the result is {shown} of the inputs, numbered from 0, and {count} of these triangles bound it"
    );
    let mut proved = vec![space.title.clone(), of_triangles, rule.claim()];
    // The boundary of a region is closed.
    let found = [
        ("dimension", json!(3)),
        ("closed", json!(true)),
        ("unbounded", json!(is_unbounded)),
        ("rule", json!(rule.name())),
    ];
    claimed(&mut proved, answer, &found)?;
    match (optional(answer, "measure"), is_unbounded) {
        (Some(said), false) => {
            let volume = volume::agrees(&boundary, said)?;
            proved.push(format!("measure = {volume}, the volume, to one part in 10^12"));
        }
        (Some(_), true) => {
            return Err(Fault::new("answer", "the result has no end, and the answer has a volume"));
        }
        (None, _) => {}
    }
    Ok(Verdict::of(proved, answer, &["dimension", "closed", "unbounded", "rule", "measure"]))
}

fn arrangement(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let step = "cells";
    let answer = field(whole, "answer", "certificate")?;
    let rule = Rule::of(whole)?;
    let space = Arrangement::read(whole, inputs)?;
    meeting::edge_to_edge(&space.all)?;
    let cells = Cells::new(&space.all, &space.tree, &space.planes)?;
    // The sides of each cell, by one of them; the triangles of the proof look out of their cells.
    let mut sides: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for own in 0..2 * space.all.pieces.len() as u32 {
        let root = cells.root(own);
        if root != cells.exterior() {
            sides.entry(root).or_default().push(own);
        }
    }
    let named = list(field(field(whole, "proof", step)?, "cells", step)?, "\"cells\"", step)?;
    let mut order = Vec::with_capacity(named.len());
    for triangle in named {
        let corners =
            list(triangle, "a triangle", step)?.iter().map(|corner| index(corner, "a vertex", step));
        let corners = corners.collect::<Result<Vec<u32>, Fault>>()?;
        let inner = <[u32; 3]>::try_from(corners).ok().and_then(|corners| space.all.side_behind(corners));
        order.push(
            cells.root(inner.ok_or_else(|| Fault::new(step, "a cell has no triangle of the arrangement"))?),
        );
    }
    let mut once = order.clone();
    once.sort_unstable();
    if !once.iter().eq(sides.keys()) {
        let message =
            format!("there are {} bounded cells, and these are not all of them, each once", sides.len());
        return Err(Fault::new(step, message));
    }
    let mut proved = vec![
        space.title.clone(),
        format!("{} bounded {}", order.len(), if order.len() == 1 { "cell" } else { "cells" }),
    ];
    let outer = (0..2 * space.all.pieces.len() as u32).filter(|&own| cells.root(own) == cells.exterior());
    let dangling = (0..space.all.pieces.len() as u32)
        .filter(|&piece| cells.root(2 * piece) == cells.root(2 * piece + 1));
    let (outer, dangling) = (outer.count(), dangling.count());
    proved.push(format!(
        "{outer} sides of triangles see the exterior, and {dangling} triangles have one cell on both sides"
    ));
    claimed(&mut proved, answer, &[("dimension", json!(3)), ("voids", json!(cells.voids()))])?;
    let mut known = vec!["dimension", "voids"];
    if let Some(measures) = optional(answer, "measures") {
        let measures = list(measures, "\"measures\"", "answer")?;
        if measures.len() != order.len() {
            return Err(Fault::new(
                "answer",
                format!("{} volumes are there for {} cells", measures.len(), order.len()),
            ));
        }
        for (measure, root) in measures.iter().zip(&order) {
            // Seen from outside of the cell: the other side of each piece.
            let outward: Vec<[&Point; 3]> = sides[root].iter().map(|own| space.seen(own ^ 1)).collect();
            volume::agrees(&outward, measure)?;
        }
        proved.push("measures, the volumes of the cells, to one part in 10^12".to_owned());
        known.push("measures");
    }
    if winding::closed(&space.all, rule).is_ok() {
        let mut inside = Vec::with_capacity(order.len());
        for root in &order {
            let own = sides[root][0];
            let windings = space.windings(own as usize / 2, inputs.len())?;
            let windings = &windings[own as usize % 2];
            inside.push(json!(
                (0..inputs.len()).filter(|&input| rule.holds(windings[input])).collect::<Vec<_>>()
            ));
        }
        proved.push(rule.claim());
        claimed(&mut proved, answer, &[("inside", Value::Array(inside))])?;
        known.push("inside");
    }
    Ok(Verdict::of(proved, answer, &known))
}
