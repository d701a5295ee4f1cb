//! Simplicial complexes that do not change: sorted flat arrays, for large read-only work.

use super::lists::{FaceWalk, Growth, Lists, too_many_faces};
use super::tree::{CALL_LIMIT, ROOT, Tree};
use super::tree_walk::Walk;
use super::{Simplex, SimplicialComplex};
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{RaggedArray, Sign};
use rayon::prelude::*;
use std::fmt;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A simplicial complex at rest: for each dimension all simplices in lexicographic order in one flat array.
///
/// The i-th k-simplex has the position i in the k-chains: matrices and chain complexes use this order.
///
/// # Complexity
/// $4(k + 2)$ bytes a k-simplex.
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::simplicial::FrozenComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let complex = FrozenComplex::from_facets(&RaggedArray::from_lists([[2, 1, 0], [3, 2, 1]]))?;
/// assert_eq!(complex.f_vector(), [4, 5, 2]);
/// assert_eq!(complex.numbers(1, 2), [1, 2]);
/// assert_eq!(complex.index_of(&[1, 2]), Some(2));
/// assert_eq!(complex.chain_complex()?.euler_characteristic(), 1);
/// # Ok(()) }
/// ```
#[derive(Clone, Default, PartialEq, Eq)]
pub struct FrozenComplex {
    /// The k-simplices at position k; the last has one.
    levels: Vec<Level>,
}

/// The simplices of one dimension k.
#[derive(Clone, Default, PartialEq, Eq)]
struct Level {
    /// The vertices of all simplices, k + 1 each, in lexicographic order.
    tuples: Vec<u32>,
    /// The (k+1)-simplices that begin with simplex i are those from `child_starts[i]` to `child_starts[i + 1]`.
    child_starts: Vec<u32>,
}

impl FrozenComplex {
    /// The smallest complex with these simplices, given as lists of vertex numbers in any order. Lists may repeat and
    /// may be faces of others.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first list without a vertex or with a repeated one;
    /// [`ErrorKind::TooLarge`] if there would be more than 2^28 simplices.
    ///
    /// # Complexity
    /// $O(f \log g)$ for f pairs of a list and a face of it, of which at most g have a common part; in parallel.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let facets = RaggedArray::uniform(4, vec![0, 1, 2, 3, 1, 2, 3, 4])?;
    /// assert_eq!(FrozenComplex::from_facets(&facets)?.f_vector(), [5, 9, 7, 2]);
    /// # Ok(()) }
    /// ```
    pub fn from_facets(facets: &RaggedArray) -> Result<Self, Error> {
        let lists = Lists::new(facets.iter())?;
        let vertex_count = lists.names.len();
        let (starts, positions) = lists.occurrences();
        let total = AtomicUsize::new(0);
        let part_count = (positions.len() >> 14).clamp(1, 64);
        let steps = stage("growing faces from vertices", positions.len());
        let parts: Vec<Result<Part<'_>, Error>> = (0..part_count)
            .into_par_iter()
            .map(|part| {
                let bound = |part: usize| {
                    let position = (positions.len() * part / part_count) as u32;
                    if part == part_count {
                        vertex_count
                    } else {
                        starts[1..].partition_point(|&s| s <= position)
                    }
                };
                let ranks = bound(part)..bound(part + 1);
                let mut walk = FaceWalk::new(&lists, Part::new(ranks.clone(), lists.longest, &total));
                for (own, rank) in ranks.enumerate() {
                    let group = &positions[starts[rank] as usize..starts[rank + 1] as usize];
                    walk.grow_from_vertex(own as u32, group)?;
                    steps.advance(group.len());
                }
                let part = walk.into_growth();
                part.report()?;
                Ok(part)
            })
            .collect();
        let mut parts = parts.into_iter().collect::<Result<Vec<_>, Error>>()?;
        let mut levels = Vec::new();
        for k in 0..lists.longest {
            levels.push(Level::joined(parts.iter_mut().map(|part| std::mem::take(&mut part.levels[k]))));
        }
        if lists.names.last().is_some_and(|&last| last as usize >= vertex_count) {
            for level in &mut levels {
                level.tuples.par_iter_mut().for_each(|number| *number = lists.names[*number as usize]);
            }
        }
        Ok(Self { levels })
    }

    /// The complex of simplices that a construction has just listed, with all their faces.
    pub(crate) fn from_levels(levels: FrozenLevels) -> Self {
        let mut levels = levels.levels;
        for k in 0..levels.len() {
            let child_count = levels.get(k + 1).map_or(0, |level| level.tuples.len() / (k + 2));
            levels[k].child_starts.push(child_count as u32);
        }
        Self { levels }
    }

    /// The greatest dimension of a simplex; `None` for the empty complex.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_complexes::simplicial::FrozenComplex::default().dimension(), None);
    /// ```
    pub fn dimension(&self) -> Option<usize> {
        self.levels.len().checked_sub(1)
    }

    /// The number of simplices of this dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!((triangle.simplex_count(1), triangle.simplex_count(3)), (3, 0));
    /// # Ok(()) }
    /// ```
    pub fn simplex_count(&self, dimension: usize) -> usize {
        self.levels.get(dimension).map_or(0, |level| level.tuples.len() / (dimension + 1))
    }

    /// The numbers of simplices of dimension 0, 1, ...; empty for the empty complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        (0..self.levels.len()).map(|k| self.simplex_count(k)).collect()
    }

    /// The number of simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?.len(), 7);
    /// # Ok(()) }
    /// ```
    pub fn len(&self) -> usize {
        (0..self.levels.len()).map(|k| self.simplex_count(k)).sum()
    }

    /// Whether there is no simplex.
    ///
    /// # Examples
    /// ```
    /// assert!(coface_complexes::simplicial::FrozenComplex::default().is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        self.levels.is_empty()
    }

    /// The vertex numbers of the i-th simplex of a dimension, rising.
    ///
    /// # Panics
    /// If there is no such simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.numbers(1, 1), [0, 2]);
    /// # Ok(()) }
    /// ```
    pub fn numbers(&self, dimension: usize, i: usize) -> &[u32] {
        let width = dimension + 1;
        &self.levels[dimension].tuples[i * width..(i + 1) * width]
    }

    /// The vertex numbers of all simplices of a dimension, one simplex after the other in lexicographic order: simplex
    /// i has the items from $i(k+1)$ on. Empty beyond the dimension of the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.flat(1), [0, 1, 0, 2, 1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn flat(&self, dimension: usize) -> &[u32] {
        self.levels.get(dimension).map_or(&[], |level| &level.tuples)
    }

    /// The i-th simplex of a dimension.
    ///
    /// # Panics
    /// If there is no such simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::{FrozenComplex, Simplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.simplex(1, 2), Simplex::from([1, 2]));
    /// # Ok(()) }
    /// ```
    pub fn simplex(&self, dimension: usize, i: usize) -> Simplex {
        Simplex::from_sorted(self.numbers(dimension, i))
    }

    /// The position of the simplex with these vertex numbers among those of its dimension; `None` if it is not in the
    /// complex, or if the numbers do not rise.
    ///
    /// # Complexity
    /// $O(k \log n)$ for dimension k.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!((triangle.index_of(&[0, 2]), triangle.index_of(&[2, 3])), (Some(1), None));
    /// # Ok(()) }
    /// ```
    pub fn index_of(&self, numbers: &[u32]) -> Option<usize> {
        let (&first, rest) = numbers.split_first()?;
        let mut at = self.vertex_position(first)?;
        for (k, &vertex) in rest.iter().enumerate() {
            let children = self.children(k, at);
            let end = children.end;
            at = self.seek(k + 1, children, vertex);
            if at == end || self.last_number(k + 1, at) != vertex {
                return None;
            }
        }
        Some(at)
    }

    /// Whether the simplex is in the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::{FrozenComplex, Simplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert!(triangle.contains(&Simplex::from([0, 2])));
    /// # Ok(()) }
    /// ```
    pub fn contains(&self, simplex: &Simplex) -> bool {
        self.index_of(simplex.numbers()).is_some()
    }

    /// The facets of the i-th simplex of a dimension as positions in the dimension below, with their signs: the j-th
    /// leaves out the j-th vertex and has the sign $(-1)^j$. A vertex has none.
    ///
    /// # Panics
    /// If there is no such simplex.
    ///
    /// # Complexity
    /// $O(k^2 \log n)$; for all simplices at once take the boundary matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{RaggedArray, Sign};
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?;
    /// let facets: Vec<(Sign, usize)> = triangle.facets(2, 0).collect();
    /// assert_eq!(facets, [(Sign::Plus, 2), (Sign::Minus, 1), (Sign::Plus, 0)]);
    /// # Ok(()) }
    /// ```
    pub fn facets(&self, dimension: usize, i: usize) -> impl Iterator<Item = (Sign, usize)> + '_ {
        let numbers = self.numbers(dimension, i);
        let count = if dimension == 0 { 0 } else { numbers.len() };
        let mut facet = Vec::with_capacity(count);
        (0..count).map(move |j| {
            facet.clear();
            facet.extend_from_slice(&numbers[..j]);
            facet.extend_from_slice(&numbers[j + 1..]);
            (
                Sign::power_of_minus_one(j),
                self.index_of(&facet).expect("a complex has all faces of its simplices"),
            )
        })
    }

    /// The same complex in the form that can be changed.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.thaw().freeze(), triangle);
    /// # Ok(()) }
    /// ```
    pub fn thaw(&self) -> SimplicialComplex {
        let mut tree = Tree::default();
        if let Some(vertices) = self.levels.first() {
            let count = vertices.tuples.len();
            tree.nodes.reserve_exact(self.len());
            tree.add_children(ROOT, 0, 0..count as u32);
            for vertex in 0..count {
                self.thaw_below(&mut tree, vertex as u32, 0, vertex);
            }
            if vertices.tuples[count - 1] as usize >= count {
                for node in &mut tree.nodes {
                    node.vertex = vertices.tuples[node.vertex as usize];
                }
            }
        }
        SimplicialComplex::from_tree(tree)
    }

    fn thaw_below(&self, tree: &mut Tree, parent: u32, dimension: usize, i: usize) {
        let children = self.children(dimension, i);
        if children.is_empty() {
            return;
        }
        let ranks = children.clone().map(|child| {
            let number = self.last_number(dimension + 1, child);
            self.vertex_position(number).expect("a complex has all vertices of its simplices") as u32
        });
        let first = tree.add_children(parent, dimension + 1, ranks);
        for (node, child) in (first..).zip(children) {
            self.thaw_below(tree, node, dimension + 1, child);
        }
    }

    /// Verifies the invariants: simplices and their vertices rise, and every face of every simplex is there.
    ///
    /// # Errors
    /// [`ErrorKind::NotAComplex`] naming the first broken one.
    ///
    /// # Examples
    /// ```
    /// coface_complexes::simplicial::FrozenComplex::default().check()?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn check(&self) -> Result<(), Error> {
        let broken = |message: String| Err(Error::new(ErrorKind::NotAComplex, message));
        for k in 0..self.levels.len() {
            for i in 0..self.simplex_count(k) {
                let numbers = self.numbers(k, i);
                if !numbers.is_sorted_by(|a, b| a < b) || (i > 0 && self.numbers(k, i - 1) >= numbers) {
                    return broken(format!("the simplices of dimension {k} do not rise at position {i}"));
                }
                let simplex = Simplex::from_sorted(numbers);
                if let Some((_, facet)) = simplex.facets().find(|(_, facet)| !self.contains(facet)) {
                    return broken(format!("the face {facet} of {simplex} is missing"));
                }
                if self.children(k, i).any(|child| self.numbers(k + 1, child)[..=k] != *numbers) {
                    return broken(format!("the simplices that begin with {simplex} are not listed right"));
                }
            }
        }
        Ok(())
    }

    /// The position of a vertex among the vertices.
    pub(super) fn vertex_position(&self, number: u32) -> Option<usize> {
        let vertices = &self.levels.first()?.tuples;
        // Vertices are often numbered without gaps; then the place is known.
        let guess = number.checked_sub(*vertices.first()?)? as usize;
        match vertices.get(guess) {
            Some(&same) if same == number => Some(guess),
            _ => vertices.binary_search(&number).ok(),
        }
    }

    /// The positions of the simplices of the next dimension that begin with this one.
    pub(super) fn children(&self, dimension: usize, i: usize) -> Range<usize> {
        let starts = &self.levels[dimension].child_starts;
        starts[i] as usize..starts[i + 1] as usize
    }

    /// The last vertex of a simplex.
    pub(super) fn last_number(&self, dimension: usize, i: usize) -> u32 {
        self.levels[dimension].tuples[i * (dimension + 1) + dimension]
    }

    /// The first position of a range of siblings whose last vertex is `vertex` or greater; its end if there is none.
    pub(super) fn seek(&self, dimension: usize, siblings: Range<usize>, vertex: u32) -> usize {
        // Ranges are short in meshes and small complexes, and what is sought is near when many are sought in turn.
        let near = siblings.end.min(siblings.start + 8);
        for i in siblings.start..near {
            if self.last_number(dimension, i) >= vertex {
                return i;
            }
        }
        let (mut low, mut high) = (near, siblings.end);
        while low < high {
            let middle = low.midpoint(high);
            if self.last_number(dimension, middle) < vertex {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        low
    }

    /// The positions of the children of consecutive simplices, so that work on them can be shared out.
    pub(super) fn child_starts(&self, dimension: usize) -> &[u32] {
        &self.levels[dimension].child_starts
    }
}

impl SimplicialComplex {
    /// The same complex in the compact form for reading.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let frozen = SimplicialComplex::from_facets([[3, 4, 6]])?.freeze();
    /// assert_eq!(frozen.numbers(1, 0), [3, 4]);
    /// # Ok(()) }
    /// ```
    pub fn freeze(&self) -> FrozenComplex {
        let level = |(k, &count): (usize, &usize)| Level {
            tuples: Vec::with_capacity(count * (k + 1)),
            child_starts: Vec::with_capacity(count + 1),
        };
        let mut levels = FrozenLevels { levels: self.f_vector().iter().enumerate().map(level).collect() };
        let mut walk = Walk::new(self.tree(), usize::MAX);
        while walk.advance() {
            levels.push(walk.path());
        }
        FrozenComplex::from_levels(levels)
    }
}

/// Simplices that are listed one after the other in lexicographic order, each with its faces before it or after it.
#[derive(Default)]
pub(crate) struct FrozenLevels {
    /// Without the ends of the last children.
    levels: Vec<Level>,
}

impl FrozenLevels {
    /// Adds a simplex by its vertices, which rise.
    pub(crate) fn push(&mut self, simplex: &[u32]) {
        let k = simplex.len() - 1;
        if self.levels.len() == k {
            self.levels.push(Level::default());
        }
        let child_start = self.levels.get(k + 1).map_or(0, |level| level.child_starts.len());
        self.levels[k].tuples.extend_from_slice(simplex);
        self.levels[k].child_starts.push(child_start as u32);
    }
}

impl fmt::Debug for FrozenComplex {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let simplices =
            (0..self.levels.len()).flat_map(|k| (0..self.simplex_count(k)).map(move |i| self.simplex(k, i)));
        f.debug_set().entries(simplices).finish()
    }
}

impl Level {
    /// Levels of parts one after the other; their child starts are still child counts.
    fn joined(parts: impl Iterator<Item = Self>) -> Self {
        let mut all = Self::default();
        for part in parts {
            if all.tuples.is_empty() {
                all = part;
            } else {
                all.tuples.extend_from_slice(&part.tuples);
                all.child_starts.extend_from_slice(&part.child_starts);
            }
        }
        let mut total = 0;
        for start in &mut all.child_starts {
            let count = std::mem::replace(start, total);
            total += count;
        }
        all.child_starts.push(total);
        all
    }
}

/// How many simplices a part makes before it tells the others.
const REPORT: usize = 1 << 16;

/// The simplices whose least vertices are in one range.
struct Part<'a> {
    /// As in the complex, but with ranks in place of vertices and child counts in place of child starts.
    levels: Vec<Level>,
    /// How many simplices all parts have reported.
    total: &'a AtomicUsize,
    not_reported: usize,
}

impl<'a> Part<'a> {
    fn new(ranks: Range<usize>, level_count: usize, total: &'a AtomicUsize) -> Self {
        let mut levels = vec![Level::default(); level_count];
        let not_reported = ranks.len();
        if let Some(vertices) = levels.first_mut() {
            vertices.child_starts = vec![0; ranks.len()];
            vertices.tuples = ranks.map(|rank| rank as u32).collect();
        }
        Self { levels, total, not_reported }
    }

    /// # Errors
    /// [`ErrorKind::TooLarge`] if all parts together have too many simplices.
    fn report(&self) -> Result<(), Error> {
        let before = self.total.fetch_add(self.not_reported, Ordering::Relaxed);
        if before + self.not_reported > CALL_LIMIT { Err(too_many_faces()) } else { Ok(()) }
    }
}

impl Growth for Part<'_> {
    fn add_children(
        &mut self,
        parent: u32,
        depth: usize,
        ranks: impl ExactSizeIterator<Item = u32> + Clone,
    ) -> u32 {
        let (below, above) = self.levels.split_at_mut(depth);
        let (parents, level) = (&mut below[depth - 1], &mut above[0]);
        let count = ranks.len();
        let first = level.child_starts.len();
        parents.child_starts[parent as usize] = count as u32;
        level.child_starts.resize(first + count, 0);
        let common = &parents.tuples[parent as usize * depth..(parent as usize + 1) * depth];
        for rank in ranks {
            level.tuples.extend_from_slice(common);
            level.tuples.push(rank);
        }
        first as u32
    }

    fn reserve(&mut self, more: usize) -> Result<(), Error> {
        self.not_reported += more;
        if self.not_reported >= REPORT {
            self.report()?;
            self.not_reported = 0;
        }
        Ok(())
    }
}
