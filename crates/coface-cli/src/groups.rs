//! What the verbs on fundamental groups share: asking, closed paths in files, and lines for people.

use crate::arguments::{Common, Limit, time_limit};
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, write_json};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::surface::{self, Solid};
use crate::target::write_model;
use coface::algebra::{RaggedArray, Word};
use coface::answers::answer::{ClosedPath, WalkAnswer, WalkPair};
use coface::answers::{FoundGroups, GivenWalks, GroupsRequest, Producer};
use coface::io::Model;
use coface::{Error, ErrorKind};
use serde::Serialize;
use serde_json::Value;
use std::path::Path;
use std::time::Duration;

/// A row of a page: a label, a value and a gloss.
pub(crate) type Fact = (String, String, String);

/// How many relators, vertices or pairs a page for people shows of one thing.
pub(crate) const FEW: usize = 12;

/// A model with its groups.
pub(crate) struct Asked {
    pub(crate) name: String,
    pub(crate) found: FoundGroups,
    pub(crate) producer: Producer,
    /// What is wrong with the positions, where some are not finite.
    fault: Option<Error>,
}

impl Asked {
    /// Reads a model and asks about its groups. Of a model that is no surface the message begins its cure with `other`.
    pub(crate) fn of(
        input: &Path,
        request: &GroupsRequest,
        other: Option<&str>,
        common: &Common,
        progress: &Progress,
    ) -> Result<Self, Failure> {
        let (name, producer): (String, Producer) = input::produce(input, common.reading(), progress)?;
        let found = request.found(&producer).map_err(|error: Error| match error.kind() {
            ErrorKind::NonManifold => {
                let cure = surface::cure(&error, Solid::of(&producer));
                let cure = other.map_or_else(|| cure.to_owned(), |other| format!("{other}, or {cure}"));
                error.with_cure(cure).in_file(name.clone())
            }
            _ => error.in_file(name.clone()),
        })?;
        accept(found.remarks(), common)?;
        say_remarks(found.remarks(), common);
        let fault = producer.require_finite().err();
        Ok(Self { name, found, producer, fault })
    }

    /// Writes closed paths as JSON, or as polylines in a format that has positions.
    pub(crate) fn write(&self, paths: &[&[u32]], place: &Path, progress: &Progress) -> Result<(), Failure> {
        progress.stage(format!("writing {}", place.display()));
        if is_json(place) {
            return write_json(place, &Loops { loops: paths });
        }
        if let Some(fault) = &self.fault {
            return Err(fault.clone().in_file(self.name.clone()).into());
        }
        if self.producer.positions().dimension() == 0 {
            return Err(Failure::new(format!(
                "{}: the model has no positions to draw loops with; write them as .json",
                place.display()
            )));
        }
        let lines = RaggedArray::from_lists(paths.iter().filter(|vertices| vertices.len() > 1));
        write_model(place, &Model::from_lines(self.producer.positions().clone(), lines)?)
    }

    /// Writes the short closed paths, or else the loops.
    pub(crate) fn write_paths(&self, place: &Path, progress: &Progress) -> Result<(), Failure> {
        let paths: Vec<&[u32]> = match self.found.short_paths() {
            Some(paths) => paths.iter().map(|path| &path.vertices[..]).collect(),
            None => self.found.loops().collect(),
        };
        self.write(&paths, place, progress)
    }
}

/// Closed paths in a file.
#[derive(Serialize)]
struct Loops<'a> {
    loops: &'a [&'a [u32]],
}

/// Reads `{"walks":[[v0,v1,..,v0],..]}`, the same with "loops", or the bare list.
pub(crate) fn walks_in(path: &Path) -> Result<GivenWalks, Failure> {
    let place = path.display().to_string();
    let text = std::fs::read_to_string(path).map_err(|error| Error::from(error).in_file(place.clone()))?;
    let how = "write closed paths of vertices as {\"walks\":[[v0,v1,..,v0],..]}";
    let value: Value = serde_json::from_str(&text)
        .map_err(|error| Failure::new(format!("{place}:{}: {error}; {how}", error.line())))?;
    let lists = value.get("walks").or_else(|| value.get("loops")).unwrap_or(&value);
    let walks = serde_json::from_value(lists.clone())
        .map_err(|error| Failure::new(format!("{place}: {error}; {how}")))?;
    Ok(GivenWalks { place, walks })
}

/// How long simplifying may take.
pub(crate) fn effort(text: &str) -> Result<Limit<Duration>, String> {
    // No time at all is a sensible request: simplify nothing.
    if text.trim() == "0" { Ok(Limit(Some(Duration::ZERO))) } else { time_limit(text) }
}

/// What is known of walks, and of all pairs of them up to `limit`.
pub(crate) fn facts_of_walks(walks: &[WalkAnswer], pairs: &[WalkPair], limit: usize) -> Vec<Fact> {
    let fact = |label: String, value: String| (label, value, String::new());
    let mut facts = Vec::new();
    for (i, walk) in walks.iter().enumerate().take(limit) {
        let word = Word::from_letters(walk.word.iter().copied());
        let verdict = match (walk.contractible, walk.bounds) {
            (true, _) => "can be contracted".to_owned(),
            (false, true) => format!("bounds, but cannot be contracted: {word}"),
            (false, false) => format!("does not bound: {word}"),
        };
        facts.push(fact(format!("walk {}", i + 1), verdict));
    }
    if walks.len() > limit {
        facts.push(fact(String::new(), format!("and {} more walks (--all prints all)", walks.len() - limit)));
    }
    for pair in pairs.iter().take(limit) {
        let verdict = match (pair.homotopic, pair.freely_homotopic, pair.homologous) {
            (Some(true), ..) => "homotopic with the base fixed",
            (_, true, _) => "freely homotopic",
            (_, _, true) => "homologous, but not homotopic",
            _ => "not homologous",
        };
        let [i, j] = pair.walks.map(|walk| walk + 1);
        facts.push(fact(format!("walks {i}, {j}"), verdict.to_owned()));
    }
    if pairs.len() > limit {
        facts.push(fact(String::new(), format!("and {} more pairs (--all prints all)", pairs.len() - limit)));
    }
    facts
}

/// A closed path for people: its length, and the vertices that it begins with.
pub(crate) fn fact_of_path(label: &str, path: &ClosedPath, limit: usize) -> Fact {
    let few: Vec<String> = path.vertices.iter().take(limit).map(u32::to_string).collect();
    let more = if path.vertices.len() > limit { " .." } else { "" };
    let gloss = format!("long, through {}{more}", few.join(" "));
    (label.to_owned(), format!("{:.6}", path.length), gloss)
}

/// That no closed path is of the kind that was asked for.
pub(crate) fn no_paths() -> Fact {
    ("cycles".to_owned(), "none".to_owned(), "no closed path is of this kind".to_owned())
}
