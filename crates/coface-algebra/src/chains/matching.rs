//! Acyclic matchings on unit incidences: which cells cancel in pairs.
//!
//! A pair is a cell b of degree k and a face a of degree k - 1 whose incidence in b is 1 or -1. A matching is acyclic
//! when its pairs can be put in an order in which each a occurs in the boundary of no later b but its own. Cancelling
//! all pairs then leaves a chain complex on the unmatched, **critical** cells with the same integral homology.

use crate::CellId;
use crate::chains::ChainComplex;
use crate::combinatorics::UnionFind;
use crate::ids::narrow;
use crate::matrices::{Entry, SparseMatrix};
use crate::progress::stage;
use std::sync::OnceLock;

/// A pair of a cell and one of its faces that cancel, with unit incidence between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MatchedPair {
    pub(super) face: u32,
    pub(super) cell: u32,
}

impl MatchedPair {
    /// The face, of degree k - 1.
    ///
    /// # Examples
    /// See [`AcyclicMatching::pairs`].
    pub fn face(self) -> CellId {
        CellId::from_u32(self.face)
    }

    /// The cell, of degree k.
    ///
    /// # Examples
    /// See [`AcyclicMatching::pairs`].
    pub fn cell(self) -> CellId {
        CellId::from_u32(self.cell)
    }
}

/// An acyclic matching of the cells of a chain complex on unit incidences.
///
/// Degree by degree from the top, a cell is removed together with a face that no other remaining cell has; where no
/// such face is left, one cell is set aside as critical. Between edges and vertices a spanning forest is the best
/// matching there is, and is taken.
///
/// # Complexity
/// Linear in the entries of the boundary matrices, but for the nearly constant factor of union-find; 8 bytes a cell
/// beside the complex. No coboundary is built: for each face the number of remaining cells on it and the exclusive-or
/// of their ids are kept, which is the id of the last one when one is left.
///
/// # References
/// R. Forman, *Morse theory for cell complexes* (1998); E. Skoeldberg, *Morse theory from an algebraic viewpoint*
/// (2006); B. Benedetti, F. H. Lutz, *Random discrete Morse theory and a new library of triangulations* (2014) for the
/// strategy.
///
/// # Examples
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::{AcyclicMatching, ChainComplex};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// // Two vertices joined by two edges: a circle.
/// let boundary = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
/// let circle = ChainComplex::new(vec![boundary])?;
/// let matching = AcyclicMatching::new(&circle);
/// assert_eq!(matching.critical_cells(0), [0]);
/// assert_eq!(matching.critical_cells(1), [1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct AcyclicMatching {
    /// The critical cells of each degree, rising.
    critical: Vec<Vec<u32>>,
    /// The pairs of each degree k (faces of degree k - 1), at position k - 1, in the order of elimination.
    pairs: Vec<Pairs>,
}

#[derive(Clone, Debug)]
enum Pairs {
    Listed(Vec<MatchedPair>),
    /// The edges of a spanning forest of a graph; the pairs are only listed when asked for.
    Forest(Vec<u32>, OnceLock<Vec<MatchedPair>>),
}

/// Classes of cells such that pairs are only taken within one.
///
/// The class of a cell must not change the choices within another, so that every part with a whole class finds the same
/// pairs in it: a class is gone through by rising ids, as if it were alone.
#[derive(Clone, Copy)]
pub(super) struct CellClasses<'a> {
    /// For each degree the class of each cell.
    pub(super) of_cell: &'a [Vec<u32>],
    /// For each class its rank. A face has at least the rank of the cell, and exactly that only in the same class.
    pub(super) ranks: &'a [u32],
}

/// Which incidences of a degree count.
#[derive(Clone, Copy)]
enum Within<'a> {
    /// All: there is one class.
    Whole,
    /// Those of a face and a cell of one class: the classes of the faces, those of the cells, and how many classes
    /// there are.
    Classes(&'a [u32], &'a [u32], usize),
}

impl Within<'_> {
    #[inline]
    fn counts(self, face: u32, cell: u32) -> bool {
        match self {
            Self::Whole => true,
            Self::Classes(of_faces, of_cells, _) => of_faces[face as usize] == of_cells[cell as usize],
        }
    }

    fn class_of(self, cell: u32) -> usize {
        match self {
            Self::Whole => 0,
            Self::Classes(_, of_cells, _) => of_cells[cell as usize] as usize,
        }
    }

    fn class_count(self) -> usize {
        match self {
            Self::Whole => 1,
            Self::Classes(_, _, count) => count,
        }
    }
}

impl AcyclicMatching {
    /// Matches the cells of a complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{AcyclicMatching, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // An edge collapses to a vertex.
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// let matching = AcyclicMatching::new(&edge);
    /// assert_eq!((matching.critical_cells(0), matching.critical_cells(1)), (&[0][..], &[][..]));
    /// # Ok(()) }
    /// ```
    pub fn new<E: Entry>(complex: &ChainComplex<E>) -> Self {
        Self::of(complex, None)
    }

    /// Matches the cells of a complex, each within its class.
    ///
    /// Pairs come by rising rank: so faces, which are of higher rank where they are of another class, are eliminated
    /// after the cells that have them.
    pub(super) fn within<E: Entry>(complex: &ChainComplex<E>, classes: CellClasses<'_>) -> Self {
        let mut matching = Self::of(complex, Some(classes));
        for degree in 1..complex.degree_count() {
            let mut pairs = matching.pairs(complex, degree).to_vec();
            pairs.sort_by_key(|pair| classes.ranks[classes.of_cell[degree][pair.cell as usize] as usize]);
            matching.pairs[degree - 1] = Pairs::Listed(pairs);
        }
        matching
    }

    fn of<E: Entry>(complex: &ChainComplex<E>, classes: Option<CellClasses<'_>>) -> Self {
        let degree_count = complex.degree_count();
        let mut critical = vec![Vec::new(); degree_count];
        let mut pairs = Vec::new();
        // The cells of the degree at hand that are faces in no pair of the degree above.
        let mut remaining = Remaining::all(complex.cell_count(degree_count.saturating_sub(1)));
        for degree in (1..degree_count).rev() {
            let matrix = complex.boundary_matrix(degree).expect("each degree below the count has its matrix");
            let within = classes.map_or(Within::Whole, |classes| {
                let of_cell = classes.of_cell;
                Within::Classes(&of_cell[degree - 1], &of_cell[degree], classes.ranks.len())
            });
            let (below, level) = if degree == 1 {
                span_or_collapse(matrix, &remaining, within, &mut critical[1])
            } else {
                let (below, pairs) = collapse(matrix, &remaining, within, &mut critical[degree]);
                (below, Pairs::Listed(pairs))
            };
            pairs.push(level);
            remaining = below;
        }
        if let Some(points) = critical.first_mut() {
            *points = remaining.iter().collect();
        }
        pairs.reverse();
        Self { critical, pairs }
    }

    /// The critical cells of this degree, rising: those in no pair.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{AcyclicMatching, ChainComplex};
    /// assert_eq!(AcyclicMatching::new(&ChainComplex::of_points(2)).critical_cells(0), [0, 1]);
    /// ```
    pub fn critical_cells(&self, degree: usize) -> &[u32] {
        self.critical.get(degree).map_or(&[], Vec::as_slice)
    }

    /// The pairs of cells of this degree with faces of `degree - 1`, in the order of elimination: the face of a pair is
    /// in the boundary of no cell of a later pair.
    ///
    /// `complex` must be the one that was matched.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, RaggedArray};
    /// use coface_algebra::chains::{AcyclicMatching, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// let matching = AcyclicMatching::new(&edge);
    /// let pair = matching.pairs(&edge, 1)[0];
    /// assert_eq!((pair.face(), pair.cell()), (CellId::new(1), CellId::new(0)));
    /// # Ok(()) }
    /// ```
    pub fn pairs<E: Entry>(&self, complex: &ChainComplex<E>, degree: usize) -> &[MatchedPair] {
        match degree.checked_sub(1).and_then(|below| self.pairs.get(below)) {
            None => &[],
            Some(Pairs::Listed(pairs)) => pairs,
            Some(Pairs::Forest(edges, pairs)) => pairs.get_or_init(|| {
                let matrix =
                    complex.boundary_matrix(1).expect("a forest was found in the matrix of degree 1");
                root_forest(matrix, edges, Within::Whole, self.critical[0].clone())
            }),
        }
    }

    /// Whether the boundary of every critical cell of this degree is known to be zero without computing it: so it is
    /// for edges when each component of the graph keeps one critical vertex.
    pub(crate) fn has_zero_boundary(&self, degree: usize) -> bool {
        matches!(degree.checked_sub(1).and_then(|below| self.pairs.get(below)), Some(Pairs::Forest(..)))
    }
}

/// A set of cells of one degree as bits: those that are not matched from above.
struct Remaining {
    words: Vec<u64>,
    count: usize,
}

impl Remaining {
    fn all(count: usize) -> Self {
        Self { words: vec![u64::MAX; count.div_ceil(64)], count }
    }

    fn none(count: usize) -> Self {
        Self { words: vec![0; count.div_ceil(64)], count }
    }

    fn contains(&self, cell: u32) -> bool {
        self.words[cell as usize / 64] & (1 << (cell % 64)) != 0
    }

    fn insert(&mut self, cell: u32) {
        self.words[cell as usize / 64] |= 1 << (cell % 64);
    }

    fn remove(&mut self, cell: u32) {
        self.words[cell as usize / 64] &= !(1 << (cell % 64));
    }

    fn iter(&self) -> impl Iterator<Item = u32> + '_ {
        self.words.iter().enumerate().flat_map(move |(at, &word)| {
            let mut bits = word;
            std::iter::from_fn(move || {
                let cell = at * 64 + bits.trailing_zeros() as usize;
                (bits != 0).then(|| {
                    bits &= bits - 1;
                    cell
                })
            })
            .take_while(|&cell| cell < self.count)
            .map(narrow)
        })
    }
}

/// What the remaining edges make of the vertices.
///
/// Where the edges of a class make a graph, a spanning forest is taken, which no collapse is better than; elsewhere
/// they collapse. An edge whose other end is in another class is an edge to a vertex outside, one for each class; trees
/// that reach it are rooted there.
fn span_or_collapse<E: Entry>(
    matrix: &SparseMatrix<E>,
    remaining: &Remaining,
    within: Within<'_>,
    critical: &mut Vec<u32>,
) -> (Remaining, Pairs) {
    let mut is_graph = vec![true; within.class_count()];
    let mut is_closed = true;
    for edge in remaining.iter() {
        let class = within.class_of(edge);
        match end_of(matrix, edge, within) {
            End::Other => is_graph[class] = false,
            End::Outside(_) => is_closed = false,
            End::None | End::Both(..) => {}
        }
    }
    let mut to_collapse = Remaining::none(remaining.count);
    if is_graph.contains(&false) {
        remaining
            .iter()
            .filter(|&edge| !is_graph[within.class_of(edge)])
            .for_each(|edge| to_collapse.insert(edge));
    }
    let vertex_count = matrix.row_count();
    let mut trees = UnionFind::new(vertex_count + within.class_count());
    let mut forest = Vec::with_capacity(vertex_count);
    let steps = stage("spanning vertices", remaining.iter().count());
    for edge in steps.each(remaining.iter()).filter(|&edge| !to_collapse.contains(edge)) {
        let is_between_trees = match end_of(matrix, edge, within) {
            End::Both(a, b) => trees.unite(a, b),
            End::Outside(a) => trees.unite(a, narrow(vertex_count + within.class_of(edge))),
            End::None | End::Other => false,
        };
        if is_between_trees { &mut forest } else { &mut *critical }.push(edge);
    }
    let has_collapses = is_graph.contains(&false);
    let (free, mut collapsed) = if has_collapses {
        collapse(matrix, &to_collapse, within, critical)
    } else {
        (Remaining::all(vertex_count), Vec::new())
    };
    critical.sort_unstable();
    // The first vertex of each tree stays; a tree with the vertex outside loses all.
    let mut is_rooted = vec![false; vertex_count + within.class_count()];
    let outside = narrow(vertex_count)..narrow(vertex_count + within.class_count());
    outside.for_each(|vertex| is_rooted[trees.find(vertex) as usize] = true);
    let mut missing = trees.class_count() - within.class_count();
    let mut roots = Remaining::none(vertex_count);
    let mut vertices = free.iter();
    while missing > 0
        && let Some(vertex) = vertices.next()
    {
        let is_rooted = &mut is_rooted[trees.find(vertex) as usize];
        if !std::mem::replace(is_rooted, true) {
            roots.insert(vertex);
            missing -= 1;
        }
    }
    if is_closed && !has_collapses && matches!(within, Within::Whole) {
        return (roots, Pairs::Forest(forest, OnceLock::new()));
    }
    collapsed.extend(root_forest(matrix, &forest, within, roots.iter().collect()));
    (roots, Pairs::Listed(collapsed))
}

/// The ends of an edge within its class.
enum End {
    /// A loop, or an edge all of whose ends are elsewhere.
    None,
    /// This vertex and one outside.
    Outside(u32),
    Both(u32, u32),
    /// It is no edge of a graph.
    Other,
}

fn end_of<E: Entry>(matrix: &SparseMatrix<E>, edge: u32, within: Within<'_>) -> End {
    let mut ends = matrix.column(edge as usize).terms().filter(|&(row, _)| within.counts(narrow(row), edge));
    match (ends.next(), ends.next(), ends.next()) {
        (None, ..) => End::None,
        (Some((a, x)), None, _) if x.is_unit() => End::Outside(narrow(a)),
        (Some((a, x)), Some((b, y)), None)
            if x.is_unit() && y.is_unit() && x.is_negative() != y.is_negative() =>
        {
            End::Both(narrow(a), narrow(b))
        }
        _ => End::Other,
    }
}

/// Roots a forest at the given vertices and those outside, and pairs each other vertex with the edge towards its root,
/// leaves first.
fn root_forest<E: Entry>(
    matrix: &SparseMatrix<E>,
    forest: &[u32],
    within: Within<'_>,
    roots: Vec<u32>,
) -> Vec<MatchedPair> {
    let ends = |edge: u32| {
        let rows = matrix.column(edge as usize).rows();
        rows.iter().copied().filter(move |&vertex| within.counts(vertex, edge))
    };
    let mut starts = vec![0u32; matrix.row_count() + 1];
    for &edge in forest {
        ends(edge).for_each(|vertex| starts[vertex as usize + 1] += 1);
    }
    for i in 1..starts.len() {
        starts[i] += starts[i - 1];
    }
    let mut next = starts.clone();
    let mut edges_at = vec![0; starts[matrix.row_count()] as usize];
    let mut seen = vec![false; matrix.row_count()];
    let mut queue = roots;
    for &root in &queue {
        seen[root as usize] = true;
    }
    let mut pairs = Vec::with_capacity(forest.len());
    for &edge in forest {
        let (mut count, mut last) = (0, 0);
        for vertex in ends(edge) {
            edges_at[next[vertex as usize] as usize] = edge;
            next[vertex as usize] += 1;
            (count, last) = (count + 1, vertex);
        }
        if count == 1 {
            seen[last as usize] = true;
            queue.push(last);
            pairs.push(MatchedPair { face: last, cell: edge });
        }
    }
    let mut at = 0;
    let steps = stage("rooting trees", matrix.row_count());
    while let Some(&vertex) = queue.get(at) {
        steps.pass(at);
        at += 1;
        for &edge in &edges_at[starts[vertex as usize] as usize..starts[vertex as usize + 1] as usize] {
            for other in ends(edge) {
                if !seen[other as usize] {
                    seen[other as usize] = true;
                    queue.push(other);
                    pairs.push(MatchedPair { face: other, cell: edge });
                }
            }
        }
    }
    pairs.reverse();
    pairs
}

/// How many remaining cells have a face, and the exclusive-or of their ids.
#[derive(Clone, Copy, Default)]
struct Cofaces {
    count: u32,
    mixed: u32,
}

/// Removes remaining cells together with a face that no other remaining cell has, as long as there is one; then sets
/// the first remaining cell aside as critical, and so on. Gives the faces that are in no pair.
fn collapse<E: Entry>(
    matrix: &SparseMatrix<E>,
    remaining: &Remaining,
    within: Within<'_>,
    critical: &mut Vec<u32>,
) -> (Remaining, Vec<MatchedPair>) {
    let faces_of = |cell: u32| {
        let rows = matrix.column(cell as usize).rows();
        rows.iter().copied().filter(move |&face| within.counts(face, cell))
    };
    let mut cofaces = vec![Cofaces::default(); matrix.row_count()];
    let steps = stage("matching cells", 2 * remaining.iter().count());
    for cell in steps.each(remaining.iter()) {
        for face in faces_of(cell) {
            let cofaces = &mut cofaces[face as usize];
            cofaces.count += 1;
            cofaces.mixed ^= cell;
        }
    }
    // Nearly always all entries are units, and then no incidence has to be looked up.
    let has_units_only = matrix.entries().iter().all(E::is_unit);
    // First in, first out: breadth-first collapses have short gradient paths.
    let mut free: Vec<u32> =
        (0..narrow(matrix.row_count())).filter(|&face| cofaces[face as usize].count == 1).collect();
    let mut at = 0;
    let mut gone = Remaining::none(remaining.count);
    let mut faces = Remaining::all(matrix.row_count());
    let mut pairs = Vec::with_capacity(matrix.row_count().min(matrix.column_count()));
    let mut candidates = remaining.iter();
    let mut taken = 0;
    loop {
        let cell = if let Some(&face) = free.get(at) {
            at += 1;
            let Cofaces { count, mixed: cell } = cofaces[face as usize];
            // Another face may have taken the cell away; an incidence of 2 or more cannot cancel over the integers.
            if count != 1 || !(has_units_only || matrix.entry(face as usize, cell as usize).is_unit()) {
                continue;
            }
            pairs.push(MatchedPair { face, cell });
            faces.remove(face);
            cell
        } else {
            free.clear();
            at = 0;
            let Some(cell) = candidates.find(|&cell| !gone.contains(cell)) else {
                break;
            };
            critical.push(cell);
            cell
        };
        gone.insert(cell);
        taken += 1;
        steps.pass(taken);
        for face in faces_of(cell) {
            let cofaces = &mut cofaces[face as usize];
            cofaces.count -= 1;
            cofaces.mixed ^= cell;
            if cofaces.count == 1 {
                free.push(face);
            }
        }
    }
    (faces, pairs)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::random_complexes;
    use proptest::prelude::*;

    proptest! {
        /// Invariant: pairs have unit incidence, no cell is used twice, and each face of a pair is in the boundary of
        /// no cell of a later pair; cells and criticals add up.
        #[test]
        fn matchings_are_acyclic_on_unit_incidences(complex in random_complexes()) {
            let matching = AcyclicMatching::new(&complex);
            let mut used: Vec<Vec<bool>> = complex.f_vector().iter().map(|&n| vec![false; n]).collect();
            for degree in 0..complex.degree_count() {
                for &cell in matching.critical_cells(degree) {
                    prop_assert!(!std::mem::replace(&mut used[degree][cell as usize], true));
                }
                let pairs = matching.pairs(&complex, degree);
                for (at, pair) in pairs.iter().enumerate() {
                    let matrix = complex.boundary_matrix(degree).unwrap();
                    prop_assert!(!std::mem::replace(&mut used[degree][pair.cell as usize], true));
                    prop_assert!(!std::mem::replace(&mut used[degree - 1][pair.face as usize], true));
                    prop_assert_eq!(matrix.entry(pair.face as usize, pair.cell as usize).abs(), 1);
                    for later in &pairs[at + 1..] {
                        prop_assert_eq!(matrix.entry(pair.face as usize, later.cell as usize), 0);
                    }
                }
            }
            prop_assert!(used.iter().flatten().all(|&used| used));
        }
    }

    #[test]
    fn complexes_without_cells_have_nothing_to_match() {
        assert_eq!(AcyclicMatching::new(&ChainComplex::of_points(0)).critical_cells(0), [0u32; 0]);
        assert_eq!(AcyclicMatching::new(&ChainComplex::of_points(3)).critical_cells(0), [0, 1, 2]);
    }

    #[test]
    fn remaining_sets_end_at_their_count() {
        let mut set = Remaining::all(70);
        set.remove(0);
        set.remove(69);
        assert_eq!(set.iter().collect::<Vec<_>>(), (1..69).collect::<Vec<_>>());
        assert_eq!(Remaining::all(0).iter().count(), 0);
    }
}
