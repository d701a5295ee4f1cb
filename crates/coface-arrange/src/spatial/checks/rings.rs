//! The rings of one face: whether they bound a polygon, and its triangles.

use super::flatness::{Flatness, make_round, tilt};
use super::holes::HoleFaults;
use super::{CheckedFaces, FaultCode, FaultPlace, FaultScope};
use crate::spatial::{GivenPoints, SpatialPredicates};
use coface_algebra::Error;
use coface_geometry::triangulation::{TriangulationFault, triangulate};
use std::cmp::Ordering;

/// The cosine of the greatest angle by which a part of a face may turn against the whole: 20 degrees.
const FOLD: f64 = 0.939_692_620_785_908_4;
/// A fold counts when points are off the plane by more than this part of the tolerance for flatness: what is below
/// is rounding.
const FOLD_DISTANCE: f64 = 0.01;
/// The tolerance for flatness, as a part of the diameter of a face, where none is given.
const USUAL_FLATNESS: f64 = 0.01;

/// What all faces are examined with.
pub(super) struct Points<'a> {
    pub(super) predicates: GivenPoints<'a>,
    pub(super) coordinates: &'a [f64],
    /// The lowest vertex with the same coordinates, for each vertex.
    pub(super) place: Vec<u32>,
    pub(super) flatness: Option<f64>,
}

impl Points<'_> {
    pub(super) fn point(&self, vertex: u32) -> [f64; 3] {
        let start = 3 * vertex as usize;
        [self.coordinates[start], self.coordinates[start + 1], self.coordinates[start + 2]]
    }
}

/// The triangles of faces, by places, with what each is a part of.
#[derive(Debug, Default)]
pub(super) struct Triangles {
    pub(super) corners: Vec<[u32; 3]>,
    pub(super) face: Vec<u32>,
    /// Bit i is set where the side from corner i to the next is a side of the face.
    pub(super) sides: Vec<u8>,
}

/// What is found about some faces.
#[derive(Debug, Default)]
pub(super) struct FoundFaces {
    pub(super) faults: Vec<(FaultCode, FaultScope, FaultPlace)>,
    pub(super) triangles: Triangles,
    pub(super) left_out: usize,
    /// The faces that have no ring left: fewer than three different points.
    pub(super) without_ring: Vec<u32>,
}

impl FoundFaces {
    fn add(&mut self, code: FaultCode, face: usize, vertices: Vec<u32>) {
        let scope = match code {
            FaultCode::RingTouches | FaultCode::NotFlat | FaultCode::Folded => FaultScope::Solid,
            _ => FaultScope::Surface,
        };
        let place = FaultPlace { faces: vec![face as u32], vertices, ..FaultPlace::default() };
        self.faults.push((code, scope, place));
    }

    fn leave_out(&mut self) {
        self.left_out += 1;
    }

    /// Examines a face.
    ///
    /// # Errors
    /// Those of an arrangement of its rings, where it has holes.
    pub(super) fn examine(
        &mut self,
        points: &Points<'_>,
        faces: &CheckedFaces,
        face: usize,
    ) -> Result<(), Error> {
        let range = faces.rings_of_face(face);
        if range.len() == 1
            && let [a, b, c] = *faces.rings().list(range.start)
        {
            let corners = [a, b, c].map(|vertex| points.place[vertex as usize]);
            if corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0] {
                if axis_of(points, corners).is_some() {
                    self.triangles.push(corners, face, 7);
                } else {
                    self.add(FaultCode::RingWithoutArea, face, vec![a, b, c]);
                    self.leave_out();
                }
                return Ok(());
            }
        }
        let mut rings = Vec::new();
        for ring in range {
            let list = faces.rings().list(ring);
            match shortened(points, list) {
                None => {
                    self.add(FaultCode::TooFewPoints, face, list.to_vec());
                    if rings.is_empty() {
                        self.without_ring.push(face as u32);
                        self.leave_out();
                        return Ok(());
                    }
                }
                Some((ring, repeated)) => {
                    if let Some(vertex) = repeated {
                        self.add(FaultCode::RepeatedPoints, face, vec![vertex]);
                    }
                    rings.push(ring);
                }
            }
        }
        self.polygon(points, face, &rings)
    }

    /// A face by the places of its rings, each with three or more.
    fn polygon(&mut self, points: &Points<'_>, face: usize, rings: &[Vec<u32>]) -> Result<(), Error> {
        let shape: Vec<Vec<[f64; 3]>> =
            rings.iter().map(|ring| ring.iter().map(|&place| points.point(place)).collect()).collect();
        let fit = Flatness::of(&shape);
        let outer = &rings[0];
        // The first two points are at different places: without a point off their line there is no area.
        let corner = (2..outer.len())
            .map(|i| [outer[0], outer[1], outer[i]])
            .find_map(|corners| Some((corners, axis_of(points, corners)?)));
        let Some((corners, axis)) = corner else {
            self.add(FaultCode::RingWithoutArea, face, outer.clone());
            self.leave_out();
            return Ok(());
        };
        let off_plane = |&place: &u32| {
            let [a, b, c] = corners;
            !corners.contains(&place) && points.predicates.orientation([a, b, c, place]).is_ne()
        };
        let is_flat = !rings.iter().flatten().any(off_plane);
        let nearest = fit.axis();
        let is_usable = !is_flat || points.predicates.normal_sign(nearest, corners).is_ne();
        let axis = if is_usable && fit.normal != [0.0; 3] { nearest } else { axis };
        let tolerance = points.flatness.unwrap_or(USUAL_FLATNESS * fit.diameter);
        let is_off = !is_flat && fit.distance > tolerance;
        if is_off {
            let far = rings.iter().flatten().nth(fit.farthest).copied();
            self.add(FaultCode::NotFlat, face, far.into_iter().collect());
            if let Some((_, _, place)) = self.faults.last_mut() {
                place.distance = Some(fit.distance);
                place.point = far.map(|far| points.point(far));
            }
        }
        let faults = self.faults.len();
        let mut signs = Vec::with_capacity(rings.len());
        let mut triangles = Vec::new();
        for ring in rings {
            match simple_ring(points, axis, ring) {
                Ok((sign, own)) => {
                    signs.push(sign);
                    triangles = own;
                    if let Some(place) = repeated_place(ring) {
                        self.add(FaultCode::RingTouches, face, vec![place]);
                    }
                }
                Err((code, vertices)) => {
                    // A fold that stands upright over the plane is seen where the ring meets itself.
                    self.add(code, face, vertices);
                }
            }
        }
        if signs.len() < rings.len() {
            self.leave_out();
            return Ok(());
        }
        if rings.len() > 1 {
            let found = HoleFaults::of(points, axis, rings)?;
            for &(code, [ring, other]) in &found.faults {
                self.add(code, face, vec![rings[ring][0], rings[other][0]]);
            }
            for hole in (1..rings.len()).filter(|&hole| signs[hole] == signs[0]) {
                self.add(FaultCode::HoleOrientation, face, vec![rings[hole][0]]);
            }
            if !found.faults.is_empty() {
                self.leave_out();
                return Ok(());
            }
            let mut turned = rings.to_vec();
            for hole in (1..rings.len()).filter(|&hole| signs[hole] == signs[0]) {
                turned[hole].reverse();
            }
            match triangles_of(points, axis, signs[0], &turned) {
                Ok(own) => triangles = own,
                Err(_) => {
                    self.leave_out();
                    return Ok(());
                }
            }
        }
        let mut sides: Vec<[u32; 2]> = rings
            .iter()
            .flat_map(|ring| (0..ring.len()).map(|i| ordered(ring[i], ring[(i + 1) % ring.len()])))
            .collect();
        sides.sort_unstable();
        let is_side = |a: u32, b: u32| sides.binary_search(&ordered(a, b)).is_ok();
        if !is_flat && !is_off && fit.distance > FOLD_DISTANCE * tolerance && self.faults.len() == faults {
            let mut round = triangles.clone();
            // Triangles run as the face does, so that its normal is theirs.
            make_round(&mut round, is_side, |place| points.point(place), fit.normal);
            let folded = round.iter().find(|own| {
                tilt(own.map(|place| points.point(place)), fit.normal).is_some_and(|cosine| cosine < FOLD)
            });
            if let Some(&folded) = folded {
                self.add(FaultCode::Folded, face, folded.to_vec());
                if let Some((_, _, place)) = self.faults.last_mut() {
                    place.distance = Some(fit.distance);
                }
            }
        }
        for own in triangles {
            let mask = (0..3).map(|i| u8::from(is_side(own[i], own[(i + 1) % 3])) << i).sum();
            self.triangles.push(own, face, mask);
        }
        Ok(())
    }
}

impl Triangles {
    fn push(&mut self, corners: [u32; 3], face: usize, sides: u8) {
        self.corners.push(corners);
        self.face.push(face as u32);
        self.sides.push(sides);
    }

    pub(super) fn append(&mut self, other: &mut Self) {
        self.corners.append(&mut other.corners);
        self.face.append(&mut other.face);
        self.sides.append(&mut other.sides);
    }
}

fn ordered(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// An axis along which three points have an area.
fn axis_of(points: &Points<'_>, corners: [u32; 3]) -> Option<usize> {
    (0..3).find(|&axis| points.predicates.normal_sign(axis, corners).is_ne())
}

/// A ring by places without repetitions of a point after itself, and the first vertex that is one; `None` with fewer
/// than three different places.
fn shortened(points: &Points<'_>, ring: &[u32]) -> Option<(Vec<u32>, Option<u32>)> {
    let mut places = Vec::with_capacity(ring.len());
    let mut repeated = None;
    for &vertex in ring {
        let place = points.place[vertex as usize];
        if places.last() == Some(&place) {
            repeated.get_or_insert(vertex);
        } else {
            places.push(place);
        }
    }
    while places.len() > 1 && places.first() == places.last() {
        places.pop();
        repeated.get_or_insert(ring[0]);
    }
    let mut different = places.clone();
    different.sort_unstable();
    different.dedup();
    (different.len() >= 3).then_some((places, repeated))
}

/// A place that a ring runs through twice.
fn repeated_place(ring: &[u32]) -> Option<u32> {
    let mut sorted = ring.to_vec();
    sorted.sort_unstable();
    sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}

/// The triangles of rings, in the direction in which the outer ring runs: counterclockwise seen along the axis if
/// `sign` is `Greater`.
fn triangles_of(
    points: &Points<'_>,
    axis: usize,
    sign: Ordering,
    rings: &[Vec<u32>],
) -> Result<Vec<[u32; 3]>, TriangulationFault> {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let (first, second) = if sign.is_gt() { (j, k) } else { (k, j) };
    let predicates = &points.predicates;
    let compare =
        |a: u32, b: u32| predicates.compare(first, a, b).then_with(|| predicates.compare(second, a, b));
    let turn = |a: u32, b: u32, c: u32| {
        let turn = predicates.normal_sign(axis, [a, b, c]);
        if sign.is_gt() { turn } else { turn.reverse() }
    };
    triangulate(rings, compare, turn)
}

/// The direction of a ring that meets itself in common vertices at most, and its triangles; else what is wrong.
#[allow(clippy::type_complexity, reason = "one caller")]
fn simple_ring(
    points: &Points<'_>,
    axis: usize,
    ring: &[u32],
) -> Result<(Ordering, Vec<[u32; 3]>), (FaultCode, Vec<u32>)> {
    let predicates = &points.predicates;
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let lowest = (0..ring.len())
        .min_by(|&a, &b| {
            predicates.compare(j, ring[a], ring[b]).then_with(|| predicates.compare(k, ring[a], ring[b]))
        })
        .unwrap_or(0);
    let around = [(lowest + ring.len() - 1) % ring.len(), lowest, (lowest + 1) % ring.len()];
    // Where a ring runs through its lowest vertex twice, this can be the wrong direction.
    let guess = if predicates.normal_sign(axis, around.map(|i| ring[i])).is_lt() {
        Ordering::Less
    } else {
        Ordering::Greater
    };
    let whole = [ring.to_vec()];
    let fault = match triangles_of(points, axis, guess, &whole) {
        Ok(triangles) => return Ok((guess, triangles)),
        Err(fault) => fault,
    };
    if let Ok(triangles) = triangles_of(points, axis, guess.reverse(), &whole) {
        return Ok((guess.reverse(), triangles));
    }
    Err(match fault {
        TriangulationFault::Crossing([[a, b], [c, d]]) => {
            // Sides that lie on each other only touch.
            let turn = |p, q, r| predicates.normal_sign(axis, [p, q, r]);
            let is_proper = turn(a, b, c) == turn(a, b, d).reverse()
                && turn(a, b, c).is_ne()
                && turn(c, d, a) == turn(c, d, b).reverse()
                && turn(c, d, a).is_ne();
            let code = if is_proper { FaultCode::RingCrosses } else { FaultCode::RingTouches };
            (code, vec![a, b, c, d])
        }
        TriangulationFault::OnSide { vertex, side: [a, b] } => (FaultCode::RingTouches, vec![vertex, a, b]),
        TriangulationFault::RepeatedSide(pair) | TriangulationFault::SamePlace(pair) => {
            (FaultCode::RingTouches, pair.to_vec())
        }
        TriangulationFault::NoLength(vertex) | TriangulationFault::WrongWay(vertex) => {
            (FaultCode::RingTouches, vec![vertex])
        }
    })
}
