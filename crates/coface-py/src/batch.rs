//! Reports on many files by worker processes.

use crate::errors::{OrRaise, invalid};
use crate::target::format_of;
use crate::volumes::{Voxels, reading_of};
use crate::work::run;
use coface::answers::SignatureRequest;
use coface::scale::batch::{Batch, Reading, TableFormat};
use coface::scale::signatures::{SignatureBatch, SignatureRows};
use coface::scale::workers::{Limits, WorkerCommand, WorkerPool};
use coface::{Error, ErrorKind};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::thread::available_parallelism;
use std::time::Duration;

/// How a batch is done, as the function of Python says it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Options {
    /// The program of workers and its arguments.
    command: Vec<String>,
    environment: BTreeMap<String, String>,
    jobs: Option<usize>,
    timeout: Option<f64>,
    memory: Option<u64>,
    format: Option<String>,
    flatten: Option<f64>,
    strict: bool,
    partial: bool,
    allow_outside: bool,
    voxels: Voxels,
    all_places: bool,
    timings: bool,
    restart: bool,
}

impl Options {
    fn pool(&self, py: Python<'_>) -> PyResult<WorkerPool> {
        let time = self.timeout.map(Duration::try_from_secs_f64).transpose().ok();
        let Some(time) = time.filter(|time| time.is_none_or(|time| !time.is_zero())) else {
            return Err(invalid(py, "the timeout is no time", "give seconds above 0, or None"));
        };
        let Some((program, arguments)) = self.command.split_first() else {
            return Err(invalid(py, "workers have no program", "run in a Python with an executable"));
        };
        let mut command = WorkerCommand::new(program, arguments);
        command.environment =
            self.environment.iter().map(|(name, value)| (name.into(), value.into())).collect();
        let jobs = self.jobs.unwrap_or_else(|| available_parallelism().map_or(1, usize::from));
        Ok(WorkerPool::new(command, jobs, Limits { time, memory: self.memory }))
    }

    fn batch(&self, py: Python<'_>, files: Vec<PathBuf>) -> PyResult<Batch> {
        let format = format_of(py, self.format.as_deref())?;
        let mut batch = Batch::new(files);
        let volume = reading_of(py, &self.voxels)?;
        let Self { flatten, strict, partial, all_places, allow_outside, .. } = *self;
        batch.reading = Reading {
            format,
            flatten,
            volume,
            strict,
            partial,
            all_places,
            allow_outside,
            ..Reading::default()
        };
        (batch.timings, batch.restart) = (self.timings, self.restart);
        Ok(batch)
    }
}

/// The rows of files as lines of JSON, in their order.
#[pyfunction]
#[pyo3(signature = (files, options, progress=None))]
pub(crate) fn _batch_lines(
    py: Python<'_>,
    files: Vec<PathBuf>,
    options: Options,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Vec<String>> {
    let (pool, batch) = (options.pool(py)?, options.batch(py, files)?);
    let mut lines = vec![String::new(); batch.files.len()];
    run(py, progress, || {
        batch.rows(&pool, |place, row| {
            lines[place] = row.to_line(batch.timings);
            Ok(())
        })
    })?;
    Ok(lines)
}

/// Writes the rows of files to a table: the numbers of rows, of errors by kind, and of rows from an earlier run.
#[pyfunction]
#[pyo3(signature = (files, out, options, progress=None))]
pub(crate) fn _batch_write(
    py: Python<'_>,
    files: Vec<PathBuf>,
    out: PathBuf,
    options: Options,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<(usize, BTreeMap<String, usize>, usize)> {
    let (pool, batch) = (options.pool(py)?, options.batch(py, files)?);
    let format = TableFormat::of_path(&out).or_raise(py)?;
    let summary = run(py, progress, || batch.write(&pool, &out, format))?;
    Ok((summary.files(), summary.errors().clone(), summary.resumed()))
}

/// Writes rows in a file of JSON lines as CSV or Parquet.
#[pyfunction]
pub(crate) fn _table_of_lines(py: Python<'_>, lines: PathBuf, out: PathBuf, timings: bool) -> PyResult<()> {
    run(py, None, || coface::scale::batch::table_of_lines(&lines, &out, timings))
}

/// The rows of lists of signatures as lines of JSON, as they are asked for.
#[pyclass(unsendable, module = "coface._coface")]
pub(crate) struct _SignatureRows {
    rows: SignatureRows,
}

#[pymethods]
impl _SignatureRows {
    #[new]
    fn new(files: Vec<PathBuf>, groups: bool, pseudomanifold: bool, jobs: Option<usize>) -> Self {
        Self { rows: signature_batch(files, groups, pseudomanifold, jobs).rows() }
    }

    fn __iter__(this: PyRef<'_, Self>) -> PyRef<'_, Self> {
        this
    }

    fn __next__(&mut self, py: Python<'_>) -> PyResult<Option<String>> {
        self.rows.next().transpose().or_raise(py).map(|row| row.map(|row| row.to_line()))
    }
}

fn signature_batch(
    files: Vec<PathBuf>,
    groups: bool,
    pseudomanifold: bool,
    jobs: Option<usize>,
) -> SignatureBatch {
    let mut batch = SignatureBatch::new(files);
    batch.request = SignatureRequest::new().groups(groups).pseudomanifold(pseudomanifold);
    batch.jobs = jobs.unwrap_or_else(|| available_parallelism().map_or(1, usize::from));
    batch
}

/// Writes the rows of lists of signatures to a table: the numbers of rows, and of errors by kind.
#[pyfunction]
#[pyo3(signature = (files, out, groups, pseudomanifold, jobs, progress=None))]
pub(crate) fn _signatures_write(
    py: Python<'_>,
    files: Vec<PathBuf>,
    out: PathBuf,
    groups: bool,
    pseudomanifold: bool,
    jobs: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<(usize, BTreeMap<String, usize>, usize)> {
    let format = TableFormat::of_path(&out).or_raise(py)?;
    let batch = signature_batch(files, groups, pseudomanifold, jobs);
    let summary = run(py, progress, || batch.write(&out, format))?;
    Ok((summary.files(), summary.errors().clone(), summary.resumed()))
}

/// Writes a file that appears whole or not at all.
#[pyfunction]
pub(crate) fn _replace_file(py: Python<'_>, path: PathBuf, data: &Bound<'_, PyBytes>) -> PyResult<()> {
    // Bytes of Python do not change, and are kept by the caller.
    let bytes = data.as_bytes();
    run(py, None, || coface::io::replace_file(&path, |out| Ok(out.write_all(bytes)?)))
}

/// Copies a file to one that appears whole or not at all.
#[pyfunction]
pub(crate) fn _copy_file(py: Python<'_>, source: PathBuf, target: PathBuf) -> PyResult<()> {
    run(py, None, || {
        let mut input = std::fs::File::open(&source)
            .map_err(|error| Error::from(error).in_file(source.display().to_string()))?;
        coface::io::replace_file(&target, |out| Ok(std::io::copy(&mut input, out).map(|_| ())?))
    })
}

/// A row in a line of JSON as a list of names and values, one a column, in a line of JSON.
#[pyfunction]
pub(crate) fn _flat_line(py: Python<'_>, line: &str, timings: bool) -> PyResult<String> {
    coface::scale::batch::flat_line(line, timings).or_raise(py)
}

/// The files that words name: see `coface batch`.
#[pyfunction]
pub(crate) fn _find_files(py: Python<'_>, words: Vec<PathBuf>, recursive: bool) -> PyResult<Vec<PathBuf>> {
    coface::scale::batch::find_files(&words, recursive, std::io::empty()).or_raise(py)
}

/// Answers requests on standard input until there are no more: what a worker does. `fetch` gives the bytes at a URL.
#[pyfunction]
pub(crate) fn _serve(py: Python<'_>, fetch: Py<PyAny>) -> PyResult<()> {
    let bytes_at = |path: &Path| {
        let url = path.to_str().filter(|path| path.contains("://"))?;
        Some(Python::attach(|py| {
            let bytes = fetch.call1(py, (url,)).and_then(|bytes| bytes.extract::<Vec<u8>>(py));
            bytes.map_err(|fault| {
                if fault.is_instance_of::<PyMemoryError>(py) {
                    // Told as the library does, so that the pool knows.
                    let _ = writeln!(std::io::stderr(), "memory allocation of a file failed");
                    std::process::abort();
                }
                Error::new(ErrorKind::Io, fault.to_string()).in_file(url)
            })
        }))
    };
    py.detach(|| {
        let mut examiner = coface::scale::batch::Examiner::default();
        coface::scale::workers::serve(|request| examiner.examine_with(request, bytes_at))
    })
    .or_raise(py)
}
