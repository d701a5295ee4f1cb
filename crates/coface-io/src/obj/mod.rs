//! OBJ, the object files of Wavefront: polygons, polylines, points and names for sets of these.
//!
//! Read are `v` (three coordinates, and a color of three numbers; a weight is read over), `f`, `l`, `p` with indices from 1, or
//! negative ones that count back from the vertex before the statement, each as `v`, `v/vt`, `v//vn` or `v/vt/vn`; and
//! the names of `g`, `o` and `usemtl`. `\` at the end of a line joins the next one, `#` starts a comment. All other
//! statements are read over. An index may name a vertex that stands further down, but not one that the file lacks.

mod groups;
mod read;
mod write;

pub use read::read;
pub(crate) use read::read_with;
pub(crate) use write::lost_groups;
pub use write::write;
