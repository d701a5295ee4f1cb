//! The sparsity of boundary matrices as a picture.

use super::flat::{Anchor, FlatPicture, Step};
use super::palette::{LIGHT, color};
use coface_algebra::SparseMatrix;
use coface_algebra::chains::ChainComplex;

/// The side of a matrix, and what is around it.
const SIDE: usize = 400;
const GAP: usize = 60;

/// So many shades has a color.
const SHADES: usize = 8;

/// The boundary matrices of a complex side by side: a square for each entry, blue for positive ones, orange for negative ones. Matrices
/// larger than a picture has room for are drawn in bins, darker where there are more entries.
///
/// # Complexity
/// Linear in the entries.
///
/// # Examples
/// ```
/// use coface_pictures::matrix_picture;
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = [(0, 0, -1), (1, 0, 1), (0, 1, -1), (2, 1, 1), (1, 2, -1), (2, 2, 1)];
/// let face = [(0, 0, 1), (1, 0, -1), (2, 0, 1)];
/// let matrices = vec![SparseMatrix::from_entries(3, 3, edges)?, SparseMatrix::from_entries(3, 1, face)?];
/// let triangle = ChainComplex::new(matrices)?;
/// let text = matrix_picture("triangle", &triangle).svg(None)?;
/// assert!(text.contains("degree 1: 3 x 3, 6 entries") && text.contains("degree 2: 3 x 1, 3 entries"));
/// # Ok(()) }
/// ```
pub fn matrix_picture(title: &str, complex: &ChainComplex) -> FlatPicture {
    let matrices = complex.boundary_matrices();
    let width = GAP + matrices.len().max(1) * (SIDE + GAP);
    let size = [width, SIDE + 2 * GAP].map(|side| side as f64);
    let mut picture = FlatPicture::new(title, size, LIGHT.background);
    if matrices.is_empty() {
        let words = "no boundary matrix: there are only points";
        picture.text([0.5 * size[0], 0.5 * size[1]], Anchor::Middle, 14.0, LIGHT.ink, words);
    }
    for (place, matrix) in matrices.iter().enumerate() {
        let (rows, columns) = (matrix.row_count(), matrix.column_count());
        let longest = rows.max(columns).max(1);
        // Cells of a matrix in one square of the picture.
        let bin = longest.div_ceil(SIDE);
        let bins = [rows.div_ceil(bin), columns.div_ceil(bin)];
        let side = SIDE as f64 / longest.div_ceil(bin) as f64;
        let corner = [(GAP + place * (SIDE + GAP)) as f64, GAP as f64];
        let words = format!("degree {}: {rows} x {columns}, {} entries", place + 1, matrix.entry_count());
        picture.text([corner[0], corner[1] - 10.0], Anchor::Start, 14.0, LIGHT.ink, words);
        let natural = |count: usize| (0..count as u32).collect::<Vec<_>>();
        let orders = [&natural(rows)[..], &natural(columns)];
        draw_entries(&mut picture, matrix, orders, corner, [bin; 2], [side; 2]);
        let frame = rectangle(corner, [side * bins[1] as f64, side * bins[0] as f64]);
        picture.stroke(frame.to_vec(), LIGHT.edge, 1.0);
    }
    picture
}

/// The entries of a matrix, rows and columns in these orders: squares from a corner on, each of so many columns and rows and with these sides.
pub(super) fn draw_entries(
    picture: &mut FlatPicture,
    matrix: &SparseMatrix,
    [rows, columns]: [&[u32]; 2],
    corner: [f64; 2],
    bin: [usize; 2],
    side: [f64; 2],
) {
    let bins = [columns.len().div_ceil(bin[0]), rows.len().div_ceil(bin[1])];
    let mut places = vec![0; rows.len()];
    rows.iter().enumerate().for_each(|(place, &row)| places[row as usize] = place);
    let mut counts = vec![[0u32; 2]; bins[0] * bins[1]];
    for (place, &column) in columns.iter().enumerate() {
        for (row, entry) in matrix.column(column as usize).iter() {
            let count = &mut counts[(places[row] / bin[1]) * bins[0] + place / bin[0]];
            count[usize::from(entry < 0)] += 1;
        }
    }
    let most = counts.iter().map(|[p, n]| p + n).max().unwrap_or(1).max(1);
    let mut squares = vec![Vec::new(); 2 * SHADES];
    for (at, &[positive, negative]) in counts.iter().enumerate().filter(|(_, [p, n])| p + n > 0) {
        let share = f64::from(positive + negative) / f64::from(most);
        let shade = ((share * SHADES as f64).ceil() as usize).clamp(1, SHADES) - 1;
        let color = usize::from(positive < negative);
        let place = [at % bins[0], at / bins[0]];
        let low = [0, 1].map(|axis| corner[axis] + side[axis] * place[axis] as f64);
        squares[color * SHADES + shade].extend(rectangle(low, side));
    }
    for (at, squares) in squares.into_iter().enumerate().filter(|(_, squares)| !squares.is_empty()) {
        let opacity = 0.25 + 0.75 * (at % SHADES + 1) as f32 / SHADES as f32;
        picture.fill(squares, color(at / SHADES), opacity);
    }
}

/// A rectangle by its corner and its sides.
pub(super) fn rectangle([x, y]: [f64; 2], [width, height]: [f64; 2]) -> [Step; 5] {
    [
        Step::Move([x, y]),
        Step::Line([x + width, y]),
        Step::Line([x + width, y + height]),
        Step::Line([x, y + height]),
        Step::Close,
    ]
}
