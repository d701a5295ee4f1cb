//! Connected components.

use super::PolygonMesh;
use coface_algebra::UnionFind;
use coface_algebra::VertexId;
use coface_algebra::progress::stage_of_many;

/// The connected components of a mesh; each isolated vertex is one.
///
/// Components are numbered in the order of their first vertices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Components {
    count: usize,
    of_vertex: Vec<u32>,
}

impl Components {
    /// The components of a graph on `vertex_count` vertices with these edges, two ends by two.
    pub(crate) fn of_graph(vertex_count: usize, ends: &[u32]) -> Self {
        let mut partition = UnionFind::new(vertex_count);
        let steps = stage_of_many("joining components", ends.len() / 2);
        for &[a, b] in steps.each(ends.as_chunks::<2>().0) {
            partition.unite(a, b);
            if partition.class_count() == 1 {
                break;
            }
        }
        let count = partition.class_count();
        let of_vertex = if count == 1 { vec![0; vertex_count] } else { partition.class_numbers() };
        Self { count, of_vertex }
    }

    /// The number of components.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The number of the component a vertex is in.
    ///
    /// # Panics
    /// If there is no such vertex.
    pub fn of_vertex(&self, vertex: VertexId) -> usize {
        self.of_vertex[vertex.index()] as usize
    }
}

impl PolygonMesh {
    /// The connected components; each isolated vertex is one.
    ///
    /// # Complexity
    /// Nearly linear, by union-find along the edges.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle, an isolated vertex and a loose edge.
    /// let mesh = PolygonMesh::new(6, RaggedArray::from_lists([[0, 1, 2]]), &[[4, 5]])?;
    /// assert_eq!(mesh.components().count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> Components {
        Components::of_graph(self.vertex_count(), self.edge_ends())
    }
}
