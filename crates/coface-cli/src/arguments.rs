//! The command line: verbs and the options they share.

use crate::commands;
use clap::builder::styling::{AnsiColor, Styles};
use clap::{Args, Parser, Subcommand};
use coface::io::{Format, ReadOptions};
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
}

impl Common {
    /// How inputs are read.
    pub(crate) fn reading(&self) -> ReadOptions {
        let mut options = ReadOptions::default();
        (options.format, options.flatten) = (self.format, self.flatten);
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
