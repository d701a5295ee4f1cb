//! Well-known text.

use crate::drawing::Drawing;
use coface_check::Fault;

/// The text from a byte on.
struct Reader<'a> {
    text: &'a str,
    at: usize,
}

/// How deep collections may lie in each other.
const DEPTH: usize = 64;

pub(crate) fn read(text: &str, drawing: &mut Drawing) -> Result<(), Fault> {
    let mut reader = Reader { text, at: 0 };
    while !reader.rest().is_empty() {
        reader.geometry(drawing, 0)?;
        while reader.take(';') || reader.take(',') {}
    }
    Ok(())
}

impl Reader<'_> {
    fn rest(&mut self) -> &str {
        self.at += self.text[self.at..].len() - self.text[self.at..].trim_start().len();
        &self.text[self.at..]
    }

    fn fault(&self, what: &str) -> Fault {
        Fault::new("input", format!("at byte {}: {what}", self.at))
    }

    /// Whether this letter is next, which is then read.
    fn take(&mut self, letter: char) -> bool {
        let is_next = self.rest().starts_with(letter);
        self.at += if is_next { letter.len_utf8() } else { 0 };
        is_next
    }

    fn expect(&mut self, letter: char) -> Result<(), Fault> {
        if self.take(letter) { Ok(()) } else { Err(self.fault(&format!("{letter:?} is missing"))) }
    }

    fn word(&mut self) -> String {
        let rest = self.rest();
        let end = rest.find(|letter: char| !letter.is_ascii_alphabetic()).unwrap_or(rest.len());
        let word = rest[..end].to_ascii_uppercase();
        self.at += end;
        word
    }

    /// A list in parentheses; none if EMPTY stands there.
    fn list(&mut self, item: &mut dyn FnMut(&mut Self) -> Result<(), Fault>) -> Result<(), Fault> {
        if !self.take('(') {
            return if self.word() == "EMPTY" { Ok(()) } else { Err(self.fault("'(' or EMPTY is missing")) };
        }
        item(self)?;
        while self.take(',') {
            item(self)?;
        }
        self.expect(')')
    }

    /// Points of two coordinates.
    fn points(&mut self) -> Result<Vec<[f64; 2]>, Fault> {
        let mut points = Vec::new();
        self.list(&mut |reader| {
            points.push([reader.number()?, reader.number()?]);
            Ok(())
        })?;
        Ok(points)
    }

    fn number(&mut self) -> Result<f64, Fault> {
        let rest = self.rest();
        let is_of_number = |letter: char| letter.is_ascii_digit() || "+-.eE".contains(letter);
        let end = rest.find(|letter| !is_of_number(letter)).unwrap_or(rest.len());
        let number = rest[..end].parse();
        let number =
            number.map_err(|_| self.fault("two coordinates a point are read, and this is no number"))?;
        self.at += end;
        Ok(number)
    }

    fn polygon(&mut self, drawing: &mut Drawing) -> Result<(), Fault> {
        let mut rings = Vec::new();
        self.list(&mut |reader| {
            rings.push(reader.points()?);
            Ok(())
        })?;
        drawing.polygon(&rings);
        Ok(())
    }

    fn geometry(&mut self, drawing: &mut Drawing, depth: usize) -> Result<(), Fault> {
        match self.word().as_str() {
            "POLYGON" => self.polygon(drawing),
            "MULTIPOLYGON" => self.list(&mut |reader| reader.polygon(drawing)),
            "LINESTRING" => {
                let points = self.points()?;
                drawing.line(&points);
                Ok(())
            }
            "MULTILINESTRING" => self.list(&mut |reader| {
                let points = reader.points()?;
                drawing.line(&points);
                Ok(())
            }),
            "GEOMETRYCOLLECTION" if depth < DEPTH => {
                self.list(&mut |reader| reader.geometry(drawing, depth + 1))
            }
            _ => Err(self
                .fault("POLYGON, MULTIPOLYGON, LINESTRING, MULTILINESTRING or GEOMETRYCOLLECTION is read")),
        }
    }
}
