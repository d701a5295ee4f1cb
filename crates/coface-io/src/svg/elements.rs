//! The shapes of SVG and their attributes.

use super::curves::Pen;
use super::path;
use super::viewport::{Extent, Viewport};
use coface_arrange::boolean::InsideRule;
use roxmltree::Node;

/// What is inside of the rings of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FillRule {
    /// What they wind around.
    Nonzero,
    /// What they wind around an odd number of times.
    EvenOdd,
}

impl FillRule {
    /// The same rule where sets are made.
    pub(super) fn inside(self) -> InsideRule {
        match self {
            Self::Nonzero => InsideRule::Nonzero,
            Self::EvenOdd => InsideRule::Odd,
        }
    }
}

/// Whether what is in an element of this name is not drawn where it stands.
pub(super) fn is_definition(name: &str) -> bool {
    matches!(
        name,
        "defs"
            | "symbol"
            | "clipPath"
            | "mask"
            | "pattern"
            | "marker"
            | "linearGradient"
            | "radialGradient"
            | "filter"
            | "metadata"
            | "style"
            | "script"
            | "title"
            | "desc"
    )
}

/// Draws an element if it is a shape.
pub(super) fn draw(node: Node<'_, '_>, viewport: &Viewport, pen: &mut Pen) -> Result<(), String> {
    let length = |name: &str| {
        let of = match name {
            "x" | "x1" | "x2" | "cx" | "rx" | "width" => Extent::Width,
            "r" => Extent::Diagonal,
            _ => Extent::Height,
        };
        viewport.length(node, name, of)
    };
    match node.tag_name().name() {
        "path" => path::draw(node.attribute("d").unwrap_or_default(), pen),
        "polygon" => path::draw_points(node.attribute("points").unwrap_or_default(), true, pen),
        "polyline" => path::draw_points(node.attribute("points").unwrap_or_default(), false, pen),
        "line" => {
            let at = |name: &str| length(name).map(Option::unwrap_or_default);
            let [from, to] = [[at("x1")?, at("y1")?], [at("x2")?, at("y2")?]];
            pen.move_to(from);
            pen.line_to(to);
            Ok(())
        }
        "circle" => {
            let center = [length("cx")?.unwrap_or(0.0), length("cy")?.unwrap_or(0.0)];
            match length("r")? {
                Some(radius) if radius > 0.0 => pen.whole_ellipse(center, [radius; 2]),
                _ => Ok(()),
            }
        }
        "ellipse" => {
            let center = [length("cx")?.unwrap_or(0.0), length("cy")?.unwrap_or(0.0)];
            match (length("rx")?, length("ry")?) {
                (Some(rx), Some(ry)) if rx > 0.0 && ry > 0.0 => pen.whole_ellipse(center, [rx, ry]),
                (Some(r), None) | (None, Some(r)) if r > 0.0 => pen.whole_ellipse(center, [r; 2]),
                _ => Ok(()),
            }
        }
        "rect" => {
            let [x, y] = [length("x")?.unwrap_or(0.0), length("y")?.unwrap_or(0.0)];
            let [width, height] = [length("width")?.unwrap_or(0.0), length("height")?.unwrap_or(0.0)];
            if width <= 0.0 || height <= 0.0 {
                return Ok(());
            }
            let (rx, ry) = (length("rx")?, length("ry")?);
            let rx = rx.or(ry).unwrap_or(0.0).min(width / 2.0);
            let ry = ry.or(length("rx")?).unwrap_or(0.0).min(height / 2.0);
            rectangle([x, y], [width, height], [rx, ry], pen)
        }
        _ => Ok(()),
    }
}

fn rectangle(
    [x, y]: [f64; 2],
    [width, height]: [f64; 2],
    [rx, ry]: [f64; 2],
    pen: &mut Pen,
) -> Result<(), String> {
    let (right, bottom) = (x + width, y + height);
    if rx <= 0.0 || ry <= 0.0 {
        pen.move_to([x, y]);
        for corner in [[right, y], [right, bottom], [x, bottom]] {
            pen.line_to(corner);
        }
        pen.close();
        return Ok(());
    }
    pen.move_to([x + rx, y]);
    let sides = [
        ([right - rx, y], [right, y + ry]),
        ([right, bottom - ry], [right - rx, bottom]),
        ([x + rx, bottom], [x, bottom - ry]),
        ([x, y + ry], [x + rx, y]),
    ];
    for (side, corner) in sides {
        pen.line_to(side);
        pen.arc_to([rx, ry], 0.0, false, true, corner)?;
    }
    pen.close();
    Ok(())
}
