//! The boundary, cut at the lines of a grid.

use super::CartesianGrid;
use crate::YinSet;
use crate::curve::bernstein::{is_straight, value};
use crate::curve::monotone_breaks;
use coface_algebra::progress::stage;
use coface_geometry::predicates::orientation;
use std::cmp::Ordering;

/// A part of the boundary of a set in one cell of a grid, along which both coordinates are monotone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutArc {
    pub(super) cell: [i32; 2],
    pub(super) curve: u32,
    pub(super) piece: u32,
    pub(super) range: [f64; 2],
    pub(super) ends: [[f64; 2]; 2],
    /// How often the boundary comes into the row from the row below at the beginning of the arc, less how often it goes back there
    /// at the end.
    pub(super) rise: i8,
    /// Whether what comes before it on the curve is in the same cell.
    pub(super) goes_on: bool,
}

impl CutArc {
    /// The curve of the set.
    pub fn curve(&self) -> usize {
        self.curve as usize
    }

    /// The piece of the curve.
    pub fn piece(&self) -> usize {
        self.piece as usize
    }

    /// Where on the piece it begins and ends, in [0, 1].
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// The points at which it begins and ends. On lines of the grid they are exactly there.
    pub fn ends(&self) -> [[f64; 2]; 2] {
        self.ends
    }
}

/// The arcs in cells of a grid and left of it, in the order of the curves.
pub(super) fn arcs_of(set: &YinSet, grid: &CartesianGrid) -> Vec<CutArc> {
    let mut kept = Vec::new();
    let mut arcs = Vec::new();
    for own in 0..set.curve_count() {
        let curve = set.curve(own);
        arcs.clear();
        let mut tracer = Tracer { grid, arcs: &mut arcs, curve: own as u32, piece: 0 };
        let steps = stage("cutting a curve along a grid", curve.piece_count());
        for piece in steps.each(0..curve.piece_count()) {
            tracer.piece = piece as u32;
            tracer.piece(curve.piece(piece));
        }
        link(&mut arcs);
        let counts = grid.cell_counts().map(|count| count as i32);
        kept.extend(arcs.iter().filter(|arc| {
            let [column, row] = arc.cell;
            column < counts[0] && 0 <= row && row < counts[1]
        }));
    }
    kept
}

/// Tells the arcs of one curve what comes before and after.
fn link(arcs: &mut [CutArc]) {
    let count = arcs.len();
    for at in 0..count {
        let [before, own, after] = [(at + count - 1) % count, at, (at + 1) % count].map(|at| arcs[at].cell);
        arcs[at].goes_on = before == own;
        arcs[at].rise = i8::from(before[1] < own[1]) - i8::from(after[1] < own[1]);
    }
}

struct Tracer<'a> {
    grid: &'a CartesianGrid,
    arcs: &'a mut Vec<CutArc>,
    curve: u32,
    piece: u32,
}

impl Tracer<'_> {
    fn piece(&mut self, controls: &[[f64; 2]]) {
        let last = controls[controls.len() - 1];
        if is_straight(controls) {
            return self.part(controls, true, [0.0, 1.0], [controls[0], last]);
        }
        let (mut from, mut start) = (0.0, controls[0]);
        for to in monotone_breaks(controls) {
            let end = value(controls, to);
            self.part(controls, false, [from, to], [start, end]);
            (from, start) = (to, end);
        }
        self.part(controls, false, [from, 1.0], [start, last]);
    }

    /// A part of a piece along which both coordinates are monotone.
    fn part(&mut self, controls: &[[f64; 2]], is_straight: bool, range: [f64; 2], ends: [[f64; 2]; 2]) {
        let grid = self.grid;
        let course = [0, 1].map(|axis| {
            let [from, to] = ends.map(|end| end[axis]);
            if from == to { Ordering::Equal } else { from.total_cmp(&to) }
        });
        let mut cell = [0i64; 2];
        let mut goal = [0i64; 2];
        for axis in 0..2 {
            let [from, to] = ends.map(|end| end[axis]);
            [cell[axis], goal[axis]] = match course[axis] {
                Ordering::Less => [grid.after(axis, from), grid.before(axis, to)],
                Ordering::Greater => [grid.before(axis, from), grid.after(axis, to)],
                Ordering::Equal => {
                    // Along a line the cell is that on the left: of a way up the one before, of a way to the right the one after.
                    let is_before = match course[1 - axis] {
                        Ordering::Equal => return,
                        other => (other == Ordering::Less) == (axis == 0),
                    };
                    [if is_before { grid.before(axis, from) } else { grid.after(axis, from) }; 2]
                }
            };
        }
        let steps = course.map(|course| match course {
            Ordering::Less => 1,
            Ordering::Greater => -1,
            Ordering::Equal => 0,
        });
        // The next line across each axis; the end of the part where there is none.
        let next_line = |axis: usize, cell: &[i64; 2]| {
            (cell[axis] != goal[axis])
                .then(|| grid.lines(axis)[(cell[axis] + i64::from(steps[axis] > 0)) as usize])
        };
        let mut at = range[0];
        let mut point = ends[0];
        let mut known: [Option<f64>; 2] = [None; 2];
        loop {
            let lines = [next_line(0, &cell), next_line(1, &cell)];
            let mut parameter = |axis: usize, line: f64| {
                *known[axis].get_or_insert_with(|| {
                    if is_straight {
                        (line - ends[0][axis]) / (ends[1][axis] - ends[0][axis])
                    } else {
                        crossing(controls, axis, line, [at, range[1]], steps[axis] > 0)
                    }
                })
            };
            let first = match lines {
                [None, None] => break,
                [Some(_), None] => Ordering::Less,
                [None, Some(_)] => Ordering::Greater,
                [Some(x), Some(y)] if is_straight => {
                    // A way right and up reaches the vertical line first when the node is on its left.
                    match orientation(ends[0], ends[1], [x, y]) {
                        Ordering::Equal => Ordering::Equal,
                        side if (side == Ordering::Greater) == (steps[0] == steps[1]) => Ordering::Less,
                        _ => Ordering::Greater,
                    }
                }
                [Some(x), Some(y)] => parameter(0, x).total_cmp(&parameter(1, y)),
            };
            let mut to = range[1];
            let mut end = ends[1];
            for axis in 0..2 {
                let is_reached = first == Ordering::Equal || (first == Ordering::Less) == (axis == 0);
                if let Some(line) = lines[axis].filter(|_| is_reached) {
                    to = parameter(axis, line).clamp(at, range[1]);
                    end[axis] = line;
                }
            }
            if first != Ordering::Equal {
                let other = usize::from(first == Ordering::Less);
                let found = if is_straight {
                    let [a, b] = ends.map(|end| end[other]);
                    let rest = 1.0 - to;
                    if to < 0.5 { a + to * (b - a) } else { b - rest * (b - a) }
                } else {
                    value(controls, to)[other]
                };
                // It stays in the cell and goes on.
                let bound = lines[other].unwrap_or(ends[1][other]);
                let [low, high] = [point[other].min(bound), point[other].max(bound)];
                end[other] = found.clamp(low, high);
            }
            self.add(cell, [at, to], [point, end]);
            (at, point) = (to, end);
            for axis in 0..2 {
                let is_reached = first == Ordering::Equal || (first == Ordering::Less) == (axis == 0);
                if is_reached && cell[axis] != goal[axis] {
                    cell[axis] += steps[axis];
                    known[axis] = None;
                }
            }
        }
        self.add(cell, [at, range[1]], [point, ends[1]]);
    }

    fn add(&mut self, cell: [i64; 2], range: [f64; 2], ends: [[f64; 2]; 2]) {
        if ends[0] != ends[1] {
            let cell = cell.map(|at| at as i32);
            let Self { curve, piece, .. } = *self;
            self.arcs.push(CutArc { cell, curve, piece, range, ends, rise: 0, goes_on: false });
        }
    }
}

/// Where a coordinate that is monotone between parameters reaches a value in between, to the nearest numbers or so: by the secant and
/// halving in turns.
fn crossing(
    controls: &[[f64; 2]],
    axis: usize,
    line: f64,
    [mut low, mut high]: [f64; 2],
    rises: bool,
) -> f64 {
    let height = |s: f64| {
        let found = value(controls, s)[axis] - line;
        if rises { found } else { -found }
    };
    let (mut below, mut above) = (height(low), height(high));
    if below >= 0.0 {
        return low;
    }
    if above <= 0.0 {
        return high;
    }
    let mut last_side = Ordering::Equal;
    for _ in 0..200 {
        let secant = low - below * (high - low) / (above - below);
        let middle = if secant > low && secant < high { secant } else { 0.5 * (low + high) };
        if middle <= low || middle >= high {
            break;
        }
        let found = height(middle);
        match found.total_cmp(&0.0) {
            _ if found == 0.0 => return middle,
            Ordering::Less => {
                (low, below) = (middle, found);
                if last_side == Ordering::Less {
                    above *= 0.5;
                }
                last_side = Ordering::Less;
            }
            _ => {
                (high, above) = (middle, found);
                if last_side == Ordering::Greater {
                    below *= 0.5;
                }
                last_side = Ordering::Greater;
            }
        }
    }
    if height(high) < -height(low) { high } else { low }
}
