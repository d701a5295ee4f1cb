//! What the questions make of complexes keeps the contract of `Cells`: covers and cut surfaces.

use coface_algebra::Error;
use coface_algebra::samples::keeps_the_contract;
use coface_complexes::known_spaces;
use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
use coface_topology::{CoverExtent, CutGraph, CutSurface, TreeCotree, UniversalCover};

#[test]
fn covers_keep_the_contract() -> Result<(), Error> {
    let plane = GeneralizedMap::new(known_spaces::projective_plane()?.freeze().two_skeleton()?)?;
    let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    for (name, map, extent, counts) in [
        ("sphere over the projective plane", &plane, CoverExtent::Copies(2), [12, 30, 20]),
        ("part of the plane over the torus", &torus, CoverExtent::Radius(1), [12, 16, 5]),
    ] {
        let cut = CutSurface::new(map, &TreeCotree::new(map));
        let cover = UniversalCover::new(map, &cut, 0, extent, 1000)?;
        assert_eq!(cover.f_vector(), counts, "{name}");
        keeps_the_contract(name, &cover, true);
        keeps_the_contract(name, map.orientation_double_cover().map(), true);
    }
    Ok(())
}

#[test]
fn cut_surfaces_keep_the_contract() -> Result<(), Error> {
    let torus = GeneralizedMap::new(known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?)?;
    let trees = TreeCotree::new(&torus);
    let disk = torus.slice_edges(&CutGraph::new(&torus, &trees, None)?.edges())?;
    assert_eq!(disk.surface().f_vector()[2], 14);
    keeps_the_contract("disk of the torus", disk.surface(), true);
    Ok(())
}
