//! `coface congruence`: what coincides within a tolerance becomes one.

use crate::arguments::{Common, length};
use crate::certified;
use crate::classes::{ClassFormat, write_classes};
use crate::failure::Failure;
use crate::input::{self, Loaded};
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::target::{take_rounding, written_format};
use clap::{Args, ValueEnum};
use coface::answers::answer::{CongruenceAnswer, Remark, RemarkCode};
use coface::answers::text;
use coface::answers::{BlockRule, CongruenceRequest, ModelCongruence};
use coface::arrange::congruence::{BlockPolicy, ClassRule, Collisions, CongruenceMethod, Representative};
use coface::io;
use coface::io::Format;
use std::path::PathBuf;

/// Merge what coincides: chain complex congruence of one or more models.
///
/// Vertices within the tolerance of each other become one, and cells whose boundaries then are the same, up to sign, become
/// one. What is left is a chain complex whatever the tolerance is. Cells that shrink to nothing are discarded, and counted.
///
/// Several models are taken together, and their cells numbered one model after the other. With -o the result is written as
/// a mesh in the format of the extension, its vertices at the representatives; as .json it is a chain complex with
/// positions. Groups and data are not kept.
///
/// With --json: "f_vector_before", "f_vector", "classes" (how many of each degree), "largest_class_diameter", "discarded" and
/// "changed" (cells of each degree that collapsed, or lost facets), "products_zero" (the boundary of every boundary, found by
/// multiplying), "merged_within_blocks" (how often vertices of one block became one).
#[derive(Args)]
pub(crate) struct Congruence {
    /// The models; - is standard input
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
    /// The length within which vertices are one, in the unit of the models
    #[arg(long, value_name = "R", allow_negative_numbers = true, value_parser = length)]
    tolerance: f64,
    /// Classes in the order of the vertices, none farther than R from the first, instead of chains of near vertices
    #[arg(long)]
    greedy: bool,
    /// Where a class is: at its lowest member, or at the mean or the median of its members
    #[arg(long, value_name = "WHERE", default_value = "lowest")]
    representative: Where,
    /// Merge classes again until none are within the tolerance of each other
    #[arg(long)]
    stable: bool,
    /// How the quotient is computed; the result is the same
    #[arg(long, value_name = "METHOD", default_value = "lists")]
    method: Method,
    /// What becomes of cells that lose facets: kept as chains, split into the cells that they enclose, or refused
    #[arg(long, value_name = "WHAT", default_value = "rewrap")]
    collisions: Lost,
    /// What belongs together beforehand: the vertices of each file, or of each connected component
    #[arg(long, value_name = "WHAT", default_value = "files")]
    blocks: Blocks,
    /// Whether vertices of one block may become one
    #[arg(long, value_name = "POLICY", default_value = "allow")]
    within_blocks: Within,
    /// Write the class and the sign of every cell: .json or .arrow
    #[arg(long, value_name = "FILE")]
    classes: Option<PathBuf>,
    /// A certificate of the congruence, which coface check verifies: the classes of the vertices by the tolerance, the map of cells to classes as a chain
    /// map, and the boundaries of the classes; of surfaces as plain OFF or OBJ; in the binary form if its name ends in .bin
    #[arg(long, value_name = "OUT")]
    certificate: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Where {
    Lowest,
    Mean,
    Median,
}

#[derive(Clone, Copy, ValueEnum)]
enum Method {
    /// Lists of facets, sorted in buckets
    Lists,
    /// Products of sparse matrices
    Matrices,
}

#[derive(Clone, Copy, ValueEnum)]
enum Lost {
    Keep,
    Rewrap,
    Refuse,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Blocks {
    Files,
    Components,
    None,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Within {
    Allow,
    Warn,
    Forbid,
}

impl Congruence {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let class_format = self.classes.as_deref().map(ClassFormat::of).transpose()?;
        let output = common.output.as_deref().map(|path| Ok::<_, Failure>((path, written_format(path, "")?)));
        let output = output.transpose()?;
        if let Some(place) = &self.certificate {
            certified::check_place(place, &self.inputs, "congruence", common)?;
        }
        let progress = Progress::start(common.quiet);
        let mut models = Vec::new();
        let mut left_out = 0;
        for path in &self.inputs {
            let Loaded { name, model, .. } = input::read(path, common.reading(), &progress)?;
            left_out += model.groups().len() + model.data().len();
            models.push((name, model));
        }
        progress.stage("merging");
        let congruence = ModelCongruence::of(models, &self.request())?;
        progress.stage("multiplying boundaries");
        let model = match output {
            Some((_, Format::Json)) => Some(congruence.to_chains()?),
            Some(_) => Some(congruence.to_mesh()?),
            None => None,
        };
        let mut answer = congruence.answer()?;
        accept(&answer.remarks, common)?;
        if let Some(place) = &self.certificate {
            progress.stage(format!("proving {}", place.display()));
            certified::save(place, &self.inputs, |inputs| congruence.certificate(inputs))?;
        }
        progress.stage("writing");
        let write_model = || match (output, &model) {
            (Some((path, format)), Some(model)) => io::write_path(model, path, Some(format)),
            _ => Ok(()),
        };
        match (&self.classes, class_format) {
            (Some(path), Some(format)) => write_classes(&congruence, path, format, write_model)?,
            _ => write_model()?,
        }
        if let (Some((path, _)), Some(model)) = (output, &model) {
            take_rounding(path, model);
        }
        drop(progress);
        if left_out > 0 && output.is_some() {
            let message = format!("groups and data are not kept: {left_out} left out");
            answer.remarks.insert(0, Remark::new(RemarkCode::DataLeftOut, message).at(left_out, []));
        }
        say_remarks(&answer.remarks, common);
        if common.json {
            return print_json(&answer);
        }
        if common.output.is_some() || self.classes.is_some() {
            return Ok(());
        }
        print_text(&self.page(&answer))
    }

    fn request(&self) -> CongruenceRequest {
        let mut request = CongruenceRequest::within(self.tolerance);
        request.rule = if self.greedy { ClassRule::Greedy } else { ClassRule::Transitive };
        request.representative = match self.representative {
            Where::Lowest => Representative::Lowest,
            Where::Mean => Representative::Mean,
            Where::Median => Representative::Median,
        };
        request.stable = self.stable;
        let method = match self.method {
            Method::Lists => CongruenceMethod::Lists,
            Method::Matrices => CongruenceMethod::Matrices,
        };
        let collisions = match self.collisions {
            Lost::Keep => Collisions::Keep,
            Lost::Rewrap => Collisions::Rewrap,
            Lost::Refuse => Collisions::Refuse,
        };
        request.options = request.options.method(method).collisions(collisions);
        request.blocks = match self.blocks {
            Blocks::Files => BlockRule::Models,
            Blocks::Components => BlockRule::Components,
            Blocks::None => BlockRule::None,
        };
        request.within_blocks = match self.within_blocks {
            Within::Allow => BlockPolicy::Allow,
            Within::Warn => BlockPolicy::Warn,
            Within::Forbid => BlockPolicy::Forbid,
        };
        request
    }

    fn page(&self, answer: &CongruenceAnswer) -> String {
        let name = |degree: usize| match degree {
            0 => "vertices".to_owned(),
            1 => "edges".to_owned(),
            2 => "faces".to_owned(),
            3 => "cells".to_owned(),
            _ => format!("{degree}-cells"),
        };
        let at = |counts: &[usize], degree: usize| counts.get(degree).copied().unwrap_or(0);
        let mut facts = Vec::new();
        for degree in 0..answer.f_vector_before.len().max(answer.f_vector.len()) {
            let [old, new] = [&answer.f_vector_before, &answer.f_vector].map(|counts| at(counts, degree));
            if old == 0 && new == 0 {
                continue;
            }
            let part = |counts: &[usize], word: &str| match at(counts, degree) {
                0 => None,
                count => Some(format!("{} {word}", text::grouped(count))),
            };
            let parts = [part(&answer.discarded, "discarded"), part(&answer.changed, "changed")];
            let gloss: Vec<String> = parts.into_iter().flatten().collect();
            let value = format!("{} from {}", text::grouped(new), text::grouped(old));
            facts.push((name(degree), value, gloss.join(", ")));
        }
        let fact = |label: &str, value: String, gloss: &str| (label.to_owned(), value, gloss.to_owned());
        facts.push(fact("Euler char.", answer.euler_characteristic.to_string(), "of what is left"));
        facts.push(fact(
            "widest class",
            text::rounded(answer.largest_class_diameter, 6),
            "the largest distance of vertices that became one",
        ));
        let is_zero = answer.products_zero;
        facts.push(fact(
            "boundaries",
            if is_zero { "of boundaries are zero" } else { "of boundaries are NOT zero" }.to_owned(),
            "found by multiplying the matrices",
        ));
        if let Some(merges) = answer.merged_within_blocks.filter(|&merges| merges > 0) {
            let gloss = match self.blocks {
                Blocks::Files => "classes with several vertices of one file",
                _ => "classes with several vertices of one component",
            };
            facts.push(fact("within blocks", text::grouped(merges), gloss));
        }
        let title = match &self.inputs[..] {
            [one] => format!("congruence of {} within {}", input::name(one), self.tolerance),
            many => format!("congruence of {} models within {}", many.len(), self.tolerance),
        };
        text::facts(&title, &facts)
    }
}
