//! Gluing tables, delta complexes and isomorphism signatures: random tables against second methods, small ones by hand.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, ErrorKind};
use coface_algebra::{Permutation, RaggedArray};
use coface_answers::{Pair, Producer, Report};
use coface_complexes::gluing::{FaceClasses, GluingFault, GluingTable};
use coface_complexes::simplicial::{DeltaComplex, FrozenComplex, SimplicialComplex};
use coface_io as io;
use coface_io::{Format, Model, Structure};
use coface_topology::{AbelianGroup, Coefficients, homology, homology_with};
use proptest::prelude::*;
use proptest::sample::Index;

/// The groups of a chain complex up to the last that is not trivial.
fn groups(chains: &ChainComplex) -> Vec<AbelianGroup> {
    let mut groups = homology(chains).groups().to_vec();
    while groups.last().is_some_and(AbelianGroup::is_trivial) {
        groups.pop();
    }
    groups
}

fn shown(chains: &ChainComplex) -> String {
    groups(chains).iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// A permutation told by a number.
fn permutation(count: usize, seed: u64) -> Permutation {
    let mut left: Vec<u32> = (0..count as u32).collect();
    let mut seed = seed;
    let images = (0..count).map(|_| {
        let place = (seed % left.len() as u64) as usize;
        seed /= left.len() as u64;
        left.remove(place)
    });
    Permutation::from_images(images.collect()).unwrap()
}

/// Simplices of one dimension with random pairs of facets glued at random; `close` glues until no two are left.
fn table(dimension: usize, count: usize, picks: &[(Index, Index, u64)], close: bool) -> GluingTable {
    let mut table = GluingTable::unglued(dimension, count).unwrap();
    let mut facets: Vec<(usize, usize)> = table.boundary_facets().collect();
    for round in 0.. {
        let Some((a, b, seed)) = picks.get(if close { round % picks.len().max(1) } else { round }) else {
            break;
        };
        if facets.len() < 2 {
            break;
        }
        let (i, f) = facets.swap_remove(a.index(facets.len()));
        let (j, g) = facets.swap_remove(b.index(facets.len()));
        // Any map of the facet: the others in some order, and f to g.
        let others: Vec<u32> = (0..=dimension as u32).filter(|&v| v as usize != g).collect();
        let order = permutation(dimension, seed.wrapping_mul(round as u64 / 7 + 1));
        let mut images = vec![g as u32; dimension + 1];
        (0..=dimension)
            .filter(|&v| v != f)
            .enumerate()
            .for_each(|(at, v)| images[v] = others[order.image(at)]);
        table.glue(i, f, j, &images).unwrap();
    }
    table.check().unwrap();
    table
}

fn tables(dimensions: std::ops::RangeInclusive<usize>, most: usize) -> impl Strategy<Value = GluingTable> {
    let picks = prop::collection::vec((any::<Index>(), any::<Index>(), any::<u64>()), 0..3 * most);
    (dimensions, 0..=most, picks, any::<bool>())
        .prop_map(|(dimension, count, picks, close)| table(dimension, count, &picks, close))
}

fn connected(table: &GluingTable) -> bool {
    table.components().count() == 1
}

/// The quotient, triangulated: a second way to every answer.
fn triangulated(faces: &FaceClasses) -> SimplicialComplex {
    faces.barycentric_subdivision().unwrap().triangulation().unwrap().0
}

/// The table of a simplicial complex has the verdict of the complex: spheres by collapses or moves, homology spheres as links by groups.
#[test]
fn tables_of_complexes_have_their_verdicts() {
    use coface_complexes::known_spaces::{cross_polytope_boundary, cyclic_torus, simplex_boundary};
    use coface_topology::{gluing_manifold_verdict, manifold_verdict};
    // The glued dodecahedron after edges were contracted whose ends have in common what the edge has: 206 tetrahedra in place of 2,880.
    let facets: Vec<Vec<u32>> = serde_json::from_str(include_str!("poincare.json")).unwrap();
    let poincare = SimplicialComplex::from_facets(facets).unwrap();
    assert_eq!(shown(&poincare.freeze().chain_complex().unwrap()), "Z, 0, 0, Z");
    let cone = poincare.cone().unwrap().0;
    for (name, complex, expected) in [
        ("a simplex", simplex_boundary(5).unwrap(), Some(true)),
        ("a cross polytope", cross_polytope_boundary(4).unwrap(), Some(true)),
        ("a torus", cyclic_torus(3).unwrap(), Some(true)),
        ("the cone of the Poincare sphere", cone, Some(false)),
        ("its suspension", poincare.suspension().unwrap().0, Some(false)),
    ] {
        let facets = complex.facets();
        let lists: Vec<&[u32]> = facets.iter().map(|facet| facet.numbers()).collect();
        let table = GluingTable::from_simplices(&RaggedArray::from_lists(lists)).unwrap();
        let faces = table.faces().unwrap();
        assert_eq!(faces.class_counts(), complex.f_vector(), "{name}");
        let verdict = gluing_manifold_verdict(&table, &faces).unwrap();
        assert_eq!(verdict.to_bool(), expected, "{name}: {verdict:?}");
        let frozen = complex.freeze();
        let of_complex = manifold_verdict(&frozen, &frozen.chain_complex().unwrap(), 1 << 30).unwrap();
        assert_eq!(of_complex.to_bool(), expected, "{name}");
    }
    for (lists, fault) in [
        (vec![vec![0, 1, 2], vec![0, 1, 3], vec![0, 1, 4]], "the facet [0, 1] lies in 3 simplices"),
        (vec![vec![0, 1, 2], vec![0, 1]], "simplex 1 has not 3"),
        (vec![vec![0, 1, 1]], "simplex 0 has not 3"),
    ] {
        let error = GluingTable::from_simplices(&RaggedArray::from_lists(lists)).unwrap_err();
        assert!(error.message().contains(fault), "{error}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn classes_and_subdivisions_have_one_homology(table in tables(1..=4, 4)) {
        let faces = table.faces().unwrap();
        let once = faces.barycentric_subdivision().unwrap();
        once.complex().check().unwrap();
        let chains = once.complex().chain_complex().unwrap();
        prop_assert_eq!(groups(&faces.chain_complex().unwrap()), groups(&chains));
        if !faces.has_folds() {
            prop_assert_eq!(faces.chain_complex().unwrap().euler_characteristic(), faces.alternating_count());
            prop_assert_eq!(faces.alternating_count(), chains.euler_characteristic());
        }
        if once.complex().f_vector().iter().sum::<usize>() < 1500 {
            let twice = once.subdivided().unwrap();
            prop_assert_eq!(groups(&chains), groups(&twice.complex().chain_complex().unwrap()));
            prop_assert_eq!(twice.complex().to_simplicial_complex().unwrap().f_vector(), twice.complex().f_vector());
        }
        if let Some(delta) = faces.to_delta() {
            delta.check().unwrap();
            prop_assert_eq!(delta.chain_complex().unwrap(), faces.chain_complex().unwrap());
        }
        // The 2-skeleton says the same of degrees 0 to 2.
        let (skeleton, chains) = (faces.two_skeleton().unwrap().chain_complex().unwrap(), faces.chain_complex().unwrap());
        for degree in 1..=2 {
            let matrix = chains.boundary_matrix(degree);
            prop_assert!(matrix.is_none_or(|matrix| Some(matrix) == skeleton.boundary_matrix(degree)));
        }
    }

    #[test]
    fn answers_agree_with_those_of_the_triangulation(table in tables(2..=3, 3)) {
        let faces = table.faces().unwrap();
        let fine = triangulated(&faces);
        let verdict = table.manifold_verdict(&faces).unwrap();
        prop_assert_eq!(verdict.to_bool(), fine.manifold_verdict().unwrap().to_bool(), "{:?}", table);
        prop_assert_eq!(fine.components().count(), table.components().count());
        let is_orientable = fine.orientability().unwrap().is_orientable();
        prop_assert!(is_orientable.is_none_or(|yes| Some(yes) == table.orientation().is_orientable()));
        if let Some(dimension) = fine.dimension() {
            let chains = fine.chain_complex().unwrap();
            let ridges = chains.coboundary_matrix(dimension - 1).unwrap();
            prop_assert_eq!(ridges.columns().all(|facets| facets.rows().len() == 2), table.is_closed());
        }
    }

    #[test]
    fn an_odd_chain_of_simplices_is_closed_and_odd(table in tables(1..=4, 5)) {
        let parity = |images: &[u8]| {
            (0..images.len()).flat_map(|i| (0..i).map(move |j| (i, j))).filter(|&(i, j)| images[i] < images[j]).count()
        };
        let found = table.orientation();
        let sign = |simplex: usize| found.sign(CellId::new(simplex));
        let mut conflicts = Vec::new();
        for i in 0..table.simplex_count() {
            for f in 0..=table.dimension() {
                let Some((j, images)) = table.neighbor(i, f) else { continue };
                if found.odd_cycle().is_none() {
                    prop_assert_eq!((sign(i) == sign(j)) as usize, parity(images) % 2);
                }
                if parity(images) % 2 == 0 && (i, f) <= (j, images[f] as usize) {
                    conflicts.push((CellId::new(i), f));
                }
            }
        }
        let listed: Vec<_> = found.conflicts().iter().map(|facet| (facet.simplex, facet.opposite)).collect();
        prop_assert_eq!(listed, conflicts);
        match found.odd_cycle() {
            None => prop_assert_eq!(found.is_orientable(), Some(true)),
            Some(cycle) => {
                prop_assert_eq!(found.is_orientable(), Some(false));
                let chain = cycle.facets();
                let mut reversals = 0;
                for (at, facet) in chain.iter().enumerate() {
                    prop_assert_eq!(facet.simplex, cycle.cells()[at]);
                    let (j, images) = table.neighbor(facet.simplex.index(), facet.opposite).unwrap();
                    prop_assert_eq!(CellId::new(j), chain[(at + 1) % chain.len()].simplex);
                    reversals += 1 + parity(images);
                }
                prop_assert_eq!(reversals % 2, 1);
            }
        }
    }

    #[test]
    fn tables_of_triangles_are_surfaces(table in tables(2..=2, 6)) {
        let faces = table.faces().unwrap();
        prop_assert!(!faces.has_folds());
        prop_assert_eq!(table.manifold_verdict(&faces).unwrap().to_bool(), Some(true));
        let report = Report::of(Model::from_structure(Structure::Gluings(table.clone()))).unwrap();
        prop_assert_eq!(report.f_vector(), faces.class_counts());
        let loops = report.boundary_loops().map_or(0, <[_]>::len);
        let open_edges = table.boundary_facets().count();
        if let Some(found) = report.boundary_loops() {
            prop_assert_eq!(found.iter().map(|part| part.edge_count()).sum::<usize>(), open_edges);
            let mut vertices: Vec<u32> = found.iter().flat_map(|part| part.vertices()).copied().collect();
            vertices.sort_unstable();
            let on_rim: Vec<u32> =
                (0..faces.class_counts()[0] as u32).filter(|&v| faces.is_boundary(0, CellId::from_u32(v))).collect();
            prop_assert_eq!(vertices, on_rim);
        }
        if connected(&table) {
            let surface = report.surface_type().unwrap();
            prop_assert_eq!(surface.euler_characteristic(), faces.alternating_count());
            prop_assert_eq!(surface.boundary_count(), loops);
            // The homology of the classified surface.
            let h = report.homology();
            let closed = loops == 0;
            let (rank, torsion) = match (surface.is_orientable(), closed) {
                (true, true) => (2 * surface.genus(), 0),
                (true, false) => (2 * surface.genus() + loops - 1, 0),
                (false, true) => (surface.genus() - 1, 1),
                (false, false) => (surface.genus() + loops - 1, 0),
            };
            prop_assert_eq!((h[1].betti(), h[1].torsion().len()), (rank, torsion));
            prop_assert_eq!(h[2].betti(), usize::from(closed && surface.is_orientable()));
        }
    }

    /// In a closed table of tetrahedra without folds twice the Euler characteristic is the sum of 2 minus that of each
    /// vertex link: count edges and triangles by the corners of links.
    #[test]
    fn links_count_the_euler_characteristic(table in tables(3..=3, 5)) {
        let faces = table.faces().unwrap();
        if !table.is_closed() || faces.has_folds() {
            return Ok(());
        }
        let links = table.vertex_links(&faces).unwrap();
        let defects: i64 = links.iter().map(|link| 2 - link.table().faces().unwrap().alternating_count()).sum();
        prop_assert_eq!(2 * faces.alternating_count(), defects);
    }

    #[test]
    fn links_are_connected_and_have_the_boundary_of_the_table(table in tables(2..=4, 4)) {
        let faces = table.faces().unwrap();
        let links = table.vertex_links(&faces).unwrap();
        prop_assert_eq!(links.len(), faces.class_counts().first().copied().unwrap_or(0));
        let corners: usize = links.iter().map(|link| link.corners().len()).sum();
        prop_assert_eq!(corners, table.simplex_count() * (table.dimension() + 1));
        for (vertex, link) in links.iter().enumerate() {
            link.table().check().unwrap();
            prop_assert!(connected(link.table()));
            prop_assert_eq!(link.table().is_closed(), !faces.is_boundary(0, CellId::new(vertex)));
        }
    }

    #[test]
    fn the_boundary_is_closed(table in tables(2..=4, 4)) {
        let (boundary, facets) = table.boundary_table().unwrap();
        boundary.check().unwrap();
        prop_assert!(boundary.is_closed());
        prop_assert_eq!(facets.len(), table.boundary_facets().count());
        let faces = table.faces().unwrap();
        // A face of a boundary facet is a boundary face.
        for &(simplex, facet) in &facets {
            for v in (0..=table.dimension()).filter(|&v| v != facet) {
                prop_assert!(faces.is_boundary(0, faces.class(simplex, &[v]).unwrap().0));
            }
        }
        if table.dimension() == 3 && table.manifold_verdict(&faces).unwrap().to_bool() == Some(true) {
            prop_assert_eq!(boundary.faces().unwrap().alternating_count(), 2 * faces.alternating_count());
        }
        if table.orientation().is_orientable() == Some(true) {
            prop_assert_eq!(boundary.orientation().is_orientable(), Some(true));
        }
    }

    /// Lefschetz duality over F_2: homology relative to the boundary is cohomology of the other degree. Without a manifold,
    /// the triangulation modulo its boundary is the second way.
    #[test]
    fn homology_relative_to_the_boundary(table in tables(1..=3, 3)) {
        let faces = table.faces().unwrap();
        let (chains, dimension) = (faces.chain_complex().unwrap(), table.dimension());
        let over_two = |chains: &ChainComplex| homology_with(chains, Coefficients::Modulo(2)).betti_numbers();
        let model = Model::from_structure(Structure::Gluings(table.clone())).as_pseudomanifold(true);
        let producer = Producer::of(model).unwrap();
        let pair = Pair::with_boundary(&producer, &chains).unwrap();
        let relative = over_two(pair.chains());
        if table.manifold_verdict(&faces).unwrap().to_bool() == Some(true) && table.simplex_count() > 0 {
            let mut dual = over_two(&chains);
            dual.resize(dimension + 1, 0);
            dual.reverse();
            prop_assert_eq!(&relative, &dual);
        }
        let lists = triangulated(&faces).facets();
        let lists = RaggedArray::from_lists(lists.iter().map(|simplex| simplex.vertices().map(|v| v.to_u32()).collect::<Vec<_>>()));
        let fine = Producer::of(Model::from_structure(Structure::Facets(lists))).unwrap();
        let fine_pair = Pair::with_boundary(&fine, &fine.chain_complex().unwrap()).unwrap();
        prop_assert_eq!(groups(pair.chains()), groups(fine_pair.chains()));
    }

    #[test]
    fn signatures_do_not_depend_on_names(
        table in tables(2..=4, 5), names in prop::collection::vec(any::<u64>(), 6)
    ) {
        let count = table.simplex_count();
        let vertices: Vec<Permutation> =
            (0..count).map(|i| permutation(table.dimension() + 1, names[i])).collect();
        let renamed = table.relabeled(&permutation(count, names[5]), &vertices).unwrap();
        renamed.check().unwrap();
        let signature = table.isomorphism_signature().unwrap();
        prop_assert_eq!(&signature, &renamed.isomorphism_signature().unwrap());
        let back = GluingTable::from_isomorphism_signature(&signature, table.dimension()).unwrap();
        back.check().unwrap();
        prop_assert_eq!(&signature, &back.isomorphism_signature().unwrap());
        let (faces, same) = (table.faces().unwrap(), back.faces().unwrap());
        prop_assert_eq!(faces.class_counts(), same.class_counts());
        prop_assert_eq!(groups(&faces.chain_complex().unwrap()), groups(&same.chain_complex().unwrap()));
    }

    #[test]
    fn texts_that_are_no_signatures_do_no_harm(text in "[a-e+*-]{0,3}[a-zA-Z0-9+-]{0,12}", dimension in 2_usize..5) {
        match GluingTable::from_isomorphism_signature(&text, dimension) {
            Ok(table) => table.check().unwrap(),
            Err(error) => {
                prop_assert_eq!(error.kind(), ErrorKind::Parse);
                prop_assert!(error.message().contains("character"), "{}", error);
            }
        }
    }

    #[test]
    fn tables_are_written_and_read_again(table in tables(1..=5, 4)) {
        let model = Model::from_structure(Structure::Gluings(table));
        let mut text = Vec::new();
        io::write(&model, &mut text, Format::Json).unwrap();
        let Some(Structure::Gluings(before)) = model.structure() else { unreachable!() };
        // A table without simplices does not tell its dimension.
        if before.simplex_count() > 0 {
            prop_assert_eq!(io::read(&text[..], Format::Json).unwrap(), model);
        }
    }

    #[test]
    fn quotients_of_simplices_keep_their_homology_when_subdivided(
        facets in prop::collection::vec(1_u32..5, 1..5),
        pairs in prop::collection::vec((0_usize..4, any::<Index>(), any::<Index>()), 0..6),
    ) {
        let lists = facets.iter().enumerate().map(|(i, &size)| (5 * i as u32..5 * i as u32 + size).collect::<Vec<u32>>());
        let apart = FrozenComplex::from_facets(&RaggedArray::from_lists(lists)).unwrap().to_delta().unwrap();
        let pairs = pairs.iter().filter(|pair| apart.simplex_count(pair.0) > 0).map(|(degree, a, b)| {
            let count = apart.simplex_count(*degree);
            (*degree, CellId::new(a.index(count)), CellId::new(b.index(count)))
        });
        let complex: DeltaComplex = apart.quotient(pairs).unwrap().0;
        let fine = complex.barycentric_subdivision().unwrap();
        let found = groups(&complex.chain_complex().unwrap());
        prop_assert_eq!(&found, &groups(&fine.complex().chain_complex().unwrap()));
        prop_assert_eq!(&found, &groups(&complex.triangulation().unwrap().0.chain_complex().unwrap()));
    }
}

/// The table of the suspension: two cones over each simplex, glued along it.
fn suspension(table: &GluingTable) -> GluingTable {
    let (apex, count) = (table.dimension() + 1, table.simplex_count());
    let mut suspension = GluingTable::unglued(apex, 2 * count).unwrap();
    for i in 0..count {
        let whole: Vec<u32> = (0..=apex as u32).collect();
        suspension.glue(i, apex, count + i, &whole).unwrap();
        for f in 0..apex {
            let Some((j, images)) = table.neighbor(i, f) else { continue };
            let images: Vec<u32> = images.iter().map(|&v| u32::from(v)).chain([apex as u32]).collect();
            for cone in [0, count] {
                if suspension.neighbor(cone + i, f).is_none() {
                    suspension.glue(cone + i, f, cone + j, &images).unwrap();
                }
            }
        }
    }
    suspension
}

fn one_tetrahedron(gluings: &[(usize, [u32; 4])]) -> GluingTable {
    let mut table = GluingTable::unglued(3, 1).unwrap();
    gluings.iter().for_each(|(facet, images)| table.glue(0, *facet, 0, images).unwrap());
    table
}

fn sphere() -> GluingTable {
    one_tetrahedron(&[(0, [1, 0, 2, 3]), (2, [0, 1, 3, 2])])
}

#[test]
fn a_sphere_of_one_tetrahedron() {
    let faces = sphere().faces().unwrap();
    assert_eq!(faces.class_counts(), [2, 3, 2, 1]);
    assert_eq!(shown(&faces.chain_complex().unwrap()), "Z, 0, 0, Z");
    assert_eq!(sphere().manifold_verdict(&faces).unwrap().as_str(), "yes");
    assert_eq!(sphere().orientation().is_orientable(), Some(true));
}

/// Facet 012 glued to facet 123: two triangles are left, and they are a torus.
#[test]
fn a_solid_torus_of_one_tetrahedron() {
    let solid = one_tetrahedron(&[(3, [1, 2, 3, 0])]);
    let faces = solid.faces().unwrap();
    assert_eq!(faces.class_counts(), [1, 3, 3, 1]);
    assert_eq!(shown(&faces.chain_complex().unwrap()), "Z, Z");
    assert_eq!(solid.manifold_verdict(&faces).unwrap().as_str(), "yes");
    let torus = solid.boundary_table().unwrap().0;
    assert_eq!(shown(&torus.faces().unwrap().chain_complex().unwrap()), "Z, Z^2, Z");
    let report = Report::of(Model::from_structure(Structure::Gluings(solid))).unwrap();
    assert_eq!(report.skin().unwrap().name(), Some("torus"));
    assert_eq!(report.is_closed(), Some(false));
}

/// The complement of the figure-eight knot: its one vertex is ideal.
#[test]
fn the_figure_eight_knot() {
    let table = GluingTable::from_isomorphism_signature("cPcbbbiht", 3).unwrap();
    let faces = table.faces().unwrap();
    assert_eq!(faces.class_counts(), [1, 2, 4, 2]);
    let verdict = table.manifold_verdict(&faces).unwrap();
    let witness = verdict.witness().unwrap();
    assert_eq!((verdict.as_str(), witness.fault()), ("no", GluingFault::LinkNotASphere));
    assert!(witness.message().contains("link of vertex 0 is a torus"), "{witness}");
    assert_eq!(table.orientation().is_orientable(), Some(true));
    // The torus is coned off, which kills the meridian and with it the first homology.
    assert_eq!(shown(&faces.chain_complex().unwrap()), "Z, 0, Z, Z");
}

/// Truncated, ideal triangulations are manifolds whose boundary has the links of the ideal vertices, and half of whose Euler
/// characteristic is that of the manifold.
#[test]
fn ideal_vertices_are_cut_off() {
    // The first homology and the numbers of boundary components are those that Regina says: figure eight, its sister, the Gieseking
    // manifold (which is not orientable), and others of two and four tetrahedra.
    for (signature, first, is_orientable) in [
        ("cPcbbbiht", "Z", true),
        ("cPcbbbdxm", "Z + Z/5", true),
        ("cPcbbbadu", "Z", true),
        ("bkaaid", "Z", false),
        ("eLPkbcddddcwjb", "Z", true),
        ("eLPkbdcddhgggb", "Z^2", true),
    ] {
        let table = GluingTable::from_isomorphism_signature(signature, 3).unwrap();
        let faces = table.faces().unwrap();
        let ideal = table.ideal_vertices(&faces).unwrap();
        let bounded = table.truncated(&faces).unwrap();
        let new_faces = bounded.faces().unwrap();
        assert_eq!(bounded.manifold_verdict(&new_faces).unwrap().as_str(), "yes", "{signature}");
        assert_eq!(bounded.orientation().is_orientable(), Some(is_orientable), "{signature}");
        if ideal.is_empty() {
            assert_eq!(bounded, table);
            continue;
        }
        let boundary = bounded.boundary_table().unwrap().0;
        assert_eq!(boundary.components().count(), ideal.len(), "{signature}");
        assert_eq!(2 * new_faces.alternating_count(), boundary.faces().unwrap().alternating_count());
        let report = Report::of(Model::from_structure(Structure::Gluings(table))).unwrap();
        assert_eq!(report.homology()[1].to_string(), first, "{signature}");
        assert_eq!(report.f_vector(), new_faces.class_counts());
    }
}

/// An edge identified with its own reverse: homology is that of the quotient, where half of the edge is left.
#[test]
fn a_folded_edge() {
    let table = one_tetrahedron(&[(3, [1, 0, 3, 2])]);
    let faces = table.faces().unwrap();
    assert_eq!(faces.folded(1).count(), 1);
    let verdict = table.manifold_verdict(&faces).unwrap();
    assert_eq!(verdict.witness().unwrap().fault(), GluingFault::FoldedFace);
    let chains = faces.chain_complex().unwrap();
    assert_eq!(groups(&chains), groups(&triangulated(&faces).chain_complex().unwrap()));
    let producer = Producer::of(Model::from_structure(Structure::Gluings(table.clone()))).unwrap();
    assert_eq!(producer.two_skeleton().unwrap().f_vector()[..], chains.f_vector()[..3]);
    let report = Report::of(Model::from_structure(Structure::Gluings(table))).unwrap();
    assert_eq!(report.f_vector(), faces.class_counts());
    assert!(report.warnings().iter().any(|warning| warning.contains("barycentric subdivision")));
}

#[test]
fn suspensions_of_spheres_are_spheres_and_others_are_no_manifolds() {
    let four = suspension(&sphere());
    let faces = four.faces().unwrap();
    assert_eq!(shown(&faces.chain_complex().unwrap()), "Z, 0, 0, 0, Z");
    assert_eq!(four.manifold_verdict(&faces).unwrap().as_str(), "yes");
    // The projective space as the lens space L(2, 1).
    let projective = GluingTable::from_isomorphism_signature("cMcabbgqw", 3).unwrap();
    let four = suspension(&projective);
    let verdict = four.manifold_verdict(&four.faces().unwrap()).unwrap();
    assert_eq!(verdict.witness().unwrap().fault(), GluingFault::LinkHomology);
    let knot = suspension(&GluingTable::from_isomorphism_signature("cPcbbbiht", 3).unwrap());
    let verdict = knot.manifold_verdict(&knot.faces().unwrap()).unwrap();
    assert_eq!(verdict.witness().unwrap().fault(), GluingFault::LinkNotAManifold);
}

#[test]
fn signatures_of_special_tables() {
    let empty = GluingTable::unglued(3, 0).unwrap();
    assert_eq!(empty.isomorphism_signature().unwrap(), "a");
    assert_eq!(GluingTable::from_isomorphism_signature("a", 3).unwrap(), empty);
    // Parts stand in the order of their signatures.
    let two = GluingTable::from_isomorphism_signature("cPcbbbihtcMcabbgqw", 3).unwrap();
    assert_eq!(two.components().numbers().last(), Some(&1));
    assert_eq!(two.isomorphism_signature().unwrap(), "cMcabbgqwcPcbbbiht");
    // A closed chain of 70 triangles takes two characters a number: "-" and "c", then 70 = 6 + 64.
    let mut strip = GluingTable::unglued(2, 70).unwrap();
    (0..69).for_each(|i| strip.glue(i, 0, i + 1, &[2, 0, 1]).unwrap());
    strip.glue(69, 0, 0, &[2, 0, 1]).unwrap();
    let signature = strip.isomorphism_signature().unwrap();
    assert!(signature.starts_with("-cgb"), "{signature}");
    let back = GluingTable::from_isomorphism_signature(&signature, 2).unwrap();
    assert_eq!(back.isomorphism_signature().unwrap(), signature);
    assert_eq!(shown(&back.faces().unwrap().chain_complex().unwrap()), "Z, Z");
    assert_eq!(strip.isomorphism_signature().unwrap().len(), signature.len());
    let error = GluingTable::unglued(1, 1).unwrap().isomorphism_signature().unwrap_err();
    assert_eq!(error.kind(), ErrorKind::UnsupportedFormat);
}

#[test]
fn faults_are_named() {
    let fault =
        |rows: &[coface_complexes::gluing::GluingRow]| GluingTable::from_rows(rows).unwrap_err().to_string();
    let to = |neighbor, images: &[u32]| Some((neighbor, images.to_vec()));
    assert!(fault(&[vec![to(1, &[0, 1]), None]]).contains("glued to simplex 1, but there are 1"));
    assert!(
        fault(&[vec![to(0, &[0, 2]), None]]).contains("[0, 2] of facet 0 of simplex 0 is no permutation")
    );
    assert!(fault(&[vec![to(0, &[0]), None]]).contains("is no permutation"));
    assert!(fault(&[vec![to(0, &[0, 1]), None]]).contains("glued to itself by the identity"));
    assert!(fault(&[vec![to(0, &[0, 2, 1]), None, None]]).contains("by a map that folds it"));
    assert!(fault(&[vec![None, None], vec![None]]).contains("simplex 1 has 1 facets"));
    assert!(fault(&[vec![]]).contains("no facets"));
    assert!(fault(&[vec![None]]).contains("not 0"));
    assert!(fault(&[vec![None; 17]]).contains("not 16"));
    let crossed = [vec![to(1, &[1, 0, 2]), None, None], vec![None, to(0, &[1, 2, 0]), None]];
    assert!(fault(&crossed).contains("give both sides of each gluing"));
    let mut table = GluingTable::unglued(2, 1).unwrap();
    table.glue(0, 0, 0, &[1, 0, 2]).unwrap();
    assert!(table.glue(0, 0, 0, &[2, 1, 0]).unwrap_err().message().contains("glued already"));
    assert!(table.glue(0, 3, 0, &[2, 1, 0]).is_err() && table.glue(1, 0, 0, &[2, 1, 0]).is_err());
}

#[test]
fn high_dimensions_and_nothing_are_ordinary() {
    let simplex = GluingTable::unglued(10, 1).unwrap();
    assert_eq!(simplex.faces().unwrap().class_counts()[5], 462);
    assert_eq!(shown(&simplex.faces().unwrap().chain_complex().unwrap()), "Z");
    let error = GluingTable::unglued(15, 1).unwrap().faces().unwrap().barycentric_subdivision().unwrap_err();
    assert_eq!(error.kind(), ErrorKind::TooLarge);
    let empty = GluingTable::from_rows(&[]).unwrap();
    let faces = empty.faces().unwrap();
    assert_eq!(faces.chain_complex().unwrap(), ChainComplex::of_points(0));
    assert!(faces.barycentric_subdivision().unwrap().complex().f_vector().is_empty());
    assert!(triangulated(&faces).is_empty());
    assert_eq!(empty.manifold_verdict(&faces).unwrap().to_bool(), Some(true));
}
