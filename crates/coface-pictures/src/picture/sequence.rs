//! Long exact sequences as diagrams.

use super::flat::{Anchor, FlatPicture, Step};
use super::formula::Formula;
use super::palette::{LIGHT, color};
use coface_answers::answer::{HomologyGroup, SequenceAnswer, SequenceMap, WholeNumber};

/// The middles of the columns, the distance of rows, and where the first one is.
const COLUMNS: [f64; 3] = [170.0, 450.0, 730.0];
const ROW: f64 = 170.0;
const TOP: f64 = 110.0;
const WIDTH: f64 = 900.0;
/// The room below the last row for words.
const FOOT: f64 = 66.0;
/// Half the height of a group, and the gap between it and arrows.
const HALF: f64 = 28.0;
const GAP: f64 = 12.0;
/// The sizes of letters.
const GROUP: f64 = 19.0;
const NAME: f64 = 17.0;
const SMALL: f64 = 13.0;
/// Matrices of more rows or columns, or longer numbers, are named by their rank alone.
const MOST_ENTRIES: [usize; 2] = [3, 4];
const MOST_DIGITS: usize = 3;
/// How far lines of a matrix are from each other.
const LINE: f64 = 15.0;

/// The long exact sequence of a pair (K, L) as a diagram: a row for each degree, from the top down, with the groups of L, of K and of the pair, and
/// connecting maps from the end of a row to the beginning of the next. An arrow with a hook is injective, one with two heads surjective. Below a map is
/// its matrix, whose columns are the images of generators, or the rank of a large one, or 0.
///
/// # Complexity
/// Linear in the entries of the maps.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_answers::{HomologyRequest, RelativeTo};
/// use coface_pictures::sequence_picture;
/// let disk = coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json)?;
/// let request = HomologyRequest::new().relative(Some(RelativeTo::Boundary)).sequence(true);
/// let answer = request.found("disk.json", disk)?.into_answer();
/// let Some(sequence) = &answer.sequence else { unreachable!() };
/// let svg = sequence_picture("a disk and its boundary", sequence).svg(None)?;
/// assert!(svg.contains("isomorphism") && svg.contains("exact"));
/// # Ok(()) }
/// ```
pub fn sequence_picture(title: &str, sequence: &SequenceAnswer) -> FlatPicture {
    let degrees = sequence.complex.len();
    let rows = degrees.max(1);
    let size = [WIDTH, TOP + (rows - 1) as f64 * ROW + HALF + FOOT];
    let mut picture = FlatPicture::new(title, size, LIGHT.background);
    picture.begin_group("title");
    picture.text([0.5 * WIDTH, 34.0], Anchor::Middle, 15.0, LIGHT.ink, title);
    for (row, degree) in (0..degrees).rev().enumerate() {
        let y = TOP + row as f64 * ROW;
        let groups = [&sequence.subcomplex, &sequence.complex, &sequence.pair];
        let halves = [0, 1, 2]
            .map(|column| draw_group(&mut picture, [COLUMNS[column], y], degree, column, groups[column]));
        for (column, map) in ["inclusion", "projection"].into_iter().enumerate() {
            let ends =
                [COLUMNS[column] + halves[column] + GAP, COLUMNS[column + 1] - halves[column + 1] - GAP];
            let drawn = Map::of(sequence, map, degree);
            drawn.arrow(&mut picture, &[[ends[0], y], [ends[1], y]]);
            drawn.words(&mut picture, [f64::midpoint(ends[0], ends[1]), y]);
        }
        draw_end(&mut picture, sequence, degree, y, halves);
        if degree > 0 {
            let middle = y + 0.5 * ROW - 8.0;
            let path = [
                [COLUMNS[2], y + HALF + GAP],
                [COLUMNS[2], middle],
                [COLUMNS[0], middle],
                [COLUMNS[0], y + ROW - HALF - GAP],
            ];
            let drawn = Map::of(sequence, "connecting", degree);
            drawn.arrow(&mut picture, &path);
            drawn.words(&mut picture, [COLUMNS[1], middle]);
        }
    }
    picture.begin_group("legend");
    let foot = size[1] - 34.0;
    if sequence.exact {
        let words = "exact at every group (checked): the image of each map is the kernel of the next";
        picture.text([0.5 * WIDTH, foot], Anchor::Middle, SMALL, LIGHT.ink, words);
    }
    let words = "hook: injective; two heads: surjective; gray: zero; columns of a matrix are the images of generators";
    picture.text([0.5 * WIDTH, foot + 20.0], Anchor::Middle, SMALL, LIGHT.edge, words);
    picture
}

/// The name of a group above what it is; half its width.
fn draw_group(
    picture: &mut FlatPicture,
    [x, y]: [f64; 2],
    degree: usize,
    column: usize,
    groups: &[HomologyGroup],
) -> f64 {
    let space = ["(L)", "(K)", "(K, L)"][column];
    let plain = ["L", "K", "K, L"][column];
    picture.begin_group(&format!("H_{degree}({plain})"));
    let name = in_space(Formula::default().italic("H").scripts(&degree.to_string(), ""), space);
    let group = groups.get(degree).map_or_else(|| Formula::default().upright("0"), group_formula);
    let half = 0.5 * (GROUP * name.width).max(GROUP * group.width);
    picture.formula([x, y - 6.0], Anchor::Middle, GROUP, LIGHT.ink, name);
    picture.formula([x, y + 19.0], Anchor::Middle, GROUP, color(0), group);
    half
}

/// Letters in italics, signs upright.
fn in_space(formula: Formula, space: &str) -> Formula {
    space.chars().fold(formula, |formula, letter| {
        let text = letter.to_string();
        if letter.is_alphabetic() { formula.italic(&text) } else { formula.upright(&text) }
    })
}

/// A sum of cyclic groups.
fn group_formula(group: &HomologyGroup) -> Formula {
    let plus = |formula: Formula, is_first: bool| match is_first {
        true => formula,
        false => formula.space(0.15).upright("\u{2295}").space(0.15),
    };
    let mut formula = Formula::default();
    if group.betti > 0 {
        let exponent = if group.betti > 1 { group.betti.to_string() } else { String::new() };
        formula = formula.bold("Z").scripts("", &exponent);
    }
    for equal in group.torsion.chunk_by(|a, b| a == b) {
        let is_first = formula.runs.is_empty();
        let order = equal[0].to_string();
        formula = plus(formula, is_first);
        formula = match equal.len() {
            1 => formula.bold("Z").upright("/").upright(&order),
            count => formula
                .upright("(")
                .bold("Z")
                .upright("/")
                .upright(&order)
                .upright(")")
                .scripts("", &count.to_string()),
        };
    }
    if formula.runs.is_empty() { formula.upright("0") } else { formula }
}

/// The zeros before the first group and after the last one.
fn draw_end(picture: &mut FlatPicture, sequence: &SequenceAnswer, degree: usize, y: f64, halves: [f64; 3]) {
    let zero = Map { name: Formula::default(), columns: None, known: None, is_zero: true };
    let mut draw = |x: f64, ends: [f64; 2]| {
        picture.begin_group("0");
        picture.formula([x, y + 6.0], Anchor::Middle, GROUP, LIGHT.ink, Formula::default().upright("0"));
        zero.arrow(picture, &[[ends[0], y], [ends[1], y]]);
    };
    if degree + 1 == sequence.complex.len() {
        draw(30.0, [42.0, COLUMNS[0] - halves[0] - GAP]);
    }
    if degree == 0 {
        draw(WIDTH - 30.0, [COLUMNS[2] + halves[2] + GAP, WIDTH - 42.0]);
    }
}

/// A map of the sequence.
struct Map<'s> {
    name: Formula,
    columns: Option<&'s [Vec<WholeNumber>]>,
    known: Option<&'s SequenceMap>,
    is_zero: bool,
}

impl<'s> Map<'s> {
    fn of(sequence: &'s SequenceAnswer, map: &str, degree: usize) -> Self {
        let (maps, name) = match map {
            "inclusion" => (&sequence.inclusion, Formula::default().italic("i")),
            "projection" => (&sequence.projection, Formula::default().italic("j")),
            _ => (&sequence.connecting, Formula::default().upright("\u{2202}")),
        };
        let columns = maps.get(degree).and_then(Option::as_deref);
        let is_zero = columns.is_none_or(|columns| columns.iter().flatten().all(WholeNumber::is_zero));
        let known = sequence.maps.iter().find(|known| known.map == map && known.degree == degree);
        Self { name: name.scripts("\u{2217}", ""), columns, known, is_zero }
    }

    /// Whether it goes from a group that is not zero to another one.
    fn has_entries(&self) -> bool {
        self.columns.is_some_and(|columns| columns.iter().any(|column| !column.is_empty()))
    }

    /// An arrow along a path.
    fn arrow(&self, picture: &mut FlatPicture, path: &[[f64; 2]]) {
        let ink = if self.is_zero { LIGHT.pale } else { LIGHT.ink };
        let [.., before, tip] = path else { return };
        let along = |[x, y]: [f64; 2], [u, v]: [f64; 2]| {
            let length = (u - x).hypot(v - y).max(1e-9);
            [(u - x) / length, (v - y) / length]
        };
        let [dx, dy] = along(*before, *tip);
        let head = |back: f64| {
            let end = [tip[0] - back * dx, tip[1] - back * dy];
            let wing = |side: f64| [end[0] - 8.0 * dx - 4.0 * side * dy, end[1] - 8.0 * dy + 4.0 * side * dx];
            [Step::Move(wing(1.0)), Step::Line(end), Step::Line(wing(-1.0))]
        };
        let mut steps = vec![Step::Move(path[0])];
        steps.extend(path[1..].iter().map(|&point| Step::Line(point)));
        steps.extend(head(0.0));
        // Zero groups make maps injective or surjective that nobody would call so.
        let counts = self.known.filter(|_| self.has_entries());
        if counts.is_some_and(|known| known.surjective) {
            steps.extend(head(6.0));
        }
        if counts.is_some_and(|known| known.injective) {
            let [dx, dy] = along(path[0], path[1]);
            let [x, y] = path[0];
            // A hook to the left of the arrow.
            let at = |ahead: f64, aside: f64| [x + ahead * dx + aside * dy, y + ahead * dy - aside * dx];
            steps.push(Step::Move([x, y]));
            steps.push(Step::Cubic([at(-6.0, 0.0), at(-6.0, 7.0), at(0.0, 7.0)]));
            steps.push(Step::Line(at(3.0, 7.0)));
        }
        let kind = self.known.map_or(String::new(), |known| {
            let kind = match (known.injective, known.surjective) {
                (true, true) => "isomorphism",
                (true, false) => "injective",
                (false, true) => "surjective",
                (false, false) => "neither injective nor surjective",
            };
            format!("{} of degree {}: rank {}, {kind}", known.map, known.degree, known.rank)
        });
        picture.begin_group(&kind);
        picture.line(steps, ink, 1.4, 1.0);
    }

    /// The name above the middle of the arrow, the matrix or the rank below.
    fn words(&self, picture: &mut FlatPicture, [x, y]: [f64; 2]) {
        let ink = if self.is_zero { LIGHT.edge } else { LIGHT.ink };
        picture.formula([x, y - 9.0], Anchor::Middle, NAME, ink, self.name.clone());
        let Some(columns) = self.columns.filter(|_| self.has_entries()) else { return };
        if self.is_zero {
            picture.formula([x, y + 18.0], Anchor::Middle, SMALL + 2.0, ink, Formula::default().upright("0"));
            return;
        }
        let rows = columns.first().map_or(0, Vec::len);
        let digits = columns.iter().flatten().map(|entry| entry.to_string().len()).max().unwrap_or(0);
        if rows > MOST_ENTRIES[0] || columns.len() > MOST_ENTRIES[1] || digits > MOST_DIGITS {
            let rank = self.known.map_or(0, |known| known.rank);
            let words = format!("rank {rank}, {rows} \u{d7} {}", columns.len());
            picture.formula([x, y + 18.0], Anchor::Middle, SMALL, ink, Formula::default().upright(&words));
            return;
        }
        let wide = 0.5 * SMALL * digits as f64 + 9.0;
        let half = 0.5 * wide * columns.len() as f64;
        let (top, bottom) = (y + 7.0, y + 7.0 + LINE * rows as f64 + 3.0);
        for (column, entries) in columns.iter().enumerate() {
            for (row, entry) in entries.iter().enumerate() {
                let at = [x - half + wide * (column as f64 + 0.5), top + LINE * (row as f64 + 0.8) + 1.5];
                let text = entry.to_string().replace('-', "\u{2212}");
                picture.formula(at, Anchor::Middle, SMALL, ink, Formula::default().upright(&text));
            }
        }
        for side in [-1.0, 1.0] {
            let [outer, inner] = [half + 2.0, half - 1.0].map(|reach| x + side * reach);
            let bracket = vec![
                Step::Move([inner, top]),
                Step::Line([outer, top]),
                Step::Line([outer, bottom]),
                Step::Line([inner, bottom]),
            ];
            picture.stroke(bracket, ink, 1.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_answers::{HomologyRequest, RelativeTo};
    use coface_io::{Format, read};

    fn drawn(facets: &str) -> (SequenceAnswer, String) {
        let model = read(facets.as_bytes(), Format::Json).unwrap();
        let request = HomologyRequest::new().relative(Some(RelativeTo::Boundary)).sequence(true);
        let answer = request.found("pair", model).unwrap().into_answer().sequence.unwrap();
        let svg = sequence_picture("pair", &answer).svg(None).unwrap();
        (answer, svg)
    }

    #[test]
    fn a_diagram_has_a_node_for_each_group_and_an_arrow_for_each_map() {
        let (answer, svg) = drawn("[[0,1,2],[1,2,3],[2,3,4],[3,4,0],[4,0,1]]");
        for degree in 0..3 {
            for space in ["L", "K", "K, L"] {
                let title = format!("<title>H_{degree}({space})</title>");
                assert_eq!(svg.matches(&title).count(), 1, "{title}");
            }
        }
        // Two maps in each of three rows, two from row to row, and those from and to zero.
        assert_eq!(svg.matches("stroke-linecap").count(), 3 * 2 + 2 + 2);
        assert_eq!(answer.maps.len(), 3 + 3 + 2 - usize::from(answer.inclusion[2].is_none()));
        // The boundary of a Moebius band goes around twice.
        assert!(svg.contains("inclusion of degree 1: rank 1, injective"));
        assert!(svg.contains("exact at every group"));
        assert!(!svg.contains("NaN"));
    }

    #[test]
    fn torsion_is_a_summand() {
        let group: HomologyGroup =
            serde_json::from_value(serde_json::json!({"degree": 1, "betti": 2, "torsion": [2, 2, 6]}))
                .unwrap();
        let words: String = group_formula(&group).runs.iter().map(|run| run.text.as_str()).collect();
        assert_eq!(words, "Z2\u{2295}(Z/2)2\u{2295}Z/6");
    }
}
