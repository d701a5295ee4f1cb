//! `coface boundary`.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::simplices::{Request, SimplexList};
use clap::Args;
use coface::complexes::simplicial::SimplexSet;
use std::path::PathBuf;

/// Boundary: the closure of the faces that lie in just one simplex of the top dimension.
///
/// Of the complex that the given simplices and their faces make, or of the whole model. All of its maximal simplices must
/// have one dimension.
#[derive(Args)]
pub(crate) struct Boundary {
    /// The model: a facet list, or a mesh of triangles or tetrahedra; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// The simplices by their vertices: "0 1 2; 1 2 3" [default: all of the model]
    #[arg(long, value_name = "LIST")]
    simplices: Option<SimplexList>,
}

impl Boundary {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        Request { verb: "boundary", input: &self.input, simplices: self.simplices.as_ref() }
            .serve(common, |complex, set| {
                Ok(SimplexSet::from(&complex.boundary_complex(&complex.closure(set)?)?))
            })
    }
}
