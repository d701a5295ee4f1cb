//! Triangles of a surface that lie in one plane, put together and cut anew with as few triangles as their outline needs.
//!
//! A **patch** is a set of triangles that are connected through sides and lie within a distance of one plane, all with
//! their fronts on one side of it. A **chain** is a path of sides between the same two patches. Vertices inside a patch
//! go, and those along a chain that is straight within the distance. No vertex moves, so what is left of a patch is its
//! outline, and the surface stays closed. A patch that cannot be drawn so stays as it is: where its outline crosses
//! itself, where it would be connected otherwise, or where its triangles would meet others.

use super::axis_view::AxisView;
use super::cutting::crossing_triangles;
use super::predicates::{GivenPoints, SpatialPredicates};
use crate::near::{minus, plus};
use coface_algebra::{Error, RaggedArray, Sign};
use coface_geometry::triangulation::{flip_to_delaunay, triangulate_sides};
use coface_geometry::{Positions, cross, dot};
use rayon::prelude::*;
use std::cmp::Ordering;

/// No number. The arrays that hold it have one entry a side, and an `Option` would double their size.
const NONE: u32 = u32::MAX;
/// A plane is fitted to a patch at most so often while the patch grows.
const MOST_FITS: usize = 4;
/// Patches are taken as they are at most so often before all is left as it is.
const MOST_ROUNDS: usize = 8;

/// Triangles that were put together and cut anew.
///
/// Each patch is a list of triangles of before.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct CoplanarTriangles {
    /// Counterclockwise as before, on vertices of before.
    pub triangles: Vec<[u32; 3]>,
    /// The patch of each.
    pub patch_of_triangle: Vec<u32>,
    /// The triangles of before in each patch, rising.
    pub patches: RaggedArray,
}

/// What comes of putting triangles together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CoplanarMerge {
    /// They are drawn with these.
    Merged(CoplanarTriangles),
    /// There is nothing to put together, or no way that is certain.
    AsBefore,
    /// Some of them meet otherwise than in common corners and sides, and not because they were put together.
    Crossing,
}

impl CoplanarMerge {
    /// What they are drawn with, if that is not as before.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::CoplanarMerge;
    /// assert!(CoplanarMerge::AsBefore.merged().is_none());
    /// ```
    pub fn merged(self) -> Option<CoplanarTriangles> {
        match self {
            Self::Merged(merged) => Some(merged),
            Self::AsBefore | Self::Crossing => None,
        }
    }
}

/// Puts triangles together that share a side and lie within a distance of one plane, and draws them with the triangles
/// that their outlines need. Vertices that are then inside a straight edge are left out. With the distance 0 that is exact: the
/// surface is the same set of points. Otherwise it is certain that triangles meet in common corners and sides alone,
/// if those do of which the last argument says no.
///
/// # Errors
/// None for triangles on points in space with finite coordinates.
///
/// # Complexity
/// $O(n \log n)$ for n triangles that are near few others.
///
/// # Examples
/// A tetrahedron, one of whose faces is cut into three at a point in its middle:
/// ```
/// use coface_arrange::spatial::merge_coplanar_triangles;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let flat = vec![0., 0., 0., 3., 0., 0., 0., 3., 0., 0., 0., 3., 1., 1., 0.];
/// let faces = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 4], [2, 1, 4], [0, 2, 4]];
/// let merged = merge_coplanar_triangles(&Positions::from_flat(3, flat)?, &faces, 0.0, |_| true)?;
/// let merged = merged.merged().expect("three are one");
/// assert_eq!(merged.triangles.len(), 4);
/// assert_eq!(merged.patches.list(merged.patch_of_triangle[3] as usize), [3, 4, 5]);
/// # Ok(()) }
/// ```
pub fn merge_coplanar_triangles(
    positions: &Positions,
    triangles: &[[u32; 3]],
    tolerance: f64,
    may_cross: impl Fn(usize) -> bool + Sync,
) -> Result<CoplanarMerge, Error> {
    if triangles.is_empty() {
        return Ok(CoplanarMerge::AsBefore);
    }
    let surface = Surface::new(positions, triangles, tolerance)?;
    let mut patch_of = surface.grown();
    let mut is_kept = surface.ends_of_odd_sides();
    let mut known = Known::new((0..triangles.len()).into_par_iter().map(|own| !may_cross(own)).collect());
    for _ in 0..MOST_ROUNDS {
        let drawing = Drawing::new(&surface, &patch_of, &is_kept);
        let mut rigid = drawing.rigid.clone();
        if rigid.is_empty() {
            if drawing.is_as_before() {
                return Ok(CoplanarMerge::AsBefore);
            }
            let drawn = drawing.drawn();
            rigid = drawing.unpaired(&drawn.merged);
            if rigid.is_empty() && tolerance > 0.0 {
                let crossing = known.crossing(positions, &drawn)?;
                if drawn.is_crossing_as_before(positions, &crossing)? {
                    return Ok(CoplanarMerge::Crossing);
                }
                rigid = crossing.iter().map(|&own| drawn.merged.patch_of_triangle[own as usize]).collect();
                rigid.retain(|&patch| drawing.is_changed(patch));
            }
            if rigid.is_empty() {
                return Ok(CoplanarMerge::Merged(drawn.merged));
            }
        }
        rigid.sort_unstable();
        rigid.dedup();
        // Each triangle of a patch that is left as it is becomes a patch.
        let members = drawing.members;
        let mut next = members.len() as u32;
        for &patch in &rigid {
            for &own in members.list(patch as usize) {
                patch_of[own as usize] = next;
                next += 1;
                triangles[own as usize].iter().for_each(|&corner| is_kept[corner as usize] = true);
            }
        }
        patch_of = numbered(&patch_of);
    }
    Ok(CoplanarMerge::AsBefore)
}

/// Triangles that are known to meet each other in common corners and sides alone.
struct Known {
    /// Whether a triangle of before is one of them.
    before: Vec<bool>,
    /// The others, by their corners, rising.
    drawn: Vec<[u32; 3]>,
}

impl Known {
    fn new(before: Vec<bool>) -> Self {
        Self { before, drawn: Vec::new() }
    }

    fn has(&self, drawn: &Drawn, own: usize) -> bool {
        match drawn.sources[own] {
            NONE => self.drawn.binary_search(&drawn.merged.triangles[own]).is_ok(),
            source => self.before[source as usize],
        }
    }

    /// The triangles of a drawing that meet others otherwise, rising; then those that do not are the known ones.
    fn crossing(&mut self, positions: &Positions, drawn: &Drawn) -> Result<Vec<u32>, Error> {
        let triangles = &drawn.merged.triangles;
        let crossing = crossing_triangles(positions, triangles, |own| !self.has(drawn, own))?;
        let mut is_known = vec![true; triangles.len()];
        crossing.iter().for_each(|&own| is_known[own as usize] = false);
        (self.before, self.drawn) = (vec![false; self.before.len()], Vec::new());
        for ((own, &source), _) in triangles.iter().zip(&drawn.sources).zip(is_known).filter(|own| own.1) {
            match source {
                NONE => self.drawn.push(*own),
                source => self.before[source as usize] = true,
            }
        }
        self.drawn.par_sort_unstable();
        Ok(crossing)
    }
}

/// The same classes numbered without gaps.
fn numbered(classes: &[u32]) -> Vec<u32> {
    let mut number = vec![NONE; classes.iter().max().map_or(0, |&last| last as usize + 1)];
    let mut count = 0;
    let mut numbers = Vec::with_capacity(classes.len());
    for &class in classes {
        let own = &mut number[class as usize];
        if *own == NONE {
            *own = count;
            count += 1;
        }
        numbers.push(*own);
    }
    numbers
}

/// Triangles with their neighbors. Side 3t + i of triangle t goes from corner i to the next.
struct Surface<'a> {
    points: GivenPoints<'a>,
    places: &'a [[f64; 3]],
    triangles: &'a [[u32; 3]],
    /// The side on the other side of each edge, where just two run along it, one each way.
    twin: Vec<u32>,
    /// The other edges, rising, with how many sides run along each.
    odd: Vec<([u32; 2], usize)>,
    /// Twice the vector area of each triangle.
    normals: Vec<[f64; 3]>,
    tolerance: f64,
}

/// The ends of the sides of triangles, the smaller first, rising; each with twice its number, plus one if it runs to the smaller.
fn sorted_sides(triangles: &[[u32; 3]]) -> Vec<([u32; 2], u32)> {
    let corners = triangles.as_flattened().par_iter().enumerate();
    let mut sides: Vec<([u32; 2], u32)> = corners
        .map(|(side, &from)| {
            let to = triangles[side / 3][(side + 1) % 3];
            ([from.min(to), from.max(to)], (side as u32) << 1 | u32::from(from > to))
        })
        .collect();
    sides.par_sort_unstable();
    sides
}

/// The plane that a patch is near to.
#[derive(Clone, Copy)]
struct Plane {
    origin: [f64; 3],
    normal: [f64; 3],
    seed: u32,
}

impl<'a> Surface<'a> {
    fn new(positions: &'a Positions, triangles: &'a [[u32; 3]], tolerance: f64) -> Result<Self, Error> {
        let points = GivenPoints::new(positions)?;
        let places = positions.as_flat().as_chunks::<3>().0;
        let sides = sorted_sides(triangles);
        let mut twin = vec![NONE; sides.len()];
        let mut odd = Vec::new();
        for own in sides.chunk_by(|x, y| x.0 == y.0) {
            match own {
                &[(_, x), (_, y)] if (x ^ y) & 1 == 1 => {
                    (twin[(x >> 1) as usize], twin[(y >> 1) as usize]) = (y >> 1, x >> 1);
                }
                _ => odd.push((own[0].0, own.len())),
            }
        }
        let normals = triangles
            .par_iter()
            .map(|own| {
                let [a, b, c] = own.map(|corner| places[corner as usize]);
                cross(minus(b, a), minus(c, a))
            })
            .collect();
        Ok(Self { points, places, triangles, twin, odd, normals, tolerance })
    }

    fn place(&self, vertex: u32) -> [f64; 3] {
        self.places[vertex as usize]
    }

    fn ends(&self, side: u32) -> [u32; 2] {
        let own = self.triangles[(side / 3) as usize];
        let at = (side % 3) as usize;
        [own[at], own[(at + 1) % 3]]
    }

    /// Whether vertices stay since a side at them has not just one on the other side.
    fn ends_of_odd_sides(&self) -> Vec<bool> {
        let mut is_kept = vec![false; self.places.len()];
        for side in (0..self.twin.len() as u32).filter(|&side| self.twin[side as usize] == NONE) {
            self.ends(side).iter().for_each(|&end| is_kept[end as usize] = true);
        }
        is_kept
    }

    fn length_of_normal(&self, triangle: u32) -> f64 {
        let normal = self.normals[triangle as usize];
        dot(normal, normal).sqrt()
    }

    fn longest_side(&self, triangle: u32) -> f64 {
        let [a, b, c] = self.triangles[triangle as usize].map(|corner| self.place(corner));
        let squared = |way: [f64; 3]| dot(way, way);
        squared(minus(b, a)).max(squared(minus(c, b))).max(squared(minus(a, c))).sqrt()
    }

    /// Whether a triangle is no higher than the distance: which way it faces says nothing.
    fn is_thin(&self, triangle: u32) -> bool {
        self.length_of_normal(triangle) <= self.tolerance * self.longest_side(triangle)
    }

    /// The patch of each triangle. Patches grow from their largest triangle.
    fn grown(&self) -> Vec<u32> {
        let count = self.triangles.len();
        let mut order: Vec<(u64, u32)> = (0..count as u32)
            .into_par_iter()
            // Lengths are not negative: their bits are in their order.
            .map(|triangle| (!self.length_of_normal(triangle).to_bits(), triangle))
            .collect();
        order.par_sort_unstable();
        let mut patch_of = vec![NONE; count];
        let mut patch = 0;
        for (_, seed) in order {
            if patch_of[seed as usize] != NONE || self.is_thin(seed) {
                continue;
            }
            let length = self.length_of_normal(seed);
            let corner = self.place(self.triangles[seed as usize][0]);
            let mut plane =
                Plane { origin: corner, normal: self.normals[seed as usize].map(|x| x / length), seed };
            let mut members = vec![seed];
            patch_of[seed as usize] = patch;
            for _ in 0..MOST_FITS {
                if !self.grow(&mut members, &mut patch_of, &plane) || self.tolerance == 0.0 {
                    break;
                }
                plane = self.fitted(&members, seed);
            }
            if members.len() > 1 && self.tolerance > 0.0 {
                for &own in members[1..].iter().filter(|&&own| !self.fits(&plane, own)) {
                    patch_of[own as usize] = NONE;
                }
            }
            patch += 1;
        }
        for own in patch_of.iter_mut().filter(|own| **own == NONE) {
            *own = patch;
            patch += 1;
        }
        numbered(&patch_of)
    }

    /// Adds all triangles that are reached and near the plane; whether there were any.
    fn grow(&self, members: &mut Vec<u32>, patch_of: &mut [u32], plane: &Plane) -> bool {
        let (before, patch) = (members.len(), patch_of[plane.seed as usize]);
        let mut next = 0;
        while next < members.len() {
            let own = members[next];
            next += 1;
            for side in 3 * own..3 * own + 3 {
                let twin = self.twin[side as usize];
                if twin != NONE && patch_of[(twin / 3) as usize] == NONE && self.fits(plane, twin / 3) {
                    patch_of[(twin / 3) as usize] = patch;
                    members.push(twin / 3);
                }
            }
        }
        members.len() > before
    }

    fn fits(&self, plane: &Plane, triangle: u32) -> bool {
        let own = self.triangles[triangle as usize];
        if self.tolerance == 0.0 {
            let [a, b, c] = self.triangles[plane.seed as usize];
            let is_on = |&corner: &u32| self.points.orientation([a, b, c, corner]).is_eq();
            let fronts = |axis: usize| [[a, b, c], own].map(|corners| self.points.normal_sign(axis, corners));
            return own.iter().all(is_on)
                && (0..3).map(fronts).all(|[x, y]| x == y)
                && (0..3).any(|axis| self.points.normal_sign(axis, own).is_ne());
        }
        let height = |&corner: &u32| dot(plane.normal, minus(self.place(corner), plane.origin)).abs();
        own.iter().all(|corner| height(corner) <= self.tolerance)
            && (dot(plane.normal, self.normals[triangle as usize]) > 0.0 || self.is_thin(triangle))
    }

    /// The plane through the middle of some triangles with the direction of their vector area.
    fn fitted(&self, members: &[u32], seed: u32) -> Plane {
        let first = self.place(self.triangles[seed as usize][0]);
        let (mut normal, mut middle) = ([0.0; 3], [0.0; 3]);
        let weight = 1.0 / (3 * members.len()) as f64;
        for &own in members {
            normal = plus(normal, 1.0, self.normals[own as usize]);
            for corner in self.triangles[own as usize] {
                middle = plus(middle, weight, minus(self.place(corner), first));
            }
        }
        let length = dot(normal, normal).sqrt();
        Plane { origin: plus(first, 1.0, middle), normal: normal.map(|x| x / length), seed }
    }

    /// Whether the vertices between the ends of a path are on the way, one after the other.
    fn is_straight(&self, path: &[u32]) -> bool {
        let (first, last) = (path[0], path[path.len() - 1]);
        if first == last {
            return false;
        }
        if self.tolerance == 0.0 {
            let order = |a: u32, b: u32| {
                (0..3).map(|axis| self.points.compare(axis, a, b)).find(|order| order.is_ne())
            };
            let is_on = |&vertex: &u32| {
                (0..3).all(|axis| self.points.normal_sign(axis, [first, vertex, last]).is_eq())
            };
            let way = order(first, last);
            return path[1..path.len() - 1].iter().all(is_on)
                && path.windows(2).all(|pair| order(pair[0], pair[1]) == way);
        }
        let start = self.place(first);
        let along = minus(self.place(last), start);
        let length = dot(along, along);
        let mut before = 0.0;
        path[1..path.len() - 1].iter().all(|&vertex| {
            let to = minus(self.place(vertex), start);
            let part = dot(to, along) / length;
            let off = plus(to, -part, along);
            let is_further = part > before && part < 1.0;
            before = part;
            is_further && dot(off, off) <= self.tolerance * self.tolerance
        })
    }

    /// The vertex inside a path that is furthest from the line through its ends, or from its end if it is closed.
    fn furthest(&self, path: &[u32]) -> usize {
        let start = self.place(path[0]);
        let along = minus(self.place(path[path.len() - 1]), start);
        let length = dot(along, along);
        let distance = |at: usize| {
            let to = minus(self.place(path[at]), start);
            let off = if length > 0.0 { plus(to, -dot(to, along) / length, along) } else { to };
            dot(off, off)
        };
        let inner = 1..path.len() - 1;
        inner.max_by(|&i, &j| distance(i).total_cmp(&distance(j)).then(j.cmp(&i))).unwrap_or(1)
    }
}

/// What patches are drawn with.
struct Drawn {
    merged: CoplanarTriangles,
    /// The triangle of before that each is, if it is one of a patch that is as before.
    sources: Vec<u32>,
}

impl Drawn {
    /// Whether triangles meet otherwise than in common corners and sides that are as before, of these that meet others so. They
    /// stay as they are.
    fn is_crossing_as_before(&self, positions: &Positions, crossing: &[u32]) -> Result<bool, Error> {
        let is_as_before = |own: &&u32| self.sources[**own as usize] != NONE;
        let own: Vec<[u32; 3]> =
            crossing.iter().filter(is_as_before).map(|&own| self.merged.triangles[own as usize]).collect();
        Ok(!own.is_empty() && !crossing_triangles(positions, &own, |_| true)?.is_empty())
    }
}

/// Patches as they are drawn by their outlines.
struct Drawing<'a> {
    surface: &'a Surface<'a>,
    patch_of: &'a [u32],
    /// The triangles of each patch, rising.
    members: RaggedArray,
    /// The two sides that begin at a vertex and run along the rim of a patch; how many there are up to three.
    at_vertex: Vec<([u32; 2], u8)>,
    /// Whether a vertex inside a chain is left out.
    is_dropped: Vec<bool>,
    /// The new triangles of each patch; `None` where they are as before.
    outlined: Vec<Option<Vec<[u32; 3]>>>,
    /// Patches that cannot be drawn by their outlines.
    rigid: Vec<u32>,
}

impl<'a> Drawing<'a> {
    fn new(surface: &'a Surface<'a>, patch_of: &'a [u32], is_kept: &[bool]) -> Self {
        let count = patch_of.iter().max().map_or(0, |&last| last as usize + 1);
        let members = RaggedArray::grouped(count, patch_of.iter().copied());
        let mut drawing = Self {
            surface,
            patch_of,
            members,
            at_vertex: vec![([NONE; 2], 0); surface.places.len()],
            is_dropped: vec![false; surface.places.len()],
            outlined: Vec::new(),
            rigid: Vec::new(),
        };
        for side in 0..surface.twin.len() as u32 {
            if !drawing.is_rim(side) {
                continue;
            }
            let (own, count) = &mut drawing.at_vertex[surface.ends(side)[0] as usize];
            if let Some(place) = own.get_mut(usize::from(*count)) {
                *place = side;
            }
            *count = (*count + 1).min(3);
        }
        drawing.drop_vertices(is_kept);
        let outlined: Vec<Result<Option<Vec<[u32; 3]>>, ()>> =
            (0..count).into_par_iter().map(|patch| drawing.outlined(patch)).collect();
        for (patch, own) in (0..).zip(outlined) {
            if own.is_err() {
                drawing.rigid.push(patch);
            }
            drawing.outlined.push(own.unwrap_or_default());
        }
        drawing
    }

    fn patch(&self, side: u32) -> u32 {
        self.patch_of[(side / 3) as usize]
    }

    /// Whether another patch, or no single one, is on the other side.
    fn is_rim(&self, side: u32) -> bool {
        let twin = self.surface.twin[side as usize];
        twin == NONE || self.patch(twin) != self.patch(side)
    }

    /// The side that goes on along the same two patches, at a vertex where nothing else meets them.
    fn next(&self, side: u32, is_kept: &[bool]) -> Option<u32> {
        let end = self.surface.ends(side)[1];
        let ([x, y], 2) = self.at_vertex[end as usize] else { return None };
        let twin = self.surface.twin[side as usize];
        if is_kept[end as usize] || twin == NONE {
            return None;
        }
        let next = if x == twin {
            y
        } else if y == twin {
            x
        } else {
            return None;
        };
        let across = self.surface.twin[next as usize];
        (across != NONE && self.patch(next) == self.patch(side) && self.patch(across) == self.patch(twin))
            .then_some(next)
    }

    /// Finds out which vertices inside of chains are left out.
    fn drop_vertices(&mut self, is_kept: &[bool]) {
        let sides = self.surface.twin.len() as u32;
        let mut is_seen = vec![false; self.surface.places.len()];
        let starts: Vec<u32> = (0..sides).filter(|&side| self.is_rim(side)).collect();
        let begins = |side: u32| {
            let twin = self.surface.twin[side as usize];
            twin == NONE || self.next(twin, is_kept).is_none()
        };
        // Chains with ends, then those that are closed.
        let mut chains: Vec<Vec<u32>> = Vec::new();
        for is_open in [true, false] {
            for &first in &starts {
                let [from, to] = self.surface.ends(first);
                if is_open != begins(first) || is_seen[to as usize] || self.next(first, is_kept).is_none() {
                    continue;
                }
                let mut path = vec![from, to];
                is_seen[to as usize] = true;
                let mut side = first;
                while let Some(next) = self.next(side, is_kept) {
                    let end = self.surface.ends(next)[1];
                    path.push(end);
                    if end == from {
                        break;
                    }
                    if self.next(next, is_kept).is_some() {
                        is_seen[end as usize] = true;
                    }
                    side = next;
                }
                if !is_open {
                    is_seen[from as usize] = true;
                    // From the vertex that is first by its place, whichever side was met first.
                    path.pop();
                    let least = (0..path.len())
                        .min_by(|&i, &j| {
                            self.surface
                                .place(path[i])
                                .partial_cmp(&self.surface.place(path[j]))
                                .unwrap_or(Ordering::Equal)
                        })
                        .unwrap_or(0);
                    path.rotate_left(least);
                    path.push(path[0]);
                }
                chains.push(path);
            }
        }
        for path in chains {
            let mut parts = vec![(0, path.len() - 1)];
            while let Some((from, to)) = parts.pop() {
                if to - from < 2 {
                    continue;
                }
                let own = &path[from..=to];
                if self.surface.is_straight(own) {
                    own[1..own.len() - 1].iter().for_each(|&vertex| self.is_dropped[vertex as usize] = true);
                } else {
                    let at = from + self.surface.furthest(own);
                    parts.extend([(from, at), (at, to)]);
                }
            }
        }
    }

    /// The sides around a patch between vertices that are not left out; whether one was left out.
    fn outline(&self, patch: usize) -> (Vec<[u32; 2]>, bool) {
        let (mut outline, mut is_changed) = (Vec::new(), false);
        for &own in self.members.list(patch) {
            for side in (3 * own..3 * own + 3).filter(|&side| self.is_rim(side)) {
                let [from, mut to] = self.surface.ends(side);
                if self.is_dropped[from as usize] {
                    continue;
                }
                while self.is_dropped[to as usize] {
                    is_changed = true;
                    let [x, y] = self.at_vertex[to as usize].0;
                    let next = if self.patch(x) == patch as u32 { x } else { y };
                    to = self.surface.ends(next)[1];
                }
                outline.push([from, to]);
            }
        }
        (outline, is_changed)
    }

    /// The triangles that an outline needs; `None` if they are no fewer and those of before will do.
    fn outlined(&self, patch: usize) -> Result<Option<Vec<[u32; 3]>>, ()> {
        let members = self.members.list(patch);
        let (mut outline, is_changed) = self.outline(patch);
        if members.len() == 1 && !is_changed {
            return Ok(None);
        }
        outline.sort_unstable();
        if outline.windows(2).any(|pair| pair[0] == pair[1]) {
            return Err(());
        }
        let sides: Vec<[u32; 2]> =
            outline.iter().copied().filter(|&[a, b]| outline.binary_search(&[b, a]).is_err()).collect();
        let corners: Vec<[u32; 3]> =
            members.iter().map(|&own| self.surface.triangles[own as usize]).collect();
        if sides.is_empty() {
            // Nothing is left of what is no higher than the distance.
            let is_thin = members.iter().all(|&own| self.surface.is_thin(own));
            return if is_thin && euler_characteristic(&corners) == 1 {
                Ok(Some(Vec::new()))
            } else {
                Err(())
            };
        }
        if sides.len() < outline.len() {
            return Err(());
        }
        let normal =
            members.iter().fold([0.0; 3], |sum, &own| plus(sum, 1.0, self.surface.normals[own as usize]));
        let axis = (0..3).max_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap_or(0);
        let from = if normal[axis] < 0.0 { Sign::Minus } else { Sign::Plus };
        let view = AxisView { axis: axis as u8, from };
        let points = &self.surface.points;
        let compare = |a: u32, b: u32| view.compare(points, a, b);
        let turn = |a: u32, b: u32, c: u32| view.turn(points, [a, b, c]);
        let mut found = triangulate_sides(&sides, compare, turn).map_err(|_| ())?;
        flip_to_delaunay(&mut found, &sides, |vertex| points.point(vertex), turn);
        if found.len() >= members.len() && !is_changed {
            return Ok(None);
        }
        if euler_characteristic(&found) == euler_characteristic(&corners) { Ok(Some(found)) } else { Err(()) }
    }

    fn is_changed(&self, patch: u32) -> bool {
        self.outlined[patch as usize].is_some()
    }

    fn is_as_before(&self) -> bool {
        self.outlined.iter().all(Option::is_none)
    }

    fn drawn(&self) -> Drawn {
        let (mut triangles, mut patch_of_triangle, mut sources) = (Vec::new(), Vec::new(), Vec::new());
        for ((patch, own), members) in (0..).zip(&self.outlined).zip(self.members.iter()) {
            match own {
                Some(own) => {
                    triangles.extend(own);
                    sources.resize(triangles.len(), NONE);
                }
                None => {
                    triangles.extend(members.iter().map(|&own| self.surface.triangles[own as usize]));
                    sources.extend(members);
                }
            }
            patch_of_triangle.resize(triangles.len(), patch);
        }
        let patches = self.members.clone();
        Drawn { merged: CoplanarTriangles { triangles, patch_of_triangle, patches }, sources }
    }

    /// The patches that have been changed and have a side without just one on its other side, which was not so before.
    fn unpaired(&self, drawn: &CoplanarTriangles) -> Vec<u32> {
        let is_pair = |own: &[([u32; 2], u32)]| matches!(own, &[(_, x), (_, y)] if (x ^ y) & 1 == 1);
        let sides = sorted_sides(&drawn.triangles);
        let mut found = Vec::new();
        for own in sides.chunk_by(|x, y| x.0 == y.0).filter(|own| !is_pair(own)) {
            if self.surface.odd.binary_search(&(own[0].0, own.len())).is_err() {
                found.extend(own.iter().map(|side| drawn.patch_of_triangle[(side.1 >> 1) as usize / 3]));
            }
        }
        found.retain(|&patch| self.is_changed(patch));
        found
    }
}

/// Vertices - edges + triangles.
fn euler_characteristic(triangles: &[[u32; 3]]) -> i64 {
    let mut vertices: Vec<u32> = triangles.as_flattened().to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    let mut edges: Vec<[u32; 2]> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]].map(|[x, y]| [x.min(y), x.max(y)]))
        .collect();
    edges.sort_unstable();
    edges.dedup();
    vertices.len() as i64 - edges.len() as i64 + triangles.len() as i64
}
