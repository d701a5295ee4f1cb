//! The report as data.

use super::{DrawnPolygons, GeometryFacts, Moment, Problem};
use crate::answer::HalfedgePointers;
use crate::answer::Remark;
use coface_complexes::surface::{SurfaceComponent, SurfaceType};
use coface_geometry::MassProperties;
use coface_io::{CellData, Group, GroupKind, ReferenceSystem};
use coface_topology::{AbelianGroup, SpaceProof};
use std::fmt;

/// What sort of thing a model is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// Given by its cells alone: a facet list, a chain complex, points, lines in space.
    Complex,
    /// The top cells are polygons.
    Surface,
    /// The top cells are 3-cells: tetrahedra, hexahedra, wedges, pyramids; or voxels, of any dimension.
    Volume,
    /// Line segments or rings in the plane.
    Planar,
}

impl Kind {
    /// The word for programs and people.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::Kind::Surface.word(), "surface");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Self::Complex => "complex",
            Self::Surface => "surface",
            Self::Volume => "volume",
            Self::Planar => "planar",
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// The answer to a question that cannot always be decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Answer {
    /// It holds.
    Yes,
    /// It does not, and a witness shows it.
    No,
    /// Neither was shown.
    Unknown,
}

impl Answer {
    /// Yes, no, or unknown for `None`.
    pub(crate) fn of(answer: Option<bool>) -> Self {
        match answer {
            Some(true) => Self::Yes,
            Some(false) => Self::No,
            None => Self::Unknown,
        }
    }

    /// `yes`, `no` or `unknown`.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::Answer::Unknown.word(), "unknown");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Self::Yes => "yes",
            Self::No => "no",
            Self::Unknown => "unknown",
        }
    }
}

impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// Cells that show why a model is no manifold.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Witness {
    pub(crate) kind: &'static str,
    pub(crate) cells: Vec<Vec<u32>>,
    pub(crate) message: String,
}

impl Witness {
    /// A word for programs: what sort of witness this is.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let facets = coface_io::read(&b"[[0,1,2],[5]]"[..], coface_io::Format::Json)?;
    /// let report = coface_answers::Report::of(facets)?;
    /// assert_eq!(report.witness().map(|witness| witness.kind()), Some("not_pure"));
    /// # Ok(()) }
    /// ```
    pub fn kind(&self) -> &'static str {
        self.kind
    }

    /// The cells, each by its vertices.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let facets = coface_io::read(&b"[[0,1,2],[5]]"[..], coface_io::Format::Json)?;
    /// let report = coface_answers::Report::of(facets)?;
    /// assert_eq!(report.witness().map(|witness| witness.cells()), Some(&[vec![5]][..]));
    /// # Ok(()) }
    /// ```
    pub fn cells(&self) -> &[Vec<u32>] {
        &self.cells
    }

    /// One sentence for people.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let facets = coface_io::read(&b"[[0,1,2],[5]]"[..], coface_io::Format::Json)?;
    /// let report = coface_answers::Report::of(facets)?;
    /// assert!(report.witness().is_some_and(|witness| witness.message().starts_with("the facet [5] has dimension 0")));
    /// # Ok(()) }
    /// ```
    pub fn message(&self) -> &str {
        &self.message
    }
}

/// A connected component of the graph of edges that lie in one face only.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct BoundaryPart {
    pub(crate) vertices: Vec<u32>,
    pub(crate) edge_count: usize,
    pub(crate) walks: Vec<Vec<u32>>,
    pub(crate) is_simple: bool,
}

impl BoundaryPart {
    /// Its vertices: in order along a simple loop, else rising.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.boundary_loops().map(|loops| loops[0].vertices()), Some(&[0, 1, 2][..]));
    /// # Ok(()) }
    /// ```
    pub fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    /// The number of its edges.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.boundary_loops().map(|loops| loops[0].edge_count()), Some(3));
    /// # Ok(()) }
    /// ```
    pub fn edge_count(&self) -> usize {
        self.edge_count
    }

    /// The walks that its edges make: simple loops, whose first vertex is there again at the end, and paths between vertices where
    /// an odd number of its edges meet.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.boundary_loops().map(|loops| &loops[0].walks()[0][..]), Some(&[0, 1, 2, 0][..]));
    /// # Ok(()) }
    /// ```
    pub fn walks(&self) -> &[Vec<u32>] {
        &self.walks
    }

    /// Whether it is one simple loop, as on a surface, and not several that run together.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert!(report.boundary_loops().is_some_and(|loops| loops[0].is_simple()));
    /// # Ok(()) }
    /// ```
    pub fn is_simple(&self) -> bool {
        self.is_simple
    }
}

/// The boundary of a volume: the surface of the faces that lie in one cell only.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Skin {
    pub(crate) face_count: usize,
    pub(crate) components: usize,
    pub(crate) euler_characteristic: i64,
    pub(crate) is_manifold: bool,
    pub(crate) name: Option<String>,
}

impl Skin {
    /// The number of its faces.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\
    ///             Tetrahedra 1\n1 2 3 4 0\nEnd\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Medit)?)?;
    /// assert_eq!(report.skin().map(|skin| skin.face_count()), Some(4));
    /// # Ok(()) }
    /// ```
    pub fn face_count(&self) -> usize {
        self.face_count
    }

    /// The number of its connected components.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\
    ///             Tetrahedra 1\n1 2 3 4 0\nEnd\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Medit)?)?;
    /// assert_eq!(report.skin().map(|skin| skin.components()), Some(1));
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> usize {
        self.components
    }

    /// Its vertices minus its edges plus its faces.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\
    ///             Tetrahedra 1\n1 2 3 4 0\nEnd\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Medit)?)?;
    /// assert_eq!(report.skin().map(|skin| skin.euler_characteristic()), Some(4 - 6 + 4));
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        self.euler_characteristic
    }

    /// Whether it is a surface.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\
    ///             Tetrahedra 1\n1 2 3 4 0\nEnd\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Medit)?)?;
    /// assert!(report.skin().is_some_and(|skin| skin.is_manifold()));
    /// # Ok(()) }
    /// ```
    pub fn is_manifold(&self) -> bool {
        self.is_manifold
    }

    /// The surface in words: `sphere`, `2 tori`; `None` where it is none.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\
    ///             Tetrahedra 1\n1 2 3 4 0\nEnd\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Medit)?)?;
    /// assert_eq!(report.skin().and_then(|skin| skin.name()), Some("sphere"));
    /// # Ok(()) }
    /// ```
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }
}

/// What is said of named numbers on the vertices, lines, polygons or cells of a model.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DataSummary {
    name: String,
    kind: GroupKind,
    components: usize,
    is_integral: bool,
    range: Option<[f64; 2]>,
}

impl DataSummary {
    pub(crate) fn of(data: &CellData) -> Self {
        Self {
            name: data.name().to_owned(),
            kind: data.kind(),
            components: data.components(),
            is_integral: data.is_integral(),
            range: data.range(),
        }
    }

    /// The name.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n\
    ///             POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS height int 1\nLOOKUP_TABLE default\n5 2 7\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Vtk)?)?;
    /// assert_eq!(report.data()[0].name(), "height");
    /// # Ok(()) }
    /// ```
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the numbers are on.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n\
    ///             POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS height int 1\nLOOKUP_TABLE default\n5 2 7\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Vtk)?)?;
    /// assert_eq!(report.data()[0].kind(), coface_io::GroupKind::Vertices);
    /// # Ok(()) }
    /// ```
    pub fn kind(&self) -> GroupKind {
        self.kind
    }

    /// How many numbers each of these has.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n\
    ///             POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS height int 1\nLOOKUP_TABLE default\n5 2 7\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Vtk)?)?;
    /// assert_eq!(report.data()[0].components(), 1);
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> usize {
        self.components
    }

    /// Whether the numbers are integers.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n\
    ///             POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS height int 1\nLOOKUP_TABLE default\n5 2 7\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Vtk)?)?;
    /// assert!(report.data()[0].is_integral());
    /// # Ok(()) }
    /// ```
    pub fn is_integral(&self) -> bool {
        self.is_integral
    }

    /// The least and the largest number; `None` if there are none.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n\
    ///             POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS height int 1\nLOOKUP_TABLE default\n5 2 7\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Vtk)?)?;
    /// assert_eq!(report.data()[0].range(), Some([2.0, 7.0]));
    /// # Ok(()) }
    /// ```
    pub fn range(&self) -> Option<[f64; 2]> {
        self.range
    }
}

/// A named set of vertices, lines, polygons or cells of a model, such as an object of an OBJ or a solid of an STL.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct GroupSummary {
    name: String,
    kind: GroupKind,
    count: usize,
}

impl GroupSummary {
    pub(crate) fn of(group: &Group) -> Self {
        Self { name: group.name().to_owned(), kind: group.kind(), count: group.members().len() }
    }

    /// The name, or the number, that the file gives it.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "g left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Obj)?)?;
    /// assert_eq!(report.groups()[0].name(), "left");
    /// # Ok(()) }
    /// ```
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the members are.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "g left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Obj)?)?;
    /// assert_eq!(report.groups()[0].kind(), coface_io::GroupKind::Polygons);
    /// # Ok(()) }
    /// ```
    pub fn kind(&self) -> GroupKind {
        self.kind
    }

    /// How many members it has.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "g left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Obj)?)?;
    /// assert_eq!(report.groups()[0].count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn count(&self) -> usize {
        self.count
    }
}

/// Everything that `coface info` says about one model.
///
/// # Conventions
/// * Cells are counted as the cells of a complex: a polygon is one face, a face shared by two cells counts once, and so
///   does a cell that the file repeats (there is a warning then). Isolated vertices are vertices and components.
/// * A notion that does not apply is `None`.
/// * Lengths, areas and volumes are in the unit of the file.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Report {
    pub(crate) kind: Kind,
    pub(crate) f_vector: Vec<usize>,
    pub(crate) shapes: Vec<(&'static str, usize)>,
    pub(crate) pure: Option<bool>,
    pub(crate) components: usize,
    pub(crate) euler_characteristic: i64,
    pub(crate) manifold: Answer,
    pub(crate) closed: Option<bool>,
    pub(crate) witness: Option<Witness>,
    pub(crate) boundary_loops: Option<Vec<BoundaryPart>>,
    pub(crate) skin: Option<Skin>,
    pub(crate) orientable: Option<bool>,
    pub(crate) coherently_oriented: Option<bool>,
    pub(crate) surface_type: Option<SurfaceType>,
    pub(crate) surfaces: Vec<SurfaceComponent>,
    pub(crate) name: Option<String>,
    pub(crate) name_proof: Option<SpaceProof>,
    pub(crate) homology: Vec<AbelianGroup>,
    pub(crate) area: Option<f64>,
    pub(crate) signed_volume: Option<f64>,
    pub(crate) surface_centroid: Option<[f64; 3]>,
    pub(crate) mass: Option<MassProperties>,
    pub(crate) moments: Vec<Moment>,
    pub(crate) data: Vec<DataSummary>,
    pub(crate) groups: Vec<GroupSummary>,
    /// The permutations of the halfedges of a small surface in cycles: name, cycles, what the cycles are.
    pub(crate) permutations: Vec<[String; 3]>,
    /// What each halfedge of a small surface points to.
    pub(crate) pointers: Vec<HalfedgePointers>,
    pub(crate) problems: Vec<Problem>,
    pub(crate) geometry: Option<GeometryFacts>,
    pub(crate) drawn: Option<DrawnPolygons>,
    pub(crate) reference: Option<ReferenceSystem>,
    pub(crate) warnings: Vec<String>,
    pub(crate) remarks: Vec<Remark>,
}

impl Report {
    /// The report on the empty complex.
    pub(crate) fn of_nothing() -> Self {
        Self {
            kind: Kind::Complex,
            f_vector: Vec::new(),
            shapes: Vec::new(),
            pure: Some(true),
            components: 0,
            euler_characteristic: 0,
            manifold: Answer::Yes,
            closed: Some(true),
            witness: None,
            boundary_loops: None,
            skin: None,
            orientable: None,
            coherently_oriented: None,
            surface_type: None,
            surfaces: Vec::new(),
            name: None,
            name_proof: None,
            homology: Vec::new(),
            area: None,
            signed_volume: None,
            surface_centroid: None,
            mass: None,
            moments: Vec::new(),
            data: Vec::new(),
            groups: Vec::new(),
            permutations: Vec::new(),
            pointers: Vec::new(),
            problems: Vec::new(),
            geometry: None,
            drawn: None,
            reference: None,
            warnings: Vec::new(),
            remarks: Vec::new(),
        }
    }

    /// What sort of thing the model is.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.kind(), coface_answers::Kind::Surface);
    /// # Ok(()) }
    /// ```
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The highest degree of a cell; `None` for the empty complex.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.dimension(), Some(2));
    /// # Ok(()) }
    /// ```
    pub fn dimension(&self) -> Option<usize> {
        self.f_vector.len().checked_sub(1)
    }

    /// The numbers of cells of degrees 0, 1, ... up to the dimension.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> &[usize] {
        &self.f_vector
    }

    /// How many top cells have which shape: `("triangle", 12)`.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.shapes(), [("triangle", 1)]);
    /// # Ok(()) }
    /// ```
    pub fn shapes(&self) -> &[(&'static str, usize)] {
        &self.shapes
    }

    /// Whether every cell is a face of a cell of the highest degree; `None` for a chain complex, where faces are not told.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let facets = coface_io::read(&b"[[0,1,2],[5]]"[..], coface_io::Format::Json)?;
    /// let report = coface_answers::Report::of(facets)?;
    /// assert_eq!(report.is_pure(), Some(false));
    /// # Ok(()) }
    /// ```
    pub fn is_pure(&self) -> Option<bool> {
        self.pure
    }

    /// The number of connected components; an isolated vertex is one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.components(), 1);
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> usize {
        self.components
    }

    /// The alternating sum of the numbers of cells.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.euler_characteristic(), 3 - 3 + 1);
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        self.euler_characteristic
    }

    /// Whether the model without its isolated vertices is a manifold, with or without boundary.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let facets = coface_io::read(&b"[[0,1,2],[5]]"[..], coface_io::Format::Json)?;
    /// let report = coface_answers::Report::of(facets)?;
    /// assert_eq!(report.manifold(), coface_answers::Answer::No);
    /// # Ok(()) }
    /// ```
    pub fn manifold(&self) -> Answer {
        self.manifold
    }

    /// Whether no ridge lies in just one top cell: there is no boundary.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.is_closed(), Some(false));
    /// # Ok(()) }
    /// ```
    pub fn is_closed(&self) -> Option<bool> {
        self.closed
    }

    /// Why the model is no manifold.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let facets = coface_io::read(&b"[[0,1,2],[5]]"[..], coface_io::Format::Json)?;
    /// let report = coface_answers::Report::of(facets)?;
    /// assert!(report.witness().is_some());
    /// # Ok(()) }
    /// ```
    pub fn witness(&self) -> Option<&Witness> {
        self.witness.as_ref()
    }

    /// The connected components of the graph of edges with just one face; `None` unless the dimension is 2.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.boundary_loops().map(|loops| loops.len()), Some(1));
    /// # Ok(()) }
    /// ```
    pub fn boundary_loops(&self) -> Option<&[BoundaryPart]> {
        self.boundary_loops.as_deref()
    }

    /// What each halfedge of a surface of at most 60 halfedges points to, as the file numbers them; empty for other models.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &br#"{"next": [1, 2, 0], "twin": [null, null, null]}"#[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Json)?)?;
    /// assert_eq!((report.halfedges()[0].twin, report.halfedges()[3].outer), (3, true));
    /// # Ok(()) }
    /// ```
    pub fn halfedges(&self) -> &[HalfedgePointers] {
        &self.pointers
    }

    /// The boundary of a volume; `None` for everything else and where there is none.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\
    ///             Tetrahedra 1\n1 2 3 4 0\nEnd\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Medit)?)?;
    /// assert_eq!(report.skin().map(|skin| skin.face_count()), Some(4));
    /// # Ok(()) }
    /// ```
    pub fn skin(&self) -> Option<&Skin> {
        self.skin.as_ref()
    }

    /// Whether the top cells can be oriented so that neighbors agree; `None` when a ridge lies in three of them.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.is_orientable(), Some(true));
    /// # Ok(()) }
    /// ```
    pub fn is_orientable(&self) -> Option<bool> {
        self.orientable
    }

    /// Whether neighboring top cells agree as the file gives them; `None` when a ridge lies in three of them, and for
    /// facet lists, whose simplices come without orientation.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.is_coherently_oriented(), Some(true));
    /// # Ok(()) }
    /// ```
    pub fn is_coherently_oriented(&self) -> Option<bool> {
        self.coherently_oriented
    }

    /// The type of the surface; `None` unless it is one connected surface.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.surface_type().map(|surface| surface.to_string()), Some("disk".to_owned()));
    /// # Ok(()) }
    /// ```
    pub fn surface_type(&self) -> Option<SurfaceType> {
        self.surface_type
    }

    /// The components of a model of polygons, isolated vertices left out: counts, and which surface each is.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.surfaces().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn surfaces(&self) -> &[SurfaceComponent] {
        &self.surfaces
    }

    /// The surface in words, each component named: `torus`, `5 spheres`; `None` if a component is no surface.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.name(), Some("disk"));
    /// # Ok(()) }
    /// ```
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// What the name of a 3-manifold rests on.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let report = coface_answers::Report::of(coface_io::isosig::read(&b"cMcabbjqs"[..])?)?;
    /// assert_eq!(report.name(), Some("L(8,3)"));
    /// assert_eq!(report.name_proof(), Some(coface_topology::SpaceProof::LayeredSolidTori));
    /// # Ok(()) }
    /// ```
    pub fn name_proof(&self) -> Option<SpaceProof> {
        self.name_proof
    }

    /// The integral homology of degrees 0, 1, ... up to the dimension.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.homology().iter().map(|group| group.betti()).collect::<Vec<_>>(), [1, 0, 0]);
    /// # Ok(()) }
    /// ```
    pub fn homology(&self) -> &[AbelianGroup] {
        &self.homology
    }

    /// The area of a surface: the sum over its faces, each counted once; `None` without positions.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.area(), Some(6.0));
    /// # Ok(()) }
    /// ```
    pub fn area(&self) -> Option<f64> {
        self.area
    }

    /// The volume that a closed, coherently oriented surface in space encloses, positive when its faces run
    /// counterclockwise seen from outside; the sum of the signed volumes of the cells of a volume mesh.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A tetrahedron of volume 1 with its corner at the origin.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Obj)?)?;
    /// assert_eq!(report.signed_volume(), Some(1.0));
    /// # Ok(()) }
    /// ```
    pub fn signed_volume(&self) -> Option<f64> {
        self.signed_volume
    }

    /// The center of the area of a surface in space.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert_eq!(report.surface_centroid().map(|center| center[2]), Some(0.0));
    /// # Ok(()) }
    /// ```
    pub fn surface_centroid(&self) -> Option<[f64; 3]> {
        self.surface_centroid
    }

    /// Volume, center and inertia of the solid of density 1 that a closed, coherently oriented surface in space encloses, or that
    /// the cells of a volume mesh fill, each with the sign of its volume; `None` where there is none or its volume is zero.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A tetrahedron of volume 1 with its corner at the origin.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Obj)?)?;
    /// assert_eq!(report.mass().map(|mass| mass.volume()), Some(1.0));
    /// # Ok(()) }
    /// ```
    pub fn mass(&self) -> Option<&MassProperties> {
        self.mass.as_ref()
    }

    /// The integrals of monomials that were asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A tetrahedron of volume 1 with its corner at the origin.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let report = coface_answers::Report::with_moments(solid, &[[0, 0, 0]])?;
    /// assert_eq!(report.moments().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn moments(&self) -> &[Moment] {
        &self.moments
    }

    /// The named numbers on vertices, lines, polygons and cells.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n\
    ///             POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS height int 1\nLOOKUP_TABLE default\n5 2 7\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Vtk)?)?;
    /// assert_eq!(report.data().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn data(&self) -> &[DataSummary] {
        &self.data
    }

    /// The named sets of vertices, lines, polygons and cells, in the order of the file.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "g left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    /// let report = coface_answers::Report::of(coface_io::read(text.as_bytes(), coface_io::Format::Obj)?)?;
    /// assert_eq!(report.groups().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn groups(&self) -> &[GroupSummary] {
        &self.groups
    }

    /// What is wrong, and where.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert!(report.problems().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }

    /// What is wrong with faces in space; `None` for what has no faces with coordinates.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let facets = coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json)?;
    /// assert_eq!(coface_answers::Report::of(facets)?.geometry(), None);
    /// # Ok(()) }
    /// ```
    pub fn geometry(&self) -> Option<&GeometryFacts> {
        self.geometry.as_ref()
    }

    /// What is wrong with the polygons with rings of a drawing; `None` for what has none, and where they were not checked.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = coface_io::read(&b"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"[..], coface_io::Format::Wkt)?;
    /// assert!(coface_answers::Report::of(square)?.drawn_polygons().is_some_and(|found| found.faults().is_empty()));
    /// # Ok(()) }
    /// ```
    pub fn drawn_polygons(&self) -> Option<&DrawnPolygons> {
        self.drawn.as_ref()
    }

    /// What was odd, one sentence each: the reader's remarks, then the first sentence of each problem.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert!(report.warnings().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// The warnings with their codes, counts and first places.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
    /// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
    /// assert!(report.remarks().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }
}
