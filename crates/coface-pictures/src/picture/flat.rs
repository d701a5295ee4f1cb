//! Flat pictures: diagrams, matrices, sets of the plane.

use super::canvas::{Canvas, centers};
use super::formula::Formula;
use super::letters;
use super::palette::{Color, packed};
use super::style::{SAMPLES, check_size};
use coface_algebra::Error;

/// A picture without depth: paths, triangles, disks and texts, one painted over the other. It is written as SVG and PDF, where texts stay texts,
/// and as PNG, where they are drawn with strokes and need no font.
///
/// # Examples
/// ```
/// use coface_pictures::matrix_picture;
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = [(0, 0, -1), (1, 0, 1), (0, 1, -1), (2, 1, 1), (1, 2, -1), (2, 2, 1)];
/// let face = [(0, 0, 1), (1, 0, -1), (2, 0, 1)];
/// let matrices = vec![SparseMatrix::from_entries(3, 3, edges)?, SparseMatrix::from_entries(3, 1, face)?];
/// let triangle = ChainComplex::new(matrices)?;
/// let picture = matrix_picture("triangle", &triangle);
/// assert!(picture.svg(None)?.contains("<title>triangle</title>"));
/// assert!(picture.png([200, 100])?.starts_with(b"\x89PNG"));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FlatPicture {
    pub(super) title: String,
    pub(super) size: [f64; 2],
    /// None where what lies behind the picture shows through.
    pub(super) background: Option<Color>,
    pub(super) parts: Vec<Part>,
    /// The names of parts that belong together.
    pub(super) groups: Vec<String>,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    pub(super) form: Form,
    pub(super) fill: Option<Color>,
    pub(super) stroke: Option<Stroke>,
    /// Of the fill.
    pub(super) opacity: f32,
    /// The place of its name among the groups.
    pub(super) group: Option<u32>,
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stroke {
    pub(super) color: Color,
    pub(super) width: f64,
    pub(super) opacity: f32,
    pub(super) has_round_ends: bool,
}

impl From<(Color, f64)> for Stroke {
    fn from((color, width): (Color, f64)) -> Self {
        Self { color, width, opacity: 1.0, has_round_ends: false }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Form {
    Path(Vec<Step>),
    /// Triangles that each have a color of their own, and a thin rim of it that closes the gaps which antialiasing leaves.
    Triangles(Vec<(Color, [[f64; 2]; 3])>),
    Disk {
        center: [f64; 2],
        radius: f64,
    },
    Text {
        at: [f64; 2],
        anchor: Anchor,
        size: f64,
        text: String,
        /// In degrees, counterclockwise about its place.
        turn: f64,
    },
    /// Grey pixels, row after row from the top, of a rectangle; those without a value are not drawn.
    Image {
        corner: [f64; 2],
        sides: [f64; 2],
        columns: usize,
        pixels: Vec<Option<u8>>,
    },
    Formula {
        at: [f64; 2],
        anchor: Anchor,
        size: f64,
        formula: Formula,
    },
}

/// A step of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Step {
    Move([f64; 2]),
    Line([f64; 2]),
    Cubic([[f64; 2]; 3]),
    Close,
}

/// Which end of a text stands at its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

impl FlatPicture {
    /// Nothing on a background.
    pub(crate) fn new(title: &str, size: [f64; 2], background: Color) -> Self {
        Self {
            title: title.to_owned(),
            size,
            background: Some(background),
            parts: Vec::new(),
            groups: Vec::new(),
        }
    }

    /// The same picture without its background: what lies behind it shows through.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::{Layer, Pane, pane_picture};
    /// let mut layer = Layer::new("graph", "an edge");
    /// layer.lines.push(&[0, 1]);
    /// let mut pane = Pane::default();
    /// pane.positions = vec![[0.0, 0.0], [1.0, 0.0]];
    /// pane.layers.push(layer);
    /// let [usual, bare] = [pane_picture(&pane), pane_picture(&pane).transparent()];
    /// assert!(usual.svg(None)?.contains("<path d=\"M0 0H"));
    /// assert!(!bare.svg(None)?.contains("<path d=\"M0 0H"));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn transparent(mut self) -> Self {
        self.background = None;
        self
    }

    /// What is added from here on belongs together, under this name.
    pub(crate) fn begin_group(&mut self, name: &str) {
        self.groups.push(name.to_owned());
    }

    fn push(&mut self, form: Form, fill: Option<Color>, stroke: Option<Stroke>, opacity: f32) {
        let group = (self.groups.len() as u32).checked_sub(1);
        self.parts.push(Part { form, fill, stroke, opacity, group });
    }

    /// Fills triangles, each with its own color. All run around in one direction then: in one path those that lie over each other would else
    /// leave a hole.
    pub(super) fn triangles(&mut self, mut triangles: Vec<(Color, [[f64; 2]; 3])>) {
        for (_, corners) in &mut triangles {
            let [a, b, c] = *corners;
            if (b[0] - a[0]) * (c[1] - a[1]) < (b[1] - a[1]) * (c[0] - a[0]) {
                corners.swap(1, 2);
            }
        }
        self.push(Form::Triangles(triangles), None, None, 1.0);
    }

    /// Draws along a path, with round ends.
    pub(super) fn line(&mut self, path: Vec<Step>, color: Color, width: f64, opacity: f32) {
        let stroke = Stroke { color, width, opacity, has_round_ends: true };
        self.push(Form::Path(path), None, Some(stroke), 1.0);
    }

    /// Draws a disk that lets through what is behind it.
    pub(super) fn faint_disk(&mut self, center: [f64; 2], radius: f64, color: Color, opacity: f32) {
        self.push(Form::Disk { center, radius }, Some(color), None, opacity);
    }

    /// Fills what lies within an odd number of the closed parts of a path.
    pub(crate) fn fill(&mut self, path: Vec<Step>, color: Color, opacity: f32) {
        self.push(Form::Path(path), Some(color), None, opacity);
    }

    /// Draws along a path.
    pub(crate) fn stroke(&mut self, path: Vec<Step>, color: Color, width: f64) {
        self.push(Form::Path(path), None, Some((color, width).into()), 1.0);
    }

    /// Fills a path and draws along it.
    pub(crate) fn shape(&mut self, path: Vec<Step>, fill: Color, stroke: (Color, f64)) {
        self.push(Form::Path(path), Some(fill), Some(stroke.into()), 1.0);
    }

    /// Draws a disk, with a rim if there is a stroke.
    pub(crate) fn disk(&mut self, center: [f64; 2], radius: f64, fill: Color, stroke: Option<(Color, f64)>) {
        self.push(Form::Disk { center, radius }, Some(fill), stroke.map(Stroke::from), 1.0);
    }

    /// Writes a text on a baseline.
    pub(crate) fn text(
        &mut self,
        at: [f64; 2],
        anchor: Anchor,
        size: f64,
        color: Color,
        text: impl Into<String>,
    ) {
        self.push(Form::Text { at, anchor, size, text: text.into(), turn: 0.0 }, Some(color), None, 1.0);
    }

    /// Writes a text upwards to the right.
    pub(super) fn slanted_text(&mut self, at: [f64; 2], size: f64, color: Color, text: String) {
        let form = Form::Text { at, anchor: Anchor::Start, size, text, turn: 45.0 };
        self.push(form, Some(color), None, 1.0);
    }

    /// Draws grey pixels, row after row from the top, in a rectangle.
    pub(super) fn image(
        &mut self,
        corner: [f64; 2],
        sides: [f64; 2],
        columns: usize,
        pixels: Vec<Option<u8>>,
    ) {
        self.push(Form::Image { corner, sides, columns, pixels }, None, None, 1.0);
    }

    /// Writes a formula on a baseline.
    pub(crate) fn formula(
        &mut self,
        at: [f64; 2],
        anchor: Anchor,
        size: f64,
        color: Color,
        formula: Formula,
    ) {
        self.push(Form::Formula { at, anchor, size, formula }, Some(color), None, 1.0);
    }

    /// Width and height of the picture in its own unit.
    ///
    /// # Examples
    /// ```
    /// use coface_pictures::{Layer, Pane, pane_picture};
    /// let mut layer = Layer::new("graph", "an edge");
    /// layer.lines.push(&[0, 1]);
    /// let mut pane = Pane::default();
    /// pane.positions = vec![[0.0, 0.0], [1.0, 0.0]];
    /// pane.layers.push(layer);
    /// let picture = pane_picture(&pane);
    /// assert!(picture.size().iter().all(|&side| side > 0.0));
    /// ```
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// The picture as SVG, of its own size or scaled to fit one in pixels.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a size of 0.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::{Layer, Pane, pane_picture};
    /// let mut layer = Layer::new("graph", "an edge");
    /// layer.lines.push(&[0, 1]);
    /// let mut pane = Pane::default();
    /// pane.positions = vec![[0.0, 0.0], [1.0, 0.0]];
    /// pane.layers.push(layer);
    /// let picture = pane_picture(&pane);
    /// assert!(picture.svg(Some([80, 60]))?.contains("width=\"80\" height=\"60\""));
    /// assert!(picture.svg(Some([0, 60])).is_err());
    /// # Ok(()) }
    /// ```
    pub fn svg(&self, size: Option<[usize; 2]>) -> Result<String, Error> {
        Ok(self.svg_of_size(self.sides(size)?))
    }

    /// Width and height of the picture where a size was or was not asked for.
    fn sides(&self, size: Option<[usize; 2]>) -> Result<[f64; 2], Error> {
        match size {
            Some(size) if size.contains(&0) => {
                Err(Error::invalid("a picture without pixels").with_cure("give a width and a height above 0"))
            }
            Some(size) => Ok(size.map(|side| side as f64)),
            None => Ok(self.size),
        }
    }

    /// The picture as PDF, of its own size or scaled to fit one, in pixels of 0.75 points, 96 to the inch. Texts of ASCII are in Helvetica, which
    /// every reader of PDF has; others are drawn with strokes.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a size of 0.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::{Layer, Pane, pane_picture};
    /// let mut layer = Layer::new("graph", "an edge");
    /// layer.lines.push(&[0, 1]);
    /// let mut pane = Pane::default();
    /// pane.positions = vec![[0.0, 0.0], [1.0, 0.0]];
    /// pane.layers.push(layer);
    /// let file = pane_picture(&pane).pdf(Some([80, 60]))?;
    /// assert!(file.starts_with(b"%PDF-1.4"));
    /// # Ok(()) }
    /// ```
    pub fn pdf(&self, size: Option<[usize; 2]>) -> Result<Vec<u8>, Error> {
        Ok(self.pdf_of_size(self.sides(size)?))
    }

    /// The picture as PNG, scaled to fit a size in pixels, antialiased.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a size of 0, [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond
    /// $2^{25}$ pixels; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) should the encoder fail.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::{Layer, Pane, pane_picture};
    /// let mut layer = Layer::new("graph", "an edge");
    /// layer.lines.push(&[0, 1]);
    /// let mut pane = Pane::default();
    /// pane.positions = vec![[0.0, 0.0], [1.0, 0.0]];
    /// pane.layers.push(layer);
    /// let picture = pane_picture(&pane);
    /// assert!(picture.png([80, 60])?.starts_with(b"\x89PNG"));
    /// # Ok(()) }
    /// ```
    pub fn png(&self, size: [usize; 2]) -> Result<Vec<u8>, Error> {
        check_size(size)?;
        let [width, height] = size;
        let scale = (width as f64 / self.size[0]).min(height as f64 / self.size[1]);
        let offset = [0, 1].map(|axis| SAMPLES as f64 * 0.5 * (size[axis] as f64 - scale * self.size[axis]));
        Canvas::png_on(self.background, SAMPLES, |background| {
            let mut canvas = Canvas::new(width * SAMPLES, height * SAMPLES, background);
            self.paint(&mut canvas, scale * SAMPLES as f64, offset);
            canvas
        })
    }

    /// Paints all parts, scaled and moved.
    pub(super) fn paint(&self, canvas: &mut Canvas, scale: f64, offset: [f64; 2]) {
        let place = |[x, y]: [f64; 2]| [offset[0] + scale * x, offset[1] + scale * y];
        for part in &self.parts {
            let share = (part.opacity * 256.0).round() as u32;
            match &part.form {
                Form::Path(steps) => {
                    let lines = flattened(steps, place);
                    if let Some(color) = part.fill {
                        let outlines: Vec<Vec<[f64; 2]>> =
                            lines.iter().map(|(line, _)| line.clone()).collect();
                        canvas.fill(&outlines, packed(color), share);
                    }
                    if let Some(stroke) = part.stroke {
                        for (line, is_closed) in &lines {
                            paint_line(canvas, line, *is_closed, stroke.width * scale, packed(stroke.color));
                        }
                    }
                }
                Form::Triangles(triangles) => {
                    for (color, corners) in triangles {
                        canvas.fill(&[corners.map(place).to_vec()], packed(*color), share);
                    }
                }
                Form::Disk { center, radius } => {
                    let circle = circle(place(*center), radius * scale);
                    if let Some(color) = part.fill {
                        canvas.fill(std::slice::from_ref(&circle), packed(color), share);
                    }
                    if let Some(stroke) = part.stroke {
                        paint_line(canvas, &circle, true, stroke.width * scale, packed(stroke.color));
                    }
                }
                Form::Text { at, anchor, size, text, turn } => {
                    let color = packed(part.fill.unwrap_or_default());
                    for line in text_strokes(*at, *anchor, *size, text, *turn) {
                        let line: Vec<[f64; 2]> = line.into_iter().map(place).collect();
                        paint_line(canvas, &line, false, STROKE_OF_TEXT * size * scale, color);
                    }
                }
                Form::Image { corner, sides, columns, pixels } => {
                    let ends = [place(*corner), place([corner[0] + sides[0], corner[1] + sides[1]])];
                    paint_image(canvas, ends, *columns, pixels);
                }
                Form::Formula { at, anchor, size, formula } => {
                    let color = packed(part.fill.unwrap_or_default());
                    for (width, line) in formula_strokes(*at, *anchor, *size, formula) {
                        let line: Vec<[f64; 2]> = line.into_iter().map(place).collect();
                        paint_line(canvas, &line, false, width * scale, color);
                    }
                }
            }
        }
    }
}

impl Anchor {
    /// Where a text of this width begins.
    pub(super) fn left(self, x: f64, width: f64) -> f64 {
        match self {
            Self::Start => x,
            Self::Middle => x - 0.5 * width,
            Self::End => x - width,
        }
    }
}

/// The width of the strokes of a text, for one of size 1.
pub(super) const STROKE_OF_TEXT: f64 = 0.1;

/// The strokes of a text on a baseline.
pub(super) fn text_strokes(
    at: [f64; 2],
    anchor: Anchor,
    size: f64,
    text: &str,
    turn: f64,
) -> Vec<Vec<[f64; 2]>> {
    let left = anchor.left(0.0, letters::width(text) * size);
    let (sine, cosine) = turn.to_radians().sin_cos();
    let mut strokes = letters::strokes(text);
    for [x, y] in strokes.iter_mut().flatten() {
        let (right, up) = (left + size * *x, size * *y);
        (*x, *y) = (at[0] + cosine * right - sine * up, at[1] - sine * right - cosine * up);
    }
    strokes
}

/// The strokes of a formula on a baseline, each with its width.
pub(super) fn formula_strokes(
    at: [f64; 2],
    anchor: Anchor,
    size: f64,
    formula: &Formula,
) -> Vec<(f64, Vec<[f64; 2]>)> {
    let left = anchor.left(at[0], formula.width * size);
    let mut strokes = formula.strokes();
    for (width, line) in &mut strokes {
        *width *= size;
        line.iter_mut().for_each(|[x, y]| (*x, *y) = (left + size * *x, at[1] - size * *y));
    }
    strokes
}

/// Paints grey pixels between two corners.
fn paint_image(canvas: &mut Canvas, [low, high]: [[f64; 2]; 2], columns: usize, pixels: &[Option<u8>]) {
    let rows = pixels.len() / columns;
    let step = [(high[0] - low[0]) / columns as f64, (high[1] - low[1]) / rows as f64];
    for y in centers(low[1], high[1], canvas.height) {
        let row = ((((y as f64 + 0.5) - low[1]) / step[1]) as usize).min(rows - 1);
        for x in centers(low[0], high[0], canvas.width) {
            let column = ((((x as f64 + 0.5) - low[0]) / step[0]) as usize).min(columns - 1);
            if let Some(grey) = pixels[row * columns + column] {
                canvas.pixels[y * canvas.width + x] = 0x01_0101 * u32::from(grey);
            }
        }
    }
}

/// The lines of a path, cubics as chords, each with whether it is closed.
fn flattened(steps: &[Step], place: impl Fn([f64; 2]) -> [f64; 2]) -> Vec<(Vec<[f64; 2]>, bool)> {
    let mut lines: Vec<(Vec<[f64; 2]>, bool)> = Vec::new();
    for step in steps {
        match (*step, lines.last_mut()) {
            (Step::Move(to), _) => lines.push((vec![place(to)], false)),
            (Step::Line(to), Some((line, _))) => line.push(place(to)),
            (Step::Cubic(controls), Some((line, _))) => {
                let Some(&a) = line.last() else { continue };
                let [b, c, d] = controls.map(&place);
                let length: f64 =
                    [[a, b], [b, c], [c, d]].iter().map(|[p, q]| (q[0] - p[0]).hypot(q[1] - p[1])).sum();
                let count = (0.5 * length).sqrt().ceil().clamp(2.0, 256.0) as usize;
                line.extend((1..=count).map(|i| {
                    let t = i as f64 / count as f64;
                    let s = 1.0 - t;
                    [0, 1].map(|axis| {
                        s * s * s * a[axis] + 3.0 * s * t * (s * b[axis] + t * c[axis]) + t * t * t * d[axis]
                    })
                }));
            }
            (Step::Close, Some((_, is_closed))) => *is_closed = true,
            (_, None) => {}
        }
    }
    lines
}

fn circle([x, y]: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    let count = (4.0 * radius.max(1.0).sqrt()).ceil().clamp(12.0, 200.0) as usize;
    let angle = |i: usize| i as f64 * std::f64::consts::TAU / count as f64;
    (0..count).map(|i| [x + radius * angle(i).cos(), y + radius * angle(i).sin()]).collect()
}

/// Paints a line with round joints and ends.
fn paint_line(canvas: &mut Canvas, line: &[[f64; 2]], is_closed: bool, width: f64, color: u32) {
    let half = 0.5 * width;
    let first = line.first().filter(|_| is_closed && line.len() > 2);
    let corners: Vec<[f64; 2]> = line.iter().chain(first).copied().collect();
    for pair in corners.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypot(dy);
        if length > 0.0 {
            let (x, y) = (-dy / length * half, dx / length * half);
            let band =
                vec![[a[0] + x, a[1] + y], [a[0] - x, a[1] - y], [b[0] - x, b[1] - y], [b[0] + x, b[1] + y]];
            canvas.fill(&[band], color, 256);
        }
    }
    if width > 2.0 {
        corners.iter().for_each(|&corner| canvas.fill(&[circle(corner, half)], color, 256));
    }
}

#[cfg(all(test, feature = "png"))]
#[allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
mod tests {
    use super::*;
    use crate::picture::palette::of;

    fn pixels(picture: &FlatPicture, size: [usize; 2]) -> Vec<[u8; 3]> {
        let bytes = picture.png(size).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
        let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut buffer).unwrap();
        buffer.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
    }

    #[test]
    fn shapes_are_where_they_belong() {
        let mut picture = FlatPicture::new("t", [20.0, 10.0], of(0xffffff));
        let square = [[2.0, 2.0], [8.0, 2.0], [8.0, 8.0], [2.0, 8.0]];
        let mut path: Vec<Step> = square.map(Step::Line).to_vec();
        path[0] = Step::Move(square[0]);
        path.push(Step::Close);
        picture.fill(path, of(0xff0000), 1.0);
        picture.disk([15.0, 5.0], 3.0, of(0x0000ff), None);
        // Twice the size, centered with room above and below.
        let pixels = pixels(&picture, [40, 40]);
        let at = |x: usize, y: usize| pixels[y * 40 + x];
        assert_eq!((at(5, 15), at(10, 20), at(3, 20)), ([255, 0, 0], [255, 0, 0], [255; 3]));
        assert_eq!((at(30, 20), at(30, 27), at(20, 5)), ([0, 0, 255], [255; 3], [255; 3]));
        assert!(picture.svg(None).unwrap().contains("M2 2L8 2L8 8L2 8Z"));
    }

    #[test]
    fn cubics_are_round() {
        let mut picture = FlatPicture::new("t", [10.0, 10.0], of(0xffffff));
        let bow = Step::Cubic([[0.0, 10.0], [10.0, 10.0], [10.0, 0.0]]);
        picture.fill(vec![Step::Move([0.0, 0.0]), bow, Step::Close], of(0), 1.0);
        let black = pixels(&picture, [100, 100]).iter().filter(|pixel| pixel[0] < 128).count();
        // The area under it is 3 / 5 of its box of 10 by 10.
        assert!(black.abs_diff(6000) < 60, "{black}");
    }

    #[test]
    fn texts_leave_ink() {
        let mut picture = FlatPicture::new("t", [60.0, 20.0], of(0xffffff));
        picture.text([30.0, 15.0], Anchor::Middle, 12.0, of(0), "H_1 = Z");
        let dark = |columns: std::ops::Range<usize>| {
            let pixels = pixels(&picture, [60, 20]);
            columns.map(|x| (0..20).filter(|y| pixels[y * 60 + x][0] < 200).count()).sum::<usize>()
        };
        assert!(dark(5..30) > 20 && dark(30..55) > 20 && dark(0..4) == 0 && dark(56..60) == 0);
    }
}
