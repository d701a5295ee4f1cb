//! PLY, the polygon file format of Stanford: text, or binary in either byte order.
//!
//! A header lists *elements* (vertices, faces, ..), each with a count and typed *properties*; the data follow in that
//! order. Read are the coordinates `x y z` of the element `vertex`, whatever their type; the list `vertex_indices` (or
//! `vertex_index`) of the element `face`, where two vertices are a line and one is a point; the pairs `vertex1 vertex2` of
//! the element `edge`; and the strips of triangles of the element `tristrips`. Other properties of vertices, faces and
//! edges that are numbers are kept as data, in the width that they have: a color takes a byte. Lists and other elements are
//! read over.

mod columns;
mod header;
mod read;
mod rows;
mod write;

pub use read::read;
pub(crate) use read::read_with;
pub use write::write;

/// How the data behind the header are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// Decimal numbers.
    Ascii,
    /// Binary, the least significant byte first.
    #[default]
    LittleEndian,
    /// Binary, the most significant byte first.
    BigEndian,
}
