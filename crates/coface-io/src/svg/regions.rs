//! The filled shapes of a drawing as curves that bound sets.

use super::clipping::{Clip, Clips};
use super::curves::{FilledPath, Subpath};
use super::reading::{ShapePaths, outlines_remark, read_paths};
use crate::yin::{BoundaryCurve, BoundaryDrawing, Filling};
use crate::{Place, Remark, RemarkCode};
use coface_algebra::Error;
use coface_arrange::boolean::InsideRule;
use coface_yin::{Curve, EndCondition, Order, YinSet};
use std::collections::HashMap;
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
    let ShapePaths { filled, outlines, mut passed_over, is_outline, clips, mut undone } = read_paths(input)?;
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
    // A frame of an unbounded set is nothing that could be clipped.
    for path in paths.iter_mut().filter(|path| path.is_exterior) {
        undone.clip_paths += usize::from(path.clip.take().is_some());
    }
    let mut clip_sets = ClipSets::new(&clips);
    let of_clips = clip_sets.subpaths(paths.iter().filter_map(|path| path.clip));
    let subpaths = || paths.iter().flat_map(|path| &path.subpaths).chain(of_clips.iter().copied());
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
        if let Some(clip) = path.clip.filter(|_| !curves.is_empty()) {
            let seen = clip_sets.clipped(&curves, path, clip, order);
            let seen = seen.map_err(|error| error.at_line(path.line))?;
            if !seen.is_empty() {
                drawing.push(Filling::Stated(InsideRule::Nonzero), seen);
            }
        } else if curves.is_empty() && path.is_exterior {
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
    undone.remarks().for_each(|remark| drawing.remark(remark));
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

/// A subpath as a closed curve.
fn curve(path: &FilledPath, subpath: &Subpath, order: Order) -> Result<BoundaryCurve, Error> {
    let mut curve = closed_curve(subpath, order)?;
    curve.set_name(path.name.clone());
    curve.set_line(path.line);
    Ok(curve)
}

fn closed_curve(subpath: &Subpath, order: Order) -> Result<BoundaryCurve, Error> {
    let mut corners = subpath.corners.clone();
    let (first, last) = (corners[0], corners[corners.len() - 1]);
    if first != last {
        corners.push(first);
    }
    let cubics = counted_sides(&mut corners, &subpath.cubics);
    let count = corners.len() - 1;
    let mut curve = BoundaryCurve::new(corners[..count].to_vec());
    if order > Order::LINEAR {
        // Whether a path goes on smoothly at its corners is not said: so they all may be kinks.
        curve.set_kinks((0..count as u32).collect());
        let straight = Curve::polyline(&corners)?;
        let raised = straight.raised(order)?;
        let mut controls = raised.controls().to_vec();
        for (side, inner) in cubics {
            controls[3 * side + 1..3 * side + 3].copy_from_slice(&inner);
        }
        curve.set_curve(Curve::from_controls(order, controls, straight.knots().to_vec())?);
    }
    Ok(curve)
}

/// Leaves out the sides of a closed path that are too short to count beside the length before them, as programs leave them where curves
/// meet; gives the sides that are cubics by their new numbers.
fn counted_sides(
    corners: &mut Vec<[f64; 2]>,
    cubics: &[(usize, [[f64; 2]; 2])],
) -> Vec<(usize, [[f64; 2]; 2])> {
    let distance = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
    let size: f64 = corners.windows(2).map(|side| distance(side[0], side[1])).sum();
    let least = 4.0 * f64::EPSILON * size;
    let mut next_cubic = cubics.iter().peekable();
    let mut counted = Vec::with_capacity(cubics.len());
    let mut kept = vec![corners[0]];
    for (side, ends) in corners.windows(2).enumerate() {
        let inner = next_cubic.next_if(|cubic| cubic.0 == side).map(|cubic| cubic.1);
        let reach = |point: &[f64; 2]| distance(ends[0], *point) <= least;
        if reach(&ends[1]) && inner.iter().flatten().all(reach) {
            continue;
        }
        counted.extend(inner.map(|inner| (kept.len() - 1, inner)));
        kept.push(ends[1]);
    }
    // What is left ends where it begins.
    if kept.len() > 2 {
        let first = kept[0];
        kept.pop();
        kept.push(first);
        *corners = kept;
        counted
    } else {
        cubics.to_vec()
    }
}

/// The clips of a drawing as sets with curved boundaries.
struct ClipSets<'a> {
    clips: &'a Clips,
    /// Those that have been made.
    sets: HashMap<usize, YinSet>,
}

impl<'a> ClipSets<'a> {
    fn new(clips: &'a Clips) -> Self {
        Self { clips, sets: HashMap::new() }
    }

    /// The subpaths of the regions that some clips are made of.
    fn subpaths(&self, clips: impl Iterator<Item = usize>) -> Vec<&'a Subpath> {
        let mut regions: Vec<usize> = clips.flat_map(|clip| self.clips.below(clip)).collect();
        regions.sort_unstable();
        regions.dedup();
        regions.into_iter().filter_map(|own| self.clips.region(own)).flat_map(|own| &own.subpaths).collect()
    }

    /// What of a shape is seen through a clip.
    fn clipped(
        &mut self,
        curves: &[BoundaryCurve],
        path: &FilledPath,
        clip: usize,
        order: Order,
    ) -> Result<Vec<BoundaryCurve>, Error> {
        let shape = set_of(curves, path.rule, order)?;
        let seen = shape.meet(self.set(clip, order)?)?;
        Ok((0..seen.curve_count())
            .map(|number| {
                let found = seen.curve(number);
                let mut curve =
                    BoundaryCurve::new((0..found.piece_count()).map(|i| found.piece(i)[0]).collect());
                curve.set_name(path.name.clone());
                curve.set_line(path.line);
                if order > Order::LINEAR {
                    curve.set_kinks(seen.kinks().on_curve(number as u32).collect());
                    curve.set_curve(found.translated([0.0, 0.0]));
                }
                curve
            })
            .collect())
    }

    /// A clip as a set; those that it is made of are made before it.
    fn set(&mut self, clip: usize, order: Order) -> Result<&YinSet, Error> {
        for own in self.clips.below(clip) {
            if self.sets.contains_key(&own) {
                continue;
            }
            let of = |parts: &[usize]| parts.iter().map(|part| &self.sets[part]).collect::<Vec<&YinSet>>();
            let set = match self.clips.clip(own) {
                Clip::Region(region) => {
                    let curves = region.subpaths.iter().filter(|subpath| subpath.corners.len() > 1);
                    let curves: Vec<BoundaryCurve> =
                        curves.map(|subpath| closed_curve(subpath, order)).collect::<Result<_, _>>()?;
                    set_of(&curves, region.rule, order)?
                }
                Clip::All(parts) if parts.is_empty() => YinSet::plane(order),
                Clip::Any(parts) if parts.is_empty() => YinSet::empty(order),
                Clip::All(parts) => YinSet::meet_all(&of(parts))?,
                Clip::Any(parts) => YinSet::join_all(&of(parts))?,
                Clip::Without([first, second]) => self.sets[first].difference(&self.sets[second])?,
            };
            self.sets.insert(own, set);
        }
        Ok(&self.sets[&clip])
    }
}

/// The set that closed curves wind around.
fn set_of(curves: &[BoundaryCurve], rule: InsideRule, order: Order) -> Result<YinSet, Error> {
    let curves: Vec<(Curve<'_>, Vec<u32>)> = curves
        .iter()
        .map(|curve| Ok((curve.curve(order, &EndCondition::NotAKnot)?, curve.kinks().to_vec())))
        .collect::<Result<_, Error>>()?;
    YinSet::combine_kinked_curves(&curves, 0, rule).map(coface_yin::Combination::into_set)
}
