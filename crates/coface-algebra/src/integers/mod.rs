//! Exact numbers: integers of any size, fractions, residues and prime fields.
//!
//! An [`Integer`] holds 64 bits as long as its value fits, and a big integer beyond: arithmetic never overflows. A
//! [`Rational`] is a fraction in lowest terms with a positive denominator. A [`Residue`] is an element of Z/n and knows
//! its modulus; elements of different moduli do not mix. A [`Field`] is a prime field as elimination uses it: 32-bit
//! classes modulo an odd prime, or the field of two elements.

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
