//! `coface check`.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::give;
use clap::Args;
use coface::answers::answer::CheckAnswer;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Checks a certificate of another run against its input, without any code of what computed the answer.
///
/// Says what was proved, and which keys of the answer were not checked. Exit status 0: verified; 1: a step fails, which is
/// named, or the certificate is of another input.
#[derive(Args)]
pub(crate) struct Check {
    /// What --certificate wrote
    #[arg(value_name = "CERTIFICATE")]
    certificate: PathBuf,
    /// The input of that run; the file that the certificate names if it is left out
    #[arg(value_name = "INPUT")]
    input: Option<PathBuf>,
}

impl Check {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let certificate = bytes(&self.certificate)?;
        let input = match &self.input {
            Some(input) => input.clone(),
            None => coface_check::input_name(&certificate).map(PathBuf::from).ok_or_else(|| {
                let place = self.certificate.display();
                Failure::new(format!(
                    "{place}: no input is named there; name it: coface check CERTIFICATE INPUT"
                ))
            })?,
        };
        let verdict = coface_check::check(&certificate, &bytes(&input)?).map_err(|fault| {
            Failure::new(format!("{}: not verified: {fault}", self.certificate.display()))
        })?;
        let answer = CheckAnswer {
            certificate: self.certificate.display().to_string(),
            file: input.display().to_string(),
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
    // A certificate of a stranger may name a device, which never ends.
    if !path.is_file() {
        return Err(Failure::new(format!("{place}: there is no such regular file; check the path")));
    }
    std::fs::read(path).map_err(|error| Failure::new(format!("{place}: cannot be read: {error}")))
}

fn page(answer: &CheckAnswer) -> String {
    let mut page = format!("verified: {}\n", answer.file);
    for claim in &answer.proved {
        let _ = writeln!(page, "  proved     {claim}");
    }
    for key in &answer.unchecked {
        let _ = writeln!(page, "  unchecked  \"{key}\" of the answer");
    }
    page
}
