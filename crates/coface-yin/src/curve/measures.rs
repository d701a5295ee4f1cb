//! Area and length.

use super::bernstein::{self, Piece};
use super::hermite::binomial;
use super::{Curve, distance};
use coface_algebra::Rational;
use coface_geometry::Sum;
use coface_geometry::predicates::{Dyadic, PlanarPoint, approximate_area};

/// The part of the area of a polygon that may be wrong.
const RELATIVE: f64 = 1.0 / (1u64 << 50) as f64;
/// Corners that are summed before sums are: bounds on errors grow with the length of a sum.
const BLOCK: usize = 256;

/// The weights of $(b_i - b_0) \times (b_j - b_0)$ for $0 < i < j$ in the area between a piece and its chord, by i and j.
///
/// $\frac12 \int (B_i B_j' - B_i' B_j)$, by the integrals of products of Bernstein polynomials.
fn bulge_weights(degree: usize) -> Vec<(usize, usize, f64)> {
    let half = |i: usize, j: usize| {
        // The integral of B_i B_j', doubled.
        let product = |k: usize| binomial(degree - 1, k) / binomial(2 * degree - 1, i + k);
        let below = if j == 0 { 0.0 } else { product(j - 1) };
        let above = if j == degree { 0.0 } else { product(j) };
        binomial(degree, i) * (below - above)
    };
    let pairs = (1..degree).flat_map(|i| (i + 1..=degree).map(move |j| (i, j)));
    pairs.map(|(i, j)| (i, j, 0.25 * (half(i, j) - half(j, i)))).collect()
}

/// The area between a piece and its chord, positive where the piece is to the right of the chord.
fn bulge(controls: &[[f64; 2]], weights: &[(usize, usize, f64)]) -> f64 {
    let way = |j: usize| [0, 1].map(|axis| controls[j][axis] - controls[0][axis]);
    let pair = |i: usize, j: usize| {
        let ([ax, ay], [bx, by]) = (way(i), way(j));
        ax * by - ay * bx
    };
    weights.iter().map(|&(i, j, weight)| weight * pair(i, j)).sum()
}

/// The area within a closed polygon given without its first corner again, with a relative error below $2^{-49}$, or exactly rounded.
fn polygon_area(corners: &[[f64; 2]]) -> f64 {
    let (mut sum, mut error) = (Sum::default(), 0.0);
    for from in (1..corners.len()).step_by(BLOCK) {
        let fan = &corners[from..(from + BLOCK + 1).min(corners.len())];
        let walk = std::iter::once(&corners[0]).chain(fan).map(|&corner| PlanarPoint::given(corner));
        let Some([area, bound]) = approximate_area(std::iter::once(walk)) else {
            return exact_area(corners).to_f64();
        };
        sum.add(area);
        error += bound;
    }
    let area = sum.value();
    if area.abs() * RELATIVE > error * (1.0 + RELATIVE) { area } else { exact_area(corners).to_f64() }
}

fn exact_area(corners: &[[f64; 2]]) -> Rational {
    let mut doubled = Dyadic::from(0.0);
    let way =
        |corner: [f64; 2]| [0, 1].map(|axis| &Dyadic::from(corner[axis]) - &Dyadic::from(corners[0][axis]));
    for pair in corners.windows(2) {
        let (a, b) = (way(pair[0]), way(pair[1]));
        doubled = &doubled + &(&(&a[0] * &b[1]) - &(&a[1] * &b[0]));
    }
    doubled.quotient(&Dyadic::from(2.0))
}

impl Curve<'_> {
    /// The area within the curve, positive where it runs counterclockwise around it; an open curve is closed by the segment from its end
    /// to its beginning.
    ///
    /// $\frac12 \oint x \, dy - y \, dx$: the area of the polygon through the knots with a relative error below $2^{-49}$, in twice the
    /// usual precision, and the areas between the pieces and their chords. So straight pieces count as exactly as polygons do.
    ///
    /// # Complexity
    /// Linear in the pieces.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let triangle = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0], [0.0, 0.0]])?;
    /// assert_eq!(triangle.signed_area(), 6.0);
    /// assert_eq!(triangle.reversed().signed_area(), -6.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn signed_area(&self) -> f64 {
        let degree = self.order().degree();
        let mut corners: Vec<[f64; 2]> = self.controls().iter().step_by(degree).copied().collect();
        if self.is_closed() {
            corners.pop();
        }
        let polygon = polygon_area(&corners);
        let weights = bulge_weights(degree);
        let mut sum = Sum::default();
        let mut is_polygon = true;
        for piece in 0..self.piece_count() {
            let controls = self.piece(piece);
            if !bernstein::is_straight(controls) {
                is_polygon = false;
                sum.add(bulge(controls, &weights));
            }
        }
        if is_polygon {
            return polygon;
        }
        sum.add(polygon);
        sum.value()
    }

    /// The length of the curve, with an error of at most `tolerance` (an absolute length) as far as the rounding of numbers allows.
    ///
    /// Straight pieces have the distance of their ends. Others are halved until Gauss-Legendre quadrature of the speed with eight nodes
    /// on a part agrees with that on its halves; the tolerance is shared in proportion to the parameter.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order};
    /// let circle = Curve::circle([0.0, 0.0], 1.0, 1024, Order::CUBIC)?;
    /// assert!((circle.length(1e-13) - std::f64::consts::TAU).abs() < 2e-11);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn length(&self, tolerance: f64) -> f64 {
        let rule = gauss_legendre();
        let [first, last] = self.range();
        let mut sum = Sum::default();
        for piece in 0..self.piece_count() {
            let controls = self.piece(piece);
            if bernstein::is_straight(controls) {
                sum.add(distance(controls[0], controls[controls.len() - 1]));
                continue;
            }
            let velocity = bernstein::derivative(controls);
            let share = tolerance * self.piece_length(piece) / (last - first);
            sum.add(speed_integral(&velocity, [0.0, 1.0], share, &rule));
        }
        sum.value()
    }
}

/// Deeper intervals are not halved: speeds are not smooth only at isolated zeros of the velocity.
const DEEPEST: u32 = 48;

/// The length of a piece between two of its parameters in [0, 1], as [`Curve::length`] has it.
pub(crate) fn length_between(controls: &[[f64; 2]], [from, to]: [f64; 2], tolerance: f64) -> f64 {
    if bernstein::is_straight(controls) {
        return (to - from) * distance(controls[0], controls[controls.len() - 1]);
    }
    speed_integral(&bernstein::derivative(controls), [from, to], tolerance, &gauss_legendre())
}

fn speed_integral(velocity: &Piece, [from, to]: [f64; 2], tolerance: f64, rule: &[[f64; 2]; 8]) -> f64 {
    let integral = |low: f64, high: f64| {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let speed = |s: f64| {
            let [x, y] = bernstein::value(velocity, s);
            distance([0.0; 2], [x, y])
        };
        rule.iter().map(|&[node, weight]| weight * speed(middle + half * node)).sum::<f64>() * half
    };
    let mut sum = Sum::default();
    let mut intervals = vec![(from, to, integral(from, to), 0)];
    while let Some((low, high, whole, depth)) = intervals.pop() {
        let middle = 0.5 * (low + high);
        let halves = [integral(low, middle), integral(middle, high)];
        let found = halves[0] + halves[1];
        let bound = (tolerance * (high - low)).max(8.0 * f64::EPSILON * found);
        if (found - whole).abs() <= bound || depth == DEEPEST {
            sum.add(found);
        } else {
            intervals.push((middle, high, halves[1], depth + 1));
            intervals.push((low, middle, halves[0], depth + 1));
        }
    }
    sum.value()
}

/// The nodes in (-1, 1) and weights of Gauss-Legendre quadrature with eight nodes, by Newton's method on the Legendre polynomial.
pub(crate) fn gauss_legendre() -> [[f64; 2]; 8] {
    const COUNT: usize = 8;
    std::array::from_fn(|i| {
        let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (COUNT as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..6 {
            let (mut value, mut before) = (x, 1.0);
            for k in 2..=COUNT {
                let k = k as f64;
                (value, before) = (((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k, value);
            }
            slope = COUNT as f64 * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        [x, 2.0 / ((1.0 - x * x) * slope * slope)]
    })
}
