//! Well-known text: points, lines and polygons with holes.
//!
//! A file holds geometries one after the other, on lines of their own or with `;` between them: `POINT`, `LINESTRING`,
//! `LINEARRING`, `POLYGON`, `TRIANGLE`, the `MULTI` forms, `POLYHEDRALSURFACE`, `TIN` and `GEOMETRYCOLLECTION`, in any
//! case, with `Z`, `M` or `ZM`, and `SRID=..;` in front; `CIRCULARSTRING`, `COMPOUNDCURVE`, `CURVEPOLYGON`, `MULTICURVE` and `MULTISURFACE`
//! become chords. The faces of a `POLYHEDRALSURFACE` or `TIN` with heights become polygons of a mesh in space; of several each is a group.
//! Heights and the number of the reference system are kept, measures passed over.
//! A file whose reference system has a number is written with `SRID=..;` in front of each geometry.
//! A geometry may also be well-known binary in hexadecimal digits, as databases give it. A table with a column of geometries (CSV) is read
//! too: each row is a feature, and its other entries are the properties.
//!
//! Rings of polygons become closed lines with the integers `polygon` and `ring`, as in [`geojson`](super::geojson), and with `feature`, the
//! number of the geometry, where one has several polygons.

use super::decimal::flush;
use super::drawing::{Drawing, Place, Shape, closed, push_list, push_place, written_dimension};
use super::geometries::Geometries;
use super::scanner::{Scanner, parse_f64, quoted};
use super::wkb;
use super::wkt_table;
use super::{Model, ReferenceSystem};
use coface_algebra::{Error, ErrorKind};
use std::io::{Read, Write};

/// The longest word that is read.
const LONGEST: usize = 1 << 12;
/// Collections in collections.
const DEEPEST: usize = 64;
/// How a list begins, what is between its things, and how it ends.
const LIST: [&[u8]; 3] = [b"(", b", ", b")"];
/// So much of a file is looked at to tell whether it is a table.
const START: usize = 1 << 12;
const CURE: &str = "write it as in POLYGON ((0 0, 1 0, 0 1, 0 0))";

/// The kinds of geometry, by their names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Point,
    Line,
    Polygon,
    Points,
    Lines,
    Polygons,
    /// The faces of a surface.
    Faces,
    Collection,
    /// A curve of arcs, or one of lines and arcs.
    Arcs,
    Curve,
    /// What is bounded by curves; many of these.
    CurvePolygon,
    Curves,
    Surfaces,
}

const KINDS: [(&str, Kind); 16] = [
    ("POINT", Kind::Point),
    ("LINESTRING", Kind::Line),
    ("LINEARRING", Kind::Line),
    ("POLYGON", Kind::Polygon),
    ("TRIANGLE", Kind::Polygon),
    ("MULTIPOINT", Kind::Points),
    ("MULTILINESTRING", Kind::Lines),
    ("MULTIPOLYGON", Kind::Polygons),
    ("POLYHEDRALSURFACE", Kind::Faces),
    ("TIN", Kind::Faces),
    ("GEOMETRYCOLLECTION", Kind::Collection),
    ("CIRCULARSTRING", Kind::Arcs),
    ("COMPOUNDCURVE", Kind::Curve),
    ("CURVEPOLYGON", Kind::CurvePolygon),
    ("MULTICURVE", Kind::Curves),
    ("MULTISURFACE", Kind::Surfaces),
];

/// The numbers of a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Axes {
    /// What their number means: x y, x y z or x y z m.
    Counted,
    Z,
    M,
    Zm,
}

/// The kind and axes that a word names, as in `POINT` or `PointZ`.
fn kind_of(word: &[u8]) -> Option<(Kind, Axes)> {
    let word = word.to_ascii_uppercase();
    KINDS.iter().find_map(|&(name, kind)| {
        let axes = axes_of(word.strip_prefix(name.as_bytes())?)?;
        Some((kind, axes))
    })
}

fn axes_of(word: &[u8]) -> Option<Axes> {
    match word {
        b"" => Some(Axes::Counted),
        b"Z" => Some(Axes::Z),
        b"M" => Some(Axes::M),
        b"ZM" => Some(Axes::Zm),
        _ => None,
    }
}

/// Whether a line begins as a geometry does.
pub(super) fn is_geometry(line: &[u8]) -> bool {
    if wkb::is_digits(line) {
        return true;
    }
    let upper = line[..line.len().min(64)].to_ascii_uppercase();
    if let Some(rest) = upper.strip_prefix(b"SRID=") {
        return rest.first().is_some_and(u8::is_ascii_digit);
    }
    let length = upper.iter().position(|byte| !byte.is_ascii_alphabetic()).unwrap_or(upper.len());
    let rest = upper[length..].trim_ascii_start();
    let rest = [&b"ZM"[..], b"Z", b"M"].iter().find_map(|&axes| rest.strip_prefix(axes)).unwrap_or(rest);
    let rest = rest.trim_ascii_start();
    kind_of(&upper[..length]).is_some() && (rest.is_empty() || rest[0] == b'(' || rest.starts_with(b"EMPTY"))
}

/// Reads geometries.
///
/// # Errors
/// [`ErrorKind::Parse`] or [`ErrorKind::InvalidInput`] with the line: a word that is none, a ring that is not closed, a
/// parenthesis that is missing, a number that is none or not finite, an arc without an end; [`ErrorKind::TooLarge`] for collections
/// nested deeper than 64 or beyond 2^32 - 2 corners; [`ErrorKind::Io`] if the stream fails.
///
/// # Complexity
/// $O(n \log n)$ for n corners, to find equal ones.
///
/// # References
/// ISO 19125-1 (2004), *Simple feature access*, section 7.
///
/// # Examples
/// ```
/// use coface_io::{GroupKind, wkt};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 1 2, 2 1, 1 1))\nPOINT (5 5)\n";
/// let model = wkt::read(text.as_bytes())?;
/// assert_eq!(model.lines().list(1), [3, 4, 5, 3]);
/// let ring = model.data_named("ring", GroupKind::Lines).ok_or(coface_algebra::Error::invalid("no rings"))?;
/// assert_eq!(ring.integer_row(1), Some(vec![1]));
/// assert_eq!(model.points().len(), 1);
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_flattened(input, None)
}

/// Reads geometries as [`read`] does. Arcs of circles become chords that are within a distance of them, 32 for a quarter of a circle if it is
/// `None`, with a remark then.
pub(super) fn read_flattened(input: impl Read, flatten: Option<f64>) -> Result<Model, Error> {
    let drawing = Drawing::flattened(flatten);
    let mut scanner = Scanner::new(input);
    if wkt_table::is_table(scanner.available(START)?) {
        return wkt_table::read(scanner, drawing)?.finish();
    }
    let mut reader = Reader { scanner, line: 1, word: Vec::new(), drawing };
    let mut seen = false;
    while let Some(byte) = reader.peek()? {
        if byte == b';' {
            reader.scanner.consume(1);
            continue;
        }
        seen = true;
        reader.drawing.begin_geometry();
        if byte == b'0' {
            wkb::read_digits(&mut reader.scanner, &mut reader.drawing, reader.line)?;
        } else {
            reader.geometry(0)?;
        }
    }
    if !seen {
        return Err(Error::parse("the file has no geometry").at_line(reader.line).with_cure(CURE));
    }
    reader.drawing.finish()
}

/// Draws the one geometry of a text that begins on this line.
///
/// # Errors
/// As of [`read`]; also for what stands behind the geometry.
pub(super) fn draw(text: &[u8], line: u64, drawing: Drawing) -> Result<Drawing, Error> {
    let mut reader = Reader { scanner: Scanner::new(text), line, word: Vec::new(), drawing };
    if text.first() == Some(&b'0') {
        wkb::read_digits(&mut reader.scanner, &mut reader.drawing, line)?;
    } else {
        reader.geometry(0)?;
    }
    match reader.peek()? {
        None => Ok(reader.drawing),
        Some(byte) => Err(reader.fault(format!("{} stands behind a geometry", quoted(&[byte])))),
    }
}

struct Reader<R> {
    scanner: Scanner<R>,
    line: u64,
    word: Vec<u8>,
    drawing: Drawing,
}

impl<R: Read> Reader<R> {
    fn fault(&self, message: impl Into<String>) -> Error {
        Error::parse(message).at_line(self.line).with_cure(CURE)
    }

    /// The next byte that is neither white space nor in a comment, still unread.
    fn peek(&mut self) -> Result<Option<u8>, Error> {
        let mut in_comment = false;
        loop {
            let bytes = self.scanner.available(1)?;
            if bytes.is_empty() {
                return Ok(None);
            }
            let mut passed = 0;
            let mut found = None;
            for &byte in bytes {
                if byte == b'\n' {
                    self.line += 1;
                    in_comment = false;
                } else if byte == b'#' {
                    in_comment = true;
                } else if !in_comment && !byte.is_ascii_whitespace() {
                    found = Some(byte);
                    break;
                }
                passed += 1;
            }
            self.scanner.consume(passed);
            if found.is_some() {
                return Ok(found);
            }
        }
    }

    /// Takes a word of letters, digits, signs and points; it is empty where there is none.
    fn word(&mut self) -> Result<(), Error> {
        self.word.clear();
        self.peek()?;
        let mut length = 0;
        loop {
            let bytes = self.scanner.available(length + 1)?;
            let is_part =
                |byte: &u8| byte.is_ascii_alphanumeric() || matches!(byte, b'+' | b'-' | b'.' | b'_');
            let more = bytes[length.min(bytes.len())..]
                .iter()
                .take(LONGEST + 1)
                .take_while(|&byte| is_part(byte))
                .count();
            length += more;
            if length > LONGEST {
                return Err(self.fault("a word or number is too long"));
            }
            if more == 0 || length < bytes.len() {
                self.word.extend_from_slice(&bytes[..length]);
                self.scanner.consume(length);
                return Ok(());
            }
        }
    }

    /// Takes this byte, which must come next.
    fn expect(&mut self, byte: u8) -> Result<(), Error> {
        match self.peek()? {
            Some(next) if next == byte => {
                self.scanner.consume(1);
                Ok(())
            }
            next => Err(self.unexpected(next, &format!("\"{}\"", char::from(byte)))),
        }
    }

    fn unexpected(&self, next: Option<u8>, wanted: &str) -> Error {
        match next {
            Some(next) => self.fault(format!("{} stands where {wanted} should be", quoted(&[next]))),
            None => self.fault(format!("the file ends where {wanted} should be")),
        }
    }

    fn geometry(&mut self, depth: usize) -> Result<(), Error> {
        self.word()?;
        let mut system = None;
        if depth == 0 && self.word.eq_ignore_ascii_case(b"SRID") {
            self.expect(b'=')?;
            self.word()?;
            let number = std::str::from_utf8(&self.word).ok().and_then(|word| word.parse().ok());
            let Some(number) = number else {
                let fault = self.fault(format!("{} is no number of a reference system", quoted(&self.word)));
                return Err(fault.with_cure("write it as in SRID=4326;POINT (1 2)"));
            };
            system = ReferenceSystem::from_srid(number);
            self.expect(b';')?;
            self.word()?;
        }
        if depth == 0 {
            self.drawing.set_reference(system).map_err(|fault| fault.at_line(self.line))?;
        }
        let Some((kind, axes)) = self.kind()? else { return Ok(()) };
        match kind {
            Kind::Point => {
                self.expect(b'(')?;
                let place = self.place(axes)?;
                self.drawing.point(place);
                self.expect(b')')
            }
            Kind::Line | Kind::Arcs | Kind::Curve => self.curve_of(kind, axes).map(|()| self.end_line()),
            Kind::Polygon => self.polygon(axes, Self::corners),
            Kind::CurvePolygon => self.polygon(axes, Self::curve),
            Kind::Points => self.list(|reader| {
                let nested = reader.peek()? == Some(b'(');
                if nested {
                    reader.expect(b'(')?;
                }
                let place = reader.place(axes)?;
                reader.drawing.point(place);
                if nested { reader.expect(b')') } else { Ok(()) }
            }),
            Kind::Lines => self.list(|reader| reader.corners(axes).map(|()| reader.end_line())),
            Kind::Curves => self.list(|reader| reader.curve(axes).map(|()| reader.end_line())),
            Kind::Polygons => self.list(|reader| reader.polygon(axes, Self::corners)),
            Kind::Faces => {
                self.drawing.begin_surface();
                let read = self.list(|reader| reader.polygon(axes, Self::corners));
                self.drawing.end_surface();
                read
            }
            Kind::Surfaces => self.list(|reader| reader.surface(axes)),
            Kind::Collection if depth == DEEPEST => {
                let message = format!("collections are nested deeper than {DEEPEST}");
                Err(Error::new(ErrorKind::TooLarge, message).at_line(self.line).with_cure("nest them less"))
            }
            Kind::Collection => self.list(|reader| reader.geometry(depth + 1)),
        }
    }

    /// The kind and axes of a geometry whose name is the last word; `None` if it is empty.
    fn kind(&mut self) -> Result<Option<(Kind, Axes)>, Error> {
        if self.word.is_empty() {
            let next = self.peek()?;
            return Err(self.unexpected(next, "the name of a geometry"));
        }
        let Some((kind, mut axes)) = kind_of(&self.word) else {
            let name = quoted(&self.word);
            return Err(self.fault(format!("{name} is not a geometry")));
        };
        if self.peek()? != Some(b'(') {
            self.word()?;
            if let Some(named) =
                axes_of(&self.word.to_ascii_uppercase()).filter(|&named| named != Axes::Counted)
            {
                axes = named;
                if self.peek()? != Some(b'(') {
                    self.word()?;
                } else {
                    self.word.clear();
                }
            }
            if self.word.eq_ignore_ascii_case(b"EMPTY") {
                return Ok(None);
            }
            if !self.word.is_empty() {
                return Err(
                    self.fault(format!("{} stands where \"(\" or EMPTY should be", quoted(&self.word)))
                );
            }
        }
        Ok(Some((kind, axes)))
    }

    /// Things in parentheses with commas between them; each may be EMPTY.
    fn list(&mut self, mut item: impl FnMut(&mut Self) -> Result<(), Error>) -> Result<(), Error> {
        self.expect(b'(')?;
        loop {
            if !self.empty()? {
                item(self)?;
            }
            match self.peek()? {
                Some(b',') => self.scanner.consume(1),
                Some(b')') => {
                    self.scanner.consume(1);
                    return Ok(());
                }
                next => return Err(self.unexpected(next, "\",\" or \")\"")),
            }
        }
    }

    /// Takes the word EMPTY if it comes next.
    fn empty(&mut self) -> Result<bool, Error> {
        if self.peek()?.is_none_or(|byte| !byte.eq_ignore_ascii_case(&b'E')) {
            return Ok(false);
        }
        let is_empty =
            self.scanner.available(5)?.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"EMPTY"));
        if is_empty {
            self.scanner.consume(5);
        }
        Ok(is_empty)
    }

    /// The rings of a polygon, each of which is read by this.
    fn polygon(
        &mut self,
        axes: Axes,
        ring: impl Fn(&mut Self, Axes) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.drawing.begin_polygon();
        self.list(|reader| {
            ring(reader, axes)?;
            let line = reader.line;
            reader.drawing.end_ring(|| format!("the ring that ends in line {line}"));
            Ok(())
        })
    }

    fn end_line(&mut self) {
        let line = self.line;
        self.drawing.end_line(|| format!("the line string that ends in line {line}"));
    }

    /// A polygon of a `MULTISURFACE`: one with straight sides has no name.
    fn surface(&mut self, axes: Axes) -> Result<(), Error> {
        if self.peek()? == Some(b'(') {
            return self.polygon(axes, Self::corners);
        }
        self.word()?;
        match self.kind()? {
            None => Ok(()),
            Some((Kind::Polygon, axes)) => self.polygon(axes, Self::corners),
            Some((Kind::CurvePolygon, axes)) => self.polygon(axes, Self::curve),
            Some(_) => Err(self.fault("a MULTISURFACE has a part that is no polygon")),
        }
    }

    /// A curve: one with straight sides has no name.
    fn curve(&mut self, axes: Axes) -> Result<(), Error> {
        self.curve_or_part(axes, false)
    }

    /// A curve, or a part of one that has several, which has none of its own.
    fn curve_or_part(&mut self, axes: Axes, is_part: bool) -> Result<(), Error> {
        if self.peek()? == Some(b'(') {
            return self.corners(axes);
        }
        self.word()?;
        match self.kind()? {
            None => Ok(()),
            Some((kind @ (Kind::Line | Kind::Arcs), axes)) => self.curve_of(kind, axes),
            Some((Kind::Curve, axes)) if !is_part => self.curve_of(Kind::Curve, axes),
            Some(_) => Err(self.fault("a curve has a part that is none")),
        }
    }

    /// The positions or parts of a curve of this kind.
    fn curve_of(&mut self, kind: Kind, axes: Axes) -> Result<(), Error> {
        match kind {
            Kind::Arcs => self.arcs(axes),
            Kind::Curve => self.list(|reader| reader.curve_or_part(axes, true)),
            _ => self.corners(axes),
        }
    }

    /// A list of positions that are joined by straight sides.
    fn corners(&mut self, axes: Axes) -> Result<(), Error> {
        let mut is_first = true;
        self.list(|reader| {
            let place = reader.place(axes)?;
            if std::mem::take(&mut is_first) {
                return reader.begin(place);
            }
            reader.drawing.corner(place);
            Ok(())
        })
    }

    /// The first position of a line, or of a part of a curve, which begins where the part before it ends.
    fn begin(&mut self, place: Place) -> Result<(), Error> {
        self.drawing.begin_part(place).map_err(|fault| fault.at_line(self.line))
    }

    /// A list of positions, of which each second one is the middle of an arc.
    fn arcs(&mut self, axes: Axes) -> Result<(), Error> {
        let mut count = 0;
        let mut middle = None;
        self.list(|reader| {
            let place = reader.place(axes)?;
            count += 1;
            match (count, middle.take()) {
                (1, _) => return reader.begin(place),
                (_, None) => middle = Some(place),
                (_, Some(middle)) => {
                    reader.drawing.arc(middle, place).map_err(|fault| fault.at_line(reader.line))?;
                }
            }
            Ok(())
        })?;
        if count % 2 == 0 {
            let message =
                format!("a CIRCULARSTRING has {count} positions: each arc needs a middle and an end");
            return Err(self.fault(message).with_cure("write it as in CIRCULARSTRING (0 0, 1 1, 2 0)"));
        }
        Ok(())
    }

    /// One position.
    fn place(&mut self, axes: Axes) -> Result<Place, Error> {
        let mut numbers = [0.0; 4];
        let mut count = 0;
        while self
            .peek()?
            .is_some_and(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'+' | b'-' | b'.'))
        {
            self.word()?;
            if count == 4 {
                return Err(self.fault("a position has more than four numbers"));
            }
            numbers[count] =
                parse_f64(&self.word, "a coordinate").map_err(|fault| fault.at_line(self.line))?;
            count += 1;
        }
        if count == 0 {
            let next = self.peek()?;
            return Err(self.unexpected(next, "a number"));
        }
        let (least, most) = match axes {
            Axes::Counted => (2, 4),
            Axes::Z | Axes::M => (3, 3),
            Axes::Zm => (4, 4),
        };
        if count < least || count > most {
            let s = if count == 1 { "" } else { "s" };
            return Err(self.fault(format!("a position has {count} number{s}; here it needs {least}")));
        }
        if axes == Axes::M || count == 4 {
            self.drawing.note_surplus();
        }
        let z = (axes != Axes::M && count > 2).then_some(numbers[2]);
        Ok(Place { x: numbers[0], y: numbers[1], z })
    }
}

/// Writes one geometry a line: `LINESTRING` for lines, `POLYGON` for the rings of each polygon and for polygons of a mesh in the plane, `POINT`
/// for points and for vertices that nothing uses, a `POLYHEDRALSURFACE` for the polygons of a mesh in space, one for those that are connected or in one group; what follows each other with one number in `feature` is one geometry, `MULTI` or a
/// `GEOMETRYCOLLECTION`. Three coordinates are written if a vertex lies outside the plane z = 0.
/// Names and data are not kept, the number of the reference system is.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] if the model has 3-cells, no positions or more than three coordinates a vertex, or is
/// an abstract structure; [`ErrorKind::Io`] if the stream fails.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::{Format, wkt};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
/// let mut written = Vec::new();
/// wkt::write(&triangle, &mut written)?;
/// assert_eq!(written, b"POLYGON ((0 0, 1 0, 0 1, 0 0))\n");
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut output: impl Write) -> Result<(), Error> {
    let writer = Writer { model, dimension: written_dimension(model, "WKT")? };
    let mut text = Vec::new();
    let geometries = Geometries::of(model, writer.dimension);
    let start = start_of(model.reference_system());
    if geometries.shapes.is_empty() {
        text.extend_from_slice(start.as_bytes());
        text.extend_from_slice(b"GEOMETRYCOLLECTION EMPTY\n");
    }
    for feature in geometries.iter() {
        text.extend_from_slice(start.as_bytes());
        writer.push_geometry(feature, &mut text);
        text.push(b'\n');
        flush(&mut text, &mut output)?;
    }
    output.write_all(&text)?;
    output.flush()?;
    Ok(())
}

/// What stands in front of each geometry in a reference system.
fn start_of(system: Option<&ReferenceSystem>) -> String {
    system.and_then(ReferenceSystem::srid).map_or_else(String::new, |srid| format!("SRID={srid};"))
}

/// Writes a polygon without rings.
pub(super) fn write_empty_polygon(
    system: Option<&ReferenceSystem>,
    mut output: impl Write,
) -> Result<(), Error> {
    writeln!(output, "{}POLYGON EMPTY", start_of(system))?;
    output.flush()?;
    Ok(())
}

struct Writer<'a> {
    model: &'a Model,
    dimension: usize,
}

/// The name of a geometry of one shape.
fn name_of(shape: &Shape) -> &'static [u8] {
    match shape {
        Shape::Line(_) => b"LINESTRING",
        Shape::Rings(_) | Shape::Face(_) => b"POLYGON",
        Shape::Point(_) => b"POINT",
    }
}

impl Writer<'_> {
    /// One geometry of shapes: a single one, several of one kind, or a collection.
    fn push_geometry(&self, shapes: &[(Shape, Option<usize>)], text: &mut Vec<u8>) {
        let name = name_of(&shapes[0].0);
        let axes: &[u8] = if self.dimension == 3 { b" Z " } else { b" " };
        if !shapes.iter().all(|(shape, _)| name_of(shape) == name) {
            text.extend_from_slice(b"GEOMETRYCOLLECTION");
            text.extend_from_slice(axes);
            let kinds = shapes.chunk_by(|(a, _), (b, _)| name_of(a) == name_of(b));
            return push_list(text, LIST, kinds, |kind, text| self.push_geometry(kind, text));
        }
        if self.dimension == 3 && matches!(shapes[0].0, Shape::Face(_)) {
            text.extend_from_slice(b"POLYHEDRALSURFACE Z ");
            return push_list(text, LIST, shapes.iter(), |(shape, _), text| self.push_shape(shape, text));
        }
        if shapes.len() > 1 {
            text.extend_from_slice(b"MULTI");
        }
        text.extend_from_slice(name);
        text.extend_from_slice(axes);
        match shapes {
            [(shape, _)] => self.push_shape(shape, text),
            _ => push_list(text, LIST, shapes.iter(), |(shape, _), text| self.push_shape(shape, text)),
        }
    }

    fn push_shape(&self, shape: &Shape, text: &mut Vec<u8>) {
        match shape {
            Shape::Line(i) => self.push_path(text, self.model.lines.list(*i).iter().copied()),
            Shape::Rings(range) => push_list(text, LIST, range.clone(), |i, text| {
                self.push_path(text, self.model.lines.list(i).iter().copied());
            }),
            Shape::Face(i) => {
                text.push(b'(');
                self.push_path(text, closed(self.model.polygons.list(*i)));
                text.push(b')');
            }
            Shape::Point(vertex) => self.push_path(text, std::iter::once(vertex.to_u32())),
        }
    }

    fn push_path(&self, text: &mut Vec<u8>, path: impl Iterator<Item = u32>) {
        push_list(text, LIST, path, |vertex, text| {
            push_place(self.model, vertex, self.dimension, b' ', text);
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GroupKind;
    use coface_algebra::RaggedArray;

    #[test]
    fn surfaces_with_heights_are_meshes_in_space() {
        let cube = "POLYHEDRALSURFACE Z (((0 0 0,0 1 0,1 1 0,1 0 0,0 0 0)),((0 0 0,0 1 0,0 1 1,0 0 1,0 0 0)),((0 0 0,1 0 0,1 0 1,0 0 1,0 0 0)),\
            ((1 1 1,1 0 1,0 0 1,0 1 1,1 1 1)),((1 1 1,1 0 1,1 0 0,1 1 0,1 1 1)),((1 1 1,1 1 0,0 1 0,0 1 1,1 1 1)))";
        let one = read(cube.as_bytes()).unwrap();
        assert_eq!((one.vertex_count(), one.polygons().len(), one.lines().len()), (8, 6, 0));
        assert!(!one.is_map_with_heights() && one.remarks().is_empty(), "{:?}", one.remarks());
        // Two solids, each a group, beside a line that shares no vertex with them; one face has a hole.
        let text = format!(
            "{cube}\nLINESTRING Z (0 0 0,5 5 5)\nTIN(((0 0 0,1 0 0,0 1 1,0 0 0)),((0 0 0,0 1 1,1 0 0,0 0 0)))\n\
             POLYHEDRALSURFACE Z (((0 0 9,9 0 9,0 9 9,0 0 9),(1 1 9,1 2 9,2 1 9,1 1 9)))"
        );
        let model = read(text.as_bytes()).unwrap();
        model.check().unwrap();
        assert_eq!(
            (model.vertex_count(), model.polygons().len(), model.lines().len()),
            (8 + 2 + 3 + 6, 14, 1)
        );
        let groups: Vec<(&str, usize)> =
            model.groups().iter().map(|group| (group.name(), group.members().len())).collect();
        assert_eq!(groups, [("surface 1", 6), ("surface 2", 2), ("surface 3", 6)]);
        assert_eq!(model.remarks().len(), 1, "{:?}", model.remarks());
        // What is written comes back.
        let corners = |model: &Model| -> Vec<Vec<f64>> {
            let corner = |vertex: &u32| model.positions().as_flat()[3 * *vertex as usize..][..3].to_vec();
            model.polygons().iter().map(|polygon| polygon.iter().flat_map(corner).collect()).collect()
        };
        for model in [&one, &model] {
            let mut written = Vec::new();
            write(model, &mut written).unwrap();
            let mut bytes = Vec::new();
            wkb::write(model, &mut bytes, wkb::Encoding::Bytes).unwrap();
            for again in [read(&written[..]).unwrap(), wkb::read(&bytes[..]).unwrap()] {
                assert_eq!((again.vertex_count(), corners(&again)), (model.vertex_count(), corners(model)));
            }
        }
        // A tetrahedron whose faces are in groups of their own is one surface, and another one is a second surface.
        let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\n";
        let faces = "g a\nf 1 3 2\ng far\nf 5 7 6\ng b\nf 1 2 4\ng c\nf 2 3 4\nf 3 1 4\ng far\nf 5 6 8\nf 6 7 8\nf 7 5 8\n";
        let grouped = crate::obj::read(format!("{obj}{faces}").as_bytes()).unwrap();
        let mut written = Vec::new();
        write(&grouped, &mut written).unwrap();
        let again = read(&written[..]).unwrap();
        assert_eq!((again.vertex_count(), again.polygons().len(), again.groups().len()), (8, 8, 2));
        assert_eq!(again.groups()[0].members(), [0, 1, 2, 3]);
        // What has too few corners is left out.
        let thin = read(&b"TIN Z (((0 0 0,1 0 0,0 0 0)),((0 0 0,1 0 0,0 1 1,0 0 0)))"[..]).unwrap();
        assert_eq!((thin.polygons().len(), thin.remarks().len()), (1, 1), "{:?}", thin.remarks());
        // Without heights they lie in the plane.
        let flat = read(&b"TIN(((0 0,1 0,0 1,0 0)),((1 0,1 1,0 1,1 0)))"[..]).unwrap();
        assert_eq!((flat.polygons().len(), flat.lines().len()), (0, 2));
    }

    #[test]
    fn every_kind_is_read_in_every_spelling() {
        let text = "# a comment\nSRID=4326;POINT(1 2);Point Empty\nmultipoint ((3 4), 5 6, EMPTY)\n\
            MULTILINESTRING((0 0,1 1),EMPTY,(1 1,2 0))GEOMETRYCOLLECTION(LINEARRING(7 7,8 7,7 7),\
            GEOMETRYCOLLECTION EMPTY, MULTIPOLYGON (((0 0,4 0,0 4,0 0),(1 1,1 2,2 1,1 1)),((9 9,8 9,9 8,9 9))))";
        let model = read(text.as_bytes()).unwrap();
        model.check().unwrap();
        let lengths: Vec<usize> = model.lines().iter().map(<[u32]>::len).collect();
        assert_eq!((lengths, model.points().len()), (vec![2, 2, 3, 4, 4, 4], 3));
        let column = |name: &str| -> Vec<i64> {
            let data = model.data_named(name, GroupKind::Lines).unwrap();
            (0..data.len()).flat_map(|i| data.integer_row(i).unwrap()).collect()
        };
        assert_eq!(column("polygon"), [-1, -1, -1, 0, 0, 1]);
        assert_eq!(column("ring"), [-1, -1, -1, 0, 1, 0]);
        let mut written = Vec::new();
        write(&model, &mut written).unwrap();
        assert_eq!(read(&written[..]).unwrap(), model);
    }

    #[test]
    fn heights_are_kept_and_measures_passed_over() {
        for text in ["LINESTRING Z (0 0 5, 1 0 6)", "LINESTRINGZ(0 0 5,1 0 6)", "LINESTRING (0 0 5, 1 0 6)"] {
            let model = read(text.as_bytes()).unwrap();
            assert_eq!(model.positions().as_flat(), [0., 0., 5., 1., 0., 6.]);
            let mut written = Vec::new();
            write(&model, &mut written).unwrap();
            assert_eq!(written, b"LINESTRING Z (0 0 5, 1 0 6)\n");
        }
        let measured = read(&b"LINESTRING M (0 0 5, 1 0 6)"[..]).unwrap();
        assert_eq!(measured.positions().dimension(), 2);
        assert_eq!(measured.remarks().len(), 1);
        assert_eq!(read(&b"POINT ZM (1 2 3 4)"[..]).unwrap().positions().as_flat(), [1., 2., 3.]);
    }

    #[test]
    fn binary_in_digits_is_read() {
        // Of both byte orders: POINT (1 2), and the polygon and the line below with the flags of EWKB and the numbers of ISO.
        let point = "0101000000000000000000F03F0000000000000040\n00000000013ff00000000000004000000000000000";
        let model = read(point.as_bytes()).unwrap();
        assert_eq!(model.positions().as_flat(), [1.0, 2.0]);
        assert!(is_geometry(point.lines().next().unwrap().as_bytes()) && !is_geometry(b"0101"));
        let number = |x: f64| x.to_le_bytes().iter().map(|byte| format!("{byte:02x}")).collect::<String>();
        let ring = [0., 0., 5., 1., 0., 6., 0., 1., 7., 0., 0., 5.].map(number).concat();
        let with_srid = format!("01030000a0e61000000100000004000000{ring}");
        let of_iso = format!("01eb0300000100000004000000{ring}");
        let text = read(&b"POLYGON Z ((0 0 5, 1 0 6, 0 1 7, 0 0 5))"[..]).unwrap();
        assert_eq!(read(of_iso.as_bytes()).unwrap(), text);
        let system = ReferenceSystem::from_srid(4326);
        assert_eq!(read(with_srid.as_bytes()).unwrap(), text.with_reference_system(system));
        for (name, binary) in
            [("a.wkt", &with_srid), ("a.hex", &with_srid), ("a", &of_iso), ("a.obj", &of_iso)]
        {
            let found = crate::read_named(binary.as_bytes(), name, &crate::ReadOptions::new());
            assert_eq!(found.unwrap().lines().len(), 1, "{name}");
        }
        let two = format!("{with_srid}\nLINESTRING (0 0, 1 1)\n{of_iso}");
        assert_eq!(read(two.as_bytes()).unwrap().lines().len(), 3);
        let multi = "010600000002000000010300000001000000040000000000";
        for (binary, message) in [
            (&with_srid[..40], "ends too early"),
            (multi, "ends too early"),
            ("010d00000000000000", "kind 13"),
            (
                "01080000000200000000000000000000000000000000000000000000000000f03f000000000000f03f",
                "2 positions",
            ),
            ("010900000001000000010100000000000000000000000000000000000000", "part that is none"),
            ("016300000000000000", "99 is no kind"),
            ("0201000000000000000", "2 is no byte order"),
            ("0101000000zz0000000000000000000000000000", "hexadecimal"),
            ("0101000000000000000000f07f0000000000000040", "finite"),
        ] {
            let error = read(binary.as_bytes()).unwrap_err();
            assert!(error.to_string().contains(message) && error.cure().is_some(), "{binary}: {error}");
        }
        assert!(read(&b"0101000000000000000000F87F000000000000F87F"[..]).unwrap().points().is_empty());
    }

    #[test]
    fn arcs_become_chords() {
        let text = "CURVEPOLYGON (COMPOUNDCURVE ((0 0, 4 0), CIRCULARSTRING (4 0, 5 1, 4 2), (4 2, 0 2, 0 0)), \
                    CIRCULARSTRING (1 1, 2 1, 1 1))";
        let model = read(text.as_bytes()).unwrap();
        // 64 chords, 4 straight sides; 128 chords of the hole.
        assert_eq!(model.lines().iter().map(<[u32]>::len).collect::<Vec<_>>(), [68, 129]);
        let ring = model.data_named("ring", crate::GroupKind::Lines).unwrap();
        assert_eq!(ring.integer_row(1), Some(vec![1]));
        let [remark] = model.remarks() else { panic!("{:?}", model.remarks()) };
        assert_eq!((remark.code, remark.count), (crate::RemarkCode::CurvesFlattened, 2));
        let rough = read_flattened(text.as_bytes(), Some(0.3)).unwrap();
        assert_eq!(rough.lines().iter().map(<[u32]>::len).collect::<Vec<_>>(), [6, 5]);
        assert!(rough.remarks().is_empty());
        // Neighbors share the arc between them, whichever way it runs.
        let two = "MULTISURFACE (CURVEPOLYGON (COMPOUNDCURVE (CIRCULARSTRING (0 0, 1.5 1, 0 3), (0 3, -1 0, 0 0))), \
                   POLYGON ((9 9, 9 8, 8 8, 9 9)))\nMULTICURVE ((7 7, 6 6), CIRCULARSTRING Z (0 3 1, 1.5 1 2, 0 0 3))";
        let model = read(two.as_bytes()).unwrap();
        let places = |line: usize| {
            let own = model.lines().list(line).iter();
            own.map(|&vertex| {
                model.positions().point(coface_algebra::VertexId::from_u32(vertex))[..2].to_vec()
            })
            .collect::<Vec<_>>()
        };
        assert_eq!(model.lines().len(), 4);
        let mut back = places(3);
        back.reverse();
        assert_eq!(places(0)[..back.len()], back);
        assert!(read(&b"MULTICURVE EMPTY\nCIRCULARSTRING EMPTY"[..]).unwrap().lines().is_empty());
    }

    #[test]
    fn reference_systems_are_kept_and_must_agree() {
        let text = "SRID=25832;POLYGON ((0 0, 1 0, 0 1, 0 0))\nSRID=25832;POINT (5 5)\n";
        let model = read(text.as_bytes()).unwrap();
        assert_eq!(model.reference_system().unwrap().srid(), Some(25832));
        let mut written = Vec::new();
        write(&model, &mut written).unwrap();
        assert_eq!(String::from_utf8(written).unwrap(), text);
        // 0 is none, and what has none is taken to be in that of the others.
        assert!(read(&b"SRID=0;POINT (1 2)"[..]).unwrap().reference_system().is_none());
        let mixed = read(&b"POINT (1 2)\nSRID=3035;POINT (3 4)\nPOINT (5 6)"[..]).unwrap();
        assert_eq!(mixed.reference_system().unwrap().srid(), Some(3035));
        let [remark] = mixed.remarks() else { panic!("{:?}", mixed.remarks()) };
        assert_eq!((remark.code, remark.count), (crate::RemarkCode::ReferenceAssumed, 2));
        for (text, words) in [
            ("SRID=1;POINT (1 2)\nSRID=2;POINT (1 2)", "SRID 1, but this is in SRID 2"),
            ("POINT (1 2)\nSRID=-4;POINT (1 2)", "\"-4\" is no number of a reference system"),
            ("SRID=4.5;POINT (1 2)", "no number"),
        ] {
            let error = read(text.as_bytes()).unwrap_err();
            assert!(error.to_string().contains(words) && error.cure().is_some(), "{error}");
            assert_eq!(error.line(), Some(text.lines().count() as u64));
        }
    }

    #[test]
    fn faults_name_the_line() {
        for (text, line, message) in [
            ("LINESTRING (0 0, 1)", 1, "1 number; here it needs 2"),
            ("LINESTRING Z (0 0, 1 1)", 1, "needs 3"),
            ("POINT (1 2 3 4 5)", 1, "more than four"),
            ("POINT (1 inf)", 1, "finite"),
            ("POINT (1 2", 1, "ends"),
            ("POLYGON (0 0, 1 0)", 1, "\"(\" should be"),
            ("\nCIRCULARSTRING (0 0, 1 1)", 2, "2 positions"),
            ("COMPOUNDCURVE ((0 0, 1 1), CIRCULARSTRING (2 1, 3 3, 4 4))", 1, "ends at (1, 1)"),
            ("MULTISURFACE (POINT (1 2))", 1, "no polygon"),
            ("COMPOUNDCURVE (POINT (1 2))", 1, "part that is none"),
            ("CIRCULARSTRING (0 0, 1e200 1, 3 3e200)", 1, "beyond the range"),
            ("BLOB (0 0)", 1, "\"BLOB\" is not a geometry"),
            ("POINT (1 2) )", 1, "the name of a geometry"),
            ("# only this\n", 2, "no geometry"),
        ] {
            let error = read(text.as_bytes()).unwrap_err();
            assert_eq!(error.line(), Some(line), "{error}");
            assert!(error.to_string().contains(message) && error.cure().is_some(), "{error}");
        }
        let deep = "GEOMETRYCOLLECTION (".repeat(1000);
        assert_eq!(read(deep.as_bytes()).unwrap_err().kind(), ErrorKind::TooLarge);
        assert!(read(&[b'1'; 100_000][..]).unwrap_err().to_string().contains("too long"));
    }

    #[test]
    fn polygons_of_a_mesh_and_lonely_vertices_are_written() {
        let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 0\nf 1 2 3\nl 1 4\nv 7 8 0\n";
        let model = crate::obj::read(text.as_bytes()).unwrap();
        let mut written = Vec::new();
        write(&model, &mut written).unwrap();
        let expected = "LINESTRING (0 0, 5 5)\nPOLYGON ((0 0, 1 0, 0 1, 0 0))\nPOINT (7 8)\n";
        assert_eq!(String::from_utf8(written).unwrap(), expected);
        let back = read(expected.as_bytes()).unwrap();
        assert_eq!(*back.lines(), RaggedArray::from_lists([vec![0, 1], vec![2, 3, 4, 2]]));
    }
}
