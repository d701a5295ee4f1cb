//! What a formula selects, read off an overlay, and made valid where rounding breaks it.

use super::arrangement::Parts;
use super::canonical::Canonical;
use super::exact::SelectedFaces;
use super::outline::Outline;
use super::settling::Settled;
use super::walks::corners_along;
use coface_algebra::{Error, RaggedArray, VertexId};
use coface_arrange::planar::{
    PlanarOptions, PlanarOverlay, Step, VertexSource, are_valid_polygons, turned_rings,
};
use coface_geometry::Positions;

/// Polygons with where their parts come from.
#[derive(Clone, Debug)]
pub(super) struct Outcome {
    pub(super) outline: Outline,
    pub(super) positions: Positions,
    pub(super) sources: Vec<VertexSource>,
    /// The sides of all rings, lower vertex first, rising, each once, and the segments along them.
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) segments_of_edge: RaggedArray,
    pub(super) areas: Vec<f64>,
    pub(super) component_count: usize,
    pub(super) pinches: Vec<VertexId>,
    /// For each polygon the regions that contain some of its faces, rising.
    pub(super) regions_of_polygon: RaggedArray,
    /// For each polygon the features with properties that contain some of its faces, rising.
    pub(super) features_of_polygon: RaggedArray,
    pub(super) is_exact: bool,
    pub(super) is_valid: bool,
    /// Whether rings run the wrong way because rounding turned them inside out.
    pub(super) is_turned: bool,
    /// Whether each face is a polygon.
    pub(super) has_walls: bool,
}

impl Outcome {
    /// The polygons of selected faces of an overlay, of which the unbounded one comes last; with the sources of vertices and
    /// of sides, and the regions and features of faces.
    pub(super) fn new<I: IntoIterator<Item = u32>>(
        overlay: &PlanarOverlay,
        selected: &[bool],
        has_walls: bool,
        source: impl Fn(VertexSource) -> VertexSource,
        segments_of_side: impl Fn(usize) -> I,
        [regions, features]: [&RaggedArray; 2],
    ) -> Result<Self, Error> {
        let merged = overlay.outline(selected, false)?;
        let component_count = merged.polygons().len();
        let mut pinches: Vec<u32> = merged.pinch_vertices().map(|vertex| merged.event(vertex)).collect();
        let found = if has_walls { overlay.outline(selected, true)? } else { merged };
        let canonical = Canonical::new(&found);
        pinches.sort_unstable();
        let is_pinch = |vertex: u32| pinches.binary_search(&found.event(VertexId::from_u32(vertex))).is_ok();
        let pinches: Vec<VertexId> = (0..)
            .zip(&canonical.order)
            .filter(|(_, vertex)| !pinches.is_empty() && is_pinch(**vertex))
            .map(|(number, _)| VertexId::from_u32(number))
            .collect();
        let sources = canonical.order.iter().map(|&v| source(found.source(VertexId::from_u32(v)))).collect();
        let (edges, segments_of_edge) = canonical.edges(segments_of_side);
        let areas = found.areas();
        let areas = canonical.polygons.iter().map(|&polygon| areas[polygon as usize]).collect();
        let regions_of_polygon = canonical.regions(regions);
        let features_of_polygon = canonical.regions(features);
        let flat = found.positions().as_flat().as_chunks::<2>().0;
        let places: Vec<[f64; 2]> = canonical.order.iter().map(|&vertex| flat[vertex as usize]).collect();
        let positions = Positions::from_flat(2, places.into_flattened())?;
        let is_exact = found.is_exactly_rounded();
        let outline = canonical.outline;
        // Polygons of an overlay are valid where they are exactly.
        let is_clear = is_exact || overlay.rounds_clearly();
        let is_valid =
            is_clear || are_valid_polygons(&positions, &outline.rings, &outline.polygons, has_walls)?;
        let is_turned =
            !is_clear && turned_rings(&positions, &outline.rings, &outline.polygons).contains(&true);
        Ok(Self {
            outline,
            positions,
            sources,
            edges,
            segments_of_edge,
            areas,
            component_count,
            pinches,
            regions_of_polygon,
            features_of_polygon,
            is_exact,
            is_valid,
            is_turned,
            has_walls,
        })
    }

    /// What some faces of an exact arrangement are; for each of its faces the regions and the features that contain it.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub(super) fn of_faces(
        parts: &Parts,
        faces: SelectedFaces,
        has_walls: bool,
        [regions, features]: [&RaggedArray; 2],
    ) -> Result<Self, Error> {
        let arrangement = &parts.arrangement;
        let vertices = || faces.vertices.iter().map(|&vertex| VertexId::from_u32(vertex));
        let flat = vertices().flat_map(|vertex| arrangement.positions().point(vertex)).copied().collect();
        let positions = Positions::from_flat(2, flat)?;
        let of_polygon = |of_face: &RaggedArray| {
            let mut lists: Vec<Vec<u32>> = vec![Vec::new(); faces.polygons.len()];
            for (own, polygon) in of_face.iter().zip(&faces.polygon_of_face) {
                if let Some(polygon) = *polygon {
                    lists[polygon].extend_from_slice(own);
                }
            }
            RaggedArray::from_lists(lists.into_iter().map(|mut list| {
                list.sort_unstable();
                list.dedup();
                list
            }))
        };
        let is_exact = vertices().all(|vertex| arrangement.is_exactly_rounded_at(vertex));
        let (rings, polygons) = (&faces.rings, &faces.polygons);
        Ok(Self {
            sources: vertices().map(|vertex| parts.sources[vertex.index()]).collect(),
            regions_of_polygon: of_polygon(regions),
            features_of_polygon: of_polygon(features),
            is_exact,
            is_valid: is_exact || are_valid_polygons(&positions, rings, polygons, has_walls)?,
            is_turned: !is_exact && turned_rings(&positions, rings, polygons).contains(&true),
            has_walls,
            positions,
            edges: faces.edges,
            segments_of_edge: faces.segments_of_edge,
            areas: faces.areas,
            component_count: faces.component_count,
            pinches: faces.pinches,
            outline: Outline { rings: faces.rings, polygons: faces.polygons },
        })
    }

    /// The same with edges that are cut and bent so that rounded coordinates are exact, and what that took.
    ///
    /// What rings wind around at least once is inside: faces that were turned inside out by rounding are not.
    pub(super) fn settled(&self) -> Result<(Self, Settled), Error> {
        let mut settled = Settled::new(&self.positions, &self.edges)?;
        let arrangement = settled.snapped.arrangement();
        let pieces = settled.snapped.segments_of_edges().transposed(self.edges.len());
        let place = |vertex: u32| {
            let point = self.positions.point(VertexId::from_u32(vertex));
            [point[0], point[1]]
        };
        let mut polygon_of_ring = vec![0; self.outline.rings.len()];
        for (polygon, rings) in (0..).zip(self.outline.polygons.iter()) {
            rings.iter().for_each(|&ring| polygon_of_ring[ring as usize] = polygon);
        }
        let (mut rings, mut edge_of_side, mut corners) = (RaggedArray::new(), Vec::new(), Vec::new());
        for ring in self.outline.rings.iter() {
            corners.clear();
            for (i, &from) in ring.iter().enumerate() {
                let to = ring[if i + 1 == ring.len() { 0 } else { i + 1 }];
                let edge = self.edges.binary_search(&[from.min(to), from.max(to)]);
                let edge = edge.expect("the sides of rings are edges");
                corners_along(arrangement, pieces.list(edge), [from, to].map(place), &mut corners);
                edge_of_side.resize(rings.item_count() + corners.len(), edge);
            }
            rings.push(&corners);
        }
        let overlay = PlanarOverlay::without_windings(
            arrangement.positions(),
            &rings,
            &polygon_of_ring,
            &PlanarOptions::default(),
        )?;
        let (mut windings, mut all) = (vec![0; self.outline.polygon_count()], 0);
        let mut is_left = vec![false; self.outline.polygon_count()];
        let mut around: Vec<u32> = Vec::new();
        let mut selected = vec![false; overlay.face_count() + 1];
        let mut polygons_of_face: Vec<Vec<u32>> = vec![Vec::new(); overlay.face_count()];
        let mut wind = |polygon: u32, by: i32, around: &mut Vec<u32>| {
            let winding: &mut i32 = &mut windings[polygon as usize];
            let was_in = *winding > 0;
            *winding += by;
            all += by;
            match (was_in, *winding > 0) {
                (false, true) => around.push(polygon),
                (true, false) => around.retain(|&other| other != polygon),
                _ => {}
            }
            all > 0
        };
        overlay.tour(|step| match step {
            Step::Into { face, across } => {
                let is_in = &mut selected[face as usize];
                overlay.across(across, |polygon, by| *is_in = wind(polygon, by, &mut around));
                polygons_of_face[face as usize].clone_from(&around);
                around.iter().for_each(|&polygon| is_left[polygon as usize] = true);
            }
            Step::Back { across, .. } => overlay.across(across, |polygon, by| {
                wind(polygon, by, &mut around);
            }),
        });
        let of_faces = |of_polygon: &RaggedArray| {
            RaggedArray::from_lists(polygons_of_face.iter().map(|polygons| {
                let mut list: Vec<u32> =
                    polygons.iter().flat_map(|&polygon| of_polygon.list(polygon as usize)).copied().collect();
                list.sort_unstable();
                list.dedup();
                list
            }))
        };
        let first_segment = |edge: usize| self.segments_of_edge.list(edge)[0] as usize;
        let source = |source: VertexSource| {
            let source = match source {
                VertexSource::Given(corner) => settled.snapped.source(VertexId::new(corner)),
                VertexSource::Crossing(sides) => VertexSource::Crossing(sides.map(|side| edge_of_side[side])),
            };
            match source {
                VertexSource::Given(vertex) => self.sources[vertex],
                VertexSource::Crossing(edges) => VertexSource::Crossing(edges.map(first_segment)),
            }
        };
        let segments = |side: usize| self.segments_of_edge.list(edge_of_side[side]).iter().copied();
        let lists = [&self.regions_of_polygon, &self.features_of_polygon].map(of_faces);
        let mut found =
            Self::new(&overlay, &selected, self.has_walls, source, segments, [&lists[0], &lists[1]])?;
        found.is_exact = self.is_exact;
        settled.movement.vanished = is_left.iter().filter(|is_left| !**is_left).count();
        Ok((found, settled))
    }
}
