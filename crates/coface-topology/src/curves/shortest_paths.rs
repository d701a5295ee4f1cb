//! Shortest paths along the edges of a surface.

use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, Error, ErrorKind, VertexId};
use coface_algebra::{RaggedArray, UnionFind};
use coface_complexes::surface::GeneralizedMap;
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// Trees of shortest paths, one in each component with edges. Ties are decided by numbers, so that the trees are always
/// the same.
#[derive(Clone, Debug)]
pub(super) struct ShortestPaths {
    /// The roots: the chosen one first, then the first vertices of the other components.
    pub(super) bases: Vec<VertexId>,
    /// The length of the path to each vertex; infinite for isolated vertices.
    pub(super) distances: Vec<f64>,
    /// The last step of each path (2e along edge e, 2e + 1 against it); `NONE` where there is none.
    pub(super) steps: Vec<u32>,
}

/// A vertex on its way into a tree.
#[derive(PartialEq)]
struct Reached {
    distance: f64,
    vertex: u32,
}

impl Eq for Reached {}

impl Ord for Reached {
    fn cmp(&self, other: &Self) -> Ordering {
        self.distance.total_cmp(&other.distance).then(self.vertex.cmp(&other.vertex))
    }
}

impl PartialOrd for Reached {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl ShortestPaths {
    /// Dijkstra's algorithm in each component.
    pub(super) fn new(map: &GeneralizedMap, base: Option<VertexId>, lengths: &[f64]) -> Self {
        let ends = map.skeleton().edge_ends();
        let vertex_count = map.skeleton().vertex_count();
        let steps_at = RaggedArray::grouped(vertex_count, ends.iter().copied());
        let mut found = Self {
            bases: Vec::new(),
            distances: vec![f64::INFINITY; vertex_count],
            steps: vec![NONE; vertex_count],
        };
        let mut heap = BinaryHeap::new();
        let steps = stage("finding shortest paths", vertex_count);
        let mut settled = 0;
        for root in base.into_iter().chain(first_vertices(map)) {
            if found.distances[root.index()].is_finite() {
                continue;
            }
            found.bases.push(root);
            found.distances[root.index()] = 0.0;
            heap.push(Reverse(Reached { distance: 0.0, vertex: root.to_u32() }));
            while let Some(Reverse(Reached { distance, vertex })) = heap.pop() {
                if distance > found.distances[vertex as usize] {
                    continue;
                }
                settled += 1;
                if settled <= vertex_count {
                    steps.pass(settled);
                }
                for &step in steps_at.list(vertex as usize) {
                    let next = ends[(step ^ 1) as usize] as usize;
                    let through = distance + lengths[(step >> 1) as usize];
                    if through < found.distances[next] {
                        found.distances[next] = through;
                        found.steps[next] = step;
                        heap.push(Reverse(Reached { distance: through, vertex: next as u32 }));
                    }
                }
            }
        }
        found
    }
}

/// The first vertex of each component with edges, rising.
pub(super) fn first_vertices(map: &GeneralizedMap) -> Vec<VertexId> {
    let vertex_count = map.skeleton().vertex_count();
    let mut partition = UnionFind::new(vertex_count);
    let mut has_edge = vec![false; vertex_count];
    let steps = stage("joining components", map.skeleton().edge_count());
    for &[a, b] in steps.each(map.skeleton().edge_ends().as_chunks::<2>().0) {
        partition.unite(a, b);
        has_edge[a as usize] = true;
        has_edge[b as usize] = true;
    }
    let mut seen = vec![false; vertex_count];
    (0..vertex_count as u32)
        .filter(|&v| has_edge[v as usize] && !std::mem::replace(&mut seen[partition.find(v) as usize], true))
        .map(VertexId::from_u32)
        .collect()
}

pub(super) fn checked_lengths(map: &GeneralizedMap, lengths: Option<&[f64]>) -> Result<Vec<f64>, Error> {
    let count = map.skeleton().edge_count();
    let Some(lengths) = lengths else { return Ok(vec![1.0; count]) };
    if lengths.len() != count {
        return Err(Error::new(ErrorKind::Shape, format!("{} lengths for {count} edges", lengths.len())));
    }
    match lengths.iter().position(|length| !length.is_finite() || *length < 0.0) {
        None => Ok(lengths.to_vec()),
        Some(edge) => {
            Err(Error::invalid(format!("edge {} has the length {}", EdgeId::new(edge), lengths[edge]))
                .with_cure("give finite lengths that are not negative"))
        }
    }
}
