//! What bounds the part of a set in a cell.

use super::perimeter::{Place, corners};
use super::{CutArc, CutCell, CutCells};
use crate::{Combination, Curve, Kinks, KnotIndex, Order, YinSet};
use coface_algebra::Error;
use coface_arrange::boolean::InsideRule;

/// A step of a walk around a part of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WalkStep {
    /// Along the boundary of the set: an arc of the cell, by its place among them.
    Arc(usize),
    /// Straight along a side of the cell.
    Side([[f64; 2]; 2]),
}

impl CutCells<'_> {
    /// The closed walks around what of the set is in a cell, the set on their left.
    ///
    /// # Complexity
    /// $O(k \log k)$ for k arcs in the cell.
    ///
    /// # Examples
    /// A triangle cuts off the corner of a unit square.
    /// ```
    /// use coface_yin::{CartesianGrid, Curve, CutCells, WalkStep, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// let cell = cells.cell(1, 0).ok_or(coface_algebra::Error::invalid("no boundary"))?;
    /// let side = WalkStep::Side([[1.0, 1.0], [1.0, 0.0]]);
    /// assert_eq!(cells.walks(cell), [[WalkStep::Arc(0), WalkStep::Arc(1), side]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn walks(&self, cell: &CutCell) -> Vec<Vec<WalkStep>> {
        let arcs = self.arcs(cell);
        let bounds = self.grid().cell_box(cell.column(), cell.row());
        let mut walks: Vec<Vec<WalkStep>> = Vec::new();
        // The chains that come in and go out, as the places of their arcs.
        let mut chains: Vec<Vec<usize>> = Vec::new();
        for chain in chains_of(arcs) {
            if arcs[chain[0]].goes_on {
                walks.push(chain.into_iter().map(WalkStep::Arc).collect());
            } else {
                chains.push(chain);
            }
        }
        let corners = corners(bounds);
        let side = |from: [f64; 2], to: [f64; 2]| (from != to).then_some(WalkStep::Side([from, to]));
        if chains.is_empty() {
            if cell.is_inside {
                walks.push((0..4).filter_map(|at| side(corners[at], corners[(at + 1) % 4])).collect());
            }
            return walks;
        }
        // Where chains begin and end, counterclockwise.
        let mut places: Vec<(Place, usize, bool)> = Vec::with_capacity(2 * chains.len());
        for (number, chain) in chains.iter().enumerate() {
            let [first, last] = [chain[0], chain[chain.len() - 1]].map(|at| &arcs[at]);
            let place = |point, direction| Place::new(bounds, point, direction);
            places.push((place(first.ends[0], self.direction(first, false)), number, true));
            places.push((place(last.ends[1], self.direction(last, true)), number, false));
        }
        places.sort_by(|(a, ..), (b, ..)| a.compare(b));
        let count = places.len();
        let is_begin = |at: usize| places[at % count].2;
        // After the end of each chain the next beginning that is not taken.
        let mut next = vec![(0, 0); chains.len()];
        let mut is_taken = vec![false; count];
        for at in (0..count).filter(|&at| !is_begin(at)) {
            let step = (1..=count)
                .find(|&step| is_begin(at + step) && !is_taken[(at + step) % count])
                .expect("as many chains begin as end");
            is_taken[(at + step) % count] = true;
            next[places[at].1] = (at, step);
        }
        let mut is_done = vec![false; chains.len()];
        for start in 0..chains.len() {
            let mut walk = Vec::new();
            let mut own = start;
            while !is_done[own] {
                is_done[own] = true;
                walk.extend(chains[own].iter().copied().map(WalkStep::Arc));
                let (at, step) = next[own];
                let (from, to) = (&places[at].0, &places[(at + step) % count]);
                own = to.1;
                let mut point = arcs[chains[places[at].1][chains[places[at].1].len() - 1]].ends[1];
                let goal = arcs[chains[own][0]].ends[0];
                // The corners between the two places; all of them when it goes around.
                let turns = (at + step) / count;
                let passed = 4 * turns + to.0.side - from.side;
                for corner in (from.side + 1..=from.side + passed).map(|side| corners[side % 4]) {
                    walk.extend(side(point, corner));
                    point = corner;
                }
                walk.extend(side(point, goal));
            }
            if !walk.is_empty() {
                walks.push(walk);
            }
        }
        walks
    }

    /// The closed curves of the walks around what of the set is in a cell, and for each curve the knots where it need not be smooth.
    ///
    /// # Errors
    /// If a walk is no closed curve: rounding left it without area.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// let cell = cells.cell(1, 0).expect("the boundary runs through it");
    /// assert_eq!(cells.part_curves(cell)?.len(), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn part_curves(&self, cell: &CutCell) -> Result<Vec<(Curve<'static>, Vec<u32>)>, Error> {
        let order = self.set.order();
        let arcs = self.arcs(cell);
        self.walks(cell)
            .iter()
            .map(|walk| {
                let (mut controls, mut knots, mut kinks) = (Vec::new(), Vec::new(), Vec::new());
                let mut length = 0.0f64;
                for (at, step) in walk.iter().enumerate() {
                    let before = &walk[(at + walk.len() - 1) % walk.len()];
                    if !self.is_smooth(arcs, before, step) {
                        kinks.push(at as u32);
                    }
                    let piece = match step {
                        WalkStep::Arc(arc) => arcs[*arc].controls(self.set),
                        WalkStep::Side(ends) => crate::curve::bernstein::straight_piece(*ends, order.value()),
                    };
                    knots.push(length);
                    let [a, b] = [piece[0], piece[order.degree()]];
                    length = (length + (b[0] - a[0]).hypot(b[1] - a[1])).max(length.next_up());
                    controls.extend_from_slice(&piece[..order.degree()]);
                }
                knots.push(length);
                controls.push(controls[0]);
                Ok((Curve::from_controls(order, controls, knots)?, kinks))
            })
            .collect()
    }

    /// What of the set is in a cell, as a set; sides of the cell bound it too, and its kinks are those of the set and the places where
    /// arcs and sides meet.
    ///
    /// # Errors
    /// If rounding at the lines of the grid left curves that bound no set.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// let cell = cells.cell(1, 0).expect("the boundary runs through it");
    /// assert_eq!(cells.part(cell)?.area(), Some(0.5));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn part(&self, cell: &CutCell) -> Result<YinSet, Error> {
        let parts = self.part_curves(cell)?;
        if parts.is_empty() {
            return Ok(YinSet::empty(self.set.order()));
        }
        if self.set.order() == Order::LINEAR {
            let rings: Vec<&[[f64; 2]]> = parts.iter().map(|(curve, _)| curve.controls()).collect();
            return YinSet::from_rings(&rings, InsideRule::Nonzero);
        }
        let curves: Vec<Curve<'_>> = parts.iter().map(|(curve, _)| curve.clone()).collect();
        // Walks that touch themselves or each other at a line are cut and pasted.
        let Ok(mut set) = YinSet::new(&curves) else {
            return YinSet::combine_kinked_curves(&parts, 0, InsideRule::Nonzero).map(Combination::into_set);
        };
        let kinks = (0..)
            .zip(&parts)
            .flat_map(|(curve, (_, kinks))| kinks.iter().map(move |&knot| KnotIndex { curve, knot }));
        *set.kinks_mut() = Kinks::new(kinks.collect());
        Ok(set)
    }

    /// Whether the boundary of the set goes on smoothly from one step to the next.
    fn is_smooth(&self, arcs: &[CutArc], before: &WalkStep, after: &WalkStep) -> bool {
        let (WalkStep::Arc(before), WalkStep::Arc(after)) = (before, after) else { return false };
        let (before, after) = (&arcs[*before], &arcs[*after]);
        let count = self.set.curve(before.curve()).piece_count() as u32;
        if before.curve != after.curve || !after.goes_on {
            return false;
        }
        let is_same = before.piece == after.piece && before.range[1] == after.range[0];
        let knot = KnotIndex { curve: after.curve, knot: after.piece };
        is_same || (before.piece + 1) % count == after.piece && self.set.kinks().vertex(knot).is_none()
    }

    /// The direction from the end of an arc, or from its beginning, along it.
    fn direction(&self, arc: &CutArc, is_end: bool) -> [f64; 2] {
        let mut controls = arc.controls(self.set);
        if is_end {
            controls = controls.reversed();
        }
        let [x, y] = controls[0];
        let next = controls.iter().find(|&&point| point != controls[0]).unwrap_or(&controls[0]);
        [next[0] - x, next[1] - y]
    }
}

/// The arcs of a cell as chains, each from the arc where the boundary comes in; one that never does is a closed curve.
fn chains_of(arcs: &[CutArc]) -> Vec<Vec<usize>> {
    let mut chains: Vec<Vec<usize>> = Vec::new();
    let mut first = 0;
    while first < arcs.len() {
        let curve = arcs[first].curve;
        let end = first + arcs[first..].iter().take_while(|arc| arc.curve == curve).count();
        // A chain can go over the beginning of the curve.
        let start = (first..end).find(|&at| !arcs[at].goes_on).unwrap_or(first);
        let around = (start..end).chain(first..start);
        for (step, at) in around.enumerate() {
            match chains.last_mut() {
                Some(chain) if step > 0 && arcs[at].goes_on => chain.push(at),
                _ => chains.push(vec![at]),
            }
        }
        first = end;
    }
    chains
}
