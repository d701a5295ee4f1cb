//! Well-known binary: points, lines and polygons with holes, as bytes or as hexadecimal digits.
//!
//! Arcs become chords. Both byte orders, the numbers of ISO (1003 for a polygon with heights) and the flags of EWKB are read; the number of the reference
//! system (SRID) is kept, measures are passed over. A file of bytes holds geometries one after the other, or a collection of
//! which each part is a feature. A file of digits has one geometry a line, and may have well-known text beside them: see
//! [`wkt`](super::wkt).
//!
//! What is written has its lowest byte first: the numbers of ISO, or the flags of EWKB where the reference system has a number.

mod reading;
#[cfg(test)]
mod tests;
mod writing;

pub use reading::read;
pub(super) use reading::{is_binary, is_digits, read_digits, read_flattened};
pub(super) use writing::write_empty_polygon;
pub use writing::{Encoding, write};

/// The flags of EWKB.
const HAS_Z: u32 = 1 << 31;
const HAS_M: u32 = 1 << 30;
const HAS_SRID: u32 = 1 << 29;

/// The kinds of geometry by their numbers.
const POINT: u32 = 1;
const LINE: u32 = 2;
const POLYGON: u32 = 3;
const COLLECTION: u32 = 7;
const ARCS: u32 = 8;
const COMPOUND: u32 = 9;
const CURVE_POLYGON: u32 = 10;
const POLYHEDRAL_SURFACE: u32 = 15;
const TIN: u32 = 16;
/// The number of several of one kind is that of the kind and this.
const MULTI: u32 = 3;
