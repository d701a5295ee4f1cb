//! The classes of vertices by a tolerance.

use coface_check::Fault;
use coface_check::json::{field, text};
use serde_json::Value;
use std::collections::HashMap;

const STEP: &str = "classes";

/// How the tolerance makes classes.
#[derive(Clone, Copy)]
pub(crate) enum Rule {
    /// Steps from vertex to vertex.
    Transitive,
    /// In the order of the vertices, around the first of each.
    Greedy,
}

impl Rule {
    /// The rule of a certificate; `None` where classes were merged again, of which nothing is proved.
    pub(crate) fn of(whole: &Value) -> Result<Option<Self>, Fault> {
        match text(field(whole, "rule", "certificate")?, "\"rule\"", "certificate")? {
            "transitive" => Ok(Some(Self::Transitive)),
            "greedy" => Ok(Some(Self::Greedy)),
            "stable" => Ok(None),
            other => Err(Fault::new("certificate", format!("{other:?} is no rule of classes"))),
        }
    }

    /// What was proved of so many classes.
    pub(crate) fn claim(self, vertices: usize, classes: usize, tolerance: f64) -> String {
        match self {
            Self::Transitive => format!(
                "{vertices} vertices are {classes} classes: joined by steps of at most {tolerance}, and no two of different classes that near"
            ),
            Self::Greedy => {
                format!(
                    "{vertices} vertices are {classes} classes: in order, each with those that have none before within {tolerance}"
                )
            }
        }
    }
}

/// Checks that the classes are those of the rule, numbered by their first vertices.
///
/// Distances are computed in doubles, with an error below 2^-50 of the tolerance. Where that leaves open whether two points are within it, either is
/// taken.
pub(crate) fn check(points: &[[f64; 3]], class_of: &[u32], tolerance: f64, rule: Rule) -> Result<(), Fault> {
    // The first vertex of each class.
    let mut firsts: Vec<u32> = Vec::new();
    for (vertex, &class) in (0u32..).zip(class_of) {
        match (class as usize).cmp(&firsts.len()) {
            std::cmp::Ordering::Less => (),
            std::cmp::Ordering::Equal => firsts.push(vertex),
            std::cmp::Ordering::Greater => {
                let message = format!("class {} is first met after class {class}", firsts.len());
                return Err(Fault::new(STEP, message));
            }
        }
    }
    let near = Near { points, tolerance };
    match rule {
        Rule::Transitive => transitive(&near, class_of, firsts.len()),
        Rule::Greedy => greedy(&near, class_of, &firsts),
    }
}

/// No two vertices of different classes are near, and those of one class are joined by pairs that may be.
fn transitive(near: &Near<'_>, class_of: &[u32], class_count: usize) -> Result<(), Fault> {
    let mut joined: Vec<u32> = (0..class_of.len() as u32).collect();
    let mut part_count = class_of.len();
    let cells = near.cells()?;
    let mut meet = |a: u32, b: u32| -> Result<(), Fault> {
        let is_one_class = class_of[a as usize] == class_of[b as usize];
        let [root, other] = [a, b].map(|vertex| root(&mut joined, vertex));
        if is_one_class && root == other {
            return Ok(());
        }
        let by = near.nearness(a, b);
        if !is_one_class && by == Nearness::Within {
            return Err(Fault::new(STEP, format!("vertices {a} and {b} are near, and in different classes")));
        }
        if is_one_class && by != Nearness::Beyond {
            joined[root as usize] = other;
            part_count -= 1;
        }
        Ok(())
    };
    let mut places: Vec<Place> = cells.keys().copied().collect();
    places.sort_unstable();
    for place in places {
        let members = &cells[&place];
        // All points of a cell are near its first: its diagonal is less than the tolerance, with rounding too.
        for &vertex in &members[1..] {
            meet(vertex, members[0])?;
        }
        for other in places_behind(place).filter_map(|place| cells.get(&place)) {
            for &a in members {
                for &b in other {
                    meet(a, b)?;
                }
            }
        }
    }
    if part_count != class_count {
        return Err(Fault::new(STEP, format!("near vertices make {part_count} classes, not {class_count}")));
    }
    Ok(())
}

fn root(joined: &mut [u32], mut vertex: u32) -> u32 {
    while joined[vertex as usize] != vertex {
        let above = joined[joined[vertex as usize] as usize];
        joined[vertex as usize] = above;
        vertex = above;
    }
    vertex
}

/// Each vertex may be near the first of its class, and is near the first of no class before.
fn greedy(near: &Near<'_>, class_of: &[u32], firsts: &[u32]) -> Result<(), Fault> {
    let cells = near.cells()?;
    for (class, &first) in (0u32..).zip(firsts) {
        let place = near.place(first)?;
        for vertex in places_around(place).filter_map(|place| cells.get(&place)).flatten().copied() {
            if class_of[vertex as usize] > class && near.nearness(first, vertex) == Nearness::Within {
                let message = format!(
                    "vertex {vertex} is near vertex {first}, the first of class {class}, and in a class behind"
                );
                return Err(Fault::new(STEP, message));
            }
        }
    }
    for (vertex, &class) in (0u32..).zip(class_of) {
        let first = firsts[class as usize];
        if near.nearness(vertex, first) == Nearness::Beyond {
            let message = format!(
                "vertex {vertex} is farther than the tolerance from vertex {first}, the first of its class"
            );
            return Err(Fault::new(STEP, message));
        }
    }
    Ok(())
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Nearness {
    Within,
    /// Within or beyond, as rounding has it.
    Open,
    Beyond,
}

struct Near<'a> {
    points: &'a [[f64; 3]],
    tolerance: f64,
}

type Place = [i64; 3];

/// Near points are in cells at most so many apart: two that are within the tolerance, and one because the first point can be anywhere in its cell, also
/// with rounding, which is at most a sixteenth of a cell.
const REACH: i64 = 3;
/// Farther than so many cells from the origin rounding is more.
const FARTHEST: f64 = (1u64 << 49) as f64;

impl Near<'_> {
    fn nearness(&self, a: u32, b: u32) -> Nearness {
        let [a, b] = [a, b].map(|vertex| self.points[vertex as usize]);
        if a == b {
            return Nearness::Within;
        }
        let square: f64 = a.iter().zip(b).map(|(x, y)| ((x - y) / self.tolerance).powi(2)).sum();
        let error = f64::powi(2.0, -49);
        match square {
            _ if square <= 1.0 - error => Nearness::Within,
            _ if square <= 1.0 + error => Nearness::Open,
            // Nothing but equal points is within the tolerance zero.
            _ => Nearness::Beyond,
        }
    }

    /// The points in cubes with half of the tolerance as their sides; without a tolerance equal points.
    fn cells(&self) -> Result<HashMap<Place, Vec<u32>>, Fault> {
        let mut cells: HashMap<Place, Vec<u32>> = HashMap::new();
        for vertex in 0..self.points.len() as u32 {
            cells.entry(self.place(vertex)?).or_default().push(vertex);
        }
        Ok(cells)
    }

    fn place(&self, vertex: u32) -> Result<Place, Fault> {
        let point = self.points[vertex as usize];
        if self.tolerance == 0.0 {
            // Zeros of both signs are equal. Neighbors of such a place are other points, which are not near.
            return Ok(point.map(|x| (x + 0.0).to_bits() as i64));
        }
        let place = point.map(|x| (x / (0.5 * self.tolerance)).floor());
        match place.iter().all(|x| x.abs() < FARTHEST) {
            true => Ok(place.map(|x| x as i64)),
            false => Err(Fault::new(
                STEP,
                "the tolerance is below 2^-48 of the coordinates, too small for the checker",
            )),
        }
    }
}

fn places_around(place: Place) -> impl Iterator<Item = Place> {
    let range = -REACH..=REACH;
    let steps = range.clone().flat_map(move |x| {
        let range = range.clone();
        range.clone().flat_map(move |y| range.clone().map(move |z| [x, y, z]))
    });
    steps.map(move |step| [0, 1, 2].map(|axis| place[axis].wrapping_add(step[axis])))
}

/// One of each two opposite places around a place, and not the place itself.
fn places_behind(place: Place) -> impl Iterator<Item = Place> {
    places_around(place).skip((2 * REACH as usize + 1).pow(3) / 2 + 1)
}

#[cfg(test)]
mod tests {
    use super::{Rule, check};

    type Points = Vec<[f64; 3]>;

    /// Points in a cube of this side, somewhere.
    fn cloud(count: usize, side: f64, corner: f64, mut state: u64) -> Points {
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            corner + side * (state >> 40) as f64 / f64::from(1 << 24)
        };
        (0..count).map(|_| [next(), next(), next()]).collect()
    }

    fn is_near(points: &Points, a: usize, b: usize, tolerance: f64) -> bool {
        let square: f64 = points[a].iter().zip(points[b]).map(|(x, y)| (x - y) * (x - y)).sum();
        square <= tolerance * tolerance
    }

    /// The classes by comparing each with each, numbered by their first vertices.
    fn classes(points: &Points, tolerance: f64, rule: Rule) -> Vec<u32> {
        let mut class_of: Vec<Option<u32>> = vec![None; points.len()];
        let mut count = 0;
        for first in 0..points.len() {
            if class_of[first].is_some() {
                continue;
            }
            class_of[first] = Some(count);
            let mut open = vec![first];
            while let Some(at) = open.pop() {
                for (other, class) in class_of.iter_mut().enumerate() {
                    if class.is_none() && is_near(points, at, other, tolerance) {
                        *class = Some(count);
                        if let Rule::Transitive = rule {
                            open.push(other);
                        }
                    }
                }
            }
            count += 1;
        }
        class_of.into_iter().flatten().collect()
    }

    #[test]
    fn classes_are_those_of_each_with_each() {
        for seed in 0..8 {
            // Far from the origin too, where a cell is a few of the least differences of doubles.
            for (tolerance, corner) in [(0.0, 0.0), (0.08, 0.0), (0.15, -1.0), (0.3, 1e13), (2.0, -4e14)] {
                let mut points = cloud(120, 1f64.max(8.0 * tolerance), corner, seed);
                points.extend(points.clone().into_iter().take(9));
                for rule in [Rule::Transitive, Rule::Greedy] {
                    let truth = classes(&points, tolerance, rule);
                    check(&points, &truth, tolerance, rule)
                        .unwrap_or_else(|fault| panic!("{seed} {tolerance} {corner}: {fault}"));
                    // A class that loses its last member, and two classes that are one.
                    let count = truth.iter().max().map_or(0, |last| last + 1);
                    let mut split = truth.clone();
                    if let Some(at) = (0..truth.len()).rev().find(|&at| truth[..at].contains(&truth[at])) {
                        split[at] = count;
                        assert!(
                            check(&points, &split, tolerance, rule).is_err(),
                            "{seed} {tolerance} {corner}"
                        );
                    }
                    if count > 1 {
                        let joined: Vec<u32> = truth.iter().map(|&class| class.min(count - 2)).collect();
                        assert!(
                            check(&points, &joined, tolerance, rule).is_err(),
                            "{seed} {tolerance} {corner}"
                        );
                    }
                }
            }
        }
    }
}
