//! `coface render`: still pictures.

mod diagram;
mod spin;

use super::persistence::image::stream;
use super::view::read_result;
use crate::arguments::Common;
use crate::failure::Failure;
use crate::filtration::read_function;
use crate::input::{self, Source};
use crate::output::{print_bytes, print_json, write_file};
use crate::pictures::PictureFormat;
use crate::progress::Progress;
use crate::remarks::{say_remarks, take};
use crate::simplices::SimplexList;
use crate::surface;
use clap::{Args, ValueEnum};
use coface::answers::answer::{Remark, RemarkCode, RenderAnswer};
use coface::answers::{
    BlockedMatrix, GeometryCheck, Growth, MatrixBlocks, Neighborhood, PersistenceRequest, PlanarSet,
    PolygonSchema, Report, ReportRequest, SetRequest,
};
use coface::complexes::simplicial::SimplexSet;
use coface::io;
use coface::io::Format;
use coface::pictures::{
    Camera, DiagramPoint, FlatPicture, Pane, Picture, PictureStyle, Scene, SetPicture, barcode_picture,
    blocked_matrix_picture, diagram_picture, image_picture, interface_picture, matrix_picture, pane_picture,
    schema_picture, set_picture,
};
use diagram::{points_of_result, points_of_volume, read_pers};
use spin::SpinOutput;
use std::path::{Path, PathBuf};

/// Draw a model as PNG, SVG or PDF, without a browser.
///
/// The picture is shaded, with edges where there is room for them, and with what --with gives drawn over it: generators, seams, loops, cocycles,
/// sets of simplices. What is hidden is left out; hidden parts of lines given by --with are thin and faint. Sets of the plane are drawn with
/// their curves, knots and kinks. --matrix, --diagram, --barcode, --schema and --forest draw other pictures of the input; --word draws a polygon.
///
/// An image, that is a volume of two axes, is drawn by its grey values; with --threshold and the like, or options of pictures in space, the pixels that
/// are set are squares. An interface is what coface yin interface -o wrote.
///
/// --star, --closure and --link draw what simplices have around them, as coface star, closure and link find it, each in a color of its own over
/// the pale complex. A star is open: vertices that bound it are rings, and tetrahedra in it do not reach their faces. Of complexes with
/// tetrahedra the edges alone are drawn.
///
/// The file named by -o has the format of its extension, .png, .svg or .pdf; without -o an SVG goes to standard output. PDF has vectors: a
/// pixel is 0.75 points.
#[derive(Args)]
pub(crate) struct Render {
    /// The model; - is standard input
    #[arg(value_name = "INPUT", required_unless_present = "word")]
    input: Option<PathBuf>,
    /// Draw an answer of coface over the model: the JSON of another verb, or a chain or cochain of your own as [[coefficient,
    /// [vertices..]],..]; may be given several times
    #[arg(long, value_name = "RESULT.json")]
    with: Vec<PathBuf>,
    /// Width and height in pixels [default: 1200x900; that of its content for SVG of --matrix, --diagram, --barcode, --schema, --forest and sets]
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[usize; 2]>,
    /// The direction from the model to the eye
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = direction)]
    from: Option<[f64; 3]>,
    /// What is up in the picture
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = direction)]
    up: Option<[f64; 3]>,
    /// See in perspective, with this angle in degrees from bottom to top
    #[arg(long, value_name = "ANGLE", num_args = 0..=1, default_missing_value = "35", require_equals = true)]
    perspective: Option<f64>,
    /// Draw edges
    #[arg(long, conflicts_with = "no_edges")]
    edges: bool,
    /// Draw no edges
    #[arg(long)]
    no_edges: bool,
    /// A dark background
    #[arg(long)]
    dark: bool,
    /// No background: what lies behind the picture shows through
    #[arg(long)]
    transparent: bool,
    /// The width of the lines of --with in points; hidden parts are half as wide [default: 2.25]
    #[arg(long, value_name = "POINTS", value_parser = width)]
    line_width: Option<f64>,
    /// The width of edges in points [default: 0.45]
    #[arg(long, value_name = "POINTS", value_parser = width)]
    edge_width: Option<f64>,
    /// Write the numbers of cells beside them: vertices, edges (in the order of their ends), faces; several with commas
    #[arg(long, value_name = "CELLS", value_delimiter = ',')]
    label: Vec<Labeled>,
    /// Let the model turn once about what is up, in so many frames, 24 a second: an animated .gif, .png or .webp, or PNG frames in a folder
    /// (-o frames/) or with numbers (-o frames-%03d.png), of which other programs make videos
    #[arg(long, value_name = "FRAMES", num_args = 0..=1, default_missing_value = "72", require_equals = true, conflicts_with = "pane")]
    spin: Option<u32>,
    /// Draw the open star of simplices, by their vertices: "0 1; 3" is the edge {0, 1} and the vertex 3
    #[arg(long, value_name = "LIST")]
    star: Option<SimplexList>,
    /// Draw the closure of simplices
    #[arg(long, value_name = "LIST")]
    closure: Option<SimplexList>,
    /// Draw the link of simplices
    #[arg(long, value_name = "LIST")]
    link: Option<SimplexList>,
    /// Write the names of what is drawn over the model above it, with their colors; --star, --closure and --link have that anyway
    #[arg(long)]
    legend: bool,
    /// Mark what is wrong: the witness of the report
    #[arg(long)]
    witness: bool,
    /// Draw a flat picture that an answer has beside the model instead: a domain, a cover, a forest; with a part of its name if there are several
    #[arg(long, value_name = "NAME", num_args = 0..=1, default_missing_value = "", require_equals = true, requires = "with")]
    pane: Option<String>,
    /// Draw the sparsity of the boundary matrices, or of that of degree K with its rows and columns in blocks
    #[arg(long, value_name = "K", num_args = 0..=1, value_parser = degree, conflicts_with_all = SCENE_OPTIONS)]
    matrix: Option<Option<usize>>,
    /// With --matrix K: what is a block. Components of the complex, groups of the mesh (cells in the closure of each), or what an acyclic matching
    /// makes of cells, which are matched or critical [default: components]
    #[arg(long, value_name = "BLOCKS", requires = "matrix")]
    blocks: Option<Blocks>,
    /// Draw the persistence diagram of the input: what `coface persistence` wrote (.json, .pers), or a model that grows as --function says
    #[arg(long, group = "classes", conflicts_with_all = SCENE_OPTIONS, conflicts_with = "matrix")]
    diagram: bool,
    /// Draw the barcode instead: a bar for each class, from its birth to its death
    #[arg(long, group = "classes", conflicts_with_all = SCENE_OPTIONS, conflicts_with = "matrix")]
    barcode: bool,
    /// With --diagram and --barcode: the function on vertices, a coordinate or a file with one number a line, or an array of NumPy (.npy), for each vertex
    #[arg(long, value_name = "x|y|z|FILE", requires = "classes")]
    function: Option<String>,
    /// With --diagram and --barcode: grow by superlevel sets, from high values to low ones
    #[arg(long, requires = "classes")]
    upper_star: bool,
    /// Draw the canonical polygon of each component of a surface: 4g sides of genus g, two for each cross-cap, with the sides that are glued in one
    /// color, their letters and arrows
    #[arg(long, conflicts_with_all = SCENE_OPTIONS, conflicts_with_all = ["matrix", "classes"])]
    schema: bool,
    /// Draw the polygon with these letters at its sides instead of a model: "a b a^-1 b^-1", "abAB", "a1 a1 a2 a2"
    #[arg(long, value_name = "WORD", conflicts_with_all = SCENE_OPTIONS, conflicts_with_all = ["input", "matrix", "classes", "forest"])]
    word: Option<String>,
    /// Draw a set of the plane and the forest of its curves: which lies in which
    #[arg(long, conflicts_with_all = SCENE_OPTIONS, conflicts_with_all = ["matrix", "classes", "schema"])]
    forest: bool,
}

/// Options of pictures in space.
const SCENE_OPTIONS: [&str; 17] = [
    "with",
    "from",
    "up",
    "perspective",
    "edges",
    "no_edges",
    "dark",
    "witness",
    "pane",
    "line_width",
    "edge_width",
    "label",
    "spin",
    "star",
    "closure",
    "link",
    "legend",
];

/// What the blocks of a matrix are.
#[derive(Clone, Copy, ValueEnum)]
enum Blocks {
    Components,
    Groups,
    Matching,
}

/// Cells whose numbers are written.
#[derive(Clone, Copy, ValueEnum)]
enum Labeled {
    Vertices,
    Edges,
    Faces,
}

/// Points in a pixel: 72 of one and 96 of the other to the inch.
const POINTS: f64 = 0.75;

fn width(text: &str) -> Result<f64, String> {
    let width: Option<f64> = text.parse().ok().filter(|&width| width > 0.0 && width <= 700.0);
    width.ok_or_else(|| "give a width in points above 0, such as 1.5".to_owned())
}

fn degree(text: &str) -> Result<usize, String> {
    text.parse().map_err(|_| {
        "this is no degree; name the model before --matrix, or give a degree as in --matrix=2".to_owned()
    })
}

fn size(text: &str) -> Result<[usize; 2], String> {
    let sides = text.split_once('x').map(|(width, height)| (width.parse(), height.parse()));
    match sides {
        Some((Ok(width), Ok(height))) if width > 0 && height > 0 => Ok([width, height]),
        _ => Err("give a width and a height in pixels, like 1200x900".to_owned()),
    }
}

fn direction(text: &str) -> Result<[f64; 3], String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    numbers
        .and_then(|numbers| <[f64; 3]>::try_from(numbers).ok())
        .filter(|numbers| numbers.iter().all(|x| x.is_finite()) && numbers.iter().any(|&x| x != 0.0))
        .ok_or_else(|| "give three numbers with commas between them, not all 0, like 1,0.5,2".to_owned())
}

/// What is drawn of a model.
enum Drawn {
    Scene(Box<Scene>),
    Pane(FlatPicture),
}

/// The answer, if it is asked for.
fn done(mut answer: RenderAnswer, common: &Common, progress: Progress) -> Result<(), Failure> {
    drop(progress);
    if !common.json {
        return Ok(());
    }
    answer.picture = common.output.as_ref().map(|path| path.display().to_string());
    print_json(&answer)
}

/// A picture without a size asked for has this.
const SIZE: [usize; 2] = [1200, 900];

impl Render {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let spin = match self.spin {
            Some(frames) => Some((frames, SpinOutput::of(common.output.as_deref())?)),
            None => None,
        };
        let format = match spin {
            Some(_) => PictureFormat::Png,
            None => PictureFormat::of_output(common.output.as_deref())?,
        };
        if self.perspective.is_some_and(|angle| !(1.0..=170.0).contains(&angle)) {
            return Err(Failure::new("an angle of view is between 1 and 170 degrees"));
        }
        let progress = Progress::start(common.quiet);
        let mut answer = RenderAnswer::new(self.name(), None, 0);
        let bytes = if let Some(schemas) = self.schemas(common, &progress)? {
            progress.stage("drawing");
            answer.schemas = schemas.iter().map(PolygonSchema::answer).collect();
            self.bytes_of(schema_picture(&self.title(), &schemas)?, format)?
        } else {
            let source = Source::of(self.input())?;
            match self.flat(&source, common, &progress, &mut answer)? {
                Some(picture) => {
                    progress.stage("drawing");
                    self.bytes_of(picture, format)?
                }
                None => match self.scene(&source, common, &progress, &mut answer.remarks)? {
                    Drawn::Pane(picture) => self.bytes_of(picture, format)?,
                    Drawn::Scene(scene) => {
                        let style = self.style(&scene, format_of(&source, common));
                        if let Some((frames, output)) = &spin {
                            answer.bytes = output.write(&scene, &style, *frames)?;
                            return done(answer, common, progress);
                        }
                        let picture = Picture::new(&scene, &style)?;
                        match format {
                            PictureFormat::Png => picture.png()?,
                            PictureFormat::Svg => picture.svg().into_bytes(),
                            PictureFormat::Pdf => picture.pdf(),
                        }
                    }
                },
            }
        };
        progress.stage("writing");
        match &common.output {
            Some(path) => write_file(path, &bytes)?,
            None if common.json => {}
            None => {
                drop(progress);
                return print_bytes(|out| out.write_all(&bytes));
            }
        }
        answer.bytes = bytes.len();
        done(answer, common, progress)
    }

    /// A picture that has no depth, if that is asked for or the input is a set of the plane.
    fn flat(
        &self,
        source: &Source<'_>,
        common: &Common,
        progress: &Progress,
        answer: &mut RenderAnswer,
    ) -> Result<Option<FlatPicture>, Failure> {
        let name = self.name();
        match self.matrix {
            Some(Some(degree)) => {
                return self.blocked_matrix(degree, source, common, progress, answer).map(Some);
            }
            Some(None) if self.blocks.is_some() => {
                return Err(Failure::new("--blocks: name the degree of a matrix, as in --matrix=1"));
            }
            Some(None) => {
                let (_, producer) = input::identify(source.model(common.reading(), progress)?, progress)?;
                let complex = producer.into_chain_complex().map_err(|error| error.in_file(name.clone()))?;
                return Ok(Some(matrix_picture(&format!("boundary matrices of {}", self.title()), &complex)));
            }
            None => {}
        }
        if self.barcode {
            let points = self.diagram_points(source, common, progress)?;
            return Ok(Some(barcode_picture(&format!("barcode of {}", self.title()), &points)?));
        }
        if self.diagram {
            let points = self.diagram_points(source, common, progress)?;
            return Ok(Some(diagram_picture(&format!("persistence diagram of {}", self.title()), &points)?));
        }
        if self.forest {
            progress.stage(format!("reading {name}"));
            let set = self.set(source, common).map_err(|error| error.in_file(name))?;
            return Ok(Some(set_picture(&set, SetPicture::Forest)?));
        }
        if let Some(interface) = source.interface().map_err(|error| error.in_file(name.clone()))? {
            return Ok(Some(
                interface_picture(&self.title(), &interface).map_err(|error| error.in_file(name))?,
            ));
        }
        let is_in_space =
            self.from.is_some() || self.up.is_some() || self.perspective.is_some() || self.spin.is_some();
        let has_rule = common.voxels.rule_given().is_some();
        let has_widths = self.line_width.is_some() || self.edge_width.is_some();
        let has_marks = !self.with.is_empty()
            || self.witness
            || self.dark
            || self.edges
            || self.no_edges
            || !self.label.is_empty()
            || self.has_neighborhoods()
            || self.legend
            || has_widths;
        if is_in_space || has_marks {
            return Ok(None);
        }
        if !has_rule && let Some(picture) = self.image(source, common, progress)? {
            return Ok(Some(picture));
        }
        if !may_be_a_set(source, common) {
            return Ok(None);
        }
        // Whatever is no set is a model; whoever reads models says what is wrong.
        let Ok(set) = self.set(source, common) else { return Ok(None) };
        // A drawing that bounds nothing still has lines to be seen.
        if set.set().curve_count() == 0
            && !matches!(format_of(source, common), Some(Format::Json | Format::Dat))
        {
            return Ok(None);
        }
        Ok(Some(set_picture(&set, SetPicture::Kinks)?))
    }

    /// A boundary matrix in blocks.
    fn blocked_matrix(
        &self,
        degree: usize,
        source: &Source<'_>,
        common: &Common,
        progress: &Progress,
        answer: &mut RenderAnswer,
    ) -> Result<FlatPicture, Failure> {
        let blocks = match self.blocks {
            None | Some(Blocks::Components) => MatrixBlocks::Components,
            Some(Blocks::Groups) => MatrixBlocks::Groups,
            Some(Blocks::Matching) => MatrixBlocks::Matching,
        };
        let loaded = source.model(common.reading(), progress)?;
        let model = loaded.model.clone();
        let (name, producer) = input::identify(loaded, progress)?;
        progress.stage("putting cells in blocks");
        let found =
            BlockedMatrix::of(&producer, &model, degree, blocks).map_err(|error| error.in_file(name))?;
        answer.matrix = Some(found.answer());
        Ok(blocked_matrix_picture(&format!("boundary matrix of {}", self.title()), &found))
    }

    /// What is drawn: a file, or nothing where a word is.
    fn input(&self) -> &Path {
        self.input.as_deref().unwrap_or(Path::new("-"))
    }

    /// The name of what is drawn, for people.
    fn name(&self) -> String {
        self.word.clone().unwrap_or_else(|| input::name(self.input()))
    }

    /// The input without its folder: the same picture wherever the file lies.
    fn title(&self) -> String {
        let file = self.input.as_deref().filter(|input| input.as_os_str() != "-").and_then(Path::file_name);
        file.map_or_else(|| self.name(), |name| name.to_string_lossy().into_owned())
    }

    /// The polygons of --word or --schema.
    fn schemas(&self, common: &Common, progress: &Progress) -> Result<Option<Vec<PolygonSchema>>, Failure> {
        if let Some(word) = &self.word {
            let schema: PolygonSchema =
                word.parse().map_err(|error: coface::Error| error.in_file(format!("--word \"{word}\"")))?;
            return Ok(Some(vec![schema]));
        }
        if !self.schema {
            return Ok(None);
        }
        let (name, surface) = surface::read(self.input(), false, common, progress)?;
        let schemas = surface.schemas();
        if schemas.is_empty() {
            return Err(Failure::new(format!("{name}: there is no surface to draw; give one with faces")));
        }
        Ok(Some(schemas))
    }

    /// The grey values of an image, if the input is a volume of two axes: of an array the first axis goes down and the second to the right, of other
    /// formats the first to the right and the second up, in PGM and PNG down.
    fn image(
        &self,
        source: &Source<'_>,
        common: &Common,
        progress: &Progress,
    ) -> Result<Option<FlatPicture>, Failure> {
        // One model of a file of several, or a phase of an interface, is no image.
        if matches!(source, Source::File(path) if !path.exists() && io::entry_of(path).is_some()) {
            return Ok(None);
        }
        let Some((name, stream)) = stream(source, common)? else { return Ok(None) };
        let &[first, second] = stream.shape() else { return Ok(None) };
        progress.stage(format!("reading {name}"));
        let shape = [first as usize, second as usize];
        let is_first_fastest = stream.fastest_axis() == 0;
        let format = format_of(source, common);
        let (is_array, goes_down) =
            (format == Some(Format::Npy), matches!(format, Some(Format::Pgm | Format::Png)));
        let (numbers, said) = stream.numbers().map_err(|error| error.in_file(name.clone()))?;
        take(&name, &said);
        let at =
            |i: usize, j: usize| numbers[if is_first_fastest { i + shape[0] * j } else { shape[1] * i + j }];
        let [rows, columns] = if is_array { shape } else { [shape[1], shape[0]] };
        let value = |place: usize| match (place / columns, place % columns) {
            (row, column) if is_array => at(row, column),
            (row, column) if goes_down => at(column, row),
            (row, column) => at(column, rows - 1 - row),
        };
        let values: Vec<f64> = (0..rows * columns).map(value).collect();
        Ok(Some(image_picture(&self.title(), [rows, columns], &values)?))
    }

    fn set(&self, source: &Source<'_>, common: &Common) -> Result<PlanarSet, coface::Error> {
        PlanarSet::of(&source.boundary(&common.reading())?, &SetRequest::default())
    }

    /// The classes of a diagram: those in a file, or those of a model.
    fn diagram_points(
        &self,
        source: &Source<'_>,
        common: &Common,
        progress: &Progress,
    ) -> Result<Vec<DiagramPoint>, Failure> {
        let extension = self.input().extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let is_computed = self.function.is_some() || self.upper_star || common.format.is_some();
        if !is_computed && extension.eq_ignore_ascii_case("pers") {
            return read_pers(self.input());
        }
        if !is_computed
            && extension.eq_ignore_ascii_case("json")
            && let Some(points) = points_of_result(self.input())?
        {
            return Ok(points);
        }
        if self.function.is_none()
            && let Some(points) = points_of_volume(source, common, self.upper_star)?
        {
            return Ok(points);
        }
        let (name, producer) = input::identify(source.model(common.reading(), progress)?, progress)?;
        let function = self.function.as_deref().map(read_function).transpose()?;
        let growth = if self.upper_star { Growth::Upper(function) } else { Growth::Lower(function) };
        let found = PersistenceRequest::new().growth(growth).found(&name, &producer)?;
        let diagram = found.diagram();
        let points = diagram.pairs().iter().map(|pair| DiagramPoint {
            degree: pair.degree(),
            birth: pair.birth(),
            death: pair.death(),
        });
        Ok(points.collect())
    }

    /// The model in space.
    fn scene(
        &self,
        source: &Source<'_>,
        common: &Common,
        progress: &Progress,
        remarks: &mut Vec<Remark>,
    ) -> Result<Drawn, Failure> {
        let loaded = source.model(common.reading(), progress).map_err(|failure| {
            match points_of_result(self.input()) {
                Ok(Some(_)) => Failure::new(format!(
                    "{}: is a persistence diagram, and no model; draw it with --diagram",
                    self.input().display()
                )),
                _ => failure,
            }
        })?;
        progress.stage("drawing");
        let in_file = |error: coface::Error| error.in_file(loaded.name.clone());
        let mut scene = Scene::of(&self.title(), &loaded.model).map_err(in_file)?;
        let left_out = scene.remarks();
        say_remarks(&left_out, common);
        remarks.extend(left_out);
        for path in &self.with {
            scene.add_result(&input::name(path), &read_result(path)?)?;
        }
        if self.has_neighborhoods() {
            progress.stage("making the complex");
            scene.add_neighborhoods(&loaded.model, &self.neighborhoods()?).map_err(in_file)?;
            progress.stage("drawing");
        }
        if let Some(name) = &self.pane {
            let pane = pane_named(&scene, name)?;
            return Ok(Drawn::Pane(pane_picture(pane)));
        }
        if !scene.panes().is_empty() {
            let message = format!("not drawn: {}; --pane draws it instead", pane_names(&scene));
            let panes = Remark::new(RemarkCode::NotDrawn, message).at(scene.panes().len(), []);
            say_remarks(std::slice::from_ref(&panes), common);
            remarks.push(panes);
        }
        if self.witness {
            progress.stage(format!("examining {}", loaded.name));
            let request = ReportRequest::new().geometry(GeometryCheck::Never);
            let report = Report::answering(loaded.model, &request).map_err(in_file)?;
            scene = scene.with_report(&report.answer(100));
            progress.stage("drawing");
        }
        for cells in &self.label {
            let dimension = match cells {
                Labeled::Vertices => 0,
                Labeled::Edges => 1,
                Labeled::Faces => 2,
            };
            scene.label_cells(dimension).map_err(in_file)?;
        }
        Ok(Drawn::Scene(Box::new(scene)))
    }

    fn has_neighborhoods(&self) -> bool {
        self.star.is_some() || self.closure.is_some() || self.link.is_some()
    }

    /// The stars, closures and links that are asked for.
    fn neighborhoods(&self) -> Result<Vec<(Neighborhood, SimplexSet)>, Failure> {
        let asked = [
            (Neighborhood::Star, &self.star),
            (Neighborhood::Closure, &self.closure),
            (Neighborhood::Link, &self.link),
        ];
        let given = asked.into_iter().filter_map(|(neighborhood, list)| Some((neighborhood, list.as_ref()?)));
        given
            .map(|(neighborhood, list)| {
                let in_option = |error: coface::Error| error.in_file(format!("--{}", neighborhood.name()));
                Ok((neighborhood, list.simplices().map_err(in_option)?))
            })
            .collect()
    }

    /// A flat picture as a file.
    fn bytes_of(&self, picture: FlatPicture, format: PictureFormat) -> Result<Vec<u8>, Failure> {
        let picture = if self.transparent { picture.transparent() } else { picture };
        Ok(format.bytes(&picture, self.size)?)
    }

    fn style(&self, scene: &Scene, format: Option<Format>) -> PictureStyle {
        let mut style = PictureStyle::default();
        style.size = self.size.unwrap_or(SIZE);
        style.is_dark = self.dark;
        style.is_transparent = self.transparent;
        style.has_legend = self.legend || self.has_neighborhoods();
        style.line_width = self.line_width.map_or(style.line_width, |points| points / POINTS);
        style.edge_width = self.edge_width.map_or(style.edge_width, |points| points / POINTS);
        style.edges = match (self.edges, self.no_edges) {
            (true, _) => Some(true),
            (_, true) => Some(false),
            _ => None,
        };
        let image = format.filter(|_| scene.dimension() == 2).and_then(image_camera);
        if self.from.is_some() || self.up.is_some() || self.perspective.is_some() {
            let mut camera = Camera::usual(scene);
            camera.from = self.from.unwrap_or(camera.from);
            camera.up = self.up.unwrap_or(camera.up);
            camera.field_of_view = self.perspective;
            style.camera = Some(camera);
        } else {
            style.camera = image;
        }
        style
    }
}

/// From where the pixels of an image lie as its grey values are drawn: of an array the first axis goes down, of PGM and PNG the second.
fn image_camera(format: Format) -> Option<Camera> {
    let mut camera = Camera::above();
    match format {
        Format::Npy => camera.up = [-1.0, 0.0, 0.0],
        Format::Pgm | Format::Png => (camera.from, camera.up) = ([0.0, 0.0, -1.0], [0.0, -1.0, 0.0]),
        _ => return None,
    }
    Some(camera)
}

/// The first pane whose name has these words.
fn pane_named<'s>(scene: &'s Scene, words: &str) -> Result<&'s Pane, Failure> {
    if scene.panes().is_empty() {
        return Err(Failure::new(
            "--pane: the answers have no flat picture beside the model; coface cut -o and coface cover -o write some that have, as .json",
        ));
    }
    scene.panes().iter().find(|pane| pane.name.contains(words)).ok_or_else(|| {
        Failure::new(format!("--pane={words}: there is no such picture; there is {}", pane_names(scene)))
    })
}

/// The names of the panes.
fn pane_names(scene: &Scene) -> String {
    scene.panes().iter().map(|pane| format!("{:?}", pane.name)).collect::<Vec<_>>().join(", ")
}

/// The format that was said, or that the name or the content tells.
fn format_of(source: &Source<'_>, common: &Common) -> Option<Format> {
    common.format.or_else(|| match source {
        Source::File(path) => Format::from_path(path),
        Source::Bytes(bytes) => Format::from_content(bytes, true),
    })
}

/// Whether the format of the input is one of those that hold sets of the plane.
fn may_be_a_set(source: &Source<'_>, common: &Common) -> bool {
    let format = format_of(source, common);
    let formats = [Format::Json, Format::Dat, Format::Svg, Format::GeoJson, Format::Wkt];
    format.is_none_or(|format| formats.contains(&format))
}
