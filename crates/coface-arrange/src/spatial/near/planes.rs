//! Planes that are near each other over the extent of their polygons become one.

use crate::near::{compare, minus, plus, squared};
use crate::spatial::SpatialPolygons;
use coface_algebra::RaggedArray;
use coface_geometry::{AxisBox, BoxTree, cross, dot};
use rayon::prelude::*;

/// A plane by a point of it and a unit normal.
#[derive(Clone, Copy)]
struct Plane {
    point: [f64; 3],
    normal: [f64; 3],
}

impl Plane {
    fn distance(&self, point: [f64; 3]) -> f64 {
        dot(self.normal, minus(point, self.point))
    }
}

/// A polygon: twice the area along the normal, the middle of its corners, and the box around it.
struct Extent {
    area: [f64; 3],
    middle: [f64; 3],
    frame: AxisBox,
}

/// Planes less than this part of the tolerance away from a vertex leave it where it is.
const IDLE_PART: f64 = 1.0 / 1024.0;
/// Two planes whose normals have this sine or less between them do not say where a vertex is along their line.
const LEAST_SINE: f64 = 0.05;

/// The points of polygons when planes that are near each other are replaced by one that fits them, and the number of
/// polygons with such a plane.
///
/// A plane is taken up by that of a larger polygon when all corners are at most half the tolerance away from it, and
/// the polygons come as near to each other without having a corner in common: so a bent surface is not made flat. Each
/// point goes to the planes of its polygons, those of the largest area first, and stays if that is further than the
/// tolerance.
pub(in crate::spatial) fn flattened(polygons: &SpatialPolygons, tolerance: f64) -> (Vec<[f64; 3]>, usize) {
    let points = polygons.positions().as_flat().as_chunks::<3>().0;
    let walks_of_polygon =
        RaggedArray::grouped(polygons.polygon_count(), polygons.polygon_of_walk().iter().copied());
    let walks = |polygon: u32| {
        walks_of_polygon.list(polygon as usize).iter().map(|&walk| polygons.walks().list(walk as usize))
    };
    let corners = |polygon: u32| walks(polygon).flatten().copied();
    let count = polygons.polygon_count() as u32;
    let extents: Vec<Extent> =
        (0..count).into_par_iter().map(|polygon| extent(points, walks(polygon), tolerance)).collect();
    let mut own_planes: Vec<Option<Plane>> = extents
        .iter()
        .map(|extent| {
            let length = squared(extent.area).sqrt();
            // Lower than the tolerance: the plane of a sliver says nothing.
            let width = extent.frame.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
            (length > 2.0 * tolerance * width)
                .then(|| Plane { point: extent.middle, normal: extent.area.map(|x| x / length) })
        })
        .collect();
    let tree = BoxTree::new(&extents.iter().map(|extent| extent.frame).collect::<Vec<_>>());
    let mut order: Vec<u32> = (0..count).filter(|&polygon| own_planes[polygon as usize].is_some()).collect();
    order.sort_by(|&x, &y| {
        let [x, y] = [x, y].map(|polygon| &extents[polygon as usize]);
        squared(y.area).total_cmp(&squared(x.area)).then_with(|| compare(x.middle, y.middle))
    });
    let mut rank = vec![0u32; count as usize];
    (0..).zip(&order).for_each(|(place, &polygon)| rank[polygon as usize] = place);
    let share_corner = |x: u32, y: u32| corners(x).any(|own| corners(y).any(|other| own == other));
    let mut is_taken = vec![false; count as usize];
    let mut fitted = 0;
    for seed in order {
        if std::mem::replace(&mut is_taken[seed as usize], true) {
            continue;
        }
        let plane = own_planes[seed as usize].expect("polygons in order have planes");
        let is_near = |polygon: u32, plane: &Plane, most: f64| {
            corners(polygon).all(|corner| plane.distance(points[corner as usize]).abs() <= most)
        };
        let mut members = vec![seed];
        let mut next = 0;
        while next < members.len() {
            let member = members[next];
            next += 1;
            let mut found = Vec::new();
            tree.visit(&extents[member as usize].frame, |other| found.push(other));
            found.sort_unstable_by_key(|&other| rank[other as usize]);
            for other in found {
                if !is_taken[other as usize]
                    && own_planes[other as usize].is_some()
                    && is_near(other, &plane, tolerance / 2.0)
                    && !share_corner(member, other)
                {
                    is_taken[other as usize] = true;
                    members.push(other);
                }
            }
        }
        if members.len() == 1 {
            continue;
        }
        fitted += members.len();
        members.sort_unstable_by_key(|&own| rank[own as usize]);
        let common = fit(&members, &extents, plane.normal);
        let kept = if members.iter().all(|&own| is_near(own, &common, tolerance)) { common } else { plane };
        members.iter().for_each(|&own| own_planes[own as usize] = Some(kept));
    }
    if fitted == 0 {
        return (points.to_vec(), 0);
    }
    let mut planes_of_point: Vec<Vec<(f64, Plane)>> = vec![Vec::new(); points.len()];
    for polygon in 0..count {
        if let Some(plane) = own_planes[polygon as usize] {
            let area = squared(extents[polygon as usize].area);
            corners(polygon).for_each(|corner| planes_of_point[corner as usize].push((area, plane)));
        }
    }
    let moved = points.par_iter().zip(planes_of_point).map(|(&point, mut planes)| {
        planes.sort_by(|(x, p), (y, q)| y.total_cmp(x).then_with(|| compare(p.point, q.point)));
        onto(point, planes.into_iter().map(|(_, plane)| plane), tolerance)
    });
    (moved.collect(), fitted)
}

fn extent<'a>(points: &[[f64; 3]], walks: impl Iterator<Item = &'a [u32]>, margin: f64) -> Extent {
    let (mut area, mut middle, mut count) = ([0.0; 3], [0.0; 3], 0.0);
    let mut frame = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    let mut origin = None;
    for walk in walks {
        for (&a, &b) in walk.iter().zip(walk.iter().cycle().skip(1)) {
            let (a, b) = (points[a as usize], points[b as usize]);
            let origin = *origin.get_or_insert(a);
            area = plus(area, 1.0, cross(minus(a, origin), minus(b, origin)));
            middle = plus(middle, 1.0, minus(a, origin));
            count += 1.0;
            for (frame, x) in frame.iter_mut().zip(a) {
                *frame = [frame[0].min(x - margin / 2.0), frame[1].max(x + margin / 2.0)];
            }
        }
    }
    Extent { area, middle: plus(origin.unwrap_or_default(), 1.0 / f64::max(count, 1.0), middle), frame }
}

/// The plane through the middle of polygons, both it and the normal by area.
fn fit(members: &[u32], extents: &[Extent], normal: [f64; 3]) -> Plane {
    let origin = extents[members[0] as usize].middle;
    let (mut sum, mut middle, mut weight) = ([0.0; 3], [0.0; 3], 0.0);
    for &member in members {
        let extent = &extents[member as usize];
        let along = dot(extent.area, normal);
        sum = plus(sum, along.signum(), extent.area);
        middle = plus(middle, along.abs(), minus(extent.middle, origin));
        weight += along.abs();
    }
    let length = squared(sum).sqrt();
    Plane { point: plus(origin, 1.0 / weight, middle), normal: sum.map(|x| x / length) }
}

/// The point nearest to one that is on these planes, the first ones first.
fn onto(point: [f64; 3], planes: impl Iterator<Item = Plane>, tolerance: f64) -> [f64; 3] {
    let mut directions: Vec<[f64; 3]> = Vec::with_capacity(3);
    let (mut moved, mut is_off) = (point, false);
    for plane in planes {
        let free = directions.iter().fold(plane.normal, |own, &taken| plus(own, -dot(own, taken), taken));
        let length = squared(free).sqrt();
        if length < LEAST_SINE {
            continue;
        }
        is_off |= plane.distance(point).abs() > IDLE_PART * tolerance;
        let unit = free.map(|x| x / length);
        moved = plus(moved, -plane.distance(moved) / dot(unit, plane.normal), unit);
        directions.push(unit);
    }
    if is_off && squared(minus(moved, point)) <= tolerance * tolerance { moved } else { point }
}
