//! Prime numbers.

/// The first twelve primes: as bases of the test of Miller and Rabin they tell every number below 3.3 * 10^24 rightly
/// (Sorenson and Webster, Strong pseudoprimes to twelve prime bases, 2017).
const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];

/// Whether a number is prime, by the test of Miller and Rabin with bases that make it exact.
///
/// # Complexity
/// At most 12 powers modulo n.
///
/// # Examples
/// ```
/// use coface_algebra::is_prime;
/// assert!(is_prime(18_446_744_073_709_551_557));
/// assert!(!is_prime(3_215_031_751), "a strong pseudoprime to the bases 2, 3, 5 and 7");
/// ```
pub fn is_prime(n: u64) -> bool {
    if let Some(&divisor) = BASES.iter().find(|&&base| n.is_multiple_of(base)) {
        return n == divisor;
    }
    // n - 1 = odd 2^twos
    let Some(before) = n.checked_sub(1).filter(|&before| before > 0) else { return false };
    let twos = before.trailing_zeros();
    #[allow(clippy::cast_possible_truncation, reason = "residues are below n, which has 64 bits")]
    let times = |a: u64, b: u64| (u128::from(a) * u128::from(b) % u128::from(n)) as u64;
    let power = |base: u64, mut exponent: u64| {
        let (mut power, mut square) = (1, base % n);
        while exponent > 0 {
            if exponent % 2 == 1 {
                power = times(power, square);
            }
            square = times(square, square);
            exponent /= 2;
        }
        power
    };
    BASES.iter().all(|&base| {
        let first = power(base, before >> twos);
        let squares = std::iter::successors(Some(first), |&x| Some(times(x, x))).take(twos as usize);
        first == 1 || squares.into_iter().any(|x| x == before)
    })
}

/// The odd primes below 2^31, falling; there are 50 million of them above 2^30.
pub fn large_primes() -> impl Iterator<Item = u32> {
    (3..1u32 << 31).rev().step_by(2).filter(|&n| is_prime(n.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn primes_are_those_of_the_sieve() {
        let mut is_composite = [true, true].to_vec();
        is_composite.resize(2000, false);
        for n in 2..2000 {
            (2 * n..2000).step_by(n).for_each(|multiple| is_composite[multiple] = true);
        }
        for (n, &composite) in is_composite.iter().enumerate() {
            assert_eq!(is_prime(n as u64), !composite, "{n}");
        }
        // Products of two primes that single bases do not tell from primes, and the largest primes of 32 and 64 bits.
        for composite in [2047, 25_326_001, 3_215_031_751, 3_474_749_660_383, 341_550_071_728_321, u64::MAX] {
            assert!(!is_prime(composite), "{composite}");
        }
        assert!(is_prime(4_294_967_291) && is_prime(18_446_744_073_709_551_557));
        assert!(is_prime((1 << 61) - 1) && !is_prime(u64::from(u32::MAX)));
        assert_eq!(large_primes().take(2).collect::<Vec<_>>(), [2_147_483_647, 2_147_483_629]);
    }
}
