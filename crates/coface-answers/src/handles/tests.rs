//! Handles of several components, knotted ones, and what is left when they are filled.

use super::{FillHandlesRequest, HandlesRequest};
use crate::answer::LoopKind;
use coface_algebra::RaggedArray;
use coface_complexes::surface::GeneralizedMap;
use coface_complexes::surface::samples::{cubes, drilled_cube, trefoil, tube};
use coface_geometry::Positions;
use coface_io::Model;
use proptest::prelude::*;

type Placed = (GeneralizedMap, Positions);

/// Surfaces beside each other as one model; some of them turned inside out.
fn model_of(surfaces: &[Placed], is_turned: bool) -> Model {
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for (map, positions) in surfaces {
        let first = (points.len() / 3) as u32;
        points.extend(positions.as_flat());
        for face in 0..map.face_count() {
            let sides = map.sides_of(coface_algebra::FaceId::new(face));
            let mut corners: Vec<u32> = sides.map(|side| first + map.source(side).to_u32()).collect();
            if is_turned {
                corners.reverse();
            }
            triangles.push(corners);
        }
    }
    Model::from_polygons(Positions::from_flat(3, points).unwrap(), RaggedArray::from_lists(triangles))
        .unwrap()
}

fn ring(center: f64, is_upright: bool) -> Placed {
    tube(
        move |t| match is_upright {
            true => [center + 2.0 * t.cos(), 0.1 + 1.2 * t.sin(), 1.6 * t.sin()],
            false => [center + 2.0 * t.cos(), 2.0 * t.sin(), 0.0],
        },
        [32, 8],
        0.5,
    )
}

#[test]
fn each_component_has_its_own_inside() {
    // Linked, and one inside of the other.
    let thin = tube(|t| [2.0 * t.cos(), 2.0 * t.sin(), 0.0], [32, 6], 0.2);
    for surfaces in [[ring(0.0, false), ring(2.0, true)], [ring(0.0, false), thin]] {
        for is_turned in [false, true] {
            let found = HandlesRequest::new().found(&model_of(&surfaces, is_turned), "rings").unwrap();
            assert_eq!((found.genus, found.handles.len()), (2, 2));
            let mut components: Vec<usize> = found.handles.iter().map(|handle| handle.component).collect();
            components.sort_unstable();
            assert_eq!(components, [0, 1]);
            assert!(found.handles.iter().all(|handle| handle.shorter == LoopKind::Handle));
            assert!(found.handles.iter().all(|handle| handle.handle.vertices.len() < 12));
        }
    }
}

#[test]
fn rings_and_knots_become_spheres() {
    for (surfaces, genus) in [
        (vec![ring(0.0, false)], 1),
        (vec![tube(trefoil, [90, 8], 0.3)], 1),
        (vec![ring(0.0, false), ring(2.0, true)], 2),
        (vec![ring(0.0, false), ring(9.0, false)], 2),
    ] {
        let model = model_of(&surfaces, false);
        let (filled, done) = FillHandlesRequest::new().filled(&model, "rings").unwrap();
        assert_eq!((done.before.genus, done.after.genus), (genus, 0), "{done:?}");
        assert_eq!(done.filled.len(), genus);
        assert!(done.left.is_empty() && done.after.closed && done.after.orientable);
        assert_eq!(done.after.euler_characteristic, 2 * surfaces.len() as i64);
        assert_eq!(done.after.f_vector[0], filled.vertex_count());
    }
}

#[test]
fn a_tunnel_is_filled_where_it_is_shorter() {
    // A plate with one small hole.
    let cells: Vec<[i32; 3]> =
        (0..49).map(|i| [i / 7, i % 7, 0]).filter(|&[x, y, _]| (x, y) != (3, 3)).collect();
    let model = model_of(&[cubes(&cells, 0)], false);
    let found = HandlesRequest::new().found(&model, "plate").unwrap();
    assert_eq!((found.genus, found.handles[0].shorter), (1, LoopKind::Tunnel));
    assert!((found.handles[0].length - 4.0).abs() < 1e-9);
    assert!(HandlesRequest::new().shorter_than(Some(4.0)).found(&model, "plate").unwrap().handles.is_empty());
    let (_, done) = FillHandlesRequest::new().shorter_than(4.5).filled(&model, "plate").unwrap();
    assert_eq!((done.after.genus, done.filled.len(), done.filled[0].kind), (0, 1, LoopKind::Tunnel));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn what_is_filled_is_a_surface_of_lower_genus(tunnels in 0u32..4096, turned in any::<u64>(), below in 3.0f64..9.0) {
        let model = model_of(&[cubes(&drilled_cube(tunnels), turned)], false);
        let (filled, done) = FillHandlesRequest::new().shorter_than(below).filled(&model, "cube").unwrap();
        prop_assert_eq!(done.before.genus, done.after.genus + done.filled.len());
        prop_assert!(done.after.closed && done.after.orientable);
        prop_assert!(done.filled.iter().all(|filled| filled.path.length < below));
        // The answer says what is left, and the same request again does no more.
        let (_, again) = FillHandlesRequest::new().shorter_than(below).filled(&filled, "cube").unwrap();
        prop_assert_eq!(&again.before, &done.after);
        if done.left.is_empty() {
            prop_assert!(again.filled.is_empty());
            let found = HandlesRequest::new().shorter_than(Some(below)).found(&filled, "cube").unwrap();
            prop_assert!(found.handles.is_empty());
        }
    }
}
