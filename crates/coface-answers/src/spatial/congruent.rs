//! A scene arranged by congruence, within a tolerance.

use super::boolean::{EXTERIOR, sides_of_faces};
use super::facts::{
    component_count, dangling_face_count, input_answers, products_are_zero, remarks_of_inputs,
    remarks_of_vanished,
};
use super::inputs::{Inputs, Membership};
use super::models::{NO_CELL, group_names};
use super::{OpenInputs, SpatialScene};
use crate::answer::{
    CongruentPieces, DegeneratePolygons, JoinedFeatures, Place, Remark, RemarkCode, SpatialArrangementAnswer,
    SpatialArrangementProvenance, SpatialInput, SpatialRounding, SplitPolygons,
};
use crate::near::assumed_tolerance;
use crate::text;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, EdgeId, Error, ErrorKind, FaceId, VertexId};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use coface_arrange::boolean::InsideRule;
use coface_arrange::spatial::{
    CongruenceArrangement, Crossings, NonPlanar, SpatialPolygons, arrange_by_congruence, closed_walks,
};
use coface_geometry::Positions;
use coface_geometry::predicates::orientation;
use coface_geometry::triangulation::triangulate;
use coface_io::{CellData, Group, GroupKind, Model, repeated_vertex};

/// So many polygons or places are listed.
const MOST_LISTED: usize = 100;

/// The cells that the polygons of models cut space into, by congruence: each polygon is cut in its own plane, and what is at
/// most a tolerance apart becomes one.
///
/// Numbers are rounded and the tolerance decides what coincides, so this is the method for polygons that meet only nearly, and
/// the second method for [`SceneArrangement`](super::SceneArrangement), which is exact.
///
/// # Examples
/// Two tetrahedra whose common face is written twice, a millionth apart:
/// ```
/// use coface_answers::{CongruentScene, SpatialScene};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let read = |text: &str| coface_io::read(text.as_bytes(), coface_io::Format::Obj);
/// let up = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")?;
/// let down = read("v 0 0 -1e-6\nv 1 0 0\nv 0 1 0\nv 0 0 -12\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n")?;
/// let scene = SpatialScene::of([("up", &up), ("down", &down)], true)?;
/// let arranged = CongruentScene::of_scene(scene, 1e-4)?;
/// assert_eq!(arranged.complex().f_vector(), [5, 9, 7, 2]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct CongruentScene {
    scene: SpatialScene,
    pub(super) arranged: CongruenceArrangement,
    complex: ChainComplex,
    inputs: Inputs,
    /// The walks around each face, one face after the other, and the face of each.
    walks: RaggedArray,
    face_of_walk: Vec<u32>,
    tolerance: f64,
    /// Says which tolerance was taken, where none was given.
    assumed: Option<Remark>,
}

impl CongruentScene {
    /// Arranges the polygons of a scene. The tolerance is a length in the unit of the models: well above the rounding of
    /// coordinates, well below the least distance of features that are different. Without one it is 1e-9 of the extent of the
    /// models, or more if rounding needs it, and a remark of the answer says so.
    ///
    /// # Errors
    /// Those of [`arrange_by_congruence`], naming the polygon of a file that is not flat within the tolerance.
    ///
    /// # Complexity
    /// That of [`arrange_by_congruence`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// let arranged = coface_answers::CongruentScene::of_scene(scene, 1e-9)?;
    /// assert_eq!(arranged.complex().f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn of_scene(scene: SpatialScene, tolerance: impl Into<Option<f64>>) -> Result<Self, Error> {
        Self::with_bent(scene, tolerance, NonPlanar::Refuse)
    }

    /// The same, where polygons that are not flat within the tolerance are split into triangles, unless these are refused.
    ///
    /// # Errors
    /// As [`Self::of_scene`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruentScene, SpatialScene};
    /// use coface_arrange::spatial::NonPlanar;
    /// let text = "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nf 1 2 3 4\n";
    /// let bent = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = SpatialScene::of([("bent", &bent)], true)?;
    /// let arranged = CongruentScene::with_bent(scene.clone(), 1e-9, NonPlanar::Split)?;
    /// assert_eq!(arranged.complex().f_vector(), [4, 5, 2, 0]);
    /// assert!(CongruentScene::with_bent(scene, 1e-9, NonPlanar::Refuse).is_err());
    /// # Ok(()) }
    /// ```
    pub fn with_bent(
        mut scene: SpatialScene,
        tolerance: impl Into<Option<f64>>,
        bent: NonPlanar,
    ) -> Result<Self, Error> {
        let positions = scene.positions()?;
        let (tolerance, assumed) = match tolerance.into() {
            Some(tolerance) => (tolerance, None),
            None => {
                let (tolerance, remark) = assumed_tolerance(positions.as_flat(), 3);
                (tolerance, Some(remark))
            }
        };
        if bent == NonPlanar::Split && tolerance.is_finite() {
            let remark = scene.cut_bent_polygons(&positions, tolerance)?;
            scene.remarks.extend(remark);
        }
        let arranged = arrange_by_congruence(&positions, &scene.walks, &scene.polygon_of_walk, tolerance)
            .map_err(|error| named(error, &scene, tolerance))?;
        if tolerance > 0.0
            && scene.polygon_count() > 0
            && arranged.dropped_polygons().len() == scene.polygon_count()
        {
            return Err(Error::invalid(format!(
                "all polygons collapse: none is wider than the tolerance {tolerance:e}"
            ))
            .with_cure("give a smaller --tolerance"));
        }
        let complex = arranged.chain_complex()?;
        let face_count = complex.cell_count(2);
        let mut entries = Vec::new();
        for face in 0..face_count {
            for (polygon, sign) in arranged.polygons_of_face(FaceId::new(face)) {
                // Faces between cells of one model cancel in it.
                if !scene.is_wall(polygon) {
                    let input = scene.input_of_polygon()[polygon] as usize;
                    entries.push((face, input, i64::from(sign.to_i32())));
                }
            }
        }
        let count = scene.names().len();
        let chains = SparseMatrix::from_entries(face_count, count, entries)?;
        let inputs = Inputs::of_chains(count, &complex, &chains)?;
        let (mut walks, mut face_of_walk) = (RaggedArray::new(), Vec::new());
        for face in 0..face_count {
            let own = walks_around(&complex, face);
            own.iter().for_each(|walk| walks.push(walk));
            face_of_walk.resize(walks.len(), face as u32);
        }
        Ok(Self { scene, arranged, complex, inputs, walks, face_of_walk, tolerance, assumed })
    }

    /// Refuses an arrangement with more vertices, edges and faces together.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] with their number.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// let arranged = coface_answers::CongruentScene::of_scene(scene, 1e-9)?;
    /// assert!(arranged.refuse_more_cells(14).is_ok() && arranged.refuse_more_cells(13).is_err());
    /// # Ok(()) }
    /// ```
    pub fn refuse_more_cells(&self, most: impl Into<Option<usize>>) -> Result<(), Error> {
        let count = self.complex.f_vector().iter().take(3).sum::<usize>();
        match most.into() {
            Some(most) if count > most => Err(Error::new(
                ErrorKind::TooLarge,
                format!("the arrangement has {count} vertices, edges and faces together, more than {most}"),
            )),
            _ => Ok(()),
        }
    }

    /// The polygons and where they are from.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// assert_eq!(coface_answers::CongruentScene::of_scene(scene, 1e-9)?.scene().polygon_count(), 4);
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
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// let arranged = coface_answers::CongruentScene::of_scene(scene, 1e-9)?;
    /// assert_eq!(arranged.complex().cell_count(3), 1);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &ChainComplex {
        &self.complex
    }

    /// Where the vertices are: at corners of polygons where these are.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// assert_eq!(coface_answers::CongruentScene::of_scene(scene, 1e-9)?.positions().len(), 4);
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
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// assert_eq!(coface_answers::CongruentScene::of_scene(scene, 1e-9)?.volumes(), [1.0]);
    /// # Ok(()) }
    /// ```
    pub fn volumes(&self) -> &[f64] {
        self.arranged.volumes()
    }

    /// The arrangement as an answer, with what congruence did under `congruence`; `inside` is by the rule, and models that are
    /// open contain nothing.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] when products of boundary matrices do not fit.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// let answer = coface_answers::CongruentScene::of_scene(scene, 1e-9)?.answer(Default::default())?;
    /// assert_eq!(answer.congruence.map(|done| done.stacked_f_vector[2]), Some(4));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self, rule: InsideRule) -> Result<SpatialArrangementAnswer, Error> {
        let membership = self.inputs.membership_of_closed(rule);
        let cells = self.complex.cell_count(3);
        let dropped = self.arranged.dropped_polygons();
        let place = |&polygon: &u32| {
            let polygon = polygon as usize;
            (self.scene.input_of_polygon()[polygon], self.scene.source_of_polygon()[polygon])
        };
        let files = input_answers(&self.scene, &self.inputs);
        let crossings = self.crossings()?;
        let remarks = self.remarks(&files, rule, &crossings);
        let parts = self.scene.has_parts();
        let faces = (0..self.complex.cell_count(2)).map(CellId::new);
        let mut f_vector = self.complex.f_vector().to_vec();
        f_vector.resize(4, 0);
        Ok(SpatialArrangementAnswer {
            dimension: 3,
            f_vector,
            measures: self.volumes().to_vec(),
            inside: (0..cells).map(|cell| membership.inputs_around(CellId::new(cell))).collect(),
            regions: if parts { self.scene.names().to_vec() } else { Vec::new() },
            inputs_of_faces: parts.then(|| faces.map(|face| self.inputs_of_face(face)).collect()),
            products_zero: products_are_zero(&self.complex)?,
            holes: self.walks.len().saturating_sub(self.complex.cell_count(2)),
            voids: self.arranged.void_count(),
            components: component_count(&self.complex),
            euler_characteristic: self.complex.euler_characteristic(),
            dangling_faces: dangling_face_count(&self.complex),
            files,
            degenerate_polygons: DegeneratePolygons {
                count: dropped.len(),
                listed: dropped.iter().take(MOST_LISTED).map(place).collect(),
            },
            split_polygons: SplitPolygons { count: 0, largest_deviation: 0.0 },
            rounding: self.rounding(crossings)?,
            joined: Some(self.joined()?),
            congruence: Some(self.pieces()),
            remarks,
        })
    }

    /// For each face its sources: the model, the polygon in it, and 1 or -1 where the polygon runs with the face or against it.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// let found = coface_answers::CongruentScene::of_scene(scene, 1e-9)?.provenance();
    /// assert_eq!(found.faces, [[[0, 0, 1]], [[0, 1, 1]], [[0, 2, 1]], [[0, 3, 1]]]);
    /// # Ok(()) }
    /// ```
    pub fn provenance(&self) -> SpatialArrangementProvenance {
        let sources = |face: usize| self.sources(CellId::new(face), Sign::Plus);
        SpatialArrangementProvenance {
            files: self.scene.names().to_vec(),
            faces: (0..self.complex.cell_count(2)).map(sources).collect(),
            vertices: Some(
                self.sources_of_low(0, |vertex| self.arranged.polygons_of_vertex(VertexId::new(vertex))),
            ),
            edges: Some(self.sources_of_low(1, |edge| self.arranged.polygons_of_edge(EdgeId::new(edge)))),
        }
    }

    /// Vertices, edges, faces and bounded cells with positions, each cell once; a remark says so where cells are no balls.
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
    /// let model = coface_answers::CongruentScene::of_scene(scene, 1e-9)?.to_chains()?;
    /// assert!(model.structure().is_some());
    /// # Ok(()) }
    /// ```
    pub fn to_chains(&self) -> Result<Model, Error> {
        Ok(Model::from_chains(self.complex.clone(), self.positions().clone())?.with_remark_on_cells())
    }

    /// The faces as polygons, those with holes as triangles, or all as triangles, with the data `cell_back` and `cell_front`, the cells
    /// on the two sides of each (-1 for the exterior); with `groups` in a group for each cell.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] where a face cannot be cut into triangles.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// let mesh = coface_answers::CongruentScene::of_scene(scene, 1e-9)?.to_mesh(false, true)?;
    /// assert_eq!((mesh.polygons().len(), mesh.groups().len()), (4, 1));
    /// # Ok(()) }
    /// ```
    pub fn to_mesh(&self, triangles: bool, groups: bool) -> Result<Model, Error> {
        let (mut polygons, mut face_of_polygon) = (RaggedArray::new(), Vec::new());
        for face in 0..self.complex.cell_count(2) {
            for piece in self.pieces_of(CellId::new(face), triangles)? {
                polygons.push(&piece);
                face_of_polygon.push(face);
            }
        }
        let mut model = Model::from_polygons(self.positions().clone(), polygons)?;
        let sides = sides_of_faces(&self.complex);
        let number = |cell: u32| if cell == EXTERIOR { NO_CELL } else { i64::from(cell) };
        for (side, name) in ["cell_back", "cell_front"].into_iter().enumerate() {
            let values = face_of_polygon.iter().map(|&face| number(sides[face][side])).collect();
            model = model.with_data(CellData::integers(name, GroupKind::Polygons, 1, values)?)?;
        }
        if !groups {
            return Ok(model);
        }
        let mut members = vec![Vec::new(); self.complex.cell_count(3)];
        for (polygon, &face) in (0..).zip(&face_of_polygon) {
            for cell in sides[face] {
                if let Some(members) = members.get_mut(cell as usize) {
                    members.push(polygon);
                }
            }
        }
        for (cell, members) in members.into_iter().enumerate() {
            model = model.with_group(Group::new(format!("cell_{cell}"), GroupKind::Polygons, members))?;
        }
        if self.scene.has_parts() {
            let mut members = vec![Vec::new(); self.scene.names().len()];
            for (polygon, &face) in (0..).zip(&face_of_polygon) {
                for input in self.inputs_of_face(CellId::new(face)) {
                    members[input].push(polygon);
                }
            }
            for (name, members) in group_names(self.scene.names()).into_iter().zip(members) {
                model = model.with_group(Group::new(name, GroupKind::Polygons, members))?;
            }
        }
        Ok(model)
    }

    /// A face as one polygon, or as triangles where it is no simple polygon or that is asked for.
    pub(super) fn pieces_of(&self, face: CellId, triangles: bool) -> Result<Vec<Vec<u32>>, Error> {
        let walks = self.walks_of(face);
        let is_simple = walks.len() == 1 && repeated_vertex(walks.list(0)).is_none();
        if is_simple && (!triangles || walks.list(0).len() == 3) {
            return Ok(vec![walks.list(0).to_vec()]);
        }
        let own = triangulated(self.positions(), &walks).ok_or_else(|| {
            Error::invalid(format!(
                "face {} crosses itself in rounded numbers, and cannot be cut into triangles",
                face.index()
            ))
            .with_cure("write .json, which keeps faces as they are, or give a smaller tolerance")
        })?;
        Ok(own.into_iter().map(|triangle| triangle.to_vec()).collect())
    }

    /// The inputs and polygons of the cells of a low degree, from their polygons.
    fn sources_of_low<'a>(&self, degree: usize, polygons: impl Fn(usize) -> &'a [u32]) -> Vec<Vec<[u32; 2]>> {
        let source = |&polygon: &u32| {
            let polygon = polygon as usize;
            [self.scene.input_of_polygon()[polygon], self.scene.source_of_polygon()[polygon]]
        };
        (0..self.complex.cell_count(degree)).map(|cell| polygons(cell).iter().map(source).collect()).collect()
    }

    /// The points that became one although they were apart.
    pub(super) fn joined(&self) -> Result<JoinedFeatures, Error> {
        let given = self.scene.positions()?;
        let at = |point: u32| given.point(VertexId::from_u32(point));
        let mut points: Vec<(VertexId, u32)> = (0..given.len())
            .filter_map(|point| Some((self.arranged.vertex_of_point(point)?, point as u32)))
            .collect();
        points.sort_unstable();
        let mut joined = JoinedFeatures::of(&coface_arrange::JoinedFeatures::default(), None);
        joined.tolerance = self.tolerance;
        for own in points.chunk_by(|x, y| x.0 == y.0) {
            let place = self.positions().point(own[0].0);
            for &(_, point) in own {
                let way = at(point).iter().zip(place).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
                joined.moved += usize::from(way > 0.0);
                joined.largest_movement = joined.largest_movement.max(way);
            }
            if own.iter().any(|&(_, point)| at(point) != at(own[0].1)) {
                joined.vertices += own.len() - 1;
                joined.classes.push(own.iter().map(|&(_, point)| point).collect());
            }
        }
        Ok(joined)
    }

    pub(super) fn inputs_of_face(&self, face: CellId) -> Vec<usize> {
        let polygons = self.arranged.polygons_of_face(FaceId::from_u32(face.to_u32()));
        let mut inputs: Vec<usize> =
            polygons.map(|(polygon, _)| self.scene.input_of_polygon()[polygon] as usize).collect();
        inputs.sort_unstable();
        inputs.dedup();
        inputs
    }

    pub(super) fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// Which inputs contain the cells.
    ///
    /// # Errors
    /// `NotACycle` naming an input that is open, if these are refused.
    pub(super) fn membership(
        &self,
        rule: InsideRule,
        open: OpenInputs,
        is_used: impl Fn(usize) -> bool,
    ) -> Result<Membership, Error> {
        let is_part = |input: usize| self.scene.is_named_part(input);
        self.inputs.membership_or(rule, open, (is_used, is_part), |input, rim| {
            let edges = text::count(rim.ridges().len(), "edge");
            let error = match rim.is_even() {
                true => Error::new(ErrorKind::NotACycle, format!("polygons do not agree in direction across {edges}"))
                    .with_cure("turn polygons so that all agree (coface convert --orient), or count by parity (--rule evenodd)"),
                false => Error::new(ErrorKind::NotACycle, format!("the surface is open along {edges}, glued within {:e}", self.tolerance))
                    .with_cure("give a larger --tolerance that closes its gaps, or leave --method out: the exact method says where it is open"),
            };
            error.in_file(self.scene.label(input))
        })
    }

    /// The walks around a face.
    pub(super) fn walks_of(&self, face: CellId) -> RaggedArray {
        let face = face.to_u32();
        let first = self.face_of_walk.partition_point(|&own| own < face);
        let last = self.face_of_walk.partition_point(|&own| own <= face);
        RaggedArray::from_lists((first..last).map(|walk| self.walks.list(walk)))
    }

    /// The sources of a face that runs in this direction.
    pub(super) fn sources(&self, face: CellId, direction: Sign) -> Vec<[i64; 3]> {
        let own = self.arranged.polygons_of_face(FaceId::from_u32(face.to_u32())).map(|(polygon, sign)| {
            let source = [self.scene.input_of_polygon()[polygon], self.scene.source_of_polygon()[polygon]];
            let [input, number] = source.map(i64::from);
            [input, number, i64::from(sign.times(direction).to_i32())]
        });
        own.collect()
    }

    /// What congruence stacked and glued.
    pub(super) fn pieces(&self) -> CongruentPieces {
        CongruentPieces {
            tolerance: self.tolerance,
            stacked_f_vector: self.arranged.stacked_f_vector().to_vec(),
            largest_class_diameter: self.arranged.largest_class_diameter(),
            glued_f_vector: self.arranged.glued_f_vector().to_vec(),
            collapsed: self.arranged.dropped_polygons().len(),
        }
    }

    pub(super) fn rounding(&self, crossings: Crossings) -> Result<SpatialRounding, Error> {
        Ok(SpatialRounding {
            exact: false,
            rounded_vertices: self.new_vertex_count()?,
            rounds: 0,
            valid: crossings.count == 0,
            crossings: crossings.count,
            turned: 0,
            places: crossings.places,
        })
    }

    pub(super) fn remarks(
        &self,
        files: &[SpatialInput],
        rule: InsideRule,
        crossings: &Crossings,
    ) -> Vec<Remark> {
        let mut remarks = self.scene.remarks().to_vec();
        remarks.extend(self.assumed.clone());
        if crossings.count > 0 {
            let places = text::count(crossings.count, "place");
            let message = format!("with rounded coordinates faces cross in {places}");
            let points = crossings.places.iter().map(|point| Place::point(point));
            remarks.push(Remark::new(RemarkCode::RoundedInvalid, message).at(crossings.count, points));
        }
        remarks.extend(self.collapsed());
        remarks.extend(remarks_of_vanished(&self.inputs, files));
        remarks.extend(remarks_of_inputs(files, rule));
        remarks
    }

    /// Which tolerance was taken, and what collapsed.
    pub(super) fn remarks_on_gluing(&self) -> Vec<Remark> {
        self.assumed.iter().cloned().chain(self.collapsed()).collect()
    }

    fn collapsed(&self) -> Option<Remark> {
        let collapsed = self.arranged.dropped_polygons().len();
        if collapsed == 0 {
            return None;
        }
        let polygons = text::count(collapsed, "polygon");
        let message = format!("{polygons} collapsed, nowhere wider than {:e}", self.tolerance);
        Some(Remark::new(RemarkCode::FeaturesJoined, message).at(collapsed, []))
    }

    /// Where faces on their rounded positions meet otherwise than in common vertices and edges; decided exactly.
    pub(super) fn crossings(&self) -> Result<Crossings, Error> {
        let polygons =
            SpatialPolygons::new(self.positions().clone(), self.walks.clone(), self.face_of_walk.clone())?;
        match polygons.crossings(MOST_LISTED) {
            // A face whose own sides cross.
            Err(error) if error.kind() == ErrorKind::InvalidInput => {
                let mut crossings = Crossings::default();
                crossings.count = 1;
                Ok(crossings)
            }
            found => found,
        }
    }

    /// The number of vertices that are no corners of polygons.
    fn new_vertex_count(&self) -> Result<usize, Error> {
        let given = self.scene.positions()?;
        let bits = |point: &[f64]| [point[0], point[1], point[2]].map(|x| (x + 0.0).to_bits());
        let mut corners: Vec<[u64; 3]> =
            given.as_flat().as_chunks::<3>().0.iter().map(|point| bits(point)).collect();
        corners.sort_unstable();
        let vertices = self.positions().as_flat().as_chunks::<3>().0.iter();
        Ok(vertices.filter(|point| corners.binary_search(&bits(&point[..])).is_err()).count())
    }
}

/// The walks around a face.
fn walks_around(complex: &ChainComplex, face: usize) -> RaggedArray {
    let (Some(faces), Some(edges)) = (complex.boundary_matrix(2), complex.boundary_matrix(1)) else {
        return RaggedArray::new();
    };
    let side = |(edge, sign): (usize, i32)| {
        let column = edges.column(edge);
        let (rows, entries) = (column.rows(), column.entries());
        let [tail, head] = if entries[0] < 0 { [rows[0], rows[1]] } else { [rows[1], rows[0]] };
        if sign > 0 { [tail, head] } else { [head, tail] }
    };
    let mut sides: Vec<[u32; 2]> = faces.column(face).iter().map(side).collect();
    closed_walks(&mut sides)
}

/// The fault of a polygon by its number in its own file.
fn named(error: Error, scene: &SpatialScene, tolerance: f64) -> Error {
    let Some(&polygon) = error.cells().first().and_then(|cell| cell.first()) else { return error };
    let input = scene.input_of_polygon()[polygon as usize] as usize;
    let number = scene.source_of_polygon()[polygon as usize];
    let message = format!("polygon {number} is not flat within the tolerance {tolerance:e}");
    Error::invalid(message)
        .with_cure(
            "give a larger --tolerance, or --non-planar split, which cuts such polygons into triangles",
        )
        .in_file(scene.label(input))
}

/// Triangles of a flat polygon with these walks around it, seen along the axis that it faces most.
pub(super) fn triangulated(positions: &Positions, walks: &RaggedArray) -> Option<Vec<[u32; 3]>> {
    let point = |vertex: u32| positions.point(VertexId::from_u32(vertex));
    let mut normal = [0.0; 3];
    for walk in walks.iter() {
        let origin = point(walk[0]);
        for (i, &from) in walk.iter().enumerate() {
            let [p, q] = [from, walk[(i + 1) % walk.len()]]
                .map(|v| [0, 1, 2].map(|axis| point(v)[axis] - origin[axis]));
            let turn = coface_geometry::cross(p, q);
            normal = [0, 1, 2].map(|axis| normal[axis] + turn[axis]);
        }
    }
    let most = (0..3).max_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs()))?;
    let [mut first, mut second] = [(most + 1) % 3, (most + 2) % 3];
    if normal[most] < 0.0 {
        std::mem::swap(&mut first, &mut second);
    }
    let flat = |vertex: u32| [point(vertex)[first], point(vertex)[second]];
    let compare = |a: u32, b: u32| {
        let ([ax, ay], [bx, by]) = (flat(a), flat(b));
        (ax + 0.0).total_cmp(&(bx + 0.0)).then((ay + 0.0).total_cmp(&(by + 0.0)))
    };
    let lists: Vec<&[u32]> = walks.iter().collect();
    triangulate(&lists, compare, |a, b, c| orientation(flat(a), flat(b), flat(c))).ok()
}
