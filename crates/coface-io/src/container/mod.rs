//! The binary container of chain complexes and of their parts.
//!
//! # The format
//! All numbers are little endian. A file is a header of 64 bytes, a table with 40 bytes for each section, and the sections, each at a
//! multiple of 64 bytes, with zeros between.
//!
//! | bytes of the header | hold |
//! |---|---|
//! | 0 to 7 | the mark `89 63 66 63 0d 0a 1a 0a` |
//! | 8 to 11 | the version, 1 |
//! | 12 to 15 | the kind: 1 a chain complex, 2 a shard, 3 a reduced shard, 4 chains, 5 a part of an image |
//! | 16 to 23 | the length of the file in bytes |
//! | 24 to 27 | the number of sections |
//! | 32 to 39 | the checksum of the header without these bytes, and of the table |
//! | 28 to 31, 40 to 63 | zero |
//!
//! | bytes of a row of the table | hold |
//! |---|---|
//! | 0 to 3 | what the section is: 1 numbers about the whole, 2 counts of cells, 3 column starts, 4 rows, 5 entries, 6 wide entries, 7 positions, ... |
//! | 4 to 7 | its index: the degree, for what there is one of for each degree |
//! | 8 to 11 | the width of its elements in bytes: 1, 4 or 8 |
//! | 12 to 15 | zero |
//! | 16 to 23, 24 to 31 | where it begins and how many bytes it has |
//! | 32 to 39 | its checksum |
//!
//! Checksums are XXH3 of 64 bits; that of the header stands for the whole file, since the table has those of the sections. Integers are in one byte each if all fit, else in 4 (incidences of
//! cells) or 8 bytes, of which the lowest value means that the number stands among the wide ones: a length of 4 bytes and two's complement, one after the other.
//!
//! Arrays are seen in place where the machine is little endian and copied elsewhere, so a container can be mapped. Whatever is
//! damaged or untrue in a file is an error that names the byte.

mod complexes;
mod elements;
mod integers;
mod reading;
#[cfg(test)]
mod tests;
mod writing;

#[doc(hidden)]
pub use complexes::push_wide_complex;
pub use complexes::{push_complex, to_complex, to_wide_complex};
pub use complexes::{read, write};
pub use elements::array_of_bytes;
#[doc(hidden)]
pub use elements::hash_array;
pub use integers::integers;
#[doc(hidden)]
pub use integers::push_integers;
#[doc(hidden)]
pub use reading::Container;
pub use reading::checksum_of_header;
#[doc(hidden)]
pub use writing::ContainerWriter;
pub use writing::Written;

/// The first bytes of every container: no text, and changed by whatever takes it for one.
pub(super) const MARK: [u8; 8] = *b"\x89cfc\r\n\x1a\n";
const VERSION: u32 = 1;
const HEADER: usize = 64;
const ROW: usize = 40;
const ALIGNMENT: usize = 64;

/// What a container holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Kind {
    /// A chain complex, perhaps with positions of its vertices.
    Complex = 1,
    /// A part of a complex, or what it is made from.
    Shard = 2,
    /// What is left of a part, or of several.
    Reduced = 3,
    /// Chains by ids on their way down.
    Chains = 4,
    /// What is left of a block of an image, or of several.
    Image = 5,
}

impl Kind {
    fn of(number: u32) -> Option<Self> {
        [Self::Complex, Self::Shard, Self::Reduced, Self::Chains, Self::Image]
            .into_iter()
            .find(|&kind| kind as u32 == number)
    }

    /// What it is, in a sentence.
    #[doc(hidden)]
    pub fn title(self) -> &'static str {
        match self {
            Self::Complex => "a chain complex",
            Self::Shard => "a shard",
            Self::Reduced => "a reduced shard",
            Self::Chains => "chains",
            Self::Image => "a part of an image",
        }
    }
}

/// What a section is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u32)]
#[doc(hidden)]
pub enum Role {
    /// Numbers about the whole.
    Meta = 1,
    Counts,
    Starts,
    Rows,
    Entries,
    WideEntries,
    Positions,
    Ids,
    Keys,
    SetStarts,
    SetItems,
    WallStarts,
    WallItems,
    WallHashes,
    Sources,
    NameStarts,
    NameItems,
    TermStarts,
    Orders,
    WideOrders,
    OwnCounts,
    Grid,
    Bits,
    Image,
}

/// All roles with their names, by number.
const ROLES: [(Role, &str); 24] = [
    (Role::Meta, "numbers about the whole"),
    (Role::Counts, "counts of cells"),
    (Role::Starts, "column starts"),
    (Role::Rows, "rows"),
    (Role::Entries, "entries"),
    (Role::WideEntries, "wide entries"),
    (Role::Positions, "positions"),
    (Role::Ids, "ids"),
    (Role::Keys, "keys"),
    (Role::SetStarts, "starts of key sets"),
    (Role::SetItems, "key sets"),
    (Role::WallStarts, "starts of shared faces"),
    (Role::WallItems, "shared faces"),
    (Role::WallHashes, "hashes of shared faces"),
    (Role::Sources, "checksums of sources"),
    (Role::NameStarts, "starts of names"),
    (Role::NameItems, "names"),
    (Role::TermStarts, "starts of chains"),
    (Role::Orders, "orders"),
    (Role::WideOrders, "wide orders"),
    (Role::OwnCounts, "counts of own cells"),
    (Role::Grid, "description of a grid"),
    (Role::Bits, "voxels"),
    (Role::Image, "what is left of blocks of an image"),
];

impl Role {
    fn of(number: u32) -> Option<Self> {
        let (role, _) = ROLES.get((number as usize).checked_sub(1)?)?;
        Some(*role)
    }

    fn name(self) -> &'static str {
        ROLES[self as usize - 1].1
    }
}
