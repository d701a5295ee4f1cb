//! Cup products and intersection forms.

use coface::Error;
use coface::algebra::Integer;
use coface::algebra::chains::Cochain;
use coface::answers::answer::{ChainTerm, CupProducts, IntersectionFormAnswer, WholeNumber};
use coface::answers::{OrderedSimplices, Producer};
use coface::topology::{
    CochainAlgebra, Cocycle, Coefficients, MiddlePairing, cup_product_table, intersection_form,
};

/// The products of a basis of degree p with one of degree q, in the basis of degree p + q, and a page that shows them.
pub(super) fn cup(
    producer: &Producer,
    p: usize,
    q: usize,
    coefficients: Coefficients,
) -> Result<(CupProducts, String), Error> {
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
    let object = CupProducts {
        degrees: [p, q],
        first: list(table.first()),
        first_orders: orders(table.first()),
        second: list(table.second()),
        second_orders: orders(table.second()),
        target: list(table.target()),
        target_orders: orders(table.target()),
        table: table.values().iter().map(|row| row.iter().map(numbers).collect()).collect(),
    };
    let mut page = format!("  cup products of degrees {p} and {q}, in the basis of H^{}\n", p + q);
    for (i, row) in table.values().iter().enumerate() {
        for (j, x) in row.iter().enumerate().filter(|(_, x)| x.iter().any(|x| !x.is_zero())) {
            let x: Vec<String> = x.iter().map(ToString::to_string).collect();
            page += &format!("    a{i} b{j} = ({})\n", x.join(" "));
        }
    }
    if table.is_zero() {
        page += "    all products are zero\n";
    }
    Ok((object, page))
}

fn terms(simplices: &OrderedSimplices, cochain: &Cochain<Integer>) -> Vec<ChainTerm> {
    let term = |(cell, x): &(coface::CellId, Integer)| {
        let name = simplices.name(cochain.degree(), cell.index());
        (WholeNumber::from(x), name.iter().map(|&vertex| u64::from(vertex)).collect())
    };
    cochain.terms().iter().map(term).collect()
}

/// The intersection form, and a page that shows it.
pub(super) fn form(producer: &Producer) -> Result<(IntersectionFormAnswer, String), Error> {
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
    let mut words = format!("rank {}, determinant {}", form.rank(), form.determinant());
    match form.pairing() {
        MiddlePairing::Symmetric(symmetric) => {
            object.signature = Some(symmetric.signature());
            object.parity = Some(symmetric.parity().to_string());
            object.definiteness = Some(symmetric.definiteness().to_string());
            object.name = symmetric.name();
            words += &format!(", signature {}, {}", symmetric.signature(), symmetric.parity());
            words += &symmetric.name().map_or(String::new(), |name| format!(", {name}"));
        }
        _ => words += ", skew",
    }
    Ok((object, format!("  intersection form: {words}\n")))
}
