//! The report for people: aligned, at 80 columns, with a gloss for each word a newcomer may not know.

use crate::facts::geometry_sentence;
use crate::{Answer, DrawnFault, DrawnPolygons, GeometryFacts, Kind, Problem, ProblemKind, Report};
use anstyle::{AnsiColor, Style};
use coface_algebra::escaped;
use coface_arrange::spatial::checks::{Fault, FaultScope};
use coface_complexes::simplicial::SimplexSet;
use coface_io::GroupKind;
use coface_topology::{AbelianGroup, Coefficients};
use std::fmt::Write;

const WIDTH: usize = 80;
/// Where values start.
const INDENT: usize = 20;

const TITLE: Style = Style::new().bold();
const GOOD: Emphasis = Emphasis::Good;
const BAD: Emphasis = Emphasis::Bad;
const ODD: Emphasis = Emphasis::Odd;
const GLOSS: Emphasis = Emphasis::Gloss;
const PLAIN: Emphasis = Emphasis::Plain;

/// How many places of a problem are listed when not all are asked for.
pub const FEW: usize = 5;

/// The report on the file of this name and format. Of each list the first `limit` items are shown.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
/// let report = coface_answers::Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
/// assert!(coface_answers::text::report("t.off", "OFF", &report, 10).contains("t.off"));
/// # Ok(()) }
/// ```
pub fn report(name: &str, format: &str, report: &Report, limit: usize) -> String {
    page_of(name, format, report, limit).finished()
}

/// The same, before it is laid out: the title, the summary, then facts and problems.
pub fn items(name: &str, format: &str, report: &Report, limit: usize) -> Vec<Item> {
    page_of(name, format, report, limit).items
}

fn page_of(name: &str, format: &str, report: &Report, limit: usize) -> Page {
    let mut page = Page::default();
    page.title(name, format);
    page.paragraph(2, PLAIN, &summary(report));
    page.blank();
    cells(&mut page, report);
    shape(&mut page, report);
    boundary(&mut page, report, limit);
    orientation(&mut page, report);
    homology(&mut page, "homology over Z", report.homology(), "H_");
    measures(&mut page, report);
    data(&mut page, report, limit);
    named_parts(&mut page, report, limit);
    for [name, cycles, gloss] in &report.permutations {
        page.fact(name, PLAIN, cycles, gloss);
    }
    for (i, row) in report.halfedges().iter().enumerate() {
        let label = if i == 0 { "halfedges" } else { "" };
        let pointed = format!("h{}: next h{}, twin h{}", row.halfedge, row.next, row.twin);
        let face = if row.outer { "outer face" } else { "face" };
        let gloss =
            format!("from v{} to v{}, edge e{}, {face} f{}", row.source, row.target, row.edge, row.face);
        page.fact(label, PLAIN, &pointed, &gloss);
    }
    problems(&mut page, report, limit);
    page
}

/// A list of groups for people, with a title.
///
/// # Examples
/// ```
/// use coface_topology::{AbelianGroup, Coefficients};
/// let circle = [1, 1].map(|betti| AbelianGroup::new(betti, vec![]));
/// assert!(coface_answers::text::groups("Homology", &circle, "H", Coefficients::Integers).contains("Z"));
/// ```
pub fn groups(title: &str, groups: &[AbelianGroup], symbol: &str, ring: Coefficients) -> String {
    let mut page = Page::default();
    page.heading(title);
    for (degree, found) in groups.iter().enumerate() {
        page.paragraph(4, PLAIN, &format!("{symbol}{degree} = {}", group(found, ring)));
    }
    if groups.is_empty() {
        page.paragraph(4, PLAIN, "nothing: the complex is empty");
    }
    page.finished()
}

/// A page of facts with a title: what each is called, what it is, what that means.
pub fn facts(title: &str, facts: &[(String, String, String)]) -> String {
    let mut page = Page::default();
    page.heading(title);
    for (label, value, gloss) in facts {
        page.fact(label, PLAIN, value, gloss);
    }
    page.finished()
}

/// A group as text: its free part over this ring, and its torsion.
///
/// # Examples
/// ```
/// use coface_topology::{AbelianGroup, Coefficients};
/// let plane = AbelianGroup::new(2, vec![2.into()]);
/// assert_eq!(coface_answers::text::group(&plane, Coefficients::Integers), "Z^2 + Z/2");
/// assert_eq!(coface_answers::text::group(&plane, Coefficients::Modulo(4)), "(Z/4)^2 + Z/2");
/// ```
pub fn group(group: &AbelianGroup, ring: Coefficients) -> String {
    let torsion = AbelianGroup::new(0, group.torsion().to_vec());
    let free = match (group.betti(), ring) {
        (0, _) => return torsion.to_string(),
        (1, _) => ring.to_string(),
        (rank, Coefficients::Modulo(n)) => format!("(Z/{n})^{rank}"),
        (rank, _) => format!("{ring}^{rank}"),
    };
    if torsion.is_trivial() { free } else { format!("{free} + {torsion}") }
}

/// How something is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Emphasis {
    /// As it is.
    Plain,
    /// As one hopes.
    Good,
    /// A fault.
    Bad,
    /// Worth a look.
    Odd,
    /// An explanation.
    Gloss,
}

impl Emphasis {
    fn style(self) -> Style {
        match self {
            Self::Plain => Style::new(),
            Self::Good => AnsiColor::Green.on_default(),
            Self::Bad => AnsiColor::Red.on_default(),
            Self::Odd => AnsiColor::Yellow.on_default(),
            Self::Gloss => Style::new().dimmed(),
        }
    }
}

/// A part of a report, before it is laid out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Item {
    /// What the report is about, and a word on it.
    Title(String, String),
    /// The title of what follows.
    Heading(String),
    /// An empty line.
    Blank,
    /// Words in lines.
    Paragraph {
        /// The column where lines begin.
        indent: usize,
        /// How they are meant.
        emphasis: Emphasis,
        /// The words.
        words: String,
    },
    /// Words after a mark.
    Bullet {
        /// How they are meant.
        emphasis: Emphasis,
        /// The words.
        words: String,
    },
    /// What it is called, what it is, what that means.
    Fact {
        /// What it is called.
        label: String,
        /// How the value is meant.
        emphasis: Emphasis,
        /// What it is.
        value: String,
        /// What that means.
        gloss: String,
    },
}

impl Item {
    /// Lays the item out for a terminal.
    fn push(&self, text: &mut String) {
        const GLOSS: Style = Style::new().dimmed();
        // Writing to a string does not fail.
        match self {
            Self::Title(name, gloss) => {
                let _ = writeln!(text, "{TITLE}{name}{TITLE:#}  {GLOSS}{gloss}{GLOSS:#}");
            }
            Self::Heading(words) => {
                let _ = writeln!(text, "  {TITLE}{words}{TITLE:#}");
            }
            Self::Blank => text.push('\n'),
            Self::Paragraph { indent, emphasis, words } => {
                let style = emphasis.style();
                for line in wrapped(words, WIDTH - indent) {
                    let _ = writeln!(text, "{:indent$}{style}{line}{style:#}", "");
                }
            }
            Self::Bullet { emphasis, words } => {
                let style = emphasis.style();
                for (i, line) in wrapped(words, WIDTH - 4).into_iter().enumerate() {
                    let mark = if i == 0 { "*" } else { " " };
                    let _ = writeln!(text, "  {style}{mark}{style:#} {line}");
                }
            }
            Self::Fact { label, emphasis, value, gloss } => {
                let style = emphasis.style();
                let _ = write!(text, "  {label:<width$}", width = INDENT - 2);
                let mut lines = wrapped(value, WIDTH - INDENT).into_iter();
                let mut last = lines.next().unwrap_or_default();
                for line in lines {
                    let _ = write!(text, "{style}{last}{style:#}\n{:INDENT$}", "");
                    last = line;
                }
                let _ = write!(text, "{style}{last}{style:#}");
                if !gloss.is_empty() {
                    let column = INDENT + last.chars().count() + 2;
                    let rest = gloss.chars().count();
                    if column + rest <= WIDTH {
                        let _ = write!(text, "  {GLOSS}{gloss}{GLOSS:#}");
                    } else {
                        for line in wrapped(gloss, WIDTH - INDENT) {
                            let _ = write!(text, "\n{:INDENT$}{GLOSS}{line}{GLOSS:#}", "");
                        }
                    }
                }
                text.push('\n');
            }
        }
    }
}

/// A report that grows.
#[derive(Default)]
struct Page {
    items: Vec<Item>,
}

impl Page {
    /// The report for a terminal.
    fn finished(self) -> String {
        let mut text = String::new();
        self.items.iter().for_each(|item| item.push(&mut text));
        text.replace(NO_BREAK, " ")
    }

    fn title(&mut self, name: &str, gloss: &str) {
        self.items.push(Item::Title(escaped(name).into_owned(), escaped(gloss).into_owned()));
    }

    fn heading(&mut self, words: &str) {
        self.items.push(Item::Heading(escaped(words).into_owned()));
    }

    fn blank(&mut self) {
        self.items.push(Item::Blank);
    }

    /// Words broken into lines that start at column `indent`.
    fn paragraph(&mut self, indent: usize, emphasis: Emphasis, words: &str) {
        self.items.push(Item::Paragraph { indent, emphasis, words: escaped(words).into_owned() });
    }

    /// One fact: what it is called, what it is, what that means.
    fn fact(&mut self, label: &str, emphasis: Emphasis, value: &str, gloss: &str) {
        let [label, value, gloss] = [label, value, gloss].map(|text| escaped(text).into_owned());
        self.items.push(Item::Fact { label, emphasis, value, gloss });
    }
}

/// The words in lines of at most `width` characters; a longer word has a line of its own.
fn wrapped(words: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut length = 0;
    for word in words.split(' ').filter(|word| !word.is_empty()) {
        let added = word.chars().count();
        match lines.last_mut() {
            Some(line) if length + 1 + added <= width => {
                line.push(' ');
                line.push_str(word);
                length += 1 + added;
            }
            _ => {
                lines.push(word.to_owned());
                length = added;
            }
        }
    }
    lines
}

/// A number of things.
///
/// # Examples
/// ```
/// assert_eq!(coface_answers::text::count(1204, "vertex"), "1,204 vertices");
/// ```
pub fn count(number: usize, singular: &str) -> String {
    format!("{} {}", grouped(number), if number == 1 { singular.to_owned() } else { plural(singular) })
}

fn plural(singular: &str) -> String {
    match singular {
        "vertex" => "vertices".to_owned(),
        "tetrahedron" => "tetrahedra".to_owned(),
        "hexahedron" => "hexahedra".to_owned(),
        "simplex" => "simplices".to_owned(),
        "class" => "classes".to_owned(),
        word => match word.split_once(" of ") {
            Some((head, rest)) => format!("{} of {rest}", plural(head)),
            None => format!("{word}s"),
        },
    }
}

/// Digits in groups of three.
///
/// # Examples
/// ```
/// assert_eq!(coface_answers::text::grouped(1_234_567), "1,234,567");
/// ```
pub fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A space at which no line is broken, while a page is laid out.
const NO_BREAK: &str = "\u{a0}";

/// What the model is, in one sentence.
fn summary(report: &Report) -> String {
    let Some(dimension) = report.dimension() else {
        return "The empty complex: no vertex, no cell.".to_owned();
    };
    if let Some(surface) = report.surface_type() {
        let name = surface.to_string();
        let article = if name.starts_with(['a', 'o']) { "An" } else { "A" };
        return format!("{article} {name}.");
    }
    let thing = match (report.kind(), dimension) {
        (_, 0) => "points".to_owned(),
        (Kind::Planar, _) => "a drawing in the plane".to_owned(),
        (Kind::Volume, 1) => "an image of segments in a row".to_owned(),
        (Kind::Volume, 2) => "an image of squares in the plane".to_owned(),
        (Kind::Volume, _) => "a volume mesh".to_owned(),
        (_, 1) => "a graph".to_owned(),
        (Kind::Surface, _) => "a polygon mesh".to_owned(),
        (_, dimension) => format!("a complex of dimension {dimension}"),
    };
    let mut sentence = format!("{}{}, {}", thing[..1].to_uppercase(), &thing[1..], connectedness(report));
    if report.is_closed() == Some(false) {
        sentence.push_str(", with boundary");
    }
    match (report.manifold(), dimension, report.name()) {
        (Answer::Yes, 2 | 3, Some(name)) => {
            let _ = write!(sentence, ": {name}");
        }
        (Answer::Yes, 2, None) => sentence.push_str(": a surface"),
        (Answer::Yes, dimension, _) if dimension > 0 => {
            let _ = write!(sentence, ": a {dimension}-manifold");
        }
        (Answer::No, ..) => sentence.push_str("; not a manifold"),
        _ => {}
    }
    sentence.push('.');
    sentence
}

fn connectedness(report: &Report) -> String {
    match report.components() {
        1 => "connected".to_owned(),
        many => format!("in {} pieces", grouped(many)),
    }
}

/// The name of a cell of this degree.
fn cell_name(report: &Report, degree: usize) -> String {
    // The cells of a chain complex, of which it is not known whether it is pure, have no shape.
    let is_simplicial = report.kind() == Kind::Complex && report.is_pure().is_some();
    match (degree, is_simplicial) {
        (0, _) => "vertex".to_owned(),
        (1, _) => "edge".to_owned(),
        (2, true) => "triangle".to_owned(),
        (3, true) => "tetrahedron".to_owned(),
        (2, _) => "face".to_owned(),
        (3, _) => "cell".to_owned(),
        (degree, _) => format!("cell of dimension {degree}"),
    }
}

fn cells(page: &mut Page, report: &Report) {
    let counts: Vec<String> = report
        .f_vector()
        .iter()
        .enumerate()
        .map(|(degree, &number)| count(number, &cell_name(report, degree)))
        .collect();
    let shapes: Vec<String> = report.shapes().iter().map(|&(name, number)| count(number, name)).collect();
    let gloss = if report.kind() == Kind::Complex || shapes.is_empty() {
        String::new()
    } else {
        format!("as {}", shapes.join(", "))
    };
    page.fact("cells", PLAIN, &if counts.is_empty() { "none".to_owned() } else { counts.join(", ") }, &gloss);
    let Some(dimension) = report.dimension() else { return };
    let gloss = match report.is_pure() {
        Some(true) => format!("pure: every cell lies in one of dimension {dimension}"),
        Some(false) => format!("not pure: some cells lie in none of dimension {dimension}"),
        None => String::new(),
    };
    page.fact("dimension", PLAIN, &dimension.to_string(), &gloss);
    let gloss = if report.components() == 1 { "connected" } else { "pieces that do not touch" };
    page.fact("components", PLAIN, &grouped(report.components()), gloss);
    let formula: String =
        "VEFC".chars().take(dimension + 1).map(String::from).collect::<Vec<_>>().join(" - ");
    let formula = match dimension {
        0 => "V".to_owned(),
        1..=3 => alternating(&formula),
        _ => "alternating sum of the numbers of cells".to_owned(),
    };
    page.fact("Euler char.", PLAIN, &report.euler_characteristic().to_string(), &formula);
}

/// `V - E - F - C` with signs that alternate.
fn alternating(formula: &str) -> String {
    let mut minus = false;
    formula
        .split(" - ")
        .enumerate()
        .map(|(i, letter)| {
            let sign = match (i, minus) {
                (0, _) => "",
                (_, true) => " - ",
                (_, false) => " + ",
            };
            minus = !minus;
            format!("{sign}{letter}")
        })
        .collect()
}

fn shape(page: &mut Page, report: &Report) {
    let Some(dimension) = report.dimension() else { return };
    match report.manifold() {
        Answer::Yes => {
            let gloss = match dimension {
                0 => "points",
                1 => "every vertex lies in one or two edges",
                2 => "around every vertex the faces form one fan or ring",
                3 => "around every vertex the cells form a ball or half ball",
                _ => "every neighborhood is a ball or half ball",
            };
            page.fact("manifold", GOOD, "yes", gloss);
        }
        Answer::No => {
            let gloss = report.witness().map_or("", |witness| witness.message());
            page.fact("manifold", BAD, "no", gloss);
        }
        Answer::Unknown => {
            let gloss = match report.witness() {
                Some(witness) => witness.message(),
                None if report.is_pure().is_none() => "boundary matrices alone do not tell",
                None => "not decided in this dimension",
            };
            page.fact("manifold", ODD, "unknown", gloss);
        }
    }
}

fn boundary(page: &mut Page, report: &Report, limit: usize) {
    if let Some(skin) = report.skin() {
        let name = skin.name().map_or_else(
            || if skin.is_manifold() { "a surface".to_owned() } else { "not a surface".to_owned() },
            |name| name.to_owned(),
        );
        let gloss = format!("{name}; a boundary face lies in one cell only");
        page.fact("boundary", PLAIN, &count(skin.face_count(), "face"), &gloss);
        return;
    }
    let Some(loops) = report.boundary_loops() else {
        match report.is_closed() {
            Some(true) if report.dimension() > Some(0) => page.fact("boundary", PLAIN, "none", "closed"),
            Some(false) => page.fact("boundary", PLAIN, "yes", "some facets lie in one top cell only"),
            _ => {}
        }
        return;
    };
    if loops.is_empty() {
        let gloss = match report.is_pure() {
            Some(false) => "closed: no edge lies in one face alone",
            _ => "closed: every edge lies in two or more faces",
        };
        page.fact("boundary", PLAIN, "none", gloss);
        return;
    }
    page.fact("boundary", PLAIN, &count(loops.len(), "loop"), "of edges that lie in one face only");
    for (i, part) in loops.iter().enumerate().take(limit) {
        let along = |vertices: &[u32]| {
            let first: Vec<String> = vertices.iter().take(6).map(|vertex| format!("v{vertex}")).collect();
            let more = if vertices.len() > first.len() { " .." } else { "" };
            format!("{}{more}", first.join(" "))
        };
        let label = format!("loop {}: {}", i + 1, count(part.edge_count(), "edge"));
        if part.is_simple() {
            page.fact("", PLAIN, &label, &along(part.vertices()));
            continue;
        }
        let walks = part.walks();
        page.fact("", PLAIN, &label, &format!("{} that touch", count(walks.len(), "walk")));
        for walk in walks.iter().take(limit) {
            let value = format!("  {}", count(walk.len() - 1, "edge"));
            page.fact("", PLAIN, &value, &along(walk));
        }
        more_of(page, INDENT, walks.len(), limit, "walk");
    }
    more_of(page, INDENT, loops.len(), limit, "loop");
}

/// `and 12 more loops (--all lists them)`.
fn more_of(page: &mut Page, indent: usize, number: usize, limit: usize, name: &str) {
    if number > limit {
        let rest = number - limit;
        let noun = if rest == 1 { name.to_owned() } else { plural(name) };
        page.paragraph(indent, GLOSS, &format!("and {} more {noun} (--all lists them)", grouped(rest)));
    }
}

fn orientation(page: &mut Page, report: &Report) {
    match (report.is_orientable(), report.is_coherently_oriented()) {
        (Some(true), Some(true)) => {
            page.fact("orientable", GOOD, "yes", "and coherently oriented: neighbors agree");
        }
        (Some(true), Some(false)) => {
            page.fact("orientable", ODD, "yes", "but not coherently oriented: some neighbors disagree");
        }
        (Some(true), None) => page.fact("orientable", GOOD, "yes", "an orientation can be chosen all over"),
        (Some(false), _) => {
            page.fact("orientable", ODD, "no", "along some closed path the orientation comes back reversed");
        }
        (None, _) => {}
    }
    if let Some(surface) = report.surface_type() {
        let gloss = match surface.is_orientable() {
            true => "number of handles",
            false => "number of cross-caps",
        };
        page.fact("genus", PLAIN, &surface.genus().to_string(), gloss);
    }
}

fn homology(page: &mut Page, title: &str, groups: &[AbelianGroup], symbol: &str) {
    for (degree, group) in groups.iter().enumerate() {
        let label = if degree == 0 { title } else { "" };
        let gloss = homology_gloss(degree, group, groups.len() < 5);
        page.fact(label, PLAIN, &format!("{symbol}{degree} = {group}"), &gloss);
    }
}

/// What a homology group counts; what fits into space has cavities.
fn homology_gloss(degree: usize, group: &AbelianGroup, fits_into_space: bool) -> String {
    let things = match degree {
        0 => "component",
        1 => "independent loop",
        2 if fits_into_space => "enclosed cavity",
        _ => "independent cycle",
    };
    let free = match (group.betti(), degree) {
        (0, _) => String::new(),
        (number, 2) if fits_into_space && number != 1 => format!("{} enclosed cavities", grouped(number)),
        (number, _) => count(number, things),
    };
    let torsion = match group.torsion() {
        [] => String::new(),
        [order] => format!("a cycle that bounds only {order} times over"),
        orders => format!("{} cycles that bound only several times over", orders.len()),
    };
    match (free.is_empty(), torsion.is_empty()) {
        (false, false) => format!("{free}; {torsion}"),
        _ => free + &torsion,
    }
}

fn measures(page: &mut Page, report: &Report) {
    if let Some(area) = report.area() {
        page.fact("area", PLAIN, &number(area), "");
    }
    if let Some(volume) = report.signed_volume() {
        let gloss = match (report.kind(), volume < 0.0) {
            (Kind::Volume, _) => "sum of the signed volumes of the cells",
            (_, false) => "positive: the faces look outward",
            (_, true) => "negative: the faces look inward",
        };
        page.fact("signed volume", PLAIN, &number(volume), gloss);
    }
    if let Some(system) = report.reference_system() {
        page.fact("reference", PLAIN, &system.to_string(), "of the coordinates");
    }
    let point = |point: [f64; 3]| point.map(number).join("  ");
    match (report.mass(), report.surface_centroid()) {
        (Some(mass), _) => {
            page.fact("center of mass", PLAIN, &point(mass.centroid()), "");
            let rows = mass.inertia();
            page.fact("inertia", PLAIN, &point(rows[0]), "about the center, density 1");
            rows[1..].iter().for_each(|&row| page.fact("", PLAIN, &point(row), ""));
        }
        (None, Some(center)) => page.fact("center of area", PLAIN, &point(center), ""),
        (None, None) => {}
    }
    for moment in report.moments() {
        let [a, b, c] = moment.exponents();
        let digits = |value: Option<f64>| value.map_or("-".to_owned(), |value| format!("{value:.15e}"));
        let label = format!("x^{a} y^{b} z^{c}");
        page.fact(&label, PLAIN, &digits(moment.volume()), "integral over the volume");
        page.fact("", PLAIN, &digits(moment.surface()), "integral over the surface");
    }
}

/// The named numbers on cells.
fn data(page: &mut Page, report: &Report, limit: usize) {
    let label = |i: usize| if i == 0 { "data" } else { "" };
    for (i, data) in report.data().iter().take(limit.saturating_mul(2)).enumerate() {
        let thing = match (data.components(), data.is_integral()) {
            (1, true) => "an integer".to_owned(),
            (1, false) => "a real number".to_owned(),
            (components, true) => format!("{components} integers"),
            (components, false) => format!("{components} real numbers"),
        };
        let range = match data.range() {
            Some([least, largest]) if data.is_integral() => format!(", {least} to {largest}"),
            Some([least, largest]) => format!(", {} to {}", number(least), number(largest)),
            None => String::new(),
        };
        let name: String = data.name().chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        page.fact(label(i), PLAIN, &format!("{name} on {}", data.kind()), &format!("{thing} each{range}"));
    }
    let rest = report.data().len().saturating_sub(limit.saturating_mul(2));
    if rest > 0 {
        page.fact("", GLOSS, &format!("and {rest} more (--all lists all)"), "");
    }
}

/// The named parts, where there are several.
fn named_parts(page: &mut Page, report: &Report, limit: usize) {
    let most = limit.saturating_mul(2);
    let parts = report.groups();
    if parts.len() < 2 {
        return;
    }
    for (i, part) in parts.iter().take(most).enumerate() {
        let name = part.name();
        let noun = match part.kind() {
            GroupKind::Vertices => "vertex",
            GroupKind::Lines => "line",
            GroupKind::Polygons => "polygon",
            GroupKind::Cells => "cell",
        };
        let hint = match (i, part.kind()) {
            (0, GroupKind::Polygons) => format!("; FILE#{name} is read alone"),
            _ => String::new(),
        };
        let label = if i == 0 { "groups" } else { "" };
        page.fact(label, PLAIN, name, &format!("{}{hint}", count(part.count(), noun)));
    }
    let rest = parts.len().saturating_sub(most);
    if rest > 0 {
        page.fact("", GLOSS, &format!("and {rest} more (--all lists all)"), "");
    }
}

/// Six significant digits.
///
/// # Examples
/// ```
/// assert_eq!(coface_answers::text::number(0.5), "0.5");
/// ```
pub fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-4..1e7).contains(&size) {
        let digits = (5 - size.log10().floor() as i32).clamp(0, 9) as usize;
        let text = format!("{value:.digits$}");
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        format!("{value:.5e}")
    }
}

/// A number to so many digits after the first: as [`number`] where it is neither large nor small, with an exponent else; 0 is 0.
///
/// # Examples
/// ```
/// use coface_answers::text::rounded;
/// assert_eq!([rounded(0.0, 1), rounded(1.25, 2), rounded(1.5e-9, 1), rounded(12345.0, 1)], ["0", "1.25", "1.5e-9", "12345"]);
/// ```
pub fn rounded(value: f64, digits: usize) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e6).contains(&size) {
        let decimals = (digits as i32 - size.log10().floor() as i32).clamp(0, 12) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{value:.digits$e}")
    }
}

fn problems(page: &mut Page, report: &Report, limit: usize) {
    let faults = report.geometry().map_or(&[][..], GeometryFacts::faults);
    let (of_surface, of_solid): (Vec<&Fault>, Vec<&Fault>) =
        faults.iter().partition(|fault| fault.scope() == FaultScope::Surface);
    let said: Vec<&str> = report.problems().iter().map(Problem::message).collect();
    let of_geometry: Vec<String> = of_surface.iter().map(|fault| geometry_sentence(fault)).collect();
    let drawn = report.drawn_polygons().map_or(&[][..], DrawnPolygons::faults);
    let of_drawn: Vec<String> = drawn.iter().map(DrawnFault::sentence).collect();
    let remarks: Vec<&String> = (report.warnings().iter())
        .filter(|warning| !said.contains(&warning.as_str()))
        .filter(|warning| !of_geometry.contains(warning) && !of_drawn.contains(warning))
        .collect();
    page.blank();
    let has_problems = !said.is_empty() || !remarks.is_empty() || !of_surface.is_empty() || !drawn.is_empty();
    if has_problems {
        page.heading("problems");
        for problem in report.problems() {
            let emphasis = match problem.kind() {
                ProblemKind::NonManifoldRidge
                | ProblemKind::NonManifoldEdge
                | ProblemKind::NonManifoldVertex => BAD,
                _ => ODD,
            };
            bullet(page, emphasis, problem.message());
            places(page, problem, limit);
        }
        for (fault, sentence) in of_surface.iter().zip(&of_geometry) {
            bullet(page, BAD, sentence);
            fault_places(page, fault, limit);
        }
        for (fault, sentence) in drawn.iter().zip(&of_drawn) {
            bullet(page, BAD, sentence);
            // The sentence has the first place.
            for place in fault.places.iter().take(limit).skip(1) {
                let ring = |&(polygon, ring): &(usize, usize)| match ring {
                    0 => format!("polygon {polygon}"),
                    hole => format!("hole {hole} of polygon {polygon}"),
                };
                let rings: Vec<String> = place.rings.iter().map(ring).collect();
                let [x, y] = place.point.map(number);
                page.paragraph(6, PLAIN, &format!("{} at ({x}, {y})", rings.join(", ")));
            }
            more_of(page, 6, fault.places.len(), limit, "place");
        }
        for remark in remarks {
            bullet(page, ODD, remark);
        }
    }
    if let Some(GeometryFacts::Unchecked(reason)) = report.geometry() {
        if !has_problems {
            page.paragraph(2, GOOD, "The cells have no problems.");
        }
        let cure = if reason.is_a_choice() { " (--check geometry checks it)" } else { "" };
        page.paragraph(2, GLOSS, &format!("The geometry is not checked: {reason}{cure}."));
    } else if !of_solid.is_empty() {
        if !has_problems {
            page.paragraph(2, GOOD, "The surface has no faults.");
        }
        page.heading("not the boundary of one solid");
        for fault in &of_solid {
            bullet(page, ODD, &geometry_sentence(fault));
            fault_places(page, fault, limit);
        }
    } else if !has_problems {
        page.paragraph(2, GOOD, "No problems found.");
    }
}

/// The first places of a fault: its faces, else its vertices, with a point.
fn fault_places(page: &mut Page, fault: &Fault, limit: usize) {
    let list = |letter: char, numbers: &[u32]| -> String {
        let shown: Vec<String> = numbers.iter().take(8).map(|number| format!("{letter}{number}")).collect();
        shown.join(NO_BREAK)
    };
    for place in fault.places().iter().take(limit) {
        let mut line = match (&place.faces[..], &place.vertices[..]) {
            ([], vertices) => list('v', vertices),
            (faces, []) => list('f', faces),
            (faces, vertices) => format!("{{{}}} in {}", list('v', vertices), list('f', faces)),
        };
        if let Some(point) = place.point {
            line += &format!(" at ({})", point.map(number).join(", "));
        }
        if let Some(distance) = place.distance {
            line += &format!(", {} off the plane", number(distance));
        }
        page.paragraph(6, PLAIN, &line);
    }
    more_of(page, 6, fault.count(), limit, "place");
}

fn bullet(page: &mut Page, emphasis: Emphasis, words: &str) {
    page.items.push(Item::Bullet { emphasis, words: escaped(words).into_owned() });
}

/// The first places of a problem: the cells by their vertices, and the top cells that meet there.
fn places(page: &mut Page, problem: &Problem, limit: usize) {
    let (cells, tops) = (problem.cells(), problem.tops());
    let letter = if problem.top_name() == "cell" { 'c' } else { 'f' };
    let name = |i: usize| {
        let vertices: Vec<String> = cells.list(i).iter().map(|vertex| format!("v{vertex}")).collect();
        match vertices.len() {
            1 => vertices.concat(),
            // The spaces inside a cell do not break a line.
            _ => format!("{{{}}}", vertices.join(NO_BREAK)),
        }
    };
    let meeting = |i: usize| -> Vec<String> {
        if i < tops.len() {
            tops.list(i).iter().map(|top| format!("{letter}{top}")).collect()
        } else {
            Vec::new()
        }
    };
    let shown = cells.len().min(limit);
    if (0..shown).all(|i| meeting(i).is_empty()) {
        // Short names run on in lines: isolated vertices.
        let names: Vec<String> = (0..cells.len().min(limit.saturating_mul(3))).map(name).collect();
        page.paragraph(6, PLAIN, &names.join(" "));
        more_of(page, 6, cells.len(), names.len(), "place");
        return;
    }
    for i in 0..shown {
        let meeting = meeting(i);
        let first: Vec<String> = meeting.iter().take(8).cloned().collect();
        let more = if meeting.len() > first.len() { " .." } else { "" };
        page.paragraph(6, PLAIN, &format!("{} in {}{more}", name(i), first.join(" ")));
    }
    more_of(page, 6, cells.len(), limit, "place");
}

/// How many simplices of a set are printed.
const MANY: usize = 200;

/// A set of simplices for people.
pub fn simplices(what: &str, set: &SimplexSet) -> String {
    let mut page = Page::default();
    let counts: Vec<String> = set
        .f_vector()
        .iter()
        .enumerate()
        .filter(|&(_, &number)| number > 0)
        .map(|(degree, &number)| match degree {
            0 => count(number, "vertex"),
            1 => count(number, "edge"),
            2 => count(number, "triangle"),
            3 => count(number, "tetrahedron"),
            degree => count(number, &format!("simplex of dimension {degree}")),
        })
        .collect();
    page.title(
        what,
        if set.is_complex() { "a complex" } else { "a set, not a complex: some faces are missing" },
    );
    page.paragraph(2, PLAIN, &if counts.is_empty() { "empty".to_owned() } else { counts.join(", ") });
    let names: Vec<String> = set
        .iter()
        .take(MANY)
        .map(|simplex| {
            let vertices: Vec<String> = simplex.numbers().iter().map(ToString::to_string).collect();
            format!("{{{}}}", vertices.join(NO_BREAK))
        })
        .collect();
    page.paragraph(4, PLAIN, &names.join(" "));
    if set.len() > MANY {
        page.paragraph(4, GLOSS, &format!("and {} more (--json lists all)", grouped(set.len() - MANY)));
    }
    page.finished()
}
