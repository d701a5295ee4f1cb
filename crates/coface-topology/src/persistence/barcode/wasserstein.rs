//! Wasserstein distances.

use super::Barcode;
use super::matching::{BarcodeMatching, Points, essential_pairs};
use coface_algebra::Error;
use coface_algebra::progress::stage;

const NONE: u32 = u32::MAX;

impl Barcode {
    /// A matching with another barcode whose pairs have the least sum of powers of lengths.
    ///
    /// The length of a pair is the distance of the points (birth, death) in the norm with the exponent `internal_p`, 1 or more, `inf` for the
    /// greatest difference; that of an interval that goes to the diagonal is its distance from there. The **Wasserstein distance** of order q is
    ///
    /// $$W_q = \Bigl(\sum_{\text{pairs}} \lVert x - y \rVert_p^q\Bigr)^{1/q},$$
    ///
    /// the q-th root of the sum of the q-th powers. The matching is optimal but for rounding, as
    /// [`lower_bound`](BarcodeMatching::lower_bound) proves. Powers of high orders make short pairs vanish beside long intervals: above order 8 look
    /// at the bound.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for an order that is not finite or is below 1, and an exponent below 1.
    ///
    /// # Complexity
    /// Linear memory. $O(n m k)$ time for n and m intervals where paths that shorten the matching visit k of them: $k$ is small where most intervals
    /// go to the diagonal, and at most n.
    ///
    /// # References
    /// R. Jonker, A. Volgenant, *A shortest augmenting path algorithm for dense and sparse linear assignment problems* (1987); D. Cohen-Steiner,
    /// H. Edelsbrunner, J. Harer, Y. Mileyko, *Lipschitz functions have L_p-stable persistence* (2010).
    ///
    /// # Examples
    /// ```
    /// use coface_topology::Barcode;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (first, second) = (Barcode::new(vec![[0.0, 6.0], [5.0, 6.0]])?, Barcode::new(vec![[3.0, 10.0]])?);
    /// let matching = first.wasserstein_matching(&second, 1.0, f64::INFINITY)?;
    /// // The first pair has the length 4, and 0.5 goes to the diagonal.
    /// assert_eq!(matching.distance(), 4.5);
    /// assert_eq!(matching.pairs(), [(Some(0), Some(0)), (Some(1), None)]);
    /// # Ok(()) }
    /// ```
    pub fn wasserstein_matching(
        &self,
        other: &Self,
        order: f64,
        internal_p: f64,
    ) -> Result<BarcodeMatching, Error> {
        if !(order.is_finite() && order >= 1.0) {
            let cure = "give an order from 1 on; the distance of order inf is the bottleneck distance";
            return Err(
                Error::invalid(format!("{order} is no order of a Wasserstein distance")).with_cure(cure)
            );
        }
        if internal_p.is_nan() || internal_p < 1.0 {
            return Err(Error::invalid(format!("{internal_p} is no exponent of a norm"))
                .with_cure("give a number from 1 on, or inf"));
        }
        let Some(essential) = essential_pairs(self, other) else { return Ok(BarcodeMatching::none()) };
        let (first, second) = (Points::of(self), Points::of(other));
        // Powers of numbers about 1 neither overflow nor vanish; a power of two rounds nothing.
        let lengths = first.points.iter().chain(&second.points).map(|[birth, death]| (death - birth).abs());
        let longest = lengths.chain(essential.iter().map(|pair| pair.2)).fold(0.0, f64::max);
        let exponent = if longest > 0.0 { longest.log2().floor().clamp(-1000.0, 1000.0) } else { 0.0 };
        let unit = exponent.exp2();
        let lengths = Lengths { order, internal_p, unit };
        let assignment = Assignment::new(&lengths, &first.points, &second.points).solved();
        let of_essential: f64 = essential.iter().map(|pair| lengths.power(pair.2 / unit)).sum();
        let mut pairs: Vec<_> = essential.iter().map(|&(a, b, _)| (Some(a), Some(b))).collect();
        pairs.extend(
            assignment
                .mates
                .iter()
                .zip(&first.places)
                .map(|(&mate, &place)| (Some(place), (mate != NONE).then(|| second.places[mate as usize]))),
        );
        let left = assignment.owners.iter().zip(&second.places).filter(|&(&owner, _)| owner == NONE);
        pairs.extend(left.map(|(_, &place)| (None, Some(place))));
        let root = |sum: f64| unit * (sum + of_essential).powf(1.0 / order);
        let distance = root(assignment.cost());
        Ok(BarcodeMatching::new(distance, root(assignment.lower_bound()).min(distance), pairs))
    }
}

/// How pairs are measured.
struct Lengths {
    order: f64,
    internal_p: f64,
    unit: f64,
}

impl Lengths {
    fn power(&self, length: f64) -> f64 {
        match self.order {
            1.0 => length,
            2.0 => length * length,
            order => length.powf(order),
        }
    }

    fn of_pair(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let (x, y) = ((a[0] - b[0]).abs() / self.unit, (a[1] - b[1]).abs() / self.unit);
        self.power(match self.internal_p {
            1.0 => x + y,
            2.0 => x.hypot(y),
            f64::INFINITY => x.max(y),
            p => {
                let greater = x.max(y);
                if greater == 0.0 {
                    0.0
                } else {
                    greater * (1.0 + (x.min(y) / greater).powf(p)).powf(1.0 / p)
                }
            }
        })
    }

    fn to_diagonal(&self, [birth, death]: [f64; 2]) -> f64 {
        // The nearest point of the diagonal has both coordinates in the middle.
        self.power((death - birth).abs() / self.unit * (1.0 / self.internal_p - 1.0).exp2())
    }
}

/// Intervals of the first barcode that get partners in the second or the diagonal, at the least cost.
///
/// All of the second barcode pays for the diagonal from the start, and gets it back with a partner. Prices of the dual problem: what an interval
/// of the first barcode pays in all is at least its price and that of its partner, and the prices of the second are at most 0.
struct Assignment<'a> {
    lengths: &'a Lengths,
    first: &'a [[f64; 2]],
    second: &'a [[f64; 2]],
    diagonal: [Vec<f64>; 2],
    first_prices: Vec<f64>,
    second_prices: Vec<f64>,
    mates: Vec<u32>,
    owners: Vec<u32>,
}

/// What the search of one path knows of the second barcode.
struct Search {
    distance: Vec<f64>,
    previous: Vec<u32>,
    /// Those that are not settled yet.
    open: Vec<u32>,
    settled: Vec<u32>,
}

impl<'a> Assignment<'a> {
    fn new(lengths: &'a Lengths, first: &'a [[f64; 2]], second: &'a [[f64; 2]]) -> Self {
        let diagonal =
            [first, second].map(|points| points.iter().map(|&point| lengths.to_diagonal(point)).collect());
        let (mates, owners) = (vec![NONE; first.len()], vec![NONE; second.len()]);
        let prices = [vec![0.0; first.len()], vec![0.0; second.len()]];
        let [first_prices, second_prices] = prices;
        Self { lengths, first, second, diagonal, first_prices, second_prices, mates, owners }
    }

    /// The cost of a pair beside the diagonal of its second interval.
    fn pair_cost(&self, a: usize, b: usize) -> f64 {
        self.lengths.of_pair(self.first[a], self.second[b]) - self.diagonal[1][b]
    }

    fn solved(mut self) -> Self {
        let mut search = Search {
            distance: vec![0.0; self.second.len()],
            previous: vec![NONE; self.second.len()],
            open: Vec::new(),
            settled: Vec::new(),
        };
        for a in stage("matching intervals", self.first.len()).each(0..self.first.len()) {
            self.assign(a, &mut search);
        }
        self
    }

    /// Assigns an interval of the first barcode along a shortest path.
    fn assign(&mut self, start: usize, search: &mut Search) {
        search.distance.fill(f64::INFINITY);
        search.settled.clear();
        search.open.clear();
        search.open.extend(0..self.second.len() as u32);
        let (mut at, mut travelled) = (start, 0.0);
        // The best end at the diagonal so far, and who goes there.
        let mut diagonal = (f64::INFINITY, start);
        let (length, end) = loop {
            let own = travelled + self.diagonal[0][at] - self.first_prices[at];
            if own < diagonal.0 {
                diagonal = (own, at);
            }
            let base = travelled - self.first_prices[at];
            let (mut nearest, mut place) = (diagonal.0, usize::MAX);
            for (i, &b) in search.open.iter().enumerate() {
                let b = b as usize;
                let length = base + self.pair_cost(at, b) - self.second_prices[b];
                if length < search.distance[b] {
                    search.distance[b] = length;
                    search.previous[b] = at as u32;
                }
                if search.distance[b] < nearest {
                    (nearest, place) = (search.distance[b], i);
                }
            }
            if place == usize::MAX {
                break (diagonal.0, None);
            }
            let b = search.open.swap_remove(place);
            if self.owners[b as usize] == NONE {
                break (nearest, Some(b));
            }
            search.settled.push(b);
            at = self.owners[b as usize] as usize;
            travelled = nearest;
        };
        self.first_prices[start] += length;
        for &b in &search.settled {
            let saved = length - search.distance[b as usize];
            self.second_prices[b as usize] -= saved;
            self.first_prices[self.owners[b as usize] as usize] += saved;
        }
        self.shift(start, end, diagonal.1, &search.previous);
    }

    /// Matches anew along the path that ends at `end`, or at the diagonal with `last`.
    fn shift(&mut self, start: usize, end: Option<u32>, last: usize, previous: &[u32]) {
        let mut free = match end {
            Some(b) => b,
            None => std::mem::replace(&mut self.mates[last], NONE),
        };
        if end.is_none() && last == start {
            return;
        }
        loop {
            let a = previous[free as usize] as usize;
            self.owners[free as usize] = a as u32;
            let next = std::mem::replace(&mut self.mates[a], free);
            if a == start {
                return;
            }
            free = next;
        }
    }

    fn cost(&self) -> f64 {
        let first = (0..self.first.len()).map(|a| match self.mates[a] {
            NONE => self.diagonal[0][a],
            b => self.lengths.of_pair(self.first[a], self.second[b as usize]),
        });
        let second = self.owners.iter().zip(&self.diagonal[1]).filter(|&(&owner, _)| owner == NONE);
        first.chain(second.map(|(_, &cost)| cost)).sum()
    }

    fn lower_bound(&self) -> f64 {
        let dual: f64 = self.first_prices.iter().chain(&self.second_prices).chain(&self.diagonal[1]).sum();
        dual.max(0.0)
    }
}
