//! Rows as a text table and as JSON lines.

use crate::measure::{Measurement, median};
use coface::Error;
use serde_json::json;
use std::io::Write;
use std::path::Path;

/// All runs of one program on one input.
pub(crate) struct Row {
    pub(crate) task: String,
    pub(crate) input: String,
    pub(crate) program: String,
    pub(crate) runs: Vec<Measurement>,
}

impl Row {
    /// The median of the seconds.
    pub(crate) fn seconds(&self) -> f64 {
        median(self.runs.iter().map(|run| run.seconds))
    }

    /// The median of the seconds of processor time, where known.
    pub(crate) fn cpu_seconds(&self) -> f64 {
        median(self.runs.iter().filter_map(|run| run.cpu_seconds))
    }

    /// The highest peak of memory.
    pub(crate) fn peak(&self) -> f64 {
        self.runs.iter().map(|run| run.peak_megabytes).fold(0.0, f64::max)
    }

    /// The size of the input, as the task counts it.
    pub(crate) fn size(&self) -> f64 {
        self.runs.first().map_or(0.0, |run| run.size)
    }

    fn result(&self) -> &str {
        self.runs.first().map_or("", |run| &run.result)
    }

    fn extreme(&self, choose: fn(f64, f64) -> f64) -> f64 {
        self.runs.iter().map(|run| run.seconds).reduce(choose).unwrap_or(f64::NAN)
    }

    /// Appends the row to a file of JSON lines.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub(crate) fn append_to(&self, path: &Path) -> Result<(), Error> {
        let line = json!({
            "task": self.task,
            "input": self.input,
            "program": self.program,
            "median_seconds": self.seconds(),
            "seconds": self.runs.iter().map(|run| run.seconds).collect::<Vec<_>>(),
            "median_cpu_seconds": self.cpu_seconds(),
            "peak_mb": self.peak(),
            "before_mb": self.runs.first().and_then(|run| run.before_megabytes),
            "size": self.size(),
            "result": self.result(),
        });
        let mut file = std::fs::OpenOptions::new().create(true).append(true).open(path)?;
        writeln!(file, "{line}")?;
        Ok(())
    }

    /// The heading over [`Self::to_text`].
    pub(crate) fn heading() -> String {
        format!(
            "{:<20} {:<14} {:<26} {:>9} {:>9} {:>19} {:>8} {:>8}  {}",
            "task", "input", "program", "median s", "cpu s", "least - most", "peak MB", "before", "result"
        )
    }

    /// The row as one aligned line.
    pub(crate) fn to_text(&self) -> String {
        let before = self.runs.first().and_then(|run| run.before_megabytes);
        format!(
            "{:<20} {:<14} {:<26} {:>9.4} {:>9.4} {:>19} {:>8.0} {:>8}  {}",
            self.task,
            self.input,
            self.program,
            self.seconds(),
            self.cpu_seconds(),
            format!("{:.4} - {:.4}", self.extreme(f64::min), self.extreme(f64::max)),
            self.peak(),
            before.map_or_else(|| "-".to_owned(), |mb| format!("{mb:.0}")),
            self.result()
        )
    }
}
