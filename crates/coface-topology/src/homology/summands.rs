//! Cyclic summands over Z/n whose orders divide each other.

use coface_algebra::{Integer, SparseVector, combination};

/// How the summands of a group over Z/n, whose orders are any divisors of n, become summands whose orders divide each other: Z/2 + Z/3 becomes Z/6.
///
/// Each step takes summands of the orders a and b and makes two of their greatest common divisor and least common multiple. For that a = a1 a2 and
/// b = b1 b2, where a1 has the prime powers of a that are no less than those of b, and b1 those of b that are greater than those of a.
#[derive(Clone, Debug)]
pub(super) struct Summands {
    modulus: Integer,
    /// The orders after all steps, 1 for summands that vanish.
    orders: Vec<Integer>,
    steps: Vec<Step>,
    /// The summands that stay, by rising orders.
    places: Vec<usize>,
}

/// Summand i gets the greatest common divisor a2 b2, summand j the least common multiple a1 b1.
#[derive(Clone, Debug)]
struct Step {
    i: usize,
    j: usize,
    a: [Integer; 2],
    b: [Integer; 2],
}

impl Summands {
    /// Those of these orders, divisors of the modulus that are not 1.
    pub(super) fn new(modulus: &Integer, mut orders: Vec<Integer>) -> Self {
        let mut steps = Vec::new();
        // Whole summands are divided by all others.
        let mut partial: Vec<usize> = (0..orders.len()).filter(|&i| orders[i] != *modulus).collect();
        partial.sort_by(|&i, &j| orders[i].cmp(&orders[j]));
        for (first, &i) in partial.iter().enumerate() {
            for &j in &partial[first + 1..] {
                if orders[i].divides(&orders[j]) {
                    continue;
                }
                let step = Step::new(i, j, &orders[i], &orders[j]);
                orders[i] = &step.a[1] * &step.b[1];
                orders[j] = &step.a[0] * &step.b[0];
                steps.push(step);
            }
        }
        let mut places: Vec<usize> = (0..orders.len()).filter(|&i| !orders[i].is_unit()).collect();
        places.sort_by(|&i, &j| orders[i].cmp(&orders[j]));
        Self { modulus: modulus.clone(), orders, steps, places }
    }

    /// The orders of the summands, each dividing the next; `None` for a whole summand.
    pub(super) fn orders(&self) -> Vec<Option<Integer>> {
        let order = |&place: &usize| Some(self.orders[place].clone()).filter(|order| *order != self.modulus);
        self.places.iter().map(order).collect()
    }

    /// The generators of the summands, from those of the given ones.
    pub(super) fn generators(&self, vectors: Vec<SparseVector>) -> Vec<SparseVector> {
        self.combined(vectors, |step| {
            let ([a1, a2], [b1, b2]) = (&step.a, &step.b);
            [[a1.clone(), b1.clone()], [a2.clone(), b2.clone()]]
        })
    }

    /// What tells the summands apart, from what tells the given ones apart: with the values n/m on the generator of order m and 0 on the other ones, modulo n.
    pub(super) fn duals(&self, vectors: Vec<SparseVector>) -> Vec<SparseVector> {
        self.combined(vectors, |step| {
            let ([a1, a2], [b1, b2]) = (&step.a, &step.b);
            [
                [a1 * &inverse(&(a1 * b2), a2), b1 * &inverse(&(b1 * a2), b2)],
                [a2 * &inverse(&(a2 * b1), a1), b2 * &inverse(&(b2 * a1), b1)],
            ]
        })
    }

    fn combined(
        &self,
        mut vectors: Vec<SparseVector>,
        factors: impl Fn(&Step) -> [[Integer; 2]; 2],
    ) -> Vec<SparseVector> {
        for step in &self.steps {
            let of = |[x, y]: &[Integer; 2]| {
                let mut sum = combination(x, &vectors[step.i], y, &vectors[step.j]);
                sum.iter_mut().for_each(|(_, x)| *x = x.div_rem_nearest(&self.modulus).1);
                sum.retain(|(_, x)| !x.is_zero());
                sum
            };
            let factors = factors(step);
            let (low, high) = (of(&factors[0]), of(&factors[1]));
            vectors[step.i] = low;
            vectors[step.j] = high;
        }
        self.places.iter().map(|&place| std::mem::take(&mut vectors[place])).collect()
    }

    /// The coefficients of a class in the generators of [`Self::generators`], from those in the given ones: from 0 to the order less one.
    pub(super) fn coefficients(&self, mut given: Vec<Integer>) -> Vec<Integer> {
        for step in &self.steps {
            let ([a1, a2], [b1, b2]) = (&step.a, &step.b);
            let (s, t) = (given[step.i].clone(), given[step.j].clone());
            let sum = |s: Integer, t: Integer, order: Integer| (&s + &t).div_rem_floor(&order).1;
            given[step.i] =
                sum(&(&s * b2) * &inverse(&(a1 * b2), a2), &(&t * a2) * &inverse(&(b1 * a2), b2), a2 * b2);
            given[step.j] =
                sum(&(&s * b1) * &inverse(&(a2 * b1), a1), &(&t * a1) * &inverse(&(b2 * a1), b1), a1 * b1);
        }
        let coefficient = |&place: &usize| given[place].div_rem_floor(&self.orders[place]).1;
        self.places.iter().map(coefficient).collect()
    }
}

impl Step {
    fn new(i: usize, j: usize, a: &Integer, b: &Integer) -> Self {
        // The primes that b has more often than a.
        let more = b.exact_quotient(&a.gcd(b)).expect("a gcd divides");
        let (a2, a1) = split(a, &more);
        let (b1, b2) = split(b, &more);
        Self { i, j, a: [a1, a2], b: [b1, b2] }
    }
}

/// The largest divisor of `x` all of whose primes divide `primes`, and what is left, which has none of them.
fn split(x: &Integer, primes: &Integer) -> (Integer, Integer) {
    let mut rest = x.clone();
    loop {
        let common = rest.gcd(primes);
        if common.is_unit() {
            break;
        }
        rest = rest.exact_quotient(&common).expect("a gcd divides");
    }
    (x.exact_quotient(&rest).expect("a part divides"), rest)
}

/// The inverse of `x` modulo `modulus`, which is coprime to it; 0 modulo 1.
fn inverse(x: &Integer, modulus: &Integer) -> Integer {
    x.extended_gcd(modulus).1.div_rem_floor(modulus).1
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Of the given summands, as unit vectors of Z/n times n/order.
        #[test]
        fn summands_divide_each_other(
            n in 2i64..2000, picks in prop::collection::vec(0usize..50, 0..6), numbers in prop::collection::vec(0i64..2000, 6),
        ) {
            let divisors: Vec<i64> = (2..=n).filter(|d| n % d == 0).collect();
            let given: Vec<i64> = picks.iter().map(|&pick| divisors[pick % divisors.len()]).collect();
            let summands = Summands::new(&n.into(), given.iter().map(|&order| order.into()).collect());
            let orders: Vec<i64> = summands
                .orders()
                .iter()
                .map(|order| order.as_ref().map_or(n, |order| order.to_i64().unwrap()))
                .collect();
            prop_assert!(orders.windows(2).all(|two| two[1] % two[0] == 0));
            prop_assert_eq!(orders.iter().product::<i64>(), given.iter().product::<i64>());
            let unit = |(i, x): (usize, i64)| vec![(i as u32, Integer::from(x))];
            let ones = || given.iter().map(|_| 1).enumerate().map(unit).collect::<Vec<_>>();
            let generators = summands.generators(ones());
            let duals = summands.duals(ones());
            let at = |vector: &SparseVector, i: usize| {
                vector.iter().find(|one| one.0 as usize == i).map_or(0, |one| one.1.to_i64().unwrap())
            };
            // The pairing of given summand i with itself is n / order.
            let value = |a: &SparseVector, b: &SparseVector| {
                (0..given.len()).map(|i| at(a, i) * at(b, i) % n * (n / given[i])).sum::<i64>().rem_euclid(n)
            };
            for (i, dual) in duals.iter().enumerate() {
                for (j, generator) in generators.iter().enumerate() {
                    prop_assert_eq!(value(dual, generator), if i == j { n / orders[i] % n } else { 0 });
                }
            }
            // A class is the sum of the generators with its coefficients.
            let class: Vec<i64> = given.iter().zip(&numbers).map(|(order, x)| x % order).collect();
            let found = summands.coefficients(class.iter().map(|&x| x.into()).collect());
            for (i, order) in given.iter().enumerate() {
                let sum: i64 = found.iter().zip(&generators).map(|(x, one)| x.to_i64().unwrap() * at(one, i)).sum();
                prop_assert_eq!((sum - class[i]).rem_euclid(*order), 0);
            }
            prop_assert!(found.iter().zip(&orders).all(|(x, &order)| (0..order).contains(&x.to_i64().unwrap())));
        }
    }
}
