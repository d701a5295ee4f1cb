//! Simplices or cuboids of one dimension on one list of positions.

use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_geometry::Positions;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// What the cells of one list are, and how they list their vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CellKind {
    /// A simplex of dimension d lists its d + 1 vertices; their order is its orientation.
    Simplex,
    /// A cuboid of dimension d lists its $2^d$ vertices as a product of segments does: local vertex i lies at the upper
    /// end of axis a when bit d - 1 - a of i is set. So the last axis is the fastest, and a square is listed as 00, 01,
    /// 10, 11, which is not its cycle. Its orientation is that of its axes in their order.
    Cuboid,
}

impl CellKind {
    /// The number of vertices of a cell of this dimension; `None` beyond $2^{31}$.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::shapes::CellKind;
    /// assert_eq!(CellKind::Simplex.vertex_count(3), Some(4));
    /// assert_eq!(CellKind::Cuboid.vertex_count(3), Some(8));
    /// assert_eq!(CellKind::Cuboid.vertex_count(64), None);
    /// ```
    pub const fn vertex_count(self, dimension: usize) -> Option<usize> {
        match self {
            _ if dimension >= 1 << 31 => None,
            Self::Simplex => Some(dimension + 1),
            Self::Cuboid if dimension < 32 => Some(1 << dimension),
            Self::Cuboid => None,
        }
    }

    /// The name of such cells: `simplices` or `cuboids`.
    pub const fn plural(self) -> &'static str {
        match self {
            Self::Simplex => "simplices",
            Self::Cuboid => "cuboids",
        }
    }
}

/// Cells of one kind and one dimension on one list of positions. Vertices that no cell uses are kept.
///
/// # Examples
/// A unit square, as one cuboid and as two triangles:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::shapes::{CellKind, PlacedCells};
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let corners = Positions::from_flat(2, vec![0., 0., 0., 1., 1., 0., 1., 1.])?;
/// let square = RaggedArray::from_lists([[0, 1, 2, 3]]);
/// let square = PlacedCells::new(corners.clone(), CellKind::Cuboid, 2, square)?;
/// assert_eq!((square.dimension(), square.cell_count()), (2, 1));
/// let halves = RaggedArray::from_lists([[0, 2, 1], [2, 3, 1]]);
/// let halves = PlacedCells::new(corners, CellKind::Simplex, 2, halves)?;
/// assert_eq!((halves.dimension(), halves.cell_count()), (2, 2));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedCells {
    positions: Positions,
    kind: CellKind,
    dimension: usize,
    cells: RaggedArray,
}

impl PlacedCells {
    /// These cells of this kind and dimension; a cell of dimension 0 is one vertex.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first cell with a wrong number of vertices, with a vertex that has no
    /// position, or with one twice; [`ErrorKind::TooLarge`] for cuboids of dimension 32 or more.
    ///
    /// # Complexity
    /// Linear, but for simplices of many vertices, which are sorted.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(1, vec![0.0, 1.0, 3.0])?;
    /// let cells = PlacedCells::new(corners, CellKind::Simplex, 1, RaggedArray::from_lists([[0, 1], [1, 2]]))?;
    /// assert_eq!(cells.cell_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn new(
        positions: Positions,
        kind: CellKind,
        dimension: usize,
        cells: RaggedArray,
    ) -> Result<Self, Error> {
        let Some(width) = kind.vertex_count(dimension) else {
            let message = format!("{} of dimension {dimension} have too many vertices", kind.plural());
            return Err(Error::new(ErrorKind::TooLarge, message));
        };
        let count = positions.len();
        for (i, cell) in cells.iter().enumerate() {
            if cell.len() != width {
                let message = format!(
                    "cell {i} has {} vertices; {} of dimension {dimension} have {width}",
                    cell.len(),
                    kind.plural()
                );
                return Err(Error::invalid(message));
            }
            if let Some(vertex) = cell.iter().find(|&&vertex| vertex as usize >= count) {
                let message = format!(
                    "cell {i} names vertex {vertex}, but there are {count} positions, numbered from 0"
                );
                return Err(Error::invalid(message));
            }
            if let Some(vertex) = repeated(cell) {
                return Err(Error::invalid(format!("cell {i} repeats vertex {vertex}"))
                    .with_cure("leave the cell out: it has no interior"));
            }
        }
        Ok(Self { positions, kind, dimension, cells })
    }

    /// The cells of a rule that names only vertices that it has placed.
    pub(crate) fn from_trusted(
        positions: Positions,
        kind: CellKind,
        dimension: usize,
        cells: RaggedArray,
    ) -> Self {
        debug_assert!(Self::new(positions.clone(), kind, dimension, cells.clone()).is_ok());
        Self { positions, kind, dimension, cells }
    }

    /// The positions of the vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(1, vec![0.0, 1.0, 3.0])?;
    /// let cells = PlacedCells::new(corners, CellKind::Simplex, 1, RaggedArray::from_lists([[0, 1], [1, 2]]))?;
    /// assert_eq!(cells.positions().as_flat(), [0.0, 1.0, 3.0]);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// What the cells are.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(1, vec![0.0, 1.0, 3.0])?;
    /// let cells = PlacedCells::new(corners, CellKind::Simplex, 1, RaggedArray::from_lists([[0, 1], [1, 2]]))?;
    /// assert_eq!(cells.kind(), CellKind::Simplex);
    /// # Ok(()) }
    /// ```
    pub fn kind(&self) -> CellKind {
        self.kind
    }

    /// The dimension of the cells; that of the space around them is [`Positions::dimension`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(1, vec![0.0, 1.0, 3.0])?;
    /// let cells = PlacedCells::new(corners, CellKind::Simplex, 1, RaggedArray::from_lists([[0, 1], [1, 2]]))?;
    /// assert_eq!(cells.dimension(), 1);
    /// # Ok(()) }
    /// ```
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The cells by their vertices, in the order that [`CellKind`] describes.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(1, vec![0.0, 1.0, 3.0])?;
    /// let cells = PlacedCells::new(corners, CellKind::Simplex, 1, RaggedArray::from_lists([[0, 1], [1, 2]]))?;
    /// assert_eq!(cells.cells().list(1), [1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn cells(&self) -> &RaggedArray {
        &self.cells
    }

    /// The number of vertices, those that no cell uses included.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(1, vec![0.0, 1.0, 3.0])?;
    /// let cells = PlacedCells::new(corners, CellKind::Simplex, 1, RaggedArray::from_lists([[0, 1], [1, 2]]))?;
    /// assert_eq!(cells.vertex_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// The number of cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(1, vec![0.0, 1.0, 3.0])?;
    /// let cells = PlacedCells::new(corners, CellKind::Simplex, 1, RaggedArray::from_lists([[0, 1], [1, 2]]))?;
    /// assert_eq!(cells.cell_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn cell_count(&self) -> usize {
        self.cells.len()
    }

    /// The same cells at other positions, perhaps of another dimension.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there are as many positions as before.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = Positions::from_flat(1, vec![0., 1.])?;
    /// let segment = PlacedCells::new(line, CellKind::Simplex, 1, RaggedArray::from_lists([[0, 1]]))?;
    /// let lifted = segment.with_positions(Positions::from_flat(2, vec![0., 0., 3., 4.])?)?;
    /// assert_eq!(lifted.positions().distances(lifted.cells().items())?, [5.0]);
    /// # Ok(()) }
    /// ```
    pub fn with_positions(self, positions: Positions) -> Result<Self, Error> {
        if positions.len() != self.positions.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} positions for {} vertices", positions.len(), self.positions.len()),
            ));
        }
        Ok(Self { positions, ..self })
    }

    /// The cells on the vertices that they use, in their order.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = Positions::from_flat(1, vec![0., 5., 7.])?;
    /// let segment = PlacedCells::new(line, CellKind::Simplex, 1, RaggedArray::from_lists([[2, 0]]))?;
    /// let compacted = segment.compacted();
    /// assert_eq!((compacted.positions().as_flat(), compacted.cells().list(0)), (&[0.0, 7.0][..], &[1, 0][..]));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn compacted(&self) -> Self {
        let mut number = vec![NONE; self.vertex_count()];
        self.cells.items().iter().for_each(|&vertex| number[vertex as usize] = 0);
        let (mut next, mut coordinates) = (0, Vec::new());
        for (vertex, number) in number.iter_mut().enumerate().filter(|(_, number)| **number == 0) {
            *number = next;
            next += 1;
            coordinates.extend_from_slice(self.positions.point(VertexId::new(vertex)));
        }
        let mut cells = self.cells.clone();
        cells.items_mut().iter_mut().for_each(|vertex| *vertex = number[*vertex as usize]);
        let positions = Positions::from_flat(self.positions.dimension(), coordinates)
            .expect("some of the positions are positions");
        Self { positions, cells, ..*self }
    }

    /// The same cells in a space of more dimensions: zeros are appended to the coordinates.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if the space has fewer dimensions than now.
    ///
    /// # Examples
    /// ```
    /// let circle = coface_complexes::shapes::circle(1.0, 4)?.embedded(3)?;
    /// assert_eq!(circle.positions().as_flat()[..6], [1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn embedded(self, space: usize) -> Result<Self, Error> {
        let old = self.positions.dimension();
        if space < old {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("positions of dimension {old} do not fit into a space of dimension {space}"),
            ));
        }
        if old == 0 {
            return Ok(self);
        }
        let padded = |point: &[f64]| -> Vec<f64> {
            point.iter().copied().chain(std::iter::repeat_n(0.0, space - old)).collect()
        };
        let coordinates = self.positions.as_flat().chunks(old).flat_map(padded).collect();
        Ok(Self { positions: Positions::from_flat(space, coordinates)?, ..self })
    }

    /// The positions and the cells, given away.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(1, vec![0.0, 1.0, 3.0])?;
    /// let cells = PlacedCells::new(corners, CellKind::Simplex, 1, RaggedArray::from_lists([[0, 1], [1, 2]]))?;
    /// assert_eq!(cells.into_parts().1.len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn into_parts(self) -> (Positions, RaggedArray) {
        (self.positions, self.cells)
    }
}

/// A vertex that stands twice in a cell; short cells are compared pairwise, long ones sorted.
fn repeated(cell: &[u32]) -> Option<u32> {
    if cell.len() <= 16 {
        return cell.iter().enumerate().find(|(i, vertex)| cell[..*i].contains(vertex)).map(|(_, &v)| v);
    }
    let mut sorted = cell.to_vec();
    sorted.sort_unstable();
    sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(count: usize) -> Positions {
        Positions::from_flat(1, (0..count).map(|i| i as f64).collect()).unwrap()
    }

    #[test]
    fn faults_are_named() {
        let fault = |kind, dimension, cell: &[u32]| {
            let cells = RaggedArray::from_lists([cell]);
            PlacedCells::new(line(40), kind, dimension, cells).unwrap_err().to_string()
        };
        assert!(
            fault(CellKind::Simplex, 2, &[0, 1]).contains("cell 0 has 2 vertices; simplices of dimension 2")
        );
        assert!(fault(CellKind::Cuboid, 2, &[0, 1, 2]).contains("cuboids of dimension 2 have 4"));
        assert!(
            fault(CellKind::Simplex, 1, &[0, 40]).contains("names vertex 40, but there are 40 positions")
        );
        assert!(fault(CellKind::Simplex, 2, &[3, 1, 3]).contains("repeats vertex 3"));
        let mut long: Vec<u32> = (0..32).collect();
        long[31] = 5;
        assert!(fault(CellKind::Cuboid, 5, &long).contains("repeats vertex 5"));
        assert!(fault(CellKind::Cuboid, 40, &[]).contains("too many vertices"));
    }

    #[test]
    fn points_and_nothing_are_ordinary() {
        let points =
            PlacedCells::new(line(2), CellKind::Cuboid, 0, RaggedArray::from_lists([[1], [0]])).unwrap();
        assert_eq!((points.dimension(), points.vertex_count(), points.cell_count()), (0, 2, 2));
        let nothing =
            PlacedCells::new(Positions::default(), CellKind::Simplex, 3, RaggedArray::new()).unwrap();
        assert_eq!((nothing.dimension(), nothing.cell_count()), (3, 0));
        assert!(nothing.with_positions(line(1)).is_err());
    }
}
