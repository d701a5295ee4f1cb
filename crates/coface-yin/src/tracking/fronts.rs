//! Curves on their way.

use super::contacts::{Contact, contacts};
use super::markers::{MarkerRange, moved_markers, polyline_length};
use super::{EventKind, TrackingCounts};
use crate::curve::distance;
use crate::kinks::are_surely_apart;
use crate::set::{CurveArena, Lying, lying};
use crate::{
    Combination, Curve, EndCondition, Kinks, KnotIndex, Order, PieceSource, SetLocation, YinFault, YinSet,
};
use coface_algebra::Error;
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use std::collections::BTreeSet;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// A curve on its way.
#[derive(Clone)]
struct Front {
    curve: Curve<'static>,
    /// Its kinks, rising, with their names.
    kinks: Vec<(u32, u32)>,
    /// Its number at the beginning.
    origin: u32,
    parent: Option<u32>,
    /// Whether it was made of parts of curves when they were last cut and pasted.
    is_pasted: bool,
}

impl Front {
    fn kink_name(&self, knot: u32) -> Option<u32> {
        let at = self.kinks.binary_search_by_key(&knot, |&(own, _)| own).ok()?;
        Some(self.kinks[at].1)
    }
}

/// A curve that became too short to have a shape.
pub(super) struct Gone {
    /// Its number at the beginning.
    pub(super) origin: u32,
    /// The length of the polygon of its markers.
    pub(super) length: f64,
    /// The mean of its markers.
    pub(super) place: [f64; 2],
    /// Whether it ran counterclockwise around a component, not clockwise around a hole.
    pub(super) is_positive: bool,
}

/// The boundary of a set on its way.
#[derive(Clone)]
pub(super) struct Fronts {
    order: Order,
    is_unbounded: bool,
    fronts: Vec<Front>,
    next_name: u32,
    ends: EndCondition,
}

impl Fronts {
    pub(super) fn new(set: &YinSet) -> Self {
        let mut fronts: Vec<Front> = (0..set.curve_count())
            .map(|curve| Front {
                curve: set.curve(curve).into_owned(),
                kinks: Vec::new(),
                origin: curve as u32,
                parent: set.forest().parent(curve).map(|parent| parent as u32),
                is_pasted: false,
            })
            .collect();
        for (at, name) in set.kinks().iter() {
            fronts[at.curve as usize].kinks.push((at.knot, name.to_u32()));
        }
        Self {
            order: set.order(),
            is_unbounded: !set.is_bounded(),
            fronts,
            next_name: set.kinks().next_name(),
            ends: set.kinks().ends().clone(),
        }
    }

    /// Moves all curves by a map. Gives those that vanished, by their numbers at the beginning.
    pub(super) fn advance(
        &mut self,
        map: &impl Fn(&[[f64; 2]]) -> Vec<[f64; 2]>,
        range: MarkerRange,
        counts: &mut TrackingCounts,
    ) -> Result<Vec<Gone>, Error> {
        let mut inner_counts = self.inner_counts();
        let mut vanished = Vec::new();
        let mut stays = vec![true; self.fronts.len()];
        let (order, is_positive) = (self.inside_out(), self.are_positive());
        for number in order {
            let front = &mut self.fronts[number];
            let range = range.for_curve(&front.curve);
            let is_kink = |knot: usize| front.kink_name(knot as u32).is_some();
            let moved = moved_markers(&front.curve, is_kink, map, range, counts)?;
            let length = polyline_length(&moved.points);
            let ring = &moved.points[..moved.points.len() - 1];
            if inner_counts[number] == 0 && (ring.len() < 3 || length < 3.0 * range.least) {
                stays[number] = false;
                let part = 1.0 / ring.len() as f64;
                let place = [0, 1].map(|axis| ring.iter().map(|point| part * point[axis]).sum());
                vanished.push(Gone { origin: front.origin, length, place, is_positive: is_positive[number] });
                // What lies in it has vanished before.
                if let Some(parent) = front.parent {
                    inner_counts[parent as usize] -= 1;
                }
                continue;
            }
            let name = |knot: u32| front.kink_name(moved.origins[knot as usize]?).map(|name| (knot, name));
            front.kinks = (0..ring.len() as u32).filter_map(name).collect();
            let kinks: Vec<u32> = front.kinks.iter().map(|&(knot, _)| knot).collect();
            front.curve = match &moved.parameters {
                Some(kept) => Curve::fit_closed_at(ring, kept, &kinks, self.order, &self.ends)?,
                None => Curve::fit_closed_by_length(ring, &kinks, self.order, &self.ends)?,
            };
        }
        vanished.sort_by_key(|gone| gone.origin);
        if !vanished.is_empty() {
            self.retain(&stays);
        }
        Ok(vanished)
    }

    /// For each curve the number of those directly in it.
    fn inner_counts(&self) -> Vec<u32> {
        let mut counts = vec![0u32; self.fronts.len()];
        for parent in self.fronts.iter().filter_map(|front| front.parent) {
            counts[parent as usize] += 1;
        }
        counts
    }

    /// For each curve whether it runs counterclockwise around a component.
    fn are_positive(&self) -> Vec<bool> {
        let mut found = vec![false; self.fronts.len()];
        for number in self.inside_out().into_iter().rev() {
            let parent = self.fronts[number].parent;
            found[number] = parent.map_or(!self.is_unbounded, |parent| !found[parent as usize]);
        }
        found
    }

    /// The numbers of components and holes: of positive curves, with one for an unbounded set, and of negative ones.
    pub(super) fn counts(&self) -> [usize; 2] {
        let positive = self.are_positive().into_iter().filter(|&is_positive| is_positive).count();
        [positive + usize::from(self.is_unbounded), self.fronts.len() - positive]
    }

    /// A knot of the curve that had this number at the beginning, or of another one.
    pub(super) fn knot_of(&self, origin: usize) -> Option<[f64; 2]> {
        let front = self.fronts.iter().find(|front| front.origin as usize == origin);
        Some(front.or(self.fronts.first())?.curve.knot_point(0))
    }

    /// The places where the curves come nearer to each other or to themselves than a distance.
    pub(super) fn contacts(&self, within: f64) -> Vec<Contact> {
        let curves: Vec<&Curve<'static>> = self.fronts.iter().map(|front| &front.curve).collect();
        contacts(&curves, within)
    }

    /// Changes the set at a contact: joins what is around a gap, or cuts through a neck, by a rectangle over it whose sides are a little
    /// longer than the distance of contacts. Gives the change, unless what it cuts off is too small to stay.
    pub(super) fn bridge(
        &mut self,
        contact: &Contact,
        within: f64,
        range: MarkerRange,
    ) -> Result<Option<EventKind>, Error> {
        /// So much larger rectangles are tried where a smaller one changes nothing.
        const SIZES: [f64; 3] = [1.0, 2.0, 4.0];
        let before = self.counts();
        let is_positive = self.are_positive();
        let are_negative = contact.curves.iter().all(|&curve| !is_positive[curve]);
        let set = self.set();
        let is_neck = set.locate(contact.place())? == SetLocation::Inside;
        let formula = if is_neck { BooleanFormula::difference(2) } else { BooleanFormula::union(2) };
        for size in SIZES {
            let patch = patch(contact.points, size * within, self.order)?;
            let mut bridged = self.clone();
            let combination = YinSet::combine(&[&set, &patch], &formula)?;
            bridged.take(&combination, |source| (source.operand == 0).then_some(source.curve as usize));
            let [components, holes] = bridged.counts();
            let kind = match is_neck {
                true if components > before[0] => EventKind::ComponentSplits,
                true if holes < before[1] && are_negative => EventKind::HolesMerge,
                true if holes < before[1] => EventKind::HoleOpens,
                false if components < before[0] => EventKind::ComponentsMerge,
                false if holes > before[1] && are_negative => EventKind::HoleSplits,
                false if holes > before[1] => EventKind::HoleForms,
                _ => continue,
            };
            bridged.drop_small(range);
            *self = bridged;
            return Ok(Some(kind).filter(|_| self.counts() != before));
        }
        let [x, y] = contact.place();
        Err(Error::invalid(format!(
            "the set cannot be cut or joined where its boundary is in contact, near ({x}, {y})"
        ))
        .with_cure("give another distance of contacts, or keep contacts"))
    }

    /// Leaves out curves in which no others lie that would vanish in the next step.
    pub(super) fn drop_small(&mut self, range: MarkerRange) {
        let inner_counts = self.inner_counts();
        let stays: Vec<bool> = (self.fronts.iter().zip(inner_counts))
            .map(|(front, inner_count)| {
                let knots: Vec<[f64; 2]> =
                    (0..=front.curve.piece_count()).map(|knot| front.curve.knot_point(knot)).collect();
                inner_count > 0 || polyline_length(&knots) >= 3.0 * range.for_curve(&front.curve).least
            })
            .collect();
        self.retain(&stays);
    }

    /// Takes out curves without others in them that are narrow all along: slivers of gaps that close and of necks that thin out. What is
    /// narrower than the distance of contacts is in contact, and the mean width of a curve is twice its area by its length, half its width for
    /// a disk.
    pub(super) fn close_slivers(&mut self, within: f64) -> Vec<Gone> {
        self.close_slivers_where(within, |_| true)
    }

    /// The same for curves that were made of parts of others when they were last cut and pasted: where boundaries that run side by side cross by the error of
    /// tracking, that leaves slivers between their crossings.
    pub(super) fn close_pasted_slivers(&mut self, within: f64) -> Vec<Gone> {
        self.close_slivers_where(within, |front| front.is_pasted)
    }

    fn close_slivers_where(&mut self, within: f64, is_asked: impl Fn(&Front) -> bool) -> Vec<Gone> {
        let (inner_counts, is_positive) = (self.inner_counts(), self.are_positive());
        let mut stays = vec![true; self.fronts.len()];
        let mut slivers = Vec::new();
        for (number, front) in self.fronts.iter().enumerate() {
            let knots: Vec<[f64; 2]> =
                (0..=front.curve.piece_count()).map(|knot| front.curve.knot_point(knot)).collect();
            let length = polyline_length(&knots);
            if !is_asked(front)
                || inner_counts[number] > 0
                || 2.0 * front.curve.signed_area().abs() >= 0.5 * within * length
            {
                continue;
            }
            stays[number] = false;
            let part = 1.0 / (knots.len() - 1) as f64;
            let place = [0, 1].map(|axis| knots[1..].iter().map(|point| part * point[axis]).sum());
            slivers.push(Gone { origin: front.origin, length, place, is_positive: is_positive[number] });
        }
        if !slivers.is_empty() {
            self.retain(&stays);
        }
        slivers
    }

    /// The numbers of all curves, each behind those that lie in it.
    fn inside_out(&self) -> Vec<usize> {
        let mut depths: Vec<Option<u32>> = vec![None; self.fronts.len()];
        let mut way = Vec::new();
        for start in 0..self.fronts.len() {
            // Up to a curve whose depth is known, and down again.
            let mut at = Some(start);
            let mut depth = 0;
            while let Some(number) = at {
                if let Some(known) = depths[number] {
                    depth = known + 1;
                    break;
                }
                way.push(number);
                at = self.fronts[number].parent.map(|parent| parent as usize);
            }
            while let Some(number) = way.pop() {
                depths[number] = Some(depth);
                depth += 1;
            }
        }
        let mut order: Vec<usize> = (0..self.fronts.len()).collect();
        order.sort_by_key(|&number| std::cmp::Reverse(depths[number]));
        order
    }

    /// Leaves curves out in which no others lie.
    fn retain(&mut self, stays: &[bool]) {
        let mut numbers = vec![NONE; stays.len()];
        let kept_numbers = numbers.iter_mut().zip(stays).filter(|(_, stays)| **stays);
        (0..).zip(kept_numbers).for_each(|(at, (number, _))| *number = at);
        let mut kept = stays.iter();
        self.fronts.retain(|_| *kept.next().expect("there is an entry for each curve"));
        for parent in self.fronts.iter_mut().filter_map(|front| front.parent.as_mut()) {
            *parent = numbers[*parent as usize];
        }
    }

    fn arena(&self) -> CurveArena {
        let count = self.fronts.iter().map(|front| front.curve.piece_count()).sum();
        let mut arena = CurveArena::with_capacity(self.order, count, self.fronts.len());
        self.fronts.iter().for_each(|front| arena.push(&front.curve));
        arena
    }

    /// What keeps the curves from bounding a set in which they lie as before. Where they are clearly apart it is not looked, unless that
    /// is asked for, whether one of them has jumped over another.
    ///
    /// # Errors
    /// If that cannot be decided.
    pub(super) fn fault(&self, is_thorough: bool) -> Result<Option<YinFault>, Error> {
        let named =
            || (0..).zip(&self.fronts).map(|(number, front)| (front.curve.as_borrowed(), [number; 2]));
        if self.fronts.is_empty() || (!is_thorough && are_surely_apart(named())) {
            return Ok(None);
        }
        let origin = |curve: usize| self.fronts[curve].origin as usize;
        let Lying { parents, is_positive, .. } = match lying(&self.arena())? {
            Ok(lying) => lying,
            Err(fault) => return Ok(Some(fault.renumbered(origin))),
        };
        let is_turned = |&curve: &usize| {
            parents[curve] != self.fronts[curve].parent
                || (parents[curve].is_none() && is_positive[curve] == self.is_unbounded)
        };
        // Curves that do not meet have changed places: one of them has jumped over another, or turned inside out.
        Ok((0..self.fronts.len()).find(is_turned).map(|curve| {
            let other = parents[curve].or(self.fronts[curve].parent).map_or(curve, |other| other as usize);
            YinFault::Crossing {
                curves: [origin(curve), origin(other)],
                point: self.fronts[curve].curve.knot_point(0),
            }
        }))
    }

    /// Cuts the curves where they meet and pastes them to the boundary of what a rule says is inside.
    pub(super) fn repair(&mut self, rule: InsideRule) -> Result<(), Error> {
        let curves: Vec<(Curve<'_>, Vec<u32>)> = self
            .fronts
            .iter()
            .map(|front| (front.curve.clone(), front.kinks.iter().map(|&(knot, _)| knot).collect()))
            .collect();
        let combination = YinSet::combine_kinked_curves(&curves, i32::from(self.is_unbounded), rule)?;
        self.take(&combination, |source| Some(source.operand as usize));
        Ok(())
    }

    /// Takes the boundary of a combination instead of the curves; `front_of` says which curve a piece comes from, if it is one.
    fn take(&mut self, combination: &Combination, front_of: impl Fn(&PieceSource) -> Option<usize>) {
        let sources = combination.sources();
        let set = combination.set();
        let mut first = 0;
        let mut fronts = Vec::with_capacity(set.curve_count());
        for number in 0..set.curve_count() {
            let curve = set.curve(number).into_owned();
            let own = &sources[first..first + curve.piece_count()];
            first += own.len();
            let origin = own.iter().filter_map(&front_of).map(|front| self.fronts[front].origin).min();
            let mut kinks = Vec::new();
            for knot in set.kinks().on_curve(number as u32) {
                // The name that the kink had before, if it was one.
                let source = own[knot as usize];
                let known = front_of(&source).and_then(|front| {
                    let front = &self.fronts[front];
                    let count = front.curve.piece_count() as u32;
                    match source.range[0] {
                        0.0 => front.kink_name(source.piece),
                        1.0 => front.kink_name((source.piece + 1) % count),
                        _ => None,
                    }
                });
                kinks.push((knot, known));
            }
            let first_front = own.first().and_then(&front_of);
            let is_whole = first_front.is_some_and(|front| {
                own.len() == self.fronts[front].curve.piece_count()
                    && own.iter().all(|source| {
                        front_of(source) == Some(front) && [[0.0, 1.0], [1.0, 0.0]].contains(&source.range)
                    })
            });
            fronts.push((curve, kinks, origin.unwrap_or_default(), set.forest().parent(number), !is_whole));
        }
        let mut used: BTreeSet<u32> = BTreeSet::new();
        self.fronts = fronts
            .into_iter()
            .map(|(curve, kinks, origin, parent, is_pasted)| {
                let mut named = |known: Option<u32>| {
                    // Where curves touch in a kink only one of them keeps its name.
                    known.filter(|&name| used.insert(name)).unwrap_or_else(|| {
                        self.next_name += 1;
                        self.next_name - 1
                    })
                };
                let kinks = kinks.into_iter().map(|(knot, known)| (knot, named(known))).collect();
                Front { curve, kinks, origin, parent: parent.map(|parent| parent as u32), is_pasted }
            })
            .collect();
        self.is_unbounded = !set.is_bounded();
    }

    /// The set.
    fn set(&self) -> YinSet {
        let parents = self.fronts.iter().map(|front| front.parent).collect();
        let mut set = YinSet::from_parts(self.arena(), self.is_unbounded, parents, Vec::new());
        let kinks = (0..).zip(&self.fronts).flat_map(|(curve, front)| {
            front.kinks.iter().map(move |&(knot, name)| (KnotIndex { curve, knot }, name))
        });
        *set.kinks_mut() = Kinks::named(kinks.collect(), Some(self.next_name)).with_ends(&self.ends);
        set
    }

    /// The set, and the number that each of its curves had at the beginning.
    pub(super) fn into_set(self) -> (YinSet, Vec<u32>) {
        (self.set(), self.fronts.iter().map(|front| front.origin).collect())
    }
}

/// A rectangle over the gap between two points: twice as wide as `size`, so that its sides are not in contact, and half of that longer at
/// both ends. All its corners are kinks.
pub(super) fn patch([p, q]: [[f64; 2]; 2], size: f64, order: Order) -> Result<YinSet, Error> {
    let far = distance(p, q);
    let along = [0, 1].map(|axis| (q[axis] - p[axis]) / far * 0.5 * size);
    let across = [-2.0 * along[1], 2.0 * along[0]];
    let corner = |at: [f64; 2], ahead: f64, aside: f64| {
        [0, 1].map(|axis| at[axis] + ahead * along[axis] + aside * across[axis])
    };
    let first = corner(p, -1.0, -1.0);
    let corners = [first, corner(q, 1.0, -1.0), corner(q, 1.0, 1.0), corner(p, -1.0, 1.0), first];
    let curve = Curve::polyline(&corners)?.raised(order)?;
    let kinks: Vec<KnotIndex> = (0..4).map(|knot| KnotIndex { curve: 0, knot }).collect();
    YinSet::new(&[curve])?.with_declared_kinks(&kinks, None, None)
}
