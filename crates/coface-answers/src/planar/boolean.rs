//! Formulas of regions.

use super::ArrangementMethod;
use super::arrangement::Parts;
use super::containment::{Containment, ContainmentSearch};
use super::crossings::{MOST_PLACES, crossed_rings, crossing_remark, refuse_crossings};
use super::crowd::{Crowd, Leaving};
use super::drawing::PlanarDrawing;
use super::exact::SelectedFaces;
use super::outcome::Outcome;
use super::settling::{Movement, Placing};
use super::walks::Walks;
use crate::answer::{
    BoundaryManifold, BoundaryVerdict, BoundaryWitness, CongruentPieces, EdgeOrigin, JoinedFeatures,
    PlanarBooleanAnswer, PlanarBooleanProvenance, PolygonRounding, Remark, RemarkCode,
};
use coface_algebra::{EdgeId, Error, FaceId, RaggedArray, VertexId};
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_arrange::planar::{PlanarOptions, PlanarOverlay, Step};
use coface_geometry::{Positions, Sum};

/// How regions are combined.
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct BooleanRequest {
    /// Which winding numbers are inside, as in [`ArrangementRequest::rule`](crate::ArrangementRequest::rule).
    pub rule: Option<InsideRule>,
    /// Refuse rings that cross themselves if neither the request nor the drawing states a rule.
    pub strict: bool,
    /// Keep the edges between faces that are selected both: then each face is a polygon.
    pub keep_walls: bool,
    /// Round coordinates of the inputs' arrangement and arrange again until all vertices are where their coordinates say.
    pub snap: bool,
    /// Put all vertices on the grid with this step: their coordinates are multiples of it.
    pub grid: Option<f64>,
    /// Put vertices and edges together that are at most this far apart, in the unit of the inputs.
    pub tolerance: Option<f64>,
    /// How cells are found. By congruence a tolerance is taken from the extent of the drawing where none is given.
    pub method: ArrangementMethod,
    /// Keep the result as it is, where rounding its coordinates makes polygons invalid. Else edges are cut and bent there by
    /// a few units of the last digit, and polygons that come to share an edge become one.
    pub exact: bool,
    /// The most vertices, edges and faces of the arrangement together.
    pub max_cells: Option<usize>,
}

/// The set that a formula of regions describes, as polygons with holes.
///
/// Outer rings run counterclockwise and holes clockwise; each ring is simple, and the points inside of each polygon are connected.
/// Where regions only touch, their corners leave no trace: a vertex at which two sides go on straight along one segment is
/// none of the result.
///
/// # Examples
/// Two rectangles side by side, and a square around the middle of what they share. Corners of both stay, though sides go straight on.
/// ```
/// use coface_arrange::boolean::BooleanFormula;
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let a = io::read(&b"POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))"[..], Format::Wkt)?;
/// let b = io::read(&b"POLYGON ((2 0, 4 0, 4 1, 2 1, 2 0))"[..], Format::Wkt)?;
/// let c = io::read(&b"POLYGON ((1.5 0.25, 2.5 0.25, 2.5 0.75, 1.5 0.75, 1.5 0.25))"[..], Format::Wkt)?;
/// let drawing = PlanarDrawing::new([("a", &a), ("b", &b), ("c", &c)], RegionSource::Models)?;
/// let formula = BooleanFormula::parse("(a | b) - c", &[])?;
/// let result = RegionBoolean::new(drawing, &formula, &BooleanRequest::default())?;
/// assert_eq!((result.f_vector(), result.hole_count(), result.area()), ([10, 10, 1], 1, 3.5));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct RegionBoolean {
    pub(super) drawing: PlanarDrawing,
    pub(super) found: Outcome,
    /// What moved so that rounded coordinates are valid, if that was needed.
    movement: Option<Movement>,
    /// Whether vertices were put elsewhere as it was asked for.
    is_placed: bool,
    /// Whether files keep exact points.
    pub(super) keeps_exact: bool,
    /// The vertices, edges and faces that the rings cut the plane into.
    cell_counts: [usize; 3],
    snap_rounds: Option<usize>,
    /// What was put together within a tolerance.
    joined: Option<JoinedFeatures>,
    /// What congruence glued.
    congruence: Option<CongruentPieces>,
    /// What was combined; none where faces were chosen one by one.
    pub(super) formula: Option<BooleanFormula>,
    pub(super) rule: Option<InsideRule>,
    warnings: Vec<String>,
    remarks: Vec<Remark>,
}

impl RegionBoolean {
    /// Combines the regions of a drawing, which are the inputs of the formula in their order.
    ///
    /// # Errors
    /// [`ErrorKind::NotACycle`](coface_algebra::ErrorKind::NotACycle) naming where lines end that should bound a region; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming the crossing
    /// of a ring with itself if the request is strict, an input of the formula that is not there, or a formula that holds outside of all regions;
    /// those of [`DrawingArrangement::new`](crate::DrawingArrangement::new).
    ///
    /// # Complexity
    /// That of the arrangement, and the faces times the length of the formula.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!((rest.area(), rest.hole_count()), (8.0, 1));
    /// # Ok(()) }
    /// ```
    pub fn new(
        drawing: PlanarDrawing,
        formula: &BooleanFormula,
        request: &BooleanRequest,
    ) -> Result<Self, Error> {
        Self::leaving_out(drawing, formula, request, Leaving::default())
    }

    /// The same, with parts of rings left out as is said.
    pub(super) fn leaving_out(
        drawing: PlanarDrawing,
        formula: &BooleanFormula,
        request: &BooleanRequest,
        leaving: Leaving,
    ) -> Result<Self, Error> {
        drawing.check_regions()?;
        let region_count = drawing.regions.len();
        if formula.input_count() > region_count {
            return Err(Error::invalid(format!(
                "the formula names input {}, but there are {region_count}, numbered from 0",
                formula.input_count() - 1
            ))
            .with_cure("name inputs that are there, or give more of them"));
        }
        if formula.evaluate(|_| false) {
            return Err(Error::invalid(
                "the formula holds outside of all regions, so the result has no bounds",
            )
            .with_cure("take the complement within a region, as in \"a - b\""));
        }
        let options = PlanarOptions::new().max_cells(request.max_cells);
        let placing = Placing {
            snap: request.snap,
            grid: request.grid,
            tolerance: request.tolerance,
            method: request.method,
        };
        let placed = if placing.is_asked() { Some(placing.of(&drawing.arrange(&options)?)?) } else { None };
        let snapped = placed.as_ref().map(|placed| &placed.snapped);
        let walks = Walks::new(&drawing, snapped);
        let is_drawn_exactly = !drawing.exact.is_empty();
        let crowd = if snapped.is_some() || request.keep_walls || is_drawn_exactly {
            None
        } else {
            Crowd::new(&drawing, &walks, formula, request.rule, &options, leaving)?
        };
        let Reading { mut found, cell_counts, containment, crossings } = match crowd {
            Some(crowd) => Reading::of_crowd(crowd, &drawing, request)?,
            None if is_drawn_exactly && snapped.is_none() => {
                Reading::of_exact(&drawing, formula, request, &options)?
            }
            None => Reading::new(&drawing, &walks, formula, request, snapped.is_some(), &options)?,
        };
        let odd = containment.as_ref();
        let warnings = odd.map_or_else(Vec::new, |containment| containment.warnings(&drawing));
        let odd = odd.map_or_else(Vec::new, |containment| containment.remarks(&drawing));
        let mut remarks: Vec<Remark> = crossings.into_iter().chain(odd).collect();
        drop(walks);
        let (mut snap_rounds, mut joined, mut congruence) = (None, None, None);
        let is_placed = placed.as_ref().is_some_and(|placed| placed.snapped.round_count() > 0);
        if let Some(placed) = placed {
            remarks.extend(placed.remarks);
            (snap_rounds, joined, congruence) = (placed.snap_rounds, placed.joined, placed.congruence);
        }
        let mut movement = None;
        if (!found.is_valid || found.is_turned) && !request.exact {
            let (valid, settled) = found.settled()?;
            (found, movement) = (valid, Some(settled.movement));
        }
        let (formula, rule) = (Some(formula.clone()), request.rule);
        Ok(Self {
            drawing,
            found,
            movement,
            is_placed,
            keeps_exact: request.exact,
            cell_counts,
            snap_rounds,
            joined,
            congruence,
            formula,
            rule,
            warnings,
            remarks,
        })
    }

    /// The faces that are chosen in the overlay of all rings, of which the unbounded one comes last and is never chosen.
    pub(super) fn of_faces(
        drawing: PlanarDrawing,
        choose: impl FnOnce(&PlanarOverlay) -> Vec<bool>,
    ) -> Result<Self, Error> {
        let walks = Walks::new(&drawing, None);
        let overlay = walks.overlay(&PlanarOptions::default())?;
        let selected = choose(&overlay);
        let nothing = RaggedArray::from_lists(vec![[0u32; 0]; overlay.face_count()]);
        let mut found = Outcome::new(
            &overlay,
            &selected,
            false,
            |source| walks.source(source),
            |side| [walks.segment(side)],
            [&nothing, &nothing],
        )?;
        let cell_counts = overlay.f_vector();
        drop(overlay);
        drop(walks);
        let mut movement = None;
        if !found.is_valid || found.is_turned {
            let (valid, settled) = found.settled()?;
            (found, movement) = (valid, Some(settled.movement));
        }
        Ok(Self {
            drawing,
            found,
            movement,
            is_placed: false,
            keeps_exact: false,
            cell_counts,
            snap_rounds: None,
            joined: None,
            congruence: None,
            formula: None,
            rule: None,
            warnings: Vec::new(),
            remarks: Vec::new(),
        })
    }

    /// What moved so that rounded coordinates are valid, if that was needed.
    pub(super) fn movement(&self) -> Option<&Movement> {
        self.movement.as_ref()
    }

    /// Whether vertices are not where the drawing has them.
    pub(super) fn is_moved(&self) -> bool {
        self.is_placed || self.movement.is_some()
    }

    /// The drawing that was combined.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide)], RegionSource::Models)?;
    /// let same = RegionBoolean::new(drawing, &BooleanFormula::union(1), &BooleanRequest::default())?;
    /// assert_eq!(same.drawing().names(), ["wide"]);
    /// # Ok(()) }
    /// ```
    pub fn drawing(&self) -> &PlanarDrawing {
        &self.drawing
    }

    /// The numbers of vertices, edges and polygons of the result.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(rest.f_vector(), [8, 8, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> [usize; 3] {
        [self.found.positions.len(), self.found.edges.len(), self.found.outline.polygon_count()]
    }

    /// The area, in the square of the unit of the drawing.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(rest.area(), 9.0 - 1.0);
    /// # Ok(()) }
    /// ```
    pub fn area(&self) -> f64 {
        let mut sum = Sum::default();
        self.found.areas.iter().for_each(|&area| sum.add(area));
        sum.value()
    }

    /// The areas of the polygons.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(rest.polygon_areas(), [8.0]);
    /// # Ok(()) }
    /// ```
    pub fn polygon_areas(&self) -> &[f64] {
        &self.found.areas
    }

    /// The number of parts whose inner points are connected. Parts that touch in points only are different ones.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(rest.component_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn component_count(&self) -> usize {
        self.found.component_count
    }

    /// The number of holes.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(rest.hole_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn hole_count(&self) -> usize {
        self.found.outline.hole_count()
    }

    /// The positions of the vertices of the result: each coordinate is the floating-point number nearest to the exact one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(rest.positions().len(), 8);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.found.positions
    }

    /// The rings of a polygon by their vertices: the outer one, counterclockwise, then the holes, clockwise. Each is simple.
    ///
    /// # Panics
    /// If there is no such polygon.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::FaceId;
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(rest.rings_of_polygon(FaceId::new(0)).len(), 2, "the outer ring and the hole");
    /// # Ok(()) }
    /// ```
    pub fn rings_of_polygon(&self, polygon: FaceId) -> impl ExactSizeIterator<Item = &[u32]> {
        self.found.outline.rings_of(polygon.index())
    }

    /// The edges of the result by their vertices, the lower first.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(rest.edges().len(), 8);
    /// # Ok(()) }
    /// ```
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.found.edges
    }

    /// The segments of the drawing along an edge of the result, rising.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::EdgeId;
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(rest.segments_of_edge(EdgeId::new(0)).len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn segments_of_edge(&self, edge: EdgeId) -> &[u32] {
        self.found.segments_of_edge.list(edge.index())
    }

    /// The regions that contain some of a polygon, rising.
    ///
    /// # Panics
    /// If there is no such polygon.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::FaceId;
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(rest.regions_of_polygon(FaceId::new(0)), [0]);
    /// # Ok(()) }
    /// ```
    pub fn regions_of_polygon(&self, polygon: FaceId) -> &[u32] {
        self.found.regions_of_polygon.list(polygon.index())
    }

    /// The vertices at which the boundary is no curve: more than two of its edges meet there.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert!(rest.pinches().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn pinches(&self) -> &[VertexId] {
        &self.found.pinches
    }

    /// What is odd about the inputs, each with the name of a model: holes that are not inside of their outer rings.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert!(rest.warnings().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Whether the polygons are valid with their rounded coordinates, as one multipolygon: see
    /// [`are_valid_polygons`](coface_arrange::planar::are_valid_polygons). Always so unless the result is kept as it is.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert!(rest.is_valid_when_rounded());
    /// # Ok(()) }
    /// ```
    pub fn is_valid_when_rounded(&self) -> bool {
        self.found.is_valid
    }

    /// The result as an answer.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!((rest.answer().measure, rest.answer().holes), (8.0, 1));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> PlanarBooleanAnswer {
        let witness = self.found.pinches.first().map(|&vertex| {
            let [x, y] = [self.found.positions.point(vertex)[0], self.found.positions.point(vertex)[1]];
            BoundaryWitness {
                kind: "pinched_vertex".to_owned(),
                cells: vec![vec![vertex.to_u32()]],
                message: format!(
                    "more than two edges of the boundary meet at vertex {} at ({x}, {y})",
                    vertex.index()
                ),
                points: None,
            }
        });
        let mut remarks = self.drawing.remarks.clone();
        remarks.extend(self.drawing.remarks_of_lines(self.rule, true));
        remarks.extend(self.remarks.iter().cloned());
        if !self.found.is_valid {
            remarks.push(Remark::new(
                RemarkCode::RoundedInvalid,
                "coordinates are rounded, and with them the polygons are not valid; without --exact they are made valid",
            ));
        }
        remarks.extend(self.movement.map(|movement| movement.remark("polygon")));
        let movement = self.movement.unwrap_or_default();
        PlanarBooleanAnswer {
            dimension: 2,
            measure: self.area(),
            f_vector: self.f_vector(),
            components: self.found.component_count,
            closed: true,
            manifold: BoundaryManifold {
                verdict: BoundaryVerdict::of(self.found.pinches.is_empty()),
                closed: true,
                witness,
            },
            polygons: self.found.outline.polygon_count(),
            holes: self.hole_count(),
            measures: self.found.areas.clone(),
            pinches: self.found.pinches.len(),
            rounding: PolygonRounding {
                exact: self.found.is_exact,
                valid: self.found.is_valid,
                repair: movement.answer(),
            },
            snap_rounds: self.snap_rounds,
            joined: self.joined.clone(),
            congruence: self.congruence.clone(),
            arrangement: self.cell_counts,
            regions: self.drawing.region_names().into_iter().map(str::to_owned).collect(),
            inputs: self.drawing.input_answers(),
            warnings: self.warnings.clone(),
            remarks,
        }
    }

    /// Where everything comes from: as [`DrawingArrangement::provenance`](crate::DrawingArrangement::provenance), edges with
    /// their ends, and for each polygon the regions that contain some of it.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(rest.provenance().inputs, ["wide", "hole"]);
    /// # Ok(()) }
    /// ```
    pub fn provenance(&self) -> PlanarBooleanProvenance {
        let drawing = &self.drawing;
        let edge = |(&ends, segments): (&[u32; 2], &[u32])| EdgeOrigin {
            ends,
            segments: segments.iter().map(|&segment| drawing.segment_source(segment as usize)).collect(),
        };
        PlanarBooleanProvenance {
            inputs: drawing.names.clone(),
            regions: drawing.region_names().into_iter().map(str::to_owned).collect(),
            vertices: self.found.sources.iter().map(|source| drawing.vertex_origin(source)).collect(),
            edges: self.found.edges.iter().zip(self.found.segments_of_edge.iter()).map(edge).collect(),
            polygons: self.found.regions_of_polygon.iter().map(<[u32]>::to_vec).collect(),
        }
    }
}

/// What is read off an overlay.
struct Reading {
    found: Outcome,
    cell_counts: [usize; 3],
    /// What is odd about rings, if anything may be.
    containment: Option<Containment>,
    crossings: Option<Remark>,
}

impl Reading {
    /// From all rings laid over each other.
    fn new(
        drawing: &PlanarDrawing,
        walks: &Walks<'_>,
        formula: &BooleanFormula,
        request: &BooleanRequest,
        is_snapped: bool,
        options: &PlanarOptions,
    ) -> Result<Self, Error> {
        let overlay = walks.overlay(options)?;
        let containment = containment(drawing, &overlay, request.rule);
        let crossings = match (request.rule, is_snapped) {
            (Some(_), _) => None,
            (None, false) => crossings(drawing, &overlay, &containment, request.strict)?,
            // Rings that rounding turns inside out somewhere do not cross themselves as they were drawn.
            (None, true) if crossed_rings(drawing, &containment.windings).is_empty() => None,
            (None, true) if !drawing.exact.is_empty() => {
                exact_crossings(drawing, &Parts::of(drawing.arrange(options)?), request.strict)?
            }
            (None, true) => {
                let overlay = Walks::new(drawing, None).overlay(options)?;
                let containment = self::containment(drawing, &overlay, request.rule);
                crossings(drawing, &overlay, &containment, request.strict)?
            }
        };
        let mut selected = selected(drawing, &containment, formula, overlay.face_count());
        selected.push(false);
        let found = Outcome::new(
            &overlay,
            &selected,
            request.keep_walls,
            |source| walks.source(source),
            |side| [walks.segment(side)],
            [&containment.regions, &containment.features],
        )?;
        Ok(Self { found, cell_counts: overlay.f_vector(), containment: Some(containment), crossings })
    }

    /// The same by an arrangement, for drawings some of which are known exactly.
    fn of_exact(
        drawing: &PlanarDrawing,
        formula: &BooleanFormula,
        request: &BooleanRequest,
        options: &PlanarOptions,
    ) -> Result<Self, Error> {
        let parts = Parts::of(drawing.arrange(options)?);
        let containment = parts.containment(drawing, request.rule, true);
        let crossings = match request.rule {
            Some(_) => None,
            None => exact_crossings(drawing, &parts, request.strict)?,
        };
        let arrangement = &parts.arrangement;
        let selected = selected(drawing, &containment, formula, arrangement.face_count());
        let faces = SelectedFaces::new(arrangement, &selected, request.keep_walls);
        let of_faces = [&containment.regions, &containment.features];
        let found = Outcome::of_faces(&parts, faces, request.keep_walls, of_faces)?;
        let cell_counts = [arrangement.vertex_count(), arrangement.edge_count(), arrangement.face_count()];
        Ok(Self { found, cell_counts, containment: Some(containment), crossings })
    }

    /// From the parts of rings that matter.
    fn of_crowd(crowd: Crowd, drawing: &PlanarDrawing, request: &BooleanRequest) -> Result<Self, Error> {
        let Crowd { found, cell_counts, invalid } = crowd;
        let crossings = match (&invalid, request.rule) {
            (Some((overlay, containment)), None) => crossings(drawing, overlay, containment, request.strict)?,
            _ => None,
        };
        Ok(Self { found, cell_counts, containment: invalid.map(|(_, containment)| containment), crossings })
    }
}

/// The regions around the faces of an overlay in which rings are regions.
pub(super) fn containment(
    drawing: &PlanarDrawing,
    overlay: &PlanarOverlay,
    rule: Option<InsideRule>,
) -> Containment {
    let mut search = ContainmentSearch::new(drawing, rule, overlay.face_count());
    overlay.tour(|step| match step {
        Step::Into { face, across } => {
            overlay.across(across, |ring, by| search.wind(ring, by));
            search.enter(face);
        }
        Step::Back { across, .. } => overlay.across(across, |ring, by| search.wind(ring, by)),
    });
    search.finish()
}

/// The remark on rings that cross themselves.
///
/// # Errors
/// `InvalidInput` naming the crossing if the request is strict and the drawing states no rule.
fn crossings(
    drawing: &PlanarDrawing,
    overlay: &PlanarOverlay,
    containment: &Containment,
    is_strict: bool,
) -> Result<Option<Remark>, Error> {
    let crossings = crossed_rings(drawing, &containment.windings);
    let places = |ring: u32| {
        let points = overlay.meetings_of(ring, MOST_PLACES);
        points.iter().map(|point| point.rounded()).collect::<Vec<[f64; 2]>>()
    };
    if is_strict {
        refuse_crossings(drawing, &crossings, places)?;
    }
    Ok(crossing_remark(drawing, &crossings, places))
}

/// Whether a formula holds in each face.
fn selected(
    drawing: &PlanarDrawing,
    containment: &Containment,
    formula: &BooleanFormula,
    face_count: usize,
) -> Vec<bool> {
    let mut is_inside = vec![false; drawing.regions.len()];
    let mut select = |face: usize| {
        let regions = containment.regions.list(face);
        regions.iter().for_each(|&region| is_inside[region as usize] = true);
        let is_selected = formula.evaluate(|input| is_inside[input]);
        regions.iter().for_each(|&region| is_inside[region as usize] = false);
        is_selected
    };
    (0..face_count).map(&mut select).collect()
}

/// As [`crossings`], by an arrangement.
fn exact_crossings(drawing: &PlanarDrawing, parts: &Parts, is_strict: bool) -> Result<Option<Remark>, Error> {
    let crossings = crossed_rings(drawing, &parts.containment(drawing, None, true).windings);
    let places = |ring: u32| parts.meetings_of(drawing, ring);
    if is_strict {
        refuse_crossings(drawing, &crossings, places)?;
    }
    Ok(crossing_remark(drawing, &crossings, places))
}
