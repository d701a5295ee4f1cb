//! The arrangement by congruence against known counts and volumes, and against fractions.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::reference::cells::arrangement;
use crate::reference::models::{Walks, crossing_grids, moved_cubes, random_cubes, second_place, shifted};
use crate::reference::{soup_count, soups};
use coface_algebra::{ErrorKind, FaceId};
use coface_algebra::{Sign, SparseMatrix};
use coface_arrange::boolean::{BooleanFormula, CellSelection, InsideRule, WindingNumbers};
use coface_arrange::spatial::{
    CongruenceArrangement, NonPlanar, SpatialArrangement, SpatialOptions, SpatialPolygons,
    arrange_by_congruence,
};
use rayon::prelude::*;

const TOLERANCE: f64 = 1e-7;

fn arranged(walks: &Walks) -> CongruenceArrangement {
    let found =
        arrange_by_congruence(&walks.positions(), &walks.lists(), &walks.polygon_of_walk, TOLERANCE).unwrap();
    assert!(found.volumes().iter().all(|&volume| volume > 0.0));
    found
}

fn volumes(found: &CongruenceArrangement) -> Vec<f64> {
    let mut volumes = found.volumes().to_vec();
    volumes.sort_by(f64::total_cmp);
    volumes
}

fn close(found: f64, expected: f64, accuracy: f64) -> bool {
    (found - expected).abs() <= accuracy * expected.abs().max(1e-3)
}

/// The volume where a formula of cubes holds, six polygons a cube.
fn volume(found: &CongruenceArrangement, formula: &BooleanFormula, cube_count: usize) -> f64 {
    let terms = (0..found.f_vector()[2]).flat_map(|face| {
        let polygons = found.polygons_of_face(FaceId::new(face));
        polygons.map(move |(polygon, sign)| (face, polygon / 6, i64::from(sign.to_i32())))
    });
    let inputs = SparseMatrix::from_entries(found.f_vector()[2], cube_count, terms).unwrap();
    let winding = WindingNumbers::new(&found.chain_complex().unwrap(), &inputs).unwrap();
    let selection = CellSelection::by_formula(&winding, formula, InsideRule::Nonzero).unwrap();
    selection.cells().map(|cell| found.volumes()[cell.index()]).sum()
}

#[test]
fn cubes_have_the_known_cells() {
    let cubes = |places: &[([f64; 3], f64)]| {
        let mut walks = Walks::default();
        places.iter().for_each(|&(by, side)| walks.add_cube(|p| shifted(p.map(|x| side * x), by)));
        arranged(&walks)
    };
    let unit = ([0.0; 3], 1.0);
    // Without the exterior: one cell less than in tables that count it.
    for (places, counts, expected) in [
        (vec![unit, unit], [8, 12, 6, 1], vec![1.0]),
        (vec![unit, ([0.5; 3], 1.0)], [22, 36, 18, 3], vec![0.125, 0.875, 0.875]),
        (vec![unit, ([1., 0., 0.], 1.0)], [12, 20, 11, 2], vec![1.0, 1.0]),
        (vec![unit, ([1., 0.5, 0.5], 1.0)], [18, 28, 13, 2], vec![1.0, 1.0]),
        (vec![unit, ([1., 1., 0.], 1.0)], [14, 23, 12, 2], vec![1.0, 1.0]),
        (vec![unit, ([1., 1., 1.], 1.0)], [15, 24, 12, 2], vec![1.0, 1.0]),
        (vec![unit, ([3., 0., 0.], 1.0)], [16, 24, 12, 2], vec![1.0, 1.0]),
        (vec![unit, ([0.25; 3], 0.5)], [16, 24, 12, 2], vec![0.125, 0.875]),
    ] {
        let found = cubes(&places);
        assert_eq!((found.f_vector(), volumes(&found)), (counts.to_vec(), expected), "{places:?}");
        assert_eq!(found.void_count(), usize::from(places[1].1 < 1.0));
    }
}

#[test]
fn moved_cubes_have_the_known_regions() {
    let two = arranged(&moved_cubes(2));
    assert_eq!(two.f_vector(), [24, 40, 20, 3]);
    let three = arranged(&moved_cubes(3));
    assert_eq!(three.f_vector(), [49, 88, 47, 7]);
    for (text, expected) in [
        ("a & b", 0.3559135818288),
        ("a & c", 0.1059069904),
        ("b & c", 0.1130602363),
        ("a & b & c", 0.0590344335),
        ("a | b | c", 2.4841536249),
        ("a - b", 0.6440864181712),
        ("b - a", 0.6440864181712),
    ] {
        let found = volume(&three, &BooleanFormula::parse(text, &[]).unwrap(), 3);
        assert!(close(found, expected, 1e-9), "{text}: {found}, not {expected}");
    }
    assert!(two.largest_class_diameter() < 1e-14);
}

#[test]
fn random_cubes_have_the_known_union() {
    // Volumes by inclusion and exclusion over intersections of half-spaces.
    for (count, seed, counts, union) in [
        (16, 11, [241, 428, 231, 40], 5.789775884653),
        (24, 12, [578, 1126, 665, 117], 8.895700855618),
        (48, 11, [2593, 5758, 4041, 889], 12.034725081359),
    ] {
        let found = arranged(&random_cubes(count, seed));
        assert_eq!(found.f_vector(), counts, "{count} cubes");
        let volume = volume(&found, &BooleanFormula::union(count), count);
        assert!(close(volume, union, 1e-12), "{count} cubes: {volume}, not {union}");
    }
}

#[test]
fn grids_that_cross_keep_their_walls() {
    let found = arranged(&crossing_grids());
    // What both fill is what the two cubes around them fill.
    let mut cubes = Walks::default();
    cubes.add_cube(|p| p.map(|x| 2.0 * x));
    cubes.add_cube(|p| second_place(p.map(|x| 2.0 * x)));
    let around = arranged(&cubes);
    let [total, expected] = [&found, &around].map(|found| found.volumes().iter().sum::<f64>());
    assert!(close(total, expected, 1e-12), "{total}, not {expected}");
    assert_eq!(found.f_vector(), [132, 303, 228, 56]);
}

#[test]
fn what_cannot_be_arranged_is_named() {
    let mut walks = moved_cubes(1);
    walks.flat[0] = 0.01;
    let arrange = |walks: &Walks, tolerance: f64| {
        arrange_by_congruence(&walks.positions(), &walks.lists(), &walks.polygon_of_walk, tolerance)
    };
    let error = arrange(&walks, TOLERANCE).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::InvalidInput);
    assert!(error.message().contains("is not flat"), "{error}");
    assert_eq!(arrange(&walks, f64::NAN).unwrap_err().kind(), ErrorKind::InvalidInput);
    assert_eq!(arrange(&walks, -1.0).unwrap_err().kind(), ErrorKind::InvalidInput);
    let mut walks = moved_cubes(1);
    walks.walks[0][0] = 99;
    assert_eq!(arrange(&walks, TOLERANCE).unwrap_err().kind(), ErrorKind::NotInComplex);
    walks.polygon_of_walk.pop();
    assert_eq!(arrange(&walks, TOLERANCE).unwrap_err().kind(), ErrorKind::Shape);
    // Nothing, and what has no width.
    let mut walks = Walks::default();
    assert_eq!(arrange(&walks, TOLERANCE).unwrap().f_vector(), [0; 4]);
    walks.add(vec![vec![[0.0; 3], [1.0; 3], [2.0; 3]]]);
    let found = arrange(&walks, TOLERANCE).unwrap();
    assert_eq!((found.f_vector(), found.dropped_polygons()), (vec![0; 4], &[0][..]));
}

/// The exact method has the same counts, and nearly the same volumes. Squares that were turned are flat up to rounding only; it
/// takes them as two triangles each and puts these together again.
#[test]
fn both_methods_agree() {
    for walks in [
        moved_cubes(2),
        moved_cubes(3),
        random_cubes(6, 3),
        random_cubes(16, 11),
        random_cubes(24, 12),
        crossing_grids(),
    ] {
        let found = arranged(&walks);
        let polygons =
            SpatialPolygons::new(walks.positions(), walks.lists(), walks.polygon_of_walk.clone()).unwrap();
        let options = SpatialOptions::new().non_planar(NonPlanar::Split);
        let exact = SpatialArrangement::new(&polygons, &options).unwrap();
        assert_eq!(found.f_vector(), exact.f_vector());
        assert_eq!(found.void_count(), exact.void_count());
        let mut expected = exact.volumes().unwrap();
        expected.sort_by(f64::total_cmp);
        assert!(volumes(&found).iter().zip(&expected).all(|(&x, &y)| (x - y).abs() < 1e-13));
        let sources = |list: Vec<(usize, Sign)>| {
            let first = list[0].1;
            list.into_iter().map(|(polygon, sign)| (polygon, sign == first)).collect::<Vec<_>>()
        };
        let faces = || (0..found.f_vector()[2]).map(FaceId::new);
        let mut here: Vec<_> = faces().map(|face| sources(found.polygons_of_face(face).collect())).collect();
        let own =
            |face| exact.polygons_of_face(face).into_iter().map(|(p, sign)| (p as usize, sign)).collect();
        let mut there: Vec<_> = faces().map(|face| sources(own(face))).collect();
        here.sort();
        there.sort();
        assert_eq!(here, there);
    }
}

/// Soups of small integers are far from the tolerance, so that it changes nothing.
#[test]
fn soups_have_the_cells_of_fractions() {
    let faults: Vec<String> = (0..soup_count(200))
        .into_par_iter()
        .filter_map(|seed| {
            let (polygons, inputs) = if seed % 2 == 0 { soups::sheets(seed) } else { soups::solids(seed) };
            let expected = arrangement(&polygons, inputs);
            let walks = Walks::of(&polygons);
            let found = match arrange_by_congruence(
                &walks.positions(),
                &walks.lists(),
                &walks.polygon_of_walk,
                TOLERANCE,
            ) {
                Ok(found) => found,
                Err(error) => return Some(format!("soup {seed}: {error}")),
            };
            let mut sources: Vec<Vec<(usize, i64)>> = (0..found.f_vector()[2])
                .map(|face| {
                    let polygons: Vec<(usize, Sign)> = found.polygons_of_face(FaceId::new(face)).collect();
                    let first = polygons[0].1;
                    polygons
                        .iter()
                        .map(|&(polygon, sign)| (polygon, i64::from(sign.times(first).to_i32())))
                        .collect()
                })
                .collect();
            sources.sort();
            let same = expected.volumes().len() == found.volumes().len()
                && expected.volumes().iter().zip(volumes(&found)).all(|(&x, y)| close(y, x, 1e-9));
            let is_right =
                found.f_vector() == expected.f_vector() && same && sources == expected.sources_of_faces();
            (!is_right).then(|| {
                format!(
                    "soup {seed}: {:?} {:?}, not {:?} {:?}",
                    found.f_vector(),
                    volumes(&found),
                    expected.f_vector(),
                    expected.volumes()
                )
            })
        })
        .collect();
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}
