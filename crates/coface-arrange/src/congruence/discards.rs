//! Cells that are removed because too few facets of them remain.

use super::CellClasses;
use super::classes::NONE;
use coface_algebra::Error;
use coface_algebra::SparseMatrix;

/// Why a cell has no class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Discard {
    /// Its boundary vanished.
    Collapsed,
    /// Fewer facets were left than a cell of its degree has: two for an edge, three for a face, four for a solid.
    TooFewFacets,
}

/// Removes classes with too few facets, from the highest degree down, and returns their cells.
///
/// A class goes when all its members lost facets, none of them in pieces, and no class above has it in its boundary:
/// otherwise the boundary of that one would be no cycle.
pub(super) fn discard(
    boundaries: &mut [SparseMatrix],
    classes: &mut [CellClasses],
    changed: &[Vec<u32>],
) -> Result<Vec<Vec<u32>>, Error> {
    let mut discarded = vec![Vec::new(); classes.len()];
    for degree in (1..classes.len()).rev() {
        let has_lost = |cell: u32| changed[degree].binary_search(&cell).is_ok();
        let is_split = |cell: u32| classes[degree].split_cells().binary_search(&cell).is_ok();
        let mut is_gone: Vec<bool> = boundaries[degree - 1]
            .columns()
            .zip(classes[degree].members().iter())
            .map(|(column, members)| {
                (1..=degree).contains(&column.rows().len())
                    && members.iter().all(|&cell| has_lost(cell) && !is_split(cell))
            })
            .collect();
        if let Some(above) = boundaries.get(degree) {
            above.rows().iter().for_each(|&row| is_gone[row as usize] = false);
        }
        if !is_gone.contains(&true) {
            continue;
        }
        let members = classes[degree].members();
        let of_gone =
            (0..is_gone.len()).filter(|&class| is_gone[class]).flat_map(|class| members.list(class));
        discarded[degree] = of_gone.copied().collect();
        discarded[degree].sort_unstable();
        let mut count = 0;
        let numbers: Vec<u32> = is_gone
            .iter()
            .map(|&is_gone| {
                count += u32::from(!is_gone);
                if is_gone { NONE } else { count - 1 }
            })
            .collect();
        classes[degree] = classes[degree].renumbered(&numbers);
        let below = &boundaries[degree - 1];
        let kept =
            (0..below.column_count()).filter(|&class| !is_gone[class]).map(|class| below.column(class));
        let (mut starts, mut rows, mut entries) = (vec![0], Vec::new(), Vec::new());
        for column in kept {
            rows.extend_from_slice(column.rows());
            entries.extend_from_slice(column.entries());
            starts.push(rows.len() as u32);
        }
        boundaries[degree - 1] = SparseMatrix::from_parts(below.row_count(), starts, rows, entries)?;
        if let Some(above) = boundaries.get_mut(degree) {
            let rows = above.rows().iter().map(|&row| numbers[row as usize]).collect();
            *above = SparseMatrix::from_parts(
                count as usize,
                above.column_starts().to_vec(),
                rows,
                above.entries().to_vec(),
            )?;
        }
    }
    Ok(discarded)
}
