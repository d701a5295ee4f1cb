//! Products of cohomology classes and intersection forms of known manifolds, with the answers of the literature.

#[cfg(test)]
mod facts {
    use coface_algebra::ErrorKind;
    use coface_algebra::{Definiteness, Integer, Parity, Sign, SymmetricForm};
    use coface_complexes::known_spaces;
    use coface_complexes::known_spaces::Solid;
    use coface_complexes::simplicial::{DeltaComplex, SimplicialComplex};
    use coface_topology::{
        CochainAlgebra, Cocycle, Coefficients, HomologyBasis, IntersectionForm, cup_product_table,
        intersection_form,
    };

    fn algebra(complex: &SimplicialComplex) -> CochainAlgebra {
        CochainAlgebra::new(complex.freeze().to_delta().unwrap()).unwrap()
    }

    fn form(complex: &SimplicialComplex) -> IntersectionForm {
        intersection_form(&algebra(complex)).unwrap()
    }

    fn symmetric(complex: &SimplicialComplex) -> SymmetricForm {
        let form = form(complex).as_symmetric().unwrap().clone();
        assert!(form.is_unimodular(), "{form:?}");
        form
    }

    fn product(a: &SimplicialComplex, b: &SimplicialComplex) -> SimplicialComplex {
        a.product(b).unwrap().0
    }

    #[test]
    fn the_square_of_a_generator_of_a_projective_plane_generates() {
        let complex = known_spaces::complex_projective_plane().unwrap();
        assert_eq!(symmetric(&complex).rows().len(), 1);
        assert_eq!(
            symmetric(&complex).name().map(|name| name.trim_matches(['(', ')', '-']).to_owned()),
            Some("1".into())
        );
        // The same for quaternions, in dimension 8.
        let quaternionic = known_spaces::quaternionic_projective_plane().unwrap();
        let form = symmetric(&quaternionic);
        assert_eq!((form.size(), form.rank(), form.signature().abs()), (1, 1, 1));
    }

    #[test]
    fn sums_of_projective_planes_tell_orientations_apart() {
        let plane = known_spaces::complex_projective_plane().unwrap();
        let sum = |sign| symmetric(&known_spaces::oriented_sum(&plane, &plane, sign).unwrap());
        let (same, opposite) = (sum(Sign::Plus), sum(Sign::Minus));
        assert_eq!((same.rank(), same.signature().abs(), same.determinant()), (2, 2, 1.into()));
        assert_eq!((opposite.rank(), opposite.signature(), opposite.determinant()), (2, 0, (-1).into()));
        assert_eq!((same.parity(), opposite.parity()), (Parity::Odd, Parity::Odd));
        assert!(matches!(same.definiteness(), Definiteness::Positive | Definiteness::Negative));
        assert_eq!(opposite.name().as_deref(), Some("(1) + (-1)"));
    }

    #[test]
    fn products_of_spheres_are_hyperbolic() {
        let sphere = |n| known_spaces::simplex_boundary(n).unwrap();
        let form = symmetric(&product(&sphere(2), &sphere(2)));
        assert_eq!((form.name().as_deref(), form.determinant()), (Some("H"), (-1).into()));
        assert_eq!(symmetric(&sphere(4)).size(), 0);
        assert_eq!(symmetric(&product(&sphere(1), &sphere(3))).size(), 0);
        assert_eq!(symmetric(&known_spaces::sphere_bundle_over_circle(4, 11).unwrap()).size(), 0);
        // Two points, each a component of its own.
        assert_eq!(symmetric(&sphere(0)), SymmetricForm::diagonal([1, 1]));
    }

    #[test]
    fn the_k3_surface_is_even_of_signature_16() {
        let form = symmetric(&known_spaces::k3_surface().unwrap());
        assert_eq!((form.rank(), form.signature().abs(), form.determinant()), (22, 16, (-1).into()));
        assert_eq!(form.parity(), Parity::Even);
        let name = form.name().unwrap();
        assert!(name == "2(-E8) + 3H" || name == "2E8 + 3H", "{name}");
    }

    #[test]
    fn the_torus_of_dimension_4_has_three_hyperbolic_planes() {
        let form = symmetric(&known_spaces::cyclic_torus(4).unwrap());
        assert_eq!((form.rank(), form.name().as_deref()), (6, Some("3H")));
    }

    #[test]
    fn products_of_surfaces_have_the_products_of_their_forms() {
        let torus = known_spaces::cyclic_torus(2).unwrap();
        let double = known_spaces::oriented_sum(&torus, &torus, Sign::Plus).unwrap();
        // H^2 is H^2 + H^1 (x) H^1 + H^0 H^2: 1 + 8 + 1.
        let form = symmetric(&product(&torus, &double));
        assert_eq!((form.rank(), form.name().as_deref()), (10, Some("5H")));
    }

    #[test]
    fn surfaces_have_skew_unimodular_forms() {
        let torus = known_spaces::cyclic_torus(2).unwrap();
        let mut surface = torus.clone();
        for genus in 1..=4 {
            let form = form(&surface);
            let skew = form.as_skew().unwrap();
            assert_eq!((skew.size(), skew.is_unimodular(), form.determinant()), (2 * genus, true, 1.into()));
            surface = known_spaces::oriented_sum(&surface, &torus, Sign::Plus).unwrap();
        }
        // Two triangles on one vertex.
        let delta = DeltaComplex::new(1, vec![vec![0; 6], vec![1, 2, 0, 0, 2, 1]]).unwrap();
        let form = intersection_form(&CochainAlgebra::new(delta).unwrap()).unwrap();
        assert!(form.as_skew().unwrap().is_unimodular() && form.rank() == 2);
        // Dimension 6: the product of three spheres has no middle cohomology, that of two 3-spheres has a plane.
        let sphere = known_spaces::simplex_boundary(3).unwrap();
        let form = self::form(&product(&sphere, &sphere));
        assert!(form.as_skew().unwrap().is_unimodular() && form.rank() == 2);
    }

    #[test]
    fn the_opposite_orientation_has_the_opposite_form() {
        let plane = known_spaces::complex_projective_plane().unwrap();
        // Exchanging two vertices of the lowest facet makes it negative in the old orientation.
        let exchange = |v: u32| if v < 2 { 1 - v } else { v };
        let facets = plane.facets();
        assert!(facets[0].numbers().starts_with(&[0, 1]));
        let mirrored =
            facets.iter().map(|facet| facet.numbers().iter().map(|&v| exchange(v)).collect::<Vec<u32>>());
        let mirrored = SimplicialComplex::from_facets(mirrored).unwrap();
        assert!(mirrored.contains(&facets[0]));
        assert_eq!(symmetric(&mirrored).signature(), -symmetric(&plane).signature());
    }

    #[test]
    fn the_triple_product_on_the_torus_is_the_volume() {
        for torus in [known_spaces::cyclic_torus(3).unwrap(), known_spaces::torus_grid(&[3, 4, 3]).unwrap()] {
            let x = algebra(&torus);
            let forms = HomologyBasis::new(x.chains()).cocycles(1);
            assert_eq!(forms.len(), 3);
            let [a, b, c] = [0, 1, 2].map(|i| forms[i].cochain());
            let cycle = x.fundamental_cycle().unwrap();
            let volume = x.cup(&x.cup(a, b).unwrap(), c).unwrap().pairing(&cycle).unwrap().unwrap();
            assert!(volume.is_unit(), "{volume}");
            // Exchanging two factors changes the sign, and no square has a volume.
            let other = x.cup(&x.cup(b, a).unwrap(), c).unwrap().pairing(&cycle).unwrap().unwrap();
            assert_eq!(other, -&volume);
            assert_eq!(x.cup(&x.cup(a, a).unwrap(), c).unwrap().pairing(&cycle).unwrap(), None);
        }
    }

    /// The products of degree 1 over F_p on the classes of degree 2, as a matrix for each of these.
    fn products_of_loops(complex: &SimplicialComplex, prime: u64) -> Vec<Vec<Vec<i64>>> {
        let table = cup_product_table(&algebra(complex), 1, 1, Coefficients::Modulo(prime)).unwrap();
        let matrix = |k: usize| {
            let row = |row: &Vec<Vec<Integer>>| row.iter().map(|value| value[k].to_i64().unwrap()).collect();
            table.values().iter().map(row).collect()
        };
        (0..table.target().len()).map(matrix).collect()
    }

    #[test]
    fn products_over_two_elements_tell_the_klein_bottle_from_the_torus() {
        // The squares vanish on an orientable surface and not on the others; the form has full rank on all.
        let torus = products_of_loops(&known_spaces::cyclic_torus(2).unwrap(), 2);
        assert_eq!(torus, [[[0, 1], [1, 0]]]);
        for bottle in [known_spaces::small_klein_bottle().unwrap(), known_spaces::klein_grid(5, 5).unwrap()] {
            let [form] = &products_of_loops(&bottle, 2)[..] else { panic!("one class of degree 2") };
            assert!(form[0][0] == 1 || form[1][1] == 1, "{form:?}");
            assert_eq!(form[0][1], form[1][0]);
            assert_eq!((form[0][0] * form[1][1] - form[0][1] * form[1][0]).rem_euclid(2), 1);
        }
        assert_eq!(products_of_loops(&known_spaces::projective_plane().unwrap(), 2), [[[1]]]);
        // The wedge with the same groups as the torus has no products.
        let (circle, sphere) = (known_spaces::circle(3).unwrap(), known_spaces::simplex_boundary(2).unwrap());
        let v = coface_algebra::VertexId::new(0);
        let wedge = circle.wedge(v, &circle, v).unwrap().into_complex();
        let wedge = wedge.wedge(v, &sphere, v).unwrap().into_complex();
        assert_eq!(products_of_loops(&wedge, 2), [[[0, 0], [0, 0]]]);
        assert_eq!(products_of_loops(&wedge, 3), [[[0, 0], [0, 0]]]);
    }

    /// On the projective space of dimension n over F_2 the n-th power of the class of degree 1 is not zero; on a lens space
    /// of odd order over F_p its square is.
    #[test]
    fn powers_of_the_class_of_a_projective_space() {
        for n in 1..=4 {
            let x = algebra(&known_spaces::real_projective_space(n).unwrap());
            for p in 0..=n {
                let table = cup_product_table(&x, p, n - p, Coefficients::Modulo(2)).unwrap();
                assert_eq!(table.values(), [[[Integer::ONE]]], "{n} {p}");
            }
        }
        let lens = algebra(&known_spaces::lens_space(3, 1).unwrap());
        let product = |p, q| cup_product_table(&lens, p, q, Coefficients::Modulo(3)).unwrap();
        assert!(product(1, 1).is_zero() && !product(1, 2).is_zero() && !product(2, 1).is_zero());
    }

    /// Over Z the class of degree 2 of a lens space has no square (degree 4), but that of RP^4 has one: the generator of Z/2.
    #[test]
    fn torsion_classes_multiply() {
        let x = algebra(&known_spaces::real_projective_space(4).unwrap());
        let table = cup_product_table(&x, 2, 2, Coefficients::Integers).unwrap();
        assert_eq!(table.first()[0].order(), Some(&Integer::from(2)));
        assert_eq!(table.target()[0].order(), Some(&Integer::from(2)));
        assert_eq!(table.values(), [[[Integer::ONE]]]);
    }

    /// Products of cocycles do not depend, on cycles, on their order but for the sign, nor on coboundaries.
    #[test]
    fn products_of_classes_commute_up_to_sign() {
        let spaces = [
            known_spaces::cyclic_torus(3).unwrap(),
            known_spaces::torus_bundle([[1, 1], [0, 1]]).unwrap(),
            product(&known_spaces::cyclic_torus(2).unwrap(), &known_spaces::simplex_boundary(2).unwrap()),
            known_spaces::mapping_torus(&known_spaces::complex_projective_plane().unwrap(), |v| v).unwrap(),
        ];
        for space in spaces {
            let x = algebra(&space);
            for (p, q) in [(1, 1), (1, 2), (2, 2), (1, 4)] {
                let [one, other] = [(p, q), (q, p)]
                    .map(|(p, q)| cup_product_table(&x, p, q, Coefficients::Integers).unwrap());
                for (i, row) in one.values().iter().enumerate() {
                    for (j, values) in row.iter().enumerate() {
                        let sign = |(v, cocycle): (&Integer, &Cocycle)| {
                            let signed = if p * q % 2 == 0 { v.clone() } else { -v };
                            cocycle.order().map_or(signed.clone(), |order| signed.div_rem_floor(order).1)
                        };
                        let expected: Vec<Integer> =
                            other.values()[j][i].iter().zip(one.target()).map(sign).collect();
                        assert_eq!(*values, expected);
                    }
                }
            }
        }
    }

    /// Over Z the Heisenberg manifold and the 3-torus differ in products of degree 1: one of them is zero on the first.
    #[test]
    fn products_tell_the_heisenberg_manifold() {
        let x = algebra(&known_spaces::torus_bundle([[1, 1], [0, 1]]).unwrap());
        assert!(cup_product_table(&x, 1, 1, Coefficients::Integers).unwrap().is_zero());
        assert!(!cup_product_table(&x, 1, 2, Coefficients::Rationals).unwrap().is_zero());
    }

    #[test]
    fn what_has_no_form_is_refused_with_a_witness() {
        let refused = |complex: &SimplicialComplex| intersection_form(&algebra(complex)).unwrap_err();
        // The chain of facets is closed: each meets the next in all vertices but one.
        let projective = known_spaces::real_projective_space(4).unwrap();
        let rp4 = refused(&projective);
        let chain = rp4.message().strip_prefix("the complex is not orientable: the closed chain of facets ");
        let chain = chain.unwrap().strip_suffix(" reverses orientation").unwrap();
        let facets: Vec<usize> = chain.split(", ").map(|facet| facet.parse().unwrap()).collect();
        let all: Vec<_> = projective.simplices(4).collect();
        for i in 0..facets.len() {
            let (here, next) = (&all[facets[i]], &all[facets[(i + 1) % facets.len()]]);
            assert_eq!(here.intersection(next).unwrap().dimension(), 3, "{rp4}");
        }
        let band = refused(&known_spaces::triangle_strip(5).unwrap());
        assert_eq!(band.kind(), ErrorKind::NonManifold);
        assert!(band.message().contains("on the boundary"), "{band}");
        let book = refused(&known_spaces::book(3).unwrap());
        assert_eq!(book.kind(), ErrorKind::NonManifold);
        let poincare = refused(&known_spaces::glued_solid(Solid::Dodecahedron, 2).unwrap());
        assert_eq!(poincare.message(), "a complex of dimension 3 has no middle degree");
        let mixed = refused(&SimplicialComplex::from_facets([vec![0, 1, 2], vec![3, 4]]).unwrap());
        assert_eq!(mixed.kind(), ErrorKind::NotPure);
        assert!(refused(&SimplicialComplex::new()).message().contains("empty"));
        let three = refused(&SimplicialComplex::from_facets([[0, 1, 2], [0, 1, 3], [0, 1, 4]]).unwrap());
        assert!(three.message().contains("3 times (facets 0, 1, 2)"), "{three}");
    }
}
