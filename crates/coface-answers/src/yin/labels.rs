//! Sets of equal pixels of an image of labels.

use super::{NamedSet, PlanarSet};
use coface_algebra::{Error, ErrorKind};
use coface_arrange::boolean::InsideRule;
use coface_io::{Format, NumberTable, Remark, VolumeStream};
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
/// use coface_io::Format;
/// let (image, _) = LabelImage::read(b"P2 2 2 9\n7 7\n0 3\n", Format::Pgm)?;
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

    /// Reads an image, [`Format::Pgm`] or [`Format::Png`]; its numbers are labels. Gives remarks too: where pixels have colors, what was taken
    /// as their numbers.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for a damaged header and missing numbers;
    /// [`ErrorKind::UnsupportedFormat`] for another format; [`ErrorKind::TooLarge`] beyond 2^28 pixels.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # References
    /// The Netpbm manual, *PGM format specification*; W3C, *Portable Network Graphics (PNG) Specification*.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::LabelImage;
    /// use coface_io::Format;
    /// let text = b"P5 # three pixels of a byte\n3 1 255\n\x01\x02\x02";
    /// assert_eq!(LabelImage::read(text, Format::Pgm)?.0, LabelImage::new(3, vec![1, 2, 2])?);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn read(bytes: &[u8], format: Format) -> Result<(Self, Vec<Remark>), Error> {
        if !matches!(format, Format::Pgm | Format::Png) {
            let message = format!("{} is no format of images of labels", format.title());
            return Err(Error::new(ErrorKind::UnsupportedFormat, message).with_cure("give a .pgm or .png"));
        }
        let image = VolumeStream::new(bytes, format)?;
        let width = image.shape()[0] as usize;
        let count = image.shape().iter().map(|&length| length as usize).product::<usize>();
        if count > MOST_PIXELS {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("the image has {count} pixels, more than 2^28"),
            )
            .with_cure("give a smaller one"));
        }
        let (numbers, remarks) = image.numbers()?;
        Ok((Self::new(width, numbers.into_iter().map(|number| number as u32).collect())?, remarks))
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
    /// use coface_io::{Format, NumberTable, VolumeStream};
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
