//! Polygons in space whose vertices are known by lines and planes.

use super::exact_segments::ExactSegmentList;
use crate::Model;
use coface_algebra::{Error, RaggedArray};
use coface_arrange::spatial::{ExactPart, ExactPolygons};
use serde::{Deserialize, Serialize};
use std::io::Write;

/// What stands under `"exact_polygons"`.
#[derive(Deserialize)]
pub(super) struct ExactList {
    points: Vec<[f64; 3]>,
    vertices: Vec<Vec<u32>>,
    polygons: Vec<Polygon>,
}

#[derive(Deserialize)]
struct Polygon {
    #[serde(default)]
    shared: bool,
    parts: Vec<Part>,
}

#[derive(Deserialize, Serialize)]
struct Part {
    triangle: [u32; 3],
    walks: Vec<Vec<u32>>,
}

impl ExactList {
    pub(super) fn into_polygons(self) -> Result<ExactPolygons, Error> {
        let is_shared = self.polygons.iter().map(|polygon| polygon.shared).collect();
        let mut parts = Vec::new();
        for (polygon, own) in (0..).zip(self.polygons) {
            let own = own.parts.into_iter();
            parts.extend(own.map(|Part { triangle, walks }| ExactPart { polygon, triangle, walks }));
        }
        ExactPolygons::new(self.points, &self.vertices, parts, is_shared).map_err(|error| {
            Error::new(error.kind(), format!("\"exact_polygons\": {}", error.message()))
                .with_cure("write the file again, or leave the key out: then rounded points are taken")
        })
    }
}

/// Writes the key with its value, one point, vertex or part a line.
pub(super) fn write(out: &mut impl Write, exact: &ExactPolygons) -> Result<(), Error> {
    write!(out, "\"exact_polygons\":{{\"points\":[")?;
    write_lines(out, exact.points().iter())?;
    write!(out, "],\n\"vertices\":[")?;
    write_lines(out, RaggedArray::iter(exact.vertices()))?;
    write!(out, "],\n\"polygons\":[")?;
    let mut parts: Vec<&ExactPart> = exact.parts().iter().collect();
    parts.sort_by_key(|part| part.polygon);
    let mut rest = &parts[..];
    for (polygon, &is_shared) in (0..).zip(exact.shared()) {
        let own = rest.partition_point(|part| part.polygon == polygon);
        write!(out, "{}{{", if polygon == 0 { "\n" } else { ",\n" })?;
        if is_shared {
            write!(out, "\"shared\":true,")?;
        }
        write!(out, "\"parts\":[")?;
        let list = rest[..own].iter().map(|part| Part { triangle: part.triangle, walks: part.walks.clone() });
        write_lines(out, list)?;
        write!(out, "]}}")?;
        rest = &rest[own..];
    }
    write!(out, "\n]}}")?;
    Ok(())
}

/// Writes values, one a line.
pub(super) fn write_lines<T: Serialize>(
    out: &mut impl Write,
    values: impl Iterator<Item = T>,
) -> Result<(), Error> {
    for (i, value) in values.enumerate() {
        out.write_all(if i == 0 { b"\n" } else { b",\n" })?;
        serde_json::to_writer(&mut *out, &value).map_err(std::io::Error::from)?;
    }
    Ok(())
}

/// Both keys, each with its value.
#[derive(Deserialize)]
struct ExactKeys {
    exact_polygons: Option<ExactList>,
    exact_segments: Option<ExactSegmentList>,
}

/// What a model knows exactly as the text of an object with the keys of files; none if it knows nothing.
///
/// # Errors
/// None: what is there can be written.
#[doc(hidden)]
pub fn exact_keys(model: &Model) -> Result<Option<String>, Error> {
    let mut bytes = b"{".to_vec();
    if let Some(exact) = model.exact_polygons() {
        write(&mut bytes, exact)?;
    }
    if let Some(exact) = model.exact_segments() {
        if bytes.len() > 1 {
            bytes.push(b',');
        }
        super::exact_segments::write(&mut bytes, exact)?;
    }
    bytes.push(b'}');
    Ok((bytes.len() > 2).then(|| String::from_utf8_lossy(&bytes).into_owned()))
}

/// A model with what the text says.
///
/// # Errors
/// Those of a file with these keys.
#[doc(hidden)]
pub fn with_exact_keys(mut model: Model, text: &[u8]) -> Result<Model, Error> {
    let keys: ExactKeys =
        serde_json::from_slice(text).map_err(|error| Error::parse(format!("exact points: {error}")))?;
    if let Some(exact) = keys.exact_polygons {
        model = model.with_exact_polygons(exact.into_polygons()?.into());
    }
    if let Some(exact) = keys.exact_segments {
        model = model.with_exact_segments(exact.into_segments()?.into());
    }
    Ok(model)
}
