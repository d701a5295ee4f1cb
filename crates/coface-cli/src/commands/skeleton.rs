//! `coface skeleton`.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::simplices::Request;
use clap::Args;
use coface::answers::simplicial_skeleton;
use coface::io::Model;
use std::path::PathBuf;

/// Skeleton: all simplices up to a dimension.
#[derive(Args)]
pub(crate) struct Skeleton {
    /// The model: a facet list, or a mesh of triangles or tetrahedra; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// The highest dimension that is kept
    #[arg(long, short, value_name = "K")]
    dimension: usize,
}

impl Skeleton {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let request = Request { verb: "skeleton", input: &self.input, simplices: None };
        let make = |model: &Model| simplicial_skeleton(model, self.dimension);
        request.serve_complex(common, make, |complex, _| {
            Ok((0..=self.dimension.min(complex.dimension().unwrap_or(0)))
                .flat_map(|dimension| complex.simplices(dimension))
                .collect())
        })
    }
}
