//! Parts of polynomials that know the polynomial they are a part of.

use super::Curve;
use super::bernstein::{self, Piece};
use coface_algebra::{Error, ErrorKind};

/// The whole polynomial that a piece of a curve is a part of, and which part: its **carrier**.
///
/// A piece that Boolean operations cut out of another one is rounded, so its control points alone do not say exactly on which curve it
/// lies. Its carrier does. Pieces with the same carrier have exactly those points in common that their ranges have in common: that is
/// decided by comparing parameters, not points. A piece without a carrier is its own carrier.
///
/// Parameters on carriers are multiples of $2^{-53}$, so that $t \\mapsto 1 - t$ is exact: a carrier and its reverse are the same.
///
/// # Examples
/// Half of a triangle: the cut side knows the whole one.
/// ```
/// use coface_yin::{Curve, Order, YinSet};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let set = |corners: &[[f64; 2]]| YinSet::new(&[Curve::polyline(corners)?.raised(Order::CUBIC)?]);
/// let triangle = set(&[[0., 0.], [3., 0.], [0., 3.], [0., 0.]])?;
/// let left = set(&[[-1., -1.], [1.5, -1.], [1.5, 9.], [-1., 9.], [-1., -1.]])?;
/// let half = triangle.meet(&left)?;
/// let curve = half.curve(0);
/// let cut = &curve.carriers()[0];
/// assert_eq!((cut.piece(), cut.range()), (0, [0.0, 0.5]));
/// assert_eq!(cut.controls(), [[0., 0.], [1., 0.], [2., 0.], [3., 0.]]);
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carrier {
    piece: u32,
    controls: Piece,
    range: [f64; 2],
    growth: f64,
}

impl Carrier {
    /// The carrier of a piece of a curve.
    ///
    /// The range falls where the piece runs against its carrier; `growth` is how much the parameter of a curve grows along the whole
    /// carrier.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for as many control points as no order has; [`ErrorKind::InvalidInput`] for numbers that are not finite,
    /// a range that is empty or not within 0 and 1, or a growth that is not positive.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Carrier;
    /// let carrier = Carrier::new(2, &[[0.0, 0.0], [3.0, 0.0]], [0.5, 1.0], 3.0)?;
    /// assert_eq!(carrier.range(), [0.5, 1.0]);
    /// assert!(Carrier::new(2, &[[0.0, 0.0], [3.0, 0.0]], [0.5, 1.5], 3.0).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(piece: u32, controls: &[[f64; 2]], range: [f64; 2], growth: f64) -> Result<Self, Error> {
        if !(2..=Piece::MOST).contains(&controls.len()) || !controls.len().is_multiple_of(2) {
            let message = format!("{} control points make no carrier of a piece", controls.len());
            return Err(Error::new(ErrorKind::Shape, message)
                .with_cure("give as many control points as the order of the curve"));
        }
        let is_finite = controls.as_flattened().iter().all(|x| x.is_finite());
        let is_range = range.iter().all(|t| (0.0..=1.0).contains(t)) && range[0] != range[1];
        let is_growth = growth > 0.0 && growth.is_finite();
        if !(is_finite && is_range && is_growth) {
            return Err(Error::invalid(format!("the carrier of piece {piece} is none"))
                .with_cure("give finite control points, a range between 0 and 1 and a positive growth"));
        }
        Ok(Self { piece, controls: Piece::new(controls), range: range.map(on_grid), growth })
    }

    pub(crate) fn from_trusted(piece: u32, controls: Piece, range: [f64; 2], growth: f64) -> Self {
        Self { piece, controls, range, growth }
    }

    /// The piece of the curve.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Carrier;
    /// let carrier = Carrier::new(2, &[[0.0, 0.0], [3.0, 0.0]], [0.5, 1.0], 3.0)?;
    /// assert_eq!(carrier.piece(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn piece(&self) -> u32 {
        self.piece
    }

    /// The control points of the whole polynomial.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Carrier;
    /// let carrier = Carrier::new(2, &[[0.0, 0.0], [3.0, 0.0]], [0.5, 1.0], 3.0)?;
    /// assert_eq!(carrier.controls(), [[0.0, 0.0], [3.0, 0.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn controls(&self) -> &[[f64; 2]] {
        &self.controls
    }

    /// The parameters on the carrier at which the piece begins and ends; they fall where it runs against it.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Carrier;
    /// let carrier = Carrier::new(2, &[[0.0, 0.0], [3.0, 0.0]], [0.5, 0.0], 3.0)?;
    /// assert_eq!(carrier.range(), [0.5, 0.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// How much the parameter of a curve grows along the whole carrier.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Carrier;
    /// let carrier = Carrier::new(2, &[[0.0, 0.0], [3.0, 0.0]], [0.5, 1.0], 3.0)?;
    /// assert_eq!(carrier.growth(), 3.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn growth(&self) -> f64 {
        self.growth
    }

    pub(super) fn mapped(&self, stretch: f64, map: impl Fn(&[[f64; 2]]) -> Piece) -> Self {
        Self { controls: map(&self.controls), growth: self.growth * stretch, ..*self }
    }

    /// The carrier of the reverse of the piece, which has this number on its curve.
    pub(crate) fn reversed(&self, piece: u32) -> Self {
        Self { piece, range: [self.range[1], self.range[0]], ..*self }
    }

    /// The same for the piece of this number.
    pub(crate) fn of_piece(self, piece: u32) -> Self {
        Self { piece, ..self }
    }

    /// Whether the part of the carrier is the piece with these control points, up to the largest resolution of Boolean operations.
    fn carries(&self, controls: &[[f64; 2]]) -> bool {
        /// Of the size of what operations put together.
        const CLOSE: f64 = 1.0 / (1u64 << 26) as f64;
        let [low, high] = bernstein::control_box(&self.controls);
        let largest = [low, high].as_flattened().iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        let close = CLOSE * extent + 64.0 * f64::EPSILON * largest;
        controls.len() == self.controls.len()
            && bernstein::sub_range(&self.controls, self.range)
                .iter()
                .zip(controls)
                .all(|(a, b)| (0..2).all(|axis| (a[axis] - b[axis]).abs() <= close))
    }
}

/// The multiple of 2^-53 nearest to a parameter between 0 and 1.
pub(crate) fn on_grid(t: f64) -> f64 {
    if t < 0.5 { (t + 0.5) - 0.5 } else { t }
}

impl Curve<'_> {
    /// The carriers of pieces that are parts of others, by rising pieces. The others are whole.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// assert!(Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0]])?.carriers().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn carriers(&self) -> &[Carrier] {
        &self.carriers
    }

    /// The same curve with carriers of its pieces, as they are read from a file.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a piece that is not there, comes twice or is no part of its carrier.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Carrier, Curve};
    /// let curve = Curve::polyline(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]])?;
    /// let carrier = |end| Carrier::new(0, &[[0.0, 0.0], [end, end]], [0.0, 0.25], 1.0);
    /// assert_eq!(curve.clone().with_carriers(vec![carrier(4.0)?])?.carriers().len(), 1);
    /// assert!(curve.with_carriers(vec![carrier(5.0)?]).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn with_carriers(self, mut carriers: Vec<Carrier>) -> Result<Self, Error> {
        carriers.sort_by_key(Carrier::piece);
        let is_twice = |at: usize| at > 0 && carriers[at - 1].piece == carriers[at].piece;
        let is_wrong = |at: usize| {
            let piece = carriers[at].piece as usize;
            piece >= self.piece_count() || is_twice(at) || !carriers[at].carries(self.piece(piece))
        };
        if let Some(at) = (0..carriers.len()).find(|&at| is_wrong(at)) {
            return Err(Error::invalid(format!("piece {} is no part of its carrier", carriers[at].piece))
                .with_cure("leave the carriers out, or write the set anew"));
        }
        Ok(self.carried_by(carriers))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reverse_of_a_parameter_on_the_grid_is_exact() {
        for t in [1e-30, 1e-17, 1e-9, 0.1, 0.3, 1.0 / 3.0, 0.499_999_999, 0.5, 0.7, 1.0 - 1e-16] {
            let own = on_grid(t);
            assert_eq!(1.0 - (1.0 - own), own);
            assert!((own - t).abs() <= f64::EPSILON / 4.0);
            assert_eq!(on_grid(own), own);
        }
    }
}
