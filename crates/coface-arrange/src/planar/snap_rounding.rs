//! Snap rounding: segments on a grid of equal squares, bent through the middles of the squares with vertices in them.

use super::PlanarArrangement;
use coface_geometry::predicates::{PlanarLine, PlanarPoint, orientation};
use rayon::prelude::*;
use std::cmp::Ordering;

/// The middles of the hot pixels: the unit squares around integer points that have a vertex of an arrangement in them.
///
/// A pixel has its left and its lower side, not the other two.
pub(super) struct HotPixels {
    /// In lexicographic order.
    pub(super) middles: Vec<[f64; 2]>,
    /// The pixel of each vertex of the arrangement.
    pub(super) of_vertex: Vec<u32>,
    tree: Vec<Node>,
    /// The pixels in the order of the tree.
    order: Vec<u32>,
}

/// A node of the tree: the pixels in a range of its order, in a box.
#[derive(Clone, Copy)]
struct Node {
    low: [f64; 2],
    high: [f64; 2],
}

/// So many pixels are looked at one by one.
const LEAF: usize = 8;

impl HotPixels {
    /// The pixels of the vertices of an arrangement, whose coordinates are less than $2^{52}$.
    pub(super) fn new(arrangement: &PlanarArrangement) -> Self {
        let of_vertex: Vec<[f64; 2]> =
            arrangement.vertices.par_iter().map(|vertex| [0, 1].map(|axis| middle(vertex, axis))).collect();
        let mut middles = of_vertex.clone();
        middles.par_sort_unstable_by(compare);
        middles.dedup();
        let place = |at: &[f64; 2]| {
            let found = middles.binary_search_by(|other| compare(other, at));
            found.expect("the middle of each vertex is in the list") as u32
        };
        let of_vertex = of_vertex.par_iter().map(place).collect();
        let mut pixels =
            Self { of_vertex, tree: Vec::new(), order: (0..middles.len() as u32).collect(), middles };
        let mut order = std::mem::take(&mut pixels.order);
        pixels.grow(&mut order);
        pixels.order = order;
        pixels
    }

    /// Adds the node above some pixels and what is under it, and puts the pixels in order.
    fn grow(&mut self, own: &mut [u32]) {
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for &pixel in &*own {
            for axis in 0..2 {
                low[axis] = low[axis].min(self.middles[pixel as usize][axis] - 0.5);
                high[axis] = high[axis].max(self.middles[pixel as usize][axis] + 0.5);
            }
        }
        self.tree.push(Node { low, high });
        if own.len() <= LEAF {
            return;
        }
        let axis = usize::from(high[1] - low[1] > high[0] - low[0]);
        let middles = &self.middles;
        let half = own.len() / 2;
        own.select_nth_unstable_by(half, |&a, &b| {
            let [p, q] = [a, b].map(|pixel| middles[pixel as usize]);
            p[axis].total_cmp(&q[axis]).then(a.cmp(&b))
        });
        let (lower, upper) = own.split_at_mut(half);
        self.grow(lower);
        self.grow(upper);
    }

    /// The number of nodes of a tree on so many pixels.
    fn node_count(pixel_count: usize) -> usize {
        match pixel_count {
            ..=LEAF => 1,
            _ => 1 + Self::node_count(pixel_count / 2) + Self::node_count(pixel_count - pixel_count / 2),
        }
    }

    /// The pixels that a segment goes through, from its start to its end.
    pub(super) fn along(&self, line: PlanarLine) -> Vec<u32> {
        let mut found = Vec::new();
        self.search(line, 0, 0, self.order.len(), &mut found);
        let ways = [0, 1].map(|axis| line[1][axis].total_cmp(&line[0][axis]));
        let along =
            |a: f64, b: f64, way: Ordering| if way.is_lt() { b.total_cmp(&a) } else { a.total_cmp(&b) };
        found.sort_unstable_by(|&a, &b| {
            let [p, q] = [a, b].map(|pixel| self.middles[pixel as usize]);
            along(p[0], q[0], ways[0]).then_with(|| along(p[1], q[1], ways[1]))
        });
        found
    }

    /// The same along a chain of segments between middles of pixels.
    pub(super) fn along_chain(&self, chain: &[u32]) -> Vec<u32> {
        let mut found: Vec<u32> = chain.first().copied().into_iter().collect();
        for side in chain.windows(2) {
            let line = [side[0], side[1]].map(|pixel| self.middles[pixel as usize]);
            found.extend(&self.along(line)[1..]);
        }
        found
    }

    fn search(&self, line: PlanarLine, node: usize, first: usize, count: usize, found: &mut Vec<u32>) {
        if count == 0 || misses(line, self.tree[node]) {
            return;
        }
        if count <= LEAF {
            let own = &self.order[first..first + count];
            found.extend(own.iter().filter(|&&pixel| is_in_pixel(line, self.middles[pixel as usize])));
            return;
        }
        let half = count / 2;
        self.search(line, node + 1, first, half, found);
        self.search(line, node + 1 + Self::node_count(half), first + half, count - half, found);
    }
}

fn compare(a: &[f64; 2], b: &[f64; 2]) -> Ordering {
    a[0].total_cmp(&b[0]).then_with(|| a[1].total_cmp(&b[1]))
}

/// The integer that a coordinate is nearest to; the upper one of two.
fn middle(point: &PlanarPoint, axis: usize) -> f64 {
    let is_below = |bound: f64| point.compare_coordinate(&PlanarPoint::given([bound; 2]), axis).is_lt();
    let mut middle = point.rounded()[axis].round();
    // Rounded twice it may be one too far.
    while is_below(middle - 0.5) {
        middle -= 1.0;
    }
    while !is_below(middle + 0.5) {
        middle += 1.0;
    }
    middle + 0.0
}

/// Whether a segment has no point in a box; not always found.
fn misses([a, b]: PlanarLine, node: Node) -> bool {
    if (0..2).any(|axis| a[axis].min(b[axis]) > node.high[axis] || a[axis].max(b[axis]) < node.low[axis]) {
        return true;
    }
    let side =
        |x: usize, y: usize| orientation(a, b, [[node.low, node.high][x][0], [node.low, node.high][y][1]]);
    let first = side(0, 0);
    first.is_ne() && [side(0, 1), side(1, 0), side(1, 1)] == [first; 3]
}

/// Whether a segment has a point in the pixel around a point.
fn is_in_pixel([a, b]: PlanarLine, middle: [f64; 2]) -> bool {
    let (low, high) = (middle.map(|x| x - 0.5), middle.map(|x| x + 0.5));
    if (0..2).any(|axis| a[axis].min(b[axis]) >= high[axis] || a[axis].max(b[axis]) < low[axis]) {
        return false;
    }
    if a == b {
        return true;
    }
    // The upper sides are taken to be lower by less than any number, so that the pixel is closed.
    let [dx, dy] = [0, 1].map(|axis| b[axis].total_cmp(&a[axis]));
    let slope = || {
        // The sign of dy - dx, that of the turn of the diagonal.
        orientation(a, b, [high[0] - 1.0, high[1] - 1.0])
    };
    let corners = [
        orientation(a, b, low),
        orientation(a, b, [high[0], low[1]]).then(dy),
        orientation(a, b, [low[0], high[1]]).then(dx.reverse()),
        orientation(a, b, high).then_with(slope),
    ];
    !(corners[0].is_ne() && corners.iter().all(|&side| side == corners[0]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::Rational;
    use coface_geometry::Positions;
    use proptest::prelude::*;

    /// Whether the segment has a point in the pixel, by cutting it with fractions.
    fn is_cut([a, b]: PlanarLine, middle: [f64; 2]) -> bool {
        let number = |x: f64| {
            let [number, _] = PlanarPoint::given([x; 2]).to_rational();
            number
        };
        let (mut from, mut to) = (Rational::ZERO, Rational::from(1));
        let (mut has_from, mut has_to) = (true, true);
        for axis in 0..2 {
            let (start, way) = (number(a[axis]), &number(b[axis]) - &number(a[axis]));
            let (low, high) = (number(middle[axis] - 0.5), number(middle[axis] + 0.5));
            if way == Rational::ZERO {
                if start < low || start >= high {
                    return false;
                }
                continue;
            }
            let inverse = way.inverse().expect("not zero");
            let [at_low, at_high] = [&low, &high].map(|bound| &(bound - &start) * &inverse);
            let ((enter, enter_in), (leave, leave_in)) = if way > Rational::ZERO {
                ((at_low, true), (at_high, false))
            } else {
                ((at_high, false), (at_low, true))
            };
            if enter > from {
                (from, has_from) = (enter, enter_in);
            } else if enter == from {
                has_from &= enter_in;
            }
            if leave < to {
                (to, has_to) = (leave, leave_in);
            } else if leave == to {
                has_to &= leave_in;
            }
        }
        from < to || (from == to && has_from && has_to)
    }

    proptest! {
        #[test]
        fn segments_are_in_the_pixels_that_cutting_them_finds(
            ends in prop::array::uniform4(-12i32..13), middle in prop::array::uniform2(-2i32..3)
        ) {
            let [ax, ay, bx, by] = ends.map(|x| f64::from(x) / 4.0);
            let middle = middle.map(f64::from);
            let line = [[ax, ay], [bx, by]];
            prop_assert_eq!(is_in_pixel(line, middle), is_cut(line, middle));
        }

        #[test]
        fn the_tree_finds_the_pixels_of_all(
            points in prop::collection::vec(prop::array::uniform2(-80i32..80), 1..60),
            ends in prop::array::uniform4(-400i32..400)
        ) {
            let flat = points.iter().flatten().map(|&x| f64::from(x) / 4.0).collect();
            let positions = Positions::from_flat(2, flat).unwrap();
            let pixels = HotPixels::new(&PlanarArrangement::new(&positions, &[]).unwrap());
            let [ax, ay, bx, by] = ends.map(|x| f64::from(x) / 16.0);
            let line = [[ax, ay], [bx, by]];
            let mut found = pixels.along(line);
            found.sort_unstable();
            let all = 0..pixels.middles.len() as u32;
            let expected: Vec<u32> = all.filter(|&pixel| is_in_pixel(line, pixels.middles[pixel as usize])).collect();
            prop_assert_eq!(found, expected);
        }
    }
}
