//! What is said about a cycle that the user gives.

use crate::chains::{GivenChain, Naming};
use coface::algebra::chains::ChainComplex;
use coface::answers::integer_to_json;
use coface::topology::{Bounding, HomologyBasis};
use serde_json::{Value, json};

/// The class of a cycle, and whether it bounds.
pub(super) struct Verdict {
    pub(super) object: Value,
    pub(super) words: String,
}

/// Finds the class of a cycle, and the chain that it bounds, or a cocycle that shows that it does not.
pub(super) fn verdict(
    given: &GivenChain,
    basis: &HomologyBasis<'_>,
    naming: &Naming<'_>,
    whole: &ChainComplex,
) -> Result<Verdict, coface::Error> {
    let chain = naming.producer.chain(whole, &given.terms, given.degree)?;
    let cycle = naming.of_model(basis.complex(), &chain)?;
    if let Some((face, x)) = basis.complex().boundary(&cycle)?.terms().first() {
        let name = naming.word(cycle.degree() - 1, face.index());
        return Err(coface::Error::new(
            coface::ErrorKind::NotACycle,
            format!("this is no cycle: its boundary has the coefficient {x} on {name}"),
        )
        .with_cure("give a chain whose boundary is zero"));
    }
    let class = basis.class_of(&cycle)?;
    let orders: Vec<Value> = basis
        .generators(cycle.degree())
        .iter()
        .map(|generator| generator.order().map_or(Value::from(0), integer_to_json))
        .collect();
    let mut object = json!({
        "degree": chain.degree(),
        "class": class.coefficients().iter().map(integer_to_json).collect::<Vec<_>>(),
        "orders": orders,
        "bounds": class.is_zero(),
        "multiple": class.order().as_ref().map(integer_to_json),
        "bounding": null,
        "cocycle": null,
    });
    let words = match basis.bounding(&cycle)? {
        Bounding::Bounds(chain) => {
            object["bounding"] = naming.terms(chain.degree(), chain.terms());
            format!("bounds a chain of {} cells", chain.terms().len())
        }
        Bounding::MultipleBounds { multiple, chain } => {
            object["bounding"] = naming.terms(chain.degree(), chain.terms());
            format!("does not bound, {multiple} times it bounds a chain of {} cells", chain.terms().len())
        }
        Bounding::Never { cocycle, value } => {
            object["cocycle"] = naming.terms(cocycle.degree(), cocycle.terms());
            object["value"] = integer_to_json(&value);
            format!("does not bound, nor does any multiple: a cocycle has the value {value} on it")
        }
        _ => "of unknown kind".to_owned(),
    };
    let class: Vec<String> = class.coefficients().iter().map(ToString::to_string).collect();
    let words = format!("class ({}) in H_{}; it {words}", class.join(", "), chain.degree());
    Ok(Verdict { object, words })
}
