//! Curved strips: what lies along the graph of a cubic polynomial over one of the axes.
//!
//! A box around a bent arc is as thick as the arc is bent, and one along its chord not much thinner. A strip along a cubic is thinner by
//! the square of the length of the arc again. So long arcs side by side, as of concentric rings, are told apart without being cut into
//! short ones, alone and in groups.

use crate::curve::bernstein;
use coface_geometry::Bounds;

/// The highest degree of what comes from a polynomial of the highest degree in a cubic one.
const MOST_DEGREE: usize = 21;

/// The largest slope of a graph: where points are nearer to each other than a margin, heights differ by at most so many margins.
const STEEPEST: f64 = 8.0;

/// Above what rounding does to a cubic in a few steps of de Casteljau's scheme, in units of its size.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// A strip around points: they lie in a box, and above a cubic polynomial over one axis by something between two numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strip {
    low: [f64; 2],
    high: [f64; 2],
    /// The Bernstein coefficients of the polynomial over the side of the box along the axis.
    graph: [f64; 4],
    /// How far points are above the polynomial, at least and at most.
    offsets: [f64; 2],
    /// The axis that the graph is over.
    axis: Axis,
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Axis {
    X,
    Y,
}

impl Axis {
    fn index(self) -> usize {
        self as usize
    }

    fn other(self) -> usize {
        1 - self.index()
    }
}

/// The sides of a box along both axes, each from the lower to the higher end.
pub(crate) type Window = [[f64; 2]; 2];

fn mean([a, b]: [f64; 2], s: f64) -> f64 {
    (1.0 - s) * a + s * b
}

/// The coefficients of a cubic over the interval between two parameters, which may be outside of [0, 1].
fn restricted(graph: &[f64; 4], [s, t]: [f64; 2]) -> [f64; 4] {
    let [a, b, c, d] = *graph;
    let [ab, bc, cd] = [mean([a, b], s), mean([b, c], s), mean([c, d], s)];
    let [of_ab, of_bc, of_cd] = [mean([a, b], t), mean([b, c], t), mean([c, d], t)];
    let [first, second] = [mean([ab, bc], s), mean([bc, cd], s)];
    let [of_first, of_second] = [mean([of_ab, of_bc], t), mean([of_bc, of_cd], t)];
    [
        mean([first, second], s),
        mean([first, second], t),
        mean([of_first, of_second], s),
        mean([of_first, of_second], t),
    ]
}

fn extremes(numbers: impl IntoIterator<Item = f64>) -> [f64; 2] {
    numbers
        .into_iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], number| [low.min(number), high.max(number)])
}

/// Pascal's triangle: the binomial coefficients of each degree.
const BINOMIALS: [[f64; MOST_DEGREE + 1]; MOST_DEGREE + 1] = {
    let mut rows = [[0.0; MOST_DEGREE + 1]; MOST_DEGREE + 1];
    let mut degree = 0;
    while degree <= MOST_DEGREE {
        rows[degree][0] = 1.0;
        let mut j = 1;
        while j <= degree {
            rows[degree][j] = rows[degree - 1][j - 1] + rows[degree - 1][j];
            j += 1;
        }
        degree += 1;
    }
    rows
};

/// A polynomial of a degree in the Bernstein basis, each coefficient times its binomial: so products are convolutions.
struct Scaled {
    coefficients: [f64; MOST_DEGREE + 1],
    degree: usize,
}

impl Scaled {
    fn constant(value: f64, degree: usize) -> Self {
        Self { coefficients: BINOMIALS[degree].map(|own| own * value), degree }
    }

    fn new(coefficients: impl ExactSizeIterator<Item = f64>) -> Self {
        let mut own = Self::constant(1.0, coefficients.len() - 1);
        own.coefficients.iter_mut().zip(coefficients).for_each(|(own, value)| *own *= value);
        own
    }

    fn times(&self, other: &Self) -> Self {
        let mut product = Self::constant(0.0, self.degree + other.degree);
        for (i, a) in self.coefficients[..=self.degree].iter().enumerate() {
            for (j, b) in other.coefficients[..=other.degree].iter().enumerate() {
                product.coefficients[i + j] += a * b;
            }
        }
        product
    }

    /// The sum with a multiple of a polynomial of the same degree.
    fn plus(mut self, other: &Self, factor: f64) -> Self {
        debug_assert_eq!(self.degree, other.degree);
        let own = self.coefficients[..=self.degree].iter_mut().zip(&other.coefficients);
        own.for_each(|(own, other)| *own += factor * other);
        self
    }

    /// The sum with a constant.
    fn plus_constant(mut self, value: f64) -> Self {
        let own = self.coefficients[..=self.degree].iter_mut().zip(&BINOMIALS[self.degree]);
        own.for_each(|(own, binomial)| *own += value * binomial);
        self
    }

    /// Bounds on the values between 0 and 1.
    fn bounds(&self) -> [f64; 2] {
        let binomials = &BINOMIALS[self.degree];
        extremes((0..=self.degree).map(|j| self.coefficients[j] / binomials[j]))
    }
}

impl Strip {
    /// The box around an arc as a strip, under the conditions of [`Self::of_arc`].
    pub(super) fn boxed(controls: &[[f64; 2]], margin: f64, largest: f64) -> Self {
        let [low, high] = bernstein::control_box(controls);
        let own = Self::flat(low.map(|x| x - margin), high.map(|x| x + margin), Axis::X);
        own.widened(margin, largest)
    }

    /// A strip around an arc, along a cubic through four of its points over an axis. What is no farther than the margin from the arc is
    /// found to be near; `largest` is at least each coordinate of whatever the strip is compared with.
    pub(super) fn of_arc(controls: &[[f64; 2]], axis: Axis, margin: f64, largest: f64) -> Self {
        let [low, high] = bernstein::control_box(controls);
        let [low, high] = [low.map(|x| x - margin), high.map(|x| x + margin)];
        let mut own = Self::flat(low, high, axis);
        let (along, across) = (axis.index(), axis.other());
        let width = high[along] - low[along];
        let place = |x: f64| (x - low[along]) / width;
        // The zeros of the Chebyshev polynomial of degree 4, on [0, 1].
        let points = [
            0.038_060_233_744_356_63,
            0.308_658_283_817_455_1,
            0.691_341_716_182_544_9,
            0.961_939_766_255_643_4,
        ]
        .map(|t| bernstein::value(controls, t));
        let at = points.map(|point| place(point[along]));
        let heights = points.map(|point| point[across]);
        let is_spread = at.windows(2).all(|pair| (pair[1] - pair[0]).abs() > 1.0 / 64.0);
        if is_spread && width > 1024.0 * margin {
            let power = interpolated(at, heights);
            let graph = [
                power[0],
                power[0] + power[1] / 3.0,
                power[0] + (2.0 * power[1] + power[2]) / 3.0,
                power[0] + power[1] + power[2] + power[3],
            ];
            if own.is_tame(&graph) {
                let degree = controls.len() - 1;
                let along = Scaled::new(controls.iter().map(|point| place(point[along])));
                let heights = Scaled::new(controls.iter().map(|point| point[across]));
                let mut sum = Scaled::constant(power[3], 0);
                for &coefficient in power[..3].iter().rev() {
                    sum = along.times(&sum).plus_constant(coefficient);
                }
                let above = heights.times(&Scaled::constant(1.0, 2 * degree)).plus(&sum, -1.0);
                let offsets = above.bounds();
                if offsets[1] - offsets[0] < own.thickness() {
                    (own.graph, own.offsets) = (graph, offsets);
                }
            }
        }
        own.widened(margin, largest)
    }

    /// A strip that has what is within the margin of its points above the graphs of other strips too.
    fn widened(mut self, margin: f64, largest: f64) -> Self {
        let margin = (1.0 + STEEPEST) * margin + 32.0 * ROUNDING * largest;
        self.offsets = [self.offsets[0] - margin, self.offsets[1] + margin];
        self
    }

    /// The strip that is a box.
    fn flat(low: [f64; 2], high: [f64; 2], axis: Axis) -> Self {
        let across = axis.other();
        let middle = 0.5 * low[across] + 0.5 * high[across];
        Self { low, high, graph: [middle; 4], offsets: [low[across] - middle, high[across] - middle], axis }
    }

    /// The axis that the graph is over.
    pub(super) fn axis(&self) -> Axis {
        self.axis
    }

    /// The middle of the box.
    pub(super) fn center(&self) -> [f64; 2] {
        [0, 1].map(|k| 0.5 * self.low[k] + 0.5 * self.high[k])
    }

    /// The sides of the box.
    pub(super) fn window(&self) -> Window {
        [0, 1].map(|k| [self.low[k], self.high[k]])
    }

    fn thickness(&self) -> f64 {
        self.offsets[1] - self.offsets[0]
    }

    /// Whether the strip is the box, and says no more than that.
    fn is_flat(&self) -> bool {
        self.graph.iter().all(|&height| height == self.graph[0])
    }

    /// The side of the box along the axis.
    fn range(&self) -> [f64; 2] {
        [self.low[self.axis.index()], self.high[self.axis.index()]]
    }

    /// Whether a polynomial over the box is not steep and stays near it: so what rounding does to it is known.
    fn is_tame(&self, graph: &[f64; 4]) -> bool {
        let across = self.axis.other();
        let [from, to] = self.range();
        let reach = (to - from) + (self.high[across] - self.low[across]);
        let is_near = |&x: &f64| self.low[across] - reach <= x && x <= self.high[across] + reach;
        let is_gentle = |pair: &[f64]| 3.0 * (pair[1] - pair[0]).abs() <= STEEPEST * (to - from);
        graph.iter().all(is_near) && graph.windows(2).all(is_gentle)
    }

    /// The coefficients of the graph over a range of the axis.
    fn graph_over(&self, range: [f64; 2]) -> [f64; 4] {
        let [from, to] = self.range();
        if from == to { self.graph } else { restricted(&self.graph, range.map(|x| (x - from) / (to - from))) }
    }

    /// How far the points of another strip over the same axis are above a polynomial over this box, where that one is within it.
    fn offsets_of(&self, graph: &[f64; 4], inner: &Self) -> [f64; 2] {
        let own = Self { graph: *graph, ..*self }.graph_over(inner.range());
        let [least, most] = extremes((0..4).map(|j| inner.graph[j] - own[j]));
        let size = extremes(graph.iter().chain(&inner.graph).map(|x| x.abs()))[1];
        let rounding = ROUNDING * (size + extremes(self.range().map(f64::abs))[1]);
        [least + inner.offsets[0] - rounding, most + inner.offsets[1] + rounding]
    }

    /// Whether no point of a window, whose sides rise, is in the strip.
    pub(super) fn misses(&self, window: &Window) -> bool {
        if (0..2).any(|k| self.high[k] < window[k][0] || window[k][1] < self.low[k]) {
            return true;
        }
        if self.is_flat() {
            return false;
        }
        let [from, to] = self.range();
        let [low, high] = window[self.axis.index()];
        let [least, most] = extremes(self.graph_over([low.max(from), high.min(to)]));
        let [bottom, top] = window[self.axis.other()];
        most + self.offsets[1] < bottom || top < least + self.offsets[0]
    }
}

/// The coefficients of the cubic through four points, from the constant one.
fn interpolated(at: [f64; 4], heights: [f64; 4]) -> [f64; 4] {
    let mut differences = heights;
    for step in 1..4 {
        for j in (step..4).rev() {
            differences[j] = (differences[j] - differences[j - 1]) / (at[j] - at[j - step]);
        }
    }
    let mut power = [differences[3], 0.0, 0.0, 0.0];
    for j in (0..3).rev() {
        for k in (1..4).rev() {
            power[k] = power[k - 1] - at[j] * power[k];
        }
        power[0] = differences[j] - at[j] * power[0];
    }
    power
}

impl Bounds for Strip {
    fn around(a: &Self, b: &Self) -> Self {
        let low = [0, 1].map(|k| a.low[k].min(b.low[k]));
        let high = [0, 1].map(|k| a.high[k].max(b.high[k]));
        let mut best = Self::flat(low, high, a.axis);
        if a.axis != b.axis || (a.is_flat() && b.is_flat()) {
            let margin = ROUNDING * extremes(low.into_iter().chain(high).map(f64::abs))[1];
            best.offsets = [best.offsets[0] - margin, best.offsets[1] + margin];
            return best;
        }
        let graphs = [a, b].map(|own| own.graph_over(best.range()));
        let middle = [0, 1, 2, 3].map(|j| 0.5 * graphs[0][j] + 0.5 * graphs[1][j]);
        let flat = best.graph;
        let mut least = f64::INFINITY;
        for graph in [middle, graphs[0], graphs[1], flat] {
            if !best.is_tame(&graph) {
                continue;
            }
            let offsets = [a, b].map(|own| best.offsets_of(&graph, own));
            let offsets = [offsets[0][0].min(offsets[1][0]), offsets[0][1].max(offsets[1][1])];
            if offsets[1] - offsets[0] < least {
                least = offsets[1] - offsets[0];
                (best.graph, best.offsets) = (graph, offsets);
            }
        }
        best
    }

    fn is_apart(&self, other: &Self) -> bool {
        if (0..2).any(|k| self.high[k] < other.low[k] || other.high[k] < self.low[k]) {
            return true;
        }
        if self.axis != other.axis || (self.is_flat() && other.is_flat()) {
            return false;
        }
        let [own, others] = [self.range(), other.range()];
        let common = [own[0].max(others[0]), own[1].min(others[1])];
        let [own, others] = [self, other].map(|strip| strip.graph_over(common));
        let [least, most] = extremes((0..4).map(|j| own[j] - others[j]));
        least + self.offsets[0] > other.offsets[1] || most + self.offsets[1] < other.offsets[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn arc() -> impl Strategy<Value = Vec<[f64; 2]>> {
        let wild = prop::sample::select(vec![2, 4, 6, 8])
            .prop_flat_map(|count| prop::collection::vec(prop::array::uniform2(-0.5..0.5f64), count));
        // Bent a little, over either axis, as most arcs are.
        let gentle = (
            prop::array::uniform2(-0.3..0.3f64),
            prop::array::uniform4(-0.1..0.1f64),
            any::<bool>(),
            1e-6..0.2f64,
        )
            .prop_map(|([x, y], bends, is_turned, size)| {
                let point = |j: usize| [x + size * j as f64 / 3.0, y + size * bends[j]];
                (0..4).map(point).map(|[x, y]| if is_turned { [y, x] } else { [x, y] }).collect()
            });
        prop_oneof![wild, gentle]
    }

    fn axis() -> impl Strategy<Value = Axis> {
        prop::sample::select(vec![Axis::X, Axis::Y])
    }

    fn points(controls: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
        (0..=64).map(|at| bernstein::value(controls, f64::from(at) / 64.0))
    }

    const MARGIN: f64 = 1e-9;

    fn is_near(a: [f64; 2], b: [f64; 2]) -> bool {
        (0..2).all(|k| (a[k] - b[k]).abs() <= MARGIN)
    }

    #[test]
    fn arcs_of_circles_have_thin_strips() {
        // Boxes around a sixth of a circle are thicker than 0.06.
        let arc = |moved: f64| {
            let controls = [[-0.25, 0.433], [-0.094, 0.523], [0.094, 0.523], [0.25, 0.433]];
            Strip::of_arc(&controls.map(|[x, y]| [x, y + moved]), Axis::X, 1e-12, 0.6)
        };
        let [own, other] = [arc(0.0), arc(0.01)];
        assert!(own.thickness() < 0.004, "{own:?}");
        assert!(own.is_apart(&other));
        assert!(Strip::around(&own, &other).thickness() < 0.016);
    }

    proptest! {
        #[test]
        fn cubics_come_back((power, range) in (prop::array::uniform4(-1.0..1.0f64), prop::array::uniform2(-0.5..1.5f64))) {
            let at = [0.1, 0.3, 0.6, 1.0];
            let value = |x: f64| power[0] + x * (power[1] + x * (power[2] + x * power[3]));
            let found = interpolated(at, at.map(value));
            prop_assert!((0..4).all(|j| (found[j] - power[j]).abs() < 1e-12), "{:?} {:?}", found, power);
            let graph = [
                power[0],
                power[0] + power[1] / 3.0,
                power[0] + (2.0 * power[1] + power[2]) / 3.0,
                power.iter().sum(),
            ];
            let part = restricted(&graph, range);
            for s in [0.0, 0.25, 1.0] {
                let point = |x: f64| [x, 0.0];
                let own = bernstein::value(&part.map(point), s)[0];
                prop_assert!((own - value(mean(range, s))).abs() < 1e-12);
            }
        }

        #[test]
        fn strips_have_their_points((arcs, axes) in (prop::array::uniform3(arc()), prop::array::uniform3(axis()))) {
            let [a, b, c] = [0, 1, 2].map(|j| Strip::of_arc(&arcs[j], axes[j], MARGIN, 0.5));
            let both = Strip::around(&a, &b);
            let all = Strip::around(&both, &c);
            let window = |[x, y]: [f64; 2]| [[x, x], [y, y]];
            for (strip, held) in [(a, &arcs[..1]), (both, &arcs[..2]), (all, &arcs[..])] {
                for point in held.iter().flat_map(|arc| points(arc)) {
                    for moved in [[0.0, 0.0], [MARGIN, -MARGIN], [-MARGIN, MARGIN], [MARGIN, MARGIN]] {
                        let near = [0, 1].map(|k| point[k] + 0.99 * moved[k]);
                        prop_assert!(!strip.misses(&window(near)), "{:?} {:?}", strip, near);
                    }
                    prop_assert!(!strip.misses(&[[point[0], point[0]], [point[1] - 0.1, point[1] + 0.2]]));
                }
            }
        }

        #[test]
        fn what_is_near_is_not_apart((arcs, axes, at) in (prop::array::uniform4(arc()), prop::array::uniform4(axis()), prop::array::uniform2(0..=64u8))) {
            // One arc of the second pair is moved so that a point of it is near one of the first pair.
            let [a, b, c, mut d] = arcs;
            let [from, to] = [(&a, at[0]), (&d, at[1])].map(|(arc, at)| bernstein::value(arc, f64::from(at) / 64.0));
            for point in &mut d {
                *point = [0, 1].map(|k| point[k] + (from[k] - to[k]) + 0.5 * MARGIN);
            }
            let [a, b, c, d] = [(&a, axes[0]), (&b, axes[1]), (&c, axes[2]), (&d, axes[3])]
                .map(|(arc, axis)| Strip::of_arc(arc, axis, MARGIN, 2.0));
            let [first, second] = [Strip::around(&a, &b), Strip::around(&c, &d)];
            for [own, other] in [[a, d], [first, d], [a, second], [first, second]] {
                prop_assert!(!own.is_apart(&other) && !other.is_apart(&own), "{:?} {:?}", own, other);
            }
        }

        /// What is told apart has no points near each other: by brute force.
        #[test]
        fn what_is_apart_has_no_near_points((arcs, axes) in (prop::array::uniform2(arc()), prop::array::uniform2(axis()))) {
            let [a, b] = [0, 1].map(|j| Strip::of_arc(&arcs[j], axes[j], MARGIN, 0.5));
            if a.is_apart(&b) {
                let near = points(&arcs[0]).find(|&p| points(&arcs[1]).any(|q| is_near(p, q)));
                prop_assert!(near.is_none(), "{:?}", near);
            }
        }
    }
}
