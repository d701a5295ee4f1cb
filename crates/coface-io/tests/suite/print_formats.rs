//! 3MF and AMF, written and read again.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_io::{self as io, CellData, Format, Group, GroupKind, Model, RemarkCode};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::io::Read;

const FORMATS: [Format; 2] = [Format::ThreeMf, Format::Amf];

fn written(model: &Model, format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    io::write(model, &mut bytes, format).unwrap();
    bytes
}

/// The text of the model in a 3MF archive.
fn text_of(bytes: &[u8]) -> String {
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).unwrap();
    let names: Vec<&str> = archive.file_names().collect();
    assert_eq!(names.len(), 3, "{names:?}");
    for part in ["[Content_Types].xml", "_rels/.rels"] {
        assert!(archive.by_name(part).is_ok(), "{part}");
    }
    let mut text = String::new();
    archive.by_name("3D/3dmodel.model").unwrap().read_to_string(&mut text).unwrap();
    text
}

const TETRAHEDRON: &str =
    "v 0.1 1e-7 0\nv 1 0 0\nv 0 1e300 0\nv 0 0 -0.3333333333333333\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

#[test]
fn coordinates_are_kept_bit_for_bit() {
    let model = io::read(TETRAHEDRON.as_bytes(), Format::Obj).unwrap();
    for format in FORMATS {
        let bytes = written(&model, format);
        assert_eq!(bytes, written(&model, format), "the same model is the same file");
        assert_eq!(io::read_unknown(&bytes[..]).unwrap(), model, "{format:?}");
        assert!(io::losses(&model, format).is_empty());
    }
    let text = text_of(&written(&model, Format::ThreeMf));
    assert!(
        text.contains("unit=\"millimeter\"") && text.contains("<object id=\"2\" type=\"model\">"),
        "{text}"
    );
}

#[test]
fn parts_are_objects_of_the_names_of_their_groups() {
    // Two tetrahedra and two triangles that have an edge in common.
    let other = "g b&<c>\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 7 5 8\n";
    let sheet = "g left\nv 9 0 0\nv 9 1 0\nv 9 0 1\nv 9 -1 0\nf 9 10 11\ng right\nf 9 11 12\n";
    let text = format!("g a\n{TETRAHEDRON}{other}{sheet}");
    let model = io::read(text.as_bytes(), Format::Obj).unwrap();
    for format in FORMATS {
        let again = io::read(&written(&model, format)[..], format).unwrap();
        assert_eq!((again.positions(), again.polygons()), (model.positions(), model.polygons()));
        let groups: Vec<(&str, &[u32])> =
            again.groups().iter().map(|group| (group.name(), group.members())).collect();
        assert_eq!(groups, [("a", &[0, 1, 2, 3][..]), ("b&<c>", &[4, 5, 6, 7])], "{format:?}");
        // The sheet is one object, and is in two groups.
        let said = io::losses(&model, format);
        assert!(said.iter().any(|said| said.message.contains("no objects by themselves")), "{said:?}");
    }
    let text = text_of(&written(&model, Format::ThreeMf));
    assert_eq!(text.matches("type=\"model\"").count(), 2, "{text}");
    assert_eq!(text.matches("type=\"surface\"").count(), 1, "{text}");
    assert_eq!(text.matches("<item ").count(), 3);
}

#[test]
fn what_is_not_kept_is_told() {
    let text = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 9 9 9\nv 1 0 0\nf 1 2 3 4\nf 1 6 2\n";
    let square = io::read(text.as_bytes(), Format::Obj).unwrap();
    for format in FORMATS {
        let codes: Vec<(RemarkCode, u64)> =
            io::losses(&square, format).iter().map(|remark| (remark.code, remark.count)).collect();
        assert_eq!(codes, [(RemarkCode::FacesTriangulated, 1), (RemarkCode::FormatKeepsLess, 1)]);
        let again = io::read(&written(&square, format)[..], format).unwrap();
        assert_eq!((again.vertex_count(), again.polygons().len()), (5, 3));
        for text in ["v 0 0 0\nv 1 0 0\nl 1 2\n", "v 0 0 0\np 1\n", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"]
        {
            let other = io::read(text.as_bytes(), Format::Obj).unwrap();
            let mut bytes = Vec::new();
            let error = io::write(&other, &mut bytes, format).unwrap_err();
            assert!(bytes.is_empty(), "{error}");
        }
        let nothing = Model::default();
        assert!(io::read(&written(&nothing, format)[..], format).unwrap().is_empty());
    }
}

#[test]
fn colors_of_vertices_are_written() {
    let model = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj).unwrap();
    let colors = [("red", [255, 0, 255]), ("green", [0, 10, 0]), ("blue", [0, 255, 0])];
    let model = colors.into_iter().fold(model, |model, (name, bytes)| {
        model.with_data(CellData::bytes(name, GroupKind::Vertices, 1, bytes.to_vec()).unwrap()).unwrap()
    });
    let text = text_of(&written(&model, Format::ThreeMf));
    let colors = "<m:color color=\"#000AFF\"/>\n<m:color color=\"#FF0000\"/>";
    assert!(text.contains(colors) && text.contains("p1=\"1\" p2=\"0\" p3=\"1\""), "{text}");
    let text = String::from_utf8(written(&model, Format::Amf)).unwrap();
    assert_eq!(text.matches("<color><r>1</r><g>0</g><b>0</b></color>").count(), 2, "{text}");
}

/// The triangles by the positions of their corners, each with the groups that it is in.
fn described(model: &Model) -> Vec<([[u64; 3]; 3], Vec<String>)> {
    let place = |vertex: u32| -> [u64; 3] {
        std::array::from_fn(|axis| model.positions().as_flat()[3 * vertex as usize + axis].to_bits())
    };
    let mut groups: BTreeMap<u32, Vec<String>> = BTreeMap::new();
    for group in model.groups() {
        group
            .members()
            .iter()
            .for_each(|&member| groups.entry(member).or_default().push(group.name().to_owned()));
    }
    let mut all: Vec<_> = (0..model.polygons().len())
        .map(|i| {
            let list = model.polygons().list(i);
            ([0, 1, 2].map(|corner| place(list[corner])), groups.remove(&(i as u32)).unwrap_or_default())
        })
        .collect();
    all.sort();
    all
}

proptest! {
    /// Disjoint pieces of two triangles each, in groups one by one: every triangle comes back, in its group.
    #[test]
    fn pieces_come_back(corners in prop::collection::vec(prop::array::uniform12(-1e9..1e9f64), 1..12), of in prop::collection::vec(0..4usize, 12)) {
        let mut text = String::new();
        for (i, corners) in corners.iter().enumerate() {
            for point in corners.chunks(3) {
                text += &format!("v {:?} {:?} {:?}\n", point[0], point[1], point[2]);
            }
            let first = 4 * i + 1;
            text += &format!("f {first} {} {}\nf {} {} {}\n", first + 1, first + 2, first + 1, first + 3, first + 2);
        }
        let mut model = io::read(text.as_bytes(), Format::Obj).unwrap();
        for label in 0..3 {
            let members: Vec<u32> = (0..corners.len()).filter(|&i| of[i] == label).flat_map(|i| [2 * i as u32, 2 * i as u32 + 1]).collect();
            if !members.is_empty() {
                model = model.with_group(Group::new(format!("g{label}"), GroupKind::Polygons, members)).unwrap();
            }
        }
        for format in FORMATS {
            prop_assert!(io::losses(&model, format).is_empty());
            let again = io::read(&written(&model, format)[..], format).unwrap();
            prop_assert_eq!(described(&again), described(&model));
            prop_assert_eq!(again.vertex_count(), model.vertex_count());
        }
    }
}
