//! Guide 6: cells as lists of vertices, grids, oriented boundaries, moments, and complexes that are merged.
//!
//! Run with `cargo run -p coface --example 06_cells_and_congruence`.

use coface::algebra::RaggedArray;
use coface::arrange::congruence::{
    CellClasses, ClassRule, CongruenceOptions, Representative, chain_congruence, vertex_congruence,
};
use coface::complexes::grids::{AxisSet, CuboidGrid, GridCell};
use coface::complexes::lar::{LarModel, Shared, oriented_boundary};
use coface::complexes::shapes;
use coface::complexes::shapes::CellKind;
use coface::complexes::surface::PolygonMesh;
use coface::geometry::MassProperties;
use coface::io::Model;
use coface::topology::homology;
use coface::{CellId, VertexId};

fn main() -> Result<(), coface::Error> {
    // A grid of 3 by 2 by 1 cuboids knows all its cells by arithmetic: here the square that spans axes 0 and 2 at a corner.
    let grid = CuboidGrid::new(&[3, 2, 1])?;
    assert_eq!(grid.f_vector(), [24, 46, 29, 6]);
    let square = GridCell::new(AxisSet::from_iter([0, 2]), vec![1, 2, 0]);
    let number = grid.number(&square).expect("it is a cell of the grid");
    assert_eq!(grid.cell(2, number), square);

    // As lists of vertices: faces that share two vertices have a common edge, as all cells are convex.
    let model = grid.lar_model()?;
    let neighbors = model.related("FF".parse()?, Shared::AtLeast(2))?;
    assert_eq!(neighbors, model.incident("FF".parse()?)?);
    // How many pairs of a face and an edge share no, one and both vertices.
    assert_eq!(model.counts("FE".parse()?)[2], 4 * 29);

    // Two squares in one face: the outer and the inner cycle are components that only positions can relate.
    let ring = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
    let edges = LarModel::new(8, vec![RaggedArray::from_lists(ring)])?.edge_boundaries()?;
    let face = oriented_boundary(&edges, &RaggedArray::from_lists([[0, 1, 2, 3, 4, 5, 6, 7]]))?;
    assert_eq!(face.boundary_components(CellId::new(0)).len(), 2);

    // A ball of tetrahedra, its surface, and what that encloses.
    let ball = shapes::ball(1.0, 8, CellKind::Simplex)?;
    let surface = Model::from_placed_cells(ball.boundary()?.compacted())?;
    let mass = MassProperties::enclosed(surface.positions(), surface.polygons()).expect("it is in space");
    assert!(mass.volume() > 4.0 && mass.volume() < 4.2);

    // Triangles with vertices of their own, as scanners and STL files give them, become one sphere.
    let sphere = surface
        .polygons()
        .iter()
        .flatten()
        .map(|&vertex| surface.positions().point(VertexId::from_u32(vertex)));
    let soup = coface::geometry::Positions::from_flat(3, sphere.flatten().copied().collect())?;
    let corners = RaggedArray::uniform(3, (0..soup.len() as u32).collect())?;
    let separate = PolygonMesh::new(soup.len(), corners, &[])?.chain_complex()?;
    let near = vertex_congruence(&soup, 1e-9, ClassRule::Transitive, Representative::Lowest)?;
    let classes = CellClasses::unsigned(near.class_of().to_vec())?;
    let merged = chain_congruence(&separate, classes, Some(near.positions()), CongruenceOptions::default())?;
    assert_eq!(merged.complex().euler_characteristic(), 2);
    let whole = PolygonMesh::new(surface.vertex_count(), surface.polygons().clone(), &[])?.chain_complex()?;
    assert_eq!(merged.complex().f_vector(), whole.f_vector());
    assert_eq!(homology(merged.complex()).groups(), homology(&whole).groups());
    assert_eq!(merged.complex().f_vector(), [386, 1152, 768]);
    Ok(())
}
