//! Points with their copies around a periodic box.

use super::PeriodicBox;
use coface_algebra::{Error, ErrorKind, VertexId, memory};
use coface_geometry::Positions;

/// The points of a periodic box, and their copies within margins around it, one for each axis, in the order of points and, of the copies of one, of their shifts.
///
/// Coordinates are multiples of a power of two, of which the sides are multiples too: then copies are moved by whole sides exactly, and whatever is decided
/// of points is so of their copies.
pub(super) struct Copies {
    pub(super) positions: Positions,
    /// Which point each is a copy of.
    pub(super) points: Vec<u32>,
    /// By how many sides it is moved along each axis.
    pub(super) shifts: Vec<[i32; 3]>,
    /// Where the copies of each point begin, and where the last ones end.
    starts: Vec<u32>,
}

impl Copies {
    /// The copies of points of the dimension of the box.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for copies that no numbers, or no memory, are left for.
    pub(super) fn new(points: &Positions, domain: &PeriodicBox, margins: &[f64]) -> Result<Self, Error> {
        let dimension = domain.dimension();
        let axes = Axis::of(points, domain, margins);
        let sides = domain.lengths().iter().zip(margins);
        let about: f64 = sides.map(|(length, margin)| 1.0 + 2.0 * margin / length).product();
        let about = about * points.len() as f64;
        let bytes = if dimension > 2 { SPATIAL_BYTES } else { PLANAR_BYTES };
        memory::require((about * bytes) as u64, || {
            format!("the alpha complex of {} points with about {about:.0} copies around them", points.len())
        })?;
        if about >= f64::from(u32::MAX / 2) {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("about {about:.0} copies of points are too many"),
            )
            .with_cure("take fewer points, or a box whose sides differ less"));
        }
        let (mut flat, mut of, mut shifts, mut starts) = (Vec::new(), Vec::new(), Vec::new(), vec![0]);
        for id in 0..points.len() {
            let place: Vec<f64> =
                axes.iter().zip(points.point(VertexId::new(id))).map(|(axis, &x)| axis.place(x)).collect();
            let ranges: Vec<std::ops::RangeInclusive<i32>> = axes
                .iter()
                .zip(&place)
                .zip(margins)
                .map(|((axis, &x), &margin)| axis.shifts(x, margin))
                .collect();
            let along = |axis: usize| ranges.get(axis).cloned().unwrap_or(0..=0);
            for x in along(0) {
                for y in along(1) {
                    for z in along(2) {
                        let shift = [x, y, z];
                        let moved = place.iter().zip(&axes).zip(shift);
                        flat.extend(moved.map(|((x, axis), by)| x + f64::from(by) * axis.length));
                        of.push(id as u32);
                        shifts.push(shift);
                    }
                }
            }
            starts.push(of.len() as u32);
        }
        Ok(Self { positions: Positions::from_flat(dimension, flat)?, points: of, shifts, starts })
    }

    /// The copy of a point that is moved by so many sides.
    pub(super) fn copy(&self, point: u32, shift: [i32; 3]) -> Option<u32> {
        let [from, to] = [0, 1].map(|next| self.starts[point as usize + next] as usize);
        self.shifts[from..to].binary_search(&shift).ok().map(|at| (from + at) as u32)
    }

    /// Copies, moved back by a shift; none if one of them is not there.
    pub(super) fn moved_back(&self, ids: &[u32], by: [i32; 3]) -> Option<Vec<u32>> {
        if by == [0; 3] {
            return Some(ids.to_vec());
        }
        let moved = |&id: &u32| {
            let shift = self.shifts[id as usize];
            self.copy(self.points[id as usize], std::array::from_fn(|axis| shift[axis] - by[axis]))
        };
        ids.iter().map(moved).collect()
    }
}

/// Whether no coordinate and no side has to be rounded for a margin.
pub(super) fn are_exact(points: &Positions, domain: &PeriodicBox, margin: f64) -> bool {
    let axes = Axis::of(points, domain, &vec![margin; domain.dimension()]);
    let is_multiple = |axis: &Axis, x: f64| (x / axis.unit).fract() == 0.0;
    let all = points.as_flat().chunks(domain.dimension().max(1));
    axes.iter().all(|axis| axis.length == axis.given)
        && all.into_iter().all(|point| axes.iter().zip(point).all(|(axis, &x)| is_multiple(axis, x)))
}

/// Bytes for each point of space and of the plane, as measured.
const SPATIAL_BYTES: f64 = 4000.0;
const PLANAR_BYTES: f64 = 1000.0;

/// A side of the box with the unit that coordinates along it are multiples of.
struct Axis {
    length: f64,
    given: f64,
    unit: f64,
}

impl Axis {
    fn of(points: &Positions, domain: &PeriodicBox, margins: &[f64]) -> Vec<Self> {
        debug_assert!(points.is_empty() || points.dimension() == domain.dimension());
        let axis = |(&given, margin): (&f64, &f64)| {
            // All copies lie between minus and plus this number.
            let most = 2.0 * given + margin;
            let unit = 2f64.powi(most.log2().floor() as i32 + 1 - 52);
            Self { length: (given / unit).round() * unit, given, unit }
        };
        domain.lengths().iter().zip(margins).map(axis).collect()
    }

    /// The place in the box of a coordinate.
    fn place(&self, x: f64) -> f64 {
        let place = (x.rem_euclid(self.given) / self.unit).round() * self.unit;
        if place >= self.length { place - self.length } else { place }
    }

    /// By how many sides a coordinate in the box may be moved to stay within a margin around it.
    fn shifts(&self, x: f64, margin: f64) -> std::ops::RangeInclusive<i32> {
        let least = ((-margin - x) / self.length).ceil();
        let most = ((self.length + margin - x) / self.length).floor();
        least as i32..=most as i32
    }
}
