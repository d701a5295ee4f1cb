//! What decides how much of a drawing is seen and is not done here.

use super::style::{Property, Style};
use crate::{Remark, RemarkCode};

/// How many elements have it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Undone {
    /// Clip paths that are no shapes of this file.
    pub(super) clip_paths: usize,
    /// Masks with other content than white and black shapes.
    pub(super) masks: usize,
    /// Elements whose shape or place a style says.
    geometry: usize,
    /// Rules and style sheets.
    pub(super) rules: usize,
    /// Paint servers that are not there.
    pub(super) paints: usize,
    /// Copies of what they are in themselves.
    pub(super) circles: usize,
}

impl Undone {
    /// Notes what an element has.
    pub(super) fn note(&mut self, style: &Style<'_>, is_root: bool) {
        self.geometry += usize::from(!is_root && style.has(Property::Geometry));
    }

    /// One remark about all that is not done, and one about what is nothing by the rules of SVG, if there is any.
    pub(super) fn remarks(&self) -> impl Iterator<Item = Remark> {
        self.unknown_remark().into_iter().chain(self.void_remark())
    }

    fn void_remark(&self) -> Option<Remark> {
        let parts = [
            one_or(
                self.paints,
                "paint by url(#..) that is not in the file",
                "paints by url(#..) that are not in the file",
            ),
            one_or(self.circles, "use of what it is in", "uses of what they are in"),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        let count = self.paints + self.circles;
        (count > 0).then(|| {
            let message = format!("these paint nothing, as SVG says: {}", parts.join(", "));
            Remark::new(RemarkCode::DrawingAssumption, message).at(count, [])
        })
    }

    fn unknown_remark(&self) -> Option<Remark> {
        let parts = [
            one_or(self.clip_paths, "clip-path", "clip-paths"),
            one_or(self.masks, "mask", "masks"),
            one_or(
                self.geometry,
                "element whose shape or place is in its style",
                "elements whose shapes or places are in their style",
            ),
            one_or(self.rules, "rule or file of a style sheet", "rules or files of style sheets"),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        let count = self.clip_paths + self.masks + self.geometry + self.rules;
        (count > 0).then(|| {
            let message = format!("shapes are read as if there were none of these: {}", parts.join(", "));
            Remark::new(RemarkCode::DrawingAssumption, message).at(count, [])
        })
    }
}

fn one_or(count: usize, one: &str, many: &str) -> Option<String> {
    match count {
        0 => None,
        1 => Some(format!("1 {one}")),
        _ => Some(format!("{count} {many}")),
    }
}
