//! Why a certificate is refused.

use std::fmt;

/// The first step of a check that fails, and why.
///
/// # Examples
/// ```
/// let fault = coface_check::check(b"{", &[b"[[0]]"]).expect_err("half an object");
/// assert_eq!(fault.step(), "certificate");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    step: String,
    message: String,
}

impl Fault {
    /// The step that fails, and why.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_check::Fault::new("sweep", "edges 3 and 4 cross").to_string(), "sweep: edges 3 and 4 cross");
    /// ```
    pub fn new(step: impl Into<String>, message: impl Into<String>) -> Self {
        Self { step: step.into(), message: message.into() }
    }

    /// The step, such as `input` or `smith of degree 2`.
    ///
    /// # Examples
    /// See [`Fault`].
    pub fn step(&self) -> &str {
        &self.step
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.step, self.message)
    }
}

impl std::error::Error for Fault {}
