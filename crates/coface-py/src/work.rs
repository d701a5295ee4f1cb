//! Long work: without the interpreter's lock, with progress, and stopped by Ctrl-C.

use crate::errors::raised;
use coface::Error;
use coface::algebra::progress::Watch;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::PyBool;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::panic::resume_unwind;
use std::process;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread;
use std::time::Duration;

/// How long the waiting thread sleeps before it looks for signals and shows progress.
const PERIOD: Duration = Duration::from_millis(20);

/// What threads that work have for their stacks: recursion on deep trees needs more than threads have by themselves.
const STACK: usize = 64 << 20;

/// The process that loaded the module.
static HOME: OnceLock<u32> = OnceLock::new();

/// The threads of a process that was forked: those of its parent are not in it.
static FORKED: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Remembers which process loaded the module.
pub(crate) fn remember_process() {
    HOME.get_or_init(process::id);
}

/// The threads for parallel work where the usual ones are not there.
fn threads_after_fork() -> Option<Arc<ThreadPool>> {
    let id = process::id();
    if HOME.get().is_none_or(|&home| home == id) {
        return None;
    }
    let mut forked = FORKED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, pool)) = forked.as_ref().filter(|(owner, _)| *owner == id) {
        return Some(Arc::clone(pool));
    }
    let pool = Arc::new(ThreadPoolBuilder::new().stack_size(STACK).build().ok()?);
    // The threads of the parent's are not here to be waited for.
    std::mem::forget(forked.replace((id, Arc::clone(&pool))));
    Some(pool)
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

/// Does long work in a thread of its own, without the lock of the interpreter. Meanwhile signals are looked for: Ctrl-C stops the work at its
/// next step. `progress` is `True` for a bar, or a function that is called with the stage, what is done of it and all of it.
pub(crate) fn run<'py, T: Send>(
    py: Python<'py>,
    progress: Option<&Bound<'py, PyAny>>,
    work: impl FnOnce() -> Result<T, Error> + Send,
) -> PyResult<T> {
    let listener = Listener::of(py, progress)?;
    let watch = Arc::new(Watch::new());
    let outcome = thread::scope(|scope| -> PyResult<_> {
        let (ended, end) = channel::<()>();
        let worker = {
            let watch = &watch;
            let work = move || {
                let _ended = ended;
                match threads_after_fork() {
                    Some(pool) => pool.install(|| watch.run(work)),
                    None => watch.run(work),
                }
            };
            let worker = thread::Builder::new().name("coface".into()).stack_size(STACK);
            worker.spawn_scoped(scope, work).map_err(PyErr::from)?
        };
        let mut fault = None;
        // Only this thread waits; the lock is for the compiler.
        let end = Mutex::new(end);
        let wait = || end.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(PERIOD);
        while py.detach(wait) == Err(RecvTimeoutError::Timeout) {
            let seen = py.check_signals().and_then(|()| listener.tell(&watch));
            if let Err(error) = seen {
                watch.stop();
                fault = Some(error);
                break;
            }
        }
        let outcome = py.detach(|| worker.join()).unwrap_or_else(|payload| resume_unwind(payload));
        fault.map_or(Ok(outcome), Err)
    });
    listener.close()?;
    match outcome? {
        Ok(Ok(value)) => Ok(value),
        Ok(Err(error)) => Err(raised(py, &error)),
        Err(stopped) => Err(PyRuntimeError::new_err(stopped.to_string())),
    }
}
