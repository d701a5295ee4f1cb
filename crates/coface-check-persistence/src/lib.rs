//! A checker of the certificates of persistence diagrams. It shares no code with what computed them: complexes are those of [`coface_check`], and it
//! adds in the field by itself.
//!
//! A certificate has a value for each vertex, or for each cell, the cells in their order, and chains. [`check`] tests that all chains have different
//! last cells, and their boundaries too: then the last cell of a boundary makes a class that the last cell of its chain ends. Of points it has cochains,
//! whose coboundaries have different first simplices. `docs/certificates.md` has
//! each rule and why it proves the claim. Certificates of other kinds are handed to [`coface_check_congruence`].

mod alpha;
mod cone;
mod extended;
mod groups;
mod image;
mod pairs;
mod parts;
mod points;
mod rips;
mod values;
mod vineyard;
mod zigzag;

pub use image::Image;

use coface_check::json::{field, index, list, optional, text};
use coface_check::{Complex, Fault, Verdict};
use pairs::Pair;
use serde_json::Value;
use std::collections::HashMap;

const KNOWN: [&str; 5] = ["file", "field", "star", "diagram", "betti"];
const PAIR_KEYS: [&str; 5] = ["degree", "birth", "death", "birth_cell", "death_cell"];

/// Checks a certificate of persistence, of a complex or of points, or of what [`coface_check_congruence`] knows, against the bytes of its inputs, in their order.
///
/// # Errors
/// A [`Fault`] with the first step that fails.
///
/// # Complexity
/// For n cells O(n log n), and the sizes of the chains and of their boundaries; certificates of other kinds as [`coface_check_congruence::check`].
///
/// # Examples
/// Vertices 0 and 2 enter before vertex 1, which is joined to both: one of two components ends.
/// ```
/// let input = b"[[0,1],[1,2]]";
/// let hash = coface_check::sha256(input);
/// let certificate = |death: f64| format!(
///     r#"{{"coface_certificate":1,"kind":"persistence","inputs":[{{"name":"a.json","sha256":"{hash}"}}],"min_persistence":0.0,
///         "answer":{{"file":"a.json","field":2,"function":"f.txt","star":"lower","betti":[1,0],"diagram":[
///             {{"degree":0,"birth":0.0,"death":null,"birth_cell":[0],"death_cell":null}},
///             {{"degree":0,"birth":1.0,"death":{death:?},"birth_cell":[2],"death_cell":[1,2]}}],"remarks":[]}},
///         "proof":{{"values":[[0.0,5.0,1.0]],"order":[[0,2,1],[0,1]],"chains":[[[[1,0]],[[1,0],[1,1]]]]}}}}"#
/// );
/// let verdict = coface_check_persistence::check(certificate(5.0).as_bytes(), &[input]).expect("the chains prove it");
/// assert_eq!((&verdict.proved()[0][..], &verdict.unchecked()[0][..]), ("Betti numbers over F_2 = [1, 0]", "function"));
/// assert!(coface_check_persistence::check(certificate(6.0).as_bytes(), &[input]).is_err());
/// ```
pub fn check(certificate: &[u8], inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    check_opened(&coface_check::opened(certificate, inputs)?, inputs)
}

/// The same for a certificate that [`coface_check::opened`] gave for these inputs.
///
/// # Errors
/// A [`Fault`] with the first step that fails.
///
/// # Complexity
/// That of [`check`].
///
/// # Examples
/// See [`check`].
pub fn check_opened(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    match text(field(whole, "kind", "certificate")?, "\"kind\"", "certificate")? {
        "persistence" => diagram(whole, inputs),
        "rips" => rips::check(whole, inputs),
        "image" => image::check(whole, inputs),
        "zigzag" => zigzag::check(whole, inputs[0]),
        "vineyard" => vineyard::check(whole, inputs[0]),
        _ => coface_check_congruence::check_opened(whole, inputs),
    }
}

fn diagram(whole: &Value, inputs: &[&[u8]]) -> Result<Verdict, Fault> {
    // Of points the certificate lists the simplices, and nothing is said about where they come from.
    let listed = optional(whole, "facets");
    if listed.is_some_and(|facets| !facets.is_array()) {
        return Err(Fault::new("input", "the simplices that the certificate lists are no list of facets"));
    }
    if listed.and(optional(&whole["answer"], "star")).is_some() {
        return Err(Fault::new(
            "input",
            "simplices are listed for points, and a star is of a function on a complex",
        ));
    }
    let listed = listed.map(Value::to_string);
    let complex = Complex::read(listed.as_ref().map_or(inputs[0], |text| text.as_bytes()))?;
    let (answer, proof) = (field(whole, "answer", "answer")?, field(whole, "proof", "proof")?);
    if optional(answer, "star").and_then(Value::as_str) == Some("extended") {
        if optional(whole, "part").is_some() {
            return Err(Fault::new("part", "extended persistence is of a whole complex"));
        }
        return extended::check(whole, &complex, inputs[0]);
    }
    let prime = index(field(answer, "field", "answer")?, "\"field\"", "answer")?;
    if !coface_check::is_prime(prime) {
        return Err(Fault::new("answer", format!("{prime} is not prime")));
    }
    let (values, of_function) =
        values::values(&complex, answer, field(proof, "values", "values")?, inputs[0])?;
    let part = parts::part(whole, &complex, listed.is_some(), inputs)?;
    let of_function = match (&listed, optional(whole, "layout").and_then(Value::as_str)) {
        // With a layout the simplices and their values are those of the points.
        (Some(_), Some(layout)) if answer["function"] == "squared radii of the alpha complex" => {
            Some(alpha::check(&complex, &values, inputs[0], layout)?)
        }
        (Some(_), _) => None,
        (None, _) => of_function,
    };
    let is_of_input = listed.is_none() || of_function.is_some();
    let is_upper = optional(answer, "star").and_then(Value::as_str) == Some("upper");
    // What is left of the complex relative to a part has its own numbers.
    let cells = Cells::of(&complex, part.as_ref().filter(|part| !part.is_image));
    let (complex, values) = match &part {
        Some(part) if !part.is_image => part.left(&complex, &values),
        _ => (complex, values),
    };
    let orders = pairs::orders(&complex, &values, field(proof, "order", "order")?, is_upper)?;
    let mut pairs = pairs::pairs(&complex, &orders, field(proof, "chains", "chains")?, prime.into())?;
    if let Some(part) = part.as_ref().filter(|part| part.is_image) {
        pairs = part.image_pairs(&complex, &orders, &pairs, proof, prime.into())?;
    }
    let mut betti = vec![0u64; complex.counts().len()];
    pairs.iter().filter(|pair| pair.2.is_none()).for_each(|pair| betti[pair.0] += 1);
    if part.is_some() && complex.counts() == [0] {
        // Without a point nothing has a degree.
        betti.clear();
    }
    let claimed = list(field(answer, "betti", "answer")?, "\"betti\"", "answer")?;
    // Complexes of points may lack simplices above a degree, and tell nothing there.
    if let (Some(_), Some(most)) = (&listed, optional(whole, "most_degree")) {
        let most = index(most, "\"most_degree\"", "answer")? as usize;
        betti.resize(most.min(64) + 1, 0);
        pairs.retain(|pair| pair.0 <= most);
    }
    if !claimed.iter().map(Value::as_u64).eq(betti.iter().map(|count| Some(*count))) {
        return Err(Fault::new("answer", format!("the Betti numbers over F_{prime} are {betti:?}")));
    }
    let least = field(whole, "min_persistence", "answer")?.as_f64();
    let least = least.ok_or_else(|| Fault::new("answer", "\"min_persistence\" is not a number"))?;
    let length = |(k, birth, death): &Pair| {
        death.map_or(f64::INFINITY, |cell| (values[k + 1][cell as usize] - values[*k][*birth as usize]).abs())
    };
    let mut expected: Vec<Pair> = pairs.into_iter().filter(|pair| length(pair) > least).collect();
    let claimed = list(field(answer, "diagram", "answer")?, "\"diagram\"", "answer")?;
    let found = claimed.iter().map(|pair| claimed_pair(&cells, &values, pair));
    let mut found = found.collect::<Result<Vec<Pair>, Fault>>()?;
    expected.sort_unstable();
    found.sort_unstable();
    if expected != found {
        return Err(Fault::new("answer", "the pairs of the chains are others than those of the answer"));
    }
    let mut known = [&KNOWN[..], if of_function.is_some() { &["function"] } else { &[] }].concat();
    let mut proved: Vec<String> = of_function.into_iter().collect();
    if let Some(part) = part {
        if part.is_named {
            known.push(part.key());
        }
        proved.push(part.claim);
    }
    if listed.is_some() {
        let counts = complex.counts();
        proved.push(format!(
            "the filtration has the simplices that the certificate lists, {counts:?} of degrees 0, 1, .."
        ));
    }
    proved.push(format!("Betti numbers over F_{prime} = {betti:?}"));
    for k in 0..betti.len() {
        let count = found.iter().filter(|pair| pair.0 == k).count();
        proved.push(format!(
            "degree {k}: the {count} pairs whose persistence is above {}, and no others",
            shown(least)
        ));
    }
    let verdict = Verdict::of(proved, answer, &known);
    Ok(if is_of_input { verdict } else { verdict.leaving(LISTED) })
}

/// What the certificate of points leaves open, beside the keys of its answer.
const LISTED: &str = "that these are the simplices of the input";

/// What the persistence of pairs is that live longer than this and not no time at all.
fn above(least: f64) -> String {
    if least < 0.0 { "not 0".to_owned() } else { format!("above {}", shown(least)) }
}

/// A length for people, with a power of ten where it is large or small.
fn shown(length: f64) -> String {
    format!("{length:?}").trim_end_matches(".0").to_owned()
}

/// The cells of each degree by their vertices in rising order, or by their numbers where they have no vertices.
struct Cells(Vec<HashMap<Vec<u32>, u32>>);

impl Cells {
    /// Those of a complex, or those that are left relative to a part, with the numbers that they have then.
    fn of(complex: &Complex, without: Option<&parts::Part>) -> Self {
        let of_degree = |(k, &count): (usize, &usize)| {
            let name = |cell: usize| match complex.vertices(k, cell) {
                Some(vertices) => sorted(vertices.to_vec()),
                None => vec![cell as u32],
            };
            let is_left = |cell: &usize| without.is_none_or(|part| !part.has(k, *cell));
            (0..count).filter(is_left).zip(0..).map(|(cell, number)| (name(cell), number)).collect()
        };
        Self(complex.counts().iter().enumerate().map(of_degree).collect())
    }

    fn find(&self, degree: usize, vertices: &Value, what: &str) -> Result<u32, Fault> {
        let vertices = list(vertices, what, "answer")?.iter().map(|vertex| index(vertex, what, "answer"));
        let vertices = sorted(vertices.collect::<Result<Vec<u32>, Fault>>()?);
        let found = self.0.get(degree).and_then(|cells| cells.get(&vertices)).copied();
        found.ok_or_else(|| Fault::new("answer", format!("there is no cell {vertices:?} of degree {degree}")))
    }
}

fn sorted(mut vertices: Vec<u32>) -> Vec<u32> {
    vertices.sort_unstable();
    vertices
}

/// A pair of the answer, whose values are those of its cells.
fn claimed_pair(cells: &Cells, values: &[Vec<f64>], pair: &Value) -> Result<Pair, Fault> {
    let step = "answer";
    let keys = pair.as_object().into_iter().flat_map(|object| object.keys());
    if let Some(key) = keys.into_iter().find(|key| !PAIR_KEYS.contains(&key.as_str())) {
        return Err(Fault::new(step, format!("a pair has the key {key:?}, of which nothing is proved")));
    }
    let degree = index(field(pair, "degree", step)?, "\"degree\"", step)? as usize;
    let cell = |degree: usize, key: &str, value: &Value| {
        let cell = cells.find(degree, field(pair, key, step)?, key)?;
        let own = values[degree][cell as usize];
        match value.as_f64() == Some(own) {
            true => Ok(cell),
            false => Err(Fault::new(step, format!("the value of the {key} {} is {own}", pair[key]))),
        }
    };
    let birth = cell(degree, "birth_cell", field(pair, "birth", step)?)?;
    let death = match (optional(pair, "death"), optional(pair, "death_cell")) {
        (None, None) => None,
        (Some(death), _) => Some(cell(degree + 1, "death_cell", death)?),
        (None, Some(_)) => return Err(Fault::new(step, "a pair has a cell of its death, but no value")),
    };
    Ok((degree, birth, death))
}
