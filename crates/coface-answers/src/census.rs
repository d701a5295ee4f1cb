//! A census: a list of triangulations with their names, in which a triangulation is looked up.

use crate::answer::{CensusAnswer, CensusLine};
use coface_algebra::Error;
use coface_complexes::gluing::GluingTable;
use coface_io::SignatureLines;
use std::collections::HashMap;
use std::io::Read;
use std::path::Path;

/// Triangulations of dimension 3 by their signatures, each with the name that a file gives it.
///
/// # Examples
/// ```
/// use coface_answers::Census;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let census = Census::from_reader("closed.sig", &b"cMcabbjak L(3,1)\ncMcabbjqs L(8,3)\n"[..])?;
/// let lens = coface_complexes::gluing::GluingTable::from_isomorphism_signature("cMcabbjqs", 3)?;
/// assert_eq!(census.find(&lens)?.and_then(|line| line.name).as_deref(), Some("L(8,3)"));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct Census {
    file: String,
    /// The line, the signature as it is written there and the name, by the signature of the same table that is the same for all its names.
    lines: HashMap<String, CensusLine>,
}

impl Census {
    /// The census in a file of lines `signature name` or `name signature`, which may be compressed.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) when the file cannot be read; [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for
    /// a line without a signature, with its number.
    pub fn from_path(path: &Path) -> Result<Self, Error> {
        let file = path.display().to_string();
        Self::of_lines(&file, SignatureLines::of_path(path)?).map_err(|error| error.in_file(file))
    }

    /// The census in a text; `file` is what it is called in answers.
    ///
    /// # Errors
    /// As [`Self::from_path`].
    pub fn from_reader(file: &str, input: impl Read) -> Result<Self, Error> {
        Self::of_lines(file, SignatureLines::new(input)).map_err(|error| error.in_file(file))
    }

    fn of_lines<R: Read>(file: &str, input: SignatureLines<R>) -> Result<Self, Error> {
        let mut lines = HashMap::new();
        for line in input {
            let line = line?;
            let table = line.table().as_ref().map_err(Clone::clone)?;
            let entry = CensusLine {
                line: line.number(),
                signature: line.signature().to_owned(),
                name: line.name().map(str::to_owned),
            };
            // Of two lines with one triangulation the first.
            lines.entry(table.isomorphism_signature()?).or_insert(entry);
        }
        Ok(Self { file: file.to_owned(), lines })
    }

    /// The line with this triangulation, whatever the names of its simplices and vertices.
    ///
    /// # Errors
    /// Those of [`GluingTable::isomorphism_signature`].
    ///
    /// # Complexity
    /// $O(n^2)$ for n simplices.
    pub fn find(&self, table: &GluingTable) -> Result<Option<CensusLine>, Error> {
        Ok(self.lines.get(&table.isomorphism_signature()?).cloned())
    }

    /// What is said of a triangulation that is on this line or on none.
    pub(crate) fn answer(&self, found: Option<CensusLine>) -> CensusAnswer {
        CensusAnswer { file: self.file.clone(), triangulation_count: self.lines.len(), found }
    }
}
