//! OFF files of any layout: words one after the other.

use super::read::{Header, Keyword, Piece, checked_vertex, header, model};
use crate::decimal::is_blank;
use crate::scanner::{parse_coordinate, parse_f64, parse_i64};
use crate::{Model, Place};

/// Reads a whole text word by word, with commas as blanks; `None` if it does not come out even.
///
/// Behind a face, the rest of its line may be a color: that is tried where the faces alone do not come out even.
pub(super) fn read(text: &[u8]) -> Option<Model> {
    [false, true].into_iter().find_map(|has_colors| Words { text, at: 0, line: 1 }.read(has_colors))
}

struct Words<'a> {
    text: &'a [u8],
    at: usize,
    line: u64,
}

impl<'a> Words<'a> {
    fn read(mut self, has_colors: bool) -> Option<Model> {
        let start = self.at_word()?;
        let keyword = match Keyword::before_count(start) {
            Some((keyword, count)) => {
                self.word()?;
                self.at -= count.len();
                keyword
            }
            None => Keyword::default(),
        };
        let dimension = if keyword.any_dimension { self.count()? } else { 3 };
        let (vertices, faces) = (self.count()?, self.count()?);
        self.count()?;
        let header: Header = header(keyword, dimension, vertices, faces).ok()?;
        let mut whole = Piece::default();
        for vertex in 0..vertices {
            let first = whole.coordinates.len();
            for _ in 0..header.dimension {
                whole.coordinates.push(parse_coordinate(self.word()?, "a coordinate").ok()?);
            }
            whole.oddities.note_unplaced(&whole.coordinates[first..], vertex, Some(self.line));
            for _ in 0..header.attributes {
                parse_f64(self.word()?, "a color").ok()?;
            }
        }
        for _ in 0..faces {
            let size = self.count()?;
            let line = self.line;
            for _ in 0..size {
                let vertex = parse_i64(self.word()?, "a vertex").ok()?;
                whole.elements.polygons.items_mut().push(checked_vertex(vertex, vertices).ok()?);
            }
            whole.elements.finish_face(&mut whole.oddities, Place::line(line));
            if has_colors {
                self.skip_line();
            }
        }
        if self.at_word().is_some() {
            return None;
        }
        model(header, whole).ok()
    }

    fn skip_line(&mut self) {
        let rest = &self.text[self.at..];
        self.at += memchr::memchr(b'\n', rest).unwrap_or(rest.len());
    }

    /// The word that comes next, which is not taken.
    fn at_word(&mut self) -> Option<&'a [u8]> {
        loop {
            let rest = &self.text[self.at..];
            match *rest.first()? {
                b'\n' => self.line += 1,
                b'#' => {
                    self.skip_line();
                    continue;
                }
                byte if is_blank(byte) || byte == b',' => {}
                _ => {
                    let ends = |&byte: &u8| is_blank(byte) || matches!(byte, b'\n' | b',' | b'#');
                    return Some(&rest[..rest.iter().position(ends).unwrap_or(rest.len())]);
                }
            }
            self.at += 1;
        }
    }

    fn word(&mut self) -> Option<&'a [u8]> {
        let word = self.at_word()?;
        self.at += word.len();
        Some(word)
    }

    fn count(&mut self) -> Option<u64> {
        u64::try_from(parse_i64(self.word()?, "a count").ok()?).ok()
    }
}
