//! A checker of the certificates of closed walks on surfaces. It shares no code with what compared them: complexes are those of [`coface_check`],
//! words of edges those of [`coface_check_loops`], and it decides by itself which words are the unit and which are conjugate.
//!
//! A certificate has a spanning forest, edges that generate the group of each component, and faces that say the words of all other edges. [`check`] finds the
//! relator of each component, and then the words of the walks. `docs/certificates.md` has each rule and why it proves the claim. Certificates of other
//! kinds are handed to [`coface_check_loops`].

mod group;
mod walks;

use coface_check::json::{field, text};
use coface_check::{Fault, Verdict};
use serde_json::Value;

/// Checks a certificate of any kind against the bytes of its inputs, in their order.
///
/// # Errors
/// A [`Fault`] with the first step that fails.
///
/// # Complexity
/// For n cells, and walks with words of m letters in all in groups with r generators, O(n log n + r m), and for each pair of walks O(r) for each letter of the
/// two; where they may be freely homotopic, O(r^2 l^2) for words of l letters. Certificates of other kinds as [`coface_check_loops::check`].
///
/// # Examples
/// The rim of a triangle that is not there cannot be contracted.
/// ```
/// let input = b"[[0,1],[1,2],[0,2]]";
/// let hash = coface_check::sha256(input);
/// let certificate = |contractible: bool| format!(
///     r#"{{"coface_certificate":1,"kind":"walks","inputs":[{{"name":"a.json","sha256":"{hash}"}}],"walks":[[0,1,2,0]],
///         "answer":{{"components":[{{"base":0,"generators":1,"relators":[]}}],"pairs":[],
///             "walks":[{{"steps":3,"component":0,"contractible":{contractible},"bounds":false,"word":[1],"homology":[1]}}]}},
///         "proof":{{"tree":[[0,1],[0,2]],"faces":[],"components":[{{"generators":[[1,2]],"relators":[],"loops":[[1]],"images":[[1]]}}]}}}}"#
/// );
/// let verdict = coface_check_walks::check(certificate(false).as_bytes(), &[input]).expect("it is so");
/// assert!(verdict.proved().contains(&"of 1 walk, numbered from 0, those that can be contracted are []".to_owned()));
/// assert!(coface_check_walks::check(certificate(true).as_bytes(), &[input]).is_err());
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
        "walks" => walks::check(whole, inputs),
        _ => coface_check_loops::check_opened(whole, inputs),
    }
}
