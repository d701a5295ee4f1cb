//! Which segments come near each other: a uniform grid of cells, refined where many short segments crowd.
//!
//! Each coordinate is mapped to a column or row by a monotone function, and a segment is listed in all cells that its points
//! are mapped to, and a little more. So two segments with a common point are listed in a common cell, whatever is rounded.

use crate::algebra::RaggedArray;
use crate::geometry::predicates::PlanarLine;

/// A part of a cell, added around segments: far above what rounding can do to grid coordinates.
const SLACK: f64 = 1.0 / 16.0;
/// Cells with more segments are refined.
const CROWDED: usize = 64;
/// Cells that are smaller than this part of the coordinates are not refined: rounding would come near the slack.
const FINEST: f64 = 1.0 / (1u64 << 40) as f64;

/// A grid of cells with the segments that pass through each.
pub(super) struct SegmentGrid {
    /// Coordinates are multiplied by this power of two, so that they lie between -1 and 1.
    factor: f64,
    levels: Vec<Level>,
}

struct Level {
    frame: Frame,
    /// The segments of each cell, rising; row after row.
    cells: RaggedArray,
    /// Cells with a finer level, rising, and which.
    finer: Vec<[u32; 2]>,
}

/// How coordinates are mapped to columns (axis 0) and rows (axis 1).
#[derive(Clone, Copy)]
struct Frame {
    origin: [f64; 2],
    /// Cells per unit.
    density: [f64; 2],
    counts: [usize; 2],
}

impl Frame {
    /// The grid coordinates of a point whose coordinates are scaled: cell i goes from i to i + 1.
    fn grid_point(&self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| (point[axis] - self.origin[axis]) * self.density[axis])
    }

    /// The column or row of a grid coordinate.
    fn cell(&self, coordinate: f64, axis: usize) -> usize {
        // A cast sends what is negative to zero.
        (coordinate as usize).min(self.counts[axis] - 1)
    }

    fn cell_number(&self, column: usize, row: usize) -> usize {
        row * self.counts[0] + column
    }

    /// Calls `found` with every cell that a segment passes through, each once. The segment is scaled.
    fn pass(&self, segment: PlanarLine, mut found: impl FnMut(usize)) {
        let [mut p, mut q] = segment.map(|point| self.grid_point(point));
        // Along the axis on which it is longer, the other coordinate changes by no more than one a cell.
        let major = usize::from((q[1] - p[1]).abs() > (q[0] - p[0]).abs());
        let minor = 1 - major;
        if p[major] > q[major] {
            (p, q) = (q, p);
        }
        let length = q[major] - p[major];
        let slope = if length > 0.0 { (q[minor] - p[minor]) / length } else { 0.0 };
        let [lowest, highest] = [p[minor].min(q[minor]), p[minor].max(q[minor])];
        let end = self.counts[major] as f64 + SLACK;
        if q[major] < -SLACK || p[major] > end || highest < -SLACK {
            return;
        }
        if lowest > self.counts[minor] as f64 + SLACK {
            return;
        }
        let [first, last] = [p[major] - SLACK, q[major] + SLACK].map(|at| self.cell(at, major));
        for i in first..=last {
            let at = |coordinate: f64| {
                let along = coordinate.clamp(p[major], q[major]) - p[major];
                (p[minor] + along * slope).clamp(lowest, highest)
            };
            let [a, b] = [at(i as f64 - SLACK), at(i as f64 + 1.0 + SLACK)];
            let [low, high] = [a.min(b) - SLACK, a.max(b) + SLACK];
            if high < 0.0 || low > self.counts[minor] as f64 {
                continue;
            }
            for j in self.cell(low, minor)..=self.cell(high, minor) {
                found(if major == 0 { self.cell_number(i, j) } else { self.cell_number(j, i) });
            }
        }
    }
}

impl SegmentGrid {
    /// A grid for these segments; points are segments of no length.
    pub(super) fn new(segments: &[PlanarLine]) -> Self {
        let coordinates = || segments.iter().map(|line| line.as_flattened());
        let largest = coordinates().flatten().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        // An ordinary number above the largest; its inverse is one too.
        let factor = 2f64.powi(-(largest.max(1e-290).log2().floor() as i32 + 1).clamp(-1020, 1020));
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for (axis, &x) in coordinates().flat_map(|flat| [0, 1, 0, 1].into_iter().zip(flat)) {
            low[axis] = low[axis].min(x * factor);
            high[axis] = high[axis].max(x * factor);
        }
        let mut grid = Self { factor, levels: Vec::new() };
        if !segments.is_empty() {
            let all: Vec<u32> = (0..segments.len() as u32).collect();
            let frame = grid.frame(segments, &all, low, [high[0] - low[0], high[1] - low[1]], 4096.0);
            let level = grid.level(segments, &all, frame);
            grid.levels.push(level);
            grid.refine(segments, 0, 0);
        }
        grid
    }

    /// A frame of about as many cells as segments, but none much smaller than the segments are long.
    fn frame(
        &self,
        segments: &[PlanarLine],
        members: &[u32],
        origin: [f64; 2],
        size: [f64; 2],
        most: f64,
    ) -> Frame {
        let count = members.len() as f64;
        // The longer side of the box around a segment, as a part of the grid, on average.
        let extent = |axis: usize| {
            let lengths = members.iter().map(|&s| {
                let [p, q] = segments[s as usize];
                ((p[axis] * self.factor - q[axis] * self.factor) / size[axis]).abs().min(1.0)
            });
            if size[axis] > 0.0 { lengths.sum::<f64>() / count } else { 0.0 }
        };
        let longest = extent(0).max(extent(1));
        let per_side = |axis: usize| {
            // Square cells, if the region is not too narrow.
            let aspect = (size[axis] / size[1 - axis]).clamp(1.0 / count, count);
            (count * aspect).sqrt().min(4.0 / longest).clamp(1.0, most)
        };
        let mut frame = Frame { origin, density: [0.0; 2], counts: [1; 2] };
        for (axis, &size) in size.iter().enumerate() {
            let sides = if size > 0.0 { per_side(axis).floor() } else { 1.0 };
            let density = sides / size;
            if density.is_finite() {
                frame.density[axis] = density;
                frame.counts[axis] = sides as usize;
            }
        }
        frame
    }

    fn scaled(&self, segment: PlanarLine) -> PlanarLine {
        segment.map(|point| point.map(|x| x * self.factor))
    }

    fn level(&self, segments: &[PlanarLine], members: &[u32], frame: Frame) -> Level {
        let cell_count = frame.counts[0] * frame.counts[1];
        let (mut cells, mut owners) = (Vec::new(), Vec::new());
        for &s in members {
            frame.pass(self.scaled(segments[s as usize]), |cell| {
                cells.push(cell as u32);
                owners.push(s);
            });
        }
        let mut grouped = RaggedArray::grouped(cell_count, cells.iter().copied());
        grouped.items_mut().iter_mut().for_each(|item| *item = owners[*item as usize]);
        Level { frame, cells: grouped, finer: Vec::new() }
    }

    /// Gives crowded cells of a level a finer level, where that spreads the segments.
    fn refine(&mut self, segments: &[PlanarLine], level: usize, depth: usize) {
        let frame = self.levels[level].frame;
        let size = frame.density.map(|density| if density > 0.0 { 1.0 / density } else { 0.0 });
        if depth == 12 || size.iter().all(|&size| size < FINEST) {
            return;
        }
        for cell in 0..self.levels[level].cells.len() {
            let members = self.levels[level].cells.list(cell);
            if members.len() <= CROWDED || size.contains(&0.0) {
                continue;
            }
            let place = [cell % frame.counts[0], cell / frame.counts[0]];
            let corner = [0, 1].map(|axis| frame.origin[axis] + place[axis] as f64 * size[axis]);
            let finer = self.level(segments, members, self.frame(segments, members, corner, size, 64.0));
            let most = finer.cells.iter().map(<[u32]>::len).max().unwrap_or(0);
            // Segments that are long against the cell, or that meet in one point, do not spread.
            if finer.cells.item_count() > 4 * members.len() || most * 10 > members.len() * 9 {
                continue;
            }
            let number = self.levels.len();
            self.levels[level].finer.push([cell as u32, number as u32]);
            self.levels.push(finer);
            self.refine(segments, number, depth + 1);
        }
    }

    /// Calls `found` with lists of segments; every segment that has a point in common with this one is in a list. One
    /// segment can be in many lists.
    pub(super) fn near(&self, segment: PlanarLine, mut found: impl FnMut(&[u32])) {
        if !self.levels.is_empty() {
            self.near_on(0, self.scaled(segment), &mut found);
        }
    }

    fn near_on(&self, level: usize, segment: PlanarLine, found: &mut impl FnMut(&[u32])) {
        let Level { frame, cells, finer } = &self.levels[level];
        let mut inner = Vec::new();
        frame.pass(segment, |cell| match finer.binary_search_by_key(&(cell as u32), |pair| pair[0]) {
            Ok(at) => inner.push(finer[at][1]),
            Err(_) => found(cells.list(cell)),
        });
        for level in inner {
            self.near_on(level as usize, segment, found);
        }
    }

    /// Goes down from a point. `visit` gets lists of segments and gives the height of the highest that it has accepted so
    /// far; segments that cross the vertical line through the point above that height, below the point, have been in a list
    /// when this ends.
    pub(super) fn downward(&self, point: [f64; 2], mut visit: impl FnMut(&[u32]) -> Option<f64>) {
        if !self.levels.is_empty() {
            self.downward_on(0, point.map(|x| x * self.factor), &mut visit);
        }
    }

    /// Whether the search has ended.
    fn downward_on(
        &self,
        level: usize,
        point: [f64; 2],
        visit: &mut impl FnMut(&[u32]) -> Option<f64>,
    ) -> bool {
        let Level { frame, cells, finer } = &self.levels[level];
        let [x, y] = frame.grid_point(point);
        let column = frame.cell(x, 0);
        for row in (0..=frame.cell(y + SLACK, 1)).rev() {
            let cell = frame.cell_number(column, row);
            let highest = match finer.binary_search_by_key(&(cell as u32), |pair| pair[0]) {
                Ok(at) => {
                    if self.downward_on(finer[at][1] as usize, point, visit) {
                        return true;
                    }
                    visit(&[])
                }
                Err(_) => visit(cells.list(cell)),
            };
            let reached = highest.map(|height| frame.grid_point([point[0], height * self.factor])[1]);
            // What is above the bottom of this row, with a margin, has been seen; the lowest row has all below it.
            if reached.is_some_and(|reached| reached > row as f64 + SLACK) {
                return true;
            }
        }
        false
    }
}
