//! Which formats models are written in: known before there is a model.

use crate::{Format, format};
use coface_algebra::{Error, ErrorKind};
use std::path::Path;

/// The format in which a model is written to a file of this name.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] when the name belongs to no format, or to one in which no model is written.
#[doc(hidden)]
pub fn format_of_output(path: &Path) -> Result<Format, Error> {
    let in_file = |error: Error| error.in_file(path.display().to_string());
    let Some(format) = Format::from_path(path) else {
        let fault = match path.extension() {
            Some(extension) => format!("the extension \"{}\" is no format known here", extension.display()),
            None => "the name has no extension, which tells the format".to_owned(),
        };
        return Err(in_file(
            Error::new(ErrorKind::UnsupportedFormat, fault)
                .with_cure(format!("end it in one of {}", format::names_of_written())),
        ));
    };
    never_written(format).map_or(Ok(format), |error| Err(in_file(error)))
}

/// Why no model is written in this format; `None` where some are.
#[doc(hidden)]
pub fn never_written(format: Format) -> Option<Error> {
    let refused = |message: String, cure: &str| {
        Some(Error::new(ErrorKind::UnsupportedFormat, message).with_cure(cure.to_owned()))
    };
    match format {
        Format::Dat => refused(
            ".dat holds sets of the plane, not models".to_owned(),
            "write another format; of a drawing coface yin info INPUT -o OUT.dat makes a set",
        ),
        Format::Png => refused(
            "a PNG image is read as a volume, and not written".to_owned(),
            "draw the model by coface render INPUT -o OUT.png; a volume is written as .npy",
        ),
        Format::Nrrd | Format::Nifti | Format::MetaImage | Format::Pgm => {
            refused(format!("{} is read, not written", format.title()), "write a volume as .npy")
        }
        Format::MatrixMarket => refused(
            "Matrix Market holds a matrix, not a model".to_owned(),
            "write .json or .cfc; coface incidence INPUT VE --signed -o OUT.mtx writes a boundary matrix",
        ),
        _ if format.is_read_only() => refused(
            format!("{} is read, not written", format.title()),
            "write a mesh as OBJ, PLY, MSH or VTK",
        ),
        _ => None,
    }
}
