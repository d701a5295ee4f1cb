//! `coface homotopic`: closed walks on a surface compared.

use crate::arguments::Common;
use crate::certified;
use crate::failure::Failure;
use crate::groups::{self, Asked};
use crate::output::give;
use crate::progress::Progress;
use clap::Args;
use coface::answers::text;
use coface::answers::{GivenWalks, GroupsRequest, SurfaceLoops};
use std::path::PathBuf;

/// Which closed walks on a surface can be contracted, which bound, and which are homotopic or homologous to each other.
///
/// A walk goes along edges and ends where it starts: "0 1 2 0". Words of walks are in the canonical loops that
/// coface loops --canonical gives.
#[derive(Args)]
pub(crate) struct Homotopic {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Walks by their vertices, each in quotes: "0 1 2 0"
    #[arg(value_name = "WALK", required_unless_present = "walks", conflicts_with = "walks")]
    given: Vec<String>,
    /// Read the walks from a file: JSON {"walks":[[v0,v1,..,v0],..]}, or what coface loops -o wrote
    #[arg(long, value_name = "FILE")]
    walks: Option<PathBuf>,
    /// The base vertex of its component, which comes first; other components have their lowest vertex
    #[arg(long, value_name = "VERTEX")]
    base: Option<u32>,
    /// Print every walk and every pair, not just the first hundred
    #[arg(long)]
    all: bool,
    /// A certificate of all that is said of the walks, which coface check verifies: words of edges by a spanning forest and faces, and canonical loops;
    /// of a facet list, or a surface as plain OFF or OBJ; in the binary form if OUT ends in .bin
    #[arg(long, value_name = "OUT")]
    certificate: Option<PathBuf>,
}

impl Homotopic {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if let Some(place) = &self.certificate {
            certified::check_place(place, std::slice::from_ref(&self.input), "homotopic", common)?;
        }
        let progress = Progress::start(common.quiet);
        let walks = match &self.walks {
            Some(path) => groups::walks_in(path)?,
            None => GivenWalks {
                place: "the command line".to_owned(),
                walks: self.given.iter().map(|walk| vertices(walk)).collect::<Result<_, _>>()?,
            },
        };
        let request =
            GroupsRequest::new().base(self.base).surface_loops(SurfaceLoops::Canonical).walks(Some(walks));
        let asked = Asked::of(&self.input, &request, None, common, &progress)?;
        if let Some(place) = &self.certificate {
            progress.stage(format!("proving {}", place.display()));
            certified::save(place, std::slice::from_ref(&self.input), |inputs| {
                request.certificate(&asked.found, &asked.producer, inputs)
            })?;
        }
        drop(progress);
        let Some(answer) = asked.found.homotopic_answer(&asked.name) else { return Ok(()) };
        let limit = if self.all { usize::MAX } else { PAIRS };
        let facts = groups::facts_of_walks(&answer.walks, &answer.pairs, limit);
        give(common, &answer, &text::facts(&format!("closed walks on {}", answer.file), &facts))
    }
}

/// How many walks and pairs of them a page shows.
const PAIRS: usize = 100;

/// The vertices of a walk.
fn vertices(walk: &str) -> Result<Vec<u32>, Failure> {
    let words = walk.split([' ', ',', '\t']).filter(|word| !word.is_empty());
    let number = |word: &str| {
        word.trim_start_matches('v').parse().map_err(|_| {
            Failure::new(format!("the walk \"{walk}\": {word:?} is no vertex; write a walk as \"0 1 2 0\""))
        })
    };
    words.map(number).collect()
}
