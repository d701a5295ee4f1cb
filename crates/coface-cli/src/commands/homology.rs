//! `coface homology`: homology and cohomology groups, generators, classes of cycles.

use crate::arguments::Common;
use crate::chains::{GivenChain, Naming};
use crate::failure::Failure;
use crate::output::{print_json, print_text, write_json};
use crate::progress::Progress;
use crate::{input, text};
use clap::Args;
use coface::algebra::Integer;
use coface::chains::{Chain, ChainComplex};
use coface::io::{self, Format};
use coface::report::{Pair, Producer, groups_to_json, integer_to_json};
use coface::topology::{AbelianGroup, Bounding, Coefficients, Homology as Groups, HomologyBasis, homology};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

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
    /// Reduced: a point has no homology
    #[arg(long, conflicts_with = "relative")]
    reduced: bool,
    /// Homology relative to a subcomplex: boundary, or a file of cells by the same vertex numbers
    #[arg(long, value_name = "boundary|FILE")]
    relative: Option<PathBuf>,
    /// Short cycles (cocycles with --cohomology) that generate the groups: with --json under the key "generators";
    /// written to OUT if given, as .json, or as a picture in .vtk, .obj and other mesh formats
    #[arg(long, value_name = "OUT", num_args = 0..=1)]
    generators: Option<Option<PathBuf>>,
    /// A cycle whose class is wanted, and whether it bounds: cells by their vertices as in "0 1; 1 2; -1*0 2", or a
    /// .json file with [[coefficient,[vertices..]],..]; may be given several times
    #[arg(long, value_name = "CHAIN", conflicts_with_all = ["coefficients", "cohomology"])]
    cycle: Vec<String>,
}

fn ring(name: &str) -> Result<Coefficients, String> {
    name.parse().map_err(|error: coface::Error| error.to_string())
}

impl Homology {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let given: Vec<GivenChain> =
            self.cycle.iter().map(|argument| GivenChain::read(argument)).collect::<Result<_, _>>()?;
        let progress = Progress::start(common.quiet);
        let loaded = input::read(&self.input, common.format, &progress)?;
        let name = loaded.name;
        progress.stage("identifying cells");
        let producer = Producer::of(loaded.model).map_err(|error| error.in_file(name.clone()))?;
        let whole = producer.chain_complex()?;
        let pair = self.pair(&producer, &whole, &progress)?;
        let augmented = if self.reduced { Some(pair.chains().augmented()?) } else { None };
        let complex = augmented.as_ref().unwrap_or(pair.chains());
        let naming = Naming { producer: &producer, pair: &pair, shift: usize::from(self.reduced) };
        progress.stage("computing homology");
        let basis = (self.generators.is_some() || !given.is_empty()).then(|| HomologyBasis::new(complex));
        let integral = basis.as_ref().map_or_else(|| homology(complex), HomologyBasis::homology);
        let groups = self.groups(&integral);
        let mut object = json!({
            "file": name,
            "coefficients": self.coefficients.to_string(),
            "cohomology": self.cohomology,
            "homology": groups_to_json(&groups),
        });
        let mut page = self.page(&name, &groups);
        if let Some(basis) = &basis {
            if let Some(place) = &self.generators {
                progress.stage("finding generators");
                let found = self.generators(basis, &naming);
                object["generators"] = to_json(&found, &naming);
                if let Some(place) = place {
                    save(place, &found, &naming, &whole, &object["generators"])?;
                }
                page += &list(&found, if self.cohomology { "cocycle" } else { "cycle" });
            }
            if !given.is_empty() {
                progress.stage("finding classes");
                let mut verdicts = Vec::new();
                for (argument, given) in self.cycle.iter().zip(&given) {
                    let verdict = self
                        .verdict(given, basis, &naming, &whole)
                        .map_err(|error| error.in_file(argument.clone()))?;
                    page += &format!("    {argument}: {}\n", verdict.words);
                    verdicts.push(verdict.object);
                }
                object["cycles"] = verdicts.into();
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
        print_text(&page)
    }

    /// The chain complex, modulo a subcomplex if one is named.
    fn pair(&self, producer: &Producer, whole: &ChainComplex, progress: &Progress) -> Result<Pair, Failure> {
        let Some(part) = &self.relative else { return Ok(Pair::absolute(whole.clone())) };
        if part.as_os_str() == "boundary" {
            return Ok(Pair::with_boundary(producer, whole)?);
        }
        let part = input::read(part, None, progress)?;
        Ok(Pair::with_model(producer, whole, &part.model).map_err(|error| error.in_file(part.name))?)
    }

    /// The groups asked for, from degree 0 of the model on.
    fn groups(&self, integral: &Groups) -> Vec<AbelianGroup> {
        let groups = match self.cohomology {
            true => integral.dual(self.coefficients),
            false => integral.with_coefficients(self.coefficients),
        };
        groups.groups()[usize::from(self.reduced).min(groups.groups().len())..].to_vec()
    }

    fn generators(&self, basis: &HomologyBasis<'_>, naming: &Naming<'_>) -> Vec<Vec<Found>> {
        let degrees = naming.shift..basis.complex().degree_count();
        let of_degree = |degree| -> Vec<Found> {
            if self.cohomology {
                let cocycles = basis.cocycles_with(degree, self.coefficients).into_iter();
                return cocycles
                    .map(|cocycle| Found {
                        order: cocycle.order().cloned(),
                        degree,
                        terms: cocycle.cochain().terms().to_vec(),
                        bounding: None,
                    })
                    .collect();
            }
            let is_integral = self.coefficients == Coefficients::Integers;
            let generators = basis.generators_with(degree, self.coefficients).into_iter().enumerate();
            generators
                .map(|(i, generator)| Found {
                    order: generator.order().cloned(),
                    degree,
                    terms: generator.chain().terms().to_vec(),
                    bounding: is_integral.then(|| basis.certificate(degree, i)).flatten(),
                })
                .collect()
        };
        degrees.map(of_degree).collect()
    }

    fn verdict(
        &self,
        given: &GivenChain,
        basis: &HomologyBasis<'_>,
        naming: &Naming<'_>,
        whole: &ChainComplex,
    ) -> Result<Verdict, coface::Error> {
        let chain = naming.producer.chain(whole, &given.terms, given.degree)?;
        let cycle = naming.of_model(basis.complex(), &chain)?;
        let class = basis.class_of(&cycle)?;
        let orders: Vec<Value> = basis
            .generators(cycle.degree())
            .iter()
            .map(|generator| generator.order().map_or(Value::from(0), integer_to_json))
            .collect();
        let mut object = json!({
            "degree": chain.degree(),
            "class": class.coefficients().iter().map(integer_to_json).collect::<Vec<_>>(),
            "orders": orders,
            "bounds": class.is_zero(),
            "multiple": class.order().as_ref().map(integer_to_json),
            "bounding": null,
            "cocycle": null,
        });
        let words = match basis.bounding(&cycle)? {
            Bounding::Bounds(chain) => {
                object["bounding"] = naming.terms(chain.degree(), chain.terms());
                format!("bounds a chain of {} cells", chain.terms().len())
            }
            Bounding::MultipleBounds { multiple, chain } => {
                object["bounding"] = naming.terms(chain.degree(), chain.terms());
                format!("does not bound, {multiple} times it bounds a chain of {} cells", chain.terms().len())
            }
            Bounding::Never { cocycle, value } => {
                object["cocycle"] = naming.terms(cocycle.degree(), cocycle.terms());
                object["value"] = integer_to_json(&value);
                format!("does not bound, nor does any multiple: a cocycle has the value {value} on it")
            }
            _ => "of unknown kind".to_owned(),
        };
        let class: Vec<String> = class.coefficients().iter().map(ToString::to_string).collect();
        let words = format!("class ({}) in H_{}; it {words}", class.join(", "), chain.degree());
        Ok(Verdict { object, words })
    }

    fn page(&self, name: &str, groups: &[AbelianGroup]) -> String {
        let what = match (self.reduced, self.cohomology) {
            (false, false) => "homology",
            (false, true) => "cohomology",
            (true, false) => "reduced homology",
            (true, true) => "reduced cohomology",
        };
        let pair =
            self.relative.as_ref().map_or(String::new(), |pair| format!(", relative to {}", pair.display()));
        let symbol = if self.cohomology { "H^" } else { "H_" };
        let title = format!("{what} of {name} over {}{pair}", self.coefficients);
        text::groups(&title, groups, symbol, self.coefficients)
    }
}

/// What is said about a given cycle.
struct Verdict {
    object: Value,
    words: String,
}

/// A generator of homology or cohomology, on the cells of the complex that was asked.
struct Found {
    order: Option<Integer>,
    degree: usize,
    terms: Vec<(coface::CellId, Integer)>,
    /// For a cycle of finite order m the chain with the boundary m times the cycle.
    bounding: Option<Chain<Integer>>,
}

impl Found {
    /// How many cells the cycle runs through, with multiplicity.
    fn length(&self) -> Integer {
        let mut length = Integer::ZERO;
        for (_, coefficient) in &self.terms {
            length += &coefficient.abs();
        }
        length
    }
}

/// The generators of each degree as `[{"order":0,"length":n,"chain":[[coefficient,[vertices..]],..]},..]`, with `"bounding"`
/// where the order is finite.
fn to_json(found: &[Vec<Found>], naming: &Naming<'_>) -> Value {
    let object = |found: &Found| {
        let mut object = json!({
            "order": found.order.as_ref().map_or(Value::from(0), integer_to_json),
            "length": integer_to_json(&found.length()),
            "chain": naming.terms(found.degree, &found.terms),
        });
        if let Some(chain) = &found.bounding {
            object["bounding"] = naming.terms(chain.degree(), chain.terms());
        }
        object
    };
    found.iter().map(|list| list.iter().map(object).collect::<Value>()).collect()
}

/// One line for each generator.
fn list(found: &[Vec<Found>], what: &str) -> String {
    let mut page = String::new();
    for (degree, list) in found.iter().enumerate() {
        for (i, found) in list.iter().enumerate() {
            let order = found.order.as_ref().map_or(String::new(), |order| format!(" of order {order}"));
            let length = found.length();
            let cells = if length == Integer::ONE { "cell" } else { "cells" };
            page += &format!("    generator {i} of degree {degree}: a {what}{order}, {length} {cells}\n");
        }
    }
    page
}

/// Writes generators as JSON, or as a picture in the format that the name tells.
fn save(
    place: &Path,
    found: &[Vec<Found>],
    naming: &Naming<'_>,
    whole: &ChainComplex,
    object: &Value,
) -> Result<(), Failure> {
    if matches!(Format::from_path(place), None | Some(Format::Json)) {
        return write_json(place, &json!({ "generators": object }));
    }
    let mut named = Vec::new();
    for (degree, list) in found.iter().enumerate() {
        for (i, found) in list.iter().enumerate() {
            let order = found.order.as_ref().map_or("free".to_owned(), |order| format!("order_{order}"));
            let chain = naming.to_model(whole, found.degree, &found.terms)?;
            named.push((format!("H{degree}_{i}_{order}"), chain));
        }
    }
    let model = naming.producer.picture(&named)?;
    Ok(io::write_path(&model, place, None)?)
}
