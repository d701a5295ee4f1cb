//! Outputs that appear whole or not at all, on a full disk, beside another run, and when the program is killed.

#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{coface, coface_in};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

const PROGRAM: &str = env!("CARGO_BIN_EXE_coface");
const SPHERE: &str = "[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]";

/// All files below a folder, by their paths in it, and the folders, which have a slash behind and no bytes.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    // Workers of a run that was killed may still remove theirs.
    fn still<T>(found: std::io::Result<T>) -> Option<T> {
        found.map_err(|error| assert_eq!(error.kind(), std::io::ErrorKind::NotFound, "{error}")).ok()
    }
    let mut found = BTreeMap::new();
    let mut pending = vec![folder.to_path_buf()];
    while let Some(next) = pending.pop() {
        for entry in still(fs::read_dir(&next)).into_iter().flatten() {
            let Some(path) = still(entry).map(|entry| entry.path()) else { continue };
            let name = path.strip_prefix(folder).unwrap().to_str().unwrap().to_owned();
            if name.ends_with("shards.json") {
                // It tells when the input was changed.
                found.insert(name, Vec::new());
            } else if path.is_dir() {
                found.insert(format!("{name}/"), Vec::new());
                pending.push(path);
            } else if let Some(bytes) = still(fs::read(&path)) {
                found.insert(name, bytes);
            }
        }
    }
    found
}

/// Starts a run in a folder, whose folder for temporary files is `temporary`.
fn start(folder: &Path, arguments: &[&str]) -> Child {
    fs::create_dir_all(folder.join("temporary")).unwrap();
    Command::new(PROGRAM)
        .current_dir(folder)
        .env("TMPDIR", folder.join("temporary"))
        .args(arguments)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Runs where no file may grow beyond so many blocks of 512 bytes: a disk that is full.
fn on_full_disk(folder: &Path, blocks: u32, arguments: &[&str]) -> Output {
    fs::create_dir_all(folder.join("temporary")).unwrap();
    Command::new("sh")
        .args(["-c", "trap '' XFSZ; ulimit -f \"$0\"; exec \"$@\"", &blocks.to_string(), PROGRAM])
        .args(arguments)
        .current_dir(folder)
        .env("TMPDIR", folder.join("temporary"))
        .stdin(Stdio::null())
        .output()
        .unwrap()
}

fn message(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A folder with models to work on.
fn inputs() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("sphere.json"), SPHERE).unwrap();
    let run = coface_in(
        folder.path(),
        &["generate", "torus", "--columns", "30", "--rows", "20", "-o", "torus.off"],
    );
    assert_eq!(run.status, 0, "{}", run.stderr);
    fs::create_dir(folder.path().join("many")).unwrap();
    for i in 0..12 {
        fs::write(folder.path().join(format!("many/{i:02}.json")), SPHERE).unwrap();
    }
    folder
}

/// Long work, by its arguments; each writes `out` or into it.
const JOBS: [&[&str]; 9] = [
    &["generate", "torus", "--columns", "30", "--rows", "20", "-o", "out.obj"],
    &["convert", "torus.off", "-o", "out.ply"],
    &["convert", "torus.off", "-o", "out.glb"],
    &["view", "torus.off", "-o", "out.html"],
    &["info", "torus.off", "-o", "out.html"],
    &["man", "-o", "out/pages"],
    &["shard", "torus.off", "--parts", "5", "-o", "out/shards"],
    &["homology", "torus.off", "--parts", "5", "--work", "out", "--json"],
    &["batch", "many", "-o", "out.csv", "--no-timings", "--jobs", "2"],
];

#[test]
fn a_full_disk_leaves_what_was_there() {
    for job in JOBS {
        let folder = inputs();
        fs::create_dir(folder.path().join("temporary")).unwrap();
        let before = files(folder.path());
        let mut failures = 0;
        for blocks in [0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128] {
            let output = on_full_disk(folder.path(), blocks, job);
            if output.status.success() {
                break;
            }
            failures += 1;
            let said = message(&output);
            assert_eq!(output.status.code(), Some(1), "{job:?} {blocks}: {said}");
            let errors = said.lines().filter(|line| line.starts_with("error: ")).count();
            assert_eq!(errors, 1, "{job:?} {blocks}: {said}");
            let mut after = files(folder.path());
            if said.contains("finished rows are kept") || said.contains("finished row is kept") {
                assert!(after.remove(".out.csv.journal").is_some(), "{job:?} {blocks}");
            }
            let [before, after] = [&before, &after].map(|files| files.keys().cloned().collect::<Vec<_>>());
            if job.contains(&"--work") {
                // What is finished is whole and is used again: shards and reduced shards.
                let is_half = |name: &&String| !before.contains(name) && !name.starts_with("out/");
                assert_eq!(after.iter().filter(is_half).count(), 0, "{job:?} {blocks}: {after:?}");
                assert!(!after.iter().any(|name| name.contains(".coface")), "{job:?} {blocks}: {after:?}");
            } else {
                assert_eq!(after, before, "{job:?} {blocks}");
            }
        }
        assert!(failures > 0, "{job:?}");
        // With room the work goes on, or begins anew, and is right.
        let run = coface_in(folder.path(), job);
        assert_eq!(run.status, 0, "{job:?}: {}", run.stderr);
    }
}

#[test]
fn an_older_output_survives_a_full_disk() {
    for (job, out) in [
        (JOBS[0], "out.obj"),
        (JOBS[2], "out.glb"),
        (JOBS[3], "out.html"),
        (JOBS[4], "out.html"),
        (JOBS[8], "out.csv"),
    ] {
        let folder = inputs();
        fs::write(folder.path().join(out), "precious").unwrap();
        let output = on_full_disk(folder.path(), 1, job);
        assert_eq!(output.status.code(), Some(1), "{job:?}: {}", message(&output));
        assert_eq!(fs::read(folder.path().join(out)).unwrap(), b"precious", "{job:?}");
    }
    // Pages of the manual are replaced together.
    let folder = inputs();
    let run = coface_in(folder.path(), &["man", "-o", "pages"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let before = files(&folder.path().join("pages"));
    assert!(before.len() > 20);
    fs::write(folder.path().join("pages/coface.1"), "precious").unwrap();
    // The first page fits, a later one does not.
    let sizes: Vec<usize> = before.values().map(Vec::len).collect();
    let blocks = (sizes.iter().max().unwrap() - 1) / 512;
    assert_eq!(on_full_disk(folder.path(), blocks as u32, &["man", "-o", "pages"]).status.code(), Some(1));
    assert_eq!(fs::read(folder.path().join("pages/coface.1")).unwrap(), b"precious");
    assert_eq!(files(&folder.path().join("pages")).len(), before.len());
}

#[test]
fn a_target_that_may_not_be_written_is_not_replaced() {
    use std::os::unix::fs::PermissionsExt;
    for (job, out) in [
        (JOBS[0], "out.obj"),
        (JOBS[1], "out.ply"),
        (JOBS[2], "out.glb"),
        (JOBS[3], "out.html"),
        (JOBS[4], "out.html"),
        (JOBS[8], "out.csv"),
        (&["info", "torus.off", "-o", "out.json"], "out.json"),
        (&["render", "torus.off", "-o", "out.svg"], "out.svg"),
        (&["render", "torus.off", "-o", "out.png"], "out.png"),
    ] {
        let folder = inputs();
        let target = folder.path().join(out);
        fs::write(&target, "precious").unwrap();
        fs::set_permissions(&target, fs::Permissions::from_mode(0o444)).unwrap();
        let run = coface_in(folder.path(), job);
        assert_eq!(run.status, 1, "{job:?}");
        assert!(run.stderr.contains("may not be written"), "{job:?}: {}", run.stderr);
        assert_eq!(fs::read(&target).unwrap(), b"precious", "{job:?}");
        // Where it may be written it is, and its permissions stay.
        fs::set_permissions(&target, fs::Permissions::from_mode(0o640)).unwrap();
        let run = coface_in(folder.path(), job);
        assert_eq!(run.status, 0, "{job:?}: {}", run.stderr);
        assert_ne!(fs::read(&target).unwrap(), b"precious", "{job:?}");
        assert_eq!(fs::metadata(&target).unwrap().permissions().mode() & 0o777, 0o640, "{job:?}");
    }
}

#[test]
fn the_file_that_a_link_points_at_is_replaced() {
    let folder = inputs();
    fs::create_dir(folder.path().join("deep")).unwrap();
    std::os::unix::fs::symlink("deep/real.obj", folder.path().join("out.obj")).unwrap();
    for _ in 0..2 {
        let run = coface_in(folder.path(), JOBS[0]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        assert!(fs::symlink_metadata(folder.path().join("out.obj")).unwrap().is_symlink());
        assert!(fs::metadata(folder.path().join("deep/real.obj")).unwrap().len() > 1000);
    }
    assert_eq!(fs::read_dir(folder.path().join("deep")).unwrap().count(), 1);
}

#[cfg(target_os = "linux")]
#[test]
fn everything_printed_to_a_full_device_is_an_error() {
    let folder = inputs();
    for arguments in [
        &["--help"][..],
        &["-h"],
        &["--version"],
        &["help"],
        &["help", "info"],
        &["info", "--help"],
        &["yin", "info", "-h"],
        &["man"],
        &["completions", "zsh"],
        &["info", "sphere.json"],
        &["info", "sphere.json", "--json"],
        &["convert", "sphere.json", "--to", "json"],
        &["homology", "sphere.json", "--parts", "2"],
        &["batch", "many", "-o", "out.csv"],
        &["info", "sphere.json", "-o", "/dev/full"],
        &["info", "sphere.json", "-o", "/dev/stdout"],
    ] {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = Command::new(PROGRAM)
            .current_dir(folder.path())
            .args(arguments)
            .stdout(full)
            .stderr(Stdio::piped())
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(message(&output).starts_with("error: "), "{arguments:?}: {}", message(&output));
    }
    // A reader that goes away has what it wants, and help is status 0 where it can be read.
    assert_eq!(coface(&["--help"]).status, 0);
    assert!(coface(&["--version"]).stdout.starts_with("coface "));
}

/// Numbers that look random, the same in each run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn below(&mut self, time: Duration) -> Duration {
        Duration::from_micros(self.next() % (time.as_micros() as u64).max(1))
    }
}

/// How often long work is killed: more by the variable `COFACE_KILLS`.
fn kills() -> usize {
    std::env::var("COFACE_KILLS").ok().and_then(|count| count.parse().ok()).unwrap_or(10)
}

/// Kills a job at random times, each time over what the last one has left; then it must finish, and give what it
/// gives undisturbed.
fn killed_at_random(seed: u64, job: &[&str]) {
    let undisturbed = inputs();
    let begin = Instant::now();
    let output = start(undisturbed.path(), job).wait_with_output().unwrap();
    let time = begin.elapsed();
    assert!(output.status.success(), "{job:?}: {}", message(&output));
    let expected = files(undisturbed.path());

    let folder = inputs();
    let mut random = Random(seed);
    for _ in 0..kills() {
        let mut child = start(folder.path(), job);
        std::thread::sleep(random.below(time));
        child.kill().unwrap();
        child.wait().unwrap();
        for (name, bytes) in files(folder.path()) {
            // What has its name is whole; else it is hidden, or of a folder of the program.
            if let Some(expected) = expected.get(&name) {
                assert!(bytes == *expected, "{job:?}: {name} is half");
            } else {
                let is_hidden =
                    name.split('/').any(|part| part.starts_with('.')) || name.starts_with("temporary/");
                assert!(is_hidden || name.ends_with('/'), "{job:?}: {name} is left");
            }
        }
    }
    // Workers of the last run may still be about to end.
    std::thread::sleep(Duration::from_millis(300));
    let deadline = Instant::now() + Duration::from_secs(20);
    let finished = loop {
        let finished = start(folder.path(), job).wait_with_output().unwrap();
        if finished.status.success() || Instant::now() > deadline {
            break finished;
        }
        assert!(message(&finished).contains("another run"), "{job:?}: {}", message(&finished));
        std::thread::sleep(Duration::from_millis(50));
    };
    assert!(finished.status.success(), "{job:?}: {}", message(&finished));
    if job.contains(&"--json") {
        let [a, b] =
            [&output, &finished].map(|output| serde_json::from_slice::<Value>(&output.stdout).unwrap());
        assert_eq!(a["homology"], b["homology"], "{job:?}");
    }
    let found = files(folder.path());
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&found), names(&expected), "{job:?}: nothing is left of the runs that were killed");
    assert!(found == expected, "{job:?}: other bytes");
}

#[test]
fn a_file_that_is_written_is_whole_or_not_there_when_the_program_is_killed() {
    killed_at_random(1, &["generate", "torus", "--columns", "300", "--rows", "200", "-o", "out.obj"]);
    killed_at_random(2, JOBS[5]);
}

#[test]
fn shards_are_whole_or_not_there_when_the_program_is_killed() {
    killed_at_random(3, JOBS[6]);
}

#[test]
fn work_in_parts_goes_on_when_the_program_is_killed() {
    killed_at_random(4, JOBS[7]);
}

#[test]
fn a_batch_goes_on_when_the_program_is_killed() {
    killed_at_random(5, JOBS[8]);
}

#[test]
fn an_interrupt_leaves_no_lock_and_no_scratch_file() {
    let mut random = Random(7);
    for job in [JOBS[6], JOBS[7]] {
        let folder = inputs();
        let begin = Instant::now();
        assert!(start(folder.path(), job).wait_with_output().unwrap().status.success());
        let time = begin.elapsed();
        for signal in ["-INT", "-TERM"].repeat(4) {
            let _ = fs::remove_dir_all(folder.path().join("out"));
            let mut child = start(folder.path(), job);
            std::thread::sleep(random.below(time));
            // It may have ended already.
            let _ =
                Command::new("kill").args([signal, &child.id().to_string()]).stderr(Stdio::null()).status();
            let ended = child.wait().unwrap();
            assert!(
                [Some(0), Some(130), Some(143), None].contains(&ended.code()),
                "{job:?} {signal}: {ended:?}"
            );
            // A signal before the program is ready for it ends it as it does others: then there is nothing yet. Workers end soon after.
            let left = || -> Vec<String> {
                files(folder.path()).into_keys().filter(|name| name.contains(".coface")).collect()
            };
            let deadline = Instant::now() + Duration::from_secs(20);
            while !left().is_empty() && Instant::now() < deadline {
                std::thread::sleep(Duration::from_millis(20));
            }
            assert_eq!(left(), [""; 0], "{job:?} {signal}");
        }
    }
}

#[test]
fn temporary_folders_of_the_dead_are_removed_by_the_next_run() {
    let parts = &["homology", "torus.off", "--parts", "5", "--json"];
    killed_at_random(6, parts);
    // The folder is private while it is there.
    use std::os::unix::fs::PermissionsExt;
    let folder = inputs();
    // A run may be over before it is looked at.
    let (mut child, mode) = (0..20)
        .find_map(|_| {
            let mut child = start(folder.path(), &["homology", "torus.off", "--parts", "40", "--json"]);
            while child.try_wait().unwrap().is_none() {
                let entry = fs::read_dir(folder.path().join("temporary")).unwrap().next();
                if let Some(found) = entry.and_then(|entry| entry.ok()?.metadata().ok()) {
                    return Some((child, found.permissions().mode() & 0o7777));
                }
            }
            None
        })
        .expect("a temporary folder is seen");
    assert_eq!(mode, 0o700);
    // What others have put there stays, links among them.
    let temporary = folder.path().join("temporary");
    fs::create_dir(folder.path().join("precious")).unwrap();
    fs::write(folder.path().join("precious/.coface-owner"), "").unwrap();
    std::os::unix::fs::symlink(folder.path().join("precious"), temporary.join("coface-parts-abcdefabcdef"))
        .unwrap();
    child.kill().unwrap();
    child.wait().unwrap();
    let run = start(folder.path(), parts).wait_with_output().unwrap();
    assert!(run.status.success(), "{}", message(&run));
    assert!(folder.path().join("precious/.coface-owner").exists());
    assert_eq!(fs::read_dir(&temporary).unwrap().count(), 1);
}

#[test]
fn two_runs_at_once_are_both_right_or_one_is_told() {
    for (job, most) in [(JOBS[6], 6), (JOBS[7], 6), (JOBS[8], 6), (JOBS[5], 3), (JOBS[0], 3)] {
        let undisturbed = inputs();
        let output = start(undisturbed.path(), job).wait_with_output().unwrap();
        assert!(output.status.success(), "{job:?}: {}", message(&output));
        let expected = files(undisturbed.path());
        for _ in 0..most {
            let folder = inputs();
            let runs: Vec<Child> = (0..2).map(|_| start(folder.path(), job)).collect();
            let outputs: Vec<Output> = runs.into_iter().map(|run| run.wait_with_output().unwrap()).collect();
            let mut successes = 0;
            for output in &outputs {
                if output.status.success() {
                    successes += 1;
                } else {
                    assert_eq!(output.status.code(), Some(1), "{job:?}");
                    assert!(message(output).contains("another run"), "{job:?}: {}", message(output));
                }
            }
            assert!(successes > 0, "{job:?}: one of them works");
            assert!(files(folder.path()) == expected, "{job:?}: {:?}", files(folder.path()).keys());
        }
    }
}

/// The processes that this one has started and that have not ended.
#[cfg(target_os = "linux")]
fn children(parent: u32) -> Vec<u32> {
    let stat = |entry: fs::DirEntry| -> Option<(u32, u32)> {
        let number = entry.file_name().to_str()?.parse().ok()?;
        let (state, above) = state_of(number)?;
        (state != 'Z').then_some((number, above))
    };
    let all = fs::read_dir("/proc").unwrap().filter_map(Result::ok).filter_map(stat);
    all.filter(|&(_, above)| above == parent).map(|(number, _)| number).collect()
}

/// The state of a process and its parent.
#[cfg(target_os = "linux")]
fn state_of(number: u32) -> Option<(char, u32)> {
    let text = fs::read_to_string(format!("/proc/{number}/stat")).ok()?;
    let mut words = text.rsplit_once(") ")?.1.split(' ');
    Some((words.next()?.chars().next()?, words.next()?.parse().ok()?))
}

#[cfg(target_os = "linux")]
#[test]
fn workers_end_when_their_parent_is_killed() {
    let folder = inputs();
    let run = coface_in(
        folder.path(),
        &["generate", "torus", "--columns", "900", "--rows", "600", "-o", "large.obj"],
    );
    assert_eq!(run.status, 0, "{}", run.stderr);
    for job in [
        &["batch", "large.obj", "-o", "out.csv", "--timeout", "none"][..],
        &["homology", "large.obj", "--parts", "4", "--json"],
    ] {
        let mut parent = start(folder.path(), job);
        let deadline = Instant::now() + Duration::from_secs(60);
        let workers = loop {
            let found = children(parent.id());
            if !found.is_empty() {
                break found;
            }
            assert!(
                Instant::now() < deadline && parent.try_wait().unwrap().is_none(),
                "{job:?}: no worker was seen"
            );
            std::thread::sleep(Duration::from_millis(1));
        };
        // At work, not on the way to it.
        std::thread::sleep(Duration::from_millis(200));
        assert!(parent.try_wait().unwrap().is_none(), "{job:?} is over too soon for this test");
        parent.kill().unwrap();
        parent.wait().unwrap();
        let deadline = Instant::now() + Duration::from_secs(20);
        for worker in workers {
            while state_of(worker).is_some_and(|(state, _)| state != 'Z') {
                assert!(Instant::now() < deadline, "{job:?}: a worker lives on");
                std::thread::sleep(Duration::from_millis(10));
            }
        }
    }
}

#[test]
fn text_has_no_name_of_another_format() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("sphere.json"), SPHERE).unwrap();
    for verb in ["info", "homology", "pi1", "subgroups"] {
        for name in ["answer.off", "answer.PDF", "answer.csv"] {
            let run = coface_in(folder.path(), &[verb, "sphere.json", "-o", name]);
            let said = run.fails_with(1);
            assert!(said.contains(name) && !folder.path().join(name).exists(), "{verb} {said}");
        }
        for name in ["answer.txt", "answer.json", "answer"] {
            assert_eq!(coface_in(folder.path(), &[verb, "sphere.json", "-o", name]).status, 0);
            fs::remove_file(folder.path().join(name)).unwrap();
        }
    }
}

#[test]
fn nothing_is_written_of_inputs_that_all_failed() {
    let folder = tempfile::tempdir().unwrap();
    let run = coface_in(folder.path(), &["info", "no.off", "none.off", "-o", "answer.txt"]);
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    assert_eq!(files(folder.path()), BTreeMap::new());
}
