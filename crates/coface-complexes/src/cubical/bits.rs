//! Bits in words.

use coface_algebra::{Error, ErrorKind};

/// A list of bits, 64 in a word, the first one lowest; bits beyond the end are zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Bits {
    pub(super) words: Vec<u64>,
    pub(super) len: usize,
}

impl Bits {
    /// So many bits, none set.
    pub(super) fn zeros(len: usize) -> Result<Self, Error> {
        let mut words = Vec::new();
        words.try_reserve_exact(len.div_ceil(64)).map_err(|_| {
            Error::new(ErrorKind::TooLarge, format!("{len} voxels do not fit in memory"))
                .with_cure("take the volume in blocks")
        })?;
        words.resize(len.div_ceil(64), 0);
        Ok(Self { words, len })
    }

    pub(super) fn fill(&mut self) {
        self.words.fill(u64::MAX);
        if !self.len.is_multiple_of(64)
            && let Some(last) = self.words.last_mut()
        {
            *last = (1 << (self.len % 64)) - 1;
        }
    }

    #[inline]
    pub(super) fn contains(&self, at: usize) -> bool {
        self.words[at / 64] & (1 << (at % 64)) != 0
    }

    pub(super) fn insert(&mut self, at: usize) {
        self.words[at / 64] |= 1 << (at % 64);
    }

    /// Up to 64 bits from a place on, the others zero.
    pub(super) fn read(&self, at: usize, count: usize) -> u64 {
        let (word, shift) = (at / 64, at % 64);
        let mut bits = self.words[word] >> shift;
        if shift + count > 64 {
            bits |= self.words[word + 1] << (64 - shift);
        }
        if count < 64 { bits & ((1 << count) - 1) } else { bits }
    }

    /// Sets the bits from `at` on that are set in `other` from `from` on, `count` of them.
    pub(super) fn add(&mut self, at: usize, other: &Self, from: usize, count: usize) {
        for done in (0..count).step_by(64) {
            let length = (count - done).min(64);
            let bits = other.read(from + done, length);
            let (word, shift) = ((at + done) / 64, (at + done) % 64);
            self.words[word] |= bits << shift;
            if shift + length > 64 {
                self.words[word + 1] |= bits >> (64 - shift);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn runs_of_bits_are_copied(
            words in prop::collection::vec(any::<u64>(), 4),
            from in 0usize..100,
            at in 0usize..100,
            count in 0usize..150,
        ) {
            let source = Bits { words, len: 256 };
            let mut target = Bits::zeros(at + count).unwrap();
            target.add(at, &source, from, count);
            for i in 0..at + count {
                prop_assert_eq!(target.contains(i), i >= at && source.contains(from + i - at));
            }
        }
    }
}
