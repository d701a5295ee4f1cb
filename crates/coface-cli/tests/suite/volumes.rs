//! Volumes of voxels through the program.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_reading};
use coface::complexes::cubical::CubicalVolume;
use coface::io::volume::write_npy;
use std::fs;
use std::path::Path;

/// Radii from the middle of 20 voxels along each axis, as 64-bit numbers in NumPy's format.
fn radii(path: &Path) {
    let text = "{'descr': '<f8', 'fortran_order': False, 'shape': (20, 20, 20), }";
    let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    bytes.extend(format!("{text:<117}\n").into_bytes());
    for at in 0..8000 {
        let square: f64 =
            [at / 400, at / 20 % 20, at % 20].map(|x| (f64::from(x) - 9.5).powi(2)).iter().sum();
        bytes.extend(square.sqrt().to_le_bytes());
    }
    fs::write(path, bytes).unwrap();
}

#[test]
fn thresholds_choose_the_voxels() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("radii.npy");
    radii(&path);
    let file = argument(&path);
    let betti = |options: &[&str]| -> Vec<u64> {
        let report = coface(&[&["homology", file, "--json"][..], options].concat()).json();
        report["homology"].as_array().unwrap().iter().map(|group| group["betti"].as_u64().unwrap()).collect()
    };
    assert_eq!(betti(&["--below", "8"]), [1, 0, 0, 0]);
    assert_eq!(betti(&["--between", "5", "8"]), [1, 0, 1, 0]);
    assert_eq!(betti(&["--threshold", "9"]), [1, 0, 1, 0]);
    // Eight corners.
    assert_eq!(betti(&["--threshold", "16"]), [8, 0, 0, 0]);
    assert_eq!(betti(&["--periodic", "x,1,2"]), [1, 3, 3, 1]);
    assert_eq!(betti(&["--between", "5", "8", "--cohomology", "--coefficients", "f2"]), [1, 0, 1, 0]);
    assert_eq!(betti(&["--between", "5", "8", "--reduced"]), [0, 0, 1, 0]);
    let report = coface(&["info", file, "--between", "5", "8", "--json"]).json();
    assert_eq!(report["kind"], "volume");
    assert_eq!(report["format"], "npy");
    assert_eq!(report["dimension"], 3);
    assert_eq!(report["components"], 1);
    assert_eq!(report["euler_characteristic"], 2);
    assert_eq!(report["homology"][2]["betti"], 1);
    let counts: Vec<i64> =
        report["f_vector"].as_array().unwrap().iter().map(|n| n.as_i64().unwrap()).collect();
    assert_eq!(counts[0] - counts[1] + counts[2] - counts[3], 2);
    assert_eq!(report["top_cells"][0]["shape"], "voxel");
    assert_eq!(report["top_cells"][0]["count"], counts[3]);
    let page = coface(&["info", file, "--between", "5", "8"]);
    assert!(page.stdout.contains("voxels"), "{}", page.stdout);
    // From standard input as well.
    let report = coface_reading(&["info", "-", "--below", "8", "--json"], &fs::read(&path).unwrap()).json();
    assert_eq!(report["euler_characteristic"], 1);
}

#[test]
fn generators_lie_on_the_cells() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ring.npy");
    let ring = CubicalVolume::new(&[3, 3], &[false; 2], |voxel| voxel != [1, 1]).unwrap();
    write_npy(&ring, fs::File::create(&path).unwrap()).unwrap();
    let report = coface(&["homology", argument(&path), "--json", "--generators"]).json();
    let chain = report["generators"][1][0]["chain"].as_array().unwrap();
    assert_eq!(chain.len(), 4, "around the hole: {chain:?}");
    let ends: Vec<u64> =
        chain.iter().flat_map(|term| term[1].as_array().unwrap()).map(|v| v.as_u64().unwrap()).collect();
    assert!(ends.iter().all(|v| ends.iter().filter(|w| *w == v).count() == 2), "{ends:?}");
}

#[test]
fn volumes_are_converted() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    radii(&path("radii.npy"));
    let convert = |to: &str, more: &[&str]| {
        let (from, to) = (path("radii.npy"), path(to));
        coface(
            &[&["convert", argument(&from), "--between", "5", "8", "-o", argument(&to)][..], more].concat(),
        )
    };
    assert_eq!(convert("shell.obj", &[]).status, 0);
    let report = coface(&["info", argument(&path("shell.obj")), "--json"]).json();
    assert_eq!(report["components"], 2);
    assert_eq!(report["manifold"]["closed"], true);
    assert_eq!(report["coherently_oriented"], true);
    assert_eq!(convert("mask.npy", &[]).status, 0);
    let report = coface(&["info", argument(&path("mask.npy")), "--json"]).json();
    assert_eq!(report["euler_characteristic"], 2);
    assert_eq!(report["signed_volume"], serde_json::Value::Null);
    assert_eq!(convert("shell.json", &[]).status, 0);
    let chains = coface(&["homology", argument(&path("shell.json")), "--json"]).json();
    assert_eq!(chains["homology"][2]["betti"], 1);
    let periodic = convert("torus.obj", &["--periodic", "x"]);
    assert!(periodic.fails_with(1).contains("--periodic"));
    assert!(!path("torus.obj").exists());
}

#[test]
fn what_makes_no_sense_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("radii.npy");
    radii(&path);
    let file = argument(&path);
    for (arguments, words) in [
        (&["pi1", file][..], "no words"),
        (&["render", file, "--periodic", "x", "-o", "x.png"], "--periodic"),
        (&["view", file, "--periodic", "x", "-o", "x.html"], "--periodic"),
        (&["link", file, "--simplices", "0"], "cubes"),
        (&["cut", file], ""),
        (&["info", file, "--periodic", "5"], "axis 5"),
        (&["info", file, "--between", "2", "1"], "lower bound first"),
    ] {
        let run = coface(arguments);
        assert!(run.fails_with(1).contains(words), "{arguments:?}: {}", run.stderr);
    }
    for arguments in [
        &["info", file, "--threshold", "nan"][..],
        &["info", file, "--periodic", "w"],
        &["info", file, "--threshold", "1", "--below", "2"],
        &["info", file, "--between", "1"],
    ] {
        assert_eq!(coface(arguments).status, 2, "{arguments:?}");
    }
    fs::write(&path, &fs::read(&path).unwrap()[..5000]).unwrap();
    let run = coface(&["info", file]);
    let message = run.fails_with(1);
    assert!(
        message.contains("radii.npy") && message.contains("64000 bytes, but 4872 bytes are left"),
        "{message}"
    );
}

#[test]
fn volumes_and_grids_are_cut_into_shards() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("radii.npy");
    radii(&path);
    let betti = |arguments: &[&str]| -> Vec<u64> {
        let report = coface(&[arguments, &["--json"]].concat()).json();
        report["homology"].as_array().unwrap().iter().map(|group| group["betti"].as_u64().unwrap()).collect()
    };
    let file = argument(&path);
    assert_eq!(betti(&["homology", file, "--between", "5", "8", "--parts", "8"]), [1, 0, 1, 0]);
    assert_eq!(betti(&["homology", file, "--parts", "5", "--periodic", "y", "--simplicial"]), [1, 1, 0, 0]);
    assert_eq!(
        betti(&["homology", "--grid", "12,10,8", "--periodic", "0,1,2", "--parts", "8"]),
        [1, 3, 3, 1]
    );
    assert_eq!(betti(&["homology", "--grid", "12,10", "--periodic", "x", "--simplicial"]), [1, 1, 0]);
    // By hand: shard, reduce, merge.
    let shards = folder.path().join("shards");
    let to = argument(&shards);
    let made = coface(&["shard", file, "--between", "5", "8", "-o", to, "--parts", "4", "--json"]).json();
    assert_eq!(made["parts"], 4);
    let parts: Vec<String> =
        (0..4).map(|number| shards.join(format!("part-{number:06}.shard")).display().to_string()).collect();
    let mut reduce = vec!["reduce"];
    reduce.extend(parts.iter().map(String::as_str));
    assert_eq!(coface(&reduce).status, 0);
    assert_eq!(betti(&["merge", to]), [1, 0, 1, 0]);
    for (arguments, words) in [
        (&["homology", file, "--parts", "2", "--owners", "walk"][..], "--owners"),
        (&["homology", "--grid", "9,9", "--periodic", "z"], "axis 2"),
        (&["shard", file, "--between", "5", "9", "-o", to, "--parts", "4"], "another complex"),
    ] {
        let run = coface(arguments);
        assert!(run.fails_with(1).contains(words), "{arguments:?}: {}", run.stderr);
    }
    assert_eq!(coface(&["homology"]).status, 2);
    assert_eq!(coface(&["shard", file, "--grid", "3,3", "-o", to, "--parts", "2"]).status, 2);
}

#[test]
fn pictures_show_the_boundary() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("radii.npy");
    radii(&path);
    let out = folder.path().join("drawn.svg");
    // One corner voxel of eight has three squares on the outside, and three within.
    let run = coface(&["render", argument(&path), "--threshold", "16", "-o", argument(&out)]);
    assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{}", run.stderr);
    assert!(run.stderr.contains("drawn: the 48 squares around the voxels of the volume"), "{}", run.stderr);
    assert!(fs::read_to_string(&out).unwrap().starts_with("<svg "));
}

/// Voxels as inputs of Booleans and arrangements are the squares around them.
#[test]
fn voxels_are_solids() {
    let folder = tempfile::tempdir().unwrap();
    let [left, right] = ["left.npy", "right.npy"].map(|name| folder.path().join(name));
    let block = |set: fn(&[u32]) -> bool| CubicalVolume::new(&[3, 2, 2], &[false; 3], set).unwrap();
    write_npy(&block(|at| at[0] < 2), fs::File::create(&left).unwrap()).unwrap();
    write_npy(&block(|at| at[0] > 0), fs::File::create(&right).unwrap()).unwrap();
    for (operation, volume) in [("union", 12.0), ("intersection", 4.0), ("difference", 4.0), ("xor", 8.0)] {
        let found = coface(&["boolean", operation, argument(&left), argument(&right), "--json"]).json();
        assert_eq!(found["measure"].as_f64(), Some(volume), "{operation}: {found}");
    }
    let found = coface(&["arrange", argument(&left), "--json"]).json();
    assert_eq!(found["measures"], serde_json::json!([8.0]), "{found}");
}
