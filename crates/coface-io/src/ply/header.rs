//! The header of a PLY file: which elements follow, and how.

use super::Encoding;
use crate::scanner::{Scanner, parse_i64, quoted};
use coface_algebra::Error;
use std::io::Read;

/// What the header says.
#[derive(Debug, PartialEq)]
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// The first line that is none of a header, with its number.
    pub(super) unknown: Option<(u64, String)>,
}

/// Things of one kind: how many, and what is said of each.
#[derive(Debug, PartialEq)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

#[derive(Debug, PartialEq)]
pub(super) struct Property {
    pub(super) name: String,
    /// The type of the count, if the property is a list.
    pub(super) count: Option<Scalar>,
    /// The type of the value, or of each item.
    pub(super) value: Scalar,
}

/// A type of numbers; each fits in `f64` exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn parse(word: &[u8]) -> Result<Self, Error> {
        Ok(match word {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => {
                return Err(Error::parse(format!("{} is not a type of numbers", quoted(word))).with_cure(
                    "the types are char, uchar, short, ushort, int, uint, float, double and int8 .. float64",
                ));
            }
        })
    }

    /// The length in bytes.
    pub(super) const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// The number that starts at the beginning of these bytes, of which there are enough.
    #[inline]
    pub(super) fn decode(self, bytes: &[u8], big: bool) -> f64 {
        /// The first bytes, the least significant one first.
        fn first<const N: usize>(bytes: &[u8], big: bool) -> [u8; N] {
            let mut array = [0; N];
            array.copy_from_slice(&bytes[..N]);
            if big {
                array.reverse();
            }
            array
        }
        match self {
            Self::I8 => f64::from(bytes[0] as i8),
            Self::U8 => f64::from(bytes[0]),
            Self::I16 => f64::from(i16::from_le_bytes(first(bytes, big))),
            Self::U16 => f64::from(u16::from_le_bytes(first(bytes, big))),
            Self::I32 => f64::from(i32::from_le_bytes(first(bytes, big))),
            Self::U32 => f64::from(u32::from_le_bytes(first(bytes, big))),
            Self::F32 => f64::from(f32::from_le_bytes(first(bytes, big))),
            Self::F64 => f64::from_le_bytes(first(bytes, big)),
        }
    }
}

impl Element {
    /// How many records the data have of it: those without properties are not there.
    pub(super) fn rows(&self) -> u64 {
        if self.properties.is_empty() { 0 } else { self.count }
    }

    /// The length of one such thing in bytes, if it has no lists.
    pub(super) fn stride(&self) -> Option<usize> {
        self.properties.iter().map(|p| if p.count.is_none() { Some(p.value.size()) } else { None }).sum()
    }

    /// The position of the property of this name that is a number.
    pub(super) fn number(&self, name: &str) -> Option<usize> {
        self.properties.iter().position(|p| p.name == name && p.count.is_none())
    }

    /// The position of the property that lists vertices: the one of that name, or the only list of whole numbers.
    pub(super) fn vertex_list(&self) -> Option<usize> {
        let named = |p: &Property| matches!(p.name.as_str(), "vertex_indices" | "vertex_index");
        let is_list = |p: &Property| p.count.is_some() && !matches!(p.value, Scalar::F32 | Scalar::F64);
        let only = || {
            let mut lists = (0..self.properties.len()).filter(|&i| is_list(&self.properties[i]));
            lists.next().filter(|_| lists.next().is_none())
        };
        self.properties.iter().position(|p| named(p) && p.count.is_some()).or_else(only)
    }
}

/// Reads the header up to `end_header`.
pub(super) fn read_header<R: Read>(input: &mut Scanner<R>) -> Result<Header, Error> {
    const CURE: &str = "a PLY file begins with \"ply\" and a header up to \"end_header\"";
    let mut encoding = None;
    let mut elements: Vec<Element> = Vec::new();
    let mut unknown = None;
    let mut first = true;
    while let Some(line) = input.next_line()? {
        let words: Vec<&[u8]> = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()).collect();
        let result = match words.as_slice() {
            [b"ply"] if first => Ok(()),
            _ if first => {
                Err(Error::parse(format!("the file begins with {}, not with ply", quoted(line)))
                    .with_cure(CURE))
            }
            [] | [b"comment" | b"obj_info", ..] => Ok(()),
            [b"end_header"] => {
                let Some(encoding) = encoding else {
                    return Err(input
                        .error("the header names no format")
                        .with_cure("write \"format ascii 1.0\""));
                };
                return Ok(Header { encoding, elements, unknown });
            }
            [b"format", name, ..] => parse_encoding(name).map(|name| encoding = Some(name)),
            [b"element", name, count] => parse_element(name, count).and_then(|element| {
                if elements.iter().any(|known| known.name == element.name) {
                    return Err(
                        Error::parse(format!("a second element {}", quoted(name))).with_cure("remove it")
                    );
                }
                elements.push(element);
                Ok(())
            }),
            [b"property", rest @ ..] => {
                match elements.last_mut() {
                    Some(element) => parse_property(rest).map(|property| element.properties.push(property)),
                    None => Err(Error::parse("a property before the first element")
                        .with_cure("put the element first")),
                }
            }
            // Before anything is promised, a line of other words can only be a comment.
            _ if elements.is_empty() => {
                let text = quoted(line);
                unknown.get_or_insert((input.line_number(), text));
                Ok(())
            }
            _ => Err(Error::parse(format!("{} is no line of a PLY header", quoted(line))).with_cure(CURE)),
        };
        result.map_err(|error| error.at_line(input.line_number()))?;
        first = false;
    }
    if first {
        return Err(Error::parse("the file is empty").at_line(1).with_cure(CURE));
    }
    Err(input.error("the file ends inside the header").with_cure(CURE))
}

fn parse_encoding(name: &[u8]) -> Result<Encoding, Error> {
    match name {
        b"ascii" => Ok(Encoding::Ascii),
        b"binary_little_endian" => Ok(Encoding::LittleEndian),
        b"binary_big_endian" => Ok(Encoding::BigEndian),
        _ => Err(Error::parse(format!("{} is not a format", quoted(name)))
            .with_cure("the formats are ascii, binary_little_endian and binary_big_endian")),
    }
}

fn parse_element(name: &[u8], count: &[u8]) -> Result<Element, Error> {
    let count = parse_i64(count, "the count of an element")?;
    let count = u64::try_from(count)
        .map_err(|_| Error::parse(format!("the count of an element is {count}; it cannot be negative")))?;
    Ok(Element { name: String::from_utf8_lossy(name).into_owned(), count, properties: Vec::new() })
}

fn parse_property(words: &[&[u8]]) -> Result<Property, Error> {
    let text = |name: &[u8]| String::from_utf8_lossy(name).into_owned();
    match words {
        [b"list", count, value, name] => Ok(Property {
            name: text(name),
            count: Some(Scalar::parse(count)?),
            value: Scalar::parse(value)?,
        }),
        [value, name] => Ok(Property { name: text(name), count: None, value: Scalar::parse(value)? }),
        _ => Err(Error::parse("a property is a type and a name")
            .with_cure("write \"property TYPE NAME\" or \"property list COUNT_TYPE TYPE NAME\"")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header(text: &str) -> Result<Header, Error> {
        read_header(&mut Scanner::new(text.as_bytes()))
    }

    #[test]
    fn types_lists_and_comments() {
        let header = header(
            "ply\r\nformat binary_big_endian 1.0\r\ncomment x\nobj_info y z\nelement face 7\n\
             property list uint8 int32 vertex_index\nproperty float64 quality\nend_header\n",
        )
        .unwrap();
        assert_eq!(header.encoding, Encoding::BigEndian);
        let face = &header.elements[0];
        assert_eq!(
            (face.count, face.vertex_list(), face.number("quality"), face.stride()),
            (7, Some(0), Some(1), None)
        );
    }

    #[test]
    fn faults_name_their_line() {
        for (text, line) in [
            ("", 1),
            ("plx\n", 1),
            ("ply\nend_header\n", 2),
            ("ply\nformat ascii2 1.0\n", 2),
            ("ply\nproperty float x\n", 2),
            ("ply\nelement vertex -1\n", 2),
            ("ply\nelement vertex 1\nproperty real x\n", 3),
            ("ply\nelement vertex 1\nelement vertex 1\n", 3),
            ("ply\n\nelement vertex\n", 3),
            ("ply\nformat ascii 1.0\n", 2),
        ] {
            assert_eq!(header(text).unwrap_err().line(), Some(line), "{text}");
        }
    }

    #[test]
    fn numbers_in_both_orders() {
        let bytes = [0x00, 0x00, 0x80, 0xbf, 0, 0, 0, 0];
        assert_eq!(Scalar::F32.decode(&bytes, false), -1.0);
        assert_eq!(Scalar::I16.decode(&[0xff, 0xfe], true), -2.0);
        assert_eq!(Scalar::U16.decode(&[0xff, 0xfe], true), 65534.0);
        assert_eq!(Scalar::U32.decode(&[1, 0, 0, 0x80], false), 2147483649.0);
        assert_eq!(Scalar::I8.decode(&[0x80], false), -128.0);
    }
}
