//! Random splines, and sets that they bound.
#![allow(dead_code, clippy::unwrap_used, reason = "each test uses a part of it")]

use coface_algebra::Error;
use coface_arrange::boolean::InsideRule;
use coface_yin::{Curve, EndCondition, Order, YinSet};
use std::f64::consts::TAU;

/// The number of cases: that of the environment variable `COFACE_SOUPS` if it is set.
pub(crate) fn case_count(usual: u64) -> u64 {
    std::env::var("COFACE_SOUPS").ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

/// The seeds of the cases: from the one that the environment variable `COFACE_FIRST_SEED` names, or from 0.
pub(crate) fn seeds(usual: u64) -> std::ops::Range<u64> {
    let first = std::env::var("COFACE_FIRST_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(0);
    first..first + case_count(usual)
}

/// A generator of numbers.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        let mut own = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x1234_5678);
        for _ in 0..4 {
            own.draw();
        }
        own
    }

    pub(crate) fn draw(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let x = self.0 ^ (self.0 >> 33);
        x.wrapping_mul(0xFF51_AFD7_ED55_8CCD) >> 11
    }

    pub(crate) fn below(&mut self, bound: u64) -> u64 {
        self.draw() % bound
    }

    /// Between -1 and 1.
    pub(crate) fn coordinate(&mut self) -> f64 {
        (self.draw() as f64 / (1u64 << 52) as f64) - 1.0
    }

    pub(crate) fn part(&mut self) -> f64 {
        0.5 + 0.5 * self.coordinate()
    }

    pub(crate) fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len() as u64) as usize]
    }
}

/// A smooth star-shaped curve.
pub(crate) fn blob(random: &mut Random, center: [f64; 2], size: f64) -> Curve<'static> {
    let count = 5 + random.below(9) as usize;
    let turn = TAU * random.part();
    let mut points: Vec<[f64; 2]> = (0..count)
        .map(|i| {
            let (sine, cosine) = (turn + TAU * i as f64 / count as f64).sin_cos();
            let radius = size * (0.6 + 0.4 * random.part());
            [center[0] + radius * cosine, center[1] + radius * sine]
        })
        .collect();
    points.push(points[0]);
    Curve::fit(&points, Order::CUBIC, &EndCondition::Periodic).unwrap()
}

/// A set of several blobs with holes.
pub(crate) fn smooth_set(random: &mut Random, size: f64) -> YinSet {
    let mut curves = Vec::new();
    for _ in 0..1 + random.below(3) {
        let center = [0, 1].map(|_| size * random.coordinate());
        curves.push(blob(random, center, size));
        if random.below(2) == 0 {
            curves.push(blob(random, center, 0.4 * size).reversed());
        }
    }
    YinSet::combine_curves(&curves, InsideRule::Positive).unwrap().into_set()
}

pub(crate) fn mapped(set: &YinSet, map: impl Fn(&Curve<'_>) -> Curve<'static>) -> Result<YinSet, Error> {
    let curves: Vec<_> = (0..set.curve_count()).map(|curve| map(&set.curve(curve))).collect();
    if curves.is_empty() { Ok(set.clone()) } else { YinSet::new(&curves) }
}
