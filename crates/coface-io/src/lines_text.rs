//! Segments in the plane as text: `x1,y1,x2,y2` a line.
//!
//! Numbers may be separated by blanks or semicolons too; what follows a `#` is a comment. A segment whose ends are
//! equal is a point. Ends with equal coordinates are one vertex, so that a file of the sides of a square is a square.

use super::Model;
use super::decimal::{flush, is_blank};
use super::drawing::{Drawing, Place, closed, push_place, shapes, written_dimension};
use super::scanner::{Scanner, parse_f64};
use coface_algebra::{Error, ErrorKind};
use std::io::{Read, Write};

/// Reads segments.
///
/// # Errors
/// [`ErrorKind::Parse`] with the line that has not four numbers, or one that is not finite; [`ErrorKind::TooLarge`] beyond
/// 2^31 segments; [`ErrorKind::Io`] if the stream fails.
///
/// # Complexity
/// $O(n \log n)$ for n segments, to find equal ends.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let corner = coface_io::lines_text::read(&b"0,0,1,0\n1,0,1,2\n"[..])?;
/// assert_eq!(corner.vertex_count(), 3);
/// assert_eq!(corner.lines().list(1), [1, 2]);
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    let mut scanner = Scanner::new(input);
    let mut drawing = Drawing::default();
    let mut seen = false;
    while let Some(line) = scanner.next_line()? {
        let parsed = segment(line);
        let line = scanner.line_number();
        seen = true;
        if let Some([x1, y1, x2, y2]) = parsed.map_err(|fault| fault.at_line(line))? {
            drawing.corner(Place { x: x1, y: y1, z: None });
            drawing.corner(Place { x: x2, y: y2, z: None });
            drawing.end_line(|| format!("the segment in line {line}"));
        }
    }
    if !seen {
        return Err(Error::parse("the file is empty")
            .at_line(1)
            .with_cure("write \"x1,y1,x2,y2\" for each segment"));
    }
    drawing.finish()
}

/// The four numbers of a line; `None` if there is nothing on it.
fn segment(line: &[u8]) -> Result<Option<[f64; 4]>, Error> {
    let mut numbers = [0.0; 4];
    let mut count = 0;
    for word in words(line) {
        if count == 4 {
            return Err(wrong_count("more than four numbers"));
        }
        numbers[count] = parse_f64(word, "a coordinate")?;
        count += 1;
    }
    match count {
        0 => Ok(None),
        4 => Ok(Some(numbers)),
        1 => Err(wrong_count("one number")),
        _ => Err(wrong_count(&format!("{count} numbers"))),
    }
}

fn wrong_count(what: &str) -> Error {
    Error::parse(format!("a segment has four numbers, and here are {what}"))
        .with_cure("write \"x1,y1,x2,y2\" for each segment")
}

/// The words of a line up to a comment.
fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    let end = memchr::memchr(b'#', line).unwrap_or(line.len());
    line[..end].split(|&byte| matches!(byte, b',' | b';') || is_blank(byte)).filter(|word| !word.is_empty())
}

/// Whether a line, with no comment in it, is a segment. Numbers that are not finite count here: reading says where they are.
pub(super) fn is_segment(line: &[u8]) -> bool {
    let is_number = |word| std::str::from_utf8(word).is_ok_and(|text| text.parse::<f64>().is_ok());
    words(line).count() == 4 && words(line).all(is_number)
}

/// Writes the segments of all lines and the sides of all polygons, then the points, and the vertices that nothing uses,
/// as segments with equal ends. Polylines, polygons, names and data are not kept.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] if the model has 3-cells or no positions, is an abstract structure or does not lie in
/// the plane z = 0; [`ErrorKind::Io`] if the stream fails.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = coface_io::wkt::read(&b"LINESTRING (0 0, 1 0, 1 2)"[..])?;
/// let mut written = Vec::new();
/// coface_io::lines_text::write(&model, &mut written)?;
/// assert_eq!(written, b"0,0,1,0\n1,0,1,2\n");
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut output: impl Write) -> Result<(), Error> {
    use super::drawing::Shape;
    if written_dimension(model, "a file of segments in the plane")? > 2 {
        let message = "a file of segments in the plane cannot hold points outside the plane z = 0";
        return Err(Error::new(ErrorKind::UnsupportedFormat, message).with_cure("write OBJ, GeoJSON or WKT"));
    }
    let mut text = Vec::new();
    let mut push = |from: u32, to: u32| {
        push_place(model, from, 2, b',', &mut text);
        text.push(b',');
        push_place(model, to, 2, b',', &mut text);
        text.push(b'\n');
        flush(&mut text, &mut output)
    };
    let mut written = false;
    for (shape, _) in shapes(model) {
        written = true;
        match shape {
            Shape::Line(i) => side(model.lines.list(i).iter().copied(), &mut push)?,
            Shape::Rings(range) => {
                for i in range {
                    side(model.lines.list(i).iter().copied(), &mut push)?;
                }
            }
            Shape::Face(i) => side(closed(model.polygons.list(i)), &mut push)?,
            Shape::Point(vertex) => push(vertex.to_u32(), vertex.to_u32())?,
        }
    }
    if !written {
        text.extend_from_slice(b"# no segments\n");
    }
    output.write_all(&text)?;
    output.flush()?;
    Ok(())
}

/// Gives the two ends of each segment of a path.
fn side(
    path: impl Iterator<Item = u32>,
    push: &mut impl FnMut(u32, u32) -> Result<(), Error>,
) -> Result<(), Error> {
    let mut last = None;
    for vertex in path {
        if let Some(last) = last {
            push(last, vertex)?;
        }
        last = Some(vertex);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::RaggedArray;
    use proptest::prelude::*;

    #[test]
    fn separators_comments_and_points_are_read() {
        let text = "# a comment\n\n0, 0 ,1 ,0 # side\r\n1 0\t1 1\n1;1;1;1\n0,0,-0.0,5";
        let model = read(text.as_bytes()).unwrap();
        assert_eq!(*model.lines(), RaggedArray::from_lists([[0, 1], [1, 2], [0, 3]]));
        assert_eq!(model.points().len(), 1);
        assert_eq!(model.points()[0].index(), 2);
        assert_eq!(
            model.remarks().iter().map(|remark| &remark.message[..]).collect::<Vec<_>>(),
            ["the segment in line 5 is a single point and kept as one"]
        );
        assert_eq!(read(&b"# nothing\n"[..]).unwrap().vertex_count(), 0);
    }

    #[test]
    fn faults_name_the_line() {
        for (text, line, message) in [
            ("0,0,1,0\n0,0,1\n", 2, "here are 3 numbers"),
            ("\n0,0,1,0,5\n", 2, "more than four"),
            ("0,0,1,x\n", 1, "\"x\" is not a number"),
            ("0,0,1,nan\n", 1, "finite"),
            ("", 1, "empty"),
        ] {
            let error = read(text.as_bytes()).unwrap_err();
            assert_eq!(error.line(), Some(line), "{error}");
            assert!(error.to_string().contains(message), "{error}");
        }
    }

    proptest! {
        #[test]
        fn what_is_written_reads_back(segments in proptest::collection::vec([-2..3i8, -2..3, -2..3, -2..3], 0..20), scale in any::<f64>().prop_filter("finite", |x| (x * 8.0).is_finite())) {
            let mut text = "# segments\n".to_owned();
            for s in &segments {
                let s = s.map(|x| f64::from(x) * scale);
                text += &format!("{:?},{:?},{:?},{:?}\n", s[0], s[1], s[2], s[3]);
            }
            let model = read(text.as_bytes()).unwrap();
            model.check().unwrap();
            let mut written = Vec::new();
            write(&model, &mut written).unwrap();
            let again = read(&written[..]).unwrap();
            prop_assert_eq!(&again, &model);
            prop_assert_eq!(model.lines().len() + model.points().len(), segments.len());
        }
    }
}
