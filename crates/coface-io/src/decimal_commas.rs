//! Tables whose numbers have decimal commas.

use crate::scanner::{LONGEST, quoted};
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use std::borrow::Cow;
use std::io::Read;

const CURE: &str = "write decimal points, or semicolons between numbers that have decimal commas";

/// The same text with decimal points, where semicolons, tabs or quotes hold numbers with decimal commas apart, and a remark that says so. It
/// has as many bytes in each line.
///
/// # Errors
/// [`Parse`](ErrorKind::Parse) with the line, where commas may be decimal commas or stand between numbers.
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// let (text, remark) = coface_io::with_decimal_points(b"0,5;1,25\n2;3,5\n").expect("a table");
/// assert_eq!(&text[..], b"0.5;1.25\n2;3.5\n");
/// assert!(remark.is_some());
/// ```
pub fn with_decimal_points(text: &[u8]) -> Result<(Cow<'_, [u8]>, Option<Remark>), Error> {
    if !text.contains(&b',') || !text.iter().any(|byte| matches!(byte, b';' | b'\t' | b'"' | b' ')) {
        return Ok((Cow::Borrowed(text), None));
    }
    let lines = || text.split(|&byte| byte == b'\n').zip(1u64..).filter(|(line, _)| !is_comment(line));
    let mut found = Found::default();
    for (line, number) in lines() {
        found.look_at(line, number);
    }
    let Some(first) = found.decimal.or(found.in_quotes) else {
        return match found.between_blanks {
            Some((line, number)) if found.points.is_none() => Err(fault(
                "blanks stand between numbers that have commas in them, which may be decimal commas",
                line,
                number,
            )),
            _ => Ok((Cow::Borrowed(text), None)),
        };
    };
    if let Some((line, number)) = found.lists.or(found.points) {
        let message = "commas stand in numbers and between them, or beside decimal points";
        return Err(fault(message, line, number));
    }
    let mut changed = text.to_vec();
    let mut count = 0;
    let mut is_quoted = false;
    for at in 0..text.len() {
        let is_digit = |at: usize| text.get(at).is_some_and(u8::is_ascii_digit);
        match text[at] {
            b'"' => is_quoted = !is_quoted,
            b'\n' => is_quoted = false,
            b',' if (is_quoted || found.decimal.is_some())
                && at > 0
                && is_digit(at - 1)
                && is_digit(at + 1) =>
            {
                changed[at] = b'.';
                count += 1;
            }
            _ => {}
        }
    }
    let message = format!("commas were read as decimal commas, as in {}", quoted(first.0));
    let remark = Remark::new(RemarkCode::InputReading, message).at(count, [crate::Place::line(first.1)]);
    Ok((Cow::Owned(changed), Some(remark)))
}

/// All of a text.
///
/// # Errors
/// [`Parse`](ErrorKind::Parse) for a line that is longer than any is read; [`Io`](ErrorKind::Io) if the stream fails.
pub(crate) fn whole_text(input: impl Read) -> Result<Vec<u8>, Error> {
    let (mut text, mut line_start) = (Vec::new(), 0);
    let mut input = input;
    loop {
        let before = text.len();
        input.by_ref().take(1 << 20).read_to_end(&mut text)?;
        if text.len() == before {
            return Ok(text);
        }
        if let Some(end) = memchr::memrchr(b'\n', &text[before..]) {
            line_start = before + end + 1;
        }
        if text.len() - line_start > LONGEST {
            return Err(Error::parse(format!("a line or word is longer than {LONGEST} bytes"))
                .with_cure("this is not a text file of a format known here"));
        }
    }
}

/// That nothing says what commas are.
fn fault(message: &str, line: &[u8], number: u64) -> Error {
    let shown = quoted(line.trim_ascii().get(..60).unwrap_or(line.trim_ascii()));
    Error::new(ErrorKind::Parse, format!("{message}: {shown}")).at_line(number).with_cure(CURE)
}

fn is_comment(line: &[u8]) -> bool {
    let line = line.trim_ascii();
    [&b"#"[..], b"//", b"%"].iter().any(|start| line.starts_with(start))
}

type At<'a> = Option<(&'a [u8], u64)>;

/// The first lines that have numbers of each kind.
#[derive(Default)]
struct Found<'a> {
    /// A number with a comma between semicolons or tabs.
    decimal: At<'a>,
    /// One in quotes.
    in_quotes: At<'a>,
    /// Several numbers with commas between semicolons or tabs.
    lists: At<'a>,
    /// A number with a decimal point.
    points: At<'a>,
    /// Nothing but numbers with commas between blanks.
    between_blanks: At<'a>,
}

impl<'a> Found<'a> {
    fn look_at(&mut self, line: &'a [u8], number: u64) {
        let at = (line.trim_ascii(), number);
        let pieces = line.split(|byte| matches!(byte, b';' | b'\t' | b',' | b' ' | b'\r' | b'"'));
        if self.points.is_none() && pieces.clone().any(has_point) {
            self.points = Some(at);
        }
        if !line.contains(&b',') {
            return;
        }
        let quoted = line.split(|&byte| byte == b'"').skip(1).step_by(2);
        if quoted.clone().any(has_decimal_comma) {
            self.in_quotes.get_or_insert(at);
        }
        if line.contains(&b';') || line.contains(&b'\t') {
            for field in outside_of_quotes(line).split(|byte| matches!(byte, b';' | b'\t')) {
                let field = field.trim_ascii();
                if has_decimal_comma(field) {
                    self.decimal.get_or_insert(at);
                } else if field.contains(&b',') && field.split(|&byte| byte == b',').all(is_whole) {
                    self.lists.get_or_insert(at);
                }
            }
            return;
        }
        let fields = || line.split(|byte| matches!(byte, b' ' | b'\r')).filter(|field| !field.is_empty());
        if fields().count() > 1 && fields().all(has_decimal_comma) {
            self.between_blanks.get_or_insert(at);
        }
    }
}

/// The line with blanks for what is in quotes.
fn outside_of_quotes(line: &[u8]) -> Cow<'_, [u8]> {
    if !line.contains(&b'"') {
        return Cow::Borrowed(line);
    }
    let mut is_quoted = false;
    let outside = line.iter().map(|&byte| {
        is_quoted ^= byte == b'"';
        if is_quoted || byte == b'"' { b' ' } else { byte }
    });
    Cow::Owned(outside.collect())
}

fn is_whole(field: &[u8]) -> bool {
    let field = field.strip_prefix(b"-").or(field.strip_prefix(b"+")).unwrap_or(field);
    !field.is_empty() && field.iter().all(u8::is_ascii_digit)
}

/// Whether it is a number with one comma, between digits.
fn has_decimal_comma(field: &[u8]) -> bool {
    let Some(comma) = field.iter().position(|&byte| byte == b',') else { return false };
    let (whole, part) = (&field[..comma], &field[comma + 1..]);
    let digits = part.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let exponent = &part[digits..];
    let is_exponent = exponent.is_empty() || matches!(exponent[0], b'e' | b'E') && is_whole(&exponent[1..]);
    is_whole(whole) && digits > 0 && is_exponent
}

fn has_point(piece: &[u8]) -> bool {
    piece.contains(&b'.') && std::str::from_utf8(piece).is_ok_and(|piece| piece.parse::<f64>().is_ok())
}

#[cfg(test)]
mod tests {
    use super::with_decimal_points;

    #[test]
    fn commas_that_other_marks_hold_apart_are_decimal() {
        for (text, points) in [
            ("x;y\n0,5;1,25\n", "x;y\n0.5;1.25\n"),
            ("x\ty\n-0,5\t1,25e-3\n2\t3\n", "x\ty\n-0.5\t1.25e-3\n2\t3\n"),
            ("0,5\n1,5;2,5\n", "0.5\n1.5;2.5\n"),
            ("\"0,5\",\"1,25\"\n", "\"0.5\",\"1.25\"\n"),
            ("\"0,5\";7\n", "\"0.5\";7\n"),
        ] {
            let (changed, remark) = with_decimal_points(text.as_bytes()).unwrap();
            assert_eq!(changed, points.as_bytes(), "{text}");
            assert!(remark.unwrap().message.contains("decimal commas"));
        }
        for same in [
            "0,5\n1,25\n",
            "1, 2, 3\n",
            "0.5,1;2\n",
            "1,2,3;4,5,6\n",
            "a,\"b, c\"\n",
            "1,\t2\n",
            "# 0,5;1\n1,2 3\n",
        ] {
            let (kept, remark) = with_decimal_points(same.as_bytes()).unwrap();
            assert_eq!((&kept[..], remark), (same.as_bytes(), None), "{same}");
        }
        for text in ["0,5;1,25\n0.5;2\n", "0,5;1\n1,2,3;4\n", "0,5 1,25\n", "1.234,5;2,5\n"] {
            let error = with_decimal_points(text.as_bytes()).unwrap_err();
            assert!(error.line().is_some() && error.cure().is_some(), "{text}: {error}");
        }
    }
}
