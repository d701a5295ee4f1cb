//! Persistence diagrams to draw: those in files.

use crate::commands::view::read_result;
use crate::failure::Failure;
use coface::pictures::DiagramPoint;
use serde::Deserialize;
use std::path::Path;

/// What is drawn of the JSON of `coface persistence`.
#[derive(Deserialize)]
struct Diagram {
    diagram: Vec<Pair>,
}

#[derive(Deserialize)]
struct Pair {
    degree: usize,
    birth: f64,
    death: Option<f64>,
}

/// The classes in the JSON of `coface persistence`; none if it is other JSON.
pub(super) fn points_of_result(path: &Path) -> Result<Option<Vec<DiagramPoint>>, Failure> {
    if !path.is_file() {
        return Ok(None);
    }
    let result = read_result(path)?;
    if result.get("diagram").is_none() {
        return Ok(None);
    }
    let found = Diagram::deserialize(result).map(|found| found.diagram);
    let pairs = found.ok().filter(|pairs| pairs.iter().all(|pair| pair.degree < MOST_DEGREES));
    let point = |pair: Pair| DiagramPoint { degree: pair.degree, birth: pair.birth, death: pair.death };
    let points = pairs.map(|pairs| pairs.into_iter().map(point).collect());
    points.map(Some).ok_or_else(|| {
        Failure::new(format!(
            "{}: an entry of \"diagram\" has no \"degree\", \"birth\" and \"death\"; give what coface persistence wrote",
            path.display()
        ))
    })
}

/// No complex here has more degrees.
const MOST_DEGREES: usize = 64;

/// The classes in a `.pers` file: a line for each, with the field (which may be left out), the degree, birth and death.
pub(super) fn read_pers(path: &Path) -> Result<Vec<DiagramPoint>, Failure> {
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::new(format!("{}: cannot be read: {error}", path.display())))?;
    let mut points = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default();
        let words: Vec<&str> = line.split_whitespace().collect();
        let point = match words[..] {
            [] => continue,
            [degree, birth, death] | [_, degree, birth, death] => degree
                .parse()
                .ok()
                .filter(|&degree| degree < MOST_DEGREES)
                .zip(birth.parse().ok())
                .zip(death.parse().ok())
                .map(|((degree, birth), death)| (degree, birth, death)),
            _ => None,
        };
        let Some((degree, birth, death)) =
            point.filter(|(_, birth, death): &(usize, f64, f64)| birth.is_finite() && !death.is_nan())
        else {
            return Err(Failure::new(format!(
                "{}:{}: this is no class; a line is \"field degree birth death\"",
                path.display(),
                number + 1
            )));
        };
        points.push(DiagramPoint { degree, birth, death: Some(death).filter(|death| death.is_finite()) });
    }
    Ok(points)
}
