//! Figures of papers: stars, closures and links; polygons with their words; long exact sequences.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_in};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A triangulated square of nine vertices.
const GRID: &str = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 0 2 0\nv 1 2 0\nv 2 2 0\n\
    f 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\nf 4 5 8\nf 4 8 7\nf 5 6 9\nf 5 9 8\n";

fn file(folder: &TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

fn svg(arguments: &[&str]) -> String {
    let run = coface(&[&["render"], arguments, &["-q"]].concat());
    assert_eq!(run.status, 0, "{arguments:?}: {}", run.stderr);
    assert!(run.stdout.starts_with("<svg ") && run.stdout.ends_with("</svg>\n"), "{arguments:?}");
    run.stdout
}

/// The group with this title.
fn group<'a>(svg: &'a str, title: &str) -> &'a str {
    let start = svg.find(&format!("<title>{title}</title>")).unwrap_or_else(|| panic!("no {title} in {svg}"));
    let rest = &svg[start..];
    &rest[..rest.find("</g>").unwrap_or(rest.len())]
}

/// Whether a file begins as its extension says.
fn has_header(path: &Path) -> bool {
    let bytes = std::fs::read(path).unwrap();
    match path.extension().and_then(|extension| extension.to_str()).unwrap() {
        "png" => bytes.starts_with(b"\x89PNG"),
        "pdf" => bytes.starts_with(b"%PDF-1.4") && bytes.ends_with(b"%%EOF\n"),
        _ => bytes.starts_with(b"<svg "),
    }
}

#[test]
fn a_star_is_open_and_its_link_goes_around_it() {
    let folder = tempfile::tempdir().unwrap();
    let grid = file(&folder, "grid.obj", GRID);
    let grid = argument(&grid);
    let picture = svg(&[grid, "--star", "4", "--closure", "0 1", "--link", "4", "--from", "0,0,1"]);
    // Vertices of the model, and of the star itself one, with a ring at each of the six that bound it.
    assert_eq!(group(&picture, "vertices").matches("<circle").count(), 9);
    let star = group(&picture, "open star of {4}");
    assert_eq!((star.matches("<circle").count(), star.matches("stroke-width=\"1.75\"").count()), (7, 6));
    assert_eq!(star.matches('L').count(), 6, "an edge for each neighbor: {star}");
    let closure = group(&picture, "closure of {0, 1}");
    assert_eq!((closure.matches("<circle").count(), closure.matches('L').count()), (2, 1));
    let link = group(&picture, "link of {4}");
    assert_eq!((link.matches("<circle").count(), link.matches('L').count()), (6, 6));
    // Each in a color of its own, with a line of the legend.
    for (name, color) in
        [("open star of {4}", "#0072b2"), ("closure of {0, 1}", "#009e73"), ("link of {4}", "#d55e00")]
    {
        assert!(group(&picture, name).contains(color), "{name}");
        assert!(
            group(&picture, "legend").contains(&format!(">{name}</text>"))
                && group(&picture, "legend").contains(color)
        );
    }
    for name in ["a.png", "a.pdf", "a.svg"] {
        let out = folder.path().join(name);
        let run = coface(&["render", grid, "--star", "4; 0 1", "--size", "200x150", "-o", argument(&out)]);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""));
        assert!(has_header(&out), "{name}");
    }
    let none = coface(&["render", grid, "--star", "0 8"]);
    assert!(none.fails_with(1).contains("grid.obj"), "{}", none.stderr);
    let no_list = coface(&["render", grid, "--link", "0 x"]);
    assert!(no_list.fails_with(2).contains("write simplices as"));
    let twice = coface(&["render", grid, "--link", "0 0"]);
    assert!(twice.fails_with(1).contains("--link"), "{}", twice.stderr);
}

#[test]
fn neighborhoods_are_drawn_of_complexes_without_positions_and_refused_of_squares() {
    let folder = tempfile::tempdir().unwrap();
    let plane = file(
        &folder,
        "rp2.json",
        "[[0,1,2],[0,1,5],[0,2,4],[0,3,4],[0,3,5],[1,2,3],[1,3,4],[1,4,5],[2,3,5],[2,4,5]]",
    );
    let picture = svg(&[argument(&plane), "--star", "0", "--link", "0"]);
    assert_eq!(group(&picture, "vertices").matches("<circle").count(), 6);
    assert_eq!(group(&picture, "legend").matches("<text").count(), 2);
    let ball = file(&folder, "ball.json", "[[0,1,2,3],[0,1,2,4]]");
    let picture = svg(&[argument(&ball), "--star", "0 1"]);
    // Of a solid the edges are drawn, and two tetrahedra that do not reach their faces.
    assert!(picture.contains("stroke=\"#a3acb5\""), "pale edges");
    let square = file(&folder, "square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    let refused = coface(&["render", argument(&square), "--star", "0"]);
    assert!(refused.fails_with(1).contains("f0 has 4 sides"), "{}", refused.stderr);
}

#[test]
fn polygons_have_their_words() {
    let folder = tempfile::tempdir().unwrap();
    let word = svg(&["--word", "a b a^-1 b^-1"]);
    assert_eq!(word.matches("<title>side ").count(), 4);
    assert!(word.contains(">torus</text>") && word.contains("<title>a b a^-1 b^-1</title>"));
    let place = folder.path();
    let run = |line: &[&str]| {
        let run = coface_in(place, line);
        assert_eq!(run.status, 0, "{line:?}: {}", run.stderr);
        run
    };
    for (shape, sides, name) in [
        (&["genus", "--genus", "3"][..], 12, "genus-3 surface"),
        (&["klein"], 4, "Klein bottle"),
        (&["rp2"], 2, "projective plane"),
        (&["moebius"], 5, "Moebius band"),
        (&["sphere"], 2, "sphere"),
    ] {
        // The projective plane has no positions.
        let file = if shape == ["rp2"] { "a.json" } else { "a.off" };
        run(&[&["generate"], shape, &["-o", file, "-q"]].concat());
        let found = run(&["render", file, "--schema", "-o", "a.svg", "--json"]).json();
        let drawn = std::fs::read_to_string(place.join("a.svg")).unwrap();
        assert_eq!(drawn.matches("<title>side ").count(), sides, "{shape:?}");
        assert_eq!(drawn.matches("stroke-linecap").count(), sides, "{shape:?}");
        assert_eq!(found["schemas"][0]["surface"], name);
        // The word is that of the cut.
        let cut = run(&["cut", file, "--canonical", "--json"]).json();
        assert_eq!(found["schemas"][0]["word"], cut["components"][0]["canonical"]);
        for name in ["a.png", "a.pdf"] {
            run(&["render", file, "--schema", "-o", name]);
            assert!(has_header(&place.join(name)), "{name}");
        }
    }
    let solid = file(&folder, "solid.json", "[[0,1,2,3]]");
    assert!(coface(&["render", argument(&solid), "--schema"]).fails_with(1).contains("solid.json"));
    assert!(coface(&["render", "--word", "a b 3"]).fails_with(1).contains("'3' at place 5"));
    assert!(coface(&["render", "--word", ""]).fails_with(1).contains("without letters"));
    coface(&["render", "--schema"]).fails_with(2);
    coface(&["render", argument(&solid), "--word", "a a"]).fails_with(2);
}

#[test]
fn a_long_exact_sequence_is_a_diagram() {
    let folder = tempfile::tempdir().unwrap();
    let band = file(&folder, "band.json", "[[0,1,2],[1,2,3],[2,3,4],[3,4,0],[4,0,1]]");
    let line = |name: &str| {
        let out = folder.path().join(name);
        let run = coface(&[
            "homology",
            argument(&band),
            "--relative",
            "boundary",
            "--sequence",
            "-o",
            argument(&out),
        ]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        assert!(has_header(&out), "{name}");
        (out, run.stdout)
    };
    let (_, page) = line("a.pdf");
    assert!(page.contains("image Z, injective"), "{page}");
    line("a.png");
    let (out, _) = line("a.svg");
    let drawn = std::fs::read_to_string(out).unwrap();
    assert!(drawn.contains("long exact sequence of band.json"), "{drawn:.300}");
    // Nine groups and two zeros; eight maps and those from and to zero.
    assert_eq!(drawn.matches("<title>H_").count() + drawn.matches("<title>0</title>").count(), 9 + 2);
    assert_eq!(drawn.matches("stroke-linecap").count(), 8 + 2);
    let answer =
        coface(&["homology", argument(&band), "--relative", "boundary", "--sequence", "--json"]).json();
    let maps = answer["sequence"]["maps"].as_array().unwrap();
    let doubled = maps.iter().find(|map| map["map"] == "inclusion" && map["degree"] == 1).unwrap();
    assert_eq!(
        (&doubled["rank"], &doubled["injective"], &doubled["surjective"]),
        (&1.into(), &true.into(), &false.into())
    );
    let none = coface(&["homology", argument(&band), "-o", argument(&folder.path().join("b.svg"))]);
    assert!(none.fails_with(1).contains("--relative boundary --sequence"));
}
