//! `--certificate`: proofs of answers, which are of files.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::write_file;
use coface::io::check_output;
use std::path::{Path, PathBuf};

/// What can be known before the work: the certificate has a place, and is of a file as it is.
pub(crate) fn check_place(
    place: &Path,
    inputs: &[PathBuf],
    verb: &str,
    common: &Common,
) -> Result<(), Failure> {
    check_other_output(place, inputs, common)?;
    refuse_standard_input(inputs)?;
    common.points.refuse(&format!("{verb} with a certificate"))
}

/// Whether a file can be written that stands beside the answer: it is neither an input nor what `-o` writes.
pub(crate) fn check_other_output(place: &Path, inputs: &[PathBuf], common: &Common) -> Result<(), Failure> {
    check_output(place)?;
    let place_of = |path: &Path| path.canonicalize().or_else(|_| std::path::absolute(path)).ok();
    let is_this = |path: &Path| place_of(path).is_some_and(|path| Some(path) == place_of(place));
    let fault = if inputs.iter().any(|input| is_this(input)) {
        "the file is an input, and would be replaced"
    } else if common.output.as_deref().is_some_and(is_this) {
        "-o writes the same file"
    } else {
        return Ok(());
    };
    Err(Failure::new(format!("{}: {fault}; name another file", place.display())))
}

/// A certificate has the hash of a file.
pub(crate) fn refuse_standard_input(inputs: &[PathBuf]) -> Result<(), Failure> {
    if inputs.iter().any(|input| input == Path::new("-")) {
        return Err(Failure::new(
            "standard input: a certificate is of a file; write the input to a file first, or leave --certificate out",
        ));
    }
    Ok(())
}

/// Whether a certificate is to have the binary form, by the name of its file.
fn is_binary(place: &Path) -> bool {
    place.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("bin"))
}

/// Writes the certificate of an answer about these files, from their names and bytes: JSON, or the binary form in a file .bin.
pub(crate) fn save(
    place: &Path,
    files: &[PathBuf],
    certificate: impl FnOnce(&[(&str, &[u8])]) -> Result<String, coface::Error>,
) -> Result<(), Failure> {
    let names: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
    let read = names.iter().zip(files).map(|(name, file)| {
        std::fs::read(file).map_err(|error| {
            Failure::new(format!("{name}: cannot be read again for the certificate: {error}"))
        })
    });
    let read = read.collect::<Result<Vec<_>, _>>()?;
    let inputs: Vec<(&str, &[u8])> =
        names.iter().map(String::as_str).zip(read.iter().map(Vec::as_slice)).collect();
    let certificate = certificate(&inputs).map_err(|error| error.in_file(names[0].clone()))?;
    if !is_binary(place) {
        return write_file(place, certificate.as_bytes());
    }
    let packed = coface_check_binary::packed(certificate.as_bytes())
        .map_err(|fault| Failure::new(format!("{}: {fault}", place.display())))?;
    write_file(place, &packed)
}
