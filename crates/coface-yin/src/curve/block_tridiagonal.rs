//! Linear systems whose matrix has blocks on its diagonal and beside it, open or running around a circle.
//!
//! One elimination serves the columns for x and for y.

use super::hermite::{Block, BlockRow, Columns};

#[inline(always)]
pub(super) fn product<const N: usize, const M: usize>(a: &Block<N>, b: &[[f64; M]; N]) -> [[f64; M]; N] {
    let mut found = [[0.0; M]; N];
    for i in 0..N {
        for j in 0..N {
            for k in 0..M {
                found[i][k] += a[i][j] * b[j][k];
            }
        }
    }
    found
}

#[inline(always)]
pub(super) fn less<const N: usize, const M: usize>(mut a: [[f64; M]; N], b: &[[f64; M]; N]) -> [[f64; M]; N] {
    for (row, other) in a.iter_mut().zip(b) {
        for (x, y) in row.iter_mut().zip(other) {
            *x -= y;
        }
    }
    a
}

/// The inverse by elimination with row pivots; not finite where there is none.
#[inline(always)]
pub(super) fn inverse<const N: usize>(mut a: Block<N>) -> Block<N> {
    let mut found = [[0.0; N]; N];
    for (i, row) in found.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    if N == 1 {
        return [[1.0 / a[0][0]; N]; N];
    }
    for column in 0..N {
        let mut pivot = column;
        for row in column + 1..N {
            if a[row][column].abs() > a[pivot][column].abs() {
                pivot = row;
            }
        }
        a.swap(column, pivot);
        found.swap(column, pivot);
        let factor = 1.0 / a[column][column];
        for k in 0..N {
            a[column][k] *= factor;
            found[column][k] *= factor;
        }
        for row in 0..N {
            let factor = a[row][column];
            if row != column && factor != 0.0 {
                for k in 0..N {
                    a[row][k] -= factor * a[column][k];
                    found[row][k] -= factor * found[column][k];
                }
            }
        }
    }
    found
}

/// The unknowns of an open system, one for each row. The rows are asked for in order.
///
/// # Complexity
/// Linear in the rows; not finite for a singular system.
pub(super) fn open_solution<const N: usize>(
    count: usize,
    row: impl Fn(usize) -> BlockRow<N>,
) -> Vec<Columns<N>> {
    let mut ahead: Vec<Block<N>> = Vec::with_capacity(count);
    let mut found: Vec<Columns<N>> = Vec::with_capacity(count);
    let mut last = ([[0.0; N]; N], [[0.0; 2]; N]);
    for at in 0..count {
        let row = row(at);
        let pivot = inverse(less(row.at, &product(&row.before, &last.0)));
        last =
            (product(&pivot, &row.after), product(&pivot, &less(row.right, &product(&row.before, &last.1))));
        ahead.push(last.0);
        found.push(last.1);
    }
    for at in (0..count.saturating_sub(1)).rev() {
        last.1 = less(found[at], &product(&ahead[at], &last.1));
        found[at] = last.1;
    }
    found
}

/// What is this small next to numbers of ordinary size has no effect on them.
const NOTHING: f64 = 1e-250;

#[inline(always)]
pub(super) fn is_nothing<const N: usize>(block: &Block<N>) -> bool {
    block.iter().flatten().all(|x| x.abs() < NOTHING)
}

/// The unknowns of a system of at least three rows, the first of which comes after the last.
///
/// All are expressed by the last one, of which the others depend the less the farther they are from it.
///
/// # Complexity
/// As [`open_solution`].
pub(super) fn cyclic_solution<const N: usize>(
    count: usize,
    row: impl Fn(usize) -> BlockRow<N>,
) -> Vec<Columns<N>> {
    let open = count - 1;
    let mut ahead: Vec<Block<N>> = Vec::with_capacity(open);
    let mut found: Vec<Columns<N>> = Vec::with_capacity(count);
    // How the first rows depend on the last unknown, as far as they do.
    let mut wrapped: Vec<Block<N>> = Vec::new();
    let mut last = ([[0.0; N]; N], [[0.0; 2]; N]);
    let mut last_wrapped = None;
    for at in 0..open {
        let BlockRow { before, at: middle, after, right } = row(at);
        let zero = [[0.0; N]; N];
        let pivot = inverse(less(middle, &product(&before, &last.0)));
        let mut own = if at == 0 { before } else { zero };
        if let Some(wrapped) = &last_wrapped {
            own = less(own, &product(&before, wrapped));
        }
        let own = product(&pivot, &own);
        let is_last = at + 1 == open;
        let next = product(&pivot, &after);
        last_wrapped = if is_last {
            // What comes next is the last unknown.
            Some(sum(own, &next))
        } else if (at == 0 || last_wrapped.is_some()) && !is_nothing(&own) {
            wrapped.push(own);
            Some(own)
        } else {
            None
        };
        last = (if is_last { zero } else { next }, product(&pivot, &less(right, &product(&before, &last.1))));
        ahead.push(last.0);
        found.push(last.1);
    }
    // Backward: the unknowns are found[i] minus dependence[i] times the last one.
    let mut dependence = last_wrapped.unwrap_or([[0.0; N]; N]);
    let mut dependences = vec![(open - 1, dependence)];
    for at in (0..open - 1).rev() {
        found[at] = less(found[at], &product(&ahead[at], &found[at + 1]));
        if at < wrapped.len() || !is_nothing(&dependence) {
            let own = wrapped.get(at).copied().unwrap_or([[0.0; N]; N]);
            dependence = less(own, &product(&ahead[at], &dependence));
            dependences.push((at, dependence));
        }
    }
    let BlockRow { before, at, after, right } = row(open);
    let at = less(less(at, &product(&before, &dependences[0].1)), &product(&after, &dependence));
    let right = less(less(right, &product(&before, &found[open - 1])), &product(&after, &found[0]));
    let last = product(&inverse(at), &right);
    for (at, dependence) in dependences {
        found[at] = less(found[at], &product(&dependence, &last));
    }
    found.push(last);
    found
}

fn sum<const N: usize>(mut a: Block<N>, b: &Block<N>) -> Block<N> {
    for (row, other) in a.iter_mut().zip(b) {
        for (x, y) in row.iter_mut().zip(other) {
            *x += y;
        }
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solutions_satisfy_their_rows() {
        let mut state = 1u64;
        let mut random = || {
            state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        for count in [3, 4, 5, 17, 2000] {
            let rows: Vec<BlockRow<2>> = (0..count)
                .map(|_| {
                    let mut block = |size: f64| {
                        let mut block = [[0.0; 2]; 2];
                        block.iter_mut().flatten().for_each(|x| *x = size * random());
                        block
                    };
                    let (before, after, mut at, right) = (block(1.0), block(1.0), block(1.0), block(1.0));
                    at[0][0] += 4.0;
                    at[1][1] += 4.0;
                    BlockRow { before, at, after, right }
                })
                .collect();
            let row = |i: usize| {
                let BlockRow { before, at, after, right } = &rows[i];
                BlockRow { before: *before, at: *at, after: *after, right: *right }
            };
            let miss = |found: &[Columns<2>], is_cyclic: bool| {
                (0..count).fold(0.0, |miss: f64, i| {
                    let own = row(i);
                    let mut rest = less(own.right, &product(&own.at, &found[i]));
                    if i > 0 || is_cyclic {
                        rest = less(rest, &product(&own.before, &found[(i + count - 1) % count]));
                    }
                    if i + 1 < count || is_cyclic {
                        rest = less(rest, &product(&own.after, &found[(i + 1) % count]));
                    }
                    rest.iter().flatten().fold(miss, |miss, x| miss.max(x.abs()))
                })
            };
            assert!(miss(&open_solution(count, row), false) < 1e-14);
            assert!(miss(&cyclic_solution(count, row), true) < 1e-14);
        }
    }
}
