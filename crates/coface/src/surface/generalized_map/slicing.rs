//! Slicing a surface along edges.

use super::GeneralizedMap;
use crate::chains::TwoSkeleton;
use crate::{EdgeId, Error, ErrorKind, HalfedgeId, VertexId};

/// A surface that was sliced along edges, with the cells it came from.
///
/// Faces and sides keep their numbers and directions. An edge that was sliced is twice there: on its first side it keeps
/// its number, on its second it has one after all others. Of a vertex that falls apart the fan with the smallest flag
/// keeps the number; the other fans get numbers after all others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SlicedMap {
    map: GeneralizedMap,
    vertex_sources: Vec<VertexId>,
    edge_sources: Vec<EdgeId>,
}

impl SlicedMap {
    /// The sliced surface.
    pub fn map(&self) -> &GeneralizedMap {
        &self.map
    }

    /// For each vertex of the sliced surface the vertex it was.
    pub fn vertex_sources(&self) -> &[VertexId] {
        &self.vertex_sources
    }

    /// For each edge of the sliced surface the edge it was; both run in the same direction.
    pub fn edge_sources(&self) -> &[EdgeId] {
        &self.edge_sources
    }
}

impl GeneralizedMap {
    /// The surface sliced along these edges: the faces on either side are not glued there any more. Edges of the boundary, and
    /// edges named twice, change nothing further.
    ///
    /// Euler characteristic and components may change; the edges need not be a path. An edge in the interior with no
    /// other sliced edge and no boundary at an end opens there no further than to that vertex.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming an edge that is not there; [`ErrorKind::TooLarge`] when edges or vertices get
    /// too many for 32 bits.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// A torus made of one square, sliced along its first edge, is an annulus.
    /// ```
    /// use coface::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface::EdgeId;
    /// # fn main() -> Result<(), coface::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton())?;
    /// let sliced = torus.slice(&[EdgeId::new(0)])?;
    /// assert_eq!(sliced.map().surfaces()[0].to_string(), "annulus");
    /// assert_eq!(sliced.map().f_vector(), [2, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn slice(&self, edges: &[EdgeId]) -> Result<SlicedMap, Error> {
        let [vertex_count, edge_count, _] = self.f_vector();
        let mut is_cut = vec![false; edge_count];
        for &edge in edges {
            let Some(cut) = is_cut.get_mut(edge.index()) else {
                return Err(Error::new(
                    ErrorKind::NotInComplex,
                    format!("there is no edge {edge} to slice along; there are {edge_count}"),
                ));
            };
            *cut = true;
        }
        let mut edge_sources: Vec<EdgeId> = (0..edge_count).map(EdgeId::new).collect();
        let mut faces = self.skeleton.faces().clone();
        for side in self.sides() {
            let edge = self.edge(side);
            if is_cut[edge.index()] && self.mate(side).is_some_and(|mate| mate < side) {
                faces.items_mut()[side.index()] = 2 * edge_sources.len() as u32 + (self.step(side) & 1);
                edge_sources.push(edge);
            }
        }
        if edge_sources.len() >= 1 << 31 {
            return Err(Error::new(ErrorKind::TooLarge, "the sliced surface has 2^31 edges or more"));
        }
        let mut vertex_sources: Vec<VertexId> = (0..vertex_count).map(VertexId::new).collect();
        let mut ends = self.skeleton.edge_ends().to_vec();
        ends.resize(2 * edge_sources.len(), 0);
        let mut has_fan = vec![false; vertex_count];
        let mut seen = vec![false; 2 * self.side_count()];
        for flag in 0..2 * self.side_count() as u32 {
            if seen[flag as usize] {
                continue;
            }
            let old = self.flag_vertex(flag);
            let vertex = if std::mem::replace(&mut has_fan[old.index()], true) {
                vertex_sources.push(old);
                vertex_sources.len() - 1
            } else {
                old.index()
            };
            self.walk_fan(
                flag,
                |side| is_cut[self.edge(side).index()],
                |flag| {
                    seen[flag as usize] = true;
                    let step = faces.items()[(flag >> 1) as usize];
                    ends[(step ^ (flag & 1)) as usize] = vertex as u32;
                },
            );
        }
        let skeleton = TwoSkeleton::new(vertex_sources.len(), ends, faces)?;
        Ok(SlicedMap { map: Self::new(skeleton)?, vertex_sources, edge_sources })
    }

    /// Visits the flags of the fan that a flag is in, each once: first one way around its vertex, then, if the fan is not
    /// closed, the other way. Fans end at the boundary and at sides where `is_wall` holds.
    pub(super) fn walk_fan(
        &self,
        flag: u32,
        is_wall: impl Fn(HalfedgeId) -> bool,
        mut visit: impl FnMut(u32),
    ) {
        visit(flag);
        for first in [1, 2] {
            let (mut at, mut index) = (flag, first);
            loop {
                let after = self.alpha(index, at);
                if after == at || (index == 2 && is_wall(HalfedgeId::from_u32(at >> 1))) {
                    break;
                }
                if after == flag {
                    return;
                }
                visit(after);
                (at, index) = (after, 3 - index);
            }
        }
    }
}
