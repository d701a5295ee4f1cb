//! Planar arrangements of small-integer rings against fractions: counts, areas, holes and winding numbers of all faces.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::reference::{Point, drawing, number, quotient, soup_count, soups};
use coface_algebra::FaceId;
use coface_algebra::{RaggedArray, Rational, UnionFind};
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_arrange::planar::{PlanarOverlay, PlanarRegions};
use coface_geometry::Positions;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// A face as both methods know it: its area, its number of holes, and the winding numbers that are not zero.
type Face = (Rational, usize, Vec<(u32, i32)>);

/// The drawing of rings in fractions.
struct Definition {
    counts: [usize; 3],
    faces: Vec<Face>,
    /// Pairs of faces on both sides of an edge.
    neighbors: Vec<[usize; 2]>,
}

fn by_definition(rings: &[Vec<[i64; 2]>], regions: &[u32]) -> Definition {
    let rings: Vec<Vec<Point>> =
        rings.iter().map(|ring| ring.iter().map(|corner| corner.map(number)).collect()).collect();
    let sides = |ring: &Vec<Point>| -> Vec<[Point; 2]> {
        (0..ring.len()).map(|i| [ring[i].clone(), ring[(i + 1) % ring.len()].clone()]).collect()
    };
    let segments: Vec<[Point; 2]> = rings.iter().flat_map(sides).collect();
    let (points, edges) = drawing::cut(&segments);
    let drawn = drawing::bounded_faces(&points, &edges);
    let mut left_of: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    for (index, face) in drawn.iter().enumerate() {
        for walk in &face.walks {
            left_of.extend((0..walk.len()).map(|i| ([walk[i], walk[(i + 1) % walk.len()]], index)));
        }
    }
    let neighbors = left_of.iter().filter_map(|(&[a, b], &face)| Some([face, *left_of.get(&[b, a])?]));
    let neighbors = neighbors.collect();
    let faces = drawn.into_iter().map(|face| {
        let mut windings: BTreeMap<u32, i32> = BTreeMap::new();
        for (ring, &region) in rings.iter().zip(regions) {
            let winding = drawing::winding(ring.iter(), &face.inside).expect("inside is on no ring");
            *windings.entry(region).or_default() += winding as i32;
        }
        let windings = windings.into_iter().filter(|&(_, winding)| winding != 0).collect();
        (quotient(&face.doubled, &number(2)), face.walks.len() - 1, windings)
    });
    let faces: Vec<Face> = faces.collect();
    Definition { counts: [points.len(), edges.len(), faces.len()], faces, neighbors }
}

impl Definition {
    /// The area of the faces for which a condition on winding numbers holds, and the number of parts joined across edges.
    fn combined(&self, condition: impl Fn(&[(u32, i32)]) -> bool) -> (Rational, usize) {
        let mut area = Rational::ZERO;
        let mut parts = UnionFind::new(self.faces.len());
        let is_in: Vec<bool> = self.faces.iter().map(|face| condition(&face.2)).collect();
        for (face, _) in self.faces.iter().zip(&is_in).filter(|(_, is_in)| **is_in) {
            area += &face.0;
        }
        for &[a, b] in self.neighbors.iter().filter(|pair| pair.iter().all(|&face| is_in[face])) {
            parts.unite(a as u32, b as u32);
        }
        let outside = is_in.iter().filter(|is_in| !**is_in).count();
        (area, parts.class_count() - outside)
    }
}

#[test]
fn rings_have_the_faces_of_the_definition() {
    (0..soup_count(1000)).into_par_iter().for_each(|seed| {
        let (rings, regions) = soups::rings(seed);
        let flat = rings.iter().flatten().flatten().map(|&x| x as f64).collect();
        let mut next = 0..;
        let lists: Vec<Vec<u32>> =
            rings.iter().map(|ring| next.by_ref().take(ring.len()).collect()).collect();
        let positions = Positions::from_flat(2, flat).unwrap();
        let found = PlanarRegions::new(&positions, &RaggedArray::from_lists(&lists), &regions).unwrap();
        let arrangement = found.arrangement();
        let mut faces: Vec<Face> = (0..arrangement.face_count())
            .map(|face| {
                let face = FaceId::new(face);
                let holes = arrangement.walks(Some(face)).len() - 1;
                (arrangement.exact_area(Some(face)), holes, found.winding_numbers(face).to_vec())
            })
            .collect();
        faces.sort();
        let definition = by_definition(&rings, &regions);
        assert_eq!(arrangement.f_vector(), definition.counts, "soup {seed}: {rings:?}");
        let mut expected = definition.faces.clone();
        expected.sort();
        assert_eq!(faces, expected, "soup {seed}: {rings:?} {regions:?}");
        // Coordinates of the vertices of faces are never far off, so this is what rounding leaves of it.
        let covered: f64 = expected.iter().map(|(area, ..)| area.to_f64()).sum();
        assert!((arrangement.areas().iter().sum::<f64>() - covered).abs() <= 1e-13 * covered);
        // Combinations that do not reach to infinity.
        let overlay = PlanarOverlay::new(&positions, &RaggedArray::from_lists(&lists), &regions).unwrap();
        for text in ["a", "a | b | c", "a & b", "a - b", "(a ^ b) - c", "a & b & c"] {
            let formula = BooleanFormula::parse(text, &[]).unwrap();
            for rule in [InsideRule::Nonzero, InsideRule::Positive, InsideRule::Odd] {
                let found = overlay.boolean(&formula, rule).unwrap();
                let winds = |windings: &[(u32, i32)], input: usize| {
                    windings.iter().any(|&(region, n)| region as usize == input && rule.is_inside(n))
                };
                let (area, parts) =
                    definition.combined(|windings| formula.evaluate(|input| winds(windings, input)));
                assert_eq!(found.exact_area(), area, "soup {seed}: {text} {rule:?}");
                assert_eq!(found.polygons().len(), parts, "soup {seed}: {text} {rule:?}");
            }
        }
    });
}
