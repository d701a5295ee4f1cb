//! Congruence of vertices.

use super::near_points::{NearPoints, is_near};
use coface_algebra::progress::stage;
use coface_algebra::{Error, VertexId};
use coface_algebra::{RaggedArray, UnionFind};
use coface_geometry::Positions;
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
    /// At the median of its members on each axis; for an even number the lower one, so that it is a coordinate of the
    /// input.
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
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::{ClassRule, Representative, vertex_congruence};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Positions::from_flat(1, vec![0.0, 5.0, 0.25])?;
    /// let near = vertex_congruence(&points, 0.5, ClassRule::Transitive, Representative::Lowest)?;
    /// assert_eq!(near.members().list(0), [0, 2]);
    /// # Ok(()) }
    /// ```
    pub fn members(&self) -> &RaggedArray {
        &self.members
    }

    /// The number of classes.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::{ClassRule, Representative, vertex_congruence};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Positions::from_flat(1, vec![0.0, 5.0, 0.25])?;
    /// let near = vertex_congruence(&points, 0.5, ClassRule::Transitive, Representative::Lowest)?;
    /// assert_eq!(near.class_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn class_count(&self) -> usize {
        self.members.len()
    }

    /// The class of each vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::{ClassRule, Representative, vertex_congruence};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Positions::from_flat(1, vec![0.0, 5.0, 0.25])?;
    /// let near = vertex_congruence(&points, 0.5, ClassRule::Transitive, Representative::Lowest)?;
    /// assert_eq!(near.class_of(), [0, 1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn class_of(&self) -> &[u32] {
        &self.class_of
    }

    /// The positions of the classes.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::{ClassRule, Representative, vertex_congruence};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Positions::from_flat(1, vec![0.0, 5.0, 0.25])?;
    /// let near = vertex_congruence(&points, 0.5, ClassRule::Transitive, Representative::Lowest)?;
    /// assert_eq!(near.positions().as_flat(), [0.0, 5.0]);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The largest distance of two members of a class; of classes with more than 1000 members the diagonal of the box
    /// around them, which is no less.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::{ClassRule, Representative, vertex_congruence};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Positions::from_flat(1, vec![0.0, 5.0, 0.25])?;
    /// let near = vertex_congruence(&points, 0.5, ClassRule::Transitive, Representative::Lowest)?;
    /// assert_eq!(near.largest_diameter(), 0.25);
    /// # Ok(()) }
    /// ```
    pub fn largest_diameter(&self) -> f64 {
        self.largest_diameter
    }
}

/// The classes of vertices within a tolerance of each other, a length in the unit of the positions.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] for a tolerance that is negative or not a number.
///
/// # Complexity
/// Nearly linear where not many vertices are within a tolerance; parallel, with the same result whatever the number of
/// threads.
///
/// # Examples
/// Three points in a row, 0.8 apart: by chains all are congruent; greedily the third is not.
/// ```
/// use coface_arrange::congruence::{ClassRule, Representative, vertex_congruence};
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
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
        return Err(Error::invalid(format!("{tolerance} is not a tolerance"))
            .with_cure("give a length that is not negative, in the unit of the positions"));
    }
    let (class_of, class_count) = class_numbers(positions, tolerance, rule);
    represented(positions, class_of, class_count, representative)
}

/// The classes of vertices, merged again as long as classes are within the tolerance of each other.
///
/// Once is enough for [`Representative::Lowest`]: members of different classes, or first members of greedy classes, are
/// farther apart than the tolerance. Means and medians can be nearer. Here classes whose positions are congruent are
/// united and get a position from all their vertices, until no two are within the tolerance; so doing it once more,
/// with the positions of the classes, changes nothing. With [`ClassRule::Transitive`] neither the classes nor, up to
/// rounding, means and medians depend on the order of the vertices. With [`ClassRule::Greedy`] united classes may be
/// longer than the rule says.
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
/// use coface_arrange::congruence::{
///     ClassRule, Representative, stable_vertex_congruence, vertex_congruence,
/// };
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
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
    let steps = stage("placing classes", class_count);
    let blocks: Vec<(Vec<f64>, f64)> = (0..class_count.div_ceil(BLOCK))
        .into_par_iter()
        .map(|block| {
            let (mut flat, mut largest): (Vec<f64>, f64) = (Vec::new(), 0.0);
            for class in block * BLOCK..((block + 1) * BLOCK).min(class_count) {
                steps.pass(class);
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

/// A greedy class lies in a chained one, so each of these is cut by itself.
fn greedy(positions: &Positions, tolerance: f64) -> (Vec<u32>, usize) {
    let (chain_of, chain_count) = chained(positions, tolerance);
    let chains = RaggedArray::grouped(chain_count, chain_of.iter().copied());
    // The vertex that opened the class of each.
    let mut opener: Vec<u32> = (0..positions.len() as u32).collect();
    let steps = stage("opening classes", positions.len());
    for chain in chains.iter().filter(|chain| chain.len() > 1) {
        steps.advance(chain.len());
        open_classes(positions, tolerance, chain, &mut opener);
    }
    let (mut class_of, mut count) = (vec![0; positions.len()], 0);
    for (vertex, &opener) in opener.iter().enumerate() {
        // A class is opened by its lowest member.
        class_of[vertex] = if opener as usize == vertex { count } else { class_of[opener as usize] };
        count += u32::from(opener as usize == vertex);
    }
    (class_of, count as usize)
}

/// Sets the openers of the vertices of a chain, which are rising.
///
/// The vertices are in cubes about as wide as the tolerance, by their first three coordinates. Openers are farther
/// apart than that, so that only a bounded number of them looks into a cube.
fn open_classes(positions: &Positions, tolerance: f64, chain: &[u32], opener: &mut [u32]) {
    const NONE: u32 = u32::MAX;
    let point = |vertex: u32| positions.point(VertexId::from_u32(vertex));
    if tolerance == 0.0 {
        return chain.iter().for_each(|&vertex| opener[vertex as usize] = chain[0]);
    }
    let axes = positions.dimension().min(3);
    // Halves, whose differences are finite; a little wider, so that rounding takes no near points apart.
    let (mut low, side) = ([f64::INFINITY; 3], tolerance * 0.5 * 1.0001);
    for &vertex in chain {
        (0..axes).for_each(|axis| low[axis] = low[axis].min(point(vertex)[axis] / 2.0));
    }
    let cube = |vertex: u32| {
        let mut cube = [0; 3];
        (0..axes).for_each(|axis| cube[axis] = ((point(vertex)[axis] / 2.0 - low[axis]) / side) as u32);
        cube
    };
    let mut sorted: Vec<([u32; 3], u32)> = chain.iter().map(|&vertex| (cube(vertex), vertex)).collect();
    sorted.sort_unstable();
    // The cubes with the vertices in them that have no class yet: a start and a length.
    let mut cubes: Vec<([u32; 3], usize, usize)> = Vec::new();
    for group in sorted.chunk_by(|a, b| a.0 == b.0) {
        let start = cubes.last().map_or(0, |&(_, start, length)| start + length);
        cubes.push((group[0].0, start, group.len()));
    }
    let mut left: Vec<u32> = sorted.iter().map(|&(_, vertex)| vertex).collect();
    chain.iter().for_each(|&vertex| opener[vertex as usize] = NONE);
    for &vertex in chain {
        if opener[vertex as usize] != NONE {
            continue;
        }
        let [i, j, k] = cube(vertex);
        for x in i.saturating_sub(1)..=i.saturating_add(1) {
            for y in j.saturating_sub(1)..=j.saturating_add(1) {
                let first = cubes.partition_point(|cube| cube.0 < [x, y, k.saturating_sub(1)]);
                let last = [x, y, k.saturating_add(1)];
                for (_, start, length) in cubes[first..].iter_mut().take_while(|cube| cube.0 <= last) {
                    let own = &mut left[*start..*start + *length];
                    let mut kept = 0;
                    for place in 0..own.len() {
                        let other = own[place];
                        if is_near(point(vertex), point(other), tolerance) {
                            opener[other as usize] = vertex;
                        } else {
                            own[kept] = other;
                            kept += 1;
                        }
                    }
                    *length = kept;
                }
            }
        }
    }
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

    /// Each with each would be 20 thousand million pairs.
    #[test]
    fn greedy_classes_of_many_near_points() {
        let flat =
            (0..200_000).flat_map(|i| [f64::from(i % 400) / 400.0, f64::from(i / 400) / 500.0]).collect();
        let positions = Positions::from_flat(2, flat).unwrap();
        let found = vertex_congruence(&positions, 5.0, ClassRule::Greedy, Representative::Lowest).unwrap();
        assert_eq!(found.class_count(), 1);
    }

    proptest! {
        /// By the definition: the lowest vertex without a class opens one, with all others without class near it.
        #[test]
        fn greedy_classes_are_those_of_the_rule(
            dimension in 1usize..5,
            flat in prop::collection::vec(0i32..40, 0..400),
            tolerance in prop::sample::select(vec![0.0, 1.0, 2.5, 7.0, 60.0]),
        ) {
            let flat: Vec<f64> = flat[..flat.len() / dimension * dimension].iter().map(|&x| f64::from(x)).collect();
            let positions = Positions::from_flat(dimension, flat).unwrap();
            let point = |vertex: usize| positions.point(VertexId::new(vertex));
            let mut expected = vec![None; positions.len()];
            let mut count = 0u32;
            for vertex in 0..positions.len() {
                if expected[vertex].is_some() {
                    continue;
                }
                for (other, class) in expected.iter_mut().enumerate().skip(vertex) {
                    let square: f64 =
                        point(vertex).iter().zip(point(other)).map(|(x, y)| (x - y) * (x - y)).sum();
                    if class.is_none() && square <= tolerance * tolerance {
                        *class = Some(count);
                    }
                }
                count += 1;
            }
            let (found, found_count) = greedy(&positions, tolerance);
            prop_assert_eq!(found.into_iter().map(Some).collect::<Vec<_>>(), expected);
            prop_assert_eq!(found_count, count as usize);
        }

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
            // Chained classes are closed: nothing outside is within the tolerance. Greedy ones are near their first
            // members.
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
