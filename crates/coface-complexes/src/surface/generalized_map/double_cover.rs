//! The orientation double cover.

use super::GeneralizedMap;
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{EdgeId, FaceId, HalfedgeId, VertexId};
use coface_algebra::{RaggedArray, Sign};

/// The orientation double cover of a surface: each face twice, once for each of its two sides, glued so that all agree.
///
/// Above an orientable component lie two copies of it with opposite orientations, above another one a connected surface.
/// Cell i of the cover lies above cell i / 2; the deck transformation exchanges 2i and 2i + 1. Face 2f runs as face f
/// does, face 2f + 1 the other way around.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OrientationDoubleCover {
    map: GeneralizedMap,
}

impl OrientationDoubleCover {
    /// The covering surface; all its faces agree.
    pub fn map(&self) -> &GeneralizedMap {
        &self.map
    }

    /// The covering surface by itself.
    pub fn into_map(self) -> GeneralizedMap {
        self.map
    }

    /// The vertex below a vertex.
    pub fn vertex_below(&self, vertex: VertexId) -> VertexId {
        VertexId::from_u32(vertex.to_u32() >> 1)
    }

    /// The edge below an edge; they run in the same direction.
    pub fn edge_below(&self, edge: EdgeId) -> EdgeId {
        EdgeId::from_u32(edge.to_u32() >> 1)
    }

    /// The face below a face, and whether they run around in the same direction.
    pub fn face_below(&self, face: FaceId) -> (FaceId, Sign) {
        (FaceId::from_u32(face.to_u32() >> 1), Sign::power_of_minus_one((face.to_u32() & 1) as usize))
    }
}

impl GeneralizedMap {
    /// The orientation double cover.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # References
    /// H. Seifert, W. Threlfall, *Lehrbuch der Topologie* (1934), section 55.
    ///
    /// # Examples
    /// The cover of the projective plane is the sphere.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// use coface_complexes::surface::GeneralizedMap;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let digon = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0, 0]]))?;
    /// let cover = GeneralizedMap::new(digon)?.orientation_double_cover();
    /// assert_eq!(cover.map().f_vector(), [2, 2, 2]);
    /// assert_eq!(cover.map().surfaces()[0].to_string(), "sphere");
    /// # Ok(()) }
    /// ```
    pub fn orientation_double_cover(&self) -> OrientationDoubleCover {
        let colors = self.flag_colors();
        let (vertex_count, edge_count) = (self.vertex_count(), self.edge_count());
        // An edge has two lifts. Lift 0 is below the face of its first side as listed, that is in sheet 0.
        let lift_of_vertex = |flag: u32, sheet: u32| {
            2 * self.flag_vertex(flag).to_u32() + (u32::from(colors[flag as usize]) ^ (flag & 1) ^ sheet)
        };
        let is_first = |side: HalfedgeId| self.first_side(self.edge(side)) == side;
        let lift_of_edge = |side: HalfedgeId, sheet: u32| {
            let turned = u32::from(!is_first(side) && !self.agrees(side));
            2 * self.edge(side).to_u32() + (sheet ^ turned)
        };
        let mut ends = vec![0; 4 * edge_count];
        for edge in (0..edge_count).map(EdgeId::new) {
            let side = self.first_side(edge);
            let along = self.step(side) & 1;
            for sheet in [0, 1] {
                let edge = lift_of_edge(side, sheet);
                for end in [0, 1] {
                    let flag = side.to_u32() << 1 | end;
                    ends[(2 * edge + (end ^ along)) as usize] = lift_of_vertex(flag, sheet);
                }
            }
        }
        let mut faces = RaggedArray::new();
        let mut rim = Vec::new();
        for face in 0..self.skeleton.face_count() {
            let sides = self.sides_of(FaceId::new(face));
            let steps = |sheet: u32| {
                move |side: HalfedgeId| 2 * lift_of_edge(side, sheet) + ((self.step(side) & 1) ^ sheet)
            };
            rim.clear();
            rim.extend(sides.clone().map(steps(0)));
            faces.push(&rim);
            rim.clear();
            rim.extend(sides.rev().map(steps(1)));
            faces.push(&rim);
        }
        let skeleton = TwoSkeleton::new(2 * vertex_count, ends, faces)
            .expect("lifts of closed paths in a sheet are closed");
        let map = Self::new(skeleton).expect("a cover of a surface is a surface");
        OrientationDoubleCover { map }
    }

    /// A color for each flag so that the involutions 1 and 2 change it: one way and the other around each vertex.
    fn flag_colors(&self) -> Vec<bool> {
        let mut colors = vec![false; 2 * self.side_count()];
        let mut seen = vec![false; 2 * self.side_count()];
        for flag in 0..2 * self.side_count() as u32 {
            if seen[flag as usize] {
                continue;
            }
            for (i, member) in self.fan(flag).into_iter().enumerate() {
                seen[member as usize] = true;
                colors[member as usize] = i % 2 == 1;
            }
        }
        colors
    }
}
