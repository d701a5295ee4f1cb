//! A checker of the certificates of arrangements and Booleans in the plane. It shares no code with what computed them: it reads drawings by
//! itself, and decides everything in fractions of integers of any length.
//!
//! A certificate has the exact vertices, and for each segment of the inputs the vertices along it. [`check`] tests that these are an
//! arrangement: each segment is covered, and a sweep finds no two edges that cross. Faces, winding numbers and areas it finds by
//! itself, and compares them with the answer. Certificates of other kinds it hands to [`coface_check_persistence`], which hands those
//! of homology and reports to [`coface_check`]. `docs/certificates.md` has each
//! rule and why it proves the claim.

mod area;
mod boolean;
mod claims;
mod drawing;
mod faces;
mod formula;
mod geojson;
mod inside;
mod point;
mod subdivision;
mod wkt;

pub use coface_check::{Fault, Verdict, sha256};
pub use drawing::Drawing;
pub use formula::{Formula, Rule};
pub use point::parts;

use coface_check::json::{field, text};
use serde_json::Value;

/// Checks a certificate of any kind against the bytes of its inputs, in their order.
///
/// # Errors
/// A [`Fault`] with the first step that fails.
///
/// # Complexity
/// For n edges $O(n \log n)$ decisions in integers, and the lengths of the winding numbers; certificates of other kinds as
/// [`coface_check::check`].
///
/// # Examples
/// The area of a triangle.
/// ```
/// let input = b"POLYGON ((0 0, 2 0, 0 2, 0 0))";
/// let hash = coface_check::sha256(input);
/// let certificate = |area: f64| format!(
///     r#"{{"coface_certificate":1,"kind":"arrangement","inputs":[{{"name":"a.wkt","sha256":"{hash}"}}],"rule":null,
///         "answer":{{"f_vector":[3,3,1],"measures":[{area:?}],"inside":[[0]]}},
///         "proof":{{"vertices":[[0,0,1],[0,2,1],[2,0,1]],"chains":[[0,2],[2,1],[1,0]],"faces":[[0,2]]}}}}"#
/// );
/// let verdict = coface_check_plane::check(certificate(2.0).as_bytes(), &[input]).expect("half of 2 times 2");
/// assert_eq!(verdict.proved()[0], "an arrangement of 3 segments in 3 vertices, 3 edges and 1 bounded face");
/// assert!(coface_check_plane::check(certificate(2.1).as_bytes(), &[input]).is_err());
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
        "arrangement" => claims::check(whole, inputs),
        "boolean" => boolean::check(whole, inputs),
        _ => coface_check_persistence::check_opened(whole, inputs),
    }
}
