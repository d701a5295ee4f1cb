//! Prime numbers.

/// Whether a number is prime, by trial division up to the square root.
pub fn is_prime(n: u64) -> bool {
    let has_no_odd_divisor = || {
        let mut divisors =
            (3..).step_by(2).take_while(|&d: &u64| d.checked_mul(d).is_some_and(|square| square <= n));
        divisors.all(|d| !n.is_multiple_of(d))
    };
    n == 2 || n > 2 && !n.is_multiple_of(2) && has_no_odd_divisor()
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
        assert!(is_prime((1 << 61) - 1) && !is_prime(u64::from(u32::MAX)));
        assert_eq!(large_primes().take(2).collect::<Vec<_>>(), [2_147_483_647, 2_147_483_629]);
    }
}
