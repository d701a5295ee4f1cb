//! Volumes whose numbers are read where they are asked for, and copies for those that have to be read from the beginning.

use super::header::{Encoding, VolumeHeader, unreadable};
use super::npy;
use super::numbers::{Decode, NumberType, Values};
use super::stream::VolumeStream;
use crate::open_regular;
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cubical::CubicalVolume;
use std::cell::Cell;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};

/// A volume file whose numbers stand there as they are, so that any of them can be read without those before.
///
/// # Examples
/// ```
/// use coface_io::{Format, VolumeStream};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-volume-windows.pgm");
/// std::fs::write(&path, b"P5 3 2 255\n\x01\x02\x03\x04\x05\x06")?;
/// let mut windows = VolumeStream::open(&path, Format::Pgm)?.windows()?.expect("bytes can be read anywhere");
/// assert_eq!(windows.numbers(&[vec![1], vec![0, 2]])?, [4.0, 6.0]);
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct VolumeWindows {
    header: VolumeHeader,
    file: File,
    name: String,
    /// Where the numbers begin.
    first_byte: u64,
    remarks: Vec<Remark>,
}

/// The lengths of axes, the slowest first.
fn from_slowest<T: Copy>(list: &[T], is_first_fastest: bool) -> Vec<T> {
    let mut list = list.to_vec();
    if is_first_fastest {
        list.reverse();
    }
    list
}

impl VolumeWindows {
    pub(super) fn new(
        header: VolumeHeader,
        (file, name): (File, String),
        first_byte: u64,
        mut remarks: Vec<Remark>,
    ) -> Result<Self, Error> {
        let count: u64 = header.shape.iter().map(|&length| u64::from(length)).product();
        let end = first_byte + count * header.number_type.size() as u64;
        if file.metadata()?.len() > end {
            let message = format!("the file goes on behind the {count} numbers of shape {:?}", header.shape);
            remarks.push(Remark::new(RemarkCode::TrailingContent, message));
        }
        Ok(Self { header, file, name, first_byte, remarks })
    }

    /// What was assumed of the file.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, VolumeStream};
    /// let path = std::env::temp_dir().join("coface-volume-windows-remarks.pgm");
    /// std::fs::write(&path, b"P5 1 1 255\n\x01 and more")?;
    /// let windows = VolumeStream::open(&path, Format::Pgm)?.windows()?.expect("bytes can be read anywhere");
    /// assert_eq!(windows.remarks().len(), 1);
    /// # std::fs::remove_file(&path)?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The numbers at these places, as they are meant: for each axis, from the one that runs slowest in the file on, where they are along it. Those along the
    /// fastest axis come first.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is a list for each axis with places that it has; [`ErrorKind::Io`] where the file cannot be read.
    ///
    /// # Complexity
    /// Linear in the numbers, of which those that lie side by side along the fastest axis are read at once.
    ///
    /// # Examples
    /// See [`VolumeWindows`].
    pub fn numbers(&mut self, along: &[Vec<usize>]) -> Result<Vec<f64>, Error> {
        let shape = from_slowest(&self.header.shape, self.header.is_first_fastest);
        let fits = |(places, &length): (&Vec<usize>, &u32)| places.iter().all(|&at| at < length as usize);
        if along.len() != shape.len() || !along.iter().zip(&shape).all(fits) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("a window that does not lie in a volume of {shape:?} voxels"),
            )
            .with_cure("give places along each axis, the slowest axis first"));
        }
        let read = self.read(&shape, along);
        read.map_err(|error| error.in_file(self.name.clone()))
    }

    fn read(&mut self, shape: &[u32], along: &[Vec<usize>]) -> Result<Vec<f64>, Error> {
        let (outer, fastest) = along.split_at(along.len() - 1);
        // Neighbors along the fastest axis are read at once.
        let mut runs: Vec<(usize, usize)> = Vec::new();
        for &at in &fastest[0] {
            match runs.last_mut() {
                Some((start, count)) if *start + *count == at => *count += 1,
                _ => runs.push((at, 1)),
            }
        }
        let mut rows = vec![0u64];
        for (places, &length) in outer.iter().zip(shape) {
            let next = |&row: &u64| places.iter().map(move |&at| row * u64::from(length) + at as u64);
            rows = rows.iter().flat_map(next).collect();
        }
        let size = self.header.number_type.size();
        let length = u64::from(shape[shape.len() - 1]);
        let values =
            Values { number_type: self.header.number_type, scale: self.header.scale, rounded: Cell::new(0) };
        let mut numbers = Vec::with_capacity(rows.len() * fastest[0].len());
        let mut bytes = Vec::new();
        for row in rows {
            for &(start, count) in &runs {
                let place = (row * length + start as u64) * size as u64;
                self.file.seek(SeekFrom::Start(self.first_byte + place))?;
                bytes.resize(count * size, 0);
                self.file.read_exact(&mut bytes).map_err(|error| unreadable(&error))?;
                values.of_bytes(&bytes, self.header.is_big_endian, &mut numbers);
            }
        }
        Ok(numbers)
    }
}

impl VolumeStream<'_> {
    /// The same volume with numbers that are read where they are asked for; nothing if they are packed, text, or integers of 64 bits, whose roundings are counted.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] where the file cannot be opened a second time.
    ///
    /// # Examples
    /// See [`VolumeWindows`].
    pub fn windows(self) -> Result<Option<VolumeWindows>, Error> {
        let (header, first_byte, files, remarks) = self.into_places();
        let is_wide = matches!(header.number_type, NumberType::I64 | NumberType::U64);
        let (Some(first_byte), Some(path), Encoding::Raw, false) =
            (first_byte, files.last(), header.encoding, is_wide)
        else {
            return Ok(None);
        };
        let name = path.display().to_string();
        let in_file = |error: Error| error.in_file(name.clone());
        let file = open_regular(path).map_err(in_file)?;
        VolumeWindows::new(header, (file, name.clone()), first_byte, remarks).map(Some).map_err(in_file)
    }

    /// Copies the numbers, as they are meant, into an array of NumPy whose last axis is the one that runs fastest in the file; those of voxels that are not in a mask
    /// are no numbers. Gives remarks.
    ///
    /// # Errors
    /// Those of [`Self::numbers`]; [`ErrorKind::Shape`] for a mask of another shape; [`ErrorKind::Io`] where the copy cannot be written.
    ///
    /// # Complexity
    /// Linear in the file, of which some thousand numbers are held.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, VolumeStream};
    /// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 3 1\nencoding: ascii\n\n1 0.5 -2";
    /// let mut copy = Vec::new();
    /// VolumeStream::new(&text[..], Format::Nrrd)?.copy(&mut copy, None)?;
    /// let copied = VolumeStream::new(&copy[..], Format::Npy)?;
    /// assert_eq!(copied.shape(), [1, 3]);
    /// assert_eq!(copied.numbers()?.0, [1.0, 0.5, -2.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn copy(self, out: &mut impl Write, mask: Option<&CubicalVolume>) -> Result<Vec<Remark>, Error> {
        let shape = self.shape().to_vec();
        if let Some(mask) = mask.filter(|mask| mask.shape() != shape) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("the mask has the shape {:?}, and the image {shape:?}", mask.shape()),
            )
            .with_cure("give a mask of the shape of the image"));
        }
        let fastest = self.fastest_axis();
        let lengths: Vec<usize> = from_slowest(&shape, shape.len() > 1 && fastest == 0)
            .into_iter()
            .map(|length| length as usize)
            .collect();
        let is_single = self.has_single_numbers();
        npy::write_header(&lengths, if is_single { "<f4" } else { "<f8" }, out)?;
        let mut bytes = Vec::new();
        self.for_each_number(|first, run| {
            bytes.clear();
            let mut voxel = first.to_vec();
            for &number in run {
                let is_in = mask.is_none_or(|mask| mask.is_set(&voxel));
                let number = if is_in { number } else { f64::NAN };
                voxel[fastest] += 1;
                if is_single {
                    bytes.extend_from_slice(&(number as f32).to_le_bytes());
                } else {
                    bytes.extend_from_slice(&number.to_le_bytes());
                }
            }
            Ok(out.write_all(&bytes)?)
        })
    }
}
