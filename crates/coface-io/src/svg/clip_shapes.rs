//! The basic shapes of CSS as clips: `inset()`, `circle()`, `ellipse()` and `polygon()`.

use super::curves::Pen;
use super::elements::FillRule;
use super::viewport::{Extent, Viewport};

/// A basic shape and the box that it is in.
pub(super) struct BasicShape<'a> {
    name: &'a str,
    arguments: &'a str,
    /// Whether outlines belong to the box.
    pub(super) has_strokes: bool,
}

impl<'a> BasicShape<'a> {
    /// Reads a value of `clip-path`; `None` if it is no such shape, or one in a box that is not known.
    pub(super) fn parse(value: &'a str) -> Option<Self> {
        let (name, rest) = value.trim().split_once('(')?;
        let (arguments, place) = rest.split_once(')')?;
        let has_strokes = match place.trim() {
            "" | "border-box" | "margin-box" | "stroke-box" => true,
            "fill-box" | "content-box" | "padding-box" => false,
            _ => return None,
        };
        Some(Self { name: name.trim(), arguments: arguments.trim(), has_strokes })
    }

    /// Draws it in a box of a size, from its upper left corner; `None` if a word of it is not known.
    pub(super) fn draw(&self, viewport: &Viewport, size: [f64; 2], pen: &mut Pen) -> Option<FillRule> {
        let inside = viewport.of_box(size);
        let [width, height] = size;
        match self.name {
            "inset" => {
                let sides: Vec<&str> = self.arguments.split_ascii_whitespace().collect();
                let [top, right, bottom, left] = match sides[..] {
                    [all] => [all; 4],
                    [ends, flanks] => [ends, flanks, ends, flanks],
                    [top, flanks, bottom] => [top, flanks, bottom, flanks],
                    [top, right, bottom, left] => [top, right, bottom, left],
                    _ => return None,
                };
                let [top, bottom] =
                    [inside.parsed(top, Extent::Height)?, inside.parsed(bottom, Extent::Height)?];
                let [left, right] =
                    [inside.parsed(left, Extent::Width)?, inside.parsed(right, Extent::Width)?];
                let (right, bottom) = (width - right, height - bottom);
                if left < right && top < bottom {
                    polygon([[left, top], [right, top], [right, bottom], [left, bottom]], pen);
                }
                Some(FillRule::Nonzero)
            }
            "polygon" => {
                let mut parts: Vec<&str> = self.arguments.split(',').map(str::trim).collect();
                let rule = match parts[0] {
                    "evenodd" => Some(FillRule::EvenOdd),
                    "nonzero" => Some(FillRule::Nonzero),
                    _ => None,
                };
                parts.drain(..usize::from(rule.is_some()));
                let corner = |part: &str| {
                    let (x, y) = part.split_once(|c: char| c.is_ascii_whitespace())?;
                    Some([inside.parsed(x, Extent::Width)?, inside.parsed(y, Extent::Height)?])
                };
                let corners: Vec<[f64; 2]> = parts.into_iter().map(corner).collect::<Option<_>>()?;
                polygon(corners, pen);
                Some(rule.unwrap_or(FillRule::Nonzero))
            }
            "circle" | "ellipse" => {
                let words: Vec<&str> = self.arguments.split_ascii_whitespace().collect();
                let at = words.iter().position(|word| *word == "at").unwrap_or(words.len());
                let center = center(words.get(at + 1..).unwrap_or_default(), &inside, size)?;
                let gaps = [0, 1].map(|axis| [center[axis].abs(), (size[axis] - center[axis]).abs()]);
                let radius = |word: &str, of: Extent, gaps: &[f64]| match word {
                    "closest-side" => gaps.iter().copied().reduce(f64::min),
                    "farthest-side" => gaps.iter().copied().reduce(f64::max),
                    length => inside.parsed(length, of).filter(|radius| *radius >= 0.0),
                };
                let radii = match (self.name, &words[..at]) {
                    ("circle", []) => [radius("closest-side", Extent::Diagonal, gaps.as_flattened())?; 2],
                    ("circle", [word]) => [radius(word, Extent::Diagonal, gaps.as_flattened())?; 2],
                    ("ellipse", []) => [0, 1].map(|axis| gaps[axis][0].min(gaps[axis][1])),
                    ("ellipse", [rx, ry]) => {
                        [radius(rx, Extent::Width, &gaps[0])?, radius(ry, Extent::Height, &gaps[1])?]
                    }
                    _ => return None,
                };
                if radii.iter().all(|radius| *radius > 0.0) {
                    pen.whole_ellipse(center, radii).ok()?;
                }
                Some(FillRule::Nonzero)
            }
            _ => None,
        }
    }
}

fn polygon(corners: impl IntoIterator<Item = [f64; 2]>, pen: &mut Pen) {
    for (number, corner) in corners.into_iter().enumerate() {
        if number == 0 { pen.move_to(corner) } else { pen.line_to(corner) }
    }
    pen.close();
}

/// A position in a box: one or two words, the middle for none.
fn center(words: &[&str], inside: &Viewport, size: [f64; 2]) -> Option<[f64; 2]> {
    let place = |word: &str, axis: usize| match (word, axis) {
        ("left", 0) | ("top", 1) => Some(0.0),
        ("right", 0) | ("bottom", 1) => Some(size[axis]),
        ("center", _) => Some(size[axis] / 2.0),
        (length, 0) => inside.parsed(length, Extent::Width),
        (length, _) => inside.parsed(length, Extent::Height),
    };
    match *words {
        [] => Some(size.map(|side| side / 2.0)),
        [word @ ("top" | "bottom")] => Some([size[0] / 2.0, place(word, 1)?]),
        [x] => Some([place(x, 0)?, size[1] / 2.0]),
        [y @ ("top" | "bottom"), x] | [x, y @ ("top" | "bottom")] => Some([place(x, 0)?, place(y, 1)?]),
        [y, x @ ("left" | "right")] => Some([place(x, 0)?, place(y, 1)?]),
        [x, y] => Some([place(x, 0)?, place(y, 1)?]),
        _ => None,
    }
}
