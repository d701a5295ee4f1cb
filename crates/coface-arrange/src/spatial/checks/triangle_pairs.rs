//! How two triangles of different faces meet, decided exactly.

use super::rings::{Points, Triangles};
use crate::spatial::SpatialPredicates;
use coface_geometry::predicates::PlaneFilter;
use rayon::prelude::*;
use std::cmp::Ordering;

/// How two triangles meet beyond the vertices and sides that their faces have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Meeting {
    /// Their insides cross along a segment.
    Cross,
    /// They are in one plane and share an area; they look the same way.
    Overlap,
    /// They are in one plane and share an area; they look opposite ways.
    OverlapReversed,
    /// They have points in common, but neither of these.
    Touch,
}

/// Triangles with what decisions about many pairs of them need.
pub(super) struct TrianglePairs<'a> {
    points: &'a Points<'a>,
    triangles: &'a Triangles,
    planes: Vec<PlaneFilter>,
}

impl<'a> TrianglePairs<'a> {
    pub(super) fn new(points: &'a Points<'a>, triangles: &'a Triangles) -> Self {
        let planes = triangles
            .corners
            .par_iter()
            .map(|corners| PlaneFilter::new(corners.map(|corner| points.point(corner))))
            .collect();
        Self { points, triangles, planes }
    }

    /// On which side of the plane of a triangle a point lies.
    fn side(&self, triangle: usize, corners: [u32; 3], place: u32) -> Ordering {
        let [a, b, c] = corners;
        if corners.contains(&place) {
            return Ordering::Equal;
        }
        let quick = self.planes[triangle].side_of(self.points.point(place));
        quick.unwrap_or_else(|| self.points.predicates.orientation([a, b, c, place]))
    }

    fn orientation(&self, a: u32, b: u32, c: u32, d: u32) -> Ordering {
        self.points.predicates.orientation([a, b, c, d])
    }

    /// How two triangles meet; touching is looked for only where it is wanted.
    pub(super) fn meeting(&self, t: usize, u: usize, wants_touch: bool) -> Option<Meeting> {
        let (first, second) = (self.triangles.corners[t], self.triangles.corners[u]);
        let is_shared = |corner: &u32| second.contains(corner);
        match first.iter().filter(|corner| is_shared(corner)).count() {
            3 => Some(self.overlap(first, second)),
            2 => {
                let own = first.into_iter().find(|corner| !is_shared(corner)).expect("a third corner");
                let other =
                    second.into_iter().find(|corner| !first.contains(corner)).expect("a third corner");
                if self.side(t, first, other).is_eq() {
                    let [a, b] = shared_pair(first, second);
                    let axis = self.axis(first);
                    let turn = |c| self.points.predicates.normal_sign(axis, [a, b, c]);
                    if turn(own) == turn(other) {
                        return Some(self.overlap(first, second));
                    }
                }
                // The common side has to be a side of both faces.
                let is_side = |triangle: usize, corners: [u32; 3]| {
                    (0..3).any(|i| {
                        is_shared_side(corners[i], corners[(i + 1) % 3], first, second)
                            && self.triangles.sides[triangle] >> i & 1 == 1
                    })
                };
                let is_edge = is_side(t, first) && is_side(u, second);
                (wants_touch && !is_edge).then_some(Meeting::Touch)
            }
            shared => self.general(t, u, shared == 1, wants_touch),
        }
    }

    fn overlap(&self, first: [u32; 3], second: [u32; 3]) -> Meeting {
        let axis = self.axis(first);
        let sign = |corners| self.points.predicates.normal_sign(axis, corners);
        if sign(first) == sign(second) { Meeting::Overlap } else { Meeting::OverlapReversed }
    }

    /// An axis along which a triangle has an area.
    fn axis(&self, corners: [u32; 3]) -> usize {
        let has_area = |&axis: &usize| self.points.predicates.normal_sign(axis, corners).is_ne();
        (0..3).find(has_area).expect("triangles of faces have an area")
    }

    /// Triangles with at most one common corner.
    fn general(&self, t: usize, u: usize, has_common: bool, wants_touch: bool) -> Option<Meeting> {
        let (first, second) = (self.triangles.corners[t], self.triangles.corners[u]);
        let of_second = second.map(|corner| self.side(t, first, corner));
        if is_apart(of_second) {
            return None;
        }
        let of_first = first.map(|corner| self.side(u, second, corner));
        if is_apart(of_first) {
            return None;
        }
        if of_second.iter().all(|side| side.is_eq()) {
            return self.in_one_plane(first, second, has_common, wants_touch);
        }
        if is_mixed(of_first) && is_mixed(of_second) {
            match self.overlap_on_line(first, of_first, second, of_second) {
                Ordering::Greater => return None,
                Ordering::Less => return Some(Meeting::Cross),
                // One point: the common corner, or a touch.
                Ordering::Equal => return (wants_touch && !has_common).then_some(Meeting::Touch),
            }
        }
        if !wants_touch {
            return None;
        }
        // One is on one side of the other. From a common corner, a further common point leads to one on a side
        // opposite to that corner.
        let meets = |own: [u32; 3], sides: [Ordering; 3], other: [u32; 3]| {
            (0..3).any(|i| {
                let (p, q) = (own[i], own[(i + 1) % 3]);
                let skipped = other.contains(&p) || other.contains(&q);
                !skipped && self.segment_meets([p, q], [sides[i], sides[(i + 1) % 3]], other)
            })
        };
        (meets(first, of_first, second) || meets(second, of_second, first)).then_some(Meeting::Touch)
    }

    /// Triangles that both cross the plane of the other: `Less` when their segments on the common line share more than
    /// a point, `Equal` when they share a point, `Greater` when they are apart.
    ///
    /// P. Guigue, O. Devillers, *Fast and robust triangle-triangle overlap test using orientation predicates* (2003).
    fn overlap_on_line(
        &self,
        first: [u32; 3],
        of_first: [Ordering; 3],
        second: [u32; 3],
        of_second: [Ordering; 3],
    ) -> Ordering {
        let (mut first, first_side) = lone_corner_first(first, of_first);
        let (mut second, second_side) = lone_corner_first(second, of_second);
        // The lone corners are to be in front of the planes.
        if first_side.is_lt() {
            second.swap(1, 2);
        }
        if second_side.is_lt() {
            first.swap(1, 2);
        }
        let [p, q, r] = first;
        let [s, t, v] = second;
        self.orientation(p, q, s, t).max(self.orientation(p, r, v, s))
    }

    fn in_one_plane(
        &self,
        first: [u32; 3],
        second: [u32; 3],
        has_common: bool,
        wants_touch: bool,
    ) -> Option<Meeting> {
        let axis = self.axis(first);
        // The greatest turn of a corner of one to the inside of each side of the other.
        let depth = |own: [u32; 3], other: &[u32]| {
            let around = self.points.predicates.normal_sign(axis, own);
            let inside = |a, b, c| {
                let turn = self.points.predicates.normal_sign(axis, [a, b, c]);
                if around.is_gt() { turn } else { turn.reverse() }
            };
            (0..3)
                .map(|i| {
                    let deepest = other.iter().map(|&corner| inside(own[i], own[(i + 1) % 3], corner)).max();
                    deepest.unwrap_or(Ordering::Less)
                })
                .min()
                .unwrap_or(Ordering::Less)
        };
        match depth(first, &second).min(depth(second, &first)) {
            Ordering::Greater => Some(self.overlap(first, second)),
            Ordering::Less => None,
            Ordering::Equal if !wants_touch => None,
            Ordering::Equal if !has_common => Some(Meeting::Touch),
            Ordering::Equal => {
                let meets = |own: [u32; 3], other: [u32; 3]| {
                    (0..3).any(|i| {
                        let (p, q) = (own[i], own[(i + 1) % 3]);
                        !other.contains(&p)
                            && !other.contains(&q)
                            && depth(other, &[p, q]).is_ge()
                            && self.line_meets(axis, [p, q], other)
                    })
                };
                (meets(first, second) || meets(second, first)).then_some(Meeting::Touch)
            }
        }
    }

    /// Whether the line of a segment meets a triangle of the same plane.
    fn line_meets(&self, axis: usize, [p, q]: [u32; 2], corners: [u32; 3]) -> bool {
        let turns = corners.map(|corner| self.points.predicates.normal_sign(axis, [p, q, corner]));
        !is_apart(turns)
    }

    /// Whether a segment whose ends lie on these sides of the plane of a triangle meets the triangle.
    fn segment_meets(&self, [p, q]: [u32; 2], sides: [Ordering; 2], corners: [u32; 3]) -> bool {
        let [a, b, c] = corners;
        let axis = self.axis(corners);
        let holds = |place: u32| {
            let turns = [[a, b, place], [b, c, place], [c, a, place]]
                .map(|corners| self.points.predicates.normal_sign(axis, corners));
            !is_mixed(turns)
        };
        match sides {
            [Ordering::Equal, Ordering::Equal] => {
                let around = self.points.predicates.normal_sign(axis, corners);
                let is_beside = (0..3).any(|i| {
                    [p, q].iter().all(|&end| {
                        let side = [corners[i], corners[(i + 1) % 3], end];
                        self.points.predicates.normal_sign(axis, side) == around.reverse()
                    })
                });
                !is_beside && self.line_meets(axis, [p, q], corners)
            }
            [Ordering::Equal, _] => holds(p),
            [_, Ordering::Equal] => holds(q),
            [one, other] if one == other => false,
            _ => {
                let turns = [[a, b], [b, c], [c, a]].map(|[from, to]| self.orientation(p, q, from, to));
                !is_mixed(turns)
            }
        }
    }

    /// A point that two triangles have in common, rounded; the middle of their segment where they cross.
    pub(super) fn point_of(&self, t: usize, u: usize) -> [f64; 3] {
        let [first, second] =
            [t, u].map(|triangle| self.triangles.corners[triangle].map(|corner| self.points.point(corner)));
        let mut hits: Vec<[f64; 3]> = Vec::new();
        for (own, other) in [(first, second), (second, first)] {
            for i in 0..3 {
                hits.extend(crossing(own[i], own[(i + 1) % 3], other));
            }
        }
        let count = hits.len() as f64;
        if hits.is_empty() {
            // In one plane, or at a corner: the middle of what the boxes have in common.
            let range = |corners: [[f64; 3]; 3], axis: usize| {
                let low = corners.iter().fold(f64::INFINITY, |low, p| low.min(p[axis]));
                [low, corners.iter().fold(f64::NEG_INFINITY, |high, p| high.max(p[axis]))]
            };
            return [0, 1, 2].map(|axis| {
                let ([a, b], [c, d]) = (range(first, axis), range(second, axis));
                a.max(c) / 2.0 + b.min(d) / 2.0
            });
        }
        hits.iter().fold([0.0; 3], |sum, p| [0, 1, 2].map(|i| sum[i] + p[i] / count))
    }
}

/// Where a segment crosses a triangle, rounded.
fn crossing(p: [f64; 3], q: [f64; 3], [a, b, c]: [[f64; 3]; 3]) -> Option<[f64; 3]> {
    let minus = |x: [f64; 3], y: [f64; 3]| [0, 1, 2].map(|i| x[i] - y[i]);
    let determinant = coface_geometry::determinant;
    let (below, above) = (
        determinant(minus(b, a), minus(c, a), minus(p, a)),
        determinant(minus(b, a), minus(c, a), minus(q, a)),
    );
    let part = below / (below - above);
    let turns =
        [[a, b], [b, c], [c, a]].map(|[from, to]| determinant(minus(from, p), minus(to, p), minus(q, p)));
    let is_in = turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0);
    ((0.0..=1.0).contains(&part) && is_in).then(|| [0, 1, 2].map(|i| p[i] * (1.0 - part) + q[i] * part))
}

fn is_apart(sides: [Ordering; 3]) -> bool {
    sides[0].is_ne() && sides[0] == sides[1] && sides[1] == sides[2]
}

fn is_mixed(sides: [Ordering; 3]) -> bool {
    sides.contains(&Ordering::Less) && sides.contains(&Ordering::Greater)
}

/// The corners turned so that the first is alone on its side, and that side.
fn lone_corner_first(corners: [u32; 3], sides: [Ordering; 3]) -> ([u32; 3], Ordering) {
    let in_front = sides.iter().filter(|side| side.is_gt()).count();
    let side = if in_front == 1 { Ordering::Greater } else { Ordering::Less };
    let lone = sides.iter().position(|&own| own == side).expect("corners are on both sides");
    ([0, 1, 2].map(|i| corners[(lone + i) % 3]), side)
}

/// The two corners that triangles have in common.
fn shared_pair(first: [u32; 3], second: [u32; 3]) -> [u32; 2] {
    let mut shared = first.into_iter().filter(|corner| second.contains(corner));
    [0, 1].map(|_| shared.next().expect("two common corners"))
}

fn is_shared_side(a: u32, b: u32, first: [u32; 3], second: [u32; 3]) -> bool {
    [a, b].iter().all(|corner| first.contains(corner) && second.contains(corner))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::GivenPoints;
    use coface_algebra::Rational;
    use coface_geometry::Positions;
    use proptest::prelude::*;

    type Point = [Rational; 3];

    fn minus(a: &Point, b: &Point) -> Point {
        [0, 1, 2].map(|i| &a[i] - &b[i])
    }

    fn dot(a: &Point, b: &Point) -> Rational {
        (0..3).map(|i| &a[i] * &b[i]).fold(Rational::ZERO, |sum, term| &sum + &term)
    }

    fn cross(a: &Point, b: &Point) -> Point {
        [0, 1, 2].map(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            &(&a[j] * &b[k]) - &(&a[k] * &b[j])
        })
    }

    /// The part of a segment or polygon on the inner side of a plane through `at`: clipping by exact fractions.
    fn clipped(polygon: &[Point], at: &Point, normal: &Point) -> Vec<Point> {
        let height = |p: &Point| dot(&minus(p, at), normal);
        let mut kept = Vec::new();
        for (i, p) in polygon.iter().enumerate() {
            let q = &polygon[(i + 1) % polygon.len()];
            let (from, to) = (height(p), height(q));
            if from >= Rational::ZERO {
                kept.push(p.clone());
            }
            if (from > Rational::ZERO && to < Rational::ZERO)
                || (from < Rational::ZERO && to > Rational::ZERO)
            {
                let part = &from * &(&from - &to).inverse().unwrap();
                kept.push([0, 1, 2].map(|i| &p[i] + &(&(&q[i] - &p[i]) * &part)));
            }
        }
        kept
    }

    /// The corners of the intersection of two triangles: the first is clipped by both sides of the plane of the
    /// second, then by its three sides.
    fn intersection(first: &[Point; 3], second: &[Point; 3]) -> Vec<Point> {
        let normal = cross(&minus(&second[1], &second[0]), &minus(&second[2], &second[0]));
        let reversed = normal.clone().map(|x| -x);
        let mut rest = clipped(first, &second[0], &normal);
        rest = clipped(&rest, &second[0], &reversed);
        for i in 0..3 {
            let inner = cross(&normal, &minus(&second[(i + 1) % 3], &second[i]));
            rest = clipped(&rest, &second[i], &inner);
        }
        let mut corners: Vec<Point> = Vec::new();
        for point in rest {
            if !corners.contains(&point) {
                corners.push(point);
            }
        }
        corners
    }

    /// The same question by fractions: the whole intersection is found, and compared with the common corners and sides.
    fn expected(first: &[Point; 3], second: &[Point; 3]) -> Option<Meeting> {
        let normal = |t: &[Point; 3]| cross(&minus(&t[1], &t[0]), &minus(&t[2], &t[0]));
        let corners = intersection(first, second);
        let (n, m) = (normal(first), normal(second));
        let spans = (2..corners.len()).any(|i| {
            let area = cross(&minus(&corners[1], &corners[0]), &minus(&corners[i], &corners[0]));
            area.iter().any(|x| *x != Rational::ZERO)
        });
        if spans {
            let same = dot(&n, &m) > Rational::ZERO;
            return Some(if same { Meeting::Overlap } else { Meeting::OverlapReversed });
        }
        let shared: Vec<&Point> = first.iter().filter(|p| second.contains(p)).collect();
        let legal = match shared[..] {
            [] => corners.is_empty(),
            [a] => corners.iter().all(|p| p == a),
            _ => true,
        };
        if legal {
            return None;
        }
        // A segment whose middle is inside of both crosses.
        let strictly_inside = |p: &Point, t: &[Point; 3], n: &Point| {
            (0..3).all(|i| {
                let inner = cross(n, &minus(&t[(i + 1) % 3], &t[i]));
                dot(&minus(p, &t[i]), &inner) > Rational::ZERO
            })
        };
        let far = corners.iter().skip(1).last();
        let half = Rational::from(2).inverse().unwrap();
        let middle = far.map(|far| [0, 1, 2].map(|i| &(&corners[0][i] + &far[i]) * &half));
        let crosses =
            middle.is_some_and(|p| strictly_inside(&p, first, &n) && strictly_inside(&p, second, &m));
        Some(if crosses { Meeting::Cross } else { Meeting::Touch })
    }

    fn corner() -> impl Strategy<Value = [i32; 3]> {
        prop::array::uniform3(-2i32..3)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        #[test]
        fn triangles_meet_as_fractions_say(corners in prop::array::uniform6(corner())) {
            let flat: Vec<f64> = corners.iter().flatten().map(|&x| f64::from(x)).collect();
            let positions = Positions::from_flat(3, flat).unwrap();
            let place: Vec<u32> = (0..6)
                .map(|i| (0..6).find(|&j| corners[j] == corners[i]).unwrap_or(i) as u32)
                .collect();
            let points = Points {
                predicates: GivenPoints::new(&positions).unwrap(),
                coordinates: positions.as_flat(),
                place: place.clone(),
                flatness: None,
            };
            let exact = corners.map(|p| p.map(|x| Rational::from(i64::from(x))));
            let [first, second] = [[0, 1, 2], [3, 4, 5]].map(|t: [usize; 3]| t.map(|i| exact[i].clone()));
            let has_area = |t: &[Point; 3]| {
                cross(&minus(&t[1], &t[0]), &minus(&t[2], &t[0])).iter().any(|x| *x != Rational::ZERO)
            };
            prop_assume!(has_area(&first) && has_area(&second));
            let triangles = Triangles {
                corners: vec![[place[0], place[1], place[2]], [place[3], place[4], place[5]]],
                face: vec![0, 1],
                sides: vec![7, 7],
            };
            let pairs = TrianglePairs::new(&points, &triangles);
            let found = pairs.meeting(0, 1, true);
            prop_assert_eq!(found, expected(&first, &second));
            prop_assert_eq!(pairs.meeting(1, 0, true), found);
            prop_assert_eq!(pairs.meeting(0, 1, false), found.filter(|&found| found != Meeting::Touch));
        }
    }
}
