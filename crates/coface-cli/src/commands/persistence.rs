//! `coface persistence`: births and deaths of classes along a filtration.

pub(super) mod image;
pub(crate) mod parts;
mod points;
mod vineyard;
mod zigzag;

use crate::arguments::Common;
use crate::certified;
use crate::domain::part;
use crate::failure::Failure;
use crate::filtration::{read_function, read_values};
use crate::input::{self, Source};
use crate::output::{is_json, print_json, print_text, write_file, write_json};
use crate::progress::Progress;
use crate::remarks;
use crate::target::write_model;
use crate::written::Written;
use clap::Args;
use coface::algebra::escaped;
use coface::answers::answer::{PersistenceAnswer, PersistencePairAnswer};
use coface::answers::text;
use coface::answers::{
    DiagramFormat, FoundRips, Growth, PersistenceRequest, PointFiltration, Producer, RelativeTo,
    VineyardRequest, write_diagram, write_kinds,
};
use coface::geometry::Positions;
use coface::io::{Format, Model};
use coface::topology::Coefficients;
use image::ImageArguments;
use parts::{Asked, ImageParts};
use points::{PointQuestion, stored};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Persistent homology: which components, loops and cavities are born and die as a model grows.
///
/// The model grows by sublevel sets of a function on vertices (each cell enters with its highest vertex), or by values
/// given for cells; points, with --rips, --alpha or
/// --cech, as balls around them meet; a weighted graph, with --flag, by its edges; a volume (.npy, NRRD, NIfTI, MetaImage, PGM, PNG) by its grey values: each class has the
/// voxels whose values its birth and death are. A volume whose voxels are chosen (--threshold, --below, --between, --value), or that
/// has a --function, is the model of its set voxels. Without --function the function is the last coordinate, the height; without positions it is the
/// vertex number. Pairs of persistence 0 are left out unless --min-persistence says otherwise.
///
/// The file named by -o has the format of its extension: .pers as GUDHI reads, .txt as Ripser prints, .csv, or .json with
/// the keys of --json: "field", "function", "star", "betti", and "diagram", a list of {"degree","birth","death","birth_cell",
/// "death_cell"} where cells are given by their vertices and death is null for a class that stays. With --cycles each has its "cycle",
/// "bounding_chain" and "cocycle", lists of [coefficient,[vertices..]].
#[derive(Args)]
pub(crate) struct Persistence {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// A prime field: f2, f3, f5, ... or 2, 3, 5, ...
    #[arg(long, value_name = "FIELD", default_value = "f2", value_parser = field)]
    coefficients: Coefficients,
    /// The function on vertices: a coordinate, or a file with one number a line, or an array of NumPy (.npy), for each vertex
    #[arg(long, value_name = "x|y|z|FILE")]
    function: Option<String>,
    /// Values of cells as JSON: {"values":[[..],..]} with a list for each degree, or {"cells":[[[vertices..],value],..]}
    /// where each cell that is not listed enters with the first cell that it is a face of
    #[arg(long, value_name = "FILE", conflicts_with_all = ["function", "upper_star"])]
    values: Option<PathBuf>,
    /// Grow by superlevel sets, from high values to low ones: each cell enters with its lowest vertex
    #[arg(long)]
    upper_star: bool,
    /// Extended persistence: behind the sublevel sets the homology relative to growing superlevel sets, where all classes die. Pairs have a "kind": ordinary,
    /// relative, extended+ (dead no lower than born), or extended- (dead lower than born). Classes of the whole model are all listed
    #[arg(long, conflicts_with_all = ["values", "upper_star", "cycles"])]
    extended: bool,
    /// Zigzag persistence: the input has lines "i 0 1" where a simplex enters a complex and "d 0 1" where it leaves, as fzz reads them, with times as "i 0 1 @ 2.5" or
    /// the numbers of the lines; or JSON: `[["i",[0,1],2.5],..]`, or `{"simplices":[[0,1],..],"times":[[enters,leaves,..],..]}` as Dionysus has them. Pairs have a
    /// "kind", such as closed-open: whether the class is there at the time of its birth, and at that of its death
    #[arg(long, conflicts_with_all = ["function", "values", "upper_star", "extended", "cycles"])]
    zigzag: bool,
    /// The paths of the points of the diagram while the first function becomes the second one, and so on, each vertex along a line. -o writes them as .json, or
    /// as .csv with lines vine,degree,parameter,birth,death; the JSON has "functions", and "vines", a list of {"degree","points"} with points `[parameter,birth,death]`
    #[arg(long, value_name = "x|y|z|FILE", num_args = 1.., conflicts_with_all = ["function", "values", "upper_star", "extended", "cycles", "zigzag"])]
    vineyard: Vec<String>,
    /// Relative to a part of the model, whose cells are left out: boundary, a group of the mesh by its name or number, several with commas between, or a file of cells by
    /// the same vertex numbers; groups may be given several times. A word that is a group and something else is the group
    #[arg(long, value_name = "boundary|GROUP|FILE", conflicts_with_all = ["extended", "zigzag", "vineyard"])]
    relative: Vec<PathBuf>,
    /// Image persistence: the classes of a part of the model, named as for --relative, as they are seen in the whole: they are born in the part, and die when they bound in the
    /// whole
    #[arg(long, value_name = "boundary|GROUP|FILE", conflicts_with_all = ["extended", "zigzag", "vineyard", "cycles", "relative"])]
    image_of: Vec<PathBuf>,
    /// Collapse edges before, of --rips and --flag: the diagram is the same, found from fewer simplices, among which are the cells of the pairs; "collapsed" of the JSON has the
    /// numbers of edges before and after
    #[arg(long, conflicts_with_all = ["extended", "zigzag", "vineyard", "certificate", "cycles", "relative", "image_of", "function", "values", "upper_star"])]
    collapse: bool,
    /// Only pairs whose persistence is greater than R; a negative R keeps all, of other complexes than those of --rips and --flag
    #[arg(long, value_name = "R", default_value = "0", allow_negative_numbers = true, value_parser = length)]
    min_persistence: f64,
    /// Cycles of the classes, the chains that they bound at their deaths, and cocycles, over the field, of models, points, graphs and images; written to OUT if given, as .json, or as a picture
    /// in .vtk, .obj and other mesh formats, with groups of triangles and cells. Made shorter
    /// by boundaries of cells that are there at the birth; the shortest ones are not promised
    #[arg(long, value_name = "OUT", num_args = 0..=1)]
    cycles: Option<Option<PathBuf>>,
    /// A certificate of the pairs, which coface check verifies against the input; of a facet list, a chain complex, or a surface as plain OFF or OBJ; with --rips of
    /// rows of points or distances; of other complexes of points, whose simplices it lists; of small volumes as .npy or .pgm; in the binary form if OUT ends in .bin. With
    /// --relative or --image-of FILE it is of both files, and coface check takes FILE behind the input
    #[arg(long, value_name = "OUT")]
    certificate: Option<PathBuf>,
    #[command(flatten)]
    image: ImageArguments,
    #[command(flatten)]
    in_parts: ImageParts,
}

/// How many pairs of a degree the page for people lists.
const LISTED: usize = 8;

fn field(name: &str) -> Result<Coefficients, String> {
    let is_number = !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_digit());
    let name = if is_number { format!("f{name}") } else { name.to_owned() };
    // The library has other coefficients too, of which persistence takes none.
    name.parse().map_err(|error: coface::Error| {
        format!("{}; give a prime field: f2, f3, f5, ... or 2, 3, 5, ...", error.message())
    })
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
        let is_moving = !self.vineyard.is_empty();
        if let Some(path) = common.output.as_deref().filter(|_| is_moving) {
            vineyard::check_name(path)?;
        }
        let output = common.output.as_deref().map(|path| {
            let format = if is_json(path) {
                Some(Output::Json)
            } else {
                DiagramFormat::from_path(path).map(Output::Text)
            };
            let unknown = || {
                Failure::new(format!(
                    "{}: a diagram is written as .pers, .txt, .csv or .json; name the file so, and draw the picture of \
                     that file with coface render FILE --diagram, or cycles on the model with --cycles OUT",
                    path.display()
                ))
            };
            Ok::<_, Failure>((path, format.ok_or_else(unknown)?))
        });
        let output = output.transpose()?;
        if let Some(Some(place)) = &self.cycles {
            // Before the work, not after it.
            Written::ModelOrJson.check(place)?;
            certified::check_other_output(place, std::slice::from_ref(&self.input), common)?;
        }
        if let Some(place) = &self.certificate {
            certified::check_other_output(place, std::slice::from_ref(&self.input), common)?;
            certified::refuse_standard_input(std::slice::from_ref(&self.input))?;
        }
        if self.collapse {
            let threshold = common.voxels.threshold();
            let is_undirected = common.points.flag(threshold).is_some_and(|flag| !flag.directed);
            if common.points.rips(threshold).is_none() && !is_undirected {
                return Err(Failure::new(format!(
                    "{}: --collapse is for the edges of --rips and of --flag without directions; leave --collapse out",
                    input::name(&self.input)
                )));
            }
        }
        if self.has_part() {
            common.points.refuse("persistence of a part of a model")?;
        }
        let progress = Progress::start(common.quiet);
        if self.in_parts.are_given() {
            self.check_parts(common)?;
            let found = self.in_parts.found(
                &Asked {
                    input: &self.input,
                    image: &self.image,
                    coefficients: self.coefficients,
                    min_persistence: self.min_persistence,
                },
                common,
                &progress,
            )?;
            return self.give(common, output.as_ref(), progress, &found.answer(), |bytes, format| {
                found.write(bytes, format)
            });
        }
        if self.zigzag {
            let zigzag = zigzag::given(&self.input, common, &self.image)?;
            let request = self.request(Growth::Lower(None));
            let answer = request.zigzag(&zigzag)?;
            self.save_certificate(&progress, |inputs| request.zigzag_certificate(&zigzag, inputs))?;
            return self.give(common, output.as_ref(), progress, &answer, |bytes, format| {
                write_table(&answer, bytes, format)
            });
        }
        if let Some((found, positions)) = self.found_of_points(common, &progress)? {
            let is_graph = common.points.flag(common.voxels.threshold()).is_some();
            if self.cycles.is_some() || is_graph && self.certificate.is_some() {
                let (points, request) = found.with_simplices(positions)?;
                let name = input::name(&self.input);
                return self.give_complex(
                    common,
                    output.as_ref(),
                    progress,
                    (&name, points.producer(), request, None, true),
                );
            }
            self.save_certificate(&progress, |inputs| found.certificate(inputs))?;
            return self.give(common, output.as_ref(), progress, &found.answer(), |bytes, format| {
                found.write(bytes, format)
            });
        }
        let source = Source::of(&self.input)?;
        if let Some((points, most_degree)) = self.filtration_of_points(&source, common, &progress)? {
            let name = input::name(&self.input);
            let mut request = self.request(points.growth());
            if let Some(degree) = most_degree {
                request = request.up_to_degree(degree);
            }
            return self.give_complex(
                common,
                output.as_ref(),
                progress,
                (&name, points.producer(), request, None, true),
            );
        }
        if self.is_of_values(common) {
            let question =
                self.image.question(&source, common, self.coefficients, self.min_persistence, &progress)?;
            if let Some((name, image, request)) = question {
                if self.cycles.is_some() {
                    let cells = request.cells(&name, image)?;
                    let found = cells.found()?;
                    self.save_certificate(&progress, |inputs| found.image().certificate(inputs))?;
                    let answer = found.answer();
                    if let Some(Some(place)) = &self.cycles {
                        progress.stage(format!("writing {}", place.display()));
                        save_cycles(place, &answer, || found.cycles_model())?;
                    }
                    return self.give(common, output.as_ref(), progress, &answer, |bytes, format| {
                        found.image().write(bytes, format)
                    });
                }
                let found = request.found(&name, image)?;
                self.save_certificate(&progress, |inputs| found.certificate(inputs))?;
                return self.give(common, output.as_ref(), progress, &found.answer(), |bytes, format| {
                    found.write(bytes, format)
                });
            }
        }
        self.refuse_values(&source, common)?;
        self.image.refuse(&self.input)?;
        let loaded = source.model(common.reading(), &progress)?;
        let relative = part(&self.relative, &loaded.model, &progress)?;
        let image_of = part(&self.image_of, &loaded.model, &progress)?;
        let of_groups = |part: &Option<RelativeTo>| matches!(part, Some(RelativeTo::Groups(_)));
        let mesh = (of_groups(&relative) || of_groups(&image_of)).then(|| loaded.model.clone());
        let (name, producer) = input::identify(loaded, &progress)?;
        if is_moving {
            let request = VineyardRequest::new().coefficients(self.coefficients);
            let request = request.min_persistence(self.min_persistence);
            let functions = self.vineyard.iter().map(|name| read_function(name));
            let functions = functions.collect::<Result<Vec<_>, Failure>>()?;
            let answer = request.answer(&name, &producer, &functions)?;
            if self.certificate.is_some() {
                common.points.refuse("persistence with a certificate")?;
            }
            self.save_certificate(&progress, |inputs| {
                request.certificate(&answer, &producer, &functions, inputs)
            })?;
            return vineyard::give(common, &answer, progress);
        }
        let growth = match &self.values {
            Some(path) => read_values(path)?,
            None => {
                let function = self.function.as_deref().map(read_function).transpose()?;
                if self.upper_star { Growth::Upper(function) } else { Growth::Lower(function) }
            }
        };
        let request = self.request(growth).relative(relative).image_of(image_of);
        if self.extended {
            let answer = request.extended(&name, &producer)?;
            self.save_certificate(&progress, |inputs| {
                request.extended_certificate(&name, &producer, inputs)
            })?;
            return self.give(common, output.as_ref(), progress, &answer, |bytes, format| {
                write_table(&answer, bytes, format)
            });
        }
        self.give_complex(
            common,
            output.as_ref(),
            progress,
            (&name, &producer, request, mesh.as_ref(), false),
        )
    }

    /// Whether an image is cut into parts, so that --memory is that of workers.
    pub(crate) fn is_in_parts(&self) -> bool {
        self.in_parts.are_given()
    }

    /// Refuses what parts do not answer.
    fn check_parts(&self, common: &Common) -> Result<(), Failure> {
        let options = [
            ("--cycles", self.cycles.is_some()),
            ("--certificate", self.certificate.is_some()),
            ("--function", self.function.is_some()),
            ("--values", self.values.is_some()),
            ("--upper-star", self.upper_star),
            ("--extended", self.extended),
            ("--zigzag", self.zigzag),
            ("--vineyard", !self.vineyard.is_empty()),
            ("--relative", !self.relative.is_empty()),
            ("--image-of", !self.image_of.is_empty()),
        ];
        let given = options.iter().find(|(_, is_given)| *is_given).map(|&(option, _)| option);
        if let Some(option) = given.or_else(|| common.voxels.rule_given()).or_else(|| common.points.given()) {
            return Err(Failure::new(format!(
                "{}: parts give the diagram of the values of a volume alone; leave {option} out, or --parts and --work",
                input::name(&self.input)
            )));
        }
        Ok(())
    }

    /// The diagram of points, distances or a graph whose complex is not stored, with the positions of points that have some.
    fn found_of_points(
        &self,
        common: &Common,
        progress: &Progress,
    ) -> Result<Option<(FoundRips, Positions)>, Failure> {
        if self.is_of_a_function() {
            return Ok(None);
        }
        let question = PointQuestion {
            coefficients: self.coefficients,
            min_persistence: self.min_persistence,
            collapse: self.collapse,
        };
        let found = question.found(&self.input, common, progress)?;
        Ok(found)
    }

    /// Points or a graph with the complex that is stored of them, if the options say that the input is one, and the highest degree that it tells, if it lacks
    /// cells above.
    fn filtration_of_points(
        &self,
        source: &Source<'_>,
        common: &Common,
        progress: &Progress,
    ) -> Result<Option<(PointFiltration, Option<usize>)>, Failure> {
        if self.is_of_a_function() {
            return Ok(None);
        }
        let name = input::name(&self.input);
        if common.points.alpha().is_some()
            && let Some(option) = self.image.given()
        {
            return Err(Failure::new(format!(
                "{name}: {option} is for volumes, and --alpha for points: leave one out"
            )));
        }
        let found = stored(source, common, &name, progress)?;
        if let Some((points, _)) = &found {
            let said = points.producer().remarks();
            common.reading().accept(said).map_err(|error| error.in_file(&name))?;
            remarks::take(&name, said);
        }
        Ok(found)
    }

    fn request(&self, growth: Growth) -> PersistenceRequest {
        let request = PersistenceRequest::new().growth(growth).coefficients(self.coefficients);
        request.min_persistence(self.min_persistence)
    }

    /// The diagram of a complex that grows.
    fn give_complex(
        &self,
        common: &Common,
        output: Option<&(&Path, Output)>,
        progress: Progress,
        (name, producer, request, mesh, of_points): (
            &str,
            &Producer,
            PersistenceRequest,
            Option<&Model>,
            bool,
        ),
    ) -> Result<(), Failure> {
        if self.certificate.is_some() && !of_points {
            // The checker reads the file as it is.
            common.points.refuse("persistence with a certificate")?;
        }
        let found = request.cycles(self.cycles.is_some()).found_in(name, producer, mesh)?;
        let answer = found.answer();
        if let Some(Some(place)) = &self.cycles {
            progress.stage(format!("writing {}", place.display()));
            save_cycles(place, &answer, || found.cycles_model())?;
        }
        self.save_certificate(&progress, |inputs| match of_points {
            true => found.certificate_of_points(inputs),
            false => found.certificate(inputs),
        })?;
        self.give(common, output, progress, &answer, |bytes, format| {
            write_diagram(found.diagram(), bytes, format)
        })
    }

    /// Writes the certificate, if there is to be one.
    fn save_certificate(
        &self,
        progress: &Progress,
        certificate: impl FnOnce(&[(&str, &[u8])]) -> Result<String, coface::Error>,
    ) -> Result<(), Failure> {
        let Some(place) = &self.certificate else { return Ok(()) };
        progress.stage(format!("proving {}", place.display()));
        // The file of a part is an input too.
        let parts = self.relative.iter().chain(&self.image_of);
        let parts = parts.filter(|word| word.as_os_str() != "boundary" && word.exists());
        let files: Vec<PathBuf> = std::iter::once(&self.input).chain(parts).cloned().collect();
        certified::save(place, &files, certificate)
    }

    /// A volume whose values nothing chooses from has no function but its values.
    fn refuse_values(&self, source: &Source<'_>, common: &Common) -> Result<(), Failure> {
        let has_function = self.function.is_some() || self.values.is_some() || !self.vineyard.is_empty();
        if has_function
            || common.voxels.rule_given().is_some()
            || !(self.upper_star || self.extended || self.has_part())
        {
            return Ok(());
        }
        if image::stream(source, common)?.is_none() {
            return Ok(());
        }
        let name = input::name(&self.input);
        if self.has_part() {
            return Err(Failure::new(format!(
                "{name}: --relative and --image-of are for functions on vertices, and the values of a volume are those of voxels; say the function on the voxels that are set: --function x"
            )));
        }
        if self.upper_star {
            return image::refuse_upper_star(source, common);
        }
        Err(Failure::new(format!(
            "{name}: --extended is for functions on vertices, and the values of a volume are those of voxels; say the function on the voxels that are set: --function x"
        )))
    }

    /// Whether a volume grows by its own values: nothing says that it is a model of voxels.
    fn is_of_values(&self, common: &Common) -> bool {
        !self.is_of_a_function() && common.voxels.rule_given().is_none()
    }

    /// Whether a function or values of cells are given.
    fn is_of_a_function(&self) -> bool {
        self.extended
            || !self.vineyard.is_empty()
            || self.function.is_some()
            || self.values.is_some()
            || self.upper_star
            || self.has_part()
    }

    /// Whether the question is about a part of the model.
    fn has_part(&self) -> bool {
        !self.relative.is_empty() || !self.image_of.is_empty()
    }

    /// Writes the file that was asked for, and prints.
    fn give(
        &self,
        common: &Common,
        output: Option<&(&Path, Output)>,
        progress: Progress,
        answer: &PersistenceAnswer,
        write: impl FnOnce(&mut Vec<u8>, DiagramFormat) -> Result<(), coface::Error>,
    ) -> Result<(), Failure> {
        progress.stage("writing");
        match output {
            Some((path, Output::Json)) => write_json(path, answer)?,
            Some((path, Output::Text(format))) => {
                let mut bytes = Vec::new();
                write(&mut bytes, *format)?;
                write_file(path, &bytes)?;
            }
            None => {}
        }
        drop(progress);
        if common.json {
            return print_json(answer);
        }
        if common.output.is_some() {
            return Ok(());
        }
        print_text(&self.page(answer))
    }

    /// The diagram for people: for each degree the longest pairs.
    fn page(&self, answer: &PersistenceAnswer) -> String {
        let (file, field) = (escaped(&answer.file), self.coefficients);
        let mut page = match (&answer.relative_to, &answer.image_of) {
            (Some(part), _) => {
                format!("  persistence of {file} over {field}, relative to {}\n", escaped(part))
            }
            (_, Some(part)) => {
                format!("  persistence of the image of {} in {file} over {field}\n", escaped(part))
            }
            _ => format!("  persistence of {file} over {field}\n"),
        };
        let function = &answer.function;
        // Writing to a string does not fail.
        let _ = match (&answer.star, answer.threshold) {
            (Some(star), _) if function.starts_with("voxels") => {
                let sets = if star == "upper" { "superlevel" } else { "sublevel" };
                writeln!(page, "    function: {function}, {sets} sets")
            }
            (Some(star), _) if star == "extended" => writeln!(page, "    function: {function}, extended"),
            (Some(star), _) => writeln!(page, "    function: {function}, {star} star"),
            (None, Some(threshold)) => {
                let what = if function == "vietoris-rips" { "diameters" } else { "values" };
                writeln!(page, "    {function}, {what} up to {}", text::number(threshold))
            }
            (None, None) if self.zigzag => writeln!(page, "    zigzag: intervals with closed and open ends"),
            (None, None) => writeln!(page, "    values: {function}"),
        };
        if let Some((before, after)) = answer.collapsed {
            let (after, before) = (text::grouped(after), text::count(before, "edge"));
            let _ = writeln!(page, "    {after} of {before} left by collapses");
        }
        if let Some(primes) = &answer.torsion_primes {
            let _ = match &primes[..] {
                [] => writeln!(page, "    the same pairs over every field: no torsion along the way"),
                primes => {
                    writeln!(page, "    other pairs than over Q for p in {primes:?}: torsion along the way")
                }
            };
        }
        for degree in 0..answer.betti.len() {
            let mut pairs: Vec<&PersistencePairAnswer> =
                answer.diagram.iter().filter(|pair| pair.degree == degree).collect();
            let essential = pairs.iter().filter(|pair| pair.death.is_none()).count();
            let for_ever = if answer.threshold.is_some() || self.zigzag { "at the end" } else { "for ever" };
            let _ = writeln!(
                page,
                "\n    degree {degree}: {} {for_ever}, {}",
                text::count(essential, "class"),
                text::count(pairs.len() - essential, "pair")
            );
            pairs.sort_by(|a, b| persistence(b).total_cmp(&persistence(a)));
            for pair in pairs.iter().take(LISTED) {
                let (birth, born) = (pair.birth, shown(answer, &pair.birth_cell));
                let _ = match (pair.death, &pair.death_cell) {
                    (_, by) if self.zigzag => {
                        let interval = interval(pair, pair.kind.as_deref().unwrap_or_default());
                        let end =
                            by.as_ref().map_or(String::new(), |by| format!(" to {}", shown(answer, by)));
                        writeln!(page, "      {interval}, from {born}{end}")
                    }
                    (Some(death), Some(by)) if let Some(kind) = &pair.kind => writeln!(
                        page,
                        "      {birth} to {death}  {kind}, from {born} to {}",
                        shown(answer, by)
                    ),
                    (Some(death), Some(by)) => writeln!(
                        page,
                        "      [{birth}, {death})  persistence {:.6}, from {born} to {}",
                        persistence(pair),
                        shown(answer, by)
                    ),
                    _ => writeln!(page, "      [{birth}, never)  from {born}"),
                };
            }
            if let Some(more) = pairs.len().checked_sub(LISTED).filter(|&more| more > 0) {
                let _ = writeln!(page, "      and {more} more; all with -o or --json");
            }
        }
        page
    }
}

/// Pairs with kinds as a table; other files of diagrams have none.
fn write_table(
    answer: &PersistenceAnswer,
    bytes: &mut Vec<u8>,
    format: DiagramFormat,
) -> Result<(), coface::Error> {
    if format == DiagramFormat::Csv {
        return write_kinds(answer, bytes);
    }
    let error = coface::Error::invalid("diagrams of GUDHI and Ripser have no kinds of pairs");
    Err(error.with_cure("write extended and zigzag persistence as .json or .csv"))
}

/// An interval whose ends are closed or open.
fn interval(pair: &PersistencePairAnswer, kind: &str) -> String {
    let (birth, death) = kind.split_once('-').unwrap_or(("closed", "open"));
    let open = if birth == "closed" { '[' } else { '(' };
    let close = if death == "closed" { ']' } else { ')' };
    match pair.death {
        Some(death) => format!("{open}{}, {death}{close}  persistence {:.6}", pair.birth, persistence(pair)),
        None => format!("{open}{}, never)", pair.birth),
    }
}

/// Writes cycles as JSON, or as a picture in the format that the name tells.
fn save_cycles(
    place: &Path,
    answer: &PersistenceAnswer,
    picture: impl FnOnce() -> Result<Model, coface::Error>,
) -> Result<(), Failure> {
    if matches!(Format::from_path(place), None | Some(Format::Json)) {
        return write_json(place, answer);
    }
    write_model(place, &picture()?)
}

/// A cell by the names or numbers of its vertices.
fn shown(answer: &PersistenceAnswer, cell: &[u32]) -> String {
    match &answer.vertex_names {
        Some(names) => {
            let names: Vec<_> = cell.iter().map(|&vertex| escaped(&names[vertex as usize])).collect();
            format!("[{}]", names.join(", "))
        }
        None => format!("{cell:?}"),
    }
}

/// How long a class lives.
fn persistence(pair: &PersistencePairAnswer) -> f64 {
    pair.death.map_or(f64::INFINITY, |death| (death - pair.birth).abs())
}
