//! Every producer of this crate keeps the contract of `Cells`.

use coface_algebra::samples::keeps_the_contract;
use coface_algebra::{Error, RaggedArray};
use coface_arrange::congruence::{CellClasses, chain_congruence};
use coface_arrange::planar::PlanarArrangement;
use coface_arrange::spatial::{
    PolygonalComplex, SpatialArrangement, SpatialCells, SpatialOptions, SpatialPolygons,
    arrange_by_congruence,
};
use coface_complexes::grids::CuboidGrid;
use coface_geometry::Positions;

/// The corners and the squares of a cube.
fn cube(low: f64) -> Result<(Positions, RaggedArray), Error> {
    let corner = |i: u32| [i & 1, i >> 1 & 1, i >> 2 & 1].map(|bit| low + f64::from(bit));
    let corners = Positions::from_flat(3, (0..8).flat_map(corner).collect())?;
    let squares = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    Ok((corners, RaggedArray::from_lists(squares)))
}

#[test]
fn planar_arrangements_keep_the_contract() -> Result<(), Error> {
    let points = Positions::from_flat(2, vec![0., 0., 2., 2., 2., 0., 0., 2., 3., 3., 4., 3.])?;
    let bow_tie = RaggedArray::from_lists([&[0, 1, 2, 3, 0][..], &[4, 5]]);
    let bow_tie = PlanarArrangement::from_polylines(&points, &bow_tie)?;
    assert_eq!(bow_tie.f_vector(), [7, 7, 2]);
    keeps_the_contract("bow tie", &bow_tie, true);
    let corners = [0., 0., 6., 0., 0., 6., 1., 1., 2., 1., 1., 2.];
    let corners = Positions::from_flat(2, corners.to_vec())?;
    let segments = [[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3]];
    keeps_the_contract("triangle with a hole", &PlanarArrangement::new(&corners, &segments)?, true);
    Ok(())
}

#[test]
fn polygonal_complexes_and_cells_keep_the_contract() -> Result<(), Error> {
    let walks = RaggedArray::from_lists([[0, 1, 2], [3, 5, 4]]);
    keeps_the_contract("holed polygon", &PolygonalComplex::from_walks(6, &walks, &[0, 0], &[[0, 3]])?, false);
    let (corners, squares) = cube(0.0)?;
    let complex = PolygonalComplex::from_polygons(8, &squares)?;
    keeps_the_contract("squares", &complex, true);
    keeps_the_contract("cells", &SpatialCells::new(complex, &corners)?, true);
    Ok(())
}

#[test]
fn spatial_arrangements_keep_the_contract() -> Result<(), Error> {
    let polygons =
        |low: f64| cube(low).and_then(|(corners, squares)| SpatialPolygons::from_polygons(corners, squares));
    let two = SpatialPolygons::joined(&[polygons(0.0)?, polygons(0.5)?])?;
    let arrangement = SpatialArrangement::new(&two, &SpatialOptions::new())?;
    assert_eq!(arrangement.f_vector()[3], 3);
    keeps_the_contract("two cubes", &arrangement, true);
    let apart = SpatialPolygons::joined(&[polygons(0.0)?, polygons(7.0)?])?;
    keeps_the_contract("cubes apart", &SpatialArrangement::new(&apart, &SpatialOptions::new())?, true);
    Ok(())
}

#[test]
fn congruence_keeps_the_contract() -> Result<(), Error> {
    let tetrahedron = [0., 0., 0., 2., 0., 0., 0., 2., 0., 0., 0., 2.];
    let blade = [-1., -1., 1., 5., -1., 1., -1., 5., 1.];
    let positions = Positions::from_flat(3, [&tetrahedron[..], &blade].concat())?;
    let walks = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3], [4, 5, 6]]);
    let cut = arrange_by_congruence(&positions, &walks, &[0, 1, 2, 3, 4], 1e-9)?;
    // The blade around the cut has a hole.
    keeps_the_contract("arrangement by congruence", &cut, false);
    // A row of three squares with its far sides identified: an annulus.
    let grid = CuboidGrid::new(&[3, 1])?.chain_complex()?;
    let classes = (0..8).map(|vertex| if vertex >= 6 { vertex - 6 } else { vertex }).collect();
    let annulus = chain_congruence(&grid, CellClasses::unsigned(classes)?, None, Default::default())?;
    assert_eq!(annulus.complex().f_vector(), [6, 9, 3]);
    keeps_the_contract("chain congruence", &annulus, true);
    Ok(())
}
