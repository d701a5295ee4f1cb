//! Mapped shapes against their topology and their measures.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::Error;
use coface_answers::{Answer, Report};
use coface_complexes::cell_mesh::cell_volumes;
use coface_complexes::shapes;
use coface_complexes::shapes::{CellKind, PlacedCells};
use coface_complexes::shapes::{DiskGrid, SphereGrid};
use coface_io::Model;
use std::f64::consts::PI;

/// A shape by a number of subdivisions, from 0 for the fewest that are allowed.
type Rule = fn(u32, CellKind) -> Result<PlacedCells, Error>;

/// What is known of a shape.
struct Truth {
    name: &'static str,
    rule: Rule,
    /// Whether it has cuboids too.
    has_cuboids: bool,
    betti: &'static [usize],
    /// The order of the torsion of degree 1.
    torsion: u32,
    /// The number of boundary loops of a surface, or of boundary components of a solid.
    boundary: usize,
    /// Length, area or volume, where a formula is known.
    measure: Option<f64>,
}

const DISK: &[usize] = &[1, 0, 0];
const RING: &[usize] = &[1, 1, 0];
const SPHERE: &[usize] = &[1, 0, 1];

fn table() -> Vec<Truth> {
    let row = |name, rule, has_cuboids, betti, boundary, measure| Truth {
        name,
        rule,
        has_cuboids,
        betti,
        torsion: 1,
        boundary,
        measure,
    };
    // The pitch of the helicoid over a full turn is 2, so c is 1 / pi.
    let c = 1.0 / PI;
    let helicoid = 1.5 * PI * (2.0 * (4.0 + c * c).sqrt() + c * c * (2.0 / c).asinh());
    let mut rows: Vec<Truth> = vec![
        row("circle", |n, _| shapes::circle(2.0, 3 + n), false, &[1, 1], 0, Some(4.0 * PI)),
        row(
            "helix",
            |n, _| shapes::helix(2.0, 1.0, -1.5, 1 + n),
            false,
            &[1, 0],
            2,
            Some(1.5 * (4.0 * PI).hypot(1.0)),
        ),
        row(
            "polar disk",
            |n, kind| shapes::disk(2.0, DiskGrid::Polar { rings: 1 + n, sectors: 3 + n }, kind),
            false,
            DISK,
            1,
            Some(4.0 * PI),
        ),
        row(
            "square disk",
            |n, kind| shapes::disk(2.0, DiskGrid::Square { subdivisions: 1 + n }, kind),
            true,
            DISK,
            1,
            Some(4.0 * PI),
        ),
        row("ring", |n, kind| shapes::ring(1.0, 2.0, [1 + n, 3 + n], kind), true, RING, 2, Some(3.0 * PI)),
        row(
            "helicoid",
            |n, kind| shapes::helicoid(0.0, 2.0, [2.0, 1.5], [1 + n, 1 + 2 * n], kind),
            true,
            DISK,
            1,
            Some(helicoid),
        ),
        row(
            "cylinder",
            |n, kind| shapes::cylinder(2.0, 3.0, [3 + n, 1 + n], kind),
            true,
            RING,
            2,
            Some(12.0 * PI),
        ),
        row("cone", |n, _| shapes::cone(3.0, 4.0, [3 + n, 1 + n]), false, DISK, 1, Some(15.0 * PI)),
        row(
            "icosahedral sphere",
            |n, kind| shapes::sphere(2.0, SphereGrid::Icosahedron { subdivisions: 1 + n }, kind),
            false,
            SPHERE,
            0,
            Some(16.0 * PI),
        ),
        row(
            "latitude sphere",
            |n, kind| shapes::sphere(2.0, SphereGrid::Latitude { meridians: 3 + n, bands: 2 + n }, kind),
            false,
            SPHERE,
            0,
            Some(16.0 * PI),
        ),
        row(
            "cube sphere",
            |n, kind| shapes::sphere(2.0, SphereGrid::Cube { subdivisions: 1 + n }, kind),
            true,
            SPHERE,
            0,
            Some(16.0 * PI),
        ),
        row(
            "torus",
            |n, kind| shapes::torus(3.0, 1.0, [3 + n, 3 + n], kind),
            true,
            &[1, 2, 1],
            0,
            Some(12.0 * PI * PI),
        ),
        row(
            "crown",
            |n, kind| shapes::crown(3.0, 1.0, [3 + n, 1 + n], kind),
            true,
            RING,
            2,
            Some(2.0 * PI * (3.0 * PI + 2.0)),
        ),
        row("moebius", |n, kind| shapes::moebius(2.0, 1.0, [3 + n, 1 + n], kind), true, RING, 1, None),
        row(
            "plate",
            |n, kind| Ok(shapes::plate_with_holes(2, 1 + n, kind)?.boundary()?.compacted()),
            true,
            &[1, 4, 1],
            0,
            Some(50.0),
        ),
        row(
            "cuboid",
            |n, kind| shapes::cuboid(&[1.0, 2.0, 3.0], &[1 + n, 2, 1], kind),
            true,
            &[1, 0, 0, 0],
            1,
            Some(6.0),
        ),
        row("ball", |n, kind| shapes::ball(2.0, 1 + n, kind), true, &[1, 0, 0, 0], 1, Some(32.0 / 3.0 * PI)),
        row(
            "rod",
            |n, kind| shapes::rod(2.0, 3.0, [1 + n, 1], kind),
            true,
            &[1, 0, 0, 0],
            1,
            Some(12.0 * PI),
        ),
        row(
            "solid torus",
            |n, kind| shapes::solid_torus(3.0, 1.0, [1 + n, 3 + 3 * n], kind),
            true,
            &[1, 1, 0, 0],
            1,
            Some(6.0 * PI * PI),
        ),
        row(
            "hollow cylinder",
            |n, kind| shapes::hollow_cylinder([1.0, 2.0], 3.0, [1 + n, 3 + 3 * n, 1], kind),
            true,
            &[1, 1, 0, 0],
            1,
            Some(9.0 * PI),
        ),
        row(
            "hollow ball",
            |n, kind| {
                shapes::hollow_ball([1.0, 2.0], SphereGrid::Cube { subdivisions: 1 + n }, 1 + n / 2, kind)
            },
            true,
            &[1, 0, 1, 0],
            2,
            Some(28.0 / 3.0 * PI),
        ),
        row(
            "hollow icosahedral ball",
            |n, kind| {
                shapes::hollow_ball([1.0, 2.0], SphereGrid::Icosahedron { subdivisions: 1 + n }, 1, kind)
            },
            false,
            &[1, 0, 1, 0],
            2,
            Some(28.0 / 3.0 * PI),
        ),
        row(
            "plate solid",
            |n, kind| shapes::plate_with_holes(3, 1 + n, kind),
            true,
            &[1, 3, 0, 0],
            1,
            Some(18.0),
        ),
    ];
    let klein = |name, rule: Rule| Truth { torsion: 2, ..row(name, rule, true, RING, 0, None) };
    rows.push(klein("klein bottle", |n, kind| shapes::klein_bottle(3.0, 1.0, [3 + n, 3 + n], kind)));
    rows.push(klein("klein bottle in 4d", |n, kind| {
        shapes::klein_bottle_in_4d(3.0, 1.0, [3 + n, 3 + n], kind)
    }));
    rows
}

fn kinds(truth: &Truth) -> &'static [CellKind] {
    if truth.has_cuboids { &[CellKind::Simplex, CellKind::Cuboid] } else { &[CellKind::Simplex] }
}

/// Length, area or volume.
fn measure(placed: &PlacedCells) -> f64 {
    let model = Model::from_placed_cells(placed.clone()).unwrap();
    match placed.dimension() {
        1 => placed.positions().distances(placed.cells().items()).unwrap().iter().sum(),
        2 => Report::of(model).unwrap().area().unwrap(),
        _ => cell_volumes(model.positions(), model.shapes(), model.cells()).unwrap().signed(),
    }
}

#[test]
fn shapes_have_their_topology_from_the_fewest_cells_on() {
    for truth in table() {
        for &kind in kinds(&truth) {
            for n in [0, 1, 2, 5] {
                let what = format!("{} of {} at {n}", truth.name, kind.plural());
                let placed = (truth.rule)(n, kind).unwrap_or_else(|error| panic!("{what}: {error}"));
                let (dimension, complex) = (placed.dimension(), placed.chain_complex().unwrap());
                let model = Model::from_placed_cells(placed.clone()).unwrap();
                let report = Report::of(model).unwrap();
                let is_orientable = !["moebius", "klein bottle", "klein bottle in 4d"].contains(&truth.name);
                assert_eq!(report.problems().is_empty(), is_orientable, "{what}: {:?}", report.warnings());
                assert_eq!(report.f_vector(), complex.f_vector(), "{what}");
                let betti: Vec<usize> =
                    report.homology().iter().map(coface_topology::AbelianGroup::betti).collect();
                assert_eq!(betti, truth.betti, "{what}");
                let torsion: Vec<String> =
                    report.homology()[1].torsion().iter().map(ToString::to_string).collect();
                let expected = if truth.torsion == 1 { vec![] } else { vec![truth.torsion.to_string()] };
                assert_eq!(torsion, expected, "{what}");
                let boundary = placed.boundary().unwrap();
                if dimension == 1 {
                    assert_eq!(boundary.cell_count(), truth.boundary, "{what}");
                    continue;
                }
                assert_eq!(report.manifold(), Answer::Yes, "{what}: {:?}", report.witness());
                assert_eq!(report.is_coherently_oriented(), Some(is_orientable), "{what}");
                assert_eq!(report.is_orientable(), Some(is_orientable), "{what}");
                if dimension == 2 {
                    assert_eq!(report.boundary_loops().unwrap().len(), truth.boundary, "{what}");
                    assert_eq!(report.is_closed(), Some(truth.boundary == 0), "{what}");
                    continue;
                }
                assert_eq!(report.skin().unwrap().components(), truth.boundary, "{what}");
                let model = Model::from_placed_cells(placed.clone()).unwrap();
                let volumes = cell_volumes(model.positions(), model.shapes(), model.cells()).unwrap();
                assert_eq!(volumes.positive_count(), placed.cell_count(), "{what}: positive cells");
                // The boundary is oriented outward: it encloses the same volume.
                let skin = Report::of(Model::from_placed_cells(boundary).unwrap()).unwrap();
                let enclosed = skin.signed_volume().unwrap();
                assert!((enclosed - volumes.signed()).abs() < 1e-9 * enclosed, "{what}: {enclosed}");
            }
        }
    }
}

#[test]
fn orientations_are_those_of_the_cells_before_they_became_a_model() {
    // A model turns 3-cells of space by itself; the list must be right without it.
    for truth in table() {
        for &kind in kinds(&truth) {
            let placed = (truth.rule)(2, kind).unwrap();
            if placed.positions().dimension() != placed.dimension() {
                continue;
            }
            let lifted = placed.clone().embedded(placed.dimension() + 1).unwrap();
            let (there, here) =
                (Model::from_placed_cells(lifted).unwrap(), Model::from_placed_cells(placed).unwrap());
            assert_eq!(there.cells(), here.cells(), "{}", truth.name);
            assert_eq!(there.polygons(), here.polygons(), "{}", truth.name);
        }
    }
}

#[test]
fn closed_surfaces_look_outward() {
    for truth in table() {
        for &kind in kinds(&truth) {
            let placed = (truth.rule)(3, kind).unwrap();
            let is_surface = placed.dimension() == 2;
            let report = Report::of(Model::from_placed_cells(placed).unwrap()).unwrap();
            if is_surface && report.is_closed() == Some(true) && report.is_orientable() == Some(true) {
                assert!(report.signed_volume().unwrap() > 0.0, "{}", truth.name);
            }
        }
    }
}

#[test]
fn sides_of_solids_look_outward() {
    let rises = |placed: PlacedCells, axis_distance: fn(&[f64]) -> [f64; 3]| {
        let model = Model::from_placed_cells(placed).unwrap();
        let point = |v: u32| model.positions().point(coface_algebra::VertexId::from_u32(v)).to_vec();
        for polygon in model.polygons().iter() {
            let [a, b, c] = [point(polygon[0]), point(polygon[1]), point(polygon[2])];
            let [u, v] = [&b, &c].map(|p| [0, 1, 2].map(|k| p[k] - a[k]));
            let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            let outward = axis_distance(&a);
            assert!((0..3).map(|k| normal[k] * outward[k]).sum::<f64>() > 0.0, "{polygon:?}");
        }
    };
    rises(shapes::cylinder(1.0, 2.0, [12, 3], CellKind::Cuboid).unwrap(), |p| [p[0], p[1], 0.0]);
    rises(shapes::cone(1.0, 2.0, [12, 1]).unwrap(), |p| [p[0], p[1], 1.0]);
    let crown = |p: &[f64]| {
        let r = p[0].hypot(p[1]);
        [p[0] * (1.0 - 3.0 / r), p[1] * (1.0 - 3.0 / r), p[2]]
    };
    rises(shapes::crown(3.0, 1.0, [24, 12], CellKind::Simplex).unwrap(), crown);
}

/// Halving the size of cells takes the error of an inscribed measure to a quarter.
#[test]
fn measures_converge_at_second_order() {
    for truth in table() {
        for &kind in kinds(&truth) {
            let dimension = truth.betti.len() - 1;
            let at = |n: u32| measure(&(truth.rule)(n, kind).unwrap());
            // The rules add small numbers to n, mostly 1 or 3: then errors fall by a little less than a quarter.
            let steps = match (dimension, truth.measure) {
                // Flat sides are exact at once.
                _ if truth.name.starts_with("plate") => [0, 1, 2],
                (3, _) => [3, 7, 15],
                (_, Some(_)) => [7, 15, 31],
                // Here 3 is added, and steps must double exactly.
                (_, None) => [21, 45, 93],
            };
            let [a, b, c] = steps.map(at);
            let what = format!("{} of {}: {a} {b} {c}", truth.name, kind.plural());
            let Some(exact) = truth.measure else {
                let ratio = (a - b) / (b - c);
                assert!((3.6..4.4).contains(&ratio), "{what}: {ratio}");
                continue;
            };
            let [a, b, c] = [a, b, c].map(|x| (x - exact).abs() / exact);
            if a < 1e-12 {
                assert!(b < 1e-12 && c < 1e-12, "{what}");
                continue;
            }
            let (first, second) = (a / b, b / c);
            assert!((3.0..4.9).contains(&first) && (3.4..4.7).contains(&second), "{what}: {first} {second}");
        }
    }
}

/// No edge meets a triangle but at its ends, exactly: the coordinates are small integers in general position.
#[test]
fn the_polyhedron_of_csaszar_does_not_cross_itself() {
    let torus = shapes::csaszar_torus().unwrap();
    let report = Report::of(Model::from_placed_cells(torus.clone()).unwrap()).unwrap();
    assert_eq!((report.name(), report.is_coherently_oriented()), (Some("torus"), Some(true)));
    assert!(report.signed_volume().unwrap() > 0.0);
    let corners: Vec<[i64; 3]> =
        torus.positions().as_flat().chunks(3).map(|p| [0, 1, 2].map(|k| p[k] as i64)).collect();
    let volume = |[a, b, c, d]: [u32; 4]| -> i64 {
        let [u, v, w] = [b, c, d].map(|p| [0, 1, 2].map(|k| corners[p as usize][k] - corners[a as usize][k]));
        u[0] * (v[1] * w[2] - v[2] * w[1])
            + u[1] * (v[2] * w[0] - v[0] * w[2])
            + u[2] * (v[0] * w[1] - v[1] * w[0])
    };
    let edges = torus.skeleton(1).unwrap();
    assert_eq!(edges.cell_count(), 21);
    for triangle in torus.cells().iter() {
        let &[a, b, c] = triangle else { panic!("no triangle") };
        for edge in edges.cells().iter().filter(|edge| edge.iter().all(|v| !triangle.contains(v))) {
            let &[p, q] = edge else { panic!("no edge") };
            let sides = [volume([a, b, c, p]), volume([a, b, c, q])].map(i64::signum);
            let around = [[p, q, a, b], [p, q, b, c], [p, q, c, a]].map(|list| volume(list).signum());
            assert!(!sides.contains(&0) && !around.contains(&0), "general position");
            let crosses = sides[0] != sides[1] && around[0] == around[1] && around[1] == around[2];
            assert!(!crosses, "{edge:?} crosses {triangle:?}");
        }
    }
}

#[test]
fn impossible_shapes_say_what_is_possible() {
    let fault = |result: Result<PlacedCells, Error>| result.unwrap_err().to_string();
    let (simplex, cuboid) = (CellKind::Simplex, CellKind::Cuboid);
    assert!(fault(shapes::circle(-1.0, 8)).contains("the radius is -1; give a positive number"));
    assert!(fault(shapes::circle(1.0, 2)).contains("segments is 2; take 3 or more"));
    assert!(fault(shapes::circle(f64::NAN, 8)).contains("radius is NaN"));
    assert!(fault(shapes::ring(2.0, 1.0, [1, 8], simplex)).contains("not less than the outer radius"));
    assert!(fault(shapes::torus(1.0, 2.0, [8, 8], simplex)).contains("minor radius, 2, is not less"));
    assert!(fault(shapes::helix(1.0, 1.0, 0.0, 8)).contains("turns is 0"));
    assert!(fault(shapes::helicoid(0.0, 1.0, [0.0, 1.0], [1, 8], simplex)).contains("pitch is 0"));
    let polar = DiskGrid::Polar { rings: 1, sectors: 8 };
    assert!(fault(shapes::disk(1.0, polar, cuboid)).contains("three corners; take triangles"));
    let globe = SphereGrid::Latitude { meridians: 8, bands: 4 };
    assert!(fault(shapes::sphere(1.0, globe, cuboid)).contains("the grid of a cube"));
    assert!(fault(shapes::ball(1.0, 1 << 20, cuboid)).contains("fewer subdivisions"));
    assert!(fault(shapes::cuboid(&[1.0], &[1, 2], cuboid)).contains("one of each for each axis"));
    assert!(fault(shapes::plate_with_holes(u32::MAX, 1, cuboid)).contains("2^31"));
    assert!(fault(shapes::hollow_ball([1.0, 1.0], globe, 1, simplex)).contains("not less"));
}
