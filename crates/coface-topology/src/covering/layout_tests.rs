//! Layouts: isometric copies, no face turned over.

use super::tests::{cover_of, map_of, polygon, split_edges, subdivided, without_faces};
use super::{CoverExtent, CoverLayout, CoverPlane, UniversalCover};
use coface_algebra::Sign;
use coface_algebra::{EdgeId, FaceId, VertexId};
use coface_complexes::known_spaces;
use coface_complexes::surface::GeneralizedMap;
use proptest::prelude::*;
use std::f64::consts::PI;

/// The model in which geodesics are straight.
fn straight(layout: &CoverLayout) -> Vec<[f64; 2]> {
    let bend = |[x, y]: [f64; 2]| match layout.plane() {
        CoverPlane::Hyperbolic => [x, y].map(|z| 2.0 * z / (1.0 + x * x + y * y)),
        _ => [x, y],
    };
    layout.points().iter().map(|&point| bend(point)).collect()
}

/// Twice the signed areas of the faces, counted as they lie in copy 0.
fn areas(cover: &UniversalCover, layout: &CoverLayout) -> Vec<f64> {
    let above = GeneralizedMap::new(cover.skeleton().clone()).unwrap();
    let points = straight(layout);
    let signs = above.orientation().signs().to_vec();
    let first = first_sign(cover, &points);
    let polygons = cover.polygons();
    let areas = polygons.iter().zip(signs).map(|(corners, sign)| {
        let next = corners.iter().cycle().skip(1);
        let area: f64 = corners
            .iter()
            .zip(next)
            .map(|(&a, &b)| [points[a as usize], points[b as usize]])
            .map(|[p, q]| p[0] * q[1] - p[1] * q[0])
            .sum();
        area * f64::from(sign.to_i32())
    });
    areas.map(|area| area * first).collect()
}

/// The side of the first face; all others must have the same.
fn first_sign(cover: &UniversalCover, points: &[[f64; 2]]) -> f64 {
    let polygons = cover.polygons();
    let corners = polygons.list(0);
    let [p, q, r] = [0, 1, 2].map(|i| points[corners[i] as usize]);
    ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])).signum()
}

fn check(name: &str, map: &GeneralizedMap, cover: &UniversalCover, layout: &CoverLayout) {
    assert_eq!(layout.points().len(), cover.f_vector()[0]);
    // Above one edge all edges have the same length.
    let mut lengths = vec![None; map.f_vector()[1]];
    for edge in (0..cover.f_vector()[1]).map(EdgeId::new) {
        let [a, b] = cover.skeleton().edge(edge);
        let length = layout.distance(a, b);
        let known = *lengths[cover.edge_below(edge).index()].get_or_insert(length);
        assert!((length - known).abs() < 1e-6 * (1.0 + known), "{name}: {length} and {known} above one edge");
    }
    for (face, area) in areas(cover, layout).into_iter().enumerate() {
        assert!(area > 0.0, "{name}: face {face} is turned over, {area}");
    }
    if layout.plane() == CoverPlane::Hyperbolic {
        assert!(layout.points().iter().all(|[x, y]| x * x + y * y < 1.0));
    }
}

#[test]
fn flat_layouts_are_embedded() {
    let octahedron = map_of(&known_spaces::cross_polytope_boundary(2).unwrap());
    let plane = map_of(&known_spaces::projective_plane().unwrap());
    let surfaces = [
        ("torus", map_of(&known_spaces::cyclic_torus(2).unwrap())),
        ("torus grid", map_of(&known_spaces::torus_grid(&[5, 3]).unwrap())),
        ("square torus", polygon(&[1, 2, -1, -2])),
        ("Klein bottle", map_of(&known_spaces::small_klein_bottle().unwrap())),
        ("Klein grid", map_of(&known_spaces::klein_grid(4, 3).unwrap())),
        ("square Klein bottle", polygon(&[1, 2, 1, -2])),
        ("annulus", without_faces(&octahedron, &[0, 7]).unwrap()),
        ("fine annulus", without_faces(&split_edges(&split_edges(&octahedron)), &[5, 77]).unwrap()),
        ("Moebius band", without_faces(&plane, &[3]).unwrap()),
        ("fine Moebius band", without_faces(&split_edges(&plane), &[8]).unwrap()),
    ];
    for (name, map) in &surfaces {
        let cover = cover_of(map, 0, CoverExtent::Radius(2));
        let layout = cover.layout(map, None).unwrap();
        assert_eq!(layout.plane(), CoverPlane::Flat);
        check(name, map, &cover, &layout);
        let weights: Vec<f64> = (0..map.f_vector()[1]).map(|edge| 1.0 + (edge * 7 % 5) as f64).collect();
        check(name, map, &cover, &cover.layout(map, Some(&weights)).unwrap());
    }
}

#[test]
fn the_grid_torus_is_a_lattice_of_area_one() {
    let map = map_of(&known_spaces::torus_grid(&[3, 3]).unwrap());
    let cover = cover_of(&map, 0, CoverExtent::Copies(1));
    let layout = cover.layout(&map, None).unwrap();
    let total: f64 = areas(&cover, &layout).iter().sum();
    assert!((total / 2.0 - 1.0).abs() < 1e-9, "{total}");
    // Squares with one diagonal each: springs along it make hexagons regular, so all edges are alike.
    for edge in (0..cover.f_vector()[1]).map(EdgeId::new) {
        let [a, b] = cover.skeleton().edge(edge);
        assert!((layout.distance(a, b).powi(2) - 2.0 / (9.0 * 3f64.sqrt())).abs() < 1e-9);
    }
}

#[test]
fn hyperbolic_layouts_are_embedded_and_have_the_area_of_gauss_and_bonnet() {
    let surfaces = [
        ("genus 2", subdivided(&[1, 2, -1, -2, 3, 4, -3, -4]), -2),
        ("opposite sides", subdivided(&[1, 2, 3, 4, -1, -2, -3, -4]), -2),
        ("three crosscaps", subdivided(&[1, 1, 2, 2, 3, 3]), -1),
        ("handle and crosscap", subdivided(&[1, 2, -1, -2, 3, 3]), -1),
        ("fine", split_edges(&subdivided(&[1, 2, 3, -2, 1, -3])), -1),
        ("genus 3", subdivided(&[1, 2, -1, -2, 3, 4, -3, -4, 5, 6, -5, -6]), -4),
    ];
    for (name, map, characteristic) in &surfaces {
        let cover = cover_of(map, 0, CoverExtent::Radius(1));
        for weights in
            [None, Some((0..map.f_vector()[1]).map(|edge| 1.0 + (edge * 7 % 5) as f64).collect::<Vec<_>>())]
        {
            let layout = cover.layout(map, weights.as_deref()).unwrap();
            check(name, map, &cover, &layout);
            let faces = (0..cover.f_vector()[2] / cover.copy_count()).map(FaceId::new);
            let area: f64 = faces.map(|face| hyperbolic_area(&cover, &layout, face)).sum();
            let expected = -2.0 * PI * f64::from(*characteristic);
            assert!((area - expected).abs() < 1e-6, "{name}: {area} instead of {expected}");
        }
    }
}

/// The area of a triangle: what its angles lack of a half turn.
fn hyperbolic_area(cover: &UniversalCover, layout: &CoverLayout, face: FaceId) -> f64 {
    let polygons = cover.polygons();
    let corners: Vec<VertexId> =
        polygons.list(face.index()).iter().map(|&vertex| VertexId::from_u32(vertex)).collect();
    let [a, b, c] = [0, 1, 2].map(|i| layout.distance(corners[(i + 1) % 3], corners[(i + 2) % 3]));
    let angle = |opposite: f64, x: f64, y: f64| {
        ((x.cosh() * y.cosh() - opposite.cosh()) / (x.sinh() * y.sinh())).clamp(-1.0, 1.0).acos()
    };
    PI - angle(a, b, c) - angle(b, c, a) - angle(c, a, b)
}

#[test]
fn the_octagon_is_regular() {
    let map = polygon(&[1, 2, -1, -2, 3, 4, -3, -4]);
    let cover = cover_of(&map, 0, CoverExtent::Radius(2));
    let layout = cover.layout(&map, None).unwrap();
    let polygons = cover.polygons();
    // Copy 0 has its corners on a circle around the origin, with angles of an eighth of a turn.
    for &corner in polygons.list(0) {
        let [x, y] = layout.points()[corner as usize];
        assert!((x.hypot(y) - 2f64.powf(-0.25)).abs() < 1e-9);
    }
    check("octagon", &map, &cover, &layout);
}

#[test]
fn what_has_no_layout_is_refused() {
    let sphere = map_of(&known_spaces::simplex_boundary(2).unwrap());
    let cover = cover_of(&sphere, 0, CoverExtent::Radius(0));
    let message = cover.layout(&sphere, None).unwrap_err().to_string();
    assert!(message.contains("closed surfaces with Euler characteristic 2"), "{message}");
    let torus = map_of(&known_spaces::cyclic_torus(2).unwrap());
    let cover = cover_of(&torus, 0, CoverExtent::Radius(1));
    assert!(
        cover.layout(&torus, Some(&[1.0; 20])).unwrap_err().message().contains("20 weights for 21 edges")
    );
    let mut weights = [1.0; 21];
    weights[4] = -1.0;
    assert!(
        cover.layout(&torus, Some(&weights)).unwrap_err().message().contains("edge e4 has the weight -1")
    );
    assert!(cover.layout(&polygon(&[1, 2, -1, -2]), None).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]
    #[test]
    fn any_positive_weights_embed(which in 0usize..4, weights in prop::collection::vec(0.2f64..5.0, 300)) {
        let map = match which {
            0 => map_of(&known_spaces::torus_grid(&[4, 3]).unwrap()),
            1 => map_of(&known_spaces::klein_grid(4, 3).unwrap()),
            2 => subdivided(&[1, 1, 2, 2, 3, 3]),
            _ => subdivided(&[1, 2, -1, -2, 3, 4, -3, -4]),
        };
        let weights: Vec<f64> = weights.into_iter().cycle().take(map.f_vector()[1]).collect();
        let cover = cover_of(&map, 0, CoverExtent::Radius(1));
        check("weighted", &map, &cover, &cover.layout(&map, Some(&weights)).unwrap());
    }
}

#[test]
fn signs_of_isometries_are_those_of_copies() {
    let map = polygon(&[1, 2, 1, -2]);
    let cover = cover_of(&map, 0, CoverExtent::Radius(2));
    let above = GeneralizedMap::new(cover.skeleton().clone()).unwrap();
    let minus = above.orientation().signs().iter().filter(|&&sign| sign == Sign::Minus).count();
    assert!(minus > 0 && minus < cover.copy_count());
}
