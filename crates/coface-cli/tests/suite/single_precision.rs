//! What numbers of 32 bits do to positions is told by every verb that writes them.

use crate::program::coface_in;

/// A tetrahedron with a vertex at a tenth, and the same far away.
const FILES: [(&str, &str); 2] = [
    ("a.obj", "v 0 0 0\nv 0.1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"),
    ("b.obj", "v 0 0 0\nv 0.25 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"),
];

#[test]
fn every_verb_tells_how_far_positions_move() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in FILES {
        std::fs::write(folder.path().join(name), text).expect("a file is written");
    }
    for line in [
        "convert IN -o OUT.glb",
        "convert IN -o OUT.gltf",
        "convert IN -o OUT.stl",
        "boolean union IN -o OUT.glb",
        "arrange IN --dimension 3 -o OUT.gltf",
        "edit IN -o OUT.stl",
        "closure IN --simplices 0,1,2 -o OUT.stl",
        "congruence IN --tolerance 0 -o OUT.stl",
    ] {
        for (input, is_rounded) in [("a.obj", true), ("b.obj", false)] {
            let line = line.replace("IN", input).replace("OUT", "out");
            let words: Vec<&str> = line.split(' ').collect();
            let run = coface_in(folder.path(), &words);
            assert_eq!(run.status, 0, "{line}: {}", run.stderr);
            let told = run.stderr.matches("coordinates are rounded to single precision").count();
            assert_eq!(told, usize::from(is_rounded), "coface {line}: {}", run.stderr);
        }
    }
    let answer = coface_in(folder.path(), &["boolean", "union", "a.obj", "-o", "out.glb", "--json"]).json();
    let remarks = answer["remarks"].as_array().expect("an answer has remarks");
    assert!(remarks.iter().any(|remark| remark["code"] == "numbers-rounded"), "{answer}");
    // Formats with all digits have nothing to say.
    for name in ["out.3mf", "out.amf", "out.ply", "out.vtu"] {
        let run = coface_in(folder.path(), &["boolean", "union", "a.obj", "-o", name]);
        assert_eq!((run.status, run.stderr.matches("single precision").count()), (0, 0), "{}", run.stderr);
    }
}

#[test]
fn three_mf_and_amf_are_written_and_read() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("a.obj"), FILES[0].1).expect("a file is written");
    for name in ["a.3mf", "a.amf"] {
        assert_eq!(coface_in(folder.path(), &["convert", "a.obj", "-o", name]).status, 0);
        let report = coface_in(folder.path(), &["info", name, "--json"]).json();
        assert_eq!(
            (&report["manifold"]["closed"], &report["f_vector"][2]),
            (&true.into(), &4.into()),
            "{report}"
        );
        assert_eq!(coface_in(folder.path(), &["convert", name, "-o", "again.obj"]).status, 0);
        let again = std::fs::read_to_string(folder.path().join("again.obj")).expect("it is there");
        assert!(again.contains("v 0.1 0 0\n"), "{again}");
    }
}
