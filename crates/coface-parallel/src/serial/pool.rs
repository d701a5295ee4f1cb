//! Pools of threads that have none: what they are given runs where it is given.

use std::error::Error;
use std::fmt;
use std::marker::PhantomData;

/// Runs the first, then the second, and has the results of both.
pub fn join<A, B, RA, RB>(first: A, second: B) -> (RA, RB)
where
    A: FnOnce() -> RA,
    B: FnOnce() -> RB,
{
    (first(), second())
}

/// The number of threads: one.
pub fn current_num_threads() -> usize {
    1
}

/// Where work is started that may borrow what lives as long as `'scope`.
#[derive(Debug)]
pub struct Scope<'scope>(PhantomData<&'scope ()>);

impl<'scope> Scope<'scope> {
    /// Runs the work at once.
    pub fn spawn<F: FnOnce(&Self) + 'scope>(&self, work: F) {
        work(self);
    }
}

/// Calls the function with a scope; all work that was started in it is done when this returns.
pub fn in_place_scope<'scope, F, R>(function: F) -> R
where
    F: FnOnce(&Scope<'scope>) -> R,
{
    function(&Scope(PhantomData))
}

/// How many threads a pool should have; it has one, whatever is asked for.
#[derive(Debug, Default)]
pub struct ThreadPoolBuilder(());

impl ThreadPoolBuilder {
    /// A pool as it is without being asked for anything.
    pub fn new() -> Self {
        Self::default()
    }

    /// Asks for a number of threads, which is not kept.
    pub fn num_threads(self, _: usize) -> Self {
        self
    }

    /// The pool.
    ///
    /// # Errors
    /// None; the type is that of rayon.
    pub fn build(self) -> Result<ThreadPool, ThreadPoolBuildError> {
        Ok(ThreadPool(()))
    }

    /// The pool of all work outside of others.
    ///
    /// # Errors
    /// None; the type is that of rayon.
    pub fn build_global(self) -> Result<(), ThreadPoolBuildError> {
        Ok(())
    }
}

/// Why a pool could not be made; there is no value of this type.
#[derive(Debug)]
pub enum ThreadPoolBuildError {}

impl fmt::Display for ThreadPoolBuildError {
    fn fmt(&self, _: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {}
    }
}

impl Error for ThreadPoolBuildError {}

/// A pool with one thread: the caller's.
#[derive(Debug)]
pub struct ThreadPool(());

impl ThreadPool {
    /// Runs the function.
    pub fn install<F: FnOnce() -> R, R>(&self, function: F) -> R {
        function()
    }
}
