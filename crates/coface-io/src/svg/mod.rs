//! SVG: paths, polygons, polylines, lines, rectangles, circles and ellipses, with their transformations.
//!
//! What is filled becomes rings: closed lines with the integers `polygon` and `ring`,
//! as in [`geojson`](super::geojson); the subpaths of one path are the rings of one polygon, in their order, and one that is open is closed, as SVG fills it, with a
//! remark. A third array, `fill_rule`, says what is inside: 0 for what winds around, 1 for what winds around an odd number of times, -1 for lines
//! that are no rings. What is not filled (`fill="none"`) is lines, and so is what has nothing inside. Where nothing is filled, closed outlines are rings, with a remark.
//! The `id` of an element names a group of its lines.
//!
//! Whether a shape is filled and shown is said by attributes, by rules of `style` elements for elements, classes, identifiers and what is in them, and by its own `style`, in the order of
//! CSS. What is hidden is not there. Clip paths, masks, shapes or places in styles, and other rules are not done: one remark counts them.
//!
//! Coordinates are those of the user: transformations are applied, `viewBox`, `width` and `height` of the outermost element are not. The second axis points
//! down in a picture and is not turned around. Lengths have the units of CSS, of which an inch has 96, and percentages are of the `viewBox`, or of `width` and `height`
//! without one. A `use` is drawn as what it names in the same file, an `svg` inside is moved and scaled to its place; neither is clipped, and a remark counts what goes beyond. Curves are replaced by chords within a tolerance: the one that is given, or a thousandth
//! of the diagonal of the box around the drawing, with a remark. What is defined but not drawn (`defs`, `symbol`, `clipPath`, `mask`, `pattern`, `marker`) is passed over, and so are text, images and copies from other files, with
//! a remark.

#[cfg(feature = "xml")]
mod clip_paths;
#[cfg(feature = "xml")]
mod clipping;
#[cfg(feature = "xml")]
mod curves;
#[cfg(feature = "xml")]
mod elements;
#[cfg(feature = "xml")]
mod path;
#[cfg(feature = "xml")]
mod reading;
#[cfg(feature = "xml")]
mod regions;
#[cfg(feature = "xml")]
mod style;
#[cfg(all(test, feature = "xml"))]
mod tests;
#[cfg(feature = "xml")]
mod transformation;
#[cfg(feature = "xml")]
mod undone;
#[cfg(feature = "xml")]
mod viewport;
#[cfg(not(feature = "xml"))]
mod without_xml;
mod writing;

#[cfg(feature = "xml")]
pub(super) use reading::read_with;
#[cfg(feature = "xml")]
pub use reading::{read, read_flattened};
#[cfg(feature = "xml")]
pub(super) use regions::read_regions;
#[cfg(not(feature = "xml"))]
pub use without_xml::{read, read_flattened};
#[cfg(not(feature = "xml"))]
pub(super) use without_xml::{read_regions, read_with};
pub use writing::write;
