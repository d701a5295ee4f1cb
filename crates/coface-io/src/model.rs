//! What a file held.

use super::numbers::Numbers;
use super::volume::VoxelFrame;
use super::{CellData, FeatureTable, Format, Group, GroupKind, ReferenceSystem};
use crate::oddities::Oddities;
use crate::{Remark, StatedSurfaces};
use coface_algebra::RaggedArray;
use coface_algebra::chains::{ChainComplex, ChainRefinement};
use coface_algebra::{Error, VertexId};
use coface_arrange::planar::ExactSegments;
use coface_arrange::spatial::ExactPolygons;
use coface_complexes::cell_mesh::CellShape;
use coface_complexes::cubical::CubicalVolume;
use coface_complexes::gluing::GluingTable;
use coface_complexes::surface::HalfedgePermutations;
use coface_geometry::{PartialPositions, Positions};
use std::sync::Arc;

/// What a file held: vertices with or without positions, polygons, 3-cells, lines, points, named groups, named data, or
/// an abstract [`Structure`] instead of all these.
///
/// Every index is below the vertex count, and no polygon or cell repeats a vertex: the readers, and [`Model::check`], see to it.
/// Vertices that nothing uses are kept: they are isolated vertices. [`Model::positions`] are finite: where a file has a coordinate
/// that is NaN or infinite, they are empty, and [`Model::partial_positions`] has those of the other vertices.
///
/// Two models are equal when they hold the same; the format they came from and the remarks do not matter.
#[derive(Clone, Debug, Default)]
pub struct Model {
    pub(crate) format: Option<Format>,
    pub(crate) vertex_count: usize,
    pub(crate) positions: Positions,
    pub(crate) partial_positions: Option<PartialPositions>,
    pub(crate) polygons: RaggedArray,
    pub(crate) shapes: Vec<CellShape>,
    pub(crate) cells: RaggedArray,
    pub(crate) lines: RaggedArray,
    pub(crate) points: Vec<VertexId>,
    pub(crate) groups: Vec<Group>,
    pub(crate) data: Vec<CellData>,
    pub(crate) structure: Option<Structure>,
    pub(crate) refinement: Option<ChainRefinement>,
    pub(crate) exact: Option<Arc<ExactPolygons>>,
    pub(crate) exact_segments: Option<Arc<ExactSegments>>,
    pub(crate) stated: Option<Arc<StatedSurfaces>>,
    /// The oddities that the reader met, which are among the remarks.
    pub(crate) oddities: Option<Arc<Oddities>>,
    pub(crate) features: FeatureTable,
    pub(crate) reference: Option<ReferenceSystem>,
    pub(crate) remarks: Vec<Remark>,
    pub(crate) is_pseudomanifold: bool,
    /// What the file has beside, and what is not read of it.
    pub(crate) unread: Vec<(&'static str, usize)>,
    /// Where the voxels of a volume are.
    pub(crate) frame: Option<VoxelFrame>,
}

/// Everything that a [`Model`] is made of but the features of a map, for the crates that build one piece by piece.
#[doc(hidden)]
#[derive(Clone, Debug, Default)]
pub struct ModelParts {
    pub format: Option<Format>,
    pub vertex_count: usize,
    pub positions: Positions,
    pub partial_positions: Option<PartialPositions>,
    pub polygons: RaggedArray,
    pub shapes: Vec<CellShape>,
    pub cells: RaggedArray,
    pub lines: RaggedArray,
    pub points: Vec<VertexId>,
    pub groups: Vec<Group>,
    pub data: Vec<CellData>,
    pub structure: Option<Structure>,
    pub remarks: Vec<Remark>,
    pub is_pseudomanifold: bool,
    pub frame: Option<VoxelFrame>,
}

impl ModelParts {
    /// The model of these parts, which are known to be those that [`Model::check`] accepts.
    pub fn into_model(self) -> Model {
        let Self {
            format,
            vertex_count,
            positions,
            partial_positions,
            polygons,
            shapes,
            cells,
            lines,
            points,
            groups,
            data,
            structure,
            remarks,
            is_pseudomanifold,
            frame,
        } = self;
        Model {
            format,
            vertex_count,
            positions,
            partial_positions,
            polygons,
            shapes,
            cells,
            lines,
            points,
            groups,
            data,
            structure,
            remarks,
            refinement: None,
            exact: None,
            exact_segments: None,
            stated: None,
            oddities: None,
            features: FeatureTable::default(),
            reference: None,
            is_pseudomanifold,
            unread: Vec::new(),
            frame,
        }
    }
}

/// An abstract structure that a file can hold instead of vertices, polygons and cells.
#[derive(Clone, Debug, PartialEq)]
pub enum Structure {
    /// Simplices of any dimension by their vertices; all faces are meant to be there too.
    Facets(RaggedArray),
    /// A surface as two permutations of its halfedges `0..next.len()`. Vertices are the orbits of "twin, then next", faces
    /// those of `next`, both numbered by their smallest halfedges.
    Halfedges {
        /// The next halfedge around the face.
        next: Vec<u32>,
        /// The other halfedge of the edge.
        twin: Vec<u32>,
        /// The faces that are outer: they fill the boundary loops.
        outer: Vec<u32>,
    },
    /// Boundary matrices.
    Chains(ChainComplex),
    /// Simplices with facets glued in pairs.
    Gluings(GluingTable),
    /// Voxels that are set, with their faces.
    Volume(CubicalVolume),
}

impl Model {
    /// A model of polygons on these positions.
    ///
    /// # Errors
    /// Those of [`Self::check`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_geometry::Positions;
    /// use coface_io::Model;
    /// let positions = Positions::from_flat(2, vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0])?;
    /// assert!(Model::from_polygons(positions.clone(), RaggedArray::from_lists([[0, 1, 2]])).is_ok());
    /// assert!(Model::from_polygons(positions, RaggedArray::from_lists([[0, 1, 3]])).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn from_polygons(positions: Positions, polygons: RaggedArray) -> Result<Self, Error> {
        let model = Self { vertex_count: positions.len(), positions, polygons, ..Self::default() };
        model.check()?;
        Ok(model)
    }

    /// A model of 3-cells on these positions: cell i has the shape `shapes[i]` and the vertices `cells.list(i)`.
    ///
    /// # Errors
    /// Those of [`Self::check`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::CellShape;
    /// use coface_geometry::Positions;
    /// use coface_io::Model;
    /// let corners = vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.];
    /// let cells = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let model = Model::from_cells(Positions::from_flat(3, corners)?, vec![CellShape::Tetrahedron], cells)?;
    /// assert_eq!(model.cells().len(), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn from_cells(
        positions: Positions,
        shapes: Vec<CellShape>,
        cells: RaggedArray,
    ) -> Result<Self, Error> {
        let model = Self { vertex_count: positions.len(), positions, shapes, cells, ..Self::default() };
        model.check()?;
        Ok(model)
    }

    /// A model of everything that has vertices: polygons, 3-cells of these shapes, polylines and single points. Without positions only
    /// numbers are known.
    ///
    /// # Errors
    /// Those of [`Self::check`].
    ///
    /// # Examples
    /// A triangle and a segment without positions.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_geometry::Positions;
    /// use coface_io::Model;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (triangle, segment) = (RaggedArray::from_lists([[0, 1, 2]]), RaggedArray::from_lists([[2, 3]]));
    /// let solids = (Vec::new(), RaggedArray::new());
    /// let model = Model::from_parts(4, Positions::default(), triangle, solids, segment, Vec::new())?;
    /// assert_eq!((model.vertex_count(), model.lines().len()), (4, 1));
    /// # Ok(()) }
    /// ```
    pub fn from_parts(
        vertex_count: usize,
        positions: Positions,
        polygons: RaggedArray,
        (shapes, cells): (Vec<CellShape>, RaggedArray),
        lines: RaggedArray,
        points: Vec<VertexId>,
    ) -> Result<Self, Error> {
        let model =
            Self { vertex_count, positions, polygons, shapes, cells, lines, points, ..Self::default() };
        model.check()?;
        Ok(model)
    }

    /// A model of polylines on these positions; a closed line has its first vertex again at its end.
    ///
    /// # Errors
    /// Those of [`Self::check`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_geometry::Positions;
    /// use coface_io::Model;
    /// let positions = Positions::from_flat(2, vec![0.0, 0.0, 1.0, 0.0])?;
    /// assert_eq!(Model::from_lines(positions, RaggedArray::from_lists([[0, 1]]))?.lines().len(), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn from_lines(positions: Positions, lines: RaggedArray) -> Result<Self, Error> {
        let model = Self { vertex_count: positions.len(), positions, lines, ..Self::default() };
        model.check()?;
        Ok(model)
    }

    /// The model with these polylines instead of its own; data on those, groups of them and features go.
    ///
    /// # Errors
    /// Those of [`Self::check`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_io as io;
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// let model = triangle.with_lines(RaggedArray::from_lists([[0, 1, 2, 0]]))?;
    /// assert_eq!((model.lines().len(), model.polygons().len()), (1, 1));
    /// # Ok(()) }
    /// ```
    pub fn with_lines(mut self, lines: RaggedArray) -> Result<Self, Error> {
        self.lines = lines;
        self.data.retain(|data| data.kind() != GroupKind::Lines);
        self.groups.retain(|group| group.kind() != GroupKind::Lines);
        self.features = FeatureTable::default();
        self.check()?;
        Ok(self)
    }

    /// The model with one more group.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] if a member is none of the model.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::{Format, Group, GroupKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// let model = triangle.with_group(Group::new("rim", GroupKind::Polygons, vec![0]))?;
    /// assert_eq!(model.groups()[0].name(), "rim");
    /// assert!(model.with_group(Group::new("far", GroupKind::Polygons, vec![1])).is_err());
    /// # Ok(()) }
    /// ```
    pub fn with_group(mut self, group: Group) -> Result<Self, Error> {
        let count = self.count_of(group.kind);
        if let Some(member) = group.members.iter().find(|&&member| member as usize >= count) {
            return Err(Error::invalid(format!(
                "the group \"{}\" has the member {member}, but there are {count} {}",
                group.name, group.kind
            )));
        }
        self.groups.push(group);
        Ok(self)
    }

    /// The model with one more array of numbers.
    ///
    /// # Errors
    /// Those of [`Self::check`].
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::{CellData, Format, GroupKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// let model = triangle.with_data(CellData::reals("x", GroupKind::Vertices, 1, vec![0.0, 1.0, 0.0])?)?;
    /// assert!(model.with_data(CellData::reals("y", GroupKind::Polygons, 1, vec![0.0, 1.0])?).is_err());
    /// # Ok(()) }
    /// ```
    pub fn with_data(mut self, data: CellData) -> Result<Self, Error> {
        self.check_data(&data, &self.data)?;
        self.data.push(data);
        Ok(self)
    }

    /// The model without the array of this name on vertices, lines, polygons or cells, if there is one.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::{CellData, Format, GroupKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let point = io::read(&b"v 0 0 0\np 1\n"[..], Format::Obj)?;
    /// let model = point.with_data(CellData::reals("x", GroupKind::Vertices, 1, vec![0.5])?)?;
    /// assert!(model.without_data("x", GroupKind::Vertices).data().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn without_data(mut self, name: &str, kind: GroupKind) -> Self {
        self.data.retain(|data| data.kind() != kind || data.name() != name);
        self
    }

    /// A model that is an abstract structure.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_io::{Model, Structure};
    /// let model = Model::from_structure(Structure::Facets(RaggedArray::from_lists([[0, 1, 2]])));
    /// assert!(model.structure().is_some() && model.polygons().is_empty());
    /// ```
    pub fn from_structure(structure: Structure) -> Self {
        Self { structure: Some(structure), ..Self::default() }
    }

    /// The same model, with the ideal vertices of a gluing table as points of its space, which is a pseudomanifold then. Otherwise questions
    /// are about the manifold with boundary that is left when they are cut off. Files do not keep this.
    ///
    /// # Examples
    /// ```
    /// use coface_io::isosig;
    /// let knot = isosig::read(&b"cPcbbbiht"[..])?;
    /// assert!(!knot.is_pseudomanifold() && knot.as_pseudomanifold(true).is_pseudomanifold());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn as_pseudomanifold(mut self, is_pseudomanifold: bool) -> Self {
        self.is_pseudomanifold = is_pseudomanifold;
        self
    }

    /// Whether the ideal vertices of a gluing table are points of its space: see [`Self::as_pseudomanifold`].
    ///
    /// # Examples
    /// ```
    /// assert!(!coface_io::Model::default().is_pseudomanifold());
    /// ```
    pub fn is_pseudomanifold(&self) -> bool {
        self.is_pseudomanifold
    }

    /// A chain complex whose cells of degree 0 are at these positions.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] unless there are as many positions as cells of degree 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_geometry::Positions;
    /// use coface_io::Model;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ends = Positions::from_flat(1, vec![0.0, 1.0])?;
    /// assert_eq!(Model::from_chains(ChainComplex::of_points(2), ends.clone())?.vertex_count(), 2);
    /// assert!(Model::from_chains(ChainComplex::of_points(3), ends).is_err());
    /// # Ok(()) }
    /// ```
    pub fn from_chains(complex: ChainComplex, positions: Positions) -> Result<Self, Error> {
        let (points, vertices) = (positions.len(), complex.cell_count(0));
        if points != vertices {
            return Err(Error::invalid(format!("there are {points} points for {vertices} vertices"))
                .with_cure("give each cell of degree 0 one point"));
        }
        let structure = Some(Structure::Chains(complex));
        Ok(Self { vertex_count: points, positions, structure, ..Self::default() })
    }

    /// A surface of halfedges, with the positions of its vertices, or none.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] unless there are as many positions as vertices, or none.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgePermutations;
    /// use coface_geometry::Positions;
    /// use coface_io::Model;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = || HalfedgePermutations::with_boundary(&[1, 2, 0], &[None; 3]);
    /// let corners = Positions::from_flat(2, vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0])?;
    /// assert_eq!(Model::from_halfedges(triangle()?, corners)?.vertex_count(), 3);
    /// assert!(Model::from_halfedges(triangle()?, Positions::from_flat(1, vec![0.0])?).is_err());
    /// # Ok(()) }
    /// ```
    pub fn from_halfedges(permutations: HalfedgePermutations, positions: Positions) -> Result<Self, Error> {
        let points = positions.len();
        if !positions.is_empty() {
            let vertices = permutations.mesh()?.vertex_count();
            if points != vertices {
                return Err(Error::invalid(format!("there are {points} points for {vertices} vertices"))
                    .with_cure("give each orbit of \"twin, then next\" one point"));
            }
        }
        let (next, twin, outer) = permutations.into_parts();
        let structure = Some(Structure::Halfedges { next, twin, outer });
        Ok(Self { vertex_count: points, positions, structure, ..Self::default() })
    }

    /// Verifies that every index is below the vertex count, that polygons have at least three vertices, lines at least
    /// two, cells as many as their shape, that none repeats a vertex (a line may return to one), that there are as
    /// many positions as vertices, or none, and rows of data as things that they are on, with no name twice; and that
    /// features, where there are any, are those of all lines and points.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] naming the first culprit.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert!(model.check().is_ok());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn check(&self) -> Result<(), Error> {
        if self.positions.dimension() > 0 && self.positions.len() != self.vertex_count {
            return Err(Error::invalid(format!(
                "{} positions for {} vertices",
                self.positions.len(),
                self.vertex_count
            )));
        }
        if let Some(partial) = &self.partial_positions
            && (partial.len() != self.vertex_count || self.positions.dimension() > 0)
        {
            return Err(Error::invalid(format!(
                "{} positions, not all of them finite, for {} vertices",
                partial.len(),
                self.vertex_count
            )));
        }
        if self.shapes.len() != self.cells.len() {
            return Err(Error::invalid(format!(
                "{} shapes for {} cells",
                self.shapes.len(),
                self.cells.len()
            )));
        }
        for (i, polygon) in self.polygons.iter().enumerate() {
            self.check_vertices("polygon", i, polygon)?;
            check_size("polygon", i, polygon, 3)?;
        }
        for (i, (cell, shape)) in self.cells.iter().zip(&self.shapes).enumerate() {
            self.check_vertices(shape.name(), i, cell)?;
            if cell.len() != shape.vertex_count() {
                return Err(Error::invalid(format!(
                    "cell {i}, a {}, has {} vertices",
                    shape.name(),
                    cell.len()
                )));
            }
        }
        for (i, line) in self.lines.iter().enumerate() {
            for &vertex in line {
                self.check_vertex("line", i, vertex)?;
            }
            check_size("line", i, line, 2)?;
            if let Some(pair) = line.windows(2).find(|pair| pair[0] == pair[1]) {
                return Err(Error::invalid(format!("line {i} repeats vertex {}", pair[0])));
            }
        }
        for (i, vertex) in self.points.iter().enumerate() {
            self.check_vertex("point", i, vertex.to_u32())?;
        }
        for (i, data) in self.data.iter().enumerate() {
            self.check_data(data, &self.data[..i])?;
        }
        if !self.features.fits(self.lines.len(), self.points.len(), self.polygons.len()) {
            return Err(Error::invalid("the features of the model are not those of its lines and points"));
        }
        Ok(())
    }

    /// That data have a row for each thing that they are on, and not the name of others on the same.
    fn check_data(&self, data: &CellData, others: &[CellData]) -> Result<(), Error> {
        let (name, kind) = (data.name(), data.kind());
        let count = self.count_of(kind);
        if data.len() != count {
            let message = format!("the data \"{name}\" on {kind} have {} rows, not {count}", data.len());
            return Err(Error::invalid(message).with_cure("give each of them one row"));
        }
        if others.iter().any(|other| other.kind() == kind && other.name() == name) {
            return Err(Error::invalid(format!("there are two arrays \"{name}\" on {kind}"))
                .with_cure("rename one of them"));
        }
        Ok(())
    }

    /// The number of vertices, lines, polygons or 3-cells.
    #[doc(hidden)]
    pub fn count_of(&self, kind: GroupKind) -> usize {
        match kind {
            GroupKind::Vertices => self.vertex_count,
            GroupKind::Lines => self.lines.len(),
            GroupKind::Polygons => self.polygons.len(),
            GroupKind::Cells => self.cells.len(),
        }
    }

    fn check_vertices(&self, what: &str, i: usize, vertices: &[u32]) -> Result<(), Error> {
        for &vertex in vertices {
            self.check_vertex(what, i, vertex)?;
        }
        if let Some(vertex) = repeated_vertex(vertices) {
            return Err(Error::invalid(format!("{what} {i} repeats vertex {vertex}"))
                .with_cure("remove it, or leave the repeated vertex out"));
        }
        Ok(())
    }

    fn check_vertex(&self, what: &str, i: usize, vertex: u32) -> Result<(), Error> {
        if (vertex as usize) < self.vertex_count {
            return Ok(());
        }
        Err(Error::invalid(format!(
            "{what} {i} names vertex {vertex}, but there are {} vertices, numbered from 0",
            self.vertex_count
        )))
    }

    /// The parts of the model, to be changed and put together again. Features are left out: their lines may change.
    #[doc(hidden)]
    pub fn into_parts(self) -> ModelParts {
        let Self {
            format,
            vertex_count,
            positions,
            partial_positions,
            polygons,
            shapes,
            cells,
            lines,
            points,
            groups,
            data,
            structure,
            remarks,
            is_pseudomanifold,
            frame,
            ..
        } = self;
        ModelParts {
            format,
            vertex_count,
            positions,
            partial_positions,
            polygons,
            shapes,
            cells,
            lines,
            points,
            groups,
            data,
            structure,
            remarks,
            is_pseudomanifold,
            frame,
        }
    }

    /// The format that [`read_path`](super::read_path) and its neighbors read the model from; `None` for a model made
    /// otherwise.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert_eq!(model.format(), Some(Format::Obj));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn format(&self) -> Option<Format> {
        self.format
    }

    #[doc(hidden)]
    pub fn with_format(self, format: Format) -> Self {
        Self { format: Some(format), ..self }
    }

    /// The number of vertices, isolated ones included.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert_eq!(model.vertex_count(), 3);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// Whether there is nothing: no vertex, and no cell of an abstract structure. Facets without positions are something.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// assert!(io::read(&b"OFF\n0 0 0\n"[..], Format::Off)?.is_empty());
    /// assert!(!io::read(&b"[[0,1],[1,2]]"[..], Format::Json)?.is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn is_empty(&self) -> bool {
        self.vertex_count == 0
            && match &self.structure {
                None => true,
                Some(Structure::Facets(facets)) => facets.is_empty(),
                Some(Structure::Chains(complex)) => complex.f_vector().iter().all(|&cells| cells == 0),
                Some(Structure::Halfedges { next, .. }) => next.is_empty(),
                Some(Structure::Gluings(_) | Structure::Volume(_)) => false,
            }
    }

    /// The positions of the vertices; empty when the file has none, and when a coordinate is NaN or infinite: then
    /// [`Self::partial_positions`] has the others.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert_eq!(model.positions().as_flat()[3..6], [1.0, 0.0, 0.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The positions of the vertices where some of them have a coordinate that is NaN or infinite; else `None`.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let model = io::read(&b"v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert!(model.positions().is_empty());
    /// let partial = model.partial_positions().ok_or(coface_algebra::Error::invalid("all are finite"))?;
    /// assert_eq!(partial.unplaced()[0].index(), 1);
    /// # Ok(()) }
    /// ```
    pub fn partial_positions(&self) -> Option<&PartialPositions> {
        self.partial_positions.as_ref()
    }

    /// Refuses a model with a coordinate that is NaN or infinite: for whatever needs the position of each vertex. A model without
    /// positions is not refused.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] naming the first such coordinate.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let model = io::read(&b"v 0 0 0\nv 1 -inf 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// let fault = model.require_finite().unwrap_err();
    /// assert_eq!(fault.message(), "coordinate 1 of v1 is -inf, not a finite number");
    /// # Ok(()) }
    /// ```
    pub fn require_finite(&self) -> Result<(), Error> {
        self.partial_positions.as_ref().and_then(PartialPositions::fault).map_or(Ok(()), Err)
    }

    /// The model with these coordinates, so many for each vertex, which need not be finite.
    ///
    /// # Errors
    /// Those of [`PartialPositions::from_flat`] and [`Self::check`].
    #[doc(hidden)]
    pub fn with_coordinates(mut self, dimension: usize, coordinates: Vec<f64>) -> Result<Self, Error> {
        (self.positions, self.partial_positions) = placed(dimension, coordinates)?;
        // They have the points of before.
        (self.exact, self.exact_segments) = (None, None);
        self.check()?;
        Ok(self)
    }

    /// The number of coordinates that the file gives a vertex, finite or not.
    #[doc(hidden)]
    pub fn coordinate_count(&self) -> usize {
        self.partial_positions.as_ref().map_or(self.positions.dimension(), PartialPositions::dimension)
    }

    /// The coordinates as the file has them, finite or not, vertex after vertex.
    #[doc(hidden)]
    pub fn coordinates(&self) -> &[f64] {
        self.partial_positions.as_ref().map_or(self.positions.as_flat(), PartialPositions::as_flat)
    }

    /// The polygons as cycles of vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert_eq!(model.polygons().list(0), [0, 1, 2]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn polygons(&self) -> &RaggedArray {
        &self.polygons
    }

    /// The shapes of the 3-cells.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert!(model.shapes().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn shapes(&self) -> &[CellShape] {
        &self.shapes
    }

    /// The 3-cells by their vertices, in the order that [`CellShape`] describes.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert!(model.cells().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn cells(&self) -> &RaggedArray {
        &self.cells
    }

    /// The polylines: each runs through its vertices in order.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n"[..], Format::Obj)?;
    /// assert_eq!(model.lines().list(0), [0, 1, 2]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn lines(&self) -> &RaggedArray {
        &self.lines
    }

    /// The vertices that the file lists as points of their own.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\np 2\n"[..], Format::Obj)?;
    /// assert_eq!(model.points()[0].index(), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn points(&self) -> &[VertexId] {
        &self.points
    }

    /// The named groups.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\ng lid\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert_eq!((model.groups()[0].name(), model.groups()[0].members()), ("lid", &[0][..]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// The named numbers on vertices, lines, polygons and cells.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert!(model.data().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn data(&self) -> &[CellData] {
        &self.data
    }

    /// The colors of the vertices: data `red`, `green` and `blue` on vertices, a byte each.
    ///
    /// # Examples
    /// ```
    /// use coface_io::Model;
    /// assert!(Model::default().vertex_colors().is_none());
    /// ```
    pub fn vertex_colors(&self) -> Option<[&CellData; 3]> {
        let part = |name| {
            self.data_named(name, GroupKind::Vertices)
                .filter(|data| data.components() == 1 && matches!(data.numbers(), Numbers::UInt8(_)))
        };
        Some([part("red")?, part("green")?, part("blue")?])
    }

    /// The texture coordinates of the vertices: data `s` and `t` on vertices, or `u` and `v`, or `texture_u` and `texture_v`, one real each.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind, Model};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let of_one = |name| CellData::reals(name, GroupKind::Vertices, 1, vec![0.25]);
    /// let model = coface_io::read(&b"v 0 0 0\np 1\n"[..], coface_io::Format::Obj)?;
    /// assert!(model.with_data(of_one("s")?)?.with_data(of_one("t")?)?.texture_coordinates().is_some());
    /// # Ok(()) }
    /// ```
    pub fn texture_coordinates(&self) -> Option<[&CellData; 2]> {
        let part = |name: &str| {
            self.data_named(name, GroupKind::Vertices)
                .filter(|data| data.components() == 1 && !data.is_integral())
        };
        let pairs = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]];
        pairs.into_iter().find_map(|[u, v]| Some([part(u)?, part(v)?]))
    }

    /// The array of this name on vertices, lines, polygons or cells.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::{Format, GroupKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty uchar red\nend_header\n0 255\n";
    /// let model = io::read(text.as_bytes(), Format::Ply)?;
    /// let red = model.data_named("red", GroupKind::Vertices).ok_or(coface_algebra::Error::invalid("no color"))?;
    /// assert_eq!(red.integer_row(0), Some(vec![255]));
    /// # Ok(()) }
    /// ```
    pub fn data_named(&self, name: &str, kind: GroupKind) -> Option<&CellData> {
        self.data.iter().find(|data| data.kind() == kind && data.name() == name)
    }

    /// The abstract structure, if the file holds one instead of a mesh.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert!(model.structure().is_none());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn structure(&self) -> Option<&Structure> {
        self.structure.as_ref()
    }

    /// The features of a map with their properties; none for other models.
    ///
    /// # Examples
    /// ```
    /// let text = r#"{"type": "Feature", "properties": {"depth": 12.50},
    ///     "geometry": {"type": "Point", "coordinates": [1, 2]}}"#;
    /// let model = coface_io::geojson::read(text.as_bytes())?;
    /// let well = model.features().of_point(0).expect("the point is of a feature");
    /// assert_eq!(model.features().properties(well), r#"{"depth":12.50}"#);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn features(&self) -> &FeatureTable {
        &self.features
    }

    /// What the reader found odd but could read: one sentence each.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// assert!(model.remarks().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }
}

/// Coordinates as positions if all of them are finite, else as those of some of the vertices.
///
/// # Errors
/// Those of [`PartialPositions::from_flat`].
pub fn placed(
    dimension: usize,
    coordinates: Vec<f64>,
) -> Result<(Positions, Option<PartialPositions>), Error> {
    if dimension == 0 || coordinates.iter().all(|x| x.is_finite()) {
        return Ok((Positions::from_flat(dimension, coordinates)?, None));
    }
    Ok((Positions::default(), Some(PartialPositions::from_flat(dimension, coordinates)?)))
}

/// The first vertex that stands twice in a list; short lists are compared pairwise, long ones sorted.
///
/// # Examples
/// ```
/// use coface_io::repeated_vertex;
/// assert_eq!(repeated_vertex(&[4, 2, 4]), Some(4));
/// assert_eq!(repeated_vertex(&[4, 2, 3]), None);
/// ```
pub fn repeated_vertex(vertices: &[u32]) -> Option<u32> {
    if vertices.len() <= 16 {
        return vertices.iter().enumerate().find(|(i, v)| vertices[..*i].contains(v)).map(|(_, &v)| v);
    }
    let mut sorted = vertices.to_vec();
    sorted.sort_unstable();
    sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}

fn check_size(what: &str, i: usize, vertices: &[u32], least: usize) -> Result<(), Error> {
    if vertices.len() < least {
        return Err(Error::invalid(format!("{what} {i} has {} vertices; it needs {least}", vertices.len())));
    }
    Ok(())
}

/// The segments of polylines.
pub fn segments(lines: &RaggedArray) -> Vec<[u32; 2]> {
    lines.iter().flat_map(|line| line.windows(2).map(|pair| [pair[0], pair[1]])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane(count: usize) -> Positions {
        Positions::from_flat(2, (0..2 * count).map(|i| i as f64).collect()).unwrap()
    }

    #[test]
    fn faults_are_named() {
        let fault = |polygon: Vec<u32>| {
            Model::from_polygons(plane(4), RaggedArray::from_lists([polygon])).unwrap_err().to_string()
        };
        assert!(fault(vec![0, 1, 4]).contains("names vertex 4, but there are 4"));
        assert!(fault(vec![0, 1, 0]).contains("polygon 0 repeats vertex 0"));
        assert!(fault(vec![0, 1]).contains("needs 3"));
    }

    #[test]
    fn repeated_vertices_are_found_in_long_lists() {
        let mut long: Vec<u32> = (0..40).collect();
        assert_eq!(repeated_vertex(&long), None);
        long.push(17);
        assert_eq!(repeated_vertex(&long), Some(17));
    }
}
