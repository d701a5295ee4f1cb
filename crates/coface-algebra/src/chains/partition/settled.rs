//! Classes that are settled before the root: they are counted, and their cells left out.

use super::merging::check_strata;
use super::owners::Parts;
use super::part::{Part, ReducedPart, StratumHash};
use super::tree::reduced_with_hashes;
use crate::Error;
use crate::chains::{ChainComplex, WideComplex};
use crate::ids::narrow;
use crate::integers::Integer;
use crate::matrices::{Entry, SparseVector, WideMatrix, combination};
use crate::progress;
use rayon::prelude::*;

/// The reduction of a complex in parts, and the classes that were counted on the way to it.
///
/// A [`PartTree`](super::PartTree) holds what is left of the parts on all levels, to take cycles of the root down. Where groups alone are asked for, a critical
/// cell inside of one part that bounds nothing and whose boundary is zero, perhaps after others of that kind are added to it, is a free class of the whole: it is
/// counted and forgotten, and parts are forgotten once they are merged.
///
/// The homology of the whole is that of [`Self::root`] plus a free group of rank [`Self::settled`] in each degree.
///
/// # Why it is correct
/// A cell inside of a part is a face of no cell of another part, so that its coboundary is known there. Where the coboundaries of some cells are zero, adding them to
/// each other changes no other boundary. A cell whose boundary and coboundary are zero is a direct summand of the complex.
///
/// # Examples
/// A circle of six edges in three parts:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_algebra::chains::{Partition, SettledParts, TwoSkeleton};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ends = (0..6).flat_map(|i| [i, (i + 1) % 6]).collect();
/// let circle = TwoSkeleton::new(6, ends, RaggedArray::new())?.chain_complex()?;
/// let found = SettledParts::new(&Partition::by_walk(&circle, 3)?, 2)?;
/// assert_eq!((found.root().cell_count(1), found.settled()), (0, &[1, 1][..]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SettledParts {
    root: WideComplex,
    settled: Vec<usize>,
}

impl SettledParts {
    /// Reduces and merges; part p goes to part p / `fan_in` of the next level.
    ///
    /// # Errors
    /// Those of [`PartTree::new`](super::PartTree::new).
    ///
    /// # Complexity
    /// That of [`PartTree::new`](super::PartTree::new) in time; beside one part for each thread, only what is shared by parts, and what does not settle, is held.
    ///
    /// # Examples
    /// See [`SettledParts`].
    pub fn new<P: Parts>(parts: &P, fan_in: u32) -> Result<Self, Error> {
        if fan_in < 2 {
            return Err(Error::invalid(format!("parts cannot be merged by groups of {fan_in}"))
                .with_cure("take a fan-in of 2 or more"));
        }
        let steps = progress::stage("reducing parts", parts.part_count() as usize);
        let reduced = (0..parts.part_count()).into_par_iter().map(|number| {
            let part = parts.part(number)?;
            let left = Left::of(&part)?;
            steps.advance(1);
            Ok(left)
        });
        let mut level = reduced.collect::<Result<Vec<Left>, Error>>()?;
        drop(steps);
        let mut settled = Vec::new();
        loop {
            check_strata(level.iter().map(|left| (left.part.number(), &left.strata[..])))?;
            level.iter().for_each(|left| add(&mut settled, &left.settled));
            if matches!(&level[..], [root] if !root.part.has_units() || root.is_stuck) {
                let root = level.pop().expect("there is one part").part.into_complex();
                settled.resize(settled.len().max(root.degree_count()), 0);
                return Ok(Self { root, settled });
            }
            let _steps = progress::stage("merging parts", level.len());
            let mut rest = level.into_iter();
            let mut groups: Vec<(u32, Vec<Left>)> = Vec::new();
            while rest.len() > 0 {
                groups.push((narrow(groups.len()), rest.by_ref().take(fan_in as usize).collect()));
            }
            level = groups
                .into_par_iter()
                .map(|(number, children)| Left::merged(number, children, fan_in))
                .collect::<Result<_, Error>>()?;
        }
    }

    /// What is left of the whole.
    ///
    /// # Examples
    /// See [`SettledParts`].
    pub fn root(&self) -> &WideComplex {
        &self.root
    }

    /// The numbers of free classes of each degree that were counted.
    ///
    /// # Examples
    /// See [`SettledParts`].
    pub fn settled(&self) -> &[usize] {
        &self.settled
    }
}

fn add(total: &mut Vec<usize>, counts: &[usize]) {
    total.resize(total.len().max(counts.len()), 0);
    total.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
}

/// What is left of a part.
struct Left {
    part: ReducedPart,
    strata: Vec<StratumHash>,
    /// The classes that were counted when it was made.
    settled: Vec<usize>,
    /// Whether it was made of one part, in which nothing canceled.
    is_stuck: bool,
}

impl Left {
    fn of<E: Entry>(part: &Part<E>) -> Result<Self, Error> {
        let (left, strata) = reduced_with_hashes(part);
        let is_stuck = left.complex().f_vector() == part.complex().f_vector();
        let (part, settled) = without_settled(left)?;
        Ok(Self { part, strata, settled, is_stuck })
    }

    fn merged(number: u32, children: Vec<Self>, fan_in: u32) -> Result<Self, Error> {
        let is_alone = children.len() == 1;
        let parts: Vec<ReducedPart> = children.into_iter().map(|child| child.part).collect();
        let merged = ReducedPart::merged(number, &parts, |part| part / fan_in)?;
        drop(parts);
        let left = Self::of(&merged)?;
        Ok(Self { is_stuck: is_alone && left.is_stuck, ..left })
    }
}

/// The part without the classes that are settled, and how many those are in each degree.
fn without_settled(part: ReducedPart) -> Result<(ReducedPart, Vec<usize>), Error> {
    let complex = part.complex();
    let keys = part.held_keys();
    let is_inside: Vec<bool> = keys.sets.iter().map(|set| set.len() == 1).collect();
    let degrees = 0..complex.degree_count();
    let kept: Vec<Vec<u32>> = degrees
        .clone()
        .map(|degree| {
            let mut is_free: Vec<bool> =
                keys.of_cell[degree].iter().map(|&key| is_inside[key as usize]).collect();
            if let Some(above) = complex.boundary_matrix(degree + 1) {
                above.rows().iter().for_each(|&face| is_free[face as usize] = false);
            }
            unsettled(complex, degree, &is_free)
        })
        .collect();
    let settled: Vec<usize> =
        degrees.clone().map(|degree| complex.cell_count(degree) - kept[degree].len()).collect();
    if settled.iter().all(|&count| count == 0) {
        return Ok((part, settled));
    }
    let mut matrices = Vec::new();
    for degree in degrees.clone().skip(1) {
        let Some(matrix) = complex.boundary_matrix(degree) else { continue };
        // Faces of the cells that are kept are kept: those that settle are faces of none.
        let mut places = vec![0; complex.cell_count(degree - 1)];
        (0..).zip(&kept[degree - 1]).for_each(|(place, &face)| places[face as usize] = place);
        let (mut starts, mut rows, mut entries) = (vec![0], Vec::new(), Vec::new());
        for &cell in &kept[degree] {
            let column = matrix.column(cell as usize);
            rows.extend(column.rows().iter().map(|&face| places[face as usize]));
            entries.extend_from_slice(column.entries());
            starts.push(narrow(rows.len()));
        }
        matrices.push(WideMatrix::checked(kept[degree - 1].len(), starts, rows, entries)?);
    }
    let ids = degrees.map(|degree| {
        let ids = part.ids(degree);
        kept[degree].iter().map(|&cell| ids[cell as usize]).collect()
    });
    let mut ids: Vec<Vec<u64>> = ids.collect();
    let mut kept_keys = keys.renamed(kept.iter().map(Vec::as_slice), |part| part);
    let complex = ChainComplex::from_trusted(kept.first().map_or(0, Vec::len), matrices);
    // Without any point no degree is left of points.
    ids.truncate(complex.degree_count());
    kept_keys.of_cell.truncate(complex.degree_count());
    Ok((Part::from_trusted(part.number(), complex, ids, kept_keys), settled))
}

/// The cells of a degree that do not settle, when those that are free to be added to each other are known.
///
/// A column is reduced by those before it, at unit entries alone, as far as it stays short: a few steps are enough for most, and no column costs much.
fn unsettled(complex: &WideComplex, degree: usize, is_free: &[bool]) -> Vec<u32> {
    const MOST_STEPS: usize = 64;
    const MOST_ENTRIES: usize = 64;
    let Some(matrix) = complex.boundary_matrix(degree) else {
        return (0..narrow(is_free.len())).filter(|&cell| !is_free[cell as usize]).collect();
    };
    // For each face the column whose last entry is there, a unit.
    let mut ending: Vec<Option<Box<SparseVector>>> = Vec::new();
    ending.resize_with(matrix.row_count(), || None);
    let mut kept = Vec::new();
    for (cell, column) in (0..).zip(matrix.columns()) {
        if !is_free[cell as usize] {
            kept.push(cell);
            continue;
        }
        let mut column: SparseVector =
            column.terms().map(|(face, entry)| (narrow(face), entry.clone())).collect();
        let mut steps = 0;
        while let Some((face, entry)) = column.last()
            && steps < MOST_STEPS
            && column.len() <= MOST_ENTRIES
        {
            let Some(other) = &ending[*face as usize] else { break };
            let (_, unit) = &other[other.len() - 1];
            // A unit is its own inverse.
            let factor = -(entry * unit);
            column = combination(&Integer::ONE, &column, &factor, other);
            steps += 1;
        }
        match column.last() {
            None => continue,
            Some((face, entry)) => {
                let (place, is_unit) = (*face as usize, entry.is_unit());
                if is_unit && ending[place].is_none() && column.len() <= MOST_ENTRIES {
                    ending[place] = Some(Box::new(column));
                }
            }
        }
        kept.push(cell);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chains::Partition;
    use crate::matrices::SparseMatrix;

    /// A path of three edges whose owners are all that they can be: one component is left, wherever it is found.
    #[test]
    fn a_path_in_parts_has_one_component() {
        let entries = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (2, 2, -1), (3, 2, 1)];
        let edges = SparseMatrix::from_entries(4, 3, entries).expect("the places are there");
        let path = ChainComplex::new(vec![edges]).expect("edges have two ends");
        for owners in (0..125).map(|number| [number % 5, number / 5 % 5, number / 25]) {
            let partition = Partition::new(&path, 5, |_, edge| owners[edge as usize]).expect("five parts");
            for fan_in in 2..6 {
                let found = SettledParts::new(&partition, fan_in).expect("parts agree");
                assert_eq!((found.settled(), found.root().f_vector()), (&[1, 0][..], &[0, 0][..]));
            }
        }
    }

    #[test]
    fn points_settle_at_once() {
        let points = ChainComplex::of_points(3);
        let partition = Partition::new(&points, 2, |_, point| point % 2).expect("two parts");
        let found = SettledParts::new(&partition, 2).expect("parts agree");
        assert_eq!((found.settled(), found.root().degree_count()), (&[3][..], 0));
        assert!(SettledParts::new(&partition, 1).is_err());
    }
}
