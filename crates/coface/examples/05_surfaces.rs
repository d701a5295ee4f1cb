//! Guide 5: surfaces as halfedges and as polygons glued in pairs; cut open, their loops, cocycles and universal covers.
//!
//! Run with `cargo run -p coface --example 05_surfaces`.

use coface::EdgeId;
use coface::algebra::Sign;
use coface::complexes::known_spaces::{cyclic_torus, klein_grid, oriented_sum};
use coface::complexes::surface::{GeneralizedMap, HalfedgeMesh};
use coface::topology::{
    CocycleBasis, CoverExtent, CutSurface, CycleKind, SurfaceHomology, SurfaceHomotopy, TreeCotree,
    UniversalCover, shortest_cycle,
};

fn main() -> Result<(), coface::Error> {
    // A permutation of an even number of halfedges is a surface: one face, one vertex, a torus.
    let square = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    assert_eq!((square.f_vector(), square.genus()), (vec![1, 2, 1], 1));

    // A Klein bottle is no halfedge mesh, but polygons glued in pairs; above it lies a torus, two to one.
    let bottle = GeneralizedMap::new(klein_grid(5, 5)?.freeze().two_skeleton()?)?;
    assert_eq!(bottle.surfaces()[0].to_string(), "Klein bottle");
    let double = bottle.orientation_double_cover();
    assert_eq!(double.map().surfaces()[0].to_string(), "torus");

    // A double torus of 11 vertices: cut along 14 edges it is a disk with 28 sides, around which each generator is read twice.
    let torus = cyclic_torus(2)?;
    let surface = GeneralizedMap::new(oriented_sum(&torus, &torus, Sign::Plus)?.freeze().two_skeleton()?)?;
    let trees = TreeCotree::new(&surface);
    let cut = CutSurface::new(&surface, &trees);
    let domain = &cut.domains()[0];
    assert_eq!((domain.cut_edge_count(), domain.side_count(), domain.euler_characteristic()), (14, 28, 1));
    let relator = domain.relator().expect("a closed surface has a relator");
    assert_eq!(relator.len(), 8);

    // Loops: the shortest that cannot be contracted, and the loops of the generators, whose commutators can.
    let shortest = shortest_cycle(&surface, None, CycleKind::NonContractible, 1_000)?;
    assert_eq!(shortest.map(|cycle| cycle.length()), Some(3.0));
    let homotopy = SurfaceHomotopy::new(&surface, &trees)?;
    let around = homotopy.walk_of_word(0, &relator);
    assert!(homotopy.is_contractible(&around)?);

    // First cohomology: cocycles by slicing have intersection numbers as values; their dual basis has the unit matrix.
    let homology = SurfaceHomology::new(&surface, &trees);
    let sliced = CocycleBasis::by_slicing(&surface, homology.loops())?;
    assert_eq!(sliced.determinant(), Some(&1.into()));
    assert_eq!(sliced.dual()?.pairing()[0], [1, 0, 0, 0]);

    // The universal cover as far as words of two letters reach: 1 + 8 + 56 copies of the disk, glued to one disk.
    let cover = UniversalCover::new(&surface, &cut, 0, CoverExtent::Radius(2), 100_000)?;
    assert_eq!(cover.sphere_sizes(), [1, 8, 56]);
    assert_eq!(cover.euler_characteristic(), 1);
    assert_eq!(cover.f_vector()[2], 65 * surface.f_vector()[2]);
    assert!(cover.edge_below(EdgeId::new(0)).index() < surface.f_vector()[1]);
    Ok(())
}
