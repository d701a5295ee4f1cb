//! Interfaces of Yin sets that lie side by side.

use super::graph::Arcs;
use super::partition::{Overlaps, Partition};
use super::{DirectedEdge, InterfaceGraph};
use crate::{Kinks, KnotIndex, Order, YinSet};
use coface_algebra::Error;

/// How sets become phases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InterfaceOptions {
    /// The order of the edges.
    pub(crate) order: Order,
    /// By how much a way may turn at a junction and still be smooth, in radians; with 0 only straight ways are, with a negative number
    /// none.
    pub(crate) smooth_angle: f64,
    /// Where points go that several sets have in common.
    pub(crate) overlaps: Overlaps,
}

impl InterfaceOptions {
    /// Edges of some order that end at all junctions, and overlaps refused.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{InterfaceGraph, InterfaceOptions, Order};
    /// let nothing = InterfaceGraph::of_sets_with(&[], &InterfaceOptions::new(Order::CUBIC))?;
    /// assert_eq!((nothing.order(), nothing.edge_count()), (Order::CUBIC, 0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(order: Order) -> Self {
        Self { order, smooth_angle: -1.0, overlaps: Overlaps::Refused }
    }

    /// Lets edges go on smoothly through a junction at which they turn by at most this angle, in radians; with 0 only straight ways do, with
    /// a negative number none.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, InterfaceGraph, InterfaceOptions, Order, YinSet};
    /// let square = Curve::polyline(&[[0., 0.], [2., 0.], [2., 2.], [0., 2.], [0., 0.]])?;
    /// let sets = [YinSet::new(&[square.translated([2.0, 0.0])])?, YinSet::new(&[square])?];
    /// let graph = InterfaceGraph::of_sets_with(&sets, &InterfaceOptions::new(Order::LINEAR).smooth_angle(0.0))?;
    /// assert!(!graph.smooth_pairs().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn smooth_angle(mut self, radians: f64) -> Self {
        self.smooth_angle = radians;
        self
    }

    /// Says where points go that several sets have in common.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, InterfaceGraph, InterfaceOptions, Order, Overlaps, YinSet};
    /// let square = Curve::polyline(&[[0., 0.], [2., 0.], [2., 2.], [0., 2.], [0., 0.]])?;
    /// let sets = [YinSet::new(&[square.translated([1.0, 1.0])])?, YinSet::new(&[square])?];
    /// let graph = InterfaceGraph::of_sets_with(&sets, &InterfaceOptions::new(Order::LINEAR).overlaps(Overlaps::ToTheLast))?;
    /// assert_eq!((graph.phase_area(0)?, graph.phase_area(1)?), (3.0, 4.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn overlaps(mut self, overlaps: Overlaps) -> Self {
        self.overlaps = overlaps;
        self
    }
}

impl InterfaceGraph {
    /// The interface of sets that lie side by side: set i becomes phase i, and what is in no set is no phase. Options are as in
    /// [`Self::of_sets_with`], and sets that overlap are refused.
    ///
    /// # Errors
    /// As [`Self::of_sets_with`].
    ///
    /// # Examples
    /// Two squares side by side, the right one with a vertex more: the segment between them is one edge.
    /// ```
    /// use coface_yin::{Curve, InterfaceGraph, Order, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let left = Curve::polyline(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.], [0., 0.]])?;
    /// let right = Curve::polyline(&[[1., 0.], [2., 0.], [2., 1.], [1., 1.], [1., 0.5], [1., 0.]])?;
    /// let sets = [YinSet::new(&[left])?, YinSet::new(&[right])?];
    /// let graph = InterfaceGraph::of_sets(&sets, Order::LINEAR, -1.0)?;
    /// assert_eq!((graph.edge_count(), graph.junctions().count()), (3, 2));
    /// assert_eq!(graph.phase_area(1)?, 1.0);
    /// # Ok(()) }
    /// ```
    pub fn of_sets(sets: &[YinSet], order: Order, smooth_angle: f64) -> Result<Self, Error> {
        Self::of_sets_with(sets, &InterfaceOptions { smooth_angle, ..InterfaceOptions::new(order) })
    }

    /// The interface of sets: set i becomes phase i, and what is in no set is no phase.
    ///
    /// The boundaries are laid over each other, so neighbors may have different vertices where they meet. Points where three or more
    /// arcs end become junctions, and kinks of the sets and points where the interface goes from one boundary to another vertices. If
    /// the sets have the order that is asked for and it is 4 or more, edges are parts of their curves bit for bit; else splines through
    /// the knots. At a junction two edges go on smoothly into each other when the way turns by at most an angle there, the ones that turn
    /// least first, whether the sets have kinks there or not.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for sets that overlap, with a place and the area, if that is refused;
    /// for splines that meet where the polylines through their points do not; and if the boundaries cannot be laid over each other.
    ///
    /// # Complexity
    /// That of an overlay of all boundaries.
    ///
    /// # Examples
    /// Of two squares that overlap the first one keeps all of it.
    /// ```
    /// use coface_yin::{Curve, InterfaceGraph, InterfaceOptions, Order, Overlaps, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = Curve::polyline(&[[0., 0.], [2., 0.], [2., 2.], [0., 2.], [0., 0.]])?;
    /// let sets = [YinSet::new(&[square.translated([1.0, 1.0])])?, YinSet::new(&[square])?];
    /// let options = InterfaceOptions::new(Order::LINEAR);
    /// assert!(InterfaceGraph::of_sets_with(&sets, &options).is_err());
    /// let graph = InterfaceGraph::of_sets_with(&sets, &options.overlaps(Overlaps::ToTheFirst))?;
    /// assert_eq!((graph.phase_area(0)?, graph.phase_area(1)?), (4.0, 3.0));
    /// # Ok(()) }
    /// ```
    pub fn of_sets_with(sets: &[YinSet], options: &InterfaceOptions) -> Result<Self, Error> {
        let names: Vec<Option<u32>> = (0..sets.len() as u32).map(Some).collect();
        Self::of_named_sets(&sets.iter().collect::<Vec<_>>(), &names, options)
    }

    /// The same with the number of the phase that each set is, or none. Several sets may be one phase.
    pub(crate) fn of_named_sets(
        sets: &[&YinSet],
        names: &[Option<u32>],
        options: &InterfaceOptions,
    ) -> Result<Self, Error> {
        let InterfaceOptions { order, smooth_angle, overlaps } = *options;
        let partition = Partition::new(sets, names, overlaps)?;
        let points = partition.points();
        let Partition { arcs, curves, around, is_kink, order: own_order } = partition;
        let graph = Self::with_curves(arcs.clone(), curves, own_order, around)?;
        let arcs = Arcs { smooth_pairs: graph.smooth_choices(smooth_angle, &is_kink), ..arcs };
        if order == own_order && order != Order::LINEAR {
            return Self::with_curves(arcs, graph.curves, order, graph.around);
        }
        let fitted = Self::with_points(arcs, &points, &[], order, Some(graph.around))?;
        match fitted.fault()? {
            None => Ok(fitted),
            Some(fault) => {
                Err(fault.into_error().with_cure("give more points, or kinks where boundaries bend"))
            }
        }
    }

    /// A phase as a Yin set, with kinks at the vertices where its boundary does not go on smoothly.
    ///
    /// # Errors
    /// As [`Self::phase_curves`] and [`YinSet::new`]: fitted edges may cross where the polylines through their markers do not.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{InterfaceEdge, InterfaceGraph, Order};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let triangle = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::LINEAR)?.phase_set(0)?;
    /// assert_eq!((triangle.area(), triangle.kinks().len()), (Some(0.5), 1));
    /// # Ok(()) }
    /// ```
    pub fn phase_set(&self, phase: u32) -> Result<YinSet, Error> {
        let mut set = YinSet::new(&self.phase_curves(phase)?)?;
        let kinks = (0..).zip(self.phase_kinks(phase));
        let kinks = kinks.flat_map(|(curve, own)| own.into_iter().map(move |knot| KnotIndex { curve, knot }));
        *set.kinks_mut() = Kinks::new(kinks.collect());
        Ok(set)
    }

    /// For each curve of a phase its knots at vertices through which the boundary does not go on smoothly.
    pub(crate) fn phase_kinks(&self, phase: u32) -> Vec<Vec<u32>> {
        let mut next: Vec<Option<DirectedEdge>> = vec![None; 2 * self.edge_count()];
        for &[from, to] in self.smooth_pairs() {
            next[from.index()] = Some(to);
            next[to.reversed().index()] = Some(from.reversed());
        }
        let kinks_of = |walk: &Vec<DirectedEdge>| {
            let (mut knot, mut kinks) = (0, Vec::new());
            for (at, &edge) in walk.iter().enumerate() {
                let before = walk[(at + walk.len() - 1) % walk.len()];
                if next[before.index()] != Some(edge) {
                    kinks.push(knot);
                }
                knot += self.curve(edge.edge).piece_count() as u32;
            }
            kinks
        };
        self.phase_walks(phase).iter().map(kinks_of).collect()
    }

    /// The pairs of edges that go on into each other: at base points of closed edges, and where the way turns by at most an angle.
    fn smooth_choices(&self, angle: f64, is_kink: &[bool]) -> Vec<[DirectedEdge; 2]> {
        let mut pairs = Vec::new();
        for (vertex, leaving) in self.around.iter().enumerate() {
            if is_kink[vertex] {
                continue;
            }
            if let [a, b] = leaving[..] {
                pairs.push([a.reversed(), b]);
                continue;
            }
            let direction = |edge: DirectedEdge| {
                let controls = self.curves[edge.edge.index()].controls();
                let next = if edge == DirectedEdge::along(edge.edge) {
                    controls[1]
                } else {
                    controls[controls.len() - 2]
                };
                [0, 1].map(|axis| next[axis] - self.vertices[vertex][axis])
            };
            let mut choices: Vec<(f64, usize, usize)> = Vec::new();
            for i in 0..leaving.len() {
                for j in i + 1..leaving.len() {
                    let ([ax, ay], [bx, by]) = (direction(leaving[i]), direction(leaving[j]));
                    // The turn from coming along the first to leaving along the second.
                    let turn = (ay * bx - ax * by).atan2(-(ax * bx + ay * by)).abs();
                    if turn <= angle {
                        choices.push((turn, i, j));
                    }
                }
            }
            choices.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
            let mut is_taken = vec![false; leaving.len()];
            for (_, i, j) in choices {
                if !is_taken[i] && !is_taken[j] {
                    (is_taken[i], is_taken[j]) = (true, true);
                    pairs.push([leaving[i].reversed(), leaving[j]]);
                }
            }
        }
        pairs
    }
}
