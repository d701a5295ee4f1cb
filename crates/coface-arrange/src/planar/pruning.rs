//! Arrangements without dangling edges and bridges.

use super::PlanarArrangement;
use super::crossings::Soup;
use super::edges::Edges;
use super::faces::NONE;
use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, Error};

impl PlanarArrangement {
    /// The same faces without the edges that have one face on both sides, and without the vertices that no edge is left
    /// at.
    ///
    /// Faces, their numbers and their areas stay. Where a bridge led to a hole, the hole becomes a walk of its own.
    ///
    /// # Errors
    /// None for an arrangement that could be made; as [`Self::new`] otherwise.
    ///
    /// # Complexity
    /// That of finding the faces again.
    ///
    /// # Examples
    /// A triangle with an edge that dangles into it, and a segment beside it.
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Positions::from_flat(2, vec![0., 0., 4., 0., 0., 4., 1., 1., 7., 7., 8., 8.])?;
    /// let arrangement = PlanarArrangement::new(&points, &[[0, 1], [1, 2], [2, 0], [0, 3], [4, 5]])?;
    /// assert_eq!(arrangement.f_vector(), [6, 5, 1]);
    /// assert_eq!(arrangement.pruned()?.f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn pruned(&self) -> Result<Self, Error> {
        let mut vertex_number = vec![NONE; self.vertex_count()];
        let mut edge_number = vec![NONE; self.edge_count()];
        for (edge, _) in self.separating_edges() {
            edge_number[edge as usize] = 0;
            self.ends[edge as usize].iter().for_each(|&end| vertex_number[end as usize] = 0);
        }
        for numbers in [&mut vertex_number, &mut edge_number] {
            let kept = numbers.iter_mut().filter(|number| **number != NONE);
            kept.zip(0..).for_each(|(number, next)| *number = next);
        }
        let (mut sources, mut vertices) = (Vec::new(), Vec::new());
        for (vertex, _) in vertex_number.iter().enumerate().filter(|(_, number)| **number != NONE) {
            sources.push(self.sources[vertex]);
            vertices.push(self.vertices[vertex]);
        }
        let renumbered = |&vertex: &u32| vertex_number.get(vertex as usize).copied().unwrap_or(NONE);
        let kept = |edge: usize| !self.is_bridge(EdgeId::new(edge));
        let edges = (0..self.edge_count()).filter(|&edge| kept(edge));
        let mut of_segment = self.edges_of_segment.clone();
        for edge in of_segment.items_mut() {
            *edge = edge_number.get(*edge as usize).copied().unwrap_or(NONE);
        }
        let edges = Edges {
            ends: edges.clone().map(|edge| self.ends[edge].map(|end| renumbered(&end))).collect(),
            segments: RaggedArray::from_lists(edges.map(|edge| self.segments_of_edge.list(edge))),
            of_segment,
        };
        let mut soup = Soup::with_loose_points(self.points.clone(), self.segments.clone());
        soup.exact.clone_from(&self.exact);
        let tree = soup.tree();
        let vertex_of_point = self.vertex_of_point.iter().map(renumbered).collect();
        Self::assemble(soup, &tree, self.segments.len(), sources, vertices, vertex_of_point, edges)
    }
}
