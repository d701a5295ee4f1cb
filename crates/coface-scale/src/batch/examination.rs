//! The report on one file as request and answer.

use coface_algebra::Error;
use coface_answers::Report;
use coface_io as io;
use coface_io::{Format, Model, ReadOptions, VolumeReading, VoxelRule};
use serde_json::{Value, json};
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
    /// Whether every place of every problem is reported, not the first hundred.
    pub all_places: bool,
}

/// How many places of a problem are reported when not all are asked for.
const PLACES: usize = 100;

impl Reading {
    /// As the value in a request.
    pub(crate) fn to_json(self) -> Value {
        json!({
            "format": self.format.map(Format::name),
            "flatten": self.flatten,
            "volume": volume_to_json(self.volume),
            "all_places": self.all_places,
        })
    }

    fn options(self) -> ReadOptions {
        ReadOptions::new().format(self.format).flatten(self.flatten).volume(self.volume)
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
        let mut value = self.reading.to_json();
        value["path"] = path_to_json(&self.path);
        value.to_string()
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
        let fault = || Error::parse("this is no request for a report");
        let value: Value = serde_json::from_str(line).map_err(|_| fault())?;
        let path = path_from_json(&value["path"]).ok_or_else(fault)?;
        let format = value["format"].as_str().map(Format::from_name).transpose()?;
        let (flatten, all_places) = (value["flatten"].as_f64(), value["all_places"] == true);
        let volume = volume_from_json(&value["volume"]).ok_or_else(fault)?;
        Ok(Self { path, reading: Reading { format, flatten, volume, all_places } })
    }
}

/// Which voxels are set as JSON: a word with its bounds, and for each axis whether it is periodic.
fn volume_to_json(volume: VolumeReading) -> Value {
    let rule = match volume.rule {
        VoxelRule::Nonzero => json!(["nonzero"]),
        VoxelRule::AtLeast(bound) => json!(["at least", bound]),
        VoxelRule::Below(bound) => json!(["below", bound]),
        VoxelRule::Between(low, high) => json!(["between", low, high]),
        VoxelRule::Equal(value) => json!(["equal", value]),
    };
    json!({"rule": rule, "periodic": volume.periodic})
}

/// What [`volume_to_json`] made JSON; the default for null.
fn volume_from_json(value: &Value) -> Option<VolumeReading> {
    let mut volume = VolumeReading::default();
    if value.is_null() {
        return Some(volume);
    }
    let bound = |i: usize| value["rule"][i].as_f64();
    volume.rule = match value["rule"][0].as_str()? {
        "nonzero" => VoxelRule::Nonzero,
        "at least" => VoxelRule::AtLeast(bound(1)?),
        "below" => VoxelRule::Below(bound(1)?),
        "between" => VoxelRule::Between(bound(1)?, bound(2)?),
        "equal" => VoxelRule::Equal(bound(1)?),
        _ => return None,
    };
    for (axis, told) in volume.periodic.iter_mut().zip(value["periodic"].as_array()?) {
        *axis = told.as_bool()?;
    }
    Some(volume)
}

/// A path as JSON: text, or a list of bytes where it is none.
pub(crate) fn path_to_json(path: &Path) -> Value {
    #[cfg(unix)]
    if path.to_str().is_none() {
        use std::os::unix::ffi::OsStrExt;
        return path.as_os_str().as_bytes().into();
    }
    path.to_string_lossy().into()
}

/// The path that [`path_to_json`] made JSON.
pub(crate) fn path_from_json(value: &Value) -> Option<PathBuf> {
    #[cfg(unix)]
    if let Value::Array(bytes) = value {
        use std::os::unix::ffi::OsStringExt;
        let bytes = bytes.iter().map(|byte| u8::try_from(byte.as_u64()?).ok()).collect::<Option<_>>()?;
        return Some(std::ffi::OsString::from_vec(bytes).into());
    }
    value.as_str().map(PathBuf::from)
}

/// Answers the [request](ReportRequest) for a report: an object with everything that `coface info --json` says, or one whose only key is
/// `error` with `kind`, `message` and `cure`, as a line of JSON.
///
/// # Examples
/// ```
/// let answer = coface_scale::batch::examine("{\"path\":\"/no/such/file.off\"}");
/// assert!(answer.starts_with("{\"error\":{") && answer.contains("\"kind\":\"io\""));
/// ```
pub fn examine(request: &str) -> String {
    examine_with(request, |_| None)
}

/// Answers as [`examine`] does; `fetch` gives the bytes of what is no file here, such as those at a URL.
///
/// # Examples
/// ```
/// use coface_scale::batch::{ReportRequest, examine_with};
/// let request = ReportRequest::new("memory://segment.lines").to_line();
/// let answer = examine_with(&request, |_| Some(Ok(b"0,0,1,1".to_vec())));
/// assert!(answer.contains("\"f_vector\":[2,1]"), "{answer}");
/// ```
pub fn examine_with(request: &str, fetch: impl FnOnce(&Path) -> Option<Result<Vec<u8>, Error>>) -> String {
    let report = ReportRequest::from_line(request).and_then(|request| {
        let (name, options) = (request.path.display().to_string(), request.reading.options());
        let model = match fetch(&request.path) {
            Some(bytes) => io::read_named(&bytes?[..], &name, &options)?,
            None => io::read_path_with(&request.path, &options)?,
        };
        report_on(model, &name, request.reading)
    });
    report.unwrap_or_else(|error| json!({"error": error_to_json(&error)})).to_string()
}

/// What is said about a model that was read from the thing of this name.
///
/// # Errors
/// What [`Report::of`] finds, in the file of this name.
pub fn report_on(model: Model, name: &str, reading: Reading) -> Result<Value, Error> {
    let format = model.format().unwrap_or(Format::Json);
    let report = Report::of(model).map_err(|error| error.in_file(name))?;
    let mut row = json!({"file": name, "format": format.name()});
    let limit = if reading.all_places { usize::MAX } else { PLACES };
    let facts =
        serde_json::to_value(report.answer(limit)).map_err(|error| Error::invalid(error.to_string()))?;
    if let (Value::Object(row), Value::Object(mut facts)) = (&mut row, facts) {
        // A row has the warnings.
        facts.remove("remarks");
        row.extend(facts);
    }
    Ok(row)
}

/// An error as an object with `kind`, `message` (with its place) and `cure` (null where there is none).
pub fn error_to_json(error: &Error) -> Value {
    let whole = error.to_string();
    let message = match error.cure() {
        Some(cure) => whole.strip_suffix(&format!("; {cure}")).unwrap_or(&whole),
        None => &whole,
    };
    json!({"kind": error.kind().word(), "message": message, "cure": error.cure()})
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::ErrorKind;

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
            request.reading =
                Reading { format: Some(Format::Svg), flatten: Some(0.125), volume, all_places: true };
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
    fn an_error_has_its_place_in_the_message_and_its_cure_beside_it() {
        let error = Error::parse("bad").at_line(3).in_file("a.off").with_cure("write a number");
        let expected = json!({"kind": "parse", "message": "a.off:3: bad", "cure": "write a number"});
        assert_eq!(error_to_json(&error), expected);
        let error = Error::new(ErrorKind::Io, "gone");
        assert_eq!(error_to_json(&error), json!({"kind": "io", "message": "gone", "cure": null}));
    }
}
