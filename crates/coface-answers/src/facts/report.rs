//! The report as data.

use super::{Moment, Problem};
use crate::answer::Remark;
use coface_complexes::surface::{SurfaceComponent, SurfaceType};
use coface_geometry::MassProperties;
use coface_io::{CellData, Group, GroupKind};
use coface_topology::AbelianGroup;
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
    pub fn kind(&self) -> &'static str {
        self.kind
    }

    /// The cells, each by its vertices.
    pub fn cells(&self) -> &[Vec<u32>] {
        &self.cells
    }

    /// One sentence for people.
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
    pub(crate) is_simple: bool,
}

impl BoundaryPart {
    /// Its vertices: in order along a simple loop, else rising.
    pub fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    /// The number of its edges.
    pub fn edge_count(&self) -> usize {
        self.edge_count
    }

    /// Whether it is one simple loop, as on a surface, and not several that run together.
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
    pub fn face_count(&self) -> usize {
        self.face_count
    }

    /// The number of its connected components.
    pub fn components(&self) -> usize {
        self.components
    }

    /// Its vertices minus its edges plus its faces.
    pub fn euler_characteristic(&self) -> i64 {
        self.euler_characteristic
    }

    /// Whether it is a surface.
    pub fn is_manifold(&self) -> bool {
        self.is_manifold
    }

    /// The surface in words: `sphere`, `2 tori`; `None` where it is none.
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
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the numbers are on.
    pub fn kind(&self) -> GroupKind {
        self.kind
    }

    /// How many numbers each of these has.
    pub fn components(&self) -> usize {
        self.components
    }

    /// Whether the numbers are integers.
    pub fn is_integral(&self) -> bool {
        self.is_integral
    }

    /// The least and the largest number; `None` if there are none.
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
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the members are.
    pub fn kind(&self) -> GroupKind {
        self.kind
    }

    /// How many members it has.
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
    pub(crate) problems: Vec<Problem>,
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
            homology: Vec::new(),
            area: None,
            signed_volume: None,
            surface_centroid: None,
            mass: None,
            moments: Vec::new(),
            data: Vec::new(),
            groups: Vec::new(),
            permutations: Vec::new(),
            problems: Vec::new(),
            warnings: Vec::new(),
            remarks: Vec::new(),
        }
    }

    /// What sort of thing the model is.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The highest degree of a cell; `None` for the empty complex.
    pub fn dimension(&self) -> Option<usize> {
        self.f_vector.len().checked_sub(1)
    }

    /// The numbers of cells of degrees 0, 1, ... up to the dimension.
    pub fn f_vector(&self) -> &[usize] {
        &self.f_vector
    }

    /// How many top cells have which shape: `("triangle", 12)`.
    pub fn shapes(&self) -> &[(&'static str, usize)] {
        &self.shapes
    }

    /// Whether every cell is a face of a cell of the highest degree; `None` for a chain complex, where faces are not told.
    pub fn is_pure(&self) -> Option<bool> {
        self.pure
    }

    /// The number of connected components; an isolated vertex is one.
    pub fn components(&self) -> usize {
        self.components
    }

    /// The alternating sum of the numbers of cells.
    pub fn euler_characteristic(&self) -> i64 {
        self.euler_characteristic
    }

    /// Whether the model without its isolated vertices is a manifold, with or without boundary.
    pub fn manifold(&self) -> Answer {
        self.manifold
    }

    /// Whether no ridge lies in just one top cell: there is no boundary.
    pub fn is_closed(&self) -> Option<bool> {
        self.closed
    }

    /// Why the model is no manifold.
    pub fn witness(&self) -> Option<&Witness> {
        self.witness.as_ref()
    }

    /// The connected components of the graph of edges with just one face; `None` unless the dimension is 2.
    pub fn boundary_loops(&self) -> Option<&[BoundaryPart]> {
        self.boundary_loops.as_deref()
    }

    /// The boundary of a volume; `None` for everything else and where there is none.
    pub fn skin(&self) -> Option<&Skin> {
        self.skin.as_ref()
    }

    /// Whether the top cells can be oriented so that neighbors agree; `None` when a ridge lies in three of them.
    pub fn is_orientable(&self) -> Option<bool> {
        self.orientable
    }

    /// Whether neighboring top cells agree as the file gives them; `None` when a ridge lies in three of them, and for
    /// facet lists, whose simplices come without orientation.
    pub fn is_coherently_oriented(&self) -> Option<bool> {
        self.coherently_oriented
    }

    /// The type of the surface; `None` unless it is one connected surface.
    pub fn surface_type(&self) -> Option<SurfaceType> {
        self.surface_type
    }

    /// The components of a model of polygons, isolated vertices left out: counts, and which surface each is.
    pub fn surfaces(&self) -> &[SurfaceComponent] {
        &self.surfaces
    }

    /// The surface in words, each component named: `torus`, `5 spheres`; `None` if a component is no surface.
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// The integral homology of degrees 0, 1, ... up to the dimension.
    pub fn homology(&self) -> &[AbelianGroup] {
        &self.homology
    }

    /// The area of a surface: the sum over its faces, each counted once; `None` without positions.
    pub fn area(&self) -> Option<f64> {
        self.area
    }

    /// The volume that a closed, coherently oriented surface in space encloses, positive when its faces run
    /// counterclockwise seen from outside; the sum of the signed volumes of the cells of a volume mesh.
    pub fn signed_volume(&self) -> Option<f64> {
        self.signed_volume
    }

    /// The center of the area of a surface in space.
    pub fn surface_centroid(&self) -> Option<[f64; 3]> {
        self.surface_centroid
    }

    /// Volume, center and inertia of the solid of density 1 that a closed, coherently oriented surface in space encloses, or that
    /// the cells of a volume mesh fill, each with the sign of its volume; `None` where there is none or its volume is zero.
    pub fn mass(&self) -> Option<&MassProperties> {
        self.mass.as_ref()
    }

    /// The integrals of monomials that were asked for.
    pub fn moments(&self) -> &[Moment] {
        &self.moments
    }

    /// The named numbers on vertices, lines, polygons and cells.
    pub fn data(&self) -> &[DataSummary] {
        &self.data
    }

    /// The named sets of vertices, lines, polygons and cells, in the order of the file.
    pub fn groups(&self) -> &[GroupSummary] {
        &self.groups
    }

    /// What is wrong, and where.
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }

    /// What was odd, one sentence each: the reader's remarks, then the first sentence of each problem.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// The warnings with their codes, counts and first places.
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }
}
