//! Pictures of interfaces: phases side by side.

use crate::picture::{Anchor, Color, FlatPicture, Step, color_of, color_of_many, mixed};
use coface_algebra::Error;
use coface_answers::answer::{YinEdgeAnswer, YinInterfaceAnswer};

/// The longer side of what is drawn, and the room around it.
const SIDE: f64 = 640.0;
const MARGIN: f64 = 24.0;
/// The room for the names of phases, a line of them, and how many there are at most.
const LEGEND: f64 = 260.0;
const ROW: f64 = 30.0;
const MOST_NAMES: usize = 24;
/// The size of letters in the legend, and of the types of junctions.
const LETTERS: f64 = 18.0;
const TYPES: f64 = 15.0;
/// The side of the squares in the legend.
const SQUARE: f64 = 20.0;
/// Of a longer name the beginning is written.
const MOST_LETTERS: usize = 20;
/// With more junctions than this, their types are not written beside them.
const MOST_TYPES: usize = 200;
/// Pieces have no higher order; those above 4 are drawn by so many chords.
const MOST_ORDER: u32 = 16;
const CHORDS: usize = 16;
/// How much of its color a phase has.
const TINT: f32 = 0.4;

const INK: Color = color_of(0x22272d);
const PALE: Color = color_of(0x5c6670);
const RED: Color = color_of(0xd0021b);
const PAPER: Color = color_of(0xffffff);

/// The phases of an interface in colors, their common edges, and disks at the junctions with their types: Y, T, X. Names of phases stand at the right.
/// A phase that is not bounded fills what the frame has of it.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the edges have no control points, or the interface is none: ends that are no
/// vertices, pieces that are not whole.
///
/// # Complexity
/// Linear in the pieces of the edges.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_answers::{LabelImage, PlanarInterface};
/// use coface_pictures::interface_picture;
/// use coface_yin::{InterfaceOptions, Overlaps};
/// // Two pixels above one of two widths.
/// let sets = LabelImage::new(2, vec![1, 2, 3, 3])?.sets()?;
/// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
/// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
/// let svg = interface_picture("labels", &interface.answer(&[], true)?)?.svg(None)?;
/// // A disk at each of the four junctions.
/// assert_eq!(svg.matches("<circle").count(), 4);
/// # Ok(()) }
/// ```
pub fn interface_picture(title: &str, interface: &YinInterfaceAnswer) -> Result<FlatPicture, Error> {
    check(interface)?;
    let frame = frame_of(interface);
    let [low, high] = frame;
    let extent = [0, 1].map(|axis| high[axis] - low[axis]);
    let scale = SIDE / extent[0].max(extent[1]).max(f64::MIN_POSITIVE);
    let [width, height] = extent.map(|side| scale * side);
    let named = interface.phases.len().min(MOST_NAMES + 1);
    let size =
        [width + 2.0 * MARGIN + LEGEND, (height + 2.0 * MARGIN).max(2.0 * MARGIN + ROW * (named + 3) as f64)];
    let mut picture = FlatPicture::new(title, size, PAPER);
    let view = View { low, scale, bottom: MARGIN + height };
    for (number, phase) in interface.phases.iter().enumerate() {
        let mut path = boundary(interface, number as u32, &view);
        if phase.area.is_none() && (!path.is_empty() || interface.edges.is_empty()) {
            let corners = [low, [high[0], low[1]], high, [low[0], high[1]]].map(|corner| view.place(corner));
            path.push(Step::Move(corners[0]));
            path.extend(corners[1..].iter().map(|&corner| Step::Line(corner)));
            path.push(Step::Close);
        }
        picture.begin_group(&format!("phase {}", phase.name));
        if !path.is_empty() {
            picture.fill(path, tint(number), 1.0);
        }
    }
    picture.begin_group("edges");
    for edge in &interface.edges {
        let mut path = vec![Step::Move(view.place(controls(edge)[0]))];
        push_pieces(&mut path, controls(edge), interface.order, &view, false);
        picture.stroke(path, INK, 1.4);
    }
    picture.begin_group("junctions");
    for junction in &interface.junctions {
        let [x, y] = view.place(junction.point);
        picture.disk([x, y], 4.0, PAPER, Some((RED, 2.0)));
        if interface.junctions.len() <= MOST_TYPES {
            // On a plate, so that it can be read on any color.
            let word = junction.kind.word();
            let [left, top] = [x + 6.0, y - 9.0 - TYPES];
            let [right, bottom] = [left + 0.62 * TYPES * word.len() as f64 + 6.0, top + TYPES + 4.0];
            let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
            picture.fill(closed(&corners), PAPER, 0.9);
            picture.text([left + 3.0, bottom - 4.0], Anchor::Start, TYPES, RED, word);
        }
    }
    draw_legend(&mut picture, interface, [width + 2.0 * MARGIN, MARGIN]);
    Ok(picture)
}

/// The color of a phase.
fn tint(number: usize) -> Color {
    mixed(color_of_many(number), PAPER, TINT)
}

fn check(interface: &YinInterfaceAnswer) -> Result<(), Error> {
    let fault = |message: String| {
        Err(Error::invalid(message)
            .with_cure("give an interface as it was written to a file, with the control points of its edges"))
    };
    if !(2..=MOST_ORDER).contains(&interface.order) {
        return fault(format!("the edges have order {}, not one from 2 to {MOST_ORDER}", interface.order));
    }
    let phases = interface.phases.len() as u32;
    for (number, edge) in interface.edges.iter().enumerate() {
        let Some(points) = &edge.controls else {
            return fault(format!("edge {number} has no control points"));
        };
        let step = interface.order as usize - 1;
        let is_whole = points.len() > 1 && (points.len() - 1).is_multiple_of(step);
        if !is_whole || points.iter().flatten().any(|x| !x.is_finite()) {
            return fault(format!(
                "edge {number} has control points that are no pieces of order {}",
                interface.order
            ));
        }
        if edge.ends.iter().any(|&end| end as usize >= interface.vertices.len()) {
            return fault(format!("edge {number} ends at a vertex that is not there"));
        }
        if [edge.left, edge.right].into_iter().flatten().any(|phase| phase >= phases) {
            return fault(format!("edge {number} bounds a phase that is not there"));
        }
    }
    let is_finite = |point: &[f64; 2]| point.iter().all(|x| x.is_finite());
    if !interface.junctions.iter().all(|junction| is_finite(&junction.point)) {
        return fault("a junction is at no place".to_owned());
    }
    Ok(())
}

fn controls(edge: &YinEdgeAnswer) -> &[[f64; 2]] {
    edge.controls.as_deref().unwrap_or(&[])
}

/// The box around all control points, with a margin if a phase is not bounded.
fn frame_of(interface: &YinInterfaceAnswer) -> [[f64; 2]; 2] {
    let points = interface.edges.iter().flat_map(controls);
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for point in points {
        for axis in 0..2 {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    }
    if low[0] > high[0] {
        return [[0.0; 2], [1.0; 2]];
    }
    let is_unbounded = interface.phases.iter().any(|phase| phase.area.is_none());
    let margin = if is_unbounded { 0.08 * (high[0] - low[0]).max(high[1] - low[1]) } else { 0.0 };
    [low.map(|x| x - margin), high.map(|x| x + margin)]
}

/// From the plane to the picture.
struct View {
    low: [f64; 2],
    scale: f64,
    bottom: f64,
}

impl View {
    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [MARGIN + self.scale * (x - self.low[0]), self.bottom - self.scale * (y - self.low[1])]
    }
}

/// The pieces of an edge, from its end to its start if it is reversed.
fn push_pieces(path: &mut Vec<Step>, controls: &[[f64; 2]], order: u32, view: &View, is_reversed: bool) {
    let mut points: Vec<[f64; 2]> = controls.iter().map(|&point| view.place(point)).collect();
    if is_reversed {
        points.reverse();
    }
    let pieces = points[1..].chunks_exact(order as usize - 1);
    for (place, piece) in pieces.enumerate() {
        match *piece {
            [end] => path.push(Step::Line(end)),
            [first, second, end] => path.push(Step::Cubic([first, second, end])),
            _ => {
                let whole = &points[place * piece.len()..=(place + 1) * piece.len()];
                path.extend((1..=CHORDS).map(|i| Step::Line(point_of(whole, i as f64 / CHORDS as f64))));
            }
        }
    }
}

/// The point of a piece at a parameter from 0 to 1 (P. de Casteljau).
fn point_of(controls: &[[f64; 2]], share: f64) -> [f64; 2] {
    let mut points = controls.to_vec();
    while points.len() > 1 {
        points = points
            .windows(2)
            .map(|pair| [0, 1].map(|i| pair[0][i] + share * (pair[1][i] - pair[0][i])))
            .collect();
    }
    points[0]
}

/// Closed walks along all edges of a phase, which lies to their left: edges, and whether each is run through backwards. How walks go on at junctions does
/// not change what they enclose.
pub(crate) fn walks_around(interface: &YinInterfaceAnswer, phase: u32) -> Vec<Vec<(usize, bool)>> {
    // An edge with the phase on both sides is in no boundary.
    let mut leaving: Vec<Vec<(usize, bool)>> = vec![Vec::new(); interface.vertices.len()];
    for (number, edge) in interface.edges.iter().enumerate() {
        match (edge.left == Some(phase), edge.right == Some(phase)) {
            (true, false) => leaving[edge.ends[0] as usize].push((number, false)),
            (false, true) => leaving[edge.ends[1] as usize].push((number, true)),
            _ => {}
        }
    }
    let mut walks = Vec::new();
    for start in 0..leaving.len() {
        while let Some(first) = leaving[start].pop() {
            let mut walk = vec![first];
            loop {
                let (number, is_reversed) = walk[walk.len() - 1];
                let at = interface.edges[number].ends[usize::from(!is_reversed)] as usize;
                if at == start {
                    break;
                }
                let Some(next) = leaving[at].pop() else { break };
                walk.push(next);
            }
            walks.push(walk);
        }
    }
    walks
}

/// The path around a phase.
fn boundary(interface: &YinInterfaceAnswer, phase: u32, view: &View) -> Vec<Step> {
    let mut path = Vec::new();
    for walk in walks_around(interface, phase) {
        for (place, (number, is_reversed)) in walk.into_iter().enumerate() {
            let points = controls(&interface.edges[number]);
            if place == 0 {
                let from = if is_reversed { points[points.len() - 1] } else { points[0] };
                path.push(Step::Move(view.place(from)));
            }
            push_pieces(&mut path, points, interface.order, view, is_reversed);
        }
        path.push(Step::Close);
    }
    path
}

/// The path around a polygon.
fn closed(corners: &[[f64; 2]]) -> Vec<Step> {
    let mut path: Vec<Step> = corners.iter().map(|&corner| Step::Line(corner)).collect();
    path[0] = Step::Move(corners[0]);
    path.push(Step::Close);
    path
}

fn draw_legend(picture: &mut FlatPicture, interface: &YinInterfaceAnswer, [x, y]: [f64; 2]) {
    picture.begin_group("legend");
    let mut line = y;
    for (number, phase) in interface.phases.iter().take(MOST_NAMES).enumerate() {
        let square = [[x, line], [x + SQUARE, line], [x + SQUARE, line + SQUARE], [x, line + SQUARE]];
        picture.shape(closed(&square), tint(number), (INK, 1.0));
        let name = match phase.name.chars().count() > MOST_LETTERS {
            true => format!("{}..", phase.name.chars().take(MOST_LETTERS - 2).collect::<String>()),
            false => phase.name.clone(),
        };
        picture.text([x + SQUARE + 9.0, line + 0.82 * SQUARE], Anchor::Start, LETTERS, INK, name);
        line += ROW;
    }
    let rest = interface.phases.len().saturating_sub(MOST_NAMES);
    if rest > 0 {
        picture.text([x, line + 0.82 * SQUARE], Anchor::Start, LETTERS, PALE, format!("and {rest} more"));
        line += ROW;
    }
    if !interface.junctions.is_empty() {
        let words = match interface.junctions.len() {
            1 => "1 junction".to_owned(),
            count => format!("{count} junctions"),
        };
        picture.text([x, line + SQUARE], Anchor::Start, LETTERS, RED, words);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_answers::{LabelImage, PlanarInterface};
    use coface_yin::{InterfaceOptions, Overlaps};

    fn answer(width: usize, labels: &[u32]) -> YinInterfaceAnswer {
        let sets = LabelImage::new(width, labels.to_vec()).unwrap().sets().unwrap();
        let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
        PlanarInterface::of(sets, &options, Overlaps::Refused).unwrap().answer(&[], true).unwrap()
    }

    #[test]
    fn phases_edges_and_junctions_are_all_there() {
        let answer = answer(4, &[1, 1, 2, 2, 1, 3, 3, 2, 1, 3, 3, 2, 1, 1, 2, 2]);
        let svg = interface_picture("labels", &answer).unwrap().svg(None).unwrap();
        assert_eq!(svg.matches("<title>phase ").count(), 3);
        assert_eq!(svg.matches("<circle").count(), answer.junctions.len());
        assert_eq!(svg.matches("stroke-width=\"1.4\"").count(), answer.edges.len());
        let colors = svg.lines().filter(|line| line.contains("evenodd") && !line.contains("stroke="));
        let mut colors: Vec<&str> =
            colors.filter_map(|line| line.split("fill=\"").nth(1)?.get(..7)).collect();
        // The plates below types are white.
        colors.retain(|color| *color != "#ffffff");
        colors.sort_unstable();
        colors.dedup();
        assert_eq!(colors.len(), 3);
    }

    #[cfg(feature = "png")]
    #[test]
    fn pixels_have_the_colors_of_their_phases() {
        // A ring of one phase around another, and a corner of neither.
        let labels = [1, 1, 1, 0, 1, 2, 1, 0, 1, 1, 1, 0];
        let picture = interface_picture("ring", &answer(4, &labels)).unwrap();
        let [width, height] = picture.size().map(|side| side as usize);
        let bytes = picture.png([width, height]).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
        let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut buffer).unwrap();
        let at = |x: f64, y: f64| {
            // Three pixels wide and high, the first row on top.
            let [column, row] = [x, y].map(|share| (MARGIN + SIDE * share / 3.0) as usize);
            let place = 3 * (row * width + column);
            [buffer[place], buffer[place + 1], buffer[place + 2]]
        };
        let bytes = |color: Color| color.map(|part| (255.0 * part).round() as u8);
        assert_eq!(at(0.5, 1.5), bytes(tint(0)));
        assert_eq!(at(1.4, 1.4), bytes(tint(1)), "the hole of the ring is the other phase");
    }

    #[test]
    fn what_is_no_interface_is_refused() {
        let whole = answer(2, &[1, 2]);
        let mut broken = whole.clone();
        broken.edges[0].controls = None;
        assert!(interface_picture("a", &broken).unwrap_err().message().contains("no control points"));
        let mut broken = whole.clone();
        broken.edges[0].ends[1] = 99;
        assert!(interface_picture("a", &broken).is_err());
        let mut broken = whole.clone();
        broken.edges[0].left = Some(9);
        assert!(interface_picture("a", &broken).is_err());
        let mut broken = whole;
        broken.order = 4;
        broken.edges[0].controls = Some(vec![[0.0; 2]; 3]);
        assert!(interface_picture("a", &broken).is_err());
    }
}
