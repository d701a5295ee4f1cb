//! Phases that move together.

use super::{Advect, Motion, named_rules, numbered};
use crate::arguments::Common;
use crate::commands::yin::interface::{InterfaceOutput, page};
use crate::failure::Failure;
use crate::input;
use crate::output::{print_json, print_text, write_file};
use crate::progress::Progress;
use crate::remarks::say_remarks;
use coface::answers::{MotionRequest, PlanarInterface};
use coface::io::StagedFiles;

impl Advect {
    /// Moves an interface.
    pub(super) fn run_phases(
        &self,
        flow: &Motion,
        request: &MotionRequest,
        common: &Common,
    ) -> Result<(), Failure> {
        if request.events || request.on_contact.is_some() {
            return Err(Failure::new(
                "--events and --on-contact are of one set: leave them out, or write the phases with `coface yin interface --sets` and move one",
            ));
        }
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
            (false, Some(_)) => Ok(()),
            (false, None) => print_text(&page("Moved interface", &answer.interface)),
        }
    }
}
