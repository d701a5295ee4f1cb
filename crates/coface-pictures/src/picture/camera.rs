//! Where a scene is seen from.

use super::scene_picture::shown;
use crate::Scene;
use coface_algebra::Error;

/// An eye that looks at the middle of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Camera {
    /// The direction from the middle of the scene to the eye; its length does not matter.
    pub from: [f64; 3],
    /// What is up in the picture, as nearly as it can be.
    pub up: [f64; 3],
    /// The angle in degrees that the picture takes from bottom to top; none for parallel rays.
    pub field_of_view: Option<f64>,
}

impl Default for Camera {
    /// From the upper right in front, by parallel rays.
    fn default() -> Self {
        Self { from: [0.5, 0.35, 1.0], up: [0.0, 1.0, 0.0], field_of_view: None }
    }
}

impl Camera {
    /// Straight from above onto the plane of x and y, as drawings are seen.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_pictures::Camera::above().from, [0.0, 0.0, 1.0]);
    /// ```
    pub fn above() -> Self {
        Self { from: [0.0, 0.0, 1.0], ..Self::default() }
    }

    /// Where a scene is seen from unless something else is asked for: what lies in a plane from straight above that plane, on the
    /// side of the largest coordinate of its normal, anything else as [`Self::default`] has it.
    ///
    /// # Examples
    /// ```
    /// use coface_pictures::{Camera, Scene};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = &b"v 0 1 0\nv 2 1 0\nv 2 1 2\nv 0 1 2\nf 1 2 3 4\n"[..];
    /// let scene = Scene::of("square", &coface_io::read(square, coface_io::Format::Obj)?)?;
    /// assert_eq!(Camera::usual(&scene).from, [0.0, 1.0, 0.0]);
    /// # Ok(()) }
    /// ```
    pub fn usual(scene: &Scene) -> Self {
        if scene.dimension() == 2 {
            return Self::above();
        }
        match plane_normal(&scene_points(scene)) {
            Some(from) => Self { from, ..Self::default() },
            None => Self::default(),
        }
    }
}

/// The points of a model and of the layers that are shown.
pub(super) fn scene_points(scene: &Scene) -> Vec<[f64; 3]> {
    let own = shown(scene).flat_map(|(layer, _)| layer.positions.iter().flatten());
    scene.positions().iter().chain(own).copied().collect()
}

/// The normal of the plane that points lie in, up to rounding, with a largest coordinate that is positive; none for points on a line.
fn plane_normal(points: &[[f64; 3]]) -> Option<[f64; 3]> {
    let first = *points.first()?;
    let from_first = |point: &[f64; 3]| [0, 1, 2].map(|i| point[i] - first[i]);
    let longest = |vectors: &mut dyn Iterator<Item = [f64; 3]>| {
        vectors.max_by(|&a, &b| dot(a, a).total_cmp(&dot(b, b))).expect("there is a point")
    };
    let far = longest(&mut points.iter().map(from_first));
    let along = unit(far)?;
    let across = longest(&mut points.iter().map(|point| cross(along, from_first(point))));
    let extent = dot(far, far).sqrt();
    // Thinner than a hair: a line as far as pictures go.
    if dot(across, across).sqrt() < 1e-6 * extent {
        return None;
    }
    let normal = unit(across)?;
    let is_flat = points.iter().all(|point| dot(normal, from_first(point)).abs() <= 1e-9 * extent);
    let largest = normal.into_iter().max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    is_flat.then(|| normal.map(|part| part * largest.signum() + 0.0))
}

/// A camera with the picture that it makes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    center: [f64; 3],
    /// To the right, up, and towards the eye.
    axes: [[f64; 3]; 3],
    /// The distance of the eye from the center; none for parallel rays.
    distance: Option<f64>,
    /// Pixels for a unit at the center.
    scale: f64,
    middle: [f64; 2],
}

impl Projection {
    /// The projection that has all points in a picture of this size.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for directions without length, or one that is up.
    pub(super) fn new(
        camera: &Camera,
        turn: Option<f64>,
        points: &[[f64; 3]],
        size: [usize; 2],
    ) -> Result<Self, Error> {
        let towards = unit(camera.from).ok_or_else(|| {
            Error::invalid("the direction to the eye has no length")
                .with_cure("give three numbers that are not all 0")
        })?;
        let up = unit(camera.up).ok_or_else(|| {
            Error::invalid("up has no length").with_cure("give three numbers that are not all 0")
        })?;
        let right = unit(cross(up, towards)).or_else(|| {
            // Seen along up, what is behind is up.
            unit(cross([-up[2], -up[0], -up[1]], towards))
        });
        let right = right.ok_or_else(|| {
            Error::invalid("up is the direction of the eye").with_cure("give another direction for up")
        })?;
        // The eye goes around up; what is above and what is beside it go with it.
        let turned = turn.unwrap_or(0.0).to_radians();
        let axes = [right, cross(towards, right), towards].map(|axis| rotated(axis, up, turned));
        let corner = |pick: fn(f64, f64) -> f64, start: f64| {
            [0, 1, 2].map(|axis| points.iter().map(|point| point[axis]).fold(start, pick))
        };
        let (low, high) = (corner(f64::min, f64::INFINITY), corner(f64::max, f64::NEG_INFINITY));
        let center = [0, 1, 2].map(|i| if low[i] <= high[i] { 0.5 * low[i] + 0.5 * high[i] } else { 0.0 });
        let local = |point: &[f64; 3]| {
            let offset = [0, 1, 2].map(|i| point[i] - center[i]);
            axes.map(|axis| dot(axis, offset))
        };
        let radius = points.iter().map(|point| dot(local(point), local(point)).sqrt()).fold(0.0, f64::max);
        let radius = if radius > 0.0 { radius } else { 1.0 };
        let distance = camera.field_of_view.map(|angle| {
            let half = (0.5 * angle.clamp(1.0, 170.0)).to_radians();
            radius / half.sin()
        });
        let mut projection = Self { center, axes, distance, scale: 1.0, middle: [0.0; 2] };
        // What the points take at scale 1, then filled.
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            let at = projection.project(*point);
            for axis in 0..2 {
                low[axis] = low[axis].min(at[axis]);
                high[axis] = high[axis].max(at[axis]);
            }
        }
        if low[0] > high[0] {
            (low, high) = ([-1.0; 2], [1.0; 2]);
        }
        if turn.is_some() {
            // All of a ball around the points is in the picture, wherever the eye is.
            let half = camera.field_of_view.map_or(0.0, |angle| (0.5 * angle.clamp(1.0, 170.0)).to_radians());
            (low, high) = ([-radius / half.cos(); 2], [radius / half.cos(); 2]);
        }
        let [width, height] = size.map(|side| side as f64);
        let extent = [0, 1].map(|axis| (high[axis] - low[axis]).max(1e-9 * radius));
        projection.scale = 0.92 * (width / extent[0]).min(height / extent[1]);
        let scale = projection.scale;
        projection.middle =
            [0.5 * width - 0.5 * scale * (low[0] + high[0]), 0.5 * height - 0.5 * scale * (low[1] + high[1])];
        Ok(projection)
    }

    /// The same picture so many pixels lower.
    pub(super) fn moved_down(mut self, pixels: f64) -> Self {
        self.middle[1] += pixels;
        self
    }

    /// The pixel of a point, and its depth.
    pub(super) fn project(&self, point: [f64; 3]) -> [f64; 3] {
        let offset = [0, 1, 2].map(|i| point[i] - self.center[i]);
        let [x, y, z] = self.axes.map(|axis| dot(axis, offset));
        let (shrink, depth) = match self.distance {
            None => (1.0, -z),
            // Linear in the picture: the reciprocal of the distance, the other way around.
            Some(distance) => {
                let shrink = distance / (distance - z).max(1e-3 * distance);
                (shrink, -shrink * distance)
            }
        };
        [self.middle[0] + self.scale * shrink * x, self.middle[1] - self.scale * shrink * y, depth]
    }

    /// A direction in space as seen: to the right, up, and towards the eye.
    pub(super) fn direction(&self, direction: [f64; 3]) -> [f64; 3] {
        self.axes.map(|axis| dot(axis, direction))
    }
}

/// A vector turned about an axis of length 1 (the formula of O. Rodrigues).
fn rotated(vector: [f64; 3], axis: [f64; 3], angle: f64) -> [f64; 3] {
    let (sine, cosine) = angle.sin_cos();
    let (across, along) = (cross(axis, vector), (1.0 - cosine) * dot(axis, vector));
    [0, 1, 2].map(|i| cosine * vector[i] + sine * across[i] + along * axis[i])
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn unit(a: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot(a, a).sqrt();
    (length > 1e-12 && length.is_finite()).then(|| a.map(|x| x / length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_of_a_plane_have_its_normal_and_others_none() {
        let slanted =
            [[0.0, 0.0, 0.0], [3.0, 0.0, -3.0], [0.0, 1.0, 0.0], [3.0, 1.0, -3.0], [1.0, 0.5, -1.0]];
        let normal = plane_normal(&slanted).expect("a plane");
        let half = 0.5f64.sqrt();
        assert!([half, 0.0, half].iter().zip(normal).all(|(a, b)| (a - b).abs() < 1e-15), "{normal:?}");
        assert_eq!(plane_normal(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1e-3]]), None);
        assert_eq!(plane_normal(&[[0.0; 3], [1.0, 1.0, 1.0], [2.0, 2.0, 2.0]]), None);
        assert_eq!(plane_normal(&[[1.0; 3]]), None);
        assert_eq!(plane_normal(&[]), None);
    }

    #[test]
    fn the_near_corner_of_a_cube_is_nearer_and_in_the_middle() {
        let corners: Vec<[f64; 3]> =
            (0..8).map(|i| [f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)]).collect();
        for field_of_view in [None, Some(40.0)] {
            let camera = Camera { from: [1.0; 3], field_of_view, ..Camera::default() };
            let projection = Projection::new(&camera, None, &corners, [200, 100]).expect("a camera");
            let [near, far] = [[1.0; 3], [0.0; 3]].map(|corner| projection.project(corner));
            assert!(near[2] < far[2]);
            assert!((near[0] - 100.0).abs() < 1e-9 && (near[1] - far[1]).abs() < 20.0);
            let inside = |at: [f64; 3]| at[0] > 0.0 && at[0] < 200.0 && at[1] > 0.0 && at[1] < 100.0;
            assert!(corners.iter().all(|&corner| inside(projection.project(corner))));
        }
    }

    #[test]
    fn the_model_keeps_its_size_while_the_eye_goes_around() {
        let corners: Vec<[f64; 3]> =
            (0..8).map(|i| [f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)]).collect();
        let camera = Camera { from: [0.0, 0.0, 1.0], up: [0.0, 1.0, 0.0], field_of_view: None };
        let at = |turn: f64, point: [f64; 3]| {
            let projection = Projection::new(&camera, Some(turn), &corners, [100, 100]).expect("a camera");
            projection.project(point)
        };
        let [front, side] = [0.0, 90.0].map(|turn| at(turn, [1.0, 1.0, 0.0]));
        // The square seen from the front is that seen from the right; what was at the right and behind is in front and at the right.
        assert!((front[0] - side[0]).abs() < 1e-9 && (front[1] - side[1]).abs() < 1e-9);
        assert!(side[2] < front[2]);
        let [low, high] = [at(45.0, [0.0; 3]), at(45.0, [0.0, 1.0, 0.0])];
        assert!((low[1] - high[1] - (at(0.0, [0.0; 3])[1] - at(0.0, [0.0, 1.0, 0.0])[1])).abs() < 1e-9);
    }

    #[test]
    fn a_camera_without_direction_is_refused() {
        let camera = Camera { from: [0.0; 3], ..Camera::default() };
        assert!(Projection::new(&camera, None, &[[0.0; 3]], [10, 10]).is_err());
    }
}
