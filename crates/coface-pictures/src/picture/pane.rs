//! Panes of scenes as pictures: domains, covers, forests.

use super::flat::{Anchor, FlatPicture, Step};
use super::palette::{LIGHT, color};
use crate::scene::Pane;

/// The longer side of what is drawn, and the room around it.
const SIDE: f64 = 720.0;
const MARGIN: f64 = 40.0;

/// A pane as a picture: its layers one over the other, what is to the right and up in the pane to the right and up in the picture. Like a scene, it
/// shows the layers that are on.
///
/// # Complexity
/// Linear in the points, lines and triangles.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_pictures::{Layer, Pane, pane_picture};
/// let mut layer = Layer::new("graph", "an edge");
/// layer.lines.push(&[0, 1]);
/// let mut pane = Pane::default();
/// pane.positions = vec![[0.0, 0.0], [1.0, 0.0]];
/// pane.layers.push(layer);
/// let picture = pane_picture(&pane);
/// assert!(picture.svg(None)?.contains("<path"));
/// # Ok(()) }
/// ```
pub fn pane_picture(pane: &Pane) -> FlatPicture {
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for point in &pane.positions {
        for axis in 0..2 {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    }
    let extent = [0, 1].map(|axis| (high[axis] - low[axis]).max(0.0));
    let longest = extent[0].max(extent[1]);
    let scale = if longest > 0.0 { SIDE / longest } else { 1.0 };
    let [width, height] = extent.map(|side| side * scale);
    let mut picture =
        FlatPicture::new(&pane.name, [width + 2.0 * MARGIN, height + 2.0 * MARGIN], LIGHT.background);
    let place = |point: u32| {
        let [x, y] = pane.positions[point as usize];
        [MARGIN + (x - low[0]) * scale, MARGIN + height - (y - low[1]) * scale]
    };
    let mut next = 0;
    let layers: Vec<_> = pane
        .layers
        .iter()
        .map(|layer| {
            let place = layer.color.map_or(next, |place| place as usize);
            next += usize::from(layer.color.is_none());
            (layer, color(place))
        })
        .filter(|(layer, _)| layer.is_on)
        .collect();
    // All areas first, so that none hides a line of another layer.
    for (layer, ink) in &layers {
        let mut path = Vec::with_capacity(4 * layer.triangles.len());
        for triangle in &layer.triangles {
            let [a, b, c] = triangle.map(place);
            path.extend([Step::Move(a), Step::Line(b), Step::Line(c), Step::Close]);
        }
        if !path.is_empty() {
            picture.fill(path, *ink, 0.25);
        }
    }
    for (layer, ink) in &layers {
        let (ink, width) = if layer.name == "edges" { (LIGHT.edge, 0.5) } else { (*ink, 1.6) };
        let mut path = Vec::new();
        for line in layer.lines.iter() {
            let mut steps = line.iter().map(|&point| place(point));
            path.extend(steps.next().map(Step::Move));
            path.extend(steps.map(Step::Line));
        }
        if !path.is_empty() {
            picture.stroke(path, ink, width);
        }
        for &point in &layer.points {
            picture.disk(place(point), 3.5, ink, None);
        }
    }
    for (layer, _) in &layers {
        for (point, text) in &layer.labels {
            let [x, y] = place(*point);
            picture.text([x, y + 4.0], Anchor::Middle, 12.0, LIGHT.ink, text.clone());
        }
    }
    picture
}
