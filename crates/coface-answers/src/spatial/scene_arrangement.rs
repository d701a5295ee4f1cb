//! A scene arranged: its cells, and what they are inside of.

use super::arranged::Arranged;
use super::cascade::Operands;
use super::coarse::refuse_other_cells;
use super::enclosed::turned_parts;
use super::facts::{
    component_count, dangling_face_count, input_answers, input_state, products_are_zero, remarks_of_inputs,
    remarks_of_vanished,
};
use super::inputs::{Inputs, Membership};
use super::solid_request::surface_alone;
use super::{InputState, OpenInputs, SolidBoolean, SolidRequest, SpatialRequest, SpatialScene};
use crate::answer::{
    DegeneratePolygons, JoinedFeatures, Place, Remark, RemarkCode, SpatialArrangementAnswer, SpatialInput,
    SpatialRounding, SplitPolygons,
};
use crate::near::ThinCells;
use crate::text;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind, Sign};
use coface_arrange::CoordinatePrecision;
use coface_arrange::boolean::{CellSelection, InsideRule};
use coface_arrange::spatial::{Crossings, SplitPolygon};
use coface_geometry::{Positions, cross, dot};
use coface_io::Model;
use std::sync::OnceLock;

/// So many polygons of a sort are listed.
const MOST_LISTED: usize = 100;

/// The cells that the polygons of models cut space into.
///
/// # Examples
/// Two tetrahedra on a common face:
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_answers::{SceneArrangement, SpatialRequest};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let read = |top: &str| {
///     let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nv {top}\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
///     io::read(text.as_bytes(), Format::Obj)
/// };
/// let (up, down) = (read("0 0 6")?, read("0 0 -12")?);
/// let scene = SceneArrangement::of([("up", &up), ("down", &down)], &SpatialRequest::default())?;
/// assert_eq!(scene.complex().f_vector(), [5, 9, 7, 2]);
/// let answer = scene.answer(Default::default())?;
/// // The second is listed inside out: it winds -1 times around what it encloses.
/// assert_eq!(answer.files[1].reversed_cells, 1);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct SceneArrangement {
    pub(super) scene: SpatialScene,
    pub(super) arranged: Arranged,
    pub(super) inputs: Inputs,
    pub(super) request: SpatialRequest,
    /// The number of cells without putting anything together, where that was done.
    cells_apart: Option<usize>,
    /// What is said of thin cells of the arrangement before anything was put together to make rounding valid.
    thin_apart: Option<Remark>,
    /// What coordinates of 32 bits were rounded from.
    pub(super) unrounded: Option<Box<Self>>,
    crossings: OnceLock<Crossings>,
    /// What it is of, where it is the surface of a result alone.
    pub(super) surface: Option<Box<ResultSurface>>,
}

/// A result of which only what its surface needs is arranged.
#[derive(Clone, Debug)]
pub(super) struct ResultSurface {
    pub(super) request: SolidRequest,
    /// The cells within the surface.
    pub(super) selection: CellSelection,
    /// How many cells are within it of the arrangement that it is from.
    pub(super) cell_count: usize,
    /// What is left of the formula, where operands were combined some at a time and the last ones are arranged; none where it is the
    /// surface of a result that was arranged before, with rounded coordinates.
    pub(super) operands: Option<Operands>,
}

impl SceneArrangement {
    /// Arranges all polygons of these models, faces between cells of a volume mesh included.
    ///
    /// # Errors
    /// Those of [`SpatialScene::of`]; naming polygons that are not flat or cross themselves, and what the request refuses.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.complex().f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn of<'a>(
        models: impl IntoIterator<Item = (&'a str, &'a Model)>,
        request: &SpatialRequest,
    ) -> Result<Self, Error> {
        Self::of_scene(SpatialScene::of(models, true)?, request)
    }

    /// Arranges the polygons of a scene.
    ///
    /// # Errors
    /// As [`Self::of`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// assert_eq!(SceneArrangement::of_scene(scene, &SpatialRequest::default())?.volumes(), arranged.volumes());
    /// # Ok(()) }
    /// ```
    pub fn of_scene(scene: SpatialScene, request: &SpatialRequest) -> Result<Self, Error> {
        if request.snap && request.precision != CoordinatePrecision::Double {
            let exact = Self::of_scene(scene, &SpatialRequest { snap: false, ..*request })?;
            let rounded = exact.snapped()?;
            return Ok(Self { request: *request, thin_apart: None, ..rounded });
        }
        let arranged = Arranged::new(&scene, request)?;
        let inputs = Inputs::new(&scene, &arranged)?;
        let cells_apart = request.tolerance.and_then(|_| {
            let apart = Arranged::new(&scene, &SpatialRequest { tolerance: None, snap: false, ..*request });
            apart.ok().map(|apart| apart.complex().cell_count(3))
        });
        let (request, crossings) = (*request, OnceLock::new());
        let (thin_apart, unrounded) = (None, None);
        let surface = None;
        Ok(Self { scene, arranged, inputs, request, cells_apart, thin_apart, unrounded, crossings, surface })
    }

    /// The same scene with coordinates that are exactly where they are rounded to: features that rounding would make
    /// cross are put together.
    ///
    /// # Errors
    /// As [`SpatialArrangement::snapped`](coface_arrange::spatial::SpatialArrangement::snapped).
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.snapped()?.volumes(), [1.0]);
    /// # Ok(()) }
    /// ```
    pub fn snapped(&self) -> Result<Self, Error> {
        if let Some(surface) = &self.surface {
            // A surface alone has been snapped.
            let operands = surface.operands.as_ref();
            return operands.map_or_else(|| Ok(self.clone()), |own| self.snapped_operands(surface, own));
        }
        let arranged = match self.arranged.snapped(&self.scene, &self.request) {
            Err(error)
                if error.kind() == ErrorKind::InvalidInput
                    && self.request.precision == CoordinatePrecision::Double =>
            {
                Arranged::within_rounding(&self.scene, &self.request)?.ok_or(error)?
            }
            other => other?,
        };
        let inputs = Inputs::new(&self.scene, &arranged)?;
        let cells_apart = self.cells_apart.or(Some(self.complex().cell_count(3)));
        let thin_apart = self.thin_cells();
        let unrounded = self.unrounded_of_single();
        let (scene, request, crossings) = (self.scene.clone(), self.request, OnceLock::new());
        let surface = None;
        Ok(Self { scene, arranged, inputs, request, cells_apart, thin_apart, unrounded, crossings, surface })
    }

    /// The same scene [snapped](Self::snapped) so that its rounded coordinates are valid; none where no distance within
    /// reach does that. With numbers of 32 bits coordinates are then the nearest ones, and [`Self::crossings`] tells where that is not
    /// valid.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for more cells than the request takes; [`ErrorKind::UnsupportedFormat`] where numbers of 32 bits are too
    /// coarse for the scene.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let valid = arranged.validly_rounded()?.expect("its coordinates are exact as they are");
    /// assert_eq!(valid.crossings()?.count, 0);
    /// # Ok(()) }
    /// ```
    pub fn validly_rounded(&self) -> Result<Option<Self>, Error> {
        match self.snapped() {
            Err(error) if matches!(error.kind(), ErrorKind::InvalidInput | ErrorKind::NotACycle) => {
                match self.request.precision {
                    CoordinatePrecision::Double => Ok(None),
                    CoordinatePrecision::Single => self.coarsely_rounded().map(Some),
                }
            }
            other => other.map(Some),
        }
    }

    /// The same with the nearest numbers of 32 bits as coordinates: nothing is put together, and faces may cross.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] where these are too coarse.
    fn coarsely_rounded(&self) -> Result<Self, Error> {
        let arranged = self.arranged.coarsely_rounded(self.request.precision)?;
        let unrounded = self.unrounded_of_single();
        Ok(Self { arranged, unrounded, crossings: OnceLock::new(), ..self.clone() })
    }

    /// What numbers of 32 bits are compared with: this arrangement, or what it was made of.
    fn unrounded_of_single(&self) -> Option<Box<Self>> {
        match self.request.precision {
            CoordinatePrecision::Double => None,
            CoordinatePrecision::Single => {
                Some(self.unrounded.clone().unwrap_or_else(|| Box::new(self.clone())))
            }
        }
    }

    /// The surface around some cells alone with rounded coordinates that are valid; the inputs are those of the whole
    /// arrangement.
    pub(super) fn snapped_surface(&self, result: &SolidBoolean<'_>) -> Result<Self, Error> {
        let (surface, exterior) = (result.boundary.facets(), result.selection.has_exterior());
        let (arranged, selection) =
            self.arranged.snapped_surface(&self.scene, &self.request, surface, exterior)?;
        let cell_count = result.selection.cells().count();
        let surface =
            ResultSurface { request: result.request.clone(), selection, cell_count, operands: None };
        let cells_apart = Some(arranged.complex().cell_count(3));
        let own = Self::of_surface(self.scene.clone(), arranged, self.inputs.clone(), self.request, surface);
        Ok(Self { cells_apart, thin_apart: self.thin_cells(), ..own })
    }

    /// The last operands of a combination with rounded coordinates that are valid.
    fn snapped_operands(&self, surface: &ResultSurface, operands: &Operands) -> Result<Self, Error> {
        let (arranged, chains) = self.arranged.snapped_operands(&self.request)?;
        let selection = operands.selection_of(arranged.complex(), &chains, surface.request.rule)?;
        let surface = ResultSurface { selection, operands: None, ..surface.clone() };
        let own = Self::of_surface(self.scene.clone(), arranged, self.inputs.clone(), self.request, surface);
        Ok(Self { cells_apart: Some(self.complex().cell_count(3)), thin_apart: self.thin_cells(), ..own })
    }

    /// What the surface of a result needs.
    pub(super) fn of_surface(
        scene: SpatialScene,
        arranged: Arranged,
        inputs: Inputs,
        request: SpatialRequest,
        surface: ResultSurface,
    ) -> Self {
        let (cells_apart, thin_apart, unrounded) = (None, None, None);
        let (surface, crossings) = (Some(Box::new(surface)), OnceLock::new());
        Self { scene, arranged, inputs, request, cells_apart, thin_apart, unrounded, crossings, surface }
    }

    /// A corner of each cell that rounding of coordinates made flat or turned inside out; decided exactly for the triangles
    /// that faces are drawn with.
    ///
    /// # Errors
    /// None for arrangements that were made.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = coface_answers::SceneArrangement::of([("solid", &solid)], &Default::default())?;
    /// assert!(arranged.turned_cells()?.is_empty());
    /// # Ok(()) }
    /// ```
    pub fn turned_cells(&self) -> Result<Vec<[f64; 3]>, Error> {
        if self.arranged.is_exactly_rounded() {
            return Ok(Vec::new());
        }
        let faces: Vec<(CellId, Sign)> =
            (0..self.complex().cell_count(2)).map(|face| (CellId::new(face), Sign::Plus)).collect();
        let mesh = self.mesh_of(&faces, true)?;
        let sides = self.sides_of_faces();
        let positions = mesh.positions(self.arranged.drawn_positions())?;
        Ok(turned_parts(&positions, mesh.polygons(), |polygon| sides[mesh.facets()[polygon].0.index()]))
    }

    /// Whether rounded coordinates are a valid arrangement: faces meet in common vertices and edges alone, no cell is
    /// flat or inside out, and coordinates are numbers of the precision that the request asks for.
    ///
    /// # Errors
    /// None for arrangements that were made.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = coface_answers::SceneArrangement::of([("solid", &solid)], &Default::default())?;
    /// assert!(arranged.is_valid()?);
    /// # Ok(()) }
    /// ```
    pub fn is_valid(&self) -> Result<bool, Error> {
        Ok(self.is_held(self.arranged.drawn_positions())
            && self.crossings()?.count == 0
            && self.turned_cells()?.is_empty())
    }

    /// Whether coordinates are numbers of the precision that is asked for.
    pub(super) fn is_held(&self, positions: &Positions) -> bool {
        positions.as_flat().iter().all(|&x| self.request.precision.holds(x))
    }

    /// Where faces with rounded coordinates meet otherwise than in common vertices and edges: nowhere if rounding is valid.
    ///
    /// # Errors
    /// None for arrangements that were made.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.crossings()?.count, 0);
    /// # Ok(()) }
    /// ```
    pub fn crossings(&self) -> Result<&Crossings, Error> {
        if let Some(found) = self.crossings.get() {
            return Ok(found);
        }
        let found = self.arranged.crossings(MOST_LISTED)?;
        Ok(self.crossings.get_or_init(|| found))
    }

    /// The polygons and where they are from.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.scene().polygon_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn scene(&self) -> &SpatialScene {
        &self.scene
    }

    /// The vertices, edges, faces and bounded cells; boundaries of cells run outward.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.complex().f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &ChainComplex {
        self.arranged.complex()
    }

    /// Where the vertices are, correctly rounded.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.positions().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        self.arranged.positions()
    }

    /// The volumes of the cells without their voids, rounded, in the cube of the unit of the models.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.volumes(), [1.0]);
    /// # Ok(()) }
    /// ```
    pub fn volumes(&self) -> &[f64] {
        self.arranged.volumes()
    }

    /// Whether a model has an inside.
    ///
    /// # Panics
    /// If there is no such model.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert!(matches!(arranged.input_state(0), coface_answers::InputState::Closed));
    /// # Ok(()) }
    /// ```
    pub fn input_state(&self, input: usize) -> InputState {
        input_state(&self.scene, &self.inputs, input)
    }

    /// Whether the products of neighboring boundary matrices are zero, found by multiplying.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] when the products do not fit.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert!(arranged.products_are_zero()?);
    /// # Ok(()) }
    /// ```
    pub fn products_are_zero(&self) -> Result<bool, Error> {
        products_are_zero(self.complex())
    }

    /// The number of connected components of all faces.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.component_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn component_count(&self) -> usize {
        component_count(self.complex())
    }

    /// Which inputs each cell is inside of; models that are open contain nothing.
    pub(super) fn membership(&self, rule: InsideRule) -> Result<Membership, Error> {
        if self.surface.is_some() {
            return Err(surface_alone());
        }
        let every = |_| true;
        self.inputs.membership(&self.scene, &self.arranged, rule, OpenInputs::Empty, &self.request, every)
    }

    /// The arrangement as an answer.
    ///
    /// `inside` is by the rule; models that are open contain nothing. `files` says for each model how many edges its rim has, how many
    /// cells it winds around less than zero times, and more than once.
    ///
    /// # Errors
    /// Those of [`Self::products_are_zero`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let answer = arranged.answer(coface_arrange::boolean::InsideRule::default())?;
    /// assert_eq!((answer.measures, answer.inside), (vec![1.0], vec![vec![0]]));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self, rule: InsideRule) -> Result<SpatialArrangementAnswer, Error> {
        if let Some(exact) = &self.unrounded {
            refuse_other_cells(exact, self)?;
        }
        let complex = self.complex();
        let membership = self.membership(rule)?;
        let cells = complex.cell_count(3);
        let place = |polygon: &u32| {
            let polygon = *polygon as usize;
            (self.scene.input_of_polygon()[polygon], self.scene.source_of_polygon()[polygon])
        };
        let dropped = self.arranged.degenerate_polygons();
        let split = self.arranged.split_polygons();
        let largest_deviation = split.iter().map(|polygon| polygon.deviation).fold(0.0, f64::max);
        let mut f_vector = complex.f_vector().to_vec();
        f_vector.resize(4, 0);
        let files = self.input_answers();
        let crossings = self.crossings()?;
        let turned = self.turned_cells()?;
        let remarks = self.remarks(&files, rule, crossings, &turned);
        Ok(SpatialArrangementAnswer {
            dimension: 3,
            f_vector,
            measures: self.volumes().to_vec(),
            inside: (0..cells).map(|cell| membership.inputs_around(CellId::new(cell))).collect(),
            regions: if self.scene.has_parts() { self.scene.names().to_vec() } else { Vec::new() },
            inputs_of_faces: self.scene.has_parts().then(|| self.inputs_of_faces()),
            products_zero: self.products_are_zero()?,
            holes: self.arranged.hole_count(),
            voids: self.arranged.void_count(),
            components: self.component_count(),
            euler_characteristic: complex.euler_characteristic(),
            dangling_faces: self.dangling_faces(),
            files,
            degenerate_polygons: DegeneratePolygons {
                count: dropped.len(),
                listed: dropped.iter().take(MOST_LISTED).map(place).collect(),
            },
            split_polygons: SplitPolygons { count: split.len(), largest_deviation },
            rounding: self.rounding((0..complex.cell_count(0)).map(CellId::new), crossings, &turned),
            joined: self.joined(),
            congruence: None,
            remarks,
        })
    }

    /// What was assumed and left out of the models, which polygons are not planar, and which models are inside out.
    pub(super) fn remarks(
        &self,
        files: &[SpatialInput],
        rule: InsideRule,
        crossings: &Crossings,
        turned: &[[f64; 3]],
    ) -> Vec<Remark> {
        let mut remarks = self.scene.remarks().to_vec();
        remarks.extend(self.warped_polygons());
        remarks.extend(self.joined_features());
        remarks.extend(self.unsettled_features());
        remarks.extend(self.thin_apart.clone().or_else(|| self.thin_cells()));
        if crossings.count > 0 {
            let places = text::count(crossings.count, "place");
            let message = format!("with rounded coordinates faces cross in {places}");
            let points = crossings.places.iter().map(|point| Place::point(point));
            remarks.push(Remark::new(RemarkCode::RoundedInvalid, message).at(crossings.count, points));
        }
        if !turned.is_empty() {
            let message = format!(
                "with rounded coordinates {} or inside out",
                if turned.len() == 1 {
                    "one part is flat".to_owned()
                } else {
                    format!("{} parts are flat", turned.len())
                }
            );
            let points = turned.iter().map(|point| Place::point(point));
            remarks.push(Remark::new(RemarkCode::RoundedInvalid, message).at(turned.len(), points));
        }
        remarks.extend(remarks_of_vanished(&self.inputs, files));
        remarks.extend(remarks_of_inputs(files, rule));
        remarks
    }

    /// The polygons that were split, if rounding of their coordinates does not explain that they are not planar.
    fn warped_polygons(&self) -> Option<Remark> {
        let split = self.arranged.split_polygons();
        let warped: Vec<&SplitPolygon> = split.iter().filter(|polygon| !polygon.is_rounding()).collect();
        let worst = warped.iter().copied().max_by(|x, y| x.deviation.total_cmp(&y.deviation))?;
        let name = |polygon: &SplitPolygon| {
            &self.scene.names()[self.scene.input_of_polygon()[polygon.polygon as usize] as usize]
        };
        let subject = match warped.len() {
            1 => "1 polygon is not planar and was".to_owned(),
            count => format!("{count} polygons are not planar and were"),
        };
        let message = format!(
            "{}: {subject} split into triangles; points are up to {:e} away from a plane, at polygon {}",
            name(worst),
            worst.deviation,
            self.scene.source_of_polygon()[worst.polygon as usize]
        );
        let places = warped.iter().map(|polygon| {
            let mut place = Place::cell(&self.scene.corners(polygon.polygon));
            place.file = Some(name(polygon).clone());
            place
        });
        Some(Remark::new(RemarkCode::FacesSplit, message).at(warped.len(), places))
    }

    /// The number of faces with one cell, or the exterior, on both sides.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(arranged.dangling_faces(), 0);
    /// # Ok(()) }
    /// ```
    pub fn dangling_faces(&self) -> usize {
        dangling_face_count(self.complex())
    }

    /// For each face the inputs that have a polygon there, rising.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1, twice.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let twice = SceneArrangement::of([("a", &solid), ("b", &solid)], &SpatialRequest::default())?;
    /// assert_eq!(twice.inputs_of_faces(), vec![vec![0, 1]; 4]);
    /// # Ok(()) }
    /// ```
    pub fn inputs_of_faces(&self) -> Vec<Vec<usize>> {
        (0..self.complex().cell_count(2)).map(|face| self.inputs_of_face(CellId::new(face))).collect()
    }

    pub(super) fn inputs_of_face(&self, face: CellId) -> Vec<usize> {
        let polygons = self.arranged.polygons_of_face(face).into_iter();
        let mut inputs: Vec<usize> =
            polygons.map(|(polygon, _)| self.scene.input_of_polygon()[polygon as usize] as usize).collect();
        inputs.sort_unstable();
        inputs.dedup();
        inputs
    }

    /// The inputs in their order.
    pub(super) fn input_answers(&self) -> Vec<SpatialInput> {
        input_answers(&self.scene, &self.inputs)
    }

    /// How many of these vertices have rounded coordinates.
    pub(super) fn rounding(
        &self,
        vertices: impl Iterator<Item = CellId>,
        crossings: &Crossings,
        turned: &[[f64; 3]],
    ) -> SpatialRounding {
        let rounded_vertices = vertices.filter(|&vertex| self.arranged.is_rounded(vertex)).count();
        SpatialRounding {
            exact: rounded_vertices == 0,
            rounded_vertices,
            rounds: self.arranged.round_count(),
            valid: crossings.count == 0 && turned.is_empty(),
            crossings: crossings.count,
            turned: turned.len(),
            places: crossings.places.clone(),
        }
    }

    /// What was put together.
    pub(super) fn joined(&self) -> Option<JoinedFeatures> {
        let vanished = |apart: usize| apart.saturating_sub(self.complex().cell_count(3));
        Some(JoinedFeatures::of(self.arranged.joined()?, self.cells_apart.map(vanished)))
    }

    /// Says that features were put together, if that changed anything.
    fn joined_features(&self) -> Option<Remark> {
        if self.request.snap {
            return None;
        }
        self.joined()?.remark(self.request.tolerance.is_some(), "cell")
    }

    /// Says that features are left that are nearer to each other than was asked for.
    fn unsettled_features(&self) -> Option<Remark> {
        let joined = self.arranged.joined().filter(|joined| joined.unsettled > 0)?;
        let places = text::count(joined.unsettled, "place");
        let message = format!(
            "in {places} features are left that are less than {:.2e} apart, since putting them together brings others together: cells there may be thinner than that",
            joined.tolerance
        );
        Some(Remark::new(RemarkCode::ThinCells, message).at(joined.unsettled, []))
    }

    /// Tells of cells thinner than a part of the extent that nobody means, and what would remove them.
    fn thin_cells(&self) -> Option<Remark> {
        if self.request.tolerance.is_some() {
            return None;
        }
        let drawn = self.arranged.drawn_positions().as_flat().as_chunks::<3>().0;
        let used = self.positions().as_flat().as_chunks::<3>().0;
        let bounds = ThinCells::of(used.as_flattened(), 3);
        let least = bounds.least();
        let cells = self.complex().boundary_matrix(3)?;
        let suspects =
            self.volumes().iter().enumerate().filter(|(_, volume)| **volume < bounds.largest_measure(3));
        let thickness = |(cell, &volume): (usize, &f64)| -> Option<f64> {
            let mut area = 0.0;
            for &face in cells.column(cell).rows() {
                for [a, b, c] in self.arranged.triangles(CellId::from_u32(face)).ok()? {
                    let [a, b, c] = [a, b, c].map(|corner| drawn[corner as usize]);
                    let normal = cross([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
                    area += dot(normal, normal).sqrt() / 2.0;
                }
            }
            // A slab has twice its area around it.
            Some(2.0 * volume / area)
        };
        let thin: Vec<f64> = suspects.filter_map(thickness).filter(|&own| own < least).collect();
        bounds.remark(&thin, "cell")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SolidBoolean;
    use crate::SolidRequest;
    use coface_arrange::boolean::BooleanFormula;
    use coface_io::Format;

    #[test]
    fn coordinates_that_nothing_makes_valid_are_the_nearest_ones() {
        // A tetrahedron with a notch narrower than the distance of numbers of 32 bits there.
        let text = "v 8 8 8\nv 9 8 8\nv 8 9 8\nv 8.1 8.1 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
        let notch =
            "v 8.3 7 7\nv 8.3000001 7 7\nv 8.3 9 7\nv 8.3 8.2 10\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
        let [solid, notch] = [text, notch].map(|text| coface_io::read(text.as_bytes(), Format::Obj).unwrap());
        let precision = CoordinatePrecision::Single;
        let request = SpatialRequest { precision, ..SpatialRequest::default() };
        let exact = SceneArrangement::of([("solid", &solid), ("notch", &notch)], &request).unwrap();
        let coarse = exact.coarsely_rounded().unwrap();
        assert!(coarse.positions().as_flat().iter().all(|&x| precision.holds(x)));
        assert!(coarse.crossings().unwrap().count > 0);
        let answer = coarse.answer(InsideRule::default()).unwrap();
        assert!(!answer.rounding.valid && !answer.rounding.exact);
        assert!(answer.remarks.iter().any(|remark| remark.code == RemarkCode::RoundedInvalid));
        let difference = SolidRequest::of(BooleanFormula::parse("a - b", &[]).unwrap());
        let result = SolidBoolean::of(&coarse, &difference).unwrap();
        assert!(result.positions().unwrap().as_flat().iter().all(|&x| precision.holds(x)));
        assert!(!result.is_valid().unwrap());
        assert!(!result.answer().unwrap().rounding.valid);
    }

    /// Two cubes of 100 m that overlap by 5 mm, 300 km away, where numbers of 32 bits are 3 cm apart.
    #[test]
    fn a_result_of_another_volume_is_refused() {
        let cube = |low: f64| {
            let mut text = String::new();
            for i in 0..8 {
                let [x, y, z] =
                    [(low, 0), (3e5, 1), (0.0, 2)].map(|(low, axis)| low + f64::from(i >> axis & 1) * 100.0);
                text += &format!("v {x:?} {y:?} {z:?}\n");
            }
            text += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
            coface_io::read(text.as_bytes(), Format::Obj).unwrap()
        };
        let (a, b) = (cube(3e5), cube(3e5 + 99.995));
        let request = SpatialRequest { precision: CoordinatePrecision::Single, ..SpatialRequest::default() };
        let exact = SceneArrangement::of([("a", &a), ("b", &b)], &request).unwrap();
        let coarse = exact.coarsely_rounded().unwrap();
        let common = SolidRequest::of(BooleanFormula::parse("a & b", &[]).unwrap());
        assert!(SolidBoolean::of(&exact, &common).is_ok());
        let error = SolidBoolean::of(&coarse, &common).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::UnsupportedFormat);
    }
}
