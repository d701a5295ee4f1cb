//! Distances between finitely many points.

use super::WeightedGraph;
use coface_algebra::{Error, ErrorKind, UnionFind};

/// The distances between points that are numbered from 0 on: all of them, or those that are known, where the others are
/// infinite.
///
/// Distances are symmetric and not negative. The triangle inequality is not needed.
///
/// # Examples
/// ```
/// use coface_complexes::filtered::Distances;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// // Points 0, 1 and 3 on a line: the distances 1-0, 2-0, 2-1.
/// let line = Distances::from_lower_triangle(3, vec![1.0, 3.0, 2.0])?;
/// assert_eq!(line.enclosing_radius(), Some(2.0));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Distances {
    count: usize,
    kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    /// That of i and j < i at i (i - 1) / 2 + j.
    All(Vec<f64>),
    /// Points i > j with their distance, sorted.
    Some(Vec<(u32, u32, f64)>),
}

impl Distances {
    /// All distances of `count` points: for each point those to the points before it.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there are `count (count - 1) / 2` numbers; [`ErrorKind::InvalidInput`] naming a distance that is negative
    /// or no number.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// assert!(Distances::from_lower_triangle(2, vec![1.5]).is_ok());
    /// assert!(Distances::from_lower_triangle(2, vec![-1.5]).is_err());
    /// assert!(Distances::from_lower_triangle(3, vec![1.5]).is_err());
    /// ```
    pub fn from_lower_triangle(count: usize, mut distances: Vec<f64>) -> Result<Self, Error> {
        if distances.len() != count * count.saturating_sub(1) / 2 {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} distances for the pairs of {count} points", distances.len()),
            )
            .with_cure("give one distance for each pair of points"));
        }
        let mut at = 0;
        for i in 0..count {
            for j in 0..i {
                distances[at] = checked(i, j, distances[at])?;
                at += 1;
            }
        }
        Ok(Self { count, kind: Kind::All(distances) })
    }

    /// Some distances of `count` points, each as two points and a number; the other pairs of points are infinitely far apart.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a pair with a point that there is not, of a point with itself unless its distance is 0, a distance
    /// that is negative or no number, or a pair that is given with two distances.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// let path = Distances::from_list(3, [(0, 1, 1.0), (2, 1, 4.0)]).expect("two distances");
    /// assert_eq!(path.enclosing_radius(), Some(4.0));
    /// assert_eq!(Distances::from_list(3, [(0, 1, 1.0)]).expect("one distance").enclosing_radius(), None);
    /// assert!(Distances::from_list(2, [(0, 2, 1.0)]).is_err());
    /// ```
    pub fn from_list(
        count: usize,
        list: impl IntoIterator<Item = (usize, usize, f64)>,
    ) -> Result<Self, Error> {
        let mut known = Vec::new();
        for (i, j, distance) in list {
            if i >= count || j >= count {
                return Err(Error::invalid(format!(
                    "there is no point {}: the points are 0 to {}",
                    i.max(j),
                    count.saturating_sub(1)
                ))
                .with_cure("number points from 0 on"));
            }
            let distance = checked(i, j, distance)?;
            if i == j {
                if distance != 0.0 {
                    return Err(Error::invalid(format!(
                        "the distance of point {i} to itself is {distance}, not 0"
                    ))
                    .with_cure("leave it out"));
                }
            } else if distance.is_finite() {
                known.push((i.max(j) as u32, i.min(j) as u32, distance));
            }
        }
        known.sort_by(|a, b| (a.0, a.1).cmp(&(b.0, b.1)).then(a.2.total_cmp(&b.2)));
        known.dedup();
        if let Some(two) = known.windows(2).find(|two| (two[0].0, two[0].1) == (two[1].0, two[1].1)) {
            let (i, j, distance) = two[0];
            return Err(Error::invalid(format!(
                "points {j} and {i} have two distances, {distance} and {}",
                two[1].2
            ))
            .with_cure("give one distance for each pair of points"));
        }
        Ok(Self { count, kind: Kind::Some(known) })
    }

    /// The number of points.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// assert_eq!(Distances::from_lower_triangle(2, vec![1.5]).expect("one distance").point_count(), 2);
    /// ```
    pub fn point_count(&self) -> usize {
        self.count
    }

    /// Whether only some distances are known.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// assert!(!Distances::from_lower_triangle(2, vec![1.5]).expect("one distance").is_sparse());
    /// ```
    pub fn is_sparse(&self) -> bool {
        matches!(self.kind, Kind::Some(_))
    }

    /// The least number r such that some point has all others within r; `None` if each point is infinitely far from some other, and if there is
    /// no point.
    ///
    /// From r on a Vietoris-Rips complex is a cone over that point, and nothing more happens.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// let line = Distances::from_lower_triangle(3, vec![1.0, 3.0, 2.0]).expect("three distances");
    /// assert_eq!(line.enclosing_radius(), Some(2.0));
    /// ```
    pub fn enclosing_radius(&self) -> Option<f64> {
        let mut farthest = vec![0f64; self.count];
        let mut known = vec![0usize; self.count];
        self.each(|i, j, distance| {
            for point in [i, j] {
                farthest[point] = farthest[point].max(distance);
                known[point] += 1;
            }
        });
        let whole = farthest.iter().zip(&known).filter(|&(_, &known)| known + 1 == self.count);
        whole.map(|(&farthest, _)| farthest).filter(|radius| radius.is_finite()).min_by(f64::total_cmp)
    }

    /// The least threshold at which the answer is whole: the enclosing radius, or the largest finite distance if there is none.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// assert_eq!(Distances::from_list(3, [(0, 1, 4.0)]).expect("one distance").whole_threshold(), 4.0);
    /// ```
    pub fn whole_threshold(&self) -> f64 {
        self.enclosing_radius().unwrap_or_else(|| {
            let mut largest = 0f64;
            self.each(|_, _, distance| {
                if distance.is_finite() {
                    largest = largest.max(distance);
                }
            });
            largest
        })
    }

    /// The least distance at which the points are connected, each to others within it: the longest edge of a shortest spanning tree. 0 for fewer than two points; `None` if they
    /// are at no distance.
    ///
    /// # Complexity
    /// $O(n^2)$ for n points, or $O(m \log m)$ for m known distances.
    ///
    /// # References
    /// R. Prim, *Shortest connection networks and some generalizations* (1957); J. Kruskal, *On the shortest spanning subtree of a graph* (1956).
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// let line = Distances::from_lower_triangle(3, vec![1.0, 3.0, 2.0]).expect("three distances");
    /// assert_eq!(line.connecting_distance(), Some(2.0));
    /// ```
    pub fn connecting_distance(&self) -> Option<f64> {
        let mut longest = 0.0f64;
        match &self.kind {
            Kind::All(distances) => {
                let between = |i: usize, j: usize| distances[i.max(j) * (i.max(j) - 1) / 2 + i.min(j)];
                let mut left: Vec<(usize, f64)> = (1..self.count).map(|i| (i, between(i, 0))).collect();
                while !left.is_empty() {
                    let nearest = (0..left.len()).min_by(|&a, &b| left[a].1.total_cmp(&left[b].1));
                    let (next, distance) = left.swap_remove(nearest.expect("some are left"));
                    longest = longest.max(distance);
                    left.iter_mut().for_each(|(i, least)| *least = least.min(between(*i, next)));
                }
            }
            Kind::Some(known) => {
                let mut known = known.clone();
                known.sort_by(|a, b| a.2.total_cmp(&b.2));
                let mut joined = UnionFind::new(self.count);
                for (i, j, distance) in known {
                    if joined.unite(i, j) {
                        longest = longest.max(distance);
                    }
                }
                if joined.class_count() > 1 {
                    return None;
                }
            }
        }
        longest.is_finite().then_some(longest)
    }

    /// The graph of the points that are within a distance of each other, whose edges enter at it.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// let line = Distances::from_lower_triangle(3, vec![1.0, 3.0, 2.0]).expect("three distances");
    /// assert_eq!(line.graph_within(2.0).edges(), [(1, 0, 1.0), (2, 1, 2.0)]);
    /// ```
    pub fn graph_within(&self, threshold: f64) -> WeightedGraph {
        let mut edges = Vec::new();
        self.each(|i, j, distance| {
            if distance <= threshold && distance.is_finite() {
                edges.push((i as u32, j as u32, distance));
            }
        });
        WeightedGraph::from_trusted_parts(vec![0.0; self.count], edges)
    }

    /// Calls with each known distance: point i, point j < i.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// let mut found = Vec::new();
    /// Distances::from_lower_triangle(2, vec![1.5]).expect("one distance").each(|i, j, distance| found.push((i, j, distance)));
    /// assert_eq!(found, [(1, 0, 1.5)]);
    /// ```
    pub fn each(&self, mut visit: impl FnMut(usize, usize, f64)) {
        match &self.kind {
            Kind::All(distances) => {
                let mut all = distances.iter();
                for i in 0..self.count {
                    for (j, &distance) in all.by_ref().take(i).enumerate() {
                        visit(i, j, distance);
                    }
                }
            }
            Kind::Some(known) => {
                known.iter().for_each(|&(i, j, distance)| visit(i as usize, j as usize, distance));
            }
        }
    }
}

fn checked(i: usize, j: usize, distance: f64) -> Result<f64, Error> {
    if distance >= 0.0 {
        // A negative zero becomes a zero.
        return Ok(distance + 0.0);
    }
    Err(Error::invalid(format!("the distance of points {} and {} is {distance}", i.min(j), i.max(j)))
        .with_cure("give distances that are 0 or more"))
}
