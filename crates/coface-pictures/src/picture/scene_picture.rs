//! A scene as a picture.

use super::camera::{Camera, Projection, cross, dot, scene_points, unit};
use super::canvas::Canvas;
use super::flat::{Anchor, FlatPicture};
use super::legend::Legend;
use super::letters;
use super::palette::{ALARM, Color, FAINT, NEUTRAL, Theme, color, mixed, of as color_of, packed};
#[cfg(feature = "png")]
use super::pixels::Pixels;
use super::raster::{Ink, NOTHING, Raster};
use super::sight::Sight;
use super::style::{PictureStyle, SAMPLES, check_size, check_widths};
use crate::{Layer, Scene};
use coface_algebra::Error;
use coface_algebra::progress::stage;

/// With more triangles than this, edges are not drawn unless that is asked for.
const EDGES_UP_TO: usize = 30_000;

/// The width of edges that are sides of no polygon, of one that is.
pub(super) const WIRE_OF_EDGE: f64 = 8.0 / 3.0;
/// The width of hidden parts of lines, of one that is seen.
pub(super) const HIDDEN_OF_LINE: f64 = 0.5;
/// Widths in pixels.
pub(super) const DOT_WIDTH: f64 = 5.0;
pub(super) const POINT_WIDTH: f64 = 8.0;
pub(super) const HOLE_WIDTH: f64 = 4.5;
pub(super) const TEXT_SIZE: f64 = 14.0;
/// The group of layers whose texts are left out where the model hides them.
pub(crate) const LABELS: &str = "labels";
/// The group of the layer of dots at the vertices of a complex.
pub(crate) const COMPLEX: &str = "complex";
/// The group of stars, closures and links: their triangles are paler than their edges and vertices.
pub(crate) const NEIGHBORHOOD: &str = "neighborhood";
/// How much of its color a triangle of a neighborhood has.
const TINT: f32 = 0.45;
/// Of 256, what is seen of hidden lines through what hides them.
pub(super) const HIDDEN_SHARE: u32 = 96;

/// A scene with everything that a picture of it needs.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_pictures::{Picture, PictureStyle, Scene};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
/// let scene = Scene::of("triangle", &triangle)?;
/// let mut style = PictureStyle::default();
/// style.size = [80, 60];
/// let picture = Picture::new(&scene, &style)?;
/// assert!(picture.svg().contains("<title>triangle</title>"));
/// assert!(picture.png()?.starts_with(b"\x89PNG"));
/// # Ok(()) }
/// ```
pub struct Picture<'a> {
    pub(super) scene: &'a Scene,
    pub(super) size: [usize; 2],
    pub(super) theme: &'static Theme,
    projection: Projection,
    /// What is shaded: the triangles of the scene, then those of layers.
    pub(super) facets: Vec<Facet>,
    /// Sides of polygons; empty if they are not drawn.
    pub(super) edges: Vec<[u32; 2]>,
    /// Edges that are sides of no polygon.
    pub(super) wires: Vec<[u32; 2]>,
    /// Vertices that are in nothing else.
    pub(super) dots: Vec<u32>,
    /// A small depth: by this much lines are in front of what they lie on.
    pub(super) reach: f64,
    pub(super) is_transparent: bool,
    pub(super) line_width: f64,
    pub(super) edge_width: f64,
    pub(super) legend: Option<Legend>,
}

impl std::fmt::Debug for Picture<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Picture")
            .field("size", &self.size)
            .field("facets", &self.facets.len())
            .finish_non_exhaustive()
    }
}

/// A triangle in the picture: pixels and depths.
#[derive(Clone, Debug)]
pub(super) struct Facet {
    pub(super) corners: [[f64; 3]; 3],
    pub(super) color: Color,
}

impl<'a> Picture<'a> {
    /// A picture of a scene.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a picture without pixels or a camera without direction;
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond $2^{25}$ pixels.
    ///
    /// # Complexity
    /// $O(n \log n)$ in the cells.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::{Picture, PictureStyle, Scene};
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// let picture = Picture::new(&scene, &PictureStyle::default())?;
    /// assert!(picture.svg().contains("<title>square</title>"));
    /// # Ok(()) }
    /// ```
    pub fn new(scene: &'a Scene, style: &PictureStyle) -> Result<Self, Error> {
        check_size(style.size)?;
        check_widths(style)?;
        let camera = style.camera.unwrap_or_else(|| Camera::usual(scene));
        let points = scene_points(scene);
        let legend = style.has_legend.then(|| Legend::of(scene, style.size, style.theme()));
        let strip = legend.as_ref().map_or(0, Legend::height);
        let below = [style.size[0], style.size[1] - strip];
        let projection = Projection::new(&camera, style.turn, &points, below)?.moved_down(strip as f64);
        let depths = points.iter().map(|&point| projection.project(point)[2]);
        let (low, high) = depths.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), d| (l.min(d), h.max(d)));
        let (mut edges, mut wires, dots) = lines_of(scene);
        let [_, has_wires_only] = scene.is_pale();
        if has_wires_only {
            edges.append(&mut wires);
        }
        let shows_edges = style.edges.unwrap_or(has_wires_only || scene.triangles().len() <= EDGES_UP_TO);
        let mut picture = Self {
            scene,
            size: style.size,
            theme: style.theme(),
            projection,
            facets: Vec::new(),
            edges: if shows_edges { edges } else { Vec::new() },
            wires,
            dots,
            reach: if low < high { 2e-3 * (high - low) } else { 1e-3 },
            is_transparent: style.is_transparent,
            line_width: style.line_width,
            edge_width: style.edge_width,
            legend,
        };
        picture.add_facets();
        Ok(picture)
    }

    fn add_facets(&mut self) {
        let mut facets = Vec::with_capacity(self.scene.triangles().len());
        let mut add = |corners: [[f64; 3]; 3], color: Color, forward: f64| {
            let color = self.shade(corners, color);
            let corners = corners.map(|corner| {
                let [x, y, depth] = self.projection.project(corner);
                [x, y, depth - forward * self.reach]
            });
            facets.push(Facet { corners, color });
        };
        let [_, has_wires_only] = self.scene.is_pale();
        let surface = match self.scene.is_pale() {
            [true, _] => {
                [0, 1, 2].map(|part| f32::midpoint(self.theme.surface[part], self.theme.background[part]))
            }
            _ => self.theme.surface,
        };
        let triangles = if has_wires_only { &[] } else { self.scene.triangles() };
        let steps = stage("shading triangles", triangles.len());
        for &triangle in steps.each(triangles) {
            add(triangle.map(|vertex| self.scene.positions()[vertex as usize]), surface, 0.0);
        }
        for (layer, color) in shown(self.scene) {
            let color = fill_of(layer, color, self.theme);
            for &triangle in &layer.triangles {
                let own = layer.positions.as_deref().unwrap_or(self.scene.positions());
                add(triangle.map(|point| own[point as usize]), color, 0.5 + lift(layer));
            }
        }
        self.facets = facets;
    }

    /// The pixel and the depth of a vertex of the model.
    pub(super) fn place(&self, vertex: u32) -> [f64; 3] {
        self.projection.project(self.scene.positions()[vertex as usize])
    }

    /// The pixel and the depth of a point of a layer.
    pub(super) fn place_in(&self, layer: &Layer, point: u32) -> [f64; 3] {
        match &layer.positions {
            Some(own) => self.projection.project(own[point as usize]),
            None => self.place(point),
        }
    }

    /// The picture as PNG, antialiased. What hides lines and points of layers lets them shine through faintly.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) should the encoder fail.
    ///
    /// # Complexity
    /// Linear in the triangles and in the pixels that they cover.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::{Picture, PictureStyle, Scene};
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// let picture = Picture::new(&scene, &PictureStyle::default())?;
    /// assert!(picture.png()?.starts_with(b"\x89PNG"));
    /// # Ok(()) }
    /// ```
    pub fn png(&self) -> Result<Vec<u8>, Error> {
        let background = (!self.is_transparent).then_some(self.theme.background);
        Canvas::png_on(background, SAMPLES, |background| self.canvas(background))
    }

    /// The pixels of the picture.
    #[cfg(feature = "png")]
    pub(super) fn pixels(&self) -> Pixels {
        let background = (!self.is_transparent).then_some(self.theme.background);
        Canvas::pixels_on(background, SAMPLES, |background| self.canvas(background))
    }

    /// The picture on a background, in pixels that are [`SAMPLES`] times as fine.
    pub(super) fn canvas(&self, background: u32) -> Canvas {
        let mut raster = self.raster(SAMPLES, color_of(background));
        let factor = SAMPLES as f64;
        let scaled =
            |[x, y, depth]: [f64; 3], forward: f64| [factor * x, factor * y, depth - forward * self.reach];
        let ink = |color: Color| Ink { color: packed(color), number: NOTHING };
        let hidden = self.hidden_lines(&raster);
        for ([a, b], color, number) in hidden {
            let ink = Ink { color: packed(color), number };
            let width = HIDDEN_OF_LINE * self.line_width * factor;
            raster.faint_line([scaled(a, 0.0), scaled(b, 0.0)], width, ink, HIDDEN_SHARE);
        }
        let wire_width = WIRE_OF_EDGE * self.edge_width;
        let [edge_color, wire_color] = self.edge_colors();
        for (edges, width, color, forward) in
            [(&self.edges, self.edge_width, edge_color, 1.0), (&self.wires, wire_width, wire_color, 1.5)]
        {
            let steps = stage("drawing edges", edges.len());
            for edge in steps.each(edges) {
                let ends = edge.map(|vertex| scaled(self.place(vertex), forward));
                raster.line(ends, width * factor, ink(color));
            }
        }
        for &vertex in &self.dots {
            raster.disk(scaled(self.place(vertex), 1.5), DOT_WIDTH * factor, ink(self.theme.ink));
        }
        for (layer, color) in shown(self.scene) {
            for pair in layer.lines.iter().flat_map(|line| line.windows(2)) {
                let ends =
                    [pair[0], pair[1]].map(|point| scaled(self.place_in(layer, point), 2.0 + lift(layer)));
                raster.line(ends, self.line_width * factor, ink(color));
            }
            for corners in self.arrowheads(layer) {
                raster.triangle(corners.map(|corner| scaled(corner, 2.5)), ink(color));
            }
            for &point in &layer.points {
                let place = scaled(self.place_in(layer, point), 3.0 + lift(layer));
                raster.disk(place, point_width(layer) * factor, ink(color));
            }
            for &point in &layer.rings {
                let [outer, inner] =
                    [2.9, 2.95].map(|forward| scaled(self.place_in(layer, point), forward + lift(layer)));
                raster.disk(outer, POINT_WIDTH * factor, ink(color));
                raster.disk(inner, HOLE_WIDTH * factor, ink(self.theme.background));
            }
        }
        let mut labels = FlatPicture::new("", self.size.map(|side| side as f64), self.theme.background);
        let sight = Sight { raster: &raster, factor, slack: 1.5 * self.reach };
        for (layer, color) in shown(self.scene) {
            for (point, text) in &layer.labels {
                let place = self.place_in(layer, *point);
                if layer.group == LABELS && !sight.is_seen(place) {
                    continue;
                }
                let (at, anchor) = beside(place, text, self.size);
                labels.text(at, anchor, TEXT_SIZE, color, text.clone());
            }
        }
        if let Some(legend) = &self.legend {
            legend.draw(&mut labels);
        }
        labels.paint(&mut raster.canvas, factor, [0.0, 0.0]);
        raster.canvas
    }

    /// The colors of sides of polygons and of other edges.
    pub(super) fn edge_colors(&self) -> [Color; 2] {
        match self.scene.is_pale() {
            [true, _] => [self.theme.pale; 2],
            _ => [self.theme.edge, self.theme.ink],
        }
    }

    /// The facets in pixels, `factor` by `factor` for each of the picture; what is seen is the number of a facet.
    pub(super) fn raster(&self, factor: usize, background: Color) -> Raster {
        self.raster_of(&self.facets, factor, background)
    }

    /// The same of other facets.
    pub(super) fn raster_of(&self, facets: &[Facet], factor: usize, background: Color) -> Raster {
        let [width, height] = self.size.map(|side| side * factor);
        let mut raster = Raster::new(width, height, packed(background));
        let steps = stage("drawing triangles", facets.len());
        for (number, facet) in steps.each((0..).zip(facets)) {
            let corners = facet.corners.map(|corner| super::sight::finer(corner, factor));
            raster.triangle(corners, Ink { color: packed(facet.color), number });
        }
        raster
    }

    /// The parts of lines of layers that something hides, with a number for each layer.
    fn hidden_lines(&self, raster: &Raster) -> Vec<([[f64; 3]; 2], Color, u32)> {
        let sight = Sight { raster, factor: SAMPLES as f64, slack: 1.5 * self.reach };
        let mut hidden = Vec::new();
        for (place, (layer, color)) in (0..).zip(shown(self.scene)) {
            for pair in layer.lines.iter().flat_map(|line| line.windows(2)) {
                let ends = [pair[0], pair[1]].map(|point| self.place_in(layer, point));
                sight.parts(ends, |part, is_seen| {
                    if !is_seen {
                        hidden.push((part, color, NOTHING - 1 - place));
                    }
                });
            }
        }
        hidden
    }

    /// The arrowheads of a layer: in the middle of each segment that has room for one.
    pub(super) fn arrowheads(&self, layer: &Layer) -> Vec<[[f64; 3]; 3]> {
        const LENGTH: f64 = 10.0;
        if !layer.has_arrows {
            return Vec::new();
        }
        let pairs = layer.lines.iter().flat_map(|line| line.windows(2));
        let head = |pair: &[u32]| {
            let [a, b] = [pair[0], pair[1]].map(|point| self.place_in(layer, point));
            let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
            let length = dx.hypot(dy);
            if length < 2.4 * LENGTH {
                return None;
            }
            let (x, y) = (LENGTH * dx / length, LENGTH * dy / length);
            let middle = [0, 1, 2].map(|i| f64::midpoint(a[i], b[i]));
            let corner = |along: f64, across: f64| {
                [middle[0] + along * x - across * y, middle[1] + along * y + across * x, middle[2]]
            };
            Some([corner(0.5, 0.0), corner(-0.5, 0.45), corner(-0.5, -0.45)])
        };
        pairs.filter_map(head).collect()
    }

    /// A color in the light that falls on a triangle, from either side.
    fn shade(&self, [a, b, c]: [[f64; 3]; 3], color: Color) -> Color {
        let to = |p: [f64; 3]| [0, 1, 2].map(|i| p[i] - a[i]);
        let Some(normal) = unit(cross(to(b), to(c))) else { return color };
        let seen = self.projection.direction(normal);
        let light = [0.27, 0.45, 0.85];
        let share = 0.45 + 0.55 * if seen[2] < 0.0 { -dot(seen, light) } else { dot(seen, light) }.max(0.0);
        color.map(|part| part * share as f32)
    }
}

/// The edges of polygons, the other edges, and the vertices on none. $O(n \log n)$.
pub(super) fn lines_of(scene: &Scene) -> (Vec<[u32; 2]>, Vec<[u32; 2]>, Vec<u32>) {
    let all = scene.edges();
    let mut is_used: Vec<bool> = (0..).map(|v| scene.is_hidden(v)).take(scene.positions().len()).collect();
    all.as_flattened().iter().for_each(|&vertex| is_used[vertex as usize] = true);
    let dots = (0..).zip(is_used).filter(|(_, is_used)| !is_used).map(|(vertex, _)| vertex).collect();
    let mut sides: Vec<[u32; 2]> = Vec::with_capacity(all.len());
    for walk in scene.polygons().iter().chain(scene.rims().iter()) {
        sides.extend((0..walk.len()).map(|i| {
            let [a, b] = [walk[i], walk[(i + 1) % walk.len()]];
            [a.min(b), a.max(b)]
        }));
    }
    sides.sort_unstable();
    sides.dedup();
    let mut rest = sides.iter().peekable();
    let mut wires = Vec::new();
    for edge in all {
        while rest.next_if(|side| **side < edge).is_some() {}
        if rest.peek() != Some(&&edge) {
            wires.push(edge);
        }
    }
    (sides, wires, dots)
}

/// The color of the triangles of a layer.
pub(super) fn fill_of(layer: &Layer, color: Color, theme: &Theme) -> Color {
    if layer.group != NEIGHBORHOOD {
        return color;
    }
    mixed(color, theme.background, TINT)
}

/// How far a layer is in front of the usual: of neighborhoods one of a later color lies over one of an earlier color.
fn lift(layer: &Layer) -> f64 {
    let place = layer.color.filter(|_| layer.group == NEIGHBORHOOD);
    place.map_or(0.0, |place| 0.15 * f64::from(place + 1))
}

/// The width of the disks at the points of a layer.
pub(super) fn point_width(layer: &Layer) -> f64 {
    if layer.group == COMPLEX { DOT_WIDTH } else { POINT_WIDTH }
}

/// Where a text beside a place stands, within a picture of this size: above the place and to its right, or to its left where the
/// right has no room.
pub(super) fn beside([x, y, _]: [f64; 3], text: &str, size: [usize; 2]) -> ([f64; 2], Anchor) {
    let [width, height] = size.map(|side| side as f64);
    let length = TEXT_SIZE * letters::width(text);
    let baseline = (y - 6.0).clamp(TEXT_SIZE, (height - 4.0).max(TEXT_SIZE));
    if x + 6.0 + length <= width || x - 6.0 - length < 0.0 {
        return ([x + 6.0, baseline], Anchor::Start);
    }
    ([x - 6.0, baseline], Anchor::End)
}

/// The layers that are shown, with their colors.
pub(super) fn shown(scene: &Scene) -> impl Iterator<Item = (&Layer, Color)> {
    let mut next = 0;
    scene
        .layers()
        .iter()
        .map(move |layer| {
            match layer.group.as_str() {
                "witness" | "boundary" => return (layer, ALARM),
                LABELS => return (layer, NEUTRAL),
                COMPLEX => return (layer, FAINT),
                _ => {}
            }
            let place = layer.color.map_or(next, |place| place as usize);
            next += usize::from(layer.color.is_none());
            (layer, color(place))
        })
        .filter(|(layer, _)| layer.is_on)
}
