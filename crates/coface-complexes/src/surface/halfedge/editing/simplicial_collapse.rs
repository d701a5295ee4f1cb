//! Edge collapses that keep a simplicial complex one.

use super::super::mesh::HalfedgeMesh;
use super::Renumbering;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId, VertexId};

/// Why collapsing an edge would leave no simplicial complex, or another surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CollapseObstacle {
    /// The edge joins a vertex to itself.
    Loop {
        /// The vertex.
        vertex: VertexId,
    },
    /// A face at an end of the edge has other than three sides.
    NoTriangle {
        /// The face.
        face: FaceId,
    },
    /// The edge lies inside, and both of its ends on the boundary.
    EndsOnBoundary,
    /// Both ends have an edge to a vertex, but they are no triangle with it: the two edges would become one edge twice.
    CommonNeighbor {
        /// The vertex.
        vertex: VertexId,
    },
    /// Both ends have a triangle on the same edge: the two triangles would become one triangle twice.
    CommonEdge {
        /// The ends of the common edge.
        ends: [VertexId; 2],
    },
    /// A triangle at the edge has its other two sides on the boundary: they would become an edge in no triangle.
    LastTriangle {
        /// The triangle.
        face: FaceId,
    },
}

/// What [`HalfedgeMesh::collapse_edge_simplicially`] took away and left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SimplicialCollapse {
    vertex: VertexId,
    removed_edges: Vec<EdgeId>,
    removed_faces: Vec<FaceId>,
    renumbering: Renumbering,
}

impl SimplicialCollapse {
    /// The vertex that the two ends of the edge are now.
    pub fn vertex(&self) -> VertexId {
        self.vertex
    }

    /// The edges that went, by the numbers that they had: the collapsed one, and one beside each triangle that went.
    pub fn removed_edges(&self) -> &[EdgeId] {
        &self.removed_edges
    }

    /// The triangles that went, by the numbers that they had.
    pub fn removed_faces(&self) -> &[FaceId] {
        &self.removed_faces
    }

    /// The cells that got other numbers.
    pub fn renumbering(&self) -> &Renumbering {
        &self.renumbering
    }
}

impl CollapseObstacle {
    /// The obstacle in one sentence without a full stop.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::surface::CollapseObstacle;
    /// let obstacle = CollapseObstacle::CommonNeighbor { vertex: VertexId::new(7) };
    /// assert_eq!(obstacle.message(), "both ends have an edge to v7, but are no triangle with it");
    /// ```
    pub fn message(&self) -> String {
        match self {
            Self::Loop { vertex } => format!("it is a loop at {vertex}"),
            Self::NoTriangle { face } => format!("face {face} at one of its ends is no triangle"),
            Self::EndsOnBoundary => "it lies inside, but both of its ends on the boundary".to_owned(),
            Self::CommonNeighbor { vertex } => {
                format!("both ends have an edge to {vertex}, but are no triangle with it")
            }
            Self::CommonEdge { ends: [a, b] } => {
                format!("both ends have a triangle on the edge {{{a}, {b}}}")
            }
            Self::LastTriangle { face } => {
                format!("triangle {face} has its other two sides on the boundary")
            }
        }
    }
}

impl HalfedgeMesh {
    /// Whether the mesh stays a simplicial complex and the same surface when this edge is collapsed and the triangles
    /// beside it vanish; what is in the way if not. The mesh must be a simplicial complex: triangles with three
    /// vertices each, no two edges and no two triangles on the same vertices.
    ///
    /// This is the link condition: the links of the two ends meet in the link of the edge alone, where the boundary
    /// counts as joined to one more vertex.
    ///
    /// # Complexity
    /// $O(d \log d)$ for d edges at the two ends.
    ///
    /// # References
    /// T. K. Dey, H. Edelsbrunner, S. Guha, D. V. Nekhayev, *Topology preserving edge contraction* (1999).
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// No edge of a tetrahedron can be collapsed.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::{CollapseObstacle, HalfedgeMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = RaggedArray::from_lists([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]);
    /// let tetrahedron = HalfedgeMesh::from_polygons(4, &triangles)?;
    /// let Some(CollapseObstacle::CommonEdge { ends }) = tetrahedron.collapse_obstacle(EdgeId::new(0)) else {
    ///     panic!()
    /// };
    /// assert_eq!(ends.map(|end| end.index()), [2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn collapse_obstacle(&self, edge: EdgeId) -> Option<CollapseObstacle> {
        let h = self.edge_halfedge(edge);
        let ends = [self.source(h), self.target(h)];
        if ends[0] == ends[1] {
            return Some(CollapseObstacle::Loop { vertex: ends[0] });
        }
        let no_triangle = ends
            .iter()
            .flat_map(|&end| self.vertex_faces(end))
            .find(|&face| self.face_halfedges(face).take(4).count() != 3);
        if let Some(face) = no_triangle {
            return Some(CollapseObstacle::NoTriangle { face });
        }
        if !self.is_boundary_edge(edge) && ends.iter().all(|&end| self.is_boundary_vertex(end)) {
            return Some(CollapseObstacle::EndsOnBoundary);
        }
        let mut opposite = Vec::with_capacity(2);
        for side in [h, self.twin(h)] {
            if self.is_outer_halfedge(side) {
                continue;
            }
            let (second, third) = (self.next(side), self.next(self.next(side)));
            if self.is_boundary_edge(self.edge(second)) && self.is_boundary_edge(self.edge(third)) {
                return Some(CollapseObstacle::LastTriangle { face: self.face(side) });
            }
            opposite.push(self.target(second));
        }
        let neighbors = ends.map(|end| {
            let mut around: Vec<VertexId> = self.adjacent_vertices(end).collect();
            around.sort_unstable();
            around
        });
        let is_common = |vertex: &&VertexId| neighbors[1].binary_search(vertex).is_ok();
        if let Some(&vertex) = neighbors[0].iter().filter(is_common).find(|vertex| !opposite.contains(vertex))
        {
            return Some(CollapseObstacle::CommonNeighbor { vertex });
        }
        // A common edge joins two common neighbors.
        if let [a, b] = opposite[..] {
            let is_on = |end: VertexId| {
                self.vertex_faces(end).any(|face| {
                    let corners: Vec<VertexId> = self.face_vertices(face).collect();
                    corners.contains(&a) && corners.contains(&b)
                })
            };
            if ends.into_iter().all(is_on) {
                return Some(CollapseObstacle::CommonEdge { ends: [a.min(b), a.max(b)] });
            }
        }
        None
    }

    /// Collapses an edge of a simplicial complex and takes away the triangles beside it, so that a simplicial complex
    /// remains: its ends become one vertex, the one with the smaller number.
    ///
    /// Beside each triangle that goes one of its other two edges goes too: the one after the collapsed edge, unless that
    /// lies on the boundary.
    ///
    /// # Errors
    /// [`ErrorKind::NonManifold`] naming the obstacle, see [`Self::collapse_obstacle`].
    ///
    /// # Complexity
    /// $O(d \log d)$ for d edges at the two ends, and the sizes of the cells around those that get other numbers.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// An octahedron becomes two tetrahedra glued along a triangle, without it.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cap = |pole: u32, i: u32| if pole == 4 { [i, (i + 1) % 4, pole] } else { [(i + 1) % 4, i, pole] };
    /// let triangles = [4, 5].into_iter().flat_map(|pole| (0..4).map(move |i| cap(pole, i)));
    /// let mut mesh = HalfedgeMesh::from_polygons(6, &RaggedArray::from_lists(triangles))?;
    /// mesh.collapse_edge_simplicially(EdgeId::new(0))?;
    /// assert_eq!(mesh.f_vector(), [5, 9, 6]);
    /// # Ok(()) }
    /// ```
    pub fn collapse_edge_simplicially(&mut self, edge: EdgeId) -> Result<SimplicialCollapse, Error> {
        if let Some(obstacle) = self.collapse_obstacle(edge) {
            let h = self.edge_halfedge(edge);
            let [a, b] = [self.source(h), self.target(h)];
            return Err(Error::new(
                ErrorKind::NonManifold,
                format!(
                    "edge {edge} = {{{a}, {b}}} cannot be collapsed so that a simplicial complex remains: {}",
                    obstacle.message()
                ),
            )
            .with_cure("collapse another edge first"));
        }
        let h = self.edge_halfedge(edge);
        let (mut removed_edges, mut removed_faces) = (vec![edge], Vec::with_capacity(2));
        let mut doomed: Vec<HalfedgeId> = Vec::with_capacity(2);
        for side in [h, self.twin(h)].into_iter().filter(|&side| !self.is_outer_halfedge(side)) {
            let second = self.next(side);
            let is_boundary = self.is_boundary_edge(self.edge(second));
            let goes = if is_boundary { self.next(second) } else { second };
            doomed.push(goes);
            removed_edges.push(self.edge(goes));
            removed_faces.push(self.face(side));
        }
        let collapse = self.collapse_edge(edge)?;
        let mut renumbering = collapse.renumbering().clone();
        for goes in doomed {
            let digon_side = renumbering.halfedge(goes.to_u32(), 0);
            let neighbor = self.face[(digon_side ^ 1) as usize];
            self.merge_faces(digon_side, neighbor, &mut renumbering);
        }
        Ok(SimplicialCollapse { vertex: collapse.vertex(), removed_edges, removed_faces, renumbering })
    }
}
