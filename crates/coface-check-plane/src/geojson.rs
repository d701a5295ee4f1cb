//! GeoJSON.

use crate::drawing::Drawing;
use coface_check::Fault;
use coface_check::json::{field, list, parsed, text};
use serde_json::Value;

const STEP: &str = "input";

pub(crate) fn read(input: &str, drawing: &mut Drawing) -> Result<(), Fault> {
    object(&parsed(input.as_bytes(), STEP)?, drawing)
}

fn object(value: &Value, drawing: &mut Drawing) -> Result<(), Fault> {
    if value.is_null() {
        return Ok(());
    }
    let kind = text(field(value, "type", STEP)?, "\"type\"", STEP)?;
    let all = |key: &str, drawing: &mut Drawing| {
        list(field(value, key, STEP)?, key, STEP)?.iter().try_for_each(|part| object(part, drawing))
    };
    match kind {
        "FeatureCollection" => return all("features", drawing),
        "Feature" => return object(field(value, "geometry", STEP)?, drawing),
        "GeometryCollection" => return all("geometries", drawing),
        _ => {}
    }
    let coordinates = field(value, "coordinates", STEP)?;
    let parts = || list(coordinates, "\"coordinates\"", STEP);
    match kind {
        "Polygon" => drawing.polygon(&rings(coordinates)?),
        "MultiPolygon" => {
            for part in parts()? {
                drawing.polygon(&rings(part)?);
            }
        }
        "LineString" => drawing.line(&points(coordinates)?),
        "MultiLineString" => {
            for part in parts()? {
                drawing.line(&points(part)?);
            }
        }
        other => return Err(Fault::new(STEP, format!("a geometry of type {other:?} is not read"))),
    }
    Ok(())
}

fn rings(value: &Value) -> Result<Vec<Vec<[f64; 2]>>, Fault> {
    list(value, "a polygon", STEP)?.iter().map(points).collect()
}

fn points(value: &Value) -> Result<Vec<[f64; 2]>, Fault> {
    let point = |value: &Value| match list(value, "a point", STEP)? {
        [x, y] => x.as_f64().zip(y.as_f64()).map(|(x, y)| [x, y]).ok_or_else(not_two),
        _ => Err(not_two()),
    };
    list(value, "a line", STEP)?.iter().map(point).collect()
}

fn not_two() -> Fault {
    Fault::new(STEP, "points of two numbers are read, and this is another")
}
