//! A checker of the certificates of Booleans of solids. It shares no code with what computed them: it reads surfaces by itself, and decides everything
//! in fractions of integers of any length, by doubles where these suffice.
//!
//! A certificate has exact vertices, and for each polygon of the inputs triangles that fill it. [`check`] tests that they do, and that no triangle
//! meets the inside of another. Then all points in front of a triangle are alike, and a ray from one of them says in which inputs they are. So it
//! finds the boundary of the result, and its volume. `docs/certificates.md` has each rule and why it proves the claim. Certificates of other
//! kinds are handed to [`coface_check_plane`].

mod meeting;
mod pieces;
mod point;
mod solids;
mod tree;
mod volume;
mod winding;

use coface_check::json::{field, optional, text};
use coface_check::{Fault, Verdict};
use coface_check_plane::{Formula, Rule};
use pieces::Pieces;
use point::Plane;
use serde_json::{Value, json};
use solids::Solids;

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
/// assert_eq!(verdict.proved()[0], "4 triangles that fill the 4 polygons of the inputs and meet in common sides and corners alone");
/// assert!(coface_check_space::check(certificate(1.1).as_bytes(), &[input]).is_err());
/// ```
pub fn check(certificate: &[u8], inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let whole = coface_check::opened(certificate, inputs)?;
    match text(field(&whole, "kind", "certificate")?, "\"kind\"", "certificate")? {
        "solids" => solid(&whole, inputs),
        _ => coface_check_plane::check(certificate, inputs),
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

fn solid(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    let step = "certificate";
    let formula = Formula::read(text(field(whole, "formula", step)?, "\"formula\"", step)?, inputs.len())?;
    let rule = Rule::of(whole)?;
    let (answer, proof) = (field(whole, "answer", step)?, field(whole, "proof", step)?);
    let solids = Solids::read(inputs)?;
    let all = Pieces::read(proof, &solids)?;
    winding::closed(&all)?;
    let planes: Vec<Plane> = all.pieces.iter().map(|piece| Plane::of(all.points(piece))).collect();
    let tree = winding::tree_of(&all);
    meeting::apart(&all, &tree, &planes)?;
    let holds = |windings: &[i64]| formula.holds(|input| rule.holds(windings[input as usize]));
    // What is on one side of the boundary only, turned so that the result is behind it.
    let mut boundary = Vec::new();
    for (number, piece) in all.pieces.iter().enumerate() {
        let [front, back] = winding::both_sides(&all, &tree, &planes, number, inputs.len())?;
        let [a, b, c] = all.points(piece);
        match (holds(&front), holds(&back)) {
            (false, true) => boundary.push([a, b, c]),
            (true, false) => boundary.push([a, c, b]),
            _ => {}
        }
    }
    let is_unbounded = holds(&vec![0; inputs.len()]);
    let [pieces, polygons] = [all.pieces.len(), solids.polygons.len()];
    let mut proved = vec![
        format!(
            "{pieces} triangles that fill the {polygons} polygons of the inputs and meet in common sides and corners alone"
        ),
        format!(
            "the result is {} of the inputs, numbered from 0, and {} of these triangles bound it",
            formula.shown(),
            boundary.len()
        ),
    ];
    // The boundary of a region is closed.
    let claims = [
        ("dimension", json!(3)),
        ("closed", json!(true)),
        ("unbounded", json!(is_unbounded)),
        ("rule", json!(rule.name())),
    ];
    for (key, found) in claims {
        match optional(answer, key) {
            Some(said) if *said == found => proved.push(format!("{key} = {found}")),
            Some(said) => {
                return Err(Fault::new(
                    "answer",
                    format!("\"{key}\" is {found}, and the answer says {said}"),
                ));
            }
            None => {}
        }
    }
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
