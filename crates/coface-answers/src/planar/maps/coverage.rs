//! Whether the polygons of a map fit together.

use super::super::arrangement::{ArrangementRequest, DrawingArrangement};
use super::super::drawing::Filling;
use super::layer::{Geometry, MapLayer, Point, Rings, drawing_of};
use super::result::{Change, blank};
use crate::answer::{GapAnswer, MapAnswer, MapCoverageAnswer, OverlapAnswer, Place, Remark, RemarkCode};
use crate::text;
use coface_algebra::{EdgeId, Error, FaceId, UnionFind, VertexId};
use coface_arrange::planar::PlanarArrangement;
use std::collections::BTreeMap;

/// Gaps and overlaps of a coverage, and a map of the sides that are not valid, feature by feature.
pub(super) fn examined(layer: &MapLayer, gap_width: Option<f64>) -> Result<Change, Error> {
    if let Some(width) = gap_width.filter(|width| !(width.is_finite() && *width >= 0.0)) {
        return Err(Error::invalid(format!("the width of gaps is {width}"))
            .with_cure("give a finite length from 0, in the unit of the map"));
    }
    let regions = layer.features.iter().map(|feature| &feature.geometry.polygons[..]);
    let drawing = drawing_of(regions.map(|polygons| (polygons, Filling::OuterWithoutHoles)))?;
    let request = ArrangementRequest { exact: true, ..ArrangementRequest::default() };
    let arranged = DrawingArrangement::new(drawing, &request)?;
    let search = Search { arranged: &arranged, arrangement: arranged.arrangement() };
    let (overlaps, gaps) = search.parts(gap_width);
    let is_invalid = search.invalid_segments();
    let mut sides = is_invalid.iter();
    let mut geometries = Vec::new();
    for (number, feature) in layer.features.iter().enumerate() {
        let lines = feature.geometry.polygons.iter().flat_map(|rings: &Rings| rings).flat_map(|ring| {
            let own: Vec<bool> = sides.by_ref().take(ring.len()).copied().collect();
            runs(ring, &own)
        });
        let lines: Vec<Vec<Point>> = lines.collect();
        if !lines.is_empty() {
            geometries.push((Some(number), Geometry { lines, ..Geometry::default() }));
        }
    }
    let invalid_edges = is_invalid.iter().filter(|is_invalid| **is_invalid).count();
    let narrow = gaps.iter().filter(|gap| gap.narrow).count();
    let mut remarks = Vec::new();
    let mut tell = |count: usize, message: String, points: Vec<[f64; 2]>| {
        if count > 0 {
            let places = points.into_iter().map(|point| Place::point(&point));
            remarks.push(Remark::new(RemarkCode::InvalidPolygon, message).at(count, places));
        }
    };
    let places = |points: &mut dyn Iterator<Item = [f64; 2]>| points.collect::<Vec<_>>();
    tell(
        overlaps.len(),
        format!("features overlap in {}", text::count(overlaps.len(), "part")),
        places(&mut overlaps.iter().map(|overlap| overlap.point)),
    );
    tell(
        narrow,
        format!("{} at most as wide as {}", text::count(narrow, "gap"), gap_width.unwrap_or(0.0)),
        places(&mut gaps.iter().filter(|gap| gap.narrow).map(|gap| gap.point)),
    );
    tell(
        invalid_edges,
        format!("{} of polygons do not fit those of their neighbors", text::count(invalid_edges, "side")),
        Vec::new(),
    );
    let valid = invalid_edges == 0 && overlaps.is_empty() && narrow == 0;
    let coverage = MapCoverageAnswer { valid, gap_width, invalid_edges, overlaps, gaps };
    Ok(Change {
        geometries,
        keeps_heights: true,
        answer: MapAnswer { coverage: Some(coverage), remarks, ..blank() },
    })
}

/// The sides of a ring that are marked, those that follow each other as one line.
fn runs(ring: &[Point], is_marked: &[bool]) -> Vec<Vec<Point>> {
    let count = ring.len();
    let end = |side: usize| ring[if side + 1 == count { 0 } else { side + 1 }];
    if is_marked.iter().all(|is_marked| *is_marked) {
        return vec![ring.iter().chain(ring.first()).copied().collect()];
    }
    let mut lines: Vec<Vec<Point>> = Vec::new();
    // From behind a side that is not marked, all around.
    let first = is_marked.iter().position(|is_marked| !is_marked).unwrap_or(0);
    let mut goes_on = false;
    for side in (first..count).chain(0..first) {
        if is_marked[side] {
            match lines.last_mut().filter(|_| goes_on) {
                Some(line) => line.push(end(side)),
                None => lines.push(vec![ring[side], end(side)]),
            }
        }
        goes_on = is_marked[side];
    }
    lines
}

struct Search<'a> {
    arranged: &'a DrawingArrangement,
    arrangement: &'a PlanarArrangement,
}

impl Search<'_> {
    /// The feature of a segment.
    fn feature(&self, segment: u32) -> u32 {
        let drawing = &self.arranged.drawing;
        let ring = drawing.rings[drawing.ring_of_segment[segment as usize] as usize];
        drawing.polygons[ring.polygon as usize].region
    }

    /// The features that contain what is on both sides of an edge.
    fn features_beside(&self, edge: u32) -> [&[u32]; 2] {
        [2 * edge, 2 * edge + 1].map(|halfedge| {
            let face = self.arrangement.face_of(coface_algebra::HalfedgeId::from_u32(halfedge));
            face.map_or(&[][..], |face| self.arranged.regions_around(face))
        })
    }

    /// The connected parts of the plane that several features contain, and the bounded ones that none does.
    fn parts(&self, gap_width: Option<f64>) -> (Vec<OverlapAnswer>, Vec<GapAnswer>) {
        let (arrangement, face_count) = (self.arrangement, self.arrangement.face_count());
        let faces = |edge: usize| {
            [2 * edge, 2 * edge + 1]
                .map(|halfedge| arrangement.face_of(coface_algebra::HalfedgeId::new(halfedge)))
        };
        // The unbounded face comes last.
        let number = |face: Option<FaceId>| face.map_or(face_count, FaceId::index) as u32;
        let around = |face: u32| match (face as usize) < face_count {
            true => self.arranged.regions_around(FaceId::from_u32(face)),
            false => &[],
        };
        let mut parts = UnionFind::new(face_count + 1);
        for edge in 0..arrangement.edge_count() {
            let [a, b] = faces(edge).map(number);
            if around(a) == around(b) {
                parts.unite(a, b);
            }
        }
        let outside = parts.find(face_count as u32);
        let areas = arrangement.areas();
        let mut found: BTreeMap<u32, (f64, f64, Vec<u32>, u32)> = BTreeMap::new();
        for (face, area) in (0..).zip(&areas) {
            if around(face).len() != 1 && parts.find(face) != outside {
                found.entry(parts.find(face)).or_insert((0.0, 0.0, Vec::new(), u32::MAX)).0 += area;
            }
        }
        let positions = arrangement.positions();
        for edge in 0..arrangement.edge_count() {
            let sides = faces(edge).map(number);
            if around(sides[0]) == around(sides[1]) {
                continue;
            }
            let ends = arrangement.ends(EdgeId::new(edge));
            let [p, q] = ends.map(|end| positions.point(end));
            let length = (p[0] - q[0]).hypot(p[1] - q[1]);
            for (own, other) in [(sides[0], sides[1]), (sides[1], sides[0])] {
                if let Some((_, border, features, first)) = found.get_mut(&parts.find(own)) {
                    *border += length;
                    features.extend_from_slice(around(other));
                    *first = (*first).min(ends[0].to_u32());
                }
            }
        }
        let (mut overlaps, mut gaps) = (Vec::new(), Vec::new());
        for (part, (area, border, mut features, first)) in found {
            let own = around(part);
            let point = positions.point(VertexId::from_u32(if first == u32::MAX { 0 } else { first }));
            let point = [point[0], point[1]];
            if own.is_empty() {
                features.sort_unstable();
                features.dedup();
                let width = if border > 0.0 { 2.0 * area / border } else { 0.0 };
                let narrow = gap_width.is_some_and(|limit| width <= limit);
                gaps.push(GapAnswer { features, area, width, point, narrow });
            } else {
                overlaps.push(OverlapAnswer { features: own.to_vec(), area, point });
            }
        }
        (overlaps, gaps)
    }

    /// For each segment whether it does not fit: what it bounds is in another feature too, or it meets another feature's sides
    /// without being equal to them, other than end to end.
    fn invalid_segments(&self) -> Vec<bool> {
        let segment_count = self.arranged.drawing.segments.len();
        let edges_of_segment = self.arrangement.segments_of_edges().transposed(segment_count);
        // The features with a side through each vertex that has no corner there.
        let mut passing: Vec<Vec<u32>> = vec![Vec::new(); self.arrangement.vertex_count()];
        let mut incident: Vec<Vec<u32>> = vec![Vec::new(); self.arrangement.vertex_count()];
        let ends_of = |segment: usize| {
            let mut ends: Vec<u32> = (edges_of_segment.list(segment).iter())
                .flat_map(|&edge| self.arrangement.ends(EdgeId::from_u32(edge)).map(VertexId::to_u32))
                .collect();
            ends.sort_unstable();
            ends
        };
        for segment in 0..segment_count {
            let feature = self.feature(segment as u32);
            // Inner vertices are ends of two of its edges.
            for same in ends_of(segment).chunk_by(|a, b| a == b) {
                incident[same[0] as usize].push(feature);
                if same.len() > 1 {
                    passing[same[0] as usize].push(feature);
                }
            }
        }
        let has_other = |features: &[u32], own: u32| features.iter().any(|&feature| feature != own);
        let is_invalid = |segment: usize| {
            let feature = self.feature(segment as u32);
            let edges = edges_of_segment.list(segment);
            let mut equal = edges.len() == 1;
            let mut is_shared = false;
            for &edge in edges {
                let beside = self.features_beside(edge);
                if beside.iter().any(|around| around.len() > 1 && around.contains(&feature)) {
                    return true;
                }
                for &other in self.arrangement.segments_of_edges().list(edge as usize) {
                    if self.feature(other) != feature {
                        is_shared = true;
                        equal &= edges_of_segment.list(other as usize).len() == 1;
                    }
                }
            }
            if is_shared {
                return !equal;
            }
            ends_of(segment).chunk_by(|a, b| a == b).any(|same| {
                let vertex = same[0] as usize;
                match same.len() {
                    1 => has_other(&passing[vertex], feature),
                    _ => has_other(&incident[vertex], feature),
                }
            })
        };
        (0..segment_count).map(is_invalid).collect()
    }
}
