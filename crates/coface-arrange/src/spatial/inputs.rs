//! Which inputs a cell of an arrangement is inside of.

use super::SpatialArrangement;
use crate::boolean::{InsideRule, WindingNumbers};
use coface_algebra::SparseMatrix;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind, FaceId};

impl SpatialArrangement {
    /// The inputs as chains of faces: rows are faces, columns inputs. A face counts as often as polygons of the input
    /// run as it does, minus those that run the other way.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 entries.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// // All four faces run as the sides of the input do.
    /// assert_eq!(tetrahedron.input_chains()?.column(0).entries(), [1; 4]);
    /// # Ok(()) }
    /// ```
    pub fn input_chains(&self) -> Result<SparseMatrix, Error> {
        self.chains_of(|_| true)
    }

    fn chains_of(&self, is_wanted: impl Fn(usize) -> bool) -> Result<SparseMatrix, Error> {
        // For each input its faces, which rise, with multiplicities.
        let mut columns: Vec<Vec<(u32, i32)>> = vec![Vec::new(); self.input_count()];
        for face in 0..self.complex().face_count() as u32 {
            let fine = self.first_fine_face(FaceId::from_u32(face));
            self.patches.for_each_polygon(self.patches_of_face.list(fine.index()), |polygon| {
                let input = self.input_of_polygon()[(polygon >> 1) as usize] as usize;
                if is_wanted(input) {
                    let sign = 1 - 2 * (polygon & 1) as i32;
                    match columns[input].last_mut().filter(|last| last.0 == face) {
                        // Polygons are fewer than 2^31.
                        Some(last) => last.1 += sign,
                        None => columns[input].push((face, sign)),
                    }
                }
            });
        }
        let (mut starts, mut rows, mut entries) = (vec![0], Vec::new(), Vec::new());
        for column in columns {
            let kept = column.into_iter().filter(|&(_, multiplicity)| multiplicity != 0);
            kept.for_each(|(face, multiplicity)| {
                rows.push(face);
                entries.push(multiplicity);
            });
            starts.push(u32::try_from(rows.len()).map_err(|_| {
                Error::new(ErrorKind::TooLarge, "2^32 or more faces of inputs, counted for each input")
            })?);
        }
        SparseMatrix::from_trusted_parts(self.complex().face_count(), starts, rows, entries)
    }

    /// How often each input winds around each cell.
    ///
    /// # Errors
    /// [`ErrorKind::NotACycle`] naming the first input that is not closed, and edges along which it is open.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, RaggedArray};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert_eq!(tetrahedron.winding_numbers()?.of_cell(CellId::new(0)), [1]);
    /// # Ok(()) }
    /// ```
    pub fn winding_numbers(&self) -> Result<WindingNumbers, Error> {
        WindingNumbers::new(&self.coarse_complex()?, &self.input_chains()?)
    }

    /// The inputs that are not closed, rising, each with an error that names edges along which it is open.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 entries in a matrix.
    ///
    /// # Examples
    /// A tetrahedron, and another one without its last side:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let positions = Positions::from_flat(3, vec![0., 0., 0., 6., 0., 0., 0., 6., 0., 0., 0., 6.])?;
    /// let sides = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
    /// let whole = SpatialPolygons::from_polygons(positions.clone(), RaggedArray::from_lists(sides))?;
    /// let open = SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(&sides[..3]))?;
    /// let both = SpatialPolygons::joined(&[whole, open])?;
    /// let arrangement = SpatialArrangement::new(&both, &SpatialOptions::default())?;
    /// let open = arrangement.open_inputs()?;
    /// assert_eq!(open[0].1.message(), "input 1 is not closed: it is open along e1 e5 e2");
    /// assert_eq!(arrangement.inside(Default::default())?, [vec![0]]);
    /// # Ok(()) }
    /// ```
    pub fn open_inputs(&self) -> Result<Vec<(u32, Error)>, Error> {
        Ok(self.winding_of_closed(&self.coarse_complex()?)?.1)
    }

    /// The closed inputs that each cell is inside of, rising. Inputs that are not closed have no inside:
    /// [`Self::open_inputs`].
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 entries in a matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::boolean::InsideRule;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert_eq!(tetrahedron.inside(InsideRule::Nonzero)?, [vec![0]]);
    /// # Ok(()) }
    /// ```
    pub fn inside(&self, rule: InsideRule) -> Result<Vec<Vec<usize>>, Error> {
        let numbers = self.winding_of_closed(&self.coarse_complex()?)?.0;
        let cells = (0..numbers.cell_count()).map(CellId::new);
        Ok(cells.map(|cell| numbers.inputs_around(cell, rule).collect()).collect())
    }

    /// The winding numbers of closed inputs, those of others zero, and what is wrong with the others.
    fn winding_of_closed(
        &self,
        complex: &ChainComplex,
    ) -> Result<(WindingNumbers, Vec<(u32, Error)>), Error> {
        match WindingNumbers::new(complex, &self.input_chains()?) {
            Ok(numbers) => return Ok((numbers, Vec::new())),
            Err(error) if error.kind() != ErrorKind::NotACycle => return Err(error),
            Err(_) => {}
        }
        let mut open = Vec::new();
        for input in 0..self.input_count() {
            match WindingNumbers::new(complex, &self.chains_of(|other| other == input)?) {
                Err(error) if error.kind() == ErrorKind::NotACycle => open.push((input as u32, error)),
                Err(error) => return Err(error),
                Ok(_) => {}
            }
        }
        let is_closed = |input: usize| !open.iter().any(|(other, _)| *other as usize == input);
        Ok((WindingNumbers::new(complex, &self.chains_of(is_closed)?)?, open))
    }
}
