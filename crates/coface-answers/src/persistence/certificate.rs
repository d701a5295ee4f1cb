//! Certificates of persistence diagrams.

use super::FoundDiagram;
use crate::Producer;
use crate::answer::PersistenceAnswer;
use crate::homology::certificate::{Input, Number, checked, number, refused};
use crate::producer::Cells;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, Integer, SparseMatrix};
use coface_topology::{Coefficients, Filtration, persistence, persistent_cycles};
use serde::Serialize;

/// A certificate of a diagram, as `docs/certificates.md` describes it.
#[derive(Serialize)]
pub(super) struct Certificate<'a> {
    coface_certificate: u64,
    coface: &'static str,
    kind: &'static str,
    inputs: Vec<Input>,
    min_persistence: f64,
    /// Of points, the simplices that no other one has as a face.
    #[serde(skip_serializing_if = "Option::is_none")]
    facets: Option<Vec<Vec<u32>>>,
    /// How the file has the points, where the checker finds the simplices and values.
    #[serde(skip_serializing_if = "Option::is_none")]
    layout: Option<&'static str>,
    /// The highest degree of the answer, where the complex has others above.
    #[serde(skip_serializing_if = "Option::is_none")]
    most_degree: Option<usize>,
    answer: &'a PersistenceAnswer,
    proof: Proof,
}

#[derive(Serialize)]
pub(super) struct Proof {
    /// The values of the vertices, or without a star of all cells, by degree; none of a zigzag.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) values: Vec<Vec<f64>>,
    /// For each degree the cells in the order in which they enter.
    pub(super) order: Vec<Vec<u32>>,
    /// For each degree from 1 on the chains that end classes, and the cycles of those that stay, with cells in the order in which they enter.
    pub(super) chains: Vec<Vec<Vec<(Number, u32)>>>,
}

impl<'a> Certificate<'a> {
    /// A certificate of an answer about a file, whose cells the checker reads from it.
    pub(super) fn new(
        kind: &'static str,
        inputs: &[(&str, &[u8])],
        min_persistence: f64,
        answer: &'a PersistenceAnswer,
        proof: Proof,
    ) -> Self {
        Self {
            coface_certificate: coface_check::VERSION,
            coface: env!("CARGO_PKG_VERSION"),
            kind,
            inputs: Input::list(inputs),
            min_persistence,
            facets: None,
            layout: None,
            most_degree: None,
            answer,
            proof,
        }
    }
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
        self.certificate_with(inputs, None)
    }

    /// The same for a complex of points, whose simplices the certificate lists. That they and their values are those of the points in the file is proved of alpha complexes without weights, periods
    /// and bounds of up to some thousand points, and of no others.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::UnsupportedFormat`] for cells that are no simplices.
    ///
    /// # Complexity
    /// That of [`Self::certificate`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PersistenceRequest, PointFiltration};
    /// use coface_io::{AlphaReading, NumberTable};
    /// let input = &b"0 0\n2 0\n2 2\n0 2\n"[..];
    /// let alpha = PointFiltration::of_alpha(AlphaReading::default().points(&NumberTable::read(input)?)?, false);
    /// let found = PersistenceRequest::new().growth(alpha.growth()).found("square.csv", alpha.producer())?;
    /// let certificate = found.certificate_of_points(&[("square.csv", input)])?;
    /// let verdict = coface_check_plane::check(certificate.as_bytes(), &[input]).expect("the proof holds");
    /// assert!(verdict.unchecked().is_empty(), "the checker finds the Delaunay triangulation");
    /// # Ok(()) }
    /// ```
    pub fn certificate_of_points(&self, inputs: &[(&str, &[u8])]) -> Result<String, Error> {
        let facets = facets(self.producer).ok_or_else(|| refused("the cells are no simplices"))?;
        self.certificate_with(inputs, Some(facets))
    }

    fn certificate_with(
        &self,
        inputs: &[(&str, &[u8])],
        facets: Option<Vec<Vec<u32>>>,
    ) -> Result<String, Error> {
        let [(_, bytes)] = inputs else {
            return Err(Error::invalid("a certificate of persistence is of one input"));
        };
        if self.relative_to.is_some() || self.image_of.is_some() {
            return Err(refused("persistence of a part of a model has no certificate"));
        }
        let listed = facets.as_ref().map(crate::answer::to_json);
        let bytes = listed.as_ref().map_or(*bytes, |text| text.as_bytes());
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
        let order: Vec<Vec<u32>> =
            (0..places.len()).map(|degree| entering(&self.filtration, degree)).collect();
        let place = |degree: usize, cell: CellId| places[degree][cell.index()];
        let chains = chains(&complex, &self.filtration, self.diagram.prime(), &order, place)?;
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
        let proof = Proof { values, order, chains };
        let certificate = Certificate::new("persistence", inputs, self.min_persistence, &answer, proof);
        let mut certificate = Certificate { facets, most_degree: self.most_degree, ..certificate };
        if certificate.facets.is_some() && self.function.starts_with("squared radii") {
            // Where the checker does not find the alpha complex, such as one that ends at a value, it is listed alone.
            for layout in ["points", "vertices"] {
                certificate.layout = Some(layout);
                if let Ok(text) = checked(&certificate, inputs) {
                    return Ok(text);
                }
            }
            certificate.layout = None;
        }
        checked(&certificate, inputs).map_err(|fault| refused(&fault.to_string()))
    }
}

/// The terms of a chain: coefficients with cells.
pub(super) type Terms = Vec<(Number, u32)>;

/// For each degree from 1 on the chains that end classes, and the cycles of those that stay, with cells in this order and their numbers by `place`.
pub(super) fn chains(
    complex: &ChainComplex,
    filtration: &Filtration,
    prime: u32,
    order: &[Vec<u32>],
    place: impl Fn(usize, CellId) -> u32,
) -> Result<Vec<Vec<Terms>>, Error> {
    let whole = persistence(complex, filtration, Coefficients::Modulo(prime.into()))?;
    let mut ranks: Vec<Vec<u32>> = order.iter().map(|own| vec![0; own.len()]).collect();
    for (ranks, order) in ranks.iter_mut().zip(order) {
        order.iter().zip(0..).for_each(|(&cell, rank)| ranks[cell as usize] = rank);
    }
    let mut chains: Vec<Vec<_>> = order.iter().skip(1).map(|_| Vec::new()).collect();
    for one in persistent_cycles(complex, filtration, &whole, f64::NEG_INFINITY)? {
        let chain = one.bounding_chain().unwrap_or_else(|| one.cycle());
        // A vertex whose class stays has no faces.
        let Some(below) = chain.degree().checked_sub(1) else { continue };
        let mut terms = chain.terms().to_vec();
        terms.sort_unstable_by_key(|(cell, _)| ranks[chain.degree()][cell.index()]);
        let term = |(cell, entry): &(CellId, Integer)| (number(entry), place(chain.degree(), *cell));
        chains[below].push(terms.iter().map(term).collect());
    }
    Ok(chains)
}

/// The cells of a degree in the order in which they enter.
pub(super) fn entering(filtration: &Filtration, degree: usize) -> Vec<u32> {
    filtration.entrance(degree).to_vec()
}

/// The simplices that no other one has as a face, if all cells are simplices.
fn facets(producer: &Producer) -> Option<Vec<Vec<u32>>> {
    let Cells::Simplices(complex) = &producer.cells else { return None };
    let counts = complex.f_vector();
    let mut is_face: Vec<Vec<bool>> = counts.iter().map(|&count| vec![false; count]).collect();
    for (degree, &count) in counts.iter().enumerate().skip(1) {
        for (_, face) in (0..count).flat_map(|simplex| complex.facets(degree, simplex)) {
            is_face[degree - 1][face] = true;
        }
    }
    let of_degree = |(degree, is_face): (usize, &Vec<bool>)| {
        let own = (0..is_face.len()).filter(|&cell| !is_face[cell]);
        own.map(|cell| producer.cell_vertices(degree, CellId::new(cell))).collect::<Vec<_>>()
    };
    Some(is_face.iter().enumerate().flat_map(of_degree).collect())
}

/// The complex of the checker with the numbers of the library.
pub(super) fn renumbered(read: &coface_check::Complex, places: &[Vec<u32>]) -> Result<ChainComplex, Error> {
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
