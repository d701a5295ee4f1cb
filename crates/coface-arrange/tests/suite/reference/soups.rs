//! Soups of polygons and of segments with small integers.

use super::Random;
use super::space::{Polygon, integer_cross, integer_dot};

/// The corners of flat shapes, the outer walk counterclockwise, holes clockwise.
const SHAPES: &[&[&[[i64; 2]]]] = &[
    &[&[[0, 0], [2, 0], [2, 2], [0, 2]]],
    &[&[[0, 0], [3, 0], [3, 1], [0, 1]]],
    &[&[[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]]],
    &[&[[0, 0], [3, 0], [3, 3], [2, 3], [2, 1], [1, 1], [1, 3], [0, 3]]],
    &[&[[0, 0], [3, 0], [3, 3], [0, 3]], &[[1, 1], [1, 2], [2, 2], [2, 1]]],
    &[&[[0, 0], [4, 0], [4, 4], [0, 4]], &[[1, 1], [1, 2], [2, 1]], &[[3, 2], [2, 3], [3, 3]]],
    &[&[[0, 0], [3, 0], [3, 3], [0, 3]], &[[0, 0], [1, 2], [2, 1]]],
    &[&[[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [0, 2]]],
    &[&[[1, 0], [3, 1], [2, 3], [0, 2]]],
];

fn point(random: &mut Random, low: i64, high: i64) -> [i64; 3] {
    [0; 3].map(|_| random.between(low, high))
}

fn triangle(random: &mut Random, low: i64, high: i64, input: usize) -> Polygon {
    Polygon { walks: vec![(0..3).map(|_| point(random, low, high)).collect()], input }
}

/// A tetrahedron with fronts outward; its corners may be in one plane.
pub(crate) fn tetrahedron(mut corners: [[i64; 3]; 4], input: usize) -> Vec<Polygon> {
    let [a, b, c, d] = corners;
    let edge = |p: [i64; 3]| [0, 1, 2].map(|i| p[i] - a[i]);
    if integer_dot(integer_cross(edge(b), edge(c)), edge(d)) < 0 {
        corners.swap(2, 3);
    }
    let [a, b, c, d] = corners;
    let triangles = [[a, c, b], [a, b, d], [b, c, d], [c, a, d]];
    triangles.map(|triangle| Polygon { walks: vec![triangle.to_vec()], input }).to_vec()
}

/// The six sides of a box, fronts outward.
pub(crate) fn cuboid(low: [i64; 3], high: [i64; 3], input: usize) -> Vec<Polygon> {
    let mut sides = Vec::new();
    for axis in 0..3 {
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        for (x, is_low) in [(low[axis], true), (high[axis], false)] {
            let corners = [[low[i], low[j]], [high[i], low[j]], [high[i], high[j]], [low[i], high[j]]];
            let mut walk: Vec<[i64; 3]> = corners
                .iter()
                .map(|&[u, v]| {
                    let mut corner = [x; 3];
                    (corner[i], corner[j]) = (u, v);
                    corner
                })
                .collect();
            if is_low {
                walk.reverse();
            }
            sides.push(Polygon { walks: vec![walk], input });
        }
    }
    sides
}

/// A flat shape in a plane in which it keeps integer corners.
fn shape(random: &mut Random, input: usize) -> Polygon {
    let walks = SHAPES[random.below(SHAPES.len() as u64) as usize];
    let (u, v) = loop {
        let (u, v) = (point(random, -1, 1), point(random, -1, 1));
        if integer_cross(u, v) != [0; 3] {
            break (u, v);
        }
    };
    let origin = point(random, 0, 3);
    let place = |[x, y]: [i64; 2]| [0, 1, 2].map(|i| origin[i] + x * u[i] + y * v[i]);
    let walks = walks.iter().map(|walk| walk.iter().map(|&corner| place(corner)).collect()).collect();
    Polygon { walks, input }
}

/// A closed input: a box, a tetrahedron, or a box with a box taken out of it.
fn solid(random: &mut Random, input: usize) -> Vec<Polygon> {
    match random.below(3) {
        0 => tetrahedron([0; 4].map(|_| point(random, 0, 4)), input),
        _ => {
            let low = point(random, 0, 3);
            let high = [0, 1, 2].map(|i| low[i] + random.between(1, 3));
            let mut sides = cuboid(low, high, input);
            if random.below(4) == 0 {
                // With a hollow, or a piece of the rim missing; possibly as large as the box.
                let inner = [0, 1, 2].map(|i| random.between(low[i], high[i] - 1));
                let outer = [0, 1, 2].map(|i| random.between(inner[i] + 1, high[i]));
                sides.extend(cuboid(inner, outer, input).iter().map(Polygon::reversed));
            }
            sides
        }
    }
}

/// Any polygons: triangles of which some have no area, shapes with holes, doubles; and the number of inputs, one a polygon.
pub(crate) fn sheets(seed: u64) -> (Vec<Polygon>, usize) {
    let mut random = Random::new(seed);
    let count = 2 + random.below(5) as usize;
    let kind = random.below(4);
    let mut polygons: Vec<Polygon> = (0..count)
        .map(|input| match kind {
            0 => triangle(&mut random, 0, 4, input),
            1 => triangle(&mut random, 0, 2, input),
            2 => shape(&mut random, input),
            _ if random.below(2) == 0 => triangle(&mut random, 0, 4, input),
            _ => shape(&mut random, input),
        })
        .collect();
    if random.below(3) == 0 {
        let again = &polygons[random.below(count as u64) as usize];
        let mut again = if random.below(2) == 0 { again.clone() } else { again.reversed() };
        again.walks[0].rotate_left(1);
        again.input = count;
        polygons.push(again);
    }
    let count = polygons.len();
    (polygons, count)
}

/// Triangles and tetrahedra in bad places: many in few planes, all through one point or line, nearly in one plane, small ones
/// beside large ones; each an input.
pub(crate) fn crowds(seed: u64) -> (Vec<Polygon>, usize) {
    const LARGE: i64 = 1 << 16;
    let mut random = Random::new(seed);
    let kind = random.below(7);
    let count = [10, 6, 6, 6, 5, 5, 4][kind as usize];
    let mut inputs: Vec<Vec<Polygon>> = Vec::new();
    for input in 0..count {
        let mut corner = || match kind {
            0 => point(&mut random, 0, 2),
            1 => point(&mut random, -LARGE, LARGE),
            2 => [0; 3].map(|_| [0, 1, 2, LARGE, LARGE + 1, -LARGE][random.below(6) as usize]),
            // Within one of a plane.
            4 => {
                let [x, y, z] = point(&mut random, -1, 1);
                let [u, v, _] = point(&mut random, -9, 9);
                [1000 * u + x, 1000 * v + y, 1000 * (u + v) + z]
            }
            5 => {
                let size = [1, 10, 10_000][random.below(3) as usize];
                point(&mut random, -3, 3).map(|x| x * size)
            }
            _ => point(&mut random, -3, 3),
        };
        let corners = [corner(), corner(), corner(), corner()];
        let opposite = |p: [i64; 3]| p.map(|x| -x);
        let walk = match kind {
            // Through the origin, where all of them cross.
            3 => vec![corners[0], corners[1], opposite(corners[0])],
            // With a side along the third axis.
            6 => vec![[0, 0, corners[0][2]], [0, 0, corners[0][2] + 2], corners[1]],
            _ => corners[..3].to_vec(),
        };
        inputs.push(match kind {
            0 | 3 | 6 => vec![Polygon { walks: vec![walk], input }],
            _ if input % 2 == 0 => tetrahedron(corners, input),
            _ => vec![Polygon { walks: vec![walk], input }],
        });
    }
    (inputs.concat(), count)
}

/// Closed inputs, and their number; some are there twice, some inside out.
pub(crate) fn solids(seed: u64) -> (Vec<Polygon>, usize) {
    let mut random = Random::new(seed);
    let count = 2 + random.below(2) as usize;
    let mut inputs: Vec<Vec<Polygon>> = (0..count).map(|input| solid(&mut random, input)).collect();
    if random.below(5) == 0 {
        let again = inputs[0].iter().map(|polygon| Polygon { input: count, ..polygon.clone() }).collect();
        inputs.push(again);
    }
    if random.below(5) == 0 {
        inputs[0] = inputs[0].iter().map(Polygon::reversed).collect();
    }
    let count = inputs.len();
    (inputs.concat(), count)
}

/// Closed rings between integers, mostly small, which may cross themselves and each other, and the region of each.
pub(crate) fn rings(seed: u64) -> (Vec<Vec<[i64; 2]>>, Vec<u32>) {
    let mut random = Random::new(seed);
    let count = 1 + random.below(4) as usize;
    let size = [2, 4, 6, 12, 1 << 20][random.below(5) as usize];
    let ring = |random: &mut Random| -> Vec<[i64; 2]> {
        let shift = [0; 2].map(|_| random.between(0, 6));
        match random.below(3) {
            0 => {
                let [w, h] = [0; 2].map(|_| random.between(1, size));
                let mut corners = [[0, 0], [w, 0], [w, h], [0, h]];
                if random.below(3) == 0 {
                    corners.reverse();
                }
                corners.iter().map(|p| [p[0] + shift[0], p[1] + shift[1]]).collect()
            }
            _ => {
                let corners = 1 + random.below(6);
                (0..corners).map(|_| [0, 1].map(|i| shift[i] + random.between(0, size))).collect()
            }
        }
    };
    let rings: Vec<_> = (0..count).map(|_| ring(&mut random)).collect();
    let regions = (0..count).map(|_| random.below(3) as u32).collect();
    (rings, regions)
}
