//! `coface shard`: a complex cut into files.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input::{self, Source};
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use crate::remarks::take;
use clap::{Args, ValueEnum};
use coface::algebra::escaped;
use coface::answers::answer::ShardAnswer;
use coface::io::{Structure, content_hash, format_of_path};
use coface::scale::shards::{
    GridSort, Owners, ShardFolder, ShardRequest, shard_grid, shard_mesh_file, shard_model, shard_volume,
    shard_volume_file,
};
use std::path::{Path, PathBuf};

/// Cut a model into shards: files that are reduced one by one and merged.
///
/// The folder of -o gets shards.json and part-000000.shard and so on. Then `coface reduce` works on each of them, on as many machines as
/// there are, and `coface merge` gives the homology of the whole. `coface homology --parts N` does all of this on one machine.
#[derive(Args)]
pub(crate) struct Shard {
    /// The model or volume; - is standard input
    #[arg(value_name = "INPUT", required_unless_present = "grid")]
    input: Option<PathBuf>,
    #[command(flatten)]
    pub(super) cut: Cut,
    /// Replace the shards of another complex in the folder
    #[arg(long)]
    force: bool,
}

/// How a complex is cut.
#[derive(Args, Clone)]
pub(crate) struct Cut {
    /// The number of shards
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(crate) parts: u32,
    /// How many neighbors are merged at once
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = clap::value_parser!(u32).range(2..=1_000_000))]
    pub(crate) fan_in: u32,
    /// Which shard each maximal cell goes to: by positions, by a walk through neighbors, at random, or the numbers in a text file, for the
    /// cells that are a face of no other, by rising degree, then by number [default: positions if there are any, else walk]
    #[arg(long, value_name = "positions|walk|random|FILE")]
    pub(crate) owners: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) grid: GridArguments,
}

/// Grids of voxels, and how voxels are cut.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct GridArguments {
    /// Instead of an input a grid of so many voxels along each axis, all of them set; --periodic closes axes. Only its description is
    /// stored
    #[arg(long, value_name = "N,N,..", value_delimiter = ',', conflicts_with_all = ["input", "owners"],
          value_parser = clap::value_parser!(u32).range(1..), help_heading = "Volumes")]
    pub(crate) grid: Option<Vec<u32>>,
    /// Cut the voxels of the grid, or of the volume, into simplices
    #[arg(long, help_heading = "Volumes")]
    pub(crate) simplicial: bool,
}

impl GridArguments {
    fn sort(&self) -> GridSort {
        if self.simplicial { GridSort::Simplices } else { GridSort::Cubes }
    }

    /// What the grid is called.
    fn name(&self) -> Option<String> {
        let lengths: Vec<String> = self.grid.as_ref()?.iter().map(u32::to_string).collect();
        Some(format!("grid of {} voxels", lengths.join(" x ")))
    }
}

/// The ways of cutting that have a name.
#[derive(Clone, Copy, ValueEnum)]
enum NamedOwners {
    Positions,
    Walk,
    Random,
}

impl Cut {
    /// What the library is asked for.
    fn request(&self, name: &str) -> Result<ShardRequest, Failure> {
        let mut request = ShardRequest::new(name, self.parts);
        request.fan_in = self.fan_in;
        request.owners = self.owners.as_deref().map_or(Ok(Owners::Automatic), owners)?;
        Ok(request)
    }
}

fn owners(how: &Path) -> Result<Owners, Failure> {
    let named = how.to_str().and_then(|name| NamedOwners::from_str(name, false).ok());
    match named {
        Some(NamedOwners::Positions) => return Ok(Owners::Positions),
        Some(NamedOwners::Walk) => return Ok(Owners::Walk),
        Some(NamedOwners::Random) => return Ok(Owners::Random),
        None => {}
    }
    let file = how.display();
    let text = std::fs::read_to_string(how).map_err(|error| {
        Failure::new(format!(
            "{file}: the list of owners cannot be read: {error}; name a file, or positions, walk or random"
        ))
    })?;
    let mut list = Vec::new();
    for (line, words) in (1..).zip(text.lines()) {
        for word in words.split_whitespace() {
            list.push(word.parse().map_err(|_| {
                let word: String = word.chars().take(40).collect();
                Failure::new(format!(
                    "{file}:{line}: \"{}\" is no number of a part; write numbers from 0 on",
                    word.escape_debug()
                ))
            })?);
        }
    }
    Ok(Owners::Listed(list))
}

/// Something that changes with the content of a file and how it is cut; nothing for what cannot be read twice.
pub(crate) fn fingerprint(input: &Path, cut: &Cut, common: &Common) -> String {
    let hash = |path: &Path| content_hash(path, &common.reading()).ok().map(|hash| format!("{hash:032x}"));
    let content = match cut.grid.name() {
        Some(name) => name,
        None => match hash(input) {
            Some(hash) => format!("{} {hash}", input.file_name().unwrap_or_default().display()),
            None => return String::new(),
        },
    };
    let owners = cut
        .owners
        .as_deref()
        .map_or_else(String::new, |how| hash(how).unwrap_or_else(|| how.display().to_string()));
    format!(
        "{content}, {} by {} {owners} {:?} {:?} {:?} {:?} {} {:?} {}",
        cut.parts,
        cut.fan_in,
        cut.grid.simplicial,
        common.format,
        common.flatten,
        common.voxels,
        common.partial,
        common.lod,
        common.pseudomanifold
    )
}

/// What is cut, and where to.
pub(crate) struct CutRequest<'a> {
    pub(crate) input: &'a Path,
    /// What the input is called, if not by its path.
    pub(crate) name: Option<String>,
    pub(crate) folder: &'a Path,
    pub(crate) cut: &'a Cut,
    /// The memory of a part, which decides their number if none is given.
    pub(crate) memory: Option<u64>,
    /// Whether shards of another complex are replaced.
    pub(crate) replaces: bool,
}

/// Cuts a grid, or what a path names, into shards in a folder: a mesh of simplices and a volume while they are read, anything else from
/// memory.
pub(crate) fn cut_input(
    asked: &CutRequest<'_>,
    common: &Common,
    progress: &Progress,
) -> Result<ShardFolder, Failure> {
    let CutRequest { input, folder, cut, .. } = *asked;
    let name = asked.name.clone().or_else(|| cut.grid.name()).unwrap_or_else(|| input::name(input));
    let (sort, reading) = (cut.grid.sort(), common.reading());
    let mut request = cut.request(&name)?;
    request.replaces = asked.replaces;
    request.allow_outside = common.allow_outside;
    request.part_memory = asked.memory;
    request.source.fingerprint = fingerprint(input, cut, common);
    if let Some(shape) = &cut.grid.grid {
        let is_periodic = reading.volume_reading().periodic_axes(shape.len())?;
        return Ok(shard_grid(sort, shape, &is_periodic, folder, &request)?);
    }
    let volumes_have_no_owners = || match cut.owners {
        None => Ok(()),
        Some(_) => Err(Failure::new(format!("{name}: volumes are cut into boxes; leave --owners away"))),
    };
    if input.is_file()
        && let Some(format) = Some(format_of_path(input, common.format)?).filter(|format| format.is_volume())
    {
        volumes_have_no_owners()?;
        progress.stage("cutting into shards");
        let (shards, remarks) =
            shard_volume_file(sort, input, format, reading.volume_reading(), folder, &request)?;
        take(&name, &remarks);
        return Ok(shards);
    }
    if input.is_file() && sort == GridSort::Cubes {
        progress.stage("cutting into shards");
        if let Some(shards) = shard_mesh_file(input, common.format, folder, &request)? {
            return Ok(shards);
        }
    }
    let loaded = Source::of(input)?.model(reading, progress)?;
    progress.stage("cutting into shards");
    if let Some(Structure::Volume(volume)) = loaded.model.structure() {
        volumes_have_no_owners()?;
        return Ok(shard_volume(sort, volume, folder, &request).map_err(|error| error.in_file(name))?);
    }
    if sort == GridSort::Simplices {
        return Err(Failure::new(format!(
            "{name}: --simplicial cuts voxels, and there are none; leave it away"
        )));
    }
    let shards = shard_model(loaded.model, folder, &request).map_err(|error| error.in_file(name.clone()))?;
    take(&name, &shards.manifest().source.remarks);
    Ok(shards)
}

impl Shard {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let Some(folder) = &common.output else {
            return Err(Failure::new("no folder for the shards: give -o FOLDER"));
        };
        common.points.refuse("shard")?;
        let progress = Progress::start(common.quiet);
        let asked = CutRequest {
            input: self.input.as_deref().unwrap_or(Path::new("")),
            name: None,
            folder,
            cut: &self.cut,
            memory: None,
            replaces: self.force,
        };
        let shards = cut_input(&asked, common, &progress)?;
        drop(progress);
        let manifest = shards.manifest();
        let sizes = (0..manifest.part_count)
            .map(|number| std::fs::metadata(shards.shard_path(number)).map_or(0, |file| file.len()));
        let (mut total, mut largest) = (0u64, 0);
        sizes.for_each(|size| (total, largest) = (total + size, largest.max(size)));
        if common.json {
            return print_json(&ShardAnswer {
                file: manifest.source.name.clone(),
                output: folder.display().to_string(),
                parts: manifest.part_count,
                fan_in: manifest.fan_in,
                bytes: total,
                largest,
                remarks: Vec::new(),
            });
        }
        print_text(&format!(
            "{} shards of {} in {}: {total} bytes, the largest {largest}\n",
            manifest.part_count,
            escaped(&manifest.source.name),
            escaped(&folder.display().to_string())
        ))
    }
}
