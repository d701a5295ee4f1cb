//! What `batch` answers: how many rows were written, and what each of them says.

use super::{
    BoundarySurface, CellsOfShape, DataAnswer, DrawnPolygonsAnswer, GeometryAnswer, HomologyGroup,
    InfoAnswer, ManifoldAnswer, MassAnswer, MomentAnswer, NamedGroup, ProblemAnswer, Remark, SurfaceAnswer,
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A table of reports.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BatchAnswer {
    /// The file that was written.
    pub output: String,
    /// The number of rows: of files, of models in files, or of lines of lists of signatures.
    pub files: usize,
    /// The numbers of rows that are errors, by kind.
    pub errors: BTreeMap<String, usize>,
    /// The number of rows taken from an earlier run that was cut short.
    pub resumed: usize,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

impl BatchAnswer {
    /// A table with no rows in this file.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::answer::BatchAnswer::new("rows.csv".to_owned()).output, "rows.csv");
    /// ```
    pub fn new(output: String) -> Self {
        Self { output, files: 0, errors: BTreeMap::new(), resumed: 0, remarks: Vec::new() }
    }

    /// The number of rows that are errors.
    ///
    /// # Examples
    /// ```
    /// let mut answer = coface_answers::answer::BatchAnswer::new("rows.csv".to_owned());
    /// answer.errors.insert("parse".to_owned(), 2);
    /// answer.errors.insert("time".to_owned(), 1);
    /// assert_eq!(answer.error_count(), 3);
    /// ```
    pub fn error_count(&self) -> usize {
        self.errors.values().sum()
    }
}

/// What a row of `batch` says of a file that could be read, beside its `path`, `bytes`, `seconds` and `error`: what `info` says of it. A
/// row has warnings, but no remarks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct RowAnswer {
    /// The name of the file, as the row has it in `path`.
    pub file: String,
    /// The format of the file, such as `off`.
    pub format: String,
    /// What sort of thing the model is: `complex`, `surface`, `volume` or `planar`.
    pub kind: String,
    /// The highest degree of a cell; `null` for the empty complex.
    pub dimension: Option<usize>,
    /// The numbers of cells of degrees 0, 1, ... up to the dimension.
    pub f_vector: Vec<usize>,
    /// How many cells of the highest degree have which shape.
    pub top_cells: Vec<CellsOfShape>,
    /// Whether every cell is a face of a cell of the highest degree; `null` for a chain complex.
    pub pure: Option<bool>,
    /// The number of connected components; an isolated vertex is one.
    pub components: usize,
    /// The alternating sum of the numbers of cells.
    pub euler_characteristic: i64,
    /// Whether the model without its isolated vertices is a manifold.
    pub manifold: ManifoldAnswer,
    /// The number of connected components of the graph of edges with one face; `null` unless the dimension is 2.
    pub boundary_loops: Option<usize>,
    /// The boundary of a volume; `null` for everything else and where there is none.
    pub boundary_surface: Option<BoundarySurface>,
    /// Whether the top cells can be oriented so that neighbors agree; `null` where one of their facets lies in three.
    pub orientable: Option<bool>,
    /// Whether neighboring top cells agree as the file gives them.
    pub coherently_oriented: Option<bool>,
    /// The genus of a connected surface; of a non-orientable one the number of cross-caps.
    pub genus: Option<usize>,
    /// The surface in words, such as `torus`, or the 3-manifold, such as `L(8,3)`, where it is proved which one it is, up to orientation (in a sum each summand up to one of its own); else `null`.
    pub name: Option<String>,
    /// What the name of a 3-manifold rests on: `layered_solid_tori`, `folded_tetrahedron`, `seifert_fibration`, `fibered_pieces`, `normal_spheres` or `fundamental_group`; absent without such a name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name_proof: Option<String>,
    /// The components of a model of polygons, isolated vertices left out.
    pub surfaces: Vec<SurfaceAnswer>,
    /// The integral homology of degrees 0, 1, ... up to the dimension.
    pub homology: Vec<HomologyGroup>,
    /// The area of a surface, in the square of the unit of the file; `null` without positions.
    pub area: Option<f64>,
    /// The enclosed volume, in the cube of the unit of the file, positive when faces run counterclockwise seen from outside.
    pub signed_volume: Option<f64>,
    /// The center of the area of a surface in space.
    pub surface_centroid: Option<[f64; 3]>,
    /// Volume, center and inertia of the solid of density 1 that the model encloses.
    pub mass: Option<MassAnswer>,
    /// The integrals of monomials that were asked for.
    pub moments: Vec<MomentAnswer>,
    /// The named numbers on vertices, lines, polygons and cells.
    pub data: Vec<DataAnswer>,
    /// The named sets of vertices, lines, polygons and cells.
    pub groups: Vec<NamedGroup>,
    /// What is wrong, and where.
    pub problems: Vec<ProblemAnswer>,
    /// Whether the faces are sound in space; `null` for what has no faces with coordinates.
    #[serde(default)]
    pub geometry: Option<GeometryAnswer>,
    /// Whether the polygons with rings of a drawing are valid; `null` for what has none, and where they were not checked.
    #[serde(default)]
    pub polygons: Option<DrawnPolygonsAnswer>,
    /// What was odd, one sentence each: the reader's remarks, then the first sentence of each problem.
    pub warnings: Vec<String>,
}

impl RowAnswer {
    /// The row of a file with this name, in this format, of which `info` says this.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Report, answer::RowAnswer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json)?;
    /// let row = RowAnswer::of("t.json", "json", Report::of(triangle)?.answer(10));
    /// assert_eq!((row.file.as_str(), row.f_vector), ("t.json", vec![3, 3, 1]));
    /// # Ok(()) }
    /// ```
    pub fn of(file: &str, format: &str, answer: InfoAnswer) -> Self {
        // All keys by name: a new one of `info` is one of rows, or left out here.
        let InfoAnswer {
            file: _,
            format: _,
            kind,
            dimension,
            f_vector,
            top_cells,
            pure,
            components,
            euler_characteristic,
            manifold,
            boundary_loops,
            boundary_surface,
            orientable,
            coherently_oriented,
            genus,
            name,
            name_proof,
            surfaces,
            homology,
            area,
            signed_volume,
            surface_centroid,
            mass,
            moments,
            data,
            groups,
            problems,
            geometry,
            warnings,
            polygons,
            halfedges: _,
            repair: _,
            reference_system: _,
            remarks: _,
        } = answer;
        Self {
            file: file.to_owned(),
            format: format.to_owned(),
            kind,
            dimension,
            f_vector,
            top_cells,
            pure,
            components,
            euler_characteristic,
            manifold,
            boundary_loops,
            boundary_surface,
            orientable,
            coherently_oriented,
            genus,
            name,
            name_proof,
            surfaces,
            homology,
            area,
            signed_volume,
            surface_centroid,
            mass,
            moments,
            data,
            groups,
            problems,
            geometry,
            polygons,
            warnings,
        }
    }
}
