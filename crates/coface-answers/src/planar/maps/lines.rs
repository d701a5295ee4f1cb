//! Lines cut where they meet, and the faces that they bound.

use super::super::arrangement::{ArrangementRequest, DrawingArrangement};
use super::super::drawing::{NO_RING, PlanarDrawing, Region};
use super::super::heights::Heights;
use super::layer::{Geometry, MapLayer, Point, Rings};
use super::result::{Change, blank};
use super::task::LineOptions;
use crate::answer::{MapAnswer, PolygonizeAnswer, Remark, RemarkCode};
use crate::text;
use coface_algebra::{EdgeId, Error, VertexId};
use coface_arrange::planar::VertexSource;
use coface_geometry::Positions;
use std::collections::BTreeSet;

/// All rings and lines of a map, cut at their meetings.
struct CutLines {
    arranged: DrawingArrangement,
    points: Vec<Point>,
    /// Where open lines end, by the bits of their coordinates.
    ends: BTreeSet<[u64; 2]>,
}

impl CutLines {
    fn new(layer: &MapLayer, options: &LineOptions) -> Result<Self, Error> {
        let mut drawing = PlanarDrawing { names: vec!["map".to_owned()], ..PlanarDrawing::default() };
        let (mut flat, mut ends) = (Vec::new(), BTreeSet::new());
        for feature in &layer.features {
            let Geometry { polygons, lines, .. } = &feature.geometry;
            let rings = polygons.iter().flatten().map(|ring| (ring, true));
            for (walk, is_ring) in rings.chain(lines.iter().map(|line| (line, false))) {
                let (first, count) = (flat.len() as u32 / 2, walk.len() as u32);
                for corner in walk {
                    flat.extend_from_slice(&corner[..2]);
                    drawing.heights.push(corner[2]);
                }
                drawing.segments.extend((1..count).map(|i| [first + i - 1, first + i]));
                if is_ring && count > 1 {
                    drawing.segments.push([first + count - 1, first]);
                }
                if let (Some(a), Some(b)) = (walk.first(), walk.last())
                    && !is_ring
                    && bits(a) != bits(b)
                {
                    ends.extend([bits(a), bits(b)]);
                }
            }
        }
        drawing.ring_of_segment = vec![NO_RING; drawing.segments.len()];
        drawing.vertex_starts = vec![0, flat.len() as u32 / 2];
        drawing.segment_starts = vec![0, drawing.segments.len() as u32];
        drawing.regions.push(Region { name: "map".to_owned(), model: 0, open_at: None, is_empty: true });
        drawing.positions = Positions::from_flat(2, flat)?;
        if drawing.heights.iter().all(|height| height.is_nan()) {
            drawing.heights.clear();
        }
        let LineOptions { snap, grid, tolerance } = *options;
        let request = ArrangementRequest { snap, grid, tolerance, ..ArrangementRequest::default() };
        let arranged = DrawingArrangement::new(drawing, &request)?;
        let arrangement = arranged.arrangement();
        let positions = match Heights::new(&arranged.drawing) {
            Some(heights) => {
                let edges = (0..arrangement.edge_count())
                    .map(|edge| arrangement.ends(EdgeId::new(edge)).map(VertexId::to_u32));
                heights.lift(arrangement.positions(), &arranged.sources, edges, &arranged.segments_of_edge)?
            }
            None => arrangement.positions().clone(),
        };
        let point = |vertex: usize| {
            let point = positions.point(VertexId::new(vertex));
            [point[0], point[1], point.get(2).copied().unwrap_or(f64::NAN)]
        };
        let points = (0..positions.len()).map(point).collect();
        Ok(Self { arranged, points, ends })
    }

    /// What moved so that rounded coordinates are valid, and what was put together within a tolerance or put on a grid.
    fn remarks(&self, options: &LineOptions) -> Vec<Remark> {
        let mut remarks: Vec<Remark> = self.arranged.remark_of_movement().into_iter().collect();
        if let Some(tolerance) = options.tolerance {
            let message = format!("vertices and lines up to {tolerance} apart were put together");
            remarks.push(Remark::new(RemarkCode::FeaturesJoined, message));
        }
        remarks
    }

    /// Whether lines end or meet at a vertex.
    fn is_node(&self, vertex: VertexId) -> bool {
        if self.arranged.arrangement().halfedges_around(vertex).count() != 2 {
            return true;
        }
        match self.arranged.source(vertex) {
            VertexSource::Given(point) => {
                let [x, y] = self.arranged.drawing.place(point as u32);
                self.ends.contains(&bits(&[x, y, 0.0]))
            }
            VertexSource::Crossing(_) => false,
        }
    }

    /// The edges put together between nodes.
    fn pieces(&self) -> Vec<Vec<u32>> {
        let arrangement = self.arranged.arrangement();
        let mut is_done = vec![false; arrangement.edge_count()];
        let mut pieces = Vec::new();
        let head = |halfedge: u32| {
            let ends = arrangement.ends(EdgeId::from_u32(halfedge / 2));
            ends[usize::from(halfedge.is_multiple_of(2))]
        };
        let mut follow = |start: VertexId, first: u32, is_done: &mut Vec<bool>| {
            let (mut piece, mut halfedge) = (vec![start.to_u32()], first);
            loop {
                is_done[halfedge as usize / 2] = true;
                let end = head(halfedge);
                piece.push(end.to_u32());
                let mut leaving = arrangement.halfedges_around(end).map(|next| next.to_u32());
                let next = leaving.find(|next| next / 2 != halfedge / 2);
                match next.filter(|next| !self.is_node(end) && !is_done[*next as usize / 2]) {
                    Some(next) => halfedge = next,
                    None => break,
                }
            }
            pieces.push(piece);
        };
        let vertices = || (0..arrangement.vertex_count()).map(VertexId::new);
        for vertex in vertices().filter(|&vertex| self.is_node(vertex)) {
            for halfedge in arrangement.halfedges_around(vertex) {
                if !is_done[halfedge.index() / 2] {
                    follow(vertex, halfedge.to_u32(), &mut is_done);
                }
            }
        }
        // What is left are closed curves without nodes.
        for vertex in vertices() {
            let first = arrangement.halfedges_around(vertex).next();
            if let Some(halfedge) = first.filter(|halfedge| !is_done[halfedge.index() / 2]) {
                follow(vertex, halfedge.to_u32(), &mut is_done);
            }
        }
        pieces
    }
}

/// The pieces of all lines and rings between the points where they end or meet, each a feature; what several run along once.
pub(super) fn noded(layer: &MapLayer, options: &LineOptions) -> Result<Change, Error> {
    let cut = CutLines::new(layer, options)?;
    let line = |piece: Vec<u32>| {
        let line = piece.into_iter().map(|vertex| cut.points[vertex as usize]).collect();
        (None, Geometry { lines: vec![line], ..Geometry::default() })
    };
    let mut answer = MapAnswer { remarks: cut.remarks(options), ..blank() };
    answer.remarks.extend(remark_of_points(layer));
    Ok(Change { geometries: cut.pieces().into_iter().map(line).collect(), keeps_heights: true, answer })
}

/// The bounded faces, each a feature.
pub(super) fn polygonized(layer: &MapLayer, options: &LineOptions) -> Result<Change, Error> {
    let cut = CutLines::new(layer, options)?;
    let arrangement = cut.arranged.arrangement();
    let [rings, polygons] = arrangement.face_polygons();
    let face = |own: &[u32]| {
        let ring = |&ring: &u32| -> Vec<Point> {
            rings.list(ring as usize).iter().map(|&vertex| cut.points[vertex as usize]).collect()
        };
        let polygon: Rings = own.iter().map(ring).collect();
        (None, Geometry { polygons: vec![polygon], ..Geometry::default() })
    };
    let bridges =
        (0..arrangement.edge_count()).filter(|&edge| arrangement.is_bridge(EdgeId::new(edge))).count();
    let dangles = cut.arranged.dangling_edge_count();
    let left_out = PolygonizeAnswer { dangles, cut_edges: bridges - dangles };
    let mut answer = MapAnswer { left_out: Some(left_out), remarks: cut.remarks(options), ..blank() };
    if bridges > 0 {
        let message = format!(
            "{} left out, which bound no face: dangles: {dangles}, cut edges: {}",
            text::count(bridges, "edge"),
            bridges - dangles
        );
        answer.remarks.push(Remark::new(RemarkCode::UnboundedSegments, message).at(bridges, []));
    }
    answer.remarks.extend(remark_of_points(layer));
    Ok(Change { geometries: polygons.iter().map(face).collect(), keeps_heights: true, answer })
}

fn remark_of_points(layer: &MapLayer) -> Option<Remark> {
    let count: usize = layer.features.iter().map(|feature| feature.geometry.points.len()).sum();
    let message = format!("{} left out: points are no lines", text::count(count, "point"));
    (count > 0).then(|| Remark::new(RemarkCode::UnboundedSegments, message).at(count, []))
}

fn bits(point: &Point) -> [u64; 2] {
    [point[0] + 0.0, point[1] + 0.0].map(f64::to_bits)
}
