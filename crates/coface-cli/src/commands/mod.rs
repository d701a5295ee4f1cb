//! The verbs, one a file.

pub(crate) mod arrange;
pub(crate) mod batch;
pub(crate) mod boolean;
pub(crate) mod boundary;
pub(crate) mod closure;
pub(crate) mod cocycles;
pub(crate) mod completions;
pub(crate) mod congruence;
pub(crate) mod convert;
pub(crate) mod cover;
pub(crate) mod cut;
pub(crate) mod generate;
pub(crate) mod homology;
pub(crate) mod incidence;
pub(crate) mod info;
pub(crate) mod interior;
pub(crate) mod link;
pub(crate) mod man;
pub(crate) mod merge;
pub(crate) mod persistence;
pub(crate) mod pi1;
pub(crate) mod reduce;
pub(crate) mod render;
pub(crate) mod shard;
pub(crate) mod skeleton;
pub(crate) mod star;
pub(crate) mod view;
pub(crate) mod worker;
pub(crate) mod yin;

use crate::arguments::{Arguments, Verb};
use crate::failure::Failure;

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
        Verb::Completions(verb) => verb.run(),
        Verb::Man(verb) => verb.run(common),
    }
}
