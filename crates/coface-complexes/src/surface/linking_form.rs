//! Linking numbers of cycles on closed surfaces in space.

use super::GeneralizedMap;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId, Sign, VertexId};
use coface_geometry::predicates::{orientation, spatial_orientation};
use coface_geometry::{AxisBox, BoxTree, Positions};
use rayon::prelude::*;
use std::cmp::Ordering;

/// One term of the linking form of cycles on a closed surface in space: what a step along an edge of the first cycle, and one along an
/// edge of the second, add to the linking number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub struct LinkingTerm {
    /// The edge of the cycle that stays on the surface.
    pub on_surface: EdgeId,
    /// The edge of the cycle that is pushed off to the outside.
    pub outside: EdgeId,
    /// What the two edges add, each run through along its direction.
    pub value: i64,
}

/// The linking form of a closed surface of triangles in space, on cycles of the given edges: for cycles a and b the sum of `value` times
/// the coefficient of `on_surface` in a times that of `outside` in b, over all terms, is the linking number of a with b pushed a little off
/// to the outside. In homology this form decides everything about the embedding: a bounds on the inside of its component if the sum
/// vanishes for all b, and b bounds on the outside if it vanishes for all a.
///
/// Every component has its own inside, as if the others were not there; of cycles on two components the numbers are those of
/// disjoint curves. The surface may not meet itself; where two of the edges do, this is found.
///
/// # Conventions
/// A term is the signed crossings of the second curve with the half-planes above the edges of the first. "Above" is the direction
/// of the last axis, turned by an infinitely small amount, so that no two edges are seen on one line unless they are; all signs are
/// exact. Around a common vertex the second curve follows the link of the vertex, from a face beside its edge to one beside the next.
///
/// # Errors
/// [`ErrorKind::Shape`] for positions that are not three coordinates a vertex; [`ErrorKind::InvalidInput`] naming a face that is no
/// triangle or has no area, a boundary edge, or two edges that meet; [`ErrorKind::NonManifold`] for a component that is not orientable.
///
/// # Complexity
/// Linear in the faces, and $O(m \log m + k)$ for m edges and k pairs of them whose boxes meet when they are seen from above.
///
/// # References
/// D. Rolfsen, *Knots and Links* (1976), sections 5.D and 8.C; T. K. Dey, F. Fan, Y. Wang, *An efficient computation of handle and tunnel
/// loops via Reeb graphs* (2013).
///
/// # Examples
/// The torus with seven vertices: some loops link themselves, pushed off.
/// ```
/// use coface_complexes::shapes;
/// use coface_complexes::surface::{GeneralizedMap, PolygonMesh, linking_terms};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = shapes::csaszar_torus()?;
/// let mesh = PolygonMesh::new(torus.vertex_count(), torus.cells().clone(), &[])?;
/// let map = GeneralizedMap::new(mesh.two_skeleton()?)?;
/// let edges: Vec<_> = (0..map.edge_count()).map(coface_algebra::EdgeId::new).collect();
/// assert!(!linking_terms(&map, torus.positions(), &edges)?.is_empty());
/// # Ok(()) }
/// ```
pub fn linking_terms(
    map: &GeneralizedMap,
    positions: &Positions,
    edges: &[EdgeId],
) -> Result<Vec<LinkingTerm>, Error> {
    let surface = Outward::new(map, positions)?;
    let mut edges: Vec<u32> = edges.iter().map(|edge| edge.to_u32()).collect();
    edges.sort_unstable();
    edges.dedup();
    let mut terms = surface.crossings(&edges)?;
    terms.extend(surface.terms_at_vertices(&edges));
    terms.sort_unstable();
    terms.dedup_by(|later, kept| {
        let is_same = (later.on_surface, later.outside) == (kept.on_surface, kept.outside);
        if is_same {
            kept.value += later.value;
        }
        is_same
    });
    terms.retain(|term| term.value != 0);
    Ok(terms)
}

/// A closed surface of triangles, all turned so that they run counterclockwise when seen from the outside of their component.
struct Outward<'a> {
    map: &'a GeneralizedMap,
    points: Vec<[f64; 3]>,
    /// The corners of each face. Side 3f + i runs from corner i to the next.
    corners: Vec<[u32; 3]>,
    edges: Vec<u32>,
    /// The two sides of each edge, that which runs along it first.
    sides: Vec<[u32; 2]>,
    /// A side that starts at each vertex; none at isolated ones.
    starts: Vec<u32>,
}

const NONE: u32 = u32::MAX;

impl<'a> Outward<'a> {
    fn new(map: &'a GeneralizedMap, positions: &Positions) -> Result<Self, Error> {
        let count = map.skeleton().vertex_count();
        if positions.dimension() != 3 || positions.len() != count {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "{} points with {} coordinates for {count} vertices in space",
                    positions.len(),
                    positions.dimension()
                ),
            ));
        }
        let points = positions.as_flat().as_chunks::<3>().0.to_vec();
        let turned = map.orientation();
        if let Some(edge) = turned.conflicts().iter().flatten().next() {
            return Err(Error::new(
                ErrorKind::NonManifold,
                format!("the faces at edge {edge} cannot be turned to agree: the surface is not orientable"),
            ));
        }
        let mut surface = Self {
            map,
            points,
            corners: Vec::new(),
            edges: Vec::new(),
            sides: Vec::new(),
            starts: Vec::new(),
        };
        let mut signs = turned.signs().to_vec();
        surface.fill(&signs)?;
        let inward = surface.inward_components(&turned);
        if inward.contains(&true) {
            for (face, sign) in signs.iter_mut().enumerate() {
                if inward[turned.component(FaceId::new(face))] {
                    *sign = sign.times(Sign::Minus);
                }
            }
            surface.fill(&signs)?;
        }
        Ok(surface)
    }

    /// Writes down the faces, turned by these signs.
    fn fill(&mut self, signs: &[Sign]) -> Result<(), Error> {
        let map = self.map;
        (self.corners, self.edges) = (Vec::with_capacity(signs.len()), Vec::with_capacity(3 * signs.len()));
        self.sides = vec![[NONE; 2]; map.edge_count()];
        self.starts = vec![NONE; map.skeleton().vertex_count()];
        for (face, &sign) in signs.iter().enumerate() {
            let sides: Vec<HalfedgeId> = map.sides_of(FaceId::new(face)).collect();
            let &[first, second, third] = &sides[..] else {
                return Err(Error::invalid(format!(
                    "face {} has {} sides; linking numbers are those of surfaces of triangles",
                    FaceId::new(face),
                    sides.len()
                )));
            };
            // Turned over, the sides come the other way round.
            let ordered = if sign == Sign::Plus { [first, second, third] } else { [third, second, first] };
            let source = |side| if sign == Sign::Plus { map.source(side) } else { map.target(side) };
            let corners = ordered.map(|side| source(side).to_u32());
            let [a, b, c] = corners.map(|corner| self.points[corner as usize]);
            if turn(a, b, c).is_eq() {
                return Err(Error::invalid(format!("face {} has no area", FaceId::new(face))));
            }
            for (place, side) in (0u32..).zip(ordered) {
                let number = 3 * face as u32 + place;
                let edge = map.edge(side);
                if map.mate(side).is_none() {
                    return Err(Error::invalid(format!("edge {edge} is on the boundary of the surface")));
                }
                self.edges.push(edge.to_u32());
                let is_along = map.skeleton().edge(edge)[0] == source(side);
                self.sides[edge.index()][usize::from(!is_along)] = number;
                self.starts[corners[place as usize] as usize] = number;
            }
            self.corners.push(corners);
        }
        Ok(())
    }

    fn target(&self, side: u32) -> u32 {
        self.corners[side as usize / 3][(side as usize + 1) % 3]
    }

    fn point(&self, vertex: u32) -> [f64; 3] {
        self.points[vertex as usize]
    }

    fn mate(&self, side: u32) -> u32 {
        let [along, against] = self.sides[self.edges[side as usize] as usize];
        if along == side { against } else { along }
    }

    /// The fan of a vertex: the sides that start at it, counterclockwise.
    fn fan(&self, vertex: u32) -> Fan {
        let mut sides = Vec::new();
        let first = self.starts[vertex as usize];
        let mut at = first;
        loop {
            sides.push(at);
            let previous = at / 3 * 3 + (at + 2) % 3;
            at = self.mate(previous);
            if at == first {
                break;
            }
        }
        let around = sides.iter().map(|&side| self.point(self.target(side))).collect();
        Fan { middle: self.point(vertex), sides, around }
    }

    /// Which components have their faces turned to the inside: at the topmost vertex the direction up leads to the outside.
    fn inward_components(&self, turned: &super::FaceOrientation) -> Vec<bool> {
        let mut tops = vec![NONE; turned.conflicts().len()];
        for (face, corners) in self.corners.iter().enumerate() {
            let top = &mut tops[turned.component(FaceId::new(face))];
            for &corner in corners {
                if *top == NONE || height(self.point(corner), self.point(*top)).is_gt() {
                    *top = corner;
                }
            }
        }
        tops.into_iter().map(|top| !self.fan(top).is_outside_above()).collect()
    }

    /// The crossings of edges without a common vertex.
    fn crossings(&self, edges: &[u32]) -> Result<Vec<LinkingTerm>, Error> {
        let ends = |edge: u32| {
            let [a, b] = self.map.skeleton().edge(EdgeId::from_u32(edge)).map(VertexId::to_u32);
            ([a, b], [self.point(a), self.point(b)])
        };
        let boxes: Vec<AxisBox> = edges
            .iter()
            .map(|&edge| {
                let (_, [p, q]) = ends(edge);
                let range = |axis: usize| [p[axis].min(q[axis]), p[axis].max(q[axis])];
                [range(0), range(1), [0.0; 2]]
            })
            .collect();
        if boxes.is_empty() {
            return Ok(Vec::new());
        }
        let tree = BoxTree::new(&boxes);
        let of_group = |group: usize| -> Result<Vec<LinkingTerm>, Error> {
            let mut terms = Vec::new();
            let mut meeting = None;
            tree.pairs_of_group(group, |i, j| {
                let [e, f] = [i, j].map(|i| edges[i as usize]);
                let ((of_e, [p, q]), (of_f, [r, s])) = (ends(e), ends(f));
                if of_e.iter().any(|end| of_f.contains(end)) {
                    return;
                }
                match crossing([p, q], [r, s]) {
                    Crossing::Apart => {}
                    Crossing::Meeting => meeting = Some([e.min(f), e.max(f)]),
                    Crossing::SecondAbove(value) => terms.push(term(e, f, value)),
                    Crossing::FirstAbove(value) => terms.push(term(f, e, value)),
                }
            });
            match meeting {
                None => Ok(terms),
                Some([e, f]) => Err(Error::invalid(format!(
                    "edges {} and {} meet: the surface meets itself",
                    EdgeId::from_u32(e),
                    EdgeId::from_u32(f)
                ))),
            }
        };
        let lists: Vec<_> =
            (0..tree.group_count()).into_par_iter().map(of_group).collect::<Result<_, _>>()?;
        Ok(lists.into_iter().flatten().collect())
    }

    /// What edges with a common vertex add, each with itself too.
    fn terms_at_vertices(&self, edges: &[u32]) -> Vec<LinkingTerm> {
        let mut vertices: Vec<u32> = edges
            .iter()
            .flat_map(|&edge| self.map.skeleton().edge(EdgeId::from_u32(edge)).map(VertexId::to_u32))
            .collect();
        vertices.sort_unstable();
        vertices.dedup();
        let of_vertex = |&vertex: &u32| {
            let fan = self.fan(vertex);
            let count = fan.sides.len();
            let is_asked = |place: usize| edges.binary_search(&self.edges[fan.sides[place] as usize]).is_ok();
            let asked: Vec<usize> = (0..count).filter(|&place| is_asked(place)).collect();
            let mut terms = Vec::new();
            for &first in &asked {
                let passed = fan.passed(first);
                for &second in &asked {
                    let [e, f] = [first, second].map(|place| self.edges[fan.sides[place] as usize]);
                    let is_start = |edge: u32, place: usize| self.sides[edge as usize][0] == fan.sides[place];
                    // The second curve keeps to the face on the left of its edge: left of a side that starts here, or
                    // right of one that ends.
                    let value = match is_start(f, second) {
                        true => passed[second].1,
                        false => -passed[second].0,
                    };
                    terms.push(term(e, f, if is_start(e, first) { value } else { -value }));
                }
            }
            terms
        };
        vertices.par_iter().map(of_vertex).flatten_iter().collect()
    }
}

fn term(on_surface: u32, outside: u32, value: i64) -> LinkingTerm {
    LinkingTerm { on_surface: EdgeId::from_u32(on_surface), outside: EdgeId::from_u32(outside), value }
}

/// A vertex with what is around it.
struct Fan {
    middle: [f64; 3],
    sides: Vec<u32>,
    /// The ends of the sides.
    around: Vec<[f64; 3]>,
}

impl Fan {
    fn next(&self, place: usize) -> usize {
        (place + 1) % self.around.len()
    }

    /// Whether the direction up leads from a side to the outside.
    fn is_up_outside(&self, place: usize) -> bool {
        let before = (place + self.around.len() - 1) % self.around.len();
        let [right, along, left] = [before, place, self.next(place)].map(|place| self.around[place]);
        let is_above_left = turn(self.middle, along, left).is_gt();
        let is_above_right = turn(self.middle, right, along).is_gt();
        match spatial_orientation(self.middle, along, left, right) {
            Ordering::Less => is_above_left || is_above_right,
            Ordering::Greater => is_above_left && is_above_right,
            Ordering::Equal => is_above_left,
        }
    }

    /// The sign with which the corner after `corner` crosses the half-plane above side `side`; zero if it does not.
    fn corner_crossing(&self, corner: usize, side: usize) -> i64 {
        let [a, b] = [corner, self.next(corner)];
        if a == side || b == side {
            return 0;
        }
        let [a, b, u] = [a, b, side].map(|place| self.around[place]);
        let of_side = spatial_orientation(self.middle, a, b, u);
        let of_up = turn(self.middle, a, b);
        let of_a = turn(self.middle, u, a).reverse();
        let of_b = turn(self.middle, u, b).reverse();
        let is_crossing = of_side.is_ne() && of_side == of_up.reverse() && of_b == of_side && of_a == of_up;
        if is_crossing { of_b as i64 } else { 0 }
    }

    /// How often a curve on the outside crosses the half-plane above a side, on its way around the vertex counterclockwise from the first
    /// corner to just before each side, and to just after it. Just before the first side is all around.
    fn passed(&self, side: usize) -> Vec<(i64, i64)> {
        let mut passed = Vec::with_capacity(self.around.len());
        let mut sum = 0;
        for place in 0..self.around.len() {
            let before = sum;
            if place > 0 && place == side && self.is_up_outside(side) {
                // Outside of the half-plane, counterclockwise is against the direction in which crossings count.
                sum -= 1;
            }
            passed.push((before, sum));
            sum += self.corner_crossing(place, side);
        }
        passed[0].0 = sum;
        passed
    }

    /// Whether the direction up leads to the outside.
    fn is_outside_above(&self) -> bool {
        let crossed: i64 = (0..self.around.len()).map(|corner| self.corner_crossing(corner, 0).abs()).sum();
        self.is_up_outside(0) == (crossed % 2 == 0)
    }
}

enum Crossing {
    Apart,
    Meeting,
    /// The second edge runs over the first one, with this sign.
    SecondAbove(i64),
    /// The first edge runs over the second one.
    FirstAbove(i64),
}

/// How two segments without a common end cross when they are seen from above.
fn crossing([p, q]: [[f64; 3]; 2], [r, s]: [[f64; 3]; 2]) -> Crossing {
    let [of_r, of_s] = [turn(p, q, r), turn(p, q, s)];
    let [of_p, of_q] = [turn(r, s, p), turn(r, s, q)];
    if of_r.is_eq() || of_p.is_eq() || of_r != of_s.reverse() || of_p != of_q.reverse() {
        return Crossing::Apart;
    }
    // The sign of the second as it crosses the half-plane above the first.
    let sign = of_s.reverse();
    match spatial_orientation(p, q, r, s) {
        Ordering::Equal => Crossing::Meeting,
        above if above == sign => Crossing::SecondAbove(sign as i64),
        // The first one crosses the half-plane above the second with the other sign.
        _ => Crossing::FirstAbove(of_q.reverse() as i64),
    }
}

/// How three points turn when they are seen from above, the direction up being turned from the last axis by an infinitely small amount towards
/// the first, and a still smaller one towards the second. Zero only for points on one line.
fn turn(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> Ordering {
    let along = |i: usize, j: usize| orientation([a[i], a[j]], [b[i], b[j]], [c[i], c[j]]);
    along(0, 1).then_with(|| along(1, 2)).then_with(|| along(2, 0))
}

/// Which of two points is higher.
fn height(a: [f64; 3], b: [f64; 3]) -> Ordering {
    let compare = |axis: usize| a[axis].partial_cmp(&b[axis]).expect("coordinates are numbers");
    compare(2).then_with(|| compare(0)).then_with(|| compare(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::samples::{cubes, drilled_cube, trefoil, tube};
    use coface_algebra::chains::TwoSkeleton;
    use proptest::prelude::*;

    type Cycle = Vec<u32>;

    /// The cycles of a breadth-first tree, as steps.
    fn cycles(skeleton: &TwoSkeleton) -> Vec<Cycle> {
        let ends = skeleton.edge_ends();
        let mut step_to: Vec<Option<u32>> = vec![None; skeleton.vertex_count()];
        let mut seen = vec![false; skeleton.vertex_count()];
        let mut queue = vec![0u32];
        seen[0] = true;
        let mut at = 0;
        while at < queue.len() {
            for step in 0..ends.len() as u32 {
                let next = ends[(step ^ 1) as usize];
                if ends[step as usize] == queue[at] && !std::mem::replace(&mut seen[next as usize], true) {
                    step_to[next as usize] = Some(step);
                    queue.push(next);
                }
            }
            at += 1;
        }
        let way = |mut vertex: u32| {
            let mut way = Vec::new();
            while let Some(step) = step_to[vertex as usize] {
                way.push(step);
                vertex = ends[step as usize];
            }
            way.reverse();
            way
        };
        let closed = |edge: u32| {
            let mut steps = way(ends[2 * edge as usize]);
            steps.push(2 * edge);
            steps.extend(way(ends[2 * edge as usize + 1]).into_iter().rev().map(|step| step ^ 1));
            steps
        };
        (0..skeleton.edge_count() as u32).map(closed).collect()
    }

    fn value(terms: &[LinkingTerm], map: &GeneralizedMap, a: &Cycle, b: &Cycle) -> i64 {
        let coefficients = |cycle: &Cycle| {
            let mut list = vec![0i64; map.edge_count()];
            cycle.iter().for_each(|&step| list[(step >> 1) as usize] += if step & 1 == 0 { 1 } else { -1 });
            list
        };
        let (a, b) = (coefficients(a), coefficients(b));
        terms.iter().map(|term| a[term.on_surface.index()] * term.value * b[term.outside.index()]).sum()
    }

    /// The linking number of a with b moved along the normals, by the crossings that are seen from some direction, in floating point.
    fn seen(map: &GeneralizedMap, positions: &Positions, outward: f64, a: &Cycle, b: &Cycle) -> f64 {
        let points = positions.as_flat().as_chunks::<3>().0;
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
        };
        let minus = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] - b[i]);
        let mut normals = vec![[0.0; 3]; points.len()];
        for face in 0..map.face_count() {
            let corners: Vec<usize> =
                map.sides_of(FaceId::new(face)).map(|side| map.source(side).index()).collect();
            let normal = cross(
                minus(points[corners[1]], points[corners[0]]),
                minus(points[corners[2]], points[corners[0]]),
            );
            for corner in corners {
                (0..3).for_each(|axis| normals[corner][axis] += outward * normal[axis]);
            }
        }
        // Seen from a direction without relations to the axes.
        let view = |p: [f64; 3]| {
            let [x, y, z] = p;
            [
                x + 0.237_1 * y - 0.171_7 * z,
                0.941_3 * y + 0.313_9 * z - 0.113 * x,
                z + 0.419_7 * x - 0.271_9 * y,
            ]
        };
        let moved = |vertex: usize, by: f64| {
            let length = normals[vertex].iter().map(|x| x * x).sum::<f64>().sqrt();
            view([0, 1, 2].map(|axis| points[vertex][axis] + by * normals[vertex][axis] / length))
        };
        let segments = |cycle: &Cycle, by: f64| -> Vec<[[f64; 3]; 2]> {
            let end = |step: u32| moved(map.skeleton().edge_ends()[step as usize] as usize, by);
            cycle.iter().map(|&step| [end(step), end(step ^ 1)]).collect()
        };
        let turn = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        };
        let mut sum = 0.0;
        for [p, q] in segments(a, 0.0) {
            for [r, s] in segments(b, 1e-3) {
                let [of_r, of_s, of_p, of_q] = [turn(p, q, r), turn(p, q, s), turn(r, s, p), turn(r, s, q)];
                if of_r * of_s < 0.0 && of_p * of_q < 0.0 {
                    let (i, j) = (of_p / (of_p - of_q), of_r / (of_r - of_s));
                    let above = (r[2] + j * (s[2] - r[2])) - (p[2] + i * (q[2] - p[2]));
                    sum += above.signum() * of_r.signum() / 2.0;
                }
            }
        }
        sum
    }

    fn check(map: &GeneralizedMap, positions: &Positions, outward: f64, chosen: &[usize]) {
        let edges: Vec<EdgeId> = (0..map.edge_count()).map(EdgeId::new).collect();
        let terms = linking_terms(map, positions, &edges).unwrap();
        let cycles = cycles(map.skeleton());
        for pair in chosen.chunks_exact(2) {
            let [a, b] = [pair[0], pair[1]].map(|i| &cycles[i % cycles.len()]);
            let expected = seen(map, positions, outward, a, b);
            assert!((value(&terms, map, a, b) as f64 - expected).abs() < 1e-6, "{a:?} {b:?}: {expected}");
            // Only the edges of the cycles matter.
            let own: Vec<EdgeId> = a.iter().chain(b).map(|&step| EdgeId::from_u32(step >> 1)).collect();
            let own = linking_terms(map, positions, &own).unwrap();
            assert_eq!(value(&own, map, a, b), value(&terms, map, a, b));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]

        #[test]
        fn linking_numbers_of_tubes_are_those_that_are_seen(
            chosen in prop::collection::vec(any::<usize>(), 24), twist in 1u32..4,
        ) {
            let (map, positions) = tube(trefoil, [40 * twist, 7], 0.3);
            // The triangles of tubes are turned inside.
            check(&map, &positions, -1.0, &chosen);
            let (map, positions) = tube(|t| [3.0 * t.cos(), 3.0 * t.sin(), 0.0], [9 * twist, 5], 1.0);
            check(&map, &positions, -1.0, &chosen);
        }

        #[test]
        fn linking_numbers_of_cubes_are_those_that_are_seen(
            chosen in prop::collection::vec(any::<usize>(), 24), tunnels in 0u32..4096, turned in any::<u64>(),
        ) {
            let (map, positions) = cubes(&drilled_cube(tunnels), turned);
            check(&map, &positions, 1.0, &chosen);
        }
    }

    #[test]
    fn surfaces_without_an_inside_are_refused() {
        let strip = GeneralizedMap::new(
            super::super::PolygonMesh::new(3, coface_algebra::RaggedArray::from_lists([[0, 1, 2]]), &[])
                .unwrap()
                .two_skeleton()
                .unwrap(),
        )
        .unwrap();
        let triangle = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.]).unwrap();
        let error = linking_terms(&strip, &triangle, &[EdgeId::new(0)]).unwrap_err();
        assert!(error.message().contains("on the boundary"), "{}", error.message());
        let flat = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 1.]).unwrap();
        assert_eq!(linking_terms(&strip, &flat, &[]).unwrap_err().kind(), ErrorKind::Shape);
        let line = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 2., 0., 0.]).unwrap();
        assert!(linking_terms(&strip, &line, &[]).unwrap_err().message().contains("no area"));
    }
}
