//! Certificates of persistence diagrams.

use super::FoundDiagram;
use crate::Producer;
use crate::answer::PersistenceAnswer;
use crate::homology::certificate::{Input, Number, checked, number, refused};
use crate::producer::Cells;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, Integer, Residue, SparseMatrix};
use coface_topology::{Coefficients, Filtration, persistence, persistent_cycles};
use serde::Serialize;
use std::collections::BTreeMap;

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
    /// What the part is that the answer is relative to, or whose image it is about: the boundary, the cells of the second input, or groups.
    #[serde(skip_serializing_if = "Option::is_none")]
    part: Option<&'static str>,
    /// The cells of groups of a mesh, but for faces of each other, by their vertices.
    #[serde(skip_serializing_if = "Option::is_none")]
    part_cells: Option<Vec<Vec<u32>>>,
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
    pub(super) chains: Vec<Vec<Terms>>,
    /// Of the image of a part, the same of the part by itself, and chains whose boundaries have different last cells where those of the part come first.
    #[serde(flatten)]
    pub(super) of_image: Option<ImageProof>,
}

#[derive(Serialize)]
pub(super) struct ImageProof {
    part_chains: Vec<Vec<Terms>>,
    image_chains: Vec<Vec<Terms>>,
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
            part: None,
            part_cells: None,
            most_degree: None,
            answer,
            proof,
        }
    }
}

impl FoundDiagram<'_> {
    /// A certificate of the diagram, from the name and the bytes of the file that the model was read from: an answer without cycles, and chains that
    /// prove it, which [`coface_check_plane::check`] follows without any code of this library, as `docs/certificates.md` says. It has been checked.
    /// Relative to a part from a file, or of the image of one, it is of two inputs: the file of the part is behind that of the model. Of groups of a mesh it lists the cells;
    /// the checker finds them in OBJ, and otherwise leaves open which these are.
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
        let expected = 1 + usize::from(self.part.is_some_and(|part| part == "file"));
        let Some((_, bytes)) = inputs.first().filter(|_| inputs.len() == expected) else {
            return Err(Error::invalid(match expected {
                1 => "a certificate of persistence is of one input",
                _ => "a certificate of persistence of a part is of two inputs: the model, and the part",
            }));
        };
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
        let prime = self.diagram.prime();
        let place = |degree: usize, cell: CellId| places[degree][cell.index()];
        let of_whole = || chains(&complex, &self.filtration, prime, &order, place);
        let (chains, placed_order, of_image) = match (&self.kept, &self.inside) {
            (Some(kept), _) => {
                // The checker numbers what is left of the whole among itself.
                let numbers = numbers_among(kept, &places);
                let place = |degree: usize, cell: CellId| numbers[degree][cell.index()];
                let left = complex.relative(&complex.complement(kept)?)?;
                let filtration = self.filtration.restricted(kept);
                let order: Vec<Vec<u32>> =
                    (0..kept.len()).map(|degree| entering(&filtration, degree)).collect();
                let chains = chains(&left, &filtration, prime, &order, place)?;
                (chains, placed(&order, &numbers), None)
            }
            (None, Some(inside)) => {
                let numbers = numbers_among(inside, &places);
                let own = |degree: usize, cell: CellId| numbers[degree][cell.index()];
                let part = complex.subcomplex(inside)?;
                let filtration = self.filtration.restricted(inside);
                let part_order: Vec<Vec<u32>> =
                    (0..inside.len()).map(|degree| entering(&filtration, degree)).collect();
                let of_image = ImageProof {
                    part_chains: chains(&part, &filtration, prime, &part_order, own)?,
                    image_chains: image_chains(&complex, &self.filtration, prime, &order, inside, &places)?,
                };
                (of_whole()?, placed(&order, &places), Some(of_image))
            }
            (None, None) => (of_whole()?, placed(&order, &places), None),
        };
        let there = |(degree, own): (usize, &Vec<u32>)| {
            let mut values = vec![0.0; own.len()];
            let given = self.filtration.values(degree);
            own.iter().zip(given).for_each(|(&place, &value)| values[place as usize] = value);
            values
        };
        let degrees = if self.star.is_some() { 1 } else { places.len() };
        let values = places.iter().take(degrees).enumerate().map(there).collect();
        let proof = Proof { values, order: placed_order, chains, of_image };
        let certificate = Certificate::new("persistence", inputs, self.min_persistence, &answer, proof);
        let part_cells = match (self.part, &self.kept, &self.inside) {
            (Some("groups"), Some(kept), _) => Some(self.cells_of(&complex, &complex.complement(kept)?)),
            (Some("groups"), _, Some(inside)) => Some(self.cells_of(&complex, inside)),
            _ => None,
        };
        let mut certificate =
            Certificate { facets, part_cells, part: self.part, most_degree: self.most_degree, ..certificate };
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

/// The proof of the diagram of a function that grows by lower stars.
pub(super) fn proof_of_star(
    producer: &Producer,
    read: &coface_check::Complex,
    filtration: &Filtration,
    prime: u32,
) -> Result<Proof, Error> {
    let degrees = 0..read.counts().len();
    let cell_counts: Vec<usize> = degrees.map(|degree| filtration.values(degree).len()).collect();
    let places = producer.places_on(read, &cell_counts)?;
    let complex = renumbered(read, &places)?;
    let order: Vec<Vec<u32>> = (0..places.len()).map(|degree| entering(filtration, degree)).collect();
    let place = |degree: usize, cell: CellId| places[degree][cell.index()];
    let chains = chains(&complex, filtration, prime, &order, place)?;
    let mut values = vec![0.0; cell_counts[0]];
    places[0].iter().zip(filtration.values(0)).for_each(|(&place, &value)| values[place as usize] = value);
    Ok(Proof { values: vec![values], order: placed(&order, &places), chains, of_image: None })
}

impl FoundDiagram<'_> {
    /// The cells of a subcomplex that are no faces of others in it, by their vertices.
    fn cells_of(&self, complex: &ChainComplex, part: &[Vec<CellId>]) -> Vec<Vec<u32>> {
        let mut is_face: Vec<Vec<bool>> =
            complex.f_vector().iter().map(|&count| vec![false; count]).collect();
        for (degree, cells) in part.iter().enumerate().skip(1) {
            let Some(matrix) = complex.boundary_matrix(degree) else { continue };
            for (face, _) in cells.iter().flat_map(|cell| matrix.column(cell.index()).iter()) {
                is_face[degree - 1][face] = true;
            }
        }
        let of_degree = |(degree, cells): (usize, &Vec<CellId>)| {
            let own = cells.iter().filter(|cell| !is_face[degree][cell.index()]);
            own.map(|&cell| self.producer.cell_vertices(degree, cell)).collect::<Vec<_>>()
        };
        part.iter().enumerate().flat_map(of_degree).collect()
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

/// Cells in this order, with their numbers.
fn placed(order: &[Vec<u32>], numbers: &[Vec<u32>]) -> Vec<Vec<u32>> {
    let of =
        |(order, numbers): (&Vec<u32>, &Vec<u32>)| order.iter().map(|&cell| numbers[cell as usize]).collect();
    order.iter().zip(numbers).map(of).collect()
}

/// For some of the cells of each degree their numbers among themselves, in the order of the checker.
fn numbers_among(cells: &[Vec<CellId>], places: &[Vec<u32>]) -> Vec<Vec<u32>> {
    let of = |(cells, places): (&Vec<CellId>, &Vec<u32>)| {
        let mut there: Vec<(u32, usize)> =
            cells.iter().enumerate().map(|(own, cell)| (places[cell.index()], own)).collect();
        there.sort_unstable();
        let mut numbers = vec![0; cells.len()];
        there.iter().zip(0..).for_each(|(&(_, own), number)| numbers[own] = number);
        numbers
    };
    cells.iter().zip(places).map(of).collect()
}

/// For each degree from 1 on a chain for each cell that ends a class of the whole: the boundaries have different last cells, where the cells of the part come
/// first, and then the others.
fn image_chains(
    complex: &ChainComplex,
    filtration: &Filtration,
    prime: u32,
    order: &[Vec<u32>],
    inside: &[Vec<CellId>],
    places: &[Vec<u32>],
) -> Result<Vec<Vec<Terms>>, Error> {
    let whole = persistence(complex, filtration, Coefficients::Modulo(prime.into()))?;
    let field = u64::from(prime);
    let mut chains = Vec::new();
    for (degree, cells) in order.iter().enumerate().skip(1) {
        let mut is_inside = vec![false; order[degree - 1].len()];
        inside[degree - 1].iter().for_each(|cell| is_inside[cell.index()] = true);
        let entered = &order[degree - 1];
        let first = entered.iter().filter(|&&face| is_inside[face as usize]);
        let then = entered.iter().filter(|&&face| !is_inside[face as usize]);
        let mut ranks = vec![0; entered.len()];
        first.chain(then).zip(0..).for_each(|(&face, rank)| ranks[face as usize] = rank);
        let mut ends_class = vec![false; cells.len()];
        let pairs = whole.pairs_of_degree(degree - 1);
        pairs.iter().filter_map(|pair| pair.death_cell()).for_each(|cell| ends_class[cell.index()] = true);
        let Some(matrix) = complex.boundary_matrix(degree) else {
            chains.push(Vec::new());
            continue;
        };
        // Boundary and chain of each, by the last face; cells of chains by when they enter.
        let mut reduced: BTreeMap<u32, [BTreeMap<u32, u64>; 2]> = BTreeMap::new();
        let mut of_degree: Vec<Terms> = Vec::new();
        for (when, &cell) in (0..).zip(cells).filter(|&(_, &cell)| ends_class[cell as usize]) {
            let residue = |entry: i32| i64::from(entry).rem_euclid(i64::from(prime)).unsigned_abs();
            let boundary = matrix.column(cell as usize).iter();
            let boundary = boundary.map(|(face, entry)| (ranks[face], residue(entry)));
            let mut boundary: BTreeMap<u32, u64> = boundary.filter(|&(_, entry)| entry != 0).collect();
            let mut chain = BTreeMap::from([(when, 1)]);
            while let Some((&last, &entry)) = boundary.last_key_value()
                && let Some([other, other_chain]) = reduced.get(&last)
            {
                let unit = Residue::new(other[&last] as i64, prime)?.inverse();
                let unit = unit.expect("a number that is not zero has an inverse in a field");
                let factor = field - entry * u64::from(unit.value()) % field;
                add(&mut boundary, factor, other, field);
                add(&mut chain, factor, other_chain, field);
            }
            let term = |(&when, &entry): (&u32, &u64)| {
                let cell = cells[when as usize] as usize;
                // Below 2^32.
                (Number::Short(entry as i64), places[degree][cell])
            };
            of_degree.push(chain.iter().map(term).collect());
            if let Some((&last, _)) = boundary.last_key_value() {
                reduced.insert(last, [boundary, chain]);
            }
        }
        chains.push(of_degree);
    }
    Ok(chains)
}

/// Adds a multiple of a vector over the field of p elements.
fn add(sum: &mut BTreeMap<u32, u64>, factor: u64, other: &BTreeMap<u32, u64>, prime: u64) {
    for (&at, &entry) in other {
        let value = (sum.get(&at).copied().unwrap_or(0) + factor * entry) % prime;
        match value {
            0 => sum.remove(&at),
            _ => sum.insert(at, value),
        };
    }
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
