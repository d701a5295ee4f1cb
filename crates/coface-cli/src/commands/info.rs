//! `coface info`: the report.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{give, is_json};
use crate::progress::Progress;
use crate::text;
use clap::Args;
use coface::io::Format;
use coface::report::Report;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Say what a model is, and what is wrong with it and where.
///
/// The report: counts, dimension, components, Euler characteristic, whether it is a manifold, boundary loops,
/// orientation, genus and name of a surface, integral homology, area, volume and mass properties, and every problem with
/// its place. Center of mass and inertia are those of a solid of density 1, the inertia about the center.
///
/// With --json one input gives one report object; several give {"reports":[..]}, where an input that cannot be served
/// has the keys "file" and "error" alone and the exit status is 1. With -o the report goes to the file, as JSON if its
/// name ends in .json.
#[derive(Args)]
pub(crate) struct Info {
    /// Files to report on; - is standard input
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
    /// List every place of every problem and all boundary loops, not just the first few
    #[arg(long)]
    all: bool,
    /// Integrate x^A y^B z^C over the volume and over the surface; may be given several times
    #[arg(long, value_name = "A,B,C", value_parser = exponents)]
    moment: Vec<[u32; 3]>,
}

/// Three exponents with commas between them.
fn exponents(text: &str) -> Result<[u32; 3], String> {
    let numbers: Option<Vec<u32>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or_else(|| "give three numbers from 0 with commas between them, like 2,0,0".to_owned())
}

/// How many places of a problem JSON lists when not all are asked for.
const PLACES_IN_JSON: usize = 100;

impl Info {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let as_json = common.json || common.output.as_deref().is_some_and(is_json);
        let text_file = common.output.as_deref().is_some_and(|path| !is_json(path));
        let (mut objects, mut page, mut failed) = (Vec::new(), String::new(), false);
        for path in &self.inputs {
            let report = match self.report(path, common, &progress) {
                Ok(report) => report,
                Err(failure) if self.inputs.len() == 1 => return Err(failure),
                Err(failure) => {
                    failed = true;
                    if let Failure::Message(message) = &failure {
                        objects.push(json!({"file": input::name(path), "error": message}));
                    }
                    failure.say();
                    continue;
                }
            };
            if as_json {
                objects.push(self.object(&report));
            }
            if !as_json || text_file {
                if !page.is_empty() {
                    page.push('\n');
                }
                page +=
                    &text::report(&report.name, report.format.title(), &report.report, self.limit(text::FEW));
            }
        }
        drop(progress);
        let object = if self.inputs.len() == 1 {
            objects.pop().unwrap_or_default()
        } else {
            json!({ "reports": objects })
        };
        give(common, &object, &page)?;
        if failed { Err(Failure::Said) } else { Ok(()) }
    }

    fn report(&self, path: &Path, common: &Common, progress: &Progress) -> Result<Named, Failure> {
        let loaded = input::read(path, common.reading(), progress)?;
        progress.stage(format!("examining {}", loaded.name));
        let format = loaded.format;
        let report = Report::with_moments(loaded.model, &self.moment)
            .map_err(|error| error.in_file(loaded.name.clone()))?;
        Ok(Named { name: loaded.name, format, report })
    }

    fn limit(&self, usual: usize) -> usize {
        if self.all { usize::MAX } else { usual }
    }

    fn object(&self, named: &Named) -> Value {
        let mut object = json!({"file": named.name, "format": named.format.name()});
        if let (Value::Object(object), Value::Object(facts)) =
            (&mut object, named.report.to_json(self.limit(PLACES_IN_JSON)))
        {
            object.extend(facts);
        }
        object
    }
}

/// A report with what it is about.
struct Named {
    name: String,
    format: Format,
    report: Report,
}
