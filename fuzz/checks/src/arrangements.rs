//! Arrangements and Booleans of small integers, where everything is known exactly by another way.

use arbitrary::{Arbitrary, Unstructured};
use coface::algebra::{RaggedArray, Rational};
use coface::answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
use coface::arrange::boolean::{BooleanFormula, InsideRule};
use coface::arrange::planar::{PlanarArrangement, PlanarOverlay};
use coface::arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
use coface::geometry::Positions;
use coface::{FaceId, Model, VertexId, homology};

/// Segments with any finite coordinates make an arrangement whose boundaries of boundaries are zero. Without coordinates that are too large
/// or small, its faces cover what the walk around it encloses.
pub fn arrange_plane(bytes: &[u8]) {
    let coordinates: Vec<f64> = bytes
        .chunks_exact(8)
        .take(80)
        .map(|chunk| f64::from_le_bytes(chunk.try_into().expect("chunks are of eight bytes")))
        .filter(|x| x.is_finite())
        .collect();
    let count = coordinates.len() / 4 * 2;
    let Ok(positions) = Positions::from_flat(2, coordinates[..2 * count].to_vec()) else { return };
    let segments: Vec<[u32; 2]> = (0..count as u32 / 2).map(|i| [2 * i, 2 * i + 1]).collect();
    if let Ok(arrangement) = PlanarArrangement::new(&positions, &segments) {
        let complex = arrangement.coarse_complex().expect("boundaries of boundaries are zero");
        let groups = homology(&complex);
        assert_eq!(groups.betti_numbers().first().copied().unwrap_or(0), arrangement.component_count());
        // With all bounded faces filled nothing is left but the parts that no face lies around.
        let filled =
            homology(&arrangement.chain_complex().expect("faces with holes are cut")).betti_numbers();
        let mut components = 0..arrangement.component_count();
        let outer =
            components.by_ref().filter(|&part| arrangement.face_around_component(part).is_none()).count();
        assert_eq!(filled.iter().sum::<usize>(), outer, "{filled:?}");
        assert_eq!(filled.first().copied().unwrap_or(0), outer);
        let faces = (0..arrangement.face_count()).map(|face| Some(FaceId::new(face))).chain([None]);
        let sum = sum(faces.map(|face| arrangement.exact_area(face)));
        assert_eq!(sum, Rational::from(0), "what the faces cover is what the outside leaves");
    }
}

/// Rings of two regions in the plane.
#[derive(Arbitrary, Debug)]
struct Regions {
    rings: Vec<(bool, Vec<(u8, u8)>)>,
    rule: u8,
}

/// Booleans of rings of small integers: areas as fractions satisfy inclusion and exclusion, and points of a raster are where the winding
/// numbers of the rings say.
pub fn boolean_plane(bytes: &[u8]) {
    let Ok(mut regions) = Regions::arbitrary(&mut Unstructured::new(bytes)) else { return };
    regions.rings.truncate(6);
    let rule = [InsideRule::Nonzero, InsideRule::Positive, InsideRule::Odd][usize::from(regions.rule) % 3];
    let (mut flat, mut rings, mut region_of) = (Vec::new(), RaggedArray::new(), Vec::new());
    for (region, ring) in &regions.rings {
        let first = (flat.len() / 2) as u32;
        for &(x, y) in ring.iter().take(12) {
            flat.extend([f64::from(x % 16), f64::from(y % 16)]);
        }
        rings.push(&(first..(flat.len() / 2) as u32).collect::<Vec<u32>>());
        region_of.push(u32::from(*region));
    }
    let positions = Positions::from_flat(2, flat).expect("an even number of finite coordinates");
    let Ok(overlay) = PlanarOverlay::new(&positions, &rings, &region_of) else { return };
    let area = |text: &str| {
        let formula = BooleanFormula::parse(text, &[]).expect("a formula");
        let polygons = overlay.boolean(&formula, rule).expect("few vertices");
        // What the rings of the result enclose, by the rule that each ring has its polygon on its left.
        let corners: Vec<Vec<[f64; 2]>> =
            (0..polygons.rings().len()).map(|ring| polygons.ring_positions(ring).collect()).collect();
        for (x, y) in (0..17 * 17).map(|i| (f64::from(i % 17) - 0.382, f64::from(i / 17) - 0.419)) {
            let is_in = |region: u32| {
                let of_region = rings.iter().zip(&region_of).filter(|&(_, &of)| of == region);
                let number: i32 = of_region
                    .map(|(ring, _)| {
                        let ring: Vec<[f64; 2]> = ring
                            .iter()
                            .map(|&v| {
                                let point = positions.point(VertexId::from_u32(v));
                                [point[0], point[1]]
                            })
                            .collect();
                        winding_number(&ring, [x, y])
                    })
                    .sum();
                rule.is_inside(number)
            };
            let expected = formula.evaluate(|input| is_in(input as u32));
            let found: i32 = corners.iter().map(|ring| winding_number(ring, [x, y])).sum();
            let found = found + i32::from(polygons.has_exterior());
            // Corners of the result are rounded: near its boundary nothing is said.
            if corners.iter().all(|ring| distance(ring, [x, y]) > 1e-9) {
                assert_eq!(found, i32::from(expected), "{text} at {x}, {y}");
            }
        }
        polygons.exact_area()
    };
    let [a, b, union, meet, xor, difference] =
        ["a & a", "b | b", "a | b", "a & b", "a ^ b", "a - b"].map(area);
    assert_eq!(sum([union.clone(), meet.clone()]), sum([a.clone(), b]));
    assert_eq!(sum([xor, meet.clone()]), union);
    assert_eq!(sum([difference, meet]), a);
}

fn sum(fractions: impl IntoIterator<Item = Rational>) -> Rational {
    fractions.into_iter().fold(Rational::from(0), |mut sum, fraction| {
        sum += &fraction;
        sum
    })
}

/// How often a ring winds around a point that is not on it.
fn winding_number(ring: &[[f64; 2]], [x, y]: [f64; 2]) -> i32 {
    let sides = ring.iter().zip(ring.iter().cycle().skip(1));
    sides
        .map(|(&[ax, ay], &[bx, by])| {
            let side = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
            if ay <= y && by > y && side > 0.0 {
                1
            } else if ay > y && by <= y && side < 0.0 {
                -1
            } else {
                0
            }
        })
        .sum()
}

/// How far a point is from a ring.
fn distance(ring: &[[f64; 2]], [x, y]: [f64; 2]) -> f64 {
    let sides = ring.iter().zip(ring.iter().cycle().skip(1));
    sides
        .map(|(&[ax, ay], &[bx, by])| {
            let (dx, dy) = (bx - ax, by - ay);
            let length = dx * dx + dy * dy;
            let t =
                if length > 0.0 { (((x - ax) * dx + (y - ay) * dy) / length).clamp(0.0, 1.0) } else { 0.0 };
            (ax + t * dx - x).hypot(ay + t * dy - y)
        })
        .fold(f64::INFINITY, f64::min)
}

/// Polygons in space, of small integers.
#[derive(Arbitrary, Debug)]
struct Polygons {
    triangles: Vec<[(u8, u8, u8); 3]>,
    merge_coplanar: bool,
}

/// Triangles of small integers make a complex in space whose boundaries of boundaries are zero, without homology beyond that of its cells: with
/// the outside added the complex is a sphere as long as it is connected.
pub fn arrange_space(bytes: &[u8]) {
    let Ok(mut plan) = Polygons::arbitrary(&mut Unstructured::new(bytes)) else { return };
    plan.triangles.truncate(10);
    let corners = plan.triangles.iter().flatten();
    let flat = corners.flat_map(|&(x, y, z)| [x, y, z].map(|x| f64::from(x % 6))).collect();
    let positions = Positions::from_flat(3, flat).expect("three coordinates a corner");
    let polygons =
        RaggedArray::from_lists((0..plan.triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]));
    let Ok(polygons) = SpatialPolygons::from_polygons(positions, polygons) else { return };
    let options = SpatialOptions::new().merge_coplanar(plan.merge_coplanar);
    let Ok(arrangement) = SpatialArrangement::new(&polygons, &options) else { return };
    let complex = arrangement.chain_complex().expect("boundaries of boundaries are zero");
    let groups = homology(&complex);
    let betti = groups.betti_numbers();
    assert_eq!(groups.euler_characteristic(), complex.euler_characteristic());
    assert!(groups.torsion().iter().all(|orders| orders.is_empty()), "nothing in space has torsion");
    // Every bounded hole of the faces is filled by a cell.
    assert_eq!(betti.get(2).copied().unwrap_or(0), 0, "each void is a cell");
    assert_eq!(betti.get(3).copied().unwrap_or(0), 0, "cells are bounded");
    let finer = arrangement.chain_map_to_fine().expect("the coarse cells are chains of the fine ones");
    drop(finer);
}

/// Two lots of boxes, and two tetrahedra.
#[derive(Arbitrary, Debug)]
struct Solids {
    boxes: [Vec<[(u8, u8); 3]>; 2],
    tetrahedra: [[(u8, u8, u8); 4]; 2],
    are_boxes: bool,
}

/// Booleans of boxes of small integers have the volumes that counting unit cubes gives; those of two tetrahedra satisfy inclusion and
/// exclusion.
pub fn boolean_space(bytes: &[u8]) {
    let Ok(solids) = Solids::arbitrary(&mut Unstructured::new(bytes)) else { return };
    let spans = |lot: &[[(u8, u8); 3]]| -> Vec<[[u8; 2]; 3]> {
        let span = |&(a, b): &(u8, u8)| [a % 5, a % 5 + 1 + b % 4];
        lot.iter().take(2).map(|axes| [span(&axes[0]), span(&axes[1]), span(&axes[2])]).collect()
    };
    let lots = [spans(&solids.boxes[0]), spans(&solids.boxes[1])];
    let models = if solids.are_boxes {
        [0, 1].map(|lot| model_of_boxes(&lots[lot]))
    } else {
        [0, 1].map(|lot| model_of_tetrahedron(&solids.tetrahedra[lot]))
    };
    let [Some(first), Some(second)] = models else { return };
    let scene = SceneArrangement::of([("a", &first), ("b", &second)], &SpatialRequest::default());
    let scene = scene.expect("closed solids are arranged");
    assert!(scene.products_are_zero().expect("a complex"));
    let volume = |text: &str| {
        let request = SolidRequest::of(BooleanFormula::parse(text, &[]).expect("a formula"));
        let solid = SolidBoolean::of(&scene, &request).expect("closed solids are combined");
        solid.answer().expect("every result is described");
        let found = solid.volume().expect("bounded results have volumes");
        if solids.are_boxes {
            let cubes = (0..9 * 9 * 9u16).map(|i| [i % 9, i / 9 % 9, i / 81].map(|x| x as u8));
            let is_in = |lot: usize, cube: [u8; 3]| {
                lots[lot].iter().any(|spans| spans.iter().zip(cube).all(|(&[a, b], x)| a <= x && x < b))
            };
            let count = cubes.filter(|&cube| request.formula.evaluate(|input| is_in(input, cube))).count();
            assert_eq!(found, count as f64, "the volume of {text}");
        }
        found
    };
    let [a, b, union, meet, xor, difference] =
        ["a & a", "b | b", "a | b", "a & b", "a ^ b", "a - b"].map(volume);
    for (found, expected) in [(union + meet, a + b), (xor + meet, union), (difference + meet, a)] {
        assert!((found - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{found} is not {expected}");
    }
}

fn model_of_boxes(boxes: &[[[u8; 2]; 3]]) -> Option<Model> {
    let (mut flat, mut polygons) = (Vec::new(), RaggedArray::new());
    for spans in boxes {
        let first = (flat.len() / 3) as u32;
        for i in 0..8 {
            flat.extend([0, 1, 2].map(|axis| f64::from(spans[axis][i >> axis & 1])));
        }
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        faces.iter().for_each(|face| polygons.push(&face.map(|corner| first + corner)));
    }
    let positions = Positions::from_flat(3, flat).ok()?;
    Model::from_polygons(positions, polygons).ok().filter(|model| !model.polygons().is_empty())
}

fn model_of_tetrahedron(corners: &[(u8, u8, u8); 4]) -> Option<Model> {
    let points = corners.map(|(x, y, z)| [x, y, z].map(|x| f64::from(x % 8)));
    let edge = |i: usize| [0, 1, 2].map(|axis| points[i][axis] - points[0][axis]);
    let [a, b, c] = [edge(1), edge(2), edge(3)];
    let volume = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0]);
    let faces: [[u32; 3]; 4] = match volume {
        v if v > 0.0 => [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
        v if v < 0.0 => [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]],
        _ => return None,
    };
    let positions = Positions::from_flat(3, points.concat()).ok()?;
    Model::from_polygons(positions, RaggedArray::from_lists(faces)).ok()
}
