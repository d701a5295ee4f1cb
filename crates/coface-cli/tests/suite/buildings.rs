//! Buildings as one file: objects as inputs, and the graph of the cells.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_in};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// The example of `docs/buildings.md`: two rooms of 4 by 3 by 2.5 with a partition of 0.2 between them, walls and
/// slabs of 0.2, a door in the
/// partition and one to the outside, both 0.9 wide and 2.1 high.
const ROOMS: [(&str, [f64; 3], [f64; 3]); 9] = [
    ("floor", [-0.2, -0.2, -0.2], [8.4, 3.2, 0.0]),
    ("ceiling", [-0.2, -0.2, 2.5], [8.4, 3.2, 2.7]),
    ("wall_south", [-0.2, -0.2, 0.0], [8.4, 0.0, 2.5]),
    ("wall_north", [-0.2, 3.0, 0.0], [8.4, 3.2, 2.5]),
    ("wall_west", [-0.2, 0.0, 0.0], [0.0, 3.0, 2.5]),
    ("wall_east", [8.2, 0.0, 0.0], [8.4, 3.0, 2.5]),
    ("partition", [4.0, 0.0, 0.0], [4.2, 3.0, 2.5]),
    ("door_inside", [4.0, 1.0, 0.0], [4.2, 1.9, 2.1]),
    ("door_outside", [1.0, -0.2, 0.0], [1.9, 0.0, 2.1]),
];

fn rooms() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/rooms.obj")
}

/// Boxes as one OBJ with an object each; polygons run counterclockwise seen from outside.
fn boxes(boxes: &[(&str, [f64; 3], [f64; 3])]) -> String {
    let mut lines = Vec::new();
    for (number, (name, low, high)) in boxes.iter().enumerate() {
        lines.push(format!("o {name}"));
        for corner in 0..8 {
            let at = |axis: usize| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] };
            lines.push(format!("v {} {} {}", at(0), at(1), at(2)));
        }
        for side in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
            let [a, b, c, d] = side.map(|corner| 8 * number + corner + 1);
            lines.push(format!("f {a} {b} {c} {d}"));
        }
    }
    lines.push(String::new());
    lines.join("\n")
}

/// What is in a list of numbers of inputs, by name.
fn names(value: &Value, graph: &Value) -> Vec<String> {
    let name = |input: &Value| graph["inputs"][input.as_u64().unwrap() as usize].as_str().unwrap().to_owned();
    value.as_array().unwrap().iter().map(name).collect()
}

fn is_near(value: &Value, truth: f64) -> bool {
    (value.as_f64().unwrap() - truth).abs() < 1e-9
}

#[test]
fn the_rooms_of_the_page_are_these_boxes() {
    assert_eq!(std::fs::read_to_string(rooms()).unwrap(), boxes(&ROOMS));
}

#[test]
fn rooms_are_cells_between_walls_and_areas_are_those_of_the_drawing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rooms.json");
    let file = rooms();
    let arguments = ["arrange", argument(&file), "--inputs", "objects", "--json", "--graph", argument(&path)];
    let answer = coface(&arguments).json();
    assert_eq!(answer["regions"].as_array().unwrap().len(), 9);
    assert_eq!(answer["remarks"], json!([]));
    let graph: Value = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    let nodes = graph["nodes"].as_array().unwrap();
    // Two rooms, six walls and slabs with two doors cut out of two of them, and the partition.
    assert_eq!(nodes.len(), 11);
    let rooms: Vec<&Value> = nodes.iter().filter(|node| node["inputs"] == json!([])).collect();
    assert_eq!(rooms.len(), 2);
    let left = rooms.iter().find(|room| is_near(&room["centroid"][0], 2.0)).unwrap();
    let right = rooms.iter().find(|room| is_near(&room["centroid"][0], 6.2)).unwrap();
    for (room, x) in [(left, [0.0, 4.0]), (right, [4.2, 8.2])] {
        assert!(is_near(&room["volume"], 4.0 * 3.0 * 2.5), "{room}");
        assert_eq!(room["bounds"], json!([[x[0], 0.0, 0.0], [x[1], 3.0, 2.5]]));
        assert_eq!((&room["exterior"], &room["exterior_area"]), (&json!(false), &json!(0.0)));
    }
    // The node that lies in exactly these inputs.
    let node = |inputs: &[&str]| {
        let found: Vec<&Value> =
            nodes.iter().filter(|node| names(&node["inputs"], &graph) == inputs).collect();
        assert_eq!(found.len(), 1, "{inputs:?}");
        found[0]["cell"].clone()
    };
    let between = |a: &Value, b: &Value| {
        let cells = if a.as_u64() < b.as_u64() { json!([a, b]) } else { json!([b, a]) };
        graph["edges"].as_array().unwrap().iter().find(|edge| edge["cells"] == cells)
    };
    let door = 0.9 * 2.1;
    let area =
        |room: &Value, inputs: &[&str]| between(&room["cell"], &node(inputs)).map(|edge| &edge["area"]);
    for room in [left, right] {
        assert!(is_near(area(room, &["floor"]).unwrap(), 4.0 * 3.0));
        assert!(is_near(area(room, &["ceiling"]).unwrap(), 4.0 * 3.0));
        assert!(is_near(area(room, &["partition"]).unwrap(), 3.0 * 2.5 - door));
        assert!(is_near(area(room, &["partition", "door_inside"]).unwrap(), door));
        assert!(is_near(area(room, &["wall_north"]).unwrap(), 4.0 * 2.5));
    }
    assert!(is_near(area(left, &["wall_south"]).unwrap(), 4.0 * 2.5 - door));
    assert!(is_near(area(left, &["wall_south", "door_outside"]).unwrap(), door));
    assert!(is_near(area(right, &["wall_south"]).unwrap(), 4.0 * 2.5));
    assert!(area(right, &["wall_west"]).is_none() && area(right, &["wall_south", "door_outside"]).is_none());
    let edge = between(&left["cell"], &node(&["partition", "door_inside"])).unwrap();
    assert_eq!(names(&edge["inputs"], &graph), ["partition", "door_inside"]);
    assert_eq!(edge["faces"], json!(1));
    // The skin: the door to the outside, and all of it.
    let entrance = &nodes[node(&["wall_south", "door_outside"]).as_u64().unwrap() as usize];
    assert!(is_near(&entrance["exterior_area"], door) && entrance["exterior"] == json!(true));
    let skin: f64 = nodes.iter().map(|node| node["exterior_area"].as_f64().unwrap()).sum();
    let (x, y, z) = (8.6, 3.4, 2.9);
    assert!((skin - 2.0 * (x * y + y * z + z * x)).abs() < 1e-9, "{skin}");
    let volume: f64 = nodes.iter().map(|node| node["volume"].as_f64().unwrap()).sum();
    assert!((volume - x * y * z).abs() < 1e-9, "{volume}");
}

#[test]
fn graphs_are_graphml_too_and_other_files_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rooms.graphml");
    let rooms = rooms();
    let run = coface(&["arrange", argument(&rooms), "--inputs", "objects", "--graph", argument(&path)]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let text = std::fs::read_to_string(&path).unwrap();
    assert_eq!(text.matches("<node id=").count(), 11);
    assert!(text.contains("<data key=\"node_inputs\">partition; door_inside</data>"), "{text}");
    let refused = folder.path().join("rooms.dot");
    let run = coface(&["arrange", argument(&rooms), "--graph", argument(&refused)]);
    assert!(run.fails_with(1).contains("name a .json or .graphml file"));
    assert!(!refused.exists());
}

#[test]
fn objects_stay_objects_in_what_is_written() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("rooms.obj"), boxes(&ROOMS)).unwrap();
    let arguments = ["arrange", "rooms.obj", "--inputs", "objects", "-o", "cells.obj"];
    assert_eq!(coface_in(folder.path(), &arguments).status, 0);
    let text = std::fs::read_to_string(folder.path().join("cells.obj")).unwrap();
    assert!(text.contains("door_inside") && text.contains("cell_0"));
    // All walls as one solid with the rooms as its voids, and the partition without its door.
    let volume = |arguments: &[&str]| coface_in(folder.path(), arguments).json()["measure"].as_f64().unwrap();
    let walls = volume(&["boolean", "union", "rooms.obj", "--inputs", "objects", "--json"]);
    assert!((walls - (8.6 * 3.4 * 2.9 - 60.0)).abs() < 1e-9, "{walls}");
    let without_door = volume(&["boolean", "--formula", "6 - 7", "rooms.obj", "--json"]);
    assert!((without_door - 0.2 * (7.5 - 0.9 * 2.1)).abs() < 1e-9, "{without_door}");
    // What was converted has its objects too.
    for [from, to] in [["rooms.obj", "again.obj"], ["again.obj", "third.obj"]] {
        assert_eq!(coface_in(folder.path(), &["convert", from, "-o", to]).status, 0, "{to}");
        let answer = coface_in(folder.path(), &["arrange", to, "--inputs", "objects", "--json"]).json();
        assert_eq!(answer["regions"].as_array().map(Vec::len), Some(9), "{to}");
    }
}

#[test]
fn words_for_inputs_that_are_none_are_wrong_usage() {
    let rooms = rooms();
    let run = coface(&["arrange", argument(&rooms), "--inputs", "rooms"]);
    let message = run.fails_with(2);
    for word in ["files", "features", "objects", "groups", "components"] {
        assert!(message.contains(word), "{message}");
    }
    let run = coface(&["arrange", argument(&rooms), "--inputs", "groups"]);
    assert!(run.fails_with(1).contains("it has 9 objects: --inputs objects"));
}

/// The commands of the page of buildings, each behind `$`, and what they print; dots stand for lines that are left out.
#[test]
fn the_commands_of_the_page_print_what_stands_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = std::fs::read_to_string(root.join("docs/buildings.md")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("docs")).unwrap();
    std::fs::copy(rooms(), folder.path().join("docs/rooms.obj")).unwrap();
    let mut count = 0;
    for block in page.split("```console\n").skip(1) {
        let block = block.split("```").next().unwrap();
        let (line, expected) = block.split_once('\n').unwrap();
        let arguments: Vec<&str> = line
            .strip_prefix("$ coface ")
            .unwrap()
            .split('"')
            .enumerate()
            .flat_map(|(i, part)| match i % 2 {
                0 => part.split_whitespace().collect::<Vec<_>>(),
                _ => vec![part],
            })
            .collect();
        let run = coface_in(folder.path(), &arguments);
        assert_eq!(run.status, 0, "{line}: {}", run.stderr);
        let printed: Vec<&str> = run.stdout.lines().chain(run.stderr.lines()).map(str::trim_end).collect();
        let mut rest = &printed[..];
        for part in expected.split("  ...\n") {
            let part: Vec<&str> = part.lines().collect();
            let at = rest.windows(part.len().max(1)).position(|lines| lines == part);
            assert!(at.is_some() || part.is_empty(), "{line} prints\n{}", printed.join("\n"));
            rest = &rest[at.unwrap_or(0) + part.len()..];
        }
        count += 1;
    }
    assert_eq!(count, 3);
}

/// Boxes that lie in brick bond, turned: the tops of walls of one row meet the walls of the next in the shape of a T.
fn bond(path: &Path) {
    let mut text = String::new();
    let mut first = 1;
    let (sine, cosine) = std::f64::consts::FRAC_PI_6.sin_cos();
    for number in 0..8 {
        let (column, row) = (number % 4, number / 4);
        let low = [4.0 * f64::from(column) + 2.0 * f64::from(row % 2), 3.0 * f64::from(row), 0.0];
        let high = [low[0] + 4.0, low[1] + 3.0, 2.5];
        writeln!(text, "o room{number}").unwrap();
        for corner in 0..8 {
            let [x, y, z] =
                [0, 1, 2].map(|axis| if corner >> axis & 1 == 1 { high[axis] } else { low[axis] });
            writeln!(text, "v {:?} {:?} {z:?}", x * cosine - y * sine, x * sine + y * cosine).unwrap();
        }
        for face in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
            let [a, b, c, d] = face.map(|corner| corner + first);
            writeln!(text, "f {a} {b} {c} {d}").unwrap();
        }
        first += 8;
    }
    std::fs::write(path, text).unwrap();
}

#[test]
fn rooms_in_bond_are_one_cell_each_by_congruence() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bond.obj");
    bond(&path);
    let (mesh, chains) = (folder.path().join("cells.obj"), folder.path().join("cells.json"));
    let by =
        ["arrange", argument(&path), "--inputs", "objects", "--method", "congruence", "--tolerance", "1e-6"];
    let answer = coface(&[&by[..], &["--json", "-o", argument(&mesh)]].concat()).json();
    assert_eq!(answer["f_vector"][3], json!(8));
    assert!(answer["measures"].as_array().unwrap().iter().all(|volume| is_near(volume, 30.0)));
    let mut inside: Vec<u64> = answer["inside"]
        .as_array()
        .unwrap()
        .iter()
        .map(|inputs| {
            assert_eq!(inputs.as_array().unwrap().len(), 1);
            inputs[0].as_u64().unwrap()
        })
        .collect();
    inside.sort_unstable();
    assert_eq!(inside, [0, 1, 2, 3, 4, 5, 6, 7]);
    assert!(answer["congruence"]["largest_class_diameter"].as_f64().unwrap() < 1e-12);
    let walls = std::fs::read_to_string(&mesh).unwrap();
    let is_named = |cell: usize| walls.contains(&format!("cell_{cell}"));
    assert!((0..8).all(is_named) && !is_named(8));
    // The cells go in again, and have the homology of a slab.
    assert_eq!(coface(&[&by[..], &["-o", argument(&chains)]].concat()).status, 0);
    let homology = coface(&["homology", argument(&chains), "--json"]).json();
    let betti: Vec<u64> = homology["homology"]
        .as_array()
        .unwrap()
        .iter()
        .map(|group| group["betti"].as_u64().unwrap())
        .collect();
    assert_eq!(betti, [1, 0, 0, 0]);
    let page = coface(&by);
    assert!(page.stdout.contains("stacked"), "{}", page.stdout);
}
