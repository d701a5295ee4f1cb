//! Remarks: what was assumed, changed or left out on the way to an answer. They begin in the readers of files, so their
//! types are those of `coface-io`.

use crate::ProblemKind;
pub use coface_io::{Place, Remark, RemarkCode};

impl From<ProblemKind> for RemarkCode {
    fn from(kind: ProblemKind) -> Self {
        match kind {
            ProblemKind::NonManifoldRidge => Self::NonmanifoldRidge,
            ProblemKind::NonManifoldEdge => Self::NonmanifoldEdge,
            ProblemKind::NonManifoldVertex => Self::NonmanifoldVertex,
            ProblemKind::OrientationConflict => Self::OrientationConflict,
            ProblemKind::OneSidedChain => Self::OneSidedChain,
            ProblemKind::DuplicateCell => Self::DuplicateCell,
            ProblemKind::IsolatedVertex => Self::IsolatedVertex,
            ProblemKind::LooseCell => Self::LooseCell,
        }
    }
}
