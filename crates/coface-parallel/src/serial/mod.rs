//! The words of rayon for one thread: what is started is done at once, and iterators go from their first item to the last.

mod iterator;
mod pool;
mod slice;

pub use pool::{
    Scope, ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder, current_num_threads, in_place_scope, join,
};

/// What `use rayon::prelude::*` brings.
pub mod prelude {
    pub use super::iterator::{
        IntoParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelExtend, Serial,
    };
    pub use super::slice::{ParallelSlice, ParallelSliceMut};
}

#[cfg(test)]
mod tests;
