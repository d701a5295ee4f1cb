//! The pages of the book that are generated: verbs by `coface help`, answers and remarks by `docs/answers.schema.json`.

use super::{keep, source};
use crate::root;
use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// What helps against each remark: `code: cure`.
const CURES: &str = include_str!("cures.txt");

/// Errors by their word in `--json`: cause, and what helps.
const ERRORS: &[(&str, &str, &str)] = &[
    (
        "io",
        "A file or stream cannot be opened, read or written.",
        "Check the path, its folder and the permissions.",
    ),
    (
        "parse",
        "The text or bytes break the rules of their format.",
        "Go to the line or byte that the message names; `--partial` reads what stands before it.",
    ),
    (
        "unsupported_format",
        "The format is unknown, or this part of it is not supported.",
        "Name the format with `--format`, or convert the file.",
    ),
    (
        "invalid_input",
        "The data is readable but cannot be what is asked for.",
        "Correct the cell that the message names.",
    ),
    (
        "not_in_complex",
        "A simplex, cell or vertex that was named does not exist.",
        "Ask `coface info` how many there are; numbers begin at 0.",
    ),
    (
        "not_a_complex",
        "A set of cells that has to be closed under faces is not.",
        "Take the closure: `coface closure`.",
    ),
    (
        "not_pure",
        "A complex that has to be pure is not.",
        "Take the part of one dimension: `coface convert` or `coface skeleton`.",
    ),
    (
        "boundary_of_boundary",
        "The boundary of a boundary is not zero.",
        "Correct the signs of the boundary matrices.",
    ),
    (
        "not_a_cycle",
        "A chain that has to be a cycle has a boundary.",
        "Close the chain: each vertex has to be left as often as it is entered.",
    ),
    (
        "shape",
        "Matrices or chains have shapes that do not fit together.",
        "Give as many values as there are cells of the degree.",
    ),
    (
        "too_large",
        "There are more cells, or larger numbers, than the representation or the limit holds.",
        "Raise `--memory`, take `homology --parts`, or a smaller input.",
    ),
    (
        "non_manifold",
        "A surface operation met an edge or a vertex that no surface has.",
        "See where: `coface info`; `coface convert --repair` splits it.",
    ),
    (
        "coefficient",
        "A coefficient that must be invertible is not, or two come from different rings.",
        "Take a field: `--coefficients q` or a prime.",
    ),
];

/// Writes or compares the generated pages.
pub(super) fn reference(program: &Path, is_written: bool) -> Vec<String> {
    let schema = std::fs::read_to_string(root().join("docs/answers.schema.json")).unwrap_or_default();
    let Ok(schema) = serde_json::from_str::<Value>(&schema) else {
        return vec!["docs/answers.schema.json cannot be read".to_owned()];
    };
    let mut faults = Vec::new();
    match verbs(program, &schema) {
        Ok(text) => faults.extend(keep(&source().join("verbs.md"), &text, is_written)),
        Err(why) => faults.push(why),
    }
    faults.extend(keep(&source().join("answers.md"), &answers(&schema), is_written));
    let (text, missing) = remarks(&schema);
    faults.extend(keep(&source().join("remarks.md"), &text, is_written));
    faults.extend(missing);
    faults
}

fn help(program: &Path, words: &[&str]) -> Result<String, String> {
    let run = Command::new(program)
        .arg("help")
        .args(words)
        .env("NO_COLOR", "1")
        .env("COLUMNS", "100")
        .output()
        .map_err(|error| error.to_string())?;
    let text = String::from_utf8_lossy(&run.stdout).into_owned();
    let text = text.lines().map(str::trim_end).collect::<Vec<_>>().join("\n");
    if run.status.success() { Ok(text) } else { Err(format!("coface help {} fails", words.join(" "))) }
}

/// The names of commands in a help text.
fn commands(help: &str) -> Vec<String> {
    let lines =
        help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    lines
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
        .filter_map(|line| line.split_whitespace().next())
        .filter(|word| *word != "help")
        .map(str::to_owned)
        .collect()
}

fn verbs(program: &Path, schema: &Value) -> Result<String, String> {
    let general = help(program, &[])?;
    let common = general.find("Common options:").map_or("", |at| &general[at..]);
    let mut text = "# Verbs\n\nThis page is generated: options by `coface help`, fields by `docs/answers.schema.json`. With `--json` a verb \
                    prints one object; its fields stand below the options. [Answers](answers.md) has the types of the fields.\n\n## All verbs\n\n```text\n"
        .to_owned();
    text.push_str(common);
    text.push_str("\n```\n");
    for verb in commands(&general) {
        let said = help(program, &[&verb])?;
        push_verb(&mut text, &verb, &said, schema);
        if matches!(verb.as_str(), "yin" | "map") {
            for task in commands(&said) {
                let said = help(program, &[&verb, &task])?;
                push_verb(&mut text, &format!("{verb} {task}"), &said, schema);
            }
        }
    }
    Ok(text)
}

/// A verb: its own part of the help, then the fields of its answers.
fn push_verb(text: &mut String, verb: &str, said: &str, schema: &Value) {
    let own = said.find("Common options:").map_or(said, |at| &said[..at]).trim_end();
    text.push_str(&format!("\n## coface {verb}\n\n```text\n{own}\n```\n"));
    let Some(answers) = schema["properties"].as_object() else { return };
    for (name, answer) in answers {
        let is_own = name == verb
            || name.strip_prefix(verb).is_some_and(|rest| {
                rest.starts_with(" (") || rest.starts_with(" --") || rest.starts_with(" FILES")
            });
        let Some(kind) = is_own.then(|| named(answer)).flatten() else { continue };
        text.push_str(&format!(
            "\nThe answer of `{name}`, [{kind}](answers.md#{}):\n\n",
            kind.to_lowercase()
        ));
        push_fields(text, &schema["$defs"][kind]);
    }
}

/// The name of the type that a schema refers to.
fn named(schema: &Value) -> Option<&str> {
    schema["$ref"].as_str()?.strip_prefix("#/$defs/")
}

fn push_fields(text: &mut String, schema: &Value) {
    let Some(fields) = schema["properties"].as_object().filter(|fields| !fields.is_empty()) else { return };
    text.push_str("| field | type | what |\n|---|---|---|\n");
    for (name, field) in fields {
        text.push_str(&format!("| `{name}` | {} | {} |\n", kind(field), line(field)));
    }
}

/// The type of a field as a few words.
fn kind(schema: &Value) -> String {
    if let Some(name) = named(schema) {
        return format!("[{name}](answers.md#{})", name.to_lowercase());
    }
    for key in ["anyOf", "oneOf"] {
        if let Some(kinds) = schema[key].as_array() {
            let mut kinds: Vec<String> = kinds.iter().map(kind).collect();
            kinds.dedup();
            return kinds.join(" or ");
        }
    }
    if let Some(word) = schema["const"].as_str() {
        return format!("`{word}`");
    }
    match &schema["type"] {
        Value::String(word) if word == "array" => match schema.get("items") {
            Some(items) => format!("list of {}", kind(items)),
            None => "list".to_owned(),
        },
        Value::String(word) => word.clone(),
        Value::Array(words) => {
            let items = schema.get("items").map(|items| format!(" of {}", kind(items))).unwrap_or_default();
            let words: Vec<&str> = words.iter().filter_map(Value::as_str).collect();
            words.join(" or ").replace("array", &format!("list{items}"))
        }
        _ => "any".to_owned(),
    }
}

/// The description of a schema as one line of a table, without its examples.
fn line(schema: &Value) -> String {
    let said = schema["description"].as_str().unwrap_or_default();
    let said = said.split("\n# ").next().unwrap_or_default();
    said.replace('\n', " ")
        .replace("  ", " ")
        .replace('|', "\\|")
        .replace('<', "&lt;")
        .replace('$', "\\$")
        .trim()
        .to_owned()
}

fn answers(schema: &Value) -> String {
    let mut text = "# Answers\n\nThis page is generated from `docs/answers.schema.json`: each type of the answers of `--json`, with its fields.\n".to_owned();
    for (name, kind_of) in schema["$defs"].as_object().into_iter().flatten() {
        text.push_str(&format!("\n## {name}\n\n{}\n\n", line(kind_of)));
        push_fields(&mut text, kind_of);
        let words =
            kind_of["oneOf"].as_array().into_iter().flatten().filter(|word| word["const"].is_string());
        for word in words {
            text.push_str(&format!("- `{}`: {}\n", word["const"].as_str().unwrap_or_default(), line(word)));
        }
        for word in kind_of["enum"].as_array().into_iter().flatten().filter_map(Value::as_str) {
            text.push_str(&format!("- `{word}`\n"));
        }
    }
    text
}

/// The page of remarks and errors, and the remarks without a cure.
fn remarks(schema: &Value) -> (String, Vec<String>) {
    let mut missing = Vec::new();
    let mut text = "# Remarks and errors\n\nThis page is generated.\n\n## Remarks\n\nA remark says what was assumed, changed or left out. It \
                    never makes an answer fail, unless `--strict` asks for that. With `--json` it has a code.\n\n| code | cause | what helps |\n|---|---|---|\n"
        .to_owned();
    let mut codes = Vec::new();
    for code in schema["$defs"]["RemarkCode"]["oneOf"].as_array().into_iter().flatten() {
        let word = code["const"].as_str().unwrap_or_default();
        codes.push(word);
        let cure = CURES.lines().find_map(|line| line.strip_prefix(word)?.strip_prefix(": "));
        if cure.is_none() {
            missing.push(format!("xtask/src/book/cures.txt has no line for the remark {word}"));
        }
        text.push_str(&format!("| `{word}` | {} | {} |\n", line(code), cure.unwrap_or_default()));
    }
    for known in CURES.lines().filter_map(|line| line.split(':').next()) {
        if !codes.contains(&known) {
            missing.push(format!("xtask/src/book/cures.txt: there is no remark {known}"));
        }
    }
    text.push_str(
        "\n## Errors\n\nAn error ends the program with exit status 1: the input or the request cannot be served. Status 2 is wrong usage. \
         The rows of `coface batch` and the errors of the library and of Python have this word.\n\n| word | cause | what helps |\n|---|---|---|\n",
    );
    for (word, cause, cure) in ERRORS {
        text.push_str(&format!("| `{word}` | {cause} | {cure} |\n"));
    }
    (text, missing)
}
