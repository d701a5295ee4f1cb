//! Arrangements of the rims of regions: how often each region winds around each face.

use super::PlanarArrangement;
use super::faces::NONE;
use crate::algebra::RaggedArray;
use crate::geometry::Positions;
use crate::{Error, ErrorKind, FaceId};

/// The arrangement of closed rings, with the winding number of every region around every face.
///
/// # Examples
/// Two squares that overlap in a quarter: inclusion and exclusion.
/// ```
/// use coface::algebra::RaggedArray;
/// use coface::arrangement::planar::PlanarRegions;
/// use coface::geometry::Positions;
/// # fn main() -> Result<(), coface::Error> {
/// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
/// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [7, 6, 5, 4]]);
/// let regions = PlanarRegions::new(&points, &rings, &[0, 1])?;
/// let both = regions.faces_where(|winding| winding.len() == 2);
/// assert_eq!(both.len(), 1);
/// // The second square runs clockwise: it winds minus once around what is in it.
/// assert_eq!(regions.winding_numbers(both[0]), [(0, 1), (1, -1)]);
/// let areas = regions.arrangement().areas();
/// assert_eq!((areas[both[0].index()], areas.iter().sum()), (1.0, 7.0));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct PlanarRegions {
    arrangement: PlanarArrangement,
    region_count: usize,
    /// For each face the regions with a winding number that is not zero, rising.
    windings: Vec<(u32, i32)>,
    starts: Vec<u32>,
}

impl PlanarRegions {
    /// The arrangement of rings. Each ring runs through its points and back to the first; `regions[i]` is the region that
    /// ring i belongs to. A ring winds once around what it has on its left: outer rings run counterclockwise, holes clockwise,
    /// or the parity of the winding number tells what is inside.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one region for each ring; else as [`PlanarArrangement::new`].
    ///
    /// # Complexity
    /// That of the arrangement, and linear in the lengths of the lists of winding numbers.
    pub fn new(positions: &Positions, rings: &RaggedArray, regions: &[u32]) -> Result<Self, Error> {
        if rings.len() != regions.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} regions are named for {} rings", regions.len(), rings.len()),
            )
            .with_cure("name the region of each ring"));
        }
        let mut sides = Vec::with_capacity(rings.item_count());
        let mut region_of_side = Vec::with_capacity(rings.item_count());
        for (ring, &region) in rings.iter().zip(regions) {
            for (i, &from) in ring.iter().enumerate() {
                sides.push([from, ring[(i + 1) % ring.len()]]);
                region_of_side.push(region);
            }
        }
        let arrangement = PlanarArrangement::new(positions, &sides)?;
        // What is left of an edge winds this much more than what is right of it.
        let step = |halfedge: u32| {
            let sign = if halfedge.is_multiple_of(2) { 1 } else { -1 };
            let segments = arrangement.segments_of_edge.list(halfedge as usize / 2);
            let mut step: Vec<(u32, i32)> = segments
                .iter()
                .map(|&side| {
                    let [a, b] =
                        sides[side as usize].map(|point| arrangement.vertex_of_point[point as usize]);
                    (region_of_side[side as usize], if a < b { sign } else { -sign })
                })
                .collect();
            step.sort_unstable();
            step
        };
        let face_count = arrangement.face_count();
        let mut windings: Vec<Option<Vec<(u32, i32)>>> = vec![None; face_count];
        let mut queue = vec![None];
        while let Some(face) = queue.pop() {
            let here =
                face.map_or(&[][..], |f: FaceId| windings[f.index()].as_deref().unwrap_or(&[])).to_vec();
            for &halfedge in arrangement.walks(face).flatten() {
                let across =
                    arrangement.faces.of_orbit[arrangement.orbits.orbit_of[(halfedge ^ 1) as usize] as usize];
                if across != NONE && windings[across as usize].is_none() {
                    windings[across as usize] = Some(sum(&here, &step(halfedge ^ 1)));
                    queue.push(Some(FaceId::from_u32(across)));
                }
            }
        }
        let mut starts = vec![0u32];
        let mut flat = Vec::new();
        for winding in windings {
            flat.extend(winding.expect("faces are connected across edges"));
            let end = u32::try_from(flat.len())
                .map_err(|_| Error::new(ErrorKind::TooLarge, "more than 2^32 winding numbers"))?;
            starts.push(end);
        }
        let region_count = regions.iter().max().map_or(0, |&last| last as usize + 1);
        Ok(Self { arrangement, region_count, windings: flat, starts })
    }

    /// The arrangement of all sides of all rings, one segment a side, ring after ring.
    pub fn arrangement(&self) -> &PlanarArrangement {
        &self.arrangement
    }

    /// One more than the highest region that a ring belongs to.
    pub fn region_count(&self) -> usize {
        self.region_count
    }

    /// The regions that wind around a face, rising, each with its winding number, which is not zero.
    ///
    /// # Panics
    /// If there is no such face.
    pub fn winding_numbers(&self, face: FaceId) -> &[(u32, i32)] {
        &self.windings[self.starts[face.index()] as usize..self.starts[face.index() + 1] as usize]
    }

    /// The bounded faces whose winding numbers satisfy a condition: any Boolean formula of the regions.
    pub fn faces_where(&self, mut condition: impl FnMut(&[(u32, i32)]) -> bool) -> Vec<FaceId> {
        let faces = (0..self.arrangement.face_count()).map(FaceId::new);
        faces.filter(|&face| condition(self.winding_numbers(face))).collect()
    }
}

/// The sum of two lists that rise by region; the second may have regions more than once. Zeros are left out.
fn sum(a: &[(u32, i32)], b: &[(u32, i32)]) -> Vec<(u32, i32)> {
    let mut merged: Vec<(u32, i32)> = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        let from_a = j == b.len() || (i < a.len() && a[i].0 <= b[j].0);
        let (region, winding) = if from_a { a[i] } else { b[j] };
        if from_a {
            i += 1;
        } else {
            j += 1;
        }
        match merged.last_mut() {
            Some(last) if last.0 == region => last.1 += winding,
            _ => merged.push((region, winding)),
        }
    }
    merged.retain(|&(_, winding)| winding != 0);
    merged
}
