//! What faces are stated to be.

/// What the faces of a solid that is given are stated to be, in the words of CityGML: which codes are looked for.
///
/// # Examples
/// Three squares that share an edge are faces as good as any, and no surface:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::spatial::checks::{CheckedFaces, CheckedPrimitive, FaultCode, GeometryChecks};
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let corners = vec![0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0., 1., -1., 0., 0., -1., 0., 1., 0., 1., 0., 0., 1.];
/// let corners = Positions::from_flat(3, corners)?;
/// let squares = RaggedArray::from_lists([[0, 1, 2, 3], [1, 0, 5, 4], [0, 1, 6, 7]]);
/// let codes = |primitive| -> Result<Vec<FaultCode>, coface_algebra::Error> {
///     let faces = CheckedFaces::from_polygons(squares.clone()).with_shells(vec![0; 3], vec![0])?;
///     let found = GeometryChecks::new().check(&corners, &faces.with_primitives(vec![primitive])?)?;
///     Ok(found.faults().iter().map(|fault| fault.code()).collect())
/// };
/// assert!(codes(CheckedPrimitive::MultiSurface)?.is_empty());
/// assert_eq!(codes(CheckedPrimitive::CompositeSurface)?, [FaultCode::NonManifoldEdge]);
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CheckedPrimitive {
    /// Faces that have nothing to do with each other: 1xx and 2xx.
    MultiSurface,
    /// Faces of one surface, which may have a boundary: 1xx, 2xx, and 3xx but for 301 and 302.
    CompositeSurface,
    /// A solid by itself, also one of many: 1xx to 4xx.
    #[default]
    Solid,
    /// A solid of the composite with this number: 1xx to 4xx, and 5xx for all of the composite.
    CompositeSolid(u32),
}

impl CheckedPrimitive {
    /// Whether its faces bound a solid.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::checks::CheckedPrimitive;
    /// assert!(CheckedPrimitive::Solid.is_solid() && !CheckedPrimitive::CompositeSurface.is_solid());
    /// ```
    pub const fn is_solid(self) -> bool {
        matches!(self, Self::Solid | Self::CompositeSolid(_))
    }
}
