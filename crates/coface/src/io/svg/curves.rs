//! Curves as chords, and the corners of subpaths.

use super::transformation::Transformation;

/// More chords than these for one curve are refused.
const MOST_CHORDS: f64 = 1e6;

/// A subpath: its corners, transformed, and whether it is closed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Subpath {
    pub(super) corners: Vec<[f64; 2]>,
    pub(super) is_closed: bool,
}

/// Why a curve has no chords.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Fault {
    /// A curve without a tolerance.
    Curve,
    /// Anything else, in words.
    Text(String),
}

impl From<String> for Fault {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

/// Subpaths while they are drawn.
pub(super) struct Pen {
    pub(super) map: Transformation,
    /// The farthest that chords may be from their curve.
    pub(super) tolerance: Option<f64>,
    pub(super) subpaths: Vec<Subpath>,
    /// Where the pen is, before the transformation.
    pub(super) at: [f64; 2],
    start: [f64; 2],
    is_drawing: bool,
}

impl Pen {
    pub(super) fn new(map: Transformation, tolerance: Option<f64>) -> Self {
        Self { map, tolerance, subpaths: Vec::new(), at: [0.0; 2], start: [0.0; 2], is_drawing: false }
    }

    /// Lifts the pen and puts it down here.
    pub(super) fn move_to(&mut self, to: [f64; 2]) {
        self.is_drawing = false;
        (self.at, self.start) = (to, to);
    }

    pub(super) fn line_to(&mut self, to: [f64; 2]) {
        self.begin();
        self.push(self.map.point(to));
        self.at = to;
    }

    /// Closes the subpath; the pen is where it began.
    pub(super) fn close(&mut self) {
        if self.is_drawing
            && let Some(subpath) = self.subpaths.last_mut()
        {
            subpath.is_closed = true;
        }
        self.is_drawing = false;
        self.at = self.start;
    }

    fn begin(&mut self) {
        if !self.is_drawing {
            self.subpaths.push(Subpath { corners: vec![self.map.point(self.at)], is_closed: false });
            self.is_drawing = true;
            self.start = self.at;
        }
    }

    fn push(&mut self, corner: [f64; 2]) {
        if let Some(subpath) = self.subpaths.last_mut() {
            subpath.corners.push(corner);
        }
    }

    /// A Bezier curve of degree 2 or 3 by its control points behind the first.
    ///
    /// Chords between points at equal steps of the parameter are within an eighth of the square of the step times the greatest
    /// second derivative.
    pub(super) fn curve_to(&mut self, controls: &[[f64; 2]]) -> Result<(), Fault> {
        let to = controls.last().copied().unwrap_or(self.at);
        let points: Vec<[f64; 2]> =
            [self.at].iter().chain(controls).map(|&control| self.map.point(control)).collect();
        let bends = points.windows(3).map(|p| {
            let bend = |axis: usize| p[0][axis] - 2.0 * p[1][axis] + p[2][axis];
            bend(0).hypot(bend(1))
        });
        let degree = controls.len() as f64;
        let bend = degree * (degree - 1.0) * bends.fold(0.0, f64::max);
        let count = self.chord_count(bend)?;
        self.begin();
        for i in 1..count {
            let t = i as f64 / count as f64;
            let mut level = points.clone();
            while level.len() > 1 {
                for j in 0..level.len() - 1 {
                    let next = level[j + 1];
                    level[j] = [0, 1].map(|axis| level[j][axis] * (1.0 - t) + next[axis] * t);
                }
                level.pop();
            }
            self.push(level[0]);
        }
        self.push(self.map.point(to));
        self.at = to;
        Ok(())
    }

    /// How many chords of equal steps from 0 to 1 are near enough to a curve with at most this second derivative.
    fn chord_count(&self, bend: f64) -> Result<usize, Fault> {
        let tolerance = self.tolerance.ok_or(Fault::Curve)?;
        let count = (bend / (8.0 * tolerance)).sqrt().ceil().max(1.0);
        if count <= MOST_CHORDS {
            return Ok(count as usize);
        }
        Err(Fault::Text(format!("a curve takes {count:.0} chords to be within {tolerance}")))
    }

    /// The part of an ellipse with this center and half axes from one angle (of the circle that it is the image of) to another.
    /// `to` is where it ends, unless it is the whole ellipse.
    fn ellipse(
        &mut self,
        center: [f64; 2],
        axes: [[f64; 2]; 2],
        [from, sweep]: [f64; 2],
        to: Option<[f64; 2]>,
    ) -> Result<(), Fault> {
        let [u, v] = axes.map(|axis| self.map.direction(axis));
        // The square of the longest half axis of the image is the larger eigenvalue of the products of these two.
        let product = |p: [f64; 2], q: [f64; 2]| p[0] * q[0] + p[1] * q[1];
        let (uu, vv, uv) = (product(u, u), product(v, v), product(u, v));
        let reach = f64::midpoint(uu + vv, (uu - vv).hypot(2.0 * uv)).sqrt();
        let least = if to.is_none() { 3 } else { 1 };
        let count = self.chord_count(reach * sweep * sweep)?.max(least);
        let center = self.map.point(center);
        let place = |i: usize| {
            let (sine, cosine) = (from + sweep * i as f64 / count as f64).sin_cos();
            [0, 1].map(|axis| center[axis] + cosine * u[axis] + sine * v[axis])
        };
        match to {
            None => {
                let corners = (0..count).map(place).collect();
                self.subpaths.push(Subpath { corners, is_closed: true });
            }
            Some(to) => {
                self.begin();
                for i in 1..count {
                    self.push(place(i));
                }
                self.push(self.map.point(to));
                self.at = to;
            }
        }
        Ok(())
    }

    /// A whole ellipse along the axes, as a subpath of its own.
    pub(super) fn whole_ellipse(&mut self, center: [f64; 2], radii: [f64; 2]) -> Result<(), Fault> {
        self.is_drawing = false;
        self.ellipse(center, [[radii[0], 0.0], [0.0, radii[1]]], [0.0, std::f64::consts::TAU], None)
    }

    /// An arc of an ellipse that is turned by an angle in degrees.
    ///
    /// # References
    /// W3C, *Scalable Vector Graphics (SVG) 2*, appendix B.2: from end points to centers.
    pub(super) fn arc_to(
        &mut self,
        radii: [f64; 2],
        angle: f64,
        is_large: bool,
        is_positive: bool,
        to: [f64; 2],
    ) -> Result<(), Fault> {
        let [mut rx, mut ry] = radii.map(f64::abs);
        let from = self.at;
        if from == to {
            return Ok(());
        }
        if rx == 0.0 || ry == 0.0 {
            self.line_to(to);
            return Ok(());
        }
        let turn = Transformation::rotation(angle);
        let back = Transformation::rotation(-angle);
        // Half the chord in the frame of the ellipse.
        let [x, y] = back.direction([(from[0] - to[0]) / 2.0, (from[1] - to[1]) / 2.0]);
        let stretch = (x / rx).hypot(y / ry);
        if stretch > 1.0 {
            // The ellipse is too small to reach: it grows until it does.
            (rx, ry) = (rx * stretch, ry * stretch);
        }
        // On the unit circle: the chord's half, and the distance of its middle from the center.
        let [p, q] = [x / rx, y / ry];
        let half = p.hypot(q).min(1.0);
        let height = ((1.0 - half) * (1.0 + half)).max(0.0).sqrt();
        let side = if is_large == is_positive { -1.0 } else { 1.0 };
        let [cx, cy] =
            if half > 0.0 { [side * height * q / half, -side * height * p / half] } else { [0.0; 2] };
        let start = (q - cy).atan2(p - cx);
        let end = (-q - cy).atan2(-p - cx);
        let mut sweep = end - start;
        if is_positive && sweep < 0.0 {
            sweep += std::f64::consts::TAU;
        } else if !is_positive && sweep > 0.0 {
            sweep -= std::f64::consts::TAU;
        }
        let [dx, dy] = turn.direction([cx * rx, cy * ry]);
        let center = [f64::midpoint(from[0], to[0]) + dx, f64::midpoint(from[1], to[1]) + dy];
        let axes = [turn.direction([rx, 0.0]), turn.direction([0.0, ry])];
        self.ellipse(center, axes, [start, sweep], Some(to))
    }
}
