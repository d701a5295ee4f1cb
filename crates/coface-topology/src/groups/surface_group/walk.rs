//! Walks in a system of quads, kept shortest and rightmost.

use super::quad_system::{Hub, QuadSystem};
use coface_algebra::Sign;

/// The rightmost of the shortest walks between two vertices of the universal cover of a system of quads, built edge
/// by edge from a start.
///
/// A walk is shortest if it has no **spur** (turn 0) and no **bracket** (turns 1 2 ... 2 1 or -1 -2 ... -2 -1), and
/// rightmost if it has no turn 1 either. All degrees are at least 5, so two shortest walks with the same ends bound
/// strips of quadrangles without an inner vertex, and where they part the left one has a turn 1: the rightmost is
/// unique.
///
/// # Complexity
/// Amortized constant time an edge: turns are stored by runs of equal ones.
#[derive(Clone, Debug)]
pub(super) struct Walk<'a> {
    quads: &'a QuadSystem,
    start: Hub,
    start_orientation: Sign,
    end: Hub,
    end_orientation: Sign,
    /// The first and the last edge, if there is one.
    first: u32,
    last: u32,
    length: usize,
    /// Turns with the number of times they follow each other.
    runs: Vec<(u32, u32)>,
}

impl<'a> Walk<'a> {
    /// The walk without edges at a hub, with the orientation there relative to the hub's own.
    pub(super) fn new(quads: &'a QuadSystem, start: Hub, orientation: Sign) -> Self {
        Self {
            quads,
            start,
            start_orientation: orientation,
            end: start,
            end_orientation: orientation,
            first: 0,
            last: 0,
            length: 0,
            runs: Vec::new(),
        }
    }

    /// Goes on along an edge.
    pub(super) fn push(&mut self, edge: u32) {
        if self.length == 0 {
            self.first = edge;
            self.extend(edge);
            return;
        }
        let turn = self.quads.turn(self.end, self.end_orientation, self.last, edge);
        let minus_one = self.quads.degree() - 1;
        if turn == 0 {
            self.pop();
        } else if turn == 1 {
            self.extend(edge);
            self.flip();
        } else if turn == minus_one {
            self.extend(edge);
            if !self.shorten() {
                self.push_turns(turn, 1);
            }
        } else {
            self.extend(edge);
            self.push_turns(turn, 1);
        }
    }

    fn extend(&mut self, edge: u32) {
        self.last = edge;
        self.length += 1;
        self.end = self.end.other();
        self.end_orientation = self.end_orientation.times(self.quads.sign(edge));
    }

    /// Takes the last edge away.
    fn pop(&mut self) {
        self.end = self.end.other();
        self.end_orientation = self.end_orientation.times(self.quads.sign(self.last));
        self.length -= 1;
        if let Some((turn, count)) = self.runs.last_mut() {
            self.last =
                self.quads.turned(self.end, self.end_orientation, self.last, self.quads.degree() - *turn);
            *count -= 1;
            if *count == 0 {
                self.runs.pop();
            }
        }
    }

    fn push_turns(&mut self, turn: u32, count: u32) {
        match self.runs.last_mut() {
            _ if count == 0 => {}
            Some((last, own)) if *last == turn => *own += count,
            _ => self.runs.push((turn, count)),
        }
    }

    /// Takes the run of this turn at the end away and gives its length.
    fn pop_run(&mut self, turn: u32) -> u32 {
        match self.runs.last() {
            Some(&(last, count)) if last == turn => {
                self.runs.pop();
                count
            }
            _ => 0,
        }
    }

    /// Changes the last turn by 1 or -1 = d - 1; before the first turn, the first edge.
    fn change_last_turn(&mut self, change: u32) {
        match self.runs.last_mut() {
            Some((turn, count)) => {
                let changed = (*turn + change) % self.quads.degree();
                *count -= 1;
                if *count == 0 {
                    self.runs.pop();
                }
                self.push_turns(changed, 1);
            }
            None => {
                self.first = self.quads.turned(self.start, self.start_orientation, self.first, change);
            }
        }
    }

    /// Moves the end ... x 2 ... 2 1 across the quadrangles on its right: x-1 -1 -2 ... -2. The turn 1 is not yet
    /// stored.
    fn flip(&mut self) {
        let degree = self.quads.degree();
        let count = self.pop_run(2);
        self.change_last_turn(degree - 1);
        self.push_turns(degree - 1, 1);
        self.push_turns(degree - 2, count);
        self.last = self.quads.turned(self.end, self.end_orientation, self.last, 1);
    }

    /// Replaces an end ... x -1 -2 ... -2 -1 by x+1 2 ... 2; false if it is not like that. The last -1 is not yet
    /// stored.
    fn shorten(&mut self) -> bool {
        let degree = self.quads.degree();
        let count = self.pop_run(degree - 2);
        let Some((turn, ones)) = self.runs.last_mut().filter(|(turn, _)| *turn == degree - 1) else {
            self.push_turns(degree - 2, count);
            return false;
        };
        debug_assert_eq!((*turn, *ones), (degree - 1, 1), "two turns -1 in a row are a bracket");
        self.runs.pop();
        self.change_last_turn(1);
        self.push_turns(2, count);
        self.length -= 2;
        self.last = self.quads.turned(self.end, self.end_orientation, self.last, degree - 1);
        debug_assert!(self.length > 1 || self.first == self.last);
        true
    }

    /// The edges in order.
    pub(super) fn edges(&self) -> Vec<u32> {
        let mut edges = Vec::with_capacity(self.length);
        if self.length == 0 {
            return edges;
        }
        let (mut hub, mut orientation, mut edge) = (self.start, self.start_orientation, self.first);
        edges.push(edge);
        for &(turn, count) in &self.runs {
            for _ in 0..count {
                orientation = orientation.times(self.quads.sign(edge));
                hub = hub.other();
                edge = self.quads.turned(hub, orientation, edge, turn);
                edges.push(edge);
            }
        }
        debug_assert_eq!(edges.len(), self.length);
        debug_assert_eq!(edges.last(), Some(&self.last));
        edges
    }
}
