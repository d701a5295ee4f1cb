//! Sets of equal pixels of an image of labels.

use super::{NamedSet, PlanarSet};
use coface_algebra::Error;
use coface_arrange::boolean::InsideRule;
use coface_io::NumberTable;
use coface_yin::YinSet;
use std::collections::BTreeMap;

/// The most numbers that an image holds.
const MOST_PIXELS: usize = 1 << 28;

/// An image of labels: a number for each pixel, 0 for what is in no set.
///
/// Pixels are unit squares; the lower left corner of the image is the origin, rows go from the top down.
///
/// # Examples
/// Two pixels with the label 7 above one of them with the label 3.
/// ```
/// use coface_answers::LabelImage;
/// let image = LabelImage::read_pgm(b"P2 2 2 9\n7 7\n0 3\n")?;
/// let sets = image.sets()?;
/// assert_eq!(sets.iter().map(|one| one.name.as_str()).collect::<Vec<_>>(), ["3", "7"]);
/// assert_eq!(sets[1].set.bounding_box(), Some([[0.0, 1.0], [2.0, 2.0]]));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LabelImage {
    width: usize,
    labels: Vec<u32>,
}

impl LabelImage {
    /// An image of rows of this width, the highest row first.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) unless the labels are whole rows.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::LabelImage;
    /// assert_eq!(LabelImage::new(2, vec![1, 1, 0, 2])?.sets()?.len(), 2);
    /// assert!(LabelImage::new(2, vec![1, 1, 0]).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(width: usize, labels: Vec<u32>) -> Result<Self, Error> {
        if width == 0 || !labels.len().is_multiple_of(width) {
            return Err(Error::invalid(format!("{} labels are no rows of width {width}", labels.len()))
                .with_cure("give a label for each pixel of each row"));
        }
        Ok(Self { width, labels })
    }

    /// Reads a gray map of Netpbm, `P2` or `P5`; gray values are labels.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for another format, a damaged header and missing numbers.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # References
    /// The Netpbm manual, *PGM format specification*.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::LabelImage;
    /// let text = b"P5 # three pixels of a byte\n3 1 255\n\x01\x02\x02";
    /// assert_eq!(LabelImage::read_pgm(text)?, LabelImage::new(3, vec![1, 2, 2])?);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn read_pgm(bytes: &[u8]) -> Result<Self, Error> {
        let damaged = |what: &str| {
            Error::parse(format!("the image {what}")).with_cure("write it again, as a .pgm of type P2 or P5")
        };
        let mut words = Words { bytes, at: 0 };
        let is_binary = match words.next() {
            Some(b"P2") => false,
            Some(b"P5") => true,
            _ => return Err(damaged("does not begin with P2 or P5")),
        };
        let mut header = [0usize; 3];
        for number in &mut header {
            *number = words.number().ok_or_else(|| damaged("has no width, height and greatest value"))?;
        }
        let [width, height, greatest] = header;
        if width == 0 || height == 0 || !(1..=65_535).contains(&greatest) {
            return Err(damaged("has a width, a height or a greatest value that cannot be"));
        }
        let count = width.checked_mul(height).filter(|&count| count <= MOST_PIXELS);
        let count = count.ok_or_else(|| damaged("has more than 2^28 pixels"))?;
        let size = if greatest > 255 { 2 } else { 1 };
        let labels: Vec<u32> = if is_binary {
            // One blank ends the header.
            let data = bytes.get(words.at + 1..).unwrap_or_default();
            let data = data.get(..count * size).ok_or_else(|| damaged("ends before its last pixel"))?;
            let label = |pixel: &[u8]| pixel.iter().fold(0, |sum, byte| 256 * sum + u32::from(*byte));
            data.chunks_exact(size).map(label).collect()
        } else {
            // A file cannot make more room than its own length.
            let mut labels = Vec::with_capacity(count.min(bytes.len()));
            for _ in 0..count {
                let number = words.number().ok_or_else(|| damaged("ends before its last pixel"))?;
                labels.push(number as u32);
            }
            labels
        };
        if labels.iter().any(|&label| label as usize > greatest) {
            return Err(damaged("has a value above the greatest one"));
        }
        Self::new(width, labels)
    }

    /// The image of a table of labels, its first row the highest.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for rows of different lengths, and for a number that is no label,
    /// with its row and column.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::LabelImage;
    /// use coface_io::NumberTable;
    /// let table = NumberTable::from_rows([[1.0, 1.0], [0.0, 2.0]]);
    /// assert_eq!(LabelImage::of_table(&table)?, LabelImage::new(2, vec![1, 1, 0, 2])?);
    /// assert!(LabelImage::of_table(&NumberTable::from_rows([[0.5]])).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn of_table(table: &NumberTable) -> Result<Self, Error> {
        let width = if table.row_count() == 0 { 0 } else { table.row(0).len() };
        let mut labels = Vec::with_capacity(table.numbers().len());
        for row in 0..table.row_count() {
            let own = table.row(row);
            if own.len() != width {
                return Err(Error::invalid(format!("row {row} has {} labels, the first {width}", own.len()))
                    .with_cure("give rows of one length"));
            }
            for (column, &label) in own.iter().enumerate() {
                if !(label >= 0.0 && label <= f64::from(u32::MAX) && label.fract() == 0.0) {
                    let message = format!("row {row}, column {column} has {label}, which is no label");
                    return Err(Error::invalid(message).with_cure("give whole numbers from 0"));
                }
                labels.push(label as u32);
            }
        }
        Self::new(width, labels)
    }

    /// A set of order 2 for each label but 0, named by it, by rising labels. Pixels that touch in a corner are different components.
    ///
    /// # Errors
    /// Those of [`YinSet::from_rings`].
    ///
    /// # Complexity
    /// That of an overlay of the runs of each label along the rows.
    ///
    /// # Examples
    /// See [`LabelImage`].
    pub fn sets(&self) -> Result<Vec<NamedSet>, Error> {
        let height = self.labels.len() / self.width;
        let mut runs: BTreeMap<u32, Vec<[[f64; 2]; 4]>> = BTreeMap::new();
        for (row, labels) in self.labels.chunks_exact(self.width).enumerate() {
            let (low, high) = ((height - row - 1) as f64, (height - row) as f64);
            let mut start = 0;
            for run in labels.chunk_by(|a, b| a == b) {
                let (from, to) = (start as f64, (start + run.len()) as f64);
                start += run.len();
                if run[0] != 0 {
                    let ring = [[from, low], [to, low], [to, high], [from, high]];
                    runs.entry(run[0]).or_default().push(ring);
                }
            }
        }
        let set = |(label, rings): (u32, Vec<[[f64; 2]; 4]>)| {
            let set = YinSet::from_rings(&rings, InsideRule::Nonzero)?.straightened().canonical();
            Ok(NamedSet::new(label.to_string(), PlanarSet::from_set(set)))
        };
        runs.into_iter().map(set).collect()
    }
}

/// The words of a header, with comments left out.
struct Words<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Option<&'a [u8]> {
        loop {
            match self.bytes.get(self.at)? {
                b'#' => {
                    let rest = &self.bytes[self.at..];
                    self.at += rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
                }
                byte if byte.is_ascii_whitespace() => self.at += 1,
                _ => break,
            }
        }
        let rest = &self.bytes[self.at..];
        let ends = |byte: &u8| byte.is_ascii_whitespace() || *byte == b'#';
        let length = rest.iter().position(ends).unwrap_or(rest.len());
        self.at += length;
        Some(&rest[..length])
    }

    fn number(&mut self) -> Option<usize> {
        std::str::from_utf8(self.next()?).ok()?.parse().ok()
    }
}
