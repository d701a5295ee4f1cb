//! `coface homology`: homology and cohomology groups, with generators.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text, write_json};
use crate::progress::Progress;
use crate::{input, text};
use clap::Args;
use coface::algebra::Integer;
use coface::report::{Pair, Producer, groups_to_json, integer_to_json};
use coface::topology::{AbelianGroup, Coefficients, Generator, cohomology, generators, homology_with};
use serde_json::{Value, json};
use std::path::PathBuf;

/// Homology groups: how many components, loops and cavities a model has, and its torsion.
///
/// Exact, over the integers unless --coefficients says otherwise. Over Z/n the "betti" number counts the summands Z/n
/// and "torsion" lists those of smaller order.
#[derive(Args)]
pub(crate) struct Homology {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Z, Q, a prime field or the integers modulo N: z, q, f2, f3, z6, ...
    #[arg(long, value_name = "RING", default_value = "z", value_parser = ring)]
    coefficients: Coefficients,
    /// Cohomology instead of homology
    #[arg(long)]
    cohomology: bool,
    /// Homology relative to a subcomplex: boundary, or a file of cells by the same vertex numbers
    #[arg(long, value_name = "boundary|FILE")]
    relative: Option<PathBuf>,
    /// Cycles that generate the groups over Z: with --json under the key "generators", written to OUT if given
    #[arg(long, value_name = "OUT", num_args = 0..=1)]
    generators: Option<Option<PathBuf>>,
}

fn ring(name: &str) -> Result<Coefficients, String> {
    name.parse().map_err(|error: coface::Error| error.to_string())
}

impl Homology {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if self.generators.is_some() && (self.cohomology || self.coefficients != Coefficients::Integers) {
            return Err(Failure::new(
                "generators are given for homology over the integers only; leave --cohomology and --coefficients away",
            ));
        }
        let progress = Progress::start(common.quiet);
        let loaded = input::read(&self.input, common.format, &progress)?;
        let name = loaded.name;
        progress.stage("identifying cells");
        let producer = Producer::of(loaded.model).map_err(|error| error.in_file(name.clone()))?;
        let pair = self.pair(&producer, &progress)?;
        progress.stage("computing homology");
        let groups = match self.cohomology {
            true => cohomology(pair.chains(), self.coefficients),
            false => homology_with(pair.chains(), self.coefficients),
        };
        let mut object = json!({
            "file": name,
            "coefficients": self.coefficients.to_string(),
            "cohomology": self.cohomology,
            "homology": groups_to_json(groups.groups()),
        });
        if let Some(place) = &self.generators {
            progress.stage("finding generators");
            object["generators"] = generator_lists(&pair, &producer);
            if let Some(place) = place {
                write_json(place, &json!({ "generators": object["generators"] }))?;
            }
        }
        drop(progress);
        if let Some(place) = &common.output {
            write_json(place, &object)?;
        }
        if common.json {
            return print_json(&object);
        }
        if common.output.is_some() {
            return Ok(());
        }
        print_text(&self.page(&name, groups.groups()))
    }

    /// The chain complex, modulo a subcomplex if one is named.
    fn pair(&self, producer: &Producer, progress: &Progress) -> Result<Pair, Failure> {
        let complex = producer.chain_complex()?;
        let Some(part) = &self.relative else { return Ok(Pair::absolute(complex)) };
        if part.as_os_str() == "boundary" {
            return Ok(Pair::with_boundary(&complex)?);
        }
        let part = input::read(part, None, progress)?;
        Ok(Pair::with_model(producer, &complex, &part.model).map_err(|error| error.in_file(part.name))?)
    }

    fn page(&self, name: &str, groups: &[AbelianGroup]) -> String {
        let what = if self.cohomology { "cohomology" } else { "homology" };
        let pair =
            self.relative.as_ref().map_or(String::new(), |pair| format!(", relative to {}", pair.display()));
        let symbol = if self.cohomology { "H^" } else { "H_" };
        let title = format!("{what} of {name} over {}{pair}", self.coefficients);
        text::groups(&title, groups, symbol, self.coefficients)
    }
}

/// The generators of each degree as `[{"order":0,"chain":[[coefficient,[vertices..]],..]},..]`.
fn generator_lists(pair: &Pair, producer: &Producer) -> Value {
    let list = |(degree, found): (usize, Vec<Generator>)| -> Value {
        found.iter().map(|generator| object(generator, degree, pair, producer)).collect()
    };
    generators(pair.chains()).into_iter().enumerate().map(list).collect()
}

fn object(generator: &Generator, degree: usize, pair: &Pair, producer: &Producer) -> Value {
    let term = |(cell, coefficient): &(u32, Integer)| {
        let vertices = producer.cell_vertices(degree, pair.cell(degree, *cell as usize));
        json!([integer_to_json(coefficient), vertices])
    };
    json!({
        "order": generator.order().map_or(Value::from(0), integer_to_json),
        "chain": generator.chain().iter().map(term).collect::<Vec<_>>(),
    })
}
