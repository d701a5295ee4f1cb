//! Vectors over Z/2.

/// A vector over Z/2.
#[derive(Clone, Debug, Default)]
pub(super) struct Bits(Vec<u64>);

impl Bits {
    pub(super) fn zero(count: usize) -> Self {
        Self(vec![0; count.div_ceil(64)])
    }

    pub(super) fn unit(count: usize, i: usize) -> Self {
        let mut unit = Self::zero(count);
        unit.flip(i);
        unit
    }

    pub(super) fn flip(&mut self, i: usize) {
        self.0[i / 64] ^= 1 << (i % 64);
    }

    pub(super) fn add(&mut self, other: &Self) {
        self.0.iter_mut().zip(&other.0).for_each(|(a, b)| *a ^= b);
    }

    /// Whether the scalar product is 1.
    pub(super) fn is_odd_on(&self, other: &Self) -> bool {
        self.0.iter().zip(&other.0).fold(0, |sum, (a, b)| sum ^ (a & b)).count_ones() % 2 == 1
    }

    /// The first place with a one.
    pub(super) fn first_one(&self) -> Option<usize> {
        let word = self.0.iter().position(|&word| word != 0)?;
        Some(64 * word + self.0[word].trailing_zeros() as usize)
    }

    pub(super) fn has(&self, i: usize) -> bool {
        self.0[i / 64] >> (i % 64) & 1 == 1
    }
}
