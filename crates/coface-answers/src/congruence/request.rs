//! What a congruence of models is asked for.

use coface_arrange::congruence::{BlockPolicy, ClassRule, CongruenceOptions, Representative};

/// Which vertices belong together before anything is merged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum BlockRule {
    /// Those of one model.
    #[default]
    Models,
    /// Those that cells connect: each connected component is a block.
    Components,
    /// Nothing is said about blocks.
    None,
}

/// How models are merged.
///
/// # Examples
/// ```
/// use coface_arrange::congruence::Representative;
/// use coface_answers::CongruenceRequest;
/// let mut request = CongruenceRequest::within(1e-6);
/// request.representative = Representative::Mean;
/// assert_eq!(request.tolerance, 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct CongruenceRequest {
    /// Vertices at most so far apart are congruent; a length in the unit of the models.
    pub tolerance: f64,
    /// Which chains of such vertices make a class.
    pub rule: ClassRule,
    /// Where a class is.
    pub representative: Representative,
    /// Whether classes are merged again until none are within the tolerance of each other.
    pub stable: bool,
    /// How the quotient is made, and what becomes of cells that lose their shape.
    pub options: CongruenceOptions,
    /// What the blocks are.
    pub blocks: BlockRule,
    /// What to do where vertices of one block become one.
    pub within_blocks: BlockPolicy,
}

impl CongruenceRequest {
    /// Classes by chains of vertices within the tolerance, at their lowest members; each model is a block, in which vertices may
    /// become one.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::CongruenceRequest::within(1e-6).tolerance, 1e-6);
    /// ```
    pub fn within(tolerance: f64) -> Self {
        Self {
            tolerance,
            rule: ClassRule::default(),
            representative: Representative::default(),
            stable: false,
            options: CongruenceOptions::default(),
            blocks: BlockRule::default(),
            within_blocks: BlockPolicy::Allow,
        }
    }
}
