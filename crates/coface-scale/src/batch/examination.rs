//! The report on one file as request and answer.

use super::journal::Stamp;
use coface_algebra::Error;
use coface_answers::Report;
use coface_answers::answer::{RowAnswer, to_json};
use coface_io as io;
use coface_io::{FileEntries, Format, Model, ReadOptions, VolumeReading};

use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// A file to report on, and how.
///
/// # Examples
/// ```
/// use coface_scale::batch::ReportRequest;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let request = ReportRequest::new("bunny.off");
/// assert_eq!(ReportRequest::from_line(&request.to_line())?, request);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ReportRequest {
    /// The file.
    pub path: PathBuf,
    /// How it is read.
    pub reading: Reading,
}

/// How the files of a batch are read and how much of each is reported.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    /// The format, instead of the one that name and content tell.
    pub format: Option<Format>,
    /// The farthest that chords may be from the curves of an SVG.
    pub flatten: Option<f64>,
    /// Which voxels of volumes are set.
    pub volume: VolumeReading,
    /// Whether what a reader assumes is an error.
    pub strict: bool,
    /// Whether a damaged file is read up to its first fault.
    pub partial: bool,
    /// Whether every place of every problem is reported, not the first hundred.
    pub all_places: bool,
    /// Whether files that a file names may lie outside of its folder.
    pub allow_outside: bool,
    /// The level of detail of CityJSON that is read, instead of the highest.
    pub lod: Option<f64>,
    /// Whether ideal vertices are points, and are not cut off.
    pub pseudomanifold: bool,
}

/// How many places of a problem are reported when not all are asked for.
const PLACES: usize = 100;

impl Reading {
    pub(crate) fn options(self) -> ReadOptions {
        let options = ReadOptions::new().format(self.format).flatten(self.flatten).volume(self.volume);
        options
            .strict(self.strict)
            .partial(self.partial)
            .allow_outside(self.allow_outside)
            .lod(self.lod)
            .pseudomanifold(self.pseudomanifold)
    }
}

impl ReportRequest {
    /// A request for the report on this file.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::batch::ReportRequest;
    /// let request = ReportRequest::new("a.off");
    /// assert_eq!(request.path.to_str(), Some("a.off"));
    /// ```
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self { path: path.into(), reading: Reading::default() }
    }

    /// The request as a line of JSON. Names of files that are no text are lists of bytes.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::batch::ReportRequest;
    /// let request = ReportRequest::new("a.off");
    /// assert_eq!(ReportRequest::from_line(&request.to_line())?, request);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn to_line(&self) -> String {
        let line = RequestLine { path: PathText::of(&self.path), reading: ReadingText::of(self.reading) };
        serde_json::to_string(&line).expect("requests have texts as keys")
    }

    /// The request in a line.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) if there is none in it.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::batch::ReportRequest;
    /// let request = ReportRequest::new("a.off");
    /// assert_eq!(ReportRequest::from_line(&request.to_line())?, request);
    /// assert!(ReportRequest::from_line("[]").is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn from_line(line: &str) -> Result<Self, Error> {
        let line: RequestLine = serde_json::from_str(line)
            .map_err(|error| Error::parse(format!("this is no request for a report: {error}")))?;
        Ok(Self { path: line.path.into_path(), reading: line.reading.into_reading()? })
    }
}

/// A request as a line.
#[derive(Serialize, Deserialize)]
struct RequestLine {
    path: PathText,
    #[serde(flatten)]
    reading: ReadingText,
}

/// How a file is read, in a line.
#[derive(Serialize, Deserialize)]
pub(crate) struct ReadingText {
    format: Option<String>,
    flatten: Option<f64>,
    #[serde(default)]
    volume: VolumeReading,
    #[serde(default)]
    strict: bool,
    #[serde(default)]
    partial: bool,
    #[serde(default)]
    all_places: bool,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    allow_outside: bool,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    lod: Option<f64>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pseudomanifold: bool,
}

impl ReadingText {
    pub(crate) fn of(reading: Reading) -> Self {
        Self {
            format: reading.format.map(|format| format.name().to_owned()),
            flatten: reading.flatten,
            volume: reading.volume,
            strict: reading.strict,
            partial: reading.partial,
            all_places: reading.all_places,
            allow_outside: reading.allow_outside,
            lod: reading.lod,
            pseudomanifold: reading.pseudomanifold,
        }
    }

    fn into_reading(self) -> Result<Reading, Error> {
        Ok(Reading {
            format: self.format.as_deref().map(Format::from_name).transpose()?,
            flatten: self.flatten,
            volume: self.volume,
            strict: self.strict,
            partial: self.partial,
            all_places: self.all_places,
            allow_outside: self.allow_outside,
            lod: self.lod,
            pseudomanifold: self.pseudomanifold,
        })
    }
}

/// A path in a line: as text, or as bytes if it is none.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(untagged)]
pub(crate) enum PathText {
    Text(String),
    Bytes(Vec<u8>),
}

impl PathText {
    pub(crate) fn of(path: &Path) -> Self {
        #[cfg(unix)]
        if path.to_str().is_none() {
            use std::os::unix::ffi::OsStrExt;
            return Self::Bytes(path.as_os_str().as_bytes().to_vec());
        }
        Self::Text(path.to_string_lossy().into_owned())
    }

    pub(crate) fn into_path(self) -> PathBuf {
        match self {
            Self::Text(text) => text.into(),
            #[cfg(unix)]
            Self::Bytes(bytes) => {
                use std::os::unix::ffi::OsStringExt;
                std::ffi::OsString::from_vec(bytes).into()
            }
            #[cfg(not(unix))]
            Self::Bytes(bytes) => String::from_utf8_lossy(&bytes).into_owned().into(),
        }
    }
}

/// Answers requests for reports, one after the other. Of a file of several models it keeps where each stands, so that all of them are
/// read in linear time.
///
/// # Examples
/// ```
/// let mut examiner = coface_scale::batch::Examiner::default();
/// let answer = examiner.examine("{\"path\":\"/no/such/file.off\"}");
/// assert!(answer.starts_with("{\"error\":{") && answer.contains("\"kind\":\"io\""));
/// ```
#[derive(Debug, Default)]
pub struct Examiner {
    /// The file of several models that was asked for last, and its state.
    last: Option<(PathBuf, Stamp, FileEntries)>,
}

impl Examiner {
    /// Answers a [request](ReportRequest) for a report: an object with everything that `coface info --json` says, or one whose only key is
    /// `error` with `kind`, `message` and `cure`, as a line of JSON.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::batch::{Examiner, ReportRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = std::env::temp_dir().join("coface-examiner.jsonl");
    /// std::fs::write(&path, "[[0, 1, 2]]\n[[0, 1]]\n")?;
    /// let request = ReportRequest::new(format!("{}#2", path.display())).to_line();
    /// assert!(Examiner::default().examine(&request).contains("\"f_vector\":[2,1]"));
    /// # std::fs::remove_file(&path)?;
    /// # Ok(()) }
    /// ```
    pub fn examine(&mut self, request: &str) -> String {
        self.examine_with(request, |_| None)
    }

    /// Answers as [`Examiner::examine`] does; `fetch` gives the bytes of what is no file here, such as those at a URL.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::batch::{Examiner, ReportRequest};
    /// let request = ReportRequest::new("memory://segment.lines").to_line();
    /// let answer = Examiner::default().examine_with(&request, |_| Some(Ok(b"0,0,1,1".to_vec())));
    /// assert!(answer.contains("\"f_vector\":[2,1]"), "{answer}");
    /// ```
    pub fn examine_with(
        &mut self,
        request: &str,
        fetch: impl FnOnce(&Path) -> Option<Result<Vec<u8>, Error>>,
    ) -> String {
        let report = ReportRequest::from_line(request).and_then(|request| {
            let (name, options) = (request.path.display().to_string(), request.reading.options());
            let model = match fetch(&request.path) {
                Some(bytes) => io::read_named(&bytes?[..], &name, &options)?,
                None => self.read(&request.path, &options, request.reading.format)?,
            };
            report_on(model, &name, request.reading)
        });
        match report {
            Ok(row) => to_json(&row),
            Err(error) => Failure { error: Fault::of(&error) }.to_line(),
        }
    }

    /// Reads a file, or one of the models of a file.
    fn read(&mut self, path: &Path, options: &ReadOptions, format: Option<Format>) -> Result<Model, Error> {
        let Some((file, entry)) = io::entry_of(path).filter(|_| !path.exists()) else {
            return io::read_path_with(path, options);
        };
        let stamp = Stamp::of(file);
        let is_known = self.last.as_ref().is_some_and(|(last, state, _)| last == file && *state == stamp);
        if !is_known {
            self.last = Some((file.to_path_buf(), stamp, FileEntries::of_path(file, format)?));
        }
        match &self.last {
            Some((.., entries)) => entries.read(entry, options),
            None => io::read_path_with(path, options),
        }
    }
}

/// What is said about a model that was read from the thing of this name.
///
/// # Errors
/// What [`Report::of`] finds, in the file of this name.
pub(crate) fn report_on(model: Model, name: &str, reading: Reading) -> Result<RowAnswer, Error> {
    let format = model.format().unwrap_or(Format::Json);
    let report = Report::of(model).map_err(|error| error.in_file(name))?;
    let limit = if reading.all_places { usize::MAX } else { PLACES };
    Ok(RowAnswer::of(name, format.name(), report.answer(limit)))
}

/// The answer of a worker on a file that it cannot serve.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Failure {
    pub(crate) error: Fault,
}

/// An error in a row.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Fault {
    /// What to do.
    pub(crate) cure: Option<String>,
    pub(crate) kind: String,
    /// The place and what is wrong there.
    pub(crate) message: String,
}

impl Failure {
    pub(crate) fn to_line(&self) -> String {
        serde_json::to_string(self).expect("errors have texts as keys")
    }
}

impl Fault {
    /// An error with its cure beside its message.
    pub(crate) fn of(error: &Error) -> Self {
        let whole = error.to_string();
        let message = match error.cure() {
            Some(cure) => whole.strip_suffix(&format!("; {cure}")).unwrap_or(&whole),
            None => &whole,
        };
        Self {
            cure: error.cure().map(str::to_owned),
            kind: error.kind().word().to_owned(),
            message: message.to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::ErrorKind;
    use coface_io::VoxelRule;

    #[test]
    fn requests_are_lines() {
        let mut request = ReportRequest::new("a\nb \"c\".svg");
        let mut volume = VolumeReading::default();
        volume.periodic[1] = true;
        let rules = [
            VoxelRule::Nonzero,
            VoxelRule::AtLeast(0.5),
            VoxelRule::Below(-1.0),
            VoxelRule::Between(0.1, 0.2),
            VoxelRule::Equal(7.0),
        ];
        for rule in rules {
            volume.rule = rule;
            request.reading = Reading {
                format: Some(Format::Svg),
                flatten: Some(0.125),
                volume,
                strict: true,
                partial: true,
                all_places: true,
                allow_outside: true,
                lod: Some(1.25),
                pseudomanifold: true,
            };
            let line = request.to_line();
            assert!(!line.contains('\n'));
            assert_eq!(ReportRequest::from_line(&line).unwrap(), request);
        }
        for line in ["", "{}", "[]", "{\"path\":7}", "{\"path\":\"a\",\"format\":\"docx\"}"] {
            assert!(ReportRequest::from_line(line).is_err(), "{line}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn names_need_not_be_text() {
        use std::os::unix::ffi::OsStringExt;
        let request = ReportRequest::new(std::ffi::OsString::from_vec(vec![b'a', 0xff, b'\n']));
        assert_eq!(ReportRequest::from_line(&request.to_line()).unwrap(), request);
    }

    #[test]
    fn a_row_says_what_info_says() {
        let read = || coface_io::read(&b"[[0,1,2],[1,2,3],[9]]"[..], Format::Json).unwrap();
        let row = report_on(read(), "a.json", Reading::default()).unwrap();
        let row: serde_json::Value = serde_json::from_str(&to_json(&row)).unwrap();
        let info = Report::of(read()).unwrap().answer(PLACES).of_file("a.json", "json");
        let mut info = serde_json::to_value(info).unwrap();
        assert!(info.as_object_mut().unwrap().remove("remarks").is_some());
        assert_eq!(row, info);
    }

    #[test]
    fn an_error_has_its_place_in_the_message_and_its_cure_beside_it() {
        let error = Error::parse("bad").at_line(3).in_file("a.off").with_cure("write a number");
        let line = Failure { error: Fault::of(&error) }.to_line();
        assert_eq!(line, r#"{"error":{"cure":"write a number","kind":"parse","message":"a.off:3: bad"}}"#);
        let error = Error::new(ErrorKind::Io, "gone");
        let line = Failure { error: Fault::of(&error) }.to_line();
        assert_eq!(line, r#"{"error":{"cure":null,"kind":"io","message":"gone"}}"#);
    }
}
