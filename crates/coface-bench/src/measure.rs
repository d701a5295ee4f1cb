//! One measurement is one process: its time, its memory, and its answer.

use coface::{Error, ErrorKind};
use serde_json::{Value, json};
use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// What one run took and found.
#[derive(Clone, Debug)]
pub(crate) struct Measurement {
    /// Seconds of the work alone, without start-up and preparation, if the program says so; else of the whole process.
    pub(crate) seconds: f64,
    /// Seconds of processor time of all threads in the same span, if known: steadier on a machine shared with others.
    pub(crate) cpu_seconds: Option<f64>,
    /// The most memory the process held, preparation included, in MB of 2^20 bytes.
    pub(crate) peak_megabytes: f64,
    /// The same when timing began, if the program says so.
    pub(crate) before_megabytes: Option<f64>,
    /// How large the input is, in the unit of its task; 0 if the program does not say.
    pub(crate) size: f64,
    /// What came out, for comparing with others.
    pub(crate) result: String,
}

impl Measurement {
    /// The line that a measuring process prints for the one that started it.
    pub(crate) fn to_line(&self) -> String {
        json!({
            "seconds": self.seconds,
            "cpu_seconds": self.cpu_seconds,
            "peak_mb": self.peak_megabytes,
            "before_mb": self.before_megabytes,
            "size": self.size,
            "result": self.result,
        })
        .to_string()
    }

    /// The measurement in the last line of a program's output that is a JSON object with `seconds`.
    fn from_output(output: &str) -> Option<Self> {
        let line = output.lines().rev().filter_map(|line| serde_json::from_str::<Value>(line).ok());
        line.into_iter().find_map(|value| {
            Some(Self {
                seconds: value.get("seconds")?.as_f64()?,
                cpu_seconds: value.get("cpu_seconds").and_then(Value::as_f64),
                peak_megabytes: value.get("peak_mb").and_then(Value::as_f64).unwrap_or(f64::NAN),
                before_megabytes: value.get("before_mb").and_then(Value::as_f64),
                size: value.get("size").and_then(Value::as_f64).unwrap_or(0.0),
                result: value.get("result").and_then(Value::as_str).unwrap_or("").to_owned(),
            })
        })
    }
}

/// Runs a command to its end and measures it. Its own word on seconds and memory is taken if it prints a JSON line with
/// them; otherwise the whole process is timed from outside.
///
/// # Errors
/// If the command cannot be started or fails.
pub(crate) fn measure(command: &mut Command) -> Result<Measurement, Error> {
    let label = command.get_program().to_string_lossy().into_owned();
    let begin = Instant::now();
    let mut child = command
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::inherit())
        .spawn()
        .map_err(|error| Error::new(ErrorKind::Io, format!("{label}: {error}")))?;
    let mut pipe = child.stdout.take().expect("the output is piped");
    let reader = std::thread::spawn(move || {
        let mut output = Vec::new();
        pipe.read_to_end(&mut output).map(|_| output)
    });
    let (succeeded, peak, cpu_seconds) = watch(&mut child)?;
    let seconds = begin.elapsed().as_secs_f64();
    let output = reader.join().map_err(|_| Error::invalid(format!("{label}: its output was lost")))??;
    if !succeeded {
        return Err(Error::invalid(format!("{label} failed")));
    }
    let output = String::from_utf8_lossy(&output);
    Ok(Measurement::from_output(&output).unwrap_or_else(|| Measurement {
        seconds,
        cpu_seconds,
        peak_megabytes: peak,
        before_megabytes: None,
        size: 0.0,
        result: String::new(),
    }))
}

/// Waits for a process, looking at its high-water mark of memory and its processor time every millisecond; both only
/// rise, so at most the growth of the last millisecond is missed.
fn watch(child: &mut Child) -> Result<(bool, f64, Option<f64>), Error> {
    let folder = format!("/proc/{}", child.id());
    let (mut peak, mut cpu_seconds) = (0.0, None);
    loop {
        peak = high_water_mark(&format!("{folder}/status")).unwrap_or(0.0).max(peak);
        cpu_seconds = processor_ticks(&folder).map(|ticks| ticks as f64 / 100.0).or(cpu_seconds);
        if let Some(exit) = child.try_wait()? {
            return Ok((exit.success(), peak, cpu_seconds));
        }
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// The most memory that this process has held so far, in MB; not a number where the system does not tell.
pub(crate) fn own_high_water_mark() -> f64 {
    high_water_mark("/proc/self/status").unwrap_or(f64::NAN)
}

fn high_water_mark(status: &str) -> Option<f64> {
    let text = std::fs::read_to_string(status).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: f64 = line.split_whitespace().next()?.parse().ok()?;
    Some(kilobytes / 1024.0)
}

/// The processor time of a process, in user and system mode, in hundredths of a second.
fn processor_ticks(folder: &str) -> Option<u64> {
    let text = std::fs::read_to_string(format!("{folder}/stat")).ok()?;
    // The second field, the name in parentheses, may itself hold blanks.
    let fields: Vec<&str> = text.rsplit_once(')')?.1.split_whitespace().collect();
    Some(fields.get(11)?.parse::<u64>().ok()? + fields.get(12)?.parse::<u64>().ok()?)
}

/// The processor time of the threads of this process that still run, in seconds; `None` where the system does not tell.
pub(crate) fn own_processor_seconds() -> Option<f64> {
    let mut nanoseconds = 0;
    for thread in std::fs::read_dir("/proc/self/task").ok()? {
        let text = std::fs::read_to_string(thread.ok()?.path().join("schedstat")).ok()?;
        nanoseconds += text.split_whitespace().next()?.parse::<u64>().ok()?;
    }
    Some(nanoseconds as f64 * 1e-9)
}

/// The middle of the values; of two middle ones the mean. Not a number for an empty list.
pub(crate) fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = values.into_iter().collect();
    sorted.sort_by(f64::total_cmp);
    let middle = sorted.len() / 2;
    match sorted.len() {
        0 => f64::NAN,
        n if n % 2 == 1 => sorted[middle],
        _ => f64::midpoint(sorted[middle - 1], sorted[middle]),
    }
}

/// The exponent e of the power law seconds = c size^e that fits best (least squares of the logarithms); `None` for fewer
/// than two sizes.
pub(crate) fn growth_exponent(points: &[(f64, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> =
        points.iter().filter(|(n, s)| *n > 0.0 && *s > 0.0).map(|(n, s)| (n.ln(), s.ln())).collect();
    let count = logs.len() as f64;
    let (mean_x, mean_y) =
        (logs.iter().map(|p| p.0).sum::<f64>() / count, logs.iter().map(|p| p.1).sum::<f64>() / count);
    let spread: f64 = logs.iter().map(|p| (p.0 - mean_x).powi(2)).sum();
    let slope: f64 = logs.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y)).sum();
    (logs.len() >= 2 && spread > 0.0).then(|| slope / spread)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_in_the_middle() {
        assert_eq!(median([3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median([4.0, 1.0, 2.0, 3.0]), 2.5);
        assert!(median([]).is_nan());
    }

    #[test]
    fn a_power_law_gives_its_exponent() {
        let points: Vec<(f64, f64)> = [10.0, 20.0, 40.0].map(|n: f64| (n, 0.5 * n.powf(1.5))).to_vec();
        assert!((growth_exponent(&points).unwrap() - 1.5).abs() < 1e-12);
        assert_eq!(growth_exponent(&points[..1]), None);
    }

    #[test]
    fn the_last_line_with_seconds_counts() {
        let output =
            "hello\n{\"seconds\": 1.0}\n{\"seconds\": 2.5, \"peak_mb\": 7, \"result\": \"V 3\"}\n[]\n";
        let found = Measurement::from_output(output).unwrap();
        assert_eq!((found.seconds, found.peak_megabytes, found.result.as_str()), (2.5, 7.0, "V 3"));
        assert!(Measurement::from_output("V 3\n").is_none());
    }
}
