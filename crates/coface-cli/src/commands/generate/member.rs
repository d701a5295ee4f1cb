//! Shapes and known spaces, by name and parameters: the subcommands are those of the table of families.

use super::construction::Numbers;
use clap::builder::{PossibleValuesParser, RangedI64ValueParser};
use clap::error::ErrorKind;
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Command, FromArgMatches, Subcommand, value_parser};
use coface::Error;
use coface::complexes::families::{Family, FamilyModel, Parameter, ParameterKind, ParameterValue};

/// A family with the values that the command line gives for its parameters.
pub(super) struct Member {
    family: &'static Family,
    values: Vec<(&'static str, ParameterValue)>,
}

impl Member {
    pub(super) fn make(&self) -> Result<FamilyModel, Error> {
        self.family.make(&self.values)
    }
}

impl Subcommand for Member {
    fn augment_subcommands(command: Command) -> Command {
        Family::all().fold(command, |command, family| command.subcommand(command_of(family)))
    }

    fn augment_subcommands_for_update(command: Command) -> Command {
        Self::augment_subcommands(command)
    }

    fn has_subcommand(name: &str) -> bool {
        Family::named(name).is_some()
    }
}

impl FromArgMatches for Member {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let found = matches.subcommand().and_then(|(name, own)| Some((Family::named(name)?, own)));
        let (family, matches) = found.ok_or_else(|| clap::Error::new(ErrorKind::MissingSubcommand))?;
        let is_given =
            |parameter: &&Parameter| matches.value_source(parameter.name()) == Some(ValueSource::CommandLine);
        let given = family.parameters().iter().filter(is_given);
        let values = given.map(|parameter| (parameter.name(), value_of(parameter, matches))).collect();
        Ok(Self { family, values })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The subcommand of a family.
pub(super) fn command_of(family: &'static Family) -> Command {
    let command = Command::new(family.name()).about(family.about()).visible_aliases(family.aliases());
    command.args(family.parameters().iter().map(argument_of))
}

fn argument_of(parameter: &'static Parameter) -> Arg {
    let name = parameter.name();
    let long = name.replace('_', "-");
    let argument = Arg::new(name).long(long).help(parameter.about());
    let argument = if name == "dimension" { argument.short('d') } else { argument };
    let named = argument.clone().value_name(parameter.symbol());
    match parameter.kind() {
        // The cells have names of their own in each dimension.
        ParameterKind::Flag if name == "cuboids" => {
            argument.action(ArgAction::SetTrue).visible_aliases(["quadrangles", "hexahedra"])
        }
        ParameterKind::Flag => argument.action(ArgAction::SetTrue),
        ParameterKind::Real { usual } => {
            named.allow_hyphen_values(true).value_parser(value_parser!(f64)).default_value(usual.to_string())
        }
        ParameterKind::Count { usual, least, most } => {
            let range = RangedI64ValueParser::<u32>::new().range(i64::from(least)..=i64::from(most));
            let argument = named.value_parser(range);
            match usual {
                Some(usual) => argument.default_value(usual.to_string()),
                None => argument,
            }
        }
        ParameterKind::Counts { usual } => {
            named.value_delimiter(',').value_parser(value_parser!(u32)).default_value(joined(usual))
        }
        ParameterKind::Reals { usual } => named
            .value_delimiter(',')
            .allow_hyphen_values(true)
            .value_parser(value_parser!(f64))
            .default_value(joined(usual)),
        ParameterKind::Integers { usual } => named
            .allow_hyphen_values(true)
            .value_parser(|text: &str| text.parse::<Numbers<i64>>())
            .default_value(joined(usual)),
        ParameterKind::Choice { words, usual } => {
            let argument = named.value_parser(PossibleValuesParser::new(words));
            match usual {
                Some(usual) => argument.default_value(usual),
                None => argument,
            }
        }
        // One word each time.
        ParameterKind::Words => named
            .long(name.trim_end_matches('s'))
            .action(ArgAction::Append)
            .allow_hyphen_values(true)
            .value_parser(|text: &str| text.parse::<Numbers<i32>>()),
    }
}

fn joined(numbers: &[impl ToString]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(",")
}

/// What the command line gives for a parameter.
fn value_of(parameter: &Parameter, matches: &ArgMatches) -> ParameterValue {
    let name = parameter.name();
    match parameter.kind() {
        ParameterKind::Real { .. } => ParameterValue::Real(one(matches, name)),
        ParameterKind::Count { .. } => ParameterValue::Count(one(matches, name)),
        ParameterKind::Counts { .. } => ParameterValue::Counts(all(matches, name)),
        ParameterKind::Reals { .. } => ParameterValue::Reals(all(matches, name)),
        ParameterKind::Integers { .. } => {
            ParameterValue::Integers(one::<Numbers<i64>>(matches, name).into_inner())
        }
        ParameterKind::Flag => ParameterValue::Flag(matches.get_flag(name)),
        ParameterKind::Choice { .. } => ParameterValue::Choice(one(matches, name)),
        ParameterKind::Words => {
            let words = all::<Numbers<i32>>(matches, name);
            ParameterValue::Words(words.into_iter().map(Numbers::into_inner).collect())
        }
    }
}

fn one<T: Clone + Send + Sync + 'static>(matches: &ArgMatches, name: &str) -> T {
    matches.get_one::<T>(name).cloned().expect("a parameter that is given has a value")
}

fn all<T: Clone + Send + Sync + 'static>(matches: &ArgMatches, name: &str) -> Vec<T> {
    matches.get_many::<T>(name).into_iter().flatten().cloned().collect()
}
