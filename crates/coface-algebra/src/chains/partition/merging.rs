//! Merges parts into larger parts.

use super::keys::{Keys, Sets};
use super::part::{Part, ReducedPart, StratumHash};
use crate::Error;
use crate::chains::ChainComplex;
use crate::ids::narrow;
use crate::matrices::{SparseVector, WideMatrix};

impl ReducedPart {
    /// The part of this number that these parts make together; `parent` says for each part of the whole to which it
    /// goes, and these are all that go to `number`.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](crate::ErrorKind::InvalidInput) naming a cell that two of the parts have with
    /// different keys or boundaries: they do not belong to one whole; and for a part that does not go to `number`.
    ///
    /// # Complexity
    /// $O(m \log m)$ for m entries.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, ReducedPart, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
    /// let partition = Partition::new(&path, 2, |_, edge| edge)?;
    /// let parts = [partition.part(0)?.reduced(), partition.part(1)?.reduced()];
    /// // Of both parts the shared vertex is left.
    /// assert_eq!(ReducedPart::merged(0, &parts, |_| 0)?.complex().f_vector()[0], 1);
    /// # Ok(()) }
    /// ```
    pub fn merged<'p>(
        number: u32,
        parts: impl IntoIterator<Item = &'p ReducedPart>,
        parent: impl Fn(u32) -> u32,
    ) -> Result<Self, Error> {
        let parts: Vec<&ReducedPart> = parts.into_iter().collect();
        if let Some(part) = parts.iter().find(|part| parent(part.number()) != number) {
            return Err(Error::invalid(format!("part {} does not go to part {number}", part.number())));
        }
        let degree_count = parts.iter().map(|part| part.complex().degree_count()).max().unwrap_or(0);
        let ids: Vec<Vec<u64>> = (0..degree_count)
            .map(|degree| {
                let mut ids: Vec<u64> = parts.iter().flat_map(|part| part.ids(degree)).copied().collect();
                ids.sort_unstable();
                ids.dedup();
                ids
            })
            .collect();
        // Where the cells of each part are among all.
        let places: Vec<Vec<Vec<u32>>> = parts
            .iter()
            .map(|part| (0..degree_count).map(|degree| places(&ids[degree], part.ids(degree))).collect())
            .collect();
        let keys = joined_keys(number, &parts, &places, &ids, parent)?;
        let mut matrices = Vec::new();
        for degree in 1..degree_count {
            let mut columns: Vec<Option<SparseVector>> = vec![None; ids[degree].len()];
            for (part, places) in parts.iter().zip(&places) {
                let Some(matrix) = part.complex().boundary_matrix(degree) else { continue };
                for (column, &place) in matrix.columns().zip(&places[degree]) {
                    let column: SparseVector =
                        column.terms().map(|(row, x)| (places[degree - 1][row], x.clone())).collect();
                    let known = &mut columns[place as usize];
                    if known.as_ref().is_some_and(|known| *known != column) {
                        let cell = ids[degree][place as usize];
                        return Err(disagreement(&format!("the boundary of cell {cell} of degree {degree}")));
                    }
                    known.get_or_insert(column);
                }
            }
            let columns = columns.into_iter().map(Option::unwrap_or_default);
            matrices.push(WideMatrix::from_integer_columns(ids[degree - 1].len(), columns)?);
        }
        let complex = ChainComplex::of_wide(ids.first().map_or(0, Vec::len), matrices)?;
        Ok(Part::from_trusted(number, complex, ids, keys))
    }
}

fn disagreement(what: &str) -> Error {
    Error::invalid(format!("parts disagree on {what}"))
        .with_cure("reduce all parts of one complex again, by the same version of the program")
}

/// The places of the second list in the first; both rise, and the first has all of the second.
fn places(all: &[u64], some: &[u64]) -> Vec<u32> {
    let mut at = 0;
    let place = |&id: &u64| {
        at += all[at..].partition_point(|&other| other < id);
        narrow(at)
    };
    some.iter().map(place).collect()
}

fn joined_keys(
    number: u32,
    parts: &[&ReducedPart],
    places: &[Vec<Vec<u32>>],
    ids: &[Vec<u64>],
    parent: impl Fn(u32) -> u32,
) -> Result<Keys, Error> {
    const NONE: u32 = u32::MAX;
    // First as they were, so that parts are seen to agree on them; then with the parents.
    let mut before = Sets::default();
    let mut after = Sets::default();
    let mut parents = Vec::new();
    let mut of_cell: Vec<Vec<u32>> = ids.iter().map(|ids| vec![NONE; ids.len()]).collect();
    for (part, places) in parts.iter().zip(places) {
        let keys = part.held_keys();
        let numbers: Vec<u32> = keys
            .sets
            .iter()
            .map(|set| {
                let set_number = before.number(set.to_vec());
                if set_number as usize == parents.len() {
                    let mut renamed: Vec<u32> = set.iter().map(|&part| parent(part)).collect();
                    renamed.sort_unstable();
                    renamed.dedup();
                    parents.push(after.number(renamed));
                }
                set_number
            })
            .collect();
        for (degree, of_part) in keys.of_cell.iter().enumerate() {
            for (&key, &place) in of_part.iter().zip(&places[degree]) {
                let known = &mut of_cell[degree][place as usize];
                if *known != NONE && *known != numbers[key as usize] {
                    let cell = ids[degree][place as usize];
                    return Err(disagreement(&format!("which parts have cell {cell} of degree {degree}")));
                }
                *known = numbers[key as usize];
            }
        }
    }
    of_cell.iter_mut().flatten().for_each(|key| *key = parents[*key as usize]);
    let keys = after.into_keys(of_cell);
    debug_assert!(
        keys.sets.iter().all(|set| set.binary_search(&number).is_ok()),
        "each cell is of one of the parts"
    );
    Ok(keys)
}

/// Compares what parts found in their common strata.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](crate::ErrorKind::InvalidInput) naming two parts and the stratum on which they do not
/// agree.
pub(super) fn check_strata<'h>(
    hashes: impl IntoIterator<Item = (u32, &'h [StratumHash])>,
) -> Result<(), Error> {
    let mut all: Vec<(&[u32], u64, u32)> = hashes
        .into_iter()
        .flat_map(|(part, strata)| strata.iter().map(move |stratum| (&stratum.key[..], stratum.hash, part)))
        .collect();
    all.sort_unstable_by(|a, b| (a.0, a.2).cmp(&(b.0, b.2)));
    match all.windows(2).find(|pair| pair[0].0 == pair[1].0 && pair[0].1 != pair[1].1) {
        Some(pair) => Err(disagreement(&format!(
            "what cancels in the stratum of parts {:?}: parts {} and {} found different pairs",
            pair[0].0, pair[0].2, pair[1].2
        ))),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ErrorKind;

    #[test]
    fn strata_that_differ_are_named() {
        let stratum = |hash| [StratumHash { key: vec![2, 5], hash }];
        assert_eq!(check_strata([(2, &stratum(7)[..]), (5, &stratum(7)[..])]), Ok(()));
        let error = check_strata([(2, &stratum(7)[..]), (5, &stratum(8)[..])]).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::InvalidInput);
        assert!(error.message().contains("parts 2 and 5"), "{error}");
    }
}
