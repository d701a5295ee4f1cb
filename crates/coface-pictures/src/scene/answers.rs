//! Whether an answer has numbers where it should: what is no number is a fault, and is named with its place.

use coface_algebra::Error;
use serde_json::Value;

/// Checks all that is shown of an answer. Keys that are not there are none.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) with the place of the first entry that cannot be what it should.
pub(super) fn check(name: &str, result: &Value) -> Result<(), Error> {
    let answer = Answer { name };
    for key in ["source", "copy"] {
        answer.vertices(&result[key], || key.to_owned())?;
    }
    for key in ["facets", "polygons", "letters", "edges", "simplices", "inside"] {
        // Some verbs have counts at these keys.
        for (i, list) in entries(&result[key]) {
            answer.vertices(list, || format!("{key}[{i}]"))?;
        }
    }
    for (degree, list) in entries(&result["generators"]) {
        for (i, generator) in entries(list) {
            answer.chain(&generator["chain"], || format!("generators[{degree}][{i}].chain"))?;
        }
    }
    for (i, cocycle) in entries(&result["cocycles"]) {
        answer.chain(cocycle, || format!("cocycles[{i}]"))?;
    }
    for (i, list) in entries(&result["harmonic"]) {
        for (j, value) in entries(&list["values"]) {
            answer.number(value, || format!("harmonic[{i}].values[{j}]"))?;
        }
        for (j, form) in entries(list) {
            answer.chain(&form["chain"], || format!("harmonic[{i}][{j}].chain"))?;
        }
    }
    for (at, component) in entries(&result["components"]) {
        for (i, seam) in entries(&component["seams"]) {
            answer.vertices(&seam["vertices"], || format!("components[{at}].seams[{i}].vertices"))?;
        }
        for (i, walk) in entries(&component["loops"]) {
            answer.walk(walk, || format!("components[{at}].loops[{i}]"))?;
        }
    }
    for key in ["loops", "walks"] {
        for (i, walk) in entries(&result[key]) {
            answer.walk(walk, || format!("{key}[{i}]"))?;
        }
    }
    for (i, point) in entries(&result["positions"]) {
        for (axis, value) in entries(point) {
            answer.number(value, || format!("positions[{i}][{axis}]"))?;
        }
    }
    for (i, pair) in entries(&result["diagram"]) {
        answer.number(&pair["birth"], || format!("diagram[{i}].birth"))?;
        if !pair["death"].is_null() {
            answer.number(&pair["death"], || format!("diagram[{i}].death"))?;
        }
    }
    Ok(())
}

fn entries(value: &Value) -> impl Iterator<Item = (usize, &Value)> {
    value.as_array().into_iter().flatten().enumerate()
}

struct Answer<'a> {
    name: &'a str,
}

impl Answer<'_> {
    /// A list of vertex numbers, or nothing.
    fn vertices(&self, list: &Value, place: impl Fn() -> String) -> Result<(), Error> {
        if !list.is_null() && !list.is_array() {
            return Err(self.fault(&place(), list, "a list of vertices"));
        }
        for (i, vertex) in entries(list) {
            if vertex.as_u64().is_none_or(|vertex| u32::try_from(vertex).is_err()) {
                return Err(self.fault(&format!("{}[{i}]", place()), vertex, "the number of a vertex"));
            }
        }
        Ok(())
    }

    /// Terms of a coefficient and a cell, or nothing.
    fn chain(&self, chain: &Value, place: impl Fn() -> String) -> Result<(), Error> {
        if !chain.is_null() && !chain.is_array() {
            return Err(self.fault(&place(), chain, "a list of terms"));
        }
        for (i, term) in entries(chain) {
            let place = || format!("{}[{i}]", place());
            if term.as_array().is_none_or(|term| term.len() != 2) || !term[1].is_array() {
                return Err(self.fault(&place(), term, "a coefficient with a cell"));
            }
            // Coefficients beyond 64 bits are texts.
            let is_text = term[0].as_str().is_some_and(|digits| {
                let digits = digits.strip_prefix('-').unwrap_or(digits);
                !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'/')
            });
            if !is_text {
                self.number(&term[0], || format!("{}[0]", place()))?;
            }
            self.vertices(&term[1], || format!("{}[1]", place()))?;
        }
        Ok(())
    }

    /// A walk along vertices, or a chain; by itself or as an object.
    fn walk(&self, walk: &Value, place: impl Fn() -> String) -> Result<(), Error> {
        if walk.is_object() {
            return self.vertices(&walk["vertices"], || format!("{}.vertices", place()));
        }
        if walk[0].is_array() { self.chain(walk, place) } else { self.vertices(walk, place) }
    }

    fn number(&self, value: &Value, place: impl Fn() -> String) -> Result<(), Error> {
        if value.is_number() { Ok(()) } else { Err(self.fault(&place(), value, "a number")) }
    }

    fn fault(&self, place: &str, value: &Value, wanted: &str) -> Error {
        let text: String = value.to_string().chars().take(40).collect();
        Error::invalid(format!("{place} is {text}, not {wanted}, in {}", self.name))
            .with_cure("give the JSON as the verb of coface wrote it")
    }
}

#[cfg(test)]
mod tests {
    use super::check;
    use serde_json::json;

    #[test]
    fn what_is_no_number_is_named_with_its_place() {
        for (result, message) in [
            (
                json!({"simplices": [[0, 1], [2, "x"]]}),
                "simplices[1][1] is \"x\", not the number of a vertex, in r",
            ),
            (json!({"simplices": [[0, -1]]}), "simplices[0][1] is -1"),
            (json!({"simplices": [7]}), "simplices[0] is 7, not a list of vertices"),
            (json!({"source": [0, 1.5]}), "source[1] is 1.5"),
            (json!({"loops": [[0, null]]}), "loops[0][1] is null"),
            (json!({"walks": [[[1, [0, 4_294_967_296_u64]]]]}), "walks[0][0][1][1] is 4294967296"),
            (
                json!({"components": [{"seams": [{"vertices": [true]}]}]}),
                "components[0].seams[0].vertices[0] is true",
            ),
            (
                json!({"generators": [[], [{"chain": [[1, 5]]}]]}),
                "generators[1][0].chain[0] is [1,5], not a coefficient",
            ),
            (
                json!({"generators": [[], [{"chain": [["1x", [0, 1]]]}]]}),
                "generators[1][0].chain[0][0] is \"1x\", not a number",
            ),
            (json!({"cocycles": [[[1, [0, "1"]]]]}), "cocycles[0][0][1][1] is \"1\""),
            (json!({"harmonic": [{"values": [1, {}]}]}), "harmonic[0].values[1] is {}"),
            (json!({"diagram": [{"degree": 0, "birth": "now"}]}), "diagram[0].birth is \"now\""),
        ] {
            let error = check("r", &result).unwrap_err();
            assert!(error.message().contains(message) && error.cure().is_some(), "{error}");
        }
        let sound = json!({"simplices": [[0]], "loops": 3, "facets": 2, "generators": [[{"chain": [["-99999999999999999999", [0, 1]]]}]],
            "components": [{"loops": [{"vertices": [0, 1, 0]}, [[1, [0, 1]]]]}], "diagram": [{"birth": 0.5, "death": null}]});
        check("r", &sound).unwrap();
    }
}
