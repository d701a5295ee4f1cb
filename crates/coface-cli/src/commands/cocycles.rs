//! `coface cocycles`: first cohomology.

use crate::arguments::Common;
use crate::chains::{Naming, read_terms};
use crate::failure::Failure;
use crate::output::{is_json, print_json, print_text, remark, write_json};
use crate::progress::Progress;
use crate::{input, surface};
use clap::{Args, ValueEnum};
use coface::algebra::chains::{Chain, ChainComplex, Cochain, TwoSkeleton};
use coface::algebra::{Integer, RaggedArray, Sign};
use coface::answers::text;
use coface::answers::{Producer, edge_lengths, integer_to_json};
use coface::complexes::surface::GeneralizedMap;
use coface::io::{CellData, Format, GroupKind, Model, write_path};
use coface::topology::{
    ClosedWalk, CocycleBasis, Exactness, HarmonicForm, HomologyBasis, SurfaceHomology, TreeCotree,
    cotangent_weights, exactness, exactness_within, harmonic_forms,
};
use coface::{EdgeId, Error, VertexId};
use serde_json::{Value, json};
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
    /// Say whether a cochain is closed and exact: a .json file with [[value, [vertex, vertex]], ..]
    #[arg(long, value_name = "FILE")]
    test: Option<PathBuf>,
    /// With --test of a cochain that is not of integers: sums up to this absolute value count as zero
    #[arg(long, value_name = "R", requires = "test")]
    tolerance: Option<f64>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Weights {
    Cotangent,
    Uniform,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Method {
    Crossing,
    Slicing,
    General,
}

/// Cocycles with the loops that they are measured on.
struct Found {
    method: &'static str,
    cocycles: Vec<Cochain<Integer>>,
    /// The vertices of the loops, closed, or chains where they come as such.
    loops: Vec<Value>,
    loop_lengths: Vec<usize>,
    pairing: Vec<Vec<Integer>>,
    determinant: Option<Integer>,
    intersection: Option<(Vec<Vec<i64>>, Option<Integer>)>,
}

impl Cocycles {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let (name, producer) = input::produce(&self.input, common.reading(), &progress)?;
        let in_file = |error: Error| error.in_file(name.clone());
        let skeleton = producer.two_skeleton().map_err(in_file)?;
        let naming = Naming { producer: &producer, pair: None, shift: 0 };
        if let Some(file) = &self.test {
            progress.stage("testing");
            let (object, page) = self.tested(file, &name, &skeleton, &naming)?;
            drop(progress);
            return crate::output::give(common, &object, &page);
        }
        let map = match (self.method, GeneralizedMap::new(skeleton)) {
            (Some(Method::General), _) => None,
            (_, Ok(map)) => Some(map),
            (None, Err(_)) => None,
            (Some(_), Err(error)) => {
                let error = error.with_cure("take --method general, which serves for every model");
                return Err(in_file(error).into());
            }
        };
        let lengths = map.as_ref().and_then(|map| edge_lengths(map.skeleton(), producer.positions()));
        progress.stage("finding cocycles");
        let found = match &map {
            Some(map) => self.on_surface(map, lengths.as_deref(), &naming).map_err(in_file)?,
            None => general(&producer.chain_complex()?, &naming)?,
        };
        let mut object = json!({
            "file": name,
            "method": found.method,
            "rank": found.cocycles.len(),
            "pairing": matrix(&found.pairing),
            "determinant": found.determinant.as_ref().map(integer_to_json),
            "loops": found.loops,
            "cocycles": found.cocycles.iter().map(|c| naming.terms(1, c.terms())).collect::<Vec<_>>(),
        });
        if let Some((numbers, determinant)) = &found.intersection {
            object["intersection"] =
                json!({"matrix": numbers, "determinant": determinant.as_ref().map(integer_to_json)});
        }
        let mut forms = Vec::new();
        if self.harmonic {
            progress.stage("spreading harmonic forms");
            let Some(map) = &map else {
                return Err(Failure::new(format!(
                    "{name}: harmonic one-forms with weights are for surfaces; coface homology --cohomology --harmonic serves here"
                )));
            };
            let (weights, found_forms) =
                self.forms(map, &found.cocycles, lengths.as_deref(), common).map_err(in_file)?;
            forms = found_forms;
            object["weights"] = json!(weights);
            let edges = 0..map.skeleton().edge_count();
            object["edges"] = edges.map(|edge| json!(naming.vertices(1, edge))).collect();
            object["harmonic"] = forms.iter().map(form_to_json).collect();
        }
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            if is_json(path) {
                write_json(path, &object)?;
            } else {
                let complex = producer.chain_complex()?;
                let model = model(&producer, &complex, &found.cocycles, &forms)
                    .map_err(|error| error.in_file(path.display().to_string()))?;
                write_path(&model, path, None)?;
                let format = Format::from_path(path).filter(|format| !format.keeps_data() && !common.quiet);
                if let Some(format) = format {
                    remark(&format!(
                        "{} does not keep data on cells, so it has no values; .ply and .vtk do",
                        format.title()
                    ));
                }
            }
        }
        drop(progress);
        match (common.json, &common.output) {
            (true, _) => print_json(&object),
            (false, Some(_)) if common.quiet => Ok(()),
            (false, _) => print_text(&page(&name, &found, &forms, &object)),
        }
    }

    fn on_surface(
        &self,
        map: &GeneralizedMap,
        lengths: Option<&[f64]>,
        naming: &Naming<'_>,
    ) -> Result<Found, Error> {
        let trees = match lengths {
            Some(_) => TreeCotree::greedy(map, None, lengths)?,
            None => TreeCotree::new(map),
        };
        let homology = SurfaceHomology::new(map, &trees);
        let orientation = map.orientation();
        let is_closed = map.sides().all(|side| map.mate(side).is_some());
        let is_orientable = orientation.conflicts().iter().all(Option::is_none);
        let sliced = if (is_closed && is_orientable) || self.method == Some(Method::Slicing) {
            Some(CocycleBasis::by_slicing(map, homology.loops())?)
        } else {
            None
        };
        let (method, basis) = match (self.method, &sliced) {
            (Some(Method::Slicing), Some(sliced)) => ("slicing", sliced.dual()?),
            _ => ("crossing", CocycleBasis::by_crossing(&homology)),
        };
        let number = |vertex: VertexId| naming.vertices(0, vertex.index())[0];
        let ends = map.skeleton().edge_ends();
        let vertices = |walk: &ClosedWalk| -> Value {
            let first = number(walk.start());
            let rest = walk.steps().iter().map(|&step| number(VertexId::from_u32(ends[(step ^ 1) as usize])));
            std::iter::once(first).chain(rest).collect()
        };
        Ok(Found {
            method,
            loops: basis.loops().iter().map(vertices).collect(),
            loop_lengths: basis.loops().iter().map(ClosedWalk::len).collect(),
            pairing: basis
                .pairing()
                .iter()
                .map(|row| row.iter().map(|&x| Integer::from(x)).collect())
                .collect(),
            determinant: basis.determinant().cloned(),
            cocycles: basis.cocycles().to_vec(),
            intersection: sliced
                .filter(|_| is_closed && is_orientable)
                .map(|sliced| (sliced.pairing().to_vec(), sliced.determinant().cloned())),
        })
    }

    /// The harmonic forms and the name of the weights.
    fn forms(
        &self,
        map: &GeneralizedMap,
        cocycles: &[Cochain<Integer>],
        lengths: Option<&[f64]>,
        common: &Common,
    ) -> Result<(&'static str, Vec<HarmonicForm>), Error> {
        let uniform = || vec![1.0; map.skeleton().edge_count()];
        if self.weights == Some(Weights::Uniform) || cocycles.is_empty() {
            return Ok(("uniform", harmonic_forms(map, cocycles, &uniform())?));
        }
        let found = match lengths {
            None => Err(Error::invalid("the model has no positions, so angles have no cotangents")
                .with_cure("take --weights uniform")),
            Some(lengths) => {
                cotangent_weights(map, lengths).and_then(|weights| harmonic_forms(map, cocycles, &weights))
            }
        };
        match found {
            Ok(forms) => Ok(("cotangent", forms)),
            Err(error) if self.weights.is_some() => Err(error),
            Err(error) => {
                if !common.quiet {
                    remark(&format!("uniform weights are taken: {}", error.message()));
                }
                Ok(("uniform", harmonic_forms(map, cocycles, &uniform())?))
            }
        }
    }

    /// Whether a cochain from a file is closed and exact.
    fn tested(
        &self,
        file: &Path,
        name: &str,
        skeleton: &TwoSkeleton,
        naming: &Naming<'_>,
    ) -> Result<(Value, String), Failure> {
        let complex = naming.producer.chain_complex()?;
        let in_file = |error: Error| Failure::from(error.in_file(file.display().to_string()));
        let integer = |value: &Value| match value {
            Value::String(digits) => digits.parse::<Integer>().ok(),
            number => number.to_string().parse().ok(),
        };
        // Integers are decided exactly.
        let (degree, values) = read_terms(file, |value| integer(value).map(Ok).or(value.as_f64().map(Err)))?;
        let lists = values.iter().map(|(_, vertices)| &vertices[..]);
        let (degree, cells) =
            naming.producer.oriented_cells(&complex, lists, degree.or(Some(1))).map_err(in_file)?;
        if degree != 1 {
            return Err(Failure::new(format!(
                "{}: a cochain of degree {degree}; one of degree 1 is asked for",
                file.display()
            )));
        }
        let terms = cells.into_iter().zip(&values).map(|((cell, sign), (value, _))| (cell, sign, value));
        let walk_vertices = |walk: &ClosedWalk| -> Vec<u32> {
            let ends = skeleton.edge_ends();
            let vertices = std::iter::once(walk.start())
                .chain(walk.steps().iter().map(|&step| VertexId::from_u32(ends[(step ^ 1) as usize])));
            vertices.map(|vertex| naming.vertices(0, vertex.index())[0]).collect()
        };
        let is_integral = values.iter().all(|(value, _)| value.is_ok());
        let (closed, certificate, words) = if is_integral {
            let terms = terms.map(|(cell, sign, value)| {
                let value = value.clone().unwrap_or_default();
                (cell, if sign == Sign::Plus { value } else { -value })
            });
            let cochain = Cochain::new(&complex, 1, terms).map_err(in_file)?;
            match exactness(skeleton, &cochain).map_err(in_file)? {
                Exactness::Exact { potential } => {
                    (true, json!({"potential": naming.terms(0, potential.terms())}), None)
                }
                Exactness::Closed { walk, period } => (
                    true,
                    json!({"walk": walk_vertices(&walk), "period": integer_to_json(&period)}),
                    Some((period.to_string(), walk_vertices(&walk))),
                ),
                Exactness::NotClosed { face, sum } => (
                    false,
                    json!({"face": naming.vertices(2, face.index()), "sum": integer_to_json(&sum)}),
                    Some((sum.to_string(), naming.vertices(2, face.index()))),
                ),
                _ => return Err(Failure::new("an answer that is not known here")),
            }
        } else {
            let Some(tolerance) = self.tolerance else {
                return Err(Failure::new(format!(
                    "{}: the values are not all integers; say with --tolerance which sums count as zero",
                    file.display()
                )));
            };
            let terms = terms.map(|(cell, sign, value)| {
                let value = match value {
                    Ok(integer) => integer.to_string().parse().unwrap_or(f64::NAN),
                    Err(real) => *real,
                };
                (cell, if sign == Sign::Plus { value } else { -value })
            });
            let cochain = Cochain::new(&complex, 1, terms).map_err(in_file)?;
            match exactness_within(skeleton, &cochain, tolerance).map_err(in_file)? {
                Exactness::Exact { potential } => {
                    let terms = potential.terms().iter();
                    let terms = terms.map(|(cell, x)| json!([x, naming.vertices(0, cell.index())]));
                    (true, json!({"potential": terms.collect::<Vec<_>>()}), None)
                }
                Exactness::Closed { walk, period } => (
                    true,
                    json!({"walk": walk_vertices(&walk), "period": period}),
                    Some((period.to_string(), walk_vertices(&walk))),
                ),
                Exactness::NotClosed { face, sum } => (
                    false,
                    json!({"face": naming.vertices(2, face.index()), "sum": sum}),
                    Some((sum.to_string(), naming.vertices(2, face.index()))),
                ),
                _ => return Err(Failure::new("an answer that is not known here")),
            }
        };
        let is_exact = closed && words.is_none();
        let mut object = json!({"file": name, "closed": closed, "exact": is_exact});
        if let (Some(object), Value::Object(certificate)) = (object.as_object_mut(), certificate) {
            object.extend(certificate);
        }
        let fact = |label: &str, value: String, gloss: &str| (label.to_owned(), value, gloss.to_owned());
        let yes = |is: bool| if is { "yes" } else { "no" }.to_owned();
        let mut facts = vec![
            fact("closed", yes(closed), "the sum around each face is zero"),
            fact("exact", yes(is_exact), "it is the difference of a function on the vertices"),
        ];
        if let Some((sum, vertices)) = words {
            let (few, more) = surface::few(vertices.len());
            let way: Vec<String> = vertices.iter().take(few).map(ToString::to_string).collect();
            let dots = if more > 0 { " .." } else { "" };
            let label = if closed { "along" } else { "around face" };
            facts.push(fact(label, format!("{}{dots}", way.join(" ")), &format!("the sum is {sum}")));
        }
        Ok((object, text::facts(&format!("{} on {name}", file.display()), &facts)))
    }
}

/// The cocycles of a basis of homology, on the free loops of that basis.
fn general(complex: &ChainComplex, naming: &Naming<'_>) -> Result<Found, Failure> {
    let basis = HomologyBasis::new(complex);
    if complex.degree_count() < 2 {
        let none = Found {
            method: "general",
            cocycles: Vec::new(),
            loops: Vec::new(),
            loop_lengths: Vec::new(),
            pairing: Vec::new(),
            determinant: Some(Integer::ONE),
            intersection: None,
        };
        return Ok(none);
    }
    let loops: Vec<&Chain<Integer>> = basis
        .generators(1)
        .iter()
        .filter(|generator| generator.order().is_none())
        .map(|generator| generator.chain())
        .collect();
    let cocycles: Vec<Cochain<Integer>> = basis
        .cocycles(1)
        .into_iter()
        .filter(|cocycle| cocycle.order().is_none())
        .map(|cocycle| cocycle.cochain().clone())
        .collect();
    let mut pairing = Vec::with_capacity(cocycles.len());
    for cocycle in &cocycles {
        let value = |chain: &&Chain<Integer>| Ok(cocycle.pairing(chain)?.unwrap_or_default());
        pairing.push(loops.iter().map(value).collect::<Result<Vec<Integer>, Error>>()?);
    }
    let one = |i: usize, j: usize| if i == j { Integer::ONE } else { Integer::ZERO };
    let is_identity = pairing.len() == loops.len()
        && pairing.iter().enumerate().all(|(i, row)| row.iter().enumerate().all(|(j, x)| *x == one(i, j)));
    Ok(Found {
        method: "general",
        loops: loops.iter().map(|chain| json!(naming.terms(1, chain.terms()))).collect(),
        loop_lengths: loops.iter().map(|chain| chain.terms().len()).collect(),
        cocycles,
        pairing,
        determinant: is_identity.then_some(Integer::ONE),
        intersection: None,
    })
}

fn matrix(rows: &[Vec<Integer>]) -> Value {
    rows.iter().map(|row| row.iter().map(integer_to_json).collect::<Value>()).collect()
}

/// The values on the edges, in the order of "edges".
fn form_to_json(form: &HarmonicForm) -> Value {
    json!({
        "values": form.values().as_slice(),
        "closed_residual": form.closed_residual(),
        "coclosed_residual": form.coclosed_residual(),
    })
}

/// The model with all edges as lines and the values on them.
fn model(
    producer: &Producer,
    complex: &ChainComplex,
    cocycles: &[Cochain<Integer>],
    forms: &[HarmonicForm],
) -> Result<Model, Error> {
    if producer.positions().is_empty() || !producer.names_cells_by_vertices() {
        return Err(Error::invalid("the edges of the model have no positions to draw them at")
            .with_cure("write the cocycles as .json"));
    }
    let count = |degree: usize| if degree < complex.degree_count() { complex.cell_count(degree) } else { 0 };
    let cells = |degree: usize| {
        RaggedArray::from_lists((0..count(degree)).map(|cell| producer.cell_vertices(degree, cell)))
    };
    let mut model = Model::from_polygons(producer.positions().clone(), cells(2))?.with_lines(cells(1))?;
    for (cocycle, number) in cocycles.iter().zip(1..) {
        let mut values = vec![0i64; count(1)];
        for (edge, value) in cocycle.terms() {
            values[edge.index()] = value.to_i64().ok_or_else(|| {
                Error::invalid(format!("cocycle {number} has the value {value} on an edge, beyond 64 bits"))
                    .with_cure("write the cocycles as .json")
            })?;
        }
        let name = format!("cocycle_{number}");
        model = model.with_data(CellData::integers(name, GroupKind::Lines, 1, values)?)?;
    }
    for (form, number) in forms.iter().zip(1..) {
        let values = (0..count(1)).map(|edge| form.values()[EdgeId::new(edge)]).collect();
        let name = format!("harmonic_{number}");
        model = model.with_data(CellData::reals(name, GroupKind::Lines, 1, values)?)?;
    }
    Ok(model)
}

fn page(name: &str, found: &Found, forms: &[HarmonicForm], object: &Value) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    fact("rank", found.cocycles.len().to_string(), "of the first cohomology over Z");
    fact("method", found.method.to_owned(), "");
    let gloss = match &found.determinant {
        Some(_) => "dual to the loops: the matrix of values is the identity",
        None => "there are more loops than cocycles: they have a relation",
    };
    fact("loops", found.loops.len().to_string(), gloss);
    let (few, more) = surface::few(found.cocycles.len());
    for (i, cocycle) in found.cocycles.iter().take(few).enumerate() {
        let length = found
            .loop_lengths
            .get(i)
            .map_or(String::new(), |&edges| format!("its loop has {}", text::count(edges, "edge")));
        let value = format!("{}: on {}", i + 1, text::count(cocycle.terms().len(), "edge"));
        fact(if i == 0 { "cocycles" } else { "" }, value, &length);
    }
    if more > 0 {
        fact("", format!("and {more} more (--json lists all)"), "");
    }
    if let Some((numbers, determinant)) = &found.intersection {
        let determinant = determinant.as_ref().map_or_else(|| "?".to_owned(), Integer::to_string);
        fact("intersections", format!("determinant {determinant}"), "of the loops with each other");
        if numbers.len() <= 10 {
            for row in numbers {
                fact("", row.iter().map(|x| format!("{x:>3}")).collect::<Vec<_>>().join(" "), "");
            }
        }
    }
    if !forms.is_empty() {
        let worst = |residual: fn(&HarmonicForm) -> f64| forms.iter().map(residual).fold(0.0, f64::max);
        let weights = object["weights"].as_str().unwrap_or_default();
        fact("harmonic forms", format!("{}, {weights} weights", forms.len()), "");
        fact("", format!("{:.1e}", worst(HarmonicForm::closed_residual)), "largest sum around a face");
        fact("", format!("{:.1e}", worst(HarmonicForm::coclosed_residual)), "largest sum at a vertex");
    }
    text::facts(&format!("first cohomology of {name}"), &facts)
}
