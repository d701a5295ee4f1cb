//! Certificates of vineyards.

use super::certificate::{Proof, proof_of_star};
use super::{VertexFunction, VineyardRequest};
use crate::Producer;
use crate::answer::VineyardAnswer;
use crate::homology::certificate::{Input, checked, refused};
use coface_algebra::Error;
use coface_topology::Filtration;
use serde::Serialize;

#[derive(Serialize)]
struct Certificate<'a> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    min_persistence: f64,
    answer: &'a VineyardAnswer,
    /// One for each function.
    proof: Vec<Proof>,
}

impl VineyardRequest {
    /// A certificate of the vines of these functions, which [`Self::answer`] has given, from the name and the bytes of the file that the model was read from. It proves
    /// that at each function the points of the vines are the diagram; which points of two functions are on one vine, and what is between functions, is left open. It has been
    /// checked.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does: it reads facet lists, chain complexes,
    /// and plain OFF and OBJ.
    ///
    /// # Complexity
    /// That of the cycles of all pairs of each function.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Producer, VertexFunction, VineyardRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let input = &b"[[0,1],[1,2]]"[..];
    /// let path = Producer::of(coface_io::read(input, coface_io::Format::Json)?)?;
    /// let values = |values: &[f64]| VertexFunction::Values { place: "f".to_owned(), values: values.to_vec() };
    /// let functions = [values(&[0.0, 4.0, 2.0]), values(&[0.0, 4.0, 6.0])];
    /// let request = VineyardRequest::new();
    /// let answer = request.answer("path.json", &path, &functions)?;
    /// let certificate = request.certificate(&answer, &path, &functions, &[("path.json", input)])?;
    /// let verdict = coface_check_plane::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert_eq!(verdict.proved()[1], "function 0: 2 points of vines are in its diagram over F_2, with all that live longer than 0");
    /// # Ok(()) }
    /// ```
    pub fn certificate(
        &self,
        answer: &VineyardAnswer,
        producer: &Producer,
        functions: &[VertexFunction],
        inputs: &[(&str, &[u8])],
    ) -> Result<String, Error> {
        let [(_, bytes)] = inputs else {
            return Err(Error::invalid("a certificate of a vineyard is of one input"));
        };
        let read = coface_check::Complex::read(bytes).map_err(|fault| refused(&fault.to_string()))?;
        let complex = producer.chain_complex()?;
        let proof = |function: &VertexFunction| {
            let values = function.values(producer, complex.cell_count(0))?;
            let filtration = Filtration::lower_star(&complex, &values)?;
            proof_of_star(producer, &read, &filtration, answer.field)
        };
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "vineyard",
            inputs: Input::list(inputs),
            min_persistence: self.min_persistence,
            answer,
            proof: functions.iter().map(proof).collect::<Result<_, Error>>()?,
        };
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }
}
