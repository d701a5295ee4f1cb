//! Files as they are in the wild: each is read with a remark, and refused by strict reading.

use coface_io::{self as io, Format, GroupKind, Model, ReadOptions, RemarkCode};

/// Reads a file of this format, with one remark of this code as the first, and sees to it that strict reading refuses it.
fn read(bytes: &[u8], format: Format, code: RemarkCode) -> Model {
    let text = String::from_utf8_lossy(bytes);
    let options = ReadOptions::new().format(format);
    let model = io::read_with(bytes, &options).unwrap_or_else(|error| panic!("{text}: {error}"));
    model.check().expect("a model that was read is sound");
    assert_eq!(
        model.remarks().first().map(|remark| remark.code),
        Some(code),
        "{text}: {:?}",
        model.remarks()
    );
    let error = io::read_with(bytes, &options.strict(true)).expect_err(&text);
    assert!(error.to_string().contains("strict reading assumes nothing"), "{error}");
    model
}

fn lists(lists: &coface_algebra::RaggedArray) -> Vec<Vec<u32>> {
    lists.iter().map(<[u32]>::to_vec).collect()
}

#[test]
fn comments_of_ply_without_their_word_are_passed_over() {
    let data = "element vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n";
    let model = read(
        format!("ply\nformat ascii 1.0\nCreated by Blender3D 247 - www.blender.org\n{data}").as_bytes(),
        Format::Ply,
        RemarkCode::UnknownSection,
    );
    assert_eq!(model.positions().as_flat(), [1.0, 2.0]);
    // Behind an element it may be a property, without which all that follows is read wrongly.
    let text = format!(
        "ply\nformat ascii 1.0\n{}",
        data.replace("property float y", "property float y\nprop float z")
    );
    assert!(io::read(text.as_bytes(), Format::Ply).is_err());
}

#[test]
fn lines_of_ply_that_go_on_behind_their_record_do_not_shift_the_next() {
    let head = |faces: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n{faces}end_header\n"
        )
    };
    let faces = "element face 4\nproperty list uchar int vertex_indices\n";
    // Points with colors of which the header says nothing: no color is a point.
    let points = "0 0 0 255 0 0\n1 0 0 255 0 0\n\n0 1 0 255 0 0 \n0 0 1 255 0 0";
    let cloud = read((head("") + points).as_bytes(), Format::Ply, RemarkCode::TrailingContent);
    let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    assert_eq!(cloud.positions().as_flat(), corners);
    let remark = &cloud.remarks()[0];
    assert_eq!((remark.count, remark.places[2].line), (4, Some(11)), "{}", remark.message);
    // More numbers behind a face, which would be faces too.
    let places = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    let all = "3 0 2 1 3 0 0 1\n3 0 1 3 3 0 0 2\n3 1 2 3\n3 2 0 3 0 0 1\n";
    let text = head(faces) + places + all;
    let solid = read(text.as_bytes(), Format::Ply, RemarkCode::TrailingContent);
    assert_eq!(lists(solid.polygons()), [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    assert_eq!(solid.remarks().len(), 1);
    // Records that are broken over lines, or stand several on one, are read as they were.
    let all = "3 0 2 1 3 0 1 3\n3 1 2\n3 3\n2 0 3\n";
    for places in
        ["0 0 0 1 0 0\n0 1 0 0 0 1\n", "0 0\n0 1 0 0 0 1\n0 0\n0 1\n", "0\n0\n0 1\n0\n0 0\n1\n0 0\n0\n1\n"]
    {
        let text = head(faces) + places + all;
        let other = io::read(text.as_bytes(), Format::Ply).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!(
            (other.positions(), other.polygons(), other.remarks().len()),
            (solid.positions(), solid.polygons(), 0)
        );
    }
}

#[test]
fn lines_of_obj_that_are_no_statements_are_passed_over() {
    let text = "# cow\n$ Contributed to a server\nv 0 0 0\nv 1 0 0\nv 0 1 0\n// a face:\nf 1 2 3\n";
    let model = read(text.as_bytes(), Format::Obj, RemarkCode::UnknownSection);
    assert_eq!((model.vertex_count(), lists(model.polygons())), (3, vec![vec![0, 1, 2]]));
    assert_eq!(
        model.remarks()[0].places.iter().map(|place| place.line).collect::<Vec<_>>(),
        [Some(2), Some(6)]
    );
    // Numbers alone may be the rest of the line before; what is no text is no remark.
    let error =
        io::read(text.replace("f 1 2 3", "f 1 2\n3").as_bytes(), Format::Obj).unwrap_err().to_string();
    assert!(error.starts_with("line 8") && error.contains("is not an OBJ statement"), "{error}");
    assert!(io::read(text.replace("//", "\u{1}").as_bytes(), Format::Obj).is_err());
    // A face in capitals would be lost.
    for word in ["F", "V", "Vn"] {
        let text = text.replace("// a face:", &format!("{word} 1 2 3"));
        let error = io::read(text.as_bytes(), Format::Obj).unwrap_err().to_string();
        assert!(error.starts_with("line 6") && error.contains("is not an OBJ statement"), "{error}");
    }
    for (line, said) in [
        ("face 1 2 3", Some("1 line is no statement of the format and is passed over")),
        ("curv 0 1 1 2", Some("1 line is of free-form geometry or of other files, and is passed over")),
        ("s off", None),
    ] {
        let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{line}\nf 1 2 3\n");
        let model = io::read(text.as_bytes(), Format::Obj).unwrap();
        let said = said.map(|said: &str| format!("{said}; the first is on line 4"));
        assert_eq!(model.remarks().first().map(|remark| remark.message.clone()), said, "{line}");
    }
}

#[test]
fn words_behind_the_end_of_a_facet_of_stl_are_passed_over() {
    let text = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop foo\nendfacet bar \nendsolid\n";
    let model = read(text.as_bytes(), Format::Stl, RemarkCode::TrailingContent);
    assert_eq!(model.polygons().len(), 1);
    assert_eq!(
        (model.remarks().len(), model.remarks()[0].count, model.remarks()[0].places[1].line),
        (1, 2, Some(8))
    );
    // Statements that share a line are none.
    assert!(io::read(text.replace("foo\nendfacet bar", "endfacet").as_bytes(), Format::Stl).is_err());
}

#[test]
fn cells_of_vtk_with_more_points_than_their_type_are_read_by_their_corners() {
    let head = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 10 float\n";
    let points = "0 0 0\n2 0 0\n0 2 0\n0 0 2\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n0 1 1\n";
    let text = |cell: &str, size: u32| format!("{head}{points}CELLS 1 {size}\n{cell}\nCELL_TYPES 1\n10\n");
    let quadratic = text("10 0 1 2 3 4 5 6 7 8 9", 11);
    let model = read(quadratic.as_bytes(), Format::Vtk, RemarkCode::HigherOrder);
    assert_eq!((model.vertex_count(), model.cells().len()), (4, 1));
    let error = io::read(text("3 0 1 2", 4).as_bytes(), Format::Vtk).unwrap_err().to_string();
    assert!(error.contains("a cell has 3 points, but its type needs 4"), "{error}");
    // No tetrahedron of higher order has five points.
    let error = io::read(text("5 0 1 2 3 4", 6).as_bytes(), Format::Vtk).unwrap_err().to_string();
    assert!(error.contains("a cell has 5 points, but its type needs 4"), "{error}");
}

#[test]
fn constellations_of_amf_are_placed() {
    use std::io::Write;
    let vertex = |x: i32, y: i32, z: i32| {
        format!("<vertex><coordinates><x>{x}</x><y> {y}.0 </y><z>{z}e0</z></coordinates></vertex>")
    };
    let triangle =
        |a: u32, b: u32, c: u32| format!("<triangle><v1>{a}</v1><v2>{b}</v2><v3>{c}</v3></triangle>");
    let object = format!(
        "<?xml version=\"1.0\"?>\n<amf unit=\"millimeter\" version=\"1.1\"><metadata type=\"author\">a</metadata>\
         <object id=\"0\"><metadata type=\"name\">tetrahedron</metadata><mesh><vertices>{}{}{}{}</vertices>\
         <volume materialid=\"1\">{}{}</volume><volume>{}{}</volume></mesh></object>",
        vertex(0, 0, 0),
        vertex(1, 0, 0),
        vertex(0, 1, 0),
        vertex(0, 0, 1),
        triangle(0, 2, 1),
        triangle(0, 1, 3),
        triangle(1, 2, 3),
        triangle(2, 0, 3)
    );
    let plain = format!("{object}</amf>");
    let model = io::read_unknown(plain.as_bytes()).unwrap();
    assert_eq!((model.format(), model.vertex_count(), model.remarks().len()), (Some(Format::Amf), 4, 0));
    assert_eq!(lists(model.polygons()), [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    assert_eq!((model.groups()[0].name(), model.groups()[0].members().len()), ("tetrahedron", 4));
    // A pair, one of it turned about x and then z and moved, and the pair again 10 higher.
    let constellations = "<constellation id=\"p\"><instance objectid=\"0\"/>\
         <instance objectid=\"0\"><deltax>5</deltax><rx>90</rx><rz>90</rz></instance></constellation>\
         <constellation id=\"q\"><instance objectid=\"p\"/><instance objectid=\"p\"><deltaz>10</deltaz></instance></constellation>";
    let placed = format!("{object}{constellations}</amf>");
    let model = io::read(placed.as_bytes(), Format::Amf).unwrap();
    assert_eq!((model.vertex_count(), model.polygons().len()), (16, 16));
    let turned = |i: usize| model.positions().as_flat()[3 * i..3 * i + 3].to_vec();
    // x goes to y, y to z, z to -y and that to x.
    assert_eq!(
        [turned(4), turned(5), turned(6), turned(7)],
        [[5., 0., 0.], [5., 1., 0.], [5., 0., 1.], [6., 0., 0.]]
    );
    assert_eq!([turned(8), turned(15)], [[0., 0., 10.], [6., 0., 10.]]);
    // Packed as slicers do.
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    archive.start_file("part.amf", zip::write::SimpleFileOptions::default()).unwrap();
    archive.write_all(placed.as_bytes()).unwrap();
    let packed = archive.finish().unwrap().into_inner();
    let same = io::read_unknown(&packed[..]).unwrap();
    assert_eq!((same.format(), same.positions()), (Some(Format::Amf), model.positions()));
    for (from, to, fault) in [
        ("<v1>0</v1>", "<v1>4</v1>", "line 2: a triangle names vertex 4, but its object has 4 vertices"),
        ("<x>1</x>", "<x>one</x>", "line 2: \"one\" is no finite number, as x must be"),
        ("<x>1</x>", "", "line 2: a coordinates without x"),
        ("objectid=\"0\"/>", "objectid=\"7\"/>", "the object \"7\" is not there"),
        ("objectid=\"0\"/>", "objectid=\"q\"/>", "contains itself"),
    ] {
        let error = io::read(placed.replace(from, to).as_bytes(), Format::Amf).unwrap_err();
        assert!(error.to_string().contains(fault) && error.cure().is_some(), "{error}");
    }
}

#[test]
fn columns_of_words_are_left_out_of_points() {
    let text = "x,y,kind\n1,2,setosa\n3,4,virginica\n";
    let model = io::read(text.as_bytes(), Format::Points).unwrap();
    assert_eq!(model.remarks()[0].code, RemarkCode::DataLeftOut);
    assert_eq!((model.positions().as_flat(), model.data().len()), (&[1.0, 2.0, 3.0, 4.0][..], 0));
    let model = io::read(&b"0.5,1,2,a09\n1.5,1,2,a09\n"[..], Format::Points).unwrap();
    assert_eq!(model.positions().as_flat(), [0.5, 1.0, 2.0, 1.5, 1.0, 2.0]);
    let atoms = io::read(&b"2\nwater\nO 0 0 0\nH 1 0 0\n"[..], Format::Points).unwrap();
    assert_eq!((atoms.vertex_count(), atoms.remarks()[0].code), (2, RemarkCode::DataLeftOut));
    // A word where the first point has a number is a fault.
    assert!(io::read(&b"1,2,3\n1,2,x\n"[..], Format::Points).is_err());
    assert!(io::read(&b"1,2,x\n1,2,3\n"[..], Format::Points).is_err());
}

#[test]
fn faces_that_repeat_a_vertex_lose_the_repetition() {
    let points = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
    let model = read(
        format!("{points}f 1 2 3 3\nf 1 2 2\nf 3 3 3\nl 1 1 3\n").as_bytes(),
        Format::Obj,
        RemarkCode::RepeatedVertex,
    );
    assert_eq!(lists(model.polygons()), [[0, 1, 2]]);
    assert_eq!(lists(model.lines()), [[0, 1], [0, 2]]);
    let counts: Vec<_> = model.remarks().iter().map(|remark| (remark.code, remark.count)).collect();
    let collapsed = RemarkCode::CollapsedCell;
    assert_eq!(counts, [(RemarkCode::RepeatedVertex, 2), (collapsed, 1), (collapsed, 1)]);
    assert_eq!((model.remarks()[0].places[0].line, model.remarks()[2].places[0].line), (Some(4), Some(5)));

    let off = "OFF\n4 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 1 2\n3 0 1 1\n0\n4 0 1 2 3\n";
    let model = read(off.as_bytes(), Format::Off, RemarkCode::RepeatedVertex);
    assert_eq!(lists(model.polygons()), [vec![0, 1, 2], vec![0, 1, 2, 3]]);
    assert_eq!((model.remarks()[1].count, model.remarks()[1].places[0].line), (2, Some(8)));

    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
               element face 3\nproperty list uchar int vertex_indices\nproperty int sort\n\
               element edge 2\nproperty int vertex1\nproperty int vertex2\nproperty int kind\nend_header\n\
               0 0 0\n1 0 0\n0 1 0\n3 0 0 1 7\n4 0 1 2 2 8\n3 2 1 0 9\n1 1 5\n0 1 6\n";
    let model = read(ply.as_bytes(), Format::Ply, RemarkCode::RepeatedVertex);
    assert_eq!(lists(model.polygons()), [[0, 1, 2], [2, 1, 0]]);
    assert_eq!(model.data_named("sort", GroupKind::Polygons).unwrap().integer_row(0), Some(vec![8]));
    assert_eq!(model.data_named("kind", GroupKind::Lines).unwrap().integer_row(0), Some(vec![6]));

    let medit = "MeshVersionFormatted 2 Dimension 2 Vertices 3 0 0 0 1 0 0 0 1 0\n\
                 Triangles 3 1 1 2 4 1 2 3 5 3 2 1 0 RequiredTriangles 3 1 2 3 End\n";
    let model = read(medit.as_bytes(), Format::Medit, RemarkCode::CollapsedCell);
    assert_eq!(lists(model.polygons()), [[0, 1, 2], [2, 1, 0]]);
    let members: Vec<_> =
        model.groups().iter().map(|group| (group.name(), group.members().to_vec())).collect();
    assert_eq!(members, [("5", vec![0]), ("RequiredTriangles", vec![0, 1])]);

    let vtk = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\n\
               POLYGONS 3 12\n3 0 0 1\n4 0 1 1 2\n2 0 1\nTRIANGLE_STRIPS 1 6\n5 0 1 2 2 3\nCELL_DATA 4\n\
               SCALARS a int\nLOOKUP_TABLE default\n5 6 7 8\n";
    let model = read(vtk.as_bytes(), Format::Vtk, RemarkCode::RepeatedVertex);
    assert_eq!(lists(model.polygons()), [[0, 1, 2], [0, 1, 2]]);
    let data = model.data_named("a", GroupKind::Polygons).unwrap();
    assert_eq!((data.integer_row(0), data.integer_row(1)), (Some(vec![6]), Some(vec![8])));
}

#[test]
fn samples_with_a_repeated_vertex_are_read() {
    let triangle = |face: &str| {
        format!(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n\
        $EndNodes\n$Elements\n2\n1 2 0 {face}\n2 4 0 1 2 3 3\n$EndElements\n"
        )
    };
    let model = read(triangle("1 2 3").as_bytes(), Format::Msh, RemarkCode::CollapsedCell);
    assert_eq!((model.polygons().len(), model.cells().len()), (1, 0));
}

#[test]
fn off_is_read_word_by_word() {
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]].concat();
    for text in [
        // Several vertices on a line, a face over two lines, comments, commas.
        "OFF 4 2 0\n0 0 0 1 0 0 # two\n1 1 0\n0 1 0 3 0 1\n2 3 0 2 3\n",
        "\n\n# a square\nOFF\n4 2 99\n0,0,0\n1,0,0\n1,1,0\n0,1,0\n3,0,1,2\n3,0,2,3\n",
        "OFF\n4 2 5 0 0 0 1 0 0 1 1 0 0 1 0 3 0 1 2 3 0 2 3",
        // Colors behind faces that are broken over lines.
        "OFF\n4 2 5\n0 0 0 1 0 0 1 1 0 0 1 0\n3 0\n1 2 255 0 0\n3 0 2 3 0 0 255\n",
    ] {
        let model = read(text.as_bytes(), Format::Off, RemarkCode::InputReading);
        assert_eq!(model.positions().as_flat(), square, "{text}");
        assert_eq!(lists(model.polygons()), [[0, 1, 2], [0, 2, 3]], "{text}");
    }
    for text in ["OFF\n2 0 0\n0 0 0\n1 0 0\n", "nOFF\n2\n2 0 0\n0 0\n1 0\n"] {
        let model = io::read(text.as_bytes(), Format::Off).unwrap();
        assert_eq!((model.vertex_count(), model.remarks().len()), (2, 0), "{text}");
    }
    // What does not come out even is refused for what it seems to be.
    let error = io::read(&b"OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n"[..], Format::Off).unwrap_err();
    assert!(error.to_string().contains("promises 2 faces, but the file ends after 1"), "{error}");
}

#[test]
fn little_endian_binary_off_is_read() {
    let mut bytes = b"OFF BINARY\n".to_vec();
    bytes.extend([3i32, 1, 0].iter().flat_map(|number| number.to_le_bytes()));
    bytes.extend(
        [0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].iter().flat_map(|number| number.to_le_bytes()),
    );
    bytes.extend([3i32, 0, 1, 2, 0].iter().flat_map(|number| number.to_le_bytes()));
    let model = read(&bytes, Format::Off, RemarkCode::InputReading);
    assert_eq!((lists(model.polygons()), model.positions().as_flat()[3]), (vec![vec![0, 1, 2]], 1.0));
}

#[test]
fn ply_properties_come_in_any_order() {
    let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty list uchar float w\nproperty uchar red\nproperty float z\n\
                property float x\nproperty list uchar int friends\nproperty float y\nelement face 1\nproperty float q\n\
                property list uchar float texcoord\nproperty list uchar int vertex_indices\nproperty list uchar int more\nend_header\n\
                2 9 9 255 3 1 1 5 2\n0 254 6 4 0 5\n1 8 253 9 7 2 1 1 8\n0.5 2 1 1 3 2 1 0 0\n";
    let model = io::read(text.as_bytes(), Format::Ply).unwrap();
    assert_eq!(model.positions().as_flat(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
    assert_eq!((lists(model.polygons()), model.remarks().len()), (vec![vec![2, 1, 0]], 0));
    assert_eq!(model.data_named("red", GroupKind::Vertices).unwrap().integer_row(2), Some(vec![253]));
}

#[test]
fn files_cut_short_are_read_in_part_when_asked() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty int a\n\
               element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0 4\n1 0 0 5\n0 1 0 6\n3 0 1 2\n3 0";
    let off = "OFF\n3 4 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nfacet\n";
    let medit =
        "MeshVersionFormatted 2 Dimension 3 Vertices 3\n0 0 0 0\n1 0 0 0\n0 1 0 0\nTriangles 4\n1 2 3 0\n1 2";
    let msh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n$Elements\n4\n1 2 0 1 2 3\n2 2";
    for (text, format) in [
        (ply, Format::Ply),
        (off, Format::Off),
        (stl, Format::Stl),
        (medit, Format::Medit),
        (msh, Format::Msh),
    ] {
        let options = ReadOptions::new().format(format);
        let error = io::read_with(text.as_bytes(), &options).unwrap_err();
        assert!(error.to_string().contains("file ends"), "{format:?}: {error}");
        let model = io::read_with(text.as_bytes(), &options.partial(true)).unwrap();
        assert_eq!((model.vertex_count(), lists(model.polygons())), (3, vec![vec![0, 1, 2]]), "{format:?}");
        assert_eq!(model.remarks()[0].code, RemarkCode::PartialFile);
    }
    let error = io::read(ply.as_bytes(), Format::Ply).unwrap_err();
    assert!(
        error.to_string().contains("face 1 of the 4 that the header promises; 3 of them are missing"),
        "{error}"
    );
    let vertices = &ply[..ply.find("0 1 0 6").unwrap()];
    let model = io::read_with(vertices.as_bytes(), &ReadOptions::new().partial(true)).unwrap();
    assert_eq!(model.vertex_count(), 2);
    assert_eq!(model.data_named("a", GroupKind::Vertices).unwrap().integer_row(1), Some(vec![5]));
}

#[test]
fn medit_references_are_fractions_and_dimension_1_is_read() {
    let text = "MeshVersionFormatted 2 Dimension 1\nVertices 2\n0 0.0\n2 3.0\nEdges 1\n1 2 7.0\nEnd\n";
    let model = read(text.as_bytes(), Format::Medit, RemarkCode::FractionalLabel);
    assert_eq!((model.positions().dimension(), lists(model.lines())), (1, vec![vec![0, 1]]));
    assert_eq!(model.groups().iter().map(io::Group::name).collect::<Vec<_>>(), ["3", "7"]);
    assert_eq!(model.remarks()[0].count, 3);
    let error = io::read(text.replace("7.0", "7.5").as_bytes(), Format::Medit).unwrap_err();
    assert!(error.to_string().contains("\"7.5\" is not an integer"), "{error}");
}

#[test]
fn gmsh_data_are_read_and_a_missing_end_is_a_remark() {
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nhello\n$EndComments\n$Nodes\n3\n10 0 0 0\n20 1 0 0\n30 2 0 0\n\
                $EndNodes\n$Elements\n2\n7 1 0 10 20\n9 1 0 20 30\n$EndElements\n\
                $NodeData\n2\n\"a view\"\n\"scheme\"\n1\n0.0\n3\n0\n1\n2\n20 0.5\n10 -1\n$EndNodeData\n\
                $ElementData\n1\n\"speed\"\n0\n3\n0\n3\n2\n9 1 2 3\n8 4 5 6\n";
    let model = read(text.as_bytes(), Format::Msh, RemarkCode::DataLeftOut);
    let view = model.data_named("a view", GroupKind::Vertices).unwrap();
    assert_eq!(
        (view.real_row(0), view.real_row(1), view.real_row(2)[0].is_nan()),
        (vec![-1.0], vec![0.5], true)
    );
    let speed = model.data_named("speed", GroupKind::Lines).unwrap();
    assert_eq!((speed.real_row(1), speed.real_row(0)[0].is_nan()), (vec![1.0, 2.0, 3.0], true));
    let codes: Vec<_> = model.remarks().iter().map(|remark| remark.code).collect();
    assert!(codes.contains(&RemarkCode::MissingEnd) && codes.contains(&RemarkCode::DataLeftOut), "{codes:?}");
}

#[test]
fn stl_without_its_end_is_read() {
    let text = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    let model = read(text.as_bytes(), Format::Stl, RemarkCode::MissingEnd);
    assert_eq!(model.polygons().len(), 1);
}

#[test]
fn compressed_files_are_read_by_the_name_before() {
    use std::io::Write;
    let folder = tempfile::tempdir().unwrap();
    let off = b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    gzip.write_all(off).unwrap();
    let mut bzip2 = bzip2::write::BzEncoder::new(Vec::new(), bzip2::Compression::default());
    bzip2.write_all(off).unwrap();
    let zstandard = ruzstd::encoding::compress_to_vec(&off[..], ruzstd::encoding::CompressionLevel::Fastest);
    // What XZ Utils 5 wrote of it.
    let digits = "fd377a585a000004e6d6b4460200210116000000742fe5a3e00023001d5d002791ac14330348a100\
                  4efbcdf91d9a0a1d28f1716e3b996b2de6326000000000006471336ec5a9f42b0001392440dc0112\
                  1fb6f37d010000000004595a";
    let xz =
        (0..digits.len() / 2).map(|i| u8::from_str_radix(&digits[2 * i..2 * i + 2], 16).unwrap()).collect();
    for (extension, bytes) in
        [("gz", gzip.finish().unwrap()), ("bz2", bzip2.finish().unwrap()), ("zst", zstandard), ("xz", xz)]
    {
        let path = folder.path().join(format!("a.off.{extension}"));
        std::fs::write(&path, &bytes).unwrap();
        let model = io::read_path(&path, None).unwrap();
        assert_eq!((model.format(), model.polygons().len()), (Some(Format::Off), 1), "{extension}");
        assert_eq!(io::format_of_path(&path, None).unwrap(), Format::Off);
        assert_eq!(io::read_unknown(&bytes[..]).unwrap(), model, "as a stream");
        assert_eq!(io::read(&bytes[..], Format::Off).unwrap(), model, "of a stated format");
        std::fs::write(&path, &bytes[..bytes.len() / 2]).unwrap();
        assert!(io::read_path(&path, None).is_err(), "{extension}, cut short");
    }
}

#[test]
fn text_in_utf16_is_text() {
    // As redirection of some shells of Windows writes it.
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        ("a.off", "OFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n"),
        ("a.off", "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2"),
        ("a.json", "[[0,1,2]]"),
        ("a.json", &format!("[[0,1,2]{}]", " ".repeat(1 << 17))),
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no \u{c9}tage\nf 1 2 3\n"),
        ("a.wkt", "POLYGON((0 0,1 0,0 1,0 0))"),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        let plain = io::read_path(&path, None).unwrap();
        for is_little in [true, false] {
            let unit = |unit: u16| if is_little { unit.to_le_bytes() } else { unit.to_be_bytes() };
            let bytes: Vec<u8> = std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(unit).collect();
            std::fs::write(&path, &bytes).unwrap();
            assert_eq!(io::read_path(&path, None).unwrap(), plain, "{name}");
            assert_eq!(io::read_unknown(&bytes[..]).unwrap().vertex_count(), plain.vertex_count(), "{name}");
        }
    }
    let binary = b"\xff\xfe\x07\x01\x99\x80";
    assert!(io::read_unknown(&binary[..]).is_err());
}

#[test]
fn gltf_places_its_meshes() {
    // Three points in base64, and a node that moves them twice.
    let points = [0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    let bytes: Vec<u8> = points.iter().flat_map(|x| x.to_le_bytes()).chain([0, 1, 2, 3, 2, 1]).collect();
    let file = |uri: &str| {
        format!(
            r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":54,"uri":"{uri}"}}],
            "bufferViews":[{{"buffer":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":6}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}},
            {{"bufferView":1,"componentType":5121,"count":6,"type":"SCALAR"}}],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
            "nodes":[{{"mesh":0,"name":"low"}},{{"children":[2],"translation":[5,0,0]}},{{"mesh":0,"scale":[2,2,2]}}],
            "scenes":[{{"nodes":[0,1]}}],"scene":0}}"#
        )
    };
    let coded = base64(&bytes);
    let text = file(&format!("data:application/octet-stream;base64,{coded}"));
    let model = read(text.as_bytes(), Format::Gltf, RemarkCode::InputReading);
    assert_eq!(io::read_unknown(text.as_bytes()).unwrap(), model);
    assert_eq!(lists(model.polygons()), [[0, 1, 2], [0, 2, 1], [3, 4, 5], [3, 5, 4]]);
    assert_eq!(model.positions().as_flat()[9..], [5.0, 0.0, 0.0, 7.0, 0.0, 0.0, 5.0, 2.0, 0.0]);
    assert_eq!((model.groups()[0].name(), model.groups()[0].members()), ("low", &[0, 1][..]));
    // A buffer is read from the folder of the file, and from nowhere else.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("in").join("a.gltf");
    std::fs::create_dir(folder.path().join("in")).unwrap();
    std::fs::write(folder.path().join("in/b c.bin"), &bytes).unwrap();
    std::fs::write(folder.path().join("out.bin"), &bytes).unwrap();
    for (uri, message) in [
        ("b%20c.bin", ""),
        ("../out.bin", "outside the folder"),
        ("/etc/hostname", "outside the folder"),
        ("https://example.org/b.bin", "no file of this machine"),
        ("none.bin", "there is no such file"),
        (".", "is no regular file"),
    ] {
        std::fs::write(&path, file(uri)).unwrap();
        match io::read_path(&path, None) {
            Ok(again) => assert!(message.is_empty() && again == model, "{uri}"),
            Err(error) => {
                assert!(!message.is_empty() && error.to_string().contains(message), "{uri}: {error}");
            }
        }
    }
    let cut = text.replace("\"byteLength\":6", "\"byteLength\":60");
    assert!(io::read(cut.as_bytes(), Format::Gltf).unwrap_err().to_string().contains("outside their buffer"));
    let cycle = text.replace("\"children\":[2]", "\"children\":[1]");
    assert!(io::read(cycle.as_bytes(), Format::Gltf).is_err());
}

/// The text of bytes, six bits a letter.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for three in bytes.chunks(3) {
        let bits =
            three.iter().fold(0u32, |bits, &byte| bits << 8 | u32::from(byte)) << (8 * (3 - three.len()));
        for i in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * i) & 63) as usize];
            text.push(if i <= three.len() { char::from(letter) } else { '=' });
        }
    }
    text
}

#[test]
fn collada_places_its_meshes() {
    let text = r##"<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
        <library_geometries><geometry id="g"><mesh>
        <source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 1 1 0 0 1 0</float_array><technique_common>
        <accessor source="#pa" count="4" stride="3"/></technique_common></source>
        <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
        <polylist count="1"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="NORMAL" source="#n" offset="1"/>
        <vcount>4</vcount><p>0 0 1 0 2 0 3 0</p></polylist>
        <triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
        </mesh></geometry></library_geometries>
        <library_visual_scenes><visual_scene id="s"><node name="a"><translate>1 0 0</translate><rotate>0 0 1 90</rotate>
        <instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
        <scene><instance_visual_scene url="#s"/></scene></COLLADA>"##;
    let model = io::read_unknown(text.as_bytes()).unwrap();
    assert_eq!((model.format(), model.remarks().len()), (Some(Format::Collada), 0));
    assert_eq!(lists(model.polygons()), [vec![0, 1, 2, 3], vec![0, 1, 2]]);
    let point = &model.positions().as_flat()[3..6];
    assert!((point[0] - 1.0).abs() < 1e-15 && point[1] == 1.0, "{point:?}");
    assert_eq!(model.groups()[0].members(), [0, 1]);
    let error = io::read(text.replace("3 0</p>", "9 0</p>").as_bytes(), Format::Collada).unwrap_err();
    assert!(error.to_string().contains("names vertex 9"), "{error}");
}

#[test]
fn build_items_of_3mf_are_placed() {
    use std::io::Write;
    let text = r#"<model xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>
        <object id="1" name="flat"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices>
        <triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh></object>
        <object id="2"><components><component objectid="1"/><component objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 9"/></components></object>
        </resources><build><item objectid="2" transform="2 0 0 0 2 0 0 0 2 1 0 0"/></build></model>"#;
    let archive = |text: &str| {
        let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
        archive.start_file("3D/3dmodel.model", zip::write::SimpleFileOptions::default()).unwrap();
        archive.write_all(text.as_bytes()).unwrap();
        archive.finish().unwrap().into_inner()
    };
    let model = io::read_unknown(&archive(text)[..]).unwrap();
    assert_eq!(
        (model.format(), lists(model.polygons())),
        (Some(Format::ThreeMf), vec![vec![0, 1, 2], vec![3, 4, 5]])
    );
    assert_eq!(model.positions().as_flat()[12..15], [3.0, 0.0, 18.0]);
    // Beams are lines; what may not be read without an unknown extension is not read.
    let beams = text
        .replace("<model ", "<model requiredextensions=\"b\" xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" ")
        .replace("</triangles>", "</triangles><b:beamlattice radius=\"1\"><b:beams><b:beam v1=\"0\" v2=\"2\"/></b:beams></b:beamlattice>");
    let model = io::read(&archive(&beams)[..], Format::ThreeMf).unwrap();
    assert_eq!(lists(model.lines()), [[0, 2], [3, 5]]);
    assert_eq!(model.remarks()[0].code, RemarkCode::DataLeftOut);
    let strange = beams.replace("beamlattice/2017/02", "volumetric/2022/01");
    let error = io::read(&archive(&strange)[..], Format::ThreeMf).unwrap_err();
    assert!(error.to_string().contains("volumetric/2022/01") && error.cure().is_some(), "{error}");
    let cycle = text.replace("<component objectid=\"1\"/>", "<component objectid=\"2\"/>");
    assert!(
        io::read(&archive(&cycle)[..], Format::ThreeMf).unwrap_err().to_string().contains("contains itself")
    );
}

#[test]
fn one_of_several_models_is_chosen() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let list = path(
        "a.json",
        r#"[{"name": "2", "facets": [[0, 1]]}, {"facets": [[0, 1, 2]]}, {"name": "c", "facets": [[7]]}]"#,
    );
    assert_eq!(io::entries_of_path(&list, None).unwrap().len(), 3);
    let model = io::read_path(&list, None).unwrap();
    assert_eq!((model.remarks()[0].code, model.remarks()[0].count), (RemarkCode::SeveralModels, 3));
    assert!(io::read_path_with(&list, &ReadOptions::new().strict(true)).is_err());
    // A name comes before a place.
    assert_eq!(io::read_path(format!("{list}#2"), None).unwrap(), model);
    assert_eq!(
        io::read_path(format!("{list}#3"), None).unwrap(),
        io::read_path(format!("{list}#c"), None).unwrap()
    );
    let census = path("a.sig", "cMcabbgqw L(3,1) : #1\ncMcabbjak\n");
    assert_eq!(io::entries_of_path(&census, None).unwrap(), ["L(3,1) : #1", "2"]);
    let chosen = io::read_path(format!("{census}#L(3,1) : #1"), None).unwrap();
    assert_eq!((&chosen, chosen.format()), (&io::read_path(&census, None).unwrap(), Some(Format::Isosig)));
    for (name, text) in [
        ("b.json", "[[[0, 1, 2]], [[5, 6], [6, 7, 8]]]"),
        ("b.jsonl", "[[0, 1, 2]]\n\n[[5, 6], [6, 7, 8]]"),
        ("c.json", "[[[0, 1, 2]], {\"facets\": [[5, 6], [6, 7, 8]]}]"),
    ] {
        let file = path(name, text);
        let model = io::read_path(&file, None).unwrap();
        assert_eq!(
            (model.remarks()[0].code, model.remarks()[0].count),
            (RemarkCode::SeveralModels, 2),
            "{name}"
        );
        let second = io::read_path(format!("{file}#2"), None).unwrap();
        let entries = io::FileEntries::of_path(&file, None).unwrap();
        assert_eq!(entries.read("2", &ReadOptions::new()).unwrap(), second, "{name}");
        assert_eq!(second, io::read(&b"[[5, 6], [6, 7, 8]]"[..], Format::Json).unwrap());
    }
    // Each name that is listed chooses its own model, also where names are places of others, or are given twice.
    let odd = path(
        "f.json",
        r#"[{"name": "2", "facets": [[0, 1]]}, {"facets": [[0, 1, 2]]}, {"name": "c", "facets": [[7]]}, {"name": "c", "facets": [[7, 8]]}]"#,
    );
    let entries = io::FileEntries::of_path(&odd, None).unwrap();
    assert_eq!(entries.names().collect::<Vec<_>>(), ["2", "02", "3", "4"]);
    for (name, facets) in [("2", "[[0,1]]"), ("02", "[[0,1,2]]"), ("3", "[[7]]"), ("4", "[[7,8]]")] {
        let expected = io::read(facets.as_bytes(), Format::Json).unwrap();
        assert_eq!(entries.read(name, &ReadOptions::new()).unwrap(), expected, "{name}");
        assert_eq!(io::read_path(format!("{odd}#{name}"), None).unwrap(), expected, "{name}");
    }
    assert!(
        io::read_path(format!("{odd}#c"), None)
            .unwrap_err()
            .to_string()
            .contains("2 entries have the name c")
    );
    // Features one a line are one drawing.
    let feature = |x: u8| {
        format!(
            "{{\"type\":\"Feature\",\"properties\":{{\"x\":{x}}},\"geometry\":{{\"type\":\"Point\",\"coordinates\":[{x},0]}}}}\n"
        )
    };
    let features = path("g.geojsonl", &(feature(1) + &feature(2)));
    let model = io::read_path(&features, None).unwrap();
    assert_eq!((model.vertex_count(), model.features().properties(1)), (2, "{\"x\":2}"));
    let torn = path("h.ndjson", &(feature(1) + "{\"type\":"));
    assert!(io::read_path(&torn, None).unwrap_err().to_string().contains(":2: "));
    // Pairs of numbers, and numbers that are no corners of a simplex, are points.
    for points in ["[[[0, 0], [1, 0], [0, 1], [0, 0]]]", "[[[0, 1, 1], [5, 1, 2], [1, 2, 3], [0, 1, 1]]]"] {
        assert_eq!(io::read_path(path("d.json", points), None).unwrap().format(), Some(Format::GeoJson));
    }
    for (text, fault) in [
        ("[[0, 1]]\n[[0, 1]", "the file was cut short"),
        ("[[0, 1]]\n[[2, 2]]", ":2: facet 0 repeats vertex 2"),
        ("[[0, 1]]\n[{\"facets\": [[0, 1]]}]", "value 2 of the file is itself a list"),
        ("[[[0, 1, 2]], [0, 1]]", "holds facets as well as models"),
    ] {
        let error = io::read_path(path("e.jsonl", text), None).unwrap_err().to_string();
        assert!(error.contains(fault), "{error}");
    }
    let parts = path("a.obj", "o low\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no high\nv 0 0 9\nf 4 3 2\n");
    assert!(io::entries_of_path(&parts, None).unwrap().is_empty());
    assert_eq!(io::parts_of_path(&parts, None).unwrap(), ["low", "high"]);
    let solids = path("a.stl", "solid\nendsolid\nsolid b c\nendsolid b c\nsolid d\nendsolid d");
    assert_eq!(io::parts_of_path(&solids, None).unwrap(), ["b c", "d"]);
    let one = path("b.obj", "o low\nv 0 0 0\no low\n");
    assert!(io::parts_of_path(&one, None).unwrap().is_empty());
    let model = io::read_path(format!("{parts}#high"), None).unwrap();
    assert_eq!((model.vertex_count(), lists(model.polygons())), (3, vec![vec![0, 1, 2]]));
    assert_eq!(model.positions().as_flat()[2], 9.0);
    assert_eq!(io::read_path(format!("{parts}#2"), None).unwrap(), model);
    let error = io::read_path(format!("{parts}#middle"), None).unwrap_err();
    assert!(error.to_string().contains("low, high"), "{error}");
}

/// An OBJ is read up to its first fault; faces whose vertices would have come behind it go too, and their groups lose them.
#[test]
fn a_cut_obj_is_read_partly() {
    let whole = "v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\ng b\nf 1 2 4\nf 3 2 1\nl 1 2\nv 0 0 1\nv 0 x 0\n";
    let partial = ReadOptions::new().format(Format::Obj).partial(true);
    let model = io::read_with(whole.as_bytes(), &partial).unwrap();
    assert_eq!((model.vertex_count(), model.polygons().len(), model.lines().len()), (4, 3, 1));
    assert_eq!(
        (model.remarks()[0].code, model.remarks()[0].places[0].line),
        (RemarkCode::PartialFile, Some(11))
    );
    let cut = &whole[..whole.find("v 0 0 1").unwrap()];
    assert!(io::read(cut.as_bytes(), Format::Obj).unwrap_err().to_string().contains("line 7"));
    let model = io::read_with(cut.as_bytes(), &partial).unwrap();
    assert_eq!((model.vertex_count(), model.polygons().len(), model.lines().len()), (3, 1, 1));
    let members: Vec<usize> = model.groups().iter().map(|group| group.members().len()).collect();
    assert_eq!(members, [1, 0, 1], "the line is in the second too");
    assert!(io::read_with(&b""[..], &partial).is_err());
}

/// A file on disk is read once more where it is not laid out line by line, packed or not, with the same result as a stream.
#[test]
fn files_on_disk_are_read_again() {
    let folder = tempfile::tempdir().unwrap();
    for text in [
        "OFF\n3 1 0 0 0 0 1 0 0 0 1 0\n3 0 1 2\n",
        "\u{feff}OFF 3, 1, 0\n0,0,0\n1,0,0\n0,1,0\n3,0,1\n2\n",
        "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0\n",
    ] {
        for options in [ReadOptions::new(), ReadOptions::new().partial(true), ReadOptions::new().strict(true)]
        {
            let from_stream = io::read_with(text.as_bytes(), &options.format(Format::Off));
            let path = folder.path().join("a.off");
            std::fs::write(&path, text).unwrap();
            let packed = folder.path().join("a.off.gz");
            let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
            std::io::Write::write_all(&mut encoder, text.as_bytes()).unwrap();
            std::fs::write(&packed, encoder.finish().unwrap()).unwrap();
            for path in [&path, &packed] {
                let from_disk = io::read_path_with(path, &options);
                match (&from_stream, from_disk) {
                    (Ok(stream), Ok(disk)) => assert_eq!(*stream, disk, "{text}"),
                    (Err(stream), Err(disk)) => assert_eq!(stream.message(), disk.message(), "{text}"),
                    (stream, disk) => panic!("{stream:?} {disk:?}"),
                }
            }
        }
    }
}
