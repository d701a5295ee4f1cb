//! The filtration that a command line asks for.

use crate::failure::Failure;
use coface::Error;
use coface::answers::{Growth, VertexFunction};
use coface::io::NumberTable;
use serde::Deserialize;
use serde_json::Value;
use std::path::Path;

/// The function of this name: a coordinate, or the values in a file.
pub(crate) fn read_function(name: &str) -> Result<VertexFunction, Failure> {
    match ["x", "y", "z"].iter().position(|axis| *axis == name) {
        Some(axis) => Ok(VertexFunction::Coordinate(axis)),
        None => Ok(VertexFunction::Values { place: name.to_owned(), values: read_numbers(Path::new(name))? }),
    }
}

/// One number a line; empty lines at the end do not count. Or an array of NumPy with a number for each vertex.
fn read_numbers(path: &Path) -> Result<Vec<f64>, Failure> {
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("npy")) {
        return read_array(path);
    }
    let number = |(i, line): (usize, &str)| {
        line.trim().parse::<f64>().ok().filter(|value| value.is_finite()).ok_or_else(|| {
            Error::parse(format!("{:?} is not a finite number", line.trim()))
                .at_line(i as u64 + 1)
                .in_file(path.display().to_string())
                .with_cure("write one number a line, for each vertex")
        })
    };
    let text = read_text(path, "write one number a line, or an array of NumPy (.npy)")?;
    Ok(text.trim_end().lines().enumerate().map(number).collect::<Result<_, Error>>()?)
}

/// The numbers of an array of NumPy with one axis, or with one row or one column.
fn read_array(path: &Path) -> Result<Vec<f64>, Failure> {
    let table = NumberTable::read_path(path)?;
    let fault = |message: String| {
        let error = Error::invalid(message).in_file(path.display().to_string());
        Failure::from(error.with_cure("write an array with one finite number for each vertex"))
    };
    let numbers = table.numbers();
    if table.row_count() != numbers.len() && table.row_count() != 1 {
        return Err(fault(format!("the array has {} rows of several numbers", table.row_count())));
    }
    match numbers.iter().position(|number| !number.is_finite()) {
        Some(place) => Err(fault(format!("number {place} is {}", numbers[place]))),
        None => Ok(numbers.to_vec()),
    }
}

fn read_text(path: &Path, cure: &str) -> Result<String, Failure> {
    std::fs::read_to_string(path).map_err(|error| {
        let named = match error.kind() {
            std::io::ErrorKind::InvalidData => {
                Error::parse("the file is no text in UTF-8").with_cure(cure.to_owned())
            }
            _ => Error::from(error),
        };
        named.in_file(path.display().to_string()).into()
    })
}

/// What a file of values of cells has.
#[derive(Deserialize)]
#[serde(untagged)]
enum Values {
    Listed { cells: Vec<(Vec<u32>, f64)> },
    Named { values: Vec<Vec<f64>> },
    Bare(Vec<Vec<f64>>),
}

/// The values of a JSON file: `{"values":[[..],..]}`, or the bare list, with a list for each degree; or
/// `{"cells":[[[vertices..],value],..]}`, where cells that are not listed enter with their first coface.
pub(crate) fn read_values(path: &Path) -> Result<Growth, Failure> {
    let text = read_text(path, "write JSON")?;
    let place = path.display().to_string();
    let fault = |error: Error| Failure::from(error.in_file(place.clone()));
    // The fault of the text first: of values without the right shape serde names no place.
    let document: Value = serde_json::from_str(&text)
        .map_err(|error| fault(Error::parse(error.to_string()).with_cure("write valid JSON")))?;
    let values = Values::deserialize(document).map_err(|_| {
        fault(
            Error::invalid("there are no values of cells here")
                .with_cure("write {\"values\":[[..],..]} with a list of numbers for each degree, or {\"cells\":[[[vertices..],value],..]}"),
        )
    })?;
    Ok(match values {
        Values::Listed { cells } => Growth::Listed { place, values: cells },
        Values::Named { values } | Values::Bare(values) => Growth::Cells { place, values },
    })
}
