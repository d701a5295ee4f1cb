//! `coface man`: manual pages.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::print_bytes;
use clap::Args;
use coface::io::{MadeFolders, replace_files};

/// Print the manual page in troff; with -o DIRECTORY write the pages of all verbs there.
///
/// For instance: coface man | man -l -
#[derive(Args)]
pub(crate) struct Man {}

impl Man {
    /// Prints or writes the pages of this program.
    pub(crate) fn run(&self, mut command: clap::Command, common: &Common) -> Result<(), Failure> {
        command.build();
        let Some(directory) = &common.output else {
            let page = rendered(command)?;
            return print_bytes(|out| out.write_all(&page));
        };
        // Gone again if the pages cannot be written.
        let _made = MadeFolders::of(directory)?;
        let page = |name: &str, command| -> Result<_, Failure> {
            Ok((directory.join(format!("{name}.1")), rendered(command)?))
        };
        let mut pages = vec![page("coface", command.clone())?];
        for verb in command.get_subcommands().filter(|verb| verb.get_name() != "help") {
            pages.push(page(&format!("coface-{}", verb.get_name()), verb.clone())?);
        }
        Ok(replace_files(&pages)?)
    }
}

fn rendered(command: clap::Command) -> Result<Vec<u8>, Failure> {
    let mut page = Vec::new();
    let name = command.get_display_name().unwrap_or(command.get_name()).to_owned();
    clap_mangen::Man::new(command)
        .title(name)
        .render(&mut page)
        .map_err(|error| Failure::new(format!("cannot make the manual page: {error}")))?;
    Ok(page)
}
