//! Certificates of persistence diagrams.

use super::FoundDiagram;
use crate::answer::PersistenceAnswer;
use crate::homology::certificate::{Input, Number, chain_complex, checked, number, refused};
use coface_algebra::chains::Chain;
use coface_algebra::{CellId, Error, Integer};
use coface_topology::{Coefficients, Filtration, persistence, persistent_cycles};
use serde::Serialize;
use std::collections::HashMap;

/// A certificate of a diagram, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<'a> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    min_persistence: f64,
    answer: &'a PersistenceAnswer,
    proof: Proof,
}

#[derive(Serialize)]
struct Proof {
    /// The values of the vertices, or without a star of all cells, by degree.
    values: Vec<Vec<f64>>,
    /// For each degree from 1 on the chains that end classes, and the cycles of those that stay, with cells in the order in which they enter.
    chains: Vec<Vec<Vec<(Number, u32)>>>,
}

impl FoundDiagram<'_> {
    /// A certificate of the diagram, from the name and the bytes of the file that the model was read from: an answer without cycles, and chains that
    /// prove it, which [`coface_check_persistence::check`] follows without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does: it reads facet lists, chain complexes,
    /// and plain OFF and OBJ.
    ///
    /// # Complexity
    /// That of the cycles of all pairs, also of those of persistence 0.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, Producer};
    /// let input = &b"[[0,2],[2,1]]"[..];
    /// let path = Producer::of(coface_io::read(input, coface_io::Format::Json)?)?;
    /// let certificate = PersistenceRequest::new().found("path.json", &path)?.certificate(&[("path.json", input)])?;
    /// let verdict = coface_check_persistence::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert_eq!(verdict.proved()[0], "the values of the vertices are vertex number");
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        let [(_, bytes)] = inputs else {
            return Err(Error::invalid("a certificate of persistence is of one input"));
        };
        let read = coface_check::Complex::read(bytes).map_err(|fault| refused(&fault.to_string()))?;
        let mut answer = self.answer();
        for pair in &mut answer.diagram {
            (pair.cycle, pair.bounding_chain, pair.cocycle) = (None, None, None);
        }
        answer.torsion_primes = None;
        let values = self.values_on(&read)?;
        let complex = chain_complex(&read)?;
        let filtration = match self.star {
            Some("upper") => Filtration::upper_star(&complex, &values[0])?,
            Some(_) => Filtration::lower_star(&complex, &values[0])?,
            None => Filtration::new(&complex, values.clone())?,
        };
        let whole = persistence(&complex, &filtration, Coefficients::Modulo(self.diagram.prime().into()))?;
        let mut chains: Vec<Vec<_>> = read.counts().iter().skip(1).map(|_| Vec::new()).collect();
        let in_order = |chain: &Chain<Integer>| {
            let values = filtration.values(chain.degree());
            let sign = if filtration.is_falling() { -1.0 } else { 1.0 };
            let key = |cell: CellId| sign * values[cell.index()];
            let mut terms = chain.terms().to_vec();
            terms.sort_by(|(a, _), (b, _)| key(*a).total_cmp(&key(*b)).then(a.cmp(b)));
            terms.iter().map(|(cell, entry)| (number(entry), cell.to_u32())).collect::<Vec<_>>()
        };
        for one in persistent_cycles(&complex, &filtration, &whole, f64::NEG_INFINITY)? {
            let chain = one.bounding_chain().unwrap_or_else(|| one.cycle());
            // A vertex whose class stays has no faces.
            if chain.degree() > 0 {
                chains[chain.degree() - 1].push(in_order(chain));
            }
        }
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "persistence",
            inputs: Input::list(inputs),
            min_persistence: self.min_persistence,
            answer: &answer,
            proof: Proof { values, chains },
        };
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }

    /// The values of the vertices, or without a star of all cells, in the order of the checker.
    fn values_on(&self, read: &coface_check::Complex) -> Result<Vec<Vec<f64>>, Error> {
        let degrees = if self.star.is_some() { 1 } else { read.counts().len() };
        let of_degree = |degree: usize| {
            let name = |mut vertices: Vec<u32>| {
                vertices.sort_unstable();
                vertices
            };
            let own = self.filtration.values(degree).iter().enumerate();
            let own: HashMap<Vec<u32>, f64> = own
                .map(|(cell, &value)| (name(self.producer.cell_vertices(degree, CellId::new(cell))), value))
                .collect();
            let value = |cell: usize| match read.vertices(degree, cell) {
                Some(vertices) => own.get(&name(vertices.to_vec())).copied(),
                None => self.filtration.values(degree).get(cell).copied(),
            };
            (0..read.counts()[degree]).map(value).collect::<Option<Vec<f64>>>()
        };
        let values = (0..degrees).map(of_degree).collect::<Option<_>>();
        values.ok_or_else(|| refused("the checker reads other cells than the library"))
    }
}
