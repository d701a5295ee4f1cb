//! Triangulations against their definition, and refusals against all pairs of sides.

use super::{TriangulationFault, flip_to_delaunay, triangulate, triangulate_sides};
use crate::predicates::orientation;
use proptest::prelude::*;
use std::cmp::Ordering;
use std::collections::BTreeMap;

type Sides = Vec<[u32; 2]>;

fn run(points: &[[i64; 2]], sides: &[[u32; 2]]) -> Result<Vec<[u32; 3]>, TriangulationFault> {
    let at = |v: u32| points[v as usize];
    triangulate_sides(sides, |a, b| at(a).cmp(&at(b)), |a, b, c| turn(at(a), at(b), at(c)))
}

fn turn(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> Ordering {
    twice_area(a, b, c).cmp(&0)
}

fn twice_area(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Twice the area that sides have to their left.
fn twice_enclosed(points: &[[i64; 2]], sides: &[[u32; 2]]) -> i64 {
    sides.iter().map(|side| side.map(|v| points[v as usize])).map(|[a, b]| twice_area([0, 0], a, b)).sum()
}

/// Each side of the polygon is one of a triangle, all others are there in both directions, and no triangle is flat.
fn check(points: &[[i64; 2]], sides: &[[u32; 2]], triangles: &[[u32; 3]]) -> Result<(), TestCaseError> {
    let mut count: BTreeMap<[u32; 2], i32> = BTreeMap::new();
    for &[a, b, c] in triangles {
        prop_assert!(turn(points[a as usize], points[b as usize], points[c as usize]).is_gt());
        for side in [[a, b], [b, c], [c, a]] {
            let here = count.entry(side).or_default();
            *here += 1;
            prop_assert_eq!(*here, 1);
        }
    }
    for side in sides {
        prop_assert_eq!(count.remove(side), Some(1), "{:?}", side);
    }
    for &[a, b] in count.keys() {
        prop_assert!(count.contains_key(&[b, a]), "{} {}", a, b);
    }
    let area = |own: &[u32; 3]| {
        let [a, b, c] = own.map(|v| points[v as usize]);
        twice_area(a, b, c)
    };
    prop_assert_eq!(triangles.iter().map(area).sum::<i64>(), twice_enclosed(points, sides));
    Ok(())
}

/// The sides of a union of cells of a grid, and of slits between cells of it.
fn sides_of_cells(width: usize, cells: &[bool], slits: &[bool]) -> (Vec<[i64; 2]>, Sides) {
    let height = cells.len() / width;
    let vertex = |x: usize, y: usize| (y * (width + 1) + x) as u32;
    let has = |x: usize, y: usize| x < width && y < height && cells[y * width + x];
    let mut sides = Vec::new();
    let mut add = |a: u32, b: u32, left: bool, right: bool| {
        let is_slit = left && right && slits[(a as usize * 7 + b as usize) % slits.len()];
        if left && (!right || is_slit) {
            sides.push([a, b]);
        }
        if right && (!left || is_slit) {
            sides.push([b, a]);
        }
    };
    for y in 0..=height {
        for x in 0..=width {
            if x < width {
                add(vertex(x, y), vertex(x + 1, y), has(x, y), y > 0 && has(x, y - 1));
            }
            if y < height {
                add(vertex(x, y), vertex(x, y + 1), x > 0 && has(x - 1, y), has(x, y));
            }
        }
    }
    let points = (0..=height).flat_map(|y| (0..=width).map(move |x| [x as i64, y as i64])).collect();
    (points, sides)
}

/// Whether two sides meet elsewhere than in common ends.
fn cross(points: &[[i64; 2]], s: [u32; 2], t: [u32; 2]) -> bool {
    let at = |v: u32| points[v as usize];
    let between = |v: u32, [a, b]: [u32; 2]| {
        turn(at(a), at(b), at(v)).is_eq() && {
            let (low, high) = (at(a).min(at(b)), at(a).max(at(b)));
            low < at(v) && at(v) < high
        }
    };
    if s.iter().any(|&v| between(v, t)) || t.iter().any(|&v| between(v, s)) {
        return true;
    }
    let apart = |[a, b]: [u32; 2], [c, d]: [u32; 2]| {
        let (x, y) = (turn(at(a), at(b), at(c)), turn(at(a), at(b), at(d)));
        x != y && x.is_ne() && y.is_ne()
    };
    apart(s, t) && apart(t, s)
}

/// Whether the last point is inside the circle through the first three, which run counterclockwise.
fn is_inside_circle(corners: [[i64; 2]; 3], last: [i64; 2]) -> bool {
    let [a, b, c] = corners.map(|corner| {
        let way = [corner[0] - last[0], corner[1] - last[1]];
        [way[0], way[1], way[0] * way[0] + way[1] * way[1]]
    });
    let minor = |x: [i64; 3], y: [i64; 3]| x[0] * y[1] - x[1] * y[0];
    minor(a, b) * c[2] + minor(b, c) * a[2] + minor(c, a) * b[2] > 0
}

/// No side between two triangles has the fourth corner of both in the circle of one, unless it is one of the polygon.
fn check_delaunay(
    points: &[[i64; 2]],
    sides: &[[u32; 2]],
    triangles: &[[u32; 3]],
) -> Result<(), TestCaseError> {
    let mut opposite: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    for &[a, b, c] in triangles {
        opposite.extend([([a, b], c), ([b, c], a), ([c, a], b)]);
    }
    for (&[a, b], &c) in &opposite {
        let Some(&d) = opposite.get(&[b, a]).filter(|_| !sides.contains(&[a, b])) else { continue };
        let corners = [a, b, c].map(|v| points[v as usize]);
        prop_assert!(!is_inside_circle(corners, points[d as usize]), "{:?}", [a, b, c, d]);
    }
    Ok(())
}

fn flipped(points: &[[i64; 2]], sides: &[[u32; 2]], mut triangles: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
    let at = |v: u32| points[v as usize];
    let point = |v: u32| [at(v)[0] as f64, at(v)[1] as f64, 7.0];
    flip_to_delaunay(&mut triangles, sides, point, |a, b, c| turn(at(a), at(b), at(c)));
    triangles
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn unions_of_cells_with_slits(
        width in 1..7usize,
        bits in prop::collection::vec(prop::bool::weighted(0.7), 1..42),
        slits in prop::collection::vec(prop::bool::weighted(0.3), 1..50),
        motion in prop::sample::select(vec![[1, 0, 0, 1], [0, -1, 1, 0], [2, 1, 1, 1], [1, -1, 1, 1], [-3, 2, 1, -1]]),
    ) {
        let cells = &bits[..bits.len() / width * width];
        let (points, sides) = sides_of_cells(width, cells, &slits);
        // Motions that keep the sense of rotation.
        let [a, b, c, d] = motion;
        let points: Vec<[i64; 2]> = points.iter().map(|&[x, y]| [a * x + b * y, c * x + d * y]).collect();
        let triangles = run(&points, &sides).map_err(|fault| TestCaseError::fail(fault.to_string()))?;
        check(&points, &sides, &triangles)?;
        let triangles = flipped(&points, &sides, triangles);
        check(&points, &sides, &triangles)?;
        check_delaunay(&points, &sides, &triangles)?;
        let inside = cells.iter().filter(|cell| **cell).count() as i64;
        prop_assert_eq!(twice_enclosed(&points, &sides), 2 * inside * (a * d - b * c));
    }

    #[test]
    fn what_is_no_polygon_is_refused(
        flat in prop::collection::vec((0..5i64, 0..5i64), 3..8),
    ) {
        let mut points: Vec<[i64; 2]> = flat.into_iter().map(|(x, y)| [x, y]).collect();
        points.dedup();
        let mut sorted = points.clone();
        sorted.sort_unstable();
        sorted.dedup();
        prop_assume!(points.len() > 2 && sorted.len() == points.len());
        let count = points.len() as u32;
        let sides: Sides = (0..count).map(|i| [i, (i + 1) % count]).collect();
        let crossing = sides.iter().enumerate()
            .any(|(i, &s)| sides[i + 1..].iter().any(|&t| cross(&points, s, t)));
        let result = run(&points, &sides);
        let is_polygon = !crossing && twice_enclosed(&points, &sides) > 0;
        prop_assert_eq!(result.is_ok(), is_polygon, "{:?}", &result);
        match result {
            Ok(triangles) => {
                prop_assert_eq!(triangles.len(), points.len() - 2);
                check(&points, &sides, &triangles)?;
            }
            Err(TriangulationFault::Crossing([s, t])) => prop_assert!(cross(&points, s, t)),
            Err(TriangulationFault::OnSide { vertex, side }) => {
                prop_assert!(cross(&points, [vertex, vertex], side));
            }
            Err(fault) => prop_assert!(matches!(fault, TriangulationFault::WrongWay(_)) && !crossing),
        }
    }

    /// Turns within a tolerance are no total order: a fault may come of them, but no panic and no end without end.
    #[test]
    fn coarse_turns_break_nothing(
        points in prop::collection::vec(prop::array::uniform2(0i64..40), 3..90),
        lists in prop::collection::vec(prop::collection::vec(any::<prop::sample::Index>(), 3..20), 1..5),
        coarse in 0i64..300,
        salt: u64,
    ) {
        let at = |v: u32| (points[v as usize], v);
        let mut sides: Sides = Vec::new();
        // Fans around the first point, which have many sides at one vertex, beside closed walks.
        sides.extend((1..points.len() as u32 - 1).flat_map(|v| [[0, v], [v, v + 1], [v + 1, 0]]));
        for list in &lists {
            let walk: Vec<u32> = list.iter().map(|index| index.index(points.len()) as u32).collect();
            sides.extend((0..walk.len()).map(|i| [walk[i], walk[(i + 1) % walk.len()]]));
        }
        sides.retain(|[a, b]| a != b);
        sides.sort_unstable();
        sides.dedup();
        let rough = |a: u32, b: u32, c: u32| match twice_area(at(a).0, at(b).0, at(c).0) {
            small if small.abs() <= coarse => Ordering::Equal,
            area => area.cmp(&0),
        };
        let none = |a: u32, b: u32, c: u32| {
            let mixed = [a, b, c].iter().fold(salt, |own, &v| (own ^ u64::from(v)).wrapping_mul(0x9E37_79B9_7F4A_7C15));
            (mixed >> 60).cmp(&8)
        };
        let _ = triangulate_sides(&sides, |a, b| at(a).cmp(&at(b)), rough);
        let _ = triangulate_sides(&sides, |a, b| at(a).cmp(&at(b)), none);
    }

    #[test]
    fn stars_with_a_hole(radii in prop::collection::vec(8..1000i64, 3..200)) {
        // The directions of a square, in order; the hole is the same at an eighth of the size, the other way around.
        let (radii, count) = (&radii, radii.len());
        let direction = |i: usize| {
            let t = 800 * i as i64 / count as i64;
            match t / 200 {
                0 => [100, t - 100],
                1 => [300 - t, 100],
                2 => [-100, 500 - t],
                _ => [t - 700, -100],
            }
        };
        let star = |part: i64| (0..count).map(move |i| direction(i).map(|x| x * (radii[i] / part).max(1)));
        let points: Vec<[i64; 2]> = star(1).chain(star(8)).collect();
        let n = count as u32;
        let outer = (0..n).map(|i| [i, (i + 1) % n]);
        let sides: Sides = outer.chain((0..n).map(|i| [n + (i + 1) % n, n + i])).collect();
        let crossing = sides.iter().enumerate()
            .any(|(i, &s)| sides[i + 1..].iter().any(|&t| cross(&points, s, t)));
        prop_assume!(!crossing);
        let triangles = run(&points, &sides).map_err(|fault| TestCaseError::fail(fault.to_string()))?;
        prop_assert_eq!(triangles.len(), 2 * count);
        check(&points, &sides, &triangles)?;
        // Circles through points that are so far apart may be the same within rounding.
        check(&points, &sides, &flipped(&points, &sides, triangles))?;
    }
}

#[test]
fn faults_are_named() {
    let points = [[0, 0], [4, 0], [4, 4], [0, 4], [2, 0], [0, 0]];
    let around =
        |walk: &[u32]| -> Sides { (0..walk.len()).map(|i| [walk[i], walk[(i + 1) % walk.len()]]).collect() };
    assert_eq!(run(&points, &around(&[3, 2, 1, 0])), Err(TriangulationFault::WrongWay(0)));
    assert!(run(&points, &around(&[0, 1, 2, 4])).is_err());
    assert_eq!(run(&points, &around(&[0, 1, 1, 2])), Err(TriangulationFault::NoLength(1)));
    assert_eq!(run(&points, &around(&[0, 1, 2, 5])), Err(TriangulationFault::SamePlace([0, 5])));
    assert_eq!(run(&points, &around(&[0, 1, 2, 0, 1, 3])), Err(TriangulationFault::RepeatedSide([0, 1])));
    // Without area: no inside anywhere.
    assert_eq!(run(&points, &[[0, 1], [1, 0]]), Err(TriangulationFault::WrongWay(0)));
    assert_eq!(run(&points, &[]), Ok(Vec::new()));
    let error = coface_algebra::Error::from(TriangulationFault::OnSide { vertex: 4, side: [0, 1] });
    assert_eq!(
        error.to_string(),
        "v4 lies on the side of v0 and v1; add the vertex to the walk that it lies on"
    );
}

#[test]
fn walks_may_be_of_thousands_of_vertices() {
    // A comb whose teeth begin and end one after the other, and a hole in each tooth.
    let teeth = 2000u32;
    let mut points: Vec<[f64; 2]> = vec![[-1.0, -1.0], [1e6, -1.0]];
    let mut outer = vec![0, 1];
    let mut walks = Vec::new();
    for i in (0..teeth).rev() {
        let x = f64::from(3 * i);
        let first = points.len() as u32;
        points.extend([[x + 2.0, 0.0], [x + 2.5, 9.0], [x, 9.0], [x + 0.5, 0.0]]);
        outer.extend(first..first + 4);
        points.extend([[x + 1.0, 2.0], [x + 1.5, 2.0], [x + 1.0, 3.0]]);
        walks.push(vec![first + 4, first + 6, first + 5]);
    }
    walks.push(outer);
    let at = |v: u32| points[v as usize];
    let triangles = triangulate(
        &walks,
        |a, b| at(a).partial_cmp(&at(b)).unwrap(),
        |a, b, c| orientation(at(a), at(b), at(c)),
    )
    .unwrap();
    assert_eq!(triangles.len() as u32, (2 + 7 * teeth) + 2 * teeth - 2);
}
