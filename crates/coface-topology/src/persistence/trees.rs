//! Components of a graph that grows, as lists, and the graph of the cells and faces of a manifold.

use super::reduction::NONE;
use coface_algebra::{ParityUnion, ParityUnionFind, Sign, SparseMatrix, UnionFind};

/// The trees of a graph that grows. Each has an oldest vertex, and ends when it is joined to an older one.
pub(super) struct Trees {
    /// For each vertex the one after it in its list. The list of a tree begins with its oldest vertex, and is put behind that of the older tree.
    successors: Vec<u32>,
    /// The last vertex in the list of the tree of each oldest vertex.
    last: Vec<u32>,
    /// The size of the tree of each oldest vertex when it ends, or now.
    sizes: Vec<u32>,
}

impl Trees {
    pub(super) fn new(vertex_count: usize) -> Self {
        let last = (0..vertex_count as u32).collect();
        Self { successors: vec![NONE; vertex_count], last, sizes: vec![1; vertex_count] }
    }

    /// Joins two trees, which their oldest vertices name.
    pub(super) fn join(&mut self, older: u32, younger: u32) {
        self.successors[self.last[older as usize] as usize] = younger;
        self.last[older as usize] = self.last[younger as usize];
        self.sizes[older as usize] += self.sizes[younger as usize];
    }

    /// The vertices of the tree of an oldest vertex when it ends, or now.
    pub(super) fn vertices(&self, oldest: u32) -> impl Iterator<Item = u32> {
        std::iter::successors(Some(oldest), |&vertex| Some(self.successors[vertex as usize]))
            .take(self.sizes[oldest as usize] as usize)
    }
}

/// The graph whose vertices are the cells of a matrix and whose edges are the faces, each of one or two cells with the coefficients 1 and -1.
pub(super) struct DualGraph {
    cell_count: usize,
    /// The cells of each face, or [`NONE`], doubled, and one more where the coefficient is -1.
    sides: Vec<[u32; 2]>,
}

impl DualGraph {
    /// `None` if a face has more than two cells or another coefficient.
    pub(super) fn of(matrix: &SparseMatrix) -> Option<Self> {
        let mut sides = vec![[NONE; 2]; matrix.row_count()];
        // Of so many cells sides cannot be told from NONE.
        if matrix.column_count() >= 1 << 31 {
            return None;
        }
        for (cell, column) in matrix.columns().enumerate() {
            for (face, x) in column.iter() {
                let side = sides[face].iter_mut().find(|side| **side == NONE)?;
                *side = 2 * cell as u32 + u32::from(x < 0);
                if x.abs() != 1 {
                    return None;
                }
            }
        }
        Some(Self { cell_count: matrix.column_count(), sides })
    }

    /// Joins the trees of cells by faces, given by their ids from the last one to enter to the first. The oldest cell of a tree is the last one to enter,
    /// by its number; a face of one cell leads outside, which is older than all cells and has the number of cells as its own. What is called has the
    /// place of the face, and the oldest cells of the two trees, the older one first: the face and the younger one are a pair.
    pub(super) fn join(
        &self,
        faces: impl Iterator<Item = u32>,
        numbers: &[u32],
        mut joined: impl FnMut(usize, u32, u32),
    ) {
        let outside = self.cell_count as u32;
        let mut components = UnionFind::new(self.cell_count + 1);
        let mut oldest: Vec<u32> = (0..=outside).collect();
        for (place, face) in faces.enumerate() {
            let sides = self.sides[face as usize];
            if sides[0] == NONE {
                continue;
            }
            let number = |side: u32| if side == NONE { outside } else { numbers[side as usize / 2] };
            let roots = sides.map(|side| components.find(number(side)));
            let [a, b] = roots.map(|root| oldest[root as usize]);
            if components.unite(roots[0], roots[1]) {
                oldest[components.find(roots[0]) as usize] = a.max(b);
                joined(place, a.max(b), a.min(b));
            }
        }
    }

    /// A sign for each cell, so that the two cells of a face have it with opposite coefficients. `None` if there are no such signs.
    pub(super) fn orientations(&self) -> Option<Vec<Sign>> {
        let mut classes = ParityUnionFind::new(self.cell_count);
        for &[a, b] in self.sides.iter().filter(|sides| sides[1] != NONE) {
            let relative = if a % 2 == b % 2 { Sign::Minus } else { Sign::Plus };
            if classes.unite(a / 2, b / 2, relative) == ParityUnion::Contradicts {
                return None;
            }
        }
        Some((0..self.cell_count as u32).map(|cell| classes.find(cell).1).collect())
    }
}
