//! Walks around the faces of an arrangement, and triangles to draw them with.

use super::SpatialArrangement;
use super::axis_view::AxisView;
use super::face_walks::{Path, face_walks, vertices_of_walks};
use crate::near::is_boundary;
use coface_algebra::{Error, FaceId};
use coface_algebra::{RaggedArray, Sign};
use coface_geometry::triangulation::{flip_to_delaunay, triangulate_sides};
use rayon::prelude::*;

/// Triangles that faces of an arrangement are drawn with.
///
/// Vertices are fine vertices ([`SpatialArrangement::fine_triangles`] has their positions). Neighboring triangles share
/// whole sides, also those of different faces.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct DrawnTriangles {
    /// The corners, counterclockwise seen from the front of the face.
    pub triangles: Vec<[u32; 3]>,
    /// The face of each triangle, rising.
    pub face_of_triangle: Vec<u32>,
}

impl SpatialArrangement {
    /// The walks around a face as lists of its vertices, the outer one first: it runs counterclockwise seen from the
    /// front, holes run clockwise. A walk that meets itself turns left, so that what it runs around is in one piece; a
    /// slit is run through in both directions.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n sides.
    ///
    /// # Examples
    /// A square with a triangle standing on it:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// use coface_algebra::FaceId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = [0., 0., 0., 4., 0., 0., 4., 4., 0., 0., 4., 0.];
    /// let triangle = [1., 1., 0., 2., 1., 0., 2., 1., 3.];
    /// let positions = Positions::from_flat(3, [&square[..], &triangle].concat())?;
    /// let lists = RaggedArray::from_lists([vec![0, 1, 2, 3], vec![4, 5, 6]]);
    /// let polygons = SpatialPolygons::from_polygons(positions, lists)?;
    /// let arrangement = SpatialArrangement::new(&polygons, &SpatialOptions::default())?;
    /// let walks = arrangement.face_walks(FaceId::new(0));
    /// assert_eq!((walks.list(0).len(), walks.list(1)), (4, &[4, 5][..]));
    /// assert_eq!(arrangement.triangulated(FaceId::new(0))?.len(), 6);
    /// # Ok(()) }
    /// ```
    pub fn face_walks(&self, face: FaceId) -> RaggedArray {
        let paths = self.paths(face);
        let walks = face_walks(&paths, self.view(face), &self.cut.predicates());
        match &self.merged {
            None => vertices_of_walks(&paths, &walks, |_| true),
            Some(merged) => {
                let mut lists =
                    vertices_of_walks(&paths, &walks, |fine| merged.vertices.binary_search(&fine).is_ok());
                for vertex in lists.items_mut() {
                    *vertex = merged.vertices.binary_search(vertex).unwrap_or(0) as u32;
                }
                lists
            }
        }
    }

    /// The same as lists of fine vertices, with the points where edges of faces that are not planar bend.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert_eq!(tetrahedron.face_outlines(FaceId::new(0)).list(0).len(), 3);
    /// # Ok(()) }
    /// ```
    pub fn face_outlines(&self, face: FaceId) -> RaggedArray {
        let paths = self.paths(face);
        let walks = face_walks(&paths, self.view(face), &self.cut.predicates());
        vertices_of_walks(&paths, &walks, |fine| !self.is_omitted(fine))
    }

    /// The number of holes of all faces: of walks beyond the first of each. Walks that touch are one.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert_eq!(tetrahedron.hole_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn hole_count(&self) -> usize {
        let holes = |face: usize| {
            let face = FaceId::new(face);
            // Fewer sides do not make two walks, but for slits.
            if self.complex().sides(face).len() < 4 { 0 } else { self.face_walks(face).len() - 1 }
        };
        (0..self.complex().face_count()).into_par_iter().map(holes).sum()
    }

    /// The triangles to draw a face with: fine vertices, counterclockwise seen from its front. Sides of triangles on
    /// the boundary are the same for all faces there. A face of a polygon that is not planar has those along its folds.
    ///
    /// # Errors
    /// None for an arrangement that was made of polygons.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert_eq!(tetrahedron.triangulated(FaceId::new(0))?.len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn triangulated(&self, face: FaceId) -> Result<Vec<[u32; 3]>, Error> {
        let fine = self.first_fine_face(face);
        let is_flat = self.patches.fold(self.patches_of_face.list(fine.index())).is_none();
        self.triangulated_without(face, &self.is_omitted, is_flat)
    }

    /// The triangles to draw a face with when these fine vertices are left out of edges. One that is flat is drawn
    /// by its outline alone, if that is possible.
    pub(super) fn triangulated_without(
        &self,
        face: FaceId,
        is_left_out: &[bool],
        is_flat: bool,
    ) -> Result<Vec<[u32; 3]>, Error> {
        if let Some(corners) = self.single_triangle(face) {
            return Ok(vec![corners]);
        }
        let paths = self.paths(face);
        let kept = paths.iter().map(|path| kept(path, is_left_out));
        let sides: Vec<[u32; 2]> = kept.flat_map(|path| pairs(&path)).collect();
        if is_flat && let Ok(found) = self.triangles(&sides, self.view(face), self.is_planar(face)) {
            // What is in line as it is seen, or without a vertex, may be missing.
            let is_exact =
                self.is_planar(face) && sides.len() == paths.iter().map(|path| path.len() - 1).sum::<usize>();
            if is_exact || is_boundary(sides.iter().copied(), &found) {
                return Ok(found);
            }
        }
        let found = self.triangulated_by_fine_faces(face, is_left_out)?;
        // A vertex that is left out of an edge may be where sides inside the face end.
        match is_boundary(sides, &found) {
            true => Ok(found),
            false => Err(Error::invalid("a face needs a vertex that is left out")),
        }
    }

    /// The triangles of all fine faces of a face, with all vertices.
    pub(super) fn triangulated_fine(&self, face: FaceId) -> Result<Vec<[u32; 3]>, Error> {
        self.triangulated_by_fine_faces(face, &[])
    }

    fn triangulated_by_fine_faces(&self, face: FaceId, is_left_out: &[bool]) -> Result<Vec<[u32; 3]>, Error> {
        let mut all = Vec::new();
        for (fine, sign) in self.fine_faces(face) {
            let mut own =
                self.triangles(&self.sides_without(fine, is_left_out), self.plane_view(fine), true)?;
            if sign == Sign::Minus {
                own.iter_mut().for_each(|triangle| triangle.swap(1, 2));
            }
            all.extend(own);
        }
        Ok(all)
    }

    /// The corners of a face that is drawn as it is, since it is a triangle with nothing along its sides: the first
    /// side, and the corner opposite to it.
    #[doc(hidden)]
    pub fn single_triangle(&self, face: FaceId) -> Option<[u32; 3]> {
        let &[x, y, z] = self.complex().packed_sides().list(face.index()) else { return None };
        if self.fold(face).is_some() {
            return None;
        }
        let fine = |side: u32| match &self.merged {
            None => Some(side),
            Some(merged) => match merged.edges.list((side >> 1) as usize) {
                &[own] => Some(own ^ (side & 1)),
                _ => None,
            },
        };
        let ends = |side: u32| Some(self.cut.complex().side_ends(fine(side)?));
        corners_of_walk([ends(x)?, ends(y)?, ends(z)?])
    }

    /// The triangles to draw all faces with.
    ///
    /// # Errors
    /// As [`Self::triangulated`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert_eq!(tetrahedron.drawn_triangles()?.triangles.len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn drawn_triangles(&self) -> Result<DrawnTriangles, Error> {
        let lists: Vec<Result<Vec<[u32; 3]>, Error>> = (0..self.complex().face_count())
            .into_par_iter()
            .map(|face| self.triangulated(FaceId::new(face)))
            .collect();
        let mut drawn = DrawnTriangles::default();
        for (face, list) in (0..).zip(lists) {
            let list = list?;
            drawn.face_of_triangle.extend(list.iter().map(|_| face));
            drawn.triangles.extend(list);
        }
        Ok(drawn)
    }

    /// Triangles within these sides, as they are seen; if these are in one plane, no thinner than need be.
    fn triangles(&self, sides: &[[u32; 2]], view: AxisView, is_planar: bool) -> Result<Vec<[u32; 3]>, Error> {
        if let &[x, y, z] = sides
            && let Some(corners) = corners_of_walk([x, y, z])
        {
            return Ok(vec![corners]);
        }
        let predicates = self.cut.predicates();
        let compare = |a: u32, b: u32| view.compare(&predicates, a, b);
        let turn = |a: u32, b: u32, c: u32| view.turn(&predicates, [a, b, c]);
        let mut found = triangulate_sides(sides, compare, turn)?;
        if is_planar {
            let flat = self.cut.positions().as_flat().as_chunks::<3>().0;
            flip_to_delaunay(&mut found, sides, |vertex| flat[vertex as usize], turn);
        }
        Ok(found)
    }

    pub(super) fn is_omitted(&self, fine: u32) -> bool {
        self.is_omitted.get(fine as usize).is_some_and(|&omitted| omitted)
    }

    /// The sides of a face as paths of fine vertices.
    pub(super) fn paths(&self, face: FaceId) -> Vec<Path> {
        let sides = self.complex().packed_sides().list(face.index()).iter();
        match &self.merged {
            None => sides.map(|&side| self.cut.complex().side_ends(side).to_vec()).collect(),
            Some(merged) => sides.map(|&side| merged.path(self.cut.complex(), side)).collect(),
        }
    }

    /// The sides of a fine face, those that meet in a vertex that is left out as one.
    fn sides_without(&self, fine: FaceId, is_left_out: &[bool]) -> Vec<[u32; 2]> {
        let is_left_out = |vertex: u32| is_left_out.get(vertex as usize).is_some_and(|&left_out| left_out);
        let complex = self.cut.complex();
        let sides = complex.packed_sides().list(fine.index());
        let next = |side: u32| {
            let end = complex.side_ends(side)[1];
            let goes_on = |other: &&u32| complex.side_ends(**other)[0] == end && **other >> 1 != side >> 1;
            is_left_out(end).then(|| sides.iter().find(goes_on).copied()).flatten()
        };
        let starts = sides.iter().filter(|&&side| !is_left_out(complex.side_ends(side)[0]));
        starts
            .map(|&first| {
                let mut last = first;
                while let Some(side) = next(last) {
                    last = side;
                }
                [complex.side_ends(first)[0], complex.side_ends(last)[1]]
            })
            .collect()
    }
}

/// The corners of a triangle with these sides, the first side first; `None` if they are no closed walk.
fn corners_of_walk([[a, b], [c, d], [e, f]]: [[u32; 2]; 3]) -> Option<[u32; 3]> {
    if b == c && d == e && f == a {
        Some([a, b, d])
    } else {
        (b == e && f == c && d == a).then_some([a, b, f])
    }
}

fn kept(path: &[u32], is_left_out: &[bool]) -> Path {
    let is_kept = |fine: &u32| !is_left_out.get(*fine as usize).is_some_and(|&left_out| left_out);
    path.iter().copied().filter(is_kept).collect()
}

fn pairs(path: &[u32]) -> Vec<[u32; 2]> {
    path.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}
