//! `coface batch`: rows of good files, of bad ones, and of those that crash, never end or take all memory.
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// The rows of a file of JSON lines.
fn rows(path: &Path) -> Vec<Value> {
    let text = fs::read_to_string(path).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// A folder with models that are right and files that are not.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let models = folder.path().join("models");
    fs::create_dir_all(models.join("more")).unwrap();
    for (name, shape) in [("a torus.off", "torus"), ("klein.obj", "klein"), ("more/sphere.ply", "sphere")] {
        coface(&["generate", shape, "-o", argument(&models.join(name)), "--json"]).json();
    }
    fs::write(models.join("bad.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 one 0\n3 0 1 2\n").unwrap();
    fs::write(models.join("c,\"d\".json"), "[[0,1,2],[0,1,3],[0,1,4]]").unwrap();
    fs::write(models.join("empty.stl"), "").unwrap();
    fs::write(models.join("notes.txt"), "no model").unwrap();
    folder
}

#[test]
fn a_row_is_what_info_says() {
    let folder = folder();
    let (models, out) = (folder.path().join("models"), folder.path().join("out.jsonl"));
    let missing = models.join("missing.off");
    let run = coface(&["batch", argument(&models), argument(&missing), "-r", "-o", argument(&out), "--json"]);
    let errors = json!({"io": 1, "parse": 2});
    assert_eq!(
        run.json(),
        json!({"output": argument(&out), "files": 7, "errors": errors, "resumed": 0, "remarks": []})
    );
    let found = rows(&out);
    let names = [
        "a torus.off",
        "bad.off",
        "c,\"d\".json",
        "empty.stl",
        "klein.obj",
        "more/sphere.ply",
        "missing.off",
    ];
    assert_eq!(found.len(), names.len());
    for (row, name) in found.iter().zip(names) {
        let path = models.join(name);
        assert_eq!(row["path"], argument(&path));
        assert_eq!(row["bytes"], json!(fs::metadata(&path).ok().map(|found| found.len())));
        let info = coface(&["info", "--json", argument(&path)]);
        if info.status == 0 {
            assert!(row["error"].is_null() && row["seconds"].as_f64().is_some(), "{row}");
            let mut report = row.clone();
            for key in ["path", "bytes", "seconds", "error"] {
                report.as_object_mut().unwrap().remove(key);
            }
            // Rows have one value a column, and no remarks.
            let mut answer = info.json();
            assert!(answer.as_object_mut().unwrap().remove("remarks").is_some());
            assert_eq!(report, answer, "{name}");
        } else {
            assert_eq!(row.as_object().unwrap().len(), 4, "{row}");
            let error = &row["error"];
            let cure = error["cure"].as_str().map_or_else(String::new, |cure| format!("; {cure}"));
            let said = format!("error: {}{cure}\n", error["message"].as_str().unwrap());
            assert_eq!(said, info.fails_with(1), "{name}");
        }
    }
    assert!(!folder.path().join(".out.jsonl.journal").exists(), "the journal goes when the output is there");
}

/// Each model of a list, of lines and of a census has a row, which says what `info` says of the path in it.
#[test]
fn every_model_of_a_file_has_a_row() {
    let folder = tempfile::tempdir().unwrap();
    let sphere = "[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]";
    for (name, text) in [
        ("census.sig", "cMcabbgqw L(3,1) : #1\ncMcabbjak\n".to_owned()),
        ("lines.jsonl", format!("{{\"name\": \"disk\", \"facets\": [[0,1,2]]}}\n{sphere}\n")),
        ("nested.json", format!("[{sphere}, [[0,1,2,3],[1,2,3,4]]]")),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let out = folder.path().join("rows.jsonl");
    // A second run does not take the rows of the first for models.
    for _ in 0..2 {
        coface(&["batch", argument(folder.path()), "-o", argument(&out), "--no-timings", "--json"]).json();
    }
    let found = rows(&out);
    let names: Vec<&str> =
        found.iter().map(|row| row["path"].as_str().unwrap().rsplit_once('/').unwrap().1).collect();
    let expected = [
        "census.sig#L(3,1) : #1",
        "census.sig#2",
        "lines.jsonl#disk",
        "lines.jsonl#2",
        "nested.json#1",
        "nested.json#2",
    ];
    assert_eq!(names, expected);
    for row in &found {
        assert!(row["bytes"].is_u64() && row["error"].is_null(), "{row}");
        let mut info = coface(&["info", "--json", row["path"].as_str().unwrap()]).json();
        let members = info.as_object_mut().unwrap();
        members.remove("remarks");
        for (key, value) in members {
            assert_eq!(&row[key.as_str()], value, "{key} of {}", row["path"]);
        }
    }
    assert_eq!(found[3]["surface"]["type"], found[4]["surface"]["type"]);
}

#[test]
fn the_number_of_jobs_does_not_matter() {
    let folder = folder();
    let (models, out) = (folder.path().join("models"), folder.path().join("out.csv"));
    let table = |jobs: &str| {
        let pattern = models.join("**/*.*");
        let run =
            coface(&["batch", argument(&pattern), "-o", argument(&out), "--jobs", jobs, "--no-timings"]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        assert!(
            run.stdout.ends_with(": 7 files, 3 errors (2 parse, 1 unsupported_format)\n"),
            "{}",
            run.stdout
        );
        fs::read_to_string(&out).unwrap()
    };
    let alone = table("1");
    assert_eq!(table("3"), alone);
    let header = alone.lines().next().unwrap();
    assert!(
        header
            .starts_with("path,bytes,error_kind,error_message,error_cure,format,kind,dimension,f_0,f_1,f_2,")
    );
    assert!(header.contains("betti_0,betti_1,betti_2,torsion_0,torsion_1,torsion_2,area"));
    let of = |name: &str| alone.lines().find(|line| line.contains(name)).unwrap().to_owned();
    assert!(of("klein.obj").contains(",Klein bottle,1,1,0,\"\",2,\"\","), "{}", of("klein.obj"));
    assert!(of("c,\"\"d\"\".json").starts_with('"'), "{}", of("c,"));
    assert!(of("bad.off").contains(",parse,"), "{}", of("bad.off"));
    let columns = header.split(',').count();
    assert!(
        alone
            .lines()
            .skip(1)
            .filter(|line| !line.contains('"'))
            .all(|line| line.split(',').count() == columns)
    );
}

#[test]
fn lists_are_read_and_strict_runs_fail() {
    let folder = folder();
    let (models, out) = (folder.path().join("models"), folder.path().join("out.ndjson"));
    let list = format!("{}\n{}\n", models.join("bad.off").display(), models.join("klein.obj").display());
    let run = coface_reading(&["batch", "-", "-o", argument(&out), "--strict"], list.as_bytes());
    assert_eq!(run.status, 1);
    assert!(run.stderr.contains("1 of 2 rows are errors"), "{}", run.stderr);
    assert_eq!(rows(&out)[1]["name"], "Klein bottle");
    let run = coface_reading(&["batch", "-", "-o", argument(&out), "--quiet"], list.as_bytes());
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
}

#[test]
fn real_files_that_are_tricky_have_rows() {
    let Some(data) = std::env::var_os("COFACE_DATA").map(PathBuf::from) else {
        println!("skipped: COFACE_DATA names no folder");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.jsonl");
    let tricky = data.join("tricky");
    coface(&["batch", argument(&tricky), "-o", argument(&out), "--json"]).json();
    let count = fs::read_dir(&tricky).unwrap().count();
    assert_eq!(rows(&out).len(), count);
    for row in rows(&out) {
        let info = coface(&["info", "--json", row["path"].as_str().unwrap()]);
        assert_eq!(info.status == 0, row["error"].is_null(), "{row}");
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let folder = folder();
    let torus = folder.path().join("models/a torus.off");
    let fails = |words: &[&str], status: i32, part: &str| {
        let run = coface(&[&["batch"], words].concat());
        assert!(run.fails_with(status).contains(part), "{}", run.stderr);
    };
    fails(&[argument(&torus)], 1, "-o");
    fails(&[argument(&torus), "-o", "rows.off"], 1, ".parquet");
    fails(&[argument(&torus), "-o", argument(&folder.path().join("no/rows.csv"))], 1, "folder");
    let out = folder.path().join("rows.csv");
    fails(&[argument(&folder.path().join("models/more/*.stl")), "-o", argument(&out)], 1, "no file fits");
    fails(&[argument(&torus), "-o", argument(&out), "--memory", "1M"], 2, "64M");
    fails(&[argument(&torus), "-o", argument(&out), "--timeout", "soon"], 2, "duration");
    assert!(!out.exists());
    let listed = coface(&["--help"]).stdout;
    assert!(listed.contains("  batch ") && !listed.contains("  worker "), "{listed}");
    assert!(!coface(&["man"]).stdout.contains("worker"), "workers are for pools alone");
}

/// A pipe with a name: whoever reads it waits for a writer.
fn make_pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

#[test]
fn what_never_ends_costs_its_row_alone() {
    let folder = folder();
    let (models, out) = (folder.path().join("models"), folder.path().join("out.jsonl"));
    make_pipe(&models.join("endless.off"));
    let words =
        ["batch", argument(&models), "-o", argument(&out), "--json", "--timeout", "5s", "--jobs", "2"];
    let summary = coface(&words).json();
    assert_eq!(summary["errors"]["time"], 1, "{summary}");
    let time = json!({"kind": "time", "message": "took longer than 5 s", "cure": "allow more time"});
    assert_eq!(row_of(&out, &models.join("endless.off"))["error"], time);
    assert_eq!(row_of(&out, &models.join("klein.obj"))["name"], "Klein bottle");
}

#[test]
fn what_takes_all_memory_costs_its_row_alone() {
    let folder = folder();
    let (models, out) = (folder.path().join("models"), folder.path().join("out.jsonl"));
    // Each simplex of dimension 19 has a million faces; one of dimension 25 has too many for what is free, and is refused at once.
    let many: Vec<Vec<u32>> = (0..10).map(|i| (20 * i..20 * i + 20).collect()).collect();
    fs::write(models.join("many.json"), json!(many).to_string()).unwrap();
    fs::write(models.join("huge.json"), json!([Vec::from_iter(0..26)]).to_string()).unwrap();
    let words =
        ["batch", argument(&models), "-o", argument(&out), "--json", "--timeout", "none", "--memory", "512M"];
    let summary = coface(&words).json();
    assert_eq!(summary["errors"]["memory"], 1, "{summary}");
    let memory = json!({"kind": "memory", "message": "needed more than 512 MiB of memory", "cure": "allow more memory"});
    assert_eq!(row_of(&out, &models.join("many.json"))["error"], memory);
    let huge = row_of(&out, &models.join("huge.json"))["error"].clone();
    assert_eq!(huge["kind"], "too_large");
    assert!(huge["message"].as_str().unwrap().contains("67108863 faces"), "{huge}");
    assert_eq!(row_of(&out, &models.join("klein.obj"))["name"], "Klein bottle");
}

/// The row of a file.
fn row_of(out: &Path, path: &Path) -> Value {
    rows(out).into_iter().find(|row| row["path"] == argument(path)).unwrap()
}

/// A batch that runs.
struct Running(Child);

impl Running {
    fn start(words: &[&str]) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_coface"));
        command.arg("batch").args(words).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        Self(command.spawn().unwrap())
    }

    /// The processes that it started.
    fn workers(&self) -> Vec<u32> {
        let mut found = Vec::new();
        for entry in fs::read_dir("/proc").unwrap().flatten() {
            let id = entry.file_name().to_str().and_then(|name| name.parse::<u32>().ok());
            // What has ended meanwhile has no state.
            if let (Some(id), Ok(state)) = (id, fs::read_to_string(entry.path().join("stat"))) {
                let parent =
                    state.rsplit_once(") ").and_then(|(_, rest)| rest.split(' ').nth(1)?.parse::<u32>().ok());
                if parent == Some(self.0.id()) {
                    found.push(id);
                }
            }
        }
        found
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // It may have ended.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn kill(id: u32) {
    assert!(Command::new("kill").args(["-9", &id.to_string()]).status().unwrap().success());
}

/// Waits until something holds; a minute is for ever.
fn wait_until(what: &str, mut holds: impl FnMut() -> bool) {
    let begin = Instant::now();
    while !holds() {
        assert!(begin.elapsed() < Duration::from_secs(60), "{what}");
        std::thread::sleep(Duration::from_millis(20));
    }
}

fn lines_of(path: &Path) -> usize {
    fs::read(path).map_or(0, |bytes| bytes.iter().filter(|&&byte| byte == b'\n').count())
}

#[test]
fn killed_workers_and_killed_batches_give_the_same_bytes() {
    let folder = folder();
    let models = folder.path().join("models");
    let (out, journal) = (folder.path().join("out.jsonl"), folder.path().join(".out.jsonl.journal"));
    let gate = models.join("gate.off");
    let gate_words =
        [argument(&models), "-r", "-o", argument(&out), "--no-timings", "--jobs", "1", "--timeout", "none"];
    fs::copy(models.join("a torus.off"), &gate).unwrap();
    assert_eq!(coface(&[&["batch"], &gate_words[..]].concat()).status, 0);
    let expected = fs::read(&out).unwrap();
    fs::remove_file(&out).unwrap();

    // The one worker waits at the gate. It is killed, the next one waits there too; then the batch is killed.
    let torus = fs::read(&gate).unwrap();
    fs::remove_file(&gate).unwrap();
    make_pipe(&gate);
    let running = Running::start(&gate_words);
    // The options and the four files before the gate.
    wait_until("rows before the gate", || lines_of(&journal) == 5);
    wait_until("a worker", || running.workers().len() == 1);
    let first = running.workers()[0];
    kill(first);
    wait_until("another worker", || running.workers().iter().any(|&id| id != first));
    assert_eq!(lines_of(&journal), 5, "a worker that was killed costs no row");
    let second = running.workers()[0];
    kill(running.0.id());
    wait_until("the end of the worker", || !Path::new(&format!("/proc/{second}")).exists());
    assert!(!out.exists(), "the output appears whole");
    drop(running);

    // The gate is open. Rows that were finished are not done again.
    fs::remove_file(&gate).unwrap();
    fs::write(&gate, torus).unwrap();
    let summary = coface(&[&["batch", "--json"], &gate_words[..]].concat()).json();
    assert_eq!((&summary["files"], &summary["resumed"]), (&json!(7), &json!(4)));
    assert_eq!(fs::read(&out).unwrap(), expected);
    assert!(!journal.exists());
}

#[test]
fn rows_of_other_options_are_not_taken() {
    let folder = folder();
    let models = folder.path().join("models");
    let (out, journal) = (folder.path().join("out.jsonl"), folder.path().join(".out.jsonl.journal"));
    let gate = models.join("z.off");
    make_pipe(&gate);
    let words = [argument(&models), "-o", argument(&out), "--jobs", "1"];
    let running = Running::start(&words);
    wait_until("rows before the gate", || lines_of(&journal) == 6);
    let twice = coface(&[&["batch"], &words[..]].concat());
    assert!(twice.fails_with(1).contains("another run"), "{}", twice.stderr);
    drop(running);
    fs::remove_file(&gate).unwrap();
    let run = coface(&[&["batch", "--json", "--all"], &words[..]].concat());
    assert_eq!(run.json()["resumed"], 0);
    assert!(run.stderr.contains("other options"), "{}", run.stderr);
}
