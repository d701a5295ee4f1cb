//! Many boxes: in a row, in a block, around each other, one cut with the next, and the rooms of a building.

use super::Mesh;
use super::random_simplices::random_values;
use coface::algebra::RaggedArray;

/// Two triangles a side, counterclockwise seen from outside.
const TRIANGLES: [[u32; 3]; 12] = [
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
];

type Corners = [[f64; 3]; 8];

fn mesh_of(boxes: impl Iterator<Item = Corners>) -> Mesh {
    let (mut coordinates, mut lists) = (Vec::new(), Vec::new());
    for corners in boxes {
        let first = (coordinates.len() / 3) as u32;
        coordinates.extend(corners.as_flattened());
        lists.extend(TRIANGLES.iter().flatten().map(|corner| first + corner));
    }
    let lists = RaggedArray::uniform(3, lists).expect("three corners a triangle");
    Mesh { vertex_count: coordinates.len() / 3, coordinates, lists }
}

fn corners(low: [f64; 3], high: [f64; 3]) -> Corners {
    std::array::from_fn(|i| {
        std::array::from_fn(|axis| if i >> axis & 1 == 0 { low[axis] } else { high[axis] })
    })
}

/// Unit cubes with gaps of one half, along x.
pub(super) fn row(count: usize) -> Mesh {
    let cube = |i: usize| {
        let low = 1.5 * i as f64;
        corners([low, 0.0, 0.0], [low + 1.0, 1.0, 1.0])
    };
    mesh_of((0..count).map(cube))
}

/// Unit cubes with gaps of one half, as many along all axes as there need to be.
pub(super) fn block(count: usize) -> Mesh {
    let side = (1..).find(|side: &usize| side.pow(3) >= count).expect("some cube is as large");
    let cube = |i: usize| {
        let low = [i % side, i / side % side, i / side / side].map(|place| 1.5 * place as f64);
        corners(low, low.map(|x| x + 1.0))
    };
    mesh_of((0..count).map(cube))
}

/// Cubes around one middle, the smallest first.
pub(super) fn dolls(count: usize) -> Mesh {
    mesh_of((1..=count).map(|i| corners([-(i as f64); 3], [i as f64; 3])))
}

/// Boxes around the middle, each turned about two axes: all meet.
pub(super) fn turned(count: usize) -> Mesh {
    let random = random_values(8 * count);
    let (values, _) = random.as_chunks::<8>();
    mesh_of(values.iter().map(|value| {
        let middle: [f64; 3] = std::array::from_fn(|i| 2.0 * value[i] - 1.0);
        let half: [f64; 3] = std::array::from_fn(|i| 0.3 + 0.6 * value[3 + i]);
        let ((s, c), (t, d)) = ((6.3 * value[6]).sin_cos(), (6.3 * value[7]).sin_cos());
        corners(half.map(|x| -x), half).map(|[x, y, z]| {
            let [x, y] = [c * x - s * y, s * x + c * y];
            let [y, z] = [d * y - t * z, t * y + d * z];
            [x + middle[0], y + middle[1], z + middle[2]]
        })
    }))
}

/// Rooms of 4 by 3 by 2.5 in rows that are shifted like bricks, turned by 30 degrees: the corners of one row are in the
/// middle of sides of the next.
pub(super) fn rooms(count: usize) -> Mesh {
    let width = count.isqrt().max(1);
    let (s, c) = 30f64.to_radians().sin_cos();
    let room = |i: usize| {
        let (row, place) = (i / width, i % width);
        let low = [4.0 * place as f64 + 2.0 * (row % 2) as f64, 3.0 * row as f64, 0.0];
        corners(low, [low[0] + 4.0, low[1] + 3.0, 2.5]).map(|[x, y, z]| [c * x - s * y, s * x + c * y, z])
    };
    mesh_of((0..count).map(room))
}
