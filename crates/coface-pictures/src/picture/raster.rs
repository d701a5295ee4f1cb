//! Triangles and lines into pixels, the nearest on top.

use super::canvas::{Canvas, centers};

/// Pixels with depth, finer than the picture by a whole factor.
pub(super) struct Raster {
    pub(super) canvas: Canvas,
    pub(super) depths: Vec<f32>,
    /// What is seen in each pixel; [`NOTHING`] for the background.
    pub(super) seen: Vec<u32>,
}

/// What is seen where nothing is.
pub(super) const NOTHING: u32 = u32::MAX;

/// How a triangle or a line is drawn.
#[derive(Clone, Copy)]
pub(super) struct Ink {
    pub(super) color: u32,
    /// What is then seen.
    pub(super) number: u32,
}

impl Raster {
    pub(super) fn new(width: usize, height: usize, background: u32) -> Self {
        let count = width * height;
        Self {
            canvas: Canvas::new(width, height, background),
            depths: vec![f32::INFINITY; count],
            seen: vec![NOTHING; count],
        }
    }

    /// Draws a triangle of pixels and depths; what is nearer stays.
    pub(super) fn triangle(&mut self, corners: [[f64; 3]; 3], ink: Ink) {
        self.visit(corners, |raster, at, depth| {
            if depth < raster.depths[at] {
                raster.depths[at] = depth;
                raster.canvas.pixels[at] = ink.color;
                raster.seen[at] = ink.number;
            }
        });
    }

    /// Calls back with each pixel whose middle a triangle covers, and the depth there. Triangles with a common side share no pixel.
    pub(super) fn visit(&mut self, corners: [[f64; 3]; 3], mut found: impl FnMut(&mut Self, usize, f32)) {
        let [a, b, c] = corners;
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if !area.is_finite() || area.abs() < 1e-12 {
            return;
        }
        let (db, dc) = (b[2] - a[2], c[2] - a[2]);
        let by_x = (db * (c[1] - a[1]) - dc * (b[1] - a[1])) / area;
        let by_y = (dc * (b[0] - a[0]) - db * (c[0] - a[0])) / area;
        let low = a[1].min(b[1]).min(c[1]);
        let high = a[1].max(b[1]).max(c[1]);
        for row in centers(low, high, self.canvas.height) {
            let y = row as f64 + 0.5;
            let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
            for [p, q] in [[a, b], [b, c], [c, a]] {
                // The lower end first, so that a common side is computed the same from both sides.
                let [p, q] = if (p[1], p[0]) <= (q[1], q[0]) { [p, q] } else { [q, p] };
                if p[1] <= y && y < q[1] {
                    let x = p[0] + (q[0] - p[0]) * ((y - p[1]) / (q[1] - p[1]));
                    left = left.min(x);
                    right = right.max(x);
                }
            }
            let columns = centers(left, right, self.canvas.width);
            let start = row * self.canvas.width;
            let mut depth = a[2] + by_x * (columns.start as f64 + 0.5 - a[0]) + by_y * (y - a[1]);
            for column in columns {
                found(self, start + column, depth as f32);
                depth += by_x;
            }
        }
    }

    /// Draws a line of a width in pixels.
    pub(super) fn line(&mut self, ends: [[f64; 3]; 2], width: f64, ink: Ink) {
        if let Some(corners) = band(ends, width) {
            self.triangle([corners[0], corners[1], corners[2]], ink);
            self.triangle([corners[0], corners[2], corners[3]], ink);
        }
    }

    /// Mixes a line into what is there, whatever its depth; what has the number of the ink already stays.
    pub(super) fn faint_line(&mut self, ends: [[f64; 3]; 2], width: f64, ink: Ink, share: u32) {
        let Some(corners) = band(ends, width) else { return };
        for triangle in [[corners[0], corners[1], corners[2]], [corners[0], corners[2], corners[3]]] {
            self.visit(triangle, |raster, at, _| {
                if raster.seen[at] != ink.number {
                    raster.seen[at] = ink.number;
                    raster.canvas.mix(at, ink.color, share);
                }
            });
        }
    }

    /// Draws a disk of a diameter in pixels.
    pub(super) fn disk(&mut self, center: [f64; 3], diameter: f64, ink: Ink) {
        let around = |i: u32| {
            let angle = f64::from(i) * std::f64::consts::TAU / 16.0;
            [center[0] + 0.5 * diameter * angle.cos(), center[1] + 0.5 * diameter * angle.sin(), center[2]]
        };
        (0..16).for_each(|i| self.triangle([center, around(i), around(i + 1)], ink));
    }
}

/// The corners of a line with a width, around; ends are square.
fn band([a, b]: [[f64; 3]; 2], width: f64) -> Option<[[f64; 3]; 4]> {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let length = dx.hypot(dy);
    if !length.is_finite() {
        return None;
    }
    let half = 0.5 * width;
    let (along, across) = if length > 0.0 {
        ([dx / length * half, dy / length * half], [-dy / length * half, dx / length * half])
    } else {
        ([half, 0.0], [0.0, half])
    };
    let corner = |p: [f64; 3], forward: f64, side: f64| {
        [p[0] + forward * along[0] + side * across[0], p[1] + forward * along[1] + side * across[1], p[2]]
    };
    Some([corner(a, -1.0, 1.0), corner(a, -1.0, -1.0), corner(b, 1.0, -1.0), corner(b, 1.0, 1.0)])
}

#[cfg(test)]
mod tests {
    use super::*;

    const INK: Ink = Ink { color: 1, number: 0 };

    #[test]
    fn the_nearer_of_two_triangles_is_seen_whatever_their_order() {
        let near = [[0.0, 0.0, 1.0], [10.0, 0.0, 1.0], [0.0, 10.0, 1.0]];
        // Tilted: in front on the left, behind on the right.
        let tilted = [[0.0, 0.0, 0.0], [10.0, 0.0, 3.0], [0.0, 10.0, 0.0]];
        let draw = |order: [([[f64; 3]; 3], u32); 2]| {
            let mut raster = Raster::new(10, 10, 0);
            order.into_iter().for_each(|(corners, number)| raster.triangle(corners, Ink { number, ..INK }));
            raster.seen
        };
        let seen = draw([(near, 0), (tilted, 1)]);
        assert_eq!(seen, draw([(tilted, 1), (near, 0)]));
        assert_eq!((seen[0], seen[8], seen[99]), (1, 0, NOTHING));
    }

    #[test]
    fn triangles_with_a_common_side_cover_a_square_once() {
        let mut counts = vec![0; 400];
        let [a, b, c, d] = [[1.3, 1.7, 0.0], [18.2, 2.9, 0.0], [17.1, 18.8, 0.0], [2.5, 16.4, 0.0]];
        let mut raster = Raster::new(20, 20, 0);
        for triangle in [[a, b, c], [c, d, a]] {
            raster.visit(triangle, |_, at, _| counts[at] += 1);
        }
        assert!(counts.iter().all(|&count| count < 2) && counts[10 * 20 + 10] == 1);
        let covered: i32 = counts.iter().sum();
        // The area by the formula of shoelaces.
        let area: f64 =
            [[a, b], [b, c], [c, d], [d, a]].iter().map(|[p, q]| 0.5 * (p[0] * q[1] - p[1] * q[0])).sum();
        assert!((f64::from(covered) - area).abs() < 8.0, "{covered} {area}");
    }
}
