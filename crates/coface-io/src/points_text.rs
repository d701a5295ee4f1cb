//! Points as text (`.xyz`, `.csv`, `.pts`): a point a line, its coordinates first.

use crate::decimal_commas::{whole_text, with_decimal_points};
use crate::numbers::Numbers;
use crate::oddities::Oddities;
use crate::scanner::{Scanner, quoted};
use crate::word_columns::{Header, WordColumns, entries, is_word};
use crate::{CellData, GroupKind, Model};
use coface_algebra::{Error, VertexId};
use std::io::Read;

/// More columns than this are no points.
const MOST_COLUMNS: usize = 256;

/// Reads points: the numbers of a line are separated by blanks, commas or semicolons; a comma in numbers that semicolons, tabs or quotes hold apart is a decimal comma,
/// and a remark says so. A first line of words names the columns; those named
/// `x`, `y` and `z` are the coordinates, without such names the first three or, if there are only two, both. Other columns are data on the
/// vertices, and columns of words are left out with a remark. A line with the count of the points and a line of words behind it, as files of
/// atoms have, are passed over, and so are lines that begin with `#` or `//`.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the line: a word where a number should be, or lines of different lengths.
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = coface_io::points_text::read(&b"id,x,y,z\n7,0,0,1\n8,2,0,1\n"[..])?;
/// assert_eq!(model.positions().as_flat(), [0.0, 0.0, 1.0, 2.0, 0.0, 1.0]);
/// assert_eq!(model.data()[0].integer_row(1), Some(vec![8]));
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    let text = whole_text(input)?;
    let (text, commas) = with_decimal_points(&text)?;
    let mut scanner = Scanner::new(&text[..]);
    let mut header = Header::default();
    let mut names: Option<Vec<String>> = None;
    // The number of entries of a line, the columns of numbers, and those of words, which are left out.
    let (mut width, mut columns, mut of_words) = (0, Vec::new(), WordColumns::default());
    let mut count = 0usize;
    let mut has_count = false;
    // Points with a number that is not finite, and their lines.
    let mut suspects: Vec<(usize, u64)> = Vec::new();
    while let Some(line) = scanner.next_line()? {
        // The first column of tables of pandas has no name.
        let begins_unnamed = matches!(line.first(), Some(b'\t' | b',' | b';'));
        let line = line.trim_ascii();
        if line.is_empty() || line.starts_with(b"#") || line.starts_with(b"//") {
            continue;
        }
        let words = entries(line);
        // Tables end in rows of nothing but separators.
        if words.is_empty() {
            continue;
        }
        if count == 0 && names.is_none() {
            if words.len() == 1 && !has_count && words[0].iter().all(u8::is_ascii_digit) {
                has_count = true;
                continue;
            }
            let has_numbers = words.iter().skip(1).filter(|word| !is_word(word)).count() >= 2;
            if is_word(words[0]) && !has_numbers {
                let lower = |word: &&[u8]| String::from_utf8_lossy(word).to_lowercase();
                let unnamed = begins_unnamed.then(|| "index".to_owned());
                let found: Vec<String> = unnamed.into_iter().chain(words.iter().map(lower)).collect();
                // Files of atoms have a comment behind their count.
                if !has_count {
                    header = Header::of(found.len(), scanner.line_number());
                }
                names = Some(found);
                continue;
            }
        }
        if count == 0 {
            (width, of_words) = (words.len(), WordColumns::of(&words));
            let number_count = width - of_words.count();
            if !(2..=MOST_COLUMNS).contains(&number_count) {
                let numbers = if number_count == 1 { "number" } else { "numbers" };
                let message = format!("a point has {number_count} {numbers}");
                return Err(scanner.error(message).with_cure("write 2 or 3 coordinates a line"));
            }
            columns = vec![Vec::new(); number_count];
        }
        header.note_row(words.len());
        header.check()?;
        if words.len() != width {
            let message = format!("a line has {} entries, and the first has {width}", words.len());
            return Err(scanner.error(message).with_cure("give each point as many numbers"));
        }
        let values = of_words.numbers(&words, "a coordinate");
        let values = values.map_err(|error| error.at_line(scanner.line_number()))?;
        if !values.iter().all(|value| value.is_finite()) {
            suspects.push((count, scanner.line_number()));
        }
        for (column, value) in columns.iter_mut().zip(values) {
            column.push(value);
        }
        count += 1;
    }
    // Names of all columns, with or without names in the file.
    let names = names.filter(|names| names.len() == width);
    let name_of = |column: usize| match &names {
        Some(names) => names[column].clone(),
        None => format!("column_{}", column + 1),
    };
    let (left_out, kept): (Vec<usize>, Vec<usize>) =
        (0..width).partition(|&column| of_words.has_words(column));
    let mut model =
        model(columns, &kept.into_iter().map(name_of).collect::<Vec<String>>(), count, &suspects)?;
    model.remarks.extend(commas);
    if !left_out.is_empty() {
        let shown = left_out.iter().take(5).map(|&column| quoted(name_of(column).as_bytes()));
        let shown: Vec<String> = shown.collect();
        model.remarks.push(of_words.remark(&format!(": {}", shown.join(", "))));
    }
    Ok(model)
}

fn model(
    columns: Vec<Vec<f64>>,
    names: &[String],
    count: usize,
    suspects: &[(usize, u64)],
) -> Result<Model, Error> {
    if count == 0 {
        return Err(Error::parse("the file has no point").with_cure("write 2 or 3 coordinates a line"));
    }
    let named = |name: &str| names.iter().position(|other| other == name);
    let axes: Vec<usize> = match (named("x"), named("y"), named("z")) {
        (Some(x), Some(y), Some(z)) => vec![x, y, z],
        (Some(x), Some(y), None) => vec![x, y],
        _ => (0..columns.len().min(3)).collect(),
    };
    let mut coordinates = Vec::with_capacity(count * axes.len());
    let mut rows: Vec<_> = axes.iter().map(|&axis| columns[axis].iter().copied()).collect();
    for _ in 0..count {
        coordinates.extend(rows.iter_mut().filter_map(Iterator::next));
    }
    let mut data = Vec::new();
    for (i, column) in columns.into_iter().enumerate().filter(|(i, _)| !axes.contains(i)) {
        let mut numbers = Numbers::UInt8(Vec::new());
        column.into_iter().for_each(|value| numbers.push_real(value));
        data.push(CellData::of_file(names[i].clone(), GroupKind::Vertices, 1, numbers));
    }
    let mut oddities = Oddities::default();
    for &(point, line) in suspects {
        let start = point * axes.len();
        oddities.note_unplaced(&coordinates[start..start + axes.len()], point as u64, Some(line));
    }
    let (positions, partial_positions) = crate::model::placed(axes.len(), coordinates)?;
    let mut model = Model {
        vertex_count: count,
        positions,
        partial_positions,
        remarks: oddities.into_remarks(),
        points: (0..count).map(VertexId::new).collect(),
        ..Model::default()
    };
    model.data = crate::data::without_repeated_names(data, &mut model.remarks);
    Ok(model)
}

/// Whether a text may be points: its first line that is no comment has numbers, or names of columns.
pub(super) fn is_likely(start: &[u8]) -> bool {
    let lines = start.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    lines
        .filter(|line| !line.is_empty() && !line.starts_with(b"#") && !line.starts_with(b"//"))
        .take(3)
        .any(|line| entries(line).iter().filter(|word| !is_word(word)).count() >= 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_in_many_dresses() {
        for (text, dimension, count) in [
            ("0 0 1\n2 3 4\n", 3, 2),
            ("# points\n0;0\n2;3\n\n4;5\n", 2, 3),
            ("2\nwater\nO 0 0 0\nH 1 0 0\n", 3, 2),
            ("3\n0 0 0\n1 0 0\n0 1 0\n", 3, 3),
            ("\"X\",\"Y\"\r\n1,2\r\n", 2, 1),
            (";;\n1;2\n;;\n", 2, 1),
            (",x,y\n0,5,6\n1,7,8\n", 2, 2),
            ("\"name, or id\",\"x\",\"y\"\n\"1st, 2nd\",\"5\",\"6\"\n", 2, 1),
        ] {
            let model = read(text.as_bytes()).unwrap();
            assert_eq!((model.positions().dimension(), model.points().len()), (dimension, count), "{text}");
            assert!(is_likely(text.as_bytes()), "{text}");
        }
        for (text, message) in [
            ("", "no point"),
            ("1 2 3\n1 2\n", "line 2: a line has 2 entries"),
            ("id,shape\n1,\"PLYGON((0 0,1 0,1 1,0 0))\"\n", "a point has 1 number"),
            ("1 2 3\n1 2 x\n", "line 2: \"x\" is not a number"),
        ] {
            let error = read(text.as_bytes()).unwrap_err().to_string();
            assert!(error.contains(message), "{error}");
        }
    }
}
