//! `coface yin`: sets through files, the tables of the reference systems, round trips, kinks, pictures, and what is refused.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

fn file(folder: &TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

fn yin(arguments: &[&str]) -> Value {
    coface(&[&["yin"], arguments, &["--json", "--quiet"]].concat()).json()
}

fn fails(arguments: &[&str]) -> String {
    coface(&[&["yin"], arguments, &["--json", "--quiet"]].concat()).fails_with(1).to_owned()
}

/// Our JSON of rings.
fn curves(order: usize, rings: &[&[[f64; 2]]]) -> String {
    let rings: Vec<Value> = rings.iter().map(|ring| json!({ "points": ring })).collect();
    json!({"order": order, "curves": rings}).to_string()
}

/// A square with sides along the axes, counterclockwise.
fn square(x: f64, y: f64, side: f64) -> [[f64; 2]; 4] {
    [[x, y], [x + side, y], [x + side, y + side], [x, y + side]]
}

fn areas(value: &Value) -> Vec<f64> {
    let mut areas: Vec<f64> =
        value["curves"].as_array().unwrap().iter().map(|curve| curve["area"].as_f64().unwrap()).collect();
    areas.sort_by(|a, b| b.total_cmp(a));
    areas
}

fn is_near(values: &[f64], expected: &[f64], bound: f64) -> bool {
    values.len() == expected.len() && values.iter().zip(expected).all(|(a, b)| (a - b).abs() <= bound)
}

/// The polygons of the reference tests as files of their own, if the data are there.
fn reference_files(test: &str, folder: &TempDir) -> Option<impl Fn(&str, [f64; 2]) -> PathBuf> {
    let Some(data) = std::env::var_os("COFACE_DATA") else {
        println!("{test}: COFACE_DATA is not set, so this is skipped");
        return None;
    };
    let text = std::fs::read(Path::new(&data).join("yin/polygons.json")).unwrap();
    let all: Value = serde_json::from_slice(&text).unwrap();
    let folder = folder.path().to_owned();
    Some(move |name: &str, [dx, dy]: [f64; 2]| {
        let rings: Vec<Value> = all[name]
            .as_array()
            .unwrap()
            .iter()
            .map(|ring| {
                let points: Vec<[f64; 2]> = serde_json::from_value(ring.clone()).unwrap();
                let moved: Vec<[f64; 2]> = points.iter().map(|[x, y]| [x + dx, y + dy]).collect();
                json!({ "points": moved })
            })
            .collect();
        let path = folder.join(format!("{name}{dx}.json"));
        std::fs::write(&path, json!({"order": 2, "curves": rings}).to_string()).unwrap();
        path
    })
}

#[test]
fn the_report_has_the_keys_of_the_contract() {
    let folder = tempfile::tempdir().unwrap();
    let (outer, mut hole) = (square(0., 0., 4.), square(1., 1., 2.));
    hole.reverse();
    let island = square(1.5, 1.5, 1.);
    let path = file(&folder, "a.json", &curves(2, &[&outer, &hole, &island]));
    let value = yin(&["info", argument(&path)]);
    for (key, expected) in [
        ("empty", json!(false)),
        ("plane", json!(false)),
        ("bounded", json!(true)),
        ("area", json!(13.0)),
        ("perimeter", json!(28.0)),
        ("curve_counts", json!([2, 1])),
        ("betti_open", json!([2, 1])),
        ("betti_closed", json!([2, 1])),
        ("order", json!(2)),
    ] {
        assert_eq!(value[key], expected, "{key}: {value}");
    }
    let of_curves: Vec<Value> = value["curves"]
        .as_array()
        .unwrap()
        .iter()
        .map(|curve| {
            json!([
                curve["sign"],
                curve["area"],
                curve["knots"],
                curve["kinks"],
                curve["parent"],
                curve["depth"]
            ])
        })
        .collect();
    assert_eq!(
        of_curves,
        [json!([1, 16.0, 4, [], null, 0]), json!([-1, -4.0, 4, [], 0, 1]), json!([1, 1.0, 4, [], 1, 2])]
    );
    assert_eq!(value["file"], json!(argument(&path)));
    assert_eq!(value["bounding_box"], json!([[0.0, 0.0], [4.0, 4.0]]));
    let page = coface(&["yin", "info", argument(&path)]);
    assert_eq!(page.status, 0, "{}", page.stderr);
    assert!(page.stdout.contains("2 positive, 1 negative"), "{}", page.stdout);
}

#[test]
fn the_trivial_sets_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let empty = file(&folder, "empty.json", "{\"curves\": []}");
    let plane = file(&folder, "plane.json", "{\"plane\": true}");
    let square = file(&folder, "square.json", &curves(2, &[&square(0., 0., 1.)]));
    let [empty, plane, square] = [&empty, &plane, &square].map(|path| argument(path));
    let kind = |value: &Value| (value["empty"] == true, value["plane"] == true, value["bounded"] == true);
    let is_empty = |value: &Value| {
        assert_eq!(kind(value), (true, false, true), "{value}");
        assert_eq!((&value["area"], &value["perimeter"]), (&json!(0.0), &json!(0.0)));
        assert_eq!(value["betti_open"], json!([0, 0]));
    };
    let is_plane = |value: &Value| {
        assert_eq!(kind(value), (false, true, false), "{value}");
        assert_eq!((&value["area"], &value["perimeter"]), (&json!(null), &json!(0.0)));
        assert_eq!(value["betti_open"], json!([1, 0]));
    };
    is_empty(&yin(&["info", empty]));
    is_plane(&yin(&["info", plane]));
    is_plane(&yin(&["complement", empty]));
    is_empty(&yin(&["complement", plane]));
    is_empty(&yin(&["meet", empty, square]));
    is_plane(&yin(&["join", plane, square]));
    is_empty(&yin(&["difference", square, plane]));
    is_empty(&yin(&["xor", square, square]));
    assert_eq!(yin(&["meet", plane, square])["area"], json!(1.0));
    assert_eq!(yin(&["join", empty, square])["area"], json!(1.0));
    let outside = folder.path().join("outside.json");
    let complement = yin(&["complement", square, "-o", argument(&outside)]);
    assert_eq!(kind(&complement), (false, false, false));
    assert_eq!((&complement["area"], &complement["perimeter"]), (&json!(null), &json!(4.0)));
    assert_eq!(
        (&complement["curves"][0]["sign"], &complement["curves"][0]["area"]),
        (&json!(-1), &json!(-1.0))
    );
    is_plane(&yin(&["join", argument(&outside), square]));
    is_empty(&yin(&["meet", argument(&outside), square]));
    for (set, check) in [(empty, &is_empty as &dyn Fn(&Value)), (plane, &is_plane)] {
        for extension in ["json", "svg"] {
            let path = folder.path().join(format!("again.{extension}"));
            yin(&["info", set, "-o", argument(&path)]);
            check(&yin(&["info", argument(&path)]));
        }
    }
}

#[test]
fn drawings_are_sets() {
    let folder = tempfile::tempdir().unwrap();
    let outer = "0 0, 0 4, 4 4, 4 0, 0 0";
    let hole = "1 1, 1 2, 2 2, 2 1, 1 1";
    for (name, text, area, counts) in [
        // Rings in any direction: the second of a polygon is a hole.
        ("a.wkt", format!("POLYGON (({outer}), ({hole}))"), 15.0, [1, 1]),
        ("b.wkt", format!("MULTIPOLYGON ((({outer}), ({hole})), ((10 0, 11 0, 11 1, 10 0)))"), 15.5, [2, 1]),
        // Polygons that overlap, and that share a side.
        ("c.wkt", format!("MULTIPOLYGON ((({outer})), ((2 2, 6 2, 6 6, 2 6, 2 2)))"), 28.0, [1, 0]),
        ("d.wkt", format!("MULTIPOLYGON ((({outer})), ((4 0, 8 0, 8 4, 4 4, 4 0)))"), 32.0, [1, 0]),
        (
            "e.geojson",
            "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[2,0],[2,2],[0,2],[0,0]]]}".to_owned(),
            4.0,
            [1, 0],
        ),
        ("f.lines", "0,0,1,0\n1,0,1,1\n1,1,0,1\n0,1,0,0\n".to_owned(), 1.0, [1, 0]),
        ("g.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n".to_owned(), 2.0, [1, 0]),
        (
            "h.svg",
            "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0H4V4H0ZM1 1H2V2H1Z'/></svg>".to_owned(),
            16.0,
            [1, 0],
        ),
        (
            "i.svg",
            "<svg xmlns='http://www.w3.org/2000/svg'><path fill-rule='evenodd' d='M0 0H4V4H0ZM1 1H2V2H1Z'/></svg>"
                .to_owned(),
            15.0,
            [1, 1],
        ),
        (
            "j.svg",
            "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0V4H4V0Z'/><rect x='5' width='2' height='3'/></svg>"
                .to_owned(),
            22.0,
            [2, 0],
        ),
    ] {
        let path = file(&folder, name, &text);
        let value = yin(&["info", argument(&path)]);
        assert_eq!((&value["area"], &value["curve_counts"]), (&json!(area), &json!(counts)), "{name}");
        assert_eq!((&value["bounded"], &value["order"]), (&json!(true), &json!(2)), "{name}");
    }
    let raised = yin(&["info", argument(&folder.path().join("a.wkt")), "--order", "4"]);
    assert_eq!((&raised["area"], &raised["order"]), (&json!(15.0), &json!(4)));
    assert_eq!(raised["curves"][0]["kinks"], json!([0, 1, 2, 3]));
    let read = coface_reading(&["yin", "info", "-", "--json", "--quiet"], b"{\"plane\":true}").json();
    assert_eq!(read["plane"], json!(true));
}

#[test]
fn curves_of_svg_are_kept() {
    use std::f64::consts::PI;
    let folder = tempfile::tempdir().unwrap();
    for (shape, area, bound) in [
        ("<circle cx='5' cy='6' r='2'/>", 4.0 * PI, 1e-7),
        ("<ellipse rx='3' ry='1' transform='rotate(30)'/>", 3.0 * PI, 1e-7),
        ("<rect width='4' height='3' rx='1'/>", 12.0 - (4.0 - PI), 1e-7),
        ("<path d='M2 0A2 2 0 0 1 -2 0A2 2 0 0 1 2 0Z'/>", 4.0 * PI, 1e-7),
        ("<path d='M2 0a2 2 0 112-2z'/>", 3.0 * PI + 2.0, 1e-7),
        ("<path d='M0 0Q1 2 2 0Z'/>", 4.0 / 3.0, 1e-14),
        ("<path d='M0 0C0 2 2 2 2 0Z'/>", 2.4, 1e-14),
        ("<path d='M0 0c0 2 2 2 2 0z'/>", 2.4, 1e-14),
        ("<path d='M0 0C0 2 2 2 2 0S4 -2 4 0L4 -3H0Z'/>", 12.0, 1e-14),
        ("<path d='M0 0Q1 2 2 0T4 0V-3H0Z'/>", 12.0, 1e-14),
    ] {
        let path = file(&folder, "a.svg", &format!("<svg xmlns='http://www.w3.org/2000/svg'>{shape}</svg>"));
        let value = yin(&["info", argument(&path)]);
        assert_eq!((&value["order"], &value["curve_counts"]), (&json!(4), &json!([1, 0])), "{shape}");
        let found = value["area"].as_f64().unwrap();
        assert!((found - area).abs() <= bound * area, "{shape}: {found} for {area}");
        // Written and read again, nothing has changed.
        let again = folder.path().join("again.svg");
        let written = yin(&["info", argument(&path), "-o", argument(&again)]);
        let back = yin(&["info", argument(&again)]);
        assert_eq!((&written["curves"], &written["area"]), (&back["curves"], &back["area"]), "{shape}");
        let chords = yin(&["info", argument(&path), "--order", "2", "--flatten", "1e-4"]);
        assert_eq!(chords["order"], json!(2));
        assert!((chords["area"].as_f64().unwrap() - area).abs() < 20.0 * 1e-4);
        let coarse = yin(&["info", argument(&path), "--order", "2"]);
        let codes: Vec<_> =
            coarse["remarks"].as_array().unwrap().iter().map(|remark| remark["code"].clone()).collect();
        assert!(codes.contains(&json!("curves-flattened")), "{codes:?}");
        assert!((coarse["area"].as_f64().unwrap() - area).abs() < 0.01 * area, "{shape}");
    }
}

#[test]
fn json_keeps_every_bit() {
    let folder = tempfile::tempdir().unwrap();
    let ring: Vec<[f64; 2]> = (0..12)
        .map(|i| f64::from(i) * std::f64::consts::TAU / 12.0)
        .map(|t| [0.1 + t.cos() * 1.7, -1e-7 + t.sin() / 3.0])
        .collect();
    let text =
        json!({"order": 4, "curves": [{"points": ring, "kinks": [2, 7], "name": "leaf \"a\""}]}).to_string();
    let first = file(&folder, "first.json", &text);
    let paths: Vec<PathBuf> = (0..4).map(|i| folder.path().join(format!("{i}.json"))).collect();
    let value = yin(&["info", argument(&first), "-o", argument(&paths[0])]);
    assert_eq!(
        (&value["curves"][0]["kinks"], &value["curves"][0]["name"]),
        (&json!([2, 7]), &json!("leaf \"a\""))
    );
    yin(&["info", argument(&paths[0]), "-o", argument(&paths[1])]);
    let bytes = |path: &Path| std::fs::read(path).unwrap();
    assert_eq!(bytes(&paths[0]), bytes(&paths[1]));
    let read: Value = serde_json::from_slice(&bytes(&paths[0])).unwrap();
    assert_eq!(read["curves"][0]["points"], json!(ring), "{read}");
    assert!(read["curves"][0].get("controls").is_none(), "what is fitted is not written");
    // Names of kinks outlive those before them.
    yin(&["kinks", argument(&paths[0]), "--erase", "0", "--insert", "0:5", "-o", argument(&paths[2])]);
    let edited = yin(&["kinks", argument(&paths[2]), "-o", argument(&paths[3])]);
    assert_eq!(edited["curves"][0]["kinks"], json!([5, 7]));
    assert_eq!(edited["curves"][0]["vertices"], json!([2, 1]));
    assert_eq!(bytes(&paths[2]), bytes(&paths[3]));
    // A name that was given up is not given again.
    let more = yin(&["kinks", argument(&paths[2]), "--erase", "2", "--insert", "0:1"]);
    assert_eq!(more["curves"][0]["vertices"], json!([3, 1]));
    // Curves that are no fit keep their control points.
    let svg = file(
        &folder,
        "a.svg",
        "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0C0 2.1 2 2 2 0.3L1 -1Z'/></svg>",
    );
    let value = yin(&["info", argument(&svg), "-o", argument(&paths[0])]);
    assert_eq!(value["curves"], yin(&["info", argument(&paths[0]), "-o", argument(&paths[1])])["curves"]);
    assert_eq!(bytes(&paths[0]), bytes(&paths[1]));
    let read: Value = serde_json::from_slice(&bytes(&paths[0])).unwrap();
    let controls = read["curves"][0]["controls"].as_array().unwrap();
    assert!(controls.contains(&json!([0, 2.1])) || controls.contains(&json!([0.0, 2.1])), "{read}");
}

#[test]
fn binary_curves_are_read_and_written() {
    let folder = tempfile::tempdir().unwrap();
    let ring: Vec<[f64; 2]> = (0..16)
        .map(|i| f64::from(i) * std::f64::consts::TAU / 16.0)
        .map(|t| [3.0 + t.cos(), 2.0 + t.sin()])
        .collect();
    for order in [2, 4] {
        let json =
            file(&folder, "a.json", &json!({"order": order, "curves": [{"points": ring}]}).to_string());
        let [dat, again] = ["a.dat", "b.dat"].map(|name| folder.path().join(name));
        let value = yin(&["info", argument(&json), "-o", argument(&dat)]);
        let bytes = std::fs::read(&dat).unwrap();
        assert_eq!(bytes.len(), 4 + 12 + 17 * 8 + 16 * 2 * order * 8);
        assert_eq!(bytes[..16], [1, 0, 0, 0, 2, 0, 0, 0, order as u8, 0, 0, 0, 16, 0, 0, 0]);
        let back = yin(&["info", argument(&dat), "-o", argument(&again)]);
        let difference = value["area"].as_f64().unwrap() - back["area"].as_f64().unwrap();
        assert!(difference.abs() < 1e-14, "{difference}");
        assert_eq!(back["curves"][0]["knots"], json!(16));
        let complement = folder.path().join("c.dat");
        yin(&["complement", argument(&dat), "-o", argument(&complement)]);
        assert_eq!(yin(&["info", argument(&complement)])["bounded"], json!(false));
        for (from, to, message) in [
            (0, &[0xff, 0xff, 0xff, 0x7f][..], "the file ends before"),
            (0, &[0xff, 0xff, 0xff, 0xff], "the name says binary curves"),
            (4, &[3, 0, 0, 0], "the name says binary curves"),
            (8, &[5, 0, 0, 0], "the name says binary curves"),
            (12, &[0xff, 0xff, 0xff, 0x7f], "are left"),
            (16 + 8, &f64::NAN.to_le_bytes(), "not finite"),
            (16 + 8, &(-1f64).to_le_bytes(), "not above"),
            (16 + 17 * 8, &9f64.to_le_bytes(), "open"),
        ] {
            let mut broken = bytes.clone();
            broken[from..from + to.len()].copy_from_slice(to);
            let path = folder.path().join("broken.dat");
            std::fs::write(&path, &broken).unwrap();
            let text = fails(&["info", argument(&path)]);
            assert!(text.contains(message), "{message}: {text}");
        }
        let path = folder.path().join("short.dat");
        std::fs::write(&path, &bytes[..bytes.len() - 3]).unwrap();
        assert!(fails(&["info", argument(&path)]).contains("are left"));
        std::fs::write(&path, [&bytes[..], &[0]].concat()).unwrap();
        assert!(fails(&["info", argument(&path)]).contains("goes on"));
    }
    let plane = file(&folder, "plane.json", "{\"plane\":true}");
    let dat = folder.path().join("plane.dat");
    assert!(fails(&["info", argument(&plane), "-o", argument(&dat)]).contains("whole plane"));
    assert!(!dat.exists());
}

#[test]
fn sets_become_polygons_where_they_must() {
    let folder = tempfile::tempdir().unwrap();
    let mut hole = square(1., 1., 1.);
    hole.reverse();
    let path = file(&folder, "a.json", &curves(2, &[&square(0., 0., 4.), &hole, &square(6., 0., 1.)]));
    for extension in ["wkt", "geojson", "svg", "obj", "lines"] {
        let out = folder.path().join(format!("a.{extension}"));
        let value = yin(&["info", argument(&path), "-o", argument(&out)]);
        let back = yin(&["info", argument(&out)]);
        for key in ["area", "perimeter", "curve_counts", "betti_open", "betti_closed"] {
            assert_eq!(value[key], back[key], "{extension}: {key}");
        }
    }
    let disk = file(&folder, "disk.svg", "<svg xmlns='http://www.w3.org/2000/svg'><circle r='1'/></svg>");
    let out = folder.path().join("disk.geojson");
    assert!(fails(&["info", argument(&disk), "-o", argument(&out)]).contains("--flatten"));
    yin(&["info", argument(&disk), "-o", argument(&out), "--flatten", "1e-6"]);
    let area = yin(&["info", argument(&out)])["area"].as_f64().unwrap();
    assert!((area - std::f64::consts::PI).abs() < 1e-5, "{area}");
    let outside = folder.path().join("outside.wkt");
    let text = fails(&["complement", argument(&path), "-o", argument(&outside)]);
    assert!(text.contains("unbounded") && text.contains(".json"), "{text}");
}

#[test]
fn other_verbs_read_sets() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(&folder, "a.json", &curves(2, &[&square(0., 0., 4.)]));
    let report = coface(&["info", argument(&path), "--json", "--quiet"]).json();
    assert_eq!((&report["kind"], &report["f_vector"]), (&json!("planar"), &json!([4, 4])));
    let other = file(&folder, "b.wkt", "POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))");
    let union = coface(&["boolean", "union", argument(&path), argument(&other), "--json", "--quiet"]).json();
    assert_eq!(union["measure"], json!(28.0));
    let plane = file(&folder, "p.json", "{\"plane\":true}");
    let text = coface(&["info", argument(&plane), "--json"]).fails_with(1).to_owned();
    assert!(text.contains("coface yin"), "{text}");
    let dat = folder.path().join("a.dat");
    assert_eq!(coface(&["convert", argument(&other), "-o", argument(&dat), "--quiet"]).status, 0);
    assert_eq!(yin(&["info", argument(&dat)])["area"], json!(16.0));
    let back = folder.path().join("back.json");
    assert_eq!(coface(&["convert", argument(&dat), "-o", argument(&back), "--quiet"]).status, 0);
    assert_eq!(yin(&["info", argument(&back)])["area"], json!(16.0));
}

#[test]
fn lists_of_sets_have_places_and_names() {
    let folder = tempfile::tempdir().unwrap();
    let set = |name: &str, side: f64| {
        format!(
            "{{\"name\":\"{name}\",\"order\":2,\"curves\":[{{\"points\":[[0,0],[{side},0],[{side},{side}],[0,{side}]]}}]}}"
        )
    };
    let one = file(&folder, "one.json", &format!("[{}]", set("a", 1.0)));
    let info = yin(&["info", argument(&one)]);
    assert_eq!((&info["area"], &info["remarks"]), (&json!(1.0), &json!([])));
    let two = file(&folder, "two.json", &format!("[{},{}]", set("a", 1.0), set("b", 2.0)));
    let info = yin(&["info", argument(&two)]);
    assert_eq!((&info["area"], &info["remarks"][0]["code"]), (&json!(1.0), &json!("several-models")));
    for (place, area) in [("1", 1.0), ("2", 4.0), ("b", 4.0)] {
        assert_eq!(yin(&["info", &format!("{}#{place}", argument(&two))])["area"], json!(area));
    }
    let meet = yin(&["meet", &format!("{}#1", argument(&two)), &format!("{}#b", argument(&two))]);
    assert_eq!(meet["area"], json!(1.0));
    assert!(coface(&["yin", "info", &format!("{}#3", argument(&two))]).fails_with(1).contains("two.json"));
}

/// A file of MARS tells no kinks; a square in it keeps its corners when it moves.
#[test]
fn corners_of_files_without_kinks_are_kinks() {
    let folder = tempfile::tempdir().unwrap();
    let points = "[[0,0],[2,0],[4,0],[4,2],[4,4],[2,4],[0,4],[0,2]]";
    for order in [4, 6] {
        let text = format!("{{\"order\":{order},\"curves\":[{{\"points\":{points},\"kinks\":[0,2,4,6]}}]}}");
        let square = file(&folder, "square.json", &text);
        let dat = folder.path().join("square.dat");
        assert_eq!(coface(&["yin", "fit", argument(&square), "-o", argument(&dat), "-q"]).status, 0);
        let info = yin(&["info", argument(&dat)]);
        assert_eq!(info["curves"][0]["kinks"].as_array().map(Vec::len), Some(4), "{info}");
        assert_eq!(info["remarks"][0]["code"], "input-reading");
        let moved = folder.path().join("moved.json");
        let words =
            ["yin", "advect", argument(&dat), "--flow", "translation", "--time", "1e-9", "--spacing", "1"];
        assert_eq!(coface(&[&words[..], &["-o", argument(&moved), "-q"]].concat()).status, 0);
        let area = yin(&["info", argument(&moved)])["area"].as_f64().unwrap();
        assert!((area - 16.0).abs() < 1e-7, "order {order}: {area}");
    }
    // Control points in JSON that turn where no kink is named: corners are kinks, and keep what names there are.
    let corners = "[[0,0],[3,0],[3,3],[0,3]]";
    let controls = "[[0,0],[1,0],[2,0],[3,0],[3,1],[3,2],[3,3],[2,3],[1,3],[0,3],[0,2],[0,1]]";
    for (kinks, count) in [("", 4), ("\"kinks\":[2],", 3)] {
        let curve = format!("{{{kinks}\"points\":{corners},\"controls\":{controls}}}");
        let nameless = file(&folder, "nameless.json", &format!("{{\"order\":4,\"curves\":[{curve}]}}"));
        let info = yin(&["info", argument(&nameless)]);
        assert_eq!(info["curves"][0]["kinks"].as_array().map(Vec::len), Some(4), "{info}");
        let remark = &info["remarks"][0];
        assert_eq!((&remark["code"], &remark["count"]), (&json!("input-reading"), &json!(count)));
        let moved = folder.path().join("turned.json");
        let words =
            ["yin", "advect", argument(&nameless), "--flow", "rotation", "--time", "0.1", "--spacing", "0.5"];
        assert_eq!(coface(&[&words[..], &["-o", argument(&moved), "-q"]].concat()).status, 0);
        let area = yin(&["info", argument(&moved)])["area"].as_f64().unwrap();
        assert!((area - 9.0).abs() < 1e-4, "{kinks}: {area}");
    }
    // A circle has no corners.
    let round = folder.path().join("round.dat");
    let circle: Vec<String> = (0..24)
        .map(|i| (f64::from(i) * std::f64::consts::TAU / 24.0).sin_cos())
        .map(|(y, x)| format!("[{x},{y}]"))
        .collect();
    let text = format!("{{\"order\":4,\"curves\":[{{\"points\":[{}]}}]}}", circle.join(","));
    let circle = file(&folder, "circle.json", &text);
    assert_eq!(coface(&["yin", "fit", argument(&circle), "-o", argument(&round), "-q"]).status, 0);
    let info = yin(&["info", argument(&round)]);
    assert_eq!((&info["curves"][0]["kinks"], &info["remarks"]), (&json!([]), &json!([])));
}

#[test]
fn the_spadjors_of_the_reference_tests_have_their_complements() {
    let folder = tempfile::tempdir().unwrap();
    let test = "the_spadjors_of_the_reference_tests_have_their_complements";
    let Some(path) = reference_files(test, &folder) else { return };
    for (id, own, bounded, counts, complement, complement_areas) in [
        (1, &[32., 8., -4.][..], true, [2, 1], [2, 2], &[4., -8., -32.][..]),
        (2, &[16., -4., -32.], false, [2, 2], [5, 0], &[4., 4., 4., 4., 4.]),
        (3, &[32.], true, [1, 0], [1, 1], &[-32.]),
        (5, &[-8.], false, [1, 1], [1, 0], &[8.]),
        (8, &[-4., -16.], false, [1, 2], [2, 0], &[16., 4.]),
        (10, &[-1., -16.], false, [1, 2], [2, 0], &[16., 1.]),
        (11, &[44., -12.], true, [1, 1], [2, 1], &[12., -44.]),
        (12, &[144., -0.75], true, [1, 1], [2, 1], &[0.75, -144.]),
        (13, &[144., -50.], true, [1, 1], [2, 1], &[50., -144.]),
    ] {
        let path = path(&format!("spadjor-{id}.input"), [0., 0.]);
        let value = yin(&["info", argument(&path)]);
        assert!(is_near(&areas(&value), own, 0.0), "{id}: {:?}", areas(&value));
        assert_eq!((&value["bounded"], &value["curve_counts"]), (&json!(bounded), &json!(counts)), "{id}");
        let value = yin(&["complement", argument(&path)]);
        assert!(is_near(&areas(&value), complement_areas, 0.0), "{id}: {:?}", areas(&value));
        assert_eq!(
            (&value["bounded"], &value["curve_counts"]),
            (&json!(!bounded), &json!(complement)),
            "{id}"
        );
    }
    let pinched = yin(&["info", argument(&path("spadjor-11.input", [0., 0.]))]);
    assert_eq!((&pinched["betti_open"], &pinched["betti_closed"]), (&json!([1, 0]), &json!([1, 1])));
}

#[test]
fn the_spadjors_of_the_reference_tests_have_their_meets_and_joins() {
    let folder = tempfile::tempdir().unwrap();
    let test = "the_spadjors_of_the_reference_tests_have_their_meets_and_joins";
    let Some(path) = reference_files(test, &folder) else { return };
    let plane: (&[f64], [usize; 2]) = (&[], [1, 0]);
    for (pair, meet, join) in [
        ([3, 4], (&[8.][..], [1, 0]), (&[56.][..], [1, 0])),
        ([3, 5], (&[24.], [1, 0]), plane),
        ([3, 6], (&[16.], [1, 0]), (&[40.], [1, 0])),
        ([3, 7], (&[16., 4., 4.], [3, 0]), plane),
        ([3, 10], (&[24.], [1, 0]), (&[-1., -8.], [1, 2])),
        ([8, 9], (&[-19., -19.], [1, 2]), (&[-1., -1.], [1, 2])),
        ([11, 12], (&[44., -12.], [1, 1]), (&[144., -0.75], [1, 1])),
        ([11, 13], (&[26. / 3., 26. / 3.], [2, 0]), (&[144., -20. / 3., -86. / 3.], [1, 2])),
    ] {
        let paths = pair.map(|id| path(&format!("spadjor-{id}.input"), [0., 0.]));
        for (verb, (expected, counts)) in [("meet", meet), ("join", join)] {
            let value = yin(&[verb, argument(&paths[0]), argument(&paths[1])]);
            assert!(is_near(&areas(&value), expected, 1e-13), "{verb} {pair:?}: {:?}", areas(&value));
            assert_eq!(value["curve_counts"], json!(counts), "{verb} {pair:?}");
            assert_eq!(value["plane"], json!(expected.is_empty()), "{verb} {pair:?}");
            let swapped = yin(&[verb, argument(&paths[1]), argument(&paths[0])]);
            assert_eq!((&value["curves"], &value["area"]), (&swapped["curves"], &swapped["area"]));
        }
    }
    let ring = yin(&[
        "meet",
        argument(&path("spadjor-3.input", [0., 0.])),
        argument(&path("spadjor-7.input", [0., 0.])),
    ]);
    assert_eq!((&ring["betti_open"], &ring["betti_closed"]), (&json!([3, 0]), &json!([1, 1])));
    let touching = yin(&[
        "meet",
        argument(&path("spadjor-8.input", [0., 0.])),
        argument(&path("spadjor-9.input", [0., 0.])),
    ]);
    assert_eq!(touching["betti_open"], json!([1, 1]));
}

#[test]
fn panda_and_mickey_have_their_areas_and_counts() {
    let folder = tempfile::tempdir().unwrap();
    let Some(path) = reference_files("panda_and_mickey_have_their_areas_and_counts", &folder) else { return };
    let panda = path("Panda", [0., 0.]);
    let panda = argument(&panda);
    let value = yin(&["info", panda]);
    assert!((value["area"].as_f64().unwrap() - 9.58648331242411).abs() < 1e-13);
    assert_eq!(value["curve_counts"], json!([6, 4]));
    let depths: Vec<u64> =
        value["curves"].as_array().unwrap().iter().map(|curve| curve["depth"].as_u64().unwrap()).collect();
    assert_eq!([0, 1, 2, 3, 4].map(|depth| depths.iter().filter(|&&d| d == depth).count()), [1, 2, 4, 2, 1]);
    for (shift, expected) in [
        (
            -1.,
            [
                ("meet", 3.65915098097378, [5, 0]),
                ("join", 13.7387885618784, [6, 11]),
                ("difference", 5.92733233145, [13, 2]),
            ],
        ),
        (
            0.,
            [
                ("meet", 3.87856540970183, [14, 2]),
                ("join", 13.5193741331503, [1, 13]),
                ("difference", 5.70791790272, [17, 0]),
            ],
        ),
        (
            1.,
            [
                ("meet", 1.85918172228191, [15, 1]),
                ("join", 15.5387578205703, [2, 16]),
                ("difference", 7.72730159014, [13, 1]),
            ],
        ),
    ] {
        let mickey = path("mickey.input", [shift, 0.]);
        for (verb, area, counts) in expected {
            let value = yin(&[verb, panda, argument(&mickey)]);
            let found = value["area"].as_f64().unwrap();
            let bound = if verb == "difference" { 1e-11 } else { 1e-13 };
            assert!((found - area).abs() < bound, "{verb} {shift}: {found} for {area}");
            assert_eq!(value["curve_counts"], json!(counts), "{verb} {shift}");
        }
    }
}

#[test]
fn formulas_combine_any_number() {
    let folder = tempfile::tempdir().unwrap();
    let paths: Vec<PathBuf> = (0..3)
        .map(|i| file(&folder, &format!("{i}.json"), &curves(2, &[&square(f64::from(i), f64::from(i), 2.)])))
        .collect();
    let names: Vec<&str> = paths.iter().map(|path| argument(path)).collect();
    let all = |verb: &str| yin(&[&[verb], &names[..]].concat())["area"].clone();
    assert_eq!((all("join"), all("meet")), (json!(10.0), json!(0.0)));
    assert_eq!((all("difference"), all("xor")), (json!(3.0), json!(8.0)));
    let formula = |text: &str| yin(&[&["combine", text], &names[..]].concat());
    assert_eq!(formula("(a | c) - b")["area"], json!(6.0));
    assert_eq!(formula("!(a | b | c)")["bounded"], json!(false));
    assert_eq!(formula("a | !a")["plane"], json!(true));
    assert!(fails(&[&["combine", "a & e"], &names[..]].concat()).contains("input 4"));
    assert!(fails(&[&["combine", "a &"], &names[..]].concat()).contains("formula"));
    let sources = folder.path().join("sources.json");
    let value = yin(&["meet", names[0], names[1], "--provenance", argument(&sources)]);
    assert_eq!((&value["area"], &value["uncertified"]), (&json!(1.0), &json!([])));
    let sources: Value = serde_json::from_slice(&std::fs::read(&sources).unwrap()).unwrap();
    let operands: Vec<u64> =
        sources["sources"][0].as_array().unwrap().iter().map(|s| s[0].as_u64().unwrap()).collect();
    assert_eq!(operands.iter().filter(|&&operand| operand == 0).count(), 2, "{sources}");
}

#[test]
fn kinks_come_and_go() {
    let folder = tempfile::tempdir().unwrap();
    let mut ring: Vec<[f64; 2]> = square(0., 0., 3.).to_vec();
    for (at, point) in [(1, [1.5, 0.]), (3, [3., 1.5]), (5, [1.5, 3.]), (7, [0., 1.5])] {
        ring.insert(at, point);
    }
    let path = file(&folder, "a.json", &json!({"order": 2, "curves": [{"points": ring}]}).to_string());
    let smooth = folder.path().join("smooth.json");
    let value = yin(&["fit", argument(&path), "-o", argument(&smooth)]);
    assert_eq!((&value["order"], &value["kinks"]), (&json!(4), &json!(0)));
    let sharp = folder.path().join("sharp.json");
    let value = yin(&["fit", argument(&path), "--kinks", "detect:30", "-o", argument(&sharp)]);
    let is_square = |value: &Value| (value["area"].as_f64().unwrap() - 9.0).abs() < 1e-14;
    assert_eq!(value["curves"][0]["kinks"], json!([0, 2, 4, 6]));
    assert!(is_square(&value), "{value}");
    let edited = folder.path().join("edited.json");
    yin(&["kinks", argument(&smooth), "--reset", "0:0,0:2,0:4,0:6", "-o", argument(&edited)]);
    assert!(is_square(&yin(&["info", argument(&edited)])));
    // Kinks that come and go leave no trace.
    let circle: Vec<[f64; 2]> =
        (0..16).map(|i| f64::from(i) * std::f64::consts::TAU / 16.0).map(|t| [t.cos(), t.sin()]).collect();
    let path = file(&folder, "c.json", &json!({"order": 4, "curves": [{"points": circle}]}).to_string());
    let [round, bent, back] = ["round.json", "bent.json", "back.json"].map(|name| folder.path().join(name));
    yin(&["info", argument(&path), "-o", argument(&round)]);
    let value =
        yin(&["kinks", argument(&round), "--insert", "0:3", "--insert", "0:9,0:16", "-o", argument(&bent)]);
    assert_eq!(
        (&value["curves"][0]["kinks"], &value["curves"][0]["vertices"]),
        (&json!([0, 3, 9]), &json!([2, 0, 1]))
    );
    yin(&["kinks", argument(&bent), "--erase", "0,1,2", "-o", argument(&back)]);
    let [a, b]: [Value; 2] =
        [&round, &back].map(|path| serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap());
    assert_eq!(a["curves"], b["curves"]);
    // A change after which the boundary would cross itself is refused.
    let text = fails(&["kinks", argument(&smooth), "--insert", "0:0"]);
    assert!(text.contains("more than once"), "{text}");
    let reset = yin(&["kinks", argument(&edited), "--reset", "0:1,0:3"]);
    assert_eq!(reset["curves"][0]["kinks"], json!([1, 3]));
    assert_eq!(reset["complex"], json!([[0], [1]]));
    assert_eq!(reset["kink_points"][1], json!({"vertex": 1, "curve": 0, "knot": 3, "point": [3.0, 1.5]}));
    assert_eq!(yin(&["kinks", argument(&edited), "--reset"])["kinks"], json!(0));
    for (options, message) in [
        (&["--insert", "0:9"][..], "9"),
        (&["--insert", "1:0"], "1"),
        (&["--insert", "0:2"], "kink"),
        (&["--erase", "9"], "9"),
        (&["--reset", "0:1,0:1"], "twice"),
        (&["--kinks", "0:77"], "77"),
    ] {
        let output = folder.path().join("none.json");
        let text = fails(&[&["kinks", argument(&edited), "-o", argument(&output)], options].concat());
        assert!(text.contains(message), "{options:?}: {text}");
        assert!(!output.exists());
    }
}

#[test]
fn cells_add_up() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(&folder, "a.json", &curves(2, &[&[[0., 0.], [2., 0.], [0., 2.]]]));
    let table = folder.path().join("cells.csv");
    let value = yin(&["cut-cells", argument(&path), "--grid", "2", "-o", argument(&table)]);
    assert_eq!(
        [&value["full"], &value["cut"], &value["empty"], &value["area"], &value["area_of_set"]],
        [&json!(1), &json!(2), &json!(1), &json!(2.0), &json!(2.0)]
    );
    let table = std::fs::read_to_string(&table).unwrap();
    assert!(table.starts_with("column,row,coverage,area,length\n0,0,full,1.0,2.0\n1,0,cut,0.5,"), "{table}");
    let disk = file(
        &folder,
        "b.svg",
        "<svg xmlns='http://www.w3.org/2000/svg'><circle cx='.5' cy='.5' r='.25'/></svg>",
    );
    let cells = folder.path().join("cells.json");
    let grid = ["--origin", "0,0", "--spacing", "0.0625", "--grid", "16x16"];
    let value = yin(&[&["cut-cells", argument(&disk), "-o", argument(&cells)], &grid[..]].concat());
    for (cells, set) in [("area", "area_of_set"), ("length", "perimeter_of_set")] {
        let difference = value[cells].as_f64().unwrap() - value[set].as_f64().unwrap();
        assert!(difference.abs() < 1e-13, "{cells}: {difference}");
    }
    let cells: Value = serde_json::from_slice(&std::fs::read(&cells).unwrap()).unwrap();
    let sum: f64 = cells["cells"].as_array().unwrap().iter().map(|cell| cell["area"].as_f64().unwrap()).sum();
    assert!((sum - value["area"].as_f64().unwrap()).abs() < 1e-13);
    assert!(fails(&["cut-cells", argument(&path), "--spacing", "0"]).contains("positive"));
    assert!(fails(&["cut-cells", argument(&path), "-o", "cells.svg"]).contains(".csv"));
}

#[test]
fn sets_move() {
    let folder = tempfile::tempdir().unwrap();
    let circle: Vec<[f64; 2]> = (0..32)
        .map(|i| f64::from(i) * std::f64::consts::TAU / 32.0)
        .map(|t| [0.5 + 0.15 * t.cos(), 0.75 + 0.15 * t.sin()])
        .collect();
    let path = file(&folder, "a.json", &json!({"order": 4, "curves": [{"points": circle}]}).to_string());
    let area = yin(&["info", argument(&path)])["area"].as_f64().unwrap();
    let moved = folder.path().join("moved.json");
    let value = yin(&[
        "advect",
        argument(&path),
        "--flow",
        "translation",
        "--velocity",
        "-1,2",
        "--time",
        "0.5",
        "--spacing",
        "0.05",
        "-o",
        argument(&moved),
    ]);
    assert_eq!((&value["steps"], &value["vanished"]), (&json!(100), &json!([])));
    assert!((value["area"].as_f64().unwrap() - area).abs() < 1e-12);
    let low = yin(&["info", argument(&moved)])["bounding_box"][0].clone();
    assert!((low[0].as_f64().unwrap() + 0.15).abs() < 1e-4 && (low[1].as_f64().unwrap() - 1.6).abs() < 1e-4);
    // There and back in a vortex, with the way in pictures.
    let picture = folder.path().join("way.svg");
    let value = yin(&[
        "advect",
        argument(&path),
        "--flow",
        "vortex",
        "--period",
        "2",
        "--step",
        "0.02",
        "--spacing",
        "0.02",
        "--frames",
        "2",
        "-o",
        argument(&picture),
    ]);
    assert!((value["area"].as_f64().unwrap() - area).abs() < 1e-4, "{value}");
    assert_eq!(value["frames"].as_array().unwrap().len(), 2);
    assert!(folder.path().join("way-001.svg").exists() && picture.exists());
    assert!(fails(&["advect", argument(&path), "--flow", "vortex", "--spacing", "0"]).contains("spacing"));
}

#[test]
fn pictures_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let mut hole = square(1., 1., 1.);
    hole.reverse();
    let text = json!({"order": 4, "curves": [
        {"points": square(0., 0., 4.), "kinks": [0, 1, 2, 3]}, {"points": hole, "kinks": [1]}]});
    let path = file(&folder, "a.json", &text.to_string());
    let picture = folder.path().join("a.svg");
    let draw = |what: &str| {
        yin(&["info", argument(&path), "-o", argument(&picture), "--picture", what]);
        std::fs::read_to_string(&picture).unwrap()
    };
    let kinks = draw("kinks");
    assert_eq!((kinks.matches("r=\"3.5\"").count(), kinks.matches("r=\"1.5\"").count()), (5, 8));
    assert!(kinks.contains(">v4<"), "{kinks}");
    let forest = draw("forest");
    assert!(forest.contains(">outside<") && forest.contains(">0<") && forest.contains(">1<"), "{forest}");
    assert!(draw("set").contains("fill="));
    assert!(fails(&["info", argument(&path), "--picture", "kinks"]).contains(".svg"));
}

#[test]
fn what_is_no_set_is_refused_with_the_place() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text, message) in [
        ("bow.json", curves(2, &[&[[0., 0.], [2., 2.], [2., 0.], [0., 2.]]]), "(1, 1)"),
        ("bow.wkt", "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))".to_owned(), "(1, 1)"),
        ("cross.json", curves(2, &[&square(0., 0., 2.), &square(1., 1., 2.)]), "cross"),
        ("nested.json", curves(2, &[&square(0., 0., 4.), &square(1., 1., 1.)]), "orientation"),
        ("few.json", curves(2, &[&[[0., 0.], [1., 0.]]]), "curve 0"),
        ("one.json", curves(2, &[&[[0., 0.]]]), "curve 0 has 1 points"),
        (
            "kink.json",
            "{\"curves\":[{\"points\":[[0,0],[1,0],[0,1]],\"kinks\":[3]}]}".to_owned(),
            "kink 3 of curve 0",
        ),
        ("again.json", "{\"curves\":[{\"points\":[[0,0],[1,0],[0,1]],\"kinks\":[1,1]}]}".to_owned(), "twice"),
        ("minus.json", "{\"curves\":[{\"points\":[[0,0],[1,0],[0,1]],\"kinks\":[-1]}]}".to_owned(), "is -1"),
        ("nan.json", "{\"curves\":[{\"points\":[[0,0],[1,NaN],[0,1]]}]}".to_owned(), "expected value"),
        ("null.json", "{\"curves\":[{\"points\":[[0,0],[1,null],[0,1]]}]}".to_owned(), "null"),
        ("huge.json", "{\"curves\":[{\"points\":[[0,0],[1,1e999],[0,1]]}]}".to_owned(), "out of range"),
        (
            "three.json",
            "{\"curves\":[{\"points\":[[0,0,0],[1,0,0],[0,1,0]]}]}".to_owned(),
            "has 3 coordinates",
        ),
        ("order.json", "{\"order\":3,\"curves\":[{\"points\":[[0,0],[1,0],[0,1]]}]}".to_owned(), "order 3"),
        ("none.json", "{\"order\":2}".to_owned(), "curves"),
        ("both.json", "{\"plane\":true,\"curves\":[{\"points\":[[0,0],[1,0],[0,1]]}]}".to_owned(), "plane"),
        ("facets.json", "{\"facets\":[[0,1,2]]}".to_owned(), "facets"),
        ("open.lines", "0,0,1,0\n1,0,1,1\n".to_owned(), "lines end at (0, 0)"),
        ("steep.obj", "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n".to_owned(), "height"),
    ] {
        let path = file(&folder, name, &text);
        let message_of = fails(&["info", argument(&path)]);
        assert!(message_of.contains(message), "{name}: {message_of}");
        assert!(message_of.contains(name), "{name} is named: {message_of}");
        assert!(message_of.contains("; "), "{name} has a cure: {message_of}");
    }
    // A named rule repairs.
    let bow = folder.path().join("bow.json");
    let value = yin(&["info", argument(&bow), "--rule", "evenodd"]);
    assert_eq!((&value["area"], &value["curve_counts"]), (&json!(2.0), &json!([2, 0])));
    let value = yin(&["info", argument(&bow), "--rule", "positive"]);
    assert_eq!((&value["area"], &value["curve_counts"]), (&json!(1.0), &json!([1, 0])));
    let cross = folder.path().join("cross.json");
    assert_eq!(yin(&["info", argument(&cross), "--rule", "nonzero"])["area"], json!(7.0));
    assert_eq!(yin(&["info", argument(&cross), "--rule", "evenodd"])["area"], json!(6.0));
    assert!(fails(&["info", argument(&bow)]).contains("--rule"));
    assert!(fails(&["info", argument(&folder.path().join("missing.json"))]).contains("no such file"));
    assert_eq!(coface(&["yin", "turn", "a.json"]).status, 2);
}

/// What one verb writes the others take: the meet of a kinked triangle and a blob meets its own operands.
#[test]
fn results_meet_their_operands_through_files() {
    let folder = tempfile::tempdir().unwrap();
    let triangle = r#"{"order":4,"curves":[{"points":[[0,0],[3,1],[1,2]],"kinks":[0,1,2]}]}"#;
    let blob = r#"{"order":4,"curves":[{"points":[[2,1],[1,1.5],[0.5,0.5],[1.5,-0.2]]}]}"#;
    let [triangle, blob] =
        [("triangle.json", triangle), ("blob.json", blob)].map(|(name, text)| file(&folder, name, text));
    let [meet, rest, again] = ["m.json", "rest.json", "again.json"].map(|name| folder.path().join(name));
    let (a, b, m) = (argument(&triangle), argument(&blob), argument(&meet));
    let area = |value: &Value| value["area"].as_f64().unwrap();
    let both = area(&yin(&["meet", a, b, "-o", m]));
    assert_eq!(area(&yin(&["meet", a, m])), both);
    let without = area(&yin(&["difference", a, m, "-o", argument(&rest)]));
    assert!((area(&yin(&["xor", a, m])) - without).abs() < 1e-14);
    let whole = yin(&["join", m, argument(&rest), "-o", argument(&again)]);
    assert_eq!((area(&whole), whole["curves"][0]["knots"].as_u64()), (2.5, Some(3)));
    assert_eq!(yin(&["xor", argument(&again), a])["empty"], true);
    // Nothing is between the whole and what was put together again.
    let compared = yin(&["compare", a, argument(&again)]);
    assert_eq!(compared["area_xor"], json!(0.0));
    assert!(compared["hausdorff"].as_f64().unwrap() < 1e-14);
    assert_eq!(compared["components"], json!([1, 1]));
    let compared = yin(&["compare", a, m]);
    let [found, error] = ["area_xor", "area_xor_error"].map(|key| compared[key].as_f64().unwrap());
    assert!((found - without).abs() <= error + 1e-14 && error < 1e-12);
    assert!(fails(&["compare", a, m, "-o", argument(&folder.path().join("c.svg"))]).contains(".json"));
    assert!(fails(&["compare", a, m, "--picture", "kinks"]).contains("yin xor"));
}
