//! A vertex on an edge, and its removal.

use super::super::mesh::HalfedgeMesh;
use super::Renumbering;
use coface_algebra::{EdgeId, Error, VertexId};

/// What [`HalfedgeMesh::split_edge`] made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgeSplit {
    vertex: VertexId,
    edge: EdgeId,
}

impl EdgeSplit {
    /// The vertex on the edge.
    pub fn vertex(&self) -> VertexId {
        self.vertex
    }

    /// The added edge: from the added vertex to the target of the edge that was split. That one ends at the added
    /// vertex now.
    pub fn edge(&self) -> EdgeId {
        self.edge
    }
}

/// What [`HalfedgeMesh::remove_vertex`] left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VertexRemoval {
    edge: EdgeId,
    renumbering: Renumbering,
}

impl VertexRemoval {
    /// The edge that the two edges at the vertex are now.
    pub fn edge(&self) -> EdgeId {
        self.edge
    }

    /// The cells that got other numbers.
    pub fn renumbering(&self) -> &Renumbering {
        &self.renumbering
    }
}

impl HalfedgeMesh {
    /// Puts a vertex on an edge. The edge becomes its first half, from its source to the vertex; the second half, in the
    /// same direction, is added. Loops, pendant edges and boundary edges are split like any other.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] from 2^31 halfedges on.
    ///
    /// # Complexity
    /// The size of a face or a vertex at the edge.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// A loop between two monogons becomes a circle of two edges between two digons.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut mesh = HalfedgeMesh::from_next(vec![0, 1])?;
    /// let split = mesh.split_edge(EdgeId::new(0))?;
    /// assert_eq!(mesh.f_vector(), [2, 2, 2]);
    /// assert_eq!(mesh.target(mesh.edge_halfedge(EdgeId::new(0))), split.vertex());
    /// mesh.remove_vertex(split.vertex())?;
    /// assert_eq!(mesh, HalfedgeMesh::from_next(vec![0, 1])?);
    /// # Ok(()) }
    /// ```
    pub fn split_edge(&mut self, edge: EdgeId) -> Result<EdgeSplit, Error> {
        self.check_room(1, 1)?;
        let h = self.edge_halfedge(edge).to_u32();
        let t = h ^ 1;
        let (after, before) = (self.next[h as usize], self.before(t));
        let (vertex, target) = (self.vertex_halfedge.len() as u32, self.source[t as usize]);
        let second = self.push_edge(vertex, target);
        let second_twin = second ^ 1;
        self.next[h as usize] = second;
        if after == t {
            // A pendant end.
            self.next[second as usize] = second_twin;
        } else {
            self.next[second as usize] = after;
            self.next[before as usize] = second_twin;
        }
        self.next[second_twin as usize] = t;
        self.face[second as usize] = self.face[h as usize];
        self.face[second_twin as usize] = self.face[t as usize];
        self.source[t as usize] = vertex;
        if self.vertex_halfedge[target as usize] == t {
            self.vertex_halfedge[target as usize] = second_twin;
        }
        let is_outer = self.face[t as usize] as usize >= self.face_count;
        self.vertex_halfedge.push(if is_outer { t } else { second });
        Ok(EdgeSplit { vertex: VertexId::from_u32(vertex), edge: EdgeId::from_u32(second >> 1) })
    }

    /// Removes a vertex with exactly two edges, which become one. The one with the smaller number stays and keeps its
    /// direction. The inverse of [`Self::split_edge`].
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] when other than two edges end at the vertex, or one loop does.
    ///
    /// # Complexity
    /// The sizes of the cells around the vertex and around the cells that get other numbers.
    ///
    /// # Panics
    /// If there is no such vertex.
    pub fn remove_vertex(&mut self, vertex: VertexId) -> Result<VertexRemoval, Error> {
        let leaving: Vec<u32> = self.halfedges_leaving(vertex).map(|h| h.to_u32()).take(3).collect();
        let &[x, y] = &leaving[..] else {
            let found = match self.degree(vertex) {
                1 => "1 edge ends".to_owned(),
                count => format!("{count} edges end"),
            };
            return Err(Error::invalid(format!(
                "{found} at vertex {vertex}; only a vertex with two is removed"
            ))
            .with_cure("collapse an edge at it instead"));
        };
        if x ^ 1 == y {
            return Err(Error::invalid(format!(
                "edge {} is a loop at vertex {vertex} and needs it",
                EdgeId::from_u32(x >> 1)
            ))
            .with_cure("remove the edge instead, or split it first"));
        }
        let (kept, gone) = if x >> 1 < y >> 1 { (x, y) } else { (y, x) };
        let (kept_twin, gone_twin) = (kept ^ 1, gone ^ 1);
        let end = self.source[gone_twin as usize];
        if self.next[gone as usize] == gone_twin {
            self.next[kept_twin as usize] = kept;
        } else {
            let before = self.before(gone_twin);
            self.next[kept_twin as usize] = self.next[gone as usize];
            self.next[before as usize] = kept;
        }
        self.source[kept as usize] = end;
        if self.vertex_halfedge[end as usize] == gone_twin {
            self.vertex_halfedge[end as usize] = kept;
        }
        for (old, new) in [(gone, kept_twin), (gone_twin, kept)] {
            let first = &mut self.face_halfedge[self.face[old as usize] as usize];
            if *first == old {
                *first = new;
            }
        }
        let mut renumbering = Renumbering::default();
        self.swap_remove_edge(gone >> 1, &mut renumbering);
        self.swap_remove_vertex(vertex.to_u32(), &mut renumbering);
        Ok(VertexRemoval { edge: EdgeId::from_u32(kept >> 1), renumbering })
    }
}
