//! Work on many threads, if it is enough: small work stays in the thread that asks, and starts none.

use rayon::prelude::*;

/// So many steps are worth other threads: some hundred microseconds.
const ENOUGH: usize = 1 << 13;

/// The images of 0, 1, ..., `count` - 1, on all threads if the work is that of many steps in all.
///
/// # Examples
/// ```
/// use coface_algebra::threads::mapped;
/// assert_eq!(mapped(3, 3, |i| i * i), [0, 1, 4]);
/// ```
pub fn mapped<T: Send>(count: usize, steps: usize, image: impl Fn(usize) -> T + Sync) -> Vec<T> {
    match is_enough(steps) {
        true => (0..count).into_par_iter().map(&image).collect(),
        false => (0..count).map(image).collect(),
    }
}

/// The first of 0, 1, ..., `count` - 1 that fits, on all threads if the work is that of many steps in all.
///
/// # Examples
/// ```
/// use coface_algebra::threads::first;
/// assert_eq!(first(10, 10, |i| i * i > 20), Some(5));
/// ```
pub fn first(count: usize, steps: usize, fits: impl Fn(usize) -> bool + Sync) -> Option<usize> {
    match is_enough(steps) {
        true => (0..count).into_par_iter().find_first(|&i| fits(i)),
        false => (0..count).find(|&i| fits(i)),
    }
}

/// What both find, at the same time if the work is that of many steps in all.
///
/// # Examples
/// ```
/// use coface_algebra::threads::both;
/// assert_eq!(both(2, || 1, || "one"), (1, "one"));
/// ```
pub fn both<A: Send, B: Send>(
    steps: usize,
    one: impl FnOnce() -> A + Send,
    other: impl FnOnce() -> B + Send,
) -> (A, B) {
    if is_enough(steps) { rayon::join(one, other) } else { (one(), other()) }
}

/// Whether work of so many steps is worth other threads.
pub fn is_enough(steps: usize) -> bool {
    steps >= ENOUGH
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_do_not_depend_on_the_threads() {
        for steps in [0, ENOUGH] {
            assert_eq!(mapped(1000, steps, |i| 2 * i), (0..2000).step_by(2).collect::<Vec<_>>());
            assert_eq!(first(1000, steps, |i| i % 7 == 6), Some(6));
            assert_eq!(first(1000, steps, |_| false), None);
            assert_eq!(both(steps, || 1, || 2), (1, 2));
        }
    }
}
