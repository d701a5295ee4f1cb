//! `coface man`: manual pages.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::{print_bytes, write_file};
use clap::Args;
use std::path::Path;

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
        std::fs::create_dir_all(directory)
            .map_err(|error| Failure::new(format!("{}: cannot write: {error}", directory.display())))?;
        let verbs: Vec<clap::Command> =
            command.get_subcommands().filter(|verb| verb.get_name() != "help").cloned().collect();
        write_page(directory, "coface", command)?;
        for verb in verbs {
            let name = format!("coface-{}", verb.get_name());
            write_page(directory, &name, verb)?;
        }
        Ok(())
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

fn write_page(directory: &Path, name: &str, command: clap::Command) -> Result<(), Failure> {
    write_file(&directory.join(format!("{name}.1")), &rendered(command)?)
}
