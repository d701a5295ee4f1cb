//! Opening containers.

use super::elements::{Element, array_of_bytes};
use super::writing::head_checksum;
use super::{ALIGNMENT, HEADER, Kind, MARK, ROW, Role, VERSION};
use coface_algebra::{Error, ErrorKind};
use std::borrow::Cow;
use xxhash_rust::xxh3::xxh3_64;

/// A container whose every byte has been looked at: its sections lie in it, apart from each other, and have their checksums.
#[derive(Debug)]
pub struct Container<'a> {
    bytes: &'a [u8],
    checksum: u64,
    sections: Vec<Section>,
}

#[derive(Clone, Copy, Debug)]
struct Section {
    role: Role,
    index: u32,
    width: u32,
    start: usize,
    length: usize,
}

fn damaged(message: impl Into<String>, byte: usize) -> Error {
    Error::parse(message).at_byte(byte as u64).with_cure("make the file again, or restore it from a copy")
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"))
}

fn u64_at(bytes: &[u8], at: usize) -> u64 {
    u64::from_le_bytes(bytes[at..at + 8].try_into().expect("eight bytes"))
}

/// The kind of a container, from its first bytes; its length is compared with the one that it says.
fn kind_of(bytes: &[u8], length: u64) -> Result<Kind, Error> {
    let mark = &bytes[..bytes.len().min(MARK.len())];
    if mark != &MARK[..mark.len()] || bytes.is_empty() {
        return Err(Error::new(
            ErrorKind::UnsupportedFormat,
            "this is no container of coface: its mark is missing",
        )
        .at_byte(0)
        .with_cure("name a file that coface convert, shard, reduce or merge has written"));
    }
    if bytes.len() < HEADER {
        return Err(damaged(format!("the file ends within its header, after {length} bytes"), bytes.len()));
    }
    let version = u32_at(bytes, 8);
    if version > VERSION {
        return Err(Error::new(
            ErrorKind::UnsupportedFormat,
            format!("the container is of version {version}, and version {VERSION} is the newest known here"),
        )
        .at_byte(8)
        .with_cure("read it with a newer coface"));
    }
    let Some(kind) = Kind::of(u32_at(bytes, 12)).filter(|_| version == VERSION) else {
        return Err(damaged("the header is damaged: there is no such version or kind", 8));
    };
    let told = u64_at(bytes, 16);
    if told > length {
        return Err(damaged(format!("the file ends after {length} of {told} bytes"), length as usize));
    }
    if told < length {
        return Err(damaged(
            format!("the file goes on behind its end, at byte {told} of {length}"),
            told as usize,
        ));
    }
    Ok(kind)
}

/// The kind and the checksum of a container, from its first bytes and its length, without a look at what it holds.
///
/// # Errors
/// [`ErrorKind::Parse`] where it is damaged.
pub fn checksum_of_header(start: &[u8], length: u64) -> Result<(Kind, u64), Error> {
    Ok((kind_of(start, length)?, u64_at(start, 32)))
}

impl<'a> Container<'a> {
    /// Opens a container of this kind.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for something else, [`ErrorKind::Parse`] with the byte for any damage.
    ///
    /// # Complexity
    /// Every byte is read once; nothing is stored but the table.
    #[doc(hidden)]
    pub fn open(bytes: &'a [u8], kind: Kind) -> Result<Self, Error> {
        let found = kind_of(bytes, bytes.len() as u64)?;
        let checksum = u64_at(bytes, 32);
        let count = u32_at(bytes, 24) as usize;
        let table_end = count.checked_mul(ROW).and_then(|length| length.checked_add(HEADER));
        let Some(table_end) = table_end.filter(|&end| end <= bytes.len()) else {
            return Err(damaged(format!("a table of {count} sections does not fit in the file"), 24));
        };
        if head_checksum(&bytes[..table_end]) != checksum {
            return Err(damaged("the header or the table of sections is damaged: its checksum differs", 32));
        }
        if found != kind {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                format!("the container holds {}, not {}", found.title(), kind.title()),
            )
            .at_byte(12)
            .with_cure(match found {
                Kind::Complex => "shard it by coface shard",
                Kind::Shard => "reduce it by coface reduce",
                Kind::Reduced => "merge its folder by coface merge",
                Kind::Chains => "take it down by the shards that it came from",
                Kind::Image => "merge it with the parts of the other blocks of its image",
            }));
        }
        if bytes[28..32].iter().chain(&bytes[40..64]).any(|&byte| byte != 0) {
            return Err(damaged("the header has bytes that mean nothing", 28));
        }
        let mut sections: Vec<Section> = Vec::with_capacity(count);
        let mut end = table_end;
        for i in 0..count {
            let at = HEADER + ROW * i;
            let section = section_at(bytes, at, &mut end)?;
            if sections.iter().any(|other| (other.role, other.index) == (section.role, section.index)) {
                return Err(damaged(format!("the section of {} is there twice", section.name()), at));
            }
            sections.push(section);
        }
        if end != bytes.len() {
            return Err(damaged("the file goes on behind its last section", end));
        }
        Ok(Self { bytes, checksum, sections })
    }

    /// The checksum of the whole.
    #[doc(hidden)]
    pub fn checksum(&self) -> u64 {
        self.checksum
    }

    /// Whether there is a section.
    #[doc(hidden)]
    pub fn has(&self, role: Role, index: usize) -> bool {
        self.find(role, index).is_some()
    }

    /// The width of the elements of a section.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`] if there is none.
    pub(crate) fn width(&self, role: Role, index: usize) -> Result<u32, Error> {
        Ok(self.section(role, index)?.width)
    }

    /// The array of a section.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`] if there is none, or one of other numbers.
    #[doc(hidden)]
    pub fn array<T: Element>(&self, role: Role, index: usize) -> Result<Cow<'a, [T]>, Error> {
        let section = self.section(role, index)?;
        if section.width as usize != size_of::<T>() {
            return Err(damaged(
                format!("the section of {} has numbers of {} bytes", section.name(), section.width),
                section.start,
            ));
        }
        Ok(array_of_bytes(&self.bytes[section.start..section.start + section.length]))
    }

    /// The error that what a section holds cannot be.
    #[doc(hidden)]
    pub fn lie(&self, role: Role, index: usize, message: &str) -> Error {
        let start = self.find(role, index).map_or(0, |section| section.start);
        damaged(message, start)
    }

    fn find(&self, role: Role, index: usize) -> Option<Section> {
        let is_meant = |section: &&Section| section.role == role && section.index as usize == index;
        self.sections.iter().find(is_meant).copied()
    }

    fn section(&self, role: Role, index: usize) -> Result<Section, Error> {
        self.find(role, index)
            .ok_or_else(|| damaged(format!("there is no section of {} {index}", role.name()), HEADER))
    }
}

impl Section {
    fn name(&self) -> String {
        format!("{} {}", self.role.name(), self.index)
    }
}

/// The section of the row of the table at this byte, after the one that ends at `end`.
fn section_at(bytes: &[u8], at: usize, end: &mut usize) -> Result<Section, Error> {
    let Some(role) = Role::of(u32_at(bytes, at)).filter(|_| u32_at(bytes, at + 12) == 0) else {
        return Err(damaged("a section is of no known sort", at));
    };
    let mut section =
        Section { role, index: u32_at(bytes, at + 4), width: u32_at(bytes, at + 8), start: 0, length: 0 };
    let lies = |what: &str| damaged(format!("the section of {} {what}", section.name()), at);
    let (Ok(start), Ok(length)) =
        (usize::try_from(u64_at(bytes, at + 16)), usize::try_from(u64_at(bytes, at + 24)))
    else {
        return Err(lies("is longer than the file"));
    };
    if start != end.next_multiple_of(ALIGNMENT) {
        return Err(lies("does not begin where the one before ends"));
    }
    let Some(after) = start.checked_add(length).filter(|&after| after <= bytes.len()) else {
        return Err(lies("is longer than the file"));
    };
    if !matches!(section.width, 1 | 4 | 8) || !length.is_multiple_of(section.width as usize) {
        return Err(lies("has numbers of an impossible width"));
    }
    if let Some(byte) = bytes[*end..start].iter().position(|&byte| byte != 0) {
        return Err(damaged("there is something between two sections", *end + byte));
    }
    if xxh3_64(&bytes[start..after]) != u64_at(bytes, at + 32) {
        return Err(damaged(
            format!("the section of {} is damaged: its checksum differs", section.name()),
            start,
        ));
    }
    (section.start, section.length) = (start, length);
    *end = after;
    Ok(section)
}
