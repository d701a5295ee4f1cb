//! Imports go down the floors, absences are kept, files stay readable, and nothing names a machine.
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// What each room may import. Rooms that are not listed here do not exist.
const ALLOWED: &[(&str, &[&str])] = &[
    // Floor 0: ground.
    ("error", &[]),
    ("progress", &[]),
    ("ids", &["error", "progress"]),
    ("algebra", &["error", "progress", "ids"]),
    ("geometry", &["error", "progress", "ids", "algebra"]),
    // Floor 1: the centre. It sees no coordinate.
    ("chains", &["error", "progress", "ids", "algebra"]),
    // Floor 2: producers, with the arrows that are allowed among them.
    ("simplicial", &["error", "progress", "ids", "algebra", "geometry", "chains"]),
    ("surface", &["error", "progress", "ids", "algebra", "geometry", "chains", "simplicial"]),
    ("cellular", &["error", "progress", "ids", "algebra", "geometry", "chains", "simplicial", "surface"]),
    ("arrangement", &["error", "progress", "ids", "algebra", "geometry", "chains", "cellular"]),
    ("yin", &["error", "progress", "ids", "algebra", "geometry", "chains", "simplicial", "arrangement"]),
    // Floor 3: questions. They see chain complexes and combinatorial producers, neither coordinates nor files.
    (
        "topology",
        &[
            "error",
            "progress",
            "ids",
            "algebra",
            "chains",
            "simplicial",
            "surface",
            "cellular",
            "arrangement",
            "yin",
        ],
    ),
    // Floor 4: doors.
    (
        "io",
        &[
            "error",
            "progress",
            "ids",
            "algebra",
            "geometry",
            "chains",
            "simplicial",
            "surface",
            "cellular",
            "arrangement",
            "yin",
            "topology",
        ],
    ),
    // Floor 5: the report.
    (
        "report",
        &[
            "error",
            "progress",
            "ids",
            "algebra",
            "geometry",
            "chains",
            "simplicial",
            "surface",
            "cellular",
            "arrangement",
            "yin",
            "topology",
            "io",
        ],
    ),
    // Beside it: parts as files.
    (
        "shards",
        &["error", "progress", "algebra", "geometry", "chains", "cellular", "topology", "io", "report"],
    ),
];

/// Words that the code of `chains` and `topology` never has: there are no coordinates and no files there.
const ABSENT: &[&str] = &["geometry", "Positions", "io", "fs", "Path", "PathBuf", "Model"];

const MOST_LINES: usize = 1000;

#[test]
fn imports_go_down_the_floors() {
    let faults: Vec<String> = sources().iter().flat_map(forbidden_arrows).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn rooms_are_in_the_table() {
    for file in sources() {
        if let Some(room) = &file.room {
            assert!(
                allowed(room).is_some(),
                "{}: the room {room:?} is not in the table of floors",
                file.name
            );
        }
    }
}

#[test]
fn chains_and_topology_see_neither_coordinates_nor_files() {
    for file in sources().iter().filter(|f| matches!(f.room.as_deref(), Some("chains" | "topology"))) {
        let tokens = tokens(&file.text);
        let found = tokens.iter().find(|token| ABSENT.contains(&token.as_str()));
        assert_eq!(found, None, "{} names what its room never sees", file.name);
    }
}

#[test]
fn source_files_stay_readable() {
    let Some(root) = repository() else { return };
    for path in texts(&root).into_iter().filter(|path| path.extension().is_some_and(|e| e == "rs")) {
        let count = std::fs::read_to_string(&path).expect("a source file is text").lines().count();
        assert!(count <= MOST_LINES, "{} has {count} lines; look for the second noun", path.display());
    }
}

#[test]
fn no_committed_text_names_a_machine_path() {
    let Some(root) = repository() else { return };
    // Put together here, so that this file does not name them either.
    let prefixes = ["work", "home", "root", "Users", "tmp"].map(|folder| format!("/{folder}/"));
    let data = ["shared", "/"].concat();
    for path in texts(&root) {
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
fn arrows_are_read_from_code_not_from_comments() {
    let file = Source {
        name: "chains/sample.rs".into(),
        room: Some("chains".into()),
        depth: 2,
        text: r#"
            //! [`crate::io::Model`]
            use crate::algebra::{SparseMatrix, Sign};
            use crate::{Error, topology::homology as h, surface::{PolygonMesh, x::{io}}};
            /* use crate::io::Model; /* nested */ use crate::yin::Knot; */
            fn f() -> Result<(), crate::cellular::CellMesh> { super::super::report::build("crate::io::x") }
            fn g() { super::matching::new(); super::super::algebra::gcd('"'); self::crate_of::it(); }
            pub(crate) use crate::simplicial::*;
        "#
        .into(),
    };
    assert_eq!(
        arrows(&file),
        ["algebra", "Error", "topology", "surface", "cellular", "simplicial", "report", "algebra"]
    );
    let forbidden: Vec<String> = forbidden_arrows(&file)
        .iter()
        .map(|fault| fault.split(' ').nth(1).unwrap_or("").to_owned())
        .collect();
    assert_eq!(
        forbidden,
        ["chains->topology", "chains->surface", "chains->cellular", "chains->simplicial", "chains->report"]
    );
}

/// One file of the library.
struct Source {
    /// Its path below `src`.
    name: String,
    /// The room it stands in; `None` for `lib.rs`, which is the map of all.
    room: Option<String>,
    /// How many modules deep it is: 1 for a room's first page, 2 for a file of a room.
    depth: usize,
    text: String,
}

fn sources() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    walk(&root, &mut found);
    let paths = found.into_iter().filter(|path| path.extension().is_some_and(|e| e == "rs"));
    paths
        .map(|path| {
            let name = path.strip_prefix(&root).expect("the walk starts at src").to_path_buf();
            let mut modules: Vec<String> =
                name.with_extension("").iter().map(|part| part.to_string_lossy().into_owned()).collect();
            if modules.last().is_some_and(|last| last == "mod" || last == "lib") {
                modules.pop();
            }
            let text = std::fs::read_to_string(&path).expect("a source file is text");
            let name = name.iter().map(|part| part.to_string_lossy()).collect::<Vec<_>>().join("/");
            Source { name, room: modules.first().cloned(), depth: modules.len(), text }
        })
        .collect()
}

fn allowed(room: &str) -> Option<&'static [&'static str]> {
    ALLOWED.iter().find(|(name, _)| *name == room).map(|(_, targets)| *targets)
}

/// A line for each arrow of the file that the table does not allow.
fn forbidden_arrows(file: &Source) -> Vec<String> {
    let Some(room) = &file.room else { return Vec::new() };
    let vocabulary = vocabulary();
    let mut faults = Vec::new();
    for name in arrows(file) {
        let target = vocabulary.get(&name).cloned().unwrap_or(name);
        let is_allowed = allowed(room).is_some_and(|targets| targets.contains(&target.as_str()));
        if target != *room && !is_allowed {
            faults.push(format!("{}: {room}->{target} goes against the floors", file.name));
        }
    }
    faults
}

/// Which room each name comes from that `lib.rs` re-exports.
fn vocabulary() -> BTreeMap<String, String> {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs"))
        .expect("the library has a map");
    let tokens = tokens(&text);
    let mut names = BTreeMap::new();
    for (i, token) in tokens.iter().enumerate() {
        if token == "use" {
            let end = tokens[i..].iter().position(|t| t == ";").map_or(tokens.len(), |length| i + length);
            let is_word = |t: &&String| t.chars().all(|c| c.is_alphanumeric() || c == '_');
            for name in tokens[i + 2..end].iter().filter(is_word) {
                names.insert(name.clone(), tokens[i + 1].clone());
            }
        }
    }
    names
}

/// The first names after `crate::`, and after as many `super::` as lead to the crate, in order of kind and appearance.
fn arrows(file: &Source) -> Vec<String> {
    let tokens = tokens(&file.text);
    let mut found = Vec::new();
    for (i, token) in tokens.iter().enumerate() {
        if token == "crate" && tokens.get(i + 1).is_some_and(|t| t == "::") {
            found.extend(heads(&tokens[i + 2..]));
        }
    }
    let mut i = 0;
    while i < tokens.len() {
        let mut length = 0;
        while tokens.get(i + 2 * length).is_some_and(|t| t == "super")
            && tokens.get(i + 2 * length + 1).is_some_and(|t| t == "::")
        {
            length += 1;
        }
        if length >= file.depth && length > 0 {
            let heads = heads(&tokens[i + 2 * length..]);
            found.extend(heads.into_iter().filter(|name| allowed(name).is_some()));
        }
        i += (2 * length).max(1);
    }
    found
}

/// The first names of a tree of imports: `a::b` has `a`, `{a, b::{c, d}}` has `a` and `b`.
fn heads(tokens: &[String]) -> Vec<String> {
    if tokens.first().is_none_or(|token| token != "{") {
        return tokens.first().filter(|token| *token != "*").cloned().into_iter().collect();
    }
    let (mut depth, mut names, mut is_head) = (0, Vec::new(), false);
    for token in tokens {
        match token.as_str() {
            "{" => {
                depth += 1;
                is_head = depth == 1;
            }
            "}" => depth -= 1,
            "," => is_head = depth == 1,
            name => {
                if is_head && depth == 1 {
                    names.push(name.to_owned());
                }
                is_head = false;
            }
        }
        if depth == 0 {
            break;
        }
    }
    names
}

/// Words, `::` and single signs of Rust code, without comments and without what stands in quotes.
fn tokens(text: &str) -> Vec<String> {
    let code: Vec<char> = text.chars().collect();
    let at = |i: usize| code.get(i).copied().unwrap_or('\0');
    let (mut tokens, mut i) = (Vec::new(), 0);
    while i < code.len() {
        match code[i] {
            '/' if at(i + 1) == '/' => i = (i..code.len()).find(|&j| code[j] == '\n').unwrap_or(code.len()),
            '/' if at(i + 1) == '*' => {
                let mut depth = 0;
                while i < code.len() {
                    match (at(i), at(i + 1)) {
                        ('/', '*') => (depth, i) = (depth + 1, i + 2),
                        ('*', '/') => (depth, i) = (depth - 1, i + 2),
                        _ => i += 1,
                    }
                    if depth == 0 {
                        break;
                    }
                }
            }
            'r' | 'b' if raw_string_hashes(&code[i..]).is_some() => {
                let hashes = raw_string_hashes(&code[i..]).unwrap_or(0);
                i = (i..code.len()).find(|&j| code[j] == '"').map_or(code.len(), |j| j + 1);
                while i < code.len() && !(code[i] == '"' && (1..=hashes).all(|k| at(i + k) == '#')) {
                    i += 1;
                }
                i += 1 + hashes;
            }
            '"' => {
                i += 1;
                while i < code.len() && code[i] != '"' {
                    i += if code[i] == '\\' { 2 } else { 1 };
                }
                i += 1;
            }
            // A character in quotes; a lifetime has no closing quote.
            '\'' if at(i + 1) == '\\' => {
                i = (i + 3..code.len()).find(|&j| code[j] == '\'').map_or(code.len(), |j| j + 1);
            }
            '\'' if at(i + 2) == '\'' => i += 3,
            ':' if at(i + 1) == ':' => {
                tokens.push("::".to_owned());
                i += 2;
            }
            c if c.is_alphanumeric() || c == '_' => {
                let end = (i..code.len())
                    .find(|&j| !(code[j].is_alphanumeric() || code[j] == '_'))
                    .unwrap_or(code.len());
                tokens.push(code[i..end].iter().collect());
                i = end;
            }
            c => {
                if !c.is_whitespace() {
                    tokens.push(c.to_string());
                }
                i += 1;
            }
        }
    }
    tokens
}

/// The number of hashes if a raw string starts here.
fn raw_string_hashes(code: &[char]) -> Option<usize> {
    let start = if code.starts_with(&['b', 'r']) {
        2
    } else if code.first() == Some(&'r') {
        1
    } else {
        return None;
    };
    let hashes = code[start..].iter().take_while(|c| **c == '#').count();
    (code.get(start + hashes) == Some(&'"')).then_some(hashes)
}

/// The folder of the whole repository; `None`, with a word, where only this crate is there.
fn repository() -> Option<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    if root.join("xtask").is_dir() && root.join("Cargo.toml").is_file() {
        return Some(root);
    }
    println!("skipped: this crate stands alone, without its repository");
    None
}

/// The files of the repository that may be committed: not the build folder, not what version control keeps.
fn texts(root: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    walk(root, &mut found);
    found
}

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
