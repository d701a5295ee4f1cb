//! Segments in the plane whose ends are known by the segments that cross there.

use super::exact::write_lines;
use coface_algebra::Error;
use coface_arrange::planar::{ExactPiece, ExactSegments, ExactVertex};
use serde::de::{SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;
use std::io::Write;

/// What stands under `"exact_segments"`.
#[derive(Deserialize)]
pub(super) struct ExactSegmentList {
    points: Vec<[f64; 2]>,
    supports: Vec<[u32; 2]>,
    vertices: Vec<Vertex>,
    pieces: Vec<[u32; 3]>,
    #[serde(default)]
    shared: Vec<[u32; 3]>,
}

/// One point, or two supports.
struct Vertex(ExactVertex);

impl<'de> Deserialize<'de> for Vertex {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(VertexVisitor)
    }
}

struct VertexVisitor;

impl<'de> Visitor<'de> for VertexVisitor {
    type Value = Vertex;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of one point or of two supports")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vertex, A::Error> {
        let Some(first) = list.next_element()? else {
            return Err(serde::de::Error::invalid_length(0, &self));
        };
        let Some(second) = list.next_element()? else { return Ok(Vertex(ExactVertex::Point(first))) };
        match list.next_element::<u32>()? {
            None => Ok(Vertex(ExactVertex::Crossing([first, second]))),
            Some(_) => Err(serde::de::Error::invalid_length(3, &self)),
        }
    }
}

impl ExactSegmentList {
    pub(super) fn into_segments(self) -> Result<ExactSegments, Error> {
        let piece = |[support, from, to]: [u32; 3]| ExactPiece { support, ends: [from, to] };
        let [pieces, shared] = [self.pieces, self.shared].map(|list| list.into_iter().map(piece).collect());
        let vertices = self.vertices.into_iter().map(|vertex| vertex.0).collect();
        ExactSegments::new(self.points, self.supports, vertices, pieces, shared).map_err(|error| {
            Error::new(error.kind(), format!("\"exact_segments\": {}", error.message()))
                .with_cure("write the file again, or leave the key out: then rounded points are taken")
        })
    }
}

/// Writes the key with its value, one point, support, vertex or piece a line.
pub(super) fn write(out: &mut impl Write, exact: &ExactSegments) -> Result<(), Error> {
    write!(out, "\"exact_segments\":{{\"points\":[")?;
    write_lines(out, exact.points().iter())?;
    write!(out, "],\n\"supports\":[")?;
    write_lines(out, exact.supports().iter())?;
    write!(out, "],\n\"vertices\":[")?;
    write_lines(out, exact.vertices().iter().map(|vertex| Vertex(*vertex)))?;
    let (pieces, shared) = exact.pieces().split_at(exact.own_count());
    for (key, list) in [("pieces", pieces), ("shared", shared)] {
        if key == "pieces" || !list.is_empty() {
            write!(out, "],\n\"{key}\":[")?;
            write_lines(out, list.iter().map(|piece| [piece.support, piece.ends[0], piece.ends[1]]))?;
        }
    }
    write!(out, "]}}")?;
    Ok(())
}

impl Serialize for Vertex {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            ExactVertex::Point(point) => [point].serialize(serializer),
            ExactVertex::Crossing(supports) => supports.serialize(serializer),
        }
    }
}
