//! Explicit Runge-Kutta schemes, which map points over a step of time.

use crate::Order;
use rayon::prelude::*;

/// A scheme for mapping points over a step of time.
///
/// # References
/// J. H. Verner, *Explicit Runge-Kutta methods with estimates of the local truncation error* (1978), for order six; G. J. Cooper,
/// J. H. Verner, *Some explicit Runge-Kutta methods of high order* (1972), for order eight.
///
/// # Examples
/// ```
/// use coface_yin::{Order, RungeKutta};
/// assert_eq!(RungeKutta::for_curves(Order::CUBIC), RungeKutta::Classical);
/// assert_eq!(RungeKutta::for_curves(Order::new(8)?).order(), 8);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RungeKutta {
    /// The midpoint rule with two stages, of order two.
    Midpoint,
    /// The classical scheme with four stages, of order four.
    #[default]
    Classical,
    /// The scheme of Verner with seven stages, of order six.
    Verner,
    /// The scheme of Cooper and Verner with eleven stages, of order eight.
    CooperVerner,
}

/// The numbers of a scheme: for each stage but the first the weights of the stages before it, and the weights of the stages in the step.
/// The part of the step at which a stage is taken is the sum of its weights.
struct Tableau {
    stages: &'static [&'static [f64]],
    weights: &'static [f64],
}

/// The most stages that a scheme has.
const MOST_STAGES: usize = 11;

const MIDPOINT: Tableau = Tableau { stages: &[&[0.5]], weights: &[0.0, 1.0] };

const CLASSICAL: Tableau = Tableau {
    stages: &[&[0.5], &[0.0, 0.5], &[0.0, 0.0, 1.0]],
    weights: &[1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
};

/// The sixth of the published stages serves only the estimate of the error, and is left out.
const VERNER: Tableau = Tableau {
    stages: &[
        &[1.0 / 6.0],
        &[4.0 / 75.0, 16.0 / 75.0],
        &[5.0 / 6.0, -8.0 / 3.0, 5.0 / 2.0],
        &[-165.0 / 64.0, 55.0 / 6.0, -425.0 / 64.0, 85.0 / 96.0],
        &[-8263.0 / 15000.0, 124.0 / 75.0, -643.0 / 680.0, -81.0 / 250.0, 2484.0 / 10625.0],
        &[
            3501.0 / 1720.0,
            -300.0 / 43.0,
            297_275.0 / 52632.0,
            -319.0 / 2322.0,
            24068.0 / 84065.0,
            3850.0 / 26703.0,
        ],
    ],
    weights: &[3.0 / 40.0, 0.0, 875.0 / 2244.0, 23.0 / 72.0, 264.0 / 1955.0, 125.0 / 11592.0, 43.0 / 616.0],
};

/// The square root of 21.
const R: f64 = 4.582_575_694_955_84;

const COOPER_VERNER: Tableau = Tableau {
    stages: &[
        &[1.0 / 2.0],
        &[1.0 / 4.0, 1.0 / 4.0],
        &[1.0 / 7.0, (-7.0 - 3.0 * R) / 98.0, (21.0 + 5.0 * R) / 49.0],
        &[(11.0 + R) / 84.0, 0.0, (18.0 + 4.0 * R) / 63.0, (21.0 - R) / 252.0],
        &[(5.0 + R) / 48.0, 0.0, (9.0 + R) / 36.0, (-231.0 + 14.0 * R) / 360.0, (63.0 - 7.0 * R) / 80.0],
        &[
            (10.0 - R) / 42.0,
            0.0,
            (-432.0 + 92.0 * R) / 315.0,
            (633.0 - 145.0 * R) / 90.0,
            (-504.0 + 115.0 * R) / 70.0,
            (63.0 - 13.0 * R) / 35.0,
        ],
        &[1.0 / 14.0, 0.0, 0.0, 0.0, (14.0 - 3.0 * R) / 126.0, (13.0 - 3.0 * R) / 63.0, 1.0 / 9.0],
        &[
            1.0 / 32.0,
            0.0,
            0.0,
            0.0,
            (91.0 - 21.0 * R) / 576.0,
            11.0 / 72.0,
            (-385.0 - 75.0 * R) / 1152.0,
            (63.0 + 13.0 * R) / 128.0,
        ],
        &[
            1.0 / 14.0,
            0.0,
            0.0,
            0.0,
            1.0 / 9.0,
            (-733.0 - 147.0 * R) / 2205.0,
            (515.0 + 111.0 * R) / 504.0,
            (-51.0 - 11.0 * R) / 56.0,
            (132.0 + 28.0 * R) / 245.0,
        ],
        &[
            0.0,
            0.0,
            0.0,
            0.0,
            (-42.0 + 7.0 * R) / 18.0,
            (-18.0 + 28.0 * R) / 45.0,
            (-273.0 - 53.0 * R) / 72.0,
            (301.0 + 53.0 * R) / 72.0,
            (28.0 - 28.0 * R) / 45.0,
            (49.0 - 7.0 * R) / 18.0,
        ],
    ],
    weights: &[1.0 / 20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 49.0 / 180.0, 16.0 / 45.0, 49.0 / 180.0, 1.0 / 20.0],
};

impl RungeKutta {
    /// The scheme for boundaries of an order: of the same order, and of order four for polylines.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, RungeKutta};
    /// assert_eq!(RungeKutta::for_curves(Order::CUBIC).order(), 4);
    /// ```
    pub fn for_curves(order: Order) -> Self {
        match order.value() {
            0..=4 => Self::Classical,
            5..=6 => Self::Verner,
            _ => Self::CooperVerner,
        }
    }

    /// The order: the error over a span of time shrinks like this power of the step.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, RungeKutta};
    /// assert_eq!(RungeKutta::for_curves(Order::CUBIC).order(), 4);
    /// ```
    pub fn order(self) -> u32 {
        match self {
            Self::Midpoint => 2,
            Self::Classical => 4,
            Self::Verner => 6,
            Self::CooperVerner => 8,
        }
    }

    fn tableau(self) -> &'static Tableau {
        match self {
            Self::Midpoint => &MIDPOINT,
            Self::Classical => &CLASSICAL,
            Self::Verner => &VERNER,
            Self::CooperVerner => &COOPER_VERNER,
        }
    }

    /// Where a point is after a step.
    pub(super) fn mapped(
        self,
        velocity: &impl Fn([f64; 2], f64) -> [f64; 2],
        point: [f64; 2],
        time: f64,
        step: f64,
    ) -> [f64; 2] {
        let Tableau { stages, weights } = self.tableau();
        let mut slopes = [[0.0; 2]; MOST_STAGES];
        slopes[0] = velocity(point, time);
        for (number, weights) in (1..).zip(*stages) {
            let at: f64 = weights.iter().sum();
            slopes[number] = velocity(moved(point, step, weights, &slopes), time + at * step);
        }
        moved(point, step, weights, &slopes)
    }

    /// Where points are after a step, one by one and in parallel.
    pub(super) fn mapped_each(
        self,
        velocity: &(impl Fn([f64; 2], f64) -> [f64; 2] + Sync),
        points: &[[f64; 2]],
        time: f64,
        step: f64,
    ) -> Vec<[f64; 2]> {
        let map = |&point: &[f64; 2]| self.mapped(velocity, point, time, step);
        points.par_iter().with_min_len(512).map(map).collect()
    }

    /// Where points are after a step, with velocities of all of them at once. A list of velocities that is too short leaves points
    /// without a finite place.
    pub(super) fn mapped_together(
        self,
        velocities: &impl Fn(&[[f64; 2]], f64) -> Vec<[f64; 2]>,
        points: &[[f64; 2]],
        time: f64,
        step: f64,
    ) -> Vec<[f64; 2]> {
        let Tableau { stages, weights } = self.tableau();
        let mut slopes = vec![[[f64::NAN; 2]; MOST_STAGES]; points.len()];
        let fill = |slopes: &mut [[[f64; 2]; MOST_STAGES]], number: usize, found: &[[f64; 2]]| {
            for (own, slope) in slopes.iter_mut().zip(found) {
                own[number] = *slope;
            }
        };
        fill(&mut slopes, 0, &velocities(points, time));
        let all = |weights: &[f64], slopes: &[[[f64; 2]; MOST_STAGES]]| -> Vec<[f64; 2]> {
            points.iter().zip(slopes).map(|(&point, own)| moved(point, step, weights, own)).collect()
        };
        for (number, weights) in (1..).zip(*stages) {
            let at: f64 = weights.iter().sum();
            let places = all(weights, &slopes);
            fill(&mut slopes, number, &velocities(&places, time + at * step));
        }
        all(weights, &slopes)
    }
}

fn moved(point: [f64; 2], step: f64, weights: &[f64], slopes: &[[f64; 2]; MOST_STAGES]) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for (weight, slope) in weights.iter().zip(slopes).filter(|(weight, _)| **weight != 0.0) {
        sum = [sum[0] + weight * slope[0], sum[1] + weight * slope[1]];
    }
    [point[0] + step * sum[0], point[1] + step * sum[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [RungeKutta; 4] =
        [RungeKutta::Midpoint, RungeKutta::Classical, RungeKutta::Verner, RungeKutta::CooperVerner];

    /// A rooted tree by the numbers of its branches among all trees.
    type Tree = Vec<usize>;

    /// All rooted trees with up to so many vertices, those with fewer first, each with the number of its vertices.
    fn trees(most: usize) -> Vec<(Tree, usize)> {
        let mut found: Vec<(Tree, usize)> = vec![(Vec::new(), 1)];
        for count in 2..=most {
            let mut grown = Vec::new();
            collect(&found, count - 1, found.len(), &mut Vec::new(), &mut grown);
            found.extend(grown.into_iter().map(|tree| (tree, count)));
        }
        found
    }

    fn collect(all: &[(Tree, usize)], rest: usize, below: usize, branches: &mut Tree, found: &mut Vec<Tree>) {
        if rest == 0 {
            found.push(branches.clone());
        }
        for branch in (0..below).filter(|&branch| all[branch].1 <= rest) {
            branches.push(branch);
            collect(all, rest - all[branch].1, branch + 1, branches, found);
            branches.pop();
        }
    }

    /// The order conditions of Butcher: for each rooted tree the elementary weight is one over the density.
    #[test]
    fn schemes_satisfy_the_conditions_of_their_orders_and_no_more() {
        let all = trees(9);
        assert_eq!(
            (1..=9).map(|n| all.iter().filter(|tree| tree.1 == n).count()).collect::<Vec<_>>(),
            [1, 1, 2, 4, 9, 20, 48, 115, 286]
        );
        for scheme in ALL {
            let Tableau { stages, weights } = scheme.tableau();
            let (mut stage_weights, mut densities): (Vec<Vec<f64>>, Vec<f64>) = (Vec::new(), Vec::new());
            let mut worst = [0.0f64; 10];
            for (branches, count) in &all {
                let mut own = vec![1.0; weights.len()];
                for &branch in branches {
                    for stage in 0..own.len() {
                        let row = if stage == 0 { &[][..] } else { stages[stage - 1] };
                        own[stage] *= row.iter().zip(&stage_weights[branch]).map(|(a, b)| a * b).sum::<f64>();
                    }
                }
                let density =
                    *count as f64 * branches.iter().map(|&branch| densities[branch]).product::<f64>();
                let sum: f64 = weights.iter().zip(&own).map(|(a, b)| a * b).sum();
                worst[*count] = worst[*count].max((sum - 1.0 / density).abs());
                stage_weights.push(own);
                densities.push(density);
            }
            let order = scheme.order() as usize;
            assert!(worst[1..=order].iter().all(|&miss| miss < 1e-15), "{scheme:?} {worst:?}");
            assert!(worst[order + 1] > 1e-6, "{scheme:?} {worst:?}");
        }
        assert_eq!(R, 21.0f64.sqrt());
    }

    /// A velocity that depends on place and time, with a known path.
    #[test]
    fn errors_shrink_with_the_order() {
        // Around the origin by the angle of the sine of time, at a distance that grows like the exponential of it.
        let velocity = |[x, y]: [f64; 2], t: f64| {
            let (growth, turn) = (0.5, t.cos());
            [growth * x - turn * y, growth * y + turn * x]
        };
        let exact = |t: f64| [(0.5 * t).exp() * t.sin().cos(), (0.5 * t).exp() * t.sin().sin()];
        for scheme in ALL {
            let miss = |count: u32| {
                let step = 2.0 / f64::from(count);
                let end = (0..count).fold([1.0, 0.0], |point, at| {
                    scheme.mapped(&velocity, point, f64::from(at) * step, step)
                });
                let right = exact(2.0);
                (end[0] - right[0]).hypot(end[1] - right[1])
            };
            let count = if scheme.order() == 8 { 8 } else { 16 };
            let rate = (miss(count) / miss(2 * count)).log2();
            assert!((rate - f64::from(scheme.order())).abs() < 0.6, "{scheme:?} {rate}");
        }
    }
}
