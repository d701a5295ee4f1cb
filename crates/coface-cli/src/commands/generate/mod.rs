//! `coface generate`: models made by rule.

mod construction;
mod member;
mod parts;
mod scene;

use crate::arguments::{Common, format_of_name};
use crate::failure::Failure;
use crate::output::{print_bytes, print_json, print_text};
use crate::progress::Progress;
use crate::remarks::say_remarks;
use crate::target::written_format;
use clap::{Args, Subcommand};
use coface::answers::answer::GenerateAnswer;
use coface::answers::losses_of;
use coface::answers::text;
use coface::complexes::families::FamilyModel;
use coface::io;
use coface::io::{Format, Model, never_written};
use construction::Construction;
use member::Member;

/// Make a model by rule: grids, shapes with positions, known spaces, sweeps and products.
///
/// The model goes to the file of -o in the format of its extension, or to standard output in the format of --to; without
/// both, a summary is printed. Shapes have a default for every parameter, so that `coface generate torus -o torus.off` is a torus.
///
/// Shapes are oriented coherently where that is possible, closed surfaces with the normal outward, solids positively.
#[derive(Args)]
#[command(subcommand_value_name = "FAMILY", subcommand_help_heading = "Families")]
pub(crate) struct Generate {
    #[command(subcommand)]
    family: Family,
    /// Write the model in this format, to standard output without -o
    #[arg(long, value_name = "FORMAT", global = true, value_parser = format_of_name)]
    to: Option<Format>,
    /// The boundary of the model instead: the facets of exactly one cell
    #[arg(long, global = true)]
    boundary: bool,
    /// The cells of this dimension instead, after --boundary
    #[arg(long, value_name = "K", global = true)]
    skeleton: Option<usize>,
}

#[derive(Subcommand)]
enum Family {
    #[command(flatten)]
    Construction(Construction),
    #[command(flatten)]
    Member(Member),
}

/// What a rule makes.
enum Made {
    /// A member of a family.
    Family(FamilyModel),
    /// A model of cells of several sorts, or a structure.
    Model(Box<Model>),
}

impl Made {
    fn boundary(self) -> Result<Self, Failure> {
        match self {
            Self::Family(made) => Ok(Self::Family(made.boundary()?.ok_or_else(no_boundary)?)),
            Self::Model(model) if model.structure().is_some() => Err(no_parts("boundary")),
            Self::Model(model) => {
                Ok(Self::Model(Box::new(parts::boundary(&model)?.ok_or_else(no_boundary)?)))
            }
        }
    }

    fn skeleton(self, dimension: usize) -> Result<Self, Failure> {
        match self {
            Self::Family(made) => Ok(Self::Family(made.skeleton(dimension)?)),
            Self::Model(model) if model.structure().is_some() => Err(no_parts("skeleton")),
            Self::Model(model) => {
                let none = || Failure::new(format!("no cell of the model has {dimension} dimensions"));
                Ok(Self::Model(Box::new(parts::skeleton(&model, dimension)?.ok_or_else(none)?)))
            }
        }
    }

    fn model(self) -> Result<Model, Failure> {
        Ok(match self {
            Self::Family(FamilyModel::Cells(cells)) => Model::from_placed_cells(cells)?,
            Self::Family(FamilyModel::Complex(complex)) => construction::facets(&complex.facets()),
            Self::Model(model) => *model,
        })
    }
}

fn no_boundary() -> Failure {
    Failure::new("the model has no boundary: every facet lies in two cells; leave --boundary out")
}

/// A format of surfaces takes the boundary of a solid.
fn or_its_boundary(error: coface::Error) -> coface::Error {
    match error.cure() {
        Some(cure @ "write MEDIT, MSH or VTK") => {
            let cure = format!("{cure}, or the surface of it with --boundary");
            error.with_cure(cure)
        }
        _ => error,
    }
}

fn no_parts(what: &str) -> Failure {
    Failure::new(format!(
        "the {what} of such a model is not taken here; write it with -o and use the verb {what}"
    ))
}

impl Family {
    fn make(&self, common: &Common, progress: &Progress) -> Result<Made, Failure> {
        match self {
            Self::Construction(construction) => construction.make(common, progress),
            Self::Member(member) => Ok(Made::Family(member.make()?)),
        }
    }
}

impl Generate {
    /// Whether the model is made of others.
    pub(crate) fn reads_models(&self) -> bool {
        matches!(self.family, Family::Construction(_))
    }

    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let target = common.output.as_deref();
        let format = match (self.to, target) {
            (Some(format), _) => match never_written(format) {
                Some(error) => return Err(error.into()),
                None => Some(format),
            },
            (None, Some(path)) => Some(written_format(path, "; or say it with --to")?),
            (None, None) => None,
        };
        if target.is_none() && self.to.is_some() && common.json {
            return Err(Failure::new("standard output cannot hold both the model and --json; give -o OUT"));
        }
        let progress = Progress::start(common.quiet);
        progress.stage("making the model");
        let mut made = self.family.make(common, &progress)?;
        if self.boundary {
            made = made.boundary()?;
        }
        if let Some(dimension) = self.skeleton {
            made = made.skeleton(dimension)?;
        }
        let model = made.model()?;
        let mut losses = Vec::new();
        match (target, format) {
            (Some(path), Some(format)) => {
                progress.stage(format!("writing {}", path.display()));
                io::write_path(&model, path, Some(format)).map_err(or_its_boundary)?;
                losses = losses_of(&model, format);
                say_remarks(&losses, common);
                if !common.json {
                    return Ok(());
                }
            }
            (None, Some(format)) => {
                // Made in memory first: a model that the format cannot hold leaves nothing on standard output.
                let mut bytes = Vec::new();
                io::write(&model, &mut bytes, format).map_err(or_its_boundary)?;
                drop(progress);
                say_remarks(&losses_of(&model, format), common);
                return print_bytes(|out| out.write_all(&bytes));
            }
            _ => {}
        }
        progress.stage("counting cells");
        let mut answer = GenerateAnswer::of(model)?;
        drop(progress);
        if let (Some(path), Some(format)) = (target, format) {
            answer = answer.written_to(path.display().to_string(), format.name());
        }
        answer.remarks = losses;
        if common.json {
            return print_json(&answer);
        }
        let fact = |label: &str, value: String, gloss: &str| (label.to_owned(), value, gloss.to_owned());
        let counts = words(answer.f_vector.iter().map(usize::to_string));
        let mut facts = vec![
            fact("f-vector", counts, "cells of dimension 0, 1, .."),
            fact("alternating sum", answer.euler_characteristic.to_string(), "the Euler characteristic"),
        ];
        if let Some([low, high]) = &answer.bounding_box {
            facts.push(fact(
                "bounding box",
                format!("({}) to ({})", coordinates(low), coordinates(high)),
                "",
            ));
        }
        let page = text::facts("model (written with -o OUT or --to FORMAT)", &facts);
        print_text(&page)
    }
}

fn coordinates(point: &[f64]) -> String {
    words(point.iter().map(|&x| text::number(x)))
}

fn words(numbers: impl Iterator<Item = String>) -> String {
    numbers.collect::<Vec<_>>().join(" ")
}
