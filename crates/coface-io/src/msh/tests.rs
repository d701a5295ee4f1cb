use super::{Version, read, write};
use crate::samples::{Limits, meshes};
use crate::{Group, GroupKind};
use proptest::prelude::*;

const NODES_2: &str =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n5 0 1 0\n9 0 0 1\n$EndNodes\n";

fn fault(text: &str) -> String {
    read(text.as_bytes()).unwrap_err().to_string()
}

#[test]
fn faults_are_placed() {
    for (elements, message) in [
        ("1\n1 4 2 0 1 1 2 5 6\n", "line 13: an element names node 6, which is not among the nodes"),
        ("1\n1 99 2 0 1 1 2 5 2\n", "line 13: elements of type 99 are not known here"),
        ("1\n1 4 -2 0 1 1 2 5 2\n", "the count of tags is -2; it cannot be negative"),
        ("9999999999999\n1 4 2 0 1 1 2 5 9\n", "line 14: \"$EndElements\" is not an integer"),
        ("1\n1 4 2 0 1 1 2 5 9\n2 4 2 0 1 1 2 5 9\n", "line 14: \"2\" stands where $EndElements should"),
    ] {
        let text = fault(&format!("{NODES_2}$Elements\n{elements}$EndElements\n"));
        assert!(text.contains(message), "{text}");
    }
    for (text, message) in [
        (NODES_2, "without the section $Elements"),
        ("$NOD\n", "the count of nodes"),
        ("$MeshFormat\n3 0 8\n$EndMeshFormat\n", "version 3"),
        ("$MeshFormat\n4.1 1 8\n", "the file ends inside the number 1"),
        ("$Nodes\n1\n", "$MeshFormat is missing"),
        (
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n3 0 0 0\n3 0 0 1\n$EndNodes\n",
            "node 3 stands twice",
        ),
        ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n-1 0 0 0\n$EndNodes\n", "a node has the tag -1"),
        (
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 info 0\n$EndNodes\n",
            "line 6: \"info\" is not a number",
        ),
        ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\nhello\n", "\"hello\" stands where a section should begin"),
    ] {
        let text = fault(text);
        assert!(text.contains(message), "{text}");
    }
}

#[test]
fn sparse_tags_are_mapped_in_order() {
    let text = NODES_2.replace("\n9 ", "\n9000000000000 ");
    let model =
        read(format!("{text}$Elements\n1\n7 4 0 9000000000000 5 2 1\n$EndElements\n").as_bytes()).unwrap();
    assert_eq!(model.cells().list(0), [3, 2, 1, 0]);
    let model = read(format!("{NODES_2}$Elements\n1\n7 4 0 9 5 2 1\n$EndElements\n").as_bytes()).unwrap();
    assert_eq!(model.cells().list(0), [3, 2, 1, 0]);
    assert!(model.groups().is_empty());
}

#[test]
fn other_sections_are_passed_over() {
    let data = "$Periodic\n1\n0 1 2\n$EndPeriodic\n$NodeData\n1\n\"x\"\n$EndNodeData\n";
    let elements = "$Elements\n1\n7 15 1 3 5\n$EndElements\n";
    let model = read(format!("{NODES_2}{data}{elements}{data}").as_bytes()).unwrap();
    assert_eq!(model.points().len(), 1);
    assert_eq!(model.groups(), [Group::new("3", GroupKind::Vertices, vec![2])]);
}

#[test]
fn quadratic_elements_are_read_by_their_corners() {
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 1 0 0\n5 1 1 0\n6 0 1 0\n\
                $EndNodes\n$Elements\n1\n1 9 2 1 1 1 2 3 4 5 6\n$EndElements\n";
    let model = read(text.as_bytes()).unwrap();
    assert_eq!((model.vertex_count(), model.polygons().list(0)), (3, &[0, 1, 2][..]));
    assert!(model.remarks()[0].message.contains("1 elements of higher order"));
}

/// One triangle on nodes 4, 5, 6 in the group 7, in the binary form of a version.
fn binary(version: &str, big: bool) -> Vec<u8> {
    let int = |x: i32| if big { x.to_be_bytes() } else { x.to_le_bytes() };
    let size = |x: u64| if big { x.to_be_bytes() } else { x.to_le_bytes() };
    let double = |x: f64| size(x.to_bits());
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5]];
    let mut bytes = format!("$MeshFormat\n{version} 1 8\n").into_bytes();
    bytes.extend(int(1));
    bytes.extend(b"\n$EndMeshFormat\n");
    match version {
        "2.2" => {
            bytes.extend(b"$Nodes\n3\n");
            for (tag, point) in (4..).zip(points) {
                bytes.extend(int(tag));
                bytes.extend(point.into_iter().flat_map(double));
            }
            bytes.extend(b"\n$EndNodes\n$Elements\n1\n");
            bytes.extend([2, 1, 2, 1, 7, 3, 4, 5, 6].into_iter().flat_map(int));
        }
        "4.0" => {
            bytes.extend(b"$Entities\n");
            bytes.extend([0, 0, 1, 0].into_iter().flat_map(size));
            bytes.extend(int(3));
            bytes.extend([0.0; 6].into_iter().flat_map(double));
            bytes.extend(size(1));
            bytes.extend(int(7));
            bytes.extend(size(0));
            bytes.extend(b"\n$EndEntities\n$Nodes\n");
            bytes.extend([1, 3].into_iter().flat_map(size));
            bytes.extend([3, 2, 0].into_iter().flat_map(int));
            bytes.extend(size(3));
            for (tag, point) in (4..).zip(points) {
                bytes.extend(int(tag));
                bytes.extend(point.into_iter().flat_map(double));
            }
            bytes.extend(b"\n$EndNodes\n$Elements\n");
            bytes.extend([1, 1].into_iter().flat_map(size));
            bytes.extend([3, 2, 2].into_iter().flat_map(int));
            bytes.extend(size(1));
            bytes.extend([1, 4, 5, 6].into_iter().flat_map(int));
        }
        _ => {
            bytes.extend(b"$Entities\n");
            bytes.extend([0, 0, 1, 0].into_iter().flat_map(size));
            bytes.extend(int(3));
            bytes.extend([0.0; 6].into_iter().flat_map(double));
            bytes.extend(size(1));
            bytes.extend(int(7));
            bytes.extend(size(1));
            bytes.extend(int(-9));
            bytes.extend(b"\n$EndEntities\n$Nodes\n");
            bytes.extend([1, 3, 4, 6].into_iter().flat_map(size));
            // Parametric: two parameters behind each point.
            bytes.extend([2, 3, 1].into_iter().flat_map(int));
            bytes.extend([3, 4, 5, 6].into_iter().flat_map(size));
            for point in points {
                bytes.extend(point.into_iter().chain([0.25, 0.75]).flat_map(double));
            }
            bytes.extend(b"\n$EndNodes\n$Elements\n");
            bytes.extend([1, 1, 1, 1].into_iter().flat_map(size));
            bytes.extend([2, 3, 2].into_iter().flat_map(int));
            bytes.extend([1, 1, 4, 5, 6].into_iter().flat_map(size));
        }
    }
    bytes.extend(b"\n$EndElements\n");
    bytes
}

#[test]
fn binary_files_of_all_versions_are_read() {
    for version in ["2.2", "4.0", "4.1"] {
        for big in [false, true] {
            let bytes = binary(version, big);
            let model = read(&bytes[..]).unwrap();
            assert_eq!(
                model.positions().as_flat(),
                [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.5],
                "{version}"
            );
            assert_eq!(model.polygons().list(0), [0, 1, 2]);
            assert_eq!(model.groups(), [Group::new("7", GroupKind::Polygons, vec![0])]);
            for cut in 0..bytes.len() - 1 {
                // What is missing is said.
                let is_told = read(&bytes[..cut]).map_or(true, |model| {
                    model.remarks().iter().any(|remark| remark.code == crate::RemarkCode::MissingEnd)
                });
                assert!(is_told, "{version} cut at {cut}");
            }
        }
    }
}

#[test]
fn names_and_shared_members_survive_version_4() {
    let text =
        format!("{NODES_2}$Elements\n3\n1 2 2 0 1 1 2 5\n2 2 2 0 1 1 2 9\n3 4 2 0 1 1 2 5 9\n$EndElements\n");
    let mut model = read(text.as_bytes()).unwrap();
    model.groups = vec![
        Group::new("left \"wing\"", GroupKind::Polygons, vec![0, 1]),
        Group::new("upper", GroupKind::Polygons, vec![1]),
        Group::new("nothing", GroupKind::Cells, vec![]),
    ];
    let mut out = Vec::new();
    write(&model, &mut out, Version::FourOne).unwrap();
    let back = read(&out[..]).unwrap();
    model.groups[0] = Group::new("left 'wing'", GroupKind::Polygons, vec![0, 1]);
    assert_eq!(back, model);
    out.clear();
    write(&model, &mut out, Version::TwoTwo).unwrap();
    assert_eq!(read(&out[..]).unwrap().groups()[1].members(), [0u32; 0]);
}

proptest! {
    #[test]
    fn what_is_written_reads_back(model in meshes(Limits {
        dimension: 3, largest_polygon: 4, longest_line: 2, points: true, groups: true,
    })) {
        for version in [Version::TwoTwo, Version::FourOne] {
            let mut out = Vec::new();
            write(&model, &mut out, version).unwrap();
            let mut back = read(&out[..]).unwrap();
            // Vertices of groups have become points.
            let mut expected = model.clone();
            let written = expected.points.len();
            prop_assert_eq!(&back.points[..written], &expected.points[..]);
            let grouped = expected.groups.iter().filter(|g| g.kind() == GroupKind::Vertices);
            let count: usize = grouped.map(|g| g.members().iter().filter(|&&m| !expected.points.iter().any(|p| p.to_u32() == m)).count()).sum();
            prop_assert_eq!(back.points.len(), written + count);
            back.points.clear();
            expected.points.clear();
            // A vertex that stands twice among the points is twice in its group; the order is that of the points.
            for model in [&mut back, &mut expected] {
                for group in &mut model.groups {
                    group.members.sort_unstable();
                    group.members.dedup();
                }
            }
            prop_assert_eq!(back, expected);
        }
    }
}

/// Found by fuzzing: a count of string tags beyond the end of the file was counted to its end, which takes 10^18 steps.
#[test]
fn counts_of_tags_beyond_the_file_end_with_it() {
    let elements = "$Elements\n1\n1 4 2 0 1 1 2 5 9\n$EndElements\n";
    let text = format!(
        "{NODES_2}{elements}$ElementData\n9223372036854775807\n\"x\"\n1\n0\n3\n0\n1\n1\n1 4\n$EndElementData\n"
    );
    let remarks = read(text.as_bytes()).unwrap().remarks().to_vec();
    assert!(remarks[0].message.contains("the file ends after 9 of"), "{}", remarks[0].message);
    // Tags that lie as far apart as numbers can.
    let elements = "$Elements\n1\n-9223372036854775808 4 2 0 1 1 2 5 9\n$EndElements\n";
    let text = format!(
        "{NODES_2}{elements}$ElementData\n1\n\"x\"\n1\n0\n3\n0\n1\n1\n9223372036854775807 4\n$EndElementData\n"
    );
    let remarks = read(text.as_bytes()).unwrap().remarks().to_vec();
    assert_eq!(remarks[0].code, crate::RemarkCode::DataLeftOut);
}

#[test]
fn small_faults_of_programs_are_read_over() {
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n-1 4 \"nothing\"\n2 7 \"lid\"\n$EndPhysicalNames\n$Nodes\n3\n\
                0 0 0 0\n1 1 0 0\n2 0 1 0\n$EndNodes\n$Elements\n1\n1 2 2 7 1 0 1 2\n$EndElements\n\
                $ElementData\n1\n\"x\"\n1\n0\n3\n0\n1\n1\n1 5\n$EndElememtData\n";
    let model = read(text.as_bytes()).unwrap();
    assert_eq!(model.polygons().list(0), [0, 1, 2]);
    assert_eq!((model.groups().len(), model.groups()[0].name()), (1, "lid"));
    assert_eq!(model.data()[0].real_row(0), [5.0]);
    let messages: Vec<&str> = model.remarks().iter().map(|remark| &remark.message[..]).collect();
    assert_eq!(
        messages,
        [
            "the name of group 4 is of dimension -1, which no element has: it is left out",
            "the section $ElementData ends with \"$EndElememtData\", which is taken for its end"
        ]
    );
}
