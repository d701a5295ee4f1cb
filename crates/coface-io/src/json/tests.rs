use super::{read, write};
use crate::{Model, RemarkCode, Structure};
use coface_algebra::RaggedArray;
use coface_algebra::chains::ChainComplex;
use coface_complexes::cell_mesh::CellShape;
use coface_complexes::surface::PolygonMesh;
use coface_geometry::Positions;
use proptest::prelude::*;

fn complex(model: &Model) -> &ChainComplex {
    match model.structure() {
        Some(Structure::Chains(complex)) => complex,
        other => panic!("{other:?}"),
    }
}

/// A triangle with a tail: four vertices, four edges, one face.
const TAILED: &str = r#"{"name": "tail", "d1": {"rows": 1, "cols": 4, "coo": [[0, 0, 1], [0, 1, 1], [0, 2, -1]]},
    "d0": [[0, 0, -1], [0, 1, 1], [1, 1, -1], [1, 2, 1], [2, 0, -1], [2, 2, 1], [3, 2, -1], [3, 3, 1]],
    "vertices": [[0, 0], [1, 0], [1e0, 1.5], [-2, 1]], "expected": {"d7": 1}}"#;

#[test]
fn coboundaries_are_transposed_boundaries() {
    let model = read(TAILED.as_bytes()).unwrap();
    assert_eq!((model.vertex_count(), model.positions().as_flat()[5]), (4, 1.5));
    assert_eq!(complex(&model).f_vector(), [4, 4, 1]);
    let edges = complex(&model).boundary_matrix(1).unwrap();
    assert_eq!((edges.column(2).rows(), edges.column(2).entries()), (&[0, 2][..], &[-1, 1][..]));
    // The same without counts and without points.
    let bare = r#"{"d0": [[0,0,-1],[0,1,1],[1,1,-1],[1,2,1],[2,0,-1],[2,2,1],[3,2,-1],[3,3,1]],
        "d1": {"entries": [[0,0,1],[0,1,1],[0,2,-1]], "other": []}}"#;
    let bare = read(bare.as_bytes()).unwrap();
    assert_eq!(complex(&bare), complex(&model));
    assert_eq!((bare.vertex_count(), bare.positions().dimension()), (0, 0));
}

#[test]
fn points_beside_facets_make_a_mesh() {
    let text =
        br#"{"facets": [[0, 1, 2], [2, 3], [4]], "vertices": [[0, 0], [1, 0], [0, 1], [3, 1.5], [9, 9]]}"#;
    let model = read(&text[..]).unwrap();
    assert_eq!((model.polygons().len(), model.lines().len(), model.points().len()), (1, 1, 1));
    assert_eq!((model.vertex_count(), model.positions().as_flat()[7], model.remarks().len()), (5, 1.5, 0));
    let solid = br#"{"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "facets": [[0,1,2,3]]}"#;
    assert_eq!(read(&solid[..]).unwrap().cells().len(), 1);
    // A tetrahedron in the plane is none; and a count is no list of points.
    let flat = read(&br#"{"vertices": [[0,0],[1,0],[0,1],[1,1]], "facets": [[0,1,2,3]]}"#[..]).unwrap();
    assert_eq!(flat.remarks()[0].code, RemarkCode::DataLeftOut);
    assert!(matches!(flat.structure(), Some(Structure::Facets(_))));
    let count = read(&br#"{"vertices": 4, "facets": [[0,1,2,9]]}"#[..]).unwrap();
    assert!(count.remarks().is_empty() && matches!(count.structure(), Some(Structure::Facets(_))));
    let error = read(&br#"{"vertices": [[0,0],[1,0],[0,1]], "facets": [[0,1,2],[0,1,3]]}"#[..]).unwrap_err();
    assert!(error.to_string().contains("facet 1 has the vertex 3, and there are 3 vertices"), "{error}");
}

#[test]
fn points_beside_boundaries_are_positions() {
    let text =
        br#"{"boundaries":[{"rows":3,"cols":1,"entries":[[0,0,-1],[2,0,1]]}],"vertices":[[0],[5],[1]]}"#;
    assert_eq!(read(&text[..]).unwrap().positions().as_flat(), [0.0, 5.0, 1.0]);
    let points = read(&br#"{"boundaries":[],"vertices":[[0,0],[5,5]]}"#[..]).unwrap();
    assert_eq!((complex(&points).f_vector(), points.vertex_count()), (&[2][..], 2));
    let nothing = read(&br#"{"vertices":[],"d0":[]}"#[..]).unwrap();
    assert_eq!(complex(&nothing).f_vector(), [0, 0]);
    // Beside other things the key means something else, whatever that is.
    for other in [r#"{"facets":[[0,1]],"vertices":"many"}"#, r#"{"vertices":{"x":[1]},"facets":[[0,1]]}"#] {
        assert_eq!(read(other.as_bytes()).unwrap(), read(&b"[[0,1]]"[..]).unwrap());
    }
}

#[test]
fn meshes_of_other_cells_are_written_as_chain_complexes() {
    let corners = [[0., 0.], [1., 0.], [1., 1.], [0., 1.], [2., 0.]].concat();
    let square = Model::from_polygons(
        Positions::from_flat(2, corners.clone()).unwrap(),
        RaggedArray::from_lists([[0, 1, 2, 3]]),
    )
    .unwrap();
    let model = square.with_lines(RaggedArray::from_lists([[1, 4]])).unwrap();
    let mut out = Vec::new();
    write(&model, &mut out).unwrap();
    let back = read(&out[..]).unwrap();
    assert_eq!(complex(&back).f_vector(), [5, 5, 1]);
    assert_eq!(back.positions().as_flat(), corners);
    let cells = RaggedArray::from_lists([[0, 1, 2, 3, 4, 5]]);
    let flat = (0..6).flat_map(|i| [f64::from(i % 3 == 1), f64::from(i % 3 == 2), f64::from(i / 3)]);
    let positions = Positions::from_flat(3, flat.collect()).unwrap();
    let wedge = Model::from_cells(positions, vec![CellShape::Wedge], cells).unwrap();
    let mut out = Vec::new();
    write(&wedge, &mut out).unwrap();
    assert_eq!(complex(&read(&out[..]).unwrap()).f_vector(), [6, 9, 5, 1]);
}

#[test]
fn faults_name_key_and_entry() {
    let table = [
        (
            r#"{"vertices":[[0,0],[1]],"d0":[]}"#,
            "point 1 of \"vertices\" has 1 coordinates, but those before it have 2",
        ),
        (r#"{"vertices":[[0,0],[1,null]],"d0":[]}"#, "coordinate 1 of point 1 of \"vertices\" is null"),
        (r#"{"vertices":[[0,0],"a"],"d0":[]}"#, "point 1 of \"vertices\" is a text"),
        (r#"{"vertices":[[[0]]],"d0":[]}"#, "coordinate 0 of point 0 of \"vertices\" is a list"),
        (r#"{"vertices":[[]],"d0":[]}"#, "point 0 of \"vertices\" has no coordinates"),
        (r#"{"vertices":{"a":1},"d0":[]}"#, "\"vertices\" is an object"),
        (r#"{"vertices":[[0],[1]],"d0":[[0,0,-1],[0,2,1]]}"#, "entry 1 of \"d0\" is at row 0, column 2"),
        (
            r#"{"vertices":[[0],[1]],"d0":{"rows":1,"cols":2,"coo":[[1,0,-1]]}}"#,
            "entry 0 of \"d0\" is at row 1",
        ),
        (
            r#"{"vertices":[[0],[1]],"d0":{"cols":3,"coo":[]}}"#,
            "\"vertices\" has 2 points, but \"d0\" has 3 columns",
        ),
        (
            r#"{"d0":{"rows":2,"coo":[]},"d1":{"cols":3,"coo":[]}}"#,
            "\"d0\" has 2 rows, but \"d1\" has 3 columns",
        ),
        (r#"{"d0":[[0,0,-1],[0,1,1],[0,0,-1]]}"#, "entries 0 and 2 of \"d0\" are both at row 0, column 0"),
        (r#"{"d0":[[0,0]]}"#, "entry 0 of \"d0\" is no triple"),
        (r#"{"d0":[[0,0,1.5]]}"#, "the value of entry 0 of \"d0\" is 1.5"),
        (r#"{"d0":[[-1,0,1]]}"#, "the row of entry 0 of \"d0\" is -1"),
        (r#"{"d1":[[0,0,1]]}"#, "there is \"d1\", but no \"d0\""),
        (r#"{"d0":[],"d00":[]}"#, "the key \"d0\" stands twice"),
        (r#"{"d0":{"rows":1}}"#, "\"d0\" has no entries"),
        (r#"{"d0":[[4000000000,0,1]]}"#, "the numbers of 1-cells go up to 4000000000, but only 1 entries"),
        (r#"{"d0":[[4294967295,0,1]]}"#, "1-cells go up to 4294967294"),
        (r#"{"d0":{"rows":4000000000,"coo":[]}}"#, "1-cells go up to 3999999999"),
        (r#"{"d0":[],"boundaries":[]}"#, "more than one of"),
        (r#"{"d0":[[0,0,-1],[0,1,1]],"d1":[[0,0,1]]}"#, "boundary"),
        (r#"{"vertices":[[0]],"boundaries":[{"rows":2,"cols":0,"entries":[]}]}"#, "1 points for 2 vertices"),
        (r#"{"vertices":[[0]]}"#, "but none of"),
        (r#"{"homology":[],"remarks":[]}"#, "an answer of coface, and not a model"),
        (
            &exact("[[0],[1],[2]]", "[0,1,2]", "[0,1,7]"),
            "\"exact_polygons\": part 0 names 7, which is not there",
        ),
        (&exact("[[0],[1],[9]]", "[0,1,2]", "[0,1,2]"), "\"exact_polygons\": vertex 2 names 9"),
        (&exact("[[0],[1],[2,0]]", "[0,1,2]", "[0,1,2]"), "vertex 2 is a list of 2 points"),
        (&exact("[[0],[1],[0,1,0,1]]", "[0,1,2]", "[0,1,2]"), "vertex 2 do not meet in one point"),
        (&exact("[[0],[1],[2]]", "[0,1,1]", "[0,1,2]"), "the triangle of part 0 has no area"),
        (&exact("[[0],[1],[3]]", "[0,1,2]", "[0,1,2]"), "vertex 2 is not in the plane of part 0"),
        (&segments("[[0],[9]]", "[0,0,1]"), "\"exact_segments\": vertex 1 names 9, which is not there"),
        (&segments("[[0],[0,4]]", "[0,0,1]"), "\"exact_segments\": vertex 1 names 4, which is not there"),
        (&segments("[[0],[1]]", "[7,0,1]"), "\"exact_segments\": piece 0 names 7, which is not there"),
        (&segments("[[0],[1]]", "[0,0,2]"), "\"exact_segments\": piece 0 names 2, which is not there"),
        (&segments("[[0],[0,2]]", "[0,0,1]"), "the supports of vertex 1 do not meet in one point"),
        (&segments("[[0],[0,3]]", "[0,0,1]"), "the supports of vertex 1 do not meet in one point"),
        (&segments("[[0],[2]]", "[0,0,1]"), "piece 0 ends in vertex 1, which is not on support 0"),
        (&segments("[[0],[0,1]]", "[2,0,1]"), "piece 0 ends in vertex 0, which is not on support 2"),
        (&segments("[[0],[]]", "[0,0,1]"), "a list of one point or of two supports"),
        (&segments("[[0],[0,1,2]]", "[0,0,1]"), "a list of one point or of two supports"),
        (&segments("[[0],[-1]]", "[0,0,1]"), "invalid value"),
        (&segments("[[0],[1]]", "[0,0]"), "invalid length 2"),
        (&segments("[[0],[1]]", "[0,0,1]").replace("0.5", "1e999"), "number out of range"),
        (&segments("[[0],[1]]", "[0,0,1]").replace("0.5", "NaN"), "expected value"),
        (&segments("[[0],[1]]", "[0,0,1]").replace("[0,1],[2,3]", "[0,1],[2,2]"), "support 1 has no length"),
        (&segments("[[0],[1]]", "[0,0,1]").replace("[0,1],[2,3]", "[0,1],[2,8]"), "support 1 names 8"),
        // The largest number is a cell like any other, and there is no such cell.
        (
            r#"{"boundaries":[{"rows":2,"cols":1,"entries":[[0,0,-1],[1,0,1]]}],"pieces_of":[[0,1],[4294967295]]}"#,
            "cells of degree 1 are pieces of cell 4294967295",
        ),
        (
            r#"{"boundaries":[{"rows":2,"cols":1,"entries":[[0,0,-1],[1,0,1]]}],"pieces_of":[[0],[0]]}"#,
            "1 entries say what cells of degree 0 are pieces of, but there are 2 cells",
        ),
    ];
    for (text, expected) in table {
        let message = read(text.as_bytes()).unwrap_err().to_string();
        assert!(message.contains(expected), "{text}\n{message}");
    }
}

/// A point with exact polygons of one part beside it.
fn exact(vertices: &str, triangle: &str, walk: &str) -> String {
    format!(
        r#"{{"vertices":[[0]],"boundaries":[{{"rows":1,"cols":0,"entries":[]}}],"exact_polygons":{{
        "points":[[0,0,0],[3,0,0],[0,3,0],[0,0,0.5]],"vertices":{vertices},
        "polygons":[{{"parts":[{{"triangle":{triangle},"walks":[{walk}]}}]}}]}}}}"#
    )
}

/// A point with exact segments of one piece beside it: supports 0 and 1 cross, 2 is parallel to 0, and 3 crosses the line of 0 beyond its end.
fn segments(vertices: &str, piece: &str) -> String {
    format!(
        r#"{{"vertices":[[0]],"boundaries":[{{"rows":1,"cols":0,"entries":[]}}],"exact_segments":{{
        "points":[[0,0],[3,0],[0.5,1],[1,-1],[0,4],[3,4],[7,-1],[7,1]],"supports":[[0,1],[2,3],[4,5],[6,7]],
        "vertices":{vertices},"pieces":[{piece}]}}}}"#
    )
}

#[test]
fn exact_segments_round_trip() {
    let text = segments("[[0],[0,1],[5]]", "[0,0,1],[1,1,1]");
    let model = read(text.as_bytes()).unwrap();
    let exact = model.exact_segments().unwrap();
    assert_eq!(exact.vertex_points()[1].rounded(), [0.75, 0.0]);
    assert_eq!((exact.pieces().len(), exact.own_count()), (2, 2));
    let shared = text.replace("[[0,0,1],[1,1,1]]", "[[0,0,1]],\"shared\":[[1,1,1]]");
    let shared = read(shared.as_bytes()).unwrap();
    assert_eq!(shared.exact_segments().unwrap().own_count(), 1);
    assert_ne!(shared, model);
    let empty = model.clone().with_exact_segments(Default::default());
    for model in [model, shared, empty] {
        let mut bytes = Vec::new();
        write(&model, &mut bytes).unwrap();
        assert_eq!(read(&bytes[..]).unwrap(), model);
    }
}

#[test]
fn exact_polygons_round_trip() {
    let model = read(exact("[[0],[1],[0,2,1,2]]", "[0,1,2]", "[0,1,2]").as_bytes()).unwrap();
    let polygons = model.exact_polygons().unwrap();
    assert_eq!(polygons.vertex_points()[2].rounded(), [0.0, 3.0, 0.0]);
    let mut bytes = Vec::new();
    write(&model, &mut bytes).unwrap();
    assert_eq!(read(&bytes[..]).unwrap(), model);
    let empty = model.with_exact_polygons(Default::default());
    bytes.clear();
    write(&empty, &mut bytes).unwrap();
    assert_eq!(read(&bytes[..]).unwrap(), empty);
}

proptest! {
    /// Chain complexes with positions are written and read again without loss, coordinates bit by bit.
    #[test]
    fn chains_with_positions_round_trip(
        triangles in prop::collection::vec(prop::sample::subsequence((0..8u32).collect::<Vec<_>>(), 3), 0..9),
        coordinates in prop::collection::vec(
            prop_oneof![any::<f64>().prop_filter("finite", |x| x.is_finite()), (-9..9i8).prop_map(f64::from)], 24),
    ) {
        let mesh = PolygonMesh::new(8, RaggedArray::from_lists(triangles), &[]).unwrap();
        let positions = Positions::from_flat(3, coordinates).unwrap();
        let model = Model::from_chains(mesh.chain_complex().unwrap(), positions).unwrap();
        let mut bytes = Vec::new();
        write(&model, &mut bytes).unwrap();
        let again = read(&bytes[..]).unwrap();
        let bits = |model: &Model| model.positions().as_flat().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(bits(&again), bits(&model));
        prop_assert_eq!(again, model);
    }
}

/// Points that repeat the one before count once, and kinks keep their places.
#[test]
fn repeated_points_of_curves_count_once() {
    let text = r#"{"order": 4, "curves": [{"points": [[0,0],[1,0],[1,0],[1,1],[0,1],[0,0]], "kinks": [1,2,3,5], "vertices": [7,8,9,4]}]}"#;
    let drawing = super::reading::read_boundary(text.as_bytes(), None).unwrap();
    let curve = &drawing.curves()[0];
    assert_eq!(curve.points(), [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    assert_eq!((curve.kinks(), curve.kink_names()), (&[1, 2, 0][..], Some(&[7, 9, 4][..])));
    assert_eq!(drawing.remarks()[0].code, RemarkCode::RepeatedVertex);
    assert_eq!(drawing.remarks()[0].count, 2);
    // Parameters and control points go with their points.
    let text = r#"{"order": 2, "curves": [{"points": [[0,0],[1,0],[1,1],[0,0]], "knots": [0,1,2,3,4]}]}"#;
    assert!(super::reading::read_boundary(text.as_bytes(), None).is_err());
}
