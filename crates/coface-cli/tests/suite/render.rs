//! `coface render`: pixels where they belong, hidden lines left out, and what is refused.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_reading};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

const CUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
const BLUE: [u8; 3] = [0, 114, 178];
const RED: [u8; 3] = [208, 2, 27];
const WHITE: [u8; 3] = [255; 3];

fn file(folder: &TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

/// Pixels in rows.
fn decoded(path: &Path) -> ([usize; 2], Vec<[u8; 3]>) {
    let bytes = std::io::Cursor::new(std::fs::read(path).unwrap());
    let mut reader = png::Decoder::new(bytes).read_info().unwrap();
    let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut buffer).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgb);
    let pixels = buffer[..info.buffer_size()].chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect();
    ([info.width as usize, info.height as usize], pixels)
}

/// Draws a file as PNG of 120 by 90 pixels.
fn drawn(folder: &TempDir, input: &Path, options: &[&str]) -> Vec<[u8; 3]> {
    let out = folder.path().join("drawn.png");
    let run =
        coface(&[&["render", argument(input), "--size", "120x90", "-o", argument(&out)], options].concat());
    assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{options:?}");
    // A model without positions is laid out, which is said.
    let is_silent =
        run.stderr.is_empty() || run.stderr.contains("has no positions") && run.stderr.lines().count() == 1;
    assert!(is_silent, "{options:?}: {}", run.stderr);
    let (size, pixels) = decoded(&out);
    assert_eq!(size, [120, 90]);
    pixels
}

fn drawn_as_svg(input: &Path, options: &[&str]) -> String {
    let run = coface(&[&["render", argument(input)], options].concat());
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert!(run.stdout.starts_with("<svg ") && run.stdout.ends_with("</svg>\n"));
    run.stdout
}

fn count(pixels: &[[u8; 3]], color: [u8; 3]) -> usize {
    pixels.iter().filter(|&&pixel| pixel == color).count()
}

/// The data of the path with this stroke.
fn path_of<'a>(svg: &'a str, stroke: &str) -> &'a str {
    let line =
        svg.lines().find(|line| line.starts_with("<path") && line.contains(stroke)).unwrap_or_default();
    line.split(" d=\"").nth(1).unwrap_or_default()
}

#[test]
fn a_cube_shows_nine_of_its_edges() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    for view in [&["--from", "1,0.8,1.5"][..], &["--from", "1,0.8,1.5", "--perspective=40"]] {
        let svg = drawn_as_svg(&cube, view);
        let edges = path_of(&svg, "stroke=\"#5c6670\"");
        assert_eq!(edges.matches('L').count(), 9, "{edges}");
        // Three faces, a color each.
        let mut colors: Vec<&str> = svg
            .lines()
            .filter_map(|line| line.strip_prefix("<path fill=\"#"))
            .map(|line| &line[..6])
            .collect();
        colors.sort_unstable();
        colors.dedup();
        assert_eq!(colors.len(), 3);
    }
    assert_eq!(path_of(&drawn_as_svg(&cube, &["--no-edges"]), "stroke=\"#5c6670\""), "");
}

#[test]
fn a_square_covers_what_it_should_from_both_sides_alike() {
    let folder = tempfile::tempdir().unwrap();
    let square = file(&folder, "square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    let options = ["--from", "0,0,1", "--no-edges"];
    let pixels = drawn(&folder, &square, &options);
    let is_covered = |x: usize, y: usize| pixels[y * 120 + x] != WHITE;
    // 92 of 100 of the height.
    let covered = (0..90).map(|y| (0..120).filter(|&x| is_covered(x, y)).count()).sum::<usize>();
    assert!(covered.abs_diff(83 * 83) < 3 * 83, "{covered}");
    assert!((0..90).all(|y| (0..60).all(|x| is_covered(x, y) == is_covered(119 - x, y))));
    assert!((0..45).all(|y| (0..120).all(|x| is_covered(x, y) == is_covered(x, 89 - y))));
    assert_eq!(drawn(&folder, &square, &["--from", "0,0,-1", "--no-edges"]), pixels);
}

#[test]
fn generators_have_their_color_and_shine_through_what_hides_them() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    let result = |edges: &str| {
        let text = format!(r#"{{"generators":[[],[{{"order":0,"chain":[{edges}]}}]]}}"#);
        file(&folder, "result.json", &text)
    };
    // An edge in front, then one behind.
    let front = result("[1,[4,5]]");
    let view = ["--from", "1,0.8,1.5"];
    let seen = drawn(&folder, &cube, &[&["--with", argument(&front)], &view[..]].concat());
    assert!(count(&seen, BLUE) > 40);
    assert_eq!(count(&drawn(&folder, &cube, &view), BLUE), 0);
    let svg = drawn_as_svg(&cube, &[&["--with", argument(&front)], &view[..]].concat());
    assert!(svg.contains("stroke=\"#0072b2\"") && svg.contains("<title>H1 generator 1</title>"));
    assert!(!svg.contains("stroke-opacity"));
    let behind = result("[1,[0,1]]");
    let hidden = drawn(&folder, &cube, &[&["--with", argument(&behind)], &view[..]].concat());
    // Nothing but the ends, which are corners that are seen.
    assert!(count(&hidden, BLUE) < 5);
    assert_ne!(hidden, drawn(&folder, &cube, &view), "it shines through");
    let svg = drawn_as_svg(&cube, &[&["--with", argument(&behind)], &view[..]].concat());
    assert!(svg.contains("stroke-opacity") && !svg.contains("stroke-width=\"3\""));
}

#[test]
fn witnesses_are_red() {
    let folder = tempfile::tempdir().unwrap();
    let book = file(
        &folder,
        "book.obj",
        "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 1\nv -1 0 -1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n",
    );
    assert!(count(&drawn(&folder, &book, &["--witness"]), RED) > 30);
    assert_eq!(count(&drawn(&folder, &book, &[]), RED), 0);
}

#[test]
fn the_same_picture_has_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    for name in ["a.png", "a.svg"] {
        let out = folder.path().join(name);
        let bytes = |threads: &str| {
            let arguments =
                ["render", argument(&cube), "--size", "80x60", "-o", argument(&out), "--threads", threads];
            assert_eq!(coface(&arguments).status, 0);
            std::fs::read(&out).unwrap()
        };
        assert_eq!(bytes("1"), bytes("3"));
    }
    let out = folder.path().join("b.svg");
    let object = coface(&["render", argument(&cube), "-o", argument(&out), "--json"]).json();
    assert_eq!(object["bytes"].as_u64(), Some(std::fs::metadata(&out).unwrap().len()));
}

#[test]
fn every_sort_of_model_is_seen() {
    let folder = tempfile::tempdir().unwrap();
    let yin = r#"{"order":4,"curves":[{"points":[[0,0],[4,0],[5,2],[4,4],[0,4]],"kinks":[0,4]}]}"#;
    let tetrahedra = "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\n\
        Tetrahedra\n2\n1 2 3 4 0\n2 3 4 5 0\nEnd\n";
    for (name, text, parts) in [
        ("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\n", &["<circle"][..]),
        (
            "rp2.json",
            "[[0,1,2],[0,1,5],[0,2,4],[0,3,4],[0,3,5],[1,2,3],[1,3,4],[1,4,5],[2,3,5],[2,4,5]]",
            &["stroke-width=\"0.5\""],
        ),
        ("graph.json", "[[0,1],[1,2],[2,0],[3]]", &["stroke-width=\"1.6\"", "<circle"]),
        ("two.mesh", tetrahedra, &["stroke-width=\"0.5\""]),
        ("cross.lines", "0,0,1,1\n0,1,1,0\n", &["stroke-width=\"1.6\""]),
        ("set.json", yin, &["C", "<circle", "#cc3333"]),
        ("ring.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))", &["evenodd"]),
        ("torus.json", r#"{"next":[2,3,4,5,0,1]}"#, &["stroke-width=\"0.5\""]),
    ] {
        let path = file(&folder, name, text);
        let pixels = drawn(&folder, &path, &[]);
        assert!(count(&pixels, WHITE) < 120 * 90 - 50, "{name}");
        let svg = drawn_as_svg(&path, &["--size", "120x90"]);
        parts.iter().for_each(|part| assert!(svg.contains(part), "{name}: {part}"));
        assert!(svg.contains("width=\"120\" height=\"90\""), "{name}");
    }
}

#[test]
fn a_region_is_filled_but_for_its_holes() {
    let folder = tempfile::tempdir().unwrap();
    let ring = file(&folder, "ring.wkt", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 6 3, 3 3))");
    let pixels = drawn(&folder, &ring, &[]);
    let pale = count(&pixels, [0x99, 0xaa, 0xcc]) as f64;
    assert_eq!(pixels[45 * 120 + 60], WHITE);
    // 72 of 81 of the square that the panel leaves.
    let side = 90.0 * (480.0 - 56.0) / 480.0 / 1.04;
    assert!((pale / (side * side * 72.0 / 81.0) - 1.0).abs() < 0.1, "{pale}");
}

#[test]
fn matrices_diagrams_and_forests_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    let svg = drawn_as_svg(&cube, &["--matrix"]);
    assert!(svg.contains("degree 1: 8 x 12, 24 entries") && svg.contains("degree 2: 12 x 6, 24 entries"));
    assert!(count(&drawn(&folder, &cube, &["--matrix"]), BLUE) > 20);

    // The walls of the cube by height: one component for ever, one sphere at the top.
    let svg = drawn_as_svg(&cube, &["--diagram"]);
    assert!(svg.contains("H_0: 1") && svg.contains("H_2: 1"), "{svg}");
    let json = folder.path().join("diagram.json");
    let pers = folder.path().join("diagram.pers");
    for out in [&json, &pers] {
        assert_eq!(coface(&["persistence", argument(&cube), "-o", argument(out)]).status, 0);
        let again = drawn_as_svg(out, &["--diagram"]);
        assert_eq!(again.matches("<circle").count(), svg.matches("<circle").count());
    }
    assert!(count(&drawn(&folder, &json, &["--diagram"]), WHITE) < 120 * 90 - 200);
    let bars = drawn_as_svg(&json, &["--barcode"]);
    assert!(bars.contains("H_0: 1") && bars.contains("H_2: 1"), "{bars}");
    assert!(count(&drawn(&folder, &pers, &["--barcode"]), WHITE) < 120 * 90 - 200);
    let both = coface(&["render", argument(&cube), "--diagram", "--barcode", "-o", "x.svg"]);
    assert!(both.fails_with(2).contains("cannot be used with"), "{}", both.stderr);
    let falling = drawn_as_svg(&cube, &["--diagram", "--upper-star", "--function", "x"]);
    assert!(falling.contains("H_2: 1"));

    let ring = file(&folder, "ring.wkt", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 6 3, 3 3))");
    let svg = drawn_as_svg(&ring, &["--forest"]);
    assert!(svg.contains(">outside</text>") && svg.matches("<circle").count() == 2);
    assert!(count(&drawn(&folder, &ring, &["--forest"]), WHITE) < 120 * 90 - 500);
}

/// The chunks of a PNG: their kinds, and how often each comes.
fn chunks(bytes: &[u8]) -> Vec<String> {
    let mut rest = &bytes[8..];
    let mut kinds = Vec::new();
    while rest.len() >= 12 {
        let length = u32::from_be_bytes(rest[..4].try_into().unwrap()) as usize;
        kinds.push(String::from_utf8_lossy(&rest[4..8]).into_owned());
        rest = &rest[length + 12..];
    }
    kinds
}

#[test]
fn a_pdf_is_one_page_of_vectors() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    let out = folder.path().join("cube.pdf");
    for options in [&["--from", "1,0.8,1.5"][..], &["--matrix"], &["--label", "vertices,faces"]] {
        let line = [&["render", argument(&cube), "-o", argument(&out)], options].concat();
        assert_eq!(coface(&line).status, 0);
        let bytes = std::fs::read(&out).unwrap();
        assert!(bytes.starts_with(b"%PDF-1.4") && bytes.ends_with(b"%%EOF\n"));
        let text = String::from_utf8_lossy(&bytes);
        assert_eq!(text.matches("/Type /Page ").count(), 1);
        assert!(text.contains("/MediaBox [0 0 "), "{options:?}");
        assert_eq!(coface(&line).status, 0);
        assert_eq!(std::fs::read(&out).unwrap(), bytes, "the same bytes each time");
    }
}

#[test]
fn a_transparent_picture_has_the_colors_of_the_other_where_it_is_opaque() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    let usual = drawn(&folder, &cube, &[]);
    let out = folder.path().join("bare.png");
    let line = ["render", argument(&cube), "--size", "120x90", "--transparent", "-o", argument(&out)];
    assert_eq!(coface(&line).status, 0);
    let mut reader =
        png::Decoder::new(std::io::Cursor::new(std::fs::read(&out).unwrap())).read_info().unwrap();
    let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut buffer).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgba);
    let mut counts = [0; 3];
    for (bare, usual) in buffer.chunks_exact(4).zip(&usual) {
        let alpha = u32::from(bare[3]);
        // Laid on white it is the picture on white.
        for (&part, &usual) in bare[..3].iter().zip(usual) {
            let on_white = (u32::from(part) * alpha + 255 * (255 - alpha) + 127) / 255;
            assert!(on_white.abs_diff(u32::from(usual)) <= 2, "{bare:?} {usual}");
        }
        counts[match alpha {
            0 => 0,
            255 => 2,
            _ => 1,
        }] += 1;
    }
    assert!(counts[0] > 3000 && counts[2] > 2000 && counts[1] > 0, "{counts:?}");
    let svg = drawn_as_svg(&cube, &["--transparent"]);
    assert!(!svg.contains("H1200V900"));
}

#[test]
fn lines_have_the_width_that_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    let svg = drawn_as_svg(&cube, &["--edge-width", "1.5"]);
    assert!(svg.contains("stroke=\"#5c6670\" stroke-width=\"2\""));
    assert!(coface(&["render", argument(&cube), "--edge-width", "0"]).fails_with(2).contains("above 0"));
}

#[test]
fn numbers_stand_at_cells_that_are_seen() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    let svg = drawn_as_svg(&cube, &["--from", "1,0.8,1.5", "--label", "faces"]);
    let mut numbers: Vec<&str> = svg
        .lines()
        .filter(|line| line.starts_with("<text"))
        .filter_map(|line| line.strip_suffix("</text>")?.rsplit('>').next())
        .collect();
    numbers.sort_unstable();
    // The faces at z = 1, y = 1 and x = 1.
    assert_eq!(numbers, ["f1", "f3", "f4"]);
    let all = drawn_as_svg(&cube, &["--from", "1,0.8,1.5", "--label", "vertices,edges"]);
    assert_eq!(all.matches("<text").count(), 7 + 9);
    let lines = file(&folder, "line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
    let none = coface(&["render", argument(&lines), "--label", "faces"]);
    assert!(none.fails_with(1).contains("there are no faces to label"));
}

#[test]
fn a_spin_has_as_many_frames_as_were_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    let out = folder.path().join("spin.png");
    let line = ["render", argument(&cube), "--size", "60x45", "--spin=5", "-o", argument(&out)];
    assert_eq!(coface(&line).status, 0);
    let kinds = chunks(&std::fs::read(&out).unwrap());
    assert_eq!(kinds.iter().filter(|kind| *kind == "fcTL").count(), 5);
    assert!(kinds.contains(&"acTL".to_owned()));
    let svg = coface(&["render", argument(&cube), "--spin", "-o", argument(&folder.path().join("a.svg"))]);
    assert!(svg.fails_with(1).contains("name the output *.gif, *.png or *.webp"));
    let none = coface(&["render", argument(&cube), "--spin=0", "-o", argument(&out)]);
    assert!(none.fails_with(1).contains("give a number above 0"));
    let bare = [&line[..], &["--transparent"]].concat();
    assert_eq!(coface(&bare).status, 0);
    let bytes = std::fs::read(&out).unwrap();
    // The sixth byte of the header's data is the type of color: with opacity.
    assert_eq!(bytes[25], 6);
    assert_eq!(chunks(&bytes).iter().filter(|kind| *kind == "fcTL").count(), 5);
}

/// The frames of a GIF: how many there are, and whether pixels of each may be none; the size of the picture and of the palette.
fn frames_of_gif(bytes: &[u8]) -> (Vec<bool>, [usize; 2], usize) {
    assert!(bytes.starts_with(b"GIF89a"));
    let number = |at: usize| usize::from(u16::from_le_bytes([bytes[at], bytes[at + 1]]));
    let palette = 2usize << (bytes[10] & 7);
    let mut at = 13 + 3 * palette;
    let mut frames = Vec::new();
    let mut is_bare = false;
    loop {
        match bytes[at] {
            0x21 => {
                if bytes[at + 1] == 0xf9 {
                    is_bare = bytes[at + 3] & 1 == 1;
                }
                at += 2;
            }
            0x2c => {
                frames.push(is_bare);
                assert_eq!(bytes[at + 9] & 0x80, 0, "one palette for all frames");
                at += 11;
            }
            0x3b => break,
            other => panic!("block {other:#x}"),
        }
        while bytes[at] != 0 {
            at += usize::from(bytes[at]) + 1;
        }
        at += 1;
    }
    (frames, [number(6), number(8)], palette)
}

#[test]
fn a_gif_has_one_palette_for_its_frames() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    let out = folder.path().join("spin.gif");
    let line = ["render", argument(&cube), "--size", "60x45", "--spin=5", "-o", argument(&out)];
    assert_eq!(coface(&line).status, 0);
    let bytes = std::fs::read(&out).unwrap();
    let (frames, size, palette) = frames_of_gif(&bytes);
    assert_eq!((frames, size), (vec![false; 5], [60, 45]));
    assert!(palette <= 256);
    assert!(bytes.windows(11).any(|window| window == b"NETSCAPE2.0"), "without end");
    assert_eq!(coface(&line).status, 0);
    assert_eq!(std::fs::read(&out).unwrap(), bytes, "the same bytes each time");
    let object = coface(&[&line[..], &["--transparent", "--json"]].concat()).json();
    let bare = std::fs::read(&out).unwrap();
    assert_eq!(frames_of_gif(&bare).0, [true; 5]);
    assert_eq!(object["bytes"].as_u64(), Some(bare.len() as u64));
}

#[test]
fn a_webp_has_the_pixels_of_the_frames() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    let out = folder.path().join("spin.webp");
    let line = ["render", argument(&cube), "--size", "60x45", "--spin=5", "-o", argument(&out)];
    for (flags, has_opacity) in [(&[][..], false), (&["--transparent"][..], true)] {
        assert_eq!(coface(&[&line[..], flags].concat()).status, 0);
        let bytes = std::fs::read(&out).unwrap();
        assert_eq!((&bytes[..4], &bytes[8..16]), (&b"RIFF"[..], &b"WEBPVP8X"[..]));
        assert_eq!(u32::from_le_bytes(bytes[4..8].try_into().unwrap()) as usize, bytes.len() - 8);
        assert_eq!(bytes[20], if has_opacity { 0x12 } else { 0x02 });
        assert_eq!((bytes[24], bytes[27]), (59, 44));
        assert_eq!(bytes.windows(4).filter(|&name| name == b"ANMF").count(), 5);
    }
}

#[test]
fn frames_go_to_a_folder_or_have_numbers_and_videos_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    let run = |name: &str| {
        let out = folder.path().join(name);
        coface(&["render", argument(&cube), "--size", "40x30", "--spin=3", "-o", argument(&out)])
    };
    assert_eq!(run("frames/").status, 0);
    assert_eq!(run("some/turn-%02d.png").status, 0);
    let names = |place: &str| {
        let entries = std::fs::read_dir(folder.path().join(place)).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort_unstable();
        names
    };
    assert_eq!(names("frames"), ["frame-001.png", "frame-002.png", "frame-003.png"]);
    assert_eq!(names("some"), ["turn-01.png", "turn-02.png", "turn-03.png"]);
    let frames: Vec<_> =
        names("frames").iter().map(|name| decoded(&folder.path().join("frames").join(name))).collect();
    assert!(frames.iter().all(|(size, _)| *size == [40, 30]) && frames[0].1 != frames[1].1);
    for (name, said) in [
        ("a.mp4", "ffmpeg -framerate 24 -i frames/frame-%03d.png"),
        ("a.pdf", "*.gif, *.png or *.webp"),
        ("a", "*.gif, *.png or *.webp"),
        ("a-%s.png", "frames-%03d.png"),
        ("a-%03d-%03d.png", "frames-%03d.png"),
        ("a-%03d.jpg", "frames-%03d.png"),
    ] {
        let message = run(name);
        assert!(message.fails_with(1).contains(said), "{name}: {}", message.stderr);
        assert!(!folder.path().join(name).exists());
    }
    let nowhere = coface(&["render", argument(&cube), "--spin"]);
    assert!(nowhere.fails_with(1).contains("-o spin.gif"));
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let cube = file(&folder, "cube.obj", CUBE);
    let out = folder.path().join("a.png");
    let fails = |options: &[&str], status: i32| {
        coface(&[&["render", argument(&cube)], options].concat()).fails_with(status).to_owned()
    };
    for size in ["0x5", "5x0", "x", "-3x4", "10", "1e3x5", "99999999999999999999x1"] {
        let text = fails(&[&format!("--size={size}"), "-o", argument(&out)], 2);
        assert!(text.contains("like 1200x900"), "{text}");
    }
    let text = fails(&["--size", "40000x40000", "-o", argument(&out)], 1);
    assert!(text.contains("make a smaller picture"), "{text}");
    assert!(fails(&["--from", "0,0,0"], 2).contains("not all 0"));
    assert!(fails(&["--perspective=180"], 1).contains("between 1 and 170"));
    assert!(fails(&["--edges", "--no-edges"], 2).contains("cannot be used with"));
    assert!(fails(&["--matrix", "--witness"], 2).contains("cannot be used with"));
    assert!(fails(&["-o", "a.bmp"], 1).contains("*.png, *.svg or *.pdf"));
    assert!(fails(&["-o", "a"], 1).contains("*.png, *.svg or *.pdf"));
    assert!(fails(&["--forest"], 1).contains("cube.obj"));
    for (text, said) in [
        ("no JSON", "give the JSON that another verb"),
        ("{\"betti\": 3}", "nothing that could be shown"),
        (
            r#"{"generators":[[],[{"chain":[[1,[0,8]]]}]]}"#,
            "the model has 8 vertices, but H1 generator 1 has vertex 8",
        ),
    ] {
        let result = file(&folder, "result.json", text);
        let message = fails(&["--with", argument(&result)], 1);
        assert!(message.contains("result.json") && message.contains(said), "{message}");
    }
    assert!(fails(&["--with", "missing.json"], 1).contains("missing.json"));
    for (name, text) in [("a.pers", "2 0 1\nfoo\n"), ("a.json", r#"{"diagram":[{"degree":0}]}"#)] {
        let path = file(&folder, name, text);
        assert!(coface(&["render", argument(&path), "--diagram"]).fails_with(1).contains(name));
    }
    assert!(!out.exists());
}

#[test]
fn a_drawing_that_bounds_nothing_shows_its_lines() {
    let text =
        "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0L4 1L2 5' fill='none' stroke='#000'/></svg>";
    let run = coface_reading(&["render", "-", "-q"], text.as_bytes());
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert!(!run.stdout.contains("d=\"\"") && run.stdout.matches('L').count() == 2, "{}", run.stdout);
}

#[test]
fn answers_with_a_picture_of_their_own_are_drawn_or_named() {
    let folder = tempfile::tempdir().unwrap();
    let [torus, cover, picture] =
        ["torus.off", "cover.json", "cover.svg"].map(|name| folder.path().join(name));
    let [torus, cover, picture] = [&torus, &cover, &picture].map(|path| argument(path));
    let done = |arguments: &[&str]| {
        let run = coface(arguments);
        assert_eq!(run.status, 0, "{}", run.stderr);
        run.stderr
    };
    done(&["generate", "torus", "--columns", "6", "--rows", "5", "-o", torus]);
    done(&["cover", torus, "--radius", "1", "-o", cover]);
    let said = done(&["render", torus, "--with", cover, "-o", picture]);
    assert!(said.contains("universal cover in the plane") && said.contains("--pane"), "{said}");
    done(&["render", torus, "--with", cover, "--pane", "-o", picture]);
    let drawn = std::fs::read_to_string(picture).unwrap();
    assert!(drawn.contains("<title>universal cover in the plane</title>"), "{drawn:.200}");
    // The deck transformations of the four neighbors stand on them.
    assert_eq!(drawn.matches("<text").count(), 5);
    let none = coface(&["render", torus, "--with", cover, "--pane=forest", "-o", picture]);
    assert!(none.status == 1 && none.stderr.contains("universal cover in the plane"), "{}", none.stderr);
}
