//! `cargo xtask soak --plane`: the laws of the Boolean algebra over chains of operations of sets with spline boundaries.

use crate::cargo;
use std::path::PathBuf;
use std::process::{Command, ExitCode};
use std::time::Instant;

const USAGE: &str = "usage: cargo xtask soak --plane [--chains N] [--suite PATH]
  chains of ten operations of sets with kinks and without, orders 4, 6 and 8: at each step results meet their own operands, and absorption,
  De Morgan's laws and (a & b) | (a - b) = a hold; and pairs of sets of all sizes, near the origin and far from it, equal, nearly equal and
  others, whose areas have to be within their bounds, with at most one refusal in forty; prints how many chains ran, were refused, or broke a law, and exits with status 1 if one did
  --chains N      how many chains [1000]
  --suite PATH    the test program of coface-yin to run; without it it is built";

/// The tests that count.
const TESTS: [&str; 3] = [
    "chains_of_operations_keep_the_laws",
    "laws_hold_for_results_that_lost_their_carriers",
    "sets_of_all_sizes_keep_the_laws",
];

pub(crate) fn soak(words: &[String]) -> ExitCode {
    let Some((chains, suite)) = parse(words) else {
        eprintln!("{USAGE}");
        return ExitCode::from(2);
    };
    let mut command = match suite {
        Some(path) => Command::new(path),
        None => {
            let mut command = cargo(&["test", "--package", "coface-yin", "--test", "suite"]);
            command.arg("--");
            command
        }
    };
    let start = Instant::now();
    let status = command.args(TESTS).arg("--nocapture").env("COFACE_SOUPS", chains.to_string()).status();
    let is_good = status.is_ok_and(|status| status.success());
    println!(
        "{chains} chains and twice {chains} pairs of sets in {:.0} s: {}",
        start.elapsed().as_secs_f64(),
        if is_good {
            "none refused, no law broken"
        } else {
            "the seeds that were refused or broke a law are above"
        }
    );
    if is_good { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn parse(words: &[String]) -> Option<(u64, Option<PathBuf>)> {
    let (mut chains, mut suite) = (1000, None);
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match word.as_str() {
            "--chains" => chains = words.next()?.parse().ok().filter(|&chains| chains > 0)?,
            "--suite" => suite = Some(words.next()?.into()),
            _ => return None,
        }
    }
    Some((chains, suite))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_read() {
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(parse(&words("")), Some((1000, None)));
        assert_eq!(parse(&words("--chains 7 --suite a/b")), Some((7, Some("a/b".into()))));
        for wrong in ["--chains", "--chains 0", "--chains x", "--steps 3"] {
            assert_eq!(parse(&words(wrong)), None, "{wrong}");
        }
    }
}
