//! Arrangements of segments by congruence: the cells of the exact method where features are clear, whatever the noise.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::{EdgeId, FaceId, RaggedArray, SparseMatrix, VertexId};
use coface_arrange::planar::{PlanarArrangement, SnappedArrangement, gift_wrapped_faces};
use coface_geometry::Positions;
use proptest::prelude::*;

type Segments = (Vec<[f64; 2]>, Vec<[u32; 2]>);

fn arranged((points, segments): &Segments) -> PlanarArrangement {
    let positions = Positions::from_flat(2, points.as_flattened().to_vec()).unwrap();
    PlanarArrangement::new(&positions, segments).unwrap()
}

fn glued(segments: &Segments, tolerance: f64) -> SnappedArrangement {
    arranged(segments).by_congruence(tolerance).unwrap()
}

/// Rectangles with corners on a grid.
fn rectangles(corners: &[[i32; 4]], place: impl Fn([f64; 2], usize) -> [f64; 2]) -> Segments {
    let (mut points, mut segments) = (Vec::new(), Vec::new());
    for &[x, y, width, height] in corners {
        let first = points.len() as u32;
        for [dx, dy] in [[0, 0], [width, 0], [width, height], [0, height]] {
            points.push(place([f64::from(x + dx), f64::from(y + dy)], points.len()));
        }
        segments.extend((0..4).map(|i| [first + i, first + (i + 1) % 4]));
    }
    (points, segments)
}

/// Everything that does not depend on coordinates, and areas in order.
fn facts(arrangement: &PlanarArrangement) -> (Vec<usize>, usize, usize, Vec<usize>) {
    let complex = arrangement.chain_complex().unwrap();
    let ranks: Vec<usize> = complex.boundary_matrices().iter().map(rank).collect();
    let counts = complex.f_vector();
    let rank = |degree: usize| ranks.get(degree).copied().unwrap_or(0);
    let betti = (0..counts.len()).map(|k| counts[k] - if k == 0 { 0 } else { rank(k - 1) } - rank(k));
    (arrangement.f_vector(), arrangement.component_count(), arrangement.hole_count(), betti.collect())
}

/// The rank over the field of two elements.
fn rank(matrix: &SparseMatrix) -> usize {
    let mut pivots: Vec<Vec<usize>> = Vec::new();
    for column in matrix.columns() {
        let mut own: Vec<usize> =
            column.iter().filter(|(_, entry)| entry % 2 != 0).map(|(row, _)| row).collect();
        while let Some(last) = own.last() {
            let Some(pivot) = pivots.iter().find(|pivot| pivot.last() == Some(last)) else {
                pivots.push(own);
                break;
            };
            let both = own.iter().chain(pivot).copied();
            let mut sum: Vec<usize> = both.collect();
            sum.sort_unstable();
            own = sum.chunk_by(|a, b| a == b).filter(|same| same.len() == 1).map(|same| same[0]).collect();
        }
    }
    pivots.len()
}

fn areas(arrangement: &PlanarArrangement) -> Vec<f64> {
    let mut areas = arrangement.areas();
    areas.sort_by(f64::total_cmp);
    areas
}

fn are_close(found: &[f64], expected: &[f64], accuracy: f64) -> bool {
    found.len() == expected.len() && found.iter().zip(expected).all(|(x, y)| (x - y).abs() <= accuracy)
}

/// The walks around faces, wrapped as gifts from the boundary matrix of the edges, are those of the arrangement.
fn check_wrapping(arrangement: &PlanarArrangement) {
    let complex = arrangement.coarse_complex().unwrap();
    if arrangement.edge_count() == 0
        || (0..arrangement.edge_count()).any(|edge| arrangement.is_bridge(EdgeId::new(edge)))
    {
        return;
    }
    let around = (0..arrangement.vertex_count())
        .map(|vertex| arrangement.halfedges_around(VertexId::new(vertex)).map(|own| own.to_u32() / 2));
    let rotation = RaggedArray::from_lists(around.map(Iterator::collect::<Vec<_>>));
    let wrapped = gift_wrapped_faces(&complex.boundary_matrices()[0], &rotation).unwrap();
    let signed = |halfedge: &u32| (*halfedge as usize / 2, if halfedge.is_multiple_of(2) { 1 } else { -1 });
    let faces = [None].into_iter().chain((0..arrangement.face_count()).map(|face| Some(FaceId::new(face))));
    let mut walks: Vec<Vec<(usize, i32)>> = faces
        .flat_map(|face| arrangement.walks(face).map(|walk| walk.to_vec()).collect::<Vec<_>>())
        .map(|walk| {
            let mut own: Vec<_> = walk.iter().map(signed).collect();
            own.sort_unstable();
            own
        })
        .collect();
    let mut cycles: Vec<Vec<(usize, i32)>> =
        wrapped.columns().map(|column| column.iter().collect()).collect();
    walks.sort_unstable();
    cycles.sort_unstable();
    assert_eq!(cycles, walks);
}

#[test]
fn squares_have_the_known_cells() {
    for (second, counts) in [
        ([0, 0, 4, 4], [4, 4, 1]),
        ([2, 2, 4, 4], [10, 12, 3]),
        ([4, 0, 4, 4], [6, 7, 2]),
        ([4, 2, 4, 4], [8, 9, 2]),
        ([4, 4, 4, 4], [7, 8, 2]),
        ([1, 1, 2, 2], [8, 8, 2]),
        ([8, 0, 4, 4], [8, 8, 2]),
    ] {
        let found = glued(&rectangles(&[[0, 0, 4, 4], second], |point, _| point), 1e-9);
        assert_eq!(found.arrangement().f_vector(), counts, "{second:?}");
        check_wrapping(found.arrangement());
        let stacked = found.stacked().unwrap();
        assert!(stacked.collapsed.is_empty() && stacked.largest_class_diameter < 1e-12);
    }
}

#[test]
fn what_collapses_is_named() {
    let drawing = (vec![[0., 0.], [4., 0.], [0., 1.], [0.001, 1.]], vec![[0, 1], [2, 3], [1, 1]]);
    let found = glued(&drawing, 0.01);
    assert_eq!(found.arrangement().f_vector(), [3, 1, 0]);
    assert_eq!(found.stacked().unwrap().collapsed, [1]);
    let exact = arranged(&drawing);
    for tolerance in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(exact.by_congruence(tolerance).unwrap_err().to_string().contains("no tolerance"));
    }
    let nothing = glued(&(Vec::new(), Vec::new()), 1.0);
    assert_eq!(nothing.arrangement().f_vector(), [0, 0, 0]);
    let point = glued(&(vec![[0., 0.], [0., 0.], [5., 5.]], vec![[0, 1]]), 0.1);
    assert_eq!(point.arrangement().f_vector(), [2, 0, 0]);
    assert!(point.stacked().unwrap().collapsed.is_empty());
}

/// Segments that pass an end by less than the tolerance, beyond it and before it, meet in that end.
#[test]
fn ends_that_nearly_touch_are_on_the_segment() {
    for gap in [-1e-3, 0.0, 1e-3] {
        let found = glued(&(vec![[0., 0.], [4., 0.], [2., gap], [2., 3.]], vec![[0, 1], [2, 3]]), 0.01);
        assert_eq!(found.arrangement().f_vector(), [4, 3, 0], "{gap}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn clear_scenes_have_the_cells_of_the_exact_method(
        points in prop::collection::vec(prop::array::uniform2(0i32..60), 4..60)
    ) {
        let points: Vec<[f64; 2]> = points.iter().map(|point| point.map(f64::from)).collect();
        let segments = (0..points.len() as u32 / 2).map(|i| [2 * i, 2 * i + 1]).collect();
        let drawing = (points, segments);
        let exact = arranged(&drawing);
        // Crossings of lines on this grid are farther apart than this, and have 2^-52 of an error.
        let found = exact.by_congruence(1e-9).unwrap();
        prop_assert_eq!(facts(found.arrangement()), facts(&exact));
        prop_assert!(are_close(&areas(found.arrangement()), &areas(&exact), 1e-6));
        prop_assert!(found.stacked().unwrap().largest_class_diameter < 1e-11);
        check_wrapping(found.arrangement());
        for (edge, segments) in found.segments_of_edges().iter().enumerate() {
            prop_assert!(!segments.is_empty(), "edge {}", edge);
        }
    }

    #[test]
    fn noise_below_a_quarter_changes_no_cells(
        corners in prop::collection::vec((0i32..12, 0i32..12, 1i32..8, 1i32..8), 1..14),
        noise in prop::collection::vec(prop::array::uniform2(-1.0..1.0f64), 56),
        angle in 0.0..6.3f64,
    ) {
        let corners: Vec<[i32; 4]> = corners.iter().map(|&(x, y, w, h)| [x, y, w, h]).collect();
        let tolerance = 0.01;
        let (sine, cosine) = angle.sin_cos();
        let exact = arranged(&rectangles(&corners, |point, _| point));
        let noisy = rectangles(&corners, |[x, y], place| {
            let [dx, dy] = noise[place].map(|by| by * tolerance / 4.0 / 2f64.sqrt());
            [cosine * x - sine * y + dx + 1e3, sine * x + cosine * y + dy - 1e3]
        });
        let found = glued(&noisy, tolerance);
        prop_assert_eq!(facts(found.arrangement()), facts(&exact));
        prop_assert!(are_close(&areas(found.arrangement()), &areas(&exact), 0.3));
        check_wrapping(found.arrangement());
    }
}
