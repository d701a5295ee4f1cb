//! Universal covers of all sorts of surfaces.

use super::{CoverExtent, UniversalCover};
use crate::curves::{CutSurface, TreeCotree};
use crate::groups::Ball;
use coface_algebra::Sign;
use coface_algebra::{FaceId, VertexId};
use coface_complexes::known_spaces;
use coface_complexes::simplicial::SimplicialComplex;
use coface_complexes::surface::GeneralizedMap;
pub(super) use coface_complexes::surface::samples::{polygon, without_faces};
use proptest::prelude::*;
use std::collections::{BTreeSet, HashSet};

pub(super) fn map_of(space: &SimplicialComplex) -> GeneralizedMap {
    GeneralizedMap::new(space.freeze().two_skeleton().unwrap()).unwrap()
}

/// A polygon triangulated from its center twice over: a simplicial surface.
pub(super) fn subdivided(letters: &[i32]) -> GeneralizedMap {
    let count = letters.iter().map(|letter| letter.unsigned_abs()).max().unwrap();
    map_of(&known_spaces::presentation_complex(count, &[letters.to_vec()]).unwrap())
}

pub(super) fn cover_of(map: &GeneralizedMap, component: usize, extent: CoverExtent) -> UniversalCover {
    let cut = CutSurface::new(map, &TreeCotree::new(map));
    UniversalCover::new(map, &cut, component, extent, 1_000_000).unwrap()
}

/// All that must hold of a cover.
fn check(map: &GeneralizedMap, cover: &UniversalCover) {
    let above = GeneralizedMap::new(cover.skeleton().clone()).unwrap();
    assert_eq!(above.component_count(), 1);
    assert_eq!(
        cover.euler_characteristic(),
        if cover.is_complete() && map.boundary_loops().is_empty() { 2 } else { 1 }
    );
    assert_eq!(above.orientation().conflicts(), [None]);
    let loops = above.boundary_loops();
    let is_closed = cover.is_complete() && map.boundary_loops().is_empty();
    assert_eq!(loops.len(), usize::from(!is_closed));
    // The projection is a map of surfaces.
    for side in above.sides() {
        let (face, below) = (above.face(side), cover.face_below(above.face(side)));
        let place = side.index() - above.sides_of(face).next().unwrap().index();
        let side_below = map.sides_of(below).nth(place).unwrap();
        assert_eq!(cover.edge_below(above.edge(side)), map.edge(side_below));
        assert_eq!(above.step(side) & 1, map.step(side_below) & 1);
        assert_eq!(cover.vertex_below(above.source(side)), map.source(side_below));
    }
    // It is a local isomorphism: around each vertex the fan goes to the fan below, corner by corner, once.
    let mut is_outer = vec![false; above.f_vector()[0]];
    for &(side, _) in loops.iter().flatten() {
        is_outer[above.source(side).index()] = true;
        is_outer[above.target(side).index()] = true;
    }
    let corner_below = |flag: u32| {
        let side = coface_algebra::HalfedgeId::from_u32(flag >> 1);
        let place = side.index() - above.sides_of(above.face(side)).next().unwrap().index();
        let below = map.sides_of(cover.face_below(above.face(side))).nth(place).unwrap();
        2 * below.to_u32() + (flag & 1)
    };
    let mut degree_below = vec![0; map.f_vector()[0]];
    for side in map.sides() {
        degree_below[map.source(side).index()] += 1;
    }
    let mut seen = vec![BTreeSet::new(); above.f_vector()[0]];
    for side in above.sides() {
        assert!(
            seen[above.source(side).index()].insert(corner_below(2 * side.to_u32())),
            "a corner above twice"
        );
    }
    for (vertex, corners) in seen.iter().enumerate() {
        let below = cover.vertex_below(VertexId::new(vertex));
        if !is_outer[vertex] {
            assert_eq!(corners.len(), degree_below[below.index()]);
        }
    }
    // A vertex is its source and its deck transformation: nothing is missing and nothing folded by chance.
    let keys: HashSet<_> = (0..above.f_vector()[0])
        .map(VertexId::new)
        .map(|v| (cover.vertex_below(v), cover.vertex_element(v)))
        .collect();
    assert_eq!(keys.len(), above.f_vector()[0]);
    // Copies are as many as the group has elements.
    let group_ball = Ball::first(cover.group(), cover.copy_count());
    assert_eq!(group_ball.sphere_sizes(), cover.sphere_sizes());
    let face_count = cover.f_vector()[2] / cover.copy_count();
    for face in (0..cover.f_vector()[2]).map(FaceId::new) {
        assert_eq!(cover.face_copy(face), face.index() / face_count);
    }
    assert_eq!(cover.letters().len(), cover.group().generator_count());
    // Around the unit, the letters lead to the copies of their words.
    for (copy, element) in cover.copies().elements().iter().enumerate() {
        assert_eq!(cover.copies().number(element), Some(copy));
        assert_eq!(cover.copy_word(copy).len(), cover.copies().length(copy));
    }
}

/// Closed and bounded surfaces, orientable and not.
fn surfaces() -> Vec<(&'static str, GeneralizedMap)> {
    let octagon = [1, 2, -1, -2, 3, 4, -3, -4];
    vec![
        ("sphere", map_of(&known_spaces::cross_polytope_boundary(2).unwrap())),
        ("projective plane", map_of(&known_spaces::projective_plane().unwrap())),
        ("torus", map_of(&known_spaces::cyclic_torus(2).unwrap())),
        ("torus grid", map_of(&known_spaces::torus_grid(&[4, 3]).unwrap())),
        ("square torus", polygon(&[1, 2, -1, -2])),
        ("Klein bottle", map_of(&known_spaces::small_klein_bottle().unwrap())),
        ("square Klein bottle", polygon(&[1, 2, 1, -2])),
        ("two crosscaps", polygon(&[1, 1, 2, 2])),
        ("octagon", polygon(&octagon)),
        ("genus 2", subdivided(&octagon)),
        ("three crosscaps", subdivided(&[1, 1, 2, 2, 3, 3])),
        ("hexagon", polygon(&[1, 2, -1, -2, 3, 3])),
        ("disk", map_of(&known_spaces::simplex(2).unwrap())),
        ("strip", map_of(&known_spaces::triangle_strip(7).unwrap())),
        (
            "annulus",
            without_faces(&map_of(&known_spaces::cross_polytope_boundary(2).unwrap()), &[0, 7]).unwrap(),
        ),
        (
            "pair of pants",
            without_faces(&map_of(&known_spaces::torus_grid(&[5, 4]).unwrap()), &[0, 25]).unwrap(),
        ),
        ("Moebius band", without_faces(&map_of(&known_spaces::projective_plane().unwrap()), &[3]).unwrap()),
    ]
}

#[test]
fn covers_are_local_isomorphisms_and_disks() {
    for (name, map) in surfaces() {
        let cut = CutSurface::new(&map, &TreeCotree::new(&map));
        for extent in
            [CoverExtent::Radius(0), CoverExtent::Radius(1), CoverExtent::Radius(2), CoverExtent::Copies(30)]
        {
            match UniversalCover::new(&map, &cut, 0, extent, 1_000_000) {
                Ok(cover) => check(&map, &cover),
                Err(error) => {
                    assert!(
                        ["sphere", "projective plane", "disk", "strip"].contains(&name),
                        "{name}: {error}"
                    );
                }
            }
        }
    }
}

#[test]
fn known_covers_have_known_sizes() {
    let genus_2 = cover_of(&subdivided(&[1, 2, -1, -2, 3, 4, -3, -4]), 0, CoverExtent::Radius(2));
    assert_eq!(genus_2.sphere_sizes(), [1, 8, 56]);
    let klein = cover_of(&map_of(&known_spaces::small_klein_bottle().unwrap()), 0, CoverExtent::Radius(3));
    assert_eq!(klein.sphere_sizes(), [1, 4, 8, 12]);
    let sphere = cover_of(&map_of(&known_spaces::projective_plane().unwrap()), 0, CoverExtent::Radius(1));
    assert!(sphere.is_complete());
    assert_eq!(sphere.f_vector(), [12, 30, 20]);
    let annulus =
        without_faces(&map_of(&known_spaces::cross_polytope_boundary(2).unwrap()), &[0, 7]).unwrap();
    assert_eq!(cover_of(&annulus, 0, CoverExtent::Radius(4)).sphere_sizes(), [1, 2, 2, 2, 2]);
}

#[test]
fn impossible_covers_are_refused() {
    let fault = |map: &GeneralizedMap, component, extent, most| {
        let cut = CutSurface::new(map, &TreeCotree::new(map));
        UniversalCover::new(map, &cut, component, extent, most).unwrap_err().to_string()
    };
    let sphere = map_of(&known_spaces::simplex_boundary(2).unwrap());
    assert!(fault(&sphere, 1, CoverExtent::Radius(0), 1000).contains("no component 1"));
    assert!(fault(&sphere, 0, CoverExtent::Copies(0), 1000).contains("0 copies"));
    let torus = map_of(&known_spaces::cyclic_torus(2).unwrap());
    assert!(fault(&torus, 0, CoverExtent::Radius(100), 100_000).contains("would have 20201 copies"));
    let octagon = polygon(&[1, 2, -1, -2, 3, 4, -3, -4]);
    assert!(fault(&octagon, 0, CoverExtent::Radius(11), 100_000_000).contains("have 2577346585 copies"));
    assert!(fault(&octagon, 0, CoverExtent::Radius(usize::MAX), 100_000_000).contains("more than"));
    assert!(
        fault(&octagon, 0, CoverExtent::Copies(usize::MAX), 100_000_000)
            .contains("18446744073709551615 copies")
    );
}

#[test]
fn deck_transformations_keep_the_cover() {
    // What is next to copy x across a side is next to copy g x across the same side, moved by g.
    for (_, map) in surfaces() {
        let cut = CutSurface::new(&map, &TreeCotree::new(&map));
        let Ok(cover) = UniversalCover::new(&map, &cut, 0, CoverExtent::Copies(12), 1_000_000) else {
            continue;
        };
        let (group, copies) = (cover.group(), cover.copies());
        for letter in (1..=group.generator_count() as i32).flat_map(|letter| [letter, -letter]) {
            for x in 0..copies.len() {
                let Some(y) = copies.neighbor(x, letter) else { continue };
                let g = &copies.elements()[copies.len() / 2];
                let [moved_x, moved_y] =
                    [x, y].map(|copy| copies.number(&group.product(g, &copies.elements()[copy])));
                if let (Some(moved_x), Some(moved_y)) = (moved_x, moved_y) {
                    assert_eq!(copies.neighbor(moved_x, letter), Some(moved_y));
                }
            }
        }
    }
}

/// Two surfaces side by side, with a vertex of no face.
#[test]
fn components_have_covers_of_their_own() {
    let facets = |space: SimplicialComplex, shift: u32| -> Vec<Vec<u32>> {
        let facets = space.facets();
        facets.iter().map(|facet| facet.vertices().map(|v| v.to_u32() + shift).collect()).collect()
    };
    let mut all = facets(known_spaces::cyclic_torus(2).unwrap(), 0);
    all.extend(facets(known_spaces::projective_plane().unwrap(), 10));
    let map = map_of(&SimplicialComplex::from_facets(all).unwrap());
    let (torus, plane) =
        (cover_of(&map, 0, CoverExtent::Copies(6)), cover_of(&map, 1, CoverExtent::Copies(2)));
    check(&map, &torus);
    assert_eq!((torus.copy_count(), plane.f_vector()), (6, vec![12, 30, 20]));
    assert!(plane.vertex_below(VertexId::new(0)).index() > 6);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn punctured_surfaces_have_covers(which in 0usize..5, gone in prop::collection::btree_set(0usize..400, 0..5), copies in 1usize..20) {
        let base = match which {
            0 => map_of(&known_spaces::torus_grid(&[4, 4]).unwrap()),
            1 => map_of(&known_spaces::klein_grid(4, 4).unwrap()),
            2 => map_of(&known_spaces::projective_plane().unwrap()),
            3 => map_of(&known_spaces::cross_polytope_boundary(2).unwrap()),
            _ => subdivided(&[1, 2, -1, -2, 3, 3]),
        };
        let count = base.f_vector()[2];
        let gone: BTreeSet<usize> = gone.into_iter().map(|face| face % count).collect();
        let Some(map) = without_faces(&base, &gone.into_iter().collect::<Vec<_>>()) else { return Ok(()) };
        let cut = CutSurface::new(&map, &TreeCotree::new(&map));
        for component in 0..cut.domains().len() {
            match UniversalCover::new(&map, &cut, component, CoverExtent::Copies(copies), 1_000_000) {
                Ok(cover) if cut.domains().len() == 1 => check(&map, &cover),
                Ok(cover) => prop_assert!(cover.euler_characteristic() >= 1),
                Err(error) => prop_assert!(false, "{error}"),
            }
        }
    }
}

#[test]
fn orientation_of_copies_follows_the_group() {
    // Two copies of the hexagon with a twisted letter between them lie face down to each other.
    let map = polygon(&[1, 2, -1, -2, 3, 3]);
    let cover = cover_of(&map, 0, CoverExtent::Radius(1));
    let above = GeneralizedMap::new(cover.skeleton().clone()).unwrap();
    let orientation = above.orientation();
    let minus = orientation.signs().iter().filter(|&&sign| sign == Sign::Minus).count();
    assert_eq!((cover.copy_count(), minus), (7, 2));
}

/// A surface with a word around its boundary, of about 1000 triangles, to radius 3.
#[test]
fn covers_of_meshes_are_quick() {
    let mut map = subdivided(&[1, 2, -1, -2, 3, 4, -3, -4]);
    while map.f_vector()[2] < 600 {
        map = split_edges(&map);
    }
    let cover = cover_of_with(&map, CoverExtent::Radius(3), 100_000_000);
    assert_eq!(cover.sphere_sizes(), [1, 8, 56, 392]);
    assert_eq!(cover.euler_characteristic(), 1);
}

/// Each triangle in four.
pub(super) fn split_edges(map: &GeneralizedMap) -> GeneralizedMap {
    let v = map.vertex_count();
    let middle = |side| (v + map.edge(side).index()) as u32;
    let triangles = (0..map.f_vector()[2]).map(FaceId::new).flat_map(|face| {
        let sides: Vec<_> = map.sides_of(face).collect();
        let corners: Vec<u32> = sides.iter().map(|&side| map.source(side).to_u32()).collect();
        let middles: Vec<u32> = sides.iter().map(|&side| middle(side)).collect();
        let outer = (0..3).map(|i| [corners[i], middles[i], middles[(i + 2) % 3]]);
        outer.chain([[middles[0], middles[1], middles[2]]]).collect::<Vec<_>>()
    });
    map_of(&SimplicialComplex::from_facets(triangles).unwrap())
}

fn cover_of_with(map: &GeneralizedMap, extent: CoverExtent, most: usize) -> UniversalCover {
    let cut = CutSurface::new(map, &TreeCotree::new(map));
    UniversalCover::new(map, &cut, 0, extent, most).unwrap()
}
