//! The command line: verbs and the options they share.

use crate::commands;
use clap::builder::styling::{AnsiColor, Styles};
use clap::{Args, Command, CommandFactory, Parser, Subcommand};
use coface::complexes::cubical::CubicalVolume;
use coface::io::{Format, ReadOptions, VolumeReading, VoxelRule};
use serde_json::{Value, json};
use std::path::PathBuf;

const STYLES: Styles = Styles::styled()
    .header(AnsiColor::Green.on_default().bold())
    .usage(AnsiColor::Green.on_default().bold())
    .literal(AnsiColor::Cyan.on_default().bold())
    .placeholder(AnsiColor::Cyan.on_default());

/// Exact topology of meshes and cell complexes.
///
/// coface reads surfaces, volume meshes, facet lists and chain complexes, says what they are and what is wrong with
/// them, and answers topological questions exactly, over the integers.
#[derive(Parser)]
#[command(name = "coface", version, styles = STYLES, max_term_width = 100, after_help = AFTER_HELP)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) verb: Verb,
    #[command(flatten)]
    pub(crate) common: Common,
}

impl Arguments {
    /// The program for people: without the verbs that no help lists.
    pub(crate) fn for_people() -> Command {
        let whole = Self::command();
        let mut shown = Command::new("coface")
            .version(env!("CARGO_PKG_VERSION"))
            .after_help(AFTER_HELP)
            .args(whole.get_arguments().cloned())
            .subcommands(whole.get_subcommands().filter(|verb| !verb.is_hide_set()).cloned());
        if let Some(about) = whole.get_about() {
            shown = shown.about(about.clone());
        }
        if let Some(about) = whole.get_long_about() {
            shown = shown.long_about(about.clone());
        }
        shown
    }
}

const AFTER_HELP: &str = "\
Vertices are numbered from 0 in the order of the file, whatever the format does.
Exit status: 0 done; 1 the input or the request cannot be served; 2 wrong usage; 130 interrupted; 143 terminated.

  coface info bunny.ply              what is it, and what is wrong with it?
  coface homology torus.off --json   integral homology for a program
  coface link mesh.obj --simplices 17
  coface convert scan.ply -o scan.off";

/// Options that every verb takes.
#[derive(Args)]
pub(crate) struct Common {
    /// Print exactly one JSON object on standard output
    #[arg(long, global = true, help_heading = "Common options")]
    pub(crate) json: bool,
    /// No progress and no remarks on standard error; errors are still said
    #[arg(long, short, global = true, help_heading = "Common options")]
    pub(crate) quiet: bool,
    /// Use N threads [default: one a core]; results never depend on it
    #[arg(long, value_name = "N", global = true, help_heading = "Common options",
          value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) threads: Option<u16>,
    /// Write the result to this file; its extension is the format
    #[arg(short, long, value_name = "OUT", global = true, help_heading = "Common options")]
    pub(crate) output: Option<PathBuf>,
    /// Read the input as this format, instead of finding out: off, obj, ply, stl, ...
    #[arg(long, value_name = "F", global = true, help_heading = "Common options", value_parser = format_of_name)]
    pub(crate) format: Option<Format>,
    /// Replace the curves of an SVG by chords within this length of them, in its unit
    #[arg(long, value_name = "LENGTH", global = true, help_heading = "Common options",
          allow_negative_numbers = true, value_parser = flatness)]
    pub(crate) flatten: Option<f64>,
    #[command(flatten)]
    pub(crate) voxels: VoxelArguments,
}

/// Which voxels of a volume are set.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct VoxelArguments {
    /// Of a volume (.npy, NRRD, NIfTI) take the voxels of T and above, instead of all that are not 0
    #[arg(long, value_name = "T", global = true, help_heading = "Volumes", allow_negative_numbers = true,
          value_parser = number, conflicts_with_all = ["below", "between", "value"])]
    threshold: Option<f64>,
    /// The voxels below T
    #[arg(long, value_name = "T", global = true, help_heading = "Volumes", allow_negative_numbers = true,
          value_parser = number, conflicts_with_all = ["between", "value"])]
    below: Option<f64>,
    /// The voxels of A, B and all between
    #[arg(long, value_names = ["A", "B"], num_args = 2, global = true, help_heading = "Volumes",
          allow_negative_numbers = true, value_parser = number, conflicts_with = "value")]
    between: Option<Vec<f64>>,
    /// The voxels of one value, such as a label
    #[arg(long, value_name = "V", global = true, help_heading = "Volumes", allow_negative_numbers = true,
          value_parser = number)]
    value: Option<f64>,
    /// Axes of a volume whose last voxels meet the first: x, y, z or numbers from 0, with commas between them
    #[arg(long, value_name = "AXES", global = true, help_heading = "Volumes", value_parser = periodic_axes)]
    periodic: Option<PeriodicAxes>,
}

/// Which axes are periodic.
type PeriodicAxes = [bool; CubicalVolume::MOST_AXES];

impl VoxelArguments {
    /// What a worker is told.
    pub(crate) fn to_json(&self) -> Value {
        json!([self.threshold, self.below, self.between, self.value, self.periodic])
    }

    /// What [`Self::to_json`] says.
    pub(crate) fn of_json(value: &Value) -> Self {
        let numbers =
            |value: &Value| -> Option<Vec<f64>> { value.as_array()?.iter().map(Value::as_f64).collect() };
        let mut axes = PeriodicAxes::default();
        let periodic = value[4].as_array().map(|list| {
            axes.iter_mut().zip(list).for_each(|(axis, is_periodic)| *axis = *is_periodic == true);
            axes
        });
        Self {
            threshold: value[0].as_f64(),
            below: value[1].as_f64(),
            between: numbers(&value[2]),
            value: value[3].as_f64(),
            periodic,
        }
    }

    /// Which axes are periodic.
    pub(crate) fn periodic(&self) -> PeriodicAxes {
        self.periodic.unwrap_or_default()
    }

    pub(crate) fn reading(&self) -> VolumeReading {
        let rule = match (self.threshold, self.below, self.between.as_deref(), self.value) {
            (Some(bound), ..) => VoxelRule::AtLeast(bound),
            (_, Some(bound), ..) => VoxelRule::Below(bound),
            (_, _, Some(&[low, high]), _) => VoxelRule::Between(low, high),
            (.., Some(value)) => VoxelRule::Equal(value),
            _ => VoxelRule::Nonzero,
        };
        VolumeReading { rule, periodic: self.periodic() }
    }
}

fn number(text: &str) -> Result<f64, String> {
    let number: Option<f64> = text.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| "give a finite number".to_owned())
}

fn periodic_axes(text: &str) -> Result<PeriodicAxes, String> {
    let mut axes = PeriodicAxes::default();
    for name in text.split(',').map(str::trim) {
        let axis = match name {
            "x" => Some(0),
            "y" => Some(1),
            "z" => Some(2),
            _ => name.parse().ok().filter(|&axis: &usize| axis < axes.len()),
        };
        axes[axis.ok_or("name axes by x, y, z or numbers from 0 to 7, with commas between them")?] = true;
    }
    Ok(axes)
}

impl Common {
    /// How inputs are read.
    pub(crate) fn reading(&self) -> ReadOptions {
        let mut options = ReadOptions::default();
        (options.format, options.flatten) = (self.format, self.flatten);
        options.volume = self.voxels.reading();
        options
    }
}

fn flatness(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|length: &f64| length.is_finite() && *length > 0.0)
        .ok_or_else(|| "the distance of chords from curves is a finite length above 0".to_owned())
}

/// The format of this name or extension.
pub(crate) fn format_of_name(name: &str) -> Result<Format, String> {
    Format::from_name(name).map_err(|error| error.to_string())
}

#[derive(Subcommand)]
pub(crate) enum Verb {
    Info(commands::info::Info),
    Homology(commands::homology::Homology),
    Shard(commands::shard::Shard),
    Reduce(commands::reduce::Reduce),
    Merge(commands::merge::Merge),
    Persistence(commands::persistence::Persistence),
    Pi1(commands::pi1::Pi1),
    Cut(commands::cut::Cut),
    Cover(commands::cover::Cover),
    Cocycles(commands::cocycles::Cocycles),
    Star(commands::star::Star),
    Closure(commands::closure::Closure),
    Link(commands::link::Link),
    Boundary(commands::boundary::Boundary),
    Interior(commands::interior::Interior),
    Skeleton(commands::skeleton::Skeleton),
    Incidence(commands::incidence::Incidence),
    Congruence(commands::congruence::Congruence),
    Arrange(commands::arrange::Arrange),
    Boolean(commands::boolean::Boolean),
    Yin(commands::yin::Yin),
    Generate(commands::generate::Generate),
    Batch(commands::batch::Batch),
    Convert(commands::convert::Convert),
    View(commands::view::View),
    Render(commands::render::Render),
    #[command(hide = true)]
    Worker(commands::worker::Worker),
    Completions(commands::completions::Completions),
    Man(commands::man::Man),
}
