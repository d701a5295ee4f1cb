//! Barycentric subdivision of delta complexes, and their triangulation.
//!
//! A simplex of the subdivision is a chain $S_0 \subset S_1 \subset \dots \subset S_j$ of faces of a standard simplex of
//! which the last is the whole simplex, together with a simplex of the delta complex: the **carrier**, which has it in
//! its interior. Vertices of the chain are barycenters, in rising order of their faces.

use super::{DeltaComplex, FrozenComplex, SimplicialComplex};
use coface_algebra::{CellId, Error, ErrorKind, IdVec, VertexId};

/// A simplex of a delta complex or face class of a gluing table: its degree and its number.
pub type Carrier = (usize, CellId);

/// Most simplices that a subdivision may have.
const SIMPLEX_LIMIT: usize = 1 << 28;

/// A subdivision of a delta complex: what it is divided into, and what each new vertex lies in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Subdivision {
    complex: DeltaComplex,
    carriers: IdVec<VertexId, Carrier>,
}

impl Subdivision {
    /// The subdivision into a complex with these carriers of its vertices.
    pub(crate) fn new(complex: DeltaComplex, carriers: Vec<Carrier>) -> Self {
        Self { complex, carriers: IdVec::from_vec(carriers) }
    }

    /// The subdivided complex. The vertices of a simplex are in rising order of their carriers' degrees for one
    /// subdivision.
    pub fn complex(&self) -> &DeltaComplex {
        &self.complex
    }

    /// For each new vertex, the simplex of the original that has it in its interior: after one subdivision, the simplex
    /// whose barycenter it is.
    pub fn carriers(&self) -> &IdVec<VertexId, Carrier> {
        &self.carriers
    }

    /// The subdivision of the subdivision, with carriers in the original.
    ///
    /// # Errors
    /// As [`DeltaComplex::barycentric_subdivision`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = DeltaComplex::new(1, vec![vec![0, 0]])?;
    /// let twice = circle.barycentric_subdivision()?.subdivided()?;
    /// assert_eq!(twice.complex().f_vector(), [4, 4]);
    /// # Ok(()) }
    /// ```
    pub fn subdivided(&self) -> Result<Self, Error> {
        let finer = self.complex.barycentric_subdivision()?;
        // The last vertex of a chain has the greatest carrier, and the interior of the chain lies in it.
        let carrier = |&(degree, cell): &Carrier| {
            let last = self.complex.back_face(degree, cell, 0);
            self.carriers[VertexId::new(last.index())]
        };
        Ok(Self { carriers: finer.carriers.iter().map(carrier).collect(), complex: finer.complex })
    }
}

/// The chains of faces of the standard simplex of one degree k that end with the whole simplex.
pub(crate) struct Flags {
    /// Those of j + 1 faces at position j; each face is a set of vertices, bit i for vertex i. In lexicographic order.
    chains: Vec<Vec<Vec<u32>>>,
}

impl Flags {
    /// All chains for degrees 0 to `dimension`.
    #[doc(hidden)]
    pub(crate) fn up_to(dimension: usize) -> Vec<Self> {
        (0..=dimension).map(Self::of_degree).collect()
    }

    fn of_degree(degree: usize) -> Self {
        let whole = (1u32 << (degree + 1)) - 1;
        let mut chains = vec![Vec::new(); degree + 1];
        let mut stack = vec![vec![whole]];
        while let Some(chain) = stack.pop() {
            // All proper faces of the first face go before it.
            let first = chain[0];
            let mut face = (first - 1) & first;
            while face > 0 {
                stack.push(std::iter::once(face).chain(chain.iter().copied()).collect());
                face = (face - 1) & first;
            }
            chains[chain.len() - 1].push(chain);
        }
        chains.iter_mut().for_each(|chains| chains.sort_unstable());
        Self { chains }
    }

    /// The chains of j + 1 faces.
    #[doc(hidden)]
    pub(crate) fn chains(&self, j: usize) -> &[Vec<u32>] {
        self.chains.get(j).map_or(&[], Vec::as_slice)
    }

    /// The place of a chain among those of its length.
    #[doc(hidden)]
    pub(crate) fn place(&self, chain: &[u32]) -> usize {
        let chains = &self.chains[chain.len() - 1];
        chains.binary_search_by(|other| other.as_slice().cmp(chain)).expect("all chains are listed")
    }
}

/// The number of chains of faces of the standard simplex of a degree that end with the whole simplex: the number of
/// ordered partitions of degree + 1 things; saturating.
pub(super) fn flag_count(degree: usize) -> usize {
    let mut counts = vec![1_usize];
    for n in 1..=degree + 1 {
        let (mut total, mut choices) = (0_usize, 1_usize);
        for k in 1..=n {
            choices = choices.saturating_mul(n - k + 1) / k;
            total = total.saturating_add(choices.saturating_mul(counts[n - k]));
        }
        counts.push(total);
    }
    counts[degree + 1]
}

/// The positions of the vertices in a set.
pub(crate) fn positions(set: u32) -> Vec<usize> {
    (0..32).filter(|i| set >> i & 1 == 1).collect()
}

/// The set of those places among the vertices of `of` that `set`, a part of it, takes.
pub(crate) fn within(set: u32, of: u32) -> u32 {
    positions(of).iter().enumerate().fold(0, |all, (place, &i)| all | (set >> i & 1) << place)
}

/// Refuses a subdivision with more simplices than fit.
pub(crate) fn check_size(counts: impl IntoIterator<Item = (usize, usize)>) -> Result<(), Error> {
    let total = counts
        .into_iter()
        .fold(0_usize, |all, (degree, n)| all.saturating_add(n.saturating_mul(flag_count(degree))));
    if total > SIMPLEX_LIMIT {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!(
                "the barycentric subdivision has {total} simplices or more; the limit is {SIMPLEX_LIMIT}"
            ),
        ));
    }
    Ok(())
}

impl DeltaComplex {
    /// The barycentric subdivision: its vertices are the simplices of this complex, in the order of their degrees and
    /// numbers, and its j-simplices are chains of j + 1 faces of a simplex that end with the whole simplex. The simplices
    /// of one degree are in the order of the degree of that simplex, its number, and the chain.
    ///
    /// The vertices of a simplex of the subdivision are distinct. That of a complex whose simplices have distinct vertices
    /// has no two simplices with the same vertices: so the second subdivision is always a simplicial complex.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^28 simplices.
    ///
    /// # Complexity
    /// Linear in the result.
    ///
    /// # References
    /// A. Hatcher, *Algebraic Topology* (2002), section 2.1 and exercise 2.1.23.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::simplicial::DeltaComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The circle of one edge becomes two edges from the ends to the middle.
    /// let circle = DeltaComplex::new(1, vec![vec![0, 0]])?.barycentric_subdivision()?;
    /// assert_eq!(circle.complex().f_vector(), [2, 2]);
    /// assert_eq!(circle.complex().vertices(1, CellId::new(0)), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn barycentric_subdivision(&self) -> Result<Subdivision, Error> {
        let counts = self.f_vector();
        check_size(counts.iter().copied().enumerate())?;
        let Some(top) = self.dimension() else { return Ok(Subdivision::new(Self::default(), Vec::new())) };
        let flags = Flags::up_to(top);
        // first[j][k]: the number of the first j-simplex that a k-simplex carries.
        let first: Vec<Vec<usize>> = (0..=top)
            .map(|j| {
                let mut next = 0;
                (0..=top)
                    .map(|k| {
                        let at = next;
                        next += counts[k] * flags[k].chains(j).len();
                        at
                    })
                    .collect()
            })
            .collect();
        let mut faces: Vec<Vec<u32>> = vec![Vec::new(); top];
        for (j, faces) in (1..).zip(&mut faces) {
            for k in j..=top {
                let within_cell: Vec<ChainFaces> =
                    flags[k].chains(j).iter().map(|chain| ChainFaces::of(chain, k, &flags)).collect();
                let width = flags[k].chains(j - 1).len();
                for cell in 0..counts[k] {
                    for chain in &within_cell {
                        let same = first[j - 1][k] + cell * width;
                        faces.extend(chain.inner.iter().map(|place| (same + place) as u32));
                        let carrier = self.face_spanned_by(k, CellId::new(cell), &chain.last_positions);
                        let degree = chain.last_positions.len() - 1;
                        let last_width = flags[degree].chains(j - 1).len();
                        faces.push(
                            (first[j - 1][degree] + carrier.index() * last_width + chain.last_place) as u32,
                        );
                    }
                }
            }
        }
        let carriers = (0..=top).flat_map(|k| (0..counts[k]).map(move |cell| (k, CellId::new(cell))));
        let vertex_count = counts.iter().sum();
        Ok(Subdivision::new(Self::from_trusted_faces(vertex_count, faces), carriers.collect()))
    }

    /// A simplicial complex of the same space: this complex itself if its simplices are told apart by their vertices,
    /// otherwise its first, otherwise its second barycentric subdivision; with the simplex of this complex that has each
    /// vertex in its interior.
    ///
    /// # Errors
    /// As [`Self::barycentric_subdivision`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (circle, carriers) = DeltaComplex::new(1, vec![vec![0, 0]])?.triangulation()?;
    /// assert_eq!(circle.f_vector(), [4, 4]);
    /// // One vertex is the old one, three lie on the edge.
    /// assert_eq!(carriers.iter().filter(|carrier| carrier.0 == 1).count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn triangulation(&self) -> Result<(SimplicialComplex, IdVec<VertexId, Carrier>), Error> {
        if let Ok(sets) = self.vertex_sets() {
            let itself = (0..self.simplex_count(0)).map(|vertex| (0, CellId::new(vertex)));
            return Ok((FrozenComplex::from_facets(&sets)?.thaw(), itself.collect()));
        }
        self.barycentric_subdivision()?.triangulation()
    }
}

impl Subdivision {
    /// A simplicial complex of the same space: this subdivision, or the next one if simplices of this one have the same
    /// vertices; with carriers in the original.
    ///
    /// # Errors
    /// As [`DeltaComplex::barycentric_subdivision`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = DeltaComplex::new(2, vec![vec![1, 0, 1, 0]])?.barycentric_subdivision()?;
    /// assert_eq!(circle.triangulation()?.0.f_vector(), [4, 4]);
    /// # Ok(()) }
    /// ```
    pub fn triangulation(&self) -> Result<(SimplicialComplex, IdVec<VertexId, Carrier>), Error> {
        let finer;
        let (sets, carriers) = match self.complex.vertex_sets() {
            Ok(sets) => (sets, &self.carriers),
            Err(_) => {
                finer = self.subdivided()?;
                (finer.complex.vertex_sets()?, &finer.carriers)
            }
        };
        Ok((FrozenComplex::from_facets(&sets)?.thaw(), carriers.clone()))
    }
}

/// The faces of one chain of faces of a standard simplex.
struct ChainFaces {
    /// For each face of the chain but the last: the place of the chain without it.
    inner: Vec<usize>,
    /// The vertices of the last face but one, which is the whole simplex of the chain without the last ...
    last_positions: Vec<usize>,
    /// ... and the place of that chain among those of that face.
    last_place: usize,
}

impl ChainFaces {
    fn of(chain: &[u32], degree: usize, flags: &[Flags]) -> Self {
        let last = chain.len() - 1;
        let without = |i: usize| -> Vec<u32> { [&chain[..i], &chain[i + 1..]].concat() };
        let inner = (0..last).map(|i| flags[degree].place(&without(i))).collect();
        let carrier = chain[last - 1];
        let restricted: Vec<u32> = chain[..last].iter().map(|&set| within(set, carrier)).collect();
        let last_positions = positions(carrier);
        let last_place = flags[last_positions.len() - 1].place(&restricted);
        Self { inner, last_positions, last_place }
    }
}
