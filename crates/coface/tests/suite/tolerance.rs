//! Arrangements within a tolerance: features that nearly coincide become one, whatever the angle and the offset.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::spatial_arrangements::{Point, cuboid, moved, sorted, triangles_again, turned};
use coface::arrange::boolean::InsideRule;
use coface::arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
use proptest::prelude::*;
use std::f64::consts::TAU;

const TOLERANCE: f64 = 1e-6;

/// Rooms of 4 x 3 x 2.5 in two storeys of four rows, each row half a room further than the one before: walls meet in
/// the shape of a T.
fn rooms(motion: impl Fn(Point) -> Point) -> SpatialPolygons {
    let room = |number: usize| {
        let (column, row, storey) = (number % 4, number / 4 % 4, number / 16);
        let low = [4.0 * column as f64 + 2.0 * (row % 2) as f64, 3.0 * row as f64, 2.5 * storey as f64];
        cuboid(low, [low[0] + 4.0, low[1] + 3.0, low[2] + 2.5], &motion)
    };
    SpatialPolygons::joined(&(0..32).map(room).collect::<Vec<_>>()).unwrap()
}

fn within(polygons: &SpatialPolygons, tolerance: f64) -> SpatialArrangement {
    SpatialArrangement::new(polygons, &SpatialOptions::new().tolerance(tolerance)).unwrap()
}

#[test]
fn bonded_rooms_are_one_cell_each() {
    let straight = SpatialArrangement::new(&rooms(|p| p), &SpatialOptions::new()).unwrap();
    assert_eq!(straight.f_vector()[3], 32);
    for degrees in [17.3, 30.0] {
        let angle = degrees * TAU / 360.0;
        let rooms = rooms(|p| turned(2, angle, p));
        let exact = SpatialArrangement::new(&rooms, &SpatialOptions::new()).unwrap();
        assert!(exact.f_vector()[3] > 32, "{:?}", exact.f_vector());
        let joined = within(&rooms, TOLERANCE);
        assert_eq!(joined.f_vector(), straight.f_vector(), "{degrees}");
        triangles_again(&joined);
        assert!(joined.joined().unwrap().largest_movement < 1e-12);
    }
}

#[test]
fn offsets_within_the_tolerance_vanish() {
    let angle = 17.3 * TAU / 360.0;
    let box_at = |offset: f64| {
        cuboid([0.0; 3], [1.0, 2.0, 3.0], |p| moved([offset; 3], turned(2, angle, turned(0, 0.3, p))))
    };
    let both = SpatialPolygons::joined(&[box_at(0.0), box_at(1e-9)]).unwrap();
    let joined = within(&both, TOLERANCE);
    assert_eq!(joined.f_vector(), [8, 12, 6, 1]);
    assert_eq!(joined.inside(InsideRule::Nonzero).unwrap(), [[0, 1]]);
    let found = joined.joined().unwrap();
    assert_eq!((found.classes.len(), found.counts.vertices), (8, 8));
    // Each vertex went to another one, not further than the tolerance.
    assert!(found.largest_movement <= TOLERANCE && found.largest_movement >= 1e-9);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn rooms_at_any_angle_and_offset(angle in 0.0..TAU, tilt in -0.5..0.5, is_far: bool) {
        // An offset as in a national grid, where the last place is a tenth of a micrometre.
        let offset = if is_far { [513_000.7, 5_403_000.3, 412.1] } else { [0.0; 3] };
        let rooms = rooms(|p| moved(offset, turned(0, tilt, turned(2, angle, p))));
        let joined = within(&rooms, TOLERANCE);
        prop_assert_eq!(joined.f_vector()[3], 32);
        prop_assert!(joined.volumes().unwrap().iter().all(|volume| (volume - 30.0).abs() < 1e-4));
        prop_assert_eq!(joined.joined().unwrap().tolerance, TOLERANCE);
        triangles_again(&joined);
    }

    #[test]
    fn noise_below_the_tolerance_changes_no_cells(
        angle in 0.0..TAU,
        noise in prop::collection::vec(prop::array::uniform3(-1.0..1.0), 256),
    ) {
        let quiet = within(&rooms(|p| turned(2, angle, p)), 0.01);
        let rooms = rooms(|p| turned(2, angle, p));
        let flat = rooms.positions().as_flat().iter().zip(noise.as_flattened());
        // A quarter of the tolerance along the diagonal.
        let flat = flat.map(|(x, noise)| x + noise * 0.0025 / 3f64.sqrt()).collect();
        let noisy = SpatialPolygons::new(
            coface::geometry::Positions::from_flat(3, flat).unwrap(),
            rooms.walks().clone(),
            rooms.polygon_of_walk().to_vec(),
        )
        .unwrap()
        .with_inputs(rooms.input_of_polygon().to_vec())
        .unwrap();
        let joined = within(&noisy, 0.01);
        prop_assert_eq!(joined.f_vector(), quiet.f_vector());
        triangles_again(&joined);
        let volumes = sorted(joined.volumes().unwrap());
        prop_assert!(volumes.iter().all(|volume| (volume - 30.0).abs() < 0.5));
    }

    #[test]
    fn the_order_of_inputs_does_not_matter(
        offsets in prop::collection::vec(prop::array::uniform3(-1e-7..1e-7), 5),
        angle in 0.0..TAU,
    ) {
        let boxes: Vec<SpatialPolygons> = offsets
            .iter()
            .map(|&by| cuboid([0.0; 3], [1.0; 3], |p| moved(by, turned(1, angle, p))))
            .collect();
        let mut reversed = boxes.clone();
        reversed.reverse();
        let [first, second] =
            [boxes, reversed].map(|own| within(&SpatialPolygons::joined(&own).unwrap(), TOLERANCE));
        prop_assert_eq!(first.f_vector(), [8, 12, 6, 1]);
        let points = |own: &SpatialArrangement| {
            let mut points = own.positions().as_flat().as_chunks::<3>().0.to_vec();
            points.sort_by(|x, y| x.partial_cmp(y).unwrap());
            points
        };
        prop_assert_eq!(points(&first), points(&second));
    }
}
