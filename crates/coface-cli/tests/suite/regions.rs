//! `coface boolean` in the plane: areas, polygons with holes, pinches, laws, and what is refused.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// A file of this name with this text in a folder of its own.
fn file(folder: &tempfile::TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

fn combined(arguments: &[&str]) -> Value {
    let value = coface(&[&["boolean", "--json", "--quiet"], arguments].concat()).json();
    assert_eq!((&value["dimension"], &value["closed"]), (&json!(2), &json!(true)));
    value
}

fn area(value: &Value) -> f64 {
    value["measure"].as_f64().unwrap()
}

/// A square as well-known text.
fn square(x: f64, y: f64, side: f64) -> String {
    let (r, t) = (x + side, y + side);
    format!("POLYGON (({x} {y}, {r} {y}, {r} {t}, {x} {t}, {x} {y}))\n")
}

#[test]
fn two_squares_have_all_operations() {
    let folder = tempfile::tempdir().unwrap();
    let a = file(&folder, "a.wkt", &square(0., 0., 2.));
    let b = file(&folder, "b.wkt", &square(1., 1., 2.));
    let [a, b] = [&a, &b].map(|path| argument(path));
    for (operation, measure, counts) in [
        ("union", 7.0, [8, 8, 1]),
        ("intersection", 1.0, [4, 4, 1]),
        ("difference", 3.0, [6, 6, 1]),
        ("xor", 6.0, [10, 12, 2]),
    ] {
        let value = combined(&[operation, a, b]);
        assert_eq!((area(&value), &value["f_vector"]), (measure, &json!(counts)), "{operation}");
        assert_eq!(value["components"], json!(counts[2]));
        let is_pinched = operation == "xor";
        assert_eq!(value["manifold"]["verdict"], json!(if is_pinched { "no" } else { "yes" }));
        assert_eq!(value["pinches"], json!(if is_pinched { 2 } else { 0 }));
        assert_eq!(value["manifold"]["witness"].is_null(), !is_pinched);
    }
    let walls = combined(&["union", a, b, "--keep-walls"]);
    assert_eq!((&walls["f_vector"], &walls["components"]), (&json!([10, 12, 3]), &json!(1)));
    assert_eq!(walls["manifold"]["verdict"], json!("yes"));
    let formula = combined(&["--formula", "(a | b) - (a & b)", a, b]);
    assert_eq!(formula["f_vector"], combined(&["xor", a, b])["f_vector"]);
    assert_eq!(combined(&["--formula", "a & !b", a, b])["measure"], json!(3.0));
    // What only touches leaves no trace.
    let beside = file(&folder, "beside.wkt", &square(2., 0.5, 1.));
    let difference = combined(&["difference", a, argument(&beside)]);
    assert_eq!(difference["f_vector"], json!([4, 4, 1]));
    assert_eq!(combined(&["intersection", a, argument(&beside)])["f_vector"], json!([0, 0, 0]));
    assert_eq!(combined(&["union", a, a])["f_vector"], json!([4, 4, 1]));
    assert_eq!(combined(&["union", a])["measure"], json!(4.0));
    let corner = file(&folder, "corner.wkt", &square(2., 2., 1.));
    let touching = combined(&["union", a, argument(&corner)]);
    assert_eq!((&touching["f_vector"], &touching["pinches"]), (&json!([7, 8, 2]), &json!(1)));
    assert_eq!(touching["manifold"]["witness"]["kind"], json!("pinched_vertex"));
}

#[test]
fn results_have_holes_and_are_inputs_again() {
    let folder = tempfile::tempdir().unwrap();
    let big = file(&folder, "big.wkt", &square(0., 0., 9.));
    let holes = file(
        &folder,
        "holes.wkt",
        // Two squares that touch in a corner, one that touches the rim in a corner, and an island's surrounding.
        &(square(1., 1., 1.)
            + &square(2., 2., 1.)
            + "POLYGON ((9 4, 8 5, 7 4, 8 3, 9 4))\n"
            + &square(3., 5., 3.)),
    );
    let island = file(&folder, "island.wkt", &square(4., 6., 1.));
    let inputs = [argument(&big), argument(&holes), argument(&island)];
    let formula = ["--formula", "a - b | c"];
    let value = combined(&[&formula[..], &inputs].concat());
    assert_eq!(area(&value), 81.0 - 2.0 - 2.0 - 9.0 + 1.0);
    assert_eq!((&value["polygons"], &value["holes"]), (&json!(2), &json!(4)));
    assert_eq!(value["pinches"], json!(2));
    for name in ["out.geojson", "out.wkt", "out.svg", "out.lines", "out.obj", "out.vtk", "out.ply"] {
        let out = folder.path().join(name);
        let run = coface(&[&["boolean", "-o", argument(&out)], &formula[..], &inputs].concat());
        assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{name}: {}", run.stderr);
        let again = combined(&["union", argument(&out)]);
        assert_eq!(area(&again), area(&value), "{name}");
        assert_eq!((&again["polygons"], &again["holes"]), (&json!(2), &json!(4)), "{name}");
    }
    let map: Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("out.geojson")).unwrap()).unwrap();
    for feature in map["features"].as_array().unwrap() {
        for (i, ring) in feature["geometry"]["coordinates"].as_array().unwrap().iter().enumerate() {
            let at = |k: usize| [0, 1].map(|axis| ring[k][axis].as_f64().unwrap());
            let corners = ring.as_array().unwrap().len();
            let twice: f64 =
                (0..corners - 1).map(|k| (at(k), at(k + 1))).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum();
            assert_eq!(twice > 0.0, i == 0, "outer rings run counterclockwise, holes clockwise");
            for k in 1..corners {
                assert!((k + 1..corners).all(|l| at(k) != at(l)), "a ring passes a point twice");
            }
        }
    }
    let from = folder.path().join("from.json");
    coface(&[&["boolean", "--provenance", argument(&from)], &formula[..], &inputs].concat());
    let from: Value = serde_json::from_slice(&std::fs::read(&from).unwrap()).unwrap();
    assert_eq!(from["polygons"], json!([[0], [0, 1, 2]]));
    assert_eq!(from["edges"].as_array().unwrap().len() as u64, value["f_vector"][1].as_u64().unwrap());
}

#[test]
fn laws_hold_on_a_map_of_random_triangles() {
    let folder = tempfile::tempdir().unwrap();
    let mut state: u64 = 3;
    let mut number = |below: u64| {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (state >> 33) % below
    };
    let mut soup = || -> String {
        let mut triangle = || {
            let [a, b, c] = [0; 3].map(|_| [number(12), number(12)]);
            format!(
                "POLYGON (({} {}, {} {}, {} {}, {} {}))\n",
                a[0], a[1], b[0], b[1], c[0], c[1], a[0], a[1]
            )
        };
        (0..5).map(|_| triangle()).collect()
    };
    let files: Vec<PathBuf> = (0..3).map(|i| file(&folder, &format!("{i}.wkt"), &soup())).collect();
    let inputs: Vec<&str> = files.iter().map(|path| argument(path)).collect();
    let formula = |text: &str| combined(&[&["--formula", text], &inputs[..]].concat());
    for (one, other) in [
        ("a - (b | c)", "(a - b) & (a - c)"),
        ("a - (b & c)", "(a - b) | (a - c)"),
        ("(a - b) | (a & b)", "a"),
        ("(a ^ b) ^ c", "a ^ (b ^ c)"),
        ("a & a", "a | a"),
        ("a ^ b", "b ^ a"),
    ] {
        let [one, other] = [one, other].map(formula);
        for key in ["measure", "f_vector", "holes", "components", "pinches"] {
            assert_eq!(one[key], other[key], "{key}");
        }
    }
    let [union, both, a, b] = ["a | b", "a & b", "a", "b"].map(|text| area(&formula(text)));
    assert!((union + both - a - b).abs() < 1e-12 * union);
}

#[test]
fn polygons_that_cross_themselves_are_taken_by_a_rule() {
    let folder = tempfile::tempdir().unwrap();
    // A star with five points: the middle is wound around twice.
    let star = file(&folder, "star.wkt", "POLYGON ((0 3, 2 -3, -3 1, 3 1, -2 -3, 0 3))");
    let object = combined(&["union", argument(&star)]);
    assert_eq!((&object["f_vector"], &object["pinches"]), (&json!([10, 10, 1]), &json!(0)));
    let remark = &object["remarks"][0];
    assert_eq!((&remark["code"], &remark["count"]), (&json!("self-crossing-ring"), &json!(1)));
    assert_eq!(remark["places"].as_array().unwrap().len(), 5);
    let arranged = coface(&["arrange", argument(&star), "--json"]).json();
    assert_eq!(arranged["remarks"][0]["places"], remark["places"]);
    assert!(coface(&["arrange", argument(&star), "--strict"]).fails_with(1).contains("crosses itself"));
    // An SVG says its own rule.
    let svg = file(
        &folder,
        "star.svg",
        "<svg xmlns='http://www.w3.org/2000/svg'><path fill-rule='evenodd' d='M0 3L2-3-3 1 3 1-2-3z'/></svg>",
    );
    let object = combined(&["union", argument(&svg), "--strict"]);
    assert_eq!(object["f_vector"], json!([10, 15, 5]));
    assert_eq!(object["remarks"][0]["code"], json!("self-crossing-ring"));
    let message = coface(&["boolean", "union", argument(&star), "--strict"]).fails_with(1).to_owned();
    assert!(
        message.contains("star.wkt: polygon 0 crosses itself at (") && message.contains("--rule"),
        "{message}"
    );
    let nonzero = combined(&["union", argument(&star), "--rule", "nonzero"]);
    assert_eq!((&nonzero["f_vector"], &nonzero["pinches"]), (&json!([10, 10, 1]), &json!(0)));
    let evenodd = combined(&["union", argument(&star), "--rule", "evenodd"]);
    assert_eq!((&evenodd["f_vector"], &evenodd["pinches"]), (&json!([10, 15, 5]), &json!(5)));
    let bow = file(&folder, "bow.wkt", "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))");
    let message = coface(&["boolean", "union", argument(&bow), "--strict"]).fails_with(1).to_owned();
    assert!(message.contains("at (1, 1)"), "{message}");
    assert_eq!(area(&combined(&["union", argument(&bow), "--rule", "positive"])), 1.0);
    let twice = file(&folder, "twice.wkt", "POLYGON ((0 0, 1 0, 0 1, 0 0, 1 0, 0 1, 0 0))");
    let message = coface(&["boolean", "union", argument(&twice), "--strict"]).fails_with(1).to_owned();
    assert!(message.contains("more than once"), "{message}");
    // An SVG says itself what is inside.
    let path = |rule: &str| {
        format!("<svg xmlns='http://www.w3.org/2000/svg'><path {rule} d='M0 3 2-3-3 1 3 1-2-3z'/></svg>")
    };
    let plain = file(&folder, "plain.svg", &path(""));
    assert_eq!(combined(&["union", argument(&plain)])["f_vector"], nonzero["f_vector"]);
    let odd = file(&folder, "odd.svg", &path("fill-rule='evenodd'"));
    assert_eq!(combined(&["union", argument(&odd)])["f_vector"], evenodd["f_vector"]);
}

#[test]
fn features_are_inputs_on_request() {
    let folder = tempfile::tempdir().unwrap();
    let feature = |name: Value, squares: &[[f64; 3]]| {
        let polygons: Vec<Value> = squares
            .iter()
            .map(|&[x, y, s]| json!([[[x, y], [x + s, y], [x + s, y + s], [x, y + s], [x, y]]]))
            .collect();
        json!({"type": "Feature", "properties": {"name": name},
               "geometry": {"type": "MultiPolygon", "coordinates": polygons}})
    };
    let map = json!({"type": "FeatureCollection", "features": [
        feature(json!("land"), &[[0., 0., 4.], [6., 0., 4.]]),
        feature(json!("park"), &[[1., 1., 1.], [7., 1., 1.]]),
        feature(Value::Null, &[[3., 0., 4.]]),
    ]});
    let map = file(&folder, "map.geojson", &map.to_string());
    let value = combined(&["difference", argument(&map), "--inputs", "features"]);
    assert_eq!(area(&value), 32.0 - 2.0 - 8.0);
    assert_eq!(value["regions"][0], json!("land"));
    assert_eq!(value["regions"].as_array().unwrap().len(), 3);
    assert_eq!(area(&combined(&["difference", argument(&map)])), 32.0 + 8.0);
    assert_eq!(area(&combined(&["--formula", "a & c", argument(&map), "--inputs", "features"])), 8.0);
}

#[test]
fn a_feature_without_a_name_is_one_input() {
    let folder = tempfile::tempdir().unwrap();
    let ring = |[x, y, s]: [f64; 3]| json!([[x, y], [x + s, y], [x + s, y + s], [x, y + s], [x, y]]);
    let feature = |geometry: Value| json!({"type": "Feature", "properties": null, "geometry": geometry});
    let map = json!({"type": "FeatureCollection", "features": [
        feature(json!({"type": "MultiPolygon", "coordinates": [[ring([0., 0., 4.]), ring([1., 1., 1.])], [ring([6., 0., 4.])]]})),
        feature(json!({"type": "LineString", "coordinates": [[0, 20], [1, 20]]})),
        feature(json!({"type": "GeometryCollection", "geometries": [
            {"type": "Polygon", "coordinates": [ring([3., 0., 2.])]},
            {"type": "Polygon", "coordinates": [ring([5., 0., 2.])]}]})),
        feature(json!({"type": "Polygon", "coordinates": [ring([0., 0., 9.])]})),
    ]});
    let geojson = file(&folder, "map.geojson", &map.to_string());
    let square = |x: f64, y: f64, s: f64| {
        let (r, t) = (x + s, y + s);
        format!("({x} {y}, {r} {y}, {r} {t}, {x} {t}, {x} {y})")
    };
    let wkt = format!(
        "MULTIPOLYGON (({}, {}), ({}))\nLINESTRING (0 20, 1 20)\nGEOMETRYCOLLECTION (POLYGON ({}), POLYGON ({}))\nPOLYGON ({})\n",
        square(0., 0., 4.),
        square(1., 1., 1.),
        square(6., 0., 4.),
        square(3., 0., 2.),
        square(5., 0., 2.),
        square(0., 0., 9.),
    );
    let wkt = file(&folder, "map.wkt", &wkt);
    // Written and read again they are the same features.
    let [from_json, from_text] = ["again.wkt", "again.geojson"].map(|name| folder.path().join(name));
    coface(&["convert", "--json", argument(&geojson), "-o", argument(&from_json)]).json();
    coface(&["convert", "--json", argument(&wkt), "-o", argument(&from_text)]).json();
    for path in [&geojson, &wkt, &from_json, &from_text] {
        let value = combined(&["difference", argument(path), "--inputs", "features"]);
        let name = path.file_name().unwrap().to_str().unwrap();
        let regions = value["regions"].as_array().unwrap();
        assert_eq!(regions.len(), 3, "{name}: {regions:?}");
        assert!(regions[1].as_str().unwrap().ends_with(&format!("{name}#1")), "{regions:?}");
        // Of the first, 15 + 16, what is above 9 and right of 9.
        assert_eq!(area(&value), 4.0, "{name}");
        let both = combined(&["--formula", "a & b", argument(path), "--inputs", "features"]);
        assert_eq!(area(&both), 2.0 + 2.0, "{name}");
        let faces = coface(&["arrange", "--json", "--quiet", argument(path), "--inputs", "features"]).json();
        assert_eq!(faces["regions"], json!(regions));
        let inside = faces["inside"].as_array().unwrap();
        assert!(inside.contains(&json!([0, 1, 2])) && inside.contains(&json!([0])), "{inside:?}");
    }
}

#[test]
fn what_cannot_be_combined_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let a = file(&folder, "a.wkt", &square(0., 0., 2.));
    let a = argument(&a);
    let fails = |arguments: &[&str]| coface(&[&["boolean"], arguments].concat()).fails_with(1).to_owned();
    for wrong in [&["boolean"][..], &["boolean", "union"], &["boolean", "melt", a], &["boolean", a, a]] {
        assert_eq!(coface(wrong).fails_with(2).lines().filter(|line| line.starts_with("error")).count(), 1);
    }
    let open = file(&folder, "open.lines", "0,0,1,0\n1,0,1,1\n");
    let message = fails(&["union", a, argument(&open)]);
    assert!(message.contains("open.lines: lines end at (0, 0)"), "{message}");
    let closed = file(&folder, "closed.lines", "0,0,1,0\n1,1,1,0\n1,1,0,0\n");
    assert_eq!(area(&combined(&["intersection", a, argument(&closed)])), 0.5);
    let message = fails(&["--formula", "a | (b", a, a]);
    assert!(message.contains("--formula: at byte 4"), "{message}");
    let message = fails(&["--formula", "a | c", a, a]);
    assert!(message.contains("input 2") && message.contains("there are 2"), "{message}");
    let message = fails(&["--formula", "!a", a]);
    assert!(message.contains("no bounds"), "{message}");
    let message = fails(&["union", a, "missing.wkt"]);
    assert!(message.contains("missing.wkt"), "{message}");
    let message = fails(&["union", a, a, "--max-cells", "3"]);
    assert!(message.contains("more than the 3") || message.contains("3"), "{message}");
    let solid =
        file(&folder, "tet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    let message = fails(&["union", a, argument(&solid), "--dimension", "2"]);
    assert!(message.contains("tet.obj: v3 is at height 1"), "{message}");
    let empty = combined(&["intersection", a, argument(&file(&folder, "none.lines", "# nothing\n"))]);
    assert_eq!((&empty["measure"], &empty["f_vector"]), (&json!(0.0), &json!([0, 0, 0])));
    let page = coface(&["boolean", "union", a]);
    assert!(page.stdout.contains("area") && page.stdout.contains('4'), "{}", page.stdout);
}

#[test]
fn recorded_overlays_have_their_areas() {
    let Some(data) = std::env::var_os("COFACE_DATA") else {
        println!("skipped: COFACE_DATA is not set");
        return;
    };
    let data = Path::new(&data);
    let manifest: Value =
        serde_json::from_slice(&std::fs::read(data.join("MANIFEST.json")).unwrap()).unwrap();
    let near = |found: f64, truth: &Value, what: &str| {
        // As near as 1e-12, but for what the record rounded away.
        let text = truth.to_string();
        let decimals = text.split_once('.').map_or(0, |(_, fraction)| fraction.len());
        let truth = truth.as_f64().unwrap();
        let rounded_away = 0.5 * 10f64.powi(-(decimals as i32)) * f64::from(u8::from(truth != 0.0));
        let bound = (1e-12 * truth + rounded_away).min(1e-10 * truth.max(1e-12));
        assert!((found - truth).abs() <= bound, "{what}: {found} for {truth}");
    };
    let overlays = manifest["overlays"].as_array().unwrap();
    assert_eq!(overlays.len(), 2);
    for record in overlays {
        let [a, b] = ["a", "b"].map(|key| data.join(record[key].as_str().unwrap()));
        for (operation, key, turned) in [
            ("union", "union", false),
            ("intersection", "intersection", false),
            ("difference", "a_minus_b", false),
            ("difference", "b_minus_a", true),
            ("xor", "symmetric_difference", false),
        ] {
            let [first, second] = if turned { [&b, &a] } else { [&a, &b] };
            let value = combined(&[operation, argument(first), argument(second)]);
            let truth = &record[key];
            near(area(&value), &truth["area"], key);
            assert_eq!(value["holes"], truth["holes"], "{key}");
            // Countries that touch along a border are one polygon for us and for them, in symmetric differences too.
            assert_eq!(value["polygons"], truth["polygons"], "{key}");
        }
    }
    for record in manifest["files"].as_array().unwrap() {
        let name = record["file"].as_str().unwrap();
        if !name.starts_with("planar/")
            || record["invalid_features"].as_array().is_some_and(|list| !list.is_empty())
        {
            continue;
        }
        let value = combined(&["union", argument(&data.join(name))]);
        let truth = [&record["union"]["area"], &record["area_shoelace"], &record["area_sum"]];
        near(area(&value), truth.into_iter().find(|truth| truth.is_number()).unwrap(), name);
    }
}
