//! Surfaces of selections of cubes, pinched and split; winding numbers without directions and without exactness.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::solids::{Faces, rod_through_cube, shifted_cubes};
use coface_algebra::{CellId, EdgeId, FaceId};
use coface_algebra::{Sign, SparseMatrix};
use coface_arrange::boolean::{
    CellSelection, SelectionMesh, WindingNumbers, generalized_winding_numbers, point_inside,
};
use coface_arrange::spatial::SpatialCells;
use coface_complexes::surface::{PolygonMesh, SurfaceDefect};
use coface_geometry::{Positions, enclosed_volume};
use proptest::prelude::*;

/// The vertices around a face with one walk.
fn walk(cells: &SpatialCells, face: CellId) -> Vec<u32> {
    let complex = cells.complex();
    let sides = complex.sides(FaceId::new(face.index()));
    sides.map(|(edge, sign)| complex.edges()[edge.index()][usize::from(sign == Sign::Minus)]).collect()
}

fn surface(cells: &SpatialCells, selection: &CellSelection) -> SelectionMesh {
    let boundary = selection.boundary(&cells.chain_complex().unwrap()).unwrap();
    SelectionMesh::new(boundary.facets(), |face, give| give(&walk(cells, face)))
}

/// The faces around the edge from one vertex to another.
fn around(cells: &SpatialCells, [a, b]: [CellId; 2]) -> Vec<(CellId, Sign)> {
    let ends = [a.index() as u32, b.index() as u32];
    let edges = cells.complex().edges();
    let edge = edges.iter().position(|&[a, b]| ends == [a, b] || ends == [b, a]).unwrap();
    let list = cells.faces_around(EdgeId::new(edge));
    let list: Vec<(CellId, Sign)> = list.map(|(face, sign)| (CellId::new(face.index()), sign)).collect();
    if edges[edge] == ends {
        return list;
    }
    list.into_iter().rev().map(|(face, sign)| (face, sign.opposite())).collect()
}

fn split(cells: &SpatialCells, surface: &mut SelectionMesh) -> usize {
    surface.split_pinches(|ends| around(cells, ends)).unwrap()
}

fn mesh(surface: &SelectionMesh) -> PolygonMesh {
    PolygonMesh::new(surface.vertex_sources().len(), surface.polygons().clone(), &[]).unwrap()
}

/// All 27 cubes of a grid.
fn grid() -> (SpatialCells, Positions) {
    let mut faces = Faces::default();
    for i in 0..27 {
        faces.add_cube([i / 9, i / 3 % 3, i % 3].map(f64::from), 1.0);
    }
    (faces.cells(), faces.positions())
}

#[test]
fn solids_that_touch_come_apart() {
    for (places, counts) in [
        // At a vertex, along an edge, and along two edges from a vertex at which a third pair touches.
        (vec![[0, 0, 0], [1, 1, 1]], [16, 24, 12]),
        (vec![[0, 0, 0], [1, 1, 0]], [16, 24, 12]),
        (vec![[0, 0, 0], [1, 1, 0], [1, 0, 1], [0, 1, 1]], [32, 48, 24]),
    ] {
        let mut faces = Faces::default();
        for place in &places {
            faces.add_cube(place.map(f64::from), 1.0);
        }
        let cells = faces.cells();
        assert_eq!(cells.cell_count(), places.len());
        let mut surface = surface(&cells, &CellSelection::new(vec![true; places.len()], false));
        assert!(!mesh(&surface).manifold_verdict().is_manifold());
        let before = surface.vertex_sources().len();
        let copies = split(&cells, &mut surface);
        let mesh = mesh(&surface);
        assert_eq!((mesh.f_vector(), before + copies), (counts.to_vec(), counts[0]));
        assert!(mesh.manifold_verdict().is_manifold());
        assert_eq!(mesh.components().count(), places.len());
        // Done once, it is done.
        assert_eq!(split(&cells, &mut surface), 0);
    }
}

#[test]
fn the_two_parts_of_a_symmetric_difference_come_apart() {
    let faces = shifted_cubes();
    let cells = faces.cells();
    let volumes = cells.volumes(&faces.positions()).unwrap();
    let parts = volumes.iter().map(|&volume| volume > 0.5).collect();
    let mut surface = surface(&cells, &CellSelection::new(parts, false));
    assert_eq!(mesh(&surface).f_vector(), [22, 36, 18]);
    // The six vertices of the hexagon where the surfaces cross.
    assert_eq!(split(&cells, &mut surface), 6);
    let mesh = mesh(&surface);
    assert_eq!((mesh.f_vector(), mesh.components().count()), (vec![28, 42, 18], 2));
    assert!(mesh.manifold_verdict().is_manifold());
    let positions = surface.positions(&faces.positions()).unwrap();
    assert_eq!(enclosed_volume(&positions, surface.polygons()), Some(1.75));
}

#[test]
fn edges_that_are_not_told_are_refused() {
    let mut faces = Faces::default();
    faces.add_cubes(&[[0, 0, 0], [1, 1, 0]]);
    let cells = faces.cells();
    let mut surface = surface(&cells, &CellSelection::new(vec![true; 2], false));
    let error = surface.split_pinches(|_| Vec::new()).unwrap_err();
    assert!(error.message().starts_with("0 of the 4 facets at the edge between v"), "{error}");
}

#[test]
fn winding_numbers_of_closed_surfaces_are_integers_in_floating_point_too() {
    for (scale, faces) in [(1.0, shifted_cubes()), (1e-200, rod_through_cube()), (1e150, shifted_cubes())] {
        let faces = faces.moved(|point| point.map(|x| x * scale));
        let (cells, positions) = (faces.cells(), faces.positions());
        let boundaries = cells.cell_boundaries().unwrap();
        // Fans of faces with holes are chains of triangles with the same boundary, which is all that counts.
        let fans = |cell: usize| {
            let mut triangles = Vec::new();
            for (face, entry) in boundaries.column(cell).iter() {
                let sides = cells.complex().sides(FaceId::new(face)).map(|(edge, sign)| {
                    let [a, b] = cells.complex().edges()[edge.index()];
                    if (sign == Sign::Plus) == (entry > 0) { [a, b] } else { [b, a] }
                });
                let sides: Vec<[u32; 2]> = sides.collect();
                triangles.extend(sides.iter().map(|&[a, b]| [sides[0][0], a, b]));
            }
            triangles
        };
        // In the first cube alone, in both, in the second alone; in the rod below, within and above the cube, and beside it.
        let places = [
            [0.2, 0.3, 0.4],
            [0.7, 0.6, 0.8],
            [1.3, 1.2, 1.1],
            [0.5, 0.4, -0.2],
            [0.5, 0.4, 1.3],
            [9.0, 9.0, 9.0],
        ];
        let points =
            Positions::from_flat(3, places.as_flattened().iter().map(|x| x * scale).collect()).unwrap();
        let mut sums = [0.0; 6];
        for cell in 0..cells.cell_count() {
            let numbers = generalized_winding_numbers(&positions, &fans(cell), &points).unwrap();
            for (sum, number) in sums.iter_mut().zip(numbers) {
                assert!((number - number.round()).abs() < 1e-12, "{number}");
                *sum += number;
            }
        }
        let expected = if scale == 1e-200 { [1, 1, 0, 1, 1, 0] } else { [1, 1, 1, 0, 0, 0] };
        assert_eq!(sums.map(|sum| sum.round() as i32), expected);
    }
}

#[test]
fn points_inside_cells_are_inside() {
    let (cells, positions) = grid();
    let boundaries = cells.cell_boundaries().unwrap();
    for cell in 0..27 {
        let mut triangles = Vec::new();
        for (face, entry) in boundaries.column(cell).iter() {
            let mut walk = walk(&cells, CellId::new(face));
            if entry < 0 {
                walk.reverse();
            }
            triangles.extend([[walk[0], walk[1], walk[2]], [walk[0], walk[2], walk[3]]]);
        }
        let inside = point_inside(&positions, &triangles).unwrap();
        let point = Positions::from_flat(3, inside.to_vec()).unwrap();
        let number = generalized_winding_numbers(&positions, &triangles, &point).unwrap()[0];
        assert!((number - 1.0).abs() < 1e-12, "{inside:?}");
        // Turned inside out there is no way straight inward.
        triangles.iter_mut().for_each(|triangle| triangle.swap(0, 1));
        assert_eq!(point_inside(&positions, &triangles), None);
    }
    assert_eq!(point_inside(&positions, &[]), None);
}

proptest! {
    /// After splitting no vertex has two fans, and what is left of crowded edges are edges whose ends hold together.
    #[test]
    fn split_surfaces_have_one_fan_at_each_vertex(is_in in prop::collection::vec(any::<bool>(), 27)) {
        let (cells, positions) = grid();
        let selection = CellSelection::new(is_in.clone(), false);
        let boundary = selection.boundary(&cells.chain_complex().unwrap()).unwrap();
        let mut surface = surface(&cells, &selection);
        let before = mesh(&surface);
        let copies = split(&cells, &mut surface);
        prop_assert!(copies == 0 || !boundary.is_manifold());
        let after = mesh(&surface);
        let verdict = after.manifold_verdict();
        let is_fanned = matches!(verdict.witness(), Some(SurfaceDefect::SeveralFans { .. }));
        prop_assert!(!is_fanned);
        prop_assert!(verdict.is_closed());
        prop_assert_eq!(after.face_count(), before.face_count());
        let volume = is_in.iter().filter(|&&is_in| is_in).count() as f64;
        let positions = surface.positions(&positions).unwrap();
        if volume > 0.0 {
            prop_assert_eq!(enclosed_volume(&positions, surface.polygons()), Some(volume));
        }
    }

    /// Facets with any signs: parities are winding numbers modulo 2.
    #[test]
    fn parities_need_no_directions(
        chain in prop::collection::vec(-2i32..3, 27),
        turned in prop::collection::vec(any::<bool>(), 108),
    ) {
        let (cells, _) = grid();
        let complex = cells.chain_complex().unwrap();
        let matrix = complex.boundary_matrix(3).unwrap();
        let terms = chain.iter().enumerate().flat_map(|(cell, &coefficient)| {
            matrix.column(cell).iter().map(move |(face, entry)| (face, 0, i64::from(coefficient * entry)))
        });
        let closed = SparseMatrix::from_entries(108, 1, terms).unwrap();
        let flipped = closed.column(0).iter().map(|(face, entry)| (face, 0, if turned[face] { -i64::from(entry) } else { entry.into() }));
        let flipped = SparseMatrix::from_entries(108, 1, flipped).unwrap();
        let parities = WindingNumbers::parities(&complex, &flipped).unwrap();
        for (cell, coefficient) in chain.iter().enumerate() {
            prop_assert_eq!(parities.of_cell(CellId::new(cell))[0], coefficient.rem_euclid(2));
        }
        prop_assert_eq!(parities, WindingNumbers::parities(&complex, &closed).unwrap());
    }
}
