//! Cup products and intersection forms.

use coface::algebra::{Integer, Parity};
use coface::chains::Cochain;
use coface::report::{OrderedSimplices, Producer, integer_to_json};
use coface::topology::{
    CochainAlgebra, Cocycle, Coefficients, HomologyBasis, MiddlePairing, intersection_form,
};
use coface::{Error, ErrorKind};
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
    let basis = HomologyBasis::new(algebra.chains());
    let [first, second, target] = [p, q, p + q].map(|degree| basis.cocycles_with(degree, coefficients));
    if let Coefficients::Modulo(n) = coefficients
        && target.iter().chain(&first).chain(&second).any(|cocycle| cocycle.order().is_some())
    {
        return Err(Error::new(
            ErrorKind::Coefficient,
            format!("cohomology over Z/{n} has summands of smaller order"),
        )
        .with_cure("multiply over z, q or a prime field"));
    }
    let mut table: Vec<Vec<Vec<Integer>>> = Vec::new();
    for a in &first {
        let mut row = Vec::new();
        for b in &second {
            let product = algebra.cup(a.cochain(), b.cochain())?;
            row.push(coordinates(&basis, &product, coefficients)?);
        }
        table.push(row);
    }
    let list = |cocycles: &[Cocycle]| -> Value {
        cocycles.iter().map(|cocycle| terms(&simplices, cocycle.cochain())).collect()
    };
    let orders: Value =
        target.iter().map(|cocycle| cocycle.order().map_or(Value::from(0), integer_to_json)).collect();
    let values: Value = table
        .iter()
        .map(|row| row.iter().map(|x| x.iter().map(integer_to_json).collect::<Value>()).collect::<Value>())
        .collect();
    let object = json!({
        "degrees": [p, q],
        "first": list(&first),
        "second": list(&second),
        "target": list(&target),
        "orders": orders,
        "table": values,
    });
    let mut page = format!("  cup products of degrees {p} and {q}, in the basis of H^{}\n", p + q);
    for (i, row) in table.iter().enumerate() {
        for (j, x) in row.iter().enumerate().filter(|(_, x)| x.iter().any(|x| !x.is_zero())) {
            let x: Vec<String> = x.iter().map(ToString::to_string).collect();
            page += &format!("    a{i} b{j} = ({})\n", x.join(" "));
        }
    }
    if table.iter().flatten().flatten().all(Integer::is_zero) {
        page += "    all products are zero\n";
    }
    Ok((object, page))
}

/// A cocycle in the basis of its degree.
fn coordinates(
    basis: &HomologyBasis<'_>,
    cocycle: &Cochain<Integer>,
    coefficients: Coefficients,
) -> Result<Vec<Integer>, Error> {
    if coefficients == Coefficients::Integers {
        return Ok(basis.class_of_cocycle(cocycle)?.coefficients().to_vec());
    }
    // Over a field cocycles are dual to generators: their values on these are the coordinates.
    let generators = basis.generators_with(cocycle.degree(), coefficients);
    let value = |generator: &coface::topology::Generator| {
        let value = cocycle.pairing(generator.chain())?.unwrap_or(Integer::ZERO);
        Ok(match coefficients {
            Coefficients::Modulo(n) => value.div_rem_floor(&n.to_string().parse()?).1,
            _ => value,
        })
    };
    generators.iter().map(value).collect()
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
        "matrix": rows,
        "basis": basis,
    });
    let mut words = format!("rank {}, determinant {}", form.rank(), form.determinant());
    match form.pairing() {
        MiddlePairing::Symmetric(symmetric) => {
            let parity = if symmetric.parity() == Parity::Even { "even" } else { "odd" };
            object["signature"] = symmetric.signature().into();
            object["parity"] = parity.into();
            words += &format!(", signature {}, {parity}", symmetric.signature());
        }
        _ => words += ", skew",
    }
    Ok((object, format!("  intersection form: {words}\n")))
}
