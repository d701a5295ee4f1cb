//! Blocks of vertices that a congruence should not bring together.

use super::VertexCongruence;
use coface_algebra::UnionFind;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_geometry::Positions;

/// What to do where vertices of one block are congruent.
///
/// Blocks are the parts that a model was put together from. Congruence is meant to join different ones; where it joins
/// vertices of one, the tolerance is above the size of its features.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum BlockPolicy {
    /// It is as it is: nothing is looked for.
    Allow,
    /// They are listed.
    #[default]
    Warn,
    /// They are an error.
    Forbid,
}

/// Vertices of one block in one class.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct BlockMerge {
    /// The class.
    pub class: usize,
    /// The block.
    pub block: u32,
    /// The vertices of the block in the class, rising; at least two.
    pub vertices: Vec<u32>,
    /// The smallest distance of two of them: the tolerance that they allow is below it.
    pub distance: f64,
}

/// The block of each vertex of a complex: its connected components, numbered by their lowest vertices.
///
/// Cells of any degree connect what their boundaries are made of, so a face connects its outer rim with its holes.
///
/// # Complexity
/// Nearly linear in the entries of the boundary matrices.
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::congruence::blocks_of;
/// use coface_complexes::surface::PolygonMesh;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangles = PolygonMesh::new(7, RaggedArray::from_lists([[0, 2, 4], [1, 3, 5]]), &[])?.chain_complex()?;
/// assert_eq!(blocks_of(&triangles), [0, 1, 0, 1, 0, 1, 2]);
/// # Ok(()) }
/// ```
pub fn blocks_of(complex: &ChainComplex) -> Vec<u32> {
    let vertex_count = complex.cell_count(0);
    let mut partition = UnionFind::new(vertex_count);
    // A vertex of each cell below, none for a cell without vertices.
    let mut vertices: Vec<Option<u32>> = (0..vertex_count as u32).map(Some).collect();
    for matrix in complex.boundary_matrices() {
        let own = matrix.columns().map(|column| {
            let mut of_facets = column.rows().iter().filter_map(|&facet| vertices[facet as usize]);
            let first = of_facets.next()?;
            of_facets.for_each(|vertex| {
                partition.unite(first, vertex);
            });
            Some(first)
        });
        vertices = own.collect();
    }
    partition.class_numbers()
}

/// The vertices of one block that are in one class, by classes and blocks.
///
/// `positions` are those of the vertices, `blocks` has the block of each.
///
/// # Errors
/// [`ErrorKind::Shape`] unless there is a position and a block for each vertex; with [`BlockPolicy::Forbid`]
/// [`ErrorKind::InvalidInput`] naming two vertices of one block in one class, the block and their distance.
///
/// # Complexity
/// $O(n \log^2 n)$ for n vertices in all, unless those of a class are very unevenly spread.
///
/// # Examples
/// Two segments, 0 to 1 and 1.01 to 1.05. With a tolerance of 0.1 the second one shrinks to a point.
/// ```
/// use coface_arrange::congruence::{
///     BlockPolicy, ClassRule, Representative, check_blocks, vertex_congruence,
/// };
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ends = Positions::from_flat(1, vec![0.0, 1.0, 1.01, 1.05])?;
/// let classes = vertex_congruence(&ends, 0.1, ClassRule::Transitive, Representative::Lowest)?;
/// let merges = check_blocks(&classes, &ends, &[0, 0, 1, 1], BlockPolicy::Warn)?;
/// assert_eq!((merges[0].block, &merges[0].vertices[..]), (1, &[2, 3][..]));
/// assert!(check_blocks(&classes, &ends, &[0, 0, 1, 1], BlockPolicy::Forbid).is_err());
/// # Ok(()) }
/// ```
pub fn check_blocks(
    classes: &VertexCongruence,
    positions: &Positions,
    blocks: &[u32],
    policy: BlockPolicy,
) -> Result<Vec<BlockMerge>, Error> {
    let vertex_count = classes.class_of().len();
    if blocks.len() != vertex_count || positions.len() != vertex_count {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("{} positions and {} blocks for {vertex_count} vertices", positions.len(), blocks.len()),
        ));
    }
    let mut merges = Vec::new();
    if policy == BlockPolicy::Allow {
        return Ok(merges);
    }
    let mut members: Vec<(u32, u32)> = Vec::new();
    for (class, vertices) in classes.members().iter().enumerate() {
        if vertices.len() == 1 {
            continue;
        }
        members.clear();
        members.extend(vertices.iter().map(|&vertex| (blocks[vertex as usize], vertex)));
        members.sort_unstable();
        for group in members.chunk_by(|a, b| a.0 == b.0).filter(|group| group.len() > 1) {
            let block = group[0].0;
            let vertices: Vec<u32> = group.iter().map(|&(_, vertex)| vertex).collect();
            let (distance, [a, b]) = nearest(positions, &vertices);
            if policy == BlockPolicy::Forbid {
                return Err(Error::invalid(format!(
                    "vertices v{a} and v{b} of block {block} are {distance} apart and become one"
                ))
                .with_cure(
                    "choose a tolerance below the distances within a block, or allow such vertices to merge",
                ));
            }
            merges.push(BlockMerge { class, block, vertices, distance });
        }
    }
    Ok(merges)
}

/// Two points at their distance.
type Pair = (f64, [u32; 2]);

/// The nearest two of at least two points, and their distance.
///
/// # References
/// M. I. Shamos and D. Hoey, *Closest-point problems* (1975).
fn nearest(positions: &Positions, vertices: &[u32]) -> Pair {
    let mut best = (f64::INFINITY, [vertices[0], vertices[1]]);
    visit_halves(positions, &mut vertices.to_vec(), &mut best);
    best
}

/// Halves the points along their widest axis, and then compares those near the plane between.
fn visit_halves(positions: &Positions, vertices: &mut [u32], best: &mut Pair) {
    const FEW: usize = 16;
    let at = |vertex: u32, axis: usize| positions.point(VertexId::from_u32(vertex))[axis];
    if vertices.len() <= FEW {
        return sweep(positions, vertices, best);
    }
    let axis = widest_axis(positions, vertices);
    let half = vertices.len() / 2;
    vertices.select_nth_unstable_by(half, |&a, &b| at(a, axis).total_cmp(&at(b, axis)).then(a.cmp(&b)));
    let wall = at(vertices[half], axis);
    let (low, high) = vertices.split_at_mut(half);
    visit_halves(positions, low, best);
    visit_halves(positions, high, best);
    // Nothing is nearer than equal points.
    if best.0 > 0.0 {
        let is_near = |vertex: &&u32| (at(**vertex, axis) - wall).abs() <= best.0;
        let mut strip: Vec<u32> = vertices.iter().filter(is_near).copied().collect();
        sweep(positions, &mut strip, best);
    }
}

fn widest_axis(positions: &Positions, vertices: &[u32]) -> usize {
    let extent = |axis: usize| {
        let coordinates = vertices.iter().map(|&vertex| positions.point(VertexId::from_u32(vertex))[axis]);
        let bounds = [f64::INFINITY, f64::NEG_INFINITY];
        let [low, high] = coordinates.fold(bounds, |[low, high], x| [low.min(x), high.max(x)]);
        high - low
    };
    (0..positions.dimension()).max_by(|&i, &j| extent(i).total_cmp(&extent(j))).unwrap_or(0)
}

/// Compares points sorted along their widest axis, as far as needed.
fn sweep(positions: &Positions, vertices: &mut [u32], best: &mut Pair) {
    let point = |vertex: u32| positions.point(VertexId::from_u32(vertex));
    let axis = widest_axis(positions, vertices);
    vertices.sort_unstable_by(|&a, &b| point(a)[axis].total_cmp(&point(b)[axis]).then(a.cmp(&b)));
    for (i, &a) in vertices.iter().enumerate() {
        for &b in &vertices[i + 1..] {
            if best.0 == 0.0 || point(b)[axis] - point(a)[axis] > best.0 {
                break;
            }
            let distance = point(a).iter().zip(point(b)).fold(0.0, |sum: f64, (x, y)| sum.hypot(x - y));
            let found = (distance, [a.min(b), a.max(b)]);
            if found < *best {
                *best = found;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Each with each would be 5 thousand million pairs, and all have the same first coordinate.
    #[test]
    fn many_points_in_a_plane() {
        let place = |i: u32| [0.0, f64::from(i % 300), f64::from(i / 300) * 1.5];
        let flat = (0..100_000).flat_map(place).collect();
        let positions = Positions::from_flat(3, flat).unwrap();
        let vertices: Vec<u32> = (0..100_000).collect();
        assert_eq!(nearest(&positions, &vertices).0, 1.0);
    }

    proptest! {
        #[test]
        fn the_nearest_two_are_those_of_all_pairs(
            dimension in 1usize..5,
            flat in prop::collection::vec(0i32..1000, 8..600),
            is_flat: bool,
        ) {
            let flat: Vec<f64> = flat[..flat.len() / dimension * dimension]
                .iter()
                .enumerate()
                .map(|(i, &x)| if is_flat && dimension > 1 && i % dimension == 0 { 1.0 } else { f64::from(x) })
                .collect();
            let positions = Positions::from_flat(dimension, flat).unwrap();
            let point = |vertex: u32| positions.point(VertexId::from_u32(vertex));
            let distance = |a: u32, b: u32| {
                point(a).iter().zip(point(b)).fold(0.0, |sum: f64, (x, y)| sum.hypot(x - y))
            };
            let vertices: Vec<u32> = (0..positions.len() as u32).collect();
            let (found, [a, b]) = nearest(&positions, &vertices);
            let all = vertices.iter().flat_map(|&a| (0..a).map(move |b| (a, b)));
            prop_assert_eq!(found, all.map(|(a, b)| distance(a, b)).fold(f64::INFINITY, f64::min));
            prop_assert!(a < b);
            prop_assert_eq!(found, distance(a, b));
        }
    }
}
