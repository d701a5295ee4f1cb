//! Abaqus input (`.inp`): nodes, elements and sets.

use crate::assembly::Assembly;
use crate::element_kind::Kind;
use crate::scanner::{Scanner, parse_coordinate, parse_i64, quoted};
use crate::{GroupKind, Model, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use std::collections::{BTreeMap, HashMap};
use std::io::Read;

/// Reads the nodes, elements and sets of an Abaqus file; the sets are groups. Elements of higher order are read by their corners. Parts keep
/// their own coordinates: where instances move them, a remark says so.
///
/// # Errors
/// [`ErrorKind::Parse`] and [`ErrorKind::InvalidInput`] with the
/// line: a word where a number should be, an element of a node that is not there, a file without nodes.
///
/// # Complexity
/// Linear.
///
/// # References
/// Dassault Systemes, *Abaqus keywords reference guide*, `*NODE`, `*ELEMENT`, `*NSET` and `*ELSET`.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "*Node\n 1, 0., 0., 0.\n 2, 1., 0., 0.\n 3, 0., 1., 0.\n*Element, type=S3, elset=lid\n 7, 1, 2,\n 3\n";
/// let model = coface_io::abaqus::read(text.as_bytes())?;
/// assert_eq!(model.polygons().list(0), [0, 1, 2]);
/// assert_eq!(model.groups()[0].name(), "lid");
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    let mut scanner = Scanner::new(input);
    let mut mesh = Mesh { assembly: Assembly::new(3), ..Mesh::default() };
    let mut section = Section::Other;
    let mut gathered: Vec<i64> = Vec::new();
    while let Some(line) = scanner.next_line()? {
        let line = line.trim_ascii();
        if line.is_empty() || line.starts_with(b"**") {
            continue;
        }
        let line = String::from_utf8_lossy(line).into_owned();
        let number = scanner.line_number();
        if line.starts_with('*') {
            if !gathered.is_empty() {
                return Err(Error::parse("an element ends before its last node").at_line(number));
            }
            section = mesh.begin(&line).map_err(|error| error.at_line(number))?;
            mesh.awaited = matches!(section, Section::Elements(..)).then_some(number);
            continue;
        }
        mesh.awaited = None;
        mesh.read_data(&mut section, &line, &mut gathered).map_err(|error| error.at_line(number))?;
    }
    if !gathered.is_empty() {
        return Err(Error::parse("the file ends before the last node of an element")
            .at_line(scanner.line_number())
            .with_cure("it was cut short: write it again"));
    }
    mesh.finish()
}

/// What the lines behind a keyword are.
enum Section {
    Nodes {
        set: Option<String>,
        is_cylindrical: bool,
    },
    Elements(ElementType, Option<String>),
    Set {
        is_of_nodes: bool,
        name: String,
        is_range: bool,
    },
    /// The translation of an instance.
    Instance,
    Other,
}

#[derive(Clone, Copy)]
struct ElementType {
    kind: Kind,
    corner_count: usize,
    node_count: usize,
}

impl ElementType {
    /// The type of this name: a family, the number of its nodes, and letters that say how it is integrated.
    fn parse(name: &str) -> Option<Self> {
        const SOLIDS: [&str; 6] = ["C3D", "DC3D", "AC3D", "DCC3D", "SC", "CSS"];
        const PLANES: [&str; 16] = [
            "CPEG", "CPE", "CPS", "CAX", "CGAX", "DC2D", "DCAX", "AC2D", "ACAX", "STRI", "SFM3D", "M3D",
            "R3D", "DS", "SAX", "S",
        ];
        const LINES: [&str; 10] = ["PIPE2", "PIPE3", "T2D", "T3D", "R2D", "B2", "B3", "RB2D", "RB3D", "DC1D"];
        let family = |families: &[&str]| {
            let prefix = families
                .iter()
                .filter(|family| name.starts_with(**family))
                .max_by_key(|family| family.len())?;
            let rest = &name[prefix.len()..];
            let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
            digits.parse::<usize>().ok()
        };
        let (kind, corner_count, node_count) = if let Some(nodes) = family(&SOLIDS) {
            match nodes {
                4 | 10 => (Kind::TETRAHEDRON, 4, nodes),
                5 | 13 => (Kind::PYRAMID, 5, nodes),
                6 | 15 => (Kind::WEDGE, 6, nodes),
                8 | 20 | 27 => (Kind::HEXAHEDRON, 8, nodes),
                _ => return None,
            }
        } else if let Some(nodes) = family(&LINES) {
            match (nodes, name.starts_with('B') || name.starts_with("PIPE")) {
                // Beams name their order behind the dimension: B31, B32, B33.
                (1 | 3, true) => (Kind::Line, 2, 2),
                (2, true) => (Kind::Line, 2, 3),
                (2, false) => (Kind::Line, 2, 2),
                (3, false) => (Kind::Line, 2, 3),
                _ => return None,
            }
        } else {
            match family(&PLANES)? {
                3 => (Kind::Polygon, 3, 3),
                6 | 65 => (Kind::Polygon, 3, 6),
                4 => (Kind::Polygon, 4, 4),
                nodes @ (8 | 9) => (Kind::Polygon, 4, nodes),
                _ => return None,
            }
        };
        Some(Self { kind, corner_count, node_count })
    }

    /// The corners in the order of the cells here; quadratic elements name the corners first.
    fn reorder(self, nodes: &[u32]) -> Vec<u32> {
        // A line of three nodes has the middle one in between.
        if self.kind == Kind::Line && self.node_count == 3 {
            return vec![nodes[0], nodes[2], nodes[1]];
        }
        nodes.to_vec()
    }
}

#[derive(Default)]
struct Mesh {
    assembly: Assembly,
    vertices: HashMap<i64, u32>,
    elements: HashMap<i64, (GroupKind, u32)>,
    /// The numbers of the groups by their names.
    groups: BTreeMap<String, i64>,
    /// Types of elements that are not known, with how many there are.
    unknown: BTreeMap<String, usize>,
    moved: usize,
    /// The names of the files that are included.
    included: Vec<String>,
    /// Sets of nodes or not, and the names of sets in them that had no member yet.
    ahead: Vec<(bool, String, String)>,
    /// How many surfaces there are.
    surfaces: usize,
    /// The line of the last keyword, if elements should stand behind it and none does.
    awaited: Option<u64>,
}

impl Mesh {
    /// Begins what a keyword says.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] for nodes in spherical coordinates, and for nodes and elements that are made of others.
    fn begin(&mut self, line: &str) -> Result<Section, Error> {
        let unsupported = |message: String, cure: &str| {
            Err(Error::new(ErrorKind::UnsupportedFormat, message).with_cure(cure))
        };
        let mut words = line[1..].split(',').map(str::trim);
        let keyword = words.next().unwrap_or_default().to_ascii_uppercase();
        let mut parameters: BTreeMap<String, String> = BTreeMap::new();
        for word in words {
            let (name, value) = word.split_once('=').unwrap_or((word, ""));
            parameters.insert(name.trim().to_ascii_uppercase(), value.trim().trim_matches('"').to_owned());
        }
        let mut parameter = |name: &str| parameters.remove(name).filter(|value| !value.is_empty());
        Ok(match keyword.as_str() {
            "NODE" => {
                let system = parameter("SYSTEM").unwrap_or_default().to_ascii_uppercase();
                if system.starts_with('S') {
                    return unsupported(
                        "the nodes are in spherical coordinates".to_owned(),
                        "write them in rectangular ones: *NODE, SYSTEM=R",
                    );
                }
                Section::Nodes { set: parameter("NSET"), is_cylindrical: system.starts_with('C') }
            }
            "NGEN" | "NFILL" | "NCOPY" | "NMAP" | "ELGEN" | "ELCOPY" => {
                return unsupported(
                    format!("nodes or elements are made of others by *{keyword}, which is not read"),
                    "write the file with all its nodes and elements",
                );
            }
            "ELEMENT" => {
                let name = parameter("TYPE").unwrap_or_default().to_ascii_uppercase();
                match ElementType::parse(&name) {
                    Some(element) => Section::Elements(element, parameter("ELSET")),
                    None => {
                        *self.unknown.entry(name).or_default() += 1;
                        Section::Other
                    }
                }
            }
            "NSET" | "ELSET" => {
                let is_of_nodes = keyword == "NSET";
                let name = parameter(&keyword).unwrap_or_else(|| keyword.clone());
                Section::Set { is_of_nodes, name, is_range: parameters.contains_key("GENERATE") }
            }
            "PART" => {
                // Each part numbers its nodes and elements for itself.
                self.vertices.clear();
                self.elements.clear();
                Section::Other
            }
            "SURFACE" => {
                self.surfaces += 1;
                Section::Other
            }
            "INSTANCE" => Section::Instance,
            "INCLUDE" => {
                self.included.push(parameter("INPUT").unwrap_or_default());
                Section::Other
            }
            _ => Section::Other,
        })
    }

    fn read_data(&mut self, section: &mut Section, line: &str, gathered: &mut Vec<i64>) -> Result<(), Error> {
        let words: Vec<&str> = line.split(',').map(str::trim).filter(|word| !word.is_empty()).collect();
        match section {
            Section::Other => {}
            Section::Instance => {
                self.moved += 1;
                *section = Section::Other;
            }
            Section::Nodes { set, is_cylindrical } => {
                let Some((number, rest)) = words.split_first() else { return Ok(()) };
                let number = parse_i64(number.as_bytes(), "the number of a node")?;
                let mut point = [0.0; 3];
                if rest.is_empty() {
                    return Err(Error::parse("a node without coordinates").with_cure("write number, x, y, z"));
                }
                for (word, x) in rest.iter().zip(&mut point) {
                    *x = parse_coordinate(word.as_bytes(), "a coordinate")?;
                }
                if *is_cylindrical {
                    let (sine, cosine) = sine_and_cosine(point[1]);
                    point = [point[0] * cosine, point[0] * sine, point[2]];
                }
                let vertex = self.assembly.vertex_count() as u32;
                self.assembly.add_vertex(&point)?;
                if self.vertices.insert(number, vertex).is_some() {
                    return Err(Error::invalid(format!("node {number} stands twice"))
                        .with_cure("give each node a number of its own"));
                }
                if let Some(name) = set.clone() {
                    self.add_to_group(GroupKind::Vertices, &name, vertex);
                }
            }
            Section::Elements(element, set) => {
                for word in words {
                    gathered.push(parse_i64(word.as_bytes(), "a node of an element")?);
                }
                if gathered.len() <= element.node_count {
                    return Ok(());
                }
                let numbers = std::mem::take(gathered);
                let nodes: Result<Vec<u32>, Error> = numbers[1..=element.node_count]
                    .iter()
                    .map(|number| {
                        self.vertices.get(number).copied().ok_or_else(|| {
                            Error::invalid(format!(
                                "an element names node {number}, which is not among the nodes"
                            ))
                            .with_cure("the file is damaged, or was written wrongly: write it again")
                        })
                    })
                    .collect();
                let nodes = element.reorder(&nodes?);
                let member = self.assembly.add(element.kind, element.corner_count, &nodes, u64::from)?;
                if let Some(member) = member {
                    let kind = element.kind.group_kind();
                    self.elements.insert(numbers[0], (kind, member));
                    if let Some(name) = set.clone() {
                        self.add_to_group(kind, &name, member);
                    }
                }
            }
            Section::Set { is_of_nodes, name, is_range } => {
                // What is no number is the name of a set whose members are members too.
                let (name, is_of_nodes) = (name.clone(), *is_of_nodes);
                let mut numbers: Vec<i64> = Vec::new();
                for word in words {
                    match parse_i64(word.as_bytes(), "a member") {
                        Ok(number) => numbers.push(number),
                        Err(_) if self.add_set(is_of_nodes, &name, word) => {}
                        Err(_) => self.ahead.push((is_of_nodes, name.clone(), word.to_owned())),
                    }
                }
                match (*is_range, numbers.as_slice()) {
                    (true, &[first, last]) => self.add_range(is_of_nodes, &name, first, last, 1),
                    (true, &[first, last, step]) if step > 0 => {
                        self.add_range(is_of_nodes, &name, first, last, step);
                    }
                    (true, _) => {
                        let line = quoted(line.as_bytes());
                        return Err(Error::parse(format!("{line} is no range of a set"))
                            .with_cure("write first, last, step"));
                    }
                    (false, numbers) => {
                        numbers.iter().for_each(|&number| self.add_member(is_of_nodes, &name, number));
                    }
                }
            }
        }
        Ok(())
    }

    /// Adds the members from first to last of which there are any: a range may be far longer than the list of nodes.
    fn add_range(&mut self, is_of_nodes: bool, name: &str, first: i64, last: i64, step: i64) {
        let is_in = |number: i64| number >= first && number <= last && (number - first) % step == 0;
        let mut numbers: Vec<i64> = if is_of_nodes {
            self.vertices.keys().copied().filter(|&number| is_in(number)).collect()
        } else {
            self.elements.keys().copied().filter(|&number| is_in(number)).collect()
        };
        numbers.sort_unstable();
        numbers.into_iter().for_each(|number| self.add_member(is_of_nodes, name, number));
    }

    fn add_member(&mut self, is_of_nodes: bool, name: &str, number: i64) {
        let found = match is_of_nodes {
            true => self.vertices.get(&number).map(|&vertex| (GroupKind::Vertices, vertex)),
            false => self.elements.get(&number).copied(),
        };
        if let Some((kind, member)) = found {
            self.add_to_group(kind, name, member);
        }
    }

    /// Adds the members of another set; false if there is none of that name so far. Case makes no difference in names.
    fn add_set(&mut self, is_of_nodes: bool, name: &str, other: &str) -> bool {
        let other = other.trim_matches('"');
        let named = self.groups.iter().find(|(known, _)| known.eq_ignore_ascii_case(other));
        let Some((_, &number)) = named else { return false };
        let kinds: &[GroupKind] = match is_of_nodes {
            true => &[GroupKind::Vertices],
            false => &[GroupKind::Lines, GroupKind::Polygons, GroupKind::Cells],
        };
        let mut is_there = false;
        for &kind in kinds {
            for member in self.assembly.group_members(kind, number).to_vec() {
                is_there = true;
                self.add_to_group(kind, name, member);
            }
        }
        is_there
    }

    fn add_to_group(&mut self, kind: GroupKind, name: &str, member: u32) {
        let next = self.groups.len() as i64 + 1;
        let group = *self.groups.entry(name.to_owned()).or_insert(next);
        self.assembly.name_group(kind, group, name.to_owned());
        self.assembly.add_to_group(kind, group, member);
    }

    fn finish(mut self) -> Result<Model, Error> {
        if self.assembly.vertex_count() == 0 {
            return Err(Error::parse("the file has no node").with_cure(match self.included.first() {
                None => "check that this is an Abaqus input file with a section *NODE".to_owned(),
                Some(name) => format!(
                    "the nodes are in a file that *INCLUDE names, {}: read that one",
                    quoted(name.as_bytes())
                ),
            }));
        }
        for _ in 0..=self.ahead.len() {
            let before = self.ahead.len();
            let ahead = std::mem::take(&mut self.ahead);
            for (is_of_nodes, name, other) in ahead {
                if !self.add_set(is_of_nodes, &name, &other) {
                    self.ahead.push((is_of_nodes, name, other));
                }
            }
            if self.ahead.is_empty() || self.ahead.len() == before {
                break;
            }
        }
        let mut say = |code, message: String, count| {
            self.assembly.remarks.push(Remark::new(code, message).at(count, []));
        };
        for (name, &count) in &self.unknown {
            let message = format!("elements of the type {} are left out", quoted(name.as_bytes()));
            say(RemarkCode::UnknownSection, message, count);
        }
        if self.awaited.is_some() {
            let message = "the file ends where elements should stand behind *ELEMENT: it may be cut there";
            say(RemarkCode::MissingEnd, message.to_owned(), 1);
        }
        if self.moved > 0 {
            let message = "instances move their parts; the parts are read as they stand".to_owned();
            say(RemarkCode::InputReading, message, self.moved);
        }
        if let Some((_, name, other)) = self.ahead.first() {
            let message = format!(
                "the set {} names {}, which is no set with members here",
                quoted(name.as_bytes()),
                quoted(other.as_bytes())
            );
            say(RemarkCode::DataLeftOut, message, self.ahead.len());
        }
        if let Some(name) = self.included.first() {
            let message = format!("other files are included, and left out: {}", quoted(name.as_bytes()));
            say(RemarkCode::UnknownSection, message, self.included.len());
        }
        let surfaces = self.surfaces;
        let mut model = self.assembly.finish()?;
        if surfaces > 0 {
            model.unread.push(("surfaces (*SURFACE)", surfaces));
        }
        // A member that several sets give is one.
        for group in &mut model.groups {
            group.members.sort_unstable();
            group.members.dedup();
        }
        Ok(model)
    }
}

/// The sine and cosine of an angle in degrees, without an error at the multiples of a right angle.
fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        angle => angle.to_radians().sin_cos(),
    }
}

/// Whether a text may be Abaqus input: its first line that is no comment is a keyword.
pub(super) fn is_likely(start: &[u8]) -> bool {
    let mut lines = start.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with(b"**"));
    first.is_some_and(|line| line.len() > 1 && line[0] == b'*' && line[1].is_ascii_alphabetic())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_sets_and_what_is_left_out() {
        let text = "** a comment\n*HEADING\nany words, 1, 2\n*NODE, NSET=all\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n5, .5, 0, 0\n\
                    *ELEMENT, TYPE=C3D4\n10, 1, 2, 3, 4\n*ELEMENT, TYPE=B32, ELSET=beam\n11, 1, 5, 2\n*Element, type=MASS\n12, 1\n\
                    *NSET, NSET=some, GENERATE\n1, 1000000000000, 2\n*ELSET, ELSET=both\n10, 11,\n*STEP\n";
        assert!(is_likely(text.as_bytes()));
        let model = read(text.as_bytes()).unwrap();
        assert_eq!((model.cells().len(), model.lines().list(0), model.vertex_count()), (1, &[0, 1][..], 4));
        let groups: Vec<_> =
            model.groups().iter().map(|group| (group.name(), group.kind(), group.members().len())).collect();
        assert!(
            groups.contains(&("some", GroupKind::Vertices, 2))
                && groups.contains(&("both", GroupKind::Cells, 1))
        );
        assert!(groups.contains(&("beam", GroupKind::Lines, 1)));
        let codes: Vec<_> = model.remarks().iter().map(|remark| remark.code).collect();
        assert_eq!(codes, [RemarkCode::UnknownSection, RemarkCode::HigherOrder]);
        let error = read(text.replace("10, 1, 2, 3, 4", "10, 1, 2, 3, 9").as_bytes()).unwrap_err();
        assert!(error.to_string().contains("line 11: an element names node 9"), "{error}");
    }

    #[test]
    fn sets_may_have_sets() {
        let text = "*NODE\n1, 0,0,0\n2, 1,0,0\n3, 0,1,0\n4, 0,0,1\n5, 1,1,1\n*ELEMENT, TYPE=C3D4\n10, 1,2,3,4\n11, 2,3,4,5\n\
                    *ELSET, ELSET=ALL\nboth, 11\n*ELSET, ELSET=A\n10\n*ELSET, ELSET=B\n11\n*ELSET, ELSET=BOTH\na, B\n*NSET, NSET=NA\n1,2\n\
                    *NSET, NSET=NB\nNA, 5\n*NSET, NSET=NC\nnothing\n*SURFACE, NAME=S\nA, S1\n";
        let model = read(text.as_bytes()).unwrap();
        let members = |name: &str| {
            let group = model.groups().iter().find(|group| group.name() == name);
            group.map(|group| group.members().to_vec()).unwrap_or_default()
        };
        assert_eq!([members("BOTH"), members("ALL"), members("A")], [vec![0, 1], vec![0, 1], vec![0]]);
        assert_eq!(members("NB"), [0, 1, 4]);
        assert_eq!(
            model.remarks()[0].message,
            "the set \"NC\" names \"nothing\", which is no set with members here"
        );
        assert_eq!(model.unread(), [("surfaces (*SURFACE)", 1)]);
    }

    #[test]
    fn coordinates_may_be_cylindrical() {
        let text =
            "*NODE, SYSTEM=C\n1, 1, 0, 0\n2, 1, 90, 0\n3, 2, 180, 5\n4, 1, 45, 0\n*NODE\n5, 1, 90, 0\n";
        let model = read(text.as_bytes()).unwrap();
        let half = 0.5f64.sqrt();
        let expected = [1., 0., 0., 0., 1., 0., -2., 0., 5., half, half, 0., 1., 90., 0.];
        let found = model.positions().as_flat();
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15), "{found:?}");
        for (text, message) in [
            ("*NODE, SYSTEM=S\n1, 1, 90, 0\n", "spherical"),
            ("*NODE\n1, 1, 90, 0\n*NGEN\n1, 5, 1\n", "made of others by *NGEN"),
            ("*HEADING\n*INCLUDE, INPUT=nodes.inp\n", "no node"),
        ] {
            let error = read(text.as_bytes()).unwrap_err();
            assert!(error.to_string().contains(message) && error.cure().is_some(), "{error}");
        }
        let error = read(&b"*HEADING\n*INCLUDE, INPUT=nodes.inp\n"[..]).unwrap_err();
        assert!(error.cure().unwrap().contains("\"nodes.inp\""), "{error}");
    }
}
