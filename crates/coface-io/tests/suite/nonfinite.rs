//! Coordinates that are NaN or infinite: kept with a remark, refused by strict reading, written again where the format can.

use coface_algebra::VertexId;
use coface_io::{self as io, Format, Model, Place, ReadOptions, RemarkCode, ply, stl, vtk};
use proptest::prelude::*;

/// Files of a tetrahedron's surface in which `X Y Z` stands for the coordinates of the last vertex; with its line.
const TEXTS: [(Format, &str, u64); 7] = [
    (Format::Obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv X Y Z\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n", 4),
    (Format::Off, "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\nX Y Z\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", 6),
    (
        Format::Ply,
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
         element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\nX Y Z\n\
         3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
        13,
    ),
    (
        Format::Medit,
        "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\nX Y Z 0\n\
         Triangles 4\n1 3 2 0\n1 2 4 0\n2 3 4 0\n3 1 4 0\nEnd\n",
        7,
    ),
    (
        Format::Msh,
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 X Y Z\n$EndNodes\n\
         $Elements\n4\n1 2 0 1 3 2\n2 2 0 1 2 4\n3 2 0 2 3 4\n4 2 0 3 1 4\n$EndElements\n",
        9,
    ),
    (
        Format::Vtk,
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0\n1 0 0\n0 1 0\nX Y Z\n\
         POLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
        9,
    ),
    (Format::Points, "0 0 0\n1 0 0\n0 1 0\nX Y Z\n", 4),
];

fn with(text: &str, point: [&str; 3]) -> String {
    text.replace("X Y Z", &point.join(" "))
}

fn read(bytes: &[u8], format: Format) -> Model {
    let model = io::read(bytes, format).unwrap_or_else(|error| panic!("{format:?}: {error}"));
    model.check().expect("a model that was read is sound");
    model
}

/// Sees to it that only this vertex has no position, and that the one remark says so.
fn check(model: &Model, vertex: usize, line: Option<u64>) {
    assert!(model.positions().is_empty(), "nothing computes with positions that are not finite");
    let partial = model.partial_positions().expect("some positions are there");
    assert_eq!(partial.unplaced(), [VertexId::new(vertex)]);
    assert_eq!(partial.len(), model.vertex_count());
    let [remark] = model.remarks() else { panic!("one remark: {:?}", model.remarks()) };
    assert_eq!((remark.code, remark.count), (RemarkCode::NonfiniteCoordinate, 1));
    let mut place = Place::cell(&[vertex as u32]);
    place.line = line;
    assert_eq!(remark.places, [place], "{}", remark.message);
}

/// Sees to it that strict reading refuses the bytes with the place.
fn refused(bytes: &[u8], format: Format, place: &str) {
    let error = io::read_with(bytes, &ReadOptions::new().format(format).strict(true)).expect_err("strict");
    let text = error.to_string();
    assert!(text.contains("a coordinate that is not finite") && text.contains(place), "{text}");
}

#[test]
fn texts_keep_such_coordinates_and_strict_reading_refuses_them() {
    for (format, text, line) in TEXTS {
        let whole = read(with(text, ["0", "0", "1"]).as_bytes(), format);
        for words in [
            ["nan", "0", "1"],
            ["0", "-NaN", "1"],
            ["0", "0", "inf"],
            ["-Infinity", "0", "1"],
            ["0", "1e999", "nan"],
        ] {
            let bytes = with(text, words).into_bytes();
            let model = read(&bytes, format);
            check(&model, 3, Some(line));
            assert_eq!((model.polygons(), model.points()), (whole.polygons(), whole.points()), "{format:?}");
            let partial = model.partial_positions().unwrap();
            for vertex in (0..3).map(VertexId::new) {
                assert_eq!(partial.point(vertex), Some(whole.positions().point(vertex)));
            }
            refused(&bytes, format, &format!("the first is on line {line}"));
            let fault = model.require_finite().unwrap_err().to_string();
            assert!(fault.contains("of v3 is ") && fault.contains("not a finite number"), "{fault}");
        }
        let words = ["-nan(ind)", "0", "1"];
        check(&read(with(text, words).as_bytes(), format), 3, Some(line));
        let error = io::read(with(text, ["0", "none", "1"]).as_bytes(), format).unwrap_err().to_string();
        assert!(error.contains("\"none\" is not a number"), "{format:?}: {error}");
    }
}

/// The triangles of the surface of a tetrahedron, by their corners.
fn facets(last: [f32; 3]) -> Vec<[[f32; 3]; 3]> {
    let points = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], last];
    [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|triangle| triangle.map(|v| points[v])).to_vec()
}

fn binary_stl(facets: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend((facets.len() as u32).to_le_bytes());
    for facet in facets {
        bytes.extend([0; 12]);
        bytes.extend(facet.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn stl_welds_such_corners_by_their_bits() {
    for last in [[f32::NAN, 0.0, 1.0], [0.0, f32::INFINITY, 1.0], [f32::NEG_INFINITY, f32::NAN, 1.0]] {
        let bytes = binary_stl(&facets(last));
        let model = read(&bytes, Format::Stl);
        check(&model, 3, None);
        assert_eq!((model.vertex_count(), model.polygons().len()), (4, 4), "a closed surface");
        refused(&bytes, Format::Stl, "the first is v3");
        let mut text = "solid\n".to_owned();
        for facet in facets(last) {
            text += "facet normal 0 0 0\nouter loop\n";
            facet.iter().for_each(|[x, y, z]| text += &format!("vertex {x} {y} {z}\n"));
            text += "endloop\nendfacet\n";
        }
        text += "endsolid\n";
        let of_text = read(text.as_bytes(), Format::Stl);
        assert_eq!(of_text, model);
        check(&of_text, 3, Some(13));
        refused(text.as_bytes(), Format::Stl, "line 13");
    }
    // Numbers beyond single precision are of no use there.
    let text = "solid\nfacet\nouter loop\nvertex 0 1e39 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    check(&read(text.as_bytes(), Format::Stl), 0, Some(4));
    refused(text.as_bytes(), Format::Stl, "line 4");
}

#[test]
fn binary_files_keep_such_coordinates() {
    let head = "ply\nformat binary_big_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\n\
                property float z\nend_header\n";
    let mut packed = head.as_bytes().to_vec();
    packed.extend([0f32, 1.0, 2.0, 3.0, f32::INFINITY, 5.0].iter().flat_map(|x| x.to_be_bytes()));
    check(&read(&packed, Format::Ply), 1, None);
    refused(&packed, Format::Ply, "the first is v1");
    // With a list between them the vertices have no fixed length.
    let mut loose =
        head.replace("property float z\n", "property list uchar int l\nproperty float z\n").into_bytes();
    for [x, y, z] in [[0f32, f32::NAN, 2.0], [3.0, 4.0, 5.0]] {
        loose.extend([x.to_be_bytes(), y.to_be_bytes()].concat());
        loose.push(0);
        loose.extend(z.to_be_bytes());
    }
    check(&read(&loose, Format::Ply), 0, None);

    let mut off = b"OFF BINARY\n".to_vec();
    off.extend([1i32, 0, 0].iter().flat_map(|x| x.to_be_bytes()));
    off.extend([0f32, f32::NAN, 0.0].iter().flat_map(|x| x.to_be_bytes()));
    check(&read(&off, Format::Off), 0, None);
    refused(&off, Format::Off, "the first is v0");
}

#[test]
fn placed_meshes_of_gltf_keep_them_too() {
    let numbers = [0f32, 0.0, 0.0, 1.0, f32::NEG_INFINITY, 0.0, 0.0, 1.0, 0.0];
    // The bytes of the buffer stand in the file in base 64.
    let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
    let digits = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let data: String = bytes
        .chunks_exact(3)
        .flat_map(|three| {
            let all = u32::from(three[0]) << 16 | u32::from(three[1]) << 8 | u32::from(three[2]);
            [18, 12, 6, 0].map(|shift| char::from(digits[(all >> shift & 63) as usize]))
        })
        .collect();
    let text = format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"scenes\":[{{\"nodes\":[0]}}],\"nodes\":[{{\"mesh\":0,\"translation\":[1,2,3]}}],\
         \"buffers\":[{{\"byteLength\":36,\"uri\":\"data:application/octet-stream;base64,{data}\"}}],\
         \"bufferViews\":[{{\"buffer\":0,\"byteLength\":36}}],\
         \"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}}],\
         \"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}}}}]}}]}}"
    );
    let model = read(text.as_bytes(), Format::Gltf);
    assert_eq!(model.polygons().len(), 1);
    check(&model, 1, None);
    refused(text.as_bytes(), Format::Gltf, "the first is v1");
}

#[test]
fn words_in_any_layout_and_other_formats_keep_them_too() {
    let off = "OFF 3 1 0 0 0 0 1,nan 0\n0 1 0 3 0 1 2";
    let model = io::read(off.as_bytes(), Format::Off).unwrap();
    let codes: Vec<RemarkCode> = model.remarks().iter().map(|remark| remark.code).collect();
    assert_eq!(codes, [RemarkCode::InputReading, RemarkCode::NonfiniteCoordinate]);
    let node = "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 inf 0\n4 0 0 1\n";
    check(&read(node.as_bytes(), Format::TetGen), 2, Some(4));
    let inp = "*NODE\n1, 0, 0, 0\n2, 1, nan, 0\n3, 0, 1, 0\n*ELEMENT, TYPE=S3\n1, 1, 2, 3\n";
    check(&read(inp.as_bytes(), Format::Abaqus), 1, None);
    let vtp = "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\"><Points>\
               <DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 nan 0</DataArray></Points>\
               <Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray>\
               <DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray></Polys></Piece></PolyData></VTKFile>";
    check(&read(vtp.as_bytes(), Format::VtkPolygons), 2, None);
    refused(vtp.as_bytes(), Format::VtkPolygons, "the first is v2");
    // Columns that are no coordinates may hold anything.
    let points = read(b"x,y,z,t\n0,0,0,nan\n1,1,1,2\n", Format::Points);
    assert!(points.partial_positions().is_none() && points.remarks().is_empty());
}

#[test]
fn many_are_counted_and_the_first_are_named() {
    let mut text = String::new();
    for i in 0..30_000 {
        text += if i % 3 == 2 { "v 0 nan 0\n" } else { "v 0 0.25 0\n" };
    }
    let model = read(text.as_bytes(), Format::Obj);
    let remark = &model.remarks()[0];
    assert_eq!((remark.count, remark.places.len()), (10_000, 5));
    assert_eq!(remark.places[4], Place::cell(&[14]).on_line(15));
    assert!(
        remark.message.starts_with("10000 vertices have a coordinate that is not finite"),
        "{}",
        remark.message
    );
    assert_eq!(model.partial_positions().unwrap().unplaced().len(), 10_000);
}

#[test]
fn formats_that_have_no_words_for_them_refuse_them() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3 4\n";
    let model = read(square.as_bytes(), Format::Obj);
    for format in [Format::Json, Format::GeoJson, Format::Wkt, Format::Svg, Format::Lines, Format::Container]
    {
        let mut out = Vec::new();
        let error = io::write(&model, &mut out, format).expect_err(format.name());
        assert_eq!(error.message(), "coordinate 1 of v2 is NaN, not a finite number", "{format:?}");
        assert!(out.is_empty());
    }
    // Drawings need coordinates already where they are read.
    for (format, text) in [
        (Format::Wkt, "LINESTRING (0 0, 1 nan)"),
        (Format::Lines, "0,0,1,nan\n"),
        (Format::GeoJson, "{\"type\":\"Point\",\"coordinates\":[0,NaN]}"),
    ] {
        assert!(io::read(text.as_bytes(), format).is_err(), "{format:?}");
    }
    // A list of facets has no positions.
    let triangle = read(b"v 0 0 0\nv 1 0 0\nv 1 nan 0\nf 1 2 3\n", Format::Obj);
    let mut out = Vec::new();
    io::write(&triangle, &mut out, Format::Json).unwrap();
    assert_eq!(out, b"{\"facets\":[\n[0,1,2]\n]}\n");
}

#[test]
fn a_part_of_a_file_has_the_positions_of_its_vertices() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("two.obj");
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 inf 0\ng low\nf 1 2 3\ng high\nf 2 4 3\n";
    std::fs::write(&path, text).unwrap();
    let part = |name: &str| io::read_path(format!("{}#{name}", path.display()), None).unwrap();
    assert_eq!(part("low").positions().len(), 3);
    assert_eq!(part("high").partial_positions().unwrap().unplaced(), [VertexId::new(1)]);
}

/// Any coordinate of single precision that a format can hold, those that are not finite often among them.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => (-9..9i8).prop_map(f64::from),
        1 => Just(f64::NAN),
        1 => Just(f64::INFINITY),
        1 => Just(f64::NEG_INFINITY),
    ]
}

proptest! {
    /// What is written reads back, in every format that can hold it; STL, which knows vertices by their coordinates alone, once welded.
    #[test]
    fn what_is_written_reads_back(points in prop::collection::vec([coordinate(), coordinate(), coordinate()], 3..8)) {
        let mut text = String::new();
        points.iter().for_each(|[x, y, z]| text += &format!("v {x} {y} {z}\n"));
        text += "f 1 2 3\n";
        let model = read(text.as_bytes(), Format::Obj);
        for format in [Format::Obj, Format::Off, Format::Ply, Format::Medit, Format::Msh, Format::Vtk, Format::VtkGrid, Format::VtkPolygons] {
            let mut out = Vec::new();
            io::write(&model, &mut out, format).unwrap();
            prop_assert_eq!(&read(&out, format), &model, "{:?}", format);
        }
        let mut out = Vec::new();
        ply::write(&model, &mut out, ply::Encoding::Ascii).unwrap();
        prop_assert_eq!(&read(&out, Format::Ply), &model);
        out.clear();
        vtk::write(&model, &mut out, vtk::Encoding::Binary).unwrap();
        prop_assert_eq!(&read(&out, Format::Vtk), &model);
        let mut binary = Vec::new();
        stl::write(&model, &mut binary, stl::Encoding::Binary).unwrap();
        let mut ascii = Vec::new();
        stl::write(&model, &mut ascii, stl::Encoding::Ascii).unwrap();
        prop_assert_eq!(read(&binary, Format::Stl), read(&ascii, Format::Stl));
    }
}
