//! Persistence diagrams to draw: those in files.

use crate::arguments::Common;
use crate::commands::persistence::image::stream;
use crate::commands::view::read_result;
use crate::failure::Failure;
use crate::input::Source;
use crate::remarks;
use coface::Error;
use coface::answers::{GreyImage, ImageRequest};
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

/// The classes of a volume by its own values, as of `coface persistence`; none where something chooses voxels, or the input is no volume.
pub(super) fn points_of_volume(
    source: &Source<'_>,
    common: &Common,
    superlevel: bool,
) -> Result<Option<Vec<DiagramPoint>>, Failure> {
    if common.voxels.rule_given().is_some() {
        return Ok(None);
    }
    let Some((name, stream)) = stream(source, common)? else { return Ok(None) };
    let (image, said) = GreyImage::read(stream).map_err(|error| error.in_file(name.clone()))?;
    remarks::take(&name, &said);
    let request = ImageRequest::new().superlevel(superlevel).periodic(common.voxels.reading());
    let found = request.found(&name, image)?;
    let pairs = found.diagram().pairs().iter();
    let point = |(degree, birth, death): (usize, f64, Option<f64>)| DiagramPoint { degree, birth, death };
    Ok(Some(pairs.map(|pair| point((pair.degree(), pair.birth(), pair.death()))).collect()))
}

/// No complex here has more degrees.
const MOST_DEGREES: usize = 64;

/// The classes in a `.pers` file: a line for each, with the field (which may be left out), the degree, birth and death.
pub(super) fn read_pers(path: &Path) -> Result<Vec<DiagramPoint>, Failure> {
    let text = std::fs::read_to_string(path)
        .map_err(|error| Error::from(error).in_file(path.display().to_string()))?;
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
