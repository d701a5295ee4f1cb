//! Making containers.

use super::elements::{Element, to_bytes};
use super::{ALIGNMENT, HEADER, Kind, MARK, ROW, Role, VERSION};
use coface_algebra::Error;
use std::borrow::Cow;
use std::io::Write;
use xxhash_rust::xxh3::{Xxh3, xxh3_64};

/// A container that is being made: arrays are borrowed until it is written.
pub struct ContainerWriter<'a> {
    kind: Kind,
    sections: Vec<Section<'a>>,
}

impl std::fmt::Debug for ContainerWriter<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ContainerWriter")
            .field("kind", &self.kind)
            .field("sections", &self.sections.len())
            .finish_non_exhaustive()
    }
}

struct Section<'a> {
    role: Role,
    index: u32,
    width: u32,
    bytes: Cow<'a, [u8]>,
}

/// What was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Written {
    /// The checksum of the whole.
    pub(crate) checksum: u64,
    /// How many bytes there are.
    pub(crate) length: u64,
}

impl<'a> ContainerWriter<'a> {
    /// An empty container.
    #[doc(hidden)]
    pub fn new(kind: Kind) -> Self {
        Self { kind, sections: Vec::new() }
    }

    /// Appends an array.
    #[doc(hidden)]
    pub fn push<T: Element>(&mut self, role: Role, index: usize, array: &'a [T]) {
        self.add::<T>(role, index, to_bytes(array));
    }

    /// Appends an array that was made for it.
    #[doc(hidden)]
    pub fn push_owned<T: Element>(&mut self, role: Role, index: usize, array: &[T]) {
        self.add::<T>(role, index, Cow::Owned(to_bytes(array).into_owned()));
    }

    fn add<T>(&mut self, role: Role, index: usize, bytes: Cow<'a, [u8]>) {
        let index = u32::try_from(index).expect("there are few degrees");
        self.sections.push(Section { role, index, width: size_of::<T>() as u32, bytes });
    }

    /// Writes it.
    ///
    /// # Errors
    /// Those of the output.
    #[doc(hidden)]
    pub fn write(&self, out: &mut (impl Write + ?Sized)) -> Result<Written, Error> {
        const ZEROS: [u8; ALIGNMENT] = [0; ALIGNMENT];
        let mut head = vec![0u8; HEADER + ROW * self.sections.len()];
        let mut end = head.len();
        let mut starts = Vec::with_capacity(self.sections.len());
        for (i, section) in self.sections.iter().enumerate() {
            let start = end.next_multiple_of(ALIGNMENT);
            starts.push(start);
            end = start + section.bytes.len();
            let row = &mut head[HEADER + ROW * i..][..ROW];
            row[..4].copy_from_slice(&(section.role as u32).to_le_bytes());
            row[4..8].copy_from_slice(&section.index.to_le_bytes());
            row[8..12].copy_from_slice(&section.width.to_le_bytes());
            row[16..24].copy_from_slice(&(start as u64).to_le_bytes());
            row[24..32].copy_from_slice(&(section.bytes.len() as u64).to_le_bytes());
            row[32..40].copy_from_slice(&xxh3_64(&section.bytes).to_le_bytes());
        }
        head[..8].copy_from_slice(&MARK);
        head[8..12].copy_from_slice(&VERSION.to_le_bytes());
        head[12..16].copy_from_slice(&(self.kind as u32).to_le_bytes());
        head[16..24].copy_from_slice(&(end as u64).to_le_bytes());
        head[24..28].copy_from_slice(&(self.sections.len() as u32).to_le_bytes());
        let checksum = head_checksum(&head);
        head[32..40].copy_from_slice(&checksum.to_le_bytes());
        out.write_all(&head)?;
        let mut at = head.len();
        for (section, start) in self.sections.iter().zip(starts) {
            out.write_all(&ZEROS[..start - at])?;
            out.write_all(&section.bytes)?;
            at = start + section.bytes.len();
        }
        Ok(Written { checksum, length: end as u64 })
    }

    /// It as bytes.
    #[doc(hidden)]
    pub fn into_bytes(self) -> Vec<u8> {
        let mut bytes = Vec::new();
        self.write(&mut bytes).expect("memory takes all bytes");
        bytes
    }
}

/// The checksum of a header and a table, without the bytes where it stands.
pub(super) fn head_checksum(head: &[u8]) -> u64 {
    let mut hash = Xxh3::new();
    hash.update(&head[..32]);
    hash.update(&head[40..]);
    hash.digest()
}
