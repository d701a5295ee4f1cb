//! `coface isomorphic`: whether two triangulations are the same under other names.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{beginning, give};
use crate::progress::Progress;
use clap::Args;
use coface::answers::{isomorphic, text};
use std::path::PathBuf;

/// Whether two triangulations are the same but for the names of simplices and vertices, and with which names.
///
/// Inputs are gluing tables, isomorphism signatures, lists of facets, or meshes of triangles or tetrahedra. Signatures are printed
/// too: two triangulations are the same if and only if they have the same signature. Surfaces of other polygons, such as
/// quadrangles, are compared polygon by polygon, and have no signature.
#[derive(Args)]
pub(crate) struct Isomorphic {
    /// The first triangulation; - is standard input
    #[arg(value_name = "A")]
    first: PathBuf,
    /// The second triangulation
    #[arg(value_name = "B")]
    second: PathBuf,
}

impl Isomorphic {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let a = input::read(&self.first, common.reading(), &progress)?;
        let b = input::read(&self.second, common.reading(), &progress)?;
        progress.stage("comparing");
        let answer = isomorphic([&a.name, &b.name], [&a.model, &b.model])?;
        drop(progress);
        let fact = |label: &str, value: String, gloss: &str| (label.to_owned(), value, gloss.to_owned());
        let mut facts = vec![match answer.isomorphic {
            true => fact("isomorphic", "yes".to_owned(), "the same but for names"),
            false => fact("isomorphic", "no".to_owned(), "no names make them the same"),
        }];
        if let Some(difference) = &answer.difference {
            facts.push(fact("difference", difference.clone(), ""));
        }
        if let Some(simplices) = &answer.simplices {
            let few: Vec<String> =
                simplices.iter().enumerate().take(12).map(|(from, to)| format!("{from} to {to}")).collect();
            let more = if simplices.len() > few.len() { ", .. (--json lists all)" } else { "" };
            facts.push(fact("simplices", format!("{}{more}", few.join(", ")), ""));
        }
        for (name, signature) in answer.files.iter().zip(&answer.signatures) {
            if let Some(signature) = signature {
                facts.push(fact("signature", beginning(signature), name));
            }
        }
        give(common, &answer, &text::facts(&format!("{} and {}", answer.files[0], answer.files[1]), &facts))
    }
}
