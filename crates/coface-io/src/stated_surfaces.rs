//! Surfaces with their rings, shells and solids, as a file states them.

use crate::Model;
use coface_algebra::{Error, RaggedArray};
use coface_arrange::spatial::checks::{CheckedFaces, CheckedPrimitive};

/// The surfaces of a file before those with holes became triangles: the rings of each, the shell that it is in, and the solid that the
/// shell bounds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StatedSurfaces {
    faces: CheckedFaces,
    polygon_of_face: Vec<u32>,
    polygon_count: usize,
    vertex_count: usize,
    incomplete_count: usize,
}

impl StatedSurfaces {
    /// The number of surfaces whose polygons are without their holes, since these cross or touch other rings, or have less than three
    /// vertices.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The hole reaches out of the square.
    /// let text = r#"{"type": "CityJSON", "version": "2.0", "CityObjects": {"slab": {"type": "Building", "geometry": [
    ///         {"type": "MultiSurface", "lod": "2", "boundaries": [[[0, 1, 2, 3], [4, 5, 6]]]}]}},
    ///     "vertices": [[0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 9, 0], [3, 3, 0], [3, 6, 0], [12, 6, 0]]}"#;
    /// let model = coface_io::cityjson::read(text.as_bytes())?;
    /// assert_eq!(model.stated_surfaces().map(|surfaces| surfaces.incomplete_count()), Some(1));
    /// # Ok(()) }
    /// ```
    pub fn incomplete_count(&self) -> usize {
        self.incomplete_count
    }

    /// The surfaces, for [`GeometryChecks`](coface_arrange::spatial::checks::GeometryChecks).
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = r#"{"type": "CityJSON", "version": "2.0", "CityObjects": {"slab": {"type": "Building", "geometry": [
    ///         {"type": "MultiSurface", "lod": "2", "boundaries": [[[0, 1, 2, 3], [4, 5, 6]]]}]}},
    ///     "vertices": [[0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 9, 0], [3, 3, 0], [3, 6, 0], [6, 6, 0]]}"#;
    /// let model = coface_io::cityjson::read(text.as_bytes())?;
    /// let faces = model.stated_surfaces().map(|surfaces| surfaces.faces());
    /// // One surface with two rings, which is drawn as seven triangles.
    /// assert_eq!(faces.map(|faces| (faces.face_count(), faces.rings().len())), Some((1, 2)));
    /// assert_eq!(model.polygons().len(), 7);
    /// # Ok(()) }
    /// ```
    pub fn faces(&self) -> &CheckedFaces {
        &self.faces
    }

    /// The first polygon of the model that a surface became.
    ///
    /// # Panics
    /// If there is no such surface.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = r#"{"type": "CityJSON", "version": "2.0", "CityObjects": {"shed": {"type": "Building", "geometry": [
    ///         {"type": "Solid", "lod": "1", "boundaries": [[[[0, 2, 1]], [[0, 1, 3]], [[1, 2, 3]], [[2, 0, 3]]]]}]}},
    ///     "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 6]]}"#;
    /// let model = coface_io::cityjson::read(text.as_bytes())?;
    /// assert_eq!(model.stated_surfaces().map(|surfaces| surfaces.polygon_of_face(3)), Some(3));
    /// # Ok(()) }
    /// ```
    pub fn polygon_of_face(&self, face: usize) -> u32 {
        self.polygon_of_face[face]
    }
}

impl Model {
    /// The surfaces as the file states them, if it tells rings, shells and solids apart, and the polygons are still those that were
    /// made of them.
    ///
    /// # Examples
    /// ```
    /// let model = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// assert!(model.stated_surfaces().is_none());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn stated_surfaces(&self) -> Option<&StatedSurfaces> {
        let found = self.stated.as_deref()?;
        let is_as_read =
            found.polygon_count == self.polygons.len() && found.vertex_count == self.vertex_count;
        is_as_read.then_some(found)
    }
}

/// Surfaces that are collected while a file is read.
#[derive(Debug, Default)]
pub(crate) struct SurfaceCollector {
    rings: RaggedArray,
    face_of_ring: Vec<u32>,
    polygon_of_face: Vec<u32>,
    shell_of_face: Vec<u32>,
    solid_of_shell: Vec<u32>,
    primitives: Vec<CheckedPrimitive>,
    composite_count: u32,
}

impl SurfaceCollector {
    /// The number of a composite of its own.
    pub(crate) fn new_composite(&mut self) -> u32 {
        self.composite_count += 1;
        self.composite_count - 1
    }

    /// The surfaces that follow are in a shell of a solid of its own, which is stated to be this, or of the last one; surfaces that
    /// bound no solid are in one too.
    pub(crate) fn begin_shell(&mut self, new_solid: Option<CheckedPrimitive>) {
        self.primitives.extend(new_solid);
        self.solid_of_shell.push(self.primitives.len() as u32 - 1);
    }

    /// A surface of the last shell, or of none where no shell began, the outer ring first, that becomes polygons from this one on.
    pub(crate) fn add(&mut self, rings: &[Vec<u32>], polygon: usize) {
        let face = self.polygon_of_face.len() as u32;
        for ring in rings {
            self.rings.push(ring);
            self.face_of_ring.push(face);
        }
        self.polygon_of_face.push(polygon as u32);
        self.shell_of_face.push((self.solid_of_shell.len() as u32).saturating_sub(1));
    }

    /// # Errors
    /// None for surfaces that were added.
    pub(crate) fn finish(self, model: &Model, incomplete_count: usize) -> Result<StatedSurfaces, Error> {
        let mut faces = CheckedFaces::from_rings(self.rings, &self.face_of_ring)?;
        if !self.solid_of_shell.is_empty() {
            faces = faces
                .with_shells(self.shell_of_face, self.solid_of_shell)?
                .with_primitives(self.primitives)?;
        }
        Ok(StatedSurfaces {
            faces,
            polygon_of_face: self.polygon_of_face,
            polygon_count: model.polygons.len(),
            vertex_count: model.vertex_count,
            incomplete_count,
        })
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.polygon_of_face.is_empty()
    }
}
