//! Closed surfaces of any genus.

use super::Mesh;
use coface::algebra::RaggedArray;

/// A plate of `side` by `side` squares and thickness one, pierced by ten square holes in two rows of five; its surface,
/// each quad cut into two triangles, is closed and of genus 10, all triangles turning outward.
pub(super) fn plate_of_genus_10(side: usize) -> Mesh {
    let hole = 2 * (side / 32);
    let (column, row) = (side / 5, side / 2);
    let is_hole = |x: usize, y: usize| {
        let within = |at: usize, pitch: usize, count: usize| {
            at / pitch < count && {
                let start = (pitch - hole) / 2;
                (start..start + hole).contains(&(at % pitch))
            }
        };
        within(x, column, 5) && within(y, row, 2)
    };
    plate(side, is_hole)
}

/// The same with `genus` holes, row by row in a square grid of places for them.
pub(super) fn plate_of_genus(genus: usize, side: usize) -> Mesh {
    let across = (1..).find(|count| count * count >= genus).expect("there is a square above each number");
    let pitch = side / across;
    let hole = pitch / 3;
    let start = (pitch - hole) / 2;
    let is_hole = |x: usize, y: usize| {
        let (column, row) = (x / pitch, y / pitch);
        let is_within = |at: usize| (start..start + hole).contains(&(at % pitch));
        column < across && row * across + column < genus && is_within(x) && is_within(y)
    };
    plate(side, is_hole)
}

/// The surface of a plate of `side` by `side` squares without those that are holes.
fn plate(side: usize, is_hole: impl Fn(usize, usize) -> bool) -> Mesh {
    let is_solid = |x: Option<usize>, y: Option<usize>| match (x, y) {
        (Some(x), Some(y)) => x < side && y < side && !is_hole(x, y),
        _ => false,
    };
    let width = side + 1;
    let mut ids = vec![u32::MAX; 2 * width * width];
    let mut coordinates = Vec::new();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    let mut add = |corners: [[usize; 3]; 4]| {
        let [a, b, c, d] = corners.map(|[x, y, z]| {
            let id = &mut ids[(z * width + y) * width + x];
            if *id == u32::MAX {
                *id = (coordinates.len() / 3) as u32;
                coordinates.extend([x as f64, y as f64, z as f64]);
            }
            *id
        });
        triangles.extend([[a, b, c], [a, c, d]]);
    };
    for y in 0..side {
        for x in 0..side {
            if is_hole(x, y) {
                continue;
            }
            add([[x, y, 1], [x + 1, y, 1], [x + 1, y + 1, 1], [x, y + 1, 1]]);
            add([[x, y, 0], [x, y + 1, 0], [x + 1, y + 1, 0], [x + 1, y, 0]]);
            if !is_solid(Some(x), y.checked_sub(1)) {
                add([[x, y, 0], [x + 1, y, 0], [x + 1, y, 1], [x, y, 1]]);
            }
            if !is_solid(Some(x), Some(y + 1)) {
                add([[x + 1, y + 1, 0], [x, y + 1, 0], [x, y + 1, 1], [x + 1, y + 1, 1]]);
            }
            if !is_solid(x.checked_sub(1), Some(y)) {
                add([[x, y + 1, 0], [x, y, 0], [x, y, 1], [x, y + 1, 1]]);
            }
            if !is_solid(Some(x + 1), Some(y)) {
                add([[x + 1, y, 0], [x + 1, y + 1, 0], [x + 1, y + 1, 1], [x + 1, y, 1]]);
            }
        }
    }
    Mesh { vertex_count: coordinates.len() / 3, coordinates, lists: RaggedArray::from_lists(triangles) }
}
