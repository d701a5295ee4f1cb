//! A vertex drawn out to an edge, and the edge collapsed to a vertex.

use super::super::mesh::HalfedgeMesh;
use super::Renumbering;
use coface_algebra::{EdgeId, Error, ErrorKind, HalfedgeId, VertexId};

/// What [`HalfedgeMesh::split_vertex`] made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexSplit {
    vertex: VertexId,
    edge: EdgeId,
}

impl VertexSplit {
    /// The added vertex.
    pub fn vertex(&self) -> VertexId {
        self.vertex
    }

    /// The added edge, from the vertex that was split to the added one.
    pub fn edge(&self) -> EdgeId {
        self.edge
    }
}

/// What [`HalfedgeMesh::collapse_edge`] and [`HalfedgeMesh::remove_pendant_edge`] left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeCollapse {
    vertex: VertexId,
    corners: [HalfedgeId; 2],
    renumbering: Renumbering,
}

impl EdgeCollapse {
    /// The vertex that the two ends of the edge are now.
    pub fn vertex(&self) -> VertexId {
        self.vertex
    }

    /// The corners at which [`HalfedgeMesh::split_vertex`] draws the edge out again.
    pub fn corners(&self) -> [HalfedgeId; 2] {
        self.corners
    }

    /// The cells that got other numbers.
    pub fn renumbering(&self) -> &Renumbering {
        &self.renumbering
    }
}

impl HalfedgeMesh {
    /// Draws a vertex out to an edge between two of its corners, given by their halfedges. The added edge goes from the
    /// vertex to an added one, which takes over the halfedges that leave the vertex from `from` on clockwise up to
    /// before `to`. The added edge has the face of `from` on its left and that of `to` on its right.
    ///
    /// At one corner, `from == to`, the added vertex takes over nothing: the added edge is pendant.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] when the halfedges leave different vertices, and for a pendant edge in an outer face;
    /// [`ErrorKind::TooLarge`] from 2^31 halfedges on.
    ///
    /// # Complexity
    /// The number of halfedges that leave the vertex, and the size of a face there.
    ///
    /// # Panics
    /// If there is no such halfedge.
    ///
    /// # Examples
    /// The vertex of the square torus becomes an edge, and the square a hexagon.
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// let split = torus.split_vertex(HalfedgeId::new(0), HalfedgeId::new(1))?;
    /// assert_eq!(torus.f_vector(), [2, 3, 1]);
    /// assert_eq!(torus.degree(split.vertex()), 3);
    /// torus.collapse_edge(split.edge())?;
    /// assert_eq!(torus, HalfedgeMesh::from_next(vec![2, 3, 1, 0])?);
    /// # Ok(()) }
    /// ```
    pub fn split_vertex(&mut self, from: HalfedgeId, to: HalfedgeId) -> Result<VertexSplit, Error> {
        let (vertex, other) = (self.source(from), self.source(to));
        if vertex != other {
            return Err(Error::invalid(format!(
                "{from} leaves vertex {vertex} and {to} vertex {other}; a vertex is split between two of its own corners"
            )));
        }
        let (x, y) = (from.to_u32(), to.to_u32());
        if x == y {
            self.check_inner(self.face[x as usize], "a pendant edge cannot lie in")?;
        }
        self.check_room(1, 1)?;
        let (before_x, before_y) = (self.before(x), self.before(y));
        let added = self.vertex_halfedge.len() as u32;
        let a = self.push_edge(vertex.to_u32(), added);
        let b = a ^ 1;
        self.face[a as usize] = self.face[x as usize];
        self.face[b as usize] = self.face[y as usize];
        if x == y {
            self.next[before_x as usize] = a;
            self.next[a as usize] = b;
            self.next[b as usize] = x;
            self.vertex_halfedge.push(b);
        } else {
            self.move_sources(x, y, added);
            self.next[before_x as usize] = a;
            self.next[a as usize] = x;
            self.next[before_y as usize] = b;
            self.next[b as usize] = y;
            let is_outer = |h: u32| self.face[h as usize] as usize >= self.face_count;
            let first = self.vertex_halfedge[vertex.index()];
            let [first, added_first] = if is_outer(a) {
                [a, x]
            } else if is_outer(b) {
                [y, b]
            } else if self.source[first as usize] == added {
                [a, first]
            } else {
                [first, b]
            };
            self.vertex_halfedge[vertex.index()] = first;
            self.vertex_halfedge.push(added_first);
        }
        Ok(VertexSplit { vertex: VertexId::from_u32(added), edge: EdgeId::from_u32(a >> 1) })
    }

    /// Collapses an edge to a vertex: its ends become one, the one with the smaller number. Its faces lose a side:
    /// triangles become digons, digons monogons. The inverse of [`Self::split_vertex`].
    ///
    /// [`Self::collapse_edge_simplicially`] is for meshes that are simplicial complexes and are to stay so.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a loop and for the only edge of a component; [`ErrorKind::NonManifold`] for an edge
    /// inside the surface between two vertices on the boundary, which would pinch the surface.
    ///
    /// # Complexity
    /// The sizes of the cells at the edge and around the cells that get other numbers.
    ///
    /// # Panics
    /// If there is no such edge.
    pub fn collapse_edge(&mut self, edge: EdgeId) -> Result<EdgeCollapse, Error> {
        let h = self.edge_halfedge(edge).to_u32();
        let t = h ^ 1;
        let (u, v) = (self.source[h as usize], self.source[t as usize]);
        let (after_h, after_t) = (self.next[h as usize], self.next[t as usize]);
        if u == v {
            return Err(Error::invalid(format!(
                "edge {edge} is a loop at vertex {}; collapsing it would change the surface",
                VertexId::from_u32(u)
            ))
            .with_cure("split the loop, or remove it"));
        }
        if after_h == t && after_t == h {
            return Err(Error::invalid(format!(
                "edge {edge} is the only one of its component, a sphere, and a face needs an edge"
            )));
        }
        let is_outer = |h: u32| self.face[h as usize] as usize >= self.face_count;
        let first_of = |vertex: u32| self.vertex_halfedge[vertex as usize];
        // The halfedge that follows on each side, past a pendant end.
        let (left, right) =
            (if after_h == t { after_t } else { after_h }, if after_t == h { after_h } else { after_t });
        let first = if is_outer(h) {
            left
        } else if is_outer(t) {
            right
        } else if is_outer(first_of(u)) && is_outer(first_of(v)) {
            let [u, v] = [u, v].map(VertexId::from_u32);
            return Err(Error::new(
                ErrorKind::NonManifold,
                format!(
                    "edge {edge} joins the vertices {u} and {v} of the boundary inside the surface; collapsing it would make two fans of faces meet in one vertex"
                ),
            )
            .with_cure("cut the surface along the edge first"));
        } else if is_outer(first_of(u)) {
            first_of(u)
        } else if is_outer(first_of(v)) {
            first_of(v)
        } else {
            let kept_first = first_of(u.min(v));
            if kept_first >> 1 == edge.to_u32() { left } else { kept_first }
        };
        let (kept, gone) = (u.min(v), u.max(v));
        let gone_first = first_of(gone);
        self.move_sources(gone_first, gone_first, kept);
        let (before_h, before_t) = (self.before(h), self.before(t));
        if after_h == t {
            self.next[before_h as usize] = after_t;
        } else if after_t == h {
            self.next[before_t as usize] = after_h;
        } else {
            self.next[before_h as usize] = after_h;
            self.next[before_t as usize] = after_t;
        }
        self.vertex_halfedge[kept as usize] = first;
        for (old, new) in [(h, left), (t, right)] {
            let first = &mut self.face_halfedge[self.face[old as usize] as usize];
            if *first == old {
                *first = new;
            }
        }
        let mut renumbering = Renumbering::default();
        self.swap_remove_edge(edge.to_u32(), &mut renumbering);
        self.swap_remove_vertex(gone, &mut renumbering);
        // What left the end that is gone is from the first of these corners to the second.
        let corners = match (after_h == t, after_t == h) {
            (true, _) => [right, right],
            (_, true) => [left, left],
            _ if gone == v => [left, right],
            _ => [right, left],
        };
        let corners = corners.map(|corner| HalfedgeId::from_u32(renumbering.halfedge(corner, 0)));
        Ok(EdgeCollapse { vertex: VertexId::from_u32(kept), corners, renumbering })
    }

    /// Removes an edge together with an end where no other edge is. Afterwards the other end is what is left of it: this is
    /// [`Self::collapse_edge`] but for the number of the vertex that stays, which is that of the other end.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] when other edges end at both ends, or none at either.
    ///
    /// # Complexity
    /// The sizes of the cells at the edge and around the cells that get other numbers.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// let corner = HalfedgeId::new(2);
    /// let whisker = torus.split_vertex(corner, corner)?;
    /// assert_eq!(torus.f_vector(), [2, 3, 1]);
    /// assert_eq!(torus.remove_pendant_edge(whisker.edge())?.corners(), [corner, corner]);
    /// # Ok(()) }
    /// ```
    pub fn remove_pendant_edge(&mut self, edge: EdgeId) -> Result<EdgeCollapse, Error> {
        let mut h = self.edge_halfedge(edge).to_u32();
        let is_end = |h: u32| self.next[h as usize] == h ^ 1;
        if is_end(h) && is_end(h ^ 1) {
            return Err(Error::invalid(format!(
                "edge {edge} is the only one of its component, a sphere, and a face needs an edge"
            )));
        }
        if is_end(h ^ 1) {
            h ^= 1;
        }
        if !is_end(h) {
            return Err(Error::invalid(format!(
                "edge {edge} is not pendant: other edges end at both of its ends"
            ))
            .with_cure("remove it as an edge between two faces, or collapse it"));
        }
        let t = h ^ 1;
        let (kept, gone) = (self.source[h as usize], self.source[t as usize]);
        let corner = self.next[t as usize];
        let before = self.before(h);
        self.next[before as usize] = corner;
        let first = &mut self.vertex_halfedge[kept as usize];
        if *first == h {
            *first = corner;
        }
        let first = &mut self.face_halfedge[self.face[h as usize] as usize];
        if *first >> 1 == h >> 1 {
            *first = corner;
        }
        let mut renumbering = Renumbering::default();
        self.swap_remove_edge(edge.to_u32(), &mut renumbering);
        self.swap_remove_vertex(gone, &mut renumbering);
        let corner = HalfedgeId::from_u32(renumbering.halfedge(corner, 0));
        // The vertex that stays may have been the last one.
        let vertex = if kept as usize == self.vertex_halfedge.len() { gone } else { kept };
        Ok(EdgeCollapse { vertex: VertexId::from_u32(vertex), corners: [corner; 2], renumbering })
    }
}
