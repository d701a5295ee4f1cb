//! Connected sums: a triangulation is cut along normal spheres until each piece has a name.

use super::normal_surfaces::{NormalSurface, vertex_surfaces};
use super::recognition::prime_space;
use super::simplification::simplified;
use super::{NamedSpace, SpaceName, SpaceProof};
use crate::homology::{AbelianGroup, homology};
use coface_algebra::{Error, Integer};
use coface_complexes::gluing::{FaceClasses, GluingTable};

/// The name of a connected closed orientable 3-manifold as a connected sum, or as one summand if there is one alone; `None` if a piece has
/// no name in which no sphere is found.
///
/// A sphere is crushed to a point. That undoes connected sums, and may take 3-spheres and summands S2 x S1, RP3 and L(3,1) away; how many went
/// is the difference of the first homology, which in the end has to be that of the sum.
pub(super) fn connected_sum(table: &GluingTable, attempts: usize) -> Result<Option<NamedSpace>, Error> {
    let whole = first_homology(&table.faces()?)?;
    let mut summands = Vec::new();
    let mut found = AbelianGroup::new(0, Vec::new());
    let mut is_cut = false;
    let mut waiting = vec![table.clone()];
    while let Some(piece) = waiting.pop() {
        // Moves that start from what a sphere has left; the table itself is as small as moves have made it.
        let piece = if is_cut { simplified(&piece, attempts)?.into_table() } else { piece };
        let faces = piece.faces()?;
        if is_cut && let Some(space) = prime_space(&piece, &faces, attempts)? {
            if space.name != SpaceName::Sphere {
                found = sum(&found, &first_homology(&faces)?);
                summands.push(space.name);
            }
            continue;
        }
        let Some(sphere) = sphere(&piece, &faces) else { return Ok(None) };
        is_cut = true;
        waiting.extend(connected_pieces(&sphere.crushed(&piece)?)?);
    }
    let Some(lost) = lost_summands(&whole, &found) else { return Ok(None) };
    summands.extend(lost);
    summands.sort_by_key(|summand| (rank(summand), summand.to_string()));
    let name = match summands.len() {
        0 => SpaceName::Sphere,
        1 => summands.remove(0),
        _ => SpaceName::Sum(summands),
    };
    Ok(Some(NamedSpace { name, proof: SpaceProof::NormalSpheres }))
}

/// A place in the order of summands: lens spaces by their numbers, fibered spaces, bundles of spheres.
fn rank(summand: &SpaceName) -> (u8, u64, u64) {
    match *summand {
        SpaceName::Lens { p, q } => (0, p, q),
        SpaceName::SphereBundle { .. } => (2, 0, 0),
        _ => (1, 0, 0),
    }
}

fn first_homology(faces: &FaceClasses) -> Result<AbelianGroup, Error> {
    let groups = homology(&faces.chain_complex()?);
    Ok(groups.groups()[1].clone())
}

fn sum(one: &AbelianGroup, two: &AbelianGroup) -> AbelianGroup {
    AbelianGroup::new(one.betti() + two.betti(), [one.torsion(), two.torsion()].concat())
}

/// A normal sphere that is not around a vertex.
fn sphere(table: &GluingTable, faces: &FaceClasses) -> Option<NormalSurface> {
    let surfaces = vertex_surfaces(table, faces)?;
    // A projective plane is crushed as the sphere around it: it has the same types of quadrilaterals.
    surfaces.into_iter().find(|surface| surface.euler_characteristic(faces) > 0)
}

/// The components of a table as tables.
fn connected_pieces(table: &GluingTable) -> Result<Vec<GluingTable>, Error> {
    let mut pieces = Vec::new();
    for members in table.components().members() {
        let mut piece = GluingTable::unglued(3, members.len())?;
        let number = |tetrahedron: usize| members.iter().position(|member| member.index() == tetrahedron);
        for (own, member) in members.iter().enumerate() {
            for facet in 0..4 {
                let Some((next, images)) = table.neighbor(member.index(), facet) else { continue };
                if let (None, Some(next)) = (piece.neighbor(own, facet), number(next)) {
                    let images: Vec<u32> = images.iter().map(|&image| u32::from(image)).collect();
                    piece.glue(own, facet, next, &images)?;
                }
            }
        }
        pieces.push(piece);
    }
    Ok(pieces)
}

/// The summands S2 x S1, RP3 and L(3,1) that are in the whole and were not found, if these explain the whole.
fn lost_summands(whole: &AbelianGroup, found: &AbelianGroup) -> Option<Vec<SpaceName>> {
    let divisible = |group: &AbelianGroup, prime: u64| {
        let prime = Integer::from(prime);
        group.torsion().iter().filter(|order| prime.divides(order)).count()
    };
    let bundles = whole.betti().checked_sub(found.betti())?;
    let twos = divisible(whole, 2).checked_sub(divisible(found, 2))?;
    let threes = divisible(whole, 3).checked_sub(divisible(found, 3))?;
    let orders = std::iter::repeat_n(2.into(), twos).chain(std::iter::repeat_n(3.into(), threes)).collect();
    if sum(found, &AbelianGroup::new(bundles, orders)) != *whole {
        return None;
    }
    let lens = |p: u64| SpaceName::Lens { p, q: 1 };
    let bundle = SpaceName::SphereBundle { is_orientable: true };
    let lost = std::iter::repeat_n(lens(2), twos)
        .chain(std::iter::repeat_n(lens(3), threes))
        .chain(std::iter::repeat_n(bundle, bundles));
    Some(lost.collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::three_manifolds::named_space;

    /// The tetrahedra of the barycentric subdivision: tetrahedron 24 t + i for permutation i of the vertices of t; vertex k of it is in the
    /// middle of a face with k + 1 vertices.
    fn subdivided(table: &GluingTable) -> GluingTable {
        let orders: Vec<[usize; 4]> = (0..256)
            .map(|code: usize| [code / 64, code / 16 % 4, code / 4 % 4, code % 4])
            .filter(|order| order.iter().fold(0, |set, &vertex| set | 1 << vertex) == 15)
            .collect();
        let place = |order: [usize; 4]| orders.iter().position(|&other| other == order).unwrap();
        let mut finer = GluingTable::unglued(3, 24 * table.simplex_count()).unwrap();
        for tetrahedron in 0..table.simplex_count() {
            for (own, &order) in orders.iter().enumerate() {
                for facet in 0..4 {
                    let next = if facet < 3 {
                        let mut swapped = order;
                        swapped.swap(facet, facet + 1);
                        24 * tetrahedron + place(swapped)
                    } else {
                        let (next, images) = table.neighbor(tetrahedron, order[3]).unwrap();
                        24 * next + place(order.map(|vertex| usize::from(images[vertex])))
                    };
                    if finer.neighbor(24 * tetrahedron + own, facet).is_none() {
                        finer.glue(24 * tetrahedron + own, facet, next, &[0, 1, 2, 3]).unwrap();
                    }
                }
            }
        }
        finer
    }

    /// The connected sum: both are opened along a triangle of the subdivision, which is embedded, and each side of one is glued to one of the other.
    fn connected(one: &GluingTable, two: &GluingTable) -> GluingTable {
        let parts = [subdivided(one), subdivided(two)];
        let base = parts[0].simplex_count();
        let mut table = GluingTable::unglued(3, base + parts[1].simplex_count()).unwrap();
        let across = parts.each_ref().map(|part| part.neighbor(0, 0).unwrap().0);
        for (part, start) in parts.iter().zip([0, base]) {
            let opened = part.neighbor(0, 0).unwrap().0;
            for tetrahedron in 0..part.simplex_count() {
                for facet in 0..4 {
                    let (next, _) = part.neighbor(tetrahedron, facet).unwrap();
                    let is_opened = facet == 0 && [0, opened].contains(&tetrahedron);
                    if !is_opened && table.neighbor(start + tetrahedron, facet).is_none() {
                        table.glue(start + tetrahedron, facet, start + next, &[0, 1, 2, 3]).unwrap();
                    }
                }
            }
        }
        table.glue(0, 0, base + across[1], &[0, 1, 2, 3]).unwrap();
        table.glue(base, 0, across[0], &[0, 1, 2, 3]).unwrap();
        table
    }

    fn table(signature: &str) -> GluingTable {
        GluingTable::from_isomorphism_signature(signature, 3).unwrap()
    }

    fn name(table: &GluingTable) -> Option<String> {
        named_space(table, &table.faces().unwrap(), 20).unwrap().map(|space| space.name().to_string())
    }

    #[test]
    fn sums_have_the_names_of_their_summands() {
        let spaces = [
            ("bkaagj", ""),
            ("cMcabbgqw", "RP3"),
            ("cMcabbgaj", "L(3,1)"),
            ("bkaajn", "L(5,2)"),
            ("cMcabbjqs", "L(8,3)"),
            ("eLAkbccddemken", "SFS [S2: (2,1) (2,1) (2,1)]"),
            ("cMcabbjaj", "S2 x S1"),
        ];
        for (at, &(one, first)) in spaces.iter().enumerate() {
            for &(two, second) in &spaces[at..] {
                let expected = match (first, second) {
                    ("", "") => "S3".to_owned(),
                    ("", other) => other.to_owned(),
                    _ => format!("{first} # {second}"),
                };
                let sum = connected(&table(one), &table(two));
                assert_eq!(name(&sum), Some(expected), "{one} {two}");
            }
        }
    }

    /// Three summands, two of which went with the spheres, and the sum of many.
    #[test]
    fn sums_of_sums_have_all_their_summands() {
        let (projective, lens, bundle) = (table("cMcabbgqw"), table("bkaajn"), table("cMcabbjaj"));
        let three = connected(&simplified(&connected(&projective, &bundle), 20).unwrap().into_table(), &lens);
        assert_eq!(name(&three).as_deref(), Some("RP3 # L(5,2) # S2 x S1"));
        let mut many = projective.clone();
        for _ in 0..3 {
            many = simplified(&connected(&many, &projective), 20).unwrap().into_table();
        }
        assert_eq!(name(&many).as_deref(), Some("RP3 # RP3 # RP3 # RP3"));
    }

    /// A hyperbolic manifold in a sum has no name, and neither has the sum.
    #[test]
    fn a_sum_with_a_nameless_summand_has_no_name() {
        assert_eq!(name(&connected(&table("bkaajn"), &table("jLLLzQQcdfeghihiiqceqgvlkuq"))), None);
    }

    /// A bundle of spheres has one as its fiber, the projective space a projective plane, and other lens spaces neither.
    #[test]
    fn vertex_surfaces_are_those_that_are_known() {
        for (signature, greatest) in [("cMcabbjaj", 2), ("cMcabbgqw", 1), ("bkaajj", 0)] {
            let table = table(signature);
            let faces = table.faces().unwrap();
            let surfaces = vertex_surfaces(&table, &faces).unwrap();
            let found = surfaces.iter().map(|surface| surface.euler_characteristic(&faces)).max();
            assert_eq!(found, Some(greatest), "{signature}");
        }
        let lens = table("cMcabbjqs");
        assert!(sphere(&lens, &lens.faces().unwrap()).is_none());
    }
}
