//! A set as one path of SVG.

use super::PlanarSet;
use coface_algebra::Error;
use coface_yin::{Curve, Order};
use std::fmt::Write as _;

const INK: &str = "#246";
const FILL: &str = "#9ac";

impl PlanarSet {
    /// The box of the plane that a picture shows: that of the curves with a margin, wider around what is unbounded.
    #[doc(hidden)]
    pub fn frame(&self) -> [[f64; 2]; 2] {
        let [low, high] = self.bounding_box().unwrap_or([[0.0; 2], [1.0; 2]]);
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        let margin = if self.set.is_bounded() { 0.02 } else { 0.15 } * extent;
        [low.map(|x| x - margin), high.map(|x| x + margin)]
    }

    /// One path, its numbers the coordinates of the set; browsers show the second axis pointing up. The rest of the plane within a frame
    /// belongs to a set that is unbounded, and an attribute says so to readers.
    pub(super) fn svg(&self) -> Result<String, Error> {
        let [low, high] = self.frame();
        let size = [high[0] - low[0], high[1] - low[1]];
        let mut text = String::from("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"");
        for number in [low[0], low[1], size[0], size[1]] {
            push(&mut text, number);
            text.push(' ');
        }
        text.pop();
        let _ = write!(text, "\" fill=\"{FILL}\" stroke=\"{INK}\" stroke-linejoin=\"round\" stroke-width=\"");
        push(&mut text, (0.002 * size[0].max(size[1])).max(f64::MIN_POSITIVE));
        text.push_str("\" style=\"transform:scaleY(-1)\">\n");
        if !self.set.is_empty() {
            text.push_str("<path ");
            if !self.set.is_bounded() {
                text.push_str("data-unbounded=\"true\" ");
            }
            text.push_str("d=\"");
            if !self.set.is_bounded() {
                for (letter, [x, y]) in
                    ["M", "L", "L", "L"].into_iter().zip([low, [high[0], low[1]], high, [low[0], high[1]]])
                {
                    text.push_str(letter);
                    push(&mut text, x);
                    text.push(' ');
                    push(&mut text, y);
                }
                text.push('Z');
            }
            for curve in 0..self.set.curve_count() {
                push_curve(&mut text, &self.set.curve(curve))?;
            }
            text.push_str("\"/>\n");
        }
        text.push_str("</svg>\n");
        Ok(text)
    }
}

fn push(text: &mut String, number: f64) {
    let size = number.abs();
    let _ = match size == 0.0 || (1e-5..1e16).contains(&size) {
        true => write!(text, "{number}"),
        false => write!(text, "{number:e}"),
    };
}

/// A closed curve as the data of a path: lines, and cubics where it bends.
fn push_curve(text: &mut String, curve: &Curve<'_>) -> Result<(), Error> {
    let point = |text: &mut String, [x, y]: [f64; 2]| {
        push(text, x);
        text.push(' ');
        push(text, y);
    };
    text.push('M');
    point(text, curve.knot_point(0));
    for piece in pieces_of(curve)? {
        match piece {
            Piece::Line(end) => {
                text.push('L');
                point(text, end);
            }
            Piece::Cubic(controls) => {
                for (letter, control) in ["C", " ", " "].into_iter().zip(controls) {
                    text.push_str(letter);
                    point(text, control);
                }
            }
        }
    }
    text.push('Z');
    Ok(())
}

/// A piece of a curve behind its start.
#[doc(hidden)]
#[derive(Debug)]
pub enum Piece {
    /// A straight piece, by its end.
    Line([f64; 2]),
    /// A cubic, by its last three control points.
    Cubic([[f64; 2]; 3]),
}

/// The pieces of a closed curve; a last one that is straight is left out, since closing draws it.
#[doc(hidden)]
pub fn pieces_of(curve: &Curve<'_>) -> Result<Vec<Piece>, Error> {
    let count = curve.piece_count();
    let corners: Vec<[f64; 2]> = (0..=count).map(|knot| curve.knot_point(knot)).collect();
    // What is straight is so bit for bit.
    let straight = match curve.order() {
        Order::LINEAR => None,
        order => Curve::polyline(&corners).and_then(|line| line.raised(order)).ok(),
    };
    let mut pieces = Vec::with_capacity(count);
    for piece in 0..count {
        let controls = curve.piece(piece);
        let is_line = curve.order() == Order::LINEAR
            || straight.as_ref().is_some_and(|straight| straight.piece(piece) == controls);
        match (is_line, controls) {
            (true, _) if piece + 1 == count => {}
            (true, _) => pieces.push(Piece::Line(corners[piece + 1])),
            (false, &[_, first, second, end]) => pieces.push(Piece::Cubic([first, second, end])),
            _ => {
                return Err(Error::new(
                    coface_algebra::ErrorKind::UnsupportedFormat,
                    format!("SVG cannot hold curves of order {}", curve.order()),
                )
                .with_cure("say how far chords may be from them: --flatten LENGTH"));
            }
        }
    }
    Ok(pieces)
}
