//! `coface persistence` of volumes as a user runs it.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{Run, coface_in, coface_reading};
use serde_json::{Value, json};
use std::path::Path;

/// What a run that succeeds prints.
fn text(run: &Run) -> &str {
    assert_eq!(run.status, 0, "{}", run.stderr);
    &run.stdout
}

/// An image as NRRD text, x fastest.
fn nrrd(shape: &[usize], numbers: &[f64]) -> String {
    let words = |list: &[String]| list.join(" ");
    let sizes: Vec<String> = shape.iter().map(usize::to_string).collect();
    let numbers: Vec<String> = numbers.iter().map(f64::to_string).collect();
    format!(
        "NRRD0004\ntype: double\ndimension: {}\nsizes: {}\nencoding: ascii\n\n{}\n",
        shape.len(),
        words(&sizes),
        words(&numbers)
    )
}

/// Four columns, three rows: dark pixels that share a corner, at (0, 0) and (1, 1), and one at (3, 2).
const CORNERS: [f64; 12] = [0.0, 9.0, 9.0, 9.0, 9.0, 1.0, 9.0, 9.0, 9.0, 9.0, 8.0, 2.0];

fn pairs(folder: &Path, arguments: &[&str]) -> Vec<(u64, f64, Option<f64>, Value)> {
    let all = [&["persistence"], arguments, &["--json"]].concat();
    let answer = coface_in(folder, &all).json();
    let pair = |pair: &Value| {
        let degree = pair["degree"].as_u64().unwrap();
        (degree, pair["birth"].as_f64().unwrap(), pair["death"].as_f64(), pair["birth_cell"].clone())
    };
    answer["diagram"].as_array().unwrap().iter().map(pair).collect()
}

#[test]
fn voxels_are_top_cells_or_vertices() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("a.nrrd"), nrrd(&[4, 3], &CORNERS)).unwrap();
    let t = [(0, 0.0, None, json!([0, 0])), (0, 2.0, Some(8.0), json!([3, 2]))];
    assert_eq!(pairs(place, &["a.nrrd"]), t);
    let v = [
        (0, 0.0, None, json!([0, 0])),
        (0, 1.0, Some(9.0), json!([1, 1])),
        (0, 2.0, Some(9.0), json!([3, 2])),
    ];
    assert_eq!(pairs(place, &["a.nrrd", "--construction", "v"]), v);
    let answer = coface_in(place, &["persistence", "a.nrrd", "--superlevel", "--json"]).json();
    assert_eq!((&answer["function"], &answer["star"]), (&json!("voxels, t-construction"), &json!("upper")));
    assert_eq!(answer["betti"], json!([1, 0, 0]));
    assert_eq!(answer["diagram"][0]["birth"], json!(9.0));
    let run = coface_in(place, &["persistence", "a.nrrd"]);
    let page = text(&run);
    assert!(page.contains("function: voxels, t-construction, sublevel sets"), "{page}");
    let whole = coface_reading(&["persistence", "-", "--json"], nrrd(&[4, 3], &CORNERS).as_bytes()).json();
    assert_eq!(whole["diagram"], coface_in(place, &["persistence", "a.nrrd", "--json"]).json()["diagram"]);
}

#[test]
fn masks_and_periodic_axes() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("a.nrrd"), nrrd(&[4, 1], &[0.0, 5.0, 1.0, 7.0])).unwrap();
    std::fs::write(place.join("mask.nrrd"), nrrd(&[4, 1], &[1.0, 0.0, 1.0, 1.0])).unwrap();
    let plain = pairs(place, &["a.nrrd"]);
    assert_eq!(plain.iter().map(|pair| pair.2).collect::<Vec<_>>(), [None, Some(5.0)]);
    let masked = pairs(place, &["a.nrrd", "--mask", "mask.nrrd"]);
    assert_eq!(masked.iter().map(|pair| pair.2).collect::<Vec<_>>(), [None, None]);
    let around = pairs(place, &["a.nrrd", "--periodic", "x"]);
    assert_eq!(
        around.iter().map(|pair| (pair.0, pair.1)).collect::<Vec<_>>(),
        [(0, 0.0), (0, 1.0), (1, 7.0)]
    );
    std::fs::write(place.join("other.nrrd"), nrrd(&[1, 4], &[1.0; 4])).unwrap();
    let message =
        coface_in(place, &["persistence", "a.nrrd", "--mask", "other.nrrd"]).fails_with(1).to_owned();
    assert!(message.contains("other.nrrd: the mask has the shape [1, 4], and the image [4, 1]"), "{message}");
}

#[test]
fn files_of_diagrams_have_voxels() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("a.nrrd"), nrrd(&[4, 3], &CORNERS)).unwrap();
    text(&coface_in(place, &["persistence", "a.nrrd", "-o", "a.csv"]));
    let table = std::fs::read_to_string(place.join("a.csv")).unwrap();
    assert_eq!(table, "degree,birth,death,birth_cell,death_cell\n0,0,inf,0 0,\n0,2,8,3 2,2 2\n");
    text(&coface_in(place, &["persistence", "a.nrrd", "--superlevel", "-o", "a.pers"]));
    assert!(std::fs::read_to_string(place.join("a.pers")).unwrap().starts_with("2 0 9 -inf\n"));
    text(&coface_in(place, &["persistence", "a.nrrd", "-o", "a.json"]));
    text(&coface_in(place, &["render", "a.json", "--diagram", "-o", "a.svg"]));
}

/// Where voxels are chosen, or a function is given, the set voxels are the model, as they are for every verb.
#[test]
fn chosen_voxels_are_a_model() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("a.nrrd"), nrrd(&[4, 3], &CORNERS)).unwrap();
    for arguments in [&["--threshold", "9"][..], &["--function", "x"]] {
        let all = [&["persistence", "a.nrrd", "--json"], arguments].concat();
        let answer = coface_in(place, &all).json();
        assert!(["x", "y"].contains(&answer["function"].as_str().unwrap()), "{answer}");
    }
    let message = coface_in(place, &["persistence", "a.nrrd", "--threshold", "9", "--superlevel"])
        .fails_with(1)
        .to_owned();
    assert!(message.contains("a.nrrd: --superlevel is for the values of a volume"), "{message}");
    std::fs::write(place.join("a.json"), "[[0,1]]").unwrap();
    let message =
        coface_in(place, &["persistence", "a.json", "--construction", "v"]).fails_with(1).to_owned();
    assert!(message.contains("a.json: --construction is for the values of a volume"), "{message}");
}

#[test]
fn memory_is_foretold() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("a.nrrd"), nrrd(&[64, 64, 64], &vec![1.0; 64 * 64 * 64])).unwrap();
    let message = coface_in(place, &["persistence", "a.nrrd", "--memory", "4MB"]).fails_with(1).to_owned();
    assert!(message.contains("memory"), "{message}");
}

#[test]
fn a_voxel_at_infinity_is_named_by_the_axes_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let numbers = [1.0, f64::NEG_INFINITY, 2.0, 3.0, 4.0, f64::INFINITY];
    std::fs::write(folder.path().join("a.nrrd"), nrrd(&[2, 3], &numbers)).unwrap();
    let said = |options: &[&str]| {
        let run = coface_in(folder.path(), &[&["persistence", "a.nrrd"], options].concat());
        run.fails_with(1).to_owned()
    };
    assert!(said(&[]).contains("voxel [1, 0] is at -inf"), "{}", said(&[]));
    assert!(said(&["--superlevel"]).contains("voxel [1, 2] is at inf"));
    let wrong = coface_in(folder.path(), &["persistence", "a.nrrd", "--coefficients", "f4"]);
    assert!(wrong.fails_with(2).contains("no prime field of 4 elements; give a prime field: f2"));
}

#[test]
fn classes_have_cycles_on_the_cells_of_voxels() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let ring = [1.0, 1.0, 1.0, 1.0, 9.0, 1.0, 1.0, 1.0, 1.0];
    std::fs::write(place.join("ring.nrrd"), nrrd(&[3, 3], &ring)).unwrap();
    let run = coface_in(place, &["persistence", "ring.nrrd", "--cycles", "cycles.obj", "--json"]);
    let answer = run.json();
    let rim = &answer["diagram"][1];
    assert_eq!(
        (&rim["birth"], &rim["death"], &rim["death_cell"]),
        (&json!(1.0), &json!(9.0), &json!([1, 1]))
    );
    // Through a side of the pixel that comes last and closes the ring, around this one and the one in the middle.
    assert_eq!(rim["cycle"].as_array().unwrap().len(), 6);
    assert_eq!(rim["bounding_chain"].as_array().unwrap().len(), 2);
    assert_eq!(answer["torsion_primes"], json!([]));
    // The picture is a file as any other: the group of the loop is one closed line.
    let group = coface_in(place, &["info", "cycles.obj#H1_0_from_1_to_9", "--json"]).json();
    assert_eq!((&group["f_vector"], &group["components"]), (&json!([6, 6]), &json!(1)), "{group}");
    // Voxels as vertices: the ring goes through eight of them.
    let answer =
        coface_in(place, &["persistence", "ring.nrrd", "--cycles", "--construction", "v", "--json"]).json();
    assert_eq!(answer["diagram"][1]["cycle"].as_array().unwrap().len(), 8);
    // Without cycles the classes are the same.
    let plain = coface_in(place, &["persistence", "ring.nrrd", "--construction", "v", "--json"]).json();
    for (a, b) in plain["diagram"].as_array().unwrap().iter().zip(answer["diagram"].as_array().unwrap()) {
        for key in ["degree", "birth", "death", "birth_cell", "death_cell"] {
            assert_eq!(a[key], b[key]);
        }
    }
}

#[test]
fn euler_curves_of_images_are_those_of_their_diagrams() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("a.nrrd"), nrrd(&[4, 3], &CORNERS)).unwrap();
    for options in
        [&[][..], &["--construction", "v"], &["--superlevel"], &["--construction", "v", "--superlevel"]]
    {
        let of_diagram = [&["persistence", "a.nrrd", "-o", "d.json", "-q"], options].concat();
        assert_eq!(coface_in(place, &of_diagram).status, 0);
        let range = ["--samples", "21", "--range", "-1", "9", "--json"];
        let expected = coface_in(place, &[&["diagram", "euler", "d.json"], &range[..]].concat()).json();
        let counted = coface_in(place, &[&["euler", "a.nrrd"], &range[..], options].concat()).json();
        assert_eq!(counted["curves"][0], expected["curves"][0]["numbers"], "{options:?}");
    }
}

#[test]
fn euler_transforms_are_tables() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("square.off"), "OFF\n4 1 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n4 0 1 2 3\n").unwrap();
    let run = coface_in(place, &["euler", "square.off", "--directions", "5", "--normalize", "-o", "ect.csv"]);
    assert_eq!((run.status, &run.stdout[..]), (0, ""), "{}", run.stderr);
    let table = std::fs::read_to_string(place.join("ect.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!((rows.len(), rows[0].len(), &rows[0][..4]), (6, 103, &["x", "y", "z", "-1"][..]));
    assert!(rows[1..].iter().all(|row| row[102] == "1"));
    // The same directions from a file, whose rows are not as long as a unit.
    let doubled: String = rows[1..]
        .iter()
        .map(|row| {
            row[..3]
                .iter()
                .map(|x| (2.0 * x.parse::<f64>().unwrap()).to_string())
                .collect::<Vec<_>>()
                .join(" ")
                + "\n"
        })
        .collect();
    std::fs::write(place.join("directions.txt"), doubled).unwrap();
    let again =
        coface_in(place, &["euler", "square.off", "--directions", "directions.txt", "--normalize", "--json"])
            .json();
    let numbers =
        |row: &Vec<&str>| json!(row[3..].iter().map(|x| x.parse::<f64>().unwrap()).collect::<Vec<_>>());
    assert_eq!(again["curves"], json!(rows[1..].iter().map(numbers).collect::<Vec<_>>()));
    let smooth = coface_in(place, &["euler", "square.off", "--directions", "4", "--smooth", "--json"]).json();
    assert_eq!(smooth["curves"][0][99], json!(0.0));
    let none =
        coface_in(place, &["euler", "square.off", "--directions", "directions.txt", "--function", "x"]);
    assert_eq!(none.status, 2);
    // What is about images is refused for models.
    let none = coface_in(place, &["euler", "square.off", "--superlevel"]);
    assert!(
        none.status == 1 && none.stderr.contains("--superlevel is for the values of a volume"),
        "{}",
        none.stderr
    );
    // The answer has directions, which are taken again.
    let of_json = ["euler", "square.off", "--directions", "ect.json", "--normalize", "--json"];
    assert_eq!(
        coface_in(place, &["euler", "square.off", "--directions", "5", "--normalize", "-o", "ect.json"])
            .status,
        0
    );
    assert_eq!(coface_in(place, &of_json).json()["curves"], again["curves"]);
}

/// What is no direction is told with its row, and nothing is answered about no directions.
#[test]
fn directions_that_are_none_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("edge.off"), "OFF\n2 1 0\n0 0 0\n2 0 0\n2 0 1\n").unwrap();
    for (name, text, message) in [
        ("words.txt", "a b c\n", "words.txt: there are no directions here"),
        ("empty.txt", "", "empty.txt: there are no directions here"),
        ("short.txt", "1 0 0\n1 0 0\n", ""),
        ("flat.txt", "1 0\n", "flat.txt: row 1: a direction has 2 coordinates, and positions have 3"),
        ("zero.txt", "1 0 0\n0 0 0\n", "zero.txt: row 2: [0.0, 0.0, 0.0] is no direction"),
        ("nan.txt", "nan 0 0\n", "nan.txt: row 1: [NaN, 0.0, 0.0] is no direction"),
        ("none.json", "[]", "none.json: there are no directions here"),
        ("diagram.json", "{\"diagram\":[]}", "diagram.json: there are no directions here"),
    ] {
        std::fs::write(place.join(name), text).unwrap();
        let run = coface_in(place, &["euler", "edge.off", "--directions", name]);
        assert_eq!(run.status, i32::from(!message.is_empty()), "{name}: {}", run.stderr);
        assert!(run.stderr.contains(message), "{name}: {}", run.stderr);
    }
}

/// The values of a volume are no function on vertices, and along directions it is the model of the voxels that are set.
#[test]
fn values_of_voxels_are_not_mistaken_for_heights() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("a.nrrd"), nrrd(&[4, 3], &CORNERS)).unwrap();
    std::fs::write(place.join("set.nrrd"), nrrd(&[2, 1], &[0.0, 5.0])).unwrap();
    for verb in ["euler", "persistence"] {
        let run = coface_in(place, &[verb, "a.nrrd", "--upper-star"]);
        assert!(run.status == 1 && run.stderr.contains("with --superlevel"), "{}", run.stderr);
        assert_eq!(coface_in(place, &[verb, "a.nrrd", "--upper-star", "--function", "x"]).status, 0);
    }
    let run = coface_in(place, &["euler", "a.nrrd", "--directions", "4", "--json"]);
    assert!(run.stderr.contains("the voxels that are not 0 are a model"), "{}", run.stderr);
    assert_eq!(run.json()["remarks"][0]["code"], json!("input-reading"));
    assert_eq!(coface_in(place, &["euler", "a.nrrd", "--directions", "4", "--strict"]).status, 1);
    for clear in [
        &["euler", "set.nrrd", "--directions", "4"][..],
        &["euler", "a.nrrd", "--directions", "4", "--threshold", "2"],
    ] {
        let run = coface_in(place, clear);
        assert_eq!((run.status, &run.stderr[..]), (0, ""));
    }
}

/// The diagram in parts is that without, in the voxels too, whatever the file, and what is finished is not made again.
#[test]
fn parts_have_the_diagram_of_the_whole() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let numbers: Vec<f64> = (0..9 * 7 * 8).map(|i| f64::from(i * i * 31 % 97)).collect();
    std::fs::write(place.join("text.nrrd"), nrrd(&[9, 7, 8], &numbers)).unwrap();
    let mask: Vec<f64> = (0..9 * 7 * 8).map(|i| f64::from(u8::from(i % 11 != 0))).collect();
    std::fs::write(place.join("mask.nrrd"), nrrd(&[9, 7, 8], &mask)).unwrap();
    let mut raw = b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 9 7 8\nencoding: raw\n\n".to_vec();
    raw.extend(numbers.iter().map(|&number| number as u8));
    std::fs::write(place.join("raw.nrrd"), raw).unwrap();
    for options in [
        &["text.nrrd"][..],
        &["raw.nrrd", "--superlevel", "--periodic", "x,z"],
        &["raw.nrrd", "--construction", "v", "--coefficients", "f3"],
        &["raw.nrrd", "--mask", "mask.nrrd", "--min-persistence", "5"],
    ] {
        let whole = coface_in(place, &[&["persistence", "--json"], options].concat()).json();
        for parts in ["1", "9"] {
            let all = [&["persistence", "--json", "--parts", parts, "--fan-in", "3"], options].concat();
            assert_eq!(coface_in(place, &all).json(), whole, "{options:?} {parts}");
        }
    }
    let words = ["persistence", "text.nrrd", "--parts", "4", "--work", "work", "--json"];
    let first = coface_in(place, &words).json();
    let part = place.join("work/block-000002.part");
    let written = |path: &Path| std::fs::metadata(path).unwrap().modified().unwrap();
    let made = written(&part);
    std::fs::write(place.join("work/block-000001.part"), "cut off").unwrap();
    assert_eq!(coface_in(place, &words).json(), first);
    assert_eq!(written(&part), made);
    // The copy of another volume of the same name is made anew.
    std::fs::write(place.join("text.nrrd"), nrrd(&[9, 7, 8], &mask)).unwrap();
    let other = coface_in(place, &words).json();
    assert_eq!(other, coface_in(place, &["persistence", "text.nrrd", "--json"]).json());
    let whole =
        coface_reading(&["persistence", "-", "--json", "--parts", "2"], nrrd(&[4, 3], &CORNERS).as_bytes());
    std::fs::write(place.join("a.nrrd"), nrrd(&[4, 3], &CORNERS)).unwrap();
    assert_eq!(
        whole.json()["diagram"],
        coface_in(place, &["persistence", "a.nrrd", "--json"]).json()["diagram"]
    );
    let infinite = nrrd(&[3, 2], &[0.0, 1.0, f64::NEG_INFINITY, 1.0, 1.0, 1.0]);
    std::fs::write(place.join("b.nrrd"), infinite).unwrap();
    let message = coface_in(place, &["persistence", "b.nrrd", "--parts", "2"]).fails_with(1).to_owned();
    assert!(message.contains("b.nrrd: voxel [2, 0] is at -inf"), "{message}");
}
