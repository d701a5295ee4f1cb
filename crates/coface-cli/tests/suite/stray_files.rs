//! Files as other programs and people write them: filled shapes, decimal commas, rounded distances, features with several parts.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::coface_in;
use serde_json::Value;
use std::path::Path;

fn write(folder: &Path, name: &str, text: impl AsRef<[u8]>) {
    std::fs::write(folder.join(name), text).unwrap();
}

/// What the program answers in a folder, without what stands on standard error.
fn answer(folder: &Path, line: &str) -> Value {
    let words: Vec<&str> = line.split(' ').chain(["--json", "--quiet"]).collect();
    coface_in(folder, &words).json()
}

fn remarks(answer: &Value) -> String {
    answer["remarks"].to_string()
}

#[test]
fn regions_of_drawings_are_what_is_filled() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    const SQUARE: &str = "<rect x='20' y='2' width='3' height='3'/>";
    for (inner, area) in [
        ("<rect width='10' height='10' fill='none' stroke='blue'/>", 9.0),
        ("<polyline points='0 0 4 0 4 3'/>", 15.0),
        ("<path d='M0 0h4v4M6 6h1v1h-1z'/>", 18.0),
        (
            "<style>.a{fill:none} .b{fill-rule:evenodd}</style><rect class='a' width='9' height='9'/><path class='b' d='M2 2h4v4h-4zM3 3h1v1h-1z'/>",
            24.0,
        ),
        ("<rect width='10' height='10' style='fill: none !important'/>", 9.0),
        ("<rect width='10' height='10' visibility='hidden'/>", 9.0),
        ("<path fill='none' d='M0 0h4v4'/><line x2='9' y2='9'/>", 9.0),
    ] {
        write(folder, "a.svg", format!("<svg xmlns='http://www.w3.org/2000/svg'>{inner}{SQUARE}</svg>"));
        let [united, set] = ["boolean union a.svg", "yin info a.svg"].map(|line| answer(folder, line));
        assert_eq!(united["measure"].as_f64(), Some(area), "{inner}");
        assert_eq!(set["area"].as_f64(), Some(area), "{inner}");
    }
    write(
        folder,
        "a.svg",
        format!("<svg xmlns='http://www.w3.org/2000/svg'><g fill='none'>{SQUARE}</g></svg>"),
    );
    for (line, key) in [("boolean union a.svg", "measure"), ("yin info a.svg", "area")] {
        let outlines = answer(folder, line);
        assert_eq!(outlines[key].as_f64(), Some(9.0));
        assert!(remarks(&outlines).contains("nothing is filled"), "{outlines}");
    }
}

#[test]
fn a_feature_of_a_map_keeps_its_polygons() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write(
        folder,
        "ab.geojson",
        r#"{"type":"FeatureCollection","features":[
        {"type":"Feature","id":"a","properties":{"name":"a"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,1],[0,0]]]}},
        {"type":"Feature","id":"b","properties":{"name":"b"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[2,2],[2,0],[0,2],[0,0]]]}}]}"#,
    );
    let near = answer(folder, "map buffer ab.geojson#a --distance 0.1")["measure"].as_f64().unwrap();
    assert!((near - 1.4313).abs() < 1e-3, "{near}");
    assert_eq!(answer(folder, "boolean union ab.geojson#a")["measure"].as_f64(), Some(1.0));
    answer(folder, "convert ab.geojson#a -o a.wkt");
    assert!(std::fs::read_to_string(folder.join("a.wkt")).unwrap().starts_with("POLYGON (("));
    assert!(answer(folder, "info ab.geojson#b")["polygons"].to_string().contains("crosses itself"));
}

#[test]
fn decimal_commas_are_read_with_a_remark() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for (name, text) in [
        ("comma.csv", "x;y\n0,5;1,25\n2,0;3,5\n1,5;0,75\n"),
        ("point.csv", "x;y\n0.5;1.25\n2.0;3.5\n1.5;0.75\n"),
        ("comma.tsv", "x\ty\n0,5\t1,25\n2,0\t3,5\n1,5\t0,75\n"),
        ("d.csv", "birth;death\n0,5;1,5\n0,2;3,25\n"),
        ("d2.csv", "birth;death\n0.5;1.5\n0.2;3.25\n"),
        ("list.csv", "0;1;0,5\n1;2;1,5\n0;2;2,5\n"),
        ("listp.csv", "0;1;0.5\n1;2;1.5\n0;2;2.5\n"),
        ("dsq.csv", "0,0;1,5;2,5\n1,5;0,0;3,5\n2,5;3,5;0,0\n"),
        ("dsqp.csv", "0.0;1.5;2.5\n1.5;0.0;3.5\n2.5;3.5;0.0\n"),
    ] {
        write(folder, name, text);
    }
    for (comma, point, options) in [
        ("comma.csv", "point.csv", "--rips"),
        ("comma.tsv", "point.csv", "--rips"),
        ("comma.csv", "point.csv", "--alpha"),
        ("comma.csv", "point.csv", "--rips --delay 1"),
        ("list.csv", "listp.csv", "--rips --distances sparse"),
        ("list.csv", "listp.csv", "--flag"),
        ("dsq.csv", "dsqp.csv", "--rips --distances square"),
        ("dsq.csv", "dsqp.csv", "--rips"),
    ] {
        let [found, plain] =
            [comma, point].map(|name| answer(folder, &format!("persistence {name} {options}")));
        assert_eq!(found["diagram"], plain["diagram"], "{comma} {options}");
        assert!(remarks(&found).contains("decimal commas"), "{found}");
    }
    let same = answer(folder, "diagram distance d.csv d2.csv");
    assert_eq!(same["distance"].as_f64(), Some(0.0), "{same}");
    let [info, plain] = ["info comma.csv", "info point.csv"].map(|line| answer(folder, line));
    assert_eq!(info["f_vector"], plain["f_vector"]);
    // A certificate is of the numbers that the checker reads.
    let asked = ["persistence", "comma.csv", "--rips", "--certificate", "c.json"];
    let result = coface_in(folder, &asked);
    assert!(result.status != 0 || coface_in(folder, &["check", "c.json", "comma.csv"]).status == 0);
    write(folder, "short.csv", "t\n0,5\n1,5\n");
    let refused = coface_in(folder, &["persistence", "short.csv", "--rips"]);
    assert!(refused.status != 0 && refused.stderr.contains("the header has 1 column"), "{}", refused.stderr);
}

#[test]
fn rounded_distances_are_distances() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    // Eight points around a circle have a loop; their rows as points have none so long.
    let point = |i: usize| (std::f64::consts::TAU * i as f64 / 8.0).sin_cos();
    let distance = |i: usize, j: usize| {
        let ((a, b), (c, d)) = (point(i), point(j));
        (a - c).hypot(b - d)
    };
    let table = |noise: f64| -> String {
        let entry = |i: usize, j: usize| match i == j {
            true => noise,
            false => distance(i.max(j), i.min(j)) + if i < j { noise * 1e-7 } else { 0.0 },
        };
        (0..8).map(|i| (0..8).map(|j| entry(i, j).to_string()).collect::<Vec<_>>().join(",") + "\n").collect()
    };
    write(folder, "exact.csv", table(0.0));
    write(folder, "rounded.csv", table(1.5e-8));
    let loops = |line: &str| {
        let found = answer(folder, line);
        let diagram = found["diagram"].as_array().unwrap().clone();
        (diagram.iter().filter(|class| class["degree"] == 1).count(), remarks(&found))
    };
    assert_eq!(loops("persistence exact.csv --rips").0, 1);
    for options in ["--rips", "--rips --distances square"] {
        let (count, said) = loops(&format!("persistence rounded.csv {options}"));
        assert_eq!(count, 1, "{options}");
        assert!(said.contains("on the diagonal became 0"), "{said}");
    }
    write(folder, "empty.csv", "");
    for option in ["--rips", "--alpha"] {
        let refused = coface_in(folder, &["persistence", "empty.csv", option]);
        assert!(refused.status != 0 && refused.stderr.contains("no point"), "{}", refused.stderr);
    }
}

#[test]
fn old_line_ends_and_loose_ends_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write(folder, "cr.off", "OFF\r3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r");
    write(folder, "cr.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r");
    write(folder, "nul.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\0\0");
    write(
        folder,
        "two_words.stl",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nend solid",
    );
    let nodes = "3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n";
    write(
        folder,
        "names.msh",
        format!(
            "$MeshFormat\n2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n7\"lid\"\n$EndPhysicalNames\n$Nodes\n{nodes}$EndNodes\n$Elements\n1\n1 2 2 7 1 1 2 3\n$EndElements\n"
        ),
    );
    write(folder, "one.msh", format!("$NOD\n{nodes}$ENDNOD\n$ELM\n1\n1 2 7 1 3 1 2 3\n$ENDELM\n"));
    for name in ["cr.off", "cr.obj", "nul.obj", "two_words.stl", "names.msh", "one.msh"] {
        let found = answer(folder, &format!("info {name}"));
        assert_eq!(found["f_vector"], serde_json::json!([3, 3, 1]), "{name}");
    }
    assert!(answer(folder, "info names.msh")["groups"].to_string().contains("lid"));
}

#[test]
fn lines_that_nearly_meet_are_polygonized_within_a_tolerance() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write(folder, "lines.wkt", "MULTILINESTRING ((0 0, 4 0), (4 0, 0 3), (0 3, 0 0.0000001))\n");
    for (options, area) in [("", 0.0), (" --tolerance 0.001", 6.0), (" --grid 0.5", 6.0), (" --snap", 0.0)] {
        let found = answer(folder, &format!("map polygonize lines.wkt{options}"));
        assert_eq!(found["measure"].as_f64(), Some(area), "{options}");
    }
    answer(folder, "map node lines.wkt --tolerance 0.001 -o cut.wkt");
    answer(folder, "convert lines.wkt -o back.wkt");
    let back = std::fs::read_to_string(folder.join("back.wkt")).unwrap();
    assert_eq!((back.lines().count(), back.starts_with("MULTILINESTRING (")), (1, true), "{back}");
}
