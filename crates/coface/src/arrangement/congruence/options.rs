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
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Collisions {
    /// Collapsed cells are dropped; the others stay as chains, possibly pinched. Both are recorded.
    #[default]
    Keep,
    /// An error that names the first such cell.
    Refuse,
}

/// How the quotient of a chain complex is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct CongruenceOptions {
    /// How quotients are computed.
    pub method: CongruenceMethod,
    /// What becomes of cells that lose their shape.
    pub collisions: Collisions,
}
