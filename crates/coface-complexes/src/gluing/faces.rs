//! The faces of a gluing table: which faces of the simplices are one, and in which order of their vertices.

use crate::gluing::table::GluingTable;
use crate::simplicial::delta_subdivision::Flags;
use crate::simplicial::delta_subdivision::check_size;
use crate::simplicial::delta_subdivision::positions;
use crate::simplicial::delta_subdivision::within;
use crate::simplicial::{DeltaComplex, Subdivision};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{SparseMatrix, UnionFind};
use std::collections::BTreeMap;

/// Most faces of simplices, before they are identified.
const FACE_LIMIT: usize = 1 << 28;

const NONE: u32 = u32::MAX;

/// The faces of a gluing table, identified: for each degree k the classes of k-faces.
///
/// Classes of one degree are numbered in the order of their first faces: by simplex, then lexicographically by vertices.
/// The first face is the **representative**, and the rising order of its vertices is the order of the class; each other
/// face of the class has its vertices matched with that order. A class whose gluings lead back to the representative with
/// another order is **folded**.
///
/// # Examples
/// A triangle with its side from 0 to 1 glued to that from 1 to 2: the Moebius band.
/// ```
/// use coface_algebra::CellId;
/// use coface_complexes::gluing::GluingTable;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mut band = GluingTable::unglued(2, 1)?;
/// band.glue(0, 2, 0, &[1, 2, 0])?;
/// let faces = band.faces()?;
/// assert_eq!(faces.class_counts(), [1, 2, 1]);
/// let [side, rim] = [0, 1].map(CellId::new);
/// assert_eq!(faces.class(0, &[1, 2])?, (side, vec![0, 1]));
/// assert!(faces.is_boundary(1, rim) && !faces.is_boundary(1, side));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FaceClasses {
    dimension: usize,
    /// The place of each set of vertices, bit i for vertex i, among those of its size in lexicographic order.
    place: Vec<u32>,
    degrees: Vec<Degree>,
}

/// The faces of one degree k.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Degree {
    /// The sets of k + 1 vertices in lexicographic order. Face s of simplex i is the face i * sets.len() + s.
    sets: Vec<u32>,
    /// The class of each face.
    classes: Vec<u32>,
    /// For each face the place of each of its k + 1 vertices, rising, in the order of the class.
    orders: Vec<u8>,
    /// The representative of each class, as simplex and set.
    first: Vec<(u32, u32)>,
    /// Whether a face of the class lies in a facet without gluing.
    boundary: Vec<bool>,
    /// For each folded class permutations of 0 to k that generate all its identifications with itself.
    folds: BTreeMap<u32, Vec<Vec<u8>>>,
}

/// How many vertices of a set are below this one.
fn rank(set: u32, vertex: usize) -> usize {
    (set & ((1 << vertex) - 1)).count_ones() as usize
}

impl FaceClasses {
    pub(super) fn of(table: &GluingTable) -> Result<Self, Error> {
        let dimension = table.dimension();
        let total = table.simplex_count().saturating_mul(1 << (dimension + 1));
        if total > FACE_LIMIT {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("the simplices have {total} faces in all; the limit is {FACE_LIMIT}"),
            ));
        }
        let mut sets: Vec<Vec<u32>> = vec![Vec::new(); dimension + 1];
        for set in 1..1_u32 << (dimension + 1) {
            sets[set.count_ones() as usize - 1].push(set);
        }
        // Of two sets of one size, that with the lower first different vertex is first: compare with bits mirrored.
        sets.iter_mut()
            .for_each(|sets| sets.sort_unstable_by_key(|set| std::cmp::Reverse(set.reverse_bits())));
        let mut place = vec![0; 1 << (dimension + 1)];
        for sets in &sets {
            for (i, &set) in sets.iter().enumerate() {
                place[set as usize] = i as u32;
            }
        }
        let degrees = sets.into_iter().map(|sets| Degree::of(table, sets, &place)).collect();
        Ok(Self { dimension, place, degrees })
    }

    /// The numbers of classes of degrees 0, 1, ...; empty for a table without simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// assert_eq!(GluingTable::unglued(2, 1)?.faces()?.class_counts(), [3, 3, 1]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn class_counts(&self) -> Vec<usize> {
        let counts: Vec<usize> = self.degrees.iter().map(|degree| degree.first.len()).collect();
        if counts[0] == 0 { Vec::new() } else { counts }
    }

    /// The alternating sum of the numbers of classes. With folded classes it may differ from the Euler characteristic of
    /// the space.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// assert_eq!(GluingTable::unglued(2, 2)?.faces()?.alternating_count(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn alternating_count(&self) -> i64 {
        let signed = |(k, n): (usize, usize)| if k % 2 == 0 { n as i64 } else { -(n as i64) };
        self.class_counts().into_iter().enumerate().map(signed).sum()
    }

    /// The class of the face of a simplex with these vertices, in any order, and for each of them, as given, its place in
    /// the order of the class.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if there is no such simplex or vertex, or a vertex is repeated.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::gluing::GluingTable;
    /// let triangle = GluingTable::unglued(2, 1)?.faces()?;
    /// assert_eq!(triangle.class(0, &[2, 0])?, (CellId::new(1), vec![1, 0]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn class(&self, simplex: usize, vertices: &[usize]) -> Result<(CellId, Vec<u8>), Error> {
        let set = vertices.iter().fold(0_u32, |set, &v| set | if v <= self.dimension { 1 << v } else { 0 });
        if simplex >= self.degrees[self.dimension].first.len()
            || vertices.is_empty()
            || set.count_ones() as usize != vertices.len()
        {
            return Err(Error::new(
                ErrorKind::NotInComplex,
                format!("there is no face {vertices:?} of simplex {simplex}"),
            )
            .with_cure(format!("give distinct vertices from 0 to {}", self.dimension)));
        }
        let (class, order) = self.of_face(simplex, set);
        Ok((CellId::new(class), vertices.iter().map(|&v| order[rank(set, v)]).collect()))
    }

    /// The class of a face and the places of its rising vertices in the order of the class.
    #[doc(hidden)]
    pub fn of_face(&self, simplex: usize, set: u32) -> (usize, &[u8]) {
        let width = set.count_ones() as usize;
        let degree = &self.degrees[width - 1];
        let face = simplex * degree.sets.len() + self.place[set as usize] as usize;
        (degree.classes[face] as usize, &degree.orders[face * width..(face + 1) * width])
    }

    /// The first face of a class: its simplex and its rising vertices.
    ///
    /// # Panics
    /// If there is no such class.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::gluing::GluingTable;
    /// let triangle = GluingTable::unglued(2, 1)?.faces()?;
    /// assert_eq!(triangle.representative(1, CellId::new(2)), (0, vec![1, 2]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn representative(&self, degree: usize, class: CellId) -> (usize, Vec<usize>) {
        let (simplex, set) = self.degrees[degree].first[class.index()];
        (simplex as usize, positions(set))
    }

    /// Whether a face of the class lies in a facet without gluing.
    ///
    /// # Panics
    /// If there is no such class.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::gluing::GluingTable;
    /// assert!(GluingTable::unglued(2, 1)?.faces()?.is_boundary(0, CellId::new(2)));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn is_boundary(&self, degree: usize, class: CellId) -> bool {
        self.degrees[degree].boundary[class.index()]
    }

    /// The classes of a degree that are identified with themselves by another order of their vertices, rising. There are
    /// none in dimensions 1 and 2; in dimension 3 they are edges identified with their own reverses.
    ///
    /// # Examples
    /// A tetrahedron with facet 012 turned onto facet 013 so that edge 01 is reversed:
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut table = GluingTable::unglued(3, 1)?;
    /// table.glue(0, 3, 0, &[1, 0, 3, 2])?;
    /// assert_eq!(table.faces()?.folded(1).collect::<Vec<_>>(), [CellId::new(0)]);
    /// # Ok(()) }
    /// ```
    pub fn folded(&self, degree: usize) -> impl Iterator<Item = CellId> + '_ {
        self.degrees
            .get(degree)
            .into_iter()
            .flat_map(|faces| faces.folds.keys().map(|&class| CellId::from_u32(class)))
    }

    /// Whether a class of some degree is folded.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// assert!(!GluingTable::unglued(3, 1)?.faces()?.has_folds());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn has_folds(&self) -> bool {
        self.degrees.iter().any(|degree| !degree.folds.is_empty())
    }

    /// The vertex classes of a class, in its order.
    ///
    /// # Panics
    /// If there is no such class.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::gluing::GluingTable;
    /// let triangle = GluingTable::unglued(2, 1)?.faces()?;
    /// assert_eq!(triangle.vertices(1, CellId::new(1)), [0, 2]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn vertices(&self, degree: usize, class: CellId) -> Vec<u32> {
        let (simplex, set) = self.degrees[degree].first[class.index()];
        let count = self.dimension + 1;
        positions(set).iter().map(|&v| self.degrees[0].classes[simplex as usize * count + v]).collect()
    }

    /// The chain complex of the space of the table.
    ///
    /// If no class is folded, cells of degree k are the k-classes, each oriented by its order: the boundary of a class
    /// is the alternating sum of the facets of its representative, each with the sign of the permutation between the
    /// rising order of its vertices and the order of its class. If a class is folded, the classes are no cells, and this
    /// is the chain complex of the barycentric subdivision.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] as [`Self::barycentric_subdivision`].
    ///
    /// # Complexity
    /// Linear in the faces of the classes; with folds, in those of the subdivision.
    ///
    /// # Examples
    /// The Klein bottle as a square of two triangles: facet 0 to facet 0 is the diagonal.
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut klein = GluingTable::unglued(2, 2)?;
    /// klein.glue(0, 0, 1, &[0, 1, 2])?;
    /// klein.glue(0, 1, 1, &[1, 2, 0])?;
    /// klein.glue(0, 2, 1, &[0, 2, 1])?;
    /// assert_eq!(klein.faces()?.chain_complex()?.euler_characteristic(), 0);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        if self.has_folds() {
            return self.barycentric_subdivision()?.complex().chain_complex();
        }
        if self.degrees[0].first.is_empty() {
            return Ok(ChainComplex::of_points(0));
        }
        let matrices: Result<Vec<SparseMatrix>, Error> =
            (1..=self.dimension).map(|degree| self.boundary_matrix(degree)).collect();
        ChainComplex::new(matrices?)
    }

    fn boundary_matrix(&self, degree: usize) -> Result<SparseMatrix, Error> {
        let first = &self.degrees[degree].first;
        let entries = first.iter().enumerate().flat_map(|(class, &(simplex, set))| {
            positions(set).into_iter().enumerate().map(move |(i, vertex)| {
                let (face, order) = self.of_face(simplex as usize, set & !(1 << vertex));
                (face, class, if (i + inversions(order)).is_multiple_of(2) { 1 } else { -1 })
            })
        });
        SparseMatrix::from_entries(self.degrees[degree - 1].first.len(), first.len(), entries)
    }

    /// The classes as a delta complex with the same numbers, if every face of the representative of each class has its
    /// vertices in the order of its own class and none is folded; else `None`.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut circle = GluingTable::unglued(1, 1)?;
    /// circle.glue(0, 0, 0, &[1, 0])?;
    /// assert_eq!(circle.faces()?.to_delta().map(|delta| delta.f_vector()), Some(vec![1, 1]));
    /// # Ok(()) }
    /// ```
    pub fn to_delta(&self) -> Option<DeltaComplex> {
        if self.has_folds() {
            return None;
        }
        let mut faces: Vec<Vec<u32>> = Vec::with_capacity(self.dimension);
        for degree in 1..=self.dimension {
            let mut flat = Vec::with_capacity(self.degrees[degree].first.len() * (degree + 1));
            for &(simplex, set) in &self.degrees[degree].first {
                for vertex in positions(set) {
                    let (face, order) = self.of_face(simplex as usize, set & !(1 << vertex));
                    if !order.is_sorted() {
                        return None;
                    }
                    flat.push(face as u32);
                }
            }
            faces.push(flat);
        }
        Some(DeltaComplex::from_trusted_faces(self.degrees[0].first.len(), faces))
    }

    /// The barycentric subdivision of the space of the table. Its vertices are the classes of all degrees, in the order
    /// of degree and number, and each is carried by its class. Folds are no obstacle: half of a folded edge is an edge.
    ///
    /// The simplices of one degree j are chains of j + 1 faces of a representative, ending with the representative, in
    /// the order of the degree and number of the class and of the chain; of chains that folds identify, the first.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^28 simplices.
    ///
    /// # Complexity
    /// Linear in the simplices of the subdivision without folds.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut table = GluingTable::unglued(3, 1)?;
    /// table.glue(0, 3, 0, &[1, 0, 3, 2])?;
    /// let folded = table.faces()?;
    /// // The edge that is folded has one half: a vertex in its middle and its end.
    /// let vertices: usize = folded.class_counts().iter().sum();
    /// assert_eq!(folded.barycentric_subdivision()?.complex().simplex_count(0), vertices);
    /// # Ok(()) }
    /// ```
    pub fn barycentric_subdivision(&self) -> Result<Subdivision, Error> {
        let counts = self.class_counts();
        check_size(counts.iter().copied().enumerate())?;
        if counts.is_empty() {
            return Ok(Subdivision::new(DeltaComplex::default(), Vec::new()));
        }
        let top = self.dimension;
        let flags = Flags::up_to(top);
        // numbers[j][k]: the j-simplices that k-classes carry.
        let mut numbers: Vec<Vec<Chains>> = Vec::with_capacity(top + 1);
        for j in 0..=top {
            let mut next = 0;
            numbers.push((0..=top).map(|k| Chains::of(&self.degrees[k], &flags[k], j, &mut next)).collect());
        }
        let mut faces: Vec<Vec<u32>> = vec![Vec::new(); top];
        for (j, flat) in (1..).zip(&mut faces) {
            for k in j..=top {
                let chains = flags[k].chains(j);
                for (class, &(simplex, set)) in self.degrees[k].first.iter().enumerate() {
                    let vertices = positions(set);
                    let mut met = 0;
                    for (at, chain) in chains.iter().enumerate() {
                        // Orbits are numbered as they are met: a lower number was met before.
                        if numbers[j][k].orbit(class, at) < met {
                            continue;
                        }
                        met += 1;
                        for i in 0..j {
                            let inner = [&chain[..i], &chain[i + 1..]].concat();
                            flat.push(numbers[j - 1][k].number(class, flags[k].place(&inner)));
                        }
                        let (last, rest) = (chain[j - 1], &chain[..j]);
                        let face = positions(last).iter().fold(0, |face, &i| face | 1 << vertices[i]);
                        let (carrier, order) = self.of_face(simplex as usize, face);
                        let moved: Vec<u32> = rest
                            .iter()
                            .map(|&part| {
                                positions(within(part, last))
                                    .iter()
                                    .fold(0, |image, &p| image | 1 << order[p])
                            })
                            .collect();
                        let degree = order.len() - 1;
                        flat.push(numbers[j - 1][degree].number(carrier, flags[degree].place(&moved)));
                    }
                }
            }
        }
        let carriers = (0..=top).flat_map(|k| (0..counts[k]).map(move |class| (k, CellId::new(class))));
        let complex = DeltaComplex::from_trusted_faces(counts.iter().sum(), faces);
        Ok(Subdivision::new(complex, carriers.collect()))
    }
}

/// The number of pairs in the wrong order.
pub(super) fn inversions(order: &[u8]) -> usize {
    (1..order.len()).map(|i| order[..i].iter().filter(|&&before| before > order[i]).count()).sum()
}

impl Degree {
    /// The classes of the faces with these sets of vertices. Each class is walked from its first face over gluings.
    fn of(table: &GluingTable, sets: Vec<u32>, place: &[u32]) -> Self {
        let (per_simplex, width) = (sets.len(), sets[0].count_ones() as usize);
        let face_count = table.simplex_count() * per_simplex;
        let mut classes = vec![NONE; face_count];
        let mut orders = vec![0_u8; face_count * width];
        let (mut first, mut boundary, mut folds) = (Vec::new(), Vec::new(), BTreeMap::new());
        let (mut stack, mut moved) = (Vec::new(), vec![0_u8; width]);
        for start in 0..face_count {
            if classes[start] != NONE {
                continue;
            }
            let class = first.len() as u32;
            first.push(((start / per_simplex) as u32, sets[start % per_simplex]));
            let (mut open, mut generators) = (false, Vec::<Vec<u8>>::new());
            classes[start] = class;
            (0..width).for_each(|p| orders[start * width + p] = p as u8);
            stack.push(start);
            while let Some(face) = stack.pop() {
                let (simplex, set) = (face / per_simplex, sets[face % per_simplex]);
                for f in (0..=table.dimension()).filter(|f| set >> f & 1 == 0) {
                    let Some((other, images)) = table.neighbor(simplex, f) else {
                        open = true;
                        continue;
                    };
                    let vertices = (0..=table.dimension()).filter(|v| set >> v & 1 == 1);
                    let image = vertices.clone().fold(0_u32, |image, v| image | 1 << images[v]);
                    for (p, v) in vertices.enumerate() {
                        moved[rank(image, images[v] as usize)] = orders[face * width + p];
                    }
                    let next = other * per_simplex + place[image as usize] as usize;
                    let known = next * width..(next + 1) * width;
                    if classes[next] == NONE {
                        classes[next] = class;
                        orders[known].copy_from_slice(&moved);
                        stack.push(next);
                    } else if orders[known.clone()] != moved[..] {
                        let mut fold = vec![0; width];
                        for (&from, &to) in orders[known].iter().zip(&moved) {
                            fold[from as usize] = to;
                        }
                        if !generators.contains(&fold) {
                            generators.push(fold);
                        }
                    }
                }
            }
            if !generators.is_empty() {
                folds.insert(class, generators);
            }
            boundary.push(open);
        }
        Self { sets, classes, orders, first, boundary, folds }
    }
}

/// The simplices of a subdivision that the classes of one degree carry, given by chains of one length.
struct Chains {
    /// The number of the first simplex of each class.
    starts: Vec<u32>,
    /// For each folded class the place of each chain's orbit among the orbits; orbits in the order of first chains.
    orbits: BTreeMap<usize, Vec<u32>>,
}

impl Chains {
    /// The simplices for chains of j + 1 faces; `next` is the number of the first and becomes that after the last.
    fn of(faces: &Degree, flags: &Flags, j: usize, next: &mut usize) -> Self {
        let chains = flags.chains(j);
        let (mut starts, mut orbits) = (Vec::with_capacity(faces.first.len()), BTreeMap::new());
        for class in 0..faces.first.len() {
            starts.push(*next as u32);
            match faces.folds.get(&(class as u32)) {
                Some(generators) => {
                    let mut partition = UnionFind::new(chains.len());
                    for fold in generators {
                        for (at, chain) in chains.iter().enumerate() {
                            let image =
                                |set: u32| positions(set).iter().fold(0, |all, &i| all | 1 << fold[i]);
                            let images: Vec<u32> = chain.iter().map(|&set| image(set)).collect();
                            partition.unite(at as u32, flags.place(&images) as u32);
                        }
                    }
                    *next += partition.class_count();
                    orbits.insert(class, partition.class_numbers());
                }
                None => *next += chains.len(),
            }
        }
        Self { starts, orbits }
    }

    /// The place of the orbit of a chain among those of a class.
    fn orbit(&self, class: usize, chain: usize) -> u32 {
        self.orbits.get(&class).map_or(chain as u32, |orbits| orbits[chain])
    }

    /// The number of the simplex of a chain.
    fn number(&self, class: usize, chain: usize) -> u32 {
        self.starts[class] + self.orbit(class, chain)
    }
}
