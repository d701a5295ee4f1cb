//! What long work tells whoever waits for it, and how it is asked to end.
//!
//! A [`Watch`] belongs to who waits. The work that it [runs](Watch::run) says which [`Stage`] it has come to and how many steps of it are
//! done; another thread may look at any time, and may [stop](Watch::stop) the work, which then unwinds at its next step. Work that nobody
//! watches pays a branch a step.

use std::cell::RefCell;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

thread_local! {
    /// Who waits for the work of this thread.
    static WATCH: RefCell<Option<Arc<Watch>>> = const { RefCell::new(None) };
}

/// Looks on long work from outside.
///
/// Stages are told by the thread that called [`run`](Self::run); steps of a stage may be done by any number of threads.
///
/// # Examples
/// ```
/// use coface_algebra::progress::Watch;
/// use coface_complexes::simplicial::SimplicialComplex;
/// use std::sync::Arc;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let watch = Arc::new(Watch::new());
/// let edges = watch.run(|| SimplicialComplex::from_facets(&[[0, 1, 2]]).map(|complex| complex.f_vector()[1]));
/// assert_eq!(edges.expect("nobody stopped it")?, 3);
/// assert_eq!(watch.stage(), None);
/// # Ok(()) }
/// ```
#[derive(Debug, Default)]
pub struct Watch {
    stages: Mutex<Vec<Arc<Counted>>>,
    is_stopped: AtomicBool,
}

impl Watch {
    /// Nothing is being done yet.
    pub const fn new() -> Self {
        Self { stages: Mutex::new(Vec::new()), is_stopped: AtomicBool::new(false) }
    }

    /// Does the work, in this thread, and tells here how far it is.
    ///
    /// # Errors
    /// [`Stopped`] when the work was asked to [stop](Self::stop) and did before it was done. Whatever it was changing in place then is not
    /// to be used any more.
    ///
    /// # Panics
    /// Where the work does.
    pub fn run<T>(self: &Arc<Self>, work: impl FnOnce() -> T) -> Result<T, Stopped> {
        let before = WATCH.replace(Some(Arc::clone(self)));
        let outcome = catch_unwind(AssertUnwindSafe(work));
        WATCH.set(before);
        outcome.or_else(|payload| if payload.is::<Stopped>() { Err(Stopped) } else { resume_unwind(payload) })
    }

    /// Asks the work to end. It does at its next step; what was asked once is never taken back.
    pub fn stop(&self) {
        self.is_stopped.store(true, Ordering::Relaxed);
    }

    /// What is being done now, the innermost stage that has begun; `None` before the first and between two.
    pub fn stage(&self) -> Option<Stage> {
        let stages = self.stages();
        let counted = stages.last()?;
        Some(Stage {
            name: counted.name.clone(),
            unit: counted.unit,
            done: counted.done.load(Ordering::Relaxed),
            total: counted.total,
        })
    }

    fn stages(&self) -> MutexGuard<'_, Vec<Arc<Counted>>> {
        // A list of stages is whole after each change.
        self.stages.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The work was asked to end and did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stopped;

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the work was stopped")
    }
}

impl std::error::Error for Stopped {}

/// A part of long work, and how much of it is done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stage {
    /// What is being done: "reading spot.obj", "matching cells".
    pub name: String,
    /// What the steps are.
    pub unit: Unit,
    /// The steps that are done.
    pub done: u64,
    /// All steps; 0 where nobody can know.
    pub total: u64,
}

/// What the steps of a [`Stage`] are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Cells, columns, pairs: whatever the stage goes through.
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

/// A stage that has begun and ends when this is dropped. [`stage`] begins one.
#[derive(Debug)]
pub struct Steps(Option<(Arc<Watch>, Arc<Counted>)>);

/// Begins a stage of so many items, 0 where that is not known. Only the thread that somebody watches can begin one: elsewhere nothing is
/// told.
///
/// # Examples
/// ```
/// use coface_algebra::progress::{Watch, stage};
/// use std::sync::Arc;
/// let watch = Arc::new(Watch::new());
/// let done = watch.run(|| {
///     let steps = stage("counting files", 3);
///     steps.advance(2);
///     watch.stage().map(|stage| stage.done)
/// });
/// assert_eq!(done, Ok(Some(2)));
/// ```
pub fn stage(name: &str, total: usize) -> Steps {
    begin(name, Unit::Items, total as u64)
}

/// Begins a stage unless there are so few items that nobody would see it: for what is done often, and mostly to little.
pub fn stage_of_many(name: &str, total: usize) -> Steps {
    if total < 16 * BATCH { Steps(None) } else { stage(name, total) }
}

/// Begins a stage of so many bytes.
pub fn stage_of_bytes(name: &str, total: u64) -> Steps {
    begin(name, Unit::Bytes, total)
}

fn begin(name: &str, unit: Unit, total: u64) -> Steps {
    let Some(watch) = WATCH.with_borrow(Clone::clone) else { return Steps(None) };
    let counted = Arc::new(Counted { name: name.to_owned(), unit, done: AtomicU64::new(0), total });
    watch.stages().push(Arc::clone(&counted));
    let steps = Steps(Some((watch, counted)));
    // A stage is a step of what is around it: work of many short stages ends when it is asked to.
    steps.advance(0);
    steps
}

impl Steps {
    /// So many further steps are done. Unwinds when somebody asked the work to stop.
    ///
    /// It costs an atomic addition: loops of a few nanoseconds a step call it once for many.
    #[inline]
    pub fn advance(&self, count: usize) {
        if let Some((watch, counted)) = &self.0 {
            counted.done.fetch_add(count as u64, Ordering::Relaxed);
            // What is told while the work unwinds, as when buffers are written out, is told to nobody.
            if watch.is_stopped.load(Ordering::Relaxed) && !std::thread::panicking() {
                // No fault, so the hook that reports panics hears nothing of it.
                resume_unwind(Box::new(Stopped));
            }
        }
    }
}

impl Steps {
    /// Goes through items; each is a step, told a batch at a time.
    #[doc(hidden)]
    pub fn each<I: IntoIterator>(&self, items: I) -> Each<'_, I::IntoIter> {
        Each { items: items.into_iter(), steps: self, untold: 0 }
    }

    /// The item of this place among all of the stage is being done: each is a step, told a batch at a time by the first of the next batch.
    /// For loops whose items are done by many threads, or in any order.
    #[inline]
    #[doc(hidden)]
    pub fn pass(&self, place: usize) {
        if place.is_multiple_of(BATCH) && place > 0 {
            self.advance(BATCH);
        }
    }
}

/// So many items are told at once where each takes nanoseconds.
const BATCH: usize = 1 << 12;

/// Items that are counted as they go by.
#[derive(Debug)]
pub struct Each<'a, I> {
    items: I,
    steps: &'a Steps,
    untold: usize,
}

impl<I: Iterator> Iterator for Each<'_, I> {
    type Item = I::Item;

    #[inline]
    fn next(&mut self) -> Option<I::Item> {
        // What is taken next is not done yet, what was taken before is.
        if self.untold == BATCH {
            self.steps.advance(BATCH);
            self.untold = 0;
        }
        let item = self.items.next();
        if item.is_some() {
            self.untold += 1;
        } else {
            self.steps.advance(self.untold);
            self.untold = 0;
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
        let outer = Stage { name: "outer".into(), unit: Unit::Bytes, done: 4, total: 10 };
        let inner = Stage { name: "inner".into(), unit: Unit::Items, done: 1, total: 3 };
        assert_eq!(seen, Ok((Some(outer.clone()), Some(inner), Some(outer))));
        assert_eq!(watch.stage(), None);
    }

    #[test]
    fn unwatched_work_goes_on() {
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
