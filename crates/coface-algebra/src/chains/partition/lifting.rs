//! Chains on the critical cells of a part as chains on its cells.

use super::part::Part;
use crate::Error;
use crate::ids::narrow;
use crate::integers::Integer;
use crate::matrices::{Entry, SparseVector};

/// A chain as cells by their ids, rising, with coefficients.
pub type ChainById = Vec<(u64, Integer)>;

impl<E: Entry> Part<E> {
    /// Chains on critical cells of all parts, given by ids, as chains on the cells of this part; only terms on its own
    /// critical cells count. The sum of the results of all parts are the chains on the cells of the whole; see
    /// [`sum_of_chains`].
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](crate::ErrorKind::InvalidInput) for a cell that is the part's own, but not critical
    /// in it.
    ///
    /// # Complexity
    /// One matching of the part, and the inclusion of the chains; only a search if no cell is the part's own.
    ///
    /// # Examples
    /// The circle of four edges in two parts, as for [`Part`]: the cycle at the root has four edges.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, ReducedPart, TwoSkeleton, sum_of_chains};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = TwoSkeleton::new(4, vec![0, 1, 1, 2, 2, 3, 3, 0], RaggedArray::new())?.chain_complex()?;
    /// let partition = Partition::new(&circle, 2, |_, edge| u32::from(edge >= 2))?;
    /// let parts = [partition.part(0)?, partition.part(1)?];
    /// let merged = ReducedPart::merged(0, &parts.each_ref().map(|part| part.reduced()), |_| 0)?;
    /// let cycle = vec![(merged.reduced().ids(1)[0], 1.into())];
    /// let between = sum_of_chains(merged.lifted(1, &[cycle])?);
    /// let [left, right] = parts.each_ref().map(|part| part.lifted(1, std::slice::from_ref(&between)));
    /// assert_eq!(sum_of_chains(left?.into_iter().chain(right?)).len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn lifted(&self, degree: usize, chains: &[ChainById]) -> Result<Vec<ChainById>, Error> {
        let ids = self.ids(degree);
        let is_own = |&(id, _): &&(u64, Integer)| {
            ids.binary_search(id).is_ok_and(|cell| self.key(degree, cell)[0] == self.number())
        };
        if !chains.iter().flatten().any(|term| is_own(&term)) {
            return Ok(vec![Vec::new(); chains.len()]);
        }
        let matching = self.matching();
        let critical = matching.critical_cells(degree);
        let own = chains.iter().map(|chain| {
            let terms = chain.iter().filter(is_own).map(|(id, x)| {
                let place = critical.binary_search_by_key(id, |&cell| ids[cell as usize]);
                place.map(|place| (narrow(place), x.clone())).map_err(|_| {
                    Error::invalid(format!(
                        "cell {id} of degree {degree} is not critical in part {}",
                        self.number()
                    ))
                    .with_cure("take chains down to the parts that they came from")
                })
            });
            terms.collect()
        });
        let own = own.collect::<Result<Vec<SparseVector>, Error>>()?;
        let images = self.inclusions(&matching, degree, own.iter().map(Vec::as_slice));
        let by_id =
            |image: SparseVector| image.into_iter().map(|(cell, x)| (ids[cell as usize], x)).collect();
        Ok(images.into_iter().map(by_id).collect())
    }
}

/// The sum of chains by ids.
///
/// # Complexity
/// One sort.
///
/// # Examples
/// ```
/// use coface_algebra::chains::sum_of_chains;
/// assert_eq!(sum_of_chains([vec![(7, 1.into())], vec![(3, 2.into()), (7, (-1).into())]]), [(3, 2.into())]);
/// ```
pub fn sum_of_chains(chains: impl IntoIterator<Item = ChainById>) -> ChainById {
    let mut terms: ChainById = chains.into_iter().flatten().collect();
    terms.sort_by_key(|&(id, _)| id);
    let mut sum: ChainById = Vec::with_capacity(terms.len());
    for (id, x) in terms {
        match sum.last_mut() {
            Some((last, total)) if *last == id => *total += &x,
            _ => sum.push((id, x)),
        }
    }
    sum.retain(|(_, x)| !x.is_zero());
    sum
}
