//! Certificates of persistence diagrams.

use super::FoundDiagram;
use crate::answer::PersistenceAnswer;
use crate::homology::certificate::{Input, Number, checked, number, refused};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, SparseMatrix};
use coface_topology::{Coefficients, persistence, persistent_cycles};
use serde::Serialize;

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
    /// For each degree the cells in the order in which they enter.
    order: Vec<Vec<u32>>,
    /// For each degree from 1 on the chains that end classes, and the cycles of those that stay, with cells in the order in which they enter.
    chains: Vec<Vec<Vec<(Number, u32)>>>,
}

impl FoundDiagram<'_> {
    /// A certificate of the diagram, from the name and the bytes of the file that the model was read from: an answer without cycles, and chains that
    /// prove it, which [`coface_check_plane::check`] follows without any code of this library, as `docs/certificates.md` says. It has been checked.
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
    /// let verdict = coface_check_plane::check(certificate.as_bytes(), &[input]).expect("the proof holds");
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
        let cell_counts: Vec<usize> =
            (0..read.counts().len()).map(|degree| self.filtration.values(degree).len()).collect();
        let places = self.producer.places_on(&read, &cell_counts)?;
        let complex = renumbered(&read, &places)?;
        let whole =
            persistence(&complex, &self.filtration, Coefficients::Modulo(self.diagram.prime().into()))?;
        let order: Vec<Vec<u32>> = (0..places.len()).map(|degree| self.entering(degree)).collect();
        let mut ranks: Vec<Vec<u32>> = places.iter().map(|own| vec![0; own.len()]).collect();
        for (ranks, order) in ranks.iter_mut().zip(&order) {
            order.iter().zip(0..).for_each(|(&cell, rank)| ranks[cell as usize] = rank);
        }
        let mut chains: Vec<Vec<_>> = places.iter().skip(1).map(|_| Vec::new()).collect();
        for one in persistent_cycles(&complex, &self.filtration, &whole, f64::NEG_INFINITY)? {
            let chain = one.bounding_chain().unwrap_or_else(|| one.cycle());
            // A vertex whose class stays has no faces.
            let Some(below) = chain.degree().checked_sub(1) else { continue };
            let mut terms = chain.terms().to_vec();
            terms.sort_unstable_by_key(|(cell, _)| ranks[chain.degree()][cell.index()]);
            let place = |cell: CellId| places[chain.degree()][cell.index()];
            chains[below].push(terms.iter().map(|(cell, entry)| (number(entry), place(*cell))).collect());
        }
        let there = |(degree, own): (usize, &Vec<u32>)| {
            let mut values = vec![0.0; own.len()];
            let given = self.filtration.values(degree);
            own.iter().zip(given).for_each(|(&place, &value)| values[place as usize] = value);
            values
        };
        let degrees = if self.star.is_some() { 1 } else { places.len() };
        let values = places.iter().take(degrees).enumerate().map(there).collect();
        let order = order.into_iter().zip(&places);
        let order =
            order.map(|(order, own)| order.into_iter().map(|cell| own[cell as usize]).collect()).collect();
        let certificate = Certificate {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind: "persistence",
            inputs: Input::list(inputs),
            min_persistence: self.min_persistence,
            answer: &answer,
            proof: Proof { values, order, chains },
        };
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }

    /// The cells of a degree in the order in which they enter.
    fn entering(&self, degree: usize) -> Vec<u32> {
        let values = self.filtration.values(degree);
        let sign = if self.filtration.is_falling() { -1.0 } else { 1.0 };
        let key = |cell: u32| sign * values[cell as usize];
        let mut cells: Vec<u32> = (0..values.len() as u32).collect();
        cells.sort_by(|&a, &b| key(a).partial_cmp(&key(b)).expect("values are numbers"));
        cells
    }
}

/// The complex of the checker with the numbers of the library.
fn renumbered(read: &coface_check::Complex, places: &[Vec<u32>]) -> Result<ChainComplex, Error> {
    if let [points] = places {
        return Ok(ChainComplex::of_points(points.len()));
    }
    let boundary = |degree: usize| {
        let mut back = vec![0; places[degree - 1].len()];
        places[degree - 1].iter().enumerate().for_each(|(own, &place)| back[place as usize] = own);
        let entries: Vec<(usize, usize, i64)> = (places[degree].iter().enumerate())
            .flat_map(|(own, &place)| {
                let faces = read.boundary(degree, place as usize).iter();
                faces.map(move |&(face, incidence)| (face, own, incidence))
            })
            .map(|(face, own, incidence)| (back[face as usize], own, incidence))
            .collect();
        SparseMatrix::from_entries(places[degree - 1].len(), places[degree].len(), entries)
    };
    ChainComplex::new((1..places.len()).map(boundary).collect::<Result<_, _>>()?)
}
