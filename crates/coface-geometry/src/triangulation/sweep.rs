//! Triangulation in one sweep over the vertices.

use super::TriangulationFault;
use super::status::{NONE, Status};
use coface_algebra::RaggedArray;
use coface_algebra::narrow;
use std::cmp::Ordering;

/// Triangulates the polygon with these walks, on its own vertices; triangles run counterclockwise.
///
/// `compare` is the lexicographic order of vertices, `turn` the way that three of them turn: `Greater` for
/// counterclockwise. Each side of a walk is a side of one triangle; all other sides of triangles come in pairs. So a
/// polygon of n vertices, of which none is passed twice, in one piece and with h holes has n + 2h - 2 triangles. None
/// is without area; vertices on straight runs are corners too.
///
/// # Errors
/// The [`TriangulationFault`] that is met first: sides that cross or touch outside of vertices, or have the inside to
/// their right. Every input that is not a polygon is refused.
///
/// # Complexity
/// $O(n \log n)$ for n sides.
///
/// # Algorithm
/// A line sweeps over the vertices in lexicographic order. The part of the polygon behind the line is triangulated up
/// to one chain for each stretch of the inside that the line crosses; the chain bulges forward, and a new vertex makes
/// triangles with the part that is visible from it. Edges that become neighbors on the line are tested for a crossing.
///
/// # References
/// S. Hertel, K. Mehlhorn, *Fast triangulation of simple polygons* (1983); M. I. Shamos, D. Hoey, *Geometric
/// intersection problems* (1976).
///
/// # Examples
/// A square with a hole that touches it in a corner:
/// ```
/// use coface_geometry::predicates::orientation;
/// use coface_geometry::triangulation::triangulate;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let points = [[0., 0.], [4., 0.], [4., 4.], [0., 4.], [1., 2.], [2., 1.]];
/// let compare = |a: u32, b: u32| points[a as usize].partial_cmp(&points[b as usize]).expect("numbers");
/// let turn = |a: u32, b: u32, c: u32| orientation(points[a as usize], points[b as usize], points[c as usize]);
/// let triangles = triangulate(&[&[0, 1, 2, 3][..], &[0, 4, 5]], compare, turn)?;
/// assert_eq!(triangles.len(), 5);
/// assert!(triangles.iter().all(|&[a, b, c]| turn(a, b, c).is_gt()));
/// # Ok(()) }
/// ```
pub fn triangulate<W: AsRef<[u32]>>(
    walks: &[W],
    compare: impl Fn(u32, u32) -> Ordering,
    turn: impl Fn(u32, u32, u32) -> Ordering,
) -> Result<Vec<[u32; 3]>, TriangulationFault> {
    if let [walk] = walks {
        match *walk.as_ref() {
            [a, b, c] if turn(a, b, c).is_gt() => return Ok(vec![[a, b, c]]),
            // Four left turns are one time around.
            [a, b, c, d]
                if turn(a, b, c).is_gt()
                    && turn(b, c, d).is_gt()
                    && turn(c, d, a).is_gt()
                    && turn(d, a, b).is_gt() =>
            {
                return Ok(vec![[a, b, c], [a, c, d]]);
            }
            _ => {}
        }
    }
    let sides: Vec<[u32; 2]> = walks
        .iter()
        .flat_map(|walk| {
            let walk = walk.as_ref();
            (0..walk.len()).map(|i| [walk[i], walk[(i + 1) % walk.len()]])
        })
        .collect();
    triangulate_sides(&sides, compare, turn)
}

/// Triangulates the polygon with these sides, in any order; see [`triangulate`]. Turns may be called straight that are nearly so, from
/// which a fault may come, but no panic.
///
/// # Errors
/// As [`triangulate`].
///
/// # Examples
/// ```
/// use coface_geometry::predicates::orientation;
/// use coface_geometry::triangulation::{TriangulationFault, triangulate_sides};
/// let points = [[0., 0.], [4., 0.], [4., 4.], [0., 4.]];
/// let compare = |a: u32, b: u32| points[a as usize].partial_cmp(&points[b as usize]).expect("numbers");
/// let turn = |a: u32, b: u32, c: u32| orientation(points[a as usize], points[b as usize], points[c as usize]);
/// let bow_tie = [[0, 1], [1, 3], [3, 2], [2, 0]];
/// assert_eq!(
///     triangulate_sides(&bow_tie, compare, turn),
///     Err(TriangulationFault::Crossing([[0, 2], [3, 1]]))
/// );
/// ```
pub fn triangulate_sides(
    sides: &[[u32; 2]],
    compare: impl Fn(u32, u32) -> Ordering,
    turn: impl Fn(u32, u32, u32) -> Ordering,
) -> Result<Vec<[u32; 3]>, TriangulationFault> {
    let mut vertices: Vec<u32> = sides.as_flattened().to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    // Places in the order of numbers, to find them again.
    let numbers = vertices.clone();
    vertices.sort_by(|&a, &b| compare(a, b));
    if let Some(pair) = vertices.windows(2).find(|pair| compare(pair[0], pair[1]).is_eq()) {
        return Err(TriangulationFault::SamePlace([pair[0], pair[1]]));
    }
    let place = |number: u32| numbers.binary_search(&number).expect("ends of sides are vertices");
    let mut rank = vec![0; numbers.len()];
    for (order, &vertex) in vertices.iter().enumerate() {
        rank[place(vertex)] = narrow(order);
    }
    let edges = Edges::new(sides, |number| rank[place(number)])?;
    let turn = |[a, b, c]: [u32; 3]| turn(vertices[a as usize], vertices[b as usize], vertices[c as usize]);
    let run = |fills: bool| {
        let mut sweep = Sweep::new(&edges, vertices.len(), &turn, fills);
        for vertex in 0..narrow(vertices.len()) {
            sweep.pass(vertex, &edges)?;
        }
        Ok(sweep.triangles)
    };
    match run(true) {
        Ok(triangles) => {
            Ok(triangles.into_iter().map(|own| own.map(|order| vertices[order as usize])).collect())
        }
        Err(mut fault) => {
            // Sides that cross have the inside on the wrong side somewhere, which may come first.
            if let (TriangulationFault::WrongWay(_), Err(crossing)) = (fault, run(false)) {
                fault = crossing;
            }
            Err(fault.renumbered(|order| vertices[order as usize]))
        }
    }
}

/// So many numbers are sorted by insertion.
const FEW: usize = 8;

/// Sorts numbers by merging. Where the comparison is no total order, as that of turns which are nearly straight, the order is some
/// order, and nothing breaks.
fn sort_any(numbers: &mut [u32], compare: impl Fn(u32, u32) -> Ordering + Copy) {
    if numbers.len() <= FEW {
        for end in 1..numbers.len() {
            let place = numbers[..end].iter().position(|&other| compare(other, numbers[end]).is_gt());
            numbers[place.unwrap_or(end)..=end].rotate_right(1);
        }
        return;
    }
    let (low, high) = numbers.split_at_mut(numbers.len() / 2);
    sort_any(low, compare);
    sort_any(high, compare);
    let mut merged = Vec::with_capacity(low.len() + high.len());
    let (mut left, mut right) = (low.iter().peekable(), high.iter().peekable());
    while let (Some(&&a), Some(&&b)) = (left.peek(), right.peek()) {
        merged.extend(if compare(a, b).is_le() { left.next() } else { right.next() });
    }
    merged.extend(left.chain(right));
    numbers.copy_from_slice(&merged);
}

/// The edges that sides run along. Vertices are numbered in lexicographic order.
struct Edges {
    /// The lower and the higher end, sorted.
    ends: Vec<[u32; 2]>,
    /// Whether the inside is below and above each.
    inside: Vec<[bool; 2]>,
    /// Where the edges that begin at each vertex begin.
    starts: Vec<u32>,
    /// The edges that end at each vertex.
    ending: RaggedArray,
}

impl Edges {
    fn new(sides: &[[u32; 2]], rank: impl Fn(u32) -> u32) -> Result<Self, TriangulationFault> {
        let mut darts = Vec::with_capacity(sides.len());
        for &[from, to] in sides {
            if from == to {
                return Err(TriangulationFault::NoLength(from));
            }
            let [a, b] = [rank(from), rank(to)];
            // A side that goes up has the inside above it.
            darts.push(([a.min(b), a.max(b)], a < b, [from, to]));
        }
        darts.sort_unstable();
        let (mut ends, mut inside): (Vec<[u32; 2]>, Vec<[bool; 2]>) = (Vec::new(), Vec::new());
        for (own, above, side) in darts {
            if ends.last() != Some(&own) {
                ends.push(own);
                inside.push([false; 2]);
            }
            let here = &mut inside.last_mut().expect("there is an edge")[usize::from(above)];
            if *here {
                return Err(TriangulationFault::RepeatedSide(side));
            }
            *here = true;
        }
        let count = ends.iter().map(|own| own[1] + 1).max().unwrap_or(0) as usize;
        let mut starts = vec![0; count + 1];
        ends.iter().for_each(|own| starts[own[0] as usize + 1] += 1);
        for i in 0..count {
            starts[i + 1] += starts[i];
        }
        let ending = RaggedArray::grouped(count, ends.iter().map(|own| own[1]));
        Ok(Self { ends, inside, starts, ending })
    }

    fn ends(&self, edge: u32) -> [u32; 2] {
        self.ends[edge as usize]
    }

    fn is_inside_above(&self, edge: u32) -> bool {
        edge != NONE && self.inside[edge as usize][1]
    }

    fn is_inside_below(&self, edge: u32) -> bool {
        edge != NONE && self.inside[edge as usize][0]
    }
}

/// A vertex on the chain behind a stretch, with the places of its neighbors.
#[derive(Clone, Copy)]
struct Link {
    vertex: u32,
    lower: u32,
    upper: u32,
}

/// The chain behind a stretch of the inside: it runs from the lower end of the edge below to that of the edge above,
/// and bulges forward.
#[derive(Clone, Copy)]
struct Chain {
    first: u32,
    last: u32,
    /// The vertex that was passed last.
    foremost: u32,
}

const NO_CHAIN: Chain = Chain { first: NONE, last: NONE, foremost: NONE };

struct Sweep<T> {
    turn: T,
    status: Status,
    links: Vec<Link>,
    /// The chain behind the stretch above each edge on the line.
    chains: Vec<Chain>,
    triangles: Vec<[u32; 3]>,
    /// The edges that begin and end at a vertex, from low to high.
    begin: Vec<u32>,
    end: Vec<u32>,
    /// Whether triangles are wanted, not only crossings.
    fills: bool,
}

impl<T: Fn([u32; 3]) -> Ordering> Sweep<T> {
    fn new(edges: &Edges, vertex_count: usize, turn: T, fills: bool) -> Self {
        Self {
            turn,
            status: Status::new(edges.ends.len()),
            links: Vec::with_capacity(2 * vertex_count),
            chains: vec![NO_CHAIN; edges.ends.len()],
            triangles: Vec::with_capacity(vertex_count),
            begin: Vec::new(),
            end: Vec::new(),
            fills,
        }
    }

    /// Moves the line over a vertex.
    fn pass(&mut self, vertex: u32, edges: &Edges) -> Result<(), TriangulationFault> {
        let (mut begin, mut end) = (std::mem::take(&mut self.begin), std::mem::take(&mut self.end));
        self.sort_around(vertex, edges, &mut begin, &mut end)?;
        let (below, above) = match (end.first(), end.last()) {
            (Some(&low), Some(&high)) => (self.status.below(low), self.status.above(high)),
            _ => {
                let below = self.status.highest_below(|edge| {
                    let [a, b] = edges.ends(edge);
                    match (self.turn)([a, b, vertex]) {
                        Ordering::Equal => Err(TriangulationFault::OnSide { vertex, side: [a, b] }),
                        side => Ok(side.is_gt()),
                    }
                })?;
                (below, self.status.above(below))
            }
        };
        // From low to high the inside begins and ends with the edges.
        let mut is_inside = edges.is_inside_above(below);
        for &edge in begin.iter().chain([&above]) {
            if self.fills && edges.is_inside_below(edge) != is_inside {
                return Err(TriangulationFault::WrongWay(vertex));
            }
            is_inside = edges.is_inside_above(edge);
        }
        let (lower, upper) =
            if self.fills { self.advance(vertex, edges, &end, below, above) } else { (None, None) };
        for &edge in &end {
            self.status.remove(edge);
        }
        let mut last = below;
        for &edge in &begin {
            self.status.insert_above(edge, last);
            if edges.is_inside_above(edge) {
                let link = self.link(vertex);
                self.chains[edge as usize] = Chain { first: link, last: link, foremost: link };
            }
            last = edge;
        }
        match (begin.first(), begin.last()) {
            (Some(&low), Some(&high)) => {
                if let Some(lower) = lower {
                    self.chains[below as usize] = lower;
                }
                if let Some(upper) = upper {
                    self.chains[high as usize] = upper;
                }
                self.check_neighbors(below, low, edges)?;
                self.check_neighbors(high, above, edges)?;
            }
            _ => {
                if let (Some(lower), Some(upper)) = (lower, upper) {
                    self.chains[below as usize] = self.joined(lower, upper);
                }
                self.check_neighbors(below, above, edges)?;
            }
        }
        (self.begin, self.end) = (begin, end);
        Ok(())
    }

    /// The edges that begin and that end at a vertex, from low to high.
    fn sort_around(
        &self,
        vertex: u32,
        edges: &Edges,
        begin: &mut Vec<u32>,
        end: &mut Vec<u32>,
    ) -> Result<(), TriangulationFault> {
        begin.clear();
        end.clear();
        begin.extend(edges.starts[vertex as usize]..edges.starts[vertex as usize + 1]);
        let turn = |low: u32, high: u32| (self.turn)([vertex, edges.ends(low)[1], edges.ends(high)[1]]);
        sort_any(begin, |low, high| turn(low, high).reverse());
        if let Some(pair) = begin.windows(2).find(|pair| turn(pair[0], pair[1]).is_eq()) {
            return Err(TriangulationFault::Crossing([edges.ends(pair[0]), edges.ends(pair[1])]));
        }
        let ending = edges.ending.list(vertex as usize);
        if let Some(&some) = ending.first() {
            let ends_here = |edge: u32| edge != NONE && edges.ends(edge)[1] == vertex;
            let mut low = some;
            while ends_here(self.status.below(low)) {
                low = self.status.below(low);
            }
            let mut edge = low;
            while ends_here(edge) {
                end.push(edge);
                edge = self.status.above(edge);
            }
            // Others in between would have been found when they became neighbors.
            if end.len() < ending.len() {
                return Err(TriangulationFault::WrongWay(vertex));
            }
        }
        Ok(())
    }

    /// Adds the triangles that a vertex sees. Gives the chains, with the vertex on them, of the stretches below and
    /// above it, if they are inside.
    fn advance(
        &mut self,
        vertex: u32,
        edges: &Edges,
        end: &[u32],
        below: u32,
        above: u32,
    ) -> (Option<Chain>, Option<Chain>) {
        let Some(&high) = end.last() else {
            if !edges.is_inside_above(below) {
                return (None, None);
            }
            let (lower, upper) = self.split(vertex, self.chains[below as usize]);
            return (Some(lower), Some(upper));
        };
        for &edge in &end[..end.len() - 1] {
            if edges.is_inside_above(edge) {
                self.close(vertex, self.chains[edge as usize]);
            }
        }
        let lower = edges.is_inside_above(below).then(|| {
            let chain = self.chains[below as usize];
            let last = self.visible_below(vertex, chain.last);
            let link = self.link(vertex);
            self.join(last, link);
            Chain { first: chain.first, last: link, foremost: link }
        });
        let upper = edges.is_inside_below(above).then(|| {
            let chain = self.chains[high as usize];
            let first = self.visible_above(vertex, chain.first);
            let link = self.link(vertex);
            self.join(link, first);
            Chain { first: link, last: chain.last, foremost: link }
        });
        (lower, upper)
    }

    /// Connects a vertex on the inside of a stretch with what it sees behind it.
    fn split(&mut self, vertex: u32, chain: Chain) -> (Chain, Chain) {
        let last = self.visible_below(vertex, chain.foremost);
        let mut first = self.visible_above(vertex, chain.foremost);
        let (mut upper_last, links) = (chain.last, [self.link(vertex), self.link(vertex)]);
        if first == last {
            // It is on both chains from now on.
            let copy = self.link(self.links[first as usize].vertex);
            let next = self.links[first as usize].upper;
            if next == NONE {
                upper_last = copy;
            } else {
                self.join(copy, next);
            }
            first = copy;
        }
        self.join(last, links[0]);
        self.join(links[1], first);
        (
            Chain { first: chain.first, last: links[0], foremost: links[0] },
            Chain { first: links[1], last: upper_last, foremost: links[1] },
        )
    }

    /// The triangles of a vertex with all of a chain.
    fn close(&mut self, vertex: u32, chain: Chain) {
        let mut here = chain.first;
        while here != chain.last {
            let Link { vertex: low, upper, .. } = self.links[here as usize];
            self.triangles.push([low, vertex, self.links[upper as usize].vertex]);
            here = upper;
        }
    }

    /// Adds the triangles with the chain below a link as far as they are visible, and gives where that ends.
    fn visible_below(&mut self, vertex: u32, mut here: u32) -> u32 {
        loop {
            let Link { vertex: high, lower, .. } = self.links[here as usize];
            if lower == NONE {
                return here;
            }
            let triangle = [self.links[lower as usize].vertex, vertex, high];
            if (self.turn)(triangle).is_le() {
                return here;
            }
            self.triangles.push(triangle);
            here = lower;
        }
    }

    /// The same above a link.
    fn visible_above(&mut self, vertex: u32, mut here: u32) -> u32 {
        loop {
            let Link { vertex: low, upper, .. } = self.links[here as usize];
            if upper == NONE {
                return here;
            }
            let triangle = [low, vertex, self.links[upper as usize].vertex];
            if (self.turn)(triangle).is_le() {
                return here;
            }
            self.triangles.push(triangle);
            here = upper;
        }
    }

    fn link(&mut self, vertex: u32) -> u32 {
        self.links.push(Link { vertex, lower: NONE, upper: NONE });
        narrow(self.links.len()) - 1
    }

    fn join(&mut self, lower: u32, upper: u32) {
        self.links[lower as usize].upper = upper;
        self.links[upper as usize].lower = lower;
    }

    /// The chain of two that meet at a vertex, which is last on the one and first on the other.
    fn joined(&mut self, lower: Chain, upper: Chain) -> Chain {
        let next = self.links[upper.first as usize].upper;
        self.join(lower.last, next);
        Chain { first: lower.first, last: upper.last, foremost: lower.last }
    }

    /// Whether two edges that have become neighbors stay one above the other up to where the first of them ends.
    fn check_neighbors(&self, low: u32, high: u32, edges: &Edges) -> Result<(), TriangulationFault> {
        if low == NONE || high == NONE {
            return Ok(());
        }
        let ([a, b], [c, d]) = (edges.ends(low), edges.ends(high));
        let (end, side, order) = match b.cmp(&d) {
            Ordering::Equal => return Ok(()),
            Ordering::Less => (b, [c, d], (self.turn)([c, d, b]).reverse()),
            Ordering::Greater => (d, [a, b], (self.turn)([a, b, d])),
        };
        match order {
            Ordering::Greater => Ok(()),
            Ordering::Equal => Err(TriangulationFault::OnSide { vertex: end, side }),
            Ordering::Less => Err(TriangulationFault::Crossing([[a, b], [c, d]])),
        }
    }
}
