//! `coface homology`: homology and cohomology groups, generators, classes of cycles, products, sequences and maps.

mod page;
pub(crate) mod parts;

use crate::arguments::{Common, ring};
use crate::certified;
use crate::chains::{chain_of_group, read_chain, read_terms};
use crate::commands::merge::Question;
use crate::domain::{DomainOptions, is_msh};
use crate::failure::Failure;
use crate::input;
use crate::output::{give, print_json, print_text, write_file, write_json};
use crate::pictures::PictureFormat;
use crate::progress::Progress;
use crate::remarks::say_remarks;
use crate::target::write_model;
use crate::written::Written;
use clap::Args;
use coface::answers::answer::GeneratorsFile;
use coface::answers::text;
use coface::answers::{FoundHomology, GivenChain, GivenRealCochain, GivenVertexMap, HomologyRequest};
use coface::io::{Format, Model, ReadOptions};
use coface::pictures::sequence_picture;
use coface::topology::{AbelianGroup, Coefficients};
use parts::PartsOptions;
use serde_json::Value;
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// Homology groups: how many components, loops and cavities a model has, and its torsion.
///
/// Exact, over the integers unless --coefficients says otherwise. Over Z/n the "betti" number counts the summands Z/n
/// and "torsion" lists those of smaller order. With --json the answers to the options stand under the keys "generators",
/// "physical_groups", "cycles", "sequence", "map", "cup", "intersection_form", "harmonic" and "decomposition".
///
/// With -o OUT.msh the mesh is written with its physical groups and one more for each generator, as Gmsh names and
/// writes them: "H_1{1},{70}1" has a cell as an element as often as its coefficient says, turned if it is negative.
/// Cocycles, "H^1{1},{70}1", have their values as data too.
#[derive(Args)]
pub(crate) struct Homology {
    /// The model; - is standard input
    #[arg(value_name = "INPUT", required_unless_present = "grid")]
    input: Option<PathBuf>,
    /// Z, Q, a prime field or the integers modulo N: z, q, f2, f3, z6, ...
    #[arg(long, value_name = "RING", default_value = "z", value_parser = ring)]
    coefficients: Coefficients,
    /// Cohomology instead of homology
    #[arg(long)]
    cohomology: bool,
    /// Reduced: a point has no homology
    #[arg(long, conflicts_with_all = ["relative", "domain"])]
    reduced: bool,
    #[command(flatten)]
    domain: DomainOptions,
    /// The long exact sequence of the pair over Z, with the connecting map; -o OUT.svg, .png or .pdf draws its diagram
    #[arg(long, requires = "relative")]
    sequence: bool,
    /// Short cycles (cocycles with --cohomology) that generate the groups; written to OUT if given: as .json, as physical
    /// groups beside those of the mesh in .msh, or as a picture in .vtk, .obj and other mesh formats
    #[arg(long, value_name = "OUT", num_args = 0..=1)]
    generators: Option<Option<PathBuf>>,
    /// A cycle whose class is wanted, and whether it bounds: cells by their vertices as in "0 1; 1 2; -1*0 2", a
    /// .json file with [[coefficient,[vertices..]],..], or the name of a group of the mesh; may be given several times
    #[arg(long, value_name = "CHAIN", conflicts_with_all = ["coefficients", "cohomology"])]
    cycle: Vec<String>,
    /// Cup products of a basis of cohomology in degree P with one in degree Q, in a basis of degree P + Q
    #[arg(long, value_names = ["P", "Q"], num_args = 2, conflicts_with_all = ["relative", "domain", "reduced"])]
    cup: Option<Vec<usize>>,
    /// The intersection form of a closed oriented manifold of even dimension: rank, signature, parity, determinant
    #[arg(long, conflicts_with_all = ["relative", "domain", "reduced"])]
    intersection_form: bool,
    /// Harmonic representatives of the real cohomology classes, dual to the free generators
    #[arg(long, conflicts_with_all = ["relative", "domain", "reduced"])]
    harmonic: bool,
    /// The Hodge decomposition of a real cochain, a .json file with [[value,[vertices..]],..], into its exact, coexact and
    /// harmonic parts
    #[arg(long, value_name = "FILE", conflicts_with_all = ["relative", "domain", "reduced"])]
    decompose: Option<PathBuf>,
    /// The map on integral homology of a simplicial map, a .json file with pairs [vertex, image], to the model --target
    #[arg(long, value_name = "FILE", requires = "target", conflicts_with_all = ["relative", "domain", "reduced"])]
    map: Option<PathBuf>,
    /// The target of --map
    #[arg(long, value_name = "MODEL", requires = "map")]
    target: Option<PathBuf>,
    /// A certificate of the groups and the generators, which coface check verifies against the input; of a facet list, a chain complex, or a
    /// surface as plain OFF or OBJ; in
    /// the binary form if OUT ends in .bin
    #[arg(long, value_name = "OUT")]
    certificate: Option<PathBuf>,
    #[command(flatten)]
    in_parts: PartsOptions,
}

impl Homology {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if self.in_parts.are_given() {
            Written::Answer.check_output(common)?;
            return self.in_parts.run(
                self.input.as_deref().unwrap_or(Path::new("")),
                &self.question_of_parts()?,
                common,
            );
        }
        if let Some(place) = &self.certificate {
            // Before the work, not after it.
            certified::check_other_output(place, self.input.as_slice(), common)?;
            certified::refuse_standard_input(self.input.as_slice())?;
            // The checker reads the file as it is.
            common.points.refuse("homology with a certificate")?;
        }
        for place in self.generators.iter().flatten() {
            // Before the work, not after it.
            Written::ModelOrJson.check(place)?;
            certified::check_other_output(place, self.input.as_slice(), common)?;
        }
        let mesh_output = common.output.as_deref().filter(|place| is_msh(place));
        let diagram = common.output.as_deref().and_then(|place| Some((place, PictureFormat::of(place)?)));
        if mesh_output.is_none() && diagram.is_none() {
            Written::Answer.check_output(common)?;
        }
        if let Some((place, _)) = diagram.filter(|_| !self.sequence) {
            return Err(Failure::new(format!(
                "{}: a picture of homology is the diagram of a long exact sequence; ask for it with --relative boundary --sequence",
                place.display()
            )));
        }
        let progress = Progress::start(common.quiet);
        let input = self.input.as_deref().ok_or_else(|| Failure::new("no model is named"))?;
        let loaded = input::read(input, common.reading(), &progress)?;
        let is_for_mesh =
            mesh_output.is_some() || self.generators.iter().flatten().any(|place| is_msh(place));
        let request = self.request(&loaded.model, &progress)?.for_mesh(is_for_mesh);
        let found = request.found(&loaded.name, loaded.model)?;
        for place in self.generators.iter().flatten().map(PathBuf::as_path).chain(mesh_output) {
            progress.stage(format!("writing {}", place.display()));
            save_generators(place, &found)?;
        }
        if let Some(place) = &self.certificate {
            progress.stage(format!("proving {}", place.display()));
            let files: Vec<PathBuf> = self.input.iter().chain(self.domain.files()).cloned().collect();
            certified::save(place, &files, |inputs| found.certificate(inputs))?;
        }
        let answer = found.answer();
        if let Some((place, format)) = diagram
            && let Some(sequence) = &answer.sequence
        {
            let (domain, pair) = self.domain.words();
            let title = format!("long exact sequence of {domain}{}{pair}", file_name(&answer.file));
            write_file(place, &format.bytes(&sequence_picture(&title, sequence), None)?)?;
        }
        drop(progress);
        say_remarks(&answer.remarks, common);
        let page = self.page(&answer.file, found.groups())
            + &page::details(answer, found.cell_names(), &self.cycle, self.decompose.as_deref());
        match (mesh_output.is_some() || diagram.is_some(), common.json) {
            (false, _) => give(common, answer, &page),
            (true, true) => print_json(answer),
            (true, false) if common.quiet => Ok(()),
            (true, false) => print_text(&page),
        }
    }

    /// What the command line asks for.
    fn request(&self, model: &Model, progress: &Progress) -> Result<HomologyRequest, Failure> {
        let domain = self.domain.domain(model, progress)?;
        let cycles = self.cycle.iter().map(|argument| {
            let (degree, terms) = match chain_of_group(model, argument) {
                Some(chain) => chain,
                None => read_chain(argument)?,
            };
            Ok(GivenChain { place: format!("--cycle \"{argument}\""), degree, terms })
        });
        let decomposed = self.decompose.as_ref().map(|file| {
            let (degree, terms) = read_terms(file, Value::as_f64)?;
            Ok::<_, Failure>(GivenRealCochain { place: file.display().to_string(), degree, terms })
        });
        let map = self.map.as_ref().zip(self.target.as_ref()).map(|(map, target)| {
            let target = input::read(target, ReadOptions::default(), progress)?;
            Ok::<_, Failure>(GivenVertexMap {
                place: map.display().to_string(),
                images: read_images(map)?,
                target_name: target.name,
                target: target.model,
            })
        });
        let cup = match self.cup.as_deref() {
            Some(&[p, q]) => Some([p, q]),
            _ => None,
        };
        Ok(HomologyRequest::new()
            .coefficients(self.coefficients)
            .cohomology(self.cohomology)
            .reduced(self.reduced)
            .domain(domain.groups)
            .relative(domain.relative)
            .sequence(self.sequence)
            .generators(self.generators.is_some())
            .cycles(cycles.collect::<Result<_, Failure>>()?)
            .cup(cup)
            .intersection_form(self.intersection_form)
            .harmonic(self.harmonic)
            .decomposed(decomposed.transpose()?)
            .map(map.transpose()?)
            .certified(self.certificate.is_some()))
    }

    /// Whether the complex is reduced in parts, which leave files of their own.
    pub(crate) fn is_in_parts(&self) -> bool {
        self.in_parts.are_given()
    }

    /// What is asked of a complex in parts, if parts answer all of it.
    fn question_of_parts(&self) -> Result<Question, Failure> {
        let others = [
            ("--reduced", self.reduced),
            ("--relative", self.domain.has_part()),
            ("--domain", self.domain.has_groups()),
            ("--cycle", !self.cycle.is_empty()),
            ("--cup", self.cup.is_some()),
            ("--intersection-form", self.intersection_form),
            ("--harmonic", self.harmonic),
            ("--decompose", self.decompose.is_some()),
            ("--map", self.map.is_some()),
            ("--certificate", self.certificate.is_some()),
        ];
        if let Some((option, _)) = others.iter().find(|(_, is_given)| *is_given) {
            return Err(Failure::new(format!(
                "{option} needs the whole complex in memory; leave {option} out, or --parts, --memory, --work, --grid \
                 and --simplicial"
            )));
        }
        let Self { coefficients, cohomology, generators, .. } = self;
        Ok(Question { coefficients: *coefficients, cohomology: *cohomology, generators: generators.clone() })
    }

    fn page(&self, name: &str, groups: &[AbelianGroup]) -> String {
        let what = match (self.reduced, self.cohomology) {
            (false, false) => "homology",
            (false, true) => "cohomology",
            (true, false) => "reduced homology",
            (true, true) => "reduced cohomology",
        };
        let (domain, pair) = self.domain.words();
        let symbol = if self.cohomology { "H^" } else { "H_" };
        let title = format!("{what} of {domain}{name} over {}{pair}", self.coefficients);
        text::groups(&title, groups, symbol, self.coefficients)
    }
}

/// The name of a file without its folder: the same picture wherever it lies.
fn file_name(name: &str) -> Cow<'_, str> {
    Path::new(name).file_name().map_or(Cow::Borrowed(name), |name| name.to_string_lossy())
}

/// Writes generators as JSON, into the mesh, or as a picture in the format that the name tells.
fn save_generators(place: &Path, found: &FoundHomology) -> Result<(), Failure> {
    if is_msh(place) {
        let mesh =
            found.mesh_with_generators().map_err(|error| error.in_file(place.display().to_string()))?;
        return write_model(place, &mesh);
    }
    if matches!(Format::from_path(place), None | Some(Format::Json)) {
        let generators = found.answer().generators.clone().unwrap_or_default();
        return write_json(place, &GeneratorsFile { generators });
    }
    write_model(place, &found.generators_model()?)
}

/// Pairs of a vertex and its image, from a list of pairs or under the key "vertices".
fn read_images(path: &Path) -> Result<Vec<(u32, u32)>, Failure> {
    let place = path.display();
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::new(format!("{place}: cannot be read: {error}")))?;
    let how = "write a map of vertices as [[vertex,image],..]";
    let value: Value = serde_json::from_str(&text)
        .map_err(|error| Failure::new(format!("{place}:{}: {error}; {how}", error.line())))?;
    let list = value.get("vertices").unwrap_or(&value);
    let list =
        list.as_array().ok_or_else(|| Failure::new(format!("{place}: there is no list of pairs; {how}")))?;
    let number = |value: &Value| u32::try_from(value.as_u64()?).ok();
    let pair = |(i, value): (usize, &Value)| {
        let pair = value.as_array().filter(|pair| pair.len() == 2);
        pair.and_then(|pair| Some((number(&pair[0])?, number(&pair[1])?)))
            .ok_or_else(|| Failure::new(format!("{place}: pair {i} is {value}; {how}")))
    };
    list.iter().enumerate().map(pair).collect()
}
