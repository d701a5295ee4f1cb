//! The answers of `cover`: universal covers and orientation double covers.

use super::Remark;
use crate::{PlacedCover, SurfaceCover, SurfaceModel};
use coface_algebra::Error;
use coface_complexes::surface::GeneralizedMap;
use coface_io::Model;
use serde::{Deserialize, Serialize};

/// A part of a universal cover: copies of the surface cut to a disk, one for each element of the fundamental group.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CoverAnswer {
    /// The name of the input; absent for a model that was made in memory.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub file: Option<String>,
    /// The component that is covered, counted from 0.
    pub component: usize,
    /// The number of components.
    pub components: usize,
    /// The surface below, in words.
    pub surface: String,
    /// The group of deck transformations.
    pub group: String,
    /// The number of copies.
    pub copies: usize,
    /// Whether this is the whole cover.
    pub complete: bool,
    /// The numbers of copies at distance 0, 1, ... of the first.
    pub spheres: Vec<usize>,
    /// The numbers of vertices, edges and faces.
    pub f_vector: Vec<usize>,
    /// Vertices minus edges plus faces.
    pub euler_characteristic: i64,
    /// The edges that letters of the words cross, by their vertices in the file.
    pub letters: Vec<[u32; 2]>,
    /// The word of each copy: i for letter i, counted from 1, -i for its inverse.
    pub words: Vec<Vec<i32>>,
    /// Where the mesh lies: `flat` or `disk`; `null` over the surface.
    pub layout: Option<String>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// An orientation double cover: every face twice, so that neighbors agree.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DoubleCoverAnswer {
    /// The name of the input.
    pub file: String,
    /// The number of copies of each face: 2.
    pub copies: usize,
    /// The components of the surface below, in words.
    pub surfaces_below: Vec<String>,
    /// The components of the cover, in words.
    pub surfaces: Vec<String>,
    /// The numbers of vertices, edges and faces.
    pub f_vector: Vec<usize>,
    /// Vertices minus edges plus faces.
    pub euler_characteristic: i64,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

impl SurfaceModel {
    /// The answer about the orientation double cover, with this name of the input, and the cover as a model.
    ///
    /// # Errors
    /// As of [`Self::orientation_double_cover`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// // A Moebius band.
    /// let band = coface_io::read(&b"[[0,1,2],[1,2,3],[2,3,4],[3,4,0],[4,0,1]]"[..], coface_io::Format::Json)?;
    /// let (answer, _) = SurfaceModel::of(band)?.double_cover("band.json")?;
    /// assert_eq!(answer.surfaces, ["annulus"]);
    /// # Ok(()) }
    /// ```
    pub fn double_cover(&self, file: &str) -> Result<(DoubleCoverAnswer, Model), Error> {
        let (map, model) = self.orientation_double_cover()?;
        let [v, e, f] = [map.vertex_count(), map.edge_count(), map.face_count()];
        let names = |map: &GeneralizedMap| map.surfaces().iter().map(ToString::to_string).collect();
        let answer = DoubleCoverAnswer {
            file: file.to_owned(),
            copies: 2,
            surfaces_below: names(self.map()),
            surfaces: names(&map),
            f_vector: vec![v, e, f],
            euler_characteristic: v as i64 - e as i64 + f as i64,
            remarks: Vec::new(),
        };
        Ok((answer, model))
    }
}

impl SurfaceCover<'_> {
    /// The cover as plain data, without the name of a file; with the layout if the mesh was placed.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// use coface_topology::CoverExtent;
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cover = surface.cover(0, CoverExtent::Radius(1), 1_000_000)?;
    /// assert_eq!((cover.answer(None).copies, cover.answer(None).spheres), (5, vec![1, 4]));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self, placed: Option<&PlacedCover>) -> CoverAnswer {
        let cover = self.cover();
        CoverAnswer {
            file: None,
            component: self.component(),
            components: self.component_count(),
            surface: self.below().to_owned(),
            group: cover.group().name().to_string(),
            copies: cover.copy_count(),
            complete: cover.is_complete(),
            spheres: cover.sphere_sizes(),
            f_vector: cover.f_vector(),
            euler_characteristic: cover.euler_characteristic(),
            letters: self.letter_edges(),
            words: (0..cover.copy_count()).map(|copy| cover.copy_word(copy).letters().to_vec()).collect(),
            layout: placed.map(|placed| placed.word().to_owned()),
            remarks: Vec::new(),
        }
    }
}
