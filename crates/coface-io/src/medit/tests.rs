use super::{read, write};
use crate::samples::{Limits, meshes};
use crate::{Format, GroupKind, Model, ReadOptions, RemarkCode};
use proptest::prelude::*;

const HEADER: &str = "MeshVersionFormatted 1\nDimension\n3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";

fn fault(rest: &str) -> String {
    read(format!("{HEADER}{rest}").as_bytes()).unwrap_err().to_string()
}

#[test]
fn faults_are_placed() {
    for (rest, message) in [
        ("Tetrahedra 1\n1 2 3 5 0\n", "line 10: Tetrahedra name vertex 5, but there are 4"),
        ("Tetrahedra 1\n0 2 3 4 0\n", "name vertex 0"),
        ("Triangles 1000000000\n1 2 3 0\n", "the file ends where a vertex should be"),
        ("Triangles 2\n1 2 3 0\n1 2 x 0\n", "line 11: \"x\" is not an integer"),
        ("Triangles -1\n", "cannot be negative"),
        ("Triangles 1\n1 2 3 4 5\n*", "\"5\" stands where a keyword should"),
        ("Dimension 3\n", "given twice"),
        ("Corners 1\n5\nEnd", "Corners lists number 5, but there are 4"),
        ("Ridges 1\n0\nEnd", "numbers start at 1"),
    ] {
        let text = fault(rest);
        assert!(text.contains(message), "{text}");
    }
    let text = read(&b"MeshVersionFormatted 1 Dimension 3 Triangles 1\n1 2 3 0"[..]).unwrap_err().to_string();
    assert!(text.contains("Triangles stand before the vertices; put"), "{text}");
    let text = read(&b"MeshVersionFormatted 1 Dimension 4"[..]).unwrap_err().to_string();
    assert!(text.contains("the dimension is 4"), "{text}");
    let vertex = b"MeshVersionFormatted 1 Dimension 3 Vertices 1\n0 nan 0 0 End";
    assert_eq!(read(&vertex[..]).unwrap().remarks()[0].places[0].line, Some(2));
    let strict = ReadOptions::new().format(Format::Medit).strict(true);
    let text = crate::read_with(&vertex[..], &strict).unwrap_err().to_string();
    assert!(text.contains("a coordinate that is not finite") && text.contains("on line 2"), "{text}");
}

#[test]
fn other_sections_are_passed_over_and_marks_kept() {
    let text = format!(
        "{HEADER}# a comment\nCorners 2\n4 1\nNormals 1\n-1 .5 +2\nRequiredTriangles 1\n2\nTriangles 1\n1 2 3 0\n\
         Quadrilaterals 1\n1 2 3 4 0\nTriangles 1\n2 3 4 0\nEnd\ntrailing"
    );
    let model = read(text.as_bytes()).unwrap();
    assert_eq!(model.polygons().iter().map(<[u32]>::len).collect::<Vec<_>>(), [3, 4, 3]);
    let groups: Vec<_> = model.groups().iter().map(|g| (g.name(), g.kind(), g.members())).collect();
    assert_eq!(
        groups,
        [("Corners", GroupKind::Vertices, &[3, 0][..]), ("RequiredTriangles", GroupKind::Polygons, &[2][..]),]
    );
    let mut out = Vec::new();
    write(&model, &mut out).unwrap();
    let text = String::from_utf8(out).unwrap();
    assert!(text.contains("Corners\n2\n4\n1\n") && text.contains("RequiredTriangles\n1\n2\n"), "{text}");
}

#[test]
fn quadratic_elements_are_read_by_their_corners() {
    let text = "MeshVersionFormatted 2\nDimension 2\nVertices 6\n0 0 0\n1 0 0\n2 0 0\n1 1 0\n0 2 0\n0 1 0\n\
                TrianglesP2 1\n1 3 5 2 4 6 7\nEnd";
    let model = read(text.as_bytes()).unwrap();
    assert_eq!((model.vertex_count(), model.polygons().list(0)), (3, &[0, 1, 2][..]));
    assert_eq!(model.positions().as_flat(), [0.0, 0.0, 2.0, 0.0, 0.0, 2.0]);
    assert!(model.remarks()[0].message.contains("1 elements of higher order"));
}

/// A binary file of this version: one triangle with the reference 5 and a section that is not known.
fn binary(version: i32, big: bool) -> Vec<u8> {
    let mut bytes = Vec::new();
    let int32 =
        |bytes: &mut Vec<u8>, x: i32| bytes.extend(if big { x.to_be_bytes() } else { x.to_le_bytes() });
    let int64 =
        |bytes: &mut Vec<u8>, x: i64| bytes.extend(if big { x.to_be_bytes() } else { x.to_le_bytes() });
    let integer =
        |bytes: &mut Vec<u8>, x: i32| if version == 4 { int64(bytes, x.into()) } else { int32(bytes, x) };
    let float = |bytes: &mut Vec<u8>, x: f32| {
        if version == 1 {
            int32(bytes, x.to_bits() as i32);
        } else {
            int64(bytes, f64::from(x).to_bits() as i64);
        }
    };
    let section = |bytes: &mut Vec<u8>, code: i32, write: &dyn Fn(&mut Vec<u8>)| {
        int32(bytes, code);
        let mut body = Vec::new();
        write(&mut body);
        let next = bytes.len() + if version > 2 { 8 } else { 4 } + body.len();
        if version > 2 {
            int64(bytes, next as i64);
        } else {
            int32(bytes, next as i32);
        }
        bytes.extend(body);
    };
    int32(&mut bytes, 1);
    int32(&mut bytes, version);
    section(&mut bytes, 3, &|body| int32(body, 2));
    section(&mut bytes, 4, &|body| {
        integer(body, 3);
        for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.5, 2.0)] {
            float(body, x);
            float(body, y);
            integer(body, 0);
        }
    });
    section(&mut bytes, 200, &|body| body.extend(b"whatever"));
    section(&mut bytes, 6, &|body| {
        for number in [1, 3, 2, 1, 5] {
            integer(body, number);
        }
    });
    int32(&mut bytes, 54);
    bytes
}

#[test]
fn binary_files_of_all_versions_are_read() {
    for version in 1..=4 {
        for big in [false, true] {
            let bytes = binary(version, big);
            let model = read(&bytes[..]).unwrap();
            assert_eq!(model.positions().as_flat(), [0.0, 0.0, 1.0, 0.0, 0.5, 2.0]);
            assert_eq!(model.polygons().list(0), [2, 1, 0]);
            assert_eq!((model.groups()[0].name(), model.groups()[0].members()), ("5", &[0][..]));
            for cut in 0..bytes.len() {
                assert!(read(&bytes[..cut]).is_err(), "cut at {cut}");
            }
        }
    }
}

/// A text that is cut anywhere is refused, or read with the remark that it has no end.
#[test]
fn a_cut_text_is_never_taken_for_a_whole_one() {
    let text = "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra 1\n1 2 3 4 0\nHexahedra 0\nEnd\n";
    for cut in 0..text.len() {
        let read = read(&text.as_bytes()[..cut]);
        let is_said =
            |model: &Model| model.remarks().iter().any(|remark| remark.code == RemarkCode::MissingEnd);
        match read {
            Ok(model) => {
                assert_eq!(is_said(&model), cut + 1 < text.len(), "cut at {cut}: {:?}", model.remarks());
            }
            Err(error) => assert!(cut + 1 < text.len(), "cut at {cut}: {error}"),
        }
    }
    let cut = &text[..text.find("dra 0").unwrap()];
    let error = read(cut.as_bytes()).unwrap_err().to_string();
    assert!(error.contains("may be Hexahedra"), "{error}");
}

#[test]
fn unknown_sections_are_named_and_surplus_rows_refused() {
    let of = |section: &str, count: usize| {
        format!(
            "MeshVersionFormatted 2\nDimension 2\nVertices {count}\n0 0 0\n1 0 0\n0 1 0\n{section}\nEnd\n"
        )
    };
    let model = read(of("Normals 1\n0 0 1\nWhatever\n1", 3).as_bytes()).unwrap();
    let remark = &model.remarks()[0];
    assert_eq!((remark.code, remark.count, remark.places[1].line), (RemarkCode::UnknownSection, 2, Some(9)));
    assert!(remark.message.contains("\"Normals\", \"Whatever\""), "{}", remark.message);
    let error = read(of("", 2).as_bytes()).unwrap_err().to_string();
    assert!(error.contains("stands where a keyword should") && error.contains("count"), "{error}");
}

proptest! {
    #[test]
    fn what_is_written_reads_back(model in (2..=3usize).prop_flat_map(|dimension| meshes(Limits {
        dimension, largest_polygon: 4, longest_line: 2, points: false, groups: true,
    }))) {
        let mut out = Vec::new();
        write(&model, &mut out).unwrap();
        prop_assert_eq!(read(&out[..]).unwrap(), model);
    }
}
