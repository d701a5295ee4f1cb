//! Pictures of sets.

use crate::picture::{Anchor, Color, FlatPicture, Step, color_of};
use coface_algebra::Error;
use coface_answers::{PlanarSet, SetPiece as Piece, set_pieces as pieces_of};
use coface_io::yin::flattened;
use coface_yin::{Curve, Order};

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum SetPicture {
    /// The set alone, in its own coordinates: the file is read again as the set.
    #[default]
    Set,
    /// The set with its knots, and its kinks with their names.
    Kinks,
    /// The set with the numbers of its curves, and the forest of curves in curves beside it.
    Forest,
}

/// The side of a panel, in the unit of the picture.
const SIDE: f64 = 480.0;
const MARGIN: f64 = 28.0;
/// So many knots and names are drawn at most.
const MOST_DOTS: usize = 4000;
const MOST_NAMES: usize = 200;
/// Between neighbors of the forest.
const STEP: f64 = 40.0;

const BLUE: Color = color_of(0x224466);
const PALE: Color = color_of(0x99aacc);
const RED: Color = color_of(0xcc3333);
const PAPER: Color = color_of(0xffffff);
/// The size of letters.
const LETTERS: f64 = 12.0;

/// The set as a flat picture: with its knots and kinks, or with its forest, or alone. Curves of order 4 stay cubics.
///
/// # Errors
/// Those of flattening curves of an order above 4.
///
/// # Complexity
/// Linear in the pieces.
///
/// # Examples
/// ```
/// use coface_answers::PlanarSet;
/// use coface_pictures::{SetPicture, set_picture};
/// use coface_yin::{Curve, YinSet};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = Curve::polyline(&[[0., 0.], [4., 0.], [0., 3.], [0., 0.]])?;
/// let picture = set_picture(&PlanarSet::from_set(YinSet::new(&[triangle])?), SetPicture::Forest)?;
/// assert!(picture.svg(None)?.contains(">outside</text>"));
/// assert!(picture.png([72, 48])?.starts_with(b"\x89PNG"));
/// # Ok(()) }
/// ```
pub fn set_picture(set: &PlanarSet, picture: SetPicture) -> Result<FlatPicture, Error> {
    match picture {
        SetPicture::Set => panel(set, [SIDE, SIDE], &View::of(set.frame())),
        SetPicture::Kinks => with_kinks(set),
        SetPicture::Forest => with_forest(set),
    }
}

/// A picture of this size, with the set in a panel.
fn panel(set: &PlanarSet, size: [f64; 2], view: &View) -> Result<FlatPicture, Error> {
    let mut picture = FlatPicture::new("Yin set", size, PAPER);
    let mut path = Vec::new();
    if !set.set().is_bounded() {
        let [low, high] = set.frame();
        let corners = [low, [high[0], low[1]], high, [low[0], high[1]]].map(|corner| view.place(corner));
        path.push(Step::Move(corners[0]));
        path.extend(corners[1..].iter().map(|&corner| Step::Line(corner)));
        path.push(Step::Close);
    }
    for number in 0..set.set().curve_count() {
        let curve = set.set().curve(number);
        if curve.order() > Order::CUBIC {
            let mut corners = flattened(&curve, 0.1 / view.scale)?;
            corners.push(corners[0]);
            path.extend(steps_of(&Curve::polyline(&corners)?, view)?);
        } else {
            path.extend(steps_of(&curve, view)?);
        }
    }
    picture.shape(path, PALE, (BLUE, 1.0));
    Ok(picture)
}

fn with_kinks(set: &PlanarSet) -> Result<FlatPicture, Error> {
    let view = View::of(set.frame());
    let mut picture = panel(set, [SIDE, SIDE], &view)?;
    let knots = (0..set.set().curve_count()).map(|curve| set.set().curve(curve).piece_count()).sum::<usize>();
    if knots <= MOST_DOTS {
        for curve in (0..set.set().curve_count()).map(|curve| set.set().curve(curve)) {
            for knot in 0..curve.piece_count() {
                picture.disk(view.place(curve.knot_point(knot)), 1.5, BLUE, None);
            }
        }
    }
    let kinks = set.set().kinks();
    let place = |at: coface_yin::KnotIndex| {
        view.place(set.set().curve(at.curve as usize).knot_point(at.knot as usize))
    };
    for (at, _) in kinks.iter() {
        picture.disk(place(at), 3.5, PAPER, Some((RED, 1.5)));
    }
    if kinks.len() <= MOST_NAMES {
        for (at, name) in kinks.iter() {
            let [x, y] = place(at);
            picture.text([x + 5.0, y - 5.0], Anchor::Start, LETTERS, RED, format!("{name:?}"));
        }
    }
    Ok(picture)
}

fn with_forest(set: &PlanarSet) -> Result<FlatPicture, Error> {
    let view = View::of(set.frame());
    let count = set.set().curve_count();
    let forest = set.set().forest();
    // Places from the left: leaves side by side, others in the middle of what lies in them; the last is what lies in no curve.
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); count + 1];
    for curve in 0..count {
        children[forest.parent(curve).unwrap_or(count)].push(curve);
    }
    let mut places = vec![0.0; count + 1];
    let mut leaf_count = 0.0;
    let mut stack = vec![(count, false)];
    while let Some((node, is_done)) = stack.pop() {
        match (children[node].first(), children[node].last()) {
            (Some(&first), Some(&last)) if is_done => {
                places[node] = f64::midpoint(places[first], places[last]);
            }
            (Some(_), _) => {
                stack.push((node, true));
                stack.extend(children[node].iter().rev().map(|&child| (child, false)));
            }
            _ => {
                places[node] = leaf_count;
                leaf_count += 1.0;
            }
        }
    }
    let deepest = (0..count).map(|curve| forest.depth(curve) + 1).max().unwrap_or(0);
    let width = (SIDE + (leaf_count * STEP + 2.0 * MARGIN).max(SIDE / 2.0)).round();
    let height = SIDE.max(deepest as f64 * 64.0 + 3.0 * MARGIN);
    let left = SIDE + (width - SIDE - (leaf_count - 1.0) * STEP) / 2.0;
    let node = |node: usize| {
        let depth = if node == count { 0 } else { forest.depth(node) + 1 };
        [left + places[node] * STEP, 1.5 * MARGIN + 64.0 * depth as f64]
    };
    let mut picture = panel(set, [width, height], &view)?;
    for curve in 0..count {
        let [from, to] = [node(forest.parent(curve).unwrap_or(count)), node(curve)];
        picture.stroke(vec![Step::Move(from), Step::Line(to)], BLUE, 1.0);
    }
    // What is inside of a positive curve and outside of all that lie in it is in the set.
    for curve in 0..=count {
        let [x, y] = node(curve);
        let is_filled = match curve == count {
            true => !set.set().is_bounded(),
            false => forest.depth(curve).is_multiple_of(2) == set.set().is_bounded(),
        };
        let fill = if is_filled { PALE } else { PAPER };
        match curve == count {
            true => {
                let corners = [[-28.0, -12.0], [28.0, -12.0], [28.0, 12.0], [-28.0, 12.0]];
                let [a, b, c, d] = corners.map(|[right, down]| [x + right, y + down]);
                let path = vec![Step::Move(a), Step::Line(b), Step::Line(c), Step::Line(d), Step::Close];
                picture.shape(path, fill, (BLUE, 1.0));
            }
            false => picture.disk([x, y], 13.0, fill, Some((BLUE, 1.0))),
        }
        let name = if curve == count { "outside".to_owned() } else { curve.to_string() };
        picture.text([x, y + 4.0], Anchor::Middle, LETTERS, BLUE, name);
    }
    if count <= MOST_NAMES {
        for number in 0..count {
            let [x, y] = view.place(set.set().curve(number).knot_point(0));
            picture.text([x, y - 4.0], Anchor::Middle, LETTERS, RED, number.to_string());
        }
    }
    Ok(picture)
}

/// A closed curve of an order up to 4 as steps of a path.
fn steps_of(curve: &Curve<'_>, view: &View) -> Result<Vec<Step>, Error> {
    let mut steps = vec![Step::Move(view.place(curve.knot_point(0)))];
    for piece in pieces_of(curve)? {
        steps.push(match piece {
            Piece::Line(end) => Step::Line(view.place(end)),
            Piece::Cubic(controls) => Step::Cubic(controls.map(|control| view.place(control))),
        });
    }
    steps.push(Step::Close);
    Ok(steps)
}

/// How the plane is shown in a panel.
struct View {
    low: [f64; 2],
    scale: f64,
    offset: [f64; 2],
}

impl View {
    fn of([low, high]: [[f64; 2]; 2]) -> Self {
        let size = [high[0] - low[0], high[1] - low[1]];
        let largest = size[0].max(size[1]);
        let scale = if largest > 0.0 { (SIDE - 2.0 * MARGIN) / largest } else { 1.0 };
        Self { low, scale, offset: size.map(|side| (SIDE - side * scale) / 2.0) }
    }

    /// The second axis points up.
    fn place(&self, point: [f64; 2]) -> [f64; 2] {
        let [x, y] = [0, 1].map(|axis| self.offset[axis] + (point[axis] - self.low[axis]) * self.scale);
        [x, SIDE - y]
    }
}
