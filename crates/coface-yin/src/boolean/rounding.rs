//! Whether the polygons of a result can have come to meet when their corners were rounded.
//!
//! Corners are exact until the result is written in floating-point numbers. A corner is moved by less than the rounding of the largest
//! coordinate then; so curves can only have come to meet, or changed their order around a common corner, where sides come nearer than a few
//! times that. Only where they do, which is seldom, the result is checked as a whole, and repaired if need be.

use super::outline::Outline;
use coface_algebra::VertexId;
use coface_arrange::planar::{PlanarPolygons, VertexSource};
use coface_geometry::predicates::orientation;
use coface_geometry::{AxisBox, BoxTree};
use rayon::prelude::*;

/// How many times the rounding of the largest coordinate sides are apart that surely do not meet.
const SAFE: f64 = 16.0;

/// A side of the result.
#[derive(Clone, Copy)]
struct Side {
    ends: [[f64; 2]; 2],
    /// The corners of the polygons that it goes from and to.
    corners: [u32; 2],
    is_moved: bool,
}

/// Whether curves of an outline come so near each other that rounding may have made them meet.
pub(super) fn is_doubtful(polygons: &PlanarPolygons<'_>, outline: &Outline) -> bool {
    let corners = polygons.rings().items();
    let is_moved: Vec<bool> = (0..polygons.positions().len())
        .into_par_iter()
        .with_min_len(1 << 12)
        .map(|vertex| {
            let vertex = VertexId::new(vertex);
            matches!(polygons.source(vertex), VertexSource::Crossing(_))
                && !polygons.point(vertex).is_exactly_rounded()
        })
        .collect();
    if !is_moved.contains(&true) {
        return false;
    }
    if outline.collapsed_count > 0 || outline.edges.len() != corners.len() {
        return true;
    }
    let curves = &outline.curves;
    let mut sides = Vec::with_capacity(outline.edges.len());
    for curve in 0..curves.len() {
        let points = curves.curve(curve);
        let own = curves.first_piece(curve)..curves.first_piece(curve + 1);
        for (piece, place) in own.clone().enumerate() {
            let next = if place + 1 == own.end { own.start } else { place + 1 };
            let corners = [place, next].map(|place| corners[outline.edges[place] as usize]);
            let ends = [points.controls()[piece], points.controls()[piece + 1]];
            sides.push(Side {
                ends,
                corners,
                is_moved: corners.iter().any(|&corner| is_moved[corner as usize]),
            });
        }
    }
    let largest = curves.controls().as_flattened().iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let safe = SAFE * f64::EPSILON * largest;
    let box_of = |side: &Side| -> AxisBox {
        let [a, b] = side.ends;
        let [x, y] = [0, 1].map(|axis| [a[axis].min(b[axis]) - safe, a[axis].max(b[axis]) + safe]);
        [x, y, [0.0; 2]]
    };
    let boxes: Vec<AxisBox> = sides.par_iter().with_min_len(1 << 12).map(box_of).collect();
    let tree = BoxTree::new(&boxes);
    sides.par_iter().zip(&boxes).with_min_len(256).any(|(side, own)| {
        let mut is_near = false;
        if side.is_moved {
            tree.visit(own, |other| is_near |= comes_near(side, &sides[other as usize], safe));
        }
        is_near
    })
}

/// Whether two sides come nearer to each other than they surely stay apart, elsewhere than in a corner that they share.
fn comes_near(a: &Side, b: &Side, safe: f64) -> bool {
    if a.corners == b.corners {
        return false;
    }
    let shared = (0..2).find_map(|i| (0..2).find(|&j| a.corners[i] == b.corners[j]).map(|j| [i, j]));
    if let Some([i, j]) = shared {
        let way = |side: &Side, end: usize| minus(side.ends[1 - end], side.ends[end]);
        let (p, q) = (way(a, i), way(b, j));
        // The end of the shorter one is near the other side, ahead and not behind.
        let [short, long] = if size(p) <= size(q) { [p, q] } else { [q, p] };
        let across = (short[0] * long[1] - short[1] * long[0]) / size(long);
        return p[0] * q[0] + p[1] * q[1] > 0.0 && across.abs() <= safe;
    }
    let [[p, q], [r, s]] = [a.ends, b.ends];
    let is_near = |[from, to]: [[f64; 2]; 2], point: [f64; 2]| {
        let (way, offset) = (minus(to, from), minus(point, from));
        let part = ((way[0] * offset[0] + way[1] * offset[1]) / (size(way) * size(way))).clamp(0.0, 1.0);
        size([offset[0] - part * way[0], offset[1] - part * way[1]]) <= safe
    };
    let crosses =
        || orientation(p, q, r) != orientation(p, q, s) && orientation(r, s, p) != orientation(r, s, q);
    is_near([p, q], r) || is_near([p, q], s) || is_near([r, s], p) || is_near([r, s], q) || crosses()
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn size([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}
