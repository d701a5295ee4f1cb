//! How models become a drawing.

use crate::RegionSource;

/// What makes a region, and which lines are rings.
///
/// # Examples
/// ```
/// use coface_answers::{DrawingOptions, PlanarDrawing, RegionSource};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ring = coface_io::read(&b"LINESTRING (0 0, 2 0, 2 2, 0 0)"[..], coface_io::Format::Wkt)?;
/// let options = DrawingOptions::new().source(RegionSource::Features).close_lines(true);
/// let drawing = PlanarDrawing::with_options([("ring", &ring)], &options)?;
/// assert_eq!((drawing.region_names(), drawing.unbounded_segment_count()), (vec!["ring#0"], 0));
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct DrawingOptions {
    /// What a region is.
    pub source: RegionSource,
    /// Whether lines that end where they begin are rings of polygons.
    pub close_lines: bool,
    /// Take models that are known exactly with rounded points, with a remark.
    pub(super) rounds_exact: bool,
}

impl DrawingOptions {
    /// Each model is a region, and lines are lines.
    ///
    /// # Examples
    /// ```
    /// assert!(!coface_answers::DrawingOptions::new().close_lines);
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Those of maps: features are what is asked about, and they have rounded points.
    pub(super) fn of_map() -> Self {
        Self { rounds_exact: true, ..Self::default() }
    }

    /// What a region is.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DrawingOptions, RegionSource};
    /// assert_eq!(DrawingOptions::new().source(RegionSource::Groups).source, RegionSource::Groups);
    /// ```
    pub fn source(mut self, source: RegionSource) -> Self {
        self.source = source;
        self
    }

    /// Whether lines that end where they begin are rings of polygons, each of its own.
    ///
    /// # Examples
    /// ```
    /// assert!(coface_answers::DrawingOptions::new().close_lines(true).close_lines);
    /// ```
    pub fn close_lines(mut self, close_lines: bool) -> Self {
        self.close_lines = close_lines;
        self
    }
}
