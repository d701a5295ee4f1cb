//! Arrangements in the plane and in space in fractions, by definition: every pair is intersected, everything is looked for everywhere.
//! Only the numbers are the library's.
#![allow(dead_code, reason = "each test takes what it needs")]
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

pub(crate) mod cells;
pub(crate) mod drawing;
pub(crate) mod models;
pub(crate) mod soups;
pub(crate) mod space;

use coface_algebra::Rational;

pub(crate) type Point = [Rational; 2];
pub(crate) type Vector = [Rational; 3];

pub(crate) fn number(x: i64) -> Rational {
    Rational::from(x)
}

/// The value of a floating-point number.
pub(crate) fn exactly(x: f64) -> Rational {
    let bits = x.to_bits();
    let (biased, fraction) = ((bits >> 52 & 0x7ff) as i32, (bits & ((1 << 52) - 1)) as i64);
    let (mantissa, exponent) =
        if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
    let mut power = Rational::ONE;
    let mut left = exponent.unsigned_abs();
    while left > 0 {
        let step = left.min(60);
        power = &power * &number(1 << step);
        left -= step;
    }
    let value = if exponent < 0 { quotient(&number(mantissa), &power) } else { &number(mantissa) * &power };
    if x < 0.0 { -&value } else { value }
}

pub(crate) fn vector(p: [i64; 3]) -> Vector {
    p.map(number)
}

pub(crate) fn quotient(a: &Rational, b: &Rational) -> Rational {
    a * &b.inverse().unwrap()
}

pub(crate) fn minus<const N: usize>(p: &[Rational; N], q: &[Rational; N]) -> [Rational; N] {
    std::array::from_fn(|i| &p[i] - &q[i])
}

/// $p + t d$.
pub(crate) fn moved<const N: usize>(p: &[Rational; N], t: &Rational, d: &[Rational; N]) -> [Rational; N] {
    std::array::from_fn(|i| &p[i] + &(t * &d[i]))
}

pub(crate) fn dot<const N: usize>(p: &[Rational; N], q: &[Rational; N]) -> Rational {
    let mut sum = Rational::ZERO;
    for i in 0..N {
        sum += &(&p[i] * &q[i]);
    }
    sum
}

/// The signed area between two vectors of the plane.
pub(crate) fn turn(p: &Point, q: &Point) -> Rational {
    &(&p[0] * &q[1]) - &(&p[1] * &q[0])
}

pub(crate) fn cross(p: &Vector, q: &Vector) -> Vector {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &(&p[j] * &q[k]) - &(&p[k] * &q[j])
    })
}

pub(crate) fn is_zero<const N: usize>(p: &[Rational; N]) -> bool {
    p.iter().all(Rational::is_zero)
}

/// A fixed sequence of numbers that look random.
pub(crate) struct Random(u64);

impl Random {
    /// The sequence as it is.
    pub(crate) fn bare(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn new(seed: u64) -> Self {
        let mut random = Self(seed);
        (0..3).for_each(|_| {
            random.below(2);
        });
        random
    }

    pub(crate) fn below(&mut self, count: u64) -> u64 {
        self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (self.0 >> 33) % count
    }

    pub(crate) fn between(&mut self, low: i64, high: i64) -> i64 {
        low + self.below((high - low + 1) as u64) as i64
    }

    /// Between 0 and 1.
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// The number of soups to try: that of the environment variable `COFACE_SOUPS` if it is set.
pub(crate) fn soup_count(usual: u64) -> u64 {
    std::env::var("COFACE_SOUPS").ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}
