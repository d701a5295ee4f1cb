//! Surfaces edited step by step: local changes of a mesh of halfedges with positions, each with its inverse, and a log
//! with which they are undone.

mod edit;
mod log;

pub use edit::{CellName, Edit, EditRecord};
pub use log::{EditLog, EditorState};

use crate::SurfaceModel;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId, RaggedArray, VertexId};
use coface_complexes::surface::{HalfedgeMesh, HalfedgePermutations, Renumbering};
use coface_geometry::Positions;
use coface_io::{Model, Structure};

/// A surface that is edited: a mesh of halfedges, with positions or without.
///
/// Edges have the numbers of [`HalfedgeMesh`], and edge e has the halfedges 2e and 2e + 1. What is added gets the last number of
/// its kind; where a cell is removed, the last of its kind gets its number.
///
/// # Examples
/// A square and its diagonals:
/// ```
/// use coface_answers::{Edit, SurfaceEditor};
/// use coface_io::Format;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"[..], Format::Obj)?;
/// let mut editor = SurfaceEditor::new(square)?;
/// editor.apply(&Edit::FlipEdge { edge: "0 2".parse()? })?;
/// assert!(editor.model()?.polygons().iter().all(|triangle| triangle.contains(&1) && triangle.contains(&3)));
/// editor.undo(1)?;
/// assert_eq!(editor.model()?.polygons().list(0), [0, 1, 2]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct SurfaceEditor {
    before: EditorState,
    records: Vec<EditRecord>,
    mesh: HalfedgeMesh,
    dimension: usize,
    points: Vec<f64>,
    has_polygons: bool,
}

impl SurfaceEditor {
    /// An oriented surface to edit: polygons whose faces agree, or halfedges.
    ///
    /// # Errors
    /// Those of [`HalfedgeMesh::from_polygons`] and [`HalfedgePermutations::mesh`]; [`ErrorKind::UnsupportedFormat`] for a model
    /// that is neither.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::SurfaceEditor;
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = coface_io::read(&br#"{"next": [2, 3, 1, 0]}"#[..], Format::Json)?;
    /// assert_eq!(SurfaceEditor::new(torus)?.mesh().f_vector(), [1, 2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn new(model: Model) -> Result<Self, Error> {
        Self::of_state(EditorState::of(model)?)
    }

    fn of_state(state: EditorState) -> Result<Self, Error> {
        let (mesh, points, has_polygons) = match &state {
            EditorState::Halfedges { next, twin, outer, vertices } => {
                let permutations = HalfedgePermutations::new(next.clone(), twin.clone(), outer.clone())?;
                (permutations.mesh()?, vertices, false)
            }
            EditorState::Polygons { vertices, vertex_count, polygons } => {
                let polygons = RaggedArray::from_lists(polygons);
                (HalfedgeMesh::from_polygons(*vertex_count, &polygons)?, vertices, true)
            }
        };
        let dimension = points.first().map_or(0, Vec::len);
        let points: Vec<f64> = points.iter().flatten().copied().collect();
        if dimension > 0 && points.len() != dimension * mesh.vertex_count() {
            return Err(Error::invalid(format!(
                "{} coordinates for {} vertices of dimension {dimension}",
                points.len(),
                mesh.vertex_count()
            )));
        }
        Ok(Self { before: state, records: Vec::new(), mesh, dimension, points, has_polygons })
    }

    /// The mesh as it is now.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Edit, SurfaceEditor};
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut torus = SurfaceEditor::new(coface_io::read(&br#"{"next": [2, 3, 1, 0]}"#[..], Format::Json)?)?;
    /// torus.apply(&Edit::PokeFace { face: 0 })?;
    /// assert_eq!(torus.mesh().f_vector(), [2, 6, 4]);
    /// # Ok(()) }
    /// ```
    pub fn mesh(&self) -> &HalfedgeMesh {
        &self.mesh
    }

    /// What was done, the first edit first.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Edit, SurfaceEditor};
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut torus = SurfaceEditor::new(coface_io::read(&br#"{"next": [2, 3, 1, 0]}"#[..], Format::Json)?)?;
    /// torus.apply(&Edit::FlipEdge { edge: "0".parse()? })?;
    /// assert_eq!(torus.records()[0].inverse, [Edit::FlipEdgeBack { edge: "0".parse()? }]);
    /// # Ok(()) }
    /// ```
    pub fn records(&self) -> &[EditRecord] {
        &self.records
    }

    /// Does one edit, and gives what is recorded of it. An edit that is refused changes nothing.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] for cells that are not there; those of the operation of [`HalfedgeMesh`].
    ///
    /// # Complexity
    /// That of the operation, and a copy of the mesh where it has several steps.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Edit, SurfaceEditor};
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = coface_io::read(&b"v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// let mut editor = SurfaceEditor::new(triangle)?;
    /// let record = editor.apply(&Edit::SplitEdge { edge: "0 1".parse()? })?;
    /// assert_eq!(record.added_vertex, Some(3));
    /// assert_eq!(editor.model()?.positions().as_flat()[9..], [1.0, 0.0, 0.0]);
    /// # Ok(()) }
    /// ```
    pub fn apply(&mut self, edit: &Edit) -> Result<EditRecord, Error> {
        let mut record =
            EditRecord { edit: edit.clone(), inverse: Vec::new(), added_vertex: None, kept_vertex: None };
        match edit {
            Edit::FlipEdge { edge } => {
                let edge = self.edge(edge)?;
                self.mesh.flip_edge(edge)?;
                record.inverse.push(Edit::FlipEdgeBack { edge: CellName::of(edge.index()) });
            }
            Edit::FlipEdgeBack { edge } => {
                let edge = self.edge(edge)?;
                self.mesh.flip_edge_back(edge)?;
                record.inverse.push(Edit::FlipEdge { edge: CellName::of(edge.index()) });
            }
            Edit::SplitEdge { edge } => {
                let edge = self.edge(edge)?;
                let h = self.mesh.edge_halfedge(edge);
                let middle = self.mean(&[self.mesh.source(h), self.mesh.target(h)]);
                let vertex = self.mesh.split_edge(edge)?.vertex();
                self.points.extend(middle);
                record.added_vertex = Some(vertex.index());
                record.inverse.push(Edit::RemoveVertex { vertex: vertex.index() });
            }
            Edit::RemoveVertex { vertex } => {
                let vertex = self.vertex(*vertex)?;
                let removal = self.mesh.remove_vertex(vertex)?;
                self.follow(removal.renumbering());
                record.inverse.push(Edit::SplitEdge { edge: CellName::of(removal.edge().index()) });
            }
            Edit::SplitFace { from, to } => {
                let (from, to) = (self.halfedge(from)?, self.halfedge(to)?);
                let split = self.mesh.split_face(from, to)?;
                record.inverse.push(Edit::RemoveEdge { edge: CellName::of(split.edge().index()) });
            }
            Edit::RemoveEdge { edge } => {
                let edge = self.edge(edge)?;
                let removal = self.mesh.remove_edge(edge)?;
                record.inverse.push(split_face(removal.corners()));
            }
            Edit::SplitVertex { from, to } => {
                let (from, to) = (self.halfedge(from)?, self.halfedge(to)?);
                let copy = self.mean(&[self.mesh.source(from)]);
                let split = self.mesh.split_vertex(from, to)?;
                self.points.extend(copy);
                record.added_vertex = Some(split.vertex().index());
                let edge = CellName::of(split.edge().index());
                record.inverse.push(if from == to {
                    Edit::RemovePendantEdge { edge }
                } else {
                    Edit::ContractEdge { edge }
                });
            }
            Edit::ContractEdge { edge } => {
                let edge = self.edge(edge)?;
                let contraction = self.mesh.collapse_edge(edge)?;
                self.follow(contraction.renumbering());
                record.kept_vertex = Some(contraction.vertex().index());
                record.inverse.push(split_vertex(contraction.corners()));
            }
            Edit::RemovePendantEdge { edge } => {
                let edge = self.edge(edge)?;
                let removal = self.mesh.remove_pendant_edge(edge)?;
                self.follow(removal.renumbering());
                record.kept_vertex = Some(removal.vertex().index());
                record.inverse.push(split_vertex(removal.corners()));
            }
            Edit::CollapseEdge { edge } => {
                let edge = self.edge(edge)?;
                self.collapse(edge, &mut record)?;
            }
            Edit::PokeFace { face } => {
                let face = self.face(*face)?;
                let corners: Vec<VertexId> = self.mesh.face_vertices(face).collect();
                let middle = self.mean(&corners);
                let poke = self.mesh.poke_face(face)?;
                self.points.extend(middle);
                record.added_vertex = Some(poke.vertex().index());
                let edges: Vec<usize> = poke.edges().map(EdgeId::index).collect();
                record.inverse.extend(
                    edges[1..].iter().rev().map(|&edge| Edit::RemoveEdge { edge: CellName::of(edge) }),
                );
                record.inverse.push(Edit::RemovePendantEdge { edge: CellName::of(edges[0]) });
            }
        }
        self.records.push(record.clone());
        Ok(record)
    }

    /// Collapses an edge together with the triangles beside it.
    fn collapse(&mut self, edge: EdgeId, record: &mut EditRecord) -> Result<(), Error> {
        if let Some(obstacle) = self.mesh.collapse_obstacle(edge) {
            return Err(Error::invalid(format!("edge {edge} cannot be collapsed: {}", obstacle.message()))
                .with_cure("take another edge, or contract it: faces then lose a side each"));
        }
        let h = self.mesh.edge_halfedge(edge);
        let mut faces: Vec<FaceId> = [h, self.mesh.twin(h)]
            .into_iter()
            .filter(|&side| !self.mesh.is_outer_halfedge(side))
            .map(|side| self.mesh.face(side))
            .collect();
        let contraction = self.mesh.collapse_edge(edge)?;
        self.follow(contraction.renumbering());
        record.kept_vertex = Some(contraction.vertex().index());
        let mut removals = Vec::new();
        while let Some(face) = faces.pop() {
            // A digon goes with one of its edges, one that lies inside.
            let inside = self.mesh.face_edges(face).find(|&edge| !self.mesh.is_boundary_edge(edge));
            let edge = inside.expect("a triangle with two sides on the boundary is an obstacle");
            let source = self.mesh.source(self.mesh.edge_halfedge(edge));
            let last = self.mesh.edge_count() - 1;
            let removal = self.mesh.remove_edge(edge)?;
            for &(from, to) in removal.renumbering().faces() {
                faces.iter_mut().filter(|face| **face == from).for_each(|face| *face = to);
            }
            removals.push(Removal {
                edge: edge.index(),
                last,
                source,
                corners: removal.corners(),
                again: None,
            });
        }
        // Edges that are put in again have other numbers than the ones that went: the corners after them are named anew.
        let mut again = self.mesh.clone();
        for at in (0..removals.len()).rev() {
            let corners = removals[at].corners.map(|corner| Removal::translate(&removals[at + 1..], corner));
            let added = again.split_face(corners[0], corners[1])?.edge();
            let h = again.edge_halfedge(added);
            let is_turned = again.source(h) != removals[at].source;
            removals[at].again = Some(if is_turned { again.twin(h) } else { h });
            record.inverse.push(split_face(corners));
        }
        let corners = contraction.corners().map(|corner| Removal::translate(&removals, corner));
        record.inverse.push(split_vertex(corners));
        Ok(())
    }

    /// Undoes the last edits: the surface is what it was before them, with the same numbers.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if there are not so many.
    ///
    /// # Complexity
    /// That of the edits that stay.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Edit, SurfaceEditor};
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut torus = SurfaceEditor::new(coface_io::read(&br#"{"next": [2, 3, 1, 0]}"#[..], Format::Json)?)?;
    /// let before = torus.mesh().clone();
    /// torus.apply(&Edit::PokeFace { face: 0 })?;
    /// torus.undo(1)?;
    /// assert_eq!(torus.mesh(), &before);
    /// assert!(torus.undo(1).is_err());
    /// # Ok(()) }
    /// ```
    pub fn undo(&mut self, edits: usize) -> Result<(), Error> {
        let Some(kept) = self.records.len().checked_sub(edits) else {
            return Err(Error::invalid(format!(
                "{edits} edits are to be undone, but there are {}",
                self.records.len()
            ))
            .with_cure("undo at most all of them"));
        };
        let mut again = Self::of_state(self.before.clone())?;
        for record in &self.records[..kept] {
            again.apply(&record.edit)?;
        }
        *self = again;
        Ok(())
    }

    /// The surface as it is now: polygons where it was made from some, else halfedges, edge e with the halfedges 2e and 2e + 1.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] where a face is no polygon any more.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Edit, SurfaceEditor};
    /// use coface_io::{Format, Structure};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut torus = SurfaceEditor::new(coface_io::read(&br#"{"next": [2, 3, 1, 0]}"#[..], Format::Json)?)?;
    /// torus.apply(&Edit::SplitEdge { edge: "0".parse()? })?;
    /// let model = torus.model()?;
    /// let Some(Structure::Halfedges { next, .. }) = model.structure() else { panic!() };
    /// assert_eq!(next.len(), 6);
    /// # Ok(()) }
    /// ```
    pub fn model(&self) -> Result<Model, Error> {
        let positions = match self.dimension {
            0 => Positions::default(),
            dimension => Positions::from_flat(dimension, self.points.clone())?,
        };
        if self.has_polygons {
            return match self.dimension {
                0 => Ok(Model::from_structure(Structure::Facets(self.mesh.polygons()))),
                _ => Model::from_polygons(positions, self.mesh.polygons()),
            };
        }
        let (permutations, vertices) = HalfedgePermutations::of_mesh(&self.mesh);
        let points = match self.dimension {
            0 => Positions::default(),
            dimension => {
                let points = vertices.iter().flat_map(|&vertex| positions.point(vertex)).copied().collect();
                Positions::from_flat(dimension, points)?
            }
        };
        Model::from_halfedges(permutations, points)
    }

    /// What was done and what there was before, for a file with which it is undone.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Edit, SurfaceEditor};
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut torus = SurfaceEditor::new(coface_io::read(&br#"{"next": [2, 3, 1, 0]}"#[..], Format::Json)?)?;
    /// torus.apply(&Edit::FlipEdge { edge: "1".parse()? })?;
    /// assert_eq!(SurfaceEditor::of_log(torus.log())?.mesh(), torus.mesh());
    /// # Ok(()) }
    /// ```
    pub fn log(&self) -> EditLog {
        EditLog { before: self.before.clone(), edits: self.records.clone() }
    }

    /// The surface that a log leads to.
    ///
    /// # Errors
    /// Those of the edits.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::SurfaceEditor;
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SurfaceEditor::new(coface_io::read(&br#"{"next": [2, 3, 1, 0]}"#[..], Format::Json)?)?;
    /// assert_eq!(SurfaceEditor::of_log(torus.log())?.records().len(), 0);
    /// # Ok(()) }
    /// ```
    pub fn of_log(log: EditLog) -> Result<Self, Error> {
        let mut editor = Self::of_state(log.before)?;
        for record in &log.edits {
            editor.apply(&record.edit)?;
        }
        Ok(editor)
    }

    /// The mean of the positions of some vertices; nothing without positions.
    fn mean(&self, vertices: &[VertexId]) -> Vec<f64> {
        let at = |vertex: &VertexId, axis| self.points[vertex.index() * self.dimension + axis];
        let sum = |axis| vertices.iter().map(|vertex| at(vertex, axis)).sum::<f64>();
        (0..self.dimension).map(|axis| sum(axis) / vertices.len() as f64).collect()
    }

    /// Moves positions as vertices moved, and drops those of vertices that are gone.
    fn follow(&mut self, renumbering: &Renumbering) {
        let d = self.dimension;
        for &(from, to) in renumbering.vertices() {
            self.points.copy_within(from.index() * d..(from.index() + 1) * d, to.index() * d);
        }
        self.points.truncate(self.mesh.vertex_count() * d);
    }

    fn vertex(&self, number: usize) -> Result<VertexId, Error> {
        let count = self.mesh.vertex_count();
        if number < count { Ok(VertexId::new(number)) } else { Err(no_cell("vertex", number, count)) }
    }

    fn face(&self, number: usize) -> Result<FaceId, Error> {
        let count = self.mesh.face_count();
        if number < count { Ok(FaceId::new(number)) } else { Err(no_cell("face", number, count)) }
    }

    fn edge(&self, name: &CellName) -> Result<EdgeId, Error> {
        match name {
            CellName::Number(number) => {
                let count = self.mesh.edge_count();
                if *number < count { Ok(EdgeId::new(*number)) } else { Err(no_cell("edge", *number, count)) }
            }
            CellName::Ends(_) => self.halfedge(name).map(|halfedge| self.mesh.edge(halfedge)),
        }
    }

    fn halfedge(&self, name: &CellName) -> Result<HalfedgeId, Error> {
        match *name {
            CellName::Number(number) => {
                let count = self.mesh.halfedge_count();
                if number < count {
                    Ok(HalfedgeId::new(number))
                } else {
                    Err(no_cell("halfedge", number, count))
                }
            }
            CellName::Ends([a, b]) => {
                let (source, target) = (self.vertex(a)?, self.vertex(b)?);
                let mut found =
                    self.mesh.halfedges_leaving(source).filter(|&h| self.mesh.target(h) == target);
                match (found.next(), found.next()) {
                    (Some(halfedge), None) => Ok(halfedge),
                    (None, _) => Err(Error::new(
                        ErrorKind::NotInComplex,
                        format!("no edge joins vertices {a} and {b}"),
                    )
                    .with_cells([[a as u32, b as u32]])),
                    (Some(first), Some(second)) => Err(Error::invalid(format!(
                        "several edges join vertices {a} and {b}, such as {} and {}",
                        self.mesh.edge(first),
                        self.mesh.edge(second)
                    ))
                    .with_cure("name the edge by its number")),
                }
            }
        }
    }
}

/// An edge that was removed on the way.
struct Removal {
    edge: usize,
    /// The last edge before, which got the number of the one that went.
    last: usize,
    /// The source of the edge that went.
    source: VertexId,
    corners: [HalfedgeId; 2],
    /// The halfedge that it is again, in its direction, once it is put in.
    again: Option<HalfedgeId>,
}

impl Removal {
    /// The number, after these removals were undone, of a halfedge before them.
    fn translate(removals: &[Self], halfedge: HalfedgeId) -> HalfedgeId {
        let (mut edge, side) = (halfedge.index() / 2, halfedge.index() % 2);
        for removal in removals {
            if edge == removal.edge {
                let again = removal.again.expect("later removals are undone first").index();
                return HalfedgeId::new(again ^ side);
            }
            if edge == removal.last {
                edge = removal.edge;
            }
        }
        HalfedgeId::new(2 * edge + side)
    }
}

fn split_face(corners: [HalfedgeId; 2]) -> Edit {
    let [from, to] = corners.map(|corner| CellName::of(corner.index()));
    Edit::SplitFace { from, to }
}

fn split_vertex(corners: [HalfedgeId; 2]) -> Edit {
    let [from, to] = corners.map(|corner| CellName::of(corner.index()));
    Edit::SplitVertex { from, to }
}

fn no_cell(what: &str, number: usize, count: usize) -> Error {
    Error::new(ErrorKind::NotInComplex, format!("there is no {what} {number}; there are {count}, from 0"))
}

impl EditorState {
    /// What a model is before it is edited.
    fn of(model: Model) -> Result<Self, Error> {
        let rows = |positions: &Positions| -> Vec<Vec<f64>> {
            match positions.dimension() {
                0 => Vec::new(),
                dimension => positions.as_flat().chunks(dimension).map(<[f64]>::to_vec).collect(),
            }
        };
        if let Some(Structure::Halfedges { next, twin, outer }) = model.structure() {
            let vertices = rows(model.positions());
            return Ok(Self::Halfedges {
                next: next.clone(),
                twin: twin.clone(),
                outer: outer.clone(),
                vertices,
            });
        }
        if let Some(Structure::Facets(facets)) = model.structure()
            && facets.iter().all(|facet| facet.len() == 3)
        {
            let vertex_count = facets.items().iter().max().map_or(0, |&last| last as usize + 1);
            let polygons = facets.iter().map(<[u32]>::to_vec).collect();
            return Ok(Self::Polygons { vertices: Vec::new(), vertex_count, polygons });
        }
        if model.structure().is_some() || !model.cells().is_empty() || model.polygons().is_empty() {
            // Refused with the fault of a model that is no surface, if it has one.
            SurfaceModel::of(model)?;
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                "only meshes of polygons and halfedges are edited",
            )
            .with_cure("make it halfedges: coface convert INPUT -o OUT.halfedges.json"));
        }
        model.require_finite()?;
        Ok(Self::Polygons {
            vertices: rows(model.positions()),
            vertex_count: model.vertex_count(),
            polygons: model.polygons().iter().map(<[u32]>::to_vec).collect(),
        })
    }
}

#[cfg(test)]
mod tests;
