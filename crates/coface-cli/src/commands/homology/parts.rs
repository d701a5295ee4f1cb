//! `coface homology --parts`: the complex in shards, reduced and merged by worker processes of limited memory.
//!
//! The process that was called reads no model and no shard: it hands out requests, one a line, and shows what comes back.

use crate::arguments::{Common, Limit, VoxelArguments, memory_limit};
use crate::commands::merge::{Answer, Question};
use crate::commands::shard::{Cut, CutRequest, GridArguments, cut_input, fingerprint};
use crate::failure::Failure;
use crate::points::PointArguments;
use crate::progress::Progress;
use crate::workers::{Sharing, Task, WorkFolder, WorkerReply, line, reply_to, text_of_path};
use clap::Args;
use coface::answers::answer::HomologyAnswer;
use coface::scale::shards::ShardFolder;
use coface::scale::workers::{Loss, bytes_text};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Work in parts.
#[derive(Args)]
pub(super) struct PartsOptions {
    /// Cut the complex into N parts that are reduced by worker processes, so that it may be larger than memory [default with --memory: as
    /// many as memory asks for]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000), help_heading = "In parts")]
    parts: Option<u32>,
    /// The memory of all worker processes together, as in 500M or 2G; what needs more is an error
    #[arg(long, value_name = "SIZE", value_parser = memory_limit, help_heading = "In parts")]
    memory: Option<Limit<u64>>,
    /// Keep shards and what is left of them in this folder, and go on with what is finished there
    #[arg(long, value_name = "FOLDER", help_heading = "In parts")]
    work: Option<PathBuf>,
    /// How many neighbors are merged at once
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = clap::value_parser!(u32).range(2..=1_000_000), help_heading = "In parts")]
    fan_in: u32,
    /// Which part each maximal cell goes to; see coface shard
    #[arg(long, value_name = "positions|walk|random|FILE", help_heading = "In parts")]
    owners: Option<PathBuf>,
    #[command(flatten)]
    grid: GridArguments,
}

impl PartsOptions {
    /// Whether work in parts is asked for.
    pub(super) fn are_given(&self) -> bool {
        let has_grid = self.grid.grid.is_some() || self.grid.simplicial;
        self.parts.is_some() || self.memory().is_some() || self.work.is_some() || has_grid
    }

    /// The memory of all worker processes together, if it is limited.
    fn memory(&self) -> Option<u64> {
        self.memory.and_then(|limit| limit.0)
    }

    /// Answers the question about an input.
    pub(super) fn run(&self, input: &Path, question: &Question, common: &Common) -> Result<(), Failure> {
        question.check()?;
        common.points.refuse("homology in parts")?;
        let progress = Progress::start(common.quiet);
        let work = WorkFolder::new(self.work.as_deref())?;
        let runner = Runner::new(self, common, work.path())?;
        let given = input;
        let input = work.standard_input(given)?;
        let name = (input != given).then(|| crate::input::name(given));
        let (part_count, fan_in) = runner.shard(&input, name.as_deref(), common)?;
        runner.reduce(part_count)?;
        runner.merge(part_count, fan_in)?;
        let answer = runner.answer(question)?;
        drop(progress);
        drop(work);
        answer.give(question, common)
    }
}

/// What a worker is asked, a line each. Paths are text, since lines are.
#[derive(Serialize, Deserialize)]
enum Request {
    /// Cut an input into shards.
    Shard(Box<ShardTask>),
    /// Reduce a part.
    Reduce { folder: String, number: u32 },
    /// Merge parts to one of this level.
    Merge { folder: String, level: u32, number: u32 },
    /// Say whether a level is the last.
    Look { folder: String, level: u32 },
    /// Answer a question about what is left.
    Answer { folder: String, coefficients: String, cohomology: bool, generators: bool },
}

/// How an input is cut, and how it is read.
#[derive(Serialize, Deserialize)]
struct ShardTask {
    folder: String,
    input: String,
    /// The name of the input in messages, where it is not that of the file.
    name: Option<String>,
    parts: Option<u32>,
    /// In bytes, for this worker.
    memory: Option<u64>,
    fan_in: u32,
    owners: Option<String>,
    format: Option<String>,
    /// In the unit of the input.
    flatten: Option<f64>,
    strict: bool,
    partial: bool,
    allow_outside: bool,
    lod: Option<f64>,
    pseudomanifold: bool,
    voxels: VoxelArguments,
    grid: Option<Vec<u32>>,
    simplicial: bool,
}

/// What a worker replies, a line each.
#[derive(Serialize, Deserialize)]
enum Reply {
    /// The input is cut.
    Sharded { parts: u32, fan_in: u32 },
    /// A part is reduced, or parts are merged.
    Done,
    /// Whether the level is the last.
    Looked { is_root: bool },
    /// The answer, and the same as text for people.
    Answered { object: Box<HomologyAnswer>, page: String },
    /// The request cannot be served.
    Error(String),
}

/// A line of a worker that is not the reply to what it was asked.
fn unexpected() -> Failure {
    Failure::new("a worker replied to another request; run the command again")
}

impl WorkerReply for Reply {
    fn of_error(message: String) -> Self {
        Self::Error(message)
    }

    fn error(&self) -> Option<&str> {
        match self {
            Self::Error(message) => Some(message),
            _ => None,
        }
    }
}

struct Runner<'a> {
    options: &'a PartsOptions,
    folder: &'a Path,
    folder_text: String,
    sharing: Sharing,
}

impl<'a> Runner<'a> {
    fn new(options: &'a PartsOptions, common: &Common, folder: &'a Path) -> Result<Self, Failure> {
        let sharing = Sharing::new(Task::Shards, common.threads, options.memory())?;
        Ok(Self { options, folder, folder_text: text_of_path(folder)?, sharing })
    }

    /// Has shards made, unless they are there. Gives the number of parts and the fan-in.
    fn shard(&self, input: &Path, name: Option<&str>, common: &Common) -> Result<(u32, u32), Failure> {
        let cut = Cut {
            parts: self.options.parts.unwrap_or(0),
            fan_in: self.options.fan_in,
            owners: self.options.owners.clone(),
            grid: self.options.grid.clone(),
        };
        let fingerprint = fingerprint(input, &cut, common);
        if let Ok(folder) = ShardFolder::open(self.folder)
            && !fingerprint.is_empty()
            && folder.manifest().source.fingerprint == fingerprint
            && (0..folder.manifest().part_count).all(|number| folder.shard_path(number).exists())
        {
            return Ok((folder.manifest().part_count, folder.manifest().fan_in));
        }
        let request = Request::Shard(Box::new(ShardTask {
            folder: self.folder_text.clone(),
            input: text_of_path(input)?,
            name: name.map(str::to_owned),
            parts: self.options.parts,
            memory: self.options.memory().map(|memory| memory / self.sharing.workers as u64),
            fan_in: self.options.fan_in,
            owners: self.options.owners.as_deref().map(text_of_path).transpose()?,
            format: common.format.map(|format| format.name().to_owned()),
            flatten: common.flatten,
            strict: common.strict,
            partial: common.partial,
            allow_outside: common.allow_outside,
            lod: common.lod,
            pseudomanifold: common.pseudomanifold,
            voxels: common.voxels.clone(),
            grid: self.options.grid.grid.clone(),
            simplicial: self.options.grid.simplicial,
        }));
        let answer = self.sharing.ask::<Reply>("cutting into shards", 1, 1, |_| line(&request))?.remove(0);
        let answer = answer.map_err(|loss| {
            Failure::new(match loss {
                Loss::Memory { .. } => format!(
                    "{}: {loss} to be cut into parts; allow more, or cut it on a larger machine by coface shard",
                    input.display()
                ),
                loss => format!("{}: it could not be cut into parts: {loss}; {}", input.display(), loss.cure()),
            })
        })?;
        match answer {
            Reply::Sharded { parts, fan_in } => Ok((parts, fan_in)),
            _ => Err(unexpected()),
        }
    }

    fn reduce(&self, part_count: u32) -> Result<(), Failure> {
        let request = |number: u32| line(&Request::Reduce { folder: self.folder_text.clone(), number });
        self.sharing.ask_all::<Reply>("reducing parts", part_count, request, |number, loss| match loss {
            Loss::Memory { limit } => format!(
                "part {number} of {part_count} needs more than {} of memory; cut into more by --parts {}, or allow more",
                limit.map_or("all".to_owned(), bytes_text),
                u64::from(part_count) * 2
            ),
            loss => format!("part {number} of {part_count} could not be reduced: {loss}; {}", loss.cure()),
        })?;
        Ok(())
    }

    fn merge(&self, part_count: u32, fan_in: u32) -> Result<(), Failure> {
        let mut width = part_count;
        for level in 1.. {
            let was_one = width == 1;
            if was_one && self.is_root(level - 1)? {
                break;
            }
            width = width.div_ceil(fan_in);
            let request =
                |number: u32| line(&Request::Merge { folder: self.folder_text.clone(), level, number });
            let stage = format!("merging parts to level {level}");
            self.sharing.ask_all::<Reply>(&stage, width, request, |number, loss| match loss {
                Loss::Memory { limit } => format!(
                    "merging to part {number} of level {level} needs more than {} of memory; merge fewer at once by --fan-in 2, or cut so that parts \
                     have smaller common boundaries: by --owners positions, or into fewer",
                    limit.map_or("all".to_owned(), bytes_text)
                ),
                loss => format!("part {number} of level {level} could not be merged: {loss}; {}", loss.cure()),
            })?;
        }
        Ok(())
    }

    fn is_root(&self, level: u32) -> Result<bool, Failure> {
        let request = |_| line(&Request::Look { folder: self.folder_text.clone(), level });
        let answers = self.sharing.ask_all::<Reply>("looking at what is left", 1, request, |_, loss| {
            format!("what is left could not be looked at: {loss}; {}", loss.cure())
        })?;
        match answers.first() {
            Some(Reply::Looked { is_root }) => Ok(*is_root),
            _ => Err(unexpected()),
        }
    }

    fn answer(&self, question: &Question) -> Result<Answer, Failure> {
        let request = Request::Answer {
            folder: self.folder_text.clone(),
            coefficients: question.coefficients.to_string(),
            cohomology: question.cohomology,
            generators: question.generators.is_some(),
        };
        let answers = self.sharing.ask_all::<Reply>(
            "asking what is left",
            1,
            |_| line(&request),
            |_, loss| format!("what is left could not be asked: {loss}; {}", loss.cure()),
        )?;
        match answers.into_iter().next() {
            Some(Reply::Answered { object, page }) => Ok(Answer { object: *object, page }),
            _ => Err(unexpected()),
        }
    }
}

/// What a worker replies to the line of a request.
pub(crate) fn answer_request(request: &str) -> String {
    reply_to(request, answered)
}

fn answered(request: Request) -> Result<Reply, Failure> {
    match request {
        Request::Shard(task) => shard(&task),
        Request::Reduce { folder, number } => {
            ShardFolder::open(Path::new(&folder))?.reduce(number, false)?;
            Ok(Reply::Done)
        }
        Request::Merge { folder, level, number } => {
            ShardFolder::open(Path::new(&folder))?.merge(level, number, false)?;
            Ok(Reply::Done)
        }
        Request::Look { folder, level } => {
            Ok(Reply::Looked { is_root: ShardFolder::open(Path::new(&folder))?.is_root(level)? })
        }
        Request::Answer { folder, coefficients, cohomology, generators } => {
            let folder = ShardFolder::open(Path::new(&folder))?;
            let question = Question {
                coefficients: crate::arguments::ring(&coefficients).map_err(Failure::new)?,
                cohomology,
                generators: generators.then_some(None),
            };
            let answer = Answer::of(&folder, &question, false)?;
            Ok(Reply::Answered { object: Box::new(answer.object), page: answer.page })
        }
    }
}

fn shard(task: &ShardTask) -> Result<Reply, Failure> {
    let cut = Cut {
        parts: task.parts.unwrap_or(0),
        fan_in: task.fan_in,
        owners: task.owners.as_ref().map(PathBuf::from),
        grid: GridArguments { grid: task.grid.clone(), simplicial: task.simplicial },
    };
    let format =
        task.format.as_deref().map(crate::arguments::format_of_name).transpose().map_err(Failure::new)?;
    let common = Common {
        json: true,
        quiet: true,
        memory: None,
        time_limit: None,
        threads: None,
        output: None,
        format,
        flatten: task.flatten,
        strict: task.strict,
        partial: task.partial,
        allow_outside: task.allow_outside,
        lod: task.lod,
        pseudomanifold: task.pseudomanifold,
        voxels: task.voxels.clone(),
        points: PointArguments::default(),
    };
    let progress = Progress::start(true);
    let asked = CutRequest {
        input: Path::new(&task.input),
        name: task.name.clone(),
        folder: Path::new(&task.folder),
        cut: &cut,
        memory: task.memory,
        replaces: false,
    };
    let shards = cut_input(&asked, &common, &progress)?;
    Ok(Reply::Sharded { parts: shards.manifest().part_count, fan_in: shards.manifest().fan_in })
}
