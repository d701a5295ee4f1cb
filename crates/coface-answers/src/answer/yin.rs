//! What the verbs of `yin` answer: regular sets of the plane with curved boundaries.

use super::{Remark, YinEventAnswer};
use serde::{Deserialize, Serialize};

/// A set of the plane.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinSetAnswer {
    /// Whether it is the empty set.
    pub empty: bool,
    /// Whether it is the whole plane.
    pub plane: bool,
    /// Whether it is bounded.
    pub bounded: bool,
    /// The area, in the square of the unit of the file; null if it is infinite, or beyond the range of numbers, as a remark says then.
    pub area: Option<f64>,
    /// The length of all curves, in the unit of the file; null beyond the range of numbers, as a remark says then.
    pub perimeter: Option<f64>,
    /// The numbers of positive and of negative curves, and one more for an unbounded component, as the papers on Yin sets count.
    pub curve_counts: [usize; 2],
    /// The numbers of components and of holes of the set.
    pub betti_open: [usize; 2],
    /// The numbers of components and of holes of its closure.
    pub betti_closed: [usize; 2],
    /// The curves of the boundary.
    pub curves: Vec<YinCurve>,
    /// The order of its splines: 2 for polylines, 4 for cubics, 6, 8.
    pub order: usize,
    /// The curves of each component, the positive one first, if it has one.
    pub atoms: Vec<Vec<usize>>,
    /// The number of kinks.
    pub kinks: usize,
    /// The lower left and the upper right corner of the box around all curves; null without curves.
    pub bounding_box: Option<[[f64; 2]; 2]>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A curve of a boundary.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinCurve {
    /// 1 if it runs counterclockwise, -1 if it runs clockwise.
    pub sign: i32,
    /// The area that it encloses, with its sign; null beyond the range of numbers.
    pub area: Option<f64>,
    /// Its length, in the unit of the file; null beyond the range of numbers.
    pub length: Option<f64>,
    /// The number of its knots.
    pub knots: usize,
    /// The knots that are kinks, numbered from 0.
    pub kinks: Vec<u32>,
    /// The names of these kinks.
    pub vertices: Vec<u32>,
    /// The curve directly around it; null if there is none.
    pub parent: Option<usize>,
    /// The number of curves around it.
    pub depth: usize,
    /// Its name; null if it has none.
    pub name: Option<String>,
}

/// The answer of `yin info`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinInfoAnswer {
    /// The name of the file.
    pub file: String,
    /// The set.
    #[serde(flatten)]
    pub set: YinSetAnswer,
}

impl YinInfoAnswer {
    /// The set of a file.
    pub fn new(file: String, set: YinSetAnswer) -> Self {
        Self { file, set }
    }
}

/// The answer of `yin complement`, `meet`, `join`, `difference`, `xor` and `combine`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinCombinationAnswer {
    /// The names of the inputs.
    pub files: Vec<String>,
    /// The decisions that were taken without proof.
    pub uncertified: Vec<YinDecision>,
    /// What was nearer together than this may have been taken for one, in the unit of the files; 0 for sets of order 2.
    pub resolution: f64,
    /// How far the area is off at most.
    pub area_error: f64,
    /// The set.
    #[serde(flatten)]
    pub set: YinSetAnswer,
}

impl YinCombinationAnswer {
    /// A combination of sets of these files, with the resolution and the bound on the error of the area.
    pub fn new(
        files: Vec<String>,
        uncertified: Vec<YinDecision>,
        [resolution, area_error]: [f64; 2],
        set: YinSetAnswer,
    ) -> Self {
        Self { files, uncertified, resolution, area_error, set }
    }
}

/// A piece of an operand: `[operand, curve, piece, from, to]` with parameters in the unit interval, which fall where the result runs
/// against its source.
pub type YinPieceSource = (u32, u32, u32, f64, f64);

/// A decision of a combination that was taken without proof.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinDecision {
    /// Where.
    pub point: [f64; 2],
    /// The two pieces of operands that are so close.
    pub pieces: Vec<YinPieceSource>,
    /// What was assumed to be equal, in words.
    pub assumed: String,
}

/// Where the boundary of a combination comes from.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinProvenance {
    /// For each curve of the result the source of each of its pieces.
    pub sources: Vec<Vec<YinPieceSource>>,
}

/// The answer of `yin kinks`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinKinksAnswer {
    /// The name of the file.
    pub file: String,
    /// The kinks as a complex: one simplex for each, with its name.
    pub complex: Vec<[u32; 1]>,
    /// The kinks with their places.
    pub kink_points: Vec<YinKinkPoint>,
    /// The set.
    #[serde(flatten)]
    pub set: YinSetAnswer,
}

impl YinKinksAnswer {
    /// The kinks of the set of a file.
    pub fn new(file: String, kink_points: Vec<YinKinkPoint>, set: YinSetAnswer) -> Self {
        let complex = kink_points.iter().map(|kink| [kink.vertex]).collect();
        Self { file, complex, kink_points, set }
    }
}

/// A kink with its place.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinKinkPoint {
    /// Its name.
    pub vertex: u32,
    /// The curve that it is on.
    pub curve: u32,
    /// The knot of that curve.
    pub knot: u32,
    /// Its position.
    pub point: [f64; 2],
}

impl YinKinkPoint {
    /// The kink of this name at a knot of a curve.
    ///
    /// # Examples
    /// ```
    /// let kink = coface_answers::answer::YinKinkPoint::new(0, 1, 2, [0.5, 0.0]);
    /// assert_eq!((kink.curve, kink.knot), (1, 2));
    /// ```
    pub fn new(vertex: u32, curve: u32, knot: u32, point: [f64; 2]) -> Self {
        Self { vertex, curve, knot, point }
    }
}

/// The answer of `yin compare`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinComparisonAnswer {
    /// The names of the inputs.
    pub files: Vec<String>,
    /// The area of the symmetric difference; null if it is infinite.
    pub area_xor: Option<f64>,
    /// An estimate from above of how far that is off.
    pub area_xor_error: f64,
    /// The area of the first set less that of the second; null if it is infinite.
    pub area_signed: Option<f64>,
    /// How far that is off at most by rounding.
    pub area_signed_error: f64,
    /// The Hausdorff distance of the boundaries; null if one set alone has a boundary.
    pub hausdorff: Option<f64>,
    /// An estimate from above of how far that is off.
    pub hausdorff_error: f64,
    /// The greatest distance of the second boundary from the first along the normals of the first, up to twice the Hausdorff distance; null if
    /// no normal meets it so near.
    pub along_normals: Option<f64>,
    /// An estimate from above of how far that is off.
    pub along_normals_error: f64,
    /// The part of the places of the first boundary whose normals do not meet the second one so near.
    pub normals_left_out: f64,
    /// The greatest difference of the curvatures of both boundaries where normals meet, in the inverse of the unit; null if none does.
    pub curvature: Option<f64>,
    /// An estimate from above of how far that is off.
    pub curvature_error: f64,
    /// The number of components of each set.
    pub components: [usize; 2],
    /// The number of holes of each set.
    pub holes: [usize; 2],
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// The answer of `yin cut-cells`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinCutCellsAnswer {
    /// The name of the file.
    pub file: String,
    /// The grid.
    pub grid: GridAnswer,
    /// The number of cells inside of the set.
    pub full: usize,
    /// The number of cells that are partly in the set.
    pub cut: usize,
    /// The number of cells outside of the set.
    pub empty: usize,
    /// The area of the set in the grid.
    pub area: f64,
    /// The length of the boundary in the grid.
    pub length: f64,
    /// The area of the set; null if it is infinite.
    pub area_of_set: Option<f64>,
    /// The length of the boundary; null beyond the range of numbers.
    pub perimeter_of_set: Option<f64>,
    /// The cells that have some of the set or of its boundary, row by row; in files only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cells: Option<Vec<CutCellAnswer>>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A Cartesian grid.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct GridAnswer {
    /// Its lower left corner.
    pub origin: [f64; 2],
    /// The width and the height of its cells.
    pub spacing: [f64; 2],
    /// The numbers of columns and of rows.
    pub counts: [usize; 2],
}

/// How much of a cell is in a set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum CoverageAnswer {
    /// All of it.
    Full,
    /// Some of it.
    Cut,
    /// Nothing of it, though the boundary runs along it.
    Empty,
}

impl CoverageAnswer {
    /// The word in files.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::answer::CoverageAnswer::Full.word(), "full");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Cut => "cut",
            Self::Empty => "empty",
        }
    }
}

/// A cell of a grid that has some of a set or of its boundary.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CutCellAnswer {
    /// The column, from 0 at the left.
    pub column: usize,
    /// The row, from 0 at the bottom.
    pub row: usize,
    /// How much of the cell is in the set.
    pub coverage: CoverageAnswer,
    /// The area of the set in the cell.
    pub area: f64,
    /// The length of the boundary in the cell.
    pub length: f64,
}

/// The answer of `yin advect`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinAdvectAnswer {
    /// The name of the file.
    pub file: String,
    /// The time at the end.
    pub time: f64,
    /// The number of time steps.
    pub steps: usize,
    /// The order of the Runge-Kutta scheme.
    pub scheme: u32,
    /// The number of knots that were added.
    pub added: usize,
    /// The number of knots that were removed.
    pub removed: usize,
    /// The curves that became too short to be kept.
    pub vanished: Vec<VanishedAnswer>,
    /// The steps in which the boundary was cut and pasted.
    pub repairs: Vec<YinRepairAnswer>,
    /// The changes of the topology, by time; null if they were not looked for.
    pub events: Option<Vec<YinEventAnswer>>,
    /// How exactly the times of events are found; null if they were not looked for.
    pub event_tolerance: Option<f64>,
    /// The distance at which boundaries are in contact; null if contacts were not looked for.
    pub contact_distance: Option<f64>,
    /// The area at the beginning; null if it is infinite.
    pub area_before: Option<f64>,
    /// The files of the way, in the order of time.
    pub frames: Vec<String>,
    /// The set at the end.
    #[serde(flatten)]
    pub set: YinSetAnswer,
}

/// A curve that vanished.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct VanishedAnswer {
    /// When it vanished.
    pub time: f64,
    /// Its number at the beginning.
    pub curve: u32,
}

/// A step in which a boundary that met itself was cut and pasted.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinRepairAnswer {
    /// The step, counted from the beginning.
    pub step: usize,
    /// The time.
    pub time: f64,
    /// What was wrong, in words.
    pub fault: String,
}
