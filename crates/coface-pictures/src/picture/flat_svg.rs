//! Flat pictures as SVG.

use super::flat::{Anchor, FlatPicture, Form, Part, Step};
use super::formula::{Face, Formula};
use super::palette::{Color, hex, packed};
#[cfg(feature = "png")]
use super::pixels::Pixels;
use super::svg_text::{escaped, push_point, push_short};
#[cfg(feature = "png")]
use base64::Engine;
#[cfg(feature = "png")]
use base64::engine::general_purpose::STANDARD;
use std::fmt::Write;

impl FlatPicture {
    /// The picture as SVG, scaled to fit a width and a height in pixels.
    pub(super) fn svg_of_size(&self, [width, height]: [f64; 2]) -> String {
        let [wide, high] = self.size;
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {wide:.0} {high:.0}\" width=\"{width:.0}\" height=\"{height:.0}\" font-family=\"sans-serif\">\n<title>{}</title>\n",
            escaped(&self.title)
        );
        if let Some(background) = self.background {
            let _ = writeln!(text, "<path d=\"M0 0H{wide:.0}V{high:.0}H0Z\" fill=\"{}\"/>", hex(background));
        }
        for parts in self.parts.chunk_by(|a, b| a.group == b.group) {
            let name = parts[0].group.map(|group| &self.groups[group as usize]);
            if let Some(name) = name {
                let _ = writeln!(text, "<g>\n<title>{}</title>", escaped(name));
            }
            parts.iter().for_each(|part| part.push_svg(&mut text));
            if name.is_some() {
                text += "</g>\n";
            }
        }
        text += "</svg>\n";
        text
    }
}

/// Triangles; those of one color that come after each other are one path.
fn push_triangles(triangles: &[(Color, [[f64; 2]; 3])], text: &mut String) {
    text.push_str("<g stroke-width=\"0.5\" stroke-linejoin=\"round\">\n");
    for run in triangles.chunk_by(|a, b| packed(a.0) == packed(b.0)) {
        let color = hex(run[0].0);
        let _ = write!(text, "<path fill=\"{color}\" stroke=\"{color}\" d=\"");
        for (_, corners) in run {
            for (letter, corner) in ['M', 'L', 'L'].into_iter().zip(corners) {
                text.push(letter);
                push_point(text, *corner);
            }
            text.push('Z');
        }
        text.push_str("\"/>\n");
    }
    text.push_str("</g>\n");
}

impl Part {
    fn push_svg(&self, text: &mut String) {
        let mut style = match self.fill {
            Some(color) => format!(" fill=\"{}\"", hex(color)),
            None => " fill=\"none\"".to_owned(),
        };
        if self.opacity < 1.0 {
            let _ = write!(style, " fill-opacity=\"{:.2}\"", self.opacity);
        }
        if let Some(stroke) = self.stroke {
            let width = (1e3 * stroke.width).round() / 1e3;
            let _ = write!(style, " stroke=\"{}\" stroke-width=\"{width}\"", hex(stroke.color));
            if stroke.opacity < 1.0 {
                let _ = write!(style, " stroke-opacity=\"{}\"", stroke.opacity);
            }
            if stroke.has_round_ends {
                style.push_str(" stroke-linecap=\"round\"");
            }
        }
        match &self.form {
            Form::Path(steps) => {
                let rule = if self.fill.is_some() { "<path fill-rule=\"evenodd\"" } else { "<path" };
                text.push_str(rule);
                text.push_str(&style);
                text.push_str(" d=\"");
                for step in steps {
                    match step {
                        Step::Move(to) => {
                            text.push('M');
                            push_fine(text, *to);
                        }
                        Step::Line(to) => {
                            text.push('L');
                            push_fine(text, *to);
                        }
                        Step::Cubic(controls) => {
                            for (letter, control) in ["C", " ", " "].into_iter().zip(controls) {
                                text.push_str(letter);
                                push_fine(text, *control);
                            }
                        }
                        Step::Close => text.push('Z'),
                    }
                }
                text.push_str("\"/>\n");
            }
            Form::Triangles(triangles) => push_triangles(triangles, text),
            Form::Disk { center, radius } => {
                let [x, y] = center;
                let _ = writeln!(text, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius}\"{style}/>");
            }
            Form::Text { at, anchor, size, text: words, turn } => {
                let anchor = match anchor {
                    Anchor::Start => "",
                    Anchor::Middle => " text-anchor=\"middle\"",
                    Anchor::End => " text-anchor=\"end\"",
                };
                let [x, y] = at;
                if *turn != 0.0 {
                    let _ = write!(style, " transform=\"rotate({} {x:.1} {y:.1})\"", -turn);
                }
                let _ = writeln!(
                    text,
                    "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{size}\"{anchor}{style}>{}</text>",
                    escaped(words)
                );
            }
            Form::Image { corner, sides, columns, pixels } => {
                push_image(*corner, *sides, *columns, pixels, text);
            }
            Form::Formula { at, anchor, size, formula } => {
                push_formula(*at, *anchor, *size, formula, &style, text);
            }
        }
    }
}

/// Grey pixels as a picture within the picture, which is not smoothed.
#[cfg(feature = "png")]
fn push_image(
    [x, y]: [f64; 2],
    [width, height]: [f64; 2],
    columns: usize,
    pixels: &[Option<u8>],
    text: &mut String,
) {
    let size = [columns, pixels.len() / columns];
    let has_opacity = pixels.contains(&None);
    let mut bytes = Vec::with_capacity(4 * pixels.len());
    for pixel in pixels {
        bytes.extend([pixel.unwrap_or(0); 3]);
        if has_opacity {
            bytes.push(if pixel.is_some() { 255 } else { 0 });
        }
    }
    let file = Pixels::png(1, 0, |_| Ok(Pixels { bytes: bytes.clone(), has_opacity, size }));
    // Memory takes whatever is written: this does not fail.
    let file = STANDARD.encode(file.unwrap_or_default());
    let _ = writeln!(
        text,
        "<image x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{file}\"/>"
    );
}

/// Grey pixels as rectangles, a path for each grey value.
#[cfg(not(feature = "png"))]
fn push_image(
    [x, y]: [f64; 2],
    [width, height]: [f64; 2],
    columns: usize,
    pixels: &[Option<u8>],
    text: &mut String,
) {
    let step = [width / columns as f64, height / (pixels.len() / columns) as f64];
    for grey in 0..=255u8 {
        let mut path = String::new();
        for (place, _) in pixels.iter().enumerate().filter(|(_, pixel)| **pixel == Some(grey)) {
            let [left, top] =
                [x + step[0] * (place % columns) as f64, y + step[1] * (place / columns) as f64];
            let _ = write!(path, "M{left:.2} {top:.2}h{:.2}v{:.2}h{:.2}Z", step[0], step[1], -step[0]);
        }
        if !path.is_empty() {
            let _ = writeln!(text, "<path fill=\"{}\" d=\"{path}\"/>", hex([f32::from(grey) / 255.0; 3]));
        }
    }
}

/// A formula as one text, each run at its own place.
fn push_formula(at: [f64; 2], anchor: Anchor, size: f64, formula: &Formula, style: &str, text: &mut String) {
    let left = anchor.left(at[0], size * formula.width);
    let _ = write!(text, "<text font-family=\"Times New Roman, Times, serif\"{style}>");
    for run in &formula.runs {
        let [x, y] = [left + size * run.at[0], at[1] - size * run.at[1]];
        let face = match run.face {
            Face::Upright => "",
            Face::Italic => " font-style=\"italic\"",
            Face::Bold => " font-weight=\"bold\"",
        };
        let size = (100.0 * size * run.size).round() / 100.0;
        let words = escaped(&run.text);
        let _ = write!(text, "<tspan x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{size}\"{face}>{words}</tspan>");
    }
    text.push_str("</text>\n");
}

/// Two numbers; whole ones short, others with two decimals.
fn push_fine(text: &mut String, [x, y]: [f64; 2]) {
    if x.fract() == 0.0 && y.fract() == 0.0 {
        push_point(text, [x, y]);
        return;
    }
    let number = |text: &mut String, number: f64| {
        if (10.0 * number - (10.0 * number).round()).abs() < 1e-9 {
            push_short(text, number);
        } else {
            let _ = write!(text, "{number:.2}");
        }
    };
    number(text, x);
    text.push(' ');
    number(text, y);
}
