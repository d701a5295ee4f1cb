//! Pictures as SVG: what is hidden is left out.

use super::Picture;
use super::palette::hex;
use super::raster::{NOTHING, Raster};
use super::style::shown;
use std::fmt::Write;

impl Picture<'_> {
    /// The picture as SVG: the triangles that are seen, from back to front, then the parts of edges and of layers that nothing
    /// hides; hidden parts of layers are dotted. What is hidden is told by a depth buffer of the size of the picture, twice as fine.
    ///
    /// # Complexity
    /// Linear in the triangles, the pixels and the lengths of lines in pixels, and sorting what is seen.
    pub fn svg(&self) -> String {
        const FACTOR: usize = 2;
        let raster = self.raster(FACTOR, false);
        let [width, height] = self.size;
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
            hex(self.theme.background)
        );
        self.push_triangles(&raster, &mut text);
        let at = |vertex: u32| self.projection.project(self.scene.positions()[vertex as usize]);
        let sight = Sight { raster: &raster, factor: FACTOR as f64, slack: 1.5 * self.reach() };
        if self.shows_edges {
            let _ = writeln!(
                text,
                "<g stroke=\"{}\" stroke-width=\"0.6\" stroke-linecap=\"round\" fill=\"none\">",
                hex(self.theme.edge)
            );
            for [a, b] in self.scene.edges() {
                sight.parts([at(a), at(b)], |part, is_seen| {
                    if is_seen {
                        push_line(&mut text, part, "");
                    }
                });
            }
            text += "</g>\n";
        }
        for (layer, color) in shown(self.scene) {
            let own = |point: u32| match &layer.positions {
                Some(own) => self.projection.project(own[point as usize]),
                None => at(point),
            };
            let _ = writeln!(
                text,
                "<g stroke=\"{0}\" stroke-width=\"3\" stroke-linecap=\"round\" fill=\"{0}\"><title>{1}</title>",
                hex(color),
                escaped(&layer.name)
            );
            for line in layer.lines.iter() {
                for pair in line.windows(2) {
                    sight.parts([own(pair[0]), own(pair[1])], |part, is_seen| {
                        let dots = " stroke-width=\"1\" stroke-dasharray=\"1 4\"";
                        push_line(&mut text, part, if is_seen { "" } else { dots });
                    });
                }
            }
            for &point in &layer.points {
                let [x, y, _] = own(point);
                let _ = writeln!(text, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"3.5\" stroke=\"none\"/>");
            }
            text += "</g>\n";
        }
        text += "</svg>\n";
        text
    }

    fn push_triangles(&self, raster: &Raster, text: &mut String) {
        let count = self.scene.triangles().len();
        let mut is_seen = vec![false; count];
        raster
            .seen
            .iter()
            .filter(|&&number| number != NOTHING)
            .for_each(|&number| is_seen[number as usize] = true);
        let mut seen: Vec<(f64, usize)> = (0..count)
            .filter(|&number| is_seen[number])
            .map(|number| {
                let corners = self.scene.triangles()[number].map(|v| self.scene.positions()[v as usize]);
                (corners.iter().map(|&corner| self.projection.project(corner)[2]).sum(), number)
            })
            .collect();
        seen.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        for (_, number) in seen {
            let corners = self.scene.triangles()[number].map(|v| self.scene.positions()[v as usize]);
            let fill = hex(self.shade(corners, self.theme.surface));
            let places = corners.map(|corner| self.projection.project(corner));
            let _ = write!(text, "<polygon points=\"");
            for (i, [x, y, _]) in places.into_iter().enumerate() {
                let _ = write!(text, "{}{x:.2},{y:.2}", if i == 0 { "" } else { " " });
            }
            // A thin rim of the same color closes the gaps that antialiasing leaves.
            let _ = writeln!(text, "\" fill=\"{fill}\" stroke=\"{fill}\" stroke-width=\"0.4\"/>");
        }
        for (layer, color) in shown(self.scene) {
            for triangle in &layer.triangles {
                let corners = triangle.map(|p| match &layer.positions {
                    Some(own) => own[p as usize],
                    None => self.scene.positions()[p as usize],
                });
                let places = corners.map(|corner| self.projection.project(corner));
                let list: Vec<String> = places.iter().map(|[x, y, _]| format!("{x:.2},{y:.2}")).collect();
                let fill = hex(self.shade(corners, color));
                let _ = writeln!(
                    text,
                    "<polygon points=\"{}\" fill=\"{fill}\" fill-opacity=\"0.8\"/>",
                    list.join(" ")
                );
            }
        }
    }
}

/// What can be seen past the triangles of a picture.
struct Sight<'a> {
    raster: &'a Raster,
    factor: f64,
    /// So much behind a triangle, a line on it still counts as in front.
    slack: f64,
}

impl Sight<'_> {
    /// Calls back with the parts of a line, and whether each is seen.
    fn parts(&self, [a, b]: [[f64; 3]; 2], mut found: impl FnMut([[f64; 3]; 2], bool)) {
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let steps = (length * self.factor).ceil().clamp(1.0, 1e5) as usize;
        let along = |step: usize| {
            let share = step as f64 / steps as f64;
            [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]))
        };
        let (mut start, mut state) = (0, self.is_seen(along(0)));
        for step in 1..=steps {
            let next = self.is_seen(along(step));
            if next != state || step == steps {
                found([along(start), along(step)], state);
                (start, state) = (step, next);
            }
        }
    }

    /// Whether a place is in front of what is drawn in its pixel or in one beside it.
    fn is_seen(&self, [x, y, depth]: [f64; 3]) -> bool {
        let (column, row) = ((x * self.factor).floor() as i64, (y * self.factor).floor() as i64);
        (-1..=1).any(|down| {
            (-1..=1).any(|right| {
                let (column, row) = (column + right, row + down);
                let inside = column >= 0
                    && row >= 0
                    && (column as usize) < self.raster.width
                    && (row as usize) < self.raster.height;
                !inside
                    || depth - self.slack
                        <= f64::from(self.raster.depths[row as usize * self.raster.width + column as usize])
            })
        })
    }
}

fn push_line(text: &mut String, [a, b]: [[f64; 3]; 2], attributes: &str) {
    let _ = writeln!(text, "<path d=\"M{:.2} {:.2}L{:.2} {:.2}\"{attributes}/>", a[0], a[1], b[0], b[1]);
}

/// Text that can stand in XML.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
