//! Polynomials of degree d = 2N + 1 by their values and first N derivatives at both ends.

/// A column of numbers for x and one for y.
pub(super) type Columns<const N: usize> = [[f64; 2]; N];
/// A matrix by rows.
pub(super) type Block<const N: usize> = [[f64; N]; N];

/// What the ends of one piece say about its higher derivatives and its control points.
///
/// On [0, 1], with values $f_0$ and $f_1$, the derivatives of degree r = N + 1, ..., 2N at 1 are
/// $D_r = E_r (f_1 - f_0) + \sum_k A_{rk} f_0^{(k)} + B_{rk} f_1^{(k)}$ with k = 1, ..., N; all coefficients are integers.
pub(super) struct HermiteRules<const N: usize> {
    value: [f64; N],
    far: Block<N>,
    near: Block<N>,
    /// Row j, column k: what the derivative of degree k + 1 adds to control point j + 1, counted from the end where it is.
    control: Block<N>,
}

fn factorial(n: usize) -> f64 {
    (1..=n).map(|k| k as f64).product()
}

pub(super) fn binomial(n: usize, k: usize) -> f64 {
    if k > n { 0.0 } else { (factorial(n) / factorial(k) / factorial(n - k)).round() }
}

fn sign(exponent: usize) -> f64 {
    if exponent.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// One row of blocks of a linear system: what stands before, at and after its place, and the right side.
#[derive(Clone, Copy)]
pub(super) struct BlockRow<const N: usize> {
    pub(super) before: Block<N>,
    pub(super) at: Block<N>,
    pub(super) after: Block<N>,
    pub(super) right: Columns<N>,
}

impl<const N: usize> BlockRow<N> {
    /// The row that says what the derivatives at its place are.
    pub(super) fn known(right: Columns<N>) -> Self {
        let mut at = [[0.0; N]; N];
        for (k, row) in at.iter_mut().enumerate() {
            row[k] = 1.0;
        }
        Self { at, right, ..Self::empty() }
    }

    fn empty() -> Self {
        Self { before: [[0.0; N]; N], at: [[0.0; N]; N], after: [[0.0; N]; N], right: [[0.0; 2]; N] }
    }
}

/// The length of a piece in its parameter, and its last point minus its first.
#[derive(Clone, Copy)]
pub(super) struct Chord {
    pub(super) length: f64,
    pub(super) way: [f64; 2],
}

impl<const N: usize> HermiteRules<N> {
    const DEGREE: usize = 2 * N + 1;

    pub(super) fn new() -> Self {
        let (d, degrees) = (Self::DEGREE, N + 1..=2 * N);
        let mut rules =
            Self { value: [0.0; N], far: [[0.0; N]; N], near: [[0.0; N]; N], control: [[0.0; N]; N] };
        for (row, r) in degrees.enumerate() {
            for i in 0..=r {
                // Control point d - r + i, the (r - i)-th from the end, in the r-th difference at the end.
                let (from_start, from_end) = (d - r + i, r - i);
                let part = sign(r - i) * binomial(r, i) / factorial(d - r);
                if from_end <= N {
                    rules.value[row] += part * factorial(d);
                }
                for k in 1..=N {
                    let factor = part * factorial(d - k);
                    if from_end <= N {
                        rules.near[row][k - 1] += factor * sign(k) * binomial(from_end, k);
                    } else {
                        rules.far[row][k - 1] += factor * binomial(from_start, k);
                    }
                }
            }
        }
        for j in 1..=N {
            for k in 1..=j {
                rules.control[j - 1][k - 1] = binomial(j, k) * factorial(d - k) / factorial(d);
            }
        }
        rules
    }

    /// The row of a knot at which the derivatives of degree N + 1 to 2N of the pieces on its sides agree, or are zero where
    /// there is no piece on one side; multiplied by powers of the shorter length, so that its numbers are neither large nor small.
    #[inline(always)]
    pub(super) fn smooth_row(&self, [before, after]: [Option<Chord>; 2]) -> BlockRow<N> {
        let unit = match (before, after) {
            (Some(before), Some(after)) => before.length.min(after.length),
            (only, other) => only.or(other).map_or(1.0, |side| side.length),
        };
        let mut row = BlockRow::empty();
        if let Some(chord) = before {
            self.add_side::<false>(&mut row, unit, chord);
        }
        if let Some(chord) = after {
            self.add_side::<true>(&mut row, unit, chord);
        }
        row
    }

    /// Adds the terms of one side. The piece after the knot is the mirror image of one before it.
    #[inline(always)]
    fn add_side<const IS_AFTER: bool>(&self, row: &mut BlockRow<N>, unit: f64, chord: Chord) {
        let ratio = unit / chord.length;
        let mut power = ratio;
        for _ in 1..N {
            power *= ratio;
        }
        let length = if IS_AFTER { -chord.length } else { chord.length };
        for at in 0..N {
            // The derivative of degree r = N + 1 + at; its sign changes with the side where r is even.
            power *= ratio;
            let is_turned = IS_AFTER && (N + 1 + at).is_multiple_of(2);
            let mut factor = if is_turned { -power } else { power };
            let value = if IS_AFTER { factor } else { -factor } * self.value[at];
            for axis in 0..2 {
                row.right[at][axis] += value * chord.way[axis];
            }
            for k in 0..N {
                factor *= length;
                row.at[at][k] += factor * self.near[at][k];
                let far = if IS_AFTER { &mut row.after } else { &mut row.before };
                far[at][k] = factor * self.far[at][k];
            }
        }
    }

    /// The row of a first knot that says that the first piece runs through N points at parameters in (0, 1), given relative to
    /// the first knot; or with `is_mirrored` of a last knot, all counted from there.
    pub(super) fn through(
        &self,
        chord: Chord,
        points: [(f64, [f64; 2]); N],
        is_mirrored: bool,
    ) -> BlockRow<N> {
        let (d, mut row) = (Self::DEGREE, BlockRow::empty());
        for (at, (s, way)) in points.into_iter().enumerate() {
            let basis = |j: usize| binomial(d, j) * s.powi(j as i32) * (1.0 - s).powi((d - j) as i32);
            row.right[at] = way;
            for j in 0..=N {
                for axis in 0..2 {
                    row.right[at][axis] -= basis(d - j) * chord.way[axis];
                }
            }
            let mut power = 1.0;
            for k in 1..=N {
                power *= if is_mirrored { -chord.length } else { chord.length };
                for j in k..=N {
                    let control = power * self.control[j - 1][k - 1];
                    row.at[at][k - 1] += control * basis(j);
                    let far = if is_mirrored { &mut row.before } else { &mut row.after };
                    far[at][k - 1] += control * sign(k) * basis(d - j);
                }
            }
        }
        row
    }

    /// The piece of a length between two points with these derivatives there: its control points but the last one, in order.
    #[inline(always)]
    pub(super) fn for_each_control(
        &self,
        length: f64,
        ends: [[f64; 2]; 2],
        derivatives: [&Columns<N>; 2],
        mut give: impl FnMut([f64; 2]),
    ) {
        let mut powers = [length; N];
        for k in 1..N {
            powers[k] = powers[k - 1] * length;
        }
        let control = |j: usize, end: usize| {
            let mut point = ends[end];
            for k in 0..j {
                let factor = self.control[j - 1][k] * powers[k];
                let factor = if end == 1 && k % 2 == 0 { -factor } else { factor };
                for axis in 0..2 {
                    point[axis] += factor * derivatives[end][k][axis];
                }
            }
            point
        };
        give(ends[0]);
        for j in 1..=N {
            give(control(j, 0));
        }
        for j in (1..=N).rev() {
            give(control(j, 1));
        }
    }
}
