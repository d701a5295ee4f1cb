//! Drawings within a tolerance: cells do not depend on order, angle, place or noise, and nothing is near anything any
//! more.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_arrange::planar::{PlanarArrangement, SnappedArrangement};
use coface_geometry::Positions;
use proptest::prelude::*;

fn arranged(points: &[[f64; 2]], segments: &[[u32; 2]]) -> PlanarArrangement {
    let positions = Positions::from_flat(2, points.as_flattened().to_vec()).unwrap();
    PlanarArrangement::new(&positions, segments).unwrap()
}

/// Rooms of a brick wall: rows of rectangles, each row moved by half a brick, so that sides meet in the middle of others.
fn bricks(rows: u32, columns: u32, place: impl Fn([f64; 2]) -> [f64; 2]) -> (Vec<[f64; 2]>, Vec<[u32; 2]>) {
    let (mut points, mut segments) = (Vec::new(), Vec::new());
    for row in 0..rows {
        for column in 0..columns {
            let low = [f64::from(2 * column + row % 2), f64::from(row)];
            let first = points.len() as u32;
            points.extend(
                [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]]
                    .map(|[x, y]| place([low[0] + x, low[1] + y])),
            );
            segments.extend((0..4).map(|i| [first + i, first + (i + 1) % 4]));
        }
    }
    (points, segments)
}

fn turned(angle: f64, shift: [f64; 2]) -> impl Fn([f64; 2]) -> [f64; 2] {
    let (s, c) = angle.sin_cos();
    move |[x, y]| [c * x - s * y + shift[0], s * x + c * y + shift[1]]
}

/// The least distance of a vertex to another one, or to an edge that does not end in it.
fn least_distance(arrangement: &PlanarArrangement) -> f64 {
    let points = arrangement.positions().as_flat().as_chunks::<2>().0;
    let mut least = f64::INFINITY;
    for (v, &[x, y]) in points.iter().enumerate() {
        for &[ox, oy] in &points[..v] {
            least = least.min((x - ox).hypot(y - oy));
        }
        for edge in 0..arrangement.edge_count() {
            let ends = arrangement.ends(coface_algebra::EdgeId::new(edge)).map(|end| end.index());
            if ends.contains(&v) {
                continue;
            }
            let [[ax, ay], [bx, by]] = ends.map(|end| points[end]);
            let (dx, dy) = (bx - ax, by - ay);
            let part = (((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
            least = least.min((ax + part * dx - x).hypot(ay + part * dy - y));
        }
    }
    least
}

/// Vertices, edges and faces, and the vertices that points became with the lowest of them first.
fn combinatorics(points: &[[f64; 2]], segments: &[[u32; 2]], tolerance: f64) -> (Vec<usize>, Vec<usize>) {
    let exact = arranged(points, segments);
    let joined = exact.within(tolerance).unwrap();
    let mut numbers: Vec<usize> = Vec::new();
    let place = |point: usize| joined.place(exact.vertex_of_point(point).unwrap()).index();
    let classes = (0..points.len()).map(|point| {
        let own = place(point);
        numbers.iter().position(|&known| known == own).unwrap_or_else(|| {
            numbers.push(own);
            numbers.len() - 1
        })
    });
    let classes: Vec<usize> = classes.collect();
    (joined.arrangement().f_vector(), classes)
}

#[test]
fn rooms_have_a_face_each_at_any_angle_and_place() {
    let (points, segments) = bricks(4, 8, |point| point);
    let expected = combinatorics(&points, &segments, 1e-6);
    assert_eq!(expected.0[2], 32);
    for step in 0..200 {
        let angle = f64::from(step) * 0.0314159;
        for shift in [[0.0, 0.0], [448_262.1, 5_411_932.7]] {
            let (points, segments) = bricks(4, 8, turned(angle, shift));
            assert_eq!(combinatorics(&points, &segments, 1e-6), expected, "{angle} {shift:?}");
        }
    }
}

/// Three lines nearly in one point are one crossing, and the movements are those that are said.
#[test]
fn what_was_put_together_is_said() {
    let points = [
        [0.0, 0.0],
        [2.0, 2.0],
        [0.0, 2.0],
        [2.0, 0.0],
        [0.0, 1.001],
        [2.0, 1.001],
        [0.0005, 0.0],
        [-1.0, -1.0],
    ];
    let exact = arranged(&points, &[[0, 1], [2, 3], [4, 5], [6, 7]]);
    let joined = exact.within(0.01).unwrap();
    assert_eq!(joined.arrangement().f_vector(), [8, 7, 0]);
    let features = joined.joined().unwrap();
    let classes: Vec<&[u32]> = features.classes.iter().collect();
    assert_eq!(classes, [[0, 6]]);
    assert!(features.largest_movement <= 0.01 && features.largest_movement >= 0.0005);
    assert!(joined.arrangement().is_exactly_rounded());
    // Nothing near: nothing moves.
    let apart = arranged(&points[..4], &[[0, 1], [2, 3]]).within(1e-3).unwrap();
    assert_eq!(apart.joined().unwrap().moved, []);
    assert_eq!(apart.arrangement().f_vector(), [5, 4, 0]);
}

#[test]
fn tolerances_that_are_none_are_refused() {
    let cross = arranged(&[[0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0]], &[[0, 1], [2, 3]]);
    for tolerance in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(cross.within(tolerance).unwrap_err().to_string().contains("no tolerance"));
    }
    // As large as the drawing: all is one point.
    assert_eq!(cross.within(10.0).unwrap().arrangement().f_vector(), [1, 0, 0]);
}

/// What edges are pieces of: each segment of the input is a chain from what its start became to what its end became.
fn check_paths(
    exact: &PlanarArrangement,
    joined: &SnappedArrangement,
    segments: &[[u32; 2]],
) -> Result<(), TestCaseError> {
    let edges_of = joined.segments_of_edges().transposed(segments.len());
    let runs_up = joined.runs_up().unwrap();
    for (segment, ends) in segments.iter().enumerate() {
        let mut boundary = vec![0i32; joined.arrangement().vertex_count()];
        for &edge in edges_of.list(segment) {
            let along = joined.segments_of_edges();
            let own = along.list(edge as usize).iter().position(|&own| own as usize == segment).unwrap();
            let [low, high] =
                joined.arrangement().ends(coface_algebra::EdgeId::from_u32(edge)).map(|end| end.index());
            let [from, to] =
                if runs_up[along.start(edge as usize) + own] { [low, high] } else { [high, low] };
            boundary[from] -= 1;
            boundary[to] += 1;
        }
        let [from, to] = ends.map(|end| joined.place_of_point(end as usize).unwrap());
        prop_assert_eq!(
            ends.map(|end| joined.place(exact.vertex_of_point(end as usize).unwrap())),
            [from, to]
        );
        boundary[from.index()] += 1;
        boundary[to.index()] -= 1;
        prop_assert!(boundary.iter().all(|&count| count == 0), "segment {} {:?}", segment, boundary);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn nothing_is_near_anything_any_more(
        points in prop::collection::vec(prop::array::uniform2(0.0..1.0), 4..40),
        tolerance in 0.001..0.05
    ) {
        let segments: Vec<[u32; 2]> = (0..points.len() as u32 / 2).map(|i| [2 * i, 2 * i + 1]).collect();
        let exact = arranged(&points, &segments);
        let joined = exact.within(tolerance).unwrap();
        let features = joined.joined().unwrap();
        prop_assert!(features.tolerance >= tolerance);
        let least = least_distance(joined.arrangement());
        prop_assert!(least > tolerance * (1.0 - 1e-9), "{}", least);
        prop_assert!(joined.arrangement().is_exactly_rounded());
        check_paths(&exact, &joined, &segments)?;
        // The same of segments in another order and the other way.
        let other: Vec<[u32; 2]> = segments.iter().rev().map(|&[a, b]| [b, a]).collect();
        let again = arranged(&points, &other).within(tolerance).unwrap();
        prop_assert_eq!(again.arrangement().positions(), joined.arrangement().positions());
        prop_assert_eq!(again.arrangement().f_vector(), joined.arrangement().f_vector());
    }

    #[test]
    fn noise_of_a_quarter_changes_nothing(
        noise in prop::collection::vec(prop::array::uniform2(-1.0..1.0), 4 * 12),
        angle in 0.0..6.3,
        tolerance in 1e-6..0.05
    ) {
        let (points, segments) = bricks(3, 4, turned(angle, [0.0; 2]));
        let expected = combinatorics(&points, &segments, tolerance);
        prop_assert_eq!(expected.0[2], 12);
        let way = tolerance / 4.0 / f64::sqrt(2.0);
        let moved: Vec<[f64; 2]> =
            points.iter().zip(&noise).map(|(p, n)| [p[0] + way * n[0], p[1] + way * n[1]]).collect();
        prop_assert_eq!(combinatorics(&moved, &segments, tolerance), expected);
    }
}
