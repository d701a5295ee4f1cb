//! The polygons of a model as triangles, for formats that hold no others.

use crate::holed_faces::triangulated;
use crate::{Model, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use std::borrow::Cow;

/// The polygons of a model as triangles.
pub(crate) struct Triangles<'a> {
    pub(crate) corners: Cow<'a, [u32]>,
    /// The polygon of each triangle, unless all polygons are triangles.
    polygons: Option<Vec<u32>>,
}

impl<'a> Triangles<'a> {
    /// The triangles of a model that a format of this title is to hold, if there is nothing else.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for lines, points, and vertices without any polygon.
    pub(crate) fn of(model: &'a Model, title: &str) -> Result<Self, Error> {
        let refuse = |what: String| {
            Err(Error::new(
                ErrorKind::UnsupportedFormat,
                format!("{title} holds triangles only, and the model has {what}"),
            )
            .with_cure("write OBJ, PLY or OFF, which keep polygons, lines and points"))
        };
        if !model.lines.is_empty() || !model.points.is_empty() {
            let counts = [(model.lines.len(), "line"), (model.points.len(), "point")];
            let parts = counts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| match count {
                1 => format!("1 {what}"),
                _ => format!("{count} {what}s"),
            });
            return refuse(parts.collect::<Vec<String>>().join(" and "));
        }
        if model.polygons.is_empty() && model.vertex_count > 0 {
            return refuse(format!("{} vertices and no triangle", model.vertex_count));
        }
        if model.polygons.iter().all(|polygon| polygon.len() == 3) {
            return Ok(Self { corners: model.polygons.items().into(), polygons: None });
        }
        let dimension = model.coordinate_count();
        let point = |vertex: u32| -> [f64; 3] {
            let at = vertex as usize * dimension;
            std::array::from_fn(|axis| if axis < dimension { model.coordinates()[at + axis] } else { 0.0 })
        };
        let (mut corners, mut polygons) = (Vec::new(), Vec::new());
        for (i, polygon) in model.polygons.iter().enumerate() {
            let is_finite = polygon.iter().all(|&vertex| point(vertex).iter().all(|x| x.is_finite()));
            let cut = match polygon.len() {
                3 => None,
                _ if is_finite => triangulated(&mut [polygon.to_vec()], point),
                _ => None,
            };
            // What is not simple is cut from its first vertex.
            let cut = cut.unwrap_or_else(|| {
                polygon[1..].windows(2).map(|pair| [polygon[0], pair[0], pair[1]]).collect()
            });
            polygons.resize(polygons.len() + cut.len(), i as u32);
            corners.extend(cut.into_iter().flatten());
        }
        Ok(Self { corners: corners.into(), polygons: Some(polygons) })
    }

    pub(crate) fn len(&self) -> usize {
        self.corners.len() / 3
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &[u32]> {
        self.corners.chunks_exact(3)
    }

    /// The polygon that a triangle is of.
    pub(crate) fn polygon(&self, triangle: usize) -> usize {
        self.polygons.as_ref().map_or(triangle, |polygons| polygons[triangle] as usize)
    }
}

/// That larger polygons of a model are written as triangles.
pub(crate) fn triangulated_remark(model: &Model) -> Option<Remark> {
    let larger = model.polygons.iter().filter(|polygon| polygon.len() > 3).count();
    let message = match larger {
        0 => return None,
        1 => "1 polygon of more than three vertices is written as triangles".to_owned(),
        _ => format!("{larger} polygons of more than three vertices are written as triangles"),
    };
    Some(Remark::new(RemarkCode::FacesTriangulated, message).at(larger, []))
}
