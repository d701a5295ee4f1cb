//! Cells between copies of cells in layers.

use super::lattice::check_size;
use super::{CellKind, PlacedCells, turn_cell};
use coface_algebra::{Error, VertexId};
use coface_algebra::{RaggedArray, Sign};
use coface_geometry::Positions;

/// Appends the coordinates of the copy of a point in a layer.
pub(super) type PlaceInLayer<'a> = &'a dyn Fn(&[f64], u32, &mut Vec<f64>);

/// The product of cells with so many steps up: layer k has the copies $v + k n$ of the n vertices, where `place` puts them. The
/// orientation is that of the cells followed by the direction up.
///
/// Simplices are cut along the rising order of their vertices, so that neighbors fit: with $s_0 < \dots < s_d$ below and
/// $s'_0, \dots, s'_d$ above, the pieces are $s_0 \dots s_i s'_i \dots s'_d$.
pub(super) fn layered(
    base: &PlacedCells,
    layers: u32,
    space: usize,
    place: PlaceInLayer<'_>,
) -> Result<PlacedCells, Error> {
    let (kind, dimension) = (base.kind(), base.dimension());
    let count = base.vertex_count() as u32;
    check_size(&[count.saturating_sub(1), layers], CellKind::Cuboid)?;
    let pieces = if kind == CellKind::Simplex { dimension as u32 + 1 } else { 1 };
    check_size(&[base.cell_count() as u32, layers, pieces], CellKind::Cuboid)?;
    let mut coordinates = Vec::with_capacity(space * base.vertex_count() * (layers as usize + 1));
    for layer in 0..=layers {
        for vertex in 0..count {
            place(base.positions().point(VertexId::from_u32(vertex)), layer, &mut coordinates);
        }
    }
    let width = kind.vertex_count(dimension + 1).expect("a prism over a cell has few vertices");
    let mut items = Vec::new();
    for layer in 0..layers {
        let (below, above) = (layer * count, (layer + 1) * count);
        for cell in base.cells().iter() {
            if kind == CellKind::Cuboid {
                items.extend(cell.iter().flat_map(|v| [v + below, v + above]));
                continue;
            }
            let mut sorted = cell.to_vec();
            sorted.sort_unstable();
            let rises: usize =
                (0..cell.len()).map(|i| cell[..i].iter().filter(|&&v| v > cell[i]).count()).sum();
            for i in 0..=dimension {
                let start = items.len();
                items.extend(sorted[..=i].iter().map(|v| v + below));
                items.extend(sorted[i..].iter().map(|v| v + above));
                // The step up stands before the last dimension - i steps of the cell.
                if Sign::power_of_minus_one(rises + dimension - i) == Sign::Minus {
                    turn_cell(kind, &mut items[start..]);
                }
            }
        }
    }
    let cells = if items.is_empty() { RaggedArray::new() } else { RaggedArray::uniform(width, items)? };
    Ok(PlacedCells::from_trusted(Positions::from_flat(space, coordinates)?, kind, dimension + 1, cells))
}
