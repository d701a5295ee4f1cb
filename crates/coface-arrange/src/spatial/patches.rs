//! What the triangles of an arrangement belong to, and which faces are pieces of one.

use super::axis_view::AxisView;
use super::cutting::{CutTriangles, SpatialVertexSource};
use super::merging::MergeRules;
use super::predicates::SpatialPredicates;
use coface_algebra::{FaceId, VertexId};
use coface_algebra::{RaggedArray, Sign};
use coface_geometry::predicates::are_coplanar;

/// Triangles in patches, whose pieces are merged again, and patches in polygons of inputs.
#[derive(Clone, Debug, Default)]
pub(super) struct Patches {
    pub(super) patch_of_triangle: Vec<u32>,
    /// The patches that are not planar, rising, each with a picture in which it is seen from its front and nothing
    /// hides it.
    pub(super) folded: Vec<(u32, AxisView)>,
    /// Those of them, rising, that rounding does not explain.
    pub(super) bent: Vec<u32>,
    /// Those of the bent ones, rising, that are cut: their pieces in different planes stay apart, since a polygon of both would be split
    /// otherwise when it is read again. `None` until it is known.
    pub(super) torn: Option<Vec<u32>>,
    /// The polygons that each patch is made of, packed with 1 for those that run the other way; `None` when patch i is
    /// polygon i.
    pub(super) polygons_of_patch: Option<RaggedArray>,
    pub(super) input_of_polygon: Vec<u32>,
    pub(super) input_count: usize,
    /// The last polygon, of the last input, if it is not one of those given: all faces of an arrangement of some faces alone are
    /// part of it, with their fronts where it has its own.
    pub(super) surface: Option<u32>,
    /// Whether a given point is none of those of polygons, and may be left out like a new one; empty when all are.
    pub(super) is_passing: Vec<bool>,
    /// Whether vertices on straight edges stay, since it is known elsewhere which of them are needed.
    pub(super) keeps_vertices: bool,
    /// Whether new vertices may be corners, as those of polygons that are known exactly.
    pub(super) has_new_corners: bool,
}

impl Patches {
    /// The patches of each face of the cut triangles, rising, packed with 1 for those that run the other way.
    pub(super) fn of_faces(&self, cut: &CutTriangles) -> RaggedArray {
        let packed = |t: u32| 2 * self.patch_of_triangle[(t >> 1) as usize] + (t & 1);
        let all = cut.triangles_of_faces();
        if all.uniform_width() == Some(1) {
            let own = all.items().iter().map(|&t| packed(t)).collect();
            return RaggedArray::uniform(1, own).expect("there are as many as before");
        }
        let mut all = RaggedArray::new();
        let mut own = Vec::new();
        for face in (0..cut.complex().face_count()).map(FaceId::new) {
            own.clear();
            let triangles = cut.triangles_of_face(face).iter();
            own.extend(triangles.map(|&t| packed(t)));
            own.sort_unstable();
            all.push(&own);
        }
        all
    }

    /// The picture of the first of some patches that is not planar, if there is one, as seen from the front of a face
    /// of them.
    pub(super) fn fold(&self, patches: &[u32]) -> Option<AxisView> {
        if self.folded.is_empty() {
            return None;
        }
        patches.iter().find_map(|&packed| {
            let place = self.folded.binary_search_by_key(&(packed >> 1), |folded| folded.0).ok()?;
            let view = self.folded[place].1;
            Some(if packed & 1 == 0 { view } else { view.behind() })
        })
    }

    /// Finds out which bent patches are not there as a whole: each triangle one face without vertices along its sides.
    pub(super) fn tear(&mut self, cut: &CutTriangles, patches_of_face: &RaggedArray) {
        if self.torn.is_some() {
            return;
        }
        let place = |patch: u32| self.bent.binary_search(&patch).ok();
        let mut is_torn = vec![false; self.bent.len()];
        let mut counts = vec![0usize; self.bent.len()];
        if !self.bent.is_empty() {
            for &patch in &self.patch_of_triangle {
                if let Some(place) = place(patch) {
                    counts[place] += 1;
                }
            }
            for (face, patches) in patches_of_face.iter().enumerate() {
                let is_whole = cut.complex().packed_sides().list(face).len() == 3;
                for place in patches.iter().filter_map(|&packed| place(packed >> 1)) {
                    is_torn[place] |= !is_whole || counts[place] == 0;
                    counts[place] = counts[place].saturating_sub(1);
                }
            }
        }
        let torn = self.bent.iter().zip(is_torn).filter(|(_, is_torn)| *is_torn);
        self.torn = Some(torn.map(|(&patch, _)| patch).collect());
    }

    /// Whether one of some patches is bent and cut.
    pub(super) fn are_torn(&self, patches: &[u32]) -> bool {
        let torn = self.torn.as_deref().unwrap_or_default();
        !torn.is_empty() && patches.iter().any(|packed| torn.binary_search(&(packed >> 1)).is_ok())
    }

    /// Whether a vertex is none of the points of polygons.
    pub(super) fn is_new(&self, cut: &CutTriangles, vertex: u32) -> bool {
        match cut.source(VertexId::from_u32(vertex)) {
            SpatialVertexSource::Given(point) => self.is_passing.get(point).is_some_and(|&passing| passing),
            _ => true,
        }
    }

    /// Calls for each polygon of some patches, packed.
    pub(super) fn for_each_polygon(&self, patches: &[u32], mut call: impl FnMut(u32)) {
        for &patch in patches {
            match &self.polygons_of_patch {
                None => call(patch),
                Some(lists) => {
                    lists.list((patch >> 1) as usize).iter().for_each(|&polygon| call(polygon ^ (patch & 1)));
                }
            }
        }
    }

    /// The inputs of some patches, sorted, packed with 1 for those that run the other way, turned if the sign is minus.
    fn inputs(&self, patches: &[u32], sign: Sign) -> Vec<u32> {
        let turned = u32::from(sign == Sign::Minus);
        let mut inputs = Vec::new();
        self.for_each_polygon(patches, |polygon| {
            inputs.push(2 * self.input_of_polygon[(polygon >> 1) as usize] + ((polygon & 1) ^ turned));
        });
        inputs.sort_unstable();
        inputs
    }

    /// Whether some patches and others, turned if the sign is minus, are of the same inputs.
    pub(super) fn have_same_inputs(&self, some: &[u32], others: &[u32], sign: Sign) -> bool {
        if let (None, &[x], &[y]) = (&self.polygons_of_patch, some, others) {
            let input = |patch: u32| self.input_of_polygon[(patch >> 1) as usize];
            return input(x) == input(y) && (x ^ y) & 1 == u32::from(sign == Sign::Minus);
        }
        self.inputs(some, Sign::Plus) == self.inputs(others, sign)
    }
}

/// Pieces of the same patches are merged and, if so asked, faces of the same inputs in one plane.
pub(super) struct SameOrigin<'a, P> {
    cut: &'a CutTriangles,
    predicates: &'a P,
    patches: &'a Patches,
    patches_of_face: &'a RaggedArray,
    merge_coplanar: bool,
    /// How many edges are left at each vertex when only pieces of the same patches are merged; for coplanar merging
    /// beside folds.
    degrees: Vec<u32>,
}

impl<'a, P: SpatialPredicates> SameOrigin<'a, P> {
    pub(super) fn new(
        cut: &'a CutTriangles,
        predicates: &'a P,
        patches: &'a Patches,
        patches_of_face: &'a RaggedArray,
        around: &RaggedArray,
        merge_coplanar: bool,
    ) -> Self {
        let mut rules =
            Self { cut, predicates, patches, patches_of_face, merge_coplanar, degrees: Vec::new() };
        if merge_coplanar && !patches.folded.is_empty() {
            let mut degrees = vec![0; cut.complex().vertex_count()];
            for (ends, sides) in cut.complex().edges().iter().zip(around.iter()) {
                let is_inside = match *sides {
                    [s, t] if (s ^ t) & 1 == 0 => rules.is_one([s >> 1, t >> 1], Sign::Minus),
                    [s, t] => rules.is_one([s >> 1, t >> 1], Sign::Plus),
                    _ => false,
                };
                if !is_inside {
                    ends.iter().for_each(|&vertex| degrees[vertex as usize] += 1);
                }
            }
            rules.degrees = degrees;
        }
        rules
    }

    /// Whether two faces are pieces of the same patches, the second with a sign, and of the same plane of those that are torn.
    fn is_one(&self, [f, g]: [u32; 2], sign: Sign) -> bool {
        let turned = u32::from(sign == Sign::Minus);
        let [own, other] = [f, g].map(|face| self.patches_of_face.list(face as usize));
        let plane = |face: u32| self.cut.plane(FaceId::from_u32(face));
        own.len() == other.len()
            && own.iter().zip(other).all(|(&x, &y)| x == y ^ turned)
            && (!self.patches.are_torn(own) || are_coplanar(plane(f), plane(g)))
    }

    fn is_straight(&self, vertex: u32, [a, b]: [u32; 2]) -> bool {
        (0..3).all(|axis| self.predicates.normal_sign(axis, [a, vertex, b]).is_eq())
    }

    fn is_new(&self, vertex: u32) -> bool {
        self.patches.is_new(self.cut, vertex)
    }
}

impl<P: SpatialPredicates> MergeRules for SameOrigin<'_, P> {
    fn may_merge(&self, faces: [u32; 2], sign: Sign) -> bool {
        if self.is_one(faces, sign) {
            return true;
        }
        if !self.merge_coplanar {
            return false;
        }
        let [own, other] = faces.map(|face| self.patches_of_face.list(face as usize));
        let [f, g] = faces.map(|face| self.cut.plane(FaceId::from_u32(face)));
        self.patches.have_same_inputs(own, other, sign)
            && self.patches.fold(own).is_none()
            && self.patches.fold(other).is_none()
            && are_coplanar(f, g)
    }

    /// A new vertex left with two edges lies on a straight edge, or on one that is bent where a polygon is folded: if
    /// it were a corner of what is left, it would be a corner of a polygon. Where coplanar faces were merged, only
    /// straight edges are certain.
    fn may_dissolve(&self, vertex: u32, neighbors: [u32; 2]) -> bool {
        if self.patches.keeps_vertices {
            return false;
        }
        if !self.merge_coplanar {
            return self.is_new(vertex)
                && (!self.patches.has_new_corners || self.is_straight(vertex, neighbors));
        }
        let is_bend = || self.degrees.get(vertex as usize) == Some(&2) && self.is_new(vertex);
        self.is_straight(vertex, neighbors) || is_bend()
    }
}
