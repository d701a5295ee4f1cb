//! The lines of PLY as text: whether each record has its own.

use crate::Place;
use crate::oddities::{Oddities, Oddity};
use crate::scanner::Scanner;
use coface_algebra::Error;
use std::io::Read;

/// So many bytes are looked at to find out.
const SAMPLE: usize = 1 << 24;

/// How the records of a text lie on its lines.
///
/// The format has one record a line, but readers take words as they come, and so are files written that break records over lines or put
/// several on one. The two readings differ where a line goes on behind a record: there the rest of the line is either left out or the next
/// record. It is left out if the record has the line for itself and as many lines follow as records.
#[derive(Debug, Default)]
pub(super) struct Rows {
    /// Whether each record has a line of its own; `None` before the first line that goes on.
    pub(super) are_lines: Option<bool>,
    /// The line where the record begins.
    pub(super) start: u64,
    /// How many records follow behind those of the element that is read.
    pub(super) behind: u64,
    /// The lines that went on.
    pub(super) oddities: Oddities,
}

impl Rows {
    /// Ends a record behind which `left` more follow.
    pub(super) fn end_record<R: Read>(&mut self, scanner: &mut Scanner<R>, left: u64) -> Result<(), Error> {
        if self.are_lines == Some(false) || !scanner.line_goes_on()? {
            return Ok(());
        }
        let line = scanner.line_number();
        let are_lines = match self.are_lines {
            Some(known) => known,
            None => line == self.start && has_lines(scanner.available(SAMPLE)?, left),
        };
        self.are_lines = Some(are_lines);
        if are_lines {
            self.oddities.note(Oddity::MoreWords, || Place::line(line));
            scanner.next_line()?;
        }
        Ok(())
    }
}

/// Whether so many lines that are not blank follow behind the one that the text begins in. What is longer than the sample is taken to have
/// them.
fn has_lines(text: &[u8], count: u64) -> bool {
    let mut lines = text.split(|&byte| byte == b'\n').skip(1).filter(|line| !line.trim_ascii().is_empty());
    text.len() >= SAMPLE
        || usize::try_from(count).is_ok_and(|count| count == 0 || lines.nth(count - 1).is_some())
}
