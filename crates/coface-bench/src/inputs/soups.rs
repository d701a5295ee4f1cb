//! Meshes taken apart: every polygon has vertices of its own, a little off.

use super::{Mesh, sphere};
use coface::algebra::RaggedArray;

/// Numbers from 0 to 1, the same on every machine.
pub(super) struct Noise(u64);

impl Noise {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(super) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// The icosphere with three vertices for each triangle, each coordinate off by up to 1e-9.
pub(super) fn exploded_icosphere(level: usize) -> Mesh {
    let mesh = sphere::icosphere(level);
    let mut noise = Noise::new(7);
    let coordinates: Vec<f64> = mesh
        .lists
        .items()
        .iter()
        .flat_map(|&vertex| [0, 1, 2].map(|axis| mesh.coordinates[3 * vertex as usize + axis]))
        .map(|x| x + (noise.next() - 0.5) * 2e-9)
        .collect();
    separate(coordinates, 3)
}

/// A grid of `side` by `side` by `side` unit cubes, each of six squares with four vertices of their own, each coordinate off by
/// up to 1e-8.
pub(super) fn separate_cubes(side: usize) -> Mesh {
    const SQUARES: [[usize; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut noise = Noise::new(7);
    let mut coordinates = Vec::with_capacity(72 * side * side * side);
    for cube in 0..side * side * side {
        let corner = [cube % side, cube / side % side, cube / side / side];
        for vertex in SQUARES.as_flattened() {
            for (axis, corner) in corner.iter().enumerate() {
                coordinates.push((corner + (vertex >> axis & 1)) as f64 + (noise.next() - 0.5) * 2e-8);
            }
        }
    }
    separate(coordinates, 4)
}

/// Polygons of `width` vertices each, one after the other.
fn separate(coordinates: Vec<f64>, width: usize) -> Mesh {
    let vertex_count = coordinates.len() / 3;
    let polygons = (0..vertex_count as u32)
        .step_by(width)
        .map(|first| (first..first + width as u32).collect::<Vec<u32>>());
    Mesh { vertex_count, coordinates, lists: RaggedArray::from_lists(polygons) }
}
