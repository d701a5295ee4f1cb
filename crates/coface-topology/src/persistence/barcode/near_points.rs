//! Points of the plane from which those near a place are taken one after the other.

/// So many points are looked at one by one.
const LEAF: usize = 8;

/// A tree of points of the plane. What is taken out is not found again.
pub(super) struct NearPoints<'a> {
    points: &'a [[f64; 2]],
    /// The points of a node are one range of these; those that are left come first in the range of a leaf.
    order: Vec<u32>,
    nodes: Vec<Node>,
}

struct Node {
    start: u32,
    /// How many points are left.
    left: u32,
    least: [f64; 2],
    greatest: [f64; 2],
    /// The node of the second half; the first half is the next node. 0 for a leaf.
    second: u32,
}

impl<'a> NearPoints<'a> {
    /// A tree of the points with these numbers.
    pub(super) fn new(points: &'a [[f64; 2]], order: Vec<u32>) -> Self {
        let mut tree = Self { points, nodes: Vec::with_capacity(2 * order.len() / LEAF + 1), order };
        if !tree.order.is_empty() {
            tree.build(0, tree.order.len());
        }
        tree
    }

    fn build(&mut self, start: usize, end: usize) {
        let own = &mut self.order[start..end];
        let (mut least, mut greatest) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for &point in &*own {
            for (axis, &x) in self.points[point as usize].iter().enumerate() {
                least[axis] = least[axis].min(x);
                greatest[axis] = greatest[axis].max(x);
            }
        }
        let node = self.nodes.len();
        let (first, last) = (start as u32, end as u32);
        self.nodes.push(Node { start: first, left: last - first, least, greatest, second: 0 });
        if own.len() <= LEAF {
            return;
        }
        let axis = usize::from(greatest[1] - least[1] > greatest[0] - least[0]);
        let half = own.len() / 2;
        own.select_nth_unstable_by(half, |&a, &b| {
            self.points[a as usize][axis].total_cmp(&self.points[b as usize][axis]).then(a.cmp(&b))
        });
        self.build(start, start + half);
        self.nodes[node].second = self.nodes.len() as u32;
        self.build(start + half, end);
    }

    /// Takes out a point whose coordinates differ by at most `radius` from these.
    pub(super) fn take_within(&mut self, center: [f64; 2], radius: f64) -> Option<u32> {
        if self.nodes.is_empty() { None } else { self.take_from(0, center, radius) }
    }

    fn take_from(&mut self, at: usize, center: [f64; 2], radius: f64) -> Option<u32> {
        let node = &self.nodes[at];
        let is_far = |axis: usize| {
            node.least[axis] - center[axis] > radius || center[axis] - node.greatest[axis] > radius
        };
        if node.left == 0 || is_far(0) || is_far(1) {
            return None;
        }
        let (start, left, second) = (node.start as usize, node.left as usize, node.second as usize);
        let taken = if second == 0 {
            let own = &mut self.order[start..start + left];
            let place =
                own.iter().position(|&point| distance(self.points[point as usize], center) <= radius)?;
            own.swap(place, left - 1);
            own[left - 1]
        } else {
            let found = self.take_from(at + 1, center, radius);
            found.or_else(|| self.take_from(second, center, radius))?
        };
        self.nodes[at].left -= 1;
        Some(taken)
    }
}

/// The greater one of the differences of births and of deaths.
pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}
