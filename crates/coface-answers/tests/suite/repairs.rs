//! Surfaces made of what files hold.

use coface_algebra::RaggedArray;
use coface_answers::{Answer, RepairRequest, Report, SurfaceRepairRequest, repaired, repaired_surface};
use coface_complexes::surface::PolygonMesh;
use coface_io::{Format, Model, Structure, read, read_path};
use proptest::prelude::*;
use std::path::PathBuf;

fn facets(lists: &[Vec<u32>]) -> Model {
    Model::from_structure(Structure::Facets(RaggedArray::from_lists(lists)))
}

fn closed() -> SurfaceRepairRequest {
    SurfaceRepairRequest::new().closed(true)
}

/// A closed manifold.
fn check_closed(model: &Model, what: &str) {
    let report = Report::of(model.clone()).expect("a surface has a report");
    if report.f_vector().len() < 3 {
        return;
    }
    assert_eq!((report.manifold(), report.is_closed()), (Answer::Yes, Some(true)), "{what}");
}

#[test]
fn a_facet_list_is_repaired_without_positions() {
    // A triangle, a repeated one, a loose edge, a point, and a pinch.
    let model = facets(&[vec![10, 20, 30], vec![20, 30, 10], vec![30, 40, 50], vec![50, 60], vec![70]]);
    let (surface, done) = repaired_surface(&model, &closed()).unwrap();
    assert_eq!((done.duplicate_count(), done.loose_line_count(), done.unused_count()), (1, 1, 2));
    assert_eq!((done.mesh().vertices_split().len(), done.hole_count()), (1, 2));
    let report = Report::of(surface).unwrap();
    assert_eq!((report.manifold(), report.is_closed(), report.components()), (Answer::Yes, Some(true), 2));
    assert_eq!(report.name(), Some("2 spheres"));
}

/// Six squares with corners of their own, one of them missing.
#[test]
fn a_box_of_separate_sides_becomes_a_sphere() {
    let corner = |i: usize| [(i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64];
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2]];
    let mut text = String::new();
    for side in sides {
        for i in side {
            let [x, y, z] = corner(i);
            text += &format!("v {x} {y} {z}\n");
        }
        text += "f -4 -3 -2 -1\n";
    }
    let model = read(text.as_bytes(), Format::Obj).unwrap();
    let (surface, done) = repaired_surface(&model, &closed()).unwrap();
    assert_eq!((done.merged_count(), done.hole_count(), done.added_face_count()), (12, 1, 2));
    let report = Report::of(surface).unwrap();
    assert_eq!((report.f_vector(), report.name()), (&[8, 13, 7][..], Some("sphere")));
    assert!((report.signed_volume().unwrap().abs() - 1.0).abs() < 1e-12);
}

#[test]
fn the_tolerance_merges_what_is_near() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1e-7\nv 1 0 0\nv 0 -1 0\nf 1 2 3\nf 5 4 6\n";
    let model = read(text.as_bytes(), Format::Obj).unwrap();
    let of = |tolerance: f64| {
        let request = SurfaceRepairRequest::new().tolerance(tolerance);
        repaired_surface(&model, &request).unwrap().0.vertex_count()
    };
    assert_eq!((of(0.0), of(1e-6)), (6, 4));
    assert!(repaired_surface(&model, &SurfaceRepairRequest::new().tolerance(-1.0)).is_err());
}

/// What repeats an earlier polygon is left out on request, turned or not; groups and data follow.
#[test]
fn repeated_polygons_are_dropped_on_request() {
    let model = facets(&[vec![0, 1, 2], vec![2, 0, 1], vec![1, 3, 2], vec![1, 0, 2]]);
    let count = |drop_repeated: bool| {
        let mut request = RepairRequest::default();
        request.drop_repeated = drop_repeated;
        let Some(Structure::Facets(made)) = repaired(&model, request).unwrap().0.structure().cloned() else {
            panic!()
        };
        made.len()
    };
    assert_eq!((count(true), count(false)), (2, 4));
}

#[test]
fn solids_and_high_complexes_are_refused() {
    let fault = repaired_surface(&facets(&[vec![0, 1, 2, 3]]), &closed()).unwrap_err().to_string();
    assert!(fault.contains("dimension 3 or more"), "{fault}");
}

proptest! {
    /// Whatever triangles there are, a closed surface comes out, and it has every triangle once that does not repeat another.
    #[test]
    fn every_list_of_triangles_becomes_closed(
        lists in prop::collection::vec(prop::collection::vec(0u32..9, 3), 1..24)
    ) {
        let different = |list: &&Vec<u32>| list[0] != list[1] && list[1] != list[2] && list[0] != list[2];
        let lists: Vec<Vec<u32>> = lists.iter().filter(different).cloned().collect();
        let model = facets(&lists);
        let (surface, done) = repaired_surface(&model, &closed()).unwrap();
        check_closed(&surface, "random");
        let (_, again) = repaired_surface(&surface, &closed()).unwrap();
        prop_assert_eq!((again.hole_count(), again.duplicate_count(), again.mesh().vertices_split().len()), (0, 0, 0));
        let mut sets: Vec<Vec<u32>> = lists.iter().map(|list| { let mut s = list.clone(); s.sort_unstable(); s }).collect();
        sets.sort();
        sets.dedup();
        let Some(Structure::Facets(made)) = surface.structure() else { panic!("a facet list stays one") };
        prop_assert_eq!(made.len(), sets.len() + done.added_face_count());
        // Second method: each edge is in two triangles.
        let count = made.items().iter().max().map_or(0, |most| *most as usize + 1);
        let mesh = PolygonMesh::new(count, made.clone(), &[]).unwrap();
        for edge in 0..mesh.edge_count() {
            prop_assert_eq!(mesh.face_count_at(coface_algebra::EdgeId::new(edge)), 2);
        }
    }
}

/// Every surface among the real files can be closed.
#[test]
fn real_files_become_closed() {
    let Some(folder) = std::env::var_os("COFACE_DATA").map(PathBuf::from) else { return };
    let mut tried = 0;
    let files = |name: &str| std::fs::read_dir(folder.join(name)).unwrap().map(|entry| entry.unwrap().path());
    let mut paths: Vec<PathBuf> = files("surfaces").chain(files("tricky")).collect();
    paths.sort();
    for path in paths {
        if path.metadata().unwrap().len() > 1 << 20 || Format::from_path(&path).is_none() {
            continue;
        }
        let Ok(model) = read_path(&path, None) else { continue };
        if model.polygons().is_empty() || !model.cells().is_empty() {
            continue;
        }
        let (surface, _) = repaired_surface(&model, &closed()).unwrap();
        check_closed(&surface, &path.display().to_string());
        tried += 1;
    }
    assert!(tried > 5, "{tried} files of {}", folder.display());
}
