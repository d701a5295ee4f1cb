//! Curves as chords or as cubics, and the corners of subpaths.

use super::transformation::Transformation;
use coface_arrange::boolean::InsideRule;

/// More chords than these for one curve are refused.
const MOST_CHORDS: f64 = 1e6;
/// More for one element are refused too.
const MOST_IN_ALL: usize = 1 << 22;
/// A number on the way is beyond the largest that there is.
const BEYOND: &str = "a curve goes beyond the numbers of double precision";

/// Arcs that are kept as cubics are within this part of their longer half axis of them.
const ARC_PRECISION: f64 = 1e-9;

/// A subpath: its corners, transformed, and whether it is closed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Subpath {
    pub(super) corners: Vec<[f64; 2]>,
    pub(super) is_closed: bool,
    /// The sides that are cubics, where curves are kept: the number of each, and its two inner control points.
    pub(super) cubics: Vec<(usize, [[f64; 2]; 2])>,
    /// How far cubics are at most from the arcs that they stand for.
    pub(super) arc_error: f64,
}

/// What becomes of curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Curves {
    /// Chords that are within this length.
    Chords(f64),
    /// Cubics between corners.
    Kept,
}

impl Subpath {
    /// Whether it may have something inside where it is filled, once it is closed.
    pub(super) fn may_fill(&self) -> bool {
        let mut corners = self.corners.clone();
        corners.dedup();
        self.is_closed || !self.cubics.is_empty() || corners.len() > 2
    }

    /// Whether it comes back to where it began: by Z, or as a path whose last corner is its first. A polyline is a line.
    pub(super) fn comes_back(&self, element: &str) -> bool {
        let least = if self.cubics.is_empty() { 4 } else { 2 };
        self.is_closed
            || element == "path" && self.corners.len() >= least && self.corners.first() == self.corners.last()
    }

    /// The corners, and the inner control points of cubics.
    pub(super) fn controls(&self) -> impl Iterator<Item = &[f64; 2]> {
        self.corners.iter().chain(self.cubics.iter().flat_map(|(_, inner)| inner))
    }

    pub(super) fn is_finite(&self) -> bool {
        self.controls().flatten().all(|x| x.is_finite())
    }

    /// Extends a box, given by its lowest and its highest corner, so that it holds the subpath.
    pub(super) fn extend(&self, bounds: &mut [[f64; 2]; 2]) {
        let mut include = |axis: usize, x: f64| {
            bounds[0][axis] = bounds[0][axis].min(x);
            bounds[1][axis] = bounds[1][axis].max(x);
        };
        for corner in &self.corners {
            (0..2).for_each(|axis| include(axis, corner[axis]));
        }
        for &(side, [first, second]) in &self.cubics {
            let (from, to) = (self.corners[side], self.corners[side + 1]);
            for axis in 0..2 {
                let [p, q, r, s] = [from, first, second, to].map(|point| point[axis]);
                // A third of the derivative is a t^2 + 2 b t + c.
                let (a, b, c) = (s - p + 3.0 * (q - r), p - 2.0 * q + r, q - p);
                let root = (b * b - a * c).sqrt();
                for t in [(-b + root) / a, (-b - root) / a, -c / (2.0 * b)] {
                    if t > 0.0 && t < 1.0 {
                        let u = 1.0 - t;
                        include(
                            axis,
                            u * u * u * p + 3.0 * u * u * t * q + 3.0 * u * t * t * r + t * t * t * s,
                        );
                    }
                }
            }
        }
    }
}

/// Subpaths while they are drawn.
pub(super) struct Pen {
    pub(super) map: Transformation,
    curves: Curves,
    pub(super) subpaths: Vec<Subpath>,
    /// Where the pen is, before the transformation.
    pub(super) at: [f64; 2],
    start: [f64; 2],
    is_drawing: bool,
    /// How far the ends of its lines and curves are at most from the origin along an axis, and how many there are.
    reach: f64,
    end_count: usize,
    /// The chords of its curves.
    chord_count: usize,
}

impl Pen {
    pub(super) fn new(map: Transformation, curves: Curves) -> Self {
        Self {
            map,
            curves,
            subpaths: Vec::new(),
            at: [0.0; 2],
            start: [0.0; 2],
            is_drawing: false,
            reach: 0.0,
            end_count: 0,
            chord_count: 0,
        }
    }

    /// Lifts the pen and puts it down here.
    pub(super) fn move_to(&mut self, to: [f64; 2]) {
        self.is_drawing = false;
        (self.at, self.start) = (to, to);
    }

    pub(super) fn line_to(&mut self, to: [f64; 2]) {
        let to = self.end(to);
        self.begin();
        self.push_line(self.map.point(to));
        self.at = to;
    }

    /// Where a line or curve ends: where the subpath began if this is all that rounding tells from it.
    ///
    /// Distances from one point to the next are added up, so an end may be farther from where it should be by half a unit in the
    /// last place of the largest coordinate for each point before it; the numbers themselves have that error once more.
    fn end(&mut self, to: [f64; 2]) -> [f64; 2] {
        let start = if self.is_drawing { self.start } else { self.at };
        if !self.is_drawing {
            (self.reach, self.end_count) = (0.0, 1);
        }
        self.end_count += 1;
        self.reach = [start, to].as_flattened().iter().fold(self.reach, |reach, x| reach.max(x.abs()));
        let error = self.end_count as f64 * f64::EPSILON * self.reach;
        if (0..2).all(|axis| (to[axis] - start[axis]).abs() <= error) { start } else { to }
    }

    /// Closes the subpath; the pen is where it began.
    pub(super) fn close(&mut self) {
        if self.is_drawing
            && let Some(subpath) = self.subpaths.last_mut()
        {
            subpath.is_closed = true;
            let [first, last] = [subpath.corners[0], subpath.corners[subpath.corners.len() - 1]];
            if self.curves == Curves::Kept && first != last {
                self.push_line(first);
            }
        }
        self.is_drawing = false;
        self.at = self.start;
    }

    fn begin(&mut self) {
        if !self.is_drawing {
            self.subpaths.push(Subpath { corners: vec![self.map.point(self.at)], ..Subpath::default() });
            self.is_drawing = true;
            self.start = self.at;
        }
    }

    fn push(&mut self, corner: [f64; 2]) {
        if let Some(subpath) = self.subpaths.last_mut() {
            subpath.corners.push(corner);
        }
    }

    /// A line to a corner. One without length is left out where curves are kept.
    fn push_line(&mut self, to: [f64; 2]) {
        let from = self.subpaths.last().and_then(|subpath| subpath.corners.last());
        if self.curves != Curves::Kept || from != Some(&to) {
            self.push(to);
        }
    }

    /// A cubic by its control points behind the first. One that comes back to its beginning is divided in the middle.
    fn push_cubic(&mut self, controls: [[f64; 2]; 3], arc_error: f64) {
        let Some(subpath) = self.subpaths.last_mut() else { return };
        let Some(&from) = subpath.corners.last() else { return };
        let [first, second, end] = controls;
        subpath.arc_error = subpath.arc_error.max(arc_error);
        if from != end {
            subpath.cubics.push((subpath.corners.len() - 1, [first, second]));
            return subpath.corners.push(end);
        }
        let middle = |a: [f64; 2], b: [f64; 2]| [0, 1].map(|axis| f64::midpoint(a[axis], b[axis]));
        let [a, b, c] = [middle(from, first), middle(first, second), middle(second, end)];
        let [d, e] = [middle(a, b), middle(b, c)];
        let center = middle(d, e);
        if center != from {
            self.push_cubic([a, d, center], 0.0);
            self.push_cubic([e, c, end], 0.0);
        }
    }

    /// A Bezier curve of degree 2 or 3 by its control points behind the first.
    ///
    /// Chords between points at equal steps of the parameter are within an eighth of the square of the step times the greatest
    /// second derivative.
    pub(super) fn curve_to(&mut self, controls: &[[f64; 2]]) -> Result<(), String> {
        let to = self.end(controls.last().copied().unwrap_or(self.at));
        let inner = &controls[..controls.len().saturating_sub(1)];
        let points: Vec<[f64; 2]> =
            [self.at].iter().chain(inner).chain([&to]).map(|&control| self.map.point(control)).collect();
        if self.curves == Curves::Kept {
            self.begin();
            let raised =
                |control: [f64; 2], end: [f64; 2]| [0, 1].map(|axis| (2.0 * control[axis] + end[axis]) / 3.0);
            self.push_cubic(
                match points[..] {
                    [from, control, end] => [raised(control, from), raised(control, end), end],
                    [_, first, second, end] => [first, second, end],
                    _ => [self.map.point(to); 3],
                },
                0.0,
            );
            self.at = to;
            return Ok(());
        }
        let bends = points.windows(3).map(|p| {
            let bend = |axis: usize| p[0][axis] - 2.0 * p[1][axis] + p[2][axis];
            bend(0).hypot(bend(1))
        });
        let degree = controls.len() as f64;
        let bend = degree
            * (degree - 1.0)
            * bends.fold(0.0, |most: f64, bend| if bend <= most { most } else { bend });
        let count = self.chords(bend)?;
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
    fn chords(&mut self, bend: f64) -> Result<usize, String> {
        let Curves::Chords(tolerance) = self.curves else { return Ok(1) };
        if !bend.is_finite() || !tolerance.is_finite() {
            return Err(BEYOND.to_owned());
        }
        let count = (bend / (8.0 * tolerance)).sqrt().ceil().max(1.0);
        if count > MOST_CHORDS {
            return Err(format!("a curve takes {count:.0} chords to be within {tolerance}"));
        }
        self.chord_count += count as usize;
        if self.chord_count > MOST_IN_ALL {
            return Err(format!("the curves take more than {MOST_IN_ALL} chords to be within {tolerance}"));
        }
        Ok(count as usize)
    }

    /// The part of an ellipse with this center and half axes from one angle (of the circle that it is the image of) to another.
    /// `to` is where it ends, unless it is the whole ellipse.
    fn ellipse(
        &mut self,
        center: [f64; 2],
        axes: [[f64; 2]; 2],
        [from, sweep]: [f64; 2],
        to: Option<[f64; 2]>,
    ) -> Result<(), String> {
        let [u, v] = axes.map(|axis| self.map.direction(axis));
        // The square of the longest half axis of the image is the larger eigenvalue of the products of these two.
        let largest = [u, v].as_flattened().iter().map(|x| x.abs()).fold(0.0, f64::max);
        let product = |p: [f64; 2], q: [f64; 2]| {
            (p[0] / largest) * (q[0] / largest) + (p[1] / largest) * (q[1] / largest)
        };
        let (uu, vv, uv) = (product(u, u), product(v, v), product(u, v));
        let reach = if largest > 0.0 {
            largest * f64::midpoint(uu + vv, (uu - vv).hypot(2.0 * uv)).sqrt()
        } else {
            0.0
        };
        let numbers = [from, sweep, reach].into_iter().chain(u).chain(v).chain(self.map.point(center));
        if !numbers.into_iter().all(f64::is_finite) {
            return Err(BEYOND.to_owned());
        }
        let least = if to.is_none() { 3 } else { 1 };
        if self.curves == Curves::Kept {
            self.cubic_arcs(self.map.point(center), [u, v], reach, [from, sweep], to);
            return Ok(());
        }
        let count = self.chords(reach * sweep * sweep)?.max(least);
        let center = self.map.point(center);
        let place = |i: usize| {
            let (sine, cosine) = (from + sweep * i as f64 / count as f64).sin_cos();
            [0, 1].map(|axis| center[axis] + cosine * u[axis] + sine * v[axis])
        };
        match to {
            None => {
                let corners = (0..count).map(place).collect();
                self.subpaths.push(Subpath { corners, is_closed: true, ..Subpath::default() });
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

    /// The part of an ellipse, transformed, as cubics that touch it at equal steps of the angle.
    ///
    /// The cubic whose inner control points are k = 4/3 tan(s/4) half axes along the tangents is never farther than 2/27 sin^6(s/4) /
    /// cos^2(s/4) of the longer half axis from the arc of angle s, and outside of it.
    ///
    /// # References
    /// M. Goldapp, *Approximation of circular arcs by cubic polynomials* (1991).
    fn cubic_arcs(
        &mut self,
        center: [f64; 2],
        [u, v]: [[f64; 2]; 2],
        reach: f64,
        [from, sweep]: [f64; 2],
        to: Option<[f64; 2]>,
    ) {
        let most = 4.0 * (13.5 * ARC_PRECISION).powf(1.0 / 6.0);
        let mut count = (sweep.abs() / most).ceil().max(1.0) as usize;
        if to.is_none() {
            // The ends of the axes are exact then.
            count = count.next_multiple_of(4);
        }
        let step = sweep / count as f64;
        let direction = |i: usize| match (4 * i).checked_rem(count) {
            Some(0) if to.is_none() => [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][4 * i / count % 4],
            _ => {
                let (sine, cosine) = (from + step * i as f64).sin_cos();
                (cosine, sine)
            }
        };
        let combine = |along: f64, across: f64, axis: usize| along * u[axis] + across * v[axis];
        let place = |i: usize| {
            let (cosine, sine) = direction(i);
            [0, 1].map(|axis| center[axis] + combine(cosine, sine, axis))
        };
        let reach_of_tangent = 4.0 / 3.0 * (step / 4.0).tan();
        let error = 2.0 / 27.0 * (step / 4.0).sin().powi(6) / (step / 4.0).cos().powi(2) * reach;
        let first = match to {
            None => {
                self.subpaths.push(Subpath {
                    corners: vec![place(0)],
                    is_closed: true,
                    ..Subpath::default()
                });
                place(0)
            }
            Some(_) => {
                self.begin();
                self.map.point(self.at)
            }
        };
        let end = to.map_or(first, |to| self.map.point(to));
        let mut point = first;
        for i in 0..count {
            let next = if i + 1 == count { end } else { place(i + 1) };
            let [(c0, s0), (c1, s1)] = [direction(i), direction(i + 1)];
            let leaving = [0, 1].map(|axis| point[axis] + reach_of_tangent * combine(-s0, c0, axis));
            let arriving = [0, 1].map(|axis| next[axis] - reach_of_tangent * combine(-s1, c1, axis));
            self.push_cubic([leaving, arriving, next], error);
            point = next;
        }
        if let Some(to) = to {
            self.at = to;
        }
    }

    /// A whole ellipse along the axes, as a subpath of its own.
    pub(super) fn whole_ellipse(&mut self, center: [f64; 2], radii: [f64; 2]) -> Result<(), String> {
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
    ) -> Result<(), String> {
        let [mut rx, mut ry] = radii.map(f64::abs);
        let from = self.at;
        if from == to {
            return Ok(());
        }
        let to = self.end(to);
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
        if !p.is_finite() || !q.is_finite() {
            return Err(BEYOND.to_owned());
        }
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

/// A shape that is filled, or would be.
pub(super) struct FilledPath {
    pub(super) line: u64,
    /// The name of the element, and its own.
    pub(super) element: String,
    pub(super) name: Option<String>,
    pub(super) rule: InsideRule,
    /// Whether its first subpath is the frame of an unbounded set: what is written so by [`crate::yin`].
    pub(super) is_exterior: bool,
    pub(super) subpaths: Vec<Subpath>,
    /// The clip that a part of it is seen through.
    pub(super) clip: Option<usize>,
}
