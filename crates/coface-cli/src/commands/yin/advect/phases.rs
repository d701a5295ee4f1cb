//! Phases that move together.

use super::{Advect, Motion, named_rules, numbered};
use crate::arguments::Common;
use crate::commands::yin::interface::{InterfaceOutput, page};
use crate::commands::yin::page::LISTED_EVENTS;
use crate::failure::Failure;
use crate::input;
use crate::output::{print_json, print_text, write_file};
use crate::progress::Progress;
use crate::remarks::say_remarks;
use coface::answers::answer::{YinInterfaceAnswer, YinInterfaceEventAnswer};
use coface::answers::{MotionRequest, PlanarInterface, text};
use coface::io::StagedFiles;

impl Advect {
    /// Moves an interface.
    pub(super) fn run_phases(
        &self,
        flow: &Motion,
        request: &MotionRequest,
        common: &Common,
    ) -> Result<(), Failure> {
        let output = InterfaceOutput::new(&self.options, common)?;
        let progress = Progress::start(common.quiet);
        let interface = self.phases.read(&self.inputs, &self.options, common, &progress)?;
        let files: Vec<String> = self.inputs.iter().map(|path| input::name(path)).collect();
        let count = request.frames;
        let stage = |frame: usize| progress.stage(format!("moving, part {frame} of {count}"));
        // Interfaces of the way are written as they come, and appear when all is done.
        let path = common.output.as_deref().filter(|_| count > 1);
        let mut staged = path.map(StagedFiles::beside).transpose()?;
        let mut frames = Vec::new();
        let take = |number: usize, interface: &PlanarInterface| {
            let (Some(path), Some(staged)) = (path, &mut staged) else { return Ok(()) };
            let path = numbered(path, number);
            let bytes = output.bytes(interface, &self.inputs)?;
            staged.write(&path, |out| Ok(out.write_all(&bytes)?))?;
            frames.push(path.display().to_string());
            Ok(())
        };
        let motion = interface.moved(|point, time| flow.velocity(point, time), request, stage, take);
        let motion = motion.map_err(|error| named_rules(error).in_file(files.join(", ")))?;
        progress.stage("measuring");
        let answer = motion.answer(&files, frames)?;
        progress.stage("writing");
        if let Some(staged) = staged {
            staged.finish()?;
        }
        self.phases.write_sets(motion.last(), &self.options, common)?;
        if let Some(path) = &common.output {
            write_file(path, &output.bytes(motion.last(), &self.inputs)?)?;
        }
        drop(progress);
        say_remarks(interface.remarks(), common);
        say_remarks(&motion.remarks(), common);
        match (common.json, &common.output) {
            (true, _) => print_json(&answer),
            (false, Some(_)) if answer.events.is_none() => Ok(()),
            (false, _) => {
                print_text(&page("Moved interface", &answer.interface))?;
                answer
                    .events
                    .as_deref()
                    .map_or(Ok(()), |events| print_text(&events_page(events, &answer.interface)))
            }
        }
    }
}

/// The changes of the topology, one by one.
fn events_page(events: &[YinInterfaceEventAnswer], interface: &YinInterfaceAnswer) -> String {
    let mut facts =
        vec![("events".to_owned(), text::grouped(events.len()), "changes of the topology".to_owned())];
    for event in events.iter().take(LISTED_EVENTS) {
        let names: Vec<&str> =
            event.phases.iter().map(|&phase| interface.phases[phase as usize].name.as_str()).collect();
        let [x, y] = event.place.map(text::number);
        let counts = [event.before, event.after].map(|counts| {
            counts.map(|own| {
                let components = text::count(own.components, "component");
                format!("{components}, {}", text::count(own.holes, "hole"))
            })
        });
        let change = match counts {
            [Some(before), Some(after)] => format!(": {before} -> {after}"),
            _ => String::new(),
        };
        facts.push((
            String::new(),
            format!("at time {} {}", text::number(event.time), event.words),
            format!("{} near ({x}, {y}){change}", names.join(", ")),
        ));
    }
    if events.len() > LISTED_EVENTS {
        let more = format!("and {} more", text::grouped(events.len() - LISTED_EVENTS));
        facts.push((String::new(), more, String::new()));
    }
    text::facts("Events", &facts)
}
