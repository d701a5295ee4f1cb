//! Models that tests share.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use super::LarModel;
use coface_algebra::RaggedArray;

/// The unit cube with the cells of a cuboid grid: vertex 4x + 2y + z at (x, y, z).
pub(crate) fn cube() -> LarModel {
    grid([1, 1, 1])
}

/// The cuboid grid of this shape, found by listing: vertices with the last axis fastest, the cells of each degree by bit
/// strings of the axes along which they extend.
pub(crate) fn grid(shape: [u32; 3]) -> LarModel {
    let stride = [(shape[1] + 1) * (shape[2] + 1), shape[2] + 1, 1];
    let mut cells = vec![RaggedArray::new(), RaggedArray::new(), RaggedArray::new()];
    for pattern in 1u32..8 {
        let extends = [0, 1, 2].map(|axis| pattern >> (2 - axis) & 1);
        let count = [0, 1, 2].map(|axis| shape[axis] + 1 - extends[axis]);
        for x in 0..count[0] {
            for y in 0..count[1] {
                for z in 0..count[2] {
                    let base = x * stride[0] + y * stride[1] + z * stride[2];
                    let mut cell = vec![base];
                    for axis in 0..3 {
                        if extends[axis] == 1 {
                            cell = cell.iter().flat_map(|&v| [v, v + stride[axis]]).collect();
                        }
                    }
                    cell.sort_unstable();
                    cells[pattern.count_ones() as usize - 1].push(&cell);
                }
            }
        }
    }
    let vertex_count = shape.iter().map(|&n| n as usize + 1).product();
    LarModel::new(vertex_count, cells).unwrap()
}
