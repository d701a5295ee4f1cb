use super::{Encoding, read, write};
use crate::samples::{Limits, meshes, with_data};
use crate::{CellData, Group, GroupKind, Model};
use coface_algebra::RaggedArray;
use coface_complexes::cell_mesh::CellShape;
use proptest::prelude::*;

const POINTS: &str = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n\
    0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";

fn fault(text: &str) -> String {
    read(text.as_bytes()).unwrap_err().to_string()
}

#[test]
fn faults_are_placed() {
    for (cells, message) in [
        ("CELLS 1 5\n4 0 1 2 8\n", "line 15: a cell names point 8, but there are 8 points, numbered from 0"),
        ("CELLS 1 5\n4 0 1 2 -1\n", "names point -1"),
        ("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n12\n", "line 15: a cell has 4 points, but its type needs 8"),
        ("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n42\n", "line 17: cell 0 has type 42: polyhedra are not read"),
        ("CELLS 1 4\n4 0 1 2 3\n", "line 15: a list of 4 numbers runs over the size of CELLS, 4"),
        ("CELLS 1 6\n4 0 1 2 3\n", "the lists of CELLS have 5 numbers, not 6"),
        ("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 2\n", "there are 2 cell types for 1 cells"),
        ("CELLS 1 5\n4 0 1 2 3\n", "the file ends before CELL_TYPES"),
        ("CELLS 99999999999 5\n4 0 1 2 3\n", "the file ends where the length of a list should be"),
        ("CELL_TYPES 2\n10\n", "CELL_TYPES stand before CELLS"),
        ("BANANAS 2\n", "line 14: \"BANANAS\" is no keyword"),
        ("POINTS 1 float\n0 0 0\n", "the points are given twice"),
        ("FIELD x 1\na 1 2 int\n1", "the file ends where an array should be"),
        ("DIMENSIONS 1 1 1\n", "the data set is no grid"),
    ] {
        let text = fault(&format!("{POINTS}{cells}"));
        assert!(text.contains(message), "{text}");
    }
    for (text, message) in [
        ("# vtk DataFile Version 3.0\ntitle\nBINARYX\n", "line 3: \"BINARYX\" stands where ASCII"),
        (
            "# vtk DataFile Version 3.0\ntitle\nASCII\nPOINTS 0 float\n",
            "\"POINTS\" stands where DATASET should",
        ),
        (
            "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET TABLE\n",
            "data sets of the kind \"TABLE\" hold no mesh",
        ),
        ("# vtk DataFile Version 3.0\ntitle\nASCII\n", "the file ends before DATASET"),
        (
            "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 none 0\n",
            "line 6: \"none\" is not a number",
        ),
        (
            "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 floaty\n",
            "is no type of numbers",
        ),
        (
            "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 100000 100000 100000\n",
            "the file has only 93 bytes",
        ),
        (
            "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_GRID\nDIMENSIONS 2 2 1\nPOINTS 1 float\n0 0 0\n",
            "do not fit the 1 points",
        ),
        ("hello\n", "\"hello\" stands where"),
    ] {
        let text = fault(text);
        assert!(text.contains(message), "{text}");
    }
}

#[test]
fn every_type_of_cell_is_read() {
    let cells = "CELLS 8 46\n8 0 1 2 3 4 5 6 7\n6 0 1 2 4 5 6\n4 0 1 2 3\n4 0 1 2 3\n4 0 1 3 2\n2 5 6\n6 0 3 2 1 5 7\n4 3 2 1 0\n";
    let text = format!(
        "{POINTS}METADATA\nINFORMATION 0\n\n{cells}CELL_TYPES 8\n11 13 8 6 7 2 22 4\nCELL_DATA 8\nSCALARS x int 1\nLOOKUP_TABLE default\n\
         10 20 30 40 50 60 70 80\nVECTORS v float\n1 1 1 2 2 2 3 3 3 4 4 4 5 5 5 6 6 6 7 7 7 8 8 nan\n\
         POINT_DATA 8\nGLOBAL_IDS id vtkIdType\n0 1 2 3 4 5 6 7\n"
    );
    let model = read(text.as_bytes()).unwrap();
    assert_eq!(model.shapes(), [CellShape::Hexahedron, CellShape::Wedge]);
    assert_eq!(model.cells().list(0), [0, 1, 3, 2, 4, 5, 7, 6]);
    assert_eq!(model.cells().list(1), [0, 2, 1, 4, 6, 5]);
    let polygons: Vec<&[u32]> = model.polygons().iter().collect();
    assert_eq!(polygons, [&[0, 1, 3, 2][..], &[0, 1, 2], &[2, 1, 3], &[0, 1, 3, 2], &[0, 3, 2]]);
    assert_eq!(model.lines().list(0), [3, 2, 1, 0]);
    assert_eq!(model.points().len(), 2);
    assert!(model.remarks()[0].message.contains("1 elements of higher order"));
    // The strip is two triangles; the points have no data.
    let column = |name: &str, kind| -> Vec<i64> {
        let data = model.data_named(name, kind).unwrap();
        (0..data.len()).map(|i| data.integer_row(i).unwrap()[0]).collect()
    };
    assert_eq!(column("x", GroupKind::Cells), [10, 20]);
    assert_eq!(column("x", GroupKind::Polygons), [30, 40, 40, 50, 70]);
    assert_eq!(column("x", GroupKind::Lines), [80]);
    assert!(model.data_named("v", GroupKind::Lines).unwrap().real_row(0)[2].is_nan());
    assert_eq!(column("id", GroupKind::Vertices), [0, 1, 2, 3, 4, 5, 6, 7]);
}

#[test]
fn data_on_cells_that_are_points_are_left_out_with_a_remark() {
    for (value, remarks) in [(9, 1), (0, 0)] {
        let text = format!(
            "{POINTS}CELLS 2 7\n1 7\n4 0 1 2 3\nCELL_TYPES 2\n1 9\nCELL_DATA 2\nSCALARS x int 1\nLOOKUP_TABLE default\n{value} 10\n"
        );
        let model = read(text.as_bytes()).unwrap();
        assert_eq!(model.data_named("x", GroupKind::Polygons).unwrap().integer_row(0), Some(vec![10]));
        assert_eq!(model.remarks().len(), remarks, "{:?}", model.remarks());
    }
}

#[test]
fn wedges_of_higher_order_have_their_corners_as_others() {
    let corners = "0 0 0 1 0 0 0 1 0 0 0 1 1 0 1 0 1 1 ";
    for (number, count) in [(13, 6), (26, 15), (31, 12), (32, 18)] {
        let ids: Vec<String> = (0..count).map(|id| id.to_string()).collect();
        let more = ".5 .5 .5 ".repeat(count - 6);
        let text = format!(
            "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {count} double\n{corners}{more}\nCELLS 1 {}\n{count} {}\nCELL_TYPES 1\n{number}\n",
            count + 1,
            ids.join(" ")
        );
        let model = read(text.as_bytes()).unwrap();
        assert_eq!(model.cells().list(0), [0, 2, 1, 3, 5, 4], "type {number}");
    }
}

#[test]
fn data_follow_the_order_in_which_cells_are_drawn() {
    let head = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\n\
        TRIANGLE_STRIPS 1 5\n4 0 1 2 3\nPOLYGONS 1 4\n3 0 2 3\nLINES 1 3\n2 0 1\n";
    let data = "CELL_DATA 3\nMETADATA\nINFORMATION 0\n\nSCALARS kind short\nLOOKUP_TABLE mine\n1 2 3\nLOOKUP_TABLE mine 1\n0 0 0 1\n\
        COLOR_SCALARS color 2\n0 0.5 1 0.25 0 0\nFIELD more 4\nnames 1 3 string\na b\nc\n\nflags 1 3 bit\n0 1 1\n\
        METADATA\nINFORMATION 0\n\nbig%20numbers 1 3 vtktypeint64\n9007199254740993 0 -1\nnone 0 3 int\nTENSORS t double\n0 0 0 0 0 0 0 0 0\n\
        0 0 0 0 0 0 0 0 0\n0 0 0 0 0 0 0 0 9\nPOINT_DATA 4\nTEXTURE_COORDINATES uv 2 float\n0 0 1 0 0 1 1 1\n";
    let model = read(format!("{head}{data}").as_bytes()).unwrap();
    let row = |name: &str, kind, i| model.data_named(name, kind).unwrap().real_row(i);
    assert_eq!(row("kind", GroupKind::Lines, 0), [1.0]);
    // The strip stands first in the file, and its two triangles in the model.
    assert_eq!([0, 1, 2].map(|i| row("kind", GroupKind::Polygons, i)[0]), [3.0, 3.0, 2.0]);
    assert_eq!(row("color", GroupKind::Polygons, 2), [1.0, 0.25]);
    let big = model.data_named("big numbers", GroupKind::Lines).unwrap();
    assert_eq!(big.integer_row(0), Some(vec![9_007_199_254_740_993]));
    assert_eq!(row("t", GroupKind::Polygons, 0)[8], 9.0);
    assert_eq!((row("uv", GroupKind::Vertices, 2), model.data().len()), (vec![0.0, 1.0], 9));
    assert!(model.remarks().is_empty());
    let strings = format!("{head}POINT_DATA 4\nPEDIGREE_IDS who string\na\nb\nc\nd\n");
    let model = read(strings.as_bytes()).unwrap();
    assert_eq!(
        model.remarks().iter().map(|remark| &remark.message[..]).collect::<Vec<_>>(),
        ["the data \"who\" are no numbers; they and what follows are left out"]
    );
    for (data, message) in [
        ("CELL_DATA 2\n", "line 13: there are data on 2 cells, but there are 3 cells"),
        ("POINT_DATA 3\n", "line 13: there are data on 3 points, but there are 4 points"),
        ("POINT_DATA 4\nSCALARS a int\n0 1 2 3\n", "line 15: \"0\" stands where a count of components or"),
        ("POINT_DATA 4\nSCALARS a int x\n", "\"X\" stands where a count of components"),
        ("POINT_DATA 4\nSCALARS a real\n", "\"real\" is no type of numbers"),
        ("POINT_DATA 4\nVECTORS a int\n0 1 2 x\n", "line 15: \"x\" is not a number, as data must be"),
        ("POINT_DATA 4\nVECTORS a int\n0 1 2\n", "the file ends where data should be"),
        ("POINT_DATA 4\nFIELD f 1\na 1 3 int\n0 1 2\n", "the data \"a\" have 3 rows"),
        ("POINT_DATA 4\nFIELD f 1\na 99999999999 4 int\n0 1 2\n", "the file ends where data should be"),
        (
            "POINT_DATA 4\nSCALARS a int 99999999999\nLOOKUP_TABLE default\n0 1 2\n",
            "the file ends where data",
        ),
        ("POINT_DATA 4\nPOLYGONS 1 4\n3 0 1 2\n", "\"POLYGONS\" is no keyword of data"),
    ] {
        let text = fault(&format!("{head}{data}"));
        assert!(text.contains(message), "{text}");
    }
}

#[test]
fn data_of_one_name_are_one_array_of_all_cells() {
    let text = format!("{POINTS}CELLS 3 12\n1 7\n3 0 1 2\n5 0 1 3 7 4\nCELL_TYPES 3\n1 5 7\n");
    let mut model = read(text.as_bytes()).unwrap();
    model.lines = RaggedArray::from_lists([[6, 7]]);
    let data = |name: &str, kind, components, values: Vec<i64>| {
        CellData::integers(name, kind, components, values).unwrap()
    };
    let model = model
        .with_data(data("seam", GroupKind::Lines, 1, vec![-5]))
        .unwrap()
        .with_data(CellData::reals("seam", GroupKind::Polygons, 1, vec![0.5, 1.5]).unwrap())
        .unwrap()
        .with_data(data("ends", GroupKind::Lines, 2, vec![6, 1 << 40]))
        .unwrap();
    for encoding in [Encoding::Ascii, Encoding::Binary] {
        let mut out = Vec::new();
        write(&model, &mut out, encoding).unwrap();
        let read = read(&out[..]).unwrap();
        let row = |name: &str, kind, i| read.data_named(name, kind).unwrap().real_row(i);
        assert_eq!(
            (row("seam", GroupKind::Lines, 0), row("seam", GroupKind::Polygons, 1)),
            (vec![-5.0], vec![1.5])
        );
        assert_eq!(read.data_named("ends", GroupKind::Lines).unwrap().integer_row(0), Some(vec![6, 1 << 40]));
        assert_eq!(row("ends", GroupKind::Polygons, 1), [0.0, 0.0]);
    }
    let model = model.with_data(data("ends", GroupKind::Polygons, 1, vec![0, 0])).unwrap();
    let message = write(&model, Vec::new(), Encoding::Ascii).unwrap_err().to_string();
    assert!(message.contains("\"ends\" have 2 components on lines and 1 on polygons"), "{message}");
}

#[test]
fn vertices_that_are_left_out_take_their_data_along() {
    let text = format!(
        "{POINTS}CELLS 1 7\n6 0 1 2 3 4 5\nCELL_TYPES 1\n22\nPOINT_DATA 8\nSCALARS a int\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7\n"
    );
    let model = read(text.as_bytes()).unwrap();
    let data = model.data_named("a", GroupKind::Vertices).unwrap();
    assert_eq!((0..5).map(|i| data.integer_row(i).unwrap()[0]).collect::<Vec<_>>(), [0, 1, 2, 6, 7]);
}

#[test]
fn polygonal_data_and_offsets_are_read() {
    let head = "# vtk DataFile Version 5.1\ntitle\nASCII\nDATASET POLYDATA\nFIELD FieldData 2\nTIME 1 1 double\n0.5\nNAMES 1 2 string\na b\nc\n\
        POINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\n";
    let text = format!(
        "{head}POLYGONS 3 7\nOFFSETS vtktypeint64\n0 3 7\nCONNECTIVITY vtktypeint64\n0 1 2 0 1 3 2\n\
         LINES 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n\
         VERTICES 2 1\nOFFSETS vtktypeint64\n0 1\nCONNECTIVITY vtktypeint64\n3\nPOINT_DATA 4\n"
    );
    let model = read(text.as_bytes()).unwrap();
    assert_eq!(model.polygons().iter().collect::<Vec<_>>(), [&[0, 1, 2][..], &[0, 1, 3, 2]]);
    assert_eq!((model.lines().len(), model.points().len()), (1, 1));
    for (offsets, message) in [
        ("0 4 3", "an offset of POLYGONS is 3"),
        ("0 3 5", "do not end at the size"),
        ("1 3 7", "an offset of POLYGONS is 1"),
    ] {
        let text = fault(&text.replace("0 3 7", offsets));
        assert!(text.contains(message), "{text}");
    }
}

#[test]
fn groups_become_cell_data() {
    let mut model = read(
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 1 0 0 0 1 0\n\
         CELLS 2 7\n2 0 1\n3 0 1 2\nCELL_TYPES 2\n3 5\n"
            .as_bytes(),
    )
    .unwrap();
    model.groups.push(Group::new("rim", GroupKind::Lines, vec![0]));
    model.groups.push(Group::new("disk", GroupKind::Polygons, vec![0]));
    let mut out = Vec::new();
    write(&model, &mut out, Encoding::Ascii).unwrap();
    assert!(out.ends_with(b"CELL_DATA 2\nSCALARS group int 1\nLOOKUP_TABLE default\n1\n2\n"));
    let read = read(&out[..]).unwrap();
    assert_eq!(read.polygons, model.polygons);
    assert_eq!(read.data_named("group", GroupKind::Polygons).unwrap().integer_row(0), Some(vec![2]));
}

#[test]
fn grids_become_cells() {
    let head = "# vtk DataFile Version 2.0\ntitle\nASCII\nDATASET ";
    let model = read(
        format!("{head}STRUCTURED_POINTS\nDIMENSIONS 3 2 2\nORIGIN 1 0 0\nSPACING 0.5 1 2\nCELL_DATA 2\nSCALARS a float 1\n\
                 LOOKUP_TABLE default\n0.5 -1\n")
            .as_bytes(),
    )
    .unwrap();
    assert_eq!((model.vertex_count(), model.cells().len()), (12, 2));
    assert_eq!(model.cells().list(1), [1, 2, 5, 4, 7, 8, 11, 10]);
    assert_eq!(model.data_named("a", GroupKind::Cells).unwrap().real_row(1), [-1.0]);
    assert_eq!(model.positions().as_flat()[33..], [2.0, 1.0, 2.0]);
    let model = read(
        format!("{head}RECTILINEAR_GRID\nDIMENSIONS 2 1 3\nX_COORDINATES 2 float\n0 5\nY_COORDINATES 1 float\n7\nZ_COORDINATES 3 float\n0 1 9\n")
            .as_bytes(),
    )
    .unwrap();
    assert_eq!(model.polygons().iter().collect::<Vec<_>>(), [&[0, 1, 3, 2][..], &[2, 3, 5, 4]]);
    assert_eq!(model.positions().as_flat()[15..], [5.0, 7.0, 9.0]);
    let model = read(
        format!("{head}STRUCTURED_GRID\nDIMENSIONS 1 3 1\nPOINTS 3 float\n0 0 0 1 1 1 2 0 1\n").as_bytes(),
    )
    .unwrap();
    assert_eq!(model.lines().iter().collect::<Vec<_>>(), [[0, 1], [1, 2]]);
}

/// The model as it comes back: data on cells are on all of them, and those on points come last.
pub(super) fn on_all_cells(model: &Model) -> Model {
    let mut read = Model { data: Vec::new(), ..model.clone() };
    let (on_points, on_cells): (Vec<_>, Vec<_>) =
        model.data.iter().cloned().partition(|data| data.kind() == GroupKind::Vertices);
    for data in on_cells {
        for kind in [GroupKind::Lines, GroupKind::Polygons, GroupKind::Cells] {
            let count = model.count_of(kind);
            if kind == data.kind() {
                read.data.push(data.clone());
            } else if count > 0 {
                let mut zeros = data.numbers().of_same_type();
                zeros.extend_zeros(count * data.components());
                read.data.push(CellData::of_file(data.name().to_owned(), kind, data.components(), zeros));
            }
        }
    }
    read.data.extend(on_points);
    read
}

proptest! {
    #[test]
    fn what_is_written_reads_back(model in with_data(meshes(Limits {
        dimension: 3, largest_polygon: 7, longest_line: 5, points: true, groups: false,
    }), &[GroupKind::Vertices, GroupKind::Lines, GroupKind::Polygons, GroupKind::Cells])) {
        for encoding in [Encoding::Ascii, Encoding::Binary] {
            let mut out = Vec::new();
            write(&model, &mut out, encoding).unwrap();
            prop_assert_eq!(read(&out[..]).unwrap(), on_all_cells(&model));
            if encoding == Encoding::Binary {
                // Cut in the points; in the last type, if there is one. Right behind the points is a sound end.
                let points = out.windows(8).position(|word| word == b" double\n").unwrap() + 8;
                prop_assert!(read(&out[..points + 100]).is_err());
                let has_cells = model.points.len() + model.lines.len() + model.polygons.len() + model.cells.len() > 0;
                prop_assert_eq!(read(&out[..out.len() - 2]).is_err(), has_cells || !model.data.is_empty());
            }
        }
    }
}
