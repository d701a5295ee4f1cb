//! Planar arrangements of small-integer rings against fractions: counts, areas, holes and winding numbers of all faces.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

mod reference;

use coface::FaceId;
use coface::algebra::{RaggedArray, Rational};
use coface::arrangement::planar::PlanarRegions;
use coface::geometry::Positions;
use rayon::prelude::*;
use reference::{Point, drawing, number, quotient, soup_count, soups};
use std::collections::BTreeMap;

/// A face as both methods know it: its area, its number of holes, and the winding numbers that are not zero.
type Face = (Rational, usize, Vec<(u32, i32)>);

fn by_definition(rings: &[Vec<[i64; 2]>], regions: &[u32]) -> ([usize; 3], Vec<Face>) {
    let rings: Vec<Vec<Point>> =
        rings.iter().map(|ring| ring.iter().map(|corner| corner.map(number)).collect()).collect();
    let sides = |ring: &Vec<Point>| -> Vec<[Point; 2]> {
        (0..ring.len()).map(|i| [ring[i].clone(), ring[(i + 1) % ring.len()].clone()]).collect()
    };
    let segments: Vec<[Point; 2]> = rings.iter().flat_map(sides).collect();
    let (points, edges) = drawing::cut(&segments);
    let mut faces: Vec<Face> = drawing::bounded_faces(&points, &edges)
        .into_iter()
        .map(|face| {
            let mut windings: BTreeMap<u32, i32> = BTreeMap::new();
            for (ring, &region) in rings.iter().zip(regions) {
                let winding = drawing::winding(ring.iter(), &face.inside).expect("inside is on no ring");
                *windings.entry(region).or_default() += winding as i32;
            }
            let windings = windings.into_iter().filter(|&(_, winding)| winding != 0).collect();
            (quotient(&face.doubled, &number(2)), face.walks.len() - 1, windings)
        })
        .collect();
    faces.sort();
    ([points.len(), edges.len(), faces.len()], faces)
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
        let (counts, expected) = by_definition(&rings, &regions);
        assert_eq!(arrangement.f_vector(), counts, "soup {seed}: {rings:?}");
        assert_eq!(faces, expected, "soup {seed}: {rings:?} {regions:?}");
        // Coordinates of the vertices of faces are never far off, so this is what rounding leaves of it.
        let covered: f64 = expected.iter().map(|(area, ..)| area.to_f64()).sum();
        assert!((arrangement.areas().iter().sum::<f64>() - covered).abs() <= 1e-13 * covered);
    });
}
