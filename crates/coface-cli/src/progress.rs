//! A sign of life on standard error for work longer than a second.

use coface::io::ReadProgress;
use indicatif::{HumanBytes, ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// How long work may take unseen.
const PATIENCE: Duration = Duration::from_secs(1);
/// What stages of reading begin with.
pub(crate) const READS: &str = "reading ";
const TICK: Duration = Duration::from_millis(100);

/// How far reading has come, over all threads.
pub(crate) static READING: ReadProgress = ReadProgress::new();

/// Whether a line is shown on standard error now.
static IS_SHOWN: AtomicBool = AtomicBool::new(false);

/// Shows the stage of the work and the time it has taken, while a file is read how much of it, how fast and how much longer, from one second on
/// and only on a terminal; dropping it clears the line.
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
            let mut stage = String::new();
            let mut bar: Option<ProgressBar> = None;
            let mut was_reading = false;
            let mut since = begin;
            loop {
                match received.recv_timeout(TICK) {
                    Ok(next) => {
                        stage = next;
                        since = Instant::now();
                    }
                    Err(RecvTimeoutError::Timeout) => {}
                    Err(RecvTimeoutError::Disconnected) => break,
                }
                if begin.elapsed() < PATIENCE {
                    continue;
                }
                let bar = bar.get_or_insert_with(|| new_bar(begin));
                IS_SHOWN.store(true, Ordering::Relaxed);
                let (done, total) = (READING.done(), READING.total());
                let is_reading = stage.starts_with(READS) && done < total;
                if is_reading != was_reading {
                    bar.set_style(style(if is_reading { WITH_BYTES } else { WITHOUT_BYTES }));
                    was_reading = is_reading;
                }
                if is_reading {
                    bar.set_length(total);
                    bar.set_position(done);
                    // Over all that was read: what went by before the line was shown counts too.
                    let rate = done as f64 / since.elapsed().as_secs_f64().max(1e-3);
                    let left = (total - done) as f64 / rate.max(1.0);
                    bar.set_prefix(format!("{}/s, {left:.0} s left", HumanBytes(rate as u64)));
                }
                bar.set_message(stage.clone());
                bar.tick();
            }
            if let Some(bar) = bar {
                bar.finish_and_clear();
                IS_SHOWN.store(false, Ordering::Relaxed);
            }
        });
        Self { shown: Some((stages, thread)) }
    }

    /// Says what is being done now.
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

const WITHOUT_BYTES: &str = "{spinner} {msg} {elapsed}";
const WITH_BYTES: &str = "{spinner} {msg} {bar:20} {bytes} of {total_bytes}, {prefix}";

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_spinner())
}

fn new_bar(begin: Instant) -> ProgressBar {
    ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr())
        .with_style(style(WITHOUT_BYTES))
        .with_elapsed(begin.elapsed())
}

/// Ends the program with status 130 when the user interrupts it: no temporary file stays, and no half a line.
pub(crate) fn end_on_interrupt() {
    // Without a handler the system ends the program, as it does others.
    let _ = ctrlc::set_handler(|| {
        coface::io::abandon_files();
        let mut out = std::io::stderr();
        if IS_SHOWN.load(Ordering::Relaxed) {
            // Back to the start of the line of progress, and away with it.
            let _ = out.write_all(b"\r\x1b[2K");
        }
        if out.is_terminal() {
            let _ = out.write_all(b"interrupted\n");
        }
        std::process::exit(INTERRUPTED);
    });
}

/// The exit status of what ended on an interrupt, as shells have it.
const INTERRUPTED: i32 = 130;
