//! Persistence diagrams as pictures.

use super::flat::{Anchor, FlatPicture, Step};
use super::matrix::rectangle;
use super::palette::{LIGHT, color};
use coface_algebra::Error;

const SIDE: f64 = 480.0;
const MARGIN: f64 = 70.0;

/// A class in a picture of a persistence diagram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiagramPoint {
    /// The degree of the class.
    pub degree: usize,
    /// The value at its birth.
    pub birth: f64,
    /// The value at its death; none for a class that stays.
    pub death: Option<f64>,
}

/// A persistence diagram: births to the right, deaths up, a color for each degree, the diagonal, and above (below, where values fall) a line
/// for classes that stay.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for births and deaths that are not finite.
///
/// # Complexity
/// Linear in the classes.
///
/// # Examples
/// ```
/// use coface_pictures::{DiagramPoint, diagram_picture};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let stays = DiagramPoint { degree: 0, birth: 0.0, death: None };
/// let dies = DiagramPoint { degree: 1, birth: 0.5, death: Some(2.0) };
/// let text = diagram_picture("two classes", &[stays, dies])?.svg(None)?;
/// assert!(text.contains("H_0") && text.contains("H_1") && text.contains("never"));
/// # Ok(()) }
/// ```
pub fn diagram_picture(title: &str, points: &[DiagramPoint]) -> Result<FlatPicture, Error> {
    let (low, high) = range_of(points)?;
    let is_falling = points.iter().any(|point| point.death.is_some_and(|death| death < point.birth));
    let size = [SIDE + 2.0 * MARGIN, SIDE + 2.0 * MARGIN];
    let mut picture = FlatPicture::new(title, size, LIGHT.background);
    // A strip at the end is for what stays.
    let room = 0.88 * SIDE;
    let share = |value: f64| (value - low) / (high - low);
    let bottom = if is_falling { MARGIN + 0.12 * SIDE } else { MARGIN };
    let place = |birth: f64, death: f64| {
        [
            MARGIN + 0.03 * SIDE + 0.94 * SIDE * share(birth),
            size[1] - bottom - 0.02 * SIDE - 0.96 * room * share(death),
        ]
    };
    let never = if is_falling { size[1] - MARGIN - 0.05 * SIDE } else { MARGIN + 0.05 * SIDE };
    let [ends, names] = [LIGHT.edge, LIGHT.ink];
    let diagonal = [place(low, low), place(high, high)];
    let line = |[a, b]: [[f64; 2]; 2]| vec![Step::Move(a), Step::Line(b)];
    picture.stroke(rectangle([MARGIN, MARGIN], [SIDE, SIDE]).to_vec(), ends, 1.0);
    picture.stroke(line(diagonal), ends, 1.0);
    picture.stroke(line([[MARGIN, never], [MARGIN + SIDE, never]]), ends, 0.5);
    picture.text([MARGIN - 6.0, never + 4.0], Anchor::End, 13.0, names, "never");
    for value in ticks(low, high) {
        let [x, y] = place(value, value);
        picture.stroke(line([[x, MARGIN + SIDE], [x, MARGIN + SIDE + 5.0]]), ends, 1.0);
        picture.stroke(line([[MARGIN - 5.0, y], [MARGIN, y]]), ends, 1.0);
        let words = format!("{value}");
        picture.text([x, MARGIN + SIDE + 20.0], Anchor::Middle, 13.0, names, words.clone());
        picture.text([MARGIN - 8.0, y + 4.0], Anchor::End, 13.0, names, words);
    }
    picture.text([MARGIN + 0.5 * SIDE, MARGIN + SIDE + 45.0], Anchor::Middle, 14.0, names, "birth");
    picture.text([MARGIN - 8.0, MARGIN - 12.0], Anchor::End, 14.0, names, "death");
    let degrees = points.iter().map(|point| point.degree + 1).max().unwrap_or(0);
    for degree in 0..degrees {
        let own = || points.iter().filter(|point| point.degree == degree);
        for point in own() {
            let [x, y] = place(point.birth, point.death.unwrap_or(low));
            let at = [x, if point.death.is_some() { y } else { never }];
            picture.disk(at, 4.0, color(degree), Some((LIGHT.background, 0.8)));
        }
        let left = MARGIN + degree as f64 * 110.0;
        picture.disk([left + 6.0, 0.5 * MARGIN - 4.0], 5.0, color(degree), None);
        let words = format!("H_{degree}: {}", own().count());
        picture.text([left + 16.0, 0.5 * MARGIN], Anchor::Start, 14.0, names, words);
    }
    Ok(picture)
}

/// The least and the greatest value of births and deaths, which are finite, or what is drawn where these are none or equal.
pub(super) fn range_of(points: &[DiagramPoint]) -> Result<(f64, f64), Error> {
    let values = || points.iter().flat_map(|point| [Some(point.birth), point.death]).flatten();
    if let Some(value) = values().find(|value| !value.is_finite()) {
        return Err(Error::invalid(format!("{value} is no value of a birth or death that can be drawn"))
            .with_cure("leave the death out where a class stays"));
    }
    let (low, high) = values().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
    Ok(if low < high {
        (low, high)
    } else if low == high {
        (low - 0.5, high + 0.5)
    } else {
        (0.0, 1.0)
    })
}

/// Round numbers in a range, some five of them.
pub(super) fn ticks(low: f64, high: f64) -> Vec<f64> {
    let rough = (high - low) / 5.0;
    let power = 10f64.powi(rough.log10().floor() as i32);
    let step = [1.0, 2.0, 5.0, 10.0].map(|digit| digit * power).into_iter().find(|&step| step >= rough);
    let step = step.unwrap_or(rough);
    if !(step.is_finite() && step > 0.0) {
        return vec![low, high];
    }
    let first = (low / step).ceil();
    // Counted in steps, so that 0.3 is not 0.30000000000000004.
    let number = |i: f64| if step >= 1.0 { i * step } else { i / (1.0 / step).round() };
    (0..12).map(|i| number(first + f64::from(i))).take_while(|&value| value <= high).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_within() {
        assert_eq!(ticks(0.0, 1.0), [0.0, 0.2, 0.4, 0.6, 0.8, 1.0]);
        assert_eq!(ticks(-3.0, 12.0), [0.0, 5.0, 10.0]);
        assert!(ticks(1e-9, 5e-9).len() > 2);
    }

    #[test]
    fn values_without_a_place_are_refused() {
        let point = DiagramPoint { degree: 0, birth: f64::NAN, death: None };
        assert!(diagram_picture("t", &[point]).is_err());
        assert!(diagram_picture("t", &[]).is_ok());
    }
}
