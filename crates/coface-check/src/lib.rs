//! A checker of the certificates that coface writes. It shares no code with what computed the answers: it has its own readers, its own
//! complexes and its own elimination, over the integers of `dashu-int`.
//!
//! A certificate is a JSON object with the answer, the SHA-256 of the input, and a proof. [`check`] reads the input anew, follows the
//! proof step by step, derives the claims itself and compares them with the answer. A claim that it does not derive is listed as
//! unchecked. `docs/certificates.md` has each rule and why it proves the claim.

#[doc(hidden)]
pub mod claims;
mod complex;
mod fault;
mod generators;
mod groups;
mod homology;
mod info;
pub mod json;
mod lists;
mod matching;
mod moves;
mod polygons;
mod sha256;
mod simplices;
mod smith;

pub use complex::Complex;
pub use fault::Fault;
pub use groups::is_prime;
pub use polygons::Surface;
pub use sha256::sha256;

use json::{field, list, text};
use serde_json::Value;

/// The number of the form of certificates that this checker reads.
pub const VERSION: u64 = 1;

/// What a certificate proved.
///
/// # Examples
/// See [`check`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    proved: Vec<String>,
    unchecked: Vec<String>,
}

/// The key whose empty list claims nothing: an answer that assumes nothing. Of others an empty list says that there are none.
const REMARKS: &str = "remarks";

impl Verdict {
    /// What was proved; the keys of an answer beyond the known ones that hold something, or say that there is none, are unchecked.
    ///
    /// # Examples
    /// ```
    /// let answer = serde_json::json!({"genus": 1, "area": 2.5, "problems": [], "remarks": []});
    /// let verdict = coface_check::Verdict::of(vec!["genus = 1".to_owned()], &answer, &["genus"]);
    /// assert_eq!(verdict.unchecked(), ["area", "problems"]);
    /// ```
    pub fn of(proved: Vec<String>, answer: &Value, known: &[&str]) -> Self {
        let says = |key: &str, value: &Value| match value {
            Value::Null => false,
            Value::Array(list) => !list.is_empty() || key != REMARKS,
            _ => true,
        };
        let others = answer.as_object().into_iter().flatten();
        let others = others.filter(|(key, value)| !known.contains(&key.as_str()) && says(key, value));
        Self { proved, unchecked: others.map(|(key, _)| key.clone()).collect() }
    }

    /// The same, with one more thing that is not checked.
    ///
    /// # Examples
    /// ```
    /// let verdict = coface_check::Verdict::of(Vec::new(), &serde_json::json!({}), &[]).leaving("where this comes from");
    /// assert_eq!(verdict.unchecked(), ["where this comes from"]);
    /// ```
    pub fn leaving(mut self, what: &str) -> Self {
        self.unchecked.push(what.to_owned());
        self
    }

    /// The claims that were derived from the input and agree with the answer, one a line.
    ///
    /// # Examples
    /// See [`check`].
    pub fn proved(&self) -> &[String] {
        &self.proved
    }

    /// The keys of the answer about which the checker says nothing.
    ///
    /// # Examples
    /// See [`check`].
    pub fn unchecked(&self) -> &[String] {
        &self.unchecked
    }
}

/// Checks a certificate against the bytes of its inputs, in the order in which [`input_names`] gives them.
///
/// # Errors
/// A [`Fault`] with the first step that fails.
///
/// # Complexity
/// Memory is linear in the sizes of the files. Time is that of eliminating the pairs for each critical cell, and of the sparse
/// products of the transforms.
///
/// # Examples
/// ```
/// // A single point: one vertex, no pairs, and H_0 = Z.
/// let input = br#"[[0]]"#;
/// let hash = coface_check::sha256(input);
/// let certificate = format!(
///     r#"{{"coface_certificate":1,"kind":"homology","inputs":[{{"name":"point.json","sha256":"{hash}"}}],"reduced":false,
///         "answer":{{"file":"point.json","coefficients":"Z","cohomology":false,
///                   "homology":[{{"degree":0,"betti":1,"torsion":[]}}],"remarks":[]}},
///         "proof":{{"cells":[1],"pairs":[],"smith":[]}}}}"#
/// );
/// let verdict = coface_check::check(certificate.as_bytes(), &[input]).expect("a point is connected");
/// assert_eq!(verdict.proved(), ["H_0 = Z"]);
/// assert!(coface_check::check(certificate.as_bytes(), &[b"[[1]]"]).is_err());
/// ```
pub fn check(certificate: &[u8], inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    check_opened(&opened(certificate, inputs)?, inputs)
}

/// The same for a certificate that [`opened`] gave for these inputs.
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
    let step = "certificate";
    match text(field(whole, "kind", step)?, "\"kind\"", step)? {
        "homology" => homology::check(whole, inputs),
        "info" => info::check(whole, inputs),
        other => {
            Err(Fault::new(step, format!("{other:?} is no kind of certificate that this checker knows")))
        }
    }
}

/// A certificate as JSON, which is of these inputs by their hashes.
///
/// # Errors
/// A [`Fault`] for another form, or another input.
///
/// # Examples
/// ```
/// let certificate = format!(
///     r#"{{"coface_certificate":1,"inputs":[{{"name":"a.json","sha256":"{}"}}]}}"#,
///     coface_check::sha256(b"[[0]]")
/// );
/// assert!(coface_check::opened(certificate.as_bytes(), &[b"[[0]]"]).is_ok());
/// assert!(coface_check::opened(certificate.as_bytes(), &[b"[[1]]"]).is_err());
/// ```
pub fn opened(certificate: &[u8], inputs: &[&[u8]]) -> Result<Value, Fault> {
    opened_value(json::parsed(certificate, "certificate")?, inputs)
}

/// The same for a certificate that is a value already.
///
/// # Errors
/// A [`Fault`] for another form, or another input.
///
/// # Examples
/// See [`opened`].
pub fn opened_value(whole: Value, inputs: &[&[u8]]) -> Result<Value, Fault> {
    let step = "certificate";
    check_version(&whole)?;
    let hashes = list(field(&whole, "inputs", step)?, "\"inputs\"", step)?;
    if hashes.len() != inputs.len() || inputs.is_empty() {
        let message =
            format!("the certificate is of {} inputs, and {} are given", hashes.len(), inputs.len());
        return Err(Fault::new("input", message));
    }
    for (input, of) in inputs.iter().zip(hashes) {
        let hash = text(field(of, "sha256", step)?, "\"sha256\"", step)?;
        let found = sha256(input);
        if hash != found {
            return Err(Fault::new(
                "input",
                format!("the certificate is of an input with SHA-256 {hash}, and this input has {found}"),
            ));
        }
    }
    Ok(whole)
}

/// Whether the certificate has the form that is known.
fn check_version(whole: &Value) -> Result<(), Fault> {
    let version = field(whole, "coface_certificate", "certificate")?;
    match version.as_u64() == Some(VERSION) {
        true => Ok(()),
        false => {
            let message = format!("form {version} is not known; this checker reads form {VERSION}");
            Err(Fault::new("certificate", message))
        }
    }
}

/// The names of the inputs of a certificate; none where they are not there.
///
/// # Errors
/// A [`Fault`] for what is no certificate.
///
/// # Examples
/// ```
/// let certificate = br#"{"coface_certificate":1,"inputs":[{"name":"a.off","sha256":""}]}"#;
/// assert_eq!(coface_check::input_names(certificate).expect("a certificate"), ["a.off"]);
/// assert!(coface_check::input_names(b"[]").is_err());
/// ```
pub fn input_names(certificate: &[u8]) -> Result<Vec<String>, Fault> {
    let whole = json::parsed(certificate, "certificate")?;
    check_version(&whole)?;
    let inputs = whole.get("inputs").and_then(Value::as_array).into_iter().flatten();
    Ok(inputs.filter_map(|input| Some(input.get("name")?.as_str()?.to_owned())).collect())
}
