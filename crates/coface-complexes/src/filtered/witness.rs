//! Witness complexes of landmarks among points.

use super::FilteredComplex;
use super::flag::{bytes_of_simplex, most_simplices};
use crate::simplicial::{FrozenComplex, FrozenLevels};
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_geometry::Positions;
use std::collections::BTreeMap;

/// What witnesses of a simplex are asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum WitnessRule {
    /// The landmarks of the simplex are nearer than all others.
    #[default]
    Weak,
    /// The landmarks of the simplex are the nearest, all as far as each other.
    Strong,
}

/// Landmarks that are spread over points: the first point, then again and again the point that is farthest from those before it.
///
/// They are fewer than `count` where no more points are different.
///
/// # Complexity
/// $O(n c d)$ for n points in dimension d and c landmarks.
///
/// # References
/// T. Gonzalez, *Clustering to minimize the maximum intercluster distance* (1985).
///
/// # Examples
/// ```
/// use coface_complexes::filtered::farthest_points;
/// use coface_geometry::Positions;
/// let line = Positions::from_flat(1, vec![0.0, 1.0, 5.0, 9.0]).expect("four points");
/// assert_eq!(farthest_points(&line, 3), [0, 3, 2]);
/// ```
pub fn farthest_points(points: &Positions, count: usize) -> Vec<usize> {
    let mut chosen = Vec::new();
    let mut distances = vec![f64::INFINITY; points.len()];
    let steps = stage("choosing landmarks", count);
    for _ in steps.each(0..count.min(points.len())) {
        // Of several the first.
        let farthest = distances.iter().enumerate().rev().max_by(|a, b| a.1.total_cmp(b.1));
        let Some((next, _)) = farthest.filter(|(_, distance)| **distance > 0.0) else { break };
        chosen.push(next);
        let point = points.point(VertexId::new(next));
        for (id, distance) in distances.iter_mut().enumerate() {
            *distance = distance.min(squared(points.point(VertexId::new(id)), point));
        }
    }
    chosen
}

fn squared(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum()
}

impl FilteredComplex {
    /// The witness complex of landmarks, up to a value and a dimension, as GUDHI's `EuclideanWitnessComplex` and `EuclideanStrongWitnessComplex` have it: a simplex is a set of
    /// landmarks that has a witness, and whose faces have one.
    ///
    /// A point w is a witness of landmarks S at the value a if $|w - p|^2 \le |w - q|^2 + a$ for all p in S and all landmarks q that are not in S; by the strong rule for all
    /// landmarks q. **Values are squared distances**, as `max_alpha_square` of GUDHI.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a bound that is negative or no number; [`ErrorKind::Shape`] for landmarks of another dimension; [`ErrorKind::TooLarge`] for more than
    /// 2^28 sets that have a witness, or more than the memory that is free would hold.
    ///
    /// # Complexity
    /// $O(c \log c)$ for each witness with c landmarks, and a logarithm for each set that it is a witness of.
    ///
    /// # References
    /// V. de Silva, G. Carlsson, *Topological estimation using witness complexes* (2004).
    ///
    /// # Examples
    /// Two landmarks with a point between them.
    /// ```
    /// use coface_complexes::filtered::{FilteredComplex, WitnessRule};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Positions::from_flat(1, vec![0.0, 4.0, 1.0])?;
    /// let landmarks = Positions::from_flat(1, vec![0.0, 4.0])?;
    /// let weak = FilteredComplex::witness(&points, &landmarks, WitnessRule::Weak, f64::INFINITY, 2)?;
    /// assert_eq!(weak.values(1), [0.0]);
    /// // The middle point is 3 from one landmark and 1 from the other: 9 - 1.
    /// let strong = FilteredComplex::witness(&points, &landmarks, WitnessRule::Strong, f64::INFINITY, 2)?;
    /// assert_eq!(strong.values(1), [8.0]);
    /// # Ok(()) }
    /// ```
    pub fn witness(
        points: &Positions,
        landmarks: &Positions,
        rule: WitnessRule,
        bound: f64,
        dimension: usize,
    ) -> Result<Self, Error> {
        if bound.is_nan() || bound < 0.0 {
            return Err(Error::invalid(format!("the bound is {bound}, and values are not negative"))
                .with_cure("give a bound of 0 or more"));
        }
        if !points.is_empty() && !landmarks.is_empty() && points.dimension() != landmarks.dimension() {
            let message = format!(
                "landmarks have {} coordinates, and points have {}",
                landmarks.dimension(),
                points.dimension()
            );
            return Err(Error::new(ErrorKind::Shape, message).with_cure("give both as many coordinates"));
        }
        let most = most_simplices(bytes_of_simplex(dimension) + 64);
        let mut sets = Sets { rule, bound, size: dimension + 1, most, found: BTreeMap::new() };
        let steps = stage("asking witnesses", points.len());
        for id in steps.each(0..points.len()) {
            let witness = points.point(VertexId::new(id));
            let place = |landmark: usize| {
                (squared(witness, landmarks.point(VertexId::new(landmark))), landmark as u32)
            };
            let mut near: Vec<(f64, u32)> = (0..landmarks.len()).map(place).collect();
            near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            if sets.ask(&near).is_none() {
                let message = format!(
                    "the witness complex of {} landmarks and {} points up to dimension {dimension} has more than {most} simplices, and there is room for no more",
                    landmarks.len(),
                    points.len()
                );
                return Err(Error::new(ErrorKind::TooLarge, message)
                    .with_cure("ask for a lower value at the end, a lower dimension, or fewer landmarks"));
            }
        }
        Ok(sets.complex())
    }
}

/// Sets of landmarks with the least values of their witnesses.
struct Sets {
    rule: WitnessRule,
    bound: f64,
    /// The most landmarks of a set.
    size: usize,
    most: usize,
    found: BTreeMap<Vec<u32>, f64>,
}

impl Sets {
    /// Adds the sets of a witness, whose landmarks are given from the nearest on; `None` if there are too many.
    fn ask(&mut self, near: &[(f64, u32)]) -> Option<()> {
        let Some(&(nearest, _)) = near.first() else { return Some(()) };
        if self.rule == WitnessRule::Strong {
            return self.add(&mut Vec::new(), near, nearest);
        }
        // The sets that have the first landmarks up to one that they lack.
        let mut first = Vec::new();
        for lacked in 0..=near.len().min(self.size) {
            let Some(&(distance, landmark)) = near.get(lacked) else {
                return self.keep(&first, 0.0);
            };
            if lacked > 0 {
                self.keep(&first, 0.0)?;
            }
            self.add(&mut first, &near[lacked + 1..], distance)?;
            first.push(landmark);
        }
        Some(())
    }

    /// Adds the sets that have landmarks of `rest` beside those of `set`, with values over this squared distance.
    fn add(&mut self, set: &mut Vec<u32>, rest: &[(f64, u32)], over: f64) -> Option<()> {
        if set.len() == self.size {
            return Some(());
        }
        for (place, &(distance, landmark)) in rest.iter().enumerate() {
            let value = (distance - over).max(0.0);
            if value > self.bound {
                break;
            }
            set.push(landmark);
            self.keep(set, value)?;
            self.add(set, &rest[place + 1..], over)?;
            set.pop();
        }
        Some(())
    }

    fn keep(&mut self, set: &[u32], value: f64) -> Option<()> {
        let mut set = set.to_vec();
        set.sort_unstable();
        let known = self.found.entry(set).or_insert(f64::INFINITY);
        *known = known.min(value);
        (self.found.len() <= self.most).then_some(())
    }

    /// The sets whose faces are there, each no sooner than these.
    fn complex(mut self) -> FilteredComplex {
        let mut facet = Vec::new();
        for size in 2..=self.size {
            let sets: Vec<(Vec<u32>, f64)> = self
                .found
                .iter()
                .filter(|(set, _)| set.len() == size)
                .map(|(set, &value)| (set.clone(), value))
                .collect();
            for (set, value) in sets {
                let mut whole = Some(value);
                for left in 0..size {
                    facet.clear();
                    facet.extend(
                        set.iter().enumerate().filter(|&(at, _)| at != left).map(|(_, &vertex)| vertex),
                    );
                    whole = whole.and_then(|value| self.found.get(&facet).map(|&own| own.max(value)));
                }
                match whole {
                    Some(value) => *self.found.get_mut(&set).expect("a set") = value,
                    None => {
                        self.found.remove(&set);
                    }
                }
            }
        }
        let (mut levels, mut values) = (FrozenLevels::default(), Vec::<Vec<f64>>::new());
        // Lists before longer ones that begin with them: as depth first.
        for (set, value) in self.found {
            levels.push(&set);
            if values.len() < set.len() {
                values.push(Vec::new());
            }
            values[set.len() - 1].push(value);
        }
        FilteredComplex::from_trusted_parts(FrozenComplex::from_levels(levels), values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Each set of landmarks and each witness, as the definition says.
    fn by_definition(
        points: &Positions,
        landmarks: &Positions,
        rule: WitnessRule,
        bound: f64,
        dimension: usize,
    ) -> BTreeMap<Vec<u32>, f64> {
        let count = landmarks.len();
        let mut found: BTreeMap<Vec<u32>, f64> = BTreeMap::new();
        let mut sets: Vec<u32> = (1u32..1 << count).collect();
        sets.sort_by_key(|set| set.count_ones());
        for set in sets {
            let members: Vec<u32> = (0..count as u32).filter(|i| set >> i & 1 == 1).collect();
            if members.len() > dimension + 1 {
                continue;
            }
            let own = (0..points.len()).map(|w| {
                let distance = |i: u32| {
                    squared(points.point(VertexId::new(w)), landmarks.point(VertexId::new(i as usize)))
                };
                let others = (0..count as u32).filter(|&q| rule == WitnessRule::Strong || set >> q & 1 == 0);
                let least = others.map(distance).fold(f64::INFINITY, f64::min);
                members.iter().map(|&p| (distance(p) - least).max(0.0)).fold(0.0, f64::max)
            });
            let own = own.fold(f64::INFINITY, f64::min);
            let faces = (0..members.len()).filter(|_| members.len() > 1).map(|left| {
                let mut face = members.clone();
                face.remove(left);
                found.get(&face).copied()
            });
            let all: Option<Vec<f64>> = faces.collect();
            if let Some(all) = all {
                let value = all.into_iter().fold(own, f64::max);
                if value <= bound {
                    found.insert(members, value);
                }
            }
        }
        found
    }

    proptest! {
        #[test]
        fn witness_complexes_are_those_of_the_definition(
            flat in prop::collection::vec(0i8..5, 2..30),
            count in 1usize..6,
            strong in any::<bool>(),
            bound in prop::option::of(0u8..12),
            dimension in 0usize..4,
        ) {
            let flat: Vec<f64> = flat[..flat.len() / 2 * 2].iter().map(|&x| x.into()).collect();
            let points = Positions::from_flat(2, flat).unwrap();
            let chosen = farthest_points(&points, count);
            let of_landmarks = chosen.iter().flat_map(|&id| points.point(VertexId::new(id)).to_vec()).collect();
            let landmarks = Positions::from_flat(2, of_landmarks).unwrap();
            let rule = if strong { WitnessRule::Strong } else { WitnessRule::Weak };
            let bound = bound.map_or(f64::INFINITY, f64::from);
            let complex = FilteredComplex::witness(&points, &landmarks, rule, bound, dimension).unwrap();
            complex.complex().check().unwrap();
            let found: BTreeMap<Vec<u32>, f64> = (0..complex.complex().f_vector().len())
                .flat_map(|k| complex.values(k).iter().enumerate().map(move |(i, &value)| (k, i, value)))
                .map(|(k, i, value)| (complex.complex().numbers(k, i).to_vec(), value))
                .collect();
            prop_assert_eq!(found, by_definition(&points, &landmarks, rule, bound, dimension));
        }
    }
}
