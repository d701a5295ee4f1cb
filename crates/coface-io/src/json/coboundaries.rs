//! Coboundary matrices under keys of their own: `"d0"`, `"d1"`, ...

use super::facets::Number;
use super::faults::Faults;
use super::matrices::{Budget, Entry, EntryList};
use coface_algebra::SparseMatrix;
use coface_algebra::{Error, ErrorKind};
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// The coboundary matrix under one key, as the file gives it.
#[derive(Default)]
pub(super) struct Coboundary {
    rows: Option<u32>,
    columns: Option<u32>,
    entries: Vec<Entry>,
}

/// The degree that a key names: k for `dk`.
pub(super) fn degree_of_key(key: &str) -> Option<u32> {
    let digits = key.strip_prefix('d')?;
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    digits.parse().ok()
}

/// Reads a list of triples, or an object with the keys `"coo"` or `"entries"`, and perhaps `"rows"` and `"cols"`.
pub(super) struct CoboundaryOf<'a> {
    pub(super) degree: u32,
    pub(super) faults: &'a Faults,
}

impl<'de> DeserializeSeed<'de> for CoboundaryOf<'_> {
    type Value = Coboundary;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Coboundary, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for CoboundaryOf<'_> {
    type Value = Coboundary;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "\"d{}\", a list of [row, column, value], or an object with that list as \"coo\"",
            self.degree
        )
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Coboundary, A::Error> {
        let name = format!("\"d{}\"", self.degree);
        let entries = EntryList { of: &name, faults: self.faults }.visit_seq(list)?;
        Ok(Coboundary { entries, ..Coboundary::default() })
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Coboundary, A::Error> {
        let name = format!("\"d{}\"", self.degree);
        let (mut rows, mut columns, mut entries) = (None, None, None);
        let faults = self.faults;
        while let Some(key) = map.next_key::<String>()? {
            let what = || format!("\"{key}\" of {name}");
            match key.as_str() {
                "rows" => rows = Some(map.next_value_seed(Number { what, faults })?),
                "cols" => columns = Some(map.next_value_seed(Number { what, faults })?),
                "coo" | "entries" => entries = Some(map.next_value_seed(EntryList { of: &name, faults })?),
                _ => drop(map.next_value::<IgnoredAny>()?),
            }
        }
        let Some(entries) = entries else {
            return Err(faults.raise(
                Error::parse(format!("{name} has no entries"))
                    .with_cure("give them as \"coo\": [[row, column, value], ..]"),
            ));
        };
        Ok(Coboundary { rows, columns, entries })
    }
}

/// The boundary matrices of degrees 1, 2, ... that these coboundary matrices are the transposes of.
///
/// The matrix of degree k has a row for each (k+1)-cell and a column for each k-cell. The number of cells is what the
/// file says of it, else the number of points for vertices, else one more than the largest index.
///
/// # Errors
/// [`ErrorKind::Parse`] for a degree that is missing; [`ErrorKind::InvalidInput`] for counts that differ, an entry outside its
/// matrix, and two at one place; [`ErrorKind::TooLarge`] for many more cells than entries.
pub(super) fn boundaries(
    mut matrices: Vec<(u32, Coboundary)>,
    point_count: Option<usize>,
) -> Result<Vec<SparseMatrix>, Error> {
    matrices.sort_unstable_by_key(|&(degree, _)| degree);
    if let Some((expected, &(degree, _))) =
        (0..).zip(&matrices).find(|(expected, (degree, _))| expected != degree)
    {
        if degree < expected {
            return Err(
                Error::parse(format!("the key \"d{degree}\" stands twice")).with_cure("keep one of them")
            );
        }
        return Err(Error::parse(format!("there is \"d{degree}\", but no \"d{expected}\""))
            .with_cure("give the coboundary matrices of all degrees from 0"));
    }
    let matrices: Vec<Coboundary> = matrices.into_iter().map(|(_, matrix)| matrix).collect();
    let budget = Budget::default();
    let counts: Vec<u32> = (0..=matrices.len())
        .map(|degree| cell_count(&matrices, degree, point_count.filter(|_| degree == 0), &budget))
        .collect::<Result<_, Error>>()?;
    matrices
        .iter()
        .enumerate()
        .map(|(degree, matrix)| {
            let (rows, columns) = (counts[degree + 1], counts[degree]);
            check_places(degree, matrix, rows, columns)?;
            let transposed =
                matrix.entries.iter().map(|&(row, column, value)| (column as usize, row as usize, value));
            SparseMatrix::from_entries(columns as usize, rows as usize, transposed)
                .map_err(|error| Error::new(error.kind(), format!("\"d{degree}\": {}", error.message())))
        })
        .collect()
}

/// The number of cells of a degree.
fn cell_count(
    matrices: &[Coboundary],
    degree: usize,
    points: Option<usize>,
    budget: &Budget,
) -> Result<u32, Error> {
    let below = degree.checked_sub(1).map(|below| &matrices[below]);
    let above = matrices.get(degree);
    let points = match points.map(u32::try_from).transpose() {
        Ok(points) => points,
        Err(_) => return Err(Error::new(ErrorKind::TooLarge, "more than 2^32 - 1 points")),
    };
    let claims = [
        (points, "\"vertices\" has".to_owned(), "points"),
        (below.and_then(|matrix| matrix.rows), format!("\"d{}\" has", degree.wrapping_sub(1)), "rows"),
        (above.and_then(|matrix| matrix.columns), format!("\"d{degree}\" has"), "columns"),
    ];
    let mut stated =
        claims.iter().filter_map(|(count, place, things)| Some((count.as_ref()?, place, things)));
    if let Some((&count, place, things)) = stated.next() {
        if let Some((other, other_place, other_things)) = stated.find(|(other, ..)| **other != count) {
            return Err(Error::invalid(format!(
                "{place} {count} {things}, but {other_place} {other} {other_things}"
            ))
            .with_cure(format!("both are the number of {degree}-cells: make them equal")));
        }
        if points.is_none() {
            check_count(count, degree, below, above, budget)?;
        }
        return Ok(count);
    }
    let rows = below.into_iter().flat_map(|matrix| matrix.entries.iter().map(|&(row, ..)| row));
    let columns = above.into_iter().flat_map(|matrix| matrix.entries.iter().map(|&(_, column, _)| column));
    let count = rows.chain(columns).max().map_or(0, |largest| largest.saturating_add(1));
    check_count(count, degree, below, above, budget)?;
    Ok(count)
}

/// Refuses many more cells than there are entries to speak of them.
fn check_count(
    count: u32,
    degree: usize,
    below: Option<&Coboundary>,
    above: Option<&Coboundary>,
    budget: &Budget,
) -> Result<(), Error> {
    let entries: usize = below.into_iter().chain(above).map(|matrix| matrix.entries.len()).sum();
    if budget.grants(count.into(), entries) {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::TooLarge,
        format!(
            "the numbers of {degree}-cells go up to {}, but only {entries} entries speak of them",
            count - 1
        ),
    )
    .with_cure("number the cells from 0 without gaps"))
}

/// That each entry is in the matrix, and no two are at one place.
fn check_places(degree: usize, matrix: &Coboundary, rows: u32, columns: u32) -> Result<(), Error> {
    let entries = &matrix.entries;
    if let Some(at) = entries.iter().position(|&(row, column, _)| row >= rows || column >= columns) {
        let (row, column, _) = entries[at];
        return Err(Error::invalid(format!(
            "entry {at} of \"d{degree}\" is at row {row}, column {column}, but there are {rows} rows and {columns} columns"
        ))
        .with_cure("number rows and columns from 0"));
    }
    let mut places: Vec<(u32, u32, usize)> =
        entries.iter().enumerate().map(|(at, &(row, column, _))| (row, column, at)).collect();
    places.sort_unstable();
    let twice = places.windows(2).find(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1));
    if let Some(&[(row, column, first), (.., second)]) = twice.and_then(|pair| pair.first_chunk()) {
        return Err(Error::invalid(format!(
            "entries {first} and {second} of \"d{degree}\" are both at row {row}, column {column}"
        ))
        .with_cure("give each place one value"));
    }
    Ok(())
}
