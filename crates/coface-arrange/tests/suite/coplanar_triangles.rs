//! Triangles in one plane put together: with the same surface, closed as before, in the fewest triangles.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::RaggedArray;
use coface_arrange::spatial::{
    SpatialArrangement, SpatialOptions, SpatialPolygons, merge_coplanar_triangles,
};
use coface_geometry::Positions;
use proptest::prelude::*;
use std::collections::BTreeMap;

/// The boundary of some unit cubes of a grid, each square cut into two triangles.
fn surface_of(cubes: &[[i32; 3]]) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let mut numbers: BTreeMap<[i32; 3], u32> = BTreeMap::new();
    let mut points = Vec::new();
    let mut triangles = Vec::new();
    for &cube in cubes {
        for axis in 0..3 {
            for side in [0, 1] {
                let mut beyond = cube;
                beyond[axis] += 2 * side - 1;
                if cubes.contains(&beyond) {
                    continue;
                }
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                let mut corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| {
                    let mut corner = cube;
                    corner[axis] += side;
                    corner[i] += x;
                    corner[j] += y;
                    *numbers.entry(corner).or_insert_with(|| {
                        points.push(corner.map(f64::from));
                        points.len() as u32 - 1
                    })
                });
                if side == 0 {
                    corners.reverse();
                }
                let [a, b, c, d] = corners;
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    (points, triangles)
}

fn positions(points: &[[f64; 3]]) -> Positions {
    Positions::from_flat(3, points.as_flattened().to_vec()).unwrap()
}

/// The triangles that are left, and whether there was anything to put together.
fn merged(points: &[[f64; 3]], triangles: &[[u32; 3]], tolerance: f64) -> (Vec<[u32; 3]>, bool) {
    match merge_coplanar_triangles(&positions(points), triangles, tolerance, |_| true).unwrap().merged() {
        None => (triangles.to_vec(), false),
        Some(found) => (found.triangles, true),
    }
}

fn volume(points: &[[f64; 3]], triangles: &[[u32; 3]]) -> f64 {
    let term = |own: &[u32; 3]| {
        let [a, b, c] = own.map(|corner| points[corner as usize]);
        (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]))
            / 6.0
    };
    triangles.iter().map(term).sum()
}

/// How often each side is there without the opposite one.
fn rim(triangles: &[[u32; 3]]) -> BTreeMap<[u32; 2], i32> {
    let mut sides = BTreeMap::new();
    for &[a, b, c] in triangles {
        for [x, y] in [[a, b], [b, c], [c, a]] {
            *sides.entry([x.min(y), x.max(y)]).or_insert(0) += if x < y { 1 } else { -1 };
        }
    }
    sides.retain(|_, count| *count != 0);
    sides
}

/// The numbers of vertices, edges, faces and cells, and the volumes.
fn cells(points: &[[f64; 3]], triangles: &[[u32; 3]]) -> (usize, Vec<f64>) {
    let polygons =
        SpatialPolygons::from_polygons(positions(points), RaggedArray::from_lists(triangles)).unwrap();
    let found = SpatialArrangement::new(&polygons, &SpatialOptions::new()).unwrap();
    (found.f_vector()[3], found.volumes().unwrap())
}

fn turned(points: &[[f64; 3]], [turn, other]: [f64; 2]) -> Vec<[f64; 3]> {
    let ((s, c), (t, d)) = (turn.sin_cos(), other.sin_cos());
    let turned = |&[x, y, z]: &[f64; 3]| {
        let [x, y] = [c * x - s * y, s * x + c * y];
        [x, d * y - t * z, t * y + d * z]
    };
    points.iter().map(turned).collect()
}

fn block(sizes: [i32; 3]) -> Vec<[i32; 3]> {
    let [n, m, l] = sizes;
    (0..n).flat_map(|x| (0..m).flat_map(move |y| (0..l).map(move |z| [x, y, z]))).collect()
}

#[test]
fn a_block_of_cubes_has_twelve_triangles() {
    let (points, triangles) = surface_of(&block([3, 4, 2]));
    assert_eq!(triangles.len(), 2 * 2 * (12 + 6 + 8));
    let (left, _) = merged(&points, &triangles, 0.0);
    assert_eq!((left.len(), volume(&points, &left)), (12, 24.0));
    assert_eq!(merged(&points, &left, 0.0), (left.clone(), false));
    // A tunnel leaves two faces with a hole of 8 triangles, and 16 around.
    let mut tunnel = block([3, 3, 2]);
    tunnel.retain(|cube| cube[..2] != [1, 1]);
    let (points, triangles) = surface_of(&tunnel);
    let (left, _) = merged(&points, &triangles, 0.0);
    assert_eq!((left.len(), volume(&points, &left)), (32, 16.0));
    // A turned one has as few within its rounding, and is never drawn otherwise if that is not allowed.
    let there = turned(&points, [0.3, 1.1]);
    let (own, _) = merged(&there, &triangles, 1e-14);
    assert_eq!(own.len(), 32);
    assert!((volume(&there, &own) - 16.0).abs() < 1e-13);
    assert_eq!(cells(&there, &own).0, 1);
}

/// A slab thinner than the distance is not put together with itself.
#[test]
fn a_thin_slab_stays_closed() {
    let (mut points, triangles) = surface_of(&block([3, 3, 1]));
    points.iter_mut().for_each(|point| point[2] *= 1e-15);
    let (left, _) = merged(&points, &triangles, 4e-15);
    assert!(rim(&left).is_empty() && left.len() >= 12);
    assert!((volume(&points, &left) / 9e-15 - 1.0).abs() < 1e-9);
}

/// A surface with a rim keeps it, corners and all, and so does one where three faces meet in a line.
#[test]
fn rims_and_walls_stay() {
    let (points, all) = surface_of(&block([2, 2, 2]));
    let open = &all[1..];
    let (left, _) = merged(&points, open, 0.0);
    assert_eq!(rim(&left), rim(open));
    assert!((volume(&points, &left) - volume(&points, open)).abs() < 1e-12);
    let mut walled = all.clone();
    let number = |place: [f64; 3]| points.iter().position(|&point| point == place).unwrap() as u32;
    // Two triangles inside, on the middle of four sides.
    let [a, b, c, d] = [[1., 0., 0.], [1., 2., 0.], [1., 2., 2.], [1., 0., 2.]].map(number);
    walled.extend([[a, b, c], [a, c, d]]);
    let (left, _) = merged(&points, &walled, 0.0);
    assert_eq!(rim(&left), rim(&walled));
    assert_eq!(cells(&points, &left), cells(&points, &walled));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Cubes of a grid at random, turned or not: the cells are those of before, the sides without another one too.
    #[test]
    fn merged_surfaces_enclose_the_same_cells(
        mut cubes in prop::collection::btree_set(prop::array::uniform3(0..4), 1..40),
        turns in prop::option::of(prop::array::uniform2(0.0..6.3)),
    ) {
        cubes.insert([0; 3]);
        let cubes: Vec<[i32; 3]> = cubes.into_iter().collect();
        let (mut points, triangles) = surface_of(&cubes);
        let mut tolerance = 0.0;
        if let Some(turns) = turns {
            (points, tolerance) = (turned(&points, turns), 64.0 * f64::EPSILON);
        }
        let (left, is_changed) = merged(&points, &triangles, tolerance);
        prop_assert!(left.len() <= triangles.len());
        prop_assert_eq!(rim(&left), rim(&triangles));
        let (before, after) = (cells(&points, &triangles), cells(&points, &left));
        if turns.is_none() {
            prop_assert_eq!(before, after);
        } else {
            prop_assert!(!is_changed || before.0 >= after.0);
            let sum = |volumes: &[f64]| volumes.iter().sum::<f64>();
            prop_assert!((sum(&before.1) - sum(&after.1)).abs() < 1e-12);
        }
        // Again, nothing is left to put together.
        prop_assert_eq!(merged(&points, &left, tolerance).0.len(), left.len());
    }
}
