//! Remarks: what was assumed, changed or left out on the way to an answer. They begin in the readers of files, so their
//! types are those of `coface-io`.

use crate::ProblemKind;
use coface_io::Model;
pub use coface_io::{Place, Remark, RemarkCode};

/// The remarks of a model that was read from a file of this name, with the name in their sentences and places.
pub(crate) fn remarks_of_file<'a>(name: &'a str, model: &'a Model) -> impl Iterator<Item = Remark> + 'a {
    model.remarks().iter().map(move |remark| {
        let mut remark = remark.clone();
        remark.message = format!("{name}: {}", remark.message);
        if remark.places.is_empty() {
            remark.places.push(Place::default());
        }
        for place in &mut remark.places {
            place.file.get_or_insert_with(|| name.to_owned());
        }
        remark
    })
}

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
