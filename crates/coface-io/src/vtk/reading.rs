//! The header, and the kinds of data sets.

use super::cell_types::CellType;
use super::data;
use super::grids;
use super::lists::read_lists;
use super::reader::{GridKind, Lists, Reader};
use crate::scanner::quoted;
use crate::values::{Encoding, NumberType};
use crate::{Model, ReadOptions};
use coface_algebra::{Error, ErrorKind};
use std::io::Read;

/// Reads a legacy VTK file, text or binary, of any version.
///
/// # Errors
/// [`ErrorKind::Parse`] and [`ErrorKind::InvalidInput`] with the line (the byte in a binary file): a word or number out
/// of place, an index outside the points, a cell that repeats a point, a file that was cut short;
/// [`ErrorKind::UnsupportedFormat`] for types of cells that are not known here.
///
/// # Complexity
/// Linear; memory is the model and one list of cells.
///
/// # References
/// W. Schroeder, K. Martin, B. Lorensen, *The Visualization Toolkit* (2006), appendix "VTK file formats".
///
/// # Examples
/// ```
/// use coface_io::vtk;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = b"# vtk DataFile Version 3.0
/// one square
/// ASCII
/// DATASET POLYDATA
/// POINTS 4 float
/// 0 0 0  1 0 0  1 1 0  0 1 0
/// POLYGONS 1 5
/// 4 0 1 2 3
/// ";
/// assert_eq!(vtk::read(&text[..])?.polygons().list(0), [0, 1, 2, 3]);
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_with(input, &ReadOptions::default())
}

pub(crate) fn read_with(input: impl Read, options: &ReadOptions) -> Result<Model, Error> {
    let mut reader = Reader::new(input);
    if let Err(fault) = read_sections(&mut reader) {
        if !options.partial || reader.elements.assembly.vertex_count() == 0 {
            return Err(fault);
        }
        reader.elements.assembly.remarks.insert(0, crate::remark::partial(&fault));
    }
    reader.elements.assembly.finish()
}

fn read_sections<R: Read>(reader: &mut Reader<R>) -> Result<(), Error> {
    reader.read_header()?;
    while let Some(keyword) = reader.next_keyword()? {
        if !reader.read_section(&keyword)? {
            break;
        }
    }
    reader.complete()
}

impl<R: Read> Reader<R> {
    fn read_header(&mut self) -> Result<(), Error> {
        const MARK: &[u8] = b"# vtk DataFile";
        let first = self.values.scanner.next_line()?.unwrap_or_default().to_vec();
        if first.len() < MARK.len() || !first[..MARK.len()].eq_ignore_ascii_case(MARK) {
            let message = format!("{} stands where \"# vtk DataFile Version\" should", quoted(&first));
            return Err(self.values.error(message).with_cure("check that this is a legacy VTK file"));
        }
        // Since version 5 lists are offsets and connectivity.
        let digits = first[MARK.len()..].iter().skip_while(|byte| !byte.is_ascii_digit());
        let major: Vec<u8> = digits.copied().take_while(u8::is_ascii_digit).collect();
        self.has_offsets = !matches!(major.as_slice(), [] | [b'0'..=b'4']);
        self.values.scanner.next_line()?;
        let encoding = self.values.scanner.expect_token("ASCII or BINARY")?.to_ascii_uppercase();
        match encoding.as_slice() {
            b"ASCII" => {}
            b"BINARY" => {
                self.values.scanner.next_line()?;
                self.values.encoding = Encoding::BigEndian;
            }
            _ => {
                let message = format!("{} stands where ASCII or BINARY should", quoted(&encoding));
                return Err(self.values.error(message).with_cure("the title must be one line"));
            }
        }
        Ok(())
    }

    /// The next keyword, in capitals.
    fn next_keyword(&mut self) -> Result<Option<Vec<u8>>, Error> {
        Ok(self.values.scanner.next_token()?.map(<[u8]>::to_ascii_uppercase))
    }

    /// Reads what follows a keyword; false at the end of what can be read.
    fn read_section(&mut self, keyword: &[u8]) -> Result<bool, Error> {
        match keyword {
            b"POINT_DATA" | b"CELL_DATA" => {
                self.complete()?;
                data::read_place(self, keyword)?;
            }
            b"METADATA" => self.skip_metadata()?,
            _ if self.data_place.is_some() => {
                let place = self.data_place.expect("it was just seen to be there");
                return data::read_array(self, place, keyword);
            }
            b"DATASET" => {
                let dataset = self.values.scanner.expect_token("the kind of data set")?.to_ascii_uppercase();
                match dataset.as_slice() {
                    b"UNSTRUCTURED_GRID" | b"POLYDATA" => {}
                    b"STRUCTURED_POINTS" => self.grid.kind = Some(GridKind::Uniform),
                    b"RECTILINEAR_GRID" => self.grid.kind = Some(GridKind::Rectilinear),
                    b"STRUCTURED_GRID" => self.grid.kind = Some(GridKind::Curved),
                    _ => {
                        let message = format!("data sets of the kind {} hold no mesh", quoted(&dataset));
                        let error = Error::new(ErrorKind::UnsupportedFormat, message);
                        let cure = "save it as UNSTRUCTURED_GRID or POLYDATA";
                        return Err(error.at_line(self.values.scanner.line_number()).with_cure(cure));
                    }
                }
                self.has_dataset = true;
            }
            // Arrays that belong to the whole data set.
            b"FIELD" => return data::read_fields(self, None),
            _ if !self.has_dataset => {
                let message = format!("{} stands where DATASET should", quoted(keyword));
                return Err(self.header_error(message, "give the kind of the data set after ASCII or BINARY"));
            }
            b"POINTS" => self.read_points()?,
            b"CELLS" => {
                self.cells = Some(read_lists(self, "CELLS")?);
            }
            b"CELL_TYPES" => self.read_types()?,
            b"VERTICES" => self.read_polydata("VERTICES", 0, CellType::Points)?,
            b"LINES" => self.read_polydata("LINES", 1, CellType::Polyline)?,
            b"POLYGONS" => self.read_polydata("POLYGONS", 2, CellType::Polygon)?,
            b"TRIANGLE_STRIPS" => self.read_polydata("TRIANGLE_STRIPS", 3, CellType::Strip)?,
            b"DIMENSIONS" | b"ORIGIN" | b"SPACING" | b"ASPECT_RATIO" | b"X_COORDINATES"
            | b"Y_COORDINATES" | b"Z_COORDINATES" => grids::read_line(self, keyword)?,
            _ => {
                let message = format!("{} is no keyword of a VTK file", quoted(keyword));
                return Err(self.header_error(message, "check the count of the section before"));
            }
        }
        Ok(true)
    }

    fn read_polydata(&mut self, keyword: &str, section: usize, cell_type: CellType) -> Result<(), Error> {
        let lists = read_lists(self, keyword)?;
        for i in 0..lists.len() {
            self.elements
                .add_cell(section, cell_type, lists.list(i), 0)
                .map_err(|fault| lists.place(i, fault))?;
        }
        Ok(())
    }

    fn read_types(&mut self) -> Result<(), Error> {
        let count = self.values.scanner.expect_u64("the count of cell types")?;
        // Without cells the section CELLS may be missing.
        let Some(cells) = self.cells.take().or((count == 0).then(Lists::default)) else {
            return Err(self.header_error("CELL_TYPES stand before CELLS".to_owned(), "put CELLS first"));
        };
        if count != cells.len() as u64 {
            let message = format!("there are {count} cell types for {} cells", cells.len());
            return Err(self.header_error(message, "give each cell one type"));
        }
        self.values.end_line()?;
        for i in 0..cells.len() {
            let number = self.values.integer(NumberType::Int32, "the type of a cell")?;
            let cell_type = CellType::of_cell(i, number).map_err(|fault| self.values.located(fault))?;
            self.elements.add_cell(0, cell_type, cells.list(i), 0).map_err(|fault| cells.place(i, fault))?;
        }
        Ok(())
    }

    /// Sees to it that the mesh is all there.
    fn complete(&mut self) -> Result<(), Error> {
        let ended =
            |message: &str| Err(Error::parse(message).with_cure("the file was cut short: write it again"));
        if !self.has_dataset {
            return ended("the file ends before DATASET");
        }
        if self.cells.is_some() {
            return ended("the file ends before CELL_TYPES");
        }
        if self.grid.kind.is_some() {
            grids::finish(self)?;
        }
        Ok(())
    }
}
