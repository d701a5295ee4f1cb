//! The first pass of edge and face identification: records cut into ranges of their first number, in streams.
//!
//! Records that must be compared have the same first number (a smallest vertex). A counting sort over all vertices
//! would write all over memory; cut into ranges of vertices first, each range then sorts in the cache, and ranges are
//! independent of each other.

use coface_algebra::Error;
use coface_algebra::progress::stage;
use rayon::prelude::*;
use std::ops::Range;

/// Where records come from: chunks that are visited in parallel, each twice.
pub(crate) trait RecordSource<const N: usize>: Sync {
    /// The number of records of each chunk.
    fn chunk_sizes(&self) -> Vec<usize>;
    /// Whether the input of the chunk is sound.
    fn check(&self, chunk: usize) -> Result<(), Error>;
    /// Calls `put` with the records of the chunk in order. The first number of a record is what it is sorted by.
    fn for_each(&self, chunk: usize, put: impl FnMut([u32; N]));
}

/// Records, chunk after chunk and in each chunk stably sorted by the range of the first number.
pub(crate) struct RangedRecords<const N: usize> {
    records: Vec<[u32; N]>,
    chunks: Vec<Chunk>,
    range_bits: u32,
    range_count: usize,
}

/// The records of range r in a chunk are at `first + starts[r]..first + starts[r + 1]`.
struct Chunk {
    first: usize,
    starts: Vec<u32>,
}

impl<const N: usize> RangedRecords<N> {
    /// Cuts records with first numbers below `bound` into ranges of `2^range_bits` numbers.
    ///
    /// # Errors
    /// The error of the first chunk that has one.
    pub(crate) fn new(bound: usize, range_bits: u32, source: &impl RecordSource<N>) -> Result<Self, Error> {
        let range_count = bound.div_ceil(1 << range_bits);
        let sizes = source.chunk_sizes();
        let mut firsts = Vec::with_capacity(sizes.len());
        let mut total = 0;
        for &size in &sizes {
            firsts.push(total);
            total += size;
        }
        let mut records = vec![[0; N]; total];
        let steps = stage("sorting cells by their vertices", total);
        let chunks: Vec<Result<Chunk, Error>> = split_by(&mut records, sizes.iter().copied())
            .into_par_iter()
            .enumerate()
            .map(|(chunk, records)| {
                source.check(chunk)?;
                steps.advance(records.len());
                let mut starts = vec![0u32; range_count + 1];
                source.for_each(chunk, |record| starts[(record[0] >> range_bits) as usize + 1] += 1);
                let mut total = 0;
                for start in &mut starts {
                    total += *start;
                    *start = total;
                }
                let mut next = starts.clone();
                source.for_each(chunk, |record| {
                    let at = &mut next[(record[0] >> range_bits) as usize];
                    records[*at as usize] = record;
                    *at += 1;
                });
                Ok(Chunk { first: firsts[chunk], starts })
            })
            .collect();
        // The first chunk in order decides, so that the same fault is named whatever ran first.
        let chunks = chunks.into_iter().collect::<Result<_, _>>()?;
        Ok(Self { records, chunks, range_bits, range_count })
    }

    /// The number of ranges.
    pub(crate) fn range_count(&self) -> usize {
        self.range_count
    }

    /// The first number of a range.
    pub(crate) fn base(&self, range: usize) -> usize {
        range << self.range_bits
    }

    /// The numbers of records of all ranges.
    pub(crate) fn range_sizes(&self) -> Vec<usize> {
        (0..self.range_count).map(|r| self.segments(r).map(<[_]>::len).sum()).collect()
    }

    /// The records of a range in their original order, in pieces.
    pub(crate) fn segments(&self, range: usize) -> impl Iterator<Item = &[[u32; N]]> + Clone {
        self.chunks.iter().map(move |chunk| {
            &self.records
                [chunk.first + chunk.starts[range] as usize..chunk.first + chunk.starts[range + 1] as usize]
        })
    }
}

/// `0..count` in `pieces` nearly equal ranges.
pub(crate) fn equal_ranges(count: usize, pieces: usize) -> Vec<Range<usize>> {
    let cut = |i: usize| (count as u128 * i as u128 / pieces as u128) as usize;
    (0..pieces).map(|i| cut(i)..cut(i + 1)).collect()
}

/// Cuts a slice into pieces of these sizes.
pub(crate) fn split_by<T>(mut slice: &mut [T], sizes: impl Iterator<Item = usize>) -> Vec<&mut [T]> {
    sizes
        .map(|size| {
            let (piece, rest) = std::mem::take(&mut slice).split_at_mut(size);
            slice = rest;
            piece
        })
        .collect()
}
