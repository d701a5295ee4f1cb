//! `coface check`.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::give;
use clap::Args;
use coface::answers::answer::CheckAnswer;
use std::fmt::Write;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Checks a certificate of another run against its input, without any code of what computed the answer.
///
/// Says what was proved, and which keys of the answer were not checked. Exit status 0: verified; 1: a step fails, which is
/// named, or the certificate is of another input.
#[derive(Args)]
pub(crate) struct Check {
    /// What --certificate wrote; - is standard input, and compressed ones are unpacked
    #[arg(value_name = "CERTIFICATE")]
    certificate: PathBuf,
    /// The inputs of that run in their order, byte for byte, one of which may be - for standard input; the files that the certificate names if they
    /// are left out
    #[arg(value_name = "INPUT")]
    inputs: Vec<PathBuf>,
}

impl Check {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let in_standard_input = |path: &&PathBuf| path.as_path() == Path::new("-");
        if self.inputs.iter().chain([&self.certificate]).filter(in_standard_input).count() > 1 {
            return Err(Failure::new(
                "standard input can be one of the files only; write the others to files",
            ));
        }
        let certificate = coface::io::unpacked_bytes(&bytes(&self.certificate)?[..])
            .map_err(|error| Failure::new(format!("{}: {error}", self.certificate.display())))?;
        // The mark of Unicode, which some shells write.
        let certificate = certificate.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&certificate);
        let refused = |fault: coface_check::Fault| {
            Failure::new(format!("{}: not verified: {fault}", self.certificate.display()))
        };
        let mut inputs = self.inputs.clone();
        if inputs.is_empty() {
            let names = coface_check_binary::input_names(certificate).map_err(refused)?;
            inputs = names.into_iter().map(PathBuf::from).collect();
        }
        if inputs.is_empty() {
            let place = self.certificate.display();
            return Err(Failure::new(format!(
                "{place}: no input is named there; name it: coface check CERTIFICATE INPUT"
            )));
        }
        let read = inputs.iter().map(|input| bytes(input)).collect::<Result<Vec<_>, _>>()?;
        let read: Vec<&[u8]> = read.iter().map(Vec::as_slice).collect();
        let verdict = coface_check_binary::check(certificate, &read).map_err(refused)?;
        let answer = CheckAnswer {
            certificate: self.certificate.display().to_string(),
            files: inputs.iter().map(|input| input.display().to_string()).collect(),
            verified: true,
            proved: verdict.proved().to_vec(),
            unchecked: verdict.unchecked().to_vec(),
            remarks: Vec::new(),
        };
        give(common, &answer, &page(&answer))
    }
}

fn bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    let place = path.display();
    if path == Path::new("-") {
        let mut bytes = Vec::new();
        let read = std::io::stdin().lock().read_to_end(&mut bytes);
        return read
            .map(|_| bytes)
            .map_err(|error| Failure::new(format!("standard input cannot be read: {error}")));
    }
    // A certificate of a stranger may name a device, which never ends.
    if !path.is_file() {
        return Err(Failure::new(format!("{place}: there is no such regular file; check the path")));
    }
    std::fs::read(path).map_err(|error| Failure::new(format!("{place}: cannot be read: {error}")))
}

fn page(answer: &CheckAnswer) -> String {
    let mut page = format!("verified: {}\n", answer.files.join(", "));
    for claim in &answer.proved {
        let _ = writeln!(page, "  proved     {claim}");
    }
    for key in &answer.unchecked {
        let _ = writeln!(page, "  unchecked  \"{key}\" of the answer");
    }
    page
}
