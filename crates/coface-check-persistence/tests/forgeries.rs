//! False certificates of points and images are refused, each by the step that it should be.

use coface_check_persistence::check;
use serde_json::{Value, json};

/// A square of side 1, whose diagonals are longer; the checker takes the distances from the points.
const SQUARE: &str = "x,y\n0,0\n1,0\n1,1\n0,1\n";

fn certificate(input: &str, layout: &str, answer: &Value, cochains: &Value) -> Value {
    let hash = coface_check::sha256(input.as_bytes());
    let inputs = json!([{"name": "a.csv", "sha256": hash}]);
    json!({
        "coface_certificate": 1, "kind": "rips", "inputs": inputs, "layout": layout, "min_persistence": 0.0, "answer": answer,
        "proof": {"cochains": cochains},
    })
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

/// By hand: sides enter by falling index, {2, 3} at 5, {1, 2} at 2, {0, 3} at 3 and {0, 1} at 0, so the order is {2, 3}, {0, 3}, {1, 2}, {0, 1}: the last one closes the hole. The diagonals
/// are {1, 3} at 4, then {0, 2} at 1; the triangles have the diagonal {1, 3} at once, and by falling index {1, 2, 3} is before {0, 1, 3}.
fn square() -> Value {
    let diagonal = 2f64.sqrt();
    let point = |number: u32, end: [u32; 2]| json!({"degree": 0, "birth": 0.0, "death": 1.0, "birth_cell": [number], "death_cell": end});
    let answer = json!({
        "file": "a.csv", "field": 2, "function": "vietoris-rips", "star": null, "threshold": diagonal, "betti": [1, 0],
        "diagram": [
            {"degree": 0, "birth": 0.0, "death": null, "birth_cell": [0], "death_cell": null},
            point(1, [1, 2]), point(2, [0, 3]), point(3, [2, 3]),
            {"degree": 1, "birth": 1.0, "death": diagonal, "birth_cell": [0, 1], "death_cell": [0, 1, 3]},
        ],
    });
    certificate(SQUARE, "points", &answer, &json!([[]]))
}

#[test]
fn forged_diagrams_of_points_are_refused() {
    let whole = square();
    let proved = verdict(SQUARE, &whole, "", &Value::Null).expect("the true one is verified");
    assert_eq!(proved[0], "the rows of the file are 4 points with 2 coordinates, at Euclidean distances");
    assert_eq!(proved[2], "Betti numbers over F_2 at this diameter = [1, 0]");
    for (place, value, step) in [
        ("/answer/diagram/4/death", json!(1.5), "answer"),
        ("/answer/diagram/4/birth", json!(0.5), "answer"),
        ("/answer/diagram/4/birth_cell", json!([1, 2]), "answer"),
        ("/answer/diagram/4/death_cell", json!([0, 1, 2]), "answer"),
        ("/answer/diagram/4/degree", json!(0), "answer"),
        ("/answer/diagram/4/death", Value::Null, "answer"),
        ("/answer/diagram/1/death_cell", json!([0, 1]), "answer"),
        ("/answer/diagram/0/death_cell", json!([0, 1]), "answer"),
        ("/answer/diagram", json!([]), "answer"),
        ("/answer/betti", json!([1, 1]), "answer"),
        ("/answer/betti", json!([1]), "cochains"),
        ("/answer/betti", json!([]), "answer"),
        ("/answer/field", json!(4), "answer"),
        ("/answer/function", json!("flag complex"), "answer"),
        ("/answer/threshold", json!(1.0), "answer"),
        ("/answer/threshold", Value::Null, "answer"),
        ("/layout", json!("lower"), "input"),
        ("/layout", json!("square"), "input"),
        ("/layout", json!("vertices"), "input"),
        ("/layout", json!("guess"), "input"),
        ("/min_persistence", json!(0.5), "answer"),
        ("/proof/cochains", json!([]), "cochains"),
        ("/proof/cochains", json!([[[]]]), "cochains"),
        // A term before the first one, zero, twice, of another degree, not there, and a cochain of an edge that joins components.
        ("/proof/cochains", json!([[[[1, [0, 1]], [1, [1, 2]]]]]), "cochains"),
        ("/proof/cochains", json!([[[[2, [0, 1]]]]]), "cochains"),
        ("/proof/cochains", json!([[[[1, [0, 1]]], [[1, [0, 1]]]]]), "cochains"),
        ("/proof/cochains", json!([[[[1, [0, 1, 2]]]]]), "cochains"),
        ("/proof/cochains", json!([[[[1, [0, 9]]]]]), "cochains"),
        ("/proof/cochains", json!([[[[1, [1, 0]]]]]), "cochains"),
        ("/proof/cochains", json!([[[[1, [2, 3]]]]]), "cochains"),
        // The coboundary of this one begins with the triangle {1, 2, 3}, with which that of {1, 3} begins.
        ("/proof/cochains", json!([[[[1, [0, 1]], [1, [1, 3]]]]]), "cochains"),
    ] {
        assert_eq!(verdict(SQUARE, &whole, place, &value), Err(step.to_owned()), "{place}: {value}");
    }
}

#[test]
fn layouts_of_distances() {
    let pair = |birth: Value, death: Value| json!({"degree": 0, "birth": 0.0, "death": death, "birth_cell": [birth], "death_cell": if death.is_null() { Value::Null } else { json!([0, 1]) }});
    let answer = json!({
        "field": 3, "function": "vietoris-rips", "threshold": 5.0, "betti": [1],
        "diagram": [pair(json!(0), Value::Null), pair(json!(1), json!(5.0))],
    });
    for (input, layout, line) in [
        ("0 5\n5 0\n", "square", "the file has the distances of 2 points"),
        ("5\n", "lower", "the file has the distances of 2 points"),
        (
            "1 1\n4; 5\n\n# the end\n",
            "points",
            "the rows of the file are 2 points with 2 coordinates, at Euclidean distances",
        ),
        (
            "OFF\n2 0 0\n1 1 1\n4 1 5\n",
            "vertices",
            "the vertices of the file are 2 points, at Euclidean distances",
        ),
    ] {
        let whole = certificate(input, layout, &answer, &json!([]));
        let proved = verdict(input, &whole, "", &Value::Null);
        assert_eq!(proved.map(|lines| lines[0].clone()), Ok(line.to_owned()), "{input}");
    }
    for (input, layout) in [
        ("0 5\n4 0\n", "square"),
        ("1 5\n5 1\n", "square"),
        ("-5\n", "lower"),
        ("5 6\n", "lower"),
        ("1 1\n4 x\n", "points"),
        ("1 1\n4\n", "points"),
        ("1 1\n4 nan\n", "points"),
        ("1 1\n1e200 1e200\n", "points"),
    ] {
        let whole = certificate(input, layout, &answer, &json!([]));
        assert_eq!(verdict(input, &whole, "", &Value::Null), Err("input".to_owned()), "{input}");
    }
}

/// A stranger's file must not take time or memory without bound.
#[test]
fn points_of_strangers_end() {
    let many = "0\n".repeat(40_000);
    let answer =
        json!({"field": 2, "function": "vietoris-rips", "threshold": 1.0, "betti": [1], "diagram": []});
    let whole = certificate(&many, "points", &answer, &json!([]));
    assert_eq!(verdict(&many, &whole, "", &Value::Null), Err("input".to_owned()));
    let few = "0\n".repeat(6_000);
    let whole = certificate(&few, "points", &answer, &json!([]));
    assert_eq!(verdict(&few, &whole, "", &Value::Null), Err("input".to_owned()));
}

/// Two dark pixels with a bright one between them, as vertices, by hand.
#[test]
fn forged_diagrams_of_images_are_refused() {
    let input = "P2\n3 1\n9\n0 5 1\n";
    let pair = |birth: f64, death: Option<f64>, from: [u32; 2], to: Option<[u32; 2]>| json!({"degree": 0, "birth": birth, "death": death, "birth_cell": from, "death_cell": to});
    let answer = json!({
        "field": 2, "function": "voxels, v-construction", "star": "lower", "betti": [1, 0, 0],
        "diagram": [pair(0.0, None, [0, 0], None), pair(1.0, Some(5.0), [0, 2], Some([0, 1]))],
    });
    let mut whole = certificate(input, "", &answer, &Value::Null);
    whole["kind"] = json!("image");
    whole["first_fastest"] = json!(false);
    // Both edges enter with the middle: the second one ends the class of the last pixel, and so does the path of both.
    whole["proof"] = json!({"order": [[0, 2, 1], [0, 1]], "chains": [[[[1, 0]], [[1, 0], [1, 1]]]]});
    let proved = verdict(input, &whole, "", &Value::Null).expect("the true one is verified");
    assert_eq!(
        proved[0],
        "the image has 1 x 3 voxels, which are vertices, and sublevel sets of their values grow"
    );
    for (place, value, step) in [
        ("/answer/diagram/1/birth", json!(0.0), "answer"),
        ("/answer/diagram/1/death", json!(4.0), "answer"),
        ("/answer/diagram/1/death", Value::Null, "answer"),
        ("/answer/diagram/1/death_cell", json!([0, 2]), "answer"),
        ("/answer/diagram/1/birth_cell", json!([0, 0]), "answer"),
        ("/answer/diagram/1/birth_cell", json!([0, 3]), "answer"),
        ("/answer/diagram/1/degree", json!(1), "answer"),
        ("/answer/diagram/1/degree", json!(7), "answer"),
        ("/answer/diagram", json!([]), "answer"),
        ("/answer/betti", json!([1, 0]), "answer"),
        ("/answer/betti", json!([2, 0, 0]), "answer"),
        ("/answer/star", json!("upper"), "order"),
        ("/answer/star", Value::Null, "answer"),
        ("/answer/function", json!("voxels, t-construction"), "order"),
        ("/answer/field", json!(1), "answer"),
        ("/first_fastest", json!(true), "answer"),
        ("/min_persistence", json!(4.0), "answer"),
        ("/proof/order/0", json!([0, 1, 2]), "order"),
        ("/proof/chains/0", json!([[[1, 0]], [[1, 1]]]), "chains"),
        ("/proof/chains/0", json!([[[1, 0]]]), "chains"),
    ] {
        assert_eq!(verdict(input, &whole, place, &value), Err(step.to_owned()), "{place}: {value}");
    }
}

/// A disk of one triangle, whose rim is a loop from 1 on, and bounds at 5, by hand.
#[test]
fn forged_images_of_parts_are_refused() {
    let input = "[[0,1,2]]";
    let pair = |degree: u32, birth: f64, death: Option<f64>, from: Value, to: Value| json!({"degree": degree, "birth": birth, "death": death, "birth_cell": from, "death_cell": to});
    let answer = json!({
        "file": "a.json", "field": 2, "function": "values.json", "star": null, "betti": [1, 0, 0], "image_of": "boundary",
        "diagram": [
            pair(0, 0.0, None, json!([0]), Value::Null), pair(0, 0.0, Some(1.0), json!([1]), json!([0, 1])),
            pair(0, 0.0, Some(1.0), json!([2]), json!([0, 2])), pair(1, 1.0, Some(5.0), json!([1, 2]), json!([0, 1, 2])),
        ],
    });
    let mut whole = certificate(input, "", &answer, &Value::Null);
    whole["kind"] = json!("persistence");
    whole["part"] = json!("boundary");
    let edges = json!([[[1, 0]], [[1, 1]]]);
    whole["proof"] = json!({
        "values": [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0], [5.0]], "order": [[0, 1, 2], [0, 1, 2], [0]],
        "chains": [edges, [[[1, 0]]]], "image_chains": [edges, [[[1, 0]]]],
        "part_chains": [[[[1, 0]], [[1, 1]], [[1, 0], [1, 1], [1, 2]]], []],
    });
    let proved = verdict(input, &whole, "", &Value::Null).expect("the true one is verified");
    assert_eq!(
        proved[0],
        "the diagram is of the image of a part in the whole, which is the boundary of the whole: [3, 3, 0] cells of degrees 0, 1, .."
    );
    for (place, value, step) in [
        ("/answer/diagram/3/death", json!(4.0), "answer"),
        ("/answer/diagram/3/death", Value::Null, "answer"),
        ("/answer/diagram/3/birth_cell", json!([0, 1]), "answer"),
        ("/answer/betti", json!([1, 1, 0]), "answer"),
        ("/answer/image_of", json!("rim"), "part"),
        ("/answer/image_of", Value::Null, "part"),
        ("/part", json!("file"), "part"),
        ("/part", Value::Null, "part"),
        ("/proof/part_chains/0", json!([[[1, 0]], [[1, 1]]]), "chains"),
        ("/proof/part_chains/0/2", json!([[1, 0], [1, 2]]), "chains"),
        ("/proof/image_chains/1", json!([]), "image_chains"),
        ("/proof/image_chains/1", json!([[[1, 0]], [[1, 0]]]), "image_chains"),
        ("/proof/image_chains/0", json!([[[1, 0]], [[1, 2]]]), "image_chains"),
        ("/proof/image_chains", json!([edges]), "image_chains"),
        ("/proof/chains/1", json!([]), "chains"),
    ] {
        assert_eq!(verdict(input, &whole, place, &value), Err(step.to_owned()), "{place}: {value}");
    }
    // Relative to the rim only the triangle is left, alone in its degree.
    let mut answer = answer;
    answer["image_of"] = Value::Null;
    answer["relative_to"] = json!("boundary");
    answer["betti"] = json!([0, 0, 1]);
    answer["diagram"] = json!([pair(2, 5.0, None, json!([0, 1, 2]), Value::Null)]);
    whole["answer"] = answer;
    whole["proof"]["order"] = json!([[], [], [0]]);
    whole["proof"]["chains"] = json!([[], [[[1, 0]]]]);
    let proved = verdict(input, &whole, "", &Value::Null).expect("the true one is verified");
    assert!(proved[0].contains("of the whole relative to a part"), "{proved:?}");
    for (place, value, step) in [
        ("/answer/diagram/0/birth", json!(1.0), "answer"),
        ("/answer/diagram/0/birth_cell", json!([0, 1]), "answer"),
        ("/answer/betti", json!([0, 1, 1]), "answer"),
        ("/answer/relative_to", json!("other"), "part"),
        ("/proof/order", json!([[0, 1, 2], [0, 1, 2], [0]]), "order"),
        ("/proof/chains/1", json!([]), "chains"),
    ] {
        assert_eq!(verdict(input, &whole, place, &value), Err(step.to_owned()), "{place}: {value}");
    }
}

#[test]
fn arrays_and_grey_maps_are_read_as_they_are() {
    use coface_check_persistence::Image;
    let array = |header: &str, data: &[u8]| {
        [&b"\x93NUMPY\x01\x00"[..], &(header.len() as u16).to_le_bytes(), header.as_bytes(), data].concat()
    };
    let header = |kind: &str, order: &str, shape: &str| {
        format!("{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}\n")
    };
    let counts = |bytes: &[u8]| {
        Image::read(bytes).and_then(|image| image.cells(true, false)).map(|cells| cells.0.counts().to_vec())
    };
    assert_eq!(counts(&array(&header("|u1", "False", "(2, 2)"), &[1, 2, 3, 4])), Ok(vec![4, 4, 1]));
    assert_eq!(counts(&array(&header("<f4", "False", "(2,)"), &[0; 8])), Ok(vec![2, 1]));
    // A voxel that is no number is not there.
    let numbers = [1.0, f64::NAN, 2.0].map(f64::to_le_bytes).concat();
    assert_eq!(counts(&array(&header("<f8", "False", "(3,)"), &numbers)), Ok(vec![2]));
    assert_eq!(counts(b"P5 2 1 255\n\x01\x02"), Ok(vec![2, 1]));
    for bytes in [
        array(&header("|u1", "True", "(2, 2)"), &[1, 2, 3, 4]),
        array(&header(">u2", "False", "(1,)"), &[1, 2]),
        array(&header("|u1", "False", "(2, 2)"), &[1, 2, 3]),
        array(&header("|u1", "False", "(99999999999, 99999999999)"), &[1]),
        array(&header("<f8", "False", "(1,)"), &f64::INFINITY.to_le_bytes()),
        array("'shape'", &[]),
        b"\x93NUMPY".to_vec(),
        b"P2 2 2 9 1 2 3".to_vec(),
        b"P5 2 1 255\n\x01\x02\x03".to_vec(),
        b"P5 2 1 65535\n\x01\x02\x03\x04".to_vec(),
        b"P3 1 1 9 1 1 1".to_vec(),
        Vec::new(),
    ] {
        assert!(Image::read(&bytes).is_err(), "{bytes:?}");
    }
    let wide = array(&header("|u1", "False", "(3000, 3000)"), &vec![0; 9_000_000]);
    assert!(Image::read(&wide).expect("an array").cells(false, false).is_err());
}

/// A right triangle, whose longest side has the same circle as its inside, by hand.
#[test]
fn forged_alpha_complexes_are_refused() {
    let input = "0 0\n4 0\n0 4\n";
    let pair = |death: Value, from: u32, to: Value| json!({"degree": 0, "birth": 0.0, "death": death, "birth_cell": [from], "death_cell": to});
    let answer = json!({
        "field": 2, "function": "squared radii of the alpha complex", "star": null, "betti": [1, 0, 0],
        "diagram": [pair(Value::Null, 0, Value::Null), pair(json!(4.0), 1, json!([0, 1])), pair(json!(4.0), 2, json!([0, 2]))],
    });
    let mut whole = certificate(input, "points", &answer, &Value::Null);
    whole["kind"] = json!("persistence");
    whole["facets"] = json!([[0, 1, 2]]);
    whole["proof"] = json!({
        "values": [[0.0, 0.0, 0.0], [4.0, 4.0, 8.0], [8.0]], "order": [[0, 1, 2], [0, 1, 2], [0]],
        "chains": [[[[1, 0]], [[1, 1]]], [[[1, 0]]]],
    });
    let proved = verdict(input, &whole, "", &Value::Null).expect("the true one is verified");
    assert!(
        proved[0].starts_with("the simplices are a Delaunay triangulation of 3 points with 2 coordinates"),
        "{proved:?}"
    );
    for (place, value) in [
        ("/proof/values/1/0", json!(4.000_000_000_000_001)),
        ("/proof/values/1/2", json!(7.999_999_999_999_999)),
        ("/proof/values/2/0", json!(8.000_000_000_000_002)),
        ("/proof/values/0/0", json!(-5e-324)),
        ("/facets", json!([[0, 1, 3]])),
        ("/layout", json!("square")),
    ] {
        let step = if place == "/layout" { Ok(proved.clone()) } else { Err("alpha".to_owned()) };
        assert_eq!(verdict(input, &whole, place, &value), step, "{place}: {value}");
    }
    // What is wrong with a triangulation of other points; values are looked at last.
    let said = |input: &str, facets: Value, counts: [usize; 3]| {
        let mut whole = certificate(input, "points", &answer, &Value::Null);
        whole["kind"] = json!("persistence");
        whole["proof"] = json!({"values": counts.map(|count| vec![1.0; count]), "order": [], "chains": []});
        whole["facets"] = facets;
        check(whole.to_string().as_bytes(), &[input.as_bytes()]).expect_err("it is false").to_string()
    };
    let square = "0 0\n1 0\n1 1\n0 1\n";
    let kite = "0 0\n1 -3\n2 0\n1 3\n";
    for (input, facets, counts, why) in [
        (square, json!([[0, 1, 2], [0, 2, 3]]), [4, 5, 2], "the value of the simplex"),
        (kite, json!([[0, 1, 2], [0, 2, 3]]), [4, 5, 2], "the value of the simplex"),
        (kite, json!([[0, 1, 3], [1, 2, 3]]), [4, 5, 2], "a point is inside of the sphere"),
        // Both diagonals: on each side of the square two triangles are on one side of it.
        (square, json!([[0, 1, 2], [0, 2, 3], [0, 1, 3], [1, 2, 3]]), [4, 6, 4], "from both sides"),
        (square, json!([[0, 1, 2], [3]]), [4, 3, 1], "is no face of one of the highest degree"),
        (square, json!([[0, 1, 2], [0, 3]]), [4, 4, 1], "is no face of one of the highest degree"),
        (square, json!([[0, 1, 2]]), [3, 3, 1], "a point is no vertex"),
        ("0 0\n1 0\n2 0\n", json!([[0, 1, 2]]), [3, 3, 1], "a simplex is flat"),
        (
            "0 0\n4 0\n4 4\n0 4\n1 2\n",
            json!([[0, 1, 4], [1, 2, 4], [2, 3, 4]]),
            [5, 7, 3],
            "has a point in front of it",
        ),
        ("0 0\n1 0\n0 1\n0 1\n", json!([[0, 1, 2], [0, 1, 3]]), [4, 5, 2], "two vertices are at one place"),
        ("0 0 0\n1 0 0\n0 1 0\n", json!([[0, 1, 2]]), [3, 3, 1], "do not fill a part of the space"),
    ] {
        let found = said(input, facets, counts);
        assert!(found.contains(why), "{input}: {found}");
    }
}

/// A certificate of the vertices of an edge as points, by listed simplices.
fn unchecked(more: &str, answer: &str) -> Result<Vec<String>, String> {
    let input = b"[[0,1]]";
    let hash = coface_check::sha256(input);
    let certificate = format!(
        r#"{{"coface_certificate":1,"kind":"persistence","inputs":[{{"name":"a.json","sha256":"{hash}"}}],"min_persistence":0.0,{more},
            "answer":{{"file":"a.json","field":2,{answer}"betti":[1],"diagram":[
                {{"degree":0,"birth":0.0,"death":null,"birth_cell":[0],"death_cell":null}}],"remarks":[]}},
            "proof":{{"values":[[0.0]],"order":[[0]],"chains":[]}}}}"#
    );
    let verdict = coface_check_persistence::check(certificate.as_bytes(), &[input])
        .map_err(|fault| fault.to_string())?;
    Ok(verdict.unchecked().to_vec())
}

/// Simplices that a certificate lists are not those of a complex in the input, and it is said that they come from nowhere.
#[test]
fn listed_simplices_are_no_claim_about_a_complex() {
    let simplices = r#""facets":[[0]]"#;
    assert_eq!(unchecked(simplices, "").expect("a point"), ["that these are the simplices of the input"]);
    let of_function = unchecked(simplices, r#""function":"vertex number","#).expect("a point");
    assert_eq!(of_function, ["function", "that these are the simplices of the input"]);
    let star = unchecked(simplices, r#""function":"vertex number","star":"lower","#);
    assert!(star.expect_err("a star is of a complex").contains("a star is of a function"));
    let chains = unchecked(r#""facets":{"boundaries":[]}"#, "");
    assert!(chains.expect_err("no simplices").contains("no list of facets"));
}
