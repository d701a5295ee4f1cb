//! False certificates are refused, each by the step that it should be.

use coface_check_loops::check;
use serde_json::{Value, json};

fn certificate(kind: &str, input: &str, answer: &Value, proof: &Value) -> Value {
    let hash = coface_check::sha256(input.as_bytes());
    json!({"coface_certificate": 1, "kind": kind, "inputs": [{"name": "a.json", "sha256": hash}], "answer": answer, "proof": proof})
}

/// What is proved, or the step that refuses the certificate after a change.
fn verdict(input: &str, mut certificate: Value, place: &str, value: Value) -> Result<Vec<String>, String> {
    if !place.is_empty() {
        *certificate.pointer_mut(place).expect("there is such a place") = value;
    }
    let found = check(certificate.to_string().as_bytes(), &[input.as_bytes()]);
    found.map(|verdict| verdict.proved().to_vec()).map_err(|fault| fault.step().to_owned())
}

fn refused(input: &str, certificate: &Value, forgeries: &[(&str, Value, &str)]) {
    verdict(input, certificate.clone(), "", Value::Null).expect("the true one is verified");
    for (place, value, step) in forgeries {
        let found = verdict(input, certificate.clone(), place, value.clone());
        assert_eq!(found, Err((*step).to_owned()), "{place}: {value}");
    }
}

/// A sphere that is cut along two edges, by hand: the middle of the seam is twice on the disk.
#[test]
fn forged_cuts_are_refused() {
    let sphere = "[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]";
    let seam = json!({"number": 1, "kind": "slit", "glued": "annulus", "edges": 2, "length": null, "vertices": [0, 1, 2]});
    let piece = json!({
        "surface": "sphere", "cut_edges": 2, "boundary_edges": 4, "euler_characteristic": 1, "f_vector": [5, 8, 4], "base": 0,
        "generators": 0, "relator": null, "seams": [seam], "word": [1, -1],
    });
    let answer = json!({"components": [piece], "f_vector": [5, 8, 4], "path": null});
    let whole = certificate("cut", sphere, &answer, &json!({"edges": [[0, 1], [1, 2]]}));
    refused(
        sphere,
        &whole,
        &[
            // A cycle cuts the sphere apart; an edge twice, one that is not there.
            ("/proof/edges", json!([[0, 1], [1, 2], [2, 0]]), "cut"),
            ("/proof/edges", json!([[0, 1], [1, 0]]), "cut"),
            ("/proof/edges", json!([[0, 1], [1, 9]]), "cut"),
            ("/proof/edges", json!([]), "cut"),
            ("/answer/components/0/word", json!([1, 1]), "seams"),
            ("/answer/components/0/word", json!([1]), "seams"),
            ("/answer/components/0/word", json!([1, -2]), "seams"),
            ("/answer/components/0/seams/0/vertices", json!([0, 1]), "answer"),
            ("/answer/components/0/seams/0/vertices", json!([0, 3, 2]), "seams"),
            ("/answer/components/0/seams/0/glued", json!("moebius"), "answer"),
            ("/answer/components/0/seams/0/number", json!(2), "answer"),
            ("/answer/components/0/surface", json!("torus"), "answer"),
            ("/answer/components/0/generators", json!(1), "answer"),
            ("/answer/components/0/base", json!(7), "answer"),
            ("/answer/components", json!([]), "cut"),
            ("/answer/f_vector", json!([4, 8, 4]), "answer"),
            ("/answer/path", json!({"kind": "open", "edges": 2}), "answer"),
        ],
    );
}

/// The annulus of three squares, three times around, by hand: a strip of nine.
#[test]
fn forged_covers_are_refused() {
    let tube = "OFF\n6 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 1\n0 1 1\n4 0 1 4 3\n4 1 2 5 4\n4 2 0 3 5\n";
    // Vertex 2i of the strip lies over i, and vertex 2i + 1 over i + 3.
    let vertices: Vec<u32> = (0..10).flat_map(|i| [i % 3, i % 3 + 3]).collect();
    // The first copy is in the middle.
    let faces: Vec<[u32; 4]> =
        [3, 4, 5, 6, 7, 8, 0, 1, 2].map(|i| [2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]).to_vec();
    let answer = json!({
        "component": 0, "components": 1, "surface": "annulus", "copies": 3, "complete": false, "f_vector": [20, 28, 9],
        "euler_characteristic": 1, "letters": [[0, 3]], "words": [[], [1], [-1]],
    });
    let proof = json!({"vertices": vertices, "faces": faces, "from": [[2, 0, 3, 5]]});
    let whole = certificate("cover", tube, &answer, &proof);
    refused(
        tube,
        &whole,
        &[
            ("/answer/words", json!([[], [-1], [1]]), "words"),
            ("/answer/words", json!([[], [1], [1]]), "words"),
            ("/answer/words", json!([[], [1], [1, 1]]), "words"),
            ("/answer/letters", json!([[1, 4]]), "words"),
            ("/answer/complete", json!(true), "answer"),
            ("/answer/copies", json!(2), "answer"),
            ("/answer/surface", json!("Moebius band"), "answer"),
            ("/proof/vertices/4", json!(0), "cover"),
            // Faces that are apart, or over no face.
            ("/proof/faces/8", json!([0, 2, 3, 9]), "surface"),
            ("/proof/faces/1", json!([8, 9, 10, 11]), "cover"),
            ("/proof/faces/8", json!([4, 6, 7, 5, 9]), "surface"),
            ("/proof/from", json!([[0, 1, 4, 3]]), "words"),
        ],
    );
    // A strip that is closed after six faces is a covering of degree 2, and no disk.
    let closed = certificate(
        "cover",
        tube,
        &json!({"components": 1, "surface": "annulus", "copies": 2, "complete": true, "f_vector": [12, 18, 6], "euler_characteristic": 0,
               "letters": [[0, 3]], "words": [[], [1]]}),
        &json!({
            "vertices": (0..6).flat_map(|i| [i % 3, i % 3 + 3]).collect::<Vec<u32>>(),
            "faces": (0..6).map(|i| { let j = (i + 1) % 6; [2 * i, 2 * j, 2 * j + 1, 2 * i + 1] }).collect::<Vec<[u32; 4]>>(),
            "from": [[2, 0, 3, 5]],
        }),
    );
    assert_eq!(verdict(tube, closed, "", Value::Null), Err("cover".to_owned()));
}

/// Two triangles with a common edge, and their rims alone: by hand.
#[test]
fn forged_groups_are_refused() {
    let rims = "[[0,1],[1,2],[0,2],[1,3],[2,3]]";
    let group = json!({"base": 0, "generators": 2, "relators": [], "name": "Free(2)"});
    let own = json!({"generators": [[1, 2], [2, 3]], "relators": [], "moves": []});
    let answer = json!({"simplified": false, "components": [group]});
    let whole = certificate(
        "pi1",
        rims,
        &answer,
        &json!({"tree": [[0, 1], [0, 2], [1, 3]], "faces": [], "components": [own]}),
    );
    refused(
        rims,
        &whole,
        &[
            ("/proof/tree", json!([[0, 1], [0, 2], [1, 2]]), "tree"),
            ("/proof/tree", json!([[0, 1], [0, 2]]), "tree"),
            ("/proof/tree", json!([[0, 1], [0, 2], [0, 3]]), "tree"),
            ("/proof/components/0/generators", json!([[1, 2]]), "faces"),
            ("/proof/components/0/generators", json!([[1, 2], [0, 1]]), "generators"),
            ("/proof/components/0/relators", json!([[1, 2]]), "answer"),
            ("/proof/faces", json!([[0, 1, 2]]), "faces"),
            ("/answer/components/0/name", json!("Z^2"), "answer"),
            ("/answer/components/0/generators", json!(1), "answer"),
            ("/answer/components/0/relators", json!([[1]]), "answer"),
            ("/answer/components/0/base", json!(9), "answer"),
            ("/answer/components", json!([]), "answer"),
        ],
    );
    // With one triangle filled its edge is the unit; with both the group is trivial, and a relator may not be made up.
    let filled = "[[0,1,2],[1,3],[2,3]]";
    let group = json!({"base": 0, "generators": 1, "relators": [], "name": "Z"});
    let own = json!({"generators": [[2, 3]], "relators": [], "moves": []});
    let whole = certificate(
        "pi1",
        filled,
        &json!({"simplified": false, "components": [group]}),
        &json!({"tree": [[0, 1], [0, 2], [1, 3]], "faces": [[0, 1, 2]], "components": [own]}),
    );
    refused(
        filled,
        &whole,
        &[
            ("/proof/faces", json!([]), "faces"),
            (
                "/proof/components/0/moves",
                json!([{"move": "eliminate", "generator": 1, "relator": 0}]),
                "moves",
            ),
            ("/proof/components/0/moves", json!([{"move": "guess"}]), "moves"),
        ],
    );
    let mut lie = whole;
    lie["proof"]["components"][0]["relators"] = json!([[1, 1]]);
    lie["answer"]["components"][0]["relators"] = json!([[1, 1]]);
    lie["answer"]["components"][0]["name"] = json!("Z/2");
    assert_eq!(verdict(filled, lie, "", Value::Null), Err("relators".to_owned()));
}
