//! Congruence of vertices.

use super::near_points::NearPoints;
use crate::algebra::{RaggedArray, UnionFind};
use crate::geometry::Positions;
use crate::{Error, VertexId};
use rayon::prelude::*;

/// Classes that one task represents.
const BLOCK: usize = 1 << 12;

/// Which vertices are congruent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum ClassRule {
    /// All that are joined by chains of vertices, each within the tolerance of the next. It does not depend on the
    /// order of the vertices; a class can be longer than the tolerance.
    #[default]
    Transitive,
    /// In the order of the vertices each that has no class yet opens one, with all others without class within the
    /// tolerance of it. No member is farther than the tolerance from the first; the classes depend on the order.
    Greedy,
}

/// Where a class of vertices is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Representative {
    /// At its lowest member.
    #[default]
    Lowest,
    /// At the mean of its members.
    Mean,
    /// At the median of its members on each axis; for an even number the lower one, so that it is a coordinate of the input.
    Median,
}

/// Classes of congruent vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct VertexCongruence {
    members: RaggedArray,
    class_of: Vec<u32>,
    positions: Positions,
    largest_diameter: f64,
}

impl VertexCongruence {
    /// The members of each class, rising; classes by their lowest members.
    pub fn members(&self) -> &RaggedArray {
        &self.members
    }

    /// The number of classes.
    pub fn class_count(&self) -> usize {
        self.members.len()
    }

    /// The class of each vertex.
    pub fn class_of(&self) -> &[u32] {
        &self.class_of
    }

    /// The positions of the classes.
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The largest distance of two members of a class; of classes with more than 1000 members the diagonal of the box around
    /// them, which is no less.
    pub fn largest_diameter(&self) -> f64 {
        self.largest_diameter
    }
}

/// The classes of vertices within a tolerance of each other, a length in the unit of the positions.
///
/// # Errors
/// [`crate::ErrorKind::InvalidInput`] for a tolerance that is negative or not a number.
///
/// # Complexity
/// Nearly linear where not many vertices are within a tolerance; parallel, with the same result whatever the number of
/// threads.
///
/// # Examples
/// Three points in a row, 0.8 apart: by chains all are congruent; greedily the third is not.
/// ```
/// use coface::arrangement::congruence::{ClassRule, Representative, vertex_congruence};
/// use coface::geometry::Positions;
/// # fn main() -> Result<(), coface::Error> {
/// let row = Positions::from_flat(1, vec![0.0, 0.8, 1.6])?;
/// let chained = vertex_congruence(&row, 1.0, ClassRule::Transitive, Representative::Lowest)?;
/// assert_eq!((chained.class_count(), chained.largest_diameter()), (1, 1.6));
/// let greedy = vertex_congruence(&row, 1.0, ClassRule::Greedy, Representative::Mean)?;
/// assert_eq!(greedy.class_of(), [0, 0, 1]);
/// assert_eq!(greedy.positions().as_flat(), [0.4, 1.6]);
/// # Ok(()) }
/// ```
pub fn vertex_congruence(
    positions: &Positions,
    tolerance: f64,
    rule: ClassRule,
    representative: Representative,
) -> Result<VertexCongruence, Error> {
    if tolerance.is_nan() || tolerance < 0.0 {
        return Err(Error::invalid(format!("{tolerance} is no tolerance"))
            .with_cure("give a length that is not negative, in the unit of the positions"));
    }
    let (class_of, class_count) = class_numbers(positions, tolerance, rule);
    represented(positions, class_of, class_count, representative)
}

/// The classes of vertices, merged again as long as classes are within the tolerance of each other.
///
/// Once is enough for [`Representative::Lowest`]: members of different classes, or first members of greedy classes, are
/// farther apart than the tolerance. Means and medians can be nearer. Here classes whose positions are congruent are united
/// and get a position from all their vertices, until no two are within the tolerance; so doing it once more, with the
/// positions of the classes, changes nothing. With [`ClassRule::Transitive`] neither the classes nor, up to rounding, means
/// and medians depend on the order of the vertices. With [`ClassRule::Greedy`] united classes may be longer than the rule
/// says.
///
/// # Errors
/// As [`vertex_congruence`].
///
/// # Complexity
/// That of [`vertex_congruence`] for each round; each but the last has fewer classes.
///
/// # Examples
/// A pair, and a point that is near to neither of it, but to its mean:
/// ```
/// use coface::arrangement::congruence::{
///     ClassRule, Representative, stable_vertex_congruence, vertex_congruence,
/// };
/// use coface::geometry::Positions;
/// # fn main() -> Result<(), coface::Error> {
/// let points = Positions::from_flat(2, vec![0., 0., 0., 1., 1.1, 0.5])?;
/// let (rule, mean) = (ClassRule::Transitive, Representative::Mean);
/// assert_eq!(vertex_congruence(&points, 1.15, rule, mean)?.class_count(), 2);
/// assert_eq!(stable_vertex_congruence(&points, 1.15, rule, mean)?.class_count(), 1);
/// # Ok(()) }
/// ```
pub fn stable_vertex_congruence(
    positions: &Positions,
    tolerance: f64,
    rule: ClassRule,
    representative: Representative,
) -> Result<VertexCongruence, Error> {
    let mut found = vertex_congruence(positions, tolerance, rule, representative)?;
    if representative == Representative::Lowest {
        return Ok(found);
    }
    loop {
        let (united, count) = class_numbers(found.positions(), tolerance, rule);
        if count == found.class_count() {
            return Ok(found);
        }
        let class_of = found.class_of.iter().map(|&class| united[class as usize]).collect();
        found = represented(positions, class_of, count, representative)?;
    }
}

/// The class of each vertex and the number of classes.
fn class_numbers(positions: &Positions, tolerance: f64, rule: ClassRule) -> (Vec<u32>, usize) {
    match rule {
        ClassRule::Transitive => chained(positions, tolerance),
        ClassRule::Greedy => greedy(positions, tolerance),
    }
}

/// Classes with their members, positions and diameters.
fn represented(
    positions: &Positions,
    class_of: Vec<u32>,
    class_count: usize,
    representative: Representative,
) -> Result<VertexCongruence, Error> {
    let members = RaggedArray::grouped(class_count, class_of.iter().copied());
    let blocks: Vec<(Vec<f64>, f64)> = (0..class_count.div_ceil(BLOCK))
        .into_par_iter()
        .map(|block| {
            let (mut flat, mut largest): (Vec<f64>, f64) = (Vec::new(), 0.0);
            for class in block * BLOCK..((block + 1) * BLOCK).min(class_count) {
                let class = members.list(class);
                represent(positions, class, representative, &mut flat);
                if class.len() > 1 {
                    largest = largest.max(diameter(positions, class));
                }
            }
            (flat, largest)
        })
        .collect();
    let largest_diameter = blocks.iter().map(|&(_, largest)| largest).fold(0.0, f64::max);
    let flat = blocks.into_iter().flat_map(|(flat, _)| flat).collect();
    let positions = Positions::from_flat(positions.dimension(), flat)?;
    Ok(VertexCongruence { members, class_of, positions, largest_diameter })
}

/// Appends the position of a class.
fn represent(positions: &Positions, class: &[u32], representative: Representative, flat: &mut Vec<f64>) {
    let points = || class.iter().map(|&vertex| positions.point(VertexId::from_u32(vertex)));
    let first = points().next().expect("a class has members");
    for (axis, &lowest) in first.iter().enumerate() {
        flat.push(match representative {
            Representative::Lowest => lowest,
            // Differences first, so that equal points have themselves as their mean.
            Representative::Mean => {
                lowest + points().map(|point| point[axis] - lowest).sum::<f64>() / class.len() as f64
            }
            Representative::Median => {
                let mut coordinates: Vec<f64> = points().map(|point| point[axis]).collect();
                coordinates.sort_unstable_by(f64::total_cmp);
                coordinates[(coordinates.len() - 1) / 2]
            }
        });
    }
}

fn chained(positions: &Positions, tolerance: f64) -> (Vec<u32>, usize) {
    let mut partition = UnionFind::new(positions.len());
    for [a, b] in NearPoints::connecting(positions, tolerance) {
        partition.unite(a, b);
    }
    let count = partition.class_count();
    (partition.class_numbers(), count)
}

fn greedy(positions: &Positions, tolerance: f64) -> (Vec<u32>, usize) {
    const NONE: u32 = u32::MAX;
    let pairs = NearPoints::all(positions, tolerance);
    let mut class_of = vec![NONE; positions.len()];
    let mut count = 0;
    let mut pairs = pairs.into_iter().peekable();
    for vertex in 0..positions.len() as u32 {
        let opens = class_of[vertex as usize] == NONE;
        if opens {
            class_of[vertex as usize] = count;
        }
        // Lower vertices are in classes by now, so only the pairs that start here matter.
        while let Some([_, other]) = pairs.next_if(|pair| pair[0] == vertex) {
            if opens && class_of[other as usize] == NONE {
                class_of[other as usize] = count;
            }
        }
        count += u32::from(opens);
    }
    (class_of, count as usize)
}

fn diameter(positions: &Positions, class: &[u32]) -> f64 {
    let point = |vertex: u32| positions.point(VertexId::from_u32(vertex));
    let square = |p: &[f64], q: &[f64]| p.iter().zip(q).map(|(x, y)| (x - y) * (x - y)).sum::<f64>();
    if class.len() <= 1000 {
        let mut largest: f64 = 0.0;
        for (i, &p) in class.iter().enumerate() {
            let p = point(p);
            for &q in &class[..i] {
                largest = largest.max(square(p, point(q)));
            }
        }
        return largest.sqrt();
    }
    let extreme = |pick: fn(f64, f64) -> f64, start: f64| -> Vec<f64> {
        let along = |axis: usize| class.iter().map(|&vertex| point(vertex)[axis]).fold(start, pick);
        (0..positions.dimension()).map(along).collect()
    };
    square(&extreme(f64::max, f64::NEG_INFINITY), &extreme(f64::min, f64::INFINITY)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_cross_is_one_class_in_any_order() {
        let arm = 0.8;
        let points = [[0.0, 0.0], [arm, 0.0], [-arm, 0.0], [0.0, arm], [0.0, -arm]];
        for first in 0..5 {
            let mut order = points;
            order.rotate_left(first);
            let positions = Positions::from_flat(2, order.concat()).unwrap();
            let classes =
                vertex_congruence(&positions, 1.0, ClassRule::Transitive, Representative::Mean).unwrap();
            assert_eq!(classes.class_count(), 1);
            assert!(classes.positions().as_flat().iter().all(|x| x.abs() < 1e-15));
        }
    }

    #[test]
    fn no_tolerance_means_equal_points() {
        let positions = Positions::from_flat(2, vec![1., 2., 3., 4., 1., 2., -0.0, 5., 0.0, 5.]).unwrap();
        for rule in [ClassRule::Transitive, ClassRule::Greedy] {
            let classes = vertex_congruence(&positions, 0.0, rule, Representative::Median).unwrap();
            assert_eq!(classes.class_of(), [0, 1, 0, 2, 2]);
            assert_eq!(classes.largest_diameter(), 0.0);
        }
        assert!(vertex_congruence(&positions, -1.0, ClassRule::Greedy, Representative::Lowest).is_err());
        let none =
            vertex_congruence(&Positions::default(), 1.0, ClassRule::Greedy, Representative::Mean).unwrap();
        assert_eq!(none.class_count(), 0);
    }

    proptest! {
        #[test]
        fn classes_partition_the_vertices(
            flat in prop::collection::vec(-20i32..20, 0..300), greedy: bool, tolerance in 0u8..6,
        ) {
            let flat: Vec<f64> = flat[..flat.len() / 2 * 2].iter().map(|&x| f64::from(x)).collect();
            let positions = Positions::from_flat(2, flat).unwrap();
            let rule = if greedy { ClassRule::Greedy } else { ClassRule::Transitive };
            let tolerance = f64::from(tolerance);
            let found = vertex_congruence(&positions, tolerance, rule, Representative::Lowest).unwrap();
            let mut seen = vec![false; positions.len()];
            let mut last = None;
            for (class, members) in found.members().iter().enumerate() {
                prop_assert!(last < Some(members[0]));
                last = Some(members[0]);
                for &member in members {
                    prop_assert!(!std::mem::replace(&mut seen[member as usize], true));
                    prop_assert_eq!(found.class_of()[member as usize] as usize, class);
                }
            }
            prop_assert!(seen.into_iter().all(|seen| seen));
            // Chained classes are closed: nothing outside is within the tolerance. Greedy ones are near their first members.
            for (vertex, &class) in found.class_of().iter().enumerate() {
                let near = |other: u32| {
                    let [p, q] = [vertex as u32, other].map(|v| positions.point(VertexId::from_u32(v)));
                    p.iter().zip(q).map(|(x, y)| (x - y) * (x - y)).sum::<f64>() <= tolerance * tolerance
                };
                if greedy {
                    prop_assert!(near(found.members().list(class as usize)[0]));
                } else {
                    let others = (0..positions.len() as u32).filter(|&other| near(other));
                    prop_assert!(others.clone().all(|other| found.class_of()[other as usize] == class));
                }
            }
        }
    }
}
