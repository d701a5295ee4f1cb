//! Certificates of the persistence of points.

use super::FoundRips;
use crate::answer::PersistenceAnswer;
use crate::homology::certificate::{Input, checked};
use crate::text;
use coface_algebra::{Error, ErrorKind};
use coface_topology::{Coefficients, RipsCochain};
use serde::Serialize;

/// A certificate of points, as `docs/certificates.md` describes it.
#[derive(Serialize)]
struct Certificate<'a> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    layout: &'static str,
    min_persistence: f64,
    answer: &'a PersistenceAnswer,
    proof: &'a Proof,
}

/// Coefficients with simplices by their points.
type Terms = Vec<(u32, Vec<u32>)>;

#[derive(Serialize)]
struct Proof {
    /// For each degree from 1 on the cochains of several terms: coefficients with simplices by their points.
    cochains: Vec<Vec<Terms>>,
}

/// How a file may hold points or distances.
const LAYOUTS: [&str; 4] = ["points", "vertices", "square", "lower"];
/// A checker tries so many points as further points of simplices; beyond, it would take hours.
const MOST_WORK: f64 = 1e11;

impl FoundRips {
    /// A certificate of the diagram, from the name and the bytes of the file that the points were read from: the cochains whose coboundaries prove the pairs.
    /// [`coface_check_walks::check`] follows that without any code of this library, as `docs/certificates.md` says. It has been checked.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] if the checker does not read the file as this library does: it reads rows of numbers as text, points or distances, and the
    /// vertices of plain OFF and OBJ. [`ErrorKind::TooLarge`] where it would look at too many simplices, with a threshold for which it would not.
    /// [`ErrorKind::InvalidInput`] for a graph: [`Self::with_simplices`] has the simplices that its certificate lists.
    ///
    /// # Complexity
    /// That of [`crate::RipsRequest::found`], and of the check: each simplex up to the highest degree is looked at once with all points near it.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::RipsRequest;
    /// use coface_io::{NumberTable, TableForm};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let input = &b"0 0\n1 0\n1 1\n0 1\n"[..];
    /// let distances = TableForm::Points.distances(&NumberTable::read(input)?)?;
    /// let certificate = RipsRequest::new().found("square.csv", &distances)?.certificate(&[("square.csv", input)])?;
    /// let verdict = coface_check_walks::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert_eq!(verdict.proved()[0], "the rows of the file are 4 points with 2 coordinates, at Euclidean distances");
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        if self.labels.is_some() || inputs.len() != 1 {
            return Err(Error::invalid("such a certificate is of the points of one input")
                .with_cure("ask for that of its simplices"));
        }
        self.require_all_edges("proofs")?;
        let dimension = self.diagram.degree_count() - 1;
        self.require_work(dimension)?;
        let coefficients = Coefficients::Modulo(self.diagram.prime().into());
        let (_, cochains) = self.filtration.persistence_with_cochains(dimension, coefficients)?;
        let terms = |cochain: &RipsCochain| {
            let terms = cochain.terms().iter();
            terms.map(|(coefficient, simplex)| (*coefficient, self.numbers(simplex))).collect()
        };
        let cochains = cochains.iter().map(|own| own.iter().map(terms).collect()).collect();
        let (answer, proof) = (self.answer(), Proof { cochains });
        let mut refused = None;
        for layout in LAYOUTS {
            let certificate = Certificate {
                coface_certificate: coface_check::VERSION,
                coface: env!("CARGO_PKG_VERSION"),
                kind: "rips",
                inputs: Input::list(inputs),
                layout,
                min_persistence: self.min_persistence,
                answer: &answer,
                proof: &proof,
            };
            match checked(&certificate, inputs) {
                Ok(text) => return Ok(text),
                // What the file is not read as says little; where it is read, the fault is another one.
                Err(fault) if fault.step() == "input" && refused.is_some() => {}
                Err(fault) => refused = Some(fault.to_string()),
            }
        }
        Err(Error::new(
            ErrorKind::UnsupportedFormat,
            format!(
                "no certificate: {}; leave --certificate out, or give points or distances as rows of numbers, or the vertices of plain OFF or OBJ",
                refused.unwrap_or_default()
            ),
        ))
    }

    /// Refuses what would take the checker too long.
    fn require_work(&self, dimension: usize) -> Result<(), Error> {
        let work = |threshold: f64| -> Result<(f64, f64), Error> {
            let size = self.filtration.size(dimension, threshold)?;
            let (points, simplices) = (size.simplices()[0], size.simplices()[1..].iter().sum::<f64>());
            Ok((simplices, simplices * points))
        };
        let (simplices, whole) = work(f64::INFINITY)?;
        if whole <= MOST_WORK {
            return Ok(());
        }
        let (mut low, mut high) = (0.0, self.diagram.threshold());
        for _ in 0..40 {
            let middle = f64::midpoint(low, high);
            if work(middle)?.1 <= MOST_WORK { low = middle } else { high = middle }
        }
        let message = format!(
            "a checker would look at about {} simplices of degrees 1 to {dimension}, each with all points near it",
            text::grouped(simplices.round() as usize)
        );
        Err(Error::new(ErrorKind::TooLarge, message).with_cure(format!(
            "ask for a threshold of {low} or less (--threshold {low}), a lower dimension, or no certificate"
        )))
    }
}
