//! OFF, the object file format of Geomview, with its relatives.
//!
//! The keyword is `[ST][C][N][4][n]OFF`, and may be missing: texture coordinates, colors and normals at the vertices are
//! read over, `4` means four coordinates a vertex, `n` that the dimension stands before the counts (`4nOFF`: one
//! coordinate more than that); the first count may follow it without a blank. A face is a number of vertices and their indices, from 0; what follows on its line, a
//! color, is read over. A face of two vertices is a line, one of one vertex a point. `#` starts a comment. In the text
//! form each vertex and each face has a line of its own; a file of another layout is read word by word, with a remark.
//! `OFF BINARY` is big-endian, or little-endian with a remark, with single precision.

mod read;
mod words;
mod write;

pub use read::read;
pub(crate) use read::{read_file, read_with};
pub use write::write;
