//! Sums of sparse columns.

use coface_algebra::Field;

/// A sum of columns, with a place for each row. Its first term can be taken out.
pub(super) struct Sum<U> {
    coefficients: Vec<Option<U>>,
    /// A bit for each row that was written to, then a bit for each word of bits that is not 0, up to a single word.
    levels: Vec<Vec<u64>>,
}

impl<U: Copy> Sum<U> {
    pub(super) fn new(row_count: usize) -> Self {
        let mut levels = vec![vec![0; row_count.div_ceil(64).max(1)]];
        while let Some(words) = levels.last().map(Vec::len).filter(|&words| words > 1) {
            levels.push(vec![0; words.div_ceil(64)]);
        }
        Self { coefficients: vec![None; row_count], levels }
    }

    pub(super) fn add<F: Field<Unit = U>>(&mut self, field: &F, row: u32, part: U) {
        let place = &mut self.coefficients[row as usize];
        if let Some(old) = *place {
            *place = field.sum(old, part);
            return;
        }
        *place = Some(part);
        let mut at = row as usize;
        for level in &mut self.levels {
            let word = &mut level[at / 64];
            let was_empty = *word == 0;
            *word |= 1 << (at % 64);
            if !was_empty {
                break;
            }
            at /= 64;
        }
    }

    /// A row such that all terms have it or a later one.
    pub(super) fn least_row(&self) -> Option<u32> {
        let mut at = 0;
        for level in self.levels.iter().rev() {
            let word = level[at];
            if word == 0 {
                return None;
            }
            at = 64 * at + word.trailing_zeros() as usize;
        }
        Some(at as u32)
    }

    /// Takes the term of a row out that was written to.
    pub(super) fn take(&mut self, row: u32) -> Option<U> {
        let mut at = row as usize;
        for level in &mut self.levels {
            let word = &mut level[at / 64];
            *word &= !(1 << (at % 64));
            if *word != 0 {
                break;
            }
            at /= 64;
        }
        self.coefficients[row as usize].take()
    }

    /// Takes the first term out.
    pub(super) fn pop(&mut self) -> Option<(u32, U)> {
        while let Some(row) = self.least_row() {
            if let Some(coefficient) = self.take(row) {
                return Some((row, coefficient));
            }
        }
        None
    }
}
