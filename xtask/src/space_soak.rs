//! `cargo xtask soak --space`: long chains of Booleans of solids, random scenes, and rooms at many angles, by the program.

use serde_json::Value;
use std::fmt::Write;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, ExitCode};
use std::time::Instant;

const USAGE: &str = "usage: cargo xtask soak --space [--count N] [--chains N] [--steps N] [--stl N] [--scenes N] [--angles N] [--offsets N] [--tubes N]
    [--program PATH] [--python PATH]
  chains of Booleans of turned boxes and spheres through OFF files: each step valid and closed, the volume that of one formula;
  scenes of boxes of a grid, whose measures and Betti numbers are those of voxels, through .off, .obj and .json;
  32 rooms at random angles and places, which are 32 cells each within a tolerance;
  boxes that coincide, wholly or along an axis, but for the rounding of a random place: manifold and valid within a tolerance;
  closed tubes of 32,000 triangles that overlap themselves, united by positive winding numbers: valid; exit status 1 if one is not
  --count N       so many of each, but for steps; what stands after it says otherwise
  --chains N      how many chains [100]
  --steps N       of how many steps [100]
  --stl N         how many chains of as many steps through STL files, whose coordinates have 32 bits [20]
  --scenes N      how many scenes [500]
  --angles N      how many angles [200]
  --offsets N     how many pairs of boxes that coincide [1000]
  --tubes N       how many tubes [10]
  --program PATH  the program to run; without it the one in the target folder is built
  --python PATH   an interpreter with manifold3d, which takes the same steps beside the program: at most twice its triangles";

/// Takes the solids of a chain one after the other, and prints volume and triangles of the last result.
const MANIFOLD: &str = r#"
import sys
import manifold3d, numpy
def read(path):
    words = open(path).read().split()
    points, faces = int(words[1]), int(words[2])
    flat = numpy.array(words[4 : 4 + 3 * points], dtype=numpy.float64).reshape(-1, 3)
    lists = numpy.array(words[4 + 3 * points :], dtype=numpy.uint64).reshape(faces, 4)[:, 1:]
    return manifold3d.Manifold(manifold3d.Mesh64(flat, numpy.ascontiguousarray(lists)))
solid = read(sys.argv[1])
for i, path in enumerate(sys.argv[2:], 1):
    solid = solid + read(path) if i % 2 == 1 else solid - read(path)
    solid.num_tri()
print(solid.volume(), solid.num_tri())
"#;

struct Soak {
    program: PathBuf,
    python: Option<PathBuf>,
    folder: PathBuf,
    random: Random,
    faults: Vec<String>,
}

struct Counts {
    chains: usize,
    steps: usize,
    stl: usize,
    scenes: usize,
    angles: usize,
    offsets: usize,
    tubes: usize,
}

/// SplitMix64: G. Steele, D. Lea, C. Flood, *Fast splittable pseudorandom number generators* (2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }
}

type Mesh = (Vec<[f64; 3]>, Vec<[usize; 3]>);

pub(crate) fn soak(words: &[String]) -> ExitCode {
    let Some((counts, program, python)) = parse(words) else {
        eprintln!("{USAGE}");
        return ExitCode::from(2);
    };
    let Some(program) = program.or_else(crate::wild::build) else {
        eprintln!("the program does not build");
        return ExitCode::FAILURE;
    };
    let folder = std::env::temp_dir().join(format!("coface-space-{}", std::process::id()));
    if let Err(error) = fs::create_dir_all(&folder) {
        eprintln!("{}: {error}", folder.display());
        return ExitCode::FAILURE;
    }
    let mut soak = Soak { program, python, folder, random: Random(2024), faults: Vec::new() };
    soak.chains(counts.chains, counts.steps, "off");
    soak.chains(counts.stl, counts.steps, "stl");
    soak.scenes(counts.scenes);
    soak.rooms(counts.angles);
    soak.offsets(counts.offsets);
    soak.tubes(counts.tubes);
    // What is left is in the way of nobody.
    let _ = fs::remove_dir_all(&soak.folder);
    soak.faults.iter().take(20).for_each(|fault| println!("{fault}"));
    println!("{} faults", soak.faults.len());
    if soak.faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn parse(words: &[String]) -> Option<(Counts, Option<PathBuf>, Option<PathBuf>)> {
    let mut counts =
        Counts { chains: 100, steps: 100, stl: 20, scenes: 500, angles: 200, offsets: 1000, tubes: 10 };
    let (mut program, mut python) = (None, None);
    let mut words = words.iter();
    while let Some(word) = words.next() {
        let mut count = || words.next()?.parse().ok();
        match word.as_str() {
            "--count" => {
                let all = count()?;
                counts = Counts {
                    chains: all,
                    stl: all,
                    scenes: all,
                    angles: all,
                    offsets: all,
                    tubes: all,
                    ..counts
                };
            }
            "--stl" => counts.stl = count()?,
            "--offsets" => counts.offsets = count()?,
            "--tubes" => counts.tubes = count()?,
            "--chains" => counts.chains = count()?,
            "--steps" => counts.steps = count()?,
            "--scenes" => counts.scenes = count()?,
            "--angles" => counts.angles = count()?,
            "--program" => program = Some(words.next()?.into()),
            "--python" => python = Some(words.next()?.into()),
            _ => return None,
        }
    }
    Some((counts, program, python))
}

impl Soak {
    /// What a verb answers with `--json`, or a fault.
    fn answer(&mut self, words: &[&str]) -> Option<Value> {
        let output = Command::new(&self.program).args(words).args(["--json", "--quiet"]).output();
        let found = match &output {
            Ok(output) if output.status.success() => serde_json::from_slice(&output.stdout).ok(),
            _ => None,
        };
        if found.is_none() {
            let said = output.map_or_else(
                |error| error.to_string(),
                |output| String::from_utf8_lossy(&output.stderr).into_owned(),
            );
            self.faults.push(format!("coface {}: {said}", words.join(" ")));
        }
        found
    }

    fn check(&mut self, holds: bool, what: impl FnOnce() -> String) {
        if !holds {
            self.faults.push(what());
        }
    }

    fn write(&self, name: &str, (points, triangles): &Mesh) -> String {
        let mut text = format!("OFF\n{} {} 0\n", points.len(), triangles.len());
        for [x, y, z] in points {
            let _ = writeln!(text, "{x} {y} {z}");
        }
        for [a, b, c] in triangles {
            let _ = writeln!(text, "3 {a} {b} {c}");
        }
        let path = self.folder.join(name);
        if let Err(error) = fs::write(&path, text) {
            eprintln!("{}: {error}", path.display());
        }
        path.display().to_string()
    }

    fn path(&self, name: &str) -> String {
        self.folder.join(name).display().to_string()
    }

    /// Chains of unions and differences in turns, through files of this format.
    fn chains(&mut self, count: usize, steps: usize, extension: &str) {
        // What rounding of coordinates to the numbers of the format moves.
        let within = if extension == "stl" { 1e-4 } else { 1e-9 };
        let (mut faces, mut peers, mut most_difference, mut slowest) = (0, 0, 0.0f64, 0.0f64);
        let start = Instant::now();
        for chain in 0..count {
            let solids: Vec<String> = (0..=steps)
                .map(|i| {
                    let solid = if self.random.below(5) < 3 { self.turned_box() } else { self.sphere() };
                    self.write(&format!("solid{i}.off"), &solid)
                })
                .collect();
            let mut formula = "0".to_owned();
            let mut last = None;
            let mut path = solids[0].clone();
            for (i, solid) in solids.iter().enumerate().skip(1) {
                let operation = if i % 2 == 1 { "union" } else { "difference" };
                formula = format!("({formula} {} {i})", if i % 2 == 1 { '|' } else { '-' });
                let out = self.path(&format!("result{}.{extension}", i % 2));
                let begin = Instant::now();
                let Some(answer) = self.answer(&["boolean", operation, &path, solid, "-o", &out]) else {
                    break;
                };
                slowest = slowest.max(begin.elapsed().as_secs_f64());
                let is_sound = answer["rounding"]["valid"] == true && answer["closed"] == true;
                self.check(is_sound, || format!("chain {chain}, step {i} is not valid"));
                let remarks = answer["remarks"].to_string();
                self.check(!remarks.contains("reversed-input"), || {
                    format!("chain {chain}, step {i}: {remarks}")
                });
                if extension == "stl"
                    && let Some(report) = self.answer(&["info", &out])
                {
                    self.check(report["geometry"]["sound_surface"] == true, || {
                        format!("chain {chain}, step {i}: the file has {}", report["geometry"]["faults"])
                    });
                }
                (path, last) = (out, Some(answer));
            }
            let Some(last) = last else { continue };
            let own = last["f_vector"][2].as_u64().unwrap_or(0);
            faces += own;
            let mut words = vec!["boolean", "--formula", &formula];
            words.extend(solids.iter().map(String::as_str));
            if let Some(whole) = self.answer(&words) {
                let [volume, expected] =
                    [&last, &whole].map(|answer| answer["measure"].as_f64().unwrap_or(f64::NAN));
                let difference = (volume - expected).abs() / expected.max(1.0);
                most_difference = most_difference.max(difference);
                self.check(difference <= within, || format!("chain {chain}: volume {volume} for {expected}"));
            }
            if let Some(python) = self.python.as_ref().filter(|_| extension == "off") {
                let output = Command::new(python).args(["-c", MANIFOLD]).args(&solids).output();
                let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
                let count = text.ok().and_then(|text| text.split_whitespace().nth(1)?.parse::<u64>().ok());
                peers += count.unwrap_or(0);
                self.check(count.is_some_and(|count| own <= 2 * count), || {
                    format!("chain {chain}: {own} triangles, {count:?} of manifold3d")
                });
            }
        }
        println!(
            "{count} chains of {steps} steps through .{extension}: {faces} triangles in the end ({peers} of manifold3d), volumes differ by {most_difference:.1e} at most, the slowest step {slowest:.2} s, {:.0} s",
            start.elapsed().as_secs_f64()
        );
    }

    /// Some boxes of a grid, united, cut away or met; the same as voxels.
    fn scenes(&mut self, count: usize) {
        const SIZE: usize = 7;
        let start = Instant::now();
        for scene in 0..count {
            let boxes: Vec<[[usize; 2]; 3]> = (0..2 + self.random.below(4))
                .map(|_| {
                    [0; 3].map(|_| {
                        let low = self.random.below(SIZE - 1);
                        [low, low + 1 + self.random.below(SIZE - low - 1)]
                    })
                })
                .collect();
            let mut formula = "0".to_owned();
            let mut voxels = vec![false; SIZE * SIZE * SIZE];
            let files: Vec<String> = boxes
                .iter()
                .enumerate()
                .map(|(i, sides)| {
                    let kind = if i == 0 { 0 } else { self.random.below(4) };
                    if i > 0 {
                        formula = format!("({formula}) {} {i}", ['|', '-', '^', '|'][kind]);
                    }
                    for (voxel, is_in) in voxels.iter_mut().enumerate() {
                        let place = [voxel % SIZE, voxel / SIZE % SIZE, voxel / SIZE / SIZE];
                        let is_covered =
                            place.iter().zip(sides).all(|(x, [low, high])| (low..high).contains(&x));
                        *is_in = match kind {
                            1 => *is_in && !is_covered,
                            2 => *is_in != is_covered,
                            _ => *is_in || is_covered,
                        };
                    }
                    self.write(&format!("box{i}.off"), &grid_box(*sides))
                })
                .collect();
            let expected = voxels.iter().filter(|is_in| **is_in).count() as f64;
            for extension in ["off", "obj", "json"] {
                let out = self.path(&format!("scene.{extension}"));
                let mut words = vec!["boolean", "--formula", &formula, "-o", &out];
                words.extend(files.iter().map(String::as_str));
                let Some(answer) = self.answer(&words) else { continue };
                let what = || format!("scene {scene}, {formula} of {boxes:?} as .{extension}");
                self.check(answer["measure"] == expected, || {
                    format!("{}: {} for {expected}", what(), answer["measure"])
                });
                if expected == 0.0 {
                    continue;
                }
                if let Some(again) = self.answer(&["boolean", "union", &out]) {
                    let holds = again["measure"] == answer["measure"] && again["rounding"]["exact"] == true;
                    self.check(holds, || format!("{}, read again: {}", what(), again["measure"]));
                }
                if extension == "json"
                    && let Some(report) = self.answer(&["info", &out])
                {
                    let euler = euler_of_voxels(&voxels, SIZE);
                    self.check(report["euler_characteristic"] == euler, || {
                        format!(
                            "{}: Euler characteristic {} for {euler}",
                            what(),
                            report["euler_characteristic"]
                        )
                    });
                }
            }
        }
        println!("{count} scenes of boxes of a grid, {:.0} s", start.elapsed().as_secs_f64());
    }

    /// Four by eight rooms, each row half a room further than the one before, at angles and places of buildings.
    fn rooms(&mut self, count: usize) {
        let start = Instant::now();
        for angle in 0..count {
            let (turn, tilt) = (self.random.between(0.0, 6.3), self.random.between(0.0, 6.3));
            let is_far = angle % 2 == 1;
            let place = if is_far { [500_000.25, 5_400_000.75, 311.5] } else { [0.0; 3] };
            let tilt = if is_far { 0.0 } else { tilt };
            let mut text = String::new();
            for room in 0..32 {
                let (row, column) = (room / 4, room % 4);
                let low = [3.0 * f64::from(column) + 1.5 * f64::from(row % 2), 2.0 * f64::from(row), 0.0];
                let (points, _) = turned(box_at(low, [3.0, 2.0, 2.5]), turn, tilt);
                let _ = writeln!(text, "o room{room}");
                for point in points {
                    let [x, y, z] = [0, 1, 2].map(|axis| point[axis] + place[axis]);
                    let _ = writeln!(text, "v {x} {y} {z}");
                }
                for square in SQUARES {
                    let [a, b, c, d] = square.map(|corner| 8 * room + 1 + corner as i32);
                    let _ = writeln!(text, "f {a} {b} {c} {d}");
                }
            }
            let path = self.folder.join("rooms.obj");
            if fs::write(&path, text).is_err() {
                self.faults.push("the rooms could not be written".to_owned());
                return;
            }
            let tolerance = if is_far { "1e-6" } else { "1e-9" };
            let words = ["arrange", &self.path("rooms.obj"), "--inputs", "objects", "--tolerance", tolerance];
            if let Some(answer) = self.answer(&words) {
                self.check(answer["f_vector"][3] == 32 && answer["rounding"]["valid"] == true, || {
                    format!("rooms turned by {turn} and {tilt} at {place:?}: {}", answer["f_vector"])
                });
            }
        }
        println!("32 rooms at {count} angles, {:.0} s", start.elapsed().as_secs_f64());
    }

    /// Two copies of a turned box that are at one place, or moved along a side by half of it, but for the rounding of a far
    /// place.
    fn offsets(&mut self, count: usize) {
        let start = Instant::now();
        let mut most_difference = 0.0f64;
        for number in 0..count {
            let half = [0; 3].map(|_| self.random.between(0.5, 2.0));
            let (turn, tilt) = (self.random.between(0.0, 6.3), self.random.between(0.0, 6.3));
            let place = [0; 3].map(|_| self.random.between(-1e4, 1e4));
            let shift = if number % 2 == 0 { 0.0 } else { half[0] };
            let low = half.map(|x| -x);
            let first = turned(box_at(low, half.map(|x| 2.0 * x)), turn, tilt);
            let second = turned(box_at([low[0] + shift, low[1], low[2]], half.map(|x| 2.0 * x)), turn, tilt);
            let moved = |(points, triangles): Mesh, parts: usize| {
                let part = place.map(|x| x / parts as f64);
                let step = |point: [f64; 3]| [0, 1, 2].map(|axis| point[axis] + part[axis]);
                let points = points.into_iter().map(|point| (0..parts).fold(point, |point, _| step(point)));
                (points.collect(), triangles)
            };
            let paths =
                [self.write("first.off", &moved(first, 1)), self.write("second.off", &moved(second, 3))];
            let volume = 8.0 * half[0] * half[1] * half[2];
            let part = shift / (2.0 * half[0]);
            let cases = [
                ("union", volume * (1.0 + part)),
                ("intersection", volume * (1.0 - part)),
                ("difference", volume * part),
                ("xor", 2.0 * volume * part),
            ];
            for (operation, expected) in cases {
                let words = ["boolean", operation, &paths[0], &paths[1], "--tolerance", "1e-7"];
                let Some(answer) = self.answer(&words) else { continue };
                let found = answer["measure"].as_f64().unwrap_or(f64::NAN);
                most_difference = most_difference.max((found - expected).abs());
                let is_sound = answer["manifold"]["verdict"] == "yes"
                    && answer["rounding"]["valid"] == true
                    && (found - expected).abs() < 1e-5;
                self.check(is_sound, || {
                    let [verdict, rounding] = ["manifold", "rounding"].map(|key| &answer[key]);
                    format!("offset {number}, {operation}: {found} for {expected}, {verdict}, {rounding}")
                });
            }
        }
        let seconds = start.elapsed().as_secs_f64();
        println!(
            "{count} pairs of boxes that coincide, {seconds:.0} s; volumes differ by {most_difference:.1e}"
        );
    }

    /// Closed tubes along curves that cross themselves.
    fn tubes(&mut self, count: usize) {
        let start = Instant::now();
        let (mut slowest, mut most_difference, mut most_movement) = (0.0f64, 0.0f64, 0.0f64);
        for number in 0..count {
            let own = self.tube(160, 100);
            let path = self.write("tube.off", &own);
            let out = self.path("united.off");
            let union = ["boolean", "union", &path, "--rule", "positive"];
            let begin = Instant::now();
            let Some(answer) = self.answer(&[&union[..], &["-o", &out]].concat()) else { continue };
            slowest = slowest.max(begin.elapsed().as_secs_f64());
            let Some(exact) = self.answer(&[&union[..], &["--exact"]].concat()) else { continue };
            let [found, expected] =
                [&answer, &exact].map(|answer| answer["measure"].as_f64().unwrap_or(f64::NAN));
            most_difference = most_difference.max((found - expected).abs() / expected);
            most_movement = most_movement.max(answer["joined"]["largest_movement"].as_f64().unwrap_or(0.0));
            let is_sound = answer["rounding"]["valid"] == true && (found - expected).abs() <= 1e-9 * expected;
            self.check(is_sound, || format!("tube {number}: {found} for {expected}, {}", answer["rounding"]));
            if let Some(again) = self.answer(&["boolean", "union", &out]) {
                let same = again["measure"].as_f64().unwrap_or(f64::NAN);
                self.check((same - found).abs() <= 1e-9 * found, || {
                    format!("tube {number}: {same} for {found}, read again")
                });
            }
        }
        println!(
            "{count} tubes, {:.0} s, the slowest {slowest:.1} s; volumes differ by {most_difference:.1e}, points moved by at most \
             {most_movement:.1e}",
            start.elapsed().as_secs_f64()
        );
    }

    /// A polygon swept along a closed curve of three waves.
    fn tube(&mut self, steps: usize, around: usize) -> Mesh {
        let waves: Vec<[f64; 3]> = (0..9)
            .map(|_| {
                [
                    self.random.between(0.2, 1.0),
                    1.0 + self.random.below(7) as f64,
                    self.random.between(0.0, 6.3),
                ]
            })
            .collect();
        let radius = self.random.between(0.2, 0.5);
        let curve = |t: f64| {
            [0, 1, 2].map(|axis| {
                let own = waves[3 * axis..3 * axis + 3].iter();
                own.map(|[size, turns, phase]| size * (turns * t + phase).sin()).sum::<f64>()
            })
        };
        let unit = |v: [f64; 3]| v.map(|x| x / v.iter().map(|x| x * x).sum::<f64>().sqrt());
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
        };
        let (mut points, mut triangles) = (Vec::new(), Vec::new());
        for i in 0..steps {
            let t = std::f64::consts::TAU * i as f64 / steps as f64;
            let [middle, before, after] = [t, t - 1e-5, t + 1e-5].map(curve);
            let along = unit([0, 1, 2].map(|axis| after[axis] - before[axis]));
            let u = unit(cross(along, [0.1, 0.2, 1.0]));
            let v = cross(along, u);
            for j in 0..around {
                let (s, c) = (std::f64::consts::TAU * j as f64 / around as f64).sin_cos();
                points.push([0, 1, 2].map(|axis| middle[axis] + radius * (c * u[axis] + s * v[axis])));
                let at = |i: usize, j: usize| i % steps * around + j % around;
                let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)];
                triangles.extend([[a, b, d], [a, d, c]]);
            }
        }
        (points, triangles)
    }

    fn turned_box(&mut self) -> Mesh {
        let half = [0; 3].map(|_| self.random.between(0.2, 0.6));
        let solid = box_at(half.map(|x| -x), half.map(|x| 2.0 * x));
        self.placed(solid)
    }

    /// An icosahedron whose triangles are cut into four, blown up to a sphere.
    fn sphere(&mut self) -> Mesh {
        let golden = (1.0 + 5f64.sqrt()) / 2.0;
        let mut points: Vec<[f64; 3]> = Vec::new();
        for (s, t) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            points.extend([[0.0, s, t * golden], [s, t * golden, 0.0], [t * golden, 0.0, s]]);
        }
        let near = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>() < 4.1;
        let mut triangles = Vec::new();
        for a in 0..12 {
            for b in a + 1..12 {
                for c in b + 1..12 {
                    let [p, q, r] = [a, b, c].map(|i: usize| points[i]);
                    if near(p, q) && near(q, r) && near(r, p) {
                        let turn = p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
                            + p[2] * (q[0] * r[1] - q[1] * r[0]);
                        triangles.push(if turn > 0.0 { [a, b, c] } else { [a, c, b] });
                    }
                }
            }
        }
        let mut middles = std::collections::BTreeMap::new();
        let mut cut = Vec::new();
        for [a, b, c] in triangles {
            let [x, y, z] = [[a, b], [b, c], [c, a]].map(|[p, q]: [usize; 2]| {
                *middles.entry([p.min(q), p.max(q)]).or_insert_with(|| {
                    points.push([0, 1, 2].map(|i| points[p][i] + points[q][i]));
                    points.len() - 1
                })
            });
            cut.extend([[a, x, z], [x, b, y], [z, y, c], [x, y, z]]);
        }
        let radius = self.random.between(0.2, 0.6);
        for point in &mut points {
            let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
            *point = point.map(|x| radius * x / length);
        }
        self.placed((points, cut))
    }

    fn placed(&mut self, solid: Mesh) -> Mesh {
        let place = [0; 3].map(|_| self.random.between(-1.0, 1.0));
        let (turn, tilt) = (self.random.between(0.0, 6.3), self.random.between(0.0, 6.3));
        let (mut points, triangles) = turned(solid, turn, tilt);
        points.iter_mut().for_each(|point| *point = [0, 1, 2].map(|i| point[i] + place[i]));
        (points, triangles)
    }
}

const SQUARES: [[usize; 4]; 6] =
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

fn box_at(low: [f64; 3], sizes: [f64; 3]) -> Mesh {
    let corner =
        |i: usize| [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { low[axis] } else { low[axis] + sizes[axis] });
    let triangles = SQUARES.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    ((0..8).map(corner).collect(), triangles)
}

fn grid_box(sides: [[usize; 2]; 3]) -> Mesh {
    box_at(sides.map(|side| side[0] as f64), sides.map(|[low, high]| (high - low) as f64))
}

fn turned((points, triangles): Mesh, turn: f64, tilt: f64) -> Mesh {
    let ((s, c), (t, d)) = (turn.sin_cos(), tilt.sin_cos());
    let turned = |[x, y, z]: [f64; 3]| {
        let [y, z] = [d * y - t * z, t * y + d * z];
        [c * x - s * y, s * x + c * y, z]
    };
    (points.into_iter().map(turned).collect(), triangles)
}

/// Vertices - edges + squares - cubes of the closed cubes.
fn euler_of_voxels(voxels: &[bool], size: usize) -> i64 {
    // Cells of all degrees have places in a grid twice as fine; odd coordinates are open intervals.
    let fine = 2 * size + 1;
    let mut is_there = vec![false; fine * fine * fine];
    for (voxel, _) in voxels.iter().enumerate().filter(|(_, is_in)| **is_in) {
        let place = [voxel % size, voxel / size % size, voxel / size / size];
        for part in 0..27 {
            let at = [2 * place[0] + part % 3, 2 * place[1] + part / 3 % 3, 2 * place[2] + part / 9];
            is_there[at[0] + fine * (at[1] + fine * at[2])] = true;
        }
    }
    let sign =
        |at: usize| if (at % fine + at / fine % fine + at / fine / fine).is_multiple_of(2) { 1 } else { -1 };
    (0..is_there.len()).filter(|&at| is_there[at]).map(sign).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn voxels_are_counted() {
        let mut voxels = vec![true; 27];
        assert_eq!(euler_of_voxels(&voxels, 3), 1);
        // A shell, then a ring.
        voxels[13] = false;
        assert_eq!(euler_of_voxels(&voxels, 3), 2);
        (voxels[4], voxels[22]) = (false, false);
        assert_eq!(euler_of_voxels(&voxels, 3), 0);
    }

    #[test]
    fn solids_are_closed() {
        let mut soak = Soak {
            program: PathBuf::new(),
            python: None,
            folder: PathBuf::new(),
            random: Random(1),
            faults: Vec::new(),
        };
        for (points, triangles) in [soak.sphere(), soak.turned_box()] {
            let edges = 3 * triangles.len() / 2;
            assert_eq!(points.len() + triangles.len(), edges + 2);
        }
    }
}
