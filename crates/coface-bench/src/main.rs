//! Benches of coface: one task an algorithm, sizes in the name of the input, each row its own process.
//!
//! `cargo run --release -p coface-bench -- list` names tasks and inputs. `run` measures growth, `compare` runs other
//! programs on the same file, in turns, and prints the ratio of the medians.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program prints what it measured")]

mod arguments;
mod compare;
mod inputs;
mod measure;
mod run;
mod store;
mod table;
mod tasks;

use arguments::{Arguments, Verb};
use coface::Error;
use std::process::ExitCode;

fn main() -> ExitCode {
    match Arguments::parse(std::env::args().skip(1)).and_then(|arguments| perform(&arguments)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("coface-bench: {error}");
            ExitCode::FAILURE
        }
    }
}

fn perform(arguments: &Arguments) -> Result<(), Error> {
    match &arguments.verb {
        Verb::List => list(),
        Verb::Write { input, path } => inputs::write(input, path)?,
        Verb::Sample { task, path } => println!("{}", tasks::sample(task, path)?.to_line()),
        Verb::Run { names } => run::run(names, arguments)?,
        Verb::Compare { task, input, peers } => compare::compare(task, input, peers, arguments)?,
    }
    Ok(())
}

fn list() {
    println!("tasks (with the inputs that `run` gives them):");
    for task in tasks::ALL {
        println!("  {:<18} {} ({})", task.name, task.about, task.inputs.join(", "));
    }
    println!("\ninputs:");
    for (family, about) in inputs::FAMILIES {
        println!("  {family:<18} {about}");
    }
    println!("\n{}", arguments::USAGE);
}
