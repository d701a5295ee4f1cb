//! What nothing hides.

use super::raster::Raster;

/// The shortest part of a partly hidden line that is seen, in pixels of the picture.
const PEEK: f64 = 3.0;

/// What can be seen past the triangles of a picture.
pub(super) struct Sight<'a> {
    pub(super) raster: &'a Raster,
    /// Pixels of the raster to one of the picture.
    pub(super) factor: f64,
    /// So much behind a triangle, a line on it still counts as in front.
    pub(super) slack: f64,
}

impl Sight<'_> {
    /// Calls back with the parts of a line, and whether each is seen.
    pub(super) fn parts(&self, [a, b]: [[f64; 3]; 2], mut found: impl FnMut([[f64; 3]; 2], bool)) {
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let steps = (length * self.factor).ceil().clamp(1.0, 1e5) as usize;
        let along = |step: usize| {
            let share = step as f64 / steps as f64;
            [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]))
        };
        // The middle of each step tells; ends may lie on the rim of what hides nothing.
        let middle = |step: usize| {
            let share = (step as f64 + 0.5) / steps as f64;
            [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]))
        };
        let mut runs: Vec<(usize, bool)> = Vec::new();
        for step in 0..steps {
            let is_seen = self.is_seen(middle(step));
            match runs.last_mut() {
                Some((end, state)) if *state == is_seen => *end = step + 1,
                _ => runs.push((step + 1, is_seen)),
            }
        }
        // What peeks out for less than this is the rim of what hides it.
        let least = (PEEK * self.factor).ceil() as usize;
        let mut start = 0;
        let is_whole = runs.len() == 1;
        for (end, is_seen) in &mut runs {
            *is_seen &= is_whole || *end - start >= least;
            start = *end;
        }
        start = 0;
        for run in runs.chunk_by(|a, b| a.1 == b.1) {
            let end = run[run.len() - 1].0;
            found([along(start), if end == steps { b } else { along(end) }], run[0].1);
            start = end;
        }
    }

    /// Whether a place is in front of what is drawn in its pixel or in one beside it.
    pub(super) fn is_seen(&self, [x, y, depth]: [f64; 3]) -> bool {
        let (column, row) = ((x * self.factor).floor() as i64, (y * self.factor).floor() as i64);
        let (width, height) = (self.raster.canvas.width as i64, self.raster.canvas.height as i64);
        for row in row - 1..=row + 1 {
            for column in column - 1..=column + 1 {
                if !(0..width).contains(&column) || !(0..height).contains(&row) {
                    return true;
                }
                let front = self.raster.depths[(row * width + column) as usize];
                if depth - self.slack <= f64::from(front) {
                    return true;
                }
            }
        }
        false
    }
}

/// A place in a raster that is finer by a factor.
pub(super) fn finer([x, y, depth]: [f64; 3], factor: usize) -> [f64; 3] {
    [factor as f64 * x, factor as f64 * y, depth]
}
