//! A tree of merged parts; cycles of the root as cycles on the cells of the complex.

use super::lifting::{ChainById, sum_of_chains};
use super::merging::check_strata;
use super::owners::Parts;
use super::part::{Part, ReducedPart, StratumHash};
use crate::Error;
use crate::ids::narrow;
use crate::matrices::{Entry, SparseVector};
use crate::progress;
use rayon::prelude::*;

/// All parts of a complex reduced, merged by groups of neighbors, reduced again, and so on until one is left.
///
/// # Complexity
/// That of reducing the parts, which is done in parallel, and beyond that of the critical cells of strata: as many as
/// there are strata where these are balls.
///
/// # Examples
/// A circle of six edges in three parts:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_algebra::chains::{PartTree, Partition, TwoSkeleton};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ends = (0..6).flat_map(|i| [i, (i + 1) % 6]).collect();
/// let circle = TwoSkeleton::new(6, ends, RaggedArray::new())?.chain_complex()?;
/// let partition = Partition::by_walk(&circle, 3)?;
/// let tree = PartTree::new(&partition, 2)?;
/// assert_eq!(tree.root().complex().f_vector(), [1, 1]);
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct PartTree<'p, P> {
    parts: &'p P,
    /// What is left of the parts on each level, from the leaves on; the last level has one part.
    levels: Vec<Vec<ReducedPart>>,
    fan_in: u32,
}

impl<'p, P: Parts> PartTree<'p, P> {
    /// Reduces and merges; part p goes to part p / `fan_in` of the next level.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](crate::ErrorKind::InvalidInput) for a fan-in below 2; those of [`Parts::part`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, PartTree, Partition};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(4);
    /// let partition = Partition::by_walk(&points, 4)?;
    /// assert!(PartTree::new(&partition, 2).is_ok() && PartTree::new(&partition, 1).is_err());
    /// # Ok(()) }
    /// ```
    pub fn new(parts: &'p P, fan_in: u32) -> Result<Self, Error> {
        if fan_in < 2 {
            return Err(Error::invalid(format!("parts cannot be merged by groups of {fan_in}"))
                .with_cure("take a fan-in of 2 or more"));
        }
        let steps = progress::stage("reducing parts", parts.part_count() as usize);
        let reduced = (0..parts.part_count()).into_par_iter().map(|number| {
            let reduced = reduced_with_hashes(&parts.part(number)?);
            steps.advance(1);
            Ok(reduced)
        });
        let mut reduced = reduced.collect::<Result<Vec<(ReducedPart, Vec<StratumHash>)>, Error>>()?;
        drop(steps);
        let mut levels: Vec<Vec<ReducedPart>> = Vec::new();
        loop {
            check_strata(reduced.iter().map(|(part, strata)| (part.number(), &strata[..])))?;
            levels.push(reduced.into_iter().map(|(part, _)| part).collect());
            if is_done(&levels) {
                return Ok(Self { parts, levels, fan_in });
            }
            let level = &levels[levels.len() - 1];
            let _steps = progress::stage("merging parts", level.len());
            reduced = level
                .par_chunks(fan_in as usize)
                .enumerate()
                .map(|(number, parts)| {
                    let merged = ReducedPart::merged(narrow(number), parts, |part| part / fan_in)?;
                    Ok(reduced_with_hashes(&merged))
                })
                .collect::<Result<_, Error>>()?;
        }
    }

    /// The parts that were reduced.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, PartTree, Partition, Parts};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(4);
    /// let partition = Partition::by_walk(&points, 4)?;
    /// assert_eq!(PartTree::new(&partition, 2)?.parts().part_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn parts(&self) -> &'p P {
        self.parts
    }

    /// The reduction of the whole.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, PartTree, Partition};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(4);
    /// let partition = Partition::by_walk(&points, 4)?;
    /// assert_eq!(PartTree::new(&partition, 2)?.root().ids(0), [0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn root(&self) -> &ReducedPart {
        self.levels.last().and_then(|level| level.first()).expect("the last level has one part")
    }

    /// The numbers of critical cells of each level, for each degree: those of all its parts, each cell counted once.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, PartTree, Partition};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(4);
    /// let partition = Partition::by_walk(&points, 4)?;
    /// // Four parts, then two, then one: no point ever cancels.
    /// assert_eq!(PartTree::new(&partition, 2)?.critical_counts(), [[4], [4], [4]]);
    /// # Ok(()) }
    /// ```
    pub fn critical_counts(&self) -> Vec<Vec<usize>> {
        self.levels.iter().map(|level| sums(level.iter().map(Part::own_counts))).collect()
    }

    /// Chains on the cells of the root as chains on the cells of the complex, by rising ids. Cycles go to cycles.
    ///
    /// # Errors
    /// Those of [`Parts::part`].
    ///
    /// # Complexity
    /// Matchings are made once more for the parts that a chain meets.
    ///
    /// # Panics
    /// If a cell is not below the count of cells of the root.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{PartTree, Partition, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ends = (0..6).flat_map(|i| [i, (i + 1) % 6]).collect();
    /// let circle = TwoSkeleton::new(6, ends, RaggedArray::new())?.chain_complex()?;
    /// let partition = Partition::by_walk(&circle, 3)?;
    /// let tree = PartTree::new(&partition, 2)?;
    /// // The edge of the root stands for all six edges.
    /// assert_eq!(tree.inclusions(1, &[vec![(0, 1.into())]])?[0].len(), 6);
    /// # Ok(()) }
    /// ```
    pub fn inclusions(&self, degree: usize, chains: &[SparseVector]) -> Result<Vec<ChainById>, Error> {
        let root_ids = self.root().ids(degree);
        let mut chains: Vec<ChainById> = chains
            .iter()
            .map(|chain| chain.iter().map(|(cell, x)| (root_ids[*cell as usize], x.clone())).collect())
            .collect();
        for below in (0..self.levels.len()).rev() {
            let lifted: Vec<Vec<ChainById>> = self.levels[below]
                .par_iter()
                .map(|left| {
                    let number = left.number();
                    if !has_own_terms(left, degree, &chains) {
                        return Ok(vec![Vec::new(); chains.len()]);
                    }
                    match below.checked_sub(1) {
                        None => self.parts.part(number)?.lifted(degree, &chains),
                        Some(level) => {
                            let children =
                                self.levels[level].chunks(self.fan_in as usize).nth(number as usize);
                            let merged = ReducedPart::merged(number, children.unwrap_or_default(), |part| {
                                part / self.fan_in
                            });
                            merged?.lifted(degree, &chains)
                        }
                    }
                })
                .collect::<Result<_, Error>>()?;
            chains =
                (0..chains.len()).map(|i| sum_of_chains(lifted.iter().map(|part| part[i].clone()))).collect();
        }
        Ok(chains)
    }
}

/// Whether one part is left in which nothing more cancels: a part alone is merged with nothing and reduced once more
/// until then.
fn is_done(levels: &[Vec<ReducedPart>]) -> bool {
    match levels {
        [.., before, last] if last.len() == 1 && before.len() == 1 => {
            before[0].complex().f_vector() == last[0].complex().f_vector() || !last[0].has_units()
        }
        [.., last] => matches!(&last[..], [root] if !root.has_units()),
        [] => false,
    }
}

/// Whether chains have a term on a cell of which the part is the first to have it.
fn has_own_terms(part: &ReducedPart, degree: usize, chains: &[ChainById]) -> bool {
    let ids = part.ids(degree);
    let is_own =
        |id: &u64| ids.binary_search(id).is_ok_and(|cell| part.key(degree, cell)[0] == part.number());
    chains.iter().flatten().any(|(id, _)| is_own(id))
}

pub(super) fn reduced_with_hashes<E: Entry>(part: &Part<E>) -> (ReducedPart, Vec<StratumHash>) {
    let matching = part.matching();
    let strata = part.stratum_hashes(&matching);
    (part.reduced_by(matching), strata)
}

fn sums(lists: impl Iterator<Item = Vec<usize>>) -> Vec<usize> {
    lists.fold(Vec::new(), |mut total, list| {
        total.resize(total.len().max(list.len()), 0);
        total.iter_mut().zip(list).for_each(|(sum, x)| *sum += x);
        total
    })
}
