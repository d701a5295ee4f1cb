//! `coface star`.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::simplices::{Request, SimplexList};
use clap::Args;
use coface::answers::Neighborhood;
use std::path::PathBuf;

/// Star: all simplices that have one of the given ones as a face.
///
/// In general no complex. Its closure is the closed star.
#[derive(Args)]
pub(crate) struct Star {
    /// The model: a facet list, or a mesh of triangles or tetrahedra; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// The simplices by their vertices: "0 1; 3" is the edge {0, 1} and the vertex 3
    #[arg(long, value_name = "LIST")]
    simplices: SimplexList,
}

impl Star {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        Request { verb: "star", input: &self.input, simplices: Some(&self.simplices) }
            .serve(common, |complex, set| Neighborhood::Star.found(complex, set))
    }
}
