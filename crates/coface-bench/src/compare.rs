//! Measures a task beside other programs on the same file, in turns.

use crate::arguments::{Arguments, Peer};
use crate::measure::measure;
use crate::store::Store;
use crate::table::Row;
use crate::tasks;
use coface::Error;
use std::path::Path;
use std::process::Command;

/// Runs ours and each peer in turns, `runs` times each, and prints the rows and the ratios of the medians.
///
/// Turns make a shared machine treat all alike: what slows one run slows its neighbors too.
///
/// # Errors
/// For an unknown task or input, or a program that fails.
pub(crate) fn compare(task: &str, input: &str, peers: &[Peer], arguments: &Arguments) -> Result<(), Error> {
    let task = tasks::find(task)?;
    let store = Store::new()?;
    let path = store.file(input, task.extension)?;
    let row = |program: &str| Row {
        task: task.name.to_owned(),
        input: input.to_owned(),
        program: program.to_owned(),
        runs: Vec::new(),
    };
    let mut rows: Vec<Row> =
        std::iter::once(row("coface")).chain(peers.iter().map(|peer| row(&peer.label))).collect();
    for _ in 0..arguments.runs {
        rows[0].runs.push(measure(&mut task.command(&path, arguments.threads)?)?);
        for (peer, row) in peers.iter().zip(&mut rows[1..]) {
            row.runs.push(measure(&mut peer_command(peer, &path))?);
        }
    }
    println!("{}", Row::heading());
    for row in &rows {
        println!("{}", row.to_text());
        if let Some(json) = &arguments.json {
            row.append_to(json)?;
        }
    }
    for row in &rows[1..] {
        println!(
            "ratio {} / coface = {:.2} (processor time {:.2})",
            row.program,
            row.seconds() / rows[0].seconds(),
            row.cpu_seconds() / rows[0].cpu_seconds()
        );
    }
    Ok(())
}

/// The peer's command with the path in the place of `{}`, or at the end.
fn peer_command(peer: &Peer, path: &Path) -> Command {
    let mut command = Command::new(&peer.command[0]);
    let mut is_placed = false;
    for word in &peer.command[1..] {
        if word == "{}" {
            command.arg(path);
            is_placed = true;
        } else {
            command.arg(word);
        }
    }
    if !is_placed {
        command.arg(path);
    }
    command
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_path_takes_the_place_of_the_braces() {
        let words = |command: &[&str]| {
            let peer =
                Peer { label: String::new(), command: command.iter().map(|&w| w.to_owned()).collect() };
            let built = peer_command(&peer, Path::new("x.raw"));
            built.get_args().map(|w| w.to_string_lossy().into_owned()).collect::<Vec<_>>()
        };
        assert_eq!(words(&["prog", "{}", "-v"]), ["x.raw", "-v"]);
        assert_eq!(words(&["prog", "star"]), ["star", "x.raw"]);
    }
}
