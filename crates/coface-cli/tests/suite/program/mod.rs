//! Running the program as a user does.

use serde_json::Value;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// What a run of the program left behind.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) status: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

/// Runs `coface` with these arguments, without standard input.
pub(crate) fn coface(arguments: &[&str]) -> Run {
    coface_reading(arguments, b"")
}

/// Runs `coface` in this folder with these arguments, without standard input.
pub(crate) fn coface_in(folder: &Path, arguments: &[&str]) -> Run {
    run(Command::new(env!("CARGO_BIN_EXE_coface")).current_dir(folder), arguments, b"")
}

/// Runs `coface` with these arguments and these bytes on standard input.
pub(crate) fn coface_reading(arguments: &[&str], input: &[u8]) -> Run {
    run(&mut Command::new(env!("CARGO_BIN_EXE_coface")), arguments, input)
}

fn run(program: &mut Command, arguments: &[&str], input: &[u8]) -> Run {
    let mut child = program
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("standard input is a pipe");
    let input = input.to_vec();
    // The program may end before it has read everything.
    let writer = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().expect("the program ends");
    writer.join().expect("writing does not panic");
    Run {
        status: output.status.code().expect("no signal ended the program"),
        stdout: String::from_utf8(output.stdout).expect("output is text"),
        stderr: String::from_utf8(output.stderr).expect("messages are text"),
    }
}

impl Run {
    /// The one JSON object on standard output of a run that succeeded.
    #[track_caller]
    pub(crate) fn json(&self) -> Value {
        assert_eq!(self.status, 0, "{}", self.stderr);
        let value: Value = serde_json::from_str(&self.stdout).expect("output is JSON");
        assert!(value.is_object(), "{value}");
        value
    }

    /// Asserts that the run failed with this status and one message, and printed nothing; gives the message.
    #[track_caller]
    pub(crate) fn fails_with(&self, status: i32) -> &str {
        assert_eq!(self.status, status, "stdout: {}\nstderr: {}", self.stdout, self.stderr);
        assert_eq!(self.stdout, "", "nothing is printed by a run that fails");
        let errors = self.stderr.lines().filter(|line| line.starts_with("error: ")).count();
        assert_eq!(errors, 1, "one message: {}", self.stderr);
        assert!(
            !self.stderr.contains("panicked") && !self.stderr.contains("RUST_BACKTRACE"),
            "{}",
            self.stderr
        );
        &self.stderr
    }
}

/// The path as an argument.
pub(crate) fn argument(path: &Path) -> &str {
    path.to_str().expect("paths of tests are text")
}
