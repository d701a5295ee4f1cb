//! Known spaces, built by rule, with the answers of the literature: f-vector where the rule fixes it, integral homology,
//! whether it is a manifold, whether it is orientable.

#[cfg(test)]
mod table {
    use coface_algebra::VertexId;
    use coface_algebra::{Integer, SparseMatrix, smith_form};
    use coface_complexes::known_spaces;
    use coface_complexes::known_spaces::{FlatManifold, Solid, glued_solid};
    use coface_complexes::simplicial::SimplicialComplex;
    use coface_topology::{AbelianGroup, Coefficients, HomologyBasis, homology, homology_with};
    use proptest::prelude::*;

    /// One space and what is known about it.
    struct KnownSpace {
        name: &'static str,
        complex: SimplicialComplex,
        /// Empty where the construction does not fix it.
        f_vector: &'static [usize],
        /// The groups from degree 0, as in `"Z, Z^2 + Z/2, 0"`.
        homology: &'static str,
        /// Yes, no, or not known to the program.
        manifold: Option<bool>,
        /// Yes, no, or a question without sense.
        orientable: Option<bool>,
    }

    const Y: Option<bool> = Some(true);
    const N: Option<bool> = Some(false);
    const NA: Option<bool> = None;

    fn facets(facets: &[&[u32]]) -> SimplicialComplex {
        SimplicialComplex::from_facets(facets).unwrap()
    }

    fn product(a: &SimplicialComplex, b: &SimplicialComplex) -> SimplicialComplex {
        a.product(b).unwrap().0
    }

    fn suspension(of: &SimplicialComplex) -> SimplicialComplex {
        of.suspension().unwrap().0
    }

    /// The connected sum at the first facet of one and the last of the other.
    fn sum(a: &SimplicialComplex, b: &SimplicialComplex) -> SimplicialComplex {
        let order =
            |facet: coface_complexes::simplicial::Simplex| facet.vertices().collect::<Vec<VertexId>>();
        let top = a.dimension().unwrap();
        let (first, last) = (a.simplices(top).next().unwrap(), b.simplices(top).last().unwrap());
        a.connected_sum(&order(first), b, &order(last)).unwrap().into_complex()
    }

    fn multiple(summand: &SimplicialComplex, count: usize) -> SimplicialComplex {
        (1..count).fold(summand.clone(), |whole, _| sum(&whole, summand))
    }

    fn wedge(a: &SimplicialComplex, b: &SimplicialComplex) -> SimplicialComplex {
        let v = VertexId::new(0);
        a.wedge(v, b, v).unwrap().into_complex()
    }

    fn table() -> Vec<KnownSpace> {
        let mut table = Vec::new();
        let mut add = |name, complex, f_vector, homology, manifold, orientable| {
            table.push(KnownSpace { name, complex, f_vector, homology, manifold, orientable });
        };
        let sphere = |n| known_spaces::simplex_boundary(n).unwrap();
        let circle = known_spaces::circle(3).unwrap();
        let torus = known_spaces::cyclic_torus(2).unwrap();
        let plane = known_spaces::projective_plane().unwrap();
        let klein = known_spaces::klein_grid(4, 3).unwrap();

        // Points, circles, balls, spheres.
        add("empty", SimplicialComplex::new(), &[], "", Y, NA);
        add("point", facets(&[&[0]]), &[1], "Z", Y, NA);
        add("sphere_0", sphere(0), &[2], "Z^2", Y, NA);
        add("points_3", facets(&[&[0], &[1], &[2]]), &[3], "Z^3", Y, NA);
        add("edge", facets(&[&[0, 1]]), &[2, 1], "Z, 0", Y, Y);
        add("circle_3", circle.clone(), &[3, 3], "Z, Z", Y, Y);
        add("circle_9", known_spaces::circle(9).unwrap(), &[9, 9], "Z, Z", Y, Y);
        add("star_3", facets(&[&[0, 1], &[0, 2], &[0, 3]]), &[4, 3], "Z, 0", N, NA);
        add("simplex_5", known_spaces::simplex(5).unwrap(), &[6, 15, 20, 15, 6, 1], "Z, 0, 0, 0, 0, 0", Y, Y);
        add("sphere_2_boundary_simplex", sphere(2), &[4, 6, 4], "Z, 0, Z", Y, Y);
        add("sphere_3_boundary_simplex", sphere(3), &[5, 10, 10, 5], "Z, 0, 0, Z", Y, Y);
        add("sphere_4_boundary_simplex", sphere(4), &[6, 15, 20, 15, 6], "Z, 0, 0, 0, Z", Y, Y);
        add("sphere_5_boundary_simplex", sphere(5), &[7, 21, 35, 35, 21, 7], "Z, 0, 0, 0, 0, Z", Y, Y);
        let cross = |n| known_spaces::cross_polytope_boundary(n).unwrap();
        add("octahedron", cross(2), &[6, 12, 8], "Z, 0, Z", Y, Y);
        add("cross_polytope_boundary_4", cross(3), &[8, 24, 32, 16], "Z, 0, 0, Z", Y, Y);
        add("cross_polytope_boundary_6", cross(5), &[12, 60, 160, 240, 192, 64], "Z, 0, 0, 0, 0, Z", Y, Y);
        add(
            "joined_circles",
            circle.join(&circle).unwrap().into_complex(),
            &[6, 15, 18, 9],
            "Z, 0, 0, Z",
            Y,
            Y,
        );

        add(
            "barnette_sphere",
            known_spaces::barnette_sphere().unwrap(),
            &[8, 27, 38, 19],
            "Z, 0, 0, Z",
            Y,
            Y,
        );
        add(
            "bruckner_sphere",
            known_spaces::bruckner_sphere().unwrap(),
            &[8, 28, 40, 20],
            "Z, 0, 0, Z",
            Y,
            Y,
        );
        add("rudin_ball", known_spaces::rudin_ball().unwrap(), &[14, 66, 94, 41], "Z, 0, 0, 0", Y, Y);
        add("ziegler_ball", known_spaces::ziegler_ball().unwrap(), &[10, 38, 50, 21], "Z, 0, 0, 0", Y, Y);

        // Surfaces.
        add(
            "disk_fig_gu",
            facets(&[&[1, 2, 6], &[2, 3, 4], &[4, 5, 6], &[2, 4, 6]]),
            &[6, 9, 4],
            "Z, 0, 0",
            Y,
            Y,
        );
        add("mobius_5", known_spaces::triangle_strip(5).unwrap(), &[5, 10, 5], "Z, Z, 0", Y, N);
        add("annulus_6", known_spaces::triangle_strip(6).unwrap(), &[6, 12, 6], "Z, Z, 0", Y, Y);
        add("mobius_31", known_spaces::triangle_strip(31).unwrap(), &[31, 62, 31], "Z, Z, 0", Y, N);
        add("torus_7", torus.clone(), &[7, 21, 14], "Z, Z^2, Z", Y, Y);
        add("torus_grid_4x5", known_spaces::torus_grid(&[4, 5]).unwrap(), &[20, 60, 40], "Z, Z^2, Z", Y, Y);
        add("rp2_6", plane.clone(), &[6, 15, 10], "Z, Z/2, 0", Y, N);
        let small_klein = known_spaces::small_klein_bottle().unwrap();
        add("klein_8", small_klein, &[8, 24, 16], "Z, Z + Z/2, 0", Y, N);
        add("klein_grid_5x5", known_spaces::klein_grid(5, 5).unwrap(), &[25, 75, 50], "Z, Z + Z/2, 0", Y, N);
        add("surface_orientable_g2", multiple(&torus, 2), &[11, 39, 26], "Z, Z^4, Z", Y, Y);
        add("surface_orientable_g3", multiple(&torus, 3), &[15, 57, 38], "Z, Z^6, Z", Y, Y);
        add("surface_orientable_g10", multiple(&torus, 10), &[43, 183, 122], "Z, Z^20, Z", Y, Y);
        add("surface_nonorientable_n3", multiple(&plane, 3), &[12, 39, 26], "Z, Z^2 + Z/2, 0", Y, N);
        add("surface_nonorientable_n4", multiple(&plane, 4), &[15, 51, 34], "Z, Z^3 + Z/2, 0", Y, N);
        add("torus_sum_plane", sum(&torus, &plane), &[10, 33, 22], "Z, Z^2 + Z/2, 0", Y, N);
        let two_tori = torus.disjoint_union(&torus).unwrap().into_complex();
        add("two_tori", two_tori, &[14, 42, 28], "Z^2, Z^4, Z^2", Y, Y);
        add(
            "octahedron_subdivided",
            cross(2).barycentric_subdivision().unwrap().0,
            &[26, 72, 48],
            "Z, 0, Z",
            Y,
            Y,
        );

        // Closed manifolds of dimension 3.
        add("torus3_15", known_spaces::cyclic_torus(3).unwrap(), &[15, 105, 180, 90], "Z, Z^3, Z^3, Z", Y, Y);
        let grid = known_spaces::torus_grid(&[3, 4, 3]).unwrap();
        add("torus_grid_3x4x3", grid, &[36, 252, 432, 216], "Z, Z^3, Z^3, Z", Y, Y);
        add("rp2_x_s1", product(&plane, &circle), &[18], "Z, Z + Z/2, Z/2, 0", Y, N);
        add("klein_x_s1", product(&klein, &circle), &[36], "Z, Z^2 + Z/2, Z + Z/2, 0", Y, N);
        add("genus2_x_s1", product(&multiple(&torus, 2), &circle), &[33], "Z, Z^5, Z^5, Z", Y, Y);
        let bundle = |n, vertices| known_spaces::sphere_bundle_over_circle(n, vertices).unwrap();
        add("s2_twisted_s1_9", bundle(3, 9), &[9, 36, 54, 27], "Z, Z, Z/2, 0", Y, N);
        add("s2_x_s1_10", bundle(3, 10), &[10, 40, 60, 30], "Z, Z, Z, Z", Y, Y);
        add("s2xs1_sum2", multiple(&bundle(3, 10), 2), &[16], "Z, Z^2, Z^2, Z", Y, Y);
        for (p, q, groups) in [
            (1, 0, "Z, 0, 0, Z"),
            (2, 1, "Z, Z/2, 0, Z"),
            (3, 1, "Z, Z/3, 0, Z"),
            (4, 1, "Z, Z/4, 0, Z"),
            (5, 1, "Z, Z/5, 0, Z"),
            (5, 2, "Z, Z/5, 0, Z"),
            (7, 2, "Z, Z/7, 0, Z"),
            (10, 3, "Z, Z/10, 0, Z"),
        ] {
            add("lens_space", known_spaces::lens_space(p, q).unwrap(), &[], groups, Y, Y);
        }
        let rp3 = known_spaces::real_projective_space(3).unwrap();
        add("rp3", rp3.clone(), &[15], "Z, Z/2, 0, Z", Y, Y);
        add("rp3_sum_rp3", multiple(&rp3, 2), &[26], "Z, Z/2 + Z/2, 0, Z", Y, Y);
        let solid = |solid, steps| glued_solid(solid, steps).unwrap();
        let poincare = solid(Solid::Dodecahedron, 2);
        add("poincare_sphere", poincare.clone(), &[], "Z, 0, 0, Z", Y, Y);
        add("poincare_sphere_mirrored", solid(Solid::Dodecahedron, 3), &[], "Z, 0, 0, Z", Y, Y);
        add("weber_seifert", solid(Solid::Dodecahedron, 1), &[], "Z, Z/5 + Z/5 + Z/5, 0, Z", Y, Y);
        add("rp3_of_dodecahedron", solid(Solid::Dodecahedron, 0), &[], "Z, Z/2, 0, Z", Y, Y);
        add("cube_space", solid(Solid::Cube, 1), &[], "Z, Z/2 + Z/2, 0, Z", Y, Y);
        add("torus_of_cube", solid(Solid::Cube, 2), &[], "Z, Z^3, Z^3, Z", Y, Y);
        add("truncated_cube_space", known_spaces::truncated_cube_space().unwrap(), &[], "Z, Z/2, 0, Z", Y, Y);
        for (n, groups) in
            [(2, "Z, Z/2 + Z/2, 0, Z"), (3, "Z, Z/4, 0, Z"), (4, "Z, Z/2 + Z/2, 0, Z"), (5, "Z, Z/4, 0, Z")]
        {
            add("prism_manifold", known_spaces::prism_manifold(n).unwrap(), &[], groups, Y, Y);
        }
        for (manifold, groups, orientable) in [
            (FlatManifold::G2, "Z, Z + Z/2 + Z/2, Z, Z", Y),
            (FlatManifold::G6, "Z, Z/4 + Z/4, 0, Z", Y),
            (FlatManifold::B2, "Z, Z^2, Z + Z/2, 0", N),
            (FlatManifold::B3, "Z, Z + Z/2 + Z/2, Z/2, 0", N),
            (FlatManifold::B4, "Z, Z + Z/4, Z/2, 0", N),
        ] {
            add("flat_manifold", known_spaces::flat_manifold(manifold).unwrap(), &[], groups, Y, orientable);
        }
        let bundle_of_tori = |a| known_spaces::torus_bundle(a).unwrap();
        add("nil_1", bundle_of_tori([[1, 1], [0, 1]]), &[27], "Z, Z^2, Z^2, Z", Y, Y);
        add("nil_2", bundle_of_tori([[1, 2], [0, 1]]), &[27], "Z, Z^2 + Z/2, Z^2, Z", Y, Y);
        add("solv_2_1_1_1", bundle_of_tori([[2, 1], [1, 1]]), &[], "Z, Z, Z, Z", Y, Y);
        add("solv_3_2_1_1", bundle_of_tori([[3, 2], [1, 1]]), &[], "Z, Z + Z/2, Z, Z", Y, Y);
        add("octahedron_space", solid(Solid::Octahedron, 1), &[], "Z, Z/3, 0, Z", Y, Y);

        // Closed manifolds of dimension 4 and 5.
        let cp2 = known_spaces::complex_projective_plane().unwrap();
        add("cp2_9", cp2.clone(), &[9, 36, 84, 90, 36], "Z, 0, Z, 0, Z", Y, Y);
        add("cp2_sum_cp2", multiple(&cp2, 2), &[13], "Z, 0, Z^2, 0, Z", Y, Y);
        add(
            "k3_16",
            known_spaces::k3_surface().unwrap(),
            &[16, 120, 560, 720, 288],
            "Z, 0, Z^22, 0, Z",
            Y,
            Y,
        );
        add("s3_x_s1_11", bundle(4, 11), &[11, 55, 110, 110, 44], "Z, Z, 0, Z, Z", Y, Y);
        // The reflection that exchanges two vertices of the boundary of a simplex.
        let reflection = |v: VertexId| if v.index() < 2 { VertexId::new(1 - v.index()) } else { v };
        let twisted = known_spaces::mapping_torus(&sphere(3), reflection).unwrap();
        add("s3_twisted_s1", twisted, &[15], "Z, Z, 0, Z/2, 0", Y, N);
        let bundle_of_planes = known_spaces::mapping_torus(&cp2, |v| v).unwrap();
        add("cp2_x_s1", bundle_of_planes, &[27], "Z, Z, Z, Z, Z, Z", Y, Y);
        add("s2xs2", product(&sphere(2), &sphere(2)), &[16], "Z, 0, Z^2, 0, Z", Y, Y);
        add("s3xs2", product(&sphere(3), &sphere(2)), &[20], "Z, 0, Z, Z, 0, Z", Y, Y);
        add("rp2xrp2", product(&plane, &plane), &[36], "Z, Z/2 + Z/2, Z/2, Z/2, 0", Y, N);
        add(
            "torus4_31",
            known_spaces::cyclic_torus(4).unwrap(),
            &[31, 465, 1550, 1860, 744],
            "Z, Z^4, Z^6, Z^4, Z",
            Y,
            Y,
        );
        add("rp4", known_spaces::real_projective_space(4).unwrap(), &[31], "Z, Z/2, 0, Z/2, 0", Y, N);

        // Not manifolds.
        add("two_triangles_vertex", facets(&[&[0, 1, 2], &[2, 3, 4]]), &[5, 6, 2], "Z, 0, 0", N, Y);
        add("nonpure_mix", facets(&[&[0, 1, 2], &[3, 4]]), &[5, 4, 1], "Z^2, 0, 0", N, NA);
        let figure = facets(&[&[0, 1, 2, 3], &[2, 3, 4], &[3, 5], &[4, 5]]);
        add("seed001_fig1_like", figure, &[6, 10, 5, 1], "Z, Z, 0, 0", N, NA);
        add("book_3", known_spaces::book(3).unwrap(), &[5, 7, 3], "Z, 0, 0", N, NA);
        let house = known_spaces::house_with_two_rooms().unwrap();
        add("bing_house", house, &[], "Z, 0, 0", N, NA);
        add("dunce_hat_8", known_spaces::dunce_hat().unwrap(), &[8, 24, 17], "Z, 0, 0", N, NA);
        for (order, groups) in [(3, "Z, Z/3, 0"), (4, "Z, Z/4, 0"), (5, "Z, Z/5, 0"), (12, "Z, Z/12, 0")] {
            add("moore_space", known_spaces::moore_space(order).unwrap(), &[], groups, N, NA);
        }
        add("moore_space_2", known_spaces::moore_space(2).unwrap(), &[6, 15, 10], "Z, Z/2, 0", Y, N);
        let trefoil = known_spaces::presentation_complex(2, &[vec![1, 2, 1, -2, -1, -2]]).unwrap();
        add("trefoil_presentation", trefoil, &[], "Z, Z, 0", N, NA);
        let binary = known_spaces::presentation_complex(
            2,
            &[vec![1, 1, 1, -2, -2, -2, -2, -2], vec![2, 2, 2, 2, 2, -1, -2, -1, -2]],
        );
        add("binary_icosahedral_presentation", binary.unwrap(), &[], "Z, 0, 0", N, NA);
        let pinched = known_spaces::pinched_torus_grid(6, 6).unwrap();
        add("pinched_torus_grid", pinched, &[35, 108, 72], "Z, Z^3, Z", N, Y);
        add("wedge_two_spheres", wedge(&sphere(2), &sphere(2)), &[7, 12, 8], "Z, 0, Z^2", N, Y);
        add("wedge_of_circles", wedge(&circle, &circle), &[5, 6], "Z, Z^2", N, NA);
        add("suspension_rp2", suspension(&plane), &[8, 27, 40, 20], "Z, 0, Z/2, 0", N, N);
        add("suspension_torus_9", suspension(&torus), &[9, 35, 56, 28], "Z, 0, Z^2, Z", N, Y);
        add("cone_torus", torus.cone().unwrap().0, &[8, 28, 35, 14], "Z, 0, 0, 0", N, Y);
        add("suspension_rp3", suspension(&rp3), &[17], "Z, 0, Z/2, 0, Z", N, Y);
        add("double_suspension_torus", suspension(&suspension(&torus)), &[11], "Z, 0, 0, Z^2, Z", N, Y);
        add("double_suspension_poincare", suspension(&suspension(&poincare)), &[], "Z, 0, 0, 0, 0, Z", NA, Y);
        add("chessboard_2_3", known_spaces::chessboard(2, 3).unwrap(), &[6, 6], "Z, Z", Y, Y);
        add("chessboard_3_3", known_spaces::chessboard(3, 3).unwrap(), &[9, 18, 6], "Z, Z^4, 0", N, Y);
        add("chessboard_3_4", known_spaces::chessboard(3, 4).unwrap(), &[12, 36, 24], "Z, Z^2, Z", Y, Y);
        add("chessboard_4_3", known_spaces::chessboard(4, 3).unwrap(), &[12, 36, 24], "Z, Z^2, Z", Y, Y);
        add("chessboard_3_5", known_spaces::chessboard(3, 5).unwrap(), &[15, 60, 60], "Z, 0, Z^14", N, NA);
        add(
            "chessboard_4_4",
            known_spaces::chessboard(4, 4).unwrap(),
            &[16, 72, 96, 24],
            "Z, 0, Z^15, 0",
            N,
            Y,
        );
        add(
            "chessboard_4_5",
            known_spaces::chessboard(4, 5).unwrap(),
            &[20, 120, 240, 120],
            "Z, 0, Z^20, Z",
            N,
            Y,
        );
        add(
            "chessboard_5_5",
            known_spaces::chessboard(5, 5).unwrap(),
            &[25, 200, 600, 600, 120],
            "Z, 0, Z/3, Z^56, 0",
            N,
            Y,
        );
        add("matching_5", known_spaces::matching_complex(5).unwrap(), &[10, 15], "Z, Z^6", N, NA);
        add("matching_6", known_spaces::matching_complex(6).unwrap(), &[15, 45, 15], "Z, Z^16, 0", N, Y);
        add("matching_7", known_spaces::matching_complex(7).unwrap(), &[21, 105, 105], "Z, Z/3, Z^20", N, NA);
        let sum_complex = |modulus, sums: &[u32]| known_spaces::sum_complex(modulus, sums).unwrap();
        add("sum_complex_11_0_1_3", sum_complex(11, &[0, 1, 3]), &[11, 55, 45], "Z, Z/23, 0", N, NA);
        add("sum_complex_13_0_1_3", sum_complex(13, &[0, 1, 3]), &[13, 78, 66], "Z, Z/159, 0", N, NA);
        add("sum_complex_13_0_1_5", sum_complex(13, &[0, 1, 5]), &[13, 78, 66], "Z, Z/159, 0", N, NA);
        add("sum_complex_17_0_1_6", sum_complex(17, &[0, 1, 6]), &[17, 136, 120], "Z, Z/24617, 0", N, NA);

        // Homology spheres as links: a verdict needs the fundamental group.
        add("suspension_poincare", suspension(&poincare), &[], "Z, 0, 0, 0, Z", NA, Y);
        add("cone_poincare", poincare.cone().unwrap().0, &[], "Z, 0, 0, 0, 0", NA, Y);
        table
    }

    /// `"Z^2 + Z/2 + Z/4"` as a Betti number and torsion coefficients.
    fn group(text: &str) -> (usize, Vec<Integer>) {
        let (mut betti, mut torsion) = (0, Vec::new());
        for part in text.split(" + ").filter(|&part| part != "0") {
            match (part.strip_prefix("Z/"), part.strip_prefix("Z^")) {
                (Some(order), _) => torsion.push(order.parse().unwrap()),
                (_, Some(power)) => betti += power.parse::<usize>().unwrap(),
                _ => betti += 1,
            }
        }
        (betti, torsion)
    }

    /// The ranks over Q, F_2 and F_3 that follow from the integral groups: torsion of an order that the prime divides counts
    /// in its own degree and in the one above.
    fn ranks(groups: &[(usize, Vec<Integer>)], prime: Option<i64>) -> Vec<usize> {
        let divided = |k: usize| {
            let torsion = groups.get(k).map_or(&[][..], |group| &group.1);
            torsion.iter().filter(|order| prime.is_some_and(|p| Integer::from(p).divides(order))).count()
        };
        (0..groups.len()).map(|k| groups[k].0 + divided(k) + k.checked_sub(1).map_or(0, divided)).collect()
    }

    /// The whole table over Z with generators, and over three fields.
    #[test]
    fn generators_and_fields_agree_with_the_literature() {
        for space in table() {
            let chains = space.complex.chain_complex().unwrap();
            let expected: Vec<_> = space.homology.split(", ").filter(|g| !g.is_empty()).map(group).collect();
            let basis = HomologyBasis::unshortened(&chains);
            for (degree, (betti, torsion)) in expected.iter().enumerate() {
                let generators = basis.generators(degree);
                let orders: Vec<Integer> = generators.iter().filter_map(|g| g.order().cloned()).collect();
                assert_eq!((generators.len() - orders.len(), &orders), (*betti, torsion), "{}", space.name);
                for generator in generators {
                    assert!(chains.is_cycle(generator.chain()).unwrap(), "{}", space.name);
                }
                // Free cocycles are dual to free generators.
                let free: Vec<_> = generators.iter().filter(|g| g.order().is_none()).collect();
                let cocycles = basis.cocycles(degree);
                for (i, cocycle) in cocycles.iter().filter(|c| c.order().is_none()).enumerate() {
                    for (j, generator) in free.iter().enumerate() {
                        let value = cocycle.cochain().pairing(generator.chain()).unwrap();
                        assert_eq!(value, (i == j).then_some(Integer::ONE), "{}", space.name);
                    }
                }
            }
            for prime in [None, Some(2), Some(3)] {
                let coefficients = prime.map_or(Coefficients::Rationals, |p| Coefficients::Modulo(p as u64));
                let found = homology_with(&chains, coefficients).betti_numbers();
                assert_eq!(found, ranks(&expected, prime), "{} over {coefficients}", space.name);
            }
        }
    }

    /// Spaces on which programs err that count classes over F_2 as ranks, or lose incidences when cells are combined: ranks
    /// over Q, F_2 and F_3 beside the integral groups.
    #[test]
    fn ranks_over_two_elements_are_not_those_over_the_integers() {
        let plane = known_spaces::projective_plane().unwrap();
        let circle = known_spaces::circle(3).unwrap();
        let moore = |order| known_spaces::moore_space(order).unwrap();
        let lens = |p, q| known_spaces::lens_space(p, q).unwrap();
        type Ranks<'a> = &'a [usize];
        let cases: [(&str, SimplicialComplex, &str, [Ranks<'_>; 3]); 10] = [
            ("rp2_6", plane.clone(), "Z, Z/2, 0", [&[1, 0, 0], &[1, 1, 1], &[1, 0, 0]]),
            (
                "klein_8",
                known_spaces::small_klein_bottle().unwrap(),
                "Z, Z + Z/2, 0",
                [&[1, 1, 0], &[1, 2, 1], &[1, 1, 0]],
            ),
            (
                "klein_grid_5x5",
                known_spaces::klein_grid(5, 5).unwrap(),
                "Z, Z + Z/2, 0",
                [&[1, 1, 0], &[1, 2, 1], &[1, 1, 0]],
            ),
            (
                "rp3",
                known_spaces::real_projective_space(3).unwrap(),
                "Z, Z/2, 0, Z",
                [&[1, 0, 0, 1], &[1, 1, 1, 1], &[1, 0, 0, 1]],
            ),
            ("l_2_1", lens(2, 1), "Z, Z/2, 0, Z", [&[1, 0, 0, 1], &[1, 1, 1, 1], &[1, 0, 0, 1]]),
            ("l_4_1", lens(4, 1), "Z, Z/4, 0, Z", [&[1, 0, 0, 1], &[1, 1, 1, 1], &[1, 0, 0, 1]]),
            (
                "dunce_hat",
                known_spaces::dunce_hat().unwrap(),
                "Z, 0, 0",
                [&[1, 0, 0], &[1, 0, 0], &[1, 0, 0]],
            ),
            ("moore_z3", moore(3), "Z, Z/3, 0", [&[1, 0, 0], &[1, 0, 0], &[1, 1, 1]]),
            ("moore_z4", moore(4), "Z, Z/4, 0", [&[1, 0, 0], &[1, 1, 1], &[1, 0, 0]]),
            (
                "rp2_x_s1",
                product(&plane, &circle),
                "Z, Z + Z/2, Z/2, 0",
                [&[1, 1, 0, 0], &[1, 2, 2, 1], &[1, 1, 0, 0]],
            ),
        ];
        for (name, complex, groups, ranks) in cases {
            let chains = complex.chain_complex().unwrap();
            let found = homology(&chains);
            let found: Vec<_> = found.groups().iter().map(|g| (g.betti(), g.torsion().to_vec())).collect();
            assert_eq!(found, groups.split(", ").map(group).collect::<Vec<_>>(), "{name}");
            let fields = [Coefficients::Rationals, Coefficients::Modulo(2), Coefficients::Modulo(3)];
            for (field, ranks) in fields.into_iter().zip(ranks) {
                assert_eq!(homology_with(&chains, field).betti_numbers(), ranks, "{name} over {field}");
                let basis = HomologyBasis::new(&chains);
                let counts: Vec<usize> =
                    (0..ranks.len()).map(|k| basis.generators_with(k, field).len()).collect();
                assert_eq!(counts, ranks, "{name} over {field}");
            }
        }
    }

    /// 16,383 simplices; its links are not tried.
    #[test]
    fn the_quaternionic_plane_has_a_class_in_every_fourth_degree() {
        let plane = known_spaces::quaternionic_projective_plane().unwrap();
        let groups = homology(&plane.chain_complex().unwrap());
        assert_eq!(groups.betti_numbers(), [1, 0, 0, 0, 1, 0, 0, 0, 1]);
        assert!(groups.torsion().iter().all(|orders| orders.is_empty()));
        assert_eq!(plane.orientability().unwrap().is_orientable(), Y);
    }

    /// Contractible, but nothing can be collapsed: every edge lies in two triangles or more.
    #[test]
    fn the_dunce_hat_and_the_house_have_no_free_edge() {
        for space in [known_spaces::dunce_hat(), known_spaces::house_with_two_rooms()] {
            let chains = space.unwrap().chain_complex().unwrap();
            let cofaces = chains.coboundary_matrix(1).unwrap();
            assert!(cofaces.columns().all(|triangles| triangles.rows().len() >= 2));
        }
    }

    #[test]
    fn the_construction_gives_the_f_vector() {
        for space in table() {
            let f_vector = space.complex.f_vector();
            // A shorter list states the first numbers only.
            assert_eq!(f_vector[..space.f_vector.len()], *space.f_vector, "{}", space.name);
        }
    }

    #[test]
    fn manifolds_are_recognized() {
        for space in table() {
            let verdict = space.complex.manifold_verdict().unwrap();
            assert_eq!(verdict.to_bool(), space.manifold, "{}: {verdict:?}", space.name);
            if let Some(true) = space.manifold {
                // The boundary of a manifold is a closed manifold one dimension lower.
                let boundary = space.complex.boundary_complex(&space.complex).unwrap();
                let of_boundary = boundary.manifold_verdict().unwrap();
                assert_eq!(of_boundary.to_bool(), Y, "{}: {of_boundary:?}", space.name);
                assert!(boundary.boundary_complex(&boundary).unwrap().is_empty(), "{}", space.name);
            }
        }
    }

    #[test]
    fn homology_is_that_of_the_literature() {
        for space in table() {
            let found = homology(&space.complex.chain_complex().unwrap());
            let found: Vec<_> = found.groups().iter().map(|g| (g.betti(), g.torsion().to_vec())).collect();
            let expected: Vec<_> = space.homology.split(", ").filter(|g| !g.is_empty()).map(group).collect();
            assert_eq!(found, expected, "{}", space.name);
        }
    }

    #[test]
    fn orientability_is_decided() {
        for space in table() {
            let found = space.complex.orientability().unwrap();
            assert_eq!(found.is_orientable(), space.orientable, "{}", space.name);
            // A closed strongly connected pseudomanifold is orientable when its top homology is Z.
            let groups: Vec<_> = space.homology.split(", ").map(group).collect();
            let Some(true) = space.manifold else { continue };
            if !space.complex.boundary_complex(&space.complex).unwrap().is_empty()
                || space.complex.dimension() < Some(1)
            {
                continue;
            }
            if found.is_orientable() == Some(true) {
                assert_eq!(
                    groups.last().unwrap().0,
                    space.complex.strong_components().len(),
                    "{}",
                    space.name
                );
            } else {
                assert_eq!(groups.last().unwrap().0, 0, "{}", space.name);
            }
        }
    }

    /// Products of shears, the exchange and the half turn.
    fn monodromies() -> impl Strategy<Value = [[i64; 2]; 2]> {
        prop::collection::vec(0usize..5, 0..6).prop_map(|word| {
            let letters =
                [[[1, 1], [0, 1]], [[1, 0], [1, 1]], [[1, -1], [0, 1]], [[0, 1], [1, 0]], [[-1, 0], [0, -1]]];
            word.into_iter().fold([[1, 0], [0, 1]], |product: [[i64; 2]; 2], letter| {
                let factor: [[i64; 2]; 2] = letters[letter];
                let entry = |[x, y]: [i64; 2], j: usize| x * factor[0][j] + y * factor[1][j];
                product.map(|row| [entry(row, 0), entry(row, 1)])
            })
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        /// Torus bundles are manifolds with the homology of their monodromy: Z and the cokernel of A - 1.
        #[test]
        fn torus_bundles_have_the_homology_of_their_monodromy(monodromy in monodromies()) {
            let bundle = known_spaces::torus_bundle(monodromy).unwrap();
            prop_assert_eq!(bundle.manifold_verdict().unwrap().to_bool(), Some(true));
            let [[a, b], [c, d]] = monodromy;
            prop_assert_eq!(bundle.orientability().unwrap().is_orientable(), Some(a * d - b * c == 1));
            let entries = [(0, 0, a - 1), (0, 1, b), (1, 0, c), (1, 1, d - 1)];
            let smith = smith_form(&SparseMatrix::from_entries(2, 2, entries).unwrap());
            let expected = AbelianGroup::new(1 + smith.nullity(), smith.torsion().to_vec());
            let groups = homology(&bundle.chain_complex().unwrap());
            prop_assert_eq!(&groups.groups()[1], &expected);
        }
    }

    #[test]
    fn the_ten_flat_manifolds_have_the_groups_of_the_literature() {
        let first_homology = [
            "Z^3",
            "Z + (Z/2)^2",
            "Z + Z/3",
            "Z + Z/2",
            "Z",
            "(Z/4)^2",
            "Z^2 + Z/2",
            "Z^2",
            "Z + (Z/2)^2",
            "Z + Z/4",
        ];
        for (i, manifold) in FlatManifold::ALL.into_iter().enumerate() {
            let space = known_spaces::flat_manifold(manifold).unwrap();
            assert_eq!(space.manifold_verdict().unwrap().to_bool(), Y, "{manifold:?}");
            assert_eq!(space.orientability().unwrap().is_orientable(), Some(i < 6), "{manifold:?}");
            let groups = homology(&space.chain_complex().unwrap());
            assert_eq!(groups.groups()[1].to_string(), first_homology[i], "{manifold:?}");
        }
    }

    /// Complexes of a library, with its facts: facet lists of manifolds and pseudomanifolds.
    #[test]
    fn facet_lists_of_others_agree() {
        let Some(folder) = std::env::var_os("COFACE_DATA") else {
            println!("skipped: COFACE_DATA names no folder");
            return;
        };
        let path = std::path::Path::new(&folder).join("complexes/facet_lists.json");
        let records: serde_json::Value =
            serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        for record in records.as_array().unwrap() {
            let name = record["name"].as_str().unwrap();
            let facets: Vec<Vec<u32>> = serde_json::from_value(record["facets"].clone()).unwrap();
            let complex = SimplicialComplex::from_facets(&facets).unwrap();
            let f_vector: Vec<usize> = serde_json::from_value(record["f_vector"].clone()).unwrap();
            assert_eq!(complex.f_vector(), f_vector, "{name}");
            assert_eq!(complex.purity().is_pure(), record["pure"].as_bool().unwrap(), "{name}");
            let found = complex.orientability().unwrap().is_orientable();
            assert_eq!(found, record["orientable"].as_bool(), "{name}");
            // The pseudomanifolds of the list are no manifolds, all others are.
            let is_manifold = !name.starts_with("PM");
            let verdict = complex.manifold_verdict().unwrap();
            assert_eq!(verdict.to_bool(), Some(is_manifold), "{name}: {verdict:?}");
            let boundary = complex.boundary_complex(&complex).unwrap();
            assert_eq!(boundary.is_empty(), record["closed"].as_bool().unwrap(), "{name}");
        }
    }
}
