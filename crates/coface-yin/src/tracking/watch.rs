//! Steps in which it is looked for events, with their times narrowed.

use super::contacts::{Contact, fresh};
use super::fronts::{Fronts, Gone};
use super::sets::{Repair, VanishedCurve, met};
use super::{EventKind, OnContact, TopologyEvent, TrackingCounts, TrackingOptions};
use crate::YinFault;
use coface_algebra::Error;
use coface_arrange::boolean::InsideRule;

/// So often a step is halted; what comes after that in it has the time of its end.
const HALTS: usize = 64;

/// So often a step is halted at contacts and crossings that change no topology: fronts that are pressed together close a gap bit by bit.
const IDLE_HALTS: usize = 3;

/// What moves points from a time by a step.
type Map<'a> = &'a dyn Fn(&[[f64; 2]], f64, f64) -> Vec<[f64; 2]>;

/// Boundaries moved for a part of a step, and what came of that.
struct Trial {
    fronts: Fronts,
    counts: TrackingCounts,
    gone: Vec<Gone>,
    /// All contacts, and the first of them that were not there before the part.
    contacts: Vec<Contact>,
    fresh: Vec<Contact>,
    /// What keeps the curves from bounding a set, or that this cannot be decided; not looked for where something has gone or is in contact.
    fault: Result<Option<YinFault>, Error>,
}

/// It is looked for events in each step.
pub(super) struct Watch<'a> {
    options: &'a TrackingOptions,
    within: f64,
    tolerance: f64,
    /// The places of contacts that are kept.
    kept: Vec<[f64; 2]>,
    /// Whether boundaries that are kept cross.
    is_crossed: bool,
    vanished: Vec<VanishedCurve>,
    repairs: Vec<Repair>,
    events: Vec<TopologyEvent>,
}

impl<'a> Watch<'a> {
    pub(super) fn new(options: &'a TrackingOptions, tolerance: f64, fronts: &Fronts) -> Self {
        let within = options.contact_distance.unwrap_or(options.least_ratio * options.spacing);
        let mut watch = Self {
            options,
            within,
            tolerance,
            kept: Vec::new(),
            is_crossed: false,
            vanished: Vec::new(),
            repairs: Vec::new(),
            events: Vec::new(),
        };
        if options.on_contact == Some(OnContact::Keep) {
            watch.kept = fronts.contacts(within).iter().map(Contact::place).collect();
        }
        watch
    }

    /// Moves boundaries through a step, the number of which is counted from 1.
    pub(super) fn step(
        &mut self,
        mut fronts: Fronts,
        map: &impl Fn(&[[f64; 2]], f64, f64) -> Vec<[f64; 2]>,
        number: usize,
        [mut from, end]: [f64; 2],
        counts: &mut TrackingCounts,
    ) -> Result<Fronts, Error> {
        let mut idle_halts = 0;
        for halt in 0..=HALTS {
            let last = self.trial(&fronts, map, [from, end], *counts)?;
            let (mut found, mut until) = (last, end);
            if !self.is_quiet(&found) && halt < HALTS && idle_halts < IDLE_HALTS {
                let mut quiet = from;
                while (until - quiet).abs() > self.tolerance {
                    let middle = 0.5 * quiet + 0.5 * until;
                    if middle == quiet || middle == until {
                        break;
                    }
                    let trial = self.trial(&fronts, map, [from, middle], *counts)?;
                    if self.is_quiet(&trial) {
                        quiet = middle;
                    } else {
                        (found, until) = (trial, middle);
                    }
                }
            }
            *counts = found.counts;
            let before = fronts.counts();
            fronts = self.taken(found, before, number, until)?;
            idle_halts += usize::from(fronts.counts() == before);
            if until == end {
                break;
            }
            from = until;
        }
        Ok(fronts)
    }

    /// Moves boundaries for a part of a step and looks at them.
    fn trial(
        &self,
        fronts: &Fronts,
        map: Map<'_>,
        [from, until]: [f64; 2],
        mut counts: TrackingCounts,
    ) -> Result<Trial, Error> {
        let mut fronts = fronts.clone();
        let map = |points: &[[f64; 2]]| map(points, from, until - from);
        let mut gone = fronts.advance(&map, self.options.range(), &mut counts)?;
        if self.closes_slivers() {
            gone.extend(fronts.close_slivers(self.within));
        }
        let contacts = match self.options.on_contact {
            Some(_) => fronts.contacts(self.within),
            None => Vec::new(),
        };
        let fresh = fresh(self.options, self.within, &contacts, Contact::place, || map(&self.kept));
        // Where something happens anyway it is looked at once that is done.
        let fault = match gone.is_empty() && fresh.is_empty() {
            true => fronts.fault(false),
            false => Ok(None),
        };
        Ok(Trial { fronts, counts, gone, contacts, fresh, fault })
    }

    fn is_quiet(&self, trial: &Trial) -> bool {
        let is_crossed = !matches!(trial.fault, Ok(None));
        trial.gone.is_empty() && trial.fresh.is_empty() && (!is_crossed || self.is_crossed)
    }

    /// The boundaries of a trial after what is done about its events. `before` are the numbers of components and holes before the trial.
    fn taken(
        &mut self,
        trial: Trial,
        mut before: [usize; 2],
        step: usize,
        time: f64,
    ) -> Result<Fronts, Error> {
        let Trial { mut fronts, gone, contacts, mut fresh, mut fault, .. } = trial;
        if !(gone.is_empty() && fresh.is_empty()) {
            fault = fronts.fault(false);
        }
        before = self.push_gone(gone, before, time);
        let rule = self.rule();
        let is_undecided = fault.is_err();
        let fault = match self.options.on_contact {
            // What crosses for a while is looked at again at the end.
            Some(OnContact::Keep) => fault.unwrap_or(None),
            _ => fault?,
        };
        if let (Some(fault), Some(rule)) = (fault, rule) {
            self.repair(&mut fronts, fault, rule, before, (step, time))?;
            fresh = match self.options.on_contact {
                Some(OnContact::Merge) => fronts.contacts(self.within),
                _ => Vec::new(),
            };
        } else if let Some(fault) = fault {
            if self.options.on_contact != Some(OnContact::Keep) {
                return Err(met(fault));
            }
            if !self.is_crossed {
                self.push_contact(time, place_of(&fault, &fronts), before);
            }
        }
        self.is_crossed = is_undecided || (fault.is_some() && rule.is_none());
        match self.options.on_contact {
            Some(OnContact::Keep) => {
                for contact in fresh {
                    self.push_contact(time, contact.place(), before);
                }
                self.kept = contacts.iter().map(Contact::place).collect();
            }
            Some(OnContact::Merge) if !fresh.is_empty() => self.merge(&mut fronts, time)?,
            _ => {}
        }
        self.close_slivers(&mut fronts, time);
        Ok(fronts)
    }

    /// Takes out what has become narrow all along.
    fn close_slivers(&mut self, fronts: &mut Fronts, time: f64) {
        if self.closes_slivers() {
            let before = fronts.counts();
            let slivers = fronts.close_slivers(self.within);
            self.push_gone(slivers, before, time);
        }
    }

    /// What vanished, and the numbers of components and holes after that.
    fn push_gone(&mut self, all: Vec<Gone>, mut before: [usize; 2], time: f64) -> [usize; 2] {
        for gone in all {
            let (kind, axis) = match gone.is_positive {
                true => (EventKind::ComponentVanishes, 0),
                false => (EventKind::HoleVanishes, 1),
            };
            let mut after = before;
            after[axis] -= 1;
            self.events.push(TopologyEvent { time, kind, place: gone.place, before, after });
            self.vanished.push(VanishedCurve { curve: gone.origin, time, length: gone.length });
            before = after;
        }
        before
    }

    /// The rule by which boundaries that cross are cut and pasted.
    fn rule(&self) -> Option<InsideRule> {
        match self.options.on_contact {
            Some(OnContact::Merge) => Some(self.options.repair.unwrap_or(InsideRule::Positive)),
            _ => self.options.repair,
        }
    }

    /// Cuts and pastes boundaries that cross.
    fn repair(
        &mut self,
        fronts: &mut Fronts,
        fault: YinFault,
        rule: InsideRule,
        before: [usize; 2],
        (step, time): (usize, f64),
    ) -> Result<(), Error> {
        let place = place_of(&fault, fronts);
        fronts.repair(rule)?;
        fronts.drop_small(self.options.range());
        if !self.options.keep_small && self.options.on_contact.is_none() {
            let slivers = fronts.close_pasted_slivers(self.options.range().least);
            let gone = |gone: Gone| VanishedCurve { curve: gone.origin, time, length: gone.length };
            self.vanished.extend(slivers.into_iter().map(gone));
        }
        self.repairs.push(Repair { step, time, fault });
        self.push_differences(time, place, before, fronts.counts());
        Ok(())
    }

    /// Whether what is narrower than the distance of contacts all along goes.
    fn closes_slivers(&self) -> bool {
        self.options.on_contact == Some(OnContact::Merge) && !self.options.keep_small
    }

    /// Changes the set at its contacts, one after the other.
    fn merge(&mut self, fronts: &mut Fronts, time: f64) -> Result<(), Error> {
        /// More contacts than these in one place of time come from bridges that are in contact themselves.
        const MOST: usize = 1000;
        for _ in 0..MOST {
            let Some(contact) = fronts.contacts(self.within).first().copied() else { return Ok(()) };
            let place = contact.place();
            let before = fronts.counts();
            if let Some(kind) = fronts.bridge(&contact, self.within, self.options.range())? {
                self.events.push(TopologyEvent { time, kind, place, before, after: fronts.counts() });
            }
        }
        Err(Error::invalid("bridges over contacts are in contact again and again".to_owned())
            .with_cure("give another distance of contacts, or keep contacts"))
    }

    fn push_contact(&mut self, time: f64, place: [f64; 2], counts: [usize; 2]) {
        let kind = EventKind::Contact;
        self.events.push(TopologyEvent { time, kind, place, before: counts, after: counts });
    }

    /// What has changed when curves that crossed were cut and pasted.
    fn push_differences(&mut self, time: f64, place: [f64; 2], before: [usize; 2], after: [usize; 2]) {
        let mut now = before;
        for (axis, fewer, more) in [
            (0, EventKind::ComponentsMerge, EventKind::ComponentSplits),
            (1, EventKind::HoleOpens, EventKind::HoleForms),
        ] {
            let kind = match after[axis].cmp(&before[axis]) {
                std::cmp::Ordering::Less => fewer,
                std::cmp::Ordering::Equal => continue,
                std::cmp::Ordering::Greater => more,
            };
            let mut then = now;
            then[axis] = after[axis];
            self.events.push(TopologyEvent { time, kind, place, before: now, after: then });
            now = then;
        }
    }

    /// Looks thoroughly at the boundaries after all steps.
    pub(super) fn finish(&mut self, fronts: &mut Fronts, steps: usize) -> Result<(), Error> {
        let found = if steps > 0 { fronts.fault(true)? } else { None };
        let Some(fault) = found else { return Ok(()) };
        let rule = self.rule().ok_or_else(|| met(fault))?;
        let before = fronts.counts();
        self.repair(fronts, fault, rule, before, (steps, self.options.end))?;
        self.close_slivers(fronts, self.options.end);
        Ok(())
    }

    pub(super) fn into_parts(self) -> (Vec<VanishedCurve>, Vec<Repair>, Vec<TopologyEvent>) {
        (self.vanished, self.repairs, self.events)
    }
}

/// Where a fault is.
fn place_of(fault: &YinFault, fronts: &Fronts) -> [f64; 2] {
    let curve = match *fault {
        YinFault::SelfMeeting { point, .. } | YinFault::Crossing { point, .. } => return point,
        YinFault::Overlap { ends: [point, _], .. } => return point,
        YinFault::Open { curve }
        | YinFault::TooFewPieces { curve }
        | YinFault::ZeroLength { curve, .. }
        | YinFault::Orientation { curve, .. } => curve,
        YinFault::MixedRoots { curves: [_, curve] } => curve,
    };
    fronts.knot_of(curve).unwrap_or_default()
}
