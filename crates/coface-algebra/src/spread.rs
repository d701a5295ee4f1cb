//! A hash map that spreads keys by multiplication: faster than that of the standard library, which resists keys chosen to collide.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// Spreads numbers by one multiplication each.
///
/// # Examples
/// ```
/// use coface_algebra::SpreadMap;
/// let mut squares = SpreadMap::default();
/// squares.extend((0..100u64).map(|n| (n, n * n)));
/// assert_eq!(squares[&7], 49);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct SpreadHasher(u64);

/// A map whose keys are spread by [`SpreadHasher`].
pub type SpreadMap<K, V> = HashMap<K, V, BuildHasherDefault<SpreadHasher>>;

impl Hasher for SpreadHasher {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.write_u64(u64::from(byte));
        }
    }

    fn write_u32(&mut self, number: u32) {
        self.write_u64(u64::from(number));
    }

    fn write_u64(&mut self, number: u64) {
        let spread = (self.0.rotate_left(5) ^ number).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 = spread ^ (spread >> 32);
    }
}
