//! A stream of bytes as lines, tokens and binary blocks, with the place of each.

use coface_algebra::{Error, ErrorKind};
use std::io::Read;

/// The longest line or token that is read; a longer one is not text of any format here.
pub(super) const LONGEST: usize = 1 << 26;
const BLOCK: usize = 1 << 18;

/// Reads a stream once, forward, in blocks; knows the line and the byte it is at.
///
/// Memory is one block, or the longest line if that is longer: a file of many gigabytes without a line end is refused
/// before it fills memory.
pub(crate) struct Scanner<R> {
    input: R,
    buffer: Vec<u8>,
    /// The unread bytes are `buffer[at..end]`.
    at: usize,
    end: usize,
    /// The byte of the stream that `buffer[0]` is.
    base: u64,
    /// The line that `at` is on, from 1.
    line: u64,
    /// The line and byte of the token or line given last.
    place: (u64, u64),
    comment: Option<u8>,
    finished: bool,
}

impl<R: Read> Scanner<R> {
    pub(crate) fn new(input: R) -> Self {
        Self {
            input,
            buffer: vec![0; BLOCK],
            at: 0,
            end: 0,
            base: 0,
            line: 1,
            place: (1, 0),
            comment: None,
            finished: false,
        }
    }

    /// A scanner of what is left of a stream, from this line and byte on.
    pub(crate) fn resumed(input: R, line: u64, byte: u64) -> Self {
        Self { base: byte, line, place: (line, byte), ..Self::new(input) }
    }

    /// The rest of a line from this byte on is no token.
    pub(crate) fn with_comments(mut self, start: u8) -> Self {
        self.comment = Some(start);
        self
    }

    /// Reads one more block behind the unread bytes; false at the end of the stream.
    fn fill(&mut self) -> Result<bool, Error> {
        if self.finished {
            return Ok(false);
        }
        if self.at > 0 {
            self.buffer.copy_within(self.at..self.end, 0);
            self.base += self.at as u64;
            self.end -= self.at;
            self.at = 0;
        }
        if self.end == self.buffer.len() {
            if self.end >= LONGEST {
                return Err(self
                    .error(format!("a line or word is longer than {LONGEST} bytes"))
                    .with_cure("this is not a text file of a format known here"));
            }
            self.buffer.resize(self.end * 2, 0);
        }
        loop {
            match self.input.read(&mut self.buffer[self.end..]) {
                Ok(0) => {
                    self.finished = true;
                    return Ok(false);
                }
                Ok(count) => {
                    self.end += count;
                    return Ok(true);
                }
                Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
                Err(error) => return Err(Error::from(error).at_line(self.line)),
            }
        }
    }

    /// The next line without its end (`\n` or `\r\n`), or `None` at the end of the stream. Comments are not removed.
    pub(crate) fn next_line(&mut self) -> Result<Option<&[u8]>, Error> {
        let mut searched = 0;
        let (length, ended) = loop {
            if let Some(found) = memchr::memchr(b'\n', &self.buffer[self.at + searched..self.end]) {
                break (searched + found, true);
            }
            searched = self.end - self.at;
            if !self.fill()? {
                break (self.end - self.at, false);
            }
        };
        if length == 0 && !ended {
            return Ok(None);
        }
        let start = self.at;
        self.place = (self.line, self.base + start as u64);
        self.at += length + usize::from(ended);
        self.line += u64::from(ended);
        let mut line = &self.buffer[start..start + length];
        if line.last() == Some(&b'\r') {
            line = &line[..line.len() - 1];
        }
        Ok(Some(line))
    }

    /// The next run of bytes that are not white space, or `None` at the end of the stream.
    pub(crate) fn next_token(&mut self) -> Result<Option<&[u8]>, Error> {
        // Skip white space and comments.
        let mut in_comment = false;
        loop {
            while self.at < self.end {
                let byte = self.buffer[self.at];
                if byte == b'\n' {
                    self.line += 1;
                    in_comment = false;
                } else if !in_comment {
                    if Some(byte) == self.comment {
                        in_comment = true;
                    } else if !byte.is_ascii_whitespace() {
                        break;
                    }
                }
                self.at += 1;
            }
            if self.at < self.end {
                break;
            }
            if !self.fill()? {
                return Ok(None);
            }
        }
        let mut length = 0;
        loop {
            let rest = &self.buffer[self.at + length..self.end];
            match rest.iter().position(|byte| byte.is_ascii_whitespace() || Some(*byte) == self.comment) {
                Some(found) => {
                    length += found;
                    break;
                }
                None => length += rest.len(),
            }
            if !self.fill()? {
                break;
            }
        }
        let start = self.at;
        self.place = (self.line, self.base + start as u64);
        self.at += length;
        Ok(Some(&self.buffer[start..start + length]))
    }

    /// The line of the next token, which is not taken; at the end of the stream the last line.
    pub(crate) fn next_token_line(&mut self) -> Result<u64, Error> {
        loop {
            while self.at < self.end && self.buffer[self.at].is_ascii_whitespace() {
                self.line += u64::from(self.buffer[self.at] == b'\n');
                self.at += 1;
            }
            if self.at < self.end || !self.fill()? {
                return Ok(self.line);
            }
        }
    }

    /// Whether more than white space stands between the token that was given last and the end of its line.
    pub(crate) fn line_goes_on(&mut self) -> Result<bool, Error> {
        loop {
            while self.at < self.end && self.buffer[self.at].is_ascii_whitespace() {
                if self.buffer[self.at] == b'\n' {
                    return Ok(false);
                }
                self.at += 1;
            }
            if self.at < self.end || !self.fill()? {
                return Ok(self.at < self.end);
            }
        }
    }

    /// The next token, which must be there; `what` says what it was to be.
    pub(crate) fn expect_token(&mut self, what: &str) -> Result<&[u8], Error> {
        // The borrow checker cannot see that an early return ends the borrow, hence the second slice.
        let length = match self.next_token()? {
            Some(token) => token.len(),
            None => {
                return Err(Error::parse(format!("the file ends where {what} should be")).at_line(self.line));
            }
        };
        Ok(&self.buffer[self.at - length..self.at])
    }

    /// The next token as a finite number.
    pub(crate) fn expect_f64(&mut self, what: &str) -> Result<f64, Error> {
        let value = parse_f64(self.expect_token(what)?, what);
        value.map_err(|error| error.at_line(self.place.0))
    }

    /// The next token as a coordinate, which need not be finite.
    pub(crate) fn expect_coordinate(&mut self, what: &str) -> Result<f64, Error> {
        let value = parse_coordinate(self.expect_token(what)?, what);
        value.map_err(|error| error.at_line(self.place.0))
    }

    /// The next token as an integer.
    pub(crate) fn expect_i64(&mut self, what: &str) -> Result<i64, Error> {
        let value = parse_i64(self.expect_token(what)?, what);
        value.map_err(|error| error.at_line(self.place.0))
    }

    /// The next token as a number that is not negative, such as a count.
    pub(crate) fn expect_u64(&mut self, what: &str) -> Result<u64, Error> {
        let value = self.expect_i64(what)?;
        u64::try_from(value).map_err(|_| self.error(format!("{what} is {value}; it cannot be negative")))
    }

    /// Fills `bytes` from the stream, binary.
    pub(crate) fn read_exact(&mut self, bytes: &mut [u8], what: &str) -> Result<(), Error> {
        let mut filled = 0;
        self.place = (self.line, self.base + self.at as u64);
        while filled < bytes.len() {
            if self.at == self.end && !self.fill()? {
                return Err(Error::parse(format!(
                    "the file ends inside {what}: {} bytes are missing",
                    bytes.len() - filled
                ))
                .at_byte(self.base + self.at as u64));
            }
            let count = (bytes.len() - filled).min(self.end - self.at);
            bytes[filled..filled + count].copy_from_slice(&self.buffer[self.at..self.at + count]);
            filled += count;
            self.at += count;
        }
        Ok(())
    }

    /// The unread bytes that are at hand, at least `least` of them unless the stream ends before.
    pub(crate) fn available(&mut self, least: usize) -> Result<&[u8], Error> {
        while self.end - self.at < least && self.fill()? {}
        Ok(&self.buffer[self.at..self.end])
    }

    /// Takes the first of the [`available`](Self::available) bytes.
    pub(crate) fn consume(&mut self, count: usize) {
        self.at = (self.at + count).min(self.end);
    }

    /// The line of the token or line that was given last, from 1.
    pub(crate) fn line_number(&self) -> u64 {
        self.place.0
    }

    /// The byte of the stream that comes next, from 0.
    pub(crate) fn byte_offset(&self) -> u64 {
        self.base + self.at as u64
    }

    /// A parse error at the token or line that was given last.
    pub(crate) fn error(&self, message: impl Into<String>) -> Error {
        Error::new(ErrorKind::Parse, message).at_line(self.place.0)
    }
}

/// The token as a coordinate, which need not be finite: `nan`, `inf`, `-Infinity`, `-nan(ind)` and numbers beyond the range
/// are read; `what` names it in the error.
pub(crate) fn parse_coordinate(token: &[u8], what: &str) -> Result<f64, Error> {
    match fast_float2::parse::<f64, _>(token) {
        Ok(value) => Ok(value),
        Err(_) if is_nan_with_payload(token) => Ok(f64::NAN),
        Err(_) => Err(Error::parse(format!("{} is not a number, as {what} must be", quoted(token)))),
    }
}

/// Whether a token is what C libraries write for some numbers that are none: `nan(ind)`, `-nan(0x7)`.
fn is_nan_with_payload(token: &[u8]) -> bool {
    let digits = token.strip_prefix(b"-").or(token.strip_prefix(b"+")).unwrap_or(token);
    digits.len() >= 5 && digits[..4].eq_ignore_ascii_case(b"nan(") && digits.ends_with(b")")
}

/// The token as a finite floating-point number; `what` names it in the error.
pub(crate) fn parse_f64(token: &[u8], what: &str) -> Result<f64, Error> {
    match fast_float2::parse::<f64, _>(token) {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(value) => Err(Error::parse(format!("{what} is {value}, not a finite number"))
            .with_cure("remove the point or give it finite coordinates")),
        Err(_) => Err(Error::parse(format!("{} is not a number, as {what} must be", quoted(token)))),
    }
}

/// The token as an integer; `what` names it in the error.
pub(crate) fn parse_i64(token: &[u8], what: &str) -> Result<i64, Error> {
    let (negative, digits) = match token {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    let mut value = 0i64;
    // Downward: there is one more negative number.
    for &digit in digits {
        let next = match digit {
            b'0'..=b'9' => value.checked_mul(10).and_then(|v| v.checked_sub(i64::from(digit - b'0'))),
            _ => return Err(Error::parse(format!("{} is not an integer, as {what} must be", quoted(token)))),
        };
        value = next.ok_or_else(|| Error::parse(format!("{what} {} is out of range", quoted(token))))?;
    }
    if digits.is_empty() {
        return Err(Error::parse(format!("{} is not an integer, as {what} must be", quoted(token))));
    }
    if negative {
        return Ok(value);
    }
    value.checked_neg().ok_or_else(|| Error::parse(format!("{what} {} is out of range", quoted(token))))
}

/// A token for an error message: shortened, control characters escaped.
pub(crate) fn quoted(token: &[u8]) -> String {
    let shown = &token[..token.len().min(40)];
    let dots = if shown.len() < token.len() { "..." } else { "" };
    format!("\"{}{dots}\"", String::from_utf8_lossy(shown).escape_debug())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A reader that gives one byte at a time, the worst case for block borders.
    struct Drip<'a>(&'a [u8]);

    impl Read for Drip<'_> {
        fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
            let Some((&first, rest)) = self.0.split_first() else { return Ok(0) };
            out[0] = first;
            self.0 = rest;
            Ok(1)
        }
    }

    #[test]
    fn tokens_keep_their_lines_whatever_the_blocks() {
        let text = b"# first\n 12 abc#x\n\n  -3.5e2\r\nlast";
        let mut scanner = Scanner::new(Drip(text)).with_comments(b'#');
        assert_eq!(scanner.expect_u64("a count").unwrap(), 12);
        assert_eq!(scanner.line_number(), 2);
        assert_eq!(scanner.next_token().unwrap(), Some(&b"abc"[..]));
        assert_eq!(scanner.expect_f64("x").unwrap(), -350.0);
        assert_eq!(scanner.line_number(), 4);
        let error = scanner.expect_i64("an index").unwrap_err();
        assert_eq!(error.to_string(), "line 5: \"last\" is not an integer, as an index must be");
        assert!(
            scanner.expect_token("a face").unwrap_err().to_string().contains("the file ends where a face")
        );
    }

    #[test]
    fn lines_and_binary_blocks_mix() {
        let mut scanner = Scanner::new(Drip(b"ply\r\nend\n\x01\x02\x03"));
        assert_eq!(scanner.next_line().unwrap(), Some(&b"ply"[..]));
        assert_eq!(scanner.next_line().unwrap(), Some(&b"end"[..]));
        let mut bytes = [0; 2];
        scanner.read_exact(&mut bytes, "a vertex").unwrap();
        assert_eq!((bytes, scanner.byte_offset()), ([1, 2], 11));
        assert_eq!(scanner.read_exact(&mut bytes, "a face").unwrap_err().byte(), Some(12));
    }

    #[test]
    fn numbers_that_are_none_are_refused() {
        for bad in ["nan", "inf", "1e999", "x", "", "1.2.3"] {
            assert!(parse_f64(bad.as_bytes(), "x").is_err(), "{bad}");
        }
        for bad in ["nan", "-NaN", "nan(ind)", "-nan(ind)", "NaN(0x7f)"] {
            assert!(parse_coordinate(bad.as_bytes(), "x").unwrap().is_nan(), "{bad}");
        }
        for (word, value) in [
            ("inf", f64::INFINITY),
            ("-Infinity", f64::NEG_INFINITY),
            ("-1e999", f64::NEG_INFINITY),
            ("2.5", 2.5),
        ] {
            assert_eq!(parse_coordinate(word.as_bytes(), "x").unwrap(), value);
        }
        for bad in ["x", "", "1.2.3", "nan(", "nan()x", "banan(1)"] {
            assert!(parse_coordinate(bad.as_bytes(), "x").is_err(), "{bad}");
        }
        for bad in ["", "-", "1.0", "99999999999999999999"] {
            assert!(parse_i64(bad.as_bytes(), "an index").is_err(), "{bad}");
        }
        assert_eq!(parse_i64(b"-12", "an index").unwrap(), -12);
        assert_eq!(parse_i64(b"-9223372036854775808", "an index").unwrap(), i64::MIN);
        assert!(parse_i64(b"9223372036854775808", "an index").is_err());
    }

    #[test]
    fn an_endless_line_is_refused_before_it_fills_memory() {
        let mut scanner = Scanner::new(std::io::repeat(0));
        assert!(scanner.next_line().unwrap_err().to_string().contains("longer than"));
        let mut scanner = Scanner::new(std::io::repeat(0));
        assert!(scanner.next_token().unwrap_err().to_string().contains("longer than"));
    }
}
