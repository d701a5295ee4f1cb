//! What of a map is in a box.

use super::super::boolean::{BooleanRequest, RegionBoolean};
use super::super::drawing::Filling;
use super::layer::{Geometry, MapLayer, Point, Rings, drawing_of};
use super::repair::polygons_of;
use super::result::{Change, repaired_map};
use super::task::RepairMethod;
use crate::answer::{Remark, RemarkCode};
use crate::text;
use coface_algebra::Error;
use coface_arrange::boolean::BooleanFormula;
use coface_geometry::predicates::PlanarPoint;
use rayon::prelude::*;

/// What of each feature is in a closed box. Features outside of it go.
pub(super) fn clipped(layer: &MapLayer, frame: [f64; 4]) -> Result<Change, Error> {
    let [left, low, right, high] = frame;
    if !(frame.iter().all(|x| x.is_finite()) && left < right && low < high) {
        return Err(Error::invalid(format!("{left},{low},{right},{high} is no box"))
            .with_cure("give least x, least y, greatest x, greatest y"));
    }
    let frame = [[left, low], [right, high]];
    let (polygons, repair) = repaired_map(layer, RepairMethod::Structure, false)?;
    let geometries: Vec<Result<Geometry, Error>> = (layer.features.par_iter())
        .zip(&polygons)
        .map(|(feature, polygons)| within(feature.geometry.clone(), polygons, frame))
        .collect();
    let geometries = geometries.into_iter().collect::<Result<Vec<Geometry>, Error>>()?;
    let is_empty = |geometry: &Geometry| geometry.corners().next().is_none();
    let lost = (geometries.iter().zip(&layer.features))
        .filter(|(after, before)| is_empty(after) && !is_empty(&before.geometry))
        .count();
    let mut answer = repair.answer;
    if lost > 0 {
        let message = format!("{} outside of the box left out", text::count(lost, "feature"));
        answer.remarks.push(Remark::new(RemarkCode::CellsLeftOut, message).at(lost, []));
    }
    let kept = geometries.into_iter().enumerate().filter(|(_, geometry)| !is_empty(geometry));
    Ok(Change {
        geometries: kept.map(|(feature, geometry)| (Some(feature), geometry)).collect(),
        keeps_heights: true,
        answer,
    })
}

/// What of a geometry with these valid polygons is in a box.
fn within(mut geometry: Geometry, polygons: &[Rings], frame: [[f64; 2]; 2]) -> Result<Geometry, Error> {
    geometry.polygons = polygons.to_vec();
    let own = geometry.frame();
    if (0..2).all(|axis| frame[0][axis] <= own[0][axis] && own[1][axis] <= frame[1][axis]) {
        return Ok(geometry);
    }
    if (0..2).any(|axis| own[1][axis] < frame[0][axis] || frame[1][axis] < own[0][axis]) {
        return Ok(Geometry::default());
    }
    let [[left, low], [right, high]] = frame;
    if !polygons.is_empty() {
        let corners = [[left, low], [right, low], [right, high], [left, high]];
        let window = [vec![corners.map(|[x, y]| [x, y, f64::NAN]).to_vec()]];
        let regions = [(polygons, Filling::OuterWithoutHoles), (&window[..], Filling::OuterWithoutHoles)];
        let formula = BooleanFormula::intersection(2);
        let inside = RegionBoolean::new(drawing_of(regions)?, &formula, &BooleanRequest::default())?;
        geometry.polygons = polygons_of(&inside)?;
    }
    geometry.lines = geometry.lines.iter().flat_map(|line| pieces_within(line, frame)).collect();
    geometry.points.retain(|point| is_within(point, frame));
    Ok(geometry)
}

fn is_within(point: &Point, frame: [[f64; 2]; 2]) -> bool {
    (0..2).all(|axis| frame[0][axis] <= point[axis] && point[axis] <= frame[1][axis])
}

/// The pieces of a line in a box. Where it only touches the box in a point there is none.
fn pieces_within(line: &[Point], frame: [[f64; 2]; 2]) -> Vec<Vec<Point>> {
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut goes_on = false;
    for side in line.windows(2) {
        let [a, b] = [side[0], side[1]];
        let found = segment_within(a, b, frame);
        match found {
            Some([from, to]) => {
                match pieces.last_mut().filter(|_| goes_on) {
                    Some(piece) => piece.push(to),
                    None => pieces.push(vec![from, to]),
                }
                goes_on = is_within(&b, frame);
            }
            // Pieces end where the line leaves, or only touches the box.
            None => goes_on = goes_on && a == b,
        }
    }
    pieces
}

/// The part of a segment in a box, its ends rounded correctly; on a side of the box they are exactly so.
fn segment_within(a: Point, b: Point, frame: [[f64; 2]; 2]) -> Option<[Point; 2]> {
    let [from, to] = [[a[0], a[1]], [b[0], b[1]]];
    let mut found: Vec<Point> = Vec::new();
    found.extend(Some(a).filter(|end| is_within(end, frame)));
    let mut crossings: Vec<(f64, Point)> = Vec::new();
    for (axis, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let value = frame[end][axis];
        let is_between = (from[axis] < value && value < to[axis]) || (to[axis] < value && value < from[axis]);
        if !is_between {
            continue;
        }
        let mut line = frame;
        line[0][axis] = value;
        line[1][axis] = value;
        let Some(point) = PlanarPoint::crossing([from, to], line) else { continue };
        let ends = frame.map(|corner| point.compare_coordinate(&PlanarPoint::given(corner), 1 - axis));
        if ends[0].is_lt() || ends[1].is_gt() {
            continue;
        }
        let mut place = point.rounded();
        place[axis] = value;
        let part = along(from, to, place);
        let height = if part == 0.5 { (a[2] + b[2]) / 2.0 } else { a[2] * (1.0 - part) + b[2] * part };
        crossings.push((part, [place[0], place[1], height]));
    }
    crossings.sort_by(|p, q| p.0.total_cmp(&q.0));
    found.extend(crossings.into_iter().map(|(_, point)| point));
    found.extend(Some(b).filter(|end| is_within(end, frame)));
    let (first, last) = (*found.first()?, *found.last()?);
    ([first[0], first[1]] != [last[0], last[1]]).then_some([first, last])
}

/// How far along a segment a point on it is: 0 to 1.
fn along(from: [f64; 2], to: [f64; 2], place: [f64; 2]) -> f64 {
    let way = [0, 1].map(|axis| (to[axis] - from[axis]).abs());
    let axis = usize::from(way[1] > way[0]);
    ((place[axis] - from[axis]) / (to[axis] - from[axis])).clamp(0.0, 1.0)
}
