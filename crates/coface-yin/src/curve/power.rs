//! Pieces by the coefficients of powers, as files have them.

use super::bernstein::{self, Piece};
use super::hermite::binomial;
use super::{Curve, Order};
use coface_algebra::{Error, ErrorKind};

impl Curve<'_> {
    /// The coefficients of a piece by powers of the parameter less the knot where the piece begins, the constant one first, rounded.
    ///
    /// # Panics
    /// If there is no such piece.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let curve = Curve::polyline(&[[1.0, 2.0], [4.0, 6.0]])?;
    /// assert_eq!(curve.power_coefficients(0), [[1.0, 2.0], [0.6, 0.8]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn power_coefficients(&self, piece: usize) -> Vec<[f64; 2]> {
        let degree = self.order().degree();
        let mut differences = self.piece(piece).to_vec();
        let is_straight = bernstein::is_straight(&differences);
        let length = self.piece_length(piece);
        (0..=degree)
            .map(|k| {
                if is_straight && k > 0 {
                    let [a, b] = [self.piece(piece)[0], self.piece(piece)[degree]];
                    return if k == 1 { [0, 1].map(|axis| (b[axis] - a[axis]) / length) } else { [0.0; 2] };
                }
                let own = differences[0].map(|x| (0..k).fold(binomial(degree, k) * x, |x, _| x / length));
                for j in 0..differences.len() - 1 {
                    differences[j] = [0, 1].map(|axis| differences[j + 1][axis] - differences[j][axis]);
                }
                differences.pop();
                own
            })
            .collect()
    }
}

impl Curve<'static> {
    /// A curve from the coefficients of its pieces by powers of the parameter less the knot where a piece begins: as many for
    /// each piece as the order, the constant one first.
    ///
    /// Pieces begin at their constant coefficient, and where the one before ends elsewhere by at most `tolerance` (an absolute length), it
    /// is made to end there; so is the last piece made to end where the first begins. Pieces without higher coefficients are straight.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] when the counts do not fit together; [`ErrorKind::InvalidInput`] naming a piece that does not begin where the
    /// one before it ends, a number that is not finite or a knot that does not rise.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order};
    /// let parabola = [[0.0, 0.0], [1.0, 2.0], [0.0, -1.0], [0.0, 0.0]];
    /// let curve = Curve::from_power(Order::CUBIC, vec![0.0, 2.0], &parabola, 1e-12)?;
    /// assert_eq!(curve.point(1.0), [1.0, 1.0]);
    /// assert!((curve.power_coefficients(0)[2][1] + 1.0).abs() < 1e-15);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn from_power(
        order: Order,
        knots: Vec<f64>,
        coefficients: &[[f64; 2]],
        tolerance: f64,
    ) -> Result<Self, Error> {
        let piece_count = knots.len().saturating_sub(1);
        if piece_count == 0 || coefficients.len() != piece_count * order.value() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "{} coefficients and {} knots make no curve of order {order}",
                    coefficients.len(),
                    knots.len()
                ),
            )
            .with_cure(format!("give {order} coefficients a piece")));
        }
        let degree = order.degree();
        let pieces: Vec<Piece> = coefficients
            .chunks_exact(order.value())
            .zip(knots.windows(2))
            .map(|(own, range)| of_powers(own, range[1] - range[0]))
            .collect();
        let mut controls = Vec::with_capacity(piece_count * degree + 1);
        for at in 0..piece_count {
            let end = pieces[at][degree];
            let next = pieces[(at + 1) % piece_count][0];
            let miss = (end[0] - next[0]).hypot(end[1] - next[1]);
            let meets = miss <= tolerance;
            if at + 1 < piece_count && !meets {
                return Err(Error::invalid(format!(
                    "piece {} begins {miss} from where piece {at} ends",
                    at + 1
                ))
                .with_cure("give pieces that are joined, or a larger tolerance"));
            }
            let ends = [pieces[at][0], if meets { next } else { end }];
            let linear =
                coefficients[at * order.value()..][..order.value()][2..].iter().all(|c| *c == [0.0; 2]);
            let piece = if linear {
                bernstein::straight_piece(ends, order.value())
            } else {
                pieces[at].between(ends)
            };
            controls.extend_from_slice(&piece[..degree]);
            if at + 1 == piece_count {
                controls.push(ends[1]);
            }
        }
        Self::from_controls(order, controls, knots)
    }
}

fn of_powers(coefficients: &[[f64; 2]], length: f64) -> Piece {
    let degree = coefficients.len() - 1;
    Piece::with(coefficients.len(), |j| {
        [0, 1].map(|axis| {
            let term = |k: usize| {
                let scaled = (0..k).fold(coefficients[k][axis], |x, _| x * length);
                binomial(j, k) / binomial(degree, k) * scaled
            };
            (0..=j).rev().map(term).sum()
        })
    })
}
