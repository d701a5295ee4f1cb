//! The arrangement of a scene: what reports and Booleans ask of it.

use super::coarse::{refuse_movement, refuse_rounding};
use super::{SpatialRequest, SpatialScene};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, EdgeId, Error, ErrorKind, FaceId, VertexId};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use coface_arrange::boolean::{CellSelection, WindingNumbers};
use coface_arrange::spatial::{
    BallComplex, BallRules, Crossings, ExactPolygons, SpatialArrangement, SpatialOptions, SpatialPolygons,
    SplitPolygon,
};
use coface_arrange::{CoordinatePrecision, JoinedFeatures};
use coface_geometry::Positions;
use std::sync::{Arc, OnceLock};

/// Where rounding an arrangement does not come to an end, features of the inputs are put together that are so many units of the
/// last digit apart.
const UNITS_OF_ROUNDING: [f64; 3] = [32.0, 128.0, 512.0];

/// The cells that the polygons of a scene cut space into.
///
/// Cells of the complex are those of the arrangement. Polygons and triangles that faces are drawn with have **drawn** vertices: those
/// before pieces of polygons were put together.
#[derive(Clone, Debug)]
pub(super) struct Arranged {
    arrangement: SpatialArrangement,
    complex: ChainComplex,
    /// Found when they are asked for.
    volumes: OnceLock<Vec<f64>>,
    /// Rows are faces, columns models.
    inputs: SparseMatrix,
    /// What its polygons are of those of the scene, where they are not the same.
    origins: Option<Arc<Origins>>,
    /// Positions rounded to numbers of 32 bits, where nothing that makes them valid was found.
    coarse: Option<Arc<CoarsePositions>>,
}

/// Positions rounded as they are, without a look at what crosses then.
#[derive(Clone, Debug)]
struct CoarsePositions {
    of_vertices: Positions,
    of_drawn: Positions,
}

/// Where the polygons of combinations of models are from.
#[derive(Clone, Debug, Default)]
pub(super) struct Origins {
    /// For each polygon those of the scene that it is part of, packed with 1 for those that run the other way.
    pub(super) polygons: RaggedArray,
    /// The polygons of the scene that have no area.
    without_area: Vec<u32>,
    /// The polygons of the scene that were split.
    split: Vec<SplitPolygon>,
}

impl Origins {
    /// Polygons that are whole ones of the scene.
    pub(super) fn of_whole(polygons: &[u32]) -> Self {
        let polygons = RaggedArray::from_lists(polygons.iter().map(|&polygon| [2 * polygon]));
        Self { polygons, ..Self::default() }
    }

    /// Adds polygons behind those that there are.
    pub(super) fn append(&mut self, other: Self) {
        other.polygons.iter().for_each(|own| self.polygons.push(own));
        self.without_area.extend(other.without_area);
        self.split.extend(other.split);
    }

    /// Adds what was found of whole polygons when they were arranged.
    pub(super) fn add_notes(&mut self, without_area: &[u32], split: &[SplitPolygon]) {
        let whole = |polygon: u32| self.polygons.list(polygon as usize)[0] >> 1;
        self.without_area.extend(without_area.iter().map(|&polygon| whole(polygon)));
        self.split.extend(split.iter().copied().map(|mut own| {
            own.polygon = whole(own.polygon);
            own
        }));
    }

    /// The polygons of the scene that something is part of that has these of this list, all turned if the sign is minus; rising, and
    /// packed.
    pub(super) fn of_polygons(&self, own: Vec<(u32, Sign)>, sign: Sign) -> Vec<u32> {
        let turned = |own: Sign| u32::from(own.times(sign) == Sign::Minus);
        let mut found: Vec<u32> = Vec::new();
        for (polygon, run) in own {
            found.extend(self.polygons.list(polygon as usize).iter().map(|packed| packed ^ turned(run)));
        }
        found.sort_unstable();
        found.dedup();
        found
    }
}

impl Arranged {
    pub(super) fn new(scene: &SpatialScene, request: &SpatialRequest) -> Result<Self, Error> {
        let options = SpatialOptions::new()
            .non_planar(request.non_planar)
            .merge_coplanar(request.merge_coplanar)
            .tolerance(request.tolerance)
            .max_cells(request.max_cells);
        let arrangement = SpatialArrangement::new(&scene.polygons()?, &options);
        // A polygon that is none is named by its number in its own model.
        let mut arrangement = match arrangement {
            // Of exact polygons the rounded ones say nothing.
            Err(error) if error.kind() == ErrorKind::InvalidInput && scene.exact.is_empty() => {
                scene.check(request.non_planar)?;
                return Err(error);
            }
            other => other?,
        };
        if request.snap {
            arrangement = match snapped(&arrangement, &options, request) {
                Err(error) if error.kind() == ErrorKind::InvalidInput => {
                    return Self::within_rounding(scene, request)?.ok_or(error);
                }
                other => other?,
            };
        }
        Self::of(scene, arrangement)
    }

    /// Combinations of models arranged; what they are combinations of is not known of cells.
    pub(super) fn of_operands(
        arrangement: SpatialArrangement,
        complex: ChainComplex,
        count: usize,
        mut origins: Origins,
    ) -> Result<Self, Error> {
        origins.without_area.sort_unstable();
        origins.split.sort_unstable_by_key(|own| own.polygon);
        let inputs = SparseMatrix::from_entries(complex.cell_count(2), count, [])?;
        let origins = Some(Arc::new(origins));
        Ok(Self { arrangement, complex, volumes: OnceLock::new(), inputs, origins, coarse: None })
    }

    /// Combinations of models with rounded coordinates that are valid, and as chains of faces: rows are faces, columns combinations.
    pub(super) fn snapped_operands(&self, request: &SpatialRequest) -> Result<(Self, SparseMatrix), Error> {
        let options = SpatialOptions::new().max_cells(request.max_cells);
        let arrangement = snapped(&self.arrangement, &options, request)?;
        let (complex, chains) = (arrangement.coarse_complex()?, arrangement.input_chains()?);
        let inputs = SparseMatrix::from_entries(complex.cell_count(2), self.inputs.column_count(), [])?;
        let origins = self.origins.clone();
        Ok((Self { arrangement, complex, volumes: OnceLock::new(), inputs, origins, coarse: None }, chains))
    }

    /// The same with rounded coordinates that are valid.
    pub(super) fn snapped(&self, scene: &SpatialScene, request: &SpatialRequest) -> Result<Self, Error> {
        let options =
            SpatialOptions::new().merge_coplanar(request.merge_coplanar).max_cells(request.max_cells);
        Self::of(scene, snapped(&self.arrangement, &options, request)?)
    }

    /// The surface around some cells alone with rounded coordinates that are valid, and the cells within it; `surface` has its
    /// fronts outside.
    ///
    /// # Errors
    /// As [`SpatialArrangement::snapped`]; [`ErrorKind::NotACycle`](coface_algebra::ErrorKind::NotACycle) if the surface is open.
    pub(super) fn snapped_surface(
        &self,
        scene: &SpatialScene,
        request: &SpatialRequest,
        surface: &[(CellId, Sign)],
        exterior: bool,
    ) -> Result<(Self, CellSelection), Error> {
        // Faces of all models in a combination are of one input.
        let options = SpatialOptions::new()
            .merge_coplanar(request.merge_coplanar && self.origins.is_none())
            .max_cells(request.max_cells);
        let face = |&(face, sign): &(CellId, Sign)| (FaceId::from_u32(face.to_u32()), sign);
        let surface: Vec<(FaceId, Sign)> = surface.iter().map(face).collect();
        let mut arranged = Self::of(scene, self.arrangement.snapped_surface(&surface, &options)?)?;
        arranged.origins.clone_from(&self.origins);
        let chains = arranged.arrangement.input_chains()?;
        let last = chains.column_count() - 1;
        let own = chains.column(last).iter().map(|(face, m)| (face, 0, i64::from(m)));
        let chain = SparseMatrix::from_entries(chains.row_count(), 1, own)?;
        let winding = WindingNumbers::of_cycles(&arranged.complex, &chain)?;
        let is_within = |cell| winding.number(CellId::new(cell), 0) + i32::from(exterior) > 0;
        let cells = (0..arranged.complex.cell_count(3)).map(is_within).collect();
        Ok((arranged, CellSelection::new(cells, exterior)))
    }

    /// The scene with features put together that are some units of the last digit apart; none where that does not come to an
    /// end, or leaves coordinates that are not exact, and where a tolerance is given.
    pub(super) fn within_rounding(
        scene: &SpatialScene,
        request: &SpatialRequest,
    ) -> Result<Option<Self>, Error> {
        if request.tolerance.is_some() {
            return Ok(None);
        }
        let polygons = scene.polygons()?;
        let largest = polygons.positions().as_flat().iter().fold(0.0, |most: f64, x| x.abs().max(most));
        for units in UNITS_OF_ROUNDING {
            let options = SpatialOptions::new()
                .merge_coplanar(request.merge_coplanar)
                .max_cells(request.max_cells)
                .precision(request.precision)
                .tolerance(units * request.precision.unit() * largest);
            let found = SpatialArrangement::new(&polygons, &options)?;
            let is_settled = found.joined().is_some_and(|joined| joined.unsettled == 0);
            if is_settled && found.is_exactly_rounded() {
                if request.precision != CoordinatePrecision::Double {
                    refuse_movement(polygons.positions(), largest_movement(&found))?;
                }
                return Self::of(scene, found).map(Some);
            }
        }
        Ok(None)
    }

    fn of(scene: &SpatialScene, arrangement: SpatialArrangement) -> Result<Self, Error> {
        let (complex, chains) = rayon::join(|| arrangement.coarse_complex(), || arrangement.input_chains());
        let (complex, chains) = (complex?, chains?);
        // Walls, and the surface of a result, are inputs of their own there, after the models.
        let count = scene.names().len();
        let (volumes, origins) = (OnceLock::new(), None);
        if chains.column_count() == count {
            return Ok(Self { arrangement, complex, volumes, inputs: chains, origins, coarse: None });
        }
        let columns = chains.columns().take(count).enumerate();
        let entries = columns
            .flat_map(|(input, column)| column.iter().map(move |(face, m)| (face, input, i64::from(m))));
        let inputs = SparseMatrix::from_entries(chains.row_count(), count, entries)?;
        Ok(Self { arrangement, complex, volumes, inputs, origins, coarse: None })
    }

    pub(super) fn complex(&self) -> &ChainComplex {
        &self.complex
    }

    /// Parts of space that cells are put together to, as a complex of balls; see [`SpatialArrangement::ball_complex_of`].
    pub(super) fn balls(&self, parts: &[Option<u32>], rules: BallRules) -> Result<BallComplex, Error> {
        self.arrangement.ball_complex_of(parts, rules)
    }

    /// Where the vertices of the complex are.
    pub(super) fn positions(&self) -> &Positions {
        self.coarse.as_ref().map_or_else(|| self.arrangement.positions(), |coarse| &coarse.of_vertices)
    }

    /// Where drawn vertices are.
    pub(super) fn drawn_positions(&self) -> &Positions {
        self.coarse
            .as_ref()
            .map_or_else(|| self.arrangement.fine_triangles().positions(), |coarse| &coarse.of_drawn)
    }

    pub(super) fn volumes(&self) -> &[f64] {
        self.volumes.get_or_init(|| {
            let found = self.arrangement.fine().volumes(self.drawn_positions());
            found.expect("vertices of an arrangement are points in space")
        })
    }

    /// The volumes of some cells.
    pub(super) fn volumes_of(&self, cells: &[CellId]) -> Vec<f64> {
        match self.volumes.get() {
            Some(all) => cells.iter().map(|cell| all[cell.index()]).collect(),
            None => {
                let found = self.arrangement.fine().volumes_of(self.drawn_positions(), cells);
                found.expect("vertices of an arrangement are points in space")
            }
        }
    }

    /// The models as chains of faces: rows are faces, columns models.
    pub(super) fn inputs(&self) -> &SparseMatrix {
        &self.inputs
    }

    /// The polygons that a face is part of, plus where they have its front in front.
    pub(super) fn polygons_of_face(&self, face: CellId) -> Vec<(u32, Sign)> {
        let own = self.arrangement.polygons_of_face(FaceId::from_u32(face.to_u32()));
        let Some(origins) = &self.origins else { return own };
        let sign = |packed: u32| Sign::power_of_minus_one((packed & 1) as usize);
        let found = origins.of_polygons(own, Sign::Plus).into_iter();
        found.map(|packed| (packed >> 1, sign(packed))).collect()
    }

    /// The walks around a face in drawn vertices, the outer one first.
    pub(super) fn walks(&self, face: CellId) -> RaggedArray {
        self.arrangement.face_outlines(FaceId::from_u32(face.to_u32()))
    }

    /// Faces as polygons that lose nothing: sides of solids, plus where they run as the face does, and shared faces.
    pub(super) fn exact_polygons(&self, surface: &[(CellId, Sign)], walls: &[CellId]) -> ExactPolygons {
        let face = |face: &CellId| FaceId::from_u32(face.to_u32());
        let surface: Vec<(FaceId, Sign)> = surface.iter().map(|(own, sign)| (face(own), *sign)).collect();
        self.arrangement.exact_polygons(&surface, &walls.iter().map(face).collect::<Vec<_>>())
    }

    /// The corners of a face that is a triangle as it is.
    pub(super) fn single_triangle(&self, face: CellId) -> Option<[u32; 3]> {
        self.arrangement.single_triangle(FaceId::from_u32(face.to_u32()))
    }

    /// Whether rounding bent a face, so that it is no polygon any more.
    pub(super) fn is_bent(&self, face: CellId) -> bool {
        self.arrangement.joined().is_some() && !self.is_planar(face)
    }

    pub(super) fn is_planar(&self, face: CellId) -> bool {
        self.arrangement.is_planar(FaceId::from_u32(face.to_u32()))
    }

    /// Triangles that make up a face, with drawn vertices.
    pub(super) fn triangles(&self, face: CellId) -> Result<Vec<[u32; 3]>, Error> {
        self.arrangement.triangulated(FaceId::from_u32(face.to_u32()))
    }

    /// The edges of the complex as pairs of drawn vertices, the smaller first, each with what [`Self::faces_around`] wants to know.
    pub(super) fn drawn_edges(&self, edges: &[CellId], is_drawn: impl Fn(u32) -> bool) -> Vec<DrawnEdge> {
        let mut drawn = Vec::new();
        let ends = self.arrangement.fine().complex().edges();
        for &edge in edges {
            let mut start: Option<(u32, EdgeId, Sign)> = None;
            for (fine, sign) in self.arrangement.fine_edges(EdgeId::from_u32(edge.to_u32())) {
                let [mut from, mut to] = ends[fine.index()];
                if sign == Sign::Minus {
                    (from, to) = (to, from);
                }
                let (begin, first, run) = *start.get_or_insert((from, fine, sign));
                if is_drawn(to) {
                    let run = if begin < to { run } else { run.opposite() };
                    drawn.push(DrawnEdge { ends: [begin.min(to), begin.max(to)], first, run });
                    start = None;
                }
            }
        }
        drawn.sort_unstable_by_key(|edge| edge.ends);
        drawn
    }

    /// The faces around a drawn edge, counterclockwise seen from its larger end, with minus where their sides run towards the
    /// smaller.
    pub(super) fn faces_around(&self, edge: &DrawnEdge, faces: &[(u32, Sign)]) -> Vec<(CellId, Sign)> {
        let list = self.arrangement.fine().faces_around(edge.first).map(|(fine, side)| {
            let (face, sign) = faces[fine.index()];
            (CellId::from_u32(face), side.times(sign).times(edge.run))
        });
        let list: Vec<(CellId, Sign)> = list.collect();
        if edge.run == Sign::Plus { list } else { list.into_iter().rev().collect() }
    }

    /// What lies inside of faces and is not in their boundary: pairs of a face and an edge that it has on both sides, and of a face
    /// and a vertex that no edge of it ends at. `faces` rise.
    pub(super) fn inside_faces(&self, faces: &[(CellId, Sign)]) -> [Vec<(u32, u32)>; 2] {
        [self.arrangement.slits(faces.iter().map(|face| face.0)), self.arrangement.points_in_faces()]
    }

    /// The face that each face before merging is part of, minus if it runs the other way.
    pub(super) fn faces_of_fine(&self) -> Vec<(u32, Sign)> {
        let mut faces = vec![(0, Sign::Plus); self.arrangement.fine().complex().face_count()];
        for face in 0..self.complex.cell_count(2) {
            for (fine, sign) in self.arrangement.fine_faces(FaceId::new(face)) {
                faces[fine.index()] = (face as u32, sign);
            }
        }
        faces
    }

    /// The number of walks around faces beyond the first of each.
    pub(super) fn hole_count(&self) -> usize {
        self.arrangement.hole_count()
    }

    /// The number of shells of cells beyond the first of each.
    pub(super) fn void_count(&self) -> usize {
        self.arrangement.void_count()
    }

    /// Whether a coordinate of this vertex was rounded.
    pub(super) fn is_rounded(&self, vertex: CellId) -> bool {
        let vertex = VertexId::from_u32(vertex.to_u32());
        let is_moved = |coarse: &Arc<CoarsePositions>| {
            coarse.of_vertices.point(vertex) != self.arrangement.positions().point(vertex)
        };
        !self.arrangement.point(vertex).is_exactly_rounded() || self.coarse.as_ref().is_some_and(is_moved)
    }

    /// Whether the rounded coordinates of all vertices are their exact ones.
    pub(super) fn is_exactly_rounded(&self) -> bool {
        self.coarse.is_none() && self.arrangement.is_exactly_rounded()
    }

    /// Whether rounding moves each drawn vertex, or faces at it may be drawn otherwise than they were cut.
    pub(super) fn rounded_vertices(&self) -> Vec<bool> {
        let mut is_rounded = self.arrangement.rounded_vertices();
        if let Some(coarse) = &self.coarse {
            let before = self.arrangement.fine_triangles().positions().as_flat().as_chunks::<3>().0;
            let after = coarse.of_drawn.as_flat().as_chunks::<3>().0;
            for ((is_rounded, before), after) in is_rounded.iter_mut().zip(before).zip(after) {
                *is_rounded |= before != after;
            }
        }
        is_rounded
    }

    /// The same with positions rounded to a precision as they are: nothing is put together, and faces may cross.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) where that moves points by a part of the extent that
    /// is seen.
    pub(super) fn coarsely_rounded(&self, precision: CoordinatePrecision) -> Result<Self, Error> {
        refuse_rounding(self.drawn_positions(), precision)?;
        let rounded = |positions: &Positions| {
            Positions::from_flat(3, positions.as_flat().iter().map(|&x| precision.rounded(x)).collect())
        };
        let (of_vertices, of_drawn) = (rounded(self.positions())?, rounded(self.drawn_positions())?);
        let coarse = Some(Arc::new(CoarsePositions { of_vertices, of_drawn }));
        Ok(Self { coarse, volumes: OnceLock::new(), ..self.clone() })
    }

    /// What was put together.
    pub(super) fn joined(&self) -> Option<&JoinedFeatures> {
        self.arrangement.joined()
    }

    /// Where faces on rounded positions meet otherwise than in common corners and sides.
    pub(super) fn crossings(&self, most_listed: usize) -> Result<Crossings, Error> {
        if self.coarse.is_some() {
            let triangles = RaggedArray::from_lists(self.arrangement.drawn_triangles()?.triangles);
            let polygons = SpatialPolygons::from_polygons(self.drawn_positions().clone(), triangles)?;
            return polygons.crossings_of_changed(|_| true, most_listed);
        }
        self.arrangement.crossings_of_rounded(most_listed)
    }

    /// How many times coordinates were rounded and everything arranged again.
    pub(super) fn round_count(&self) -> usize {
        self.arrangement.round_count()
    }

    /// The polygons without area, which are left out.
    pub(super) fn degenerate_polygons(&self) -> &[u32] {
        match &self.origins {
            Some(origins) => &origins.without_area,
            None => self.arrangement.polygons_without_area(),
        }
    }

    /// The polygons that were split because they are not planar.
    pub(super) fn split_polygons(&self) -> &[SplitPolygon] {
        match &self.origins {
            Some(origins) => &origins.split,
            None => self.arrangement.split_polygons(),
        }
    }
}

/// An arrangement with rounded coordinates that are valid, unless they are too coarse for it.
fn snapped(
    arrangement: &SpatialArrangement,
    options: &SpatialOptions,
    request: &SpatialRequest,
) -> Result<SpatialArrangement, Error> {
    let before = arrangement.fine_triangles().positions();
    refuse_rounding(before, request.precision)?;
    let snapped = arrangement.snapped(&options.precision(request.precision))?;
    if request.precision != CoordinatePrecision::Double {
        refuse_movement(before, largest_movement(&snapped) - largest_movement(arrangement))?;
    }
    Ok(snapped)
}

fn largest_movement(arrangement: &SpatialArrangement) -> f64 {
    arrangement.joined().map_or(0.0, |joined| joined.largest_movement)
}

/// An edge between two drawn vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct DrawnEdge {
    pub(super) ends: [u32; 2],
    /// The first edge before merging, seen along the edge of the complex.
    first: EdgeId,
    /// Whether that runs from the smaller end to the larger.
    run: Sign,
}
