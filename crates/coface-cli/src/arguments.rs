//! The options that verbs share.

use crate::failure::Failure;
use crate::points::PointArguments;
use clap::Args;
use coface::complexes::cubical::CubicalVolume;
use coface::io::{Format, ReadOptions, VolumeReading, VoxelRule};
use coface::scale::workers::{parse_bytes, parse_duration};
use coface::topology::Coefficients;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::time::Duration;

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
    /// Replace curves by chords within this length of them, in the unit of the drawing [default: in SVG a thousandth of the drawing's size, in WKT and WKB 32 chords for a quarter of a circle]
    #[arg(long, value_name = "LENGTH", global = true, help_heading = "Common options",
          allow_negative_numbers = true, value_parser = flatness)]
    pub(crate) flatten: Option<f64>,
    /// The most memory that the program may hold: 500M, 2G, or none
    #[arg(long, value_name = "SIZE", global = true, help_heading = "Common options", value_parser = memory_limit)]
    pub(crate) memory: Option<Limit<u64>>,
    /// The longest that the program may take: 500ms, 60s, 5m, 2h, or none
    #[arg(long, value_name = "TIME", global = true, help_heading = "Common options", value_parser = time_limit)]
    pub(crate) time_limit: Option<Limit<Duration>>,
    /// Make everything that a reader assumes an error: a face that repeats a vertex, counts that differ, ..
    #[arg(long, global = true, help_heading = "Common options")]
    pub(crate) strict: bool,
    /// Read a damaged file up to its first fault
    #[arg(long, global = true, help_heading = "Common options")]
    pub(crate) partial: bool,
    /// Let the input name other files outside of its folder, as the header of an NRRD file and a glTF do: for files
    /// that you trust
    #[arg(long, global = true, help_heading = "Common options")]
    pub(crate) allow_outside: bool,
    /// Read this level of detail of CityJSON, such as 1.2 [default: the highest of each object]
    #[arg(long, value_name = "L", global = true, help_heading = "Common options", value_parser = number)]
    pub(crate) lod: Option<f64>,
    /// Take the ideal vertices of a triangulation of a 3-manifold as points, instead of cutting them off
    #[arg(long, global = true, help_heading = "Common options")]
    pub(crate) pseudomanifold: bool,
    #[command(flatten)]
    pub(crate) voxels: VoxelArguments,
    #[command(flatten)]
    pub(crate) points: PointArguments,
}

/// Which voxels of a volume are set.
#[derive(Args, Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct VoxelArguments {
    /// Of a volume (.npy, NRRD, NIfTI, MetaImage, PGM, PNG) take the voxels of T and above, instead of all that are not 0; of points and graphs (--rips, --cech, --flag) the simplices
    /// up to the diameter, radius or value T, and with --mapper neighbors within T
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

/// A limit that may be none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Limit<T>(pub(crate) Option<T>);

/// A duration with its unit, or `none`.
pub(crate) fn time_limit(text: &str) -> Result<Limit<Duration>, String> {
    limit(text, parse_duration)
}

/// An amount of memory with its unit, or `none`.
pub(crate) fn memory_limit(text: &str) -> Result<Limit<u64>, String> {
    limit(text, parse_bytes)
}

fn limit<T>(text: &str, parse: fn(&str) -> Result<T, coface::Error>) -> Result<Limit<T>, String> {
    if text == "none" {
        return Ok(Limit(None));
    }
    parse(text).map(|value| Limit(Some(value))).map_err(|error| error.to_string())
}

/// Which axes are periodic.
type PeriodicAxes = [bool; CubicalVolume::MOST_AXES];

impl VoxelArguments {
    /// The threshold by itself; of points it is the largest diameter, of graphs the largest value.
    pub(crate) fn threshold(&self) -> Option<f64> {
        self.threshold
    }

    /// The option that chooses voxels, if one is given.
    pub(crate) fn rule_given(&self) -> Option<&'static str> {
        let given = [
            ("--threshold", self.threshold.is_some()),
            ("--below", self.below.is_some()),
            ("--between", self.between.is_some()),
            ("--value", self.value.is_some()),
        ];
        given.into_iter().find(|&(_, is_given)| is_given).map(|(name, _)| name)
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

/// A length.
pub(crate) fn length(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|length: &f64| length.is_finite() && *length >= 0.0)
        .ok_or_else(|| "give a finite length that is not negative".to_owned())
}

pub(crate) fn number(text: &str) -> Result<f64, String> {
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
    /// The first option that says how a model is read, if one is given.
    fn input_option(&self) -> Option<&'static str> {
        let given = [
            ("--format", self.format.is_some()),
            ("--flatten", self.flatten.is_some()),
            ("--partial", self.partial),
            ("--allow-outside", self.allow_outside),
            ("--lod", self.lod.is_some()),
            ("--pseudomanifold", self.pseudomanifold),
            ("--periodic", self.voxels.periodic.is_some()),
        ];
        let other = given.into_iter().find(|&(_, is_given)| is_given).map(|(name, _)| name);
        self.points.given().or(self.voxels.rule_given()).or(other)
    }

    /// Refuses options that say how a model is read, where none is.
    pub(crate) fn refuse_input_options(&self) -> Result<(), Failure> {
        match self.input_option() {
            None => Ok(()),
            Some(option) => Err(Failure::new(format!(
                "{option} says how a model is read, and none is read here: leave it out"
            ))),
        }
    }

    /// How inputs are read.
    pub(crate) fn reading(&self) -> ReadOptions {
        let options = ReadOptions::new()
            .format(self.format)
            .flatten(self.flatten)
            .volume(self.voxels.reading())
            .strict(self.strict)
            .partial(self.partial)
            .allow_outside(self.allow_outside)
            .lod(self.lod)
            .pseudomanifold(self.pseudomanifold);
        self.points.reading(options, self.voxels.threshold())
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

/// The ring of coefficients of this name.
pub(crate) fn ring(name: &str) -> Result<Coefficients, String> {
    name.parse().map_err(|error: coface::Error| error.to_string())
}
