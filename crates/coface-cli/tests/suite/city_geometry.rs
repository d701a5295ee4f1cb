//! Rings, shells and solids of CityJSON by the codes of ISO 19107.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};

/// Vertices that are numbered as they come.
#[derive(Default)]
struct City(Vec<[i64; 3]>);

impl City {
    fn vertex(&mut self, point: [i64; 3]) -> usize {
        self.0.iter().position(|&own| own == point).unwrap_or_else(|| {
            self.0.push(point);
            self.0.len() - 1
        })
    }

    /// The six sides of a box, looking outward or inward.
    fn shell(&mut self, low: [i64; 3], high: [i64; 3], is_outward: bool) -> Vec<Value> {
        let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let side = |mut corners: [usize; 4]| {
            if !is_outward {
                corners.reverse();
            }
            let place = |corner: usize| {
                [0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] })
            };
            json!([corners.map(|corner| self.vertex(place(corner)))])
        };
        sides.map(side).to_vec()
    }

    fn ring(&mut self, corners: &[[i64; 2]], z: i64) -> Value {
        json!(corners.iter().map(|&[x, y]| self.vertex([x, y, z])).collect::<Vec<_>>())
    }

    /// The report on one geometry.
    fn report(self, kind: &str, boundaries: &Value) -> Value {
        self.asked(kind, boundaries, |path| coface(&["info", path, "--json"]).json())
    }

    /// What is asked of the file with one geometry.
    fn asked<T>(self, kind: &str, boundaries: &Value, ask: impl FnOnce(&str) -> T) -> T {
        let geometry = json!({"type": kind, "lod": "2", "boundaries": boundaries});
        let city = json!({"type": "CityJSON", "version": "2.0", "transform": {"scale": [1, 1, 1], "translate": [0, 0, 0]},
            "CityObjects": {"b": {"type": "Building", "geometry": [geometry]}}, "vertices": self.0});
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("b.city.json");
        std::fs::write(&path, city.to_string()).unwrap();
        ask(argument(&path))
    }
}

fn codes(report: &Value, of: &[&str]) -> Vec<i64> {
    let faults = report["geometry"]["faults"].as_array().unwrap().iter();
    let wanted = faults.filter(|fault| of.contains(&fault["of"].as_str().unwrap()));
    let mut codes: Vec<i64> = wanted.map(|fault| fault["code"].as_i64().unwrap()).collect();
    codes.sort_unstable();
    codes
}

fn rectangle([x, y]: [i64; 2], [to_x, to_y]: [i64; 2]) -> Vec<[i64; 2]> {
    vec![[x, y], [x, to_y], [to_x, to_y], [to_x, y]]
}

#[test]
fn rings_are_named_by_their_codes() {
    let reversed = |mut ring: Vec<[i64; 2]>| {
        ring.reverse();
        ring
    };
    type Case = (&'static str, Vec<Vec<[i64; 2]>>, &'static [i64]);
    let cases: [Case; 14] = [
        ("inside", vec![rectangle([2, 2], [4, 4])], &[]),
        ("touches in a point", vec![vec![[0, 5], [2, 7], [4, 5], [2, 3]]], &[]),
        ("outside", vec![rectangle([12, 2], [14, 4])], &[206]),
        ("nested", vec![rectangle([2, 2], [8, 8]), rectangle([4, 4], [6, 6])], &[207]),
        ("cross", vec![rectangle([2, 2], [6, 6]), rectangle([4, 4], [8, 8])], &[201]),
        ("crosses the outer ring", vec![rectangle([8, 2], [12, 4])], &[201]),
        ("twice", vec![rectangle([2, 2], [4, 4]), rectangle([2, 2], [4, 4])], &[202]),
        ("shares a side", vec![rectangle([0, 2], [4, 4])], &[201]),
        ("cuts in two", vec![vec![[0, 5], [5, 7], [10, 5], [5, 3]]], &[205]),
        ("runs as the outer ring", vec![reversed(rectangle([2, 2], [4, 4]))], &[208]),
        ("bow", vec![vec![[2, 2], [4, 4], [4, 2], [2, 4]]], &[104]),
        ("two points", vec![vec![[2, 2], [4, 4]]], &[101]),
        ("repeats a point", vec![vec![[2, 2], [2, 4], [2, 4], [4, 4], [4, 2]]], &[102]),
        (
            "three rings around a face",
            vec![
                vec![[2, 2], [5, 6], [8, 2], [5, 3]],
                vec![[2, 2], [2, 8], [3, 7]],
                vec![[2, 8], [8, 8], [8, 2], [7, 7]],
            ],
            &[205],
        ),
    ];
    for (name, holes, expected) in cases {
        let mut city = City::default();
        let outer = city.ring(&[[0, 0], [10, 0], [10, 10], [0, 10]], 0);
        let rings: Vec<Value> =
            [outer].into_iter().chain(holes.iter().map(|hole| city.ring(hole, 0))).collect();
        let report = city.report("MultiSurface", &json!([rings]));
        assert_eq!(codes(&report, &["surface"]), expected, "{name}: {report}");
    }
}

/// Polygons without the holes of their surfaces are no solid to compute with.
#[test]
fn surfaces_without_their_holes_are_cut_with_nothing() {
    let mut city = City::default();
    let mut shell = city.shell([0; 3], [10; 3], true);
    let hole = city.ring(&rectangle([8, 2], [12, 4]), 10);
    shell[1].as_array_mut().unwrap().push(hole);
    city.asked("Solid", &json!([shell]), |path| {
        let run = coface(&["boolean", "union", path]);
        let refusal = run.fails_with(1);
        assert!(refusal.contains("1 surface has holes that cross or touch its rings"), "{refusal}");
        assert!(coface(&["arrange", path]).fails_with(1).contains("mend these holes"));
        assert_eq!(codes(&coface(&["info", path, "--json"]).json(), &["surface"]), [201]);
    });
}

#[test]
fn shells_are_named_by_their_codes() {
    type Shells = fn(&mut City) -> Vec<Vec<Value>>;
    let cases: [(&str, Shells, &[i64]); 14] = [
        ("a void", |city| vec![city.shell([0; 3], [10; 3], true), city.shell([3; 3], [6; 3], false)], &[]),
        (
            "a void that looks outward",
            |city| vec![city.shell([0; 3], [10; 3], true), city.shell([3; 3], [6; 3], true)],
            &[405],
        ),
        (
            "a void outside",
            |city| vec![city.shell([0; 3], [10; 3], true), city.shell([13, 3, 3], [16, 6, 6], false)],
            &[403],
        ),
        (
            "a void across the outer shell",
            |city| vec![city.shell([0; 3], [10; 3], true), city.shell([8, 3, 3], [16, 6, 6], false)],
            &[401],
        ),
        (
            "equal voids",
            |city| {
                let void = city.shell([3; 3], [6; 3], false);
                vec![city.shell([0; 3], [10; 3], true), void.clone(), void]
            },
            &[402],
        ),
        (
            "equal voids, one with other first corners",
            |city| {
                let void = city.shell([3; 3], [6; 3], false);
                let mut other = void.clone();
                for face in &mut other {
                    face[0].as_array_mut().unwrap().rotate_left(1);
                }
                vec![city.shell([0; 3], [10; 3], true), void, other]
            },
            &[402],
        ),
        (
            "a void that is all of the solid",
            |city| vec![city.shell([0; 3], [10; 3], true), city.shell([0; 3], [10; 3], false)],
            &[402],
        ),
        (
            "voids that cross",
            |city| {
                let voids = [[2; 3], [4; 3]].map(|low| city.shell(low, low.map(|x| x + 4), false));
                [vec![city.shell([0; 3], [10; 3], true)], voids.to_vec()].concat()
            },
            &[401],
        ),
        (
            "voids with a common face",
            |city| {
                let voids = [[2; 3], [4, 2, 2]].map(|low| city.shell(low, low.map(|x| x + 2), false));
                [vec![city.shell([0; 3], [10; 3], true)], voids.to_vec()].concat()
            },
            &[401],
        ),
        (
            "voids that touch in a point",
            |city| {
                let voids = [[2; 3], [4; 3]].map(|low| city.shell(low, low.map(|x| x + 2), false));
                [vec![city.shell([0; 3], [10; 3], true)], voids.to_vec()].concat()
            },
            &[],
        ),
        (
            "an open void",
            |city| {
                let void = city.shell([3; 3], [6; 3], false)[1..].to_vec();
                vec![city.shell([0; 3], [10; 3], true), void]
            },
            &[302],
        ),
        (
            "a void of three faces",
            |city| {
                let void = city.shell([3; 3], [6; 3], false)[..3].to_vec();
                vec![city.shell([0; 3], [10; 3], true), void]
            },
            &[301],
        ),
        (
            "two pieces in one shell",
            |city| vec![[city.shell([0; 3], [10; 3], true), city.shell([20; 3], [30; 3], true)].concat()],
            &[305],
        ),
        (
            "a lid over a hole that is not there",
            |city| {
                let mut shell = city.shell([0; 3], [10; 3], true);
                let hole = city.ring(&rectangle([3, 3], [6, 6]), 10);
                shell[1].as_array_mut().unwrap().push(hole);
                vec![shell]
            },
            &[302],
        ),
    ];
    for (name, shells, expected) in cases {
        let mut city = City::default();
        let boundaries = json!(shells(&mut city));
        let report = city.report("Solid", &boundaries);
        assert_eq!(codes(&report, &["surface", "solid"]), expected, "{name}: {report}");
        assert_eq!(report["geometry"]["valid_solid"], json!(expected.is_empty()), "{name}");
    }
}

/// What a geometry is meant to be says which codes are looked for.
#[test]
fn the_codes_are_those_of_the_scope() {
    let solids = |shells: &[Vec<Value>]| json!(shells.iter().map(|shell| json!([shell])).collect::<Vec<_>>());
    let cases: [(&str, [i64; 3], &[i64]); 5] = [
        ("CompositeSolid", [10, 0, 0], &[]),
        ("CompositeSolid", [5, 0, 0], &[501]),
        ("CompositeSolid", [0, 0, 0], &[502]),
        ("CompositeSolid", [10, 10, 0], &[503]),
        ("MultiSolid", [5, 0, 0], &[]),
    ];
    for (kind, low, expected) in cases {
        let mut city = City::default();
        let shells = [city.shell([0; 3], [10; 3], true), city.shell(low, low.map(|x| x + 10), true)];
        let report = city.report(kind, &solids(&shells));
        assert_eq!(codes(&report, &["surface", "solid"]), expected, "{kind} {low:?}: {report}");
        assert_eq!(report["geometry"]["valid_solid"], json!(expected.is_empty()), "{kind} {low:?}");
    }
    // A box without a side, and the same with a face that crosses it.
    for (kind, is_crossed, expected) in [
        ("MultiSurface", false, &[][..]),
        ("MultiSurface", true, &[]),
        ("CompositeSurface", false, &[]),
        ("CompositeSurface", true, &[303, 306]),
    ] {
        let mut city = City::default();
        let mut faces = city.shell([0; 3], [10; 3], true)[1..].to_vec();
        if is_crossed {
            let corners = [[-5, 5, 5], [5, 5, 5], [5, 8, 5]].map(|point| city.vertex(point));
            let joined = [city.vertex([0, 0, 10]), corners[0], corners[2]];
            faces.extend([json!([corners]), json!([joined])]);
        }
        let report = city.report(kind, &json!(faces));
        let found = codes(&report, &["surface", "solid"]);
        assert_eq!(found, expected, "{kind}: {report}");
        assert_eq!(report["geometry"]["valid_solid"], json!(false), "{kind}");
    }
}

/// A hole through a block, and solids beside each other and in the void of another, have no faults.
#[test]
fn tunnels_and_solids_in_one_object_are_sound() {
    let mut city = City::default();
    let mut tunnel = city.shell([0; 3], [10; 3], true);
    for (side, mut hole, z) in [(1, rectangle([3, 3], [6, 6]), 10), (0, rectangle([3, 3], [6, 6]), 0)] {
        if z == 0 {
            hole.reverse();
        }
        let hole = city.ring(&hole, z);
        tunnel[side].as_array_mut().unwrap().push(hole);
    }
    tunnel.extend(city.shell([3, 3, 0], [6, 6, 10], false).split_off(2));
    let report = city.report("Solid", &json!([tunnel]));
    assert_eq!(codes(&report, &["surface", "solid"]), [0; 0], "{report}");
    assert_eq!((&report["name"], &report["signed_volume"]), (&json!("torus"), &json!(910.0)));

    let mut city = City::default();
    let shells = [
        vec![city.shell([0; 3], [10; 3], true), city.shell([2; 3], [8; 3], false)],
        vec![city.shell([3; 3], [6; 3], true)],
        vec![city.shell([10, 0, 0], [20, 10, 10], true)],
    ];
    let report = city.report("MultiSolid", &json!(shells));
    assert_eq!(codes(&report, &["surface", "solid"]), [0; 0], "{report}");
}
