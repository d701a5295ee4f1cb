//! Normal surfaces by quadrilaterals, and what is left when one is crushed to a point.
//!
//! A normal surface meets each tetrahedron in triangles, which cut off a vertex, and quadrilaterals, which separate two opposite edges.
//! Quadrilateral type i separates vertices 0 and i + 1 from the two others. A surface is embedded if each tetrahedron has one type of
//! quadrilaterals at most. The quadrilaterals give the surface up to spheres around vertices.
//!
//! Sources: J. L. Tollefson, *Normal surface Q-theory* (1998); B. A. Burton, *Optimizing the double description method for normal surface
//! enumeration* (2010) and *A new approach to crushing 3-manifold triangulations* (2014).

use coface_algebra::Error;
use coface_complexes::gluing::{FaceClasses, GluingTable};
use std::collections::VecDeque;

/// A vertex beside another: quadrilaterals of a type keep the two on one side.
const PARTNERS: [[usize; 4]; 3] = [[1, 0, 3, 2], [2, 3, 0, 1], [3, 2, 1, 0]];

/// The most tetrahedra that are looked at: types of quadrilaterals are bits of 128.
const TETRAHEDRA: usize = 42;

/// The most vectors that an enumeration keeps at a time.
const VECTORS: usize = 6_000;

/// The most comparisons of vectors that an enumeration makes.
const COMPARISONS: usize = 300_000_000;

/// The quadrilateral type that keeps two different vertices on one side.
fn type_beside(a: usize, b: usize) -> usize {
    (0..3).find(|&kind| PARTNERS[kind][a] == b).unwrap_or(0)
}

/// An embedded normal surface of a closed triangulation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct NormalSurface {
    /// How many triangles cut off each vertex of each tetrahedron.
    triangles: Vec<[i64; 4]>,
    /// How many quadrilaterals of each type each tetrahedron has.
    quadrilaterals: Vec<[i64; 3]>,
}

impl NormalSurface {
    /// The surface with these quadrilaterals and the fewest triangles. `None` if numbers do not fit.
    fn from_quadrilaterals(table: &GluingTable, quadrilaterals: Vec<[i64; 3]>) -> Option<Self> {
        let count = table.simplex_count();
        let mut triangles = vec![[0_i64; 4]; count];
        let mut is_seen = vec![[false; 4]; count];
        for start in (0..count).flat_map(|tetrahedron| (0..4).map(move |vertex| (tetrahedron, vertex))) {
            if is_seen[start.0][start.1] {
                continue;
            }
            is_seen[start.0][start.1] = true;
            let mut reached = vec![start];
            let mut queue = VecDeque::from([start]);
            while let Some((tetrahedron, vertex)) = queue.pop_front() {
                for facet in (0..4).filter(|&facet| facet != vertex) {
                    let (next, images) = table.neighbor(tetrahedron, facet)?;
                    let (to, across) = (usize::from(images[vertex]), usize::from(images[facet]));
                    // Arcs around the vertex in this facet come from triangles, and from quadrilaterals that keep the vertex beside the one across.
                    let arcs = triangles[tetrahedron][vertex]
                        .checked_add(quadrilaterals[tetrahedron][type_beside(vertex, facet)])?;
                    let there = arcs.checked_sub(quadrilaterals[next][type_beside(to, across)])?;
                    if !is_seen[next][to] {
                        is_seen[next][to] = true;
                        triangles[next][to] = there;
                        reached.push((next, to));
                        queue.push_back((next, to));
                    } else if triangles[next][to] != there {
                        return None;
                    }
                }
            }
            let least = reached.iter().map(|&(tetrahedron, vertex)| triangles[tetrahedron][vertex]).min()?;
            for (tetrahedron, vertex) in reached {
                triangles[tetrahedron][vertex] = triangles[tetrahedron][vertex].checked_sub(least)?;
            }
        }
        Some(Self { triangles, quadrilaterals })
    }

    /// The number of points on an edge, by a tetrahedron and two of its vertices.
    fn weight(&self, tetrahedron: usize, a: usize, b: usize) -> i64 {
        let beside = type_beside(a, b);
        let crossing: i64 =
            (0..3).filter(|&kind| kind != beside).map(|kind| self.quadrilaterals[tetrahedron][kind]).sum();
        self.triangles[tetrahedron][a] + self.triangles[tetrahedron][b] + crossing
    }

    /// The Euler characteristic.
    pub(super) fn euler_characteristic(&self, faces: &FaceClasses) -> i64 {
        let mut is_counted = vec![false; faces.class_counts()[1]];
        let (mut points, mut sides, mut pieces) = (0, 0, 0);
        for (tetrahedron, (triangles, quadrilaterals)) in
            self.triangles.iter().zip(&self.quadrilaterals).enumerate()
        {
            let (threes, fours): (i64, i64) = (triangles.iter().sum(), quadrilaterals.iter().sum());
            pieces += threes + fours;
            sides += 3 * threes + 4 * fours;
            for (a, b) in (0..4).flat_map(|b| (0..b).map(move |a| (a, b))) {
                let class = faces.of_face(tetrahedron, 1 << a | 1 << b).0;
                if !std::mem::replace(&mut is_counted[class], true) {
                    points += self.weight(tetrahedron, a, b);
                }
            }
        }
        points - sides / 2 + pieces
    }

    /// The type of the quadrilaterals of a tetrahedron, if it has some.
    fn kind(&self, tetrahedron: usize) -> Option<usize> {
        self.quadrilaterals[tetrahedron].iter().position(|&count| count > 0)
    }

    /// The triangulation with the surface crushed to a point: tetrahedra with quadrilaterals are flattened, and what has become thinner than
    /// a tetrahedron goes. Connected or not, and without tetrahedra maybe.
    ///
    /// If the surface is a sphere in a closed orientable manifold, the result is got from it by undoing connected sums, taking 3-spheres away,
    /// and taking summands S2 x S1, RP3 and L(3,1) away.
    pub(super) fn crushed(&self, table: &GluingTable) -> Result<GluingTable, Error> {
        let kept: Vec<usize> =
            (0..table.simplex_count()).filter(|&tetrahedron| self.kind(tetrahedron).is_none()).collect();
        let mut number = vec![0; table.simplex_count()];
        for (new, &old) in kept.iter().enumerate() {
            number[old] = new;
        }
        let mut left = GluingTable::unglued(3, kept.len())?;
        for &tetrahedron in &kept {
            for facet in 0..4 {
                if left.neighbor(number[tetrahedron], facet).is_some() {
                    continue;
                }
                let Some((mut at, images)) = table.neighbor(tetrahedron, facet) else { continue };
                let mut images: [usize; 4] = std::array::from_fn(|vertex| usize::from(images[vertex]));
                // In at one facet of a flat tetrahedron, out at the one that is folded onto it.
                while let Some(kind) = self.kind(at) {
                    let out = PARTNERS[kind][images[facet]];
                    let swapped = images.map(|vertex| match vertex {
                        vertex if vertex == images[facet] => out,
                        vertex if vertex == out => images[facet],
                        vertex => vertex,
                    });
                    let Some((next, onward)) = table.neighbor(at, out) else {
                        return Err(Error::invalid("a crushed tetrahedron is at the boundary"));
                    };
                    images = swapped.map(|vertex| usize::from(onward[vertex]));
                    at = next;
                }
                left.glue(number[tetrahedron], facet, number[at], &images.map(|vertex| vertex as u32))?;
            }
        }
        Ok(left)
    }
}

/// One equation for each edge: walking around it, as many quadrilaterals go up as down. Entries are (column, coefficient), with column
/// 3 t + i for type i of tetrahedron t.
fn matching_equations(table: &GluingTable, faces: &FaceClasses) -> Option<Vec<Vec<(usize, i64)>>> {
    let mut is_seen = vec![false; faces.class_counts()[1]];
    let mut equations = Vec::new();
    for tetrahedron in 0..table.simplex_count() {
        for (a, b) in (0..4).flat_map(|b| (0..b).map(move |a| (a, b))) {
            let class = faces.of_face(tetrahedron, 1 << a | 1 << b).0;
            if std::mem::replace(&mut is_seen[class], true) {
                continue;
            }
            let mut others = (0..4).filter(|&vertex| vertex != a && vertex != b);
            let start = (tetrahedron, [a, b, others.next()?, others.next()?]);
            let mut row = vec![0_i64; 3 * table.simplex_count()];
            let mut at = start;
            // As many steps as there are edges of tetrahedra, each in two directions; more of them in no closed manifold.
            let mut steps = 0;
            loop {
                let (here, [a, b, c, d]) = at;
                row[3 * here + type_beside(a, c)] += 1;
                row[3 * here + type_beside(b, c)] -= 1;
                // Out through the facet across c, where the next tetrahedron has d first.
                let (next, images) = table.neighbor(here, c)?;
                at = (next, [a, b, d, c].map(|vertex| usize::from(images[vertex])));
                steps += 1;
                if at == start {
                    break;
                }
                if steps > 12 * table.simplex_count() {
                    return None;
                }
            }
            let entries: Vec<(usize, i64)> =
                row.into_iter().enumerate().filter(|&(_, value)| value != 0).collect();
            if !entries.is_empty() {
                equations.push(entries);
            }
        }
    }
    // Equations with early columns first keep the numbers of vectors small.
    equations.sort();
    equations.dedup();
    Some(equations)
}

/// A vector of the enumeration, and the set of its columns that are not zero.
#[derive(Clone, Debug)]
struct Ray {
    values: Vec<i64>,
    support: u128,
}

/// Whether each tetrahedron has one type of quadrilaterals at most.
fn is_embedded(support: u128) -> bool {
    let mut left = support;
    while left != 0 {
        let triple = left & 7;
        if triple & triple.wrapping_sub(1) != 0 {
            return false;
        }
        left >>= 3;
    }
    true
}

/// All embedded vertex surfaces by quadrilaterals, with the least whole numbers. `None` if there are too many, numbers are too large, or the
/// table is none of a closed manifold.
///
/// Double description: the cone of all vectors is cut by one equation after the other; a new vector comes from two neighboring ones on both
/// sides. Exponential in the number of tetrahedra at worst; bounded by a fixed number of vectors.
pub(super) fn vertex_surfaces(table: &GluingTable, faces: &FaceClasses) -> Option<Vec<NormalSurface>> {
    let count = table.simplex_count();
    if count > TETRAHEDRA {
        return None;
    }
    let columns = 3 * count;
    let mut rays: Vec<Ray> = (0..columns)
        .map(|column| {
            let mut values = vec![0; columns];
            values[column] = 1;
            Ray { values, support: 1 << column }
        })
        .collect();
    let mut comparisons = COMPARISONS;
    for equation in matching_equations(table, faces)? {
        rays = cut(rays, &equation, &mut comparisons)?;
    }
    rays.into_iter()
        .map(|ray| {
            let quadrilaterals = ray.values.chunks(3).map(|chunk| [chunk[0], chunk[1], chunk[2]]).collect();
            NormalSurface::from_quadrilaterals(table, quadrilaterals)
        })
        .collect()
}

/// The extreme rays of a cone where an equation holds too; comparisons are counted down.
fn cut(rays: Vec<Ray>, equation: &[(usize, i64)], comparisons: &mut usize) -> Option<Vec<Ray>> {
    let mut sums = Vec::with_capacity(rays.len());
    for ray in &rays {
        let mut sum = 0_i64;
        for &(column, coefficient) in equation {
            sum = sum.checked_add(coefficient.checked_mul(ray.values[column])?)?;
        }
        sums.push(sum);
    }
    let on_side =
        |sign: i64| -> Vec<usize> { (0..rays.len()).filter(|&at| sums[at].signum() == sign).collect() };
    let (above, below) = (on_side(1), on_side(-1));
    let mut made = Vec::new();
    for &up in &above {
        for &down in &below {
            let union = rays[up].support | rays[down].support;
            if !is_embedded(union) {
                continue;
            }
            *comparisons = comparisons.checked_sub(rays.len())?;
            // Neighbors: no third ray lies in the smallest face with both.
            let is_between = |(at, ray): (usize, &Ray)| at != up && at != down && ray.support & !union == 0;
            if rays.iter().enumerate().any(is_between) {
                continue;
            }
            made.push(combined(&rays[up], sums[up], &rays[down], sums[down])?);
            if made.len() > VECTORS {
                return None;
            }
        }
    }
    let mut left: Vec<Ray> =
        rays.into_iter().zip(&sums).filter(|&(_, &sum)| sum == 0).map(|(ray, _)| ray).collect();
    left.extend(made);
    (left.len() <= VECTORS).then_some(left)
}

/// The positive combination of a ray above and one below on which the equation holds, in least whole numbers.
fn combined(up: &Ray, above: i64, down: &Ray, below: i64) -> Option<Ray> {
    let mut values = Vec::with_capacity(up.values.len());
    let mut divisor = 0_i64;
    for (&x, &y) in up.values.iter().zip(&down.values) {
        let value = x.checked_mul(below.checked_neg()?)?.checked_add(y.checked_mul(above)?)?;
        divisor = super::layered::bezout(divisor, value).0;
        values.push(value);
    }
    if divisor > 1 {
        for value in &mut values {
            *value /= divisor;
        }
    }
    Some(Ray { values, support: up.support | down.support })
}
