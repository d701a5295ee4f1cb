//! Surfaces in space as formats of maps have them: `POLYHEDRALSURFACE` and `TIN` with heights.

use crate::holed_faces::triangulated;
use crate::lists::Elements;
use crate::oddities::{Oddities, Oddity};
use crate::{Place, Remark, RemarkCode};

/// The faces of surfaces, ring by ring.
#[derive(Debug, Default)]
pub(crate) struct SpaceFaces {
    /// The corners of all rings, none of which has its first again at its end.
    pub(crate) corners: Vec<[f64; 3]>,
    /// The corner behind the last of each ring, the surface it is of, and whether it is a hole.
    rings: Vec<(usize, u32, bool)>,
}

impl SpaceFaces {
    /// Adds a ring: the outer one of the next face, or a hole of the last.
    pub(crate) fn add(&mut self, corners: &[[f64; 3]], surface: u32, is_hole: bool) {
        let open = match corners {
            [first, inner @ .., last] if first == last && !inner.is_empty() => &corners[..corners.len() - 1],
            _ => corners,
        };
        self.corners.extend_from_slice(open);
        self.rings.push((self.corners.len(), surface, is_hole));
    }

    /// The surface of each corner.
    pub(crate) fn surface_of_corners(&self) -> impl Iterator<Item = u32> {
        let mut start = 0;
        self.rings.iter().flat_map(move |&(end, surface, _)| {
            let count = end - std::mem::replace(&mut start, end);
            std::iter::repeat_n(surface, count)
        })
    }

    /// The polygons of the faces, given the vertex of each corner, with the surface of each; a face with holes becomes triangles.
    pub(crate) fn elements(
        &self,
        vertices: &[u32],
        place: impl Fn(u32) -> [f64; 3] + Copy,
        remarks: &mut Vec<Remark>,
    ) -> (Elements, Vec<u32>) {
        let (mut elements, mut oddities) = (Elements::default(), Oddities::default());
        let mut surfaces = Vec::new();
        let (mut with_holes, mut with_odd_holes) = (0, 0);
        let mut start = 0;
        for face in self.rings.chunk_by(|_, &(_, _, is_hole)| is_hole) {
            let mut rings: Vec<Vec<u32>> = Vec::with_capacity(face.len());
            for &(end, ..) in face {
                rings.push(vertices[std::mem::replace(&mut start, end)..end].to_vec());
            }
            let triangles = if rings.len() > 1 { triangulated(&mut rings, place) } else { None };
            with_odd_holes += usize::from(rings.len() > 1 && triangles.is_none());
            with_holes += usize::from(triangles.is_some());
            let polygons = triangles.map_or_else(
                || vec![rings.swap_remove(0)],
                |triangles| triangles.into_iter().map(|triangle| triangle.to_vec()).collect(),
            );
            for polygon in polygons {
                if polygon.len() < 3 {
                    oddities.note(Oddity::Collapsed, || Place::cell(&polygon));
                    continue;
                }
                elements.polygons.items_mut().extend_from_slice(&polygon);
                elements.finish_face(&mut oddities, Place::default());
                surfaces.resize(elements.polygons.len(), face[0].1);
            }
        }
        remarks.extend(oddities.into_remarks());
        if with_holes > 0 {
            let message = match with_holes {
                1 => "a face with holes is read as triangles".to_owned(),
                count => format!("{count} faces with holes are read as triangles"),
            };
            remarks.push(Remark::new(RemarkCode::FacesTriangulated, message).at(with_holes, []));
        }
        if with_odd_holes > 0 {
            let message = match with_odd_holes {
                1 => "a face has holes that cross or touch its rings; they are left out".to_owned(),
                count => {
                    format!("{count} faces have holes that cross or touch their rings; they are left out")
                }
            };
            remarks.push(Remark::new(RemarkCode::DataLeftOut, message).at(with_odd_holes, []));
        }
        (elements, surfaces)
    }
}
