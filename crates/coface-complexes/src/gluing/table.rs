//! Gluing tables: simplices of one dimension with their facets glued in pairs.
//!
//! A table of dimension n has n-simplices with the vertices 0 to n, all apart at first. Facet f of a simplex is the one
//! opposite to its vertex f. A **gluing** of facet f of simplex i to simplex j is a permutation p of 0 to n: vertex k of
//! i goes to vertex p(k) of j for all k other than f, and so the facet goes to facet p(f) of j. The partner facet holds
//! the inverse. A facet without a gluing is boundary.
//!
//! The space of a table is the quotient. Faces below the facets are identified as a consequence, in **face classes**:
//! see [`FaceClasses`]. A class may be identified with itself by another order of its vertices (an edge with its own
//! reverse); it is **folded** then.

use crate::components::Components;
use crate::gluing::faces::FaceClasses;
use coface_algebra::{CellId, Error, ErrorKind, Permutation, RaggedArray, UnionFind, narrow};
use std::fmt;

/// The highest dimension of a gluing table.
const DIMENSION_LIMIT: usize = 15;

/// The dimension of a table that is given as an empty list.
const DIMENSION_OF_NOTHING: usize = 3;

const NONE: u32 = u32::MAX;

/// One line of a gluing table: for each facet of a simplex the simplex it is glued to and the images of the vertices
/// 0, 1, ... there, or nothing.
pub type GluingRow = Vec<Option<(u32, Vec<u32>)>>;

/// Simplices of one dimension, 1 to 15, with their facets glued in pairs.
///
/// # Complexity
/// $(n + 1)(n + 5)$ bytes an n-simplex.
///
/// # Examples
/// The 3-sphere of one tetrahedron: two facets are folded onto the two others.
/// ```
/// use coface_complexes::gluing::GluingTable;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mut sphere = GluingTable::unglued(3, 1)?;
/// sphere.glue(0, 0, 0, &[1, 0, 2, 3])?;
/// sphere.glue(0, 2, 0, &[0, 1, 3, 2])?;
/// assert!(sphere.is_closed());
/// assert_eq!(sphere.faces()?.class_counts(), [2, 3, 2, 1]);
/// # Ok(()) }
/// ```
#[derive(Clone, PartialEq, Eq)]
pub struct GluingTable {
    dimension: usize,
    /// For facet f of simplex i, at position i(n + 1) + f, the simplex on the other side or [`NONE`].
    neighbors: Vec<u32>,
    /// For each of these facets the images of the n + 1 vertices; zeros where there is no gluing.
    images: Vec<u8>,
}

impl GluingTable {
    /// The table of this many simplices without any gluing.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] unless the dimension is 1 to 15; [`ErrorKind::TooLarge`] beyond 2^32 facets.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// assert_eq!(GluingTable::unglued(2, 3)?.boundary_facets().count(), 9);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn unglued(dimension: usize, simplex_count: usize) -> Result<Self, Error> {
        if !(1..=DIMENSION_LIMIT).contains(&dimension) {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                format!("gluing tables have a dimension of 1 to {DIMENSION_LIMIT}, not {dimension}"),
            )
            .with_cure("give each simplex one more facet than its dimension"));
        }
        let width = dimension + 1;
        check_count(dimension, simplex_count)?;
        let facet_count = simplex_count * width;
        Ok(Self { dimension, neighbors: vec![NONE; facet_count], images: vec![0; facet_count * width] })
    }

    /// The table with these rows, one for each simplex. Without rows it has dimension 3.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first facet that is wrong: rows of different lengths, a neighbor that is
    /// not there, images that are no permutation, a facet glued to itself, a partner that is not glued back by the
    /// inverse; [`ErrorKind::UnsupportedFormat`] and [`ErrorKind::TooLarge`] as [`Self::unglued`].
    ///
    /// # Complexity
    /// $O(n^2)$ for each n-simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// // A triangle with two sides glued to a cone.
    /// let cone = vec![vec![Some((0, vec![1, 0, 2])), Some((0, vec![1, 0, 2])), None]];
    /// assert_eq!(GluingTable::from_rows(&cone)?.faces()?.class_counts(), [2, 2, 1]);
    /// let one_sided = vec![vec![Some((0, vec![1, 0, 2])), None, None]];
    /// let error = GluingTable::from_rows(&one_sided).unwrap_err();
    /// assert!(error.message().contains("facet 1 of simplex 0"));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn from_rows(rows: &[GluingRow]) -> Result<Self, Error> {
        let width = rows.first().map_or(DIMENSION_OF_NOTHING + 1, Vec::len);
        let (mut neighbors, mut images) = (Vec::with_capacity(rows.len() * width), Vec::new());
        for (i, row) in rows.iter().enumerate() {
            if row.len() != width {
                return Err(different_rows(i, row.len(), width));
            }
            for (f, gluing) in row.iter().enumerate() {
                neighbors.push(gluing.as_ref().map(|gluing| gluing.0));
                match gluing {
                    Some((_, map))
                        if map.len() != width || map.iter().any(|&image| image as usize >= width) =>
                    {
                        return Err(no_permutation(i, f, map, width - 1));
                    }
                    Some((_, map)) => images.extend(map.iter().map(|&image| image as u8)),
                    None => images.extend((0..width).map(|_| 0)),
                }
            }
        }
        Self::from_flat(width, neighbors, images)
    }

    /// The simplices with these vertices, glued along the facets that two of them share; the vertices of a simplex keep their order.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a simplex that repeats a vertex or has another dimension than the first, or a facet of three
    /// simplices; [`ErrorKind::UnsupportedFormat`] and [`ErrorKind::TooLarge`] as [`Self::unglued`].
    ///
    /// # Complexity
    /// $O(m \log m)$ for m facets.
    ///
    /// # Examples
    /// The boundary of a tetrahedron.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = RaggedArray::from_lists([[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]);
    /// let sphere = GluingTable::from_simplices(&triangles)?;
    /// assert!(sphere.is_closed());
    /// assert_eq!(sphere.faces()?.class_counts(), [4, 6, 4]);
    /// # Ok(()) }
    /// ```
    pub fn from_simplices(simplices: &RaggedArray) -> Result<Self, Error> {
        let size = simplices.iter().next().map_or(DIMENSION_OF_NOTHING + 1, <[u32]>::len);
        let dimension = size.checked_sub(1).ok_or_else(|| Error::invalid("simplex 0 has no vertex"))?;
        let mut table = Self::unglued(dimension, simplices.len())?;
        // Each facet by its vertices, rising, with its simplex and the place of the vertex opposite to it.
        let mut keys = Vec::with_capacity(simplices.len() * size * dimension);
        for (i, simplex) in simplices.iter().enumerate() {
            let mut sorted = simplex.to_vec();
            sorted.sort_unstable();
            if simplex.len() != size || sorted.windows(2).any(|pair| pair[0] == pair[1]) {
                return Err(Error::invalid(format!(
                    "simplex {i} has not {size} different vertices as the first has"
                ))
                .with_cure("give simplices of one dimension"));
            }
            for &opposite in simplex {
                keys.extend(sorted.iter().copied().filter(|&vertex| vertex != opposite));
            }
        }
        let key = |facet: usize| &keys[facet * dimension..(facet + 1) * dimension];
        let mut order: Vec<usize> = (0..simplices.len() * size).collect();
        order.sort_unstable_by_key(|&facet| (key(facet), facet));
        for group in order.chunk_by(|&a, &b| key(a) == key(b)) {
            match group {
                &[a, b] => {
                    let (simplex, neighbor) = (simplices.list(a / size), simplices.list(b / size));
                    let image = |(k, vertex): (usize, &u32)| match neighbor
                        .iter()
                        .position(|other| other == vertex)
                    {
                        Some(place) if k != a % size => place as u32,
                        _ => (b % size) as u32,
                    };
                    let images: Vec<u32> = simplex.iter().enumerate().map(image).collect();
                    table.glue(a / size, a % size, b / size, &images)?;
                }
                [_] => {}
                _ => {
                    let message = format!("the facet {:?} lies in {} simplices", key(group[0]), group.len());
                    return Err(Error::invalid(message).with_cure("two at most can be glued there"));
                }
            }
        }
        Ok(table)
    }

    /// The table with these neighbors of facets, `width` to a simplex, and `width` images of vertices for each facet.
    ///
    /// # Errors
    /// As [`Self::from_rows`].
    #[doc(hidden)]
    pub fn from_flat(width: usize, neighbors: Vec<Option<u32>>, images: Vec<u8>) -> Result<Self, Error> {
        let Some(dimension) = width.checked_sub(1) else {
            return Err(Error::invalid("simplex 0 has no facets").with_cure("give one entry for each facet"));
        };
        let mut table = Self::unglued(dimension, 0)?;
        check_count(dimension, neighbors.len() / width)?;
        let count = neighbors.len() / width;
        if let Some(at) = neighbors.iter().position(|neighbor| neighbor.is_some_and(|j| j as usize >= count))
        {
            let neighbor = neighbors[at].expect("the position is that of a neighbor");
            return Err(no_neighbor(at / width, at % width, neighbor as usize, count));
        }
        table.neighbors = neighbors.into_iter().map(|neighbor| neighbor.unwrap_or(NONE)).collect();
        table.images = images;
        table.check()?;
        Ok(table)
    }

    /// Glues facet `facet` of `simplex` to `neighbor`, vertex k to vertex `images[k]`, and that facet back.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] as [`Self::from_rows`], and if one of the two facets is glued already.
    ///
    /// # Examples
    /// Two segments to a circle.
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut circle = GluingTable::unglued(1, 2)?;
    /// circle.glue(0, 0, 1, &[0, 1])?;
    /// circle.glue(0, 1, 1, &[0, 1])?;
    /// assert_eq!(circle.faces()?.class_counts(), [2, 2]);
    /// # Ok(()) }
    /// ```
    pub fn glue(
        &mut self,
        simplex: usize,
        facet: usize,
        neighbor: usize,
        images: &[u32],
    ) -> Result<(), Error> {
        if simplex >= self.simplex_count() || facet > self.dimension {
            return Err(Error::invalid(format!(
                "there is no facet {facet} of simplex {simplex}: there are {} simplices of {} facets, numbered from 0",
                self.simplex_count(),
                self.dimension + 1
            )));
        }
        self.check_gluing(simplex, facet, neighbor, images)?;
        let partner = images[facet] as usize;
        for (i, f) in [(simplex, facet), (neighbor, partner)] {
            if self.neighbor(i, f).is_some() {
                return Err(Error::invalid(format!("facet {f} of simplex {i} is glued already"))
                    .with_cure("glue each facet once"));
            }
        }
        let inverse = inverse_of(images);
        self.set(simplex, facet, neighbor as u32, images);
        self.set(neighbor, partner, simplex as u32, &inverse);
        Ok(())
    }

    fn set(&mut self, simplex: usize, facet: usize, neighbor: u32, images: &[u32]) {
        let width = self.dimension + 1;
        let at = simplex * width + facet;
        self.neighbors[at] = neighbor;
        for (slot, &image) in self.images[at * width..(at + 1) * width].iter_mut().zip(images) {
            *slot = image as u8;
        }
    }

    /// One side of a gluing by itself.
    fn check_gluing(
        &self,
        simplex: usize,
        facet: usize,
        neighbor: usize,
        images: &[u32],
    ) -> Result<(), Error> {
        let width = self.dimension + 1;
        if neighbor >= self.simplex_count() {
            return Err(no_neighbor(simplex, facet, neighbor, self.simplex_count()));
        }
        let mut met = 0_u32;
        for &image in images {
            let bit = if (image as usize) < width { 1 << image } else { 0 };
            if met & bit != 0 || bit == 0 {
                met = u32::MAX;
                break;
            }
            met |= bit;
        }
        if images.len() != width || met == u32::MAX {
            return Err(no_permutation(simplex, facet, images, self.dimension));
        }
        if neighbor == simplex && images[facet] as usize == facet {
            let (what, cure) = if images.iter().enumerate().all(|(k, &image)| k == image as usize) {
                ("by the identity", "write null for a facet that is boundary")
            } else {
                ("by a map that folds it", "subdivide the simplex, so that the facet becomes several")
            };
            let message = format!("facet {facet} of simplex {simplex} is glued to itself {what}");
            return Err(Error::invalid(message).with_cure(cure));
        }
        Ok(())
    }

    /// Verifies the invariants: see [`Self::from_rows`].
    ///
    /// # Errors
    /// Those of [`Self::from_rows`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// GluingTable::unglued(2, 5)?.check()?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn check(&self) -> Result<(), Error> {
        for i in 0..self.simplex_count() {
            for f in 0..=self.dimension {
                let Some((j, images)) = self.neighbor(i, f) else { continue };
                let listed: Vec<u32> = images.iter().map(|&image| u32::from(image)).collect();
                self.check_gluing(i, f, j, &listed)?;
                let g = images[f] as usize;
                let says = match self.neighbor(j, g) {
                    Some((back, inverse))
                        if back == i
                            && (0..images.len()).all(|k| inverse[images[k] as usize] as usize == k) =>
                    {
                        continue;
                    }
                    Some((back, map)) => format!("glued to simplex {back} by {map:?}"),
                    None => "not glued".to_owned(),
                };
                return Err(Error::invalid(format!(
                    "facet {f} of simplex {i} is glued to facet {g} of simplex {j} by {images:?}, but facet {g} of \
                     simplex {j} is {says}"
                ))
                .with_cure("give both sides of each gluing, each the inverse of the other"));
            }
        }
        Ok(())
    }

    /// The dimension n of the simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// assert_eq!(GluingTable::unglued(4, 1)?.dimension(), 4);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The number of simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// assert_eq!(GluingTable::unglued(4, 7)?.simplex_count(), 7);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn simplex_count(&self) -> usize {
        self.neighbors.len() / (self.dimension + 1)
    }

    /// The simplex that a facet is glued to, and the images there of the vertices 0, 1, ...; `None` on the boundary.
    ///
    /// # Panics
    /// If there is no such simplex or facet.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut table = GluingTable::unglued(1, 2)?;
    /// table.glue(0, 0, 1, &[1, 0])?;
    /// assert_eq!(table.neighbor(0, 0), Some((1, &[1, 0][..])));
    /// assert_eq!(table.neighbor(0, 1), None);
    /// # Ok(()) }
    /// ```
    pub fn neighbor(&self, simplex: usize, facet: usize) -> Option<(usize, &[u8])> {
        let width = self.dimension + 1;
        assert!(facet < width, "a simplex of dimension {} has {width} facets", self.dimension);
        let at = simplex * width + facet;
        let neighbor = self.neighbors[at];
        (neighbor != NONE).then(|| (neighbor as usize, &self.images[at * width..(at + 1) * width]))
    }

    /// The rows that [`Self::from_rows`] reads.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut table = GluingTable::unglued(1, 1)?;
    /// table.glue(0, 0, 0, &[1, 0])?;
    /// assert_eq!(table.rows().next(), Some(vec![Some((0, vec![1, 0])), Some((0, vec![1, 0]))]));
    /// # Ok(()) }
    /// ```
    pub fn rows(&self) -> impl Iterator<Item = GluingRow> + '_ {
        (0..self.simplex_count()).map(|i| {
            let entry = |f| {
                let (neighbor, images) = self.neighbor(i, f)?;
                Some((neighbor as u32, images.iter().map(|&image| u32::from(image)).collect()))
            };
            (0..=self.dimension).map(entry).collect()
        })
    }

    /// The facets without a gluing, as simplex and facet.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut table = GluingTable::unglued(1, 2)?;
    /// table.glue(0, 0, 1, &[1, 0])?;
    /// assert_eq!(table.boundary_facets().collect::<Vec<_>>(), [(0, 1), (1, 0)]);
    /// # Ok(()) }
    /// ```
    pub fn boundary_facets(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let width = self.dimension + 1;
        let open = self.neighbors.iter().enumerate().filter(|&(_, &neighbor)| neighbor == NONE);
        open.map(move |(at, _)| (at / width, at % width))
    }

    /// Whether every facet is glued.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// assert!(!GluingTable::unglued(2, 1)?.is_closed());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn is_closed(&self) -> bool {
        !self.neighbors.contains(&NONE)
    }

    /// The connected components of the simplices. Two simplices are connected when facets are glued along a path between them.
    ///
    /// # Complexity
    /// Nearly linear, by union-find over the gluings.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut table = GluingTable::unglued(1, 3)?;
    /// table.glue(0, 0, 2, &[1, 0])?;
    /// assert_eq!(table.components().numbers(), [0, 1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> Components<CellId> {
        let mut partition = UnionFind::new(self.simplex_count());
        for i in 0..self.simplex_count() {
            for (j, _) in (0..=self.dimension).filter_map(|f| self.neighbor(i, f)) {
                partition.unite(narrow(i), narrow(j));
            }
        }
        Components::of_partition(partition)
    }

    /// The same table with its simplices and their vertices named anew: simplex i becomes `simplices.image(i)`, and its
    /// vertex k becomes `vertices[i].image(k)`.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one permutation of the vertices for each simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Permutation;
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut table = GluingTable::unglued(1, 2)?;
    /// table.glue(0, 0, 1, &[1, 0])?;
    /// let turned = Permutation::from_images(vec![1, 0])?;
    /// let other = table.relabeled(&turned, &[turned.clone(), turned.clone()])?;
    /// assert_eq!(other.neighbor(1, 1), Some((0, &[1, 0][..])));
    /// # Ok(()) }
    /// ```
    pub fn relabeled(&self, simplices: &Permutation, vertices: &[Permutation]) -> Result<Self, Error> {
        let count = self.simplex_count();
        if simplices.len() != count
            || vertices.len() != count
            || vertices.iter().any(|permutation| permutation.len() != self.dimension + 1)
        {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "names for {} simplices of dimension {} do not fit {} and {} permutations",
                    count,
                    self.dimension,
                    simplices.len(),
                    vertices.len()
                ),
            )
            .with_cure("give one permutation of the vertices for each simplex"));
        }
        let mut other = Self::unglued(self.dimension, count)?;
        let mut renamed = vec![0; self.dimension + 1];
        for i in 0..count {
            for f in 0..=self.dimension {
                let Some((j, images)) = self.neighbor(i, f) else { continue };
                for (k, &image) in images.iter().enumerate() {
                    renamed[vertices[i].image(k)] = vertices[j].image(image as usize) as u32;
                }
                other.set(simplices.image(i), vertices[i].image(f), simplices.image(j) as u32, &renamed);
            }
        }
        Ok(other)
    }

    /// The face classes of all degrees.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^28 faces of simplices.
    ///
    /// # Complexity
    /// $O(n^2 2^n)$ for each n-simplex.
    ///
    /// # Examples
    /// Two triangles glued along all their sides: the sphere.
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut sphere = GluingTable::unglued(2, 2)?;
    /// (0..3).try_for_each(|side| sphere.glue(0, side, 1, &[0, 1, 2]))?;
    /// assert_eq!(sphere.faces()?.class_counts(), [3, 3, 2]);
    /// # Ok(()) }
    /// ```
    pub fn faces(&self) -> Result<FaceClasses, Error> {
        FaceClasses::of(self)
    }
}

/// A row of another length than the first.
pub fn different_rows(simplex: usize, length: usize, width: usize) -> Error {
    Error::invalid(format!("simplex {simplex} has {length} facets, but simplex 0 has {width}"))
        .with_cure("a table has simplices of one dimension")
}

/// A vertex map that is none.
pub fn no_permutation(simplex: usize, facet: usize, images: &[u32], dimension: usize) -> Error {
    let shown = &images[..images.len().min(20)];
    Error::invalid(format!(
        "the vertex map {shown:?} of facet {facet} of simplex {simplex} is no permutation of 0 to {dimension}"
    ))
    .with_cure("give for each vertex, the one opposite to the facet too, the vertex it goes to")
}

fn no_neighbor(simplex: usize, facet: usize, neighbor: usize, count: usize) -> Error {
    Error::invalid(format!(
        "facet {facet} of simplex {simplex} is glued to simplex {neighbor}, but there are {count} simplices, numbered \
         from 0"
    ))
}

/// Refuses more facets than there are 32-bit numbers.
fn check_count(dimension: usize, simplex_count: usize) -> Result<(), Error> {
    if simplex_count.saturating_mul(dimension + 1) < NONE as usize {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::TooLarge,
        format!("{simplex_count} simplices have too many facets; the limit is 2^32 - 1"),
    ))
}

/// The inverse of a permutation given by its images.
fn inverse_of(images: &[u32]) -> Vec<u32> {
    let mut inverse = vec![0; images.len()];
    for (k, &image) in images.iter().enumerate() {
        inverse[image as usize] = k as u32;
    }
    inverse
}

impl fmt::Debug for GluingTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "GluingTable of dimension {} ", self.dimension)?;
        f.debug_list().entries(self.rows()).finish()
    }
}
