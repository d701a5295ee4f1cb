//! `coface yin advect`: schemes, verification, repair, turning, names, and what is refused.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::path::PathBuf;
use tempfile::TempDir;

fn yin(arguments: &[&str]) -> Value {
    coface(&[&["yin"], arguments, &["--json", "--quiet"]].concat()).json()
}

fn fails(arguments: &[&str]) -> String {
    coface(&[&["yin"], arguments, &["--json", "--quiet"]].concat()).fails_with(1).to_owned()
}

fn file(folder: &TempDir, name: &str, value: &Value) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, value.to_string()).unwrap();
    path
}

/// The points of a circle, counterclockwise.
fn ring(center: [f64; 2], radius: f64, count: u32) -> Vec<[f64; 2]> {
    (0..count)
        .map(|i| f64::from(i) * std::f64::consts::TAU / f64::from(count))
        .map(|t| [center[0] + radius * t.cos(), center[1] + radius * t.sin()])
        .collect()
}

fn disk(folder: &TempDir, order: usize) -> PathBuf {
    let points = ring([0.5, 0.75], 0.15, 48);
    file(folder, "disk.json", &json!({"order": order, "curves": [{"name": "drop", "points": points}]}))
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap()
}

/// A vortex there and back: kept parameters are nearer, and are the usual ones in order 6.
#[test]
fn parameters_of_splines() {
    let folder = tempfile::tempdir().unwrap();
    let off = |order: usize, parameters: &[&str]| {
        let points = ring([0.5, 0.75], 0.15, 80);
        let path = file(&folder, "round.json", &json!({"order": order, "curves": [{"points": points}]}));
        let back = folder.path().join("back.json");
        let common = ["advect", argument(&path), "--flow", "vortex", "--spacing", "0.0125", "--step", "0.02"];
        yin(&[&common, parameters, &["-o", argument(&back)]].concat());
        number(&yin(&["compare", argument(&back), argument(&path)]), "area_xor")
    };
    let [usual, lengths, kept] =
        [&[][..], &["--parameters", "lengths"], &["--parameters", "kept"]].map(|words| off(4, words));
    assert!(usual == lengths && 50.0 * kept < lengths, "{usual:e} {lengths:e} {kept:e}");
    let [usual, lengths, kept] =
        [&[][..], &["--parameters", "lengths"], &["--parameters", "kept"]].map(|words| off(6, words));
    assert!(usual == kept && 1000.0 * kept < lengths, "{usual:e} {lengths:e} {kept:e}");
}

#[test]
fn schemes_have_their_orders() {
    let folder = tempfile::tempdir().unwrap();
    let path = disk(&folder, 4);
    // Half a turn in few steps: what is lost of the area is what the scheme misses.
    let turn = |scheme: &[&str]| {
        let common = ["advect", argument(&path), "--flow", "rotation", "--center", "0.5,0.5"];
        let more = ["--speed", "3.141592653589793", "--step", "0.1", "--spacing", "0.05"];
        yin(&[&common, &more[..], scheme].concat())
    };
    let mut misses = Vec::new();
    for (scheme, order) in [("midpoint", 2), ("classical", 4), ("verner", 6), ("cooper-verner", 8)] {
        let moved = turn(&["--scheme", scheme]);
        assert_eq!((&moved["scheme"], &moved["steps"]), (&json!(order), &json!(10)));
        misses.push((number(&moved, "area") - number(&moved, "area_before")).abs());
    }
    assert!(misses[0] > 1e-4 && misses.windows(2).all(|pair| pair[1] < 0.5 * pair[0]), "{misses:?}");
    assert!(misses[2] < 1e-8, "{misses:?}");
    // The scheme of the order of the set, if none is named.
    assert_eq!(turn(&[])["scheme"], json!(4));
    let high = disk(&folder, 8);
    let moved = yin(&["advect", argument(&high), "--flow", "translation", "--spacing", "0.05"]);
    assert_eq!((&moved["scheme"], &moved["order"]), (&json!(8), &json!(8)));
}

#[test]
fn turning_markers_are_nearer_together() {
    let folder = tempfile::tempdir().unwrap();
    let path = disk(&folder, 4);
    let moved = |turn: &[&str]| {
        let common = ["advect", argument(&path), "--flow", "vortex", "--time", "1", "--spacing", "0.05"];
        yin(&[&common, turn].concat())["curves"][0]["knots"].as_u64().unwrap()
    };
    let [none, wide, narrow] = [moved(&[]), moved(&["--turn", "30"]), moved(&["--turn", "5"])];
    assert!(none <= wide && wide < narrow, "{none} {wide} {narrow}");
}

#[test]
fn what_meets_is_refused_or_repaired() {
    let folder = tempfile::tempdir().unwrap();
    // A long thin thread with too few markers comes to cross itself.
    let points = ring([0.5, 0.75], 0.15, 12);
    let path =
        file(&folder, "drop.json", &json!({"order": 4, "curves": [{"name": "drop", "points": points}]}));
    let output = folder.path().join("moved.json");
    let flow = ["advect", argument(&path), "--flow", "vortex", "--period", "16", "--time", "8"];
    let common = [&flow[..], &["--spacing", "0.15", "--step", "0.1", "-o", argument(&output)]].concat();
    let run = |more: &[&str]| yin(&[&common, more].concat());
    let message = fails(&common);
    assert!(
        message.contains("in step ") && message.contains("at time ") && message.contains('('),
        "{message}"
    );
    assert!(message.contains("--repair nonzero") && message.contains("drop.json"), "{message}");
    assert!(!output.exists(), "nothing is written");
    // Nor are the sets of the way before that, which are kept in a folder that goes.
    let message = fails(&[&common[..], &["--frames", "4"]].concat());
    assert!(message.contains("at time ") && !message.contains("at time 0.0"), "{message}");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    let repaired = run(&["--repair", "nonzero"]);
    let repairs = repaired["repairs"].as_array().unwrap();
    assert!(!repairs.is_empty() && repairs[0]["fault"].as_str().unwrap().contains('('), "{repaired}");
    assert!(repairs[0]["step"].as_u64().unwrap() >= 1 && repairs[0]["time"].as_f64().unwrap() > 0.0);
    // The result is a set, its parts are those of the drop: it is read again.
    let again = yin(&["info", argument(&output)]);
    assert_eq!(again["area"], repaired["area"]);
    assert!(again["curves"].as_array().unwrap().iter().all(|curve| curve["name"] == "drop"), "{again}");
    // Not verified it goes on, until what it bounds is to be counted.
    std::fs::remove_file(&output).unwrap();
    let unseen = fails(&[&common[..], &["--verify", "never"]].concat());
    assert!(unseen.contains("curve 0 comes to (") && unseen.contains("--repair"), "{unseen}");
    assert!(!output.exists(), "nothing is written");
    // Nor are the sets of the way before that, which are kept in a folder that goes.
    let message = fails(&[&common[..], &["--frames", "4"]].concat());
    assert!(message.contains("at time ") && !message.contains("at time 0.0"), "{message}");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    assert!(
        fails(&[&common[..], &["--verify", "never", "--repair", "nonzero"]].concat())
            .contains("--verify never")
    );
    // Looked at in the end alone, it is the last step that is named.
    let late = fails(&[&common[..], &["--verify", "end"]].concat());
    assert!(late.contains("in step 80, at time 8"), "{late}");
}

#[test]
fn names_and_kinks_come_along() {
    let folder = tempfile::tempdir().unwrap();
    let mut hole = ring([0.5, 0.75], 0.03, 24);
    hole.reverse();
    let curves = json!({"order": 4, "next_vertex": 50, "curves": [
        {"name": "drop", "points": ring([0.5, 0.75], 0.15, 48), "kinks": [0, 12], "vertices": [7, 40]},
        {"name": "bubble", "points": hole},
        {"points": ring([0.2, 0.2], 0.05, 24)}]});
    let path = file(&folder, "a.json", &curves);
    let output = folder.path().join("b.json");
    let names = |value: &Value| -> Vec<Value> {
        value["curves"].as_array().unwrap().iter().map(|curve| curve["name"].clone()).collect()
    };
    let moved = yin(&[
        "advect",
        argument(&path),
        "--flow",
        "translation",
        "--spacing",
        "0.05",
        "--frames",
        "3",
        "-o",
        argument(&output),
    ]);
    assert_eq!(names(&moved), [json!("drop"), json!("bubble"), Value::Null]);
    assert_eq!(moved["curves"][0]["vertices"], json!([7, 40]));
    let read = yin(&["info", argument(&folder.path().join("b-002.json"))]);
    assert_eq!((names(&read), &read["curves"][0]["vertices"]), (names(&moved), &json!([7, 40])));
    // A curve that vanishes is told by its number at the beginning, whatever the frame.
    let gone = yin(&[
        "advect",
        argument(&path),
        "--flow",
        "translation",
        "--spacing",
        "2",
        "--least-ratio",
        "0.25",
        "--frames",
        "2",
    ]);
    let numbers: Vec<&Value> = gone["vanished"].as_array().unwrap().iter().map(|own| &own["curve"]).collect();
    assert_eq!((numbers, &gone["empty"]), (vec![&json!(0), &json!(1), &json!(2)], &json!(true)), "{gone}");
    let remark =
        gone["remarks"].as_array().unwrap().iter().find(|own| own["code"] == "curves-vanished").unwrap();
    assert_eq!(remark["count"], 3);
    assert!(remark["message"].as_str().unwrap().starts_with("3 curves became shorter"), "{remark}");
    // Curves of one curve keep its name in a combination.
    let outside = yin(&["complement", argument(&path)]);
    assert!(names(&outside).contains(&json!("bubble")), "{outside}");
    assert_eq!(outside["uncertified"], json!([]));
}

#[test]
fn options_without_meaning_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = disk(&folder, 4);
    for (words, said) in [
        (&["vortex", "--spacing", "0"][..], "spacing 0"),
        (&["vortex", "--spacing", "-1"], "spacing -1"),
        (&["vortex", "--spacing", "nan"], "spacing NaN"),
        (&["vortex", "--step", "0"], "steps of 0"),
        (&["vortex", "--step", "-1"], "steps of -1"),
        (&["vortex", "--step", "1e-300"], "steps of"),
        (&["vortex", "--time", "inf"], "--time inf"),
        (&["vortex", "--period", "0"], "--period 0"),
        (&["vortex", "--least-ratio", "0.5"], "least ratio 0.5"),
        (&["vortex", "--least-ratio", "-0.1"], "least ratio -0.1"),
        (&["vortex", "--turn", "0"], "turn by at most 0"),
        (&["vortex", "--turn", "-3"], "turn by at most"),
        (&["rotation", "--speed", "nan"], "--speed NaN"),
    ] {
        let said_of = fails(&[&["advect", argument(&path), "--flow"], words].concat());
        assert!(said_of.contains(said) && said_of.contains("; "), "{words:?}: {said_of}");
    }
    for words in [&["vortex", "--frames", "0"][..], &["deformation", "--vortices", "0"], &["drift"]] {
        let run = coface(&[&["yin", "advect", argument(&path), "--flow"], words].concat());
        assert_eq!(run.status, 2, "{words:?}");
    }
    // Of several files none is written if one cannot be.
    let output = folder.path().join("way.wkt");
    let said = fails(&[
        "advect",
        argument(&path),
        "--flow",
        "translation",
        "--frames",
        "2",
        "-o",
        argument(&output),
    ]);
    assert!(said.contains("way-001.wkt") && said.contains("--flatten"), "{said}");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// The vortex by its name and by its expressions, there and at the middle of its period; a turn by "-y; x" keeps the area.
#[test]
fn velocities_are_expressions() {
    let folder = tempfile::tempdir().unwrap();
    let path = disk(&folder, 4);
    let text = "sin(pi*x)^2*sin(2*pi*y)*cos(pi*t/T); -sin(pi*y)^2*sin(2*pi*x)*cos(pi*t/T)";
    let common = ["advect", argument(&path), "--spacing", "0.01", "--step", "0.05", "--period", "2"];
    let named = yin(&[&common[..], &["--flow", "vortex", "--time", "1"]].concat());
    let written = yin(&[&common[..], &["--velocity", text, "--time", "1"]].concat());
    for key in ["area", "perimeter"] {
        assert!((number(&named, key) - number(&written, key)).abs() < 1e-9, "{key}");
    }
    // With T the motion ends after a period, without it at time 1.
    assert_eq!(yin(&[&common[..], &["--velocity", text]].concat())["time"], json!(2.0));
    let turned = yin(&[&common[..], &["--velocity", "-(y - 0.5); x - 0.5"]].concat());
    assert_eq!(turned["time"], json!(1.0));
    assert!((number(&turned, "area") - number(&turned, "area_before")).abs() < 1e-6);
    for (text, said) in [
        ("x^2", "--velocity: there is one expression"),
        ("x; 2*z", "--velocity: column 6: \"z\" is not known"),
        ("1/(x - x); 0", "leads to no finite point"),
        ("x; y); 1", "there are 3 expressions"),
    ] {
        let error = fails(&[&common[..], &["--velocity", text]].concat());
        assert!(error.contains(said), "{text}: {error}");
    }
}

/// Two disks whose gap is exp(-t)/2.
fn two_disks(folder: &TempDir) -> PathBuf {
    let curves = json!([{"points": ring([-1.25, 0.0], 1.0, 96)}, {"points": ring([1.25, 0.0], 1.0, 96)}]);
    file(folder, "two.json", &json!({"order": 4, "curves": curves}))
}

#[test]
fn events_are_listed_with_times_and_places() {
    let folder = tempfile::tempdir().unwrap();
    let path = two_disks(&folder);
    let output = folder.path().join("one.json");
    let common = ["advect", argument(&path), "--velocity", "-x; 0", "--time", "2.6", "--step", "0.1"];
    let contact = ["--spacing", "0.05", "--contact-distance", "0.05"];
    let merged = yin(&[&common[..], &contact, &["--on-contact", "merge", "-o", argument(&output)]].concat());
    let [event] = &merged["events"].as_array().unwrap()[..] else { panic!("{merged}") };
    assert_eq!(event["kind"], "components-merge");
    assert_eq!(event["before"], json!({"components": 2, "holes": 0}));
    assert_eq!(event["after"], json!({"components": 1, "holes": 0}));
    assert!((number(event, "time") - 10.0f64.ln()).abs() < 2e-3, "{event}");
    assert!(event["place"][0].as_f64().unwrap().abs() < 1e-3, "{event}");
    assert_eq!((&merged["event_tolerance"], &merged["contact_distance"]), (&json!(1e-4), &json!(0.05)));
    assert_eq!(merged["betti_open"], json!([1, 0]));
    let remark = merged["remarks"].as_array().unwrap().iter().find(|own| own["code"] == "topology-repaired");
    assert!(remark.unwrap()["message"].as_str().unwrap().contains("two components merge"), "{merged}");
    assert_eq!(yin(&["info", argument(&output)])["betti_open"], json!([1, 0]));
    // Times are finer on request, the same through files of the way.
    let fine = ["--on-contact", "merge", "--event-tolerance", "1e-7", "--frames", "3"];
    let fine = yin(&[&common[..], &contact, &fine].concat());
    assert!((number(&fine["events"][0], "time") - 10.0f64.ln()).abs() < 1e-4, "{fine}");
    assert_eq!(fine["events"].as_array().unwrap().len(), 1);
    // Kept, with a remark and one event, through files of the way too.
    let kept = yin(&[&common[..], &contact, &["--on-contact", "keep", "--frames", "4"]].concat());
    assert_eq!(kept["events"].as_array().unwrap().len(), 1, "{kept}");
    assert_eq!((&kept["events"][0]["kind"], &kept["betti_open"]), (&json!("contact"), &json!([2, 0])));
    assert!(kept["remarks"].as_array().unwrap().iter().any(|own| own["code"] == "contacts-kept"), "{kept}");
    // Without contacts there is nothing to list; without --events there is no list.
    let none = yin(&[&common[..], &["--spacing", "0.05", "--events"]].concat());
    assert_eq!((&none["events"], &none["contact_distance"]), (&json!([]), &Value::Null));
    let plain = yin(&[&common[..], &["--spacing", "0.05"]].concat());
    assert_eq!((&plain["events"], &plain["event_tolerance"]), (&Value::Null, &Value::Null));
    let text = coface(&[&["yin"], &common[..], &contact, &["--on-contact", "merge", "--quiet"]].concat());
    assert!(text.stdout.contains("two components merge"), "{}", text.stdout);
    assert!(text.stdout.contains("2 components, 0 holes -> 1 component,"), "{}", text.stdout);
}

#[test]
fn what_vanishes_is_an_event() {
    let folder = tempfile::tempdir().unwrap();
    let path = disk(&folder, 4);
    let common =
        ["advect", argument(&path), "--velocity", "0.5-x; 0.75-y", "--time", "5", "--spacing", "0.05"];
    let gone = yin(&[&common[..], &["--events", "--event-tolerance", "1e-3"]].concat());
    let [event] = &gone["events"].as_array().unwrap()[..] else { panic!("{gone}") };
    assert_eq!((&event["kind"], &event["after"]["components"]), (&json!("component-vanishes"), &json!(0)));
    // The perimeter is three times the least distance.
    let latest = (std::f64::consts::TAU * 0.15 / 0.015).ln();
    assert!((number(event, "time") - latest).abs() < 0.3, "{event} {latest}");
    assert_eq!(event["time"], gone["vanished"][0]["time"]);
    assert_eq!(yin(&[&common[..], &["--events", "--keep-small"]].concat())["events"], json!([]));
    for (words, said) in [
        (&["--contact-distance", "0", "--on-contact", "merge"][..], "--contact-distance 0"),
        (&["--event-tolerance", "-1", "--events"], "--event-tolerance -1"),
        (&["--events", "--verify", "never"], "leave out --verify"),
    ] {
        let error = fails(&[&common[..], words].concat());
        assert!(error.contains(said), "{words:?}: {error}");
    }
    let wrong = [&["yin"], &common[..], &["--contact-distance", "1"]].concat();
    assert_eq!(coface(&wrong).status, 2);
}

#[test]
fn fronts_that_are_pressed_together_end_and_each_remark_comes_once() {
    let folder = tempfile::tempdir().unwrap();
    let disks = [-1.2, 1.2].map(|x| json!({"points": ring([x, 0.0], 1.0, 8)}));
    let path = file(&folder, "few.json", &json!({"order": 4, "curves": disks}));
    let common = ["yin", "advect", argument(&path), "--velocity", "max(-1, min(1, -20*x)); 0"];
    let steps = ["--time", "0.8", "--step", "0.05", "--spacing", "0.25", "--on-contact", "merge"];
    let run = coface(&[&common[..], &steps, &["--contact-distance", "1e-2", "--json"]].concat());
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert_eq!(run.json()["curves"].as_array().map(Vec::len), Some(1), "no sliver is left");
    let mut lines: Vec<&str> = run.stderr.lines().collect();
    let count = lines.len();
    lines.sort_unstable();
    lines.dedup();
    assert!(count > 0 && lines.len() == count, "{}", run.stderr);
    assert!(run.stderr.contains("narrower than half of the contact distance"), "{}", run.stderr);
}
