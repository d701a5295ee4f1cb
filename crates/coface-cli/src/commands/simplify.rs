//! `coface simplify`: a triangulated 3-manifold with fewer tetrahedra.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{beginning, print_json, print_text};
use crate::progress::Progress;
use crate::target::write_model;
use clap::Args;
use coface::answers::{Census, SimplifiedManifold, text};
use std::path::PathBuf;

/// A triangulation of a 3-manifold with fewer tetrahedra, by moves that keep the space.
///
/// The moves 4-1, 3-2 and 2-0 and collapses of edges remove tetrahedra; 2-3 adds one on the way to others. The same input gives the same triangulation on every machine. The
/// homology before and after is compared, and a boundary stays as it is. -o writes the gluing table as JSON or as an isomorphism signature (.sig).
#[derive(Args)]
pub(crate) struct Simplify {
    /// Tetrahedra: a gluing table, an isomorphism signature, a list of facets or a mesh; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// How often moves that add a tetrahedron are tried, when none removes one
    #[arg(long, value_name = "N", default_value_t = 200)]
    attempts: u32,
    /// Lines "signature name": the triangulation is looked up there, and moves go on until it is one of them
    #[arg(long, value_name = "FILE")]
    census: Option<PathBuf>,
    /// Print the moves
    #[arg(long)]
    log: bool,
}

impl Simplify {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let loaded = input::read(&self.input, common.reading(), &progress)?;
        progress.stage("simplifying");
        let attempts = self.attempts as usize;
        let found = match &self.census {
            None => SimplifiedManifold::of(&loaded.name, &loaded.model, attempts)?,
            Some(path) => {
                let census = Census::from_path(path)?;
                SimplifiedManifold::in_census(&loaded.name, &loaded.model, attempts, &census)?
            }
        };
        if let Some(path) = &common.output {
            write_model(path, found.model())?;
        }
        drop(progress);
        let answer = found.answer();
        if common.json {
            return print_json(answer);
        }
        let fact = |label: &str, value: String, gloss: &str| (label.to_owned(), value, gloss.to_owned());
        let listed = |counts: &[usize]| counts.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
        let mut facts = vec![
            fact("before", listed(&answer.f_vector_before), "vertices, edges, triangles, tetrahedra"),
            fact("now", listed(&answer.f_vector), ""),
            fact("moves", answer.moves.len().to_string(), "the homology is the same"),
            fact("signature", beginning(&answer.signature), ""),
        ];
        if let (Some(name), Some(proof)) = (&answer.name, &answer.name_proof) {
            facts.push(fact("name", name.clone(), &format!("by {}", proof.replace('_', " "))));
        }
        if let Some(census) = &answer.census {
            let count = census.triangulation_count;
            facts.push(match &census.found {
                Some(found) => {
                    let name = found.name.clone().unwrap_or_else(|| beginning(&found.signature));
                    fact("in the census", name, &format!("line {} of {}", found.line, census.file))
                }
                None => fact(
                    "in the census",
                    "no".to_owned(),
                    &format!("none of the {count} triangulations of {}", census.file),
                ),
            });
        }
        if self.log {
            facts.extend(answer.moves.iter().map(|one| fact("", one.clone(), "")));
        }
        print_text(&text::facts(&loaded.name, &facts))
    }
}
