//! Canonical polygons drawn as regular polygons.

use super::component::{CanonicalComponent, CurveKind};
use super::cut::CanonicalCut;
use super::refinement::{Mark, Refinement, Segment};
use crate::curves::intrinsic::IntrinsicTriangulation;
use crate::curves::shortest_paths::checked_lengths;
use crate::hodge::{CholeskyFactor, MOST_FILL};
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId, RaggedArray, Sign, VertexId};
use coface_complexes::surface::{GeneralizedMap, Slice};
use std::f64::consts::PI;

const NONE: u32 = u32::MAX;

/// How often edges are split.
const MOST_ROUNDS: usize = 16;

/// The largest number of flips for each edge.
const MOST_FLIPS: usize = 100;

/// No spring is weaker: cotangents may be 0.
const LEAST_WEIGHT: f64 = 1e-8;

/// An edge between two vertices of a slice, and how strongly it pulls.
type Spring = ([u32; 2], f64);

/// Where a canonical polygon is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PolygonPlane {
    /// The Euclidean plane: a regular polygon in the unit circle.
    Euclidean,
    /// The disk of Klein, where geodesics of the hyperbolic plane are straight: the regular polygon whose corners make one full turn
    /// together.
    Klein,
}

/// The walk around the polygon of one component.
struct Rim {
    /// The vertices of the slice, in the order of the word.
    vertices: Vec<u32>,
    /// Where each side starts, and the end.
    starts: Vec<usize>,
}

impl CanonicalCut {
    /// The same cut of a surface that can be drawn with straight sides: faces that are no triangles get a vertex inside, and edges are
    /// split until no two join the same vertices of the [slice](Self::slice) and none joins two points of one side of a polygon.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if that does not end after sixteen rounds.
    ///
    /// # Complexity
    /// $O(n \log n)$ a round; one or two rounds serve for simplicial surfaces.
    ///
    /// # Examples
    /// The torus made of one square has one vertex; drawn, its square needs more.
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// let drawn = cut.straightened()?;
    /// assert_eq!(drawn.components()[0].word(), cut.components()[0].word());
    /// let triangles = drawn.refinement().map().skeleton().faces();
    /// assert!(triangles.iter().all(|face| face.len() == 3));
    /// # Ok(()) }
    /// ```
    pub fn straightened(&self) -> Result<Self, Error> {
        let map = self.refinement.map();
        let is_polygon = |&face: &FaceId| map.sides_of(face).count() != 3;
        let polygons: Vec<FaceId> = (0..map.face_count()).map(FaceId::new).filter(is_polygon).collect();
        let mut cut = if polygons.is_empty() {
            self.clone()
        } else {
            let refinement = Refinement::poked(map, &polygons).after(&self.refinement);
            Self { refinement, components: self.components.clone() }
        };
        for _ in 0..MOST_ROUNDS {
            let split = cut.edges_to_split();
            if split.is_empty() {
                return Ok(cut);
            }
            cut = cut.with_edges_split(&split);
        }
        Err(Error::new(ErrorKind::TooLarge, "the surface does not become simplicial by splitting edges")
            .with_cure("subdivide the surface first"))
    }

    /// The edges of the refined surface that keep its slice from being drawn, rising: loops, all but one of those between the same two
    /// vertices, and those inside that join two points of one side.
    fn edges_to_split(&self) -> Vec<EdgeId> {
        let slice = self.slice();
        let open = slice.surface();
        let sides = sides_of_vertices(&self.rims(&slice), open.vertex_count());
        let mut split = Vec::new();
        let mut pairs: Vec<([VertexId; 2], bool, EdgeId)> = Vec::with_capacity(open.edge_count());
        for edge in (0..open.edge_count()).map(EdgeId::new) {
            let mut ends = open.skeleton().edge(edge);
            ends.sort_unstable();
            let is_inside = open.mate(open.first_side(edge)).is_some();
            let [a, b] = ends.map(|end| sides[end.index()]);
            let is_along_side = is_inside && a.iter().any(|side| *side != NONE && b.contains(side));
            if ends[0] == ends[1] || is_along_side {
                split.push(slice.edge_sources()[edge]);
            } else {
                pairs.push((ends, is_inside, slice.edge_sources()[edge]));
            }
        }
        pairs.sort_unstable();
        split.extend(pairs.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1].2));
        split.sort_unstable();
        split.dedup();
        split
    }

    /// The same cut with a vertex in the middle of each of these edges, of a surface of triangles.
    fn with_edges_split(&self, edges: &[EdgeId]) -> Self {
        let map = self.refinement.map();
        let mut points = vec![Vec::new(); map.edge_count()];
        for (&edge, point) in edges.iter().zip(map.vertex_count() as u32..) {
            points[edge.index()].push(point);
        }
        let segments = segments_between(map, &points);
        let is_split: Vec<bool> = points.iter().map(|inner| !inner.is_empty()).collect();
        let (refined, _) = Refinement::along(map, &RaggedArray::from_lists(points), &segments);
        let parts = refined.first_parts(map.edge_count());
        let mut components = self.components.clone();
        for curve in components.iter_mut().flat_map(|component| &mut component.curves) {
            let parts_of = |&step: &u32| {
                let (edge, back) = ((step >> 1) as usize, step & 1);
                let first = 2 * parts[edge] + back;
                match (is_split[edge], back) {
                    (false, _) => [Some(first), None],
                    (true, 0) => [Some(first), Some(first + 2)],
                    (true, _) => [Some(first + 2), Some(first)],
                }
            };
            curve.steps = curve.steps.iter().flat_map(parts_of).flatten().collect();
        }
        Self { refinement: refined.after(&self.refinement), components }
    }

    /// Points in the plane for the vertices of the [slice](Self::slice), so that each polygon is regular, and each vertex inside lies in the
    /// middle of its neighbors: then no triangle is turned over, but for rounding, if the cut is [straightened](Self::straightened).
    ///
    /// With `lengths` of the edges of the refined surface vertices have the weights of cotangents instead, of the intrinsic Delaunay
    /// triangulation, where they are not negative: that keeps angles better. Then no triangle of that triangulation is turned over, and those of the
    /// surface may be where edges were flipped.
    ///
    /// Sides that are glued have the same points on them, evenly spaced in the plane's own lengths. The corner where the word starts is at
    /// (1, 0) as far as the unit circle is concerned, and the word runs counterclockwise. A polygon of fewer than three sides has all
    /// its vertices on the circle. Components lie beside each other, 2.5 apart.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] in the disk of Klein for components with a boundary or a characteristic that is not negative;
    /// [`ErrorKind::Shape`] unless there are as many lengths as edges of the refined surface; [`ErrorKind::TooLarge`] if there are too many
    /// equations.
    ///
    /// # Complexity
    /// One sparse Cholesky factor with as many unknowns as there are vertices inside, for both coordinates.
    ///
    /// # References
    /// W. T. Tutte, *How to draw a graph* (1963); M. Floater, *One-to-one piecewise linear mappings over triangulations* (2003);
    /// U. Pinkall, K. Polthier, *Computing discrete minimal surfaces and their conjugates* (1993).
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::{CanonicalCut, PolygonPlane};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?.straightened()?;
    /// let slice = cut.slice();
    /// let points = cut.layout(&slice, PolygonPlane::Euclidean, None)?;
    /// assert_eq!(points.len(), slice.surface().vertex_count());
    /// assert!(points.iter().all(|[x, y]| x.hypot(*y) < 1.0 + 1e-12));
    /// # Ok(()) }
    /// ```
    pub fn layout(
        &self,
        slice: &Slice<GeneralizedMap>,
        plane: PolygonPlane,
        lengths: Option<&[f64]>,
    ) -> Result<Vec<[f64; 2]>, Error> {
        let rims = self.rims(slice);
        let mut places = vec![None; slice.surface().vertex_count()];
        for (i, (rim, component)) in rims.iter().zip(&self.components).enumerate() {
            let corner_count = rim.starts.len() - 1;
            if plane == PolygonPlane::Klein {
                check_hyperbolic(component)?;
            }
            for side in 0..corner_count {
                let (from, to) = (rim.starts[side], rim.starts[side + 1]);
                for at in from..to {
                    let share = (at - from) as f64 / (to - from) as f64;
                    let [x, y] = place_on_side(plane, corner_count, side, share);
                    places[rim.vertices[at] as usize] = Some([x + 2.5 * i as f64, y]);
                }
            }
        }
        let open = slice.surface();
        let springs: Vec<Spring> = match lengths {
            None => {
                let edges = (0..open.edge_count()).map(EdgeId::new);
                edges.map(|edge| (open.skeleton().edge(edge).map(VertexId::to_u32), 1.0)).collect()
            }
            Some(lengths) => {
                let lengths = checked_lengths(self.refinement.map(), Some(lengths))?;
                let own: Vec<f64> = slice.edge_sources().iter().map(|edge| lengths[edge.index()]).collect();
                let mut intrinsic = IntrinsicTriangulation::new(open, &own)?;
                intrinsic.make_delaunay(MOST_FLIPS * open.edge_count());
                intrinsic.weights().map(|(ends, weight)| (ends, weight.max(LEAST_WEIGHT))).collect()
            }
        };
        balanced(places, &springs)
    }

    /// The walks around all polygons.
    fn rims(&self, slice: &Slice<GeneralizedMap>) -> Vec<Rim> {
        let (map, open) = (self.refinement.map(), slice.surface());
        let orientation = open.orientation();
        let mut rims: Vec<Option<Rim>> = self.components.iter().map(|_| None).collect();
        for walk in open.boundary_loops() {
            let i = orientation.component(open.face(walk[0].0));
            // The step on the refined surface and the vertex where it starts.
            let mut steps: Vec<(u32, u32)> = (walk.iter())
                .map(|&(side, sign)| {
                    let back = u32::from(sign == Sign::Minus);
                    let start = open.skeleton().edge_ends()[(open.step(side) ^ back) as usize];
                    (map.step(side) ^ back, start)
                })
                .collect();
            rims[i] = Some(self.components[i].rim(&mut steps));
        }
        rims.into_iter().map(|rim| rim.expect("each component is a disk")).collect()
    }
}

impl CanonicalComponent {
    /// The walk around the polygon in the direction and from the corner of the word.
    fn rim(&self, steps: &mut [(u32, u32)]) -> Rim {
        let lengths = |letter: i32| self.curves[letter.unsigned_abs() as usize - 1].steps.len();
        let expected: Vec<u32> = (self.word.iter())
            .flat_map(|&letter| {
                let own = &self.curves[letter.unsigned_abs() as usize - 1].steps;
                if letter > 0 { own.clone() } else { own.iter().rev().map(|step| step ^ 1).collect() }
            })
            .collect();
        let is_here =
            |steps: &[(u32, u32)]| steps.iter().zip(&expected).all(|(found, step)| found.0 == *step);
        'found: for _ in 0..2 {
            for start in 0..steps.len() {
                if steps[start].0 == expected[0] {
                    steps.rotate_left(start);
                    if is_here(steps) {
                        break 'found;
                    }
                    steps.rotate_right(start);
                }
            }
            // Backwards each step starts where it ended.
            let first = steps[0].1;
            let count = steps.len();
            for i in 0..count {
                let end = if i + 1 < count { steps[i + 1].1 } else { first };
                steps[i] = (steps[i].0 ^ 1, end);
            }
            steps.reverse();
        }
        assert!(is_here(steps), "the walk around a polygon has its word");
        let vertices: Vec<u32> = steps.iter().map(|step| step.1).collect();
        let mut starts = vec![0];
        if self.word.len() < 3 {
            starts.extend(1..=vertices.len());
        } else {
            for &letter in &self.word {
                starts.push(starts[starts.len() - 1] + lengths(letter));
            }
        }
        Rim { vertices, starts }
    }
}

/// The one or two sides that each vertex of the slice lies on.
fn sides_of_vertices(rims: &[Rim], vertex_count: usize) -> Vec<[u32; 2]> {
    let mut sides = vec![[NONE; 2]; vertex_count];
    let mut first = 0;
    for rim in rims {
        let count = rim.starts.len() - 1;
        for side in 0..count {
            for at in rim.starts[side]..rim.starts[side + 1] {
                sides[rim.vertices[at] as usize][0] = first + side as u32;
            }
            let before = (side + count - 1) % count;
            sides[rim.vertices[rim.starts[side]] as usize][1] = first + before as u32;
        }
        first += count as u32;
    }
    sides
}

/// Lines between points on the sides of triangles with at most one on each: they cut off corners, or lead to the corner across.
fn segments_between(map: &GeneralizedMap, points: &[Vec<u32>]) -> Vec<Segment> {
    let mut segments = Vec::new();
    for face in (0..map.face_count()).map(FaceId::new) {
        let mark =
            |side: HalfedgeId| points[map.edge(side).index()].first().map(|&point| Mark { side, point });
        let sides: Vec<HalfedgeId> = map.sides_of(face).collect();
        let marked: Vec<Mark> = sides.iter().filter_map(|&side| mark(side)).collect();
        let mut join = |from: Mark, to: Mark| segments.push(Segment { ends: [from, to], strand: 0 });
        match marked[..] {
            [only] => {
                let across = map.previous(only.side);
                join(only, Mark { side: across, point: map.source(across).to_u32() });
            }
            [a, b] => join(a, b),
            [a, b, c] => {
                join(a, b);
                join(b, c);
                join(c, a);
            }
            _ => {}
        }
    }
    segments
}

/// Refuses what is no closed surface of negative characteristic.
fn check_hyperbolic(component: &CanonicalComponent) -> Result<(), Error> {
    let surface = component.surface();
    let has_paths = component.curves().iter().any(|curve| curve.kind() == CurveKind::Join);
    if surface.euler_characteristic() >= 0 || has_paths {
        return Err(Error::new(
            ErrorKind::InvalidInput,
            format!("no regular polygon in the hyperbolic plane whose corners make one turn is this surface: {surface}"),
        )
        .with_cure("take the layout polygon"));
    }
    Ok(())
}

/// The point on a side of the regular polygon at a share of its length.
fn place_on_side(plane: PolygonPlane, count: usize, side: usize, share: f64) -> [f64; 2] {
    let half = PI / count as f64;
    // The distance of the side from the center, and where the point is along it.
    let (distance, along) = match plane {
        PolygonPlane::Euclidean => (half.cos(), half.sin() * (2.0 * share - 1.0)),
        PolygonPlane::Klein => {
            let to_side = half.tan().recip();
            let half_side = to_side.acosh();
            ((1.0 - to_side.powi(-2)).sqrt(), ((2.0 * share - 1.0) * half_side).tanh() / to_side)
        }
    };
    let (sin, cos) = ((2 * side + 1) as f64 * half).sin_cos();
    [distance * cos - along * sin, distance * sin + along * cos]
}

/// The places of all vertices when some are fixed, and each other one is the mean of its neighbors by the weights of the springs to them.
fn balanced(mut places: Vec<Option<[f64; 2]>>, springs: &[Spring]) -> Result<Vec<[f64; 2]>, Error> {
    let mut is_used = vec![false; places.len()];
    springs.iter().flat_map(|(ends, _)| ends).for_each(|&end| is_used[end as usize] = true);
    let mut unknowns = vec![None; places.len()];
    let mut count = 0;
    for (vertex, place) in places.iter_mut().enumerate() {
        if place.is_none() && is_used[vertex] {
            unknowns[vertex] = Some(count);
            count += 1;
        } else if place.is_none() {
            *place = Some([0.0; 2]);
        }
    }
    let mut right = [vec![0.0; count], vec![0.0; count]];
    let mut entries = Vec::with_capacity(4 * springs.len());
    for &(ends, weight) in springs {
        for [from, to] in [ends, [ends[1], ends[0]]].map(|ends| ends.map(|end| end as usize)) {
            let Some(row) = unknowns[from] else { continue };
            entries.push((row, row, weight));
            match (unknowns[to], places[to]) {
                (Some(column), _) if column < row => entries.push((row, column, -weight)),
                (None, Some(place)) => {
                    right[0][row] += weight * place[0];
                    right[1][row] += weight * place[1];
                }
                _ => {}
            }
        }
    }
    if count > 0 {
        let factor = CholeskyFactor::new(count, entries, MOST_FILL)?;
        right.iter_mut().for_each(|right| factor.solve(right));
    }
    let solved = |unknown: Option<usize>| unknown.map(|row| [right[0][row], right[1][row]]);
    let places = places.into_iter().zip(unknowns);
    Ok(places.map(|(place, unknown)| place.or(solved(unknown)).unwrap_or_default()).collect())
}
