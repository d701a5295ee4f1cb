//! `coface worker`: answers requests of a pool of worker processes.

use crate::commands::homology::parts;
use crate::commands::persistence;
use crate::failure::Failure;
use crate::workers::Task;
use clap::Args;
use coface::scale::batch::Examiner;
use coface::scale::workers::serve;

/// Answer requests, one a line on standard input; for pools of this program.
#[derive(Args)]
pub(crate) struct Worker {
    /// What to do with requests
    #[arg(value_enum)]
    task: Task,
}

impl Worker {
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match self.task {
            Task::Info => {
                let mut examiner = Examiner::default();
                serve(|request| examiner.examine(request))?;
            }
            Task::Shards => serve(parts::answer_request)?,
            Task::Images => serve(persistence::parts::answer_request)?,
        }
        Ok(())
    }
}
