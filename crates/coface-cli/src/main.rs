//! The `coface` program: exact topology of meshes and cell complexes from the command line.
//!
//! A verb is a file in `commands/`. It reads its input by [`input`], asks the library, and prints by [`output`]; what
//! goes wrong comes back as a [`failure::Failure`] and is said here, once.

mod arguments;
mod certified;
mod chains;
mod classes;
mod commands;
mod domain;
mod examples;
mod failure;
mod filtration;
mod groups;
mod input;
mod limits;
mod output;
mod pictures;
mod points;
mod progress;
mod remarks;
mod simplices;
mod surface;
mod target;
mod verbs;
mod workers;
mod written;

use failure::Failure;
use std::process::ExitCode;
use verbs::Arguments;

fn main() -> ExitCode {
    let arguments = Arguments::of_command_line();
    progress::end_on_signals();
    let started = limits::keep(&arguments).and_then(|()| start_threads(&arguments));
    let done = started.and_then(|()| progress::watched(|| verbs::run(&arguments)));
    limits::work_is_done();
    match done {
        Ok(()) => ExitCode::SUCCESS,
        // The reader of our output went away: it has what it wanted.
        Err(Failure::ClosedPipe) => ExitCode::SUCCESS,
        Err(Failure::Usage(kind, message)) => {
            output::end_with(&Arguments::of_verb_in_use().error(kind, message))
        }
        Err(failure) => {
            failure.say();
            ExitCode::FAILURE
        }
    }
}

/// Rayon's pool with the number of threads asked for; without the option rayon takes one a core.
fn start_threads(arguments: &Arguments) -> Result<(), Failure> {
    let Some(count) = arguments.common.threads else { return Ok(()) };
    rayon::ThreadPoolBuilder::new()
        .num_threads(usize::from(count))
        .build_global()
        .map_err(|error| Failure::new(format!("cannot start {count} threads: {error}")))
}
