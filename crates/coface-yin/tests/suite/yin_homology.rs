//! Betti numbers of Yin sets and of their closures against homology of triangulations.
//!
//! The box around a set is cut by its curves and by a vertical line through each knot. The pieces are trapezoids, so cells and
//! their sides make a regular cell complex, and chains of cells, each in the closure of the next, triangulate it. Chains of the cells
//! of the closed set triangulate that; chains of the open cells that make up the open set are a deformation retract of it.

#![allow(clippy::unwrap_used)]

use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, FaceId, HalfedgeId, VertexId};
use coface_arrange::boolean::InsideRule;
use coface_arrange::planar::PlanarRegions;
use coface_complexes::simplicial::SimplicialComplex;
use coface_geometry::Positions;
use coface_topology::homology;
use coface_yin::{Order, YinSet};

/// A generator of numbers that is the same everywhere (splitmix64).
struct Random(u64);

impl Random {
    fn below(&mut self, bound: u64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % bound) as f64
    }
}

/// The Betti numbers of degree 0 and 1 of the complex of some chains of cells; there is no other homology.
fn betti(chains: &[Vec<u32>]) -> [usize; 2] {
    if chains.is_empty() {
        return [0, 0];
    }
    let complex = SimplicialComplex::from_facets(chains).unwrap();
    let mut found = homology(&complex.chain_complex().unwrap()).betti_numbers();
    found.resize(3, 0);
    assert_eq!(found[2], 0);
    [found[0], found[1]]
}

/// The Betti numbers of a set in a box of this size around the origin, and those of its closure.
fn triangulated(set: &YinSet, size: f64) -> [[usize; 2]; 2] {
    let mut rings: Vec<Vec<[f64; 2]>> = (0..set.curve_count())
        .map(|curve| {
            let curve = set.curve(curve);
            curve.controls()[..curve.piece_count()].to_vec()
        })
        .collect();
    let curve_count = rings.len();
    let mut places: Vec<f64> = rings.iter().flatten().map(|point| point[0]).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    // A line there and back winds around nothing.
    rings.extend(places.iter().map(|&x| vec![[x, -size], [x, size]]));
    rings.push(vec![[-size, -size], [size, -size], [size, size], [-size, size]]);
    let regions: Vec<u32> = (0..rings.len()).map(|ring| u32::from(ring >= curve_count)).collect();
    let flat: Vec<f64> = rings.iter().flatten().flatten().copied().collect();
    let mut next = 0u32..;
    let lists =
        RaggedArray::from_lists(rings.iter().map(|ring| next.by_ref().take(ring.len()).collect::<Vec<_>>()));
    let regions = PlanarRegions::new(&Positions::from_flat(2, flat).unwrap(), &lists, &regions).unwrap();
    let cells = regions.arrangement();
    assert_eq!((cells.hole_count(), cells.component_count()), (0, 1));
    let inside: Vec<bool> = (0..cells.face_count())
        .map(|face| {
            let winding = regions.winding_numbers(FaceId::new(face)).iter().find(|own| own.0 == 0);
            winding.map_or(0, |own| own.1) >= i32::from(set.is_bounded())
        })
        .collect();
    let is_inside = |h: usize| cells.face_of(HalfedgeId::new(h)).is_some_and(|face| inside[face.index()]);
    let open_edge: Vec<bool> =
        (0..cells.edge_count()).map(|edge| is_inside(2 * edge) && is_inside(2 * edge + 1)).collect();
    let open_vertex: Vec<bool> = (0..cells.vertex_count())
        .map(|v| cells.halfedges_around(VertexId::new(v)).all(|h| open_edge[h.index() / 2]))
        .collect();
    let (vertex_count, edge_count) = (cells.vertex_count(), cells.edge_count());
    let (mut open, mut closed) = (Vec::new(), Vec::new());
    for face in (0..cells.face_count()).filter(|&face| inside[face]) {
        let name = (vertex_count + edge_count + face) as u32;
        open.push(vec![name]);
        let walks: Vec<&[u32]> = cells.walks(Some(FaceId::new(face))).collect();
        assert_eq!(walks.len(), 1);
        for edge in walks[0].iter().map(|&h| h as usize / 2) {
            let edge_name = (vertex_count + edge) as u32;
            if open_edge[edge] {
                open.push(vec![edge_name, name]);
            }
            for end in cells.ends(EdgeId::new(edge)).map(VertexId::index) {
                closed.push(vec![end as u32, edge_name, name]);
                if open_vertex[end] {
                    open.push(vec![end as u32, edge_name, name]);
                }
            }
        }
    }
    [betti(&open), betti(&closed)]
}

fn compare(set: &YinSet, size: f64, place: &str) {
    let found = [set.betti_open().unwrap(), set.betti_closed().unwrap()];
    assert_eq!(found, triangulated(set, size), "{place}");
}

#[test]
fn sets_that_touch_themselves() {
    let of = |rings: &[&[[f64; 2]]]| YinSet::from_rings(rings, InsideRule::Odd).unwrap();
    // A pentagon with a hole that touches its corner; three triangles that touch in a ring; holes that touch.
    let pentagon =
        of(&[&[[0., 4.], [2., -2.], [6., -2.], [8., 4.], [4., 6.]], &[[4., 6.], [6., 0.], [2., 0.]]]);
    let ring = of(&[&[[0., 2.], [4., -2.], [8., 2.], [4., 6.]], &[[2., 0.], [2., 4.], [6., 4.]]]);
    let holes = of(&[
        &[[-9., -9.], [20., -9.], [20., 20.], [-9., 20.]],
        &[[0., 0.], [0., 4.], [4., 4.], [4., 0.]],
        &[[4., 4.], [4., 8.], [8., 8.], [8., 4.]],
    ]);
    for (number, set) in [pentagon, ring, holes].iter().enumerate() {
        compare(set, 50.0, &format!("{number}"));
        compare(&set.complement().unwrap(), 50.0, &format!("complement of {number}"));
    }
    compare(&YinSet::plane(Order::LINEAR), 1.0, "plane");
    compare(&YinSet::empty(Order::LINEAR), 1.0, "empty");
}

#[test]
fn random_sets_on_a_small_lattice() {
    let usual = 60;
    let count = std::env::var("COFACE_SOUPS").ok().and_then(|text| text.parse().ok()).unwrap_or(usual);
    for case in 0..count.min(2000) {
        let mut random = Random(case as u64);
        let mut set = || {
            let rings: Vec<Vec<[f64; 2]>> = (0..1 + random.below(5) as usize)
                .map(|_| {
                    let [x, y] = [random.below(6), random.below(6)];
                    let [w, h] = [1.0 + random.below(4), 1.0 + random.below(4)];
                    match random.below(3) as usize {
                        0 => vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]],
                        1 => vec![[x, y], [x + w, y], [x, y + w]],
                        _ => vec![[x, y - w], [x + w, y], [x, y + w], [x - w, y]],
                    }
                })
                .collect();
            YinSet::from_rings(&rings, InsideRule::Odd).unwrap()
        };
        let (a, b) = (set(), set());
        compare(&a, 20.0, &format!("case {case}"));
        compare(&a.meet(&b).unwrap(), 20.0, &format!("case {case}: meet"));
        compare(
            &a.join(&b).unwrap().complement().unwrap(),
            20.0,
            &format!("case {case}: outside of the join"),
        );
    }
}
