//! Write then read gives the same model, and no bytes make a reader of surfaces panic: OFF, OBJ, PLY, STL.

use super::samples::with_data;
use super::{CellData, Format, Group, GroupKind, GroupRole, Model, ReadOptions, obj, off, ply, stl};
use coface_algebra::RaggedArray;
use coface_algebra::{Error, VertexId};
use coface_geometry::Positions;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

/// Finite numbers of all sizes, and those that people write.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
        (-9..9i8).prop_map(|x| f64::from(x) / 4.0)
    ]
}

/// Lists of distinct vertices with lengths in this range.
fn lists(vertices: usize, shortest: usize, longest: usize) -> BoxedStrategy<RaggedArray> {
    if vertices < shortest {
        return Just(RaggedArray::new()).boxed();
    }
    let all: Vec<u32> = (0..vertices as u32).collect();
    let list = proptest::sample::subsequence(all, shortest..=longest.min(vertices)).prop_shuffle();
    vec(list, 0..6).prop_map(|lists| RaggedArray::from_lists(&lists)).boxed()
}

/// Models of polygons, lines of at most `longest_line` vertices and points, with groups of polygons.
fn models(dimension: usize, longest_line: usize) -> impl Strategy<Value = Model> {
    (0..9usize).prop_flat_map(move |vertex_count| {
        let points = if vertex_count == 0 { 0..1 } else { 0..3 };
        let points = vec(0..vertex_count.max(1), points);
        (
            vec(coordinate(), dimension * vertex_count),
            lists(vertex_count, 3, 7),
            lists(vertex_count, 2, longest_line),
            points,
            vec((vec(any::<bool>(), 6), select(&ROLES[..])), 0..4),
        )
            .prop_map(move |(coordinates, polygons, lines, points, groups)| {
                let members = |group: &[bool]| -> Vec<u32> {
                    (0..polygons.len() as u32).filter(|&polygon| group[polygon as usize]).collect()
                };
                let groups = groups
                    .iter()
                    .enumerate()
                    .map(|(i, (group, role))| {
                        let blank = if *role == GroupRole::Group { "" } else { " " };
                        let name = format!("part{blank}{}", 3 - i);
                        Group::new(name, GroupKind::Polygons, members(group)).with_role(*role)
                    })
                    .collect();
                let model = Model {
                    vertex_count,
                    positions: Positions::from_flat(dimension, coordinates).unwrap(),
                    lines,
                    points: points.into_iter().map(VertexId::new).collect(),
                    groups,
                    polygons,
                    ..Model::default()
                };
                model.check().unwrap();
                model
            })
    })
}

const ROLES: [GroupRole; 3] = [GroupRole::Group, GroupRole::Object, GroupRole::Material];

/// The groups as OBJ gives them back: what shares a polygon with an object before it is no object but a group, with a name of one word.
fn groups_in_obj(model: &Model) -> Vec<Group> {
    let mut taken = [Vec::new(), Vec::new()];
    let kept = |group: &Group| {
        let Some(role) =
            [GroupRole::Object, GroupRole::Material].iter().position(|&role| group.has_role(role))
        else {
            return group.clone();
        };
        if group.members().iter().any(|polygon| taken[role].contains(polygon)) {
            return Group::new(group.name().replace(' ', "_"), GroupKind::Polygons, group.members().to_vec());
        }
        taken[role].extend_from_slice(group.members());
        group.clone()
    };
    model.groups.iter().map(kept).collect()
}

/// The model without its groups.
fn without_groups(model: &Model) -> Model {
    Model { groups: Vec::new(), ..model.clone() }
}

/// What PLY has data on.
const IN_PLY: &[GroupKind] = &[GroupKind::Vertices, GroupKind::Polygons, GroupKind::Lines];

/// Equal to the last bit: `-0.0` is not `0.0`.
fn bits(model: &Model) -> Vec<u64> {
    model.positions.as_flat().iter().map(|x| x.to_bits()).collect()
}

fn written(write: impl FnOnce(&mut Vec<u8>) -> Result<(), Error>) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(&mut bytes).unwrap();
    bytes
}

const PLY_ENCODINGS: [ply::Encoding; 3] =
    [ply::Encoding::Ascii, ply::Encoding::LittleEndian, ply::Encoding::BigEndian];
const STL_ENCODINGS: [stl::Encoding; 2] = [stl::Encoding::Ascii, stl::Encoding::Binary];

/// All readers on the same bytes. What they accept is sound and no larger than the bytes.
fn read_all(bytes: &[u8]) {
    for model in
        [off::read(bytes), obj::read(bytes), ply::read(bytes), stl::read(bytes)].into_iter().flatten()
    {
        model.check().unwrap();
        assert!(model.vertex_count <= bytes.len() && model.polygons.item_count() <= 3 * bytes.len());
    }
}

proptest! {
    #[test]
    fn off_keeps_models(model in (1..6usize).prop_flat_map(|dimension| models(dimension, 2))) {
        let bytes = written(|out| off::write(&model, out));
        let read = off::read(&bytes[..]).unwrap();
        prop_assert_eq!(bits(&read), bits(&model));
        prop_assert_eq!(read, without_groups(&model));
    }

    #[test]
    fn obj_keeps_models(model in models(3, 6)) {
        let bytes = written(|out| obj::write(&model, out));
        let read = obj::read(&bytes[..]).unwrap();
        prop_assert_eq!(bits(&read), bits(&model));
        prop_assert_eq!(read, Model { groups: groups_in_obj(&model), ..model });
    }

    #[test]
    fn ply_keeps_models_and_data(model in with_data((1..4usize).prop_flat_map(|dimension| models(dimension, 2)), IN_PLY), encoding in proptest::sample::select(&PLY_ENCODINGS[..])) {
        let bytes = written(|out| ply::write(&model, out, encoding));
        let read = ply::read(&bytes[..]).unwrap();
        prop_assert_eq!(bits(&read), bits(&model));
        prop_assert_eq!(read, without_groups(&model));
    }

    #[test]
    fn stl_keeps_triangles(corners in vec([-3..3i8, -3..3i8, 0..2i8], 0..30), scale in 1e-30..1e30f32, encoding in proptest::sample::select(&STL_ENCODINGS[..])) {
        let coordinates: Vec<f64> = corners.iter().flatten().map(|&x| f64::from(f32::from(x) * scale)).collect();
        // What is in no triangle has no place in STL.
        let coordinates = coordinates[..corners.len() / 3 * 9].to_vec();
        let soup: Vec<u32> = (0..(corners.len() / 3 * 3) as u32).collect();
        let soup = RaggedArray::uniform(3, soup).unwrap();
        let model = Model::from_polygons(Positions::from_flat(3, coordinates).unwrap(), soup).unwrap();
        // The corners come back, welded and without triangles that repeat one.
        let once = stl::read(&written(|out| stl::write(&model, out, encoding))[..]).unwrap();
        let points = |model: &Model| -> Vec<Vec<u64>> {
            let point = |&v: &u32| model.positions.point(VertexId::from_u32(v)).iter().map(|x| (x + 0.0).to_bits());
            let triangles = model.polygons.iter().map(|polygon| polygon.iter().flat_map(point).collect());
            triangles.filter(|t: &Vec<u64>| t[..3] != t[3..6] && t[3..6] != t[6..] && t[6..] != t[..3]).collect()
        };
        prop_assert_eq!(points(&once), points(&model));
        // What has been welded stays as it is, but for vertices of triangles that were left out.
        if once.remarks.is_empty() && !once.polygons.is_empty() {
            let twice = stl::read(&written(|out| stl::write(&once, out, encoding))[..]).unwrap();
            prop_assert_eq!(twice, once);
        }
    }

    #[test]
    fn any_bytes_are_survived(bytes in vec(any::<u8>(), 0..200)) {
        read_all(&bytes);
    }

    #[test]
    fn broken_files_are_survived(model in with_data(models(3, 2), IN_PLY), format in 0..6usize, edits in vec((0..4u8, any::<u16>(), any::<u8>()), 1..5)) {
        let mut bytes = match format {
            0 => written(|out| off::write(&model, out)),
            1 => written(|out| obj::write(&model, out)),
            2..5 => written(|out| ply::write(&model, out, PLY_ENCODINGS[format - 2])),
            _ => b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n".to_vec(),
        };
        for (kind, place, byte) in edits {
            let at = usize::from(place) % (bytes.len() + 1);
            match kind {
                0 => bytes.insert(at, byte),
                1 if at < bytes.len() => bytes[at] = byte,
                2 if at < bytes.len() => drop(bytes.drain(at..bytes.len().min(at + usize::from(byte)))),
                _ => bytes.truncate(at.max(20)),
            }
        }
        read_all(&bytes);
    }
}

#[test]
fn a_vertical_tab_is_no_blank() {
    read_all(b"\x0b");
    assert!(fault(obj::read(&b"\x0b\n"[..])).contains("not an OBJ statement"));
}

/// What strict reading refuses.
fn strict(bytes: &[u8], format: Format) -> String {
    fault(crate::read_with(bytes, &ReadOptions::new().format(format).strict(true)))
}

fn fault<T: std::fmt::Debug>(result: Result<T, Error>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn off_in_unusual_dress() {
    let read = |text: &str| off::read(text.as_bytes());
    let model =
        read("STCN4nOFF # all of it\n1\n2 2\n# edges follow\n7\n0 0 9 9 1 1 1 1 5 5\n1 2 0\n2 0 1\n1 1\n")
            .unwrap();
    assert_eq!((model.positions.dimension(), model.vertex_count), (2, 2));
    assert_eq!(model.positions.as_flat(), [0.0, 0.0, 1.0, 2.0]);
    assert_eq!((model.lines.list(0), model.points.as_slice()), (&[0, 1][..], &[VertexId::new(1)][..]));
    let model =
        read("COFF 3 1 0\n0 0 0 255 0 0 1\n1 0 0 0 1 0 1\n0 1 0\n\n3 0 1 2 0.5 0.5 x#\nmore\n").unwrap();
    assert_eq!(model.polygons.list(0), [0, 1, 2]);
    assert_eq!(model.remarks.len(), 1);
    // Without a blank behind the keyword, line by line and word by word.
    for (text, remarks) in
        [("OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 0), ("OFF3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2", 1)]
    {
        let model = read(text).unwrap();
        assert_eq!(
            (model.vertex_count, model.polygons.list(0), model.remarks.len()),
            (3, &[0, 1, 2][..], remarks)
        );
        let found = crate::read_unknown(text.as_bytes()).unwrap();
        assert_eq!(found.format(), Some(crate::Format::Off));
    }
    for text in ["OFF3x 1 0\n", "xOFF3 1 0\n", "OFF-3 1 0\n"] {
        assert!(read(text).is_err(), "{text}");
    }
}

#[test]
fn off_of_other_programs_in_binary() {
    let numbers = [3_i32, 1, 0].map(i32::to_le_bytes).concat();
    let points = [0f32, 0., 0., 1., 0., 0., 0., 1., 0.].map(f32::to_le_bytes).concat();
    let face = [3_i32, 0, 1, 2].map(i32::to_le_bytes).concat();
    let bytes = [&b"OFF BINARY\n"[..], &numbers, &points, &face].concat();
    let model = off::read(&bytes[..]).unwrap();
    assert_eq!((model.positions.as_flat()[3], model.polygons.list(0)), (1.0, &[0, 1, 2][..]));
    assert!(model.remarks[0].message.contains("no number of color components"));
    assert!(off::read(&[&bytes[..], &[7; 5]].concat()[..]).is_err());
    assert!(off::read(&bytes[..bytes.len() - 2]).is_err());
}

#[test]
fn off_faults_are_named() {
    let read = |text: &str| fault(off::read(text.as_bytes()));
    assert!(read("").contains("line 1: the file is empty"));
    assert!(read("OFF\n3 1\n").contains("promises 3 vertices, but the file ends after 0"));
    assert!(read("OFF\n4000000000 4000000000 0\n0 0 0\n").contains("promises 4000000000 vertices"));
    assert!(read("OFF\n5000000000 1 0\n").contains("limit"));
    assert!(read("OFF\n1 1 0\n0 0 0\n").contains("promises 1 faces, but the file ends after 0"));
    assert!(strict(b"OFF\n1 0 0\n0 nan 0\n", Format::Off).contains("on line 3"));
    assert!(read("OFF\n1 1 0\n0 none 0\n").starts_with("line 3: \"none\" is not a number"));
    assert!(read("OFF\n1 1 0\n0 0\n").starts_with("line 3: a vertex with 2 coordinates"));
    assert!(read("OFF\n1 1 0 0 0 0\n").starts_with("line 2: \"0\" stands behind the counts"));
    assert!(read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n").starts_with("line 6: a face names vertex 3"));
    assert!(
        read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n").starts_with("line 6: a face names vertex -1")
    );
    assert!(
        read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n").starts_with("line 6: a face of 4 vertices names")
    );
    assert!(read("solid x\n").contains("neither OFF nor a count"));
}

#[test]
fn off_in_binary() {
    let mut bytes = b"NOFF BINARY\n".to_vec();
    for number in [3i32, 1, 0] {
        bytes.extend(number.to_be_bytes());
    }
    for number in
        [0.0f32, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1.0]
    {
        bytes.extend(number.to_be_bytes());
    }
    for number in [3i32, 0, 1, 2, 1] {
        bytes.extend(number.to_be_bytes());
    }
    bytes.extend(0.25f32.to_be_bytes());
    let model = off::read(&bytes[..]).unwrap();
    assert_eq!(model.positions.as_flat(), [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.5, 0.0]);
    assert_eq!(model.polygons.list(0), [0, 1, 2]);
    let error = off::read(&bytes[..40]).unwrap_err();
    assert_eq!(error.byte(), Some(40), "{error}");
    assert!(error.to_string().contains("vertex 0 of the 3"), "{error}");
}

#[test]
fn obj_in_unusual_dress() {
    let text = "\u{feff}";
    assert!(fault(obj::read(text.as_bytes())).contains("not an OBJ statement"));
    let text = "# forward references and continued lines\nf 1 2 \\\r\n 3 # a comment\nmtllib x.mtl\n  v 0 0 0 1 0 0\n\
                v\t1 0\\\n 0\nv 0 1 0\nvn 0 0 1\nl 1 2 3 1\np -1 1\nf -3//1 -2//1 -1//1";
    let model = obj::read(text.as_bytes()).unwrap();
    assert_eq!(model.polygons, RaggedArray::from_lists([[0, 1, 2], [0, 1, 2]]));
    assert_eq!(model.lines.list(0), [0, 1, 2, 0]);
    assert_eq!(model.points, [VertexId::new(2), VertexId::new(0)]);
}

#[test]
fn obj_faults_are_named() {
    let read = |text: &str| fault(obj::read(text.as_bytes()));
    assert!(read("").starts_with("line 1: the file is empty"));
    assert!(read(" \n\n").starts_with("line 1: the file is empty"));
    assert!(read("v 0 0 0\nf 1 1 2\n").starts_with("line 2: vertex index 2, but there are 1"));
    assert!(read("v 0 0 0\nf 0 1 2\n").starts_with("line 2: vertex index 0; they are numbered from 1"));
    assert!(read("v 0 0 0\nf -1 -2 -3\n").starts_with("line 2: vertex index -2 counts back over the 1"));
    assert!(read("v 0 0 0\nf 2 3 1\nf 4 5 6\n\n").starts_with("line 2: vertex index 2, but there are 1"));
    assert!(read("v 0 0 0\nl\n").starts_with("line 2: a line with 0 vertices"));
    assert!(read("v 0 0 0\nf\n").starts_with("line 2: a face with 0 vertices"));
    assert!(read("v 0 0 0\np\n").starts_with("line 2: a point statement without"));
    assert!(read("v 0 0\n").starts_with("line 1: a vertex with 2 coordinates"));
    assert!(strict(b"\nv 0 inf 0\n", Format::Obj).contains("on line 2"));
    assert!(read("v 0 x 0\n").starts_with("line 1: \"x\" is not a number"));
    assert!(read("v 0 0 0\n\nf 1 2 3x\n").starts_with("line 3: \"3x\" is not an integer"));
    assert!(read("OFF\n3 1 0\n").starts_with("line 2: \"3\" is not an OBJ statement"));
    assert!(read("f 1 2 99999999999\n").contains("but there are 0 vertices"));
}

#[test]
fn the_line_of_a_fault_is_right_whatever_the_blocks() {
    let mut text = String::new();
    for i in 0..60_000 {
        text += &format!("v {i} 0 0\nv {i} 1 0\\\n\nv {i} 2 1.0000000000000000000001\nf -1 -2 -3\n");
    }
    let model = obj::read(text.as_bytes()).unwrap();
    assert_eq!((model.vertex_count, model.polygons.len()), (180_000, 60_000));
    assert_eq!(model.polygons.list(59_999), [179_999, 179_998, 179_997]);
    text += "\nf 1 2 180001\n";
    assert_eq!(obj::read(text.as_bytes()).unwrap_err().line(), Some(300_002));
    text += "v 0 0 0\nf 1 2 2\nf 1 1 0";
    assert_eq!(obj::read(text.as_bytes()).unwrap_err().line(), Some(300_005));
}

#[test]
fn ply_in_unusual_dress() {
    let text = "ply\nformat ascii 1.0\nelement edge 1\nproperty int vertex2\nproperty uchar quality\nproperty int vertex1\n\
                element camera 2\nproperty list int float view\nproperty float x\nelement tristrips 1\n\
                property list int int vertex_indices\nelement vertex 4\nproperty list uchar float weights\n\
                property short y\nproperty double x\nend_header\n1 nan 0\n2 0.5 nan 1\n0 7\n\
                9 0 1 2 3 -1 3 2 2 0\n0 5 6\n1 1 7 8\n2 1 1 -9 10\n0 11 12\nmore";
    let model = ply::read(text.as_bytes()).unwrap();
    assert_eq!(model.lines.list(0), [0, 1]);
    assert_eq!(model.polygons, RaggedArray::from_lists([[0, 1, 2], [2, 1, 3]]));
    assert_eq!(model.positions.as_flat(), [6.0, 5.0, 8.0, 7.0, 10.0, -9.0, 12.0, 11.0]);
    assert_eq!(model.remarks.len(), 1);
    // A text may say what it wants in a column of bytes.
    let [quality] = model.data() else { panic!("{:?}", model.data()) };
    assert_eq!(
        (quality.name(), quality.kind(), quality.real_row(0)[0].is_nan()),
        ("quality", GroupKind::Lines, true)
    );
}

#[test]
fn ply_properties_become_data() {
    let text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty uchar red\nproperty float n_0\n\
                property float n_1\nproperty double red\nelement tristrips 1\nproperty list int int vertex_indices\n\
                property int kind\nelement face 4\nproperty char sort\nproperty list uchar int vertex_indices\n\
                property uint m_0\nproperty list uchar int others\nend_header\n0 255 0.1 nan 7\n1 0 0.5 1 7\n2 3 0 0 7\n3 4 0 0 7\n3 0 1 2 5\n\
                -7 3 0 1 2 4000000000 0\n1 2 0 1 1 0\n2 1 0 1 2 9 9\n3 3 1 2 3 3 0\n";
    let model = ply::read(text.as_bytes()).unwrap();
    let data = |name: &str, kind| model.data_named(name, kind).unwrap();
    assert_eq!(data("red", GroupKind::Vertices).integer_row(0), Some(vec![255]));
    assert_eq!(data("n", GroupKind::Vertices).real_row(1), [0.5, 1.0]);
    assert!(data("n", GroupKind::Vertices).real_row(0)[1].is_nan());
    assert_eq!((model.polygons.len(), model.lines.len(), model.points.len()), (3, 1, 1));
    // The strip comes first and has no sort; the line and the point have none in the model.
    let sorts = (0..3).map(|i| data("sort", GroupKind::Polygons).integer_row(i).unwrap()[0]);
    assert_eq!(sorts.collect::<Vec<_>>(), [0, -7, 3]);
    assert_eq!(data("m_0", GroupKind::Polygons).integer_row(1), Some(vec![4_000_000_000]));
    assert_eq!(model.data().len(), 4);
    assert_eq!(
        model.remarks()[0].message,
        "there are two arrays \"red\" on vertices; the second is left out"
    );
    assert_eq!(model.remarks().len(), 1);
    let broken = text.replace("3 3 1 2 3 3 0", "3 3 1 2 3 x 0");
    let message = fault(ply::read(broken.as_bytes()));
    assert!(
        message.starts_with("line 26: \"x\" is not a number, as a property must be (face 3 of the 4"),
        "{message}"
    );
}

#[test]
fn ply_names_and_widths_are_kept_in_bounds() {
    let triangle = obj::read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\np 1\nl 1 2 3\n".as_bytes()).unwrap();
    let with = |name: &str, value: i64| {
        let data = CellData::integers(name, GroupKind::Polygons, 2, vec![1, value]).unwrap();
        let model = triangle.clone().with_data(data).unwrap();
        model.with_data(CellData::integers("x", GroupKind::Lines, 1, vec![8]).unwrap()).unwrap()
    };
    let names = with("two words", 3)
        .with_data(CellData::reals("x", GroupKind::Vertices, 1, vec![0.5; 3]).unwrap())
        .unwrap();
    for encoding in PLY_ENCODINGS {
        let bytes = written(|out| ply::write(&names, out, encoding));
        let read = ply::read(&bytes[..]).unwrap();
        assert_eq!(
            read.data_named("two_words", GroupKind::Polygons).unwrap().integer_row(0),
            Some(vec![1, 3])
        );
        assert_eq!(read.data_named("x_", GroupKind::Vertices).unwrap().real_row(2), [0.5]);
        assert_eq!(read.data_named("x", GroupKind::Lines).unwrap().len(), 2);
        assert_eq!(read.points, names.points);
    }
    let message = fault(ply::write(&with("a", 1 << 40), Vec::new(), ply::Encoding::Ascii));
    assert!(message.contains("integers of 32 bits") && message.ends_with("write VTK"), "{message}");
    let other = CellData::integers("a_1", GroupKind::Polygons, 1, vec![0]).unwrap();
    let message =
        fault(ply::write(&with("a", 1).with_data(other).unwrap(), Vec::new(), ply::Encoding::Ascii));
    assert!(message.contains("the name \"a_1\" in PLY"), "{message}");
}

#[test]
fn ply_faults_are_named() {
    let head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
                element face 1\nproperty list uchar int vertex_index\nend_header\n";
    let read = |body: &str| fault(ply::read(format!("{head}{body}").as_bytes()));
    let points = "0 0 0\n1 0 0\n0 1 0\n";
    assert!(read("").contains("the file ends where a coordinate should be (vertex 0 of the 3"));
    assert!(read("0 0 0\n0 none 0\n").starts_with("line 11: \"none\" is not a number"));
    let text = format!("{head}0 0 0\n0 nan 0\n0 1 0\n3 0 1 2\n");
    assert!(strict(text.as_bytes(), Format::Ply).contains("on line 11"));
    assert!(
        read(&format!("{points}3 0 1 3\n")).starts_with("line 13: vertex index 3, but there are 3 vertices")
    );
    assert!(read(&format!("{points}3 0 1 0.5\n")).starts_with("line 13: vertex index 0.5"));
    assert!(read(&format!("{points}-3 0 1\n")).starts_with("line 13: the length of a list is -3"));
    let lying = head.replace("ascii", "binary_little_endian").replace("vertex 3", "vertex 4294967295");
    let error = ply::read([lying.as_bytes(), &[0; 40]].concat().as_slice()).unwrap_err();
    assert!(error.to_string().contains("vertex 3 of the 4294967295 that the header promises"), "{error}");
    assert_eq!(error.byte(), Some(lying.len() as u64 + 40));
    let mut bytes = head.replace("ascii", "binary_big_endian").into_bytes();
    bytes.extend([0; 24]);
    bytes.extend(f32::INFINITY.to_be_bytes());
    bytes.extend([0; 8]);
    bytes.push(3);
    bytes.extend([0u32, 1, 2].iter().flat_map(|vertex| vertex.to_be_bytes()));
    assert_eq!(ply::read(&bytes[..]).unwrap().remarks[0].places[0].cell, Some(vec![2]));
    assert!(strict(&bytes, Format::Ply).contains("the first is v2"));
}

#[test]
fn stl_in_unusual_dress() {
    let facet = |x: i32| {
        format!(
            "FACET normal nan 0 0\n  Outer  LOOP\nvertex {x} 0 -0\nVertex 1e0 0 0\r\nvertex 0 1 0\nendloop\nendfacet\n"
        )
    };
    let text =
        format!("  SOLID one body\n{}{}endsolid\n\nsolid\n{}endsolid x\n", facet(0), facet(1), facet(2));
    let model = stl::read(text.as_bytes()).unwrap();
    assert_eq!(model.polygons, RaggedArray::from_lists([[0, 1, 2], [3, 1, 2]]));
    assert_eq!(model.groups, [Group::new("one body", GroupKind::Polygons, vec![0])]);
    assert!(model.remarks[0].message.starts_with("1 triangle repeats a vertex"), "{:?}", model.remarks);
    assert!(model.remarks[0].message.ends_with("left out: 1 (counted from 0)"), "{:?}", model.remarks);
    // A binary file whose header begins with the word of the text form.
    let mut bytes = b"solid but binary".to_vec();
    bytes.resize(80, b' ');
    bytes.extend(1u32.to_le_bytes());
    bytes.extend(
        [0f32, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].iter().flat_map(|x| x.to_le_bytes()),
    );
    bytes.extend([0; 2]);
    let model = stl::read(&bytes[..]).unwrap();
    assert_eq!((model.vertex_count, model.polygons.len(), model.remarks.len()), (3, 1, 0));
    assert!(fault(stl::read(&bytes[..130])).starts_with("at byte 130: the header promises 1 triangles"));
    bytes[84 + 16..84 + 20].copy_from_slice(&f32::NAN.to_le_bytes());
    assert_eq!(stl::read(&bytes[..]).unwrap().vertex_count, 3);
    assert!(strict(&bytes, Format::Stl).contains("not finite"));
}

#[test]
fn stl_faults_are_named() {
    let read = |text: &str| fault(stl::read(text.as_bytes()));
    assert!(read("").contains("the file is empty"));
    assert!(read("v 0 0 0\n").starts_with("line 1: the file begins with \"v 0 0 0\", not with solid"));
    assert!(read("solid x\nfacet normal 0 0 1\n").starts_with("line 2: the file ends where endfacet"));
    let facet = "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 1\n";
    assert!(read(&format!("{facet}vertex 0 0 0\n")).starts_with("line 7: a facet with more than three"));
    assert!(read(&format!("{facet}endloop x\n")).starts_with("line 7: the file ends where endfacet"));
    assert!(read(&format!("{facet}endfacet\n")).starts_with("line 7: \"endfacet\" where endloop should be"));
    let number = "solid\nfacet\nouter loop\nvertex 0 1e39x 0\n";
    assert!(read(number).starts_with("line 4: \"1e39x\" is not a number"));
    let large = "solid\nfacet\nouter loop\nvertex 0 1e39 0\nvertex 0 0 1\nvertex 0 1 1\nendloop\nendfacet\nendsolid\n";
    assert!(strict(large.as_bytes(), Format::Stl).contains("on line 4"));
    assert!(
        read("solid\nfacet\nouter loop\nvertex 0 1\n").starts_with("line 4: a vertex with 2 coordinates")
    );
}

#[test]
fn what_a_format_cannot_hold_is_refused() {
    let square = obj::read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1e300\nf 1 2 3 4\n".as_bytes()).unwrap();
    let to_stl = |model: &Model| fault(stl::write(model, Vec::new(), stl::Encoding::Ascii));
    assert!(to_stl(&square).contains("the coordinate 1e300 of v3 is too large"));
    let points = Model { polygons: RaggedArray::new(), ..square.clone() };
    assert_eq!(
        to_stl(&points),
        "STL holds triangles only, and the model has 4 vertices and no triangle; write OBJ, PLY or OFF, which keep polygons, lines and points"
    );
    let cell = Model {
        shapes: vec![coface_complexes::cell_mesh::CellShape::Tetrahedron],
        cells: RaggedArray::from_lists([[0, 1, 2, 3]]),
        ..square
    };
    for refused in [
        off::write(&cell, Vec::new()),
        obj::write(&cell, Vec::new()),
        ply::write(&cell, Vec::new(), ply::Encoding::Ascii),
        stl::write(&cell, Vec::new(), stl::Encoding::Binary),
    ] {
        let message = fault(refused);
        assert!(
            message.contains("cannot hold 3-cells") && message.contains("write MEDIT, MSH or VTK"),
            "{message}"
        );
    }
    let four = off::read("4OFF\n1 0 0\n0 0 0 1\n".as_bytes()).unwrap();
    assert!(fault(obj::write(&four, Vec::new())).contains("at most 3 coordinates"));
    let bare = Model { vertex_count: 2, ..Model::default() };
    assert!(fault(off::write(&bare, Vec::new())).contains("vertices without positions"));
}

#[test]
fn endless_files_are_refused() {
    for byte in [0u8, b' ', b'1'] {
        assert!(off::read(std::io::repeat(byte)).is_err());
        assert!(obj::read(std::io::repeat(byte)).is_err());
        assert!(ply::read(std::io::repeat(byte)).is_err());
    }
    assert!(stl::read(std::io::repeat(b' ')).is_err());
    // Zeros are a binary STL that promises nothing, and goes on.
    assert!(fault(stl::read(std::io::repeat(0))).starts_with("at byte 84: the header promises no triangle"));
}
