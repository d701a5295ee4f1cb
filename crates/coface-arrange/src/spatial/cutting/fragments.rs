//! What the cuts and runs inside one sheet make of it: fragments, polygons with holes and slits.

use super::lines::{Chain, Lines, OnLines};
use super::meetings::Meetings;
use crate::spatial::axis_view::PlaneView;
use coface_algebra::{RaggedArray, UnionFind};
use coface_geometry::predicates::{SpatialLine, direction_side, direction_turn, normals_turn};
use coface_geometry::{AxisBox, BoxTree};
use rayon::prelude::*;
use std::cmp::Ordering;

const NONE: u32 = u32::MAX;

/// The sides of each fragment of a sheet, and pairs of a fragment and a vertex inside of it that no side ends at.
pub(super) type Fragments = (Vec<Vec<u32>>, Vec<[u32; 2]>);

/// All that fragments are made from.
pub(super) struct Fragmenting<'a> {
    pub(super) on: OnLines<'a>,
    pub(super) lines: &'a Lines,
    pub(super) meetings: &'a Meetings,
    /// The cuts of each sheet.
    cuts_of: RaggedArray,
    /// The runs in each sheet.
    runs_of: RaggedArray,
}

/// What the direction of a part is known by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Support {
    /// An edge of a sheet, from its lower to its higher end.
    Edge(u32),
    /// The line where the sheet meets another one: the product of the normals, of the sheet itself first.
    Sheet {
        other: u32,
        /// How parts of it, in their own direction, agree with the product.
        sense: Ordering,
    },
}

/// An edge of the result in a sheet. Halfedge 2i goes along part i, halfedge 2i + 1 back.
#[derive(Clone, Copy, Debug)]
struct Part {
    edge: u32,
    ends: [u32; 2],
    support: Support,
}

impl<'a> Fragmenting<'a> {
    pub(super) fn new(on: OnLines<'a>, lines: &'a Lines, meetings: &'a Meetings) -> Self {
        let count = on.sheets.count();
        let cuts = meetings.cuts.iter().flat_map(|cut| cut.sheets);
        let mut cuts_of = RaggedArray::grouped(count, cuts);
        cuts_of.items_mut().iter_mut().for_each(|item| *item /= 2);
        let runs_of = RaggedArray::grouped(count, meetings.runs.iter().map(|run| run.sheet));
        Self { on, lines, meetings, cuts_of, runs_of }
    }

    /// The corners of other sheets inside a sheet.
    pub(super) fn points_of(&self, sheet: u32) -> impl Iterator<Item = u32> + '_ {
        let all = &self.meetings.vertices_in_sheets;
        let start = all.partition_point(|point| point[0] < sheet);
        all[start..].iter().take_while(move |point| point[0] == sheet).map(|point| point[1])
    }

    /// Whether the sheet is a fragment as it is.
    pub(super) fn is_whole(&self, sheet: u32) -> bool {
        self.is_undivided(sheet)
            && !self.on.sheets.edges_of[sheet as usize].iter().any(|&edge| self.lines.is_split(edge))
    }

    /// The sides of a sheet that is a fragment as it is.
    pub(super) fn whole(&self, sheet: u32) -> [u32; 3] {
        let corners = self.on.sheets.corners[sheet as usize];
        [0, 1, 2].map(|i| {
            let edge =
                self.lines.along_edge(self.on.sheets, self.on.sheets.edges_of[sheet as usize][i]).edges[0];
            edge << 1 | u32::from(corners[i] > corners[(i + 1) % 3])
        })
    }

    fn is_undivided(&self, sheet: u32) -> bool {
        self.cuts_of.list(sheet as usize).is_empty() && self.runs_of.list(sheet as usize).is_empty()
    }

    /// The sides of each fragment of a sheet as `2 * edge + against`, walk after walk, the outer one first.
    pub(super) fn fragments(&self, sheet: u32) -> Fragments {
        let (mut parts, mut boundary) = (Vec::new(), Vec::new());
        self.add_boundary(sheet, &mut parts, &mut boundary);
        if self.is_undivided(sheet) {
            return (vec![boundary], self.points_of(sheet).map(|vertex| [0, vertex]).collect());
        }
        let mut add = |chain: Chain<'_>, support: Support| {
            for (pair, &edge) in chain.vertices.windows(2).zip(chain.edges) {
                parts.push(Part { edge, ends: [pair[0], pair[1]], support });
            }
        };
        for &run in self.runs_of.list(sheet as usize) {
            let run = &self.meetings.runs[run as usize];
            add(self.lines.along_run(&self.on, run.edge, run.ends), Support::Edge(run.edge));
        }
        for &cut in self.cuts_of.list(sheet as usize) {
            let [f, g] = self.meetings.cuts[cut as usize].sheets;
            let sense = self.lines.senses[cut as usize];
            let support = if f == sheet {
                Support::Sheet { other: g, sense }
            } else {
                Support::Sheet { other: f, sense: sense.reverse() }
            };
            add(self.lines.along_cut(cut as usize), support);
        }
        // Pieces that lie on each other are one, on an edge if there is one.
        parts.sort_unstable_by_key(|part| (part.edge, part.support));
        parts.dedup_by_key(|part| part.edge);
        Graph::new(self, sheet, &parts).fragments(boundary[0])
    }

    /// Adds the parts of the boundary, and its sides in their order.
    fn add_boundary(&self, sheet: u32, parts: &mut Vec<Part>, sides: &mut Vec<u32>) {
        let corners = self.on.sheets.corners[sheet as usize];
        for (i, &edge) in self.on.sheets.edges_of[sheet as usize].iter().enumerate() {
            let Chain { vertices, edges } = self.lines.along_edge(self.on.sheets, edge);
            let mut add = |k: usize, turned: bool| {
                let part = Part {
                    edge: edges[k],
                    ends: [vertices[k], vertices[k + 1]],
                    support: Support::Edge(edge),
                };
                sides.push(part.side(turned));
                parts.push(part);
            };
            if corners[i] < corners[(i + 1) % 3] {
                (0..edges.len()).for_each(|k| add(k, false));
            } else {
                (0..edges.len()).rev().for_each(|k| add(k, true));
            }
        }
    }
}

impl Part {
    /// The part as a side, against its direction if it is turned.
    fn side(self, turned: bool) -> u32 {
        let [from, to] = self.ends;
        self.edge << 1 | u32::from((from > to) != turned)
    }
}

/// The parts in a sheet as a graph in its plane.
struct Graph<'a, 'b> {
    all: &'a Fragmenting<'b>,
    sheet: u32,
    view: PlaneView,
    parts: &'a [Part],
    /// The vertices of the graph, rising.
    vertices: Vec<u32>,
    /// The halfedges that leave each of them, counterclockwise seen from the front.
    rotation: RaggedArray,
    /// The halfedges around the face on the left of each.
    orbits: Vec<Vec<u32>>,
    orbit_of: Vec<u32>,
}

impl<'a, 'b> Graph<'a, 'b> {
    fn new(all: &'a Fragmenting<'b>, sheet: u32, parts: &'a [Part]) -> Self {
        let mut vertices: Vec<u32> = parts.iter().flat_map(|part| part.ends).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let local = |vertex: u32| vertices.binary_search(&vertex).expect("it is there") as u32;
        let tails: Vec<u32> = parts.iter().flat_map(|part| part.ends.map(local)).collect();
        let rotation = RaggedArray::grouped(vertices.len(), tails.iter().copied());
        let view = all.on.sheets.views[sheet as usize];
        let mut graph =
            Self { all, sheet, view, parts, vertices, rotation, orbits: Vec::new(), orbit_of: Vec::new() };
        let mut rotation = std::mem::take(&mut graph.rotation);
        let starts: Vec<usize> = (0..=graph.vertices.len()).map(|vertex| rotation.start(vertex)).collect();
        for own in starts.windows(2) {
            graph.sort_around(&mut rotation.items_mut()[own[0]..own[1]]);
        }
        let mut next = vec![NONE; tails.len()];
        for leaving in rotation.iter() {
            // Arriving opposite to a halfedge, a face on the left goes on clockwise.
            for (i, &halfedge) in leaving.iter().enumerate() {
                next[(halfedge ^ 1) as usize] = leaving[(i + leaving.len() - 1) % leaving.len()];
            }
        }
        graph.rotation = rotation;
        graph.orbit_of = vec![NONE; next.len()];
        for first in 0..next.len() as u32 {
            let mut orbit = Vec::new();
            let mut at = first;
            while graph.orbit_of[at as usize] == NONE {
                graph.orbit_of[at as usize] = graph.orbits.len() as u32;
                orbit.push(at);
                at = next[at as usize];
            }
            if !orbit.is_empty() {
                graph.orbits.push(orbit);
            }
        }
        graph
    }

    /// How the direction of a halfedge turns into that of another, seen from the front.
    fn turn(&self, a: u32, b: u32) -> Ordering {
        use Support::{Edge, Sheet};
        let sheets = self.all.on.sheets;
        let [x, y] = [a, b].map(|halfedge| self.parts[halfedge as usize / 2].support);
        let signed = |turn: Ordering, sense: Ordering| if sense.is_gt() { turn } else { turn.reverse() };
        let turn = match (x, y) {
            (Edge(d), Edge(e)) if d == e => Ordering::Equal,
            (Edge(d), Edge(e)) => {
                let [d, e] = [d, e].map(|edge| sheets.line(edge).map(|end| self.view.seen(end)));
                self.view.seen_from_front(direction_turn(d, e))
            }
            // With n for normals and u for the edge: (n x n') x u = -n (n' u), as u is at right angles to n.
            (Sheet { other, sense }, Edge(e)) => {
                signed(direction_side(sheets.line(e), sheets.plane(other)).reverse(), sense)
            }
            (Edge(e), Sheet { other, sense }) => {
                signed(direction_side(sheets.line(e), sheets.plane(other)), sense)
            }
            (Sheet { other: g, .. }, Sheet { other: h, .. }) if g == h => Ordering::Equal,
            // (n x n') x (n x n'') = n det(n, n', n'').
            (Sheet { other: g, sense: s }, Sheet { other: h, sense: t }) => {
                let [f, g, h] = [self.sheet, g, h].map(|sheet| sheets.plane(sheet));
                signed(signed(normals_turn(f, g, h), s), t)
            }
        };
        if (a ^ b) & 1 == 0 { turn } else { turn.reverse() }
    }

    /// Sorts the halfedges that leave a vertex counterclockwise, from the first of them on. No two have the same
    /// direction.
    fn sort_around(&self, leaving: &mut [u32]) {
        if leaving.len() < 3 {
            return;
        }
        let first = leaving[0];
        let mut rest: Vec<(u8, u32)> = leaving[1..]
            .iter()
            .map(|&other| match self.turn(first, other) {
                Ordering::Greater => (1, other),
                Ordering::Equal => (2, other),
                Ordering::Less => (3, other),
            })
            .collect();
        rest.sort_by(|&(p, a), &(q, b)| p.cmp(&q).then_with(|| self.turn(a, b).reverse()));
        for (place, (_, halfedge)) in leaving[1..].iter_mut().zip(rest) {
            *place = halfedge;
        }
    }

    fn side(&self, halfedge: u32) -> u32 {
        self.parts[halfedge as usize / 2].side(halfedge & 1 == 1)
    }

    /// The sides of each face inside the boundary, which has this side.
    fn fragments(&self, boundary_side: u32) -> Fragments {
        let boundary = self
            .parts
            .binary_search_by_key(&(boundary_side >> 1), |part| part.edge)
            .expect("the boundary is part of the graph") as u32;
        let outward = 2 * boundary + u32::from(self.side(2 * boundary) == boundary_side);
        let outside = self.orbit_of[outward as usize];
        let islands = Islands::new(self, boundary);
        let mut fragment_of = vec![NONE; self.orbits.len()];
        let mut fragments: Vec<Vec<u32>> = Vec::new();
        let sides = |orbit: u32| self.orbits[orbit as usize].iter().map(|&halfedge| self.side(halfedge));
        for orbit in 0..self.orbits.len() as u32 {
            if orbit != outside && !islands.is_outer[orbit as usize] {
                fragment_of[orbit as usize] = fragments.len() as u32;
                fragments.push(sides(orbit).collect());
            }
        }
        for (island, &outer) in islands.outer.iter().enumerate() {
            let around = fragment_of[islands.parent(self, island) as usize];
            fragments[around as usize].extend(sides(outer));
        }
        let mut lone =
            self.all.points_of(self.sheet).filter(|v| self.vertices.binary_search(v).is_err()).peekable();
        let mut points = Vec::new();
        if lone.peek().is_some() {
            let rays = Rays::new(self, &islands.of_vertex, 1);
            for vertex in lone {
                let own = rays.around(vertex, LONE, &islands.is_outer);
                points.push([fragment_of[islands.deepest(self, &own) as usize], vertex]);
            }
        }
        (fragments, points)
    }
}

/// The components of the graph of a sheet that do not reach its boundary.
struct Islands {
    /// The island of each vertex of the graph; none on the component of the boundary.
    of_vertex: Vec<u32>,
    /// The orbit of each island that sees what is around it, rising.
    outer: Vec<u32>,
    /// For each orbit whether it is the outer one of an island.
    is_outer: Vec<bool>,
    /// For each island the orbits, none of them outer, of other components that it lies within.
    around: Vec<Vec<u32>>,
}

impl Islands {
    fn new(graph: &Graph<'_, '_>, boundary: u32) -> Self {
        let on = &graph.all.on;
        let local = |vertex: u32| graph.vertices.binary_search(&vertex).expect("it is there");
        let mut joined = UnionFind::new(graph.vertices.len());
        for part in graph.parts {
            let [a, b] = part.ends.map(local);
            joined.unite(a as u32, b as u32);
        }
        let component_of = joined.class_numbers();
        let main = component_of[local(graph.parts[boundary as usize].ends[0])];
        let count = joined.class_count() - 1;
        let of_vertex: Vec<u32> = component_of
            .into_iter()
            .map(|component| match component.cmp(&main) {
                Ordering::Less => component,
                Ordering::Equal => NONE,
                Ordering::Greater => component - 1,
            })
            .collect();
        let mut is_outer = vec![false; graph.orbits.len()];
        if count == 0 {
            return Self { of_vertex, outer: Vec::new(), is_outer, around: Vec::new() };
        }
        let [right, up] = graph.view.other_axes();
        let mut lowest = vec![NONE; count];
        for (vertex, &island) in of_vertex.iter().enumerate().filter(|&(_, &island)| island != NONE) {
            let known = &mut lowest[island as usize];
            let is_lower = |known: u32| {
                let [a, b] = [vertex, known as usize].map(|vertex| graph.vertices[vertex]);
                on.compare_coordinate(right, a, b).then_with(|| on.compare_coordinate(up, a, b)).is_lt()
            };
            if *known == NONE || is_lower(*known) {
                *known = vertex as u32;
            }
        }
        // All that leaves the lowest vertex goes right or straight up: the last of it has the outside on its left.
        let last = |&vertex: &u32| {
            let leaving = graph.rotation.list(vertex as usize);
            let is_last = |i: &usize| {
                leaving.len() == 1 || !graph.turn(leaving[*i], leaving[(i + 1) % leaving.len()]).is_gt()
            };
            let last = (0..leaving.len()).find(is_last).expect("less than a half turn is used");
            graph.orbit_of[leaving[last] as usize]
        };
        let outer: Vec<u32> = lowest.iter().map(last).collect();
        outer.iter().for_each(|&orbit| is_outer[orbit as usize] = true);
        let rays = Rays::new(graph, &of_vertex, count);
        let around = lowest
            .par_iter()
            .with_min_len(64)
            .map(|&vertex| {
                rays.around(graph.vertices[vertex as usize], of_vertex[vertex as usize], &is_outer)
            })
            .collect();
        Self { of_vertex, outer, is_outer, around }
    }

    /// The orbit that an island lies directly within.
    fn parent(&self, graph: &Graph<'_, '_>, island: usize) -> u32 {
        self.deepest(graph, &self.around[island])
    }

    /// Of the orbits around a point, all of them, the one that lies within the others.
    fn deepest(&self, graph: &Graph<'_, '_>, own: &[u32]) -> u32 {
        let depth = |orbit: u32| {
            let tail = graph.parts[graph.orbits[orbit as usize][0] as usize / 2].ends[0];
            let at = graph.vertices.binary_search(&tail).expect("it is there");
            match self.of_vertex[at] {
                NONE => 0,
                around => self.around[around as usize].len(),
            }
        };
        *own.iter().find(|&&orbit| depth(orbit) + 1 == own.len()).expect("islands are inside the sheet")
    }
}

/// The component of a vertex on its own.
const LONE: u32 = NONE - 1;

/// Graphs with as many islands and parts are searched part by part.
const FEW: usize = 1 << 10;

/// Rays down in the plane of a sheet, turned so little that they pass on the left of the vertices below.
struct Rays<'a> {
    graph: &'a Graph<'a, 'a>,
    of_vertex: &'a [u32],
    /// The boxes around the parts, if there are many.
    tree: Option<BoxTree>,
}

impl<'a> Rays<'a> {
    fn new(graph: &'a Graph<'a, '_>, of_vertex: &'a [u32], islands: usize) -> Self {
        let on = &graph.all.on;
        let [right, up] = graph.view.other_axes();
        let box_of = |part: &Part| -> AxisBox {
            let [a, b] = part.ends.map(|end| on.rounded(end));
            let ends = |axis: usize| [a[axis].min(b[axis]), a[axis].max(b[axis])];
            [ends(right), ends(up), [0.0; 2]]
        };
        let tree = (islands * graph.parts.len() > FEW)
            .then(|| BoxTree::new(&graph.parts.iter().map(box_of).collect::<Vec<_>>()));
        Self { graph, of_vertex, tree }
    }

    /// The orbits of other components than its own, but for their outer ones, that wind around a vertex, rising.
    ///
    /// Each part that the ray crosses counts for the orbits on its sides: inside an orbit that runs counterclockwise,
    /// it leaves through one part more that runs to the right than through parts that run to the left.
    fn around(&self, vertex: u32, component: u32, is_outer: &[bool]) -> Vec<u32> {
        let graph = self.graph;
        let mut terms: Vec<(u32, i32)> = Vec::new();
        let mut visit = |part: u32| {
            let halfedges = [2 * part, 2 * part + 1];
            if let Some(rightward) = self.crossing(part, vertex, component) {
                for halfedge in halfedges {
                    let sign = if (halfedge & 1 == 0) == rightward { 1 } else { -1 };
                    terms.push((graph.orbit_of[halfedge as usize], sign));
                }
            }
        };
        match &self.tree {
            None => (0..graph.parts.len() as u32).for_each(visit),
            Some(tree) => {
                let [right, up] = graph.view.other_axes();
                let place = graph.all.on.rounded(vertex);
                let below = [[place[right]; 2], [f64::NEG_INFINITY, place[up]], [0.0; 2]];
                tree.visit(&below, &mut visit);
            }
        }
        terms.sort_unstable();
        // Seen from the far end of the axis, orbits run the other way where the front is on the other side.
        let inside = if graph.view.front.is_gt() { 1 } else { -1 };
        terms
            .chunk_by(|a, b| a.0 == b.0)
            .filter(|own| {
                own.iter().map(|term| term.1).sum::<i32>() == inside && !is_outer[own[0].0 as usize]
            })
            .map(|own| own[0].0)
            .collect()
    }

    /// Whether the ray from a vertex meets a part of another component, and then whether the part runs to the right
    /// there.
    fn crossing(&self, part: u32, from: u32, component: u32) -> Option<bool> {
        let graph = self.graph;
        let on = &graph.all.on;
        let own = &graph.parts[part as usize];
        let at = graph.vertices.binary_search(&own.ends[0]).expect("it is there");
        if self.of_vertex[at] == component {
            return None;
        }
        let [right, _] = graph.view.other_axes();
        let [a, b] = own.ends.map(|end| on.compare_coordinate(right, end, from).is_ge());
        if a == b {
            return None;
        }
        let rightward = b;
        // On the left of a part that runs to the right is above it.
        let left = self.side(own, from);
        debug_assert!(left.is_ne(), "components have no point in common");
        ((left.is_gt()) == rightward).then_some(rightward)
    }

    /// On which side of a part a vertex is, seen from the far end of the axis: `Greater` for left.
    fn side(&self, part: &Part, vertex: u32) -> Ordering {
        let graph = self.graph;
        let on = &graph.all.on;
        let point = on.vertices.point(on.sheets, vertex);
        match part.support {
            Support::Edge(edge) => {
                let line: SpatialLine = on.sheets.line(edge);
                let axis = usize::from(graph.view.axis);
                // A plane through the line and the axis. Its normal is to the left when the third point is below.
                let mut off = line[0];
                off[axis] = if off[axis] == 0.0 { 1.0 } else { 0.0 };
                let side = point.side_of([line[0], line[1], off]);
                if off[axis] > line[0][axis] { side.reverse() } else { side }
            }
            Support::Sheet { other, sense } => {
                // The product of the normals has what is behind the other sheet on its left.
                let left = point.side_of(on.sheets.plane(other)).reverse();
                graph.view.seen_from_front(if sense.is_gt() { left } else { left.reverse() })
            }
        }
    }
}
