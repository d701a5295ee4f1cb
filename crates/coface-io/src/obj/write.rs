//! Writing OBJ.

use super::groups::MOST_NAMES;
use crate::decimal::{flush, push_f64, push_natural};
use crate::limits::{require_dimension, require_mesh};
use crate::{GroupKind, Model};
use coface_algebra::{Error, ErrorKind};
use std::io::Write;

/// Writes a model in OBJ.
///
/// Coordinates are written so that they read back bit for bit; fewer than three are filled up with zeros. Groups of
/// polygons are written as `g`, with all names of a polygon in one statement; `_` stands for the blanks in a name, which
/// `g` does not allow. Data `red`, `green` and `blue` on vertices, a byte each, stand behind the coordinates as numbers from 0 to 1, as many
/// programs write and read them; our reader passes over them. [Texture coordinates](Model::texture_coordinates) are written as `vt`; then
/// vertices at one place with one number in data `source` are one, so that a surface that was cut open to be laid out is whole. OBJ has no names for vertices and lines: such groups are left out.
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
    let names = Names::new(model)?;
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
    names.declare(&mut text);
    let mut changes = names.changes.iter().peekable();
    let mut current: Vec<usize> = Vec::new();
    for (i, polygon) in model.polygons.iter().enumerate() {
        if changes.peek().is_some_and(|change| change.polygon as usize <= i) {
            while let Some(change) = changes.next_if(|change| change.polygon as usize <= i) {
                match current.binary_search(&change.group) {
                    Ok(at) if !change.enters => {
                        current.remove(at);
                    }
                    Err(at) if change.enters => current.insert(at, change.group),
                    _ => {}
                }
            }
            names.push_statement(&mut text, &current)?;
        }
        push_statement(&mut text, b'f', polygon, numbers);
        flush(&mut text, &mut output)?;
    }
    for line in model.lines.iter() {
        push_statement(&mut text, b'l', line, numbers);
        flush(&mut text, &mut output)?;
    }
    for point in &model.points {
        push_statement(&mut text, b'p', &[point.to_u32()], numbers);
        flush(&mut text, &mut output)?;
    }
    output.write_all(&text)?;
    output.flush()?;
    Ok(())
}

/// A share with at most four decimals.
fn push_short(text: &mut Vec<u8>, share: f64) {
    push_f64(text, (share * 1e4).round() / 1e4);
}

/// The names of the groups of polygons and where they begin and end.
struct Names {
    names: Vec<String>,
    changes: Vec<Change>,
    /// Whether the groups come in another order than their first polygons, or some have none.
    to_declare: bool,
}

/// A polygon at which a group begins or has ended.
struct Change {
    polygon: u32,
    group: usize,
    enters: bool,
}

impl Names {
    fn new(model: &Model) -> Result<Self, Error> {
        let groups: Vec<_> =
            model.groups.iter().filter(|group| group.kind() == GroupKind::Polygons).collect();
        let names: Vec<String> = groups.iter().map(|group| one_word(group.name())).collect();
        let mut sorted: Vec<&String> = names.iter().collect();
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(Error::invalid(format!("two groups would have the name \"{}\" in OBJ", pair[0]))
                .with_cure("rename one of them"));
        }
        let mut changes = Vec::new();
        let mut firsts = Vec::with_capacity(groups.len());
        for (group, members) in groups.iter().map(|group| group.members()).enumerate() {
            let mut members = members.to_vec();
            members.sort_unstable();
            members.dedup();
            firsts.push(members.first().copied());
            for run in members.chunk_by(|a, b| a + 1 == *b) {
                changes.push(Change { polygon: run[0], group, enters: true });
                changes.push(Change { polygon: run[run.len() - 1] + 1, group, enters: false });
            }
        }
        changes.sort_by_key(|change| change.polygon);
        let to_declare = !firsts.is_sorted() || firsts.contains(&None);
        Ok(Self { names, changes, to_declare })
    }

    /// Names all groups once, without polygons, so that a reader meets them in their order.
    fn declare(&self, text: &mut Vec<u8>) {
        if self.to_declare {
            for names in self.names.chunks(MOST_NAMES) {
                text.extend_from_slice(format!("g {}\n", names.join(" ")).as_bytes());
            }
            text.extend_from_slice(b"g\n");
        }
    }

    fn push_statement(&self, text: &mut Vec<u8>, groups: &[usize]) -> Result<(), Error> {
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
        text.push(b'g');
        for &group in groups {
            text.push(b' ');
            text.extend_from_slice(self.names[group].as_bytes());
        }
        text.push(b'\n');
        Ok(())
    }
}

/// The name with `_` for each blank or control character, and for the backslash that would continue the line.
fn one_word(name: &str) -> String {
    if name.is_empty() {
        return "_".to_owned();
    }
    name.chars().map(|c| if c.is_whitespace() || c.is_control() || c == '\\' { '_' } else { c }).collect()
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
