//! Cells as lists of vertices.

use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{RaggedArray, SparseMatrix};
use rayon::prelude::*;
use std::borrow::Cow;

/// A cellular model of any dimension: the number of vertices, and for each degree from 1 on the cells as lists of
/// vertices.
///
/// The order of the vertices in a list says nothing, except that an edge runs from its first to its second vertex. Vertices
/// that no cell names are vertices all the same. Where lists of vertices do not tell the facets of cells, as with faces that
/// are not convex, the facets are given by [`Self::with_facets`].
///
/// # Complexity
/// 4 bytes a vertex of a cell; lists of different lengths take 4 bytes more each.
///
/// # Examples
/// Two triangles on a common edge:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::lar::LarModel;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = RaggedArray::from_lists([[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]);
/// let faces = RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]);
/// let model = LarModel::new(4, vec![edges, faces])?;
/// assert_eq!(model.f_vector(), [4, 5, 2]);
/// assert_eq!(model.shared_vertices("FE".parse()?)?.entry(0, 4), 1);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LarModel {
    vertex_count: usize,
    /// The k-cells at position k - 1; the last has one.
    cells: Vec<RaggedArray>,
    /// The facets of the k-cells at position k - 2, where they were given.
    facets: Vec<Option<RaggedArray>>,
}

impl LarModel {
    /// The model with these cells, `cells[k - 1]` the k-cells, on the vertices `0..vertex_count`.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first cell without a vertex, with a vertex that does not exist or repeats, and
    /// the first edge that has not two vertices; [`ErrorKind::TooLarge`] beyond 2^32 - 1 vertices.
    ///
    /// # Complexity
    /// $O(n \log m)$ for lists of n vertices in all, m in the longest; in parallel.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = LarModel::new(3, vec![RaggedArray::from_lists([[0, 1], [1, 2]])])?;
    /// assert!(LarModel::new(1, vec![RaggedArray::from_lists([[0, 1]])]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn new(vertex_count: usize, mut cells: Vec<RaggedArray>) -> Result<Self, Error> {
        if u32::try_from(vertex_count).is_err() {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("{vertex_count} vertices; the limit is 2^32 - 1"),
            ));
        }
        while cells.pop_if(|lists| lists.is_empty()).is_some() {}
        for (below, lists) in cells.iter().enumerate() {
            check_lists(lists, |cell, sorted| check_cell(vertex_count, below + 1, cell, sorted))?;
        }
        let facets = vec![None; cells.len().saturating_sub(1)];
        Ok(Self { vertex_count, cells, facets })
    }

    /// The same model with facets of its k-cells given as lists of positions of (k-1)-cells, one list a cell; facets given
    /// before are replaced. The order in a list says nothing.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for a degree below 2, whose facets are the vertices, and unless there is one list a cell;
    /// [`ErrorKind::InvalidInput`] naming the first cell whose facets do not exist, repeat, have a vertex that the cell has
    /// not, or leave one out.
    ///
    /// # Complexity
    /// Linear in the vertices of all facets, with a sort of each list.
    ///
    /// # Examples
    /// A quadrangle that is not convex, with an edge 0 2 outside of it:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = RaggedArray::from_lists([[0, 1], [1, 2], [2, 3], [0, 3], [0, 2]]);
    /// let model = LarModel::new(4, vec![edges, RaggedArray::from_lists([[0, 1, 2, 3]])])?;
    /// assert!(model.facets(2).is_err());
    /// let model = model.with_facets(2, RaggedArray::from_lists([[0, 1, 2, 3]]))?;
    /// assert_eq!(model.facets(2)?.list(0), [0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn with_facets(mut self, degree: usize, facets: RaggedArray) -> Result<Self, Error> {
        if degree < 2 {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "the facets of cells of degree {degree} are not given: those of edges are their vertices"
                ),
            ));
        }
        if facets.len() != self.cell_count(degree) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "{} lists of facets beside {} cells of degree {degree}",
                    facets.len(),
                    self.cell_count(degree)
                ),
            ));
        }
        if facets.is_empty() {
            return Ok(self);
        }
        let below = self.cell_count(degree - 1);
        let noun = ["edge", "face", "cell"].get(degree - 2).copied().unwrap_or("facet");
        check_lists(&facets, |cell, sorted| {
            check_list(&format!("the list of facets of cell {cell} of degree {degree}"), noun, below, sorted)
        })?;
        self.check_facet_vertices(degree, &facets)?;
        self.facets[degree - 2] = Some(facets);
        Ok(self)
    }

    /// That the vertices of the facets of each cell are its vertices.
    fn check_facet_vertices(&self, degree: usize, facets: &RaggedArray) -> Result<(), Error> {
        const UNSEEN: u32 = u32::MAX;
        // 2 * cell for a vertex of the cell, 2 * cell + 1 once a facet has it.
        let mut seen = vec![u64::from(UNSEEN) << 1; self.vertex_count];
        let lower = &self.cells[degree - 2];
        for (cell, vertices) in self.cells[degree - 1].iter().enumerate() {
            let mark = (cell as u64) << 1;
            for &vertex in vertices {
                seen[vertex as usize] = mark;
            }
            for &facet in facets.list(cell) {
                for &vertex in lower.list(facet as usize) {
                    let seen = &mut seen[vertex as usize];
                    if *seen | 1 != mark | 1 {
                        return Err(Error::invalid(format!(
                            "facet {facet} of cell {cell} of degree {degree} has the vertex {vertex}, which the cell has not"
                        )));
                    }
                    *seen |= 1;
                }
            }
            if let Some(vertex) = vertices.iter().find(|&&vertex| seen[vertex as usize] == mark) {
                return Err(Error::invalid(format!(
                    "vertex {vertex} of cell {cell} of degree {degree} lies in none of its facets"
                )));
            }
        }
        Ok(())
    }

    /// The number of vertices, isolated ones included.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = LarModel::new(3, vec![RaggedArray::from_lists([[0, 1], [1, 2]])])?;
    /// assert_eq!(path.vertex_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The highest degree with a cell; `None` without vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = LarModel::new(3, vec![RaggedArray::from_lists([[0, 1], [1, 2]])])?;
    /// assert_eq!(path.dimension(), Some(1));
    /// # Ok(()) }
    /// ```
    pub fn dimension(&self) -> Option<usize> {
        if self.vertex_count == 0 { None } else { Some(self.cells.len()) }
    }

    /// The number of cells of this degree; 0 beyond the dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = LarModel::new(3, vec![RaggedArray::from_lists([[0, 1], [1, 2]])])?;
    /// assert_eq!(path.cell_count(1), 2);
    /// # Ok(()) }
    /// ```
    pub fn cell_count(&self, degree: usize) -> usize {
        match degree {
            0 => self.vertex_count,
            _ => self.cells.get(degree - 1).map_or(0, RaggedArray::len),
        }
    }

    /// The numbers of cells of degrees 0, 1, ...; empty without vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = LarModel::new(3, vec![RaggedArray::from_lists([[0, 1], [1, 2]])])?;
    /// assert_eq!(path.f_vector(), [3, 2]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        (0..self.dimension().map_or(0, |d| d + 1)).map(|degree| self.cell_count(degree)).collect()
    }

    /// The cells of this degree by their vertices; a vertex is the list of itself.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = LarModel::new(3, vec![RaggedArray::from_lists([[0, 1], [1, 2]])])?;
    /// assert_eq!(path.cells(1).list(1), [1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn cells(&self, degree: usize) -> Cow<'_, RaggedArray> {
        match degree {
            0 => Cow::Owned(
                RaggedArray::uniform(1, (0..self.vertex_count as u32).collect())
                    .expect("there are fewer than 2^32 vertices"),
            ),
            _ => self.cells.get(degree - 1).map_or_else(|| Cow::Owned(RaggedArray::new()), Cow::Borrowed),
        }
    }

    /// The facets of the k-cells that were given, as positions of (k-1)-cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = LarModel::new(3, vec![RaggedArray::from_lists([[0, 1], [1, 2]])])?;
    /// assert!(path.given_facets(2).is_none());
    /// # Ok(()) }
    /// ```
    pub fn given_facets(&self, degree: usize) -> Option<&RaggedArray> {
        self.facets.get(degree.checked_sub(2)?)?.as_ref()
    }

    /// The characteristic matrix of this degree: rows are the cells, columns the vertices, an entry is 1 where the vertex
    /// belongs to the cell. That of degree 0 is the identity.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 32 bits.
    ///
    /// # Complexity
    /// Linear, by counting.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let model = LarModel::new(4, vec![RaggedArray::from_lists([[0, 2], [1, 2]])])?;
    /// let matrix = model.characteristic_matrix(1)?;
    /// // Vertex 3 is isolated and has its column.
    /// assert_eq!((matrix.row_count(), matrix.column_count()), (2, 4));
    /// assert_eq!(matrix.column(2).rows(), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn characteristic_matrix(&self, degree: usize) -> Result<SparseMatrix, Error> {
        let cells = self.cells(degree);
        let at = cells.transposed(self.vertex_count);
        let starts = (0..=at.len()).map(|vertex| at.start(vertex) as u32).collect();
        let count = at.item_count();
        SparseMatrix::from_trusted_parts(cells.len(), starts, at.into_items(), vec![1; count])
    }
}

/// Gives each list, sorted, to `check` with its position; the first error in their order.
fn check_lists(
    lists: &RaggedArray,
    check: impl Fn(usize, &[u32]) -> Result<(), Error> + Sync,
) -> Result<(), Error> {
    const BLOCK: usize = 1 << 12;
    let steps = stage("checking cells", lists.len().div_ceil(BLOCK));
    let block = |block: usize| {
        steps.advance(1);
        let mut sorted = Vec::new();
        (block * BLOCK..((block + 1) * BLOCK).min(lists.len())).find_map(|i| {
            let list = lists.list(i);
            if list.is_sorted_by(|a, b| a < b) {
                return check(i, list).err();
            }
            sorted.clear();
            sorted.extend_from_slice(list);
            sorted.sort_unstable();
            check(i, &sorted).err()
        })
    };
    match (0..lists.len().div_ceil(BLOCK)).into_par_iter().find_map_first(block) {
        Some(error) => Err(error),
        None => Ok(()),
    }
}

/// That a sorted list of vertices can be a cell.
fn check_cell(vertex_count: usize, degree: usize, cell: usize, sorted: &[u32]) -> Result<(), Error> {
    let name = match degree {
        1 => format!("edge {cell}"),
        2 => format!("face {cell}"),
        _ => format!("cell {cell} of degree {degree}"),
    };
    if degree == 1 && sorted.len() != 2 {
        return Err(Error::invalid(format!("{name} has {} vertices; an edge has two", sorted.len())));
    }
    check_list(&name, "vertex", vertex_count, sorted)
}

/// That a sorted list has something, that nothing repeats, and that everything is below `count`.
fn check_list(name: &str, noun: &str, count: usize, sorted: &[u32]) -> Result<(), Error> {
    let Some(&last) = sorted.last() else {
        return Err(Error::invalid(format!("{name} is empty")).with_cure("leave it out"));
    };
    if last as usize >= count {
        return Err(Error::invalid(format!("{name} names the {noun} {last}, but there are {count}"))
            .with_cure("number from 0 on"));
    }
    match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(Error::invalid(format!("{name} names the {noun} {} twice", pair[0]))),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::cube;
    use super::*;

    fn lists<const N: usize, const M: usize>(lists: [[u32; N]; M]) -> RaggedArray {
        RaggedArray::from_lists(lists)
    }

    #[test]
    fn faults_are_named() {
        let message = |cells: Vec<RaggedArray>| LarModel::new(4, cells).unwrap_err().to_string();
        assert_eq!(
            message(vec![lists([[0, 1], [1, 4]])]),
            "edge 1 names the vertex 4, but there are 4; number from 0 on"
        );
        assert_eq!(message(vec![lists([[2, 2]])]), "edge 0 names the vertex 2 twice");
        assert_eq!(message(vec![lists([[0, 1, 2]])]), "edge 0 has 3 vertices; an edge has two");
        assert_eq!(
            message(vec![lists([[0, 1]]), lists([[0, 1, 3], [3, 1, 3]])]),
            "face 1 names the vertex 3 twice"
        );
        let empty = RaggedArray::from_lists([vec![0], vec![]]);
        assert_eq!(
            message(vec![lists([[0, 1]]), lists([[0, 1, 2]]), empty]),
            "cell 1 of degree 3 is empty; leave it out"
        );
    }

    #[test]
    fn models_without_cells_are_models() {
        let nothing = LarModel::new(0, vec![]).unwrap();
        assert_eq!((nothing.dimension(), nothing.f_vector()), (None, vec![]));
        let points = LarModel::new(3, vec![RaggedArray::new(), RaggedArray::new()]).unwrap();
        assert_eq!((points.dimension(), points.f_vector()), (Some(0), vec![3]));
        assert_eq!(points.characteristic_matrix(0).unwrap(), SparseMatrix::identity(3).unwrap());
        assert_eq!(points.characteristic_matrix(1).unwrap(), SparseMatrix::zero(0, 3).unwrap());
        // A gap in the degrees stays.
        let gap = LarModel::new(3, vec![RaggedArray::new(), lists([[0, 1, 2]])]).unwrap();
        assert_eq!(gap.f_vector(), [3, 0, 1]);
    }

    #[test]
    fn given_facets_are_checked() {
        let cube = cube();
        let message = |list: &[u32]| {
            let mut facets = RaggedArray::from_lists([list]);
            (1..6).for_each(|_| facets.push(&[0, 1, 4, 5]));
            cube.clone().with_facets(2, facets).unwrap_err().to_string()
        };
        assert_eq!(
            message(&[0, 1, 4, 12]),
            "the list of facets of cell 0 of degree 2 names the edge 12, but there are 12; number from 0 on"
        );
        assert_eq!(message(&[0, 0, 4]), "the list of facets of cell 0 of degree 2 names the edge 0 twice");
        assert_eq!(
            message(&[0, 4, 8]),
            "facet 8 of cell 0 of degree 2 has the vertex 4, which the cell has not"
        );
        assert_eq!(message(&[0, 4]), "vertex 3 of cell 0 of degree 2 lies in none of its facets");
        assert_eq!(cube.clone().with_facets(1, RaggedArray::new()).unwrap_err().kind(), ErrorKind::Shape);
        assert_eq!(cube.clone().with_facets(2, RaggedArray::new()).unwrap_err().kind(), ErrorKind::Shape);
        assert_eq!(cube.clone().with_facets(7, RaggedArray::new()).unwrap(), cube);
    }
}
