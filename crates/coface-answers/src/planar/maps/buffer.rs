//! What is at most so far from a map, with arcs as straight lines.
//!
//! A buffer is the union of the polygon, of a strip along each side, and of a wedge at each corner where strips are apart; a negative
//! one is the polygon without the strips and wedges inside of it. Strips and wedges share their corners bit by bit, and the union is exact, so
//! nothing is lost between them, however the sides of the buffer cross each other.

use super::super::boolean::{BooleanRequest, RegionBoolean};
use super::super::drawing::Filling;
use super::layer::{Corners, Geometry, MapLayer, Point, Rings, drawing_of};
use super::repair::{polygons_of, union_of};
use super::result::{Change, repaired_map};
use super::task::{BufferCaps, BufferJoins, BufferOptions, RepairMethod};
use crate::answer::{BufferArcsAnswer, MapAnswer};
use coface_algebra::Error;
use coface_arrange::boolean::BooleanFormula;
use coface_geometry::predicates::orientation;
use rayon::prelude::*;
use std::cmp::Ordering;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The most sides of a circle.
const MOST_SIDES: f64 = 1_000_000.0;

/// The buffer of each feature.
pub(super) fn buffered(layer: &MapLayer, options: &BufferOptions) -> Result<Change, Error> {
    let strips = Strips::new(options)?;
    let (polygons, repair) = repaired_map(layer, RepairMethod::Structure, false)?;
    let geometries: Vec<Result<Geometry, Error>> = (layer.features.par_iter())
        .zip(&polygons)
        .map(|(feature, polygons)| {
            let polygons = strips.around(polygons, &feature.geometry)?;
            Ok(Geometry { polygons, ..Geometry::default() })
        })
        .collect();
    let geometries = geometries.into_iter().collect::<Result<Vec<Geometry>, Error>>()?;
    let arcs = BufferArcsAnswer {
        distance: options.distance(),
        error: options.arc_error(),
        sides: (TAU / strips.step).ceil() as usize,
    };
    Ok(Change {
        geometries: geometries.into_iter().enumerate().map(|(i, geometry)| (Some(i), geometry)).collect(),
        keeps_heights: false,
        answer: MapAnswer { arcs: Some(arcs), ..repair.answer },
    })
}

/// How strips and wedges are made.
struct Strips {
    distance: f64,
    /// The greatest angle of one side of an arc.
    step: f64,
    joins: BufferJoins,
    caps: BufferCaps,
}

/// A side of a walk with the way from it to the border of the strip on its right.
#[derive(Clone, Copy)]
struct Side {
    from: [f64; 2],
    to: [f64; 2],
    /// The unit vector along it, times the distance.
    along: [f64; 2],
}

impl Side {
    fn normal(&self) -> [f64; 2] {
        [self.along[1], -self.along[0]]
    }
}

impl Strips {
    fn new(options: &BufferOptions) -> Result<Self, Error> {
        let &BufferOptions { distance, joins, caps, .. } = options;
        let error = options.arc_error();
        if !distance.is_finite() {
            return Err(Error::invalid(format!("the distance of the buffer is {distance}"))
                .with_cure("give a finite number, below 0 for what is inside"));
        }
        if !(error.is_finite() && error > 0.0) && distance != 0.0 {
            return Err(Error::invalid(format!("arcs cannot be flattened to within {error}"))
                .with_cure("give a length above 0"));
        }
        if let BufferJoins::Mitre(limit) = joins
            && !(limit.is_finite() && limit >= 1.0)
        {
            return Err(Error::invalid(format!("the limit of mitres is {limit}"))
                .with_cure("give a number from 1: how many times the distance a corner may be away"));
        }
        let radius = distance.abs();
        // The arrow of an arc with half the angle h is r (1 - cos h) = 2 r sin^2 (h / 2).
        let part = if radius > 0.0 { (error * (1.0 - 1e-9) / (2.0 * radius)).min(0.5) } else { 0.5 };
        let step = (4.0 * part.sqrt().asin()).min(FRAC_PI_2);
        if TAU / step > MOST_SIDES {
            let least = 2.0 * radius * (TAU / MOST_SIDES / 4.0).sin().powi(2);
            return Err(Error::invalid(format!(
                "arcs of radius {radius} within {error} have more than a million sides a circle"
            ))
            .with_cure(format!("allow an error of {least:.1e}")));
        }
        Ok(Self { distance, step, joins, caps })
    }

    /// The buffer of valid polygons, and of the lines and points of a geometry.
    fn around(&self, polygons: &[Rings], geometry: &Geometry) -> Result<Vec<Rings>, Error> {
        let mut pieces: Vec<Rings> = Vec::new();
        if self.distance < 0.0 {
            for ring in polygons.iter().flatten() {
                let reversed: Corners = ring.iter().rev().copied().collect();
                self.walk(&reversed, true, &mut pieces);
            }
            if polygons.is_empty() {
                return Ok(Vec::new());
            }
            let regions = [(polygons, Filling::OuterWithoutHoles), (&pieces[..], Filling::OuterWithoutHoles)];
            let formula = BooleanFormula::difference(2);
            let rest = RegionBoolean::new(drawing_of(regions)?, &formula, &BooleanRequest::default())?;
            return polygons_of(&rest);
        }
        if self.distance == 0.0 {
            return Ok(polygons.to_vec());
        }
        pieces.extend(polygons.iter().cloned());
        for ring in polygons.iter().flatten() {
            self.walk(ring, true, &mut pieces);
        }
        for line in &geometry.lines {
            let is_closed = line.len() > 3 && line.first().map(xy) == line.last().map(xy);
            let line = if is_closed { &line[1..] } else { &line[..] };
            let reversed: Corners = line.iter().rev().copied().collect();
            self.walk(line, is_closed, &mut pieces);
            self.walk(&reversed, is_closed, &mut pieces);
        }
        for point in &geometry.points {
            match self.caps {
                BufferCaps::Flat => {}
                BufferCaps::Round => {
                    let [x, y] = xy(point);
                    let sides = (TAU / self.step / 4.0).ceil() as usize * 4;
                    let corner = |i: usize| {
                        let [c, s] = self.on_circle(TAU * i as f64 / sides as f64);
                        at([x + c, y + s])
                    };
                    pieces.push(vec![(0..sides).map(corner).collect()]);
                }
                BufferCaps::Square => {
                    let ([x, y], r) = (xy(point), self.distance);
                    let corners = [[x - r, y - r], [x + r, y - r], [x + r, y + r], [x - r, y + r]];
                    pieces.push(vec![corners.map(at).to_vec()]);
                }
            }
        }
        if pieces.is_empty() {
            return Ok(Vec::new());
        }
        polygons_of(&union_of(&pieces, Filling::OuterWithoutHoles)?)
    }

    fn on_circle(&self, angle: f64) -> [f64; 2] {
        let radius = self.distance.abs();
        // Quarters are exact.
        let quarters = angle / FRAC_PI_2;
        match (quarters.fract() == 0.0, (quarters as i64).rem_euclid(4)) {
            (true, 0) => [radius, 0.0],
            (true, 1) => [0.0, radius],
            (true, 2) => [-radius, 0.0],
            (true, _) => [0.0, -radius],
            _ => [radius * angle.cos(), radius * angle.sin()],
        }
    }

    /// Adds the strips on the right of a walk, its joins on that side, and the cap at its end if it is open.
    fn walk(&self, corners: &[Point], is_closed: bool, pieces: &mut Vec<Rings>) {
        let mut places: Vec<[f64; 2]> = corners.iter().map(xy).collect();
        places.dedup();
        if is_closed && places.len() > 1 && places.first() == places.last() {
            places.pop();
        }
        let radius = self.distance.abs();
        let ends = places.iter().zip(places.iter().cycle().skip(1));
        let count = if is_closed { places.len() } else { places.len().saturating_sub(1) };
        let sides: Vec<Side> = ends
            .take(count)
            .map(|(&from, &to)| {
                let way = [to[0] - from[0], to[1] - from[1]];
                let length = way[0].hypot(way[1]);
                let along = way.map(|part| {
                    // Sides along the axes have exact strips.
                    if part.abs() == length { radius.copysign(part) } else { part / length * radius }
                });
                Side { from, to, along }
            })
            .filter(|side| side.from != side.to)
            .collect();
        let count = sides.len();
        if count == 0 {
            return;
        }
        // The outer corners at the start and the end of each strip.
        let mut outer: Vec<[[f64; 2]; 2]> =
            sides.iter().map(|side| [side.from, side.to].map(|end| plus(end, side.normal()))).collect();
        let mut inner: Vec<[[f64; 2]; 2]> = sides.iter().map(|side| [side.from, side.to]).collect();
        for first in 0..count {
            let second = if first + 1 < count { first + 1 } else { 0 };
            if second == 0 && !is_closed {
                break;
            }
            if let Some(mitre) = self.join(&sides[first], &sides[second], pieces) {
                outer[first][1] = mitre;
                outer[second][0] = mitre;
            }
        }
        if !is_closed {
            let last = sides[count - 1];
            match self.caps {
                BufferCaps::Flat => {}
                BufferCaps::Square => {
                    for (side, end, way) in [(0, 0, minus(sides[0].along)), (count - 1, 1, last.along)] {
                        outer[side][end] = plus(outer[side][end], way);
                        inner[side][end] = plus(inner[side][end], way);
                    }
                }
                BufferCaps::Round => self.wedge(last.to, last.normal(), minus(last.normal()), PI, pieces),
            }
        }
        pieces.extend(outer.iter().zip(&inner).map(|(&[a, b], &[from, to])| {
            // A corner of the walk stays one of its strip where that goes beyond it.
            vec![[from, a, b, to].map(at).to_vec()]
        }));
    }

    /// Adds what is between the strips of two sides on their right; or gives the corner to which both are extended.
    fn join(&self, first: &Side, second: &Side, pieces: &mut Vec<Rings>) -> Option<[f64; 2]> {
        let (n, m) = (first.normal(), second.normal());
        let square = self.distance * self.distance;
        let (cross, dot) = (n[0] * m[1] - n[1] * m[0], n[0] * m[0] + n[1] * m[1]);
        let corner = first.to;
        let turn = orientation(first.from, corner, second.to);
        if dot > 0.0 && cross.abs() < 1e-12 * square {
            // Almost straight on: what rounding leaves between both.
            if n != m {
                pieces.push(vec![[corner, plus(corner, n), plus(corner, m)].map(at).to_vec()]);
            }
            return None;
        }
        let turns_back = turn == Ordering::Equal && dot < 0.0;
        if turn != Ordering::Greater && !turns_back {
            return None;
        }
        let angle = if turns_back { PI } else { cross.atan2(dot).abs() };
        match self.joins {
            BufferJoins::Round => self.wedge(corner, n, m, angle, pieces),
            // Away from the corner by the distance over the cosine of half the angle.
            BufferJoins::Mitre(limit) if !turns_back && 2.0 * square <= limit * limit * (square + dot) => {
                let part = square / (square + dot);
                return Some([0, 1].map(|axis| corner[axis] + (n[axis] + m[axis]) * part));
            }
            _ if turns_back => {}
            // Cut off across the line between both sides, at the limit.
            BufferJoins::Mitre(limit) => {
                let [cosine, sine] = [square + dot, square - dot].map(|part| (part / (2.0 * square)).sqrt());
                let part = (limit - cosine) / sine;
                let ends = [(n, first.along), (m, minus(second.along))]
                    .map(|(normal, along)| plus(plus(corner, normal), along.map(|x| x * part)));
                pieces.push(vec![
                    [corner, plus(corner, n), ends[0], ends[1], plus(corner, m)].map(at).to_vec(),
                ]);
            }
            _ => pieces.push(vec![[corner, plus(corner, n), plus(corner, m)].map(at).to_vec()]),
        }
        None
    }

    /// Adds the wedge at a corner from one direction counterclockwise to another, by an angle.
    fn wedge(&self, corner: [f64; 2], from: [f64; 2], to: [f64; 2], angle: f64, pieces: &mut Vec<Rings>) {
        let count = ((angle / self.step).ceil() as usize).max(1);
        let start = from[1].atan2(from[0]);
        let mut ring = vec![at(corner), at(plus(corner, from))];
        for i in 1..count {
            ring.push(at(plus(corner, self.on_circle(start + angle * i as f64 / count as f64))));
        }
        ring.push(at(plus(corner, to)));
        pieces.push(vec![ring]);
    }
}

fn xy(point: &Point) -> [f64; 2] {
    [point[0] + 0.0, point[1] + 0.0]
}

fn at(place: [f64; 2]) -> Point {
    [place[0], place[1], f64::NAN]
}

fn plus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

fn minus(a: [f64; 2]) -> [f64; 2] {
    a.map(|x| -x)
}
