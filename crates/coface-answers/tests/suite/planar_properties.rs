//! Properties of the features of maps, through arrangements and Boolean combinations. The second method is to ask of
//! one point of each face which polygons of the features contain it.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::FaceId;
use coface_answers::{
    ArrangementRequest, BooleanRequest, DrawingArrangement, DrawingOptions, PlanarDrawing, RegionBoolean,
    RegionSource,
};
use coface_arrange::boolean::BooleanFormula;
use coface_io as io;
use coface_io::{Format, Model};
use proptest::prelude::*;
use serde_json::{Map, Value, json};

type Ring = Vec<[f64; 2]>;

fn square(x: f64, y: f64, side: f64) -> Value {
    let (r, t) = (x + side, y + side);
    json!([[[x, y], [r, y], [r, t], [x, t], [x, y]]])
}

fn polygon(properties: Value, coordinates: Value) -> Value {
    feature(properties, Value::from_iter([("type", json!("Polygon")), ("coordinates", coordinates)]))
}

fn feature(properties: Value, geometry: Value) -> Value {
    Value::from_iter([("type", json!("Feature")), ("properties", properties), ("geometry", geometry)])
}

fn map(features: &[Value]) -> Model {
    let text = json!({"type": "FeatureCollection", "features": features}).to_string();
    io::read(text.as_bytes(), Format::GeoJson).unwrap()
}

fn drawing(models: &[Model]) -> PlanarDrawing {
    let names = ["a", "b", "c"];
    PlanarDrawing::new(names.into_iter().zip(models), RegionSource::Models).unwrap()
}

fn arranged(models: &[Model]) -> DrawingArrangement {
    DrawingArrangement::new(drawing(models), &ArrangementRequest::default()).unwrap()
}

fn combined(formula: &str, models: &[Model], keep_walls: bool) -> RegionBoolean {
    let formula = BooleanFormula::parse(formula, &[]).unwrap();
    let mut request = BooleanRequest::default();
    request.keep_walls = keep_walls;
    RegionBoolean::new(drawing(models), &formula, &request).unwrap()
}

/// The features of a result as GeoJSON, and the model that the text is.
fn written(
    write: impl Fn(&mut dyn std::io::Write) -> Result<(), coface_algebra::Error>,
) -> (Vec<Value>, Model) {
    let mut bytes = Vec::new();
    write(&mut bytes).unwrap();
    let value: Value = serde_json::from_slice(&bytes).unwrap();
    (value["features"].as_array().unwrap().clone(), io::read(&bytes[..], Format::GeoJson).unwrap())
}

fn of_arrangement(arranged: &DrawingArrangement) -> (Vec<Value>, Model) {
    written(|out| arranged.write(out, Format::GeoJson))
}

fn of_boolean(result: &RegionBoolean) -> (Vec<Value>, Model) {
    written(|out| result.write(out, Format::GeoJson))
}

/// The properties that are not our own.
fn others(feature: &Value, own: &[&str]) -> Value {
    let mut properties = feature["properties"].as_object().unwrap().clone();
    for key in own {
        assert!(properties.remove(*key).is_some(), "{feature} has no {key}");
    }
    Value::Object(properties)
}

const OF_FACES: [&str; 3] = ["area", "face", "inside"];
const OF_POLYGONS: [&str; 3] = ["area", "polygon", "regions"];

fn sorted(mut values: Vec<String>) -> Vec<String> {
    values.sort();
    values
}

/// What is left of the properties of the polygons of a result, as sorted texts.
fn texts(features: &[Value], own: &[&str]) -> Vec<String> {
    sorted(features.iter().map(|feature| others(feature, own).to_string()).collect())
}

fn two_squares() -> [Model; 2] {
    let a = polygon(json!({"zone": "A", "year": 2020, "deep": {"x": [1, null]}}), square(0., 0., 2.));
    let b = polygon(json!({"zone": "B", "year": 2020, "owner": null}), square(1., 1., 2.));
    [map(&[a]), map(&[b])]
}

#[test]
fn two_squares_give_their_faces_what_they_say() {
    let models = two_squares();
    let a = r#"{"deep":{"x":[1,null]},"year":2020,"zone":"A"}"#;
    let b = r#"{"owner":null,"year":2020,"zone":"B"}"#;
    let both = r#"{"deep":{"x":[1,null]},"owner":null,"year":2020,"zone":["A","B"]}"#;
    let (faces, _) = of_arrangement(&arranged(&models));
    assert_eq!(texts(&faces, &OF_FACES), sorted([a, b, both].map(str::to_owned).to_vec()));
    for (formula, expected) in [
        ("a | b", vec![both]),
        ("a & b", vec![both]),
        ("a - b", vec![a]),
        ("b - a", vec![b]),
        ("a ^ b", vec![a, b]),
    ] {
        let (polygons, _) = of_boolean(&combined(formula, &models, false));
        let expected = sorted(expected.into_iter().map(str::to_owned).collect());
        assert_eq!(texts(&polygons, &OF_POLYGONS), expected, "{formula}");
    }
    let (walls, _) = of_boolean(&combined("a | b", &models, true));
    assert_eq!(texts(&walls, &OF_POLYGONS), texts(&faces, &OF_FACES));
    // Values come in the order of the inputs.
    let [a, b] = models;
    let turned = combined("a | b", &[b, a], false).properties_of_polygon(FaceId::new(0)).unwrap();
    assert!(turned.contains(r#""zone":["B","A"]"#), "{turned}");
}

#[test]
fn three_nested_squares_add_up() {
    let nested = [
        polygon(json!({"level": 1, "land": "x"}), square(0., 0., 9.)),
        polygon(json!({"level": 2, "land": "x"}), square(1., 1., 6.)),
        polygon(json!({"level": 2.0, "land": "x", "top": true}), square(2., 2., 2.)),
    ];
    let models = [map(&nested)];
    let (faces, _) = of_arrangement(&arranged(&models));
    let expected = [
        r#"{"land":"x","level":1}"#,
        r#"{"land":"x","level":[1,2]}"#,
        // 2 and 2.0 are one number.
        r#"{"land":"x","level":[1,2],"top":true}"#,
    ];
    assert_eq!(texts(&faces, &OF_FACES), sorted(expected.map(str::to_owned).to_vec()));
    let whole = combined("a", &models, false);
    assert_eq!(whole.features_of_polygon(FaceId::new(0)), [0, 1, 2]);
    assert_eq!(
        whole.properties_of_polygon(FaceId::new(0)).unwrap(),
        r#"{"land":"x","level":[1,2],"top":true}"#
    );
}

#[test]
fn features_without_properties_and_files_without_features_add_nothing() {
    let bare = polygon(Value::Null, square(0., 0., 2.));
    let named = polygon(json!({"k": 1}), square(1., 1., 2.));
    let wkt = io::read(&b"POLYGON ((1 0, 5 0, 5 5, 1 5, 1 0))"[..], Format::Wkt).unwrap();
    let (faces, _) = of_arrangement(&arranged(&[map(&[bare.clone(), named]), wkt.clone()]));
    assert_eq!(faces.len(), 5);
    assert_eq!(texts(&faces, &OF_FACES).iter().filter(|text| *text == r#"{"k":1}"#).count(), 2);
    assert_eq!(texts(&faces, &OF_FACES).iter().filter(|text| *text == "{}").count(), 3);
    // Without properties the text is what it was before there were any.
    let plain = arranged(&[map(&[bare]), wkt]);
    let (faces, _) = of_arrangement(&plain);
    assert_eq!(texts(&faces, &OF_FACES), ["{}", "{}", "{}"]);
    assert_eq!((plain.drawing().feature_count(), plain.features_around(FaceId::new(0))), (0, &[][..]));
    assert_eq!(plain.properties_of_face(FaceId::new(0)).unwrap(), "{}");
}

#[test]
fn all_parts_of_a_multipolygon_have_its_properties_and_its_holes_none() {
    let hole = json!([[1., 1.], [1., 2.], [2., 2.], [2., 1.], [1., 1.]]);
    let mut outer = square(0., 0., 4.);
    outer.as_array_mut().unwrap().push(hole);
    let coordinates = json!([outer, square(6., 0., 1.), square(3., 3., 2.)]);
    let many = feature(json!({"m": 1}), json!({"type": "MultiPolygon", "coordinates": coordinates}));
    let over = polygon(json!({"o": 2}), square(-1., -1., 20.));
    let (faces, _) = of_arrangement(&arranged(&[map(&[many, over])]));
    // Around, in the hole, in the first part, in the second, where the third overlaps the first, and beside it.
    let (both, one) = (r#"{"m":1,"o":2}"#, r#"{"o":2}"#);
    assert_eq!(texts(&faces, &OF_FACES), [both, both, both, both, one, one]);
}

#[test]
fn a_topology_gives_its_properties() {
    let topology = br#"{"type": "Topology", "transform": {"scale": [1, 1], "translate": [0, 0]},
        "arcs": [[[0, 0], [2, 0], [0, 2], [-2, 0], [0, -2]], [[1, 1], [2, 0], [0, 2], [-2, 0], [0, -2]]],
        "objects": {"all": {"type": "GeometryCollection", "geometries": [
            {"type": "Polygon", "arcs": [[0]], "properties": {"t": "first", "n": 1.50}},
            {"type": "MultiPolygon", "arcs": [[[1]]], "properties": {"t": "second"}}]}}}"#;
    let (faces, _) = of_arrangement(&arranged(&[io::read(&topology[..], Format::GeoJson).unwrap()]));
    let expected = [r#"{"n":1.5,"t":"first"}"#, r#"{"n":1.5,"t":["first","second"]}"#, r#"{"t":"second"}"#];
    assert_eq!(texts(&faces, &OF_FACES), expected);
}

#[test]
fn our_own_keys_win_over_those_of_the_input() {
    let given =
        json!({"area": "large", "face": 77, "inside": null, "polygon": 7, "regions": [], "name": "p"});
    let model = map(&[polygon(given, square(0., 0., 2.))]);
    let (faces, _) = of_arrangement(&arranged(std::slice::from_ref(&model)));
    let expected = json!({"area": 4.0, "face": 0, "inside": ["a"], "polygon": 7, "regions": [], "name": "p"});
    assert_eq!(faces[0]["properties"], expected);
    let (polygons, _) = of_boolean(&combined("a", &[model], false));
    let expected =
        json!({"area": 4.0, "polygon": 0, "regions": ["a"], "face": 77, "inside": null, "name": "p"});
    assert_eq!(polygons[0]["properties"], expected);
    // Where we write none of ours, those of the input stand.
    let line = json!({"type": "LineString", "coordinates": [[0, 0], [1, 0]]});
    let (edges, _) = of_arrangement(&arranged(&[map(&[feature(json!({"area": "thin"}), line)])]));
    assert_eq!(edges[0]["properties"], json!({"area": "thin"}));
}

#[test]
fn loose_edges_and_points_have_the_properties_of_what_they_lie_in() {
    let line = |properties: Value, coordinates: Value| {
        feature(properties, json!({"type": "LineString", "coordinates": coordinates}))
    };
    let point = |properties: Value, place: [f64; 2]| {
        feature(properties, json!({"type": "Point", "coordinates": place}))
    };
    let features = [
        polygon(json!({"park": 1}), square(0., 0., 8.)),
        line(json!({"path": "p"}), json!([[1, 1], [5, 1]])),
        line(json!({"path": "q"}), json!([[3, 1], [7, 1]])),
        point(json!({"tree": "oak"}), [2., 6.]),
        point(json!({"tree": "elm"}), [2., 6.]),
        point(json!({"tree": "far"}), [20., 6.]),
        // On the rim: part of the polygons.
        point(json!({"tree": "lost"}), [0., 0.]),
    ];
    let (found, _) = of_arrangement(&arranged(&[map(&features)]));
    let rest: Vec<&Value> = found[1..].iter().map(|feature| &feature["properties"]).collect();
    let expected = [
        json!({"park": 1, "path": "p"}),
        json!({"park": 1, "path": ["p", "q"]}),
        json!({"park": 1, "path": "q"}),
        json!({"park": 1, "tree": ["oak", "elm"]}),
        json!({"tree": "far"}),
    ];
    assert_eq!(rest, expected.iter().collect::<Vec<_>>());
    // A closed line is a line, unless it is to be a ring.
    let ring = json!([[0, 0], [2, 0], [2, 2], [0, 0]]);
    let model = map(&[line(json!({"r": 1}), ring)]);
    let (open, _) = of_arrangement(&arranged(std::slice::from_ref(&model)));
    assert_eq!((others(&open[0], &OF_FACES), &open[0]["properties"]["inside"]), (json!({}), &json!([])));
    let options = DrawingOptions::new().close_lines(true);
    let drawing = PlanarDrawing::with_options([("a", &model)], &options).unwrap();
    let closed = DrawingArrangement::new(drawing, &ArrangementRequest::default()).unwrap();
    let (one, _) = of_arrangement(&closed);
    assert_eq!(
        (others(&one[0], &OF_FACES), &one[0]["properties"]["inside"]),
        (json!({"r": 1}), &json!(["a"]))
    );
}

#[test]
fn a_chain_of_arrange_boolean_and_convert_keeps_properties() {
    let models = two_squares();
    let (_, faces) = of_arrangement(&arranged(&models));
    // All faces together: face and inside of the first step are properties of the second.
    let (united, model) = of_boolean(&combined("a", &[faces], false));
    let expected = json!({"polygon": 0, "area": 7.0, "regions": ["a"], "face": [0, 1, 2],
        "inside": [["a"], ["a", "b"], ["b"]],
        "year": 2020, "deep": {"x": [1, null]}, "zone": ["A", ["A", "B"], "B"], "owner": null});
    assert_eq!(united[0]["properties"], expected);
    // What is written is read and written as it is, ten times.
    let mut model = model;
    for _ in 0..10 {
        let (features, again) = written(|out| io::write(&model, out, Format::GeoJson));
        assert_eq!((&features, &again), (&united, &model));
        model = again;
    }
    // Arranging what is arranged changes nothing: each face lies in one feature.
    let (first, mut faces) = of_arrangement(&arranged(&models[..1]));
    for _ in 0..10 {
        let (again, next) = of_arrangement(&arranged(&[faces]));
        assert_eq!(again, first);
        faces = next;
    }
}

/// Whether a point that lies on no side is inside an odd number of times.
fn contains(rings: &[Ring], [x, y]: [f64; 2]) -> bool {
    let mut is_inside = false;
    for ring in rings {
        for (i, &[ax, ay]) in ring.iter().enumerate() {
            let [bx, by] = ring[(i + 1) % ring.len()];
            if (ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax) {
                is_inside = !is_inside;
            }
        }
    }
    is_inside
}

/// A point inside of rings, with its distance to their sides along its row; from the row in the middle of the widest
/// gap between corners.
fn point_in(rings: &[Ring]) -> ([f64; 2], f64) {
    let mut rows: Vec<f64> = rings.iter().flatten().map(|&[_, y]| y).collect();
    rows.sort_by(f64::total_cmp);
    let widest = rows.windows(2).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0]))).unwrap();
    let y = f64::midpoint(widest[0], widest[1]);
    let mut crossings = Vec::new();
    for ring in rings {
        for (i, &[ax, ay]) in ring.iter().enumerate() {
            let [bx, by] = ring[(i + 1) % ring.len()];
            if (ay > y) != (by > y) {
                crossings.push(ax + (y - ay) / (by - ay) * (bx - ax));
            }
        }
    }
    crossings.sort_by(f64::total_cmp);
    let pairs = crossings.as_chunks::<2>().0;
    let pair = pairs.iter().max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0]))).unwrap();
    let margin = (pair[1] - pair[0]).min(widest[1] - widest[0]) / 2.0;
    ([f64::midpoint(pair[0], pair[1]), y], margin)
}

fn rings_of(polygon: &Value) -> Vec<Ring> {
    let rings: Vec<Ring> = serde_json::from_value(polygon.clone()).unwrap();
    rings.into_iter().map(|ring| ring[..ring.len() - 1].to_vec()).collect()
}

/// The rule in other words: values by key, one if there is one.
fn merged(properties: &[&Map<String, Value>]) -> Value {
    let mut all: Map<String, Value> = Map::new();
    for (key, value) in properties.iter().copied().flatten() {
        let list = all.entry(key.clone()).or_insert_with(|| json!([])).as_array_mut().unwrap();
        if !list.contains(value) {
            list.push(value.clone());
        }
    }
    for value in all.values_mut() {
        if let [single] = value.as_array().unwrap().as_slice() {
            *value = single.clone();
        }
    }
    Value::Object(all)
}

/// One or two triangles, with properties or none.
fn triangles() -> impl Strategy<Value = (Vec<Ring>, Map<String, Value>)> {
    let corner = || prop::array::uniform2((0u8..9).prop_map(f64::from));
    let triangle = prop::collection::vec(corner(), 3);
    let value = prop::sample::select(vec![json!(1), json!("x"), json!(null), json!([1, 2]), json!({"a": 1})]);
    let properties = prop::collection::vec((prop::sample::select(vec!["k", "l", "name"]), value), 0..4);
    let properties = properties.prop_map(|list| list.into_iter().map(|(k, v)| (k.to_owned(), v)).collect());
    (prop::collection::vec(triangle, 1..3), properties)
}

fn map_of_triangles(drawn: &[(Vec<Ring>, Map<String, Value>)]) -> Model {
    let features: Vec<Value> = drawn
        .iter()
        .map(|(triangles, properties)| {
            let closed = |ring: &Ring| ring.iter().chain(ring.first()).copied().collect::<Ring>();
            let polygons: Vec<Vec<Ring>> = triangles.iter().map(|ring| vec![closed(ring)]).collect();
            let properties = Value::Object(properties.clone());
            feature(properties, json!({"type": "MultiPolygon", "coordinates": polygons}))
        })
        .collect();
    map(&features)
}

proptest! {
    #[test]
    fn a_point_of_each_face_lies_in_the_features_that_give_it_properties(
        a in prop::collection::vec(triangles(), 1..5),
        b in prop::collection::vec(triangles(), 1..5),
        formula in prop::sample::select(vec!["a | b", "a & b", "a - b", "a ^ b", "b"]),
    ) {
        let models = [map_of_triangles(&a), map_of_triangles(&b)];
        let all: Vec<&(Vec<Ring>, Map<String, Value>)> = a.iter().chain(&b).collect();
        let around = |point: [f64; 2]| -> Vec<usize> {
            let has = |feature: &usize| all[*feature].0.iter().any(|ring| contains(std::slice::from_ref(ring), point));
            (0..all.len()).filter(has).collect()
        };
        let (faces, _) = of_arrangement(&arranged(&models));
        let is_face = |feature: &&Value| feature["geometry"]["type"] == "Polygon";
        let mut points = Vec::new();
        for face in faces.iter().filter(is_face) {
            let (point, margin) = point_in(&rings_of(&face["geometry"]["coordinates"]));
            if margin < 1e-9 {
                continue;
            }
            let features = around(point);
            let properties: Vec<_> = features.iter().map(|&feature| &all[feature].1).collect();
            prop_assert_eq!(others(face, &OF_FACES), merged(&properties));
            points.push((point, features));
        }
        // A polygon has those of the features that contain some of its faces.
        let (polygons, _) = of_boolean(&combined(formula, &models, false));
        for polygon in &polygons {
            let rings = rings_of(&polygon["geometry"]["coordinates"]);
            let inside = points.iter().filter(|(point, _)| contains(&rings, *point));
            let mut features: Vec<usize> = inside.flat_map(|(_, features)| features.clone()).collect();
            features.sort_unstable();
            features.dedup();
            let properties: Vec<_> = features.iter().map(|&feature| &all[feature].1).collect();
            prop_assert_eq!(others(polygon, &OF_POLYGONS), merged(&properties));
        }
    }
}
