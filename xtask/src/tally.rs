//! Counts what passed, failed and was skipped.

/// What a run of checks came to.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Tally {
    pub(crate) passed: usize,
    pub(crate) failed: usize,
    pub(crate) skipped: usize,
}

impl Tally {
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

#[cfg(test)]
mod tests {
    use super::*;

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
        assert_eq!(tally, Tally { passed: 8, failed: 2, skipped: 1 });
        assert_eq!(tally.to_line(), "8 passed, 2 failed, 1 skipped");
        tally.add_line("1 failed, 3 passed, 2 skipped, 1 warning, 1 error in 0.12s (0:00:00)");
        tally.add_line("= 2 passed in 0.1s =");
        tally.add_line("SKIPPED [1] tests/test_doors.py:3: 1 skipped in all");
        assert_eq!(tally, Tally { passed: 13, failed: 4, skipped: 3 });
    }
}
