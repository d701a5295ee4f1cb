//! False certificates are refused, each by the step that it should be.

use coface_check_walks::check;
use serde_json::{Value, json};

/// The projective plane of 6 vertices.
const PLANE: &str = "[[0,1,2],[0,2,3],[0,3,4],[0,4,5],[0,1,5],[1,2,4],[2,4,5],[2,3,5],[1,3,5],[1,3,4]]";

fn certificate(input: &str, walks: &Value, answer: &Value, proof: &Value) -> Value {
    let hash = coface_check::sha256(input.as_bytes());
    let inputs = json!([{"name": "a.json", "sha256": hash}]);
    json!({"coface_certificate": 1, "kind": "walks", "inputs": inputs, "walks": walks, "answer": answer, "proof": proof})
}

/// What is proved, or the step that refuses the certificate after a change.
fn verdict(input: &str, certificate: &Value, place: &str, value: &Value) -> Result<Vec<String>, String> {
    let mut certificate = certificate.clone();
    if !place.is_empty() {
        *certificate.pointer_mut(place).expect("there is such a place") = value.clone();
    }
    let found = check(certificate.to_string().as_bytes(), &[input.as_bytes()]);
    found.map(|verdict| verdict.proved().to_vec()).map_err(|fault| fault.step().to_owned())
}

/// By hand: with the star of vertex 0 as its tree all edges around it are the unit, and all others are the edge from 1 to 3, whose square is the
/// word of the last face.
fn plane() -> Value {
    let walk = |contractible: bool| {
        let letters = if contractible { json!([]) } else { json!([1]) };
        let class = json!([i32::from(!contractible)]);
        json!({"steps": 3, "component": 0, "contractible": contractible, "bounds": contractible, "word": letters, "homology": class})
    };
    let pair = |i: usize, j: usize, same: bool| json!({"walks": [i, j], "homotopic": same, "freely_homotopic": same, "homologous": same});
    let answer = json!({
        "components": [{"base": 0, "generators": 1, "relators": [[1, 1]]}],
        "walks": [walk(false), walk(true), walk(false)],
        "pairs": [pair(0, 1, false), pair(0, 2, true), pair(1, 2, false)],
    });
    let proof = json!({
        "tree": [[0, 1], [0, 2], [0, 3], [0, 4], [0, 5]],
        "faces": [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 1, 5], [1, 3, 4], [1, 2, 4], [2, 4, 5], [2, 3, 5]],
        "components": [{"generators": [[1, 3]], "relators": [[1, 1]], "loops": [[1]], "images": [[1]]}],
    });
    certificate(PLANE, &json!([[0, 1, 3, 0], [0, 1, 2, 0], [0, 2, 4, 0]]), &answer, &proof)
}

#[test]
fn forged_walks_are_refused() {
    let whole = plane();
    let proved = verdict(PLANE, &whole, "", &Value::Null).expect("the true one is verified");
    for line in [
        "a component has the group of the answer, of 1 generator and 1 relator",
        "of 3 walks, numbered from 0, those that can be contracted are [1]",
        "of 3 walks, those that bound are [1]",
        "the pairs of walks that are freely homotopic are [[0, 2]]",
    ] {
        assert!(proved.iter().any(|found| found == line), "{line}: {proved:?}");
    }
    // Another face that says the word of an edge: the truth told otherwise.
    assert_eq!(verdict(PLANE, &whole, "/proof/faces/8", &json!([1, 3, 5])), Ok(proved));
    for (place, value, step) in [
        ("/answer/walks/0/contractible", json!(true), "answer"),
        ("/answer/walks/1/contractible", json!(false), "answer"),
        ("/answer/walks/0/bounds", json!(true), "answer"),
        ("/answer/walks/0/word", json!([]), "answer"),
        ("/answer/walks/0/word", json!([2]), "answer"),
        ("/answer/walks/1/word", json!([1]), "answer"),
        ("/answer/walks/0/homology", json!([0]), "answer"),
        ("/answer/walks/0/homology", json!([]), "answer"),
        ("/answer/walks/0/homology", json!([i64::MIN]), "answer"),
        ("/answer/walks/0/steps", json!(4), "answer"),
        ("/answer/walks/0/component", Value::Null, "answer"),
        ("/answer/walks/0/component", json!(1), "answer"),
        ("/answer/pairs/1/homotopic", json!(false), "answer"),
        ("/answer/pairs/1/homotopic", Value::Null, "answer"),
        ("/answer/pairs/0/freely_homotopic", json!(true), "answer"),
        ("/answer/pairs/0/homologous", json!(true), "answer"),
        ("/answer/pairs/0/walks", json!([0, 2]), "answer"),
        ("/answer/pairs", json!([]), "answer"),
        ("/answer/walks", json!([]), "answer"),
        ("/answer/components", json!([]), "answer"),
        ("/answer/components/0/relators", json!([]), "answer"),
        ("/answer/components/0/relators", json!([[1, -1]]), "answer"),
        ("/answer/components/0/relators", json!([[1, 1], [1, 1]]), "answer"),
        ("/answer/components/0/generators", json!(2), "answer"),
        ("/answer/components/0/base", json!(9), "answer"),
        ("/walks/0", json!([0, 1, 3]), "walks"),
        ("/walks/0", json!([]), "walks"),
        ("/walks/0", json!([0, 9, 0]), "walks"),
        ("/walks/0", json!([0, 0]), "walks"),
        ("/walks/0", json!([0, 1, 2, 0]), "answer"),
        ("/proof/tree", json!([[0, 1], [0, 2], [1, 2], [0, 4], [0, 5]]), "tree"),
        ("/proof/faces/8", json!([2, 4, 5]), "faces"),
        ("/proof/components/0/relators", json!([]), "answer"),
        ("/proof/components/0/relators", json!([[1, 1, 1]]), "relators"),
        ("/proof/components/0/generators", json!([[3, 1], [1, 3]]), "generators"),
        ("/proof/components/0/loops", json!([[]]), "words"),
        ("/proof/components/0/loops", json!([[1, 1]]), "words"),
        ("/proof/components/0/loops", json!([]), "words"),
        ("/proof/components/0/images", json!([[]]), "words"),
        ("/proof/components/0/images", json!([[2]]), "words"),
    ] {
        let found = verdict(PLANE, &whole, place, &value);
        assert_eq!(found, Err(step.to_owned()), "{place}: {value}");
    }
}

/// Two edges that meet nothing, and a vertex: what bounds is homologous wherever it is, and what stays at one place is there alone.
#[test]
fn walks_in_several_components() {
    let input = "[[0,1],[2,3],[5]]";
    let walk = |steps: usize, component: Option<usize>| json!({"steps": steps, "component": component, "contractible": true, "bounds": true, "word": [], "homology": []});
    let pair = |i: usize, j: usize, same: Option<bool>, free: bool| json!({"walks": [i, j], "homotopic": same, "freely_homotopic": free, "homologous": true});
    let component = |base: u32| json!({"base": base, "generators": 0, "relators": []});
    let answer = json!({
        "components": [component(0), component(2), component(5)],
        "walks": [walk(2, Some(0)), walk(2, Some(1)), walk(0, None), walk(0, None)],
        "pairs": [
            pair(0, 1, None, false), pair(0, 2, None, false), pair(0, 3, None, false), pair(1, 2, None, false), pair(1, 3, None, false),
            pair(2, 3, Some(true), true),
        ],
    });
    let own = json!({"generators": [], "relators": [], "loops": [], "images": []});
    let proof = json!({"tree": [[0, 1], [2, 3]], "faces": [], "components": [own, own, own]});
    let whole = certificate(input, &json!([[0, 1, 0], [3, 2, 3], [5], [5]]), &answer, &proof);
    let proved = verdict(input, &whole, "", &Value::Null).expect("the true one is verified");
    assert!(
        proved.contains(&"the pairs of walks that are freely homotopic are [[2, 3]]".to_owned()),
        "{proved:?}"
    );
    for (place, value) in [
        ("/answer/pairs/0/homologous", json!(false)),
        ("/answer/pairs/0/freely_homotopic", json!(true)),
        ("/answer/pairs/5/freely_homotopic", json!(false)),
        ("/answer/pairs/5/homotopic", Value::Null),
        ("/answer/walks/2/component", json!(2)),
    ] {
        assert_eq!(verdict(input, &whole, place, &value), Err("answer".to_owned()), "{place}: {value}");
    }
}
