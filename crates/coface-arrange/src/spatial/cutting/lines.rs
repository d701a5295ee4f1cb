//! Edges and cuts with the vertices along them, and the pieces that these make of them.

use super::meetings::{Cut, Meetings, Place};
use super::sheets::Sheets;
use super::vertices::Vertices;
use coface_algebra::RaggedArray;
use coface_geometry::predicates::{SpatialPlane, normals_turn};
use rayon::prelude::*;
use std::cmp::Ordering;

const NONE: u32 = u32::MAX;

/// The edges of the sheets and the cuts between them, cut into pieces: the edges of the result.
#[derive(Clone, Debug)]
pub(super) struct Lines {
    /// The ends of each edge of the result, the lower first; they rise.
    pub(super) ends: Vec<[u32; 2]>,
    /// The line of each edge of a sheet that has vertices inside it.
    line_of_edge: Vec<u32>,
    /// The edge of the result that an edge of a sheet without vertices inside it is.
    whole: Vec<u32>,
    /// The edges that are lines; lines after these are cuts.
    split_edges: Vec<u32>,
    /// The vertices along each line: along edges from the lower end on, along cuts with the coordinate of an axis.
    chains: RaggedArray,
    /// The edges of the result between these vertices.
    pieces: RaggedArray,
    /// For each cut how the order of its vertices agrees with the product of the normals of its lower and higher sheet.
    pub(super) senses: Vec<Ordering>,
}

/// What the direction of an edge of the result is known by.
#[derive(Clone, Copy, Debug)]
pub(super) enum Support {
    /// Two corners of sheets on its line, in its direction.
    Corners([u32; 2]),
    /// Two sheets whose normals, multiplied in this order, have its direction.
    Sheets([u32; 2]),
}

/// An axis that a line rises or falls along.
#[derive(Clone, Copy, Debug)]
struct Slope {
    axis: u8,
    direction: Ordering,
}

/// The vertices and edges along a line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chain<'a> {
    pub(super) vertices: &'a [u32],
    pub(super) edges: &'a [u32],
}

/// The vertices of places and the order of vertices on lines.
pub(super) struct OnLines<'a> {
    pub(super) sheets: &'a Sheets,
    pub(super) vertices: &'a Vertices,
    /// All places, rising, and their vertices.
    pub(super) places: &'a [Place],
    pub(super) vertex_of_place: &'a [u32],
}

impl OnLines<'_> {
    pub(super) fn vertex(&self, place: Place) -> u32 {
        match place {
            Place::Corner(vertex) => vertex,
            _ => self.vertex_of_place[self.places.binary_search(&place).expect("a place that was found")],
        }
    }

    pub(super) fn rounded(&self, vertex: u32) -> [f64; 3] {
        self.vertices.rounded(self.sheets, vertex)
    }

    /// The order of one coordinate of two vertices. Rounding is monotone, so that only equal coordinates need the exact
    /// points.
    pub(super) fn compare_coordinate(&self, axis: usize, a: u32, b: u32) -> Ordering {
        let order =
            self.rounded(a)[axis].partial_cmp(&self.rounded(b)[axis]).expect("coordinates are numbers");
        if order.is_ne() || (a as usize) < self.vertices.given && (b as usize) < self.vertices.given {
            return order;
        }
        let [a, b] = [a, b].map(|vertex| self.vertices.point(self.sheets, vertex));
        a.compare_coordinate(&b, axis)
    }

    /// The order of vertices along a line.
    fn compare(&self, slope: Slope, a: u32, b: u32) -> Ordering {
        if a == b {
            return Ordering::Equal;
        }
        let order = self.compare_coordinate(usize::from(slope.axis), a, b);
        if slope.direction.is_gt() { order } else { order.reverse() }
    }

    /// The axis along which the way between two vertices is longest, up to rounding.
    fn slope(&self, a: u32, b: u32) -> Slope {
        let [from, to] = [a, b].map(|vertex| self.rounded(vertex));
        let length = |axis: usize| (to[axis] / 2.0 - from[axis] / 2.0).abs();
        let axis = (1..3).fold(0, |best, axis| if length(axis) > length(best) { axis } else { best });
        let order = to[axis].partial_cmp(&from[axis]).expect("coordinates are numbers");
        if order.is_ne() {
            return Slope { axis: axis as u8, direction: order };
        }
        let [from, to] = [a, b].map(|vertex| self.vertices.point(self.sheets, vertex));
        (0..3)
            .map(|axis| Slope { axis: axis as u8, direction: to.compare_coordinate(&from, axis) })
            .find(|slope| slope.direction.is_ne())
            .expect("the ends of a line are different points")
    }
}

impl Lines {
    pub(super) fn new(on: &OnLines<'_>, meetings: &Meetings) -> Self {
        let (sheets, cuts) = (on.sheets, &meetings.cuts);
        // (edge, vertex) for vertices inside edges.
        let mut inside: Vec<[u32; 2]> = meetings.vertices_on_edges.clone();
        // (vertex, sheet) for vertices inside sheets.
        let mut in_sheets: Vec<[u32; 2]> =
            meetings.vertices_in_sheets.iter().map(|&[sheet, vertex]| [vertex, sheet]).collect();
        for (place, &vertex) in on.places.iter().zip(on.vertex_of_place) {
            match *place {
                Place::Corner(_) => {}
                Place::Edges(edges) => inside.extend(edges.map(|edge| [edge, vertex])),
                Place::EdgeAndSheet([edge, sheet]) => {
                    inside.push([edge, vertex]);
                    in_sheets.push([vertex, sheet]);
                }
                Place::Sheets(three) => in_sheets.extend(three.map(|sheet| [vertex, sheet])),
            }
        }
        inside.par_sort_unstable();
        inside.dedup();
        let mut line_of_edge = vec![NONE; sheets.edges.len()];
        let mut split_edges = Vec::new();
        let mut own: Vec<Vec<u32>> = Vec::new();
        for vertices in inside.chunk_by(|a, b| a[0] == b[0]) {
            let edge = vertices[0][0];
            line_of_edge[edge as usize] = split_edges.len() as u32;
            split_edges.push(edge);
            let [a, b] = sheets.edges[edge as usize];
            let mut chain = vec![a, b];
            chain.extend(
                vertices.iter().map(|&[_, vertex]| vertex).filter(|&vertex| vertex != a && vertex != b),
            );
            own.push(chain);
        }
        drop(inside);
        let sort = |chain: &mut Vec<u32>| {
            let slope = on.slope(chain[0], chain[1]);
            if chain.len() > 2 {
                chain.sort_unstable_by(|&a, &b| on.compare(slope, a, b));
            }
            slope
        };
        own.par_iter_mut().for_each(|chain| {
            sort(chain);
        });
        // Vertices inside a sheet on edges that run in its plane.
        let within: Vec<Vec<[u32; 2]>> = meetings
            .runs
            .par_iter()
            .map(|run| {
                let line = line_of_edge[run.edge as usize];
                if line == NONE {
                    return Vec::new();
                }
                let part = part(on, &own[line as usize], sheets.edges[run.edge as usize], run.ends);
                let chain = &own[line as usize][part[0]..=part[1]];
                chain[1..chain.len() - 1].iter().map(|&vertex| [vertex, run.sheet]).collect()
            })
            .collect();
        in_sheets.extend(within.into_iter().flatten());
        in_sheets.par_sort_unstable();
        in_sheets.dedup();
        // (cut, vertex): a vertex inside two sheets is inside their cut.
        let mut on_cuts: Vec<[u32; 2]> = Vec::new();
        for at in in_sheets.chunk_by(|a, b| a[0] == b[0]).filter(|at| at.len() > 1) {
            for (i, &[vertex, g]) in at.iter().enumerate() {
                for &[_, f] in &at[..i] {
                    if let Ok(cut) = cuts.binary_search_by(|cut| cut.sheets.cmp(&[f, g])) {
                        on_cuts.push([cut as u32, vertex]);
                    }
                }
            }
        }
        on_cuts.par_sort_unstable();
        let mut next = 0;
        let mut cut_chains: Vec<Vec<u32>> = Vec::with_capacity(cuts.len());
        for (i, cut) in cuts.iter().enumerate() {
            let mut chain: Vec<u32> = cut.ends.iter().map(|&end| on.vertex(end)).collect();
            while let Some([_, vertex]) = on_cuts.get(next).filter(|own| own[0] as usize == i) {
                chain.push(*vertex);
                next += 1;
            }
            cut_chains.push(chain);
        }
        let senses = cut_chains
            .par_iter_mut()
            .zip(cuts)
            .map(|(chain, cut)| {
                let slope = sort(chain);
                let [f, g] = cut.sheets.map(|sheet| sheets.plane(sheet));
                let along_axis = normals_turn(f, g, across(usize::from(slope.axis)));
                if slope.direction.is_gt() { along_axis } else { along_axis.reverse() }
            })
            .collect();
        own.append(&mut cut_chains);
        let chains = RaggedArray::from_lists(&own);
        Self::with_pieces(sheets, line_of_edge, split_edges, chains, senses)
    }

    /// Numbers the pieces together with the edges that are left whole.
    fn with_pieces(
        sheets: &Sheets,
        line_of_edge: Vec<u32>,
        split_edges: Vec<u32>,
        chains: RaggedArray,
        senses: Vec<Ordering>,
    ) -> Self {
        let pairs = chains.iter().flat_map(|chain| chain.windows(2));
        let mut new: Vec<([u32; 2], u32)> = pairs
            .zip(0..)
            .map(|(pair, piece)| ([pair[0].min(pair[1]), pair[0].max(pair[1])], piece))
            .collect();
        new.par_sort_unstable();
        let mut ends: Vec<[u32; 2]> = Vec::with_capacity(sheets.edges.len() + new.len());
        let mut whole = vec![NONE; sheets.edges.len()];
        let mut items = vec![0; new.len()];
        let mut rest = new.iter().peekable();
        let old = (0..).zip(&sheets.edges).filter(|&(edge, _)| line_of_edge[edge as usize] == NONE);
        let add = |ends: &mut Vec<[u32; 2]>, pair: [u32; 2]| {
            if ends.last() != Some(&pair) {
                ends.push(pair);
            }
            ends.len() as u32 - 1
        };
        for (edge, &pair) in old {
            while let Some((own, piece)) = rest.next_if(|next| next.0 <= pair) {
                items[*piece as usize] = add(&mut ends, *own);
            }
            whole[edge as usize] = add(&mut ends, pair);
        }
        for (own, piece) in rest {
            items[*piece as usize] = add(&mut ends, *own);
        }
        let mut starts = vec![0; chains.len() + 1];
        for (i, chain) in chains.iter().enumerate() {
            starts[i + 1] = starts[i] + chain.len() as u32 - 1;
        }
        let pieces =
            RaggedArray::from_parts(starts, items).expect("each chain has one piece less than vertices");
        Self { ends, line_of_edge, whole, split_edges, chains, pieces, senses }
    }

    /// Whether an edge of a sheet has vertices inside it.
    pub(super) fn is_split(&self, edge: u32) -> bool {
        self.line_of_edge[edge as usize] != NONE
    }

    /// The vertices and edges along an edge of a sheet, from its lower to its higher end.
    pub(super) fn along_edge<'a>(&'a self, sheets: &'a Sheets, edge: u32) -> Chain<'a> {
        match self.line_of_edge[edge as usize] {
            NONE => Chain {
                vertices: &sheets.edges[edge as usize],
                edges: std::slice::from_ref(&self.whole[edge as usize]),
            },
            line => self.along(line as usize),
        }
    }

    /// The vertices and edges along a cut.
    pub(super) fn along_cut(&self, cut: usize) -> Chain<'_> {
        self.along(self.split_edges.len() + cut)
    }

    fn along(&self, line: usize) -> Chain<'_> {
        Chain { vertices: self.chains.list(line), edges: self.pieces.list(line) }
    }

    /// The vertices and edges along the part of an edge between two of its vertices, from its lower end on.
    pub(super) fn along_run<'a>(&'a self, on: &OnLines<'a>, edge: u32, ends: [Place; 2]) -> Chain<'a> {
        let Chain { vertices, edges } = self.along_edge(on.sheets, edge);
        let [first, last] = part(on, vertices, on.sheets.edges[edge as usize], ends);
        Chain { vertices: &vertices[first..=last], edges: &edges[first..last] }
    }

    /// What the direction of each edge of the result is known by.
    pub(super) fn supports(&self, sheets: &Sheets, meetings: &Meetings) -> Vec<Support> {
        let mut supports: Vec<Support> = self.ends.iter().map(|&ends| Support::Corners(ends)).collect();
        // Edges last: where a cut lies on an edge, the edge is simpler.
        for (cut, own) in meetings.cuts.iter().enumerate() {
            let Chain { vertices, edges } = self.along_cut(cut);
            let [f, g] = cut_sheets(own, self.senses[cut].is_gt());
            for (pair, &piece) in vertices.windows(2).zip(edges) {
                supports[piece as usize] = Support::Sheets(if pair[0] < pair[1] { [f, g] } else { [g, f] });
            }
        }
        for (line, &edge) in self.split_edges.iter().enumerate() {
            let Chain { vertices, edges } = self.along(line);
            let [a, b] = sheets.edges[edge as usize];
            for (pair, &piece) in vertices.windows(2).zip(edges) {
                supports[piece as usize] = Support::Corners(if pair[0] < pair[1] { [a, b] } else { [b, a] });
            }
        }
        supports
    }
}

/// The sheets of a cut in the order in which the product of their normals agrees with its vertices.
fn cut_sheets(cut: &Cut, agrees: bool) -> [u32; 2] {
    let [f, g] = cut.sheets;
    if agrees { [f, g] } else { [g, f] }
}

/// The positions of two places in the vertices along an edge, rising.
fn part(on: &OnLines<'_>, chain: &[u32], [a, b]: [u32; 2], ends: [Place; 2]) -> [usize; 2] {
    let slope = on.slope(a, b);
    let [x, y] = ends.map(|end| {
        let vertex = on.vertex(end);
        chain
            .binary_search_by(|&other| on.compare(slope, other, vertex))
            .expect("the ends of what runs along an edge are on it")
    });
    [x.min(y), x.max(y)]
}

/// A plane whose normal is the direction of an axis.
fn across(axis: usize) -> SpatialPlane {
    let mut plane = [[0.0; 3]; 3];
    plane[1][(axis + 1) % 3] = 1.0;
    plane[2][(axis + 2) % 3] = 1.0;
    plane
}
