//! Long work that somebody watches: what it tells, and how it ends when it is asked to.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface::algebra::chains::{ChainComplex, MorseComplex};
use coface::algebra::progress::{Stopped, Watch};
use coface::algebra::{SparseMatrix, smith_form};
use coface::answers::Report;
use coface::arrange::congruence::{ClassRule, Representative, vertex_congruence};
use coface::complexes::known_spaces::torus_grid;
use coface::complexes::simplicial::SimplicialComplex;
use coface::complexes::surface::{GeneralizedMap, PolygonMesh};
use coface::io;
use coface::io::{Format, Model};
use coface::pictures::{Picture, PictureStyle, Scene};
use coface::topology::{Coefficients, CutSurface, Filtration, HomologyBasis, TreeCotree, persistence};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

fn torus(side: u32) -> SimplicialComplex {
    torus_grid(&[side, side]).unwrap()
}

/// A torus as a file: OFF, flat in four dimensions folded to three.
fn file(side: u32) -> Vec<u8> {
    let turn = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(side);
    let mut text = format!("OFF\n{} {} 0\n", side * side, side * side);
    for i in 0..side {
        for j in 0..side {
            let r = 2.0 + turn(j).cos();
            text += &format!("{} {} {}\n", r * turn(i).cos(), r * turn(i).sin(), turn(j).sin());
        }
    }
    let at = |i: u32, j: u32| i % side * side + j % side;
    for i in 0..side {
        for j in 0..side {
            text += &format!("4 {} {} {} {}\n", at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    text.into_bytes()
}

fn model(side: u32) -> Model {
    io::read(&file(side)[..], Format::Off).unwrap()
}

fn complex(side: u32) -> ChainComplex {
    torus(side).chain_complex().unwrap()
}

fn map(side: u32) -> GeneralizedMap {
    let model = model(side);
    let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &[]).unwrap();
    GeneralizedMap::new(mesh.two_skeleton().unwrap()).unwrap()
}

/// A matrix that no entry of divides another.
fn matrix() -> SparseMatrix {
    let entries = (0..40)
        .flat_map(|i| (0..40).map(move |j| (i, j, ((7 * i * i + 11 * j * i + 13 * j) % 23) as i64 - 11)));
    SparseMatrix::from_entries(40, 40, entries).unwrap()
}

/// A name, and what it does.
type Work = (&'static str, Box<dyn Fn() -> String + Send + Sync>);

/// What takes long, as texts so that it can be compared; each with its name.
fn works() -> Vec<Work> {
    let (small, surface, text) = (Arc::new(complex(30)), Arc::new(map(30)), file(40));
    let heights: Vec<f64> = (0..900).map(|v| f64::from((v * 37) % 101)).collect();
    let points = model(40).positions().clone();
    let drawn = model(20);
    let mut found: Vec<Work> = Vec::new();
    let own = Arc::clone(&small);
    found.push(("reduction", Box::new(move || format!("{:?}", MorseComplex::new(&own).boundary_matrix(1)))));
    let own = Arc::clone(&small);
    found.push(("generators", Box::new(move || format!("{:?}", HomologyBasis::new(&own).generators(1)))));
    let own = Arc::clone(&small);
    found.push((
        "persistence",
        Box::new(move || {
            let filtration = Filtration::lower_star(&own, &heights).unwrap();
            format!("{:?}", persistence(&own, &filtration, Coefficients::Modulo(2)).unwrap().pairs())
        }),
    ));
    found.push(("Smith form", Box::new(|| format!("{:?}", smith_form(&matrix())))));
    found.push(("reading", Box::new(move || format!("{:?}", io::read(&text[..], Format::Off).unwrap()))));
    let own = Arc::clone(&surface);
    found.push((
        "cutting",
        Box::new(move || {
            let trees = TreeCotree::new(&own);
            format!("{:?} {:?}", trees.roles(), CutSurface::new(&own, &trees).domains().len())
        }),
    ));
    found.push((
        "congruence",
        Box::new(move || {
            let found = vertex_congruence(&points, 0.2, ClassRule::Transitive, Representative::default());
            format!("{:?}", found.unwrap().class_of())
        }),
    ));
    found.push((
        "report",
        Box::new(|| serde_json::to_string(&Report::of(model(30)).unwrap().answer(9)).unwrap()),
    ));
    found.push((
        "drawing",
        Box::new(move || {
            let scene = Scene::of("torus", &drawn).unwrap();
            Picture::new(&scene, &PictureStyle::default()).unwrap().svg()
        }),
    ));
    found
}

#[test]
fn results_do_not_depend_on_a_watch() {
    for (name, work) in works() {
        let watch = Arc::new(Watch::new());
        assert_eq!(watch.run(&work), Ok(work()), "{name}");
        assert_eq!(watch.stage(), None, "{name}");
    }
}

#[test]
fn all_work_ends_when_it_is_asked_to() {
    for (name, work) in works() {
        let watch = Arc::new(Watch::new());
        watch.stop();
        assert_eq!(watch.run(work).err(), Some(Stopped), "{name}");
        assert_eq!(watch.stage(), None, "{name}");
    }
}

/// Another thread looks all the time: steps never are more than there are, and stages come in the order of the work. On a busy machine it may
/// look only now and then: it looks at the work again until it has seen more than two stages.
#[test]
fn stages_come_in_order() {
    let bytes = file(150);
    let order = [
        "reading the input",
        "sorting cells by their vertices",
        "identifying edges",
        "multiplying boundaries",
        "matching cells",
        "spanning vertices",
        "cancelling pairs",
    ];
    let is_enough = (0..100).any(|_| {
        let seen = stages_of_homology(&bytes);
        let places: Vec<usize> =
            seen.iter().filter_map(|name| order.iter().position(|known| known == name)).collect();
        assert!(places.is_sorted(), "{seen:?}");
        places.len() > 2
    });
    assert!(is_enough, "a hundred runs, and never more than two stages");
}

/// The stages that another thread sees while the homology of the surface is found.
fn stages_of_homology(bytes: &[u8]) -> Vec<String> {
    let watch = Arc::new(Watch::new());
    let is_done = AtomicBool::new(false);
    std::thread::scope(|scope| {
        let looking = scope.spawn(|| {
            let mut seen: Vec<String> = Vec::new();
            while !is_done.load(Ordering::Relaxed) {
                if let Some(stage) = watch.stage() {
                    assert!(stage.total().is_none_or(|total| stage.done() <= total), "{stage:?}");
                    if seen.last().is_none_or(|last| last != stage.name()) {
                        seen.push(stage.name().to_owned());
                    }
                }
                std::thread::yield_now();
            }
            seen
        });
        let euler = watch.run(|| {
            let model = io::read(bytes, Format::Off).unwrap();
            let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &[]).unwrap();
            let complex = mesh.into_chain_complex().unwrap();
            MorseComplex::new(&complex).critical_count(1)
        });
        is_done.store(true, Ordering::Relaxed);
        assert_eq!(euler, Ok(2));
        looking.join().unwrap()
    })
}

/// Runs work and stops it as soon as the stage has begun; once more where the work was faster than the look at it.
fn stopped_in<T>(stage: &str, work: impl Fn() -> T) -> Result<T, Stopped> {
    let attempt = || {
        let (watch, is_done) = (Arc::new(Watch::new()), AtomicBool::new(false));
        std::thread::scope(|scope| {
            scope.spawn(|| {
                while !is_done.load(Ordering::Relaxed) {
                    if watch.stage().is_some_and(|now| now.name() == stage && now.done() > 0) {
                        watch.stop();
                        return;
                    }
                    std::thread::yield_now();
                }
            });
            let ended = watch.run(&work);
            is_done.store(true, Ordering::Relaxed);
            ended
        })
    };
    let stopped = (0..100).map(|_| attempt()).find(Result::is_err);
    stopped.unwrap_or_else(|| panic!("the work was never seen in the stage {stage:?}"))
}

/// A watch that is asked to stop in the middle ends the work before it is done.
#[test]
fn work_is_stopped_in_the_middle() {
    let complex = complex(300);
    let ended = stopped_in("matching cells", || HomologyBasis::new(&complex).generators(1).len());
    assert_eq!(ended, Err(Stopped));
}

/// A file that is being written when the work is stopped does not appear, and nothing is left of it.
#[test]
fn a_stopped_watch_leaves_no_file() {
    let model = model(200);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("torus.off");
    let ended = stopped_in("writing torus.off", || {
        let written = io::write_path(&model, &path, None);
        std::fs::remove_file(&path).unwrap();
        written
    });
    assert_eq!(ended.err(), Some(Stopped));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}
