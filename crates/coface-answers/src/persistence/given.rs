//! Persistence diagrams that users give: our JSON, tables, and what other programs write.

use crate::answer::{Place, Remark, RemarkCode};
use coface_algebra::Error;
use coface_io::{NumberTable, with_decimal_points};
use coface_topology::Barcode;
use serde_json::Value;

/// A class of a higher degree is an oversight.
const HIGHEST_DEGREE: usize = 255;

/// A persistence diagram of a file or an array: a barcode for each degree.
///
/// # Examples
/// ```
/// use coface_answers::GivenDiagram;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let table = GivenDiagram::read("a.csv", b"birth,death,dimension\n0,inf,0\n0.5,2,0\n1,3,1\n")?;
/// assert_eq!(table.barcode(0).intervals(), [[0.0, f64::INFINITY], [0.5, 2.0]]);
/// assert_eq!(table.degree_count(), 2);
/// let gudhi = GivenDiagram::read("a.pers", b"2 1 1 3\n")?;
/// assert_eq!(gudhi.barcode(1).intervals(), [[1.0, 3.0]]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GivenDiagram {
    name: String,
    degrees: Vec<Barcode>,
    /// For each class its place in the file.
    places: Vec<Vec<usize>>,
    /// For each class which of its ends belong to its life.
    ends: Vec<Vec<Ends>>,
    is_of_points: bool,
    is_extended: bool,
    remarks: Vec<Remark>,
}

/// Whether a class is there at the values of its birth and of its death: at its birth alone, but for classes of zigzags.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Ends {
    is_birth_open: bool,
    is_death_closed: bool,
}

/// What the kind of a class says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Zigzag(Ends),
    /// Ordinary, relative or extended.
    Extended,
}

impl Kind {
    /// The kind of this name, as it is written for zigzags and extended persistence.
    fn of(name: &str) -> Option<Self> {
        let zigzag =
            |is_birth_open, is_death_closed| Some(Self::Zigzag(Ends { is_birth_open, is_death_closed }));
        match name {
            "closed-open" => zigzag(false, false),
            "closed-closed" => zigzag(false, true),
            "open-open" => zigzag(true, false),
            "open-closed" => zigzag(true, true),
            "ordinary" | "relative" | "extended+" | "extended-" => Some(Self::Extended),
            _ => None,
        }
    }
}

/// A class of a file: degree, birth and death, and its kind if it has one.
type Class = (usize, [f64; 2], Option<Kind>);

/// Classes in the order of a file.
type Classes = Vec<Class>;

impl GivenDiagram {
    /// The diagram of these barcodes, one for each degree from 0 on.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::GivenDiagram;
    /// use coface_topology::Barcode;
    /// assert_eq!(GivenDiagram::new("a", vec![Barcode::default()]).degree_count(), 1);
    /// ```
    pub fn new(name: &str, degrees: Vec<Barcode>) -> Self {
        let mut next = 0..;
        let places =
            degrees.iter().map(|barcode| next.by_ref().take(barcode.intervals().len()).collect()).collect();
        let ends = degrees.iter().map(|barcode| vec![Ends::default(); barcode.intervals().len()]).collect();
        let name = name.to_owned();
        Self { name, degrees, places, ends, is_of_points: false, is_extended: false, remarks: Vec::new() }
    }

    /// The same diagram, said to be of points: it has only the degrees that were asked for.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DiagramCurveKind, DiagramCurvesRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let diagram = GivenDiagram::new("a", Vec::new()).of_points();
    /// let answer = DiagramCurvesRequest::new(DiagramCurveKind::Euler).answer(&diagram)?;
    /// assert!(answer.remarks[0].message.contains("not the Euler characteristic"));
    /// # Ok(()) }
    /// ```
    pub fn of_points(mut self) -> Self {
        self.is_of_points = true;
        self
    }

    /// The diagram in a file of this name: the JSON of `coface persistence`, lists `[degree, [birth, death]]` as of GUDHI or `[[birth, death], ..]`
    /// for each degree as of Ripser; a `.npy` array; what Ripser prints; or a table with the columns birth and death, and the degree behind them.
    /// A first line of words names the columns, of which `kind` has the kinds of classes of zigzags; files `.pers` of GUDHI and tables of four columns have the degree before births and deaths.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) and [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) with the file
    /// and the line for what is no diagram.
    ///
    /// # Examples
    /// See [`GivenDiagram`].
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, Error> {
        Self::of_bytes(name, bytes).map_err(|error| error.in_file(name))
    }

    fn of_bytes(name: &str, bytes: &[u8]) -> Result<Self, Error> {
        let start = bytes.trim_ascii_start();
        if start.starts_with(b"{") || start.starts_with(b"[") {
            let value = serde_json::from_slice(bytes)
                .map_err(|error| Error::parse(error.to_string()).with_cure(NO_DIAGRAM))?;
            let (classes, is_of_points) = of_json(&value)?;
            let mut found = Self::of_classes(name, classes)?;
            found.is_of_points = is_of_points;
            return Ok(found);
        }
        if bytes.starts_with(b"\x93NUMPY") {
            return Self::of_rows(name, &NumberTable::read(bytes)?.of_numbers_only()?, None);
        }
        let text = std::str::from_utf8(bytes).map_err(|_| no_diagram("the file is no text"))?;
        if text.contains("persistence intervals in dim") {
            return Self::of_classes(name, of_ripser(text)?);
        }
        let (text, commas) = with_decimal_points(text.as_bytes())?;
        let text = std::str::from_utf8(&text).map_err(|_| no_diagram("the file is no text"))?;
        let (head, table) = table_of(text)?;
        let mut found = Self::of_rows(name, &table, head.as_ref())?;
        found.remarks.extend(commas);
        Ok(found)
    }

    fn of_classes(name: &str, classes: Classes) -> Result<Self, Error> {
        let count = classes.iter().map(|&(degree, ..)| degree + 1).max().unwrap_or(0);
        let mut intervals = vec![Vec::new(); count];
        let mut places = vec![Vec::new(); count];
        let mut ends = vec![Vec::new(); count];
        let is_extended = classes.iter().any(|&(.., kind)| kind == Some(Kind::Extended));
        for (place, (degree, interval, kind)) in classes.into_iter().enumerate() {
            intervals[degree].push(interval);
            places[degree].push(place);
            ends[degree].push(match kind {
                Some(Kind::Zigzag(ends)) => ends,
                _ => Ends::default(),
            });
        }
        let degrees = intervals.into_iter().map(Barcode::new).collect::<Result<_, Error>>()?;
        let name = name.to_owned();
        Ok(Self { name, degrees, places, ends, is_of_points: false, is_extended, remarks: Vec::new() })
    }

    /// Rows of numbers, with the names of the columns if the file has them.
    fn of_rows(name: &str, table: &NumberTable, head: Option<&Head>) -> Result<Self, Error> {
        let is_of_gudhi = name.to_ascii_lowercase().ends_with(".pers");
        let mut remarks = Vec::new();
        let columns = match head {
            Some(head) => named_columns(&head.names)?,
            None => {
                let (columns, said) = columns_of(table, is_of_gudhi)?;
                remarks.extend(said);
                columns
            }
        };
        let width = head.map_or(usize::MAX, |head| head.names.len());
        let class = |row: usize| {
            let numbers = table.row(row);
            if numbers.len() > width {
                let error = no_diagram(format!(
                    "the row has {} numbers, and the header {width} columns",
                    numbers.len()
                ));
                return Err(match table.line(row) {
                    Some(line) => error.at_line(line),
                    None => error,
                });
            }
            let at_line = |error: Error| match table.line(row) {
                Some(line) => error.at_line(line),
                None => error,
            };
            let number = |column: usize| {
                let short = || at_line(no_diagram(format!("the row has {} numbers", numbers.len())));
                numbers.get(column).copied().ok_or_else(short)
            };
            let degree = columns.degree.map_or(Ok(0.0), number)?;
            let interval = [number(columns.birth)?, number(columns.death)?];
            let kind = head.and_then(|head| head.kinds.get(row).copied().flatten());
            Ok((whole_degree(degree).map_err(at_line)?, interval, kind))
        };
        let classes = (0..table.row_count()).map(class).collect::<Result<Classes, Error>>()?;
        Ok(Self { remarks, ..Self::of_classes(name, classes)? })
    }

    /// The name of the file.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::GivenDiagram::new("a", Vec::new()).name(), "a");
    /// ```
    pub fn name(&self) -> &str {
        &self.name
    }

    /// One more than the highest degree that has classes.
    ///
    /// # Examples
    /// See [`GivenDiagram`].
    pub fn degree_count(&self) -> usize {
        self.degrees.len()
    }

    /// The barcode of a degree; an empty one where there are no classes.
    ///
    /// # Examples
    /// See [`GivenDiagram`].
    pub fn barcode(&self, degree: usize) -> Barcode {
        self.degrees.get(degree).cloned().unwrap_or_default()
    }

    /// The barcodes by degree.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::GivenDiagram;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(GivenDiagram::read("a.txt", b"0 1\n")?.barcodes().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn barcodes(&self) -> &[Barcode] {
        &self.degrees
    }

    /// What the reader assumed.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::GivenDiagram;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Degrees may stand before births or behind deaths.
    /// assert_eq!(GivenDiagram::read("a.txt", b"0 1 2\n1 2 3\n")?.remarks().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The barcodes by degree with intervals that have their births and not their deaths, as classes of filtrations live: an end that is open where
    /// others are closed, or closed where others are open, is the next number above.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a diagram of extended persistence, whose classes live on two ways.
    pub(super) fn half_open_barcodes(&self) -> Result<Vec<Barcode>, Error> {
        if self.is_extended {
            let message = "classes of extended persistence live while values rise and while they fall again: they cannot be counted at a value";
            return Err(Error::invalid(message)
                .with_cure("give the diagram of the function without its extension")
                .in_file(&self.name));
        }
        let moved = |(&[birth, death], ends): (&[f64; 2], &Ends)| {
            let end = |end: f64, is_moved: bool| if is_moved { end.next_up() } else { end };
            [end(birth, ends.is_birth_open), end(death, ends.is_death_closed)]
        };
        let one = |(barcode, ends): (&Barcode, &Vec<Ends>)| {
            Barcode::new(barcode.intervals().iter().zip(ends).map(moved).collect())
        };
        self.degrees.iter().zip(&self.ends).map(one).collect()
    }

    /// Whether a class is there at its death, or is not at its birth, as those of zigzags may be.
    pub(super) fn has_open_or_closed_ends(&self) -> bool {
        self.ends.iter().flatten().any(|&ends| ends != Ends::default())
    }

    /// Whether the diagram is of points, which have classes of higher degrees that nobody asked for.
    pub(super) fn is_of_points(&self) -> bool {
        self.is_of_points
    }

    /// The place in the file of a class of a degree.
    pub(super) fn place(&self, degree: usize, class: usize) -> usize {
        self.places[degree][class]
    }
}

const NO_DIAGRAM: &str =
    "give a diagram that coface persistence INPUT -o DIAGRAM.json writes, or a table of births and deaths";

fn no_diagram(message: impl Into<String>) -> Error {
    Error::parse(message).with_cure(NO_DIAGRAM)
}

fn whole_degree(number: f64) -> Result<usize, Error> {
    if number >= 0.0 && number.fract() == 0.0 && number <= HIGHEST_DEGREE as f64 {
        return Ok(number as usize);
    }
    Err(Error::invalid(format!("{number} is no degree of a class"))
        .with_cure(format!("give whole numbers from 0 to {HIGHEST_DEGREE}")))
}

/// The classes of JSON, and whether they are of points.
fn of_json(value: &Value) -> Result<(Classes, bool), Error> {
    let wrong = |what: &Value| no_diagram(format!("{what} is no class of a diagram"));
    let number = |value: &Value, never: f64| match value {
        Value::Null => Some(never),
        Value::String(word) => word.parse().ok(),
        value => value.as_f64(),
    };
    if let Value::Object(object) = value {
        let list = object.get("diagram").and_then(Value::as_array);
        let list = list.ok_or_else(|| no_diagram("the object has no \"diagram\""))?;
        let is_falling = object.get("star").and_then(Value::as_str) == Some("upper");
        let never = if is_falling { f64::NEG_INFINITY } else { f64::INFINITY };
        let class = |class: &Value| {
            let ends = [number(&class["birth"], f64::NAN), number(&class["death"], never)];
            let (Some(degree), [Some(birth), Some(death)]) = (class["degree"].as_f64(), ends) else {
                return Err(wrong(class));
            };
            Ok((whole_degree(degree)?, [birth, death], class["kind"].as_str().and_then(Kind::of)))
        };
        let is_of_points = object.get("threshold").is_some_and(Value::is_number);
        return Ok((list.iter().map(class).collect::<Result<_, Error>>()?, is_of_points));
    }
    let interval = |pair: &Value| match pair.as_array().map(Vec::as_slice) {
        Some([birth, death]) => Some([number(birth, f64::NAN)?, number(death, f64::INFINITY)?]),
        _ => None,
    };
    let mut classes = Vec::new();
    for (place, item) in value.as_array().into_iter().flatten().enumerate() {
        let parts = item.as_array().ok_or_else(|| wrong(item))?;
        match parts.as_slice() {
            [degree, pair] if degree.is_number() && pair.is_array() => {
                let degree = whole_degree(degree.as_f64().unwrap_or(f64::NAN))?;
                classes.push((degree, interval(pair).ok_or_else(|| wrong(item))?, None));
            }
            pairs if pairs.iter().all(Value::is_array) => {
                for pair in pairs {
                    let interval = interval(pair).ok_or_else(|| wrong(pair))?;
                    classes.push((whole_degree(place as f64)?, interval, None));
                }
            }
            _ => classes.push((0, interval(item).ok_or_else(|| wrong(item))?, None)),
        }
    }
    Ok((classes, false))
}

/// What Ripser prints: for each degree a line, and under it the intervals.
fn of_ripser(text: &str) -> Result<Classes, Error> {
    let mut classes = Classes::new();
    let mut degree = None;
    for (line, content) in text.lines().enumerate() {
        let wrong = || no_diagram(format!("{:?} is no interval", content.trim())).at_line(line as u64 + 1);
        if let Some(rest) = content.trim().strip_prefix("persistence intervals in dim") {
            let number = rest.trim().trim_end_matches(':').parse().map_err(|_| wrong())?;
            degree = Some(whole_degree(number)?);
        } else if let (Some(degree), Some(rest)) = (degree, content.trim().strip_prefix('[')) {
            // Behind the interval a version of Ripser prints its cycle.
            let inner = rest.split([')', ']']).next().unwrap_or(rest);
            let (birth, death) = inner.split_once(',').ok_or_else(wrong)?;
            let birth = birth.trim().parse().map_err(|_| wrong())?;
            let death = match death.trim() {
                "" => f64::INFINITY,
                word => word.parse().map_err(|_| wrong())?,
            };
            classes.push((degree, [birth, death], None));
        }
    }
    // Where values fall, what never dies has an empty place too.
    let is_falling = |[birth, death]: [f64; 2]| death < birth;
    if classes.iter().any(|&(_, interval, _)| is_falling(interval)) {
        for (_, interval, _) in classes.iter_mut().filter(|(_, interval, _)| interval[1] == f64::INFINITY) {
            interval[1] = f64::NEG_INFINITY;
        }
    }
    Ok(classes)
}

/// What a first line of words says.
struct Head {
    /// The names of the columns.
    names: Vec<String>,
    /// The kinds of the rows, where a column has them.
    kinds: Vec<Option<Kind>>,
}

/// The rows of a text, and what its first line says.
fn table_of(text: &str) -> Result<(Option<Head>, NumberTable), Error> {
    let mut head: Option<Head> = None;
    let mut table = NumberTable::default();
    for (line, content) in text.lines().enumerate() {
        let content = content.trim();
        if content.is_empty() || content.starts_with('#') || content.starts_with("//") {
            continue;
        }
        let is_list = content.contains([',', ';']);
        let words: Vec<&str> = if is_list {
            content.split([',', ';']).map(str::trim).collect()
        } else {
            content.split_whitespace().collect()
        };
        let is_first = head.is_none() && table.row_count() == 0;
        if is_first && words.iter().all(|word| word.parse::<f64>().is_err()) {
            let names = words.iter().map(|word| word.trim_matches('"').to_lowercase()).collect();
            head = Some(Head { names, kinds: Vec::new() });
            continue;
        }
        // Columns of words, as the cells of a class, stand behind the numbers.
        let numbers: Vec<f64> = words.iter().map_while(|word| number_of(word, is_list)).collect();
        if numbers.len() < 2 {
            let message = format!("{:?} is no birth and death", content.chars().take(60).collect::<String>());
            return Err(no_diagram(message).at_line(line as u64 + 1));
        }
        table.push_row(&numbers, line as u64 + 1);
        if let Some(head) = &mut head {
            let column = head.names.iter().position(|name| name == "kind");
            head.kinds.push(column.and_then(|column| Kind::of(words.get(column)?.trim_matches('"'))));
        }
    }
    Ok((head, table))
}

/// A number; an empty place of a list is the death of a class that never dies.
fn number_of(word: &str, is_list: bool) -> Option<f64> {
    if word.is_empty() && is_list { Some(f64::INFINITY) } else { word.parse().ok() }
}

/// Which columns of a table have what.
struct Columns {
    degree: Option<usize>,
    birth: usize,
    death: usize,
}

fn named_columns(names: &[String]) -> Result<Columns, Error> {
    let place = |wanted: &[&str]| names.iter().position(|name| wanted.contains(&name.as_str()));
    let degree = place(&["degree", "dimension", "dim", "homology_dimension"]);
    match (place(&["birth", "births", "birth_time"]), place(&["death", "deaths", "death_time"])) {
        (Some(birth), Some(death)) => Ok(Columns { degree, birth, death }),
        _ => Err(no_diagram(format!("no columns of the table ({}) are birth and death", names.join(", ")))),
    }
}

/// The columns of a table without names, and what was assumed.
fn columns_of(table: &NumberTable, is_of_gudhi: bool) -> Result<(Columns, Option<Remark>), Error> {
    let count = if table.row_count() == 0 { 2 } else { table.row(0).len() };
    let before = Columns { degree: Some(0), birth: 1, death: 2 };
    let behind = Columns { degree: Some(2), birth: 0, death: 1 };
    let may_be_degrees = |column: usize| {
        let numbers = (0..table.row_count()).filter_map(|row| table.row(row).get(column));
        numbers.clone().count() == table.row_count() && numbers.copied().all(|x| whole_degree(x).is_ok())
    };
    match (count, is_of_gudhi) {
        (2, _) => Ok((Columns { degree: None, birth: 0, death: 1 }, None)),
        (3, true) => Ok((before, None)),
        (3, false) if !may_be_degrees(2) && may_be_degrees(0) => Ok((before, None)),
        (3, false) => {
            let message = "each row was taken for a birth, a death and a degree; a first line \"degree birth death\" says that degrees come first";
            let said = may_be_degrees(0).then(|| {
                Remark::new(RemarkCode::InputReading, message).at(1, table.line(0).map(Place::line))
            });
            Ok((behind, said))
        }
        // The field, the degree, birth and death.
        (4, _) => Ok((Columns { degree: Some(1), birth: 2, death: 3 }, None)),
        _ => Err(no_diagram(format!("the first row has {count} numbers"))),
    }
}
