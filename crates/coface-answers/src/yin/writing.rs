//! Sets as files of any format of the plane.

use super::PlanarSet;
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind};
use coface_geometry::Positions;
use coface_io as io;
use coface_io::{CellData, Format, GroupKind, Model, yin};
use coface_yin::Order;
use serde::Serialize;
use std::io::Write;

/// What GeoJSON says of a polygon of a set.
#[derive(Serialize)]
struct PieceProperties {
    polygon: usize,
    area: Option<f64>,
}

impl PlanarSet {
    /// Writes the set in a format.
    ///
    /// * JSON and `.dat`: as [`yin`] says; JSON keeps everything.
    /// * SVG: a path with curves, filled; what is unbounded within a frame.
    /// * GeoJSON: a polygon with holes for each component, a feature with the properties `polygon` and `area`.
    /// * WKT and WKB: the same polygons as one geometry; the empty set is an empty polygon.
    /// * Others: the curves as closed lines.
    ///
    /// But for JSON and `.dat`, curves of order 6 and more, and for all but SVG also cubics, become chords within `flatten`.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for curves without `flatten`, for unbounded sets in formats that do not hold them, and if the format
    /// cannot hold lines; [`ErrorKind::Io`] from the output.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// let mut text = Vec::new();
    /// square.write(&mut text, Format::Wkt, None)?;
    /// assert_eq!(text, b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\n");
    /// # Ok(()) }
    /// ```
    pub fn write(&self, out: &mut dyn Write, format: Format, flatten: Option<f64>) -> Result<(), Error> {
        match format {
            Format::Json => return yin::write_json(&self.set, &self.names, out),
            Format::Dat => return yin::write_dat(&self.set, out),
            Format::Svg if self.set.order() > Order::CUBIC => {
                return self.flattened(flatten)?.write(out, format, None);
            }
            Format::Svg => {
                out.write_all(self.svg()?.as_bytes())?;
                return Ok(out.flush()?);
            }
            _ => {}
        }
        if !self.set.is_bounded() {
            let message = format!("{} cannot hold an unbounded set", format.title());
            return Err(Error::new(ErrorKind::UnsupportedFormat, message)
                .with_cure("write .json, or the meet with a set that is bounded"));
        }
        if self.set.order() > Order::LINEAR {
            if let (None, Some([low, high])) = (flatten, self.set.bounding_box()) {
                // What the format cannot hold with chords either is the fault, and chords are no cure.
                let coarse = (0.01 * (high[0] - low[0]).hypot(high[1] - low[1])).max(f64::MIN_POSITIVE);
                if let Ok(chords) = self.flattened(Some(coarse)) {
                    chords.write(&mut std::io::sink(), format, None)?;
                }
            }
            return self.flattened(flatten)?.write(out, format, None);
        }
        let (mut flat, mut lines) = (Vec::new(), RaggedArray::new());
        let (mut polygons, mut rings, mut areas) = (Vec::new(), Vec::new(), Vec::new());
        for (polygon, atom) in self.set.atoms().iter().enumerate() {
            let mut area = 0.0;
            for (ring, curve) in atom.curves().enumerate() {
                let curve = self.set.curve(curve);
                let start = (flat.len() / 2) as u32;
                let count = curve.piece_count();
                flat.extend(curve.controls()[..count].as_flattened());
                let line: Vec<u32> = (start..start + count as u32).chain([start]).collect();
                lines.push(&line);
                polygons.push(polygon as i64);
                rings.push(ring as i64);
                area += curve.signed_area();
            }
            areas.push(area);
        }
        let model = Model::from_lines(Positions::from_flat(2, flat)?, lines)?;
        let is_well_known = matches!(format, Format::Wkt | Format::Wkb | Format::WkbHex);
        if is_well_known && model.vertex_count() == 0 {
            return io::write_empty_polygon(None, out, format);
        }
        if !is_well_known && format != Format::GeoJson {
            return io::write(&model, out, format);
        }
        let count = polygons.len();
        let model = model
            .with_data(CellData::integers("polygon", GroupKind::Lines, 1, polygons)?)?
            .with_data(CellData::integers("ring", GroupKind::Lines, 1, rings)?)?;
        if format == Format::GeoJson {
            return io::geojson::write_with(&model, out, |polygon| PieceProperties {
                polygon,
                area: areas.get(polygon).copied(),
            });
        }
        // One set is one geometry.
        let model = model.with_data(CellData::integers("feature", GroupKind::Lines, 1, vec![0; count])?)?;
        io::write(&model, out, format)
    }

    /// The same with chords for curves.
    fn flattened(&self, tolerance: Option<f64>) -> Result<Self, Error> {
        let order = self.set.order();
        let Some(tolerance) = tolerance else {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                format!("the format cannot hold curves of order {order}"),
            )
            .with_cure("say how far chords may be from them: --flatten LENGTH; or write .json"));
        };
        let mut drawing = yin::BoundaryDrawing::new(Order::LINEAR);
        let mut curves = Vec::with_capacity(self.set.curve_count());
        for curve in 0..self.set.curve_count() {
            let corners = yin::flattened(&self.set.curve(curve), tolerance)
                .map_err(|error| super::making::named(curve, &error))?;
            curves.push(yin::BoundaryCurve::new(corners));
        }
        if curves.is_empty() {
            return Ok(self.clone());
        }
        drawing.push(yin::Filling::Left, curves);
        let flat = Self::of(&drawing, &super::SetRequest::default()).map_err(|fault| {
            let message = format!("within {tolerance:e}, chords bound no set: {}", fault.message());
            Error::new(fault.kind(), message).with_cure("allow less: chords that are nearer to the curves")
        })?;
        Ok(Self { names: self.names.clone(), ..flat })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SetRequest;

    /// One set is one geometry of well-known text and bytes, with its areas.
    #[test]
    fn sets_are_one_geometry() -> Result<(), Error> {
        let set = |json: &str| {
            let drawing = io::read_boundary(json.as_bytes(), Format::Json, &io::ReadOptions::default())?;
            PlanarSet::of(&drawing, &SetRequest::default())
        };
        let written = |set: &PlanarSet, format: Format| -> Result<Vec<u8>, Error> {
            let mut bytes = Vec::new();
            set.write(&mut bytes, format, None)?;
            Ok(bytes)
        };
        // A square with a hole, and a triangle beside it.
        let two = set(
            r#"{"order":2,"curves":[{"points":[[0,0],[3,0],[3,3],[0,3]]},{"points":[[1,1],[1,2],[2,2],[2,1]]},
            {"points":[[5,0],[7,0],[5,2]]}]}"#,
        )?;
        let text = written(&two, Format::Wkt)?;
        assert_eq!(
            String::from_utf8_lossy(&text),
            "MULTIPOLYGON (((0 0, 3 0, 3 3, 0 3, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1)), ((5 0, 7 0, 5 2, 5 0)))\n"
        );
        for format in [Format::Wkt, Format::Wkb, Format::WkbHex] {
            let bytes = written(&two, format)?;
            let drawing = io::read_boundary(&bytes[..], format, &io::ReadOptions::default())?;
            assert_eq!(PlanarSet::of(&drawing, &SetRequest::default())?.set().area(), Some(10.0));
        }
        let nothing = set(r#"{"curves":[]}"#)?;
        assert_eq!(written(&nothing, Format::Wkt)?, b"POLYGON EMPTY\n");
        Ok(())
    }
}
