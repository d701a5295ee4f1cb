//! Overlays of regions against arrangements with winding numbers, and laws of Boolean algebra, in fractions.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::{EdgeId, ErrorKind, FaceId, HalfedgeId, VertexId};
use coface_algebra::{RaggedArray, Rational, UnionFind};
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_arrange::planar::{PlanarOptions, PlanarOverlay, PlanarPolygons, PlanarRegions, VertexSource};
use coface_geometry::Positions;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Rings by their corners, with their regions.
type Drawing = Vec<(u32, Vec<[f64; 2]>)>;

struct Input {
    positions: Positions,
    rings: RaggedArray,
    regions: Vec<u32>,
}

fn input(drawing: &Drawing) -> Input {
    let (mut flat, mut rings, mut regions) = (Vec::new(), RaggedArray::new(), Vec::new());
    for (region, ring) in drawing {
        let first = flat.len() as u32 / 2;
        flat.extend_from_slice(ring.as_flattened());
        rings.push(&(first..first + ring.len() as u32).collect::<Vec<_>>());
        regions.push(*region);
    }
    Input { positions: Positions::from_flat(2, flat).unwrap(), rings, regions }
}

fn overlay(drawing: &Drawing) -> PlanarOverlay {
    let Input { positions, rings, regions } = input(drawing);
    let overlay = PlanarOverlay::new(&positions, &rings, &regions).unwrap();
    assert!(overlay.region_count() <= regions.iter().max().map_or(0, |&r| r as usize + 1));
    overlay
}

fn ring_area(polygons: &PlanarPolygons<'_>, ring: usize) -> Rational {
    let points: Vec<[Rational; 2]> = polygons
        .rings()
        .list(ring)
        .iter()
        .map(|&v| polygons.point(VertexId::from_u32(v)).to_rational())
        .collect();
    let mut doubled = Rational::ZERO;
    for (i, p) in points.iter().enumerate() {
        let q = &points[(i + 1) % points.len()];
        doubled += &(&(&p[0] * &q[1]) - &(&p[1] * &q[0]));
    }
    &doubled * &Rational::from(2).inverse().unwrap()
}

/// All that polygons promise.
fn check(polygons: &PlanarPolygons<'_>, input: &Input) {
    let [vertices, edges, count] = polygons.f_vector();
    assert_eq!(polygons.rings().item_count(), edges);
    let mut passes = vec![0; vertices];
    for ring in polygons.rings().iter() {
        assert!(ring.len() >= 3);
        assert_eq!(ring.iter().collect::<BTreeSet<_>>().len(), ring.len(), "rings are simple");
        ring.iter().for_each(|&vertex| passes[vertex as usize] += 1);
    }
    assert!(passes.iter().all(|&passes| passes > 0));
    let pinched: Vec<usize> = polygons.pinch_vertices().map(VertexId::index).collect();
    assert_eq!(pinched, (0..vertices).filter(|&v| passes[v] > 1).collect::<Vec<_>>());
    let numbers: Vec<u32> = polygons.polygons().items().to_vec();
    assert_eq!(numbers, (0..polygons.rings().len() as u32).collect::<Vec<_>>());
    let mut total = Rational::ZERO;
    for (polygon, rings) in polygons.polygons().iter().enumerate() {
        let areas: Vec<Rational> = rings.iter().map(|&ring| ring_area(polygons, ring as usize)).collect();
        let sum = areas.iter().fold(Rational::ZERO, |sum, area| &sum + area);
        let holes = if polygon < count {
            assert!(areas[0] > Rational::ZERO && sum > Rational::ZERO);
            assert!((polygons.areas()[polygon] / sum.to_f64() - 1.0).abs() < 1e-14);
            &areas[1..]
        } else {
            &areas[..]
        };
        assert!(holes.iter().all(|area| *area < Rational::ZERO));
        total += &sum;
    }
    assert_eq!(total, polygons.exact_area());
    // Vertices and edges lie on what they come from.
    let points: Vec<[f64; 2]> = input.positions.as_flat().as_chunks::<2>().0.to_vec();
    let mut sides = Vec::new();
    for ring in input.rings.iter() {
        for (i, &p) in ring.iter().enumerate() {
            sides.push([p, ring[(i + 1) % ring.len()]].map(|p| points[p as usize]));
        }
    }
    for vertex in (0..vertices).map(VertexId::new) {
        match polygons.source(vertex) {
            VertexSource::Given(point) => assert_eq!(polygons.point(vertex).rounded(), points[point]),
            VertexSource::Crossing(pair) => {
                assert!(pair.iter().all(|&side| polygons.point(vertex).side_of(sides[side]).is_eq()));
            }
        }
    }
    let mut edge = 0;
    for ring in polygons.rings().iter() {
        for (i, &p) in ring.iter().enumerate() {
            let ends = [p, ring[(i + 1) % ring.len()]].map(|v| polygons.point(VertexId::from_u32(v)));
            // Along the axis on which the edge is longer the sides reach from one end to the other.
            let [p, q] = ends.map(|end| end.rounded());
            let axis = usize::from((p[1] - q[1]).abs() > (p[0] - q[0]).abs());
            let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
            for side in polygons.sides_of_edge(EdgeId::new(edge)) {
                assert!(ends.iter().all(|end| end.side_of(sides[side]).is_eq()));
                low = low.min(sides[side][0][axis].min(sides[side][1][axis]));
                high = high.max(sides[side][0][axis].max(sides[side][1][axis]));
            }
            assert!(low <= p[axis].min(q[axis]) && p[axis].max(q[axis]) <= high);
            edge += 1;
        }
    }
}

/// Corners on a small grid, where much touches and overlaps.
fn grid_drawing() -> impl Strategy<Value = Drawing> {
    let corner = (0i32..6, 0i32..6).prop_map(|(x, y)| [f64::from(x), f64::from(y)]);
    prop::collection::vec((0u32..3, prop::collection::vec(corner, 0..8)), 0..7)
}

/// Rectangles, some turned inside out, some twice, on a coarse grid.
fn rectangles() -> impl Strategy<Value = Drawing> {
    let one = (0u32..3, 0i32..6, 0i32..6, 1i32..5, 1i32..5, any::<bool>(), 1usize..3);
    prop::collection::vec(one, 0..9).prop_map(|all| {
        let mut drawing = Vec::new();
        for (region, x, y, width, height, is_reversed, copies) in all {
            let mut ring = [[x, y], [x + width, y], [x + width, y + height], [x, y + height]]
                .map(|p| p.map(f64::from))
                .to_vec();
            if is_reversed {
                ring.reverse();
            }
            drawing.extend(std::iter::repeat_n((region, ring), copies));
        }
        drawing
    })
}

/// Long curves with few crossings, and numbers that are no fractions of two.
fn curves() -> impl Strategy<Value = Drawing> {
    let curve = (0u32..3, prop::collection::vec(1i32..40, 3..40), -3i32..4, -3i32..4);
    prop::collection::vec(curve, 1..5).prop_map(|curves| {
        let ring = |(region, radii, x, y): (u32, Vec<i32>, i32, i32)| {
            let step = std::f64::consts::TAU / radii.len() as f64;
            let corner = |(i, &radius): (usize, &i32)| {
                let (sine, cosine) = (i as f64 * step).sin_cos();
                let radius = 1.0 + 0.01 * f64::from(radius);
                [0.1 * f64::from(x) + radius * cosine, 0.1 * f64::from(y) + radius * sine]
            };
            (region, radii.iter().enumerate().map(corner).collect())
        };
        curves.into_iter().map(ring).collect()
    })
}

/// Rings far apart and within each other.
fn islands() -> impl Strategy<Value = Drawing> {
    let island = (0u32..3, 0i32..5, 0i32..5, 1i32..5, any::<bool>());
    prop::collection::vec(island, 0..12).prop_map(|islands| {
        let ring = |(region, x, y, size, is_diamond): (u32, i32, i32, i32, bool)| {
            let [x, y] = [x, y].map(|x| 10.0 * f64::from(x));
            let size = f64::from(size);
            let ring = if is_diamond {
                vec![[x - size, y], [x, y - size], [x + size, y], [x, y + size]]
            } else {
                vec![[x - size, y - size], [x + size, y - size], [x + size, y + size], [x - size, y + size]]
            };
            (region, ring)
        };
        islands.into_iter().map(ring).collect()
    })
}

fn drawings() -> impl Strategy<Value = Drawing> {
    prop_oneof![3 => grid_drawing(), 3 => rectangles(), 1 => curves(), 2 => islands()]
}

/// The number of connected parts of faces with these winding numbers, joined across edges.
fn part_count(regions: &PlanarRegions, is_inside: impl Fn(&[(u32, i32)]) -> bool) -> usize {
    let arrangement = regions.arrangement();
    let inside: Vec<bool> =
        (0..arrangement.face_count()).map(|f| is_inside(regions.winding_numbers(FaceId::new(f)))).collect();
    let mut parts = UnionFind::new(inside.len());
    for edge in 0..arrangement.edge_count() {
        let sides = [0, 1].map(|side| arrangement.face_of(HalfedgeId::new(2 * edge + side)));
        if let [Some(left), Some(right)] = sides
            && inside[left.index()]
            && inside[right.index()]
        {
            parts.unite(left.to_u32(), right.to_u32());
        }
    }
    let roots: BTreeSet<u32> =
        (0..inside.len() as u32).filter(|&f| inside[f as usize]).map(|f| parts.find(f)).collect();
    roots.len()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn overlays_are_arrangements_with_winding_numbers(drawing in drawings()) {
        let input = input(&drawing);
        let regions = PlanarRegions::new(&input.positions, &input.rings, &input.regions).unwrap();
        let overlay = overlay(&drawing);
        // Strokes to a point and back enclose nothing and are left out; in an arrangement they cut faces.
        let is_stroke = |(_, ring): &(u32, Vec<[f64; 2]>)| {
            (0..ring.len()).filter(|&i| ring[i] != ring[(i + 1) % ring.len()]).count() < 3
        };
        if !drawing.iter().any(is_stroke) {
            prop_assert_eq!(overlay.face_count(), regions.arrangement().face_count());
        }
        let mut areas: BTreeMap<Vec<(u32, i32)>, Rational> = BTreeMap::new();
        for face in (0..regions.arrangement().face_count()).map(FaceId::new) {
            let winding = regions.winding_numbers(face).to_vec();
            *areas.entry(winding).or_insert(Rational::ZERO) += &regions.arrangement().exact_area(Some(face));
        }
        for (winding, area) in areas {
            if winding.is_empty() {
                continue;
            }
            let found = overlay.select(|found| found == winding).unwrap();
            check(&found, &input);
            prop_assert!(!found.has_exterior());
            prop_assert_eq!(found.exact_area(), area, "winding {:?}", winding);
            prop_assert_eq!(found.f_vector()[2], part_count(&regions, |found| found == winding));
            // What is around it has the same rings, the other way round.
            let rest = overlay.select(|found| found != winding).unwrap();
            check(&rest, &input);
            prop_assert!(rest.has_exterior());
            prop_assert_eq!(&rest.exact_area() + &found.exact_area(), Rational::ZERO);
            prop_assert_eq!(rest.positions().len(), found.positions().len());
        }
    }

    #[test]
    fn laws_of_boolean_algebra_hold(drawing in drawings(), rule in 0usize..3) {
        let rule = [InsideRule::Nonzero, InsideRule::Positive, InsideRule::Odd][rule];
        let overlay = overlay(&drawing);
        let area = |text: &str| {
            let formula = BooleanFormula::parse(text, &[]).unwrap();
            let found = overlay.boolean(&formula, rule).unwrap();
            (found.exact_area(), found.has_exterior(), found.f_vector(), found.hole_count())
        };
        let plain = |text: &str| area(text).0;
        prop_assert_eq!(&plain("a | b") + &plain("a & b"), &plain("a") + &plain("b"));
        prop_assert_eq!(&plain("a - b") + &plain("a & b"), plain("a"));
        prop_assert_eq!(&plain("a ^ b") + &plain("a & b"), plain("a | b"));
        prop_assert_eq!(area("!(a | b)"), area("!a & !b"));
        prop_assert_eq!(area("!(a & b)"), area("!a | !b"));
        prop_assert_eq!(area("a | a"), area("a"));
        prop_assert_eq!(area("a ^ (b ^ c)"), area("(a ^ b) ^ c"));
        prop_assert_eq!(area("a & (b | c)"), area("(a & b) | (a & c)"));
        prop_assert_eq!(plain("a ^ a"), Rational::ZERO);
        prop_assert_eq!(area("!!a"), area("a"));
        prop_assert_eq!(&plain("!c") + &plain("c"), Rational::ZERO);
    }

    /// What has exact coordinates can be laid over again.
    #[test]
    fn results_are_inputs_again(drawing in prop_oneof![rectangles(), islands()]) {
        let first = overlay(&drawing);
        let union = first.select(|windings| !windings.is_empty()).unwrap();
        prop_assume!(union.is_exactly_rounded());
        let mut again = drawing.iter().map(|(_, ring)| (0, ring.clone())).collect::<Drawing>();
        for ring in 0..union.rings().len() {
            again.push((1, union.ring_positions(ring).collect()));
        }
        let result = overlay(&again.iter().filter(|(region, _)| *region == 1).cloned().collect());
        let same = result.select(|windings| windings == [(1, 1)]).unwrap();
        prop_assert_eq!(same.exact_area(), union.exact_area());
        prop_assert_eq!(same.f_vector(), union.f_vector());
        prop_assert_eq!(same.hole_count(), union.hole_count());
        prop_assert!(result.select(|windings| !windings.is_empty() && windings != [(1, 1)]).unwrap().rings().is_empty());
        // Each ring of the input lies within.
        let outside = overlay(&again);
        let outside = outside.select(|windings| windings.len() == 1 && windings[0].0 == 0).unwrap();
        prop_assert!(outside.rings().is_empty());
    }
}

#[test]
fn touching_parts_are_polygons_of_their_own_and_pinches_are_named() {
    // Two squares that share a corner; then a square with two holes that touch each other and the outer ring.
    let square = |x: f64, y: f64, size: f64| vec![[x, y], [x + size, y], [x + size, y + size], [x, y + size]];
    let drawing = vec![(0, square(0., 0., 1.)), (0, square(1., 1., 1.))];
    let found = overlay(&drawing);
    let union = found.select(|windings| !windings.is_empty()).unwrap();
    assert_eq!((union.f_vector(), union.hole_count(), union.pinch_vertices().len()), ([7, 8, 2], 0, 1));
    let diamond = |x: f64, y: f64| vec![[x - 1., y], [x, y - 1.], [x + 1., y], [x, y + 1.]];
    let drawing = vec![(0, square(0., 0., 4.)), (1, diamond(1., 2.)), (1, diamond(3., 2.))];
    let found = overlay(&drawing);
    let rest = found.select(|windings| windings == [(0, 1)]).unwrap();
    // The holes cut the square in two; the lower part has the corner at the left side once more.
    assert_eq!((rest.f_vector()[2], rest.hole_count(), rest.pinch_vertices().len()), (2, 0, 3));
    assert_eq!(rest.areas(), [6.0, 6.0]);
    let input = input(&drawing);
    check(&rest, &input);
    // A hole that touches the outer ring in one point stays a hole.
    let drawing = vec![(0, square(0., 0., 4.)), (1, diamond(1., 2.))];
    let found = overlay(&drawing);
    let rest = found.select(|windings| windings == [(0, 1)]).unwrap();
    assert_eq!((rest.f_vector(), rest.hole_count(), rest.pinch_vertices().len()), ([8, 9, 1], 1, 1));
    assert_eq!(rest.area(), 14.0);
}

#[test]
fn degenerate_rings_are_ordinary() {
    let empty = overlay(&Vec::new());
    assert_eq!((empty.face_count(), empty.meeting_count()), (0, 0));
    assert!(empty.select(|_| true).unwrap().rings().is_empty());
    // A point, a stroke, a spike on a triangle, a repeated corner.
    let drawing = vec![
        (0, vec![[5., 5.]]),
        (0, vec![[6., 6.], [7., 7.]]),
        (0, vec![[0., 0.], [4., 0.], [4., 0.], [4., 4.], [6., 6.], [4., 4.], [0., 0.]]),
    ];
    let found = overlay(&drawing);
    let inside = found.select(|windings| windings == [(0, 1)]).unwrap();
    assert_eq!(inside.exact_area(), Rational::from(8));
    check(&inside, &input(&drawing));
    // A ring that runs back over itself encloses nothing.
    let found = overlay(&vec![(0, vec![[0., 0.], [1., 1.], [3., 1.], [1., 1.]])]);
    assert!(found.select(|windings| !windings.is_empty()).unwrap().rings().is_empty());
}

#[test]
fn impossible_overlays_are_refused() {
    let positions = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 1.]).unwrap();
    let rings = RaggedArray::from_lists([[0, 1, 2]]);
    let kind = |rings: &RaggedArray, regions: &[u32]| {
        PlanarOverlay::new(&positions, rings, regions).map(|_| ()).unwrap_err().kind()
    };
    assert_eq!(kind(&rings, &[]), ErrorKind::Shape);
    assert_eq!(kind(&RaggedArray::from_lists([[0, 1, 3]]), &[0]), ErrorKind::NotInComplex);
    let options = PlanarOptions::new().max_cells(6);
    let refused = PlanarOverlay::with_options(&positions, &rings, &[0], &options);
    assert_eq!(refused.map(|_| ()).unwrap_err().kind(), ErrorKind::TooLarge);
    let options = options.max_cells(7);
    assert!(PlanarOverlay::with_options(&positions, &rings, &[0], &options).is_ok());
}
