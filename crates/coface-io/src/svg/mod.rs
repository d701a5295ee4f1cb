//! SVG: paths, polygons, polylines, lines, rectangles, circles and ellipses, with their transformations.
//!
//! What is filled becomes rings: closed lines with the integers `polygon` and `ring`,
//! as in [`geojson`](super::geojson); the subpaths of one path are the rings of one polygon, in their order, and one that is open is closed, as SVG fills it, with a
//! remark. A third array, `fill_rule`, says what is inside: 0 for what winds around, 1 for what winds around an odd number of times, -1 for lines
//! that are no rings. What is not filled (`fill="none"`) is lines, and so is what has nothing inside. Where nothing is filled, closed outlines are rings, with a remark.
//! The `id` of an element names a group of its lines.
//!
//! Whether a shape is filled and shown is said by attributes, by rules of `style` elements for elements, classes, identifiers and what is in them, and by its own `style`, in the order of
//! CSS. What is hidden is not there. Shapes or places in styles, and other rules are not done: one remark counts them.
//!
//! As SVG 2 says, a paint `url(#id)` that is not in the file is the paint behind it, or else none, `context-fill` and `context-stroke` are the paints of the `use` that draws an element, and a `use` of what it is in draws
//! nothing. Another remark counts paints that are not there and circles of uses.
//!
//! # Clipping
//! What is seen of a shape is what is read. A filled shape becomes its exact intersection with all that clips it, rounded once: polygons with holes, each connected part of it one, of one feature; a line becomes its pieces. What
//! lies inside of all clips stays as it is drawn. These clip:
//! * `clip-path="url(#id)"` of shapes and groups, as an attribute or in a style: the shapes of the `clipPath` and those that a `use` in it names, by `clip-rule`, with `clipPathUnits`, `transform`, and clip paths of
//!   the `clipPath` and of its shapes. In units of a box without an extent, as that of a straight line, it clips nothing.
//! * `inset()`, `circle()`, `ellipse()` and `polygon()` as `clip-path`, in the box around what is filled; not in that around outlines, and not with round corners.
//! * An `svg` inside, and a `symbol` that is used: at their boxes, unless `overflow` says otherwise.
//! * `mask="url(#id)"`, if its shapes are plain white or black (or of any color, for `mask-type: alpha`), without outlines, and nothing shines through.
//!
//! Other clip paths and masks are not done, and counted in that remark: those of other files, of text, grey ones, and such as contain themselves. The outermost `svg` clips nothing.
//!
//! # Coordinates
//! Coordinates are those of the user: transformations are applied, `viewBox`, `width` and `height` of the outermost element are not. The second axis points
//! down in a picture and is not turned around. Lengths have the units of CSS, of which an inch has 96, and percentages are of the `viewBox`, or of `width` and `height`
//! without one. A `use` is drawn as what it names in the same file, an `svg` inside is moved and scaled to its place. Curves are replaced by chords within a tolerance: the one that is given, or a thousandth
//! of the diagonal of the box around the drawing, with a remark. What is defined but not drawn (`defs`, `symbol`, `clipPath`, `mask`, `pattern`, `marker`) is passed over, and so are text, images and copies from other files, with
//! a remark.
//!
//! # Examples
//! A square of side 4 of which a clip path shows the half above a diagonal: 8.
//! ```
//! # #[cfg(feature = "xml")]
//! # fn main() -> Result<(), coface_algebra::Error> {
//! let text = r##"<svg xmlns="http://www.w3.org/2000/svg"><clipPath id="c"><path d="M0 0h9v9z"/></clipPath>
//!     <rect width="4" height="4" clip-path="url(#c)"/></svg>"##;
//! let model = coface_io::svg::read(text.as_bytes())?;
//! assert_eq!((model.lines().len(), model.vertex_count()), (1, 3));
//! # Ok(()) }
//! # #[cfg(not(feature = "xml"))]
//! # fn main() {}
//! ```

#[cfg(feature = "xml")]
mod clip_paths;
#[cfg(feature = "xml")]
mod clip_shapes;
#[cfg(all(test, feature = "xml"))]
mod clip_tests;
#[cfg(feature = "xml")]
mod clipping;
#[cfg(feature = "xml")]
mod curves;
#[cfg(feature = "xml")]
mod elements;
#[cfg(feature = "xml")]
mod masks;
#[cfg(feature = "xml")]
mod painting;
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
