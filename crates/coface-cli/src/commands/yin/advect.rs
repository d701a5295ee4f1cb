//! `coface yin advect`: a set that moves with a velocity field.

mod phases;

use super::interface::PhaseOptions;
use super::{SetOptions, give, pair};
use crate::arguments::Common;
use crate::commands::arrange::Rule;
use crate::failure::Failure;
use crate::input;
use crate::progress::Progress;
use clap::{Args, ValueEnum};
use coface::answers::{MotionRequest, PlanarSet};
use coface::io::StagedFiles;
use coface::yin::{Flow, MarkerParameters, OnContact, RungeKutta, VelocityExpression, Verification};
use std::path::{Path, PathBuf};

/// Move a set, or an interface of several phases, with a velocity field: its knots are mapped, and splines fitted anew (MARS).
///
/// Where neighbors come to lie farther apart than --spacing, knots are added; where they come closer than a tenth of it, knots are left
/// out. Kinks stay. Polylines are best fitted before: `coface yin fit`.
///
/// A boundary that comes to meet itself is an error that names the step, the time and the place, and nothing is written; with --repair it
/// is cut and pasted by a fill rule, and the motion goes on.
///
/// Several files, an image of labels and the .json of an interface are phases that move together, as with `coface yin interface`; so are the
/// features of one file with --inputs features. They keep their common arcs, and junctions stay junctions. -o FILE.json writes an interface again.
///
/// A continuous velocity brings nothing into contact in finite time: what merges or splits is a matter of the distance at which the model
/// ends. --on-contact merge joins the set across gaps, and cuts it through necks, that are narrower than --contact-distance, by a rectangle
/// of that width, and slivers whose mean width is below half of it vanish (they stay with --keep-small); --on-contact keep goes on with the
/// curves as they are, with a remark, and is an error only if they cross at the end. --events lists what merges, splits, opens, closes and
/// vanishes, with times and places.
///
/// With --json also "time", "steps", "scheme" (its order), "added" and "removed" (knots), "vanished" (curves that became too short, each with
/// its time), "repairs" (each with its "step", "time" and "fault"), "events" (each with "time", "kind": components-merge, component-splits, hole-forms, hole-opens,
/// holes-merge, hole-splits, component-vanishes, hole-vanishes or contact, "words", "place", "before" and "after": "components" and "holes"),
/// "event_tolerance", "contact_distance" and "area_before"; for an interface the keys of `coface yin interface` and "areas_before" of the
/// phases; and "frames". Events of an interface have the "phases" that changed, and are phase-vanishes, component-vanishes, hole-vanishes,
/// junctions-meet (the edge between them is shorter than the least distance of knots, and stays), and where --repair cuts and pastes
/// phase-merges, phase-splits, hole-forms and hole-opens. Edges from a junction to itself have no events. With --on-contact merge a phase comes together
/// with itself where what is between its edges is narrower than --contact-distance (phase-merges, hole-forms, ..), two phases get an edge in common
/// (phases-meet, and phase-splits of the film between them), and components that are narrow all along go to the neighbor that they have most in
/// common with; with keep contacts are listed.
#[derive(Args)]
pub(super) struct Advect {
    /// The set, or the phases of an interface; - is standard input
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
    #[command(flatten)]
    options: SetOptions,
    #[command(flatten)]
    phases: PhaseOptions,
    /// The velocity field, if --velocity does not give it
    #[arg(long, value_name = "FLOW", required_unless_present = "velocity")]
    flow: Option<Field>,
    /// The time at the end [default: the period of a vortex or deformation, or of expressions with T; else 1]
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    time: Option<f64>,
    /// The longest step of time [default: a hundredth of the time]
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    step: Option<f64>,
    /// The greatest distance of neighboring knots [default: a hundredth of the box around the set]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    spacing: Option<f64>,
    /// The least distance of neighboring knots as a part of --spacing, up to 1/3; a small one is more exact
    #[arg(long, value_name = "RATIO", default_value = "0.1", allow_hyphen_values = true)]
    least_ratio: f64,
    /// Add knots where the polygon through them turns by more degrees, as far as the least distance allows
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true)]
    turn: Option<f64>,
    /// The period of a vortex or deformation, and T of expressions
    #[arg(long, value_name = "TIME", default_value = "4", allow_hyphen_values = true)]
    period: f64,
    /// The number of vortices of a deformation in each direction of the unit square
    #[arg(long, value_name = "N", default_value = "4", value_parser = clap::value_parser!(u32).range(1..=1000))]
    vortices: u32,
    /// The velocity: X,Y of a translation [default: 1,0], or two expressions of x, y, t and T as in "-y*cos(pi*t/T); x*cos(pi*t/T)": powers
    /// are ^, and there are sin, cos, tan, asin, acos, atan, atan2, sinh, cosh, tanh, exp, log, sqrt, abs, floor, hypot, min and max
    #[arg(long, value_name = "VELOCITY", allow_hyphen_values = true)]
    velocity: Option<String>,
    /// The center of a rotation: X,Y
    #[arg(long, value_name = "POINT", default_value = "0,0", value_parser = pair, allow_hyphen_values = true)]
    center: [f64; 2],
    /// The speed of a rotation in radians per time, counterclockwise
    #[arg(long, value_name = "SPEED", default_value = "1", allow_hyphen_values = true)]
    speed: f64,
    /// What the parameters of splines through knots are [default: lengths in orders 2 and 4, kept in orders 6 and 8]
    #[arg(long, value_name = "WHAT")]
    parameters: Option<Parameters>,
    /// The Runge-Kutta scheme that moves knots [default: that of the order of the set]
    #[arg(long, value_name = "SCHEME")]
    scheme: Option<Scheme>,
    /// When it is looked whether the boundary meets itself
    #[arg(long, value_name = "WHEN", default_value = "each-step")]
    verify: When,
    /// Cut and paste a boundary that has come to meet itself by a fill rule
    #[arg(long, value_name = "RULE")]
    repair: Option<Rule>,
    /// Keep curves that become short beside --spacing: their knots come nearer together, sixteen at least [default: they vanish, with a remark,
    /// when they are shorter than three times the least distance of knots]
    #[arg(long)]
    keep_small: bool,
    /// List the changes of the topology with their times, which are narrowed down within steps
    #[arg(long)]
    events: bool,
    /// How exactly times of events are found [default: a thousandth of the step]
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    event_tolerance: Option<f64>,
    /// What to do where parts of the boundary come near each other [default: nothing, until they cross]; lists events too
    #[arg(long, value_name = "WHAT")]
    on_contact: Option<Contacts>,
    /// How near that is [default: the least distance of knots]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "on_contact")]
    contact_distance: Option<f64>,
    /// Write so many files of the way, at equal times: NAME-001, NAME-002, .. for -o NAME
    #[arg(long, value_name = "N", default_value = "1", value_parser = clap::value_parser!(u16).range(1..=10000))]
    frames: u16,
}

#[derive(Clone, Copy, ValueEnum)]
enum Field {
    /// A single vortex in the unit square, there and back in a period
    Vortex,
    /// Rows of vortices in the unit square, there and back in a period
    Deformation,
    /// A rigid rotation
    Rotation,
    /// All points move alike
    Translation,
}

#[derive(Clone, Copy, ValueEnum)]
enum Parameters {
    /// The distances of neighbors, as in cubic MARS; in orders 6 and 8 the lengths of curves between them
    Lengths,
    /// Those that knots had at the beginning: nearer to the exact boundary by far, unless the velocity jumps along it
    Kept,
}

#[derive(Clone, Copy, ValueEnum)]
enum Scheme {
    /// The midpoint rule, of order 2
    Midpoint,
    /// The classical scheme, of order 4
    Classical,
    /// The scheme of Verner, of order 6
    Verner,
    /// The scheme of Cooper and Verner, of order 8
    CooperVerner,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Contacts {
    /// Go on with the curves as they are
    Keep,
    /// Join the set across gaps, and cut it through necks
    Merge,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum When {
    /// After each step of time
    EachStep,
    /// At the end, and before each file of the way
    End,
    /// Not at all
    Never,
}

impl Advect {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        let flow = self.flow()?;
        let request = self.request(&flow)?;
        if self.phases.are_phases(&self.inputs)? {
            return self.run_phases(&flow, &request, common);
        }
        let output = self.options.output(common)?;
        let input = &self.inputs[0];
        let progress = Progress::start(common.quiet);
        let planar = self.options.read(input, common, false, &progress)?;
        let count = request.frames;
        let name = input::name(input);
        let stage = |frame: usize| progress.stage(format!("moving, part {frame} of {count}"));
        // Sets of the way are written as they come, and appear when all is done.
        let frames = output.filter(|_| count > 1);
        let mut staged = frames.map(|(path, _)| StagedFiles::beside(path)).transpose()?;
        let mut files = Vec::new();
        let take = |number: usize, set: &PlanarSet| {
            let (Some((path, format)), Some(staged)) = (frames, &mut staged) else { return Ok(()) };
            let path = numbered(path, number);
            staged.write(&path, |out| self.options.write_to(set, out, format, common))?;
            files.push(path.display().to_string());
            Ok(())
        };
        let motion = planar.moved(|point, time| flow.velocity(point, time), &request, stage, take);
        let motion = motion.map_err(|error| named_rules(error).in_file(name.clone()))?;
        let planar = motion.last();
        progress.stage("measuring");
        let answer = match motion.answer(&name, files) {
            Err(error) if self.verify == When::Never => {
                // What is no boundary any more has no components to be counted.
                let fault = planar.set().validate().ok().flatten();
                let fault = fault.map_or_else(|| error.to_string(), |fault| fault.to_string());
                return Err(Failure::new(format!(
                    "{name}: at time {} the curves bound no set any more: {fault}; leave out --verify never, and repair the set by a fill rule: --repair nonzero, evenodd or positive",
                    request.time
                )));
            }
            answer => answer?,
        };
        if let Some(staged) = staged {
            progress.stage("writing");
            staged.finish()?;
        }
        give(planar, "Moved set", answer, &self.options, output, common, progress)
    }

    /// How it moves, if options go together.
    fn request(&self, flow: &Motion) -> Result<MotionRequest, Failure> {
        let end = self.time.unwrap_or(if flow.is_periodic() { self.period } else { 1.0 });
        if !end.is_finite() {
            return Err(Failure::new(format!("--time {end}: there is no such time; give a finite one")));
        }
        if self.repair.is_some() && self.verify == When::Never {
            return Err(Failure::new("--repair needs to know when: leave out --verify never"));
        }
        self.check_contacts()?;
        Ok(MotionRequest::until(end)
            .step(self.step)
            .spacing(self.spacing)
            .least_ratio(self.least_ratio)
            .most_turn(self.turn.map(f64::to_radians))
            .parameters(self.parameters.map(|what| match what {
                Parameters::Lengths => MarkerParameters::Lengths,
                Parameters::Kept => MarkerParameters::Kept,
            }))
            .scheme(self.scheme())
            .verification(match self.verify {
                When::EachStep => Verification::EachStep,
                When::End => Verification::End,
                When::Never => Verification::Never,
            })
            .repair(self.repair.map(Rule::inside))
            .keep_small(self.keep_small)
            .events(self.events)
            .event_tolerance(self.event_tolerance)
            .on_contact(self.on_contact.map(|what| match what {
                Contacts::Keep => OnContact::Keep,
                Contacts::Merge => OnContact::Merge,
            }))
            .contact_distance(self.contact_distance)
            .frames(usize::from(self.frames)))
    }

    /// Whether options of events and contacts go together.
    fn check_contacts(&self) -> Result<(), Failure> {
        if (self.events || self.on_contact.is_some()) && self.verify != When::EachStep {
            return Err(Failure::new("--events and --on-contact look after each step: leave out --verify"));
        }
        if self.on_contact == Some(Contacts::Keep) && self.repair.is_some() {
            return Err(Failure::new(
                "--on-contact keep leaves curves as they are, and --repair changes them: leave one of them out",
            ));
        }
        let positive =
            [("--event-tolerance", self.event_tolerance), ("--contact-distance", self.contact_distance)];
        for (option, value) in positive {
            if let Some(value) = value.filter(|value| !(value.is_finite() && *value > 0.0)) {
                return Err(Failure::new(format!("{option} {value}: give a number above 0")));
            }
        }
        if self.event_tolerance.is_some() && !self.events && self.on_contact.is_none() {
            return Err(Failure::new("--event-tolerance is of events: ask for them with --events"));
        }
        Ok(())
    }

    fn scheme(&self) -> Option<RungeKutta> {
        self.scheme.map(|scheme| match scheme {
            Scheme::Midpoint => RungeKutta::Midpoint,
            Scheme::Classical => RungeKutta::Classical,
            Scheme::Verner => RungeKutta::Verner,
            Scheme::CooperVerner => RungeKutta::CooperVerner,
        })
    }

    /// The velocity of a translation, or by expressions.
    fn given_velocity(&self) -> Result<Motion, Failure> {
        let Some(text) = &self.velocity else {
            return Ok(Motion::Named(Flow::Translation { velocity: [1.0, 0.0] }));
        };
        if let Ok(velocity) = pair(text) {
            return Ok(Motion::Named(Flow::Translation { velocity }));
        }
        let read = VelocityExpression::parse(text, self.period);
        read.map(Motion::Written).map_err(|error| Failure::new(format!("--velocity: {error}")))
    }

    fn flow(&self) -> Result<Motion, Failure> {
        let Some(field) = self.flow else { return self.given_velocity() };
        if let (Some(velocity), false) = (&self.velocity, matches!(field, Field::Translation)) {
            return Err(Failure::new(format!(
                "--velocity {velocity} stands beside --flow, which says how points move already; leave one of them out"
            )));
        }
        let is_periodic = matches!(field, Field::Vortex | Field::Deformation);
        if is_periodic && !(self.period.is_finite() && self.period != 0.0) {
            return Err(Failure::new(format!(
                "--period {}: a flow cannot come back after that; give a finite time other than 0",
                self.period
            )));
        }
        if !self.speed.is_finite() {
            let speed = self.speed;
            return Err(Failure::new(format!(
                "--speed {speed}: nothing turns so; give a finite number of radians per time"
            )));
        }
        Ok(Motion::Named(match field {
            Field::Vortex => Flow::Vortex { period: self.period },
            Field::Deformation => Flow::Deformation { period: self.period, vortices: self.vortices },
            Field::Rotation => Flow::Rotation { center: self.center, speed: self.speed },
            Field::Translation => return self.given_velocity(),
        }))
    }
}

/// How points move.
enum Motion {
    Named(Flow),
    Written(VelocityExpression),
}

impl Motion {
    /// Whether it ends after a period unless a time is said.
    fn is_periodic(&self) -> bool {
        match self {
            Self::Named(flow) => matches!(flow, Flow::Vortex { .. } | Flow::Deformation { .. }),
            Self::Written(flow) => flow.has_period(),
        }
    }

    fn velocity(&self, point: [f64; 2], time: f64) -> [f64; 2] {
        match self {
            Self::Named(flow) => flow.velocity(point, time),
            Self::Written(flow) => flow.velocity(point, time),
        }
    }
}

/// The same error; where a fill rule cures it, with the option that names one.
fn named_rules(error: coface::Error) -> coface::Error {
    match error.cure().and_then(|cure| cure.strip_suffix("by a fill rule")) {
        None => error,
        Some(cure) => {
            let cure =
                cure.replace("shorter steps or a smaller spacing", "a shorter --step or a smaller --spacing");
            let cure = format!("{cure}by a fill rule: --repair nonzero, evenodd or positive");
            coface::Error::new(error.kind(), error.message()).with_cure(cure)
        }
    }
}

/// `a/b.svg` with a number: `a/b-007.svg`.
pub(super) fn numbered(path: &Path, number: usize) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!("{stem}-{number:03}.{extension}"))
}
