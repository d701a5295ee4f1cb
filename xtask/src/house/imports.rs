//! Which file of a crate names things of which other file.
//!
//! A path that begins with `crate`, `super` or `self` is followed through re-exports to the file that defines what it names. Paths in modules
//! of tests do not count.

use crate::tokens::tokens;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The files of one crate, by the path of their module: `a::b`, and the empty text for `lib.rs`.
#[derive(Debug, Default)]
pub(super) struct Imports {
    modules: BTreeMap<String, Module>,
}

#[derive(Debug)]
struct Module {
    /// The file below `src`, with slashes.
    file: String,
    tokens: Vec<String>,
    exports: Exports,
}

/// What the `use` items at the top of a file bring into its module.
#[derive(Debug, Default)]
struct Exports {
    names: BTreeMap<String, Vec<String>>,
    globs: Vec<Vec<String>>,
}

impl Imports {
    /// The files with their texts: names below `src`, with slashes.
    pub(super) fn new(files: impl IntoIterator<Item = (String, String)>) -> Self {
        let mut modules = BTreeMap::new();
        for (file, text) in files {
            let mut words: Vec<&str> = file.trim_end_matches(".rs").split('/').collect();
            if matches!(words.last(), Some(&("mod" | "lib" | "main"))) {
                words.pop();
            }
            let module = Module { file: file.clone(), tokens: tokens(&text), exports: Exports::default() };
            modules.insert(words.join("::"), module);
        }
        let mut imports = Self { modules };
        let exports: Vec<(String, Exports)> =
            imports.modules.keys().map(|name| (name.clone(), imports.read_exports(name))).collect();
        for (name, exports) in exports {
            if let Some(module) = imports.modules.get_mut(&name) {
                module.exports = exports;
            }
        }
        imports
    }

    /// The files of the folder `src` of a crate.
    pub(super) fn of_folder(src: &Path) -> Self {
        let mut paths = Vec::new();
        super::walk(src, &mut paths);
        let sources = paths.into_iter().filter(|path| path.extension().is_some_and(|e| e == "rs"));
        Self::new(sources.map(|path| {
            let name =
                path.strip_prefix(src).expect("the walk starts at src").to_string_lossy().replace('\\', "/");
            let text = std::fs::read_to_string(&path).expect("a source file is text");
            (name, text)
        }))
    }

    /// For each file those that it names things of.
    pub(super) fn arrows(&self) -> BTreeMap<&str, BTreeSet<&str>> {
        let mut arrows = BTreeMap::new();
        for (name, module) in &self.modules {
            let mut targets = BTreeSet::new();
            if !is_test(name) {
                for path in self.paths(name, &module.tokens) {
                    let target = self.modules.get(&self.resolve(&path, 0)).map(|target| target.file.as_str());
                    targets.extend(target.filter(|file| *file != module.file));
                }
            }
            arrows.insert(module.file.as_str(), targets);
        }
        arrows
    }

    /// Groups of files each of which leads to each other one, if they lie in more than one folder.
    pub(super) fn circles_between_folders(&self) -> Vec<Vec<String>> {
        let arrows = self.arrows();
        let reach: BTreeMap<&str, BTreeSet<&str>> =
            arrows.keys().map(|&file| (file, reachable(file, &arrows))).collect();
        let mut seen = BTreeSet::new();
        let mut circles = Vec::new();
        for (&file, targets) in &reach {
            if !targets.contains(file) || seen.contains(file) {
                continue;
            }
            let group: Vec<&str> =
                targets.iter().copied().filter(|other| reach[other].contains(file)).collect();
            seen.extend(group.iter().copied());
            let folders: BTreeSet<&str> =
                group.iter().map(|file| file.rsplit_once('/').map_or("", |(folder, _)| folder)).collect();
            if folders.len() > 1 {
                circles.push(group.into_iter().map(str::to_owned).collect());
            }
        }
        circles
    }

    /// The `use` items at the top of a file, as paths from the root of the crate. What comes from other crates is left out.
    fn read_exports(&self, name: &str) -> Exports {
        let tokens = &self.modules[name].tokens;
        let mut exports = Exports::default();
        let (mut depth, mut i) = (0_usize, 0);
        while i < tokens.len() {
            match tokens[i].as_str() {
                "{" => depth += 1,
                "}" => depth = depth.saturating_sub(1),
                "use" if depth == 0 => {
                    let (paths, end) = tree(tokens, i + 1);
                    for (path, alias) in paths {
                        let Some(path) = self.rooted(name, &path) else { continue };
                        if alias == "*" {
                            exports.globs.push(path[..path.len() - 1].to_vec());
                        } else {
                            exports.names.insert(alias, path);
                        }
                    }
                    i = end;
                    continue;
                }
                _ => {}
            }
            i += 1;
        }
        exports
    }

    /// The path from the root of the crate; `None` if it leads to another crate.
    fn rooted(&self, name: &str, path: &[String]) -> Option<Vec<String>> {
        let mut base: Vec<String> = split(name);
        let mut rest = path;
        match rest.first()?.as_str() {
            "crate" => (base, rest) = (Vec::new(), &rest[1..]),
            "self" | "super" => {
                while let Some(word @ ("self" | "super")) = rest.first().map(String::as_str) {
                    if word == "super" {
                        base.pop();
                    }
                    rest = &rest[1..];
                }
            }
            first => {
                let inner = [split(name), vec![first.to_owned()]].concat().join("::");
                if !self.modules.contains_key(&inner) {
                    return None;
                }
            }
        }
        base.extend_from_slice(rest);
        (!base.is_empty()).then_some(base)
    }

    /// All paths in the code of a file that begin with `crate`, `super` or `self`, from the root of the crate; not those in inner modules of tests.
    fn paths(&self, name: &str, tokens: &[String]) -> Vec<Vec<String>> {
        let mut found = Vec::new();
        let mut inner: Vec<(String, usize)> = Vec::new();
        let (mut depth, mut i) = (0_usize, 0);
        while i < tokens.len() {
            let follows = |k: usize, sign: &str| tokens.get(i + k).is_some_and(|token| token == sign);
            match tokens[i].as_str() {
                "mod" if follows(2, "{") => {
                    inner.push((tokens[i + 1].clone(), depth));
                    depth += 1;
                    i += 3;
                    continue;
                }
                "{" => depth += 1,
                "}" => {
                    depth = depth.saturating_sub(1);
                    if inner.last().is_some_and(|(_, at)| *at == depth) {
                        inner.pop();
                    }
                }
                "crate" | "super" | "self" if follows(1, "::") && (i == 0 || tokens[i - 1] != "::") => {
                    let (paths, end) = tree(tokens, i);
                    let here = split(name).into_iter().chain(inner.iter().map(|(word, _)| word.clone()));
                    let here = here.collect::<Vec<_>>().join("::");
                    if !is_test(&here) {
                        found.extend(paths.into_iter().filter_map(|(path, _)| self.rooted(&here, &path)));
                    }
                    i = end.max(i + 1);
                    continue;
                }
                _ => {}
            }
            i += 1;
        }
        found
    }

    /// The module that defines what a path names.
    fn resolve(&self, path: &[String], steps: usize) -> String {
        /// Longer chains of re-exports are circles of their own.
        const MOST_STEPS: usize = 20;
        let mut current = String::new();
        for (i, word) in path.iter().enumerate() {
            let next = if current.is_empty() { word.clone() } else { format!("{current}::{word}") };
            if self.modules.contains_key(&next) {
                current = next;
                continue;
            }
            let Some(module) = self.modules.get(&current).filter(|_| steps < MOST_STEPS) else {
                return current;
            };
            if let Some(target) = module.exports.names.get(word).filter(|target| *target != path) {
                return self.resolve(&[target, &path[i + 1..]].concat(), steps + 1);
            }
            for glob in module.exports.globs.iter().filter(|glob| glob.join("::") != current) {
                let target = self.resolve(&[glob, &path[i..]].concat(), steps + 1);
                if target != glob.join("::") || self.defines(&target, word) {
                    return target;
                }
            }
            return current;
        }
        current
    }

    /// Whether an item of this name is in the file.
    fn defines(&self, module: &str, name: &str) -> bool {
        const ITEMS: [&str; 8] = ["fn", "struct", "enum", "trait", "type", "const", "static", "union"];
        self.modules.get(module).is_some_and(|module| {
            module.tokens.windows(2).any(|pair| ITEMS.contains(&pair[0].as_str()) && pair[1] == name)
        })
    }
}

fn split(module: &str) -> Vec<String> {
    module.split("::").filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

fn is_test(module: &str) -> bool {
    module.split("::").any(|word| word.ends_with("tests"))
}

/// The files that can be reached along one arrow or more.
fn reachable<'a>(file: &str, arrows: &BTreeMap<&'a str, BTreeSet<&'a str>>) -> BTreeSet<&'a str> {
    let mut found = BTreeSet::new();
    let mut open: Vec<&str> = arrows.get(file).into_iter().flatten().copied().collect();
    while let Some(next) = open.pop() {
        if found.insert(*arrows.get_key_value(next).map_or(&next, |(key, _)| key)) {
            open.extend(arrows.get(next).into_iter().flatten());
        }
    }
    found
}

/// The paths of a tree of imports that begins at a token, each with the name it gets, and the token after the tree.
fn tree(tokens: &[String], mut i: usize) -> (Vec<(Vec<String>, String)>, usize) {
    let token = |i: usize| tokens.get(i).map_or("", String::as_str);
    let is_word = |text: &str| text.starts_with(|c: char| c.is_alphabetic() || c == '_');
    let mut path: Vec<String> = Vec::new();
    loop {
        match token(i) {
            "{" => {
                let mut found = Vec::new();
                i += 1;
                while is_word(token(i)) || matches!(token(i), "," | "{" | "*" | "::") {
                    if matches!(token(i), "," | "::") {
                        i += 1;
                        continue;
                    }
                    let (inner, end) = tree(tokens, i);
                    found.extend(
                        inner.into_iter().map(|(rest, alias)| ([path.clone(), rest].concat(), alias)),
                    );
                    i = end.max(i + 1);
                }
                // `a::{self}` is `a`.
                for (path, alias) in &mut found {
                    if path.len() > 1 && path.last().is_some_and(|word| word == "self") {
                        path.pop();
                        if alias == "self" {
                            *alias = path.last().cloned().unwrap_or_default();
                        }
                    }
                }
                return (found, i + 1);
            }
            "*" => {
                path.push("*".to_owned());
                return (vec![(path, "*".to_owned())], i + 1);
            }
            word if is_word(word) => {
                path.push(word.to_owned());
                i += 1;
                if token(i) == "::" && (is_word(token(i + 1)) || matches!(token(i + 1), "{" | "*")) {
                    i += 1;
                } else if token(i) == "as" {
                    return (vec![(path, token(i + 1).to_owned())], i + 2);
                } else {
                    let alias = word.to_owned();
                    return (vec![(path, alias)], i);
                }
            }
            _ => return (vec![(path, String::new())], i),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn imports(files: &[(&str, &str)]) -> Imports {
        Imports::new(files.iter().map(|&(name, text)| (name.to_owned(), text.to_owned())))
    }

    #[test]
    fn paths_lead_through_re_exports_to_the_file_that_defines() {
        let imports = imports(&[
            ("lib.rs", "mod a; mod b; pub use a::Deep; pub use crate::b::*;"),
            ("a/mod.rs", "mod x; mod y; pub use self::x::{Inner as Deep, other}; pub use y::*;"),
            ("a/x.rs", "pub struct Inner; pub fn other() {}"),
            ("a/y.rs", "pub fn why() { super::x::other(); }"),
            ("b/mod.rs", "pub fn f() -> crate::Deep { crate::a::why(); crate::g() } pub fn g() {}"),
        ]);
        let arrows = imports.arrows();
        assert_eq!(arrows["b/mod.rs"], BTreeSet::from(["a/x.rs", "a/y.rs"]));
        assert_eq!(arrows["a/y.rs"], BTreeSet::from(["a/x.rs"]));
        assert!(imports.circles_between_folders().is_empty());
    }

    #[test]
    fn circles_count_between_folders_only() {
        let imports = imports(&[
            ("lib.rs", "mod a; mod b;"),
            ("a/mod.rs", "mod p; mod q;"),
            ("a/p.rs", "use super::q::Q; use crate::b::{self, B}; pub struct P;"),
            ("a/q.rs", "use crate::a::p::P; pub struct Q;"),
            ("b/mod.rs", "mod tests { use crate::a::q::Q; } pub struct B;"),
        ]);
        assert!(imports.circles_between_folders().is_empty(), "one folder, and a test");
        let imports = super::tests::imports(&[
            ("lib.rs", "mod a; mod b;"),
            ("a/mod.rs", "pub struct P(crate::b::B);"),
            ("b/mod.rs", "pub struct B; fn f() { let _ = crate::a::P; }"),
        ]);
        assert_eq!(imports.circles_between_folders(), [["a/mod.rs", "b/mod.rs"]]);
    }

    #[test]
    fn trees_are_read_whole() {
        let tokens = tokens("crate::{a::{self, b as c}, d::*, e} ;");
        let (paths, end) = tree(&tokens, 0);
        let found: Vec<(String, &str)> =
            paths.iter().map(|(path, alias)| (path.join("::"), alias.as_str())).collect();
        assert_eq!(
            found,
            [
                ("crate::a".to_owned(), "a"),
                ("crate::a::b".to_owned(), "c"),
                ("crate::d::*".to_owned(), "*"),
                ("crate::e".to_owned(), "e")
            ]
        );
        assert_eq!(tokens[end], ";");
    }
}
