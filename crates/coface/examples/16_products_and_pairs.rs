//! Guide 16: cup products, intersection forms, relative homology and the long exact sequence of a pair.
//!
//! Run with `cargo run -p coface --example 16_products_and_pairs`.

use coface::algebra::{Integer, Sign};
use coface::complexes::known_spaces::{
    complex_projective_plane, cyclic_torus, oriented_sum, simplex, small_klein_bottle,
};
use coface::topology::{CochainAlgebra, LongExactSequence, cup_product_table, intersection_form};
use coface::{CellId, Coefficients, Error, SimplicialComplex};

fn algebra(complex: &SimplicialComplex) -> Result<CochainAlgebra, Error> {
    CochainAlgebra::new(complex.freeze().to_delta()?)
}

fn main() -> Result<(), Error> {
    // The torus: two classes of degree 1 whose product is the generator of degree 2, up to sign; a square is zero, since products of degree 1
    // are antisymmetric.
    let torus = cup_product_table(&algebra(&cyclic_torus(2)?)?, 1, 1, Coefficients::Integers)?;
    let value = |i: usize, j: usize| torus.values()[i][j][0].clone();
    assert_eq!((value(0, 0), value(1, 1), value(0, 1).abs()), (Integer::ZERO, Integer::ZERO, Integer::ONE));
    assert_eq!(value(0, 1), -value(1, 0));

    // Over the field of two elements a Klein bottle has the Betti numbers of the torus, but a class whose square is not zero.
    let bottle = cup_product_table(&algebra(&small_klein_bottle()?)?, 1, 1, Coefficients::Modulo(2))?;
    let squares = (0..2).map(|i| bottle.values()[i][i][0] != Integer::ZERO);
    assert_eq!(bottle.first().len(), 2);
    assert!(squares.into_iter().any(|is_one| is_one));

    // Two complex projective planes, glued with the same orientation and with opposite ones: the homology agrees, the forms do not.
    // One is definite, the other is not: the signatures are 2 or -2, and 0.
    let plane = complex_projective_plane()?;
    let signature = |sign| -> Result<i64, Error> {
        let form = intersection_form(&algebra(&oriented_sum(&plane, &plane, sign)?)?)?;
        assert_eq!((form.rank(), form.determinant().abs()), (2, Integer::ONE));
        Ok(form.as_symmetric().expect("the dimension is 4").signature())
    };
    assert_eq!((signature(Sign::Plus)?.abs(), signature(Sign::Minus)?), (2, 0));

    // Relative homology: a disk modulo its rim has the reduced homology of a sphere. The connecting map sends the disk to its rim.
    let disk = simplex(2)?.chain_complex()?;
    let rim: Vec<Vec<CellId>> = vec![(0..3).map(CellId::new).collect(); 2];
    let sequence = LongExactSequence::new(&disk, &rim)?;
    assert_eq!(sequence.pair().betti_numbers(), [0, 0, 1]);
    let connecting = sequence.connecting(2).expect("degree 2 has one");
    assert!(connecting.is_injective() && connecting.is_surjective());
    // At each of its places the image of one map is the kernel of the next.
    sequence.check()?;

    // The rim of a Moebius band runs twice around its core. So the inclusion of the rim is multiplication by 2 in degree 1, and the pair has torsion.
    let band = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [0, 3, 4], [0, 1, 4]];
    let complex = SimplicialComplex::from_facets(band)?.chain_complex()?;
    // All five vertices lie on the rim, and of the 10 edges those of one triangle only: 5.
    let faces = complex.coboundary_matrix(1).expect("there are triangles");
    let on_rim =
        (0..10).filter(|&edge| faces.column(edge).entries().len() == 1).map(CellId::new).collect::<Vec<_>>();
    assert_eq!(on_rim.len(), 5);
    let sequence = LongExactSequence::new(&complex, &[(0..5).map(CellId::new).collect(), on_rim])?;
    let inclusion = sequence.inclusion(1).expect("degree 1 has one");
    assert_eq!(inclusion.columns()[0][0].abs(), 2.into());
    assert_eq!(inclusion.cokernel().to_string(), "Z/2");
    assert_eq!(sequence.pair().groups()[1].to_string(), "Z/2");
    Ok(())
}
