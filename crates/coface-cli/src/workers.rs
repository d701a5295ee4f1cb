//! Worker processes of the program itself.
//!
//! A worker is `coface worker TASK`, a verb that no help lists. What a task makes of a request is in
//! [`commands::worker`](crate::commands::worker).

use crate::failure::Failure;
use clap::ValueEnum;
use coface::Error;
use coface::io::{FolderLock, MadeFolders, TemporaryFolder};
use coface::scale::workers::{Limits, Loss, WorkerCommand, WorkerPool, bytes_text};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::alloc::{Layout, handle_alloc_error};
use std::path::{Path, PathBuf};
use std::thread::available_parallelism;

/// What workers do with requests.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Task {
    /// Report on a file.
    Info,
    /// Make, reduce and merge shards.
    Shards,
    /// Make and merge parts of images.
    Images,
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

/// A worker that does anything at all takes so much.
const LEAST: u64 = 64 << 20;
/// What is advised instead of less.
const ADVISED: u64 = 96 << 20;
/// Workers are not started for less each, as long as one can do the work.
const COMFORT: u64 = 256 << 20;

/// Workers of one task that share the memory of all.
pub(crate) struct Sharing {
    pub(crate) task: Task,
    /// At most so many at once.
    pub(crate) workers: usize,
    /// The memory of all together, if it is limited.
    pub(crate) memory: Option<u64>,
}

/// What workers reply, a line each.
pub(crate) trait WorkerReply: Serialize + DeserializeOwned {
    /// Says that the request cannot be served.
    fn of_error(message: String) -> Self;

    /// The message, if this says that the request cannot be served.
    fn error(&self) -> Option<&str>;
}

/// What a worker replies to the line of a request. One that has not enough memory ends, as where an allocation fails: the process that asked says what that means.
pub(crate) fn reply_to<Q: DeserializeOwned, R: WorkerReply>(
    request: &str,
    answer: impl FnOnce(Q) -> Result<R, Failure>,
) -> String {
    let request = serde_json::from_str(request)
        .map_err(|error| Failure::new(format!("a worker was asked what it does not know: {error}")));
    line(&match request.and_then(answer) {
        Ok(reply) => reply,
        Err(Failure::Message(message)) => R::of_error(message),
        Err(Failure::Memory(_)) => handle_alloc_error(Layout::new::<u8>()),
        Err(_) => R::of_error("the request could not be answered".to_owned()),
    })
}

impl Sharing {
    /// As many workers as there are threads, but no more than the memory is enough for.
    pub(crate) fn new(task: Task, threads: Option<u16>, memory: Option<u64>) -> Result<Self, Failure> {
        if let Some(memory) = memory.filter(|&memory| memory < LEAST) {
            return Err(Failure::new(format!(
                "{} of memory is too little for any part; give --memory {}M or more",
                bytes_text(memory),
                ADVISED >> 20
            )));
        }
        let threads = threads.map_or_else(core_count, usize::from);
        let fit = memory.map_or(usize::MAX, |memory| (memory / COMFORT).max(1) as usize);
        Ok(Self { task, workers: threads.min(fit), memory })
    }

    /// Asks workers side by side, and those requests again that need more memory than one has then, alone with all of it.
    pub(crate) fn ask_all<R: WorkerReply>(
        &self,
        stage: &str,
        count: u32,
        request: impl Fn(u32) -> String + Sync,
        fault: impl Fn(u32, Loss) -> String,
    ) -> Result<Vec<R>, Failure> {
        let first = self.ask(stage, self.workers, count as usize, |number| request(number as u32))?;
        let mut answers = Vec::with_capacity(first.len());
        for (number, outcome) in (0..).zip(first) {
            answers.push(
                match outcome {
                    Err(Loss::Memory { .. }) if self.workers > 1 => {
                        self.ask(stage, 1, 1, |_| request(number))?.remove(0)
                    }
                    outcome => outcome,
                }
                .map_err(|loss| Failure::new(fault(number, loss)))?,
            );
        }
        Ok(answers)
    }

    /// What so many workers, that share the memory, say to requests.
    pub(crate) fn ask<R: WorkerReply>(
        &self,
        stage: &str,
        workers: usize,
        count: usize,
        request: impl Fn(usize) -> String + Sync,
    ) -> Result<Vec<Result<R, Loss>>, Failure> {
        let workers = workers.min(count).max(1);
        let limits = Limits { time: None, memory: self.memory.map(|memory| memory / workers as u64) };
        let mut answers = Vec::with_capacity(count);
        pool(self.task, workers, 1, limits)?.run_in_order(stage, count, request, |_, outcome| {
            answers.push(match outcome {
                Ok(answer) => {
                    let reply: R = serde_json::from_str(&answer.line)
                        .map_err(|error| Error::parse(format!("a worker gave no reply: {error}")))?;
                    if let Some(message) = reply.error() {
                        return Err(Error::invalid(message.to_owned()));
                    }
                    Ok(reply)
                }
                Err(loss) => Err(loss),
            });
            Ok(())
        })?;
        Ok(answers)
    }
}

/// A request or a reply as a line.
pub(crate) fn line(message: &impl Serialize) -> String {
    serde_json::to_string(message).expect("requests and replies have texts as keys")
}

/// A path as text, which lines are.
pub(crate) fn text_of_path(path: &Path) -> Result<String, Failure> {
    path.to_str().map(str::to_owned).ok_or_else(|| {
        Failure::new(format!(
            "{}: the name is not valid UTF-8, so it cannot be sent to worker processes; rename it",
            path.display()
        ))
    })
}

/// Where parts stand.
pub(crate) enum WorkFolder {
    /// A folder that goes with this run.
    Temporary(TemporaryFolder),
    /// A folder of the user, in which no other run works meanwhile. It goes too if it was made for this run and
    /// stays empty.
    Given { path: PathBuf, _lock: FolderLock, _made: MadeFolders },
}

impl WorkFolder {
    pub(crate) fn new(given: Option<&Path>) -> Result<Self, Failure> {
        let cure = |error: Error| error.with_cure("name another folder with --work");
        if let Some(path) = given {
            let (made, lock) =
                MadeFolders::with(path, |path| FolderLock::take(path, ".coface-work.lock")).map_err(cure)?;
            return Ok(Self::Given { path: path.to_path_buf(), _lock: lock, _made: made });
        }
        let folder = TemporaryFolder::create_in(&std::env::temp_dir(), "coface-parts-").map_err(cure)?;
        Ok(Self::Temporary(folder))
    }

    pub(crate) fn path(&self) -> &Path {
        match self {
            Self::Temporary(folder) => folder.path(),
            Self::Given { path, .. } => path,
        }
    }

    /// A file instead of the standard input, which workers do not see.
    pub(crate) fn standard_input(&self, input: &Path) -> Result<PathBuf, Failure> {
        if input.as_os_str() != "-" {
            return Ok(input.to_path_buf());
        }
        let path = self.path().join("standard input");
        let copied = coface::io::replace_file(&path, |out| {
            Ok(std::io::copy(&mut std::io::stdin().lock(), out).map(|_| ())?)
        });
        copied.map(|()| path).map_err(Failure::from)
    }
}
