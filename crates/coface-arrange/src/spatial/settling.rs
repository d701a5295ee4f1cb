//! Drawings on floating-point points, joined where they nearly meet and cut, until nothing new comes of it.

use super::axis_view::AxisView;
use super::cutting::{Crossings, SpatialVertexSource, crossings};
use super::patches::Patches;
use super::predicates::{GivenPoints, SpatialPredicates};
use super::{SpatialArrangement, SpatialOptions};
use crate::near::{
    CoordinatePrecision, HotPlaces, JoinedFeatures, NONE, NearChains, NearCounts, STEADY_ROUNDS, minus,
    reach, squared,
};
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, RaggedArray, Sign, VertexId};
use coface_geometry::{Positions, cross, dot, frame_around};
use rayon::prelude::*;
use std::cmp::Ordering;

/// Where a tolerance is given, it is given up after so many rounds; what was joined until then is cut.
const ROUNDS_WITH_TOLERANCE: usize = 12;
/// To make rounding valid features are put together within so many times the least tolerance, in so many rounds each, before more is done.
const FIRST_ATTEMPTS: [(f64, usize); 3] = [(1.0, STEADY_ROUNDS), (4.0, 4), (32.0, 4)];
/// Such an attempt is given up where faces cross in so many times the places of the first round of all, and some more.
const GROWTH_OF_PLACES: usize = 2;
const GROWTH_OF_FEW_PLACES: usize = 1 << 6;
/// With numbers of 32 bits features farther apart than this part of the extent are not put together: that would be seen.
const SEEN_PART: f64 = 1.0 / 16384.0;
/// Where a tolerance is given, no point goes further than so many times that.
const MOST_WAY: f64 = 2.0;

/// Rounding is given up where a round has so many times the vertices of the first one, and some more.
const GROWTH: usize = 2;
const GROWTH_OF_SMALL: usize = 1 << 10;

/// A round may make so many cells for each vertex that it may have. Tetrahedra that fill space have 26: 1 vertex, 7 edges, 12 triangles, 6 tetrahedra.
const CELLS_OF_VERTEX: usize = 32;

/// How features are put together in rounds.
#[derive(Clone, Copy, Debug)]
struct Attempt {
    /// Whether features are put together within longer distances after some rounds, where faces cross; else what is left in the end is cut
    /// as it is.
    is_rounding: bool,
    /// Whether the attempt is given up where faces cross in more and more places, since others follow.
    is_first: bool,
    /// So many rounds at most.
    rounds: usize,
    /// The attempt is given up before features farther apart are put together.
    longest: f64,
}

impl Default for Attempt {
    fn default() -> Self {
        Self { is_rounding: false, is_first: false, rounds: 0, longest: f64::INFINITY }
    }
}

/// Triangles in patches that are to be arranged.
#[derive(Clone, Debug)]
pub(super) struct Drawing {
    points: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    /// Edges that triangles have, also those inside patches that lie on other patches.
    edges: Vec<[u32; 2]>,
    /// Whose `is_passing` has an entry for each point.
    patches: Patches,
    /// Where points were first.
    first: Vec<[f64; 3]>,
    /// For each of them, the point that it became; no number for one that vanished.
    place: Vec<u32>,
}

impl Drawing {
    /// Triangles on the points of polygons, which were at other places first.
    pub(super) fn new(
        first: Vec<[f64; 3]>,
        points: Vec<[f64; 3]>,
        triangles: Vec<[u32; 3]>,
        mut patches: Patches,
    ) -> Self {
        patches.is_passing = vec![false; points.len()];
        let place = (0..points.len() as u32).collect();
        Self { points, triangles, edges: Vec::new(), patches, first, place }
    }

    /// The faces of an arrangement on the rounded positions of its drawn vertices. Vertices that nothing needs are left
    /// out of edges that are straight within the tolerance, and faces that are as flat are drawn by their outlines.
    pub(super) fn of(
        arrangement: &SpatialArrangement,
        tolerance: f64,
        precision: CoordinatePrecision,
    ) -> Result<Self, Error> {
        let all = vec![Some(Sign::Plus); arrangement.complex().face_count()];
        Self::of_faces(arrangement, &all, false, tolerance, precision)
    }

    /// Some faces of an arrangement alone, which are part of one more polygon of an input of its own, with their fronts where
    /// these signs say.
    pub(super) fn of_surface(
        arrangement: &SpatialArrangement,
        surface: &[(FaceId, Sign)],
        tolerance: f64,
        precision: CoordinatePrecision,
    ) -> Result<Self, Error> {
        let mut signs = vec![None; arrangement.complex().face_count()];
        surface.iter().for_each(|&(face, sign)| signs[face.index()] = Some(sign));
        Self::of_faces(arrangement, &signs, true, tolerance, precision)
    }

    /// Those faces of an arrangement that have a sign.
    fn of_faces(
        arrangement: &SpatialArrangement,
        signs: &[Option<Sign>],
        is_surface: bool,
        tolerance: f64,
        precision: CoordinatePrecision,
    ) -> Result<Self, Error> {
        let is_flat: Vec<bool> = (0..arrangement.complex().face_count())
            .into_par_iter()
            .map(|face| arrangement.is_flat(FaceId::new(face), tolerance))
            .collect();
        let mut is_left_out = arrangement.left_out(&is_flat, tolerance);
        let mut lists: Vec<Vec<[u32; 3]>> = vec![Vec::new(); is_flat.len()];
        let wanted: Vec<usize> = (0..is_flat.len()).filter(|&face| signs[face].is_some()).collect();
        let mut due = wanted.clone();
        while !due.is_empty() {
            let own: Vec<Option<Vec<[u32; 3]>>> = due
                .par_iter()
                .map(|&face| {
                    arrangement.triangulated_without(FaceId::new(face), &is_left_out, is_flat[face]).ok()
                })
                .collect();
            // Without vertices that are not quite on straight lines a face may cross itself: it needs all of them, and so do
            // its neighbors there.
            let mut is_kept = vec![false; arrangement.cut.complex().vertex_count()];
            for (&face, _) in due.iter().zip(&own).filter(|(_, own)| own.is_none()) {
                for vertex in arrangement.fine_vertices(FaceId::new(face)) {
                    let is_left_out = is_left_out.get_mut(vertex as usize).map(std::mem::take);
                    // Of several faces the first says that it was left out.
                    is_kept[vertex as usize] |= is_left_out.unwrap_or(false);
                }
            }
            let needs = |face: &usize| {
                arrangement.fine_vertices(FaceId::new(*face)).iter().any(|&vertex| is_kept[vertex as usize])
            };
            let fails = own.iter().any(Option::is_none);
            let again: Vec<usize> =
                if fails { wanted.iter().copied().filter(needs).collect() } else { Vec::new() };
            for (&face, list) in due.iter().zip(own) {
                match list {
                    Some(list) => lists[face] = list,
                    None if again.binary_search(&face).is_err() => {
                        lists[face] = arrangement.triangulated_fine(FaceId::new(face))?;
                    }
                    None => {}
                }
            }
            due = again;
        }
        let (mut triangles, mut patch_of_triangle) = (Vec::new(), Vec::new());
        let (mut polygons_of_patch, mut packed) = (RaggedArray::new(), Vec::new());
        let mut input_of_polygon = arrangement.patches.input_of_polygon.clone();
        let (mut input_count, mut surface) = (arrangement.patches.input_count, arrangement.patches.surface);
        let added = is_surface.then_some(input_of_polygon.len() as u32);
        if added.is_some() {
            input_of_polygon.push(input_count as u32);
            input_count += 1;
            surface = added;
        }
        for ((face, list), sign) in (0..).zip(lists).zip(signs) {
            patch_of_triangle.extend(list.iter().map(|_| face));
            triangles.extend(list);
            // Of faces that were merged each has as many polygons of each input as all others.
            let first = arrangement.first_fine_face(FaceId::from_u32(face));
            packed.clear();
            let own = arrangement.patches_of_face.list(first.index());
            arrangement.patches.for_each_polygon(own, |polygon| packed.push(polygon));
            packed.extend(added.map(|polygon| polygon << 1 | u32::from(*sign == Some(Sign::Minus))));
            polygons_of_patch.push(&packed);
        }
        let is_original = |vertex: usize| {
            let vertex = VertexId::new(vertex);
            !arrangement.patches.is_new(&arrangement.cut, vertex.to_u32())
        };
        let first = arrangement.cut.positions().as_flat().as_chunks::<3>().0.to_vec();
        let points: Vec<[f64; 3]> = first.iter().map(|&point| precision.rounded_point(point)).collect();
        let is_passing = (0..points.len()).map(|vertex| !is_original(vertex)).collect();
        let patches = Patches {
            patch_of_triangle,
            folded: Vec::new(),
            bent: Vec::new(),
            torn: None,
            polygons_of_patch: Some(polygons_of_patch),
            input_of_polygon,
            input_count,
            surface,
            is_passing,
            keeps_vertices: false,
            has_new_corners: false,
        };
        let place = (0..points.len() as u32).collect();
        let mut is_edge_wanted = vec![!is_surface; arrangement.complex().edge_count()];
        if is_surface {
            let sides = wanted.iter().flat_map(|&face| arrangement.complex().packed_sides().list(face));
            sides.for_each(|&side| is_edge_wanted[(side >> 1) as usize] = true);
        }
        let edges = (0..is_edge_wanted.len()).filter(|&edge| is_edge_wanted[edge]).flat_map(|edge| {
            let path = arrangement.path(EdgeId::new(edge), &is_left_out);
            path.windows(2).map(|ends| [ends[0], ends[1]]).collect::<Vec<_>>()
        });
        let mut drawing = Self { first, edges: edges.collect(), points, triangles, patches, place };
        if is_surface {
            drawing.leave_out_points();
        }
        Ok(drawing)
    }

    /// Leaves out the points that nothing has.
    fn leave_out_points(&mut self) {
        let mut number = vec![NONE; self.points.len()];
        let corners = self.triangles.as_flattened().iter().chain(self.edges.as_flattened());
        corners.for_each(|&corner| number[corner as usize] = 0);
        let mut used = Vec::new();
        for (point, number) in number.iter_mut().enumerate().filter(|(_, number)| **number != NONE) {
            *number = used.len() as u32;
            used.push(point);
        }
        self.points = used.iter().map(|&point| self.points[point]).collect();
        self.patches.is_passing = used.iter().map(|&point| self.patches.is_passing[point]).collect();
        let corners = self.triangles.as_flattened_mut().iter_mut().chain(self.edges.as_flattened_mut());
        corners.for_each(|corner| *corner = number[*corner as usize]);
        self.place.iter_mut().for_each(|place| *place = number[*place as usize]);
    }

    /// The arrangement of the drawing, drawn and arranged again until there are no new vertices or, where rounding is
    /// all that is asked for, none that is not exactly at its rounded coordinates.
    ///
    /// Features within the tolerance are put together everywhere. When rounding is all that is asked for, a few rounds with that are
    /// followed by a few with somewhat more, from the beginning: two faces along each other cross anew wherever one of them is
    /// bent, more often in each round, and are one face at once when they are put together. Where that is not enough, features that are
    /// farther apart are put together too after some rounds, but only around the places where faces still cross: within a
    /// reach that is twice that of the round before, and boxes around these places that grow with it. When the reach is
    /// that of the whole drawing, all of it is one point, and no faces are left that cross: so this ends. With numbers of 32 bits,
    /// which are too coarse for it then, it ends before that with an error. Where a
    /// tolerance is asked for, it stays what it is, and no point goes further than twice that; after some rounds
    /// what was joined is cut as it is, and [`JoinedFeatures::unsettled`] counts the places that were cut anew.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) for more cells than the options take;
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) where rounding alone would make several times
    /// as many vertices as there are.
    pub(super) fn settled(
        self,
        options: &SpatialOptions,
        tolerance: f64,
        is_rounding: bool,
    ) -> Result<SpatialArrangement, Error> {
        if !is_rounding {
            let attempt = Attempt { rounds: ROUNDS_WITH_TOLERANCE, ..Attempt::default() };
            return self.settled_in(options, tolerance, attempt, &mut None);
        }
        let mut first_places = None;
        for (units, rounds) in FIRST_ATTEMPTS {
            let attempt = Attempt { is_rounding: units == 1.0, is_first: true, rounds, ..Attempt::default() };
            match self.clone().settled_in(options, units * tolerance, attempt, &mut first_places) {
                Ok(found) if found.is_exactly_rounded() && found.is_held(options.precision) => {
                    return Ok(found);
                }
                Ok(_) => {}
                Err(error) if error.kind() == ErrorKind::InvalidInput => {}
                Err(error) => return Err(error),
            }
        }
        let diagonal = diagonal(&self.points);
        let longest = match options.precision {
            CoordinatePrecision::Double => f64::INFINITY,
            CoordinatePrecision::Single => SEEN_PART * diagonal,
        };
        let rounds = rounds_to_an_end(diagonal, tolerance);
        let attempt = Attempt { is_rounding: true, rounds, longest, ..Attempt::default() };
        self.settled_in(options, tolerance, attempt, &mut first_places)
    }

    /// The same in one attempt. `first_places` is the number of places where faces cross in the first round of the first one.
    fn settled_in(
        self,
        options: &SpatialOptions,
        tolerance: f64,
        attempt: Attempt,
        first_places: &mut Option<usize>,
    ) -> Result<SpatialArrangement, Error> {
        let Attempt { is_rounding, is_first, rounds: most, longest } = attempt;
        let mut drawing = self;
        let precision = options.precision;
        let mut joined = JoinedFeatures { tolerance, ..JoinedFeatures::default() };
        let most_way = (!is_rounding).then_some(MOST_WAY * tolerance);
        let most_vertices = GROWTH * drawing.points.len() + GROWTH_OF_SMALL;
        let given_up = |makes: String, tolerance: f64, points: usize| {
            Error::invalid(format!(
                "putting features together that are less than {tolerance:e} apart makes {makes} where there were {points} vertices"
            ))
            .with_cure("scale the model up, or remove polygons that nearly coincide")
        };
        // A round that makes too much ends while its points are counted: all of them would take minutes, and gigabytes.
        let most_cells = CELLS_OF_VERTEX * most_vertices;
        let is_own = is_rounding && options.max_cells.is_none_or(|asked| asked > most_cells);
        let bounded = if is_own { options.max_cells(most_cells) } else { *options };
        let mut hot = Vec::new();
        for round in 0..most {
            if is_rounding {
                joined.tolerance = reach(tolerance, round);
            }
            if joined.tolerance > longest {
                break;
            }
            let is_local = is_rounding && round >= STEADY_ROUNDS;
            let places = is_local.then(|| HotPlaces::new(&hot, joined.tolerance));
            let most_points = is_rounding.then(|| drawing.points.len() + most_vertices);
            let bounds = (most_way, most_points);
            let Some(counts) = drawing.join(tolerance, places, joined.tolerance, precision, bounds) else {
                let makes = format!("more than {most_vertices} new vertices");
                return Err(given_up(makes, joined.tolerance, drawing.first.len()));
            };
            joined.counts.add(&counts);
            let Self { points, triangles, patches, first, place, .. } = drawing;
            let positions = Positions::from_flat(3, points.into_flattened())?;
            // Faces of different polygons become one in the end alone: a round that draws them with less vertices than their
            // neighbors makes them cross.
            let of_end = options.merge_coplanar.then(|| patches.clone());
            let found = SpatialArrangement::of_triangles(
                &positions,
                &triangles,
                patches,
                None,
                &bounded.merge_coplanar(false),
            );
            let mut arrangement = found.map_err(|error| match error.kind() {
                ErrorKind::TooLarge if is_own => {
                    given_up(format!("more than {most_cells} cells"), joined.tolerance, first.len())
                }
                _ => error,
            })?;
            arrangement.options = *options;
            hot = arrangement.new_places();
            let is_settled = hot.is_empty()
                || (is_rounding && arrangement.is_exactly_rounded() && arrangement.is_held(precision));
            let vertex_count = arrangement.cut.complex().vertex_count();
            if !is_settled && is_rounding && vertex_count > most_vertices {
                return Err(given_up(format!("{vertex_count} vertices"), joined.tolerance, first.len()));
            }
            let most_places =
                GROWTH_OF_PLACES * *first_places.get_or_insert(hot.len()) + GROWTH_OF_FEW_PLACES;
            if !is_settled && is_first && hot.len() > most_places {
                let makes = format!("faces cross in {} places", hot.len());
                return Err(given_up(makes, joined.tolerance, first.len()));
            }
            let is_last = !is_rounding && (round + 1 == most || vertex_count > most_vertices);
            if is_settled || is_last {
                if let Some(patches) = of_end {
                    arrangement =
                        SpatialArrangement::of_triangles(&positions, &triangles, patches, None, options)?;
                }
                if !is_settled {
                    joined.unsettled = hot.len();
                }
                joined.tell(&first, &place, positions.as_flat().as_chunks().0);
                arrangement.round_count = round + 1;
                arrangement.joined = Some(joined);
                return Ok(arrangement);
            }
            // What is bent only a little is straightened as long as that is all that is put together.
            let straight = if is_local { 0.0 } else { joined.tolerance };
            drawing = Self::of(&arrangement, straight, precision)?;
            (drawing.first, drawing.place) = (first, place);
        }
        Err(Error::invalid(format!(
            "features less than {:e} apart are put together again and again: {most} rounds are not enough",
            joined.tolerance
        ))
        .with_cure("scale the model up, or remove polygons that nearly coincide"))
    }

    /// Puts together what is near, and leaves out points that nothing has any more.
    ///
    /// Within the tolerance everywhere, then within `reach` near some places. None where there are more points then than there may be.
    fn join(
        &mut self,
        tolerance: f64,
        places: Option<HotPlaces>,
        reach: f64,
        precision: CoordinatePrecision,
        (most_way, most_points): (Option<f64>, Option<usize>),
    ) -> Option<NearCounts> {
        let ways = most_way.map(|_| self.ways());
        let mut near = NearChains::of_panels(
            std::mem::take(&mut self.points),
            &self.triangles,
            &self.patches.patch_of_triangle,
            std::mem::take(&mut self.edges),
            std::mem::take(&mut self.patches.is_passing),
            tolerance,
        );
        (near.precision, near.most_points) = (precision, most_points);
        if let Some((most, ways)) = most_way.zip(ways) {
            near.bound_movements(most, ways);
        }
        near.join(tolerance, |near| near.put_vertices_on_panels(tolerance));
        if let Some(places) = places {
            near.stay_near(places);
            near.join(reach, |near| near.put_vertices_on_panels(reach));
        }
        if near.has_too_many_points() {
            return None;
        }
        let (triangles, patch_of_triangle) = near.triangles(tolerance, reach);
        let mut number = vec![NONE; near.points.len()];
        triangles.as_flattened().iter().for_each(|&corner| number[corner as usize] = 0);
        let mut used = Vec::new();
        for (point, number) in number.iter_mut().enumerate().filter(|(_, number)| **number != NONE) {
            *number = used.len() as u32;
            used.push(point);
        }
        for place in self.place.iter_mut().filter(|place| **place != NONE) {
            *place = number[near.end_of(*place) as usize];
        }
        self.points = used.iter().map(|&point| near.points[point]).collect();
        self.patches.is_passing = used.iter().map(|&point| near.is_passing[point]).collect();
        let renumbered = |own: [u32; 3]| own.map(|corner| number[corner as usize]);
        self.triangles = triangles.into_iter().map(renumbered).collect();
        self.patches.patch_of_triangle = patch_of_triangle;
        self.fold();
        Some(near.counts)
    }

    /// How far the points that became each vertex went, the longest way of each.
    fn ways(&self) -> Vec<f64> {
        let mut ways = vec![0.0; self.points.len()];
        for (first, &place) in self.first.iter().zip(&self.place).filter(|(_, place)| **place != NONE) {
            let way: &mut f64 = &mut ways[place as usize];
            *way = way.max(squared(minus(self.points[place as usize], *first)).sqrt());
        }
        ways
    }

    /// Finds out which patches are not planar any more, with the pictures in which all of their triangles run
    /// counterclockwise; triangles of a patch that has none are patches of their own.
    fn fold(&mut self) {
        let Ok(positions) = Positions::from_flat(3, self.points.as_flattened().to_vec()) else { return };
        let Ok(points) = GivenPoints::new(&positions) else { return };
        let of_triangle = &self.patches.patch_of_triangle;
        let count = of_triangle.iter().max().map_or(0, |&last| last as usize + 1);
        let triangles_of_patch = RaggedArray::grouped(count, of_triangle.iter().copied());
        let shape = |patch: usize| {
            let own =
                triangles_of_patch.list(patch).iter().map(|&triangle| self.triangles[triangle as usize]);
            shape(&own.collect::<Vec<_>>(), &self.points, &points)
        };
        let shapes: Vec<Shape> = (0..count).into_par_iter().map(shape).collect();
        self.patches.folded.clear();
        self.patches.bent.clear();
        self.patches.torn = None;
        let mut lists = match self.patches.polygons_of_patch.take() {
            Some(lists) => lists,
            None => {
                let polygons = 0..self.patches.input_of_polygon.len() as u32;
                RaggedArray::from_lists(polygons.map(|polygon| [2 * polygon]))
            }
        };
        for (patch, shape) in (0u32..).zip(shapes) {
            match shape {
                Shape::Flat => {}
                Shape::Folded(view) => self.patches.folded.push((patch, view)),
                Shape::Apart => {
                    let own = lists.list(patch as usize).to_vec();
                    for &triangle in triangles_of_patch.list(patch as usize) {
                        self.patches.patch_of_triangle[triangle as usize] = lists.len() as u32;
                        lists.push(&own);
                    }
                }
            }
        }
        self.patches.polygons_of_patch = Some(lists);
    }
}

/// The diagonal of the box around points.
fn diagonal(points: &[[f64; 3]]) -> f64 {
    let frame = frame_around(points.len(), |i| points[i].map(|x| [x; 2]));
    squared(minus(frame.map(|side| side[1]), frame.map(|side| side[0]))).sqrt()
}

/// So many rounds until features are put together that are as far apart as anything in a drawing.
fn rounds_to_an_end(diagonal: f64, tolerance: f64) -> usize {
    let doublings = (diagonal / tolerance).log2().ceil().max(0.0);
    // Two more, since distances are rounded.
    if doublings.is_finite() { STEADY_ROUNDS.max(ROUNDS_WITH_TOLERANCE) + doublings as usize + 2 } else { 1 }
}

/// How the triangles of a patch lie.
enum Shape {
    Flat,
    Folded(AxisView),
    Apart,
}

fn shape(own: &[[u32; 3]], points: &[[f64; 3]], predicates: &GivenPoints<'_>) -> Shape {
    let [first, rest @ ..] = own else { return Shape::Flat };
    if rest.is_empty() {
        return Shape::Flat;
    }
    let normal = own.iter().fold([0.0; 3], |sum, &[a, b, c]| {
        let [a, b, c] = [a, b, c].map(|corner| points[corner as usize]);
        let normal = cross([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
        [0, 1, 2].map(|i| sum[i] + normal[i])
    });
    let axis = (0..3).max_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap_or(0);
    let from = if normal[axis] < 0.0 { Sign::Minus } else { Sign::Plus };
    let view = AxisView { axis: axis as u8, from };
    if own.iter().any(|&triangle| view.turn(predicates, triangle) != Ordering::Greater) {
        return Shape::Apart;
    }
    let [a, b, c] = *first;
    let is_in_plane = |corner: &u32| predicates.orientation([a, b, c, *corner]).is_eq();
    if rest.as_flattened().iter().all(is_in_plane) { Shape::Flat } else { Shape::Folded(view) }
}

impl SpatialArrangement {
    /// Where faces on rounded positions meet otherwise than in common corners and sides: nowhere if rounding is valid. At
    /// most so many places are listed.
    ///
    /// # Errors
    /// As [`Self::triangulated`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert_eq!(tetrahedron.crossings_of_rounded(10)?.count, 0);
    /// # Ok(()) }
    /// ```
    pub fn crossings_of_rounded(&self, most_listed: usize) -> Result<Crossings, Error> {
        if self.is_exactly_rounded() {
            return Ok(Crossings::default());
        }
        let triangles = self.drawn_triangles()?.triangles;
        let is_moved = self.rounded_vertices();
        let is_changed = |own: usize| triangles[own].iter().any(|&corner| is_moved[corner as usize]);
        let mut found = crossings(self.cut.positions(), &triangles, is_changed, most_listed)?;
        // Different vertices at one place are one for whoever reads the coordinates.
        let mut drawn: Vec<u32> = triangles.into_flattened();
        drawn.sort_unstable();
        drawn.dedup();
        let key = |&vertex: &u32| self.rounded(vertex).map(|x| (x + 0.0).to_bits());
        drawn.sort_by_key(key);
        for pair in drawn.windows(2).filter(|pair| key(&pair[0]) == key(&pair[1])) {
            found.add(self.rounded(pair[0]), most_listed);
        }
        Ok(found)
    }

    /// Whether all of a face is exactly in one plane. Faces of polygons that are not planar, and those that rounding
    /// bent, are not: drawn as polygons they may be bent along other lines.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 1., 1., 0.5, 0., 1., 0.])?;
    /// let bent = SpatialPolygons::from_polygons(corners, RaggedArray::from_lists([[0, 1, 2, 3]]))?;
    /// let arrangement = SpatialArrangement::new(&bent, &SpatialOptions::new())?;
    /// assert!(!arrangement.is_planar(FaceId::new(0)));
    /// # Ok(()) }
    /// ```
    pub fn is_planar(&self, face: FaceId) -> bool {
        let fine = self.first_fine_face(face);
        self.patches.fold(self.patches_of_face.list(fine.index())).is_none()
    }

    /// Whether rounding moves each fine vertex, or faces at it may be drawn otherwise than they were cut.
    #[doc(hidden)]
    pub fn rounded_vertices(&self) -> Vec<bool> {
        let count = self.cut.complex().vertex_count();
        let is_rounded = |fine: usize| self.joined.is_some() || !self.is_exact(fine as u32);
        (0..count).into_par_iter().map(is_rounded).collect()
    }

    /// Where fine vertices are that are no points of the input.
    fn new_places(&self) -> Vec<[f64; 3]> {
        let is_new =
            |fine: &u32| !matches!(self.cut.source(VertexId::from_u32(*fine)), SpatialVertexSource::Given(_));
        let fine = 0..self.cut.complex().vertex_count() as u32;
        fine.filter(is_new).map(|fine| self.rounded(fine)).collect()
    }

    fn rounded(&self, fine: u32) -> [f64; 3] {
        let point = self.cut.positions().point(VertexId::from_u32(fine));
        [point[0], point[1], point[2]]
    }

    /// The fine vertices on the sides of the fine faces of a face.
    fn fine_vertices(&self, face: FaceId) -> Vec<u32> {
        let fine = self.fine_faces(face);
        let sides = fine.flat_map(|(fine, _)| self.cut.complex().packed_sides().list(fine.index()));
        sides.map(|&side| self.cut.complex().side_ends(side)[0]).collect()
    }

    /// The fine vertices along an edge, but for those that are left out.
    fn path(&self, edge: EdgeId, is_left_out: &[bool]) -> Vec<u32> {
        let Some(merged) = &self.merged else { return self.complex().edges()[edge.index()].to_vec() };
        let mut path = merged.path(self.cut.complex(), edge.to_u32() << 1);
        path.retain(|&vertex| !is_left_out[vertex as usize]);
        path
    }

    /// Whether all of a face is this near to a plane.
    fn is_flat(&self, face: FaceId, tolerance: f64) -> bool {
        if self.is_planar(face) {
            return true;
        }
        let sides: Vec<[u32; 2]> = self
            .fine_faces(face)
            .flat_map(|(fine, _)| self.cut.complex().packed_sides().list(fine.index()))
            .map(|&side| self.cut.complex().side_ends(side))
            .collect();
        let origin = self.rounded(sides[0][0]);
        let relative = |vertex: u32| {
            let point = self.rounded(vertex);
            [0, 1, 2].map(|axis| point[axis] - origin[axis])
        };
        let mut normal = [0.0; 3];
        for path in self.paths(face) {
            for pair in path.windows(2) {
                let part = cross(relative(pair[0]), relative(pair[1]));
                normal = [0, 1, 2].map(|axis| normal[axis] + part[axis]);
            }
        }
        let length = dot(normal, normal).sqrt();
        let heights = sides.iter().map(|side| dot(relative(side[0]), normal));
        let (low, high) =
            heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        high - low <= 2.0 * tolerance * length
    }

    /// The fine vertices that need not be drawn: those that no face needs, and those inside edges of flat faces that
    /// are straight within the tolerance.
    fn left_out(&self, is_flat: &[bool], tolerance: f64) -> Vec<bool> {
        let Some(merged) = &self.merged else { return Vec::new() };
        let mut is_left_out = self.is_omitted.clone();
        let mut is_bent = vec![false; merged.edges.len()];
        for (face, sides) in self.complex().packed_sides().iter().enumerate() {
            if !is_flat[face] {
                sides.iter().for_each(|&side| is_bent[(side >> 1) as usize] = true);
            }
        }
        for edge in (0..merged.edges.len()).filter(|&edge| !is_bent[edge]) {
            let path = merged.path(self.cut.complex(), EdgeId::new(edge).to_u32() << 1);
            let [first, inner @ .., last] = &path[..] else { continue };
            let (a, b) = (self.rounded(*first), self.rounded(*last));
            let along = [0, 1, 2].map(|axis| b[axis] - a[axis]);
            let length = dot(along, along);
            let mut before = 0.0;
            let is_straight = inner.iter().all(|&vertex| {
                let point = self.rounded(vertex);
                let to = [0, 1, 2].map(|axis| point[axis] - a[axis]);
                let part = dot(to, along) / length;
                let off = [0, 1, 2].map(|axis| to[axis] - part * along[axis]);
                let is_further = part > before && part < 1.0;
                before = part;
                is_further && dot(off, off) <= tolerance * tolerance
            });
            if is_straight {
                inner.iter().for_each(|&vertex| is_left_out[vertex as usize] = true);
            }
        }
        is_left_out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::near::least_tolerance;
    use crate::spatial::SpatialPolygons;
    use std::collections::HashMap;

    const PRECISION: CoordinatePrecision = CoordinatePrecision::Single;

    /// Numbers from 0 to 1 that look random.
    fn noise(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
        move || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    /// A sphere of quadrangles that are cut into triangles, with rough points about (90, 90, 90), and copies of it a little aside.
    fn nearly_equal_spheres(seed: u64) -> SpatialPolygons {
        let (rows, columns) = (6u32, 10u32);
        let mut random = noise(seed);
        let mut points = vec![[90.0, 90.0, 91.0], [90.0, 90.0, 89.0]];
        for row in 1..rows {
            for column in 0..columns {
                let (up, around) = (f64::from(row) / f64::from(rows), f64::from(column) / f64::from(columns));
                let (up, around) = (up * std::f64::consts::PI, around * std::f64::consts::TAU);
                let away = 1.0 + 0.05 * random();
                let out = [up.sin() * around.cos(), up.sin() * around.sin(), up.cos()];
                points.push(out.map(|x| 90.0 + away * x));
            }
        }
        let at = |row: u32, column: u32| 2 + (row - 1) * columns + column % columns;
        let mut triangles = Vec::new();
        for column in 0..columns {
            triangles.push([0, at(1, column), at(1, column + 1)]);
            triangles.push([1, at(rows - 1, column + 1), at(rows - 1, column)]);
            for row in 1..rows - 1 {
                let (a, b) = (at(row, column), at(row + 1, column));
                let (c, d) = (at(row + 1, column + 1), at(row, column + 1));
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        let mut moved = |copy: usize| {
            let far = if copy == 0 { 0.0 } else { 2e-3 };
            let flat = points.iter().flat_map(|point| point.map(|x| x + far * (random() - 0.5))).collect();
            let positions = Positions::from_flat(3, flat).unwrap();
            SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(&triangles)).unwrap()
        };
        let copies: Vec<SpatialPolygons> = (0..3).map(&mut moved).collect();
        SpatialPolygons::joined(&copies).unwrap()
    }

    /// The number of sides that triangles of an input have more often one way than the other.
    fn open_side_count(drawing: &Drawing) -> usize {
        let mut balance: HashMap<(u32, [u32; 2]), i32> = HashMap::new();
        for (&[a, b, c], &patch) in drawing.triangles.iter().zip(&drawing.patches.patch_of_triangle) {
            drawing.patches.for_each_polygon(&[patch << 1], |polygon| {
                let input = drawing.patches.input_of_polygon[(polygon >> 1) as usize];
                let sign = if polygon & 1 == 0 { 1 } else { -1 };
                for [from, to] in [[a, b], [b, c], [c, a]] {
                    let run = if from < to { sign } else { -sign };
                    *balance.entry((input, [from.min(to), from.max(to)])).or_default() += run;
                }
            });
        }
        balance.values().filter(|&&own| own != 0).count()
    }

    #[test]
    fn drawings_of_closed_inputs_are_closed_in_each_round() {
        for seed in 20..26 {
            let polygons = nearly_equal_spheres(seed);
            let options = SpatialOptions::new().precision(PRECISION).merge_coplanar(seed % 2 == 0);
            let exact = SpatialArrangement::new(&polygons, &options).unwrap();
            let tolerance = 20.0 * least_tolerance(polygons.positions().as_flat().as_chunks().0, PRECISION);
            let mut drawing = Drawing::of(&exact, tolerance, PRECISION).unwrap();
            for round in 0..4 {
                assert_eq!(open_side_count(&drawing), 0, "seed {seed}, before round {round}");
                drawing.join(tolerance, None, tolerance, PRECISION, (None, None)).unwrap();
                assert_eq!(open_side_count(&drawing), 0, "seed {seed}, in round {round}");
                let Drawing { points, triangles, patches, .. } = drawing;
                let positions = Positions::from_flat(3, points.into_flattened()).unwrap();
                let plain = options.merge_coplanar(false);
                let found = SpatialArrangement::of_triangles(&positions, &triangles, patches, None, &plain);
                let found = found.unwrap();
                assert!(found.open_inputs().unwrap().is_empty(), "seed {seed}, after round {round}");
                drawing = Drawing::of(&found, tolerance, PRECISION).unwrap();
            }
        }
    }
}
