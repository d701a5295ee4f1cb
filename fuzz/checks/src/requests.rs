//! Requests about small models: every verb with options from bytes, and laws that its answer must satisfy.

use crate::models::check_model;
use arbitrary::{Arbitrary, Unstructured};
use coface::algebra::{Integer, RaggedArray};
use coface::answers::answer::{CocycleBasisMethod, EdgeWeights, to_json};
use coface::answers::{
    BlockRule, CocyclesRequest, CongruenceRequest, CutRequest, GivenChain, GroupsRequest, Growth,
    HomologyRequest, LayoutChoice, LayoutRequest, ModelCongruence, OperatorKind, OperatorRequest,
    PersistenceRequest, Producer, RelativeTo, RepairRequest, Report, ReportRequest, ShortPaths, SurfaceLoops,
    SurfaceModel, SurfaceRepairRequest, VertexFunction, model_of_simplices, repaired, repaired_surface,
    simplicial_complex, text, triangulated,
};
use coface::complexes::cubical::CubicalVolume;
use coface::complexes::lar::{Operator, Shared};
use coface::complexes::simplicial::SimplexSet;
use coface::complexes::surface::{FacesAtEdge, GeneralizedMap, PolygonMesh};
use coface::geometry::Positions;
use coface::io::{Format, Structure, read, write};
use coface::pictures::{GltfForm, Picture, PictureStyle, Scene, gltf};
use coface::topology::{Bounding, CoverExtent, HomologyBasis, cohomology, homology_with};
use coface::{AbelianGroup, ChainComplex, Coefficients, Model, Simplex, VertexId, homology};
use std::time::Duration;

/// A verb and its options.
#[derive(Arbitrary, Debug)]
enum Question {
    Info { has_moments: bool, is_full: bool },
    Homology(HomologyOptions),
    Groups { is_simplified: bool, base: Option<u8>, has_loops: bool, index: Option<u8> },
    Loops { loops: u8, kind: Option<u8>, through: Option<u8> },
    Cut { simplify: bool, rounds: Option<u8>, base: Option<u8>, path: Vec<u8> },
    Cover { component: u8, radius: Option<u8>, copies: u8, layout: u8, is_double: bool },
    Cocycles { method: Option<u8>, weights: Option<bool>, is_harmonic: bool },
    Operator { degrees: (u8, u8), kind: u8, least: u8 },
    Persistence { is_upper: bool, function: u8, values: Vec<i8>, prime: u8, least: u8 },
    Congruence { tolerance: u8, blocks: u8 },
    Simplices { simplices: Vec<Vec<u8>>, dimension: u8 },
    Repair { request: u8, closed: bool, tolerance: Option<u8> },
    Triangles,
    Picture { is_dark: bool, edges: Option<bool> },
    Conversion { format: u8, again: u8 },
}

#[derive(Arbitrary, Debug)]
struct HomologyOptions {
    coefficients: u8,
    is_cohomology: bool,
    is_reduced: bool,
    part: Option<Vec<Vec<u8>>>,
    is_relative: bool,
    has_sequence: bool,
    has_generators: bool,
    cup: Option<(u8, u8)>,
    has_form: bool,
    has_harmonic: bool,
    cycle: Vec<(i8, Vec<u8>)>,
}

/// A question about a list of facets of at most ten vertices.
pub fn ask_facets(bytes: &[u8]) {
    let mut bytes = Unstructured::new(bytes);
    let Ok((question, facets)) = <(Question, Vec<Vec<u8>>)>::arbitrary(&mut bytes) else { return };
    if let Some(model) = model_of_facets(&facets) {
        ask(model, &question);
    }
}

/// A question about polygons of at most twelve vertices with small integers as coordinates.
pub fn ask_polygons(bytes: &[u8]) {
    let mut bytes = Unstructured::new(bytes);
    type Drawn = (Question, [(u8, u8, u8); 12], Vec<Vec<u8>>, bool);
    let Ok((question, points, polygons, is_planar)) = Drawn::arbitrary(&mut bytes) else { return };
    let flat = |&(x, y, z): &(u8, u8, u8)| -> Vec<f64> {
        let all = [x, y, z].map(|x| f64::from(x % 9));
        if is_planar { all[..2].to_vec() } else { all.to_vec() }
    };
    let dimension = if is_planar { 2 } else { 3 };
    let positions =
        Positions::from_flat(dimension, points.iter().flat_map(flat).collect()).expect("whole points");
    let polygons = polygons
        .iter()
        .take(12)
        .map(|polygon| polygon.iter().take(6).map(|v| u32::from(v % 12)).collect::<Vec<u32>>());
    if let Ok(model) = Model::from_polygons(positions, RaggedArray::from_lists(polygons)) {
        ask(model, &question);
    }
}

/// A question about voxels of two or three axes, some of them periodic.
pub fn ask_voxels(bytes: &[u8]) {
    let mut bytes = Unstructured::new(bytes);
    type Array = (Question, [u8; 3], [bool; 3], bool, u64);
    let Ok((question, lengths, is_periodic, is_flat, bits)) = Array::arbitrary(&mut bytes) else { return };
    let count = if is_flat { 2 } else { 3 };
    let shape: Vec<u32> = lengths[..count].iter().map(|&length| 1 + u32::from(length) % 4).collect();
    let number =
        |voxel: &[u32]| voxel.iter().zip(&shape).fold(0, |number, (&x, &length)| number * length + x);
    let volume = CubicalVolume::new(&shape, &is_periodic[..count], |voxel| bits >> number(voxel) & 1 == 1);
    if let Ok(volume) = volume {
        ask(Model::from_structure(Structure::Volume(volume)), &question);
    }
}

fn euler_characteristic(map: &GeneralizedMap) -> i64 {
    map.vertex_count() as i64 - map.edge_count() as i64 + map.face_count() as i64
}

fn model_of_facets(facets: &[Vec<u8>]) -> Option<Model> {
    let lists = facets.iter().take(14).map(|facet| {
        let mut facet: Vec<u32> = facet.iter().take(5).map(|v| u32::from(v % 10)).collect();
        facet.sort_unstable();
        facet.dedup();
        facet
    });
    let lists: Vec<Vec<u32>> = lists.filter(|facet| !facet.is_empty()).collect();
    let text = to_json(&lists);
    read(text.as_bytes(), Format::Json).ok()
}

/// Answers a question, and looks at what must hold for every model and for the answer. Refusals are fine.
fn ask(model: Model, question: &Question) {
    check_model(&model);
    // The number of vertices is at most so, as are the numbers that options name.
    let vertex = |number: u8| u32::from(number % 16);
    let name = "model";
    match question {
        Question::Info { has_moments, is_full } => {
            let moments = if *has_moments { vec![[0, 0, 0], [1, 0, 2]] } else { Vec::new() };
            let request = ReportRequest::new().moments(moments).full_verdict(*is_full);
            let Ok(report) = Report::answering(model, &request) else { return };
            let signs = |counts: &mut dyn Iterator<Item = usize>| -> i64 {
                counts
                    .enumerate()
                    .map(|(i, count)| if i % 2 == 0 { count as i64 } else { -(count as i64) })
                    .sum()
            };
            assert_eq!(
                report.euler_characteristic(),
                signs(&mut report.homology().iter().map(AbelianGroup::betti))
            );
            assert!(!text::report(name, "json", &report, 10).is_empty());
        }
        Question::Homology(options) => ask_homology(model, options),
        Question::Groups { is_simplified, base, has_loops, index } => {
            let Ok(producer) = Producer::of(model) else { return };
            let Ok(complex) = producer.chain_complex() else { return };
            let request = GroupsRequest::new()
                .simplified(*is_simplified)
                .base(base.map(vertex))
                .loops(*has_loops)
                .subgroups(index.map(|index| usize::from(index % 4)))
                .time_limit(Some(Duration::from_millis(200)));
            let Ok(found) = request.found(&producer) else { return };
            let betti: usize =
                found.presentations().map(|presentation| presentation.abelianization().betti()).sum();
            assert_eq!(betti, homology(&complex).betti_numbers().get(1).copied().unwrap_or(0));
            to_json(&found.answer(name));
        }
        Question::Loops { loops, kind, through } => {
            let Ok(producer) = Producer::of(model) else { return };
            let loops =
                [SurfaceLoops::Any, SurfaceLoops::Shortest, SurfaceLoops::Canonical][usize::from(loops % 3)];
            let request =
                GroupsRequest::new().surface_loops(loops).time_limit(Some(Duration::from_millis(200)));
            let request = match kind {
                Some(kind) => {
                    let kinds =
                        [ShortPaths::NonContractible, ShortPaths::NonSeparating, ShortPaths::HomologyBasis];
                    request.short_paths(kinds[usize::from(kind % 3)], through.map(vertex))
                }
                None => request,
            };
            if let Ok(found) = request.found(&producer) {
                to_json(&found.answer(name));
                drop(found.loops_answer(name));
            }
        }
        Question::Cut { simplify, rounds, base, path } => {
            let Ok(surface) = SurfaceModel::of(model) else { return };
            let base = base.and_then(|base| surface.vertex(vertex(base)));
            let request = CutRequest {
                simplify: *simplify,
                rounds: rounds.map(usize::from),
                base,
                roles: false,
                canonical: false,
                layout: None,
            };
            let drawn = CutRequest { base, layout: Some(LayoutRequest::default()), ..CutRequest::default() };
            for request in [request, drawn] {
                if let Ok(cut) = surface.cut_open(&request) {
                    assert!(cut.components().iter().all(|component| component.euler_characteristic() == 1));
                    to_json(&cut.answer());
                    drop(cut.model());
                }
            }
            let path: Vec<u32> = path.iter().take(8).map(|&v| vertex(v)).collect();
            if let Ok(cut) = surface.cut_along(&path) {
                to_json(&cut.answer());
                drop(cut.model());
            }
        }
        Question::Cover { component, radius, copies, layout, is_double } => {
            let Ok(surface) = SurfaceModel::of(model) else { return };
            if *is_double {
                let below = euler_characteristic(surface.map());
                if let Ok((above, model)) = surface.orientation_double_cover() {
                    assert_eq!(euler_characteristic(&above), 2 * below);
                    check_model(&model);
                }
            }
            let extent = match radius {
                Some(radius) => CoverExtent::Radius(usize::from(radius % 4)),
                None => CoverExtent::Copies(usize::from(*copies)),
            };
            let Ok(cover) = surface.cover(usize::from(*component), extent, 20_000) else { return };
            let layout = [LayoutChoice::Any, LayoutChoice::Flat, LayoutChoice::Disk, LayoutChoice::Klein]
                [usize::from(layout % 4)];
            let placed = cover.placed(layout).ok();
            to_json(&cover.answer(placed.as_ref()));
            if let Ok(model) = cover.model(placed.as_ref()) {
                check_model(&model);
            }
        }
        Question::Cocycles { method, weights, is_harmonic } => {
            let Ok(producer) = Producer::of(model) else { return };
            let methods =
                [CocycleBasisMethod::Crossing, CocycleBasisMethod::Slicing, CocycleBasisMethod::General];
            let request =
                CocyclesRequest::new()
                    .method(method.map(|method| methods[usize::from(method % 3)]))
                    .weights(weights.map(|is_uniform| {
                        if is_uniform { EdgeWeights::Uniform } else { EdgeWeights::Cotangent }
                    }))
                    .harmonic(*is_harmonic);
            let Ok(found) = request.found(&producer) else { return };
            let complex = producer.chain_complex().expect("cocycles are of a complex");
            for cocycle in found.cocycles() {
                assert_eq!(complex.is_closed(cocycle), Ok(true));
            }
            assert_eq!(
                found.cocycles().len(),
                homology(&complex).betti_numbers().get(1).copied().unwrap_or(0)
            );
            to_json(&found.answer(name));
            drop(found.model());
        }
        Question::Operator { degrees, kind, least } => {
            let Ok(producer) = Producer::of(model) else { return };
            let least = u32::from(*least);
            let kinds = [
                OperatorKind::Counts,
                OperatorKind::Incident,
                OperatorKind::Signed,
                OperatorKind::Shared(Shared::AtLeast(least)),
                OperatorKind::Shared(Shared::Exactly(least)),
                OperatorKind::Shared(Shared::AllOfRow),
                OperatorKind::Shared(Shared::AllOfColumn),
            ];
            let operator = Operator::new(usize::from(degrees.0 % 5), usize::from(degrees.1 % 5));
            let request = OperatorRequest::new(operator, kinds[usize::from(kind % 7)]).entries(true);
            if let Ok(found) = request.found(&producer) {
                to_json(&found.answer(name));
            }
        }
        Question::Persistence { is_upper, function, values, prime, least } => {
            let Ok(producer) = Producer::of(model) else { return };
            let function = match function % 5 {
                0 => None,
                1 => Some(VertexFunction::Number),
                axis @ (2 | 3) => Some(VertexFunction::Coordinate(usize::from(axis) - 2)),
                _ => {
                    let mut values: Vec<f64> = values.iter().map(|&x| f64::from(x)).collect();
                    values.resize(10, 0.5);
                    Some(VertexFunction::Values { place: name.to_owned(), values })
                }
            };
            let growth = if *is_upper { Growth::Upper(function) } else { Growth::Lower(function) };
            let prime = Coefficients::Modulo([2, 3, 5][usize::from(prime % 3)]);
            let request = PersistenceRequest::new().growth(growth).coefficients(prime);
            let Ok(found) = request.found(name, &producer) else { return };
            let complex = producer.chain_complex().expect("a diagram is of a complex");
            let mut expected = homology_with(&complex, prime).betti_numbers();
            let mut essential = found.diagram().betti_numbers();
            for betti in [&mut expected, &mut essential] {
                while betti.last() == Some(&0) {
                    betti.pop();
                }
            }
            assert_eq!(essential, expected, "what never dies is the homology of the whole");
            to_json(&found.answer());
            let request = request.min_persistence(f64::from(*least));
            drop(request.found(name, &producer).map(|found| to_json(&found.answer())));
        }
        Question::Congruence { tolerance, blocks } => {
            let mut request = CongruenceRequest::within(f64::from(tolerance % 32) / 8.0);
            request.blocks =
                [BlockRule::Models, BlockRule::Components, BlockRule::None][usize::from(blocks % 3)];
            let Ok(found) = ModelCongruence::of(vec![(name.to_owned(), model)], &request) else { return };
            assert_eq!(found.products_are_zero(), Ok(true));
            let answer = found.answer().expect("what was found is told");
            assert_eq!(answer.euler_characteristic, found.complex().euler_characteristic());
            drop(found.to_mesh().map(|model| check_model(&model)));
            drop(found.to_chains().map(|model| check_model(&model)));
        }
        Question::Simplices { simplices, dimension } => {
            ask_simplices(&model, simplices, usize::from(dimension % 6));
        }
        Question::Repair { request, closed, tolerance } => {
            let split =
                [None, Some(FacesAtEdge::Apart), Some(FacesAtEdge::CoherentPairs)][usize::from(request % 3)];
            let mut splitting = RepairRequest::default();
            splitting.split_edges = split;
            splitting.split_vertices = request & 4 != 0;
            splitting.orient = request & 8 != 0;
            splitting.orient_parts = request & 16 != 0;
            if let Ok((model, _)) = repaired(&model, splitting) {
                check_model(&model);
            }
            let request = SurfaceRepairRequest::new().closed(*closed);
            let request = match tolerance {
                Some(tolerance) => request.tolerance(f64::from(*tolerance) / 16.0),
                None => request,
            };
            if let Ok((model, _)) = repaired_surface(&model, &request) {
                check_model(&model);
                let Ok(mesh) = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &[]) else {
                    return;
                };
                let verdict = mesh.manifold_verdict();
                assert!(verdict.is_manifold(), "what is repaired is a surface");
                assert!(!closed || verdict.is_closed(), "what is closed has no boundary");
            }
        }
        Question::Triangles => {
            if let Ok((cut, carriers)) = triangulated(&model) {
                check_model(&cut);
                assert!(cut.polygons().iter().all(|polygon| polygon.len() == 3));
                drop(carriers);
            }
        }
        Question::Picture { is_dark, edges } => {
            let Ok(scene) = Scene::of(name, &model) else { return };
            let scene = scene.with_boundary();
            to_json(&scene.document());
            let mut style = PictureStyle::default();
            style.is_dark = *is_dark;
            style.edges = *edges;
            style.size = [40, 30];
            if let Ok(picture) = Picture::new(&scene, &style) {
                assert!(picture.svg().ends_with("</svg>\n"));
            }
            if let Ok(bytes) = gltf(&scene, None, GltfForm::Binary) {
                drop(read(&bytes[..], Format::Gltf).expect("what is written is read"));
            }
        }
        Question::Conversion { format, again } => {
            let chosen = |number: &u8| Format::ALL[usize::from(*number) % Format::ALL.len()];
            let groups = |model: Model| {
                let complex = Producer::of(model).ok()?.chain_complex().ok()?;
                let mut groups = homology(&complex).groups().to_vec();
                while groups.last().is_some_and(AbelianGroup::is_trivial) {
                    groups.pop();
                }
                Some(groups)
            };
            // A file of voxels does not say which axes are periodic.
            if matches!(model.structure(), Some(Structure::Volume(volume)) if volume.is_periodic().contains(&true))
            {
                return;
            }
            let mut model = model;
            let expected = groups(model.clone());
            for format in [chosen(format), chosen(again)] {
                let mut written = Vec::new();
                if write(&model, &mut written, format).is_err() {
                    return;
                }
                model = read(&written[..], format).expect("what is written is read");
                check_model(&model);
                // These hold triangles by their coordinates, segments, or no vertices without cells.
                if !matches!(
                    format,
                    Format::Stl
                        | Format::ThreeMf
                        | Format::Amf
                        | Format::Lines
                        | Format::GeoJson
                        | Format::Wkt
                        | Format::Wkb
                        | Format::WkbHex
                        | Format::Svg
                ) {
                    assert_eq!(groups(model.clone()), expected, "{} keeps homology", format.title());
                } else {
                    return;
                }
            }
        }
    }
}

/// Groups of several coefficients, cohomology and generators agree by the universal coefficient theorem; then what else is asked.
fn ask_homology(model: Model, options: &HomologyOptions) {
    let part = options.part.as_ref().and_then(|part| model_of_facets(part));
    let producer = Producer::of(model.clone());
    if let Ok(complex) = producer.and_then(|producer| producer.chain_complex()) {
        check_groups(&complex);
    }
    let names = [
        Coefficients::Integers,
        Coefficients::Rationals,
        Coefficients::Modulo(2),
        Coefficients::Modulo(3),
        Coefficients::Modulo(4),
        Coefficients::Modulo(6),
        Coefficients::Modulo(65537),
    ];
    let relative = match part {
        Some(part) => Some(RelativeTo::Part { name: "part".to_owned(), model: Box::new(part) }),
        None if options.is_relative => Some(RelativeTo::Boundary),
        None => None,
    };
    let terms = options.cycle.iter().take(6).map(|(coefficient, cell)| {
        let cell: Vec<u32> = cell.iter().take(4).map(|v| u32::from(v % 10)).collect();
        (i64::from(*coefficient).into(), cell)
    });
    let cycle = GivenChain { place: "cycle".to_owned(), degree: None, terms: terms.collect() };
    let request = HomologyRequest::new()
        .coefficients(names[usize::from(options.coefficients) % names.len()])
        .cohomology(options.is_cohomology)
        .reduced(options.is_reduced)
        .relative(relative)
        .sequence(options.has_sequence)
        .generators(options.has_generators)
        .cup(options.cup.map(|(p, q)| [usize::from(p % 4), usize::from(q % 4)]))
        .intersection_form(options.has_form)
        .harmonic(options.has_harmonic)
        .cycles(if options.cycle.is_empty() { Vec::new() } else { vec![cycle] });
    let Ok(found) = request.found("model", model) else { return };
    let answer = found.answer();
    assert!(
        answer.sequence.as_ref().is_none_or(|sequence| sequence.exact),
        "the sequence of a pair is exact"
    );
    to_json(answer);
    drop(found.generators_model());
}

fn check_groups(complex: &ChainComplex) {
    let integral = homology(complex);
    let betti = integral.betti_numbers();
    assert_eq!(integral.euler_characteristic(), complex.euler_characteristic(), "alternating sums agree");
    let rational = homology_with(complex, Coefficients::Rationals);
    assert_eq!(rational.betti_numbers(), betti);
    let torsion = |degree: usize, prime: i64| {
        let orders = integral.torsion().get(degree).map_or(&[][..], |orders| orders);
        orders.iter().filter(|order| Integer::from(prime).divides(order)).count()
    };
    for prime in [2, 3, 5] {
        let field = homology_with(complex, Coefficients::Modulo(prime as u64)).betti_numbers();
        for (degree, &dimension) in field.iter().enumerate() {
            let below = if degree > 0 { torsion(degree - 1, prime) } else { 0 };
            assert_eq!(
                dimension,
                betti[degree] + torsion(degree, prime) + below,
                "degree {degree} over F_{prime}"
            );
        }
    }
    let dual = cohomology(complex, Coefficients::Integers);
    for (degree, group) in dual.groups().iter().enumerate() {
        assert_eq!(group.betti(), betti.get(degree).copied().unwrap_or(0));
        let below = if degree > 0 { integral.groups()[degree - 1].torsion() } else { &[] };
        assert_eq!(group.torsion(), below, "torsion of cohomology is that of homology one degree below");
    }
    let basis = HomologyBasis::new(complex);
    assert_eq!(basis.homology().groups(), integral.groups());
    for degree in 0..complex.degree_count() {
        for (i, generator) in basis.generators(degree).iter().enumerate() {
            assert_eq!(complex.is_cycle(generator.chain()), Ok(true));
            let bounding = basis.bounding(generator.chain()).expect("a cycle is looked at");
            match (generator.order(), bounding) {
                (None, Bounding::Never { .. }) => {}
                (Some(order), Bounding::MultipleBounds { multiple, .. }) => assert_eq!(&multiple, order),
                (order, _) => panic!("generator {i} of degree {degree} has not the order {order:?}"),
            }
        }
    }
}

/// Star, closure, link, boundary, interior and skeleton of some simplices.
fn ask_simplices(model: &Model, simplices: &[Vec<u8>], dimension: usize) {
    let Ok(complex) = simplicial_complex(model) else { return };
    let chosen: SimplexSet = simplices
        .iter()
        .take(6)
        .filter_map(|simplex| {
            Simplex::new(simplex.iter().take(4).map(|&v| VertexId::from_u32(u32::from(v % 10)))).ok()
        })
        .collect();
    let Ok(star) = complex.star(chosen.clone()) else {
        assert!(
            chosen.iter().any(|simplex| !complex.contains(simplex)),
            "a star of simplices of the complex"
        );
        return;
    };
    let closure = complex.closure(chosen.clone()).expect("a closure of simplices of the complex");
    let link = complex.link(chosen.clone()).expect("a link of simplices of the complex");
    let closed_star = complex.closure(star.clone()).expect("a star is of the complex");
    let star_of_closure = complex.star(SimplexSet::from(&closure)).expect("a closure is of the complex");
    let expected = SimplexSet::from(&closed_star).difference(&star_of_closure);
    let link = SimplexSet::from(&link);
    assert_eq!(link, expected, "the link is the closed star without the star of the closure");
    drop(complex.interior(chosen.clone()));
    drop(complex.boundary_complex(chosen));
    if let Ok(skeleton) = complex.skeleton(dimension) {
        assert!(skeleton.dimension().is_none_or(|found| found <= dimension));
    }
    drop(model_of_simplices(&star, model, false).map(|model| check_model(&model)));
    drop(model_of_simplices(&link, model, true).map(|model| check_model(&model)));
}
