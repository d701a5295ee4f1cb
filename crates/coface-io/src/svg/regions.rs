//! The filled shapes of a drawing as curves that bound sets.

use super::curves::{FilledPath, Subpath};
use super::reading::{ShapePaths, outlines_remark, read_paths};
use crate::yin::{BoundaryCurve, BoundaryDrawing, Filling};
use crate::{Place, Remark, RemarkCode};
use coface_algebra::Error;
use coface_yin::{Curve, Order};
use std::io::Read;

/// Reads the filled shapes of a drawing with their curves: order 4 if there is a curve, else 2.
///
/// Arcs become cubics that are within 1e-9 of their longer half axis of them; quadratics become cubics exactly up to rounding. What is filled is what
/// [`read_flattened`](super::read_flattened) makes rings of: open subpaths are closed with a remark, lines and shapes that are not filled
/// (`fill="none"`) are passed over, and where nothing is filled, closed outlines are taken for shapes.
///
/// # Errors
/// As [`read_flattened`](super::read_flattened).
pub(crate) fn read_regions(input: impl Read) -> Result<BoundaryDrawing, Error> {
    let ShapePaths { filled, outlines, mut passed_over, undone } = read_paths(input)?;
    let is_outline = filled.is_empty();
    let mut paths = filled;
    if is_outline {
        paths = outlines;
    } else {
        passed_over += outlines.len();
    }
    for path in &mut paths {
        let (count, element) = (path.subpaths.len(), path.element.clone());
        path.subpaths.retain(|subpath| match is_outline {
            true => subpath.comes_back(&element),
            false => subpath.may_fill(),
        });
        passed_over += usize::from(path.subpaths.len() < count && !path.is_exterior);
    }
    paths.retain(|path| path.is_exterior || !path.subpaths.is_empty());
    let subpaths = || paths.iter().flat_map(|path| &path.subpaths);
    let has_curves = subpaths().any(|subpath| !subpath.cubics.is_empty());
    let arc_error = subpaths().map(|subpath| subpath.arc_error).fold(0.0, f64::max);
    let order = if has_curves { Order::CUBIC } else { Order::LINEAR };
    let mut drawing = BoundaryDrawing::new(order);
    let mut unclosed = Vec::new();
    for path in &paths {
        let frame = usize::from(path.is_exterior);
        let rings = path.subpaths.iter().skip(frame).filter(|subpath| subpath.corners.len() > 1);
        let curves: Vec<BoundaryCurve> = rings
            .map(|subpath| {
                if !subpath.is_closed && subpath.corners.first() != subpath.corners.last() {
                    unclosed.push((path, subpath));
                }
                curve(path, subpath, order).map_err(|error| error.at_line(path.line))
            })
            .collect::<Result<_, _>>()?;
        if curves.is_empty() && path.is_exterior {
            drawing = BoundaryDrawing::plane(order);
        } else if !curves.is_empty() {
            let filling = if path.is_exterior { Filling::Left } else { Filling::Stated(path.rule) };
            drawing.push(filling, curves);
        }
    }
    if is_outline {
        outlines_remark(paths.len()).into_iter().for_each(|remark| drawing.remark(remark));
    }
    if let Some(remark) = unclosed_remark(&unclosed) {
        drawing.remark(remark);
    }
    if arc_error > 0.0 {
        drawing.remark(Remark::new(
            RemarkCode::ArcsApproximated,
            format!("arcs became cubics that are within {arc_error:.1e} of them"),
        ));
    }
    if passed_over > 0 {
        let what = if passed_over == 1 { "element is" } else { "elements are" };
        drawing.remark(Remark::new(RemarkCode::ElementsLeftOut, format!(
            "{passed_over} {what} not filled and passed over: lines, paths without fill, text, images or copies from other files"
        )));
    }
    undone.remark().into_iter().for_each(|remark| drawing.remark(remark));
    Ok(drawing)
}

/// That open subpaths are closed.
fn unclosed_remark(unclosed: &[(&FilledPath, &Subpath)]) -> Option<Remark> {
    let &(path, subpath) = unclosed.first()?;
    let others = match unclosed.len() {
        1 => String::new(),
        2 => "; 1 more ring is closed so".to_owned(),
        count => format!("; {} more rings are closed so", count - 1),
    };
    let ([x, y], [u, v]) = (subpath.corners[0], subpath.corners[subpath.corners.len() - 1]);
    let message = format!(
        "a part of <{}> in line {} begins at ({x}, {y}) but ends at ({u}, {v}), and is closed{others}",
        path.element, path.line
    );
    let places = unclosed.iter().map(|(path, _)| Place::line(path.line));
    Some(Remark::new(RemarkCode::UnclosedRing, message).at(unclosed.len(), places))
}

fn curve(path: &FilledPath, subpath: &Subpath, order: Order) -> Result<BoundaryCurve, Error> {
    let mut corners = subpath.corners.clone();
    let (first, last) = (corners[0], corners[corners.len() - 1]);
    if first != last {
        corners.push(first);
    }
    let count = corners.len() - 1;
    let mut curve = BoundaryCurve::new(corners[..count].to_vec());
    curve.set_name(path.name.clone());
    curve.set_line(path.line);
    if order > Order::LINEAR {
        // Whether a path goes on smoothly at its corners is not said: so they all may be kinks.
        curve.set_kinks((0..count as u32).collect());
        let straight = Curve::polyline(&corners)?;
        let raised = straight.raised(order)?;
        let mut controls = raised.controls().to_vec();
        for &(side, inner) in &subpath.cubics {
            controls[3 * side + 1..3 * side + 3].copy_from_slice(&inner);
        }
        curve.set_curve(Curve::from_controls(order, controls, straight.knots().to_vec())?);
    }
    Ok(curve)
}
