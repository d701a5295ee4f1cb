//! Limits of memory and time, which every verb keeps.
//!
//! Where a limit is reached, or the system has no more memory, the program says so and ends with status 1; temporary files go with it.

use crate::failure::Failure;
use crate::progress;
use crate::verbs::{Arguments, Verb};
use coface::scale::workers::{bytes_text, seconds_text};
use coface_allocator::{CountingAllocator, Shortage, free_memory};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

#[global_allocator]
static ALLOCATOR: CountingAllocator = CountingAllocator::new();

/// How long temporary files may take to remove.
const PATIENCE: Duration = Duration::from_secs(2);

/// Keeps the limits of the command line.
pub(crate) fn keep(arguments: &Arguments) -> Result<(), Failure> {
    coface::algebra::memory::measure_by(free_memory);
    // A worker is watched by the process that started it, which says what became of it.
    if matches!(arguments.verb, Verb::Worker(_)) {
        return Ok(());
    }
    ALLOCATOR.end_at_shortage(|shortage| end(&out_of_memory(shortage)));
    if let Some(time) = arguments.time_of_program() {
        keep_time(time)?;
    }
    if let Some(bytes) = arguments.memory_of_program() {
        coface::algebra::memory::allow(Some(bytes));
        ALLOCATOR.limit_to(usize::try_from(bytes).unwrap_or(usize::MAX));
    }
    Ok(())
}

/// Whether the work is done, or was ended for its time: the first of these holds.
static IS_OVER: AtomicBool = AtomicBool::new(false);

/// The work is done: it is not too long any more. Where it was ended just before, this does not return.
pub(crate) fn work_is_done() {
    if IS_OVER.swap(true, Ordering::SeqCst) {
        loop {
            thread::park();
        }
    }
}

/// Ends the program after this time.
fn keep_time(time: Duration) -> Result<(), Failure> {
    let watch = move || {
        thread::sleep(time);
        if IS_OVER.swap(true, Ordering::SeqCst) {
            return;
        }
        end(&Failure::new(format!(
            "the work takes longer than {}; allow more by --time-limit, or ask for less",
            seconds_text(time)
        )))
    };
    let started = thread::Builder::new().name("coface-time".to_owned()).spawn(watch);
    started.map(|_| ()).map_err(|error| Failure::new(format!("no thread can be started: {error}")))
}

fn out_of_memory(shortage: Shortage) -> Failure {
    let asked = bytes_text((shortage.asked as u64).next_multiple_of(1 << 20));
    Failure::new(match shortage.limit {
        Some(limit) => format!(
            "the work needs more than {} of memory (the last piece asked for: {asked}); allow more by --memory, or ask for less",
            bytes_text(limit as u64)
        ),
        None => format!(
            "the work needs more memory than there is (the last piece asked for: {asked}); ask for less, or use a machine with more memory"
        ),
    })
}

/// Says why the program ends, and ends it.
fn end(failure: &Failure) -> ! {
    progress::clear_line();
    failure.say();
    // In a thread of its own: this one may hold the lock of the list of temporary files.
    let cleaning = thread::Builder::new().spawn(|| progress::end(1));
    if cleaning.is_ok() {
        thread::sleep(PATIENCE);
    }
    std::process::exit(1)
}
