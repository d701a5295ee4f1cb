//! Validity of polygons as they are drawn, and rounding that always ends.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::{EdgeId, RaggedArray, VertexId};
use coface_arrange::planar::{PlanarArrangement, PlanarOverlay, are_valid_polygons, polygon_faults};
use coface_geometry::Positions;
use proptest::prelude::*;

/// Corners, rings and polygons of a text with `;` between polygons, `|` between rings, `,` between corners.
fn polygons_of(text: &str) -> (Positions, RaggedArray, RaggedArray) {
    let mut flat = Vec::new();
    let (mut rings, mut lists) = (RaggedArray::new(), RaggedArray::new());
    for polygon in text.split(';') {
        let first = rings.len() as u32;
        for ring in polygon.split('|') {
            let start = flat.len() as u32 / 2;
            flat.extend(
                ring.split([' ', ',']).filter(|word| !word.is_empty()).map(|x| x.parse::<f64>().unwrap()),
            );
            rings.push(&(start..flat.len() as u32 / 2).collect::<Vec<u32>>());
        }
        lists.push(&(first..rings.len() as u32).collect::<Vec<u32>>());
    }
    (Positions::from_flat(2, flat).unwrap(), rings, lists)
}

/// The kinds of the faults of polygons, with the places.
fn faults_of(text: &str) -> Vec<(&'static str, [f64; 2])> {
    let (positions, rings, polygons) = polygons_of(text);
    let faults = polygon_faults(&positions, &rings, &polygons).unwrap();
    faults.iter().map(|fault| (fault.kind.name(), fault.point)).collect()
}

#[test]
fn each_fault_makes_polygons_invalid() {
    for (text, why) in [
        ("0 0, 9 0, 9 9, 0 9 | 1 1, 1 2, 2 1", "a hole"),
        ("0 0, 9 0, 9 9, 0 9 | 0 1, 1 2, 2 1", "a hole that touches the outer ring once"),
        ("0 0, 9 0, 9 9, 0 9; 9 3, 10 1, 12 4, 9 7, 11 4", "polygons that touch twice"),
        ("0 0, 9 0, 9 9, 0 9 | 1 1, 1 8, 8 8, 8 1; 2 2, 3 2, 3 3", "a polygon in a hole of another"),
        ("0 0, 9 0, 9 9, 0 9 | 2 2, 2 4, 4 4 | 4 4, 4 6, 6 6", "holes that touch once"),
    ] {
        let (positions, rings, polygons) = polygons_of(text);
        assert!(are_valid_polygons(&positions, &rings, &polygons, false).unwrap(), "{why}");
        assert_eq!(faults_of(text), [], "{why}");
    }
    for (text, fault) in [
        ("0 0, 2 2, 2 0, 0 2", "a bow tie"),
        ("0 0, 4 0, 4 4, 4 6, 4 4, 0 4", "a spike"),
        ("0 0, 4 0, 2 0, 2 3", "a vertex within the side before"),
        ("0 0, 1 0", "a ring there and back"),
        ("0 0, 9 0, 9 9, 0 9 | 1 1, 1 1, 1 1", "a ring of no length"),
        ("0 0, 4 0, 4 4, 2 0, 0 4", "a ring that touches itself"),
        ("0 0, 9 0, 9 9, 0 9 | 11 1, 11 2, 12 1", "a hole outside"),
        ("0 0, 9 0, 9 9, 0 9 | 1 1, 1 8, 8 8, 8 1 | 2 2, 2 3, 3 2", "a hole in a hole"),
        ("0 0, 9 0, 9 9, 0 9 | 0 1, 0 2, 2 1", "a hole along the outer ring"),
        ("0 0, 9 0, 9 9, 0 9 | 0 4, 4 9, 4 4", "a hole that touches the outer ring twice"),
        ("0 0, 9 0, 9 9, 0 9; 8 8, 12 8, 12 12", "polygons that cross"),
        ("0 0, 9 0, 9 9, 0 9; 9 3, 12 3, 9 5", "polygons that share a part of an edge"),
        ("0 0, 9 0, 9 9, 0 9; 2 2, 3 2, 3 3", "a polygon in a polygon"),
        ("0 0, 9 0, 9 9, 0 9; 20 0, 29 0, 29 9 | 1 1, 1 2, 2 1", "a hole in another polygon than its own"),
        ("0 0, 9 0, 9 9, 0 9 | 0 4, 4 5, 4 3 | 4 5, 9 4, 6 3", "a chain of holes from side to side"),
    ] {
        let (positions, rings, polygons) = polygons_of(text);
        assert!(!are_valid_polygons(&positions, &rings, &polygons, false).unwrap(), "{fault}");
        assert!(!faults_of(text).is_empty(), "{fault}");
    }
}

#[test]
fn faults_have_kinds_and_places() {
    for (text, faults) in [
        ("0 0, 2 2, 2 0, 0 2", &[("ring_crosses_itself", [1., 1.])][..]),
        ("0 0, 4 0, 4 4, 4 6, 4 4, 0 4", &[("spike", [4., 4.])]),
        ("0 0, 1 0", &[("too_few_points", [0., 0.])]),
        ("0 0, 4 0, 4 4, 2 0, 0 4", &[("ring_touches_itself", [2., 0.])]),
        ("0 0, 9 0, 9 9, 0 9 | 11 1, 11 2, 12 1", &[("hole_outside", [11., 2.])]),
        ("0 0, 9 0, 9 9, 0 9 | 1 1, 1 8, 8 8, 8 1 | 2 2, 2 3, 3 2", &[("holes_nested", [2., 3.])]),
        ("0 0, 9 0, 9 9, 0 9 | 0 1, 0 2, 2 1", &[("rings_overlap", [0., 1.])]),
        ("0 0, 9 0, 9 9, 0 9 | 0 0, 0 9, 9 9, 9 0", &[("duplicate_ring", [0., 0.])]),
        ("0 0, 9 0, 9 9, 0 9 | 0 4, 4 9, 4 4", &[("interior_disconnected", [4., 9.])]),
        ("0 0, 9 0, 9 9, 0 9 | 8 8, 8 10, 10 8", &[("rings_cross", [8., 9.]), ("rings_cross", [9., 8.])]),
        ("0 0, 9 0, 9 9, 0 9; 9 3, 12 3, 9 5", &[("polygons_overlap", [9., 3.])]),
        ("0 0, 9 0, 9 9, 0 9; 2 2, 3 2, 3 3", &[("polygons_nested", [2., 2.])]),
        (
            "0 0, 9 0, 9 9, 0 9; 8 8, 12 8, 12 12",
            &[("polygons_cross", [9., 8.]), ("polygons_cross", [9., 9.])],
        ),
        // Two faults at once.
        (
            "0 0, 9 0, 9 9, 0 9 | 11 1, 11 2, 12 1 | 1 1, 2 2, 2 1, 1 2",
            &[("ring_crosses_itself", [1.5, 1.5]), ("hole_outside", [11., 2.])],
        ),
    ] {
        assert_eq!(faults_of(text), faults, "{text}");
    }
}

#[test]
fn walls_are_allowed_between_polygons_only() {
    let flat = vec![0., 0., 2., 0., 2., 2., 0., 2., 4., 0., 4., 2.];
    let positions = Positions::from_flat(2, flat).unwrap();
    let rings = RaggedArray::from_lists([[0, 1, 2, 3], [1, 4, 5, 2]]);
    let both = RaggedArray::from_lists([[0], [1]]);
    assert!(are_valid_polygons(&positions, &rings, &both, true).unwrap());
    assert!(!are_valid_polygons(&positions, &rings, &both, false).unwrap());
    assert!(!are_valid_polygons(&positions, &rings, &RaggedArray::from_lists([[0, 1]]), true).unwrap());
}

/// The arrangement of closed rings.
fn arranged(rings: &[&[[f64; 2]]]) -> PlanarArrangement {
    let (mut flat, mut segments) = (Vec::new(), Vec::new());
    for ring in rings {
        let start = flat.len() as u32;
        flat.extend_from_slice(ring);
        let end = flat.len() as u32;
        segments
            .extend((start..end).map(|corner| [corner, if corner + 1 == end { start } else { corner + 1 }]));
    }
    PlanarArrangement::new(&Positions::from_flat(2, flat.concat()).unwrap(), &segments).unwrap()
}

fn edge_ends(arrangement: &PlanarArrangement) -> Vec<[u32; 2]> {
    (0..arrangement.edge_count()).map(|e| arrangement.ends(EdgeId::new(e)).map(VertexId::to_u32)).collect()
}

/// Two triangles along one diagonal: their crossings move over each other from round to round.
#[test]
fn rounding_ends_where_rounds_did_not() {
    let arrangement = arranged(&[
        &[[2.4489212000000027, 48.7672806], [2.4509811, 48.7665939], [2.4502945, 48.7659073]],
        &[[2.4406815, 48.7755203], [2.4489212, 48.7672806], [2.4509811, 48.7665939]],
    ]);
    let snapped = arrangement.snapped().unwrap();
    assert!(snapped.arrangement().is_exactly_rounded() && snapped.round_count() < 20);
    for vertex in (0..arrangement.vertex_count()).map(VertexId::new) {
        let from = arrangement.positions().point(vertex);
        let to = snapped.arrangement().positions().point(snapped.place(vertex));
        assert!((0..2).all(|axis| (from[axis] - to[axis]).abs() <= 4.0 * 48.0 * f64::EPSILON));
    }
}

fn is_on_grid(x: f64, inverse: f64) -> bool {
    (x * inverse).round() / inverse == x
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Two methods: faults that are listed, and winding numbers with the joints of rings.
    #[test]
    fn what_has_no_fault_is_valid(
        polygons in prop::collection::vec(
            prop::collection::vec(prop::collection::vec(prop::array::uniform2(0i32..6), 3..6), 1..4), 1..3
        )
    ) {
        let text: Vec<String> = polygons.into_iter().map(|rings| {
            let rings = rings.into_iter().map(|ring| {
                let corners = ring.into_iter().map(|[x, y]| format!("{x} {y}"));
                corners.collect::<Vec<_>>().join(",")
            });
            rings.collect::<Vec<_>>().join("|")
        }).collect();
        let text = text.join(";");
        let (positions, rings, polygons) = polygons_of(&text);
        let is_valid = are_valid_polygons(&positions, &rings, &polygons, false).unwrap();
        let faults = faults_of(&text);
        prop_assert_eq!(is_valid, faults.is_empty(), "{}: {:?}", text, faults);
    }
}

proptest! {
    /// Segments of a few units of a grid and finer parts: all vertices end on it, nothing crosses, and again nothing moves.
    #[test]
    fn grids_have_all_vertices(
        soup in prop::collection::vec(prop::array::uniform4(-3000i32..3000), 1..12), steps in prop::sample::select(vec![0.1, 0.25, 0.01, 3.0])
    ) {
        let flat: Vec<f64> = soup.concat().into_iter().map(|x| f64::from(x) / 700.0).collect();
        let ends: Vec<[u32; 2]> = (0..soup.len() as u32).map(|s| [2 * s, 2 * s + 1]).collect();
        let arrangement = PlanarArrangement::new(&Positions::from_flat(2, flat).unwrap(), &ends).unwrap();
        let snapped = arrangement.snapped_to_grid(steps).unwrap();
        let result = snapped.arrangement();
        prop_assert!(result.is_exactly_rounded());
        for &x in result.positions().as_flat() {
            prop_assert!(if steps < 1.0 { is_on_grid(x, 1.0 / steps) } else { x % steps == 0.0 }, "{} of {}", x, steps);
        }
        let drawn = PlanarArrangement::new(result.positions(), &edge_ends(result)).unwrap();
        prop_assert_eq!(drawn.f_vector(), result.f_vector());
        prop_assert!(result.segments_of_edges().iter().all(|segments| segments.len() == 1));
        for vertex in (0..arrangement.vertex_count()).map(VertexId::new) {
            let from = arrangement.positions().point(vertex);
            let to = result.positions().point(snapped.place(vertex));
            prop_assert!((0..2).all(|axis| (from[axis] - to[axis]).abs() <= steps * 0.500001));
        }
        let again = drawn.snapped_to_grid(steps).unwrap();
        prop_assert_eq!(again.arrangement().positions(), result.positions());
        prop_assert_eq!(edge_ends(again.arrangement()), edge_ends(result));
    }

    /// Overlays of rings on small integers are valid polygons; moving one vertex of them is found out, or harmless.
    #[test]
    fn polygons_of_overlays_are_valid(
        corners in prop::collection::vec(prop::collection::vec(prop::array::uniform2(0i32..9), 3..8), 1..4)
    ) {
        let mut flat = Vec::new();
        let mut rings = RaggedArray::new();
        for ring in &corners {
            let start = flat.len() as u32;
            flat.extend(ring.iter().map(|point| point.map(f64::from)));
            rings.push(&(start..flat.len() as u32).collect::<Vec<u32>>());
        }
        // Multiples of all differences: crossings are integers mostly, and where not, this is left out.
        let scaled = flat.concat().into_iter().map(|x| x * 2520.0).collect();
        let overlay = PlanarOverlay::new(&Positions::from_flat(2, scaled).unwrap(), &rings, &vec![0; rings.len()]).unwrap();
        let found = overlay.select(|windings| windings.first().is_some_and(|&(_, by)| by % 2 != 0)).unwrap();
        prop_assume!(found.is_exactly_rounded());
        prop_assert!(are_valid_polygons(found.positions(), found.rings(), found.polygons(), false).unwrap());
    }
}

#[test]
fn grids_that_are_no_grids_are_refused() {
    let arrangement = arranged(&[&[[0., 0.], [9., 0.], [9., 9.], [0., 9.]]]);
    for (step, fault) in [(0.0, "no step"), (-1.0, "no step"), (f64::NAN, "no step"), (1e-16, "too fine")] {
        let error = arrangement.snapped_to_grid(step).unwrap_err();
        assert!(error.to_string().contains(fault) && error.cure().is_some(), "{error}");
    }
}
