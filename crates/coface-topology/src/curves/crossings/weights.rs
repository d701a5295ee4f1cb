//! Lengths of edges as whole numbers, in which sums of the same edges are equal and different paths hardly ever.

/// The low bits that hold what is added to make paths of one length differ.
const NOISE_BITS: u32 = 46;
/// The sum of all lengths takes at most this many bits: sums of a few paths of a double cover fit in 128 bits.
const LENGTH_BITS: i32 = 77;
/// Each edge gets less than 2 to this power.
const EDGE_NOISE_BITS: u32 = 24;

/// The lengths of edges in units of a small power of two, exact unless a length is below $2^{-77}$ of their sum or has
/// digits below that; in the low bits a positive number that looks random and depends on the edge alone.
///
/// Dijkstra's algorithm then gives trees from different roots that agree where they meet, and no length is zero.
#[derive(Debug)]
pub(super) struct Weights {
    weights: Vec<u128>,
    exponent: i32,
}

impl Weights {
    pub(super) fn new(lengths: &[f64]) -> Self {
        let most = lengths.iter().copied().fold(0.0, f64::max);
        // The sum is below most * 2^count_bits.
        let count_bits = (usize::BITS - lengths.len().leading_zeros()) as i32;
        let exponent = if most > 0.0 { LENGTH_BITS - libm::ilogb(most) - 1 - count_bits } else { 0 };
        let weights = (0u64..).zip(lengths).map(|(edge, &length)| {
            let whole = libm::scalbn(length, exponent) as u128;
            (whole << NOISE_BITS) + u128::from(1 + (mixed(edge) >> (64 - EDGE_NOISE_BITS)))
        });
        Self { weights: weights.collect(), exponent }
    }

    pub(super) fn of(&self, edge: u32) -> u128 {
        self.weights[edge as usize]
    }

    /// A number that is at most the length that a weight stands for.
    pub(super) fn length_below(&self, weight: u128) -> f64 {
        libm::scalbn(without_noise(weight) as f64, -self.exponent) * (1.0 - 1e-12)
    }
}

/// A weight without what was added to make it differ.
pub(super) fn without_noise(weight: u128) -> u128 {
    weight >> NOISE_BITS
}

/// A number that looks random (the finalizer of G. Steele, D. Lea, C. Flood, *Fast splittable pseudorandom number generators*, 2014).
fn mixed(number: u64) -> u64 {
    let mut z = number.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_are_in_the_order_of_lengths() {
        for scale in [1e-300, 1.0, 1e300] {
            let lengths = [3.0, 0.0, 1.0, 1.5, 1.0 + f64::EPSILON].map(|length| length * scale);
            let weights = Weights::new(&lengths);
            let order = |i: u32, j: u32| without_noise(weights.of(i)).cmp(&without_noise(weights.of(j)));
            for i in 0..5u32 {
                for j in 0..5u32 {
                    assert_eq!(order(i, j), lengths[i as usize].total_cmp(&lengths[j as usize]));
                }
                let below = weights.length_below(weights.of(i));
                assert!(below <= lengths[i as usize] && below >= lengths[i as usize] * 0.999);
                assert!(weights.of(i) > 0);
            }
        }
        assert_eq!(Weights::new(&[0.0]).length_below(7), 0.0);
        assert_eq!(
            without_noise(Weights::new(&[1.0, 2.0]).of(0)) * 2,
            without_noise(Weights::new(&[1.0, 2.0]).of(1))
        );
    }
}
