//! Generators of homology and cohomology.

use crate::CellNames;
use crate::answer::{ChainTerm, GeneratorAnswer, WholeNumber};
use coface_algebra::chains::{Chain, ChainComplex};
use coface_algebra::{CellId, Error, Integer};
use coface_topology::{Coefficients, HomologyBasis};

/// The generators of each degree of the model, cycles or cocycles.
pub(super) fn find(
    basis: &HomologyBasis<'_>,
    naming: &CellNames<'_>,
    coefficients: Coefficients,
    is_cohomology: bool,
) -> Vec<Vec<Found>> {
    let degrees = naming.shift()..basis.complex().degree_count();
    let of_degree = |degree| -> Vec<Found> {
        if is_cohomology {
            let cocycles = basis.cocycles_with(degree, coefficients).into_iter();
            return cocycles
                .map(|cocycle| Found {
                    order: cocycle.order().cloned(),
                    degree,
                    terms: cocycle.cochain().terms().to_vec(),
                    bounding: None,
                })
                .collect();
        }
        let is_integral = coefficients == Coefficients::Integers;
        let generators = basis.generators_with(degree, coefficients).into_iter().enumerate();
        generators
            .map(|(i, generator)| Found {
                order: generator.order().cloned(),
                degree,
                terms: generator.chain().terms().to_vec(),
                bounding: is_integral.then(|| basis.certificate(degree, i)).flatten(),
            })
            .collect()
    };
    degrees.map(of_degree).collect()
}

/// A generator of homology or cohomology, on the cells of the complex that was asked.
pub(super) struct Found {
    order: Option<Integer>,
    degree: usize,
    terms: Vec<(CellId, Integer)>,
    /// For a cycle of finite order m the chain with the boundary m times the cycle.
    bounding: Option<Chain<Integer>>,
}

impl Found {
    /// How many cells the cycle runs through, with multiplicity.
    fn length(&self) -> Integer {
        let mut length = Integer::ZERO;
        for (_, coefficient) in &self.terms {
            length += &coefficient.abs();
        }
        length
    }
}

/// The generators of each degree as `[{"order":0,"length":n,"chain":[[coefficient,[vertices..]],..]},..]`, with `"bounding"`
/// where the order is finite.
pub(super) fn answer(found: &[Vec<Found>], naming: &CellNames<'_>) -> Vec<Vec<GeneratorAnswer>> {
    let generator = |found: &Found| GeneratorAnswer {
        order: WholeNumber::of_order(found.order.as_ref()),
        length: WholeNumber::from(&found.length()),
        chain: naming.terms(found.degree, &found.terms),
        bounding: found.bounding.as_ref().map(|chain| naming.terms(chain.degree(), chain.terms())),
    };
    found.iter().map(|list| list.iter().map(generator).collect()).collect()
}

/// For each generator what tells it from the others: a cochain for a cycle, a chain for a cocycle.
pub(super) fn duals(
    basis: &HomologyBasis<'_>,
    naming: &CellNames<'_>,
    coefficients: Coefficients,
    is_cohomology: bool,
) -> Vec<Vec<Vec<ChainTerm>>> {
    let of_degree = |degree| -> Vec<Vec<ChainTerm>> {
        if is_cohomology {
            let duals = basis.cocycle_duals(degree, coefficients);
            return duals.iter().map(|chain| naming.terms(degree, chain.terms())).collect();
        }
        let duals = basis.generator_duals(degree, coefficients);
        duals.iter().map(|cochain| naming.terms(degree, cochain.terms())).collect()
    };
    (naming.shift()..basis.complex().degree_count()).map(of_degree).collect()
}

/// The generators on the cells of the model, with names for groups of cells.
pub(super) fn named(
    found: &[Vec<Found>],
    naming: &CellNames<'_>,
    whole: &ChainComplex,
) -> Result<Vec<(String, Chain<Integer>)>, Error> {
    let mut named = Vec::new();
    for (degree, list) in found.iter().enumerate() {
        for (i, found) in list.iter().enumerate() {
            let order = found.order.as_ref().map_or("free".to_owned(), |order| format!("order_{order}"));
            let chain = naming.to_model(whole, found.degree, &found.terms)?;
            named.push((format!("H{degree}_{i}_{order}"), chain));
        }
    }
    Ok(named)
}

/// The generators on the cells of the model, named as Gmsh names them: the symbol, the degree, the domain and the number of the generator in
/// its degree, from 1, with its order if that is finite.
pub(super) fn physical(
    found: &[Vec<Found>],
    naming: &CellNames<'_>,
    whole: &ChainComplex,
    symbol: &str,
    domain: &str,
) -> Result<Vec<(String, Chain<Integer>)>, Error> {
    let mut named = Vec::new();
    for (degree, list) in found.iter().enumerate() {
        for (found, number) in list.iter().zip(1..) {
            let order = found.order.as_ref().map_or(String::new(), |order| format!(" of order {order}"));
            let chain = naming.to_model(whole, found.degree, &found.terms)?;
            named.push((format!("{symbol}{degree}{domain}{number}{order}"), chain));
        }
    }
    Ok(named)
}
