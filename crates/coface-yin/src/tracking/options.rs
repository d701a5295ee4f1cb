//! How boundaries are tracked.

use super::RungeKutta;
use super::events::OnContact;
use super::markers::MarkerRange;
use crate::Order;
use coface_algebra::Error;
use coface_arrange::boolean::InsideRule;

/// When it is verified that what moves still bounds what it should: that no boundary has come to meet itself or another.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Verification {
    /// After each step of time.
    #[default]
    EachStep,
    /// At the end only: what meets in between and parts again is not seen.
    End,
    /// Not at all.
    Never,
}

/// What the parameters of the splines through markers are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkerParameters {
    /// The distances of neighbors, as in the cubic method of the references; in orders 6 and 8 the lengths of the curve between them.
    Lengths,
    /// Those that markers had at the beginning, and those of added ones on the boundary before the step. The images of the points of a smooth
    /// curve are a smooth function of it, also where the flow folds the curve; but not where the velocity jumps along the curve.
    Kept,
}

/// From when to when, in which steps, and with which spacing of markers a boundary is tracked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackingOptions {
    /// The time at which the boundary is as given.
    pub(crate) start: f64,
    /// The time at which it is asked for; it may be earlier.
    pub(crate) end: f64,
    /// The longest step of time; all steps are equally long.
    pub(crate) time_step: f64,
    /// The greatest distance h of neighboring markers.
    pub(crate) spacing: f64,
    /// The least distance of neighboring markers as a part r of h, at most 1/3 so that both can be kept.
    pub(crate) least_ratio: f64,
    /// The most that the polygon of the markers turns at a marker that is no kink, in radians, as far as the least distance leaves room for
    /// more markers: so they are nearer together where the boundary bends. None if their distance alone counts.
    pub(crate) most_turn: Option<f64>,
    /// What the parameters of splines are; none for the usual ones of the order of the boundary.
    pub(crate) parameters: Option<MarkerParameters>,
    /// The scheme that maps markers; none for the one of the order of the boundary.
    pub(crate) scheme: Option<RungeKutta>,
    /// When the boundary is verified.
    pub(crate) verification: Verification,
    /// What is inside of boundaries that have come to meet: with a rule they are cut and pasted by it, and the motion goes on. Without
    /// one it is an error. Needs a verification.
    pub(crate) repair: Option<InsideRule>,
    /// Whether curves stay that become short beside the spacing.
    pub(crate) keep_small: bool,
    /// Whether changes of the topology are listed, with times found within the steps.
    pub(crate) events: bool,
    /// What becomes of boundaries that come into contact; without it they are not looked for.
    pub(crate) on_contact: Option<OnContact>,
    /// Boundaries are in contact when they are nearer than this; none for the least distance of markers.
    pub(crate) contact_distance: Option<f64>,
    /// How exactly times of events are found; none for a thousandth of the step.
    pub(crate) event_tolerance: Option<f64>,
}

impl TrackingOptions {
    /// From time 0 to `end` with steps and spacing as given; r = 1/10, the scheme of the order of the boundary, verified after each step,
    /// and without repair.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, TrackingOptions, YinSet};
    /// let options = TrackingOptions::new(1.0, 0.25, 0.1);
    /// assert_eq!(YinSet::empty(Order::LINEAR).advected(|_, _| [0.0; 2], &options)?.counts().steps(), 4);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(end: f64, time_step: f64, spacing: f64) -> Self {
        Self {
            start: 0.0,
            end,
            time_step,
            spacing,
            least_ratio: 0.1,
            most_turn: None,
            parameters: None,
            scheme: None,
            verification: Verification::EachStep,
            repair: None,
            keep_small: false,
            events: false,
            on_contact: None,
            contact_distance: None,
            event_tolerance: None,
        }
    }

    /// Begins at this time instead of 0.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let options = TrackingOptions::new(1.0, 0.5, 2.0).start(0.5);
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &options)?;
    /// let [low, _] = moved.set().bounding_box().expect("a square is bounded");
    /// assert!((low[0] - 0.5).abs() < 1e-12);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn start(mut self, time: f64) -> Self {
        self.start = time;
        self
    }

    /// Ends at this time; it may be earlier than the start.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let options = TrackingOptions::new(1.0, 0.5, 2.0).end(-1.0);
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &options)?;
    /// let [low, _] = moved.set().bounding_box().expect("a square is bounded");
    /// assert!((low[0] + 1.0).abs() < 1e-12);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn end(mut self, time: f64) -> Self {
        self.end = time;
        self
    }

    /// Leaves out markers that are nearer together than this part of the spacing: 0 to 1/3.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let options = TrackingOptions::new(1.0, 0.5, 2.0).least_ratio(0.3);
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &options)?;
    /// assert_eq!(moved.counts().removed(), 0);
    /// assert!(square.advected(|_, _| [0.0; 2], &options.least_ratio(0.5)).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn least_ratio(mut self, ratio: f64) -> Self {
        self.least_ratio = ratio;
        self
    }

    /// Adds markers where their polygon turns by more than this angle, in radians.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let options = TrackingOptions::new(1.0, 0.5, 2.0).most_turn(2.0);
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &options)?;
    /// assert_eq!(moved.counts().added(), 0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn most_turn(mut self, radians: impl Into<Option<f64>>) -> Self {
        self.most_turn = radians.into();
        self
    }

    /// Takes these parameters for the splines through markers. Without this they are lengths in orders 2 and 4, and kept in orders 6 and 8.
    /// A polyline has lengths whatever is said.
    ///
    /// # Examples
    /// A disk that a vortex draws out and brings back: cubic splines are nearer to it by far when the parameters are kept.
    /// ```
    /// use coface_yin::{Curve, Flow, MarkerParameters, Order, TrackingOptions, YinSet};
    /// let disk = YinSet::new(&[Curve::circle([0.5, 0.75], 0.15, 80, Order::CUBIC)?])?;
    /// let flow = Flow::Vortex { period: 4.0 };
    /// let off = |parameters| -> Result<f64, coface_algebra::Error> {
    ///     let options = TrackingOptions::new(4.0, 0.02, 0.0125).parameters(parameters);
    ///     let moved = disk.advected(|point, time| flow.velocity(point, time), &options)?;
    ///     Ok(moved.set().comparison(&disk)?.area_xor())
    /// };
    /// assert!(50.0 * off(MarkerParameters::Kept)? < off(MarkerParameters::Lengths)?);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn parameters(mut self, parameters: impl Into<Option<MarkerParameters>>) -> Self {
        self.parameters = parameters.into();
        self
    }

    /// Maps markers by this scheme instead of the one of the order of the boundary.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, RungeKutta, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let options = TrackingOptions::new(1.0, 0.5, 2.0).scheme(RungeKutta::Midpoint);
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &options)?;
    /// assert_eq!(moved.set().area(), Some(4.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn scheme(mut self, scheme: impl Into<Option<RungeKutta>>) -> Self {
        self.scheme = scheme.into();
        self
    }

    /// Verifies the boundary after each step, at the end, or never.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, Verification, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let options = TrackingOptions::new(1.0, 0.5, 2.0).verification(Verification::End);
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &options)?;
    /// assert!(moved.set().validate()?.is_none());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn verification(mut self, verification: Verification) -> Self {
        self.verification = verification;
        self
    }

    /// Cuts and pastes boundaries that have come to meet by this rule, instead of refusing them.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::InsideRule;
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let options = TrackingOptions::new(1.0, 0.5, 2.0).repair(InsideRule::Nonzero);
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &options)?;
    /// assert!(moved.repairs().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn repair(mut self, rule: impl Into<Option<InsideRule>>) -> Self {
        self.repair = rule.into();
        self
    }

    /// Keeps curves that become short beside the spacing: they have markers nearer together, sixteen at least. Without this they vanish with a
    /// report when they are shorter than three times the least distance.
    ///
    /// # Examples
    /// A hole that shrinks to a hundredth of the spacing.
    /// ```
    /// use coface_yin::{Curve, Order, TrackingOptions, YinSet};
    /// let disk = Curve::circle([0.0, 0.0], 1.0, 64, Order::CUBIC)?;
    /// let hole = Curve::circle([0.0, 0.0], 0.1, 32, Order::CUBIC)?.reversed();
    /// let ring = YinSet::new(&[disk, hole])?;
    /// let shrink = |[x, y]: [f64; 2], _| if x.hypot(y) < 0.2 { [-4.0 * x, -4.0 * y] } else { [0.0; 2] };
    /// let options = TrackingOptions::new(1.0, 0.05, 0.1).least_ratio(0.3);
    /// assert_eq!(ring.advected(shrink, &options)?.vanished().len(), 1);
    /// let moved = ring.advected(shrink, &options.keep_small(true))?;
    /// assert!(moved.vanished().is_empty() && moved.set().betti_open()? == [1, 1]);
    /// let exact = std::f64::consts::PI * (0.1 * (-4f64).exp()).powi(2);
    /// assert!((-moved.set().curve(1).signed_area() / exact - 1.0).abs() < 1e-3);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn keep_small(mut self, keeps: bool) -> Self {
        self.keep_small = keeps;
        self
    }

    /// The same, with [`TrackedSet::events`](super::TrackedSet::events) listed or not: what vanishes, and with [`Self::on_contact`] and
    /// [`Self::repair`] what merges, splits, forms and opens. It is looked after each step; the time of what is found is narrowed by
    /// halving the step.
    ///
    /// # Examples
    /// A disk that shrinks by $e^{-t}$ vanishes when fewer than three of its markers are the least distance of 0.01 from each other: at a radius between
    /// 0.005 and 0.0075.
    /// ```
    /// use coface_yin::{Curve, EventKind, Order, TrackingOptions, YinSet};
    /// let disk = YinSet::new(&[Curve::circle([0.0, 0.0], 1.0, 64, Order::CUBIC)?])?;
    /// let options = TrackingOptions::new(8.0, 0.25, 0.1).events(true);
    /// let moved = disk.advected(|[x, y], _| [-x, -y], &options)?;
    /// let event = moved.events()[0];
    /// assert_eq!((event.kind(), event.before(), event.after()), (EventKind::ComponentVanishes, [1, 0], [0, 0]));
    /// assert!((0.005..0.0075).contains(&(-event.time()).exp()));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn events(mut self, events: bool) -> Self {
        self.events = events;
        self
    }

    /// The same, with this done where boundaries come nearer to each other than [`Self::contact_distance`], or cross; events are listed then.
    ///
    /// The flow of a continuous velocity brings nothing into contact in finite time, so that the distance is where the model ends. With
    /// [`OnContact::Merge`] a bridge of that width joins the set across a gap, and a cut of that width goes through a neck; boundaries that
    /// cross nevertheless are cut and pasted by the rule of [`Self::repair`], or by winding numbers above 0. With [`OnContact::Keep`]
    /// boundaries stay as they are; where they still cross at the end that is an error. Threads that are thinner up to their tips are no
    /// necks, and what touches at the beginning is not in contact.
    ///
    /// # Examples
    /// The gap between two disks is $e^{-t}$.
    /// ```
    /// use coface_yin::{Curve, EventKind, OnContact, Order, TrackingOptions, YinSet};
    /// let disks = [-1.5, 1.5].map(|x| Curve::circle([x, 0.0], 1.0, 64, Order::CUBIC));
    /// let [left, right] = disks;
    /// let options = TrackingOptions::new(2.0, 0.1, 0.1).on_contact(OnContact::Merge).contact_distance(0.25);
    /// let moved = YinSet::new(&[left?, right?])?.advected(|[x, _], _| [-x, 0.0], &options)?;
    /// let event = moved.events()[0];
    /// assert_eq!((event.kind(), event.before(), event.after()), (EventKind::ComponentsMerge, [2, 0], [1, 0]));
    /// assert!((event.time() - 4.0_f64.ln()).abs() < 1e-3);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn on_contact(mut self, what: impl Into<Option<OnContact>>) -> Self {
        self.on_contact = what.into();
        self
    }

    /// The same with boundaries in contact when they are nearer than this; none for the least distance of markers. With [`OnContact::Merge`]
    /// curves whose mean width (twice the area by the length) is below half of it vanish: slivers of gaps that close and necks that thin out.
    ///
    /// # Examples
    /// See [`Self::on_contact`].
    #[must_use]
    pub fn contact_distance(mut self, distance: impl Into<Option<f64>>) -> Self {
        self.contact_distance = distance.into();
        self
    }

    /// The same with times of events found as exactly as this; none for a thousandth of the step.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::TrackingOptions;
    /// let options = TrackingOptions::new(1.0, 0.25, 0.1).events(true).event_tolerance(1e-6);
    /// assert_ne!(options, TrackingOptions::new(1.0, 0.25, 0.1).events(true));
    /// ```
    #[must_use]
    pub fn event_tolerance(mut self, tolerance: impl Into<Option<f64>>) -> Self {
        self.event_tolerance = tolerance.into();
        self
    }

    /// How exactly times of events are found; `None` if events are not looked for.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for options without meaning.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::TrackingOptions;
    /// let options = TrackingOptions::new(1.0, 0.25, 0.1).events(true);
    /// assert_eq!(options.times_within()?, Some(0.25e-3));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn times_within(&self) -> Result<Option<f64>, Error> {
        let (_, step) = self.steps()?;
        Ok(self.is_watching().then(|| self.event_tolerance.unwrap_or(1e-3 * step.abs())))
    }

    /// Whether it is looked for events.
    pub(super) fn is_watching(&self) -> bool {
        self.events || self.on_contact.is_some()
    }

    /// The distances and turns of markers.
    pub(super) fn range(&self) -> MarkerRange {
        MarkerRange {
            least: self.least_ratio * self.spacing,
            most: self.spacing,
            turn: self.most_turn.unwrap_or(f64::INFINITY),
            keeps_small: self.keep_small,
            parameters: self.parameters,
        }
    }

    /// The distance at which boundaries are in contact, and the least distance of markers; none if contacts are not looked for.
    #[doc(hidden)]
    pub fn contact_lengths(&self) -> Option<[f64; 2]> {
        let least = self.least_ratio * self.spacing;
        self.on_contact.map(|_| [self.contact_distance.unwrap_or(least), least])
    }

    /// The scheme for a boundary of some order.
    pub(super) fn scheme_for(&self, order: Order) -> RungeKutta {
        self.scheme.unwrap_or(RungeKutta::for_curves(order))
    }

    /// Whether a boundary is verified after one of so many steps.
    pub(super) fn is_verified_after(&self, step: usize, count: usize) -> bool {
        match self.verification {
            Verification::EachStep => true,
            Verification::End => step + 1 == count,
            Verification::Never => false,
        }
    }

    /// The number of steps, and their length.
    pub(super) fn steps(&self) -> Result<(usize, f64), Error> {
        let span = self.end - self.start;
        let count = (span.abs() / self.time_step).ceil();
        let is_positive = |x: f64| x > 0.0 && x.is_finite();
        if !span.is_finite() || !is_positive(self.time_step) || count > 1e9 {
            return Err(Error::invalid(format!(
                "the time from {} to {} has no steps of {}",
                self.start, self.end, self.time_step
            ))
            .with_cure("give finite times and a positive step"));
        }
        if !is_positive(self.spacing) {
            return Err(Error::invalid(format!("markers cannot have the spacing {}", self.spacing))
                .with_cure("give a positive length"));
        }
        if !(0.0..=1.0 / 3.0).contains(&self.least_ratio) {
            return Err(Error::invalid(format!(
                "the least ratio {} of distances cannot be kept",
                self.least_ratio
            ))
            .with_cure("give a number from 0 to 1/3"));
        }
        if let Some(turn) = self.most_turn.filter(|turn| turn.is_nan() || *turn <= 0.0) {
            return Err(Error::invalid(format!("markers cannot turn by at most {turn}"))
                .with_cure("give a positive angle in radians"));
        }
        let lengths =
            [("contact distance", self.contact_distance), ("tolerance of times", self.event_tolerance)];
        for (name, length) in lengths {
            if let Some(length) = length.filter(|&length| !is_positive(length)) {
                return Err(Error::invalid(format!("{length} cannot be the {name}"))
                    .with_cure("give a positive number"));
            }
        }
        if self.is_watching() && self.verification != Verification::EachStep {
            return Err(Error::invalid("events are looked for after each step".to_owned())
                .with_cure("verify after each step"));
        }
        Ok((count as usize, if count > 0.0 { span / count } else { 0.0 }))
    }
}
