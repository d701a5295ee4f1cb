//! `coface link`.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::simplices::{Request, SimplexList};
use clap::Args;
use coface::answers::Neighborhood;
use std::path::PathBuf;

/// Link: what the neighborhood of the given simplices leaves when everything touching them is taken away.
///
/// The closure of the star minus the star of the closure. A vertex of a closed surface has a cycle as its link.
#[derive(Args)]
pub(crate) struct Link {
    /// The model: a facet list, or a mesh of triangles or tetrahedra; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// The simplices by their vertices: "0 1; 3" is the edge {0, 1} and the vertex 3
    #[arg(long, value_name = "LIST")]
    simplices: SimplexList,
}

impl Link {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        Request { verb: "link", input: &self.input, simplices: Some(&self.simplices) }
            .serve(common, |complex, set| Neighborhood::Link.found(complex, set))
    }
}
