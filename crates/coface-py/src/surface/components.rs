//! What a sliced surface falls into.

use coface::algebra::Sign;
use coface::surface::{GeneralizedMap, Slice};
use coface::{EdgeId, FaceId};
use serde_json::{Value, json};

/// The counts of the components of a sliced surface.
pub(super) struct Parts {
    pub(super) cut_edges: Vec<usize>,
    pub(super) boundary_edges: Vec<usize>,
    pub(super) f_vectors: Vec<[usize; 3]>,
}

impl Parts {
    pub(super) fn of(
        map: &GeneralizedMap,
        slice: &Slice<GeneralizedMap>,
        edges: &[EdgeId],
        count: usize,
        component_of: impl Fn(FaceId) -> usize,
    ) -> Self {
        let open = slice.surface();
        let mut parts = Self {
            cut_edges: vec![0; count],
            boundary_edges: vec![0; count],
            f_vectors: vec![[0; 3]; count],
        };
        let mut seen = vec![false; open.skeleton().vertex_count()];
        for side in open.sides() {
            let component = component_of(open.face(side));
            parts.boundary_edges[component] += usize::from(open.mate(side).is_none());
            let counts = &mut parts.f_vectors[component];
            counts[1] += usize::from(open.first_side(open.edge(side)) == side);
            counts[0] += usize::from(!std::mem::replace(&mut seen[open.source(side).index()], true));
        }
        for face in (0..open.skeleton().face_count()).map(FaceId::new) {
            parts.f_vectors[component_of(face)][2] += 1;
        }
        for &edge in edges {
            // The faces of the slice are those of the surface.
            parts.cut_edges[component_of(map.face(map.first_side(edge)))] += 1;
        }
        parts
    }

    pub(super) fn to_json(&self, i: usize) -> Value {
        let [v, e, f] = self.f_vectors[i];
        json!({
            "cut_edges": self.cut_edges[i],
            "boundary_edges": self.boundary_edges[i],
            "euler_characteristic": v as i64 - e as i64 + f as i64,
            "f_vector": [v, e, f],
        })
    }
}

/// The seams of a component in the order of a walk around its domain: letters from 1, negative where a seam is run backward.
pub(super) fn around(
    map: &GeneralizedMap,
    slice: &Slice<GeneralizedMap>,
    seams: &[Vec<u32>],
    own: &[usize],
) -> Vec<i32> {
    let mut letters: Vec<(u32, i32)> =
        own.iter().zip(1..).filter_map(|(&seam, letter)| Some((*seams[seam].first()?, letter))).collect();
    letters.sort_unstable();
    let mut word = Vec::new();
    for walk in slice.surface().boundary_loops() {
        for (side, sign) in walk {
            let step = map.step(side) ^ u32::from(sign == Sign::Minus);
            let found = |step: u32| letters.binary_search_by_key(&step, |&(first, _)| first);
            if let Ok(at) = found(step) {
                word.push(letters[at].1);
            } else if let Ok(at) = found(step ^ 1) {
                word.push(-letters[at].1);
            }
        }
    }
    word
}
