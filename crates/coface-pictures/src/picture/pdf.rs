//! Flat pictures as PDF (ISO 32000-1): one page, one stream of drawing operators, and a font that every reader has.

use super::flat::{Anchor, FlatPicture, Form, Part, STROKE_OF_TEXT, Step, Stroke, text_strokes};
use super::formula::{Face, Formula, symbol, width};
use super::letters::without_accent;
use super::palette::Color;
use std::collections::BTreeSet;
use std::fmt::Write as _;
#[cfg(feature = "compression")]
use std::io::Write as _;

/// Points in a pixel: 72 of one and 96 of the other to the inch.
const POINTS: f64 = 0.75;

/// The distance of control points of a quarter of a unit circle from its ends: the arc is off by at most 3e-4.
const QUARTER: f64 = 0.552_284_749_8;

/// Widths of the letters from the blank to the tilde in Helvetica, in thousandths of its size (Adobe Font Metrics).
const WIDTHS: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556, 556, 556,
    556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667, 611, 778, 722, 278,
    500, 667, 556, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469,
    556, 333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, 556, 556, 333, 500,
    278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584,
];

impl FlatPicture {
    /// The picture as PDF, scaled to fit a width and a height in pixels.
    pub(super) fn pdf_of_size(&self, size: [f64; 2]) -> Vec<u8> {
        let [width, height] = size.map(|side| POINTS * side);
        let scale = (width / self.size[0]).min(height / self.size[1]);
        let offset = [0.5 * (width - scale * self.size[0]), 0.5 * (height + scale * self.size[1])];
        let mut page = Page::default();
        if let Some(background) = self.background {
            page.color(background, "rg");
            let _ = writeln!(page.operators, "0 0 {} {} re f", Short(width), Short(height));
        }
        // Pixels count downwards, points upwards.
        let _ = writeln!(
            page.operators,
            "q {scale:.6} 0 0 {:.6} {} {} cm 1 j",
            -scale,
            Short(offset[0]),
            Short(offset[1])
        );
        self.parts.iter().for_each(|part| page.draw(part));
        page.operators.push_str("Q\n");
        page.file(&self.title, [width, height])
    }
}

/// What is drawn so far.
#[derive(Default)]
struct Page {
    operators: String,
    /// Opacities in thousandths, in the order in which they were needed.
    opacities: Vec<u16>,
    /// The fonts that formulas needed, beside the one of texts.
    fonts: BTreeSet<Font>,
}

/// Fonts of formulas.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Font {
    Letters(Face),
    Symbol,
}

impl Font {
    /// Its name in the page, the name that readers know it by, and what its codes are.
    fn words(self) -> [&'static str; 3] {
        const LATIN: &str = " /Encoding /WinAnsiEncoding";
        match self {
            Self::Letters(Face::Upright) => ["R", "Times-Roman", LATIN],
            Self::Letters(Face::Italic) => ["I", "Times-Italic", LATIN],
            Self::Letters(Face::Bold) => ["B", "Times-Bold", LATIN],
            Self::Symbol => ["S", "Symbol", ""],
        }
    }
}

/// A number with at most three decimals, none of them a zero at the end.
struct Short(f64);

impl std::fmt::Display for Short {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let text = format!("{:.3}", self.0 + 0.0);
        let text = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

impl Page {
    /// Appends a point and the operator that takes it.
    fn point(&mut self, [x, y]: [f64; 2], operator: &str) {
        let _ = write!(self.operators, "{} {} {operator} ", Short(x), Short(y));
    }

    fn color(&mut self, color: Color, operator: &str) {
        let [red, green, blue] = color.map(|part| Short(f64::from(part)));
        let _ = writeln!(self.operators, "{red} {green} {blue} {operator}");
    }

    /// From here on fills and lines have this opacity.
    fn opacity(&mut self, opacity: f32) {
        let thousandths = (1000.0 * opacity.clamp(0.0, 1.0)).round() as u16;
        let place = self.opacities.iter().position(|&known| known == thousandths).unwrap_or_else(|| {
            self.opacities.push(thousandths);
            self.opacities.len() - 1
        });
        let _ = writeln!(self.operators, "/G{place} gs");
    }

    fn stroke(&mut self, stroke: Stroke) {
        self.color(stroke.color, "RG");
        let cap = u8::from(stroke.has_round_ends);
        let _ = writeln!(self.operators, "{} w {cap} J", Short(stroke.width));
    }

    fn draw(&mut self, part: &Part) {
        let opacity =
            part.stroke.filter(|_| part.fill.is_none()).map_or(part.opacity, |stroke| stroke.opacity);
        if opacity < 1.0 {
            self.opacity(opacity);
        }
        match &part.form {
            Form::Path(steps) => self.painted(steps, part),
            Form::Triangles(triangles) => self.triangles(triangles),
            Form::Disk { center, radius } => self.painted(&circle(*center, *radius), part),
            Form::Text { at, anchor, size, text, turn } => {
                let color = part.fill.unwrap_or_default();
                if text.chars().all(|letter| matches!(without_accent(letter).0, ' '..='~')) {
                    self.color(color, "rg");
                    self.text(*at, *anchor, *size, text, *turn);
                } else {
                    self.stroke(Stroke {
                        color,
                        width: STROKE_OF_TEXT * size,
                        opacity: 1.0,
                        has_round_ends: true,
                    });
                    self.strokes(&text_strokes(*at, *anchor, *size, text, *turn));
                }
            }
            Form::Image { corner, sides, columns, pixels } => self.image(*corner, *sides, *columns, pixels),
            Form::Formula { at, anchor, size, formula } => {
                self.formula(*at, *anchor, *size, formula, part.fill.unwrap_or_default());
            }
        }
        if opacity < 1.0 {
            self.opacity(1.0);
        }
    }

    /// A path with the colors of a part, which stand before it.
    fn painted(&mut self, steps: &[Step], part: &Part) {
        if let Some(color) = part.fill {
            self.color(color, "rg");
        }
        if let Some(stroke) = part.stroke {
            self.stroke(stroke);
        }
        self.path(steps);
        self.operators.push_str(match (part.fill.is_some(), part.stroke.is_some()) {
            (true, true) => "B*\n",
            (true, false) => "f*\n",
            (false, true) => "S\n",
            (false, false) => "n\n",
        });
    }

    fn path(&mut self, steps: &[Step]) {
        for step in steps {
            match *step {
                Step::Move(to) => self.point(to, "m"),
                Step::Line(to) => self.point(to, "l"),
                Step::Cubic([first, second, to]) => {
                    self.point(first, "");
                    self.point(second, "");
                    self.point(to, "c");
                }
                Step::Close => self.operators.push_str("h "),
            }
        }
    }

    fn triangles(&mut self, triangles: &[(Color, [[f64; 2]; 3])]) {
        self.operators.push_str("0.5 w\n");
        for run in triangles.chunk_by(|a, b| a.0 == b.0) {
            self.color(run[0].0, "rg");
            self.color(run[0].0, "RG");
            for (_, [a, b, c]) in run {
                self.point(*a, "m");
                self.point(*b, "l");
                self.point(*c, "l");
                self.operators.push_str("h ");
            }
            self.operators.push_str("B\n");
        }
    }

    /// Grey pixels as inline images: one for each run of pixels of a row that have values, or one of all.
    fn image(&mut self, [x, y]: [f64; 2], [width, height]: [f64; 2], columns: usize, pixels: &[Option<u8>]) {
        let rows = pixels.len() / columns;
        let step = [width / columns as f64, height / rows as f64];
        let whole: Option<Vec<u8>> = pixels.iter().copied().collect();
        if let Some(whole) = whole {
            self.inline_image([x, y], [width, height], columns, &whole);
            return;
        }
        for (row, line) in pixels.chunks_exact(columns).enumerate() {
            let mut start = 0;
            for run in line.chunk_by(|a, b| a.is_some() == b.is_some()) {
                let own: Option<Vec<u8>> = run.iter().copied().collect();
                if let Some(own) = own {
                    let corner = [x + step[0] * start as f64, y + step[1] * row as f64];
                    self.inline_image(corner, [step[0] * run.len() as f64, step[1]], run.len(), &own);
                }
                start += run.len();
            }
        }
    }

    fn inline_image(&mut self, [x, y]: [f64; 2], [width, height]: [f64; 2], columns: usize, pixels: &[u8]) {
        let rows = pixels.len() / columns;
        // An image is a square of side 1, upwards.
        let _ = write!(
            self.operators,
            "q {} 0 0 {} {} {} cm BI /W {columns} /H {rows} /CS /G /BPC 8 /F /AHx ID ",
            Short(width),
            Short(-height),
            Short(x),
            Short(y + height)
        );
        for pixel in pixels {
            let _ = write!(self.operators, "{pixel:02X}");
        }
        self.operators.push_str("> EI Q\n");
    }

    fn strokes(&mut self, lines: &[Vec<[f64; 2]>]) {
        for line in lines {
            for (place, point) in line.iter().enumerate() {
                self.point(*point, if place == 0 { "m" } else { "l" });
            }
            self.operators.push_str("S\n");
        }
    }

    /// A text of ASCII and of letters of Latin-1 with accents, turned by an angle in degrees.
    fn text(&mut self, at: [f64; 2], anchor: Anchor, size: f64, text: &str, turn: f64) {
        let plain = text.chars().map(|letter| without_accent(letter).0);
        let width: f64 = plain.map(|letter| f64::from(WIDTHS[letter as usize - usize::from(b' ')])).sum();
        let left = anchor.left(0.0, 1e-3 * size * width);
        let (sine, cosine) = turn.to_radians().sin_cos();
        let mut words = String::with_capacity(text.len());
        for letter in text.chars() {
            match letter {
                '\\' | '(' | ')' => words.extend(['\\', letter]),
                ' '..='~' => words.push(letter),
                // In WinAnsiEncoding as in Latin-1.
                _ => words += &format!("\\{:03o}", u32::from(letter)),
            }
        }
        let _ = writeln!(
            self.operators,
            "BT /F {} Tf {} {} {} {} {} {} Tm ({words}) Tj ET",
            Short(size),
            Short(cosine),
            Short(-sine),
            Short(-sine),
            Short(-cosine),
            Short(at[0] + cosine * left),
            Short(at[1] - sine * left)
        );
    }

    fn formula(&mut self, at: [f64; 2], anchor: Anchor, size: f64, formula: &Formula, color: Color) {
        let left = anchor.left(at[0], size * formula.width);
        self.color(color, "rg");
        for run in &formula.runs {
            let [mut x, y] = [left + size * run.at[0], at[1] - size * run.at[1]];
            let font_of = |letter: char| {
                if symbol(letter).is_some() { Font::Symbol } else { Font::Letters(run.face) }
            };
            let letters: Vec<char> = run.text.chars().collect();
            for same in letters.chunk_by(|&a, &b| font_of(a) == font_of(b)) {
                let font = font_of(same[0]);
                self.fonts.insert(font);
                let mut words = String::new();
                for &letter in same {
                    let code = symbol(letter).map_or(u32::from(letter), |(code, _)| u32::from(code));
                    // What no font has here is a question.
                    let code = u8::try_from(code).unwrap_or(b'?');
                    let _ = write!(words, "{code:02X}");
                }
                let [name, ..] = font.words();
                let size = Short(size * run.size);
                let [at_x, at_y] = [Short(x), Short(y)];
                let _ = writeln!(
                    self.operators,
                    "BT /{name} {size} Tf 1 0 0 -1 {at_x} {at_y} Tm <{words}> Tj ET"
                );
                x += size.0 * same.iter().map(|&letter| width(run.face, letter)).sum::<f64>();
            }
        }
    }

    /// The file: catalog, pages, the page, its operators, the font, the title, and where each of them begins.
    fn file(self, title: &str, [width, height]: [f64; 2]) -> Vec<u8> {
        let mut states = String::new();
        for (place, thousandths) in self.opacities.iter().enumerate() {
            let share = Short(f64::from(*thousandths) / 1000.0);
            let _ = write!(states, " /G{place} << /ca {share} /CA {share} >>");
        }
        let title: String = title.encode_utf16().fold("FEFF".to_owned(), |mut text, unit| {
            let _ = write!(text, "{unit:04X}");
            text
        });
        let (operators, filter) = packed(self.operators.as_bytes());
        let mut stream = format!("<< /Length {}{filter} >>\nstream\n", operators.len()).into_bytes();
        stream.extend(operators);
        stream.extend(b"\nendstream");
        let mut fonts = String::new();
        for (number, font) in (7..).zip(&self.fonts) {
            let [name, ..] = font.words();
            let _ = write!(fonts, " /{name} {number} 0 R");
        }
        let of_formulas = self.fonts.iter().map(|font| {
            let [_, name, codes] = font.words();
            format!("<< /Type /Font /Subtype /Type1 /BaseFont /{name}{codes} >>").into_bytes()
        });
        let mut objects = vec![
            b"<< /Type /Catalog /Pages 2 0 R >>".to_vec(),
            b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>".to_vec(),
            format!(
                "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {} {}] /Contents 4 0 R /Resources << /Font << /F 5 0 R{fonts} >> /ExtGState <<{states} >> >> >>",
                Short(width),
                Short(height)
            )
            .into_bytes(),
            stream,
            b"<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>".to_vec(),
            format!("<< /Title <{title}> /Producer (coface) >>").into_bytes(),
        ];
        objects.extend(of_formulas);
        let mut file = b"%PDF-1.4\n%\xE2\xE3\xCF\xD3\n".to_vec();
        let mut places = String::new();
        for (number, object) in (1..).zip(&objects) {
            let _ = writeln!(places, "{:010} 00000 n ", file.len());
            file.extend(format!("{number} 0 obj\n").into_bytes());
            file.extend(object);
            file.extend(b"\nendobj\n");
        }
        let start = file.len();
        let count = objects.len() + 1;
        let end = format!(
            "xref\n0 {count}\n0000000000 65535 f \n{places}trailer\n<< /Size {count} /Root 1 0 R /Info 6 0 R >>\nstartxref\n{start}\n%%EOF\n"
        );
        file.extend(end.into_bytes());
        file
    }
}

/// A stream and what its dictionary says of how it is packed.
#[cfg(feature = "compression")]
fn packed(bytes: &[u8]) -> (Vec<u8>, &'static str) {
    let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
    match encoder.write_all(bytes).and_then(|()| encoder.finish()) {
        Ok(short) => (short, " /Filter /FlateDecode"),
        // Memory takes whatever is written: this does not happen.
        Err(_) => (bytes.to_vec(), ""),
    }
}

#[cfg(not(feature = "compression"))]
fn packed(bytes: &[u8]) -> (Vec<u8>, &'static str) {
    (bytes.to_vec(), "")
}

fn circle([x, y]: [f64; 2], radius: f64) -> [Step; 6] {
    let at = |along: f64, across: f64| [x + radius * along, y + radius * across];
    let quarter = |[a, b]: [f64; 2]| {
        // From the direction (a, b) to the left of it.
        let (c, d) = (-b, a);
        Step::Cubic([at(a + QUARTER * c, b + QUARTER * d), at(c + QUARTER * a, d + QUARTER * b), at(c, d)])
    };
    let starts = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].map(quarter);
    [Step::Move(at(1.0, 0.0)), starts[0], starts[1], starts[2], starts[3], Step::Close]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::palette::of;

    fn square() -> Vec<Step> {
        let mut path: Vec<Step> = [[2.0, 2.0], [8.0, 2.0], [8.0, 8.0], [2.0, 8.0]].map(Step::Line).to_vec();
        path[0] = Step::Move([2.0, 2.0]);
        path.push(Step::Close);
        path
    }

    fn operators(picture: &FlatPicture) -> String {
        let mut page = Page::default();
        picture.parts.iter().for_each(|part| page.draw(part));
        page.operators
    }

    #[test]
    fn shapes_are_drawn_with_their_colors() {
        let mut picture = FlatPicture::new("t", [20.0, 10.0], of(0xffffff));
        picture.shape(square(), of(0xff0000), (of(0x0000ff), 1.5));
        assert_eq!(operators(&picture), "1 0 0 rg\n0 0 1 RG\n1.5 w 0 J\n2 2 m 8 2 l 8 8 l 2 8 l h B*\n");
    }

    #[test]
    fn opacity_ends_with_its_part() {
        let mut picture = FlatPicture::new("t", [20.0, 10.0], of(0xffffff));
        picture.fill(square(), of(0), 0.25);
        picture.fill(square(), of(0), 1.0);
        let text = operators(&picture);
        assert_eq!(text.matches("/G0 gs").count(), 1);
        assert!(text.find("/G1 gs") < text.rfind("f*") && text.find("f*") < text.find("/G1 gs"));
    }

    #[test]
    fn objects_begin_where_the_table_says() {
        let mut picture = FlatPicture::new("Z \u{2295} Z/2", [60.0, 20.0], of(0xffffff));
        picture.text([30.0, 15.0], Anchor::Middle, 12.0, of(0), "H_1 (a\\b)");
        picture.text([30.0, 15.0], Anchor::Middle, 12.0, of(0), "\u{2295}");
        let file = picture.pdf_of_size([60.0, 20.0]);
        let text = String::from_utf8_lossy(&file);
        let table = text.lines().filter(|line| line.ends_with(" 00000 n ")).enumerate();
        let mut count = 0;
        for (place, line) in table {
            let start: usize = line[..10].parse().unwrap_or_default();
            assert!(file[start..].starts_with(format!("{} 0 obj\n", place + 1).as_bytes()), "{line}");
            count += 1;
        }
        assert_eq!(count, 6);
        assert!(text.contains("/MediaBox [0 0 45 15]") && text.contains("<FEFF005A00202295"));
        // A text of 10 letters in the middle; parentheses are escaped.
        assert!(operators(&picture).contains("(H_1 \\(a\\\\b\\)) Tj"));
    }
}
