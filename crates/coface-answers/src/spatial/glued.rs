//! What congruence glued, as polygons for the exact method.

use super::{CongruentScene, SpatialScene};
use crate::answer::{CongruentPieces, JoinedFeatures};
use coface_algebra::{CellId, Error, FaceId, RaggedArray, Sign};

impl CongruentScene {
    /// The glued faces as the polygons of a scene, on the points that they have now: what is asked of exact cells can be asked of
    /// [`SceneArrangement`](super::SceneArrangement) of it. Inputs and the numbers of their polygons are those of this scene; a face
    /// that several polygons became is there for each of them.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruentScene, SceneArrangement, SpatialRequest, SpatialScene};
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = SpatialScene::of([("solid", &solid)], true)?;
    /// let glued = CongruentScene::of_scene(scene, 1e-9)?.glued_scene();
    /// assert_eq!(SceneArrangement::of_scene(glued, &SpatialRequest::default())?.volumes(), [1.0]);
    /// # Ok(()) }
    /// ```
    pub fn glued_scene(&self) -> SpatialScene {
        let scene = self.scene();
        let mut pieces: Vec<(u32, u32, Sign)> = Vec::new();
        for face in 0..self.complex().cell_count(2) {
            let own = self.arranged.polygons_of_face(FaceId::new(face));
            pieces.extend(own.map(|(polygon, sign)| (polygon as u32, face as u32, sign)));
        }
        pieces.sort_unstable_by_key(|&(polygon, face, _)| (polygon, face));
        let mut glued = scene.without_polygons(self.positions().as_flat().to_vec());
        for &(polygon, face, sign) in &pieces {
            let walks = self.walks_of(CellId::from_u32(face));
            let number = glued.input_of_polygon.len() as u32;
            for walk in walks.iter() {
                let mut walk = walk.to_vec();
                if sign == Sign::Minus {
                    walk.reverse();
                }
                glued.walks.push(&walk);
                glued.polygon_of_walk.push(number);
            }
            let polygon = polygon as usize;
            glued.input_of_polygon.push(scene.input_of_polygon()[polygon]);
            glued.source_of_polygon.push(scene.source_of_polygon()[polygon]);
            glued.is_wall.push(scene.is_wall(polygon));
        }
        if let Some(first) = scene.first_patch {
            glued.first_patch = Some(pieces.partition_point(|&(polygon, _, _)| (polygon as usize) < first));
        }
        glued.remarks.extend(self.remarks_on_gluing());
        glued
    }

    /// What congruence did, and which points became one, for an answer about [`Self::glued_scene`].
    ///
    /// # Errors
    /// None for arrangements that were made.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// let (done, joined) = coface_answers::CongruentScene::of_scene(scene, 1e-9)?.gluing()?;
    /// assert_eq!((done.stacked_f_vector[2], joined.moved), (4, 0));
    /// # Ok(()) }
    /// ```
    pub fn gluing(&self) -> Result<(CongruentPieces, JoinedFeatures), Error> {
        Ok((self.pieces(), self.joined()?))
    }
}

impl SpatialScene {
    /// The same inputs without polygons, on other points, which all files have in common.
    fn without_polygons(&self, flat: Vec<f64>) -> Self {
        Self {
            flat,
            point_starts: vec![0; self.point_starts.len()],
            walks: RaggedArray::new(),
            polygon_of_walk: Vec::new(),
            input_of_polygon: Vec::new(),
            source_of_polygon: Vec::new(),
            is_wall: Vec::new(),
            exact: Vec::new(),
            surfaces: vec![Vec::new(); self.surfaces.len()],
            first_patch: None,
            ..self.clone()
        }
    }
}
