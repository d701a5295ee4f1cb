//! Orientation of gluing tables.

use crate::coherence::{Coherence, OddCycle};
use crate::gluing::table::GluingTable;
use coface_algebra::{CellId, Sign};
use std::collections::VecDeque;

/// Whether the simplices of a gluing table can be oriented so that all gluings reverse the orientation of facets.
///
/// The sign minus stands for the simplices whose vertex order 0, 1, ... is to be taken with an odd permutation; the first
/// simplex of each component has plus. A simplex of an odd cycle stands with its own facet over which the next is reached.
pub type GluingOrientation = Coherence<CellId, GluedFacet>;

/// A facet of one simplex of a gluing table.
///
/// # Examples
/// ```
/// use coface_algebra::CellId;
/// use coface_complexes::gluing::{GluedFacet, GluingTable};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mut band = GluingTable::unglued(2, 1)?;
/// band.glue(0, 2, 0, &[1, 2, 0])?;
/// assert_eq!(band.orientation().conflicts(), [GluedFacet { simplex: CellId::new(0), opposite: 0 }]);
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct GluedFacet {
    /// The simplex.
    pub simplex: CellId,
    /// The number of the vertex of the simplex that is opposite to the facet.
    pub opposite: usize,
}

impl GluingTable {
    /// An orientation of all simplices, or a closed chain of them that has none. A gluing keeps the orientation of
    /// the simplices when its permutation is odd.
    ///
    /// # Complexity
    /// $O(n^2)$ for each n-simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut band = GluingTable::unglued(2, 1)?;
    /// band.glue(0, 2, 0, &[1, 2, 0])?;
    /// assert_eq!(band.orientation().odd_cycle().map(|cycle| cycle.cells().len()), Some(1));
    /// let mut cone = GluingTable::unglued(2, 1)?;
    /// cone.glue(0, 0, 0, &[1, 0, 2])?;
    /// assert_eq!(cone.orientation().is_orientable(), Some(true));
    /// # Ok(()) }
    /// ```
    pub fn orientation(&self) -> GluingOrientation {
        let count = self.simplex_count();
        let mut found =
            Coherence { obstruction: None, conflicts: Vec::new(), signs: Vec::new(), odd_cycle: None };
        for i in 0..count {
            for f in 0..=self.dimension() {
                let Some((j, images)) = self.neighbor(i, f) else { continue };
                // Each gluing once, from its lower side.
                if (i, f) <= (j, images[f] as usize) && permutation_sign(images) == Sign::Plus {
                    found.conflicts.push(GluedFacet { simplex: CellId::new(i), opposite: f });
                }
            }
        }
        let mut signs: Vec<Option<Sign>> = vec![None; count];
        // The simplex and facet from which each was reached.
        let mut parents: Vec<Option<(usize, usize)>> = vec![None; count];
        let mut queue = VecDeque::new();
        for root in 0..count {
            if signs[root].is_some() {
                continue;
            }
            signs[root] = Some(Sign::Plus);
            queue.push_back((root, Sign::Plus));
            while let Some((i, sign)) = queue.pop_front() {
                for f in 0..=self.dimension() {
                    let Some((j, images)) = self.neighbor(i, f) else { continue };
                    let across = sign.times(permutation_sign(images)).opposite();
                    match signs[j] {
                        None => {
                            signs[j] = Some(across);
                            parents[j] = Some((i, f));
                            queue.push_back((j, across));
                        }
                        Some(known) if known != across => {
                            let chain = self.closed_chain(&parents, (i, f), j);
                            found.odd_cycle = Some(OddCycle {
                                cells: chain.iter().map(|&(simplex, _)| CellId::new(simplex)).collect(),
                                facets: chain
                                    .into_iter()
                                    .map(|(simplex, opposite)| GluedFacet {
                                        simplex: CellId::new(simplex),
                                        opposite,
                                    })
                                    .collect(),
                            });
                            return found;
                        }
                        Some(_) => {}
                    }
                }
            }
        }
        found.signs = signs.into_iter().map(|sign| sign.expect("every simplex was reached")).collect();
        found
    }

    /// The chain from where the tree paths to two simplices part, to the first, over its facet to the second, and back.
    fn closed_chain(
        &self,
        parents: &[Option<(usize, usize)>],
        last: (usize, usize),
        to: usize,
    ) -> Vec<(usize, usize)> {
        let steps_to = |mut simplex: usize| {
            let mut steps = Vec::new();
            while let Some(step) = parents[simplex] {
                steps.push(step);
                simplex = step.0;
            }
            steps.reverse();
            steps
        };
        let (there, back) = (steps_to(last.0), steps_to(to));
        let common = there.iter().zip(&back).take_while(|(a, b)| a == b).count();
        let mut chain = there[common..].to_vec();
        chain.push(last);
        // The way back crosses each facet from its other side.
        for &(simplex, facet) in back[common..].iter().rev() {
            let (other, images) = self.neighbor(simplex, facet).expect("the tree goes over gluings");
            chain.push((other, images[facet] as usize));
        }
        chain
    }
}

/// Plus for an even permutation.
pub(super) fn permutation_sign(images: &[u8]) -> Sign {
    Sign::power_of_minus_one(crate::gluing::faces::inversions(images))
}
