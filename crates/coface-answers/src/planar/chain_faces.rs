//! Faces of chain complexes in the plane as polygons.

use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, ErrorKind, RaggedArray};
use coface_arrange::spatial::closed_walks;

/// So many sides of faces at most run along one edge, counted with its coefficients.
const MOST_SIDES: u32 = 1 << 16;

/// What a chain complex draws: the edges, the loops that bound its faces, and which edges are in none.
pub(super) struct ChainFaces {
    /// The two ends of each edge.
    pub(super) edges: Vec<[u32; 2]>,
    /// The vertices of each loop.
    pub(super) loops: RaggedArray,
    /// The loops of each face.
    pub(super) faces: RaggedArray,
    /// Whether an edge is in the boundary of a face.
    pub(super) is_side: Vec<bool>,
}

/// Whether a chain complex has cells of degree 2.
pub(super) fn has_faces(complex: &ChainComplex) -> bool {
    complex.degree_count() > 2 && complex.cell_count(2) > 0
}

impl ChainFaces {
    /// The edges and the faces of a complex.
    ///
    /// The boundary of a face is a sum of loops, each of which visits a vertex once: they wind around the face once more than around
    /// what is beside it, so that loops around its holes run the other way.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming an edge that does not run from one vertex to another; [`ErrorKind::TooLarge`] naming a
    /// coefficient beyond 2^16.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n coefficients.
    pub(super) fn new(complex: &ChainComplex) -> Result<Self, Error> {
        let mut edges = Vec::new();
        if let Some(matrix) = complex.boundary_matrix(1) {
            for (edge, column) in matrix.columns().enumerate() {
                let ends: Vec<(usize, i32)> = column.iter().collect();
                edges.push(match ends[..] {
                    [(a, -1), (b, 1)] | [(b, 1), (a, -1)] => [a as u32, b as u32],
                    _ => {
                        return Err(Error::invalid(format!(
                            "edge e{edge} does not run from one vertex to another"
                        ))
                        .with_cure("give each edge the coefficients -1 and 1 on its two ends"));
                    }
                });
            }
        }
        let mut made = Self {
            is_side: vec![false; edges.len()],
            edges,
            loops: RaggedArray::new(),
            faces: RaggedArray::new(),
        };
        let Some(matrix) = complex.boundary_matrix(2) else { return Ok(made) };
        for (face, column) in matrix.columns().enumerate() {
            let mut sides: Vec<[u32; 2]> = Vec::new();
            for (edge, coefficient) in column.iter() {
                if coefficient.unsigned_abs() > MOST_SIDES {
                    let message = format!("face f{face} runs {coefficient} times along edge e{edge}");
                    return Err(Error::new(ErrorKind::TooLarge, message)
                        .with_cure("give each face of a drawing the coefficients -1 and 1 on its sides"));
                }
                made.is_side[edge] = true;
                let [a, b] = made.edges[edge];
                let side = if coefficient < 0 { [b, a] } else { [a, b] };
                sides.extend((0..coefficient.unsigned_abs()).map(|_| side));
            }
            let first = made.loops.len() as u32;
            for own in closed_walks(&mut sides).iter() {
                made.loops.push(own);
            }
            made.faces.push(&(first..made.loops.len() as u32).collect::<Vec<u32>>());
        }
        Ok(made)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::SparseMatrix;

    #[test]
    fn faces_have_the_sides_of_their_columns() {
        let edges = SparseMatrix::from_entries(
            3,
            3,
            [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)],
        );
        let faces = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, -1)]);
        let complex = ChainComplex::new(vec![edges.unwrap(), faces.unwrap()]).unwrap();
        assert!(has_faces(&complex));
        let made = ChainFaces::new(&complex).unwrap();
        assert_eq!(made.edges, [[0, 1], [1, 2], [0, 2]]);
        assert_eq!(made.loops.iter().collect::<Vec<_>>(), [[0, 1, 2]]);
        assert_eq!((made.faces.len(), made.is_side), (1, vec![true; 3]));
    }
}
