//! A model as a surface, and the models of surfaces that are made from it.

mod canonical;
mod certificate;
mod covering;
mod cutting;
mod schema;

pub use canonical::{LayoutRequest, LayoutWeights, PlacedPolygons};
pub use covering::{LayoutChoice, PlacedCover, SurfaceCover};
pub use cutting::{CutComponent, CutRequest, CutSeam, SurfaceCut};
pub use schema::PolygonSchema;

use crate::producer::{Cells, Producer};
use coface_algebra::RaggedArray;
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, VertexId};
use coface_complexes::cell_mesh::CellMesh;
use coface_complexes::surface::{GeneralizedMap, PolygonMesh};
use coface_geometry::{PartialPositions, Positions};
use coface_io::{CellData, Group, GroupKind, Model, ModelParts, placed};

/// A model that is a surface: its cells as a [`GeneralizedMap`], with their numbers in the file and everything that the file
/// says of them.
///
/// # Examples
/// A square of two triangles.
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_answers::SurfaceModel;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = io::read(&b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"[..], Format::Obj)?;
/// let surface = SurfaceModel::of(square)?;
/// assert_eq!(surface.map().f_vector(), [4, 5, 2]);
/// assert_eq!(surface.map().surfaces()[0].to_string(), "disk");
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct SurfaceModel {
    map: GeneralizedMap,
    positions: Positions,
    /// Instead of the positions, where some are not finite.
    partial_positions: Option<PartialPositions>,
    /// The number in the file of each vertex, if it is not its own.
    numbers: Option<Vec<u32>>,
    /// The polygon of the file that each face is, if it is one.
    polygons: Option<Vec<u32>>,
    groups: Vec<Group>,
    data: Vec<CellData>,
}

impl SurfaceModel {
    /// The surface that the cells of a model are.
    ///
    /// # Errors
    /// Those of [`Producer::of`] and [`Producer::two_skeleton`]; [`ErrorKind::NonManifold`] naming the cells where the model is no
    /// surface; [`ErrorKind::UnsupportedFormat`] for a model with 3-cells, whose boundary is one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
    /// assert_eq!(surface.map().f_vector(), [4, 5, 2]);
    /// # Ok(()) }
    /// ```
    pub fn of(model: Model) -> Result<Self, Error> {
        if !model.cells().is_empty() {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                format!("the model has {} 3-cells and is no surface", model.cells().len()),
            )
            .with_cure("take its boundary"));
        }
        let mut model = model.into_parts();
        let (groups, data) = (std::mem::take(&mut model.groups), std::mem::take(&mut model.data));
        let producer = Producer::of(model.into_model())?;
        let skeleton = producer.two_skeleton()?;
        let Producer { cells, labels, positions, partial_positions, .. } = producer;
        let (numbers, polygons) = match &cells {
            Cells::Polygons(mesh) => {
                let count = mesh.vertex_count() as u32;
                let numbers: Vec<u32> = (0..count).map(|vertex| labels.of(vertex)).collect();
                let is_own = numbers.iter().zip(0..).all(|(&number, vertex)| number == vertex);
                ((!is_own).then_some(numbers), Some(polygons_of(mesh)))
            }
            Cells::Simplices(complex) => {
                let number = |vertex| complex.numbers(0, vertex)[0];
                (Some((0..skeleton.vertex_count()).map(number).collect()), None)
            }
            _ => (None, None),
        };
        let map = GeneralizedMap::new(skeleton).map_err(|error| renumbered(error, numbers.as_deref()))?;
        Ok(Self { map, positions, partial_positions, numbers, polygons, groups, data })
    }

    /// The boundary surface of a model with 3-cells. Faces have no numbers in the file.
    ///
    /// # Errors
    /// Those of [`CellMesh::new`]; [`ErrorKind::NonManifold`] naming the cells where the boundary is no surface;
    /// [`ErrorKind::UnsupportedFormat`] for a model without 3-cells.
    ///
    /// # Examples
    /// A tetrahedron.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_answers::SurfaceModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\
    ///             Tetrahedra 1\n1 2 3 4 0\nEnd\n";
    /// let surface = SurfaceModel::boundary_of(io::read(text.as_bytes(), Format::Medit)?)?;
    /// assert_eq!(surface.map().surfaces()[0].to_string(), "sphere");
    /// # Ok(()) }
    /// ```
    pub fn boundary_of(model: Model) -> Result<Self, Error> {
        let (dimension, given) = (model.coordinate_count(), model.coordinates().to_vec());
        let ModelParts { vertex_count, polygons, shapes, cells, mut groups, mut data, .. } =
            model.into_parts();
        if cells.is_empty() {
            return Err(Error::new(ErrorKind::UnsupportedFormat, "the model has no 3-cells")
                .with_cure("its boundary is a curve, if there is one"));
        }
        let boundary = CellMesh::new(vertex_count, shapes, cells, &polygons, &[])?.boundary_surface();
        let vertices: Vec<u32> = boundary.vertices().iter().map(|vertex| vertex.to_u32()).collect();
        let coordinates = vertices.iter().flat_map(|&v| &given[v as usize * dimension..][..dimension]);
        let (positions, partial_positions) = placed(dimension, coordinates.copied().collect())?;
        groups.retain(|group| group.kind() == GroupKind::Vertices);
        data.retain(|data| data.kind() == GroupKind::Vertices);
        Ok(Self {
            map: boundary
                .mesh()
                .two_skeleton()
                .and_then(GeneralizedMap::new)
                .map_err(|error| renumbered(error, Some(&vertices)))?,
            positions,
            partial_positions,
            numbers: Some(vertices),
            polygons: None,
            groups,
            data,
        })
    }

    /// The surface.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
    /// assert_eq!(surface.map().face_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn map(&self) -> &GeneralizedMap {
        &self.map
    }

    /// The positions of its vertices; empty when there are none.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
    /// assert_eq!(surface.positions().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The number of a vertex in the file.
    ///
    /// # Panics
    /// If there is no such vertex. Likewise the functions that follow panic where there is no such cell.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
    /// assert_eq!(surface.number(coface_algebra::VertexId::new(2)), 2);
    /// # Ok(()) }
    /// ```
    pub fn number(&self, vertex: VertexId) -> u32 {
        self.numbers.as_ref().map_or(vertex.to_u32(), |numbers| numbers[vertex.index()])
    }

    /// The vertex with this number in the file, if there is one.
    ///
    /// # Complexity
    /// Logarithmic: numbers rise with the vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_answers::SurfaceModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let surface = SurfaceModel::of(io::read(&b"[[3, 7, 9]]"[..], Format::Json)?)?;
    /// assert_eq!(surface.vertex(9), Some(VertexId::new(2)));
    /// assert_eq!(surface.vertex(8), None);
    /// # Ok(()) }
    /// ```
    pub fn vertex(&self, number: u32) -> Option<VertexId> {
        let found = match &self.numbers {
            Some(numbers) => numbers.binary_search(&number).ok(),
            None => Some(number as usize).filter(|&vertex| vertex < self.map.skeleton().vertex_count()),
        };
        found.map(VertexId::new)
    }

    /// The vertex with this number in the file.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] where there is none.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
    /// assert_eq!(surface.vertex_numbered(3)?.index(), 3);
    /// assert!(surface.vertex_numbered(4).is_err());
    /// # Ok(()) }
    /// ```
    pub fn vertex_numbered(&self, number: u32) -> Result<VertexId, Error> {
        self.vertex(number).ok_or_else(|| {
            Error::new(ErrorKind::NotInComplex, format!("there is no vertex {number}"))
                .with_cells([[number]])
                .with_cure("give a vertex of the surface")
        })
    }

    /// Refuses a surface with a coordinate that is NaN or infinite: for whatever measures lengths. A surface without positions is
    /// not refused.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first such coordinate.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::SurfaceModel;
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n";
    /// let surface = SurfaceModel::of(coface_io::read(text.as_bytes(), Format::Obj)?)?;
    /// assert!(surface.require_finite().is_err() && surface.edge_lengths().is_none());
    /// # Ok(()) }
    /// ```
    pub fn require_finite(&self) -> Result<(), Error> {
        self.partial_positions.as_ref().and_then(PartialPositions::fault).map_or(Ok(()), Err)
    }

    /// The lengths of the edges; `None` without positions, or where some are not finite.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
    /// let lengths = surface.edge_lengths().unwrap_or_default();
    /// assert_eq!(lengths.iter().sum::<f64>(), 3.0 + 4.0 + 3.0 + 4.0 + 5.0);
    /// # Ok(()) }
    /// ```
    pub fn edge_lengths(&self) -> Option<Vec<f64>> {
        edge_lengths(self.map.skeleton(), &self.positions)
    }

    /// The numbers in the file of the vertices along a path of steps, 2e along edge e and 2e + 1 against it.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
    /// let steps = surface.steps_along(&[0, 1, 2])?;
    /// assert_eq!(surface.numbers_along(&steps), [0, 1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn numbers_along(&self, steps: &[u32]) -> Vec<u32> {
        let ends = self.map.skeleton().edge_ends();
        let number = |step: u32| self.number(VertexId::from_u32(ends[step as usize]));
        let first = steps.first().map(|&step| number(step));
        first.into_iter().chain(steps.iter().map(|&step| number(step ^ 1))).collect()
    }

    /// The numbers in the file of the ends of an edge, from its start to its end.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
    /// let steps = surface.steps_along(&[0, 1])?;
    /// let edge = coface_algebra::EdgeId::from_u32(steps[0] >> 1);
    /// assert_eq!(surface.edge_numbers(edge), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn edge_numbers(&self, edge: EdgeId) -> [u32; 2] {
        self.map.skeleton().edge(edge).map(|end| self.number(end))
    }

    /// The number in the file of the polygon that a face is; the number of the face itself where the file has no polygons.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
    /// assert_eq!(surface.polygon(coface_algebra::FaceId::new(1)), 1);
    /// # Ok(()) }
    /// ```
    pub fn polygon(&self, face: FaceId) -> u32 {
        self.polygons.as_ref().map_or(face.to_u32(), |polygons| polygons[face.index()])
    }

    /// The numbers in the file of the vertices around a face.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
    /// assert_eq!(surface.face_numbers(coface_algebra::FaceId::new(1)), [0, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn face_numbers(&self, face: FaceId) -> Vec<u32> {
        self.map.sides_of(face).map(|side| self.number(self.map.source(side))).collect()
    }

    /// The surface as a model, with its numbers in the file as data.
    ///
    /// # Errors
    /// Those of [`Self::model_over`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::SurfaceModel;
    /// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
    /// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
    /// assert_eq!(surface.to_model()?.polygons().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn to_model(&self) -> Result<Model, Error> {
        let (v, f) = (self.map.vertex_count(), self.map.face_count());
        let vertices: Vec<VertexId> = (0..v).map(VertexId::new).collect();
        let faces: Vec<FaceId> = (0..f).map(FaceId::new).collect();
        self.model_over(cutting::polygons_of_map(&self.map), &vertices, &faces, None)
    }

    /// A model of a surface whose vertices and faces lie over those of this one: a cover, or this one cut open.
    ///
    /// Positions, groups and data of vertices and polygons come along. There are two more arrays: `source` on vertices, the
    /// number in the file of the vertex below, and `face` on polygons, that of the polygon below; they take the place of
    /// others of these names. Without `positions` vertices have those of the vertices below.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if a polygon has fewer than three vertices or one twice, which files cannot hold.
    ///
    /// # Examples
    /// The two triangles of a square, no longer glued.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_io as io;
    /// use coface_io::{Format, GroupKind};
    /// use coface_answers::SurfaceModel;
    /// use coface_algebra::{FaceId, VertexId};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = io::read(&b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"[..], Format::Obj)?;
    /// let surface = SurfaceModel::of(square)?;
    /// let polygons = RaggedArray::from_lists([[0, 1, 2], [4, 5, 3]]);
    /// let sources = [0, 1, 2, 3, 0, 2].map(VertexId::new);
    /// let model = surface.model_over(polygons, &sources, &[0, 1].map(FaceId::new), None)?;
    /// assert_eq!(model.positions().point(VertexId::new(5)), [1.0, 1.0, 0.0]);
    /// let source = model.data_named("source", GroupKind::Vertices).and_then(|data| data.integer_row(4));
    /// assert_eq!(source, Some(vec![0]));
    /// # Ok(()) }
    /// ```
    pub fn model_over(
        &self,
        polygons: RaggedArray,
        vertex_sources: &[VertexId],
        face_sources: &[FaceId],
        positions: Option<Positions>,
    ) -> Result<Model, Error> {
        let (positions, partial_positions) = match positions {
            Some(positions) => (positions, None),
            None => {
                let (dimension, given) = match &self.partial_positions {
                    Some(partial) => (partial.dimension(), partial.as_flat()),
                    None => (self.positions.dimension(), self.positions.as_flat()),
                };
                let points = vertex_sources
                    .iter()
                    .flat_map(|source| &given[source.index() * dimension..][..dimension]);
                placed(dimension, points.copied().collect())?
            }
        };
        let mut model = ModelParts {
            vertex_count: vertex_sources.len(),
            positions,
            partial_positions,
            polygons,
            ..ModelParts::default()
        }
        .into_model();
        let row = |kind: GroupKind| -> Option<Box<dyn Fn(usize) -> usize + '_>> {
            match kind {
                GroupKind::Vertices => Some(Box::new(|i| self.number(vertex_sources[i]) as usize)),
                GroupKind::Polygons if self.polygons.is_some() => {
                    Some(Box::new(|i| self.polygon(face_sources[i]) as usize))
                }
                _ => None,
            }
        };
        for group in &self.groups {
            let Some(row) = row(group.kind()) else { continue };
            let mut is_member =
                vec![false; group.members().iter().map(|&m| m as usize + 1).max().unwrap_or(0)];
            group.members().iter().for_each(|&member| is_member[member as usize] = true);
            let count = model.count_of(group.kind());
            let members = (0..count).filter(|&i| is_member.get(row(i)) == Some(&true)).map(|i| i as u32);
            let group = group.with_members(members.collect());
            model = model.with_group(group)?;
        }
        let numbers = |values: Vec<i64>, name: &str, kind| CellData::integers(name, kind, 1, values);
        let sources = vertex_sources.iter().map(|&source| i64::from(self.number(source))).collect();
        model = model.with_data(numbers(sources, "source", GroupKind::Vertices)?)?;
        let faces = face_sources.iter().map(|&face| i64::from(self.polygon(face))).collect();
        model = model.with_data(numbers(faces, "face", GroupKind::Polygons)?)?;
        for data in &self.data {
            let is_taken = model.data_named(data.name(), data.kind()).is_some();
            if let Some(row) = row(data.kind()).filter(|_| !is_taken) {
                let taken = data.taken_from((0..model.count_of(data.kind())).map(row));
                model = model.with_data(taken)?;
            }
        }
        model.check()?;
        Ok(model)
    }
}

/// The lengths of the edges of a 2-skeleton whose vertices have these positions; `None` if these are empty.
///
/// # Panics
/// If a vertex has no position among some.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_answers::SurfaceModel;
/// let square = &b"v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n"[..];
/// let surface = SurfaceModel::of(coface_io::read(square, coface_io::Format::Obj)?)?;
/// let lengths = coface_answers::edge_lengths(surface.map().skeleton(), surface.positions());
/// assert_eq!(lengths, surface.edge_lengths());
/// # Ok(()) }
/// ```
pub fn edge_lengths(skeleton: &TwoSkeleton, positions: &Positions) -> Option<Vec<f64>> {
    if positions.is_empty() {
        return None;
    }
    let length = |ends: &[u32]| {
        let [a, b] = [ends[0], ends[1]].map(|end| positions.point(VertexId::from_u32(end)));
        a.iter().zip(b).map(|(x, y)| x - y).fold(0.0, f64::hypot)
    };
    Some(skeleton.edge_ends().chunks_exact(2).map(length).collect())
}

/// The fault with cells by the numbers of the file, where those of the surface are others.
fn renumbered(error: Error, numbers: Option<&[u32]>) -> Error {
    let Some(numbers) = numbers else { return error };
    error.with_vertex_numbers(|vertex| numbers.get(vertex as usize).copied().unwrap_or(vertex))
}

/// The polygon that each face is.
fn polygons_of(mesh: &PolygonMesh) -> Vec<u32> {
    (0..mesh.face_count()).map(|face| mesh.polygon_of_face(FaceId::new(face)) as u32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_io as io;
    use coface_io::{Format, Structure};

    #[test]
    fn everything_comes_along() {
        let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 5 5\ng a\nf 1 2 3\ng b\nf 3 2 1\nf 1 3 4\n";
        let model = io::read(text.as_bytes(), Format::Obj).unwrap();
        let data = |name: &str, kind, values| CellData::integers(name, kind, 1, values).unwrap();
        let model = model
            .with_data(data("weight", GroupKind::Polygons, vec![7, 8, 9]))
            .and_then(|model| model.with_data(data("source", GroupKind::Vertices, vec![9; 5])))
            .and_then(|model| model.with_group(Group::new("ends", GroupKind::Vertices, vec![1, 4])))
            .unwrap();
        let surface = SurfaceModel::of(model).unwrap();
        assert_eq!(surface.map().f_vector(), [5, 5, 2]);
        assert_eq!([0, 1].map(|face| surface.polygon(FaceId::new(face))), [0, 2]);
        assert_eq!(surface.face_numbers(FaceId::new(1)), [0, 2, 3]);
        // The second triangle twice.
        let sources = [0, 2, 3, 1].map(VertexId::new);
        let polygons = RaggedArray::from_lists([[0, 1, 2], [2, 1, 0]]);
        let model = surface.model_over(polygons, &sources, &[1, 1].map(FaceId::new), None).unwrap();
        let members: Vec<_> = model.groups().iter().map(|group| (group.name(), group.members())).collect();
        assert_eq!(members, [("a", &[][..]), ("b", &[0, 1]), ("ends", &[3])]);
        let row = |name: &str, kind, i| model.data_named(name, kind).unwrap().integer_row(i).unwrap()[0];
        assert_eq!(row("weight", GroupKind::Polygons, 1), 9);
        assert_eq!(row("face", GroupKind::Polygons, 1), 2);
        assert_eq!(row("source", GroupKind::Vertices, 2), 3);
        assert_eq!(model.data().len(), 3);
    }

    #[test]
    fn numbers_of_facet_lists_are_kept() {
        let facets = RaggedArray::from_lists([[30, 10, 20], [20, 10, 40]]);
        let surface = SurfaceModel::of(Model::from_structure(Structure::Facets(facets))).unwrap();
        assert_eq!(surface.number(VertexId::new(3)), 40);
        assert_eq!(surface.edge_numbers(EdgeId::new(0)), [10, 20]);
        assert_eq!((surface.vertex(40), surface.vertex(11)), (Some(VertexId::new(3)), None));
    }

    #[test]
    fn what_is_no_surface_is_refused() {
        let of = |facets: &[&[u32]]| {
            let facets = RaggedArray::from_lists(facets);
            SurfaceModel::of(Model::from_structure(Structure::Facets(facets))).unwrap_err()
        };
        for error in
            [of(&[&[0, 1, 2], &[0, 1, 3], &[0, 1, 4]]), of(&[&[0, 1, 2], &[0, 3, 4]]), of(&[&[0, 1]])]
        {
            assert_eq!(error.kind(), ErrorKind::NonManifold);
            assert!(error.cure().is_some(), "{error}");
        }
        assert!(SurfaceModel::boundary_of(Model::default()).is_err());
    }
}
