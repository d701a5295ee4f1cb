//! `coface yin info --rule`: paths of cubic pieces that cross themselves, by all fill rules, against Green's theorem.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::Value;
use tempfile::TempDir;

fn info(path: &str, attributes: &str, more: &[&str]) -> Value {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("path.svg");
    let text = format!(r#"<svg xmlns="http://www.w3.org/2000/svg"><path d="{path}" {attributes}/></svg>"#);
    std::fs::write(&file, text).unwrap();
    coface(&[&["yin", "info", argument(&file), "--json", "--quiet"], more].concat()).json()
}

fn area(value: &Value) -> f64 {
    value["area"].as_f64().unwrap()
}

#[test]
fn an_eight_has_two_lobes() {
    // Of a cubic with both ends in the origin the area is 3 / 20 of the cross product of the other control points: 4.8 and -4.8.
    let eight = "M0 0 C4 4 4 -4 0 0 C-4 4 -4 -4 0 0 Z";
    for (rule, lobes) in [("nonzero", 2), ("evenodd", 2), ("positive", 1)] {
        let found = info(eight, "", &["--rule", rule]);
        assert!((area(&found) - 4.8 * f64::from(lobes)).abs() < 1e-12, "{rule}: {found}");
        assert_eq!(found["curve_counts"], serde_json::json!([lobes, 0]), "{rule}");
        assert_eq!(found["order"], 4);
        assert_eq!(found["betti_closed"], serde_json::json!([1, 0]));
    }
    assert_eq!(info(eight, "", &[])["curve_counts"], serde_json::json!([2, 0]));
}

#[test]
fn what_is_wound_around_twice() {
    // A loop with a loop inside: with areas A and B that it winds around once and twice, Green's theorem gives A + 2 B.
    let spiral = "M0 0 C8 0 8 8 0 8 C-8 8 -8 2 0 2 C4 2 4 6 0 6 C-8 6 -8 0 0 0 Z";
    let pieces: [[[f64; 2]; 4]; 4] = [
        [[0., 0.], [8., 0.], [8., 8.], [0., 8.]],
        [[0., 8.], [-8., 8.], [-8., 2.], [0., 2.]],
        [[0., 2.], [4., 2.], [4., 6.], [0., 6.]],
        [[0., 6.], [-8., 6.], [-8., 0.], [0., 0.]],
    ];
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let around: f64 = pieces
        .iter()
        .map(|&[a, b, c, d]| {
            (6.0 * (cross(a, b) + cross(c, d))
                + 3.0 * (cross(a, c) + cross(b, c) + cross(b, d))
                + cross(a, d))
                / 20.0
        })
        .sum();
    let [all, once] = ["nonzero", "evenodd"].map(|rule| info(spiral, &format!(r#"fill-rule="{rule}""#), &[]));
    assert_eq!(all["curve_counts"], serde_json::json!([1, 0]));
    assert!(
        (2.0 * area(&all) - area(&once) - around.abs()).abs() < 1e-10,
        "{} {} {around}",
        area(&all),
        area(&once)
    );
    assert!(area(&once) < area(&all) - 1.0);
    // The rule that is asked for goes before that of the file.
    let asked = info(spiral, r#"fill-rule="evenodd""#, &["--rule", "nonzero"]);
    assert_eq!(area(&asked), area(&all));
    let turned = info(spiral, "", &["--rule", "positive"]);
    assert!(area(&turned) == area(&all) || turned["empty"] == true);
}

#[test]
fn a_rule_that_does_not_exist_is_wrong_usage() {
    let run = coface(&["yin", "info", "none.svg", "--rule", "negative"]);
    assert!(run.fails_with(2).contains("nonzero"));
}
