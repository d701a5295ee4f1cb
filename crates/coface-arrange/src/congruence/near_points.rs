//! Pairs of points that are near each other.

use coface_algebra::VertexId;
use coface_algebra::progress::{Steps, stage};
use coface_geometry::Positions;
use rayon::prelude::*;
use std::cmp::Ordering;

/// Fewer points than this are compared each with each.
const FEW: usize = 32;
/// Points a cell of a grid has, about.
const PER_CELL: usize = 8;
/// More points than this are first put into cells that fit a cache, and there into smaller ones.
const MANY: usize = 1 << 15;

/// A point with its first three coordinates, missing ones zero.
#[derive(Clone, Copy)]
struct Point {
    at: [f64; 3],
    id: u32,
}

/// Finds near points: at most `tolerance` apart, in any dimension.
///
/// A grid over the first three coordinates is refined where points are many. A point near the wall of a cell belongs to
/// the cells on both sides, so that two near points are in one cell somewhere. Cells are at least four tolerances wide;
/// what is denser is cut into cubes all of whose points are near each other.
pub(super) struct NearPoints<'a> {
    positions: &'a Positions,
    tolerance: f64,
    /// Points, as often as they are compared with others.
    steps: Steps,
}

impl<'a> NearPoints<'a> {
    /// Pairs of near points that connect all points that are joined by chains of near ones.
    pub(super) fn connecting(positions: &'a Positions, tolerance: f64) -> Vec<[u32; 2]> {
        Self { positions, tolerance, steps: stage("finding near points", 0) }.pairs()
    }

    fn pairs(&self) -> Vec<[u32; 2]> {
        let points: Vec<Point> = (0..self.positions.len() as u32)
            .into_par_iter()
            .map(|id| {
                let mut at = [0.0; 3];
                for (own, &coordinate) in at.iter_mut().zip(self.positions.point(VertexId::from_u32(id))) {
                    *own = coordinate;
                }
                Point { at, id }
            })
            .collect();
        let mut pairs = Vec::new();
        self.visit(&points, &mut pairs);
        pairs
    }

    fn is_near(&self, p: &Point, q: &Point) -> bool {
        if self.positions.dimension() <= 3 {
            return is_near(&p.at, &q.at, self.tolerance);
        }
        let [p, q] = [p, q].map(|point| self.positions.point(VertexId::from_u32(point.id)));
        is_near(p, q, self.tolerance)
    }

    fn visit(&self, points: &[Point], pairs: &mut Vec<[u32; 2]>) {
        if points.len() <= FEW {
            return self.compare(points, pairs);
        }
        let Some(grid) = Grid::new(points, self.tolerance) else { return self.visit_dense(points, pairs) };
        if points.len() > MANY {
            return self.visit_many(&grid, points, pairs);
        }
        let (starts, sorted) = grid.distribute(points);
        for range in starts.windows(2) {
            self.visit(&sorted[range[0]..range[1]], pairs);
        }
    }

    /// Distributes parts of the points, then visits the boxes, in parallel.
    fn visit_many(&self, grid: &Grid, points: &[Point], pairs: &mut Vec<[u32; 2]>) {
        let parts: Vec<(Vec<usize>, Vec<Point>)> =
            points.par_chunks(MANY).map(|part| grid.distribute(part)).collect();
        let found: Vec<Vec<[u32; 2]>> = (0..grid.box_count())
            .into_par_iter()
            .map(|place| {
                let own = |part: &'_ (Vec<usize>, Vec<Point>)| part.0[place]..part.0[place + 1];
                let mut together = Vec::with_capacity(parts.iter().map(|part| own(part).len()).sum());
                for part in &parts {
                    together.extend_from_slice(&part.1[own(part)]);
                }
                let mut found = Vec::new();
                self.visit(&together, &mut found);
                found
            })
            .collect();
        found.into_iter().for_each(|found| pairs.extend(found));
    }

    /// Each with each.
    fn compare(&self, points: &[Point], pairs: &mut Vec<[u32; 2]>) {
        self.steps.advance(points.len());
        let (mut few, mut many) = ([0; FEW], Vec::new());
        let classes = match few.get_mut(..points.len()) {
            Some(few) => few,
            None => {
                many.resize(points.len(), 0);
                &mut many[..]
            }
        };
        for (i, p) in points.iter().enumerate() {
            classes[i] = i as u32;
            for (j, q) in points.iter().enumerate().take(i) {
                let (old, new) = (classes[i], classes[j]);
                if old != new && self.is_near(p, q) {
                    pairs.push([p.id.min(q.id), p.id.max(q.id)]);
                    classes[..=i].iter_mut().filter(|class| **class == old).for_each(|class| *class = new);
                }
            }
        }
    }

    /// Each with the next one that is equal to it.
    fn connect_equal(&self, points: &[Point], pairs: &mut Vec<[u32; 2]>) {
        let point = |id: u32| self.positions.point(VertexId::from_u32(id));
        let mut ids: Vec<u32> = points.iter().map(|p| p.id).collect();
        ids.sort_unstable_by(|&a, &b| {
            // Coordinates are numbers, and zeros of both signs are equal.
            point(a).partial_cmp(point(b)).unwrap_or(Ordering::Equal).then(a.cmp(&b))
        });
        pairs.extend(ids.windows(2).filter(|ids| point(ids[0]) == point(ids[1])).map(|ids| [ids[0], ids[1]]));
    }

    /// Many points within a few tolerances.
    fn visit_dense(&self, points: &[Point], pairs: &mut Vec<[u32; 2]>) {
        if self.tolerance == 0.0 {
            return self.connect_equal(points, pairs);
        }
        if self.positions.dimension() > 3 {
            return self.compare(points, pairs);
        }
        // A little less than fits, so that rounding makes no cube too large; halves, so that differences are finite.
        let side = self.tolerance / 1.75 / 2.0;
        let low = bounds(points)[0].map(|x| x / 2.0);
        let cube = |p: &Point| [0, 1, 2].map(|axis| ((p.at[axis] / 2.0 - low[axis]) / side) as i64);
        let mut cubes: Vec<([i64; 3], Point)> = points.iter().map(|p| (cube(p), *p)).collect();
        cubes.sort_unstable_by_key(|(cube, p)| (*cube, p.id));
        let groups: Vec<&[([i64; 3], Point)]> = cubes.chunk_by(|a, b| a.0 == b.0).collect();
        let mut classes: Vec<u32> = (0..groups.len() as u32).collect();
        for (i, group) in groups.iter().enumerate() {
            for (_, p) in &group[1..] {
                let first = group[0].1.id;
                pairs.push([p.id.min(first), p.id.max(first)]);
            }
            for (j, other) in groups.iter().enumerate().take(i) {
                let (old, new) = (classes[i], classes[j]);
                let is_far = (0..3).any(|axis| (group[0].0[axis] - other[0].0[axis]).abs() > 2);
                if old == new || is_far {
                    continue;
                }
                let near = group.iter().find_map(|(_, p)| {
                    other
                        .iter()
                        .find(|(_, q)| self.is_near(p, q))
                        .map(|(_, q)| [p.id.min(q.id), p.id.max(q.id)])
                });
                if let Some(pair) = near {
                    pairs.push(pair);
                    classes[..=i].iter_mut().filter(|class| **class == old).for_each(|class| *class = new);
                }
            }
        }
    }
}

/// Whether two points are at most `tolerance` apart.
#[inline]
pub(crate) fn is_near(p: &[f64], q: &[f64], tolerance: f64) -> bool {
    if (1e-150..1e150).contains(&tolerance) {
        let square: f64 = p.iter().zip(q).map(|(x, y)| (x - y) * (x - y)).sum();
        return square <= tolerance * tolerance;
    }
    // Squares would be lost or endless.
    let square: f64 = p.iter().zip(q).map(|(x, y)| ((x - y) / tolerance).powi(2)).sum();
    if tolerance == 0.0 { p == q } else { square <= 1.0 }
}

/// The least and the greatest coordinates.
fn bounds(points: &[Point]) -> [[f64; 3]; 2] {
    let [mut low, mut high] = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for point in points {
        for ((low, high), &x) in low.iter_mut().zip(&mut high).zip(&point.at) {
            *low = low.min(x);
            *high = high.max(x);
        }
    }
    [low, high]
}

/// A grid of equal boxes.
struct Grid {
    /// The least coordinates, halved: differences of halves are finite.
    low: [f64; 3],
    /// Boxes two units of length.
    scale: [f64; 3],
    /// How far a point reaches, in boxes: the tolerance, and a little more for the rounding of places.
    reach: [f64; 3],
    counts: [usize; 3],
}

impl Grid {
    /// A grid with about one box for a few points, at least two of them; `None` if the points are within a few
    /// tolerances.
    fn new(points: &[Point], tolerance: f64) -> Option<Self> {
        let [low, high] = bounds(points).map(|corner| corner.map(|x| x / 2.0));
        let extent = [0, 1, 2].map(|axis| high[axis] - low[axis]);
        // Half of four tolerances.
        let least = 2.0 * tolerance;
        let wide: Vec<usize> =
            (0..3).filter(|&axis| extent[axis] > 2.0 * least && extent[axis] > 0.0).collect();
        if wide.is_empty() {
            return None;
        }
        // Sides of boxes so that all together fill the bounds; thin axes are not cut.
        let per_box = if points.len() > MANY { MANY / 16 } else { PER_CELL };
        let boxes = (points.len() / per_box) as f64;
        let longest = wide.iter().map(|&axis| extent[axis]).fold(0.0, f64::max);
        let product: f64 = wide.iter().map(|&axis| extent[axis] / longest).product();
        let side = longest * (product / boxes).powf(1.0 / wide.len() as f64);
        let mut counts = [1; 3];
        let mut most = points.len();
        for &axis in &wide {
            let wanted = (extent[axis] / side).min(extent[axis] / least).min(most as f64);
            counts[axis] = (wanted as usize).max(if extent[axis] == longest { 2 } else { 1 });
            most = (most / counts[axis]).max(1);
        }
        let scale =
            [0, 1, 2].map(|axis| if counts[axis] > 1 { counts[axis] as f64 / extent[axis] } else { 0.0 });
        let reach =
            [0, 1, 2].map(|axis| tolerance / 2.0 * 1.000_001 * scale[axis] + counts[axis] as f64 * 1e-15);
        scale.iter().all(|scale| scale.is_finite()).then_some(Self { low, scale, reach, counts })
    }

    fn box_count(&self) -> usize {
        self.counts.iter().product()
    }

    /// The points by boxes: those of box b are `starts[b]..starts[b + 1]`, with those beyond its walls that are within
    /// the tolerance.
    fn distribute(&self, points: &[Point]) -> (Vec<usize>, Vec<Point>) {
        const SEVERAL: u32 = u32::MAX;
        let mut starts = vec![0; self.box_count() + 1];
        let place_of = |point: &Point| {
            let mut own = SEVERAL;
            let mut count = 0;
            self.boxes(point, |place| {
                starts[place + 1] += 1;
                own = u32::try_from(place).unwrap_or(SEVERAL);
                count += 1;
            });
            if count == 1 { own } else { SEVERAL }
        };
        let places: Vec<u32> = points.iter().map(place_of).collect();
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut sorted = vec![points[0]; starts[starts.len() - 1]];
        for (point, &own) in points.iter().zip(&places) {
            let mut put = |place: usize| {
                sorted[next[place]] = *point;
                next[place] += 1;
            };
            match own {
                SEVERAL => self.boxes(point, put),
                place => put(place as usize),
            }
        }
        (starts, sorted)
    }

    #[inline]
    fn boxes(&self, point: &Point, mut visit: impl FnMut(usize)) {
        let ends = |axis: usize| {
            let place = (point.at[axis] / 2.0 - self.low[axis]) * self.scale[axis];
            // Casts take what is below zero to zero.
            [place - self.reach[axis], place + self.reach[axis]]
                .map(|end| (end as usize).min(self.counts[axis] - 1))
        };
        let [x, y, z] = [ends(0), ends(1), ends(2)];
        for i in x[0]..=x[1] {
            for j in y[0]..=y[1] {
                for k in z[0]..=z[1] {
                    visit((i * self.counts[1] + j) * self.counts[2] + k);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::UnionFind;
    use proptest::prelude::*;

    fn brute(positions: &Positions, tolerance: f64) -> Vec<[u32; 2]> {
        let point = |i: u32| positions.point(VertexId::from_u32(i));
        let mut pairs = Vec::new();
        for i in 0..positions.len() as u32 {
            for j in i + 1..positions.len() as u32 {
                let square: f64 = point(i).iter().zip(point(j)).map(|(x, y)| (x - y) * (x - y)).sum();
                if square <= tolerance * tolerance {
                    pairs.push([i, j]);
                }
            }
        }
        pairs
    }

    fn classes(count: usize, pairs: &[[u32; 2]]) -> Vec<u32> {
        let mut partition = UnionFind::new(count);
        pairs.iter().for_each(|&[a, b]| {
            partition.unite(a, b);
        });
        partition.class_numbers()
    }

    /// So many that they go through cells of two sizes: the edges of a square lattice.
    #[test]
    fn many_points_are_near_their_neighbors_only() {
        let side = 200;
        assert!(side * side > MANY);
        let flat = (0..side * side).flat_map(|i| [i / side, i % side].map(|x| x as f64)).collect();
        let positions = Positions::from_flat(2, flat).unwrap();
        let mut expected = Vec::new();
        for i in 0..(side * side) as u32 {
            let place = i as usize;
            expected.extend((place % side + 1 < side).then_some([i, i + 1]));
            expected.extend((place / side + 1 < side).then_some([i, i + side as u32]));
        }
        assert!(NearPoints::connecting(&positions, 0.99).is_empty());
        let connecting = NearPoints::connecting(&positions, 1.0);
        assert!(connecting.iter().all(|pair| expected.binary_search(pair).is_ok()));
        assert!(classes(positions.len(), &connecting).iter().all(|&class| class == 0));
    }

    /// Coordinates whose differences or squares are no numbers of the machine, or are lost.
    #[test]
    fn huge_and_tiny_numbers_are_compared() {
        let found = |flat: Vec<f64>, tolerance: f64| {
            let positions = Positions::from_flat(1, flat).unwrap();
            let mut found = classes(positions.len(), &NearPoints::connecting(&positions, tolerance));
            found.dedup();
            found
        };
        let mut far: Vec<f64> = vec![-1.7e308; 40];
        far.extend([1.7e308; 40]);
        for tolerance in [0.0, 1e-300, 1.0, 1e160, 1e308] {
            assert_eq!(found(far.clone(), tolerance), [0, 1], "{tolerance}");
        }
        assert_eq!(found(vec![0.0, 1e-200, 1e-170], 0.0), [0, 1, 2]);
        assert_eq!(found(vec![0.0, 1e-200, 1e-170], 1e-190), [0, 1]);
        assert_eq!(found(vec![0.0, 1e160, 1e170], 1e161), [0, 1]);
        assert_eq!(found(vec![0.0, -0.0, 1.0], 0.0), [0, 1]);
    }

    /// Far too many to be compared each with each.
    #[test]
    fn equal_points_are_many() {
        let positions = Positions::from_flat(2, [0.5, 0.25].repeat(400_000)).unwrap();
        let found = NearPoints::connecting(&positions, 0.0);
        assert_eq!(found.len(), 399_999);
        assert!(classes(positions.len(), &found).iter().all(|&class| class == 0));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// Points on a lattice with a few far away, clusters and equal points among them, in dimensions 1 to 4.
        #[test]
        fn near_points_agree_with_all_pairs(
            dimension in 1usize..5,
            numbers in prop::collection::vec((0i32..40, prop::bool::weighted(0.1)), 0..400),
            tolerance in prop::sample::select(vec![0.0, 1.0, 1.5, 4.0, 30.0]),
            stretch in prop::sample::select(vec![1.0, 0.01, 1000.0]),
        ) {
            let flat: Vec<f64> = numbers
                .iter()
                .map(|&(number, is_far)| f64::from(number) * if is_far { stretch } else { 1.0 })
                .collect();
            let flat = flat[..flat.len() / dimension * dimension].to_vec();
            let positions = Positions::from_flat(dimension, flat).unwrap();
            let expected = brute(&positions, tolerance);
            let connecting = NearPoints::connecting(&positions, tolerance);
            prop_assert!(connecting.iter().all(|pair| expected.binary_search(pair).is_ok()));
            prop_assert_eq!(classes(positions.len(), &connecting), classes(positions.len(), &expected));
        }
    }
}
