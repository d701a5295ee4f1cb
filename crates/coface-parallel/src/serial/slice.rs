//! Slices in pieces, and their order.

use super::iterator::Serial;
use std::cmp::Ordering;
use std::slice::{Chunks, ChunksMut, Windows};

/// Slices in pieces.
pub trait ParallelSlice<T> {
    /// The slice itself.
    fn as_parallel_slice(&self) -> &[T];

    /// Pieces of `size` items; the last may be shorter.
    fn par_chunks(&self, size: usize) -> Serial<Chunks<'_, T>> {
        Serial::new(self.as_parallel_slice().chunks(size))
    }

    /// All runs of `size` items that follow each other.
    fn par_windows(&self, size: usize) -> Serial<Windows<'_, T>> {
        Serial::new(self.as_parallel_slice().windows(size))
    }
}

impl<T> ParallelSlice<T> for [T] {
    fn as_parallel_slice(&self) -> &[T] {
        self
    }
}

/// Slices that are changed: in pieces, and in order.
pub trait ParallelSliceMut<T> {
    /// The slice itself.
    fn as_parallel_slice_mut(&mut self) -> &mut [T];

    /// Pieces of `size` items; the last may be shorter.
    fn par_chunks_mut(&mut self, size: usize) -> Serial<ChunksMut<'_, T>> {
        Serial::new(self.as_parallel_slice_mut().chunks_mut(size))
    }

    /// Puts items in order; equal items stay as they stand.
    fn par_sort_by<F: Fn(&T, &T) -> Ordering>(&mut self, compare: F) {
        self.as_parallel_slice_mut().sort_by(compare);
    }

    /// Puts items in the order of their keys; items of equal keys stay as they stand.
    fn par_sort_by_key<K: Ord, F: Fn(&T) -> K>(&mut self, key: F) {
        self.as_parallel_slice_mut().sort_by_key(key);
    }

    /// Puts items in order.
    fn par_sort_unstable(&mut self)
    where
        T: Ord,
    {
        self.as_parallel_slice_mut().sort_unstable();
    }

    /// Puts items in order.
    fn par_sort_unstable_by<F: Fn(&T, &T) -> Ordering>(&mut self, compare: F) {
        self.as_parallel_slice_mut().sort_unstable_by(compare);
    }

    /// Puts items in the order of their keys.
    fn par_sort_unstable_by_key<K: Ord, F: Fn(&T) -> K>(&mut self, key: F) {
        self.as_parallel_slice_mut().sort_unstable_by_key(key);
    }
}

impl<T> ParallelSliceMut<T> for [T] {
    fn as_parallel_slice_mut(&mut self) -> &mut [T] {
        self
    }
}
