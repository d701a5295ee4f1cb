//! Progress and cancellation of long computations.
//!
//! # Words
//! * A [`Watch`] observes one computation. The caller makes it and [runs](Watch::run) the computation under it.
//! * A computation has **stages**, such as "reading spot.obj" or "matching cells"; stages may contain stages. A
//!   [`Stage`] is a snapshot of one: its name, and how many of its steps are done.
//! * [`Steps`] is the side of the computation: [`stage`] begins a stage, and [`Steps::advance`] counts its steps.
//!
//! # Conventions
//! * Any thread may read the progress at any time by [`Watch::stage`], and may cancel the computation by
//!   [`Watch::stop`]. The computation then unwinds at its next step, and [`Watch::run`] returns [`Stopped`].
//! * A computation that is not observed pays one branch for each step.
//!
//! # Examples
//! A thread that shows the progress, while the computation runs in this one:
//! ```
//! use coface_algebra::progress::{Watch, stage};
//! use std::sync::Arc;
//! let watch = Arc::new(Watch::new());
//! let observer = std::thread::spawn({
//!     let watch = Arc::clone(&watch);
//!     move || watch.stage().map(|stage| format!("{}: {} steps are done", stage.name(), stage.done()))
//! });
//! let sum = watch.run(|| {
//!     let steps = stage("adding numbers", 100);
//!     steps.each(1..=100_u32).sum::<u32>()
//! });
//! assert_eq!(sum, Ok(5050));
//! observer.join().expect("the observer does not panic");
//! ```

use std::cell::RefCell;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

thread_local! {
    /// The observer of the computation of this thread.
    static WATCH: RefCell<Option<Arc<Watch>>> = const { RefCell::new(None) };
}

/// Observes a computation: reads its progress, and cancels it.
///
/// The thread that calls [`run`](Self::run) begins the stages; any number of threads may count the steps of a stage.
///
/// # Examples
/// ```
/// use coface_algebra::progress::Watch;
/// use std::sync::Arc;
/// let watch = Arc::new(Watch::new());
/// let sum: u64 = watch.run(|| (1..=4).sum()).expect("nothing stops the work");
/// assert_eq!(sum, 10);
/// assert_eq!(watch.stage(), None);
/// ```
#[derive(Debug, Default)]
pub struct Watch {
    stages: Mutex<Vec<Arc<Counted>>>,
    is_stopped: AtomicBool,
}

impl Watch {
    /// An observer without a computation.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::progress::Watch;
    /// assert_eq!(Watch::new().stage(), None);
    /// ```
    pub const fn new() -> Self {
        Self { stages: Mutex::new(Vec::new()), is_stopped: AtomicBool::new(false) }
    }

    /// Runs a computation in this thread and records its progress.
    ///
    /// # Errors
    /// [`Stopped`] if the computation was [stopped](Self::stop) before its end. Values that it was changing in place
    /// are then in an unspecified state; discard them.
    ///
    /// # Panics
    /// If the computation panics.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::progress::{Stopped, Watch, stage};
    /// use std::sync::Arc;
    /// let watch = Arc::new(Watch::new());
    /// assert_eq!(watch.run(|| 6 * 7), Ok(42));
    /// watch.stop();
    /// assert_eq!(watch.run(|| stage("adding", 3).advance(1)), Err(Stopped));
    /// ```
    pub fn run<T>(self: &Arc<Self>, work: impl FnOnce() -> T) -> Result<T, Stopped> {
        let before = WATCH.replace(Some(Arc::clone(self)));
        let outcome = catch_unwind(AssertUnwindSafe(work));
        WATCH.set(before);
        outcome.or_else(|payload| if payload.is::<Stopped>() { Err(Stopped) } else { resume_unwind(payload) })
    }

    /// Cancels the computation, which ends at its next step. A watch that was stopped stays stopped.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::progress::{Stopped, Watch, stage};
    /// use std::sync::Arc;
    /// let watch = Arc::new(Watch::new());
    /// let outcome = watch.run(|| {
    ///     let steps = stage("counting without end", 0);
    ///     for step in 0.. {
    ///         if step == 10 {
    ///             watch.stop();
    ///         }
    ///         steps.advance(1);
    ///     }
    /// });
    /// assert_eq!(outcome, Err(Stopped));
    /// ```
    pub fn stop(&self) {
        self.is_stopped.store(true, Ordering::Relaxed);
    }

    /// The innermost stage that is running; `None` before the first stage, between two, and after the last.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::progress::{Unit, Watch, stage_of_bytes};
    /// use std::sync::Arc;
    /// let watch = Arc::new(Watch::new());
    /// let seen = watch.run(|| {
    ///     let steps = stage_of_bytes("reading spot.obj", 200);
    ///     steps.advance(50);
    ///     watch.stage().map(|stage| (stage.unit(), stage.done(), stage.total()))
    /// });
    /// assert_eq!(seen, Ok(Some((Unit::Bytes, 50, Some(200)))));
    /// ```
    pub fn stage(&self) -> Option<Stage> {
        let stages = self.stages();
        let counted = stages.last()?;
        Some(Stage {
            name: counted.name.clone(),
            unit: counted.unit,
            done: counted.done.load(Ordering::Relaxed),
            total: Some(counted.total).filter(|&total| total > 0),
        })
    }

    fn stages(&self) -> MutexGuard<'_, Vec<Arc<Counted>>> {
        // A list of stages is whole after each change.
        self.stages.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The computation was cancelled by [`Watch::stop`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stopped;

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the computation was stopped")
    }
}

impl std::error::Error for Stopped {}

/// A snapshot of one part of a computation: its name and its progress.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stage {
    name: String,
    unit: Unit,
    done: u64,
    total: Option<u64>,
}

impl Stage {
    /// The name of the stage, such as "reading spot.obj" or "matching cells".
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::progress::{Watch, stage};
    /// use std::sync::Arc;
    /// let watch = Arc::new(Watch::new());
    /// let name = watch.run(|| {
    ///     let _steps = stage("matching cells", 100);
    ///     watch.stage().map(|stage| stage.name().to_owned())
    /// });
    /// assert_eq!(name, Ok(Some("matching cells".to_owned())));
    /// ```
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The unit of [`Self::done`] and [`Self::total`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::progress::{Unit, Watch, stage_of_bytes};
    /// use std::sync::Arc;
    /// let watch = Arc::new(Watch::new());
    /// let unit = watch.run(|| {
    ///     let _steps = stage_of_bytes("reading", 100);
    ///     watch.stage().map(|stage| stage.unit())
    /// });
    /// assert_eq!(unit, Ok(Some(Unit::Bytes)));
    /// ```
    pub fn unit(&self) -> Unit {
        self.unit
    }

    /// The number of steps that are done.
    ///
    /// # Examples
    /// See [`stage`].
    pub fn done(&self) -> u64 {
        self.done
    }

    /// The number of all steps; `None` if it is unknown.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::progress::{Watch, stage};
    /// use std::sync::Arc;
    /// let watch = Arc::new(Watch::new());
    /// let total = |count: usize| {
    ///     let _steps = stage("matching cells", count);
    ///     watch.stage().and_then(|stage| stage.total())
    /// };
    /// assert_eq!(watch.run(|| [total(100), total(0)]), Ok([Some(100), None]));
    /// ```
    pub fn total(&self) -> Option<u64> {
        self.total
    }
}

/// The unit in which a [`Stage`] counts its steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Items: cells, columns, pairs, or whatever the stage iterates over.
    Items,
    /// Bytes of a file.
    Bytes,
}

#[derive(Debug)]
struct Counted {
    name: String,
    unit: Unit,
    done: AtomicU64,
    total: u64,
}

/// A running stage, for the computation to count its steps. The stage begins with [`stage`] and ends when this is
/// dropped.
#[derive(Debug)]
pub struct Steps(Option<(Arc<Watch>, Arc<Counted>)>);

/// Begins a stage of `total` items; 0 if their number is unknown.
///
/// Only the thread that called [`Watch::run`] records a stage; in other threads this has no effect.
///
/// # Examples
/// ```
/// use coface_algebra::progress::{Watch, stage};
/// use std::sync::Arc;
/// let watch = Arc::new(Watch::new());
/// let done = watch.run(|| {
///     let steps = stage("counting files", 3);
///     steps.advance(2);
///     watch.stage().map(|stage| stage.done())
/// });
/// assert_eq!(done, Ok(Some(2)));
/// ```
pub fn stage(name: &str, total: usize) -> Steps {
    begin(name, Unit::Items, total as u64)
}

/// Begins a stage of `total` items unless they are too few to be noticed: for functions that are called often, and
/// mostly with few items.
///
/// # Examples
/// ```
/// use coface_algebra::progress::{Watch, stage_of_many};
/// use std::sync::Arc;
/// let watch = Arc::new(Watch::new());
/// let shown = |total: usize| {
///     let _steps = stage_of_many("sorting", total);
///     watch.stage().is_some()
/// };
/// assert_eq!(watch.run(|| [shown(10), shown(1_000_000)]), Ok([false, true]));
/// ```
pub fn stage_of_many(name: &str, total: usize) -> Steps {
    if total < 16 * BATCH { Steps(None) } else { stage(name, total) }
}

/// Begins a stage of `total` bytes.
///
/// # Examples
/// ```
/// use coface_algebra::progress::{Watch, stage_of_bytes};
/// use std::sync::Arc;
/// let watch = Arc::new(Watch::new());
/// let total = watch.run(|| {
///     let _steps = stage_of_bytes("reading", 4096);
///     watch.stage().and_then(|stage| stage.total())
/// });
/// assert_eq!(total, Ok(Some(4096)));
/// ```
pub fn stage_of_bytes(name: &str, total: u64) -> Steps {
    begin(name, Unit::Bytes, total)
}

fn begin(name: &str, unit: Unit, total: u64) -> Steps {
    let Some(watch) = WATCH.with_borrow(Clone::clone) else { return Steps(None) };
    let counted = Arc::new(Counted { name: name.to_owned(), unit, done: AtomicU64::new(0), total });
    watch.stages().push(Arc::clone(&counted));
    let steps = Steps(Some((watch, counted)));
    // A stage counts as a step of the stage around it: a computation of many short stages can be stopped between them.
    steps.advance(0);
    steps
}

impl Steps {
    /// Counts `count` further steps as done. If the computation was stopped, this unwinds to [`Watch::run`].
    ///
    /// A call costs an atomic addition: a loop of a few nanoseconds a step calls it once for many steps.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::progress::{Watch, stage};
    /// use std::sync::Arc;
    /// let watch = Arc::new(Watch::new());
    /// let done = watch.run(|| {
    ///     let steps = stage("counting", 10);
    ///     steps.advance(4);
    ///     steps.advance(3);
    ///     watch.stage().map(|stage| stage.done())
    /// });
    /// assert_eq!(done, Ok(Some(7)));
    /// ```
    #[inline]
    pub fn advance(&self, count: usize) {
        if let Some((watch, counted)) = &self.0 {
            counted.done.fetch_add(count as u64, Ordering::Relaxed);
            // Steps that are counted while the computation unwinds, as when buffers are flushed, do not unwind again.
            if watch.is_stopped.load(Ordering::Relaxed) && !std::thread::panicking() {
                // A stop is no fault: the panic hook is not called.
                resume_unwind(Box::new(Stopped));
            }
        }
    }
}

impl Steps {
    /// Iterates over items and counts each as a step, in batches of some thousand.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::progress::stage;
    /// let steps = stage("squaring", 3);
    /// assert!(steps.each([1, 2, 3]).map(|x| x * x).eq([1, 4, 9]));
    /// ```
    pub fn each<I: IntoIterator>(&self, items: I) -> Each<'_, I::IntoIter> {
        Each { items: items.into_iter(), steps: self, uncounted: 0 }
    }

    /// Counts the item at this place as a step, in batches: the first item of a batch counts the batch before it. For
    /// loops whose items are processed by many threads, or in any order.
    #[inline]
    #[doc(hidden)]
    pub fn pass(&self, place: usize) {
        if place.is_multiple_of(BATCH) && place > 0 {
            self.advance(BATCH);
        }
    }
}

/// The number of items that are counted at once where each takes nanoseconds.
const BATCH: usize = 1 << 12;

/// The iterator of [`Steps::each`].
#[derive(Debug)]
pub struct Each<'a, I> {
    items: I,
    steps: &'a Steps,
    uncounted: usize,
}

impl<I: Iterator> Iterator for Each<'_, I> {
    type Item = I::Item;

    #[inline]
    fn next(&mut self) -> Option<I::Item> {
        // The next item is not done yet; those before it are.
        if self.uncounted == BATCH {
            self.steps.advance(BATCH);
            self.uncounted = 0;
        }
        let item = self.items.next();
        if item.is_some() {
            self.uncounted += 1;
        } else {
            self.steps.advance(self.uncounted);
            self.uncounted = 0;
        }
        item
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.items.size_hint()
    }
}

impl Drop for Steps {
    fn drop(&mut self) {
        if let Some((watch, counted)) = &self.0 {
            watch.stages().retain(|other| !Arc::ptr_eq(other, counted));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Stage, Stopped, Unit, Watch, stage, stage_of_bytes};
    use rayon::prelude::*;
    use std::sync::Arc;
    use std::sync::atomic::Ordering;

    #[test]
    fn stages_nest_and_end() {
        let watch = Arc::new(Watch::new());
        let seen = watch.run(|| {
            let outer = stage_of_bytes("outer", 10);
            outer.advance(4);
            let before = watch.stage();
            let inner = stage("inner", 3);
            inner.advance(1);
            let within = watch.stage();
            drop(inner);
            (before, within, watch.stage())
        });
        let outer = Stage { name: "outer".into(), unit: Unit::Bytes, done: 4, total: Some(10) };
        let inner = Stage { name: "inner".into(), unit: Unit::Items, done: 1, total: Some(3) };
        assert_eq!(seen, Ok((Some(outer.clone()), Some(inner), Some(outer))));
        assert_eq!(watch.stage(), None);
    }

    #[test]
    fn computations_without_an_observer_run() {
        let steps = stage("alone", 1);
        steps.advance(1);
        assert!(steps.0.is_none());
    }

    #[test]
    fn steps_of_all_threads_count_and_all_stop() {
        let watch = Arc::new(Watch::new());
        let counted = watch.run(|| {
            let steps = stage("many", 1000);
            (0..1000).into_par_iter().for_each(|_| steps.advance(1));
            watch.stage().map(|stage| stage.done)
        });
        assert_eq!(counted, Ok(Some(1000)));
        let stopped = watch.run(|| {
            let steps = stage("many", 1 << 16);
            (0..1 << 16).into_par_iter().for_each(|i| {
                if i == 1000 {
                    watch.stop();
                }
                steps.advance(1);
            });
        });
        assert_eq!(stopped, Err(Stopped));
        assert_eq!(watch.stage(), None);
        assert_eq!(watch.run(|| drop(stage("more", 0))), Err(Stopped));
    }

    #[test]
    fn items_are_counted_a_batch_at_a_time() {
        let watch = Arc::new(Watch::new());
        let done = |steps: &super::Steps| {
            steps.0.as_ref().map_or(0, |(_, counted)| counted.done.load(Ordering::Relaxed))
        };
        let counted = watch.run(|| {
            let (serial, parallel) = (stage("serial", 10_000), stage("parallel", 10_000));
            for place in serial.each(0..10_000_usize) {
                assert!(done(&serial) <= place as u64);
            }
            (0..10_000).into_par_iter().for_each(|place| parallel.pass(place));
            (done(&serial), done(&parallel))
        });
        assert_eq!(counted, Ok((10_000, 8192)));
    }

    #[test]
    fn another_thread_stops_endless_work() {
        let watch = Arc::new(Watch::new());
        let stopped = std::thread::scope(|scope| {
            scope.spawn(|| {
                while watch.stage().is_none_or(|stage| stage.done < 1000) {
                    std::thread::yield_now();
                }
                watch.stop();
            });
            watch.run(|| {
                let steps = stage("endless", 0);
                loop {
                    steps.advance(1);
                }
            })
        });
        assert_eq!(stopped.map(|(): ()| ()), Err(Stopped));
    }

    #[test]
    fn faults_of_the_work_stay_faults() {
        let watch = Arc::new(Watch::new());
        let outcome = std::panic::catch_unwind(|| watch.run(|| std::panic::resume_unwind(Box::new("fault"))));
        let payload = outcome.map(|_: Result<(), _>| ()).expect_err("a fault");
        assert_eq!(payload.downcast_ref(), Some(&"fault"));
        let alone = std::panic::catch_unwind(|| stage("after", 1).0.is_none());
        assert!(alone.unwrap_or(false), "the watch of the thread is what it was before");
    }
}
