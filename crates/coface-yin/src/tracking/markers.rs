//! Markers of one curve, mapped and with their distances kept in range.

use super::MarkerParameters;
use crate::curve::{bernstein, distance};
use crate::{Curve, Order};
use coface_algebra::Error;

/// What tracking did to markers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct TrackingCounts {
    pub(crate) steps: usize,
    pub(crate) added: usize,
    pub(crate) removed: usize,
}

impl TrackingCounts {
    /// The number of steps of time.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// The markers that were added.
    pub fn added(&self) -> usize {
        self.added
    }

    /// The markers that were left out.
    pub fn removed(&self) -> usize {
        self.removed
    }
}

/// Distances of neighboring markers.
#[derive(Clone, Copy, Debug)]
pub(super) struct MarkerRange {
    pub(super) least: f64,
    pub(super) most: f64,
    /// The most that the polygon of the markers turns at a marker where there is room for more, in radians.
    pub(super) turn: f64,
    /// Whether curves that are short beside these distances have markers nearer together, so that they do not vanish.
    pub(super) keeps_small: bool,
    /// What the parameters of splines through the markers are; none for the usual ones.
    pub(super) parameters: Option<MarkerParameters>,
}

impl MarkerRange {
    /// Whether markers keep their parameters. Those of a polyline are lengths, and so are those of a cubic spline unless it is asked for:
    /// that is the method of the references.
    fn keeps_parameters(self, order: Order) -> bool {
        match self.parameters {
            _ if order == Order::LINEAR => false,
            Some(parameters) => parameters == MarkerParameters::Kept,
            None => order > Order::CUBIC,
        }
    }

    /// The distances of markers of a closed curve.
    pub(super) fn for_curve(self, curve: &Curve<'_>) -> Self {
        /// Curves that are kept have so many markers at least.
        const FEWEST: f64 = 16.0;
        if !self.keeps_small {
            return self;
        }
        let knots: Vec<[f64; 2]> = (0..=curve.piece_count()).map(|knot| curve.knot_point(knot)).collect();
        let most = polyline_length(&knots) / FEWEST;
        if most >= self.most {
            return self;
        }
        Self { least: self.least.min(most / 3.0), most, ..self }
    }
}

/// The markers of a curve after a step.
pub(super) struct MovedMarkers {
    /// From the first knot to the last.
    pub(super) points: Vec<[f64; 2]>,
    /// The knot of the old curve that each one was, if it was one.
    pub(super) origins: Vec<Option<u32>>,
    /// What each one was at on the old curve; nothing where splines through the markers had better have other parameters.
    pub(super) parameters: Option<Vec<f64>>,
}

/// So often gaps are filled again before the map is given up.
const ROUNDS: usize = 12;

/// Maps the knots of a curve, adds points of the curve where the images are too far apart, and leaves out those that are too close to
/// the one before. Knots that are `fixed` stay, and the first and the last one.
pub(super) fn moved_markers(
    curve: &Curve<'_>,
    fixed: impl Fn(usize) -> bool,
    map: &impl Fn(&[[f64; 2]]) -> Vec<[f64; 2]>,
    range: MarkerRange,
    counts: &mut TrackingCounts,
) -> Result<MovedMarkers, Error> {
    let point = |&(piece, s): &(u32, f64)| match s {
        0.0 => curve.knot_point(piece as usize),
        s => bernstein::value(curve.piece(piece as usize), s),
    };
    let images =
        |places: &[(u32, f64)]| -> Vec<[f64; 2]> { map(&places.iter().map(point).collect::<Vec<_>>()) };
    let mut places: Vec<(u32, f64)> = (0..=curve.piece_count() as u32).map(|knot| (knot, 0.0)).collect();
    let mut points = images(&places);
    if curve.is_closed() {
        points[curve.piece_count()] = points[0];
    }
    for round in 0.. {
        if let Some(at) = points.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
            let [x, y] = curve.knot_point(places[at].0 as usize);
            return Err(Error::invalid(format!("the velocity near ({x}, {y}) leads to no finite point"))
                .with_cure("give a velocity that is finite where the boundary comes, or shorter steps"));
        }
        let is_wide = |at: usize| distance(points[at - 1], points[at]) > range.most;
        let is_bent = bent_gaps(&points, range, |at| match places[at] {
            (knot, 0.0) => fixed(knot as usize),
            _ => false,
        });
        let gaps: Vec<usize> = (1..points.len()).filter(|&at| is_wide(at) || is_bent[at]).collect();
        if gaps.is_empty() {
            break;
        }
        if round == ROUNDS {
            if !gaps.iter().any(|&at| is_wide(at)) {
                break;
            }
            let [x, y] = points[gaps[0]];
            return Err(Error::invalid(format!(
                "markers near ({x}, {y}) move apart faster than they can be added"
            ))
            .with_cure("give a continuous velocity, shorter steps or a larger spacing"));
        }
        let mut added: Vec<(u32, f64)> = Vec::new();
        let mut starts = Vec::with_capacity(gaps.len());
        for &at in &gaps {
            starts.push(added.len());
            let (piece, low) = places[at - 1];
            let high = if places[at].0 == piece { places[at].1 } else { 1.0 };
            // A little more than needed, for parts are not of equal length.
            let parts = (1.1 * distance(points[at - 1], points[at]) / range.most).ceil().clamp(2.0, 64.0);
            added.extend((1..parts as u32).map(|i| (piece, low + (high - low) * f64::from(i) / parts)));
        }
        starts.push(added.len());
        counts.added += added.len();
        let added_points = images(&added);
        let mut merged = (Vec::with_capacity(places.len() + added.len()), Vec::new());
        let mut from = 0;
        for (gap, &at) in gaps.iter().enumerate() {
            merged.0.extend_from_slice(&places[from..at]);
            merged.1.extend_from_slice(&points[from..at]);
            merged.0.extend_from_slice(&added[starts[gap]..starts[gap + 1]]);
            merged.1.extend_from_slice(&added_points[starts[gap]..starts[gap + 1]]);
            from = at;
        }
        merged.0.extend_from_slice(&places[from..]);
        merged.1.extend_from_slice(&points[from..]);
        (places, points) = merged;
    }
    let knot = |&(piece, s): &(u32, f64)| (s == 0.0).then_some(piece);
    let stays = |at: usize| {
        at == 0 || at + 1 == places.len() || knot(&places[at]).is_some_and(|knot| fixed(knot as usize))
    };
    let mut kept: Vec<usize> = Vec::with_capacity(places.len());
    for at in 0..places.len() {
        if !stays(at) {
            let last = points[kept[kept.len() - 1]];
            let is_close = distance(last, points[at]) < range.least;
            if is_close && distance(last, points[at + 1]) <= range.most {
                counts.removed += 1;
                continue;
            }
        } else {
            // What was kept just before makes way, if that leaves no gap.
            while let [.., before, last] = kept[..] {
                let is_close = distance(points[last], points[at]) < range.least;
                if stays(last) || !is_close || distance(points[before], points[at]) > range.most {
                    break;
                }
                kept.pop();
                counts.removed += 1;
            }
        }
        kept.push(at);
    }
    Ok(MovedMarkers {
        points: kept.iter().map(|&at| points[at]).collect(),
        origins: kept.iter().map(|&at| knot(&places[at])).collect(),
        parameters: range
            .keeps_parameters(curve.order())
            .then(|| kept_parameters(curve, kept.iter().map(|&at| places[at]), fixed))
            .flatten(),
    })
}

/// The parameters of places on a curve, which their images keep: the images of the points of a smooth curve are a smooth function of its
/// parameter, and splines of it are within the power of their order whatever the flow does to the distances of markers. Their own length
/// is less smooth a parameter by far where the flow folds the curve, and it is known as exactly as the fit is only.
///
/// None where the curve turns to another speed at a knot that is not fixed, as polylines do, and curves that were pasted.
fn kept_parameters(
    curve: &Curve<'_>,
    places: impl Iterator<Item = (u32, f64)>,
    fixed: impl Fn(usize) -> bool,
) -> Option<Vec<f64>> {
    if !curve.has_smooth_parameter(fixed) {
        return None;
    }
    let knots = curve.knots();
    let parameters: Vec<f64> = places
        .map(|(piece, s)| match s {
            0.0 => knots[piece as usize],
            s => knots[piece as usize] + s * (knots[piece as usize + 1] - knots[piece as usize]),
        })
        .collect();
    // Some are equal where there is no number between.
    parameters.windows(2).all(|pair| pair[0] < pair[1]).then_some(parameters)
}

/// For each point whether there is to be another one before it, because the polyline turns much at one end of the gap, and there is room.
fn bent_gaps(points: &[[f64; 2]], range: MarkerRange, is_kink: impl Fn(usize) -> bool) -> Vec<bool> {
    let mut is_bent = vec![false; points.len()];
    if range.turn >= std::f64::consts::PI {
        return is_bent;
    }
    // Both parts are longer than the least distance then, unless the flow is very uneven.
    let has_room = |at: usize| distance(points[at - 1], points[at]) > 2.5 * range.least;
    for at in 1..points.len() - 1 {
        let [a, b, c] = [points[at - 1], points[at], points[at + 1]];
        let ([px, py], [qx, qy]) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
        let turn = (px * qy - py * qx).atan2(px * qx + py * qy).abs();
        if turn > range.turn && !is_kink(at) {
            is_bent[at] |= has_room(at);
            is_bent[at + 1] |= has_room(at + 1);
        }
    }
    is_bent
}

/// The length of the polyline through points.
pub(super) fn polyline_length(points: &[[f64; 2]]) -> f64 {
    points.windows(2).map(|pair| distance(pair[0], pair[1])).sum()
}
