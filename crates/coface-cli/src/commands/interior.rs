//! `coface interior`.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::simplices::{Request, SimplexList};
use clap::Args;
use std::path::PathBuf;

/// Interior: the simplices that are not in the boundary.
///
/// Of the complex that the given simplices and their faces make, or of the whole model. In general no complex.
#[derive(Args)]
pub(crate) struct Interior {
    /// The model: a facet list, or a mesh of triangles or tetrahedra; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// The simplices by their vertices: "0 1 2; 1 2 3" [default: all of the model]
    #[arg(long, value_name = "LIST")]
    simplices: Option<SimplexList>,
}

impl Interior {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        Request { verb: "interior", input: &self.input, simplices: self.simplices.as_ref() }
            .serve(common, |complex, set| complex.interior(&complex.closure(set)?))
    }
}
