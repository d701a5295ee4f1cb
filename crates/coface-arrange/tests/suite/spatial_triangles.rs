//! Arrangements of small-integer polygons in space against fractions.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::reference::cells::arrangement;
use crate::reference::models::Walks;
use crate::reference::space::Polygon;
use crate::reference::{soup_count, soups};
use coface_algebra::Rational;
use coface_algebra::{CellId, FaceId, VertexId};
use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons, gift_wrapped_shells};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// What is known of boxes, to see that the reference is to be believed.
#[test]
fn the_reference_knows_boxes() {
    let expect = |boxes: &[([i64; 3], [i64; 3])], counts: [usize; 4], volumes: &[f64]| {
        let polygons: Vec<Polygon> = boxes
            .iter()
            .enumerate()
            .flat_map(|(input, &(low, high))| soups::cuboid(low, high, input))
            .collect();
        let found = arrangement(&polygons, boxes.len());
        assert_eq!((found.f_vector(), found.volumes()), (counts, volumes.to_vec()), "{boxes:?}");
    };
    let unit = ([0; 3], [2; 3]);
    expect(&[unit], [8, 12, 6, 1], &[8.0]);
    expect(&[unit, unit], [8, 12, 6, 1], &[8.0]);
    expect(&[unit, ([1; 3], [3; 3])], [22, 36, 18, 3], &[1.0, 7.0, 7.0]);
    expect(&[unit, ([2, 0, 0], [4, 2, 2])], [12, 20, 11, 2], &[8.0, 8.0]);
    expect(&[unit, ([2, 1, 1], [4, 3, 3])], [18, 28, 13, 2], &[8.0, 8.0]);
    expect(&[unit, ([2, 2, 0], [4, 4, 2])], [14, 23, 12, 2], &[8.0, 8.0]);
    expect(&[unit, ([2; 3], [4; 3])], [15, 24, 12, 2], &[8.0, 8.0]);
    expect(&[unit, ([3; 3], [5; 3])], [16, 24, 12, 2], &[8.0, 8.0]);
    expect(&[([0; 3], [4; 3]), ([1; 3], [3; 3])], [16, 24, 12, 2], &[8.0, 56.0]);
    expect(&[([0; 3], [4; 3]), ([1, 1, -2], [3, 3, 6])], [24, 40, 22, 4], &[8.0, 8.0, 16.0, 48.0]);
}

/// The exact arrangement of polygons.
fn exact(polygons: &[Polygon]) -> Result<SpatialArrangement, coface_algebra::Error> {
    let walks = Walks::of(polygons);
    let inputs = polygons.iter().map(|polygon| polygon.input as u32).collect();
    let polygons = SpatialPolygons::new(walks.positions(), walks.lists(), walks.polygon_of_walk)?;
    SpatialArrangement::new(&polygons.with_inputs(inputs)?, &SpatialOptions::default())
}

/// What is different between the arrangement and the one in fractions.
fn fault(polygons: &[Polygon], input_count: usize) -> Option<String> {
    let expected = arrangement(polygons, input_count);
    let found = match exact(polygons) {
        Ok(found) => found,
        Err(error) => return Some(format!("error: {error}")),
    };
    if found.f_vector() != expected.f_vector() {
        return Some(format!("{:?}, not {:?}", found.f_vector(), expected.f_vector()));
    }
    // The product of boundary matrices is zero, or there would be no chain complex.
    let complex = found.coarse_complex().unwrap();
    assert_eq!(*complex.f_vector(), found.f_vector());
    let mut sources: Vec<Vec<(usize, i64)>> = (0..found.f_vector()[2])
        .map(|face| {
            let polygons = found.polygons_of_face(FaceId::new(face));
            let first = polygons[0].1;
            polygons.iter().map(|&(p, sign)| (p as usize, i64::from(sign.times(first).to_i32()))).collect()
        })
        .collect();
    sources.sort();
    if sources != expected.sources_of_faces() {
        return Some(format!("faces of {sources:?}, not of {:?}", expected.sources_of_faces()));
    }
    // Vertices are the same points, each rounded to the nearest number.
    let places = found.positions().as_flat().as_chunks::<3>().0;
    let points = (0..places.len()).map(|vertex| found.point(VertexId::new(vertex)).to_rational());
    let mut points: Vec<crate::reference::Vector> = points.collect();
    for (place, point) in places.iter().zip(&points) {
        for (&x, exact) in place.iter().zip(point) {
            let distance = |x: f64| {
                let off = exact - &crate::reference::exactly(x);
                if off < Rational::ZERO { -&off } else { off }
            };
            if distance(x).is_zero() {
                continue;
            }
            if [x.next_down(), x.next_up()].iter().any(|&other| distance(other) < distance(x)) {
                return Some(format!("{exact} rounded to {x}"));
            }
        }
    }
    points.sort();
    if points != expected.faces.vertices {
        return Some("other vertices".to_owned());
    }
    let voids: usize = expected.cells.iter().map(|cell| cell.void_count).sum();
    if found.void_count() != voids {
        return Some(format!("{} voids, not {voids}", found.void_count()));
    }
    let is_closed: Vec<bool> = (0..input_count)
        .map(|input| {
            let own: Vec<Polygon> = polygons.iter().filter(|p| p.input == input).cloned().collect();
            crate::reference::cells::is_closed(&own)
        })
        .collect();
    let volumes = found.volumes().unwrap();
    let mut cells: Vec<(f64, Vec<i64>)> = if is_closed.iter().all(|&is_closed| is_closed) {
        let winding = found.winding_numbers().unwrap();
        let numbers =
            |cell: usize| winding.of_cell(CellId::new(cell)).iter().map(|&n| i64::from(n)).collect();
        (0..volumes.len()).map(|cell| (volumes[cell], numbers(cell))).collect()
    } else {
        volumes.iter().map(|&volume| (volume, Vec::new())).collect()
    };
    // By winding numbers, then by volume: rounding may exchange what is nearly equal, not what is told apart by numbers.
    cells.sort_by(|x, y| x.1.cmp(&y.1).then(x.0.total_cmp(&y.0)));
    let mut known: Vec<(f64, Vec<i64>)> = (expected.cells.iter())
        .map(|cell| {
            let numbers = if cells.first().is_some_and(|cell| cell.1.is_empty()) {
                Vec::new()
            } else {
                cell.windings.clone()
            };
            (cell.volume.to_f64(), numbers)
        })
        .collect();
    known.sort_by(|x, y| x.1.cmp(&y.1).then(x.0.total_cmp(&y.0)));
    // Cells that are thin for their place have the rounding of their place.
    let size = places.as_flattened().iter().fold(0.0f64, |size, x| size.max(x.abs()));
    let is_near = |x: f64, y: f64| (x - y).abs() <= 1e-13 * y + 1e-14 * size.powi(3);
    if !cells.iter().zip(&known).all(|(x, y)| x.1 == y.1 && is_near(x.0, y.0)) {
        return Some(format!("cells {cells:?}, not {known:?}"));
    }
    // Gift wrapping has the shells of the radial order, with the coefficients of their sides.
    let fine = found.fine();
    let wrapped = gift_wrapped_shells(fine.complex().face_count(), fine.radial_order()).unwrap();
    assert_eq!(wrapped.column_count(), fine.shell_count());
    for (shell, column) in wrapped.columns().enumerate() {
        let mut chain = BTreeMap::new();
        for (face, sign) in fine.shell_sides(shell as u32) {
            *chain.entry(face.index()).or_insert(0) += sign.to_i32();
        }
        chain.retain(|_, coefficient| *coefficient != 0);
        assert!(column.iter().eq(chain), "gift wrapping");
    }
    None
}

/// As few polygons as show a fault.
fn least(mut polygons: Vec<Polygon>, input_count: usize) -> Vec<Polygon> {
    let mut at = 0;
    while at < polygons.len() {
        let mut fewer = polygons.clone();
        fewer.remove(at);
        if fault(&fewer, input_count).is_some() {
            polygons = fewer;
        } else {
            at += 1;
        }
    }
    polygons
}

#[test]
fn soups_have_the_cells_of_fractions() {
    let faults: Vec<String> = (0..soup_count(1000))
        .into_par_iter()
        .filter_map(|seed| {
            let (polygons, inputs) = if seed % 2 == 0 { soups::sheets(seed) } else { soups::solids(seed) };
            let fault = fault(&polygons, inputs)?;
            Some(format!("soup {seed}: {fault}; as in {:?}", least(polygons, inputs)))
        })
        .collect();
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn crowds_have_the_cells_of_fractions() {
    let faults: Vec<String> = (0..soup_count(140))
        .into_par_iter()
        .filter_map(|seed| {
            let (polygons, inputs) = soups::crowds(seed);
            let fault = fault(&polygons, inputs)?;
            Some(format!("crowd {seed}: {fault}; as in {:?}", least(polygons, inputs)))
        })
        .collect();
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}
