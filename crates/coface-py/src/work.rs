//! Long work: without the interpreter's lock, with progress, and stopped by Ctrl-C.

use crate::errors::raised;
use coface::Error;
use coface::algebra::progress::Watch;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::PyBool;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::panic::resume_unwind;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread;
use std::time::Duration;

/// How long the waiting thread sleeps before it looks for signals and shows progress.
const PERIOD: Duration = Duration::from_millis(20);

/// What threads that work have for their stacks: recursion on deep trees needs more than threads have by themselves.
const STACK: usize = 64 << 20;

/// The process that loaded the module.
static HOME: OnceLock<u32> = OnceLock::new();

/// The threads of this process: those of a parent are not in a process that was forked.
static TEAM: Mutex<Option<Arc<Team>>> = Mutex::new(None);

/// Threads that stay for the next call, so that a small one starts none. One call at a time has them: where two shared them, a thread that
/// waits for parts of one could begin the other.
struct Team {
    process: u32,
    threads: ThreadPool,
    is_busy: AtomicBool,
}

impl Team {
    /// The threads of this process, `None` where they cannot be started.
    fn of_process() -> Option<Arc<Self>> {
        let process = process::id();
        let mut known = TEAM.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(team) = known.as_ref().filter(|team| team.process == process) {
            return Some(Arc::clone(team));
        }
        let team = Arc::new(Self { process, threads: threads().ok()?, is_busy: AtomicBool::new(false) });
        // The threads of the parent are not here to be waited for.
        std::mem::forget(known.replace(Arc::clone(&team)));
        Some(team)
    }

    /// Has all threads until it is dropped, unless another call has them.
    fn turn(&self) -> Option<Turn<'_>> {
        (!self.is_busy.swap(true, Ordering::Acquire)).then_some(Turn(self))
    }

    fn is_forked(&self) -> bool {
        HOME.get().is_some_and(|&home| home != self.process)
    }
}

struct Turn<'a>(&'a Team);

impl Drop for Turn<'_> {
    fn drop(&mut self) {
        self.0.is_busy.store(false, Ordering::Release);
    }
}

fn threads() -> Result<ThreadPool, ThreadPoolBuildError> {
    ThreadPoolBuilder::new().stack_size(STACK).thread_name(|number| format!("coface {number}")).build()
}

/// Remembers which process loaded the module.
pub(crate) fn remember_process() {
    HOME.get_or_init(process::id);
}

/// Who receives progress.
enum Listener<'py> {
    Nobody,
    Callable(Bound<'py, PyAny>),
    /// A bar, which is closed at the end.
    Bar(Bound<'py, PyAny>),
}

impl<'py> Listener<'py> {
    fn of(py: Python<'py>, progress: Option<&Bound<'py, PyAny>>) -> PyResult<Self> {
        let Some(progress) = progress.filter(|progress| !progress.is_none()) else { return Ok(Self::Nobody) };
        if progress.is_instance_of::<PyBool>() {
            if !progress.is_truthy()? {
                return Ok(Self::Nobody);
            }
            return Ok(Self::Bar(py.import("coface._progress")?.getattr("Bar")?.call0()?));
        }
        if !progress.is_callable() {
            return Err(crate::errors::invalid(
                py,
                format!("progress is {progress}"),
                "give True, False or a function of (stage, done, total)",
            ));
        }
        Ok(Self::Callable(progress.clone()))
    }

    fn tell(&self, watch: &Watch) -> PyResult<()> {
        if let (Self::Callable(function) | Self::Bar(function), Some(stage)) = (self, watch.stage()) {
            function.call1((stage.name(), stage.done(), stage.total().unwrap_or(0)))?;
        }
        Ok(())
    }

    fn close(&self) -> PyResult<()> {
        if let Self::Bar(bar) = self {
            bar.call_method0("close")?;
        }
        Ok(())
    }
}

/// Waits for the end of work, looks for signals and shows progress meanwhile. The first fault of these stops the work; it has ended when
/// this returns.
fn watched(py: Python<'_>, listener: &Listener<'_>, watch: &Watch, end: Receiver<()>) -> PyResult<()> {
    // Only this thread waits; the lock is for the compiler.
    let end = Mutex::new(end);
    let wait = || end.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(PERIOD);
    let mut outcome = Ok(());
    while py.detach(wait) == Err(RecvTimeoutError::Timeout) {
        if outcome.is_ok() {
            outcome = py.check_signals().and_then(|()| listener.tell(watch));
            if outcome.is_err() {
                watch.stop();
            }
        }
    }
    outcome
}

/// Does long work in another thread, without the lock of the interpreter. Meanwhile signals are looked for: Ctrl-C stops the work at its
/// next step. `progress` is `True` for a bar, or a function that is called with the stage, what is done of it and all of it.
pub(crate) fn run<'py, T: Send>(
    py: Python<'py>,
    progress: Option<&Bound<'py, PyAny>>,
    work: impl FnOnce() -> Result<T, Error> + Send,
) -> PyResult<T> {
    let listener = Listener::of(py, progress)?;
    let watch = Arc::new(Watch::new());
    let (ending, end) = channel::<()>();
    let team = Team::of_process();
    let mut outcome = None;
    let seen = if let Some((team, _turn)) = team.as_deref().and_then(|team| Some((team, team.turn()?))) {
        team.threads.in_place_scope(|scope| {
            scope.spawn(|_| {
                // Dropped last.
                let _ending = ending;
                outcome = Some(watch.run(work));
            });
            watched(py, &listener, &watch, end)
        })
    } else {
        thread::scope(|scope| {
            let own = || {
                let _ending = ending;
                // The usual threads are not there after a fork, and those of the team may wait for this very call.
                let threads = team.as_deref().filter(|team| team.is_forked()).and_then(|_| threads().ok());
                outcome = Some(match threads {
                    Some(threads) => threads.install(|| watch.run(work)),
                    None => watch.run(work),
                });
            };
            let worker = thread::Builder::new().name("coface".into()).stack_size(STACK);
            let worker = worker.spawn_scoped(scope, own).map_err(PyErr::from)?;
            let seen = watched(py, &listener, &watch, end);
            py.detach(|| worker.join()).unwrap_or_else(|payload| resume_unwind(payload));
            seen
        })
    };
    listener.close()?;
    seen?;
    match outcome {
        Some(Ok(Ok(value))) => Ok(value),
        Some(Ok(Err(error))) => Err(raised(py, &error)),
        Some(Err(stopped)) => Err(PyRuntimeError::new_err(stopped.to_string())),
        None => Err(PyRuntimeError::new_err("the work ended without an answer")),
    }
}
