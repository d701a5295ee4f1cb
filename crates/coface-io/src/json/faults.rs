//! Faults of a document, which pass through the parser.

use coface_algebra::Error;
use std::cell::RefCell;

/// Where a fault with its kind and cure waits while the parser hands its own error up.
#[derive(Default)]
pub(crate) struct Faults(RefCell<Option<Error>>);

impl Faults {
    /// Keeps the fault and gives the error that stops the parser.
    pub(crate) fn raise<E: serde::de::Error>(&self, fault: Error) -> E {
        let stop = E::custom(fault.message());
        self.0.borrow_mut().get_or_insert(fault);
        stop
    }

    /// The fault that was raised.
    pub(crate) fn take(&self) -> Option<Error> {
        self.0.borrow_mut().take()
    }
}
