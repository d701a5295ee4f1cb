//! The links of the simplices of a complex, and what is seen of them: spheres, balls, or neither.

use super::FrozenComplex;
use super::bistellar::is_sphere_or_ball;
use super::collapse::{is_seen_as_ball, is_seen_as_sphere};
use super::manifold::{Cells, LinkFault, ManifoldWitness, subsets};
use coface_algebra::chains::{ChainComplex, MorseComplex};
use coface_algebra::{RaggedArray, smith_form};

/// What was found out about a link that is a manifold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Recognition {
    /// It is a sphere or a ball.
    Certified,
    /// It has the homology of neither.
    WrongHomology,
    /// Neither of these was shown.
    Open,
}

/// The links of all simplices of one codimension, as lists of facets around each.
pub(super) struct Links {
    codimension: usize,
    starts: Vec<u32>,
    facets: Vec<u32>,
}

impl Links {
    pub(super) fn new(cells: &Cells<'_>, codimension: usize) -> Self {
        let n = cells.dimension;
        let corners = subsets(n + 1, codimension);
        let mut starts = vec![0u32; cells.chains.cell_count(n - codimension) + 1];
        let of = |facet: usize| corners.iter().map(move |positions| cells.face_without(n, facet, positions));
        for facet in 0..cells.facet_count() {
            of(facet).for_each(|cell| starts[cell + 1] += 1);
        }
        let mut total = 0;
        for start in &mut starts {
            total += *start;
            *start = total;
        }
        let mut next = starts.clone();
        let mut facets = vec![0; total as usize];
        for facet in 0..cells.facet_count() {
            for cell in of(facet) {
                facets[next[cell] as usize] = facet as u32;
                next[cell] += 1;
            }
        }
        Self { codimension, starts, facets }
    }

    pub(super) fn count(&self) -> usize {
        self.starts.len() - 1
    }

    /// How much work it is to look at all links: their simplices, counted once for each facet.
    pub(super) fn work(&self) -> u64 {
        (self.facets.len() as u64).saturating_mul(1 << self.codimension.min(32))
    }

    /// The facets of the link of a simplex, by the vertices of the complex.
    pub(super) fn facets(&self, cells: &Cells<'_>, cell: usize) -> RaggedArray {
        let n = cells.dimension;
        let of = cells.complex.numbers(n - self.codimension, cell);
        let mut vertices = Vec::new();
        for &facet in &self.facets[self.starts[cell] as usize..self.starts[cell + 1] as usize] {
            let facet = cells.complex.numbers(n, facet as usize);
            vertices.extend(facet.iter().filter(|v| of.binary_search(v).is_err()));
        }
        RaggedArray::uniform(self.codimension, vertices).expect("a link has facets of one size")
    }

    /// Whether the link is a sphere or a ball by bistellar moves, which show it without knowing that it is a manifold.
    pub(super) fn is_certified_by_moves(&self, cells: &Cells<'_>, cell: usize) -> bool {
        is_sphere_or_ball(&self.facets(cells, cell))
    }

    /// What can be shown about one link. `is_manifold` says that it is known to be a combinatorial manifold.
    pub(super) fn recognize(&self, cells: &Cells<'_>, cell: usize, is_manifold: bool) -> Recognition {
        let facets = self.facets(cells, cell);
        let chains = chains_of(&facets);
        let dimension = self.codimension - 1;
        let ridges = chains.coboundary_matrix(dimension - 1).expect("a link of dimension 3 has ridges");
        let is_closed = ridges.columns().all(|facets| facets.rows().len() == 2);
        if is_manifold && if is_closed { is_seen_as_sphere(&chains) } else { is_seen_as_ball(&chains) } {
            return Recognition::Certified;
        }
        let is_right = |k: usize, (betti, torsion): (usize, usize)| {
            torsion == 0 && betti == usize::from(k == 0) + usize::from(is_closed && k == dimension)
        };
        let homology = homology_sizes(&chains);
        if !homology.into_iter().enumerate().all(|(k, sizes)| is_right(k, sizes)) {
            return Recognition::WrongHomology;
        }
        if is_sphere_or_ball(&facets) { Recognition::Certified } else { Recognition::Open }
    }

    pub(super) fn witness(
        &self,
        cells: &Cells<'_>,
        degree: usize,
        found: &[usize],
        fault: LinkFault,
    ) -> ManifoldWitness {
        let cell = found[0];
        let simplex = cells.named(degree, cell);
        let dimension = self.codimension - 1;
        let message = match fault {
            LinkFault::LinkHomology => {
                let homology = homology_sizes(&chains_of(&self.facets(cells, cell)));
                let betti: Vec<String> = homology.iter().map(|(b, _)| b.to_string()).collect();
                let torsion = if homology.iter().any(|&(_, t)| t > 0) { ", with torsion" } else { "" };
                format!(
                    "the link of {simplex} has the Betti numbers {}{torsion}, not those of a sphere or ball of dimension {dimension}",
                    betti.join(" ")
                )
            }
            _ => format!(
                "the link of {simplex} has the homology of a sphere or ball of dimension {dimension}, but was not seen to be one"
            ),
        };
        ManifoldWitness::new(fault, vec![simplex], found.len(), message)
    }
}

/// The Betti number and the number of torsion coefficients of each integral homology group.
pub(crate) fn homology_sizes(chains: &ChainComplex) -> Vec<(usize, usize)> {
    let morse = MorseComplex::new(chains);
    let count = chains.degree_count();
    let forms: Vec<(usize, usize)> = (1..count)
        .map(|degree| {
            let form = smith_form(&morse.boundary_matrix(degree));
            (form.rank(), form.torsion().len())
        })
        .collect();
    let out = |degree: usize| degree.checked_sub(1).and_then(|i| forms.get(i)).copied().unwrap_or((0, 0));
    (0..count)
        .map(|degree| {
            let (rank_in, torsion) = out(degree + 1);
            (morse.critical_count(degree) - out(degree).0 - rank_in, torsion)
        })
        .collect()
}

fn chains_of(facets: &RaggedArray) -> ChainComplex {
    let complex = FrozenComplex::from_facets(facets).expect("the link of a simplex is a complex");
    complex.chain_complex().expect("the link of a simplex is a complex")
}
