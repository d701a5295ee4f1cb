//! What a congruence does where cells lose their shape.

/// How quotients are computed. The results are the same, entry by entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum CongruenceMethod {
    /// Lists of facets, sorted in buckets: the fast one.
    #[default]
    Lists,
    /// Products of sparse matrices, and a map of their columns.
    Matrices,
}

/// What becomes of cells that lose their shape: those that collapse, and those whose boundary loses terms.
///
/// # Examples
/// A hexagon with two opposite vertices at one place: one pinched face, or two triangles.
/// ```
/// use coface_arrange::congruence::{CellClasses, Collisions, CongruenceOptions, chain_congruence};
/// use coface_algebra::RaggedArray;
/// use coface_complexes::surface::PolygonMesh;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let hexagon = PolygonMesh::new(6, RaggedArray::from_lists([[0, 1, 2, 3, 4, 5]]), &[])?.chain_complex()?;
/// let quotient = |collisions| {
///     let vertices = CellClasses::unsigned(vec![0, 1, 2, 0, 3, 4])?;
///     chain_congruence(&hexagon, vertices, None, CongruenceOptions::new().collisions(collisions))
/// };
/// assert_eq!(quotient(Collisions::Keep)?.complex().f_vector(), [5, 6, 1]);
/// assert_eq!(quotient(Collisions::Rewrap)?.complex().f_vector(), [5, 6, 2]);
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Collisions {
    /// Collapsed cells are dropped; the others stay as chains, possibly pinched. Both are recorded.
    #[default]
    Keep,
    /// Collapsed cells are dropped; the others, and those that came to touch themselves, are split into the cells that
    /// their boundaries enclose.
    ///
    /// A face is split into the regions of its plane that its boundary encloses, a solid into those of space, each with
    /// its holes. Where several splits are possible, at a vertex of a face with more than two of its edges or at an
    /// edge of a solid with more than two of its faces, the order of angles decides, in rounded numbers, so that the
    /// pieces do not cross; equal angles go by the numbers of the cells. Without positions, or for a face without area,
    /// the pieces are closed walks that meet no vertex twice, lowest edges first. Solids without positions, and cells
    /// of higher degree, fall into what is connected through ridges (cells two degrees below). A cell stays whole if a
    /// facet of it has no boundary, if a coefficient of it is beyond 64, or if it had several shells and there are no
    /// positions to relate them.
    ///
    /// Cells that lost facets until they have fewer than their degree and one more are removed, unless a higher cell
    /// has them in its boundary.
    ///
    /// Pieces are cells like all others, so they can be congruent to cells that were there before. The image of a split
    /// cell is the sum of its pieces. So images are a chain map wherever no cell was removed for too few facets.
    Rewrap,
    /// An error that names the first such cell.
    Refuse,
}

/// How the quotient of a chain complex is made.
///
/// # Examples
/// ```
/// use coface_arrange::congruence::{Collisions, CongruenceMethod, CongruenceOptions};
/// let options = CongruenceOptions::new().method(CongruenceMethod::Matrices).collisions(Collisions::Refuse);
/// assert_ne!(options, CongruenceOptions::new());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct CongruenceOptions {
    pub(super) method: CongruenceMethod,
    pub(super) collisions: Collisions,
}

impl CongruenceOptions {
    /// Lists of facets, and chains that are kept as they are.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::{Collisions, CongruenceMethod, CongruenceOptions};
    /// let options = CongruenceOptions::new();
    /// assert_eq!(options, options.method(CongruenceMethod::Lists).collisions(Collisions::Keep));
    /// ```
    pub const fn new() -> Self {
        Self { method: CongruenceMethod::Lists, collisions: Collisions::Keep }
    }

    /// Computes quotients by this method. The results of all methods are the same.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::{CongruenceMethod, CongruenceOptions};
    /// let options = CongruenceOptions::new().method(CongruenceMethod::Matrices);
    /// assert_ne!(options, CongruenceOptions::new());
    /// ```
    #[must_use]
    pub const fn method(mut self, method: CongruenceMethod) -> Self {
        self.method = method;
        self
    }

    /// Does this with cells that lose their shape.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::{Collisions, CongruenceOptions};
    /// let options = CongruenceOptions::new().collisions(Collisions::Rewrap);
    /// assert_ne!(options, CongruenceOptions::new());
    /// ```
    #[must_use]
    pub const fn collisions(mut self, collisions: Collisions) -> Self {
        self.collisions = collisions;
        self
    }
}
