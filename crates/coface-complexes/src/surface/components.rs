//! Connected components.

use super::PolygonMesh;
use crate::components::Components;

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
