//! Writing OBJ.

use super::groups::{MOST_NAMES, Statement};
use crate::decimal::{flush, push_f64, push_natural};
use crate::limits::{require_dimension, require_mesh};
use crate::{Group, GroupKind, GroupRole, Model};
use coface_algebra::{Error, ErrorKind};
use std::collections::BTreeMap;
use std::io::Write;

/// Writes a model in OBJ: polygons, then lines, then points.
///
/// Coordinates are written so that they read back bit for bit; fewer than three are filled up with zeros. Groups of
/// polygons are written as `g`, with all names of a polygon in one statement, objects as `o` and materials as `usemtl`; these give one name at a time:
/// an object that shares a polygon with another is a group. `_` stands for the blanks in a name behind `g`, and at the ends of others. Data `red`, `green` and `blue` on vertices, a byte each, stand behind the coordinates as numbers from 0 to 1, as many
/// programs write and read them. [Texture coordinates](Model::texture_coordinates) are written as `vt`; then
/// vertices at one place with one number in data `source` are one, so that a surface that was cut open to be laid out is whole. Lines and points have the names of their groups too. Groups of vertices that are no points are left out.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] naming formats that serve if the model has 3-cells, no positions or more than three
/// coordinates a vertex, or is an abstract structure; [`ErrorKind::InvalidInput`] if two groups would have one name;
/// [`ErrorKind::Io`] if the stream fails.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = coface_io::obj::read("v 0 0 0\nv 1 0 0\nv 0 0.5 0\ng t\nf 1 2 3\n".as_bytes())?;
/// let mut written = Vec::new();
/// coface_io::obj::write(&triangle, &mut written)?;
/// assert_eq!(coface_io::obj::read(&written[..])?, triangle);
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut output: impl Write) -> Result<(), Error> {
    require_mesh(model, "OBJ", "MEDIT, MSH or VTK")?;
    require_dimension(model, "OBJ", 3)?;
    let names = Names::new(&groups_of(model, GroupKind::Polygons), model.polygons.len())?;
    let mut text =
        format!("# {} vertices, {} polygons\n", model.vertex_count, model.polygons.len()).into_bytes();
    let colors = model.vertex_colors();
    let texture = model.texture_coordinates();
    let numbers = texture.is_some().then(|| whole_vertices(model));
    let points = model.coordinates().chunks_exact(model.coordinate_count().max(1));
    let mut written = 0;
    for (vertex, point) in points.enumerate() {
        if numbers.as_ref().is_some_and(|numbers| numbers[vertex] < written) {
            continue;
        }
        written += 1;
        text.push(b'v');
        for i in 0..3 {
            text.push(b' ');
            push_f64(&mut text, point.get(i).copied().unwrap_or(0.0));
        }
        for color in colors.iter().flatten() {
            text.push(b' ');
            push_short(&mut text, color.numbers().real(vertex) / 255.0);
        }
        text.push(b'\n');
        flush(&mut text, &mut output)?;
    }
    for vertex in (0..model.vertex_count).filter(|_| texture.is_some()) {
        text.extend_from_slice(b"vt");
        for data in texture.iter().flatten() {
            text.push(b' ');
            push_f64(&mut text, data.numbers().real(vertex));
        }
        text.push(b'\n');
        flush(&mut text, &mut output)?;
    }
    let numbers = numbers.as_deref();
    let named_points = groups_of_points(model);
    let lines = Names::of_others(&groups_of(model, GroupKind::Lines), model.lines.len()).unwrap_or_default();
    let points = Names::of_others(&named_points.iter().collect::<Vec<_>>(), model.points.len());
    let single: Vec<[u32; 1]> = model.points.iter().map(|point| [point.to_u32()]).collect();
    let mut writer = Writer { text, output, numbers };
    writer.write(b'f', &names, model.polygons.iter())?;
    if !model.lines.is_empty() || !model.points.is_empty() {
        writer.end(&names)?;
    }
    writer.write(b'l', &lines, model.lines.iter())?;
    if !model.points.is_empty() {
        writer.end(&lines)?;
    }
    writer.write(b'p', &points.unwrap_or_default(), single.iter().map(|point| &point[..]))?;
    writer.output.write_all(&writer.text)?;
    writer.output.flush()?;
    Ok(())
}

/// The number of groups that [`write`] leaves out: of vertices that are no points, and of lines and points whose names as words would be the same.
pub(crate) fn lost_groups(model: &Model) -> usize {
    let vertices = model.groups.iter().filter(|group| group.kind() == GroupKind::Vertices).count();
    let points = groups_of_points(model);
    let kept = match Names::of_others(&points.iter().collect::<Vec<_>>(), model.points.len()) {
        Some(_) => points.len(),
        None => 0,
    };
    let lines = groups_of(model, GroupKind::Lines);
    let count = lines.len();
    vertices - kept + if Names::of_others(&lines, model.lines.len()).is_some() { 0 } else { count }
}

/// The groups of a kind; those without members are polygons to a reader.
fn groups_of(model: &Model, kind: GroupKind) -> Vec<&Group> {
    let is_there =
        |group: &&Group| group.kind() == kind && (kind == GroupKind::Polygons || !group.members().is_empty());
    model.groups.iter().filter(is_there).collect()
}

/// The groups of vertices that are all points, as groups of these.
fn groups_of_points(model: &Model) -> Vec<Group> {
    let groups = model.groups.iter().filter(|group| group.kind() == GroupKind::Vertices);
    if model.points.is_empty() {
        return Vec::new();
    }
    let mut places: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for (place, point) in model.points.iter().enumerate() {
        places.entry(point.to_u32()).or_default().push(place as u32);
    }
    let as_points = |group: &Group| {
        let mut members = Vec::new();
        for vertex in group.members() {
            members.extend(places.get(vertex)?);
        }
        (!members.is_empty()).then(|| Group { members, ..group.clone() })
    };
    groups.filter_map(as_points).collect()
}

/// What has been written and what is to come.
struct Writer<'a, W> {
    text: Vec<u8>,
    output: W,
    numbers: Option<&'a [u32]>,
}

impl<W: Write> Writer<'_, W> {
    /// Writes elements of a kind, with the names of their groups.
    fn write<'e>(
        &mut self,
        keyword: u8,
        names: &Names,
        elements: impl Iterator<Item = &'e [u32]>,
    ) -> Result<(), Error> {
        names.declare(&mut self.text);
        let mut naming = names.namings.iter().peekable();
        for (i, vertices) in elements.enumerate() {
            while let Some(naming) = naming.next_if(|naming| naming.polygon as usize <= i) {
                names.push_statement(&mut self.text, naming.statement, &naming.groups)?;
            }
            push_statement(&mut self.text, keyword, vertices, self.numbers);
            flush(&mut self.text, &mut self.output)?;
        }
        Ok(())
    }

    /// Ends the names that hold up to the last element of a kind.
    fn end(&mut self, names: &Names) -> Result<(), Error> {
        let mut last: Vec<Statement> = Vec::new();
        for naming in names.namings.iter().rev() {
            if !last.contains(&naming.statement) {
                last.push(naming.statement);
                if naming.groups.is_empty() && naming.polygon as usize == names.count {
                    names.push_statement(&mut self.text, naming.statement, &[])?;
                }
            }
        }
        Ok(())
    }
}

/// A share with at most four decimals.
fn push_short(text: &mut Vec<u8>, share: f64) {
    push_f64(text, (share * 1e4).round() / 1e4);
}

/// The names of the groups of polygons, of lines or of points, and the statements that give them.
#[derive(Default)]
struct Names {
    /// The number of elements.
    count: usize,
    /// The names behind `g`, and behind `o` and `usemtl`, which may have blanks.
    words: Vec<String>,
    titles: Vec<String>,
    /// The statement that names each first.
    statements: Vec<Statement>,
    /// In the order of their polygons.
    namings: Vec<Naming>,
    /// Whether the statements name the groups in another order than theirs, or leave some out.
    to_declare: bool,
}

/// A statement in front of a polygon: these groups, and no others of its kind, hold what follows.
struct Naming {
    polygon: u32,
    statement: Statement,
    groups: Vec<usize>,
}

impl Names {
    /// The names of groups of lines or points; `None` if OBJ has no room for all of them.
    fn of_others(groups: &[&Group], count: usize) -> Option<Self> {
        let names = Self::new(groups, count).ok()?;
        names.namings.iter().all(|naming| naming.groups.len() <= MOST_NAMES).then_some(names)
    }

    fn new(groups: &[&Group], count: usize) -> Result<Self, Error> {
        let names: Vec<&str> = (0..groups.len()).map(|group| plain_name(groups, group)).collect();
        let words: Vec<String> = names.iter().map(|name| one_word(name)).collect();
        let titles: Vec<String> = names.iter().map(|name| one_line(name)).collect();
        let mut namings = Vec::new();
        let mut rest: Vec<usize> = Vec::new();
        let mut statements = vec![Statement::Group; groups.len()];
        for statement in [Statement::Object, Statement::Material] {
            let of_role: Vec<usize> =
                (0..groups.len()).filter(|&group| groups[group].has_role(statement.role())).collect();
            let (alone, others) = apart(groups, &of_role, count);
            rest.extend(others);
            for &group in alone.iter().filter(|&&group| {
                !groups[group].has_role(GroupRole::Object) || statement == Statement::Object
            }) {
                statements[group] = statement;
            }
            require_distinct(&alone, &titles)?;
            add_namings(groups, &alone, statement, &mut namings);
        }
        let words_of: Vec<usize> = (0..groups.len())
            .filter(|group| groups[*group].has_role(GroupRole::Group) || rest.contains(group))
            .collect();
        require_distinct(&words_of, &words)?;
        add_namings(groups, &words_of, Statement::Group, &mut namings);
        namings.sort_by_key(|naming| {
            let first =
                naming.groups.iter().find(|&&group| first_member(groups[group]) == Some(naming.polygon));
            (naming.polygon, first.copied().unwrap_or(usize::MAX))
        });
        let mut named = vec![false; groups.len()];
        let mut order = Vec::with_capacity(groups.len());
        for &group in namings.iter().flat_map(|naming| &naming.groups) {
            if !std::mem::replace(&mut named[group], true) {
                order.push(group);
            }
        }
        let to_declare = !order.iter().copied().eq(0..groups.len());
        Ok(Self { count, words, titles, statements, namings, to_declare })
    }

    /// Names all groups once, without polygons, so that a reader meets them in their order.
    fn declare(&self, text: &mut Vec<u8>) {
        if !self.to_declare {
            return;
        }
        let mut used = Vec::new();
        let mut words = 0;
        for (group, title) in self.titles.iter().enumerate() {
            let statement = self.statements[group];
            if statement == Statement::Group && used.last() == Some(&statement) && words < MOST_NAMES {
                text.pop();
                text.extend_from_slice(format!(" {}\n", self.words[group]).as_bytes());
                words += 1;
                continue;
            }
            let name = if statement == Statement::Group { &self.words[group] } else { title };
            text.extend_from_slice(format!("{} {name}\n", statement.keyword()).as_bytes());
            words = 1;
            used.push(statement);
        }
        used.sort_unstable();
        used.dedup();
        for statement in used {
            text.extend_from_slice(format!("{}\n", statement.keyword()).as_bytes());
        }
    }

    fn push_statement(
        &self,
        text: &mut Vec<u8>,
        statement: Statement,
        groups: &[usize],
    ) -> Result<(), Error> {
        if groups.len() > MOST_NAMES {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                format!(
                    "a polygon lies in {} groups; OBJ is written with at most {MOST_NAMES}",
                    groups.len()
                ),
            )
            .with_cure("write MSH or VTK, or leave groups out"));
        }
        text.extend_from_slice(statement.keyword().as_bytes());
        let names = if statement == Statement::Group { &self.words } else { &self.titles };
        for &group in groups {
            text.push(b' ');
            text.extend_from_slice(names[group].as_bytes());
        }
        text.push(b'\n');
        Ok(())
    }
}

/// The name without the keyword that reading puts in front of it where a group before it has the name.
fn plain_name<'a>(groups: &[&'a Group], group: usize) -> &'a str {
    let name = groups[group].name();
    let role = |statement: &Statement| groups[group].has_role(statement.role());
    let statements = [Statement::Object, Statement::Material, Statement::Group];
    statements
        .into_iter()
        .filter(role)
        .filter_map(|statement| name.strip_prefix(statement.keyword())?.strip_prefix(':'))
        .find(|plain| groups[..group].iter().any(|before| before.name() == *plain))
        .unwrap_or(name)
}

/// Those of these groups that share no polygon with one of them before, and the others: `o` and `usemtl` give one name at a time.
fn apart(groups: &[&Group], wanted: &[usize], polygon_count: usize) -> (Vec<usize>, Vec<usize>) {
    let mut taken = vec![false; if wanted.is_empty() { 0 } else { polygon_count }];
    wanted.iter().partition(|&&group| {
        let members = groups[group].members();
        let free = members.iter().all(|&polygon| !taken[polygon as usize]);
        if free {
            members.iter().for_each(|&polygon| taken[polygon as usize] = true);
        }
        free
    })
}

fn first_member(group: &Group) -> Option<u32> {
    group.members().iter().min().copied()
}

/// # Errors
/// [`ErrorKind::InvalidInput`] if two of these groups would have one name.
fn require_distinct(groups: &[usize], names: &[String]) -> Result<(), Error> {
    let mut sorted: Vec<&String> = groups.iter().map(|&group| &names[group]).collect();
    sorted.sort_unstable();
    match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(Error::invalid(format!("two groups would have the name \"{}\" in OBJ", pair[0]))
            .with_cure("rename one of them")),
        None => Ok(()),
    }
}

/// Adds the statements of one kind, where one of these groups begins or has ended.
fn add_namings(groups: &[&Group], wanted: &[usize], statement: Statement, namings: &mut Vec<Naming>) {
    // (polygon, group, whether it begins there)
    let mut changes = Vec::new();
    for &group in wanted {
        let mut members = groups[group].members().to_vec();
        members.sort_unstable();
        members.dedup();
        for run in members.chunk_by(|a, b| a + 1 == *b) {
            changes.push((run[0], group, true));
            changes.push((run[run.len() - 1] + 1, group, false));
        }
    }
    changes.sort_by_key(|&(polygon, ..)| polygon);
    let mut current: Vec<usize> = Vec::new();
    for at_one in changes.chunk_by(|a, b| a.0 == b.0) {
        for &(_, group, begins) in at_one {
            match current.binary_search(&group) {
                Ok(at) if !begins => {
                    current.remove(at);
                }
                Err(at) if begins => current.insert(at, group),
                _ => {}
            }
        }
        namings.push(Naming { polygon: at_one[0].0, statement, groups: current.clone() });
    }
}

/// The name with `_` for each blank or control character, and for the backslash that would continue the line.
fn one_word(name: &str) -> String {
    if name.is_empty() {
        return "_".to_owned();
    }
    name.chars().map(|c| if c.is_whitespace() || c.is_control() || c == '\\' { '_' } else { c }).collect()
}

/// The name with its blanks, with `_` for those at its ends, for control characters and backslashes.
fn one_line(name: &str) -> String {
    let inner = name.trim();
    if inner.is_empty() {
        return one_word(name);
    }
    let start = name.len() - name.trim_start().len();
    let ends = start + inner.len();
    let written = |(at, c): (usize, char)| match c {
        _ if at < start || at >= ends || c.is_control() || c == '\\' => '_',
        _ => c,
    };
    name.char_indices().map(written).collect()
}

/// Adds a statement about vertices, which are written under these numbers if they are not all their own; then faces have texture coordinates.
fn push_statement(text: &mut Vec<u8>, keyword: u8, vertices: &[u32], numbers: Option<&[u32]>) {
    text.push(keyword);
    for &vertex in vertices {
        text.push(b' ');
        let number = numbers.map_or(vertex, |numbers| numbers[vertex as usize]);
        push_natural(text, u64::from(number) + 1);
        if keyword == b'f' && numbers.is_some() {
            text.push(b'/');
            push_natural(text, u64::from(vertex) + 1);
        }
    }
    text.push(b'\n');
}

/// The number of each vertex when those at one place with one `source` are one, in the order of the first ones.
fn whole_vertices(model: &Model) -> Vec<u32> {
    let count = model.vertex_count;
    let source = model.data_named("source", GroupKind::Vertices).filter(|data| data.is_integral());
    let Some(source) = source else { return (0..count as u32).collect() };
    let dimension = model.coordinate_count();
    let bits = |vertex: usize, axis: usize| match axis < dimension {
        true => model.coordinates()[vertex * dimension + axis].to_bits(),
        false => 0,
    };
    let mut keys: Vec<(i64, [u64; 3], u32)> = (0..count)
        .map(|vertex| {
            let number = source.integer_row(vertex).map_or(-1, |row| row[0]);
            (number, [0, 1, 2].map(|axis| bits(vertex, axis)), vertex as u32)
        })
        .collect();
    keys.sort_unstable();
    let mut first = vec![0; count];
    for same in keys.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        same.iter().for_each(|key| first[key.2 as usize] = same[0].2);
    }
    let mut numbers: Vec<u32> = Vec::with_capacity(count);
    let mut next = 0;
    for (vertex, &first) in first.iter().enumerate() {
        if first as usize == vertex {
            numbers.push(next);
            next += 1;
        } else {
            numbers.push(numbers[first as usize]);
        }
    }
    numbers
}
