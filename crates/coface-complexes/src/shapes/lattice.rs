//! Cells of a box of lattice points, some of which are identified by a rule.

use super::{CellKind, PlacedCells, turn_cell};
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{RaggedArray, Sign};
use coface_geometry::Positions;

/// A box of cells, `shape[a]` along axis a, on the lattice points `0..=shape[a]`, and what becomes of them.
pub(super) struct Lattice<'a> {
    pub(super) shape: &'a [u32],
    /// The number of coordinates of a point.
    pub(super) space: usize,
    /// Takes a lattice point to the one that stands for all that are identified with it, which it leaves.
    pub(super) glue: &'a dyn Fn(&mut [u32]),
    /// Whether simplices walk down along this axis in cells at this index; they walk up elsewhere. Simplices of neighbors fit
    /// whatever the rule, because cells that share a facet differ along the axis across it alone.
    pub(super) is_downward: &'a dyn Fn(usize, u32) -> bool,
    /// Appends the coordinates of a lattice point.
    pub(super) place: &'a dyn Fn(&[u32], &mut Vec<f64>),
}

/// No lattice point is identified with another.
pub(super) fn apart(_: &mut [u32]) {}

/// All simplices walk up.
pub(super) fn upward(_: usize, _: u32) -> bool {
    false
}

impl Lattice<'_> {
    /// The cells, with the orientation of the axes in their order. A cell is cut into simplices that walk along its axes
    /// in all orders; simplices that the rule flattens are left out. Cuboids must not be flattened.
    ///
    /// # References
    /// H. W. Kuhn, *Some combinatorial lemmas in topology* (1960).
    pub(super) fn cells(&self, kind: CellKind) -> Result<PlacedCells, Error> {
        let dimension = self.shape.len();
        let (positions, vertex_of_point) = self.vertices(kind)?;
        let strides = strides(self.shape);
        let walks = match kind {
            CellKind::Simplex => walks(dimension),
            CellKind::Cuboid => Vec::new(),
        };
        let width = kind.vertex_count(dimension).expect("the number of points has been checked");
        let (mut items, mut cell) = (Vec::new(), vec![0u32; width]);
        let mut place = vec![0u32; dimension];
        let cell_count: usize = self.shape.iter().map(|&n| n as usize).product();
        for _ in 0..cell_count {
            let low: usize = place.iter().zip(&strides).map(|(&i, stride)| i as usize * stride).sum();
            if kind == CellKind::Cuboid {
                for (i, vertex) in cell.iter_mut().enumerate() {
                    let up = |axis: usize| (i >> (dimension - 1 - axis) & 1) * strides[axis];
                    *vertex = vertex_of_point[low + (0..dimension).map(up).sum::<usize>()];
                }
                items.extend_from_slice(&cell);
            }
            for (order, parity) in &walks {
                let mut sign = *parity;
                let is_down = |axis: usize| (self.is_downward)(axis, place[axis]);
                let start: usize =
                    (0..dimension).filter(|&axis| is_down(axis)).map(|axis| strides[axis]).sum();
                let mut at = low + start;
                cell[0] = vertex_of_point[at];
                for (i, &axis) in order.iter().enumerate() {
                    if is_down(axis) {
                        at -= strides[axis];
                        sign = sign.opposite();
                    } else {
                        at += strides[axis];
                    }
                    cell[i + 1] = vertex_of_point[at];
                }
                if (1..width).all(|i| !cell[..i].contains(&cell[i])) {
                    items.extend_from_slice(&cell);
                    if sign == Sign::Minus {
                        let last = items.len() - width;
                        turn_cell(kind, &mut items[last..]);
                    }
                }
            }
            step(&mut place, self.shape);
        }
        Ok(PlacedCells::from_trusted(positions, kind, dimension, RaggedArray::uniform(width, items)?))
    }

    /// The positions of the points that stand for others, in lexicographic order, and the number of each lattice point.
    fn vertices(&self, kind: CellKind) -> Result<(Positions, Vec<u32>), Error> {
        check_size(self.shape, kind)?;
        let sides: Vec<u32> = self.shape.iter().map(|&n| n + 1).collect();
        let count: usize = sides.iter().map(|&n| n as usize).product();
        let strides = strides(self.shape);
        let (mut coordinates, mut vertex_of_point) = (Vec::new(), vec![0u32; count]);
        let (mut place, mut image) = (vec![0u32; sides.len()], vec![0u32; sides.len()]);
        let mut next = 0;
        // Points that stand for others may come after them.
        for pass in 0..2 {
            for point in 0..count {
                image.copy_from_slice(&place);
                (self.glue)(&mut image);
                if pass == 0 && image == place {
                    (self.place)(&place, &mut coordinates);
                    vertex_of_point[point] = next;
                    next += 1;
                } else if pass == 1 && image != place {
                    let target: usize =
                        image.iter().zip(&strides).map(|(&i, stride)| i as usize * stride).sum();
                    vertex_of_point[point] = vertex_of_point[target];
                }
                step(&mut place, &sides);
            }
        }
        Ok((Positions::from_flat(self.space, coordinates)?, vertex_of_point))
    }
}

/// How far the numbers of neighbors along each axis are apart, the last axis fastest.
fn strides(shape: &[u32]) -> Vec<usize> {
    let mut strides = vec![1; shape.len()];
    for axis in (1..shape.len()).rev() {
        strides[axis - 1] = strides[axis] * (shape[axis] as usize + 1);
    }
    strides
}

/// The next place of a box, the last axis fastest; after the last the first again.
fn step(place: &mut [u32], sides: &[u32]) {
    for axis in (0..place.len()).rev() {
        place[axis] += 1;
        if place[axis] < sides[axis] {
            return;
        }
        place[axis] = 0;
    }
}

/// All orders of the axes with their parities.
fn walks(dimension: usize) -> Vec<(Vec<usize>, Sign)> {
    let mut walks = vec![(Vec::new(), Sign::Plus)];
    for axis in 0..dimension {
        walks = walks
            .into_iter()
            .flat_map(|(order, sign)| {
                (0..=axis).map(move |place| {
                    let mut order = order.clone();
                    order.insert(place, axis);
                    (order, sign.times(Sign::power_of_minus_one(axis - place)))
                })
            })
            .collect();
    }
    walks
}

/// That a box has neither too many points nor too many corners of cells.
pub(super) fn check_size(shape: &[u32], kind: CellKind) -> Result<(), Error> {
    let points = shape.iter().try_fold(1u64, |product, &n| product.checked_mul(u64::from(n) + 1));
    let dimension = shape.len();
    let corners_of_cell = match kind {
        CellKind::Simplex if dimension <= 8 => (1..=dimension as u64 + 1).product(),
        CellKind::Cuboid if dimension <= 24 => 1u64 << dimension,
        _ => u64::MAX,
    };
    let corners = shape.iter().try_fold(corners_of_cell, |product, &n| product.checked_mul(u64::from(n)));
    if points.is_some_and(|n| n < 1 << 31) && corners.is_some_and(|n| n < 1 << 32) {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::TooLarge,
        format!("{shape:?} cells have over 2^31 vertices, or over 2^32 corners of {}", kind.plural()),
    )
    .with_cure("take fewer subdivisions"))
}

/// That a length is finite and positive.
pub(super) fn check_length(name: &str, length: f64) -> Result<(), Error> {
    if length.is_finite() && length > 0.0 {
        return Ok(());
    }
    Err(Error::invalid(format!("the {name} is {length}")).with_cure("give a positive number"))
}

/// That one length is less than another.
pub(super) fn check_less(name: &str, length: f64, other: &str, bound: f64) -> Result<(), Error> {
    check_length(other, bound)?;
    if length < bound {
        return Ok(());
    }
    Err(Error::invalid(format!("the {name}, {length}, is not less than the {other}, {bound}")))
}

/// That there are so many subdivisions at least.
pub(super) fn check_count(name: &str, count: u32, least: u32) -> Result<(), Error> {
    if count >= least {
        return Ok(());
    }
    Err(Error::invalid(format!("the number of {name} is {count}")).with_cure(format!("take {least} or more")))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(shape: &[u32], kind: CellKind, is_downward: &dyn Fn(usize, u32) -> bool) -> PlacedCells {
        let place = |place: &[u32], out: &mut Vec<f64>| out.extend(place.iter().map(|&i| f64::from(i)));
        Lattice { shape, space: shape.len(), glue: &apart, is_downward, place: &place }.cells(kind).unwrap()
    }

    #[test]
    fn a_square_by_hand() {
        let halves = plain(&[1, 1], CellKind::Simplex, &upward);
        assert_eq!(halves.cells(), &RaggedArray::from_lists([[1, 0, 3], [0, 2, 3]]));
        let square = plain(&[1, 1], CellKind::Cuboid, &upward);
        assert_eq!(square.cells(), &RaggedArray::from_lists([[0, 1, 2, 3]]));
    }

    #[test]
    fn directions_keep_neighbors_together_and_positive() {
        for rule in [
            (|_, _| false) as fn(usize, u32) -> bool,
            |_, i| i < 2,
            |axis, i| (i + axis as u32).is_multiple_of(2),
        ] {
            let cells = plain(&[3, 2, 2], CellKind::Simplex, &rule);
            assert_eq!(cells.cell_count(), 72);
            // The boundary of a box of cubes has two triangles a square: inner sides cancel.
            assert_eq!(cells.boundary().unwrap().cell_count(), 2 * 2 * (6 + 6 + 4));
            let volume: f64 = cells
                .cells()
                .iter()
                .map(|cell| {
                    let p = |i: usize| cells.positions().point(coface_algebra::VertexId::from_u32(cell[i]));
                    let edge = |i: usize, k: usize| p(i)[k] - p(0)[k];
                    let minor = |a: usize, b: usize| edge(2, a) * edge(3, b) - edge(2, b) * edge(3, a);
                    let volume =
                        edge(1, 0) * minor(1, 2) + edge(1, 1) * minor(2, 0) + edge(1, 2) * minor(0, 1);
                    assert_eq!(volume, 1.0);
                    volume
                })
                .sum();
            assert_eq!(volume, 72.0);
        }
    }

    #[test]
    fn sizes_are_checked_before_anything_is_made() {
        let error = check_size(&[1 << 16, 1 << 16], CellKind::Cuboid).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::TooLarge);
        assert!(check_size(&[1; 30], CellKind::Cuboid).is_err());
        assert!(check_size(&[u32::MAX], CellKind::Simplex).is_err());
        assert!(check_size(&[1000, 1000], CellKind::Simplex).is_ok());
    }
}
