//! What the verbs on sets of simplices share: naming simplices, and giving the resulting set back.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input::{self, Loaded};
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use crate::remarks;
use crate::target::write_model;
use coface::Error;
use coface::answers::answer::{Place, Remark, RemarkCode, SimplicesAnswer};
use coface::answers::text;
use coface::answers::{model_of_simplices, simplicial_complex};
use coface::complexes::simplicial::{Simplex, SimplexSet, SimplicialComplex};
use coface::io::{Format, Model};
use std::path::Path;
use std::str::FromStr;

/// Simplices as the user writes them: `"0 1; 3"` is the edge {0, 1} and the vertex 3.
#[derive(Clone)]
pub(crate) struct SimplexList(Vec<Vec<u32>>);

impl FromStr for SimplexList {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let simplex = |part: &str| -> Result<Vec<u32>, String> {
            let words = part.split([' ', ',', '\t']).filter(|word| !word.is_empty());
            let vertex = |word: &str| {
                let number = word.strip_prefix('v').unwrap_or(word);
                number.parse().map_err(|_| format!("{word:?} is no vertex: write simplices as \"0 1; 3\""))
            };
            words.map(vertex).collect()
        };
        let parts = text.split([';', '\n']).map(simplex).collect::<Result<Vec<_>, _>>()?;
        Ok(Self(parts.into_iter().filter(|vertices| !vertices.is_empty()).collect()))
    }
}

impl SimplexList {
    /// The simplices; one that repeats a vertex is a fault.
    pub(crate) fn simplices(&self) -> Result<SimplexSet, Error> {
        self.0.iter().map(|vertices| Simplex::from_numbers(vertices)).collect()
    }
}

/// What a verb on sets of simplices is asked.
pub(crate) struct Request<'a> {
    pub(crate) verb: &'a str,
    pub(crate) input: &'a Path,
    /// Without a list, all simplices of the model.
    pub(crate) simplices: Option<&'a SimplexList>,
}

/// All simplices of a model; the vertices of a mesh that no face uses are no facets, and stay out with a remark.
fn all_simplices(complex: &SimplicialComplex, loaded: &Loaded) -> SimplexSet {
    let all = SimplexSet::from(complex);
    if loaded.model.structure().is_some() || complex.dimension().is_none_or(|dimension| dimension == 0) {
        return all;
    }
    let strays: Vec<Simplex> = complex.facets().into_iter().filter(|facet| facet.dimension() == 0).collect();
    if strays.is_empty() {
        return all;
    }
    let message = format!("left out: {} that no face uses", text::count(strays.len(), "vertex"));
    let places = strays.iter().map(|stray| Place::cell(stray.numbers()));
    let remark = Remark::new(RemarkCode::IsolatedVertex, message).at(strays.len(), places);
    remarks::take(&loaded.name, &[remark]);
    all.iter().filter(|simplex| strays.binary_search(simplex).is_err()).cloned().collect()
}

impl Request<'_> {
    /// Reads the model, lets `answer` make a set from the complex and the simplices asked about, and gives it back: as
    /// JSON, as a file, or as text.
    pub(crate) fn serve(
        &self,
        common: &Common,
        answer: impl FnOnce(&SimplicialComplex, &SimplexSet) -> Result<SimplexSet, Error>,
    ) -> Result<(), Failure> {
        self.serve_complex(common, simplicial_complex, answer)
    }

    /// The same of the complex that is made of the model so.
    pub(crate) fn serve_complex(
        &self,
        common: &Common,
        make: impl FnOnce(&Model) -> Result<SimplicialComplex, Error>,
        answer: impl FnOnce(&SimplicialComplex, &SimplexSet) -> Result<SimplexSet, Error>,
    ) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let loaded = input::read(self.input, common.reading(), &progress)?;
        let in_file = |error: Error| error.in_file(loaded.name.clone());
        progress.stage("making the complex");
        let complex = make(&loaded.model).map_err(in_file)?;
        let asked = match self.simplices {
            Some(list) => list.simplices()?,
            None => all_simplices(&complex, &loaded),
        };
        progress.stage(format!("computing the {}", self.verb));
        let set = answer(&complex, &asked).map_err(in_file)?;
        drop(complex);
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            let as_facets = Format::from_path(path) == Some(Format::Json);
            let model = model_of_simplices(&set, &loaded.model, as_facets)?;
            write_model(path, &model)?;
        }
        drop(progress);
        if common.json {
            return print_json(&SimplicesAnswer::of(&loaded.name, &set));
        }
        if common.output.is_some() {
            return Ok(());
        }
        let what = format!("{} in {}", self.verb, loaded.name);
        print_text(&text::simplices(&what, &set))
    }
}
