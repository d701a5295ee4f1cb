//! `coface diagram` as a user runs it.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{coface_in, coface_reading};
use serde_json::{Value, json};
use std::path::Path;

/// Heights of a path with two valleys, and others.
const PATHS: [(&str, &str); 2] = [("a.values", "0\n5\n1\n2\n"), ("b.values", "0\n4\n1.5\n2\n")];

fn folder_of_paths() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("path.json"), "[[0,1],[1,2],[2,3]]").unwrap();
    for (name, values) in PATHS {
        std::fs::write(folder.path().join(name), values).unwrap();
    }
    folder
}

fn written(folder: &Path, values: &str, output: &str) {
    let run = coface_in(folder, &["persistence", "path.json", "--function", values, "-o", output]);
    assert_eq!(run.status, 0, "{}", run.stderr);
}

/// Law 7: what `persistence` writes, `diagram` takes; all formats mean the same.
#[test]
fn every_format_that_is_written_is_read() {
    let folder = folder_of_paths();
    let place = folder.path();
    written(place, "b.values", "b.json");
    for name in ["a.json", "a.csv", "a.pers", "a.txt"] {
        written(place, "a.values", name);
        let answer =
            coface_in(place, &["diagram", "distance", name, "b.json", "--matching", "--json"]).json();
        assert_eq!(answer["distance"], 1.0, "{name}");
        assert_eq!(answer["degrees"][0]["matching"], json!([[0, 0], [1, 1]]), "{name}");
        assert_eq!(answer["metric"], "bottleneck");
        let same = coface_in(place, &["diagram", "distance", name, "a.json", "--json"]).json();
        assert_eq!(same["distance"], 0.0, "{name}");
    }
    let falling = ["persistence", "path.json", "--function", "a.values", "--upper-star", "-o"];
    for name in ["down.json", "down.csv", "down.pers", "down.txt"] {
        assert_eq!(coface_in(place, &[&falling[..], &[name]].concat()).status, 0);
        let answer = coface_in(place, &["diagram", "distance", name, "down.json", "--json"]).json();
        assert_eq!(answer["distance"], 0.0, "{name}");
        let against = coface_in(place, &["diagram", "distance", name, "a.json", "--json"]).json();
        assert_eq!(
            (&against["distance"], &against["degrees"][0]["essential"]),
            (&Value::Null, &json!([1, 1]))
        );
    }
}

#[test]
fn plain_tables_and_lists_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    for (name, text) in [
        ("table.csv", "0,inf,0\n1,3.5,1\n"),
        ("names.csv", "dimension;birth;death\n0;0;inf\n1;1;3.5\n"),
        ("empty_death.csv", "birth,death,dim\n0,,0\n1,3.5,1\n"),
        ("before.txt", "# GUDHI\n0 0 inf\n1 1 3.5\n"),
        ("gudhi.pers", "0 0 inf\n1 1 3.5\n"),
        ("gudhi.json", "[[0,[0,null]],[1,[1,3.5]]]"),
        ("ripser.json", "[[[0,null]],[[1,3.5]]]"),
        (
            "ripser.txt",
            "value range: [0,9]\npersistence intervals in dim 0:\n [0, )\npersistence intervals in dim 1:\n [1,3.5)\n",
        ),
    ] {
        std::fs::write(place.join(name), text).unwrap();
        let answer = coface_in(place, &["diagram", "betti", name, "--json"]).json();
        assert_eq!(answer["values"], json!([0.0, 1.0, 3.5]), "{name}");
        assert_eq!(answer["curves"][0]["numbers"], json!([1.0, 1.0, 1.0]), "{name}");
        assert_eq!(answer["curves"][1]["numbers"], json!([0.0, 1.0, 0.0]), "{name}");
    }
    let piped = coface_reading(&["diagram", "betti", "-", "--json"], b"0 1\n");
    assert_eq!(piped.json()["curves"][0]["numbers"], json!([1.0, 0.0]));
    let nothing = coface_reading(&["diagram", "betti", "-", "--json"], b"");
    assert_eq!(nothing.json()["curves"], json!([]));
}

#[test]
fn all_formats_keep_the_direction_of_values() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("image.pgm"), "P2\n3 2\n9\n0 1 2\n3 4 5\n").unwrap();
    for (name, direction) in [("up", &[][..]), ("down", &["--superlevel"])] {
        for extension in ["json", "txt", "csv", "pers"] {
            let out = format!("{name}.{extension}");
            let words = [&["persistence", "image.pgm", "-q", "-o", &out], direction].concat();
            assert_eq!(coface_in(place, &words).status, 0);
            let own = format!("{name}.json");
            let answer = coface_in(place, &["diagram", "distance", &out, &own, "--json"]).json();
            assert_eq!(answer["distance"], 0.0, "{out}");
        }
    }
    let run = coface_in(place, &["diagram", "distance", "up.txt", "down.txt"]);
    assert!(run.stdout.contains("here while values rise"), "{}", run.stdout);
}

#[test]
fn curves_and_images_are_written_as_tables_and_arrays() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("a.csv"), "0 4\n1 3\n").unwrap();
    let task = ["diagram", "landscape", "a.csv", "--count", "2", "--samples", "5", "-o"];
    for name in ["l.csv", "l.npy", "l.json"] {
        assert_eq!(coface_in(place, &[&task[..], &[name]].concat()).status, 0);
    }
    let csv = std::fs::read_to_string(place.join("l.csv")).unwrap();
    assert_eq!(
        csv,
        "value,landscape 1 of degree 0,landscape 2 of degree 0\n0,0,0\n1,1,0\n2,2,1\n3,1,0\n4,0,0\n"
    );
    let array = coface::io::NumberTable::read_path(place.join("l.npy")).unwrap();
    assert_eq!((array.row_count(), array.row(1)), (3, &[0.0, 1.0, 2.0, 1.0, 0.0][..]));
    let written: Value = serde_json::from_slice(&std::fs::read(place.join("l.json")).unwrap()).unwrap();
    assert_eq!(written["curves"][1]["numbers"], json!([0.0, 0.0, 1.0, 0.0, 0.0]));
    let image = ["diagram", "image", "a.csv", "--degree", "0", "--resolution", "3", "2", "-o", "i.npy"];
    assert_eq!(coface_in(place, &image).status, 0);
    let array = coface::io::NumberTable::read_path(place.join("i.npy")).unwrap();
    assert_eq!((array.row_count(), array.row(0).len()), (2, 3));
    let refused = coface_in(place, &["diagram", "betti", "a.csv", "-o", "a.off"]);
    assert_eq!(
        (refused.status, refused.stderr.contains("name the file so")),
        (1, true),
        "{}",
        refused.stderr
    );
}

/// The Euler characteristic of sublevel sets of a small image, cell by cell.
#[test]
fn euler_curves_of_images_count_cells() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let (width, height) = (5usize, 4usize);
    let values: Vec<i32> = (0..20).map(|i: i32| (i * i * 7 + i * 3) % 11).collect();
    let numbers: Vec<String> = values.iter().map(i32::to_string).collect();
    let header =
        format!("NRRD0004\ntype: double\ndimension: 2\nsizes: {width} {height}\nencoding: ascii\n\n");
    std::fs::write(place.join("a.nrrd"), header + &numbers.join(" ") + "\n").unwrap();
    assert_eq!(coface_in(place, &["persistence", "a.nrrd", "-o", "a.json"]).status, 0);
    let answer = coface_in(
        place,
        &["diagram", "euler", "a.json", "--samples", "12", "--range", "-0.5", "10.5", "--json"],
    );
    // Voxels are top cells: a side or a corner is there with the first voxel that it is of.
    let lives = |x: usize, y: usize, level: f64| f64::from(values[y * width + x]) <= level;
    let any = |mut xs: std::ops::Range<usize>, ys: std::ops::Range<usize>, level: f64| {
        xs.any(|x| ys.clone().any(|y| lives(x, y, level)))
    };
    let range = |doubled: usize, length: usize| match doubled % 2 {
        // An odd place is inside of a voxel, an even one between two.
        1 => doubled / 2..doubled / 2 + 1,
        _ => (doubled / 2).saturating_sub(1)..(doubled / 2 + 1).min(length),
    };
    let expected: Vec<f64> = (0..12)
        .map(|step| {
            let level = f64::from(step) - 0.5;
            let cells = (0..=2 * width).flat_map(|x| (0..=2 * height).map(move |y| (x, y)));
            let present = cells.filter(|&(x, y)| any(range(x, width), range(y, height), level));
            present.map(|(x, y)| if (x + y) % 2 == 0 { 1.0 } else { -1.0 }).sum()
        })
        .collect();
    assert_eq!(answer.json()["curves"][0]["numbers"], json!(expected));
}

#[test]
fn wasserstein_distances_have_orders_and_norms() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("a.csv"), "0 6\n5 6\n").unwrap();
    std::fs::write(place.join("b.csv"), "3 10\n").unwrap();
    let distance = |more: &[&str]| {
        let all =
            [&["diagram", "distance", "a.csv", "b.csv", "--metric", "wasserstein", "--json"], more].concat();
        let answer = coface_in(place, &all).json();
        assert_eq!(answer["degrees"][0]["distance"], answer["distance"]);
        answer["distance"].as_f64().unwrap()
    };
    assert_eq!(distance(&[]), 4.5);
    assert!((distance(&["--internal-p", "1", "--order", "2"]) - 50f64.sqrt()).abs() < 1e-14);
    let refused = coface_in(
        place,
        &["diagram", "distance", "a.csv", "b.csv", "--metric", "wasserstein", "--order", "inf"],
    );
    assert!(refused.status == 1 && refused.stderr.contains("bottleneck"), "{}", refused.stderr);
    let page = coface_in(place, &["diagram", "distance", "a.csv", "b.csv"]).stdout;
    assert!(page.contains("bottleneck distance of a.csv and b.csv") && page.contains("3.5"), "{page}");
}

#[test]
fn what_is_no_diagram_is_refused_with_its_place() {
    for (text, says) in [
        ("0 1\nx y\n", "standard input:2:"),
        ("0 1 2 3 4 5\n", "6 numbers"),
        ("0 nan\n", "interval 0"),
        ("{\"facets\":[[0,1]]}", "no \"diagram\""),
        ("[[0,1,2]]", "no class of a diagram"),
        ("{\"diagram\":[{\"degree\":-1,\"birth\":0,\"death\":1}]}", "no degree"),
        ("a,b\n0,1\n", "birth and death"),
        ("persistence intervals in dim 0:\n [x,1)\n", "standard input:2:"),
    ] {
        let run = coface_reading(&["diagram", "betti", "-"], text.as_bytes());
        assert!(run.status == 1 && run.stderr.contains(says), "{text:?}: {} {}", run.status, run.stderr);
    }
}

/// Classes that live on two ways are not counted as if there were one.
#[test]
fn classes_of_extended_persistence_are_not_counted() {
    let folder = folder_of_paths();
    for file in ["extended.json", "extended.csv"] {
        let line = ["persistence", "path.json", "--function", "a.values", "--extended", "-o", file];
        assert_eq!(coface_in(folder.path(), &line).status, 0);
        for verb in ["betti", "euler"] {
            let run = coface_in(folder.path(), &["diagram", verb, file]);
            assert!(run.fails_with(1).contains("classes of extended persistence"), "{verb} {file}");
        }
        assert_eq!(coface_in(folder.path(), &["diagram", "landscape", file]).status, 0, "{file}");
    }
}
