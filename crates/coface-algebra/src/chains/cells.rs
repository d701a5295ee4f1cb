//! What every producer of cells has in common.

use super::{ChainComplex, TwoSkeleton};
use crate::ids::narrow;
use crate::{EdgeId, Error, ErrorKind, FaceId, RaggedArray};

/// A producer: something that is made of cells and has a chain complex.
///
/// All answers number the cells alike: cell j of degree k is column j of the boundary matrix of degree k of
/// [`Self::chain_complex`], entry k of [`Self::f_vector`] counts these columns, and list j of
/// [`Self::cell_vertices`] belongs to it.
///
/// A producer that stores its counts also has an inherent method `f_vector`, which cannot fail.
///
/// # Examples
/// One question for every producer:
/// ```
/// use coface_algebra::chains::{Cells, ChainComplex};
/// use coface_algebra::{Error, SparseMatrix};
/// fn alternating_sum(cells: &impl Cells) -> Result<i64, Error> {
///     Ok(cells.f_vector()?.iter().rev().fold(0, |sum, &count| count as i64 - sum))
/// }
/// # fn main() -> Result<(), Error> {
/// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
/// assert_eq!(alternating_sum(&segment)?, 1);
/// assert_eq!(segment.cell_vertices(1)?.list(0), [0, 1]);
/// # Ok(()) }
/// ```
pub trait Cells {
    /// The chain complex of the cells, in the order of the producer.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for boundary matrices beyond 32 bits, and what the producer names.
    fn chain_complex(&self) -> Result<ChainComplex, Error>;

    /// The vertices, edges and faces with the paths around the faces.
    ///
    /// # Errors
    /// As [`Self::chain_complex`]; [`ErrorKind::InvalidInput`] if nothing but the boundary matrices is known, and they do
    /// not tell the path around some face.
    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        TwoSkeleton::from_chain_complex(&self.chain_complex()?)
    }

    /// The vertices of each cell of this degree, by the names that the producer gives to its vertices; no list beyond
    /// the dimension. List i of degree 0 is the name of vertex i alone. An edge is listed from its source to its target,
    /// a face around where it has one path around it.
    ///
    /// # Errors
    /// As [`Self::chain_complex`].
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.chain_complex()?.cell_vertices(degree)
    }

    /// The numbers of cells of degrees 0, 1, ... Zeros may follow the last degree that has a cell.
    ///
    /// # Errors
    /// As [`Self::chain_complex`], where the cells must be made to be counted.
    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.chain_complex()?.f_vector().to_vec())
    }
}

impl Cells for ChainComplex {
    /// A copy.
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        Ok(self.clone())
    }

    /// The vertices of the facets of each cell, rising from degree 2 on. A cell has those vertices that its boundary
    /// matrix leads to, so a loop has none.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        if degree == 0 {
            let count = u32::try_from(self.cell_count(0)).map_err(|_| {
                Error::new(
                    ErrorKind::TooLarge,
                    format!("{} vertices; the limit is 2^32 - 1", self.cell_count(0)),
                )
            })?;
            return RaggedArray::uniform(1, (0..count).collect());
        }
        let mut lists = RaggedArray::new();
        let Some(edges) = self.boundary_matrix(1) else { return Ok(lists) };
        for edge in edges.columns() {
            match (edge.rows(), edge.entries()) {
                (&[a, b], &[1, -1]) => lists.push(&[b, a]),
                (rows, _) => lists.push(rows),
            }
        }
        for k in 2..=degree {
            let Some(matrix) = self.boundary_matrix(k) else { return Ok(RaggedArray::new()) };
            let lower = std::mem::take(&mut lists);
            let mut vertices: Vec<u32> = Vec::new();
            for cell in matrix.columns() {
                vertices.clear();
                vertices.extend(cell.rows().iter().flat_map(|&facet| lower.list(facet as usize)));
                vertices.sort_unstable();
                vertices.dedup();
                lists.push(&vertices);
            }
        }
        Ok(lists)
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector().to_vec())
    }
}

impl Cells for TwoSkeleton {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    /// A copy.
    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        Ok(self.clone())
    }

    /// A face has the vertices that its path starts a step at; a vertex stands as often as the path comes by.
    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        match degree {
            0 => RaggedArray::uniform(1, (0..narrow(self.vertex_count())).collect()),
            1 => RaggedArray::uniform(2, self.edge_ends().to_vec()),
            2 => {
                let mut lists = RaggedArray::new();
                let mut corners = Vec::new();
                for face in (0..self.face_count()).map(FaceId::new) {
                    corners.clear();
                    corners.extend(
                        self.faces().list(face.index()).iter().map(|&step| self.edge_ends()[step as usize]),
                    );
                    if corners.is_empty() {
                        corners.push(self.start(face).to_u32());
                    }
                    lists.push(&corners);
                }
                Ok(lists)
            }
            _ => Ok(RaggedArray::new()),
        }
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

impl TwoSkeleton {
    /// The vertices, edges and faces of a complex in which each edge goes from one vertex to another, and the boundary of
    /// each face is one path that meets no vertex twice. The path starts along the lowest edge. The cells of degree 3
    /// become [`Self::solids`].
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first edge or face that is attached in another way: its boundary does not tell how.
    ///
    /// # Complexity
    /// $O(n \log m)$ for n incidences of edges and faces, m in one face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::{ChainComplex, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let rim = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
    /// let edges = SparseMatrix::from_entries(3, 3, rim)?;
    /// let face = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, -1)])?;
    /// let triangle = TwoSkeleton::from_chain_complex(&ChainComplex::new(vec![edges, face])?)?;
    /// // Along edges 0 and 1, and back along edge 2.
    /// assert_eq!(triangle.faces().list(0), [0, 2, 5]);
    /// # Ok(()) }
    /// ```
    pub fn from_chain_complex(complex: &ChainComplex) -> Result<Self, Error> {
        let mut ends = Vec::with_capacity(2 * complex.cell_count(1));
        for (edge, column) in
            complex.boundary_matrix(1).into_iter().flat_map(|matrix| matrix.columns()).enumerate()
        {
            match (column.rows(), column.entries()) {
                (&[a, b], &[-1, 1]) => ends.extend([a, b]),
                (&[a, b], &[1, -1]) => ends.extend([b, a]),
                _ => {
                    let edge = EdgeId::new(edge);
                    return Err(Error::invalid(format!(
                        "the boundary of edge {edge} does not name its two ends"
                    ))
                    .with_cure("use a producer that stores the ends of its edges"));
                }
            }
        }
        let mut faces = RaggedArray::new();
        // The steps of one face by the vertex they start at.
        let (mut steps, mut path): (Vec<(u32, u32)>, Vec<u32>) = (Vec::new(), Vec::new());
        for (face, column) in
            complex.boundary_matrix(2).into_iter().flat_map(|matrix| matrix.columns()).enumerate()
        {
            steps.clear();
            path.clear();
            let is_unit = column.entries().iter().all(|entry| entry.abs() == 1);
            for (edge, &entry) in column.rows().iter().zip(column.entries()) {
                let step = 2 * edge + u32::from(entry < 0);
                steps.push((ends[step as usize], step));
            }
            let mut next = steps.first().map(|&(_, step)| step);
            steps.sort_unstable();
            let is_simple = is_unit && steps.windows(2).all(|pair| pair[0].0 != pair[1].0);
            while let Some(step) = next.filter(|_| is_simple) {
                path.push(step);
                let target = ends[(step ^ 1) as usize];
                let at = steps.binary_search_by_key(&target, |&(from, _)| from).ok();
                next = at.map(|at| steps[at].1).filter(|&step| step != path[0]);
            }
            if path.is_empty() || path.len() < steps.len() {
                let face = FaceId::new(face);
                return Err(Error::invalid(format!(
                    "the boundary of face {face} is not one path without repeated vertices"
                ))
                .with_cure("use a producer that stores the path around each face"));
            }
            faces.push(&path);
        }
        let skeleton = Self::new(complex.cell_count(0), ends, faces)?;
        match complex.boundary_matrix(3) {
            None => Ok(skeleton),
            Some(matrix) => skeleton
                .with_solids(RaggedArray::from_lists(matrix.columns().map(|cell| cell.rows().to_vec()))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SparseMatrix;

    #[test]
    fn boundaries_that_tell_no_path_are_named() {
        let of = |edges: &[(usize, usize, i64)], edge_count, faces: &[(usize, usize, i64)]| {
            let edges = SparseMatrix::from_entries(4, edge_count, edges.iter().copied()).unwrap();
            let faces = SparseMatrix::from_entries(edge_count, 1, faces.iter().copied()).unwrap();
            TwoSkeleton::from_chain_complex(&ChainComplex::new(vec![edges, faces]).unwrap())
        };
        let message = |found: Result<TwoSkeleton, Error>| found.unwrap_err().message().to_owned();
        let digon = [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)];
        assert_eq!(of(&digon, 2, &[(0, 0, 1), (1, 0, -1)]).unwrap().faces().list(0), [0, 3]);
        assert_eq!(message(of(&[], 1, &[])), "the boundary of edge e0 does not name its two ends");
        let fault = "the boundary of face f0 is not one path without repeated vertices";
        assert_eq!(message(of(&digon, 2, &[])), fault);
        assert_eq!(message(of(&digon, 2, &[(0, 0, 2), (1, 0, -2)])), fault);
        // An annulus between two digons.
        let two = [digon.as_slice(), &[(2, 2, -1), (3, 2, 1), (2, 3, -1), (3, 3, 1)]].concat();
        assert_eq!(message(of(&two, 4, &[(0, 0, 1), (1, 0, -1), (2, 0, 1), (3, 0, -1)])), fault);
    }
}
