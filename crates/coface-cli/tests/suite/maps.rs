//! What maps expect: reference systems, heights and well-known binary are kept; lines are lines.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::coface_in;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// A file of this name with this text in a folder.
fn file(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path
}

/// What the program answers in a folder, without what stands on standard error.
fn answer(folder: &Path, line: &str) -> Value {
    let words: Vec<&str> = line.split(' ').chain(["--json", "--quiet"]).collect();
    coface_in(folder, &words).json()
}

fn codes(answer: &Value) -> Vec<&str> {
    answer["remarks"].as_array().unwrap().iter().map(|remark| remark["code"].as_str().unwrap()).collect()
}

const LOW: &str = "SRID=25832;POLYGON Z ((0 0 1, 4 0 1, 4 4 3, 0 4 3, 0 0 1))\n";
const HIGH: &str = "POLYGON Z ((2 2 10, 6 2 10, 6 6 10, 2 6 10, 2 2 10))\n";

#[test]
fn systems_and_heights_go_through_all_formats_of_maps() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    file(folder, "low.wkt", LOW);
    file(folder, "high.wkt", HIGH);
    let both = answer(folder, "boolean intersection low.wkt high.wkt -o both.wkt");
    assert_eq!((codes(&both), both["measure"].as_f64()), (vec!["reference-assumed"], Some(4.0)));
    let expected = "SRID=25832;POLYGON Z ((2 2 10, 4 2 6, 4 4 3, 2 4 6.5, 2 2 10))\n";
    assert_eq!(std::fs::read_to_string(folder.join("both.wkt")).unwrap(), expected);
    // Around: each format is input again and says the same.
    let mut last = "both.wkt".to_owned();
    for name in ["a.geojson", "b.wkb", "c.hex", "d.wkt", "e.geojson", "f.hex", "g.wkb"] {
        for verb in ["convert", "boolean union", "arrange"] {
            let value = answer(folder, &format!("{verb} {last} -o {name}"));
            // A feature of GeoJSON that becomes a geometry loses its properties, and nothing else.
            let lost = value["remarks"].as_array().unwrap();
            let is_of_features = verb == "convert" && last.ends_with("geojson");
            assert_eq!(lost.len(), usize::from(is_of_features), "{verb} {last} {name}: {lost:?}");
            assert!(lost.iter().all(|remark| remark["message"].as_str().unwrap().contains("properties")));
            answer(folder, &format!("convert {name} -o back.wkt"));
            assert_eq!(std::fs::read_to_string(folder.join("back.wkt")).unwrap(), expected, "{verb} {name}");
        }
        last = name.to_owned();
    }
    let crs = r#""crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}}"#;
    assert!(std::fs::read_to_string(folder.join("e.geojson")).unwrap().contains(crs));
    // What does not keep them says so.
    for name in ["x.svg", "x.obj", "x.lines", "x.json"] {
        assert_eq!(codes(&answer(folder, &format!("arrange both.wkt -o {name}"))), ["format-keeps-less"; 2]);
    }
    assert_eq!(codes(&answer(folder, "convert both.wkt -o x.obj")).len(), 2, "data and the system");
    // Without heights.
    assert_eq!(
        codes(&answer(folder, "boolean union both.wkt --dimension 2 -o flat.wkt")),
        ["heights-left-out"]
    );
    let flat = std::fs::read_to_string(folder.join("flat.wkt")).unwrap();
    assert_eq!(flat, "SRID=25832;POLYGON ((2 2, 4 2, 4 4, 2 4, 2 2))\n");
    // What is empty is an empty polygon in its system.
    for (name, bytes) in
        [("o.wkt", &b"SRID=25832;POLYGON EMPTY\n"[..]), ("o.hex", b"0103000020E864000000000000\n")]
    {
        answer(folder, &format!("boolean difference both.wkt both.wkt -o {name}"));
        assert_eq!(std::fs::read(folder.join(name)).unwrap(), bytes);
    }
}

#[test]
fn different_systems_are_refused_with_both_names() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    file(folder, "low.wkt", LOW);
    let map = r#"{"type":"Polygon","crs":{"type":"name","properties":{"name":"EPSG:4326"}},"coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}"#;
    file(folder, "map.geojson", map);
    for verb in [&["boolean", "union"][..], &["arrange"]] {
        let words = [verb, &["low.wkt", "map.geojson", "-o", "out.wkt"]].concat();
        let run = coface_in(folder, &words);
        let message = run.fails_with(1);
        for part in ["low.wkt is in SRID 25832", "map.geojson is in SRID 4326", "ogr2ogr -t_srs EPSG:25832"] {
            assert!(message.contains(part), "{message}");
        }
        assert!(!folder.join("out.wkt").exists());
    }
    file(folder, "mixed.wkt", "SRID=1;POINT (1 2)\nSRID=2;POINT (1 2)\n");
    assert!(coface_in(folder, &["info", "mixed.wkt"]).fails_with(1).contains("mixed.wkt:2"));
    file(folder, "none.wkt", HIGH);
    let strict = coface_in(folder, &["boolean", "union", "low.wkt", "none.wkt", "--strict"]);
    assert!(strict.fails_with(1).contains("none.wkt names no reference system"));
}

#[test]
fn lines_of_maps_bound_nothing_unless_closed_ones_are_rings() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let square = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\n";
    file(folder, "square.wkt", square);
    file(folder, "ring.wkt", "LINESTRING (1 1, 2 1, 2 2, 1 2, 1 1)\n");
    file(folder, "open.wkt", "LINESTRING (1 1, 2 1, 2 2)\n");
    file(folder, "ring.lines", "1,1,2,1\n2,1,2,2\n2,2,1,1\n");
    // One treatment: in a file of their own or beside polygons.
    file(folder, "beside.wkt", &format!("{square}LINESTRING (1 1, 2 1, 2 2)\n"));
    for line in ["difference square.wkt open.wkt", "difference square.wkt ring.wkt", "union beside.wkt"] {
        let value = answer(folder, &format!("boolean {line}"));
        assert_eq!(
            (value["measure"].as_f64(), codes(&value)),
            (Some(16.0), vec!["unbounded-segments"]),
            "{line}"
        );
    }
    assert_eq!(answer(folder, "boolean difference square.wkt ring.wkt --close")["measure"], json!(15.0));
    for name in ["ring.wkt", "open.wkt"] {
        assert!(coface_in(folder, &["boolean", "union", name]).fails_with(1).contains("lines bound nothing"));
        assert_eq!(answer(folder, &format!("arrange {name}"))["regions"].as_array().unwrap().len(), 1);
    }
    assert_eq!(answer(folder, "arrange ring.wkt")["inside"], json!([[]]));
    assert_eq!(answer(folder, "arrange ring.wkt --close")["inside"], json!([[0]]));
    // A file of segments can hold nothing else, and is decided by parity; a rule that says otherwise does not apply.
    let parity = answer(folder, "boolean difference square.wkt ring.lines");
    assert_eq!((parity["measure"].as_f64(), codes(&parity)), (Some(15.5), vec![]));
    let ruled = answer(folder, "boolean difference square.wkt ring.lines --rule positive");
    assert_eq!((ruled["measure"].as_f64(), codes(&ruled)), (Some(15.5), vec!["drawing-assumption"]));
    // Rings that are closed so follow the rule.
    file(folder, "bow.wkt", "LINESTRING (0 0, 2 2, 2 0, 0 2, 0 0)\n");
    assert_eq!(answer(folder, "boolean union bow.wkt --close --rule evenodd")["measure"], json!(2.0));
    assert_eq!(answer(folder, "boolean union bow.wkt --close --rule positive")["measure"], json!(1.0));
}

/// Features of a map, each a square with properties.
fn lots(lots: &[(i32, &str)]) -> String {
    let lot = |(x, properties): &(i32, &str)| {
        let right = x + 1;
        format!(
            "{{\"type\":\"Feature\",\"properties\":{properties},\"geometry\":{{\"type\":\"Polygon\",\"coordinates\":\
             [[[{x},0],[{right},0],[{right},1],[{x},1],[{x},0]]]}}}}"
        )
    };
    let features: Vec<String> = lots.iter().map(lot).collect();
    format!("{{\"type\":\"FeatureCollection\",\"features\":[{}]}}", features.join(","))
}

#[test]
fn tables_with_a_column_of_geometries_are_maps() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let square = |x: i32| format!("\"POLYGON(({x} 0,{0} 0,{0} 1,{x} 1,{x} 0))\"", x + 1);
    let table = format!("id,owner,geom\n1,\"A, B\",{}\n2,C,{}\n3,C,\n", square(0), square(1));
    file(folder, "lots.csv", &table);
    let info = answer(folder, "info lots.csv");
    assert_eq!(info["polygons"]["count"], 2);
    assert_eq!(codes(&info), ["format-by-content", "data-left-out"]);
    let once = answer(folder, "boolean union lots.csv --dissolve owner -o out.geojson");
    let values: Vec<&Value> =
        once["groups"].as_array().unwrap().iter().map(|group| &group["values"][0]).collect();
    assert_eq!(values, ["A, B", "C"]);
    let run = coface_in(folder, &["info", "lots.csv", "--format", "points"]);
    run.fails_with(1);
}

#[test]
fn features_are_dissolved_by_a_property() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let of_a = r#"{"owner":"A","use":"wood"}"#;
    file(folder, "a.geojson", &lots(&[(0, of_a), (1, of_a), (2, r#"{"owner":"B"}"#), (5, of_a)]));
    file(folder, "b.geojson", &lots(&[(6, of_a), (9, r#"{"use":"road"}"#)]));
    let once = answer(folder, "boolean union a.geojson b.geojson --dissolve owner -o out.geojson");
    assert_eq!(codes(&once), ["property-missing"]);
    let groups = |answer: &Value| -> Vec<Value> {
        let groups = answer["groups"].as_array().unwrap().iter();
        groups.map(|group| json!([group["values"][0], group["measure"], group["polygons"]])).collect()
    };
    let expected = [json!(["A", 4.0, 2]), json!(["B", 1.0, 1]), json!([null, 1.0, 1])];
    assert_eq!(groups(&once), expected);
    let written: Value =
        serde_json::from_str(&std::fs::read_to_string(folder.join("out.geojson")).unwrap()).unwrap();
    let features = written["features"].as_array().unwrap();
    assert_eq!(features[0]["properties"], json!({"owner": "A", "features": 4, "area": 4, "use": "wood"}));
    assert_eq!(features[0]["geometry"]["type"], "MultiPolygon");
    // Read back, it is the same.
    let twice = answer(folder, "boolean union out.geojson --dissolve owner -o again.geojson");
    assert_eq!(groups(&twice), expected);
    assert_eq!(answer(folder, "info out.geojson")["polygons"]["valid"], true);
    // Formats without properties say what they lose.
    let lost = answer(folder, "boolean union out.geojson --dissolve owner -o out.wkt");
    assert_eq!(codes(&lost), ["property-missing", "format-keeps-less"]);
    assert_eq!(std::fs::read_to_string(folder.join("out.wkt")).unwrap().lines().count(), 3);
    for (line, status, says) in [
        ("boolean union a.geojson --dissolve lot", 1, "\"owner\", \"use\""),
        ("boolean xor a.geojson --dissolve owner", 2, "union"),
        ("boolean union a.geojson --dissolve owner --keep-walls", 2, "--keep-walls"),
    ] {
        let words: Vec<&str> = line.split(' ').chain(["-o", "not.geojson"]).collect();
        let run = coface_in(folder, &words);
        assert_eq!(run.status, status, "{line}");
        assert!(run.stderr.contains(says), "{line}: {}", run.stderr);
        assert!(!folder.join("not.geojson").exists());
    }
}

#[test]
fn faces_have_the_properties_of_all_inputs() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let wide = r#"{"type":"Feature","properties":{"use":"soil","ph":6.50},"geometry":{"type":"Polygon","coordinates":[[[0,0],[3,0],[3,1],[0,1],[0,0]]]}}"#;
    file(folder, "soil.geojson", wide);
    file(folder, "lots.geojson", &lots(&[(1, r#"{"use":"road","lot":7}"#), (5, r#"{"use":"wood"}"#)]));
    let found = answer(folder, "arrange soil.geojson lots.geojson --attributes faces.geojson");
    let columns: Vec<Value> =
        found["attributes"].as_array().unwrap().iter().map(|c| c["name"].clone()).collect();
    assert_eq!(columns, ["use_1", "ph", "use_2", "lot"]);
    let text = std::fs::read_to_string(folder.join("faces.geojson")).unwrap();
    let written: Value = serde_json::from_str(&text).unwrap();
    let mut rows: Vec<String> = written["features"]
        .as_array()
        .unwrap()
        .iter()
        .map(|feature| feature["properties"].to_string())
        .collect();
    rows.sort_unstable();
    // The lot cuts the soil into two rows of the same properties and one of both.
    assert_eq!(rows.len(), 4);
    assert_eq!(
        rows.iter()
            .filter(|row| row.contains(r#""use_2":"road""#) && row.contains(r#""use_1":"soil""#))
            .count(),
        1
    );
    assert!(text.contains("6.50"), "digits stay: {text}");
    // Read back, it is the same table.
    let again = answer(folder, "arrange faces.geojson --attributes again.geojson");
    assert_eq!(again["measures"], found["measures"]);
    assert_eq!(std::fs::read_to_string(folder.join("again.geojson")).unwrap(), text);
    assert_eq!(answer(folder, "info faces.geojson")["polygons"]["valid"], true);
    // By one of its columns the faces are the lots again.
    let lots = answer(folder, "boolean union faces.geojson --dissolve lot");
    let groups: Vec<&Value> =
        lots["groups"].as_array().unwrap().iter().map(|group| &group["measure"]).collect();
    assert_eq!(groups, [&json!(1.0), &json!(3.0)]);
}

#[test]
fn systems_are_named_by_info_and_left_out_by_yin_with_a_remark() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    file(folder, "low.wkt", LOW);
    let info = answer(folder, "info low.wkt");
    assert_eq!(
        (info["kind"].as_str(), info["reference_system"]["srid"].as_u64()),
        (Some("planar"), Some(25832))
    );
    assert!(coface_in(folder, &["info", "low.wkt"]).stdout.contains("SRID 25832"));
    file(folder, "flat.wkt", "SRID=25832;POLYGON ((0 0, 4 0, 4 4, 0 0))\n");
    for line in ["yin info flat.wkt", "yin join flat.wkt flat.wkt -o out.wkt"] {
        let found = answer(folder, line).to_string();
        assert!(
            found.contains("sets of the plane keep no reference system: SRID 25832 is left out"),
            "{line}: {found}"
        );
    }
    // An upright wall has no area seen from above.
    file(folder, "wall.wkt", "POLYGON Z ((0 0 0, 1 0 0, 1 0 1, 0 0 1, 0 0 0))\n");
    for verb in ["arrange", "boolean union"] {
        let found = answer(folder, &format!("{verb} wall.wkt"));
        assert_eq!(codes(&found), ["unbounded-segments"], "{verb}");
    }
}

#[test]
fn polygons_are_repaired_by_convert_and_map() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    file(folder, "tie.wkt", "SRID=25832;POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))\n");
    let told = answer(folder, "info tie.wkt --repair");
    let repair = &told["repair"];
    let faults = &repair["faults"];
    assert_eq!(
        (repair["area"].as_f64(), faults[0]["name"].as_str()),
        (Some(2.0), Some("ring_crosses_itself"))
    );
    assert_eq!(faults[0]["places"][0]["point"], json!([1.0, 1.0]));
    let valid = "SRID=25832;MULTIPOLYGON (((0 0, 1 1, 0 2, 0 0)), ((1 1, 2 0, 2 2, 1 1)))\n";
    for line in [
        "convert tie.wkt --repair -o valid.wkt",
        "convert tie.wkt --repair linework -o valid.wkt",
        "map repair tie.wkt -o valid.wkt",
        "map repair tie.wkt --method linework -o valid.wkt",
    ] {
        let done = answer(folder, line);
        assert_eq!(codes(&done), ["invalid-polygon", "model-repaired"], "{line}");
        assert_eq!(std::fs::read_to_string(folder.join("valid.wkt")).unwrap(), valid, "{line}");
    }
    assert_eq!(answer(folder, "info valid.wkt")["polygons"]["valid"], json!(true));
    assert!(coface_in(folder, &["info", "tie.wkt", "--repair"]).stdout.contains("area changed"));
}

#[test]
fn map_keeps_features_and_writes_what_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let feature = |id: i32, x: i32| {
        format!(
            "{{\"type\":\"Feature\",\"id\":{id},\"properties\":{{\"lot\":{id}}},\"geometry\":{{\"type\":\"Polygon\",\
             \"coordinates\":[[[{x},0],[{},0],[{},2],[{x},2],[{x},0]]]}}}}",
            x + 2,
            x + 2
        )
    };
    let text =
        format!("{{\"type\":\"FeatureCollection\",\"features\":[{},{}]}}", feature(7, 0), feature(8, 2));
    file(folder, "lots.geojson", &text);
    let wide = answer(folder, "map buffer lots.geojson --distance 1 --joins mitre -o wide.geojson");
    assert_eq!((wide["measure"].as_f64(), wide["counts"]["features"].as_u64()), (Some(32.0), Some(2)));
    let written = std::fs::read_to_string(folder.join("wide.geojson")).unwrap();
    assert!(written.contains(r#""id":7,"properties":{"lot":7}"#), "{written}");
    let overlap = answer(folder, "map coverage wide.geojson -o edges.wkt");
    assert_eq!((overlap["coverage"]["valid"].as_bool(), codes(&overlap).len()), (Some(false), 3));
    assert!(answer(folder, "map coverage lots.geojson")["coverage"]["valid"].as_bool().unwrap());
    let inner = answer(folder, "map buffer lots.geojson --distance -0.5");
    assert_eq!(inner["measure"].as_f64(), Some(2.0));
    let clipped = answer(folder, "map clip lots.geojson --box 0,0,1,1 -o clip.wkt");
    assert_eq!(codes(&clipped), ["cells-left-out", "format-keeps-less"]);
    assert_eq!(
        std::fs::read_to_string(folder.join("clip.wkt")).unwrap(),
        "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n"
    );
    let faces = answer(folder, "map polygonize lots.geojson");
    assert_eq!((faces["counts"]["polygons"].as_u64(), faces["measure"].as_f64()), (Some(2), Some(8.0)));
    assert_eq!(answer(folder, "map node lots.geojson")["counts"]["lines"].as_u64(), Some(3));
    let simpler = answer(folder, "map simplify lots.geojson --tolerance 0.1 -o lots.wkt");
    assert_eq!(simpler["simplification"]["vertices"].as_u64(), Some(6));
    for (line, status) in [
        ("map buffer lots.geojson", 2),
        ("map buffer lots.geojson --distance 1 --error 0", 1),
        ("map clip lots.geojson --box 1,1,0,0", 1),
        ("map clip lots.geojson --box 1,1,0", 2),
        ("map simplify lots.geojson --tolerance -1", 2),
        ("map melt lots.geojson", 2),
    ] {
        let words: Vec<&str> = line.split(' ').collect();
        coface_in(folder, &words).fails_with(status);
    }
}

#[test]
fn compound_paths_of_drawings_are_polygons_of_what_they_fill() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    // A head beside shoulders with a hole, as an icon has them in one path.
    let path = "M4 0H6V2H4Z M0 4H10V9H0Z M1 5V8H9V5Z";
    let text = format!("<svg xmlns='http://www.w3.org/2000/svg'><path d='{path}'/></svg>");
    file(folder, "icon.svg", &text);
    for format in ["wkt", "wkb", "hex", "geojson"] {
        let made = answer(folder, &format!("convert icon.svg -o icon.{format}"));
        assert!(codes(&made).contains(&"model-repaired"), "{made}");
        let united = answer(folder, &format!("boolean union icon.{format}"));
        assert_eq!((united["measure"].as_f64(), codes(&united).len()), (Some(30.0), 0), "{united}");
    }
    let text = std::fs::read_to_string(folder.join("icon.wkt")).unwrap();
    assert!(text.starts_with("MULTIPOLYGON (((") && text.lines().count() == 1, "{text}");
    for line in [
        "map repair icon.svg",
        "map clip icon.svg --box 0,0,10,10",
        "map simplify icon.svg --tolerance 0.001",
    ] {
        assert_eq!(answer(folder, line)["measure"], json!(30.0), "{line}");
    }
    // A set with two components is two polygons, not a polygon with a hole outside of it.
    let two = r#"{"order":2,"curves":[{"points":[[0,0],[2,0],[2,2]]},{"points":[[5,0],[9,0],[9,2]]}]}"#;
    file(folder, "two.json", two);
    answer(folder, "convert two.json -o two.wkt");
    answer(folder, "yin join two.json -o joined.wkb");
    for name in ["two.wkt", "joined.wkb"] {
        assert_eq!(answer(folder, &format!("boolean union {name}"))["measure"], json!(6.0), "{name}");
    }
}
