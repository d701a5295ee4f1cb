//! Requests that need more than there is: they end in words with status 1, and leave nothing behind.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_in, coface_reading};
use serde_json::json;
use std::path::Path;

/// A simplex of so many vertices.
fn simplex(folder: &Path, count: u32) -> String {
    let path = folder.join(format!("simplex{count}.json"));
    std::fs::write(&path, json!([Vec::from_iter(0..count)]).to_string()).unwrap();
    argument(&path).to_owned()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn numbers_of_vertices_cost_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let few = folder.path().join("few.json");
    std::fs::write(&few, "[[0,1,4294967295],[4294967295,70000]]").unwrap();
    for line in [
        &["view", "few.json", "-o", "a.html"][..],
        &["render", "few.json", "-o", "a.png"],
        &["render", "few.json", "-o", "a.svg"],
        &["info", "few.json", "--html", "b.html"],
        &["convert", "few.json", "-o", "a.glb"],
        &["homology", "few.json", "--generators", "generators.json"],
        &["view", "few.json", "--with", "generators.json", "-o", "c.html"],
        &["link", "few.json", "--simplices", "4294967295"],
    ] {
        let mut line = line.to_vec();
        line.extend(["--memory", "200M"]);
        assert_eq!(
            coface_in(folder.path(), &line).status,
            0,
            "{line:?}: {}",
            coface_in(folder.path(), &line).stderr
        );
    }
    let page = std::fs::read_to_string(folder.path().join("a.html")).unwrap();
    assert!(page.contains("vertexNumbers"));
}

#[test]
fn a_simplex_of_too_many_faces_is_counted_before_it_is_built() {
    let folder = tempfile::tempdir().unwrap();
    let large = simplex(folder.path(), 26);
    for line in [&["info", &large, "--memory", "2G"][..], &["pi1", &large, "--memory", "2G"]] {
        let message = coface(line).fails_with(1).to_owned();
        assert!(
            message.contains("67108863 faces") && message.contains("2.1 GB are free"),
            "{line:?}: {message}"
        );
    }
}

#[test]
fn memory_beyond_the_limit_ends_the_program_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let grid = folder.path().join("grid.json");
    assert_eq!(coface(&["generate", "torus-grid", "--shape", "150,150", "-o", argument(&grid)]).status, 0);
    let before = names(folder.path());
    let out = folder.path().join("out.json");
    for (limit, line) in [
        ("1M", &["info", argument(&grid)][..]),
        ("1M", &["convert", argument(&grid), "-o", argument(&out)]),
        ("6M", &["cut", argument(&grid), "-o", argument(&out)]),
    ] {
        let run = coface(&[line, &["--memory", limit]].concat());
        let message = run.fails_with(1);
        assert!(message.contains("needs more than") && message.contains("--memory"), "{line:?}: {message}");
        assert_eq!((names(folder.path()), run.stdout.as_str()), (before.clone(), ""), "{line:?}");
    }
    assert_eq!(coface(&["info", argument(&grid), "--memory", "1G"]).status, 0);
    assert_eq!(coface(&["info", argument(&grid), "--memory", "none"]).status, 0);
    assert!(coface(&["info", argument(&grid), "--memory", "much"]).fails_with(2).contains("500M, 2G"));
}

#[test]
fn time_beyond_the_limit_ends_the_program_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let large = simplex(folder.path(), 21);
    let generators = folder.path().join("generators.json");
    let page = folder.path().join("page.html");
    let before = names(folder.path());
    for line in [
        &["homology", &large][..],
        &["info", &large, "--html", argument(&page)],
        &["homology", &large, "--generators", argument(&generators)],
    ] {
        let run = coface(&[line, &["--time-limit", "20ms"]].concat());
        assert!(run.fails_with(1).contains("takes longer than 0.02 s"), "{line:?}: {}", run.stderr);
        assert_eq!((names(folder.path()), run.stdout.as_str()), (before.clone(), ""), "{line:?}");
    }
    let small = simplex(folder.path(), 4);
    assert_eq!(coface(&["homology", &small, "--time-limit", "10m"]).status, 0);
}

#[test]
fn every_verb_takes_both_limits() {
    let help = coface(&["--help"]).stdout;
    let verbs = help.split("Commands:").nth(1).unwrap().split("Options:").next().unwrap();
    let mut count = 0;
    // What goes on in the next line is indented further.
    let starts = verbs.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    for verb in starts.filter_map(|line| line.split_whitespace().next()).filter(|&word| word != "help") {
        let own = coface(&[verb, "--help"]).stdout;
        assert!(own.contains("--memory <SIZE>") && own.contains("--time-limit <TIME>"), "{verb}");
        count += 1;
    }
    assert!(count > 25, "{count}");
}

#[test]
#[cfg(unix)]
fn a_system_without_memory_ends_the_program_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let large = simplex(folder.path(), 21);
    let run = std::process::Command::new("sh")
        .args(["-c", "ulimit -v 300000; exec \"$0\" homology --threads 1 \"$1\""])
        .args([env!("CARGO_BIN_EXE_coface"), &large])
        .output()
        .unwrap();
    let message = String::from_utf8_lossy(&run.stderr);
    assert_eq!(run.status.code(), Some(1), "{message}");
    assert!(message.contains("of memory") || message.contains("more memory"), "{message}");
}

#[test]
fn matrices_take_by_what_they_hold() {
    let one = r#"{"rows":16777216,"cols":16777216,"entries":[]}"#;
    let text = format!("{{\"boundaries\":[{one}]}}");
    let message = coface_reading(&["homology", "-"], text.as_bytes()).fails_with(1).to_owned();
    assert!(message.contains("16777216 rows") && message.contains("only 0 entries"), "{message}");
    let half = r#"{"rows":600000,"cols":600000,"entries":[]}"#;
    let text = format!("{{\"boundaries\":[{half},{half}]}}");
    let message = coface_reading(&["homology", "-"], text.as_bytes()).fails_with(1).to_owned();
    assert!(message.contains("degree 2"), "one budget for all: {message}");
    let text = format!("{{\"boundaries\":[{half}]}}");
    let answer = coface_reading(&["homology", "--json", "-"], text.as_bytes()).json();
    assert_eq!(answer["homology"][1]["betti"], 600_000);
}

#[test]
fn entries_are_echoed_as_they_are() {
    for (entry, said) in [
        ("9223372036854775808", "9223372036854775808"),
        ("18446744073709551615", "18446744073709551615"),
        ("-2147483648", "-2147483648, beyond the limits of -2147483647"),
        ("2147483648", "2147483648, beyond"),
    ] {
        let text = format!(r#"{{"boundaries":[{{"rows":2,"cols":1,"entries":[[0,0,{entry}]]}}]}}"#);
        let message = coface_reading(&["homology", "-"], text.as_bytes()).fails_with(1).to_owned();
        assert!(message.contains(said), "{entry}: {message}");
    }
    let text = r#"{"boundaries":[{"rows":1,"cols":1,"entries":[[0,0,-2147483647]]}]}"#;
    let answer = coface_reading(&["homology", "--json", "-"], text.as_bytes()).json();
    assert_eq!(answer["homology"][0]["torsion"], json!([2_147_483_647]));
}

#[test]
fn circles_of_any_radius_are_round_or_refused() {
    let count = |radius: &str| {
        let text = format!("<svg xmlns=\"http://www.w3.org/2000/svg\"><circle r=\"{radius}\"/></svg>");
        let run = coface_reading(&["info", "--json", "--format", "svg", "-"], text.as_bytes());
        (run.status == 0).then(|| run.json()["f_vector"][0].as_u64().unwrap()).ok_or(run.stderr)
    };
    let usual = count("1").unwrap();
    assert!(usual > 30);
    for radius in ["1e-160", "1e150", "1e170", "1e300"] {
        assert_eq!(count(radius), Ok(usual), "{radius}");
    }
    assert!(count("1.7e308").unwrap_err().contains("beyond the numbers of double precision"));
}

#[test]
fn large_primes_are_coefficients_at_once() {
    let sphere = b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]";
    let answer =
        coface_reading(&["homology", "--json", "--coefficients", "f18446744073709551557", "-"], sphere)
            .json();
    assert_eq!(answer["homology"][2]["betti"], 1);
    let message = coface_reading(&["homology", "--coefficients", "f18446744073709551556", "-"], sphere);
    assert!(message.fails_with(2).contains("prime"), "{}", message.stderr);
}

/// The same size and the same time do not make the same file.
#[test]
fn work_that_is_kept_is_that_of_the_content() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("in.json");
    let work = folder.path().join("work");
    std::fs::write(&input, "[[0,1],[1,2],[2,0],[3,4]]").unwrap();
    let changed = std::fs::metadata(&input).unwrap().modified().unwrap();
    let ask = || coface(&["homology", "--json", argument(&input), "--parts", "2", "--work", argument(&work)]);
    assert_eq!(ask().json()["homology"][1]["betti"], 1);
    assert_eq!(ask().json()["homology"][1]["betti"], 1);
    std::fs::write(&input, "[[0,1],[1,2],[2,3],[3,4]]").unwrap();
    std::fs::File::options().write(true).open(&input).unwrap().set_modified(changed).unwrap();
    assert!(ask().fails_with(1).contains("shards of another complex"));
}
