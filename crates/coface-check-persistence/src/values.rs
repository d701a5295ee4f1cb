//! The value of each cell.

use coface_check::json::{field, list, optional};
use coface_check::{Complex, Fault};
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
        Some(Some("lower")) if values.len() == 1 => f64::max,
        Some(Some("upper")) if values.len() == 1 => f64::min,
        _ => return Err(Fault::new(step, "not the values that the star of the answer needs")),
    };
    // A vertex has a name, by which cells have it.
    let name = |vertex: usize| complex.vertices(0, vertex).map(|name| name[0]);
    let names: Option<Vec<u32>> = (0..complex.counts()[0]).map(name).collect();
    let names = names.ok_or_else(|| Fault::new(step, "the cells have no vertices"))?;
    for (k, &count) in complex.counts().iter().enumerate().skip(1) {
        let of_cell = |cell: usize| -> Option<f64> {
            let place = |vertex: &u32| names.binary_search(vertex).ok().map(|place| values[0][place]);
            complex.vertices(k, cell)?.iter().map(place).reduce(|a, b| Some(star(a?, b?)))?
        };
        let own: Option<Vec<f64>> = (0..count).map(of_cell).collect();
        values.push(own.ok_or_else(|| Fault::new(step, "a cell has a vertex that is none"))?);
    }
    let function = field(answer, "function", step)?.as_str().unwrap_or_default();
    let expected: Vec<f64> = match (["x", "y", "z"].iter().position(|axis| *axis == function), function) {
        (Some(axis), _) => {
            let places = places(input)?;
            let of = |&vertex: &u32| places.get(vertex as usize).map(|place| place[axis]);
            let own: Option<Vec<f64>> = names.iter().map(of).collect();
            own.ok_or_else(|| Fault::new(step, "the input has no coordinates"))?
        }
        (None, "vertex number") => names.iter().map(|&vertex| vertex.into()).collect(),
        _ => return Ok((values, None)),
    };
    match values[0] == expected {
        true => Ok((values, Some(format!("the values of the vertices are {function}")))),
        false => Err(Fault::new(step, format!("the values of the vertices are not {function}"))),
    }
}

/// The coordinates of the vertices of an OFF or OBJ file, which the checker has read as a complex.
fn places(input: &[u8]) -> Result<Vec<Vec<f64>>, Fault> {
    let text =
        std::str::from_utf8(input).map_err(|_| Fault::new("values", "the input has no coordinates"))?;
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or("").trim());
    let mut lines = lines.filter(|line| !line.is_empty());
    let numbers = |words: &mut dyn Iterator<Item = &str>| -> Result<Vec<f64>, Fault> {
        let numbers: Option<Vec<f64>> = words.take(3).map(|word| word.parse().ok()).collect();
        let numbers = numbers.filter(|numbers| numbers.len() == 3);
        numbers.ok_or_else(|| Fault::new("values", "a vertex has no three coordinates"))
    };
    if !text.trim_start().starts_with("OFF") {
        let vertices = lines.filter_map(|line| line.strip_prefix("v ").or_else(|| line.strip_prefix("v\t")));
        return vertices.map(|line| numbers(&mut line.split_whitespace())).collect();
    }
    let first = lines.next().unwrap_or("").trim_start_matches("OFF").trim();
    let counts = if first.is_empty() { lines.next().unwrap_or("") } else { first };
    let count: Option<usize> = counts.split_whitespace().next().and_then(|word| word.parse().ok());
    lines.take(count.unwrap_or(0)).map(|line| numbers(&mut line.split_whitespace())).collect()
}
