//! The vertices of cut sheets: corners and the places where sheets meet, equal points made one.

use super::meetings::Place;
use super::sheets::{Sheets, compare_places};
use coface_algebra::progress::stage;
use coface_geometry::predicates::SpatialPoint;
use rayon::prelude::*;
use std::borrow::Cow;

/// Corners of sheets first, by their own numbers, then new points by rising rounded coordinates.
#[derive(Clone, Debug)]
pub(super) struct Vertices {
    /// The number of corners.
    pub(super) given: usize,
    /// The points that are no corners.
    pub(super) points: Vec<SpatialPoint>,
    /// The first of the places at each of them.
    pub(super) places: Vec<Place>,
}

/// How many classes of equal points are split off one by one before the rest is sorted.
const SPLIT_OFF: usize = 8;

impl Vertices {
    /// The vertices, and that of each place. Places are rising, each with its point.
    pub(super) fn new(sheets: &Sheets, places: &[Place], points: &[SpatialPoint]) -> (Self, Vec<u32>) {
        let rounded = |place: u32| points[place as usize].rounded();
        let mut order: Vec<u32> = (0..places.len() as u32).collect();
        order.par_sort_unstable_by(|&a, &b| compare_places(&rounded(a), &rounded(b)).then(a.cmp(&b)));
        let given = sheets.points.len();
        let mut vertices = Self { given, points: Vec::new(), places: Vec::new() };
        let mut vertex_of_place = vec![0; places.len()];
        let runs: Vec<&[u32]> = order.chunk_by(|&a, &b| rounded(a) == rounded(b)).collect();
        let steps = stage("comparing points", runs.len());
        let classes_of = |(number, run): (usize, &[u32])| {
            steps.pass(number);
            classes(run, points)
        };
        let classes: Vec<Vec<Vec<u32>>> = runs.into_par_iter().enumerate().map(classes_of).collect();
        for class in classes.into_iter().flatten() {
            let point = &points[class[0] as usize];
            let corner = if point.is_exactly_rounded() { sheets.vertex_at(point.rounded()) } else { None };
            let vertex = corner.unwrap_or_else(|| {
                vertices.points.push(*point);
                vertices.places.push(places[class[0] as usize]);
                (given + vertices.points.len() - 1) as u32
            });
            class.iter().for_each(|&place| vertex_of_place[place as usize] = vertex);
        }
        (vertices, vertex_of_place)
    }

    pub(super) fn count(&self) -> usize {
        self.given + self.points.len()
    }

    /// The point of a vertex that is no corner.
    pub(super) fn new_point(&self, vertex: u32) -> Option<&SpatialPoint> {
        (vertex as usize).checked_sub(self.given).map(|new| &self.points[new])
    }

    pub(super) fn point<'a>(&'a self, sheets: &Sheets, vertex: u32) -> Cow<'a, SpatialPoint> {
        match self.new_point(vertex) {
            Some(point) => Cow::Borrowed(point),
            None => Cow::Owned(SpatialPoint::given(sheets.point(vertex))),
        }
    }

    pub(super) fn rounded(&self, sheets: &Sheets, vertex: u32) -> [f64; 3] {
        self.new_point(vertex).map_or_else(|| sheets.point(vertex), SpatialPoint::rounded)
    }
}

/// The classes of equal points among some that are rounded alike, in lexicographic order; each class rises.
fn classes(run: &[u32], points: &[SpatialPoint]) -> Vec<Vec<u32>> {
    let compare = |a: u32, b: u32| points[a as usize].compare(&points[b as usize]);
    let mut classes: Vec<Vec<u32>> = Vec::new();
    let mut rest = run.to_vec();
    while let Some(&first) = rest.first().filter(|_| classes.len() < SPLIT_OFF) {
        let (class, others) =
            rest.into_iter().partition(|&other| other == first || compare(first, other).is_eq());
        classes.push(class);
        rest = others;
    }
    rest.sort_by(|&a, &b| compare(a, b));
    classes.extend(rest.chunk_by(|&a, &b| compare(a, b).is_eq()).map(<[u32]>::to_vec));
    if classes.len() > 1 {
        classes.sort_by(|a, b| compare(a[0], b[0]));
    }
    classes
}
