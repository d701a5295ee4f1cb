//! How much memory this process may still take, so that a request which needs more is refused before the work begins.
//!
//! # Words
//! The memory that is **free** is the less of what [`allow`] allows and what the function given to [`measure_by`] finds. Without either,
//! nothing is known and everything is granted: this crate does not look at the system itself.
//!
//! # Examples
//! ```standalone_crate
//! use coface_algebra::memory;
//! memory::measure_by(|| Some(1 << 30));
//! memory::require(1 << 20, || "a matrix of 512 rows and 256 columns".to_owned())?;
//! assert!(memory::require(u64::MAX, || "a matrix of 2^40 rows".to_owned()).is_err());
//! # Ok::<(), coface_algebra::Error>(())
//! ```

use crate::{Error, ErrorKind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{PoisonError, RwLock};

/// What the program allows; the largest number is no limit.
static ALLOWED: AtomicU64 = AtomicU64::new(u64::MAX);
/// What says how much the system has left.
static METER: RwLock<Option<Meter>> = RwLock::new(None);

/// Says how many bytes this process may still take; `None` if that is not known.
pub type Meter = fn() -> Option<u64>;

/// Has the free memory measured by this function, each time that a request asks for more than 64 MiB.
///
/// # Examples
/// ```standalone_crate
/// use coface_algebra::memory;
/// memory::measure_by(|| Some(1 << 30));
/// assert_eq!(memory::free(), Some(1 << 30));
/// ```
pub fn measure_by(meter: Meter) {
    *METER.write().unwrap_or_else(PoisonError::into_inner) = Some(meter);
}

/// Lets requests of this process ask for so many bytes at most; `None` is no limit of its own.
///
/// This limits what [`require`] grants. It does not watch what is allocated.
///
/// # Examples
/// ```standalone_crate
/// use coface_algebra::memory;
/// memory::allow(Some(1000));
/// assert!(memory::require(2000, || "a table".to_owned()).is_err());
/// memory::allow(None);
/// ```
pub fn allow(bytes: Option<u64>) {
    ALLOWED.store(bytes.unwrap_or(u64::MAX), Ordering::Relaxed);
}

/// The bytes that this process may still take, as far as is known.
///
/// # Examples
/// ```standalone_crate
/// assert_eq!(coface_algebra::memory::free(), None);
/// ```
pub fn free() -> Option<u64> {
    let allowed = Some(ALLOWED.load(Ordering::Relaxed)).filter(|&bytes| bytes < u64::MAX);
    let meter = *METER.read().unwrap_or_else(PoisonError::into_inner);
    [allowed, meter.and_then(|meter| meter())].into_iter().flatten().min()
}

/// Refuses what needs more memory than is free.
///
/// # Errors
/// [`ErrorKind::TooLarge`], which names `what` and both numbers.
///
/// # Complexity
/// Constant below 64 MiB, which are granted unless [`allow`] allows less; else that of [`free`].
///
/// # Examples
/// ```standalone_crate
/// coface_algebra::memory::allow(Some(1 << 30));
/// let error = coface_algebra::memory::require(1 << 62, || "a list of 2^60 numbers".to_owned()).unwrap_err();
/// assert!(error.message().starts_with("a list of 2^60 numbers needs about"));
/// ```
pub fn require(bytes: u64, what: impl FnOnce() -> String) -> Result<(), Error> {
    let is_small = bytes <= 1 << 26 && bytes <= ALLOWED.load(Ordering::Relaxed);
    match free().filter(|&free| !is_small && free < bytes) {
        None => Ok(()),
        Some(free) => Err(Error::new(
            ErrorKind::TooLarge,
            format!("{} needs about {} of memory, and {} are free", what(), rounded(bytes), rounded(free)),
        )
        .with_cure("ask for less, or give it more memory")),
    }
}

/// A number of bytes in three digits: `1.5 GB`.
fn rounded(bytes: u64) -> String {
    let units = [(1e12, "TB"), (1e9, "GB"), (1e6, "MB"), (1e3, "kB")];
    match units.into_iter().find(|&(unit, _)| bytes as f64 >= unit) {
        Some((unit, name)) if bytes as f64 >= 100.0 * unit => format!("{:.0} {name}", bytes as f64 / unit),
        Some((unit, name)) => format!("{:.1} {name}", bytes as f64 / unit),
        None => format!("{bytes} bytes"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amounts_are_short() {
        let shown = [12, 1500, 805_306_368, 6_400_000_000, 1 << 62].map(rounded);
        assert_eq!(shown, ["12 bytes", "1.5 kB", "805 MB", "6.4 GB", "4611686 TB"]);
    }
}
