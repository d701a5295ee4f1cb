//! Guide 8: what polygons cut space into, which solids each cell lies in, Booleans by formula, and where each face comes from.
//!
//! Run with `cargo run -p coface --example 08_solids_and_booleans`.

use coface::algebra::{RaggedArray, Sign};
use coface::arrange::boolean::{BooleanFormula, CellSelection, InsideRule};
use coface::arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
use coface::{CellId, Error, FaceId, Positions};

/// A box whose sides run counterclockwise, seen from outside.
fn cuboid(low: [f64; 3], high: [f64; 3]) -> Result<SpatialPolygons, Error> {
    let corner = |i: usize| (0..3).map(move |axis| if i >> axis & 1 == 1 { high[axis] } else { low[axis] });
    let positions = Positions::from_flat(3, (0..8).flat_map(corner).collect())?;
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(sides))
}

fn main() -> Result<(), Error> {
    // Two cubes of side 2 that share a unit cube. Space falls into three bounded cells: only the first, both, only the second.
    let cubes = [cuboid([0.0; 3], [2.0; 3])?, cuboid([1.0; 3], [3.0; 3])?];
    let scene = SpatialArrangement::new(&SpatialPolygons::joined(&cubes)?, &SpatialOptions::new())?;
    assert_eq!(scene.volumes()?, [7.0, 1.0, 7.0]);
    assert_eq!(scene.inside(InsideRule::Nonzero)?, [vec![0], vec![0, 1], vec![1]]);
    // 8 + 8 corners, and 6 points where an edge of one cube crosses a side of the other.
    assert_eq!(scene.f_vector(), [22, 36, 18, 3]);

    // The winding numbers say how often the boundary of each input runs around a cell: the common cell is inside both.
    let winding = scene.winding_numbers()?;
    assert_eq!(winding.of_cell(CellId::new(1)), [1, 1]);

    // A Boolean is a choice of cells; its boundary is a choice of faces, with the side that looks outward. All of them from one arrangement.
    let complex = scene.coarse_complex()?;
    let volumes = scene.volumes()?;
    for (text, volume, faces) in
        [("a | b", 15.0, 12), ("a & b", 1.0, 6), ("a - b", 7.0, 9), ("a ^ b", 14.0, 18)]
    {
        let formula = BooleanFormula::parse(text, &[])?;
        let selection = CellSelection::by_formula(&winding, &formula, InsideRule::Nonzero)?;
        assert_eq!(selection.cells().map(|cell| volumes[cell.index()]).sum::<f64>(), volume, "{text}");
        let boundary = selection.boundary(&complex)?;
        assert_eq!(boundary.facets().len(), faces, "{text}");
    }
    // The symmetric difference touches itself along the hexagon where the two surfaces cross: four faces meet at each of its 6 edges.
    let formula = BooleanFormula::parse("a ^ b", &[])?;
    let selection = CellSelection::by_formula(&winding, &formula, InsideRule::Nonzero)?;
    assert_eq!(selection.boundary(&complex)?.pinched_ridges().len(), 6);

    // Provenance: polygons 0 to 5 are the sides of the first cube, 6 to 11 those of the second, and each face knows its own.
    let formula = BooleanFormula::parse("a - b", &[])?;
    let difference =
        CellSelection::by_formula(&winding, &formula, InsideRule::Nonzero)?.boundary(&complex)?;
    let from_second = difference.facets().iter().filter(|(facet, sign)| {
        let sources = scene.polygons_of_face(FaceId::new(facet.index()));
        // A side of the tool looks into the hole that it leaves, so it stands in the result turned around.
        sources.iter().any(|&(polygon, side)| polygon >= 6 && side != *sign)
    });
    assert_eq!(from_second.count(), 3);

    // A cube in a cube: the cell between them has two boundary components, and the winding numbers say which cell is deeper.
    let nested = [cuboid([0.0; 3], [3.0; 3])?, cuboid([1.0; 3], [2.0; 3])?];
    let nested = SpatialArrangement::new(&SpatialPolygons::joined(&nested)?, &SpatialOptions::new())?;
    assert_eq!((nested.volumes()?, nested.void_count()), (vec![26.0, 1.0], 1));
    assert_eq!(nested.inside(InsideRule::Nonzero)?, [vec![0], vec![0, 1]]);
    // A side of the outer cube has the first cell on one side and the unbounded one, which is no cell, on the other.
    let sides = [Sign::Plus, Sign::Minus].map(|side| nested.cell_at(FaceId::new(0), side));
    assert!(sides.contains(&None) && sides.contains(&Some(CellId::new(0))));
    Ok(())
}
