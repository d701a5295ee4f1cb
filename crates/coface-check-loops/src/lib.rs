//! A checker of the certificates of surfaces that were cut open or covered, of bases of the first cohomology, and of fundamental groups. It shares no code with what computed them:
//! complexes are those of [`coface_check`], and it glues and adds by itself.
//!
//! A certificate of a cut has the edges that were cut. [`check`] glues the faces along all others, and finds what the pieces are by their Euler
//! characteristics, and the ways around them. One of cocycles has a certificate of homology inside, which proves how many there have to be.
//! `docs/certificates.md` has each rule and why it proves the claim. Certificates of other kinds are handed to [`coface_check_space`].

mod abelian;
mod cocycles;
mod cosets;
mod cover;
mod cut;
mod pi1;
mod surface;
mod tietze;
#[doc(hidden)]
pub mod words;

#[doc(hidden)]
pub use {cut::vertices, pi1::EdgePaths, pi1::Words, surface::Classes};

use coface_check::json::{field, text};
use coface_check::{Fault, Verdict};
use serde_json::Value;

/// Checks a certificate of any kind against the bytes of its inputs, in their order.
///
/// # Errors
/// A [`Fault`] with the first step that fails.
///
/// # Complexity
/// O(n log n) for n cells and as many terms of cochains; certificates of other kinds as [`coface_check::check`].
///
/// # Examples
/// Two triangles that are cut apart are no disk.
/// ```
/// let input = b"[[0,1,2],[0,2,3]]";
/// let hash = coface_check::sha256(input);
/// let certificate = |edges: &str| format!(
///     r#"{{"coface_certificate":1,"kind":"cut","inputs":[{{"name":"a.json","sha256":"{hash}"}}],
///         "answer":{{"f_vector":[4,5,2],"components":[{{"surface":"disk","cut_edges":0,"boundary_edges":4,"euler_characteristic":1,
///             "f_vector":[4,5,2],"base":0,"generators":0,"relator":null,"seams":[],"word":[]}}]}},
///         "proof":{{"edges":[{edges}]}}}}"#
/// );
/// let verdict = coface_check_loops::check(certificate("").as_bytes(), &[input]).expect("it is a disk");
/// assert!(verdict.proved()[0].contains("disk of 4 vertices, 5 edges and 2 faces"));
/// assert!(coface_check_loops::check(certificate("[0,2]").as_bytes(), &[input]).is_err());
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
        "cut" => cut::check(whole, inputs),
        "cover" => cover::universal(whole, inputs),
        "orientation cover" => cover::orientation(whole, inputs),
        "pi1" => pi1::check(whole, inputs),
        "cocycles" => cocycles::check(whole, inputs),
        _ => coface_check_space::check_opened(whole, inputs),
    }
}
