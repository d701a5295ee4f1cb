//! The domain of homology on the command line: groups of a mesh, and what they are taken relative to.

use crate::failure::Failure;
use crate::input;
use crate::progress::Progress;
use clap::Args;
use coface::answers::{Domain, RelativeTo, named_groups};
use coface::io::{Format, Model, ReadOptions};
use std::path::{Path, PathBuf};

/// Which part of the model the question is about.
#[derive(Args)]
pub(crate) struct DomainOptions {
    /// Only the cells of a physical group of a .msh, or of another group of a mesh, and their faces: its name or number,
    /// or several with commas between; may be given several times
    #[arg(long, value_name = "GROUP")]
    domain: Vec<String>,
    /// Relative to a subcomplex: boundary (of the domain), a physical group or another group of the mesh by its name or
    /// number, several with commas between, or a file of cells by the same vertex numbers; groups may be given several
    /// times. A word that is a group and something else is the group
    #[arg(long, value_name = "boundary|GROUP|FILE")]
    relative: Vec<PathBuf>,
}

impl DomainOptions {
    /// What the words mean for this model.
    pub(crate) fn domain(&self, model: &Model, progress: &Progress) -> Result<Domain, Failure> {
        let relative = part(&self.relative, model, progress)?;
        Ok(Domain { groups: self.domain.clone(), relative })
    }

    /// The file that the domain is taken relative to, if the word is one.
    pub(crate) fn files(&self) -> impl Iterator<Item = &PathBuf> {
        self.relative.iter().filter(|word| word.as_os_str() != "boundary" && word.exists())
    }

    pub(crate) fn has_groups(&self) -> bool {
        !self.domain.is_empty()
    }

    pub(crate) fn has_part(&self) -> bool {
        !self.relative.is_empty()
    }

    /// What stands before the name of the model in a title, and what after it.
    pub(crate) fn words(&self) -> (String, String) {
        let before =
            if self.domain.is_empty() { String::new() } else { format!("{} in ", self.domain.join(", ")) };
        let parts: Vec<String> = self.relative.iter().map(|part| part.display().to_string()).collect();
        let after =
            if parts.is_empty() { String::new() } else { format!(", relative to {}", parts.join(", ")) };
        (before, after)
    }
}

/// The part of a model that words name: its boundary, groups, or the cells of a file.
pub(crate) fn part(
    given: &[PathBuf],
    model: &Model,
    progress: &Progress,
) -> Result<Option<RelativeTo>, Failure> {
    let words: Vec<&str> = given.iter().filter_map(|word| word.to_str()).collect();
    let is_group = |word: &str| named_groups(model, &[word.to_owned()]);
    Ok(match (given, &words[..]) {
        ([], _) => None,
        ([_], [word]) if is_group(word).is_ok() => Some(RelativeTo::Groups(vec![(*word).to_owned()])),
        ([_], ["boundary"]) => Some(RelativeTo::Boundary),
        ([file], _) if file.exists() || model.groups().is_empty() => {
            let part = input::read(file, ReadOptions::default(), progress)?;
            Some(RelativeTo::Part { name: part.name, model: Box::new(part.model) })
        }
        (_, words) => Some(RelativeTo::Groups(words.iter().map(|&word| word.to_owned()).collect())),
    })
}

/// Whether a file is a mesh of Gmsh by its name, which keeps chains as physical groups.
pub(crate) fn is_msh(path: &Path) -> bool {
    Format::from_path(path) == Some(Format::Msh)
}
