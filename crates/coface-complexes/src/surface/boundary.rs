//! The boundary of a mesh: the edges in exactly one face, loop by loop.

use super::PolygonMesh;
use coface_algebra::UnionFind;
use coface_algebra::{EdgeId, VertexId};
use std::collections::{BTreeMap, BTreeSet};

/// A connected component of the graph of the edges with exactly one face.
///
/// On a surface it is a simple loop. Where sheets touch in a vertex, or an edge has three faces, several loops can
/// run together, and the component is no simple loop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BoundaryLoop {
    edges: Vec<EdgeId>,
    vertices: Vec<VertexId>,
    walks: Vec<Vec<VertexId>>,
    is_simple: bool,
}

impl BoundaryLoop {
    /// Its vertices. Of a simple loop: in order, from the smallest, in the direction of the face at the edge that is
    /// first in [`Self::edges`]. Otherwise rising.
    pub fn vertices(&self) -> &[VertexId] {
        &self.vertices
    }

    /// Its edges. Of a simple loop: in order, edge i from vertex i to the next. Otherwise rising.
    pub fn edges(&self) -> &[EdgeId] {
        &self.edges
    }

    /// The walks that its edges make, each edge in one of them: simple loops, whose first vertex is there again at the
    /// end, and paths between vertices where an odd number of the edges meet. A simple loop is one walk.
    ///
    /// # Examples
    /// Two triangles that touch in a vertex.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let touching = PolygonMesh::new(5, RaggedArray::from_lists([[0, 1, 2], [0, 3, 4]]), &[])?;
    /// let walks: Vec<Vec<usize>> = touching.boundary_loops()[0]
    ///     .walks()
    ///     .iter()
    ///     .map(|walk| walk.iter().map(|v| v.index()).collect())
    ///     .collect();
    /// assert_eq!(walks, [[0, 1, 2, 0], [0, 3, 4, 0]]);
    /// # Ok(()) }
    /// ```
    pub fn walks(&self) -> &[Vec<VertexId>] {
        &self.walks
    }

    /// Whether each vertex lies on exactly two of the edges.
    pub fn is_simple(&self) -> bool {
        self.is_simple
    }
}

impl PolygonMesh {
    /// The boundary: the components of the graph of edges with exactly one face, by their smallest vertices.
    ///
    /// # Complexity
    /// One pass over the edges and $O(b \log b)$ for b boundary edges.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonMesh::new(3, RaggedArray::from_lists([[0, 2, 1]]), &[])?;
    /// let loops = triangle.boundary_loops();
    /// let vertices: Vec<usize> = loops[0].vertices().iter().map(|v| v.index()).collect();
    /// assert_eq!(vertices, [0, 2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn boundary_loops(&self) -> Vec<BoundaryLoop> {
        let edges: Vec<u32> = self
            .edge_degrees()
            .enumerate()
            .filter(|&(_, count)| count == 1)
            .map(|(edge, _)| edge as u32)
            .collect();
        let mut vertices: Vec<u32> = edges.iter().flat_map(|&edge| self.ends(edge as usize)).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let local =
            |v: u32| vertices.binary_search(&v).expect("the ends of boundary edges were listed") as u32;

        // The boundary edges at each boundary vertex, compressed.
        let ends: Vec<[u32; 2]> = edges.iter().map(|&edge| self.ends(edge as usize).map(local)).collect();
        let mut starts = vec![0u32; vertices.len() + 1];
        let mut partition = UnionFind::new(vertices.len());
        for &[a, b] in &ends {
            starts[a as usize + 1] += 1;
            starts[b as usize + 1] += 1;
            partition.unite(a, b);
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut around = vec![0u32; 2 * ends.len()];
        for (i, pair) in ends.iter().enumerate() {
            for &end in pair {
                let at = &mut next[end as usize];
                around[*at as usize] = i as u32;
                *at += 1;
            }
        }
        let edges_at = |v: u32| &around[starts[v as usize] as usize..starts[v as usize + 1] as usize];

        let class = partition.class_numbers();
        let mut loops: Vec<BoundaryLoop> = (0..partition.class_count())
            .map(|_| BoundaryLoop {
                edges: Vec::new(),
                vertices: Vec::new(),
                walks: Vec::new(),
                is_simple: true,
            })
            .collect();
        for v in 0..vertices.len() as u32 {
            let component = &mut loops[class[v as usize] as usize];
            component.is_simple &= edges_at(v).len() == 2;
            component.vertices.push(VertexId::from_u32(v));
        }
        for (i, &[a, _]) in ends.iter().enumerate() {
            loops[class[a as usize] as usize].edges.push(EdgeId::new(i));
        }
        for component in &mut loops {
            if component.is_simple {
                // Leave the smallest vertex along the face: by the edge that its face runs away from the vertex.
                let start = component.vertices[0].to_u32();
                let leaves = |&&i: &&u32| {
                    let reversed = self.packed_faces(edges[i as usize] as usize)[0] & 1;
                    ends[i as usize][reversed as usize] == start
                };
                let around_start = edges_at(start);
                let mut edge = *around_start.iter().find(leaves).unwrap_or(&around_start[0]);
                let mut at = start;
                component.vertices.clear();
                component.edges.clear();
                loop {
                    component.vertices.push(VertexId::from_u32(at));
                    component.edges.push(EdgeId::from_u32(edge));
                    let [a, b] = ends[edge as usize];
                    at = if a == at { b } else { a };
                    if at == start {
                        break;
                    }
                    let [first, second] = edges_at(at) else {
                        unreachable!("a simple loop has two edges at a vertex")
                    };
                    edge = if *first == edge { *second } else { *first };
                }
            }
            component.walks = match component.is_simple {
                true => vec![component.vertices.iter().chain(component.vertices.first()).copied().collect()],
                false => walks(&component.vertices, &ends, &edges_at),
            };
            for vertex in component.vertices.iter_mut().chain(component.walks.iter_mut().flatten()) {
                *vertex = VertexId::from_u32(vertices[vertex.index()]);
            }
            for edge in &mut component.edges {
                *edge = EdgeId::from_u32(edges[edge.index()]);
            }
        }
        loops
    }
}

/// The edges at some vertices as simple loops and paths. Paths begin where an odd number of edges meet.
fn walks<'a>(
    vertices: &[VertexId],
    ends: &[[u32; 2]],
    edges_at: &impl Fn(u32) -> &'a [u32],
) -> Vec<Vec<VertexId>> {
    let mut met: BTreeSet<u32> = BTreeSet::new();
    let mut walks = Vec::new();
    let (odd, even): (Vec<u32>, Vec<u32>) =
        vertices.iter().map(|vertex| vertex.to_u32()).partition(|&vertex| edges_at(vertex).len() % 2 == 1);
    for start in odd.into_iter().chain(even) {
        while let Some(first) = edges_at(start).iter().find(|edge| !met.contains(edge)) {
            // The walk so far, from which each loop is taken as soon as it closes.
            let mut walk = vec![start];
            let mut places = BTreeMap::from([(start, 0)]);
            let mut edge = Some(*first);
            while let Some(along) = edge {
                met.insert(along);
                let [a, b] = ends[along as usize];
                let at = if walk[walk.len() - 1] == a { b } else { a };
                if let Some(&place) = places.get(&at) {
                    walks.push(walk[place..].iter().chain([&at]).copied().map(VertexId::from_u32).collect());
                    walk.drain(place + 1..).for_each(|vertex| {
                        places.remove(&vertex);
                    });
                } else {
                    places.insert(at, walk.len());
                    walk.push(at);
                }
                edge = edges_at(at).iter().find(|edge| !met.contains(edge)).copied();
            }
            if walk.len() > 1 {
                walks.push(walk.into_iter().map(VertexId::from_u32).collect());
            }
        }
    }
    walks
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::RaggedArray;
    use proptest::prelude::*;

    fn loops_of(vertex_count: usize, polygons: &[Vec<u32>]) -> (PolygonMesh, Vec<BoundaryLoop>) {
        let mesh = PolygonMesh::new(vertex_count, RaggedArray::from_lists(polygons), &[]).unwrap();
        let loops = mesh.boundary_loops();
        (mesh, loops)
    }

    fn numbers(vertices: &[VertexId]) -> Vec<u32> {
        vertices.iter().map(|v| v.to_u32()).collect()
    }

    #[test]
    fn an_annulus_has_two_loops_along_its_faces() {
        let quadrangles: Vec<Vec<u32>> =
            (0..4).map(|i| vec![i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i]).collect();
        let (_, loops) = loops_of(8, &quadrangles);
        assert_eq!(loops.len(), 2);
        assert_eq!(numbers(loops[0].vertices()), [0, 1, 2, 3]);
        assert_eq!(numbers(loops[1].vertices()), [4, 7, 6, 5]);
    }

    #[test]
    fn loops_that_touch_are_one_component_and_not_simple() {
        let (_, touching) = loops_of(5, &[vec![0, 1, 2], vec![0, 3, 4]]);
        assert_eq!((touching.len(), touching[0].is_simple(), touching[0].edges().len()), (1, false, 6));
        let (_, book) = loops_of(5, &[vec![0, 1, 2], vec![0, 1, 3], vec![0, 1, 4]]);
        assert_eq!(
            (book.len(), book[0].is_simple(), numbers(book[0].vertices())),
            (1, false, vec![0, 1, 2, 3, 4])
        );
    }

    proptest! {
        #[test]
        fn loops_partition_the_boundary_edges(
            triangles in prop::collection::vec(
                Just((0u32..10).collect::<Vec<_>>()).prop_shuffle().prop_map(|v| v[..3].to_vec()), 0..12),
        ) {
            let (mesh, loops) = loops_of(10, &triangles);
            let mut found: Vec<EdgeId> = loops.iter().flat_map(|l| l.edges().to_vec()).collect();
            found.sort_unstable();
            let all: Vec<EdgeId> =
                (0..mesh.edge_count()).map(EdgeId::new).filter(|&e| mesh.face_count_at(e) == 1).collect();
            prop_assert_eq!(found, all);
            for component in &loops {
                let mut degree: BTreeMap<VertexId, usize> = BTreeMap::new();
                for end in component.edges().iter().flat_map(|&e| mesh.edge(e)) {
                    *degree.entry(end).or_default() += 1;
                }
                prop_assert_eq!(component.is_simple(), degree.values().all(|&d| d == 2));
                prop_assert_eq!(component.vertices().len(), degree.len());
                let mut walked = Vec::new();
                for walk in component.walks() {
                    let is_closed = walk.first() == walk.last();
                    for pair in walk.windows(2) {
                        walked.push(mesh.edge_between(pair[0], pair[1]).unwrap());
                    }
                    let mut inside = walk[usize::from(is_closed)..].to_vec();
                    inside.sort_unstable();
                    prop_assert!(inside.windows(2).all(|pair| pair[0] != pair[1]), "a walk meets itself");
                    prop_assert!(is_closed || [walk[0], walk[walk.len() - 1]].iter().all(|v| degree[v] % 2 == 1));
                }
                walked.sort_unstable();
                let mut all = component.edges().to_vec();
                all.sort_unstable();
                prop_assert_eq!(walked, all);
                if component.is_simple() {
                    let n = component.vertices().len();
                    for (i, &edge) in component.edges().iter().enumerate() {
                        let (a, b) = (component.vertices()[i], component.vertices()[(i + 1) % n]);
                        prop_assert_eq!(mesh.edge_between(a, b), Some(edge));
                    }
                }
            }
        }
    }
}
