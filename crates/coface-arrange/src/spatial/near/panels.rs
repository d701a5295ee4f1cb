//! Panels: flat faces by their sides, with what lies on them.

use crate::near::{Chain, NearChains, compare, is_boundary, minus, plus, squared};
use crate::spatial::predicates::{GivenPoints, SpatialPredicates};
use coface_algebra::RaggedArray;
use coface_geometry::triangulation::triangulate_sides;
use coface_geometry::{AxisBox, BoxTree, Positions, cross, dot};
use rayon::prelude::*;
use std::cmp::Ordering;

/// A panel is seen along the first axis along which its normal has at least this part of its largest coordinate; no
/// usual angle has just that.
const LEAST_PART: f64 = 0.432_1;

/// Panels are swept along directions with these slopes. A path of sides that is straight within the tolerance must not
/// be across the sweep, or the order of its vertices is that of their errors: so these are slopes of no usual angle.
const SWEEP_SLOPES: [f64; 3] = [0.739_085_133, -1.324_717_957, 0.0];

/// The vertices on the sides and on the inside of a panel, rising.
fn vertices(panel: &Chain) -> Vec<u32> {
    let mut all: Vec<u32> = panel.sides.iter().map(|side| side[0]).collect();
    all.extend(&panel.inside);
    all.sort_unstable();
    all.dedup();
    all
}

/// Where a panel is: a point and the unit normal of its plane, how far sides are from that, and the axis it is seen
/// along.
struct Lie {
    point: [f64; 3],
    normal: [f64; 3],
    deviation: f64,
    axis: usize,
}

/// A vertex so many units of the last place of its coordinates away from a face is in it.
const ON_UNITS: f64 = 16.0;

/// The chains are panels, their owners patches.
impl NearChains {
    /// Panels of triangles, each triangle a piece of a patch: patches that are flat within the tolerance, else their
    /// triangles. Lines are edges that lie on them.
    pub(in crate::spatial) fn of_panels(
        points: Vec<[f64; 3]>,
        triangles: &[[u32; 3]],
        patch_of_triangle: &[u32],
        lines: Vec<[u32; 2]>,
        is_passing: Vec<bool>,
        tolerance: f64,
    ) -> Self {
        let mut near = Self::new(points, Vec::new(), lines, is_passing);
        let count = patch_of_triangle.iter().max().map_or(0, |&last| last as usize + 1);
        let of_patch = RaggedArray::grouped(count, patch_of_triangle.iter().copied());
        let sides_of = |triangle: u32| {
            let [a, b, c] = triangles[triangle as usize];
            [[a, b], [b, c], [c, a]]
        };
        let panels: Vec<Vec<Chain>> = (0..count)
            .into_par_iter()
            .map(|patch| {
                let own = of_patch.list(patch);
                let patch = patch as u32;
                let single = |&triangle: &u32| Chain::new(patch, sides_of(triangle).to_vec());
                if own.len() < 2 {
                    return own.iter().map(single).collect();
                }
                let sides = own.iter().flat_map(|&triangle| sides_of(triangle)).collect();
                let mut whole = Chain::new(patch, sides);
                whole.cancel();
                let lie = near.lie(&whole);
                let is_on = |&triangle: &u32| {
                    let corners = triangles[triangle as usize].iter();
                    lie.as_ref().is_some_and(|lie| {
                        corners.copied().all(|corner| near.height(lie, corner).abs() <= tolerance)
                    })
                };
                if own.iter().all(is_on) { vec![whole] } else { own.iter().map(single).collect() }
            })
            .collect();
        near.chains = panels.into_iter().flatten().collect();
        near
    }

    /// Where a panel is; none without sides or area.
    fn lie(&self, panel: &Chain) -> Option<Lie> {
        let first = panel.sides.first()?[0];
        let origin = self.point(first);
        let relative = |vertex: u32| minus(self.point(vertex), origin);
        let area =
            panel.sides.iter().fold([0.0; 3], |sum, &[a, b]| plus(sum, 1.0, cross(relative(a), relative(b))));
        let length = squared(area).sqrt();
        if length <= 0.0 {
            return None;
        }
        let normal = area.map(|x| x / length);
        let weight = 1.0 / panel.sides.len() as f64;
        let middle = panel.sides.iter().fold([0.0; 3], |sum, &[a, _]| plus(sum, weight, relative(a)));
        let height = |vertex: u32| dot(normal, minus(relative(vertex), middle)).abs();
        let deviation = panel.sides.iter().map(|side| height(side[0])).fold(0.0, f64::max);
        let largest = normal.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let axis = (0..3).find(|&axis| normal[axis].abs() >= LEAST_PART * largest)?;
        Some(Lie { point: plus(origin, 1.0, middle), normal, deviation, axis })
    }

    fn height(&self, lie: &Lie, vertex: u32) -> f64 {
        dot(lie.normal, minus(self.point(vertex), lie.point))
    }

    /// Whether a point is inside a panel as it is seen along its axis.
    fn is_inside(&self, panel: &Chain, lie: &Lie, point: [f64; 3]) -> bool {
        let (i, j) = ((lie.axis + 1) % 3, (lie.axis + 2) % 3);
        let mut winding = 0;
        for side in &panel.sides {
            let [a, b] = side.map(|end| minus(self.point(end), point));
            let turn = a[i] * b[j] - a[j] * b[i];
            if a[j] <= 0.0 && b[j] > 0.0 && turn > 0.0 {
                winding += 1;
            } else if a[j] > 0.0 && b[j] <= 0.0 && turn < 0.0 {
                winding -= 1;
            }
        }
        winding != 0
    }

    /// Puts vertices on panels that they are near the insides of.
    pub(in crate::spatial) fn put_vertices_on_panels(&mut self, tolerance: f64) -> bool {
        let used = self.hot_vertices();
        let boxes: Vec<AxisBox> = used.par_iter().map(|&vertex| self.box_of([vertex], 0.0)).collect();
        let tree = BoxTree::new(&boxes);
        let found: Vec<Vec<u32>> = self
            .chains
            .par_iter()
            .map(|panel| {
                let Some(lie) = self.lie(panel) else { return Vec::new() };
                let reach = tolerance + lie.deviation;
                let frame = self.box_of(panel.sides.iter().map(|side| side[0]), reach);
                let mut own = Vec::new();
                tree.visit(&frame, |place| own.push(used[place as usize]));
                own.retain(|&vertex| self.height(&lie, vertex).abs() <= reach);
                if own.is_empty() {
                    return own;
                }
                let known = vertices(panel);
                own.retain(|vertex| {
                    known.binary_search(vertex).is_err() && self.is_inside(panel, &lie, self.point(*vertex))
                });
                own
            })
            .collect();
        let count: usize = found.iter().map(Vec::len).sum();
        let off_count = |panel: &Chain, own: &[u32]| {
            if own.is_empty() {
                return 0;
            }
            let lie = self.lie(panel);
            let off = |&&vertex: &&u32| {
                let largest = self.point(vertex).iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                lie.as_ref()
                    .is_some_and(|lie| self.height(lie, vertex).abs() > ON_UNITS * f64::EPSILON * largest)
            };
            own.iter().filter(off).count()
        };
        self.counts.faces +=
            self.chains.iter().zip(&found).map(|(panel, own)| off_count(panel, own)).sum::<usize>();
        for (panel, own) in self.chains.iter_mut().zip(found) {
            panel.inside.extend(own);
        }
        count > 0
    }

    /// The triangles of all panels, each with its patch.
    ///
    /// Sides are straight within `reach` where features that far apart were put together, else within the tolerance.
    pub(in crate::spatial) fn triangles(&self, tolerance: f64, reach: f64) -> (Vec<[u32; 3]>, Vec<u32>) {
        let edges = self.edges();
        let mut sides: Vec<[u32; 2]> = edges.iter().flat_map(|&[a, b]| [[a, b], [b, a]]).collect();
        sides.sort_unstable();
        let positions = Positions::from_flat(3, self.points.as_flattened().to_vec());
        let lists: Vec<Vec<[u32; 3]>> = match positions.as_ref().map(GivenPoints::new) {
            Ok(Ok(points)) => {
                let own = |panel: &Chain| {
                    let is_hot = || vertices(panel).iter().any(|&own| self.is_hot(self.point(own)));
                    let within = if reach > tolerance && is_hot() { reach } else { tolerance };
                    self.triangulated(panel, &sides, &points, within)
                };
                self.chains.par_iter().map(own).collect()
            }
            _ => Vec::new(),
        };
        let (mut triangles, mut patches) = (Vec::new(), Vec::new());
        for (panel, own) in self.chains.iter().zip(lists) {
            patches.extend(own.iter().map(|_| panel.owner));
            triangles.extend(own);
        }
        (triangles, patches)
    }

    /// The triangles of a panel, divided by what lies on it: `sides` are all sides there are, in both directions, rising.
    fn triangulated(
        &self,
        panel: &Chain,
        sides: &[[u32; 2]],
        points: &GivenPoints<'_>,
        tolerance: f64,
    ) -> Vec<[u32; 3]> {
        if let ([x, y, z], []) = (&panel.sides[..], &panel.inside[..]) {
            return closed(*x, *y, *z).into_iter().collect();
        }
        let Some(lie) = self.lie(panel) else { return fan(&panel.sides) };
        let inner = self.sides_on(panel, &lie, sides);
        let is_turned = lie.normal[lie.axis] < 0.0;
        let turned = |&[a, b]: &[u32; 2]| if is_turned { [b, a] } else { [a, b] };
        let (i, j) = ((lie.axis + 1) % 3, (lie.axis + 2) % 3);
        let turn = |a: u32, b: u32, c: u32| points.normal_sign(lie.axis, [a, b, c]);
        // Vertices that were put on a side are in line with its ends.
        let rough_turn = |a: u32, b: u32, c: u32| match self.is_thin([a, b, c], [i, j], tolerance) {
            true => Ordering::Equal,
            false => turn(a, b, c),
        };
        let attempt = |inner: &[[u32; 2]], slope: f64, is_rough: bool| {
            let place = |vertex: u32| {
                let point = self.point(vertex);
                point[i] + slope * point[j]
            };
            let order = |a: u32, b: u32| {
                let exact = || points.compare(i, a, b).then_with(|| points.compare(j, a, b));
                if slope == 0.0 { exact() } else { place(a).total_cmp(&place(b)).then_with(exact) }
            };
            let mut all: Vec<[u32; 2]> = panel.sides.iter().chain(inner).map(turned).collect();
            all.sort_by(|x, y| order(x[0], y[0]).then_with(|| order(x[1], y[1])));
            let found = match is_rough {
                true => triangulate_sides(&all, order, rough_turn),
                false => triangulate_sides(&all, order, turn),
            };
            // Where all of a part is in line, it may be left out: then there would be a gap.
            let own = found.ok()?;
            is_boundary(panel.sides.iter().map(turned), &own).then_some(own)
        };
        let roughly = SWEEP_SLOPES.iter().find_map(|&slope| attempt(&inner, slope, true));
        let found = roughly.or_else(|| attempt(&inner, 0.0, false)).or_else(|| attempt(&[], 0.0, false));
        let Some(mut own) = found else { return fan(&panel.sides) };
        // Vertices on the inside at which no side ends.
        let mut alone: Vec<u32> = panel.inside.clone();
        alone.sort_by(|&a, &b| compare(self.point(a), self.point(b)));
        alone.dedup();
        alone.retain(|&vertex| !own.as_flattened().contains(&vertex));
        for vertex in alone {
            // What is on a side of one triangle only nearly may be beside that side for the other: that leaves a gap.
            let found = [true, false].into_iter().find_map(|is_rough| {
                let pieces = match is_rough {
                    true => divided_at(&own, vertex, rough_turn),
                    false => divided_at(&own, vertex, turn),
                };
                is_boundary(panel.sides.iter().map(turned), &pieces).then_some(pieces)
            });
            if let Some(pieces) = found {
                own = pieces;
            }
        }
        let mut fixed: Vec<[u32; 2]> =
            panel.sides.iter().chain(&inner).map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        fixed.sort_unstable();
        let normal = if is_turned { lie.normal.map(|x| -x) } else { lie.normal };
        self.flip_thin(&mut own, &fixed, normal, tolerance);
        if is_turned {
            own.iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
        own
    }

    /// Whether a triangle seen along an axis is at most as high as the tolerance.
    fn is_thin(&self, corners: [u32; 3], [i, j]: [usize; 2], tolerance: f64) -> bool {
        let [a, b, c] = corners.map(|corner| self.point(corner));
        let [u, v, w] = [minus(b, a), minus(c, a), minus(c, b)].map(|way| [way[i], way[j]]);
        let longest = [u, v, w].iter().map(|way| way[0] * way[0] + way[1] * way[1]).fold(0.0, f64::max);
        (u[0] * v[1] - u[1] * v[0]).abs() <= tolerance * longest.sqrt()
    }

    /// The sides of other panels on the inside of one, in both directions.
    fn sides_on(&self, panel: &Chain, lie: &Lie, sides: &[[u32; 2]]) -> Vec<[u32; 2]> {
        let corners = vertices(panel);
        if corners.len() < 4 {
            return Vec::new();
        }
        let mut own: Vec<[u32; 2]> = panel.sides.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        own.sort_unstable();
        let mut found = Vec::new();
        for &from in &corners {
            let start = sides.partition_point(|side| side[0] < from);
            for &[_, to] in sides[start..].iter().take_while(|side| side[0] == from) {
                if from < to
                    && corners.binary_search(&to).is_ok()
                    && own.binary_search(&[from, to]).is_err()
                    && self.is_inside(
                        panel,
                        lie,
                        plus(self.point(from), 0.5, minus(self.point(to), self.point(from))),
                    )
                {
                    found.extend([[from, to], [to, from]]);
                }
            }
        }
        found
    }
}

/// Triangles divided at a vertex inside of one, or on the side of two.
fn divided_at(
    triangles: &[[u32; 3]],
    vertex: u32,
    turn: impl Fn(u32, u32, u32) -> Ordering,
) -> Vec<[u32; 3]> {
    let mut pieces = Vec::with_capacity(triangles.len() + 2);
    for &[a, b, c] in triangles {
        let turns = [[a, b], [b, c], [c, a]].map(|[x, y]| turn(x, y, vertex));
        let on = turns.iter().filter(|turn| turn.is_eq()).count();
        if turns.contains(&Ordering::Less) || on > 1 {
            pieces.push([a, b, c]);
            continue;
        }
        let sides = [[a, b], [b, c], [c, a]].into_iter().zip(turns);
        pieces.extend(sides.filter(|(_, turn)| turn.is_gt()).map(|([x, y], _)| [x, y, vertex]));
    }
    pieces
}

/// The triangle that three sides are.
fn closed([a, b]: [u32; 2], [c, d]: [u32; 2], [e, f]: [u32; 2]) -> Option<[u32; 3]> {
    if b == c && d == e && f == a {
        Some([a, b, d])
    } else {
        (b == e && f == c && d == a).then_some([a, b, f])
    }
}

/// Triangles from one vertex to sides: with the same boundary, whatever they are.
fn fan(sides: &[[u32; 2]]) -> Vec<[u32; 3]> {
    let Some(&[top, _]) = sides.first() else { return Vec::new() };
    let pieces = sides.iter().map(|&[a, b]| [top, a, b]);
    pieces.filter(|&[top, a, b]| top != a && top != b && a != b).collect()
}
