//! Names of outputs are looked at before anything is read.

use crate::program::coface_in;

/// Command lines of inputs that are not there, whose results go where `OUT` stands.
const LINES: [&str; 41] = [
    "homology a.off -o OUT",
    "homology a.off --generators OUT",
    "homology a.off --parts 2 -o OUT",
    "check a.json -o OUT",
    "merge folder -o OUT",
    "persistence a.off -o OUT",
    "persistence a.off --cycles OUT",
    "persistence a.off --vineyard x y -o OUT",
    "diagram distance a.pers b.pers -o OUT",
    "diagram betti a.pers -o OUT",
    "euler a.off -o OUT",
    "pi1 a.off -o OUT",
    "pi1 a.off --loops OUT",
    "loops a.off -o OUT",
    "cycles a.off -o OUT",
    "cycles a.off --handles -o OUT",
    "cycles a.off --fill-handles all -o OUT",
    "homotopic a.off 0-1-2 -o OUT",
    "subgroups a.off -o OUT",
    "cut a.off -o OUT",
    "edit a.off --poke 0 -o OUT",
    "isomorphic a.off b.off -o OUT",
    "simplify a.off -o OUT",
    "cover a.off --orientation -o OUT",
    "cocycles a.off -o OUT",
    "star a.off --simplices 0 -o OUT",
    "boundary a.off -o OUT",
    "skeleton a.off --dimension 1 -o OUT",
    "incidence a.off VE -o OUT",
    "congruence a.off --tolerance 0.1 -o OUT",
    "arrange a.off -o OUT",
    "boolean union a.off b.off -o OUT",
    "map node a.wkt -o OUT",
    "yin join a.wkt b.wkt -o OUT",
    "yin interface a.wkt -o OUT",
    "yin sample a.wkt -o OUT",
    "generate product a.off b.off -o OUT",
    "batch a.off -o OUT",
    "convert a.off -o OUT",
    "view a.off -o OUT",
    "render a.off -o OUT",
];

#[test]
fn the_name_of_an_output_is_looked_at_before_the_input() {
    let folder = tempfile::tempdir().expect("a folder");
    for line in LINES {
        // Text may have any extension that is not that of something else.
        for name in ["o.xyzw", "o.dae", "o"] {
            let line = line.replace("OUT", name);
            let words: Vec<&str> = line.split(' ').collect();
            let run = coface_in(folder.path(), &words);
            let said = run.fails_with(1);
            let is_looked_at = said.starts_with(&format!("error: {name}: "));
            let is_text = [
                "homology a.off -o",
                "homology a.off --parts",
                "check",
                "merge",
                "diagram distance",
                "pi1 a.off -o",
            ]
            .into_iter()
            .chain(["homotopic", "subgroups", "isomorphic"])
            .any(|start| line.starts_with(start));
            // JSON and pages may have no extension.
            let may_be_bare = ["--generators", "--cycles", "view "].iter().any(|word| line.contains(word));
            let is_free = is_text && name != "o.dae" || name == "o" && may_be_bare;
            assert_ne!(is_looked_at, is_free, "coface {line}: {said}");
        }
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("the folder is there").count(), 0);
}

/// Where no model is read, what says how to read one is a mistake.
#[test]
fn options_of_models_are_refused_where_none_is_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let lines = ["generate torus --rips", "check a.json --rips", "diagram betti a.pers --format off"];
    for line in lines {
        let run = coface_in(folder.path(), &line.split(' ').collect::<Vec<_>>());
        let option = line.split(' ').find(|word| word.starts_with("--")).expect("an option");
        let expected = format!("{option} says how a model is read, and none is read here: leave it out");
        assert!(run.fails_with(1).contains(&expected), "coface {line}: {}", run.stderr);
    }
}
