//! Topological gift wrapping in the plane: faces from a signed boundary matrix and the order of edges around vertices.

use coface_algebra::{Error, ErrorKind};
use coface_algebra::{RaggedArray, SparseMatrix};

/// No place, no cycle.
const NOWHERE: u32 = u32::MAX;

/// The cycles that bound the faces of a plane graph, found by wrapping chains until they close.
///
/// `boundary` has a column for each edge, -1 at its tail and 1 at its head; `rotation` lists the edges around each
/// vertex counterclockwise. Column i of the result is cycle i; it has 1 for edges that run with the face on their left,
/// and -1 for those that have it on their right. Each edge is in two cycles, once with each sign. Each component has
/// one cycle that runs clockwise around its outside.
///
/// A cycle grows from the lowest edge that is not in two yet, at both ends: at the head by the edge before in the
/// rotation, at the tail by the edge after, with the signs that cancel the boundary there. It is closed when the edge
/// ahead is its tail; where its boundary vanishes before that, the face touches itself in a vertex and the chain goes
/// on.
///
/// # Errors
/// [`ErrorKind::Shape`] unless each column has one -1 and one 1 and the rotation lists the edges at their ends;
/// [`ErrorKind::InvalidInput`] naming an edge that has one face on both sides: a chain cannot use it twice.
///
/// # Complexity
/// $O(m \\log m)$ for m edges: sorting the terms of each cycle.
///
/// # References
/// A. Paoluzzi, V. Shapiro, A. DiCarlo, F. Furiani, G. Martella, G. Scorzelli, *Topological computing of arrangements
/// with (co)chains* (2020), section 4.
///
/// # Examples
/// A triangle has two sides.
/// ```
/// use coface_algebra::{RaggedArray, SparseMatrix};
/// use coface_arrange::planar::gift_wrapped_faces;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// // Edges 01, 12 and 02 of a triangle that runs counterclockwise.
/// let entries = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
/// let boundary = SparseMatrix::from_entries(3, 3, entries)?;
/// let rotation = RaggedArray::from_lists([[0, 2], [1, 0], [2, 1]]);
/// let cycles = gift_wrapped_faces(&boundary, &rotation)?;
/// assert_eq!(cycles.column(0).iter().collect::<Vec<_>>(), [(0, 1), (1, 1), (2, -1)]);
/// assert_eq!(cycles.column(1).iter().collect::<Vec<_>>(), [(0, -1), (1, -1), (2, 1)]);
/// # Ok(()) }
/// ```
pub fn gift_wrapped_faces(boundary: &SparseMatrix, rotation: &RaggedArray) -> Result<SparseMatrix, Error> {
    let edge_count = boundary.column_count();
    let mut ends = Vec::with_capacity(edge_count);
    for edge in 0..edge_count {
        let column = boundary.column(edge);
        match (column.rows(), column.entries()) {
            (&[tail, head], [-1, 1]) | (&[head, tail], [1, -1]) => ends.push([tail, head]),
            _ => {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!("column {edge} is not the boundary of an edge: it needs one -1 and one 1"),
                ));
            }
        }
    }
    let places = places_in_rotation(&ends, boundary.row_count(), rotation)?;
    // The edge at a distance counterclockwise from another around one of its ends: 0 the tail, 1 the head.
    let turned = |edge: u32, end: usize, back: bool| {
        let around = rotation.list(ends[edge as usize][end] as usize);
        let place = places[edge as usize][end] as usize;
        around[if back { (place + around.len() - 1) % around.len() } else { (place + 1) % around.len() }]
    };
    // The cycle that has each edge with its sign, and the one that has it against.
    let mut used = vec![[NOWHERE; 2]; edge_count];
    let (mut starts, mut rows, mut entries) = (vec![0u32], Vec::new(), Vec::new());
    for first in 0..edge_count as u32 {
        while let Some(sign) =
            [1, -1].into_iter().find(|&sign| used[first as usize][usize::from(sign < 0)] == NOWHERE)
        {
            let mut chain: Vec<(u32, i32)> = Vec::new();
            let cycle = starts.len() as u32 - 1;
            let mut add = |edge: u32, sign: i32| {
                let by = &mut used[edge as usize];
                let side = usize::from(sign < 0);
                if by[side] != NOWHERE || by[1 - side] == cycle {
                    return Err(Error::invalid(format!("edge {edge} has one face on both sides"))
                        .with_cure("remove bridges and dangling edges first"));
                }
                by[side] = cycle;
                chain.push((edge, sign));
                Ok(())
            };
            add(first, sign)?;
            // Which end of an edge is the head of a term, and which its tail.
            let [head_end, tail_end] = [|sign: i32| usize::from(sign > 0), |sign: i32| usize::from(sign < 0)];
            let (mut head, mut tail) = ((first, sign), (first, sign));
            loop {
                let vertex = ends[head.0 as usize][head_end(head.1)];
                let ahead = turned(head.0, head_end(head.1), true);
                let ahead = (ahead, if ends[ahead as usize][0] == vertex { 1 } else { -1 });
                if ahead == tail {
                    break;
                }
                add(ahead.0, ahead.1)?;
                head = ahead;
                let vertex = ends[tail.0 as usize][tail_end(tail.1)];
                let behind = turned(tail.0, tail_end(tail.1), false);
                let behind = (behind, if ends[behind as usize][1] == vertex { 1 } else { -1 });
                if behind == head {
                    break;
                }
                add(behind.0, behind.1)?;
                tail = behind;
            }
            chain.sort_unstable();
            rows.extend(chain.iter().map(|&(edge, _)| edge));
            entries.extend(chain.iter().map(|&(_, sign)| sign));
            starts.push(rows.len() as u32);
        }
    }
    SparseMatrix::from_parts(edge_count, starts, rows, entries)
}

/// The place of each edge among those around its tail and its head.
fn places_in_rotation(
    ends: &[[u32; 2]],
    vertex_count: usize,
    rotation: &RaggedArray,
) -> Result<Vec<[u32; 2]>, Error> {
    let fault = |message: String| Error::new(ErrorKind::Shape, message);
    if rotation.len() != vertex_count {
        return Err(fault(format!("there are {vertex_count} vertices, but rotations of {}", rotation.len())));
    }
    let mut places = vec![[NOWHERE; 2]; ends.len()];
    for (vertex, around) in rotation.iter().enumerate() {
        for (place, &edge) in around.iter().enumerate() {
            let end =
                ends.get(edge as usize).and_then(|ends| ends.iter().position(|&v| v as usize == vertex));
            let Some(end) = end else {
                return Err(fault(format!(
                    "edge {edge} is listed around vertex {vertex}, but does not end there"
                )));
            };
            if std::mem::replace(&mut places[edge as usize][end], place as u32) != NOWHERE {
                return Err(fault(format!("edge {edge} is listed twice around vertex {vertex}")));
            }
        }
    }
    match places.iter().position(|places| places.contains(&NOWHERE)) {
        Some(edge) => Err(fault(format!("edge {edge} is not listed around both its ends"))),
        None => Ok(places),
    }
}
