//! What libFuzzer prints about a run.

/// What a run of a target has found.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Findings {
    pub(crate) executions: u64,
    pub(crate) per_second: u64,
    /// Edges of the program that some input has taken.
    pub(crate) edges: u64,
    /// Edges by how often they were taken, and comparisons by how near they came.
    pub(crate) features: u64,
    /// Inputs that are kept.
    pub(crate) inputs: u64,
    pub(crate) peak_memory: u64,
    /// What broke a promise, and the path of the input.
    pub(crate) fault: Option<String>,
}

impl Findings {
    pub(crate) const HEADER: &str =
        "target                executions  a second    edges  features  inputs    MiB  faults";

    pub(crate) fn of_fault(fault: String) -> Self {
        Self { fault: Some(fault), ..Self::default() }
    }

    /// A row of the table.
    pub(crate) fn to_line(&self, name: &str) -> String {
        format!(
            "{name:<20} {:>11} {:>9} {:>8} {:>9} {:>7} {:>6} {:>7}",
            self.executions,
            self.per_second,
            self.edges,
            self.features,
            self.inputs,
            self.peak_memory,
            usize::from(self.fault.is_some())
        )
    }
}

/// Reads what a target has printed, and whether it ended well.
///
/// Lines of progress look like `#8192 pulse  cov: 512 ft: 1234 corp: 100/12Kb lim: 4096 exec/s: 4096 rss: 40Mb`; the counts come at the end,
/// each in a line like `stat::number_of_executed_units: 8192`; a fault names its file in `Test unit written to PATH`.
pub(crate) fn read_log(text: &str, has_passed: bool) -> Findings {
    let mut findings = Findings::default();
    let mut message: Vec<&str> = Vec::new();
    let mut path = None;
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if let Some((name, value)) = line.strip_prefix("stat::").and_then(|rest| rest.split_once(':')) {
            let value = value.trim().parse().unwrap_or(0);
            match name {
                "number_of_executed_units" => findings.executions = value,
                "average_exec_per_sec" => findings.per_second = value,
                "peak_rss_mb" => findings.peak_memory = value,
                _ => {}
            }
        } else if line.starts_with('#') {
            let words: Vec<&str> = line.split_whitespace().collect();
            for pair in words.windows(2) {
                let number = pair[1].split('/').next().and_then(|number| number.parse().ok());
                match (pair[0], number) {
                    ("cov:", Some(number)) => findings.edges = number,
                    ("ft:", Some(number)) => findings.features = number,
                    ("corp:", Some(number)) => findings.inputs = number,
                    _ => {}
                }
            }
            // A run that ends with a fault prints no counts when it is killed.
            let executed = words[0].trim_start_matches('#').parse().unwrap_or(0);
            findings.executions = findings.executions.max(executed);
        } else if line.starts_with("thread ") && line.contains(" panicked at ") {
            // The message stands below.
            message = vec![line];
            message.extend(lines.next());
        } else if line.contains("ERROR: libFuzzer: ") || line.starts_with("memory allocation of ") {
            let (_, fault) = line.split_once("ERROR: ").unwrap_or(("", line));
            if message.is_empty() || !fault.contains("deadly signal") {
                message.push(fault);
            }
        } else if let Some((_, written)) = line.split_once("Test unit written to ") {
            // Slow inputs are kept, and are no faults.
            path = Some(written.trim()).filter(|written| !written.contains("slow-unit-")).or(path);
        }
    }
    if !has_passed {
        let message = if message.is_empty() {
            text.lines().last().unwrap_or("no output")
        } else {
            &message.join("\n  ")
        };
        let path = path.map_or_else(String::new, |path| format!("\n  {path}"));
        findings.fault = Some(format!("{message}{path}"));
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_read_from_the_last_lines() {
        let text = "INFO: Running with entropic power schedule (0xFF, 100).\n\
            #8192\tpulse  cov: 500 ft: 1200 corp: 90/11Kb lim: 4096 exec/s: 4096 rss: 40Mb\n\
            #9000\tDONE   cov: 512 ft: 1234 corp: 100/12Kb lim: 4096 exec/s: 4500 rss: 41Mb\n\
            Done 9000 runs in 2 second(s)\n\
            stat::number_of_executed_units: 9000\nstat::average_exec_per_sec:     4500\nstat::new_units_added:          100\n\
            stat::slowest_unit_time_sec:    0\nstat::peak_rss_mb:              41\n";
        let expected = Findings {
            executions: 9000,
            per_second: 4500,
            edges: 512,
            features: 1234,
            inputs: 100,
            peak_memory: 41,
            fault: None,
        };
        assert_eq!(read_log(text, true), expected);
        assert_eq!(
            expected.to_line("read_off"),
            "read_off                    9000      4500      512      1234     100     41       0"
        );
        assert_eq!(Findings::HEADER.len(), expected.to_line("read_off").len());
    }

    #[test]
    fn a_fault_is_told_with_its_place_and_its_input() {
        let text = "#5\tINITED cov: 12 ft: 13 corp: 1/1b exec/s: 0 rss: 30Mb\n\
            \nthread '<unnamed>' (12) panicked at src/off/read.rs:7:5:\nindex out of bounds: the len is 3\nnote: run with `RUST_BACKTRACE=1`\n\
            ==7== ERROR: libFuzzer: deadly signal\n    #0 0x5566\n\
            artifact_prefix='faults/'; Test unit written to faults/crash-0a1b\nBase64: AA==\n";
        let findings = read_log(text, false);
        assert_eq!((findings.executions, findings.edges), (5, 12));
        assert_eq!(
            findings.fault.as_deref(),
            Some(
                "thread '<unnamed>' (12) panicked at src/off/read.rs:7:5:\n  index out of bounds: the len is 3\n  faults/crash-0a1b"
            )
        );
        let text = "ALARM: working on the last Unit for 6 seconds\n==7== ERROR: libFuzzer: timeout after 6 seconds\n\
            artifact_prefix='faults/'; Test unit written to faults/slow-unit-77\n\
            artifact_prefix='faults/'; Test unit written to faults/timeout-88\n";
        let fault = read_log(text, false).fault.unwrap();
        assert_eq!(fault, "libFuzzer: timeout after 6 seconds\n  faults/timeout-88");
        assert_eq!(read_log("", false).fault.as_deref(), Some("no output"));
    }
}
