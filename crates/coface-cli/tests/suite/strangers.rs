//! Files of strangers: they name no other file of the machine, and what they are called cannot pass for something else.

#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_in};
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

/// A folder `in` for files of strangers, and beside it files that are nobody's business.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir_all(folder.path().join("in/deep")).unwrap();
    fs::write(folder.path().join("secret"), [1; 8]).unwrap();
    fs::write(folder.path().join("in/numbers"), [1; 8]).unwrap();
    fs::write(folder.path().join("in/deep/numbers"), [1; 8]).unwrap();
    symlink("../secret", folder.path().join("in/out")).unwrap();
    symlink("numbers", folder.path().join("in/same")).unwrap();
    pipe(&folder.path().join("in/pipe"));
    folder
}

fn pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

fn nrrd(data: &str) -> String {
    format!("NRRD0004\ntype: uchar\ndimension: 2\nsizes: 4 2\nencoding: raw\ndata file: {data}\n\n")
}

#[test]
fn numbers_of_a_header_are_beside_it() {
    let folder = folder();
    let secret = folder.path().join("secret");
    let header = folder.path().join("in/a.nhdr");
    for data in
        ["numbers", "./deep/numbers", "same", "deep/../numbers", argument(&folder.path().join("in/numbers"))]
    {
        fs::write(&header, nrrd(data)).unwrap();
        let run = coface(&["info", argument(&header), "--json"]);
        assert_eq!(run.json()["f_vector"][2], 8, "{data}");
    }
    let shards = folder.path().join("shards");
    let verbs: [&[&str]; 4] = [
        &["info"],
        &["homology", "--parts", "2"],
        &["shard", "--parts", "2", "-o", argument(&shards)],
        &["convert", "--to", "json"],
    ];
    for data in ["../secret", argument(&secret), "out", "deep/../../secret"] {
        fs::write(&header, nrrd(data)).unwrap();
        for verb in &verbs {
            let words = |more: &[&str]| -> Vec<String> {
                let words = [verb[0], argument(&header)].into_iter().chain(verb[1..].iter().copied());
                words.chain(more.iter().copied()).map(str::to_owned).collect()
            };
            let arguments = words(&[]);
            let run = coface(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
            assert!(run.fails_with(1).contains("--allow-outside"), "{data} {verb:?}: {}", run.stderr);
            assert!(!folder.path().join("shards").exists(), "{data} {verb:?}");
            let arguments = words(&["--allow-outside"]);
            let run = coface(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
            assert_eq!(run.status, 0, "{data} {verb:?}: {}", run.stderr);
            let _ = fs::remove_dir_all(folder.path().join("shards"));
        }
        let rows = folder.path().join("rows.jsonl");
        for (option, kind) in [(None, "invalid_input"), (Some("--allow-outside"), "null")] {
            let arguments: Vec<&str> =
                ["batch", argument(&header), "-o", argument(&rows)].into_iter().chain(option).collect();
            assert_eq!(coface(&arguments).status, 0);
            assert!(
                fs::read_to_string(&rows).unwrap().contains(kind),
                "{data}: {:?}",
                fs::read_to_string(&rows)
            );
        }
    }
    // A pipe or device is not waited for, whoever allows what.
    for data in ["pipe", "/dev/zero", "/dev/tty", "deep", "."] {
        fs::write(&header, nrrd(data)).unwrap();
        for options in [&[][..], &["--allow-outside"]] {
            let run = coface(&[&["info", argument(&header)], options].concat());
            let fault = run.fails_with(1);
            assert!(fault.contains("regular file") || fault.contains("outside"), "{data}: {fault}");
        }
    }
}

#[test]
fn other_files_that_files_name_are_beside_them() {
    let folder = folder();
    let at = |name: &str| folder.path().join("in").join(name);
    let refused = |path: &Path, cure: &str| {
        let run = coface(&["info", argument(path)]);
        assert!(run.fails_with(1).contains(cure), "{}: {}", path.display(), run.stderr);
    };
    let served = |path: &Path, options: &[&str]| {
        let run = coface(&[&["info", argument(path)], options].concat());
        assert_eq!(run.status, 0, "{} {options:?}: {}", path.display(), run.stderr);
    };
    // glTF: a buffer of one triangle.
    let floats: Vec<u8> =
        [0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    fs::write(folder.path().join("outside.bin"), &floats).unwrap();
    fs::write(at("inside.bin"), &floats).unwrap();
    let gltf = |uri: &str| {
        let text = format!(
            "{{\"asset\":{{\"version\":\"2.0\"}},\"scenes\":[{{\"nodes\":[0]}}],\"scene\":0,\"nodes\":[{{\"mesh\":0}}],\
             \"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}}}}]}}],\
             \"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,0]}}],\
             \"bufferViews\":[{{\"buffer\":0,\"byteLength\":36}}],\"buffers\":[{{\"byteLength\":36,\"uri\":\"{uri}\"}}]}}"
        );
        fs::write(at("a.gltf"), text).unwrap();
        at("a.gltf")
    };
    served(&gltf("inside.bin"), &[]);
    for uri in ["../outside.bin", "%2e%2e/outside.bin", argument(&folder.path().join("outside.bin"))] {
        refused(&gltf(uri), "--allow-outside");
        served(&gltf(uri), &["--allow-outside"]);
    }
    refused(&gltf("pipe"), "regular file");
    refused(&gltf("https://example.org/a.bin"), "no file of this machine");
    // TetGen: the nodes have the name of the elements.
    fs::write(folder.path().join("outside.node"), "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n").unwrap();
    fs::write(at("tet.ele"), "1 4 0\n1 1 2 3 4\n").unwrap();
    symlink("../outside.node", at("tet.node")).unwrap();
    refused(&at("tet.ele"), "--allow-outside");
    served(&at("tet.ele"), &["--allow-outside"]);
    fs::remove_file(at("tet.node")).unwrap();
    pipe(&at("tet.node"));
    refused(&at("tet.ele"), "regular file");
    fs::remove_file(at("tet.node")).unwrap();
    fs::copy(folder.path().join("outside.node"), at("tet.node")).unwrap();
    served(&at("tet.ele"), &[]);
    // A scene that is assembled of models.
    fs::write(folder.path().join("outside.json"), "[[0,1,2]]").unwrap();
    fs::write(folder.path().join("disk.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").unwrap();
    fs::copy(folder.path().join("disk.off"), at("disk.off")).unwrap();
    let scene = |file: &str| {
        fs::write(at("scene.json"), format!("[{{\"file\":{file:?}}}]")).unwrap();
        at("scene.json")
    };
    let generate = |path: &Path, options: &[&str]| {
        coface(&[&["generate", "assembly", argument(path), "--to", "off"], options].concat())
    };
    assert_eq!(generate(&scene("disk.off"), &[]).status, 0, "{}", generate(&scene("disk.off"), &[]).stderr);
    assert!(generate(&scene("../disk.off"), &[]).fails_with(1).contains("--allow-outside"));
    assert_eq!(generate(&scene("../disk.off"), &["--allow-outside"]).status, 0);
    assert!(generate(&scene("pipe"), &[]).fails_with(1).contains("regular file"));
}

#[test]
fn a_folder_of_shards_has_no_pipes() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.json"), "[[0,1,2],[1,2,3]]").unwrap();
    let made = coface_in(folder.path(), &["shard", "a.json", "--parts", "2", "-o", "shards"]);
    assert_eq!(made.status, 0, "{}", made.stderr);
    let shards = folder.path().join("shards");
    for (name, arguments) in [
        ("part-000001.shard", &["reduce", "shards"][..]),
        ("part-000001.shard", &["reduce", "shards/part-000001.shard"]),
        ("shards.json", &["merge", "shards"]),
    ] {
        let kept = fs::read(shards.join(name)).unwrap();
        fs::remove_file(shards.join(name)).unwrap();
        pipe(&shards.join(name));
        let run = coface_in(folder.path(), arguments);
        assert!(run.fails_with(1).contains("regular file"), "{arguments:?}: {}", run.stderr);
        fs::remove_file(shards.join(name)).unwrap();
        fs::write(shards.join(name), kept).unwrap();
    }
}

/// A name with an end of line, an escape sequence of terminals, a mark that turns text around, and what HTML would
/// take for an element.
const EVIL: &str = "a\n\u{1b}[31mred\u{202e}\u{9b}1m<img src=x onerror=alert(1)>.json";
const SHOWN: &str = "a\\n\\u{1b}[31mred\\u{202e}\\u{9b}1m<img src=x onerror=alert(1)>.json";

/// Whether a terminal would do something else than show the text.
fn is_clean(text: &str) -> bool {
    !text.contains(|c: char| c.is_control() && c != '\n' || ('\u{202a}'..='\u{202e}').contains(&c))
}

#[test]
fn names_of_files_stay_in_their_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(EVIL);
    fs::write(&path, "[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]").unwrap();
    let file = argument(&path);
    let verbs: [&[&str]; 21] = [
        &["info"],
        &["homology"],
        &["homology", "--generators"],
        &["homology", "--parts", "2"],
        &["pi1"],
        &["loops"],
        &["cut"],
        &["cover", "--radius", "1"],
        &["cover", "--orientation"],
        &["cocycles"],
        &["star", "--simplices", "0"],
        &["link", "--simplices", "0"],
        &["boundary"],
        &["skeleton", "--dimension", "1"],
        &["persistence"],
        &["incidence", "--operator", "VE"],
        &["cycles"],
        &["subgroups", "--index", "2"],
        &["congruence", "--tolerance", "0.1"],
        &["arrange"],
        &["yin", "info"],
    ];
    let mut named = 0;
    for verb in verbs {
        let group = if verb[0] == "yin" { 2 } else { 1 };
        let run = coface(&[&verb[..group], &[file], &verb[group..]].concat());
        for text in [&run.stdout, &run.stderr] {
            assert!(is_clean(text), "{verb:?}: {text:?}");
            assert!(!text.contains("\n\\u{1b}[31mred"), "{verb:?}: {text:?}");
            named += usize::from(text.contains(SHOWN));
        }
    }
    assert!(named > 10, "{named}");
    // Files that are not there, options that are none, and words that are no verb.
    let missing = format!("{file}.off");
    for arguments in [&["info", &missing][..], &[&missing], &["info", "--format", EVIL, file], &[EVIL]] {
        let run = coface(arguments);
        assert_ne!((run.status, is_clean(&run.stderr)), (0, false), "{arguments:?}");
        assert!(
            is_clean(&run.stderr) && run.stderr.contains("\\u{1b}[31m"),
            "{arguments:?}: {:?}",
            run.stderr
        );
    }
    // JSON keeps the name, with escapes of its own.
    let run = coface(&["info", file, "--json"]);
    assert!(is_clean(&run.stdout));
    assert_eq!(run.json()["file"], file);
}

#[test]
fn names_in_tables_are_text() {
    let folder = tempfile::tempdir().unwrap();
    for name in [EVIL, "=cmd|'!A0.json", "+1.json", "-2+3.json", "@SUM(A1).json", "plain.json"] {
        fs::write(folder.path().join(name), "[[0,1,2]]").unwrap();
    }
    let names = ["=cmd|'!A0.json", "./-2+3.json", "+1.json", "@SUM(A1).json", "plain.json", EVIL];
    let run = coface_in(folder.path(), &[&["batch", "-o", "out.csv", "--no-timings"], &names[..]].concat());
    assert_eq!(run.status, 0, "{}", run.stderr);
    let text = fs::read_to_string(folder.path().join("out.csv")).unwrap();
    assert!(is_clean(&text), "{text:?}");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 1 + names.len(), "a row is a line: {text}");
    assert!(
        lines[1].starts_with("'=cmd") && lines[2].starts_with("./-2") && lines[3].starts_with("'+1.json"),
        "{text}"
    );
    assert!(lines[4].starts_with("'@SUM") && lines[5].starts_with("plain.json,"), "{text}");
}

#[test]
fn names_of_objects_stay_in_their_line_and_out_of_html() {
    let folder = tempfile::tempdir().unwrap();
    let object = "\u{9b}2J\u{202e}</script><img src=x onerror=alert(1)>";
    let path = folder.path().join("objects.obj");
    fs::write(
        &path,
        format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no {object}\nf 1 2 3\no other{object}\nf 1 2 4\n"),
    )
    .unwrap();
    let file = argument(&path);
    let run = coface(&["info", file]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert!(is_clean(&run.stdout) && run.stdout.contains("\\u{9b}2J\\u{202e}"), "{:?}", run.stdout);
    let run = coface(&["info", &format!("{file}#\u{1b}[3Jnone")]);
    assert!(is_clean(run.fails_with(1)), "{:?}", run.stderr);
    for arguments in [
        &["view", file, "-o", "page.html"][..],
        &["info", file, "-o", "page.html"],
        &["arrange", file, "-o", "page.html"],
        &["render", file, "-o", "page.svg"],
        &["convert", file, "-o", "page.vtu"],
    ] {
        let run = coface_in(folder.path(), arguments);
        if arguments[0] == "arrange" && run.status != 0 {
            continue;
        }
        assert_eq!(run.status, 0, "{arguments:?}: {}", run.stderr);
        let page = folder.path().join(arguments[3]);
        let text = fs::read_to_string(&page).unwrap();
        assert!(!text.contains("<img src=x onerror"), "{arguments:?}");
        fs::remove_file(page).unwrap();
    }
    // The name of the file, as the title.
    let evil = folder.path().join("<img src=x onerror=alert(1)>.json");
    fs::write(&evil, "[[0,1,2]]").unwrap();
    for verb in ["info", "view"] {
        let run = coface_in(folder.path(), &[verb, argument(&evil), "-o", "page.html"]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        assert!(
            !fs::read_to_string(folder.path().join("page.html")).unwrap().contains("<img src=x onerror"),
            "{verb}"
        );
    }
}
