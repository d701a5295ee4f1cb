//! Options of an arrangement in the plane.

use coface_algebra::{Error, ErrorKind};

/// Options of a planar arrangement or overlay.
///
/// # Examples
/// Ten lines in each direction make more than a hundred cells.
/// ```
/// use coface_arrange::planar::{PlanarArrangement, PlanarOptions};
/// use coface_geometry::Positions;
/// use coface_algebra::ErrorKind;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let lines = (1..11).map(f64::from).flat_map(|i| [[i, 0., i, 11.], [0., i, 11., i]]);
/// let points = Positions::from_flat(2, lines.flatten().collect())?;
/// let segments: Vec<[u32; 2]> = (0..20).map(|s| [2 * s, 2 * s + 1]).collect();
/// let options = PlanarOptions::new().max_cells(441);
/// assert_eq!(PlanarArrangement::with_options(&points, &segments, &options)?.f_vector(), [140, 220, 81]);
/// let options = options.max_cells(440);
/// let refused = PlanarArrangement::with_options(&points, &segments, &options).unwrap_err();
/// assert_eq!(refused.kind(), ErrorKind::TooLarge);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct PlanarOptions {
    /// The most vertices, edges and bounded faces together; no bound if `None`. What would be larger is refused as soon
    /// as that is certain.
    pub(super) max_cells: Option<usize>,
}

impl PlanarOptions {
    /// No bound on the number of cells.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarOptions;
    /// assert_eq!(PlanarOptions::new(), PlanarOptions::default());
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Refuses more vertices, edges and bounded faces together than this.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarOptions;
    /// assert_eq!(PlanarOptions::new().max_cells(7).max_cells(None), PlanarOptions::new());
    /// ```
    #[must_use]
    pub fn max_cells(mut self, most: impl Into<Option<usize>>) -> Self {
        self.max_cells = most.into();
        self
    }

    /// # Errors
    /// [`ErrorKind::TooLarge`] if there are more cells than allowed.
    pub(super) fn check(&self, cell_count: usize, when: &str) -> Result<(), Error> {
        match self.max_cells {
            Some(most) if cell_count > most => Err(Error::new(
                ErrorKind::TooLarge,
                format!("the arrangement has {cell_count} cells {when}; {most} are allowed"),
            )
            .with_cure("allow more cells, or arrange the segments in parts")),
            _ => Ok(()),
        }
    }
}
