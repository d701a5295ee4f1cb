//! The filled shapes of a drawing as curves that bound sets.

use super::curves::{FilledPath, Subpath};
use super::reading::{ShapePaths, read_paths};
use crate::yin::{BoundaryCurve, BoundaryDrawing, Filling};
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use coface_yin::{Curve, Order};
use std::io::Read;

/// Reads the filled shapes of a drawing with their curves: order 4 if there is a curve, else 2.
///
/// Arcs become cubics that are within 1e-9 of their longer half axis of them; quadratics become cubics exactly up to rounding. Shapes
/// that are not filled (`fill="none"`) and lines are passed over; but where nothing is filled, closed outlines are taken for shapes, and a
/// warning says so.
///
/// # Errors
/// As [`read_flattened`](super::read_flattened); [`ErrorKind::NotACycle`] naming a path that is not closed, with its line.
pub(crate) fn read_regions(input: impl Read) -> Result<BoundaryDrawing, Error> {
    let ShapePaths { filled, outlines, mut passed_over } = read_paths(input)?;
    let is_outline = filled.is_empty();
    let paths: Vec<FilledPath> = if is_outline {
        let (closed, open): (Vec<_>, Vec<_>) = outlines.into_iter().partition(FilledPath::is_closed);
        passed_over += open.len();
        closed
    } else {
        passed_over += outlines.len();
        filled
    };
    let subpaths = || paths.iter().flat_map(|path| &path.subpaths);
    let has_curves = subpaths().any(|subpath| !subpath.cubics.is_empty());
    let arc_error = subpaths().map(|subpath| subpath.arc_error).fold(0.0, f64::max);
    let order = if has_curves { Order::CUBIC } else { Order::LINEAR };
    let mut drawing = BoundaryDrawing::new(order);
    for path in &paths {
        let frame = usize::from(path.is_exterior);
        let rings = path.subpaths.iter().skip(frame).filter(|subpath| subpath.corners.len() > 1);
        let curves: Vec<BoundaryCurve> = rings
            .map(|subpath| curve(path, subpath, order).map_err(|error| error.at_line(path.line)))
            .collect::<Result<_, _>>()?;
        if curves.is_empty() && path.is_exterior {
            drawing = BoundaryDrawing::plane(order);
        } else if !curves.is_empty() {
            let filling = if path.is_exterior { Filling::Left } else { Filling::Stated(path.rule) };
            drawing.push(filling, curves);
        }
    }
    if is_outline && !paths.is_empty() {
        let what = if paths.len() == 1 { "closed outline is" } else { "closed outlines are" };
        drawing.remark(Remark::new(
            RemarkCode::DrawingAssumption,
            format!("nothing is filled: {} {what} taken for the boundary of filled shapes", paths.len()),
        ));
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
    Ok(drawing)
}

fn curve(path: &FilledPath, subpath: &Subpath, order: Order) -> Result<BoundaryCurve, Error> {
    let mut corners = subpath.corners.clone();
    let (first, last) = (corners[0], corners[corners.len() - 1]);
    if first != last {
        if !subpath.is_closed {
            return Err(Error::new(
                ErrorKind::NotACycle,
                format!(
                    "<{}> begins at ({}, {}) but ends at ({}, {}): an open path bounds no set",
                    path.element, first[0], first[1], last[0], last[1]
                ),
            )
            .with_cure("close it with Z, or give it fill=\"none\" so that it is passed over"));
        }
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
