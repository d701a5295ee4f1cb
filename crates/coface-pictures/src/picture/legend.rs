//! Legends: which color is what.

use super::flat::{Anchor, FlatPicture};
use super::matrix::rectangle;
use super::palette::{Color, Theme};
use super::scene_picture::{COMPLEX, LABELS, fill_of, shown};
use crate::Scene;

const TEXT_SIZE: f64 = 14.0;
const ROW: f64 = 24.0;
const MARGIN: f64 = 12.0;
/// The side of a colored square, and the room behind it and behind a name.
const SIDE: f64 = 12.0;
const GAP: f64 = 8.0;
const BETWEEN: f64 = 26.0;
/// A letter is at most so wide in the middle, for a size of 1.
const LETTER: f64 = 0.6;

/// The names of layers with their colors, in rows above the model.
#[derive(Clone, Debug)]
pub(super) struct Legend {
    entries: Vec<Entry>,
    rows: usize,
    ink: Color,
    /// No more than this is there for it.
    most: usize,
}

#[derive(Clone, Debug)]
struct Entry {
    name: String,
    color: Color,
    /// The color of its triangles, if it has any.
    fill: Option<Color>,
    has_lines: bool,
    at: [f64; 2],
}

impl Legend {
    /// The legend of the layers of a scene that are shown and have a name, for a picture of this size.
    pub(super) fn of(scene: &Scene, size: [usize; 2], theme: &Theme) -> Self {
        let width = size[0] as f64 - MARGIN;
        let (mut x, mut row) = (MARGIN, 0);
        let mut entries = Vec::new();
        let named = |name: &str, group: &str| !name.is_empty() && group != LABELS && group != COMPLEX;
        for (layer, color) in shown(scene).filter(|(layer, _)| named(&layer.name, &layer.group)) {
            let length = SIDE + GAP + LETTER * TEXT_SIZE * layer.name.chars().count() as f64;
            if x > MARGIN && x + length > width {
                (x, row) = (MARGIN, row + 1);
            }
            entries.push(Entry {
                name: layer.name.clone(),
                color,
                fill: (!layer.triangles.is_empty()).then(|| fill_of(layer, color, theme)),
                has_lines: !layer.lines.is_empty(),
                at: [x, MARGIN + ROW * row as f64],
            });
            x += length + BETWEEN;
        }
        let rows = if entries.is_empty() { 0 } else { row + 1 };
        Self { entries, rows, ink: theme.ink, most: size[1] / 2 }
    }

    /// The rows of pixels that it takes.
    pub(super) fn height(&self) -> usize {
        if self.rows == 0 { 0 } else { ((MARGIN + ROW * self.rows as f64) as usize).min(self.most) }
    }

    pub(super) fn draw(&self, picture: &mut FlatPicture) {
        for entry in &self.entries {
            let [x, y] = entry.at;
            let middle = [x + 0.5 * SIDE, y + 0.5 * SIDE];
            match entry.fill {
                Some(fill) => {
                    let square = rectangle([x, y], [SIDE, SIDE]).to_vec();
                    picture.shape(square, fill, (entry.color, 1.5));
                }
                None if entry.has_lines => {
                    let line = rectangle([x, middle[1] - 1.5], [SIDE, 3.0]).to_vec();
                    picture.fill(line, entry.color, 1.0);
                }
                None => picture.disk(middle, 4.0, entry.color, None),
            }
            let at = [x + SIDE + GAP, y + SIDE - 1.0];
            picture.text(at, Anchor::Start, TEXT_SIZE, self.ink, entry.name.clone());
        }
    }
}
