//! The rows of lists of signatures, made as they are asked for.

use super::SignatureRow;
use coface_algebra::{Error, ErrorKind};
use coface_answers::SignatureRequest;
use coface_io::{SignatureLine, SignatureLines};
use rayon::prelude::*;
use std::collections::VecDeque;
use std::fmt;
use std::io::Read;
use std::path::PathBuf;

/// How many lines are looked at together.
const BLOCK: usize = 512;

/// Fewer lines than this are looked at in this thread.
const FEW: usize = 32;

/// The rows of a [`SignatureBatch`](super::SignatureBatch), in the order of the lines.
pub struct SignatureRows {
    pub(super) request: SignatureRequest,
    pub(super) jobs: usize,
    /// The lists that were not opened yet.
    pub(super) files: std::vec::IntoIter<PathBuf>,
    pub(super) open: Option<(String, SignatureLines<Box<dyn Read>>)>,
    pub(super) ready: VecDeque<SignatureRow>,
    pub(super) pool: Option<rayon::ThreadPool>,
}

impl fmt::Debug for SignatureRows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SignatureRows").field("request", &self.request).finish_non_exhaustive()
    }
}

impl SignatureRows {
    /// Makes the rows of the next block of lines ready.
    fn read_on(&mut self, path: String, mut lines: SignatureLines<Box<dyn Read>>) -> Result<(), Error> {
        let mut block = Vec::with_capacity(BLOCK);
        let mut fault = None;
        let mut is_over = false;
        while block.len() < BLOCK && !is_over {
            match lines.next() {
                Some(Ok(line)) => block.push(line),
                Some(Err(error)) => (fault, is_over) = (Some(error.in_file(path.clone())), true),
                None => is_over = true,
            }
        }
        let rows = self.rows_of(&path, block)?;
        self.ready.extend(rows);
        self.ready.extend(fault.map(|error| SignatureRow::of_file(&path, &error)));
        if !is_over {
            self.open = Some((path, lines));
        }
        Ok(())
    }

    /// The rows of a block of lines, on threads of their own if there are enough.
    fn rows_of(&mut self, path: &str, block: Vec<SignatureLine>) -> Result<Vec<SignatureRow>, Error> {
        let request = self.request;
        let row = |line: SignatureLine| SignatureRow::of_line(path, &line, request);
        if self.jobs < 2 || block.len() < FEW {
            return Ok(block.into_iter().map(row).collect());
        }
        let pool = match &mut self.pool {
            Some(pool) => pool,
            none => {
                let made = rayon::ThreadPoolBuilder::new().num_threads(self.jobs).build();
                none.insert(made.map_err(|error| {
                    Error::new(ErrorKind::Io, format!("cannot start {} threads: {error}", self.jobs))
                })?)
            }
        };
        Ok(pool.install(|| block.into_par_iter().map(row).collect()))
    }
}

impl Iterator for SignatureRows {
    type Item = Result<SignatureRow, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            if let Some(row) = self.ready.pop_front() {
                return Some(Ok(row));
            }
            if let Some((path, lines)) = self.open.take() {
                if let Err(error) = self.read_on(path, lines) {
                    return Some(Err(error));
                }
                continue;
            }
            let file = self.files.next()?;
            let path = file.to_string_lossy().into_owned();
            match SignatureLines::of_path(&file) {
                Ok(lines) => self.open = Some((path, lines)),
                Err(error) => return Some(Ok(SignatureRow::of_file(&path, &error))),
            }
        }
    }
}
