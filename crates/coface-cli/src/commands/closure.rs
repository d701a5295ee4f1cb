//! `coface closure`.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::simplices::{Request, SimplexList};
use clap::Args;
use coface::answers::Neighborhood;
use std::path::PathBuf;

/// Closure: the given simplices with all their faces.
///
/// The smallest complex that holds them.
#[derive(Args)]
pub(crate) struct Closure {
    /// The model: a facet list, or a mesh of triangles or tetrahedra; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// The simplices by their vertices: "0 1; 3" is the edge {0, 1} and the vertex 3
    #[arg(long, value_name = "LIST")]
    simplices: SimplexList,
}

impl Closure {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        Request { verb: "closure", input: &self.input, simplices: Some(&self.simplices) }
            .serve(common, |complex, set| Neighborhood::Closure.found(complex, set))
    }
}
