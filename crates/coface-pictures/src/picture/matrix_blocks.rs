//! Boundary matrices in blocks.

use super::flat::{Anchor, FlatPicture, Step};
use super::matrix::{draw_entries, rectangle};
use super::palette::{LIGHT, color};
use coface_answers::BlockedMatrix;
use std::f64::consts::FRAC_1_SQRT_2;

/// The longer side of a matrix, the room around it, that above for the title, and that below.
const SIDE: f64 = 640.0;
const MARGIN: f64 = 16.0;
const TITLE: f64 = 60.0;
const BOTTOM: f64 = 50.0;
/// From a name to the matrix, and the width of a letter at most, for a size of 1.
const TICK: f64 = 18.0;
const LETTER: f64 = 0.6;
/// No side is shorter, so that its words have room.
const LEAST: f64 = 120.0;
/// The size of names, and how far two of them are from each other at least.
const NAME: f64 = 13.0;
const APART: f64 = 15.0;
/// Of a longer name the beginning is written.
const MOST_LETTERS: usize = 24;

/// A boundary matrix with its rows and columns in blocks: names of blocks at the left and above, their sizes in brackets, lines between them. An entry
/// is blue if it is positive, orange if it is negative; a matrix larger than the picture is drawn in bins, darker where there are more
/// entries.
///
/// # Complexity
/// Linear in the entries.
///
/// # Examples
/// ```
/// use coface_answers::{BlockedMatrix, MatrixBlocks, Producer};
/// use coface_pictures::blocked_matrix_picture;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let two = coface_io::read(&b"[[0,1,2],[3,4,5]]"[..], coface_io::Format::Json)?;
/// let blocks = BlockedMatrix::of(&Producer::of(two.clone())?, &two, 2, MatrixBlocks::Components)?;
/// let svg = blocked_matrix_picture("two triangles", &blocks).svg(None)?;
/// assert_eq!(svg.matches(">component 1 (3)</text>").count(), 1);
/// # Ok(()) }
/// ```
pub fn blocked_matrix_picture(title: &str, blocks: &BlockedMatrix) -> FlatPicture {
    let matrix = blocks.matrix();
    let counts = [matrix.column_count(), matrix.row_count()];
    let longest = counts[0].max(counts[1]).max(1);
    let sides = counts.map(|count| (SIDE * count as f64 / longest as f64).max(LEAST));
    let longest_name = |own: &[(String, usize)]| {
        own.iter().map(|block| LETTER * NAME * named(block).chars().count() as f64).fold(0.0, f64::max)
    };
    // Names above go up as far as to the right.
    let (left, above) =
        (longest_name(blocks.row_blocks()), longest_name(blocks.column_blocks()) * FRAC_1_SQRT_2);
    let corner = [MARGIN + left + TICK, TITLE + above + TICK + NAME];
    let size = [corner[0] + sides[0] + above + MARGIN, corner[1] + sides[1] + BOTTOM];
    let mut picture = FlatPicture::new(title, size, LIGHT.background);
    picture.begin_group("title");
    picture.text([16.0, 28.0], Anchor::Start, 16.0, LIGHT.ink, title);
    let words = format!(
        "degree {}: {} x {}, {} entries",
        blocks.degree(),
        counts[1],
        counts[0],
        matrix.entry_count()
    );
    picture.text([16.0, 48.0], Anchor::Start, NAME, LIGHT.edge, words);
    picture.begin_group("entries");
    let orders = [blocks.row_order(), blocks.column_order()];
    let scale = [0, 1].map(|axis| sides[axis] / counts[axis].max(1) as f64);
    // Squares are no smaller than a unit of the picture.
    let bin = scale.map(|scale| (1.0 / scale).ceil().max(1.0) as usize);
    let side = [0, 1].map(|axis| scale[axis] * bin[axis] as f64);
    draw_entries(&mut picture, matrix, orders, corner, bin, side);
    picture.begin_group("blocks");
    let frame = rectangle(corner, sides);
    let mut lines = Vec::new();
    let ends = |own: &[(String, usize)]| -> Vec<usize> {
        own.iter()
            .scan(0, |sum, (_, size)| {
                *sum += size;
                Some(*sum)
            })
            .collect()
    };
    let [columns, rows] = [blocks.column_blocks(), blocks.row_blocks()];
    for &end in ends(columns).iter().take(columns.len().saturating_sub(1)) {
        let x = corner[0] + scale[0] * end as f64;
        lines.extend([Step::Move([x, corner[1]]), Step::Line([x, corner[1] + sides[1]])]);
    }
    for &end in ends(rows).iter().take(rows.len().saturating_sub(1)) {
        let y = corner[1] + scale[1] * end as f64;
        lines.extend([Step::Move([corner[0], y]), Step::Line([corner[0] + sides[0], y])]);
    }
    if !lines.is_empty() {
        picture.stroke(lines, LIGHT.pale, 1.0);
    }
    picture.stroke(frame.to_vec(), LIGHT.edge, 1.0);
    draw_names(&mut picture, columns, 0, corner, scale[0]);
    draw_names(&mut picture, rows, 1, corner, scale[1]);
    draw_legend(&mut picture, [corner[0], size[1] - 18.0]);
    picture
}

/// The names of blocks beside a side of the matrix, each with a tick to the middle of its block; they keep apart.
fn draw_names(
    picture: &mut FlatPicture,
    blocks: &[(String, usize)],
    axis: usize,
    corner: [f64; 2],
    scale: f64,
) {
    let mut start = 0;
    let mut middles = Vec::new();
    for (_, size) in blocks {
        middles.push(corner[axis] + scale * (start as f64 + 0.5 * *size as f64));
        start += size;
    }
    let end = corner[axis] + scale * start as f64;
    for (block, (middle, at)) in blocks.iter().zip(middles.iter().zip(spread(&middles, end))) {
        let words = named(block);
        let (tick, name_at) = match axis {
            // Above: names go up and to the right.
            0 => ([[*middle, corner[1] - 3.0], [at, corner[1] - 14.0]], [at, corner[1] - 18.0]),
            _ => ([[corner[0] - 3.0, *middle], [corner[0] - 12.0, at]], [corner[0] - 16.0, at + 4.0]),
        };
        picture.stroke(vec![Step::Move(tick[0]), Step::Line(tick[1])], LIGHT.pale, 1.0);
        match axis {
            0 => picture.slanted_text(name_at, NAME, LIGHT.ink, words),
            _ => picture.text(name_at, Anchor::End, NAME, LIGHT.ink, words),
        }
    }
}

/// The name and the size of a block.
fn named((name, size): &(String, usize)) -> String {
    format!("{} ({size})", shortened(name))
}

fn shortened(name: &str) -> String {
    if name.chars().count() <= MOST_LETTERS {
        return name.to_owned();
    }
    let beginning: String = name.chars().take(MOST_LETTERS - 2).collect();
    format!("{beginning}..")
}

/// Places near these, rising, that keep apart; the last one is not beyond the end unless there is no room.
fn spread(middles: &[f64], end: f64) -> Vec<f64> {
    let mut places = Vec::with_capacity(middles.len());
    let mut least = f64::NEG_INFINITY;
    for &middle in middles {
        let place = middle.max(least);
        places.push(place);
        least = place + APART;
    }
    // What was pushed beyond the end goes back.
    let mut most = end;
    for place in places.iter_mut().rev() {
        *place = place.min(most);
        most = *place - APART;
    }
    places
}

fn draw_legend(picture: &mut FlatPicture, [x, y]: [f64; 2]) {
    picture.begin_group("legend");
    for (place, name) in ["positive", "negative"].into_iter().enumerate() {
        let left = x + 100.0 * place as f64;
        picture.fill(rectangle([left, y - 9.0], [10.0, 10.0]).to_vec(), color(place), 1.0);
        picture.text([left + 16.0, y], Anchor::Start, NAME, LIGHT.ink, name);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_answers::{MatrixBlocks, Producer};
    use coface_io::{Format, read};

    #[test]
    fn every_entry_and_every_block_is_there() {
        let model = read(&b"[[0,1,2],[1,2,3],[4,5,6]]"[..], Format::Json).unwrap();
        let producer = Producer::of(model.clone()).unwrap();
        for (kind, rows, columns) in [(MatrixBlocks::Components, 2, 2), (MatrixBlocks::Matching, 2, 1)] {
            let blocks = BlockedMatrix::of(&producer, &model, 2, kind).unwrap();
            assert_eq!((blocks.row_blocks().len(), blocks.column_blocks().len()), (rows, columns));
            let svg = blocked_matrix_picture("three triangles", &blocks).svg(None).unwrap();
            // An entry is a square of its own; the legend has two more.
            let squares: usize = svg
                .lines()
                .filter(|line| line.contains("evenodd"))
                .map(|line| line.matches('M').count())
                .sum();
            assert_eq!(squares, 9 + 2);
            // Names, sizes, two lines of the title and two of the legend.
            assert_eq!(svg.matches("<text").count(), rows + columns + 4);
        }
    }

    #[test]
    fn names_keep_apart_and_within() {
        assert_eq!(spread(&[10.0, 12.0, 300.0], 400.0), [10.0, 25.0, 300.0]);
        assert_eq!(spread(&[380.0, 385.0, 390.0], 395.0), [365.0, 380.0, 395.0]);
    }
}
