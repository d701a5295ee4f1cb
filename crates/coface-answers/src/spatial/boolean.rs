//! Boolean combinations of the models of a scene.

use super::arranged::Arranged;
use super::coarse::refuse_other_result;
use super::coincident::coincident;
use super::enclosed::turned_parts;
use super::solid_request::surface_alone;
use super::{InputState, SceneArrangement, SolidRequest};
use crate::answer::{
    BoundaryManifold, BoundaryVerdict, BoundaryWitness, InsideMethod, Pinches, SolidBooleanAnswer,
    SpatialInput,
};
use crate::facts::witness;
use crate::producer::Labels;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind, VertexId};
use coface_algebra::{RaggedArray, Sign, UnionFind};
use coface_arrange::CoordinatePrecision;
use coface_arrange::boolean::{BooleanFormula, CellSelection, InsideRule, SelectionBoundary, SelectionMesh};
use coface_arrange::spatial::{
    CoplanarMerge, CoplanarTriangles, Crossings, SpatialPolygons, merge_coplanar_triangles,
};
use coface_complexes::surface::{PolygonMesh, SurfaceVerdict};
use coface_geometry::{Positions, Sum, polygon_area};
use coface_io::repeated_vertex;
use rayon::prelude::*;
use std::sync::OnceLock;

/// So many pinches of a sort are listed.
const MOST_LISTED: usize = 100;
/// A volume changes by at most so many times the area around it and the way that points of it move, both of which are rounded.
const MOVED_VOLUME: f64 = 4.0;
/// So many faces are cut into polygons at a time.
const CHUNK: usize = 1 << 11;
/// A mesh has fewer corners than this.
const MOST_CORNERS: usize = 1 << 30;
/// Where a face has the exterior.
pub(super) const EXTERIOR: u32 = u32::MAX;

/// What a formula makes of the models of a scene: some cells of their arrangement, and the surface around them.
///
/// # Examples
/// Of two tetrahedra on a common face the union:
/// ```
/// use coface_arrange::boolean::BooleanFormula;
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let read = |top: &str| {
///     let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nv {top}\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
///     io::read(text.as_bytes(), Format::Obj)
/// };
/// let (up, down) = (read("0 0 6")?, read("0 0 -12")?);
/// let scene = SceneArrangement::of([("up", &up), ("down", &down)], &SpatialRequest::default())?;
/// let union = SolidBoolean::of(&scene, &SolidRequest::of(BooleanFormula::parse("a | b", &[])?))?;
/// assert_eq!(union.volume(), Some(3.0));
/// assert_eq!(union.mesh().f_vector(), [5, 9, 6]);
/// assert!(union.mesh().manifold_verdict().is_manifold());
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct SolidBoolean<'a> {
    pub(super) arrangement: &'a SceneArrangement,
    pub(super) request: SolidRequest,
    pub(super) selection: CellSelection,
    pub(super) boundary: SelectionBoundary,
    /// The boundary, with copies of vertices if pinches are split.
    pub(super) surface: SelectionMesh,
    /// Made when it is asked for.
    mesh: OnceLock<PolygonMesh>,
    crossings: OnceLock<Crossings>,
    turned: OnceLock<Vec<[f64; 3]>>,
    /// The numbers of vertices and edges that splitting pinches added.
    copies: [usize; 2],
    /// The cells behind and in front of each face.
    pub(super) sides: Vec<[u32; 2]>,
    /// The connected part of each cell, selected or not; that of the exterior last.
    pub(super) regions: Vec<u32>,
    /// The facets that each polygon of the surface has parts of, where they were put together.
    pub(super) merged_facets: Option<Vec<Vec<(CellId, Sign)>>>,
    /// Whether it is known that rounded polygons of the surface cross, though not where.
    is_crossing: bool,
}

impl<'a> SolidBoolean<'a> {
    /// The cells for which the formula holds.
    ///
    /// # Errors
    /// [`ErrorKind::NotACycle`] naming a model that is open, with a closed walk along its rim, or whose polygons do not agree in
    /// direction; [`ErrorKind::InvalidInput`] if the formula names a model that is not there, or if pinches are to be split
    /// while walls are kept; [`ErrorKind::UnsupportedFormat`] where numbers of 32 bits are too coarse for the result.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n sides of faces, and the number of cells times that of models.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.volume(), Some(1.0));
    /// # Ok(()) }
    /// ```
    pub fn of(arrangement: &'a SceneArrangement, request: &SolidRequest) -> Result<Self, Error> {
        let SceneArrangement { scene, arranged, inputs, .. } = arrangement;
        let input_count = scene.names().len();
        check_formula(&request.formula, input_count)?;
        if request.keep_walls && request.split_pinches {
            return Err(Error::invalid("pinches cannot be split while walls are kept")
                .with_cure("ask for one of both; cells that touch are told apart by walls"));
        }
        let complex = arranged.complex();
        let selection = match &arrangement.surface {
            Some(surface) if surface.request.is_of_same_cells(request) => surface.selection.clone(),
            Some(_) => return Err(surface_alone()),
            None => {
                let membership = inputs.membership(
                    scene,
                    arranged,
                    request.rule,
                    request.open,
                    &arrangement.request,
                    |input| request.formula.names(input),
                )?;
                let cells = complex.cell_count(3);
                CellSelection::by_membership(cells, &request.formula, |cell, input| {
                    membership.is_inside(cell, input)
                })
            }
        };
        let mut boundary = selection.boundary_without_pinches(complex)?;
        let facets = boundary.facets().to_vec();
        let (surface, ()) = rayon::join(
            || arrangement.mesh_of(&facets, request.triangles),
            || {
                let [slits, points] = arranged.inside_faces(&facets);
                boundary.find_pinches(complex, &slits, &points);
            },
        );
        let mut surface = surface?;
        if surface.polygons().item_count() >= MOST_CORNERS {
            return Err(Error::new(
                ErrorKind::TooLarge,
                "2^30 or more corners of polygons around the result",
            ));
        }
        let mut copies = [0; 2];
        if request.split_pinches && !boundary.is_manifold() {
            let is_drawn =
                |vertex: u32| surface.vertex_sources().binary_search(&CellId::from_u32(vertex)).is_ok();
            let edges = arranged.drawn_edges(boundary.pinched_ridges(), is_drawn);
            let faces = arranged.faces_of_fine();
            let edge_count = mesh_on(&surface).edge_count();
            let around = |[a, b]: [CellId; 2]| {
                let ends = [a.to_u32(), b.to_u32()];
                let found = edges.binary_search_by_key(&ends, |edge| edge.ends);
                found.map_or(Vec::new(), |at| arranged.faces_around(&edges[at], &faces))
            };
            copies[0] = surface.split_pinches(around)?;
            copies[1] = mesh_on(&surface).edge_count() - edge_count;
        }
        let sides = sides_of_faces(complex);
        let regions = regions(&selection, &sides, complex.cell_count(3));
        let (crossings, turned) = (OnceLock::new(), OnceLock::new());
        let (mut merged_facets, mut is_crossing) = (None, false);
        if request.merge_coplanar && request.triangles && !request.keep_walls {
            let positions = surface.positions(arranged.drawn_positions())?;
            let is_rounded = arranged.joined().is_some() || !arranged.is_exactly_rounded();
            let tolerance =
                if is_rounded { rounding_of(&positions, arrangement.request.precision) } else { 0.0 };
            let triangles: Vec<[u32; 3]> = surface.polygons().items().as_chunks::<3>().0.to_vec();
            // With exact coordinates triangles are those that were cut.
            let is_moved = match arranged.is_exactly_rounded() {
                true => vec![false; triangles.len()],
                false => rounded_polygons(arranged, &surface),
            };
            let merge = merge_coplanar_triangles(&positions, &triangles, tolerance, |own| is_moved[own])?;
            is_crossing = merge == CoplanarMerge::Crossing;
            if let Some(merged) = merge.merged() {
                let first = |&patch: &u32| merged.patches.list(patch as usize)[0];
                let pairs = merged.triangles.iter().zip(&merged.patch_of_triangle);
                let drawn = surface.with_triangles(pairs.map(|(&own, patch)| (own, first(patch))));
                let is_turned = is_rounded && {
                    let positions = drawn.positions(arranged.drawn_positions())?;
                    !turned_of(&drawn, &positions, &sides, &regions).is_empty()
                };
                if !is_turned {
                    merged_facets = Some(facets_of_patches(&merged, surface.facets()));
                    surface = drawn;
                }
                let positions = surface.positions(arranged.drawn_positions())?;
                if is_rounded && !is_turned && coincident(&surface, &positions).is_empty() {
                    // It was looked for crossings and turned parts.
                    crossings.get_or_init(Crossings::default);
                    turned.get_or_init(Vec::new);
                }
            }
        }
        let result = Self {
            arrangement,
            request: request.clone(),
            selection,
            boundary,
            surface,
            mesh: OnceLock::new(),
            crossings,
            turned,
            copies,
            sides,
            regions,
            merged_facets,
            is_crossing,
        };
        if let Some(exact) = &arrangement.unrounded
            && let Some(volume) = result.volume()
        {
            refuse_other_result(exact, request, (volume, result.part_counts()[0]))?;
        }
        Ok(result)
    }

    /// The cells that are selected.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert!(same.selection().contains(coface_algebra::CellId::new(0)));
    /// # Ok(()) }
    /// ```
    pub fn selection(&self) -> &CellSelection {
        &self.selection
    }

    /// The faces around them, walls, and pinches, in the arrangement.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.boundary().facets().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn boundary(&self) -> &SelectionBoundary {
        &self.boundary
    }

    /// The surface around the selected cells with the face that each polygon is part of.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.surface().facets().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn surface(&self) -> &SelectionMesh {
        &self.surface
    }

    /// The same as a mesh, for what can be asked of one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.mesh().f_vector(), [4, 6, 4]);
    /// # Ok(()) }
    /// ```
    pub fn mesh(&self) -> &PolygonMesh {
        self.mesh.get_or_init(|| mesh_on(&self.surface))
    }

    /// Where polygons of the surface with rounded coordinates meet otherwise than in common vertices and edges: nowhere if
    /// rounding is valid, as it is where no coordinate of the arrangement was rounded.
    ///
    /// # Errors
    /// None for arrangements that were made.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.crossings()?.count, 0);
    /// # Ok(()) }
    /// ```
    pub fn crossings(&self) -> Result<&Crossings, Error> {
        if let Some(found) = self.crossings.get() {
            return Ok(found);
        }
        let arranged = &self.arrangement.arranged;
        // Polygons of faces that are not planar may be drawn with other triangles than those that were cut.
        let is_cut_so = || {
            self.boundary.facets().iter().all(|facet| self.request.triangles || arranged.is_planar(facet.0))
        };
        let found = if arranged.is_exactly_rounded() && is_cut_so() {
            Crossings::default()
        } else {
            let polygons =
                SpatialPolygons::from_polygons(self.positions()?, self.surface.polygons().clone())?;
            // A polygon that is not simple any more is refused.
            let is_moved = rounded_polygons(arranged, &self.surface);
            let found = polygons.crossings_of_changed(|own| is_moved[own], MOST_LISTED);
            let mut found = found.or_else(|error| match error.kind() {
                ErrorKind::InvalidInput => self.arrangement.crossings().cloned(),
                _ => Err(error),
            })?;
            for place in coincident(&self.surface, &self.positions()?) {
                found.add(place, MOST_LISTED);
            }
            found
        };
        Ok(self.crossings.get_or_init(|| found))
    }

    /// A corner of each solid and void of the result that rounding of coordinates made flat or turned inside out; decided
    /// exactly for the surface as it is drawn.
    ///
    /// # Errors
    /// None for results that were made.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("a", &solid)], &Default::default())?;
    /// let result = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::union(1)))?;
    /// assert!(result.turned_parts()?.is_empty());
    /// # Ok(()) }
    /// ```
    pub fn turned_parts(&self) -> Result<&[[f64; 3]], Error> {
        if let Some(found) = self.turned.get() {
            return Ok(found);
        }
        let found = if self.arrangement.arranged.is_exactly_rounded() {
            Vec::new()
        } else {
            turned_of(&self.surface, &self.positions()?, &self.sides, &self.regions)
        };
        Ok(self.turned.get_or_init(|| found))
    }

    /// Whether rounded coordinates are a valid surface: faces meet in common vertices and edges alone, no solid or void
    /// is flat or inside out, and coordinates are numbers of the precision that was asked for.
    ///
    /// # Errors
    /// As [`Self::crossings`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("a", &solid)], &Default::default())?;
    /// assert!(SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::union(1)))?.is_valid()?);
    /// # Ok(()) }
    /// ```
    pub fn is_valid(&self) -> Result<bool, Error> {
        Ok(!self.is_crossing
            && self.arrangement.is_held(&self.positions()?)
            && self.crossings()?.count == 0
            && self.turned_parts()?.is_empty())
    }

    /// An arrangement with rounded coordinates that are valid, from which the same request gets the same result: of the surface
    /// of this result alone where that will do, else as [`SceneArrangement::validly_rounded`]. The former answers no other request.
    ///
    /// # Errors
    /// As [`SceneArrangement::validly_rounded`].
    ///
    /// # Complexity
    /// That of arranging the surface again, some times.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("a", &solid)], &Default::default())?;
    /// let request = SolidRequest::of(BooleanFormula::union(1));
    /// let result = SolidBoolean::of(&arranged, &request)?;
    /// let rounded = result.validly_rounded()?.expect("its coordinates are exact as they are");
    /// assert_eq!(SolidBoolean::of(&rounded, &request)?.volume(), Some(1.0));
    /// assert!(SolidBoolean::of(&rounded, &SolidRequest::of(BooleanFormula::parse("~a", &[])?)).is_err());
    /// # Ok(()) }
    /// ```
    pub fn validly_rounded(&self) -> Result<Option<SceneArrangement>, Error> {
        let whole = self.arrangement;
        let is_plain = whole.request.tolerance.is_none()
            && whole.request.precision == CoordinatePrecision::Double
            && whole.surface.as_ref().is_none_or(|surface| surface.operands.is_some());
        if !self.request.keep_walls && is_plain {
            match whole.snapped_surface(self) {
                Ok(rounded) if self.is_kept_by(&rounded) => return Ok(Some(rounded)),
                // What vanished is said of the whole arrangement.
                Ok(_) => {}
                Err(error) if matches!(error.kind(), ErrorKind::InvalidInput | ErrorKind::NotACycle) => {}
                Err(error) => return Err(error),
            }
        }
        whole.validly_rounded()
    }

    /// Whether the surface alone has as many solids and voids within and between it as the result, and the volume but for what its
    /// points moved.
    fn is_kept_by(&self, rounded: &SceneArrangement) -> bool {
        let Some(surface) = &rounded.surface else { return false };
        let complex = rounded.complex();
        let regions = regions(&surface.selection, &sides_of_faces(complex), complex.cell_count(3));
        if part_counts(&surface.selection, &regions) != self.part_counts() {
            return false;
        }
        let Some((before, after)) = self.volume().zip(volume_of(rounded, &surface.selection)) else {
            return true;
        };
        let moved =
            rounded.arranged.joined().map_or(0.0, |joined| joined.largest_movement + joined.tolerance);
        let Ok(positions) = self.positions() else { return false };
        let Some(area) = polygon_area(&positions, self.surface.polygons()) else { return false };
        (after - before).abs() <= MOVED_VOLUME * area * moved
    }

    /// The number of vertices that were copied to split pinches.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.copy_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn copy_count(&self) -> usize {
        self.copies[0]
    }

    /// The volume of the selected cells, rounded; `None` if the exterior is among them.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.volume(), Some(1.0));
    /// # Ok(()) }
    /// ```
    pub fn volume(&self) -> Option<f64> {
        volume_of(self.arrangement, &self.selection)
    }

    /// Where the vertices of the surface are.
    ///
    /// # Errors
    /// None for arrangements that were made.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.positions()?.len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> Result<Positions, Error> {
        self.surface.positions(self.arrangement.arranged.drawn_positions())
    }

    /// The numbers of connected parts that are selected, solids, and of bounded ones that are not, voids. Cells are connected
    /// through faces.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.part_counts(), [1, 0], "one solid and no void");
    /// # Ok(()) }
    /// ```
    pub fn part_counts(&self) -> [usize; 2] {
        part_counts(&self.selection, &self.regions)
    }

    /// The result as an answer.
    ///
    /// `measure` is the volume, none if the exterior is in the result. `f_vector` counts vertices, edges and polygons of the surface;
    /// where faces are not cut into triangles those with holes count once. `components` are those of the surface, `solids` those of
    /// what it encloses. Pinches are listed by coordinates as they were before they were split.
    ///
    /// # Errors
    /// Those of [`Self::positions`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.answer()?.measure, Some(1.0));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> Result<SolidBooleanAnswer, Error> {
        let positions = self.positions()?;
        let survey = self.mesh().survey();
        let verdict = survey.verdict();
        let manifold = boundary_manifold(self.mesh(), verdict, &positions);
        let [solids, voids] = self.part_counts();
        let surface = survey.surface();
        let files = self.input_answers();
        let crossings = self.crossings()?;
        let turned = self.turned_parts()?;
        let remarks = self.arrangement.remarks(&files, self.request.rule, crossings, turned);
        Ok(SolidBooleanAnswer {
            dimension: 3,
            measure: self.volume(),
            f_vector: self.f_vector(),
            components: survey.components().count(),
            closed: verdict.boundary_edge_count() == 0,
            manifold,
            euler_characteristic: self.mesh().euler_characteristic(),
            genus: surface.map(|surface| surface.genus()),
            area: polygon_area(&positions, self.surface.polygons()),
            solids,
            voids,
            cells: match &self.arrangement.surface {
                Some(surface) => surface.cell_count,
                None => self.selection.cells().count(),
            },
            unbounded: self.selection.has_exterior(),
            triangles: self.request.triangles,
            faces_cut: self.faces_cut(),
            walls: if self.request.keep_walls { self.boundary.walls().len() } else { 0 },
            pinches: self.pinches(),
            rule: rule_word(self.request.rule).to_owned(),
            files,
            rounding: self.arrangement.rounding(self.closure()[0].iter().copied(), crossings, turned),
            joined: self.arrangement.joined(),
            congruence: None,
            remarks,
        })
    }

    /// The numbers of vertices, edges and faces of the surface, faces with holes once; of triangles if faces are cut.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.f_vector(), [4, 6, 4]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> [usize; 3] {
        if self.request.triangles {
            let mesh = self.mesh();
            return [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()];
        }
        let [vertices, edges, faces] = self.closure().map(|cells| cells.len());
        [vertices + self.copies[0], edges + self.copies[1], faces]
    }

    /// The vertices, edges and faces of the arrangement that are part of the surface.
    fn closure(&self) -> [Vec<CellId>; 3] {
        let complex = self.arrangement.complex();
        let faces: Vec<CellId> = self.boundary.facets().iter().map(|facet| facet.0).collect();
        let edges = facets_of(complex, 2, &faces);
        [facets_of(complex, 1, &edges), edges, faces]
    }

    /// The number of faces that are no polygon of a mesh, since they have holes or slits, and were cut into triangles.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// assert_eq!(same.faces_cut(), 0);
    /// # Ok(()) }
    /// ```
    pub fn faces_cut(&self) -> usize {
        if self.request.triangles {
            return 0;
        }
        let facets = self.surface.facets().chunk_by(|x, y| x.0 == y.0);
        facets.filter(|chunk| chunk.len() > 1).count()
    }

    /// The places where the result is pinched.
    fn pinches(&self) -> Pinches {
        Pinches {
            split: self.request.split_pinches,
            copies: self.copies[0],
            ..pinches(self.arrangement.complex(), self.arrangement.positions(), &self.boundary)
        }
    }

    fn input_answers(&self) -> Vec<SpatialInput> {
        let mut files = self.arrangement.input_answers();
        for (input, file) in files.iter_mut().enumerate() {
            file.inside_by = Some(match self.arrangement.input_state(input) {
                _ if self.arrangement.scene.mouth_edges(input).is_some() => InsideMethod::ClosedMouths,
                InputState::Incoherent { .. } => InsideMethod::Parity,
                _ => InsideMethod::Winding,
            });
        }
        files
    }
}

/// Refuses a formula with an input that is not there.
pub(super) fn check_formula(formula: &BooleanFormula, input_count: usize) -> Result<(), Error> {
    if formula.input_count() > input_count {
        return Err(Error::invalid(format!(
            "the formula names input {}, but there are {input_count} inputs, from 0",
            formula.input_count() - 1
        )));
    }
    Ok(())
}

/// Whether a surface is a manifold, with the places of a witness.
pub(super) fn boundary_manifold(
    mesh: &PolygonMesh,
    verdict: &SurfaceVerdict,
    positions: &Positions,
) -> BoundaryManifold {
    let place = |vertex: &u32| positions.point(VertexId::from_u32(*vertex)).to_vec();
    let witness = verdict.witness().map(|defect| {
        let found = witness(mesh, defect, &Labels::default());
        let cells = found.cells().to_vec();
        BoundaryWitness {
            kind: found.kind().to_owned(),
            points: Some(cells.iter().map(|cell| cell.iter().map(place).collect()).collect()),
            cells,
            message: found.message().to_owned(),
        }
    });
    BoundaryManifold {
        verdict: BoundaryVerdict::of(verdict.is_manifold()),
        closed: verdict.is_closed(),
        witness,
    }
}

/// Where a selection is pinched; nothing is split.
pub(super) fn pinches(
    complex: &ChainComplex,
    positions: &Positions,
    boundary: &SelectionBoundary,
) -> Pinches {
    let place = |vertex: u32| positions.point(VertexId::from_u32(vertex)).to_vec();
    let (edges, vertices) = (boundary.pinched_ridges(), boundary.pinched_vertices());
    let ends = |edge: &CellId| -> Vec<Vec<f64>> {
        let rows = complex.boundary_matrix(1).map_or(&[][..], |matrix| matrix.column(edge.index()).rows());
        rows.iter().map(|&vertex| place(vertex)).collect()
    };
    Pinches {
        edge_count: edges.len(),
        vertex_count: vertices.len(),
        edges: edges.iter().take(MOST_LISTED).map(ends).collect(),
        vertices: vertices.iter().take(MOST_LISTED).map(|v| place(v.to_u32())).collect(),
        split: false,
        copies: 0,
    }
}

/// The numbers of solids and of voids.
pub(super) fn part_counts(selection: &CellSelection, regions: &[u32]) -> [usize; 2] {
    let exterior = regions.len() - 1;
    let mut solids = Vec::new();
    let mut voids = Vec::new();
    for (cell, &region) in regions[..exterior].iter().enumerate() {
        match selection.contains(CellId::new(cell)) {
            true => solids.push(region),
            false if region != regions[exterior] => voids.push(region),
            false => {}
        }
    }
    [solids, voids].map(|mut list| {
        list.sort_unstable();
        list.dedup();
        list.len()
    })
}

/// The volume of the selected cells, rounded; `None` if the exterior is among them.
fn volume_of(arrangement: &SceneArrangement, selection: &CellSelection) -> Option<f64> {
    if selection.has_exterior() {
        return None;
    }
    let mut sum = Sum::default();
    let cells: Vec<CellId> = selection.cells().collect();
    arrangement.arranged.volumes_of(&cells).into_iter().for_each(|volume| sum.add(volume));
    Some(sum.value())
}

/// The cells behind and in front of each face.
pub(super) fn sides_of_faces(complex: &ChainComplex) -> Vec<[u32; 2]> {
    let mut sides = vec![[EXTERIOR; 2]; complex.cell_count(2)];
    if let Some(cells) = complex.boundary_matrix(3) {
        for (cell, column) in cells.columns().enumerate() {
            for (face, entry) in column.iter() {
                sides[face][usize::from(entry < 0)] = cell as u32;
            }
        }
    }
    sides
}

/// A corner of each solid and void that a surface does not have around it with its fronts outward. `sides` has the cells behind
/// and in front of each face, `regions` the part of each cell, that of the exterior last.
fn turned_of(
    surface: &SelectionMesh,
    positions: &Positions,
    sides: &[[u32; 2]],
    regions: &[u32],
) -> Vec<[f64; 3]> {
    let exterior = regions.len() - 1;
    let region = |cell: u32| {
        let own = regions[if cell == EXTERIOR { exterior } else { cell as usize }];
        if own == regions[exterior] { EXTERIOR } else { own }
    };
    turned_parts(positions, surface.polygons(), |polygon| {
        let (facet, sign) = surface.facets()[polygon];
        let [back, front] = sides[facet.index()].map(region);
        if sign == Sign::Plus { [back, front] } else { [front, back] }
    })
}

/// Whether rounding moved a vertex of each polygon of a surface.
fn rounded_polygons(arranged: &Arranged, surface: &SelectionMesh) -> Vec<bool> {
    let is_moved = arranged.rounded_vertices();
    let is_moved = |&vertex: &u32| is_moved[surface.vertex_sources()[vertex as usize].index()];
    surface.polygons().iter().map(|polygon| polygon.iter().any(is_moved)).collect()
}

/// How far points that rounding moved out of a plane or a line may be from it: both ways by a few units in the last place
/// of the largest coordinate, in each coordinate.
fn rounding_of(positions: &Positions, precision: CoordinatePrecision) -> f64 {
    8.0 * precision.unit() * positions.as_flat().iter().fold(0.0, |most: f64, x| x.abs().max(most))
}

/// For each new triangle the facets that its patch has triangles of, rising.
fn facets_of_patches(merged: &CoplanarTriangles, facets: &[(CellId, Sign)]) -> Vec<Vec<(CellId, Sign)>> {
    let own = |&patch: &u32| {
        let members = merged.patches.list(patch as usize).iter();
        let mut own: Vec<(CellId, Sign)> = members.map(|&triangle| facets[triangle as usize]).collect();
        own.sort_unstable();
        own.dedup();
        own
    };
    merged.patch_of_triangle.iter().map(own).collect()
}

/// The word for a rule in answers.
pub(super) fn rule_word(rule: InsideRule) -> &'static str {
    match rule {
        InsideRule::Nonzero => "nonzero",
        InsideRule::Positive => "positive",
        InsideRule::Odd => "evenodd",
    }
}

impl SceneArrangement {
    /// The polygons of these faces.
    pub(super) fn mesh_of(&self, facets: &[(CellId, Sign)], triangles: bool) -> Result<SelectionMesh, Error> {
        let add_pieces = |face: CellId, pieces: &mut Pieces| {
            if let Some(corners) = self.arranged.single_triangle(face) {
                pieces.polygons.push(&corners);
                pieces.counts.push(1);
                return Ok(());
            }
            if !triangles && !self.arranged.is_bent(face) {
                let walks = self.arranged.walks(face);
                if walks.len() == 1 && walks.list(0).len() >= 3 && repeated_vertex(walks.list(0)).is_none() {
                    pieces.polygons.push(walks.list(0));
                    pieces.counts.push(1);
                    return Ok(());
                }
            }
            let own = self.arranged.triangles(face)?;
            own.iter().for_each(|triangle| pieces.polygons.push(triangle));
            pieces.counts.push(own.len() as u32);
            Ok::<_, Error>(())
        };
        let pieces_of = |facets: &[(CellId, Sign)]| {
            let mut pieces = Pieces::default();
            facets.iter().try_for_each(|&(face, _)| add_pieces(face, &mut pieces))?;
            Ok(pieces)
        };
        let pieces: Vec<Result<Pieces, Error>> = facets.par_chunks(CHUNK).map(pieces_of).collect();
        let pieces: Vec<Pieces> = pieces.into_iter().collect::<Result<_, _>>()?;
        let counts = pieces.iter().flat_map(|pieces| &pieces.counts);
        let own = facets.iter().zip(counts).flat_map(|(&facet, &count)| (0..count).map(move |_| facet));
        let polygons = pieces.iter().flat_map(|pieces| pieces.polygons.iter());
        Ok(SelectionMesh::of_pieces(own.zip(polygons)))
    }

    /// The cells behind and in front of each face.
    pub(super) fn sides_of_faces(&self) -> Vec<[u32; 2]> {
        sides_of_faces(self.complex())
    }
}

/// The polygons of some faces, one face after the other.
#[derive(Default)]
struct Pieces {
    polygons: RaggedArray,
    /// How many there are of each face.
    counts: Vec<u32>,
}

fn mesh_on(surface: &SelectionMesh) -> PolygonMesh {
    PolygonMesh::new(surface.vertex_sources().len(), surface.polygons().clone(), &[])
        .expect("polygons on vertices of the surface that repeat none, with fewer than 2^30 corners")
}

/// The facets of cells of one degree, rising.
pub(super) fn facets_of(complex: &ChainComplex, degree: usize, cells: &[CellId]) -> Vec<CellId> {
    let Some(matrix) = complex.boundary_matrix(degree) else { return Vec::new() };
    let mut facets: Vec<CellId> = cells
        .iter()
        .flat_map(|cell| matrix.column(cell.index()).rows())
        .map(|&facet| CellId::from_u32(facet))
        .collect();
    facets.sort_unstable();
    facets.dedup();
    facets
}

/// The connected parts of the selection and of the rest, by cells that have a face in common; the exterior is the last cell.
pub(super) fn regions(selection: &CellSelection, sides: &[[u32; 2]], cell_count: usize) -> Vec<u32> {
    let mut parts = UnionFind::new(cell_count + 1);
    let number = |cell: u32| if cell == EXTERIOR { cell_count as u32 } else { cell };
    let is_in = |cell: u32| match cell {
        EXTERIOR => selection.has_exterior(),
        _ => selection.contains(CellId::from_u32(cell)),
    };
    for &[back, front] in sides {
        if is_in(back) == is_in(front) {
            parts.unite(number(back), number(front));
        }
    }
    parts.class_numbers()
}

/// Refuses what is no result in space.
pub(super) fn refuse_unbounded(result: &SolidBoolean<'_>) -> Result<(), Error> {
    refuse_exterior(result.selection())
}

/// Refuses a selection with the exterior.
pub(super) fn refuse_exterior(selection: &CellSelection) -> Result<(), Error> {
    if selection.has_exterior() {
        return Err(Error::new(
            ErrorKind::UnsupportedFormat,
            "the result contains the exterior, which is no cell of a complex",
        )
        .with_cure("write its surface as a mesh, or intersect it with a solid"));
    }
    Ok(())
}
