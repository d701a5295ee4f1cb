//! Triangles into pixels, the nearest on top.

use super::palette::Color;

/// Pixels with color and depth, finer than the picture by a whole factor.
pub(super) struct Raster {
    pub(super) width: usize,
    pub(super) height: usize,
    colors: Vec<Color>,
    pub(super) depths: Vec<f32>,
    /// What is seen in each pixel; [`NOTHING`] for the background.
    pub(super) seen: Vec<u32>,
}

/// What is seen where nothing is.
pub(super) const NOTHING: u32 = u32::MAX;

impl Raster {
    pub(super) fn new(width: usize, height: usize, background: Color) -> Self {
        let count = width * height;
        Self {
            width,
            height,
            colors: vec![background; count],
            depths: vec![f32::INFINITY; count],
            seen: vec![NOTHING; count],
        }
    }

    /// Draws a triangle of pixels and depths; what is nearer stays.
    pub(super) fn triangle(&mut self, corners: [[f64; 3]; 3], color: Color, number: u32) {
        let [a, b, c] = corners;
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if !area.is_finite() || area == 0.0 {
            return;
        }
        let bounds = |axis: usize, end: usize| {
            let low = a[axis].min(b[axis]).min(c[axis]).floor().clamp(0.0, end as f64) as usize;
            let high = a[axis].max(b[axis]).max(c[axis]).ceil().clamp(0.0, end as f64) as usize;
            low..high
        };
        let columns = bounds(0, self.width);
        for row in bounds(1, self.height) {
            let y = row as f64 + 0.5;
            for column in columns.clone() {
                let x = column as f64 + 0.5;
                let part = |p: [f64; 3], q: [f64; 3]| {
                    ((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])) / area
                };
                let (of_a, of_b) = (part(b, c), part(c, a));
                let of_c = 1.0 - of_a - of_b;
                if of_a < 0.0 || of_b < 0.0 || of_c < 0.0 {
                    continue;
                }
                let depth = (of_a * a[2] + of_b * b[2] + of_c * c[2]) as f32;
                let pixel = row * self.width + column;
                if depth < self.depths[pixel] {
                    self.depths[pixel] = depth;
                    self.colors[pixel] = color;
                    self.seen[pixel] = number;
                }
            }
        }
    }

    /// Draws a line of a width in pixels.
    pub(super) fn line(&mut self, [a, b]: [[f64; 3]; 2], width: f64, color: Color) {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypot(dy);
        let half = 0.5 * width;
        let (along, across) = if length > 0.0 {
            ([dx / length * half, dy / length * half], [-dy / length * half, dx / length * half])
        } else {
            ([half, 0.0], [0.0, half])
        };
        let corner = |p: [f64; 3], forward: f64, side: f64| {
            [p[0] + forward * along[0] + side * across[0], p[1] + forward * along[1] + side * across[1], p[2]]
        };
        let corners =
            [corner(a, -1.0, 1.0), corner(a, -1.0, -1.0), corner(b, 1.0, -1.0), corner(b, 1.0, 1.0)];
        self.triangle([corners[0], corners[1], corners[2]], color, NOTHING);
        self.triangle([corners[0], corners[2], corners[3]], color, NOTHING);
    }

    /// Draws a disk of a diameter in pixels.
    pub(super) fn disk(&mut self, center: [f64; 3], diameter: f64, color: Color) {
        let around = |i: u32| {
            let angle = f64::from(i) * std::f64::consts::TAU / 16.0;
            [center[0] + 0.5 * diameter * angle.cos(), center[1] + 0.5 * diameter * angle.sin(), center[2]]
        };
        (0..16).for_each(|i| self.triangle([center, around(i), around(i + 1)], color, NOTHING));
    }

    /// The picture as bytes of red, green and blue, each pixel the mean of `factor` by `factor` of these.
    pub(super) fn shrunk(&self, factor: usize) -> Vec<u8> {
        let (width, height) = (self.width / factor, self.height / factor);
        let mut bytes = Vec::with_capacity(3 * width * height);
        for row in 0..height {
            for column in 0..width {
                let mut sum = [0.0f32; 3];
                for inner in 0..factor * factor {
                    let at = (row * factor + inner / factor) * self.width + column * factor + inner % factor;
                    (0..3).for_each(|part| sum[part] += self.colors[at][part]);
                }
                bytes.extend(
                    sum.map(|part| (part / (factor * factor) as f32 * 255.0).round().clamp(0.0, 255.0) as u8),
                );
            }
        }
        bytes
    }
}
