//! The house: crates depend downward, files form no circles between folders, absences are kept, files stay readable, and nothing names a
//! machine. All of it is tests; cargo itself enforces that a crate sees only what it depends on.

mod dialect;
mod examples;
mod imports;

use crate::root;
use crate::tokens::tokens;
use imports::Imports;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// What each crate may depend on, among the crates here: the drawing of `DESIGN.md`, section 1.
const ALLOWED: &[(&str, &[&str])] = &[
    ("coface-algebra", &[]),
    ("coface-geometry", &["coface-algebra"]),
    ("coface-complexes", &["coface-algebra", "coface-geometry"]),
    ("coface-topology", &["coface-algebra", "coface-complexes"]),
    ("coface-graphblas", &[]),
    ("coface-arrange", &["coface-algebra", "coface-geometry"]),
    ("coface-yin", &["coface-algebra", "coface-geometry", "coface-complexes", "coface-arrange"]),
    ("coface-check", &[]),
    ("coface-check-congruence", &["coface-check"]),
    ("coface-check-persistence", &["coface-check", "coface-check-congruence"]),
    ("coface-check-plane", &["coface-check", "coface-check-persistence"]),
    ("coface-check-space", &["coface-check", "coface-check-plane"]),
    ("coface-check-loops", &["coface-check", "coface-check-space"]),
    ("coface-check-walks", &["coface-check", "coface-check-loops"]),
    ("coface-check-binary", &["coface-check", "coface-check-walks"]),
    ("coface-io", &["coface-algebra", "coface-geometry", "coface-complexes", "coface-arrange", "coface-yin"]),
    (
        "coface-answers",
        &[
            "coface-algebra",
            "coface-geometry",
            "coface-complexes",
            "coface-topology",
            "coface-arrange",
            "coface-yin",
            "coface-io",
            "coface-check",
            "coface-check-persistence",
            "coface-check-plane",
            "coface-check-space",
            "coface-check-walks",
        ],
    ),
    (
        "coface-pictures",
        &[
            "coface-algebra",
            "coface-geometry",
            "coface-complexes",
            "coface-yin",
            "coface-io",
            "coface-answers",
        ],
    ),
    ("coface-mapped", &[]),
    ("coface-parallel", &[]),
    ("coface-allocator", &[]),
    (
        "coface-scale",
        &[
            "coface-algebra",
            "coface-geometry",
            "coface-complexes",
            "coface-topology",
            "coface-io",
            "coface-answers",
            "coface-mapped",
        ],
    ),
    (
        "coface",
        &[
            "coface-algebra",
            "coface-geometry",
            "coface-complexes",
            "coface-topology",
            "coface-arrange",
            "coface-yin",
            "coface-io",
            "coface-answers",
            "coface-pictures",
            "coface-scale",
        ],
    ),
    ("coface-cli", &["coface", "coface-allocator", "coface-check", "coface-check-binary"]),
    ("coface-py", &["coface", "coface-allocator", "coface-check", "coface-check-binary"]),
    ("coface-bench", &["coface", "coface-check-binary"]),
];

/// Words that the code of a crate never has: algebra sees neither coordinates nor files, topology no files.
const ABSENT: &[(&str, &[&str])] = &[
    ("coface-algebra", &["coface_geometry", "Positions", "fs", "Path", "PathBuf", "Model"]),
    ("coface-topology", &["coface_geometry", "Positions", "fs", "Path", "PathBuf", "Model"]),
];

/// Circles between folders that are known, by one of their files, and why they stay.
const KNOWN_CIRCLES: &[(&str, &str, &str)] = &[];

const MOST_LINES: usize = 1000;

#[test]
fn crates_depend_downward_and_on_nothing_unused() {
    let mut faults = Vec::new();
    let mut above: Vec<&str> = Vec::new();
    for (name, allowed) in ALLOWED {
        above.push(name);
        for target in allowed.iter().filter(|target| !above.contains(*target)) {
            faults.push(format!("{name} -> {target}: the table is not in order, from the ground up"));
        }
        let folder = root().join("crates").join(name);
        let manifest = std::fs::read_to_string(folder.join("Cargo.toml")).expect("a crate has a manifest");
        let declared = dependencies(&manifest);
        let words = words_of(&folder.join("src"));
        for target in declared.iter().filter(|target| target.starts_with("coface")) {
            if !allowed.contains(&target.as_str()) {
                faults.push(format!("{name} -> {target}: an arrow that the table does not have"));
            }
        }
        for target in allowed.iter().filter(|target| !declared.contains(**target)) {
            faults.push(format!("{name} -> {target}: allowed, but Cargo.toml does not have it"));
        }
        for target in declared.iter().filter(|target| !words.contains(&target.replace('-', "_"))) {
            faults.push(format!("{name} -> {target}: in Cargo.toml, but no source names it"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn all_crates_are_in_the_table() {
    for entry in std::fs::read_dir(root().join("crates")).expect("the folder of the crates") {
        let name = entry.expect("an entry can be read").file_name().to_string_lossy().into_owned();
        assert!(
            ALLOWED.iter().any(|(known, _)| *known == name),
            "crates/{name} is not in the table of the house"
        );
    }
}

#[test]
fn crates_without_tests_are_linted_in_ci() {
    // There the compiler of the tests has the lints; what has none is named in its place.
    let wrapper = std::fs::read_to_string(root().join(".ci/rustc")).expect("what stands before the compiler");
    for (name, _) in ALLOWED {
        let manifest = std::fs::read_to_string(root().join("crates").join(name).join("Cargo.toml"));
        let manifest = manifest.expect("a manifest can be read");
        if manifest.contains("test = false") {
            let table = manifest.split("[lib]").nth(1).unwrap_or_default();
            let table = table.split("\n[").next().unwrap_or_default();
            let library = table.lines().find_map(|line| line.strip_prefix("name = "));
            let library =
                library.map_or_else(|| name.replace('-', "_"), |name| name.trim_matches('"').to_owned());
            assert!(
                wrapper.contains(&format!(" --crate-name {library} ")),
                "{name}: .ci/rustc lints it nowhere"
            );
        }
        assert!(!manifest.contains("[[bench]]"), "{name}: benches are not built for tests, and not linted");
    }
}

#[test]
fn files_of_different_folders_form_no_circles() {
    let mut faults = Vec::new();
    for (name, _) in ALLOWED {
        for circle in
            Imports::of_folder(&root().join("crates").join(name).join("src")).circles_between_folders()
        {
            let is_known = KNOWN_CIRCLES
                .iter()
                .any(|(owner, file, _)| owner == name && circle.iter().any(|f| f == file));
            if !is_known {
                faults.push(format!("{name}: {}", circle.join(", ")));
            }
        }
    }
    assert!(faults.is_empty(), "these files name things of each other in circles:\n{}", faults.join("\n"));
}

#[test]
fn absences_are_kept() {
    for (name, absent) in ABSENT {
        for path in sources(&root().join("crates").join(name).join("src")) {
            let text = std::fs::read_to_string(&path).expect("a source file is text");
            let found = tokens(&text).into_iter().find(|token| absent.contains(&token.as_str()));
            assert_eq!(found, None, "{} names what its crate never sees", path.display());
        }
    }
}

#[test]
fn docs_of_each_crate_are_published_with_formulas() {
    let read = |path: PathBuf| {
        std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    };
    let header = read(root().join("docs/katex-header.html"));
    for (name, _) in ALLOWED {
        let folder = root().join("crates").join(name);
        let manifest = read(folder.join("Cargo.toml"));
        if manifest.contains("publish = false") || !folder.join("src/lib.rs").is_file() {
            continue;
        }
        let is_named = manifest.contains(r#"rustdoc-args = ["--html-in-header", "katex-header.html"]"#);
        assert!(is_named, "crates/{name}/Cargo.toml does not name katex-header.html for docs.rs");
        // A package has only files of its own folder, so each has its copy.
        let copy = read(folder.join("katex-header.html"));
        assert_eq!(copy, header, "crates/{name}/katex-header.html is not docs/katex-header.html");
    }
}

#[test]
fn source_files_stay_readable() {
    for path in sources(&root()) {
        let count = std::fs::read_to_string(&path).expect("a source file is text").lines().count();
        assert!(count <= MOST_LINES, "{} has {count} lines; look for the second noun", path.display());
    }
}

#[test]
fn no_committed_text_names_a_machine_path() {
    let root = root();
    // Put together here, so that this file does not name them either.
    let prefixes = ["work", "home", "root", "Users", "tmp"].map(|folder| format!("/{folder}/"));
    let data = ["shared", "/"].concat();
    let mut paths = Vec::new();
    walk(&root, &mut paths);
    for path in paths {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let name = path.strip_prefix(&root).expect("the walk starts at the root").to_path_buf();
        for (i, line) in text.lines().enumerate() {
            let named = prefixes.iter().find(|prefix| {
                line.match_indices(prefix.as_str()).any(|(at, _)| {
                    // A folder of that name inside a relative path is no machine path.
                    !line[..at].ends_with(|c: char| c.is_alphanumeric() || c == '.' || c == '_' || c == '-')
                })
            });
            assert_eq!(named, None, "{}:{}: a machine path", name.display(), i + 1);
            // The one script that knows where the data folder lies beside a checkout.
            let is_data = line.contains(&data) && name != Path::new(".ci/run");
            assert!(!is_data, "{}:{}: a path outside the repository", name.display(), i + 1);
        }
    }
}

#[test]
fn dependencies_are_read_from_all_their_tables() {
    let manifest = "[package]\nname = \"x\"\n[dependencies]\n# a word\na-b = { workspace = true }\nc.workspace = true\n\
                    [dev-dependencies]\nd = \"1\"\n[target.'cfg(unix)'.dependencies]\ne = \"1\"\n[lints]\nworkspace = true\n";
    assert_eq!(dependencies(manifest), BTreeSet::from(["a-b", "c", "e"].map(str::to_owned)));
}

/// The names in the tables of dependencies of a manifest, without those of tests.
fn dependencies(manifest: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut is_within = false;
    for line in manifest.lines().map(str::trim) {
        if let Some(table) = line.strip_prefix('[') {
            let table = table.trim_end_matches(']');
            is_within =
                table == "dependencies" || (table.starts_with("target.") && table.ends_with(".dependencies"));
        } else if is_within && !line.starts_with('#') {
            let name = line.split(['=', '.']).next().unwrap_or_default().trim();
            found.extend((!name.is_empty()).then(|| name.to_owned()));
        }
    }
    found
}

/// All words in the sources of a folder.
fn words_of(folder: &Path) -> BTreeSet<String> {
    let texts =
        sources(folder).into_iter().map(|path| std::fs::read_to_string(path).expect("a source file is text"));
    texts.flat_map(|text| tokens(&text)).collect()
}

/// The files of Rust code below a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    walk(folder, &mut found);
    found.retain(|path| path.extension().is_some_and(|e| e == "rs"));
    found
}

/// The files below a folder that may be committed: not the build folder, not what version control keeps.
fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
    let entries = std::fs::read_dir(folder).expect("a folder of the repository can be read");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry can be read").path()).collect();
    paths.sort();
    for path in paths {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or("");
        if path.is_symlink()
            || matches!(name, "target" | ".git" | "__pycache__" | "bench-results" | "node_modules")
        {
            continue;
        }
        if path.is_dir() {
            walk(&path, found);
        } else if !name.ends_with(".tmp") {
            found.push(path);
        }
    }
}
