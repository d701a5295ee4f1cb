//! The side of the worker: requests in, answers out.

use crate::workers::loss::FAULT;
use crate::workers::process::READY;
use coface_algebra::{Error, ErrorKind};
use std::io::{self, BufRead, Write};
use std::panic::PanicHookInfo;
use std::sync::mpsc::{Receiver, channel};
use std::thread;

/// Answers the requests of a [`WorkerPool`](crate::workers::WorkerPool), line by line, until there are no more. Then the process has to end.
///
/// It first takes the memory limit from standard input, keeps it, and says that it is ready on standard output; nothing else may write
/// there. `answer` gives one line to each request. A panic in it ends the process and is reported in one line.
///
/// When standard input ends while a request is being answered, the answer is no longer needed: the process ends at once, and leaves no
/// temporary files.
///
/// # Errors
/// [`ErrorKind::Io`] when the limit cannot be kept or standard output cannot be written.
///
/// # Examples
/// ```no_run
/// // The main function of a worker that counts bytes:
/// fn main() -> Result<(), coface_algebra::Error> {
///     coface_scale::workers::serve(|request| request.len().to_string())
/// }
/// ```
pub fn serve(mut answer: impl FnMut(&str) -> String) -> Result<(), Error> {
    std::panic::set_hook(Box::new(tell));
    let requests = requests()?;
    let Ok(limits) = requests.recv() else { return Ok(()) };
    let kept = match limits.strip_prefix("memory ") {
        Some("none") => limit(None),
        Some(bytes) => match bytes.parse() {
            Ok(bytes) => limit(Some(bytes)),
            Err(_) => Err(Error::parse(format!("\"{bytes}\" is no number of bytes"))),
        },
        None => Err(Error::parse("the first line that a worker reads is its memory limit")
            .with_cure("start it by a pool")),
    };
    match kept {
        Ok(()) => say(READY)?,
        Err(error) => return say(&error.to_string()),
    }
    for request in requests {
        let line = answer(&request);
        debug_assert!(!line.contains('\n'), "an answer is one line");
        say(&line)?;
    }
    Ok(())
}

/// The lines of standard input, read by a thread that ends the process at their end.
fn requests() -> Result<Receiver<String>, Error> {
    let (send, requests) = channel();
    let read = move || {
        for line in io::stdin().lock().lines().map_while(Result::ok) {
            if send.send(line).is_err() {
                break;
            }
        }
        coface_io::abandon_files();
        std::process::exit(0);
    };
    let builder = thread::Builder::new().name("coface-requests".to_owned());
    builder
        .spawn(read)
        .map_err(|error| Error::new(ErrorKind::Io, format!("no thread can be started: {error}")))?;
    Ok(requests)
}

fn say(line: &str) -> Result<(), Error> {
    let mut out = io::stdout().lock();
    out.write_all(line.as_bytes())?;
    out.write_all(b"\n")?;
    Ok(out.flush()?)
}

/// Reports a panic in one line.
fn tell(panic: &PanicHookInfo<'_>) {
    let payload = panic.payload();
    let text =
        payload.downcast_ref::<&str>().copied().or(payload.downcast_ref::<String>().map(String::as_str));
    let what = text.unwrap_or("panic").replace('\n', " ");
    let place = panic.location().map_or_else(String::new, |place| format!(" at {place}"));
    // Without standard error there is nobody to tell.
    let _ = writeln!(io::stderr(), "{FAULT}{what}{place}");
}

/// Limits the address space of this process, and keeps it from leaving a copy of its memory when it crashes.
#[cfg(unix)]
fn limit(memory: Option<u64>) -> Result<(), Error> {
    use nix::sys::resource::{Resource, getrlimit, setrlimit};
    let fault =
        |error: nix::errno::Errno| Error::new(ErrorKind::Io, format!("limits cannot be set: {error}"));
    setrlimit(Resource::RLIMIT_CORE, 0, 0).map_err(fault)?;
    if let Some(memory) = memory {
        let (_, hard) = getrlimit(Resource::RLIMIT_AS).map_err(fault)?;
        let memory = memory.min(hard);
        setrlimit(Resource::RLIMIT_AS, memory, memory).map_err(fault)?;
    }
    Ok(())
}

#[cfg(not(unix))]
fn limit(memory: Option<u64>) -> Result<(), Error> {
    match memory {
        None => Ok(()),
        Some(_) => Err(Error::new(
            ErrorKind::UnsupportedFormat,
            "this system does not limit the memory of a process",
        )
        .with_cure("set no limit of memory")),
    }
}
