//! How many roots a polynomial has between two numbers, by exact arithmetic.

use coface_algebra::Rational;
use coface_geometry::predicates::Dyadic;
use std::cmp::Ordering;

/// A polynomial by its coefficients, the constant one first and the last one not zero; none for zero.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RationalPolynomial(Vec<Rational>);

/// The chain of Sturm of a polynomial, divided by the common divisor of the polynomial and its derivative: it counts roots once,
/// whatever their multiplicities are.
///
/// # References
/// C. Sturm, *Mémoire sur la résolution des équations numériques* (1835); S. Basu, R. Pollack, M.-F. Roy, *Algorithms in Real
/// Algebraic Geometry* (2006), section 2.2.
pub(super) struct SturmChain(Vec<RationalPolynomial>);

/// The exact value of a finite number.
fn rational(x: f64) -> Rational {
    Dyadic::from(x).quotient(&Dyadic::from(1.0))
}

impl RationalPolynomial {
    /// The polynomial with these coefficients in the Bernstein basis on [0, 1].
    pub(super) fn from_bernstein(coefficients: &[Dyadic]) -> Self {
        let one = Dyadic::from(1.0);
        let mut differences: Vec<Rational> = coefficients.iter().map(|c| c.quotient(&one)).collect();
        let degree = differences.len() - 1;
        // Coefficient k is the k-th difference times the binomial coefficient.
        let mut found = Vec::with_capacity(degree + 1);
        let mut binomial = 1i64;
        for k in 0..=degree {
            found.push(&differences[0] * &Rational::from(binomial));
            binomial = binomial * (degree - k) as i64 / (k as i64 + 1);
            differences = differences.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
        }
        Self::trimmed(found)
    }

    fn trimmed(mut coefficients: Vec<Rational>) -> Self {
        while coefficients.last().is_some_and(Rational::is_zero) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    pub(super) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    pub(super) fn value(&self, t: f64) -> Rational {
        let t = rational(t);
        self.0.iter().rev().fold(Rational::ZERO, |sum, coefficient| &(&sum * &t) + coefficient)
    }

    pub(super) fn sign(&self, t: f64) -> Ordering {
        self.value(t).cmp(&Rational::ZERO)
    }

    fn derivative(&self) -> Self {
        let scaled = self.0.iter().enumerate().skip(1).map(|(k, c)| c * &Rational::from(k as i64));
        Self(scaled.collect())
    }

    /// Quotient and remainder of the division by a polynomial that is not zero.
    fn divided(&self, divisor: &Self) -> [Self; 2] {
        let degree = divisor.degree();
        let inverse = divisor.0[degree].inverse().expect("the leading coefficient is not zero");
        let mut rest = self.0.clone();
        let mut quotient = vec![Rational::ZERO; (self.0.len()).saturating_sub(degree)];
        for k in (0..quotient.len()).rev() {
            let factor = &rest[k + degree] * &inverse;
            for (j, coefficient) in divisor.0.iter().enumerate() {
                rest[k + j] = &rest[k + j] - &(&factor * coefficient);
            }
            quotient[k] = factor;
        }
        [quotient, rest].map(Self::trimmed)
    }

    fn negated(&self) -> Self {
        Self(self.0.iter().map(|c| -c).collect())
    }
}

impl SturmChain {
    /// The chain of a polynomial that is not zero.
    pub(super) fn new(polynomial: &RationalPolynomial) -> Self {
        let mut chain = vec![polynomial.clone()];
        let mut next = polynomial.derivative();
        while !next.is_zero() {
            let last = &chain[chain.len() - 1];
            let [_, rest] = last.divided(&next);
            chain.push(next);
            next = rest.negated();
        }
        let divisor = chain[chain.len() - 1].clone();
        Self(chain.iter().map(|own| own.divided(&divisor)[0].clone()).collect())
    }

    /// The polynomial with the same roots, each of them simple.
    pub(super) fn simple(&self) -> &RationalPolynomial {
        &self.0[0]
    }

    /// The number of different roots from one number, inclusive, to another, inclusive.
    pub(super) fn count(&self, [low, high]: [f64; 2]) -> usize {
        let changes = |t: f64| {
            let signs: Vec<Ordering> =
                self.0.iter().map(|own| own.sign(t)).filter(|sign| sign.is_ne()).collect();
            signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
        };
        changes(low) - changes(high) + usize::from(self.simple().sign(low).is_eq())
    }

    /// Neighboring numbers, or equal ones, between which the only root in a range lies at which no end of the range is a root.
    pub(super) fn bracket(&self, [mut low, mut high]: [f64; 2]) -> [f64; 2] {
        let below = self.simple().sign(low);
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                return [low, high];
            }
            match self.simple().sign(middle) {
                Ordering::Equal => return [middle; 2],
                sign if sign == below => low = middle,
                _ => high = middle,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn of_roots(roots: &[i32]) -> RationalPolynomial {
        roots.iter().fold(RationalPolynomial(vec![Rational::ONE]), |product, &root| {
            let mut found = vec![Rational::ZERO; product.0.len() + 1];
            for (k, coefficient) in product.0.iter().enumerate() {
                found[k + 1] = &found[k + 1] + coefficient;
                found[k] = &found[k] - &(coefficient * &Rational::from(i64::from(root)));
            }
            RationalPolynomial(found)
        })
    }

    proptest! {
        #[test]
        fn roots_count_once(roots in prop::collection::vec(-5..5i32, 1..7), low in -6..6i32, length in 1..8i32) {
            let chain = SturmChain::new(&of_roots(&roots));
            let high = low + length;
            let mut inside: Vec<i32> = roots.into_iter().filter(|root| (low..=high).contains(root)).collect();
            inside.sort_unstable();
            inside.dedup();
            prop_assert_eq!(chain.count([low, high].map(f64::from)), inside.len());
            if let [root] = inside[..] && low < root && root < high {
                let [below, above] = chain.bracket([low, high].map(f64::from));
                prop_assert!(below <= f64::from(root) && f64::from(root) <= above);
            }
        }
    }

    #[test]
    fn the_power_basis_of_a_parabola() {
        // (1 - 2 t)^2 = 1 - 4 t + 4 t^2.
        let found = RationalPolynomial::from_bernstein(&[1.0, -1.0, 1.0].map(Dyadic::from));
        assert_eq!(found.0, [1, -4, 4].map(Rational::from));
        let chain = SturmChain::new(&found);
        assert_eq!((chain.count([0.0, 1.0]), chain.count([0.0, 0.25])), (1, 0));
        assert_eq!(chain.bracket([0.0, 1.0]), [0.5; 2]);
    }
}
