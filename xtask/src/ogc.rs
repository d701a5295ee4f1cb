//! `cargo xtask ogc DIR`: the test cases of JTS and GEOS, against the program.

use serde_json::Value;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};

const USAGE: &str = "usage: cargo xtask ogc DIR.. [--program PATH]
  runs the XML test cases of JTS or GEOS below the folders: isValid of polygons, and overlays of valid polygons, whose results must be
  valid and have the area that the case says; with a fixed precision model they are put on its grid and must be valid. Files in folders
  called failure record faults of JTS, and are passed over
  --program PATH  the program to run; without it the one in the target folder is built";

/// An operation of a test case.
#[derive(Debug, PartialEq)]
struct Case {
    /// In lower case, without the suffix for an engine.
    operation: String,
    operands: [String; 2],
    expected: String,
    /// The step of a fixed precision model.
    grid: Option<f64>,
}

#[derive(Default)]
struct Tally {
    validities: usize,
    overlays: usize,
    passed_over: usize,
    faults: Vec<String>,
}

pub(crate) fn ogc(words: &[String]) -> ExitCode {
    let (mut files, program) = match crate::wild::files_and_program(words, USAGE) {
        Ok(found) => found,
        Err(code) => return code,
    };
    files.retain(|file| !file.components().any(|part| part.as_os_str() == "failure"));
    files.retain(|file| file.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("xml")));
    files.sort();
    let work = std::env::temp_dir().join(format!("coface-ogc-{}", std::process::id()));
    if let Err(error) = std::fs::create_dir_all(&work) {
        eprintln!("{}: {error}", work.display());
        return ExitCode::FAILURE;
    }
    let mut tally = Tally::default();
    for file in &files {
        let Ok(bytes) = std::fs::read(file) else { continue };
        for (number, case) in cases(&String::from_utf8_lossy(&bytes)).iter().enumerate() {
            if let Err(fault) = examine(&program, &work, case, &mut tally) {
                tally.faults.push(format!(
                    "{}, operation {number}, {}: {fault}",
                    file.display(),
                    case.operation
                ));
            }
        }
    }
    // What is left of it is a file of a few bytes.
    drop(std::fs::remove_dir_all(&work));
    println!("{} files", files.len());
    println!(
        "{} times isValid, {} overlays, {} passed over",
        tally.validities, tally.overlays, tally.passed_over
    );
    tally.faults.iter().for_each(|fault| println!("{fault}"));
    println!("{} faults", tally.faults.len());
    if tally.faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The operations of all cases of a file.
fn cases(text: &str) -> Vec<Case> {
    let scale = between(text, "<precisionModel", ">").and_then(|model| model.split("scale=").nth(1));
    let number = |scale: &str| scale.split(['"', '\'']).nth(1).and_then(|number| number.parse::<f64>().ok());
    let grid = scale.and_then(number).filter(|&scale| scale > 0.0).map(|scale| 1.0 / scale);
    let mut found = Vec::new();
    for case in text.split("<case").skip(1) {
        let case = case.split("</case").next().unwrap_or_default();
        let operand = |tag: &str| {
            let start = case.find(&format!("<{tag}>")).or_else(|| case.find(&format!("<{tag} ")))?;
            Some(words(between(&case[start..], ">", "<")?))
        };
        let [a, b] = ["a", "b"].map(|tag| operand(tag).unwrap_or_default());
        for operation in case.split("<op").skip(1).filter(|part| part.starts_with([' ', '\n', '\t'])) {
            let Some((attributes, rest)) = operation.split_once('>') else { continue };
            let attribute = |name: &str| {
                let lower = attributes.to_ascii_lowercase();
                let start = lower.find(&format!("{name}="))? + name.len() + 2;
                let value = &attributes[start..];
                value.split(['"', '\'']).next().map(str::to_ascii_lowercase)
            };
            let Some(name) = attribute("name") else { continue };
            let is_swapped = attribute("arg1").is_some_and(|first| first == "b");
            let operands = if is_swapped { [b.clone(), a.clone()] } else { [a.clone(), b.clone()] };
            let name = name.strip_suffix("ng").unwrap_or(&name).to_owned();
            let expected = words(rest.split('<').next().unwrap_or_default());
            found.push(Case { operation: name, operands, expected, grid });
        }
    }
    found
}

fn between<'a>(text: &'a str, start: &str, end: &str) -> Option<&'a str> {
    let rest = &text[text.find(start)? + start.len()..];
    rest.find(end).map(|length| &rest[..length])
}

/// The same with single spaces.
fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Whether a text is a polygon or multipolygon.
fn is_polygonal(text: &str) -> bool {
    let text = text.to_ascii_uppercase();
    (text.starts_with("POLYGON") || text.starts_with("MULTIPOLYGON")) && !text.contains("NAN")
}

/// Counts the case, or says what is wrong.
fn examine(program: &Path, work: &Path, case: &Case, tally: &mut Tally) -> Result<(), String> {
    let operation = match case.operation.as_str() {
        "isvalid" => None,
        "symdifference" => Some("xor"),
        name @ ("union" | "intersection" | "difference") => Some(name),
        _ => return Ok(()),
    };
    let operands: &[String] = if operation.is_some() { &case.operands } else { &case.operands[..1] };
    if !operands.iter().all(|text| is_polygonal(text)) {
        tally.passed_over += 1;
        return Ok(());
    }
    let mut files = Vec::new();
    for (place, text) in operands.iter().enumerate() {
        let file = work.join(format!("{place}.wkt"));
        std::fs::write(&file, text).map_err(|error| error.to_string())?;
        files.push(file.display().to_string());
    }
    let info = |file: &str| -> Result<Option<bool>, String> {
        Ok(run(program, &["info", "--json", file])?["polygons"]["valid"].as_bool())
    };
    let Some(operation) = operation else {
        let Some(found) = info(&files[0])? else {
            tally.passed_over += 1;
            return Ok(());
        };
        tally.validities += 1;
        let expected = case.expected.eq_ignore_ascii_case("true");
        return if found == expected {
            Ok(())
        } else {
            Err(format!("{found}, not {expected}: {}", operands[0]))
        };
    };
    for file in &files {
        if info(file)? == Some(false) {
            tally.passed_over += 1;
            return Ok(());
        }
    }
    let output = work.join("result.wkt").display().to_string();
    let grid = case.grid.map(|step| step.to_string());
    let mut words = vec!["boolean", operation, &files[0], &files[1], "--json", "-o", &output];
    words.extend(grid.iter().flat_map(|step| ["--grid", step]));
    let answer = run(program, &words)?;
    tally.overlays += 1;
    if info(&output)? == Some(false) {
        return Err("the result is not valid".to_owned());
    }
    if grid.is_some() {
        return Ok(());
    }
    let area =
        |file: &str| run(program, &["boolean", "union", file, "--json"]).map(|own| own["measure"].as_f64());
    let [a, b] = [area(&files[0])?, area(&files[1])?].map(|area| area.unwrap_or(0.0));
    let expected = work.join("expected.wkt");
    std::fs::write(&expected, &case.expected).map_err(|error| error.to_string())?;
    // Lines and points of a result have no area.
    let expected = match is_polygonal(&case.expected) {
        true => area(&expected.display().to_string())?,
        false if case.expected.contains("POLYGON") => return Ok(()),
        false => Some(0.0),
    };
    match (answer["measure"].as_f64(), expected) {
        (Some(found), Some(expected)) if (found - expected).abs() > 1e-9 * a.max(b) => {
            Err(format!("the area is {found}, not {expected}"))
        }
        _ => Ok(()),
    }
}

/// What the program answers.
fn run(program: &Path, words: &[&str]) -> Result<Value, String> {
    let output = Command::new(program)
        .args(words)
        .stdin(Stdio::null())
        .output()
        .map_err(|error| format!("{}: {error}", program.display()))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).trim().to_owned());
    }
    serde_json::from_slice(&output.stdout).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases_are_read() {
        let text = "<run><precisionModel type=\"FLOATING\"/><case><desc>one</desc>\n<a>\n POLYGON((0 0,1 0,\n 1 1,0 0))</a>\
            <b>POINT (1 2)</b><test><op name=\"isValid\" arg1=\"A\">true</op></test>\
            <test><op name='differenceNG' arg1='B' arg2='A'> POINT\n EMPTY </op></test></case></run>";
        let [a, b] = ["POLYGON((0 0,1 0, 1 1,0 0))", "POINT (1 2)"].map(str::to_owned);
        let case = |operation: &str, operands: [&String; 2], expected: &str| Case {
            operation: operation.to_owned(),
            operands: operands.map(String::clone),
            expected: expected.to_owned(),
            grid: None,
        };
        assert_eq!(
            cases(text),
            [case("isvalid", [&a, &b], "true"), case("difference", [&b, &a], "POINT EMPTY")]
        );
        assert!(
            cases(&text.replace("\"FLOATING\"", "\"FIXED\" scale=\"10\""))
                .iter()
                .all(|case| case.grid == Some(0.1))
        );
        assert!(is_polygonal(&a) && !is_polygonal(&b));
    }
}
