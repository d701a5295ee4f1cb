//! The pool: requests to worker processes, answers from them.

use super::{Limits, Loss};
use crate::workers::process::{ATTEMPTS, Answer, Reply, WorkerCommand, WorkerProcess};
use coface_algebra::progress;
use coface_algebra::{Error, ErrorKind};
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Duration;

/// What became of a request.
pub type Outcome = Result<Answer, Loss>;

/// Worker processes of one program that are handed requests.
///
/// A worker that ends takes one request with it, and another is started in its place. A request is lost only when a worker that had done
/// nothing else was lost to it, so what became of it does not depend on what was asked before. Workers that were ended from outside (by a
/// signal that no fault of theirs raises) are replaced and asked again, three times in all.
///
/// # Examples
/// ```no_run
/// use coface_scale::workers::{Limits, WorkerCommand, WorkerPool, parse_duration};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let limits = Limits { time: Some(parse_duration("60s")?), memory: Some(2 << 30) };
/// let pool = WorkerPool::new(WorkerCommand::new("coface", ["worker", "info"]), 2, limits);
/// let requests = ["{\"path\":\"a.off\"}", "{\"path\":\"b.off\"}"];
/// pool.run("examining files", requests.len(), |i| requests[i].to_owned(), |i, outcome| {
///     match outcome {
///         Ok(answer) => println!("{}: {}", requests[i], answer.line),
///         Err(loss) => println!("{}: {loss}", requests[i]),
///     }
///     Ok(())
/// })
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct WorkerPool {
    command: WorkerCommand,
    count: usize,
    limits: Limits,
}

/// How often it is looked whether the work was asked to stop.
const TICK: Duration = Duration::from_millis(50);

impl WorkerPool {
    /// A pool of at most `count` workers at once, at least one. None is started yet.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::workers::{Limits, WorkerCommand, WorkerPool};
    /// let pool = WorkerPool::new(WorkerCommand::new("cat", [""; 0]), 2, Limits::default());
    /// assert_eq!(pool.limits(), Limits::default());
    /// ```
    pub fn new(command: WorkerCommand, count: usize, limits: Limits) -> Self {
        Self { command, count: count.max(1), limits }
    }

    /// What a request may take.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::workers::{Limits, WorkerCommand, WorkerPool};
    /// let pool = WorkerPool::new(WorkerCommand::new("cat", [""; 0]), 2, Limits::default());
    /// assert_eq!(pool.limits().time, None);
    /// ```
    pub fn limits(&self) -> Limits {
        self.limits
    }

    /// Has requests `0..count` done, and gives what became of each to `take` as it comes, in this thread. `request` gives a request by its
    /// number, one line.
    ///
    /// It is a stage of this name for whoever [watches](progress::Watch), a step a request. All workers have ended when it returns,
    /// also when it is stopped or `take` fails.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] when workers cannot be started; the first error of `take`, after which no further request is handed out.
    pub fn run(
        &self,
        stage: &str,
        count: usize,
        request: impl Fn(usize) -> String + Sync,
        mut take: impl FnMut(usize, Outcome) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let (next, ended) = (AtomicUsize::new(0), AtomicBool::new(false));
        let steps = progress::stage(stage, count);
        thread::scope(|scope| {
            // Also when `take` fails or the work is stopped: the threads below are waited for.
            let _end = EndAtDrop(&ended);
            let (send, outcomes) = channel();
            for _ in 0..self.count.min(count) {
                let send = send.clone();
                let (next, ended, request) = (&next, &ended, &request);
                let hand_out = move || self.hand_out(next, ended, count, request, &send);
                thread::Builder::new().name("coface-pool".to_owned()).spawn_scoped(scope, hand_out).map_err(
                    |error| Error::new(ErrorKind::Io, format!("no thread can be started: {error}")),
                )?;
            }
            drop(send);
            let mut taken = 0;
            while taken < count {
                match outcomes.recv_timeout(TICK) {
                    Ok(Ok((place, outcome))) => {
                        take(place, outcome)?;
                        taken += 1;
                        steps.advance(1);
                    }
                    Ok(Err(error)) => return Err(error),
                    Err(RecvTimeoutError::Timeout) => steps.advance(0),
                    Err(RecvTimeoutError::Disconnected) => {
                        return Err(Error::new(
                            ErrorKind::Io,
                            "the threads that wait for workers have ended",
                        ));
                    }
                }
            }
            Ok(())
        })
    }

    /// As [`run`](Self::run), with outcomes in the order of the requests. Those that come before their turn are kept until then.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_in_order(
        &self,
        stage: &str,
        count: usize,
        request: impl Fn(usize) -> String + Sync,
        mut take: impl FnMut(usize, Outcome) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let (mut early, mut turn) = (BTreeMap::new(), 0);
        self.run(stage, count, request, |place, outcome| {
            early.insert(place, outcome);
            while let Some(outcome) = early.remove(&turn) {
                take(turn, outcome)?;
                turn += 1;
            }
            Ok(())
        })
    }

    /// Hands requests to one worker at a time until there are none left.
    fn hand_out(
        &self,
        next: &AtomicUsize,
        ended: &AtomicBool,
        count: usize,
        request: &(impl Fn(usize) -> String + Sync),
        send: &Sender<Result<(usize, Outcome), Error>>,
    ) {
        let mut worker = None;
        while !ended.load(Ordering::Relaxed) {
            let place = next.fetch_add(1, Ordering::Relaxed);
            if place >= count {
                break;
            }
            let told = match self.ask(&mut worker, &request(place), ended) {
                Ok(Some(outcome)) => Ok((place, outcome)),
                Ok(None) => break,
                Err(error) => Err(error),
            };
            if send.send(told).is_err() {
                break;
            }
        }
    }

    /// What becomes of a request; `None` if the pool ended first.
    fn ask(
        &self,
        worker: &mut Option<WorkerProcess>,
        request: &str,
        ended: &AtomicBool,
    ) -> Result<Option<Outcome>, Error> {
        debug_assert!(!request.contains('\n'), "a request is one line");
        let mut killed = 0;
        loop {
            let mut process = match worker.take() {
                Some(process) => process,
                None => match WorkerProcess::start(&self.command, self.limits, ended)? {
                    Some(process) => process,
                    None => return Ok(None),
                },
            };
            let is_fresh = process.is_fresh();
            match process.ask(request, ended) {
                Reply::Answer(answer) => {
                    *worker = Some(process);
                    return Ok(Some(Ok(answer)));
                }
                Reply::Ended => return Ok(None),
                Reply::Lost(Loss::Killed { signal, .. }) => {
                    killed += 1;
                    if killed == ATTEMPTS {
                        return Ok(Some(Err(Loss::Killed { signal, attempts: killed })));
                    }
                }
                Reply::Lost(loss) if is_fresh || matches!(loss, Loss::Time { .. }) => {
                    return Ok(Some(Err(loss)));
                }
                // Perhaps the fault is what earlier requests left behind.
                Reply::Lost(_) => {}
            }
        }
    }
}

/// States that the pool has ended.
struct EndAtDrop<'a>(&'a AtomicBool);

impl Drop for EndAtDrop<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use coface_algebra::progress::Watch;
    use std::sync::Arc;

    /// A worker in the language of the shell, that doubles words and dies of some.
    const DOUBLING: &str = r#"
        read limits; echo ready
        while read word; do
            case $word in
                signal*) kill -${word#signal} $$;;
                exit*) exit ${word#exit};;
                memory) echo "memory allocation of 99 bytes failed" >&2; kill -ABRT $$;;
                stack) echo "fault: no stack: Cannot allocate memory (os error 12) at here.rs:1" >&2; exit 101;;
                fault) echo "fault: no bits left at here.rs:1" >&2; exit 101;;
                second) test "$before" && kill -SEGV $$; echo fine;;
                long*) i=0; while test $i -lt ${word#long}; do i=$((i + 1)); echo >&2 "line $i"; done; exit 3;;
                endless) while :; do :; done;;
                limits) echo $limits;;
                process) echo $$;;
                *) echo $word$word;;
            esac
            before=1
        done"#;

    fn pool(count: usize, limits: Limits) -> WorkerPool {
        WorkerPool::new(WorkerCommand::new("sh", ["-c", DOUBLING]), count, limits)
    }

    /// What becomes of words, as text.
    fn outcomes(pool: &WorkerPool, words: &[&str]) -> Vec<String> {
        let mut all = Vec::new();
        let take = |place, outcome: Outcome| {
            assert_eq!(place, all.len());
            all.push(match outcome {
                Ok(answer) => answer.line,
                Err(loss) => format!("{}: {loss}", loss.kind()),
            });
            Ok(())
        };
        pool.run_in_order("words", words.len(), |i| words[i].to_owned(), take).expect("workers start");
        all
    }

    #[test]
    fn answers_are_the_same_for_any_number_of_workers() {
        let words: Vec<String> =
            (0..200).map(|i| if i % 17 == 3 { "exit7".into() } else { i.to_string() }).collect();
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let alone = outcomes(&pool(1, Limits::default()), &words);
        assert_eq!((alone[2].as_str(), alone[3].as_str()), ("22", "crash: crashed: exit status: 7"));
        assert_eq!(outcomes(&pool(3, Limits::default()), &words), alone);
        assert!(outcomes(&pool(3, Limits::default()), &[]).is_empty());
    }

    #[test]
    fn a_loss_says_how_the_worker_ended() {
        let limits = Limits { memory: Some(1 << 30), time: None };
        let words = ["a", "signal11", "signal9", "memory", "stack", "fault", "exit0", "long9999", "b"];
        let expected = [
            "aa",
            "crash: crashed: SIGSEGV",
            "killed: was ended from outside by SIGKILL, 3 times",
            "memory: needed more than 1 GiB of memory",
            "memory: needed more than 1 GiB of memory",
            "crash: crashed: no bits left at here.rs:1",
            "crash: crashed: exit status: 0",
            "crash: crashed: exit status: 3",
            "bb",
        ];
        assert_eq!(outcomes(&pool(1, limits), &words), expected);
    }

    #[test]
    fn what_is_lost_does_not_depend_on_what_was_before() {
        assert_eq!(outcomes(&pool(1, Limits::default()), &["a", "second", "second"]), ["aa", "fine", "fine"]);
    }

    #[test]
    fn a_request_that_takes_too_long_is_ended() {
        let limits = Limits { time: Some(Duration::from_millis(300)), memory: None };
        assert_eq!(
            outcomes(&pool(1, limits), &["a", "endless", "b"]),
            ["aa", "time: took longer than 0.3 s", "bb"]
        );
    }

    #[test]
    fn limits_are_told_and_workers_are_kept() {
        let limits = Limits { time: None, memory: Some(77) };
        let told = outcomes(&pool(1, limits), &["limits", "process", "process"]);
        assert_eq!(told[0], "memory 77");
        assert_eq!(told[1], told[2]);
    }

    #[test]
    fn all_workers_have_ended_afterwards() {
        let mut processes = Vec::new();
        let result = pool(2, Limits::default()).run(
            "processes",
            100,
            |i| if i < 2 { "process".to_owned() } else { "endless".to_owned() },
            |_, outcome| {
                processes.push(outcome.unwrap().line);
                if processes.len() == 2 { Err(Error::invalid("enough")) } else { Ok(()) }
            },
        );
        assert_eq!(result.unwrap_err().message(), "enough");
        for id in processes {
            let id = nix::unistd::Pid::from_raw(id.parse().unwrap());
            assert_eq!(nix::sys::signal::kill(id, None), Err(nix::errno::Errno::ESRCH));
        }
    }

    #[test]
    fn work_that_is_stopped_ends() {
        let watch = Arc::new(Watch::new());
        let stopped = thread::scope(|scope| {
            scope.spawn(|| {
                while watch.stage().is_none_or(|stage| stage.done() < 3) {
                    thread::yield_now();
                }
                watch.stop();
            });
            let request = |i| if i < 3 { "a".to_owned() } else { "endless".to_owned() };
            watch.run(|| pool(2, Limits::default()).run("endless", 9, request, |_, _| Ok(())))
        });
        assert!(stopped.is_err());
    }

    #[test]
    fn workers_that_are_killed_while_they_start_are_started_again() {
        let folder = tempfile::tempdir().unwrap();
        let marks = folder.path().display();
        // So many starts are killed, and then there is a worker.
        let run = |kills: usize| {
            let mark =
                format!("n=$(ls {marks} | wc -l); test $n -lt {kills} && mkdir {marks}/$n && kill -KILL $$;");
            let command = WorkerCommand::new("sh", ["-c".to_owned(), format!("{mark}{DOUBLING}")]);
            let mut all = Vec::new();
            let done = WorkerPool::new(command, 1, Limits::default()).run(
                "words",
                1,
                |_| "ab".to_owned(),
                |_, outcome| {
                    all.extend(outcome.map(|answer| answer.line).ok());
                    Ok(())
                },
            );
            done.map(|()| all).map_err(|error| error.to_string())
        };
        assert_eq!(run(2), Ok(vec!["abab".to_owned()]));
        assert!(run(9).unwrap_err().contains("cannot be started: it was ended from outside by SIGKILL"));
    }

    #[test]
    fn programs_that_are_no_workers_are_refused() {
        let run = |program: &str, arguments: &[&str]| {
            let command = WorkerCommand::new(program, arguments.iter().copied());
            let error = WorkerPool::new(command, 2, Limits::default()).run(
                "none",
                3,
                |_| String::new(),
                |_, _| Ok(()),
            );
            error.unwrap_err().to_string()
        };
        assert!(run("/no/such/program", &[]).contains("/no/such/program cannot be started"));
        assert!(run("sh", &["-c", "echo error: no"]).ends_with("cannot be started: error: no"));
        assert!(run("sh", &["-c", "kill -SEGV $$"]).contains("it crashed: SIGSEGV"));
    }
}
