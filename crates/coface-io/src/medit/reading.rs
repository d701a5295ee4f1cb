//! Reading, text and binary.

use super::sections::{self, Elements, Marks, Section};
use crate::assembly::Assembly;
use crate::oddities::Oddity;
use crate::scanner::{Scanner, quoted};
use crate::scratch_mesh::ScratchMesh;
use crate::values::{Encoding, NumberType, Values};
use crate::{GroupKind, Model, Place, ReadOptions, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use std::io::Read;

/// The groups of marked vertices and elements have numbers from here on, far from those of references.
const FIRST_MARK: i64 = i64::MAX / 2;

/// Reads a MEDIT mesh, text or binary.
///
/// # Errors
/// [`ErrorKind::Parse`] and [`ErrorKind::InvalidInput`] with the line (the byte of a binary file): a word or number out
/// of place, an index outside the vertices, a file that was cut short;
/// [`ErrorKind::UnsupportedFormat`] for a dimension above 3.
///
/// # Complexity
/// Linear; memory is the model.
///
/// # References
/// P. J. Frey, *MEDIT: an interactive mesh visualization software* (2001), INRIA technical report 0253.
///
/// # Examples
/// ```
/// use coface_io::medit;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = b"MeshVersionFormatted 2 Dimension 2
/// Vertices 3
/// 0 0 0  1 0 0  0 1 7
/// Triangles 1
/// 1 2 3 5
/// End";
/// let model = medit::read(&text[..])?;
/// assert_eq!(model.polygons().list(0), [0, 1, 2]);
/// assert_eq!((model.groups()[0].name(), model.groups()[0].members()), ("7", &[2][..]));
/// assert_eq!((model.groups()[1].name(), model.groups()[1].members()), ("5", &[0][..]));
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_with(input, &ReadOptions::default())
}

pub(crate) fn read_with(input: impl Read, options: &ReadOptions) -> Result<Model, Error> {
    let (reader, fault) = read_up_to_fault(input, None)?;
    match fault {
        Some(fault) if !options.partial || reader.assembly.is_none() => Err(fault),
        Some(fault) => {
            let mut model = reader.finish()?;
            model.remarks.insert(0, crate::remark::partial(&fault));
            Ok(model)
        }
        None => reader.finish(),
    }
}

/// Reads a mesh into files.
pub(crate) fn read_into(input: impl Read, scratch: ScratchMesh) -> Result<ScratchMesh, Error> {
    let (reader, fault) = read_up_to_fault(input, Some(scratch))?;
    if let Some(fault) = fault {
        return Err(fault);
    }
    let scratch = reader.assembly.and_then(|(assembly, _)| assembly.into_scratch());
    scratch.ok_or_else(|| {
        Error::parse("the file ends without a dimension").with_cure("it was cut short: write it again")
    })
}

/// What was read, and the fault that reading ended at.
fn read_up_to_fault(
    input: impl Read,
    scratch: Option<ScratchMesh>,
) -> Result<(Reader<impl Read>, Option<Error>), Error> {
    let mut first = [0; 1];
    let mut input = input;
    let start = loop {
        match input.read(&mut first) {
            Ok(count) => break first[..count].to_vec(),
            Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error.into()),
        }
    };
    let encoding = match start[..] {
        [0] => Encoding::BigEndian,
        [1] => Encoding::LittleEndian,
        _ => Encoding::Ascii,
    };
    let scanner = Scanner::new(std::io::Cursor::new(start).chain(input)).with_comments(b'#');
    let mut reader = Reader {
        values: Values::new(scanner, encoding),
        integer: NumberType::Int32,
        float: NumberType::Float64,
        assembly: None,
        scratch,
        runs: Vec::new(),
        marked: Vec::new(),
        unknown: Vec::new(),
        cut_keyword: None,
        has_end: true,
    };
    let read = if encoding == Encoding::Ascii { reader.read_text() } else { reader.read_binary() };
    Ok((reader, read.err()))
}

struct Reader<R> {
    values: Values<R>,
    /// The types of indices and coordinates in a binary file.
    integer: NumberType,
    float: NumberType,
    /// The mesh so far, and its dimension, once the file has stated it.
    assembly: Option<(Assembly, usize)>,
    /// Where the mesh goes instead of being kept, until the file has stated its dimension.
    scratch: Option<ScratchMesh>,
    /// The sections of elements so far.
    runs: Vec<Run>,
    /// Marked vertices and elements, by number from 0.
    marked: Vec<(Marks, Vec<u64>)>,
    /// The keywords that are not known, quoted, with their lines; of a binary file the codes.
    unknown: Vec<(String, Option<u64>)>,
    /// What the last word would be if it were cut off within a keyword.
    cut_keyword: Option<&'static str>,
    /// Whether the file says where it ends.
    has_end: bool,
}

/// A section of elements.
struct Run {
    elements: Elements,
    /// The position of its first among the elements of their kind.
    first: usize,
    /// How many elements the file lists.
    count: usize,
    /// The places in the section of those that were left out.
    left_out: Vec<usize>,
}

impl<R: Read> Reader<R> {
    fn read_text(&mut self) -> Result<(), Error> {
        let keyword = self.values.scanner.expect_token("MeshVersionFormatted")?;
        if keyword != b"MeshVersionFormatted" && keyword != b"MeshVersionUnformatted" {
            let message = format!("{} stands where MeshVersionFormatted should", quoted(keyword));
            return Err(self.values.error(message).with_cure("check that this is a MEDIT mesh"));
        }
        self.values.scanner.expect_u64("the version")?;
        let mut is_known = true;
        loop {
            let Some(keyword) = self.values.scanner.next_token()? else {
                return self.end_of_text(is_known);
            };
            if keyword == b"Dimension" {
                let dimension = self.values.scanner.expect_i64("the dimension")?;
                self.set_dimension(dimension)?;
                is_known = true;
                continue;
            }
            match Section::from_keyword(keyword) {
                Section::End => return Ok(()),
                Section::Unknown if keyword[0].is_ascii_alphabetic() => {
                    self.cut_keyword = sections::completed(keyword);
                    let keyword = quoted(keyword);
                    self.unknown.push((keyword, Some(self.values.scanner.line_number())));
                    is_known = false;
                }
                // The numbers of a section that is not known are passed over here, word by word.
                Section::Unknown if !is_known && is_number(keyword) => self.cut_keyword = None,
                Section::Unknown => {
                    let message = format!("{} stands where a keyword should", quoted(keyword));
                    return Err(self
                        .values
                        .error(message)
                        .with_cure("check the count of the section before"));
                }
                section => {
                    is_known = true;
                    self.read_section(section)?;
                }
            }
        }
    }

    /// The file ends without `End`; a last word that begins a keyword was cut off with what followed it.
    fn end_of_text(&mut self, is_known: bool) -> Result<(), Error> {
        if let Some(whole) = self.cut_keyword.filter(|_| !is_known) {
            let message = format!("the file ends within a keyword, which may be {whole}");
            return Err(self.values.error(message).with_cure("it was cut short: write it again"));
        }
        self.has_end = false;
        Ok(())
    }

    /// Each section of a binary file begins with its code and the place of the next one.
    fn read_binary(&mut self) -> Result<(), Error> {
        self.values.integer(NumberType::Int32, "the first number")?;
        let version = self.values.integer(NumberType::Int32, "the version")?;
        let (integer, float, place) = match version {
            1 => (NumberType::Int32, NumberType::Float32, NumberType::Int32),
            2 => (NumberType::Int32, NumberType::Float64, NumberType::Int32),
            3 => (NumberType::Int32, NumberType::Float64, NumberType::Int64),
            4 => (NumberType::Int64, NumberType::Float64, NumberType::Int64),
            _ => return Err(self.values.error(format!("the version is {version}; 1 to 4 are known"))),
        };
        (self.integer, self.float) = (integer, float);
        loop {
            let code = self.values.integer(NumberType::Int32, "a section")?;
            let section = Section::from_code(code);
            if section == Section::End {
                return Ok(());
            }
            let next = self.values.count(place, "the place of the next section")?;
            if code == 3 {
                let dimension = self.values.integer(NumberType::Int32, "the dimension")?;
                self.set_dimension(dimension)?;
            } else if section == Section::Unknown && next == 0 {
                return Ok(());
            } else if section == Section::Unknown {
                self.unknown.push((format!("code {code}"), None));
            } else {
                self.read_section(section)?;
            }
            match next.checked_sub(self.values.scanner.byte_offset()) {
                Some(ahead) => self.values.skip_bytes(ahead, "a section")?,
                None if next == 0 => {}
                None => {
                    let message =
                        format!("the section with the code {code} runs past the next one at byte {next}");
                    return Err(self.values.error(message).with_cure("the file is damaged: write it again"));
                }
            }
        }
    }

    fn set_dimension(&mut self, dimension: i64) -> Result<(), Error> {
        if let (1..=3, None) = (dimension, &self.assembly) {
            self.assembly =
                Some((Assembly::streaming(dimension as usize, self.scratch.take()), dimension as usize));
            return Ok(());
        }
        let message = match self.assembly {
            Some(_) => "the dimension is given twice".to_owned(),
            None => format!("the dimension is {dimension}; MEDIT has 1 to 3"),
        };
        Err(self.values.located(
            Error::new(ErrorKind::UnsupportedFormat, message).with_cure("give Dimension 1, 2 or 3, once"),
        ))
    }

    fn read_section(&mut self, section: Section) -> Result<(), Error> {
        let count = self.values.count(self.integer, "the count of a section")?;
        let (integer, float, values) = (self.integer, self.float, &mut self.values);
        if let Section::Marks(marks) = section {
            let mut numbers = Vec::new();
            for _ in 0..count {
                let number = values.integer(integer, "the number of a marked vertex or element")?;
                let Some(number) = u64::try_from(number).ok().and_then(|number| number.checked_sub(1)) else {
                    return Err(values.error(format!("{} lists {number}; numbers start at 1", marks.name)));
                };
                numbers.push(number);
            }
            self.marked.push((marks, numbers));
            return Ok(());
        }
        let Some((assembly, dimension)) = &mut self.assembly else {
            let message = format!("{} stand before the dimension", section.keyword());
            return Err(values.error(message).with_cure("give the dimension first: Dimension 3"));
        };
        match section {
            Section::Vertices => {
                let mut point = [0.0; 3];
                for _ in 0..count {
                    for coordinate in &mut point[..*dimension] {
                        *coordinate = values.coordinate(float, "a coordinate")?;
                    }
                    let (reference, is_fraction) = values.label(integer, "the reference of a vertex")?;
                    if is_fraction {
                        let line = values.scanner.line_number();
                        assembly.oddities.note(Oddity::Fraction, || Place::line(line));
                    }
                    let vertex = assembly.vertex_count() as u32;
                    let line = values.line();
                    let added = assembly.add_vertex_on_line(&point[..*dimension], line);
                    added.map_err(|fault| values.located(fault))?;
                    if reference != 0 {
                        assembly.add_to_group(GroupKind::Vertices, reference, vertex);
                    }
                }
            }
            Section::Elements(elements) => {
                let Elements { kind, corner_count, vertex_count } = elements;
                if assembly.vertex_count() == 0 && count > 0 {
                    let message = format!("{} stand before the vertices", section.keyword());
                    return Err(values.error(message).with_cure("put the section of vertices first"));
                }
                let mut vertices = [0; 27];
                let mut first = None;
                let mut left_out = Vec::new();
                for place in 0..count as usize {
                    for vertex in &mut vertices[..vertex_count] {
                        let number = values.integer(integer, "a vertex")?;
                        *vertex = match u32::try_from(number) {
                            Ok(number @ 1..) if number as usize <= assembly.vertex_count() => number - 1,
                            _ => {
                                let message = format!(
                                    "{} name vertex {number}, but there are {} vertices, numbered from 1",
                                    section.keyword(),
                                    assembly.vertex_count()
                                );
                                return Err(values.located(Error::invalid(message).with_cure(
                                    "the file is damaged, or was written wrongly: write it again",
                                )));
                            }
                        };
                    }
                    let position = assembly
                        .add(kind, corner_count, &vertices[..vertex_count], |vertex| u64::from(vertex) + 1)
                        .map_err(|fault| values.located(fault))?;
                    let (reference, is_fraction) = values.label(integer, "the reference of an element")?;
                    if is_fraction {
                        let line = values.scanner.line_number();
                        assembly.oddities.note(Oddity::Fraction, || Place::line(line));
                    }
                    let Some(position) = position else {
                        left_out.push(place);
                        continue;
                    };
                    first.get_or_insert(position as usize);
                    if reference != 0 {
                        assembly.add_to_group(kind.group_kind(), reference, position);
                    }
                }
                let (first, count) = (first.unwrap_or(0), count as usize);
                self.runs.push(Run { elements, first, count, left_out });
            }
            Section::Marks(_) | Section::End | Section::Unknown => {}
        }
        Ok(())
    }

    fn finish(self) -> Result<Model, Error> {
        let Some((mut assembly, _)) = self.assembly else {
            return Err(Error::parse("the file ends without a dimension")
                .at_line(self.values.scanner.line_number())
                .with_cure("it was cut short: write it again"));
        };
        for (i, (marks, numbers)) in self.marked.into_iter().enumerate() {
            let runs = self.runs.iter().filter(|Run { elements, .. }| {
                elements.kind.group_kind() == marks.kind && elements.corner_count == marks.corner_count
            });
            let count = match marks.kind {
                GroupKind::Vertices => assembly.vertex_count(),
                _ => runs.clone().map(|run| run.count).sum(),
            };
            let group = FIRST_MARK + i as i64;
            assembly.name_group(marks.kind, group, marks.name.to_owned());
            for number in numbers {
                let Some(mut left) = usize::try_from(number).ok().filter(|&number| number < count) else {
                    return Err(Error::invalid(format!(
                        "{} lists number {}, but there are {count}",
                        marks.name,
                        number + 1
                    ))
                    .with_cure("the file is damaged, or was written wrongly: write it again"));
                };
                if marks.kind == GroupKind::Vertices {
                    assembly.add_to_group(marks.kind, group, left as u32);
                    continue;
                }
                for run in runs.clone() {
                    if left >= run.count {
                        left -= run.count;
                        continue;
                    }
                    // What was left out before this one has no position.
                    if let Err(before) = run.left_out.binary_search(&left) {
                        assembly.add_to_group(marks.kind, group, (run.first + left - before) as u32);
                    }
                    break;
                }
            }
        }
        if !self.unknown.is_empty() {
            let named: Vec<&str> = self.unknown.iter().map(|(keyword, _)| &keyword[..]).take(4).collect();
            let dots = if self.unknown.len() > named.len() { ", .." } else { "" };
            let message = format!("sections that are not known were passed over: {}{dots}", named.join(", "));
            let places = self.unknown.iter().filter_map(|&(_, line)| line.map(Place::line));
            let remark = Remark::new(RemarkCode::UnknownSection, message);
            assembly.remarks.push(remark.at(self.unknown.len(), places));
        }
        if !self.has_end {
            assembly.remarks.push(Remark::new(RemarkCode::MissingEnd, "the file ends without End"));
        }
        assembly.finish()
    }
}

/// Whether a word of a section that is not known is a number.
fn is_number(word: &[u8]) -> bool {
    word[0].is_ascii_digit() || matches!(word[0], b'-' | b'+' | b'.')
}
