//! Solids of one composite: they may touch, have no inside in common, and are connected through faces.

use super::faults::Collector;
use super::rings::Points;
use super::touching_shells::arranged_shells;
use super::{CheckedFaces, CheckedPrimitive, FaultCode, FaultPlace, FaultScope};
use coface_algebra::{CellId, Error, UnionFind};

/// A composite of more triangles than this is not arranged.
const MOST_TRIANGLES: usize = 200_000;

/// The numbers of the shells of each solid of each composite, the outer one first, rising by composites.
fn composites(faces: &CheckedFaces) -> Vec<Vec<Vec<u32>>> {
    let mut shells: Vec<(u32, u32, u32)> = Vec::new();
    for (shell, &solid) in (0..).zip(faces.solid_of_shell()) {
        if let CheckedPrimitive::CompositeSolid(composite) = faces.primitive(solid) {
            shells.push((composite, solid, shell));
        }
    }
    shells.sort_unstable();
    let of_solid = |own: &[(u32, u32, u32)]| own.iter().map(|&(_, _, shell)| shell).collect();
    let by_solid = |own: &[(u32, u32, u32)]| own.chunk_by(|a, b| a.1 == b.1).map(of_solid).collect();
    shells.chunk_by(|a, b| a.0 == b.0).map(by_solid).collect()
}

/// Examines how solids of each composite lie to each other, those whose shells are sound; the number of shells that were too
/// many to be arranged. `triangles` are those of a shell, running coherently.
pub(super) fn examine(
    points: &Points<'_>,
    faces: &CheckedFaces,
    is_sound: impl Fn(u32) -> bool,
    triangles: impl Fn(u32) -> Vec<[u32; 3]>,
    place: impl Fn(&[u32]) -> FaultPlace,
    faults: &mut Collector,
) -> usize {
    let mut left_out = 0;
    for solids in composites(faces) {
        let sound: Vec<&Vec<u32>> =
            solids.iter().filter(|shells| shells.iter().all(|&shell| is_sound(shell))).collect();
        if sound.len() < 2 {
            continue;
        }
        let shells: Vec<Vec<[u32; 3]>> =
            sound.iter().flat_map(|own| own.iter().map(|&shell| triangles(shell))).collect();
        let solid_of_shell: Vec<u32> =
            (0..).zip(&sound).flat_map(|(solid, own)| own.iter().map(move |_| solid)).collect();
        let found = if shells.iter().map(Vec::len).sum::<usize>() > MOST_TRIANGLES {
            None
        } else {
            SolidsOfComposite::new(points, &shells, &solid_of_shell, sound.len()).ok()
        };
        let Some(found) = found else {
            left_out += shells.len();
            continue;
        };
        let outer = |solid: u32| sound[solid as usize][0];
        for [a, b] in found.overlapping {
            let is_same = found.cells_of_solid[a as usize] == found.cells_of_solid[b as usize];
            let code = if is_same { FaultCode::DuplicateSolids } else { FaultCode::SolidsOverlap };
            faults.add_with(code, FaultScope::Solid, || place(&[outer(a), outer(b)]));
        }
        // Where solids were left out, others may be connected by them.
        if sound.len() == solids.len() {
            for &solid in &found.apart {
                faults.add_with(FaultCode::SolidsDisconnected, FaultScope::Solid, || place(&[outer(solid)]));
            }
        }
    }
    left_out
}

/// How solids lie to each other, by the cells that their shells cut space into.
struct SolidsOfComposite {
    /// The cells inside of each solid, rising.
    cells_of_solid: Vec<Vec<u32>>,
    /// The pairs of solids with a common cell, rising.
    overlapping: Vec<[u32; 2]>,
    /// The first solid of each connected part but that of the first solid; solids are connected through a common face or cell.
    apart: Vec<u32>,
}

impl SolidsOfComposite {
    fn new(
        points: &Points<'_>,
        shells: &[Vec<[u32; 3]>],
        solid_of_shell: &[u32],
        solid_count: usize,
    ) -> Result<Self, Error> {
        let arrangement = arranged_shells(points, shells)?;
        let windings = arrangement.winding_numbers()?;
        let solids_of_cell = |cell: usize| -> Vec<u32> {
            let around = windings.around(CellId::new(cell)).iter().filter(|(_, winding)| winding % 2 != 0);
            let mut solids: Vec<u32> = around.map(|&(shell, _)| solid_of_shell[shell as usize]).collect();
            solids.sort_unstable();
            // Inside of a void of a solid is outside of the solid.
            let runs = solids.chunk_by(|a, b| a == b).filter(|own| own.len() % 2 == 1);
            runs.map(|own| own[0]).collect()
        };
        let solids_of_cell: Vec<Vec<u32>> = (0..windings.cell_count()).map(solids_of_cell).collect();
        let mut cells_of_solid = vec![Vec::new(); solid_count];
        let mut overlapping = Vec::new();
        let mut parts = UnionFind::new(solid_count);
        for (cell, solids) in (0..).zip(&solids_of_cell) {
            for (at, &solid) in solids.iter().enumerate() {
                cells_of_solid[solid as usize].push(cell);
                overlapping.extend(solids[..at].iter().map(|&other| [other, solid]));
            }
        }
        overlapping.sort_unstable();
        overlapping.dedup();
        for &[a, b] in &overlapping {
            parts.unite(a, b);
        }
        let complex = arrangement.coarse_complex()?;
        let mut cells_of_face = vec![Vec::new(); complex.cell_count(2)];
        if let Some(boundaries) = complex.boundary_matrix(3) {
            for (cell, column) in boundaries.columns().enumerate() {
                column.rows().iter().for_each(|&face| cells_of_face[face as usize].push(cell));
            }
        }
        for cells in cells_of_face {
            let mut solids = cells.iter().flat_map(|&cell| &solids_of_cell[cell]);
            if let Some(&first) = solids.next() {
                for &other in solids {
                    parts.unite(first, other);
                }
            }
        }
        let mut is_seen = vec![false; solid_count];
        let is_first = |&solid: &u32| !std::mem::replace(&mut is_seen[parts.find(solid) as usize], true);
        let apart = (0..solid_count as u32).filter(is_first).skip(1).collect();
        Ok(Self { cells_of_solid, overlapping, apart })
    }
}
