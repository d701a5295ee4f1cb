//! Arrangements of small-integer polygons in space against fractions.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

mod reference;

use rayon::prelude::*;
use reference::cells::arrangement;
use reference::space::Polygon;
use reference::{soup_count, soups};

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

#[test]
fn soups_in_fractions_are_consistent() {
    (0..soup_count(200)).into_par_iter().for_each(|seed| {
        let (polygons, inputs) = if seed % 2 == 0 { soups::sheets(seed) } else { soups::solids(seed) };
        let _ = arrangement(&polygons, inputs);
    });
}
