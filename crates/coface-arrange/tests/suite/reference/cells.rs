//! The cells between faces.

use super::drawing::winding;
use super::space::{Faces, Polygon, faces, integer_dot, winding_in};
use super::{Point, Vector, cross, dot, minus, moved, number, quotient, vector};
use coface_algebra::{Rational, UnionFind};
use std::collections::BTreeMap;

/// A bounded cell.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Cell {
    pub(crate) volume: Rational,
    /// How often each input winds around it; meaningless for inputs that are not closed.
    pub(crate) windings: Vec<i64>,
    pub(crate) void_count: usize,
    /// The number of faces on its boundary, those with the cell on both sides twice.
    pub(crate) side_count: usize,
}

/// The arrangement of polygons.
pub(crate) struct Arrangement {
    pub(crate) faces: Faces,
    /// Rising.
    pub(crate) cells: Vec<Cell>,
}

impl Arrangement {
    pub(crate) fn f_vector(&self) -> [usize; 4] {
        let Faces { vertices, edges, faces, .. } = &self.faces;
        [vertices.len(), edges.len(), faces.len(), self.cells.len()]
    }

    pub(crate) fn volumes(&self) -> Vec<f64> {
        self.cells.iter().map(|cell| cell.volume.to_f64()).collect()
    }

    /// The volume where a condition on winding numbers holds.
    pub(crate) fn volume_where(&self, condition: impl Fn(&[i64]) -> bool) -> Rational {
        let mut sum = Rational::ZERO;
        let inside = self.cells.iter().filter(|cell| condition(&cell.windings));
        inside.for_each(|cell| sum += &cell.volume);
        sum
    }

    /// The polygons of each face with the signs of their fronts, sorted: what coarse faces are known by.
    pub(crate) fn sources_of_faces(&self) -> Vec<Vec<(usize, i64)>> {
        let mut sources: Vec<_> = self
            .faces
            .faces
            .iter()
            .map(|face| {
                // Relative to the first polygon: which way a plane looks is nobody's business.
                let sign = face.polygons[0].1;
                face.polygons.iter().map(|&(polygon, own)| (polygon, own * sign)).collect()
            })
            .collect();
        sources.sort();
        sources
    }
}

/// The signed volume that polygons enclose: a sixth of what their planes' offsets and areas say.
pub(crate) fn enclosed_volume(polygons: &[Polygon]) -> Rational {
    let sixth = quotient(&Rational::ONE, &number(6));
    let sum = polygons.iter().map(|polygon| integer_dot(polygon.normal(), polygon.walks[0][0])).sum();
    &number(sum) * &sixth
}

/// Directions that are parallel to few planes.
const DIRECTIONS: [[i64; 3]; 8] = [
    [1009, 613, 307],
    [-401, 1201, 733],
    [811, -523, 1103],
    [-907, -311, 577],
    [139, 1511, -701],
    [-1301, 449, -887],
    [661, -1123, -239],
    [-557, -1013, -1429],
];

/// What a ray does with a face, or a polygon.
enum Meeting {
    Miss,
    Hit(Rational),
    /// Nothing that can be counted.
    Unclear,
}

/// A plane and a point on the ray: where it meets what is in the plane, as `winding_at` says.
fn meeting(
    height: &Rational,
    slope: &Rational,
    winding_at: impl FnOnce(&Rational) -> Option<i64>,
) -> Meeting {
    if slope.is_zero() {
        return if height.is_zero() { Meeting::Unclear } else { Meeting::Miss };
    }
    let t = quotient(&-height, slope);
    if t < Rational::ZERO {
        return Meeting::Miss;
    }
    match winding_at(&t) {
        None => Meeting::Unclear,
        Some(0) => Meeting::Miss,
        Some(_) if t.is_zero() => Meeting::Unclear,
        Some(_) => Meeting::Hit(t),
    }
}

impl Faces {
    fn meet(&self, face: usize, p: &Vector, ray: &Vector) -> Meeting {
        let face = &self.faces[face];
        let plane = &self.planes[face.plane];
        meeting(&plane.height(p), &dot(&vector(plane.normal), ray), |t| {
            let x = plane.drawn(&moved(p, t, ray));
            let mut sum = 0;
            for walk in &face.walks {
                let walk: Vec<Point> = walk.iter().map(|&v| plane.drawn(&self.vertices[v])).collect();
                sum += winding(walk.iter(), &x)?;
            }
            Some(sum)
        })
    }

    /// How often half-faces wind around a point that is on none of them.
    fn winding(&self, half_faces: &[u32], p: &Vector) -> i64 {
        'directions: for ray in DIRECTIONS.map(vector) {
            let mut sum = 0;
            for &half in half_faces {
                let face = half as usize / 2;
                let outward = if half % 2 == 0 { 1 } else { -1 };
                let normal = vector(self.planes[self.faces[face].plane].normal);
                match self.meet(face, p, &ray) {
                    Meeting::Miss => {}
                    Meeting::Unclear => continue 'directions,
                    Meeting::Hit(_) if dot(&normal, &ray) > Rational::ZERO => sum += outward,
                    Meeting::Hit(_) => sum -= outward,
                }
            }
            return sum;
        }
        panic!("no direction misses all edges")
    }

    /// The half-face that is seen first from the side of a face, and a point before it.
    fn first_seen(&self, half: u32) -> Option<(u32, Vector)> {
        let own = half as usize / 2;
        let normal = vector(self.planes[self.faces[own].plane].normal);
        let start = &self.faces[own].inside;
        'directions: for ray in DIRECTIONS.map(vector) {
            let is_front = dot(&normal, &ray) > Rational::ZERO;
            let ray = if is_front == (half % 2 == 1) { ray } else { [0, 1, 2].map(|i| -&ray[i]) };
            let mut first: Option<(Rational, usize)> = None;
            for face in (0..self.faces.len()).filter(|&face| face != own) {
                match self.meet(face, start, &ray) {
                    Meeting::Miss => {}
                    Meeting::Unclear => continue 'directions,
                    Meeting::Hit(t) => {
                        if first.as_ref().is_none_or(|(best, _)| t < *best) {
                            first = Some((t, face));
                        }
                    }
                }
            }
            let (t, face) = first?;
            let slope = dot(&vector(self.planes[self.faces[face].plane].normal), &ray);
            let seen = 2 * face as u32 + u32::from(slope < Rational::ZERO);
            return Some((seen, moved(start, &quotient(&t, &number(2)), &ray)));
        }
        panic!("no direction misses all edges")
    }

    /// The half-faces around each edge that look at each other: 2f is the back of face f, 2f + 1 its front.
    fn gaps(&self) -> Vec<[u32; 2]> {
        let mut wings: BTreeMap<[usize; 2], Vec<(Vector, u32)>> = BTreeMap::new();
        for (index, face) in (0..).zip(&self.faces) {
            let normal = vector(self.planes[face.plane].normal);
            for walk in &face.walks {
                for (i, &from) in walk.iter().enumerate() {
                    let to = walk[(i + 1) % walk.len()];
                    let side = minus(&self.vertices[to], &self.vertices[from]);
                    let wing = cross(&normal, &side);
                    // The front is counterclockwise of a face that runs with the edge, the back of one that runs against it.
                    wings
                        .entry([from.min(to), from.max(to)])
                        .or_default()
                        .push((wing, 2 * index + u32::from(from > to)));
                }
            }
        }
        let mut gaps = Vec::new();
        for ([low, high], mut around) in wings {
            let along = minus(&self.vertices[high], &self.vertices[low]);
            let first = around[0].0.clone();
            let second = cross(&along, &first);
            let place = |wing: &Vector| [dot(wing, &first), dot(wing, &second)];
            let half = |d: &Point| (&d[1], &d[0]) < (&Rational::ZERO, &Rational::ZERO);
            around.sort_by(|(p, _), (q, _)| {
                let [p, q] = [place(p), place(q)];
                half(&p).cmp(&half(&q)).then_with(|| Rational::ZERO.cmp(&super::turn(&p, &q)))
            });
            for i in 0..around.len() {
                let ((p, here), (q, next)) = (&around[i], &around[(i + 1) % around.len()]);
                let [u, v] = [place(p), place(q)];
                let is_same = super::turn(&u, &v).is_zero() && super::dot(&u, &v) > Rational::ZERO;
                assert!(around.len() == 1 || !is_same, "faces in one plane overlap");
                gaps.push([*here ^ 1, *next]);
            }
        }
        gaps
    }
}

/// The arrangement of polygons, each of one of `input_count` inputs.
pub(crate) fn arrangement(polygons: &[Polygon], input_count: usize) -> Arrangement {
    let faces = faces(polygons);
    let face_count = faces.faces.len();
    let (mut shells, mut components) = (UnionFind::new(2 * face_count), UnionFind::new(face_count));
    for [a, b] in faces.gaps() {
        shells.unite(a, b);
        components.unite(a / 2, b / 2);
    }
    let component_of = components.class_numbers();
    let shell_of = shells.class_numbers();
    let mut members = vec![Vec::new(); shells.class_count()];
    (0..).zip(&shell_of).for_each(|(half, &shell)| members[shell as usize].push(half));
    let volume = |half_faces: &Vec<u32>| {
        let mut sum = Rational::ZERO;
        for &half in half_faces {
            let face = &faces.faces[half as usize / 2];
            let plane = &faces.planes[face.plane];
            let sign = if half % 2 == 0 { 1 } else { -1 };
            let part = &number(sign * plane.offset) * &face.doubled;
            sum += &quotient(&part, &number(6 * plane.normal[plane.axis]));
        }
        sum
    };
    let volumes: Vec<Rational> = members.iter().map(volume).collect();
    // The outer shell of a component is the one that encloses least.
    let mut outer: Vec<Option<usize>> = vec![None; components.class_count()];
    let shell_component = |shell: usize| component_of[members[shell][0] as usize / 2] as usize;
    for shell in 0..members.len() {
        let known = &mut outer[shell_component(shell)];
        if known.is_none_or(|best| volumes[shell] < volumes[best]) {
            *known = Some(shell);
        }
    }
    let mut cell_of_shell: Vec<Option<usize>> = vec![None; members.len()];
    let mut own_shells: Vec<Vec<usize>> = Vec::new();
    for shell in (0..members.len()).filter(|&shell| outer[shell_component(shell)] != Some(shell)) {
        assert!(volumes[shell] > Rational::ZERO, "a component has one outer shell");
        cell_of_shell[shell] = Some(own_shells.len());
        own_shells.push(vec![shell]);
    }
    for (component, outer) in outer.iter().enumerate() {
        let outer = outer.unwrap();
        assert!(volumes[outer] <= Rational::ZERO, "the outer shell encloses nothing");
        let place = &faces.faces[members[outer][0] as usize / 2].inside;
        let around = (0..members.len()).filter(|&shell| {
            volumes[shell] > Rational::ZERO
                && shell_component(shell) != component
                && faces.winding(&members[shell], place) != 0
        });
        if let Some(parent) = around.min_by(|&i, &j| volumes[i].cmp(&volumes[j])) {
            cell_of_shell[outer] = cell_of_shell[parent];
            own_shells[cell_of_shell[parent].unwrap()].push(outer);
        }
    }
    // Whoever is seen from the side of a face is at the same cell.
    let mut inside: Vec<Option<Vector>> = vec![None; own_shells.len()];
    for half in 0..2 * face_count as u32 {
        let cell = cell_of_shell[shell_of[half as usize] as usize];
        if cell.is_some_and(|cell| inside[cell].is_some()) {
            continue;
        }
        match (faces.first_seen(half), cell) {
            (None, cell) => assert_eq!(cell, None, "cells are bounded"),
            (Some((seen, p)), cell) => {
                assert_eq!(cell_of_shell[shell_of[seen as usize] as usize], cell, "both sides of a cell");
                if let Some(cell) = cell {
                    inside[cell] = Some(p);
                }
            }
        }
    }
    let cells = own_shells.iter().zip(inside).map(|(own, inside)| {
        let mut volume = Rational::ZERO;
        own.iter().for_each(|&shell| volume += &volumes[shell]);
        assert!(volume > Rational::ZERO);
        let windings = windings(&faces, polygons, input_count, &inside.expect("a cell has sides"));
        let side_count = own.iter().map(|&shell| members[shell].len()).sum();
        Cell { volume, windings, void_count: own.len() - 1, side_count }
    });
    let mut cells: Vec<Cell> = cells.collect();
    cells.sort();
    let found = Arrangement { faces, cells };
    found.check(polygons, input_count);
    found
}

/// How often each input winds around a point, by a ray through the polygons.
fn windings(faces: &Faces, polygons: &[Polygon], input_count: usize, p: &Vector) -> Vec<i64> {
    'directions: for ray in DIRECTIONS.map(vector) {
        let mut sums = vec![0; input_count];
        for (polygon, plane) in polygons.iter().zip(&faces.plane_of) {
            let Some((plane, sign)) = plane else { continue };
            let plane = &faces.planes[*plane];
            let slope = dot(&vector(plane.normal), &ray);
            let found = meeting(&plane.height(p), &slope, |t| winding_in(plane, polygon, &moved(p, t, &ray)));
            match found {
                Meeting::Miss => {}
                Meeting::Unclear => continue 'directions,
                Meeting::Hit(_) if slope > Rational::ZERO => sums[polygon.input] += sign,
                Meeting::Hit(_) => sums[polygon.input] -= sign,
            }
        }
        return sums;
    }
    panic!("no direction misses all rims")
}

impl Arrangement {
    /// What holds whatever was done above.
    fn check(&self, polygons: &[Polygon], input_count: usize) {
        // Alexander duality: the cells are counted by the cycles of faces.
        assert_eq!(self.cells.len(), self.faces.faces.len() - self.face_rank());
        // Where an input is closed, what it encloses is what its winding numbers say.
        for input in 0..input_count {
            let own: Vec<Polygon> = polygons.iter().filter(|p| p.input == input).cloned().collect();
            if is_closed(&own) {
                let mut sum = Rational::ZERO;
                self.cells.iter().for_each(|cell| sum += &(&number(cell.windings[input]) * &cell.volume));
                assert_eq!(sum, enclosed_volume(&own), "input {input}");
            }
        }
    }

    /// The rank of the boundary matrix of faces modulo a prime.
    fn face_rank(&self) -> usize {
        const PRIME: i64 = 1_000_003;
        let number_of: BTreeMap<[usize; 2], usize> =
            (0..).zip(&self.faces.edges).map(|(i, &e)| (e, i)).collect();
        let mut pivots: BTreeMap<usize, BTreeMap<usize, i64>> = BTreeMap::new();
        for face in &self.faces.faces {
            let mut row: BTreeMap<usize, i64> = BTreeMap::new();
            for walk in &face.walks {
                for (i, &from) in walk.iter().enumerate() {
                    let to = walk[(i + 1) % walk.len()];
                    let sign = if from < to { 1 } else { PRIME - 1 };
                    let entry = row.entry(number_of[&[from.min(to), from.max(to)]]).or_default();
                    *entry = (*entry + sign) % PRIME;
                }
            }
            row.retain(|_, entry| *entry != 0);
            while let Some((&lead, &entry)) = row.first_key_value() {
                let Some(pivot) = pivots.get(&lead) else {
                    pivots.insert(lead, row);
                    break;
                };
                let factor = entry * inverse(pivot[&lead], PRIME) % PRIME;
                for (&edge, &term) in pivot {
                    let entry = row.entry(edge).or_default();
                    *entry = (*entry + (PRIME - factor) * term) % PRIME;
                }
                row.retain(|_, entry| *entry != 0);
            }
        }
        pivots.len()
    }
}

fn inverse(x: i64, prime: i64) -> i64 {
    let (mut power, mut result, mut exponent) = (x, 1, prime - 2);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = result * power % prime;
        }
        power = power * power % prime;
        exponent >>= 1;
    }
    result
}

/// Whether the sides of polygons cancel, piece by piece: cut at all corners.
pub(crate) fn is_closed(polygons: &[Polygon]) -> bool {
    let corners: Vec<[i64; 3]> = polygons.iter().flat_map(|p| p.walks.iter().flatten().copied()).collect();
    let mut sum: BTreeMap<[[i64; 3]; 2], i64> = BTreeMap::new();
    for [p, q] in polygons.iter().flat_map(|polygon| polygon.sides().collect::<Vec<_>>()) {
        let side = [0, 1, 2].map(|i| q[i] - p[i]);
        let mut on: Vec<(i64, [i64; 3])> = corners
            .iter()
            .filter_map(|&corner| {
                let offset = [0, 1, 2].map(|i| corner[i] - p[i]);
                let along = integer_dot(side, offset);
                let is_on = super::space::integer_cross(side, offset) == [0; 3];
                (is_on && along >= 0 && along <= integer_dot(side, side)).then_some((along, corner))
            })
            .collect();
        on.sort_unstable();
        on.dedup();
        for pair in on.windows(2) {
            let [a, b] = [pair[0].1, pair[1].1];
            *sum.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
        }
    }
    sum.values().all(|&count| count == 0)
}
