//! A text in blocks of whole lines, parsed in parallel.
//!
//! The file is read forward once, a batch of blocks at a time. What stands in each block is counted first, so that
//! every block is parsed knowing its line and how many records stand before it; then the pieces are merged in the
//! order of the file. One batch is parsed while the next is read. Nothing depends on the number of threads.

use super::scanner::{LONGEST, Scanner};
use coface_algebra::{Error, ErrorKind};
use rayon::prelude::*;
use std::io::Read;

/// The usual length of a block in bytes; long enough to forget the cost of a task, short enough for a core's cache.
const BLOCK: usize = 1 << 18;

/// Some whole lines of a text.
#[derive(Debug, Default)]
pub(crate) struct Block {
    /// The lines; each ends with `\n`, the last one too.
    pub(crate) text: Vec<u8>,
    /// The number of the first line in the file, from 1.
    pub(crate) line: u64,
    /// The number of records in the file before this block, as the counting function counts them.
    pub(crate) record: u64,
}

/// Cuts a stream into blocks of whole lines.
pub(crate) struct Blocks<R> {
    input: R,
    /// Read, but not given out yet.
    rest: Vec<u8>,
    /// The line on which `rest` begins.
    line: u64,
    /// The byte of the stream at which `rest` begins, as long as lines are taken one by one.
    byte: u64,
    /// Whether a block may end behind this line, given without its end.
    may_end: fn(&[u8]) -> bool,
    finished: bool,
    /// Used texts, whose memory serves again.
    spare: Vec<Vec<u8>>,
}

impl<R: Read> Blocks<R> {
    pub(crate) fn new(input: R) -> Self {
        Self {
            input,
            rest: Vec::new(),
            line: 1,
            byte: 0,
            may_end: |_| true,
            finished: false,
            spare: Vec::new(),
        }
    }

    /// Blocks end only behind lines, given without their ends, for which this is true.
    pub(crate) fn ending_behind(mut self, may_end: fn(&[u8]) -> bool) -> Self {
        self.may_end = may_end;
        self
    }

    /// The first bytes that were not given out yet: `count` of them unless the stream ends before.
    pub(crate) fn peek(&mut self, count: usize) -> Result<&[u8], Error> {
        self.read_more(count)?;
        Ok(&self.rest[..count.min(self.rest.len())])
    }

    /// The next line, with its number and without its end; for headers. `None` at the end of the stream.
    pub(crate) fn next_line(&mut self) -> Result<Option<(Vec<u8>, u64)>, Error> {
        let mut searched = 0;
        let length = loop {
            if let Some(found) = memchr::memchr(b'\n', &self.rest[searched..]) {
                break searched + found + 1;
            }
            searched = self.rest.len();
            if searched >= LONGEST {
                return Err(self.too_long());
            }
            if !self.read_more(searched + (1 << 13))? {
                break searched;
            }
        };
        if length == 0 {
            return Ok(None);
        }
        let mut line: Vec<u8> = self.rest.drain(..length).collect();
        while matches!(line.last(), Some(b'\n' | b'\r')) {
            line.pop();
        }
        let number = self.line;
        self.line += 1;
        self.byte += length as u64;
        Ok(Some((line, number)))
    }

    /// Gives a line back that [`Self::next_line`] gave last.
    pub(crate) fn put_back(&mut self, line: &[u8]) {
        self.rest.splice(..0, line.iter().copied().chain([b'\n']));
        self.line -= 1;
    }

    /// The stream from here on, for other ways to read it.
    pub(crate) fn into_scanner(self) -> Scanner<impl Read> {
        Scanner::resumed(std::io::Cursor::new(self.rest).chain(self.input), self.line, self.byte)
    }

    /// Reads until `rest` has `wanted` bytes; false if the stream ended before anything was added.
    fn read_more(&mut self, wanted: usize) -> Result<bool, Error> {
        let before = self.rest.len();
        while self.rest.len() < wanted && !self.finished {
            let start = self.rest.len();
            self.rest.resize(wanted, 0);
            let count = match self.input.read(&mut self.rest[start..]) {
                Ok(count) => count,
                Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {
                    self.rest.truncate(start);
                    continue;
                }
                Err(error) => return Err(Error::from(error).at_line(self.line)),
            };
            self.rest.truncate(start + count);
            self.finished = count == 0;
        }
        Ok(self.rest.len() > before)
    }

    /// The next block, or `None` at the end of the stream.
    fn next_block(&mut self) -> Result<Option<Vec<u8>>, Error> {
        let mut wanted = BLOCK.max(self.rest.len());
        loop {
            self.read_more(wanted)?;
            if self.finished {
                if self.rest.is_empty() {
                    return Ok(None);
                }
                self.check_line_ends()?;
                let mut text = std::mem::take(&mut self.rest);
                if text.last() != Some(&b'\n') {
                    text.push(b'\n');
                }
                return Ok(Some(text));
            }
            if let Some(cut) = self.last_line_end() {
                let mut next = self.spare.pop().unwrap_or_default();
                next.clear();
                next.extend_from_slice(&self.rest[cut..]);
                self.rest.truncate(cut);
                return Ok(Some(std::mem::replace(&mut self.rest, next)));
            }
            self.check_line_ends()?;
            if self.rest.len() >= LONGEST {
                return Err(self.too_long());
            }
            wanted = self.rest.len() * 2;
        }
    }

    /// The position behind the last line end in `rest` at which a block may end.
    fn last_line_end(&self) -> Option<usize> {
        let mut end = memchr::memrchr(b'\n', &self.rest)?;
        loop {
            let before = memchr::memrchr(b'\n', &self.rest[..end]);
            let line = &self.rest[before.map_or(0, |found| found + 1)..end];
            if (self.may_end)(line.strip_suffix(b"\r").unwrap_or(line)) {
                return Some(end + 1);
            }
            end = before?;
        }
    }

    fn too_long(&self) -> Error {
        Error::parse(format!("a line or statement is longer than {LONGEST} bytes"))
            .at_line(self.line)
            .with_cure("this is not a text file of a format known here")
    }

    /// Refuses carriage returns as the only line ends, which would make the file one line.
    fn check_line_ends(&self) -> Result<(), Error> {
        let trimmed = self.rest.trim_ascii();
        if memchr::memchr(b'\n', &self.rest).is_none() && memchr::memchr(b'\r', trimmed).is_some() {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                "the lines end with carriage returns alone",
            )
            .at_line(self.line)
            .with_cure("convert the line ends to line feeds"));
        }
        Ok(())
    }

    /// The next blocks, up to `limit`, none if the stream has ended. What was read before a fault comes with it.
    fn next_batch(&mut self, limit: usize) -> (Vec<Block>, Result<(), Error>) {
        let mut batch = Vec::with_capacity(limit);
        while batch.len() < limit {
            match self.next_block() {
                Ok(Some(text)) => batch.push(Block { text, line: 0, record: 0 }),
                Ok(None) => break,
                Err(error) => return (batch, Err(error)),
            }
        }
        (batch, Ok(()))
    }

    /// Parses the rest of the stream: `count` the records of a text, `parse` each block, `merge` the pieces in order.
    ///
    /// The first fault in the order of the file is the one that is given.
    pub(crate) fn parse<T: Send>(
        mut self,
        count: impl Fn(&[u8]) -> u64 + Sync,
        parse: impl Fn(&Block) -> T + Sync,
        mut merge: impl FnMut(T) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let limit = 4 * rayon::current_num_threads();
        let mut record = 0;
        let mut pieces: Vec<Option<T>> = Vec::new();
        let (mut batch, mut fault) = self.next_batch(limit);
        while !batch.is_empty() {
            let counts: Vec<(u64, u64)> = batch
                .par_iter()
                .map(|block| (memchr::memchr_iter(b'\n', &block.text).count() as u64, count(&block.text)))
                .collect();
            for (block, (lines, records)) in batch.iter_mut().zip(counts) {
                (block.line, block.record) = (self.line, record);
                self.line += lines;
                record += records;
            }
            let mut new_pieces: Vec<Option<T>> = batch.iter().map(|_| None).collect();
            let mut merged = Ok(());
            // The caller's thread reads on and merges while the pool parses, so the stream need not be sent to it.
            let mut next = (Vec::new(), Ok(()));
            rayon::in_place_scope(|scope| {
                for (block, piece) in batch.iter().zip(&mut new_pieces) {
                    let parse = &parse;
                    scope.spawn(move |_| *piece = Some(parse(block)));
                }
                if fault.is_ok() {
                    next = self.next_batch(limit);
                }
                merged = pieces.drain(..).flatten().try_for_each(&mut merge);
            });
            merged?;
            pieces = new_pieces;
            self.spare.extend(batch.drain(..).map(|block| block.text));
            if fault.is_ok() {
                fault = next.1;
            }
            batch = next.0;
        }
        pieces.drain(..).flatten().try_for_each(merge)?;
        fault
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gives at most three bytes at a time.
    struct Trickle<'a>(&'a [u8]);

    impl Read for Trickle<'_> {
        fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
            let count = self.0.len().min(3).min(out.len());
            out[..count].copy_from_slice(&self.0[..count]);
            self.0 = &self.0[count..];
            Ok(count)
        }
    }

    type Collected = (Vec<u8>, Vec<(u64, u64)>);

    fn collect(blocks: Blocks<impl Read>) -> Result<Collected, Error> {
        let (mut text, mut places) = (Vec::new(), Vec::new());
        blocks.parse(
            |text| text.iter().filter(|&&byte| byte == b'v').count() as u64,
            |block| (block.text.clone(), (block.line, block.record)),
            |(piece, place)| {
                assert_eq!(piece.last(), Some(&b'\n'));
                text.extend(piece);
                places.push(place);
                Ok(())
            },
        )?;
        Ok((text, places))
    }

    #[test]
    fn blocks_are_the_text_and_know_their_place() {
        let line = b"v 1 2 3\nab\\\n";
        let mut file = line.repeat(200_000);
        file.extend_from_slice(b"\nend");
        let (text, places) =
            collect(Blocks::new(&file[..]).ending_behind(|line| line.last() != Some(&b'\\'))).unwrap();
        assert_eq!(text[..text.len() - 1], file[..]);
        assert!(places.len() > 5);
        for &(line, record) in &places[1..] {
            // A block begins with "ab", never behind the backslash.
            assert_eq!(line, 2 * record);
        }
        assert!(places[places.len() - 1].1 > 100_000);
    }

    #[test]
    fn headers_come_line_by_line_and_can_be_put_back() {
        let mut blocks = Blocks::new(Trickle(b"OFF\r\n3 1 0\n0 0 0"));
        assert_eq!(blocks.next_line().unwrap(), Some((b"OFF".to_vec(), 1)));
        assert_eq!(blocks.next_line().unwrap(), Some((b"3 1 0".to_vec(), 2)));
        let (last, number) = blocks.next_line().unwrap().unwrap();
        assert_eq!(number, 3);
        assert_eq!(blocks.next_line().unwrap(), None);
        blocks.put_back(&last);
        assert_eq!(collect(blocks).unwrap(), (b"0 0 0\n".to_vec(), vec![(3, 0)]));
    }

    #[test]
    fn text_without_line_ends_is_refused() {
        let error = collect(Blocks::new(std::io::repeat(b'x'))).unwrap_err();
        assert!(error.to_string().contains("longer than"), "{error}");
        let error = collect(Blocks::new(&b"v 0 0 0\rv 1 0 0\r"[..])).unwrap_err();
        assert!(error.to_string().contains("carriage returns"), "{error}");
    }

    #[test]
    fn the_first_fault_is_given() {
        let file = b"line\n".repeat(500_000);
        let result = Blocks::new(&file[..]).parse(
            |_| 1,
            |block| block.record,
            |record| if record >= 2 { Err(Error::parse(record.to_string())) } else { Ok(()) },
        );
        assert_eq!(result.unwrap_err().message(), "2");
    }
}
