//! A set that moves with a velocity field.

use super::PlanarSet;
use crate::answer::{
    Remark, RemarkCode, VanishedAnswer, YinAdvectAnswer, YinEventAnswer, YinEventKind, YinRepairAnswer,
    YinSetAnswer,
};
use crate::text;
use coface_algebra::Error;
use coface_arrange::boolean::InsideRule;
use coface_yin::{MarkerParameters, OnContact, RungeKutta, TrackingOptions, Verification};

/// That contacts of these lines were left as they are, the first at a time and a place.
pub(super) fn kept(count: usize, lines: &str, time: f64, place: [f64; 2]) -> Remark {
    let message = format!(
        "{} of {lines} left as they are, the first {}",
        text::count(count, "contact"),
        at(time, place)
    );
    Remark::new(RemarkCode::ContactsKept, message).at(count, [])
}

/// That the topology changed so often, and how it did first.
pub(super) fn changed(count: usize, words: &str, time: f64, place: [f64; 2]) -> Remark {
    let message = format!(
        "the topology changed {}: {words}, {}{}",
        if count == 1 { "once".to_owned() } else { text::count(count, "time") },
        at(time, place),
        if count == 1 { "" } else { ", is the first change" }
    );
    Remark::new(RemarkCode::TopologyRepaired, message).at(count, [])
}

fn at(time: f64, place: [f64; 2]) -> String {
    let [x, y] = place.map(text::number);
    format!("at time {} near ({x}, {y})", text::number(time))
}

/// How a set moves.
///
/// # Examples
/// ```
/// let request = coface_answers::MotionRequest::until(2.0).frames(4).spacing(Some(0.1));
/// assert_eq!((request.time, request.frames), (2.0, 4));
/// ```
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct MotionRequest {
    /// The time at the end; it may be negative.
    pub time: f64,
    /// The longest step of time; a hundredth of the time if none is given.
    pub step: Option<f64>,
    /// The greatest distance of neighboring knots; a hundredth of the box around the set if none is given.
    pub spacing: Option<f64>,
    /// The least distance of neighboring knots as a part of the spacing.
    pub least_ratio: f64,
    /// Knots are added where the polygon through them turns by more than this angle, in radians.
    pub most_turn: Option<f64>,
    /// What the parameters of splines through knots are; the usual ones of the order of the set if nothing is said.
    pub parameters: Option<MarkerParameters>,
    /// The scheme that moves knots; that of the order of the set if none is given.
    pub scheme: Option<RungeKutta>,
    /// When the boundary is tested against itself.
    pub verification: Verification,
    /// The fill rule by which a boundary that meets itself is cut and pasted; without one that is an error.
    pub repair: Option<InsideRule>,
    /// The number of sets of the way, at equal times.
    pub frames: usize,
    /// Whether curves stay that become short beside the spacing.
    pub keep_small: bool,
    /// Whether changes of the topology are listed.
    pub events: bool,
    /// What becomes of boundaries that come into contact; they are not looked for without it.
    pub on_contact: Option<OnContact>,
    /// Boundaries are in contact when they are nearer than this; than the least distance of knots if none is given.
    pub contact_distance: Option<f64>,
    /// How exactly times of events are found; a thousandth of the step if none is given.
    pub event_tolerance: Option<f64>,
}

impl MotionRequest {
    /// One set at this time.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert_eq!((MotionRequest::until(2.0).time, MotionRequest::until(2.0).frames), (2.0, 1));
    /// ```
    pub fn until(time: f64) -> Self {
        Self {
            time,
            step: None,
            spacing: None,
            least_ratio: 0.1,
            most_turn: None,
            parameters: None,
            scheme: None,
            verification: Verification::EachStep,
            repair: None,
            frames: 1,
            keep_small: false,
            events: false,
            on_contact: None,
            contact_distance: None,
            event_tolerance: None,
        }
    }

    /// The same with this longest step of time.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert_eq!(MotionRequest::until(2.0).step(Some(0.5)).step, Some(0.5));
    /// ```
    #[must_use]
    pub fn step(mut self, step: Option<f64>) -> Self {
        self.step = step;
        self
    }

    /// The same with this greatest distance of neighboring knots.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert_eq!(MotionRequest::until(2.0).spacing(Some(0.1)).spacing, Some(0.1));
    /// ```
    #[must_use]
    pub fn spacing(mut self, spacing: Option<f64>) -> Self {
        self.spacing = spacing;
        self
    }

    /// The same with this least distance of neighboring knots, as a part of the spacing.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert_eq!(MotionRequest::until(2.0).least_ratio(0.2).least_ratio, 0.2);
    /// ```
    #[must_use]
    pub fn least_ratio(mut self, ratio: f64) -> Self {
        self.least_ratio = ratio;
        self
    }

    /// The same with knots where the polygon turns by more than this angle, in radians.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert_eq!(MotionRequest::until(2.0).most_turn(Some(0.3)).most_turn, Some(0.3));
    /// ```
    #[must_use]
    pub fn most_turn(mut self, angle: Option<f64>) -> Self {
        self.most_turn = angle;
        self
    }

    /// The same with these parameters of splines.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert_eq!(MotionRequest::until(2.0).parameters(None).parameters, None);
    /// ```
    #[must_use]
    pub fn parameters(mut self, parameters: Option<MarkerParameters>) -> Self {
        self.parameters = parameters;
        self
    }

    /// The same with this scheme.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert_eq!(MotionRequest::until(2.0).scheme(None).scheme, None);
    /// ```
    #[must_use]
    pub fn scheme(mut self, scheme: Option<RungeKutta>) -> Self {
        self.scheme = scheme;
        self
    }

    /// The same with this time of tests.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// let request = MotionRequest::until(2.0).verification(coface_yin::Verification::EachStep);
    /// assert_eq!(request.verification, coface_yin::Verification::EachStep);
    /// ```
    #[must_use]
    pub fn verification(mut self, verification: Verification) -> Self {
        self.verification = verification;
        self
    }

    /// The same with this rule of repairs.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert!(MotionRequest::until(2.0).repair(None).repair.is_none());
    /// ```
    #[must_use]
    pub fn repair(mut self, rule: Option<InsideRule>) -> Self {
        self.repair = rule;
        self
    }

    /// The same with so many sets of the way.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert_eq!(MotionRequest::until(2.0).frames(4).frames, 4);
    /// ```
    #[must_use]
    pub fn frames(mut self, count: usize) -> Self {
        self.frames = count;
        self
    }

    /// The same with curves kept that become short beside the spacing, or not.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert!(MotionRequest::until(2.0).keep_small(true).keep_small);
    /// ```
    #[must_use]
    pub fn keep_small(mut self, keeps: bool) -> Self {
        self.keep_small = keeps;
        self
    }

    /// The same with changes of the topology listed, or not.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert!(MotionRequest::until(2.0).events(true).events);
    /// ```
    #[must_use]
    pub fn events(mut self, events: bool) -> Self {
        self.events = events;
        self
    }

    /// The same with this done where boundaries come into contact.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// use coface_yin::OnContact;
    /// assert_eq!(MotionRequest::until(2.0).on_contact(Some(OnContact::Merge)).on_contact, Some(OnContact::Merge));
    /// ```
    #[must_use]
    pub fn on_contact(mut self, what: Option<OnContact>) -> Self {
        self.on_contact = what;
        self
    }

    /// The same with boundaries in contact when they are nearer than this.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert_eq!(MotionRequest::until(2.0).contact_distance(Some(0.1)).contact_distance, Some(0.1));
    /// ```
    #[must_use]
    pub fn contact_distance(mut self, distance: Option<f64>) -> Self {
        self.contact_distance = distance;
        self
    }

    /// The same with times of events found as exactly as this.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::MotionRequest;
    /// assert_eq!(MotionRequest::until(2.0).event_tolerance(Some(1e-6)).event_tolerance, Some(1e-6));
    /// ```
    #[must_use]
    pub fn event_tolerance(mut self, tolerance: Option<f64>) -> Self {
        self.event_tolerance = tolerance;
        self
    }

    /// The distance at which boundaries are in contact, if that is looked for, with knots at this greatest distance.
    pub(super) fn contact_distance_for(&self, spacing: f64) -> Option<f64> {
        self.on_contact.map(|_| self.contact_distance.unwrap_or(self.least_ratio * spacing))
    }

    /// The options of tracking from one time to another, in steps of at most `step`.
    pub(super) fn tracking(&self, [start, end]: [f64; 2], step: f64, spacing: f64) -> TrackingOptions {
        TrackingOptions::new(end, step, spacing)
            .start(start)
            .parameters(self.parameters)
            .scheme(self.scheme)
            .least_ratio(self.least_ratio)
            .most_turn(self.most_turn)
            .verification(self.verification)
            .repair(self.repair)
            .keep_small(self.keep_small)
            .events(self.events)
            .on_contact(self.on_contact)
            .contact_distance(self.contact_distance)
            .event_tolerance(self.event_tolerance)
    }
}

/// What came of moving a set.
#[derive(Clone, Debug)]
pub struct PlanarMotion {
    last: PlanarSet,
    time: f64,
    scheme: u32,
    counts: [usize; 3],
    vanished: Vec<VanishedAnswer>,
    repairs: Vec<YinRepairAnswer>,
    events: Option<Vec<YinEventAnswer>>,
    event_tolerance: Option<f64>,
    contact_distance: Option<f64>,
    /// The least distance of knots.
    least_distance: f64,
    area_before: Option<f64>,
}

impl PlanarSet {
    /// Moves the set with a velocity field, which gives the velocity at a point and a time.
    ///
    /// `progress` is called with the number of each part before it begins, from 1, and `take` with this number and the set at its end: the
    /// last of them is the set at the end. Only one set of the way is in memory at a time.
    ///
    /// # Errors
    /// Those of [`YinSet::advected`](coface_yin::YinSet::advected), and the errors of `take`, which end the motion.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{MotionRequest, PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = b"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))";
    /// let square = PlanarSet::of(&read_boundary(&text[..], Format::Wkt, &ReadOptions::default())?, &SetRequest::default())?;
    /// let request = MotionRequest::until(1.0).step(Some(0.5)).spacing(Some(1.0)).frames(2);
    /// let mut corners = Vec::new();
    /// let take = |number, set: &PlanarSet| {
    ///     corners.push((number, set.bounding_box().map(|[low, _]| low)));
    ///     Ok(())
    /// };
    /// square.moved(|_, _| [3.0, 0.0], &request, |_| (), take)?;
    /// assert_eq!(corners, [(1, Some([1.5, 0.0])), (2, Some([3.0, 0.0]))]);
    /// # Ok(()) }
    /// ```
    pub fn moved(
        &self,
        velocity: impl Fn([f64; 2], f64) -> [f64; 2] + Sync,
        request: &MotionRequest,
        mut progress: impl FnMut(usize),
        mut take: impl FnMut(usize, &Self) -> Result<(), Error>,
    ) -> Result<PlanarMotion, Error> {
        let end = request.time;
        // Without time nothing moves, in steps of any length.
        let step = request.step.unwrap_or(if end == 0.0 { 1.0 } else { end.abs() / 100.0 });
        let [low, high] = self.bounding_box().unwrap_or([[0.0; 2], [1.0; 2]]);
        let spacing = request.spacing.unwrap_or(f64::max(high[0] - low[0], high[1] - low[1]) / 100.0);
        let scheme = request.scheme.unwrap_or(RungeKutta::for_curves(self.set().order()));
        let is_watching = request.events || request.on_contact.is_some();
        let mut motion = PlanarMotion {
            last: self.clone(),
            time: end,
            scheme: scheme.order(),
            counts: [0; 3],
            vanished: Vec::new(),
            repairs: Vec::new(),
            events: is_watching.then(Vec::new),
            event_tolerance: None,
            contact_distance: request.contact_distance_for(spacing),
            least_distance: request.least_ratio * spacing,
            area_before: self.set().area(),
        };
        // The number that each curve had at the beginning.
        let mut origins: Vec<u32> = (0..self.set().curve_count() as u32).collect();
        let count = request.frames.max(1);
        for frame in 1..=count {
            progress(frame);
            let times = [frame - 1, frame].map(|at| end * at as f64 / count as f64);
            let tracking = request.tracking(times, step, spacing);
            let moved = motion.last.set().advected(&velocity, &tracking)?;
            let counts = moved.counts();
            let before = motion.counts[0];
            motion.repairs.extend(moved.repairs().iter().map(|repair| YinRepairAnswer {
                step: before + repair.step(),
                time: repair.time(),
                fault: repair.fault().to_string(),
            }));
            if let Some(events) = &mut motion.events {
                events.extend(moved.events().iter().map(YinEventAnswer::new));
                motion.event_tolerance = tracking.times_within()?;
            }
            for (sum, count) in
                motion.counts.iter_mut().zip([counts.steps(), counts.added(), counts.removed()])
            {
                *sum += count;
            }
            let origin = |curve: u32| origins[curve as usize];
            motion.vanished.extend(
                moved
                    .vanished()
                    .iter()
                    .map(|curve| VanishedAnswer { time: curve.time(), curve: origin(curve.curve()) }),
            );
            let curves = moved.curves().to_vec();
            origins = curves.iter().map(|&curve| origin(curve)).collect();
            motion.last = motion.last.followed_by(moved.into_set(), &curves);
            take(frame, &motion.last)?;
        }
        Ok(motion)
    }
}

/// That a distance of contacts is below what knots tell, which are nearer together than this nowhere.
#[doc(hidden)]
pub fn below_knots(distance: f64, least_distance: f64) -> Option<Remark> {
    // The least distance is a product, which is rounded.
    (distance < least_distance * (1.0 - 1e-9)).then(|| {
        let message = format!(
            "the contact distance {} is below the least distance of knots, {}: between knots that are so far apart the boundary is not known so \
             exactly; a smaller --spacing or --least-ratio makes it so",
            text::number(distance),
            text::number(least_distance)
        );
        Remark::new(RemarkCode::ContactBelowKnots, message)
    })
}

impl PlanarMotion {
    /// The set at the end.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{MotionRequest, PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// let request = MotionRequest::until(1.0).step(Some(0.5)).spacing(Some(1.0)).frames(2);
    /// let motion = square.moved(|_, _| [3.0, 0.0], &request, |_| (), |_, _| Ok(()))?;
    /// assert_eq!(motion.last().bounding_box(), Some([[3.0, 0.0], [4.0, 1.0]]));
    /// # Ok(()) }
    /// ```
    pub fn last(&self) -> &PlanarSet {
        &self.last
    }

    /// The number of steps in which the boundary was cut and pasted.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{MotionRequest, PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// let request = MotionRequest::until(1.0).step(Some(0.5)).spacing(Some(1.0)).frames(2);
    /// let motion = square.moved(|_, _| [3.0, 0.0], &request, |_| (), |_, _| Ok(()))?;
    /// assert_eq!(motion.repair_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn repair_count(&self) -> usize {
        self.repairs.len()
    }

    /// That curves became too short to be kept, if any did, and what keeps them.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{MotionRequest, PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0), (1 1, 1.01 1, 1 1.01, 1 1))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// let request = MotionRequest::until(1.0).step(Some(0.5)).spacing(Some(1.0));
    /// let motion = square.moved(|_, _| [3.0, 0.0], &request, |_| (), |_, _| Ok(()))?;
    /// assert!(motion.vanishing().is_some_and(|remark| remark.message.starts_with("1 curve became")));
    /// # Ok(()) }
    /// ```
    pub fn vanishing(&self) -> Option<Remark> {
        let first = self.vanished.first()?;
        let count = self.vanished.len();
        let narrow = match self.contact_distance {
            Some(_) => ", or narrower than half of the contact distance,",
            None if !self.repairs.is_empty() => {
                ", or narrower than half of that distance where the boundary was cut and pasted,"
            }
            None => "",
        };
        let message = format!(
            "{} became shorter than three times the least distance of knots{narrow} and left the set, the first at time {}; \
             --keep-small keeps such curves",
            text::count(count, "curve"),
            text::number(first.time)
        );
        Some(Remark::new(RemarkCode::CurvesVanished, message).at(count, []))
    }

    /// That boundaries came into contact, if any did, and what was done there.
    fn contacts(&self) -> Vec<Remark> {
        let fine = self.contact_distance.and_then(|distance| below_knots(distance, self.least_distance));
        let of = |is_kept: bool| {
            let events = self.events.iter().flatten();
            let is_own = move |event: &&YinEventAnswer| match event.kind {
                YinEventKind::Contact => is_kept,
                YinEventKind::ComponentVanishes | YinEventKind::HoleVanishes => false,
                _ => !is_kept,
            };
            let own: Vec<&YinEventAnswer> = events.filter(is_own).collect();
            own.first().map(|&first| (own.len(), first.clone()))
        };
        let kept = of(true).map(|(count, first)| kept(count, "boundaries", first.time, first.place));
        let changed = of(false).map(|(count, first)| changed(count, &first.words, first.time, first.place));
        fine.into_iter().chain(kept).chain(changed).collect()
    }

    /// The motion as an answer; `files` are those that the sets of the way were written to.
    ///
    /// # Errors
    /// Those of [`PlanarSet::answer`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{MotionRequest, PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// let request = MotionRequest::until(1.0).step(Some(0.5)).spacing(Some(1.0)).frames(2);
    /// let motion = square.moved(|_, _| [3.0, 0.0], &request, |_| (), |_, _| Ok(()))?;
    /// assert_eq!(motion.answer("square.wkt", Vec::new())?.file, "square.wkt");
    /// # Ok(()) }
    /// ```
    pub fn answer(&self, file: &str, files: Vec<String>) -> Result<YinAdvectAnswer, Error> {
        let mut set: YinSetAnswer = self.last().answer()?;
        set.remarks.extend(self.vanishing());
        set.remarks.extend(self.contacts());
        if !self.repairs.is_empty() {
            let count = self.repairs.len();
            let message = format!("the boundary was cut and pasted in {}", text::count(count, "step"));
            set.remarks.push(Remark::new(RemarkCode::TopologyRepaired, message).at(count, []));
        }
        let [steps, added, removed] = self.counts;
        Ok(YinAdvectAnswer {
            file: file.to_owned(),
            time: self.time,
            steps,
            scheme: self.scheme,
            added,
            removed,
            vanished: self.vanished.clone(),
            repairs: self.repairs.clone(),
            events: self.events.clone(),
            event_tolerance: self.event_tolerance,
            contact_distance: self.contact_distance,
            area_before: self.area_before,
            frames: files,
            set,
        })
    }
}
