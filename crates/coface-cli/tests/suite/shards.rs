//! `coface shard`, `reduce`, `merge` and `homology --parts`: the answers of the whole, from files and worker processes; work that is killed
//! goes on to the same bytes.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a skipped test says so")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// A model made by `coface generate`.
fn generated(folder: &Path, name: &str, arguments: &[&str]) -> PathBuf {
    let path = folder.join(name);
    let run = coface(&[&["generate", "-o", argument(&path)], arguments].concat());
    assert_eq!(run.status, 0, "{}", run.stderr);
    path
}

/// T^3, the Klein bottle times a circle, lens spaces, the projective plane and some solids.
fn spaces(folder: &Path) -> Vec<PathBuf> {
    let make = |name: &str, arguments: &[&str]| generated(folder, name, arguments);
    let circle = folder.join("circle.json");
    std::fs::write(&circle, "[[0,1],[1,2],[0,2]]").unwrap();
    let klein = make("klein.json", &["klein-grid"]);
    vec![
        make("t3.json", &["torus-grid", "--shape", "3,3,3"]),
        make("klein-circle.json", &["product", "--chains", argument(&klein), argument(&circle)]),
        make("lens.json", &["lens", "--p", "5", "--q", "2"]),
        make("rp2.json", &["rp2"]),
        make("grid.mesh", &["grid", "--shape", "3,3,3"]),
        make("cuboids.vtk", &["cuboids", "--shape", "3,2,2"]),
        klein,
    ]
}

/// The names and bytes of the files of a folder but its list, which tells when the input was changed.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let mut files: Vec<(String, Vec<u8>)> = entries
        .map(|entry| (entry.file_name().into_string().unwrap(), std::fs::read(entry.path()).unwrap()))
        .filter(|(name, _)| name != "shards.json")
        .collect();
    files.sort();
    files
}

fn whole(path: &Path, options: &[&str]) -> Value {
    coface(&[&["homology", "--json", argument(path)], options].concat()).json()["homology"].clone()
}

#[test]
fn parts_have_the_homology_of_the_whole() {
    let folder = tempfile::tempdir().unwrap();
    for path in spaces(folder.path()) {
        for parts in ["1", "7", "64"] {
            let answer =
                coface(&["homology", "--json", "--parts", parts, "--fan-in", "4", argument(&path)]).json();
            assert_eq!(answer["homology"], whole(&path, &[]), "{} in {parts}", path.display());
            assert_eq!(answer["f_vector"], coface(&["info", "--json", argument(&path)]).json()["f_vector"]);
            assert_eq!(answer["parts"]["count"].to_string(), parts);
            assert!(answer["parts"]["critical_per_stratum"].as_f64().unwrap() > 0.0);
        }
    }
    let klein = folder.path().join("klein.json");
    for options in [
        &["--coefficients", "f2"][..],
        &["--coefficients", "q"],
        &["--coefficients", "z4", "--cohomology"],
        &["--cohomology"],
    ] {
        let in_parts = coface(
            &[&["homology", "--json", "--parts", "5", "--owners", "random", argument(&klein)], options]
                .concat(),
        );
        assert_eq!(in_parts.json()["homology"], whole(&klein, options), "{options:?}");
    }
    let rp2 = std::fs::read(folder.path().join("rp2.json")).unwrap();
    let read = coface_reading(&["homology", "--json", "--parts", "3", "-"], &rp2).json();
    assert_eq!(read["homology"][1]["torsion"], json!([2]));
}

#[test]
fn verbs_one_by_one_and_all_at_once_make_the_same_files() {
    let folder = tempfile::tempdir().unwrap();
    let klein = generated(folder.path(), "klein.json", &["klein-grid", "--columns", "12", "--rows", "9"]);
    let (by_hand, at_once) = (folder.path().join("by-hand"), folder.path().join("at-once"));
    let made = coface(&[
        "shard",
        argument(&klein),
        "-o",
        argument(&by_hand),
        "--parts",
        "6",
        "--fan-in",
        "2",
        "--json",
    ])
    .json();
    assert_eq!((&made["parts"], &made["fan_in"]), (&json!(6), &json!(2)));
    // What is missing is named, with what makes it.
    let run = coface(&["merge", argument(&by_hand)]);
    let message = run.fails_with(1);
    assert!(
        message.contains("6 of 6 parts")
            && message.contains("coface reduce")
            && message.contains("part-000000.shard"),
        "{message}"
    );
    let shard = |number: u32| by_hand.join(format!("part-{number:06}.shard"));
    let reduced = coface(&["reduce", "--json", argument(&shard(4)), argument(&shard(1))]).json();
    assert_eq!(
        (&reduced["reduced"][0]["number"], &reduced["reduced"][1]["skipped"]),
        (&json!(4), &json!(false))
    );
    let reduced = coface(&["reduce", "--json", argument(&by_hand)]).json();
    let skipped: Vec<bool> =
        reduced["reduced"].as_array().unwrap().iter().map(|step| step["skipped"] == true).collect();
    assert_eq!(skipped, [false, true, false, false, true, false]);
    let generators = folder.path().join("cycles.json");
    let merged =
        coface(&["merge", "--json", argument(&by_hand), "--generators", argument(&generators)]).json();
    assert_eq!(merged["homology"], whole(&klein, &[]));
    let levels: Vec<u64> = merged["parts"]["levels"]
        .as_array()
        .unwrap()
        .iter()
        .map(|level| level["parts"].as_u64().unwrap())
        .collect();
    assert_eq!(levels, [6, 3, 2, 1]);
    let saved: Value = serde_json::from_slice(&std::fs::read(&generators).unwrap()).unwrap();
    assert_eq!(saved["generators"], merged["generators"]);
    let once = coface(&[
        "homology",
        "--json",
        "--parts",
        "6",
        "--fan-in",
        "2",
        "--work",
        argument(&at_once),
        "--memory",
        "600M",
        "--generators",
        "--threads",
        "2",
        argument(&klein),
    ])
    .json();
    assert_eq!(
        (&once["homology"], &once["generators"], &once["parts"]),
        (&merged["homology"], &merged["generators"], &merged["parts"])
    );
    assert!(files(&by_hand) == files(&at_once), "the same bytes");
    // The cycles are cycles that bound as often as they should: asked of the whole.
    for chain in saved["generators"][1].as_array().unwrap() {
        let cycle = folder.path().join("cycle.json");
        std::fs::write(&cycle, chain["chain"].to_string()).unwrap();
        let verdict =
            coface(&["homology", "--json", argument(&klein), "--cycle", argument(&cycle)]).json()["cycles"]
                [0]
            .clone();
        let order = if chain["order"] == 0 { Value::Null } else { chain["order"].clone() };
        assert_eq!((&verdict["multiple"], &verdict["bounds"]), (&order, &json!(false)));
    }
}

#[test]
fn requests_that_parts_do_not_serve_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let rp2 = generated(folder.path(), "rp2.json", &["rp2"]);
    let rp2 = argument(&rp2);
    let list = folder.path().join("owners.txt");
    std::fs::write(&list, "0 1 x").unwrap();
    for (arguments, words) in [
        (&["homology", "--parts", "2", "--harmonic", rp2][..], "--harmonic needs the whole"),
        (&["homology", "--parts", "2", "--relative", "boundary", rp2], "--relative needs"),
        (&["homology", "--parts", "2", "--generators", "a.vtk", rp2], "JSON"),
        (&["homology", "--parts", "2", "--generators", "--coefficients", "q", rp2], "integral cycles"),
        (&["homology", "--memory", "1M", rp2], "too little"),
        (&["shard", rp2, "--parts", "2"], "-o FOLDER"),
        (&["shard", "none.off", "-o", "none", "--parts", "2"], "none.off"),
        (&["homology", "none.off", "--parts", "2"], "none.off"),
        (&["homology", rp2, "--parts", "2", "--owners", "positions"], "no positions"),
        (&["homology", rp2, "--parts", "2", "--owners", argument(&list)], "owners.txt:1"),
        (&["merge", argument(folder.path())], "coface shard"),
        (&["reduce", rp2], ".shard"),
    ] {
        let run = coface(arguments);
        let message = run.fails_with(1);
        assert!(message.contains(words), "{arguments:?}: {message}");
    }
    coface(&["homology", "--parts", "0", rp2]).fails_with(2);
    coface(&["shard", rp2, "-o", "x", "--parts", "2", "--fan-in", "1"]).fails_with(2);
    // Nothing was left behind.
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn a_container_is_a_format_like_others() {
    let folder = tempfile::tempdir().unwrap();
    for path in spaces(folder.path()) {
        let container = path.with_extension("cfc");
        assert_eq!(coface(&["convert", argument(&path), "-o", argument(&container)]).status, 0);
        let info = coface(&["info", "--json", argument(&container)]).json();
        let before = coface(&["info", "--json", argument(&path)]).json();
        assert_eq!((&info["format"], &info["f_vector"]), (&json!("cfc"), &before["f_vector"]));
        assert_eq!(info["homology"], before["homology"]);
        assert_eq!(whole(&container, &["--cohomology"]), whole(&path, &["--cohomology"]));
        let mut bytes = std::fs::read(&container).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 16;
        std::fs::write(&container, bytes).unwrap();
        let run = coface(&["homology", argument(&container)]);
        assert!(
            run.fails_with(1).contains("damaged") || run.stderr.contains("between two"),
            "{}",
            run.stderr
        );
    }
}

/// The brain surface of the development data in parts, and with little memory.
#[test]
fn a_brain_in_parts() {
    let Some(data) = std::env::var_os("COFACE_DATA").map(PathBuf::from) else {
        println!("COFACE_DATA is not set: the brain is skipped");
        return;
    };
    let brain = data.join("surfaces/mni152_wm_isosurface.ply");
    let folder = tempfile::tempdir().unwrap();
    let answer = coface(&[
        "homology",
        "--json",
        "--parts",
        "16",
        "--memory",
        "1G",
        "--work",
        argument(folder.path()),
        argument(&brain),
    ])
    .json();
    assert_eq!(answer["homology"], whole(&brain, &[]));
    let health = answer["parts"]["critical_per_stratum"].as_f64().unwrap();
    assert!(health < 50.0, "{health}");
}

#[cfg(unix)]
mod killed {
    use super::*;
    use nix::sys::signal::{Signal, kill};
    use nix::unistd::Pid;
    use std::process::{Child, Command, Stdio};
    use std::time::{Duration, Instant};

    fn started(arguments: &[&str]) -> Child {
        Command::new(env!("CARGO_BIN_EXE_coface"))
            .args(arguments)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    }

    /// The processes that another has started.
    fn children(of: u32) -> Vec<i32> {
        let mut found = Vec::new();
        for entry in std::fs::read_dir("/proc").unwrap().flatten() {
            let Some(id) = entry.file_name().to_str().and_then(|name| name.parse::<i32>().ok()) else {
                continue;
            };
            let Ok(stat) = std::fs::read_to_string(entry.path().join("stat")) else { continue };
            // The name, in brackets, may have anything in it; then come the state and the parent.
            let parent = stat.rsplit(')').next().and_then(|rest| rest.split_whitespace().nth(1));
            if parent.and_then(|parent| parent.parse().ok()) == Some(of) {
                found.push(id);
            }
        }
        found
    }

    /// Waits until the condition holds, or the process has ended.
    fn wait_for(child: &mut Child, mut condition: impl FnMut() -> bool) -> bool {
        let begin = Instant::now();
        while begin.elapsed() < Duration::from_secs(120) {
            if condition() {
                return true;
            }
            if child.try_wait().unwrap().is_some() {
                return false;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        panic!("nothing happened in two minutes");
    }

    fn has(folder: &Path, start: &str, end: &str) -> bool {
        std::fs::read_dir(folder).is_ok_and(|entries| {
            entries.flatten().any(|entry| {
                entry.file_name().to_str().is_some_and(|name| name.starts_with(start) && name.ends_with(end))
            })
        })
    }

    /// Random owners: so that what is left of parts is large and merges take their time.
    fn arguments<'a>(input: &'a Path, work: &'a Path) -> Vec<&'a str> {
        vec![
            "homology",
            "--json",
            "--parts",
            "12",
            "--fan-in",
            "3",
            "--owners",
            "random",
            "--threads",
            "2",
            "--work",
            argument(work),
            argument(input),
        ]
    }

    #[test]
    fn killed_workers_are_started_again_and_bytes_are_the_same() {
        let folder = tempfile::tempdir().unwrap();
        let input = generated(folder.path(), "t3.json", &["torus-grid", "--shape", "9,9,8"]);
        let (quiet, disturbed) = (folder.path().join("quiet"), folder.path().join("disturbed"));
        let expected = coface(&arguments(&input, &quiet)).json();
        assert_eq!(expected["homology"], whole(&input, &[]));
        // One worker killed while parts are reduced, one while they are merged.
        for (start, end) in [("part-", ".reduced"), ("level-1", ".reduced")] {
            let _ = std::fs::remove_dir_all(&disturbed);
            let mut child = started(&arguments(&input, &disturbed));
            let program = child.id();
            let is_killed = wait_for(&mut child, || has(&disturbed, start, end))
                && wait_for(&mut child, || {
                    let workers = children(program);
                    workers
                        .first()
                        .is_some_and(|&worker| kill(Pid::from_raw(worker), Signal::SIGKILL).is_ok())
                });
            let output = child.wait_with_output().unwrap();
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
            assert_eq!(answer, expected);
            let mut left = files(&disturbed);
            // What a killed worker had not finished stays under a hidden name.
            left.retain(|(name, _)| !name.starts_with('.'));
            assert!(left == files(&quiet), "the same bytes after {start}");
            assert!(is_killed, "the work was done before a worker could be killed");
        }
    }

    #[test]
    fn a_killed_program_goes_on_where_it_was() {
        let folder = tempfile::tempdir().unwrap();
        let input = generated(folder.path(), "t3.json", &["torus-grid", "--shape", "8,8,8"]);
        let (quiet, killed) = (folder.path().join("quiet"), folder.path().join("killed"));
        let expected = coface(&arguments(&input, &quiet)).json();
        // In the middle of reducing, then in the middle of merging, then to the end.
        for (start, end) in [("part-000003", ".reduced"), ("level-1", ".reduced")] {
            let mut child = started(&arguments(&input, &killed));
            if wait_for(&mut child, || has(&killed, start, end)) {
                child.kill().unwrap();
            }
            child.wait().unwrap();
        }
        let kept = killed.join("part-000003.reduced");
        let before = std::fs::metadata(&kept).unwrap().modified().unwrap();
        assert_eq!(coface(&arguments(&input, &killed)).json(), expected);
        assert_eq!(std::fs::metadata(&kept).unwrap().modified().unwrap(), before, "what is finished is kept");
        let whole_files = |folder: &Path| {
            let mut all = files(folder);
            // What a killed worker had not finished stays under a hidden name.
            all.retain(|(name, _)| !name.starts_with('.'));
            all
        };
        assert!(whole_files(&killed) == whole_files(&quiet), "the same bytes");
    }

    #[test]
    fn a_part_too_large_for_the_memory_says_how_many_to_cut() {
        let folder = tempfile::tempdir().unwrap();
        let input = generated(folder.path(), "grid.mesh", &["grid", "--shape", "28,28,28"]);
        let work = folder.path().join("work");
        let shards = coface(&["shard", argument(&input), "-o", argument(&work), "--parts", "1"]);
        assert_eq!(shards.status, 0, "{}", shards.stderr);
        // An allocation may fail as a reader asks for it, and is an error there, or anywhere, and ends the worker.
        for memory in ["70M", "75M", "80M", "85M"] {
            let run = coface(&["homology", "--memory", memory, "--parts", "1", argument(&input)]);
            let message = run.fails_with(1);
            assert!(
                message.contains("memory") && (message.contains("--parts 2") || message.contains("cut")),
                "{message}"
            );
        }
        // As many as memory asks for.
        let answer = coface(&["homology", "--json", "--memory", "700M", argument(&input)]).json();
        assert_eq!(
            answer["homology"],
            json!([{"degree": 0, "betti": 1, "torsion": []}, {"degree": 1, "betti": 0, "torsion": []},
            {"degree": 2, "betti": 0, "torsion": []}, {"degree": 3, "betti": 0, "torsion": []}])
        );
    }
}
