//! Regions, rounding and gift wrapping of planar arrangements: second methods, properties and real maps.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use coface_algebra::{EdgeId, FaceId, VertexId};
use coface_algebra::{RaggedArray, SparseMatrix};
use coface_arrange::planar::{PlanarArrangement, PlanarRegions, gift_wrapped_faces};
use coface_geometry::Positions;
use proptest::prelude::*;
use serde_json::Value;
use std::collections::BTreeMap;

fn arranged(flat: Vec<f64>) -> PlanarArrangement {
    let ends: Vec<[u32; 2]> = (0..flat.len() as u32 / 4).map(|s| [2 * s, 2 * s + 1]).collect();
    PlanarArrangement::new(&Positions::from_flat(2, flat).unwrap(), &ends).unwrap()
}

fn edge_ends(arrangement: &PlanarArrangement) -> Vec<[u32; 2]> {
    (0..arrangement.edge_count()).map(|e| arrangement.ends(EdgeId::new(e)).map(VertexId::to_u32)).collect()
}

/// Coordinates of segments from uniform points in the unit square in uniform directions.
fn random_segments(count: usize, length: f64, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut random = || {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let segments = (0..count).map(|_| {
        let [x, y, turn] = [random(), random(), random()];
        let angle = std::f64::consts::PI * turn;
        [x, y, x + length * angle.cos(), y + length * angle.sin()]
    });
    segments.flatten().collect()
}

type Column = Vec<(usize, i32)>;

/// The walks around all faces as chains.
fn walks_as_chains(arrangement: &PlanarArrangement) -> Vec<Column> {
    let mut chains = Vec::new();
    for face in (0..arrangement.face_count()).map(|f| Some(FaceId::new(f))).chain([None]) {
        for walk in arrangement.walks(face) {
            let mut chain: Column =
                walk.iter().map(|&h| (h as usize / 2, if h.is_multiple_of(2) { 1 } else { -1 })).collect();
            chain.sort_unstable();
            chains.push(chain);
        }
    }
    chains.sort();
    chains
}

fn wrapped(arrangement: &PlanarArrangement) -> SparseMatrix {
    let complex = arrangement.coarse_complex().unwrap();
    let rotation = RaggedArray::from_lists((0..arrangement.vertex_count()).map(|vertex| {
        let around = arrangement.halfedges_around(VertexId::new(vertex));
        around.map(|h| h.to_u32() / 2).collect::<Vec<_>>()
    }));
    gift_wrapped_faces(complex.boundary_matrix(1).unwrap(), &rotation).unwrap()
}

fn compare_with_gift_wrapping(arrangement: &PlanarArrangement) {
    let wrapped = wrapped(arrangement);
    let mut cycles: Vec<Column> =
        (0..wrapped.column_count()).map(|cycle| wrapped.column(cycle).iter().collect()).collect();
    cycles.sort();
    assert_eq!(cycles, walks_as_chains(arrangement));
    let boundary = arrangement.coarse_complex().unwrap();
    let boundary = boundary.boundary_matrix(1).unwrap();
    assert_eq!(boundary.first_nonzero_product_column(&wrapped).unwrap(), None);
}

#[test]
fn gift_wrapping_finds_the_faces_of_grids_and_of_random_segments() {
    for m in 1..7u32 {
        let lines = (0..=m).flat_map(|i| {
            let [i, m] = [i, m].map(f64::from);
            [[i, 0., i, m], [0., i, m, i]]
        });
        compare_with_gift_wrapping(&arranged(lines.flatten().collect()));
    }
    for (count, seed) in [(50, 42), (100, 42), (200, 42), (100, 5), (150, 6)] {
        compare_with_gift_wrapping(&arranged(random_segments(count, 0.4, seed)).pruned().unwrap());
    }
}

#[test]
fn gift_wrapping_refuses_bridges() {
    let arrangement = arranged(vec![0., 0., 1., 0., 1., 0., 0., 1., 0., 1., 0., 0., 0., 0., 2., 2.]);
    let complex = arrangement.coarse_complex().unwrap();
    let rotation = RaggedArray::from_lists((0..arrangement.vertex_count()).map(|vertex| {
        let around = arrangement.halfedges_around(VertexId::new(vertex));
        around.map(|h| h.to_u32() / 2).collect::<Vec<_>>()
    }));
    assert!(gift_wrapped_faces(complex.boundary_matrix(1).unwrap(), &rotation).is_err());
    assert!(gift_wrapped_faces(complex.boundary_matrix(1).unwrap(), &RaggedArray::new()).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn gift_wrapping_finds_the_orbits(
        soup in prop::collection::vec(prop::array::uniform4((-4i32..5).prop_map(f64::from)), 3..16)
    ) {
        let arrangement = arranged(soup.concat()).pruned().unwrap();
        if arrangement.edge_count() > 0 {
            compare_with_gift_wrapping(&arrangement);
        }
    }

    /// Rectangles on a grid, some clockwise: unit cells know their winding numbers.
    #[test]
    fn winding_numbers_are_those_of_cells(
        boxes in prop::collection::vec((0i32..8, 0i32..8, 1i32..6, 1i32..6, any::<bool>(), 0u32..4), 0..9)
    ) {
        let (mut flat, mut rings, mut regions) = (Vec::new(), RaggedArray::new(), Vec::new());
        let mut cells: BTreeMap<(i32, i32), BTreeMap<u32, i32>> = BTreeMap::new();
        for &(x, y, width, height, clockwise, region) in &boxes {
            let first = flat.len() as u32 / 2;
            let corners = [[x, y], [x + width, y], [x + width, y + height], [x, y + height]];
            flat.extend(corners.as_flattened().iter().map(|&x| f64::from(x)));
            let ring = [0, 1, 2, 3].map(|i| first + i);
            rings.push(&if clockwise { [ring[3], ring[2], ring[1], ring[0]] } else { ring });
            regions.push(region);
            for cell in (x..x + width).flat_map(|i| (y..y + height).map(move |j| (i, j))) {
                *cells.entry(cell).or_default().entry(region).or_default() += if clockwise { -1 } else { 1 };
            }
        }
        let mut expected: BTreeMap<Vec<(u32, i32)>, f64> = BTreeMap::new();
        for winding in cells.into_values() {
            let winding = winding.into_iter().filter(|&(_, number)| number != 0).collect();
            *expected.entry(winding).or_default() += 1.0;
        }
        let positions = Positions::from_flat(2, flat).unwrap();
        let found = PlanarRegions::new(&positions, &rings, &regions).unwrap();
        let mut areas: BTreeMap<Vec<(u32, i32)>, f64> = BTreeMap::new();
        for (face, area) in found.arrangement().areas().into_iter().enumerate() {
            *areas.entry(found.winding_numbers(FaceId::new(face)).to_vec()).or_default() += area;
        }
        // What no region winds around is also outside; cells that are not covered were not counted.
        for found in [&mut areas, &mut expected] {
            found.remove(&Vec::new());
        }
        prop_assert_eq!(areas, expected);
        prop_assert_eq!(found.region_count(), regions.iter().max().map_or(0, |&last| last as usize + 1));
    }

    /// Lines that nearly meet: rounding breaks some drawings, and snapping mends them.
    #[test]
    fn snapped_drawings_are_their_own_arrangements(
        soup in prop::collection::vec(prop::array::uniform4((-6i32..7, -1i64..2)), 2..14), offset in 0i32..3
    ) {
        let coordinate = |(tenths, ulps): (i32, i64)| {
            let x = f64::from(tenths) * 0.1 + f64::from(offset) * 1e3;
            f64::from_bits(x.to_bits().wrapping_add_signed(if x == 0.0 { 0 } else { ulps }))
        };
        let flat: Vec<f64> = soup.into_iter().flatten().map(coordinate).collect();
        let arrangement = arranged(flat);
        let drawn = PlanarArrangement::new(arrangement.positions(), &edge_ends(&arrangement)).unwrap();
        let certificate = arrangement.rounding_certificate().unwrap();
        if certificate.is_valid() {
            prop_assert_eq!(drawn.f_vector(), arrangement.f_vector());
            prop_assert_eq!(drawn.hole_count(), arrangement.hole_count());
        } else {
            let is_same = drawn.f_vector() == arrangement.f_vector() && drawn.hole_count() == arrangement.hole_count();
            let is_broken = !certificate.merged_vertices.is_empty() || !certificate.broken_edges.is_empty();
            prop_assert!(!is_same || is_broken || !certificate.turned_vertices.is_empty()
                || !certificate.moved_components.is_empty());
        }
        let snapped = arrangement.snapped().unwrap();
        let result = snapped.arrangement();
        let again = PlanarArrangement::new(result.positions(), &edge_ends(result)).unwrap();
        prop_assert!(result.is_exactly_rounded() && again.is_exactly_rounded());
        prop_assert_eq!(again.positions(), result.positions());
        prop_assert_eq!(again.coarse_complex().unwrap(), result.coarse_complex().unwrap());
        prop_assert!(again.rounding_certificate().unwrap().is_valid());
        // Provenance: segments whose pieces were not all rounded away are along some edge.
        prop_assert_eq!(snapped.segments_of_edges().len(), result.edge_count());
        prop_assert!(snapped.segments_of_edges().iter().all(|segments| !segments.is_empty()));
    }
}

#[test]
fn a_flipped_triangle_is_not_certified() {
    // The smallest numbers cannot tell crossings apart: what is left after rounding is broken, or certified rightly.
    let tiny = f64::from_bits(1);
    let flat =
        vec![0., 0., 3. * tiny, 2. * tiny, 0., 2. * tiny, 3. * tiny, 0., tiny, 0., 2. * tiny, 3. * tiny];
    let arrangement = arranged(flat);
    let certificate = arrangement.rounding_certificate().unwrap();
    let snapped = arrangement.snapped().unwrap();
    assert_eq!(certificate.is_valid(), snapped.arrangement().f_vector() == arrangement.f_vector());
    assert!(snapped.arrangement().is_exactly_rounded());
}

/// The polygons of a GeoJSON value: each a list of rings.
fn polygons(value: &Value, found: &mut Vec<Vec<Vec<[f64; 2]>>>) {
    let point = |value: &Value| {
        let numbers = value.as_array()?;
        Some([numbers.first()?.as_f64()?, numbers.get(1)?.as_f64()?])
    };
    let rings = |value: &Value| -> Option<Vec<Vec<[f64; 2]>>> {
        value.as_array()?.iter().map(|ring| ring.as_array()?.iter().map(point).collect()).collect()
    };
    match value {
        Value::Array(_) if rings(value).is_some_and(|rings| !rings.is_empty()) => found.extend(rings(value)),
        Value::Array(items) => items.iter().for_each(|item| polygons(item, found)),
        Value::Object(fields) => {
            for (key, field) in fields {
                if ["coordinates", "features", "geometry", "geometries"].contains(&key.as_str()) {
                    polygons(field, found);
                }
            }
        }
        _ => {}
    }
}

fn data(name: &str) -> Option<Value> {
    let Some(folder) = std::env::var_os("COFACE_DATA") else {
        println!("COFACE_DATA is not set: {name} is skipped");
        return None;
    };
    let text = std::fs::read_to_string(std::path::Path::new(&folder).join(name)).unwrap();
    Some(serde_json::from_str(&text).unwrap())
}

/// The regions of all polygons of maps, one region a polygon, and the map of each.
fn overlay(maps: &[Vec<Vec<Vec<[f64; 2]>>>]) -> (PlanarRegions, Vec<usize>) {
    let (mut flat, mut rings, mut regions, mut map_of) =
        (Vec::new(), RaggedArray::new(), Vec::new(), Vec::new());
    for (map, polygons) in maps.iter().enumerate() {
        for polygon in polygons {
            for ring in polygon {
                let first = flat.len() as u32 / 2;
                flat.extend(ring.iter().flatten());
                rings.push(&(first..first + ring.len() as u32).collect::<Vec<_>>());
                regions.push(map_of.len() as u32);
            }
            map_of.push(map);
        }
    }
    (PlanarRegions::new(&Positions::from_flat(2, flat).unwrap(), &rings, &regions).unwrap(), map_of)
}

/// The area of the faces inside maps as `inside` wants it; inside a polygon is where its rings wind an odd number of times.
fn area_where(regions: &PlanarRegions, map_of: &[usize], inside: impl Fn([bool; 2]) -> bool) -> f64 {
    let areas = regions.arrangement().areas();
    let faces = regions.faces_where(|winding| {
        let mut is_in = [false; 2];
        for &(region, number) in winding {
            is_in[map_of[region as usize]] |= number % 2 != 0;
        }
        inside(is_in)
    });
    faces.iter().map(|face| areas[face.index()]).sum()
}

fn close(found: f64, expected: f64) -> bool {
    // Facts are given with twelve digits.
    (found - expected).abs() <= 2e-11 * expected.abs().max(found.abs()) + 1e-12
}

#[test]
fn maps_have_their_known_areas_and_overlays() {
    let Some(manifest) = data("MANIFEST.json") else { return };
    let map = |name: &str| {
        let mut found = Vec::new();
        polygons(&data(name).unwrap(), &mut found);
        found
    };
    let mut seen = 0;
    for record in manifest["files"].as_array().unwrap() {
        let name = record["file"].as_str().unwrap();
        if record["format"] == "geojson" {
            let polygons = map(name);
            assert_eq!(polygons.len() as u64, record["polygons"].as_u64().unwrap(), "{name}");
            let (regions, map_of) = overlay(&[polygons]);
            let union = area_where(&regions, &map_of, |[a, _]| a);
            let expected = record["union"]["area"].as_f64().unwrap();
            // A ring that crosses itself is mended by a rule of its own there.
            if record["invalid_features"].as_array().is_none_or(Vec::is_empty) {
                assert!(close(union, expected), "{name}: {union}, not {expected}");
                seen += 1;
            }
            assert!(regions.arrangement().rounding_certificate().unwrap().is_valid(), "{name}");
        } else if name.ends_with("earcut-dude.json") {
            let mut found = Vec::new();
            polygons(&data(name).unwrap(), &mut found);
            let (regions, map_of) = overlay(&[found]);
            let area = area_where(&regions, &map_of, |[a, _]| a);
            assert!(close(area, record["area_shoelace"].as_f64().unwrap()), "{name}: {area}");
            assert_eq!(regions.arrangement().hole_count() as u64 + 1, record["rings"].as_u64().unwrap());
            seen += 1;
        }
    }
    assert_eq!(seen, 5);
    for record in manifest["overlays"].as_array().unwrap() {
        let [a, b] = ["a", "b"].map(|key| map(record[key].as_str().unwrap()));
        let (regions, map_of) = overlay(&[a, b]);
        let area = |inside: fn([bool; 2]) -> bool| area_where(&regions, &map_of, inside);
        let found = [
            ("union", area(|[a, b]| a || b)),
            ("intersection", area(|[a, b]| a && b)),
            ("a_minus_b", area(|[a, b]| a && !b)),
            ("b_minus_a", area(|[a, b]| b && !a)),
            ("symmetric_difference", area(|[a, b]| a != b)),
        ];
        for (key, area) in found {
            let expected = record[key]["area"].as_f64().unwrap();
            assert!(close(area, expected), "{key} of {}: {area}, not {expected}", record["a"]);
        }
    }
}
