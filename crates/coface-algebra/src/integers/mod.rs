//! Exact numbers: integers that widen instead of overflowing, fractions, residues and prime fields.

mod integer;
pub(crate) mod modular;
mod prime_field;
mod primes;
mod rational;
mod residue;

pub use integer::Integer;
#[doc(hidden)]
pub use prime_field::Binary;
pub use prime_field::{Field, Odd};
#[doc(hidden)]
pub use primes::is_prime;
pub use primes::large_primes;
pub use rational::Rational;
pub use residue::Residue;
