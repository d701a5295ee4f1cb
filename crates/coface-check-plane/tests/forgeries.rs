//! False certificates are refused, each by the step that it should be.

use coface_check_plane::{check, sha256};
use serde_json::{Value, json};

/// A triangle and a line through it.
const INPUT: &str = "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 0 4, 0 0)), LINESTRING (1 -1, 1 1))";

fn honest() -> Value {
    json!({
        "coface_certificate": 1, "kind": "arrangement", "rule": null,
        "inputs": [{"name": "a.wkt", "sha256": sha256(INPUT.as_bytes())}],
        "answer": {"f_vector": [6, 6, 1], "components": 1, "holes": 0, "euler_characteristic": 1, "bridges": 2,
                   "dangling_edges": 2, "inside": [[0]], "measures": [8.0], "rounding": {"exact": true}},
        // (0, 0), (0, 4), (1, -1), (1, 0), (1, 1), (4, 0); the second as (0, 8) / 2.
        "proof": {"vertices": [[0, 0, 1], [0, 8, 2], [1, -1, 1], [1, 0, 1], [1, 1, 1], [4, 0, 1]],
                  "chains": [[0, 3, 5], [5, 1], [1, 0], [2, 3, 4]],
                  "faces": [[0, 3]]},
    })
}

fn refusal(change: impl Fn(&mut Value)) -> String {
    let mut forged = honest();
    change(&mut forged);
    check(forged.to_string().as_bytes(), &[INPUT.as_bytes()]).expect_err("a forgery").to_string()
}

#[test]
fn the_true_one_is_verified() {
    let verdict = check(honest().to_string().as_bytes(), &[INPUT.as_bytes()]).expect("it is true");
    assert_eq!(verdict.proved().len(), 10);
    assert_eq!(verdict.unchecked(), ["rounding"]);
}

#[test]
fn forgeries_are_refused_by_their_steps() {
    // Vertices out of order, twice the same, at infinity.
    assert!(refusal(|c| c["proof"]["vertices"][0] = json!([1, 0, 1])).starts_with("vertices:"));
    assert!(refusal(|c| c["proof"]["vertices"][4] = json!([2, 0, 2])).starts_with("vertices:"));
    assert!(refusal(|c| c["proof"]["vertices"][5] = json!([4, 0, 0])).starts_with("vertices:"));
    // A crossing that is left out is a vertex on an edge, or two edges that cross.
    assert!(refusal(|c| c["proof"]["chains"][0] = json!([0, 5])).starts_with("sweep:"));
    assert!(refusal(|c| c["proof"]["chains"][3] = json!([2, 4])).starts_with("sweep:"));
    // Segments that are not covered, or left.
    assert!(refusal(|c| c["proof"]["chains"][3] = json!([2, 3])).starts_with("chains:"));
    assert!(refusal(|c| c["proof"]["chains"][3] = json!([2, 5, 4])).starts_with("chains:"));
    assert!(refusal(|c| c["proof"]["chains"][1] = json!([5, 4, 1])).starts_with("chains:"));
    assert!(refusal(|c| c["proof"]["chains"][0] = json!([0, 3, 9])).starts_with("chains:"));
    assert!(refusal(|c| c["proof"]["chains"][0] = json!([0, 5, 3, 5])).starts_with("chains:"));
    // Faces.
    assert!(refusal(|c| c["proof"]["faces"] = json!([[3, 0]])).starts_with("faces:"));
    assert!(refusal(|c| c["proof"]["faces"] = json!([])).starts_with("faces:"));
    assert!(refusal(|c| c["proof"]["faces"] = json!([[0, 3], [3, 5]])).starts_with("faces:"));
    // Answers.
    for (key, lie) in [
        ("f_vector", json!([6, 6, 2])),
        ("components", json!(2)),
        ("holes", json!(1)),
        ("bridges", json!(0)),
        ("dangling_edges", json!(1)),
        ("inside", json!([[]])),
        ("measures", json!([8.000_000_001])),
        ("measures", json!([8.0, 8.0])),
    ] {
        assert!(refusal(|c| c["answer"][key] = lie.clone()).starts_with("answer:"), "{key}");
    }
    // The line is of no polygon: only a rule of parities would need to know.
    assert!(refusal(|c| c["rule"] = json!("odd")).starts_with("certificate:"));
}

#[test]
fn crossings_of_many_edges_are_seen() {
    // Two bundles of lines that cross, of which all crossings are left out.
    let lines: Vec<String> =
        (1..6).flat_map(|i| [format!("0,{i},9,{}", 20 - i), format!("0,{},9,{i}", 20 - i)]).collect();
    let input = lines.join("\n");
    let segments: Vec<[i64; 4]> = (1..6).flat_map(|i| [[0, i, 9, 20 - i], [0, 20 - i, 9, i]]).collect();
    let mut ends: Vec<[i64; 2]> = segments.iter().flat_map(|s| [[s[0], s[1]], [s[2], s[3]]]).collect();
    ends.sort_unstable();
    let place = |x: i64, y: i64| ends.binary_search(&[x, y]).expect("an end");
    let forged = json!({
        "coface_certificate": 1, "kind": "arrangement", "inputs": [{"name": "a.lines", "sha256": sha256(input.as_bytes())}],
        "answer": {},
        "proof": {"vertices": ends.iter().map(|[x, y]| json!([x, y, 1])).collect::<Vec<_>>(),
                  "chains": segments.iter().map(|s| json!([place(s[0], s[1]), place(s[2], s[3])])).collect::<Vec<_>>(),
                  "faces": []},
    });
    let fault = check(forged.to_string().as_bytes(), &[input.as_bytes()]).expect_err("they cross");
    assert!(fault.to_string().starts_with("sweep: edges "), "{fault}");
}

#[test]
fn inputs_of_strangers_end() {
    for input in [
        "POLYGON",
        "POLYGON ((0 0, 1 0",
        "POLYGON ((0 0 1, 1 0 1, 1 1 1, 0 0 1))",
        "POINT (1 1)",
        "{}",
        "{\"type\":\"Point\"}",
        "1,2,3",
        "1,2,3,inf",
        "POLYGON ((1e999 0, 1 0, 1 1, 1e999 0))",
        "GEOMETRYCOLLECTION (",
        "\u{1}",
    ] {
        assert!(coface_check_plane::Drawing::read(&[input.as_bytes()]).is_err(), "{input}");
    }
    let deep = "GEOMETRYCOLLECTION (".repeat(100_000);
    assert!(coface_check_plane::Drawing::read(&[deep.as_bytes()]).is_err());
    for (input, segments) in [
        ("POLYGON EMPTY", 0),
        ("", 0),
        ("MULTIPOLYGON (((0 0, 1 0, 1 1)), EMPTY)", 3),
        ("LINESTRING (0 0, 1 1, 2 2)", 2),
        ("# a line\n0 0 1 1\n", 1),
        ("{\"type\":\"Feature\",\"geometry\":null}", 0),
    ] {
        let drawing = coface_check_plane::Drawing::read(&[input.as_bytes()]).expect(input);
        assert_eq!(drawing.segments().len(), segments, "{input}");
    }
}

/// A certificate of the arrangement of the triangle (0, 0), (2, 0), (0, 2).
fn verdict(vertices: &str, chains: &str, answer: &str) -> Result<Vec<String>, String> {
    let input = b"POLYGON ((0 0, 2 0, 0 2, 0 0))";
    let hash = coface_check::sha256(input);
    let certificate = format!(
        r#"{{"coface_certificate":1,"kind":"arrangement","inputs":[{{"name":"a.wkt","sha256":"{hash}"}}],"rule":"evenodd",
            "answer":{{{answer}}},"proof":{{"vertices":[{vertices}],"chains":[{chains}],"faces":[[0,2]]}}}}"#
    );
    let verdict =
        coface_check_plane::check(certificate.as_bytes(), &[input]).map_err(|fault| fault.to_string())?;
    Ok(verdict.proved().to_vec())
}

#[test]
fn vertices_have_reasons() {
    let chains = "[0,2],[2,1],[1,0]";
    let honest = verdict("[0,0,1],[0,2,1],[2,0,1]", chains, r#""f_vector":[3,3,1]"#).expect("it holds");
    assert_eq!(
        honest[1..],
        ["inside is where winding numbers are odd, the rule \"evenodd\"", "f_vector = [3,3,1]"]
    );
    // A vertex apart from all would make a component more; one on a side, an edge more.
    let apart = verdict("[0,0,1],[0,2,1],[2,0,1],[5,5,1]", chains, r#""f_vector":[4,3,1],"components":2"#);
    assert!(apart.expect_err("a lie").contains("vertex 3 is no end of a segment"));
    let on_side = verdict("[0,0,1],[0,2,1],[1,0,1],[2,0,1]", "[0,2,3],[3,1],[1,0]", r#""f_vector":[4,4,1]"#);
    assert!(on_side.expect_err("a lie").contains("vertex 2 is no end of a segment"));
}
