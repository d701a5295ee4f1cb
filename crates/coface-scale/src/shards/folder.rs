//! Shards as files of a folder.

use super::chains::{ShardChains, chains_below_merge, chains_on_cells, root_chains, sum_chains};
use super::manifest::ShardManifest;
use super::place::ShardPlace;
use super::reduced::{ReducedSummary, merge, reduce, root_homology, summary};
use coface_algebra::progress;
use coface_algebra::{Error, ErrorKind};
use coface_io::container::{Kind, checksum_of_header};
use coface_io::{FolderLock, MadeFolders, open_regular, replace_file};
use coface_topology::Homology;
use rayon::prelude::*;
use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// A folder with the shards of one complex and what is left of them: `shards.json`, `part-000007.shard`, `part-000007.reduced`,
/// `level-1-000000.reduced`.
///
/// Files appear whole or not at all, and are never changed: only replaced. A reduced shard that is whole, and made of what stands there, is not
/// made again, so that work that was cut off goes on where it ended.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_scale::shards::{ShardRequest, shard_model};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let folder = std::env::temp_dir().join("coface-shard-folder");
/// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
/// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
/// for number in 0..3 {
///     assert!(shards.reduce(number, false)?.is_new());
/// }
/// let found = shards.merge_all(false)?;
/// assert_eq!(found.homology().betti_numbers(), [1, 0, 1]);
/// assert_eq!(found.cells(), [4, 6, 4]);
/// assert!(!shards.reduce(0, false)?.is_new());
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct ShardFolder {
    path: PathBuf,
    manifest: ShardManifest,
    /// Nothing for a folder that was opened.
    writing: Option<Arc<Mutex<Writing>>>,
}

/// What is known of a folder whose shards are being written.
#[derive(Debug, Default)]
struct Writing {
    /// The shards that are there.
    written: Vec<u32>,
    _lock: Option<FolderLock>,
    /// Dropped after the lock, which is a file in them.
    _made: Option<MadeFolders>,
}

/// The lock of those who write shards.
const LOCK: &str = ".coface-shards.lock";

/// A reduced shard that is there.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ReducedStep {
    pub(crate) path: PathBuf,
    pub(crate) is_new: bool,
    pub(crate) summary: ReducedSummary,
}

impl ReducedStep {
    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Whether it was made now, and not found finished.
    pub fn is_new(&self) -> bool {
        self.is_new
    }

    /// Its counts.
    pub fn summary(&self) -> &ReducedSummary {
        &self.summary
    }
}

/// The reduced shards of one level together.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct FolderLevel {
    pub(crate) parts: u32,
    pub(crate) strata: u64,
    pub(crate) critical: Vec<u64>,
    pub(crate) bytes: u64,
    pub(crate) widest: usize,
}

impl FolderLevel {
    /// How many there are.
    pub fn parts(&self) -> u32 {
        self.parts
    }

    /// The strata before the level was reduced.
    pub fn strata(&self) -> u64 {
        self.strata
    }

    /// The critical cells in each degree.
    pub fn critical(&self) -> &[u64] {
        &self.critical
    }

    /// The bytes of all files: what is sent to the next level.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// The bits of the largest incidence.
    pub fn widest(&self) -> usize {
        self.widest
    }
}

impl FolderLevel {
    /// Critical cells for each stratum: 1 where all strata are balls.
    pub fn critical_per_stratum(&self) -> f64 {
        self.critical.iter().sum::<u64>() as f64 / self.strata.max(1) as f64
    }
}

/// What a merged folder says.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct FolderSummary {
    pub(crate) homology: Homology,
    pub(crate) cells: Vec<u64>,
    pub(crate) levels: Vec<FolderLevel>,
}

impl FolderSummary {
    /// The homology of the whole.
    pub fn homology(&self) -> &Homology {
        &self.homology
    }

    /// The number of cells of the whole in each degree.
    pub fn cells(&self) -> &[u64] {
        &self.cells
    }

    /// The levels, from the shards on.
    pub fn levels(&self) -> &[FolderLevel] {
        &self.levels
    }
}

/// The name of the file that lists the shards.
const MANIFEST: &str = "shards.json";

fn in_file(path: &Path) -> impl Fn(Error) -> Error + '_ {
    move |error| error.in_file(path.display().to_string())
}

/// The bytes of a shard or of a reduced one.
///
/// They are copied and not mapped: the folder is open to other programs, and a copy keeps its checksum whatever becomes of the file.
fn bytes_of(path: &Path) -> Result<Vec<u8>, Error> {
    let read = || {
        let mut bytes = Vec::new();
        // A folder of shards may come from elsewhere: a pipe in it is not waited for.
        open_regular(path)?.read_to_end(&mut bytes)?;
        Ok(bytes)
    };
    read().map_err(in_file(path))
}

/// The checksum that a container says it has.
fn stated_checksum(path: &Path, kind: Kind) -> Result<u64, Error> {
    let mut start = Vec::new();
    let file = open_regular(path)?;
    let length = file.metadata()?.len();
    file.take(64).read_to_end(&mut start)?;
    match checksum_of_header(&start, length)? {
        (found, checksum) if found == kind => Ok(checksum),
        (found, _) => Err(Error::invalid(format!("the file holds {}, not {}", found.title(), kind.title()))),
    }
}

/// Reduces the shard in a file to one beside it with the extension `reduced`, unless that is there, whole and made of this shard.
///
/// # Errors
/// As of [`reduce`]; [`ErrorKind::Io`] where files cannot be read or written. All name the file.
///
/// # Complexity
/// As of [`reduce`]; one look at every byte of what is finished.
///
/// # Examples
/// The boundary of a tetrahedron in three shards.
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_scale::shards::{ShardRequest, reduce_file, shard_model};
/// let folder = std::env::temp_dir().join("coface-shards-reduce-file");
/// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
/// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
/// assert!(reduce_file(&shards.shard_path(1), false)?.is_new());
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn reduce_file(shard: &Path, replaces: bool) -> Result<ReducedStep, Error> {
    if shard.extension().is_none_or(|extension| extension != "shard") {
        return Err(in_file(shard)(
            Error::invalid("a shard is a file whose name ends in .shard")
                .with_cure("name files that coface shard has made"),
        ));
    }
    let target = shard.with_extension("reduced");
    let source = || stated_checksum(shard, Kind::Shard);
    step(
        &target,
        replaces,
        |_| Ok(vec![source()?]),
        || {
            let bytes = bytes_of(shard)?;
            reduce(&bytes).map_err(in_file(shard))
        },
    )
}

/// Makes a reduced shard unless it is there, whole and made of the sources.
fn step(
    target: &Path,
    replaces: bool,
    sources: impl Fn(&ReducedSummary) -> Result<Vec<u64>, Error>,
    make: impl FnOnce() -> Result<Vec<u8>, Error>,
) -> Result<ReducedStep, Error> {
    let finished = (!replaces && target.exists()).then(|| summary(&bytes_of(target)?)).and_then(Result::ok);
    if let Some(summary) = finished
        && sources(&summary).is_ok_and(|sources| sources == summary.sources)
    {
        return Ok(ReducedStep { path: target.to_path_buf(), is_new: false, summary });
    }
    let bytes = make()?;
    replace_file(target, |out| Ok(out.write_all(&bytes)?))?;
    Ok(ReducedStep { path: target.to_path_buf(), is_new: true, summary: summary(&bytes)? })
}

impl ShardFolder {
    /// The folder with the shards of this manifest, made if it is not there. The manifest is written by [`finish`](Self::finish), after the shards.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] where the shards of another complex stand there and are not to be replaced;
    /// [`ErrorKind::Io`], also while another run writes shards there.
    pub fn create(path: &Path, manifest: ShardManifest, replaces: bool) -> Result<Self, Error> {
        ShardPlace::new(manifest.complex, manifest.part_count, manifest.fan_in, 0)?;
        let (made, lock) = MadeFolders::with(path, |path| FolderLock::take(path, LOCK))?;
        let list = path.join(MANIFEST);
        let is_same = |other: &ShardManifest| {
            (other.complex, other.part_count, other.fan_in)
                == (manifest.complex, manifest.part_count, manifest.fan_in)
        };
        if list.exists() {
            let other = read_manifest(&list);
            if !replaces && !other.as_ref().is_ok_and(is_same) {
                return Err(in_file(path)(
                    Error::invalid("the folder has the shards of another complex, or cut in another way")
                        .with_cure("name an empty folder, or replace them by coface shard --force"),
                ));
            }
            // While shards are replaced they must not be merged.
            fs::remove_file(&list).map_err(|error| in_file(&list)(error.into()))?;
        }
        let writing = Writing { written: Vec::new(), _lock: Some(lock), _made: Some(made) };
        Ok(Self { path: path.to_path_buf(), manifest, writing: Some(Arc::new(Mutex::new(writing))) })
    }

    /// Says that all shards are written.
    ///
    /// # Errors
    /// [`ErrorKind::Io`].
    pub fn finish(&self) -> Result<(), Error> {
        replace_file(
            &self.path.join(MANIFEST),
            |out| Ok(out.write_all(self.manifest.to_json().as_bytes())?),
        )?;
        if let Some(writing) = &self.writing {
            *writing.lock().unwrap_or_else(PoisonError::into_inner) = Writing::default();
        }
        Ok(())
    }

    /// Has all shards written, and says that they are; when that fails, those that were written are removed, and the
    /// folder if it was made for them.
    pub(super) fn finished(self, write: impl FnOnce(&Self) -> Result<(), Error>) -> Result<Self, Error> {
        let failed = match write(&self).and_then(|()| self.finish()) {
            Ok(()) => return Ok(self),
            Err(error) => error,
        };
        if let Some(writing) = &self.writing {
            let mut writing = writing.lock().unwrap_or_else(PoisonError::into_inner);
            for number in writing.written.drain(..) {
                // What cannot be removed is replaced by the next run.
                let _ = fs::remove_file(self.shard_path(number));
            }
        }
        Err(failed)
    }

    /// The folder at this path.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] where there is none, or none with a list of shards; [`ErrorKind::Parse`] for a list that is none.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardFolder, ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-open");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// assert_eq!(ShardFolder::open(&folder)?.manifest().part_count, 3);
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn open(path: &Path) -> Result<Self, Error> {
        let list = path.join(MANIFEST);
        if !list.exists() {
            return Err(in_file(path)(
                Error::new(ErrorKind::Io, "is no folder of shards: it has no shards.json")
                    .with_cure("make one by coface shard INPUT -o FOLDER --parts N"),
            ));
        }
        Ok(Self { path: path.to_path_buf(), manifest: read_manifest(&list)?, writing: None })
    }

    /// The path.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-path");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// assert_eq!(shards.path(), folder);
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// What the shards are.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-manifest");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// assert_eq!(shards.manifest().part_count, 3);
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn manifest(&self) -> &ShardManifest {
        &self.manifest
    }

    /// The place of a shard or of what is left of some.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-place");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// assert_eq!(shards.place(0, 2).number, 2);
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn place(&self, level: u32, number: u32) -> ShardPlace {
        let ShardManifest { complex, part_count, fan_in, .. } = self.manifest;
        ShardPlace { complex, part_count, fan_in, level, number }
    }

    /// The file of a shard.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-shard-path");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// assert_eq!(shards.shard_path(2), folder.join("part-000002.shard"));
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn shard_path(&self, number: u32) -> PathBuf {
        self.path.join(format!("part-{number:06}.shard"))
    }

    /// The file of a reduced shard.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-reduced-path");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// assert_eq!(shards.reduced_path(1, 0), folder.join("level-1-000000.reduced"));
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn reduced_path(&self, level: u32, number: u32) -> PathBuf {
        self.path.join(match level {
            0 => format!("part-{number:06}.reduced"),
            level => format!("level-{level}-{number:06}.reduced"),
        })
    }

    /// Writes a shard.
    pub(super) fn write_shard(
        &self,
        number: u32,
        write: impl FnOnce(&mut dyn Write) -> Result<(), Error>,
    ) -> Result<(), Error> {
        replace_file(&self.shard_path(number), write)?;
        if let Some(writing) = &self.writing {
            writing.lock().unwrap_or_else(PoisonError::into_inner).written.push(number);
        }
        Ok(())
    }

    /// Reduces a shard, as [`reduce_file`] does.
    ///
    /// # Errors
    /// As of [`reduce_file`]; [`ErrorKind::InvalidInput`] for a shard of another complex.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-reduce");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// assert!(shards.reduce(0, false)?.is_new() && !shards.reduce(0, false)?.is_new());
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn reduce(&self, number: u32, replaces: bool) -> Result<ReducedStep, Error> {
        let step = reduce_file(&self.shard_path(number), replaces)?;
        self.check(&step, self.place(0, number))?;
        Ok(step)
    }

    /// Merges what is left of the level below to the reduced shard of a place, unless that is there, whole and made of these.
    ///
    /// # Errors
    /// As of [`merge`]; [`ErrorKind::Io`] where files cannot be read or written. All name a file.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-merge");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// (0..3).try_for_each(|number| shards.reduce(number, false).map(|_| ()))?;
    /// assert!(shards.merge(1, 0, false)?.summary().is_root());
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn merge(&self, level: u32, number: u32, replaces: bool) -> Result<ReducedStep, Error> {
        let place = self.place(level, number);
        let below = level.saturating_sub(1);
        let children: Vec<PathBuf> = place.children().map(|child| self.reduced_path(below, child)).collect();
        let target = self.reduced_path(level, number);
        let sources =
            |_: &ReducedSummary| children.iter().map(|path| stated_checksum(path, Kind::Reduced)).collect();
        let step = step(&target, replaces, sources, || {
            let bytes = children.iter().map(|path| bytes_of(path)).collect::<Result<Vec<_>, _>>()?;
            merge(place, &bytes).map_err(in_file(&self.path))
        })?;
        self.check(&step, place)?;
        Ok(step)
    }

    fn check(&self, step: &ReducedStep, place: ShardPlace) -> Result<(), Error> {
        if step.summary.place == place {
            return Ok(());
        }
        let found = step.summary.place;
        let what = if found.complex == place.complex {
            "has another place than its name"
        } else {
            "is of another complex than shards.json"
        };
        Err(in_file(&step.path)(Error::invalid(format!("{} {what} says", found.name())).with_cure(
            match place.level {
                0 => format!(
                    "shard the complex again into the folder, then coface reduce {}",
                    self.shard_path(place.number).display()
                ),
                _ => "remove it and merge again".to_owned(),
            },
        )))
    }

    /// The reduced shards of level 0, of which all must be there and made of the shards that stand there, if these still do.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming those that are missing, with the command that makes them; [`ErrorKind::Parse`] for a damaged one.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-reduced-shards");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// (0..3).try_for_each(|number| shards.reduce(number, false).map(|_| ()))?;
    /// assert_eq!(shards.reduced_shards()?.len(), 3);
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn reduced_shards(&self) -> Result<Vec<ReducedStep>, Error> {
        // A list may say more parts than any folder has files: only those that are there are looked at.
        let numbers = self.reduced_numbers()?;
        let steps = progress::stage("looking at reduced parts", numbers.len());
        let found: Vec<Option<ReducedStep>> = numbers
            .par_iter()
            .map(|&number| {
                steps.advance(1);
                let (shard, path) = (self.shard_path(number), self.reduced_path(0, number));
                let summary = summary(&bytes_of(&path)?).map_err(|error| {
                    in_file(&path)(error.with_cure(format!("coface reduce {}", shard.display())))
                })?;
                let step = ReducedStep { path, is_new: false, summary };
                self.check(&step, self.place(0, number))?;
                let is_current = !shard.exists()
                    || stated_checksum(&shard, Kind::Shard)
                        .is_ok_and(|checksum| step.summary.sources == [checksum]);
                Ok(is_current.then_some(step))
            })
            .collect::<Result<_, Error>>()?;
        let current: Vec<u32> = numbers
            .iter()
            .zip(&found)
            .filter(|(_, step)| step.is_some())
            .map(|(&number, _)| number)
            .collect();
        let missing_count = self.manifest.part_count as usize - current.len();
        if missing_count == 0 {
            return Ok(found.into_iter().flatten().collect());
        }
        let missing = (0..self.manifest.part_count).filter(|number| current.binary_search(number).is_err());
        let some: Vec<String> =
            missing.take(3).map(|number| self.shard_path(number).display().to_string()).collect();
        let more = if missing_count > 3 { " ..." } else { "" };
        Err(in_file(&self.path)(
            Error::invalid(format!(
                "{} of {} parts are not reduced, or not from the shards that stand there",
                missing_count, self.manifest.part_count
            ))
            .with_cure(format!("coface reduce {}{more}", some.join(" "))),
        ))
    }

    /// The numbers of the reduced shards of the first level that are there, rising.
    fn reduced_numbers(&self) -> Result<Vec<u32>, Error> {
        let mut numbers = Vec::new();
        for entry in fs::read_dir(&self.path).map_err(|error| in_file(&self.path)(error.into()))? {
            let name = entry.map_err(|error| in_file(&self.path)(error.into()))?.file_name();
            let digits = name.to_str().and_then(|name| name.strip_prefix("part-")?.strip_suffix(".reduced"));
            let number = digits.and_then(|digits| digits.parse().ok());
            numbers.extend(number.filter(|&number| {
                number < self.manifest.part_count && self.reduced_path(0, number).file_name() == Some(&name)
            }));
        }
        numbers.sort_unstable();
        Ok(numbers)
    }

    /// Merges all levels, as far as they are not merged, and says what the whole is.
    ///
    /// # Errors
    /// As of [`reduced_shards`](Self::reduced_shards) and [`merge`](Self::merge).
    ///
    /// # Complexity
    /// That of the merges, in parallel within a level.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-merge-all");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// (0..3).try_for_each(|number| shards.reduce(number, false).map(|_| ()))?;
    /// assert_eq!(shards.merge_all(false)?.homology().betti_numbers(), [1, 0, 1]);
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn merge_all(&self, replaces: bool) -> Result<FolderSummary, Error> {
        self.merge_all_by(|level, number| self.merge(level, number, replaces))
    }

    /// The same with the merges that a function makes, in parallel within a level.
    ///
    /// # Errors
    /// As of [`merge_all`](Self::merge_all); those of `merge`.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-merge-all-by");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// (0..3).try_for_each(|number| shards.reduce(number, false).map(|_| ()))?;
    /// let found = shards.merge_all_by(|level, number| shards.merge(level, number, false))?;
    /// assert_eq!(found.cells(), [4, 6, 4]);
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn merge_all_by(
        &self,
        merge: impl Fn(u32, u32) -> Result<ReducedStep, Error> + Sync,
    ) -> Result<FolderSummary, Error> {
        let mut steps = self.reduced_shards()?;
        let mut levels = Vec::new();
        loop {
            levels.push(level_of(&steps));
            if let [step] = &steps[..]
                && step.summary.is_root
            {
                let homology = root_homology(&bytes_of(&step.path)?).map_err(in_file(&step.path))?;
                return Ok(FolderSummary { homology, cells: step.summary.cells.clone(), levels });
            }
            let level = levels.len() as u32;
            let width = self.place(level, 0).width(level);
            let counted = progress::stage(&format!("merging parts to level {level}"), width as usize);
            let merged = (0..width).into_par_iter().map(|number| {
                let step = merge(level, number);
                counted.advance(1);
                step
            });
            steps = merged.collect::<Result<_, Error>>()?;
        }
    }

    /// Whether the first reduced shard of a level is the root.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] where it is not there; [`ErrorKind::Parse`] for any damage.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-is-root");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// (0..3).try_for_each(|number| shards.reduce(number, false).map(|_| ()))?;
    /// shards.merge_all(false)?;
    /// assert!(shards.is_root(1)?);
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn is_root(&self, level: u32) -> Result<bool, Error> {
        let path = self.reduced_path(level, 0);
        Ok(summary(&bytes_of(&path)?).map_err(in_file(&path))?.is_root)
    }

    /// Cycles on the cells of the complex that generate its homology, from a folder that is merged.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] where a shard or a reduced one is missing, naming it; as of [`chains_below_merge`] and [`chains_on_cells`].
    ///
    /// # Complexity
    /// Matchings are made once more for the parts that a cycle meets.
    ///
    /// # Examples
    /// The boundary of a tetrahedron in three shards.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_scale::shards::{ShardRequest, shard_model};
    /// let folder = std::env::temp_dir().join("coface-shards-generators");
    /// let model = io::read(&b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]"[..], Format::Json)?;
    /// let shards = shard_model(model, &folder, &ShardRequest::new("sphere", 3))?;
    /// (0..3).try_for_each(|number| shards.reduce(number, false).map(|_| ()))?;
    /// shards.merge_all(false)?;
    /// assert_eq!(shards.generators()?.degrees[2][0].terms.len(), 4);
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn generators(&self) -> Result<ShardChains, Error> {
        let mut level = 0;
        while !self.is_root(level)? {
            level += 1;
        }
        let root = self.reduced_path(level, 0);
        let mut chains = root_chains(&bytes_of(&root)?).map_err(in_file(&root))?;
        for level in (1..=level).rev() {
            let width = self.place(level, 0).width(level);
            let pieces = (0..width).into_par_iter().map(|number| {
                let place = self.place(level, number);
                let children = place.children().map(|child| bytes_of(&self.reduced_path(level - 1, child)));
                let children = children.collect::<Result<Vec<_>, _>>()?;
                chains_below_merge(place, &children, &chains).map_err(in_file(&self.path))
            });
            chains = sum_chains(&pieces.collect::<Result<Vec<_>, Error>>()?)?;
        }
        let mut sum: Option<Vec<u8>> = None;
        let steps = progress::stage("taking chains down", self.manifest.part_count as usize);
        for number in 0..self.manifest.part_count {
            let path = self.shard_path(number);
            let piece = chains_on_cells(&bytes_of(&path)?, &chains).map_err(in_file(&path))?;
            sum = Some(match sum {
                Some(sum) => sum_chains(&[sum, piece])?,
                None => piece,
            });
            steps.advance(1);
        }
        ShardChains::from_bytes(&sum.expect("there is one part at least"))
    }
}

fn read_manifest(list: &Path) -> Result<ShardManifest, Error> {
    let text = String::from_utf8(bytes_of(list)?);
    let text = text.map_err(|_| in_file(list)(Error::parse("the list of shards is no text")))?;
    ShardManifest::from_json(&text).map_err(in_file(list))
}

fn level_of(steps: &[ReducedStep]) -> FolderLevel {
    let mut level =
        FolderLevel { parts: steps.len() as u32, strata: 0, critical: Vec::new(), bytes: 0, widest: 0 };
    for ReducedStep { summary, .. } in steps {
        level.strata += summary.strata;
        level.bytes += summary.bytes;
        level.widest = level.widest.max(summary.widest);
        level.critical.resize(level.critical.len().max(summary.critical.len()), 0);
        level.critical.iter_mut().zip(&summary.critical).for_each(|(sum, x)| *sum += x);
    }
    level
}
