//! Drawings in the plane: segments, and pairs of sets of rings that are laid over each other.
//!
//! A drawing is stored with three coordinates a point; the third is the number of the region that a ring belongs to.

use super::Mesh;
use super::soups::Noise;
use coface::algebra::RaggedArray;
use std::f64::consts::PI;

/// `count` segments of one length from uniform points of the unit square in uniform directions, seed 42; about eight crossings
/// a segment unless `length` says otherwise.
pub(super) fn random_segments(count: usize, length: Option<f64>) -> Mesh {
    let length = length.unwrap_or_else(|| (8.0 * PI / count as f64).sqrt());
    let mut noise = Noise::new(42);
    let mut coordinates = Vec::with_capacity(6 * count);
    for _ in 0..count {
        let [x, y, turn] = [0; 3].map(|_| noise.next());
        let (sine, cosine) = (PI * turn).sin_cos();
        coordinates.extend([x, y, 0.0, x + length * cosine, y + length * sine, 0.0]);
    }
    let lists = RaggedArray::from_lists((0..count as u32).map(|s| [2 * s, 2 * s + 1]));
    Mesh { vertex_count: 2 * count, coordinates, lists }
}

/// Two polygons of `count` vertices each whose radii are displaced at midpoints, level by level: two simple closed curves that
/// cross each other some dozen times, more often on finer levels: 33, 59 and 82 times with 1e4, 1e5 and 1e6 vertices.
pub(super) fn coastlines(count: usize) -> Mesh {
    /// How much less each level displaces than the one before it.
    const ROUGHNESS: f64 = 0.8;
    let ring = |seed: u64| {
        let mut noise = Noise::new(seed);
        let levels = count.next_power_of_two().trailing_zeros();
        let size = 1usize << levels;
        let mut radii = vec![0.0; size];
        let mut amplitude = 0.16;
        let mut step = size;
        while step > 1 {
            for middle in (step / 2..size).step_by(step) {
                let mean = 0.5 * (radii[middle - step / 2] + radii[(middle + step / 2) % size]);
                radii[middle] = mean + amplitude * (noise.next() - 0.5);
            }
            amplitude *= 0.5f64.powf(ROUGHNESS);
            step /= 2;
        }
        let radius = move |i: usize| {
            let at = i as f64 * size as f64 / count as f64;
            let (below, part) = (at.floor() as usize, at.fract());
            0.6 + radii[below % size] * (1.0 - part) + radii[(below + 1) % size] * part
        };
        (0..count).map(move |i| polar(2.0 * PI * i as f64 / count as f64, radius(i))).collect::<Vec<_>>()
    };
    rings(&[vec![ring(37)], vec![ring(42)]])
}

/// Two polygons of `count` vertices each with random radii between a half and 1; the second is turned by half a step.
pub(super) fn stars(count: usize) -> Mesh {
    let ring = |seed: u64, turn: f64| {
        let mut noise = Noise::new(seed);
        let corner = |i: usize| polar(2.0 * PI * (i as f64 + turn) / count as f64, 0.5 + 0.5 * noise.next());
        (0..count).map(corner).collect::<Vec<_>>()
    };
    rings(&[vec![ring(7, 0.0)], vec![ring(8, 0.5)]])
}

/// Two polygons of `count` vertices each with random radii between a half and 1, at random angles within their steps.
pub(super) fn random_stars(count: usize) -> Mesh {
    let ring = |seed: u64| {
        let mut noise = Noise::new(seed);
        let mut corner = |i: usize| {
            let angle = 2.0 * PI * (i as f64 + noise.next() - 0.75) / count as f64;
            polar(angle, 0.5 + 0.5 * noise.next())
        };
        (0..count).map(&mut corner).collect::<Vec<_>>()
    };
    rings(&[vec![ring(7)], vec![ring(8)]])
}

/// Two regular polygons of `count` vertices each with radius 1; the second is turned a little and moved by (0.5, 0.1).
pub(super) fn circles(count: usize) -> Mesh {
    let ring = |turn: f64, center: [f64; 2]| {
        let corner = |i: usize| {
            let [x, y] = polar(2.0 * PI * i as f64 / count as f64 + turn, 1.0);
            [x + center[0], y + center[1]]
        };
        (0..count).map(corner).collect::<Vec<_>>()
    };
    rings(&[vec![ring(0.0, [0.0, 0.0])], vec![ring(0.01, [0.5, 0.1])]])
}

/// Two polygons of `count` vertices each with radii 0.9 and 1 in turns; the second is turned by 1.1 half steps and moved a little.
pub(super) fn gears(count: usize) -> Mesh {
    let ring = |turn: f64, center: [f64; 2]| {
        let corner = |i: usize| {
            let radius = if i.is_multiple_of(2) { 0.9 } else { 1.0 };
            let [x, y] = polar((2.0 * PI * i as f64 + turn * PI) / count as f64, radius);
            [x + center[0], y + center[1]]
        };
        (0..count).map(corner).collect::<Vec<_>>()
    };
    rings(&[vec![ring(0.0, [0.0, 0.0])], vec![ring(1.1, [0.0003, 0.0002])]])
}

/// Two polygons of `count` vertices each, the knots of flowers of half as many lobes, with radii 1.2 and 0.8 in turns; the second is
/// turned by 0.7 of the angle that is a radian over the lobes, and moved by (0.01, 0.02).
pub(super) fn flowers(count: usize) -> Mesh {
    let ring = |turn: f64, center: [f64; 2]| {
        let knot = |i: usize| {
            let radius = if i.is_multiple_of(2) { 1.2 } else { 0.8 };
            let [x, y] = polar(2.0 * (PI * i as f64 + turn) / count as f64, radius);
            [x + center[0], y + center[1]]
        };
        (0..count).map(knot).collect::<Vec<_>>()
    };
    rings(&[vec![ring(0.0, [0.0, 0.0])], vec![ring(0.7, [0.01, 0.02])]])
}

/// A grid of about `count / 4` squares of side 70 at distances of 100, and the same moved by (30, 37): edges of the two lie on one
/// another where one ends and another begins.
pub(super) fn grids(count: usize) -> Mesh {
    let side = ((count as f64 / 4.0).sqrt().round() as usize).max(1);
    let grid = |shift: [usize; 2]| {
        let square = |cell: usize| {
            let [x, y] = [cell % side * 100 + shift[0], cell / side * 100 + shift[1]];
            [[x, y], [x + 70, y], [x + 70, y + 70], [x, y + 70]]
                .map(|corner| corner.map(|x| x as f64))
                .to_vec()
        };
        (0..side * side).map(square).collect::<Vec<_>>()
    };
    integer_rings(&[grid([0, 0]), grid([30, 37])], 1.0)
}

/// `count` squares around one center, turned by 0.3 radians, every second one clockwise, at equal distances.
pub(super) fn nested_squares(count: usize) -> Mesh {
    let square = |i: usize| {
        let radius = (i + 1) as f64 / count as f64;
        let corner = |turn: usize| polar(0.3 + 0.5 * PI * turn as f64, radius);
        (0..4).map(|turn| corner(if i.is_multiple_of(2) { turn } else { 3 - turn })).collect::<Vec<_>>()
    };
    rings(&[(0..count).map(square).collect(), Vec::new()])
}

/// A grid of about `count / 4` squares that cover 0.49 of a square of side 1.4, and the same turned by half a radian.
pub(super) fn squares(count: usize) -> Mesh {
    let side = ((count as f64 / 4.0).sqrt().round() as usize).max(1);
    let pitch = 1.4 / side as f64;
    let grid = |turn: f64| {
        let (sine, cosine) = turn.sin_cos();
        let square = move |cell: usize| {
            let corner = [cell % side, cell / side].map(|i| i as f64 * pitch - 0.7 + 0.15 * pitch);
            [[0.0, 0.0], [0.7, 0.0], [0.7, 0.7], [0.0, 0.7]]
                .map(|[x, y]| [corner[0] + x * pitch, corner[1] + y * pitch])
                .map(|[x, y]| [x * cosine - y * sine, x * sine + y * cosine])
                .to_vec()
        };
        (0..side * side).map(square).collect::<Vec<_>>()
    };
    rings(&[grid(0.0), grid(0.5)])
}

fn polar(angle: f64, radius: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    [radius * cosine, radius * sine]
}

/// The rings of two regions on the grid of multiples of 2^-27, as integers.
fn rings(regions: &[Vec<Vec<[f64; 2]>>; 2]) -> Mesh {
    integer_rings(regions, f64::from(1u32 << 27))
}

/// The rings of two regions, scaled and rounded to integers.
fn integer_rings(regions: &[Vec<Vec<[f64; 2]>>; 2], scale: f64) -> Mesh {
    let (mut coordinates, mut lists) = (Vec::new(), RaggedArray::new());
    for (ring, region) in
        regions.iter().zip([0.0, 1.0]).flat_map(|(rings, z)| rings.iter().map(move |r| (r, z)))
    {
        let first = coordinates.len() as u32 / 3;
        for &[x, y] in ring {
            coordinates.extend([(x * scale).round(), (y * scale).round(), region]);
        }
        lists.push(&(first..first + ring.len() as u32).collect::<Vec<_>>());
    }
    Mesh { vertex_count: coordinates.len() / 3, coordinates, lists }
}
