//! The command line as a whole: the verbs, and the one that runs.

use crate::arguments::Common;
use crate::commands;
use crate::examples::with_examples;
use crate::failure::Failure;
use crate::output::end_with;
use crate::remarks::say_read;
use crate::written::Written;
use clap::builder::styling::{AnsiColor, Styles};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Args, Command, CommandFactory, FromArgMatches, Parser, Subcommand};
use coface::io::{check_output, replace_together};
use std::ffi::OsString;
use std::path::Path;
use std::time::Duration;

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
    /// The command line of this run; a file alone is a file to report on: `coface FILE` is `coface info FILE`. Wrong usage
    /// ends the program.
    pub(crate) fn of_command_line() -> Self {
        let words: Vec<OsString> = std::env::args_os().collect();
        if let Some(arguments) = Self::of_verb_alone(&words) {
            return arguments;
        }
        let matches =
            Self::shaped().try_get_matches_from(&words).or_else(|error| match file_alone(&error, &words) {
                Some(true) => Self::shaped().try_get_matches_from(with_info(&words)),
                Some(false) => Err(no_such_file(&error)),
                None => match with_input_first(&error, &words) {
                    Some(words) => Self::shaped().try_get_matches_from(words).map_err(|again| {
                        // The word was the value of the option after all.
                        if again.kind() == ErrorKind::UnknownArgument { error } else { again }
                    }),
                    None => Err(error),
                },
            });
        matches.and_then(|matches| Self::from_arg_matches(&matches)).unwrap_or_else(|error| end_with(&error))
    }

    /// The command line by its verb alone, where that stands first and all is well; else all verbs are asked, which know what to say. Putting forty
    /// verbs together takes longer than most of them work.
    fn of_verb_alone(words: &[OsString]) -> Option<Self> {
        let verb = Verb::alone(words.get(1)?.to_str()?)?;
        let program = Common::augment_args(Command::new("coface")).subcommand(verb);
        let matches = shape(program).try_get_matches_from(words).ok()?;
        Self::from_arg_matches(&matches).ok()
    }

    /// The verb of this run, whose usage a message about it shows.
    pub(crate) fn of_verb_in_use() -> Command {
        let mut whole = Self::shaped();
        whole.build();
        let words = std::env::args().skip(1);
        let verb = words.into_iter().find_map(|word| whole.find_subcommand(&word).cloned());
        verb.unwrap_or(whole)
    }

    /// The most memory that this process may hold. The verbs that share memory out to workers keep the limit there.
    pub(crate) fn memory_of_program(&self) -> Option<u64> {
        match &self.verb {
            Verb::Homology(_) | Verb::Batch(_) | Verb::Worker(_) => None,
            Verb::Persistence(persistence) if persistence.is_in_parts() => None,
            _ => self.common.memory.and_then(|limit| limit.0),
        }
    }

    /// The longest that this process may take. The verbs that simplify groups, and the search for a shortest cycle, say after this time what is
    /// known then.
    pub(crate) fn time_of_program(&self) -> Option<Duration> {
        match &self.verb {
            Verb::Pi1(_) | Verb::Subgroups(_) => None,
            Verb::Cycles(cycles) if cycles.has_bounds() => None,
            _ => self.common.time_limit.and_then(|limit| limit.0),
        }
    }

    /// The command line with the options that a verb cannot use left out of its help, which ends with examples.
    pub(crate) fn shaped() -> Command {
        with_examples(shape(Self::command()))
    }

    /// The program for people: without the verbs that no help lists.
    pub(crate) fn for_people() -> Command {
        let whole = Self::shaped();
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

/// All verbs, or one, each without the options in its help that it cannot use. It takes them all the same.
fn shape(mut whole: Command) -> Command {
    let hidden = |whole: &Command, is_one: &dyn Fn(&Arg) -> bool| -> Vec<Arg> {
        whole.get_arguments().filter(|option| is_one(option)).map(|one| one.clone().hide(true)).collect()
    };
    let volumes = hidden(&whole, &|option| option.get_help_heading() == Some("Volumes"));
    let points = hidden(&whole, &|option| {
        option.get_help_heading() == Some("Points and graphs")
            && !ALL_TAKE.contains(&option.get_id().as_str())
    });
    let inputs = hidden(&whole, &|option| OF_INPUTS.contains(&option.get_id().as_str()));
    let with_dimension: Vec<String> = whole
        .get_subcommands()
        .filter(|verb| has_dimension(verb))
        .map(|verb| verb.get_name().to_owned())
        .collect();
    for verb in with_dimension {
        // These have a dimension of their own.
        let mut other = whole
            .get_arguments()
            .find(|option| option.get_id() == "points_dimension")
            .expect("an option of points")
            .clone();
        other = other.long("points-dimension").hide(true);
        whole = whole.mut_subcommand(verb, |verb| verb.arg(other));
    }
    for verb in WITHOUT_VOLUMES {
        if whole.find_subcommand(verb).is_some() {
            whole = whole.mut_subcommand(verb, |verb| verb.args(&volumes).args(&points));
        }
    }
    for verb in WITHOUT_INPUTS {
        if whole.find_subcommand(verb).is_some() {
            whole = whole.mut_subcommand(verb, |verb| verb.args(&volumes).args(&inputs));
        }
    }
    whole
}

/// Whether a verb has an option `--dimension` of its own.
fn has_dimension(verb: &Command) -> bool {
    verb.get_arguments().any(|option| option.get_long() == Some("dimension"))
        || verb.get_subcommands().any(has_dimension)
}

/// Whether the word that is no verb names a file that is there, or standard input; `None` if it looks like a verb, or follows one.
fn file_alone(error: &clap::Error, words: &[OsString]) -> Option<bool> {
    let word = word_that_is_no_verb(error)?;
    let whole = Arguments::shaped();
    let before = words.iter().skip(1).take_while(|other| *other != word);
    if before.into_iter().any(|other| whole.find_subcommand(other).is_some()) {
        return None;
    }
    // One model of a file with several is FILE#3.
    let file = word.rsplit_once('#').map_or(word, |(file, _)| file);
    let is_there = word == "-" || Path::new(word).exists() || Path::new(file).is_file();
    (is_there || word.contains(['.', '/'])).then_some(is_there)
}

fn word_that_is_no_verb(error: &clap::Error) -> Option<&str> {
    match error.get(ContextKind::InvalidSubcommand)? {
        ContextValue::String(word) => Some(word),
        _ => None,
    }
}

/// Options whose value may be left out.
const WITH_OR_WITHOUT_VALUE: [&str; 5] = ["--alpha", "--cycles", "--generators", "--repair", "--reset"];

/// The command line with the input before an option that took it for its value, as in `coface homology --generators FILE`.
fn with_input_first(error: &clap::Error, words: &[OsString]) -> Option<Vec<OsString>> {
    let is_missing = matches!(
        error.kind(),
        ErrorKind::MissingRequiredArgument | ErrorKind::InvalidValue | ErrorKind::ValueValidation
    );
    let takes_file = |pair: &[OsString]| {
        WITH_OR_WITHOUT_VALUE.iter().any(|option| pair[0] == *option) && Path::new(&pair[1]).is_file()
    };
    let at = words.windows(2).position(takes_file).filter(|_| is_missing)?;
    let mut words = words.to_vec();
    words.swap(at, at + 1);
    Some(words)
}

fn no_such_file(error: &clap::Error) -> clap::Error {
    let word = word_that_is_no_verb(error).unwrap_or_default();
    let message = format!("{word}: there is no such file, and no verb of this name; check the path");
    Arguments::shaped().error(ErrorKind::InvalidSubcommand, message)
}

/// The command line with the verb `info` in front.
fn with_info(words: &[OsString]) -> impl Iterator<Item = OsString> {
    let (program, rest) = words.split_at(words.len().min(1));
    program.iter().cloned().chain([OsString::from("info")]).chain(rest.iter().cloned())
}

/// The verbs that never read a volume of voxels.
const WITHOUT_VOLUMES: [&str; 12] = [
    "star",
    "closure",
    "link",
    "boundary",
    "interior",
    "skeleton",
    "congruence",
    "arrange",
    "boolean",
    "map",
    "yin",
    "merge",
];

/// The options of points that need no `--threshold`.
const ALL_TAKE: [&str; 4] = ["alpha", "weighted", "radii", "points_dimension"];

/// The verbs that read no model.
const WITHOUT_INPUTS: [&str; 4] = ["check", "diagram", "completions", "man"];

/// The options that say how a model is read.
const OF_INPUTS: [&str; 24] = [
    "format",
    "flatten",
    "strict",
    "partial",
    "allow_outside",
    "lod",
    "pseudomanifold",
    "alpha",
    "weighted",
    "radii",
    "periods",
    "rips",
    "flag",
    "directed",
    "cech",
    "landmarks",
    "strong",
    "mapper",
    "overlap",
    "lens",
    "points_dimension",
    "distances",
    "delay",
    "embedding",
];

const AFTER_HELP: &str = "\
Vertices are numbered from 0 in the order of the file, whatever the format does.
Exit status: 0 done; 1 the input or the request cannot be served; 2 wrong usage; 129 its terminal was closed; 130 interrupted; 143 terminated.

  coface bunny.ply                   what is it, and what is wrong with it? (coface info)
  coface homology torus.off --json   integral homology for a program
  coface link mesh.obj --simplices 17
  coface convert scan.ply -o scan.off";

/// The verbs, of which each can be had without the others. The name of a verb is that of its variant in lower case.
macro_rules! verbs {
    ($($(#[$attribute:meta])* $variant:ident($arguments:ty),)*) => {
        #[derive(Subcommand)]
        pub(crate) enum Verb {
            $($(#[$attribute])* $variant($arguments),)*
        }

        impl Verb {
            /// The verb of this name; `None` if there is none.
            fn alone(name: &str) -> Option<Command> {
                let is_named = |variant: &str| {
                    variant.eq_ignore_ascii_case(name) && !name.contains(|letter: char| letter.is_uppercase())
                };
                $(if is_named(stringify!($variant)) {
                    return Some(<$arguments>::augment_args(Command::new(name.to_owned())));
                })*
                None
            }
        }
    };
}

verbs! {
    Info(commands::info::Info),
    Homology(commands::homology::Homology),
    Check(commands::check::Check),
    Shard(commands::shard::Shard),
    Reduce(commands::reduce::Reduce),
    Merge(commands::merge::Merge),
    Persistence(commands::persistence::Persistence),
    Diagram(commands::diagram::Diagram),
    Euler(commands::euler::Euler),
    Pi1(commands::pi1::Pi1),
    Loops(commands::loops::Loops),
    Cycles(commands::cycles::Cycles),
    Homotopic(commands::homotopic::Homotopic),
    Subgroups(commands::subgroups::Subgroups),
    Cut(commands::cut::Cut),
    Edit(commands::edit::EditSurface),
    Isomorphic(commands::isomorphic::Isomorphic),
    Simplify(commands::simplify::Simplify),
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
    Map(commands::map::MapVerb),
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

/// Runs the verb of the command line, and says what the readers of its inputs assumed.
pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let done = serve(arguments);
    say_read(&arguments.common);
    done
}

fn serve(arguments: &Arguments) -> Result<(), Failure> {
    let common = &arguments.common;
    common.points.check(&common.voxels)?;
    if !reads_models(&arguments.verb) {
        common.refuse_input_options()?;
    }
    if let Some(output) = &common.output {
        // Before the work, not after it.
        check_output(output)?;
    }
    written_by(&arguments.verb).check_output(common)?;
    if is_written_together(&arguments.verb) {
        replace_together(|| run_verb(arguments))
    } else {
        run_verb(arguments)
    }
}

/// Whether a verb reads models; [`WITHOUT_INPUTS`] has the names of those that never do.
fn reads_models(verb: &Verb) -> bool {
    match verb {
        Verb::Check(_) | Verb::Diagram(_) | Verb::Completions(_) | Verb::Man(_) => false,
        Verb::Generate(verb) => verb.reads_models(),
        _ => true,
    }
}

/// What a verb writes into the file of -o.
fn written_by(verb: &Verb) -> Written {
    match verb {
        Verb::Simplify(_)
        | Verb::Edit(_)
        | Verb::Cut(_)
        | Verb::Cover(_)
        | Verb::Loops(_)
        | Verb::Cycles(_) => Written::Model,
        Verb::Star(_)
        | Verb::Closure(_)
        | Verb::Link(_)
        | Verb::Boundary(_)
        | Verb::Interior(_)
        | Verb::Skeleton(_)
        | Verb::Congruence(_) => Written::Model,
        Verb::Cocycles(verb) => verb.written(),
        Verb::Pi1(_)
        | Verb::Subgroups(_)
        | Verb::Isomorphic(_)
        | Verb::Homotopic(_)
        | Verb::Check(_)
        | Verb::Merge(_) => Written::Answer,
        // Each of these looks at the name before it reads.
        Verb::Info(_)
        | Verb::Homology(_)
        | Verb::Persistence(_)
        | Verb::Diagram(_)
        | Verb::Euler(_)
        | Verb::Incidence(_)
        | Verb::Arrange(_)
        | Verb::Boolean(_)
        | Verb::Map(_)
        | Verb::Yin(_)
        | Verb::Generate(_)
        | Verb::Batch(_)
        | Verb::Convert(_)
        | Verb::View(_)
        | Verb::Render(_) => Written::Other,
        // Folders, or nothing.
        Verb::Shard(_) | Verb::Reduce(_) | Verb::Worker(_) | Verb::Completions(_) | Verb::Man(_) => {
            Written::Other
        }
    }
}

/// Whether the files of a verb appear when all of them are complete. What is done in parts keeps the files of each part, and pictures that
/// move have many.
fn is_written_together(verb: &Verb) -> bool {
    match verb {
        Verb::Homology(verb) => !verb.is_in_parts(),
        Verb::Persistence(verb) => !verb.is_in_parts(),
        Verb::Shard(_)
        | Verb::Reduce(_)
        | Verb::Merge(_)
        | Verb::Batch(_)
        | Verb::Render(_)
        | Verb::Worker(_)
        | Verb::Yin(_) => false,
        _ => true,
    }
}

fn run_verb(arguments: &Arguments) -> Result<(), Failure> {
    let common = &arguments.common;
    match &arguments.verb {
        Verb::Info(verb) => verb.run(common),
        Verb::Homology(verb) => verb.run(common),
        Verb::Check(verb) => verb.run(common),
        Verb::Shard(verb) => verb.run(common),
        Verb::Reduce(verb) => verb.run(common),
        Verb::Merge(verb) => verb.run(common),
        Verb::Persistence(verb) => verb.run(common),
        Verb::Diagram(verb) => verb.run(common),
        Verb::Euler(verb) => verb.run(common),
        Verb::Pi1(verb) => verb.run(common),
        Verb::Loops(verb) => verb.run(common),
        Verb::Cycles(verb) => verb.run(common),
        Verb::Homotopic(verb) => verb.run(common),
        Verb::Subgroups(verb) => verb.run(common),
        Verb::Cut(verb) => verb.run(common),
        Verb::Edit(verb) => verb.run(common),
        Verb::Isomorphic(verb) => verb.run(common),
        Verb::Simplify(verb) => verb.run(common),
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
        Verb::Map(verb) => verb.run(common),
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

#[cfg(test)]
mod tests {
    use super::{Arguments, Verb, shape};
    use crate::arguments::Common;
    use clap::{Arg, Args, Command};

    /// The options of a verb that has been built, each with all that is known of it, and those of the verbs in it.
    fn options(verb: &Command) -> Vec<String> {
        // The order in which help lists them counts the verbs before them.
        let describe = |option: &Arg| format!("{:?}", option.clone().display_order(0));
        let own = verb.get_arguments().map(describe);
        own.chain(verb.get_subcommands().flat_map(options)).collect()
    }

    #[test]
    fn a_verb_alone_takes_what_it_takes_among_all() {
        let mut whole = Arguments::shaped();
        whole.build();
        let mut count = 0;
        for verb in whole.get_subcommands().filter(|verb| verb.get_name() != "help") {
            let name = verb.get_name();
            let alone = Verb::alone(name).expect(name);
            let mut alone = shape(Common::augment_args(Command::new("coface")).subcommand(alone));
            alone.build();
            let alone = alone.find_subcommand(name).expect(name);
            assert_eq!(options(alone), options(verb), "{name}");
            count += 1;
        }
        assert_eq!(count, 40);
        assert!(
            Verb::alone("Info").is_none() && Verb::alone("help").is_none() && Verb::alone("a.off").is_none()
        );
    }
}
