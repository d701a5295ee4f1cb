//! Boundary matrices.

use super::facets::Number;
use super::faults::Faults;
use coface_algebra::SparseMatrix;
use coface_algebra::{Error, ErrorKind};
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// A matrix without many entries may still have so many rows and columns.
const FREE_COUNT: u32 = 1 << 24;

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
        while let Some(matrix) =
            list.next_element_seed(Matrix { degree: matrices.len() + 1, faults: self.0 })?
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
        if rows.max(columns) > most_cells(entries.len()) {
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

/// The most rows or columns of a matrix with so many entries: what a file merely claims takes no memory.
pub(super) fn most_cells(entry_count: usize) -> u32 {
    FREE_COUNT.max(u32::try_from(entry_count.saturating_mul(16)).unwrap_or(u32::MAX))
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

impl Visitor<'_> for Value<'_> {
    type Value = i64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the value of {}, an integer", self.0.name())
    }

    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<i64, E> {
        if i32::try_from(value).is_err() {
            return Err(self.0.faults.raise(Error::new(
                ErrorKind::TooLarge,
                format!("the value of {} is {value}; the limit is 32 bits", self.0.name()),
            )));
        }
        Ok(value)
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<i64, E> {
        self.visit_i64(i64::try_from(value).unwrap_or(i64::MAX))
    }

    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<i64, E> {
        Err(self.0.faults.raise(
            Error::invalid(format!("the value of {} is {value}, not an integer of 32 bits", self.0.name()))
                .with_cure("boundary matrices have whole numbers"),
        ))
    }
}
