//! Worker processes: work that may crash, never end or take all memory runs in a process of its own.
//!
//! A [`WorkerPool`] keeps processes of a program and hands each one **request** after another; both requests and **answers** are lines of
//! text. What becomes of a request is an [`Outcome`]: an answer, or a [`Loss`] that says how its worker ended. The program at the other end
//! calls [`serve`]. [`Limits`] are those of one request: the pool ends a worker that takes too long, and each worker limits its own memory.
//!
//! ```text
//!    WorkerPool --spawns--> WorkerProcess ==limits, requests==> serve (in the worker)
//!         ^--Outcome------------ | <==========ready, answers====== |
//! ```
//!
//! Workers end with the process that started them, however it ends: their standard input is then at its end.

mod limits;
mod loss;
mod pool;
mod process;
mod serving;

pub use limits::{Limits, bytes_text, parse_bytes, parse_duration, seconds_text};
pub use loss::Loss;
pub use pool::{Outcome, WorkerPool};
pub use process::{Answer, WorkerCommand};
pub use serving::serve;
