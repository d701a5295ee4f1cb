//! Cells that were made by rule, as models.

use super::{Model, Structure};
use crate::algebra::RaggedArray;
use crate::cellular::{CellKind, CellShape, PlacedCells, turn_cell};
use crate::geometry::Positions;
use crate::{Error, VertexId};

impl Model {
    /// The model of these cells and positions.
    ///
    /// Points become points, segments lines of two vertices, triangles and squares polygons (a square by its cycle), simplices and
    /// cuboids of dimension 3 tetrahedra and hexahedra. Cells of the dimension of the space around them are turned so
    /// that they are positive: polygons in the plane run counterclockwise, 3-cells are as [`CellShape`] describes. Other cells
    /// keep their orientation.
    ///
    /// No mesh holds cells of dimension 4 and more: simplices become the structure [`Structure::Facets`], cuboids
    /// [`Structure::Chains`], the chain complex of [`PlacedCells::chain_complex`]. Neither has positions.
    ///
    /// # Errors
    /// [`crate::ErrorKind::TooLarge`] beyond $2^{32}$ incidences.
    ///
    /// # Complexity
    /// Linear up to dimension 3; beyond it that of [`PlacedCells::chain_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface::algebra::RaggedArray;
    /// use coface::cellular::{CellKind, PlacedCells};
    /// use coface::geometry::Positions;
    /// use coface::io::Model;
    /// # fn main() -> Result<(), coface::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 0., 1., 1., 0., 1., 1.])?;
    /// let cells = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let square = PlacedCells::new(corners, CellKind::Cuboid, 2, cells)?;
    /// assert_eq!(Model::from_placed_cells(square)?.polygons().list(0), [0, 2, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn from_placed_cells(placed: PlacedCells) -> Result<Self, Error> {
        let (kind, dimension) = (placed.kind(), placed.dimension());
        if dimension > 3 {
            return Ok(Self::from_structure(match kind {
                CellKind::Simplex => Structure::Facets(placed.into_parts().1),
                CellKind::Cuboid => Structure::Chains(placed.chain_complex()?),
            }));
        }
        let (positions, cells) = placed.into_parts();
        let mut model = Self { vertex_count: positions.len(), positions, ..Self::default() };
        model.add_cells(kind, dimension, &cells);
        debug_assert_eq!(model.check(), Ok(()));
        Ok(model)
    }

    /// Adds cells of dimension 3 or less on vertices of the model.
    pub(crate) fn add_cells(&mut self, kind: CellKind, dimension: usize, cells: &RaggedArray) {
        let is_full = self.positions.dimension() == dimension;
        for list in cells.iter() {
            let mut cell = [0u32; 8];
            let cell = &mut cell[..list.len()];
            cell.copy_from_slice(list);
            if is_full && volume_sign(&self.positions, kind, cell) < 0.0 {
                turn_cell(kind, cell);
            }
            let reorder = |order: &[usize]| -> Vec<u32> { order.iter().map(|&i| cell[i]).collect() };
            match (dimension, kind) {
                (0, _) => self.points.push(VertexId::from_u32(cell[0])),
                (1, _) => self.lines.push(cell),
                (2, CellKind::Simplex) => self.polygons.push(cell),
                (2, CellKind::Cuboid) => self.polygons.push(&reorder(&SQUARE)),
                (_, CellKind::Simplex) => {
                    self.shapes.push(CellShape::Tetrahedron);
                    self.cells.push(cell);
                }
                (_, CellKind::Cuboid) => {
                    self.shapes.push(CellShape::Hexahedron);
                    self.cells.push(&reorder(&CUBE));
                }
            }
        }
    }
}

/// The cycle of a square by its local vertices: 00, 10, 11, 01.
const SQUARE: [usize; 4] = [0, 2, 3, 1];
/// The vertices of a cube as a hexahedron lists them: the cycle of the first two axes below, then above.
const CUBE: [usize; 8] = [0, 4, 6, 2, 1, 5, 7, 3];

/// A number with the sign of the volume of a cell of full dimension, up to rounding: of a simplex the determinant of its
/// edges at the first vertex, of a cuboid that of the mean edges along its axes.
fn volume_sign(positions: &Positions, kind: CellKind, cell: &[u32]) -> f64 {
    let dimension = positions.dimension();
    let point = |local: usize| positions.point(VertexId::from_u32(cell[local]));
    let mut edges = [[0.0; 3]; 3];
    for (axis, edge) in edges.iter_mut().enumerate().take(dimension) {
        for (k, x) in edge.iter_mut().enumerate().take(dimension) {
            *x = match kind {
                CellKind::Simplex => point(axis + 1)[k] - point(0)[k],
                CellKind::Cuboid => {
                    let bit = 1 << (dimension - 1 - axis);
                    (0..cell.len()).map(|i| if i & bit == 0 { -point(i)[k] } else { point(i)[k] }).sum()
                }
            };
        }
    }
    let [a, b, c] = edges;
    match dimension {
        1 => a[0],
        2 => a[0] * b[1] - a[1] * b[0],
        3 => {
            a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0])
        }
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cellular::cell_volumes;

    fn cube(dimension: usize) -> Positions {
        let corner = |i: usize| (0..dimension).map(move |axis| (i >> (dimension - 1 - axis) & 1) as f64);
        Positions::from_flat(dimension, (0..1 << dimension).flat_map(corner).collect()).unwrap()
    }

    fn model(kind: CellKind, dimension: usize, space: usize, cells: &[&[u32]]) -> Model {
        let cells = RaggedArray::from_lists(cells);
        Model::from_placed_cells(PlacedCells::new(cube(space), kind, dimension, cells).unwrap()).unwrap()
    }

    fn volume(model: &Model) -> f64 {
        cell_volumes(model.positions(), model.shapes(), model.cells()).unwrap().signed()
    }

    #[test]
    fn cells_of_full_dimension_are_positive() {
        for mirrored in [false, true] {
            let cell: Vec<u32> = (0..8).map(|i| if mirrored { i ^ 2 } else { i }).collect();
            let hexahedron = model(CellKind::Cuboid, 3, 3, &[&cell]);
            assert_eq!(volume(&hexahedron), 1.0, "{cell:?}");
        }
        let five: [&[u32]; 5] = [&[0, 1, 2, 4], &[3, 1, 2, 7], &[5, 1, 4, 7], &[6, 2, 4, 7], &[1, 2, 4, 7]];
        assert!((volume(&model(CellKind::Simplex, 3, 3, &five)) - 1.0).abs() < 1e-12);
        let squares = model(CellKind::Cuboid, 2, 2, &[&[1, 0, 3, 2], &[0, 1, 2, 3]]);
        assert_eq!(squares.polygons(), &RaggedArray::from_lists([[3, 1, 0, 2], [0, 2, 3, 1]]));
    }

    #[test]
    fn lower_cells_keep_their_orientation() {
        let squares = model(CellKind::Cuboid, 2, 3, &[&[0, 1, 2, 3], &[0, 2, 1, 3]]);
        assert_eq!(squares.polygons(), &RaggedArray::from_lists([[0, 2, 3, 1], [0, 1, 3, 2]]));
        let segments = model(CellKind::Cuboid, 1, 2, &[&[3, 1]]);
        assert_eq!(segments.lines(), &RaggedArray::from_lists([[3, 1]]));
        let points = model(CellKind::Simplex, 0, 2, &[&[2]]);
        assert_eq!((points.points(), points.vertex_count()), (&[VertexId::new(2)][..], 4));
    }

    #[test]
    fn higher_cells_become_structures() {
        let simplices = model(CellKind::Simplex, 4, 4, &[&[0, 1, 2, 4, 8]]);
        assert_eq!(
            simplices.structure(),
            Some(&Structure::Facets(RaggedArray::from_lists([[0, 1, 2, 4, 8]])))
        );
        let all: Vec<u32> = (0..16).collect();
        let tesseract = model(CellKind::Cuboid, 4, 4, &[&all]);
        let Some(Structure::Chains(complex)) = tesseract.structure() else { panic!("no chains") };
        assert_eq!(complex.f_vector(), [16, 32, 24, 8, 1]);
    }
}
