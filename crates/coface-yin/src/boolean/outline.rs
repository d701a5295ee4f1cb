//! The boundary of a selection in canonical form.

use crate::Order;
use crate::set::{CanonicalOrder, CurveArena};
use coface_arrange::planar::PlanarPolygons;
use rayon::prelude::*;
use std::cmp::Ordering;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// The rings around selected faces as curves in canonical form.
pub(super) struct Outline {
    pub(super) curves: CurveArena,
    pub(super) parents: Vec<Option<u32>>,
    /// The edge of the polygons that each piece is.
    pub(super) edges: Vec<u32>,
    /// Rings that rounding left without three corners.
    pub(super) collapsed_count: usize,
}

/// A ring of polygons after rounding.
#[derive(Clone, Copy)]
struct RoundedRing {
    /// The corner that is lexicographically lowest, by its place on the ring.
    lowest: u32,
    /// How many corners are not at the place of the one before them.
    corner_count: u32,
}

impl Outline {
    pub(super) fn new(polygons: &PlanarPolygons<'_>, parents: &[Option<u32>]) -> Self {
        let positions = polygons.positions().as_flat().as_chunks::<2>().0;
        let lists = polygons.rings();
        let at = |ring: usize, place: u32| positions[lists.list(ring)[place as usize] as usize];
        let rounded: Vec<RoundedRing> = (0..lists.len())
            .into_par_iter()
            .with_min_len(64)
            .map(|ring| {
                let corners = lists.list(ring).iter().map(|&vertex| positions[vertex as usize]);
                let count = corners.len();
                let (mut lowest, mut lowest_point) = (0, [f64::INFINITY; 2]);
                let mut corner_count = 0;
                let mut last = positions[lists.list(ring)[count - 1] as usize];
                for (place, point) in (0..).zip(corners) {
                    if point != last {
                        corner_count += 1;
                        if point < lowest_point {
                            (lowest, lowest_point) = (place, point);
                        }
                    }
                    last = point;
                }
                RoundedRing { lowest, corner_count }
            })
            .collect();
        let is_collapsed = |ring: usize| rounded[ring].corner_count < 3;
        // The ring around each that is still there.
        let surrounding = |ring: usize| {
            let mut parent = parents[ring];
            while let Some(over) = parent.filter(|&over| is_collapsed(over as usize)) {
                parent = parents[over as usize];
            }
            parent
        };
        let kept: Vec<u32> = (0..lists.len() as u32).filter(|&ring| !is_collapsed(ring as usize)).collect();
        let mut place_of_ring = vec![NONE; lists.len()];
        for (place, &ring) in (0..).zip(&kept) {
            place_of_ring[ring as usize] = place;
        }
        let parents: Vec<Option<u32>> = kept
            .iter()
            .map(|&ring| surrounding(ring as usize).map(|over| place_of_ring[over as usize]))
            .collect();
        let walk = |kept_ring: u32| {
            let ring = kept[kept_ring as usize] as usize;
            let (lowest, count) = (rounded[ring].lowest, lists.list(ring).len() as u32);
            (lowest..count).chain(0..lowest)
        };
        let order = CanonicalOrder::new(
            &parents,
            |ring| at(kept[ring as usize] as usize, rounded[kept[ring as usize] as usize].lowest),
            |a, b| {
                let [first, second] = [a, b].map(|ring| kept[ring as usize] as usize);
                let points = walk(a).map(|place| at(first, place));
                points.partial_cmp(walk(b).map(|place| at(second, place))).unwrap_or(Ordering::Equal)
            },
        );
        let piece_count: usize = kept.iter().map(|&ring| rounded[ring as usize].corner_count as usize).sum();
        let mut curves = CurveArena::with_capacity(Order::LINEAR, piece_count, kept.len());
        let mut edges = Vec::with_capacity(piece_count);
        for &kept_ring in order.items() {
            let ring = kept[kept_ring as usize] as usize;
            let start = lists.start(ring) as u32;
            let corners = walk(kept_ring).map(|place| (start + place, at(ring, place)));
            // Of corners that rounding brought together the last one is the beginning of a piece with length.
            let first = edges.len();
            let mut last: Option<[f64; 2]> = None;
            curves.push_polyline(corners.filter_map(|(edge, point)| {
                if last == Some(point) {
                    edges.pop();
                    edges.push(edge);
                    return None;
                }
                last = Some(point);
                edges.push(edge);
                Some(point)
            }));
            debug_assert_eq!(edges.len() - first, rounded[ring].corner_count as usize);
        }
        Self { curves, parents: order.parents(&parents), edges, collapsed_count: lists.len() - kept.len() }
    }
}
