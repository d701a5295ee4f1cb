//! Tests of both directions, with arrays of every encoding.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use super::tests::on_all_cells;
use super::{XmlKind, read_xml, write_xml};
use crate::samples::{Limits, meshes, with_data};
use crate::{Format, GroupKind, Model, read_unknown};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use coface_complexes::cell_mesh::CellShape;
use proptest::prelude::*;
use std::io::Write;

/// Written by VTK 9.7, but for those that name another program: meshio 5.3, pyvista 0.49.
const POLYGONS: [(&str, &[u8]); 4] = [
    ("text", include_bytes!("../../tests/vtk_xml/text.vtp")),
    ("base64 packed, 64-bit lengths, big-endian", include_bytes!("../../tests/vtk_xml/binary.vtp")),
    ("appended base64", include_bytes!("../../tests/vtk_xml/appended.vtp")),
    ("appended base64 packed, big-endian", include_bytes!("../../tests/vtk_xml/packed.vtp")),
];
const GRIDS: [(&str, &[u8]); 3] = [
    ("appended bytes, 64-bit lengths", include_bytes!("../../tests/vtk_xml/raw.vtu")),
    ("appended bytes packed", include_bytes!("../../tests/vtk_xml/packed.vtu")),
    ("base64, big-endian", include_bytes!("../../tests/vtk_xml/big.vtu")),
];
const PIECES: &[u8] = include_bytes!("../../tests/vtk_xml/pieces.vtu");
const MESHIO: [&[u8]; 2] = [
    include_bytes!("../../tests/vtk_xml/meshio.vtu"),
    include_bytes!("../../tests/vtk_xml/meshio_plain.vtu"),
];
const PYVISTA: &[u8] = include_bytes!("../../tests/vtk_xml/pyvista.vtp");

fn column(model: &Model, name: &str, kind: GroupKind) -> Vec<f64> {
    let data = model.data_named(name, kind).unwrap();
    (0..data.len()).map(|i| data.real_row(i)[0]).collect()
}

#[test]
fn polygons_of_vtk_are_read_in_every_encoding() {
    for (encoding, bytes) in POLYGONS {
        let model = read_unknown(bytes).unwrap();
        assert_eq!(model.format(), Some(Format::VtkPolygons));
        let polygons: Vec<&[u32]> = model.polygons().iter().collect();
        assert_eq!(polygons, [&[0, 1, 2, 3][..], &[1, 4, 2], &[1, 4, 2], &[2, 4, 5]], "{encoding}");
        assert_eq!((model.lines().list(0), model.points()[0].index()), (&[0, 1, 2][..], 3));
        assert_eq!(model.positions().as_flat()[15..], [2.0, 1.0, 0.5]);
        // Cells in the order in which they are drawn: a vertex, a line, two polygons, a strip of two triangles.
        assert_eq!(column(&model, "kind", GroupKind::Lines), [20.0]);
        assert_eq!(column(&model, "kind", GroupKind::Polygons), [30.0, 40.0, 50.0, 50.0]);
        assert_eq!(column(&model, "height", GroupKind::Vertices), [0.0, 0.25, 0.5, 0.75, 1.0, 1.25]);
    }
}

#[test]
fn grids_of_vtk_are_read_in_every_encoding() {
    for (encoding, bytes) in GRIDS {
        let model = read_unknown(bytes).unwrap();
        assert_eq!(model.format(), Some(Format::VtkGrid), "{encoding}");
        use CellShape::{Hexahedron, Pyramid, Tetrahedron, Wedge};
        assert_eq!(model.shapes(), [Hexahedron, Tetrahedron, Wedge, Pyramid]);
        assert_eq!(model.cells().list(2), [4, 6, 5, 8, 10, 9]);
        assert_eq!(column(&model, "density", GroupKind::Cells), [0.5, 1.5, 2.5, 3.5]);
        assert_eq!(column(&model, "density", GroupKind::Lines), [5.5]);
        assert_eq!(
            model.data_named("velocity", GroupKind::Vertices).unwrap().real_row(11),
            [11.0, 0.0, -11.0]
        );
    }
}

#[test]
fn pieces_and_files_of_other_programs_are_read() {
    // Both pieces are the whole grid.
    let model = read_unknown(PIECES).unwrap();
    let whole = read_unknown(GRIDS[0].1).unwrap();
    assert_eq!(model.vertex_count(), 2 * whole.vertex_count());
    assert_eq!(model.cells().list(5), [16, 17, 18, 20]);
    assert_eq!(column(&model, "density", GroupKind::Cells), [0.5, 1.5, 2.5, 3.5, 0.5, 1.5, 2.5, 3.5]);
    assert_eq!(column(&model, "density", GroupKind::Polygons), [4.5, 4.5]);
    assert_eq!(model.data_named("velocity", GroupKind::Vertices).unwrap().real_row(23), [11.0, 0.0, -11.0]);
    assert!(model.remarks().is_empty(), "{:?}", model.remarks());
    for bytes in MESHIO {
        let model = read_unknown(bytes).unwrap();
        assert_eq!((model.cells().list(0), model.polygons().list(0)), (&[0, 1, 2, 3][..], &[0, 1, 2][..]));
        assert_eq!(column(&model, "a", GroupKind::Cells), [1.5]);
        assert_eq!(column(&model, "a", GroupKind::Polygons), [2.5]);
    }
    let cube = read_unknown(PYVISTA).unwrap();
    assert_eq!((cube.polygons().len(), column(&cube, "n", GroupKind::Polygons).len()), (6, 6));
}

/// A file made by hand from the format's documentation: a square with a hole in one byte of XML or another.
fn by_hand(head: &str, data: &str, polys: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n<!-- <AppendedData -->\n<VTKFile type=\"PolyData\" version=\"0.1\" {head}>\n<PolyData>\n\
         <FieldData><DataArray type=\"Int32\" Name=\"TIME\" NumberOfTuples=\"1\" format=\"ascii\">7</DataArray></FieldData>\n\
         <Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\">\n{data}\n<Points>\n\
         <DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">\n0 0 0 <!-- a --> 1 0 0\n1 1 0 0 1 0</DataArray>\n\
         </Points>\n<Polys>\n{polys}\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n"
    )
}

const POLYS: &str = "<DataArray type=\"UInt64\" Name=\"connectivity\" format=\"ascii\">0 1 2\n0 2 3</DataArray>\n\
    <DataArray type=\"Int8\" Name=\"offsets\" format=\"ascii\">3 6</DataArray>";

fn fault(text: &str) -> String {
    read_xml(text.as_bytes()).unwrap_err().to_string()
}

#[test]
fn a_file_by_hand_and_its_faults() {
    let data = "<PointData><Array type=\"String\" Name=\"who\" format=\"ascii\">97 0</Array></PointData>\
        <CellData><DataArray type=\"UInt8\" Name=\"rgb\" NumberOfComponents=\"3\" format=\"ascii\">1 2 3 4 5 6</DataArray></CellData>";
    let model = read_xml(by_hand("", data, POLYS).as_bytes()).unwrap();
    assert_eq!(model.polygons().iter().collect::<Vec<_>>(), [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(model.data_named("rgb", GroupKind::Polygons).unwrap().integer_row(1), Some(vec![4, 5, 6]));
    assert_eq!(
        model.remarks().iter().map(|remark| &remark.message[..]).collect::<Vec<_>>(),
        ["the data \"who\" are no numbers; they are left out"]
    );
    for (from, to, message) in [
        ("0 2 3<", "0 2 4<", "line 14: cell 1 names point 4, but the piece has 4 points, numbered from 0"),
        ("0 2 3<", "0 2 -1<", "cell 1 names point -1"),
        ("0 2 3<", "0 2<", "in the array \"connectivity\": the file ends where a number should be"),
        ("0 2 3<", "0 2 x<", "line 15: in the array \"connectivity\": \"x\" is not a number"),
        ("0 2 3<", "0 2 3 3<", "there are more than 6 numbers"),
        ("3 6<", "3 2<", "there are more than 2 numbers"),
        ("3 6<", "7 6<", "the offset of cell 0 is 7; offsets rise from 0 to 6"),
        ("3 6<", "3 -6<", "the last offset is negative"),
        ("1 1 0", "none 1 0", "\"none\" is not a number"),
        ("=\"Float32\"", "=\"Float\"", "line 9: \"Float\" is no type of numbers in VTK XML"),
        ("NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"", "the file ends where a number should be"),
        ("NumberOfPoints=\"4\"", "NumberOfPoints=\"99999999999\"", "the file ends where a number should be"),
        ("NumberOfPoints=\"4\"", "NumberOfPoints=\"many\"", "NumberOfPoints is \"many\", not a count"),
        ("NumberOfPoints=\"4\"", "", "Piece has no attribute NumberOfPoints"),
        (
            "NumberOfComponents=\"3\" format",
            "NumberOfComponents=\"2\" format",
            "there are more than 8 numbers",
        ),
        ("format=\"ascii\">3", "format=\"appended\" offset=\"0\">3", "there are no appended data"),
        ("format=\"ascii\">3", "format=\"binary\">3", "the bytes end too early"),
        ("format=\"ascii\">3", "format=\"hex\">3", "\"hex\" is no format of an array"),
        ("Name=\"offsets\"", "Name=\"ends\"", "the array offsets is missing"),
        ("</Polys>", "</Polies>", "this is no XML"),
        ("type=\"PolyData\"", "type=\"ImageData\"", "data sets of the kind \"ImageData\" are not read"),
        ("VTKFile", "VTKfile", "the element \"VTKfile\" stands where VTKFile should"),
        ("<Polys>", "<Polygons>", "this is no XML"),
    ] {
        let text = fault(&by_hand("", "", POLYS).replace(from, to));
        assert!(text.contains(message) && text.contains("; "), "{text}");
    }
    for (head, message) in [
        ("byte_order=\"Middle\"", "byte_order is \"Middle\""),
        ("header_type=\"Int8\"", "header_type is \"Int8\""),
        ("compressor=\"vtkLZ4DataCompressor\"", "the compressor is \"vtkLZ4DataCompressor\""),
    ] {
        assert!(fault(&by_hand(head, "", POLYS)).contains(message));
    }
}

/// Connectivity in blocks of seven bytes, each packed; lengths and blocks are base64 each for itself.
#[test]
fn arrays_of_several_blocks_are_unpacked() {
    let bytes: Vec<u8> = [0u32, 1, 2, 0, 2, 3].into_iter().flat_map(u32::to_le_bytes).collect();
    let packed = |block: &[u8]| {
        let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
        encoder.write_all(block).unwrap();
        encoder.finish().unwrap()
    };
    let blocks: Vec<Vec<u8>> = bytes.chunks(7).map(packed).collect();
    let lengths = [blocks.len(), 7, 24 % 7].into_iter().chain(blocks.iter().map(Vec::len));
    let lengths: Vec<u8> = lengths.flat_map(|length| (length as u32).to_le_bytes()).collect();
    let polys = |lengths: &[u8], blocks: &[u8]| {
        let text = STANDARD.encode(lengths) + &STANDARD.encode(blocks);
        let array = format!(
            "<DataArray type=\"Int32\" Name=\"connectivity\" format=\"binary\">\n{text}\n</DataArray>"
        );
        let polys = array + "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6</DataArray>";
        by_hand("compressor=\"vtkZLibDataCompressor\"", "", &polys)
    };
    let blocks = blocks.concat();
    let model = read_xml(polys(&lengths, &blocks).as_bytes()).unwrap();
    assert_eq!(model.polygons().iter().collect::<Vec<_>>(), [[0, 1, 2], [0, 2, 3]]);
    for (at, value, message) in [
        (4, 6, "there are 21 bytes where the numbers have 24"),
        (4, 8, "there are 27 bytes where the numbers have 24"),
        (8, 2, "there are 23 bytes where the numbers have 24"),
        (3, 255, "bytes where the numbers have 24"),
        (12, 2, "block 0 cannot be unpacked"),
    ] {
        let mut lengths = lengths.clone();
        lengths[at] = value;
        let text = fault(&polys(&lengths, &blocks));
        assert!(text.contains(message), "{text}");
    }
    for (count, message) in [(6, "block 0 has only 6 bytes, not 7"), (8, "block 0 has more bytes, not 7")] {
        let wrong = packed(&bytes[..count]);
        let mut lengths = lengths.clone();
        let behind = &blocks[usize::from(lengths[12])..];
        lengths[12] = wrong.len() as u8;
        let text = fault(&polys(&lengths, &[&wrong[..], behind].concat()));
        assert!(text.contains(message), "{text}");
    }
}

#[test]
fn files_that_were_cut_are_refused() {
    let files =
        POLYGONS.into_iter().chain(GRIDS).map(|(_, bytes)| bytes).chain([PIECES, PYVISTA]).chain(MESHIO);
    for bytes in files {
        let whole = bytes.len() - bytes.iter().rev().position(|&byte| byte == b'>').unwrap();
        for end in 0..whole - 1 {
            assert!(read_xml(&bytes[..end]).is_err(), "{end}");
        }
    }
}

proptest! {
    #[test]
    fn what_is_written_reads_back(model in with_data(meshes(Limits {
        dimension: 3, largest_polygon: 7, longest_line: 5, points: true, groups: false,
    }), &[GroupKind::Vertices, GroupKind::Lines, GroupKind::Polygons, GroupKind::Cells])) {
        let mut expected = on_all_cells(&model);
        // Data on points come first.
        expected.data.sort_by_key(|data| data.kind() != GroupKind::Vertices);
        for kind in [XmlKind::UnstructuredGrid, XmlKind::PolyData] {
            if kind == XmlKind::PolyData && !model.cells.is_empty() {
                continue;
            }
            let mut out = Vec::new();
            write_xml(&model, &mut out, kind).unwrap();
            prop_assert_eq!(&read_xml(&out[..]).unwrap(), &expected);
        }
    }

    /// Whatever happens to a byte, there is a sound model or a fault.
    #[test]
    fn damaged_files_do_no_harm(file in 0..7usize, at in any::<prop::sample::Index>(), byte: u8) {
        let files: Vec<&[u8]> = POLYGONS.into_iter().chain(GRIDS).map(|(_, bytes)| bytes).collect();
        let mut bytes = files[file].to_vec();
        let at = at.index(bytes.len());
        bytes[at] = byte;
        if let Ok(model) = read_xml(&bytes[..]) {
            model.check().unwrap();
        }
    }
}
