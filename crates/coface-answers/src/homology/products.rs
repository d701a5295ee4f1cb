//! Cup products and intersection forms.

use crate::answer::{ChainTerm, CupProducts, IntersectionFormAnswer, WholeNumber};
use crate::{OrderedSimplices, Producer};
use coface_algebra::chains::Cochain;
use coface_algebra::{CellId, Error, Integer};
use coface_topology::{
    CochainAlgebra, Cocycle, Coefficients, MiddlePairing, cup_product_table, intersection_form,
};

/// The products of a basis of degree p with one of degree q, in the basis of degree p + q.
pub(super) fn cup(
    producer: &Producer,
    p: usize,
    q: usize,
    coefficients: Coefficients,
) -> Result<CupProducts, Error> {
    let simplices = producer.ordered_simplices()?;
    let algebra = CochainAlgebra::new(simplices.complex().clone())?;
    let table = cup_product_table(&algebra, p, q, coefficients)?;
    let list = |cocycles: &[Cocycle]| -> Vec<Vec<ChainTerm>> {
        cocycles.iter().map(|cocycle| terms(&simplices, cocycle.cochain())).collect()
    };
    let orders = |cocycles: &[Cocycle]| -> Vec<WholeNumber> {
        cocycles.iter().map(|cocycle| WholeNumber::of_order(cocycle.order())).collect()
    };
    let numbers = |x: &Vec<Integer>| x.iter().map(WholeNumber::from).collect();
    Ok(CupProducts {
        degrees: [p, q],
        first: list(table.first()),
        first_orders: orders(table.first()),
        second: list(table.second()),
        second_orders: orders(table.second()),
        target: list(table.target()),
        target_orders: orders(table.target()),
        table: table.values().iter().map(|row| row.iter().map(numbers).collect()).collect(),
    })
}

fn terms(simplices: &OrderedSimplices, cochain: &Cochain<Integer>) -> Vec<ChainTerm> {
    let term = |(cell, x): &(CellId, Integer)| {
        let name = simplices.name(cochain.degree(), *cell);
        (WholeNumber::from(x), name.iter().map(|&vertex| u64::from(vertex)).collect())
    };
    cochain.terms().iter().map(term).collect()
}

/// The intersection form.
pub(super) fn form(producer: &Producer) -> Result<IntersectionFormAnswer, Error> {
    let simplices = producer.ordered_simplices()?;
    let algebra = CochainAlgebra::new(simplices.complex().clone())?;
    let form = intersection_form(&algebra)?;
    let mut object = IntersectionFormAnswer {
        rank: form.rank(),
        determinant: WholeNumber::from(&form.determinant()),
        symmetric: form.as_symmetric().is_some(),
        signature: None,
        parity: None,
        definiteness: None,
        name: None,
        matrix: form.rows().iter().map(|row| row.iter().map(WholeNumber::from).collect()).collect(),
        basis: form.basis().iter().map(|cochain| terms(&simplices, cochain)).collect(),
    };
    if let MiddlePairing::Symmetric(symmetric) = form.pairing() {
        object.signature = Some(symmetric.signature());
        object.parity = Some(symmetric.parity().to_string());
        object.definiteness = Some(symmetric.definiteness().to_string());
        object.name = symmetric.name();
    }
    Ok(object)
}
