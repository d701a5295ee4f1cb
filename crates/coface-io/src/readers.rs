//! Reading and writing models by path or stream, whatever the format.

use super::counted_stream::{CountedStream, name_of, open, reading};
use super::files::{Companions, replace_file};
use super::scratch_mesh::{self, ScratchMesh, ScratchStream};
use super::stream_start::{unpacked_start, without_mark};
use super::tail::Tail;
use super::{
    Format, Model, Remark, Structure, VolumeReading, VolumeStream, abaqus, amf, cityjson, collada,
    complex_reading, container, detection, geojson, gltf, isosig, json, lines_text, matrix_market, medit,
    msh, obj, off, parts, ply, points_text, stl, svg, tetgen, three_mf, volume, vtk, wkb, wkt, written, yin,
};
use crate::complex_reading::ComplexReading;
use crate::{ReferenceSystem, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use std::fs::File;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

/// What a stream without a name is called.
const STREAM: &str = "the input";

/// Reads the model in a file. Without a format, the name and the content decide it; when they disagree it is an error
/// that says how to settle it, unless the content is sure: then it decides, with a remark. [`Model::format`] then says which it was.
/// A compressed file (gzip, Zstandard, bzip2, xz) is unpacked; the name before its extension counts.
///
/// One model of several is chosen by its name, or its place from 1, after a `#`: an object of a list in JSON
/// (`facets.json#RP^3`), an isomorphism signature (`census.isosig#3`), or a group of the polygons of a mesh, such as an object of an OBJ or a
/// solid of an STL (`parts.stl#lid`).
///
/// # Errors
/// [`ErrorKind::Io`] when the file is missing, a directory or unreadable; [`ErrorKind::UnsupportedFormat`] when the
/// format cannot be detected; otherwise what the reader of the format found. All name the file, and the line or byte.
///
/// # Examples
/// ```
/// use coface_io as io;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-read-path.json");
/// std::fs::write(&path, "[[0, 1, 2], [1, 2, 3]]")?;
/// let model = io::read_path(&path, None)?;
/// assert_eq!(model.format(), Some(io::Format::Json));
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
pub fn read_path(path: impl AsRef<Path>, format: Option<Format>) -> Result<Model, Error> {
    read_path_with(path, &ReadOptions { format, ..ReadOptions::default() })
}

/// How files are read.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::{Format, ReadOptions};
/// let text = r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="1"/></svg>"#;
/// let options = ReadOptions::new().format(Format::Svg).flatten(0.01);
/// assert_eq!(io::read_with(text.as_bytes(), &options)?.vertex_count(), 23);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct ReadOptions {
    pub(crate) format: Option<Format>,
    pub(crate) flatten: Option<f64>,
    pub(crate) volume: VolumeReading,
    pub(crate) strict: bool,
    pub(crate) partial: bool,
    pub(crate) allow_outside: bool,
    pub(crate) lod: Option<f64>,
    pub(crate) pseudomanifold: bool,
    /// What points and graphs make, if they are no models by themselves.
    pub(crate) complex: Option<ComplexReading>,
}

impl ReadOptions {
    /// The format is detected, curves are refused, and every voxel but those with the number 0 is set.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{ReadOptions, read_with};
    /// assert_eq!(read_with(&b"[[0, 1, 2]]"[..], &ReadOptions::new())?.format(), Some(coface_io::Format::Json));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Reads this format, or with `None` the one that the name and the content state.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{Format, ReadOptions, read_with};
    /// let options = ReadOptions::new().format(Format::Lines);
    /// assert_eq!(read_with(&b"0,0,1,1"[..], &options)?.lines().len(), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn format(mut self, format: impl Into<Option<Format>>) -> Self {
        self.format = format.into();
        self
    }

    /// Replaces curves by chords that are at most this far from them, in the unit of the file. Without it the distance is a
    /// thousandth of the size of the drawing, and a remark says so.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{ReadOptions, read_with};
    /// let text = r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="1"/></svg>"#;
    /// let corners = |options| read_with(text.as_bytes(), &options).map(|model| model.vertex_count());
    /// assert!(corners(ReadOptions::new().flatten(0.5))? < corners(ReadOptions::new())?);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn flatten(mut self, tolerance: impl Into<Option<f64>>) -> Self {
        self.flatten = tolerance.into();
        self
    }

    /// Reads the geometries of this level of detail of CityJSON; with `None` those of the highest level of each object.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{ReadOptions, read_with};
    /// let text = r#"{"type": "CityJSON", "CityObjects": {"a": {"type": "Road", "geometry": [
    ///     {"type": "MultiPoint", "lod": "1", "boundaries": [0]}, {"type": "MultiPoint", "lod": "2", "boundaries": [0,
    /// 1]}]}},
    ///     "vertices": [[0, 0, 0], [1, 0, 0]]}"#;
    /// let vertices = |options| read_with(text.as_bytes(), &options).map(|model| model.vertex_count());
    /// assert_eq!((vertices(ReadOptions::new())?, vertices(ReadOptions::new().lod(1.0))?), (2, 1));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn lod(mut self, level: impl Into<Option<f64>>) -> Self {
        self.lod = level.into();
        self
    }

    /// Takes the ideal vertices of a gluing table as points: see [`Model::as_pseudomanifold`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{ReadOptions, read_with};
    /// assert!(read_with(&b"cPcbbbiht"[..], &ReadOptions::new().pseudomanifold(true))?.is_pseudomanifold());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn pseudomanifold(mut self, is_pseudomanifold: bool) -> Self {
        self.pseudomanifold = is_pseudomanifold;
        self
    }

    /// Says which voxels of a volume are set, and which of its axes are periodic.
    ///
    /// # Examples
    /// Only one of two voxels has a number of 2 at least.
    /// ```
    /// use coface_io::{ReadOptions, Structure, VolumeReading, VoxelRule, read_with};
    /// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 2 1\nencoding: ascii\n\n1 2";
    /// let volume = VolumeReading { rule: VoxelRule::AtLeast(2.0), ..VolumeReading::default() };
    /// let model = read_with(&text[..], &ReadOptions::new().volume(volume))?;
    /// let Some(Structure::Volume(voxels)) = model.structure() else { panic!("the file holds a volume") };
    /// assert!(!voxels.is_set(&[0, 0]) && voxels.is_set(&[1, 0]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn volume(mut self, volume: VolumeReading) -> Self {
        self.volume = volume;
        self
    }

    /// Lets a file name other files that lie anywhere: without it those outside of its own folder are refused, since
    /// a file of a stranger could name every file of the machine.
    ///
    /// Files that name others are NRRD headers, glTF, and the files of TetGen and NIfTI that come in pairs. What is
    /// no regular file is refused either way.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{ReadOptions, read_path_with};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let folder = std::env::temp_dir().join("coface-allow-outside");
    /// std::fs::create_dir_all(folder.join("headers"))?;
    /// std::fs::write(folder.join("numbers.raw"), [1, 0])?;
    /// let header = folder.join("headers/a.nhdr");
    /// let text = "NRRD0004\ntype: uchar\ndimension: 2\nsizes: 2 1\nencoding: raw\ndata file: ../numbers.raw\n\n";
    /// std::fs::write(&header, text)?;
    /// let error = read_path_with(&header, &ReadOptions::new()).unwrap_err();
    /// assert!(error.to_string().contains("--allow-outside"));
    /// assert!(read_path_with(&header, &ReadOptions::new().allow_outside(true)).is_ok());
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn allow_outside(mut self, is_allowed: bool) -> Self {
        self.allow_outside = is_allowed;
        self
    }

    /// Whether files that are named may lie anywhere.
    #[doc(hidden)]
    pub fn allows_outside(&self) -> bool {
        self.allow_outside
    }

    /// The choice of voxels.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{ReadOptions, VoxelRule};
    /// assert_eq!(ReadOptions::new().volume_reading().rule, VoxelRule::Nonzero);
    /// ```
    pub fn volume_reading(&self) -> &VolumeReading {
        &self.volume
    }

    /// Makes every assumption an error: what the reader would say in a [`Remark`] whose code is
    /// [an assumption](crate::RemarkCode::is_assumption) is refused.
    ///
    /// # Examples
    /// The file goes on behind the one triangle that its header states.
    /// ```
    /// use coface_io::{ReadOptions, read_with};
    /// let text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n";
    /// assert_eq!(read_with(text.as_bytes(), &ReadOptions::new())?.remarks().len(), 1);
    /// assert!(read_with(text.as_bytes(), &ReadOptions::new().strict(true)).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn strict(mut self, strict: bool) -> Self {
        self.strict = strict;
        self
    }

    /// Reads what stands before the first fault of a file that is cut short, with a remark, instead of refusing it.
    #[must_use]
    pub fn partial(mut self, partial: bool) -> Self {
        self.partial = partial;
        self
    }

    /// Refuses the first assumption among these remarks if reading is strict.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] with the sentence of the remark and its first line.
    #[doc(hidden)]
    pub fn accept(&self, remarks: &[Remark]) -> Result<(), Error> {
        match remarks.iter().find(|remark| self.strict && remark.code.is_assumption()) {
            Some(remark) => {
                let fault = Error::invalid(format!("{}; strict reading assumes nothing", remark.message))
                    .with_cure("leave out --strict, or correct the file");
                Err(match remark.places.first().and_then(|place| place.line) {
                    Some(line) => fault.at_line(line),
                    None => fault,
                })
            }
            None => Ok(()),
        }
    }

    fn check(&self) -> Result<(), Error> {
        match self.flatten {
            Some(tolerance) => yin::check_tolerance(tolerance),
            None => Ok(()),
        }
    }
}

/// Reads the model in a file as [`read_path`] does, with more to say about how.
///
/// # Errors
/// As [`read_path`]; [`ErrorKind::InvalidInput`] if the distance of chords is not positive and finite.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::ReadOptions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-read-path-with.svg");
/// std::fs::write(&path, "<svg xmlns=\"http://www.w3.org/2000/svg\"><circle r=\"1\"/></svg>")?;
/// assert_eq!(io::read_path_with(&path, &ReadOptions::new().flatten(0.5))?.lines().len(), 1);
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
pub fn read_path_with(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Model, Error> {
    let path = &volume::header_path(path.as_ref());
    let format = options.format;
    options.check()?;
    if let Some(read) = complex_reading::model_of_path(path, options) {
        return read;
    }
    if !path.exists()
        && let Some((file, entry)) = entry_of(path)
    {
        let read = || {
            let mut opened = opened(counted(file)?, Some(file), format)?;
            opened.path = Some(file.to_path_buf());
            match opened.format {
                Format::Isosig => {
                    isosig::read_entry(opened.bytes(), entry).map(|model| model.with_format(Format::Isosig))
                }
                Format::Json => {
                    json::read_entry(opened.bytes(), entry).map(|model| model.with_format(Format::Json))
                }
                _ => parts::part(read_started(opened, options)?, entry),
            }
        };
        let model: Result<Model, Error> = read();
        return model
            .and_then(|model| options.accept(model.remarks()).map(|()| model))
            .map(|model| model.as_pseudomanifold(options.pseudomanifold))
            .map_err(|error| error.in_file(file.display().to_string()));
    }
    let read = || {
        let mut opened = opened(counted(path)?, Some(path), format)?;
        opened.path = Some(path.clone());
        if opened.format.is_volume() && !opened.is_unpacked {
            options.accept(&opened.remarks)?;
            let Opened { format, remarks, .. } = opened;
            let mut model =
                volume_model(VolumeStream::open_with(path, format, options.allow_outside)?, options, format)?;
            model.remarks.splice(..0, remarks);
            return Ok(model);
        }
        read_started(opened, options)
    };
    read().map_err(|error: Error| error.in_file(path.display().to_string()))
}

/// Reads a model that a file names, which lies in the folder of that file unless the options say otherwise.
#[doc(hidden)]
pub fn read_companion(file: &Path, name: &str, options: &ReadOptions) -> Result<Model, Error> {
    let companions = Companions::of(file, options.allow_outside);
    let path = companions.path(Path::new(name));
    // One model of several is behind a `#`.
    let is_entry = |at: &usize| companions.path(Path::new(&name[..*at])).is_file();
    let entry = name.match_indices('#').map(|(at, _)| at).find(is_entry).filter(|_| !path.exists());
    let named = companions.open(Path::new(entry.map_or(name, |at| &name[..at])));
    named.map_err(|error| error.in_file(path.display().to_string()))?;
    read_path_with(path, options)
}

/// The format of a file: what its name and its content tell, or the one that is given.
///
/// # Errors
/// As [`read_path`], but for what is wrong behind the start of the file.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-format-of-path");
/// std::fs::write(&path, "[[0, 1, 2]]")?;
/// assert_eq!(io::format_of_path(&path, None)?, Format::Json);
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
pub fn format_of_path(path: impl AsRef<Path>, format: Option<Format>) -> Result<Format, Error> {
    let path = &volume::header_path(path.as_ref());
    let found = || opened(open(path)?, Some(path), format).map(|opened| opened.format);
    found().map_err(|error: Error| error.in_file(path.display().to_string()))
}

/// The volume in a file whose header has been read, and whose numbers have not, with remarks; `None` for a file of another format, and for one that is
/// read as points or as a graph.
///
/// # Errors
/// Those of [`VolumeStream::open`]; as [`read_path`] where the format is not known.
///
/// # Examples
/// ```
/// use coface_io as io;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-volume-of-path.json");
/// std::fs::write(&path, "[[0, 1, 2]]")?;
/// assert!(io::volume_of_path(&path, &io::ReadOptions::new())?.is_none());
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
pub fn volume_of_path(
    path: impl AsRef<Path>,
    options: &ReadOptions,
) -> Result<Option<(VolumeStream<'static>, Vec<Remark>)>, Error> {
    let path = path.as_ref();
    let find = || {
        if options.complex.is_some() {
            return Ok(None);
        }
        let header = &volume::header_path(path);
        let opened = opened(counted(header)?, Some(header), options.format)?;
        if !opened.format.is_volume() || opened.is_unpacked {
            return volume_started(opened, options);
        }
        options.accept(&opened.remarks)?;
        let stream = VolumeStream::open_with(header, opened.format, options.allow_outside)?;
        Ok(Some((stream, opened.remarks)))
    };
    find().map_err(|error: Error| error.in_file(path.display().to_string()))
}

/// The volume in a stream, as [`volume_of_path`] gives that of a file.
///
/// # Errors
/// As of [`volume_of_path`], without the name.
///
/// # Examples
/// ```
/// use coface_io as io;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = b"NRRD0004\ntype: double\ndimension: 1\nsizes: 3\nencoding: ascii\n\n1 0.5 -2";
/// let (stream, _) = io::volume_of(&text[..], &io::ReadOptions::new())?.expect("it is a volume");
/// assert_eq!(stream.numbers()?.0, [1.0, 0.5, -2.0]);
/// # Ok(()) }
/// ```
pub fn volume_of<'r>(
    input: impl Read + 'r,
    options: &ReadOptions,
) -> Result<Option<(VolumeStream<'r>, Vec<Remark>)>, Error> {
    if options.complex.is_some() {
        return Ok(None);
    }
    volume_started(opened(input, None, options.format)?, options)
}

fn volume_started<'r>(
    mut opened: Opened<'r>,
    options: &ReadOptions,
) -> Result<Option<(VolumeStream<'r>, Vec<Remark>)>, Error> {
    let format = opened.format;
    if !format.is_volume() {
        return Ok(None);
    }
    options.accept(&opened.remarks)?;
    let remarks = std::mem::take(&mut opened.remarks);
    Ok(Some((VolumeStream::new(opened.bytes(), format)?, remarks)))
}

/// The model of a volume.
fn volume_model(stream: VolumeStream<'_>, options: &ReadOptions, format: Format) -> Result<Model, Error> {
    let frame = stream.frame();
    let (volume, remarks) = stream.read(&options.volume)?;
    options.accept(&remarks)?;
    let mut model = Model::from_structure(Structure::Volume(volume));
    model.frame = frame;
    model.remarks = remarks;
    Ok(model.with_format(format))
}

/// Reads a model of this format.
///
/// # Errors
/// What the reader of the format found.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = io::read(&b"[[0, 1, 2], [1, 2, 3]]"[..], Format::Json)?;
/// assert!(model.structure().is_some());
/// # Ok(()) }
/// ```
pub fn read(input: impl Read, format: Format) -> Result<Model, Error> {
    read_started(opened(reading(STREAM, input, 0), None, Some(format))?, &ReadOptions::default())
}

/// Reads a model from a stream: of the format of the options, or of the one that its content shows.
///
/// # Errors
/// As [`read_unknown`]; [`ErrorKind::InvalidInput`] if the distance of chords is not positive and finite.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::ReadOptions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = io::read_with(&b"0,0,1,1"[..], &ReadOptions::default())?;
/// assert_eq!(model.lines().len(), 1);
/// # Ok(()) }
/// ```
pub fn read_with(mut input: impl Read, options: &ReadOptions) -> Result<Model, Error> {
    options.check()?;
    if let Some(read) = complex_reading::model_of_stream(&mut input, options) {
        return read;
    }
    read_started(opened(reading(STREAM, input, 0), None, options.format)?, options)
}

/// Reads a model from the bytes of a file of this name, as [`read_path_with`] does from the file itself: for what was fetched from
/// elsewhere.
///
/// # Errors
/// As [`read_path_with`].
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::ReadOptions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = io::read_named(&b"0,0,1,1"[..], "https://example.org/a.lines", &ReadOptions::default())?;
/// assert_eq!(model.format(), Some(io::Format::Lines));
/// # Ok(()) }
/// ```
pub fn read_named(mut input: impl Read, name: &str, options: &ReadOptions) -> Result<Model, Error> {
    let read = || {
        options.check()?;
        if let Some(read) = complex_reading::model_of_stream(&mut input, options) {
            return read;
        }
        read_started(opened(reading(name, input, 0), Some(Path::new(name)), options.format)?, options)
    };
    read().map_err(|error: Error| error.in_file(name))
}

/// Reads a model whose format is detected by its content alone, such as one from the standard input.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] when the content is of no known format; otherwise what the reader of the format
/// found.
///
/// # Examples
/// ```
/// use coface_io as io;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// assert_eq!(io::read_unknown(&b"[[0, 1, 2]]"[..])?.format(), Some(io::Format::Json));
/// # Ok(()) }
/// ```
pub fn read_unknown(input: impl Read) -> Result<Model, Error> {
    read_with(input, &ReadOptions::default())
}

/// Reads the boundary of a set in the plane from a file, as [`read_boundary`] does from a stream; the format is found out as by
/// [`read_path`], and `file#name` is an entry of a JSON list.
///
/// # Errors
/// As [`read_path`] and [`read_boundary`].
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::ReadOptions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-read-boundary.wkt");
/// std::fs::write(&path, "POLYGON ((0 0, 1 0, 0 1, 0 0))")?;
/// assert_eq!(io::read_boundary_path(&path, &ReadOptions::default())?.curves().len(), 1);
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
pub fn read_boundary_path(
    path: impl AsRef<Path>,
    options: &ReadOptions,
) -> Result<yin::BoundaryDrawing, Error> {
    let path = path.as_ref();
    options.check()?;
    if !path.exists()
        && let Some((file, entry)) = entry_of(path)
    {
        let drawing = counted(file).and_then(|file| json::read_boundary(file, Some(entry)));
        return match drawing {
            Ok(drawing) => Ok(drawing.with_format(Format::Json)),
            Err(error) => Err(error.in_file(file.display().to_string())),
        };
    }
    let read = || boundary_of(counted(path)?, Some(path), options);
    read().map_err(|error: Error| error.in_file(path.display().to_string()))
}

/// Reads the boundary of a set in the plane: our JSON and `.dat` as [`yin`] says; SVG with its curves, unless the options have a
/// tolerance; and the polygons and closed lines of all other formats.
///
/// # Errors
/// What the reader of the format found; those of [`yin::drawing_of_model`].
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::{Format, ReadOptions};
/// use coface_yin::Order;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = br#"<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0C1 0 1 1 0 1Z"/></svg>"#;
/// let drawing = io::read_boundary(&text[..], Format::Svg, &ReadOptions::default())?;
/// assert_eq!((drawing.order(), drawing.curves()[0].points().len()), (Order::CUBIC, 2));
/// # Ok(()) }
/// ```
pub fn read_boundary(
    input: impl Read,
    format: Format,
    options: &ReadOptions,
) -> Result<yin::BoundaryDrawing, Error> {
    options.check()?;
    boundary_started(opened(reading(STREAM, input, 0), None, Some(format))?, options)
}

/// Reads the boundary of a set in the plane from a stream whose format is that of the options, or the one that its content shows.
///
/// # Errors
/// As [`read_with`] and [`read_boundary`].
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::ReadOptions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// assert!(io::read_boundary_with(&b"{\"plane\": true}"[..], &ReadOptions::default())?.is_plane());
/// # Ok(()) }
/// ```
pub fn read_boundary_with(input: impl Read, options: &ReadOptions) -> Result<yin::BoundaryDrawing, Error> {
    options.check()?;
    boundary_of(reading(STREAM, input, 0), None, options)
}

fn boundary_of(
    input: impl Read,
    name: Option<&Path>,
    options: &ReadOptions,
) -> Result<yin::BoundaryDrawing, Error> {
    let (start, whole, rest, is_unpacked) = unpacked_start(input)?;
    if options.format.is_none() && yin::is_factories(without_mark(&start)) {
        // Curves as text are no format of their own, for nothing else reads them.
        let rest = rest.take(if whole { 0 } else { u64::MAX });
        return yin::read_factories(without_mark(&start).chain(rest));
    }
    let (format, remarks) = match options.format {
        Some(format) => (format, Vec::new()),
        None => detection::decide(without_mark(&start), whole, name.and_then(Format::from_input_path))?,
    };
    let path = name.filter(|name| name.is_file()).map(Path::to_path_buf);
    boundary_started(Opened { start, whole, rest, is_unpacked, format, remarks, path }, options)
}

fn boundary_started(opened: Opened<'_>, options: &ReadOptions) -> Result<yin::BoundaryDrawing, Error> {
    options.accept(&opened.remarks)?;
    let (format, flatten) = (opened.format, options.flatten);
    let drawing = match format {
        Format::Json | Format::Dat | Format::Svg if format != Format::Svg || flatten.is_none() => {
            let Opened { start, whole, rest, .. } = opened;
            detection::check_stated(format, &start, whole)?;
            let rest = rest.take(if whole { 0 } else { u64::MAX });
            let input = without_mark(&start).chain(rest);
            match format {
                Format::Json => json::read_boundary(input, None)?,
                Format::Dat => yin::read_dat(input)?,
                _ => svg::read_regions(input)?,
            }
        }
        _ => yin::drawing_of_model(&read_started(opened, options)?)?,
    };
    options.accept(drawing.remarks())?;
    Ok(drawing.with_format(format))
}

/// Writes a model in this format, in the encoding that is most often wanted: ascii, but binary for STL and PLY.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] when the format cannot hold the model; [`ErrorKind::Io`] from the output.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = io::read(&b"[[0, 1, 2], [1, 2, 3]]"[..], Format::Json)?;
/// let mut out = Vec::new();
/// io::write(&model, &mut out, Format::Json)?;
/// assert_eq!(io::read(&out[..], Format::Json)?, model);
/// # Ok(()) }
/// ```
pub fn write(model: &Model, out: impl Write, format: Format) -> Result<(), Error> {
    match format {
        Format::Off => off::write(model, out),
        Format::Obj => obj::write(model, out),
        Format::Ply => ply::write(model, out, ply::Encoding::default()),
        Format::Stl => stl::write(model, out, stl::Encoding::default()),
        Format::Medit => medit::write(model, out),
        Format::Msh => msh::write(model, out, msh::Version::default()),
        Format::Vtk => vtk::write(model, out, vtk::Encoding::default()),
        Format::VtkGrid => vtk::write_xml(model, out, vtk::XmlKind::UnstructuredGrid),
        Format::VtkPolygons => vtk::write_xml(model, out, vtk::XmlKind::PolyData),
        Format::Json => json::write(model, out),
        Format::Isosig => isosig::write(model, out),
        Format::Lines => lines_text::write(model, out),
        Format::GeoJson => geojson::write(model, out),
        Format::Wkt => wkt::write(model, out),
        Format::Wkb => wkb::write(model, out, wkb::Encoding::Bytes),
        Format::WkbHex => wkb::write(model, out, wkb::Encoding::Digits),
        Format::Svg => svg::write(model, out),
        Format::Container => container::write(model, out),
        Format::ThreeMf => three_mf::write(model, out),
        Format::Amf => amf::write(model, out),
        Format::Npy => match model.structure() {
            Some(Structure::Volume(voxels)) => volume::write_npy(voxels, out),
            _ => Err(Error::new(
                ErrorKind::UnsupportedFormat,
                "a .npy file can only hold a voxel volume; this model is none",
            )
            .with_cure("write a mesh format or JSON")),
        },
        Format::Dat
        | Format::Png
        | Format::Nrrd
        | Format::Nifti
        | Format::MetaImage
        | Format::Pgm
        | Format::MatrixMarket
        | Format::Gltf
        | Format::Collada
        | Format::Abaqus
        | Format::TetGen
        | Format::Points
        | Format::CityJson => {
            Err(written::never_written(format).expect("these hold no models that are written"))
        }
    }
}

/// Writes what is empty as a polygon of well-known text or binary without rings.
///
/// # Panics
/// For other formats.
#[doc(hidden)]
pub fn write_empty_polygon(
    system: Option<&ReferenceSystem>,
    out: impl Write,
    format: Format,
) -> Result<(), Error> {
    match format {
        Format::Wkt => wkt::write_empty_polygon(system, out),
        Format::Wkb => wkb::write_empty_polygon(system, out, wkb::Encoding::Bytes),
        Format::WkbHex => wkb::write_empty_polygon(system, out, wkb::Encoding::Digits),
        other => panic!("{other:?} is no well-known format"),
    }
}

/// Writes a model to a file, in the format of its name unless another is given. The file appears whole or not
/// at all: see [`replace_file`](super::replace_file).
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] when the name belongs to no format or the format cannot hold the model;
/// [`ErrorKind::Io`] with the path when it cannot be written.
///
/// # Examples
/// ```
/// use coface_io as io;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = io::read_unknown(&b"[[0, 1, 2]]"[..])?;
/// let path = std::env::temp_dir().join("coface-write-path.json");
/// io::write_path(&model, &path, None)?;
/// assert_eq!(io::read_path(&path, None)?, model);
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
pub fn write_path(model: &Model, path: impl AsRef<Path>, format: Option<Format>) -> Result<(), Error> {
    let path = path.as_ref();
    let format = match format {
        Some(format) => format,
        None => written::format_of_output(path)?,
    };
    replace_file(path, |out| write(model, out, format))
}

/// The file and the entry that `file#entry` names, if there is such a file.
#[doc(hidden)]
pub fn entry_of(path: &Path) -> Option<(&Path, &str)> {
    let text = path.to_str()?;
    text.match_indices('#')
        .map(|(at, _)| (Path::new(&text[..at]), &text[at + 1..]))
        .find(|(file, _)| file.is_file())
}

/// A file whose bytes are counted.
pub(crate) fn counted(path: &Path) -> Result<CountedStream<File>, Error> {
    let file = open(path)?;
    let total = file.metadata().map_or(0, |metadata| metadata.len());
    Ok(reading(&name_of(path), file, total))
}

/// Reads a mesh of simplices from a file into two streams, those of its vertices and of its elements, without keeping it in memory: three
/// coordinates for each vertex, and four vertices for each element. False if the file is of a format, or has elements, for which that is not
/// done.
#[doc(hidden)]
pub fn stream_mesh(path: &Path, format: Option<Format>, streams: [ScratchStream; 2]) -> Result<bool, Error> {
    let read = || {
        let Opened { start, whole, rest, format, .. } = opened(counted(path)?, Some(path), format)?;
        if !matches!(format, Format::Medit | Format::Msh) {
            return Ok(false);
        }
        detection::check_stated(format, &start, whole)?;
        let input = without_mark(&start).chain(rest);
        let scratch = ScratchMesh::new(streams);
        let read = match format {
            Format::Medit => medit::read_into(input, scratch),
            _ => msh::read_into(input, scratch),
        };
        match read {
            Ok(mut scratch) => {
                scratch.finish()?;
                Ok(true)
            }
            Err(error) if error.message() == scratch_mesh::NOT_SIMPLICIAL => Ok(false),
            Err(error) => Err(error),
        }
    };
    read().map_err(|error: Error| error.in_file(path.display().to_string()))
}

/// A stream, unpacked if it is compressed, whose format is known.
pub(crate) struct Opened<'r> {
    start: Vec<u8>,
    /// Whether the start is all of it.
    whole: bool,
    rest: Box<dyn Read + 'r>,
    pub(crate) is_unpacked: bool,
    pub(crate) format: Format,
    remarks: Vec<Remark>,
    /// The path of the file, if it is one: some formats have files beside it.
    path: Option<PathBuf>,
}

impl<'r> Opened<'r> {
    /// Whether text begins with the mark that some editors put there.
    pub(crate) fn has_mark(&self) -> bool {
        without_mark(&self.start).len() < self.start.len()
    }

    /// All bytes but the mark that some editors put before text.
    pub(crate) fn bytes(self) -> impl Read + use<'r> {
        let start = without_mark(&self.start).to_vec();
        std::io::Cursor::new(start).chain(self.rest.take(if self.whole { 0 } else { u64::MAX }))
    }
}

/// Looks at the start of a stream, which has a name or none, and finds its format unless it is stated.
pub(crate) fn opened<'r>(
    input: impl Read + 'r,
    name: Option<&Path>,
    stated: Option<Format>,
) -> Result<Opened<'r>, Error> {
    let (start, whole, rest, is_unpacked) = unpacked_start(input)?;
    let (format, remarks) = match stated {
        Some(format) => (format, Vec::new()),
        None => detection::decide(without_mark(&start), whole, name.and_then(Format::from_input_path))?,
    };
    Ok(Opened { start, whole, rest, is_unpacked, format, remarks, path: None })
}

/// The bytes of a file once more, unpacked and without the mark of text.
pub(crate) fn bytes_again(path: &Path) -> Result<impl Read + use<>, Error> {
    Ok(opened(counted(path)?, Some(path), Some(Format::Off))?.bytes())
}

/// Reads on from the start that was looked at.
fn read_started(opened: Opened<'_>, options: &ReadOptions) -> Result<Model, Error> {
    options.accept(&opened.remarks)?;
    let Opened { start, whole, rest, format, remarks, path, .. } = opened;
    let read = read_format(&start, whole, rest, (format, path.as_deref()), options);
    let mut model = read.map_err(|error| explained(error, &remarks))?;
    model.remarks.splice(..0, remarks);
    Ok(model)
}

/// Where the content decided the format and is not whole, the name may have been right.
fn explained(error: Error, remarks: &[Remark]) -> Error {
    match remarks.iter().find(|remark| remark.code == RemarkCode::FormatByContent) {
        Some(remark) => {
            let cure = error.cure().map_or_else(String::new, |cure| format!("{cure}; "));
            error.with_cure(format!("{cure}note that {}", remark.message))
        }
        None => error,
    }
}

fn read_format(
    start: &[u8],
    whole: bool,
    rest: impl Read,
    (format, path): (Format, Option<&Path>),
    options: &ReadOptions,
) -> Result<Model, Error> {
    detection::check_stated(format, start, whole)?;
    let rest = rest.take(if whole { 0 } else { u64::MAX });
    let mut input = Tail::new(without_mark(start).chain(rest));
    let mut model = read_mesh(&mut input, (format, path), options)?;
    if format.is_lines_of_text() {
        model.remarks.extend(input.remark());
    }
    if options.volume != VolumeReading::default() && !matches!(model.structure, Some(Structure::Volume(_))) {
        let message =
            format!("voxels are chosen, and this is {}, which has none: all of it is read", format.title());
        model.remarks.push(Remark::new(RemarkCode::InputReading, message));
    }
    options.accept(model.remarks())?;
    Ok(model.with_format(format).as_pseudomanifold(options.pseudomanifold))
}

/// Reads what is no volume.
fn read_mesh(
    input: &mut dyn Read,
    (format, path): (Format, Option<&Path>),
    options: &ReadOptions,
) -> Result<Model, Error> {
    let flatten = options.flatten;
    let companions = path.map(|path| Companions::of(path, options.allow_outside));
    Ok(match format {
        Format::Off => match path.filter(|path| path.is_file()) {
            Some(path) => off::read_file(input, path, options)?,
            None => off::read_with(input, options)?,
        },
        Format::Obj => obj::read_with(input, options)?,
        Format::Ply => ply::read_with(input, options)?,
        Format::Stl => stl::read_with(input, options)?,
        Format::Medit => medit::read_with(input, options)?,
        Format::Msh => msh::read_with(input, options)?,
        Format::Vtk => vtk::read_with(input, options)?,
        Format::Json => json::read_with(input, flatten)?,
        Format::Isosig => isosig::read(input)?,
        Format::Lines => lines_text::read(input)?,
        Format::GeoJson => geojson::read(input)?,
        Format::Wkt | Format::WkbHex => wkt::read_flattened(input, flatten)?,
        Format::Wkb => wkb::read_flattened(input, flatten)?,
        Format::Svg => svg::read_with(input, flatten)?,
        Format::Dat => yin::model_of_drawing(&yin::read_dat(input)?, flatten)?,
        Format::VtkGrid | Format::VtkPolygons => vtk::read_xml(input)?,
        Format::Container => container::read(input)?,
        Format::Gltf => gltf::read_in(input, companions.as_ref())?,
        Format::ThreeMf => three_mf::read(input)?,
        Format::Collada => collada::read(input)?,
        Format::Amf => amf::read(input)?,
        Format::Abaqus => abaqus::read(input)?,
        Format::TetGen => tetgen::read_beside(input, path, companions.as_ref())?,
        Format::Points => points_text::read(input)?,
        Format::CityJson => cityjson::read_with(input, options)?,
        Format::MatrixMarket => matrix_market::read_model(input)?,
        Format::Npy | Format::Nrrd | Format::Nifti | Format::MetaImage | Format::Pgm | Format::Png => {
            volume_model(VolumeStream::new(input, format)?, options, format)?
        }
    })
}
