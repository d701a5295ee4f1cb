//! Boundary matrices.

use super::facets::Number;
use super::faults::Faults;
use coface_algebra::SparseMatrix;
use coface_algebra::{Error, ErrorKind};
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::cell::Cell;
use std::fmt;

/// The matrices of a file may have so many rows and columns in all, whatever their entries.
const FREE_COUNT: u64 = 1 << 20;

/// A list of boundary matrices, of degrees 1, 2, ...
pub(super) struct MatrixList<'a>(pub(super) &'a Faults);

impl<'de> DeserializeSeed<'de> for MatrixList<'_> {
    type Value = Vec<SparseMatrix>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for MatrixList<'_> {
    type Value = Vec<SparseMatrix>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of boundary matrices")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut matrices = Vec::new();
        let budget = Budget::default();
        while let Some(matrix) =
            list.next_element_seed(Matrix { degree: matrices.len() + 1, faults: self.0, budget: &budget })?
        {
            matrices.push(matrix);
        }
        Ok(matrices)
    }
}

/// The boundary matrix of one degree.
struct Matrix<'a> {
    degree: usize,
    faults: &'a Faults,
    budget: &'a Budget,
}

/// What the matrices of a file claim, and what they hold.
#[derive(Default)]
pub(super) struct Budget {
    cells: Cell<u64>,
    entries: Cell<u64>,
}

impl Budget {
    /// Counts more cells and the entries that speak of them; the result says whether the file holds enough for so many.
    pub(super) fn grants(&self, cells: u64, entries: usize) -> bool {
        self.cells.set(self.cells.get().saturating_add(cells));
        self.entries.set(self.entries.get() + entries as u64);
        self.cells.get() <= most_cells(self.entries.get())
    }
}

impl Matrix<'_> {
    fn raise<E: serde::de::Error>(&self, kind: ErrorKind, message: &str, cure: &str) -> E {
        let message = format!("the boundary matrix of degree {} {message}", self.degree);
        self.faults.raise(Error::new(kind, message).with_cure(cure))
    }
}

impl<'de> DeserializeSeed<'de> for Matrix<'_> {
    type Value = SparseMatrix;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<SparseMatrix, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for Matrix<'_> {
    type Value = SparseMatrix;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the boundary matrix of degree {}, an object with \"rows\", \"cols\" and \"entries\"",
            self.degree
        )
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<SparseMatrix, A::Error> {
        let (mut rows, mut columns, mut entries) = (None, None, None);
        let (name, faults) = (format!("the boundary matrix of degree {}", self.degree), self.faults);
        while let Some(key) = map.next_key::<String>()? {
            let what = || format!("\"{key}\" of {name}");
            match key.as_str() {
                "rows" => rows = Some(map.next_value_seed(Number { what, faults })?),
                "cols" => columns = Some(map.next_value_seed(Number { what, faults })?),
                "entries" => entries = Some(map.next_value_seed(EntryList { of: &name, faults })?),
                _ => drop(map.next_value::<IgnoredAny>()?),
            }
        }
        let (Some(rows), Some(columns), Some(entries)) = (rows, columns, entries) else {
            return Err(self.raise(
                ErrorKind::Parse,
                "is incomplete",
                "give \"rows\", \"cols\" and \"entries\"",
            ));
        };
        // The rows are the columns of the degree below.
        if !self.budget.grants(u64::from(rows.max(columns)), entries.len()) {
            let message =
                format!("has {rows} rows and {columns} columns, but only {} entries", entries.len());
            return Err(self.raise(ErrorKind::TooLarge, &message, "check the counts"));
        }
        if let Some(at) = entries.iter().position(|&(row, column, _)| row >= rows || column >= columns) {
            let (row, column, _) = entries[at];
            let message = format!(
                "has {rows} rows and {columns} columns, but entry {at} is at row {row}, column {column}"
            );
            return Err(self.raise(ErrorKind::InvalidInput, &message, "number rows and columns from 0"));
        }
        let triples = entries.into_iter().map(|(r, c, value)| (r as usize, c as usize, value));
        SparseMatrix::from_entries(rows as usize, columns as usize, triples).map_err(|error| {
            self.raise(error.kind(), &format!("is too large: {}", error.message()), "split it")
        })
    }
}

/// Row, column and value.
pub(super) type Entry = (u32, u32, i64);

/// The most cells in all that so many entries may speak of: what a file merely claims takes no memory.
pub(crate) fn most_cells(entry_count: u64) -> u64 {
    FREE_COUNT + 16 * entry_count
}

/// The triples (row, column, value) of the matrix that is called so.
pub(super) struct EntryList<'a> {
    pub(super) of: &'a str,
    pub(super) faults: &'a Faults,
}

impl<'de> DeserializeSeed<'de> for EntryList<'_> {
    type Value = Vec<Entry>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for EntryList<'_> {
    type Value = Vec<Entry>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the entries of {}, a list", self.of)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut entries = Vec::new();
        while let Some(entry) =
            list.next_element_seed(EntryAt { of: self.of, position: entries.len(), faults: self.faults })?
        {
            entries.push(entry);
        }
        Ok(entries)
    }
}

/// One triple.
struct EntryAt<'a> {
    of: &'a str,
    position: usize,
    faults: &'a Faults,
}

impl EntryAt<'_> {
    fn name(&self) -> String {
        format!("entry {} of {}", self.position, self.of)
    }
}

impl<'de> DeserializeSeed<'de> for EntryAt<'_> {
    type Value = Entry;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Entry, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for EntryAt<'_> {
    type Value = Entry;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, a list of row, column and value", self.name())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Entry, A::Error> {
        let faults = self.faults;
        let row =
            list.next_element_seed(Number { what: || format!("the row of {}", self.name()), faults })?;
        let column =
            list.next_element_seed(Number { what: || format!("the column of {}", self.name()), faults })?;
        let value = list.next_element_seed(Value(&self))?;
        let end = list.next_element::<IgnoredAny>()?;
        match (row, column, value, end) {
            (Some(row), Some(column), Some(value), None) => Ok((row, column, value)),
            _ => Err(faults.raise(
                Error::parse(format!("{} is no triple", self.name())).with_cure("write [row, column, value]"),
            )),
        }
    }
}

/// The value of one triple.
struct Value<'a>(&'a EntryAt<'a>);

impl<'de> DeserializeSeed<'de> for Value<'_> {
    type Value = i64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<i64, D::Error> {
        deserializer.deserialize_i64(self)
    }
}

impl Value<'_> {
    fn too_large<E: serde::de::Error>(&self, value: &dyn fmt::Display) -> E {
        let name = self.0.name();
        let message =
            format!("the value of {name} is {value}, beyond the limits of -2147483647 and 2147483647");
        self.0.faults.raise(Error::new(ErrorKind::TooLarge, message))
    }
}

impl Visitor<'_> for Value<'_> {
    type Value = i64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the value of {}, an integer", self.0.name())
    }

    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<i64, E> {
        match i32::try_from(value) {
            Ok(narrow) if narrow > i32::MIN => Ok(value),
            _ => Err(self.too_large(&value)),
        }
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<i64, E> {
        match i32::try_from(value) {
            Ok(narrow) => Ok(narrow.into()),
            Err(_) => Err(self.too_large(&value)),
        }
    }

    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<i64, E> {
        Err(self.0.faults.raise(
            Error::invalid(format!("the value of {} is {value}, not an integer of 32 bits", self.0.name()))
                .with_cure("boundary matrices have whole numbers"),
        ))
    }
}
