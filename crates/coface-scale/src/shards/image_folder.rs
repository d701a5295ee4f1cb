//! Parts of an image as files of a folder.

use super::images::{image_part_of, open_image_part, window_checksum};
use super::place::ShardPlace;
use coface_algebra::Error;
use coface_algebra::progress;
use coface_io::container::{Container, ContainerWriter, Kind, Role};
use coface_io::{open_regular, replace_file};
use coface_topology::{ImageBlocks, ImageDiagram, ImagePart};
use std::io::Read;
use std::path::{Path, PathBuf};

/// A folder with what is left of the blocks of an image: `block-000007.part`, `blocks-1-000000.part` for eight of them merged, and beside each a file
/// `.pairs` with the pairs that were found there, which need not be merged.
///
/// Files appear whole or not at all. A part that is whole, and made of the same numbers and options, is not made again, so that work that was cut off goes on
/// where it ended.
///
/// # Examples
/// Two valleys with a pass between them.
/// ```
/// use coface_scale::shards::ImageFolder;
/// use coface_topology::ImageBlocks;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-image-folder");
/// std::fs::create_dir_all(&path)?;
/// let folder = ImageFolder::new(&path, ImageBlocks::new(&[4], &[2])?, 8)?;
/// assert!(folder.block(0, &[0.0, 5.0, 1.0])?);
/// assert!(folder.block(1, &[5.0, 1.0, 2.0])?);
/// // Nothing is made twice.
/// assert!(!folder.block(1, &[5.0, 1.0, 2.0])?);
/// assert_eq!(folder.width(1), 1);
/// assert!(folder.merge(1, 0)?);
/// let diagram = folder.diagram()?;
/// assert_eq!((diagram.pairs()[1].birth(), diagram.pairs()[1].death()), (1.0, Some(5.0)));
/// # std::fs::remove_dir_all(&path)?;
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct ImageFolder {
    path: PathBuf,
    blocks: ImageBlocks,
    tree: ShardPlace,
}

impl ImageFolder {
    /// The folder at this path, which is there, with the parts of an image that is cut so; `fan_in` neighbors are merged at once.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a `fan_in` below 2.
    ///
    /// # Examples
    /// See [`ImageFolder`].
    pub fn new(path: &Path, blocks: ImageBlocks, fan_in: u32) -> Result<Self, Error> {
        let tree = ShardPlace::new(0, blocks.count(), fan_in, 0)?;
        Ok(Self { path: path.to_path_buf(), blocks, tree })
    }

    /// How the image is cut.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::shards::ImageFolder;
    /// use coface_topology::ImageBlocks;
    /// let folder = ImageFolder::new(".".as_ref(), ImageBlocks::new(&[4], &[2])?, 8)?;
    /// assert_eq!(folder.blocks().count(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn blocks(&self) -> &ImageBlocks {
        &self.blocks
    }

    /// How many parts a level has: level 0 has the blocks, and of the last level, which has one part, comes the diagram.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::shards::ImageFolder;
    /// use coface_topology::ImageBlocks;
    /// let folder = ImageFolder::new(".".as_ref(), ImageBlocks::new(&[10], &[1])?, 4)?;
    /// assert_eq!([0, 1, 2].map(|level| folder.width(level)), [10, 3, 1]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn width(&self, level: u32) -> u32 {
        self.tree.width(level)
    }

    /// The level of the part of all blocks.
    fn last_level(&self) -> u32 {
        (0..).find(|&level| self.width(level) == 1).unwrap_or_default()
    }

    fn part_path(&self, level: u32, number: u32) -> PathBuf {
        self.path.join(match level {
            0 => format!("block-{number:06}.part"),
            level => format!("blocks-{level}-{number:06}.part"),
        })
    }

    /// Makes the part of a block from the numbers of its window, unless it is there; whether it is new.
    ///
    /// # Errors
    /// Those of [`ImageBlocks::part`]; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io).
    ///
    /// # Panics
    /// If there is no such block.
    ///
    /// # Complexity
    /// That of [`ImageBlocks::part`].
    ///
    /// # Examples
    /// See [`ImageFolder`].
    pub fn block(&self, number: u32, numbers: &[f64]) -> Result<bool, Error> {
        let target = self.part_path(0, number);
        let sources = [window_checksum(&self.blocks, number, numbers)];
        if is_finished(&target, &sources) {
            return Ok(false);
        }
        write(&target, self.blocks.part(number, numbers.iter().copied())?, &sources)?;
        Ok(true)
    }

    /// Merges neighbors to a part of this level, from 1 on, unless it is there; whether it is new.
    ///
    /// # Errors
    /// Those of [`ImagePart::merged`]; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) where a part is missing, [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for
    /// any damage, naming the file.
    ///
    /// # Complexity
    /// That of [`ImagePart::merged`].
    ///
    /// # Examples
    /// See [`ImageFolder`].
    pub fn merge(&self, level: u32, number: u32) -> Result<bool, Error> {
        let target = self.part_path(level, number);
        let (mut parts, mut sources) = (Vec::new(), Vec::new());
        for child in self.tree.at(level, number).children() {
            let path = self.part_path(level - 1, child);
            let (part, checksum, _) = open_image_part(&bytes_of(&path)?).map_err(in_file(&path))?;
            if *part.cut() != self.blocks {
                let error = Error::parse("this is a part of another image, or of one that is cut otherwise");
                return Err(in_file(&path)(error.with_cure("remove it, and work anew")));
            }
            parts.push(part);
            sources.push(checksum);
        }
        if is_finished(&target, &sources) {
            return Ok(false);
        }
        write(&target, ImagePart::merged(&parts)?, &sources)?;
        Ok(true)
    }

    /// The diagram, once all parts are merged.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) where a file is missing, [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for any damage, naming the file.
    ///
    /// # Complexity
    /// That of sorting the pairs, which are all held.
    ///
    /// # Examples
    /// See [`ImageFolder`].
    pub fn diagram(&self) -> Result<ImageDiagram, Error> {
        let last = self.last_level();
        let path = self.part_path(last, 0);
        let (mut root, ..) = open_image_part(&bytes_of(&path)?).map_err(in_file(&path))?;
        let steps = progress::stage("collecting pairs", 0);
        for level in 0..=last {
            for number in 0..self.width(level) {
                let path = pairs_path(&self.part_path(level, number));
                let bytes = bytes_of(&path)?;
                let pairs = Container::open(&bytes, Kind::Image)
                    .and_then(|container| Ok(container.array(Role::Image, 0)?.into_owned()));
                if !root.add_pairs(&pairs.map_err(in_file(&path))?) {
                    return Err(in_file(&path)(Error::parse(
                        "these numbers are not those of pairs of an image",
                    )));
                }
                steps.advance(0);
            }
        }
        drop(steps);
        root.diagram().map_err(in_file(&path))
    }
}

fn in_file(path: &Path) -> impl Fn(Error) -> Error + '_ {
    move |error| error.in_file(path.display().to_string())
}

fn bytes_of(path: &Path) -> Result<Vec<u8>, Error> {
    let read = || {
        let mut bytes = Vec::new();
        open_regular(path)?.read_to_end(&mut bytes)?;
        Ok(bytes)
    };
    read().map_err(in_file(path))
}

fn pairs_path(part: &Path) -> PathBuf {
    part.with_extension("pairs")
}

/// Whether a part and its pairs are there, whole and made of these sources.
fn is_finished(part: &Path, sources: &[u64]) -> bool {
    let of_part = bytes_of(part).and_then(|bytes| Ok(open_image_part(&bytes)?.2));
    let of_pairs = bytes_of(&pairs_path(part))
        .and_then(|bytes| Ok(Container::open(&bytes, Kind::Image)?.array(Role::Sources, 0)?.into_owned()));
    let are_same = |found: Result<Vec<u64>, Error>| found.is_ok_and(|found| found == sources);
    are_same(of_part) && are_same(of_pairs)
}

/// Writes a part, after its pairs.
fn write(target: &Path, mut part: ImagePart, sources: &[u64]) -> Result<(), Error> {
    let pairs = part.take_pairs();
    let mut writer = ContainerWriter::new(Kind::Image);
    writer.push(Role::Sources, 0, sources);
    writer.push(Role::Image, 0, &pairs);
    replace_file(&pairs_path(target), |out| writer.write(out).map(|_| ()))?;
    drop(writer);
    drop(pairs);
    let bytes = image_part_of(&part, sources);
    replace_file(target, |out| Ok(out.write_all(&bytes)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::ErrorKind;

    #[test]
    fn finished_parts_are_kept_and_damaged_ones_are_made_again() {
        let folder = tempfile::tempdir().unwrap();
        let row = [3.0, 0.0, 5.0, 1.0, 2.0, 7.0, 4.0, 6.0];
        let blocks = ImageBlocks::new(&[8], &[2]).unwrap();
        let shards = ImageFolder::new(folder.path(), blocks.clone(), 2).unwrap();
        let window =
            |number: u32| -> Vec<f64> { blocks.window(number)[0].iter().map(|&voxel| row[voxel]).collect() };
        let all = |shards: &ImageFolder| -> Vec<bool> {
            let mut made: Vec<bool> =
                (0..4).map(|number| shards.block(number, &window(number)).unwrap()).collect();
            for (level, number) in [(1, 0), (1, 1), (2, 0)] {
                made.push(shards.merge(level, number).unwrap());
            }
            made
        };
        assert_eq!(all(&shards), [true; 7]);
        let whole = ImageBlocks::new(&[8], &[8]).unwrap().part(0, row).unwrap().diagram().unwrap();
        assert_eq!(shards.diagram().unwrap(), whole);
        assert_eq!(all(&shards), [false; 7]);
        for name in ["block-000002.part", "block-000002.pairs"] {
            std::fs::write(folder.path().join(name), "no container").unwrap();
            assert!(shards.merge(1, 1).is_err() || name.ends_with("pairs"));
            // The same bytes come again, so that what was made of them stays.
            assert_eq!(all(&shards), [false, false, true, false, false, false, false]);
        }
        assert_eq!(shards.diagram().unwrap(), whole);
        std::fs::remove_file(folder.path().join("blocks-2-000000.part")).unwrap();
        assert_eq!(shards.diagram().unwrap_err().kind(), ErrorKind::Io);
        let other = ImageFolder::new(folder.path(), blocks.clone().superlevel(true), 2).unwrap();
        assert_eq!(other.merge(1, 0).unwrap_err().kind(), ErrorKind::Parse);
        assert_eq!(all(&other), [true; 7]);
    }
}
