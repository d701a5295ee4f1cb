//! Real drawings: what the files hold, what the report says of them, and the regions that their rings bound.
#![allow(clippy::unwrap_used, reason = "tests")]
#![allow(clippy::print_stderr, reason = "a test says what it skips")]

use coface_algebra::RaggedArray;
use coface_answers::{Kind, Report};
use coface_arrange::planar::PlanarRegions;
use coface_io as io;
use coface_io::{CellData, Format, GroupKind, Model};
use std::path::PathBuf;

fn data_folder(test: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("COFACE_DATA").map(PathBuf::from);
    if folder.is_none() {
        eprintln!("{test}: COFACE_DATA is not set, so this is skipped");
    }
    folder
}

fn column(model: &Model, name: &str) -> Vec<i64> {
    let data = model.data_named(name, GroupKind::Lines).unwrap();
    (0..data.len()).flat_map(|i| data.integer_row(i).unwrap()).collect()
}

/// The area inside an odd number of rings of one polygon, added over the polygons; the area inside of any.
fn areas(model: &Model) -> (f64, f64) {
    let rings = RaggedArray::from_lists(model.lines().iter().map(|line| &line[..line.len() - 1]));
    // One region a ring: holes may run in either direction.
    let polygons = column(model, "polygon");
    let regions: Vec<u32> = (0..rings.len() as u32).collect();
    let regions = PlanarRegions::new(model.positions(), &rings, &regions).unwrap();
    let areas = regions.arrangement().areas();
    let (mut sum, mut union) = (0.0, 0.0);
    for face in regions.faces_where(|_| true) {
        let mut around: Vec<i64> = regions
            .winding_numbers(face)
            .iter()
            .filter(|(_, winding)| winding % 2 != 0)
            .map(|&(ring, _)| polygons[ring as usize])
            .collect();
        around.sort_unstable();
        let inside = around.chunk_by(|a, b| a == b).filter(|rings| rings.len() % 2 == 1).count();
        sum += areas[face.index()] * inside as f64;
        union += if inside > 0 { areas[face.index()] } else { 0.0 };
    }
    (sum, union)
}

#[test]
fn maps_are_what_the_manifest_says() {
    let Some(data) = data_folder("maps_are_what_the_manifest_says") else { return };
    let manifest: serde_json::Value =
        serde_json::from_slice(&std::fs::read(data.join("MANIFEST.json")).unwrap()).unwrap();
    let mut seen = 0;
    for record in manifest["files"].as_array().unwrap() {
        let name = record["file"].as_str().unwrap();
        if !name.starts_with("planar/") || name.ends_with(".svg") {
            continue;
        }
        seen += 1;
        let model = io::read_path(data.join(name), None).unwrap();
        assert_eq!(model.format(), Some(Format::GeoJson), "{name}");
        assert!(model.remarks().is_empty(), "{name}");
        let corners = record["ring_vertices"].as_u64().unwrap() as usize;
        let (polygons, rings) = match record["rings"].as_u64() {
            Some(rings) => (1, rings),
            None => {
                let polygons = record["polygons"].as_u64().unwrap();
                (polygons, polygons + record["holes"].as_u64().unwrap())
            }
        };
        assert_eq!((model.lines().len() as u64, model.vertex_count()), (rings, corners), "{name}");
        let outer = column(&model, "ring").iter().filter(|&&ring| ring == 0).count() as u64;
        assert_eq!(outer, polygons, "{name}");
        assert_eq!(column(&model, "polygon").iter().max(), Some(&(polygons as i64 - 1)), "{name}");
        // A map whose rings cross themselves has the area that a repair gives it: no truth for this.
        if record["invalid_features"].as_array().is_none_or(Vec::is_empty) {
            let truth = record["area_sum"].as_f64().or(record["area_shoelace"].as_f64()).unwrap();
            let (sum, union) = areas(&model);
            assert!((sum - truth).abs() < 1e-9 * truth, "{name}: {sum} for {truth}");
            if let Some(truth) = record["union"]["area"].as_f64() {
                assert!((union - truth).abs() < 1e-9 * truth, "{name}: {union} for {truth}");
            }
        }
        for format in [Format::GeoJson, Format::Wkt] {
            let mut out = Vec::new();
            io::write(&model, &mut out, format).unwrap();
            let back = io::read_unknown(&out[..]).unwrap();
            assert_eq!(back.format(), Some(format));
            assert_eq!((back.lines(), back.positions()), (model.lines(), model.positions()), "{name}");
            // Rows of WKT have no names: features of several polygons are told by their numbers.
            let told = |found: &Model| -> Vec<CellData> {
                found.data().iter().filter(|data| data.name() != "feature").cloned().collect()
            };
            assert_eq!(told(&back), told(&model), "{name}");
            assert!(format == Format::Wkt || back == model, "{name}");
        }
        let report = Report::of(model).unwrap();
        assert_eq!(report.kind(), Kind::Planar, "{name}");
        assert_eq!(report.f_vector(), [corners, corners], "{name}");
        assert_eq!((report.components() as u64, report.euler_characteristic()), (rings, 0), "{name}");
    }
    assert_eq!(seen, 6);
}

#[test]
fn a_drawing_in_svg_is_what_the_manifest_says() {
    let Some(data) = data_folder("a_drawing_in_svg_is_what_the_manifest_says") else { return };
    let model = io::read_path(data.join("planar/polygon.svg"), None).unwrap();
    assert_eq!((model.format(), model.vertex_count()), (Some(Format::Svg), 12));
    let (sum, union) = areas(&model);
    assert!((sum - 11398.38366).abs() < 1e-6 && (sum - union).abs() < 1e-9, "{sum} {union}");
    let mut out = Vec::new();
    io::write(&model, &mut out, Format::Svg).unwrap();
    assert_eq!(io::read_unknown(&out[..]).unwrap(), model);
}

#[test]
fn names_of_countries_are_groups() {
    let Some(data) = data_folder("names_of_countries_are_groups") else { return };
    let model = io::read_path(data.join("planar/ITA.geo.json"), None).unwrap();
    let group = &model.groups()[0];
    assert_eq!((group.name(), group.kind(), group.members()), ("Italy", GroupKind::Lines, &[0, 1, 2][..]));
}

#[test]
fn segments_that_meet_are_connected() {
    let Some(data) = data_folder("segments_that_meet_are_connected") else { return };
    // The sides of a rectangle, and other segments.
    for i in 1..=4 {
        let path = data.join(format!("planar/test{i}.lines"));
        let text = std::fs::read_to_string(&path).unwrap();
        let lines: Vec<Vec<&str>> =
            text.lines().filter(|l| !l.is_empty()).map(|l| l.split(',').collect()).collect();
        // The coordinates of these files are written in one way, so equal points are equal texts.
        let mut ends: Vec<&[&str]> = lines.iter().flat_map(|line| line.chunks(2)).collect();
        ends.sort_unstable();
        ends.dedup();
        let model = io::read_path(&path, None).unwrap();
        assert_eq!(model.format(), Some(Format::Lines));
        let mut out = Vec::new();
        io::write(&model, &mut out, Format::Lines).unwrap();
        assert_eq!(io::read_unknown(&out[..]).unwrap(), model);
        let report = Report::of(model).unwrap();
        assert_eq!((report.kind(), report.f_vector()), (Kind::Planar, &[ends.len(), lines.len()][..]));
    }
}
