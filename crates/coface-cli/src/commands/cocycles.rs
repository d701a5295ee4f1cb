//! `coface cocycles`: first cohomology.

use crate::arguments::Common;
use crate::certified;
use crate::chains::{chain_of_group, read_terms};
use crate::domain::{DomainOptions, is_msh};
use crate::failure::Failure;
use crate::output::{is_json, print_json, print_text, write_json};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::target::write_model;
use crate::written::Written;
use crate::{input, surface};
use clap::{Args, ValueEnum};
use coface::Error;
use coface::algebra::Integer;
use coface::answers::answer::{
    CochainTestAnswer, CocycleBasisMethod, CocyclesAnswer, EdgeWeights, HarmonicFormAnswer, Remark,
    RemarkCode,
};
use coface::answers::{CocyclesRequest, GivenCochain, tested_cochain, text};
use coface::io::{Format, Model};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A basis of the first cohomology: integers on the edges whose sum around each face is zero, dual to loops.
///
/// On a surface the loops are those of a tree-cotree decomposition, and cocycle i has the value 1 on loop i and 0 on the others.
/// A closed surface that is not orientable has one cocycle less than loops. On closed orientable surfaces
/// "intersection" is the matrix of intersection numbers of the loops, which slicing along them gives.
///
/// The mesh written with -o has all edges as lines, with the values as data: "cocycle_1", .. and "harmonic_1", ..; a
/// value belongs to the direction of the line. Formats that keep data are .ply and .vtk; .json has the answer, in which
/// the values of harmonic forms stand in the order of "edges".
#[derive(Args)]
pub(crate) struct Cocycles {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Harmonic one-forms of the classes too: of all cochains of a class that with the least energy
    #[arg(long)]
    harmonic: bool,
    /// The energy: cotangent, of triangles in space, or uniform; by default cotangent where it serves
    #[arg(long, value_enum, requires = "harmonic")]
    weights: Option<Weights>,
    /// How: crossing the faces between (surfaces), slicing along loops (closed orientable surfaces), or general, the reduction of
    /// the chain complex (any model) [default: crossing on surfaces, else general]
    #[arg(long, value_enum)]
    method: Option<Method>,
    #[command(flatten)]
    domain: DomainOptions,
    /// Say whether a cochain on the whole model is closed and exact: a .json file with [[value, [vertex, vertex]], ..], or
    /// the name of a group of lines of the mesh
    #[arg(long, value_name = "FILE")]
    test: Option<PathBuf>,
    /// With --test of a cochain that is not of integers: sums up to this absolute value count as zero
    #[arg(long, value_name = "R", requires = "test")]
    tolerance: Option<f64>,
    /// A certificate of the basis, which coface check verifies: rank, closedness, values on loops, and that it is a basis over Z; of a facet list, or
    /// a surface as plain OFF or OBJ; in
    /// the binary form if OUT ends in .bin
    #[arg(long, value_name = "OUT", conflicts_with_all = ["test", "relative", "domain"])]
    certificate: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Weights {
    Cotangent,
    Uniform,
}

impl From<Weights> for EdgeWeights {
    fn from(weights: Weights) -> Self {
        match weights {
            Weights::Cotangent => Self::Cotangent,
            Weights::Uniform => Self::Uniform,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Method {
    Crossing,
    Slicing,
    General,
}

impl From<Method> for CocycleBasisMethod {
    fn from(method: Method) -> Self {
        match method {
            Method::Crossing => Self::Crossing,
            Method::Slicing => Self::Slicing,
            Method::General => Self::General,
        }
    }
}

impl Cocycles {
    /// What goes into the file of -o.
    pub(crate) fn written(&self) -> Written {
        if self.test.is_some() { Written::Answer } else { Written::Model }
    }

    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if let Some(place) = &self.certificate {
            certified::check_place(place, std::slice::from_ref(&self.input), "cocycles", common)?;
        }
        let progress = Progress::start(common.quiet);
        let loaded = input::read(&self.input, common.reading(), &progress)?;
        let domain = self.domain.domain(&loaded.model, &progress)?;
        let given = self.test.as_ref().map(|file| self.given(file, &loaded.model)).transpose()?;
        let is_for_mesh = common.output.as_deref().is_some_and(is_msh);
        let mesh = (is_for_mesh || domain.has_groups()).then(|| loaded.model.clone());
        let (name, producer) = input::identify(loaded, &progress)?;
        if let (Some(file), Some((degree, given))) = (&self.test, given) {
            progress.stage("testing");
            let answer = tested_cochain(&producer, &given, degree, &name)
                .map_err(|error| error.in_file(file.display().to_string()))?;
            drop(progress);
            return crate::output::give(common, &answer, &page_of_test(file, &answer));
        }
        let request = CocyclesRequest::new()
            .method(self.method.map(CocycleBasisMethod::from))
            .harmonic(self.harmonic)
            .weights(self.weights.map(EdgeWeights::from))
            .domain(domain, mesh);
        let found = request.found(&producer).map_err(|error| in_words(error).in_file(name.clone()))?;
        accept(found.remarks(), common)?;
        say_remarks(found.remarks(), common);
        if let Some(place) = &self.certificate {
            progress.stage(format!("proving {}", place.display()));
            certified::save(place, std::slice::from_ref(&self.input), |inputs| found.certificate(inputs))?;
        }
        let mut answer = found.answer(&name);
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            if is_json(path) {
                write_json(path, &answer)?;
            } else if is_for_mesh {
                let mesh =
                    found.mesh_with_cocycles().map_err(|error| error.in_file(path.display().to_string()))?;
                write_model(path, &mesh)?;
            } else {
                let model = found.model().map_err(|error| error.in_file(path.display().to_string()))?;
                write_model(path, &model)?;
                if let Some(format) = Format::from_path(path).filter(|format| !format.keeps_data()) {
                    let title = format.title();
                    let message =
                        format!("{title} does not keep data on cells, so it has no values; .ply and .vtk do");
                    let remark = Remark::new(RemarkCode::FormatKeepsLess, message);
                    say_remarks(std::slice::from_ref(&remark), common);
                    answer.remarks.push(remark);
                }
            }
        }
        drop(progress);
        match (common.json, &common.output) {
            (true, _) => print_json(&answer),
            (false, Some(_)) if common.quiet => Ok(()),
            (false, _) => print_text(&page(&answer)),
        }
    }

    /// The cochain of a group or a file that is to be tested, with its degree if that is known.
    fn given(&self, file: &Path, model: &Model) -> Result<(Option<usize>, GivenCochain), Failure> {
        if let Some((degree, terms)) = file.to_str().and_then(|name| chain_of_group(model, name)) {
            return Ok((degree, GivenCochain::Whole(terms)));
        }
        let integer = |value: &Value| match value {
            Value::String(digits) => digits.parse::<Integer>().ok(),
            number => number.to_string().parse().ok(),
        };
        // Integers are decided exactly.
        let (degree, values) = read_terms(file, |value| integer(value).map(Ok).or(value.as_f64().map(Err)))?;
        let whole: Option<Vec<(Integer, Vec<u32>)>> = values
            .iter()
            .map(|(value, vertices)| Some((value.as_ref().ok()?.clone(), vertices.clone())))
            .collect();
        let given = match (whole, self.tolerance) {
            (Some(terms), _) => GivenCochain::Whole(terms),
            (None, Some(tolerance)) => {
                let real = |value: Result<Integer, f64>| match value {
                    Ok(integer) => integer.to_string().parse().unwrap_or(f64::NAN),
                    Err(real) => real,
                };
                let terms = values.into_iter().map(|(value, vertices)| (real(value), vertices));
                GivenCochain::Real { terms: terms.collect(), tolerance }
            }
            (None, None) => {
                return Err(Failure::new(format!(
                    "{}: the values are not all integers; say with --tolerance which sums count as zero",
                    file.display()
                )));
            }
        };
        Ok((degree, given))
    }
}

/// An error with the cure in the words of the command line.
fn in_words(error: Error) -> Error {
    let cure = match error.cure() {
        Some(cure) if cure.contains("the method general") => {
            "take --method general, which serves for every model"
        }
        Some(cure) if cure.starts_with("take the cocycles by crossing") => "take --method crossing",
        Some("take uniform weights") => "take --weights uniform",
        _ => return error,
    };
    error.with_cure(cure)
}

fn page_of_test(file: &Path, answer: &CochainTestAnswer) -> String {
    let fact = |label: &str, value: String, gloss: &str| (label.to_owned(), value, gloss.to_owned());
    let yes = |is: bool| if is { "yes" } else { "no" }.to_owned();
    let mut facts = vec![
        fact(
            "closed",
            yes(answer.closed),
            match answer.closed {
                true => "the sum around each face is zero",
                false => "the sum around some face is not zero",
            },
        ),
        fact(
            "exact",
            yes(answer.exact),
            match answer.exact {
                true => "it is the difference of a function on the vertices",
                false => "it is not the difference of a function on the vertices",
            },
        ),
    ];
    let walk = answer.walk.as_ref().zip(answer.period.as_ref()).map(|found| ("along", found));
    let face = answer.face.as_ref().zip(answer.sum.as_ref()).map(|found| ("around face", found));
    if let Some((label, (vertices, sum))) = walk.or(face) {
        let (few, more) = surface::few(vertices.len());
        let way: Vec<String> = vertices.iter().take(few).map(ToString::to_string).collect();
        let dots = if more > 0 { " .." } else { "" };
        facts.push(fact(label, format!("{}{dots}", way.join(" ")), &format!("the sum is {sum}")));
    }
    text::facts(&format!("{} on {}", file.display(), answer.file), &facts)
}

fn page(answer: &CocyclesAnswer) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    fact("rank", answer.rank.to_string(), "of the first cohomology over Z");
    fact("method", answer.method.name().to_owned(), "");
    let gloss = match &answer.determinant {
        Some(_) => "dual to the loops: the matrix of values is the identity",
        None => "there are more loops than cocycles: they have a relation",
    };
    fact("loops", answer.loops.len().to_string(), gloss);
    let (few, more) = surface::few(answer.cocycles.len());
    for (i, cocycle) in answer.cocycles.iter().take(few).enumerate() {
        let length = answer.loops.get(i).map_or(String::new(), |found| {
            format!("its loop has {}", text::count(found.edge_count(), "edge"))
        });
        let value = format!("{}: on {}", i + 1, text::count(cocycle.len(), "edge"));
        fact(if i == 0 { "cocycles" } else { "" }, value, &length);
    }
    if more > 0 {
        fact("", format!("and {more} more (--json lists all)"), "");
    }
    if let Some(found) = &answer.intersection {
        let determinant = found.determinant.as_ref().map_or_else(|| "?".to_owned(), ToString::to_string);
        fact("intersections", format!("determinant {determinant}"), "of the loops with each other");
        if found.matrix.len() <= 10 {
            for row in &found.matrix {
                fact("", row.iter().map(|x| format!("{x:>3}")).collect::<Vec<_>>().join(" "), "");
            }
        }
    }
    if let (Some(forms), Some(weights)) = (&answer.harmonic, answer.weights)
        && !forms.is_empty()
    {
        let worst = |residual: fn(&HarmonicFormAnswer) -> f64| forms.iter().map(residual).fold(0.0, f64::max);
        fact("harmonic forms", format!("{}, {} weights", forms.len(), weights.name()), "");
        fact("", format!("{:.1e}", worst(|form| form.closed_residual)), "largest sum around a face");
        fact("", format!("{:.1e}", worst(|form| form.coclosed_residual)), "largest sum at a vertex");
    }
    text::facts(&format!("first cohomology of {}", answer.file), &facts)
}
