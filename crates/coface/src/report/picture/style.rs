//! A scene as a picture.

use super::camera::{Camera, Projection, cross, dot, unit};
use super::palette::{ALARM, Color, DARK, LIGHT, Theme, color};
use super::raster::Raster;
use crate::report::{Layer, Scene};
use crate::{Error, ErrorKind};

/// How a picture looks.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PictureStyle {
    /// Width and height in pixels.
    pub size: [usize; 2],
    /// Where the eye is; none for the usual place.
    pub camera: Option<Camera>,
    /// Whether edges are drawn; none for where they can be told apart.
    pub edges: Option<bool>,
    /// A dark background.
    pub is_dark: bool,
}

impl Default for PictureStyle {
    fn default() -> Self {
        Self { size: [1200, 900], camera: None, edges: None, is_dark: false }
    }
}

/// With more triangles than this, edges are not drawn unless that is asked for.
const EDGES_UP_TO: usize = 30_000;

/// How often a pixel is looked at in each direction.
const SAMPLES: usize = 3;

/// The most pixels of a picture.
const MOST_PIXELS: usize = 1 << 25;

/// A scene with everything that a picture of it needs.
///
/// # Examples
/// ```
/// use coface::io::{self, Format};
/// use coface::report::{Picture, PictureStyle, Scene};
/// # fn main() -> Result<(), coface::Error> {
/// let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
/// let scene = Scene::of("triangle", &triangle)?;
/// let picture = Picture::new(&scene, &PictureStyle::default())?;
/// assert!(picture.svg().contains("<polygon"));
/// assert!(picture.png()?.starts_with(b"\x89PNG"));
/// # Ok(()) }
/// ```
pub struct Picture<'a> {
    pub(super) scene: &'a Scene,
    pub(super) size: [usize; 2],
    pub(super) projection: Projection,
    pub(super) theme: &'static Theme,
    pub(super) shows_edges: bool,
}

impl<'a> Picture<'a> {
    /// A picture of a scene.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a picture without pixels or a camera without direction; [`ErrorKind::TooLarge`] beyond $2^{25}$ pixels.
    pub fn new(scene: &'a Scene, style: &PictureStyle) -> Result<Self, Error> {
        let [width, height] = style.size;
        if width == 0 || height == 0 {
            return Err(
                Error::invalid("a picture without pixels").with_cure("give a width and a height above 0")
            );
        }
        if width.saturating_mul(height) > MOST_PIXELS {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("{width} by {height} are more than 2^25 pixels"),
            )
            .with_cure("make a smaller picture, or an SVG, which has no pixels"));
        }
        let camera =
            style.camera.unwrap_or(if scene.dimension() == 2 { Camera::above() } else { Camera::default() });
        let own = shown(scene).flat_map(|(layer, _)| layer.positions.iter().flatten());
        let points: Vec<[f64; 3]> = scene.positions().iter().chain(own).copied().collect();
        Ok(Self {
            scene,
            size: style.size,
            projection: Projection::new(&camera, &points, style.size)?,
            theme: if style.is_dark { &DARK } else { &LIGHT },
            shows_edges: style.edges.unwrap_or(scene.triangles().len() <= EDGES_UP_TO),
        })
    }

    /// The picture as PNG, antialiased.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] should the encoder fail.
    ///
    /// # Complexity
    /// Linear in the triangles and in the pixels that they cover.
    pub fn png(&self) -> Result<Vec<u8>, Error> {
        let bytes = self.raster(SAMPLES, true).shrunk(SAMPLES);
        let mut file = Vec::new();
        let failed = |error: png::EncodingError| {
            Error::new(ErrorKind::Io, format!("the PNG cannot be written: {error}"))
        };
        let mut encoder = png::Encoder::new(&mut file, self.size[0] as u32, self.size[1] as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header().map_err(failed)?;
        writer.write_image_data(&bytes).map_err(failed)?;
        writer.finish().map_err(failed)?;
        Ok(file)
    }

    /// The picture in pixels, `factor` by `factor` for each of its own; with the triangles alone or with everything.
    pub(super) fn raster(&self, factor: usize, has_lines: bool) -> Raster {
        let [width, height] = self.size.map(|side| side * factor);
        let mut raster = Raster::new(width, height, self.theme.background);
        let place = |point: [f64; 3]| {
            let [x, y, depth] = self.projection.project(point);
            [x * factor as f64, y * factor as f64, depth]
        };
        let at = |vertex: u32| self.scene.positions()[vertex as usize];
        for (number, &triangle) in (0..).zip(self.scene.triangles()) {
            let corners = triangle.map(at);
            raster.triangle(corners.map(place), self.shade(corners, self.theme.surface), number);
        }
        let unit = factor as f64;
        // Lines on a surface are in front of it by a little.
        let nearer = |[x, y, depth]: [f64; 3], share: f64| [x, y, depth - share * self.reach()];
        for (layer, color) in shown(self.scene) {
            let own =
                |point: u32| layer.positions.as_ref().map_or_else(|| at(point), |own| own[point as usize]);
            for &triangle in &layer.triangles {
                let corners = triangle.map(own);
                let seen = corners.map(place).map(|corner| nearer(corner, 0.5));
                raster.triangle(seen, self.shade(corners, color), super::raster::NOTHING);
            }
        }
        if !has_lines {
            return raster;
        }
        if self.shows_edges {
            for [a, b] in self.scene.edges() {
                let ends = [a, b].map(|v| nearer(place(at(v)), 1.0));
                raster.line(ends, 0.7 * unit, self.theme.edge);
            }
        }
        for (layer, color) in shown(self.scene) {
            let own =
                |point: u32| layer.positions.as_ref().map_or_else(|| at(point), |own| own[point as usize]);
            for line in layer.lines.iter() {
                for pair in line.windows(2) {
                    raster.line([pair[0], pair[1]].map(|p| nearer(place(own(p)), 2.0)), 3.5 * unit, color);
                }
            }
            for &point in &layer.points {
                raster.disk(nearer(place(own(point)), 3.0), 8.0 * unit, color);
            }
        }
        raster
    }

    /// A small depth: by this much lines are in front of what they lie on.
    pub(super) fn reach(&self) -> f64 {
        let depths = self.scene.positions().iter().map(|&point| self.projection.project(point)[2]);
        let (low, high) = depths.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), d| (l.min(d), h.max(d)));
        if low < high { 2e-3 * (high - low) } else { 1e-3 }
    }

    /// A color in the light that falls on a triangle, from either side.
    pub(super) fn shade(&self, [a, b, c]: [[f64; 3]; 3], color: Color) -> Color {
        let to = |p: [f64; 3]| [0, 1, 2].map(|i| p[i] - a[i]);
        let Some(normal) = unit(cross(to(b), to(c))) else { return color };
        let seen = self.projection.direction(normal);
        let light = [0.27, 0.45, 0.85];
        let share = 0.45 + 0.55 * if seen[2] < 0.0 { -dot(seen, light) } else { dot(seen, light) }.max(0.0);
        color.map(|part| part * share as f32)
    }
}

/// The layers that are shown, with their colors.
pub(super) fn shown(scene: &Scene) -> impl Iterator<Item = (&Layer, Color)> {
    let mut next = 0;
    scene
        .layers()
        .iter()
        .map(move |layer| {
            if layer.group == "witness" {
                return (layer, ALARM);
            }
            next += 1;
            (layer, color(next - 1))
        })
        .filter(|(layer, _)| layer.is_on)
}
