//! A surface cut along one loop, and both rims filled.

use super::patch::{MOST_CORNERS, least_area};
use super::triangle_surface::TriangleSurface;
use coface_algebra::{Error, RaggedArray};
use coface_arrange::spatial::checks::meeting_triangles;
use coface_geometry::{AxisBox, BoxTree, Positions};
use std::collections::{BTreeMap, BTreeSet};

/// How far the second rim is moved towards the neighbors of its vertices: parts of the way, tried one after the other.
const PARTS: [f64; 4] = [0.25, 0.0625, 1.0 / 64.0, 1.0 / 1024.0];
/// How often triangles of a patch that meet others are replaced.
const MOST_PATCHES: usize = 64;

/// What a cut and two patches change.
pub(super) struct Filling {
    /// The loop, without the vertices that could be left out.
    pub(super) vertices: Vec<u32>,
    /// The places of the vertices of the second rim.
    pub(super) points: Vec<[f64; 3]>,
    /// Triangles by their numbers, with new corners.
    pub(super) changed: Vec<(u32, [u32; 3])>,
    pub(super) added: Vec<[u32; 3]>,
}

/// A surface with what finds its parts, while loops are filled one after the other.
pub(super) struct Workpiece<'a> {
    surface: &'a mut TriangleSurface,
    /// The triangles at each vertex when the work began.
    around: RaggedArray,
    tree: BoxTree,
    /// The triangles that were changed or added since.
    new: Vec<u32>,
    is_touched: Vec<bool>,
}

impl<'a> Workpiece<'a> {
    pub(super) fn new(surface: &'a mut TriangleSurface) -> Self {
        let around =
            RaggedArray::grouped(surface.points.len(), surface.triangles.as_flattened().iter().copied());
        let boxes: Vec<AxisBox> = surface
            .triangles
            .iter()
            .map(|triangle| box_of(triangle.map(|v| surface.points[v as usize])))
            .collect();
        let tree = BoxTree::new(&boxes);
        let is_touched = vec![false; surface.points.len()];
        Self { surface, around, tree, new: Vec::new(), is_touched }
    }

    /// Whether a loop runs over or beside what was changed before.
    pub(super) fn is_touched(&self, vertices: &[u32]) -> bool {
        vertices.iter().any(|&vertex| {
            let triangles = self.around.list(vertex as usize).iter().map(|&corner| corner / 3);
            let mut corners = triangles.flat_map(|triangle| self.surface.triangles[triangle as usize]);
            corners.any(|corner| self.is_touched.get(corner as usize).is_none_or(|touched| *touched))
        })
    }

    /// Cuts the surface along a simple loop and fills both rims; `None` where the patches cannot but meet other triangles.
    pub(super) fn filled(&self, vertices: &[u32]) -> Result<Option<Filling>, Error> {
        let Some((vertices, stars)) = self.straightened(vertices.to_vec()) else { return Ok(None) };
        if vertices.len() > MOST_CORNERS {
            return Ok(None);
        }
        for part in PARTS {
            if let Some(filling) = self.filled_at(&vertices, &stars, part)? {
                return Ok(Some(filling));
            }
        }
        Ok(None)
    }

    pub(super) fn apply(&mut self, filling: &Filling) {
        let surface = &mut *self.surface;
        let first = surface.triangles.len() as u32;
        let source = filling.changed.first().map_or(0, |(triangle, _)| surface.sources[*triangle as usize]);
        for &(triangle, corners) in &filling.changed {
            for corner in surface.triangles[triangle as usize] {
                self.is_touched[corner as usize] = true;
            }
            surface.triangles[triangle as usize] = corners;
            self.new.push(triangle);
        }
        for (&vertex, &point) in filling.vertices.iter().zip(&filling.points) {
            self.is_touched[vertex as usize] = true;
            surface.points.push(point);
            surface.vertex_sources.push(surface.vertex_sources[vertex as usize]);
        }
        surface.triangles.extend(&filling.added);
        surface.sources.resize(surface.triangles.len(), source);
        self.new.extend(first..surface.triangles.len() as u32);
    }

    /// The loop without vertices at which one triangle alone lies on one side, and the stars of the others; `None` if it is not a simple
    /// loop of three vertices or more, or is the boundary of a triangle.
    fn straightened(&self, mut vertices: Vec<u32>) -> Option<(Vec<u32>, Vec<Star>)> {
        loop {
            let count = vertices.len();
            let different: BTreeSet<u32> = vertices.iter().copied().collect();
            if count < 3 || different.len() < count {
                return None;
            }
            let star = |i: usize| {
                let [before, at, after] = [i + count - 1, i, i + 1].map(|i| vertices[i % count]);
                self.star(at, before, after)
            };
            let stars: Vec<Star> = (0..count).map(star).collect::<Option<_>>()?;
            match stars.iter().position(|star| star.left.len() < 2 || star.right_count < 2) {
                None => return Some((vertices, stars)),
                Some(_) if count == 3 => return None,
                Some(i) => {
                    vertices.remove(i);
                }
            }
        }
    }

    /// The triangles at a vertex of a loop, on its left, from the next vertex to the one before.
    fn star(&self, vertex: u32, before: u32, after: u32) -> Option<Star> {
        let mut next: BTreeMap<u32, (u32, u32)> = BTreeMap::new();
        for &corner in self.around.list(vertex as usize) {
            let triangle = self.surface.triangles[corner as usize / 3];
            let place = corner as usize % 3;
            next.insert(triangle[(place + 1) % 3], (corner, triangle[(place + 2) % 3]));
        }
        let (mut left, mut neighbors, mut at) = (Vec::new(), Vec::new(), after);
        while at != before {
            let &(corner, following) = next.get(&at)?;
            left.push(corner);
            at = following;
            if at != before {
                neighbors.push(at);
            }
            if left.len() > next.len() {
                return None;
            }
        }
        let right_count = next.len() - left.len();
        Some(Star { left, neighbors, right_count, around: next.into_keys().collect() })
    }

    fn filled_at(&self, vertices: &[u32], stars: &[Star], part: f64) -> Result<Option<Filling>, Error> {
        let surface = &*self.surface;
        let count = vertices.len();
        let first = surface.points.len() as u32;
        let points: Vec<[f64; 3]> =
            vertices.iter().zip(stars).map(|(&vertex, star)| self.moved(vertex, star, part)).collect();
        let mut corners: BTreeMap<u32, [u32; 3]> = BTreeMap::new();
        for (star, copy) in stars.iter().zip(first..) {
            for &corner in &star.left {
                let triangle = corner / 3;
                let changed = corners.entry(triangle).or_insert(surface.triangles[triangle as usize]);
                changed[corner as usize % 3] = copy;
            }
        }
        let changed: Vec<(u32, [u32; 3])> = corners.into_iter().collect();
        let neighborhood = Neighborhood::new(self, vertices, &points, &changed);
        let moved: Vec<[u32; 3]> = changed.iter().map(|&(_, corners)| corners).collect();
        if !neighborhood.meetings(&moved, &[])?.is_empty() {
            return Ok(None);
        }
        let rim: Vec<[f64; 3]> = vertices.iter().map(|&vertex| surface.points[vertex as usize]).collect();
        let is_free: Vec<Vec<bool>> = stars
            .iter()
            .map(|star| vertices.iter().map(|vertex| star.around.binary_search(vertex).is_err()).collect())
            .collect();
        let mut forbidden = BTreeSet::new();
        for _ in 0..MOST_PATCHES {
            let Some(patch) = least_area(&rim, &is_free, &forbidden) else { return Ok(None) };
            // The right side runs against the loop, so its patch runs along it; the left one is turned over.
            let right = patch.iter().map(|places| places.map(|place| vertices[place]));
            let left = patch.iter().map(|&[i, j, k]| [k, j, i].map(|place| first + place as u32));
            let added: Vec<[u32; 3]> = right.chain(left).collect();
            let meetings = neighborhood.meetings(&moved, &added)?;
            if meetings.is_empty() {
                return Ok(Some(Filling { vertices: vertices.to_vec(), points, changed, added }));
            }
            let before = forbidden.len();
            forbidden.extend(meetings.into_iter().map(|triangle| patch[triangle % (count - 2)]));
            if forbidden.len() == before {
                return Ok(None);
            }
        }
        Ok(None)
    }

    /// A vertex moved a part of the way to the middle of its neighbors on the left.
    fn moved(&self, vertex: u32, star: &Star, part: f64) -> [f64; 3] {
        let at = self.surface.points[vertex as usize];
        let count = star.neighbors.len() as f64;
        [0, 1, 2].map(|axis| {
            let sum: f64 = star
                .neighbors
                .iter()
                .map(|&other| self.surface.points[other as usize][axis] - at[axis])
                .sum();
            at[axis] + part * sum / count
        })
    }
}

/// What is around a vertex of a loop.
struct Star {
    /// The corners on the left of the loop, each three times its triangle and its place.
    left: Vec<u32>,
    /// The vertices between these triangles.
    neighbors: Vec<u32>,
    right_count: usize,
    /// All neighbors, rising.
    around: Vec<u32>,
}

/// The triangles near a loop that stay as they are, in a numbering of their own.
struct Neighborhood {
    positions: Positions,
    numbers: BTreeMap<u32, u32>,
    kept: Vec<[u32; 3]>,
}

impl Neighborhood {
    fn new(
        piece: &Workpiece<'_>,
        vertices: &[u32],
        points: &[[f64; 3]],
        changed: &[(u32, [u32; 3])],
    ) -> Self {
        let surface = &*piece.surface;
        let first = surface.points.len() as u32;
        let point = |vertex: u32| match vertex.checked_sub(first) {
            Some(copy) => points[copy as usize],
            None => surface.points[vertex as usize],
        };
        let all =
            changed.iter().flat_map(|(_, corners)| corners.iter().copied()).chain(vertices.iter().copied());
        let around = box_of(all.map(point));
        let mut near: BTreeSet<u32> = piece.new.iter().copied().collect();
        piece.tree.visit(&around, |triangle| {
            near.insert(triangle);
        });
        let is_changed =
            |triangle: &u32| changed.binary_search_by_key(triangle, |&(changed, _)| changed).is_ok();
        let kept: Vec<[u32; 3]> = near
            .iter()
            .filter(|triangle| !is_changed(triangle))
            .map(|&triangle| surface.triangles[triangle as usize])
            .collect();
        let mut used: Vec<u32> = kept.as_flattened().to_vec();
        used.extend(changed.iter().flat_map(|(_, corners)| corners));
        used.extend(vertices);
        used.extend(first..first + points.len() as u32);
        used.sort_unstable();
        used.dedup();
        let flat: Vec<f64> = used.iter().flat_map(|&vertex| point(vertex)).collect();
        let positions = Positions::from_flat(3, flat).expect("points are finite");
        let numbers: BTreeMap<u32, u32> = used.into_iter().zip(0..).collect();
        let kept = kept.into_iter().map(|triangle| triangle.map(|vertex| numbers[&vertex])).collect();
        Self { positions, numbers, kept }
    }

    /// Which of the added triangles meet others, or, if none are added, which of the moved ones do.
    fn meetings(&self, moved: &[[u32; 3]], added: &[[u32; 3]]) -> Result<BTreeSet<usize>, Error> {
        let own = |triangle: &[u32; 3]| triangle.map(|vertex| self.numbers[&vertex]);
        let mut triangles = self.kept.clone();
        triangles.extend(moved.iter().map(own));
        let first = if added.is_empty() { self.kept.len() } else { triangles.len() };
        triangles.extend(added.iter().map(own));
        let found = meeting_triangles(&self.positions, &triangles, &|triangle| triangle as usize >= first)?;
        Ok(found
            .into_iter()
            .flatten()
            .filter_map(|triangle| (triangle as usize).checked_sub(first))
            .collect())
    }
}

fn box_of(points: impl IntoIterator<Item = [f64; 3]>) -> AxisBox {
    let empty = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    points.into_iter().fold(empty, |around, point| {
        [0, 1, 2].map(|axis| [around[axis][0].min(point[axis]), around[axis][1].max(point[axis])])
    })
}
