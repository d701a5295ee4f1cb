//! What became of a request that has no answer.

use crate::workers::limits::{bytes_text, seconds_text};
use std::fmt;
use std::process::ExitStatus;
use std::time::Duration;

/// Why a request has no answer: how its worker ended.
///
/// # Examples
/// ```
/// use coface_scale::workers::Loss;
/// let loss = Loss::Memory { limit: Some(2 << 30) };
/// assert_eq!((loss.kind(), loss.to_string().as_str()), ("memory", "needed more than 2 GiB of memory"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Loss {
    /// It took longer than it may, and its worker was ended.
    Time {
        /// The time it may take.
        limit: Duration,
    },
    /// It needed more memory than there is for it.
    Memory {
        /// The memory in bytes that it may take, if that is limited.
        limit: Option<u64>,
    },
    /// Its worker failed by its own fault.
    Crash {
        /// The signal, the exit status, or what the program says about its fault.
        how: String,
    },
    /// Its workers were ended from outside: by hand, or by a system that has no memory left.
    Killed {
        /// The name of the last signal.
        signal: String,
        /// How many workers were lost to it.
        attempts: usize,
    },
}

impl Loss {
    /// One word for it: `time`, `memory`, `crash`, `killed`.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::workers::Loss;
    /// let loss = Loss::Memory { limit: None };
    /// assert_eq!(loss.kind(), "memory");
    /// ```
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Time { .. } => "time",
            Self::Memory { .. } => "memory",
            Self::Crash { .. } => "crash",
            Self::Killed { .. } => "killed",
        }
    }

    /// What to do about it.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::workers::Loss;
    /// let loss = Loss::Memory { limit: None };
    /// assert_eq!(loss.cure(), "use a machine with more memory");
    /// ```
    pub fn cure(&self) -> &'static str {
        match self {
            Self::Time { .. } => "allow more time",
            Self::Memory { limit: Some(_) } => "allow more memory",
            Self::Memory { limit: None } => "use a machine with more memory",
            Self::Crash { .. } => "this is a fault of the program: please report it with the input",
            Self::Killed { .. } => "free memory, or use fewer processes at once",
        }
    }

    /// How a worker with this memory ended that nobody here ended; `said` is what it wrote on standard error.
    pub(crate) fn of_death(status: ExitStatus, said: &str, memory: Option<u64>) -> Self {
        // An allocation of Rust that failed, or one of the system: of the stack of a thread, say.
        let is_out_of_memory = said.lines().any(|line| {
            line.starts_with("memory allocation of ") || line.contains("Cannot allocate memory (os error 12)")
        });
        let signal = signal_of(status);
        if is_out_of_memory && status.code() != Some(0) {
            return Self::Memory { limit: memory };
        }
        if let Some(fault) = said.lines().rev().find_map(|line| line.strip_prefix(FAULT)) {
            return Self::Crash { how: fault.to_owned() };
        }
        if said.contains("has overflowed its stack") {
            return Self::Crash { how: "its stack overflowed".to_owned() };
        }
        match signal {
            Some((signal, true)) => Self::Killed { signal, attempts: 1 },
            Some((signal, false)) => Self::Crash { how: signal },
            None => Self::Crash { how: status.to_string() },
        }
    }
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Time { limit } => write!(f, "took longer than {}", seconds_text(*limit)),
            Self::Memory { limit: Some(limit) } => {
                write!(f, "needed more than {} of memory", bytes_text(*limit))
            }
            Self::Memory { limit: None } => f.write_str("needed more memory than there is"),
            Self::Crash { how } => write!(f, "crashed: {how}"),
            Self::Killed { signal, attempts: 1 } => write!(f, "was ended from outside by {signal}"),
            Self::Killed { signal, attempts } => {
                write!(f, "was ended from outside by {signal}, {attempts} times")
            }
        }
    }
}

/// What a worker begins the line with that reports a panic.
pub(crate) const FAULT: &str = "fault: ";

/// The signal that ended a process, and whether such signals come from outside.
#[cfg(unix)]
fn signal_of(status: ExitStatus) -> Option<(String, bool)> {
    use nix::sys::signal::Signal;
    use std::os::unix::process::ExitStatusExt;
    let number = status.signal()?;
    let Ok(signal) = Signal::try_from(number) else { return Some((format!("signal {number}"), true)) };
    let is_own = matches!(
        signal,
        Signal::SIGABRT
            | Signal::SIGBUS
            | Signal::SIGFPE
            | Signal::SIGILL
            | Signal::SIGSEGV
            | Signal::SIGSYS
            | Signal::SIGTRAP
    );
    Some((signal.as_str().to_owned(), !is_own))
}

#[cfg(not(unix))]
fn signal_of(_: ExitStatus) -> Option<(String, bool)> {
    None
}
