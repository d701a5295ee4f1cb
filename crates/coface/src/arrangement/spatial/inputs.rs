//! Which inputs a cell of an arrangement is inside of.

use super::SpatialArrangement;
use crate::algebra::SparseMatrix;
use crate::arrangement::boolean::{InsideRule, WindingNumbers};
use crate::chains::ChainComplex;
use crate::{CellId, Error, ErrorKind, FaceId};

impl SpatialArrangement {
    /// The inputs as chains of faces: rows are faces, columns inputs. A face counts as often as polygons of the input run as it does,
    /// minus those that run the other way.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 entries.
    pub fn input_chains(&self) -> Result<SparseMatrix, Error> {
        self.chains_of(|_| true)
    }

    fn chains_of(&self, is_wanted: impl Fn(usize) -> bool) -> Result<SparseMatrix, Error> {
        let mut entries = Vec::new();
        for face in 0..self.complex().face_count() {
            let fine = self.first_fine_face(FaceId::new(face));
            self.patches.for_each_polygon(self.patches_of_face.list(fine.index()), |polygon| {
                let input = self.input_of_polygon()[(polygon >> 1) as usize] as usize;
                if is_wanted(input) {
                    entries.push((face, input, 1 - 2 * i64::from(polygon & 1)));
                }
            });
        }
        SparseMatrix::from_entries(self.complex().face_count(), self.input_count(), entries)
    }

    /// How often each input winds around each cell.
    ///
    /// # Errors
    /// [`ErrorKind::NotACycle`] naming the first input that is not closed, and edges along which it is open.
    pub fn winding_numbers(&self) -> Result<WindingNumbers, Error> {
        WindingNumbers::new(&self.chain_complex()?, &self.input_chains()?)
    }

    /// The inputs that are not closed, rising, each with an error that names edges along which it is open.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 entries in a matrix.
    pub fn open_inputs(&self) -> Result<Vec<(u32, Error)>, Error> {
        self.open_among(&self.chain_complex()?)
    }

    fn open_among(&self, complex: &ChainComplex) -> Result<Vec<(u32, Error)>, Error> {
        let mut open = Vec::new();
        if let Err(first) = WindingNumbers::new(complex, &self.input_chains()?) {
            if first.kind() != ErrorKind::NotACycle {
                return Err(first);
            }
            for input in 0..self.input_count() {
                match WindingNumbers::new(complex, &self.chains_of(|other| other == input)?) {
                    Err(error) if error.kind() == ErrorKind::NotACycle => open.push((input as u32, error)),
                    Err(error) => return Err(error),
                    Ok(_) => {}
                }
            }
        }
        Ok(open)
    }

    /// The closed inputs that each cell is inside of, rising. Inputs that are not closed have no inside: [`Self::open_inputs`].
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 entries in a matrix.
    pub fn inside(&self, rule: InsideRule) -> Result<Vec<Vec<usize>>, Error> {
        let complex = self.chain_complex()?;
        let open = self.open_among(&complex)?;
        let is_closed = |input: usize| !open.iter().any(|(other, _)| *other as usize == input);
        let numbers = WindingNumbers::new(&complex, &self.chains_of(is_closed)?)?;
        let cells = (0..numbers.cell_count()).map(CellId::new);
        Ok(cells.map(|cell| numbers.inputs_around(cell, rule).collect()).collect())
    }
}
