//! Cells of the grid as cubes of the image.

use super::super::filtration::ImageFiltration;
use super::super::gradient::Gradient;

/// How the cells of the grid are cubes, by their numbers in doubled places: those of an image whose voxels are twice as many along each axis, and one more
/// where an axis has ends, with the last axis running fastest.
pub(super) struct Cubes<'a> {
    gradient: &'a Gradient,
    is_dual: bool,
    /// For each axis of the grid: the step of a doubled place, and how many there are.
    along: Vec<(u64, u64)>,
    /// For each choice of axes that a cell extends along what that adds to the number of its cube, and whether the cube is turned.
    extents: Vec<(u64, bool)>,
    /// For each row of vertices along the last axis of the grid the number of the cube at the first one, modulo 2^64; empty if an axis is periodic.
    rows: Vec<u64>,
    row_length: usize,
    /// What is added to a cube for each side of the axes of a single voxel that have ends, to which the grid does not extend.
    sides: Vec<u64>,
}

/// The steps between the numbers of cubes along axes with so many places.
pub(super) fn steps(lengths: &[u64]) -> Vec<u64> {
    let mut steps = vec![1; lengths.len()];
    for axis in (1..lengths.len()).rev() {
        steps[axis - 1] = steps[axis] * lengths[axis];
    }
    steps
}

impl<'a> Cubes<'a> {
    pub(super) fn new(image: &ImageFiltration, gradient: &'a Gradient) -> Self {
        let lengths = image.doubled_shape();
        let long = image.long_axis_numbers();
        let steps = steps(&lengths);
        let along: Vec<(u64, u64)> = long.iter().map(|&axis| (steps[axis], lengths[axis])).collect();
        let mut sides = vec![0];
        if image.is_dual() {
            let circles = image.circles();
            for axis in (0..lengths.len()).filter(|axis| !long.contains(axis) && !circles.contains(*axis)) {
                sides.extend(sides.iter().map(|side| side + 2 * steps[axis]).collect::<Vec<_>>());
            }
        }
        let grid = &gradient.grid;
        let axes_of = |extents: usize| (0..along.len()).filter(move |axis| extents >> axis & 1 == 1);
        let extents = (0..1usize << along.len()).map(|extents| {
            let step = axes_of(extents).map(|axis| along[axis].0).sum();
            (step, image.is_dual() && axes_of(extents).filter(|axis| axis % 2 == 0).count() % 2 == 1)
        });
        let extents = extents.collect();
        let row_length = grid.row_length();
        let is_dual = image.is_dual();
        let mut cubes = Self { gradient, is_dual, along, extents, rows: Vec::new(), row_length, sides };
        if !grid.is_periodic() {
            let first = (0..grid.vertex_count()).step_by(row_length);
            cubes.rows = first.map(|vertex| cubes.first_cube(vertex)).collect();
        }
        cubes
    }

    /// The cube of a vertex as if it had no extent, modulo 2^64: for those in the layer around it is none.
    fn first_cube(&self, vertex: usize) -> u64 {
        let place = |axis: usize| 2 * self.gradient.grid.along(vertex, axis) + i64::from(self.is_dual);
        let term = |(axis, &(step, _)): (usize, &(u64, u64))| place(axis).cast_unsigned().wrapping_mul(step);
        self.along.iter().enumerate().map(term).fold(0, u64::wrapping_add)
    }

    /// The number of the cube of the cell at a place, on the first side of axes of a single voxel, and whether it is turned. A cube of the dual image is the dual of a cell
    /// of the grid, whose coboundary is its boundary, if those that span an odd number of axes with even numbers in the grid are turned.
    pub(super) fn cube(&self, place: usize) -> (u64, bool) {
        let (vertex, extents) = self.gradient.grid.first_vertex(place);
        let (step, is_turned) = self.extents[extents];
        if !self.rows.is_empty() {
            // The last axis of the grid is the last long one of the image.
            let (row, at) = (vertex / self.row_length, vertex % self.row_length);
            let along = 2 * self.along[self.along.len() - 1].0 * at as u64;
            return (self.rows[row].wrapping_add(along).wrapping_add(step), is_turned);
        }
        let mut cube = 0;
        for (axis, &(step, length)) in self.along.iter().enumerate() {
            let (at, extends) = (self.gradient.grid.along(vertex, axis), extents >> axis & 1 == 1);
            let place = 2 * at + i64::from(self.is_dual) + i64::from(extends);
            cube += place.cast_unsigned() % length * step;
        }
        (cube, is_turned)
    }

    /// What is added to a cube to have it on each side of the axes of a single voxel that have ends: cochains are the same there.
    pub(super) fn sides(&self) -> &[u64] {
        &self.sides
    }
}
