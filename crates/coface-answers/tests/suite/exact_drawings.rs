//! Chains of arrangements and Booleans in the plane that keep exact points: the last result is that of all inputs at once.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::{EdgeId, FaceId, RaggedArray, Rational, VertexId};
use coface_answers::answer::{Remark, RemarkCode};
use coface_answers::{
    ArrangementMethod, ArrangementRequest, BooleanRequest, DrawingArrangement, DrawingOptions, PlanarDrawing,
    RegionBoolean, RegionSource,
};
use coface_arrange::boolean::BooleanFormula;
use coface_geometry::Positions;
use coface_io::{self as io, Format, Model};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

type Segments = Vec<[[f64; 2]; 2]>;

/// Segments, and points on their own.
fn lines(segments: &[[[f64; 2]; 2]], points: &[[f64; 2]]) -> Model {
    let flat: Vec<f64> = segments.as_flattened().iter().chain(points).flatten().copied().collect();
    let lists = (0..segments.len() as u32).map(|segment| [2 * segment, 2 * segment + 1]);
    Model::from_lines(Positions::from_flat(2, flat).unwrap(), RaggedArray::from_lists(lists)).unwrap()
}

fn polygon(corners: &[[f64; 2]]) -> Model {
    let text: Vec<String> =
        corners.iter().chain(&corners[..1]).map(|[x, y]| format!("{x:?} {y:?}")).collect();
    io::read(format!("POLYGON (({}))", text.join(", ")).as_bytes(), Format::Wkt).unwrap()
}

fn drawing(models: &[&Model]) -> PlanarDrawing {
    PlanarDrawing::new(models.iter().map(|model| ("drawn", *model)), RegionSource::Models).unwrap()
}

fn arranged(models: &[&Model], prune: bool) -> DrawingArrangement {
    let mut request = ArrangementRequest::default();
    (request.exact, request.prune) = (true, prune);
    DrawingArrangement::new(drawing(models), &request).unwrap()
}

fn combined(models: &[&Model], formula: &str) -> RegionBoolean {
    let mut request = BooleanRequest::default();
    request.exact = true;
    RegionBoolean::new(drawing(models), &BooleanFormula::parse(formula, &[]).unwrap(), &request).unwrap()
}

fn read(bytes: &[u8]) -> Model {
    io::read(bytes, Format::Json).unwrap()
}

fn file_of(arranged: &DrawingArrangement) -> Vec<u8> {
    let mut bytes = Vec::new();
    arranged.write(&mut bytes, Format::Json).unwrap();
    bytes
}

fn file_of_result(result: &RegionBoolean) -> Vec<u8> {
    let mut bytes = Vec::new();
    result.write(&mut bytes, Format::Json).unwrap();
    bytes
}

/// Coordinates that make crossings near each other: of a grid, of tenths, next to one number, and of all sizes.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-3i32..4).prop_map(f64::from),
        3 => (-3i32..4).prop_map(|x| f64::from(x) * 0.1),
        2 => (-3i32..4, -2i64..3)
            .prop_map(|(x, ulps)| f64::from_bits((f64::from(x) + 7.3).to_bits().wrapping_add_signed(ulps))),
        1 => (-9i32..10, -40i32..10).prop_map(|(m, e)| f64::from(m) * 2f64.powi(e)),
    ]
}

fn segment() -> impl Strategy<Value = [[f64; 2]; 2]> {
    prop_oneof![
        4 => prop::array::uniform2(prop::array::uniform2(coordinate())),
        // Nearly through one point.
        3 => (0.1f64..6.0, -2i64..3, 1.0f64..9.0).prop_map(|(angle, ulps, length)| {
            let (s, c) = angle.sin_cos();
            let middle = f64::from_bits((1.0f64 / 3.0).to_bits().wrapping_add_signed(ulps));
            [[middle - length * c, 1.0 / 3.0 - length * s], [middle + length * c, 1.0 / 3.0 + length * s]]
        }),
        // Long and thin: through two steps of the last place over a length of a million.
        1 => (-3i64..4, -3i64..4).prop_map(|(a, b)| {
            let height = |ulps| f64::from_bits(1.0f64.to_bits().wrapping_add_signed(ulps));
            [[-1e6, height(a)], [1e6, height(b)]]
        }),
    ]
}

/// Drawings, into which segments of those before come again: as they are, back, and parts of them.
fn drawings(steps: std::ops::Range<usize>, most: usize) -> impl Strategy<Value = Vec<Segments>> {
    let again = prop::collection::vec((any::<prop::sample::Index>(), 0..4u8), 0..3);
    let step = (prop::collection::vec(segment(), 1..most), again);
    prop::collection::vec(step, steps).prop_map(|steps| {
        let mut known = Segments::new();
        let drawing = |(own, again): (Segments, Vec<(prop::sample::Index, u8)>)| {
            let mut drawing = own;
            for (index, way) in again.into_iter().filter(|_| !known.is_empty()) {
                let [a, b] = *index.get(&known);
                let middle = [0, 1].map(|axis| (a[axis] + b[axis]) / 2.0);
                drawing.push([[a, b], [b, a], [a, middle], [middle, b]][usize::from(way)]);
            }
            known.extend_from_slice(&drawing);
            drawing
        };
        steps.into_iter().map(drawing).collect()
    })
}

/// One chain: each step arranges the file of the step before with a drawing more. Edges have sets of segments of all drawings.
fn agree(drawings: &[Segments], points: &[[f64; 2]]) -> Result<(), TestCaseError> {
    let models: Vec<Model> = drawings.iter().map(|own| lines(own, points)).collect();
    let mut last = arranged(&[&models[0]], false);
    let origins_of =
        |found: &DrawingArrangement, before: Option<&[BTreeSet<(usize, usize)>]>, step: usize| {
            let edges = found.provenance().edges;
            let of_edge = |own: &Vec<(usize, usize)>| {
                let mut origins = BTreeSet::new();
                for &(model, segment) in own {
                    match before {
                        Some(before) if model == 0 => origins.extend(before[segment].iter().copied()),
                        _ => {
                            origins.insert((step, segment));
                        }
                    }
                }
                origins
            };
            edges.iter().map(of_edge).collect::<Vec<_>>()
        };
    let mut origins = origins_of(&last, None, 0);
    for step in 1..models.len() {
        let bytes = file_of(&last);
        let file = read(&bytes);
        // The file alone is itself.
        let again = arranged(&[&file], false);
        prop_assert!(file_of(&again) == bytes, "arranged alone a file is another one");
        let next = arranged(&[&file, &models[step]], false);
        // Pieces of a file with faces are edges in another order.
        let edges = (0..last.arrangement().edge_count()).map(EdgeId::new);
        let number: BTreeMap<[u32; 2], usize> =
            edges.map(|edge| (last.arrangement().ends(edge).map(VertexId::to_u32), edge.index())).collect();
        let pieces = file.exact_segments().unwrap().pieces();
        let of_pieces: Vec<_> = pieces.iter().map(|piece| origins[number[&piece.ends]].clone()).collect();
        origins = origins_of(&next, Some(&of_pieces), step);
        let all: Vec<&Model> = models[..=step].iter().collect();
        let once = arranged(&all, false);
        prop_assert_eq!(next.arrangement().f_vector(), once.arrangement().f_vector());
        prop_assert_eq!(next.arrangement().component_count(), once.arrangement().component_count());
        prop_assert_eq!(next.arrangement().hole_count(), once.arrangement().hole_count());
        let areas = |found: &DrawingArrangement| -> Vec<Rational> {
            let faces = (0..found.arrangement().face_count()).map(FaceId::new);
            faces.map(|face| found.arrangement().exact_area(Some(face))).collect()
        };
        prop_assert_eq!(areas(&next), areas(&once));
        let expected: Vec<BTreeSet<(usize, usize)>> =
            once.provenance().edges.iter().map(|own| own.iter().copied().collect()).collect();
        prop_assert_eq!(&origins, &expected);
        for vertex in (0..next.arrangement().vertex_count()).map(VertexId::new) {
            let [own, other] = [&next, &once].map(|found| found.arrangement().point(vertex));
            prop_assert!(own.compare(&other).is_eq(), "{vertex:?}");
            let around =
                |found: &DrawingArrangement| found.arrangement().halfedges_around(vertex).collect::<Vec<_>>();
            prop_assert_eq!(around(&next), around(&once));
        }
        last = next;
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn chains_of_arrangements_are_one_arrangement(drawings in drawings(2..5, 6)) {
        agree(&drawings, &[])?;
    }

    #[test]
    fn points_on_their_own_stay_in_chains(
        drawings in drawings(2..4, 4), points in prop::collection::vec(prop::array::uniform2(coordinate()), 1..4),
    ) {
        agree(&drawings, &points)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn chains_of_ten_arrangements_are_one(drawings in drawings(10..11, 5)) {
        agree(&drawings, &[])?;
    }
}

type Point = [Rational; 2];

fn rational(point: [f64; 2]) -> Point {
    coface_geometry::predicates::PlanarPoint::given(point).to_rational()
}

/// Edges and vertices by fractions, all pairs of segments against each other.
#[derive(Clone, Default)]
struct Plain {
    edges: BTreeSet<[Point; 2]>,
    vertices: BTreeSet<Point>,
}

fn minus(a: &Point, b: &Point) -> Point {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

fn cross(a: &Point, b: &Point) -> Rational {
    &(&a[0] * &b[1]) - &(&a[1] * &b[0])
}

impl Plain {
    fn of(segments: &[[Point; 2]], points: &BTreeSet<Point>) -> Self {
        let mut vertices: BTreeSet<Point> = points.clone();
        vertices.extend(segments.iter().flatten().cloned());
        for (i, [a, b]) in segments.iter().enumerate() {
            for [c, d] in &segments[..i] {
                let (s, t) = (minus(b, a), minus(d, c));
                let Some(inverse) = cross(&s, &t).inverse() else { continue };
                let between = minus(c, a);
                let [along_s, along_t] = [&t, &s].map(|other| &cross(&between, other) * &inverse);
                let is_inner = |part: &Rational| *part >= Rational::ZERO && *part <= Rational::from(1);
                if is_inner(&along_s) && is_inner(&along_t) {
                    vertices.insert([0, 1].map(|axis| &a[axis] + &(&along_s * &s[axis])));
                }
            }
        }
        let mut edges = BTreeSet::new();
        for [a, b] in segments {
            let [low, high] = if a <= b { [a, b] } else { [b, a] };
            let on: Vec<&Point> = vertices
                .range(low.clone()..=high.clone())
                .filter(|point| cross(&minus(point, low), &minus(high, low)).is_zero())
                .collect();
            edges.extend(on.windows(2).map(|pair| [pair[0].clone(), pair[1].clone()]));
        }
        Self { edges, vertices }
    }

    fn component_count(&self, without: Option<&[Point; 2]>) -> usize {
        let numbers: BTreeMap<&Point, u32> = self.vertices.iter().zip(0..).collect();
        let mut joined = coface_algebra::UnionFind::new(numbers.len());
        for edge in self.edges.iter().filter(|edge| Some(*edge) != without) {
            joined.unite(numbers[&edge[0]], numbers[&edge[1]]);
        }
        joined.class_count()
    }

    /// Without the edges whose ends nothing else connects.
    fn pruned(&self) -> Self {
        let count = self.component_count(None);
        let edges: BTreeSet<[Point; 2]> =
            self.edges.iter().filter(|edge| self.component_count(Some(edge)) == count).cloned().collect();
        Self { vertices: edges.iter().flatten().cloned().collect(), edges }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Fractions, which know nothing of pieces and supports, find the same in each step, where edges vanish on the way.
    #[test]
    fn pruned_chains_are_those_of_fractions(drawings in drawings(2..5, 5)) {
        let mut plain = Plain::default();
        let mut file: Option<Model> = None;
        for own in &drawings {
            let mut segments: Vec<[Point; 2]> = plain.edges.iter().cloned().collect();
            segments.extend(own.iter().map(|segment| segment.map(rational)));
            plain = Plain::of(&segments, &plain.vertices).pruned();
            let model = lines(own, &[]);
            let models: Vec<&Model> = file.iter().chain([&model]).collect();
            let found = arranged(&models, true);
            let arrangement = found.arrangement();
            let faces = plain.edges.len() + plain.component_count(None) - plain.vertices.len();
            prop_assert_eq!(arrangement.f_vector(), [plain.vertices.len(), plain.edges.len(), faces]);
            let points: Vec<Point> =
                (0..arrangement.vertex_count()).map(|v| arrangement.point(VertexId::new(v)).to_rational()).collect();
            prop_assert!(points.iter().eq(&plain.vertices));
            let edges: BTreeSet<[Point; 2]> = (0..arrangement.edge_count())
                .map(|edge| arrangement.ends(EdgeId::new(edge)).map(|end| points[end.index()].clone()))
                .collect();
            prop_assert!(edges == plain.edges);
            let bytes = file_of(&found);
            file = Some(read(&bytes));
            let again = arranged(&[file.as_ref().unwrap()], true);
            prop_assert!(file_of(&again) == bytes);
        }
    }
}

fn corners() -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop::collection::vec(prop::array::uniform2(coordinate()), 3..6)
}

/// A turned rectangle, long and thin at times.
fn rectangle() -> impl Strategy<Value = Vec<[f64; 2]>> {
    (prop::array::uniform2(-1.0..1.0f64), prop::array::uniform2(0.01..2.0f64), 0.0..6.3f64).prop_map(
        |(middle, half, angle)| {
            let (s, c) = angle.sin_cos();
            let corner = |[x, y]: [f64; 2]| [middle[0] + c * x - s * y, middle[1] + s * x + c * y];
            let [w, h] = half;
            [[-w, -h], [w, -h], [w, h], [-w, h]].map(corner).to_vec()
        },
    )
}

fn operands(steps: std::ops::Range<usize>) -> impl Strategy<Value = Vec<Vec<[f64; 2]>>> {
    prop::collection::vec(prop_oneof![2 => corners(), 3 => rectangle()], steps)
}

/// A chain of Booleans through files, and one formula.
fn agree_combined(operands: &[Vec<[f64; 2]>], operations: &[char]) -> Result<(), TestCaseError> {
    let models: Vec<Model> = operands.iter().map(|own| polygon(own)).collect();
    let mut formula = "0".to_owned();
    let mut chained = combined(&[&models[0]], "0");
    for (step, operation) in (1..models.len()).zip(operations.iter().cycle()) {
        formula = format!("({formula}) {operation} {step}");
        let file = read(&file_of_result(&chained));
        let next = combined(&[&file, &models[step]], &format!("0 {operation} 1"));
        let all: Vec<&Model> = models[..=step].iter().collect();
        let once = combined(&all, &formula);
        let tolerance = 1e-12 * once.area().max(1.0);
        prop_assert!(
            (next.area() - once.area()).abs() <= tolerance,
            "{formula}: {} {}",
            next.area(),
            once.area()
        );
        prop_assert_eq!(next.component_count(), once.component_count(), "{}", &formula);
        prop_assert_eq!(next.hole_count(), once.hole_count(), "{}", &formula);
        prop_assert_eq!(next.pinches().len(), once.pinches().len(), "{}", &formula);
        // Where the chain has cut it has no more corners.
        prop_assert!(next.f_vector()[0] <= once.f_vector()[0], "{formula}");
        // Nothing is in one and not in the other, be it ever so thin.
        let [own, other] = [&next, &once].map(|found| read(&file_of_result(found)));
        let difference = combined(&[&own, &other], "0 ^ 1");
        prop_assert_eq!(difference.f_vector(), [0, 0, 0], "{}", &formula);
        // And what is read again is what was written.
        if next.f_vector()[2] > 0 {
            let again = combined(&[&own], "0");
            prop_assert!(file_of_result(&again) == file_of_result(&next));
        }
        chained = next;
    }
    Ok(())
}

fn operations() -> impl Strategy<Value = Vec<char>> {
    prop::collection::vec(prop::sample::select(vec!['|', '-', '|', '^', '&']), 10)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn chains_of_booleans_are_one_formula(operands in operands(2..6), operations in operations()) {
        agree_combined(&operands, &operations)?;
    }

    /// Parts and wholes: laws that hold for sets hold for files.
    #[test]
    fn parts_put_together_are_the_whole(a in rectangle(), b in rectangle()) {
        let models = [polygon(&a), polygon(&b)];
        let [a, b] = [&models[0], &models[1]];
        let [both, rest] = ["0 & 1", "0 - 1"].map(|formula| read(&file_of_result(&combined(&[a, b], formula))));
        let whole = combined(&[&both, &rest], "0 | 1");
        let file = read(&file_of_result(&whole));
        prop_assert_eq!(combined(&[&file, a], "0 ^ 1").f_vector(), [0, 0, 0]);
        // What was cut is whole again.
        prop_assert_eq!(whole.f_vector(), combined(&[a], "0").f_vector());
        let again = combined(&[a, &both], "0 & 1");
        prop_assert!(file_of_result(&again).len() <= 2 * file_of_result(&combined(&[a, b], "0 & 1")).len());
        prop_assert_eq!(combined(&[&read(&file_of_result(&again)), &both], "0 ^ 1").f_vector(), [0, 0, 0]);
    }

    /// Regions around faces are the same whether lines come from a file that was cut before or not.
    #[test]
    fn faces_are_in_the_same_inputs(operands in operands(2..5), segments in prop::collection::vec(segment(), 1..5)) {
        let cut = lines(&segments, &[]);
        let models: Vec<Model> = operands.iter().map(|own| polygon(own)).collect();
        let mut all: Vec<&Model> = models.iter().collect();
        all.push(&cut);
        let file = read(&file_of(&arranged(&all, false)));
        let once = arranged(&all, false);
        all[models.len()] = &file;
        let again = arranged(&all, false);
        prop_assert_eq!(again.arrangement().f_vector(), once.arrangement().f_vector());
        let inside = |found: &DrawingArrangement, face: usize| -> Vec<u32> {
            let around = found.regions_around(FaceId::new(face)).iter();
            around.copied().filter(|&region| (region as usize) < models.len()).collect()
        };
        for face in 0..once.arrangement().face_count() {
            prop_assert_eq!(inside(&again, face), inside(&once, face), "f{}", face);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn chains_of_ten_booleans_are_one_formula(operands in operands(11..12), operations in operations()) {
        agree_combined(&operands, &operations)?;
    }
}

/// Three lines that nearly meet: the triangle between them is smaller than what rounded crossings can tell, and is cut again all the same.
#[test]
fn a_triangle_that_rounding_loses_is_cut_again() {
    let three = [[[0., 0.], [2., 2.]], [[0., 2.], [2., 0.]], [[0., 1.], [4., 1.0 + f64::EPSILON]]];
    let first = arranged(&[&lines(&three, &[])], false);
    assert_eq!(first.arrangement().f_vector(), [9, 9, 1]);
    let bytes = file_of(&first);
    let file = read(&bytes);
    let exact = file.exact_segments().unwrap();
    assert_eq!((exact.points().len(), exact.supports().len(), exact.pieces().len()), (6, 3, 9));
    // Without the key the rounded points have no triangle any more.
    let text = String::from_utf8(bytes).unwrap();
    let rounded = read(text.replace("\"exact_segments\"", "\"others\"").as_bytes());
    assert_eq!(arranged(&[&rounded], false).arrangement().face_count(), 0);
    let cut = lines(&[[[1.0, 0.], [1.0 + f64::EPSILON, 2.]]], &[]);
    let next = arranged(&[&file, &cut], false);
    assert_eq!(
        next.arrangement().f_vector(),
        arranged(&[&lines(&three, &[]), &cut], false).arrangement().f_vector()
    );
}

/// With a grid or a tolerance points are where their coordinates say, and files need no more.
#[test]
fn moved_vertices_are_written_as_they_are() {
    let crossed = lines(&[[[0., 0.], [3., 1.]], [[1., 0.], [1., 5.]]], &[]);
    let file = read(&file_of(&arranged(&[&crossed], false)));
    let mut request = ArrangementRequest::default();
    request.exact = true;
    request.tolerance = Some(0.01);
    for method in [ArrangementMethod::Exact, ArrangementMethod::Congruence] {
        request.method = method;
        let moved = DrawingArrangement::new(drawing(&[&file]), &request).unwrap();
        assert!(read(&file_of(&moved)).exact_segments().is_none());
        assert_eq!(moved.arrangement().f_vector(), [5, 4, 0]);
    }
    // Without --exact files have rounded points.
    let plain = DrawingArrangement::new(drawing(&[&file]), &ArrangementRequest::default()).unwrap();
    assert!(read(&file_of(&plain)).exact_segments().is_none());
}

/// A Boolean of results within a tolerance, on a grid, and with faces kept apart.
#[test]
fn results_are_operands_of_all_kinds_of_booleans() {
    let [a, b] = [
        polygon(&[[0., 0.], [3., 1.], [2., 4.], [-1., 3.]]),
        polygon(&[[1., -1.], [1.1, 5.], [7., 5.], [7., -1.]]),
    ];
    let part = read(&file_of_result(&combined(&[&a, &b], "0 - 1")));
    let area = combined(&[&a, &b], "0 - 1").area();
    let whole = BooleanFormula::parse("0 | 1", &[]).unwrap();
    let mut request = BooleanRequest::default();
    request.grid = Some(1.0 / 1024.0);
    let on_grid = RegionBoolean::new(drawing(&[&part, &a]), &whole, &request).unwrap();
    assert!((on_grid.area() - 10.0).abs() < 0.01, "{}", on_grid.area());
    request.grid = None;
    request.tolerance = Some(1e-6);
    let within = RegionBoolean::new(drawing(&[&part, &a]), &whole, &request).unwrap();
    assert!((within.area() - 10.0).abs() < 1e-4);
    let mut request = BooleanRequest::default();
    (request.exact, request.keep_walls) = (true, true);
    let apart = RegionBoolean::new(drawing(&[&part, &a]), &whole, &request).unwrap();
    assert_eq!(apart.f_vector()[2], 2);
    let file = read(&file_of_result(&apart));
    let exact = file.exact_segments().unwrap();
    // One edge between both bounds nothing.
    assert_eq!(exact.pieces().len() - exact.own_count(), 1);
    let all = combined(&[&file], "0");
    assert!((all.area() - 10.0).abs() < 1e-12);
    assert_eq!(combined(&[&file, &part], "0 & 1").area().to_bits(), area.to_bits());
    // Holes are holes again, and lines of a map are what they were.
    let ring = combined(&[&a, &polygon(&[[0.5, 1.], [1., 1.1], [0.6, 1.7]])], "0 - 1");
    let file = read(&file_of_result(&ring));
    assert_eq!(
        (combined(&[&file], "0").hole_count(), combined(&[&file], "0").area().to_bits()),
        (1, ring.area().to_bits())
    );
}

/// Files of Booleans without exact points keep holes as well: edges across polygons bound nothing.
#[test]
fn files_of_booleans_are_input_again() {
    let [a, b] = [polygon(&[[0., 0.], [9., 0.], [0., 9.]]), polygon(&[[2., 2.], [3., 2.], [2., 3.]])];
    let formula = BooleanFormula::parse("0 - 1", &[]).unwrap();
    let ring = RegionBoolean::new(drawing(&[&a, &b]), &formula, &BooleanRequest::default()).unwrap();
    let file = read(&file_of_result(&ring));
    assert!(file.exact_segments().is_none());
    let again = combined(&[&file], "0");
    assert_eq!((again.area(), again.hole_count()), (40.0, 1));
    assert_eq!(file.coarse().unwrap().unwrap().vertex_count(), 6);
}

/// Many overlapping polygons take another way to their union; its edges are on segments all the same.
#[test]
fn unions_of_crowds_keep_exact_points() {
    let squares: Vec<Model> = (0..400)
        .map(|i| {
            let [x, y] = [f64::from(i % 20) * 0.31, f64::from(i / 20) * 0.29 + f64::from(i % 7) * 0.01];
            polygon(&[[x, y], [x + 0.9, y + 0.1], [x + 0.8, y + 1.1], [x - 0.1, y + 1.0]])
        })
        .collect();
    let models: Vec<&Model> = squares.iter().collect();
    let mut request = BooleanRequest::default();
    request.exact = true;
    let union = RegionBoolean::new(drawing(&models), &BooleanFormula::union(400), &request).unwrap();
    let file = read(&file_of_result(&union));
    let options = DrawingOptions::new();
    let named = std::iter::once(("union", &file)).chain(models.iter().map(|model| ("square", *model)));
    let drawing = PlanarDrawing::with_options(named, &options).unwrap();
    let formula: Vec<String> = (1..401).map(|i| i.to_string()).collect();
    let formula = BooleanFormula::parse(&format!("0 ^ ({})", formula.join(" | ")), &[]).unwrap();
    let difference = RegionBoolean::new(drawing, &formula, &request).unwrap();
    assert_eq!(difference.f_vector(), [0, 0, 0]);
}

/// The faces of an arrangement as a mesh with exact points: what they cover is inside, and their common sides bound nothing. Where parts of a
/// model are inputs, a remark says that its points are rounded.
#[test]
fn meshes_with_exact_points_are_what_their_faces_cover() {
    let [a, b] = [
        polygon(&[[0., 0.], [3., 1.], [2., 4.], [-1., 3.]]),
        polygon(&[[1., -1.], [1.1, 5.], [7., 5.], [7., -1.]]),
    ];
    let found = arranged(&[&a, &b], false);
    let exact = found.exact_segments_of_faces().unwrap().unwrap();
    let mesh = found.to_mesh().unwrap().with_exact_segments(exact.into());
    let both = read(&file_of_result(&combined(&[&a, &b], "0 | 1")));
    assert_eq!(combined(&[&mesh, &both], "0 ^ 1").f_vector(), [0, 0, 0]);
    let rounded = |source: RegionSource| {
        let options = DrawingOptions::new().source(source);
        let drawing = PlanarDrawing::with_options([("mesh", &mesh)], &options).unwrap();
        let answer =
            DrawingArrangement::new(drawing, &ArrangementRequest::default()).unwrap().answer().unwrap();
        let is_said = |remark: &&Remark| remark.code == RemarkCode::PointsRounded;
        (answer.remarks.iter().filter(is_said).count(), answer.regions)
    };
    assert_eq!(rounded(RegionSource::Models), (0, vec!["mesh".to_owned()]));
    assert_eq!(rounded(RegionSource::Components), (1, vec!["mesh#0".to_owned()]));
}

/// The area of the union of a file, by these inputs, and their number.
fn union_of_file(bytes: &[u8], source: RegionSource) -> (f64, usize) {
    let model = read(bytes);
    let drawing = PlanarDrawing::new([("file", &model)], source).unwrap();
    let count = drawing.region_names().len();
    let union = BooleanFormula::union(count);
    (RegionBoolean::new(drawing, &union, &BooleanRequest::default()).unwrap().area(), count)
}

/// Faces of cells in the plane are inside of what is read, and each is an input where parts are.
#[test]
fn faces_of_files_are_what_is_inside() {
    let wkt = |text: &str| io::read(text.as_bytes(), Format::Wkt).unwrap();
    let squares = ["0 0,2 0,2 2,0 2,0 0", "1 0,3 0,3 2,1 2,1 0"];
    let two = squares.map(|ring| wkt(&format!("POLYGON (({ring}))")));
    let nested = wkt("MULTIPOLYGON (((0 0,6 0,6 6,0 6,0 0)),((2 2,4 2,4 4,2 4,2 2)))");
    let hole = wkt("POLYGON ((0 0,6 0,6 6,0 6,0 0),(2 2,4 2,4 4,2 4,2 2))");
    let cases = [(vec![&two[0], &two[1]], 3, 6.0), (vec![&nested], 2, 36.0), (vec![&hole], 2, 36.0)];
    for (models, faces, area) in cases {
        for exact in [false, true] {
            let mut request = ArrangementRequest::default();
            request.exact = exact;
            let file = file_of(&DrawingArrangement::new(drawing(&models), &request).unwrap());
            assert_eq!(union_of_file(&file, RegionSource::Models), (area, 1));
            assert_eq!(union_of_file(&file, RegionSource::Features), (area, faces));
            assert_eq!(union_of_file(&file, RegionSource::Components).0, area);
        }
    }
    // A result keeps its holes, and faces that were kept apart are one set again.
    let mut request = BooleanRequest::default();
    request.keep_walls = true;
    for (model, area) in [(&hole, 32.0), (&nested, 36.0)] {
        for exact in [false, true] {
            request.exact = exact;
            let result = RegionBoolean::new(drawing(&[model]), &BooleanFormula::union(1), &request).unwrap();
            assert_eq!(union_of_file(&file_of_result(&result), RegionSource::Models), (area, 1));
        }
    }
    // An edge beside a face bounds nothing, and is said to.
    let text = r#"{"vertices":[[0,0],[2,0],[0,2],[5,5]],"boundaries":[
        {"rows":4,"cols":4,"entries":[[0,0,-1],[1,0,1],[1,1,-1],[2,1,1],[2,2,-1],[0,2,1],[2,3,-1],[3,3,1]]},
        {"rows":4,"cols":1,"entries":[[0,0,-1],[1,0,-1],[2,0,-1]]}]}"#;
    let model = read(text.as_bytes());
    let drawn = drawing(&[&model]);
    assert_eq!((drawn.segments().len(), drawn.unbounded_segment_count()), (4, 1));
    let result = RegionBoolean::new(drawn, &BooleanFormula::union(1), &BooleanRequest::default()).unwrap();
    let answer = result.answer();
    assert_eq!((answer.measure, answer.remarks.len()), (2.0, 1));
    assert_eq!(answer.remarks[0].code, RemarkCode::UnboundedSegments);
}

/// Areas of unions through files of cells are those of the inputs.
fn unions_agree(operands: &[Vec<[f64; 2]>]) -> Result<(), TestCaseError> {
    let models: Vec<Model> = operands.iter().map(|own| polygon(own)).collect();
    let all: Vec<&Model> = models.iter().collect();
    let formula = BooleanFormula::union(all.len());
    let plain = RegionBoolean::new(drawing(&all), &formula, &BooleanRequest::default()).unwrap();
    let arranged = DrawingArrangement::new(drawing(&all), &ArrangementRequest::default()).unwrap();
    // All bounded faces, of which some may be in none of the polygons.
    let faces: f64 = arranged.arrangement().areas().iter().sum();
    let (area, _) = union_of_file(&file_of(&arranged), RegionSource::Models);
    prop_assert!((area - faces).abs() <= 1e-9 * faces.max(1.0), "{area} {faces}");
    let (area, _) = union_of_file(&file_of_result(&plain), RegionSource::Models);
    prop_assert!((area - plain.area()).abs() <= 1e-9 * area.max(1.0), "{area} {}", plain.area());
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn unions_of_files_of_faces(
        operands in prop::collection::vec(prop::collection::vec(prop::array::uniform2(-4.0f64..4.0), 3..7), 1..5),
    ) {
        unions_agree(&operands)?;
    }
}
