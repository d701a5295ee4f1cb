//! The verbs of surfaces, and the data on cells that they write.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

mod program;

use program::{argument, coface};
use serde_json::json;

#[test]
fn data_on_cells_are_told_and_kept_where_the_format_can() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(
        path("a.ply"),
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n\
         element face 1\nproperty list uchar int vertex_indices\nproperty double weight\nelement edge 1\nproperty int vertex1\n\
         property int vertex2\nproperty int end_0\nproperty int end_1\nend_header\n0 0 0 0\n1 0 0 7\n0 1 0 255\n3 0 1 2 0.25\n0 1 -3 4\n",
    )
    .unwrap();
    let expected = json!([
        {"name": "red", "on": "vertices", "components": 1, "type": "integer", "range": [0.0, 255.0]},
        {"name": "weight", "on": "polygons", "components": 1, "type": "real", "range": [0.25, 0.25]},
        {"name": "end", "on": "lines", "components": 2, "type": "integer", "range": [-3.0, 4.0]},
    ]);
    assert_eq!(coface(&["info", "--json", argument(&path("a.ply"))]).json()["data"], expected);
    let page = coface(&["info", argument(&path("a.ply"))]).stdout;
    assert!(page.contains("end on lines  2 integers each, -3 to 4"), "{page}");
    let converted = coface(&["convert", argument(&path("a.ply")), "-o", argument(&path("b.ply"))]);
    assert!(converted.stderr.is_empty(), "{}", converted.stderr);
    assert_eq!(coface(&["info", "--json", argument(&path("b.ply"))]).json()["data"], expected);
    let converted = coface(&["convert", argument(&path("a.ply")), "-o", argument(&path("b.obj"))]);
    assert!(converted.stderr.contains("OBJ does not keep data on cells: 3 left out"), "{}", converted.stderr);
    coface(&["convert", argument(&path("a.ply")), "-o", argument(&path("b.vtk"))]);
    let data = coface(&["info", "--json", argument(&path("b.vtk"))]).json()["data"].clone();
    // VTK has one array over all cells.
    assert_eq!(data.as_array().unwrap().len(), 5);
    assert!(data.as_array().unwrap().contains(&expected[0]));
}

#[test]
fn data_that_a_format_cannot_hold_leave_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(
        path("a.vtk"),
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n\
         POINT_DATA 3\nSCALARS big vtktypeint64\nLOOKUP_TABLE default\n0 1 1099511627776\n",
    )
    .unwrap();
    let run = coface(&["convert", argument(&path("a.vtk")), "-o", argument(&path("b.ply"))]);
    let message = run.fails_with(1);
    assert!(message.contains("the data \"big\" on vertices have larger ones; write VTK"), "{message}");
    assert!(!path("b.ply").exists());
}
