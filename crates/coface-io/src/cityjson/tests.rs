//! Cities, good and bad.

use super::{is_cityjson, read};
use crate::{Format, GroupKind, GroupRole, Model, ReadOptions, RemarkCode, read_with as read_any};
use coface_algebra::ErrorKind;

/// The sides of a box on vertices `first` to `first + 7`, as surfaces that run counterclockwise seen from outside, or
/// from inside.
fn sides(first: u32, inside: bool) -> String {
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let side = |side: &[u32; 4]| {
        let mut corners = side.map(|corner| first + corner);
        if inside {
            corners.reverse();
        }
        format!("[{corners:?}]")
    };
    sides.iter().map(side).collect::<Vec<_>>().join(",")
}

/// The vertices of a cube from one corner on.
fn cube(low: i32, side: i32) -> String {
    let corner = |corner: i32| {
        let at = |axis: i32| low + (corner >> axis & 1) * side;
        format!("[{},{},{}]", at(0), at(1), at(2))
    };
    (0..8).map(corner).collect::<Vec<_>>().join(",")
}

fn city(version: &str, objects: &str, vertices: &str) -> String {
    format!(
        "{{\"type\":\"CityJSON\",\"version\":\"{version}\",\"transform\":{{\"scale\":[0.1,0.1,0.1],\"translate\":[7.7,0,0]}},\
         \"CityObjects\":{{{objects}}},\"vertices\":[{vertices}]}}"
    )
}

fn object(id: &str, geometry: &str) -> String {
    format!("\"{id}\":{{\"type\":\"Building\",\"geometry\":[{geometry}]}}")
}

fn geometry(kind: &str, lod: &str, boundaries: &str) -> String {
    format!("{{\"type\":\"{kind}\",\"lod\":{lod},\"boundaries\":{boundaries}}}")
}

fn counts(model: &Model) -> (usize, usize) {
    (model.vertex_count(), model.polygons().len())
}

#[test]
fn solids_of_all_kinds_are_their_surfaces() {
    let hollow = format!("[[{}],[{}]]", sides(0, false), sides(8, true));
    let vertices = format!("{},{}", cube(0, 30), cube(10, 10));
    for (kind, boundaries) in [
        ("Solid", hollow.clone()),
        ("MultiSolid", format!("[{hollow}]")),
        ("CompositeSolid", format!("[[[{}]],[[{}]]]", sides(0, false), sides(8, true))),
        ("MultiSurface", format!("[{},{}]", sides(0, false), sides(8, true))),
        ("CompositeSurface", format!("[{},{}]", sides(0, false), sides(8, true))),
    ] {
        for (version, lod) in [("1.0", "2"), ("1.1", "\"2.2\""), ("2.0", "\"2.2\"")] {
            let text = city(version, &object("house", &geometry(kind, lod, &boundaries)), &vertices);
            let model = read(text.as_bytes()).unwrap();
            assert_eq!(counts(&model), (16, 12), "{kind}");
            assert_eq!(model.positions().as_flat()[..3], [7.7, 0.0, 0.0]);
            assert_eq!(model.positions().as_flat()[3], 10.7, "30 tenths behind 7.7");
            assert!(model.remarks().is_empty());
            assert_eq!(model.groups().len(), 1);
            assert_eq!((model.groups()[0].name(), model.groups()[0].members().len()), ("house", 12));
        }
    }
}

#[test]
fn the_highest_level_is_read_or_the_one_asked_for() {
    let low = geometry("MultiSurface", "\"0\"", "[[[0,1,2]]]");
    let surface = geometry("MultiSurface", "\"2\"", "[[[0,1,3]],[[0,2,3]]]");
    let solid = geometry("Solid", "\"2\"", &format!("[[{}]]", sides(0, false)));
    let other = geometry("MultiSurface", "\"1.3\"", "[[[4,5,6]]]");
    let objects = format!("{},{}", object("a", &format!("{low},{surface},{solid}")), object("b", &other));
    let text = city("2.0", &objects, &cube(0, 10));
    let model = read(text.as_bytes()).unwrap();
    assert_eq!(counts(&model), (8, 7), "the solid of a, and b");
    let at = |lod: f64| read_any(text.as_bytes(), &ReadOptions::new().lod(lod));
    let lowest = at(0.0).unwrap();
    assert_eq!(counts(&lowest), (3, 1), "vertices that nothing has are left out");
    assert_eq!(lowest.remarks()[0].message, "1 objects have no geometry of the level of detail 0");
    let error = at(3.0).unwrap_err().to_string();
    assert!(error.contains("level of detail 3") && error.contains("0, 1.3, 2"), "{error}");
}

#[test]
fn semantics_are_groups_and_attributes_are_features() {
    let semantics =
        "{\"surfaces\":[{\"type\":\"WallSurface\"},{\"type\":\"RoofSurface\"}],\"values\":[[1,0,null,0]]}";
    let solid = format!(
        "{{\"type\":\"Solid\",\"lod\":\"2\",\"boundaries\":[[{}]],\"semantics\":{semantics}}}",
        sides(0, false)
    );
    let objects = format!(
        "\"h \\\"1\\\"\":{{\"type\":\"Building\",\"attributes\":{{\"roof\": \"flat\", \"floors\":2.50}},\"geometry\":[{solid}]}},\
         \"part\":{{\"type\":\"BuildingPart\"}}"
    );
    let model = read(city("2.0", &objects, &cube(0, 10)).as_bytes()).unwrap();
    let groups: Vec<(&str, Vec<u32>, bool)> = model
        .groups()
        .iter()
        .map(|group| (group.name(), group.members().to_vec(), group.has_role(GroupRole::Object)))
        .collect();
    assert_eq!(
        groups,
        [
            ("h \"1\"", (0..6).collect(), true),
            ("RoofSurface", vec![0], false),
            ("WallSurface", vec![1, 3], false)
        ]
    );
    assert!(model.groups()[1].has_role(GroupRole::Group));
    assert_eq!(model.features().len(), 2);
    assert_eq!(model.features().of_polygon(5), Some(0));
    assert_eq!(model.features().properties(0), "{\"type\":\"Building\",\"roof\":\"flat\",\"floors\":2.50}");
    assert_eq!(model.features().id(1), Some("\"part\""));
    model.check().unwrap();
    // Values that are null as a whole, and too few.
    for values in ["null", "[null]", "[[]]", "[]"] {
        let text = city("2.0", &objects.replace("[[1,0,null,0]]", values), &cube(0, 10));
        assert_eq!(read(text.as_bytes()).unwrap().groups().len(), 1, "{values}");
    }
}

#[test]
fn surfaces_with_holes_are_triangles_that_fill_them() {
    // A square with a hole, upright and turned; the hole runs as the outer ring does, which is wrong and mended.
    for corners in ["[[0,1,2,3],[4,7,6,5]]", "[[0,1,2,3],[4,5,6,7]]", "[[3,2,1,0],[4,5,6,7]]"] {
        for vertices in [
            "[0,0,5],[40,0,5],[40,40,5],[0,40,5],[10,10,5],[30,10,5],[30,30,5],[10,30,5]",
            "[5,0,0],[5,40,0],[5,40,40],[5,0,40],[5,10,10],[5,30,10],[5,30,30],[5,10,30]",
        ] {
            let text = city(
                "2.0",
                &object("o", &geometry("MultiSurface", "\"2\"", &format!("[{corners}]"))),
                vertices,
            );
            let model = read(text.as_bytes()).unwrap();
            assert_eq!(counts(&model), (8, 8));
            assert_eq!(model.remarks()[0].code, RemarkCode::FacesTriangulated);
            let point = |vertex: u32| {
                let at = 3 * vertex as usize;
                let flat = &model.positions().as_flat()[at..at + 3];
                [flat[0], flat[1], flat[2]]
            };
            let area = |corners: &[u32]| {
                let [a, b, c] = [0, 1, 2].map(|i| point(corners[i]));
                let [u, v] = [b, c].map(|p| [0, 1, 2].map(|i| p[i] - a[i]));
                let axis = if vertices.starts_with("[0") { 2 } else { 0 };
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                (u[i] * v[j] - u[j] * v[i]) / 2.0
            };
            let sum: f64 = model.polygons().iter().map(area).sum();
            let sign = if corners.starts_with("[[0") { 1.0 } else { -1.0 };
            assert!((sum - sign * 12.0).abs() < 1e-12, "{sum}");
        }
    }
}

#[test]
fn text_sequences_have_vertices_for_each_feature() {
    let head = city("2.0", "", "");
    let feature = |id: &str, low: i32| {
        let solid = geometry("Solid", "\"1\"", &format!("[[{}]]", sides(0, false)));
        format!(
            "{{\"type\":\"CityJSONFeature\",\"id\":\"{id}\",\"CityObjects\":{{{}}},\"vertices\":[{}]}}",
            object(id, &solid),
            cube(low, 10)
        )
    };
    let text = format!("{head}\n{}\n{}\n", feature("a", 0), feature("b", 50));
    let model = read(text.as_bytes()).unwrap();
    assert_eq!(counts(&model), (16, 12));
    assert_eq!(model.groups().iter().map(|group| group.name()).collect::<Vec<_>>(), ["a", "b"]);
    assert_eq!(model.positions().as_flat()[24], 12.7);
    let named = read_any(text.as_bytes(), &ReadOptions::new()).unwrap();
    assert_eq!(named.format(), Some(Format::CityJson));
}

#[test]
fn templates_are_placed_and_few_bytes_do_not_place_much() {
    let template = |count: usize| {
        let solid = geometry("Solid", "\"1\"", &format!("[[{}]]", sides(0, false)));
        let instances: Vec<String> = (0..count)
            .map(|i| {
                let matrix = "[-2,0,0,0, 0,2,0,0, 0,0,2,1, 0,0,0,1]";
                object(
                    &format!("tree {i}"),
                    &format!(
                        "{{\"type\":\"GeometryInstance\",\"template\":0,\"boundaries\":[0],\"transformationMatrix\":{matrix}}}"
                    ),
                )
            })
            .collect();
        let text = city("1.1", &instances.join(","), "[10,20,30]");
        let templates = format!(
            "\"geometry-templates\":{{\"templates\":[{solid}],\"vertices-templates\":[{}]}},\"CityObjects\"",
            cube(0, 1)
        );
        text.replacen("\"CityObjects\"", &templates, 1)
    };
    let model = read(template(2).as_bytes()).unwrap();
    assert_eq!(counts(&model), (16, 12));
    // Corners 0 and 2: the point (1, 2, 3), and one unit along y times 2.
    assert_eq!(model.positions().as_flat()[..6], [8.7, 2.0, 4.0, 8.7, 4.0, 4.0]);
    // The mirror turns the sides: the first one, the bottom, still runs clockwise seen from above.
    let first = coface_algebra::RaggedArray::from_lists(model.polygons().iter().take(6));
    let volume = coface_geometry::enclosed_volume(model.positions(), &first).unwrap();
    assert!((volume - 8.0).abs() < 1e-9, "{volume}");
    let bad = |from: &str, to: &str, says: &str| {
        let error = read(template(1).replace(from, to).as_bytes()).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::InvalidInput);
        assert!(error.to_string().contains("object \"tree 0\", geometry 0 (GeometryInstance"), "{error}");
        assert!(error.to_string().contains(says), "{error}");
    };
    bad("\"template\":0", "\"template\":7", "template 7, but there are 1");
    bad("\"boundaries\":[0]", "\"boundaries\":[3]", "vertex 3, but there are 1 vertices");
    bad("0,0,0,1]", "0,0,1,1]", "16 numbers");
}

/// Holes that no triangles can leave out are left out themselves, and stay among the stated surfaces.
#[test]
fn holes_that_cross_are_stated_and_left_out() {
    let surfaces = "[[0,1,2,3],[4,5,6,7]],[[0,1,2,3],[4,5]],[[0,1,5]]";
    let vertices = "[0,0,5],[40,0,5],[40,40,5],[0,40,5],[30,10,5],[50,10,5],[50,30,5],[30,30,5]";
    let text =
        city("2.0", &object("o", &geometry("MultiSurface", "\"2\"", &format!("[{surfaces}]"))), vertices);
    let model = read(text.as_bytes()).unwrap();
    assert_eq!(model.polygons().iter().map(<[u32]>::len).collect::<Vec<_>>(), [4, 4, 3]);
    let remark = &model.remarks()[0];
    assert_eq!((remark.code, remark.count), (RemarkCode::DataLeftOut, 2));
    let stated = model.stated_surfaces().unwrap();
    let rings: Vec<usize> = (0..3).map(|face| stated.faces().rings_of_face(face).len()).collect();
    assert_eq!((rings, stated.polygon_of_face(2)), (vec![2, 2, 1], 2));
    // One primitive, whose faces have nothing to do with each other.
    assert_eq!(stated.faces().shell_of_face(), Some(&[0; 3][..]));
    // A hole that touches a side in a point is cut out.
    let touching = "[[0,1,2,3],[4,5,6,7]]";
    let vertices = "[0,0,5],[40,0,5],[40,40,5],[0,40,5],[0,20,5],[10,30,5],[20,20,5],[10,10,5]";
    let text =
        city("2.0", &object("o", &geometry("MultiSurface", "\"2\"", &format!("[{touching}]"))), vertices);
    let model = read(text.as_bytes()).unwrap();
    assert_eq!((model.polygons().len(), model.remarks()[0].code), (7, RemarkCode::FacesTriangulated));
    // Shells and solids are those of the file; another model has none.
    let shells = format!("[[[{}],[{}]],[[{}]]]", sides(0, false), sides(8, true), sides(16, false));
    let vertices = [cube(0, 90), cube(10, 20), cube(100, 10)].join(",");
    let model =
        read(city("2.0", &object("o", &geometry("MultiSolid", "\"2\"", &shells)), &vertices).as_bytes())
            .unwrap();
    let shell_of_face = model.stated_surfaces().unwrap().faces().shell_of_face().unwrap().to_vec();
    assert_eq!(shell_of_face, [[0; 6], [1; 6], [2; 6]].concat());
    assert!(model.into_parts().into_model().stated_surfaces().is_none());
}

#[test]
fn surfaces_of_two_points_collapse() {
    let text = city("2.0", &object("b1", &geometry("Solid", "\"2\"", "[[[[0,1]],[[0,1,2]]]]")), &cube(0, 10));
    let model = read(text.as_bytes()).unwrap();
    assert_eq!((model.polygons().len(), model.remarks()[0].code), (1, RemarkCode::CollapsedCell));
}

#[test]
fn faults_name_object_geometry_and_place() {
    let solid = |boundaries: &str| {
        city("2.0", &object("b1", &geometry("Solid", "\"2.2\"", boundaries)), &cube(0, 10))
    };
    for (text, says) in [
        (
            solid("[[[[0,1,2]],[[0,9,2]]]]"),
            "object \"b1\", geometry 0 (Solid, lod 2.2), shell 0, surface 1: vertex 9, but there are 8",
        ),
        (solid("[[[[0,1,2]]],[[[]]]]"), "shell 0, surface 0: ring 0 has no vertices"),
        (solid("[[[0,1,2]]]"), "geometry 0 (Solid, lod 2.2): its boundaries are not nested"),
        (solid("[]").replace("Solid", "Sphere"), "the type \"Sphere\" is no geometry"),
        (solid("[[[[0,1,2]]]]").replace("\"vertices\"", "\"points\""), "no \"vertices\""),
        (solid("[[[[0,1,-2]]]]"), "invalid type"),
        (solid("[[[[0,1,2]]]]").replace("[7.7,0,0]", "[7.7,0]"), "\"translate\" of the transform"),
        (solid("[[[[0,1,2]]]]").replace("\"CityJSON\"", "\"CityGML\""), "not \"CityJSON\""),
    ] {
        let text = text.replace("[[[[0,1,2]]],[[[]]]]", "[[[[]]],[[[0,1,2]]]]");
        let error = read(text.as_bytes()).unwrap_err().to_string();
        assert!(error.contains(says), "{error}\n{says}");
    }
    let deep = solid(&format!("{}0{}", "[".repeat(100), "]".repeat(100)));
    assert!(read(deep.as_bytes()).unwrap_err().to_string().contains("too deep"));
    let huge = solid("[[[[0,1,4294967295]]]]");
    assert!(read(huge.as_bytes()).unwrap_err().to_string().contains("but there are 8"));
    let cut = solid("[[[[0,1,2]]]]");
    assert!(read(&cut.as_bytes()[..cut.len() - 9]).unwrap_err().to_string().contains("cut short"));
}

#[test]
fn points_lines_and_an_empty_city_are_read() {
    let parts =
        [geometry("MultiPoint", "\"1\"", "[0,1]"), geometry("MultiLineString", "\"1\"", "[[2,3,4],[5,6]]")];
    let text = city("2.0", &object("o", &parts.join(",")), &cube(0, 10));
    let model = read(text.as_bytes()).unwrap();
    assert_eq!((model.points().len(), model.lines().len(), model.vertex_count()), (2, 2, 7));
    let empty = read(city("2.0", "", "").as_bytes()).unwrap();
    assert_eq!(counts(&empty), (0, 0));
}

#[test]
fn content_tells_cityjson_from_other_json() {
    assert!(is_cityjson(b"{\n \"type\" : \"CityJSON\", \"version\""));
    assert!(is_cityjson(b"{\"type\":\"CityJSONFeature\"}"));
    assert!(!is_cityjson(b"{\"type\":\"FeatureCollection\"}"));
    let text = city("1.1", &object("o", &geometry("MultiSurface", "\"2\"", "[[[0,1,2]]]")), &cube(0, 10));
    assert_eq!(Format::from_content(text.as_bytes(), true), Some(Format::CityJson));
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.city.json", "a.json", "a.cityjson", "a.city.jsonl", "a.geojson"] {
        let path = folder.path().join(name);
        std::fs::write(&path, &text).unwrap();
        let model = crate::read_path(&path, None).unwrap();
        assert_eq!((model.format(), model.remarks().len()), (Some(Format::CityJson), 0), "{name}");
        assert_eq!(model.groups()[0].kind(), GroupKind::Polygons);
    }
}
