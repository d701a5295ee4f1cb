//! `cargo xtask clipping DIR`: the test cases of Clipper2 and of i_overlay, against the program.

use serde_json::Value;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};

const USAGE: &str = "usage: cargo xtask clipping DIR.. [--program PATH]
  runs the cases of Clipper2 (files Polygons.txt) and of i_overlay (.json files in folders called boolean) below the folders: results
  must be valid polygons and have the area that the case says, within what rounding to whole numbers does along their boundary
  --program PATH  the program to run; without it the one in the target folder is built";

/// The key of i_overlay for the subjects alone.
const SUBJECT: &str = "subject";

/// The corners of a ring.
type Ring = Vec<[f64; 2]>;

/// Rings combined.
#[derive(Debug, PartialEq)]
struct Case {
    name: String,
    operation: &'static str,
    rule: Rule,
    subjects: Vec<Ring>,
    clips: Vec<Ring>,
    /// The areas that are right; none if the case does not say.
    areas: Vec<f64>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Rule {
    EvenOdd,
    Nonzero,
    Positive,
    Negative,
}

pub(crate) fn clipping(words: &[String]) -> ExitCode {
    let (mut files, program) = match crate::wild::files_and_program(words, USAGE) {
        Ok(found) => found,
        Err(code) => return code,
    };
    files.sort();
    let work = std::env::temp_dir().join(format!("coface-clipping-{}", std::process::id()));
    if let Err(error) = std::fs::create_dir_all(&work) {
        eprintln!("{}: {error}", work.display());
        return ExitCode::FAILURE;
    }
    let (mut count, mut without_area, mut faults, mut stale) = (0, 0, Vec::new(), Vec::new());
    for file in &files {
        let cases = cases_of(file);
        // What such a file says of its subjects alone is of other subjects: so is the rest.
        let is_stale = |case: &Case| case.name == SUBJECT && examine(&program, &work, case).is_err();
        if cases.first().is_some_and(is_stale) {
            stale.push(file);
            continue;
        }
        for case in cases {
            count += 1;
            without_area += usize::from(case.areas.is_empty());
            if let Err(fault) = examine(&program, &work, &case) {
                faults.push(format!("{}, {}, {}: {fault}", file.display(), case.name, case.operation));
            }
        }
    }
    // What is left of it is a file of a few bytes.
    drop(std::fs::remove_dir_all(&work));
    println!("{count} operations, {without_area} of them without an area to compare with");
    stale.iter().for_each(|file| {
        println!("passed over, since its results are those of other rings: {}", file.display());
    });
    faults.iter().for_each(|fault| println!("{fault}"));
    println!("{} faults", faults.len());
    if faults.is_empty() && count > 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The cases of a file; none if it has none.
fn cases_of(file: &Path) -> Vec<Case> {
    let is_of_clipper = file.file_name().is_some_and(|name| name == "Polygons.txt");
    let is_of_overlay = file.extension().is_some_and(|extension| extension == "json")
        && file.parent().and_then(Path::file_name).is_some_and(|name| name == "boolean");
    match std::fs::read_to_string(file) {
        Ok(text) if is_of_clipper => of_clipper(&text),
        Ok(text) if is_of_overlay => of_overlay(&text),
        _ => Vec::new(),
    }
}

/// Cases as Clipper2 has them: lines `KEY: value`, then a ring a line below the word SUBJECTS or CLIPS.
fn of_clipper(text: &str) -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    let mut is_clip = false;
    for line in text.lines().map(str::trim) {
        if let Some(caption) = line.strip_prefix("CAPTION:") {
            let name = format!("case {}", caption.trim().trim_end_matches('.'));
            cases.push(Case {
                name,
                operation: "union",
                rule: Rule::EvenOdd,
                subjects: Vec::new(),
                clips: Vec::new(),
                areas: Vec::new(),
            });
        }
        let Some(case) = cases.last_mut() else { continue };
        match line.split_once(':') {
            Some(("CLIPTYPE", value)) => {
                case.operation = match value.trim() {
                    "INTERSECTION" => "intersection",
                    "DIFFERENCE" => "difference",
                    "XOR" => "xor",
                    _ => "union",
                };
            }
            Some(("FILLRULE", value)) => {
                case.rule = match value.trim() {
                    "NONZERO" => Rule::Nonzero,
                    "POSITIVE" => Rule::Positive,
                    "NEGATIVE" => Rule::Negative,
                    _ => Rule::EvenOdd,
                };
            }
            Some(("SOL_AREA", value)) => {
                case.areas = value.trim().parse().ok().filter(|area| *area > 0.0).into_iter().collect();
            }
            _ if line.starts_with("SUBJECTS") => is_clip = false,
            _ if line.starts_with("CLIPS") => is_clip = true,
            None if line.starts_with(|first: char| first.is_ascii_digit() || first == '-') => {
                let numbers: Vec<f64> = line
                    .split([',', ' '])
                    .filter(|word| !word.is_empty())
                    .filter_map(|word| word.parse().ok())
                    .collect();
                let ring = numbers.as_chunks::<2>().0.to_vec();
                if is_clip { case.clips.push(ring) } else { case.subjects.push(ring) }
            }
            _ => {}
        }
    }
    cases
}

/// Cases as i_overlay has them: contours, and for each operation the shapes that are right, of which there may be several.
fn of_overlay(text: &str) -> Vec<Case> {
    let Ok(value) = serde_json::from_str::<Value>(text) else { return Vec::new() };
    let rule = match value["fillRule"].as_i64() {
        Some(0) => Rule::EvenOdd,
        Some(1) => Rule::Nonzero,
        _ => return Vec::new(),
    };
    let rings = |contours: &Value| -> Vec<Ring> {
        contours.as_array().into_iter().flatten().map(ring_of).filter(|ring| ring.len() > 2).collect()
    };
    let operations = [
        (SUBJECT, "union"),
        ("union", "union"),
        ("intersect", "intersection"),
        ("difference", "difference"),
        ("inverseDifference", "difference"),
        ("xor", "xor"),
    ];
    let case = |(key, operation): (&str, &'static str)| {
        let areas = value[key].as_array()?.iter().map(area_of_shapes).collect();
        let (mut subjects, mut clips) = (rings(&value["subjPaths"]), rings(&value["clipPaths"]));
        match key {
            SUBJECT => clips.clear(),
            "inverseDifference" => std::mem::swap(&mut subjects, &mut clips),
            _ => {}
        }
        Some(Case { name: key.to_owned(), operation, rule, subjects, clips, areas })
    };
    operations.into_iter().filter_map(case).collect()
}

fn ring_of(contour: &Value) -> Ring {
    let number = |corner: &Value, axis: usize| corner[axis].as_f64();
    let corners = contour.as_array().into_iter().flatten();
    corners.filter_map(|corner| Some([number(corner, 0)?, number(corner, 1)?])).collect()
}

/// The area of shapes: of each the contour that comes first minus the others.
fn area_of_shapes(shapes: &Value) -> f64 {
    let of_shape = |shape: &Value| {
        let areas =
            shape.as_array().into_iter().flatten().map(|contour| doubled_area(&ring_of(contour)).abs() / 2.0);
        areas.enumerate().map(|(i, area)| if i == 0 { area } else { -area }).sum::<f64>()
    };
    shapes.as_array().into_iter().flatten().map(of_shape).sum()
}

fn doubled_area(ring: &Ring) -> f64 {
    let sides = ring.iter().zip(ring.iter().cycle().skip(1));
    sides.map(|([ax, ay], [bx, by])| ax * by - ay * bx).sum()
}

/// Rings as one path, which says how it is filled.
fn picture(rings: &[Ring], rule: Rule) -> String {
    let ring = |ring: &Ring| {
        let mut corners: Vec<String> = ring.iter().map(|[x, y]| format!("{x},{y}")).collect();
        // Winding the other way turns signs around.
        if rule == Rule::Negative {
            corners.reverse();
        }
        format!("M {} Z", corners.join(" L "))
    };
    let paths: Vec<String> = rings.iter().map(ring).collect();
    let filled = if rule == Rule::EvenOdd { "evenodd" } else { "nonzero" };
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><path fill-rule=\"{filled}\" d=\"{}\"/></svg>\n",
        paths.join(" ")
    )
}

fn examine(program: &Path, work: &Path, case: &Case) -> Result<(), String> {
    let mut files = Vec::new();
    for (name, rings) in [("subjects.svg", &case.subjects), ("clips.svg", &case.clips)] {
        if rings.is_empty() && name == "clips.svg" {
            continue;
        }
        let file = work.join(name);
        std::fs::write(&file, picture(rings, case.rule)).map_err(|error| error.to_string())?;
        files.push(file.display().to_string());
    }
    // Without clips an intersection is empty, and the rest is the subjects.
    let is_empty = case.operation == "intersection" && files.len() == 1;
    let output = work.join("result.wkt");
    let target = output.display().to_string();
    let mut words = vec!["boolean", case.operation, &files[0]];
    words.extend(files.get(1).map(String::as_str));
    words.extend(["--json", "-o", &target]);
    if matches!(case.rule, Rule::Positive | Rule::Negative) {
        words.extend(["--rule", "positive"]);
    }
    let answer = run(program, &words)?;
    if run(program, &["info", "--json", &target])?["polygons"]["valid"].as_bool() == Some(false) {
        return Err("the result is not valid".to_owned());
    }
    if is_empty {
        return Ok(());
    }
    let found = answer["measure"].as_f64().unwrap_or(f64::NAN);
    let text = std::fs::read_to_string(&output).map_err(|error| error.to_string())?;
    // Rounding moves no corner by more than half the diagonal of a unit square.
    let slack = 0.75 * boundary_length(&text) + 2.0;
    let is_right = |area: &f64| (found - area).abs() <= slack;
    if case.areas.is_empty() || case.areas.iter().any(is_right) {
        return Ok(());
    }
    Err(format!("the area is {found}, not {:?} within {slack}", case.areas))
}

/// The length of all rings of WKT.
fn boundary_length(text: &str) -> f64 {
    let corner = |corner: &str| {
        let mut numbers = corner.split_whitespace().filter_map(|word| word.parse::<f64>().ok());
        Some([numbers.next()?, numbers.next()?])
    };
    let length = |ring: &str| {
        let corners: Vec<[f64; 2]> = ring.split(',').filter_map(corner).collect();
        corners.windows(2).map(|side| (side[1][0] - side[0][0]).hypot(side[1][1] - side[0][1])).sum::<f64>()
    };
    text.split(['(', ')']).filter(|part| part.contains(' ')).map(length).sum()
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
        let text = "CAPTION: 1. \nCLIPTYPE: DIFFERENCE\nFILLRULE: NEGATIVE\nSOL_AREA: 9\nSOL_COUNT: 1\nSUBJECTS\n\
            0,0, 3,0, 3,3\nCLIPS\n-1,-1 1,0 1,1,\n\nCAPTION: 2.\nSUBJECTS\n0,0 1,0 1,1\n";
        let cases = of_clipper(text);
        assert_eq!((cases.len(), cases[0].operation, cases[0].rule), (2, "difference", Rule::Negative));
        assert_eq!(cases[0].subjects, [vec![[0.0, 0.0], [3.0, 0.0], [3.0, 3.0]]]);
        assert_eq!(cases[0].clips, [vec![[-1.0, -1.0], [1.0, 0.0], [1.0, 1.0]]]);
        assert_eq!((&cases[0].areas[..], &cases[1].areas[..]), (&[9.0][..], &[][..]));
        let json = r#"{"fillRule":1,"subjPaths":[[[0,0],[2,0],[2,2],[0,2]]],"clipPaths":[],
            "union":[[[[[0,0],[2,0],[2,2],[0,2]],[[0,0],[1,0],[1,1],[0,1]]]]]}"#;
        let cases = of_overlay(json);
        assert_eq!((cases.len(), &cases[0].areas[..]), (1, &[3.0][..]));
        assert!(picture(&cases[0].subjects, Rule::EvenOdd).contains("M 0,0 L 2,0 L 2,2 L 0,2 Z"));
        assert_eq!(boundary_length("MULTIPOLYGON (((0 0, 3 0, 3 4, 0 0)), ((9 9, 9 10, 9 9)))"), 14.0);
    }
}
