//! Remarks: what was assumed, changed or left out on the way from a file to an answer.
//!
//! A reader that meets an ordinary oddity, such as a face that repeats a vertex, reads on and leaves a [`Remark`] in the model.
//! [`crate::ReadOptions::strict`] turns the first of them into an error.

use coface_algebra::Error;
use serde::{Deserialize, Serialize};

/// How many places a remark lists.
pub(crate) const LISTED_PLACES: usize = 5;

/// One thing worth knowing about an answer: what was assumed, changed or left out, how often, and where first.
///
/// # Examples
/// ```
/// use coface_io::{Place, Remark, RemarkCode};
/// let remark = Remark::new(RemarkCode::IsolatedVertex, "1 vertex is in no cell").at(1, [Place::cell(&[7])]);
/// assert_eq!(remark.places[0].cell.as_deref(), Some(&[7][..]));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Remark {
    /// What sort of remark it is, for programs.
    pub code: RemarkCode,
    /// The remark for people: one sentence.
    pub message: String,
    /// How many times it applies.
    pub count: u64,
    /// The first places where it applies; empty when it is about the whole input or the request.
    pub places: Vec<Place>,
}

impl Remark {
    /// A remark that applies once, to the whole.
    pub fn new(code: RemarkCode, message: impl Into<String>) -> Self {
        Self { code, message: message.into(), count: 1, places: Vec::new() }
    }

    /// The same remark with a count and the first of these places.
    pub fn at(mut self, count: usize, places: impl IntoIterator<Item = Place>) -> Self {
        self.count = count as u64;
        self.places = places.into_iter().take(LISTED_PLACES).collect();
        self
    }
}

/// The remark of partial reading: what stands before this fault was read.
pub(crate) fn partial(fault: &Error) -> Remark {
    let place = fault.line().map(Place::line);
    Remark::new(
        RemarkCode::PartialFile,
        format!("only what stands before a fault is read: {}", fault.message()),
    )
    .at(1, place)
}

/// Where a [`Remark`] applies. The fields that say nothing are `None` and absent from the JSON.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Place {
    /// The name of the input.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub file: Option<String>,
    /// A cell by its vertices, numbered from 0 in the order of the file.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub cell: Option<Vec<u32>>,
    /// A point, in the unit of the input.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub point: Option<Vec<f64>>,
    /// The line of the file, counted from 1.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub line: Option<u64>,
}

impl Place {
    /// The cell with these vertices.
    pub fn cell(vertices: &[u32]) -> Self {
        Self { cell: Some(vertices.to_vec()), ..Self::default() }
    }

    /// The line of a file, counted from 1.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_io::Place::line(3).line, Some(3));
    /// ```
    pub fn line(number: u64) -> Self {
        Self { line: Some(number), ..Self::default() }
    }

    /// The same place with its line in the file, counted from 1.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Place;
    /// let place = Place::cell(&[0, 1, 1]).on_line(7);
    /// assert_eq!((place.cell, place.line), (Some(vec![0, 1, 1]), Some(7)));
    /// ```
    pub fn on_line(mut self, number: u64) -> Self {
        self.line = Some(number);
        self
    }

    /// The input of this name.
    pub fn file(name: impl Into<String>) -> Self {
        Self { file: Some(name.into()), ..Self::default() }
    }

    /// The point with these coordinates.
    pub fn point(coordinates: &[f64]) -> Self {
        Self { point: Some(coordinates.to_vec()), ..Self::default() }
    }
}

impl RemarkCode {
    /// Whether the remark says that something was assumed, changed or left out on reading: what strict reading refuses.
    ///
    /// # Examples
    /// ```
    /// use coface_io::RemarkCode;
    /// assert!(RemarkCode::RepeatedVertex.is_assumption());
    /// assert!(!RemarkCode::NonmanifoldVertex.is_assumption(), "a finding, not an assumption");
    /// ```
    pub fn is_assumption(self) -> bool {
        use RemarkCode::*;
        matches!(
            self,
            InputReading
                | RepeatedVertex
                | CollapsedCell
                | CountsDiffer
                | PartialFile
                | UnknownSection
                | MissingEnd
                | TrailingContent
                | FractionalLabel
                | NonfiniteCoordinate
                | FormatByContent
                | SeveralModels
                | HigherOrder
                | SinglePoint
                | HeightsAssumed
                | ReferenceAssumed
                | ElementsLeftOut
                | CurvesFlattened
                | ArcsApproximated
                | SelfCrossingRing
                | UnclosedRing
                | NumbersRounded
                | ToleranceAssumed
                | FacesSplit
                | UnknownKey
                | DrawingAssumption
                | EmptyInput
                | UnnamedInput
        )
    }
}

/// What sort of remark a [`Remark`] is. The word in the JSON is the name in kebab case: `isolated-vertex`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum RemarkCode {
    /// Something was read in a way that no other code names.
    InputReading,
    /// A cell of the file repeats a vertex; the repetition was dropped.
    RepeatedVertex,
    /// A cell of the file has too few different vertices and was left out, or became a cell of lower dimension.
    CollapsedCell,
    /// A count in the file differs from what the file holds.
    CountsDiffer,
    /// The file has a fault, and what stands before it was read (`--partial`).
    PartialFile,
    /// A section or keyword of the file is not known and was passed over.
    UnknownSection,
    /// The file ends without the word that ends it.
    MissingEnd,
    /// The file goes on behind its end; that was left out.
    TrailingContent,
    /// A number of a group or label is written as a fraction and was taken as a whole number.
    FractionalLabel,
    /// A coordinate is not finite; measures that need it are left out.
    NonfiniteCoordinate,
    /// The name of the file states another format than its content, which decides.
    FormatByContent,
    /// The file holds several models, and one was taken, or all as one.
    SeveralModels,
    /// Elements of higher order were read by their corners.
    HigherOrder,
    /// A line or ring of a drawing is a single point and was kept as one.
    SinglePoint,
    /// Positions without a height were placed at height 0 among positions with heights.
    HeightsAssumed,
    /// Geometries or files without a reference system were taken to be in that of others.
    ReferenceAssumed,
    /// Heights of a drawing were left out.
    HeightsLeftOut,
    /// Elements of a drawing that are no lines or shapes were left out.
    ElementsLeftOut,
    /// Curves became chords.
    CurvesFlattened,
    /// Arcs became cubic curves.
    ArcsApproximated,
    /// A ring of a drawing crosses or touches itself, and what it encloses was decided by the rule of the format.
    SelfCrossingRing,
    /// A ring of a polygon does not end where it begins; it was closed.
    UnclosedRing,
    /// Polygons that are not flat were split.
    FacesSplit,
    /// A key of the file has no meaning here.
    UnknownKey,
    /// The order of curves was raised to a common one.
    OrderRaised,
    /// An edge of a surface or a face of a volume lies in more than two cells.
    NonmanifoldRidge,
    /// The cells around an edge of a volume form no single fan or ring.
    NonmanifoldEdge,
    /// The cells around a vertex form several fans.
    NonmanifoldVertex,
    /// Two neighboring cells are oriented against each other although another choice would agree.
    OrientationConflict,
    /// A closed chain of cells reverses the orientation.
    OneSidedChain,
    /// The file has a cell more than once.
    DuplicateCell,
    /// A vertex is in no cell.
    IsolatedVertex,
    /// Vertices of the boundary are at the very position of others there.
    CoincidentVertices,
    /// A cell of lower dimension is no face of a cell of the highest dimension.
    LooseCell,
    /// Faces in space cross, overlap, or are not as ISO 19107 asks; the message has its code.
    GeometryFault,
    /// A polygon of a drawing is not valid as OGC's Simple feature access says.
    InvalidPolygon,
    /// Cells of a chain complex are no balls: a face has several rims, or a cell voids or tunnels. The homology is that of the
    /// boundary matrices, not that of the space.
    CellsNotBalls,
    /// Cells have a negative volume: their vertices are listed inside out.
    NegativeVolume,
    /// The homology is that of the barycentric subdivision, because face classes are identified with themselves.
    SubdivisionCounted,
    /// Ideal vertices of a gluing table are cut off: the answer is about the manifold with boundary that is left.
    IdealVerticesCut,
    /// The format that was written does not keep something of the result.
    FormatKeepsLess,
    /// A step that makes the result shorter or nicer was left out because the input is large.
    StepLeftOut,
    /// Handles stay that were to be filled.
    HandlesLeft,
    /// A search ended early, so the best that it found need not be the best there is.
    SearchEnded,
    /// The name of a connected sum does not say how its summands are oriented to each other.
    SummandOrientations,
    /// The input has no positions, and each edge counts as length 1.
    UnitLengths,
    /// The weights asked for do not exist on this input, and uniform ones were taken.
    UniformWeights,
    /// The layout asked for does not exist on this input, and another one was taken.
    LayoutReplaced,
    /// Triangles of a layout are turned over or flat.
    TrianglesTurned,
    /// A surface is open, and what lies inside of it was decided in floating point.
    OpenInput,
    /// A file, object or group that is an input has no polygons or cells: it is the empty set.
    EmptyInput,
    /// Polygons or cells are in no object or group, and are one more input.
    UnnamedInput,
    /// The objects of a file could be inputs, each by itself, and are one input; or they are inputs because the file
    /// alone is too few.
    ObjectsInFile,
    /// A surface is inside out, wholly or in part.
    ReversedInput,
    /// A surface overlaps itself: it winds more than once around cells.
    OverlappingInput,
    /// Faces with holes or slits were written as triangles.
    FacesTriangulated,
    /// Segments beside polygons, or points, bound nothing and were left out.
    UnboundedSegments,
    /// A hole of a drawing is not inside of its outer ring; what is outside counts as empty.
    DrawingAssumption,
    /// Features do not have the properties by which they are united.
    PropertyMissing,
    /// Cells of an input that the answer is not about were left out.
    CellsLeftOut,
    /// Curves bound nothing, so the set has no boundary.
    EmptyBoundary,
    /// Coordinates were rounded, and the rounded result is not valid.
    RoundedInvalid,
    /// A model that is known exactly was taken with rounded points.
    PointsRounded,
    /// Integers that no double is equal to, or coordinates that a format of single precision cannot hold, were rounded.
    NumbersRounded,
    /// Pixels of an image have colors, and were taken as numbers.
    ColorsAsNumbers,
    /// Features that were nearly one were put together: within the tolerance asked for, or to make rounded coordinates valid.
    FeaturesJoined,
    /// Congruence was asked for without a tolerance; one was taken from the extent of the inputs.
    ToleranceAssumed,
    /// Cells are so thin that they are not meant, as a rule.
    ThinCells,
    /// An area or a length is beyond the range of numbers, or an area is so small that it is none of them.
    BeyondRange,
    /// Groups and data on cells were left out.
    DataLeftOut,
    /// Vertices of one block, a file or a connected component, were merged with each other.
    MergedWithinBlock,
    /// The boundary of a moving region was cut and pasted.
    TopologyRepaired,
    /// Curves of a moving region became shorter than three times the least distance of knots, or narrower than half of the distance of
    /// contacts that merge, and were left out.
    CurvesVanished,
    /// Parts of the boundary of a moving region came into contact, and were left as they are.
    ContactsKept,
    /// The distance of contacts is below the least distance of knots.
    ContactBelowKnots,
    /// A geometric decision could not be certified at the resolution of the arithmetic.
    DecisionUncertified,
    /// Edges or vertices were split, or faces turned, to make the model a manifold.
    ModelRepaired,
    /// Vertices of the result have other numbers than in the file.
    VerticesRenumbered,
    /// Parts of the scene were not drawn.
    NotDrawn,
    /// Something else was drawn than the model itself: the boundary of a volume.
    DrawnInstead,
    /// The model has no positions; places were found for its vertices.
    PositionsInvented,
    /// The rows of an earlier run were not taken.
    EarlierRunIgnored,
    /// A file could not be served and is a row of refusals.
    InputRefused,
}
