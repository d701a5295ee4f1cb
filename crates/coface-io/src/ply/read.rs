//! Reading PLY.

use super::Encoding;
use super::columns::Columns;
use super::header::{Element, Header, Property, Scalar, read_header};
use super::rows::Rows;
use crate::data::without_repeated_names;
use crate::lists::Elements;
use crate::oddities::{Oddities, Oddity};
use crate::scanner::{Scanner, parse_coordinate, parse_f64};
use crate::{CellData, GroupKind, Model, Place, ReadOptions, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use std::io::Read;

/// Reads a model in PLY, in any of its encodings.
///
/// Other numbers that are said of vertices, faces and edges become data of the same name: `red`, `nx`, `quality`. What
/// follow each other as `name_0`, `name_1`, .. are the components of one array. What is said of faces that are lines or
/// points is not kept, and lines and polygons that other elements make have zeros. Words behind a record on its line, of which the header
/// says nothing, are left out with a remark.
///
/// # Errors
/// [`ErrorKind::Parse`] or [`ErrorKind::InvalidInput`] with the line or the byte: a header that is none, a number that is
/// none, an index out of range, fewer data than the counts promise;
/// [`ErrorKind::TooLarge`] beyond 2^32 - 1 vertices; [`ErrorKind::Io`] if the stream fails.
///
/// # Complexity
/// Linear in the file; memory is the model and a block of the file, whatever the counts claim.
///
/// # References
/// G. Turk, *The PLY polygon file format* (1994).
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
///             element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
/// let triangle = coface_io::ply::read(text.as_bytes())?;
/// assert_eq!(triangle.polygons().list(0), [0, 1, 2]);
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_with(input, &ReadOptions::default())
}

pub(crate) fn read_with(input: impl Read, options: &ReadOptions) -> Result<Model, Error> {
    let mut scanner = Scanner::new(input);
    let Header { encoding, elements, unknown } = read_header(&mut scanner)?;
    let mut reader = Reader::new(scanner, encoding);
    let vertex_count =
        elements.iter().find(|element| element.name == "vertex").map_or(0, |vertex| vertex.count);
    if vertex_count > u64::from(u32::MAX) {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!("{vertex_count} vertices; the limit is 2^32 - 1"),
        )
        .with_cure("write the number of vertices that are there, or divide the model"));
    }
    let mut found = Found::default();
    let mut fault = (0..elements.len()).find_map(|i| {
        reader.rows.behind = elements[i + 1..].iter().map(Element::rows).fold(0, u64::saturating_add);
        reader.element(&elements[i], vertex_count, &mut found).err()
    });
    found.oddities.append(std::mem::take(&mut reader.rows.oddities));
    let mut model = Model { vertex_count: vertex_count as usize, ..Model::default() };
    if let Some(fault) = fault.take() {
        let vertices_read = found.coordinates.len().checked_div(found.dimension).unwrap_or(0);
        // Faces that came before the vertices may name those that are missing.
        if !options.partial || (vertices_read < model.vertex_count && !found.elements.is_empty()) {
            return Err(fault);
        }
        model.vertex_count = vertices_read;
        found.elements.polygons.abandon();
        model.remarks.push(crate::remark::partial(&fault));
    } else if reader.has_more()? {
        let message = "the file goes on behind the last element of its header; that is left out";
        model.remarks.push(Remark::new(RemarkCode::TrailingContent, message));
    }
    if let Some((line, text)) = unknown {
        let message = format!("{text} is no line of a PLY header, and is taken as a comment");
        model.remarks.push(Remark::new(RemarkCode::UnknownSection, message).at(1, [Place::line(line)]));
    }
    model.remarks.extend(found.oddities.into_remarks());
    (model.positions, model.partial_positions) = crate::model::placed(found.dimension, found.coordinates)?;
    model.polygons = found.elements.polygons.into_ragged()?;
    model.lines = found.elements.lines.into_ragged()?;
    model.points = found.elements.points;
    let mut data: Vec<CellData> = Vec::new();
    for (kind, first, mut columns) in found.columns {
        let count = model.count_of(kind);
        columns.truncate(count - first);
        columns.prepend_zeros(first);
        data.extend(columns.into_data(kind, count));
    }
    model.data = without_repeated_names(data, &mut model.remarks);
    debug_assert!(model.check().is_ok(), "the reader has checked what it read");
    Ok(model)
}

/// What was read so far.
#[derive(Default)]
struct Found {
    dimension: usize,
    coordinates: Vec<f64>,
    elements: Elements,
    /// Data on things of a kind, and how many of these came before.
    columns: Vec<(GroupKind, usize, Columns)>,
    oddities: Oddities,
}

impl Found {
    /// Columns for things of this kind, of which there are so many.
    fn begin(&mut self, kind: GroupKind, first: usize, columns: Columns) {
        self.columns.push((kind, first, columns));
    }

    /// The columns that were begun last.
    fn columns(&mut self) -> &mut Columns {
        &mut self.columns.last_mut().expect("columns were begun").2
    }
}

/// The data behind the header.
struct Reader<R> {
    scanner: Scanner<R>,
    encoding: Encoding,
    rows: Rows,
}

impl<R: Read> Reader<R> {
    fn new(scanner: Scanner<R>, encoding: Encoding) -> Self {
        Self { scanner, encoding, rows: Rows::default() }
    }

    /// Marks the start of a record.
    fn start_record(&mut self) -> Result<(), Error> {
        if self.encoding == Encoding::Ascii && self.rows.are_lines.is_none() {
            self.rows.start = self.scanner.next_token_line()?;
        }
        Ok(())
    }

    /// Marks the end of record `i` of an element.
    fn end_record(&mut self, element: &Element, i: u64) -> Result<(), Error> {
        if self.encoding == Encoding::Ascii {
            let left = (element.count - i - 1).saturating_add(self.rows.behind);
            self.rows.end_record(&mut self.scanner, left)?;
        }
        Ok(())
    }

    fn big(&self) -> bool {
        self.encoding == Encoding::BigEndian
    }

    /// Reads all records of an element.
    fn element(&mut self, element: &Element, vertices: u64, found: &mut Found) -> Result<(), Error> {
        match element.name.as_str() {
            "vertex" => self.vertices(element, found),
            "face" => match element.vertex_list() {
                Some(list) => self.faces(element, list, vertices, found),
                None if element.count == 0 => Ok(()),
                None => Err(self.missing("face", "a list vertex_indices")),
            },
            "tristrips" => match element.vertex_list() {
                Some(list) => self.strips(element, list, vertices, &mut found.elements),
                None => Err(self.missing("tristrips", "a list vertex_indices")),
            },
            "edge" => match (element.number("vertex1"), element.number("vertex2")) {
                (Some(from), Some(to)) => self.edges(element, [from, to], vertices, found),
                _ => self.skip_element(element),
            },
            _ => self.skip_element(element),
        }
    }

    /// The error at the place that was read last.
    fn here(&self, error: Error, byte: u64) -> Error {
        match self.encoding {
            Encoding::Ascii => error.at_line(self.scanner.line_number()),
            _ => error.at_byte(byte),
        }
    }

    fn missing(&self, element: &str, what: &str) -> Error {
        Error::parse(format!("the element {element} has no {}", what.trim_start_matches("a ")))
            .with_cure(format!("declare {what} in the header"))
    }

    /// The error of a record, with its number and how many the header promises.
    fn in_record(error: &Error, element: &Element, i: u64) -> Error {
        let left = element.count - i;
        let missing = match error.message().starts_with("the file ends") {
            true if left > 1 => format!("; {left} of them are missing"),
            _ => String::new(),
        };
        let message = format!(
            "{} ({} {i} of the {} that the header promises{missing})",
            error.message(),
            element.name,
            element.count
        );
        let mut with_record = Error::new(error.kind(), message);
        if let Some(line) = error.line() {
            with_record = with_record.at_line(line);
        }
        if let Some(byte) = error.byte() {
            with_record = with_record.at_byte(byte);
        }
        match error.cure() {
            Some(cure) => with_record.with_cure(cure),
            None => with_record
                .with_cure("correct the count or complete the file, or read what is there with --partial"),
        }
    }

    /// The next number of this type; it need not be finite in binary.
    fn scalar(&mut self, kind: Scalar, what: &str) -> Result<f64, Error> {
        if self.encoding == Encoding::Ascii {
            let value = parse_f64(self.scanner.expect_token(what)?, what);
            return value.map_err(|error| error.at_line(self.scanner.line_number()));
        }
        let mut bytes = [0; 8];
        self.scanner.read_exact(&mut bytes[..kind.size()], what)?;
        Ok(kind.decode(&bytes, self.big()))
    }

    /// The next number as a count.
    fn count(&mut self, kind: Scalar) -> Result<u64, Error> {
        let byte = self.scanner.byte_offset();
        let value = self.scalar(kind, "the length of a list")?;
        if value < 0.0 || value.fract() != 0.0 || value > u32::MAX.into() {
            return Err(self.here(Error::parse(format!("the length of a list is {value}")), byte));
        }
        Ok(value as u64)
    }

    /// Reads one property that has no meaning here: into its column, if it is one.
    fn datum(&mut self, element: &Element, i: usize, columns: &mut Columns) -> Result<(), Error> {
        let property = &element.properties[i];
        let Some(numbers) = columns.of_property(i) else { return self.skip(property) };
        if self.encoding == Encoding::Ascii {
            let pushed = numbers.push_word(self.scanner.expect_token("a property")?, "a property");
            return pushed.map_err(|error| error.at_line(self.scanner.line_number()));
        }
        let mut bytes = [0; 8];
        self.scanner.read_exact(&mut bytes[..property.value.size()], "a property")?;
        numbers.push_real(property.value.decode(&bytes, self.big()));
        Ok(())
    }

    fn skip_value(&mut self, kind: Scalar) -> Result<(), Error> {
        match self.encoding {
            Encoding::Ascii => self.scanner.expect_token("a property").map(|_| ()),
            _ => self.scanner.read_exact(&mut [0; 8][..kind.size()], "a property"),
        }
    }

    fn skip(&mut self, property: &Property) -> Result<(), Error> {
        let count = match property.count {
            Some(kind) => self.count(kind)?,
            None => 1,
        };
        (0..count).try_for_each(|_| self.skip_value(property.value))
    }

    fn skip_element(&mut self, element: &Element) -> Result<(), Error> {
        if element.properties.is_empty() {
            return Ok(());
        }
        for i in 0..element.count {
            self.start_record()?;
            for property in &element.properties {
                self.skip(property).map_err(|error| Self::in_record(&error, element, i))?;
            }
            self.end_record(element, i)?;
        }
        Ok(())
    }

    fn has_more(&mut self) -> Result<bool, Error> {
        Ok(match self.encoding {
            Encoding::Ascii => self.scanner.next_token()?.is_some(),
            _ => !self.scanner.available(1)?.is_empty(),
        })
    }

    fn vertices(&mut self, element: &Element, found: &mut Found) -> Result<(), Error> {
        let axes: Vec<Option<usize>> = ["x", "y", "z"].iter().map(|axis| element.number(axis)).collect();
        let axes: Vec<usize> = match axes.as_slice() {
            [Some(x), Some(y), Some(z)] => vec![*x, *y, *z],
            [Some(x), Some(y), None] => vec![*x, *y],
            [Some(x), None, None] => vec![*x],
            _ if element.count == 0 => {
                found.begin(GroupKind::Vertices, 0, Columns::new(element, &[]));
                return Ok(());
            }
            _ => return Err(self.missing("vertex", "properties x, y and z")),
        };
        found.dimension = axes.len();
        found.begin(GroupKind::Vertices, 0, Columns::new(element, &axes));
        if let Some(stride) = element.stride().filter(|_| self.encoding != Encoding::Ascii) {
            return self.packed_vertices(element, &axes, stride, found);
        }
        let mut point = vec![0.0; axes.len()];
        for i in 0..element.count {
            self.start_record()?;
            self.vertex(element, &axes, &mut point, found.columns())
                .map_err(|error| Self::in_record(&error, element, i))?;
            let line = (self.encoding == Encoding::Ascii).then(|| self.scanner.line_number());
            self.end_record(element, i)?;
            found.oddities.note_unplaced(&point, i, line);
            found.coordinates.extend_from_slice(&point);
        }
        Ok(())
    }

    /// One vertex, property by property.
    fn vertex(
        &mut self,
        element: &Element,
        axes: &[usize],
        point: &mut [f64],
        columns: &mut Columns,
    ) -> Result<(), Error> {
        for (i, property) in element.properties.iter().enumerate() {
            match axes.iter().position(|&axis| axis == i) {
                Some(axis) if self.encoding == Encoding::Ascii => {
                    let value = parse_coordinate(self.scanner.expect_token("a coordinate")?, "a coordinate");
                    point[axis] = value.map_err(|error| error.at_line(self.scanner.line_number()))?;
                }
                Some(axis) => point[axis] = self.scalar(property.value, "a coordinate")?,
                None => self.datum(element, i, columns)?,
            }
        }
        Ok(())
    }

    /// Binary vertices of one length, block by block.
    fn packed_vertices(
        &mut self,
        element: &Element,
        axes: &[usize],
        stride: usize,
        found: &mut Found,
    ) -> Result<(), Error> {
        let offset = |axis: usize| element.properties[..axis].iter().map(|p| p.value.size()).sum::<usize>();
        let fields: Vec<(usize, Scalar)> =
            axes.iter().map(|&axis| (offset(axis), element.properties[axis].value)).collect();
        let big = self.big();
        let mut read = 0;
        while read < element.count {
            let base = self.scanner.byte_offset();
            let bytes = self.scanner.available(stride)?;
            let records =
                (bytes.len() / stride).min(usize::try_from(element.count - read).unwrap_or(usize::MAX));
            if records == 0 {
                let error = Error::parse("the file ends inside a vertex").at_byte(base + bytes.len() as u64);
                return Err(Self::in_record(&error, element, read));
            }
            let coordinates = &mut found.coordinates;
            let bytes = &bytes[..records * stride];
            let first = coordinates.len();
            match *fields.as_slice() {
                // Nothing but x, y and z of one type, the usual case, is one flat list.
                [(0, Scalar::F32), (4, Scalar::F32), (8, Scalar::F32)] if stride == 12 => {
                    let flat = bytes.chunks_exact(4).map(|x| [x[0], x[1], x[2], x[3]]);
                    if big {
                        coordinates.extend(flat.map(|x| f64::from(f32::from_be_bytes(x))));
                    } else {
                        coordinates.extend(flat.map(|x| f64::from(f32::from_le_bytes(x))));
                    }
                }
                _ => {
                    for record in bytes.chunks_exact(stride) {
                        coordinates.extend(fields.iter().map(|&(at, kind)| kind.decode(&record[at..], big)));
                    }
                }
            }
            if !coordinates[first..].iter().all(|value| value.is_finite()) {
                for (point, vertex) in coordinates[first..].chunks_exact(fields.len()).zip(read..) {
                    found.oddities.note_unplaced(point, vertex, None);
                }
            }
            for (i, property) in element.properties.iter().enumerate() {
                let Some(numbers) = found.columns().of_property(i) else { continue };
                let at = offset(i);
                let values =
                    bytes.chunks_exact(stride).map(|record| property.value.decode(&record[at..], big));
                values.for_each(|value| numbers.push_real(value));
            }
            self.scanner.consume(records * stride);
            read += records as u64;
        }
        Ok(())
    }

    fn faces(
        &mut self,
        element: &Element,
        list: usize,
        vertices: u64,
        found: &mut Found,
    ) -> Result<(), Error> {
        let first = found.elements.polygons.len();
        found.begin(GroupKind::Polygons, first, Columns::new(element, &[list]));
        let mut read = 0;
        while read < element.count {
            if let [Property { count: Some(Scalar::U8), value: Scalar::I32 | Scalar::U32, .. }] =
                element.properties.as_slice()
            {
                read += self.packed_triangles(element.count - read, vertices, &mut found.elements)?;
                if read == element.count {
                    break;
                }
            }
            self.start_record()?;
            let Found { elements, columns, oddities, .. } = &mut *found;
            let columns = &mut columns.last_mut().expect("columns were begun").2;
            self.list_record(element, list, Some(&mut *columns), |vertex| {
                elements.polygons.items_mut().push(checked_vertex(vertex, vertices)?);
                Ok(())
            })
            .map_err(|error| Self::in_record(&error, element, read))?;
            let place = match self.encoding {
                Encoding::Ascii => Place::line(self.scanner.line_number()),
                _ => Place::default(),
            };
            elements.finish_face(oddities, place);
            // What is said of a face that is a line, a point or nothing is not kept.
            columns.truncate(elements.polygons.len() - first);
            self.end_record(element, read)?;
            read += 1;
        }
        Ok(())
    }

    /// Sound binary triangles as far as they go in the bytes at hand, each a byte 3 and three indices of four bytes; the
    /// number of them, at most `limit`.
    fn packed_triangles(&mut self, limit: u64, vertices: u64, found: &mut Elements) -> Result<u64, Error> {
        const LENGTH: usize = 13;
        let big = self.big();
        if self.encoding == Encoding::Ascii {
            return Ok(0);
        }
        let bytes = self.scanner.available(LENGTH)?;
        let records = (bytes.len() / LENGTH).min(usize::try_from(limit).unwrap_or(usize::MAX));
        let sound = bytes[..records * LENGTH].chunks_exact(LENGTH).map_while(|record| {
            let index = |at: usize| {
                let bytes = [record[at], record[at + 1], record[at + 2], record[at + 3]];
                if big { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) }
            };
            let [a, b, c] = [index(1), index(5), index(9)];
            let sound = record[0] == 3 && u64::from(a.max(b).max(c)) < vertices && a != b && b != c && c != a;
            sound.then_some([a, b, c])
        });
        let read = found.polygons.push_triangles(records, sound);
        self.scanner.consume(read * LENGTH);
        Ok(read as u64)
    }

    /// Reads one record, whose property `list` is a list, and takes the items of that.
    fn list_record(
        &mut self,
        element: &Element,
        list: usize,
        mut columns: Option<&mut Columns>,
        mut take: impl FnMut(f64) -> Result<(), Error>,
    ) -> Result<(), Error> {
        for (i, property) in element.properties.iter().enumerate() {
            match property.count {
                Some(kind) if i == list => {
                    for _ in 0..self.count(kind)? {
                        let byte = self.scanner.byte_offset();
                        let item = self.scalar(property.value, "a vertex index")?;
                        take(item).map_err(|error| self.here(error, byte))?;
                    }
                }
                _ => match &mut columns {
                    Some(columns) => self.datum(element, i, columns)?,
                    None => self.skip(property)?,
                },
            }
        }
        Ok(())
    }

    /// Strips of triangles: each vertex from the third on makes a triangle with the two before it, every other one
    /// turned; -1 ends a strip. Triangles that repeat a vertex only join strips and are no faces.
    fn strips(
        &mut self,
        element: &Element,
        list: usize,
        vertices: u64,
        found: &mut Elements,
    ) -> Result<(), Error> {
        for i in 0..element.count {
            let mut last: [Option<u32>; 2] = [None; 2];
            let mut turned = false;
            self.start_record()?;
            self.list_record(element, list, None, |vertex| {
                if vertex == -1.0 {
                    (last, turned) = ([None; 2], false);
                    return Ok(());
                }
                let c = checked_vertex(vertex, vertices)?;
                if let [Some(a), Some(b)] = last {
                    if a != b && b != c && c != a {
                        found.polygons.push(&if turned { [b, a, c] } else { [a, b, c] });
                    }
                    turned = !turned;
                }
                last = [last[1], Some(c)];
                Ok(())
            })
            .map_err(|error| Self::in_record(&error, element, i))?;
            self.end_record(element, i)?;
        }
        Ok(())
    }

    fn edges(
        &mut self,
        element: &Element,
        ends: [usize; 2],
        vertices: u64,
        found: &mut Found,
    ) -> Result<(), Error> {
        let first = found.elements.lines.len();
        found.begin(GroupKind::Lines, first, Columns::new(element, &ends));
        for i in 0..element.count {
            self.start_record()?;
            self.edge(element, ends, vertices, found).map_err(|error| Self::in_record(&error, element, i))?;
            self.end_record(element, i)?;
            let count = found.elements.lines.len() - first;
            found.columns().truncate(count);
        }
        Ok(())
    }

    fn edge(
        &mut self,
        element: &Element,
        ends: [usize; 2],
        vertices: u64,
        found: &mut Found,
    ) -> Result<(), Error> {
        let mut edge = [0; 2];
        for (i, property) in element.properties.iter().enumerate() {
            match ends.iter().position(|&end| end == i) {
                Some(end) => {
                    let byte = self.scanner.byte_offset();
                    let vertex = self.scalar(property.value, "an end of an edge")?;
                    edge[end] = checked_vertex(vertex, vertices).map_err(|error| self.here(error, byte))?;
                }
                None => self.datum(element, i, found.columns())?,
            }
        }
        if edge[0] == edge[1] {
            found.oddities.note(Oddity::Collapsed, || Place::cell(&edge));
        } else {
            found.elements.lines.push(&edge);
        }
        Ok(())
    }
}

/// The index if there is such a vertex.
fn checked_vertex(vertex: f64, count: u64) -> Result<u32, Error> {
    if vertex >= 0.0 && vertex < count as f64 && vertex.fract() == 0.0 {
        return Ok(vertex as u32);
    }
    Err(Error::invalid(format!("vertex index {vertex}, but there are {count} vertices, numbered from 0"))
        .with_cure("correct the index"))
}
