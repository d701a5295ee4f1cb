//! How much memory this process may still take, so that a request which needs more is refused before the work begins.
//!
//! # Words
//! The memory that is **free** is the least of: what [`allow`] allows; the limit of the system on the address space (`ulimit -v`) and of the
//! control group (containers), less what the process has of them; and what the machine has left. On systems other than Linux only [`allow`]
//! is known.
//!
//! # Examples
//! ```
//! use coface_algebra::memory;
//! memory::require(1 << 20, || "a matrix of 512 rows and 256 columns".to_owned())?;
//! assert!(memory::require(u64::MAX, || "a matrix of 2^40 rows".to_owned()).is_err());
//! # Ok::<(), coface_algebra::Error>(())
//! ```

use crate::{Error, ErrorKind};
use std::sync::atomic::{AtomicU64, Ordering};

/// What the program allows; the largest number is no limit.
static ALLOWED: AtomicU64 = AtomicU64::new(u64::MAX);

/// Lets requests of this process ask for so many bytes at most; `None` is no limit of its own.
///
/// This limits what [`require`] grants. It does not watch what is allocated.
///
/// # Examples
/// ```
/// use coface_algebra::memory;
/// memory::allow(Some(1000));
/// assert!(memory::require(2000, || "a table".to_owned()).is_err());
/// memory::allow(None);
/// ```
pub fn allow(bytes: Option<u64>) {
    ALLOWED.store(bytes.unwrap_or(u64::MAX), Ordering::Relaxed);
}

/// The bytes that this process may still take, as far as the system tells; `None` if nothing is known.
///
/// # Complexity
/// Four small files of the system are read.
///
/// # Examples
/// ```
/// assert_ne!(coface_algebra::memory::free(), Some(0));
/// ```
pub fn free() -> Option<u64> {
    let allowed = Some(ALLOWED.load(Ordering::Relaxed)).filter(|&bytes| bytes < u64::MAX);
    [allowed, free_addresses(), free_of_group(), free_of_machine()].into_iter().flatten().min()
}

/// Refuses what needs more memory than is free.
///
/// # Errors
/// [`ErrorKind::TooLarge`], which names `what` and both numbers.
///
/// # Complexity
/// Constant below 64 MiB, which are always granted; else that of [`free`].
///
/// # Examples
/// ```
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

/// What is left of the limit on the address space.
fn free_addresses() -> Option<u64> {
    let limits = std::fs::read_to_string("/proc/self/limits").ok()?;
    let row = limits.lines().find_map(|line| line.strip_prefix("Max address space"))?;
    let soft: u64 = row.split_whitespace().next()?.parse().ok()?;
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    Some(soft.saturating_sub(kibibytes(&status, "VmSize:")?))
}

/// What is left of the limit of the control group, in which the process is alone as far as it sees.
fn free_of_group() -> Option<u64> {
    let number = |name: &str| {
        let text = std::fs::read_to_string(format!("/sys/fs/cgroup/{name}")).ok()?;
        text.trim().parse::<u64>().ok()
    };
    Some(number("memory.max")?.saturating_sub(number("memory.current")?))
}

/// What the machine can give without swapping.
fn free_of_machine() -> Option<u64> {
    kibibytes(&std::fs::read_to_string("/proc/meminfo").ok()?, "MemAvailable:")
}

/// The row of this name in a table of the kernel, in bytes.
fn kibibytes(table: &str, name: &str) -> Option<u64> {
    let row = table.lines().find_map(|line| line.strip_prefix(name))?;
    let count: u64 = row.split_whitespace().next()?.parse().ok()?;
    count.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_the_kernel_are_read() {
        let table = "MemTotal:       24000000 kB\nMemAvailable:   12000000 kB\n";
        assert_eq!(kibibytes(table, "MemAvailable:"), Some(12_000_000 << 10));
        assert_eq!(kibibytes(table, "SwapFree:"), None);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn the_machine_has_some_memory() {
        let free = free().unwrap();
        assert!(free > 1 << 20 && free < 1 << 50, "{free}");
    }

    #[test]
    fn amounts_are_short() {
        let shown = [12, 1500, 805_306_368, 6_400_000_000, 1 << 62].map(rounded);
        assert_eq!(shown, ["12 bytes", "1.5 kB", "805 MB", "6.4 GB", "4611686 TB"]);
    }
}
