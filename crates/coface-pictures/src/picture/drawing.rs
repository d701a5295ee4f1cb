//! What is seen of scenes, as flat pictures: what is hidden is left out.

use super::Picture;
use super::flat::{FlatPicture, Step};
use super::painting::painting_order;
use super::palette::Color;
use super::scene_picture::{
    DOT_WIDTH, HIDDEN_OF_LINE, HIDDEN_SHARE, HOLE_WIDTH, LABELS, POINT_WIDTH, TEXT_SIZE, WIRE_OF_EDGE,
    beside, point_width, shown,
};
use super::sight::Sight;
use coface_algebra::progress::stage;

/// Pixels of the depth buffer to one of the picture, in each direction.
const FACTOR: usize = 2;

impl Picture<'_> {
    /// The picture as SVG: the triangles that are seen, those behind first, then the parts of edges and layers that nothing hides;
    /// hidden parts of the lines of layers are thin and faint. What is hidden is told by a depth buffer of the size of the picture, twice
    /// as fine.
    ///
    /// # Complexity
    /// Linear in the triangles, the pixels and the lengths of lines in pixels, and sorting what is seen.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::{Picture, PictureStyle, Scene};
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// let picture = Picture::new(&scene, &PictureStyle::default())?;
    /// assert!(picture.svg().starts_with("<svg "));
    /// # Ok(()) }
    /// ```
    pub fn svg(&self) -> String {
        let drawing = self.drawing();
        drawing.svg_of_size(drawing.size())
    }

    /// The picture as PDF, as vectors: what [`svg`](Self::svg) has. A pixel is 0.75 points.
    ///
    /// # Complexity
    /// That of [`svg`](Self::svg).
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::{Picture, PictureStyle, Scene};
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let scene = Scene::of("square", &square)?;
    /// let picture = Picture::new(&scene, &PictureStyle::default())?;
    /// assert!(picture.pdf().starts_with(b"%PDF-1.4"));
    /// # Ok(()) }
    /// ```
    pub fn pdf(&self) -> Vec<u8> {
        let drawing = self.drawing();
        drawing.pdf_of_size(drawing.size())
    }

    fn drawing(&self) -> FlatPicture {
        let mut raster = self.raster(FACTOR, self.theme.background);
        let mut facets = self.facets.clone();
        let order = painting_order(&mut facets, &mut raster, FACTOR, |facets| {
            self.raster_of(facets, FACTOR, self.theme.background)
        });
        let mut drawing =
            FlatPicture::new(self.scene.title(), self.size.map(|side| side as f64), self.theme.background);
        if self.is_transparent {
            drawing = drawing.transparent();
        }
        let facets = order.iter().map(|&number| &facets[number as usize]);
        drawing.triangles(
            facets.map(|facet| (facet.color, facet.corners.map(|[x, y, _]| rounded([x, y])))).collect(),
        );
        let sight = Sight { raster: &raster, factor: FACTOR as f64, slack: 1.5 * self.reach };
        let wire_width = WIRE_OF_EDGE * self.edge_width;
        let [edge_color, wire_color] = self.edge_colors();
        for (edges, width, color) in
            [(&self.edges, self.edge_width, edge_color), (&self.wires, wire_width, wire_color)]
        {
            let lines = edges.iter().map(|edge| edge.map(|vertex| self.place(vertex)));
            let [seen, _] = paths(&sight, lines);
            if !seen.is_empty() {
                drawing.line(seen, color, width, 1.0);
            }
        }
        for &vertex in &self.dots {
            draw_dot(&sight, self.place(vertex), DOT_WIDTH, self.theme.ink, &mut drawing);
        }
        for (layer, color) in shown(self.scene) {
            drawing.begin_group(&layer.name);
            let pairs = layer.lines.iter().flat_map(|line| line.windows(2));
            let lines = pairs.map(|pair| [pair[0], pair[1]].map(|point| self.place_in(layer, point)));
            let [seen, hidden] = paths(&sight, lines);
            if !hidden.is_empty() {
                let share = HIDDEN_SHARE as f32 / 256.0;
                drawing.line(hidden, color, HIDDEN_OF_LINE * self.line_width, share);
            }
            if !seen.is_empty() {
                drawing.line(seen, color, self.line_width, 1.0);
            }
            let mut heads = Vec::new();
            for corners in self.arrowheads(layer) {
                let middle = [0, 1, 2].map(|i| corners.iter().map(|corner| corner[i]).sum::<f64>() / 3.0);
                if sight.is_seen(middle) {
                    let [a, b, c] = corners.map(|[x, y, _]| rounded([x, y]));
                    heads.extend([Step::Move(a), Step::Line(b), Step::Line(c), Step::Close]);
                }
            }
            if !heads.is_empty() {
                drawing.fill(heads, color, 1.0);
            }
            for &point in &layer.points {
                draw_dot(&sight, self.place_in(layer, point), point_width(layer), color, &mut drawing);
            }
            for &point in &layer.rings {
                let place = self.place_in(layer, point);
                if sight.is_seen(place) {
                    let width = 0.5 * (POINT_WIDTH - HOLE_WIDTH);
                    let at = rounded([place[0], place[1]]);
                    let radius = 0.25 * (POINT_WIDTH + HOLE_WIDTH);
                    drawing.disk(at, radius, self.theme.background, Some((color, width)));
                }
            }
            for (point, label) in &layer.labels {
                let place = self.place_in(layer, *point);
                if layer.group == LABELS && !sight.is_seen(place) {
                    continue;
                }
                let (at, anchor) = beside(place, label, self.size);
                drawing.text(rounded(at), anchor, TEXT_SIZE, color, label.clone());
            }
        }
        if let Some(legend) = &self.legend {
            drawing.begin_group("legend");
            legend.draw(&mut drawing);
        }
        drawing
    }
}

/// A tenth of a pixel is as fine as anyone sees.
fn rounded(place: [f64; 2]) -> [f64; 2] {
    place.map(|coordinate| (10.0 * coordinate).round() / 10.0)
}

/// Two paths: what is seen of lines, and what is hidden.
fn paths(sight: &Sight<'_>, lines: impl Iterator<Item = [[f64; 3]; 2]>) -> [Vec<Step>; 2] {
    let mut paths = [Vec::new(), Vec::new()];
    let mut ends = [[f64::NAN; 2]; 2];
    let steps = stage("drawing lines", 0);
    for line in steps.each(lines) {
        sight.parts(line, |[[ax, ay, _], [bx, by, _]], is_seen| {
            let place = usize::from(!is_seen);
            let path = &mut paths[place];
            if ends[place] != [ax, ay] {
                path.push(Step::Move(rounded([ax, ay])));
            }
            path.push(Step::Line(rounded([bx, by])));
            ends[place] = [bx, by];
        });
    }
    paths
}

fn draw_dot(sight: &Sight<'_>, place: [f64; 3], width: f64, color: Color, drawing: &mut FlatPicture) {
    let opacity = if sight.is_seen(place) { 1.0 } else { HIDDEN_SHARE as f32 / 256.0 };
    drawing.faint_disk(rounded([place[0], place[1]]), 0.5 * width, color, opacity);
}
