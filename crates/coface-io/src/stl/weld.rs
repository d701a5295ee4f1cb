//! Equal corners become one vertex.

use crate::lists::number_by_firsts;
use coface_algebra::progress::stage;
use rayon::prelude::*;

/// A corner by the bits of its three coordinates in single precision, with zero for negative zero.
pub(super) type Corner = [u32; 3];

/// The bits of a coordinate; equal for equal numbers.
pub(super) fn bits(coordinate: f32) -> u32 {
    if coordinate == 0.0 { 0 } else { coordinate.to_bits() }
}

/// What welding makes of a list of corners.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Welded {
    /// The vertex of each corner; vertices are numbered in the order of their first corner.
    pub(super) vertices: Vec<u32>,
    /// The first corner of each vertex.
    pub(super) first_corners: Vec<u32>,
}

/// Welds corners with equal bits by sorting them, in O(n log n). There are fewer than 2^32.
pub(super) fn weld(corners: &[Corner]) -> Welded {
    // The number of the corner stands below its coordinates, so that equal corners follow each other in order.
    let mut keys: Vec<u128> = corners
        .par_iter()
        .enumerate()
        .map(|(i, &[x, y, z])| {
            u128::from(x) << 96 | u128::from(y) << 64 | u128::from(z) << 32 | u128::from(i as u32)
        })
        .collect();
    let _steps = stage("welding corners", 0);
    keys.par_sort_unstable();
    // Each corner first points to the first corner that equals it.
    let mut vertices = vec![0; corners.len()];
    for equal in keys.chunk_by(|a, b| a >> 32 == b >> 32) {
        for &key in equal {
            vertices[key as u32 as usize] = equal[0] as u32;
        }
    }
    drop(keys);
    let first_corners = number_by_firsts(&mut vertices);
    Welded { vertices, first_corners }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::HashMap;

    #[test]
    fn zeros_are_equal_and_nothing_else_is() {
        assert_eq!(bits(-0.0), bits(0.0));
        let corner = |x: f32| [bits(x), 0, 0];
        let next_after_one = f32::from_bits(1.0f32.to_bits() + 1);
        let welded = weld(&[corner(1.0), corner(0.0), corner(next_after_one), corner(-0.0), corner(1.0)]);
        assert_eq!(welded, Welded { vertices: vec![0, 1, 2, 1, 0], first_corners: vec![0, 1, 2] });
    }

    proptest! {
        #[test]
        fn sorting_and_a_hash_table_weld_alike(corners in proptest::collection::vec([0..4u32, 0..3, 0..3], 0..60)) {
            let mut known = HashMap::new();
            let mut first_corners = Vec::new();
            let mut vertices = Vec::new();
            for (i, &corner) in corners.iter().enumerate() {
                let next = known.len() as u32;
                let vertex = *known.entry(corner).or_insert(next);
                if vertex == next {
                    first_corners.push(i as u32);
                }
                vertices.push(vertex);
            }
            prop_assert_eq!(weld(&corners), Welded { vertices, first_corners });
        }
    }
}
