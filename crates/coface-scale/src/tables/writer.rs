//! Rows written one after the other.

use super::Cell;
use super::csv::field;
use super::parquet::ParquetWriter;
use coface_algebra::Error;
use std::io::Write;

/// What the values of a column are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Flag,
    Whole,
    Real,
    Text,
}

impl Kind {
    /// The kind of a value; `None` where there is none.
    fn of(cell: &Cell) -> Option<Self> {
        match cell {
            Cell::Nothing => None,
            Cell::Flag(_) => Some(Self::Flag),
            Cell::Count(_) | Cell::Whole(_) => Some(Self::Whole),
            Cell::Real(_) => Some(Self::Real),
            Cell::Text(_) => Some(Self::Text),
        }
    }

    /// The kinds of columns with these values seen before: numbers are real if one of them is, and what differs otherwise is text.
    pub(crate) fn see(kinds: &mut Vec<Option<Self>>, cells: &[Cell]) {
        kinds.resize(kinds.len().max(cells.len()), None);
        for (kind, cell) in kinds.iter_mut().zip(cells) {
            *kind = match (*kind, Self::of(cell)) {
                (None, found) => found,
                (found, None) => found,
                (Some(a), Some(b)) if a == b => Some(a),
                (Some(Self::Whole | Self::Real), Some(Self::Whole | Self::Real)) => Some(Self::Real),
                _ => Some(Self::Text),
            };
        }
    }
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Column {
    pub(crate) name: String,
    pub(crate) kind: Kind,
}

impl Column {
    pub(crate) fn new(name: impl Into<String>, kind: Kind) -> Self {
        Self { name: name.into(), kind }
    }
}

/// Writes the rows of a table to a stream.
pub(crate) enum TableWriter<'a> {
    Csv(&'a mut dyn Write),
    Parquet(ParquetWriter<'a>),
}

impl<'a> TableWriter<'a> {
    /// Begins a table of values separated by commas, with these columns.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the stream.
    pub(crate) fn csv(out: &'a mut dyn Write, columns: &[Column]) -> Result<Self, Error> {
        let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
        writeln!(out, "{}", names.join(","))?;
        Ok(Self::Csv(out))
    }

    /// Begins a file of Parquet with these columns.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the stream.
    pub(crate) fn parquet(out: &'a mut dyn Write, columns: Vec<Column>) -> Result<Self, Error> {
        Ok(Self::Parquet(ParquetWriter::begin(out, columns)?))
    }

    /// Adds a row, one value a column.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the stream.
    pub(crate) fn row(&mut self, cells: &[Cell]) -> Result<(), Error> {
        match self {
            Self::Csv(out) => {
                let values: Vec<String> = cells.iter().map(field).collect();
                Ok(writeln!(out, "{}", values.join(","))?)
            }
            Self::Parquet(writer) => writer.row(cells),
        }
    }

    /// Ends the table.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the stream.
    pub(crate) fn end(self) -> Result<(), Error> {
        match self {
            Self::Csv(_) => Ok(()),
            Self::Parquet(writer) => writer.end(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_hold_all_values_that_were_seen() {
        let mut kinds = Vec::new();
        let text = |text: &str| Cell::from(text);
        Kind::see(&mut kinds, &[Cell::Nothing, 1_u64.into(), 1_u64.into(), true.into()]);
        Kind::see(&mut kinds, &[Cell::Nothing, (-1_i64).into(), 0.5.into(), text("x"), text("y")]);
        assert_eq!(kinds, [None, Some(Kind::Whole), Some(Kind::Real), Some(Kind::Text), Some(Kind::Text)]);
    }
}
