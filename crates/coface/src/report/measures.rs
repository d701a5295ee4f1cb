//! Areas and volumes of models.
//!
//! A polygon, planar or not, is measured by its vector area $A = \frac{1}{2} \sum_i p_i \wedge p_{i+1}$ and the mean c of
//! its vertices: its area is $|A|$, and the cone from the origin over it has the signed volume $\frac{1}{3} c \cdot A$. For
//! a planar polygon, convex or not, that is its area; for a skew quadrangle the volume is that under its bilinear
//! patch, so that the cells on its two sides agree on it.

use crate::algebra::RaggedArray;
use crate::cellular::CellShape;
use crate::geometry::Positions;
use rayon::prelude::*;

/// Faces or cells whose measures are summed in one piece: the pieces, and so the rounding, do not depend on threads.
const PIECE: usize = 1 << 13;

/// Points moved to their middle and scaled by a power of two, so that neither coordinates near the limits of floating
/// point nor models far from the origin spoil a sum.
pub(super) struct Ruler<'a> {
    positions: &'a Positions,
    middle: Vec<f64>,
    scale: f64,
    unit: f64,
}

impl<'a> Ruler<'a> {
    pub(super) fn new(positions: &'a Positions) -> Self {
        let dimension = positions.dimension();
        let mut low = vec![f64::INFINITY; dimension];
        let mut high = vec![f64::NEG_INFINITY; dimension];
        if dimension > 0 {
            for point in positions.as_flat().chunks_exact(dimension) {
                for (i, &x) in point.iter().enumerate() {
                    low[i] = low[i].min(x);
                    high[i] = high[i].max(x);
                }
            }
        }
        let largest = low.iter().zip(&high).map(|(&a, &b)| b / 2.0 - a / 2.0).fold(0.0, f64::max);
        // Between 2^-1021 and 2^1022, so that the unit and its inverse are both exact.
        let unit = if largest > 0.0 { largest.log2().floor().clamp(-1020.0, 1021.0).exp2() } else { 1.0 };
        let scale = unit.recip();
        let middle = low.iter().zip(&high).map(|(&a, &b)| (a / 2.0 + b / 2.0) * scale).collect();
        Self { positions, middle, scale, unit }
    }

    /// The sum of the areas of polygons: of their vector areas in space, of bivectors in higher dimensions.
    pub(super) fn area(&self, polygons: &RaggedArray) -> f64 {
        let total = match self.positions.dimension() {
            0 | 1 => 0.0,
            3 => sum(polygons.len(), |i| norm(&self.cone(polygons.list(i).iter().copied()).0)),
            dimension => sum(polygons.len(), |i| self.bivector_norm(polygons.list(i), dimension)),
        };
        total * self.unit * self.unit
    }

    /// The sum of the signed volumes of the cones over polygons in space: what a closed surface encloses.
    pub(super) fn enclosed_volume(&self, polygons: &RaggedArray) -> f64 {
        let total = sum(polygons.len(), |i| self.cone(polygons.list(i).iter().copied()).1);
        total * self.unit * self.unit * self.unit
    }

    /// The sum of the signed volumes of 3-cells in space.
    pub(super) fn cell_volume(&self, shapes: &[CellShape], cells: &RaggedArray) -> f64 {
        let volume = |i: usize| {
            let vertices = cells.list(i);
            shapes[i]
                .faces()
                .iter()
                .map(|face| self.cone(face.iter().map(|&corner| vertices[corner])).1)
                .sum::<f64>()
        };
        sum(cells.len(), volume) * self.unit * self.unit * self.unit
    }

    fn point(&self, vertex: u32) -> [f64; 3] {
        let start = 3 * vertex as usize;
        let point = &self.positions.as_flat()[start..start + 3];
        std::array::from_fn(|i| point[i] * self.scale - self.middle[i])
    }

    /// The vector area of a polygon and the signed volume of the cone over it, in scaled units.
    fn cone(&self, mut vertices: impl ExactSizeIterator<Item = u32>) -> ([f64; 3], f64) {
        let count = vertices.len() as f64;
        let Some(first) = vertices.next() else { return ([0.0; 3], 0.0) };
        let corner = self.point(first);
        // Relative to the first corner, so that small faces far away keep their digits.
        let (mut doubled, mut offset, mut last) = ([0.0; 3], [0.0; 3], [0.0; 3]);
        for vertex in vertices {
            let point = self.point(vertex);
            let side: [f64; 3] = std::array::from_fn(|i| point[i] - corner[i]);
            let cross = cross(&last, &side);
            for i in 0..3 {
                doubled[i] += cross[i];
                offset[i] += side[i];
            }
            last = side;
        }
        let area = doubled.map(|x| x / 2.0);
        let volume = (0..3).map(|i| (corner[i] + offset[i] / count) * area[i]).sum::<f64>() / 3.0;
        (area, volume)
    }

    fn bivector_norm(&self, polygon: &[u32], dimension: usize) -> f64 {
        let flat = self.positions.as_flat();
        let at = |vertex: u32, i: usize| flat[vertex as usize * dimension + i] * self.scale - self.middle[i];
        let mut square = 0.0;
        for i in 0..dimension {
            for j in i + 1..dimension {
                let corner = (at(polygon[0], i), at(polygon[0], j));
                let mut doubled = 0.0;
                for pair in polygon[1..].windows(2) {
                    let a = (at(pair[0], i) - corner.0, at(pair[0], j) - corner.1);
                    let b = (at(pair[1], i) - corner.0, at(pair[1], j) - corner.1);
                    doubled += a.0 * b.1 - a.1 * b.0;
                }
                square += doubled * doubled;
            }
        }
        square.sqrt() / 2.0
    }
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn norm(a: &[f64; 3]) -> f64 {
    (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt()
}

/// The sum of `measure` over `0..count`, in pieces whose sums are added in order with the rounding errors kept.
fn sum(count: usize, measure: impl Fn(usize) -> f64 + Sync) -> f64 {
    let pieces: Vec<f64> = (0..count.div_ceil(PIECE))
        .into_par_iter()
        .map(|piece| (piece * PIECE..count.min((piece + 1) * PIECE)).map(&measure).sum())
        .collect();
    let (mut total, mut lost) = (0.0_f64, 0.0);
    for piece in pieces {
        let next = total + piece;
        lost += if total.abs() >= piece.abs() { (total - next) + piece } else { (piece - next) + total };
        total = next;
    }
    total + lost
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
    }

    /// A box with corners numbered as a hexahedron, and its outward faces.
    fn cuboid(corner: [f64; 3], size: [f64; 3]) -> (Positions, RaggedArray) {
        let at = |i: usize, j: usize, k: usize| {
            [corner[0] + size[0] * i as f64, corner[1] + size[1] * j as f64, corner[2] + size[2] * k as f64]
        };
        let points = [
            at(0, 0, 0),
            at(1, 0, 0),
            at(1, 1, 0),
            at(0, 1, 0),
            at(0, 0, 1),
            at(1, 0, 1),
            at(1, 1, 1),
            at(0, 1, 1),
        ];
        let faces = CellShape::Hexahedron.faces().iter();
        let faces = faces.map(|face| face.iter().map(|&i| i as u32).collect::<Vec<_>>());
        (Positions::from_flat(3, points.concat()).unwrap(), RaggedArray::from_lists(faces))
    }

    #[test]
    fn a_box_has_its_area_and_volume_wherever_it_stands() {
        for (corner, size) in [
            ([0.0; 3], [2.0, 3.0, 4.0]),
            ([1e6, -1e6, 3.0], [2.0, 3.0, 4.0]),
            ([-1e38; 3], [2e38, 3e38, 4e38]),
        ] {
            let (positions, faces) = cuboid(corner, size);
            let ruler = Ruler::new(&positions);
            let [a, b, c] = size;
            assert!(close(ruler.area(&faces), 2.0 * (a * b + b * c + c * a)));
            assert!(close(ruler.enclosed_volume(&faces), a * b * c));
            let cells = RaggedArray::from_lists([[0, 1, 2, 3, 4, 5, 6, 7]]);
            assert!(close(ruler.cell_volume(&[CellShape::Hexahedron], &cells), a * b * c));
        }
    }

    #[test]
    fn a_polygon_need_not_be_convex() {
        // An L of three unit squares, in the plane and in a plane of a space of four dimensions.
        let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
        let polygon = RaggedArray::from_lists([[0, 1, 2, 3, 4, 5]]);
        let flat: Vec<f64> = corners.iter().flat_map(|&(x, y)| [x, y]).collect();
        assert!(close(Ruler::new(&Positions::from_flat(2, flat).unwrap()).area(&polygon), 3.0));
        let flat: Vec<f64> = corners.iter().flat_map(|&(x, y)| [x, y, 0.0]).collect();
        assert!(close(Ruler::new(&Positions::from_flat(3, flat).unwrap()).area(&polygon), 3.0));
        let flat: Vec<f64> = corners.iter().flat_map(|&(x, y)| [x, y, -y, x]).collect();
        assert!(close(Ruler::new(&Positions::from_flat(4, flat).unwrap()).area(&polygon), 6.0));
    }

    #[test]
    fn a_skew_cell_measures_the_same_from_both_sides() {
        // Two hexahedra on a common skew face fill the box that the face divides.
        let (positions, _) = cuboid([0.0; 3], [1.0; 3]);
        let mut flat = positions.as_flat().to_vec();
        for z in [14, 17, 20, 23] {
            flat[z] = [0.3, 0.9, 0.2, 0.7][(z - 14) / 3];
        }
        for corner in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
            flat.extend([corner[0], corner[1], 1.5]);
        }
        let positions = Positions::from_flat(3, flat).unwrap();
        let cells = RaggedArray::from_lists([[0, 1, 2, 3, 4, 5, 6, 7], [4, 5, 6, 7, 8, 9, 10, 11]]);
        let volume = Ruler::new(&positions).cell_volume(&[CellShape::Hexahedron; 2], &cells);
        assert!(close(volume, 1.5), "{volume}");
    }

    #[test]
    fn nothing_measures_nothing() {
        let positions = Positions::from_flat(3, vec![1.0; 9]).unwrap();
        let ruler = Ruler::new(&positions);
        assert_eq!(ruler.area(&RaggedArray::new()), 0.0);
        assert_eq!(ruler.area(&RaggedArray::from_lists([[0, 1, 2]])), 0.0);
        assert_eq!(Ruler::new(&Positions::default()).enclosed_volume(&RaggedArray::new()), 0.0);
    }
}
