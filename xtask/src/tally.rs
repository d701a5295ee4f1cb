//! Counts what passed, failed and was skipped, and what took how long.

/// What a run of checks came to.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Tally {
    pub(crate) passed: usize,
    pub(crate) failed: usize,
    pub(crate) skipped: usize,
    /// Stages and programs of tests with their seconds.
    times: Vec<(String, f64)>,
    /// Stages that failed with what they said.
    failures: Vec<(String, Vec<String>)>,
}

impl Tally {
    /// A run that did not come to its end.
    pub(crate) fn of_panic() -> Self {
        Self {
            failed: 1,
            failures: vec![("the checks themselves panicked".to_owned(), Vec::new())],
            ..Self::default()
        }
    }

    /// Adds another run.
    pub(crate) fn add(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.skipped += other.skipped;
        self.times.extend(other.times);
        self.failures.extend(other.failures);
    }

    /// Says what is skipped and why.
    pub(crate) fn skip(&mut self, what: &str, why: &str) {
        println!("== skipped: {what} ({why})");
        self.skipped += 1;
    }

    /// Keeps the time of a stage or of a program of tests.
    pub(crate) fn time(&mut self, name: &str, seconds: f64) {
        self.times.push((name.to_owned(), seconds));
    }

    /// Keeps the name of a stage that failed, and what it said.
    pub(crate) fn fail(&mut self, name: &str, said: &[String]) {
        self.failures.push((name.to_owned(), abridged(said)));
    }

    /// The slowest of all, and what failed: a log is often cut, and its end is read first.
    pub(crate) fn to_text(&self) -> String {
        let mut times: Vec<&(String, f64)> = self.times.iter().collect();
        times.sort_by(|a, b| b.1.total_cmp(&a.1));
        let slowest = times.iter().take(10).map(|(name, seconds)| format!("  {seconds:>7.1} s  {name}\n"));
        let failures = self.failures.iter().map(|(name, said)| {
            let said: String = said.iter().map(|line| format!("    {line}\n")).collect();
            format!("  failed: {name}\n{said}")
        });
        format!("slowest:\n{}{}", slowest.collect::<String>(), failures.collect::<String>())
    }

    /// Counts a check.
    pub(crate) fn count(&mut self, has_passed: bool) {
        *(if has_passed { &mut self.passed } else { &mut self.failed }) += 1;
    }

    /// Adds the counts of a closing line of `cargo test` or of pytest; other lines count nothing.
    ///
    /// The lines are `test result: ok. 3 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.01s` and
    /// `1 failed, 3 passed, 2 skipped in 0.12s`.
    pub(crate) fn add_line(&mut self, line: &str) {
        let of_pytest = || {
            let (counts, time) = line.trim_matches(['=', ' ']).rsplit_once(" in ")?;
            let begins = counts.starts_with(|sign: char| sign.is_ascii_digit());
            (begins && time.starts_with(|sign: char| sign.is_ascii_digit())).then_some(counts)
        };
        let Some(counts) = line.strip_prefix("test result: ").or_else(of_pytest) else { return };
        let words: Vec<&str> = counts.split([' ', ';', ',']).filter(|word| !word.is_empty()).collect();
        for pair in words.windows(2) {
            let Ok(count) = pair[0].parse::<usize>() else { continue };
            match pair[1] {
                "passed" => self.passed += count,
                "failed" | "error" | "errors" => self.failed += count,
                "ignored" | "skipped" | "xfailed" => self.skipped += count,
                _ => {}
            }
        }
    }

    /// The closing line.
    pub(crate) fn to_line(&self) -> String {
        format!("{} passed, {} failed, {} skipped", self.passed, self.failed, self.skipped)
    }
}

/// At most 100 lines: the first ones, and those of the end, where the names stand.
fn abridged(said: &[String]) -> Vec<String> {
    const FIRST: usize = 60;
    const LAST: usize = 40;
    if said.len() <= FIRST + LAST {
        return said.to_vec();
    }
    let between = format!("... {} more lines ...", said.len() - FIRST - LAST);
    [&said[..FIRST], &[between], &said[said.len() - LAST..]].concat()
}

/// What tests that failed say: Rust's and pytest's lines between the word `failures` and the closing line.
#[derive(Default)]
pub(crate) struct Failures {
    lines: Vec<String>,
    is_within: bool,
}

impl Failures {
    /// Looks at the next line.
    pub(crate) fn add_line(&mut self, line: &str) {
        let title = line.trim_matches(['=', ' ']);
        if ["failures:", "FAILURES", "ERRORS"].contains(&title) {
            self.is_within = true;
        } else if line.starts_with("test result: ") {
            self.is_within = false;
        } else if self.is_within && !line.trim().is_empty() {
            self.lines.push(line.to_owned());
        }
    }

    /// All that was said.
    pub(crate) fn into_lines(self) -> Vec<String> {
        self.lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_failed_is_told_at_the_end() {
        let mut failures = Failures::default();
        let said = "test a ... ok\ntest b ... FAILED\n\nfailures:\n\n---- b stdout ----\nthread 'b' panicked\n\nfailures:\n    b\n\n\
                    test result: FAILED. 1 passed; 1 failed; 0 ignored\ntest c ... ok";
        said.lines().for_each(|line| failures.add_line(line));
        let lines = failures.into_lines();
        assert_eq!(lines, ["---- b stdout ----", "thread 'b' panicked", "    b"]);
        let mut tally = Tally::default();
        tally.fail("tests", &lines);
        assert!(
            tally
                .to_text()
                .ends_with("failed: tests\n    ---- b stdout ----\n    thread 'b' panicked\n        b\n")
        );
        let many: Vec<String> = (0..150).map(|i| i.to_string()).collect();
        let few = abridged(&many);
        assert_eq!(
            [&few[0], &few[59], &few[60], &few[61], &few[100]],
            ["0", "59", "... 50 more lines ...", "110", "149"]
        );
    }

    #[test]
    fn closing_lines_are_added_up() {
        let mut tally = Tally::default();
        tally.add_line(
            "test result: ok. 3 passed; 0 failed; 1 ignored; 0 measured; 5 filtered out; finished in 0.01s",
        );
        tally.add_line("test algebra::tests::x ... ok");
        tally.add_line(
            "test result: FAILED. 4 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 1s",
        );
        tally.count(true);
        assert_eq!([tally.passed, tally.failed, tally.skipped], [8, 2, 1]);
        assert_eq!(tally.to_line(), "8 passed, 2 failed, 1 skipped");
        tally.add_line("1 failed, 3 passed, 2 skipped, 1 warning, 1 error in 0.12s (0:00:00)");
        tally.add_line("= 2 passed in 0.1s =");
        tally.add_line("SKIPPED [1] tests/test_doors.py:3: 1 skipped in all");
        assert_eq!([tally.passed, tally.failed, tally.skipped], [13, 4, 3]);
    }

    #[test]
    fn the_slowest_come_first() {
        let mut tally = Tally::default();
        for i in 0..12 {
            tally.time(&format!("stage {i}"), f64::from(i));
        }
        let mut other = Tally::default();
        other.time("lints", 100.0);
        other.fail("lints", &[]);
        tally.add(other);
        let text = tally.to_text();
        let lines: Vec<&str> = text.lines().map(str::trim).collect();
        assert_eq!(lines.len(), 12);
        assert_eq!(lines[..3], ["slowest:", "100.0 s  lints", "11.0 s  stage 11"]);
        assert_eq!(lines[11], "failed: lints");
    }
}
