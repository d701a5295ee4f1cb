//! Work on ranges of cells in parallel, with scratch arrays as many as threads.

use rayon::prelude::*;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

/// Gives ranges of `0..count`, and a scratch that `make` has made for them or for others before, to `work`, in parallel; the
/// results in the order of the ranges.
///
/// The ranges depend on the number of threads: what is made of all results must not.
pub(super) fn in_parts<S: Send, T: Send>(
    count: usize,
    make: impl Fn() -> S + Sync,
    work: impl Fn(&mut S, Range<usize>) -> T + Sync,
) -> Vec<T> {
    const LEAST: usize = 1 << 12;
    let part_count = (count / LEAST).clamp(1, 4 * rayon::current_num_threads());
    let bound = |part: usize| (count as u128 * part as u128 / part_count as u128) as usize;
    let idle: Mutex<Vec<S>> = Mutex::new(Vec::new());
    (0..part_count)
        .into_par_iter()
        .map(|part| {
            let taken = idle.lock().unwrap_or_else(PoisonError::into_inner).pop();
            let mut scratch = taken.unwrap_or_else(&make);
            let result = work(&mut scratch, bound(part)..bound(part + 1));
            idle.lock().unwrap_or_else(PoisonError::into_inner).push(scratch);
            result
        })
        .collect()
}
