//! `cargo run -p coface-fuzz-checks --example replay NAME FILE..` runs one check on files, such as the ones that a fuzz target has left behind.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a developer tool talks to a terminal")]

use coface_fuzz_checks::CHECKS;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let found = words.first().and_then(|name| CHECKS.iter().find(|(known, _)| known == name));
    let Some((_, check)) = found else {
        let names: Vec<&str> = CHECKS.iter().map(|(name, _)| *name).collect();
        eprintln!("usage: replay NAME FILE..\nNAME is one of {}", names.join(", "));
        return ExitCode::from(2);
    };
    let mut is_clean = true;
    for path in &words[1..] {
        println!("{path}");
        let begin = Instant::now();
        match std::fs::read(path) {
            Ok(bytes) => is_clean &= std::panic::catch_unwind(|| check(&bytes)).is_ok(),
            Err(error) => {
                eprintln!("{path}: {error}");
                is_clean = false;
            }
        }
        println!("  {:.2} s", begin.elapsed().as_secs_f64());
    }
    if is_clean { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
