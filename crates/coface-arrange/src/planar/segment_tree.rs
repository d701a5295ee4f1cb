//! Which segments come near each other: a tree of oriented boxes.
//!
//! A binary tree stands on the order of segments in the plane, in which segments that follow each other on a polyline
//! mostly do so. Each node has the box along the axes, exactly, and a box along a direction of its own, with a margin
//! for rounding: so long thin segments that lie side by side are distinguished, as spikes of a star are, and nothing
//! depends on the sizes of the segments being alike. What is near is only a hint; predicates decide.
//!
//! A run on which one coordinate rises or falls strictly meets itself in its corners only, so its segments are not
//! compared with each other, nor with those of the run that goes on from it the same way.

use super::hilbert_order::{HilbertOrder, LEAF};
use super::oriented_box::{OrientedBox, dot};
use coface_geometry::predicates::PlanarLine;
use coface_geometry::{Bounds, PairNode, PairTask, PairTree};
use rayon::prelude::*;

/// Into how many parts a search for pairs is cut, at least, when there is that much to do.
const PARTS: usize = 1024;

/// The order of a set of segments in space, and boxes on it.
pub(super) struct SegmentTree {
    /// Coordinates are multiplied by this power of two before they are multiplied by each other.
    factor: f64,
    /// The segment at each place.
    order: Vec<u32>,
    /// The ends of the segments, in this order.
    lines: Vec<PlanarLine>,
    /// What is known of the segments in each leaf.
    runs: Vec<Run>,
    /// The boxes around [`LEAF`] places each, and around nodes.
    tree: PairTree<TwoBoxes>,
}

/// Whether the segments of a leaf follow each other on a polyline, and which ways all of them go.
#[derive(Clone, Copy)]
struct Run {
    /// One bit each for going right, left, up and down strictly; none if the segments do not follow each other.
    ways: u8,
    /// Whether the first segment begins where the one before it ends.
    is_joined: bool,
}

impl Run {
    /// The run of the segments of a leaf, which are `lines`.
    fn of_leaf(segments: &[u32], lines: &[PlanarLine], is_joined: impl Fn(usize) -> bool) -> Self {
        let follows = segments.windows(2).all(|pair| pair[0] + 1 == pair[1] && is_joined(pair[1] as usize));
        let ways = |[p, q]: &PlanarLine| {
            let ways = [p[0] < q[0], p[0] > q[0], p[1] < q[1], p[1] > q[1]];
            (0..4).fold(0, |bits, i| bits | u8::from(ways[i]) << i)
        };
        Self {
            ways: if follows { lines.iter().fold(15, |common, line| common & ways(line)) } else { 0 },
            is_joined: is_joined(segments[0] as usize),
        }
    }
}

/// Two boxes around the same segments.
#[derive(Clone, Copy)]
struct TwoBoxes {
    low: [f64; 2],
    high: [f64; 2],
    oriented: OrientedBox,
}

impl TwoBoxes {
    /// The boxes around the segments of a leaf.
    fn of_leaf(lines: &[PlanarLine], factor: f64) -> Self {
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        // The direction of the longest segment is tried.
        let (mut longest, mut axis) = (0.0, [1.0, 0.0]);
        for line in lines {
            for i in 0..2 {
                low[i] = low[i].min(line[0][i].min(line[1][i]));
                high[i] = high[i].max(line[0][i].max(line[1][i]));
            }
            let along = [0, 1].map(|i| line[1][i] * factor - line[0][i] * factor);
            let square = dot(along, along);
            if square > longest {
                (longest, axis) = (square, along);
            }
        }
        let upright = OrientedBox::between([1.0, 0.0], low.map(|x| x * factor), high.map(|x| x * factor));
        let length = longest.sqrt();
        let mut oriented = upright;
        // Where the square is far from what is no ordinary number, the axis is a unit vector.
        if length > 1e-100 {
            let points = lines.as_flattened().iter().map(|point| point.map(|x| x * factor));
            let turned = OrientedBox::of_points(axis.map(|x| x / length), points);
            if turned.area() < upright.area() {
                oriented = turned;
            }
        }
        Self { low, high, oriented }
    }

    /// How low and how high a vertical line can meet what is in the boxes.
    fn heights_at(&self, x: f64, factor: f64) -> [f64; 2] {
        if self.oriented.is_upright() {
            return [self.low[1], self.high[1]];
        }
        let [low, high] = self.oriented.heights_at(x * factor).map(|height| height / factor);
        [self.low[1].max(low), self.high[1].min(high)]
    }

    fn misses(&self, line: PlanarLine, factor: f64) -> bool {
        (0..2).any(|i| line[0][i].min(line[1][i]) > self.high[i] || line[0][i].max(line[1][i]) < self.low[i])
            || !self.oriented.is_upright()
                && self.oriented.misses(line.map(|point| point.map(|x| x * factor)))
    }
}

impl Bounds for TwoBoxes {
    fn around(a: &Self, b: &Self) -> Self {
        let low = [0, 1].map(|i| a.low[i].min(b.low[i]));
        let high = [0, 1].map(|i| a.high[i].max(b.high[i]));
        let mut oriented = OrientedBox::around([1.0, 0.0], &a.oriented, &b.oriented);
        for axis in [a.oriented.axis, b.oriented.axis] {
            let turned = OrientedBox::around(axis, &a.oriented, &b.oriented);
            if turned.area() < oriented.area() {
                oriented = turned;
            }
        }
        Self { low, high, oriented }
    }

    fn is_apart(&self, other: &Self) -> bool {
        (0..2).any(|i| self.high[i] < other.low[i] || other.high[i] < self.low[i])
            || !(self.oriented.is_upright() && other.oriented.is_upright())
                && self.oriented.is_apart(&other.oriented)
    }
}

impl SegmentTree {
    /// A tree on `count` segments; `is_joined` tells whether a segment begins where the one before it ends.
    pub(super) fn new(
        count: usize,
        line: impl Fn(usize) -> PlanarLine + Sync,
        is_joined: impl Fn(usize) -> bool + Sync,
    ) -> Self {
        let HilbertOrder { factor, order } = HilbertOrder::new(count, &line, &is_joined);
        let lines: Vec<PlanarLine> = order.par_iter().with_min_len(4096).map(|&s| line(s as usize)).collect();
        let leaves: Vec<TwoBoxes> =
            lines.par_chunks(LEAF).with_min_len(256).map(|leaf| TwoBoxes::of_leaf(leaf, factor)).collect();
        let runs = (order.par_chunks(LEAF).zip(lines.par_chunks(LEAF)).with_min_len(256))
            .map(|(segments, lines)| Run::of_leaf(segments, lines, &is_joined))
            .collect();
        let tree = PairTree::new(count, LEAF, leaves);
        Self { factor, order, lines, runs, tree }
    }

    /// The parts of the search for all pairs of segments that come near each other; they do not depend on the number of
    /// threads.
    pub(super) fn parts(&self) -> Vec<PairTask> {
        self.tree.tasks(PARTS)
    }

    /// Calls `found` with the pairs of segments of one part whose boxes along the axes meet, and their ends; the
    /// segment of lower number first. In all parts each pair is found once.
    pub(super) fn search(&self, part: PairTask, mut found: impl FnMut([u32; 2], [PlanarLine; 2])) {
        self.tree.search(part, |leaves| self.meet_leaves(leaves, &mut found));
    }

    /// Whether the segments of two leaves, or of one, are known to meet in common corners only.
    fn is_run(&self, [a, b]: PairTask) -> bool {
        let [run_a, run_b] = [a, b].map(|leaf| self.runs[leaf.index()]);
        if run_a.ways & run_b.ways == 0 {
            return false;
        }
        let [of_a, of_b] = [a, b].map(|leaf| &self.order[self.tree.leaf(leaf)]);
        a == b
            || (run_b.is_joined && of_a[of_a.len() - 1] + 1 == of_b[0])
            || (run_a.is_joined && of_b[of_b.len() - 1] + 1 == of_a[0])
    }

    fn meet_leaves(&self, [a, b]: PairTask, found: &mut impl FnMut([u32; 2], [PlanarLine; 2])) {
        if self.is_run([a, b]) {
            return;
        }
        let mut meet = |i: usize, j: usize| {
            let (s, t) = (self.lines[i], self.lines[j]);
            let is_apart = (0..2).any(|axis| {
                s[0][axis].max(s[1][axis]) < t[0][axis].min(t[1][axis])
                    || t[0][axis].max(t[1][axis]) < s[0][axis].min(s[1][axis])
            });
            if !is_apart {
                let numbers = [self.order[i], self.order[j]];
                if numbers[0] < numbers[1] {
                    found(numbers, [s, t]);
                } else {
                    found([numbers[1], numbers[0]], [t, s]);
                }
            }
        };
        if a == b {
            for i in self.tree.leaf(a) {
                (i + 1..self.tree.leaf(a).end).for_each(|j| meet(i, j));
            }
            return;
        }
        let near = |leaf: PairNode, of: PairNode| {
            let bounds = self.tree.bounds(of);
            let (mut places, mut count) = ([0; LEAF], 0);
            for i in self.tree.leaf(leaf) {
                if !bounds.misses(self.lines[i], self.factor) {
                    places[count] = i;
                    count += 1;
                }
            }
            (places, count)
        };
        let (of_a, count_a) = near(a, b);
        if count_a == 0 {
            return;
        }
        let (of_b, count_b) = near(b, a);
        for &i in &of_a[..count_a] {
            of_b[..count_b].iter().for_each(|&j| meet(i, j));
        }
    }

    /// Goes down from a point. `visit` gets segments with their ends and gives the height of the highest that it has
    /// accepted so far; segments that cross the vertical line through the point above that height, below the point,
    /// have been visited when this ends.
    pub(super) fn downward(&self, point: [f64; 2], mut visit: impl FnMut(u32, PlanarLine) -> Option<f64>) {
        let [x, y] = point;
        let mut highest: Option<f64> = None;
        // Nodes by how high they reach below the point, the highest last.
        let mut waiting: Vec<(f64, PairNode)> = self.tree.root().map(|root| (y, root)).into_iter().collect();
        while let Some((reached, node)) = waiting.pop() {
            if highest.is_some_and(|height| reached < height) {
                return;
            }
            if node.is_leaf() {
                for i in self.tree.leaf(node) {
                    let [p, q] = self.lines[i];
                    if p[0].min(q[0]) <= x && x <= p[0].max(q[0]) && p[1].min(q[1]) <= y {
                        highest = visit(self.order[i], self.lines[i]);
                    }
                }
                continue;
            }
            for inner in self.tree.children(node) {
                let bounds = self.tree.bounds(inner);
                if !(bounds.low[0] <= x && x <= bounds.high[0] && bounds.low[1] <= y) {
                    continue;
                }
                let [low, high] = bounds.heights_at(x, self.factor);
                if low <= y {
                    let reach = high.min(y);
                    let place = waiting.iter().rposition(|&(other, _)| other <= reach).map_or(0, |at| at + 1);
                    waiting.insert(place, (reach, inner));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    fn lines() -> impl Strategy<Value = Vec<PlanarLine>> {
        let small = (-8i32..9).prop_map(f64::from);
        let mixed = (-8i32..9, -30i32..30).prop_map(|(m, e)| f64::from(m) * 2f64.powi(e));
        let huge = (-8i32..9, -1060i32..1000).prop_map(|(m, e)| f64::from(m) * 2f64.powi(e));
        let line = |x: BoxedStrategy<f64>| prop::array::uniform4(x).prop_map(|[a, b, c, d]| [[a, b], [c, d]]);
        let of_a_sort = [small.boxed(), mixed.boxed(), huge.boxed()]
            .map(|sort| prop::collection::vec(line(sort), 0..60).boxed());
        prop::strategy::Union::new(of_a_sort)
    }

    /// A segment that is 2^256 times as wide as the curve's squares are.
    #[test]
    fn huge_segments_have_a_level_of_the_curve() {
        let lines = [[[1.0, 5.9e20], [0.0, -5.9e20]], [[0.0, -5.9e20], [3.0e287, 0.0]]];
        let tree = SegmentTree::new(2, |s| lines[s], |s| s == 1);
        let mut found = Vec::new();
        tree.parts().into_iter().for_each(|part| tree.search(part, |pair, _| found.push(pair)));
        assert_eq!(found, [[0, 1]]);
    }

    proptest! {
        #[test]
        fn every_pair_whose_segments_meet_is_found_once(lines in lines()) {
            use coface_geometry::predicates::orientation;
            let mut lines = lines;
            let is_joined = |s: usize| !s.is_multiple_of(5);
            (0..lines.len()).filter(|&s| is_joined(s)).for_each(|s| lines[s][0] = lines[s - 1][1]);
            let tree = SegmentTree::new(lines.len(), |s| lines[s], is_joined);
            let mut found = Vec::new();
            for part in tree.parts() {
                tree.search(part, |pair, ends| {
                    assert_eq!(ends, pair.map(|s| lines[s as usize]));
                    found.push(pair);
                });
            }
            let set: BTreeSet<[u32; 2]> = found.iter().copied().collect();
            prop_assert_eq!(set.len(), found.len());
            for (i, &[a, b]) in lines.iter().enumerate() {
                for (j, &[c, d]) in lines.iter().enumerate().skip(i + 1) {
                    let apart = |a: [f64; 2], b: [f64; 2], c, d| {
                        let sides = [orientation(a, b, c), orientation(a, b, d)];
                        sides[0] == sides[1] && sides[0].is_ne()
                    };
                    let boxes_apart = (0..2).any(|x| {
                        a[x].max(b[x]) < c[x].min(d[x]) || c[x].max(d[x]) < a[x].min(b[x])
                    });
                    // What goes on the same way on an axis meets what it goes on from in their corner only.
                    let goes_on = j == i + 1 && is_joined(j) && (0..2).any(|x| {
                        (a[x] < b[x] && c[x] < d[x]) || (a[x] > b[x] && c[x] > d[x])
                    });
                    if !goes_on && !boxes_apart && !apart(a, b, c, d) && !apart(c, d, a, b) {
                        prop_assert!(set.contains(&[i as u32, j as u32]));
                    }
                }
            }
            // Rays: what is below a point and above the answer so far is visited.
            for &[p, _] in &lines {
                let mut visited = BTreeSet::new();
                tree.downward(p, |segment, _| { visited.insert(segment); None });
                for (i, &[a, b]) in lines.iter().enumerate() {
                    let is_over = a[0].min(b[0]) <= p[0] && p[0] <= a[0].max(b[0]) && a[1].min(b[1]) <= p[1];
                    let is_below = if a < b { orientation(a, b, p).is_ge() } else { orientation(b, a, p).is_ge() };
                    let is_visited = visited.contains(&(i as u32));
                    prop_assert!(is_over || !is_visited);
                    prop_assert!(is_visited || !(is_over && is_below));
                }
            }
        }
    }

    /// The corners of a ring with `count` sides.
    fn polygon(count: usize, center: [f64; 2], radius: f64, turn: f64) -> Vec<[f64; 2]> {
        let corner = |i: usize| {
            let (sine, cosine) = (std::f64::consts::TAU * i as f64 / count as f64 + turn).sin_cos();
            [center[0] + radius * cosine, center[1] + radius * sine]
        };
        (0..count).map(corner).collect()
    }

    /// Rings one around the other, with the least and the greatest radius.
    fn nested(count: usize, sides: usize, radii: [f64; 2], turn: f64) -> Vec<Vec<[f64; 2]>> {
        let radius = |i: usize| radii[0] + (radii[1] - radii[0]) * i as f64 / count as f64;
        (0..count).map(|i| polygon(sides, [0.3, 0.1], radius(i), turn)).collect()
    }

    /// Some drawings with `count` rings or so that do not cross.
    fn drawings(count: usize) -> Vec<(&'static str, Vec<Vec<[f64; 2]>>)> {
        let step = 1.0 / count as f64;
        let upright = std::f64::consts::FRAC_PI_4;
        let scaled = |rings: Vec<Vec<[f64; 2]>>, by: [f64; 2]| {
            let scaled =
                |ring: Vec<[f64; 2]>| ring.into_iter().map(|[x, y]| [x * by[0], y * by[1]]).collect();
            rings.into_iter().map(scaled).collect::<Vec<Vec<[f64; 2]>>>()
        };
        let with = |mut rings: Vec<Vec<[f64; 2]>>, more: Vec<Vec<[f64; 2]>>| {
            rings.extend(more);
            rings
        };
        let comb = (0..count).flat_map(|i| {
            let x = i as f64 * step;
            [[x, 0.0], [x, 1.0], [x + 0.5 * step, 1.0], [x + 0.5 * step, 0.0]]
        });
        let slanted_comb: Vec<[f64; 2]> =
            comb.clone().chain([[1.0, -0.1], [0.0, -0.1]]).map(|[x, y]| [x - 0.4 * y, y + 0.3 * x]).collect();
        let comb: Vec<[f64; 2]> = comb.chain([[1.0, -0.1], [0.0, -0.1]]).collect();
        // Two combs with their teeth between those of each other.
        let lower: Vec<[f64; 2]> = (0..count)
            .flat_map(|i| {
                let [left, right] = [0.0, 0.25].map(|part| (i as f64 + part) * step);
                [[left, 0.0], [left, 1.0], [right, 1.0], [right, 0.0]]
            })
            .chain([[1.0, -0.1], [0.0, -0.1]])
            .collect();
        let upper = lower.iter().map(|&[x, y]| [x + 0.5 * step, 1.1 - y]).collect();
        let combs = vec![lower, upper];
        let slanted = |rings: &[Vec<[f64; 2]>]| {
            let slanted =
                |ring: &Vec<[f64; 2]>| ring.iter().map(|[x, y]| [x - 0.4 * y, y + 0.3 * x]).collect();
            rings.iter().map(slanted).collect::<Vec<Vec<[f64; 2]>>>()
        };
        let spiral = (0..2 * count).map(|i| {
            let [radius, corner] = [1.0 - 0.4 * i as f64 * step, (i % 4) as f64];
            let (sine, cosine) = (upright * (2.0 * corner + 1.0)).sin_cos();
            [radius * cosine, radius * sine]
        });
        let side = (count as f64).sqrt() as usize;
        let holes = (0..side * side).map(|i| {
            polygon(
                4,
                [(i % side) as f64, (i / side) as f64].map(|x| (x + 0.5) / side as f64),
                0.4 / side as f64,
                0.2,
            )
        });
        let fan = (0..count).map(|i| {
            let [left, right] = [0.0, 0.3].map(|part| 6.0 * (i as f64 + part) * step);
            [[0.1, left], [1.0, left], [1.0, right]]
                .map(|[r, angle]| [r * angle.cos(), r * angle.sin()])
                .to_vec()
        });
        vec![
            ("squares", nested(count, 4, [0.0, 1.0], upright)),
            ("diamonds", nested(count, 4, [0.0, 1.0], 0.0)),
            ("slanted squares", nested(count, 4, [0.0, 1.0], 0.3)),
            ("triangles", nested(count, 3, [0.0, 1.0], 0.1)),
            ("polygons of 20 sides", nested(count / 4, 20, [0.0, 1.0], 0.1)),
            ("frames", nested(count, 4, [0.9, 1.0], upright)),
            ("thin frames", scaled(nested(count, 4, [0.5, 1.0], upright), [1.0, 1e-5])),
            ("long triangles", scaled(nested(count, 3, [0.5, 1.0], 0.1), [1.0, 1e-3])),
            (
                "small squares and a far one",
                with(nested(count, 4, [0.0, 1e-3], upright), vec![polygon(4, [1e4, 1e4], 1.0, 0.1)]),
            ),
            (
                "squares in a fine ring",
                with(nested(count, 4, [0.0, 1.0], 0.3), vec![polygon(4 * count, [0.3, 0.1], 1.1, 0.0)]),
            ),
            (
                "squares around a fine ring",
                with(nested(count, 4, [0.5, 1.0], 0.3), vec![polygon(4 * count, [0.3, 0.1], 0.3, 0.0)]),
            ),
            ("comb", vec![comb]),
            ("slanted comb", vec![slanted_comb]),
            ("comb against comb", combs.clone()),
            ("slanted comb against comb", slanted(&combs)),
            ("comb against comb with long teeth", scaled(combs.clone(), [1.0, 1e3])),
            ("comb against comb with long slanted teeth", slanted(&scaled(combs, [1.0, 1e2]))),
            ("spiral", vec![spiral.collect()]),
            ("holes", with(vec![polygon(4, [0.5, 0.5], 2.0, 0.0)], holes.collect())),
            ("fan", fan.collect()),
        ]
    }

    /// How many pairs of nodes a search looks at, and how many segments rays down from the lowest corners of rings.
    fn visits(rings: &[Vec<[f64; 2]>]) -> [usize; 2] {
        let mut lines: Vec<PlanarLine> = Vec::new();
        let mut is_joined: Vec<bool> = Vec::new();
        for ring in rings {
            let next = ring.iter().cycle().skip(1);
            lines.extend(ring.iter().zip(next).map(|(&p, &q)| [p, q]));
            is_joined.extend((0..ring.len()).map(|i| i > 0));
        }
        let tree = SegmentTree::new(lines.len(), |s| lines[s], |s| is_joined[s]);
        let mut stack: Vec<PairTask> = tree.parts();
        let mut pair_count = 0;
        while let Some(pair) = stack.pop() {
            pair_count += 1;
            tree.tree.split(pair, |inner| stack.push(inner));
        }
        let mut ray_count = 0;
        for ring in rings {
            let from = ring.iter().copied().reduce(|p, q| if q < p { q } else { p }).unwrap();
            let mut highest: Option<f64> = None;
            tree.downward(from, |_, [p, q]| {
                ray_count += 1;
                let height = p[1] + (q[1] - p[1]) * (from[0] - p[0]) / (q[0] - p[0]);
                if height < from[1] && highest.is_none_or(|other| other < height) {
                    highest = Some(height);
                }
                highest
            });
        }
        [pair_count, ray_count]
    }

    #[test]
    fn rings_around_each_other_are_told_apart() {
        for (name, rings) in drawings(4000) {
            let side_count: usize = rings.iter().map(Vec::len).sum();
            let [pair_count, ray_count] = visits(&rings);
            assert!(
                pair_count <= 16 * side_count,
                "{name}: {pair_count} pairs of nodes for {side_count} sides"
            );
            assert!(ray_count <= 64 * rings.len(), "{name}: {ray_count} segments on {} rays", rings.len());
        }
    }
}
