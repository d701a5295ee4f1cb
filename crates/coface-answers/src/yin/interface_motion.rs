//! An interface that moves with a velocity field.

use super::motion::{below_knots, changed, kept};
use super::{MotionRequest, PlanarInterface};
use crate::answer::{
    Remark, RemarkCode, VanishedEdgeAnswer, YinInterfaceAdvectAnswer, YinInterfaceEventAnswer,
    YinInterfaceEventKind, YinRepairAnswer,
};
use crate::text;
use coface_algebra::{EdgeId, Error};
use coface_yin::{InterfaceFault, RungeKutta, TrackedGraph};

/// What came of moving an interface.
#[derive(Clone, Debug)]
pub struct InterfaceMotion {
    last: PlanarInterface,
    time: f64,
    scheme: u32,
    counts: [usize; 3],
    vanished: Vec<VanishedEdgeAnswer>,
    repairs: Vec<YinRepairAnswer>,
    events: Option<Vec<YinInterfaceEventAnswer>>,
    event_tolerance: Option<f64>,
    contact_distance: Option<f64>,
    /// The least distance of knots.
    least_distance: f64,
    areas_before: Vec<Option<f64>>,
    /// The number that each edge had at the beginning.
    origins: Vec<Option<u32>>,
}

impl PlanarInterface {
    /// Moves the interface with a velocity field, which gives the velocity at a point and a time. Phases keep their common arcs, and
    /// junctions stay junctions.
    ///
    /// `progress` is called with the number of each part before it begins, from 1, and `take` with this number and the interface at its end:
    /// the last of them is the interface at the end.
    ///
    /// # Errors
    /// Those of [`InterfaceGraph::advected`](coface_yin::InterfaceGraph::advected), and the errors of `take`, which end the motion.
    ///
    /// # Examples
    /// Two pixels side by side turn by a quarter.
    /// ```
    /// use coface_answers::{LabelImage, MotionRequest, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// let request = MotionRequest::until(std::f64::consts::FRAC_PI_2).spacing(Some(1.0));
    /// let motion = interface.moved(|[x, y], _| [-y, x], &request, |_| (), |_, _| Ok(()))?;
    /// let answer = motion.answer(&[], Vec::new())?;
    /// assert_eq!((answer.interface.junctions.len(), answer.areas_before), (2, vec![Some(1.0); 2]));
    /// assert!((answer.interface.phases[1].area.expect("a pixel is bounded") - 1.0).abs() < 1e-6);
    /// # Ok(()) }
    /// ```
    pub fn moved(
        &self,
        velocity: impl Fn([f64; 2], f64) -> [f64; 2] + Sync,
        request: &MotionRequest,
        mut progress: impl FnMut(usize),
        mut take: impl FnMut(usize, &Self) -> Result<(), Error>,
    ) -> Result<InterfaceMotion, Error> {
        let end = request.time;
        // Without time nothing moves, in steps of any length.
        let step = request.step.unwrap_or(if end == 0.0 { 1.0 } else { end.abs() / 100.0 });
        let spacing = request.spacing.unwrap_or_else(|| self.extent() / 100.0);
        let scheme = request.scheme.unwrap_or(RungeKutta::for_curves(self.graph.order()));
        let mut motion = InterfaceMotion {
            last: self.clone(),
            time: end,
            scheme: scheme.order(),
            counts: [0; 3],
            vanished: Vec::new(),
            repairs: Vec::new(),
            events: (request.events || request.on_contact.is_some()).then(Vec::new),
            event_tolerance: None,
            contact_distance: request.contact_distance_for(spacing),
            least_distance: request.least_ratio * spacing,
            areas_before: self.phases()?.iter().map(|phase| phase.set().area()).collect(),
            origins: (0..self.graph.edge_count() as u32).map(Some).collect(),
        };
        let count = request.frames.max(1);
        for frame in 1..=count {
            progress(frame);
            let times = [frame - 1, frame].map(|at| end * at as f64 / count as f64);
            let tracking = request.tracking(times, step, spacing);
            let moved = motion.last.graph.advected(&velocity, &tracking)?;
            if motion.events.is_some() {
                motion.event_tolerance = tracking.times_within()?;
            }
            motion.go_on(&moved);
            take(frame, &motion.last)?;
        }
        Ok(motion)
    }

    /// The interface with another graph, of the same phases; remarks go.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps, TrackingOptions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(1, vec![1])?.sets()?;
    /// let pixel = PlanarInterface::of(sets, &InterfaceOptions::new(coface_yin::Order::LINEAR), Overlaps::Refused)?;
    /// let moved = pixel.graph().advected(|_, _| [3.0, 0.0], &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// assert_eq!(pixel.followed_by(&moved).graph().vertices()[0], [3.0, 0.0]);
    /// # Ok(()) }
    /// ```
    pub fn followed_by(&self, moved: &TrackedGraph) -> Self {
        Self {
            graph: moved.graph().clone(),
            names: self.names.clone(),
            plane: self.plane,
            remarks: Vec::new(),
        }
    }

    /// The longer side of the box around the edges; 1 without edges.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(3, vec![1, 2, 3])?.sets()?;
    /// let row = PlanarInterface::of(sets, &InterfaceOptions::new(coface_yin::Order::LINEAR), Overlaps::Refused)?;
    /// assert_eq!(row.extent(), 3.0);
    /// # Ok(()) }
    /// ```
    pub fn extent(&self) -> f64 {
        self.bounding_box().map_or(1.0, |[low, high]| f64::max(high[0] - low[0], high[1] - low[1]))
    }

    /// What was wrong in an interface, with the names of phases.
    pub(super) fn fault_words(&self, fault: &InterfaceFault) -> String {
        let names: Vec<&str> = (fault.phases().iter())
            .filter_map(|&phase| self.names.get(phase as usize).map(String::as_str))
            .collect();
        if names.is_empty() { fault.to_string() } else { format!("{fault}; they are {}", names.join(", ")) }
    }
}

impl InterfaceMotion {
    /// Takes a part of the motion.
    fn go_on(&mut self, moved: &TrackedGraph) {
        let counts = moved.counts();
        let before = self.counts[0];
        for repair in moved.repairs() {
            self.repairs.push(YinRepairAnswer {
                step: before + repair.step(),
                time: repair.time(),
                fault: self.last.fault_words(repair.fault()),
            });
        }
        for (sum, count) in self.counts.iter_mut().zip([counts.steps(), counts.added(), counts.removed()]) {
            *sum += count;
        }
        if let Some(events) = &mut self.events {
            events.extend(moved.events().iter().map(YinInterfaceEventAnswer::new));
        }
        let origin = |edge: Option<EdgeId>| self.origins.get(edge?.index()).copied().flatten();
        let vanished = moved.vanished().iter();
        self.vanished.extend(vanished.map(|&(time, edge)| VanishedEdgeAnswer { time, edge: origin(edge) }));
        self.origins = moved.edges().iter().map(|&edge| origin(edge)).collect();
        self.last = self.last.followed_by(moved);
    }

    /// The changes of the topology, by time; none unless they were asked for.
    ///
    /// # Examples
    /// See [`YinInterfaceEventAnswer::new`].
    pub fn events(&self) -> Option<&[YinInterfaceEventAnswer]> {
        self.events.as_deref()
    }

    /// The interface at the end.
    ///
    /// # Examples
    /// See [`PlanarInterface::moved`].
    pub fn last(&self) -> &PlanarInterface {
        &self.last
    }

    /// That edges became too short to be kept, that they came into contact, and that they were cut and pasted, if any were.
    ///
    /// # Examples
    /// See [`PlanarInterface::moved`].
    pub fn remarks(&self) -> Vec<Remark> {
        let mut remarks = Vec::new();
        if let Some(first) = self.vanished.first() {
            let count = self.vanished.len();
            let narrow = match self.contact_distance {
                Some(_) => ", or narrower than half of the contact distance,",
                None => "",
            };
            let message = format!(
                "{} became shorter than three times the least distance of knots{narrow} and left the interface, the first at time {}; \
                 --keep-small keeps such edges",
                text::count(count, if self.contact_distance.is_some() { "edge" } else { "closed edge" }),
                text::number(first.time)
            );
            remarks.push(Remark::new(RemarkCode::CurvesVanished, message).at(count, []));
        }
        if let Some(distance) = self.contact_distance {
            remarks.extend(below_knots(distance, self.least_distance));
        }
        remarks.extend(self.contacts());
        if !self.repairs.is_empty() {
            let count = self.repairs.len();
            let message = format!("edges were cut and pasted in {}", text::count(count, "step"));
            remarks.push(Remark::new(RemarkCode::TopologyRepaired, message).at(count, []));
        }
        remarks
    }

    /// What was done where edges came into contact.
    fn contacts(&self) -> Vec<Remark> {
        use YinInterfaceEventKind::{Contact, HoleForms, HoleOpens, PhaseMerges, PhaseSplits, PhasesMeet};
        let of = |kinds: &[YinInterfaceEventKind]| {
            let own = || self.events.iter().flatten().filter(|event| kinds.contains(&event.kind));
            own().next().map(|first| (own().count(), first.clone()))
        };
        let contacts = of(&[Contact]).map(|(count, first)| kept(count, "edges", first.time, first.place));
        let changes = [PhasesMeet, PhaseMerges, PhaseSplits, HoleForms, HoleOpens];
        let changes = of(&changes).filter(|_| self.contact_distance.is_some());
        let changes = changes.map(|(count, first)| changed(count, &first.words, first.time, first.place));
        contacts.into_iter().chain(changes).collect()
    }

    /// The motion as an answer; `files` are the names of the inputs, `frames` the files that interfaces of the way were written to.
    ///
    /// # Errors
    /// Those of [`PlanarInterface::answer`].
    ///
    /// # Examples
    /// See [`PlanarInterface::moved`].
    pub fn answer(&self, files: &[String], frames: Vec<String>) -> Result<YinInterfaceAdvectAnswer, Error> {
        let mut interface = self.last.answer(files, false)?;
        interface.remarks.extend(self.remarks());
        let [steps, added, removed] = self.counts;
        Ok(YinInterfaceAdvectAnswer {
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
            areas_before: self.areas_before.clone(),
            frames,
            interface,
        })
    }
}
