//! Parallel iterators: those of [rayon](https://docs.rs/rayon), and for targets without threads the same words for work that one thread
//! does in order.
//!
//! The crates of coface name this crate `rayon`. Where there are threads it is rayon and nothing else. A module of WebAssembly has one
//! thread; there rayon would run each piece of work itself, through code for dividing it that is made anew for each chain of iterators and
//! is a large part of the module. In its place are the iterators of the standard library, in a wrapper with the methods of rayon that coface
//! uses. Answers are the same: nothing in coface depends on how work is divided.

#[cfg(any(target_family = "wasm", test))]
#[cfg_attr(not(target_family = "wasm"), allow(dead_code, unused_imports, unreachable_pub))]
mod serial;

#[cfg(not(target_family = "wasm"))]
pub use rayon::*;

#[cfg(target_family = "wasm")]
pub use serial::{
    Scope, ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder, current_num_threads, in_place_scope, join,
    prelude,
};
