//! Points as text (`.xyz`, `.csv`, `.pts`): a point a line, its coordinates first.

use crate::numbers::Numbers;
use crate::oddities::Oddities;
use crate::scanner::{Scanner, parse_coordinate, quoted};
use crate::{CellData, GroupKind, Model, Remark, RemarkCode};
use coface_algebra::{Error, VertexId};
use std::io::Read;

/// More columns than this are no points.
const MOST_COLUMNS: usize = 256;

/// Reads points: the numbers of a line are separated by blanks, commas or semicolons. A first line of words names the columns; those named
/// `x`, `y` and `z` are the coordinates, without such names the first three or, if there are only two, both. Other columns are data on the
/// vertices, and columns of words are left out with a remark. A line with the count of the points, a line of words behind it and a word before the coordinates, as files of atoms have, are
/// passed over, and so are lines that begin with `#` or `//`.
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
    let mut scanner = Scanner::new(input);
    let mut names: Option<Vec<String>> = None;
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut count = 0usize;
    let mut has_count = false;
    // The columns that have words, which are left out.
    let mut has_words: Vec<bool> = Vec::new();
    // Points with a number that is not finite, and their lines.
    let mut suspects: Vec<(usize, u64)> = Vec::new();
    while let Some(line) = scanner.next_line()? {
        let line = line.trim_ascii();
        if line.is_empty() || line.starts_with(b"#") || line.starts_with(b"//") {
            continue;
        }
        let mut words: Vec<&[u8]> =
            line.split(|byte| is_separator(*byte)).filter(|word| !word.is_empty()).collect();
        // Tables end in rows of nothing but separators.
        if words.is_empty() {
            continue;
        }
        let is_number = |word: &&[u8]| parse_coordinate(word, "").is_ok();
        if count == 0 && names.is_none() {
            if words.len() == 1 && !has_count && words[0].iter().all(u8::is_ascii_digit) {
                has_count = true;
                continue;
            }
            let has_numbers = words.iter().skip(1).filter(|word| is_number(word)).count() >= 2;
            if !is_number(&words[0]) && !has_numbers {
                let unquoted = |word: &&[u8]| String::from_utf8_lossy(word).trim_matches('"').to_lowercase();
                names = Some(words.iter().map(unquoted).collect());
                continue;
            }
        }
        // The name of an atom.
        if words.len() > 3
            && !is_number(&words[0])
            && words[1..4].iter().all(is_number)
            && columns.len() != words.len()
        {
            words.remove(0);
        }
        if columns.is_empty() {
            if !(2..=MOST_COLUMNS).contains(&words.len()) {
                let message = format!("a point has {} numbers", words.len());
                return Err(scanner.error(message).with_cure("write 2 or 3 coordinates a line"));
            }
            columns = vec![Vec::new(); words.len()];
        }
        if words.len() != columns.len() {
            let message = format!("a line has {} numbers, and the first has {}", words.len(), columns.len());
            return Err(scanner.error(message).with_cure("give each point as many numbers"));
        }
        // Columns that begin with a word have words.
        if count == 0 {
            has_words = words.iter().map(|word| !is_number(word)).collect();
            if has_words.iter().filter(|has_words| !**has_words).count() < 2 {
                has_words.fill(false);
            }
        }
        let value = |(word, &has_words): (&&[u8], &bool)| match has_words {
            true if is_number(word) => {
                let message = format!("{} is a number, and the column begins with a word", quoted(word));
                Err(Error::parse(message).with_cure("write numbers into all lines of a column, or words"))
            }
            true => Ok(0.0),
            false => parse_coordinate(word, "a coordinate"),
        };
        let values: Result<Vec<f64>, Error> = words.iter().zip(&has_words).map(value).collect();
        let values = values.map_err(|error| error.at_line(scanner.line_number()))?;
        if !values.iter().all(|value| value.is_finite()) {
            suspects.push((count, scanner.line_number()));
        }
        for (column, value) in columns.iter_mut().zip(values) {
            column.push(value);
        }
        count += 1;
    }
    model(columns, &has_words, names, count, &suspects)
}

fn is_separator(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b',' | b';' | b'\r')
}

fn model(
    columns: Vec<Vec<f64>>,
    has_words: &[bool],
    names: Option<Vec<String>>,
    count: usize,
    suspects: &[(usize, u64)],
) -> Result<Model, Error> {
    if count == 0 {
        return Err(Error::parse("the file has no point").with_cure("write 2 or 3 coordinates a line"));
    }
    let names = names.filter(|names| names.len() == columns.len());
    let named = |name: &str| {
        let place = names.as_ref()?.iter().position(|other| other == name)?;
        (!has_words[place]).then_some(place)
    };
    let axes: Vec<usize> = match (named("x"), named("y"), named("z")) {
        (Some(x), Some(y), Some(z)) => vec![x, y, z],
        (Some(x), Some(y), None) => vec![x, y],
        _ => (0..columns.len()).filter(|&column| !has_words[column]).take(3).collect(),
    };
    let mut coordinates = Vec::with_capacity(count * axes.len());
    let mut rows: Vec<_> = axes.iter().map(|&axis| columns[axis].iter().copied()).collect();
    for _ in 0..count {
        coordinates.extend(rows.iter_mut().filter_map(Iterator::next));
    }
    let mut data = Vec::new();
    let name_of =
        |i: usize| names.as_ref().map_or_else(|| format!("column_{}", i + 1), |names| names[i].clone());
    let left_out: Vec<String> = (0..columns.len()).filter(|&i| has_words[i]).map(name_of).collect();
    for (i, column) in columns.into_iter().enumerate().filter(|(i, _)| !axes.contains(i) && !has_words[*i]) {
        let name = name_of(i);
        let mut numbers = Numbers::UInt8(Vec::new());
        column.into_iter().for_each(|value| numbers.push_real(value));
        data.push(CellData::of_file(name, GroupKind::Vertices, 1, numbers));
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
    if !left_out.is_empty() {
        let columns = if left_out.len() == 1 { "a column of words is" } else { "columns of words are" };
        let shown: Vec<String> = left_out.iter().take(5).map(|name| quoted(name.as_bytes())).collect();
        let message = format!("{columns} left out: {}", shown.join(", "));
        model.remarks.push(Remark::new(RemarkCode::DataLeftOut, message).at(left_out.len(), []));
    }
    model.data = crate::data::without_repeated_names(data, &mut model.remarks);
    Ok(model)
}

/// Whether a text may be points: its first line that is no comment has numbers, or names of columns.
pub(super) fn is_likely(start: &[u8]) -> bool {
    let lines = start.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    lines.filter(|line| !line.is_empty() && !line.starts_with(b"#") && !line.starts_with(b"//")).take(3).any(
        |line| {
            let words = line.split(|byte| is_separator(*byte)).filter(|word| !word.is_empty());
            words.filter(|word| parse_coordinate(word, "").is_ok()).count() >= 2
        },
    )
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
        ] {
            let model = read(text.as_bytes()).unwrap();
            assert_eq!((model.positions().dimension(), model.points().len()), (dimension, count), "{text}");
            assert!(is_likely(text.as_bytes()), "{text}");
        }
        for (text, message) in [
            ("", "no point"),
            ("1 2 3\n1 2\n", "line 2: a line has 2 numbers"),
            ("1 2 3\n1 2 x\n", "line 2: \"x\" is not a number"),
        ] {
            let error = read(text.as_bytes()).unwrap_err().to_string();
            assert!(error.contains(message), "{error}");
        }
    }
}
