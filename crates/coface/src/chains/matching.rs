//! Acyclic matchings on unit incidences: which cells cancel in pairs.
//!
//! A pair is a cell b of degree k and a face a of degree k - 1 whose incidence in b is 1 or -1. A matching is acyclic
//! when its pairs can be put in an order in which each a occurs in the boundary of no later b but its own. Cancelling
//! all pairs then leaves a chain complex on the unmatched, **critical** cells with the same integral homology.

use crate::algebra::{SparseMatrix, UnionFind};
use crate::chains::ChainComplex;
use crate::progress::stage;
use std::sync::OnceLock;

/// A pair of a cell and one of its faces that cancel, with unit incidence between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MatchedPair {
    /// The face, of degree k - 1.
    pub face: u32,
    /// The cell, of degree k.
    pub cell: u32,
}

/// An acyclic matching of the cells of a chain complex on unit incidences.
///
/// Degree by degree from the top, a cell is taken away together with a face that no other remaining cell has; where no
/// such face is left, one cell is set aside as critical. Between edges and vertices a spanning forest is the best
/// matching there is, and is taken.
///
/// # Complexity
/// Linear in the entries of the boundary matrices, but for the nearly constant factor of union-find; 8 bytes a cell
/// beside the complex. No coboundary is built: for each face the number of remaining cells on it and the exclusive-or
/// of their ids tell which one is left when there is just one.
///
/// # References
/// R. Forman, *Morse theory for cell complexes* (1998); E. Skoeldberg, *Morse theory from an algebraic viewpoint* (2006);
/// B. Benedetti, F. H. Lutz, *Random discrete Morse theory and a new library of triangulations* (2014) for the strategy.
///
/// # Examples
/// ```
/// use coface::algebra::SparseMatrix;
/// use coface::chains::{AcyclicMatching, ChainComplex};
/// # fn main() -> Result<(), coface::Error> {
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
    /// The edges of a spanning forest; the pairs are only listed when asked for.
    Forest(Vec<u32>, OnceLock<Vec<MatchedPair>>),
}

impl AcyclicMatching {
    /// Matches the cells of a complex.
    pub fn new(complex: &ChainComplex) -> Self {
        let degree_count = complex.degree_count();
        let mut critical = vec![Vec::new(); degree_count];
        let mut pairs = Vec::new();
        // The cells of the degree at hand that are faces in no pair of the degree above.
        let mut remaining = Remaining::all(complex.cell_count(degree_count.saturating_sub(1)));
        for degree in (1..degree_count).rev() {
            let matrix = complex.boundary_matrix(degree).expect("each degree below the count has its matrix");
            let forest = if degree == 1 { span(matrix, &remaining, &mut critical[1]) } else { None };
            let (below, level) =
                forest.unwrap_or_else(|| collapse(matrix, &remaining, &mut critical[degree]));
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
    pub fn critical_cells(&self, degree: usize) -> &[u32] {
        self.critical.get(degree).map_or(&[], Vec::as_slice)
    }

    /// The pairs of cells of this degree with faces of `degree - 1`, in the order of elimination: the face of a pair is
    /// in the boundary of no cell of a later pair.
    ///
    /// `complex` must be the one that was matched.
    pub fn pairs(&self, complex: &ChainComplex, degree: usize) -> &[MatchedPair] {
        match degree.checked_sub(1).and_then(|below| self.pairs.get(below)) {
            None => &[],
            Some(Pairs::Listed(pairs)) => pairs,
            Some(Pairs::Forest(edges, pairs)) => pairs.get_or_init(|| {
                let matrix =
                    complex.boundary_matrix(1).expect("a forest was found in the matrix of degree 1");
                root_forest(matrix, edges, &self.critical[0])
            }),
        }
    }

    /// Whether the boundary of every critical cell of this degree is known to be zero without looking at it: so it is
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
            .map(|cell| cell as u32)
        })
    }
}

/// Takes a spanning forest of the graph of the remaining edges. Gives the vertices that stay: the first of each tree.
/// `None` if they are not the edges of a graph, where each column is empty or one 1 and one -1.
fn span(matrix: &SparseMatrix, remaining: &Remaining, critical: &mut Vec<u32>) -> Option<(Remaining, Pairs)> {
    let mut trees = UnionFind::new(matrix.row_count());
    let mut forest = Vec::with_capacity(matrix.row_count());
    let steps = stage("spanning vertices", remaining.iter().count());
    for edge in steps.each(remaining.iter()) {
        let column = matrix.column(edge as usize);
        match (column.rows(), column.entries()) {
            (&[a, b], [-1, 1] | [1, -1]) if trees.unite(a, b) => forest.push(edge),
            (_, [] | [-1, 1] | [1, -1]) => critical.push(edge),
            _ => {
                critical.clear();
                return None;
            }
        }
    }
    let mut is_rooted = vec![false; matrix.row_count()];
    let mut roots = Remaining::none(matrix.row_count());
    let mut missing = trees.class_count();
    let mut vertices = 0..matrix.row_count() as u32;
    while missing > 0
        && let Some(vertex) = vertices.next()
    {
        let is_rooted = &mut is_rooted[trees.find(vertex) as usize];
        if !std::mem::replace(is_rooted, true) {
            roots.insert(vertex);
            missing -= 1;
        }
    }
    Some((roots, Pairs::Forest(forest, OnceLock::new())))
}

/// Roots a forest at the given vertices and pairs each other vertex with the edge towards its root, leaves first.
fn root_forest(matrix: &SparseMatrix, forest: &[u32], roots: &[u32]) -> Vec<MatchedPair> {
    let mut starts = vec![0u32; matrix.row_count() + 1];
    for &edge in forest {
        for &vertex in matrix.column(edge as usize).rows() {
            starts[vertex as usize + 1] += 1;
        }
    }
    for i in 1..starts.len() {
        starts[i] += starts[i - 1];
    }
    let mut next = starts.clone();
    let mut edges_at = vec![0; 2 * forest.len()];
    for &edge in forest {
        for &vertex in matrix.column(edge as usize).rows() {
            edges_at[next[vertex as usize] as usize] = edge;
            next[vertex as usize] += 1;
        }
    }
    let mut seen = vec![false; matrix.row_count()];
    let mut queue = roots.to_vec();
    for &root in roots {
        seen[root as usize] = true;
    }
    let mut pairs = Vec::with_capacity(forest.len());
    let mut at = 0;
    let steps = stage("rooting trees", matrix.row_count());
    while let Some(&vertex) = queue.get(at) {
        steps.pass(at);
        at += 1;
        for &edge in &edges_at[starts[vertex as usize] as usize..starts[vertex as usize + 1] as usize] {
            for &other in matrix.column(edge as usize).rows() {
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

/// Takes remaining cells away with a face that no other remaining cell has, as long as there is one; then sets the
/// first remaining cell aside as critical, and so on. Gives the faces that are in no pair.
fn collapse(matrix: &SparseMatrix, remaining: &Remaining, critical: &mut Vec<u32>) -> (Remaining, Pairs) {
    let mut cofaces = vec![Cofaces::default(); matrix.row_count()];
    let steps = stage("matching cells", 2 * remaining.iter().count());
    for cell in steps.each(remaining.iter()) {
        for &face in matrix.column(cell as usize).rows() {
            let cofaces = &mut cofaces[face as usize];
            cofaces.count += 1;
            cofaces.mixed ^= cell;
        }
    }
    // Nearly always all entries are units, and then no incidence has to be looked up.
    let has_units_only = matrix.entries().iter().all(|entry| entry.unsigned_abs() == 1);
    // First in, first out: breadth-first collapses have short gradient paths.
    let mut free: Vec<u32> =
        (0..matrix.row_count() as u32).filter(|&face| cofaces[face as usize].count == 1).collect();
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
            if count != 1
                || !(has_units_only || matrix.entry(face as usize, cell as usize).unsigned_abs() == 1)
            {
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
        for &face in matrix.column(cell as usize).rows() {
            let cofaces = &mut cofaces[face as usize];
            cofaces.count -= 1;
            cofaces.mixed ^= cell;
            if cofaces.count == 1 {
                free.push(face);
            }
        }
    }
    (faces, Pairs::Listed(pairs))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chains::random_complexes;
    use proptest::prelude::*;

    proptest! {
        /// Invariant: pairs have unit incidence, no cell is used twice, and each face of a pair is in the boundary of no
        /// cell of a later pair; cells and criticals add up.
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
