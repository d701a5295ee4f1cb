//! Volume files read voxel by voxel.

use super::frame::VoxelFrame;
use super::header::{Encoding, Skip, VolumeHeader, unreadable, up_to};
use super::numbers::{Decode, Test, Values, Words};
use super::rule::{VolumeReading, VoxelRule};
use super::{metaimage, nifti, npy, nrrd, pgm};
use crate::Format;
use crate::counted_stream::{name_of, open, reading};
use crate::features::{GZIP, gunzipped, inflated};
use crate::files::Companions;
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cubical::{CubicalVolume, VoxelBoxes, VoxelWindow};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};

/// No more numbers than this are held at once.
const CHUNK: usize = 1 << 14;

/// What is called with the first voxel of a run and what became of the numbers of the run.
type Visit<'v, T> = dyn FnMut(&[u32], &[T]) -> Result<(), Error> + 'v;

/// A volume file whose header has been read, and whose numbers have not.
///
/// # Examples
/// ```
/// use coface_io::{Format, VolumeReading, VolumeStream};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 3 3\nencoding: ascii\n\n1 1 1  1 0 1  1 1 nan";
/// let stream = VolumeStream::new(&text[..], Format::Nrrd)?;
/// assert_eq!(stream.shape(), [3, 3]);
/// let (volume, _) = stream.read(&VolumeReading::default())?;
/// assert!(volume.is_set(&[0, 2]) && !volume.is_set(&[1, 1]) && !volume.is_set(&[2, 2]));
/// # Ok(()) }
/// ```
pub struct VolumeStream<'r> {
    header: VolumeHeader,
    input: Box<dyn Read + 'r>,
    /// Where the input begins in its file; `None` for what is unpacked.
    first_byte: Option<u64>,
    /// The file of the numbers.
    name: Option<String>,
    files: Vec<PathBuf>,
    /// What was assumed of the numbers.
    remarks: Vec<Remark>,
}

impl std::fmt::Debug for VolumeStream<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("VolumeStream")
            .field("header", &self.header)
            .field("files", &self.files)
            .finish_non_exhaustive()
    }
}

impl VolumeStream<'static> {
    /// Opens a file of this format, or the one that its name and content tell; of `.hdr` and `.img`, and of `.nhdr`,
    /// the other file too, which lies in the folder of the first or below.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] where a file cannot be read; [`ErrorKind::UnsupportedFormat`] for what is no volume, or one of numbers that are not
    /// read; [`ErrorKind::Parse`] for a damaged header, and one that says more numbers than the file has. All name the file.
    pub fn open(path: &Path, format: Format) -> Result<Self, Error> {
        Self::open_with(path, format, false)
    }

    /// Opens a file as [`open`](Self::open) does; with `allow_outside` the other file may lie outside the folder of
    /// the header.
    ///
    /// # Errors
    /// As of [`open`](Self::open).
    pub fn open_with(path: &Path, format: Format, allow_outside: bool) -> Result<Self, Error> {
        let path = header_path(path);
        let opened = Self::open_here(&path, format, allow_outside);
        let mut stream = opened.map_err(|error| error.in_file(path.display().to_string()))?;
        stream.files.insert(0, path);
        Ok(stream)
    }

    fn open_here(path: &Path, format: Format, allow_outside: bool) -> Result<Self, Error> {
        let file = open(path)?;
        let size = file.metadata().ok().filter(|metadata| metadata.is_file()).map(|metadata| metadata.len());
        let file = reading(&name_of(path), file, size.unwrap_or(0));
        let begun = begin(Box::new(BufReader::with_capacity(1 << 18, file)), format)?;
        let Some(data_file) = begun.header.data_file.clone() else {
            let left = begun.first_byte.and_then(|first| size?.checked_sub(first));
            return Self::positioned(begun, left, None);
        };
        let data_file = match format {
            Format::Nifti => image_path(path).file_name().map(PathBuf::from).unwrap_or_default(),
            _ => data_file,
        };
        let companions = Companions::of(path, allow_outside);
        let data_path = companions.path(&data_file);
        let name = data_path.display().to_string();
        let in_data = |error: Error| error.in_file(name.clone());
        let file = companions.open(&data_file).map_err(in_data)?;
        let size = file.metadata().ok().filter(|metadata| metadata.is_file()).map(|metadata| metadata.len());
        let mut file = reading(&name_of(&data_path), file, size.unwrap_or(0));
        let start = up_to(&mut file, 2).map_err(in_data)?;
        let is_packed = format == Format::Nifti && start == GZIP;
        let input = BufReader::with_capacity(1 << 18, std::io::Cursor::new(start).chain(file));
        if is_packed {
            let unpacked = Box::new(BufReader::with_capacity(1 << 18, gunzipped(input)?));
            let begun = Begun { input: unpacked, first_byte: None, ..begun };
            let mut stream = Self::positioned(begun, None, Some(name))?;
            stream.files.push(data_path);
            return Ok(stream);
        }
        let begun = Begun { input: Box::new(input), first_byte: Some(0), ..begun };
        let mut stream = Self::positioned(begun, size, Some(name))?;
        stream.files.push(data_path);
        Ok(stream)
    }
}

impl<'r> VolumeStream<'r> {
    /// Reads the header of a stream.
    ///
    /// # Errors
    /// As [`Self::open`]; [`ErrorKind::InvalidInput`] where the numbers are in another file.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, VolumeStream};
    /// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 3 2\nencoding: ascii\n\n1 1 1  1 0 1";
    /// let stream = VolumeStream::new(&text[..], Format::Nrrd)?;
    /// assert_eq!(stream.shape(), [3, 2]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(input: impl Read + 'r, format: Format) -> Result<Self, Error> {
        let begun = begin(Box::new(input), format)?;
        if let Some(file) = &begun.header.data_file {
            let what = if file.as_os_str().is_empty() {
                "an .img file".to_owned()
            } else {
                file.display().to_string()
            };
            return Err(Error::invalid(format!("the numbers are in {what}, not behind the header"))
                .with_cure("give the path of the header, beside which the other file lies"));
        }
        Self::positioned(begun, None, None)
    }

    /// The same, once what comes before the numbers is skipped.
    fn positioned(begun: Begun<'r>, mut size: Option<u64>, name: Option<String>) -> Result<Self, Error> {
        let Begun { header, mut input, mut first_byte, remarks } = begun;
        let in_data = |error: Error| match &name {
            Some(name) => error.in_file(name.clone()),
            None => error,
        };
        let needed = header
            .shape
            .iter()
            .try_fold(header.number_type.size() as u64, |bytes, &length| bytes.checked_mul(length.into()));
        let Some(needed) = needed else {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("an array of shape {:?} has no size", header.shape),
            )
            .with_cure("the header is damaged: write the file again"));
        };
        let (lines, bytes) = match header.skip {
            Skip::Ahead { lines, bytes } => (lines, bytes),
            Skip::FromEnd => {
                let size = size.ok_or_else(|| {
                    Error::invalid("the numbers begin so many bytes before the end, but the end is not known")
                        .with_cure("give the file by its path")
                })?;
                (0, size.saturating_sub(needed))
            }
        };
        let skipped = skip_lines(&mut input, lines).map_err(in_data)?;
        if let Encoding::Gzip | Encoding::Zlib = header.encoding {
            let unpacked = if header.encoding == Encoding::Gzip { gunzipped(input) } else { inflated(input) };
            input = Box::new(BufReader::with_capacity(1 << 18, unpacked?));
            (size, first_byte) = (None, None);
        }
        let passed = std::io::copy(&mut input.by_ref().take(bytes), &mut std::io::sink());
        let passed = passed.map_err(|error| in_data(unreadable(&error)))?;
        first_byte = first_byte.map(|first| first + skipped + passed);
        size = size.map(|size| size.saturating_sub(skipped + passed));
        if header.encoding == Encoding::Raw
            && let Some(size) = size.filter(|&size| size < needed)
        {
            return Err(in_data(
                Error::parse(format!(
                    "the header says an array of shape {:?}, {needed} bytes, but {size} bytes are left for it",
                    header.shape
                ))
                .at_byte(first_byte.unwrap_or(0))
                .with_cure("the file is cut short or its header damaged: copy or write it again"),
            ));
        }
        Ok(Self { header, input, first_byte, name, files: Vec::new(), remarks })
    }

    /// The number of voxels along each axis of the file.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, VolumeStream};
    /// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 3 2\nencoding: ascii\n\n1 1 1  1 0 1";
    /// let stream = VolumeStream::new(&text[..], Format::Nrrd)?;
    /// assert_eq!(stream.shape(), [3, 2]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn shape(&self) -> &[u32] {
        &self.header.shape
    }

    /// The files that are read: that of the header, and that of the numbers if it is another; none for a stream without a name.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, VolumeStream};
    /// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 3 2\nencoding: ascii\n\n1 1 1  1 0 1";
    /// let stream = VolumeStream::new(&text[..], Format::Nrrd)?;
    /// assert!(stream.files().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// Where voxels are, if the header says it and there are three axes.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, VolumeStream};
    /// let text = b"NRRD0004\ntype: double\ndimension: 3\nsizes: 1 1 1\nspacings: 2 2 2\nencoding: ascii\n\n1";
    /// assert!(VolumeStream::new(&text[..], Format::Nrrd)?.frame().is_some());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn frame(&self) -> Option<VoxelFrame> {
        self.header.frame.filter(|_| self.header.shape.len() == 3)
    }

    /// The axis that runs fastest in the file: the last one or the first.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, VolumeStream};
    /// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 3 2\nencoding: ascii\n\n1 1 1  1 0 1";
    /// let stream = VolumeStream::new(&text[..], Format::Nrrd)?;
    /// assert_eq!(stream.fastest_axis(), 0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn fastest_axis(&self) -> usize {
        if self.header.is_first_fastest { 0 } else { self.header.shape.len() - 1 }
    }

    /// Goes through all voxels in the order of the file: calls with the first voxel of a run along [`Self::fastest_axis`] and which voxels of
    /// the run are set. Gives remarks.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] and [`ErrorKind::Parse`] where numbers cannot be read, or end too early; what `visit` says.
    ///
    /// # Complexity
    /// Linear in the file; some thousand numbers are held.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, VolumeStream, VoxelRule};
    /// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 3 2\nencoding: ascii\n\n1 1 1  1 0 1";
    /// let stream = VolumeStream::new(&text[..], Format::Nrrd)?;
    /// let mut set = 0;
    /// stream.for_each_run(VoxelRule::default(), |_, run| {
    ///     set += run.iter().filter(|&&is_set| is_set).count();
    ///     Ok(())
    /// })?;
    /// assert_eq!(set, 5);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn for_each_run(
        self,
        rule: VoxelRule,
        mut visit: impl FnMut(&[u32], &[bool]) -> Result<(), Error>,
    ) -> Result<Vec<Remark>, Error> {
        rule.check()?;
        let name = self.name.clone();
        let test = Test::new(rule, self.header.number_type, self.header.scale);
        self.runs(&test, &mut visit).map_err(|error| match name {
            Some(name) if error.kind() != ErrorKind::InvalidInput => error.in_file(name),
            _ => error,
        })
    }

    /// Reads the numbers in the order of the file, as they are meant (scaled where the header says so). Gives remarks too.
    ///
    /// # Errors
    /// Those of [`Self::for_each_run`].
    ///
    /// # Complexity
    /// Linear in the file; 8 bytes a voxel are held.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, VolumeStream};
    /// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 3 1\nencoding: ascii\n\n1 0.5 -2";
    /// let stream = VolumeStream::new(&text[..], Format::Nrrd)?;
    /// assert_eq!(stream.numbers()?.0, [1.0, 0.5, -2.0]);
    /// // The first has no double: that is said.
    /// let text = b"NRRD0004\ntype: int64\ndimension: 2\nsizes: 2 1\nencoding: ascii\n\n9007199254740993 9007199254740992";
    /// let (numbers, remarks) = VolumeStream::new(&text[..], Format::Nrrd)?.numbers()?;
    /// assert_eq!((numbers, remarks[0].count), (vec![9007199254740992.0; 2], 1));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn numbers(self) -> Result<(Vec<f64>, Vec<Remark>), Error> {
        // Grown as numbers come: what the header says may be a lie.
        let mut numbers = Vec::new();
        let remarks = self.for_each_number(|_, run| {
            numbers.extend_from_slice(run);
            Ok(())
        })?;
        Ok((numbers, remarks))
    }

    /// Goes through all numbers in the order of the file: calls with the first voxel of a run along [`Self::fastest_axis`] and the numbers of the run, as they are
    /// meant. Gives remarks.
    ///
    /// # Errors
    /// Those of [`Self::for_each_run`].
    ///
    /// # Complexity
    /// Linear in the file; some thousand numbers are held.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, VolumeStream};
    /// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 2 2\nencoding: ascii\n\n1 0.5 -2 4";
    /// let mut sums = Vec::new();
    /// VolumeStream::new(&text[..], Format::Nrrd)?.for_each_number(|_, run| {
    ///     sums.push(run.iter().sum::<f64>());
    ///     Ok(())
    /// })?;
    /// assert_eq!(sums, [1.5, 2.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn for_each_number(
        self,
        mut visit: impl FnMut(&[u32], &[f64]) -> Result<(), Error>,
    ) -> Result<Vec<Remark>, Error> {
        let name = self.name.clone();
        let values =
            Values { number_type: self.header.number_type, scale: self.header.scale, rounded: Cell::new(0) };
        let mut remarks = self.runs(&values, &mut visit).map_err(|error| match name {
            Some(name) => error.in_file(name),
            None => error,
        })?;
        let rounded = values.rounded.get() as usize;
        if rounded > 0 {
            let message = match rounded {
                1 => "1 integer beyond 2^53 is rounded to the nearest double".to_owned(),
                count => format!("{count} integers beyond 2^53 are rounded to the nearest doubles"),
            };
            remarks.push(Remark::new(RemarkCode::NumbersRounded, message).at(rounded, []));
        }
        Ok(remarks)
    }

    /// Whether each number is one of 32 bits.
    pub(super) fn has_single_numbers(&self) -> bool {
        self.header.scale.is_none() && self.header.number_type.is_single()
    }

    /// The header, where numbers begin, the files and the remarks.
    pub(super) fn into_places(self) -> (VolumeHeader, Option<u64>, Vec<PathBuf>, Vec<Remark>) {
        (self.header, self.first_byte, self.files, self.remarks)
    }

    fn runs<D: Decode>(self, decode: &D, visit: &mut Visit<'_, D::Item>) -> Result<Vec<Remark>, Error> {
        let fastest = self.fastest_axis();
        let VolumeHeader { shape, is_first_fastest, number_type, is_big_endian, encoding, .. } = self.header;
        let total: u128 = shape.iter().map(|&length| u128::from(length)).product();
        let mut numbers = match encoding {
            Encoding::Ascii => Numbers::Words(Words::new(self.input)),
            _ => Numbers::Bytes {
                input: self.input,
                size: number_type.size(),
                is_big_endian,
                buffer: Vec::new(),
            },
        };
        // The axes but the fastest, the next fastest last.
        let mut outer: Vec<usize> = (0..shape.len()).filter(|&axis| axis != fastest).collect();
        if is_first_fastest {
            outer.reverse();
        }
        let mut voxel = vec![0u32; shape.len()];
        let mut items = Vec::with_capacity(CHUNK.min(shape[fastest] as usize));
        let mut done: u128 = 0;
        loop {
            voxel[fastest] = 0;
            while voxel[fastest] < shape[fastest] {
                let count = (shape[fastest] - voxel[fastest]).min(CHUNK as u32);
                items.clear();
                numbers.read(count as usize, decode, &mut items).map_err(|fault| match fault {
                    Fault::Error(error) => error,
                    Fault::End(early) => {
                        let error = Error::parse(format!(
                            "the numbers end after {} of {total}, those of shape {shape:?}",
                            done + early as u128
                        ));
                        let error =
                            error.with_cure("the file is cut short or its header damaged: write it again");
                        match self.first_byte {
                            Some(first) if encoding == Encoding::Raw => error
                                .at_byte(first + (done as u64 + early as u64) * number_type.size() as u64),
                            _ => error,
                        }
                    }
                })?;
                visit(&voxel, &items)?;
                voxel[fastest] += count;
                done += u128::from(count);
            }
            let next = outer.iter().rev().find(|&&axis| {
                voxel[axis] += 1;
                let fits = voxel[axis] < shape[axis];
                if !fits {
                    voxel[axis] = 0;
                }
                fits
            });
            if next.is_none() {
                break;
            }
        }
        let mut remarks = self.remarks;
        if numbers.goes_on()? {
            let message = format!("the file goes on behind the {total} numbers of shape {shape:?}");
            remarks.push(Remark::new(RemarkCode::TrailingContent, message));
        }
        Ok(remarks)
    }

    /// Reads the whole volume: its axes are those of the file. Gives remarks too.
    ///
    /// # Errors
    /// Those of [`Self::for_each_run`]; [`ErrorKind::InvalidInput`] for a periodic axis that there is not; [`ErrorKind::TooLarge`] beyond
    /// 2^63 places of cells.
    ///
    /// # Complexity
    /// Linear in the file; two bits a voxel are held.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, VolumeReading, VolumeStream};
    /// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 3 2\nencoding: ascii\n\n1 1 1  1 0 1";
    /// let stream = VolumeStream::new(&text[..], Format::Nrrd)?;
    /// let (volume, _) = stream.read(&VolumeReading::default())?;
    /// assert!(volume.is_set(&[0, 0]) && !volume.is_set(&[1, 1]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn read(self, how: &VolumeReading) -> Result<(CubicalVolume, Vec<Remark>), Error> {
        let shape = self.header.shape.clone();
        let is_first_fastest = self.header.is_first_fastest;
        let is_periodic = how.periodic_axes(shape.len())?;
        // Grown as numbers come: what the header says may be a lie.
        let (mut words, mut word, mut count) = (Vec::new(), 0u64, 0usize);
        let remarks = self.for_each_run(how.rule, |_, is_set| {
            for &is_set in is_set {
                word |= u64::from(is_set) << (count % 64);
                count += 1;
                if count % 64 == 0 {
                    words.push(std::mem::take(&mut word));
                }
            }
            Ok(())
        })?;
        if count % 64 != 0 {
            words.push(word);
        }
        let volume = if is_first_fastest {
            CubicalVolume::from_words_first_fastest(&shape, &is_periodic, &words)?
        } else {
            CubicalVolume::from_words(&shape, &is_periodic, words)?
        };
        Ok((volume, remarks))
    }

    /// Reads the volume into windows of the boxes that it is cut into, each given as soon as it is complete. Every box is given once, with its
    /// number. Gives remarks.
    ///
    /// # Errors
    /// Those of [`Self::for_each_run`]; [`ErrorKind::Shape`] for boxes of a volume of another shape; what `give` says.
    ///
    /// # Complexity
    /// Linear in the file, times the boxes that a voxel is in or beside. The windows that a slab meets are held, a bit a voxel.
    pub fn for_each_window(
        self,
        rule: VoxelRule,
        boxes: &VoxelBoxes,
        mut give: impl FnMut(u32, VoxelWindow) -> Result<(), Error>,
    ) -> Result<Vec<Remark>, Error> {
        if boxes.shape() != self.shape() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("boxes of a volume of shape {:?} for one of shape {:?}", boxes.shape(), self.shape()),
            ));
        }
        let slowest = if self.header.is_first_fastest { self.header.shape.len() - 1 } else { 0 };
        let mut windows = OpenWindows::new(boxes, self.fastest_axis(), slowest)?;
        let remarks = self.for_each_run(rule, |voxel, is_set| {
            windows.advance(voxel[slowest], &mut give)?;
            windows.insert(voxel, is_set)
        })?;
        windows.advance(u32::MAX, &mut give)?;
        Ok(remarks)
    }
}

/// The windows of boxes that have been begun and are not complete.
struct OpenWindows<'b> {
    boxes: &'b VoxelBoxes,
    fastest: usize,
    /// For each axis, for each box along it, where its window begins and how many voxels it has.
    spans: Vec<Vec<(u32, u32)>>,
    /// The boxes by the voxel along the slowest axis with which they are complete.
    ends: Vec<(u32, u32)>,
    given: usize,
    open: BTreeMap<u32, VoxelWindow>,
    chosen: Vec<u32>,
}

impl<'b> OpenWindows<'b> {
    fn new(boxes: &'b VoxelBoxes, fastest: usize, slowest: usize) -> Result<Self, Error> {
        let axis_count = boxes.shape().len();
        let mut spans = Vec::new();
        for axis in 0..axis_count {
            let stride: u32 = boxes.counts()[axis + 1..].iter().product();
            let along = (0..boxes.counts()[axis]).map(|at| boxes.window_along(axis, at * stride));
            spans.push(along.collect::<Vec<_>>());
        }
        let slow = boxes.shape()[slowest];
        let mut ends: Vec<(u32, u32)> = (0..boxes.count())
            .map(|number| {
                let (start, length) = boxes.window_along(slowest, number);
                let end = u64::from(start) + u64::from(length) - 1;
                (end.min(u64::from(slow) - 1) as u32, number)
            })
            .collect();
        ends.sort_unstable();
        Ok(Self { boxes, fastest, spans, ends, given: 0, open: BTreeMap::new(), chosen: Vec::new() })
    }

    /// Gives what is complete before this voxel along the slowest axis.
    fn advance(
        &mut self,
        slow: u32,
        give: &mut impl FnMut(u32, VoxelWindow) -> Result<(), Error>,
    ) -> Result<(), Error> {
        while let Some(&(end, number)) = self.ends.get(self.given).filter(|(end, _)| *end < slow) {
            debug_assert!(end < slow, "a window is given when its last slab has come");
            let window = match self.open.remove(&number) {
                Some(window) => window,
                None => self.empty(number)?,
            };
            self.given += 1;
            give(number, window)?;
        }
        Ok(())
    }

    fn empty(&self, number: u32) -> Result<VoxelWindow, Error> {
        VoxelWindow::empty(self.boxes.shape(), self.boxes.is_periodic(), &self.boxes.voxels(number))
    }

    fn insert(&mut self, voxel: &[u32], is_set: &[bool]) -> Result<(), Error> {
        if !is_set.contains(&true) {
            return Ok(());
        }
        // The boxes along each axis whose windows the run meets.
        let mut chosen = std::mem::take(&mut self.chosen);
        chosen.clear();
        chosen.push(0);
        for (axis, spans) in self.spans.iter().enumerate() {
            let length = self.boxes.shape()[axis];
            let run = if axis == self.fastest { is_set.len() as u32 } else { 1 };
            let before = chosen.len();
            for (at, &(start, count)) in spans.iter().enumerate() {
                if meets(start, count, length, voxel[axis], run) {
                    for i in 0..before {
                        chosen.push(chosen[i] * spans.len() as u32 + at as u32);
                    }
                }
            }
            chosen.drain(..before);
        }
        for &number in &chosen {
            if !self.open.contains_key(&number) {
                let window = self.empty(number)?;
                self.open.insert(number, window);
            }
            let window = self.open.get_mut(&number).expect("the window was put in");
            window.insert_run(voxel, self.fastest, is_set);
        }
        self.chosen = chosen;
        Ok(())
    }
}

/// Whether `count` voxels from `start` on, around the end of an axis, meet `run` voxels from `first` on.
fn meets(start: u32, count: u32, length: u32, first: u32, run: u32) -> bool {
    let (start, count, length) = (u64::from(start), u64::from(count), u64::from(length));
    let (first, end) = (u64::from(first), u64::from(first) + u64::from(run));
    start < end && first < start + count || first + length < start + count
}

enum Fault {
    Error(Error),
    /// The stream ended after so many numbers.
    End(usize),
}

enum Numbers<'r> {
    Words(Words<Box<dyn Read + 'r>>),
    Bytes { input: Box<dyn Read + 'r>, size: usize, is_big_endian: bool, buffer: Vec<u8> },
}

impl Numbers<'_> {
    /// Decodes the next numbers.
    fn read<D: Decode>(&mut self, count: usize, decode: &D, out: &mut Vec<D::Item>) -> Result<(), Fault> {
        match self {
            Self::Words(words) => {
                for done in 0..count {
                    let word = words.next().map_err(Fault::Error)?.ok_or(Fault::End(done))?;
                    out.push(decode.of_word(word).map_err(Fault::Error)?);
                }
            }
            Self::Bytes { input, size, is_big_endian, buffer } => {
                buffer.clear();
                let wanted = count * *size;
                let read = input.by_ref().take(wanted as u64).read_to_end(buffer);
                read.map_err(|error| Fault::Error(unreadable(&error)))?;
                if buffer.len() < wanted {
                    return Err(Fault::End(buffer.len() / *size));
                }
                decode.of_bytes(buffer, *is_big_endian, out);
            }
        }
        Ok(())
    }

    fn goes_on(&mut self) -> Result<bool, Error> {
        match self {
            Self::Words(words) => Ok(words.next()?.is_some()),
            Self::Bytes { input, .. } => {
                let mut rest = Vec::new();
                input.by_ref().take(1).read_to_end(&mut rest).map_err(|error| unreadable(&error))?;
                Ok(!rest.is_empty())
            }
        }
    }
}

/// A file whose header has been read.
struct Begun<'r> {
    header: VolumeHeader,
    /// What comes behind it.
    input: Box<dyn Read + 'r>,
    /// At which byte of the file that is; `None` for what is unpacked.
    first_byte: Option<u64>,
    remarks: Vec<Remark>,
}

/// Reads the header.
fn begin<'r>(mut input: Box<dyn Read + 'r>, format: Format) -> Result<Begun<'r>, Error> {
    let mut is_packed = false;
    if format == Format::Nifti {
        let start = up_to(&mut input, 2)?;
        is_packed = start == GZIP;
        input = Box::new(std::io::Cursor::new(start).chain(input));
        if is_packed {
            input = Box::new(BufReader::with_capacity(1 << 18, gunzipped(input)?));
        }
    }
    let header = match format {
        Format::Npy => npy::read_header(&mut input)?,
        Format::Nrrd => nrrd::read_header(&mut input)?,
        Format::MetaImage => metaimage::read_header(&mut input)?,
        Format::Pgm => pgm::read_header(&mut input)?,
        Format::Png => return begin_png(&mut input),
        Format::Nifti => {
            let (mut header, is_single) = nifti::read_header(&mut input)?;
            if !is_single {
                header.data_file = Some(PathBuf::new());
            }
            header
        }
        _ => {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                format!("{} holds no volume", format.title()),
            )
            .with_cure("give a volume as .npy, NRRD, NIfTI, MetaImage, PGM or PNG"));
        }
    };
    let first_byte = (!is_packed).then_some(header.length);
    Ok(Begun { header, input, first_byte, remarks: Vec::new() })
}

#[cfg(feature = "images")]
fn begin_png<'r>(input: &mut impl Read) -> Result<Begun<'r>, Error> {
    let image = super::png::read(input)?;
    Ok(Begun {
        header: image.header,
        input: Box::new(image.numbers),
        first_byte: None,
        remarks: image.remarks,
    })
}

#[cfg(not(feature = "images"))]
fn begin_png<'r>(_input: &mut impl Read) -> Result<Begun<'r>, Error> {
    Err(crate::features::without_feature("PNG", "images"))
}

fn skip_lines(input: &mut impl Read, lines: u64) -> Result<u64, Error> {
    let (mut left, mut skipped, mut byte) = (lines, 0, [0]);
    while left > 0 {
        if input.read(&mut byte).map_err(|error| unreadable(&error))? == 0 {
            return Err(Error::parse(format!("the file has not the {lines} lines that are to be skipped")));
        }
        skipped += 1;
        left -= u64::from(byte[0] == b'\n');
    }
    Ok(skipped)
}

/// The header of a pair, of which either file may be named.
pub(crate) fn header_path(path: &Path) -> PathBuf {
    let name = path.file_name().map(|name| name.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    let stem = if name.ends_with(".img") {
        path.with_extension("")
    } else if name.ends_with(".img.gz") {
        path.with_extension("").with_extension("")
    } else {
        return path.to_owned();
    };
    let headers = ["hdr", "HDR", "hdr.gz"].map(|extension| with_added(&stem, extension));
    headers.into_iter().find(|path| path.is_file()).unwrap_or_else(|| path.to_owned())
}

/// The numbers of a pair.
fn image_path(header: &Path) -> PathBuf {
    let mut stem = header.with_extension("");
    if stem.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("hdr")) {
        stem = stem.with_extension("");
    }
    let [plain, upper, packed] = ["img", "IMG", "img.gz"].map(|extension| with_added(&stem, extension));
    if !plain.is_file() && upper.is_file() {
        upper
    } else if !plain.is_file() && packed.is_file() {
        packed
    } else {
        plain
    }
}

fn with_added(stem: &Path, extension: &str) -> PathBuf {
    let mut name = stem.as_os_str().to_owned();
    name.push(".");
    name.push(extension);
    PathBuf::from(name)
}
