//! Long block tridiagonal systems cut into parts that are solved side by side.
//!
//! What a row says fades with the distance from it: by a factor of about four a row for cubic splines, and by two at least. So the
//! unknowns between two parts, the **separators**, are found from the rows near them alone, as far as numbers of ordinary size
//! can tell, and then each part by itself. Where the parts are depends on the number of rows, not on threads.

use super::block_tridiagonal::{inverse, is_nothing, less, product};
use super::hermite::{Block, BlockRow, Columns};
use rayon::prelude::*;
use std::ops::Range;

/// Rows of a part. What elimination needs of a part stays in the second cache.
const PART: usize = 1 << 14;
/// How far around a separator is looked first; then twice as far, up to a part.
const NEAR: usize = 512;

/// The unknowns of a system between its parts.
pub(super) struct Separators<const N: usize> {
    /// The unknown before each part, if it is a separator.
    values: Vec<Columns<N>>,
    /// The number of unknowns.
    count: usize,
    is_cyclic: bool,
}

/// Room for the elimination of one part.
#[derive(Default)]
pub(super) struct Elimination<const N: usize> {
    rows: Vec<BlockRow<N>>,
    /// The unknowns of the part, and the one after it, if there is one.
    pub(super) unknowns: Vec<Columns<N>>,
}

impl<const N: usize> Separators<N> {
    /// The separators of an open system, or one in which the first row comes after the last; none if it is too short to be cut, or
    /// where rows do not fade.
    pub(super) fn new(
        count: usize,
        is_cyclic: bool,
        row: &(impl Fn(usize) -> BlockRow<N> + Sync),
    ) -> Option<Self> {
        let part_count = count / PART;
        if part_count < 2 {
            return None;
        }
        let values = (0..part_count)
            .into_par_iter()
            .map(|part| match part {
                // Nothing comes before the first part of an open system.
                0 if !is_cyclic => Some([[0.0; 2]; N]),
                _ => separator(part * PART, count, is_cyclic, row),
            })
            .collect::<Option<Vec<_>>>()?;
        Some(Self { values, count, is_cyclic })
    }

    pub(super) fn part_count(&self) -> usize {
        self.values.len()
    }

    /// The unknowns of a part without the one that the next part begins with.
    pub(super) fn part(&self, part: usize) -> Range<usize> {
        part * PART..if part + 1 == self.part_count() { self.count } else { (part + 1) * PART }
    }

    /// Finds the unknowns of a part.
    pub(super) fn solve(
        &self,
        part: usize,
        row: impl Fn(usize) -> BlockRow<N>,
        Elimination { rows, unknowns }: &mut Elimination<N>,
    ) {
        let Range { start, end } = self.part(part);
        let before = (start > 0 || self.is_cyclic).then(|| self.values[part]);
        let after = if end < self.count {
            Some(self.values[part + 1])
        } else {
            self.is_cyclic.then(|| self.values[0])
        };
        let first = usize::from(before.is_some());
        rows.clear();
        rows.extend((start + first..end).map(row));
        // From both ends to the middle and back, so that there is something to do while one way waits for its numbers. What a row
        // becomes stands where it was: the unknown is the right side less a block times the next unknown.
        let zero = [[0.0; N]; N];
        let mut up = (zero, before.unwrap_or([[0.0; 2]; N]));
        let mut down = (zero, after.unwrap_or([[0.0; 2]; N]));
        let (low, high) = rows.split_at_mut((end - start - first) / 2);
        for (own, other) in low.iter_mut().zip(high.iter_mut().rev()) {
            up = eliminated(own, &up);
            down = eliminated(&mirrored(other), &down);
            (own.after, own.right) = up;
            (other.before, other.right) = down;
        }
        // The upper half may have one row more.
        if high.len() > low.len() {
            down = eliminated(&mirrored(&high[0]), &down);
            (high[0].before, high[0].right) = down;
        }
        let mut pivot = less(zero, &product(&up.0, &down.0));
        (0..N).for_each(|i| pivot[i][i] += 1.0);
        let mut below = product(&inverse(pivot), &less(up.1, &product(&up.0, &down.1)));
        let mut above = less(down.1, &product(&down.0, &below));
        unknowns.clear();
        unknowns.extend(before);
        unknowns.resize(end - start, below);
        unknowns.extend(after);
        let (lower, upper) = unknowns[first..end - start].split_at_mut(low.len());
        if let (Some(own), Some(other)) = (lower.last_mut(), upper.first_mut()) {
            (*own, *other) = (below, above);
        }
        let mut lower = lower.iter_mut().zip(low.iter()).rev().skip(1);
        for (place, row) in upper.iter_mut().zip(high.iter()).skip(1) {
            above = less(row.right, &product(&row.before, &above));
            *place = above;
            if let Some((place, row)) = lower.next() {
                below = less(row.right, &product(&row.after, &below));
                *place = below;
            }
        }
    }
}

/// A row seen from the other end.
#[inline(always)]
fn mirrored<const N: usize>(row: &BlockRow<N>) -> BlockRow<N> {
    let BlockRow { before, at, after, right } = *row;
    BlockRow { before: after, at, after: before, right }
}

/// The unknown of a row as a constant less a block times the unknown after it, from that of the row before.
#[inline(always)]
fn eliminated<const N: usize>(row: &BlockRow<N>, before: &(Block<N>, Columns<N>)) -> (Block<N>, Columns<N>) {
    let pivot = inverse(less(row.at, &product(&row.before, &before.0)));
    (product(&pivot, &row.after), product(&pivot, &less(row.right, &product(&row.before, &before.1))))
}

/// One unknown from the rows on both sides up to where unknowns have no effect on it.
fn separator<const N: usize>(
    at: usize,
    count: usize,
    is_cyclic: bool,
    row: &impl Fn(usize) -> BlockRow<N>,
) -> Option<Columns<N>> {
    let mut near = NEAR;
    while near <= PART {
        let [below, above] = if is_cyclic { [near; 2] } else { [near.min(at), near.min(count - 1 - at)] };
        let before = side((1..=below).rev().map(|step| row((at + count - step) % count)));
        let after = side((1..=above).rev().map(|step| mirrored(&row((at + step) % count))));
        if let (Some(before), Some(after)) = (before, after) {
            let own = row(at);
            let pivot = less(less(own.at, &product(&own.before, &before.0)), &product(&own.after, &after.0));
            let right =
                less(less(own.right, &product(&own.before, &before.1)), &product(&own.after, &after.1));
            return Some(product(&inverse(pivot), &right));
        }
        near *= 2;
    }
    None
}

/// Eliminates rows up to the last one; none if the unknown before the first one has an effect there.
fn side<const N: usize>(rows: impl Iterator<Item = BlockRow<N>>) -> Option<(Block<N>, Columns<N>)> {
    let mut last = ([[0.0; N]; N], [[0.0; 2]; N]);
    let mut effect: Option<Block<N>> = None;
    for row in rows {
        let pivot = inverse(less(row.at, &product(&row.before, &last.0)));
        let from = match &effect {
            None => row.before,
            Some(effect) => product(&row.before, effect),
        };
        effect = Some(product(&pivot, &from));
        last =
            (product(&pivot, &row.after), product(&pivot, &less(row.right, &product(&row.before, &last.1))));
    }
    effect.is_none_or(|effect| is_nothing(&effect)).then_some(last)
}

#[cfg(test)]
mod tests {
    use super::super::block_tridiagonal::{cyclic_solution, open_solution};
    use super::*;

    /// Rows of which the one at a place is weak if asked for.
    fn rows(weak: Option<usize>) -> impl Fn(usize) -> BlockRow<2> + Sync {
        move |i: usize| {
            let size = |k: usize| ((i * 31 + k * 17) % 101) as f64 / 101.0 - 0.5;
            let block = |k: usize| [[size(k), size(k + 1)], [size(k + 2), size(k + 3)]];
            let mut at = block(0);
            let own = if weak == Some(i) { 1e-3 } else { 4.0 };
            at[0][0] += own;
            at[1][1] += own;
            BlockRow { before: block(4), at, after: block(8), right: block(12) }
        }
    }

    #[test]
    fn parts_have_the_solution_of_the_whole() {
        for (count, weak) in [(2 * PART, None), (3 * PART + 5, Some(2 * PART)), (5 * PART - 1, None)] {
            for is_cyclic in [false, true] {
                let row = rows(weak);
                let whole = if is_cyclic { cyclic_solution(count, &row) } else { open_solution(count, &row) };
                let separators = Separators::new(count, is_cyclic, &row).expect("the rows fade");
                let mut room = Elimination::default();
                for part in 0..separators.part_count() {
                    separators.solve(part, &row, &mut room);
                    for (at, own) in (separators.part(part).start..).zip(&room.unknowns) {
                        for (a, b) in own.as_flattened().iter().zip(whole[at % count].as_flattened()) {
                            assert!((a - b).abs() < 1e-13 * (1.0 + b.abs()), "row {at}: {a} and {b}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn what_does_not_fade_is_not_cut() {
        // Each unknown is the one before it: nothing is lost on the way.
        let row = |i: usize| BlockRow {
            before: [[if i == 0 { 0.0 } else { -1.0 }]],
            at: [[1.0]],
            after: [[0.0]],
            right: [[if i == 0 { 1.0 } else { 0.0 }; 2]],
        };
        assert!(Separators::<1>::new(4 * PART, false, &row).is_none());
        assert!(Separators::<1>::new(PART, false, &rows_of_one()).is_none());
    }

    fn rows_of_one() -> impl Fn(usize) -> BlockRow<1> + Sync {
        |_| BlockRow { before: [[1.0]], at: [[4.0]], after: [[1.0]], right: [[1.0; 2]] }
    }
}
