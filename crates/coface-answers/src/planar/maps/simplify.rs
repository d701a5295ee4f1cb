//! A map with fewer vertices in which everything touches, contains and lies beside the same things.
//!
//! Borders that features share are simplified once. A vertex with two neighbors may go if nothing else is in the triangle of the three:
//! then the new side crosses nothing and nothing changes sides, so the map stays the same but for the shapes of its borders. All vertices that a
//! side stands for are within the tolerance of it. Vertices go in the order of how far they are from the side that would stand for them, the
//! nearest first.

use super::borders::Borders;
use super::layer::{Geometry, MapFeature, MapLayer, Point, Rings};
use super::repair::{faults_of, repaired};
use super::result::{Change, blank};
use super::task::RepairMethod;
use crate::answer::{MapAnswer, Place, Remark, RemarkCode, SimplificationAnswer};
use crate::text;
use coface_algebra::Error;
use coface_arrange::planar::PolygonFault;
use coface_geometry::predicates::orientation;
use coface_geometry::{AxisBox, BoxTree};
use rayon::prelude::*;
use std::borrow::Cow;
use std::cmp::{Ordering, Reverse};
use std::collections::{BinaryHeap, HashMap};

/// The simplified map.
pub(super) fn simplified(layer: &MapLayer, tolerance: f64) -> Result<Change, Error> {
    if !(tolerance.is_finite() && tolerance >= 0.0) {
        return Err(Error::invalid(format!("the tolerance is {tolerance}"))
            .with_cure("give a finite length from 0, in the unit of the map"));
    }
    let given = layer;
    let first = Borders::new(layer)?;
    let (added, vertices_before) = (first.added, first.places.len() - first.added);
    let mended = mended(layer, &first)?;
    let mut remarks = remarks_of_meetings(&first, mended.as_ref().map_or(0, |mended| mended.1));
    let (layer, borders) = match mended {
        Some((mended, _)) => {
            let borders = Borders::new(&mended)?;
            (Cow::Owned(mended), borders)
        }
        None => (Cow::Borrowed(layer), first),
    };
    let mut graph = Graph::new(&borders, tolerance);
    graph.simplify();
    let mut walks = borders.walks.iter().enumerate().map(|(number, walk)| {
        let mut kept: Vec<u32> =
            walk.iter().copied().filter(|&vertex| graph.is_there[vertex as usize]).collect();
        // A closed line stays closed when the vertex that it began at has gone.
        let is_closed_line = number >= borders.ring_count && walk.len() > 1 && walk.first() == walk.last();
        if is_closed_line && kept.first() != kept.last() {
            kept.extend(kept.first().copied());
        }
        kept.into_iter().map(|vertex| borders.point(vertex)).collect::<Vec<Point>>()
    });
    let mut geometries: Vec<Geometry> = (layer.features.iter())
        .map(|feature| Geometry {
            polygons: (feature.geometry.polygons.iter())
                .filter_map(|rings| polygon(walks.by_ref().take(rings.len()).collect()))
                .collect(),
            lines: Vec::new(),
            points: feature.geometry.points.clone(),
        })
        .collect();
    for (geometry, feature) in geometries.iter_mut().zip(&layer.features) {
        geometry.lines = walks.by_ref().take(feature.geometry.lines.len()).collect();
    }
    let used = |vertex: usize| !graph.neighbors[vertex].is_empty();
    let vertices = (0..borders.places.len()).filter(|&vertex| graph.is_there[vertex] && used(vertex)).count();
    let simplification = SimplificationAnswer {
        tolerance,
        largest_distance: graph.largest_distance(),
        vertices_before,
        vertices,
        vertices_added: added,
    };
    let again = made_valid(given, &mut geometries)?;
    if again > 0 {
        let message =
            format!("polygons of {} that lost their shape were made valid", text::count(again, "feature"));
        remarks.push(Remark::new(RemarkCode::DrawingAssumption, message).at(again, []));
    }
    remarks.extend(remark_of_faults(&geometries)?);
    Ok(Change {
        geometries: geometries.into_iter().enumerate().map(|(i, geometry)| (Some(i), geometry)).collect(),
        keeps_heights: true,
        answer: MapAnswer { simplification: Some(simplification), remarks, ..blank() },
    })
}

/// The polygons of a feature, which has this number.
type Numbered = (usize, Vec<Rings>);

/// The map with the polygons that are not valid where borders were cut, as where a side came to lie on another one, made valid, and the
/// number of features that have some; `None` where there are none. What was not valid before stays as it is.
fn mended(layer: &MapLayer, borders: &Borders) -> Result<Option<(MapLayer, usize)>, Error> {
    if !borders.is_cut {
        return Ok(None);
    }
    let mut walks = borders.walks.iter();
    let mut cut: Vec<Numbered> = Vec::new();
    for (number, feature) in layer.features.iter().enumerate() {
        let rings_of = |rings: &Rings| -> Rings {
            let own = walks.by_ref().take(rings.len());
            own.map(|walk| walk.iter().map(|&vertex| borders.point(vertex)).collect()).collect()
        };
        let polygons: Vec<Rings> =
            feature.geometry.polygons.iter().map(rings_of).filter_map(polygon).collect();
        cut.push((number, polygons));
    }
    let repaired = |(number, polygons): &Numbered| -> Result<Option<Numbered>, Error> {
        let given = &layer.features[*number].geometry.polygons;
        if faults_of(polygons)?.0.is_empty() || !faults_of(given)?.0.is_empty() {
            return Ok(None);
        }
        Ok(Some((*number, repaired(polygons, RepairMethod::Structure)?.polygons)))
    };
    let found: Vec<Result<Option<Numbered>, Error>> = cut.par_iter().map(repaired).collect();
    let found: Vec<Option<Numbered>> = found.into_iter().collect::<Result<_, _>>()?;
    let found: Vec<Numbered> = found.into_iter().flatten().collect();
    if found.is_empty() {
        return Ok(None);
    }
    let count = found.len();
    let mut mended = layer.clone();
    for (number, polygons) in found {
        mended.features[number].geometry.polygons = polygons;
    }
    Ok(Some((mended, count)))
}

/// Makes polygons valid that are not and were; how many features have some.
fn made_valid(given: &MapLayer, geometries: &mut [Geometry]) -> Result<usize, Error> {
    let valid = |(geometry, feature): (&mut Geometry, &MapFeature)| -> Result<bool, Error> {
        let was_valid = || Ok::<_, Error>(faults_of(&feature.geometry.polygons)?.0.is_empty());
        if faults_of(&geometry.polygons)?.0.is_empty() || !was_valid()? {
            return Ok(false);
        }
        geometry.polygons = repaired(&geometry.polygons, RepairMethod::Structure)?.polygons;
        Ok(true)
    };
    let made: Vec<Result<bool, Error>> =
        geometries.par_iter_mut().zip(given.features.par_iter()).map(valid).collect();
    let made = made.into_iter().collect::<Result<Vec<bool>, Error>>()?;
    Ok(made.into_iter().filter(|&was_made| was_made).count())
}

fn remarks_of_meetings(borders: &Borders, mended: usize) -> Vec<Remark> {
    if borders.added == 0 && mended == 0 {
        return Vec::new();
    }
    let mut message =
        format!("borders met without a vertex: {} put in first", text::count(borders.added, "vertex"));
    if mended > 0 {
        message +=
            &format!("; sides of {} came to lie on each other and went", text::count(mended, "feature"));
    }
    vec![Remark::new(RemarkCode::DrawingAssumption, message).at(borders.added.max(mended), [])]
}

/// That polygons of the simplified map are not valid, since those of the map are not.
fn remark_of_faults(geometries: &[Geometry]) -> Result<Option<Remark>, Error> {
    let faults = |geometry: &Geometry| faults_of(&geometry.polygons).map(|found| found.0);
    let found: Vec<Result<Vec<PolygonFault>, Error>> = geometries.par_iter().map(faults).collect();
    let found: Vec<Vec<PolygonFault>> = found.into_iter().collect::<Result<_, _>>()?;
    let count = found.iter().filter(|faults| !faults.is_empty()).count();
    let Some(first) = found.iter().flatten().next() else { return Ok(None) };
    let places = found.iter().flatten().map(|fault| Place::point(&fault.point));
    let [x, y] = first.point;
    let message = match count {
        1 => {
            format!("the polygons of 1 feature are not valid, as before, at ({x}, {y}); repair the map first")
        }
        _ => format!(
            "the polygons of {count} features are not valid, as before, the first at ({x}, {y}); repair the map first"
        ),
    };
    Ok(Some(Remark::new(RemarkCode::InvalidPolygon, message).at(count, places)))
}

/// A polygon without the rings that noding left fewer than three corners of; none if that is the outer one.
fn polygon(rings: Vec<Vec<Point>>) -> Option<Vec<Vec<Point>>> {
    let is_there = rings.first().is_some_and(|outer| outer.len() > 2);
    is_there.then(|| rings.into_iter().filter(|ring| ring.len() > 2).collect())
}

/// The graph of all borders while it is simplified.
struct Graph<'a> {
    places: &'a [[f64; 2]],
    /// The vertices that each has a side with.
    neighbors: Vec<Vec<u32>>,
    /// Whether lines end at a vertex: it stays.
    is_end: Vec<bool>,
    is_there: Vec<bool>,
    /// The vertices that a side stands for, by its ends, the lower first.
    hidden: HashMap<[u32; 2], Vec<u32>>,
    /// Boxes around the vertices and the points of their own, and the places of the latter.
    tree: BoxTree,
    points: &'a [[f64; 2]],
    tolerance: f64,
}

impl<'a> Graph<'a> {
    fn new(borders: &'a Borders, tolerance: f64) -> Self {
        let mut neighbors: Vec<Vec<u32>> = vec![Vec::new(); borders.places.len()];
        for [a, b] in borders.sides() {
            neighbors[a as usize].push(b);
            neighbors[b as usize].push(a);
        }
        for own in &mut neighbors {
            own.sort_unstable();
            own.dedup();
        }
        let places = || borders.places.iter().chain(&borders.points);
        let boxes: Vec<AxisBox> = places().map(|&place| box_around(&[place])).collect();
        Self {
            places: &borders.places,
            neighbors,
            is_end: borders.line_ends(),
            is_there: vec![true; borders.places.len()],
            hidden: HashMap::new(),
            tree: BoxTree::new(&boxes),
            points: &borders.points,
            tolerance,
        }
    }

    /// The two neighbors of a vertex that may go.
    fn ends_around(&self, vertex: u32) -> Option<[u32; 2]> {
        match self.neighbors[vertex as usize][..] {
            [u, w] if self.is_there[vertex as usize] && !self.is_end[vertex as usize] => Some([u, w]),
            _ => None,
        }
    }

    /// How far what the side between the neighbors of a vertex would stand for is from it; `None` if that is too far.
    fn distance(&self, vertex: u32, [u, w]: [u32; 2]) -> Option<f64> {
        let hidden = |a: u32, b: u32| self.hidden.get(&[a.min(b), a.max(b)]).into_iter().flatten();
        let [from, to] = [u, w].map(|end| self.places[end as usize]);
        let mut largest: f64 = 0.0;
        for &own in std::iter::once(&vertex).chain(hidden(u, vertex)).chain(hidden(vertex, w)) {
            let place = self.places[own as usize];
            if self.tolerance == 0.0 && orientation(from, place, to).is_ne() {
                return None;
            }
            largest = largest.max(distance_to_segment(place, from, to));
            if largest > self.tolerance {
                return None;
            }
        }
        Some(largest)
    }

    /// A vertex or point in the closed triangle, which is none of its corners.
    fn occupant(&self, corners: [u32; 3]) -> Option<u32> {
        let triangle = corners.map(|corner| self.places[corner as usize]);
        let mut found: Option<u32> = None;
        self.tree.visit(&box_around(&triangle), |other| {
            let place = match (other as usize).checked_sub(self.places.len()) {
                Some(point) => self.points[point],
                None if !self.is_there[other as usize] || corners.contains(&other) => return,
                None => self.places[other as usize],
            };
            if found.is_none_or(|known| other < known) && is_in(triangle, place) {
                found = Some(other);
            }
        });
        found
    }

    fn simplify(&mut self) {
        let mut queue: BinaryHeap<Reverse<(u64, u32, [u32; 2])>> = BinaryHeap::new();
        // What waits until a vertex has gone.
        let mut waiting: HashMap<u32, Vec<u32>> = HashMap::new();
        let enter = |graph: &Self, queue: &mut BinaryHeap<_>, vertex: u32| {
            if let Some(ends) = graph.ends_around(vertex)
                && let Some(distance) = graph.distance(vertex, ends)
            {
                queue.push(Reverse((distance.to_bits(), vertex, ends)));
            }
        };
        (0..self.places.len() as u32).for_each(|vertex| enter(self, &mut queue, vertex));
        while let Some(Reverse((_, vertex, ends))) = queue.pop() {
            let [u, w] = ends;
            // Neighbors may have gone since.
            if self.ends_around(vertex) != Some(ends) || self.neighbors[u as usize].contains(&w) {
                continue;
            }
            if let Some(other) = self.occupant([u, vertex, w]) {
                waiting.entry(other).or_default().push(vertex);
                continue;
            }
            self.remove(vertex, ends);
            let freed = waiting.remove(&vertex).unwrap_or_default();
            for next in ends.into_iter().chain(freed) {
                enter(self, &mut queue, next);
            }
        }
    }

    fn remove(&mut self, vertex: u32, [u, w]: [u32; 2]) {
        self.is_there[vertex as usize] = false;
        self.neighbors[vertex as usize].clear();
        for (end, other) in [(u, w), (w, u)] {
            let own = &mut self.neighbors[end as usize];
            own.retain(|&neighbor| neighbor != vertex);
            if let Err(place) = own.binary_search(&other) {
                own.insert(place, other);
            }
        }
        let key = |a: u32, b: u32| [a.min(b), a.max(b)];
        let mut first = self.hidden.remove(&key(u, vertex)).unwrap_or_default();
        let mut second = self.hidden.remove(&key(vertex, w)).unwrap_or_default();
        if first.len() < second.len() {
            std::mem::swap(&mut first, &mut second);
        }
        first.append(&mut second);
        first.push(vertex);
        self.hidden.insert(key(u, w), first);
    }

    fn largest_distance(&self) -> f64 {
        let of_side = |(ends, own): (&[u32; 2], &Vec<u32>)| {
            let [from, to] = ends.map(|end| self.places[end as usize]);
            own.iter().fold(0.0, |largest: f64, &vertex| {
                largest.max(distance_to_segment(self.places[vertex as usize], from, to))
            })
        };
        self.hidden.iter().map(of_side).fold(0.0, f64::max)
    }
}

fn box_around(places: &[[f64; 2]]) -> AxisBox {
    let mut found = [[f64::INFINITY, f64::NEG_INFINITY], [f64::INFINITY, f64::NEG_INFINITY], [0.0; 2]];
    for place in places {
        for (axis, [low, high]) in found[..2].iter_mut().enumerate() {
            *low = low.min(place[axis]);
            *high = high.max(place[axis]);
        }
    }
    found
}

/// Whether a point is in a closed triangle, which may be a segment.
fn is_in([a, b, c]: [[f64; 2]; 3], place: [f64; 2]) -> bool {
    let turns = [orientation(a, b, place), orientation(b, c, place), orientation(c, a, place)];
    let has = |turn: Ordering| turns.contains(&turn);
    if has(Ordering::Less) && has(Ordering::Greater) {
        return false;
    }
    if has(Ordering::Less) || has(Ordering::Greater) {
        return true;
    }
    // All on one line.
    let [low, high] = [f64::min, f64::max].map(|of| [0, 1].map(|axis| of(of(a[axis], b[axis]), c[axis])));
    (0..2).all(|axis| low[axis] <= place[axis] && place[axis] <= high[axis])
}

fn distance_to_segment(place: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let (way, own) = ([to[0] - from[0], to[1] - from[1]], [place[0] - from[0], place[1] - from[1]]);
    let square = way[0] * way[0] + way[1] * way[1];
    let part = if square > 0.0 { (way[0] * own[0] + way[1] * own[1]) / square } else { 0.0 };
    let part = part.clamp(0.0, 1.0);
    (own[0] - part * way[0]).hypot(own[1] - part * way[1])
}
