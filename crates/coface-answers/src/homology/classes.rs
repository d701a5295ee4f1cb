//! The classes of given cycles.

use super::GivenChain;
use crate::CellNames;
use crate::answer::{CycleClass, WholeNumber};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, ErrorKind};
use coface_topology::{Bounding, HomologyBasis};

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
            object.bounding = Some(naming.terms(chain.degree(), chain.terms()));
        }
        Bounding::Never { cocycle, value } => {
            object.cocycle = Some(naming.terms(cocycle.degree(), cocycle.terms()));
            object.value = Some(WholeNumber::from(&value));
        }
        _ => {}
    }
    Ok(object)
}
