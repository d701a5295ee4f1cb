//! Covers of real surfaces. The folder named by the environment variable `COFACE_DATA` holds them; without it the tests say
//! that they skip.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a skipped test says so")]

use coface_algebra::FaceId;
use coface_answers::Producer;
use coface_complexes::surface::GeneralizedMap;
use coface_io::read_path;
use coface_topology::{
    CoverExtent, CoverLayout, CoverPlane, CutSurface, SurfaceGroup, TreeCotree, UniversalCover,
};
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::time::Instant;

fn surfaces() -> Vec<(String, GeneralizedMap)> {
    let Some(folder) = std::env::var_os("COFACE_DATA").map(PathBuf::from) else {
        println!("COFACE_DATA is not set: the covers of real surfaces are skipped");
        return Vec::new();
    };
    let mut paths: Vec<PathBuf> =
        std::fs::read_dir(folder.join("surfaces")).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let maps = paths.into_iter().filter_map(|path| {
        let model = read_path(&path, None).ok()?;
        if model.polygons().len() > 50_000 {
            return None;
        }
        let skeleton = Producer::of(model).ok()?.two_skeleton().ok()?;
        let map = GeneralizedMap::new(skeleton).ok()?;
        Some((path.file_name().unwrap().to_string_lossy().into_owned(), map))
    });
    maps.collect()
}

/// No triangle of copy 0 is turned over, in the model in which geodesics are straight.
fn check_faces_of_first_copy(map: &GeneralizedMap, cover: &UniversalCover, layout: &CoverLayout) {
    let straight = |vertex: u32| {
        let [x, y] = layout.points()[vertex as usize];
        let scale = match layout.plane() {
            CoverPlane::Flat => 1.0,
            _ => 2.0 / (1.0 + x * x + y * y),
        };
        [scale * x, scale * y]
    };
    let polygons = cover.polygons();
    let above = GeneralizedMap::new(cover.skeleton().clone()).unwrap();
    let orientation = above.orientation();
    let mut signs = BTreeSet::new();
    for face in (0..map.f_vector()[2].min(cover.f_vector()[2])).map(FaceId::new) {
        let corners: Vec<[f64; 2]> = polygons.list(face.index()).iter().map(|&v| straight(v)).collect();
        let [o, rest @ ..] = corners.as_slice() else { continue };
        let twice_area: f64 = rest
            .windows(2)
            .map(|pair| [pair[0], pair[1]].map(|p| [p[0] - o[0], p[1] - o[1]]))
            .map(|[p, q]| p[0] * q[1] - p[1] * q[0])
            .sum();
        let sign = f64::from(orientation.signs()[face.index()].to_i32());
        signs.insert(sign * twice_area > 0.0);
    }
    assert_eq!(signs.len(), 1);
}

#[test]
fn real_surfaces_have_covers() {
    for (name, map) in surfaces() {
        let cut = CutSurface::new(&map, &TreeCotree::new(&map));
        for (component, domain) in cut.domains().iter().enumerate().take(3) {
            let started = Instant::now();
            if let Some(relator) = domain.relator().filter(|relator| !relator.is_empty()) {
                let group = SurfaceGroup::closed(&relator).unwrap();
                let system = group.canonical_system().unwrap();
                assert_eq!(system.relator().image(system.generators()), relator, "{name}");
                assert!(group.is_trivial(&relator.power(7)));
            }
            let system_time = started.elapsed();
            let started = Instant::now();
            let cover = UniversalCover::new(&map, &cut, component, CoverExtent::Radius(1), 12_000_000)
                .or_else(|_| UniversalCover::new(&map, &cut, component, CoverExtent::Copies(1), 12_000_000));
            let cover = cover.unwrap();
            let expected = if domain.relator().is_some_and(|relator| relator.is_empty()) { 2 } else { 1 };
            assert_eq!(cover.euler_characteristic(), expected, "{name}");
            println!(
                "{name} {component}: {:?}, {:?} cells in {:?}; canonical system in {system_time:?}",
                cover.sphere_sizes(),
                cover.f_vector(),
                started.elapsed()
            );
            let has_layout = match domain.relator() {
                Some(relator) => (4..=240).contains(&relator.len()),
                None => cover.group().generator_count() == 1,
            };
            if has_layout {
                let started = Instant::now();
                let layout = cover.layout(&map, None).unwrap();
                println!("  layout in {:?}", started.elapsed());
                let inside = |[x, y]: &[f64; 2]| x * x + y * y < 1.0;
                assert!(layout.plane() == CoverPlane::Flat || layout.points().iter().all(inside));
                check_faces_of_first_copy(&map, &cover, &layout);
            }
        }
    }
}
