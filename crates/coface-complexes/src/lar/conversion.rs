//! Models of the meshes and complexes that have their cells identified already.

use super::LarModel;
use crate::cell_mesh::CellMesh;
use crate::simplicial::FrozenComplex;
use crate::surface::PolygonMesh;
use coface_algebra::Error;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, FaceId};
use coface_algebra::{RaggedArray, SparseMatrix};

/// The cells of all degrees of a polygon mesh in the order of their ids, edges from the smaller to the larger end, with the
/// edges of each face given.
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::lar::LarModel;
/// use coface_complexes::surface::PolygonMesh;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mesh = PolygonMesh::new(5, RaggedArray::from_lists([[0, 1, 2, 3]]), &[[3, 4]])?;
/// let model = LarModel::try_from(&mesh)?;
/// assert_eq!(model.f_vector(), [5, 5, 1]);
/// // The edges are 01, 03, 12, 23 and 34.
/// assert_eq!(model.facets(2)?.list(0), [0, 2, 3, 1]);
/// # Ok(()) }
/// ```
impl TryFrom<&PolygonMesh> for LarModel {
    type Error = Error;

    fn try_from(mesh: &PolygonMesh) -> Result<Self, Error> {
        let edges = RaggedArray::uniform(2, mesh.edge_ends().to_vec())?;
        let model = Self::new(mesh.vertex_count(), vec![edges, mesh.polygons().clone()])?;
        model.with_facets(2, face_edges(mesh)?)
    }
}

/// The edges of each face, in the order of its sides.
fn face_edges(mesh: &PolygonMesh) -> Result<RaggedArray, Error> {
    let starts = (0..=mesh.face_count()).map(|face| mesh.polygons().start(face) as u32).collect();
    RaggedArray::from_parts(starts, mesh.corner_edges().to_vec())
}

/// The cells of all degrees of a cell mesh in the order of their ids, with the edges of each face and the faces of each
/// cell given.
impl TryFrom<&CellMesh> for LarModel {
    type Error = Error;

    fn try_from(mesh: &CellMesh) -> Result<Self, Error> {
        let skeleton = mesh.skeleton();
        let edges = RaggedArray::uniform(2, skeleton.edge_ends().to_vec())?;
        let cells = vec![edges, skeleton.polygons().clone(), mesh.cells().clone()];
        let (mut starts, mut faces) = (vec![0], Vec::new());
        for cell in 0..mesh.cell_count() {
            faces.extend(mesh.faces_of_cell(CellId::new(cell)).map(|(face, _): (FaceId, _)| face.to_u32()));
            starts.push(faces.len() as u32);
        }
        Self::new(mesh.vertex_count(), cells)?
            .with_facets(2, face_edges(skeleton)?)?
            .with_facets(3, RaggedArray::from_parts(starts, faces)?)
    }
}

/// The simplices of all dimensions in the order of the complex, with their facets given. A vertex has the number of its
/// 0-simplex, so gaps in the numbers of the complex are closed.
impl TryFrom<&FrozenComplex> for LarModel {
    type Error = Error;

    fn try_from(complex: &FrozenComplex) -> Result<Self, Error> {
        let names = complex.flat(0);
        let has_gaps = names.last().is_some_and(|&last| last as usize >= names.len());
        let mut cells = Vec::new();
        for k in 1..=complex.dimension().unwrap_or(0) {
            let mut numbers = complex.flat(k).to_vec();
            if has_gaps {
                for number in &mut numbers {
                    let rank = names.binary_search(number).expect("vertices of simplices are 0-simplices");
                    *number = rank as u32;
                }
            }
            cells.push(RaggedArray::uniform(k + 1, numbers)?);
        }
        let mut model = Self::new(names.len(), cells)?;
        for (k, matrix) in (1..).zip(complex.chain_complex()?.boundary_matrices()).skip(1) {
            model = model.with_facets(k, columns(matrix)?)?;
        }
        Ok(model)
    }
}

/// The cells of a chain complex, each with the vertices that its facets have, rising, and with its facets given; edges run
/// from the vertex with the entry -1 to that with 1.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] naming the first cell whose vertices its boundary does not tell: an edge without two
/// ends, or another cell without a boundary.
///
/// # Examples
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_complexes::lar::LarModel;
/// use coface_algebra::chains::ChainComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, 1), (1, 0, -1), (1, 1, -1), (2, 1, 1)])?;
/// let path = LarModel::try_from(&ChainComplex::new(vec![edges])?)?;
/// assert!(path.cells(1).iter().eq([[1, 0], [1, 2]]));
/// # Ok(()) }
/// ```
impl TryFrom<&ChainComplex> for LarModel {
    type Error = Error;

    fn try_from(complex: &ChainComplex) -> Result<Self, Error> {
        let untold = |fault: String| {
            Error::invalid(format!("{fault}, so the cells are not sets of vertices"))
                .with_cure("give the complex as facets, polygons or cells")
        };
        let mut cells: Vec<RaggedArray> = Vec::new();
        for (degree, matrix) in (1..).zip(complex.boundary_matrices()) {
            let mut lists = RaggedArray::new();
            let mut vertices: Vec<u32> = Vec::new();
            for (cell, column) in matrix.columns().enumerate() {
                vertices.clear();
                match cells.last() {
                    None => match (column.rows(), column.entries()) {
                        (&[start, end], [-1, 1]) | (&[end, start], [1, -1]) => vertices.extend([start, end]),
                        _ => {
                            return Err(untold(format!(
                                "edge {cell} does not run from one vertex to another"
                            )));
                        }
                    },
                    Some(lower) => {
                        let facets = column.rows().iter();
                        vertices.extend(facets.flat_map(|&facet| lower.list(facet as usize)));
                        vertices.sort_unstable();
                        vertices.dedup();
                        if vertices.is_empty() {
                            return Err(untold(format!("cell {cell} of degree {degree} has no boundary")));
                        }
                    }
                }
                lists.push(&vertices);
            }
            cells.push(lists);
        }
        let mut model = Self::new(complex.cell_count(0), cells)?;
        for (degree, matrix) in (1..).zip(complex.boundary_matrices()).skip(1) {
            if matrix.column_count() > 0 {
                model = model.with_facets(degree, columns(matrix)?)?;
            }
        }
        Ok(model)
    }
}

/// The rows with an entry, column by column.
pub(super) fn columns(matrix: &SparseMatrix) -> Result<RaggedArray, Error> {
    RaggedArray::from_parts(matrix.column_starts().to_vec(), matrix.rows().to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell_mesh::CellShape;

    #[test]
    fn a_hexahedron_is_a_model_with_its_facets() {
        let cells = RaggedArray::from_lists([[0, 1, 2, 3, 4, 5, 6, 7]]);
        let mesh =
            CellMesh::new(9, vec![CellShape::Hexahedron], cells, &RaggedArray::new(), &[[7, 8]]).unwrap();
        let model = LarModel::try_from(&mesh).unwrap();
        assert_eq!(model.f_vector(), [9, 13, 6, 1]);
        assert_eq!(model.given_facets(3).unwrap().item_count(), 6);
        assert_eq!(model.given_facets(2).unwrap().item_count(), 24);
    }

    /// Of a mesh and of its chain complex: the same cells, and the same facets as sets.
    #[test]
    fn a_chain_complex_tells_the_cells_of_its_mesh() {
        let cells = RaggedArray::from_lists([[0, 1, 2, 3, 4, 5, 6, 7]]);
        let mesh =
            CellMesh::new(9, vec![CellShape::Hexahedron], cells, &RaggedArray::new(), &[[7, 8]]).unwrap();
        let (own, told) =
            (LarModel::try_from(&mesh).unwrap(), LarModel::try_from(&mesh.chain_complex().unwrap()).unwrap());
        assert_eq!(own.f_vector(), told.f_vector());
        for operator in ["VV", "EE", "FE", "FF", "CF", "CV"].map(|name| name.parse().unwrap()) {
            assert_eq!(own.shared_vertices(operator).unwrap(), told.shared_vertices(operator).unwrap());
            assert_eq!(own.incident(operator).unwrap(), told.incident(operator).unwrap());
        }
        let loop_edge = ChainComplex::new(vec![SparseMatrix::zero(1, 1).unwrap()]).unwrap();
        let error = LarModel::try_from(&loop_edge).unwrap_err();
        assert!(error.message().contains("edge 0 does not run from one vertex to another"), "{error}");
    }

    #[test]
    fn gaps_between_the_numbers_of_simplices_are_closed() {
        let complex = FrozenComplex::from_facets(&RaggedArray::from_lists([[7, 3, 100, 9, 4]])).unwrap();
        let model = LarModel::try_from(&complex).unwrap();
        assert_eq!(model.f_vector(), [5, 10, 10, 5, 1]);
        assert_eq!(model.cells(4).list(0), [0, 1, 2, 3, 4]);
        assert_eq!(model.given_facets(4).unwrap().list(0), [0, 1, 2, 3, 4]);
        let nothing = LarModel::try_from(&FrozenComplex::default()).unwrap();
        assert_eq!(nothing.dimension(), None);
    }
}
