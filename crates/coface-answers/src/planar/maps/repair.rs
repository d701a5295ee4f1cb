//! Polygons made valid.

use super::super::boolean::{BooleanRequest, RegionBoolean};
use super::super::drawing::Filling;
use super::layer::{Corners, Point, Rings, drawing_of};
use super::linework::by_linework;
use super::task::RepairMethod;
use coface_algebra::{Error, FaceId, RaggedArray, VertexId};
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_arrange::planar::{PlanarArrangement, PolygonFault, polygon_faults};
use coface_geometry::Positions;
use coface_geometry::predicates::orientation;

/// The polygons of a geometry, valid.
#[derive(Clone, Debug, Default)]
pub(super) struct Repaired {
    pub(super) polygons: Vec<Rings>,
    /// What was wrong, by the rings of all polygons one after the other.
    pub(super) faults: Vec<PolygonFault>,
    /// The polygon and the ring of it that each ring of the input is.
    pub(super) rings: Vec<(usize, usize)>,
    /// The area of the valid polygons, where something was wrong.
    pub(super) area: Option<f64>,
    /// The area of what is inside now and was not, or the other way around.
    pub(super) changed: f64,
    /// How many rings were reversed, of polygons that were valid.
    pub(super) turned: usize,
    /// How far vertices moved for the sake of rounding.
    pub(super) largest_movement: f64,
}

/// Makes the polygons of one geometry valid. Valid ones keep their coordinates; outer rings then run counterclockwise, holes clockwise.
pub(super) fn repaired(polygons: &[Rings], method: RepairMethod) -> Result<Repaired, Error> {
    let (faults, rings) = faults_of(polygons)?;
    let mut done = Repaired { rings, ..Repaired::default() };
    if faults.is_empty() {
        done.polygons = polygons.to_vec();
        for rings in &mut done.polygons {
            for (i, ring) in rings.iter_mut().enumerate() {
                if runs_clockwise(ring) == (i == 0) {
                    ring[1..].reverse();
                    done.turned += 1;
                }
            }
        }
        return Ok(done);
    }
    let result = match method {
        RepairMethod::Linework => by_linework(polygons)?,
        RepairMethod::Structure => union_of(&with_outer_holes(polygons)?, Filling::OuterWithoutHoles)?,
    };
    done.area = Some(result.area());
    done.largest_movement = result.movement().map_or(0.0, |movement| movement.largest);
    done.polygons = polygons_of(&result)?;
    let both =
        [(polygons, Filling::Stated(InsideRule::Odd)), (&done.polygons[..], Filling::OuterWithoutHoles)];
    let changed = RegionBoolean::new(drawing_of(both)?, &BooleanFormula::xor(2), &BooleanRequest::default())?;
    done.changed = changed.area();
    done.faults = faults;
    Ok(done)
}

/// Whether a simple ring runs clockwise: it turns so at its lowest corner.
pub(super) fn runs_clockwise(ring: &Corners) -> bool {
    let key = |&i: &usize| (ring[i][0] + 0.0, ring[i][1] + 0.0);
    let lowest =
        (0..ring.len()).min_by(|a, b| key(a).partial_cmp(&key(b)).unwrap_or(std::cmp::Ordering::Equal));
    let Some(lowest) = lowest else { return false };
    let corner = |i: usize| [ring[i % ring.len()][0], ring[i % ring.len()][1]];
    orientation(corner(lowest + ring.len() - 1), corner(lowest), corner(lowest + 1)).is_lt()
}

/// The union of polygons.
pub(super) fn union_of(polygons: &[Rings], filling: Filling) -> Result<RegionBoolean, Error> {
    RegionBoolean::new(
        drawing_of([(polygons, filling)])?,
        &BooleanFormula::union(1),
        &BooleanRequest::default(),
    )
}

/// The polygons of a result, with heights where the input has some.
pub(super) fn polygons_of(result: &RegionBoolean) -> Result<Vec<Rings>, Error> {
    let positions = result.lifted_positions()?;
    let point = |&vertex: &u32| -> Point {
        let point = positions.point(VertexId::from_u32(vertex));
        [point[0], point[1], point.get(2).copied().unwrap_or(f64::NAN)]
    };
    let ring = |ring: &[u32]| -> Corners { ring.iter().map(point).collect() };
    let polygons = 0..result.f_vector()[2];
    Ok(polygons.map(|polygon| result.rings_of_polygon(FaceId::new(polygon)).map(ring).collect()).collect())
}

/// A ring by its polygon, and by its place in it: 0 is the outer ring.
pub(super) type RingName = (usize, usize);

/// What is wrong with polygons, by their rings one after the other; and which ring each of these is.
pub(super) fn faults_of(polygons: &[Rings]) -> Result<(Vec<PolygonFault>, Vec<RingName>), Error> {
    let (mut flat, mut rings, mut lists) = (Vec::new(), RaggedArray::new(), RaggedArray::new());
    let mut names = Vec::new();
    for (number, polygon) in polygons.iter().enumerate() {
        let first = rings.len() as u32;
        for (i, ring) in polygon.iter().enumerate() {
            let start = flat.len() as u32 / 2;
            flat.extend(ring.iter().flat_map(|corner| [corner[0], corner[1]]));
            rings.push(&(start..start + ring.len() as u32).collect::<Vec<u32>>());
            names.push((number, i));
        }
        lists.push(&(first..rings.len() as u32).collect::<Vec<u32>>());
    }
    Ok((polygon_faults(&Positions::from_flat(2, flat)?, &rings, &lists)?, names))
}

/// The same polygons, but for holes that do not touch their outer rings and are outside of them: these are polygons.
fn with_outer_holes(polygons: &[Rings]) -> Result<Vec<Rings>, Error> {
    let mut found: Vec<Rings> = Vec::with_capacity(polygons.len());
    let mut outside: Vec<Rings> = Vec::new();
    for rings in polygons {
        let Some((outer, holes)) = rings.split_first() else { continue };
        let mut kept = vec![outer.clone()];
        for hole in holes {
            if do_meet(outer, hole)? {
                kept.push(hole.clone());
            } else {
                outside.push(vec![hole.clone()]);
            }
        }
        found.push(kept);
    }
    found.append(&mut outside);
    Ok(found)
}

/// Whether a ring winds around a point, or has it on a side, by the sides to the right of it.
fn winds_around(ring: &Corners, [x, y]: [f64; 2]) -> bool {
    let mut winding = 0;
    for (from, to) in ring.iter().zip(ring.iter().cycle().skip(1)) {
        let [from, to] = [from, to].map(|corner| [corner[0], corner[1]]);
        let turn = orientation(from, to, [x, y]);
        let is_beside =
            |axis: usize, at: f64| from[axis].min(to[axis]) <= at && at <= from[axis].max(to[axis]);
        if turn.is_eq() && is_beside(0, x) && is_beside(1, y) {
            return true;
        }
        match (from[1] <= y, to[1] <= y) {
            (true, false) if turn.is_gt() => winding += 1,
            (false, true) if turn.is_lt() => winding -= 1,
            _ => {}
        }
    }
    winding != 0
}

/// Whether what two rings wind around has a point in common.
fn do_meet(a: &Corners, b: &Corners) -> Result<bool, Error> {
    if a.is_empty() || b.is_empty() {
        return Ok(false);
    }
    let range = |ring: &Corners, axis: usize| {
        ring.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], corner| {
            [low.min(corner[axis]), high.max(corner[axis])]
        })
    };
    for axis in 0..2 {
        let [own, other] = [range(a, axis), range(b, axis)];
        if own[1] < other[0] || other[1] < own[0] {
            return Ok(false);
        }
    }
    if winds_around(a, [b[0][0], b[0][1]]) || winds_around(b, [a[0][0], a[0][1]]) {
        return Ok(true);
    }
    let rings = [a.clone(), b.clone()];
    let (mut flat, mut segments) = (Vec::new(), Vec::new());
    for ring in &rings {
        let first = flat.len() as u32 / 2;
        let count = ring.len() as u32;
        flat.extend(ring.iter().flat_map(|corner| [corner[0], corner[1]]));
        segments.extend((0..count).map(|i| [first + i, first + (i + 1) % count]));
    }
    let arrangement = PlanarArrangement::new(&Positions::from_flat(2, flat)?, &segments)?;
    // Lines that meet are one component; others that are not in each other have nothing in common.
    Ok(arrangement.component_count() < 2)
}
