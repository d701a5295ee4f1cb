//! One worker process, from the side of the pool.

use crate::workers::Limits;
use crate::workers::loss::Loss;
use coface_algebra::{Error, ErrorKind};
use std::collections::VecDeque;
use std::ffi::OsString;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// What a worker said to a request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// The line that it answered, without its end.
    pub line: String,
    /// The time from request to answer.
    pub time: Duration,
}

/// How a worker is started: a program that calls [`serve`](crate::workers::serve).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WorkerCommand {
    /// The program.
    pub program: PathBuf,
    /// Its arguments.
    pub arguments: Vec<OsString>,
    /// Variables of the environment beside those of this process.
    pub environment: Vec<(OsString, OsString)>,
}

impl WorkerCommand {
    /// This program with these arguments.
    ///
    /// # Examples
    /// ```
    /// let command = coface_scale::workers::WorkerCommand::new("sh", ["-c", "cat"]);
    /// assert_eq!(command.arguments.len(), 2);
    /// ```
    pub fn new<A: Into<OsString>>(
        program: impl Into<PathBuf>,
        arguments: impl IntoIterator<Item = A>,
    ) -> Self {
        let arguments = arguments.into_iter().map(Into::into).collect();
        Self { program: program.into(), arguments, environment: Vec::new() }
    }

    fn spawn(&self, limits: Limits) -> Result<Child, Error> {
        let mut command = Command::new(&self.program);
        if limits.memory.is_some() {
            // The allocator of GNU libc sets addresses aside for each thread, and addresses are what is limited.
            command.env("MALLOC_ARENA_MAX", "1");
        }
        command.args(&self.arguments).envs(self.environment.iter().cloned());
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        // Ctrl-C in a terminal is for who started the workers; they end with it.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        command.spawn().map_err(|error| {
            Error::new(
                ErrorKind::Io,
                format!("the worker process {} cannot be started: {error}", self.program.display()),
            )
        })
    }
}

/// So many workers may be ended from outside at one request, or one after the other before they are ready.
pub(crate) const ATTEMPTS: usize = 3;
/// How long a worker may take until it is ready.
const START: Duration = Duration::from_secs(120);
/// How long a worker may live after its output ended.
const GRACE: Duration = Duration::from_secs(2);
/// How often it is looked whether the pool has ended.
const TICK: Duration = Duration::from_millis(50);
/// So much of what a worker says on standard error is kept.
const SAID: usize = 1 << 14;

/// A process that takes requests. Dropping it ends the process and waits for its end, so that none stays.
pub(crate) struct WorkerProcess {
    child: Child,
    requests: ChildStdin,
    answers: Receiver<String>,
    said: Option<JoinHandle<String>>,
    limits: Limits,
    answered: usize,
}

/// What a worker made of a request.
pub(crate) enum Reply {
    Answer(Answer),
    Lost(Loss),
    /// The pool ended first.
    Ended,
}

/// Why no line came.
enum Silence {
    Time,
    Death,
    Ended,
}

impl WorkerProcess {
    /// Starts a worker, sends it its limits, and waits until it is ready; `None` if the pool ended first. One that is ended from outside before
    /// it is ready is started again, [`ATTEMPTS`] times in all.
    pub(crate) fn start(
        command: &WorkerCommand,
        limits: Limits,
        ended: &AtomicBool,
    ) -> Result<Option<Self>, Error> {
        let mut attempts = 1;
        loop {
            match Self::start_once(command, limits, ended)? {
                Ok(worker) => return Ok(worker),
                Err(Loss::Killed { .. }) if attempts < ATTEMPTS => attempts += 1,
                Err(loss) => {
                    let message = format!("a worker process cannot be started: it {loss}");
                    return Err(Error::new(ErrorKind::Io, message).with_cure(loss.cure()));
                }
            }
        }
    }

    /// The same once; what it was lost to if it ended.
    fn start_once(
        command: &WorkerCommand,
        limits: Limits,
        ended: &AtomicBool,
    ) -> Result<Result<Option<Self>, Loss>, Error> {
        let mut child = command.spawn(limits)?;
        let (Some(requests), Some(output), Some(faults)) =
            (child.stdin.take(), child.stdout.take(), child.stderr.take())
        else {
            return Err(Error::new(ErrorKind::Io, "a worker process has no pipes"));
        };
        let (send, answers) = channel();
        let mut worker = Self { child, requests, answers, said: None, limits, answered: 0 };
        spawn(move || forward(output, |line| send.send(line).is_ok()))?;
        worker.said = Some(spawn(move || last_words(faults))?);
        let memory = limits.memory.map_or_else(|| "none".to_owned(), |bytes| bytes.to_string());
        // A worker that has ended already is told from its silence.
        let _ = worker.requests.write_all(format!("memory {memory}\n").as_bytes());
        let fault = |message| Err(Error::new(ErrorKind::Io, message));
        match worker.line(Some(START), ended) {
            Ok(line) if line == READY => Ok(Ok(Some(worker))),
            Ok(line) => fault(format!("a worker process cannot be started: {line}")),
            Err(Silence::Ended) => Ok(Ok(None)),
            Err(Silence::Time) => fault("a worker process does not become ready".to_owned()),
            Err(Silence::Death) => Ok(Err(worker.loss())),
        }
    }

    /// Whether it has not answered anything yet: what it loses, every worker loses.
    pub(crate) fn is_fresh(&self) -> bool {
        self.answered == 0
    }

    /// Hands it a request and waits for the answer. After anything but an answer it is of no use.
    pub(crate) fn ask(&mut self, request: &str, ended: &AtomicBool) -> Reply {
        let begin = Instant::now();
        // A worker that has ended already is told from its silence.
        let _ = self.requests.write_all(format!("{request}\n").as_bytes());
        match self.line(self.limits.time, ended) {
            Ok(line) => {
                self.answered += 1;
                Reply::Answer(Answer { line, time: begin.elapsed() })
            }
            Err(Silence::Ended) => Reply::Ended,
            Err(Silence::Time) => Reply::Lost(Loss::Time { limit: self.limits.time.unwrap_or_default() }),
            Err(Silence::Death) => Reply::Lost(self.loss()),
        }
    }

    /// The next line of its output.
    fn line(&self, time: Option<Duration>, ended: &AtomicBool) -> Result<String, Silence> {
        let begin = Instant::now();
        loop {
            let left = time.map_or(TICK, |time| time.saturating_sub(begin.elapsed()).min(TICK));
            match self.answers.recv_timeout(left) {
                Ok(line) => return Ok(line),
                Err(RecvTimeoutError::Disconnected) => return Err(Silence::Death),
                Err(RecvTimeoutError::Timeout) if ended.load(Ordering::Relaxed) => {
                    return Err(Silence::Ended);
                }
                Err(RecvTimeoutError::Timeout) if time.is_some_and(|time| begin.elapsed() >= time) => {
                    return Err(Silence::Time);
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }

    /// How it ended, after its output did.
    fn loss(&mut self) -> Loss {
        let status = match self.end_of(GRACE) {
            Some(status) => status,
            None => return Loss::Crash { how: "it closed its output".to_owned() },
        };
        let said = self.said.take().and_then(|said| said.join().ok()).unwrap_or_default();
        Loss::of_death(status, &said, self.limits.memory)
    }

    /// Its exit status, if it ends within this time.
    fn end_of(&mut self, time: Duration) -> Option<ExitStatus> {
        let begin = Instant::now();
        loop {
            match self.child.try_wait() {
                Ok(Some(status)) => return Some(status),
                Ok(None) if begin.elapsed() < time => thread::sleep(Duration::from_millis(1)),
                _ => return None,
            }
        }
    }
}

impl Drop for WorkerProcess {
    fn drop(&mut self) {
        // An error says that it has ended already; waiting leaves no zombie.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The first line of a worker.
pub(crate) const READY: &str = "ready";

fn spawn<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> Result<JoinHandle<T>, Error> {
    let builder = thread::Builder::new().name("coface-worker".to_owned());
    builder
        .spawn(work)
        .map_err(|error| Error::new(ErrorKind::Io, format!("no thread can be started: {error}")))
}

/// Passes on whole lines until the output ends or the receiver is dropped; what is behind the last line end is no line.
fn forward(output: ChildStdout, mut take: impl FnMut(String) -> bool) {
    let mut output = BufReader::new(output);
    let mut line = Vec::new();
    while output.read_until(b'\n', &mut line).is_ok() && line.pop() == Some(b'\n') {
        if !take(String::from_utf8_lossy(&line).into_owned()) {
            break;
        }
        line.clear();
    }
}

/// Reads to the end and keeps the last of it.
fn last_words(mut faults: ChildStderr) -> String {
    let mut kept = VecDeque::new();
    let mut block = [0; 1 << 12];
    while let Ok(count @ 1..) = faults.read(&mut block) {
        kept.extend(&block[..count]);
        let excess = kept.len().saturating_sub(SAID);
        drop(kept.drain(..excess));
    }
    String::from_utf8_lossy(kept.make_contiguous()).into_owned()
}
