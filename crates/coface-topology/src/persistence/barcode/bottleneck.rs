//! Bottleneck distances.

use super::Barcode;
use super::matching::{BarcodeMatching, Points, essential_pairs};
use super::near_points::{NearPoints, distance};

const NONE: u32 = u32::MAX;

impl Barcode {
    /// A matching with another barcode whose longest pair is as short as possible.
    ///
    /// The length of a pair is the greater one of the differences of births and of deaths, and half of its length for an interval that goes
    /// to the diagonal. The distance is the **bottleneck distance**. It is exact: it is one of these numbers, as floating point rounds each of
    /// them, and no matching does with less.
    ///
    /// # Complexity
    /// At most 64 maximal matchings of the pairs up to a length, each in $O(\sqrt n)$ rounds of $O(n)$ searches in a tree of points. Memory is
    /// linear.
    ///
    /// # References
    /// J. E. Hopcroft, R. M. Karp, *An n^5/2 algorithm for maximum matchings in bipartite graphs* (1973); A. Efrat, A. Itai, M. J. Katz,
    /// *Geometry helps in bottleneck matching* (2001); M. Kerber, D. Morozov, A. Nigmetov, *Geometry helps to compare persistence diagrams*
    /// (2017). What we do otherwise: an interval of twice the length or less needs no partner, so only the longer ones of each side are covered,
    /// one side after the other (N. S. Mendelsohn, A. L. Dulmage, 1958); and bisection runs over the floating-point numbers, of which a list of
    /// all lengths would be a part.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::Barcode;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let first = Barcode::new(vec![[0.0, f64::INFINITY], [0.0, 2.0]])?;
    /// assert_eq!(first.bottleneck_matching(&Barcode::new(vec![[0.25, f64::INFINITY]])?).distance(), 1.0);
    /// // A class that never dies has no partner.
    /// assert_eq!(first.bottleneck_matching(&Barcode::default()).distance(), f64::INFINITY);
    /// # Ok(()) }
    /// ```
    pub fn bottleneck_matching(&self, other: &Self) -> BarcodeMatching {
        let Some(essential) = essential_pairs(self, other) else { return BarcodeMatching::none() };
        let (first, second) = (Points::of(self), Points::of(other));
        let least = essential.iter().map(|&(_, _, length)| length).fold(0.0, f64::max);
        let found = Bipartite::new(&first.points, &second.points).shortest(least);
        let mut pairs: Vec<_> = essential.iter().map(|&(a, b, _)| (Some(a), Some(b))).collect();
        pairs.extend(
            found.mates[0]
                .iter()
                .zip(&first.places)
                .map(|(&mate, &place)| (Some(place), (mate != NONE).then(|| second.places[mate as usize]))),
        );
        let is_left = |&(&mate, _): &(&u32, &usize)| mate == NONE;
        let left = found.mates[1].iter().zip(&second.places).filter(is_left);
        pairs.extend(left.map(|(_, &place)| (None, Some(place))));
        BarcodeMatching::new(found.length, found.length, pairs)
    }
}

/// Points of two sides, and a matching of some of them.
struct Bipartite<'a> {
    points: [&'a [[f64; 2]]; 2],
    /// For each point the one of the other side that it is matched with.
    mates: [Vec<u32>; 2],
}

/// The shortest matching.
struct Shortest {
    length: f64,
    mates: [Vec<u32>; 2],
}

/// The distance of a point from the diagonal.
fn to_diagonal([birth, death]: [f64; 2]) -> f64 {
    (death - birth).abs() / 2.0
}

impl<'a> Bipartite<'a> {
    fn new(first: &'a [[f64; 2]], second: &'a [[f64; 2]]) -> Self {
        Self { points: [first, second], mates: [vec![NONE; first.len()], vec![NONE; second.len()]] }
    }

    /// The matching whose longest pair is shortest, among those that are allowed to have the length `least`.
    fn shortest(mut self, least: f64) -> Shortest {
        let mut best = Shortest { length: self.length().max(least), mates: self.mates.clone() };
        if best.length == least || self.cover_all(least) {
            let length = self.length().max(least);
            return if length <= best.length { Shortest { length, mates: self.mates } } else { best };
        }
        // No matching has the length `low`, and there is one of the length `best`. Not negative numbers are ordered as their bits.
        let mut low = least.to_bits();
        while best.length.to_bits() - low > 1 {
            let middle = f64::from_bits(low + (best.length.to_bits() - low) / 2);
            if self.cover_all(middle) {
                best = Shortest { length: self.length(), mates: self.mates.clone() };
            } else {
                low = middle.to_bits();
            }
        }
        best
    }

    /// The length of the longest pair.
    fn length(&self) -> f64 {
        let of_first = self.points[0].iter().zip(&self.mates[0]).map(|(&point, &mate)| match mate {
            NONE => to_diagonal(point),
            mate => distance(point, self.points[1][mate as usize]),
        });
        let of_second = self.points[1].iter().zip(&self.mates[1]).filter(|&(_, &mate)| mate == NONE);
        of_first.chain(of_second.map(|(&point, _)| to_diagonal(point))).fold(0.0, f64::max)
    }

    /// Whether pairs of at most this length cover all points that are farther from the diagonal. If they do, the matching does.
    fn cover_all(&mut self, length: f64) -> bool {
        for a in 0..self.points[0].len() {
            let b = self.mates[0][a];
            if b != NONE && distance(self.points[0][a], self.points[1][b as usize]) > length {
                self.mates[0][a] = NONE;
                self.mates[1][b as usize] = NONE;
            }
        }
        self.cover(0, length) && self.cover(1, length)
    }

    /// Covers the points of one side that are farther from the diagonal than this; those of the other side that are covered stay so.
    fn cover(&mut self, side: usize, length: f64) -> bool {
        let far: Vec<bool> = self.points[side].iter().map(|&point| to_diagonal(point) > length).collect();
        loop {
            let is_free = |&point: &u32| far[point as usize] && self.mates[side][point as usize] == NONE;
            let free: Vec<u32> = (0..far.len() as u32).filter(is_free).collect();
            if free.is_empty() {
                return true;
            }
            let layers = self.layers(side, &free, &far, length);
            let Some(mut layers) = layers else { return false };
            for &point in &free {
                self.augment(side, point, &far, length, &mut layers);
            }
        }
    }

    /// Whether a path may end at this point of the other side: it is free, or its mate may become so.
    fn is_end(&self, side: usize, far: &[bool], point: u32) -> bool {
        let mate = self.mates[1 - side][point as usize];
        mate == NONE || !far[mate as usize]
    }

    /// The points of the other side by their distance from free points along alternating paths, up to the first layer that has an end of a
    /// path; `None` if no path ends.
    fn layers(&self, side: usize, free: &[u32], far: &[bool], length: f64) -> Option<Vec<NearPoints<'a>>> {
        let others = self.points[1 - side];
        let mut left = NearPoints::new(others, (0..others.len() as u32).collect());
        let (mut layers, mut frontier) = (Vec::new(), free.to_vec());
        while !frontier.is_empty() {
            let mut layer = Vec::new();
            for &point in &frontier {
                let center = self.points[side][point as usize];
                while let Some(other) = left.take_within(center, length) {
                    layer.push(other);
                }
            }
            let has_end = layer.iter().any(|&other| self.is_end(side, far, other));
            frontier = layer.iter().map(|&other| self.mates[1 - side][other as usize]).collect();
            layers.push(NearPoints::new(others, layer));
            if has_end {
                return Some(layers);
            }
        }
        None
    }

    /// Covers a point by a path through the layers that ends in the last one, if there is one.
    fn augment(&mut self, side: usize, start: u32, far: &[bool], length: f64, layers: &mut [NearPoints<'a>]) {
        // Points of this side, with the point of the other side that leads on.
        let mut path: Vec<(u32, u32)> = vec![(start, NONE)];
        while let Some(&(point, _)) = path.last() {
            let depth = path.len() - 1;
            let center = self.points[side][point as usize];
            let Some(other) = layers[depth].take_within(center, length) else {
                path.pop();
                continue;
            };
            path[depth].1 = other;
            if depth + 1 < layers.len() {
                path.push((self.mates[1 - side][other as usize], NONE));
            } else if self.is_end(side, far, other) {
                let mate = self.mates[1 - side][other as usize];
                if mate != NONE {
                    self.mates[side][mate as usize] = NONE;
                }
                for &(point, other) in &path {
                    self.mates[side][point as usize] = other;
                    self.mates[1 - side][other as usize] = point;
                }
                return;
            }
        }
    }
}
