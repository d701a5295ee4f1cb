//! Where edges of an interface come near each other, and what is done there.

use super::contacts::{Contact, contacts};
use super::fronts::patch;
use super::markers::polyline_length;
use crate::curve::distance;
use crate::{
    Curve, DirectedEdge, InterfaceGraph, InterfaceOptions, Kinks, KnotIndex, Order, Overlaps, SetLocation,
    YinSet,
};
use coface_algebra::{EdgeId, Error};
use std::collections::BTreeMap;

/// As in repairs: edges go on smoothly into each other where they turn by at most this angle, in radians.
const SMOOTH_ANGLE: f64 = 1e-6;

/// Two places of edges that are near each other, with the phase between them and those beyond.
#[derive(Clone, Debug)]
pub(super) struct EdgeContact {
    contact: Contact,
    between: Option<u32>,
    beyond: [Option<u32>; 2],
}

impl EdgeContact {
    /// The point halfway between the two places.
    pub(super) fn place(&self) -> [f64; 2] {
        self.contact.place()
    }

    /// The phases that are concerned, rising.
    pub(super) fn phases(&self) -> Vec<u32> {
        let mut all: Vec<u32> =
            [self.between, self.beyond[0], self.beyond[1]].into_iter().flatten().collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The phases that come together, if they are two.
    pub(super) fn meeting(&self) -> Option<Vec<u32>> {
        let [first, second] = self.beyond;
        (first != second).then(|| {
            let mut both: Vec<u32> = [first, second].into_iter().flatten().collect();
            both.sort_unstable();
            both
        })
    }
}

/// A component of a phase, or of what is in none, that is narrow all along.
pub(super) struct Sliver {
    walk: Vec<DirectedEdge>,
    pub(super) phase: Option<u32>,
    /// The phase around it that it has most of its boundary in common with.
    pub(super) heir: Option<u32>,
    pub(super) place: [f64; 2],
}

impl InterfaceGraph {
    /// The phases that edges name, and what is in none.
    fn regions(&self) -> impl Iterator<Item = Option<u32>> {
        self.phases().into_iter().map(Some).chain([None])
    }

    /// The places where edges come nearer to each other than a distance, the nearest first. Around junctions and where phases are pointed there are
    /// none.
    pub(super) fn contacts(&self, within: f64) -> Result<Vec<EdgeContact>, Error> {
        let mut found = Vec::new();
        for region in self.regions() {
            let walks = self.walks_of(region);
            let curves = walks.iter().map(|walk| self.walk_curve(walk)).collect::<Result<Vec<_>, Error>>()?;
            let own = contacts(&curves.iter().collect::<Vec<&Curve<'static>>>(), within);
            if own.is_empty() {
                continue;
            }
            let set = self.unchecked_region(region)?;
            for contact in own {
                if set.locate(contact.place())? == SetLocation::Inside {
                    let beyond =
                        [0, 1].map(|end| self.beyond(&walks[contact.curves[end]], contact.pieces[end]));
                    found.push(EdgeContact { contact, between: region, beyond });
                }
            }
        }
        found.sort_by(|a: &EdgeContact, b| a.contact.distance().total_cmp(&b.contact.distance()));
        Ok(found)
    }

    /// The phase on the right of a walk at one of its pieces.
    fn beyond(&self, walk: &[DirectedEdge], piece: usize) -> Option<u32> {
        let mut first = 0;
        for edge in walk {
            first += self.curve(edge.edge).piece_count();
            if piece < first {
                return self.left(edge.reversed());
            }
        }
        None
    }

    /// A phase, or what is in none, as a set with its kinks.
    fn region_set(&self, region: Option<u32>) -> Result<YinSet, Error> {
        let mut set = self.unchecked_region(region)?;
        if let Some(phase) = region {
            let kinks = (0..).zip(self.phase_kinks(phase));
            let kinks =
                kinks.flat_map(|(curve, own)| own.into_iter().map(move |knot| KnotIndex { curve, knot }));
            *set.kinks_mut() = Kinks::new(kinks.collect());
        }
        Ok(set)
    }

    /// The interface in which parts of the plane belong to other phases, or to none.
    fn with_parts(&self, parts: &[(YinSet, Option<u32>)]) -> Result<Self, Error> {
        let phases = self.phases();
        let own =
            phases.iter().map(|&phase| self.region_set(Some(phase))).collect::<Result<Vec<_>, Error>>()?;
        let sets: Vec<&YinSet> = parts.iter().map(|(set, _)| set).chain(&own).collect();
        let names: Vec<Option<u32>> =
            parts.iter().map(|&(_, name)| name).chain(phases.into_iter().map(Some)).collect();
        let options = InterfaceOptions {
            order: self.order(),
            smooth_angle: SMOOTH_ANGLE,
            overlaps: Overlaps::ToTheFirst,
        };
        Self::of_named_sets(&sets, &names, &options)
    }

    /// The interface in which what lies beyond the edges of a contact has come together: a rectangle over the gap is taken out of the phase
    /// between them, as much wider as it has to be. Where one phase is beyond both edges it gets the rectangle, where two are each gets the half at
    /// its side.
    pub(super) fn bridged(&self, found: &EdgeContact, within: f64) -> Result<Self, Error> {
        /// So much larger rectangles are tried where a smaller one changes nothing.
        const SIZES: [f64; 3] = [1.0, 2.0, 4.0];
        let EdgeContact { contact, between, beyond } = found;
        let gap = self.region_set(*between)?;
        let before = (self.counts_of(*between)?, self.counts_of(beyond[0])?, self.common_edges(*beyond));
        for size in SIZES {
            let parts = match beyond[0] == beyond[1] {
                true => vec![(patch(contact.points, size * within, self.order())?, beyond[0])],
                false => (0..2)
                    .map(|end| Ok((half_patch(contact, end, size * within, self.order())?, beyond[end])))
                    .collect::<Result<Vec<_>, Error>>()?,
            };
            let parts = parts.into_iter().map(|(part, name)| Ok((part.meet(&gap)?, name)));
            let graph = self.with_parts(&parts.collect::<Result<Vec<_>, Error>>()?)?;
            let after =
                (graph.counts_of(*between)?, graph.counts_of(beyond[0])?, graph.common_edges(*beyond));
            if after != before && (beyond[0] == beyond[1] || after.2 > before.2) {
                return Ok(graph);
            }
        }
        let [x, y] = contact.place();
        Err(Error::invalid(format!(
            "phases cannot come together where their edges are in contact, near ({x}, {y})"
        ))
        .with_cure("give another distance of contacts, or keep contacts"))
    }

    /// The numbers of components and holes of a phase; nothing is counted of what is in none.
    fn counts_of(&self, region: Option<u32>) -> Result<[usize; 2], Error> {
        match region.filter(|&phase| !self.walks_of(Some(phase)).is_empty()) {
            Some(phase) => self.phase_set(phase)?.betti_open(),
            None => Ok([0; 2]),
        }
    }

    /// The number of edges that two phases have in common.
    fn common_edges(&self, [first, second]: [Option<u32>; 2]) -> usize {
        let sides = |edge: usize| self.phases_of(EdgeId::new(edge));
        (0..self.edge_count())
            .filter(|&edge| [[first, second], [second, first]].contains(&sides(edge)))
            .count()
    }

    /// The components of phases, and of what is in none, whose mean width is below half of a distance. The mean width is twice the area by the length of
    /// the boundary, half the width for a disk.
    pub(super) fn slivers(&self, within: f64) -> Result<Vec<Sliver>, Error> {
        let mut found = Vec::new();
        for region in self.regions() {
            for walk in self.walks_of(region) {
                let curve = self.walk_curve(&walk)?;
                let knots: Vec<[f64; 2]> =
                    (0..=curve.piece_count()).map(|knot| curve.knot_point(knot)).collect();
                let area = curve.signed_area();
                if area <= 0.0 || 2.0 * area >= 0.5 * within * polyline_length(&knots) {
                    continue;
                }
                let mut shares: BTreeMap<Option<u32>, f64> = BTreeMap::new();
                for edge in &walk {
                    let own = self.curve(edge.edge);
                    let length: f64 = (0..own.piece_count())
                        .map(|piece| distance(own.knot_point(piece), own.knot_point(piece + 1)))
                        .sum();
                    *shares.entry(self.left(edge.reversed())).or_default() += length;
                }
                let heir = shares.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).and_then(|(phase, _)| phase);
                let part = 1.0 / (knots.len() - 1) as f64;
                let place = [0, 1].map(|axis| knots[1..].iter().map(|point| part * point[axis]).sum());
                found.push(Sliver { walk, phase: region, heir, place });
            }
        }
        Ok(found)
    }

    /// The interface without slivers that it did not have before it was cut and pasted: where edges that run side by side cross by the error of tracking,
    /// that leaves slivers between their crossings.
    pub(super) fn without_fresh_slivers(self, before: &Self, within: f64) -> Result<Self, Error> {
        let is_known = |edge: &DirectedEdge, graph: &Self| {
            let own = graph.curve(edge.edge).controls();
            let is_same = |other: &[[f64; 2]]| own == other || own.iter().rev().eq(other);
            (0..before.edge_count()).any(|other| is_same(before.curve(EdgeId::new(other)).controls()))
        };
        let mut graph = self;
        for _ in 0..=graph.edge_count() {
            let found = graph.slivers(within)?;
            let fresh =
                found.into_iter().find(|sliver| !sliver.walk.iter().all(|edge| is_known(edge, &graph)));
            match fresh {
                None => break,
                Some(sliver) => graph = graph.without_sliver(&sliver)?,
            }
        }
        Ok(graph)
    }

    /// The interface without a sliver, which belongs to its heir.
    pub(super) fn without_sliver(&self, sliver: &Sliver) -> Result<Self, Error> {
        let around = YinSet::new(&[self.walk_curve(&sliver.walk)?])?;
        let part = around.meet(&self.region_set(sliver.phase)?)?;
        self.with_parts(&[(part, sliver.heir)])
    }
}

/// The half of a rectangle over a gap that lies at one of its ends.
fn half_patch(contact: &Contact, end: usize, size: f64, order: Order) -> Result<YinSet, Error> {
    let [p, q] = contact.points;
    let far = distance(p, q);
    let along = [0, 1].map(|axis| (q[axis] - p[axis]) / far * 0.5 * size);
    let across = [-2.0 * along[1], 2.0 * along[0]];
    let corner = |at: [f64; 2], ahead: f64, aside: f64| {
        [0, 1].map(|axis| at[axis] + ahead * along[axis] + aside * across[axis])
    };
    let middle = contact.place();
    // Both halves have the corners in the middle bit for bit.
    let sides = [corner(middle, 0.0, -1.0), corner(middle, 0.0, 1.0)];
    let corners = match end {
        0 => [corner(p, -1.0, -1.0), sides[0], sides[1], corner(p, -1.0, 1.0)],
        _ => [sides[0], corner(q, 1.0, -1.0), corner(q, 1.0, 1.0), sides[1]],
    };
    let closed: Vec<[f64; 2]> = corners.into_iter().chain([corners[0]]).collect();
    let kinks: Vec<KnotIndex> = (0..4).map(|knot| KnotIndex { curve: 0, knot }).collect();
    YinSet::new(&[Curve::polyline(&closed)?.raised(order)?])?.with_declared_kinks(&kinks, None, None)
}
