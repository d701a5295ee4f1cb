//! Planar arrangements against a second method in fractions, known counts and real drawings.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use crate::reference::{Point, drawing, exactly, number, quotient};
use coface_algebra::{EdgeId, FaceId, HalfedgeId, VertexId};
use coface_algebra::{Rational, UnionFind};
use coface_arrange::planar::{PlanarArrangement, VertexSource};
use coface_geometry::Positions;
use coface_geometry::predicates::orientation;
use proptest::prelude::*;

type Segment = [f64; 4];

fn arranged(segments: &[Segment]) -> PlanarArrangement {
    let positions = Positions::from_flat(2, segments.as_flattened().to_vec()).unwrap();
    let ends: Vec<[u32; 2]> = (0..segments.len() as u32).map(|s| [2 * s, 2 * s + 1]).collect();
    let arrangement = PlanarArrangement::new(&positions, &ends).unwrap();
    check(&arrangement);
    arrangement
}

fn ring(points: &[[f64; 2]]) -> Vec<Segment> {
    (0..points.len())
        .map(|i| [points[i], points[(i + 1) % points.len()]])
        .map(|[p, q]| [p[0], p[1], q[0], q[1]])
        .collect()
}

fn rectangle(x: f64, y: f64, width: f64, height: f64) -> Vec<Segment> {
    ring(&[[x, y], [x + width, y], [x + width, y + height], [x, y + height]])
}

/// Everything that holds for every arrangement.
fn check(arrangement: &PlanarArrangement) {
    let (v, e, f) = (arrangement.vertex_count(), arrangement.edge_count(), arrangement.face_count());
    assert_eq!(v + f, e + arrangement.component_count(), "Euler's relation");
    let complex = arrangement.coarse_complex().unwrap();
    assert_eq!(complex.f_vector(), [v, e, f]);
    // Two sides of each edge: the boundaries of all faces add up to zero.
    let mut sum = vec![0; e];
    let faces = complex.boundary_matrix(2).unwrap();
    for face in 0..f {
        faces.column(face).iter().for_each(|(edge, sign)| sum[edge] += sign);
    }
    for (edge, sign) in arrangement.unbounded_boundary() {
        sum[edge.index()] += sign;
    }
    assert!(sum.iter().all(|&sign| sign == 0));
    let mut sides = vec![0; 2 * e];
    for face in (0..f).map(|face| Some(FaceId::new(face))).chain([None]) {
        for walk in arrangement.walks(face) {
            for (i, &h) in walk.iter().enumerate() {
                sides[h as usize] += 1;
                assert_eq!(arrangement.face_of(HalfedgeId::from_u32(h)), face);
                assert_eq!(arrangement.next(HalfedgeId::from_u32(h)).to_u32(), walk[(i + 1) % walk.len()]);
            }
        }
    }
    assert!(sides.iter().all(|&count| count == 1), "each edge has two sides");
    for vertex in 1..v {
        let [p, q] = [vertex - 1, vertex].map(|v| arrangement.point(VertexId::new(v)));
        assert!(p.compare(&q).is_lt(), "vertices are in order");
    }
    for vertex in (0..v).map(VertexId::new) {
        if let VertexSource::Given(point) = arrangement.source(vertex) {
            assert_eq!(arrangement.vertex_of_point(point), Some(vertex));
        }
    }
    let areas = arrangement.areas();
    // Below 1e-140 areas may be too small for a number.
    let is_tiny = arrangement.positions().as_flat().iter().all(|x| x.abs() < 1e-140);
    assert!(areas.iter().all(|&area| area > 0.0 || is_tiny));
    let covered = arrangement.covered_area();
    assert!((areas.iter().sum::<f64>() - covered).abs() <= 1e-12 * covered);
    for edge in 0..e {
        for &segment in arrangement.segments_of_edges().list(edge) {
            assert!(arrangement.edges_of_segment(segment as usize).any(|found| found == EdgeId::new(edge)));
        }
    }
}

/// Everything with fractions and sets: vertices, edges, areas of bounded faces (rising) with their numbers of holes.
fn brute_force(segments: &[Segment]) -> (usize, usize, Vec<(Rational, usize)>) {
    let segments: Vec<[Point; 2]> =
        segments.iter().map(|&[a, b, c, d]| [[exactly(a), exactly(b)], [exactly(c), exactly(d)]]).collect();
    let (points, edges) = drawing::cut(&segments);
    let faces = drawing::bounded_faces(&points, &edges);
    let mut faces: Vec<(Rational, usize)> =
        faces.iter().map(|face| (quotient(&face.doubled, &number(2)), face.walks.len() - 1)).collect();
    faces.sort();
    (points.len(), edges.len(), faces)
}

fn exact_faces(arrangement: &PlanarArrangement) -> Vec<(Rational, usize)> {
    let face = |face| {
        let face = Some(FaceId::new(face));
        (arrangement.exact_area(face), arrangement.walks(face).len() - 1)
    };
    let mut faces: Vec<_> = (0..arrangement.face_count()).map(face).collect();
    faces.sort();
    faces
}

/// Segments between small integers: many cross, touch and overlap. Of different numbers, so that some have several components.
fn soups() -> impl Strategy<Value = Vec<Segment>> {
    let far = prop::array::uniform4((-5i32..6).prop_map(f64::from));
    let near = prop::array::uniform4(0i32..3).prop_flat_map(|[a, b, c, d]| {
        (-6i32..6, -6i32..6).prop_map(move |(x, y)| [a + x, b + y, c + x, d + y].map(f64::from))
    });
    let square = (-6i32..6, -6i32..6, 1i32..5).prop_map(|(x, y, side)| {
        let [x, y, side] = [x, y, side].map(f64::from);
        rectangle(x, y, side, side)
    });
    let parts = prop_oneof![
        prop::collection::vec(far, 0..12).prop_map(|found| vec![found]),
        prop::collection::vec(near, 0..30).prop_map(|found| vec![found]),
        prop::collection::vec(square, 0..7),
    ];
    prop::collection::vec(parts, 1..3).prop_map(|parts| parts.concat().concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn arrangements_are_those_of_fractions(soup in soups()) {
        let arrangement = arranged(&soup);
        let (vertices, edges, faces) = brute_force(&soup);
        prop_assert_eq!(arrangement.f_vector(), [vertices, edges, faces.len()]);
        prop_assert_eq!(&exact_faces(&arrangement), &faces);
        let pruned = arrangement.pruned().unwrap();
        check(&pruned);
        let faces_without_bridges: Vec<Rational> = exact_faces(&pruned).into_iter().map(|(area, _)| area).collect();
        prop_assert!(faces_without_bridges.iter().eq(faces.iter().map(|(area, _)| area)));
        prop_assert!((0..pruned.edge_count()).all(|edge| !pruned.is_bridge(EdgeId::new(edge))));
        for (face, area) in arrangement.areas().into_iter().enumerate() {
            let exact = arrangement.exact_area(Some(FaceId::new(face))).to_f64();
            prop_assert!((area - exact).abs() <= exact * 2f64.powi(-49));
        }
    }

    /// Order, direction, exact motions and doubling of segments change nothing.
    #[test]
    fn motions_change_nothing(soup in soups(), seed: u64, shift in 0u32..20) {
        let here = arranged(&soup);
        let offset = 2f64.powi(shift as i32);
        let mut moved: Vec<Segment> = soup.iter().map(|s| [s[1] + offset, s[0], s[3] + offset, s[2]]).collect();
        for i in (1..moved.len()).rev() {
            moved.swap(i, (seed.rotate_left(i as u32) % (i as u64 + 1)) as usize);
            if seed.rotate_right(i as u32) % 2 == 1 {
                let [a, b, c, d] = moved[i];
                moved.push([c, d, a, b]);
            }
        }
        let there = arranged(&moved);
        prop_assert_eq!(here.f_vector(), there.f_vector());
        prop_assert_eq!(exact_faces(&here), exact_faces(&there));
        prop_assert_eq!(here.hole_count(), there.hole_count());
    }
}

#[test]
fn arranging_again_changes_nothing_where_crossings_are_exact() {
    // Directions along the axes and diagonals cross in halves.
    let mut state = 5u64;
    let mut random = |below: u64| {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (state >> 33) % below
    };
    for _ in 0..30 {
        let soup: Vec<Segment> = (0..40)
            .map(|_| {
                let [x, y, length] = [random(30), random(30), random(15)].map(|x| x as f64);
                let [dx, dy] = [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [-1.0, 1.0]][random(4) as usize];
                [x, y, x + dx * length, y + dy * length]
            })
            .collect();
        let first = arranged(&soup);
        let edges: Vec<[u32; 2]> =
            (0..first.edge_count()).map(|e| first.ends(EdgeId::new(e)).map(VertexId::to_u32)).collect();
        let second = PlanarArrangement::new(first.positions(), &edges).unwrap();
        assert_eq!(first.positions(), second.positions());
        assert_eq!(first.f_vector(), second.f_vector());
        assert_eq!(first.coarse_complex().unwrap(), second.coarse_complex().unwrap());
        assert_eq!(first.areas(), second.areas());
    }
}

#[test]
fn small_drawings_have_their_known_counts() {
    let counts = |segments: &[Segment]| arranged(segments).f_vector();
    assert_eq!(counts(&[]), [0, 0, 0]);
    assert_eq!(counts(&[[1., 2., 5., 2.], [2., 2., 4., 2.]]), [4, 3, 0]);
    let grid: Vec<Segment> = (0..4)
        .flat_map(|i| (0..3).map(move |j| [i, j].map(f64::from)))
        .flat_map(|[i, j]| [[i, j, i, j + 1.], [j, i, j + 1., i]])
        .collect();
    let arrangement = arranged(&grid);
    assert_eq!(arrangement.f_vector(), [16, 24, 9]);
    let complex = arrangement.coarse_complex().unwrap();
    assert_eq!(complex.boundary_matrix(2).unwrap().entry_count(), 36);
    assert_eq!(complex.boundary_matrix(1).unwrap().entry_count(), 48);

    let nested =
        [rectangle(0., 0., 4., 4.), rectangle(1., 1., 2., 2.), rectangle(1.5, 1.5, 0.5, 0.5)].concat();
    let arrangement = arranged(&nested);
    assert_eq!(arrangement.f_vector(), [12, 12, 3]);
    assert_eq!(arrangement.areas(), [12., 3.75, 0.25]);
    assert_eq!(arrangement.coarse_complex().unwrap().boundary_matrix(2).unwrap().column(0).rows().len(), 8);
    assert_eq!(arrangement.hole_count(), 2);

    assert_eq!(counts(&[rectangle(0., 0., 1., 1.), rectangle(1., 1., 1., 1.)].concat()), [7, 8, 2]);
    let square = rectangle(0., 0., 1., 1.);
    let dangling = arranged(&[square, vec![[1., 1., 2., 2.], [0.5, 0.5, 0.25, 0.5]]].concat());
    assert_eq!(dangling.f_vector(), [7, 6, 1]);
    assert_eq!((0..6).filter(|&e| dangling.is_bridge(EdgeId::new(e))).count(), 2);
    let bridged = [rectangle(0., 0., 4., 4.), rectangle(1., 1., 2., 2.), vec![[0., 0., 1., 1.]]].concat();
    let bridged = arranged(&bridged);
    assert_eq!(bridged.f_vector(), [8, 9, 2]);
    assert_eq!(bridged.coarse_complex().unwrap().boundary_matrix(2).unwrap().column(0).rows().len(), 8);
    let pruned = bridged.pruned().unwrap();
    check(&pruned);
    assert_eq!((pruned.f_vector(), pruned.hole_count()), (vec![8, 8, 2], 1));
    assert_eq!(bridged.walks(Some(FaceId::new(0))).map(<[u32]>::len).collect::<Vec<_>>(), [10]);
    assert_eq!(counts(&[rectangle(0., 0., 2., 1.), rectangle(1., 0., 2., 1.)].concat()), [8, 10, 3]);
    assert_eq!(counts(&[rectangle(0., 0., 1e6, 1e6), rectangle(5e5, 5e5, 1e6, 1e6)].concat()), [10, 12, 3]);
    let corner = arranged(&[rectangle(0., 0., 4., 4.), ring(&[[0., 0.], [1., 2.], [2., 1.]])].concat());
    assert_eq!(corner.f_vector(), [6, 7, 2]);
    let mut areas = corner.areas();
    areas.sort_by(f64::total_cmp);
    assert_eq!(areas, [1.5, 14.5]);
    for side in [1e-5, 1e-3, 1e-160, 1e150, 1e-300] {
        assert_eq!(counts(&rectangle(0., 0., side, side)), [4, 4, 1]);
    }
    let components = [
        ring(&[[0., 0.], [4., 0.], [4., 2.], [2., 4.], [0., 4.]]),
        rectangle(0.5, 0.5, 2., 2.),
        ring(&[[1., 1.], [1.5, 1.], [1., 2.]]),
        ring(&[[2., 2.], [2., 1.], [1.5, 2.]]),
        ring(&[[3.9, 3.9], [3.4, 3.9], [3.9, 3.4]]),
    ];
    let arrangement = arranged(&components.concat());
    assert_eq!(arrangement.f_vector(), [18, 18, 5]);
    let mut areas = arrangement.areas();
    areas.sort_by(f64::total_cmp);
    let expected = [0.125, 0.25, 0.25, 3.5, 10.];
    assert!(areas.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{areas:?}");
    assert_eq!(arrangement.hole_count(), 3);
}

#[test]
fn noisy_copies_stay_apart() {
    // Sides that are a billionth apart cross each other: no tolerance makes them one.
    let mut state = 3u64;
    let mut noise = || {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        ((state >> 11) as f64 / (1u64 << 53) as f64 - 0.5) * 1e-12
    };
    let soup: Vec<Segment> =
        (0..4).flat_map(|_| rectangle(0., 0., 1., 1.)).map(|side| side.map(|x| x + noise())).collect();
    let arrangement = arranged(&soup);
    assert!(arrangement.vertex_count() > 32 && arrangement.face_count() > 1);
}

#[test]
fn isolated_points_and_points_on_edges_are_vertices() {
    let points = Positions::from_flat(
        2,
        vec![0., 0., 4., 0., 4., 4., 0., 4., 2., 0., 1., 1., -0.0, 0., 9., 9., 1., 1.],
    )
    .unwrap();
    let segments = [[0, 1], [1, 2], [2, 3], [3, 6], [5, 8], [7, 7]];
    let arrangement = PlanarArrangement::new(&points, &segments).unwrap();
    check(&arrangement);
    // (2, 0) cuts a side; (1, 1) and (9, 9) are on their own; both zeros are one.
    assert_eq!(arrangement.f_vector(), [7, 5, 1]);
    assert_eq!(arrangement.vertex_of_point(0), arrangement.vertex_of_point(6));
    assert_eq!((arrangement.component_count(), arrangement.hole_count()), (3, 0));
    let component = |point| arrangement.component(arrangement.vertex_of_point(point).unwrap());
    assert_eq!(arrangement.face_around_component(component(5)), Some(FaceId::new(0)));
    assert_eq!(arrangement.face_around_component(component(7)), None);
    assert_eq!(arrangement.edges_of_segment(4).count(), 0);
    assert_eq!(arrangement.edges_of_segment(0).count(), 2);
    assert!(PlanarArrangement::new(&points, &[[0, 9]]).is_err());
    let space = Positions::from_flat(3, vec![0.0; 6]).unwrap();
    assert!(PlanarArrangement::new(&space, &[[0, 1]]).is_err());
}

/// Segments from uniform points in the unit square in uniform directions.
fn random_segments(count: usize, length: f64, seed: u64) -> Vec<Segment> {
    let mut state = seed;
    let mut random = || {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..count)
        .map(|_| {
            let [x, y, turn] = [random(), random(), random()];
            let angle = std::f64::consts::PI * turn;
            [x, y, x + length * angle.cos(), y + length * angle.sin()]
        })
        .collect()
}

#[test]
fn random_segments_have_their_known_counts() {
    for (count, crossings, faces) in [
        (25, 14, 1),
        (50, 66, 26),
        (100, 349, 253),
        (200, 1334, 1136),
        (400, 5536, 5139),
        (800, 22270, 21471),
    ] {
        let arrangement = arranged(&random_segments(count, 0.4, 42));
        assert_eq!(arrangement.f_vector(), [2 * count + crossings, count + 2 * crossings, faces]);
    }
}

/// Crossings are those of all pairs, decided one by one; components are those of segments that cross; faces follow by Euler's formula.
#[test]
fn short_segments_have_the_crossings_of_all_pairs_and_the_faces_of_euler() {
    for count in [300, 1500] {
        let soup = random_segments(count, 0.1, 42);
        let ends = |s: usize| [[soup[s][0], soup[s][1]], [soup[s][2], soup[s][3]]];
        let parts = |s: usize, t: usize| {
            let ([a, b], [c, d]) = (ends(s), ends(t));
            let [left, right] = [c, d].map(|point| orientation(a, b, point));
            assert!(left.is_ne() && right.is_ne(), "no point is on another segment");
            left != right
        };
        let (mut crossings, mut together) = (0, UnionFind::new(count));
        for s in 0..count {
            let [a, _] = ends(s);
            for t in (0..s).filter(|&t| (ends(t)[0][0] - a[0]).abs().max((ends(t)[0][1] - a[1]).abs()) < 0.3)
            {
                if parts(s, t) && parts(t, s) {
                    crossings += 1;
                    together.unite(s as u32, t as u32);
                }
            }
        }
        let arrangement = arranged(&soup);
        let [vertices, edges] = [2 * count + crossings, count + 2 * crossings];
        assert_eq!(arrangement.component_count(), together.class_count());
        assert_eq!(arrangement.f_vector(), [vertices, edges, together.class_count() + edges - vertices]);
    }
}

#[test]
fn results_do_not_depend_on_threads() {
    let soup = random_segments(300, 0.4, 7);
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap().install(|| arranged(&soup));
    let four = rayon::ThreadPoolBuilder::new().num_threads(4).build().unwrap().install(|| arranged(&soup));
    assert_eq!(format!("{one:?}"), format!("{four:?}"));
}

#[test]
fn many_segments_through_one_point_make_one_vertex() {
    // Lines through (1/3, 1/3), which is no binary fraction; coordinates are such that it is exactly on all of them.
    let star: Vec<Segment> = (0..60).map(f64::from).map(|i| [0., i - 30., 1., 61. - 2. * i]).collect();
    let arrangement = arranged(&star);
    // All cross x = 1/3 at the same height: (i - 30) 2/3 + (61 - 2 i) / 3 = 1/3.
    assert_eq!(arrangement.f_vector(), [121, 120, 0]);
}

#[test]
fn sizes_far_apart_are_ordinary() {
    let mut soup = rectangle(-1e6, -1e6, 2e6, 2e6);
    for i in 0..40 {
        for j in 0..40 {
            soup.extend(rectangle(f64::from(i) * 1e-6, f64::from(j) * 1e-6, 0.7e-6, 0.7e-6));
        }
    }
    soup.push([-1e6, -1e6, 1e6, 1e6]);
    let arrangement = arranged(&soup);
    assert_eq!(arrangement.component_count(), 1 + 1600 - 40);
    assert_eq!(arrangement.hole_count(), 1600 - 40);
    let huge =
        [rectangle(-1e300, -1e300, 2e300, 2e300), rectangle(-1e-300, -1e-300, 2e-300, 2e-300)].concat();
    let [big, small] = [rectangle(0., 0., 1e308, 1e308), rectangle(-1e308, -1e308, 1.5e308, 1.5e308)];
    let positions = |soup: &[Segment]| Positions::from_flat(2, soup.as_flattened().to_vec()).unwrap();
    let ends: Vec<[u32; 2]> = (0..8).map(|s| [2 * s, 2 * s + 1]).collect();
    let arrangement = PlanarArrangement::new(&positions(&huge), &ends).unwrap();
    assert_eq!((arrangement.f_vector(), arrangement.hole_count()), (vec![8, 8, 2], 1));
    let arrangement = PlanarArrangement::new(&positions(&[big, small].concat()), &ends).unwrap();
    assert_eq!(arrangement.f_vector(), [10, 12, 3]);
}

#[test]
fn rounded_crossings_are_on_the_right_side_or_on_the_line() {
    // A sanity check of the meaning of rounding: a crossing is within a unit of both its lines.
    let soup = random_segments(60, 0.8, 1);
    let arrangement = arranged(&soup);
    for vertex in (0..arrangement.vertex_count()).map(VertexId::new) {
        if let VertexSource::Crossing([s, t]) = arrangement.source(vertex) {
            let [x, y] = arrangement.point(vertex).rounded();
            for [a, b, c, d] in [soup[s], soup[t]] {
                let corners = [[-1., -1.], [1., -1.], [-1., 1.], [1., 1.]];
                let sides = corners.map(|[i, j]| {
                    let [dx, dy] = [i * x.abs() * 2f64.powi(-52), j * y.abs() * 2f64.powi(-52)];
                    orientation([a, b], [c, d], [x + dx, y + dy])
                });
                assert!(sides.iter().any(|side| side.is_le()) && sides.iter().any(|side| side.is_ge()));
            }
        }
    }
}

/// Segments of a text file of `x1,y1,x2,y2` lines in the data folder.
fn lines_file(name: &str) -> Option<Vec<Segment>> {
    let Some(folder) = std::env::var_os("COFACE_DATA") else {
        println!("COFACE_DATA is not set: {name} is skipped");
        return None;
    };
    let text = std::fs::read_to_string(std::path::Path::new(&folder).join("planar").join(name)).unwrap();
    let numbers = text.lines().map(|line| {
        let numbers: Vec<f64> = line.split(',').map(|x| x.trim().parse().unwrap()).collect();
        <[f64; 4]>::try_from(numbers).unwrap()
    });
    Some(numbers.collect())
}

#[test]
fn drawings_have_their_known_counts() {
    for (name, expected) in [
        ("test1.lines", [32, 48, 17]),
        ("test2.lines", [39, 61, 23]),
        ("test3.lines", [12, 16, 5]),
        ("test4.lines", [16, 20, 6]),
    ] {
        if let Some(soup) = lines_file(name) {
            assert_eq!(arranged(&soup).f_vector(), expected, "{name}");
        }
    }
}
