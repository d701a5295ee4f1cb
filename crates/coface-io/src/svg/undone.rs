//! What decides how much of a drawing is seen and is not done here.

use super::style::{Property, Style};
use super::transformation::Transformation;
use crate::{Remark, RemarkCode};

/// How many elements have it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Undone {
    clip_paths: usize,
    masks: usize,
    /// Shapes that go beyond the box of an `svg` or a `symbol` inside.
    pub(super) beyond: usize,
    /// Elements whose shape or place a style says.
    geometry: usize,
    /// Rules and style sheets.
    pub(super) rules: usize,
}

impl Undone {
    /// Notes what an element has.
    pub(super) fn note(&mut self, style: &Style<'_>, is_root: bool) {
        self.clip_paths += usize::from(style.has(Property::ClipPath));
        self.masks += usize::from(style.has(Property::Mask));
        self.geometry += usize::from(!is_root && style.has(Property::Geometry));
    }

    /// One remark about all of it, if there is any.
    pub(super) fn remark(&self) -> Option<Remark> {
        let one_or = |count: usize, one: &str, many: &str| match count {
            0 => None,
            1 => Some(format!("1 {one}")),
            _ => Some(format!("{count} {many}")),
        };
        let parts = [
            one_or(self.clip_paths, "clip-path", "clip-paths"),
            one_or(self.masks, "mask", "masks"),
            one_or(
                self.beyond,
                "shape that goes beyond the box of an inner <svg> or <symbol>",
                "shapes that go beyond the boxes of inner <svg> or <symbol>",
            ),
            one_or(
                self.geometry,
                "element whose shape or place is in its style",
                "elements whose shapes or places are in their style",
            ),
            one_or(self.rules, "rule or file of a style sheet", "rules or files of style sheets"),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        let count = self.clip_paths + self.masks + self.beyond + self.geometry + self.rules;
        (count > 0).then(|| {
            let message = format!("shapes are read as if there were none of these: {}", parts.join(", "));
            Remark::new(RemarkCode::DrawingAssumption, message).at(count, [])
        })
    }
}

/// The box of an `svg` or a `symbol` inside, which clips what is in it.
pub(super) struct Frame {
    /// From the coordinates of the drawing to those of the box.
    back: Transformation,
    low: [f64; 2],
    high: [f64; 2],
    /// The frame around it.
    outer: Option<usize>,
}

impl Frame {
    /// The box in the coordinates of this map; `None` where the map is flat.
    pub(super) fn new(
        map: &Transformation,
        [low, high]: [[f64; 2]; 2],
        outer: Option<usize>,
    ) -> Option<Self> {
        Some(Self { back: map.inverse()?, low, high, outer })
    }

    /// Whether a point of the drawing is in a frame and all around it, but for rounding.
    pub(super) fn holds(frames: &[Self], mut number: Option<usize>, point: [f64; 2]) -> bool {
        while let Some(frame) = number.map(|number| &frames[number]) {
            let place = frame.back.point(point);
            let is_inside = (0..2).all(|axis| {
                let margin = 1e-6 * (frame.high[axis] - frame.low[axis]);
                (frame.low[axis] - margin..=frame.high[axis] + margin).contains(&place[axis])
            });
            if !is_inside {
                return false;
            }
            number = frame.outer;
        }
        true
    }
}
