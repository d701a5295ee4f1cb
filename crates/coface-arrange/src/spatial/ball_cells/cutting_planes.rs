//! Where to cut a piece that is no ball.

use crate::spatial::SpatialArrangement;
use coface_algebra::{FaceId, UnionFind, VertexId};
use coface_geometry::{cross, dot};
use rayon::prelude::*;
use std::cmp::Ordering;

/// So many vertices across each axis are tried, then more where no plane through these or between them leaves fewer
/// tunnels.
const VERTICES_TRIED: [usize; 3] = [8, 64, 512];
/// A piece with more tunnels is cut across each axis at once.
const TUNNELS_FOR_ONE_CUT: i64 = 2;
/// So many directions of facets are tried where no plane across an axis leaves fewer tunnels, nearly parallel ones once.
const DIRECTIONS_TRIED: usize = 12;
/// The cosine of the angle from which on two directions are nearly parallel.
const NEARLY_PARALLEL: f64 = 0.995;

/// Rectangles across a piece, which has these half-faces around it, at right angles to an axis, through a vertex of its
/// boundary or between two: of all tried the one that leaves the fewest tunnels, with the fewest rims; for pieces with many
/// tunnels that across each axis. The wall of a slanted tube has none that leaves fewer: planes along facets are tried then,
/// and at last those across an axis near the middle.
///
/// No plane is taken that is there already. A piece that lies between two parts of the faces at a vertex must be cut
/// through that, so one can be given with an axis.
///
/// Where a rectangle is does not matter for what the cells are, only for how many are made: rounded coordinates do.
pub(super) fn best_cuts(
    arrangement: &SpatialArrangement,
    halves: &[u32],
    through: Option<(u32, usize)>,
    cuts: &[[[f64; 3]; 4]],
    tries_slanted: bool,
) -> Vec<[[f64; 3]; 4]> {
    let surface = Surface::new(arrangement, halves);
    if let Some((vertex, axis)) = through {
        let level = arrangement.positions().point(VertexId::from_u32(vertex))[axis];
        return surface.rectangle(axis, level).into_iter().collect();
    }
    let tunnels = surface.tunnels();
    let mut best: Vec<Plane> = Vec::new();
    for most in VERTICES_TRIED {
        let planes: Vec<(usize, f64)> = (0..3)
            .flat_map(|axis| surface.levels(axis, most).into_iter().map(move |level| (axis, level)))
            .filter(|&(axis, level)| is_new(axis, level, cuts))
            .collect();
        let plane = |&(axis, level): &(usize, f64)| surface.cut_at(axis, level);
        let mut found: Vec<Plane> = planes.par_iter().filter_map(plane).collect();
        found.sort_by(Plane::compare);
        best = found;
        if best.first().is_some_and(|plane| plane.tunnels < tunnels) {
            break;
        }
    }
    if best.first().is_none_or(|plane| plane.tunnels >= tunnels) {
        let slanted = if tries_slanted { surface.slanted_cuts(tunnels) } else { Vec::new() };
        if !slanted.is_empty() {
            return slanted;
        }
        best.sort_by(|a, b| {
            a.tunnels.cmp(&b.tunnels).then(a.off.total_cmp(&b.off)).then_with(|| a.compare(b))
        });
    }
    let is_first = |axis: usize| best.iter().find(|plane| plane.axis == axis);
    let chosen: Vec<&Plane> = match tunnels > TUNNELS_FOR_ONE_CUT {
        true => (0..3).filter_map(is_first).filter(|plane| plane.tunnels < tunnels).collect(),
        false => Vec::new(),
    };
    let chosen = if chosen.is_empty() { best.iter().take(1).collect() } else { chosen };
    chosen.into_iter().filter_map(|plane| surface.rectangle(plane.axis, plane.level)).collect()
}

/// A rectangle across a piece through a vertex, at right angles to the first axis that has none there yet. Two parts of the
/// faces that touch in the vertex alone are connected by it, or what lies between them is cut in two.
pub(super) fn new_cut_through(
    arrangement: &SpatialArrangement,
    halves: &[u32],
    vertex: u32,
    cuts: &[[[f64; 3]; 4]],
) -> Option<[[f64; 3]; 4]> {
    let point = arrangement.positions().point(VertexId::from_u32(vertex));
    let axis = (0..3).find(|&axis| is_new(axis, point[axis], cuts))?;
    Surface::new(arrangement, halves).rectangle(axis, point[axis])
}

/// Whether no rectangle is in a plane at right angles to an axis.
fn is_new(axis: usize, level: f64, cuts: &[[[f64; 3]; 4]]) -> bool {
    cuts.iter().all(|cut| cut.iter().any(|corner| corner[axis] != level))
}

/// A direction, and two at right angles to it and each other.
fn frame(direction: [f64; 3]) -> [[f64; 3]; 3] {
    let smallest = (0..3).min_by(|&a, &b| direction[a].abs().total_cmp(&direction[b].abs())).unwrap_or(0);
    let mut axis = [0.0; 3];
    axis[smallest] = 1.0;
    let across = cross(direction, axis);
    let length = dot(across, across).sqrt();
    let across = across.map(|x| x / length);
    [direction, across, cross(direction, across)]
}

/// The rectangle with these corners in a frame, rounded so that its corners lie in one plane exactly: all coordinates are
/// multiples of one number, few enough that sums are exact. None where nothing would be left of it.
fn turned_back(frame: &[[f64; 3]; 3], corners: &[[f64; 3]; 4]) -> Option<[[f64; 3]; 4]> {
    let back = |corner: &[f64; 3]| [0, 1, 2].map(|i| (0..3).map(|axis| corner[axis] * frame[axis][i]).sum());
    let corners: [[f64; 3]; 4] = [0, 1, 2, 3].map(|i| back(&corners[i]));
    let largest = corners.as_flattened().iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let step = 2.0_f64.powi(largest.log2().ceil() as i32 - 48);
    if !step.is_normal() {
        return None;
    }
    let rounded = |x: f64| (x / step).round() * step;
    let [first, second, _, last] = corners;
    let first = first.map(rounded);
    let [right, up] = [second, last].map(|corner| [0, 1, 2].map(|i| rounded(corner[i] - first[i])));
    let normal = cross(right, up);
    let (length, cosine) = (dot(normal, normal).sqrt(), dot(normal, frame[0]));
    let sum = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] + b[i]);
    (cosine > 0.99 * length).then(|| [first, sum(first, right), sum(sum(first, right), up), sum(first, up)])
}

/// A plane at right angles to an axis, and what it does.
struct Plane {
    axis: usize,
    level: f64,
    /// The tunnels that are left.
    tunnels: i64,
    rims: usize,
    /// How far it is from the middle of the piece, as a part of its extent.
    off: f64,
}

impl Plane {
    /// The better one first.
    fn compare(&self, other: &Self) -> Ordering {
        (self.tunnels, self.rims)
            .cmp(&(other.tunnels, other.rims))
            .then_with(|| self.off.total_cmp(&other.off))
            .then_with(|| self.axis.cmp(&other.axis))
    }
}

/// Where a triangle crosses a plane: the crossings at the two ends, where those are, and a vertex below and above.
type Segment = ([u32; 2], [[f64; 2]; 2], [u32; 2]);

/// The boundary of a piece as triangles, which run counterclockwise seen from outside of it, on vertices of its own.
struct Surface {
    points: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    /// Each once, the lower end first.
    edges: Vec<[u32; 2]>,
}

impl Surface {
    fn new(arrangement: &SpatialArrangement, halves: &[u32]) -> Self {
        let mut triangles = Vec::with_capacity(halves.len());
        for &half in halves {
            // Exact triangles exist for all faces of an arrangement.
            let own = arrangement.triangulated(FaceId::from_u32(half >> 1)).unwrap_or_default();
            triangles
                .extend(own.into_iter().map(|[a, b, c]| if half & 1 == 0 { [a, b, c] } else { [a, c, b] }));
        }
        let mut vertices: Vec<u32> = triangles.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        for corner in triangles.as_flattened_mut() {
            *corner = vertices.partition_point(|vertex| vertex < corner) as u32;
        }
        let positions = arrangement.fine_triangles().positions();
        let point = |&vertex: &u32| {
            let point = positions.point(VertexId::from_u32(vertex));
            [point[0], point[1], point[2]]
        };
        let sides = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]].map(|[p, q]| [p.min(q), p.max(q)]);
        let mut edges: Vec<[u32; 2]> = triangles.iter().flat_map(sides).collect();
        edges.sort_unstable();
        edges.dedup();
        Self { points: vertices.iter().map(point).collect(), triangles, edges }
    }

    fn range(&self, axis: usize) -> [f64; 2] {
        self.points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| {
            [low.min(point[axis]), high.max(point[axis])]
        })
    }

    /// Coordinates of vertices strictly between the ends, and the middle of the largest gap; few of them.
    fn levels(&self, axis: usize, most: usize) -> Vec<f64> {
        let mut all: Vec<f64> = self.points.iter().map(|point| point[axis]).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        let mut levels: Vec<f64> = Vec::new();
        let inner = all.get(1..all.len().saturating_sub(1)).unwrap_or(&[]);
        let step = inner.len().div_ceil(most).max(1);
        levels.extend(inner.iter().skip(step / 2).step_by(step));
        let middle = |pair: &[f64]| pair[0] + (pair[1] - pair[0]) / 2.0;
        let gaps = all.windows(2).step_by(step).map(middle);
        levels.extend(
            gaps.filter(|level| level.is_finite() && all.binary_search_by(|x| x.total_cmp(level)).is_err()),
        );
        levels
    }

    /// A rectangle that is larger than the piece; none if that is too large.
    fn rectangle(&self, axis: usize, level: f64) -> Option<[[f64; 3]; 4]> {
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        let [across, up] = [u, v].map(|axis| {
            let [low, high] = self.range(axis);
            let margin = (high - low) / 8.0;
            [low - margin, high + margin]
        });
        let corner = |x: f64, y: f64| {
            let mut point = [0.0; 3];
            (point[axis], point[u], point[v]) = (level, x, y);
            point
        };
        let corners = [
            corner(across[0], up[0]),
            corner(across[1], up[0]),
            corner(across[1], up[1]),
            corner(across[0], up[1]),
        ];
        corners.as_flattened().iter().all(|x| x.is_finite()).then_some(corners)
    }

    /// The best planes along facets of the piece: one, or for many tunnels up to three that are not nearly parallel; none
    /// if no plane leaves fewer tunnels.
    fn slanted_cuts(&self, tunnels: i64) -> Vec<[[f64; 3]; 4]> {
        for most in VERTICES_TRIED {
            let best = |&direction: &[f64; 3]| {
                let frame = frame(direction);
                let turned = self.turned(&frame);
                let planes = turned.levels(0, most).into_iter().filter_map(|level| turned.cut_at(0, level));
                let plane = planes.filter(|plane| plane.tunnels < tunnels).min_by(Plane::compare)?;
                let corners = turned.rectangle(0, plane.level)?;
                Some((plane, turned_back(&frame, &corners)?))
            };
            let mut found: Vec<(Plane, [[f64; 3]; 4])> =
                self.directions().par_iter().filter_map(best).collect();
            if !found.is_empty() {
                found.sort_by(|a, b| a.0.compare(&b.0));
                found.truncate(if tunnels > TUNNELS_FOR_ONE_CUT { 3 } else { 1 });
                return found.into_iter().map(|(_, cut)| cut).collect();
            }
        }
        Vec::new()
    }

    /// Normals of facets, of those with the largest area first; none that is nearly parallel to an axis or another.
    fn directions(&self) -> Vec<[f64; 3]> {
        let mut normals: Vec<(f64, [f64; 3])> = Vec::with_capacity(self.triangles.len());
        for corners in &self.triangles {
            let [a, b, c] = corners.map(|corner| self.points[corner as usize]);
            let from_a = |p: [f64; 3]| [0, 1, 2].map(|i| p[i] - a[i]);
            let normal = cross(from_a(b), from_a(c));
            let length = dot(normal, normal).sqrt();
            if length.is_normal() {
                normals.push((length, normal.map(|x| x / length)));
            }
        }
        normals.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut found: Vec<[f64; 3]> = Vec::new();
        for (_, normal) in normals {
            let is_parallel = |other: &[f64; 3]| dot(normal, *other).abs() > NEARLY_PARALLEL;
            // Along an axis the planes have been tried.
            let is_across_axis = normal.iter().any(|x| x.abs() == 1.0);
            if found.len() < DIRECTIONS_TRIED && !is_across_axis && !found.iter().any(is_parallel) {
                found.push(normal);
            }
        }
        found
    }

    /// The surface in the coordinates of a frame.
    fn turned(&self, frame: &[[f64; 3]; 3]) -> Self {
        let points = self.points.iter().map(|&point| frame.map(|axis| dot(axis, point))).collect();
        Self { points, triangles: self.triangles.clone(), edges: self.edges.clone() }
    }

    fn characteristic(&self) -> i64 {
        self.points.len() as i64 - self.edges.len() as i64 + self.triangles.len() as i64
    }

    /// The number of tunnels, where each connected part of the surface is around a solid.
    fn tunnels(&self) -> i64 {
        let mut parts = UnionFind::new(self.points.len());
        for &[a, b] in &self.edges {
            parts.unite(a, b);
        }
        parts.class_count() as i64 - self.characteristic() / 2
    }

    fn cut_at(&self, axis: usize, level: f64) -> Option<Plane> {
        let (tunnels, rims) = self.tunnels_after(axis, level)?;
        let [low, high] = self.range(axis);
        let off = ((level - low) / (high - low) - 0.5).abs();
        Some(Plane { axis, level, tunnels, rims, off })
    }

    /// The number of tunnels of all parts after a cut a little above a level, and of rims of the cut; `None` if the
    /// plane misses the piece.
    fn tunnels_after(&self, axis: usize, level: f64) -> Option<(i64, usize)> {
        let is_above = |vertex: u32| self.points[vertex as usize][axis] > level;
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        let crossed: Vec<[u32; 2]> =
            self.edges.iter().copied().filter(|&[a, b]| is_above(a) != is_above(b)).collect();
        if crossed.is_empty() {
            return None;
        }
        let number = |a: u32, b: u32| {
            let ends = [a.min(b), a.max(b)];
            crossed.partition_point(|known| *known < ends) as u32
        };
        let crossing = |a: u32, b: u32| {
            let [p, q] = [a, b].map(|vertex| self.points[vertex as usize]);
            let part = (level - p[axis]) / (q[axis] - p[axis]);
            [u, v].map(|axis| p[axis] + part * (q[axis] - p[axis]))
        };
        let mut segments: Vec<Segment> = Vec::new();
        for &[a, b, c] in &self.triangles {
            for [p, q, r] in [[a, b, c], [b, c, a], [c, a, b]] {
                // The corner that is alone on its side of the plane.
                let lone = is_above(p);
                if is_above(q) != lone && is_above(r) != lone {
                    let at = [number(p, q), number(p, r)];
                    let places = [crossing(p, q), crossing(p, r)];
                    let sides = if lone { [q, p] } else { [p, q] };
                    // The inside is on the left seen from above.
                    if lone {
                        segments.push((at, places, sides));
                    } else {
                        segments.push(([at[1], at[0]], [places[1], places[0]], sides));
                    }
                }
            }
        }
        let mut rims = UnionFind::new(crossed.len());
        let mut parts = UnionFind::new(self.points.len());
        for &[a, b] in self.edges.iter().filter(|&&[a, b]| is_above(a) == is_above(b)) {
            parts.unite(a, b);
        }
        for segment in &segments {
            rims.unite(segment.0[0], segment.0[1]);
        }
        // Area and members of each rim.
        let mut of_rim: Vec<(f64, Vec<usize>)> = vec![(0.0, Vec::new()); rims.class_count()];
        let numbers = rims.class_numbers();
        for (i, (at, [p, q], _)) in segments.iter().enumerate() {
            let rim = &mut of_rim[numbers[at[0] as usize] as usize];
            rim.0 += p[0] * q[1] - p[1] * q[0];
            rim.1.push(i);
        }
        of_rim.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
        let list = of_rim;
        let rim_count = list.len();
        let winds_around = |own: &[usize], [x, y]: [f64; 2]| {
            let crossings = own.iter().filter(|&&i| {
                let [p, q] = segments[i].1;
                (p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
            });
            crossings.count() % 2 == 1
        };
        // A hole is in the smallest outer rim around it; the surface below and above is connected by the region.
        let outer: Vec<usize> = (0..rim_count).filter(|&rim| list[rim].0 > 0.0).collect();
        let mut characteristic = 0;
        for (rim, (area, own)) in list.iter().enumerate() {
            for &i in own {
                for side in 0..2 {
                    parts.unite(segments[i].2[side], segments[own[0]].2[side]);
                }
            }
            if *area > 0.0 {
                characteristic += 1;
                continue;
            }
            characteristic -= 1;
            let point = segments[own[0]].1[0];
            if let Some(&around) =
                outer.iter().find(|&&other| other != rim && winds_around(&list[other].1, point))
            {
                let other = list[around].1[0];
                for side in 0..2 {
                    parts.unite(segments[own[0]].2[side], segments[other].2[side]);
                }
            }
        }
        Some((parts.class_count() as i64 - (self.characteristic() + 2 * characteristic) / 2, rim_count))
    }
}
