//! Topological gift wrapping.

use coface_algebra::{Error, ErrorKind};
use coface_algebra::{RaggedArray, SparseMatrix};
use std::collections::BTreeMap;

/// The shells that the two sides of faces close up to, by topological gift wrapping: column i is the boundary chain of
/// shell i, rows are faces.
///
/// `around` has for each edge the sides of faces in their order around it, each as `2 * face + 1` if the side runs
/// against the edge, else as `2 * face`. A chain grows from the first face that was not used twice, with the sign that
/// it was not used with; while it has a boundary, each face there gets the next one around the edge, with the sign that
/// cancels. Shells come in the order of their first faces, plus before minus.
///
/// The texts take the boundary at whole edges. Here the gaps between the faces around an edge count one by one: where a
/// shell passes an edge twice, as the outside of two cubes with a common edge does, its coefficients cancel at the edge
/// before it is closed, and the shell would fall apart. Faces with one shell on both sides are in it twice and have no
/// coefficient.
///
/// It does not matter what the faces are cells of: edges around vertices in the plane are wrapped in the same way. This
/// is the second method for the shells of [`SpatialCells`](super::SpatialCells), which has them from a union-find.
///
/// # Errors
/// [`ErrorKind::Shape`] for a side of a face that is not there.
///
/// # Complexity
/// $O(n \log n)$ for n sides.
///
/// # References
/// A. Paoluzzi, V. Shapiro, A. DiCarlo, F. Furiani, G. Martella, G. Scorzelli, *Topological computing of arrangements
/// with (co)chains* (2020), algorithm 1.
///
/// # Examples
/// Two halves of a sphere on a circle of one edge: the inside and the outside.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::spatial::gift_wrapped_shells;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let shells = gift_wrapped_shells(2, &RaggedArray::from_lists([[0, 3]]))?;
/// assert_eq!(shells.column(0).entries(), [1, 1]);
/// assert_eq!(shells.column(1).entries(), [-1, -1]);
/// # Ok(()) }
/// ```
pub fn gift_wrapped_shells(face_count: usize, around: &RaggedArray) -> Result<SparseMatrix, Error> {
    if let Some(side) = around.items().iter().find(|&&side| (side >> 1) as usize >= face_count) {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("a side of face f{} is at an edge, but there are {face_count} faces", side >> 1),
        ));
    }
    // The edge of each item, and where each face stands: once for each side.
    let mut edge_of_item = Vec::with_capacity(around.item_count());
    for edge in 0..around.len() {
        edge_of_item.resize(around.start(edge + 1), edge);
    }
    let places = RaggedArray::grouped(face_count, around.items().iter().map(|&side| side >> 1));
    // Gap g is counterclockwise of item g, up to the next item around the edge.
    let neighbor = |item: usize, step: isize| {
        let edge = edge_of_item[item];
        let (start, count) = (around.start(edge), around.list(edge).len());
        start + (item - start + count).wrapping_add_signed(step) % count
    };
    let mut used = vec![[false; 2]; face_count];
    let mut entries = Vec::new();
    let mut shell_count = 0;
    for seed in 0..2 * face_count {
        let (face, sign) = (seed / 2, 1 - 2 * (seed as i64 % 2));
        if used[face][seed % 2] {
            continue;
        }
        // The boundary of the chain at each gap.
        let mut boundary: BTreeMap<usize, i64> = BTreeMap::new();
        let mut added = vec![(face, sign)];
        while !added.is_empty() {
            for &(face, sign) in &added {
                used[face][usize::from(sign < 0)] = true;
                entries.push((face, shell_count, sign));
                for &item in places.list(face) {
                    let item = item as usize;
                    let incidence = sign * if around.items()[item] & 1 == 0 { 1 } else { -1 };
                    // A face that runs with the edge bounds what is clockwise of it, one that runs against it the
                    // other.
                    let gap = if incidence > 0 { neighbor(item, -1) } else { item };
                    *boundary.entry(gap).or_default() += incidence;
                }
            }
            boundary.retain(|_, coefficient| *coefficient != 0);
            added.clear();
            for (&gap, &coefficient) in &boundary {
                // The side across the gap, with the sign that cancels.
                let item = if coefficient > 0 { gap } else { neighbor(gap, 1) };
                let side = around.items()[item];
                let sign = -coefficient.signum() * if side & 1 == 0 { 1 } else { -1 };
                added.push(((side >> 1) as usize, sign));
            }
            added.sort_unstable();
            added.dedup();
        }
        shell_count += 1;
    }
    SparseMatrix::from_entries(face_count, shell_count, entries)
}
