//! `coface persistence --parts`: an image cut into blocks, which worker processes of limited memory reduce and merge.
//!
//! The process that was called reads the header of the volume, and at the end the pairs: it hands out requests, one a line.

use super::image::{ImageArguments, stream};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input::{self, Source};
use crate::progress::Progress;
use crate::remarks;
use crate::workers::{Sharing, Task, WorkFolder, WorkerReply, line, reply_to, text_of_path};
use clap::Args;
use coface::answers::FoundImage;
use coface::io::{self, ReadOptions, Structure, VolumeStream, content_hash, replace_file};
use coface::scale::shards::ImageFolder;
use coface::scale::workers::{Loss, bytes_text};
use coface::topology::{Coefficients, ImageBlocks};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Work in parts.
#[derive(Args)]
pub(crate) struct ImageParts {
    /// Cut an image into N blocks or a few more that are reduced by worker processes and merged, so that it may be larger than memory; --memory is that of all
    /// workers together [default with --work: blocks of some two million voxels, or as small as --memory asks for]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000), help_heading = "In parts")]
    parts: Option<u32>,
    /// Keep what is left of blocks in this folder, and go on with what is finished there
    #[arg(long, value_name = "FOLDER", help_heading = "In parts")]
    work: Option<PathBuf>,
    /// How many neighbors are merged at once
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = clap::value_parser!(u32).range(2..=1_000_000), help_heading = "In parts")]
    fan_in: u32,
}

/// So many voxels a block, if nothing asks for others.
const USUAL: usize = 1 << 21;

/// What is asked of an image in parts.
pub(super) struct Asked<'a> {
    pub(super) input: &'a Path,
    pub(super) image: &'a ImageArguments,
    pub(super) coefficients: Coefficients,
    pub(super) min_persistence: f64,
}

/// How a volume is cut, and where its numbers and its parts are.
#[derive(Clone, Serialize, Deserialize)]
struct ImageTask {
    folder: String,
    /// The name of the input in messages.
    name: String,
    volume: String,
    format: Option<String>,
    allow_outside: bool,
    /// Whether the first axis of the input runs fastest; its axes are numbered so in messages.
    is_first_fastest: bool,
    /// The cut as numbers.
    cut: Vec<u64>,
    fan_in: u32,
    is_superlevel: bool,
}

/// What a worker is asked, a line each.
#[derive(Serialize, Deserialize)]
enum Request {
    /// Make the part of a block.
    Block { task: ImageTask, number: u32 },
    /// Merge parts to one of this level.
    Merge { task: ImageTask, level: u32, number: u32 },
}

/// What a worker replies, a line each.
#[derive(Serialize, Deserialize)]
enum Reply {
    Done,
    Error(String),
}

impl WorkerReply for Reply {
    fn of_error(message: String) -> Self {
        Self::Error(message)
    }

    fn error(&self) -> Option<&str> {
        match self {
            Self::Error(message) => Some(message),
            Self::Done => None,
        }
    }
}

impl ImageParts {
    /// Whether work in parts is asked for.
    pub(crate) fn are_given(&self) -> bool {
        self.parts.is_some() || self.work.is_some()
    }

    /// Finds the diagram of an image.
    pub(super) fn found(
        &self,
        asked: &Asked<'_>,
        common: &Common,
        progress: &Progress,
    ) -> Result<FoundImage, Failure> {
        let memory = common.memory.and_then(|limit| limit.0);
        let sharing = Sharing::new(Task::Images, common.threads, memory)?;
        let name = input::name(asked.input);
        let work = WorkFolder::new(self.work.as_deref())?;
        let volume = work.standard_input(asked.input)?;
        let source = Source::of(&volume)?;
        let Some((_, stream)) = stream(&source, common)? else {
            return Err(Failure::new(format!(
                "{name}: --parts and --work are for the values of a volume (.npy, NRRD, NIfTI, MetaImage, PGM, PNG), and this is none; leave --parts and --work out"
            )));
        };
        let is_first_fastest = stream.shape().len() > 1 && stream.fastest_axis() == 0;
        let blocks = self.blocks(asked, common, &stream, &sharing)?;
        let mut task = ImageTask {
            folder: text_of_path(work.path())?,
            name: name.clone(),
            volume: text_of_path(&volume)?,
            format: common.format.map(|format| format.name().to_owned()),
            allow_outside: common.allow_outside,
            is_first_fastest,
            cut: blocks.to_words(),
            fan_in: self.fan_in,
            is_superlevel: asked.image.is_superlevel(),
        };
        if !self.reads_in_place(asked, &name, stream)? {
            task.volume = text_of_path(&self.copied(asked, common, (&volume, work.path()), progress)?)?;
            task.format = None;
        }
        let folder = ImageFolder::new(work.path(), blocks, self.fan_in)?;
        Self::reduced(&task, &folder, &sharing)?;
        progress.stage("collecting pairs");
        let diagram = folder.diagram()?;
        drop(work);
        let is_periodic = common.voxels.periodic().contains(&true);
        let construction = asked.image.construction();
        let found = FoundImage::of_diagram(&name, construction, &diagram, is_periodic, asked.min_persistence);
        Ok(if is_first_fastest { found.first_fastest() } else { found })
    }

    /// How the image is cut; its axes are those of the file from the slowest one on.
    fn blocks(
        &self,
        asked: &Asked<'_>,
        common: &Common,
        stream: &VolumeStream<'_>,
        sharing: &Sharing,
    ) -> Result<ImageBlocks, Failure> {
        let mut shape: Vec<usize> = stream.shape().iter().map(|&length| length as usize).collect();
        let mut is_periodic = common.voxels.reading().periodic_axes(shape.len())?;
        if stream.fastest_axis() == 0 {
            shape.reverse();
            is_periodic.reverse();
        }
        let cut = |count: u32| -> Result<ImageBlocks, Failure> {
            let blocks = ImageBlocks::at_least(&shape, count)
                .and_then(|blocks| blocks.periodic(&is_periodic))
                .and_then(|blocks| blocks.coefficients(asked.coefficients));
            let blocks = blocks.map_err(|error| error.in_file(input::name(asked.input)))?;
            let blocks = blocks.construction(asked.image.construction());
            Ok(blocks.superlevel(asked.image.is_superlevel()))
        };
        if let Some(count) = self.parts {
            return cut(count);
        }
        let voxels: usize = shape.iter().product();
        let mut blocks = cut(voxels.div_ceil(USUAL).clamp(1, 1_000_000) as u32)?;
        // Numbers are held beside the matching, and critical cells.
        let fits =
            |blocks: &ImageBlocks, memory: u64| blocks.bytes() / 2 * 3 <= memory / sharing.workers as u64;
        while let Some(memory) = sharing.memory
            && !fits(&blocks, memory)
            && blocks.count() < 500_000
        {
            let finer = cut(blocks.count() * 2)?;
            if finer.count() == blocks.count() {
                break;
            }
            blocks = finer;
        }
        Ok(blocks)
    }

    /// Whether windows are read from the file as it is; says what was assumed of it then.
    fn reads_in_place(
        &self,
        asked: &Asked<'_>,
        name: &str,
        stream: VolumeStream<'_>,
    ) -> Result<bool, Failure> {
        if asked.image.mask().is_some() {
            return Ok(false);
        }
        let windows = stream.windows()?;
        if let Some(windows) = &windows {
            remarks::take(name, windows.remarks());
        }
        Ok(windows.is_some())
    }

    /// A copy of the numbers in the work folder, with those that the mask leaves out made no numbers. One that is finished there is taken again.
    fn copied(
        &self,
        asked: &Asked<'_>,
        common: &Common,
        (volume, folder): (&Path, &Path),
        progress: &Progress,
    ) -> Result<PathBuf, Failure> {
        let name = input::name(asked.input);
        let (copy, note) = (folder.join("volume.npy"), folder.join("volume.txt"));
        let mut content = String::new();
        if self.work.is_some() {
            progress.stage("looking at the file");
            let files = [Some(volume), asked.image.mask()];
            for file in files.into_iter().flatten() {
                content += &format!("{:032x} ", content_hash(file, &common.reading())?);
            }
            content += &format!("{:?}\n", common.format);
            if copy.exists() && std::fs::read_to_string(&note).is_ok_and(|text| text == content) {
                return Ok(copy);
            }
        }
        let mask =
            asked.image.mask().map(|path| input::read(path, common.reading(), progress)).transpose()?;
        let mask_name = asked.image.mask().map(input::name).unwrap_or_default();
        let mask = match mask.as_ref().map(|mask| mask.model.structure()) {
            None => None,
            Some(Some(Structure::Volume(mask))) => Some(mask),
            Some(_) => return Err(ImageArguments::no_mask(&mask_name)),
        };
        progress.stage(format!("copying {name}"));
        let gone = || Failure::new(format!("{name}: the file was changed meanwhile; run the command again"));
        // Its header has been read before, with what is to be said of it.
        let (stream, _) = io::volume_of_path(volume, &common.reading())?.ok_or_else(gone)?;
        if let Some(mask) = mask.filter(|mask| mask.shape() != stream.shape()) {
            return Err(Failure::new(format!(
                "{mask_name}: the mask has the shape {:?}, and the image {:?}; give a mask of the shape of the image",
                mask.shape(),
                stream.shape()
            )));
        }
        let mut said = Vec::new();
        replace_file(&copy, |mut out| {
            said = stream.copy(&mut out, mask).map_err(|error| error.in_file(name.clone()))?;
            Ok(())
        })?;
        remarks::take(&name, &said);
        if self.work.is_some() {
            replace_file(&note, |out| Ok(out.write_all(content.as_bytes())?))?;
        }
        Ok(copy)
    }

    /// Has all parts made and merged.
    fn reduced(task: &ImageTask, folder: &ImageFolder, sharing: &Sharing) -> Result<(), Failure> {
        let count = folder.width(0);
        let allowed = |limit: Option<u64>| limit.map_or("all".to_owned(), bytes_text);
        let request = |number: u32| line(&Request::Block { task: task.clone(), number });
        sharing.ask_all::<Reply>("reducing blocks", count, request, |number, loss| match loss {
            Loss::Memory { limit } => format!(
                "block {number} of {count} needs more than {} of memory; cut into more by --parts {}, or allow more by --memory",
                allowed(limit),
                u64::from(count) * 2
            ),
            loss => format!("block {number} of {count} could not be reduced: {loss}; {}", loss.cure()),
        })?;
        for level in 1.. {
            if folder.width(level - 1) == 1 {
                break;
            }
            let request = |number: u32| line(&Request::Merge { task: task.clone(), level, number });
            let stage = format!("merging blocks to level {level}");
            sharing.ask_all::<Reply>(&stage, folder.width(level), request, |number, loss| match loss {
                Loss::Memory { limit } => format!(
                    "merging blocks to part {number} of level {level} needs more than {} of memory; merge fewer at once by --fan-in 2, or allow more by --memory",
                    allowed(limit)
                ),
                loss => format!("part {number} of level {level} could not be merged: {loss}; {}", loss.cure()),
            })?;
        }
        Ok(())
    }
}

/// What a worker replies to the line of a request.
pub(crate) fn answer_request(request: &str) -> String {
    reply_to(request, answered)
}

fn answered(request: Request) -> Result<Reply, Failure> {
    match request {
        Request::Block { task, number } => {
            let folder = task.image_folder()?;
            let numbers = task.window(folder.blocks(), number)?;
            folder.block(number, &numbers)?;
        }
        Request::Merge { task, level, number } => {
            task.image_folder()?.merge(level, number)?;
        }
    }
    Ok(Reply::Done)
}

impl ImageTask {
    fn image_folder(&self) -> Result<ImageFolder, Failure> {
        let blocks = ImageBlocks::of_words(&mut &self.cut[..])
            .ok_or_else(|| Failure::new("a worker was asked about an image that there is none of"))?;
        Ok(ImageFolder::new(Path::new(&self.folder), blocks, self.fan_in)?)
    }

    /// The numbers of the window of a block.
    fn window(&self, blocks: &ImageBlocks, number: u32) -> Result<Vec<f64>, Failure> {
        let format = self.format.as_deref().map(crate::arguments::format_of_name);
        let format = format.transpose().map_err(Failure::new)?;
        let options = ReadOptions::new().format(format).allow_outside(self.allow_outside);
        let changed = || {
            Failure::new(format!("{}: the file was changed meanwhile; run the command again", self.volume))
        };
        let (stream, _) = io::volume_of_path(&self.volume, &options)?.ok_or_else(changed)?;
        let mut windows = stream.windows()?.ok_or_else(changed)?;
        let window = blocks.window(number);
        let numbers = windows.numbers(&window)?;
        let from = if self.is_superlevel { f64::INFINITY } else { f64::NEG_INFINITY };
        if let Some(place) = numbers.iter().position(|&number| number == from) {
            let mut rest = place;
            let mut voxel: Vec<usize> = Vec::new();
            for along in window.iter().rev() {
                voxel.push(along[rest % along.len()]);
                rest /= along.len();
            }
            if !self.is_first_fastest {
                voxel.reverse();
            }
            return Err(Failure::new(format!(
                "{}: voxel {voxel:?} is at {from}, so classes would be born at infinity; write a finite number there, or NaN if the voxel is outside",
                self.name
            )));
        }
        Ok(numbers)
    }
}
