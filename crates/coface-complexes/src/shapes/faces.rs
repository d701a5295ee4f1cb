//! The faces of placed cells: facets with signs, skeletons, boundary and chain complex.

use super::{CellKind, PlacedCells};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use rayon::prelude::*;

/// Cells of one kind and dimension, each once, in the lexicographic order of their least lists.
struct Facets {
    cells: RaggedArray,
    /// Rows are facets, columns the cells that they were taken from.
    boundary: SparseMatrix,
}

impl PlacedCells {
    /// The faces of dimension `dimension` of all cells, each once, on the same positions; in dimension 0 all vertices.
    ///
    /// A simplex has its vertices rising; a cuboid has its least vertex first and its axes in the falling order of the
    /// vertices that they lead to, so that its list is the least. Two cuboids with the same vertices in other places are two cells.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a dimension above that of the cells; [`ErrorKind::TooLarge`] beyond $2^{32}$
    /// incidences.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n facets of cells in each dimension passed through; sorting is parallel.
    ///
    /// # Examples
    /// Two triangles with a common edge:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 1., 1., 1.])?;
    /// let halves = RaggedArray::from_lists([[0, 1, 2], [1, 3, 2]]);
    /// let halves = PlacedCells::new(corners, CellKind::Simplex, 2, halves)?;
    /// assert_eq!(halves.skeleton(1)?.cell_count(), 5);
    /// assert_eq!(halves.boundary()?.cells().list(0), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn skeleton(&self, dimension: usize) -> Result<Self, Error> {
        if dimension > self.dimension() {
            return Err(Error::invalid(format!(
                "there is no skeleton of dimension {dimension}; the cells have dimension {}",
                self.dimension()
            ))
            .with_cure("ask for a dimension up to that of the cells"));
        }
        let cells = if dimension == self.dimension() {
            self.cells().clone()
        } else if dimension == 0 {
            RaggedArray::uniform(1, (0..self.vertex_count() as u32).collect())?
        } else {
            let mut cells = facets(self.kind(), self.dimension(), self.cells())?.cells;
            for d in (dimension + 1..self.dimension()).rev() {
                cells = facets(self.kind(), d, &cells)?.cells;
            }
            cells
        };
        Ok(Self::from_trusted(self.positions().clone(), self.kind(), dimension, cells))
    }

    /// The facets of exactly one cell, on the same positions, oriented as in the boundary of that cell.
    ///
    /// The boundary of a simplex is $\sum_i (-1)^i [v_0, \dots, \hat v_i, \dots, v_d]$, that of a cuboid
    /// $\sum_a (-1)^a (\text{upper facet} - \text{lower facet})$ over its axes a from 0. Points have no sign: those of a
    /// segment are listed without one.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for points; [`ErrorKind::TooLarge`] beyond $2^{32}$ incidences.
    ///
    /// # Complexity
    /// That of [`Self::skeleton`].
    pub fn boundary(&self) -> Result<Self, Error> {
        let dimension = self.dimension();
        if dimension == 0 {
            return Err(
                Error::invalid("points have no boundary").with_cure("take cells of dimension 1 or more")
            );
        }
        let Facets { cells, boundary } = facets(self.kind(), dimension, self.cells())?;
        let cofaces = boundary.transpose();
        let mut kept = Vec::new();
        for i in 0..cells.len() {
            let column = cofaces.column(i);
            if let ([_], &[sign]) = (column.rows(), column.entries()) {
                let start = kept.len();
                kept.extend_from_slice(cells.list(i));
                if sign < 0 {
                    turn_cell(self.kind(), &mut kept[start..]);
                }
            }
        }
        let cells = lists_of(self.kind(), dimension - 1, kept)?;
        Ok(Self::from_trusted(self.positions().clone(), self.kind(), dimension - 1, cells))
    }

    /// The same cells, each with the other orientation; points stay as they are.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = Positions::from_flat(1, vec![0., 1.])?;
    /// let segment = PlacedCells::new(line, CellKind::Cuboid, 1, RaggedArray::from_lists([[0, 1]]))?;
    /// assert_eq!(segment.turned().cells().list(0), [1, 0]);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn turned(&self) -> Self {
        let (positions, mut cells) = self.clone().into_parts();
        if let Some(width) = cells.uniform_width() {
            cells.items_mut().chunks_mut(width).for_each(|cell| turn_cell(self.kind(), cell));
        }
        Self::from_trusted(positions, self.kind(), self.dimension(), cells)
    }

    /// The chain complex of the cells and all their faces, with all vertices; the cells themselves in their order and
    /// orientation, faces as [`Self::skeleton`] gives them.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond $2^{32}$ incidences in one degree.
    ///
    /// # Complexity
    /// That of [`Self::skeleton`].
    ///
    /// # Examples
    /// The tesseract has 16 vertices, 32 edges, 24 squares and 8 cubes:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = (0..16u32).flat_map(|i| [3, 2, 1, 0].map(|bit| f64::from(i >> bit & 1))).collect();
    /// let cell = RaggedArray::from_lists([(0..16).collect::<Vec<u32>>()]);
    /// let tesseract = PlacedCells::new(Positions::from_flat(4, corners)?, CellKind::Cuboid, 4, cell)?;
    /// assert_eq!(tesseract.chain_complex()?.f_vector(), [16, 32, 24, 8, 1]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        let dimension = self.dimension();
        if dimension == 0 {
            return Ok(ChainComplex::of_points(self.vertex_count()));
        }
        let mut boundaries = Vec::with_capacity(dimension);
        let mut lower = None;
        for d in (2..=dimension).rev() {
            let facets = facets(self.kind(), d, lower.as_ref().unwrap_or_else(|| self.cells()))?;
            boundaries.push(facets.boundary);
            lower = Some(facets.cells);
        }
        let segments = lower.as_ref().unwrap_or_else(|| self.cells());
        let (mut rows, mut entries) = (Vec::with_capacity(2 * segments.len()), Vec::new());
        for ends in segments.items().as_chunks::<2>().0 {
            rows.extend([ends[0].min(ends[1]), ends[0].max(ends[1])]);
            entries.extend(if ends[0] < ends[1] { [-1, 1] } else { [1, -1] });
        }
        let starts = (0..=segments.len()).map(|i| 2 * i as u32).collect();
        boundaries.push(SparseMatrix::from_trusted_parts(self.vertex_count(), starts, rows, entries)?);
        boundaries.reverse();
        ChainComplex::new(boundaries)
    }
}

/// The facets of cells of this dimension, 2 or more unless their vertices are asked for as facets.
fn facets(kind: CellKind, dimension: usize, cells: &RaggedArray) -> Result<Facets, Error> {
    let (facet_count, width) = match kind {
        CellKind::Simplex => (dimension + 1, dimension),
        CellKind::Cuboid => (2 * dimension, 1 << (dimension - 1)),
    };
    let side_count = cells
        .len()
        .checked_mul(facet_count)
        .filter(|&count| count.checked_mul(width).is_some_and(|n| u32::try_from(n).is_ok()));
    let Some(side_count) = side_count else {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!(
                "{} {} of dimension {dimension} have over 2^32 corners of facets",
                cells.len(),
                kind.plural()
            ),
        ));
    };
    let mut lists = vec![0u32; side_count * width];
    let mut signs = vec![Sign::Plus; side_count];
    if side_count > 0 {
        let of_cell = lists.par_chunks_mut(width * facet_count).zip(signs.par_chunks_mut(facet_count));
        of_cell.enumerate().for_each(|(i, (lists, signs))| {
            for (side, (list, sign)) in lists.chunks_mut(width).zip(signs).enumerate() {
                *sign = facet(kind, dimension, cells.list(i), side, list);
                *sign = sign.times(least_list(kind, list));
            }
        });
    }
    let list = |side: u32| &lists[side as usize * width..(side as usize + 1) * width];
    let mut order: Vec<u32> = (0..side_count as u32).collect();
    order.par_sort_unstable_by(|&a, &b| list(a).cmp(list(b)).then(a.cmp(&b)));
    let mut facet_of_side = vec![0u32; side_count];
    let (mut items, mut count) = (Vec::new(), 0u32);
    for equal in order.chunk_by(|&a, &b| list(a) == list(b)) {
        items.extend_from_slice(list(equal[0]));
        equal.iter().for_each(|&side| facet_of_side[side as usize] = count);
        count += 1;
    }
    let (mut rows, mut entries) = (Vec::with_capacity(side_count), Vec::with_capacity(side_count));
    let mut column = Vec::with_capacity(facet_count);
    for i in 0..cells.len() {
        let sides = i * facet_count..(i + 1) * facet_count;
        column.clear();
        column.extend(sides.map(|side| (facet_of_side[side], signs[side].to_i32())));
        column.sort_unstable();
        rows.extend(column.iter().map(|&(row, _)| row));
        entries.extend(column.iter().map(|&(_, entry)| entry));
    }
    let starts = (0..=cells.len()).map(|i| (i * facet_count) as u32).collect();
    let boundary = SparseMatrix::from_trusted_parts(count as usize, starts, rows, entries)?;
    Ok(Facets { cells: lists_of(kind, dimension - 1, items)?, boundary })
}

/// Writes facet number `side` of a cell and gives its sign in the boundary: of a simplex the one without vertex `side`, of
/// a cuboid the lower facet of axis `side / 2` for even numbers, else the upper one.
fn facet(kind: CellKind, dimension: usize, cell: &[u32], side: usize, list: &mut [u32]) -> Sign {
    match kind {
        CellKind::Simplex => {
            list[..side].copy_from_slice(&cell[..side]);
            list[side..].copy_from_slice(&cell[side + 1..]);
            Sign::power_of_minus_one(side)
        }
        CellKind::Cuboid => {
            let (axis, upper) = (side / 2, side % 2);
            let bit = dimension - 1 - axis;
            for (i, vertex) in list.iter_mut().enumerate() {
                *vertex = cell[(i >> bit << (bit + 1)) | upper << bit | (i & ((1 << bit) - 1))];
            }
            Sign::power_of_minus_one(axis + 1 + upper)
        }
    }
}

/// Puts the vertices of a cell into the least order that is one of its cell, and gives the sign of that change.
fn least_list(kind: CellKind, cell: &mut [u32]) -> Sign {
    match kind {
        CellKind::Simplex => {
            let mut exchanges = 0;
            for i in 1..cell.len() {
                let mut j = i;
                while j > 0 && cell[j - 1] > cell[j] {
                    cell.swap(j - 1, j);
                    (j, exchanges) = (j - 1, exchanges + 1);
                }
            }
            Sign::power_of_minus_one(exchanges)
        }
        CellKind::Cuboid => least_cuboid(cell),
    }
}

fn least_cuboid(cell: &mut [u32]) -> Sign {
    let dimension = cell.len().trailing_zeros() as usize;
    let corner = (0..cell.len()).min_by_key(|&i| cell[i]).unwrap_or(0);
    // Bits in the order of the axes that they become; a cuboid has fewer than 32.
    let mut bits = [0usize; 32];
    let bits = &mut bits[..dimension];
    bits.iter_mut().enumerate().for_each(|(axis, bit)| *bit = dimension - 1 - axis);
    // The last axis leads to the second vertex of the list, so it comes first among them.
    let mut exchanges = 0;
    for i in 1..dimension {
        let mut j = i;
        while j > 0 && cell[corner ^ 1 << bits[j - 1]] < cell[corner ^ 1 << bits[j]] {
            bits.swap(j - 1, j);
            (j, exchanges) = (j - 1, exchanges + 1);
        }
    }
    let sign = Sign::power_of_minus_one(exchanges + corner.count_ones() as usize);
    if corner == 0 && exchanges == 0 {
        return sign;
    }
    let old = cell.to_vec();
    for (i, vertex) in cell.iter_mut().enumerate() {
        let moved = bits.iter().enumerate().map(|(axis, bit)| (i >> (dimension - 1 - axis) & 1) << bit);
        *vertex = old[corner ^ moved.sum::<usize>()];
    }
    sign
}

/// Gives a cell its other orientation: exchanges two vertices of a simplex, mirrors a cuboid along its first axis.
pub fn turn_cell(kind: CellKind, cell: &mut [u32]) {
    match kind {
        CellKind::Simplex if cell.len() > 1 => cell.swap(0, 1),
        CellKind::Simplex => {}
        CellKind::Cuboid => cell.rotate_left(cell.len() / 2),
    }
}

fn lists_of(kind: CellKind, dimension: usize, items: Vec<u32>) -> Result<RaggedArray, Error> {
    let width = kind.vertex_count(dimension).expect("a face has fewer vertices than its cell");
    if items.is_empty() { Ok(RaggedArray::new()) } else { RaggedArray::uniform(width, items) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simplicial::SimplicialComplex;
    use coface_geometry::Positions;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    fn placed(kind: CellKind, dimension: usize, count: usize, cells: &[Vec<u32>]) -> PlacedCells {
        let positions = Positions::from_flat(1, vec![0.0; count]).unwrap();
        PlacedCells::new(positions, kind, dimension, RaggedArray::from_lists(cells)).unwrap()
    }

    /// Cuboids of dimension d at places of the grid of 4^d vertices.
    fn grid_cells(dimension: usize, places: &[usize]) -> Vec<Vec<u32>> {
        let corner = |place: usize, i: usize| {
            (0..dimension).fold(0, |sum, axis| {
                let digit = place / 3usize.pow((dimension - 1 - axis) as u32) % 3;
                sum * 4 + (digit + (i >> (dimension - 1 - axis) & 1)) as u32
            })
        };
        places.iter().map(|&place| (0..1 << dimension).map(|i| corner(place, i)).collect()).collect()
    }

    /// The cell seen in the frame with these axes, mirrored along those of the mask.
    fn reframed(cell: &[u32], axes: &[usize], mask: usize) -> Vec<u32> {
        let moved = |i: usize| axes.iter().enumerate().map(|(k, &bit)| (i >> k & 1) << bit).sum::<usize>();
        (0..cell.len()).map(|i| cell[moved(i) ^ (mask & (cell.len() - 1))]).collect()
    }

    #[test]
    fn a_square_and_a_triangle_by_hand() {
        let triangle = placed(CellKind::Simplex, 2, 3, &[vec![0, 1, 2]]).boundary().unwrap();
        assert_eq!(triangle.cells(), &RaggedArray::from_lists([[0, 1], [2, 0], [1, 2]]));
        let square = placed(CellKind::Cuboid, 2, 4, &[vec![0, 1, 2, 3]]).boundary().unwrap();
        // d(a x b) = da x b - a x db: right less left, less top, and bottom.
        assert_eq!(square.cells(), &RaggedArray::from_lists([[1, 0], [0, 2], [3, 1], [2, 3]]));
        let segment = placed(CellKind::Cuboid, 1, 2, &[vec![1, 0]]);
        assert_eq!(segment.boundary().unwrap().cells(), &RaggedArray::from_lists([[0], [1]]));
        assert!(segment.boundary().unwrap().boundary().is_err());
        assert!(segment.skeleton(2).is_err());
    }

    #[test]
    fn nothing_has_a_complex_of_vertices() {
        for kind in [CellKind::Simplex, CellKind::Cuboid] {
            let nothing = placed(kind, 3, 2, &[]);
            assert_eq!(nothing.chain_complex().unwrap().f_vector(), [2, 0, 0, 0]);
            assert_eq!(nothing.boundary().unwrap().cell_count(), 0);
            assert_eq!(nothing.skeleton(1).unwrap().cell_count(), 0);
        }
    }

    proptest! {
        /// Every cell in a frame of its own: faces are still identified, and the boundary of the boundary is zero.
        #[test]
        fn frames_of_cuboids_do_not_matter(
            places in prop::collection::btree_set(0usize..27, 1..12),
            frames in prop::collection::vec((Just(vec![0usize, 1, 2]).prop_shuffle(), 0usize..8), 12),
        ) {
            let cells = grid_cells(3, &places.into_iter().collect::<Vec<_>>());
            let turned: Vec<_> =
                cells.iter().zip(&frames).map(|(cell, (axes, mask))| reframed(cell, axes, *mask)).collect();
            let complex = placed(CellKind::Cuboid, 3, 64, &turned).chain_complex().unwrap();
            let faces = |size: usize| -> usize {
                // Faces of cubes are the sets of vertices in subcubes: fix some bits, free the others.
                let mut found = BTreeSet::new();
                for cell in &cells {
                    for free in (0..8usize).filter(|free| 1 << free.count_ones() == size) {
                        for base in (0..8usize).filter(|base| base & free == 0) {
                            let inside = (0..8).filter(|i| i & !free == base);
                            found.insert(inside.map(|i| cell[i]).collect::<BTreeSet<_>>());
                        }
                    }
                }
                found.len()
            };
            prop_assert_eq!(complex.f_vector(), [64, faces(2), faces(4), faces(8)]);
        }

        /// The outer boundary of positive cells is a cycle, whatever the frames.
        #[test]
        fn the_boundary_of_turned_cells_is_turned(places in prop::collection::btree_set(0usize..27, 1..12)) {
            let cells = grid_cells(3, &places.into_iter().collect::<Vec<_>>());
            let placed = placed(CellKind::Cuboid, 3, 64, &cells);
            let (there, back) = (placed.boundary().unwrap(), placed.turned().boundary().unwrap());
            prop_assert_eq!(back.turned(), there);
        }

        #[test]
        fn simplices_have_the_faces_of_their_complex(
            cells in prop::collection::btree_set(prop::collection::btree_set(0u32..8, 4), 1..10),
            swaps in prop::collection::vec((0usize..4, 0usize..4), 10),
        ) {
            let mut lists: Vec<Vec<u32>> = cells.iter().map(|cell| cell.iter().copied().collect()).collect();
            let expected = SimplicialComplex::from_facets(&lists).unwrap();
            for (list, &(a, b)) in lists.iter_mut().zip(&swaps) {
                list.swap(a, b);
            }
            let placed = placed(CellKind::Simplex, 3, 8, &lists);
            let complex = placed.chain_complex().unwrap();
            prop_assert_eq!(&complex.f_vector()[1..], &expected.f_vector()[1..]);
            for k in 1..3 {
                let skeleton = placed.skeleton(k).unwrap();
                let simplices: Vec<Vec<u32>> = expected.simplices(k).map(|s| s.numbers().to_vec()).collect();
                prop_assert_eq!(skeleton.cells(), &RaggedArray::from_lists(simplices));
            }
        }
    }
}
