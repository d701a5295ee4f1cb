//! Which shells lie inside of which, and which way they look, where no two of them touch.

use super::rings::{Points, Triangles};
use crate::spatial::SpatialPredicates;
use coface_algebra::Sign;
use coface_geometry::{AxisBox, BoxTree};
use dashu_int::IBig;
use rayon::prelude::*;
use std::cmp::Ordering;

/// The shells around the places, rising, by the parity of the crossings of a ray. The shell of a place itself, and all
/// that a place lies on, are not to be asked about: `is_asked(place, shell)`.
///
/// Rays go along the axis on which the whole is least, so that rows and planes of many shells cost little. A ray
/// is moved aside by less than any distance, first along one axis and then along the other.
pub(super) fn shells_around(
    points: &Points<'_>,
    triangles: &Triangles,
    shell_of_face: &[u32],
    places: &[u32],
    is_asked: impl Fn(usize, u32) -> bool + Sync,
) -> Vec<Vec<u32>> {
    let box_of = |triangle: usize| -> AxisBox { box_around(points, triangles.corners[triangle]) };
    let whole = coface_geometry::frame_around(triangles.corners.len(), box_of);
    let extent = |axis: &usize| whole[*axis][1] / 2.0 - whole[*axis][0] / 2.0;
    let axis = (0..3).min_by(|a, b| extent(a).total_cmp(&extent(b))).unwrap_or(2);
    let boxes: Vec<AxisBox> = (0..triangles.corners.len()).into_par_iter().map(box_of).collect();
    let tree = BoxTree::new(&boxes);
    let around = |(number, &place): (usize, &u32)| {
        let mut crossed = Vec::new();
        let point = points.point(place);
        let mut ray = point.map(|x| [x; 2]);
        ray[axis][1] = f64::INFINITY;
        tree.visit(&ray, |triangle| {
            let shell = shell_of_face[triangles.face[triangle as usize] as usize];
            if is_asked(number, shell) && crosses(points, axis, place, triangles.corners[triangle as usize]) {
                crossed.push(shell);
            }
        });
        crossed.sort_unstable();
        crossed.chunk_by(|a, b| a == b).filter(|own| own.len() % 2 == 1).map(|own| own[0]).collect()
    };
    places.par_iter().enumerate().map(around).collect()
}

pub(super) fn box_around(points: &Points<'_>, corners: [u32; 3]) -> AxisBox {
    let corners = corners.map(|corner| points.point(corner));
    [0, 1, 2].map(|axis| {
        let [a, b, c] = corners.map(|corner| corner[axis]);
        [a.min(b).min(c), a.max(b).max(c)]
    })
}

/// Whether the ray from a place up an axis, moved aside, crosses a triangle.
fn crosses(points: &Points<'_>, axis: usize, place: u32, corners: [u32; 3]) -> bool {
    let predicates = &points.predicates;
    let front = predicates.normal_sign(axis, corners);
    if front.is_eq() {
        return false;
    }
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let is_in = (0..3).all(|i| {
        let (a, b) = (corners[i], corners[(i + 1) % 3]);
        let turn = predicates
            .normal_sign(axis, [a, b, place])
            .then_with(|| predicates.compare(k, a, b))
            .then_with(|| predicates.compare(j, b, a));
        turn == front
    });
    // The place is behind a triangle above it that faces up.
    is_in && predicates.orientation([corners[0], corners[1], corners[2], place]) == front.reverse()
}

/// The sign of the volume that triangles enclose, each taken with a sign: `Greater` when they look outwards.
pub(super) fn volume_sign(
    points: &Points<'_>,
    triangles: impl Iterator<Item = ([u32; 3], Sign)> + Clone,
) -> Ordering {
    let Some((first, _)) = triangles.clone().next() else {
        return Ordering::Equal;
    };
    let origin = points.point(first[0]);
    let (mut volume, mut size) = (0.0, 0.0);
    for (corners, sign) in triangles.clone() {
        let [a, b, c] = corners.map(|corner| {
            let point = points.point(corner);
            [0, 1, 2].map(|i| point[i] - origin[i])
        });
        volume += f64::from(sign.to_i32()) * coface_geometry::determinant(a, b, c);
        let minor = |i: usize, j: usize| (b[i] * c[j]).abs() + (b[j] * c[i]).abs();
        size += a[0].abs() * minor(1, 2) + a[1].abs() * minor(2, 0) + a[2].abs() * minor(0, 1);
    }
    // Sums of fewer than 2^31 terms lose less than this part of their sizes.
    if volume.abs() > 1e-6 * size && size > 1e-250 && size < 1e250 {
        return volume.total_cmp(&0.0);
    }
    exact_volume_sign(points, triangles)
}

/// The same by integers of any size.
fn exact_volume_sign(
    points: &Points<'_>,
    triangles: impl Iterator<Item = ([u32; 3], Sign)> + Clone,
) -> Ordering {
    // A number is an integer times a power of two.
    let parts = |x: f64| -> (i64, i32) {
        let bits = x.to_bits();
        let (biased, fraction) = ((bits >> 52 & 0x7ff) as i32, (bits & ((1 << 52) - 1)) as i64);
        let value = if biased == 0 { fraction } else { fraction | 1 << 52 };
        (if x < 0.0 { -value } else { value }, biased.max(1))
    };
    let numbers = triangles.clone().flat_map(|(corners, _)| corners).flat_map(|corner| points.point(corner));
    let least = numbers.filter(|&x| x != 0.0).map(|x| parts(x).1).min().unwrap_or(0);
    let integer = |x: f64| {
        let (value, exponent) = parts(x);
        IBig::from(value) << (exponent - least).max(0) as usize
    };
    let mut sum = IBig::ZERO;
    for (corners, sign) in triangles {
        let [a, b, c] = corners.map(|corner| points.point(corner).map(integer));
        let minor = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
        let term = &a[0] * minor(1, 2) + &a[1] * minor(2, 0) + &a[2] * minor(0, 1);
        if sign == Sign::Plus { sum += term } else { sum -= term }
    }
    sum.cmp(&IBig::ZERO)
}
