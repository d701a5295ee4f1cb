//! Coordinates to test decisions with, and their exact values.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::{Integer, Rational};
use proptest::prelude::*;

/// Numbers of very different sizes, small integers among them.
pub(super) fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-4i32..5).prop_map(f64::from),
        2 => (-100i32..100, -1070i32..1010).prop_map(|(m, e)| f64::from(m) * 2f64.powi(e)),
        1 => (-3i32..4, 0u64..3).prop_map(|(m, ulps)| {
            f64::from_bits((f64::from(m) * 0.1).to_bits() + ulps)
        }),
        1 => any::<f64>().prop_filter("finite", |x| x.is_finite()),
    ]
}

/// The exact value.
pub(super) fn rational(x: f64) -> Rational {
    let two = |e: i32| (0..e).fold(Integer::ONE, |p, _| p * Integer::from(2));
    let bits = x.to_bits();
    let biased = (bits >> 52 & 0x7ff) as i32;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (m, e) = if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
    let m = Integer::from(if x < 0.0 { -m } else { m });
    if e >= 0 { Rational::from(m * two(e)) } else { Rational::new(m, two(-e)).unwrap() }
}
