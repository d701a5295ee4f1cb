//! The torus with seven vertices, embedded.

use super::{CellKind, PlacedCells};
use coface_algebra::Error;
use coface_algebra::RaggedArray;
use coface_geometry::Positions;

/// The polyhedron of Csaszar: the torus with 7 vertices, 21 edges, every two vertices an edge, and 14 flat triangles that do not
/// cross. The half turn about the third axis takes it to itself; the normal looks outward.
///
/// The triangles are $\\{i, i + 1, i + 3\\}$ and $\\{i, i + 2, i + 3\\}$ modulo 7.
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// A. Csaszar, *A polyhedron without diagonals* (1949).
///
/// # Examples
/// ```
/// let torus = coface_complexes::shapes::csaszar_torus()?;
/// assert_eq!(torus.chain_complex()?.f_vector(), [7, 21, 14]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn csaszar_torus() -> Result<PlacedCells, Error> {
    const CORNERS: [[i8; 3]; 7] =
        [[3, -3, 0], [3, 3, 1], [1, 2, 3], [-1, -2, 3], [-3, -3, 1], [-3, 3, 0], [0, 0, 15]];
    let positions = Positions::from_flat(3, CORNERS.as_flattened().iter().map(|&x| f64::from(x)).collect())?;
    let triangles = (0..7u32).flat_map(|i| [[i, i + 1, i + 3], [i, i + 3, i + 2]].map(|t| t.map(|v| v % 7)));
    PlacedCells::new(positions, CellKind::Simplex, 2, RaggedArray::from_lists(triangles))
}
