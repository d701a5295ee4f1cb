//! How shells that touch each other lie: by the cells that they cut space into.

use super::rings::Points;
use crate::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
use coface_algebra::{CellId, Error, RaggedArray};
use coface_geometry::Positions;

/// The cells that some shells cut space into, each by the shells that it is inside of, rising, by their positions in
/// the list.
#[derive(Debug)]
pub(super) struct TouchingShells {
    pub(super) cells: Vec<Vec<u32>>,
    /// The cells in each shell, rising.
    cells_of_shell: Vec<Vec<u32>>,
}

/// The arrangement of closed shells, each as triangles that run coherently and an input of its own.
///
/// # Errors
/// Those of an arrangement.
pub(super) fn arranged_shells(
    points: &Points<'_>,
    shells: &[Vec<[u32; 3]>],
) -> Result<SpatialArrangement, Error> {
    let mut places: Vec<u32> = shells.iter().flatten().flatten().copied().collect();
    places.sort_unstable();
    places.dedup();
    let flat = places.iter().flat_map(|&place| points.point(place)).collect();
    let number = |place| places.binary_search(&place).expect("each place is listed") as u32;
    let triangles = shells.iter().flatten().map(|corners| corners.map(number));
    let inputs = shells.iter().zip(0..).flat_map(|(shell, input)| shell.iter().map(move |_| input)).collect();
    let polygons =
        SpatialPolygons::from_polygons(Positions::from_flat(3, flat)?, RaggedArray::from_lists(triangles))?;
    SpatialArrangement::new(&polygons.with_inputs(inputs)?, &SpatialOptions::new())
}

impl TouchingShells {
    /// Of closed shells, each as triangles that run coherently.
    ///
    /// # Errors
    /// Those of an arrangement.
    pub(super) fn new(points: &Points<'_>, shells: &[Vec<[u32; 3]>]) -> Result<Self, Error> {
        let arrangement = arranged_shells(points, shells)?;
        let windings = arrangement.winding_numbers()?;
        let inside = |cell: usize| -> Vec<u32> {
            let numbers = windings.around(CellId::new(cell)).iter();
            numbers.filter(|(_, winding)| winding % 2 != 0).map(|&(shell, _)| shell).collect()
        };
        let cells: Vec<Vec<u32>> = (0..windings.cell_count()).map(inside).collect();
        let mut cells_of_shell = vec![Vec::new(); shells.len()];
        for (cell, number) in cells.iter().zip(0..) {
            cell.iter().for_each(|&shell| cells_of_shell[shell as usize].push(number));
        }
        Ok(Self { cells, cells_of_shell })
    }

    /// Whether there are cells in both shells, in the first alone, and in the second alone.
    pub(super) fn relation(&self, first: u32, second: u32) -> [bool; 3] {
        let [first, second] = [first, second].map(|shell| &self.cells_of_shell[shell as usize]);
        let both = first.iter().filter(|cell| second.binary_search(cell).is_ok()).count();
        [both > 0, first.len() > both, second.len() > both]
    }
}
