//! Triangulations against their definition.

use super::RegularTriangulation;
use super::triangulation::weighted_points;
use crate::Positions;
use crate::predicates::{
    WeightedPoint, circle_side, orientation, smallest_sphere, spatial_orientation, sphere_side,
};
use proptest::prelude::*;
use std::collections::BTreeMap;

/// Points of a dimension, with weights or without: of a small grid, or of a line or a plane of it, or anywhere.
fn points() -> impl Strategy<Value = (usize, Vec<f64>, Option<Vec<f64>>)> {
    let coordinate = prop_oneof![
        3 => (0i32..4).prop_map(f64::from),
        1 => (0i32..1000).prop_map(|x| f64::from(x) * 0.001),
    ];
    let flat = (1usize..4, prop::collection::vec(coordinate, 0..60), 0usize..4);
    let flat = flat.prop_map(|(dimension, mut flat, kind)| {
        flat.truncate(flat.len() / dimension * dimension);
        for point in flat.chunks_mut(dimension) {
            match (kind, &mut *point) {
                // A line, and a plane.
                (0, [x, rest @ ..]) => {
                    rest.iter_mut().enumerate().for_each(|(i, y)| *y = *x * (i as f64 + 2.0));
                }
                (1, [x, y, z]) => *z = *x + *y,
                _ => {}
            }
        }
        (dimension, flat)
    });
    (flat, prop::option::of(prop::collection::vec(prop_oneof![Just(0.0), (0i32..5).prop_map(f64::from)], 60)))
        .prop_map(|((dimension, flat), weights)| {
            let count = flat.len() / dimension;
            (
                dimension,
                flat,
                weights.map(|mut weights| {
                    weights.truncate(count);
                    weights
                }),
            )
        })
}

/// Whether no point is inside of the sphere of a cell; points off the flat of the cells do not occur.
fn is_empty(cell: &[WeightedPoint], points: &[WeightedPoint]) -> bool {
    match *cell {
        [a] => points.iter().all(|q| q.point() == a.point() && q.weight() <= a.weight()),
        [_, _] => points.iter().all(|&q| crate::predicates::smallest_sphere_side(cell, q).is_le()),
        [_, _, _] => points.iter().all(|&q| crate::predicates::smallest_sphere_side(cell, q).is_le()),
        [a, b, c, d] => {
            let run = spatial_orientation(a.point(), b.point(), c.point(), d.point());
            assert!(run.is_ne(), "a flat cell");
            let positive = if run.is_lt() { [b, a, c, d] } else { [a, b, c, d] };
            points.iter().all(|&q| sphere_side(positive, q).is_le())
        }
        _ => panic!("too many corners"),
    }
}

/// The facets of the cells that are in one of them alone.
fn hull(triangulation: &RegularTriangulation) -> BTreeMap<Vec<u32>, usize> {
    let mut counts: BTreeMap<Vec<u32>, usize> = BTreeMap::new();
    for cell in triangulation.cells().iter() {
        for lacked in cell {
            *counts.entry(cell.iter().copied().filter(|id| id != lacked).collect()).or_default() += 1;
        }
    }
    counts
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]
    /// Invariant 120: cells have empty spheres, two at each inner facet; all other facets are on the convex hull.
    #[test]
    fn spheres_of_cells_are_empty((dimension, flat, weights) in points()) {
        let positions = Positions::from_flat(dimension, flat).unwrap();
        let found = RegularTriangulation::new(&positions, weights.as_deref()).unwrap();
        let all = weighted_points(&positions, weights.as_deref()).unwrap();
        let at = |ids: &[u32]| ids.iter().map(|&id| all[id as usize]).collect::<Vec<_>>();
        for cell in found.cells().iter() {
            prop_assert!(is_empty(&at(cell), &all), "{:?}", cell);
        }
        let facets = hull(&found);
        prop_assert!(facets.values().all(|&count| count <= 2));
        let is_used = |id: u32| found.cells().iter().any(|cell| cell.contains(&id));
        for id in 0..positions.len() as u32 {
            prop_assert_eq!(is_used(id), !found.hidden().iter().any(|hidden| hidden.index() == id as usize));
        }
        // On the hull all points are on one side.
        for (facet, _) in facets.iter().filter(|&(_, &count)| count == 1) {
            let corners = at(facet);
            let sides: Vec<_> = match (found.dimension(), &corners[..]) {
                (Some(3), &[a, b, c]) => {
                    all.iter().map(|q| spatial_orientation(a.point(), b.point(), c.point(), q.point())).collect()
                }
                (Some(2), &[a, b]) if dimension == 2 => {
                    let plane = |p: WeightedPoint| [p.point()[0], p.point()[1]];
                    all.iter().map(|&q| orientation(plane(a), plane(b), plane(q))).collect()
                }
                _ => continue,
            };
            prop_assert!(sides.iter().all(|side| side.is_ge()) || sides.iter().all(|side| side.is_le()));
        }
        if weights.is_none() {
            let mut places: Vec<[u64; 3]> = all.iter().map(|p| p.point().map(f64::to_bits)).collect();
            places.sort_unstable();
            places.dedup();
            prop_assert_eq!(places.len() + found.hidden().len(), all.len());
        }
    }

    /// The volume of the cells is that of the points' convex hull, which another insertion order has too.
    #[test]
    fn cells_fill_the_hull((dimension, flat, _) in points()) {
        let positions = Positions::from_flat(dimension, flat.clone()).unwrap();
        let mut points: Vec<&[f64]> = flat.chunks(dimension).collect();
        points.reverse();
        let turned = Positions::from_flat(dimension, points.concat()).unwrap();
        let size = |positions: &Positions| {
            let all = weighted_points(positions, None).unwrap();
            let found = RegularTriangulation::new(positions, None).unwrap();
            let volume = |cell: &[u32]| {
                let [a, b, c, d] = [0, 1, 2, 3].map(|i| all[cell[i] as usize].point());
                let [u, v, w] = [b, c, d].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
                crate::determinant(u, v, w).abs()
            };
            match found.dimension() {
                Some(3) => (found.dimension(), found.cells().iter().map(volume).sum::<f64>()),
                dimension => (dimension, 0.0),
            }
        };
        let (one, other) = (size(&positions), size(&turned));
        prop_assert_eq!(one.0, other.0);
        prop_assert!((one.1 - other.1).abs() < 1e-9);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    /// Invariant 123: points in another order, and all of them elsewhere, have the same cells.
    #[test]
    fn the_order_and_the_place_of_points_do_not_matter((dimension, flat, weights) in points(), turn in 0usize..60) {
        // Of equal points with equal weights the first one stays.
        let mut rows: Vec<(Vec<f64>, f64)> = flat
            .chunks(dimension)
            .enumerate()
            .map(|(i, point)| (point.to_vec(), weights.as_ref().map_or(0.0, |weights| weights[i])))
            .collect();
        rows.sort_by(|a, b| a.partial_cmp(b).unwrap());
        rows.dedup_by(|a, b| a.0 == b.0);
        let cells = |rows: &[(Vec<f64>, f64)], shift: f64| {
            let moved = rows.iter().flat_map(|(point, _)| point.iter().map(|x| (x * 1024.0).round() / 1024.0 + shift));
            let positions = Positions::from_flat(dimension, moved.collect()).unwrap();
            let weights: Vec<f64> = rows.iter().map(|row| row.1).collect();
            let found = RegularTriangulation::new(&positions, Some(&weights)).unwrap();
            let cell = |cell: &[u32]| {
                let mut cell: Vec<&(Vec<f64>, f64)> = cell.iter().map(|&id| &rows[id as usize]).collect();
                cell.sort_by(|a, b| a.partial_cmp(b).unwrap());
                cell.into_iter().cloned().collect::<Vec<_>>()
            };
            let mut cells: Vec<_> = found.cells().iter().map(cell).collect();
            cells.sort_by(|a, b| a.partial_cmp(b).unwrap());
            cells
        };
        let expected = cells(&rows, 0.0);
        let mut turned = rows.clone();
        if !turned.is_empty() {
            let turn = turn % turned.len();
            turned.rotate_left(turn);
        }
        prop_assert_eq!(&cells(&turned, 0.0), &expected);
        turned.reverse();
        prop_assert_eq!(cells(&turned, -5.0), expected);
    }
}

#[test]
fn a_grid_of_space() {
    let flat: Vec<f64> = (0..1000).flat_map(|i| [i / 100, i / 10 % 10, i % 10].map(f64::from)).collect();
    let positions = Positions::from_flat(3, flat).unwrap();
    let found = RegularTriangulation::new(&positions, None).unwrap();
    assert!(found.hidden().is_empty());
    let all = weighted_points(&positions, None).unwrap();
    for cell in found.cells().iter() {
        let corners: Vec<WeightedPoint> = cell.iter().map(|&id| all[id as usize]).collect();
        // Each cell is one of a cube.
        assert_eq!(smallest_sphere(&corners), 0.75);
    }
}

#[test]
fn all_sizes_of_numbers() {
    let flat = vec![0.0, 1e300, -1e300, 1e-300, 5e-324, 0.0, 1.0, 1e-170, 1e170, -1.0, 0.3, 0.1];
    let positions = Positions::from_flat(2, flat).unwrap();
    let found = RegularTriangulation::new(&positions, None).unwrap();
    let all = weighted_points(&positions, None).unwrap();
    for cell in found.cells().iter() {
        let [a, b, c] = [0, 1, 2].map(|i| all[cell[i] as usize]);
        let run = orientation(
            [a.point()[0], a.point()[1]],
            [b.point()[0], b.point()[1]],
            [c.point()[0], c.point()[1]],
        );
        let positive = if run.is_lt() { [b, a, c] } else { [a, b, c] };
        assert!(all.iter().all(|&q| circle_side(positive, q).is_le()));
    }
    assert!(found.hidden().is_empty());
}

#[test]
fn faults_are_named() {
    let fault = |dimension, weights: Option<&[f64]>| {
        let points = Positions::from_flat(dimension, vec![0.0; 12]).unwrap();
        RegularTriangulation::new(&points, weights).unwrap_err().to_string()
    };
    assert!(fault(4, None).contains("4 coordinates"));
    assert!(fault(3, Some(&[1.0])).contains("1 weights for 4 points"));
    assert!(fault(3, Some(&[1.0, 1.0, f64::NAN, 1.0])).contains("weight of point 2 is NaN"));
}
