//! Barcodes as pictures.

use super::diagram::{DiagramPoint, range_of, ticks};
use super::flat::{Anchor, FlatPicture, Step};
use super::matrix::rectangle;
use super::palette::{LIGHT, color};
use coface_algebra::Error;

const SIDE: f64 = 480.0;
const MARGIN: f64 = 70.0;

/// A barcode: a bar from the birth of each class to its death, by degrees from the top on and then by births and deaths, a color for each degree. Bars of classes that
/// stay go on to the frame.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for births and deaths that are not finite.
///
/// # Complexity
/// That of sorting the classes.
///
/// # Examples
/// ```
/// use coface_pictures::{DiagramPoint, barcode_picture};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let stays = DiagramPoint { degree: 0, birth: 0.0, death: None };
/// let dies = DiagramPoint { degree: 1, birth: 0.5, death: Some(2.0) };
/// let text = barcode_picture("two classes", &[stays, dies])?.svg(None)?;
/// assert!(text.contains("H_0: 1") && text.contains("H_1: 1"));
/// # Ok(()) }
/// ```
pub fn barcode_picture(title: &str, points: &[DiagramPoint]) -> Result<FlatPicture, Error> {
    let (low, high) = range_of(points)?;
    let is_falling = points.iter().any(|point| point.death.is_some_and(|death| death < point.birth));
    let size = [SIDE + 2.0 * MARGIN, SIDE + 2.0 * MARGIN];
    let mut picture = FlatPicture::new(title, size, LIGHT.background);
    // A strip at the end is for what stays.
    let start = MARGIN + SIDE * if is_falling { 0.08 } else { 0.02 };
    let place = |value: f64| start + 0.9 * SIDE * (value - low) / (high - low);
    let never = if is_falling { MARGIN } else { MARGIN + SIDE };
    let [ends, names] = [LIGHT.edge, LIGHT.ink];
    let line = |a: [f64; 2], b: [f64; 2]| vec![Step::Move(a), Step::Line(b)];
    for value in ticks(low, high) {
        let x = place(value);
        picture.stroke(line([x, MARGIN + SIDE], [x, MARGIN + SIDE + 5.0]), ends, 1.0);
        picture.text([x, MARGIN + SIDE + 20.0], Anchor::Middle, 13.0, names, format!("{value}"));
    }
    picture.text([MARGIN + 0.5 * SIDE, MARGIN + SIDE + 45.0], Anchor::Middle, 14.0, names, "value");
    let mut bars: Vec<&DiagramPoint> = points.iter().collect();
    let sign = if is_falling { -1.0 } else { 1.0 };
    let death = |point: &DiagramPoint| point.death.map_or(f64::INFINITY, |death| sign * death);
    bars.sort_by(|a, b| {
        let births = (sign * a.birth).total_cmp(&(sign * b.birth));
        a.degree.cmp(&b.degree).then(births).then(death(a).total_cmp(&death(b)))
    });
    let step = 0.96 * SIDE / bars.len().max(1) as f64;
    for (row, point) in bars.iter().enumerate() {
        let y = MARGIN + 0.02 * SIDE + step * (row as f64 + 0.5);
        let ends = [place(point.birth), point.death.map_or(never, place)];
        let (left, right) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        // Short ones can be seen too.
        let (width, height) = ((right - left).max(0.5), (0.6 * step).min(6.0));
        let bar = rectangle([left, y - 0.5 * height], [width, height]);
        picture.fill(bar.to_vec(), color(point.degree), 1.0);
    }
    picture.stroke(rectangle([MARGIN, MARGIN], [SIDE, SIDE]).to_vec(), ends, 1.0);
    let degrees = points.iter().map(|point| point.degree + 1).max().unwrap_or(0);
    for degree in 0..degrees {
        let left = MARGIN + degree as f64 * 110.0;
        picture.disk([left + 6.0, 0.5 * MARGIN - 4.0], 5.0, color(degree), None);
        let words = format!("H_{degree}: {}", bars.iter().filter(|point| point.degree == degree).count());
        picture.text([left + 16.0, 0.5 * MARGIN], Anchor::Start, 14.0, names, words);
    }
    Ok(picture)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_are_drawn_for_all_classes_and_without_any() {
        let point = |degree, birth, death| DiagramPoint { degree, birth, death };
        assert!(barcode_picture("t", &[point(0, f64::NAN, None)]).is_err());
        assert!(barcode_picture("t", &[]).is_ok());
        // A bar each, beside the frame and ticks.
        let strokes = |points: &[DiagramPoint]| {
            let text = barcode_picture("t", points).unwrap().svg(None).unwrap();
            text.matches("<path").count() + text.matches("<line").count()
        };
        let two = [point(0, 0.0, None), point(0, 0.0, Some(1.0))];
        let three = [&two[..], &[point(1, 0.5, Some(1.0))]].concat();
        assert_eq!(strokes(&three), strokes(&two) + 1);
        assert!(barcode_picture("t", &[point(0, 5.0, Some(1.0)), point(0, 5.0, None)]).is_ok());
    }
}
