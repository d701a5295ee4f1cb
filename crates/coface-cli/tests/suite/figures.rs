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
    let solid = file(&folder, "solid.json", "[[0,1,2,3],[0,1,2,4]]");
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

#[test]
fn an_interface_has_its_phases_in_colors_and_its_junctions_marked() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    // A ring of label 1 around label 2, and label 3 below.
    std::fs::write(place.join("labels.pgm"), "P2\n3 4\n3\n1 1 1\n1 2 1\n1 1 1\n3 3 3\n").unwrap();
    let run = |line: &[&str]| {
        let run = coface_in(place, line);
        assert_eq!(run.status, 0, "{line:?}: {}", run.stderr);
        run
    };
    run(&["yin", "interface", "labels.pgm", "-o", "i.json"]);
    let answer = run(&["yin", "interface", "labels.pgm", "--json"]).json();
    for name in ["i.svg", "i.png", "i.pdf"] {
        run(&["yin", "interface", "labels.pgm", "-o", name]);
        assert!(has_header(&place.join(name)), "{name}");
    }
    let drawn = std::fs::read_to_string(place.join("i.svg")).unwrap();
    assert!(drawn.contains("<title>interface of labels.pgm</title>"));
    assert_eq!(drawn.matches("<title>phase ").count(), 3);
    assert_eq!(drawn.matches("<circle").count(), answer["junctions"].as_array().unwrap().len());
    let of_file = svg(&[argument(&place.join("i.json"))]);
    assert_eq!(of_file.matches("<title>phase ").count(), 3);
    // Without control points there is nothing to draw.
    std::fs::write(place.join("bare.json"), serde_json::to_string(&answer).unwrap()).unwrap();
    let bare = coface(&["render", argument(&place.join("bare.json"))]);
    assert!(bare.fails_with(1).contains("no control points"), "{}", bare.stderr);
    let other = coface_in(place, &["yin", "interface", "labels.pgm", "-o", "i.obj"]);
    assert!(other.fails_with(1).contains(".json"));
}

#[test]
fn images_of_two_axes_are_drawn_by_their_grey_values() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    // Two rows of three numbers, as a NumPy array of bytes and as NRRD, whose first axis is the fastest.
    let header = "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3), }";
    let mut npy = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    npy.extend(format!("{header:<117}\n").into_bytes());
    npy.extend([0, 50, 100, 150, 200, 255]);
    std::fs::write(place.join("a.npy"), npy).unwrap();
    let nrrd = "NRRD0004\ntype: uint8\ndimension: 2\nsizes: 3 2\nencoding: ascii\n\n150 200 255 0 50 100\n";
    std::fs::write(place.join("a.nrrd"), nrrd).unwrap();
    let drawn = |name: &str, options: &[&str]| {
        let (input, out) = (place.join(name), place.join("a.png"));
        let line =
            [&["render", argument(&input), "-o", argument(&out), "--size", "780x503"], options].concat();
        let run = coface(&line);
        assert_eq!(run.status, 0, "{}", run.stderr);
        let mut reader =
            png::Decoder::new(std::io::Cursor::new(std::fs::read(&out).unwrap())).read_info().unwrap();
        let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut buffer).unwrap();
        buffer
    };
    let array = drawn("a.npy", &[]);
    let at = |buffer: &[u8], row: usize, column: usize| {
        let (y, x) = (46 + 213 * row + 106, 30 + 213 * column + 106);
        buffer[3 * (780 * y + x)]
    };
    let greys: Vec<u8> = (0..6).map(|i| at(&array, i / 3, i % 3)).collect();
    assert_eq!(greys, [0, 50, 100, 150, 200, 255]);
    // The second axis of the other goes up.
    let other = drawn("a.nrrd", &[]);
    assert_eq!((0..6).map(|i| at(&other, i / 3, i % 3)).collect::<Vec<u8>>(), greys);
    // Rows of PGM go from the top down.
    std::fs::write(place.join("a.pgm"), "P2\n3 2\n255\n0 50 100\n150 200 255\n").unwrap();
    let image = drawn("a.pgm", &[]);
    assert_eq!((0..6).map(|i| at(&image, i / 3, i % 3)).collect::<Vec<u8>>(), greys);
    for name in ["a.svg", "a.pdf"] {
        let run = coface_in(place, &["render", "a.npy", "-o", name]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        assert!(has_header(&place.join(name)));
    }
    // Those that are set lie where their grey values do.
    for name in ["a.npy", "a.pgm"] {
        let set = drawn(name, &["--threshold", "100", "--no-edges"]);
        let is_set = |place: usize| set[3 * place] < 255;
        let (columns, rows): (Vec<usize>, Vec<usize>) =
            (0..set.len() / 3).filter(|&place| is_set(place)).map(|place| (place % 780, place / 780)).unzip();
        let within = |all: &[usize], part: usize, count: usize| {
            let (least, most) = (all.iter().min().unwrap(), all.iter().max().unwrap());
            least + (most - least) * (2 * part + 1) / (2 * count)
        };
        let found: Vec<bool> =
            (0..6).map(|i| is_set(780 * within(&rows, i / 3, 2) + within(&columns, i % 3, 3))).collect();
        assert_eq!(found, [false, false, true, true, true, true], "{name}");
    }
    // Pixels that are set are squares.
    let set = coface_in(place, &["render", "a.npy", "--threshold", "100", "-o", "set.svg"]);
    assert!(set.status == 0 && set.stderr.contains("the 4 pixels"), "{}", set.stderr);
    let page = coface_in(place, &["view", "a.npy", "-o", "page.html", "--json"]);
    assert_eq!(page.status, 0, "{}", page.stderr);
    assert_eq!(page.json()["triangles"], 10, "two for each of five pixels that are not 0");
}

#[test]
fn short_cycles_are_shown_over_their_surface() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let run = |line: &[&str]| {
        let run = coface_in(place, line);
        assert_eq!(run.status, 0, "{line:?}: {}", run.stderr);
        run
    };
    run(&["generate", "torus", "-o", "torus.off", "-q"]);
    let found = run(&["cycles", "torus.off", "--json"]);
    std::fs::write(place.join("cycles.json"), &found.stdout).unwrap();
    let shown = run(&["view", "torus.off", "--with", "cycles.json", "-o", "page.html", "--json"]).json();
    let names: Vec<&str> =
        shown["layers"].as_array().unwrap().iter().filter_map(|layer| layer["name"].as_str()).collect();
    assert!(names.contains(&"cycle 1") && names.contains(&"cycle 2"), "{names:?}");
    run(&["render", "torus.off", "--with", "cycles.json", "-o", "a.svg"]);
    assert!(std::fs::read_to_string(place.join("a.svg")).unwrap().contains("<title>cycle 2</title>"));
}
