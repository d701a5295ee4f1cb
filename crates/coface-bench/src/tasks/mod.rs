//! What is measured: one file an algorithm.
//!
//! A task reads its input file and prepares what it needs outside the clock, works inside it, and says what came out, so
//! that a wrong answer is seen beside its time.

mod boundary_matrices;
mod boxes;
mod certificates;
mod congruence;
mod edges;
mod generators;
mod halfedges;
mod homology;
mod info;
mod kinks;
mod manifold;
mod operators;
mod parts;
mod persistence;
mod planar;
mod reading;
mod simplicial;
mod solids;
mod surfaces;
mod yin;

use crate::measure::{Measurement, own_high_water_mark, own_processor_seconds};
use coface::Error;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// One algorithm under the clock.
pub(crate) struct Task {
    pub(crate) name: &'static str,
    pub(crate) about: &'static str,
    /// The format of its input file.
    pub(crate) extension: &'static str,
    /// What `run` gives it: sizes n, 2n, 4n or so.
    pub(crate) inputs: &'static [&'static str],
    pub(crate) work: Work,
}

/// How a task runs.
pub(crate) enum Work {
    /// In a process of this program; the function prepares, then works within the clock.
    Inside(fn(&Path, &mut Clock) -> Result<String, Error>),
    /// As the program `coface` with these words before the file.
    Program(&'static [&'static str]),
}

/// All tasks.
pub(crate) const ALL: &[Task] = &[
    reading::OBJ,
    reading::OFF,
    reading::PLY,
    edges::TASK,
    halfedges::TASK,
    manifold::TASK,
    boundary_matrices::TASK,
    homology::SURFACE,
    homology::SOLID,
    homology::REDUCTION,
    generators::SURFACE,
    generators::SOLID,
    generators::COMPLEX,
    persistence::SURFACE,
    persistence::SOLID,
    simplicial::INSERTION,
    simplicial::FREEZING,
    simplicial::STARS,
    simplicial::LINKS,
    simplicial::LINK_SIMPLICES,
    surfaces::LOOPS,
    surfaces::LOOPS_BY_GENUS,
    surfaces::COCYCLES,
    surfaces::COCYCLES_BY_GENUS,
    congruence::WELD,
    congruence::QUOTIENT,
    operators::FACES,
    operators::VERTICES,
    operators::GRID,
    planar::SEGMENTS,
    planar::LONG_SEGMENTS,
    planar::SHORT_SEGMENTS,
    planar::INTERSECTION,
    planar::UNION,
    yin::MEET,
    yin::JOIN,
    yin::FLOWERS,
    yin::NESTED,
    yin::RINGS,
    yin::DISKS,
    yin::CUT,
    kinks::EDIT,
    kinks::INSERTION,
    yin::FIT,
    solids::INTERSECTION,
    solids::UNION,
    solids::CHECKS,
    certificates::CERTIFY,
    certificates::CHECK,
    certificates::CERTIFY_SOLIDS,
    certificates::CHECK_SOLIDS,
    boxes::ROW,
    boxes::BLOCK,
    boxes::DOLLS,
    boxes::ROOMS,
    boxes::CHAIN,
    parts::TORUS,
    parts::SIMPLICIAL_TORUS,
    parts::VOLUME,
    info::TASK,
];

/// Surfaces of about 250,000, 500,000 and 1,000,000 triangles.
const SURFACES: &[&str] = &["genus10_160", "genus10_255", "genus10_360", "genus10_510"];
/// Solids of about 100,000, 250,000, 500,000 and 1,000,000 tetrahedra.
const SOLIDS: &[&str] = &["t3_26", "t3_35", "t3_44", "t3_55"];

impl Task {
    /// The command that measures the task on a file once, in its own process.
    ///
    /// # Errors
    /// If this program, or the program `coface` beside it, is not found.
    pub(crate) fn command(&self, path: &Path, threads: Option<usize>) -> Result<Command, Error> {
        let own = std::env::current_exe()?;
        let mut command = match self.work {
            Work::Inside(_) => {
                let mut command = Command::new(own);
                command.arg("sample").arg(self.name);
                command
            }
            Work::Program(words) => {
                let program = own.with_file_name(format!("coface{}", std::env::consts::EXE_SUFFIX));
                if !program.exists() {
                    return Err(Error::invalid("the program coface is not built")
                        .with_cure("run `cargo build --release --workspace` first"));
                }
                let mut command = Command::new(program);
                command.args(words);
                command
            }
        };
        command.arg(path);
        if let Some(threads) = threads {
            command.env("RAYON_NUM_THREADS", threads.to_string());
        }
        Ok(command)
    }
}

/// The task of this name.
///
/// # Errors
/// If there is none.
pub(crate) fn find(name: &str) -> Result<&'static Task, Error> {
    ALL.iter().find(|task| task.name == name).ok_or_else(|| {
        Error::invalid(format!("{name:?} is no task")).with_cure("see `coface-bench list` for the tasks")
    })
}

/// Performs the task once, here.
///
/// # Errors
/// If there is no such task, or it fails.
pub(crate) fn sample(name: &str, path: &Path) -> Result<Measurement, Error> {
    let Work::Inside(work) = find(name)?.work else {
        return Err(Error::invalid(format!("{name} runs as a program of its own")));
    };
    let mut clock = Clock::default();
    let result = work(path, &mut clock)?;
    Ok(Measurement {
        seconds: clock.seconds,
        cpu_seconds: clock.cpu_seconds,
        peak_megabytes: own_high_water_mark(),
        before_megabytes: Some(clock.before_megabytes),
        size: clock.size,
        result,
    })
}

/// Times the work of a task, not its preparation.
#[derive(Default)]
pub(crate) struct Clock {
    seconds: f64,
    cpu_seconds: Option<f64>,
    before_megabytes: f64,
    size: f64,
}

impl Clock {
    /// Times the work on an input of this size.
    pub(crate) fn time<T>(&mut self, size: usize, work: impl FnOnce() -> T) -> T {
        self.size = size as f64;
        self.before_megabytes = own_high_water_mark();
        let (begin, begin_cpu) = (Instant::now(), own_processor_seconds());
        let result = work();
        self.seconds = begin.elapsed().as_secs_f64();
        self.cpu_seconds = own_processor_seconds().zip(begin_cpu).map(|(end, begin)| end - begin);
        result
    }
}
