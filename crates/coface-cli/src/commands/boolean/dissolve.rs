//! `coface boolean union --dissolve`.

use super::{Boolean, Operation, Task};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::target::{Target, write_seen};
use clap::error::ErrorKind;
use coface::answers::answer::DissolveAnswer;
use coface::answers::text;
use coface::answers::{BooleanRequest, DissolveRequest, Dissolved, PlanarDrawing};
use coface::io::replace_file;
use std::path::Path;

/// How many groups the page lists.
const LISTED: usize = 20;

/// Refuses `--dissolve` with what is no union of a map.
pub(super) fn check(verb: &Boolean, task: &Task) -> Result<(), Failure> {
    if verb.dissolve.is_empty() || matches!(task, Task::Named(Operation::Union)) {
        return Ok(());
    }
    let message = "--dissolve unites features: the operation is union";
    Err(Failure::Usage(ErrorKind::ArgumentConflict, message.to_owned()))
}

pub(super) fn run(
    verb: &Boolean,
    drawing: &PlanarDrawing,
    request: BooleanRequest,
    common: &Common,
    output: Option<(&Path, Target)>,
    progress: Progress,
) -> Result<(), Failure> {
    let request = DissolveRequest::new(verb.dissolve.iter().cloned()).boolean(request);
    let dissolved = Dissolved::new(drawing, &request)?;
    let mut answer = dissolved.answer().clone();
    accept(&answer.remarks, common)?;
    progress.stage("writing");
    match output {
        Some((path, Target::Model(format))) => {
            answer.remarks.extend(dissolved.losses(format));
            replace_file(path, |out| dissolved.write(out, format))?;
        }
        Some((path, Target::Seen(seen))) => write_seen(path, dissolved.model(), seen)?,
        None => {}
    }
    drop(progress);
    say_remarks(&answer.remarks, common);
    if common.json {
        return print_json(&answer);
    }
    if common.output.is_some() {
        return Ok(());
    }
    print_text(&page(&answer))
}

fn page(answer: &DissolveAnswer) -> String {
    let mut facts = vec![
        ("area".to_owned(), text::number(answer.measure), "sum of all groups".to_owned()),
        ("groups".to_owned(), text::grouped(answer.groups.len()), String::new()),
        ("polygons".to_owned(), text::grouped(answer.f_vector[2]), String::new()),
    ];
    for group in answer.groups.iter().take(LISTED) {
        let values: Vec<String> = group.values.iter().map(ToString::to_string).collect();
        let gloss = format!(
            "area {}, {}, {}",
            text::number(group.measure),
            text::count(group.features, "feature"),
            text::count(group.polygons, "polygon")
        );
        facts.push(("group".to_owned(), values.join(", "), gloss));
    }
    if answer.groups.len() > LISTED {
        let rest = answer.groups.len() - LISTED;
        facts.push((String::new(), String::new(), format!("and {rest} more")));
    }
    text::facts(&format!("Features united by {}", answer.properties.join(", ")), &facts)
}
