//! What lies inside faces and is not in their boundaries: slits and points.

use super::SpatialArrangement;
use super::cutting::CutTriangles;
use super::merging::Merged;
use coface_algebra::CellId;

impl SpatialArrangement {
    /// The edges that some faces, given rising, have on both sides, as where a ridge touches a face: face and edge, rising.
    #[doc(hidden)]
    pub fn slits(&self, faces: impl Iterator<Item = CellId>) -> Vec<(u32, u32)> {
        let mut slits = Vec::new();
        let mut edges: Vec<u32> = Vec::new();
        for face in faces {
            let sides = self.complex().packed_sides().list(face.index());
            // A triangle with a slit has five sides.
            if sides.len() < 5 {
                continue;
            }
            edges.clear();
            edges.extend(sides.iter().map(|side| side >> 1));
            edges.sort_unstable();
            let twice = edges.windows(2).filter(|pair| pair[0] == pair[1]);
            slits.extend(twice.map(|pair| (face.to_u32(), pair[0])));
        }
        slits
    }

    /// The vertices inside faces that no edge of them ends at, as where the apex of a pyramid touches a face: face and
    /// vertex, rising.
    #[doc(hidden)]
    pub fn points_in_faces(&self) -> Vec<(u32, u32)> {
        points_in_faces(&self.cut, self.merged.as_ref())
    }
}

/// The vertices inside faces that no edge of them ends at.
fn points_in_faces(cut: &CutTriangles, merged: Option<&Merged>) -> Vec<(u32, u32)> {
    let fine = cut.points_in_faces();
    let Some(merged) = merged else { return fine.iter().map(|&[face, vertex]| (face, vertex)).collect() };
    let complex = cut.complex();
    let mut points = Vec::new();
    let mut own = Vec::new();
    for (face, parts) in (0..).zip(merged.faces.iter()) {
        own.clear();
        for &part in parts {
            let start = fine.partition_point(|point| point[0] < part >> 1);
            own.extend(fine[start..].iter().take_while(|point| point[0] == part >> 1).map(|point| point[1]));
            if parts.len() > 1 {
                let sides = complex.packed_sides().list((part >> 1) as usize).iter();
                let inside = sides.filter(|&&side| merged.is_inside_face[(side >> 1) as usize]);
                own.extend(inside.flat_map(|&side| complex.side_ends(side)));
            }
        }
        if own.is_empty() {
            continue;
        }
        own.sort_unstable();
        own.dedup();
        let mut on_sides: Vec<u32> = merged
            .complex
            .packed_sides()
            .list(face)
            .iter()
            .flat_map(|&side| merged.complex.side_ends(side))
            .collect();
        on_sides.sort_unstable();
        let kept = own.iter().filter_map(|vertex| merged.vertices.binary_search(vertex).ok());
        let lone = kept.map(|vertex| vertex as u32).filter(|vertex| on_sides.binary_search(vertex).is_err());
        points.extend(lone.map(|vertex| (face as u32, vertex)));
    }
    points
}
