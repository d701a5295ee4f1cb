//! Homology of physical groups of a mesh, and generators as more of them: the case of Gmsh's tutorial t14, whose ranks Gmsh 4.15.2 finds as
//! well, by second methods on the elements of the files alone.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use coface::io::{GroupKind, Model, read_path};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::PathBuf;

/// How many cubes the square has along a side, and the plate above it.
const SIDE: usize = 5;

/// The plate 10 x 10 x 2 of t14 with a hole of 2 x 2 through its middle, in cubes of side 2 and six tetrahedra each. The terminals 70 to 73
/// are at the corners of two opposite sides; 75 is the rest of the surface and 80 all of it.
fn plate() -> String {
    let is_in = |x: usize, y: usize| x < SIDE && y < SIDE && (x, y) != (2, 2);
    let node = |corner: [usize; 3]| 1 + corner[0] + (SIDE + 1) * (corner[1] + (SIDE + 1) * corner[2]);
    let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let walk = |start: [usize; 3], axes: &[usize]| {
        let mut corner = start;
        let steps = axes.iter().map(|&axis| {
            corner[axis] += 1;
            node(corner)
        });
        std::iter::once(node(start)).chain(steps).collect::<Vec<_>>()
    };
    let (mut solids, mut faces) = (Vec::new(), Vec::new());
    let mut square = |start: [usize; 3], [a, b]: [usize; 2], group: u32| {
        faces.push((group, walk(start, &[a, b])));
        faces.push((group, walk(start, &[b, a])));
    };
    for (x, y) in (0..SIDE).flat_map(|x| (0..SIDE).map(move |y| (x, y))).filter(|&(x, y)| is_in(x, y)) {
        for (i, order) in orders.iter().enumerate() {
            let mut solid = walk([x, y, 0], order);
            if i > 2 {
                solid.swap(1, 2);
            }
            solids.push(solid);
        }
        square([x, y, 0], [0, 1], 75);
        square([x, y, 1], [0, 1], 75);
        let corner = |low: u32, high: u32| match x {
            0 => low,
            4 => high,
            _ => 75,
        };
        if x == 0 || !is_in(x - 1, y) {
            square([x, y, 0], [1, 2], 75);
        }
        if !is_in(x + 1, y) {
            square([x + 1, y, 0], [1, 2], 75);
        }
        if y == 0 || !is_in(x, y - 1) {
            square([x, y, 0], [0, 2], if y == 0 { corner(71, 72) } else { 75 });
        }
        if !is_in(x, y + 1) {
            square([x, y + 1, 0], [0, 2], if y + 1 == SIDE { corner(70, 73) } else { 75 });
        }
    }
    let mut text =
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"plate\"\n2 75 \"insulation\"\n\
        $EndPhysicalNames\n$Nodes\n72\n"
            .to_owned();
    for (z, y, x) in (0..72).map(|i| (i / 36, i / 6 % 6, i % 6)) {
        writeln!(text, "{} {} {} {}", node([x, y, z]), 2 * x, 2 * y, 2 * z).unwrap();
    }
    write!(text, "$EndNodes\n$Elements\n{}\n", solids.len() + 2 * faces.len()).unwrap();
    let words = |nodes: &[usize]| nodes.iter().map(usize::to_string).collect::<Vec<_>>().join(" ");
    let mut tag = 0;
    for (group, nodes) in &faces {
        for group in [*group, 80] {
            tag += 1;
            writeln!(text, "{tag} 2 2 {group} {group} {}", words(nodes)).unwrap();
        }
    }
    for nodes in &solids {
        tag += 1;
        writeln!(text, "{tag} 4 2 1 1 {}", words(nodes)).unwrap();
    }
    text + "$EndElements\n"
}

fn files() -> (tempfile::TempDir, PathBuf, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let (mesh, out) = (folder.path().join("t14.msh"), folder.path().join("out.msh"));
    std::fs::write(&mesh, plate()).unwrap();
    (folder, mesh, out)
}

fn bettis(answer: &Value) -> Vec<u64> {
    answer["homology"].as_array().unwrap().iter().map(|group| group["betti"].as_u64().unwrap()).collect()
}

/// The elements of a group, by their vertices.
fn elements(model: &Model, name: &str) -> Vec<Vec<u32>> {
    let group = model.groups().iter().find(|group| group.name() == name).unwrap();
    let lists = match group.kind() {
        GroupKind::Lines => model.lines(),
        GroupKind::Polygons => model.polygons(),
        _ => model.cells(),
    };
    group.members().iter().map(|&i| lists.list(i as usize).to_vec()).collect()
}

/// The sum of the elements as a chain on edges in rising order.
fn edge_chain(lines: &[Vec<u32>]) -> BTreeMap<[u32; 2], i64> {
    let mut chain = BTreeMap::new();
    for line in lines {
        let (low, high) = (line[0].min(line[1]), line[0].max(line[1]));
        *chain.entry([low, high]).or_insert(0) += if line[0] == low { 1 } else { -1 };
    }
    chain
}

/// The vertices and the edges, in rising order, of the triangles of groups.
fn skeleton(model: &Model, names: &[&str]) -> (BTreeSet<u32>, BTreeSet<[u32; 2]>) {
    let triangles: Vec<Vec<u32>> = names.iter().flat_map(|name| elements(model, name)).collect();
    let edges = triangles.iter().flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]);
    let edges = edges.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    (triangles.into_iter().flatten().collect(), edges)
}

fn determinant(mut rows: Vec<Vec<f64>>) -> f64 {
    let mut product = 1.0;
    for i in 0..rows.len() {
        let Some(pivot) = (i..rows.len()).find(|&r| rows[r][i] != 0.0) else { return 0.0 };
        if pivot != i {
            rows.swap(i, pivot);
            product = -product;
        }
        product *= rows[i][i];
        for r in i + 1..rows.len() {
            let factor = rows[r][i] / rows[i][i];
            let pivot = rows[i].clone();
            for (x, y) in rows[r].iter_mut().zip(pivot) {
                *x -= factor * y;
            }
        }
    }
    product
}

const TERMINALS: [&str; 4] = ["70", "71", "72", "73"];

#[test]
fn the_ranks_of_t14_are_those_of_gmsh() {
    let (_folder, mesh, _) = files();
    let mesh = argument(&mesh);
    // `gmsh t14.geo -3`: H_1({1},{70,71,72,73}) and H_2({1},{75}) have rank 4, and the other spaces of the pairs are 0.
    for (arguments, expected) in [
        (&["--domain", "1"][..], [1, 1, 0, 0]),
        (&["--domain", "plate", "--relative", "70,71,72,73"], [0, 4, 0, 0]),
        (&["--relative", "70", "--relative", "71", "--relative", "72,73"], [0, 4, 0, 0]),
        (&["--domain", "plate", "--relative", "insulation"], [0, 0, 4, 0]),
        (&["--domain", "1", "--relative", "75", "--cohomology"], [0, 0, 4, 0]),
        (&["--domain", "1", "--relative", "80"], [0, 0, 1, 1]),
        (&["--domain", "1", "--relative", "boundary"], [0, 0, 1, 1]),
        (&["--domain", "80"], [1, 2, 1, 0]),
        (&["--domain", "70", "--relative", "boundary"], [0, 0, 1, 0]),
        (&["--domain", "70,71"], [2, 0, 0, 0]),
    ] {
        let answer = coface(&[&["homology", mesh, "--json"], arguments].concat()).json();
        assert_eq!(bettis(&answer), expected, "{arguments:?}");
    }
}

#[test]
fn thin_and_thick_cuts_are_written_as_physical_groups_and_pair_up() {
    let (folder, mesh, thin) = files();
    let thick = folder.path().join("thick.msh");
    let pair = ["--domain", "plate", "--relative", "70,71,72,73"];
    let answer =
        coface(&[&["homology", argument(&mesh), "--json", "-o", argument(&thin)], &pair[..]].concat()).json();
    let groups = answer["physical_groups"].as_array().unwrap();
    assert_eq!((&groups[0]["name"], &groups[0]["tag"]), (&"H_1{1},{70,71,72,73}1".into(), &81.into()));
    coface(
        &[&["homology", argument(&thin), "--cohomology", "--json", "-o", argument(&thick)], &pair[..]]
            .concat(),
    )
    .json();
    let model = read_path(&thick, None).unwrap();
    // Asked again of what was written, the same groups take the place of the old ones.
    let again = folder.path().join("again.msh");
    for dual in [&["--cohomology"][..], &[]] {
        let words = [&["homology", argument(&thick), "-o", argument(&again), "-q"], dual, &pair[..]].concat();
        let run = coface(&words);
        assert_eq!(run.status, 0, "{}", run.stderr);
        let names = |model: &Model| {
            let mut names: Vec<String> = model.groups().iter().map(|group| group.name().to_owned()).collect();
            names.sort();
            names
        };
        assert_eq!(names(&read_path(&again, None).unwrap()), names(&model));
    }
    let tag = |name: &str| model.groups().iter().find(|group| group.name() == name).unwrap().number();
    assert_eq!((tag("insulation"), tag("70"), tag("H^1{1},{70,71,72,73}4")), (Some(75), Some(70), Some(88)));
    let (terminal_vertices, terminal_edges) = skeleton(&model, &TERMINALS);
    let cycles: Vec<_> =
        (1..=4).map(|i| edge_chain(&elements(&model, &format!("H_1{{1}},{{70,71,72,73}}{i}")))).collect();
    for cycle in &cycles {
        let mut sums: BTreeMap<u32, i64> = BTreeMap::new();
        for (&[a, b], x) in cycle {
            *sums.entry(a).or_default() -= x;
            *sums.entry(b).or_default() += x;
        }
        assert!(sums.iter().all(|(v, &x)| x == 0 || terminal_vertices.contains(v)), "{sums:?}");
    }
    let cocycles: Vec<_> =
        (1..=4).map(|i| edge_chain(&elements(&model, &format!("H^1{{1}},{{70,71,72,73}}{i}")))).collect();
    for cocycle in &cocycles {
        assert!(cocycle.keys().all(|edge| !terminal_edges.contains(edge)), "zero on the terminals");
        let value = |a: u32, b: u32| {
            let sign = if a < b { 1 } else { -1 };
            sign * cocycle.get(&[a.min(b), a.max(b)]).copied().unwrap_or(0)
        };
        for s in model.cells().iter() {
            for [a, b, c] in [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]].map(|face| face.map(|i| s[i])) {
                assert_eq!(value(a, b) + value(b, c) + value(c, a), 0, "closed on {a} {b} {c}");
            }
        }
    }
    let pairing = |cocycle: &BTreeMap<[u32; 2], i64>, cycle: &BTreeMap<[u32; 2], i64>| {
        cycle.iter().map(|(edge, x)| (x * cocycle.get(edge).copied().unwrap_or(0)) as f64).sum::<f64>()
    };
    let rows = cocycles.iter().map(|w| cycles.iter().map(|c| pairing(w, c)).collect()).collect();
    assert_eq!(determinant(rows).abs(), 1.0, "cocycles and cycles are bases of dual groups");
    // The values are data too, on the first element of each edge for its direction.
    let name = "H^1{1},{70,71,72,73}1";
    let data = model.data_named(name, GroupKind::Lines).unwrap();
    let values: f64 = (0..data.len()).map(|i| data.real_row(i)[0]).filter(|x| !x.is_nan()).sum();
    assert_eq!(values as usize, elements(&model, name).len());
    // What was written is read as chains.
    let name = "H_1{1},{70,71,72,73}2";
    let again =
        coface(&[&["homology", argument(&thick), "--json", "--cycle", name], &pair[..]].concat()).json();
    let class = again["cycles"][0]["class"].as_array().unwrap();
    assert!(class.iter().any(|x| x.as_i64() != Some(0)), "{class:?}");
    let test = coface(&["cocycles", argument(&thick), "--test", "H^1{1},{70,71,72,73}2", "--json"]).json();
    assert_eq!(test["closed"], true);
}

#[test]
fn surfaces_that_cut_are_bounded_by_the_insulation() {
    let (_folder, mesh, out) = files();
    coface(&[
        "homology",
        argument(&mesh),
        "--domain",
        "1",
        "--relative",
        "insulation",
        "--generators",
        argument(&out),
        "--json",
    ])
    .json();
    let model = read_path(&out, None).unwrap();
    let (_, insulation) = skeleton(&model, &["insulation"]);
    for i in 1..=4 {
        let faces = elements(&model, &format!("H_2{{1}},{{75}}{i}"));
        let sides = faces.iter().flat_map(|f| [vec![f[0], f[1]], vec![f[1], f[2]], vec![f[2], f[0]]]);
        let boundary = edge_chain(&sides.collect::<Vec<_>>());
        let rest: Vec<_> =
            boundary.iter().filter(|(edge, x)| **x != 0 && !insulation.contains(*edge)).collect();
        assert!(rest.is_empty() && boundary.values().any(|&x| x != 0), "{i}: {rest:?}");
    }
    // The copies of triangles are the same faces again.
    let again = coface(&["homology", argument(&out), "--json", "--domain", "1", "--relative", "75"]).json();
    assert_eq!(bettis(&again), [0, 0, 4, 0]);
}

#[test]
fn cocycles_of_a_pair_are_written_into_the_mesh() {
    let (_folder, mesh, out) = files();
    let arguments = ["--domain", "plate", "--relative", "70,71,72,73", "-o", argument(&out), "--json"];
    let answer = coface(&[&["cocycles", argument(&mesh)], &arguments[..]].concat()).json();
    assert_eq!((&answer["rank"], &answer["determinant"]), (&4.into(), &1.into()));
    let model = read_path(&out, None).unwrap();
    let edges = answer["cocycles"][2].as_array().unwrap();
    let total: u64 = edges.iter().map(|term| term[0].as_i64().unwrap().unsigned_abs()).sum();
    assert_eq!(elements(&model, "H^1{1},{70,71,72,73}3").len() as u64, total);
}

#[test]
fn unknown_groups_are_refused_with_those_that_there_are() {
    let (_folder, mesh, _) = files();
    for option in ["--domain", "--relative"] {
        let run = coface(&["homology", argument(&mesh), option, "terminal"]);
        let message = run.fails_with(1);
        assert!(
            message.contains("no group \"terminal\"") && message.contains("\"plate\" (1, cells)"),
            "{message}"
        );
        assert!(message.contains("\"insulation\" (75, polygons)"), "{message}");
    }
    let run = coface(&["homology", argument(&mesh), "--relative", "70,74"]);
    assert!(run.fails_with(1).contains("no group \"74\""));
    let run = coface(&["cocycles", argument(&mesh), "--domain", "air"]);
    assert!(run.fails_with(1).contains("no group \"air\""));
}
