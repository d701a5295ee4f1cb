//! Guide 17: fundamental groups, their subgroups and covers, canonical polygons, and covers laid out in the plane.
//!
//! Run with `cargo run -p coface --example 17_groups_and_covers`.

use coface::algebra::{Sign, Word};
use coface::complexes::known_spaces::{cyclic_torus, klein_grid, oriented_sum};
use coface::complexes::surface::GeneralizedMap;
use coface::topology::{
    CanonicalCut, CosetTable, CoverExtent, CoverPlane, CutSurface, EdgePathGroups, Effort, PermutationGroup,
    PolygonPlane, Presentation, SurfaceGroup, TreeCotree, UniversalCover,
};

fn main() -> Result<(), coface::Error> {
    // The group of the trefoil knot, a b a = b a b, is not that of a circle: it maps onto the permutations of three things.
    let trefoil = Presentation::new(2, vec![Word::from_letters([1, 2, 1, -2, -1, -2])])?;
    assert_eq!(trefoil.abelianization().to_string(), "Z");
    let colors =
        trefoil.homomorphisms_to(PermutationGroup::Symmetric(3), Effort::default()).expect("it is small");
    assert_eq!(colors.onto, 6);

    // Rotations of a cube: a^2 = b^3 = (ab)^4 = 1 has 24 elements; those that ab generates are 4, so there are 6 cosets, one for each side.
    let relators = [vec![1, 1], vec![2, 2, 2], vec![1, 2, 1, 2, 1, 2, 1, 2]].map(Word::from_letters);
    let cube = Presentation::new(2, relators.to_vec())?;
    let cosets = |subgroup: &[Word]| CosetTable::new(&cube, subgroup, 1_000).map(|table| table.index());
    assert_eq!((cosets(&[]), cosets(&[Word::from_letters([1, 2])])), (Some(24), Some(6)));

    // Covers of two sheets belong to subgroups of index 2: three for the Klein bottle, as for the torus. One of them is the orientation cover.
    let klein = klein_grid(5, 5)?.freeze();
    let groups = EdgePathGroups::new(&klein.two_skeleton()?);
    let subgroups = groups.presentation(0).subgroups_up_to(2, Effort::default()).expect("few are needed");
    assert_eq!(subgroups.iter().filter(|class| class.index() == 2).count(), 3);
    let bottle = GeneralizedMap::new(klein.two_skeleton()?)?;
    assert_eq!(bottle.orientation_double_cover().map().surfaces()[0].to_string(), "torus");

    // In the group of a surface words are compared exactly: in that of the Klein bottle, ab is ba^-1 and not ba.
    let group = SurfaceGroup::closed(&Word::from_letters([1, 2, 1, -2]))?;
    let (a, b) = (Word::from_letters([1]), Word::from_letters([2]));
    assert!(
        group.are_equal(&a.times(&b), &b.times(&a.inverse())) && !group.are_equal(&a.times(&b), &b.times(&a))
    );

    // A double torus as its canonical polygon: cut along four loops through one point it is an octagon with the word of two commutators.
    let torus = cyclic_torus(2)?;
    let double = oriented_sum(&torus, &torus, Sign::Plus)?;
    let double = GeneralizedMap::new(double.freeze().two_skeleton()?)?;
    let cut = CanonicalCut::new(&double, None)?;
    assert_eq!(cut.components()[0].word(), [1, 2, -1, -2, 3, 4, -3, -4]);
    // Drawn in the plane: the polygon has its corners on the unit circle, and everything else lies inside.
    let drawn = cut.straightened()?;
    let slice = drawn.slice();
    let points = drawn.layout(&slice, PolygonPlane::Euclidean, None)?;
    assert_eq!(points.len(), slice.surface().vertex_count());
    assert!(points.iter().all(|[x, y]| x.hypot(*y) < 1.0 + 1e-9));

    // Universal covers: of a torus in the plane, of a double torus in the hyperbolic disk. The numbers of copies at each distance tell them apart.
    let cover_of = |map: &GeneralizedMap| -> Result<(Vec<usize>, CoverPlane), coface::Error> {
        let cut = CutSurface::new(map, &TreeCotree::new(map));
        let cover = UniversalCover::new(map, &cut, 0, CoverExtent::Radius(2), 100_000)?;
        Ok((cover.sphere_sizes(), cover.layout(map, None)?.plane()))
    };
    let torus = GeneralizedMap::new(torus.freeze().two_skeleton()?)?;
    assert_eq!(cover_of(&torus)?, (vec![1, 4, 8], CoverPlane::Flat));
    assert_eq!(cover_of(&double)?, (vec![1, 8, 56], CoverPlane::Hyperbolic));
    Ok(())
}
