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
    check_output(place)?;
    refuse_standard_input(inputs)?;
    common.points.refuse(&format!("{verb} with a certificate"))
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
