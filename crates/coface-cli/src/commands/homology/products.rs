//! Cup products and intersection forms.

use coface::Error;
use coface::algebra::Integer;
use coface::algebra::chains::Cochain;
use coface::answers::{OrderedSimplices, Producer, integer_to_json};
use coface::topology::{
    CochainAlgebra, Cocycle, Coefficients, MiddlePairing, cup_product_table, intersection_form,
};
use serde_json::{Value, json};

/// The products of a basis of degree p with one of degree q, in the basis of degree p + q, and a page that shows them.
pub(super) fn cup(
    producer: &Producer,
    p: usize,
    q: usize,
    coefficients: Coefficients,
) -> Result<(Value, String), Error> {
    let simplices = producer.ordered_simplices()?;
    let algebra = CochainAlgebra::new(simplices.complex().clone())?;
    let table = cup_product_table(&algebra, p, q, coefficients)?;
    let list = |cocycles: &[Cocycle]| -> Value {
        cocycles.iter().map(|cocycle| terms(&simplices, cocycle.cochain())).collect()
    };
    let orders = |cocycles: &[Cocycle]| -> Value {
        cocycles.iter().map(|cocycle| cocycle.order().map_or(Value::from(0), integer_to_json)).collect()
    };
    let values: Value = table
        .values()
        .iter()
        .map(|row| row.iter().map(|x| x.iter().map(integer_to_json).collect::<Value>()).collect::<Value>())
        .collect();
    let object = json!({
        "degrees": [p, q],
        "first": list(table.first()),
        "first_orders": orders(table.first()),
        "second": list(table.second()),
        "second_orders": orders(table.second()),
        "target": list(table.target()),
        "target_orders": orders(table.target()),
        "table": values,
    });
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

fn terms(simplices: &OrderedSimplices, cochain: &Cochain<Integer>) -> Value {
    let term = |(cell, x): &(coface::CellId, Integer)| {
        json!([integer_to_json(x), simplices.name(cochain.degree(), cell.index())])
    };
    cochain.terms().iter().map(term).collect()
}

/// The intersection form, and a page that shows it.
pub(super) fn form(producer: &Producer) -> Result<(Value, String), Error> {
    let simplices = producer.ordered_simplices()?;
    let algebra = CochainAlgebra::new(simplices.complex().clone())?;
    let form = intersection_form(&algebra)?;
    let rows: Value =
        form.rows().iter().map(|row| row.iter().map(integer_to_json).collect::<Value>()).collect();
    let basis: Value = form.basis().iter().map(|cochain| terms(&simplices, cochain)).collect();
    let mut object = json!({
        "rank": form.rank(),
        "determinant": integer_to_json(&form.determinant()),
        "symmetric": form.as_symmetric().is_some(),
        "signature": null,
        "parity": null,
        "definiteness": null,
        "name": null,
        "matrix": rows,
        "basis": basis,
    });
    let mut words = format!("rank {}, determinant {}", form.rank(), form.determinant());
    match form.pairing() {
        MiddlePairing::Symmetric(symmetric) => {
            object["signature"] = symmetric.signature().into();
            object["parity"] = symmetric.parity().to_string().into();
            object["definiteness"] = symmetric.definiteness().to_string().into();
            object["name"] = symmetric.name().into();
            words += &format!(", signature {}, {}", symmetric.signature(), symmetric.parity());
            words += &symmetric.name().map_or(String::new(), |name| format!(", {name}"));
        }
        _ => words += ", skew",
    }
    Ok((object, format!("  intersection form: {words}\n")))
}
