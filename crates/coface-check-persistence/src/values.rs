//! The value of each cell.

use coface_check::json::{field, list, optional};
use coface_check::{Complex, Fault, Surface};
use serde_json::Value;

/// The value of each cell; and what is proved of the function, unless it is a file that the checker does not see.
pub(crate) fn values(
    complex: &Complex,
    answer: &Value,
    given: &Value,
    input: &[u8],
) -> Result<(Vec<Vec<f64>>, Option<String>), Fault> {
    let step = "values";
    let mut values = Vec::new();
    for (k, of_degree) in list(given, "\"values\"", step)?.iter().enumerate() {
        let numbers: Option<Vec<f64>> = list(of_degree, "a list", step)?.iter().map(Value::as_f64).collect();
        let numbers = numbers.filter(|numbers| complex.counts().get(k) == Some(&numbers.len()));
        values.push(
            numbers.ok_or_else(|| Fault::new(step, format!("not a number for each cell of degree {k}")))?,
        );
    }
    let star = match optional(answer, "star").map(Value::as_str) {
        None if values.len() == complex.counts().len() => {
            return Ok((values, None));
        }
        Some(Some("lower" | "extended")) if values.len() == 1 => f64::max,
        Some(Some("upper")) if values.len() == 1 => f64::min,
        _ => return Err(Fault::new(step, "not the values that the star of the answer needs")),
    };
    let names = names(complex)?;
    let values = of_cells(complex, &values[0], star)?;
    let function = field(answer, "function", step)?.as_str().unwrap_or_default();
    let expected: Vec<f64> = match (["x", "y", "z"].iter().position(|axis| *axis == function), function) {
        (Some(axis), _) => {
            let without = || Fault::new(step, "the input has no coordinates");
            let points = Surface::read(input).map_err(|_| without())?.points;
            let of = |&vertex: &u32| points.get(vertex as usize).map(|point| point[axis]);
            let own: Option<Vec<f64>> = names.iter().map(of).collect();
            own.ok_or_else(without)?
        }
        (None, "vertex number") => names.iter().map(|&vertex| vertex.into()).collect(),
        _ => return Ok((values, None)),
    };
    match values[0] == expected {
        true => Ok((values, Some(format!("the values of the vertices are {function}")))),
        false => Err(Fault::new(step, format!("the values of the vertices are not {function}"))),
    }
}

/// A vertex has a name, by which cells have it.
fn names(complex: &Complex) -> Result<Vec<u32>, Fault> {
    let name = |vertex: usize| complex.vertices(0, vertex).map(|name| name[0]);
    let names: Option<Vec<u32>> = (0..complex.counts()[0]).map(name).collect();
    names.ok_or_else(|| Fault::new("values", "the cells have no vertices"))
}

/// The greatest or the least of the values of the vertices of each cell.
pub(crate) fn of_cells(
    complex: &Complex,
    of_vertices: &[f64],
    star: fn(f64, f64) -> f64,
) -> Result<Vec<Vec<f64>>, Fault> {
    let names = names(complex)?;
    let mut values = vec![of_vertices.to_vec()];
    for (k, &count) in complex.counts().iter().enumerate().skip(1) {
        let of_cell = |cell: usize| -> Option<f64> {
            let place = |vertex: &u32| names.binary_search(vertex).ok().map(|place| of_vertices[place]);
            complex.vertices(k, cell)?.iter().map(place).reduce(|a, b| Some(star(a?, b?)))?
        };
        let own: Option<Vec<f64>> = (0..count).map(of_cell).collect();
        values.push(own.ok_or_else(|| Fault::new("values", "a cell has a vertex that is none"))?);
    }
    Ok(values)
}
