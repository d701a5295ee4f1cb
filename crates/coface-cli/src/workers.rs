//! Worker processes of the program itself.
//!
//! A worker is `coface worker TASK`, a verb that no help lists. What a task makes of a request is in
//! [`commands::worker`](crate::commands::worker).

use crate::failure::Failure;
use clap::ValueEnum;
use coface::scale::workers::{Limits, WorkerCommand, WorkerPool};
use std::thread::available_parallelism;

/// What workers do with requests.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Task {
    /// Report on a file.
    Info,
    /// Make, reduce and merge shards.
    Shards,
}

/// A pool of this program: at most `count` workers at once, each with so many threads.
pub(crate) fn pool(task: Task, count: usize, threads: usize, limits: Limits) -> Result<WorkerPool, Failure> {
    let program = std::env::current_exe()
        .map_err(|error| Failure::new(format!("the program does not find itself: {error}")))?;
    let task = task.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned());
    let arguments = ["worker".to_owned(), task, "--threads".to_owned(), threads.max(1).to_string()];
    Ok(WorkerPool::new(WorkerCommand::new(program, arguments), count, limits))
}

/// As many workers as the machine has cores.
pub(crate) fn core_count() -> usize {
    available_parallelism().map_or(1, usize::from)
}
