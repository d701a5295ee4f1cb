//! `coface batch`: the report over many files.

use crate::arguments::{Common, Limit, memory_limit, time_limit};
use crate::failure::Failure;
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use crate::remarks::say_remarks;
use crate::workers::{self, Task};
use clap::{Args, ValueEnum};
use coface::algebra::escaped;
use coface::answers::SignatureRequest;
use coface::answers::answer::{BatchAnswer, Remark, RemarkCode};
use coface::io::entry_of;
use coface::scale::batch::{Batch as Files, Reading, Summary, TableFormat, find_files};
use coface::scale::signatures::{SignatureBatch, are_signature_lists};
use coface::scale::workers::Limits;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Report on many files, one row a file, into a table.
///
/// PATHS are files; folders, for the files of known formats in them; patterns in quotes, like 'models/**/*.ply'; @LIST, a file with one
/// path a line; or -, the same on standard input. A file of several models, such as JSON lines or a census of isomorphism signatures, has
/// a row for each, with the path FILE#NAME that chooses it in any verb; an OBJ of several objects or an STL of several solids has one for
/// the whole and one for each. A row has path, bytes, seconds, error, and everything that coface info --json says. In
/// JSON lines that is one object; in CSV and Parquet cells are f_0, f_1, .., homology is betti_0, .., torsion_0, .., and lists are text.
///
/// Lists of isomorphism signatures alone, such as census.sig, are read as they come, whatever their length, a row a line: path, line, name,
/// signature, error, and counts, verdicts and homology of the triangulation; --with pi1,names adds fundamental groups and the names of 3-manifolds. A line has a signature and
/// perhaps a name, in either order, with tabs or blanks between them; a bad line is a row with its error. Limits of time and memory and
/// rows of an earlier run are for models in files.
///
/// Files are read by worker processes: one that crashes, takes too long or needs too much memory costs its row alone, which says so.
/// Rows are in the order of the paths, the same for any number of jobs. A run that is cut short goes on where it was when it is started again:
/// finished rows are kept beside OUT, which appears whole at the end.
#[derive(Args)]
pub(crate) struct Batch {
    /// Files, folders, patterns, @LIST; - is a list on standard input
    #[arg(required = true, value_name = "PATHS")]
    paths: Vec<PathBuf>,
    /// Take the files of folders in folders too
    #[arg(long, short)]
    recursive: bool,
    /// Read at most N files at once [default: one a core]
    #[arg(long, short, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    /// The longest that one file may take: 500ms, 60s, 5m, 2h, or none
    #[arg(long, value_name = "TIME", default_value = "60s", value_parser = time_limit)]
    timeout: Limit<Duration>,
    /// The most memory that one file may take: 500M, 2G, or none
    #[arg(long, value_name = "SIZE", default_value = if cfg!(unix) { "2G" } else { "none" }, value_parser = worker_memory)]
    memory: Limit<u64>,
    /// Do not take rows that an earlier run finished
    #[arg(long)]
    restart: bool,
    /// Make everything that a reader assumes an error of its row, and exit with status 1 if any row is an error
    #[arg(long)]
    strict: bool,
    /// Leave out the seconds, so that equal files give equal bytes
    #[arg(long)]
    no_timings: bool,
    /// List every place of every problem, not just the first hundred
    #[arg(long)]
    all: bool,
    /// Add to the rows of lists of signatures: fundamental groups, names of 3-manifolds
    #[arg(long, value_name = "WHAT", value_enum, value_delimiter = ',')]
    with: Vec<Extra>,
}

/// What rows of signatures have beside the usual.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Extra {
    /// The fundamental group of each component
    Pi1,
    /// Which 3-manifold it is, where that is proved, and what the name rests on
    Names,
}

/// The memory of a worker.
fn worker_memory(text: &str) -> Result<Limit<u64>, String> {
    let limit = memory_limit(text)?;
    match limit.0 {
        Some(bytes) if bytes < LEAST => Err("a worker needs 64M to start".to_owned()),
        _ => Ok(limit),
    }
}

/// Below this no worker starts.
const LEAST: u64 = 64 << 20;

impl Batch {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let Some(out) = &common.output else {
            return Err(Failure::new(
                "the rows go to a file: name it with -o, ending in .jsonl, .csv or .parquet",
            ));
        };
        let format = TableFormat::of_path(out)?;
        common.points.refuse("batch")?;
        let progress = Progress::start(common.quiet);
        if are_signature_lists(&self.paths, common.format) {
            let summary = self.signatures(common).write(out, format)?;
            drop(progress);
            return self.say(&summary, out, common);
        }
        if !self.with.is_empty() {
            return Err(Failure::new(
                "--with is for lists of isomorphism signatures, and not all paths are such lists; ask coface pi1 about other models",
            ));
        }
        progress.stage("finding files");
        let mut files = find_files(&self.paths, self.recursive, std::io::stdin().lock())?;
        // The rows of an earlier run, in a folder of the files.
        if let Ok(earlier) = out.canonicalize() {
            let name = earlier.file_name();
            let is_earlier = |file: &Path| {
                file.file_name() == name && file.canonicalize().is_ok_and(|file| file == earlier)
            };
            files.retain(|file| !is_earlier(entry_of(file).map_or(file, |(file, _)| file)));
        }
        let mut batch = Files::new(files);
        batch.reading = Reading {
            format: common.format,
            flatten: common.flatten,
            volume: common.voxels.reading(),
            strict: self.strict,
            partial: common.partial,
            allow_outside: common.allow_outside,
            lod: common.lod,
            pseudomanifold: common.pseudomanifold,
            all_places: self.all,
        };
        (batch.timings, batch.restart) = (!self.no_timings, self.restart);
        let limits = Limits { time: self.timeout.0, memory: self.memory.0 };
        let jobs = self.jobs.map_or_else(workers::core_count, usize::from);
        let pool = workers::pool(Task::Info, jobs, common.threads.map_or(1, usize::from), limits)?;
        let summary = batch.write(&pool, out, format)?;
        drop(progress);
        self.say(&summary, out, common)
    }

    /// The lists and what is asked about their lines.
    fn signatures(&self, common: &Common) -> SignatureBatch {
        let mut batch = SignatureBatch::new(self.paths.clone());
        batch.request = SignatureRequest::new()
            .groups(self.with.contains(&Extra::Pi1))
            .names(self.with.contains(&Extra::Names))
            .pseudomanifold(common.pseudomanifold);
        batch.jobs = self.jobs.map_or_else(workers::core_count, usize::from);
        batch
    }

    /// Says what came of it.
    fn say(&self, summary: &Summary, out: &Path, common: &Common) -> Result<(), Failure> {
        let mut answer = BatchAnswer::new(out.display().to_string());
        (answer.files, answer.resumed) = (summary.files(), summary.resumed());
        answer.errors.clone_from(summary.errors());
        let refused = summary.refused();
        answer.remarks.extend(refused.map(|why| Remark::new(RemarkCode::EarlierRunIgnored, why)));
        say_remarks(&answer.remarks, common);
        if common.json {
            print_json(&answer)?;
        } else {
            let noun = if are_signature_lists(&self.paths, common.format) { "line" } else { "file" };
            print_text(&format!("{}: {}\n", escaped(&answer.output), in_words(&answer, noun)))?;
        }
        match answer.error_count() {
            count @ 1.. if self.strict => {
                Err(Failure::new(format!("{count} of {} rows are errors", answer.files)))
            }
            _ => Ok(()),
        }
    }
}

/// The summary for people: `12 files, 2 errors (1 parse, 1 time)`.
fn in_words(answer: &BatchAnswer, noun: &str) -> String {
    let plural = |count: usize, noun: &str| format!("{count} {noun}{}", if count == 1 { "" } else { "s" });
    let mut text = plural(answer.files, noun);
    match answer.error_count() {
        0 => text += ", no errors",
        count => {
            let kinds: Vec<String> =
                answer.errors.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
            text += &format!(", {} ({})", plural(count, "error"), kinds.join(", "));
        }
    }
    if answer.resumed > 0 {
        text += &format!("; {} from an earlier run", plural(answer.resumed, "row"));
    }
    text
}
