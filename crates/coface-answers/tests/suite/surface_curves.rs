//! Curves and cocycles of real surfaces. The folder named by the environment variable `COFACE_DATA` holds them; without it the
//! test says that it skips.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a skipped test says so, and times are of interest")]

use coface_algebra::CellId;
use coface_answers::Producer;
use coface_complexes::surface::GeneralizedMap;
use coface_io::read_path;
use coface_topology::{
    CocycleBasis, CutGraph, CycleKind, Exactness, SurfaceHomology, TreeCotree, cotangent_weights, exactness,
    harmonic_forms, shortest_cycle, shortest_homology_basis,
};
use std::path::PathBuf;
use std::time::Instant;

/// The surfaces that are small enough, with the lengths of their edges.
fn surfaces() -> Vec<(String, GeneralizedMap, Vec<f64>)> {
    let Some(folder) = std::env::var_os("COFACE_DATA").map(PathBuf::from) else {
        println!("COFACE_DATA is not set: the curves of real surfaces are skipped");
        return Vec::new();
    };
    let mut paths: Vec<PathBuf> =
        std::fs::read_dir(folder.join("surfaces")).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let surface = |path: PathBuf| {
        let model = read_path(&path, None).ok()?;
        if model.polygons().len() > 50_000 {
            return None;
        }
        let producer = Producer::of(model).ok()?;
        let map = GeneralizedMap::new(producer.two_skeleton().ok()?).ok()?;
        let number = |&end: &u32| producer.cell_vertices(0, CellId::from_u32(end))[0];
        let ends: Vec<u32> = map.skeleton().edge_ends().iter().map(number).collect();
        let lengths = producer.positions().distances(&ends).ok()?;
        Some((path.file_name().unwrap().to_string_lossy().into_owned(), map, lengths))
    };
    paths.into_iter().filter_map(surface).collect()
}

#[test]
fn real_surfaces_have_cocycles_and_short_curves() {
    for (name, map, lengths) in surfaces() {
        let begin = Instant::now();
        let trees = TreeCotree::new(&map);
        let homology = SurfaceHomology::new(&map, &trees);
        let basis = CocycleBasis::by_crossing(&homology);
        for (cocycle, row) in basis.cocycles().iter().zip(basis.pairing()) {
            let Exactness::Closed { .. } = exactness(map.skeleton(), cocycle).unwrap() else {
                panic!("{name}: a cocycle of a basis is closed and not exact");
            };
            for (walk, &value) in basis.loops().iter().zip(row) {
                let found = cocycle.pairing(&walk.chain()).unwrap().map_or(0, |x| x.to_i64().unwrap());
                assert_eq!(found, value, "{name}");
            }
        }
        let is_closed = trees.components().iter().all(|component| !component.has_boundary());
        if is_closed && map.orientation().conflicts().iter().all(Option::is_none) {
            let sliced = CocycleBasis::by_slicing(&map, homology.loops()).unwrap();
            assert_eq!(sliced.determinant(), Some(&1.into()), "{name}");
            let dual = sliced.dual().unwrap();
            for (a, b) in dual.cocycles().iter().zip(basis.cocycles()).take(4) {
                let difference = a.minus(b).unwrap();
                let verdict = exactness(map.skeleton(), &difference).unwrap();
                assert!(matches!(verdict, Exactness::Exact { .. }), "{name}");
            }
        }
        if let Ok(weights) = cotangent_weights(&map, &lengths)
            && basis.cocycles().len() < 20
        {
            let size = weights.iter().fold(1.0, |size: f64, weight| size.max(weight.abs()));
            for form in harmonic_forms(&map, basis.cocycles(), &weights).unwrap() {
                // Flat triangles have very large weights; what rounding leaves grows with them.
                let residuals = [form.closed_residual(), form.coclosed_residual() / size];
                assert!(residuals.iter().all(|&x| x < 1e-6), "{name}: {residuals:?}, weights up to {size:e}");
            }
        }
        let cocycles = begin.elapsed();
        if homology.generators().len() > 120 {
            println!("{name}: {} loops; cocycles {cocycles:.2?}", homology.generators().len());
            continue;
        }
        let graph = CutGraph::new(&map, &trees, Some(&lengths)).unwrap();
        let short = graph.shortened(&map, Some(&lengths), 2).unwrap();
        assert!(short.length() <= graph.length(), "{name}");
        let disks = map.slice_edges(&short.edges()).unwrap();
        assert!(disks.surface().surfaces().iter().all(|surface| surface.to_string() == "disk"), "{name}");
        let cut = begin.elapsed() - cocycles;
        let cycle = shortest_cycle(&map, Some(&lengths), CycleKind::NonContractible, 10_000_000).unwrap();
        let basis = shortest_homology_basis(&map, Some(&lengths), 100_000_000).unwrap();
        assert_eq!(basis.len(), homology.generators().len(), "{name}");
        if let Some(first) = basis.first() {
            // What does not bound cannot be contracted.
            let (a, b) = (cycle.unwrap().length(), first.length());
            assert!(a <= b * (1.0 + 1e-12), "{name}: {a} {b}");
        }
        let curves = begin.elapsed() - cocycles - cut;
        println!(
            "{name}: {} loops; cocycles {cocycles:.2?}, cut graph {:.4} to {:.4} {cut:.2?}, cycles {curves:.2?}",
            basis.len(),
            graph.length(),
            short.length()
        );
    }
}
