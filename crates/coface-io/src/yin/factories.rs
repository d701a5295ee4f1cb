//! Curves as text: what a circle, a rectangle and a list of points are made from.

use super::{BoundaryCurve, BoundaryDrawing, Filling};
use crate::scanner::{Scanner, parse_f64, parse_i64, quoted};
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use coface_geometry::Angle;
use coface_yin::Order;
use std::f64::consts::TAU;
use std::io::Read;

/// The most pieces that a circle or a side of a rectangle gets.
const MOST_PIECES: f64 = (1u32 << 24) as f64;

const NAMES: [&str; 3] = ["Circle", "Rectangle", "OrientedJordanCurve"];

/// Whether a file begins like curves as text: with one of the names, after a line with a number or without. A word that differs from a name in
/// two letters at most, or in capitals, is taken for it where a number follows: what is wrong with it is then said.
pub(crate) fn is_factories(start: &[u8]) -> bool {
    let mut lines = start
        .split(|&byte| byte == b'\n')
        .map(<[u8]>::trim_ascii)
        .filter(|line| !line.is_empty() && line[0] != b'#');
    let is_named = |line: &[u8]| {
        let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        let word = words.next().unwrap_or_default();
        NAMES.iter().any(|name| name.as_bytes() == word)
            || NAMES.iter().any(|name| is_nearly(word, name.as_bytes()))
                && words.next().is_some_and(|number| parse_f64(number, "").is_ok())
    };
    match lines.next() {
        Some(first) if is_named(first) => true,
        Some(first) => parse_f64(first, "").is_ok() && lines.next().is_some_and(is_named),
        None => false,
    }
}

/// Whether two letters inserted, left out or replaced make one word of the other; capitals do not count.
fn is_nearly(word: &[u8], name: &[u8]) -> bool {
    if word.len().abs_diff(name.len()) > 2 {
        return false;
    }
    // The distances of the beginnings of the word from one beginning of the name.
    let mut before: Vec<usize> = (0..=word.len()).collect();
    for (i, letter) in name.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, own) in word.iter().enumerate() {
            let replaced = before[j] + usize::from(!own.eq_ignore_ascii_case(letter));
            row.push(replaced.min(before[j + 1] + 1).min(row[j] + 1));
        }
        before = row;
    }
    before[word.len()] <= 2
}

/// Reads closed curves from text: a line with a tolerance, which is not used, and a line for each curve.
///
/// * `Circle x y r s h`: the circle around (x, y) with radius r, counterclockwise if s is 1 and clockwise if it is 0, in equal pieces
///   shorter than h; it begins at angle 0.
/// * `Rectangle x y z w a s h`: from (x, y) to (z, w), turned around the origin by a radians, in pieces shorter than h; the corners are
///   kinks.
/// * `OrientedJordanCurve n x y .. x y k ..`: n + 1 points, of which the last is the first again, and the numbers of those that are kinks.
///
/// What follows a # is a comment. The curves are of order 4, the set on their left.
///
/// # Errors
/// [`ErrorKind::Parse`] with line and column: an unknown name, a word that is no number or too few or too many of them, a curve without
/// area; [`ErrorKind::TooLarge`] for more than 2^24 pieces along a circle or a side.
///
/// # Complexity
/// Linear in the points.
///
/// # References
/// The format is that of the text factories of a published program for interface tracking, MARS-n2D.
///
/// # Examples
/// ```
/// use coface_io::yin::read_factories;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let drawing = read_factories(&b"1e-10\nCircle 0 0 1 1 0.1\nRectangle -4 -4 4 4 0 1 0.5\n"[..])?;
/// assert_eq!(drawing.curves()[0].points().len(), 63);
/// assert_eq!(drawing.curves()[1].kinks(), [0, 17, 34, 51]);
/// # Ok(()) }
/// ```
pub fn read_factories(input: impl Read) -> Result<BoundaryDrawing, Error> {
    let mut scanner = Scanner::new(input);
    let mut drawing = BoundaryDrawing::new(Order::CUBIC);
    let mut curves = Vec::new();
    let mut has_tolerance = false;
    while let Some(line) = scanner.next_line()? {
        let made = Words::of(line).curve();
        let number = scanner.line_number();
        match made.map_err(|error| error.at_line(number))? {
            None => {}
            Some(Line::Tolerance(_)) if has_tolerance || !curves.is_empty() => {
                return Err(Error::parse("a number without a name of a curve")
                    .at_line(number)
                    .with_cure(CURE));
            }
            Some(Line::Tolerance(tolerance)) => {
                has_tolerance = true;
                drawing.remark(Remark::new(
                    RemarkCode::DataLeftOut,
                    format!("the tolerance {tolerance} is not used: there is none"),
                ));
            }
            Some(Line::Curve(mut curve)) => {
                curve.set_line(number);
                curves.push(*curve);
            }
        }
    }
    if curves.is_empty() {
        return Err(Error::parse("the file has no curve").at_line(scanner.line_number()).with_cure(CURE));
    }
    drawing.push(Filling::Left, curves);
    drawing.check()?;
    Ok(drawing)
}

const CURE: &str =
    "write \"Circle x y r s h\", \"Rectangle x y z w a s h\" or \"OrientedJordanCurve n x y .. x y\"";

enum Line {
    Tolerance(f64),
    Curve(Box<BoundaryCurve>),
}

/// The words of a line one after the other, with the column of each.
struct Words<'a> {
    line: &'a [u8],
    at: usize,
}

impl<'a> Words<'a> {
    fn of(line: &'a [u8]) -> Self {
        let end = line.iter().position(|&byte| byte == b'#').unwrap_or(line.len());
        Self { line: &line[..end], at: 0 }
    }

    /// The next word and its column, from 1.
    fn next(&mut self) -> Option<(&'a [u8], usize)> {
        let is_blank = |byte: &u8| byte.is_ascii_whitespace() || *byte == 0x0b;
        let start = self.at + self.line[self.at..].iter().position(|byte| !is_blank(byte))?;
        let length = self.line[start..].iter().position(is_blank).unwrap_or(self.line.len() - start);
        self.at = start + length;
        Some((&self.line[start..self.at], start + 1))
    }

    fn word(&mut self, what: &str) -> Result<(&'a [u8], usize), Error> {
        let end = self.line.len() + 1;
        self.next().ok_or_else(|| {
            Error::parse(format!("column {end}: the line ends where {what} should be")).with_cure(CURE)
        })
    }

    fn number(&mut self, what: &str) -> Result<f64, Error> {
        self.number_at(what).map(|(number, _)| number)
    }

    fn number_at(&mut self, what: &str) -> Result<(f64, usize), Error> {
        let (word, column) = self.word(what)?;
        let number = parse_f64(word, what).map_err(|error| in_column(&error, column))?;
        Ok((number, column))
    }

    fn positive(&mut self, what: &str) -> Result<f64, Error> {
        let (number, column) = self.number_at(what)?;
        match number {
            number if number > 0.0 => Ok(number),
            number => Err(Error::parse(format!("column {column}: {what} is {number}, not positive"))
                .with_cure("give a positive length")),
        }
    }

    fn whole(&mut self, what: &str) -> Result<(u32, usize), Error> {
        let (word, column) = self.word(what)?;
        let number = parse_i64(word, what).map_err(|error| in_column(&error, column))?;
        match u32::try_from(number) {
            Ok(number) => Ok((number, column)),
            Err(_) => Err(Error::parse(format!("column {column}: {what} is {number}, which there is not"))
                .with_cure("count from 0")),
        }
    }

    fn is_counterclockwise(&mut self) -> Result<bool, Error> {
        match self.whole("the orientation")? {
            (0, _) => Ok(false),
            (1, _) => Ok(true),
            (other, column) => Err(Error::parse(format!("column {column}: the orientation is {other}"))
                .with_cure("write 1 for counterclockwise, 0 for clockwise")),
        }
    }

    /// The number of pieces of a length that are shorter than the spacing.
    fn piece_count(&mut self, lengths: [f64; 2]) -> Result<[usize; 2], Error> {
        let spacing = self.positive("the length of pieces")?;
        let counts = lengths.map(|length| (length / spacing).floor() + 1.0);
        if counts.iter().any(|&count| count.is_nan() || count > MOST_PIECES) {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!(
                    "pieces of {spacing} are more than 2^24 along a length of {}",
                    lengths[0].max(lengths[1])
                ),
            )
            .with_cure("take longer pieces"));
        }
        Ok(counts.map(|count| count as usize))
    }

    fn end(&mut self) -> Result<(), Error> {
        match self.next() {
            None => Ok(()),
            Some((word, column)) => {
                Err(Error::parse(format!("column {column}: {} comes behind the last number", quoted(word)))
                    .with_cure(CURE))
            }
        }
    }

    fn curve(mut self) -> Result<Option<Line>, Error> {
        let Some((name, column)) = self.next() else { return Ok(None) };
        let curve = match name {
            b"Circle" => self.circle()?,
            b"Rectangle" => self.rectangle()?,
            b"OrientedJordanCurve" => return self.points().map(|curve| Some(Line::Curve(Box::new(curve)))),
            _ => match parse_f64(name, "the tolerance") {
                Ok(tolerance) => {
                    self.end()?;
                    return Ok(Some(Line::Tolerance(tolerance)));
                }
                Err(_) => {
                    return Err(Error::parse(format!("column {column}: {} is no curve", quoted(name)))
                        .with_cure(format!("write one of {}", NAMES.join(", "))));
                }
            },
        };
        self.end()?;
        Ok(Some(Line::Curve(Box::new(curve))))
    }

    fn circle(&mut self) -> Result<BoundaryCurve, Error> {
        let center = [self.number("the center")?, self.number("the center")?];
        let radius = self.positive("the radius")?;
        let is_counterclockwise = self.is_counterclockwise()?;
        let [count, _] = self.piece_count([TAU * radius, 0.0])?;
        if count < 3 {
            return Err(Error::parse(format!("a circle in {count} pieces has no area"))
                .with_cure("take shorter pieces"));
        }
        let point = |i: usize| {
            let (cosine, sine) = Angle::turns(i as i64, count as u32).cosine_and_sine();
            let sine = if is_counterclockwise { sine } else { -sine };
            [center[0] + radius * cosine, center[1] + radius * sine]
        };
        Ok(BoundaryCurve::new((0..count).map(point).collect()))
    }

    fn rectangle(&mut self) -> Result<BoundaryCurve, Error> {
        let [low, high] = [
            [self.number("the lower left corner")?, self.number("the lower left corner")?],
            [self.number("the upper right corner")?, self.number("the upper right corner")?],
        ];
        let (sine, cosine) = self.number("the angle")?.sin_cos();
        let is_counterclockwise = self.is_counterclockwise()?;
        let sides = [high[0] - low[0], high[1] - low[1]];
        if sides.iter().any(|&side| side.is_nan() || side <= 0.0) {
            return Err(Error::parse(format!(
                "a rectangle with sides of {} and {} has no area",
                sides[0], sides[1]
            ))
            .with_cure("give the lower left and then the upper right corner"));
        }
        let counts = self.piece_count(sides)?;
        let corners = [low, [high[0], low[1]], high, [low[0], high[1]]];
        let (mut points, mut kinks) = (Vec::with_capacity(2 * (counts[0] + counts[1])), Vec::new());
        for side in 0..4 {
            let [a, b] = [corners[side], corners[(side + 1) % 4]];
            let count = counts[side % 2];
            kinks.push(points.len() as u32);
            points.extend((0..count).map(|i| {
                let part = i as f64 / count as f64;
                let [x, y] = [0, 1].map(|k| if a[k] == b[k] { a[k] } else { a[k] + part * (b[k] - a[k]) });
                [cosine * x - sine * y, sine * x + cosine * y]
            }));
        }
        if !is_counterclockwise {
            points[1..].reverse();
            let count = points.len() as u32;
            kinks = kinks.iter().rev().map(|&kink| (count - kink) % count).collect();
            kinks.rotate_right(1);
        }
        let mut curve = BoundaryCurve::new(points);
        curve.set_kinks(kinks);
        Ok(curve)
    }

    fn points(mut self) -> Result<BoundaryCurve, Error> {
        let (count, _) = self.whole("the number of pieces")?;
        let mut points = Vec::new();
        let mut column = self.at;
        // Room is made for what is there only.
        for _ in 0..=count {
            let (x, at) = self.number_at("a coordinate")?;
            column = at;
            points.push([x, self.number("a coordinate")?]);
        }
        let last = points.pop().expect("there is one more than pieces");
        if points.first().is_some_and(|&first| first != last) {
            return Err(Error::parse(format!(
                "column {column}: the last point ({}, {}) is not the first",
                last[0], last[1]
            ))
            .with_cure("repeat the first point at the end"));
        }
        let mut kinks = Vec::new();
        while self.line[self.at..].iter().any(|byte| !byte.is_ascii_whitespace()) {
            let (kink, column) = self.whole("a kink")?;
            if kink > count {
                return Err(Error::parse(format!("column {column}: there is no point {kink} to be a kink"))
                    .with_cure(format!("the points are 0 to {}", count.saturating_sub(1))));
            }
            // The last point is the first.
            kinks.push(if kink == count { 0 } else { kink });
        }
        let mut curve = BoundaryCurve::new(points);
        curve.set_kinks(kinks);
        Ok(curve)
    }
}

fn in_column(error: &Error, column: usize) -> Error {
    let said = Error::new(error.kind(), format!("column {column}: {}", error.message()));
    match error.cure() {
        Some(cure) => said.with_cure(cure),
        None => said,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn found_by_content() {
        assert!(
            is_factories(b"1e-10\n# a frame\nRectangle -2 -1 2 1 0 1 0.3\n") && !is_factories(b"0,0,1,1\n")
        );
        // What is spelt wrong is found, so that it can be named; what has another meaning is not.
        for wrong in
            ["Cirle 0 0 1 1 0.1", "circle 0 0 1 1 0.1", "1e-9\nRectangel 0 0 1 1 0 1 0.1", "Kreis 0 0 1 1"]
        {
            assert_eq!(is_factories(wrong.as_bytes()), wrong != "Kreis 0 0 1 1", "{wrong}");
        }
        assert!(!is_factories(b"Circles\n") && !is_factories(b"POLYGON ((0 0, 1 0, 1 1, 0 0))"));
        let error =
            read_factories(&b"Circle 0 0 1 1 0.1\nCirle 0 0 1 1 0.1\n"[..]).expect_err("it is no curve");
        assert_eq!(error.line(), Some(2));
        let said = error.to_string();
        assert!(said.contains("\"Cirle\"") && NAMES.iter().all(|name| said.contains(name)), "{said}");
    }
}
