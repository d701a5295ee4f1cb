//! The vertices of an arrangement: given points and crossings, equal ones made one, in lexicographic order.

use super::crossings::{Meetings, Soup};
use coface_geometry::predicates::{HomogeneousPoint, PlanarPoint};
use rayon::prelude::*;

/// Points in lexicographic order, none twice.
pub(super) struct Vertices {
    /// The lowest event of each vertex.
    pub(super) events: Vec<u32>,
    /// The vertex of each event.
    pub(super) vertex_of_event: Vec<u32>,
}

/// An event with the rounded coordinates that it is sorted by first.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) rounded: [f64; 2],
    pub(super) event: u32,
}

/// How many classes of equal points are split off one by one before the rest is sorted.
const SPLIT_OFF: usize = 8;

impl Vertices {
    /// The vertices of all given points of a soup, and then of all crossings.
    pub(super) fn of_soup(soup: &Soup, meetings: &Meetings) -> Self {
        let given = soup.points.len();
        let point = |event: u32| match (event as usize).checked_sub(given) {
            None => soup.point(event),
            Some(crossing) => meetings.crossings[crossing].point(soup),
        };
        let coordinates =
            soup.points.iter().copied().chain(meetings.crossings.iter().map(|crossing| crossing.rounded));
        Self::new(coordinates, point)
    }

    /// The vertices of events with these rounded coordinates.
    pub(super) fn new(
        rounded: impl Iterator<Item = [f64; 2]>,
        point: impl Fn(u32) -> PlanarPoint + Sync,
    ) -> Self {
        let mut places: Vec<Place> = rounded
            .enumerate()
            // Adding zero makes the negative zero positive.
            .map(|(event, rounded)| Place { rounded: rounded.map(|x| x + 0.0), event: event as u32 })
            .collect();
        places.par_sort_unstable_by(|a, b| {
            let by_axis = |axis: usize| a.rounded[axis].total_cmp(&b.rounded[axis]);
            by_axis(0).then_with(|| by_axis(1)).then(a.event.cmp(&b.event))
        });
        let mut vertices =
            Self { events: Vec::with_capacity(places.len()), vertex_of_event: vec![0; places.len()] };
        let is_exact = |event: u32| point(event).residues()[0].is_some_and(|side| side.is_eq());
        let mut classes: Vec<Vec<u32>> = Vec::new();
        for column in places.chunk_by(|a, b| a.rounded[0] == b.rounded[0]) {
            if let [place] = column {
                vertices.push(&[place.event]);
                continue;
            }
            // Rounded to one x, in the order of the rounded y; that is the true order where x is exact.
            let all_exact = column.iter().all(|place| is_exact(place.event));
            for same in column.chunk_by(|a, b| a.rounded[1] == b.rounded[1]) {
                match same {
                    [place] if all_exact => vertices.push(&[place.event]),
                    _ => split_into_classes(same, &point, &mut classes),
                }
                if all_exact {
                    classes.drain(..).for_each(|class| vertices.push(&class));
                }
            }
            if classes.len() > 1 {
                let mut exact: Vec<(PlanarPoint, HomogeneousPoint, Vec<u32>)> = std::mem::take(&mut classes)
                    .into_par_iter()
                    .map(|class| (point(class[0]), point(class[0]).to_homogeneous(), class))
                    .collect();
                exact.par_sort_by(|(_, a, _), (_, b, _)| a.compare(b));
                classes = exact.into_iter().map(|(_, _, class)| class).collect();
            }
            classes.drain(..).for_each(|class| vertices.push(&class));
        }
        vertices
    }

    /// The next vertex; the first of its events is the lowest.
    fn push(&mut self, events: &[u32]) {
        let vertex = self.events.len() as u32;
        self.events.push(events[0]);
        for &event in events {
            self.vertex_of_event[event as usize] = vertex;
        }
    }
}

/// Splits places with the same rounded coordinates into classes of equal points, in the order of the points.
pub(super) fn split_into_classes(
    places: &[Place],
    point: &(impl Fn(u32) -> PlanarPoint + Sync),
    classes: &mut Vec<Vec<u32>>,
) {
    let first = classes.len();
    let mut rest: Vec<u32> = places.iter().map(|place| place.event).collect();
    while let Some(&lowest) = rest.first() {
        if rest.len() == 1 || classes.len() - first == SPLIT_OFF {
            break;
        }
        let representative = point(lowest);
        let exact = representative.to_homogeneous();
        let is_equal = |&event: &u32| {
            let other = point(event);
            // Both are rounded alike: they are equal if nothing was rounded away, or if the exact points are.
            let both_exact = |side: [Option<std::cmp::Ordering>; 2]| {
                side.iter().all(|side| side.is_some_and(|side| side.is_eq()))
            };
            (both_exact(representative.residues()) && both_exact(other.residues()))
                || other.to_homogeneous().compare(&exact).is_eq()
        };
        let (class, others): (Vec<u32>, Vec<u32>) = if rest.len() < 1000 {
            rest.into_iter().partition(is_equal)
        } else {
            // Keeps the order.
            let equal: Vec<bool> = rest.par_iter().map(is_equal).collect();
            let mut flags = equal.into_iter();
            rest.into_iter().partition(|_| flags.next().expect("a flag for each"))
        };
        classes.push(class);
        rest = others;
    }
    let mut exact: Vec<(HomogeneousPoint, u32)> =
        rest.into_par_iter().map(|event| (point(event).to_homogeneous(), event)).collect();
    exact.par_sort_by(|(a, _), (b, _)| a.compare(b));
    for same in exact.chunk_by(|(a, _), (b, _)| a.compare(b).is_eq()) {
        classes.push(same.iter().map(|&(_, event)| event).collect());
    }
    if classes.len() > first + 1 {
        classes[first..].sort_by(|a, b| point(a[0]).compare(&point(b[0])));
    }
}
