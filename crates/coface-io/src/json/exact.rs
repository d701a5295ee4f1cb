//! Polygons in space whose vertices are known by lines and planes.

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

fn write_lines<T: Serialize>(out: &mut impl Write, values: impl Iterator<Item = T>) -> Result<(), Error> {
    for (i, value) in values.enumerate() {
        out.write_all(if i == 0 { b"\n" } else { b",\n" })?;
        serde_json::to_writer(&mut *out, &value).map_err(std::io::Error::from)?;
    }
    Ok(())
}
