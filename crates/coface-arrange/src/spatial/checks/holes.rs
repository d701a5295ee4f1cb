//! How the rings of a face lie to each other.

use super::FaultCode;
use super::rings::Points;
use crate::planar::PlanarRegions;
use coface_algebra::{Error, FaceId, RaggedArray};
use coface_geometry::Positions;

/// What is wrong between rings.
#[derive(Debug)]
pub(super) struct HoleFaults {
    /// What is wrong, and the two rings; for what is wrong with one, it stands twice.
    pub(super) faults: Vec<(FaultCode, [usize; 2])>,
}

/// How two rings lie to each other, by the parts that the plane is cut into.
struct Relation {
    both: bool,
    first_only: bool,
    second_only: bool,
    share_a_side: bool,
}

impl HoleFaults {
    /// Of rings, each of which is simple, seen along an axis. The first is the outer ring.
    ///
    /// The rings are arranged exactly: each part of the plane is inside of some of them.
    pub(super) fn of(points: &Points<'_>, axis: usize, rings: &[Vec<u32>]) -> Result<Self, Error> {
        let mut flat = Vec::new();
        let mut lists = RaggedArray::new();
        for ring in rings {
            let start = flat.len() as u32 / 2;
            for &place in ring {
                let point = points.point(place);
                flat.extend([point[(axis + 1) % 3], point[(axis + 2) % 3]]);
            }
            lists.push(&(start..start + ring.len() as u32).collect::<Vec<u32>>());
        }
        let numbers: Vec<u32> = (0..rings.len() as u32).collect();
        let regions = PlanarRegions::new(&Positions::from_flat(2, flat)?, &lists, &numbers)?;
        let inside: Vec<Vec<u32>> = (0..regions.arrangement().face_count())
            .map(|face| {
                let windings = regions.winding_numbers(FaceId::new(face));
                windings.iter().filter(|(_, winding)| winding % 2 != 0).map(|&(ring, _)| ring).collect()
            })
            .collect();
        let ring_of_side: Vec<u32> =
            rings.iter().zip(0..).flat_map(|(ring, number)| ring.iter().map(move |_| number)).collect();
        let mut shared: Vec<[u32; 2]> = Vec::new();
        for sides in regions.arrangement().segments_of_edges().iter() {
            let mut own: Vec<u32> = sides.iter().map(|&side| ring_of_side[side as usize]).collect();
            own.sort_unstable();
            own.dedup();
            shared.extend(
                (1..own.len()).flat_map(|j| (0..j).map(move |i| [i, j])).map(|pair| pair.map(|i| own[i])),
            );
        }
        let relation = |first: usize, second: usize| {
            let has = |face: &Vec<u32>, ring: usize| face.contains(&(ring as u32));
            Relation {
                both: inside.iter().any(|face| has(face, first) && has(face, second)),
                first_only: inside.iter().any(|face| has(face, first) && !has(face, second)),
                second_only: inside.iter().any(|face| !has(face, first) && has(face, second)),
                share_a_side: shared.contains(&[first as u32, second as u32]),
            }
        };
        let mut faults = Vec::new();
        for second in 1..rings.len() {
            for first in 0..second {
                let relation = relation(first, second);
                let code = match relation {
                    Relation { first_only: false, second_only: false, .. } => FaultCode::DuplicateRings,
                    Relation { share_a_side: true, .. } => FaultCode::RingsIntersect,
                    Relation { both: true, second_only: false, .. } if first == 0 => continue,
                    Relation { both: false, .. } if first == 0 => FaultCode::HoleOutside,
                    Relation { both: false, .. } => continue,
                    Relation { first_only: true, second_only: true, .. } => FaultCode::RingsIntersect,
                    _ if first == 0 => FaultCode::RingsIntersect,
                    _ => FaultCode::HolesNested,
                };
                faults.push((code, [first, second]));
            }
        }
        if faults.is_empty() && inside.iter().filter(|face| face[..] == [0]).count() > 1 {
            faults.push((FaultCode::FaceDisconnected, [0, 0]));
        }
        Ok(Self { faults })
    }
}
