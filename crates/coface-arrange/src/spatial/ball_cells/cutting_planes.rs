//! Where to cut a piece that is no ball.

use super::pieces::Kept;
use crate::spatial::SpatialArrangement;
use coface_algebra::{FaceId, UnionFind, VertexId};
use std::collections::HashMap;

/// So many planes across each axis are tried.
const MOST_PLANES: usize = 8;

/// A rectangle across a piece, at right angles to an axis, through a vertex of its boundary or between two: of all tried
/// the one that leaves the fewest tunnels, with the fewest rims.
///
/// No plane is taken that is there already. A piece that lies between two parts of the faces at a vertex must be cut through that, so one can be given with an axis.
///
/// Where a rectangle is does not matter for what the cells are, only for how many are made: rounded coordinates do.
pub(super) fn best_cut(
    arrangement: &SpatialArrangement,
    kept: &Kept,
    piece: u32,
    through: Option<(u32, usize)>,
    cuts: &[[[f64; 3]; 4]],
) -> Option<[[f64; 3]; 4]> {
    let surface = Surface::new(arrangement, kept, piece);
    let mut best: Option<((i64, usize, f64), usize, f64)> = None;
    if let Some((vertex, axis)) = through {
        let level = arrangement.positions().point(VertexId::from_u32(vertex))[axis];
        best = Some(((0, 0, 0.0), axis, level));
    }
    for axis in (0..3).filter(|_| through.is_none()) {
        let [low, high] = surface.range(axis);
        let is_new = |level: &f64| cuts.iter().all(|cut| cut.iter().any(|corner| corner[axis] != *level));
        for level in surface.levels(axis).into_iter().filter(is_new) {
            let Some((tunnels, rims)) = surface.tunnels_after(axis, level) else { continue };
            let off = ((level - low) / (high - low) - 0.5).abs();
            let merit = (tunnels, rims, off);
            let is_better = best.is_none_or(|(known, ..)| {
                (merit.0, merit.1).cmp(&(known.0, known.1)).then(merit.2.total_cmp(&known.2)).is_lt()
            });
            if is_better {
                best = Some((merit, axis, level));
            }
        }
    }
    let (_, axis, level) = best?;
    let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    let [across, up] = [u, v].map(|axis| {
        let [low, high] = surface.range(axis);
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

/// Where a triangle crosses a plane: the crossings at the two ends, where those are, and a vertex below and above.
type Segment = ([u32; 2], [[f64; 2]; 2], [u32; 2]);

/// The boundary of a piece as triangles, which run counterclockwise seen from outside of it.
struct Surface {
    points: HashMap<u32, [f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Surface {
    fn new(arrangement: &SpatialArrangement, kept: &Kept, piece: u32) -> Self {
        let mut surface = Self { points: HashMap::new(), triangles: Vec::new() };
        let positions = arrangement.fine_triangles().positions();
        for face in 0..kept.is_kept.len() as u32 {
            let sides = [0, 1].map(|side| kept.piece_at(arrangement, face, side) == piece);
            if !kept.is_kept[face as usize] || !(sides[0] || sides[1]) {
                continue;
            }
            // Exact triangles exist for all faces of an arrangement.
            let own = arrangement.triangulated(FaceId::from_u32(face)).unwrap_or_default();
            for triangle in own {
                for vertex in triangle {
                    let point = positions.point(VertexId::from_u32(vertex));
                    surface.points.insert(vertex, [point[0], point[1], point[2]]);
                }
                let [a, b, c] = triangle;
                surface.triangles.extend(sides[0].then_some([a, b, c]));
                surface.triangles.extend(sides[1].then_some([a, c, b]));
            }
        }
        surface
    }

    fn range(&self, axis: usize) -> [f64; 2] {
        self.points.values().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| {
            [low.min(point[axis]), high.max(point[axis])]
        })
    }

    /// Coordinates of vertices strictly between the ends, and the middle of the largest gap; few of them.
    fn levels(&self, axis: usize) -> Vec<f64> {
        let mut all: Vec<f64> = self.points.values().map(|point| point[axis]).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        let mut levels: Vec<f64> = Vec::new();
        let inner = all.get(1..all.len().saturating_sub(1)).unwrap_or(&[]);
        let step = inner.len().div_ceil(MOST_PLANES).max(1);
        levels.extend(inner.iter().skip(step / 2).step_by(step));
        let middle = |pair: &[f64]| pair[0] + (pair[1] - pair[0]) / 2.0;
        let gaps = all.windows(2).step_by(step).map(middle);
        levels.extend(
            gaps.filter(|level| level.is_finite() && all.binary_search_by(|x| x.total_cmp(level)).is_err()),
        );
        levels
    }

    /// The number of tunnels of all parts after a cut a little above a level, and of rims of the cut; `None` if the
    /// plane misses the piece.
    fn tunnels_after(&self, axis: usize, level: f64) -> Option<(i64, usize)> {
        let is_above = |vertex: u32| self.points[&vertex][axis] > level;
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        // Vertices of the surface, and crossings of edges with the plane, by numbers of their own.
        let mut numbers: HashMap<[u32; 2], u32> = HashMap::new();
        let mut number = |key: [u32; 2]| {
            let next = numbers.len() as u32;
            *numbers.entry(key).or_insert(next)
        };
        let crossing = |a: u32, b: u32| {
            let [p, q] = [a, b].map(|vertex| self.points[&vertex]);
            let part = (level - p[axis]) / (q[axis] - p[axis]);
            [u, v].map(|axis| p[axis] + part * (q[axis] - p[axis]))
        };
        let mut links: Vec<[u32; 2]> = Vec::new();
        let mut segments: Vec<Segment> = Vec::new();
        let mut edges: Vec<[u32; 2]> = Vec::with_capacity(3 * self.triangles.len());
        for &[a, b, c] in &self.triangles {
            for [p, q] in [[a, b], [b, c], [c, a]] {
                edges.push([p.min(q), p.max(q)]);
                if is_above(p) == is_above(q) {
                    links.push([number([p, p]), number([q, q])]);
                }
            }
            for [p, q, r] in [[a, b, c], [b, c, a], [c, a, b]] {
                // The corner that is alone on its side of the plane.
                let lone = is_above(p);
                if is_above(q) != lone && is_above(r) != lone {
                    let at = [number([p.min(q), p.max(q)]), number([p.min(r), p.max(r)])];
                    let places = [crossing(p, q), crossing(p, r)];
                    let (low, high) = if lone { (q, p) } else { (p, q) };
                    let sides = [number([low, low]), number([high, high])];
                    // The inside is on the left seen from above.
                    if lone {
                        segments.push((at, places, sides));
                    } else {
                        segments.push(([at[1], at[0]], [places[1], places[0]], sides));
                    }
                }
            }
        }
        if segments.is_empty() {
            return None;
        }
        edges.sort_unstable();
        edges.dedup();
        let vertices: Vec<u32> = self.points.keys().map(|&vertex| number([vertex, vertex])).collect();
        let count = numbers.len();
        let mut rims = UnionFind::new(count);
        let mut parts = UnionFind::new(count);
        links.iter().for_each(|&[a, b]| {
            parts.unite(a, b);
        });
        segments.iter().for_each(|segment| {
            rims.unite(segment.0[0], segment.0[1]);
        });
        // Area and members of each rim.
        let mut of_rim: HashMap<u32, (f64, Vec<usize>)> = HashMap::new();
        for (i, (at, [p, q], _)) in segments.iter().enumerate() {
            let rim = of_rim.entry(rims.find(at[0])).or_default();
            rim.0 += p[0] * q[1] - p[1] * q[0];
            rim.1.push(i);
        }
        let mut list: Vec<(f64, Vec<usize>)> = of_rim.into_values().collect();
        list.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
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
        let mut roots: Vec<u32> = vertices.into_iter().map(|vertex| parts.find(vertex)).collect();
        roots.sort_unstable();
        roots.dedup();
        let surface = self.points.len() as i64 - edges.len() as i64 + self.triangles.len() as i64;
        Some((roots.len() as i64 - (surface + 2 * characteristic) / 2, rim_count))
    }
}
