//! Tests of both directions.

use super::{read, write};
use crate::{CellData, Format, Group, GroupKind, Model, ReadOptions, RemarkCode, read_with, wkt};
use coface_algebra::RaggedArray;
use coface_algebra::{ErrorKind, VertexId};
use proptest::collection::vec;
use proptest::prelude::*;
use serde_json::{Value, json};

fn column(model: &Model, name: &str) -> Vec<i64> {
    let data = model.data_named(name, GroupKind::Lines).unwrap();
    (0..data.len()).flat_map(|i| data.integer_row(i).unwrap()).collect()
}

fn written(model: &Model) -> Vec<u8> {
    let mut out = Vec::new();
    write(model, &mut out).unwrap();
    let value: Value = serde_json::from_slice(&out).unwrap();
    assert_eq!(value["type"], "FeatureCollection");
    out
}

#[test]
fn a_collection_of_everything_is_read() {
    // The type stands behind what it says of, and foreign members are passed over.
    let text = r#"{"features": [
        {"geometry": {"coordinates": [[0, 0], [1, 0], [1, 0], [1, 1]], "type": "LineString"},
         "properties": {"Name": "ü \"way\"", "nested": {"name": [1]}}, "id": 3, "type": "Feature"},
        {"type": "Feature", "properties": null, "geometry": null},
        {"type": "Feature", "id": 17, "properties": {}, "geometry": {"type": "GeometryCollection", "geometries": [
            {"type": "Polygon", "coordinates": [[[0,0],[4,0],[0,4],[0,0]], [[1,1],[1,2],[2,1],[1,1]]]},
            {"type": "MultiPoint", "coordinates": [[1, 0], [8, 8]]},
            {"type": "GeometryCollection", "geometries": []},
            {"type": "MultiLineString", "coordinates": [[[8, 8], [9, 9]], []]}]}},
        {"type": "Feature", "properties": {}, "geometry": {"type": "MultiPolygon", "coordinates":
            [[[[5,5],[6,5],[5,6],[5,5]]], [[[5,5],[4,5],[5,4],[5,5]]]]}}
        ], "bbox": [0, 0, 9, 9], "type": "FeatureCollection"}"#;
    let model = read(text.as_bytes()).unwrap();
    model.check().unwrap();
    let expected: [&[u32]; 6] =
        [&[0, 1, 2], &[3, 4, 5, 3], &[6, 7, 8, 6], &[9, 10], &[11, 12, 13, 11], &[14, 15, 16, 14]];
    assert_eq!(*model.lines(), RaggedArray::from_lists(expected));
    assert_eq!(model.points(), [VertexId::new(1), VertexId::new(9)]);
    assert_eq!(column(&model, "polygon"), [-1, 0, 0, -1, 1, 2]);
    assert_eq!(column(&model, "ring"), [-1, 0, 1, -1, 0, 0]);
    let groups = [
        Group::new("17", GroupKind::Vertices, vec![1, 9]),
        Group::new("ü \"way\"", GroupKind::Lines, vec![0]),
        Group::new("17", GroupKind::Lines, vec![1, 2, 3]),
    ];
    assert_eq!(model.groups(), groups);
    assert!(model.remarks().is_empty());
    assert_eq!(read(&written(&model)[..]).unwrap(), model);
}

#[test]
fn geometries_alone_and_bare_rings_are_read() {
    let polygon = read(&br#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}"#[..]).unwrap();
    assert_eq!(read(&b"[[[0,0],[1,0],[0,1],[0,0]]]"[..]).unwrap(), polygon);
    assert_eq!(read(&b"[[[0,0],[1,0],[0,1]]]"[..]).unwrap(), polygon);
    assert_eq!(read(&b"[[[[0,0],[1,0],[0,1],[0,0]]]]"[..]).unwrap(), polygon);
    for empty in [
        r#"{"type":"Point","coordinates":[]}"#,
        r#"{"type":"MultiPolygon","coordinates":[[],[[]]]}"#,
        r#"{"type":"FeatureCollection","features":[]}"#,
        r#"{"type":"GeometryCollection","geometries":[]}"#,
    ] {
        let model = read(empty.as_bytes()).unwrap();
        assert_eq!((model.vertex_count(), model.data().len()), (0, 0), "{empty}");
        assert_eq!(read(&written(&model)[..]).unwrap(), model);
    }
}

#[test]
fn a_ring_that_is_not_closed_is_closed_with_a_remark() {
    let text = br#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,0],[0,1]]]}"#;
    let model = read(&text[..]).unwrap();
    assert_eq!(model.lines().list(0), [0, 1, 2, 0]);
    let remark = &model.remarks()[0];
    assert_eq!((remark.code, remark.count), (RemarkCode::UnclosedRing, 1));
    assert!(remark.message.contains("begins at (0, 0) but ends at (0, 1)"), "{}", remark.message);
    assert_eq!(remark.places[0].point.as_deref(), Some(&[0.0, 1.0][..]));
    let strict = ReadOptions::new().format(Format::GeoJson).strict(true);
    assert!(read_with(&text[..], &strict).is_err());
}

/// Two squares side by side that share an arc, as whole numbers with differences.
#[test]
fn a_topology_is_read_as_the_map_that_it_is() {
    let topology = r#"{"type": "Topology", "transform": {"scale": [0.5, 2], "translate": [10, -1]},
        "arcs": [[[2, 0], [0, 1]], [[2, 1], [-2, 0], [0, -1], [2, 0]], [[2, 0], [2, 0], [0, 1], [-2, 0]]],
        "objects": {"squares": {"type": "GeometryCollection", "geometries": [
            {"type": "Polygon", "arcs": [[0, 1]], "properties": {"name": "west"}},
            {"type": "Polygon", "arcs": [[2, -1]], "id": 7},
            {"type": null}]},
          "town": {"type": "Point", "coordinates": [1, 1]}}}"#;
    let map = r#"{"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"name": "west"}, "geometry": {"type": "Polygon", "coordinates":
            [[[11, -1], [11, 1], [10, 1], [10, -1], [11, -1]]]}},
        {"type": "Feature", "id": 7, "properties": {}, "geometry": {"type": "Polygon", "coordinates":
            [[[11, -1], [12, -1], [12, 1], [11, 1], [11, -1]]]}},
        {"type": "Feature", "properties": {}, "geometry": null},
        {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [10.5, 1]}}]}"#;
    let model = read(topology.as_bytes()).unwrap();
    assert_eq!(model, read(map.as_bytes()).unwrap());
    assert!(model.remarks().is_empty());
    assert!(super::reading::is_geojson(topology.as_bytes()));
}

/// The features of a file: type, id, properties and geometry of each as texts.
fn lines_of(written: &[u8]) -> Vec<String> {
    let text = String::from_utf8(written.to_vec()).unwrap();
    let lines = text.lines().filter(|line| line.starts_with("{\"type\":\"Feature\","));
    lines.map(|line| line.trim_end_matches(',').to_owned()).collect()
}

#[test]
fn features_are_written_with_the_properties_that_they_have() {
    let point = |x: u8| format!("\"geometry\":{{\"type\":\"Point\",\"coordinates\":[{x},0]}}}}");
    // Digits, the order of keys, nested values, escapes, nulls; names in any case; ids that are numbers and texts.
    let starts = [
        r#""properties":{"z":1.10,"a":[1,{"deep":null}],"long":123456789012345678901234567890,"n":-0.0,"":true},"#,
        r#""properties":{"NAME":"ü \u00fc \"q\" ","name":"second"},"#,
        r#""properties":{"name":"twice"},"#,
        r#""properties":{"name":"twice"},"#,
        r#""id":7,"properties":{"kind":"well"},"#,
        r#""id":"7","properties":{},"#,
        r#""properties":{},"#,
    ];
    let features =
        starts.iter().zip(0..).map(|(start, x)| format!("{{\"type\":\"Feature\",{start}{}", point(x)));
    let mut features: Vec<String> = features.collect();
    features.insert(2, r#"{"type":"Feature","properties":{"only":"a table"},"geometry":null}"#.to_owned());
    features.push(r#"{"type":"Feature","id":-1.50,"properties":{},"geometry":null}"#.to_owned());
    let text = format!("{{\"type\":\"FeatureCollection\",\"features\":[{}]}}", features.join(" ,\n\n"));
    let model = read(text.as_bytes()).unwrap();
    model.check().unwrap();
    assert_eq!((model.features().len(), model.points().len()), (9, 7));
    assert_eq!(lines_of(&written(&model)), features);
    // The second method: the parser of another crate.
    let [given, found] =
        [text.as_bytes(), &written(&model)].map(|text| serde_json::from_slice::<Value>(text).unwrap());
    assert_eq!(found, given);
    assert_eq!(read(&written(&model)[..]).unwrap(), model);
    // Spaces between parts go.
    let spaced = text.replace("\":", "\" :\t").replace(",\"", " , \"");
    assert_eq!(lines_of(&written(&read(spaced.as_bytes()).unwrap())), features);
}

#[test]
fn the_shapes_of_a_feature_stay_together() {
    let collection =
        r#"{"type":"Feature","properties":{"mixed":1},"geometry":{"type":"GeometryCollection","geometries":["#
            .to_owned()
            + r#"{"type":"MultiPolygon","coordinates":[[[[0,0],[4,0],[0,4],[0,0]],[[1,1],[1,2],[2,1],[1,1]]],"#
            + r#"[[[5,5],[6,5],[5,6],[5,5]]]]},{"type":"LineString","coordinates":[[8,8],[9,9]]},"#
            + r#"{"type":"MultiPoint","coordinates":[[8,8],[7,7]]}]}}"#;
    // Equal properties do not make one feature of two, and points at one place stay two.
    let point = r#"{"type":"Feature","properties":{"p":2},"geometry":{"type":"Point","coordinates":[7,7]}}"#;
    let features = [point.to_owned(), collection, point.to_owned(), point.to_owned()];
    let text = format!("{{\"type\":\"FeatureCollection\",\"features\":[{}]}}", features.join(","));
    let model = read(text.as_bytes()).unwrap();
    assert_eq!(lines_of(&written(&model)), features);
    let [lines, points] = [model.lines().len(), model.points().len()];
    let table = model.features();
    assert!((0..lines).all(|line| table.of_line(line) == Some(1)));
    assert!((0..points).map(|point| table.of_point(point).unwrap()).eq([0, 1, 1, 2, 3]));
}

#[test]
fn properties_go_where_their_lines_go() {
    let text = r#"{"type":"Feature","properties":{"a":1},"geometry":{"type":"LineString","coordinates":[[0,0],[1,0]]}}"#;
    let model = read(text.as_bytes()).unwrap();
    let lines = RaggedArray::from_lists([[1, 0]]);
    assert!(model.clone().with_lines(lines).unwrap().features().is_empty());
    assert!(model.clone().into_parts().into_model().features().is_empty());
    assert_ne!(read(text.replace('1', "2").as_bytes()).unwrap(), model);
    // A group that is added later names a feature that has no name.
    let model = model.with_group(Group::new("way", GroupKind::Lines, vec![0])).unwrap();
    assert!(lines_of(&written(&model))[0].contains(r#""properties":{"name":"way","a":1}"#));
    // Geometries that are no features have none, and are written last.
    let text = format!(
        "{{\"type\":\"FeatureCollection\",\"features\":[{{\"type\":\"Point\",\"coordinates\":[5,5]}},{text}]}}"
    );
    let model = read(text.as_bytes()).unwrap();
    assert_eq!((model.features().len(), model.features().of_point(0)), (1, None));
    let lines = lines_of(&written(&model));
    assert!(lines[0].contains(r#"{"a":1}"#) && lines[1].contains(r#""properties":{}"#), "{lines:?}");
}

#[test]
fn properties_of_a_topology_are_those_of_its_geometries() {
    let topology = r#"{"type": "Topology", "arcs": [[[0, 0], [1, 0], [0, 1], [0, 0]]], "objects": {
        "b": {"type": "Polygon", "arcs": [[0]], "properties": {"pop": 10.0, "name": "B", "list": [1, [2]]}},
        "a": {"type": "GeometryCollection", "geometries": [
            {"type": "LineString", "arcs": [0], "id": "x", "properties": {"w": null}},
            {"type": "Point", "coordinates": [3, 3], "properties": []},
            {"type": "GeometryCollection", "properties": {"inner": true}, "geometries": [
                {"type": "Point", "coordinates": [4, 4], "properties": {"lost": 1}}]}]}}}"#;
    let model = read(topology.as_bytes()).unwrap();
    let table = model.features();
    let properties: Vec<&str> = (0..table.len()).map(|feature| table.properties(feature)).collect();
    // Objects come in the order of their names.
    let expected = [r#"{"w":null}"#, "{}", r#"{"inner":true}"#, r#"{"pop":10.0,"name":"B","list":[1,[2]]}"#];
    assert_eq!(properties, expected);
    assert_eq!(
        (0..4).map(|feature| table.id(feature)).collect::<Vec<_>>(),
        [Some("\"x\""), None, None, None]
    );
    assert_eq!([table.of_line(0), table.of_line(1), table.of_point(1)], [Some(0), Some(3), Some(2)]);
    assert_eq!(read(&written(&model)[..]).unwrap(), model);
}

#[test]
fn properties_that_are_no_object_are_refused_and_deep_ones_kept() {
    for properties in ["5", "[]", "\"text\"", "true"] {
        let text = format!("\n{{\"type\":\"Feature\",\"geometry\":null,\"properties\":{properties}}}");
        let error = read(text.as_bytes()).unwrap_err();
        assert!(error.to_string().contains("expected properties, an object or null"), "{error}");
        assert_eq!((error.kind(), error.line()), (ErrorKind::Parse, Some(2)), "{error}");
    }
    let deep = format!("{{\"a\":{}{}}}", "[".repeat(5_000), "]".repeat(5_000));
    let text = format!("{{\"type\":\"Feature\",\"geometry\":null,\"properties\":{deep}}}");
    assert_eq!(read(text.as_bytes()).unwrap().features().properties(0), deep);
}

#[test]
fn heights_are_kept() {
    let model = read(&br#"{"type":"LineString","coordinates":[[0,0,5],[1,0],[1,1,6,7]]}"#[..]).unwrap();
    assert_eq!(model.positions().as_flat(), [0., 0., 5., 1., 0., 0., 1., 1., 6.]);
    assert_eq!(model.remarks().len(), 2);
    assert_eq!(read(&written(&model)[..]).unwrap(), model);
}

#[test]
fn faults_have_a_line_and_a_cure() {
    for (text, message) in [
        (r#"{"type":"Polygon","coordinates":[[0,0],[1,0]]}"#, "a Polygon are a list of positions"),
        (r#"{"type":"Point","coordinates":5}"#, "a Point are a number"),
        (r#"{"type":"Point","coordinates":[5]}"#, "position 0 has one number"),
        (r#"{"type":"LineString","coordinates":[[0,0],[1,[2]]]}"#, "stand in one list"),
        (r#"{"type":"Point","coordinates":[[[[[1,2]]]]]}"#, "too deep"),
        (r#"{"type":"Point","coordinates":[1,null]}"#, "null"),
        (r#"{"type":"Point","coordinates":[1,1e999]}"#, "out of range"),
        (r#"{"type":"Point"}"#, "no \"coordinates\""),
        (r#"{"coordinates":[1,2]}"#, "no \"type\""),
        (r#"{"type":"Feature","geometry":{"type":"Feature"}}"#, "\"Feature\" is not a type of geometry"),
        (r#"{"type":"Point","features":[]}"#, "no FeatureCollection"),
        (r#"{"type":"Topology","arcs":[]}"#, "no \"objects\""),
        (
            r#"{"type":"Topology","arcs":[],"objects":{"a":{"type":"Polygon","arcs":[[0]]}}}"#,
            "arc 0 is named",
        ),
        (r#"{"type":"FeatureCollection","features":{}}"#, "a list of features"),
        (r#"{"type":"FeatureCollection","features":["#, "EOF"),
        ("[[0,0],[1,0]]", "a Polygon are a list of positions"),
        (&"[".repeat(100_000), "recursion"),
    ] {
        let error = read(format!("\n{text}").as_bytes()).unwrap_err();
        assert!(error.to_string().contains(message), "{text}: {error}");
        assert_eq!((error.line(), error.cure().is_some()), (Some(2), true), "{error}");
        assert!(matches!(error.kind(), ErrorKind::Parse | ErrorKind::InvalidInput));
    }
}

/// Positions on a small lattice, scaled.
fn path(length: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[i8; 2]>> {
    vec([0..5i8, 0..5i8], length)
}

#[derive(Clone, Debug)]
enum Piece {
    Line(Vec<[i8; 2]>),
    Polygon(Vec<Vec<[i8; 2]>>),
    Point([i8; 2]),
}

fn pieces() -> impl Strategy<Value = Vec<(u8, Vec<Piece>)>> {
    let piece = prop_oneof![
        path(1..5).prop_map(Piece::Line),
        vec(path(1..5), 1..3).prop_map(Piece::Polygon),
        [9..12i8, 0..5i8].prop_map(Piece::Point),
    ];
    vec((0..3u8, vec(piece, 0..4)), 0..6)
}

proptest! {
    #[test]
    fn what_is_written_reads_back(features in pieces(), scale in 1e-9..1e9f64, height in any::<bool>()) {
        let position = |p: &[i8; 2], named: u8| {
            // Points of features of other names lie apart.
            let x = f64::from(p[0]) + if p[0] > 8 { 10.0 * f64::from(named) } else { 0.0 };
            let mut position = vec![x * scale, f64::from(p[1]) * scale];
            if height {
                position.push(1.5);
            }
            position
        };
        let features: Vec<Value> = features.iter().map(|(name, pieces)| {
            let geometries: Vec<Value> = pieces.iter().map(|piece| match piece {
                Piece::Line(path) => json!({"type": "LineString",
                    "coordinates": path.iter().map(|p| position(p, *name)).collect::<Vec<_>>()}),
                Piece::Polygon(rings) => json!({"type": "Polygon", "coordinates": rings.iter().map(|ring| {
                    ring.iter().chain(ring.first()).map(|p| position(p, *name)).collect::<Vec<_>>()
                }).collect::<Vec<_>>()}),
                Piece::Point(p) => json!({"type": "Point", "coordinates": position(p, *name)}),
            }).collect();
            json!({"type": "Feature", "properties": if *name == 0 { Value::Null } else { json!({"name": name}) },
                "geometry": {"type": "GeometryCollection", "geometries": geometries}})
        }).collect();
        let text = json!({"type": "FeatureCollection", "features": features}).to_string();
        let model = read(text.as_bytes()).unwrap();
        model.check().unwrap();
        // A line that is a point may lie on points of other features, which then are in two groups.
        prop_assume!(model.remarks().is_empty());
        let again = read(&written(&model)[..]).unwrap();
        prop_assert_eq!(&again, &model);
        // WKT keeps all but the names, so that each line with one is a feature of its own there.
        let mut out = Vec::new();
        wkt::write(&model, &mut out).unwrap();
        let from_wkt = wkt::read(&out[..]).unwrap();
        prop_assert_eq!(from_wkt.lines(), model.lines());
        prop_assert_eq!(from_wkt.points(), model.points());
        prop_assert_eq!(from_wkt.positions(), model.positions());
        let has_names = !model.groups().is_empty();
        let told = |found: &Model| -> Vec<CellData> {
            found.data().iter().filter(|data| !has_names || data.name() != "feature").cloned().collect()
        };
        prop_assert_eq!(told(&from_wkt), told(&model));
    }
}

#[test]
fn the_member_crs_is_kept() {
    let member = r#"{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}}"#;
    let point = r#"{"type":"Point","coordinates":[1,2]}"#;
    let before = format!(
        r#"{{"type":"FeatureCollection","crs":{member},"features":[{{"type":"Feature","properties":{{}},"geometry":{point}}}]}}"#
    );
    let behind = format!(r#"{{"type":"FeatureCollection","features":[{point}],"crs":{member}}}"#);
    for text in [before, behind] {
        let model = read(text.as_bytes()).unwrap();
        assert_eq!(model.reference_system().unwrap().srid(), Some(25832));
        let mut written = Vec::new();
        write(&model, &mut written).unwrap();
        assert!(String::from_utf8_lossy(&written).contains(member));
        assert_eq!(read(&written[..]).unwrap(), model);
    }
    let null = r#"{"type":"Point","crs":null,"coordinates":[1,2]}"#;
    assert!(read(null.as_bytes()).unwrap().reference_system().is_none());
    for (crs, words) in [
        ("[]", "neither an object nor null"),
        (r#"{"type":"name","properties":{"name":"EPSG:4326"}}"#, "SRID 4326"),
    ] {
        let text = format!(
            "{{\"type\":\"FeatureCollection\",\"crs\":{member},\"features\":[]}}\n{{\"type\":\"Point\",\"crs\":{crs},\"coordinates\":[1,2]}}"
        );
        let error = read(text.as_bytes()).unwrap_err();
        assert!(
            error.to_string().contains(words) && error.cure().is_some() && error.line() == Some(2),
            "{error}"
        );
    }
}

#[test]
fn text_sequences_are_read_as_a_feature_a_line() {
    let features = [
        json!({"type": "Feature", "properties": {"name": "a", "width": 3},
            "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}}),
        json!({"type": "Feature", "properties": {"name": "b", "width": 5},
            "geometry": {"type": "LineString", "coordinates": [[1, 1], [2, 0]]}}),
    ];
    let [a, b] = features.map(|feature| feature.to_string());
    let model = read(format!("{a}\n{b}\n").as_bytes()).unwrap();
    assert_eq!((model.lines().len(), model.features().is_empty()), (2, false));
    let sequence = format!("\x1e{a}\n\x1e{b}\n");
    let empty_ones = format!("\n\x1e\x1e{a}\x1e \n\x1e{}\x1e", b.replace(',', ",\n"));
    for text in [sequence.clone(), empty_ones, format!("\x1e{a}\x1e{b}")] {
        assert_eq!(read(text.as_bytes()).unwrap(), model, "{text:?}");
        assert_eq!(crate::read_unknown(text.as_bytes()).unwrap().format(), Some(Format::GeoJson));
    }
    // By the names too.
    let folder = std::env::temp_dir().join(format!("coface-text-sequences-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for name in ["a.geojsons", "a.json", "a.unknown", "a"] {
        let path = folder.join(name);
        std::fs::write(&path, &sequence).unwrap();
        let found = crate::read_path(&path, None).unwrap();
        assert_eq!((found.format(), found.features() == model.features()), (Some(Format::GeoJson), true));
        assert_eq!(found.remarks(), []);
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn records_that_are_cut_off_are_named_with_their_line() {
    let record = r#"{"type":"LineString","coordinates":[[0,0],[1,1]]}"#;
    // At every place, in the middle and at the end; with and without the line feed.
    for at in 1..record.len() {
        for end in ["", "\n"] {
            let cut = &record[..at];
            let error = read(format!("\x1e{record}\n\x1e{cut}{end}\x1e{record}\n").as_bytes()).unwrap_err();
            let message = "record 2 is cut off: the next one begins within it";
            assert_eq!(
                (error.message(), error.line(), error.kind()),
                (message, Some(2), ErrorKind::Parse),
                "{cut}"
            );
            let error = read(format!("\x1e{record}\n\x1e{cut}{end}").as_bytes()).unwrap_err();
            let message = "record 2 is cut off: the file ends within it";
            assert_eq!(
                (error.message(), error.line(), error.cure().is_some()),
                (message, Some(2), true),
                "{cut}"
            );
        }
    }
    for (second, message) in [
        (record.replace("LineString", "Line"), "record 2: \"Line\" is not a type of geometry"),
        (record.replace("[1,1]", "[1 1]"), "record 2: expected `,` or `]` (column"),
    ] {
        let error = read(format!("\x1e{record}\n\x1e\n{second}\n").as_bytes()).unwrap_err();
        assert!(error.message().starts_with(message) && error.line() == Some(3), "{error}");
    }
    assert!(read(&b"\x1e\n"[..]).unwrap_err().message().contains("no record"));
}
