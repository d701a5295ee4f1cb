//! How many public functions have an example that can be run.

use super::{root, sources};

/// Two of three, and a little less.
const LEAST_PERCENT: usize = 65;

#[test]
fn two_of_three_public_functions_have_examples() {
    let (mut all, mut with) = (0, 0);
    for entry in std::fs::read_dir(root().join("crates")).expect("the folder of the crates") {
        let folder = entry.expect("an entry can be read").path();
        // What no one calls as a library: programs, and the module of Python, whose examples are in its stub.
        if !folder.join("src/lib.rs").is_file() || folder.ends_with("coface-py") {
            continue;
        }
        let [here, shown] = sources(&folder.join("src")).into_iter().fold([0, 0], |[all, with], path| {
            let text = std::fs::read_to_string(path).expect("a source file is text");
            let [here, shown] = counted(&text);
            [all + here, with + shown]
        });
        println!("{}: {shown} of {here}", folder.file_name().unwrap_or_default().display());
        all += here;
        with += shown;
    }
    println!("{with} of {all} public functions have examples");
    assert!(100 * with >= LEAST_PERCENT * all, "{with} of {all} public functions have examples");
}

/// The public functions of a source file, and how many of them have an example in their docs.
fn counted(text: &str) -> [usize; 2] {
    let (mut has_example, mut is_hidden) = (false, false);
    let [mut all, mut with] = [0, 0];
    for line in text.lines().map(str::trim) {
        if let Some(doc) = line.strip_prefix("///") {
            has_example |= doc.trim_start().starts_with("```");
            continue;
        }
        if line.starts_with("#[") {
            is_hidden |= line == "#[doc(hidden)]";
            continue;
        }
        let words = ["pub fn ", "pub const fn ", "pub unsafe fn "];
        if words.iter().any(|words| line.starts_with(words)) && !is_hidden {
            all += 1;
            with += usize::from(has_example);
        }
        (has_example, is_hidden) = (false, false);
    }
    [all, with]
}

#[test]
fn examples_are_counted() {
    let text = "/// One.\n/// ```\n/// assert!(true);\n/// ```\n#[inline]\npub fn one() {}\n\n/// Two.\npub const fn two() {}\n\
                #[doc(hidden)]\npub fn three() {}\n/// ```\nfn four() {}\npub(crate) fn five() {}\n";
    assert_eq!(counted(text), [2, 1]);
}
