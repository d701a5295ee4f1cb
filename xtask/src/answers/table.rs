//! Which calls are made: verbs and options, files, pairs of files, families.

use super::run::Run;
use crate::root;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Verbs with options for each file; `@` stands for the file.
const VERBS: &[&str] = &[
    "info @ --json",
    "info @ --json --all",
    "info @",
    "homology @ --json",
    "homology @ --json --coefficients q",
    "homology @ --json --coefficients f2",
    "homology @ --json --coefficients f3",
    "homology @ --json --coefficients z4",
    "homology @ --json --cohomology",
    "homology @ --json --cohomology --coefficients f2",
    "homology @ --json --reduced",
    "homology @ --json --relative boundary",
    "homology @ --json --relative boundary --sequence",
    "homology @ --json --generators",
    "homology @ --json --generators --coefficients f2",
    "homology @ --json --cohomology --generators",
    "homology @ --json --cup 1 1",
    "homology @ --json --intersection-form",
    "homology @ --json --harmonic",
    "homology @ --json --parts 3",
    "homology @",
    "persistence @ --json",
    "persistence @ --json --coefficients f3 --upper-star",
    "persistence @ --json --function x",
    "pi1 @ --json",
    "pi1 @ --json --simplify",
    "pi1 @ --json --shortest",
    "pi1 @ --json --canonical",
    "pi1 @ --json --cycles non-contractible",
    "pi1 @ --json --cycles non-separating",
    "pi1 @ --json --cycles homology-basis",
    "pi1 @ --json --simplify --subgroups 3",
    "pi1 @ --simplify",
    "cut @ --json",
    "cut @ --json --simplify",
    "cut @ --json --boundary",
    "cover @ --json --copies 20",
    "cover @ --json --radius 2 --layout none",
    "cover @ --json --orientation",
    "cover @ --json --copies 5 --boundary",
    "cocycles @ --json",
    "cocycles @ --json --harmonic",
    "cocycles @ --json --harmonic --weights uniform",
    "cocycles @ --json --method slicing",
    "cocycles @ --json --method general",
    "star @ --json --simplices 0;1",
    "closure @ --json --simplices 0;1",
    "link @ --json --simplices 0",
    "boundary @ --json",
    "interior @ --json",
    "skeleton @ --json --dimension 1",
    "incidence @ --json --operator VV",
    "incidence @ --json --operator FE --entries",
    "incidence @ --json --operator EV --signed --entries",
    "incidence @ --json --operator CF --incident --entries",
    "congruence @ --json --tolerance 0.001",
    "congruence @ --json --tolerance 0.1 --greedy --representative mean",
    "congruence @ --json --tolerance 0.01 --method matrices --blocks components --stable",
    "arrange @ --json",
    "arrange @ --json --rule evenodd --prune",
    "arrange @ --json --dimension 3 --non-planar split",
    "arrange @ --json --inputs features",
    "boolean union @ --json",
    "boolean union @ --json --rule evenodd",
    "boolean union @ --json --non-planar split --open close --pinches split",
    "yin info @ --json",
    "yin complement @ --json",
    "yin fit @ --json",
    "yin kinks @ --json --kinks detect:20",
    "yin cut-cells @ --json --grid 8",
    "yin advect @ --json --flow translation --time 0.1 --step 0.05",
    "render @ --size 300x200",
];

/// Formats that each file is converted to.
const FORMATS: &[&str] = &[
    "off", "obj", "ply", "stl", "mesh", "msh", "vtk", "vtu", "vtp", "json", "isosig", "lines", "geojson",
    "wkt", "svg", "dat", "npy", "cfc", "glb", "gltf",
];

/// Verbs for a model in a list of models, and for families.
const SHORT: &[&str] = &[
    "info @ --json",
    "homology @ --json",
    "homology @ --json --coefficients f2 --generators",
    "homology @ --json --cohomology",
    "homology @ --json --cup 1 1",
    "persistence @ --json",
    "pi1 @ --json --simplify",
    "cut @ --json --simplify",
    "cover @ --json --copies 20 --layout none",
    "cocycles @ --json",
    "boundary @ --json",
    "incidence @ --json --operator FE --incident",
    "convert @ --to json",
];

/// Verbs for files of more than [`LARGE`] bytes.
const LIGHT: &[&str] =
    &["info @ --json", "homology @ --json", "cut @ --json --simplify", "convert @ --to off"];
const LARGE: u64 = 2_000_000;

/// Verbs for pairs of files in the plane; `@` and `%` stand for them.
const PLANE_PAIRS: &[&str] = &[
    "boolean union @ % --json",
    "boolean intersection @ % --json",
    "boolean difference @ % --json",
    "boolean difference % @ --json",
    "boolean xor @ % --json",
    "boolean @ % --formula !(a|b)^(a&b) --json",
    "boolean union @ % --json --keep-walls",
    "boolean intersection @ % --to-file geojson",
    "arrange @ % --json",
    "arrange @ % --json --snap",
    "arrange @ % --to-file json",
];

/// Verbs for pairs of solids.
const SPACE_PAIRS: &[&str] = &[
    "boolean union @ % --json --non-planar split",
    "boolean intersection @ % --json --non-planar split",
    "boolean difference @ % --json --non-planar split",
    "boolean xor @ % --json --non-planar split --merge-coplanar",
    "boolean union @ % --non-planar split --to-file off",
    "arrange @ % --json --non-planar split",
    "congruence @ % --json --tolerance 0.001",
];

/// Verbs for pairs of Yin sets.
const YIN_PAIRS: &[&str] = &[
    "yin meet @ % --json",
    "yin join @ % --json",
    "yin difference @ % --json",
    "yin xor @ % --json",
    "yin combine !(a|b) @ % --json",
    "yin meet @ % --json --order 4",
];

const PLANE: &[(&str, &str)] = &[
    ("planar/ITA.geo.json", "planar/italy-110m.geojson"),
    ("planar/ZAF.geo.json", "planar/LSO.geo.json"),
    ("planar/earcut-dude.json", "planar/polygon.svg"),
    ("planar/land-110m.geojson", "planar/ITA.geo.json"),
    ("planar/test1.lines", "planar/test2.lines"),
    ("planar/test3.lines", "planar/test4.lines"),
];

const SPACE: &[(&str, &str)] = &[
    ("surfaces/Cray_left.obj", "surfaces/Cray_right.obj"),
    ("surfaces/eight.off", "surfaces/three_cubes.stl"),
    ("surfaces/fandisk_quads.off", "surfaces/eight.off"),
    ("surfaces/spot.obj", "surfaces/eight.off"),
    ("surfaces/stl_box_ascii.stl", "surfaces/eight.off"),
    ("surfaces/platonic_shelf.obj", "surfaces/eight.off"),
    ("volumes/cylinder.vtk", "volumes/box.msh"),
];

/// Families of `generate`, with what they need beyond their defaults.
const FAMILIES: &[&str] = &[
    "grid --shape 2,3",
    "cuboids --shape 2,1,2",
    "simplex",
    "circle",
    "helix",
    "disk",
    "ring",
    "helicoid",
    "cylinder",
    "cone",
    "sphere",
    "torus",
    "crown",
    "moebius",
    "klein",
    "csaszar",
    "box",
    "ball",
    "rod",
    "solid-torus",
    "hollow-cylinder",
    "hollow-ball",
    "genus",
    "simplex-boundary",
    "cross-polytope",
    "cyclic-torus",
    "torus-grid",
    "klein-grid",
    "small-klein",
    "pinched-torus",
    "strip",
    "rp2",
    "rp",
    "cp2",
    "hp2",
    "k3",
    "lens",
    "lens --p 7 --q 3",
    "poincare",
    "weber-seifert",
    "glued-solid",
    "prism-manifold",
    "truncated-cube",
    "flat",
    "torus-bundle",
    "sphere-bundle",
    "moore",
    "presentation --generators 2 --relator 1,2,-1,-2",
    "dunce-hat",
    "house",
    "book",
    "chessboard",
    "matching",
    "sum-complex",
    "barnette",
    "bruckner",
    "rudin-ball",
    "ziegler-ball",
];

/// All calls. Files that are made for them go to a folder of their own.
pub(super) fn runs(scratch: &Path) -> Result<Vec<Run>, String> {
    let mut runs = Vec::new();
    let real = std::env::var_os("COFACE_DATA").map(PathBuf::from).filter(|folder| folder.is_dir());
    let places = [("data", Some(root().join("data"))), ("real", real)];
    for (place, folder) in places {
        let Some(folder) = folder else {
            println!("skipped: files of COFACE_DATA (the environment variable names no folder)");
            continue;
        };
        files_of(place, &folder, &mut runs)?;
        if place == "real" {
            let pairs = [(PLANE, PLANE_PAIRS), (SPACE, SPACE_PAIRS)];
            for (files, verbs) in pairs {
                for (a, b) in
                    files.iter().filter(|(a, b)| folder.join(a).is_file() && folder.join(b).is_file())
                {
                    runs.extend(verbs.iter().map(|verb| run(place, &folder, verb, a, b)));
                }
            }
            let sets = folder.join("yin/polygons.json");
            if sets.is_file() {
                yin_sets(&sets, &scratch.join("yin"), &mut runs)?;
            }
        }
        runs.push(run(place, &folder, "batch . -r --no-timings --json --jobs 1 --to-file jsonl", "", ""));
    }
    for family in FAMILIES {
        runs.push(run("family", scratch, &format!("generate {family} --json"), "", ""));
        for format in ["off", "json", "vtk"] {
            runs.push(run("family", scratch, &format!("generate {family} --to {format}"), "", ""));
        }
    }
    Ok(runs)
}

/// The calls for all files of a folder, and for the models in files that are lists of them.
fn files_of(place: &'static str, folder: &Path, runs: &mut Vec<Run>) -> Result<(), String> {
    let mut paths = Vec::new();
    walk(folder, &mut paths)?;
    for path in paths {
        let name = path.strip_prefix(folder).unwrap_or(&path).to_string_lossy().replace('\\', "/");
        if name.ends_with(".md") || name.starts_with("licenses/") {
            continue;
        }
        if path.metadata().is_ok_and(|data| data.len() > LARGE) {
            runs.extend(LIGHT.iter().map(|verb| run(place, folder, verb, &name, "")));
            continue;
        }
        runs.extend(VERBS.iter().map(|verb| run(place, folder, verb, &name, "")));
        runs.extend(
            FORMATS.iter().map(|format| run(place, folder, &format!("convert @ --to {format}"), &name, "")),
        );
        for model in models(&path) {
            runs.extend(SHORT.iter().map(|verb| run(place, folder, verb, &format!("{name}#{model}"), "")));
        }
    }
    Ok(())
}

/// A call: `@` and `%` stand for files, `--to-file X` for a file of that ending which is kept.
fn run(place: &'static str, folder: &Path, verb: &str, first: &str, second: &str) -> Run {
    let mut words = Vec::new();
    let mut output = None;
    let mut rest = verb.split(' ');
    while let Some(word) = rest.next() {
        match word {
            "@" => words.push(first.to_owned()),
            "%" => words.push(second.to_owned()),
            "--to-file" => output = rest.next().and_then(ending),
            _ => words.push(word.to_owned()),
        }
    }
    Run { place, folder: folder.to_owned(), words, output }
}

fn ending(word: &str) -> Option<&'static str> {
    ["geojson", "json", "off", "jsonl"].into_iter().find(|ending| *ending == word)
}

/// The names of the models in a JSON file that is a list of named objects.
fn models(path: &Path) -> Vec<String> {
    if path.extension().is_none_or(|extension| extension != "json") {
        return Vec::new();
    }
    let text = std::fs::read_to_string(path).unwrap_or_default();
    let list: Vec<Value> = serde_json::from_str(&text).unwrap_or_default();
    list.iter().filter_map(|item| Some(item.get("name")?.as_str()?.to_owned())).collect()
}

/// Writes the sets of a file of test sets as files of their own, and adds calls for each and for neighbors in the list.
fn yin_sets(file: &Path, folder: &Path, runs: &mut Vec<Run>) -> Result<(), String> {
    let fault = |error: String| format!("{}: {error}", file.display());
    let text = std::fs::read_to_string(file).map_err(|error| fault(error.to_string()))?;
    let sets: serde_json::Map<String, Value> =
        serde_json::from_str(&text).map_err(|error| fault(error.to_string()))?;
    std::fs::create_dir_all(folder).map_err(|error| fault(error.to_string()))?;
    let mut names = Vec::new();
    for (name, curves) in &sets {
        let curves: Vec<Value> =
            curves.as_array().into_iter().flatten().map(|points| json!({"points": points})).collect();
        let name = format!("{}.json", name.replace(['/', ' '], "_"));
        let set = json!({"order": 2, "curves": curves});
        std::fs::write(folder.join(&name), set.to_string()).map_err(|error| fault(error.to_string()))?;
        names.push(name);
    }
    names.sort();
    let alone = VERBS.iter().filter(|verb| verb.starts_with("yin ") || verb.starts_with("info @ --json"));
    for verb in alone {
        runs.extend(names.iter().map(|name| run("yin", folder, verb, name, "")));
    }
    for pair in names.windows(2) {
        runs.extend(YIN_PAIRS.iter().map(|verb| run("yin", folder, verb, &pair[0], &pair[1])));
    }
    Ok(())
}

fn walk(folder: &Path, found: &mut Vec<PathBuf>) -> Result<(), String> {
    let fault = |error: std::io::Error| format!("{}: {error}", folder.display());
    let entries = std::fs::read_dir(folder).map_err(fault)?;
    let mut paths: Vec<PathBuf> =
        entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<_, _>>().map_err(fault)?;
    paths.sort();
    for path in paths {
        if path.is_dir() {
            walk(&path, found)?;
        } else {
            found.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stand_for_files() {
        let run = run("real", Path::new("x"), "boolean union @ % --to-file off", "a b.off", "c.off");
        assert_eq!(run.words, ["boolean", "union", "a b.off", "c.off"]);
        assert_eq!(run.output, Some("off"));
        assert_eq!(run.name(), "[real] boolean union a b.off c.off");
    }

    #[test]
    fn no_two_runs_have_one_record() {
        let folder = std::env::temp_dir().join(format!("coface-xtask-table-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let runs = runs(&folder).expect("the table");
        let mut names: Vec<String> = runs.iter().map(Run::file_name).collect();
        assert!(names.len() > 500);
        names.sort();
        names.dedup();
        assert_eq!(names.len(), runs.len());
        std::fs::remove_dir_all(&folder).expect("the folder goes away");
    }
}
