//! The command line as a whole: the verbs, and the one that runs.

use crate::arguments::Common;
use crate::commands;
use crate::failure::Failure;
use clap::builder::styling::{AnsiColor, Styles};
use clap::{Command, CommandFactory, Parser, Subcommand};

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

/// Runs the verb of the command line.
pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let common = &arguments.common;
    match &arguments.verb {
        Verb::Info(verb) => verb.run(common),
        Verb::Homology(verb) => verb.run(common),
        Verb::Shard(verb) => verb.run(common),
        Verb::Reduce(verb) => verb.run(common),
        Verb::Merge(verb) => verb.run(common),
        Verb::Persistence(verb) => verb.run(common),
        Verb::Pi1(verb) => verb.run(common),
        Verb::Cut(verb) => verb.run(common),
        Verb::Cover(verb) => verb.run(common),
        Verb::Cocycles(verb) => verb.run(common),
        Verb::Star(verb) => verb.run(common),
        Verb::Closure(verb) => verb.run(common),
        Verb::Link(verb) => verb.run(common),
        Verb::Boundary(verb) => verb.run(common),
        Verb::Interior(verb) => verb.run(common),
        Verb::Skeleton(verb) => verb.run(common),
        Verb::Incidence(verb) => verb.run(common),
        Verb::Congruence(verb) => verb.run(common),
        Verb::Arrange(verb) => verb.run(common),
        Verb::Boolean(verb) => verb.run(common),
        Verb::Yin(verb) => verb.run(common),
        Verb::Generate(verb) => verb.run(common),
        Verb::Batch(verb) => verb.run(common),
        Verb::Convert(verb) => verb.run(common),
        Verb::View(verb) => verb.run(common),
        Verb::Render(verb) => verb.run(common),
        Verb::Worker(verb) => verb.run(),
        Verb::Completions(verb) => verb.run(&mut Arguments::for_people()),
        Verb::Man(verb) => verb.run(Arguments::for_people(), common),
    }
}
