//! Persistence of images by blocks, as bytes: what is left of a block, what is merged, the diagram.

use coface_algebra::Error;
use coface_io::container::{Container, ContainerWriter, Kind, Role, hash_array};
use coface_topology::{ImageBlocks, ImageDiagram, ImagePart};
use std::ops::Range;
use xxhash_rust::xxh3::Xxh3;

/// Counts of a part of an image.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ImagePartSummary {
    blocks: Range<u32>,
    critical: Vec<usize>,
    pairs: usize,
    rules: usize,
    bytes: u64,
    checksum: u64,
    sources: Vec<u64>,
}

impl ImagePartSummary {
    /// The blocks that it is of.
    pub fn blocks(&self) -> Range<u32> {
        self.blocks.clone()
    }

    /// The critical cells in each degree that are not paired yet.
    pub fn critical(&self) -> &[usize] {
        &self.critical
    }

    /// The pairs that were found, but for those that die as they are born.
    pub fn pairs(&self) -> usize {
        self.pairs
    }

    /// The cells at the rim that other blocks ask for.
    pub fn rules(&self) -> usize {
        self.rules
    }

    /// Its length.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// The checksum of the whole.
    pub fn checksum(&self) -> u64 {
        self.checksum
    }

    /// The checksums of what it was made from.
    pub fn sources(&self) -> &[u64] {
        &self.sources
    }
}

/// The checksum that a part of this block names as its source: it changes with the numbers of the window, and with what is asked about the image.
///
/// # Examples
/// ```
/// use coface_scale::shards::window_checksum;
/// use coface_topology::ImageBlocks;
/// let blocks = ImageBlocks::new(&[4], &[2])?;
/// let of = |blocks: &ImageBlocks, first: f64| window_checksum(blocks, 0, &[first, 5.0, 1.0]);
/// assert_eq!(of(&blocks, 0.0), of(&blocks, 0.0));
/// assert_ne!(of(&blocks, 0.0), of(&blocks, 1.0));
/// assert_ne!(of(&blocks, 0.0), of(&blocks.clone().superlevel(true), 0.0));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn window_checksum(blocks: &ImageBlocks, number: u32, numbers: &[f64]) -> u64 {
    let mut hash = Xxh3::new();
    hash_array(&mut hash, &blocks.to_words());
    hash_array(&mut hash, &[u64::from(number)]);
    // NaN has many bits and one meaning.
    let word = |&number: &f64| if number.is_nan() { u64::MAX } else { (number + 0.0).to_bits() };
    let mut words = Vec::with_capacity(4096);
    for chunk in numbers.chunks(4096) {
        words.clear();
        words.extend(chunk.iter().map(word));
        hash_array(&mut hash, &words);
    }
    hash.digest()
}

/// A part as bytes.
pub(super) fn image_part_of(part: &ImagePart, sources: &[u64]) -> Vec<u8> {
    let words = part.to_words();
    let mut writer = ContainerWriter::new(Kind::Image);
    writer.push(Role::Sources, 0, sources);
    writer.push(Role::Image, 0, &words);
    writer.into_bytes()
}

/// A part, its checksum, and those of its sources.
pub(super) fn open_image_part(bytes: &[u8]) -> Result<(ImagePart, u64, Vec<u64>), Error> {
    let container = Container::open(bytes, Kind::Image)?;
    let sources = container.array(Role::Sources, 0)?.into_owned();
    let part = ImagePart::of_words(&container.array(Role::Image, 0)?);
    let part = part
        .ok_or_else(|| container.lie(Role::Image, 0, "these numbers are not those of a part of an image"))?;
    Ok((part, container.checksum(), sources))
}

/// What is left of a block of an image, from the numbers of its window.
///
/// # Errors
/// Those of [`ImageBlocks::part`].
///
/// # Panics
/// If there is no such block.
///
/// # Complexity
/// That of [`ImageBlocks::part`].
///
/// # Examples
/// Two valleys with a pass between them, in two blocks.
/// ```
/// use coface_scale::shards::{image_diagram, image_part, image_part_summary, merge_image_parts};
/// use coface_topology::ImageBlocks;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let blocks = ImageBlocks::new(&[4], &[2])?;
/// let parts = [image_part(&blocks, 0, &[0.0, 5.0, 1.0])?, image_part(&blocks, 1, &[5.0, 1.0, 2.0])?];
/// let whole = merge_image_parts(&parts)?;
/// let summary = image_part_summary(&whole)?;
/// assert_eq!(summary.blocks(), 0..2);
/// assert_eq!(summary.sources()[1], image_part_summary(&parts[1])?.checksum());
/// let diagram = image_diagram(&whole)?;
/// assert_eq!((diagram.pairs()[1].birth(), diagram.pairs()[1].death()), (1.0, Some(5.0)));
/// # Ok(()) }
/// ```
pub fn image_part(blocks: &ImageBlocks, number: u32, numbers: &[f64]) -> Result<Vec<u8>, Error> {
    let part = blocks.part(number, numbers.iter().copied())?;
    Ok(image_part_of(&part, &[window_checksum(blocks, number, numbers)]))
}

/// The part of the blocks of these parts together, in the order of their numbers.
///
/// # Errors
/// Those of [`ImagePart::merged`]; [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the byte for any damage.
///
/// # Complexity
/// That of [`ImagePart::merged`].
///
/// # Examples
/// See [`image_part`].
pub fn merge_image_parts<B: AsRef<[u8]>>(parts: &[B]) -> Result<Vec<u8>, Error> {
    let mut opened = Vec::with_capacity(parts.len());
    let mut sources = Vec::with_capacity(parts.len());
    for part in parts {
        let (part, checksum, _) = open_image_part(part.as_ref())?;
        opened.push(part);
        sources.push(checksum);
    }
    Ok(image_part_of(&ImagePart::merged(&opened)?, &sources))
}

/// The diagram of an image, from the part of all its blocks.
///
/// # Errors
/// Those of [`ImagePart::diagram`]; [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the byte for any damage.
///
/// # Complexity
/// That of [`ImagePart::diagram`].
///
/// # Examples
/// See [`image_part`].
pub fn image_diagram(part: &[u8]) -> Result<ImageDiagram, Error> {
    open_image_part(part)?.0.diagram()
}

/// The counts of a part.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the byte for any damage.
///
/// # Complexity
/// Linear.
///
/// # Examples
/// See [`image_part`].
pub fn image_part_summary(part: &[u8]) -> Result<ImagePartSummary, Error> {
    let (opened, checksum, sources) = open_image_part(part)?;
    Ok(ImagePartSummary {
        blocks: opened.blocks(),
        critical: opened.critical_counts(),
        pairs: opened.pair_count(),
        rules: opened.rule_count(),
        bytes: part.len() as u64,
        checksum,
        sources,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::ErrorKind;

    #[test]
    fn damaged_bytes_are_refused() {
        let blocks = ImageBlocks::new(&[4], &[4]).unwrap();
        let bytes = image_part(&blocks, 0, &[0.0, 5.0, 1.0, 2.0]).unwrap();
        assert_eq!(image_diagram(&bytes).unwrap().pairs().len(), 2);
        for place in (0..bytes.len()).step_by(7) {
            let mut damaged = bytes.clone();
            damaged[place] ^= 0x20;
            if let Err(error) = image_diagram(&damaged) {
                assert!(matches!(error.kind(), ErrorKind::Parse | ErrorKind::UnsupportedFormat), "{error}");
            }
        }
        let words = [9u64, 9];
        let mut writer = ContainerWriter::new(Kind::Image);
        writer.push(Role::Sources, 0, &words);
        writer.push(Role::Image, 0, &words);
        assert_eq!(image_diagram(&writer.into_bytes()).unwrap_err().kind(), ErrorKind::Parse);
    }
}
