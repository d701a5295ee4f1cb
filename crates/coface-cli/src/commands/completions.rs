//! `coface completions`: completions for a shell.

use crate::failure::Failure;
use crate::output::print_bytes;
use clap::Args;
use clap_complete::Shell;

/// Print completions for a shell.
///
/// For instance: coface completions bash > ~/.local/share/bash-completion/completions/coface
#[derive(Args)]
pub(crate) struct Completions {
    /// The shell
    shell: Shell,
}

impl Completions {
    /// Prints completions for this program.
    pub(crate) fn run(&self, program: &mut clap::Command) -> Result<(), Failure> {
        // Made in memory first: the generator takes a failure to write for a fault of its own.
        let mut script = Vec::new();
        clap_complete::generate(self.shell, program, "coface", &mut script);
        print_bytes(|out| out.write_all(&script))
    }
}
