//! Arrays of a VTK XML file: text, base64 or bytes, compressed or not.

use crate::features::inflated;
use crate::numbers::Numbers;
use crate::scanner::Scanner;
use crate::values::{Encoding, NumberType, Values};
use coface_algebra::{Error, ErrorKind};
use roxmltree::Node;
use std::borrow::Cow;
use std::io::Read;

/// How the arrays of a file are stored.
pub(super) struct Storage<'a> {
    /// The order of bytes in numbers.
    pub(super) encoding: Encoding,
    /// The type of the lengths that stand before bytes: 32 or 64 bits.
    pub(super) length: NumberType,
    pub(super) is_compressed: bool,
    /// What stands behind the underscore of the element `AppendedData`.
    pub(super) appended: Appended<'a>,
}

/// The bytes at the end of the file that arrays are parts of.
#[derive(Clone, Copy)]
pub(super) enum Appended<'a> {
    None,
    Raw(&'a [u8]),
    Base64(&'a [u8]),
}

/// An array: its values, and what they are called.
pub(super) struct Array {
    pub(super) name: String,
    pub(super) components: usize,
    pub(super) numbers: Numbers,
}

/// The type of the numbers of an array; `None` for strings and bits.
pub(super) fn number_type(node: Node<'_, '_>) -> Result<Option<NumberType>, Error> {
    Ok(Some(match node.attribute("type").unwrap_or_default() {
        "Int8" => NumberType::Int8,
        "UInt8" => NumberType::UInt8,
        "Int16" => NumberType::Int16,
        "UInt16" => NumberType::UInt16,
        "Int32" => NumberType::Int32,
        "UInt32" => NumberType::UInt32,
        "Int64" => NumberType::Int64,
        "UInt64" => NumberType::UInt64,
        "Float32" => NumberType::Float32,
        "Float64" => NumberType::Float64,
        "String" | "Bit" => return Ok(None),
        other => {
            let message = format!("\"{}\" is no type of numbers in VTK XML", other.escape_debug());
            return Err(located(Error::parse(message).with_cure("use Float64, Int64 or their like"), node));
        }
    }))
}

/// A number in an attribute, or what it is when it is missing.
pub(super) fn natural(node: Node<'_, '_>, attribute: &str, missing: Option<u64>) -> Result<u64, Error> {
    let fault = |message: String| located(Error::parse(message).with_cure("write the file again"), node);
    match (node.attribute(attribute), missing) {
        (Some(text), _) => text
            .trim()
            .parse()
            .map_err(|_| fault(format!("{attribute} is \"{}\", not a count", text.escape_debug()))),
        (None, Some(missing)) => Ok(missing),
        (None, None) => Err(fault(format!("{} has no attribute {attribute}", node.tag_name().name()))),
    }
}

/// A fault at the line of an element.
pub(super) fn located(fault: Error, node: Node<'_, '_>) -> Error {
    let line = node.document().text_pos_at(node.range().start).row;
    fault.at_line(line.into())
}

impl Storage<'_> {
    /// The numbers of an array on so many rows, of so many components unless the array says how many. `None` if they are no numbers.
    pub(super) fn array(&self, node: Node<'_, '_>, rows: u64, usual: u64) -> Result<Option<Array>, Error> {
        let name = node.attribute("Name").filter(|name| !name.is_empty()).unwrap_or("unnamed").to_owned();
        let components = natural(node, "NumberOfComponents", Some(usual))?;
        let Some(number) = number_type(node)? else { return Ok(None) };
        let count = rows.saturating_mul(components);
        let numbers = self.numbers(node, count, number).map_err(|fault| within(&fault, node, &name))?;
        Ok(Some(Array { name, components: components as usize, numbers }))
    }

    /// The single integers of an array, one a row; `None` if it holds others.
    pub(super) fn integers(&self, node: Node<'_, '_>, rows: u64) -> Result<Option<Numbers>, Error> {
        let name = node.attribute("Name").unwrap_or_default();
        let number = match number_type(node)? {
            None | Some(NumberType::Float32 | NumberType::Float64) => return Ok(None),
            // None that counts anything is so large that a sign matters.
            Some(NumberType::UInt64) => NumberType::Int64,
            Some(number) => number,
        };
        if natural(node, "NumberOfComponents", Some(1))? > 1 {
            return Ok(None);
        }
        let numbers = self.numbers(node, rows, number).map_err(|fault| within(&fault, node, name))?;
        Ok(Some(numbers).filter(Numbers::is_integral))
    }

    fn numbers(&self, node: Node<'_, '_>, count: u64, number: NumberType) -> Result<Numbers, Error> {
        let expected = count.saturating_mul(number.size() as u64);
        let bytes = match node.attribute("format").unwrap_or("ascii") {
            "ascii" => {
                let text = text_of(node);
                let mut values = Values::new(Scanner::new(text.as_bytes()), Encoding::Ascii);
                let numbers = values.numbers(count, number, "a number")?;
                return match values.scanner.next_token()? {
                    None => Ok(numbers),
                    Some(_) => Err(Error::parse(format!("there are more than {count} numbers"))
                        .with_cure("check the counts of the piece and the number of components")),
                };
            }
            // Empty arrays have lengths, or not.
            "binary" | "appended" if count == 0 => Vec::new(),
            "binary" => self.bytes(&mut Stream::Base64(Base64::new(text_of(node).as_bytes())), expected)?,
            "appended" => {
                let offset = natural(node, "offset", None)?;
                let behind = |bytes: &[u8]| {
                    usize::try_from(offset).ok().filter(|&offset| offset <= bytes.len()).ok_or_else(|| {
                        Error::parse(format!("the offset {offset} is behind the end of the appended data"))
                            .with_cure("the file was cut short or damaged: write it again")
                    })
                };
                let mut stream = match self.appended {
                    Appended::None => {
                        return Err(Error::parse("there are no appended data")
                            .with_cure("the file was cut short: write it again"));
                    }
                    Appended::Raw(bytes) => Stream::Raw(&bytes[behind(bytes)?..]),
                    Appended::Base64(text) => Stream::Base64(Base64::new(&text[behind(text)?..])),
                };
                self.bytes(&mut stream, expected)?
            }
            other => {
                let message = format!("\"{}\" is no format of an array", other.escape_debug());
                return Err(Error::parse(message).with_cure("write it as ascii, binary or appended"));
            }
        };
        Values::new(Scanner::new(&bytes[..]), self.encoding).numbers(count, number, "a number")
    }

    /// The bytes of an array behind their length, or of its compressed blocks behind theirs. No memory is taken for an array that promises
    /// another length than `expected`.
    fn bytes(&self, stream: &mut Stream<'_>, expected: u64) -> Result<Vec<u8>, Error> {
        let check = |promised: u64| {
            let fault = || {
                Error::parse(format!("there are {promised} bytes where the numbers have {expected}"))
                    .with_cure("check the counts of the piece and the number of components")
            };
            if promised == expected { Ok(()) } else { Err(fault()) }
        };
        let first = self.length(stream)?;
        if !self.is_compressed {
            check(first)?;
            return Ok(stream.take(first)?.into_owned());
        }
        let [size, last_size] = [self.length(stream)?, self.length(stream)?];
        let is_short = u64::from(first > 0 && last_size > 0);
        check((first - is_short).saturating_mul(size).saturating_add(is_short * last_size))?;
        if first > stream.left() {
            return Err(cut_short());
        }
        let mut lengths = Vec::new();
        for _ in 0..first {
            lengths.push(self.length(stream)?);
        }
        let mut bytes = Vec::new();
        for (i, &length) in lengths.iter().enumerate() {
            let expected = if i + 1 == lengths.len() && last_size > 0 { last_size } else { size };
            let packed = stream.take(length)?;
            let before = bytes.len() as u64;
            // Not a byte more is unpacked than was promised, so that a small file cannot fill memory with what nobody asked for.
            inflated(&packed[..])?.take(expected.saturating_add(1)).read_to_end(&mut bytes).map_err(
                |error| {
                    Error::parse(format!("block {i} cannot be unpacked: {error}"))
                        .with_cure("the file is damaged: write it again")
                },
            )?;
            if bytes.len() as u64 - before != expected {
                let found = bytes.len() as u64 - before;
                let found = if found > expected { "more".to_owned() } else { format!("only {found}") };
                return Err(Error::parse(format!("block {i} has {found} bytes, not {expected}"))
                    .with_cure("the file is damaged: write it again"));
            }
        }
        Ok(bytes)
    }

    fn length(&self, stream: &mut Stream<'_>) -> Result<u64, Error> {
        let bytes = stream.take(self.length.size() as u64)?;
        let bits =
            |bytes: &mut dyn Iterator<Item = &u8>| bytes.fold(0, |bits, &byte| bits << 8 | u64::from(byte));
        Ok(match self.encoding {
            Encoding::BigEndian => bits(&mut bytes.iter()),
            _ => bits(&mut bytes.iter().rev()),
        })
    }
}

/// The fault of an array, at its line.
fn within(fault: &Error, node: Node<'_, '_>, name: &str) -> Error {
    let start = node.children().find(Node::is_text).unwrap_or(node).range().start;
    let line = u64::from(node.document().text_pos_at(start).row) + fault.line().unwrap_or(1) - 1;
    let message = format!("in the array \"{}\": {}", name.escape_debug(), fault.message());
    let cure = fault.cure().unwrap_or("the file was cut short or damaged: write it again");
    Error::new(fault.kind(), message).at_line(line).with_cure(cure)
}

fn text_of<'a>(node: Node<'a, '_>) -> Cow<'a, str> {
    let mut texts = node.children().filter_map(|child| child.text().filter(|_| child.is_text()));
    let first = texts.next().unwrap_or_default();
    match texts.next() {
        None => Cow::Borrowed(first),
        // Comments between them.
        Some(next) => Cow::Owned([first, next].into_iter().chain(texts).collect()),
    }
}

fn cut_short() -> Error {
    Error::new(ErrorKind::Parse, "the bytes end too early")
        .with_cure("the file was cut short or damaged: write it again")
}

/// Bytes as they are, or written as base64.
enum Stream<'a> {
    Raw(&'a [u8]),
    Base64(Base64<'a>),
}

impl<'a> Stream<'a> {
    /// An upper bound of the bytes that are left.
    fn left(&self) -> u64 {
        match self {
            Self::Raw(bytes) => bytes.len() as u64,
            Self::Base64(text) => (text.decoded.len() + 3 * text.text.len() / 4) as u64,
        }
    }

    fn take(&mut self, count: u64) -> Result<Cow<'a, [u8]>, Error> {
        if count > self.left() {
            return Err(cut_short());
        }
        let count = count as usize;
        match self {
            Self::Raw(bytes) => {
                let (taken, rest) = bytes.split_at(count);
                *bytes = rest;
                Ok(Cow::Borrowed(taken))
            }
            Self::Base64(text) => text.take(count).map(Cow::Owned),
        }
    }
}

/// Base64 in groups of four letters. Several texts may stand one after the other, each with its padding: lengths are often written so.
struct Base64<'a> {
    text: &'a [u8],
    /// What has been decoded and not yet taken: up to two bytes.
    decoded: Vec<u8>,
}

impl<'a> Base64<'a> {
    fn new(text: &'a [u8]) -> Self {
        Self { text, decoded: Vec::new() }
    }

    fn take(&mut self, count: usize) -> Result<Vec<u8>, Error> {
        let mut bytes = std::mem::take(&mut self.decoded);
        while bytes.len() < count {
            let mut group = [0; 4];
            let mut letters = 0;
            while letters < 4 {
                let Some((&letter, rest)) = self.text.split_first() else { return Err(cut_short()) };
                self.text = rest;
                if !letter.is_ascii_whitespace() {
                    group[letters] = letter;
                    letters += 1;
                }
            }
            let padding = group.iter().rev().take_while(|&&letter| letter == b'=').count();
            let mut bits = 0u32;
            for &letter in &group[..4 - padding] {
                bits = bits << 6 | value_of(letter)?;
            }
            let [_, three @ ..] = (bits << (6 * padding)).to_be_bytes();
            bytes.extend_from_slice(&three[..3usize.saturating_sub(padding)]);
        }
        self.decoded = bytes.split_off(count);
        Ok(bytes)
    }
}

fn value_of(letter: u8) -> Result<u32, Error> {
    Ok(u32::from(match letter {
        b'A'..=b'Z' => letter - b'A',
        b'a'..=b'z' => letter - b'a' + 26,
        b'0'..=b'9' => letter - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        _ => {
            let letter = char::from(letter).escape_default();
            return Err(Error::parse(format!("\"{letter}\" is no letter of base64"))
                .with_cure("the file is damaged: write it again"));
        }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_of_base64_follow_one_another() {
        let mut text = Base64::new(b"AQ==AgM=\n BAUG BwgJ");
        assert_eq!(text.take(2).unwrap(), [1, 2]);
        assert_eq!(text.take(2).unwrap(), [3, 4]);
        assert_eq!(text.take(5).unwrap(), [5, 6, 7, 8, 9]);
        assert!(text.take(1).is_err());
        assert!(Base64::new(b"A*==").take(1).unwrap_err().to_string().contains("\"*\" is no letter"));
    }
}
