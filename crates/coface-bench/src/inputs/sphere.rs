//! The icosphere, and two of them.

use super::Mesh;
use coface::algebra::RaggedArray;
use std::collections::HashMap;

/// The icosahedron, its triangles cut into four `level` times, the vertices pushed to the unit sphere.
///
/// The vertices of a level are numbered after those of the level before, in the order in which the triangles meet
/// them, so neighbors are far apart in memory: no reader or builder profits from a tidy order.
pub(super) fn icosphere(level: usize) -> Mesh {
    let golden = f64::midpoint(1.0, 5f64.sqrt());
    let mut points: Vec<[f64; 3]> = Vec::new();
    for (a, b) in [(-1.0, golden), (1.0, golden), (-1.0, -golden), (1.0, -golden)] {
        points.push(unit([a, b, 0.0]));
    }
    for (a, b) in [(-1.0, golden), (1.0, golden), (-1.0, -golden), (1.0, -golden)] {
        points.push(unit([0.0, a, b]));
    }
    for (a, b) in [(golden, -1.0), (golden, 1.0), (-golden, -1.0), (-golden, 1.0)] {
        points.push(unit([a, 0.0, b]));
    }
    let mut triangles: Vec<[u32; 3]> = vec![
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    for _ in 0..level {
        let mut middles: HashMap<(u32, u32), u32> = HashMap::with_capacity(triangles.len() * 3 / 2);
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for [a, b, c] in triangles {
            let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(from, to)| {
                *middles.entry((from.min(to), from.max(to))).or_insert_with(|| {
                    let (p, q) = (points[from as usize], points[to as usize]);
                    points.push(unit([p[0] + q[0], p[1] + q[1], p[2] + q[2]]));
                    points.len() as u32 - 1
                })
            });
            finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    Mesh {
        vertex_count: points.len(),
        coordinates: points.concat(),
        lists: RaggedArray::from_lists(triangles),
    }
}

/// Two icospheres of radius 1 that overlap: the second is moved by (0.4, 0.03, 0.02), and its vertices and triangles come
/// after those of the first.
pub(super) fn overlapping_icospheres(level: usize) -> Mesh {
    let first = icosphere(level);
    let mut coordinates = first.coordinates.clone();
    let moved =
        first.coordinates.as_chunks::<3>().0.iter().flat_map(|p| [p[0] + 0.4, p[1] + 0.03, p[2] + 0.02]);
    coordinates.extend(moved);
    let mut lists = first.lists.clone();
    let shift = first.vertex_count as u32;
    for triangle in first.lists.iter() {
        lists.push(&[triangle[0] + shift, triangle[1] + shift, triangle[2] + shift]);
    }
    Mesh { vertex_count: 2 * first.vertex_count, coordinates, lists }
}

fn unit(p: [f64; 3]) -> [f64; 3] {
    let length = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    p.map(|x| x / length)
}
