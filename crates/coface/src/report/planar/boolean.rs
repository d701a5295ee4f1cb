//! Formulas of regions.

use super::arrangement::{ArrangementRequest, DrawingArrangement};
use super::containment::Containment;
use super::drawing::{Filling, PlanarDrawing, Polygon, Region, Ring};
use super::outline::{NONE, Outline};
use super::sides::Sides;
use crate::arrangement::boolean::{BooleanFormula, InsideRule};
use crate::arrangement::planar::{PlanarArrangement, VertexSource};
use crate::geometry::Positions;
use crate::{EdgeId, Error, FaceId, HalfedgeId, VertexId};
use serde_json::{Value, json};

/// How regions are combined.
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct BooleanRequest {
    /// Which winding numbers are inside, as in [`ArrangementRequest::rule`]. Without a rule, rings that cross themselves are refused
    /// unless the drawing states a rule.
    pub rule: Option<InsideRule>,
    /// Keep the edges between faces that are selected both: then each face is a polygon.
    pub keep_walls: bool,
    /// Round coordinates and arrange again until all vertices are where their coordinates say.
    pub snap: bool,
    /// The most vertices, edges and faces of the arrangement together.
    pub max_cells: Option<usize>,
}

/// The set that a formula of regions describes, as polygons with holes.
///
/// Outer rings run counterclockwise and holes clockwise; each ring is simple, and the points inside of each polygon are connected.
/// Where regions only touch, their corners leave no trace: a vertex at which two sides go on straight along one segment is
/// none of the result.
///
/// # Examples
/// Two rectangles side by side, and a square around the middle of what they share. Corners of both stay, though sides go straight on.
/// ```
/// use coface::arrangement::boolean::BooleanFormula;
/// use coface::io::{self, Format};
/// use coface::report::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
/// # fn main() -> Result<(), coface::Error> {
/// let a = io::read(&b"POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))"[..], Format::Wkt)?;
/// let b = io::read(&b"POLYGON ((2 0, 4 0, 4 1, 2 1, 2 0))"[..], Format::Wkt)?;
/// let c = io::read(&b"POLYGON ((1.5 0.25, 2.5 0.25, 2.5 0.75, 1.5 0.75, 1.5 0.25))"[..], Format::Wkt)?;
/// let drawing = PlanarDrawing::new([("a", &a), ("b", &b), ("c", &c)], RegionSource::Models)?;
/// let formula = BooleanFormula::parse("(a | b) - c", &[])?;
/// let result = RegionBoolean::new(drawing, &formula, &BooleanRequest::default())?;
/// assert_eq!((result.f_vector(), result.hole_count(), result.area()), ([10, 10, 1], 1, 3.5));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct RegionBoolean {
    pub(super) arranged: DrawingArrangement,
    pub(super) outline: Outline,
    pub(super) positions: Positions,
    areas: Vec<f64>,
    component_count: usize,
    pinches: Vec<u32>,
    /// For each polygon the regions that contain some of its faces, rising.
    regions_of_polygon: Vec<Vec<u32>>,
    is_valid: bool,
    is_exact: bool,
}

impl RegionBoolean {
    /// Combines the regions of a drawing, which are the inputs of the formula in their order.
    ///
    /// # Errors
    /// [`ErrorKind::NotACycle`](crate::ErrorKind::NotACycle) naming where lines end that should bound a region; [`ErrorKind::InvalidInput`](crate::ErrorKind::InvalidInput) naming the crossing
    /// of a ring with itself, an input of the formula that is not there, or a formula that holds outside of all regions;
    /// those of [`DrawingArrangement::new`].
    ///
    /// # Complexity
    /// That of the arrangement, and the faces times the length of the formula.
    pub fn new(
        drawing: PlanarDrawing,
        formula: &BooleanFormula,
        request: &BooleanRequest,
    ) -> Result<Self, Error> {
        drawing.check_regions()?;
        let region_count = drawing.regions.len();
        if formula.input_count() > region_count {
            return Err(Error::invalid(format!(
                "the formula names input {}, but there are {region_count}, numbered from 0",
                formula.input_count() - 1
            ))
            .with_cure("name inputs that are there, or give more of them"));
        }
        if formula.evaluate(|_| false) {
            return Err(Error::invalid(
                "the formula holds outside of all regions, so the result has no bounds",
            )
            .with_cure("take the complement within a region, as in \"a - b\""));
        }
        let arrangement = ArrangementRequest {
            rule: request.rule,
            snap: request.snap,
            max_cells: request.max_cells,
            ..ArrangementRequest::default()
        };
        let arranged = DrawingArrangement::new(drawing, &arrangement)?;
        if request.rule.is_none() {
            check_rings(&arranged)?;
        }
        let face_count = arranged.arrangement.face_count();
        let mut is_inside = vec![false; region_count];
        let mut select = |face: usize| {
            let regions = arranged.containment.regions.list(face);
            regions.iter().for_each(|&region| is_inside[region as usize] = true);
            let is_selected = formula.evaluate(|input| is_inside[input]);
            regions.iter().for_each(|&region| is_inside[region as usize] = false);
            is_selected
        };
        let selected: Vec<bool> = (0..face_count).map(&mut select).collect();
        let label = |face: usize| match (selected[face], request.keep_walls) {
            (false, _) => NONE,
            (true, false) => 0,
            (true, true) => face as u32,
        };
        let labels: Vec<u32> = (0..face_count).map(label).collect();
        let sides = arranged.sides();
        let outline = Outline::new(&sides, &labels, true);
        let component_count = if request.keep_walls {
            let merged: Vec<u32> = selected.iter().map(|&is_in| if is_in { 0 } else { NONE }).collect();
            Outline::new(&sides, &merged, true).polygon_count()
        } else {
            outline.polygon_count()
        };
        let mut areas = vec![Sum::default(); outline.polygon_count()];
        let mut regions_of_polygon = vec![Vec::new(); outline.polygon_count()];
        for (face, area) in arranged.arrangement.areas().into_iter().enumerate() {
            let polygon = outline.polygon_of_face[face] as usize;
            if let Some(sum) = areas.get_mut(polygon) {
                sum.add(area);
                regions_of_polygon[polygon].extend_from_slice(arranged.containment.regions.list(face));
            }
        }
        for regions in &mut regions_of_polygon {
            regions.sort_unstable();
            regions.dedup();
        }
        let flat = outline.vertices.iter().flat_map(|&vertex| {
            arranged.arrangement.positions().point(VertexId::from_u32(vertex)).iter().copied()
        });
        let positions = Positions::from_flat(2, flat.collect())?;
        let is_exact = (outline.vertices.iter())
            .all(|&vertex| arranged.arrangement.point(VertexId::from_u32(vertex)).is_exactly_rounded());
        let is_valid = is_exact || is_drawn_well(&outline, &positions)?;
        Ok(Self {
            pinches: pinches(&arranged.arrangement, &selected),
            areas: areas.into_iter().map(Sum::value).collect(),
            component_count,
            regions_of_polygon,
            is_valid,
            is_exact,
            positions,
            outline,
            arranged,
        })
    }

    /// The numbers of vertices, edges and polygons of the result.
    pub fn f_vector(&self) -> [usize; 3] {
        [self.positions.len(), self.outline.edges.len(), self.outline.polygon_count()]
    }

    /// The area, in the square of the unit of the drawing.
    pub fn area(&self) -> f64 {
        let mut sum = Sum::default();
        self.areas.iter().for_each(|&area| sum.add(area));
        sum.value()
    }

    /// The areas of the polygons.
    pub fn polygon_areas(&self) -> &[f64] {
        &self.areas
    }

    /// The number of parts whose inner points are connected. Parts that touch in points only are different ones.
    pub fn component_count(&self) -> usize {
        self.component_count
    }

    /// The number of holes.
    pub fn hole_count(&self) -> usize {
        self.outline.hole_count()
    }

    /// The positions of the vertices of the result: each coordinate is the floating-point number nearest to the exact one.
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The rings of a polygon by their vertices: the outer one, counterclockwise, then the holes, clockwise. Each is simple.
    ///
    /// # Panics
    /// If there is no such polygon.
    pub fn rings_of_polygon(&self, polygon: usize) -> impl ExactSizeIterator<Item = &[u32]> {
        self.outline.rings_of(polygon)
    }

    /// The edges of the result by their vertices, the lower first.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.outline.edges
    }

    /// The segments of the drawing along an edge of the result, rising.
    ///
    /// # Panics
    /// If there is no such edge.
    pub fn segments_of_edge(&self, edge: usize) -> &[u32] {
        self.outline.segments.list(edge)
    }

    /// The regions that contain some of a polygon, rising.
    ///
    /// # Panics
    /// If there is no such polygon.
    pub fn regions_of_polygon(&self, polygon: usize) -> &[u32] {
        &self.regions_of_polygon[polygon]
    }

    /// The vertices at which the boundary is no curve: more than two of its edges meet there.
    pub fn pinches(&self) -> Vec<VertexId> {
        let find = |vertex: &u32| self.outline.vertices.binary_search(vertex).ok().map(VertexId::new);
        self.pinches.iter().filter_map(find).collect()
    }

    /// Whether the polygons are sound with their rounded coordinates: they have all their vertices, no two edges cross, and
    /// each edge has the result on the side that it should.
    pub fn is_valid_when_rounded(&self) -> bool {
        self.is_valid
    }

    /// The result as one JSON object with the keys that programs rely on: `measure` (the area), `f_vector`, `components`,
    /// `closed`, `manifold`.
    pub fn to_json(&self) -> Value {
        let pinches = self.pinches();
        let witness = pinches.first().map(|&vertex| {
            let [x, y] = [self.positions.point(vertex)[0], self.positions.point(vertex)[1]];
            json!({
                "kind": "pinched_vertex",
                "cells": [[vertex.index()]],
                "message": format!("more than two edges of the boundary meet at vertex {} at ({x}, {y})", vertex.index()),
            })
        });
        json!({
            "dimension": 2,
            "measure": self.area(),
            "f_vector": self.f_vector(),
            "components": self.component_count,
            "closed": true,
            "manifold": {
                "verdict": if pinches.is_empty() { "yes" } else { "no" },
                "closed": true,
                "witness": witness,
            },
            "polygons": self.outline.polygon_count(),
            "holes": self.hole_count(),
            "measures": self.areas,
            "pinches": pinches.len(),
            "rounding": {"exact": self.is_exact, "valid": self.is_valid},
            "snap_rounds": self.arranged.snap_rounds,
            "arrangement": self.arranged.arrangement.f_vector(),
            "regions": self.arranged.drawing.region_names(),
            "inputs": self.arranged.drawing.inputs_to_json(),
        })
    }

    /// Where everything comes from, as JSON: as [`DrawingArrangement::provenance_to_json`], edges with their ends, and for each
    /// polygon the regions that contain some of it.
    pub fn provenance_to_json(&self) -> Value {
        let drawing = &self.arranged.drawing;
        let segment = |segment: u32| json!(drawing.segment_source(segment as usize));
        let vertices: Value = (self.outline.vertices.iter())
            .map(|&vertex| match self.arranged.source(VertexId::from_u32(vertex)) {
                VertexSource::Given(vertex) => json!({"vertex": drawing.vertex_source(vertex)}),
                VertexSource::Crossing(segments) => {
                    json!({"segments": segments.map(|s| segment(s as u32))})
                }
            })
            .collect();
        let edges: Value = (self.outline.edges.iter().zip(self.outline.segments.iter()))
            .map(|(ends, segments)| {
                let segments: Value = segments.iter().map(|&s| segment(s)).collect();
                json!({"ends": ends, "segments": segments})
            })
            .collect();
        json!({
            "inputs": drawing.names,
            "regions": drawing.region_names(),
            "vertices": vertices,
            "edges": edges,
            "polygons": self.regions_of_polygon,
        })
    }
}

/// A sum with the part that single additions lose.
#[derive(Clone, Copy, Debug, Default)]
struct Sum {
    sum: f64,
    lost: f64,
}

impl Sum {
    fn add(&mut self, value: f64) {
        let total = self.sum + value;
        let (large, small) =
            if self.sum.abs() >= value.abs() { (self.sum, value) } else { (value, self.sum) };
        self.lost += (large - total) + small;
        self.sum = total;
    }

    fn value(self) -> f64 {
        self.sum + self.lost
    }
}

/// `InvalidInput` naming a ring that winds around something more than once, or in both directions, with the place.
fn check_rings(arranged: &DrawingArrangement) -> Result<(), Error> {
    let drawing = &arranged.drawing;
    let is_wrong = |ring: &usize| {
        let [least, most] = arranged.containment.windings[*ring];
        let polygon = drawing.rings[*ring].polygon as usize;
        most - least > 1 && drawing.polygons[polygon].filling == Filling::OuterWithoutHoles
    };
    let Some(ring) = (0..drawing.rings.len()).find(is_wrong) else { return Ok(()) };
    let number = drawing.rings[ring].polygon as usize;
    let Polygon { region, number: place, .. } = drawing.polygons[number];
    let first = drawing.rings.partition_point(|other| (other.polygon as usize) < number);
    let name = match ring - first {
        0 => format!("polygon {place}"),
        hole => format!("hole {hole} of polygon {place}"),
    };
    let what = match crossing_of(arranged, ring as u32) {
        Some(vertex) => {
            let point = arranged.arrangement.positions().point(vertex);
            format!("{name} crosses itself at ({}, {})", point[0], point[1])
        }
        None => format!("{name} runs around its inside more than once"),
    };
    Err(Error::invalid(what)
        .with_cure("say what is inside of it: --rule evenodd or --rule nonzero")
        .in_file(drawing.names[drawing.regions[region as usize].model as usize].clone()))
}

/// A vertex at which two parts of a ring meet: a crossing of two of its segments if there is one.
fn crossing_of(arranged: &DrawingArrangement, ring: u32) -> Option<VertexId> {
    let (drawing, arrangement) = (&arranged.drawing, &arranged.arrangement);
    let is_own = |segment: usize| drawing.ring_of_segment[segment] == ring;
    let mut degrees = vec![0u8; arrangement.vertex_count()];
    for (edge, segments) in arranged.segments_of_edge.iter().enumerate() {
        if segments.iter().any(|&segment| is_own(segment as usize)) {
            for end in arrangement.ends(EdgeId::new(edge)) {
                degrees[end.index()] = degrees[end.index()].saturating_add(1);
            }
        }
    }
    let meeting = |vertex: &VertexId| degrees[vertex.index()] > 2;
    let crosses = |vertex: &VertexId| match arranged.source(*vertex) {
        VertexSource::Crossing(segments) => segments.iter().all(|&segment| is_own(segment)),
        VertexSource::Given(_) => false,
    };
    let vertices = || (0..arrangement.vertex_count()).map(VertexId::new).filter(meeting);
    vertices().find(crosses).or_else(|| vertices().next())
}

/// The vertices of the arrangement with more than two edges that have a selected face on one side only, rising.
fn pinches(arrangement: &PlanarArrangement, selected: &[bool]) -> Vec<u32> {
    let is_in = |halfedge: u32| {
        arrangement.face_of(HalfedgeId::from_u32(halfedge)).is_some_and(|face: FaceId| selected[face.index()])
    };
    let mut degrees = vec![0u32; arrangement.vertex_count()];
    for edge in (0..arrangement.edge_count() as u32).filter(|&edge| is_in(2 * edge) != is_in(2 * edge + 1)) {
        arrangement.ends(EdgeId::from_u32(edge)).iter().for_each(|end| degrees[end.index()] += 1);
    }
    (0..).zip(&degrees).filter(|(_, degree)| **degree > 2).map(|(vertex, _)| vertex).collect()
}

/// Whether rings drawn with these positions have all their vertices and edges, and together wind once around what is in them.
fn is_drawn_well(outline: &Outline, positions: &Positions) -> Result<bool, Error> {
    let mut drawing = PlanarDrawing {
        names: vec![String::new()],
        positions: positions.clone(),
        vertex_starts: vec![0, positions.len() as u32],
        regions: vec![Region { name: String::new(), model: 0, open_at: None, is_empty: false }],
        polygons: vec![Polygon { region: 0, filling: Filling::Stated(InsideRule::Nonzero), number: 0 }],
        rings: vec![Ring { polygon: 0, is_hole: false }],
        ..PlanarDrawing::default()
    };
    for ring in outline.rings.iter() {
        let next = ring.iter().cycle().skip(1);
        drawing.segments.extend(ring.iter().zip(next).map(|(&from, &to)| [from, to]));
    }
    drawing.segment_starts = vec![0, drawing.segments.len() as u32];
    drawing.ring_of_segment = vec![0; drawing.segments.len()];
    let drawn = PlanarArrangement::new(positions, &drawing.segments)?;
    let sides =
        Sides { drawing: &drawing, arrangement: &drawn, segments: drawn.segments_of_edges(), is_exact: true };
    let [least, most] = Containment::new(&drawing, &drawn, &sides, None).windings[0];
    let is_whole = drawn.vertex_count() == positions.len() && drawn.edge_count() == outline.edges.len();
    Ok(is_whole && least >= 0 && most <= 1)
}
