//! STL, the triangles of stereolithography: text or binary.
//!
//! STL has no vertices, only the corners of triangles in single precision. Corners whose three coordinates are equal
//! bit for bit (negative zero counting as zero) are *welded* to one vertex; no tolerance is used. Vertices are numbered
//! in the order of their first corner. Triangles that repeat a vertex after that are left out with a warning; their
//! vertices stay. The name behind `solid` makes a group. A binary file may begin with the word `solid` too: it is known
//! by its bytes.

mod read;
mod weld;
mod write;

pub use read::read;
pub(crate) use read::read_with;
pub(crate) use write::losses;
pub use write::write;

/// How triangles are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// Words and decimal numbers.
    Ascii,
    /// 50 bytes a triangle, the least significant byte first.
    #[default]
    Binary,
}
