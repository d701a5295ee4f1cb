//! Volumes of cells.

use crate::cell_mesh::shape::CellShape;
use coface_algebra::RaggedArray;
use coface_geometry::{Positions, Scaled, Sum};

/// The volumes of cells, summed up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CellVolumes {
    signed: f64,
    absolute: f64,
    positive_count: usize,
    negative_count: usize,
}

impl CellVolumes {
    /// The sum of the signed volumes, positive for cells that list their vertices as [`CellShape`] describes.
    pub fn signed(&self) -> f64 {
        self.signed
    }

    /// The sum of the volumes without their signs.
    pub fn absolute(&self) -> f64 {
        self.absolute
    }

    /// The number of cells of positive volume, up to rounding.
    pub fn positive_count(&self) -> usize {
        self.positive_count
    }

    /// The number of cells of negative volume, up to rounding.
    pub fn negative_count(&self) -> usize {
        self.negative_count
    }
}

/// The volumes of cells, cell i of the shape `shapes[i]` with the vertices `cells.list(i)`, in the cube of the unit of the
/// positions; `None` unless the positions have three coordinates.
///
/// The volume of a cell is that of the cones over its sides. A quadrangle that is not flat is taken as the fan around the
/// mean of its vertices, on both sides the same, so that the cells of a mesh fill it without gap.
///
/// # Panics
/// If a cell names a vertex without position, or has too few vertices for its shape.
///
/// # Complexity
/// Linear; parallel, with the same rounding whatever the number of threads.
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::cell_mesh::{CellShape, cell_volumes};
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let positions = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 6.])?;
/// let cells = RaggedArray::from_lists([[0, 1, 2, 3], [1, 0, 2, 3]]);
/// let volumes = cell_volumes(&positions, &[CellShape::Tetrahedron; 2], &cells).expect("there are three coordinates");
/// assert_eq!((volumes.signed(), volumes.absolute()), (0.0, 2.0));
/// assert_eq!((volumes.positive_count(), volumes.negative_count()), (1, 1));
/// # Ok(()) }
/// ```
pub fn cell_volumes(positions: &Positions, shapes: &[CellShape], cells: &RaggedArray) -> Option<CellVolumes> {
    if positions.dimension() != 3 {
        return None;
    }
    let scaled = Scaled::new(positions);
    let six_fold = |i: usize| {
        let cell = cells.list(i);
        let origin = scaled.origin_at(cell[0]);
        if shapes[i] == CellShape::Tetrahedron {
            return scaled.cone(cell[1..].iter().copied(), origin);
        }
        let side = |face: &&[usize]| scaled.cone(face.iter().map(|&k| cell[k]), origin);
        shapes[i].faces().iter().map(side).sum()
    };
    let count = |test: fn(f64) -> bool| (0..cells.len()).filter(|&i| test(six_fold(i))).count();
    let total = |term: f64| scaled.unscaled(term / 6.0, 3);
    Some(CellVolumes {
        signed: total(Sum::of(cells.len(), six_fold)),
        absolute: total(Sum::of(cells.len(), |i| six_fold(i).abs())),
        positive_count: count(|volume| volume > 0.0),
        negative_count: count(|volume| volume < 0.0),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn cells_of_the_unit_cube_have_their_volumes() {
        let corners: Vec<f64> =
            [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
                .iter()
                .flatten()
                .map(|&x| f64::from(x))
                .collect();
        let positions = Positions::from_flat(3, corners).unwrap();
        let table: [(CellShape, &[u32], f64); 4] = [
            (CellShape::Hexahedron, &[0, 1, 2, 3, 4, 5, 6, 7], 1.0),
            (CellShape::Wedge, &[0, 1, 2, 4, 5, 6], 0.5),
            (CellShape::Pyramid, &[0, 1, 2, 3, 4], 1.0 / 3.0),
            (CellShape::Tetrahedron, &[0, 1, 2, 5], 1.0 / 6.0),
        ];
        for (shape, cell, volume) in table {
            let found = cell_volumes(&positions, &[shape], &RaggedArray::from_lists([cell])).unwrap();
            assert!((found.signed() - volume).abs() < 1e-15, "{shape:?} {found:?}");
            assert_eq!((found.positive_count(), found.negative_count()), (1, 0));
        }
        assert_eq!(cell_volumes(&Positions::default(), &[], &RaggedArray::new()), None);
    }

    proptest! {
        /// Two crooked hexahedra on a common side fill what their outer sides enclose.
        #[test]
        fn crooked_cells_leave_no_gap(shifts in prop::collection::vec(-0.2f64..0.2, 36)) {
            let flat: Vec<f64> = (0..12)
                .flat_map(|i| [(i % 4 == 1 || i % 4 == 2) as u8 as f64, (i % 4 > 1) as u8 as f64, f64::from(i / 4)])
                .zip(&shifts)
                .map(|(x, shift)| x + shift)
                .collect();
            let positions = Positions::from_flat(3, flat).unwrap();
            let cells = RaggedArray::from_lists([[0, 1, 2, 3, 4, 5, 6, 7], [4, 5, 6, 7, 8, 9, 10, 11]]);
            let shapes = vec![CellShape::Hexahedron; 2];
            let volumes = cell_volumes(&positions, &shapes, &cells).unwrap();
            let mesh = crate::cell_mesh::mesh::CellMesh::new(12, shapes, cells, &RaggedArray::new(), &[]).unwrap();
            let boundary = mesh.boundary_surface();
            let outer: Vec<f64> =
                boundary.vertices().iter().flat_map(|&v| positions.point(v).to_vec()).collect();
            let outer = Positions::from_flat(3, outer).unwrap();
            let enclosed = coface_geometry::enclosed_volume(&outer, boundary.mesh().polygons()).unwrap();
            prop_assert!((volumes.signed() - enclosed).abs() < 1e-12);
        }
    }
}
