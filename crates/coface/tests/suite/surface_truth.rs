//! Surfaces and cell meshes of real files against the measured facts of the manifest.
//!
//! The files lie in the folder that the environment variable `COFACE_DATA` names; without it the tests say so and pass.
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use coface::Error;
use coface::ErrorKind;
use coface::complexes::cell_mesh::{CellMesh, cell_volumes};
use coface::complexes::surface::{GeneralizedMap, PolygonMesh};
use coface::geometry::{Positions, enclosed_volume, polygon_area};
use coface::io::{Model, read_path};
use coface::topology::{CutSurface, TreeCotree, homology};
use serde_json::Value;
use std::path::PathBuf;

fn data() -> Option<PathBuf> {
    let folder = std::env::var_os("COFACE_DATA").map(PathBuf::from);
    if folder.is_none() {
        println!("skipped: COFACE_DATA names no folder");
    }
    folder
}

/// The records of files in this folder with their models; formats without a reader are left out.
fn models(folder: &str) -> Vec<(Value, Model)> {
    let Some(data) = data() else { return Vec::new() };
    let manifest = std::fs::read_to_string(data.join("MANIFEST.json")).expect("the data has a manifest");
    let manifest: Value = serde_json::from_str(&manifest).expect("the manifest is JSON");
    let mut found = Vec::new();
    for record in manifest["files"].as_array().expect("the manifest lists files") {
        let file = record["file"].as_str().expect("a record names its file");
        if !file.starts_with(folder) || record["vertices"].is_null() {
            continue;
        }
        match read_path(data.join(file), None) {
            Ok(model) => found.push((record.clone(), model)),
            Err(error) if error.kind() == ErrorKind::UnsupportedFormat => println!("skipped: {error}"),
            Err(error) => panic!("{error}"),
        }
    }
    found
}

fn loose_edges(model: &Model) -> Vec<[u32; 2]> {
    model.lines().iter().flat_map(|line| line.windows(2).map(|pair| [pair[0], pair[1]])).collect()
}

/// Compares a number that we found with the record, if the record has it.
fn check(record: &Value, key: &str, found: impl Into<Value>) {
    if !record[key].is_null() {
        assert_eq!(found.into(), record[key], "{key} of {}", record["file"]);
    }
}

/// The same for a measure, which the manifest gives to nine digits.
fn check_close(record: &Value, key: &str, found: Option<f64>) {
    if let (Some(expected), Some(found)) = (record[key].as_f64(), found) {
        assert!(
            (found - expected).abs() <= 5.1e-9 * expected.abs(),
            "{key} of {}: {found}, not {expected}",
            record["file"]
        );
    }
}

/// The first three coordinates of points in four dimensions, and other points as they are: the tools that measured the
/// areas of the manifest looked at `tetraplex.off` that way.
fn in_space(positions: &Positions) -> Result<Positions, Error> {
    if positions.dimension() != 4 {
        return Ok(positions.clone());
    }
    Positions::from_flat(3, positions.as_flat().chunks(4).flat_map(|point| point[..3].to_vec()).collect())
}

#[test]
fn the_600_cell_has_its_area_in_four_dimensions() -> Result<(), Error> {
    for (_, model) in models("surfaces/tetraplex.off") {
        // 1200 triangles with sides sqrt(5) - 1, at a radius of 2, to the six digits of the file.
        let side = 5f64.sqrt() - 1.0;
        let area = polygon_area(model.positions(), model.polygons()).expect("there are positions");
        assert!((area - 1200.0 * 3f64.sqrt() / 4.0 * side * side).abs() < 5e-3, "{area}");
    }
    Ok(())
}

#[test]
fn surfaces_are_what_the_manifest_says() -> Result<(), Error> {
    let mut checked = 0;
    for (record, model) in models("surfaces/").into_iter().chain(models("tricky/")) {
        let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &loose_edges(&model))?;
        let survey = mesh.survey();
        let (verdict, orientation) = (survey.verdict(), survey.orientation());
        check(&record, "vertices", mesh.vertex_count());
        check(&record, "edges", mesh.edge_count());
        check(&record, "faces", mesh.face_count());
        check(&record, "duplicate_faces", mesh.duplicate_faces().len());
        check(&record, "components", survey.components().count());
        check(&record, "euler", mesh.euler_characteristic());
        check(&record, "manifold", verdict.is_manifold());
        check(&record, "nonmanifold_edges", verdict.non_manifold_edges().len());
        check(&record, "nonmanifold_vertices", verdict.non_manifold_vertices().len());
        check(&record, "boundary_edges", verdict.boundary_edge_count());
        check(&record, "boundary_loops", survey.boundary_loops().len());
        let simple = survey.boundary_loops().iter().all(|boundary| boundary.is_simple());
        check(&record, "boundary_is_simple_loops", simple);
        check(&record, "orientable", orientation.is_orientable());
        check(&record, "coherently_oriented", orientation.is_coherent());
        if let Some(genus) = record["genus"].as_u64() {
            let found: usize =
                survey.parts().iter().filter_map(|part| part.surface()).map(|s| s.genus()).sum();
            assert_eq!(found as u64, genus, "genus of {}", record["file"]);
        }
        let isolated = survey.parts().iter().filter(|part| part.f_vector() == [1, 0, 0]).count();
        check(&record, "isolated_vertices", isolated);
        check_close(&record, "area", polygon_area(&in_space(model.positions())?, mesh.polygons()));
        check_close(&record, "signed_volume", enclosed_volume(model.positions(), mesh.polygons()));
        checked += 1;
        println!("{}: {:?}", record["file"], survey.name());
    }
    assert!(data().is_none() || checked >= 22, "{checked} files");
    Ok(())
}

#[test]
fn top_homology_agrees_with_orientation() -> Result<(), Error> {
    for (record, model) in models("surfaces/") {
        let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &[])?;
        let survey = mesh.survey();
        if !survey.verdict().is_manifold() {
            continue;
        }
        // A connected surface has Z in degree 2 exactly if it is closed and orientable.
        let closed_orientable = survey
            .parts()
            .iter()
            .filter_map(|part| part.surface())
            .filter(|surface| surface.is_orientable() && surface.boundary_count() == 0)
            .count();
        let betti = homology(&mesh.chain_complex().unwrap()).betti_numbers();
        assert_eq!(betti[2], closed_orientable, "{}", record["file"]);
    }
    Ok(())
}

#[test]
fn halfedge_meshes_are_what_the_manifest_says() -> Result<(), Error> {
    let mut checked = 0;
    for (record, model) in models("surfaces/").into_iter().chain(models("tricky/")) {
        let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &loose_edges(&model))?;
        let survey = mesh.survey();
        let made = mesh.halfedges();
        let is_surface = survey.verdict().is_manifold();
        assert_eq!(made.is_ok(), is_surface && survey.orientation().is_coherent() == Some(true));
        if !is_surface || survey.orientation().is_orientable() != Some(true) {
            println!("{}: {}", record["file"], made.expect_err("no oriented surface"));
            continue;
        }
        let halfedges = mesh.oriented()?.halfedges()?;
        halfedges.check()?;
        assert_eq!(halfedges.f_vector(), mesh.f_vector());
        check(&record, "components", halfedges.component_count());
        check(&record, "euler", halfedges.euler_characteristic());
        check(&record, "boundary_loops", halfedges.outer_face_count());
        check(&record, "genus", halfedges.genus());
        let along: usize = halfedges.outer_faces().map(|outer| halfedges.boundary_loop(outer).count()).sum();
        check(&record, "boundary_edges", along);
        assert_eq!(halfedges.to_polygon_mesh()?.edge_ends(), mesh.edge_ends());
        checked += 1;
    }
    assert!(data().is_none() || checked >= 12, "{checked} files");
    Ok(())
}

#[test]
fn cell_meshes_are_what_the_manifest_says() -> Result<(), Error> {
    let mut checked = 0;
    for (record, model) in models("volumes/") {
        let mesh = CellMesh::new(
            model.vertex_count(),
            model.shapes().to_vec(),
            model.cells().clone(),
            model.polygons(),
            &loose_edges(&model),
        )?;
        let (vertices, edges, faces, cells) =
            (mesh.vertex_count(), mesh.edge_count(), mesh.face_count(), mesh.cell_count());
        check(&record, "vertices", vertices);
        check(&record, "edges", edges);
        check(&record, "faces", faces);
        check(&record, "cells", cells);
        check(&record, "duplicate_cells", mesh.duplicate_cells().len());
        check(&record, "components", mesh.components().count());
        check(&record, "euler", mesh.euler_characteristic());
        let verdict = mesh.manifold_verdict();
        check(&record, "manifold", verdict.is_manifold());
        check(&record, "orientable", mesh.orientation().is_orientable());
        let boundary = mesh.boundary_surface();
        let survey = boundary.mesh().survey();
        check(&record, "boundary_faces", verdict.boundary_face_count());
        check(&record, "boundary_faces", boundary.faces().len());
        check(&record, "boundary_surfaces", survey.components().count());
        check(&record, "boundary_euler", boundary.mesh().euler_characteristic());
        check(&record, "boundary_is_manifold", survey.verdict().is_manifold());
        if let Some(surface) = survey.surface() {
            check(&record, "genus", surface.genus());
        }
        let volumes =
            cell_volumes(model.positions(), model.shapes(), model.cells()).expect("cells lie in space");
        if record["hexes"] == 0 {
            check(&record, "tets_positive", volumes.positive_count());
            check(&record, "tets_negative", volumes.negative_count());
            check_close(&record, "tet_volume", Some(volumes.absolute()));
        }
        let betti = homology(&mesh.chain_complex().unwrap()).betti_numbers();
        check(&record, "betti", betti);
        println!("{}: {:?}", record["file"], verdict.witness().map(|defect| defect.message()));
        checked += 1;
    }
    assert!(data().is_none() || checked >= 4, "{checked} files");
    Ok(())
}

#[test]
fn real_surfaces_are_cut_to_disks() -> Result<(), Error> {
    for (record, model) in models("surfaces/") {
        let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &loose_edges(&model))?;
        let map = match GeneralizedMap::new(mesh.two_skeleton().unwrap()) {
            Ok(map) => map,
            Err(error) => {
                assert_eq!(error.kind(), ErrorKind::NonManifold);
                check(&record, "manifold", false);
                continue;
            }
        };
        check(&record, "manifold", true);
        check(&record, "boundary_loops", map.boundary_loops().len());
        check(&record, "components", map.component_count());
        let surfaces = map.surfaces();
        check(&record, "orientable", surfaces.iter().all(|surface| surface.is_orientable()));
        check(&record, "genus", surfaces.iter().map(|surface| surface.genus()).sum::<usize>());
        let trees = TreeCotree::new(&map);
        let cut = CutSurface::new(&map, &trees);
        let mut sides = 0;
        for (part, domain) in trees.components().iter().zip(cut.domains()) {
            assert_eq!(domain.euler_characteristic(), 1);
            sides += domain.side_count();
            let Some(relator) = domain.relator() else { continue };
            let mut count = vec![0; part.generators().len()];
            relator.letters().iter().for_each(|letter| count[letter.unsigned_abs() as usize - 1] += 1);
            assert!(count.iter().all(|&count| count == 2), "each generator is on the boundary twice");
        }
        // All surfaces here have free first homology.
        let rank: usize = trees.components().iter().map(|part| part.generators().len()).sum();
        check(&record, "torsion", "none");
        assert_eq!(rank as u64, record["betti"][1].as_u64().expect("the record has Betti numbers"));
        let sliced = map.slice_edges(&cut.cut_graph(&map))?;
        assert_eq!(sliced.surface().boundary_loops().iter().map(Vec::len).sum::<usize>(), sides);
        assert!(sliced.surface().surfaces().iter().all(|surface| surface.to_string() == "disk"));
        assert_eq!(sliced.surface().component_count(), trees.components().len());
    }
    Ok(())
}
