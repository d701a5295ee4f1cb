//! A sign of life on standard error for work longer than a second.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// How long work may take unseen.
const PATIENCE: Duration = Duration::from_secs(1);
const TICK: Duration = Duration::from_millis(100);

/// Shows the stage of the work and the time it has taken, from one second on and only on a terminal; dropping it
/// clears the line.
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
            loop {
                match received.recv_timeout(TICK) {
                    Ok(next) => stage = next,
                    Err(RecvTimeoutError::Timeout) => {}
                    Err(RecvTimeoutError::Disconnected) => break,
                }
                if begin.elapsed() < PATIENCE {
                    continue;
                }
                let bar = bar.get_or_insert_with(|| new_bar(begin));
                bar.set_message(stage.clone());
                bar.tick();
            }
            if let Some(bar) = bar {
                bar.finish_and_clear();
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

fn new_bar(begin: Instant) -> ProgressBar {
    let style = ProgressStyle::with_template("{spinner} {msg} {elapsed}")
        .unwrap_or_else(|_| ProgressStyle::default_spinner());
    ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr())
        .with_style(style)
        .with_elapsed(begin.elapsed())
}
