//! Pictures of scenes as SVG: what is hidden is left out.

use super::Picture;
use super::painting::painting_order;
use super::palette::{hex, packed};
use super::scene_picture::{
    DOT_WIDTH, EDGE_WIDTH, HIDDEN_SHARE, HIDDEN_WIDTH, LINE_WIDTH, POINT_WIDTH, TEXT_SIZE, WIRE_WIDTH, shown,
};
use super::sight::Sight;
use super::svg_text::{escaped, push_point};
use coface_algebra::progress::stage;
use std::fmt::Write;

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
        let mut raster = self.raster(FACTOR);
        let order = painting_order(&self.facets, &mut raster, FACTOR);
        let [width, height] = self.size;
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" font-family=\"sans-serif\" font-size=\"{TEXT_SIZE}\">\n<title>{}</title>\n<path d=\"M0 0H{width}V{height}H0Z\" fill=\"{}\"/>\n",
            escaped(self.scene.title()),
            hex(self.theme.background)
        );
        self.push_facets(&order, &mut text);
        let sight = Sight { raster: &raster, factor: FACTOR as f64, slack: 1.5 * self.reach };
        for (edges, width, color) in
            [(&self.edges, EDGE_WIDTH, self.theme.edge), (&self.wires, WIRE_WIDTH, self.theme.ink)]
        {
            let lines = edges.iter().map(|edge| edge.map(|vertex| self.place(vertex)));
            let [seen, _] = paths(&sight, lines);
            if !seen.is_empty() {
                let _ = writeln!(
                    text,
                    "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\" stroke-linecap=\"round\" d=\"{seen}\"/>",
                    hex(color)
                );
            }
        }
        let ink = hex(self.theme.ink);
        for &vertex in &self.dots {
            push_dot(&sight, self.place(vertex), DOT_WIDTH, &ink, &mut text);
        }
        for (layer, color) in shown(self.scene) {
            let color = hex(color);
            let _ = writeln!(text, "<g fill=\"none\" stroke=\"{color}\" stroke-linecap=\"round\">");
            let _ = writeln!(text, "<title>{}</title>", escaped(&layer.name));
            let pairs = layer.lines.iter().flat_map(|line| line.windows(2));
            let lines = pairs.map(|pair| [pair[0], pair[1]].map(|point| self.place_in(layer, point)));
            let [seen, hidden] = paths(&sight, lines);
            if !hidden.is_empty() {
                let share = f64::from(HIDDEN_SHARE) / 256.0;
                let _ = writeln!(
                    text,
                    "<path stroke-width=\"{HIDDEN_WIDTH}\" stroke-opacity=\"{share}\" d=\"{hidden}\"/>"
                );
            }
            if !seen.is_empty() {
                let _ = writeln!(text, "<path stroke-width=\"{LINE_WIDTH}\" d=\"{seen}\"/>");
            }
            let mut heads = String::new();
            for corners in self.arrowheads(layer) {
                let middle = [0, 1, 2].map(|i| corners.iter().map(|corner| corner[i]).sum::<f64>() / 3.0);
                if sight.is_seen(middle) {
                    for (place, [x, y, _]) in corners.into_iter().enumerate() {
                        heads.push(if place == 0 { 'M' } else { 'L' });
                        push_point(&mut heads, [x, y]);
                    }
                    heads.push('Z');
                }
            }
            if !heads.is_empty() {
                let _ = writeln!(text, "<path fill=\"{color}\" stroke=\"none\" d=\"{heads}\"/>");
            }
            text += "</g>\n";
            for &point in &layer.points {
                push_dot(&sight, self.place_in(layer, point), POINT_WIDTH, &color, &mut text);
            }
            for (point, label) in &layer.labels {
                let [x, y, _] = self.place_in(layer, *point);
                let [x, y] = [x + 6.0, y - 6.0];
                let _ = writeln!(
                    text,
                    "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"{color}\">{}</text>",
                    escaped(label)
                );
            }
        }
        text += "</svg>\n";
        text
    }

    /// The facets of this order; those of one color that come after each other are one path.
    fn push_facets(&self, order: &[u32], text: &mut String) {
        // A thin rim of the same color closes the gaps that antialiasing leaves.
        text.push_str("<g fill=\"currentColor\" stroke=\"currentColor\" stroke-width=\"0.5\" stroke-linejoin=\"round\">\n");
        for run in order
            .chunk_by(|&a, &b| packed(self.facets[a as usize].color) == packed(self.facets[b as usize].color))
        {
            let _ = write!(text, "<path color=\"{}\" d=\"", hex(self.facets[run[0] as usize].color));
            for &number in run {
                for (place, [x, y, _]) in self.facets[number as usize].corners.into_iter().enumerate() {
                    text.push(if place == 0 { 'M' } else { 'L' });
                    push_point(text, [x, y]);
                }
                text.push('Z');
            }
            text.push_str("\"/>\n");
        }
        text.push_str("</g>\n");
    }
}

/// The data of two paths: what is seen of lines, and what is hidden.
fn paths(sight: &Sight<'_>, lines: impl Iterator<Item = [[f64; 3]; 2]>) -> [String; 2] {
    let mut paths = [String::new(), String::new()];
    let mut ends = [[f64::NAN; 2]; 2];
    let steps = stage("drawing lines", 0);
    for line in steps.each(lines) {
        sight.parts(line, |[[ax, ay, _], [bx, by, _]], is_seen| {
            let place = usize::from(!is_seen);
            let path = &mut paths[place];
            if ends[place] != [ax, ay] {
                path.push('M');
                push_point(path, [ax, ay]);
            }
            path.push('L');
            push_point(path, [bx, by]);
            ends[place] = [bx, by];
        });
    }
    paths
}

fn push_dot(sight: &Sight<'_>, place: [f64; 3], width: f64, color: &str, text: &mut String) {
    let opacity = if sight.is_seen(place) { "" } else { " fill-opacity=\"0.375\"" };
    let [x, y, _] = place;
    let radius = 0.5 * width;
    let _ = writeln!(text, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{color}\"{opacity}/>");
}
