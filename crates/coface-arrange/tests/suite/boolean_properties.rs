//! What holds for all Boolean combinations, in the plane and in space, against fractions.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::reference::cells::arrangement;
use crate::reference::models::Walks;
use crate::reference::space::Polygon;
use crate::reference::{Random, soup_count, soups};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, FaceId, VertexId};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use coface_arrange::boolean::{BooleanFormula, CellSelection, InsideRule, WindingNumbers};
use coface_arrange::planar::PlanarRegions;
use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
use coface_geometry::Positions;
use rayon::prelude::*;

/// Pairs of formulas that are the same set whatever the inputs are.
const LAWS: &[(&str, &str)] = &[
    ("!(a | b)", "!a & !b"),
    ("!(a & b)", "!a | !b"),
    ("a | a", "a"),
    ("a & a", "a"),
    ("a - b", "a & !b"),
    ("(a - b) | (a & b)", "a"),
    ("a | (a & b)", "a"),
    ("a ^ b", "(a | b) - (a & b)"),
    ("a ^ a", "a & !a"),
    ("!!a", "a"),
    ("a & (b | a)", "a"),
];

/// The same with three inputs.
const LAWS_OF_THREE: &[(&str, &str)] = &[
    ("(a ^ b) ^ c", "a ^ (b ^ c)"),
    ("a ^ b ^ c", "c ^ a ^ b"),
    ("a & (b | c)", "(a & b) | (a & c)"),
    ("a | (b & c)", "(a | b) & (a | c)"),
    ("a - (b | c)", "(a - b) - c"),
    ("(a | b) & c", "(a & c) | (b & c)"),
];

/// Polygons, cells and winding numbers, whoever made them.
struct Arranged {
    complex: ChainComplex,
    measures: Vec<f64>,
    winding: WindingNumbers,
    positions: Positions,
    /// For each face that is not in one plane its triangles.
    bent: Vec<Option<Vec<[[f64; 3]; 3]>>>,
}

impl Arranged {
    fn select(&self, text: &str) -> CellSelection {
        let formula = BooleanFormula::parse(text, &[]).unwrap();
        CellSelection::by_formula(&self.winding, &formula, InsideRule::Nonzero).unwrap()
    }

    fn measure(&self, selection: &CellSelection) -> f64 {
        selection.cells().map(|cell| self.measures[cell.index()]).sum()
    }

    /// Counts, and what is enclosed with the winding numbers of each cell, in an order of their own.
    fn summary(&self) -> (Vec<usize>, Vec<(Vec<i32>, f64)>) {
        let cells = (0..self.measures.len())
            .map(|cell| (self.winding.of_cell(CellId::new(cell)).to_vec(), self.measures[cell]));
        let mut cells: Vec<_> = cells.collect();
        cells.sort_by(|x, y| x.0.cmp(&y.0).then(x.1.total_cmp(&y.1)));
        (self.complex.f_vector().to_vec(), cells)
    }

    /// What the laws of sets say of the cells.
    fn check_laws(&self, input_count: usize) {
        for &(left, right) in LAWS {
            assert_eq!(self.select(left), self.select(right), "{left} is {right}");
        }
        if input_count > 2 {
            for &(left, right) in LAWS_OF_THREE {
                assert_eq!(self.select(left), self.select(right), "{left} is {right}");
            }
        }
        let measure = |text: &str| self.measure(&self.select(text));
        let (both, either) = (measure("a") + measure("b"), measure("a | b") + measure("a & b"));
        assert!(close(both, either), "inclusion and exclusion: {both} and {either}");
        // The rest has the same boundary, the other way around.
        let (union, rest) = (self.select("a | b"), self.select("!(a | b)"));
        let [here, there] = [union, rest].map(|selection| selection.boundary(&self.complex).unwrap());
        let turned = there.facets().iter().map(|&(facet, sign)| (facet, sign.times(Sign::Minus)));
        assert!(here.facets().iter().copied().eq(turned));
    }
}

fn close(x: f64, y: f64) -> bool {
    (x - y).abs() <= 1e-9 * x.abs().max(y.abs()).max(1e-3)
}

fn is_same(x: &(Vec<usize>, Vec<(Vec<i32>, f64)>), y: &(Vec<usize>, Vec<(Vec<i32>, f64)>)) -> bool {
    // Cells with equal winding numbers and equal volumes may change places: their volumes are the same then.
    x.0 == y.0 && x.1.len() == y.1.len() && x.1.iter().zip(&y.1).all(|(c, d)| c.0 == d.0 && close(c.1, d.1))
}

/// The exact arrangement of walks, each polygon of one input; on request with rounded vertices, so that it is an input again.
fn in_space(walks: &Walks, input_of_polygon: &[usize], is_snapped: bool) -> Arranged {
    let inputs = input_of_polygon.iter().map(|&input| input as u32).collect();
    let polygons =
        SpatialPolygons::new(walks.positions(), walks.lists(), walks.polygon_of_walk.clone()).unwrap();
    let options = SpatialOptions::default();
    let mut found = SpatialArrangement::new(&polygons.with_inputs(inputs).unwrap(), &options).unwrap();
    if is_snapped {
        found = found.snapped(&options).unwrap();
    }
    Arranged {
        complex: found.coarse_complex().unwrap(),
        measures: found.volumes().unwrap(),
        winding: found.winding_numbers().unwrap(),
        positions: found.positions().clone(),
        bent: (0..found.complex().face_count()).map(|face| bent(&found, FaceId::new(face))).collect(),
    }
}

/// The corners of the triangles of a face that rounding bent.
fn bent(found: &SpatialArrangement, face: FaceId) -> Option<Vec<[[f64; 3]; 3]>> {
    let place = |corner: u32| {
        let point = found.fine_triangles().positions().point(VertexId::from_u32(corner));
        [point[0], point[1], point[2]]
    };
    let triangles = || found.triangulated(face).unwrap().into_iter().map(|own| own.map(place)).collect();
    (!found.is_planar(face)).then(triangles)
}

fn inputs_of(polygons: &[Polygon]) -> Vec<usize> {
    polygons.iter().map(|polygon| polygon.input).collect()
}

/// Closed walks that make up the boundary of a face.
fn walks_around(complex: &ChainComplex, face: usize) -> Vec<Vec<u32>> {
    let mut sides: Vec<[u32; 2]> = complex
        .boundary_matrix(2)
        .unwrap()
        .column(face)
        .iter()
        .map(|(edge, sign)| {
            let column = complex.boundary_matrix(1).unwrap().column(edge);
            let (rows, entries) = (column.rows(), column.entries());
            if (entries[0] < 0) == (sign > 0) { [rows[0], rows[1]] } else { [rows[1], rows[0]] }
        })
        .collect();
    let mut walks = Vec::new();
    while let Some([start, mut at]) = sides.pop() {
        let mut walk = vec![start];
        while at != start {
            walk.push(at);
            let next = sides.iter().position(|side| side[0] == at).unwrap();
            at = sides.swap_remove(next)[1];
        }
        walks.push(walk);
    }
    walks
}

/// The faces as polygons of their own.
fn as_walks(found: &Arranged, faces: impl Iterator<Item = (usize, bool)>) -> Walks {
    let mut walks = Walks::default();
    for (face, is_turned) in faces {
        if let Some(Some(triangles)) = found.bent.get(face) {
            for &[a, b, c] in triangles {
                walks.add(vec![if is_turned { vec![c, b, a] } else { vec![a, b, c] }]);
            }
            continue;
        }
        let own = walks_around(&found.complex, face).into_iter().map(|mut walk| {
            if is_turned {
                walk.reverse();
            }
            let place = |v: u32| {
                let point = found.positions.point(VertexId::from_u32(v));
                [point[0], point[1], point[2]]
            };
            walk.into_iter().map(place).collect()
        });
        walks.add(own.collect());
    }
    walks
}

#[test]
fn combinations_in_space_are_those_of_fractions() {
    (0..soup_count(150)).into_par_iter().for_each(|seed| {
        let (polygons, count) = soups::solids(seed);
        let expected = arrangement(&polygons, count);
        let found = in_space(&Walks::of(&polygons), &inputs_of(&polygons), false);
        found.check_laws(count);
        let (counts, cells) = found.summary();
        assert_eq!(counts, expected.f_vector());
        let mut known: Vec<(Vec<i32>, f64)> = (expected.cells.iter())
            .map(|cell| (cell.windings.iter().map(|&n| n as i32).collect(), cell.volume.to_f64()))
            .collect();
        known.sort_by(|x, y| x.0.cmp(&y.0).then(x.1.total_cmp(&y.1)));
        assert!(is_same(&(counts.clone(), cells), &(counts, known)), "soup {seed}");
        for (text, condition) in [
            ("a | b", (|n| n[0] != 0 || n[1] != 0) as fn(&[i64]) -> bool),
            ("a & b", |n| n[0] != 0 && n[1] != 0),
            ("a - b", |n| n[0] != 0 && n[1] == 0),
            ("a ^ b", |n| (n[0] != 0) != (n[1] != 0)),
        ] {
            let volume = found.measure(&found.select(text));
            assert!(close(volume, expected.volume_where(condition).to_f64()), "soup {seed}: {text}");
        }
    });
}

#[test]
fn results_in_space_are_inputs_again() {
    (0..soup_count(150)).into_par_iter().for_each(|seed| {
        let (polygons, _) = soups::solids(seed);
        let found = in_space(&Walks::of(&polygons), &inputs_of(&polygons), true);
        // All faces arranged again are what they were.
        let face_count = found.complex.cell_count(2);
        let again = as_walks(&found, (0..face_count).map(|face| (face, false)));
        let polygons_again =
            SpatialPolygons::new(again.positions(), again.lists(), again.polygon_of_walk).unwrap();
        let again = SpatialArrangement::new(&polygons_again, &SpatialOptions::default()).unwrap();
        if found.bent.iter().all(Option::is_none) {
            assert_eq!(again.f_vector(), found.complex.f_vector(), "soup {seed}");
        }
        assert_eq!(again.f_vector()[3], found.complex.cell_count(3), "soup {seed}");
        assert_eq!(again.f_vector()[2], again.polygon_count(), "soup {seed}");
        let has_one = |face| again.polygons_of_face(FaceId::new(face)).len() == 1;
        assert!((0..again.polygon_count()).all(has_one), "soup {seed}");
        let [mut here, mut there] = [found.measures.clone(), again.volumes().unwrap()];
        here.sort_by(f64::total_cmp);
        there.sort_by(f64::total_cmp);
        assert!(here.iter().zip(&there).all(|(&x, &y)| close(x, y)), "soup {seed}: {here:?} {there:?}");
        // The boundary of a combination, combined with an input, is the formula of all.
        for (first, then) in [("a | b", "(a | b) - b"), ("a - b", "(a - b) - b"), ("a & b", "a & b - b")] {
            let selection = found.select(first);
            let boundary = selection.boundary(&found.complex).unwrap();
            let facets = boundary.facets().iter();
            let mut walks =
                as_walks(&found, facets.map(|&(facet, sign)| (facet.index(), sign == Sign::Minus)));
            let mut input_of_polygon = vec![0; walks.polygon_count as usize];
            for polygon in polygons.iter().filter(|polygon| polygon.input == 1) {
                walks.add_polygon(polygon);
                input_of_polygon.push(1);
            }
            let combined = in_space(&walks, &input_of_polygon, false);
            if input_of_polygon.first() == Some(&0) {
                let enclosed = combined.measure(&combined.select("a"));
                assert!(close(enclosed, found.measure(&selection)), "soup {seed}: {first}");
                let once = combined.measure(&combined.select("a - b"));
                let direct = found.measure(&found.select(then));
                // Rounding has moved the first operand, but not the second: slivers are left.
                assert!((once - direct).abs() < 1e-9, "soup {seed}: {then} is {direct}, in two steps {once}");
            }
        }
    });
}

#[test]
fn order_and_motions_change_nothing_in_space() {
    (0..soup_count(100)).into_par_iter().for_each(|seed| {
        let (polygons, _) = soups::solids(seed);
        let here = in_space(&Walks::of(&polygons), &inputs_of(&polygons), false).summary();
        let mut random = Random::new(seed);
        let mut moved = polygons.clone();
        for i in (1..moved.len()).rev() {
            moved.swap(i, random.below(i as u64 + 1) as usize);
        }
        for polygon in &mut moved {
            for walk in &mut polygon.walks {
                let by = random.below(walk.len() as u64) as usize;
                walk.rotate_left(by);
            }
        }
        let there = in_space(&Walks::of(&moved), &inputs_of(&moved), false).summary();
        assert!(is_same(&here, &there), "soup {seed}: in another order");
        // Axes in a circle, then a power of two, then a shift.
        let mut walks = Walks::of(&polygons);
        for point in walks.flat.chunks_exact_mut(3) {
            point.rotate_left(1);
            point.iter_mut().for_each(|x| *x = *x * 4.0 + 32.0);
        }
        let there = in_space(&walks, &inputs_of(&polygons), false).summary();
        let scaled = (here.0.clone(), here.1.iter().map(|(n, v)| (n.clone(), 64.0 * v)).collect());
        assert!(is_same(&scaled, &there), "soup {seed}: moved");
        // In the mirror all winds the other way.
        let mut walks = Walks::of(&polygons);
        walks.flat.chunks_exact_mut(3).for_each(|point| point[0] = -point[0]);
        let there = in_space(&walks, &inputs_of(&polygons), false).summary();
        let mut mirrored =
            (here.0, here.1.into_iter().map(|(n, v)| (n.iter().map(|n| -n).collect(), v)).collect());
        let cells: &mut Vec<(Vec<i32>, f64)> = &mut mirrored.1;
        cells.sort_by(|x, y| x.0.cmp(&y.0).then(x.1.total_cmp(&y.1)));
        assert!(is_same(&mirrored, &there), "soup {seed}: in the mirror");
    });
}

/// The arrangement of rings, with winding numbers by the chain complex.
fn in_the_plane(rings: &[Vec<[i64; 2]>], regions: &[u32], region_count: usize) -> Arranged {
    let flat = rings.iter().flatten().flatten().map(|&x| x as f64).collect();
    let mut next = 0..;
    let lists: Vec<Vec<u32>> = rings.iter().map(|ring| next.by_ref().take(ring.len()).collect()).collect();
    let positions = Positions::from_flat(2, flat).unwrap();
    let found = PlanarRegions::new(&positions, &RaggedArray::from_lists(&lists), regions).unwrap();
    let arrangement = found.arrangement();
    let complex = arrangement.coarse_complex().unwrap();
    // The ends of each side, and its region.
    let sides = lists.iter().zip(regions).flat_map(|(list, &region)| {
        (0..list.len()).map(move |i| (list[i] as usize, list[(i + 1) % list.len()] as usize, region as usize))
    });
    let sides: Vec<(usize, usize, usize)> = sides.collect();
    let mut terms = Vec::new();
    for edge in 0..arrangement.edge_count() {
        for &side in arrangement.segments_of_edges().list(edge) {
            let (from, to, region) = sides[side as usize];
            let is_up = arrangement.vertex_of_point(from) < arrangement.vertex_of_point(to);
            terms.push((edge, region, if is_up { 1 } else { -1 }));
        }
    }
    let inputs = SparseMatrix::from_entries(arrangement.edge_count(), region_count, terms).unwrap();
    let winding = WindingNumbers::new(&complex, &inputs).unwrap();
    for face in 0..arrangement.face_count() {
        // The second method for the numbers.
        let mut expected = vec![0; region_count];
        found
            .winding_numbers(FaceId::new(face))
            .iter()
            .for_each(|&(region, n)| expected[region as usize] = n);
        assert_eq!(winding.of_cell(CellId::new(face)), expected);
    }
    Arranged {
        complex,
        measures: arrangement.areas(),
        winding,
        positions: arrangement.positions().clone(),
        bent: Vec::new(),
    }
}

#[test]
fn combinations_in_the_plane_keep_the_laws() {
    (0..soup_count(300)).into_par_iter().for_each(|seed| {
        let (rings, regions) = soups::rings(seed);
        let found = in_the_plane(&rings, &regions, 3);
        if found.complex.cell_count(2) == 0 {
            return;
        }
        found.check_laws(3);
        let here = found.summary();
        // Another order, and another first corner.
        let turned: Vec<Vec<[i64; 2]>> = rings
            .iter()
            .rev()
            .map(|ring| {
                let mut ring = ring.clone();
                ring.rotate_left(1);
                ring
            })
            .collect();
        let turned_regions: Vec<u32> = regions.iter().rev().copied().collect();
        let there = in_the_plane(&turned, &turned_regions, 3).summary();
        assert!(is_same(&here, &there), "soup {seed}: in another order");
        // A quarter turn, a power of two and a shift.
        let moved: Vec<Vec<[i64; 2]>> =
            rings.iter().map(|ring| ring.iter().map(|&[x, y]| [16 - 8 * y, 8 * x + 5]).collect()).collect();
        let there = in_the_plane(&moved, &regions, 3).summary();
        let scaled = (here.0.clone(), here.1.iter().map(|(n, a)| (n.clone(), 64.0 * a)).collect());
        assert!(is_same(&scaled, &there), "soup {seed}: moved");
        // The boundary of the union encloses its area.
        let boundary = found.select("a | b | c").boundary(&found.complex).unwrap();
        let doubled: f64 = (boundary.facets().iter())
            .map(|&(edge, sign)| {
                let point = |vertex: usize| found.positions.point(VertexId::new(vertex));
                let ends = found.complex.boundary_matrix(1).unwrap().column(edge.index());
                // Vertices rise along edges of the plane.
                let [p, q] = [0, 1].map(|i| point(ends.rows()[i] as usize));
                f64::from(sign.to_i32()) * (p[0] * q[1] - p[1] * q[0])
            })
            .sum();
        assert!(close(0.5 * doubled, found.measure(&found.select("a | b | c"))), "soup {seed}");
    });
}
