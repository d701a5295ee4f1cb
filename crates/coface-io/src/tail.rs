//! The last line of a text: whether a file may have been cut within it.

use crate::{Remark, RemarkCode};
use std::io::{self, Read};

/// How much of the end is kept.
const KEPT: usize = 2048;
/// How many lines the last one is compared with, and how many of its form there must be.
const NEIGHBORS: usize = 8;
const LEAST: usize = 4;

/// A stream whose end is kept.
pub(crate) struct Tail<R> {
    input: R,
    end: Vec<u8>,
}

impl<R: Read> Tail<R> {
    pub(crate) fn new(input: R) -> Self {
        Self { input, end: Vec::new() }
    }

    /// What is said where the last line has no newline and is shorter than all lines of its form before it: `1 2 34` behind `1 2 333` may be
    /// a whole line of a file without a newline, or what is left of a longer one.
    pub(crate) fn remark(&self) -> Option<Remark> {
        let text = std::str::from_utf8(&self.end).ok()?;
        let mut lines = text.rsplit('\n');
        let is_comment =
            |line: &str| ["#", "//", "**", "%"].iter().any(|mark| line.trim_start().starts_with(mark));
        let last = lines.next().filter(|line| !line.trim().is_empty() && !is_comment(line))?;
        // The first of the lines may not be whole.
        let before: Vec<&str> = lines.take(NEIGHBORS + 1).collect();
        let whole = before.split_last().map_or(&[][..], |(_, whole)| whole);
        let alike: Vec<&str> = whole.iter().copied().filter(|line| form(line) == form(last)).collect();
        let is_shorter = alike.len() >= LEAST && alike.iter().all(|line| line.trim_end().len() > last.len());
        (is_shorter || lacks_words(last, whole)).then(|| {
            let shown: String = last.chars().take(60).collect();
            let message = format!(
                "the last line, \"{}\", has no newline and is shorter than those before it: the file may be cut there",
                shown.escape_debug()
            );
            Remark::new(RemarkCode::MissingEnd, message)
        })
    }
}

/// Whether a line has fewer words than all lines of its keyword before it, which have the same number: a face that lost a corner.
fn lacks_words(last: &str, before: &[&str]) -> bool {
    let (keyword, words) = form(last);
    let mut counts =
        before.iter().map(|line| form(line)).filter(|(own, _)| *own == keyword).map(|(_, count)| count);
    let Some(first) = counts.next().filter(|_| keyword.is_some()) else { return false };
    let others: Vec<usize> = counts.collect();
    words < first && others.len() + 1 >= LEAST && others.iter().all(|&count| count == first)
}

/// The keyword of a line, if it has one, and the number of its words.
fn form(line: &str) -> (Option<&str>, usize) {
    let keyword = line.split_whitespace().next().filter(|word| word.starts_with(|c: char| c.is_alphabetic()));
    (keyword, line.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty()).count())
}

impl<R: Read> Read for Tail<R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let count = self.input.read(bytes)?;
        let new = &bytes[count.saturating_sub(KEPT)..count];
        let excess = (self.end.len() + new.len()).saturating_sub(KEPT);
        self.end.drain(..excess.min(self.end.len()));
        self.end.extend_from_slice(new);
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Format, ReadOptions, RemarkCode, read, read_with};

    fn is_noticed(text: &str, format: Format) -> bool {
        let model = read(text.as_bytes(), format).unwrap();
        model.remarks().iter().any(|remark| remark.code == RemarkCode::MissingEnd)
    }

    #[test]
    fn a_number_cut_at_the_end_is_noticed() {
        let vertices = "v 0.25 0.5 1\n".repeat(20);
        let whole = vertices + &"f 11 12 13\n".repeat(10);
        assert!(!is_noticed(&whole, Format::Obj));
        assert!(!is_noticed(whole.trim_end(), Format::Obj), "a whole line without its newline");
        let cut = &whole[..whole.len() - 2];
        assert!(is_noticed(cut, Format::Obj), "f 11 12 1");
        assert!(!is_noticed(&format!("{cut}\n"), Format::Obj), "a shorter line with its newline");
        assert!(read_with(cut.as_bytes(), &ReadOptions::new().strict(true)).is_err());
    }

    #[test]
    fn a_corner_lost_at_the_end_is_noticed() {
        let vertices = (0..9).map(|i| format!("v {i} {} 0\n", i * i)).collect::<String>();
        let whole = vertices + &"f 1 2 3 4\n".repeat(6);
        assert!(!is_noticed(whole.trim_end(), Format::Obj));
        assert!(is_noticed(&whole[..whole.len() - 3], Format::Obj), "f 1 2 3");
        assert!(!is_noticed(&format!("{whole}f 1 2 3\n"), Format::Obj), "a triangle with its newline");
        let nodes = (1..9).map(|i| format!("{i}, {i}., {}., 0.\n", i * i)).collect::<String>();
        let abaqus = format!("*NODE\n{nodes}*ELEMENT, TYPE=S3\n1, 1, 2, 3\n");
        assert!(!is_noticed(&format!("{abaqus}** the end"), Format::Abaqus), "a comment");
        assert!(is_noticed(&format!("*NODE\n{nodes}*ELEMENT, TYPE=S3"), Format::Abaqus), "no element");
        assert!(
            is_noticed(&format!("{abaqus}*ELEMENT, TYPE=S4\n"), Format::Abaqus),
            "no element behind others"
        );
    }

    #[test]
    fn counts_do_not_hide_it() {
        let points = "0.5 0.25 0.75\n".repeat(200);
        let off = format!("OFF\n200 9 0\n{points}{}", "3 100 101 102\n".repeat(9));
        assert!(!is_noticed(off.trim_end(), Format::Off));
        assert!(is_noticed(&off[..off.len() - 2], Format::Off), "3 100 101 10");
        let lines = "0 0 1.5 1.25\n".repeat(9);
        assert!(is_noticed(&lines[..lines.len() - 2], Format::Lines));
        assert!(!is_noticed("0 0 1.5 1.5\n0 0 1 1", Format::Lines), "too few to tell");
    }

    #[test]
    fn long_lines_and_small_pieces_are_no_matter() {
        let text = format!("{}\n", "1 ".repeat(5000)).repeat(3);
        let mut tail = super::Tail::new(text.as_bytes());
        let mut piece = [0; 7];
        while std::io::Read::read(&mut tail, &mut piece).unwrap() > 0 {}
        assert!(tail.remark().is_none() && tail.end.len() <= super::KEPT);
    }
}
