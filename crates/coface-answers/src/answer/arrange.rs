//! What `arrange` answers: the cells that drawings cut the plane into, or surfaces space.

use super::Remark;
use serde::{Deserialize, Serialize};

/// The arrangement of drawings in the plane.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PlanarArrangementAnswer {
    /// The dimension of the space: 2.
    pub dimension: usize,
    /// The numbers of vertices, edges and bounded faces.
    pub f_vector: [usize; 3],
    /// The areas of the bounded faces, in the square of the unit of the inputs.
    pub measures: Vec<f64>,
    /// For each bounded face the inputs (or the regions, if features are inputs) that contain it, numbered from 0, rising.
    pub inside: Vec<Vec<u32>>,
    /// Whether the boundary of every boundary is zero, found by multiplying the matrices.
    pub products_zero: bool,
    /// The number of holes in bounded faces.
    pub holes: usize,
    /// The number of connected components of vertices and edges.
    pub components: usize,
    /// Vertices minus edges plus bounded faces.
    pub euler_characteristic: i64,
    /// The number of edges with one face on both sides.
    pub bridges: usize,
    /// The number of those bridges that are joined to the rest at one end, or at none.
    pub dangling_edges: usize,
    /// What rounding the coordinates does to the drawing.
    pub rounding: PlanarRounding,
    /// How many times coordinates were rounded and everything arranged again; null unless snapping was asked for.
    pub snap_rounds: Option<usize>,
    /// What was put together, where that was asked for.
    #[serde(default)]
    pub joined: Option<JoinedFeatures>,
    /// What congruence put together; with `--method congruence` only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub congruence: Option<CongruentPieces>,
    /// The inputs in their order.
    pub inputs: Vec<DrawingInput>,
    /// The names of the regions in their order.
    pub regions: Vec<String>,
    /// The columns of the table of faces, with `--attributes`; absent without.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub attributes: Option<Vec<AttributeColumn>>,
    /// Sentences about what is odd in the inputs.
    pub warnings: Vec<String>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A column of the table of faces: a key of the properties of features of an input.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct AttributeColumn {
    /// The name of the column.
    pub name: String,
    /// The input whose features have the key, numbered from 0.
    pub input: usize,
    /// The key.
    pub key: String,
}

impl AttributeColumn {
    /// The column of a key of an input that no other input has.
    pub(crate) fn new(input: usize, key: String) -> Self {
        Self { name: key.clone(), input, key }
    }
}

/// What rounding the coordinates of crossings does to an arrangement in the plane.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PlanarRounding {
    /// Whether no coordinate was rounded.
    pub exact: bool,
    /// Whether the drawing with rounded coordinates is the same complex.
    pub valid: bool,
    /// The number of vertices that have the rounded position of another one.
    pub merged_vertices: usize,
    /// The number of edges that cross others when they are drawn with rounded coordinates.
    pub broken_edges: usize,
    /// The number of vertices around which the order of the edges changes.
    pub turned_vertices: usize,
    /// The number of components that lie in another face.
    pub moved_components: usize,
    /// What was done so that it is.
    #[serde(flatten)]
    pub repair: RoundingRepair,
}

/// What was done in the plane because rounded coordinates alone would change a result.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(default)]
#[non_exhaustive]
pub struct RoundingRepair {
    /// How many times the result was rounded and cut again.
    pub rounds: usize,
    /// How many vertices were added to edges.
    pub bends: usize,
    /// The vertices that became one with others, or went to another place than the nearest.
    pub moved: usize,
    /// The longest way that a point of an edge went, in the unit of the inputs.
    pub largest_movement: f64,
    /// The number of faces or polygons that are not there any more, because they were thinner.
    pub vanished: usize,
}

/// One drawing among the inputs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DrawingInput {
    /// The name of the file.
    pub file: String,
    /// The number of segments it draws.
    pub segments: usize,
    /// The number of polygons it draws.
    pub polygons: usize,
}

/// Where a vertex of a result in the plane comes from. A pair is an input and a number in it, both from 0.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum VertexOrigin {
    /// It is this vertex of an input.
    Vertex((usize, usize)),
    /// It is the crossing of these two segments.
    Segments([(usize, usize); 2]),
}

/// Where the cells of an arrangement in the plane come from. A segment is a pair: an input and a number in it, both from 0.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PlanarArrangementProvenance {
    /// The names of the inputs.
    pub inputs: Vec<String>,
    /// The names of the regions.
    pub regions: Vec<String>,
    /// The origin of each vertex.
    pub vertices: Vec<VertexOrigin>,
    /// The segments along each edge.
    pub edges: Vec<Vec<(usize, usize)>>,
    /// The regions around each bounded face.
    pub faces: Vec<Vec<u32>>,
}

/// The arrangement of surfaces and solids in space.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SpatialArrangementAnswer {
    /// The dimension of the space: 3.
    pub dimension: usize,
    /// The numbers of vertices, edges, faces and bounded cells.
    pub f_vector: Vec<usize>,
    /// The volumes of the bounded cells without their voids, in the cube of the unit of the inputs.
    pub measures: Vec<f64>,
    /// For each bounded cell the inputs that contain it, numbered from 0, rising; inputs that are open contain nothing.
    pub inside: Vec<Vec<usize>>,
    /// The names of the inputs in their order, if parts of files are inputs.
    #[serde(default)]
    pub regions: Vec<String>,
    /// For each face the inputs that have a polygon there, numbered from 0, rising; if parts of files are inputs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inputs_of_faces: Option<Vec<Vec<usize>>>,
    /// Whether the boundary of every boundary is zero, found by multiplying the matrices.
    pub products_zero: bool,
    /// The number of holes of faces: walks around faces beyond the first of each.
    pub holes: usize,
    /// The number of voids of cells: shells of cells beyond the first of each.
    pub voids: usize,
    /// The number of connected components of all faces.
    pub components: usize,
    /// Vertices minus edges plus faces minus bounded cells.
    pub euler_characteristic: i64,
    /// The number of faces with one cell, or the exterior, on both sides.
    pub dangling_faces: usize,
    /// The inputs in their order.
    pub files: Vec<SpatialInput>,
    /// The polygons without area, which are left out.
    pub degenerate_polygons: DegeneratePolygons,
    /// The polygons that were split because they are not planar.
    pub split_polygons: SplitPolygons,
    /// What was rounded.
    pub rounding: SpatialRounding,
    /// What was put together, where that was asked for or needed.
    pub joined: Option<JoinedFeatures>,
    /// What congruence put together; with `--method congruence` only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub congruence: Option<CongruentPieces>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// What congruence did: the pieces of segments, or of polygons in space, each cut for itself, that were stacked and glued.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CongruentPieces {
    /// The distance within which vertices became one, in the unit of the inputs.
    pub tolerance: f64,
    /// The numbers of vertices and edges of all segments, or of vertices, edges and faces of all polygons, each cut by itself.
    pub stacked_f_vector: Vec<usize>,
    /// The largest distance of two vertices that became one, in the unit of the inputs: far below the tolerance if that was
    /// chosen well.
    pub largest_class_diameter: f64,
    /// In space the numbers of vertices, edges and faces that several pieces became.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub glued_f_vector: Vec<usize>,
    /// The segments whose ends became one, or the polygons that are nowhere wider than the tolerance: they are left out.
    #[serde(default)]
    pub collapsed: usize,
}

/// Polygons that have no area.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DegeneratePolygons {
    /// How many there are.
    pub count: usize,
    /// The first hundred of them as pairs: an input and a polygon of it, both from 0.
    pub listed: Vec<(u32, u32)>,
}

/// Polygons that were split into triangles because they are not planar.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SplitPolygons {
    /// How many there are.
    pub count: usize,
    /// The largest distance of a vertex from the plane of its polygon, in the unit of the inputs.
    pub largest_deviation: f64,
}

/// One surface or solid among the inputs.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SpatialInput {
    /// The name of the file.
    pub file: String,
    /// The name of the object, group, feature or component of the file that is this input, if parts of files are
    /// inputs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The number of its polygons.
    pub polygons: usize,
    /// Whether every edge lies in an even number of its polygons.
    pub closed: bool,
    /// Whether its polygons agree in direction across every edge.
    pub coherent: bool,
    /// The number of edges along which it is open, or its polygons disagree.
    pub rim_edges: usize,
    /// The number of cells that it winds around less than zero times.
    pub reversed_cells: usize,
    /// The number of cells that it winds around more than once.
    pub overlapping_cells: usize,
    /// How cells inside of it were found; in Booleans only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inside_by: Option<InsideMethod>,
}

impl SpatialInput {
    /// What the input is called: its name in the file if it has one, or the file.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{RegionSource, SceneArrangement, SpatialRequest, SpatialScene};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\no peak\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = SpatialScene::with_inputs([("a.obj", &solid)], RegionSource::Objects, true)?;
    /// let arranged = SceneArrangement::of_scene(scene, &SpatialRequest::default())?;
    /// assert_eq!(arranged.answer(Default::default())?.files[0].label(), "a.obj: peak");
    /// # Ok(()) }
    /// ```
    pub fn label(&self) -> String {
        match &self.name {
            // A component is named by its file.
            Some(name) if name.starts_with(&self.file) => name.clone(),
            Some(name) => format!("{}: {name}", self.file),
            None => self.file.clone(),
        }
    }
}

/// How the cells inside of a model are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum InsideMethod {
    /// By winding numbers, which are exact.
    Winding,
    /// By the parity of crossings, since polygons disagree in direction.
    Parity,
    /// By winding numbers of the model with patches that close its mouths.
    ClosedMouths,
}

/// What was rounded in space.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SpatialRounding {
    /// Whether no coordinate was rounded.
    pub exact: bool,
    /// The number of vertices with a rounded coordinate.
    pub rounded_vertices: usize,
    /// How many times coordinates were rounded and everything arranged again.
    pub rounds: usize,
    /// Whether faces with rounded coordinates meet in common vertices and edges alone, and no cell, or no solid and void of
    /// a result, is flat or inside out; decided exactly.
    pub valid: bool,
    /// The number of places where faces meet otherwise.
    pub crossings: usize,
    /// The number of cells, or of solids and voids of a result, that rounding made flat or turned inside out.
    #[serde(default)]
    pub turned: usize,
    /// Some of these places, by their coordinates.
    pub places: Vec<[f64; 3]>,
}

/// What was put together because it was nearly one: within a tolerance, or to make rounded coordinates valid.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct JoinedFeatures {
    /// The distance within which features were put together, in the unit of the inputs.
    pub tolerance: f64,
    /// The number of polygons whose planes were replaced by one that fits several.
    pub planes: usize,
    /// How many times a vertex was put to another one.
    pub vertices: usize,
    /// How many times a vertex was put on an edge.
    pub edges: usize,
    /// How many pairs of edges were given a common vertex.
    pub crossings: usize,
    /// How many times a vertex was put on a face.
    pub faces: usize,
    /// The number of points that moved.
    pub moved: usize,
    /// The longest way that a point went, in the unit of the inputs.
    pub largest_movement: f64,
    /// The vertices that became one although they were apart, by their numbers among the points of all inputs, one input after
    /// the other.
    pub classes: Vec<Vec<u32>>,
    /// The number of cells that are not there any more, because they were thinner; none if that was not counted.
    pub vanished_cells: Option<usize>,
}

/// Where the faces of an arrangement in space come from.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SpatialArrangementProvenance {
    /// The names of the inputs.
    pub files: Vec<String>,
    /// For each face its sources: the input, the polygon in it, and 1 or -1 where that runs with the face or against it.
    pub faces: Vec<Vec<[i64; 3]>>,
    /// With `--method congruence` for each vertex the polygons whose pieces became it: the input and the polygon in it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertices: Option<Vec<Vec<[u32; 2]>>>,
    /// With `--method congruence` the same for each edge.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<Vec<Vec<[u32; 2]>>>,
}
