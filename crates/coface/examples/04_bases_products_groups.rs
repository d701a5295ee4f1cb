//! Guide 4: bases of homology with proofs, products, and fundamental groups.
//!
//! Run with `cargo run -p coface --example 04_bases_products_groups`.

use coface::CellId;
use coface::algebra::Integer;
use coface::algebra::chains::Chain;
use coface::complexes::gluing::GluingTable;
use coface::complexes::known_spaces::{complex_projective_plane, projective_plane};
use coface::topology::{Bounding, CochainAlgebra, EdgePathGroups, Effort, HomologyBasis, intersection_form};

fn main() -> Result<(), coface::Error> {
    // The projective plane with six vertices: a loop of three edges does not bound, twice the loop does, and the chain
    // that it bounds comes along.
    let plane = projective_plane()?.freeze();
    let complex = plane.chain_complex()?;
    let basis = HomologyBasis::new(&complex);
    let generator = &basis.generators(1)[0];
    assert_eq!((generator.order(), generator.length()), (Some(&2.into()), 3.into()));
    let certificate = basis.certificate(1, 0).expect("a generator of finite order has one");
    assert_eq!(complex.boundary(&certificate)?, generator.chain().scaled(&2.into())?);

    // Any cycle may be asked: the rim of the first triangle bounds just that triangle.
    let triangle = Chain::new(&complex, 2, [(CellId::new(0), Integer::ONE)])?;
    let rim = complex.boundary(&triangle)?;
    assert!(basis.class_of(&rim)?.is_zero());
    let Bounding::Bounds(chain) = basis.bounding(&rim)? else { panic!("the rim bounds") };
    assert_eq!(complex.boundary(&chain)?, rim);

    // Products: on the complex projective plane the square of the class of degree 2 is a generator.
    let cochains = CochainAlgebra::new(complex_projective_plane()?.freeze().to_delta()?)?;
    let form = intersection_form(&cochains)?;
    assert_eq!((form.rank(), form.determinant().abs()), (1, 1.into()));

    // Groups: loops of the plane up to homotopy, and those of a lens space given by Regina's signature.
    let group = EdgePathGroups::new(&plane.two_skeleton()?);
    let name = |group: &EdgePathGroups| {
        group
            .presentation(0)
            .recognized(Effort::default())
            .map_or("unknown".to_owned(), |name| name.to_string())
    };
    assert_eq!(name(&group), "Z/2");
    let lens = GluingTable::from_isomorphism_signature("cMcabbjxr", 3)?;
    assert_eq!(name(&EdgePathGroups::new(&lens.faces()?.two_skeleton()?)), "Z/5");
    Ok(())
}
