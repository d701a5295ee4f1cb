//! Surfaces that cover others.

use super::SurfaceModel;
use super::cutting::polygons_of_map;
use coface_algebra::progress::stage;
use coface_algebra::{Error, FaceId, VertexId};
use coface_complexes::surface::GeneralizedMap;
use coface_geometry::Positions;
use coface_io::{CellData, GroupKind, Model};
use coface_topology::{CoverExtent, CoverPlane, CutSurface, TreeCotree, UniversalCover};

/// Where the copies of a universal cover are to lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LayoutChoice {
    /// In the plane or in the disk, whichever there is.
    Any,
    /// In the plane, by translations and glide reflections.
    Flat,
    /// In the disk of Poincare, where hyperbolic angles are right.
    Disk,
    /// In the disk of Klein, where hyperbolic lines are straight, so that a mesh with straight sides is the cover.
    Klein,
}

/// A part of the universal cover of a component of a surface.
///
/// Made by [`SurfaceModel::cover`].
#[derive(Clone, Debug)]
pub struct SurfaceCover<'s> {
    surface: &'s SurfaceModel,
    cover: UniversalCover,
    /// The name of what is covered, the number of the component and how many there are.
    below: String,
    component: usize,
    component_count: usize,
}

/// The positions of a cover.
#[derive(Clone, Debug)]
pub struct PlacedCover {
    word: &'static str,
    positions: Positions,
}

impl PlacedCover {
    /// `flat`, `disk` or `klein`.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{LayoutChoice, SurfaceModel};
    /// use coface_topology::CoverExtent;
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cover = surface.cover(0, CoverExtent::Radius(1), 1_000_000)?;
    /// assert_eq!(cover.placed(LayoutChoice::Flat)?.word(), "flat");
    /// # Ok(()) }
    /// ```
    pub fn word(&self) -> &'static str {
        self.word
    }
}

impl SurfaceModel {
    /// The universal cover of a component, as far as it is asked for.
    ///
    /// # Errors
    /// Those of [`UniversalCover::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_io::{Model, Structure};
    /// use coface_answers::SurfaceModel;
    /// use coface_topology::CoverExtent;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let torus = Model::from_structure(Structure::Facets(RaggedArray::from_lists(triangles)));
    /// let surface = SurfaceModel::of(torus)?;
    /// let cover = surface.cover(0, CoverExtent::Radius(2), 1_000_000)?;
    /// assert_eq!(cover.cover().sphere_sizes(), [1, 4, 8]);
    /// # Ok(()) }
    /// ```
    pub fn cover(
        &self,
        component: usize,
        extent: CoverExtent,
        most_cells: usize,
    ) -> Result<SurfaceCover<'_>, Error> {
        let map = self.map();
        let cutting = stage("cutting", 0);
        let trees = TreeCotree::new(map);
        let cut = CutSurface::new(map, &trees);
        drop(cutting);
        let _gluing = stage("gluing copies", 0);
        let cover = UniversalCover::new(map, &cut, component, extent, most_cells)?;
        let root = trees.components()[component].root();
        let below = map.surfaces()[map.orientation().component(root)].to_string();
        Ok(SurfaceCover { surface: self, cover, below, component, component_count: trees.components().len() })
    }

    /// The cover that has each face twice, once for each of its sides, as a model: data are `source` and `copy` on vertices, `face` and `copy`
    /// on polygons. With it the covering surface.
    ///
    /// # Errors
    /// Those of [`Self::model_over`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let (cover, model) = surface.orientation_double_cover()?;
    /// assert_eq!((cover.face_count(), model.polygons().len()), (28, 28));
    /// # Ok(()) }
    /// ```
    pub fn orientation_double_cover(&self) -> Result<(GeneralizedMap, Model), Error> {
        let _covering = stage("covering", 0);
        let cover = self.map().orientation_double_cover();
        let map = cover.map();
        let (v, f) = (map.vertex_count(), map.face_count());
        let vertices: Vec<VertexId> =
            (0..v).map(|vertex| cover.vertex_below(VertexId::new(vertex))).collect();
        let below: Vec<FaceId> = (0..f).map(|face| cover.face_below(FaceId::new(face)).0).collect();
        let sheet = |count: usize| (0..count as i64).map(|cell| cell % 2).collect();
        let model = self
            .model_over(polygons_of_map(map), &vertices, &below, None)?
            .with_data(CellData::integers("copy", GroupKind::Vertices, 1, sheet(v))?)?
            .with_data(CellData::integers("copy", GroupKind::Polygons, 1, sheet(f))?)?;
        Ok((map.clone(), model))
    }
}

impl SurfaceCover<'_> {
    /// The cover.
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
    /// assert_eq!(cover.cover().sphere_sizes(), [1, 4]);
    /// # Ok(()) }
    /// ```
    pub fn cover(&self) -> &UniversalCover {
        &self.cover
    }

    /// The number of components of the surface.
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
    /// assert_eq!(cover.component_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn component_count(&self) -> usize {
        self.component_count
    }

    /// Positions in a plane.
    ///
    /// # Errors
    /// Those of [`UniversalCover::layout`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) where the layout is the other one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{LayoutChoice, SurfaceModel};
    /// use coface_topology::CoverExtent;
    /// // The torus of seven vertices.
    /// let triangles = (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]);
    /// let facets = coface_io::Structure::Facets(coface_algebra::RaggedArray::from_lists(triangles));
    /// let surface = SurfaceModel::of(coface_io::Model::from_structure(facets))?;
    /// let cover = surface.cover(0, CoverExtent::Radius(1), 1_000_000)?;
    /// assert_eq!(cover.placed(LayoutChoice::Flat)?.word(), "flat");
    /// assert!(cover.placed(LayoutChoice::Disk).is_err());
    /// # Ok(()) }
    /// ```
    pub fn placed(&self, layout: LayoutChoice) -> Result<PlacedCover, Error> {
        let _laying = stage("laying out", 0);
        let found = self.cover.layout(self.surface.map(), None)?;
        let other = match (layout, found.plane()) {
            (LayoutChoice::Flat, CoverPlane::Hyperbolic) => Some("disk"),
            (LayoutChoice::Disk | LayoutChoice::Klein, CoverPlane::Flat) => Some("flat"),
            _ => None,
        };
        if let Some(other) = other {
            let message = "the cover has no such layout, because of its Euler characteristic";
            return Err(Error::invalid(message).with_cure(format!("take the layout {other}")));
        }
        let word = match (layout, found.plane()) {
            (LayoutChoice::Klein, _) => "klein",
            (_, CoverPlane::Flat) => "flat",
            _ => "disk",
        };
        // A point of the disk of Poincare is half as far from the middle, in the hyperbolic plane, as the same point of the disk of Klein.
        let scale = |[x, y]: [f64; 2]| if word == "klein" { 2.0 / (1.0 + x * x + y * y) } else { 1.0 };
        let place = |&[x, y]: &[f64; 2]| [scale([x, y]) * x, scale([x, y]) * y, 0.0];
        let coordinates = found.points().iter().flat_map(place).collect();
        Ok(PlacedCover { word, positions: Positions::from_flat(3, coordinates)? })
    }

    /// The cover as a model: data are `source` and `copy` on vertices, `face`, `copy` and `length`, the distance of the copy, on polygons.
    ///
    /// # Errors
    /// Those of [`SurfaceModel::model_over`].
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
    /// assert_eq!(cover.model(None)?.polygons().len(), 5 * 14);
    /// # Ok(()) }
    /// ```
    pub fn model(&self, placed: Option<&PlacedCover>) -> Result<Model, Error> {
        let cover = &self.cover;
        let skeleton = cover.skeleton();
        let (vertex_count, face_count) = (skeleton.vertex_count(), skeleton.face_count());
        let vertices = || (0..vertex_count).map(VertexId::new);
        let faces = || (0..face_count).map(FaceId::new);
        let vertex_sources: Vec<VertexId> = vertices().map(|vertex| cover.vertex_below(vertex)).collect();
        let face_sources: Vec<FaceId> = faces().map(|face| cover.face_below(face)).collect();
        let data = |name: &str, kind, values: Vec<i64>| CellData::integers(name, kind, 1, values);
        let copy_lengths: Vec<i64> =
            (0..cover.copy_count()).map(|copy| cover.copies().length(copy) as i64).collect();
        let lengths = faces().map(|face| copy_lengths[cover.face_copy(face)]).collect();
        let copies_of_vertices = vertices().map(|vertex| cover.vertex_copy(vertex) as i64).collect();
        let copies_of_faces = faces().map(|face| cover.face_copy(face) as i64).collect();
        let positions = placed.map(|placed| placed.positions.clone());
        self.surface
            .model_over(cover.polygons(), &vertex_sources, &face_sources, positions)?
            .with_data(data("copy", GroupKind::Vertices, copies_of_vertices)?)?
            .with_data(data("copy", GroupKind::Polygons, copies_of_faces)?)?
            .with_data(data("length", GroupKind::Polygons, lengths)?)
    }

    /// The surface that is covered.
    pub(super) fn surface(&self) -> &SurfaceModel {
        self.surface
    }

    /// The component that is covered, counted from 0.
    pub(crate) fn component(&self) -> usize {
        self.component
    }

    /// The surface below, in words.
    pub(crate) fn below(&self) -> &str {
        &self.below
    }

    /// The edges that letters cross, by their vertices in the file.
    pub(crate) fn letter_edges(&self) -> Vec<[u32; 2]> {
        self.cover.letters().into_iter().map(|edge| self.surface.edge_numbers(edge)).collect()
    }
}
