//! `cargo xtask soak`: mixed requests for a long time, whose answers, files and memory must stay as they are.

use crate::{python, root};
use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

const USAGE: &str = "usage: cargo xtask soak [--minutes N] [--program PATH] [--python PATH]
  asks the program and the Python package the same things again and again, with two workers, and exits with status 1 if an
  answer changes, a file is left over, or the memory of the Python process grows
  --minutes N     how long [60]
  --program PATH  the program to run; without it the one in the target folder is built
  --python PATH   an interpreter that has the package; without it, the one of `cargo xtask python` where it is there";

/// What a Python process asks of each file whose name it gets, one answer a line with the memory that it holds.
const ASK: &str = r#"
import sys, warnings
import coface
warnings.simplefilter("ignore")

def resident():
    with open("/proc/self/statm") as table:
        return int(table.read().split()[1]) * 4096

for line in sys.stdin:
    path = line.rstrip("\n")
    try:
        model = coface.read(path)
        answer = [str(coface.homology(model)), list(model.f_vector)]
    except coface.Error as error:
        answer = str(error)
    print(resident(), repr(answer), sep="\t", flush=True)
"#;

/// Growth of the Python process that is no leak: what allocators keep.
const SLACK: u64 = 16 << 20;

struct Soak {
    program: PathBuf,
    folder: PathBuf,
    inputs: Vec<PathBuf>,
    python: Option<Python>,
    /// The first answer to each request.
    answers: BTreeMap<String, String>,
    faults: Vec<String>,
    requests: usize,
}

struct Python {
    process: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    /// The memory after each round.
    rounds: Vec<u64>,
}

pub(crate) fn soak(words: &[String]) -> ExitCode {
    let Some((minutes, program, interpreter)) = parse(words) else {
        eprintln!("{USAGE}");
        return ExitCode::from(2);
    };
    let Some(program) = program.or_else(crate::wild::build) else {
        eprintln!("the program does not build");
        return ExitCode::FAILURE;
    };
    let folder = std::env::temp_dir().join(format!("coface-soak-{}", std::process::id()));
    let done = prepare(&folder, program, interpreter).and_then(|mut soak| {
        let (start, mut rounds) = (Instant::now(), 0);
        let end = Duration::from_secs_f64(60.0 * minutes);
        while start.elapsed() < end && soak.faults.is_empty() {
            soak.round()?;
            rounds += 1;
        }
        soak.finish();
        print!("{}", soak.summary(rounds, start.elapsed()));
        Ok(soak.faults.is_empty())
    });
    // What is left is in the way of nobody.
    let _ = fs::remove_dir_all(&folder);
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn parse(words: &[String]) -> Option<(f64, Option<PathBuf>, Option<PathBuf>)> {
    let (mut minutes, mut program, mut interpreter) = (60.0, None, None);
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match word.as_str() {
            "--minutes" => minutes = words.next()?.parse().ok().filter(|&minutes| minutes > 0.0)?,
            "--program" => program = Some(words.next()?.into()),
            "--python" => interpreter = Some(words.next()?.into()),
            _ => return None,
        }
    }
    Some((minutes, program, interpreter))
}

/// Models of many kinds, and the files of the repository and of `COFACE_DATA` up to a megabyte.
fn prepare(folder: &Path, program: PathBuf, interpreter: Option<PathBuf>) -> std::io::Result<Soak> {
    for name in ["in", "out", "tmp"] {
        fs::create_dir_all(folder.join(name))?;
    }
    let made: [&[&str]; 8] = [
        &["torus-grid", "--shape", "12,12"],
        &["torus-grid", "--shape", "5,5,5"],
        &["klein-grid"],
        &["lens", "--p", "7", "--q", "2"],
        &["cuboids", "--shape", "4,3,2"],
        &["cross-polytope", "--dimension", "5"],
        &["rp2"],
        &["grid", "--shape", "3,3,3"],
    ];
    for (number, words) in made.iter().enumerate() {
        let path = folder.join(format!("in/made{number}.json"));
        let status = Command::new(&program).args(["generate", "-q", "-o"]).arg(path).args(*words).status()?;
        if !status.success() {
            return Err(std::io::Error::other(format!("{} was not made: {status}", words.join(" "))));
        }
    }
    let mut folders = vec![folder.join("in"), root().join("data")];
    folders.extend(std::env::var_os("COFACE_DATA").map(PathBuf::from));
    let mut inputs = Vec::new();
    for folder in folders {
        for entry in fs::read_dir(folder)?.flatten() {
            let is_small = entry.metadata().is_ok_and(|found| found.is_file() && found.len() <= 1 << 20);
            if is_small {
                inputs.push(entry.path());
            }
        }
    }
    inputs.sort();
    let python = match interpreter.map(Command::new).or_else(python::with_package) {
        Some(command) => Some(Python::start(command, &folder.join("tmp"))?),
        None => {
            println!("the Python package is not there: it is left out");
            None
        }
    };
    let folder = folder.to_owned();
    Ok(Soak { program, folder, inputs, python, answers: BTreeMap::new(), faults: Vec::new(), requests: 0 })
}

impl Soak {
    /// Asks everything once.
    fn round(&mut self) -> std::io::Result<()> {
        let out = self.folder.join("out/rows.jsonl");
        let mut batch = self.command(&["batch", "-q", "-j", "2", "--no-timings", "-o"]);
        batch.arg(&out).args(&self.inputs);
        let status = batch.stdout(Stdio::null()).status()?;
        let rows = fs::read_to_string(&out)?;
        fs::remove_file(&out)?;
        self.requests += self.inputs.len();
        self.compare("batch", format!("{status} {rows}"));
        let mut last = None;
        for input in self.inputs.clone() {
            let name = input.display().to_string();
            for words in [&["homology", "--json", "--parts", "3"][..], &["loops", "--json"]] {
                // A minute is more than any of these takes: what hangs is a fault.
                let output = self
                    .command(words)
                    .args(["--threads", "1", "--time-limit", "60s"])
                    .arg(&input)
                    .output()?;
                let said = String::from_utf8_lossy(&output.stdout).into_owned();
                self.compare(&format!("{} {name}", words[0]), format!("{} {said}", output.status));
            }
            if let Some(python) = &mut self.python {
                let (resident, answer) = python.ask(&name)?;
                last = Some(resident);
                self.compare(&format!("python {name}"), answer);
            }
            self.look_for_files();
        }
        if let Some(python) = &mut self.python {
            python.rounds.extend(last);
        }
        Ok(())
    }

    fn command(&self, words: &[&str]) -> Command {
        let mut command = Command::new(&self.program);
        command.args(words).env("TMPDIR", self.folder.join("tmp")).stderr(Stdio::null()).stdin(Stdio::null());
        command
    }

    fn compare(&mut self, request: &str, answer: String) {
        self.requests += 1;
        match self.answers.get(request) {
            None => drop(self.answers.insert(request.to_owned(), answer)),
            Some(first) if *first == answer => {}
            Some(_) => self.faults.push(format!("{request}: another answer than at first")),
        }
    }

    /// Nothing is to stay in the folder of temporary files and in that of outputs.
    fn look_for_files(&mut self) {
        for folder in ["tmp", "out"] {
            let left = fs::read_dir(self.folder.join(folder)).into_iter().flatten().flatten();
            self.faults.extend(left.map(|entry| format!("{} is left over", entry.path().display())));
        }
    }

    fn finish(&mut self) {
        let Some(python) = &mut self.python else { return };
        // What is read in the first rounds stays in caches.
        let (Some(first), Some(last)) = (python.rounds.get(1), python.rounds.last()) else { return };
        if *last > first + first / 10 + SLACK {
            self.faults.push(format!("the Python process grew from {first} to {last} bytes"));
        }
        // Its end is that of its input.
        let _ = python.process.kill();
        let _ = python.process.wait();
    }

    fn summary(&self, rounds: usize, time: Duration) -> String {
        let memory = self.python.as_ref().map_or_else(String::new, |python| {
            let mebibytes = |bytes: Option<&u64>| bytes.map_or(0, |bytes| bytes >> 20);
            let (first, last) = (python.rounds.get(1), python.rounds.last());
            format!(
                "the Python process holds {} MiB, after the second round {}\n",
                mebibytes(last),
                mebibytes(first)
            )
        });
        let faults: String = self.faults.iter().take(20).map(|fault| format!("{fault}\n")).collect();
        format!(
            "{} requests on {} files in {rounds} rounds, {:.0} s\n{memory}{faults}{} faults\n",
            self.requests,
            self.inputs.len(),
            time.as_secs_f64(),
            self.faults.len()
        )
    }
}

impl Python {
    fn start(mut command: Command, temporary: &Path) -> std::io::Result<Self> {
        command.args(["-c", ASK]).env("TMPDIR", temporary);
        let mut process = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let missing = || std::io::Error::other("the Python process has no pipes");
        let input = process.stdin.take().ok_or_else(missing)?;
        let output = BufReader::new(process.stdout.take().ok_or_else(missing)?);
        Ok(Self { process, input, output, rounds: Vec::new() })
    }

    /// The memory of the process after a request, and the answer.
    fn ask(&mut self, path: &str) -> std::io::Result<(u64, String)> {
        writeln!(self.input, "{path}")?;
        self.input.flush()?;
        let mut line = String::new();
        self.output.read_line(&mut line)?;
        let ended = || std::io::Error::other(format!("the Python process ended at {path}"));
        let (resident, answer) = line.split_once('\t').ok_or_else(ended)?;
        Ok((resident.parse().map_err(|_| ended())?, answer.to_owned()))
    }
}
