//! `coface persistence`: births and deaths of classes along a filtration.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::filtration::{Function, read_values};
use crate::input;
use crate::output::{is_json, print_json, print_text, write_file, write_json};
use crate::progress::Progress;
use clap::Args;
use coface::answers::Producer;
use coface::answers::answer::{PersistenceAnswer, PersistencePairAnswer};
use coface::answers::text;
use coface::answers::{DiagramFormat, write_diagram};
use coface::topology::{Coefficients, Filtration, PersistenceDiagram, PersistencePair, persistence};
use std::fmt::Write;
use std::path::PathBuf;

/// Persistent homology: which components, loops and cavities are born and die as a model grows.
///
/// The model grows by sublevel sets of a function on vertices (each cell enters with its highest vertex), or by values
/// given for cells. Without --function the function is the last coordinate, the height; without positions it is the
/// vertex number. Pairs of persistence 0 are left out unless --min-persistence says otherwise.
///
/// The file named by -o has the format of its extension: .pers as GUDHI reads, .txt as Ripser prints, .csv, or .json with
/// the keys of --json: "field", "function", "star", "betti", and "diagram", a list of {"degree","birth","death","birth_cell",
/// "death_cell"} where cells are given by their vertices and death is null for a class that stays.
#[derive(Args)]
pub(crate) struct Persistence {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// A prime field: f2, f3, f5, ...
    #[arg(long, value_name = "FIELD", default_value = "f2", value_parser = field)]
    coefficients: Coefficients,
    /// The function on vertices: a coordinate, or a file with one number a line for each vertex
    #[arg(long, value_name = "x|y|z|FILE")]
    function: Option<String>,
    /// Values of cells as JSON: {"values":[[..],..]} with a list for each degree, or {"cells":[[[vertices..],value],..]}
    /// where each cell that is not listed enters with the first cell that it is a face of
    #[arg(long, value_name = "FILE", conflicts_with_all = ["function", "upper_star"])]
    values: Option<PathBuf>,
    /// Grow by superlevel sets, from high values to low ones: each cell enters with its lowest vertex
    #[arg(long)]
    upper_star: bool,
    /// Only pairs whose persistence is greater than R; a negative R keeps all
    #[arg(long, value_name = "R", default_value = "0", allow_negative_numbers = true, value_parser = length)]
    min_persistence: f64,
}

/// How many pairs of a degree the page for people lists.
const LISTED: usize = 8;

fn field(name: &str) -> Result<Coefficients, String> {
    name.parse().map_err(|error: coface::Error| error.to_string())
}

fn length(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|length: &f64| length.is_finite())
        .ok_or_else(|| "not a finite number".to_owned())
}

/// The form of the file to write.
enum Output {
    Json,
    Text(DiagramFormat),
}

impl Persistence {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let output = common.output.as_deref().map(|path| {
            let format = if is_json(path) {
                Some(Output::Json)
            } else {
                DiagramFormat::from_path(path).map(Output::Text)
            };
            let unknown = || {
                Failure::new(format!(
                    "{}: a diagram is written as .pers, .txt, .csv or .json; name the file so",
                    path.display()
                ))
            };
            Ok::<_, Failure>((path, format.ok_or_else(unknown)?))
        });
        let output = output.transpose()?;
        let progress = Progress::start(common.quiet);
        let (name, producer) = input::produce(&self.input, common.reading(), &progress)?;
        let complex = producer.chain_complex()?;
        progress.stage("sorting cells");
        let (function, filtration) = match &self.values {
            Some(path) => (path.display().to_string(), read_values(path, &producer, &complex)?),
            None => {
                let function = Function::choose(self.function.as_deref(), producer.positions())?;
                let values = function.values(&producer, complex.cell_count(0))?;
                let star = if self.upper_star { Filtration::upper_star } else { Filtration::lower_star };
                (function.name(), star(&complex, &values).map_err(|error| error.in_file(name.clone()))?)
            }
        };
        progress.stage("pairing cells");
        let diagram =
            persistence(&complex, &filtration, self.coefficients)?.longer_than(self.min_persistence);
        progress.stage("writing");
        let as_object = || self.answer(&name, &function, &diagram, &producer);
        match output {
            Some((path, Output::Json)) => write_json(path, &as_object())?,
            Some((path, Output::Text(format))) => {
                let mut bytes = Vec::new();
                write_diagram(&diagram, &mut bytes, format)?;
                write_file(path, &bytes)?;
            }
            None => {}
        }
        if common.json {
            let object = as_object();
            drop(progress);
            return print_json(&object);
        }
        drop(progress);
        if common.output.is_some() {
            return Ok(());
        }
        print_text(&self.page(&name, &function, &diagram, &producer))
    }

    /// How cells follow from the function; `None` for given values.
    fn star(&self) -> Option<&'static str> {
        match (&self.values, self.upper_star) {
            (Some(_), _) => None,
            (None, true) => Some("upper"),
            (None, false) => Some("lower"),
        }
    }

    fn answer(
        &self,
        name: &str,
        function: &str,
        diagram: &PersistenceDiagram,
        producer: &Producer,
    ) -> PersistenceAnswer {
        let pair = |pair: &PersistencePair| PersistencePairAnswer {
            degree: pair.degree(),
            birth: pair.birth(),
            death: pair.death(),
            birth_cell: producer.cell_vertices(pair.degree(), pair.birth_cell().index()),
            death_cell: pair.death_cell().map(|cell| producer.cell_vertices(pair.degree() + 1, cell.index())),
        };
        PersistenceAnswer {
            file: name.to_owned(),
            field: diagram.prime(),
            function: function.to_owned(),
            star: self.star().map(str::to_owned),
            diagram: diagram.pairs().iter().map(pair).collect(),
            betti: diagram.betti_numbers(),
            remarks: Vec::new(),
        }
    }

    /// The diagram for people: for each degree the longest pairs.
    fn page(&self, name: &str, function: &str, diagram: &PersistenceDiagram, producer: &Producer) -> String {
        let mut page = format!("  persistence of {name} over {}\n", self.coefficients);
        // Writing to a string does not fail.
        let _ = match self.star() {
            Some(star) => writeln!(page, "    function: {function}, {star} star"),
            None => writeln!(page, "    values: {function}"),
        };
        let cell = |degree, cell: usize| format!("{:?}", producer.cell_vertices(degree, cell));
        for degree in 0..diagram.degree_count() {
            let mut pairs: Vec<&PersistencePair> = diagram.pairs_of_degree(degree).iter().collect();
            let essential = pairs.iter().filter(|pair| pair.is_essential()).count();
            let _ = writeln!(
                page,
                "\n    degree {degree}: {} for ever, {}",
                text::count(essential, "class"),
                text::count(pairs.len() - essential, "pair")
            );
            pairs.sort_by(|a, b| b.persistence().total_cmp(&a.persistence()));
            for pair in pairs.iter().take(LISTED) {
                let born = cell(degree, pair.birth_cell().index());
                let _ = match (pair.death(), pair.death_cell()) {
                    (Some(death), Some(by)) => writeln!(
                        page,
                        "      [{}, {death})  persistence {:.6}, from {born} to {}",
                        pair.birth(),
                        pair.persistence(),
                        cell(degree + 1, by.index())
                    ),
                    _ => writeln!(page, "      [{}, never)  from {born}", pair.birth()),
                };
            }
            if let Some(more) = pairs.len().checked_sub(LISTED).filter(|&more| more > 0) {
                let _ = writeln!(page, "      and {more} more; all with -o or --json");
            }
        }
        page
    }
}
