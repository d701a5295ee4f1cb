//! What an input is: a set, a phase of an interface, or an interface.

use super::{Ends, SetOptions};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input::{self, Source};
use crate::output::is_json;
use crate::progress::Progress;
use crate::remarks::{accept, take};
use coface::answers::answer::YinInterfaceAnswer;
use coface::answers::{NamedSet, PlanarInterface, PlanarSet};
use coface::io;
use coface::io::yin::BoundaryDrawing;
use coface::io::{Format, ReadOptions};
use coface::yin::Order;
use std::path::{Path, PathBuf};

/// What an input is.
pub(super) enum Given {
    Set(PlanarSet),
    Interface(PlanarInterface),
}

/// The file of an input and the phase in it: `rooms.json#kitchen`, or `rooms.json#0`. A file with a # in its name is that file.
fn file_and_phase(path: &Path) -> (PathBuf, Option<String>) {
    if let Some(text) = path.to_str().filter(|_| !path.exists()) {
        for (at, _) in text.match_indices('#') {
            let file = &text[..at];
            if file == "-" || Path::new(file).is_file() {
                return (file.into(), Some(text[at + 1..].to_owned()));
            }
        }
    }
    (path.to_owned(), None)
}

/// The interface of an answer in a file.
fn interface_of(answer: &YinInterfaceAnswer, name: &str) -> Result<PlanarInterface, Failure> {
    let found = PlanarInterface::of_answer(answer);
    Ok(found.map_err(|error| error.in_file(name.to_owned()))?)
}

/// The answer that a whole file is, if it is that of an interface.
pub(super) fn interface_answer(path: &Path) -> Result<Option<YinInterfaceAnswer>, Failure> {
    let (file, phase) = file_and_phase(path);
    if phase.is_some() {
        return Ok(None);
    }
    let found = Source::of(&file)?.interface();
    Ok(found.map_err(|error| error.in_file(input::name(path)))?)
}

/// The interface that a whole file is, if it is one.
pub(super) fn interface(path: &Path) -> Result<Option<PlanarInterface>, Failure> {
    interface_answer(path)?.map(|answer| interface_of(&answer, &input::name(path))).transpose()
}

/// Whether an input is a phase of an interface.
pub(super) fn is_phase(path: &Path) -> bool {
    file_and_phase(path).1.is_some()
}

impl SetOptions {
    /// Reads a file as these options say: as a set, or as an interface.
    pub(super) fn given(&self, path: &Path, common: &Common, progress: &Progress) -> Result<Given, Failure> {
        progress.stage(format!("reading {}", input::name(path)));
        match interface(path)? {
            Some(interface) => {
                self.check_interface(path)?;
                accept(interface.remarks(), common)?;
                Ok(Given::Interface(interface))
            }
            None => self.read(path, common, false, progress).map(Given::Set),
        }
    }

    /// Refuses options that an interface has no use for.
    pub(super) fn check_interface(&self, path: &Path) -> Result<(), Failure> {
        self.check_interface_but(path, &[])
    }

    /// Refuses options that an interface has no use for, but for some.
    pub(super) fn check_interface_but(&self, path: &Path, allowed: &[&str]) -> Result<(), Failure> {
        let given = [
            ("--order", self.order.is_some()),
            ("--rule", self.rule.is_some()),
            ("--kinks", self.kinks.is_some()),
            ("--canonical", self.canonical),
            ("--ends natural", self.ends == Ends::Natural),
        ];
        let found = given.iter().find(|(option, is_given)| *is_given && !allowed.contains(option));
        let Some((option, _)) = found else { return Ok(()) };
        let name = input::name(path);
        Err(Failure::new(format!(
            "{name}: {option} is of one set, and this is an interface; leave it out, or name a phase, as in coface yin info {name}#0"
        )))
    }

    /// Reads a file as an interface, if it is one, with options that it has a use for.
    pub(super) fn given_interface(
        &self,
        path: &Path,
        allowed: &[&str],
        common: &Common,
        progress: &Progress,
    ) -> Result<Option<PlanarInterface>, Failure> {
        progress.stage(format!("reading {}", input::name(path)));
        let Some(interface) = interface(path)? else { return Ok(None) };
        self.check_interface_but(path, allowed)?;
        accept(interface.remarks(), common)?;
        Ok(Some(interface))
    }

    /// Reads a file as one set.
    pub(super) fn read(
        &self,
        path: &Path,
        common: &Common,
        fit: bool,
        progress: &Progress,
    ) -> Result<PlanarSet, Failure> {
        let mut request = self.request(common);
        request.fit = fit;
        let name = input::name(path);
        let drawing = self.drawing(path, common, progress)?;
        progress.stage("checking");
        let set = PlanarSet::of(&drawing, &request).map_err(|error| error.in_file(name.clone()))?;
        accept(set.remarks(), common)?;
        take(&name, set.remarks());
        Ok(set)
    }

    /// Sets that an image gives, with the order and the kinks that these options ask for.
    pub(super) fn applied(
        &self,
        sets: Vec<NamedSet>,
        common: &Common,
    ) -> Result<Vec<NamedSet>, coface::Error> {
        if self.order.is_none() && self.kinks.is_none() {
            return Ok(sets);
        }
        let request = self.request(common);
        let apply = |one: NamedSet| {
            let drawing = drawing_of(&one.set, &ReadOptions::default())?;
            Ok(NamedSet::new(one.name, PlanarSet::of(&drawing, &request)?))
        };
        sets.into_iter().map(apply).collect()
    }

    /// Reads what a file says about the boundary of one set.
    pub(super) fn drawing(
        &self,
        path: &Path,
        common: &Common,
        progress: &Progress,
    ) -> Result<BoundaryDrawing, Failure> {
        let name = input::name(path);
        progress.stage(format!("reading {name}"));
        let mut reading = common.reading();
        if self.order != Some(Order::LINEAR) {
            // Curves stay curves: it is on output that they may have to become chords.
            reading = reading.flatten(None);
        }
        let (file, phase) = file_and_phase(path);
        let source = Source::of(&file)?;
        let in_file = |error: coface::Error| error.in_file(name.clone());
        match (source.interface().map_err(in_file)?, phase) {
            (None, None) => Ok(source.boundary(&reading).map_err(in_file)?),
            // One of several sets in a file.
            (None, Some(_)) if is_json(&file) => Ok(io::read_boundary_path(path, &reading)?),
            (None, Some(_)) => {
                let file = input::name(&file);
                Err(Failure::new(format!(
                    "{name}: {file} is no interface, and has no phases; give the file alone, as in coface yin info {file}"
                )))
            }
            (Some(answer), None) => {
                let count = answer.phases.len();
                Err(Failure::new(match count {
                    0 => {
                        format!("{name}: it is an interface without phases, and not a set; give another file")
                    }
                    _ => format!(
                        "{name}: it is an interface of {count} phases, and not one set; name a phase by its number or its name, as in coface yin info {name}#0"
                    ),
                }))
            }
            (Some(answer), Some(phase)) => {
                let found = interface_of(&answer, &input::name(&file))?.phase(&phase).map_err(in_file)?;
                Ok(drawing_of(&found, &reading)?)
            }
        }
    }
}

/// A set as its file would have it, bit for bit.
fn drawing_of(set: &PlanarSet, reading: &ReadOptions) -> Result<BoundaryDrawing, coface::Error> {
    let mut text = Vec::new();
    set.write(&mut text, Format::Json, None)?;
    io::read_boundary_with(&text[..], &reading.format(Format::Json))
}
