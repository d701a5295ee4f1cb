//! Cells that touch themselves become several: figures that can be checked by hand, and sets of pixels and voxels, whose
//! pieces are their connected components.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::CellId;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use coface_arrange::congruence::{
    CellClasses, ChainCongruence, ClassRule, Collisions, CongruenceMethod, CongruenceOptions, Discard,
    Representative, chain_congruence, vertex_congruence,
};
use coface_complexes::surface::PolygonMesh;
use coface_geometry::Positions;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

const REWRAP: CongruenceOptions = CongruenceOptions::new().collisions(Collisions::Rewrap);

/// The other methods, which agree.
const OTHERS: &[CongruenceMethod] = &[CongruenceMethod::Matrices];

/// The quotient with its cells wrapped again, after checks of what holds for all.
fn rewrapped(complex: &ChainComplex, vertices: &[u32], positions: Option<&Positions>) -> ChainCongruence {
    let classes = CellClasses::unsigned(vertices.to_vec()).unwrap();
    let found = chain_congruence(complex, classes.clone(), positions, REWRAP).unwrap();
    for &method in OTHERS {
        let again = chain_congruence(complex, classes.clone(), positions, REWRAP.method(method));
        assert_eq!(found, again.unwrap());
    }
    #[cfg(feature = "graphblas-tests")]
    crate::graphblas::check(complex, &classes);
    for (degree, matrix) in (1..).zip(complex.boundary_matrices()) {
        let [lower, own] = [degree - 1, degree].map(|k| found.classes()[k].matrix().unwrap());
        let of_images = found.complex().boundary_matrix(degree).unwrap().checked_product(&own).unwrap();
        let images = lower.checked_product(matrix).unwrap();
        let small: Vec<usize> = found
            .discards(degree)
            .filter(|&(_, reason)| reason == Discard::TooFewFacets)
            .map(|(cell, _)| cell.index())
            .collect();
        for cell in (0..matrix.column_count()).filter(|cell| !small.contains(cell)) {
            assert_eq!(
                of_images.column(cell),
                images.column(cell),
                "image of cell {cell} of degree {degree}"
            );
        }
        for (class, members) in found.classes()[degree].members().iter().enumerate() {
            for &cell in members {
                assert!(found.classes()[degree].image(CellId::from_u32(cell)).any(|(own, _)| own == class));
            }
        }
    }
    // Once more nothing happens.
    let identity = CellClasses::unsigned((0..found.complex().cell_count(0) as u32).collect()).unwrap();
    let again = chain_congruence(found.complex(), identity, positions, REWRAP).unwrap();
    assert_eq!(again.complex(), found.complex());
    assert!(again.changed().iter().all(Vec::is_empty));
    found
}

/// One polygon in the plane; points at the same place become one.
fn polygon(points: &[[f64; 2]], more: &[&[u32]]) -> (ChainComplex, Vec<u32>, Positions) {
    let positions = Positions::from_flat(2, points.concat()).unwrap();
    let mut faces = RaggedArray::from_lists([(0..points.len() as u32).collect::<Vec<_>>()]);
    more.iter().for_each(|face| faces.push(face));
    let complex = PolygonMesh::new(points.len(), faces, &[]).unwrap().chain_complex().unwrap();
    let found = vertex_congruence(&positions, 0.0, ClassRule::Transitive, Representative::Lowest).unwrap();
    (complex, found.class_of().to_vec(), found.positions().clone())
}

fn images(found: &ChainCongruence, degree: usize, cell: usize) -> Vec<(usize, Sign)> {
    found.classes()[degree].image(CellId::new(cell)).collect()
}

#[test]
fn a_figure_of_eight_is_two_triangles() {
    let points = [[0., 0.], [2., -1.], [2., 1.], [0., 0.], [-2., 1.], [-2., -1.]];
    for more in [&[][..], &[&[2, 1, 0][..]]] {
        let (complex, classes, positions) = polygon(&points, more);
        for positions in [None, Some(&positions)] {
            let found = rewrapped(&complex, &classes, positions);
            assert_eq!(found.complex().f_vector(), [5, 6, 2]);
            assert_eq!(images(&found, 2, 0), [(0, Sign::Plus), (1, Sign::Plus)]);
            assert_eq!(found.changed()[2], [0]);
            // The second face, where there is one, is the first triangle the other way round.
            if !more.is_empty() {
                assert_eq!(images(&found, 2, 1), [(0, Sign::Minus)]);
                assert_eq!(found.classes()[2].members().list(0), [0, 1]);
            }
        }
    }
}

#[test]
fn a_waist_that_closes_leaves_two_squares() {
    let points = [[0., 0.], [1., 0.], [2., 0.], [3., 0.], [3., 1.], [2., 0.], [1., 0.], [0., 1.]];
    let (complex, classes, positions) = polygon(&points, &[]);
    for positions in [None, Some(&positions)] {
        let found = rewrapped(&complex, &classes, positions);
        assert_eq!(found.complex().f_vector(), [6, 7, 2]);
        assert_eq!(found.classes()[2].image(CellId::new(0)).len(), 2);
    }
}

/// A ring of width 1 around a unit square; its two ends meet in the edge, or only in the vertex, at the right below.
fn ring(closes: bool) -> Vec<[f64; 2]> {
    let mut points = vec![[3., 0.], [3., 3.], [0., 3.], [0., 0.], [3., 0.], [2., 1.]];
    points.extend([[1., 1.], [1., 2.], [2., 2.], [2., 1.]]);
    if !closes {
        points[0] = [3., 1.];
        points[4] = [3., -1.];
    }
    points
}

#[test]
fn a_ring_that_closes_keeps_its_hole() {
    let (complex, classes, positions) = polygon(&ring(true), &[]);
    let found = rewrapped(&complex, &classes, Some(&positions));
    assert_eq!(found.complex().f_vector(), [8, 9, 1]);
    assert_eq!(found.complex().boundary_matrix(2).unwrap().column(0).rows().len(), 8);
    // Without positions the hole is a face that is taken away.
    let found = rewrapped(&complex, &classes, None);
    assert_eq!(found.complex().f_vector(), [8, 9, 2]);
    // Ends that meet in a vertex: one region, though its boundary meets the vertex twice.
    let (complex, classes, positions) = polygon(&ring(false), &[]);
    assert_eq!(rewrapped(&complex, &classes, Some(&positions)).complex().cell_count(2), 1);
    assert_eq!(rewrapped(&complex, &classes, None).complex().cell_count(2), 2);
}

#[test]
fn faces_lie_in_any_plane_and_at_any_scale() {
    let flat = [[0., 0.], [2., -1.], [2., 1.], [0., 0.], [-2., 1.], [-2., -1.]];
    for scale in [1e-150, 1.0, 1e150] {
        let points = flat.map(|[x, y]: [f64; 2]| [x, x - y, 3.0 + y, 7.0 * x].map(|c| c * scale)).concat();
        let positions = Positions::from_flat(4, points).unwrap();
        let complex = PolygonMesh::new(6, RaggedArray::from_lists([[0, 1, 2, 3, 4, 5]]), &[])
            .unwrap()
            .chain_complex()
            .unwrap();
        let vertices =
            vertex_congruence(&positions, 0.0, ClassRule::Transitive, Representative::Lowest).unwrap();
        let found = rewrapped(&complex, vertices.class_of(), Some(vertices.positions()));
        assert_eq!(found.complex().f_vector(), [5, 6, 2]);
    }
}

/// Cells of degree 2 with fewer than three edges are taken away, unless a solid has them.
#[test]
fn faces_of_two_edges_are_discarded() {
    let matrix = |rows, columns, entries: &[(usize, usize, i64)]| {
        SparseMatrix::from_entries(rows, columns, entries.iter().copied()).unwrap()
    };
    // Edges 0 and 1 are loops; edge 2 joins two vertices that become one.
    let edges = matrix(2, 3, &[(0, 2, -1), (1, 2, 1)]);
    let faces = matrix(3, 1, &[(0, 0, 1), (1, 0, 1)]);
    // Nothing of the face is lost: it stays.
    let found = rewrapped(&ChainComplex::new(vec![edges, faces]).unwrap(), &[0, 0], None);
    assert_eq!(found.complex().f_vector(), [1, 2, 1]);
    let edges = matrix(2, 4, &[(0, 2, -1), (1, 2, 1), (0, 3, 1), (1, 3, -1)]);
    let face = [(0, 0, 1), (1, 0, 1), (2, 0, 1), (3, 0, 1)];
    let bare = ChainComplex::new(vec![edges.clone(), matrix(4, 1, &face)]).unwrap();
    let found = rewrapped(&bare, &[0, 0], None);
    assert_eq!(found.complex().f_vector(), [1, 2, 0]);
    assert!(found.discards(2).eq([(CellId::new(0), Discard::TooFewFacets)]));
    assert!(found.discards(1).eq([2, 3].map(|edge| (CellId::new(edge), Discard::Collapsed))));
    assert_eq!(found.collapsed_counts(), [0, 2, 1]);
    // A solid with four faces has it among them; a fifth one, of the two edges that vanish, collapses.
    let others = [(0, 1, 3), (0, 2, -2), (1, 2, 2), (1, 3, -1), (2, 4, 1), (3, 4, 1)];
    let faces = matrix(4, 5, &[&face[..], &others].concat());
    let solid = matrix(5, 1, &[(0, 0, 1), (1, 0, -1), (2, 0, -1), (3, 0, -1), (4, 0, -1)]);
    let kept = ChainComplex::new(vec![edges, faces, solid]).unwrap();
    let found = rewrapped(&kept, &[0, 0], None);
    assert_eq!(found.complex().f_vector(), [1, 2, 4, 1]);
    assert_eq!(found.changed()[2], [0]);
}

/// The box of 3 x 1 x 1 cubes as one solid with squares as faces; moves vertices by a map of their coordinates.
fn long_box(moved: impl Fn([i32; 3]) -> [i32; 3]) -> (ChainComplex, Vec<u32>, Positions) {
    let voxels: BTreeSet<[i32; 3]> = (0..3).map(|x| [x, 0, 0]).collect();
    let solid = Solid::new(&voxels, &[], false);
    let flat: Vec<f64> = solid.vertices.iter().flat_map(|&v| moved(v).map(f64::from)).collect();
    let positions = Positions::from_flat(3, flat).unwrap();
    let found = vertex_congruence(&positions, 0.0, ClassRule::Transitive, Representative::Lowest).unwrap();
    (solid.complex, found.class_of().to_vec(), found.positions().clone())
}

#[test]
fn a_box_squeezed_to_an_edge_is_two_wedges() {
    let squeeze = |[x, y, z]: [i32; 3]| match x {
        0 => [0, 2 * y, z],
        3 => [4, 2 * y, z],
        _ => [2, 1, z],
    };
    let (complex, classes, positions) = long_box(squeeze);
    let found = rewrapped(&complex, &classes, Some(&positions));
    assert_eq!(found.complex().f_vector(), [10, 17, 10, 2]);
    assert_eq!(found.complex().euler_characteristic(), 1);
    // Without positions nothing says which faces go together.
    assert_eq!(rewrapped(&complex, &classes, None).complex().f_vector(), [10, 17, 10, 1]);
    // With a fin between the wedges they are apart: what cancels between them needs no positions.
    let (complex, classes, positions) =
        long_box(|[x, y, z]| if x % 3 == 0 { [x, 2 * y, z] } else { [x, 1, z] });
    for positions in [None, Some(&positions)] {
        let found = rewrapped(&complex, &classes, positions);
        assert_eq!(found.complex().f_vector(), [12, 20, 11, 2]);
    }
}

/// A set of unit cubes as one solid: its faces are unit squares. An edge with four faces becomes two edges between the
/// same vertices, each with two of them: those of one cube, or those of different cubes.
struct Solid {
    complex: ChainComplex,
    vertices: Vec<[i32; 3]>,
    has_pinch: bool,
}

/// Faces with coefficients.
type Faces = Vec<(usize, i64)>;

impl Solid {
    fn new(voxels: &BTreeSet<[i32; 3]>, choices: &[bool], is_reversed: bool) -> Self {
        let moved = |mut at: [i32; 3], axis: usize, by: i32| {
            at[axis] += by;
            at
        };
        // Squares by their lowest corners and normals, with the sign of the outward normal and the cube behind.
        let mut squares: BTreeMap<([i32; 3], usize), (i64, [i32; 3])> = BTreeMap::new();
        for &voxel in voxels {
            for axis in 0..3 {
                for (side, sign) in [(0, -1), (1, 1)] {
                    if !voxels.contains(&moved(voxel, axis, 2 * side - 1)) {
                        squares.insert((moved(voxel, axis, side), axis), (sign, voxel));
                    }
                }
            }
        }
        let mut vertices: BTreeSet<[i32; 3]> = BTreeSet::new();
        // The faces of each edge (lowest corner, axis), with coefficients.
        let mut around: BTreeMap<([i32; 3], usize), Faces> = BTreeMap::new();
        for (face, &(corner, axis)) in squares.keys().enumerate() {
            let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            for (at, along, coefficient) in
                [(corner, u, 1), (moved(corner, u, 1), v, 1), (moved(corner, v, 1), u, -1), (corner, v, -1)]
            {
                vertices.insert(at);
                vertices.insert(moved(at, along, 1));
                around.entry((at, along)).or_default().push((face, coefficient));
            }
        }
        let vertices: Vec<[i32; 3]> = vertices.into_iter().collect();
        let outward: Vec<(i64, [i32; 3])> = squares.values().copied().collect();
        let (mut ends, mut of_faces, mut edge_count, mut pinches) = (Vec::new(), Vec::new(), 0, 0);
        for ((at, along), faces) in around {
            let mut copies: Vec<Faces> = vec![faces];
            if copies[0].len() == 4 {
                let is_split_by_cubes = choices[pinches % choices.len().max(1)];
                pinches += 1;
                let (first, rest) = copies[0].split_first().unwrap();
                let partner = rest
                    .iter()
                    .find(|&&(face, coefficient)| {
                        let is_same_cube = outward[face].1 == outward[first.0].1;
                        let cancels = coefficient * outward[face].0 == -first.1 * outward[first.0].0;
                        cancels && is_same_cube == is_split_by_cubes
                    })
                    .copied()
                    .unwrap();
                let others = rest.iter().copied().filter(|&other| other != partner).collect();
                copies = vec![vec![*first, partner], others];
            }
            for faces in copies {
                let [tail, head] = [at, moved(at, along, 1)].map(|v| vertices.binary_search(&v).unwrap());
                ends.extend([(tail, edge_count, -1), (head, edge_count, 1)]);
                of_faces.extend(faces.into_iter().map(|(face, coefficient)| (edge_count, face, coefficient)));
                edge_count += 1;
            }
        }
        let factor = if is_reversed { -1 } else { 1 };
        let of_solid = outward.iter().enumerate().map(|(face, &(sign, _))| (face, 0, factor * sign));
        let complex = ChainComplex::new(vec![
            SparseMatrix::from_entries(vertices.len(), edge_count, ends).unwrap(),
            SparseMatrix::from_entries(edge_count, outward.len(), of_faces).unwrap(),
            SparseMatrix::from_entries(outward.len(), 1, of_solid).unwrap(),
        ]);
        Self { complex: complex.unwrap(), vertices, has_pinch: pinches > 0 }
    }
}

/// The sets of cubes or squares that are connected through facets.
fn components<const N: usize>(cells: &BTreeSet<[i32; N]>) -> Vec<BTreeSet<[i32; N]>> {
    let mut left = cells.clone();
    let mut found = Vec::new();
    while let Some(start) = left.pop_first() {
        let (mut component, mut stack) = (BTreeSet::from([start]), vec![start]);
        while let Some(at) = stack.pop() {
            for axis in 0..N {
                for by in [-1, 1] {
                    let mut next = at;
                    next[axis] += by;
                    if left.remove(&next) {
                        component.insert(next);
                        stack.push(next);
                    }
                }
            }
        }
        found.push(component);
    }
    found
}

fn facet_count<const N: usize>(cells: &BTreeSet<[i32; N]>) -> usize {
    let outside = |cell: &[i32; N]| {
        (0..N)
            .flat_map(|axis| [(axis, -1), (axis, 1)])
            .filter(|&(axis, by)| {
                let mut next = *cell;
                next[axis] += by;
                !cells.contains(&next)
            })
            .count()
    };
    cells.iter().map(outside).sum()
}

/// What pieces a region has, as the sorted numbers of their facets.
fn piece_sizes(found: &ChainCongruence, degree: usize) -> Vec<usize> {
    let matrix = found.complex().boundary_matrix(degree).unwrap();
    let mut sizes: Vec<usize> =
        images(found, degree, 0).iter().map(|&(class, _)| matrix.column(class).rows().len()).collect();
    sizes.sort_unstable();
    sizes
}

fn component_sizes<const N: usize>(cells: &BTreeSet<[i32; N]>) -> Vec<usize> {
    let mut sizes: Vec<usize> = components(cells).iter().map(facet_count).collect();
    sizes.sort_unstable();
    sizes
}

/// A set of unit squares as one face with unit edges. A vertex with four edges becomes two vertices at one place, each with
/// two of the edges.
fn pixel_region(
    pixels: &BTreeSet<[i32; 2]>,
    choices: &[bool],
    is_reversed: bool,
) -> (ChainComplex, Positions, bool) {
    // Edges that run counterclockwise around the squares, where the other side is free.
    let mut edges: Vec<[[i32; 2]; 2]> = Vec::new();
    for &[x, y] in pixels {
        let corners = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
        let beside = [[x, y - 1], [x + 1, y], [x, y + 1], [x - 1, y]];
        for side in 0..4 {
            if !pixels.contains(&beside[side]) {
                edges.push([corners[side], corners[(side + 1) % 4]]);
            }
        }
    }
    if is_reversed {
        edges.iter_mut().for_each(|edge| edge.reverse());
    }
    let places: BTreeSet<[i32; 2]> = edges.iter().flatten().copied().collect();
    let (mut flat, mut entries, mut count, mut pinches) = (Vec::new(), Vec::new(), 0, 0);
    for place in places {
        let into: Vec<usize> = (0..edges.len()).filter(|&e| edges[e][1] == place).collect();
        let mut out: Vec<usize> = (0..edges.len()).filter(|&e| edges[e][0] == place).collect();
        if into.len() == 2 {
            if choices[pinches % choices.len()] {
                out.reverse();
            }
            pinches += 1;
        }
        for (into, out) in into.into_iter().zip(out) {
            entries.extend([(count, into, 1), (count, out, -1)]);
            flat.extend(place.map(f64::from));
            count += 1;
        }
    }
    let complex = ChainComplex::new(vec![
        SparseMatrix::from_entries(count, edges.len(), entries).unwrap(),
        SparseMatrix::from_entries(edges.len(), 1, (0..edges.len()).map(|e| (e, 0, 1))).unwrap(),
    ]);
    (complex.unwrap(), Positions::from_flat(2, flat).unwrap(), pinches > 0)
}

/// A shell around a void, in which a cube floats, and a cube that touches the shell in an edge.
#[test]
fn a_void_stays_with_the_solid_around_it() {
    let in_shell = |at: &[i32; 3]| {
        let most = at.iter().map(|x| (x - 2).abs()).max();
        most == Some(2) || most == Some(0)
    };
    let places = (0..5).flat_map(|x| (0..5).flat_map(move |y| (0..5).map(move |z| [x, y, z])));
    let mut voxels: BTreeSet<[i32; 3]> = places.filter(in_shell).collect();
    voxels.insert([5, 5, 0]);
    for choice in [false, true] {
        for is_reversed in [false, true] {
            let solid = Solid::new(&voxels, &[choice], is_reversed);
            let flat = solid.vertices.iter().flat_map(|v| v.map(f64::from)).collect();
            let positions = Positions::from_flat(3, flat).unwrap();
            let identity: Vec<u32> = (0..solid.vertices.len() as u32).collect();
            let found = rewrapped(&solid.complex, &identity, Some(&positions));
            assert_eq!(piece_sizes(&found, 3), [6, 6, 150 + 54]);
            // Nothing but positions tells the shells apart.
            assert_eq!(rewrapped(&solid.complex, &identity, None).complex().cell_count(3), 1);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// A region of squares that touches itself in vertices becomes its connected components, with their holes, whatever way
    /// its boundary went through the vertices.
    #[test]
    fn pieces_of_pixels_are_components(
        pixels in prop::collection::vec(prop::bool::weighted(0.7), 36),
        choices in prop::collection::vec(any::<bool>(), 1..6),
        is_reversed: bool,
    ) {
        let places = (0..6).flat_map(|x| (0..6).map(move |y| [x, y]));
        let pixels: BTreeSet<[i32; 2]> = places.zip(pixels).filter(|(_, is_in)| *is_in).map(|(at, _)| at).collect();
        prop_assume!(!pixels.is_empty());
        let (complex, positions, has_pinch) = pixel_region(&pixels, &choices, is_reversed);
        let vertices = vertex_congruence(&positions, 0.0, ClassRule::Transitive, Representative::Lowest).unwrap();
        let found = rewrapped(&complex, vertices.class_of(), Some(vertices.positions()));
        let expected = if has_pinch { component_sizes(&pixels) } else { vec![facet_count(&pixels)] };
        prop_assert_eq!(piece_sizes(&found, 2), expected);
        // Without positions: walks that meet no vertex twice, if the boundary was one.
        let found = rewrapped(&complex, vertices.class_of(), None);
        let is_split = found.classes()[2].image(CellId::new(0)).len() > 1;
        if is_split {
            let faces = found.complex().boundary_matrix(2).unwrap();
            let edges = found.complex().boundary_matrix(1).unwrap();
            for face in faces.columns() {
                let mut degrees = BTreeMap::new();
                for &edge in face.rows() {
                    edges.column(edge as usize).rows().iter().for_each(|&v| *degrees.entry(v).or_insert(0) += 1);
                }
                prop_assert!(degrees.values().all(|&degree| degree == 2));
            }
        }
    }

    /// The same in space: cubes that touch in edges.
    #[test]
    fn pieces_of_voxels_are_components(
        voxels in prop::collection::vec(prop::bool::weighted(0.75), 60),
        choices in prop::collection::vec(any::<bool>(), 1..6),
        is_reversed: bool,
    ) {
        let places = (0..5).flat_map(|x| (0..4).flat_map(move |y| (0..3).map(move |z| [x, y, z])));
        let voxels: BTreeSet<[i32; 3]> = places.zip(voxels).filter(|(_, is_in)| *is_in).map(|(at, _)| at).collect();
        prop_assume!(!voxels.is_empty());
        let solid = Solid::new(&voxels, &choices, is_reversed);
        let flat = solid.vertices.iter().flat_map(|v| v.map(f64::from)).collect();
        let positions = Positions::from_flat(3, flat).unwrap();
        let identity: Vec<u32> = (0..solid.vertices.len() as u32).collect();
        let found = rewrapped(&solid.complex, &identity, Some(&positions));
        let expected = if solid.has_pinch { component_sizes(&voxels) } else { vec![facet_count(&voxels)] };
        prop_assert_eq!(piece_sizes(&found, 3), expected);
        rewrapped(&solid.complex, &identity, None);
    }

    /// Any classes of the vertices of a simplicial complex, with positions in the plane, in space, or none.
    #[test]
    fn any_classes_give_a_complex(
        facets in prop::collection::vec(prop::collection::btree_set(0u32..9, 1..6), 1..7),
        merged in prop::collection::vec(0u32..9, 9),
        coordinates in prop::collection::vec(-9i32..9, 27),
        dimension in 0usize..4,
    ) {
        let facets: Vec<Vec<u32>> = facets.into_iter().map(|facet| facet.into_iter().collect()).collect();
        let complex = coface_complexes::simplicial::SimplicialComplex::from_facets(facets.iter().map(Vec::as_slice))
            .unwrap().freeze().chain_complex().unwrap();
        let count = complex.cell_count(0);
        // Vertex i goes to the class of merged[i] if that is lower.
        let mut lowest: Vec<usize> = (0..count).collect();
        for vertex in 0..count {
            lowest[vertex] = lowest[vertex.min(merged[vertex] as usize)];
        }
        let mut numbers = BTreeMap::new();
        let classes: Vec<u32> = lowest.iter().map(|&low| {
            let next = numbers.len() as u32;
            *numbers.entry(low).or_insert(next)
        }).collect();
        let flat = coordinates[..numbers.len() * dimension].iter().map(|&x| f64::from(x)).collect();
        let positions = Positions::from_flat(dimension, flat).unwrap();
        rewrapped(&complex, &classes, (dimension > 0).then_some(&positions));
    }
}
