//! Facets of a piecewise linear complex: polygons and points in holes of one plane in space.

use crate::holed_faces::triangulated;
use crate::model::repeated_vertex;
use crate::{Place, Remark, RemarkCode};
use coface_geometry::predicates::orientation;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// The polygons of a facet with the lines of the file that they stand on, and a point in each of its holes.
///
/// A polygon of two vertices is a segment, one of a single vertex a point of the facet.
#[derive(Clone, Debug, Default)]
pub(crate) struct Facet {
    pub(crate) line: u64,
    pub(crate) polygons: Vec<(u64, Vec<u32>)>,
    pub(crate) holes: Vec<[f64; 3]>,
    /// For each polygon of a facet that was divided the rings of the surface that begins with it, the outer one first; none where it
    /// continues the surface before.
    pub(crate) surfaces: Vec<Vec<Vec<u32>>>,
}

impl Facet {
    /// Where polygons cross, or a hole point is in none or in an outer one: all of them as the rings of one surface, which is at
    /// fault.
    fn state_as_one(&mut self) {
        let rings: Vec<Vec<u32>> =
            self.polygons.iter().map(|own| own.1.clone()).filter(|ring| ring.len() > 2).collect();
        self.surfaces = vec![Vec::new(); self.polygons.len()];
        if let Some(first) = self.polygons.iter().position(|own| own.1.len() > 2) {
            self.surfaces[first] = rings;
        }
    }
}

/// What was found while facets were divided.
#[derive(Debug, Default)]
pub(crate) struct Facets {
    /// The facets that became triangles, that have rings which cross or touch themselves, and that have hole points outside of their rings.
    with_holes: Vec<u64>,
    crossing: Vec<u64>,
    outside: Vec<u64>,
}

/// Where a point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Inside,
    On,
    Outside,
}

impl Facets {
    /// Makes the polygons of a facet those of the parts of its plane that its rings enclose and that have no hole point; a part with rings inside of
    /// it becomes triangles. Segments and points that bound nothing stay as they are.
    ///
    /// One polygon without a hole point is left as it is; so are polygons that repeat vertices or cross each other, and those whose vertices have
    /// no finite position.
    pub(crate) fn divide(&mut self, facet: &mut Facet, point: impl Fn(u32) -> [f64; 3]) {
        let area_count = facet.polygons.iter().filter(|(_, polygon)| polygon.len() > 2).count();
        let segment_count = facet.polygons.iter().filter(|(_, polygon)| polygon.len() == 2).count();
        if facet.holes.is_empty() && area_count < 2 && segment_count < 3 {
            return;
        }
        let (rings, others) = rings_of(&facet.polygons);
        let is_finite = |vertex: &u32| point(*vertex).iter().all(|x| x.is_finite());
        if rings.is_empty() || !rings.iter().flat_map(|(_, ring)| ring).all(is_finite) {
            return;
        }
        let axes = plane_axes(&rings, &point);
        let flat = |vertex: u32| axes.map(|axis| point(vertex)[axis]);
        let holes: Vec<[f64; 2]> = facet.holes.iter().map(|hole| axes.map(|axis| hole[axis])).collect();
        let is_sound = rings.iter().all(|(_, ring)| repeated_vertex(ring).is_none());
        let Some(parents) = is_sound.then(|| parents(&rings, flat)).flatten() else {
            self.crossing.push(facet.line);
            facet.state_as_one();
            return;
        };
        // The innermost ring around each hole point loses what it encloses.
        let mut is_hole = vec![false; rings.len()];
        let mut is_odd = false;
        for &hole in &holes {
            let around = (0..rings.len()).filter(|&ring| side(hole, &rings[ring].1, flat) == Side::Inside);
            match around.max_by_key(|&ring| depth(&parents, ring)) {
                Some(ring) => {
                    is_hole[ring] = true;
                    is_odd |= parents[ring].is_none();
                }
                None => {
                    self.outside.push(facet.line);
                    is_odd = true;
                }
            }
        }
        is_odd &= area_count > 1;
        let all = is_odd.then(|| rings.iter().map(|own| own.1.clone()).collect::<Vec<_>>());
        let mut polygons = others;
        let mut surfaces: Vec<Vec<Vec<u32>>> =
            polygons.iter().map(|own: &Walk| vec![own.1.clone()]).collect();
        let mut is_divided = false;
        for ring in (0..rings.len()).filter(|&ring| !is_hole[ring]) {
            let inner: Vec<usize> = (0..rings.len()).filter(|&other| parents[other] == Some(ring)).collect();
            if inner.is_empty() {
                polygons.push(rings[ring].clone());
                surfaces.push(vec![rings[ring].1.clone()]);
                continue;
            }
            let line = rings[ring].0;
            let mut walks: Vec<Vec<u32>> = vec![rings[ring].1.clone()];
            walks.extend(inner.iter().map(|&inner| rings[inner].1.clone()));
            let stated = walks.clone();
            let Some(triangles) = triangulated(&mut walks, &point) else {
                self.crossing.push(facet.line);
                facet.state_as_one();
                return;
            };
            is_divided = true;
            surfaces.push(stated);
            surfaces.resize(polygons.len() + triangles.len(), Vec::new());
            polygons.extend(triangles.into_iter().map(|triangle| (line, triangle.to_vec())));
        }
        if is_divided {
            self.with_holes.push(facet.line);
        }
        facet.polygons = polygons;
        // Segments have no direction; and rings that touch others have no vertex there in files that are sound.
        let touches = (0..rings.len()).any(|one| {
            let mut others = (0..rings.len()).filter(|&other| other != one);
            let corners = || rings[one].1.iter();
            others.any(|other| corners().any(|&vertex| side(flat(vertex), &rings[other].1, flat) == Side::On))
        });
        if segment_count == 0 && !touches {
            facet.surfaces = surfaces;
        }
        if let (Some(all), 0) = (all, segment_count)
            && let Some(first) = facet.polygons.iter().position(|own| own.1.len() > 2)
        {
            facet.surfaces = vec![Vec::new(); facet.polygons.len()];
            facet.surfaces[first] = all;
        }
    }

    pub(crate) fn into_remarks(self) -> impl Iterator<Item = Remark> {
        let kinds = [
            (
                RemarkCode::FacesTriangulated,
                self.with_holes,
                ["facet has polygons inside of others", "facets have polygons inside of others"],
                "read as triangles",
            ),
            (
                RemarkCode::InputReading,
                self.crossing,
                [
                    "facet has polygons that cross or repeat vertices",
                    "facets have polygons that cross or repeat vertices",
                ],
                "each of these polygons is read as a face of its own, and holes are filled",
            ),
            (
                RemarkCode::InputReading,
                self.outside,
                ["point of a hole of a facet is", "points of holes of facets are"],
                "in none of its polygons: nothing is left out for it",
            ),
        ];
        kinds.into_iter().filter(|(_, lines, ..)| !lines.is_empty()).map(
            |(code, lines, [one, many], what)| {
                let count = lines.len();
                let between = if what.starts_with("in none") { " " } else { ": " };
                let message = format!("{count} {}{between}{what}", if count == 1 { one } else { many });
                Remark::new(code, message).at(count, lines.into_iter().map(Place::line))
            },
        )
    }
}

type Walk = (u64, Vec<u32>);

/// The closed polygons of a facet, among them those that segments make, and what else there is. Segments make rings where each vertex has two of them.
fn rings_of(polygons: &[Walk]) -> (Vec<Walk>, Vec<Walk>) {
    let (mut rings, mut others) = (Vec::new(), Vec::new());
    let mut neighbors: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for (line, polygon) in polygons {
        match polygon[..] {
            [a, b] if a != b => {
                neighbors.entry(a).or_default().push(b);
                neighbors.entry(b).or_default().push(a);
            }
            _ if polygon.len() > 2 => rings.push((*line, polygon.clone())),
            _ => others.push((*line, polygon.clone())),
        }
    }
    let mut rings_of_vertex: BTreeMap<u32, bool> = BTreeMap::new();
    for &start in neighbors.keys() {
        if rings_of_vertex.contains_key(&start) {
            continue;
        }
        // The segments that are connected with this vertex.
        let (mut connected, mut at) = (vec![start], 0);
        rings_of_vertex.insert(start, false);
        while let Some(vertex) = connected.get(at).copied() {
            at += 1;
            for &next in &neighbors[&vertex] {
                if rings_of_vertex.insert(next, false).is_none() {
                    connected.push(next);
                }
            }
        }
        let is_ring = connected.len() > 2
            && connected.iter().all(|vertex| matches!(neighbors[vertex][..], [a, b] if a != b));
        if !is_ring {
            continue;
        }
        let mut ring = vec![start];
        let (mut before, mut vertex) = (start, neighbors[&start][0]);
        while vertex != start {
            ring.push(vertex);
            let [a, b] = [0, 1].map(|i| neighbors[&vertex][i]);
            let next = if a == before { b } else { a };
            (before, vertex) = (vertex, next);
        }
        for vertex in &ring {
            rings_of_vertex.insert(*vertex, true);
        }
        let line = polygons.iter().find(|(_, polygon)| polygon.len() == 2 && polygon.contains(&start));
        rings.push((line.map_or(0, |(line, _)| *line), ring));
    }
    let is_loose = |(_, polygon): &&Walk| {
        polygon.len() == 2 && !rings_of_vertex.get(&polygon[0]).copied().unwrap_or(false)
    };
    let loose = polygons.iter().filter(is_loose).filter(|(_, polygon)| polygon[0] != polygon[1]);
    others.extend(loose.cloned());
    (rings, others)
}

/// The two axes along which the largest ring is seen best.
fn plane_axes(rings: &[Walk], point: impl Fn(u32) -> [f64; 3]) -> [usize; 2] {
    let mut normal = [0.0f64; 3];
    for (_, ring) in rings {
        for (axis, most) in normal.iter_mut().enumerate() {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            let origin = point(ring[0]);
            let relative = |vertex: u32| [point(vertex)[u] - origin[u], point(vertex)[v] - origin[v]];
            let next = ring.iter().skip(1).chain(ring.first());
            let sides = ring.iter().zip(next).map(|(&a, &b)| [relative(a), relative(b)]);
            *most = most.max(sides.map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum::<f64>().abs());
        }
    }
    let axis = (0..3).max_by(|&a, &b| normal[a].total_cmp(&normal[b])).unwrap_or(2);
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// Where a point is that is seen in the plane, exactly: by the sides that a ray to the right of it crosses.
fn side(at: [f64; 2], ring: &[u32], flat: impl Fn(u32) -> [f64; 2]) -> Side {
    let mut is_inside = false;
    for (i, &from) in ring.iter().enumerate() {
        let [a, b] = [from, ring[(i + 1) % ring.len()]].map(&flat);
        let turn = orientation(a, b, at);
        let is_within = |axis: usize| a[axis].min(b[axis]) <= at[axis] && at[axis] <= a[axis].max(b[axis]);
        if turn.is_eq() && is_within(0) && is_within(1) {
            return Side::On;
        }
        if (a[1] <= at[1]) != (b[1] <= at[1]) {
            let is_left = if a[1] < b[1] { turn == Ordering::Greater } else { turn == Ordering::Less };
            is_inside ^= is_left;
        }
    }
    if is_inside { Side::Inside } else { Side::Outside }
}

/// The innermost ring around each ring; `None` if rings cross, or two are one.
fn parents(rings: &[Walk], flat: impl Fn(u32) -> [f64; 2] + Copy) -> Option<Vec<Option<usize>>> {
    let count = rings.len();
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (inner, (_, ring)) in rings.iter().enumerate() {
        for (outer, (_, other)) in rings.iter().enumerate().filter(|&(outer, _)| outer != inner) {
            match side_of_ring(ring, other, flat)? {
                Side::Inside => around[inner].push(outer),
                // They are one.
                Side::On => return None,
                Side::Outside => {}
            }
        }
    }
    let depths: Vec<usize> = around.iter().map(Vec::len).collect();
    Some(around.iter().map(|around| around.iter().copied().max_by_key(|&ring| depths[ring])).collect())
}

/// Where a ring is that may touch the other; `None` if it has vertices on both sides.
fn side_of_ring(ring: &[u32], other: &[u32], flat: impl Fn(u32) -> [f64; 2] + Copy) -> Option<Side> {
    let middle = |i: usize| {
        let [a, b] = [flat(ring[i]), flat(ring[(i + 1) % ring.len()])];
        [f64::midpoint(a[0], b[0]), f64::midpoint(a[1], b[1])]
    };
    let is_corner = |vertex: u32| other.contains(&vertex);
    let corners =
        ring.iter().filter(|&&vertex| !is_corner(vertex)).map(|&vertex| side(flat(vertex), other, flat));
    // Where all corners are common, the middles of sides decide, which rounding cannot move across another ring.
    let shares_side = |i: usize| {
        let [a, b] = [ring[i], ring[(i + 1) % ring.len()]];
        (0..other.len()).any(|j| {
            let pair = [other[j], other[(j + 1) % other.len()]];
            pair == [a, b] || pair == [b, a]
        })
    };
    let middles = (0..ring.len()).filter(|&i| !shares_side(i)).map(|i| side(middle(i), other, flat));
    let mut found = Side::On;
    for side in corners.chain(middles).filter(|&side| side != Side::On) {
        if found != Side::On && found != side {
            return None;
        }
        found = side;
    }
    Some(found)
}

/// The number of rings around a ring.
fn depth(parents: &[Option<usize>], ring: usize) -> usize {
    std::iter::successors(parents[ring], |&ring| parents[ring]).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The vertices of a raster of 9 by 9 points in a plane that is not along the axes.
    fn raster(vertex: u32) -> [f64; 3] {
        let [x, y] = [f64::from(vertex % 9), f64::from(vertex / 9)];
        [x, y, x + 2.0 * y]
    }

    fn square(low: u32, size: u32) -> Vec<u32> {
        vec![low, low + size, low + 10 * size, low + 9 * size]
    }

    /// The area seen along the last axis, counting each point of the raster cells by the second method: the middles of cells.
    fn covered(facet: &Facet) -> (f64, usize) {
        let flat = |vertex: u32| [raster(vertex)[0], raster(vertex)[1]];
        let mut area = 0.0;
        for (_, polygon) in facet.polygons.iter().filter(|(_, polygon)| polygon.len() > 2) {
            let next = polygon.iter().skip(1).chain(polygon.first());
            let sides = polygon.iter().zip(next).map(|(&a, &b)| [flat(a), flat(b)]);
            area += 0.5 * sides.map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum::<f64>().abs();
        }
        let cells = (0..64).filter(|cell| {
            let at = [f64::from(cell % 8) + 0.5, f64::from(cell / 8) + 0.25];
            let is_in = |(_, polygon): &&(u64, Vec<u32>)| {
                polygon.len() > 2 && side(at, polygon, flat) == Side::Inside
            };
            facet.polygons.iter().filter(is_in).count() == 1
        });
        (area, cells.count())
    }

    fn divided(polygons: &[Vec<u32>], holes: &[[f64; 2]]) -> (Facet, Facets) {
        let mut facet = Facet {
            line: 7,
            polygons: polygons.iter().map(|polygon| (8, polygon.clone())).collect(),
            holes: holes.iter().map(|&[x, y]| [x, y, x + 2.0 * y]).collect(),
            surfaces: Vec::new(),
        };
        let mut facets = Facets::default();
        facets.divide(&mut facet, raster);
        (facet, facets)
    }

    #[test]
    fn holes_and_rings_inside_of_others_divide_a_facet() {
        let (outer, inner, island) = (square(0, 8), square(20, 4), square(30, 2));
        let cells = |polygons: &[Vec<u32>], holes: &[[f64; 2]]| covered(&divided(polygons, holes).0);
        assert_eq!(cells(std::slice::from_ref(&outer), &[]), (64.0, 64));
        assert_eq!(cells(&[outer.clone(), inner.clone()], &[[2.5, 2.5]]), (48.0, 48));
        assert_eq!(
            cells(&[inner.clone(), outer.clone()], &[]),
            (64.0, 64),
            "a ring divides and leaves nothing out"
        );
        assert_eq!(cells(&[outer.clone(), inner.clone(), island.clone()], &[[2.5, 2.5]]), (52.0, 52));
        assert_eq!(cells(&[outer.clone(), inner, island], &[[4.0, 4.0]]), (60.0, 60));
        // A ring of segments, in any order, and a loose one.
        let segments: Vec<Vec<u32>> =
            [[20, 24], [60, 56], [24, 60], [20, 56], [0, 10]].map(Vec::from).to_vec();
        let mut all = vec![outer.clone()];
        all.extend(segments);
        let (facet, facets) = divided(&all, &[[3.0, 3.0]]);
        assert_eq!(covered(&facet), (48.0, 48));
        assert_eq!(facet.polygons.iter().filter(|(_, polygon)| polygon.len() == 2).count(), 1);
        assert_eq!(facets.with_holes, [7]);
        // Rings that touch the outer one, at a corner, along a side, and at a corner in the middle of a side.
        for touching in [square(0, 3), square(3, 3), vec![4, 23, 21]] {
            let area = covered(&divided(std::slice::from_ref(&touching), &[]).0).0;
            let at = raster(touching[0]);
            let next = raster(touching[2]);
            let hole = [0.9 * at[0] + 0.1 * next[0] + 0.01, 0.9 * at[1] + 0.1 * next[1] + 0.1];
            let (facet, facets) = divided(&[outer.clone(), touching], &[hole]);
            assert!(facets.crossing.is_empty() && facets.outside.is_empty(), "{facets:?}");
            assert_eq!(covered(&facet).0, 64.0 - area);
        }
        // Polygons side by side stay as they are.
        let (facet, facets) = divided(&[square(0, 4), square(4, 4)], &[]);
        assert_eq!((facet.polygons.len(), facets.into_remarks().count()), (2, 0));
    }

    #[test]
    fn what_cannot_be_divided_is_said() {
        let (facet, facets) = divided(&[square(0, 5), square(30, 5)], &[[4.0, 4.0]]);
        assert_eq!((facet.polygons.len(), &facets.crossing[..]), (2, &[7][..]));
        let (facet, facets) = divided(&[square(0, 3)], &[[5.0, 5.0]]);
        assert_eq!((facet.polygons.len(), &facets.outside[..]), (1, &[7][..]));
        let remark = facets.into_remarks().next().unwrap();
        assert_eq!(
            remark.message,
            "1 point of a hole of a facet is in none of its polygons: nothing is left out for it"
        );
        let (facet, _) = divided(&[square(0, 3), square(0, 3)], &[]);
        assert_eq!(facet.polygons.len(), 2);
        // The hole point of the only polygon leaves nothing.
        assert!(divided(&[square(0, 3)], &[[1.0, 1.5]]).0.polygons.is_empty());
    }
}
