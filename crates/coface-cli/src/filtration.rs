//! The filtration that a command line asks for.

use crate::failure::Failure;
use coface::Error;
use coface::answers::{Growth, VertexFunction};
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

/// One number a line; empty lines at the end do not count.
fn read_numbers(path: &Path) -> Result<Vec<f64>, Failure> {
    let number = |(i, line): (usize, &str)| {
        line.trim().parse::<f64>().ok().filter(|value| value.is_finite()).ok_or_else(|| {
            Error::parse(format!("{:?} is not a finite number", line.trim()))
                .at_line(i as u64 + 1)
                .in_file(path.display().to_string())
                .with_cure("write one number a line, for each vertex")
        })
    };
    Ok(read_text(path)?.trim_end().lines().enumerate().map(number).collect::<Result<_, Error>>()?)
}

fn read_text(path: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(path)
        .map_err(|error| Error::from(error).in_file(path.display().to_string()).into())
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
    let text = read_text(path)?;
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
