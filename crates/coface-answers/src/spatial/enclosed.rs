//! Volumes that polygons enclose, by their signs.

use super::boolean::EXTERIOR;
use coface_algebra::{RaggedArray, Sign, VertexId};
use coface_geometry::predicates::Dyadic;
use coface_geometry::{Positions, determinant};
use rayon::prelude::*;
use std::cmp::Ordering;

/// A corner of each part that polygons do not enclose with their fronts outward: rounding made it flat or turned it inside
/// out. `sides` has the parts behind and before each polygon.
pub(super) fn turned_parts(
    positions: &Positions,
    polygons: &RaggedArray,
    sides: impl Fn(usize) -> [u32; 2],
) -> Vec<[f64; 3]> {
    let (mut parts, mut packed) = (Vec::new(), Vec::new());
    for polygon in 0..polygons.len() {
        let [back, front] = sides(polygon);
        for (part, against) in [(back, 0), (front, 1)] {
            if back != front && part != EXTERIOR {
                parts.push(part);
                packed.push(2 * polygon as u32 + against);
            }
        }
    }
    let count = parts.iter().max().map_or(0, |&last| last as usize + 1);
    let own = RaggedArray::grouped(count, parts.into_iter());
    (0..count)
        .into_par_iter()
        .filter_map(|part| {
            let faces = || {
                own.list(part).iter().map(|&at| {
                    let polygon = packed[at as usize];
                    let sign = Sign::power_of_minus_one((polygon & 1) as usize);
                    (sign, polygons.list((polygon >> 1) as usize))
                })
            };
            let (_, first) = faces().next()?;
            let point = positions.point(VertexId::from_u32(first[0]));
            volume_order(positions, faces).is_le().then(|| [point[0], point[1], point[2]])
        })
        .collect()
}

/// The sign of the volume that polygons enclose, as 1, -1, or 1 for none: 1 where they run counterclockwise seen from outside.
pub(super) fn volume_sign<'a, I: Iterator<Item = (Sign, &'a [u32])>>(
    positions: &Positions,
    faces: impl Fn() -> I,
) -> i32 {
    if volume_order(positions, faces).is_lt() { -1 } else { 1 }
}

/// How the volume that polygons enclose, each cut into triangles at its first corner, compares with 0. Exact.
fn volume_order<'a, I: Iterator<Item = (Sign, &'a [u32])>>(
    positions: &Positions,
    faces: impl Fn() -> I,
) -> Ordering {
    let point = |vertex: u32| {
        let point = positions.point(VertexId::from_u32(vertex));
        [point[0], point[1], point[2]]
    };
    let Some(apex) = faces().next().map(|(_, face)| point(face[0])) else { return Ordering::Equal };
    let relative = |vertex: u32| {
        let point = point(vertex);
        [0, 1, 2].map(|axis| point[axis] - apex[axis])
    };
    let (mut sum, mut size, mut count) = (0.0, 0.0, 0);
    for (sign, face) in faces() {
        for pair in face[1..].windows(2) {
            let [a, b, c] = [face[0], pair[0], pair[1]].map(relative);
            sum += f64::from(sign.to_i32()) * determinant(a, b, c);
            size += (0..3)
                .map(|i| {
                    a[i].abs()
                        * (b[(i + 1) % 3] * c[(i + 2) % 3]).abs().max((b[(i + 2) % 3] * c[(i + 1) % 3]).abs())
                })
                .sum::<f64>();
            count += 1;
        }
    }
    // Each term is off by less than 16 units of its size, the sum by one unit of that for each term.
    let bound = size * f64::EPSILON * f64::from(count + 16) * 2.0;
    if size.is_finite() && size > f64::MIN_POSITIVE * 1e40 && sum.abs() > bound {
        return sum.total_cmp(&0.0);
    }
    let mut exact = Dyadic::from(0.0);
    let apex = apex.map(Dyadic::from);
    for (sign, face) in faces() {
        for pair in face[1..].windows(2) {
            let [a, b, c] = [face[0], pair[0], pair[1]].map(|vertex| {
                let point = point(vertex).map(Dyadic::from);
                [0, 1, 2].map(|axis| &point[axis] - &apex[axis])
            });
            for (i, x) in a.iter().enumerate() {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                let minor = &(&b[j] * &c[k]) - &(&b[k] * &c[j]);
                let term = x * &minor;
                exact = match sign {
                    Sign::Plus => &exact + &term,
                    Sign::Minus => &exact - &term,
                };
            }
        }
    }
    exact.sign()
}
