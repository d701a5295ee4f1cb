//! A sign of life on standard error for work longer than a second.

use coface::algebra::escaped;
use coface::algebra::progress::{Stage, Unit, Watch};
use indicatif::{HumanBytes, ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, LazyLock};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// How long work may take unseen.
const PATIENCE: Duration = Duration::from_secs(1);
const TICK: Duration = Duration::from_millis(100);

/// Looks on all that the library does.
static WATCH: LazyLock<Arc<Watch>> = LazyLock::new(|| Arc::new(Watch::new()));

/// Whether a line is shown on standard error now.
static IS_SHOWN: AtomicBool = AtomicBool::new(false);

/// Does the work of the program, whose stages are shown by [`Progress`].
pub(crate) fn watched<T>(work: impl FnOnce() -> T) -> T {
    WATCH.run(work).expect("nobody stops this watch: an interrupt ends the program")
}

/// Shows the stage of the work and the time it has taken; of a stage that the library counts, how much of it is done, how fast and how much
/// longer it takes. From one second on and only on a terminal; dropping it clears the line.
pub(crate) struct Progress {
    shown: Option<(Sender<String>, JoinHandle<()>)>,
}

impl Progress {
    /// Starts the clock. Nothing is ever shown when `quiet` or when standard error is no terminal.
    pub(crate) fn start(quiet: bool) -> Self {
        if quiet || !std::io::stderr().is_terminal() {
            return Self { shown: None };
        }
        let (stages, received) = channel::<String>();
        let thread = std::thread::spawn(move || {
            let begin = Instant::now();
            let mut line = Line::new(begin);
            let mut coarse = String::new();
            loop {
                match received.recv_timeout(TICK) {
                    Ok(next) => {
                        coarse = next;
                        continue;
                    }
                    Err(RecvTimeoutError::Timeout) => {}
                    Err(RecvTimeoutError::Disconnected) => break,
                }
                line.see(WATCH.stage());
                if begin.elapsed() >= PATIENCE {
                    line.show(&coarse);
                }
            }
            line.clear();
        });
        Self { shown: Some((stages, thread)) }
    }

    /// Says what is being done now, where the library does not.
    pub(crate) fn stage(&self, name: impl Into<String>) {
        if let Some((stages, _)) = &self.shown {
            // The thread ends only after this sender is gone.
            let _ = stages.send(name.into());
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((stages, thread)) = self.shown.take() {
            drop(stages);
            // A fault of the display is no fault of the work.
            let _ = thread.join();
        }
    }
}

/// The line on standard error.
struct Line {
    begin: Instant,
    bar: Option<ProgressBar>,
    template: &'static str,
    counted: Option<Stage>,
    /// When the stage that is counted was first seen.
    since: Instant,
}

impl Line {
    fn new(begin: Instant) -> Self {
        Self { begin, bar: None, template: UNCOUNTED, counted: None, since: begin }
    }

    /// The stage that the library has come to.
    fn see(&mut self, stage: Option<Stage>) {
        let is_same = match (&self.counted, &stage) {
            (Some(a), Some(b)) => (a.name(), a.total()) == (b.name(), b.total()) && a.done() <= b.done(),
            _ => false,
        };
        if !is_same {
            self.since = Instant::now();
        }
        self.counted = stage;
    }

    /// Shows that stage, or the coarse one when there is none.
    fn show(&mut self, coarse: &str) {
        let bar = self.bar.get_or_insert_with(|| new_bar(self.begin));
        IS_SHOWN.store(true, Ordering::Relaxed);
        let template = match self.counted.as_ref().map(|stage| (stage.total(), stage.unit())) {
            Some((None, _)) | None => UNCOUNTED,
            Some((Some(_), Unit::Bytes)) => OF_BYTES,
            Some(_) => OF_ITEMS,
        };
        if template != self.template {
            bar.set_style(style(template));
            self.template = template;
        }
        match &self.counted {
            Some(stage) => {
                let rate = stage.done() as f64 / self.since.elapsed().as_secs_f64().max(TICK.as_secs_f64());
                let per_second = match stage.unit() {
                    Unit::Bytes => format!("{}/s", HumanBytes(rate as u64)),
                    _ => format!("{}/s", with_prefix(rate)),
                };
                let name = escaped(stage.name()).into_owned();
                match stage.total() {
                    None if stage.done() == 0 => bar.set_message(name),
                    None => bar.set_message(format!("{name} {per_second}")),
                    Some(total) => {
                        bar.set_message(name);
                        bar.set_length(total);
                        bar.set_position(stage.done().min(total));
                        let left = total.saturating_sub(stage.done()) as f64 / rate;
                        let left = if rate > 0.0 { format!(", {left:.0} s left") } else { String::new() };
                        bar.set_prefix(per_second + &left);
                    }
                }
            }
            None => bar.set_message(escaped(coarse).into_owned()),
        }
        bar.tick();
    }

    fn clear(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
            IS_SHOWN.store(false, Ordering::Relaxed);
        }
    }
}

/// A number in three or four digits: 950, 12.3 k, 4.56 M.
fn with_prefix(number: f64) -> String {
    let (scaled, prefix) = match number {
        x if x >= 1e9 => (x / 1e9, " G"),
        x if x >= 1e6 => (x / 1e6, " M"),
        x if x >= 1e3 => (x / 1e3, " k"),
        x => return format!("{x:.0}"),
    };
    match scaled {
        x if x < 10.0 => format!("{x:.2}{prefix}"),
        x if x < 100.0 => format!("{x:.1}{prefix}"),
        x => format!("{x:.0}{prefix}"),
    }
}

const UNCOUNTED: &str = "{spinner} {msg} {elapsed}";
const OF_BYTES: &str = "{spinner} {msg} {bar:20} {bytes} of {total_bytes}, {prefix}";
const OF_ITEMS: &str = "{spinner} {msg} {bar:20} {human_pos} of {human_len}, {prefix}";

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_spinner())
}

fn new_bar(begin: Instant) -> ProgressBar {
    ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr())
        .with_style(style(UNCOUNTED))
        .with_elapsed(begin.elapsed())
}

/// Ends the program when the user interrupts it or the system asks it to end: no temporary file stays, and no half a line. To be called before
/// there are other threads.
#[cfg(unix)]
pub(crate) fn end_on_signals() {
    use nix::sys::signal::{SigSet, Signal};
    let mut signals: SigSet = [Signal::SIGINT, Signal::SIGTERM].into_iter().collect();
    // A terminal that is closed ends what runs in it, unless that was started by nohup.
    if !ignores_hangup() {
        signals.add(Signal::SIGHUP);
    }
    // Without somebody who waits for them the system ends the program, as it does others.
    if signals.thread_block().is_err() {
        return;
    }
    std::thread::spawn(move || {
        let status = match signals.wait() {
            Ok(Signal::SIGTERM) => TERMINATED,
            Ok(Signal::SIGHUP) => HUNG_UP,
            _ => INTERRUPTED,
        };
        end(status)
    });
}

/// Whether the program was started to outlive its terminal; where the system does not tell, it counts as such.
#[cfg(unix)]
fn ignores_hangup() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    // The bit of signal 1.
    mask.is_none_or(|mask| mask & 1 != 0)
}

/// Ends the program when the user interrupts it: no temporary file stays, and no half a line.
#[cfg(windows)]
pub(crate) fn end_on_signals() {
    // Without a handler the system ends the program, as it does others.
    let _ = ctrlc::set_handler(|| end(INTERRUPTED));
}

/// There are no signals: a page that runs the program ends it together with its files.
#[cfg(not(any(unix, windows)))]
pub(crate) fn end_on_signals() {}

/// Ends the program before its work is done: no temporary file stays, and no half a line.
pub(crate) fn end(status: i32) -> ! {
    coface::io::abandon_files();
    clear_line();
    let mut out = std::io::stderr();
    if out.is_terminal() {
        let _ = match status {
            INTERRUPTED => out.write_all(b"interrupted\n"),
            TERMINATED => out.write_all(b"terminated\n"),
            _ => Ok(()),
        };
    }
    std::process::exit(status)
}

/// Back to the start of the line of progress, and away with it.
pub(crate) fn clear_line() {
    if IS_SHOWN.swap(false, Ordering::Relaxed) {
        let _ = std::io::stderr().write_all(b"\r\x1b[2K");
    }
}

/// The exit status of what ended on an interrupt, as shells have it.
const INTERRUPTED: i32 = 130;
/// The exit status of what the system asked to end.
const TERMINATED: i32 = 143;
/// The exit status of what ended with its terminal.
#[cfg(unix)]
const HUNG_UP: i32 = 129;

#[cfg(test)]
mod tests {
    use super::with_prefix;

    #[test]
    fn rates_are_short() {
        let shown = [0.4, 950.0, 1234.0, 56_789.0, 1.5e8, 2e9].map(with_prefix);
        assert_eq!(shown, ["0", "950", "1.23 k", "56.8 k", "150 M", "2.00 G"]);
    }
}
