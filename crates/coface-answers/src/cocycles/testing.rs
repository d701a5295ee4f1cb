//! Whether a cochain is closed and exact.

use crate::answer::{CochainTestAnswer, CochainValue, WholeNumber};
use crate::{CellNames, Producer};
use coface_algebra::chains::{Cochain, TwoSkeleton};
use coface_algebra::{CellId, Error, Integer, Sign};
use coface_topology::{ClosedWalk, Exactness, exactness, exactness_within};

/// A cochain of degree 1 as the user writes it: values on edges by their vertices.
#[derive(Clone, Debug, PartialEq)]
pub enum GivenCochain {
    /// Integers, whose sums are decided exactly.
    Whole(Vec<(Integer, Vec<u32>)>),
    /// Real numbers; sums up to the absolute tolerance count as zero.
    Real {
        /// The values.
        terms: Vec<(f64, Vec<u32>)>,
        /// The largest absolute value of a sum that counts as zero.
        tolerance: f64,
    },
}

/// Whether a cochain on the edges of a model is closed and exact, with what shows it. The degree is that which the user
/// gives beside the cochain, 1 if there is none.
///
/// # Errors
/// Those of [`Producer::two_skeleton`] and [`Producer::oriented_cells`]; an invalid argument if the cochain is not of
/// degree 1, or the tolerance is negative.
///
/// # Examples
/// ```
/// use coface_answers::{GivenCochain, Producer, tested_cochain};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
/// let around = GivenCochain::Whole(vec![(1.into(), vec![0, 1])]);
/// let answer = tested_cochain(&rim, &around, None, "rim.json")?;
/// assert!(answer.closed && !answer.exact);
/// # Ok(()) }
/// ```
pub fn tested_cochain(
    producer: &Producer,
    given: &GivenCochain,
    degree: Option<usize>,
    file: &str,
) -> Result<CochainTestAnswer, Error> {
    let skeleton = producer.two_skeleton().map_err(|error| error.in_file(file))?;
    let test = Test { names: CellNames::of(producer), skeleton: &skeleton, file };
    match given {
        GivenCochain::Whole(terms) => {
            let cochain = test.cochain(terms, degree, |value| -value)?;
            let found = exactness(&skeleton, &cochain)?;
            test.answer(found, |value| CochainValue::Whole(WholeNumber::from(value)))
        }
        GivenCochain::Real { terms, tolerance } => {
            let cochain = test.cochain(terms, degree, |value| -value)?;
            let found = exactness_within(&skeleton, &cochain, *tolerance)?;
            test.answer(found, |&value| CochainValue::Real(value))
        }
    }
}

struct Test<'a> {
    names: CellNames<'a>,
    skeleton: &'a TwoSkeleton,
    file: &'a str,
}

impl Test<'_> {
    fn cochain<T: coface_algebra::chains::Coefficient>(
        &self,
        terms: &[(T, Vec<u32>)],
        degree: Option<usize>,
        negative: impl Fn(&T) -> T,
    ) -> Result<Cochain<T>, Error> {
        let producer = self.names.producer();
        let complex = producer.chain_complex()?;
        let lists = terms.iter().map(|(_, vertices)| &vertices[..]);
        let (degree, cells) = producer.oriented_cells(&complex, lists, degree.or(Some(1)))?;
        if degree != 1 {
            return Err(Error::invalid(format!(
                "a cochain of degree {degree}; one of degree 1 is asked for"
            )));
        }
        let signed = cells.into_iter().zip(terms).map(|((cell, sign), (value, _))| match sign {
            Sign::Plus => (cell, value.clone()),
            Sign::Minus => (cell, negative(value)),
        });
        Cochain::new(&complex, 1, signed)
    }

    fn answer<T: coface_algebra::chains::Coefficient>(
        &self,
        found: Exactness<T>,
        value: impl Fn(&T) -> CochainValue,
    ) -> Result<CochainTestAnswer, Error> {
        let mut answer = CochainTestAnswer {
            file: self.file.to_owned(),
            closed: true,
            exact: false,
            potential: None,
            walk: None,
            period: None,
            face: None,
            sum: None,
            remarks: Vec::new(),
        };
        match found {
            Exactness::Exact { potential } => {
                let vertices =
                    |cell: CellId| self.names.vertices(0, cell).into_iter().map(u64::from).collect();
                let terms = potential.terms().iter().map(|(cell, x)| (value(x), vertices(*cell)));
                answer.exact = true;
                answer.potential = Some(terms.collect());
            }
            Exactness::Closed { walk, period } => {
                answer.walk = Some(self.vertices(&walk));
                answer.period = Some(value(&period));
            }
            Exactness::NotClosed { face, sum } => {
                answer.closed = false;
                answer.face = Some(self.names.vertices(2, CellId::new(face.index())));
                answer.sum = Some(value(&sum));
            }
            _ => return Err(Error::invalid("the test of the cochain gave no verdict")),
        }
        Ok(answer)
    }

    fn vertices(&self, walk: &ClosedWalk) -> Vec<u32> {
        let vertices = walk.vertices(self.skeleton).into_iter();
        vertices.map(|vertex| self.names.vertex(vertex)).collect()
    }
}
