//! The Kuhn triangulation of a grid.

use super::CuboidGrid;
use crate::shapes::{CellKind, PlacedCells};
use crate::simplicial::SignedSimplices;
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{RaggedArray, Sign};

impl CuboidGrid {
    /// The top cells cut into simplices without new vertices: of dimension d, each into the d! simplices that walk from its
    /// lowest to its highest vertex along its axes in some order (the Kuhn or Freudenthal triangulation).
    ///
    /// They come cell by cell, in each by the order of axes, lexicographically. Vertices rise, and signs are those of the
    /// orders as permutations, so that all simplices are oriented as the cells are. Neighboring cells are cut alike on
    /// their common face.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if the simplices have more than $2^{32} - 1$ vertices in all.
    ///
    /// # Complexity
    /// Linear in the result, in parallel.
    ///
    /// # References
    /// H. W. Kuhn, *Some combinatorial lemmas in topology* (1960).
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = CuboidGrid::new(&[1, 1])?.simplices()?;
    /// assert!(square.lists().iter().eq([[0, 2, 3], [0, 1, 3]]));
    /// assert!(square.to_oriented().iter().eq([[0, 2, 3], [1, 0, 3]]));
    /// assert_eq!(CuboidGrid::new(&[2, 2, 2])?.simplices()?.len(), 48);
    /// # Ok(()) }
    /// ```
    pub fn simplices(&self) -> Result<SignedSimplices, Error> {
        let Some((dimension, top)) =
            self.dimension().and_then(|dimension| Some((dimension, *self.blocks(dimension).first()?)))
        else {
            return Ok(SignedSimplices::default());
        };
        let count = self.cell_count(dimension);
        let total = (1..=dimension as u64 + 1).fold(count as u64, u64::saturating_mul);
        if u32::try_from(total).is_err() {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("{count} cells of dimension {dimension} make simplices with more than 2^32 - 1 vertices in all"),
            )
            .with_cure("cut a smaller grid"));
        }
        let strides = self.strides(super::AxisSet::default());
        let steps: Vec<u32> = top.extent.iter().map(|axis| strides[axis]).collect();
        let (mut template, mut signs) = (Vec::new(), Vec::new());
        for_each_order(steps.len(), &mut Vec::new(), Sign::Plus, &mut |order, sign| {
            let mut at = 0;
            template.push(at);
            for &i in order {
                at += steps[i];
                template.push(at);
            }
            signs.push(sign);
        });
        let mut items = vec![0; total as usize];
        self.fill_block(top, &template, &mut items);
        Ok(SignedSimplices::from_trusted(RaggedArray::uniform(dimension + 1, items)?, signs.repeat(count)))
    }

    /// The simplices of [`Self::simplices`], oriented, with the positions of all vertices.
    ///
    /// # Errors
    /// Those of [`Self::simplices`]; [`ErrorKind::InvalidInput`] for a grid without axes, which has no positions.
    pub fn placed_simplices(&self) -> Result<PlacedCells, Error> {
        let simplices = self.simplices()?.to_oriented();
        PlacedCells::new(self.positions()?, CellKind::Simplex, self.dimension().unwrap_or(0), simplices)
    }
}

/// Calls `visit` with every order of `0..count` in lexicographic order and its sign as a permutation.
fn for_each_order(count: usize, order: &mut Vec<usize>, sign: Sign, visit: &mut dyn FnMut(&[usize], Sign)) {
    if order.len() == count {
        return visit(order, sign);
    }
    let mut passed = 0;
    for i in 0..count {
        if !order.contains(&i) {
            order.push(i);
            // The numbers that are passed over follow later: as many inversions.
            for_each_order(count, order, sign.times(Sign::power_of_minus_one(passed)), visit);
            order.pop();
            passed += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simplicial::{FrozenComplex, facets};
    use coface_algebra::Permutation;
    use coface_algebra::VertexId;
    use proptest::prelude::*;

    #[test]
    fn orders_come_with_their_signs() {
        let mut orders: Vec<Vec<usize>> = Vec::new();
        for_each_order(5, &mut Vec::new(), Sign::Plus, &mut |order, sign| {
            assert_eq!(sign, Permutation::sorting(order).sign());
            orders.push(order.to_vec());
        });
        assert_eq!(orders.len(), 120);
        assert!(orders.is_sorted_by(|a, b| a < b));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn cells_are_cut_alike(
            lengths in prop::collection::vec(prop::collection::vec(prop_oneof![3 => Just(1.0), 1 => Just(-2.0)], 0..4), 0..4),
        ) {
            let grid = CuboidGrid::with_lengths(&lengths).unwrap();
            let simplices = grid.simplices().unwrap();
            let complex = FrozenComplex::from_facets(simplices.lists()).unwrap();
            let cells = grid.chain_complex().unwrap();
            prop_assert_eq!(complex.chain_complex().unwrap().euler_characteristic(), cells.euler_characteristic());
            prop_assert_eq!(complex.simplex_count(0), grid.cell_count(0));
            let dimension = grid.dimension().unwrap_or(0);
            if dimension > 0 {
                // No inner facet is left over, and each facet of a cell on the boundary has its simplices.
                let table = facets(&simplices.to_oriented()).unwrap();
                let factorial: usize = (1..dimension).product();
                prop_assert_eq!(table.boundary_facets().len(), factorial * grid.boundary_facets().len());
            }
            if dimension == lengths.len() {
                let positions = grid.positions().unwrap();
                for (list, sign) in simplices.lists().iter().zip(simplices.signs()) {
                    // A step along one axis each: the determinant is that of the order of axes, times the lengths.
                    let axes: Vec<usize> = list.windows(2).map(|pair| {
                        let [a, b] = [pair[0], pair[1]].map(|v| positions.point(VertexId::from_u32(v)));
                        let moved: Vec<usize> = (0..a.len()).filter(|&i| a[i] < b[i]).collect();
                        assert!(moved.len() == 1 && a.iter().zip(b).all(|(x, y)| x <= y));
                        moved[0]
                    }).collect();
                    prop_assert_eq!(Permutation::sorting(&axes).sign(), *sign);
                }
            }
        }
    }

    #[test]
    fn too_many_simplices_are_refused() {
        let grid = CuboidGrid::new(&[1; 13]).unwrap();
        assert_eq!(grid.simplices().unwrap_err().kind(), ErrorKind::TooLarge);
        assert_eq!(CuboidGrid::new(&[]).unwrap().simplices().unwrap().lists().items(), [0]);
        assert_eq!(CuboidGrid::new(&[3]).unwrap().placed_simplices().unwrap().cell_count(), 3);
    }
}
