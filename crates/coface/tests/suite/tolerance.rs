//! Arrangements within a tolerance: features that nearly coincide become one, whatever the angle and the offset.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::spatial_arrangements::{Point, cuboid, moved, sorted, triangles_again, turned};
use coface::answers::answer::RemarkCode;
use coface::answers::{CongruentScene, SceneArrangement, SpatialRequest, SpatialScene, welded};
use coface::arrange::boolean::InsideRule;
use coface::arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
use coface::geometry::Positions;
use coface::io::Model;
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

/// Polygons as a model.
fn model(polygons: &SpatialPolygons) -> Model {
    Model::from_polygons(polygons.positions().clone(), polygons.walks().clone()).unwrap()
}

/// The rooms or boxes of one scene, each a model of its own, by congruence.
fn by_congruence(models: &[Model], tolerance: f64) -> CongruentScene {
    let named = models.iter().map(|model| ("room", model));
    CongruentScene::of_scene(SpatialScene::of(named, true).unwrap(), tolerance).unwrap()
}

#[test]
fn bonded_rooms_are_one_cell_each_by_congruence() {
    let straight = SpatialArrangement::new(&rooms(|p| p), &SpatialOptions::new()).unwrap();
    for degrees in [0.0, 17.3, 30.0, 45.0, 71.9] {
        let angle = degrees * TAU / 360.0;
        let found = by_congruence(&[model(&rooms(|p| turned(2, angle, turned(0, 0.2, p))))], TOLERANCE);
        assert_eq!(found.complex().f_vector(), straight.f_vector(), "{degrees}");
        assert!(found.volumes().iter().all(|volume| (volume - 30.0).abs() < 1e-9));
        let answer = found.answer(InsideRule::Nonzero).unwrap();
        assert!(answer.products_zero && answer.voids == 0 && answer.holes == 0);
        assert_eq!((answer.dangling_faces, answer.components), (0, 1));
        assert!(answer.inside.iter().all(|inputs| inputs == &[0]));
        if degrees == 0.0 {
            assert!(answer.rounding.valid && answer.joined.unwrap().classes.is_empty());
        }
        let done = answer.congruence.unwrap();
        // Faces between two rooms are of both.
        let sides = found.complex().boundary_matrix(3).unwrap().entry_count();
        assert_eq!(done.glued_f_vector[2], sides - found.complex().cell_count(2));
        assert!(done.largest_class_diameter < 1e-12, "{}", done.largest_class_diameter);
        // The cells are input again, and the mesh encloses them.
        let mesh = found.to_mesh(false, true).unwrap();
        assert_eq!(mesh.groups().len(), 32);
        assert!(found.to_chains().unwrap().remarks().is_empty());
    }
}

#[test]
fn a_hole_in_a_face_is_counted_and_cut_in_meshes() {
    let [outer, inner] = [[0.0, 4.0], [1.0, 2.0]].map(|[low, high]| {
        let low_corner = [low, low, if low == 0.0 { 0.0 } else { 4.0 }];
        model(&cuboid(low_corner, [high, high, low_corner[2] + high - low], |p| p))
    });
    let found = by_congruence(&[outer.clone(), inner.clone()], TOLERANCE);
    let answer = found.answer(InsideRule::Nonzero).unwrap();
    assert_eq!((&answer.f_vector[..], answer.holes), (&[16, 24, 12, 2][..], 1));
    assert_eq!(answer.inside, [[0], [1]]);
    let mesh = found.to_mesh(false, false).unwrap();
    assert_eq!(mesh.polygons().len(), 11 + 8);
    assert_eq!(found.to_mesh(true, false).unwrap().polygons().len(), 22 + 8);
    assert_eq!(found.to_chains().unwrap().remarks().len(), 1);
    // Without a tolerance one is taken from the extent, with a remark.
    let named = [("a", &outer), ("b", &inner)];
    let assumed = CongruentScene::of_scene(SpatialScene::of(named, true).unwrap(), None).unwrap();
    let again = assumed.answer(InsideRule::Nonzero).unwrap();
    assert_eq!((again.f_vector, again.remarks[0].code), (answer.f_vector, RemarkCode::ToleranceAssumed));
    // A tolerance that is none, and a polygon that is not flat, by its number in its own file.
    let scene = || SpatialScene::of([("a", &outer), ("b", &inner)], true).unwrap();
    assert!(CongruentScene::of_scene(scene(), -1.0).is_err());
    assert!(CongruentScene::of_scene(scene(), f64::NAN).is_err());
    let mut bent = inner.positions().as_flat().to_vec();
    bent[2] += 0.25;
    let bent =
        Model::from_polygons(Positions::from_flat(3, bent).unwrap(), inner.polygons().clone()).unwrap();
    let scene = SpatialScene::of([("a", &outer), ("bent", &bent)], true).unwrap();
    let error = CongruentScene::of_scene(scene, TOLERANCE).unwrap_err().to_string();
    assert!(error.starts_with("bent: polygon ") && error.contains("not flat"), "{error}");
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

    /// Boxes at random places have clear features: both methods have the same cells, and the same inputs around them.
    #[test]
    fn congruence_has_the_cells_of_the_exact_method(
        places in prop::collection::vec((prop::array::uniform3(0.0..3.0), prop::array::uniform3(0.4..2.0)), 1..5),
        angles in prop::collection::vec(0.0..TAU, 4),
    ) {
        let models: Vec<Model> = places
            .iter()
            .zip(&angles)
            .map(|(&(low, size), &angle)| {
                let high = [0, 1, 2].map(|axis| low[axis] + size[axis]);
                model(&cuboid(low, high, |p| turned(2, angle, turned(1, angle / 2.0, p))))
            })
            .collect();
        let found = by_congruence(&models, 1e-9);
        let named = models.iter().map(|model| ("room", model));
        let exact = SceneArrangement::of(named, &SpatialRequest::default()).unwrap();
        prop_assert_eq!(found.complex().f_vector(), exact.complex().f_vector());
        let cells = |volumes: &[f64], inside: &[Vec<usize>]| {
            let mut cells: Vec<(Vec<usize>, i64)> = inside
                .iter()
                .zip(volumes)
                .map(|(inside, volume)| (inside.clone(), (volume * 1e6).round() as i64))
                .collect();
            cells.sort();
            cells
        };
        let [by_congruence, exactly] = [found.answer(InsideRule::Nonzero), exact.answer(InsideRule::Nonzero)]
            .map(|answer| answer.unwrap());
        prop_assert_eq!(
            cells(&by_congruence.measures, &by_congruence.inside),
            cells(&exactly.measures, &exactly.inside)
        );
        prop_assert_eq!(by_congruence.holes, exactly.holes);
    }

    /// Copies of points that are moved by less than the radius become their points again, in any order, and none goes
    /// farther than the radius.
    #[test]
    fn merged_vertices_do_not_depend_on_their_order(
        noise in prop::collection::vec(prop::array::uniform3(-1.0..1.0), 256),
        angle in 0.0..TAU,
    ) {
        let rooms = rooms(|p| turned(2, angle, p));
        let flat = rooms.positions().as_flat().iter().zip(noise.as_flattened());
        let flat: Vec<f64> = flat.map(|(x, noise)| x + noise * 1e-7).collect();
        let count = flat.len() / 3;
        let reversed: Vec<f64> = flat.chunks_exact(3).rev().flatten().copied().collect();
        let lists = rooms.walks().iter().map(|walk| walk.iter().map(|v| count as u32 - 1 - v).collect::<Vec<u32>>());
        let given = Model::from_polygons(Positions::from_flat(3, flat).unwrap(), rooms.walks().clone()).unwrap();
        let other = Model::from_polygons(
            Positions::from_flat(3, reversed).unwrap(),
            coface::algebra::RaggedArray::from_lists(lists),
        )
        .unwrap();
        let [(first, done), (second, again)] = [welded(&given, 1e-6).unwrap(), welded(&other, 1e-6).unwrap()];
        prop_assert_eq!(done.merged_count(), again.merged_count());
        prop_assert_eq!(done.largest_movement(), again.largest_movement());
        prop_assert!(done.largest_movement() <= 1e-6);
        let points = |model: &Model| {
            let mut points = model.positions().as_flat().as_chunks::<3>().0.to_vec();
            points.sort_by(|x, y| x.partial_cmp(y).unwrap());
            points
        };
        prop_assert_eq!(points(&first), points(&second));
        // Twice is once.
        prop_assert_eq!(welded(&first, 1e-6).unwrap().1.merged_count(), 0);
        prop_assert_eq!(first.polygons().len(), 192);
    }

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
