//! Yin sets on Cartesian grids: cells add up, and what is in a cell is what the set has in common with it.

#![allow(clippy::unwrap_used)]

use coface_algebra::ErrorKind;
use coface_arrange::boolean::InsideRule;
use coface_geometry::Angle;
use coface_yin::{CartesianGrid, Coverage, Curve, CutCells, EndCondition, Order, WalkStep, YinSet};
use std::f64::consts::{PI, TAU};

fn grid(origin: [f64; 2], spacing: [f64; 2], counts: [usize; 2]) -> CartesianGrid {
    CartesianGrid::new(origin, spacing, counts).unwrap()
}

fn ring(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    points.to_vec()
}

fn linear(rings: &[Vec<[f64; 2]>]) -> YinSet {
    YinSet::fit(rings, &[], Order::LINEAR, &EndCondition::NotAKnot).unwrap()
}

fn rectangle(low: [f64; 2], high: [f64; 2]) -> Vec<[f64; 2]> {
    vec![low, [high[0], low[1]], high, [low[0], high[1]]]
}

fn flower(count: usize, size: f64, lobes: f64, depth: f64) -> Vec<[f64; 2]> {
    (0..count)
        .map(|i| TAU * i as f64 / count as f64)
        .map(|t| [t, size * (1.0 + depth * (lobes * t).cos())])
        .map(|[t, radius]| [radius * t.cos(), radius * t.sin()])
        .collect()
}

/// Each cell against the meet of the set with the cell, and what must hold for all.
fn check_against_meets(set: &YinSet, grid: &CartesianGrid) {
    let cells = CutCells::new(set, grid.clone()).unwrap();
    let [columns, rows] = grid.cell_counts();
    for row in 0..rows {
        for column in 0..columns {
            let [low, high] = grid.cell_box(column, row);
            let all = (high[0] - low[0]) * (high[1] - low[1]);
            let cell = linear(&[rectangle(low, high)]);
            let meet = set.meet(&cell).unwrap();
            let area = meet.area().unwrap();
            let at = format!("cell {column} {row}");
            assert!(
                (cells.area(column, row) - area).abs() <= 1e-12 * all,
                "{at}: {} {area}",
                cells.area(column, row)
            );
            match cells.coverage(column, row) {
                Coverage::Empty => assert!(meet.is_empty(), "{at}"),
                Coverage::Full => assert_eq!(area, all, "{at}"),
                Coverage::Cut => assert!(area > 0.0 && area < all, "{at}"),
            }
            let Some(own) = cells.cell(column, row) else { continue };
            let walked: f64 =
                cells.part_curves(own).unwrap().iter().map(|(curve, _)| curve.signed_area()).sum();
            assert!((walked - area).abs() <= 1e-12 * all, "{at}: {walked} {area} {:?}", cells.walks(own));
            let part = cells.part(own).unwrap();
            assert!((part.area().unwrap() - area).abs() <= 1e-12 * all, "{at}");
            // Rounded corners are the same, for both round one crossing.
            assert_eq!(part.curve_counts(), meet.curve_counts(), "{at}");
            assert_eq!(part.betti_closed().unwrap(), meet.betti_closed().unwrap(), "{at}");
        }
    }
}

#[test]
fn parts_of_polygons_are_their_meets_with_cells() {
    let sets = [
        linear(&[ring(&[[0.3, 0.2], [3.7, 0.9], [2.1, 1.3], [3.1, 3.8], [1.2, 2.4], [0.4, 3.3]])]),
        // Along lines and through nodes, with a hole in one cell and one along sides of four cells.
        linear(&[
            rectangle([0.0, 0.0], [4.0, 4.0]),
            ring(&[[1.25, 1.25], [1.25, 1.75], [1.75, 1.75], [1.75, 1.25]]),
            ring(&[[2.0, 1.0], [2.0, 3.0], [3.0, 3.0], [3.0, 1.0]]),
        ]),
        // Diagonals through nodes, which touch lines in corners.
        linear(&[ring(&[[2.0, 0.0], [4.0, 2.0], [2.0, 4.0], [0.0, 2.0]])]),
        // An island in one cell, one that touches a line from inside, one as large as a cell.
        linear(&[
            ring(&[[0.25, 0.25], [0.5, 0.25], [0.5, 0.5]]),
            ring(&[[1.0, 0.5], [1.5, 0.25], [1.5, 0.75]]),
            rectangle([2.0, 2.0], [3.0, 3.0]),
            ring(&[[3.0, 3.0], [3.5, 3.0], [3.0, 3.5]]),
        ]),
        // Thin spikes: many chains in a cell.
        linear(&[ring(&[
            [-1.0, 0.1],
            [2.5, 0.2],
            [-1.0, 0.3],
            [2.6, 0.4],
            [-1.0, 0.5],
            [3.9, 0.6],
            [5.0, 3.0],
            [-1.5, 3.5],
        ])]),
    ];
    for set in &sets {
        check_against_meets(set, &grid([0.0, 0.0], [1.0, 1.0], [4, 4]));
        check_against_meets(set, &grid([0.5, 0.0], [0.5, 1.0], [5, 4]));
        check_against_meets(set, &grid([-0.7, -0.3], [0.9, 1.1], [6, 4]));
        check_against_meets(&set.complement().unwrap(), &grid([-1.0, -1.0], [1.0, 1.5], [6, 4]));
    }
}

#[test]
fn random_polygons_on_the_integers_are_cut_like_meets() {
    let mut seed = 5u64;
    let mut below = |bound: u64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((seed >> 33) % bound) as f64
    };
    for _ in 0..12 {
        let rings: Vec<Vec<[f64; 2]>> =
            (0..3).map(|_| (0..5).map(|_| [below(9) / 2.0, below(9) / 2.0]).collect()).collect();
        let set = YinSet::from_rings(&rings, InsideRule::Odd).unwrap();
        check_against_meets(&set, &grid([0.0, 0.0], [1.0, 1.0], [4, 4]));
    }
}

#[test]
fn what_runs_along_lines_belongs_to_its_left() {
    let square = linear(&[rectangle([1.0, 1.0], [3.0, 3.0])]);
    let cells = CutCells::new(&square, grid([0.0, 0.0], [1.0, 1.0], [4, 4])).unwrap();
    assert_eq!((cells.count(Coverage::Full), cells.count(Coverage::Cut)), (4, 0));
    assert_eq!((cells.total_area(), cells.total_length()), (4.0, 8.0));
    let corner = cells.cell(1, 1).unwrap();
    assert_eq!((corner.length(), corner.area(), corner.coverage()), (2.0, 1.0, Coverage::Full));
    assert_eq!(cells.arcs(corner).len(), 2);
    // Of the exterior the cells around have the boundary.
    let outside = square.complement().unwrap();
    let cells = CutCells::new(&outside, grid([0.0, 0.0], [1.0, 1.0], [4, 4])).unwrap();
    assert_eq!((cells.total_area(), cells.total_length()), (12.0, 8.0));
    assert_eq!((cells.count(Coverage::Full), cells.count(Coverage::Empty)), (12, 4));
    assert!(cells.cell(1, 1).is_none() && cells.cell(0, 1).is_some());
    // Without boundary all cells are alike.
    for (set, coverage) in
        [(YinSet::empty(Order::CUBIC), Coverage::Empty), (YinSet::plane(Order::CUBIC), Coverage::Full)]
    {
        let cells = CutCells::new(&set, grid([0.0, 0.0], [0.5, 0.5], [3, 2])).unwrap();
        assert_eq!(cells.count(coverage), 6);
        assert_eq!(cells.total_area(), if coverage == Coverage::Full { 1.5 } else { 0.0 });
    }
}

#[test]
fn a_fine_circle_is_cut_without_loss() {
    // 0.25 times the number of chords of length 1e-4.
    let count = (TAU * 0.25 / 1e-4).floor() as usize + 1;
    let points: Vec<[f64; 2]> = (0..count)
        .map(|i| Angle::turns(i as i64, count as u32).cosine_and_sine())
        .map(|(x, y)| [0.5 + 0.25 * x, 0.5 + 0.25 * y])
        .collect();
    let disk = YinSet::fit(&[points], &[], Order::CUBIC, &EndCondition::NotAKnot).unwrap();
    let cells = CutCells::new(&disk, grid([0.0, 0.0], [1.0 / 1024.0; 2], [1024, 1024])).unwrap();
    assert!((cells.total_area() - PI / 16.0).abs() < 1e-12, "{}", cells.total_area() - PI / 16.0);
    assert!((cells.total_area() - disk.area().unwrap()).abs() < 1e-15);
    assert!((cells.total_length() - PI / 2.0).abs() < 1e-12, "{}", cells.total_length() - PI / 2.0);
    let cut = cells.count(Coverage::Cut);
    assert!((2000..2100).contains(&cut), "{cut}");
    for cell in cells.cells().iter().step_by(7) {
        let walked: f64 = cells.part_curves(cell).unwrap().iter().map(|(curve, _)| curve.signed_area()).sum();
        assert!((walked - cell.area()).abs() < 1e-18, "{walked} {}", cell.area());
    }
}

/// Lengths do not depend on where the set is but for rounding of coordinates, nor does the work: parts of arcs that are rounded like
/// coordinates never have the lengths that add up to that of the whole.
#[test]
fn lengths_far_from_the_origin_are_as_near_it() {
    let circle = Curve::circle([0.0, 0.0], 1.0, 200, Order::CUBIC).unwrap();
    for offset in [0.0, 100.0, 1e4, 1e8] {
        let set = YinSet::new(&[circle.translated([offset, -offset])]).unwrap();
        let around = grid([offset - 1.1, -offset - 1.1], [2.2 / 32.0; 2], [32, 32]);
        let cells = CutCells::new(&set, around).unwrap();
        let rounding = 1e-14 + 200.0 * 8.0 * f64::EPSILON * offset;
        assert!((cells.total_length() - circle.length(1e-14)).abs() < rounding + 1e-13, "{offset}");
    }
}

#[test]
fn a_turned_rectangle_is_cut_without_loss() {
    for order in [Order::LINEAR, Order::CUBIC] {
        let corners = rectangle([0.2, 0.3], [0.8, 0.5]).into_iter().map(|[x, y]| {
            let (sine, cosine) = 0.3f64.sin_cos();
            [cosine * x - sine * y + 0.1, sine * x + cosine * y]
        });
        let set =
            YinSet::fit(&[corners.collect()], &[vec![0, 1, 2, 3]], order, &EndCondition::NotAKnot).unwrap();
        let cells = CutCells::new(&set, grid([0.0, 0.0], [1.0 / 512.0; 2], [512, 512])).unwrap();
        assert!((cells.total_area() - 0.12).abs() < 1e-12);
        assert!((cells.total_length() - 1.6).abs() < 1e-12);
        assert!((cells.total_area() - set.area().unwrap()).abs() < 1e-16);
    }
}

#[test]
fn smooth_sets_are_cut_like_fine_polygons() {
    for order in [4, 6, 8].map(|order| Order::new(order).unwrap()) {
        let mut hole = flower(48, 0.55, 2.0, 0.3);
        hole.reverse();
        let set =
            YinSet::fit(&[flower(96, 1.0, 7.0, 0.2), hole], &[vec![3, 50]], order, &EndCondition::NotAKnot)
                .unwrap();
        let polygons = linear(&[0, 1].map(|own| flattened(&set.curve(own))));
        // Lines through knots on the axes and lines that the curves come near to or touch.
        for grid in [
            grid([-1.5, -1.5], [0.25, 0.25], [12, 12]),
            grid([-1.2, -1.2], [0.4, 2.4], [3, 1]),
            CartesianGrid::with_lines([vec![-1.2, 0.0, 0.715, 1.2], vec![-1.2, -0.385, 0.385, 1.0]]).unwrap(),
        ] {
            let cells = CutCells::new(&set, grid.clone()).unwrap();
            let flat = CutCells::new(&polygons, grid.clone()).unwrap();
            let whole = set.area().unwrap();
            let [columns, rows] = grid.cell_counts();
            if grid.lines(0)[columns] > 1.2 {
                assert!((cells.total_area() - whole).abs() < 1e-14, "{}", cells.total_area() - whole);
                let lengths: f64 = (0..2).map(|own| set.curve(own).length(1e-14)).sum();
                assert!((cells.total_length() - lengths).abs() < 1e-13);
            }
            for row in 0..rows {
                for column in 0..columns {
                    let [low, high] = grid.cell_box(column, row);
                    let all = (high[0] - low[0]) * (high[1] - low[1]);
                    let at = format!("{column} {row}");
                    let difference = (flat.area(column, row) - cells.area(column, row)).abs();
                    assert!(difference < 1e-4 * all, "{at}: {difference}");
                    match cells.coverage(column, row) {
                        Coverage::Empty => assert!(flat.area(column, row) < 1e-4 * all, "{at}"),
                        Coverage::Full => assert!(flat.area(column, row) > (1.0 - 1e-4) * all, "{at}"),
                        Coverage::Cut => {
                            let cell = cells.cell(column, row).unwrap();
                            let parts = cells.part_curves(cell).unwrap();
                            let walked: f64 = parts.iter().map(|(curve, _)| curve.signed_area()).sum();
                            assert!((walked - cell.area()).abs() < 1e-15, "{at}: {walked} {}", cell.area());
                        }
                    }
                }
            }
        }
    }
}

fn flattened(curve: &Curve<'_>) -> Vec<[f64; 2]> {
    const PARTS: usize = 32;
    let pairs = curve.knots().windows(2);
    let parameters = pairs.flat_map(|pair| {
        (0..PARTS).map(|part| pair[0] + (pair[1] - pair[0]) * part as f64 / PARTS as f64).collect::<Vec<_>>()
    });
    parameters.map(|parameter| curve.point(parameter)).collect()
}

#[test]
fn kinks_of_parts_are_where_they_are_not_smooth() {
    let disk = YinSet::fit(&[flower(32, 1.0, 0.0, 0.0)], &[], Order::CUBIC, &EndCondition::NotAKnot).unwrap();
    let cells = CutCells::new(&disk, grid([0.0, 0.0], [2.0, 2.0], [1, 1])).unwrap();
    let cell = cells.cell(0, 0).unwrap();
    assert_eq!(cells.walks(cell).len(), 1);
    let sides = cells.walks(cell)[0].iter().filter(|step| matches!(step, WalkStep::Side(_))).count();
    assert_eq!(sides, 2);
    let (curve, kinks) = &cells.part_curves(cell).unwrap()[0];
    let found: Vec<[f64; 2]> = kinks.iter().map(|&knot| curve.knot_point(knot as usize)).collect();
    assert_eq!(found, [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]);
    assert!((curve.signed_area() - PI / 4.0).abs() < 1e-5);
    assert!((cells.total_area() - curve.signed_area()).abs() < 1e-15);
}

#[test]
fn grids_that_are_none_are_refused() {
    let words =
        |origin, spacing, counts| CartesianGrid::new(origin, spacing, counts).unwrap_err().to_string();
    assert_eq!(
        words([0.0; 2], [1.0; 2], [0, 4]),
        "a grid of 0 columns and 4 rows has no cells; give at least one column and one row"
    );
    assert!(
        words([0.0; 2], [1.0, -1.0], [4, 4]).starts_with("cells of size -1 from 0 make no grid along axis 1")
    );
    assert!(words([1e20, 0.0], [1.0; 2], [4, 4]).starts_with("line 1 across axis 0 is not beyond line 0"));
    let error = CartesianGrid::new([0.0; 2], [1.0; 2], [1 << 20, 1 << 20]).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::TooLarge);
    let huge = linear(&[rectangle([0.0, 0.0], [1e150, 1e150])]);
    assert_eq!(
        CutCells::new(&huge, grid([0.0; 2], [1.0; 2], [2, 2])).unwrap_err().kind(),
        ErrorKind::TooLarge
    );
    let curve = Curve::polyline(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]).unwrap();
    let far = grid([5.0, 5.0], [1.0; 2], [2, 2]);
    assert_eq!(CutCells::new(&YinSet::new(&[curve]).unwrap(), far).unwrap().count(Coverage::Empty), 4);
}

/// A random smooth curve around the origin.
fn blob(seed: u64, size: f64) -> Vec<[f64; 2]> {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut part = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1u64 << 31) as f64
    };
    let count = 12;
    (0..count)
        .map(|i| {
            let (sine, cosine) = (TAU * i as f64 / count as f64).sin_cos();
            let radius = size * (0.7 + 0.3 * part());
            [radius * cosine, radius * sine]
        })
        .collect()
}

/// The parts in cells: valid sets within their cells that add up to the set.
fn check_parts(set: &YinSet, grid: &CartesianGrid, about: &str) {
    let cells = CutCells::new(set, grid.clone()).unwrap();
    let [low, high] = set.bounding_box().unwrap();
    let [columns, rows] = grid.cell_counts();
    let is_covered = (0..2).all(|axis| {
        let lines = grid.lines(axis);
        lines[0] <= low[axis] && high[axis] <= lines[lines.len() - 1]
    });
    assert!(is_covered && set.is_bounded(), "{about}");
    let mut sum = 0.0;
    for row in 0..rows {
        for column in 0..columns {
            let [low, high] = grid.cell_box(column, row);
            let all = (high[0] - low[0]) * (high[1] - low[1]);
            let at = format!("{about}: cell {column} {row}");
            let Some(cell) = cells.cell(column, row) else {
                sum += if cells.coverage(column, row) == Coverage::Full { all } else { 0.0 };
                continue;
            };
            let part = cells.part(cell).unwrap_or_else(|error| panic!("{at}: {error}"));
            assert_eq!(part.validate().unwrap(), None, "{at}");
            let area = part.area().unwrap();
            assert!((area - cell.area()).abs() <= 1e-12 * all, "{at}: {area} {}", cell.area());
            if let Some([part_low, part_high]) = part.bounding_box() {
                for axis in 0..2 {
                    assert!(
                        part_low[axis] >= low[axis] - 1e-15 && part_high[axis] <= high[axis] + 1e-15,
                        "{at}"
                    );
                }
            }
            sum += area;
            // The same as the meet with the cell.
            let square = linear(&[rectangle(low, high)]);
            let meet = set.meet(&square).unwrap_or_else(|error| panic!("{at}: {error}"));
            assert!((meet.area().unwrap() - area).abs() <= 1e-10 * all, "{at}: {area} {:?}", meet.area());
        }
    }
    let whole = set.area().unwrap();
    assert!((sum - whole).abs() <= 1e-12 * whole, "{about}: {sum} {whole}");
}

#[test]
fn curved_parts_add_up_to_the_set() {
    for (seed, order) in [(1, 4), (2, 4), (3, 4), (4, 6), (5, 8), (6, 4)] {
        let order = Order::new(order).unwrap();
        let mut hole = blob(seed + 100, 0.45);
        hole.reverse();
        let set = YinSet::fit(&[blob(seed, 1.0), hole], &[], order, &EndCondition::Periodic).unwrap();
        check_parts(&set, &grid([-1.5, -1.5], [0.3, 0.3], [10, 10]), &format!("seed {seed}"));
        // Lines through knots: those on the axes are at angles of quarters.
        check_parts(&set, &grid([-1.5, -1.5], [0.5, 0.75], [6, 4]), &format!("seed {seed}, axes"));
        // Lines that touch the curves: through the extremes of their boxes.
        let boxes = [0, 1].map(|curve| set.curve(curve).bounding_box());
        let lines = [0, 1].map(|axis| {
            let mut lines = vec![-2.0, 0.0, 2.0];
            lines.extend(boxes.iter().flat_map(|own| own.map(|corner| corner[axis])));
            lines.sort_by(f64::total_cmp);
            lines
        });
        check_parts(&set, &CartesianGrid::with_lines(lines).unwrap(), &format!("seed {seed}, tangents"));
    }
}

#[test]
fn circles_between_the_lines_that_they_touch() {
    // Knots on the axes, where the circle touches lines of the grid, and cells of the size of the circle.
    for count in [4, 8, 16] {
        let circle = Curve::circle([0.0, 0.0], 1.0, count, Order::CUBIC).unwrap();
        let set = YinSet::new(&[circle]).unwrap();
        check_parts(&set, &grid([-1.0, -1.0], [1.0, 1.0], [2, 2]), &format!("{count} quarters"));
        check_parts(&set, &grid([-1.0, -1.0], [2.0, 2.0], [1, 1]), &format!("{count} whole"));
        check_parts(&set, &grid([-2.0, -2.0], [1.0, 1.0], [4, 4]), &format!("{count} outside"));
    }
}

#[test]
fn straight_sides_of_curved_sets_on_lines() {
    // Half a disk on a line, and a square with a bulge, at order 4: sides run along lines of the grid.
    let segment = |a: [f64; 2], b: [f64; 2]| Curve::polyline(&[a, b]).unwrap().raised(Order::CUBIC).unwrap();
    let bow = [[2.0, 0.0], [2.0, 2.5], [-2.0, 2.5], [-2.0, 0.0]];
    let side = segment([-2.0, 0.0], [2.0, 0.0]);
    let controls = [&bow[..], &side.controls()[1..]].concat();
    let half = Curve::from_controls(Order::CUBIC, controls, vec![0.0, 1.0, 2.0]).unwrap();
    let square = [[2.0, 0.0], [2.0, 2.0], [-2.0, 2.0]];
    let bulge = [[-2.0, 2.0], [-1.0, 1.0], [-1.0, 1.0], [-2.0, 0.0]];
    let mut controls = vec![[-2.0, 0.0]];
    for pair in [[[-2.0, 0.0], square[0]], [square[0], square[1]], [square[1], square[2]]] {
        controls.extend_from_slice(&segment(pair[0], pair[1]).controls()[1..]);
    }
    controls.extend_from_slice(&bulge[1..]);
    let bulged = Curve::from_controls(Order::CUBIC, controls, vec![0.0, 1.0, 2.0, 3.0, 4.0]).unwrap();
    for (number, curve) in [half, bulged].into_iter().enumerate() {
        let set = YinSet::new(&[curve]).unwrap();
        for spacing in [1.0, 0.5, 0.75, 2.0] {
            let count = (8.0 / spacing) as usize + 1;
            check_parts(&set, &grid([-4.0, -4.0], [spacing; 2], [count; 2]), &format!("{number} {spacing}"));
        }
    }
}
