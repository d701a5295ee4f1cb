//! The classes of given cycles.

use super::GivenChain;
use crate::CellNames;
use crate::answer::{CycleClass, WholeNumber};
use coface_algebra::chains::{Chain, ChainComplex};
use coface_algebra::{CellId, Error, ErrorKind, Integer};
use coface_topology::{Bounding, HomologyBasis};
use std::collections::BTreeMap;

/// So often each cycle is tried for a shorter chain.
const MOST_ROUNDS: usize = 8;
/// With more cells above, chains stay as they are.
const MOST_CELLS: usize = 1 << 20;

/// Finds the class of a cycle, and the chain that it bounds, or a cocycle that shows that it does not.
pub(super) fn class(
    given: &GivenChain,
    basis: &HomologyBasis<'_>,
    naming: &CellNames<'_>,
    whole: &ChainComplex,
) -> Result<CycleClass, Error> {
    let chain = naming.producer().chain(whole, &given.terms, given.degree)?;
    let cycle = naming.of_model(basis.complex(), &chain)?;
    if let Some((face, x)) = basis.complex().boundary(&cycle)?.terms().first() {
        let name = naming.word(cycle.degree() - 1, *face);
        return Err(Error::new(
            ErrorKind::NotACycle,
            format!("this is no cycle: its boundary has the coefficient {x} on {name}"),
        )
        .with_cure("give a chain whose boundary is zero"));
    }
    let class = basis.class_of(&cycle)?;
    let orders = basis
        .generators(cycle.degree())
        .iter()
        .map(|generator| WholeNumber::of_order(generator.order()))
        .collect();
    let mut object = CycleClass {
        degree: chain.degree(),
        class: class.coefficients().iter().map(WholeNumber::from).collect(),
        orders,
        bounds: class.is_zero(),
        multiple: class.order().as_ref().map(WholeNumber::from),
        bounding: None,
        cocycle: None,
        value: None,
    };
    match basis.bounding(&cycle)? {
        Bounding::Bounds(chain) | Bounding::MultipleBounds { chain, .. } => {
            object.bounding = Some(naming.terms(chain.degree(), &shortened(&chain, basis)));
        }
        Bounding::Never { cocycle, value } => {
            object.cocycle = Some(naming.terms(cocycle.degree(), cocycle.terms()));
            object.value = Some(WholeNumber::from(&value));
        }
        _ => {}
    }
    Ok(object)
}

/// The terms of a chain with the same boundary that has fewer cells, where that is seen at once: generators, and boundaries of single
/// cells, are added as long as more cells go than come.
fn shortened(chain: &Chain<Integer>, basis: &HomologyBasis<'_>) -> Vec<(CellId, Integer)> {
    let mut kept: BTreeMap<CellId, Integer> = chain.terms().iter().cloned().collect();
    let degree = chain.degree();
    if basis.complex().cell_count(degree + 1) > MOST_CELLS {
        return kept.into_iter().collect();
    }
    let generators = basis.generators(degree).iter().map(|generator| generator.chain().terms().to_vec());
    let above = basis.complex().boundary_matrix(degree + 1);
    let boundaries = above.into_iter().flat_map(|boundary| boundary.columns()).map(|column| {
        column.iter().map(|(cell, x)| (CellId::new(cell), Integer::from(i64::from(x)))).collect()
    });
    let cycles: Vec<Vec<(CellId, Integer)>> = generators.chain(boundaries).collect();
    for _ in 0..MOST_ROUNDS {
        let mut is_shorter = false;
        for cycle in &cycles {
            // How many cells go with each factor; all that are not there yet come.
            let mut gone: BTreeMap<Integer, usize> = BTreeMap::new();
            let mut new_count = 0;
            for (cell, x) in cycle {
                match kept.get(cell) {
                    None => new_count += 1,
                    Some(own) => {
                        if let Some(factor) = own.exact_quotient(x) {
                            *gone.entry(factor).or_default() += 1;
                        }
                    }
                }
            }
            let best = gone.iter().max_by(|x, y| x.1.cmp(y.1).then(y.0.cmp(x.0)));
            let Some((factor, _)) = best.filter(|(_, count)| **count > new_count) else { continue };
            is_shorter = true;
            for (cell, x) in cycle {
                let own = kept.remove(cell).unwrap_or(Integer::ZERO);
                let left = &own - &(factor * x);
                if !left.is_zero() {
                    kept.insert(*cell, left);
                }
            }
        }
        if !is_shorter {
            break;
        }
    }
    kept.into_iter().collect()
}
