//! Certificates of bases of the first cohomology.

use super::FoundCocycles;
use crate::answer::CocyclesAnswer;
use crate::homology::certificate::{Input, checked, of_groups, refused};
use coface_algebra::Error;
use serde::Serialize;

/// A certificate of cocycles, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<G> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    answer: CocyclesAnswer,
    /// A certificate of the homology groups, which proves the rank.
    homology: G,
}

impl FoundCocycles<'_> {
    /// A certificate of the basis, from the name and the bytes of the file that the model was read from: cocycles and loops are closed, their values
    /// on each other are the pairing, and they are a basis. [`coface_check_walks::check`] derives that without any code of this library, as
    /// `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does: it reads facet lists, and plain
    /// OFF and OBJ. [`coface_algebra::ErrorKind::InvalidInput`] for cocycles of a domain, or relative to a part.
    ///
    /// # Complexity
    /// That of homology, and of a Smith form with transforms of what a matching leaves.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CocyclesRequest, Producer};
    /// let input = &b"[[0,1],[1,2],[0,2]]"[..];
    /// let rim = Producer::of(coface_io::read(input, coface_io::Format::Json)?)?;
    /// let certificate = CocyclesRequest::new().found(&rim)?.certificate(&[("rim.json", input)])?;
    /// let verdict = coface_check_walks::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert_eq!(verdict.proved()[0], "the first cohomology over Z has rank 1");
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        let [(name, _)] = inputs else {
            return Err(Error::invalid("a certificate of cocycles is of one input"));
        };
        if self.pair.is_some() {
            return Err(Error::invalid("cocycles of a domain, or relative to a part, have no certificate")
                .with_cure("ask for those of the whole model"));
        }
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "cocycles",
            inputs: Input::list(inputs),
            answer: self.answer(name),
            homology: of_groups(inputs)?,
        };
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }
}
