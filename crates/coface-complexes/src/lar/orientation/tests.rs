//! Orientation on cells whose signs are known by hand, and against trying all signs.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use super::*;
use crate::lar::chain_complex::TopOrientation;
use crate::lar::model::LarModel;
use crate::lar::samples::{cube, grid};
use crate::simplicial::FrozenComplex;
use coface_algebra::{CellId, ErrorKind};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use coface_geometry::Positions;
use proptest::prelude::*;

fn edges(vertex_count: usize, ends: &[[u32; 2]]) -> SparseMatrix {
    LarModel::new(vertex_count, vec![RaggedArray::from_lists(ends)]).unwrap().edge_boundaries().unwrap()
}

/// The positions of the vertices of a cuboid grid.
fn grid_positions(shape: [u32; 3], origin: f64, side: f64) -> Vec<f64> {
    let mut flat = Vec::new();
    for x in 0..=shape[0] {
        for y in 0..=shape[1] {
            for z in 0..=shape[2] {
                flat.extend([x, y, z].map(|i| origin + side * f64::from(i)));
            }
        }
    }
    flat
}

/// By hand: faces 0123, 4567, 0145, 2367, 0246, 1357 with their lowest edge positive.
#[test]
fn the_faces_of_the_cube_have_their_signs() {
    let complex = cube().oriented_chain_complex(TopOrientation::LowestFacet, None).unwrap();
    let faces = complex.boundary_matrix(2).unwrap();
    let rows = [
        [1, -1, 0, 0, -1, 1, 0, 0, 0, 0, 0, 0],
        [0, 0, 1, -1, 0, 0, -1, 1, 0, 0, 0, 0],
        [1, 0, -1, 0, 0, 0, 0, 0, -1, 1, 0, 0],
        [0, 1, 0, -1, 0, 0, 0, 0, 0, 0, -1, 1],
        [0, 0, 0, 0, 1, 0, -1, 0, -1, 0, 1, 0],
        [0, 0, 0, 0, 0, 1, 0, -1, 0, -1, 0, 1],
    ];
    for (face, row) in rows.iter().enumerate() {
        assert_eq!((0..12).map(|edge| faces.entry(edge, face)).collect::<Vec<_>>(), row);
    }
    assert!(complex.boundary_matrix(1).unwrap().checked_product(faces).unwrap().is_zero());
}

#[test]
fn the_cube_and_its_exterior_sum_to_zero() {
    let complex = cube().oriented_chain_complex(TopOrientation::LowestFacet, None).unwrap();
    let solid = OrientedCells::connected(complex.boundary_matrix(3).unwrap().clone());
    let space = solid.with_exterior().unwrap();
    assert_eq!(space.cell_count(), 2);
    for facet in 0..6 {
        assert_eq!(space.boundary().entry(facet, 0) + space.boundary().entry(facet, 1), 0);
    }
    // The faces of the cube alone, coherent: a closed surface has no exterior to add.
    let lower = complex.boundary_matrix(1).unwrap();
    let faces = oriented_boundary(lower, &cube().facets(2).unwrap()).unwrap();
    assert_eq!(faces.coherence().unwrap().is_coherent(), Some(false));
    assert!(faces.with_exterior().is_err());
    let coherent = faces.coherent().unwrap();
    let exterior = coherent.with_exterior().unwrap();
    assert!(exterior.boundary().column(6).rows().is_empty());
    assert_eq!(coherent.coherence().unwrap().conflicts(), []);
}

fn square(x: f64, side: f64) -> [f64; 8] {
    [x, x, x + side, x, x + side, x + side, x, x + side]
}

/// Squares of sides 4, 2 and 0.5 around the same center: each but the last has a hole.
fn nested_squares() -> (LarModel, Positions) {
    let cycle = |i: u32| [[i, i + 1], [i + 1, i + 2], [i + 2, i + 3], [i, i + 3]];
    let sides: Vec<[u32; 2]> = [0, 4, 8].into_iter().flat_map(cycle).collect();
    let faces = [(0..8).collect::<Vec<u32>>(), (4..12).collect(), (8..12).collect()];
    let model =
        LarModel::new(12, vec![RaggedArray::from_lists(sides), RaggedArray::from_lists(faces)]).unwrap();
    let flat = [square(0.0, 4.0), square(1.0, 2.0), square(1.75, 0.5)].concat();
    (model, Positions::from_flat(2, flat).unwrap())
}

#[test]
fn nested_squares_have_holes() {
    let (model, positions) = nested_squares();
    let error = model.oriented_chain_complex(TopOrientation::LowestFacet, None).unwrap_err();
    assert!(error.message().contains("has 2 components"), "{error}");
    let complex = model.oriented_chain_complex(TopOrientation::Positive, Some(&positions)).unwrap();
    let faces = complex.boundary_matrix(2).unwrap();
    assert_eq!(faces.column(0).rows().len(), 8);
    assert_eq!(signed_measures(&complex, &positions).unwrap(), [12.0, 3.75, 0.25]);
    // The common edges of two faces cancel.
    for edge in 4..12 {
        assert_eq!((0..3).map(|face| faces.entry(edge, face)).sum::<i32>(), 0);
    }
    // In space the same, with the lowest edge of each face positive.
    let flat: Vec<f64> = positions.as_flat().chunks(2).flat_map(|p| [p[0], p[1], p[0] + p[1]]).collect();
    let inclined = Positions::from_flat(3, flat).unwrap();
    let complex = model.oriented_chain_complex(TopOrientation::LowestFacet, Some(&inclined)).unwrap();
    assert_eq!(complex.boundary_matrix(2).unwrap().column(0).entries(), [1, 1, 1, -1, -1, -1, -1, 1]);
}

#[test]
fn components_that_positions_do_not_relate_are_refused() {
    let (model, positions) = nested_squares();
    let refused = |flat: Vec<f64>| {
        let positions = Positions::from_flat(2, flat).unwrap();
        model
            .oriented_chain_complex(TopOrientation::Positive, Some(&positions))
            .unwrap_err()
            .message()
            .to_owned()
    };
    let mut flat = positions.as_flat().to_vec();
    flat[8..16].fill(1.0);
    assert!(
        refused(flat.clone()).contains("the component of the boundary of cell 0 with facet 4 has no area")
    );
    flat[8..16].copy_from_slice(&square(9.0, 4.0));
    assert!(refused(flat).contains("cell 0, with facets 0 and 4, have the same area"));
    assert!(refused(vec![0.0; 6]).contains("3 positions for 12 vertices"));
    let error = model.oriented_chain_complex(TopOrientation::Positive, None).unwrap_err();
    assert!(error.message().contains("components"), "{error}");
}

/// A cube of side 1 with a cubic void of side 1/2, and the cube in it.
#[test]
fn a_void_of_a_cube_runs_opposite() {
    let cube = cube();
    let twice = |degree: usize, shift: u32| -> RaggedArray {
        let cells = cube.cells(degree);
        RaggedArray::from_lists(
            cells
                .iter()
                .map(<[u32]>::to_vec)
                .chain(cells.iter().map(|c| c.iter().map(|i| i + shift).collect())),
        )
    };
    let solids = RaggedArray::from_lists([(0..16).collect::<Vec<u32>>(), (8..16).collect()]);
    let model = LarModel::new(16, vec![twice(1, 8), twice(2, 8), solids]).unwrap();
    let flat = [grid_positions([1, 1, 1], 0.0, 1.0), grid_positions([1, 1, 1], 0.25, 0.5)].concat();
    let positions = Positions::from_flat(3, flat).unwrap();
    assert!(model.oriented_chain_complex(TopOrientation::Coherent, None).is_err());
    let complex = model.oriented_chain_complex(TopOrientation::Positive, Some(&positions)).unwrap();
    let solids = complex.boundary_matrix(3).unwrap();
    assert_eq!(solids.column(0).rows().len(), 12);
    assert_eq!(signed_measures(&complex, &positions).unwrap(), [0.875, 0.125]);
    for face in 6..12 {
        assert_eq!(solids.entry(face, 0) + solids.entry(face, 1), 0);
    }
    let low = model.oriented_chain_complex(TopOrientation::LowestFacet, Some(&positions)).unwrap();
    assert_eq!(low.boundary_matrix(3).unwrap().entry(0, 0), 1);
    let sizes: Vec<f64> = signed_measures(&low, &positions).unwrap().into_iter().map(f64::abs).collect();
    assert_eq!(sizes, [0.875, 0.125]);
}

/// A square with a triangle inside that touches it in a corner, and a second triangle that touches the first: three cycles, two
/// of which meet in one vertex each time.
#[test]
fn pinched_faces_have_a_component_for_each_cycle() {
    // The face between has the cycles 0123, 045 and 467; the triangles are faces, too.
    let ends = [[0, 1], [1, 2], [2, 3], [0, 3], [0, 4], [4, 5], [0, 5], [4, 6], [6, 7], [4, 7]];
    let lower = edges(8, &ends);
    let facets = RaggedArray::from_lists([(0..10).collect::<Vec<u32>>(), vec![4, 5, 6], vec![7, 8, 9]]);
    let cells = oriented_boundary(&lower, &facets).unwrap();
    let components = cells.boundary_components(CellId::new(0));
    let lists: Vec<Vec<usize>> =
        components.iter().map(|c| c.iter().map(|(facet, _)| facet.index()).collect()).collect();
    assert_eq!(lists, [vec![0, 1, 2, 3], vec![4, 5, 6], vec![7, 8, 9]]);
    assert!(components.iter().all(|component| component[0].1 == Sign::Plus));
    let flat = vec![0., 0., 4., 0., 4., 4., 0., 4., 1., 2., 2., 1., 1., 3., 2., 3.];
    let positions = Positions::from_flat(2, flat).unwrap();
    let lower = [lower];
    let cells = cells.nested(&lower, &positions).unwrap().positive(&lower, &positions).unwrap();
    let exterior = cells.with_exterior().unwrap();
    let complex =
        coface_algebra::chains::ChainComplex::new(vec![lower[0].clone(), exterior.into_boundary()]).unwrap();
    assert_eq!(signed_measures(&complex, &positions).unwrap(), [14.0, 1.5, 0.5, -16.0]);
    let sums =
        (0..10).map(|edge| (0..4).map(|f| complex.boundary_matrix(2).unwrap().entry(edge, f)).sum::<i32>());
    assert!(sums.into_iter().all(|sum| sum == 0));
}

/// The projective plane with six vertices as the boundary of a cell.
#[test]
fn a_boundary_that_is_no_orientable_surface_names_a_chain() {
    let triangles = [
        [0, 1, 2],
        [0, 1, 5],
        [0, 2, 4],
        [0, 3, 4],
        [0, 3, 5],
        [1, 2, 3],
        [1, 3, 4],
        [1, 4, 5],
        [2, 3, 5],
        [2, 4, 5],
    ];
    let plane = FrozenComplex::from_facets(&RaggedArray::from_lists(triangles)).unwrap();
    let complex = plane.chain_complex().unwrap();
    let lower = complex.boundary_matrix(2).unwrap();
    let error =
        oriented_boundary(lower, &RaggedArray::from_lists([(0..10).collect::<Vec<u32>>()])).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::NonManifold);
    let message = error.message();
    let list = message.split("its facets ").nth(1).unwrap().split(" are").next().unwrap();
    let chain: Vec<usize> = list.split(", ").map(|facet| facet.parse().unwrap()).collect();
    // Neighbors share an edge, and an odd number of them conflict.
    let mut conflicts = 0;
    for (i, &face) in chain.iter().enumerate() {
        let (a, b) = (lower.column(face), lower.column(chain[(i + 1) % chain.len()]));
        let common = a.iter().find(|&(edge, _)| b.entry(edge) != 0).expect("neighbors share an edge");
        conflicts += usize::from(common.1 == b.entry(common.0));
    }
    assert_eq!(conflicts % 2, 1);
    let few = oriented_boundary(lower, &RaggedArray::from_lists([[0, 1, 2]])).unwrap_err();
    assert_eq!(few.kind(), ErrorKind::NotACycle);
}

/// Five triangles in a band with a half turn.
#[test]
fn cells_that_cannot_agree_are_named() {
    let triangles = RaggedArray::from_lists([[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]]);
    let band = LarModel::try_from(&FrozenComplex::from_facets(&triangles).unwrap()).unwrap();
    let error = band.oriented_chain_complex(TopOrientation::Coherent, None).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::NonManifold);
    let complex = band.oriented_chain_complex(TopOrientation::LowestFacet, None).unwrap();
    let found = OrientedCells::connected(complex.boundary_matrix(2).unwrap().clone()).coherence().unwrap();
    assert_eq!((found.is_orientable(), found.odd_cycle().unwrap().cells().len()), (Some(false), 5));
    assert_eq!(found.odd_cycle().unwrap().facets().len(), 5);
}

#[test]
fn faults_of_facets_are_named() {
    let lower = edges(3, &[[0, 1], [1, 2], [0, 2]]);
    let message = |list: &[u32]| {
        oriented_boundary(&lower, &RaggedArray::from_lists([&[0, 1, 2], list]))
            .unwrap_err()
            .message()
            .to_owned()
    };
    assert_eq!(message(&[]), "cell 1 has no facet");
    assert_eq!(message(&[3]), "cell 1 names the facet 3, but there are 3");
    assert_eq!(message(&[1, 0, 1]), "cell 1 names the facet 1 twice");
    let none = oriented_boundary(&lower, &RaggedArray::new()).unwrap();
    assert_eq!((none.cell_count(), none.boundary().row_count()), (0, 3));
}

proptest! {
    /// Sets of edges of the complete graph on six vertices as the rim of a face: the signs found make a cycle of each
    /// component; where they are refused, no signs do, or several that no component explains.
    #[test]
    fn signs_agree_with_trying_all(chosen in prop::collection::btree_set(0usize..15, 1..11), turned in any::<u16>()) {
        let mut ends: Vec<[u32; 2]> = (0..6u32).flat_map(|b| (0..b).map(move |a| [a, b])).collect();
        for (i, end) in ends.iter_mut().enumerate() {
            if turned >> i & 1 == 1 {
                end.reverse();
            }
        }
        let lower = edges(6, &ends);
        let list: Vec<u32> = chosen.iter().map(|&e| e as u32).collect();
        let closes = |signs: &[i32]| {
            let mut sums = [0; 6];
            for (&edge, sign) in list.iter().zip(signs) {
                lower.column(edge as usize).iter().for_each(|(vertex, entry)| sums[vertex] += sign * entry);
            }
            sums == [0; 6]
        };
        let solutions = (0u32..1 << list.len())
            .filter(|bits| closes(&(0..list.len()).map(|i| 1 - 2 * (bits >> i & 1) as i32).collect::<Vec<_>>()))
            .count();
        match oriented_boundary(&lower, &RaggedArray::from_lists([&list])) {
            Ok(cells) => {
                let components = cells.boundary_components(CellId::new(0));
                prop_assert_eq!(solutions, 1 << components.len(), "each component has a sign of its own");
                for component in components {
                    prop_assert_eq!(component[0].1, Sign::Plus);
                    let signs: Vec<i32> = list
                        .iter()
                        .map(|&edge| component.iter().find(|c| c.0.to_u32() == edge).map_or(0, |c| c.1.to_i32()))
                        .collect();
                    prop_assert!(closes(&signs));
                }
            }
            Err(error) if error.kind() == ErrorKind::NotACycle => prop_assert_eq!(solutions, 0),
            Err(error) => {
                prop_assert!(error.message().contains("pinched"), "{}", error);
                // Edges are oriented by their ends, so what is left is undecided: more solutions than one and its opposite.
                prop_assert!(solutions != 2);
            }
        }
    }

    /// Grids whose cells and vertices have other numbers keep unit volumes, and the signs are those of any other way:
    /// neighbors agree.
    #[test]
    fn grids_have_unit_cells_whatever_their_numbers(
        shape in [1u32..4, 1u32..4, 1u32..3],
        seed in any::<u64>(),
    ) {
        let model = grid(shape);
        let mut state = seed | 1;
        let mut shuffled = |count: usize| {
            let mut list: Vec<u32> = (0..count as u32).collect();
            for i in (1..count).rev() {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                list.swap(i, (state >> 33) as usize % (i + 1));
            }
            list
        };
        let names = shuffled(model.vertex_count());
        let cells: Vec<RaggedArray> = (1..=3)
            .map(|degree| {
                let cells = model.cells(degree);
                let order = shuffled(cells.len());
                RaggedArray::from_lists(order.iter().map(|&cell| {
                    let list = cells.list(cell as usize);
                    let turn = shuffled(list.len());
                    turn.iter().map(|&i| names[list[i as usize] as usize]).collect::<Vec<_>>()
                }))
            })
            .collect();
        let flat = grid_positions(shape, -0.3, 1.0);
        let mut moved = vec![0.0; flat.len()];
        for (vertex, &name) in names.iter().enumerate() {
            moved[3 * name as usize..][..3].copy_from_slice(&flat[3 * vertex..][..3]);
        }
        let positions = Positions::from_flat(3, moved).unwrap();
        let renamed = LarModel::new(model.vertex_count(), cells).unwrap();
        let complex = renamed.oriented_chain_complex(TopOrientation::Positive, Some(&positions)).unwrap();
        for volume in signed_measures(&complex, &positions).unwrap() {
            prop_assert!((volume - 1.0).abs() < 1e-12);
        }
        let solids = OrientedCells::connected(complex.boundary_matrix(3).unwrap().clone());
        prop_assert_eq!(solids.coherence().unwrap().is_coherent(), Some(true));
        let faces = complex.boundary_matrix(2).unwrap();
        prop_assert!(faces.columns().all(|face| face.entries()[0] == 1));
    }

    /// Triangles with large coordinates that are nearly on a line, and tetrahedra nearly in a plane: signs against integers.
    #[test]
    fn signs_of_measures_are_exact(
        base in prop::collection::vec(-(1i64 << 40)..1 << 40, 3),
        step in prop::collection::vec(-(1i64 << 20)..1 << 20, 6),
        shift in -1i64..=1,
        factors in [-1000i64..1000, -1000i64..1000],
        scale in -500i32..500,
    ) {
        let unit = 2f64.powi(scale);
        let p: Vec<[i64; 3]> = {
            let [u, v] = [[step[0], step[1], step[2]], [step[3], step[4], step[5]]];
            let at = |i: i64, j: i64| [0, 1, 2].map(|k| base[k] + i * u[k] + j * v[k]);
            let mut last = at(factors[0], factors[1]);
            last[2] += shift;
            vec![at(0, 0), at(1, 0), at(0, 1), last]
        };
        let d = |i: usize| [0, 1, 2].map(|k| i128::from(p[i][k] - p[0][k]));
        let (a, b, c) = (d(1), d(2), d(3));
        let volume = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
        let tetrahedron = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2, 3]])).unwrap();
        let complex = tetrahedron.chain_complex().unwrap();
        let cells = OrientedCells::connected(complex.boundary_matrix(3).unwrap().clone());
        let flat: Vec<f64> = p.iter().flatten().map(|&x| x as f64 * unit).collect();
        let turned = cells
            .clone()
            .positive(&complex.boundary_matrices()[..2], &Positions::from_flat(3, flat).unwrap())
            .unwrap();
        prop_assert_eq!(turned != cells, volume < 0);
        // The triangle of 0, 1 and a point on the line through them, moved by the shift.
        let q: Vec<[i64; 2]> = (0..3)
            .map(|i| [base[0] + [0, 1, factors[0]][i] * step[0], base[1] + [0, 1, factors[0]][i] * step[1] + [0, 0, shift][i]])
            .collect();
        let e = |i: usize| [0, 1].map(|k| i128::from(q[i][k] - q[0][k]));
        let area = e(1)[0] * e(2)[1] - e(1)[1] * e(2)[0];
        let lower = [edges(3, &[[0, 1], [1, 2], [0, 2]])];
        let cells = oriented_boundary(&lower[0], &RaggedArray::from_lists([[0, 1, 2]])).unwrap();
        let flat: Vec<f64> = q.iter().flatten().map(|&x| x as f64 * unit).collect();
        let turned = cells.clone().positive(&lower, &Positions::from_flat(2, flat).unwrap()).unwrap();
        prop_assert_eq!(turned != cells, area < 0);
    }
}

#[test]
fn lengths_on_a_line_are_made_positive() {
    let model = LarModel::new(3, vec![RaggedArray::from_lists([[0, 1], [1, 2], [2, 0]])]).unwrap();
    let positions = Positions::from_flat(1, vec![0.0, -1.0, 5.0]).unwrap();
    let complex = model.oriented_chain_complex(TopOrientation::Positive, Some(&positions)).unwrap();
    assert_eq!(signed_measures(&complex, &positions).unwrap(), [1.0, 6.0, 5.0]);
    let plane = Positions::from_flat(2, vec![0.0; 6]).unwrap();
    assert!(model.oriented_chain_complex(TopOrientation::Positive, Some(&plane)).is_err());
    assert!(model.oriented_chain_complex(TopOrientation::Positive, None).is_err());
    let points =
        LarModel::new(2, vec![]).unwrap().oriented_chain_complex(TopOrientation::Coherent, None).unwrap();
    assert_eq!(points.f_vector(), [2]);
}
