//! Arrangements of polygons in space against the tables of known counts and volumes, and against themselves.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface::algebra::{RaggedArray, Sign};
use coface::arrange::boolean::InsideRule;
use coface::arrange::spatial::{NonPlanar, SpatialArrangement, SpatialOptions, SpatialPolygons};
use coface::geometry::Positions;
use coface::topology::homology;
use coface::{CellId, FaceId, VertexId};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::PI;

pub(crate) type Point = [f64; 3];

const SPLIT: SpatialOptions = SpatialOptions::new().non_planar(NonPlanar::Split);

fn polygons(points: &[Point], lists: &[Vec<u32>]) -> SpatialPolygons {
    let positions = Positions::from_flat(3, points.as_flattened().to_vec()).unwrap();
    SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(lists)).unwrap()
}

/// The six sides of a box, fronts outward, with the corners moved.
pub(crate) fn cuboid(low: Point, high: Point, motion: impl Fn(Point) -> Point) -> SpatialPolygons {
    let corner = |i: usize| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { high[axis] } else { low[axis] });
    let points: Vec<Point> = (0..8).map(|i| motion(corner(i))).collect();
    let squares = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    polygons(&points, &squares.map(|square| square.to_vec()))
}

fn cube(low: Point, side: f64) -> SpatialPolygons {
    cuboid(low, low.map(|x| x + side), |p| p)
}

fn unit(motion: impl Fn(Point) -> Point) -> SpatialPolygons {
    cuboid([0.0; 3], [1.0; 3], motion)
}

/// A rotation about an axis.
pub(crate) fn turned(axis: usize, angle: f64, p: Point) -> Point {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let (sine, cosine) = angle.sin_cos();
    let mut q = p;
    (q[i], q[j]) = (cosine * p[i] - sine * p[j], sine * p[i] + cosine * p[j]);
    q
}

pub(crate) fn moved(by: Point, p: Point) -> Point {
    [0, 1, 2].map(|axis| p[axis] + by[axis])
}

/// The motion of the second cube of the table.
fn second(p: Point) -> Point {
    moved([0.3, 0.4, 0.25], turned(0, PI / 5.0, turned(2, PI / 12.0, p)))
}

fn third(p: Point) -> Point {
    second(moved([-0.2, 0.4, -0.2], turned(1, PI / 5.0, turned(1, PI / 12.0, p))))
}

fn arrange(inputs: &[SpatialPolygons]) -> SpatialArrangement {
    SpatialArrangement::new(&SpatialPolygons::joined(inputs).unwrap(), &SPLIT).unwrap()
}

/// The volume within the inputs that satisfy a condition.
fn volume_where(arrangement: &SpatialArrangement, condition: impl Fn(&[usize]) -> bool) -> f64 {
    let inside = arrangement.inside(InsideRule::Nonzero).unwrap();
    let volumes = arrangement.volumes().unwrap();
    inside.iter().zip(volumes).filter(|(inputs, _)| condition(inputs)).map(|(_, volume)| volume).sum()
}

/// Everything that holds for all arrangements.
fn check(arrangement: &SpatialArrangement) {
    let counts = arrangement.f_vector();
    let (vertices, edges, faces, cells) = (counts[0], counts[1], counts[2], counts[3]);
    // Products are zero, and sums of fine cells commute with boundaries: else these are errors.
    let complex = arrangement.coarse_complex().unwrap();
    assert_eq!(complex.f_vector(), [vertices, edges, faces, cells]);
    let balls = arrangement.ball_complex().unwrap();
    assert_eq!(balls.refinement().coarse(balls.complex()).unwrap().f_vector(), complex.f_vector());
    arrangement.chain_map_to_fine().unwrap();
    // Alexander duality for the faces, and nothing left with the cells.
    let betti = homology(&arrangement.complex().chain_complex().unwrap()).betti_numbers();
    assert_eq!(betti.get(2).copied().unwrap_or(0), cells);
    let betti = homology(balls.complex()).betti_numbers();
    if balls.parts_left().is_empty() {
        assert_eq!(betti.get(2..).map_or(0, |high| high.iter().sum::<usize>()), 0);
    }
    // Walks run through each side once.
    let mut holes = 0;
    for face in (0..faces).map(FaceId::new) {
        let mut sides: BTreeMap<[u32; 2], i32> = BTreeMap::new();
        let walks = arrangement.face_walks(face);
        holes += walks.len() - 1;
        for walk in walks.iter() {
            for (i, &from) in walk.iter().enumerate() {
                *sides.entry([from, walk[(i + 1) % walk.len()]]).or_default() += 1;
            }
        }
        for (edge, sign) in arrangement.complex().sides(face) {
            let [a, b] = arrangement.complex().edges()[edge.index()];
            *sides.entry(if sign == Sign::Plus { [a, b] } else { [b, a] }).or_default() -= 1;
        }
        assert!(sides.values().all(|&count| count == 0), "{face} {sides:?}");
        assert!(!arrangement.polygons_of_face(face).is_empty());
    }
    assert_eq!(arrangement.hole_count(), holes);
    // Triangles close up around every cell and enclose its volume.
    let drawn = arrangement.drawn_triangles().unwrap();
    let positions = arrangement.fine_triangles().positions();
    let at = |v: u32| -> Point { positions.point(VertexId::from_u32(v)).try_into().unwrap() };
    let volumes = arrangement.volumes().unwrap();
    for cell in (0..cells).map(CellId::new) {
        let (mut sides, mut volume) = (BTreeMap::new(), 0.0);
        for (&[a, b, c], &face) in drawn.triangles.iter().zip(&drawn.face_of_triangle) {
            let face = FaceId::from_u32(face);
            let [back, front] = [Sign::Plus, Sign::Minus].map(|side| arrangement.cell_at(face, side));
            let sign = i32::from(back == Some(cell)) - i32::from(front == Some(cell));
            if sign == 0 {
                continue;
            }
            for [x, y] in [[a, b], [b, c], [c, a]] {
                *sides.entry([x.min(y), x.max(y)]).or_insert(0) += if x < y { sign } else { -sign };
            }
            let [p, q, r] = [a, b, c].map(at);
            volume += f64::from(sign)
                * (0..3)
                    .map(|i| {
                        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                        p[i] * (q[j] * r[k] - q[k] * r[j])
                    })
                    .sum::<f64>()
                / 6.0;
        }
        assert!(sides.values().all(|&sum| sum == 0), "{cell} is open");
        let expected = volumes[cell.index()];
        assert!((volume - expected).abs() <= 1e-9 * (1.0 + expected), "{cell} {volume} {expected}");
    }
}

pub(crate) fn sorted(mut volumes: Vec<f64>) -> Vec<f64> {
    volumes.sort_by(f64::total_cmp);
    volumes
}

fn expect(inputs: &[SpatialPolygons], counts: [usize; 4], volumes: &[f64]) -> SpatialArrangement {
    let arrangement = arrange(inputs);
    check(&arrangement);
    assert_eq!(arrangement.f_vector(), counts);
    let found = sorted(arrangement.volumes().unwrap());
    assert_eq!(found.len(), volumes.len(), "{found:?}");
    assert!(found.iter().zip(volumes).all(|(x, y)| (x - y).abs() <= 1e-12 * y), "{found:?}");
    again(&arrangement);
    arrangement
}

/// Triangles that faces of a rounded arrangement are drawn with meet in common edges and corners alone, and enclose the
/// same cells.
pub(crate) fn triangles_again(rounded: &SpatialArrangement) {
    let drawn = rounded.drawn_triangles().unwrap();
    let positions = rounded.fine_triangles().positions().clone();
    let triangles =
        SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(drawn.triangles)).unwrap();
    let again = SpatialArrangement::new(&triangles, &SpatialOptions::default()).unwrap();
    assert!(again.is_exactly_rounded());
    assert_eq!(again.f_vector()[2], again.polygon_count());
    let (found, volumes) = (sorted(again.volumes().unwrap()), sorted(rounded.volumes().unwrap()));
    assert_eq!(found.len(), volumes.len());
    assert!(found.iter().zip(volumes).all(|(x, y)| (x - y).abs() <= 1e-12 * y));
}

/// Faces drawn with rounded vertices, arranged again, are the same, if that is exact.
fn again(arrangement: &SpatialArrangement) {
    if !arrangement.is_exactly_rounded() {
        return;
    }
    let mut walks = RaggedArray::new();
    let mut face_of_walk = Vec::new();
    for face in 0..arrangement.complex().face_count() as u32 {
        for walk in arrangement.face_walks(FaceId::from_u32(face)).iter() {
            walks.push(walk);
            face_of_walk.push(face);
        }
    }
    let faces = SpatialPolygons::new(arrangement.positions().clone(), walks, face_of_walk).unwrap();
    let again = SpatialArrangement::new(&faces, &SpatialOptions::default()).unwrap();
    assert_eq!(again.f_vector(), arrangement.f_vector());
    assert_eq!(again.positions(), arrangement.positions());
    // Volumes are sums of doubles, in the order of another triangulation.
    let (found, volumes) = (sorted(again.volumes().unwrap()), sorted(arrangement.volumes().unwrap()));
    assert_eq!(found.len(), volumes.len());
    assert!(
        found.iter().zip(&volumes).all(|(x, y)| (x - y).abs() <= 1e-15 * y.abs()),
        "{found:?} {volumes:?}"
    );
    assert_eq!(again.coarse_complex().unwrap(), arrangement.coarse_complex().unwrap());
}

/// Shells find their cells whatever the order: n boxes in a row along each axis, and n boxes each within the next.
#[test]
fn rows_and_dolls_have_a_cell_each() {
    const COUNT: usize = 60;
    for axis in 0..3 {
        let row: Vec<SpatialPolygons> = (0..COUNT)
            .map(|i| {
                let mut low = [0.0; 3];
                low[axis] = 2.0 * i as f64;
                cube(low, 1.0)
            })
            .collect();
        let row = arrange(&row);
        assert_eq!(row.f_vector(), [8 * COUNT, 12 * COUNT, 6 * COUNT, COUNT]);
        assert_eq!(row.volumes().unwrap(), [1.0; COUNT]);
    }
    // The smallest last, so that numbers say nothing about who is within whom.
    let dolls: Vec<SpatialPolygons> =
        (0..COUNT).rev().map(|i| cube([-1.0 - i as f64; 3], 2.0 * (i + 1) as f64)).collect();
    let dolls = arrange(&dolls);
    assert_eq!((dolls.f_vector()[3], dolls.void_count()), (COUNT, COUNT - 1));
    let cube_of = |i: usize| (2.0 * i as f64).powi(3);
    let expected: Vec<f64> = (1..=COUNT).map(|i| cube_of(i) - cube_of(i - 1)).collect();
    assert_eq!(sorted(dolls.volumes().unwrap()), expected);
    // The innermost is within all.
    let inside = dolls.inside(InsideRule::Nonzero).unwrap();
    assert_eq!(inside.iter().map(Vec::len).max(), Some(COUNT));
}

#[test]
fn cubes_that_touch_have_the_known_cells() {
    let one = || cube([0.0; 3], 1.0);
    let with = |low: Point| [one(), cube(low, 1.0)];
    expect(&[one()], [8, 12, 6, 1], &[1.0]);
    expect(&with([0.0; 3]), [8, 12, 6, 1], &[1.0]);
    expect(&with([1.0, 0.0, 0.0]), [12, 20, 11, 2], &[1.0; 2]);
    expect(&with([1.0, 0.5, 0.5]), [18, 28, 13, 2], &[1.0; 2]);
    expect(&with([1.0, 1.0, 0.0]), [14, 23, 12, 2], &[1.0; 2]);
    expect(&with([1.0; 3]), [15, 24, 12, 2], &[1.0; 2]);
    expect(&with([3.0, 0.0, 0.0]), [16, 24, 12, 2], &[1.0; 2]);
    expect(&with([0.5; 3]), [22, 36, 18, 3], &[0.125, 0.875, 0.875]);
    let nested = expect(&[one(), cube([0.25; 3], 0.5)], [16, 24, 12, 2], &[0.125, 0.875]);
    assert_eq!(nested.void_count(), 1);
    assert_eq!(sorted_inside(&nested), [vec![0], vec![0, 1]]);
}

fn sorted_inside(arrangement: &SpatialArrangement) -> Vec<Vec<usize>> {
    let mut inside = arrangement.inside(InsideRule::Nonzero).unwrap();
    inside.sort();
    inside
}

#[test]
fn a_rod_through_a_cube_makes_faces_with_holes() {
    let rod = cuboid([0.25, 0.25, -0.5], [0.75, 0.75, 1.5], |p| p);
    let found = expect(&[cube([0.0; 3], 1.0), rod], [24, 40, 22, 4], &[0.125, 0.125, 0.25, 0.75]);
    assert_eq!(found.hole_count(), 2);
    assert_eq!(sorted_inside(&found), [vec![0], vec![0, 1], vec![1], vec![1]]);
}

#[test]
fn turned_cubes_have_the_known_cells_and_volumes() {
    let close = |x: f64, y: f64| assert!((x - y).abs() < 1e-10, "{x} {y}");
    let two = arrange(&[unit(|p| p), unit(second)]);
    check(&two);
    assert_eq!(two.f_vector(), [24, 40, 20, 3]);
    let volume = |arrangement, wanted: &[usize]| {
        volume_where(arrangement, |inside| wanted.iter().all(|input| inside.contains(input)))
    };
    let both = 0.355_913_581_828_8;
    close(volume(&two, &[0, 1]), both);
    close(volume_where(&two, |inside| inside == [0]), 1.0 - both);
    close(volume_where(&two, |inside| inside == [1]), 1.0 - both);
    // Squares that are flat only up to rounding are told, and are whole again.
    assert!(!two.split_polygons().is_empty());
    assert!(two.split_polygons().iter().all(|split| split.deviation < 1e-15));
    let three = arrange(&[unit(|p| p), unit(second), unit(third)]);
    check(&three);
    assert_eq!(three.f_vector(), [49, 88, 47, 7]);
    close(volume(&three, &[0, 1]), 0.355_913_581_8);
    close(volume(&three, &[0, 2]), 0.105_906_990_4);
    close(volume(&three, &[1, 2]), 0.113_060_236_3);
    close(volume(&three, &[0, 1, 2]), 0.059_034_433_5);
    close(volume(&three, &[]), 2.484_153_624_9);
}

/// The squares of a grid of unit cubes, each once, moved.
fn grid(count: usize, motion: impl Fn(Point) -> Point) -> SpatialPolygons {
    let number = |[x, y, z]: [usize; 3]| ((z * (count + 1) + y) * (count + 1) + x) as u32;
    let mut points = Vec::new();
    let mut squares = Vec::new();
    for z in 0..=count {
        for y in 0..=count {
            for x in 0..=count {
                let here = [x, y, z];
                points.push(motion(here.map(|i| i as f64)));
                for axis in 0..3 {
                    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                    if here[i] < count && here[j] < count {
                        let step = |u: usize, v: usize| {
                            let mut at = here;
                            (at[i], at[j]) = (at[i] + u, at[j] + v);
                            number(at)
                        };
                        squares.push(vec![step(0, 0), step(1, 0), step(1, 1), step(0, 1)]);
                    }
                }
            }
        }
    }
    polygons(&points, &squares)
}

#[test]
fn two_grids_are_arranged() {
    let one = arrange(&[grid(2, |p| p)]);
    assert_eq!(one.f_vector(), [27, 54, 36, 8]);
    let two = arrange(&[grid(2, |p| p), grid(2, second)]);
    check(&two);
    let total: f64 = two.volumes().unwrap().iter().sum();
    // Each cube of one meets some of the other; together they are less than both.
    assert!(total > 8.0 && total < 16.0 && two.f_vector()[3] > 16, "{total}");
    // Inputs that are not closed say so, and have no inside.
    let open = two.open_inputs().unwrap();
    assert_eq!(open.iter().map(|(input, _)| *input).collect::<Vec<_>>(), [0, 1]);
    assert!(open[1].1.message().starts_with("input 1 is not closed"));
    assert!(two.inside(InsideRule::Nonzero).unwrap().iter().all(Vec::is_empty));
}

/// Cubes by the generator of the table.
fn random_cubes(count: usize, seed: u64) -> Vec<SpatialPolygons> {
    let mut state = seed;
    let mut draw = move || {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..count)
        .map(|_| {
            let side = 0.3 + 0.7 * draw();
            let by = [0; 3].map(|_| 2.0 * draw());
            let angles = [0; 3].map(|_| PI * draw());
            unit(move |p| {
                let p = p.map(|x| x * side);
                moved(by, turned(0, angles[0], turned(1, angles[1], turned(2, angles[2], p))))
            })
        })
        .collect()
}

#[test]
fn random_cubes_have_the_known_union() {
    // Volumes by inclusion and exclusion over intersections of half-spaces.
    for (count, seed, counts, union) in [
        (16, 11, [241, 428, 231, 40], 5.789_775_884_653),
        (24, 12, [578, 1126, 665, 117], 8.895_700_855_618),
        (48, 11, [2593, 5758, 4041, 889], 12.034_725_081_359),
    ] {
        let found = arrange(&random_cubes(count, seed));
        assert_eq!(found.f_vector(), counts, "{count} cubes");
        let volume = volume_where(&found, |inside| !inside.is_empty());
        assert!((volume - union).abs() < 1e-11, "{count} cubes: {volume}, not {union}");
        if count == 16 {
            check(&found);
        }
    }
}

#[test]
fn tetrahedra_share_a_small_one() {
    let tetrahedron = |by: f64| {
        let points = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]].map(|p| moved([by; 3], p));
        polygons(&points, &[vec![0, 2, 1], vec![0, 1, 3], vec![1, 2, 3], vec![0, 3, 2]])
    };
    let two = arrange(&[tetrahedron(0.0), tetrahedron(0.25)]);
    check(&two);
    let both = volume_where(&two, |inside| inside.len() == 2);
    assert!((both - 0.25f64.powi(3) / 6.0).abs() < 1e-15);
}

#[test]
fn coplanar_faces_of_one_input_are_merged_on_request() {
    let options = SPLIT.merge_coplanar(true);
    // A cube whose sides are grids of triangles; its inner walls are left out.
    let squares = grid(3, |p| p);
    let mut triangles = Vec::new();
    for square in squares.walks().iter() {
        let at = |v: u32| squares.positions().point(VertexId::from_u32(v));
        let is_outside =
            (0..3).any(|axis| [0.0, 3.0].iter().any(|&end| square.iter().all(|&v| at(v)[axis] == end)));
        if is_outside {
            triangles.extend([[square[0], square[1], square[2]], [square[0], square[2], square[3]]]);
        }
    }
    let lists = RaggedArray::from_lists(&triangles);
    let soup = SpatialPolygons::from_polygons(squares.positions().clone(), lists).unwrap();
    let fine = SpatialArrangement::new(&soup, &SPLIT).unwrap();
    assert_eq!(fine.f_vector(), [56, 162, 108, 1]);
    let merged = SpatialArrangement::new(&soup, &options).unwrap();
    check(&merged);
    assert_eq!(merged.f_vector(), [8, 12, 6, 1]);
    assert_eq!(merged.polygons_of_face(FaceId::new(0)).len(), 18);
    // Of several inputs, those that differ stay apart.
    let inputs = (0..108).map(|triangle| u32::from(triangle == 0)).collect();
    let two = SpatialArrangement::new(&soup.with_inputs(inputs).unwrap(), &options).unwrap();
    check(&two);
    assert_eq!(two.f_vector()[2..], [7, 1]);
}

#[test]
fn rounded_results_can_be_read_again() {
    let two = arrange(&[unit(|p| p), unit(second)]);
    assert!(!two.is_exactly_rounded());
    let snapped = two.snapped(&SPLIT).unwrap();
    assert!(snapped.is_exactly_rounded() && snapped.round_count() > 0);
    check(&snapped);
    again(&snapped);
    assert_eq!(snapped.f_vector()[3], 3);
    let both = volume_where(&snapped, |inside| inside == [0, 1]);
    assert!((both - 0.355_913_581_828_8).abs() < 1e-10);
    assert_eq!(snapped.polygon_count(), 12);
    // Points that no polygon runs through are no vertices.
    let points = [[9.0; 3], [0.0; 3], [1., 0., 0.], [8.0; 3], [0., 1., 0.]];
    let one = SpatialArrangement::new(&polygons(&points, &[vec![1, 2, 4]]), &SPLIT).unwrap();
    check(&one);
    assert_eq!((one.f_vector(), one.positions().len()), (vec![3, 3, 1, 0], 3));
    again(&one);
}

#[test]
fn limits_and_faults_are_told() {
    let options = SPLIT.max_cells(40);
    let two = SpatialPolygons::joined(&[cube([0.0; 3], 1.0), cube([0.5; 3], 1.0)]).unwrap();
    let error = SpatialArrangement::new(&two, &options).unwrap_err();
    assert_eq!(error.kind(), coface::ErrorKind::TooLarge);
    let error = SpatialArrangement::new(&unit(second), &SPLIT.non_planar(NonPlanar::Refuse)).unwrap_err();
    assert!(error.message().contains("is not planar"), "{error}");
    let empty = SpatialArrangement::new(&SpatialPolygons::joined(&[]).unwrap(), &SPLIT).unwrap();
    assert_eq!(empty.f_vector(), [0; 4]);
    let flat = polygons(&[[0.0; 3], [1.0; 3], [2.0; 3]], &[vec![0, 1, 2]]);
    let nothing = SpatialArrangement::new(&flat, &SPLIT).unwrap();
    assert_eq!((nothing.f_vector()[2], nothing.polygons_without_area()), (0, &[0][..]));
}

/// Triangles, squares that are not planar, and flat ones with a hole, between points with small integers.
fn soup() -> impl Strategy<Value = SpatialPolygons> {
    let point = || prop::array::uniform3((0..4i32).prop_map(f64::from));
    let triangle = prop::array::uniform3(point()).prop_map(|p| p.to_vec());
    let bent = prop::array::uniform4(0..4i32).prop_map(|z| {
        [[0., 0.], [3., 0.], [3., 3.], [0., 3.]]
            .iter()
            .zip(z)
            .map(|(p, z)| [p[0], p[1], f64::from(z)])
            .collect()
    });
    let flat = (0..3usize, 0..4i32, 0..2i32, 1..3i32).prop_map(|(axis, place, low, side)| {
        let (low, high) = (f64::from(low), f64::from(low + side));
        [[low, low], [high, low], [high, high], [low, high]]
            .map(|[u, v]| {
                let mut point = [f64::from(place); 3];
                (point[(axis + 1) % 3], point[(axis + 2) % 3]) = (u, v);
                point
            })
            .to_vec()
    });
    prop::collection::vec(prop_oneof![3 => triangle, 2 => bent, 3 => flat], 1..9).prop_map(
        |lists: Vec<Vec<Point>>| {
            let mut points = Vec::new();
            let mut numbers = Vec::new();
            for list in lists {
                let start = points.len() as u32;
                numbers.push((start..start + list.len() as u32).collect());
                points.extend(list);
            }
            polygons(&points, &numbers)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn soups_are_arranged(soup in soup(), merge_coplanar: bool) {
        let options = SPLIT.merge_coplanar(merge_coplanar);
        let arrangement = SpatialArrangement::new(&soup, &options).unwrap();
        check(&arrangement);
        if !merge_coplanar && arrangement.split_polygons().is_empty() {
            again(&arrangement);
        }
        // The axes in another order, and mirrored.
        let flat = soup.positions().as_flat().as_chunks::<3>().0.iter().flat_map(|&[x, y, z]| [-z, x, 4.0 * y]);
        let moved = SpatialPolygons::new(
            Positions::from_flat(3, flat.collect()).unwrap(),
            soup.walks().clone(),
            soup.polygon_of_walk().to_vec(),
        )
        .unwrap();
        if soup.walks().iter().all(|walk| walk.len() == 3) || arrangement.split_polygons().is_empty() {
            let moved = SpatialArrangement::new(&moved, &options).unwrap();
            prop_assert_eq!(moved.f_vector(), arrangement.f_vector());
            let volumes = arrangement.volumes().unwrap().into_iter().map(|volume| 4.0 * volume).collect();
            let found = sorted(moved.volumes().unwrap());
            prop_assert!(found.iter().zip(sorted(volumes)).all(|(x, y)| (x - y).abs() <= 1e-9 * y));
        }
    }

    #[test]
    fn soups_are_rounded(soup in soup(), merge_coplanar: bool) {
        let options = SPLIT.merge_coplanar(merge_coplanar);
        let arrangement = SpatialArrangement::new(&soup, &options).unwrap();
        let snapped = arrangement.snapped(&options).unwrap();
        check(&snapped);
        prop_assert!(snapped.is_exactly_rounded());
        // Nothing is so thin that it vanishes.
        prop_assert_eq!(snapped.f_vector()[3], arrangement.f_vector()[3]);
        let volumes = sorted(arrangement.volumes().unwrap());
        let found = sorted(snapped.volumes().unwrap());
        prop_assert!(found.iter().zip(volumes).all(|(x, y)| (x - y).abs() <= 1e-12));
        if snapped.round_count() > 0 {
            triangles_again(&snapped);
        }
    }
}
