//! Arrangements and results as models, for files.

use super::arrangement::DrawingArrangement;
use super::boolean::RegionBoolean;
use super::drawing::PlanarDrawing;
use super::heights::Heights;
use super::outline::Outline;
use super::properties::with_own;
use crate::answer::{Remark, RemarkCode};
use crate::text;
use coface_algebra::chains::{ChainComplex, ChainRefinement};
use coface_algebra::{EdgeId, Error, FaceId, VertexId};
use coface_algebra::{RaggedArray, SparseMatrix};
use coface_arrange::planar::{ExactSegments, exact_turn};
use coface_geometry::Positions;
use coface_geometry::predicates::orientation;
use coface_geometry::triangulation::triangulate;
use coface_io as io;
use coface_io::{CellData, Format, GroupKind, Model, ReferenceSystem, geojson};
use serde::Serialize;
use std::cmp::Ordering;
use std::io::Write;

impl DrawingArrangement {
    /// Writes the arrangement in a format.
    ///
    /// * JSON: the chain complex with the positions of the vertices; faces with holes are cut into triangles and what is apart in a face
    ///   is joined by bridges, with what each cell is a piece of.
    /// * Segments as text: all edges.
    /// * GeoJSON, WKT, WKB, SVG: each face as a polygon with holes, then edges that are in no face's rim, and vertices on their own. A polygon of
    ///   GeoJSON has the properties `face`, `area` and `inside` (the names of the regions around it), and those of
    ///   all features that contain it, but for these three; an edge those of the features along it or around it, a
    ///   vertex those of the features that it is a point of or lies in. A key with equal values keeps its value, one
    ///   with different values has the list of them ([`MergedProperties`](coface_io::geojson::MergedProperties)).
    /// * Others: faces as polygons; a face with holes or corners that touch is cut into triangles.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) if the format cannot hold it; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the output.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// let mut text = Vec::new();
    /// arranged.write(&mut text, coface_io::Format::Wkt)?;
    /// assert_eq!(String::from_utf8_lossy(&text).matches("POLYGON").count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn write(&self, out: &mut dyn Write, format: Format) -> Result<(), Error> {
        let arrangement = &self.arrangement;
        let positions = arrangement.positions().clone();
        let system = self.drawing.reference.clone();
        match format {
            Format::Json => {
                let (complex, refinement) = arrangement.ball_complex()?;
                let mut model = Model::from_chains(complex, positions)?.with_refinement(refinement)?;
                if let Some(exact) = self.exact_segments_of_faces()? {
                    model = model.with_exact_segments(exact.into());
                }
                return io::write(&model, out, format);
            }
            Format::Lines => {
                let edges = (0..arrangement.edge_count())
                    .map(|edge| arrangement.ends(EdgeId::new(edge)).map(VertexId::to_u32));
                return io::write(
                    &Model::from_lines(positions, RaggedArray::from_lists(edges))?,
                    out,
                    format,
                );
            }
            _ => {}
        }
        let [rings, polygons] = arrangement.face_polygons();
        let outline = Outline { rings, polygons };
        let bridges = self.bridges();
        let loose: Vec<[u32; 2]> = bridges.iter().map(|&edge| self.ends(edge)).collect();
        if is_drawing(format) {
            let areas = arrangement.areas();
            let names = self.drawing.region_names();
            let properties = |polygon: usize| {
                let regions = self.regions_around(FaceId::new(polygon)).iter();
                let inside: Vec<&str> = regions.map(|&region| names[region as usize]).collect();
                let own = FaceProperties { face: polygon, area: areas[polygon], inside };
                with_own(&own, self.merged_of_face(FaceId::new(polygon))?)
            };
            let (lone, of_points) = (self.lone_vertices(), self.features_of_points());
            let count = outline.polygon_count();
            let properties = |shape: usize| match shape.checked_sub(count) {
                None => properties(shape),
                Some(place) => match bridges.get(place) {
                    Some(&edge) => self.properties_of_bridge(edge),
                    None => self.properties_of_lone(lone[place - bridges.len()], &of_points),
                },
            };
            let positions = match Heights::new(&self.drawing).filter(|_| format.keeps_heights()) {
                Some(heights) => {
                    let edges = (0..arrangement.edge_count()).map(|edge| self.ends(EdgeId::new(edge)));
                    heights.lift(&positions, &self.sources, edges, &self.segments_of_edge)?
                }
                None => positions,
            };
            let model = drawing_model(&outline, positions, &loose, false)?.with_reference_system(system);
            return write_drawing(model, out, format, properties);
        }
        let model = mesh(&outline, &positions, &loose)?;
        io::write(&model, out, format)
    }

    /// The faces as polygons, and edges in no face's rim; a face with holes or corners that touch is cut into triangles.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if a face cannot be cut with rounded coordinates.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// assert_eq!(arranged.to_mesh()?.polygons().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn to_mesh(&self) -> Result<Model, Error> {
        let [rings, polygons] = self.arrangement.face_polygons();
        let loose: Vec<[u32; 2]> = self.bridges().into_iter().map(|edge| self.ends(edge)).collect();
        mesh(&Outline { rings, polygons }, self.arrangement.positions(), &loose)
    }

    /// The edges with one face on both sides.
    fn bridges(&self) -> Vec<EdgeId> {
        let edges = (0..self.arrangement.edge_count()).map(EdgeId::new);
        edges.filter(|&edge| self.arrangement.is_bridge(edge)).collect()
    }

    fn ends(&self, edge: EdgeId) -> [u32; 2] {
        self.arrangement.ends(edge).map(VertexId::to_u32)
    }

    /// The vertices at which no edge ends.
    fn lone_vertices(&self) -> Vec<VertexId> {
        let vertices = (0..self.arrangement.vertex_count()).map(VertexId::new);
        vertices.filter(|&vertex| self.arrangement.halfedges_around(vertex).next().is_none()).collect()
    }
}

impl RegionBoolean {
    /// Writes the result in a format.
    ///
    /// * WKT, WKB: one `POLYGON` or `MULTIPOLYGON`; each polygon by itself where edges between selected faces are kept.
    /// * GeoJSON, SVG: polygons with holes. A polygon of GeoJSON has the properties `polygon`, `area` and `regions` (the names of
    ///   those that contain some of it), and those of all features that contain some of it, but for these three. A
    ///   key with equal values keeps its value, one with different values has the list of them
    ///   ([`MergedProperties`](coface_io::geojson::MergedProperties)).
    /// * Segments as text: the edges.
    /// * Others: polygons; one with holes is cut into triangles.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) if the format cannot hold it; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the output.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// let mut text = Vec::new();
    /// rest.write(&mut text, coface_io::Format::Wkt)?;
    /// assert_eq!(String::from_utf8_lossy(&text).matches("POLYGON").count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn write(&self, out: &mut dyn Write, format: Format) -> Result<(), Error> {
        let positions = self.found.positions.clone();
        if format == Format::Lines {
            let lines = RaggedArray::from_lists(&self.found.edges);
            return io::write(&Model::from_lines(positions, lines)?, out, format);
        }
        let is_well_known = matches!(format, Format::Wkt | Format::Wkb | Format::WkbHex);
        if is_well_known && self.found.outline.polygon_count() == 0 {
            return io::write_empty_polygon(self.drawing.reference.as_ref(), out, format);
        }
        if is_drawing(format) {
            let names = self.drawing.region_names();
            let properties = |polygon: usize| {
                let regions = self.regions_of_polygon(FaceId::new(polygon)).iter();
                let regions: Vec<&str> = regions.map(|&region| names[region as usize]).collect();
                let own = PolygonProperties { polygon, area: self.polygon_areas()[polygon], regions };
                with_own(&own, self.merged_of_polygon(FaceId::new(polygon))?)
            };
            let is_one = is_well_known && !self.found.has_walls;
            let positions = if format.keeps_heights() { self.lifted_positions()? } else { positions };
            let model = drawing_model(&self.found.outline, positions, &[], is_one)?
                .with_reference_system(self.drawing.reference.clone());
            return write_drawing(model, out, format, properties);
        }
        if format == Format::Json && self.found.outline.polygon_count() > 0 {
            return io::write(&self.cells()?, out, format);
        }
        io::write(&mesh(&self.found.outline, &positions, &[])?, out, format)
    }

    /// The polygons as a chain complex whose faces are disks, with exact segments if they are kept.
    fn cells(&self) -> Result<Model, Error> {
        let found = &self.found;
        let exact = self.exact_segments()?;
        // With the exact points polygons are sound, whatever rounding does to them.
        let points = exact.as_ref().map(ExactSegments::vertex_points);
        let triangles_of = |polygon: usize, rings: &[&[u32]]| match &points {
            Some(points) => {
                let turn = |a: u32, b: u32, c: u32| exact_turn([a, b, c].map(|own| &points[own as usize]));
                // Vertices are in the order of their exact places.
                triangles(polygon, rings, |a, b| a.cmp(&b), turn)
            }
            None => {
                let place = |vertex: u32| place_in(&found.positions, vertex);
                triangles(
                    polygon,
                    rings,
                    |a, b| compare_places(place(a), place(b)),
                    |a, b, c| orientation(place(a), place(b), place(c)),
                )
            }
        };
        let (complex, refinement) =
            polygon_cells(&found.outline, &found.edges, found.positions.len(), triangles_of)?;
        let model = Model::from_chains(complex, found.positions.clone())?.with_refinement(refinement)?;
        Ok(match exact {
            Some(exact) => model.with_exact_segments(exact.into()),
            None => model,
        })
    }

    /// The positions with heights, where inputs have some.
    pub(super) fn lifted_positions(&self) -> Result<Positions, Error> {
        let found = &self.found;
        match Heights::new(&self.drawing) {
            Some(heights) => {
                let edges = found.edges.iter().copied();
                heights.lift(&found.positions, &found.sources, edges, &found.segments_of_edge)
            }
            None => Ok(found.positions.clone()),
        }
    }

    /// The result as polygons; one with holes is cut into triangles.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if a polygon cannot be cut with rounded coordinates.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let wide = coface_io::read(&b"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let hole = coface_io::read(&b"POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("wide", &wide), ("hole", &hole)], RegionSource::Models)?;
    /// let rest = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// // A polygon with a hole is cut into triangles.
    /// assert!(rest.to_mesh()?.polygons().iter().all(|polygon| polygon.len() == 3));
    /// # Ok(()) }
    /// ```
    pub fn to_mesh(&self) -> Result<Model, Error> {
        mesh(&self.found.outline, &self.found.positions, &[])
    }
}

impl PlanarDrawing {
    /// What a result in this format does not keep of the drawing: heights, the reference system.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarDrawing, RegionSource};
    /// use coface_io::Format;
    /// let roof = coface_io::read(&b"SRID=25832;POLYGON Z ((0 0 5, 2 0 5, 2 2 7, 0 0 5))"[..], Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("roof", &roof)], RegionSource::Models)?;
    /// assert_eq!([Format::Wkb, Format::Svg].map(|format| drawing.losses(format).len()), [0, 2]);
    /// # Ok(()) }
    /// ```
    pub fn losses(&self, format: Format) -> Vec<Remark> {
        let mut losses = Vec::new();
        let count = self.heights.iter().filter(|height| !height.is_nan()).count();
        if count > 0 && !format.keeps_heights() {
            let message = format!(
                "a file of {} does not keep heights of a map: those of {} are left out",
                format.title(),
                text::count(count, "vertex")
            );
            losses.push(Remark::new(RemarkCode::FormatKeepsLess, message).at(count, []));
        }
        losses.extend(self.reference.as_ref().and_then(|system| reference_loss(system, format)));
        losses
    }
}

/// That a format does not keep a reference system, where that is so.
#[doc(hidden)]
pub fn reference_loss(system: &ReferenceSystem, format: Format) -> Option<Remark> {
    if format.keeps_reference(system) {
        return None;
    }
    let message =
        format!("a file of {} does not keep the reference system: {system} is left out", format.title());
    Some(Remark::new(RemarkCode::FormatKeepsLess, message))
}

/// Whether a format holds polygons with holes.
fn is_drawing(format: Format) -> bool {
    format.keeps_heights() || format == Format::Svg
}

/// What GeoJSON says of a face of an arrangement.
#[derive(Serialize)]
struct FaceProperties<'a> {
    face: usize,
    area: f64,
    /// The names of the inputs that the face is inside of.
    inside: Vec<&'a str>,
}

/// What GeoJSON says of a polygon of a combination.
#[derive(Serialize)]
struct PolygonProperties<'a> {
    polygon: usize,
    area: f64,
    /// The names of the inputs that the polygon is inside of.
    regions: Vec<&'a str>,
}

/// A drawing with properties by the places of what is drawn.
fn write_drawing(
    model: Model,
    out: &mut dyn Write,
    format: Format,
    properties: impl Fn(usize) -> Result<String, Error>,
) -> Result<(), Error> {
    // Heights that are all zero are heights of a map.
    let model = if format.keeps_heights() { model.with_format(format) } else { model };
    if format == Format::GeoJson {
        return geojson::write_with_texts(&model, out, properties);
    }
    io::write(&model, out, format)
}

/// Polygons with holes, then loose edges, then vertices that nothing uses. All may be one geometry.
fn drawing_model(
    outline: &Outline,
    positions: Positions,
    loose: &[[u32; 2]],
    is_one: bool,
) -> Result<Model, Error> {
    let (mut lines, mut polygons, mut rings) = (RaggedArray::new(), Vec::new(), Vec::new());
    let mut closed = Vec::new();
    for polygon in 0..outline.polygon_count() {
        for (ring, corners) in outline.rings_of(polygon).enumerate() {
            closed.clear();
            closed.extend(corners.iter().chain(corners.first()));
            lines.push(&closed);
            polygons.push(polygon as i64);
            rings.push(ring as i64);
        }
    }
    for edge in loose {
        lines.push(edge);
        polygons.push(-1);
        rings.push(-1);
    }
    let line_count = lines.len();
    let mut model = Model::from_lines(positions, lines)?
        .with_data(CellData::integers("polygon", GroupKind::Lines, 1, polygons)?)?
        .with_data(CellData::integers("ring", GroupKind::Lines, 1, rings)?)?;
    if is_one {
        model = model.with_data(CellData::integers("feature", GroupKind::Lines, 1, vec![0; line_count])?)?;
    }
    Ok(model)
}

fn place_in(positions: &Positions, vertex: u32) -> [f64; 2] {
    let point = positions.point(VertexId::from_u32(vertex));
    [point[0], point[1]]
}

fn compare_places([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> Ordering {
    // Zeros of both signs are equal.
    (ax + 0.0).total_cmp(&(bx + 0.0)).then((ay + 0.0).total_cmp(&(by + 0.0)))
}

/// The triangles of a polygon with holes.
fn triangles(
    polygon: usize,
    rings: &[&[u32]],
    compare: impl Fn(u32, u32) -> Ordering,
    turn: impl Fn(u32, u32, u32) -> Ordering,
) -> Result<Vec<[u32; 3]>, Error> {
    triangulate(rings, compare, turn).map_err(|fault| {
        Error::invalid(format!(
            "with rounded coordinates polygon {polygon} cannot be cut into triangles: {fault}"
        ))
        .with_cure("leave --exact out, or write GeoJSON, WKT or SVG, which hold polygons with holes")
    })
}

/// The chain complex of polygons on these edges, those with holes cut into triangles, and what its cells are pieces of.
fn polygon_cells(
    outline: &Outline,
    edges: &[[u32; 2]],
    vertex_count: usize,
    triangles_of: impl Fn(usize, &[&[u32]]) -> Result<Vec<[u32; 3]>, Error>,
) -> Result<(ChainComplex, ChainRefinement), Error> {
    let mut all = edges.to_vec();
    let (mut faces, mut polygon_of_face) = (Vec::new(), Vec::new());
    for polygon in 0..outline.polygon_count() {
        let rings: Vec<&[u32]> = outline.rings_of(polygon).collect();
        let cells = match rings[..] {
            [ring] => vec![ring.to_vec()],
            _ => triangles_of(polygon, &rings)?.into_iter().map(Vec::from).collect(),
        };
        // Edges across the polygon are of it alone.
        let first = all.len();
        let sides_of = |cell: &[u32]| {
            let next = cell.iter().cycle().skip(1);
            cell.iter().zip(next).map(|(&a, &b)| [a, b]).collect::<Vec<[u32; 2]>>()
        };
        let rising = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
        let mut across: Vec<[u32; 2]> = cells
            .iter()
            .flat_map(|cell| sides_of(cell))
            .map(rising)
            .filter(|side| edges.binary_search(side).is_err())
            .collect();
        across.sort_unstable();
        across.dedup();
        for cell in &cells {
            let own = sides_of(cell).into_iter().map(|side| {
                let ends = rising(side);
                let known = edges.binary_search(&ends);
                let edge = known.unwrap_or_else(|_| first + across.partition_point(|other| *other < ends));
                (edge, if side == ends { 1 } else { -1 })
            });
            faces.push(own.collect::<Vec<(usize, i64)>>());
            polygon_of_face.push(Some(polygon as u32));
        }
        all.extend(across);
    }
    let ends = all.iter().enumerate();
    let ends = ends.flat_map(|(edge, &[a, b])| [(a as usize, edge, -1), (b as usize, edge, 1)]);
    let sides = faces.iter().enumerate();
    let sides = sides.flat_map(|(face, own)| own.iter().map(move |&(edge, sign)| (edge, face, sign)));
    let matrices = vec![
        SparseMatrix::from_entries(vertex_count, all.len(), ends)?,
        SparseMatrix::from_entries(all.len(), faces.len(), sides)?,
    ];
    let pieces = |count: usize, all: usize| (0..all).map(|own| (own < count).then_some(own as u32)).collect();
    let pieces = vec![pieces(vertex_count, vertex_count), pieces(edges.len(), all.len()), polygon_of_face];
    Ok((ChainComplex::new(matrices)?, ChainRefinement::new(pieces)))
}

/// Polygons of a mesh, and loose edges. Polygons with holes are cut into triangles.
fn mesh(outline: &Outline, positions: &Positions, loose: &[[u32; 2]]) -> Result<Model, Error> {
    let place = |vertex: u32| place_in(positions, vertex);
    let compare = |a: u32, b: u32| compare_places(place(a), place(b));
    let turn = |a: u32, b: u32, c: u32| orientation(place(a), place(b), place(c));
    let (mut polygons, mut numbers) = (RaggedArray::new(), Vec::new());
    for polygon in 0..outline.polygon_count() {
        let rings: Vec<&[u32]> = outline.rings_of(polygon).collect();
        if let [ring] = rings[..] {
            polygons.push(ring);
            numbers.push(polygon as i64);
            continue;
        }
        let triangles = triangles(polygon, &rings, compare, turn)?;
        for triangle in &triangles {
            polygons.push(triangle);
            numbers.push(polygon as i64);
        }
    }
    let lines = RaggedArray::from_lists(loose);
    let model = Model::from_polygons(positions.clone(), polygons)?.with_lines(lines)?;
    model.with_data(CellData::integers("face", GroupKind::Polygons, 1, numbers)?)
}
