//! Certificates of reports.

use crate::answer::InfoAnswer;
use crate::homology::certificate::{Input, Proof, checked, refused};
use coface_algebra::Error;
use serde::Serialize;

/// A certificate of a report, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<'a> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    answer: &'a InfoAnswer,
    proof: Proof,
}

impl InfoAnswer {
    /// A certificate of the report on a file, from the name and the bytes of the file: the counts, components, Euler characteristic, and up to
    /// dimension 3 whether the model is a manifold; whether it is orientable, its boundary loops and genus; and its homology.
    /// [`coface_check::check`] derives them without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does: it reads facet lists, and
    /// plain OFF and OBJ.
    ///
    /// # Complexity
    /// That of homology, and of a Smith form with transforms of what a matching leaves.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Report;
    /// let input = &b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..];
    /// let sphere = Report::of(coface_io::read(input, coface_io::Format::Json)?)?;
    /// let certificate = sphere.answer(10).of_file("sphere.json", "json").certificate(&[("sphere.json", input)])?;
    /// let verdict = coface_check::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert!(verdict.proved().contains(&"manifold = [\"yes\",true]".to_owned()));
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        let [(_, bytes)] = inputs else {
            return Err(Error::invalid("a certificate of a report is of one input"));
        };
        let complex = coface_check::Complex::read(bytes).map_err(|fault| refused(&fault.to_string()))?;
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "info",
            inputs: Input::list(inputs),
            answer: self,
            proof: Proof::of(&complex)?,
        };
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }
}
