//! What is said about a cycle that the user gives.

use crate::chains::GivenChain;
use coface::algebra::chains::ChainComplex;
use coface::answers::CellNames;
use coface::answers::answer::{CycleClass, WholeNumber};
use coface::topology::{Bounding, HomologyBasis};

/// The class of a cycle, and whether it bounds.
pub(super) struct Verdict {
    pub(super) object: CycleClass,
    pub(super) words: String,
}

/// Finds the class of a cycle, and the chain that it bounds, or a cocycle that shows that it does not.
pub(super) fn verdict(
    given: &GivenChain,
    basis: &HomologyBasis<'_>,
    naming: &CellNames<'_>,
    whole: &ChainComplex,
) -> Result<Verdict, coface::Error> {
    let chain = naming.producer().chain(whole, &given.terms, given.degree)?;
    let cycle = naming.of_model(basis.complex(), &chain)?;
    if let Some((face, x)) = basis.complex().boundary(&cycle)?.terms().first() {
        let name = naming.word(cycle.degree() - 1, *face);
        return Err(coface::Error::new(
            coface::ErrorKind::NotACycle,
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
    let words = match basis.bounding(&cycle)? {
        Bounding::Bounds(chain) => {
            object.bounding = Some(naming.terms(chain.degree(), chain.terms()));
            format!("bounds a chain of {} cells", chain.terms().len())
        }
        Bounding::MultipleBounds { multiple, chain } => {
            object.bounding = Some(naming.terms(chain.degree(), chain.terms()));
            format!("does not bound, {multiple} times it bounds a chain of {} cells", chain.terms().len())
        }
        Bounding::Never { cocycle, value } => {
            object.cocycle = Some(naming.terms(cocycle.degree(), cocycle.terms()));
            object.value = Some(WholeNumber::from(&value));
            format!("does not bound, nor does any multiple: a cocycle has the value {value} on it")
        }
        _ => "of unknown kind".to_owned(),
    };
    let class: Vec<String> = class.coefficients().iter().map(ToString::to_string).collect();
    let words = format!("class ({}) in H_{}; it {words}", class.join(", "), chain.degree());
    Ok(Verdict { object, words })
}
