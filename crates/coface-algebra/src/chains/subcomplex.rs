//! Subcomplexes, complexes relative to them, and direct sums.

use super::ChainComplex;
use crate::ids::narrow;
use crate::matrices::SparseMatrix;
use crate::{CellId, Error, ErrorKind, Fault};

impl ChainComplex {
    /// The complex of some of the cells, which must have their faces among them: `cells[k]` are those of degree k, and
    /// their order is that of the cells of the result.
    ///
    /// # Errors
    /// [`ErrorKind::NotAComplex`] naming a cell and a face of it that is missing; [`ErrorKind::NotInComplex`] for a
    /// cell that is not here; [`ErrorKind::InvalidInput`] for a cell that is listed twice.
    ///
    /// # Complexity
    /// Linear in the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_algebra::CellId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let [v, w, e] = [0, 1, 0].map(CellId::new);
    /// assert_eq!(edge.subcomplex(&[vec![v, w]])?.f_vector(), [2, 0]);
    /// let error = edge.subcomplex(&[vec![v], vec![e]]).unwrap_err();
    /// assert_eq!(error.message(), "cell c0 of degree 1 is listed without its face c1");
    /// # Ok(()) }
    /// ```
    pub fn subcomplex(&self, cells: &[Vec<CellId>]) -> Result<Self, Error> {
        self.check_subcomplex(cells)?;
        self.restricted(cells)
    }

    /// The complex relative to a subcomplex: the cells outside of it, in their order, with the faces inside left out
    /// of the boundaries. [`Self::complement`] says which cells these are.
    ///
    /// Its homology is that of the pair.
    ///
    /// # Errors
    /// As [`Self::subcomplex`].
    ///
    /// # Complexity
    /// Linear in the complex.
    ///
    /// # Examples
    /// An edge relative to its ends is a cycle:
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_algebra::CellId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let relative = edge.relative(&[vec![CellId::new(0), CellId::new(1)]])?;
    /// assert_eq!(relative.f_vector(), [0, 1]);
    /// assert_eq!(relative.euler_characteristic(), -1);
    /// # Ok(()) }
    /// ```
    pub fn relative(&self, cells: &[Vec<CellId>]) -> Result<Self, Error> {
        self.check_subcomplex(cells)?;
        self.restricted(&self.complement(cells)?)
    }

    /// The cells that are not listed, for each degree in rising order.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] and [`ErrorKind::InvalidInput`] as for [`Self::subcomplex`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::chains::ChainComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(3);
    /// assert_eq!(points.complement(&[vec![CellId::new(1)]])?, [[CellId::new(0), CellId::new(2)]]);
    /// # Ok(()) }
    /// ```
    pub fn complement(&self, cells: &[Vec<CellId>]) -> Result<Vec<Vec<CellId>>, Error> {
        let members = self.members(cells)?;
        let outside = |level: &Vec<bool>| (0..level.len()).filter(|&i| !level[i]).map(CellId::new).collect();
        Ok(members.iter().map(outside).collect())
    }

    /// The direct sum: in each degree the cells of this complex, then those of the other.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 cells or entries of one degree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(ChainComplex::of_points(2).direct_sum(&ChainComplex::of_points(3))?, ChainComplex::of_points(5));
    /// # Ok(()) }
    /// ```
    pub fn direct_sum(&self, other: &Self) -> Result<Self, Error> {
        let degree_count = self.degree_count().max(other.degree_count());
        let boundaries: Vec<SparseMatrix> = (1..degree_count)
            .map(|degree| {
                let (mut starts, mut rows, mut entries) = (vec![0], Vec::new(), Vec::new());
                for (complex, shift) in [(self, 0), (other, self.cell_count(degree - 1))] {
                    if let Some(matrix) = complex.boundary_matrix(degree) {
                        let start = narrow(rows.len());
                        // Where these sums wrap, the counts are beyond 32 bits and the parts are refused for that.
                        starts.extend(matrix.column_starts()[1..].iter().map(|&end| end.wrapping_add(start)));
                        rows.extend(matrix.rows().iter().map(|&row| row.wrapping_add(narrow(shift))));
                        entries.extend_from_slice(matrix.entries());
                    }
                }
                let row_count = self.cell_count(degree - 1) + other.cell_count(degree - 1);
                SparseMatrix::from_parts(row_count, starts, rows, entries)
            })
            .collect::<Result<_, Error>>()?;
        if boundaries.is_empty() {
            return Ok(Self::of_points(self.cell_count(0) + other.cell_count(0)));
        }
        Self::new(boundaries)
    }

    /// The augmented complex: below the cells of degree 0 stands one more cell, which each of them has as its face.
    /// All degrees go up by one, so that the homology of degree k + 1 is the reduced homology of degree k.
    ///
    /// # Errors
    /// [`ErrorKind::BoundaryOfBoundary`] naming an edge whose boundary does not sum to zero.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let augmented = ChainComplex::of_points(3).augmented()?;
    /// assert_eq!(augmented.f_vector(), [1, 3]);
    /// # Ok(()) }
    /// ```
    pub fn augmented(&self) -> Result<Self, Error> {
        let count = self.cell_count(0);
        let augmentation = SparseMatrix::from_entries(1, count, (0..count).map(|vertex| (0, vertex, 1)))?;
        let mut boundaries = vec![augmentation];
        boundaries.extend_from_slice(self.boundary_matrices());
        Self::new(boundaries)
    }

    /// For each degree and each cell whether it is listed.
    fn members(&self, cells: &[Vec<CellId>]) -> Result<Vec<Vec<bool>>, Error> {
        let mut members: Vec<Vec<bool>> = self.f_vector().iter().map(|&count| vec![false; count]).collect();
        for (degree, level) in cells.iter().enumerate() {
            for &cell in level {
                match members.get_mut(degree).and_then(|level| level.get_mut(cell.index())) {
                    Some(is_member) if !*is_member => *is_member = true,
                    Some(_) => {
                        return Err(Error::new(
                            ErrorKind::InvalidInput,
                            format!("cell {cell} of degree {degree} is listed twice"),
                        ));
                    }
                    None => {
                        return Err(Error::new(
                            ErrorKind::NotInComplex,
                            format!("there is no cell {cell} of degree {degree} in the complex"),
                        )
                        .with_fault(Fault::OutOfRange {
                            index: cell.index(),
                            count: self.cell_count(degree),
                        }));
                    }
                }
            }
        }
        Ok(members)
    }

    /// That the faces of all listed cells are listed.
    fn check_subcomplex(&self, cells: &[Vec<CellId>]) -> Result<(), Error> {
        let members = self.members(cells)?;
        for (degree, level) in cells.iter().enumerate().skip(1) {
            let Some(matrix) = self.boundary_matrix(degree) else { continue };
            for &cell in level {
                let faces = matrix.column(cell.index()).rows();
                if let Some(&face) = faces.iter().find(|&&face| !members[degree - 1][face as usize]) {
                    return Err(Error::new(
                        ErrorKind::NotAComplex,
                        format!("cell {cell} of degree {degree} is listed without its face c{face}"),
                    )
                    .with_fault(Fault::MissingFace { degree, cell, face: CellId::from_u32(face) })
                    .with_cure("list the faces of all cells too"));
                }
            }
        }
        Ok(())
    }

    /// The rows and columns of these cells; degrees without a list have no cells.
    fn restricted(&self, cells: &[Vec<CellId>]) -> Result<Self, Error> {
        let numbers = |degree: usize| -> Vec<usize> {
            cells.get(degree).into_iter().flatten().map(|cell| cell.index()).collect()
        };
        if self.boundary_matrices().is_empty() {
            return Ok(Self::of_points(numbers(0).len()));
        }
        let boundaries = self.boundary_matrices().iter().enumerate();
        let parts = boundaries.map(|(k, matrix)| matrix.submatrix(&numbers(k), &numbers(k + 1)));
        Self::new(parts.collect::<Result<_, Error>>()?)
    }
}

#[cfg(test)]
mod tests {
    use super::super::chain::tests::disk_of_four_triangles;
    use super::*;
    use crate::normal_forms::invariant_factors;
    use crate::samples::random_complexes;
    use proptest::prelude::*;

    fn cells(numbers: &[usize]) -> Vec<CellId> {
        numbers.iter().copied().map(CellId::new).collect()
    }

    /// The Betti numbers by ranks.
    fn betti_numbers(complex: &ChainComplex) -> Vec<usize> {
        let rank =
            |degree| complex.boundary_matrix(degree).map_or(0, |matrix| invariant_factors(matrix).len());
        (0..complex.degree_count()).map(|k| complex.cell_count(k) - rank(k) - rank(k + 1)).collect()
    }

    #[test]
    fn a_disk_relative_to_its_rim_is_a_sphere_relative_to_a_point() {
        let disk = disk_of_four_triangles();
        let rim = [cells(&[0, 1, 2, 3, 4, 5]), cells(&[0, 1, 2, 3, 4, 5])];
        assert_eq!(betti_numbers(&disk.subcomplex(&rim).unwrap()), [1, 1, 0]);
        let relative = disk.relative(&rim).unwrap();
        assert_eq!(relative.f_vector(), [0, 3, 4]);
        assert_eq!(betti_numbers(&relative), [0, 0, 1]);
        assert_eq!(disk.complement(&rim).unwrap(), [vec![], cells(&[6, 7, 8]), cells(&[0, 1, 2, 3])]);
        assert_eq!(betti_numbers(&disk.augmented().unwrap()), [0, 0, 0, 0]);
    }

    #[test]
    fn the_order_of_cells_is_that_of_the_list() {
        let disk = disk_of_four_triangles();
        // Edge 0 goes from vertex 1 to vertex 0.
        let edge = disk.subcomplex(&[cells(&[1, 0]), cells(&[0])]).unwrap();
        let column = edge.boundary_matrix(1).unwrap().column(0);
        assert!(column.iter().eq([(0, -1), (1, 1)]));
    }

    #[test]
    fn faults_are_named() {
        let disk = disk_of_four_triangles();
        let kind = |lists: &[Vec<CellId>]| disk.subcomplex(lists).unwrap_err().kind();
        assert_eq!(kind(&[cells(&[0]), cells(&[0])]), ErrorKind::NotAComplex);
        assert_eq!(kind(&[cells(&[0, 0])]), ErrorKind::InvalidInput);
        assert_eq!(kind(&[cells(&[6])]), ErrorKind::NotInComplex);
        assert_eq!(kind(&[vec![], vec![], vec![], cells(&[0])]), ErrorKind::NotInComplex);
        assert_eq!(disk.relative(&[cells(&[0]), cells(&[0])]).unwrap_err().kind(), ErrorKind::NotAComplex);
        // Without cells there is a complex, and relative to it nothing changes.
        assert_eq!(disk.subcomplex(&[]).unwrap().dimension(), None);
        assert_eq!(disk.relative(&[]).unwrap(), disk);
    }

    #[test]
    fn an_edge_that_leads_nowhere_cannot_be_augmented() {
        let ray = ChainComplex::new(vec![SparseMatrix::from_entries(1, 1, [(0, 0, 1)]).unwrap()]).unwrap();
        let error = ray.augmented().unwrap_err();
        assert_eq!(error.kind(), ErrorKind::BoundaryOfBoundary);
        assert_eq!(ChainComplex::of_points(0).augmented().unwrap().f_vector(), [1, 0]);
    }

    proptest! {
        #[test]
        fn a_direct_sum_holds_both(a in random_complexes(), b in random_complexes()) {
            let sum = a.direct_sum(&b).unwrap();
            prop_assert_eq!(sum.euler_characteristic(), a.euler_characteristic() + b.euler_characteristic());
            let both: Vec<usize> = betti_numbers(&a).iter().zip(&betti_numbers(&b)).map(|(x, y)| x + y).collect();
            prop_assert_eq!(betti_numbers(&sum), both);
            // The first summand is found again as a subcomplex, and relative to it there is the second.
            let first: Vec<Vec<CellId>> = a.f_vector().iter().map(|&n| (0..n).map(CellId::new).collect()).collect();
            prop_assert_eq!(sum.subcomplex(&first).unwrap(), a);
            prop_assert_eq!(sum.relative(&first).unwrap(), b);
        }
    }
}
