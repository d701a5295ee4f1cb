//! Blocks of vertices that a congruence should not bring together.

use super::VertexCongruence;
use crate::algebra::UnionFind;
use crate::chains::ChainComplex;
use crate::geometry::Positions;
use crate::{Error, ErrorKind, VertexId};

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
/// use coface::algebra::RaggedArray;
/// use coface::arrangement::congruence::blocks_of;
/// use coface::surface::PolygonMesh;
/// # fn main() -> Result<(), coface::Error> {
/// let triangles = PolygonMesh::new(7, RaggedArray::from_lists([[0, 2, 4], [1, 3, 5]]), &[])?.chain_complex();
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
/// $O(n \log n)$ for n vertices; more only where many vertices of one block are as near as the nearest ones.
///
/// # Examples
/// Two segments, 0 to 1 and 1.01 to 1.05. With a tolerance of 0.1 the second one shrinks to a point.
/// ```
/// use coface::arrangement::congruence::{
///     BlockPolicy, ClassRule, Representative, check_blocks, vertex_congruence,
/// };
/// use coface::geometry::Positions;
/// # fn main() -> Result<(), coface::Error> {
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

/// The nearest two of at least two points, and their distance: sorted along the first axis, compared as far as needed.
fn nearest(positions: &Positions, vertices: &[u32]) -> (f64, [u32; 2]) {
    let point = |vertex: u32| positions.point(VertexId::from_u32(vertex));
    let mut sorted = vertices.to_vec();
    sorted.sort_by(|&a, &b| point(a)[0].total_cmp(&point(b)[0]));
    let mut best = (f64::INFINITY, [sorted[0].min(sorted[1]), sorted[0].max(sorted[1])]);
    for (i, &a) in sorted.iter().enumerate() {
        for &b in &sorted[i + 1..] {
            if point(b)[0] - point(a)[0] > best.0 {
                break;
            }
            let distance = point(a).iter().zip(point(b)).fold(0.0, |sum: f64, (x, y)| sum.hypot(x - y));
            let pair = [a.min(b), a.max(b)];
            if (distance, pair) < best {
                best = (distance, pair);
            }
            // Nothing is nearer than equal points.
            if distance == 0.0 {
                return best;
            }
        }
    }
    best
}
