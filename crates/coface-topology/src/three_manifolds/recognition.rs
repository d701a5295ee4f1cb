//! Which 3-manifold a gluing table is.

use super::by_group::space_of_group;
use super::fibered::fibered_space;
use super::graph::Fibered;
use super::layered::lens;
use super::simplification::simplified_until;
use super::summands::connected_sum;
use super::{NamedSpace, SeifertSpace, SpaceName, SpaceProof};
use crate::groups::Effort;
use crate::homology::homology;
use coface_algebra::Error;
use coface_complexes::gluing::{FaceClasses, GluingTable};

/// The name of a connected 3-manifold, if its triangulation shows it; `None` says nothing.
///
/// Two structures are looked for. In a **layered** lens space two solid tori, in which each tetrahedron is layered on the one before, have
/// their boundary in common, and the meridians give its numbers. In a **fibered** triangulation stacks of tetrahedra over triangles are closed
/// by layered solid tori; base and meridians give the invariants of a Seifert fibration. It is named only if the first homology that follows
/// from the invariants is that of the table. One or two fibered pieces may be glued along a torus on which fibers do not agree, directly or through
/// layers of tetrahedra: a **graph manifold**, or a bundle of tori.
///
/// Where the triangulation shows neither, moves to others with no more tetrahedra are tried, so many `attempts`: see
/// [`simplified_until`]. Where none of them does, and the manifold is closed and orientable, a normal sphere is looked for that is not around a
/// vertex; crushed to a point, it leaves the summands of a **connected sum**, and the first homology says what went with it. Where the **fundamental group** is
/// known and only one space has it, that is the space. A space with a sphere as its boundary is a ball if a cone over the boundary makes it a sphere.
///
/// `faces` are the face classes of the table.
///
/// # Errors
/// Those of [`FaceClasses::chain_complex`]; [`ErrorKind::Shape`](coface_algebra::ErrorKind::Shape) for the face classes of another table.
///
/// # Complexity
/// $O(n^2)$ for n tetrahedra, and the Smith normal form of a matrix of size O(n); choices of fibers are followed up to a fixed number; all that for each attempt.
/// Normal surfaces are looked for once in the smallest triangulation that moves lead to, and in what each sphere leaves: up to 42 tetrahedra, and a fixed number
/// of vectors and comparisons.
///
/// # References
/// B. A. Burton, *Minimal triangulations and normal surfaces* (2003) and *A new approach to crushing 3-manifold triangulations* (2014); H. Seifert,
/// *Topologie dreidimensionaler gefaserter Raeume* (1933); F. Waldhausen, *Eine Klasse von 3-dimensionalen Mannigfaltigkeiten* (1967).
///
/// # Examples
/// ```
/// use coface_complexes::gluing::GluingTable;
/// use coface_topology::named_space;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let name = |signature: &str| -> Result<Option<String>, coface_algebra::Error> {
///     let table = GluingTable::from_isomorphism_signature(signature, 3)?;
///     Ok(named_space(&table, &table.faces()?, 0)?.map(|space| space.name().to_string()))
/// };
/// assert_eq!(name("bkaagb")?.as_deref(), Some("S3"));
/// assert_eq!(name("cMcabbjqs")?.as_deref(), Some("L(8,3)"));
/// # Ok(()) }
/// ```
pub fn named_space(
    table: &GluingTable,
    faces: &FaceClasses,
    attempts: usize,
) -> Result<Option<NamedSpace>, Error> {
    if table.dimension() != 3 || table.components().count() != 1 || faces.has_folds() {
        return Ok(None);
    }
    if !table.is_closed() {
        let Some(closed) = coned(table)? else { return Ok(None) };
        let sphere = named_space(&closed, &closed.faces()?, attempts)?;
        let is_ball = |space: &NamedSpace| space.name == SpaceName::Sphere;
        return Ok(sphere.filter(is_ball).map(|space| NamedSpace { name: SpaceName::Ball, ..space }));
    }
    if !table.ideal_vertices(faces)?.is_empty() {
        return Ok(None);
    }
    let table = &canonical(table)?;
    let (space, smaller) = looked_at(table, &table.faces()?, attempts)?;
    match space {
        Some(space) => Ok(Some(space)),
        None if table.orientation().odd_cycle().is_none() => connected_sum(&smaller, attempts),
        None => Ok(None),
    }
}

/// The name of a connected closed manifold that one of its triangulations shows, without cutting it.
pub(super) fn prime_space(
    table: &GluingTable,
    faces: &FaceClasses,
    attempts: usize,
) -> Result<Option<NamedSpace>, Error> {
    Ok(looked_at(table, faces, attempts)?.0)
}

/// The name that the triangulation or one after moves shows, and the smallest of these triangulations.
fn looked_at(
    table: &GluingTable,
    faces: &FaceClasses,
    attempts: usize,
) -> Result<(Option<NamedSpace>, GluingTable), Error> {
    if let Some(space) = shown(table, faces)? {
        return Ok((Some(space), table.clone()));
    }
    let mut found = None;
    let smaller = simplified_until(table, attempts, |other| {
        let name = other.faces().and_then(|faces| shown(other, &faces));
        found = name.ok().flatten();
        found.is_some()
    })?;
    let smaller = smaller.into_table();
    if found.is_none() && attempts > 0 {
        let effort = Effort::new().max_steps(STEPS_OF_GROUP * attempts as u64).time_limit(None);
        found = space_of_group(&smaller, &smaller.faces()?, effort)?;
    }
    Ok((found, smaller))
}

/// Steps for the name of the fundamental group, for each attempt.
const STEPS_OF_GROUP: u64 = 20_000;

/// Larger tables keep their numbers.
const CANONICAL: usize = 1000;

/// The table in the order of its isomorphism signature: what is found then does not depend on how it was numbered.
fn canonical(table: &GluingTable) -> Result<GluingTable, Error> {
    if table.simplex_count() > CANONICAL {
        return Ok(table.clone());
    }
    GluingTable::from_isomorphism_signature(&table.isomorphism_signature()?, 3)
}

/// The table with a cone over its boundary, if that is one sphere.
fn coned(table: &GluingTable) -> Result<Option<GluingTable>, Error> {
    let (boundary, facets) = table.boundary_table()?;
    if boundary.components().count() != 1 || boundary.faces()?.alternating_count() != 2 {
        return Ok(None);
    }
    let count = table.simplex_count();
    let mut closed = GluingTable::unglued(3, count + facets.len())?;
    let glue = |closed: &mut GluingTable, simplex: usize, facet: usize, neighbor: usize, images: &[u32]| {
        if closed.neighbor(simplex, facet).is_some() {
            Ok(())
        } else {
            closed.glue(simplex, facet, neighbor, images)
        }
    };
    for tetrahedron in 0..count {
        for facet in 0..4 {
            if let Some((next, images)) = table.neighbor(tetrahedron, facet) {
                let images: Vec<u32> = images.iter().map(|&image| u32::from(image)).collect();
                glue(&mut closed, tetrahedron, facet, next, &images)?;
            }
        }
    }
    for (triangle, &(tetrahedron, facet)) in facets.iter().enumerate() {
        // Vertices 0 to 2 are those of the triangle, and 3 is the apex.
        let mut base: Vec<u32> = (0..4).filter(|&vertex| vertex != facet as u32).collect();
        base.push(facet as u32);
        glue(&mut closed, count + triangle, 3, tetrahedron, &base)?;
        for side in 0..3 {
            if let Some((next, images)) = boundary.neighbor(triangle, side) {
                let images: Vec<u32> = images.iter().map(|&image| u32::from(image)).chain([3]).collect();
                glue(&mut closed, count + triangle, side, count + next, &images)?;
            }
        }
    }
    Ok(Some(closed))
}

/// The name that a triangulation of a closed manifold itself shows.
fn shown(table: &GluingTable, faces: &FaceClasses) -> Result<Option<NamedSpace>, Error> {
    if is_folded_tetrahedron(table) {
        return Ok(Some(NamedSpace { name: SpaceName::Sphere, proof: SpaceProof::FoldedTetrahedron }));
    }
    let is_orientable = table.orientation().odd_cycle().is_none();
    if let Some(numbers) = lens(table) {
        let name = lens_name(numbers, is_orientable);
        return Ok(name.map(|name| NamedSpace { name, proof: SpaceProof::LayeredSolidTori }));
    }
    if !is_orientable {
        return Ok(None);
    }
    let Some(space) = fibered_space(table, faces) else { return Ok(None) };
    let groups = homology(&faces.chain_complex()?);
    let first = &groups.groups()[1];
    let found: Vec<String> = first.torsion().iter().map(ToString::to_string).collect();
    if space.first_homology() != Some((found, first.betti())) {
        return Ok(None);
    }
    Ok(match space {
        Fibered::Seifert(space) => {
            seifert_name(space).map(|name| NamedSpace { name, proof: SpaceProof::SeifertFibration })
        }
        Fibered::Graph(space) => {
            Some(NamedSpace { name: SpaceName::Graph(space), proof: SpaceProof::FiberedPieces })
        }
        Fibered::Bundle(space) => {
            Some(NamedSpace { name: SpaceName::TorusBundle(space), proof: SpaceProof::FiberedPieces })
        }
    })
}

/// Whether the table is one tetrahedron whose facets are folded onto each other in pairs, each along the edge in which they meet: a fold makes a ball
/// of it whose boundary is the two other facets, and the other fold closes that to the 3-sphere.
fn is_folded_tetrahedron(table: &GluingTable) -> bool {
    let is_fold = |facet: usize| {
        table.neighbor(0, facet).is_some_and(|(_, images)| {
            let other = usize::from(images[facet]);
            other != facet
                && (0..4)
                    .all(|vertex| vertex == facet || vertex == other || usize::from(images[vertex]) == vertex)
        })
    };
    table.simplex_count() == 1 && (0..4).all(is_fold)
}

fn lens_name(numbers: (u64, u64), is_orientable: bool) -> Option<SpaceName> {
    match numbers {
        (0, _) => Some(SpaceName::SphereBundle { is_orientable }),
        _ if !is_orientable => None,
        (1, _) => Some(SpaceName::Sphere),
        (p, q) => Some(SpaceName::Lens { p, q }),
    }
}

/// The name of a fibered space: lens spaces have theirs, and prism manifolds the fibration over the sphere.
fn seifert_name(space: SeifertSpace) -> Option<SpaceName> {
    if let Some(numbers) = space.lens() {
        return lens_name(numbers, true);
    }
    if !space.is_base_orientable() && space.base_genus() == 1 && space.exceptional_count() < 2 {
        return match space.fibers()[..] {
            // Over the projective plane with one fiber: over the sphere with fibers 2, 2 and another.
            [(alpha, beta)] if beta.abs() > 1 => {
                let (beta, alpha) = (beta.abs(), alpha * beta.signum());
                SeifertSpace::new(true, 0, &[(2, 1), (2, -1), (beta, alpha)]).map(SpaceName::Seifert)
            }
            [(alpha, beta)] if beta.abs() == 1 => {
                let p = u64::try_from(4 * alpha).ok()?;
                lens_name((p, super::layered::normal(p, 2 * alpha - 1).1), true)
            }
            _ => None,
        };
    }
    // Over the sphere with four fibers 2 that cancel: the bundle of circles over the Klein bottle.
    if space.is_base_orientable()
        && space.base_genus() == 0
        && space.fibers() == [(2, 1), (2, 1), (2, 1), (2, -3)]
    {
        return SeifertSpace::new(false, 2, &[(1, 0)]).map(SpaceName::Seifert);
    }
    Some(SpaceName::Seifert(space))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::three_manifolds::{GluingMove, moved};

    /// Signatures with names, as Regina's census of closed 3-manifolds has them (B. A. Burton), in our form.
    const CENSUS: [(&str, &str); 22] = [
        ("bkaagb", "S3"),
        ("bkaagj", "S3"),
        ("bkaajj", "L(4,1)"),
        ("bkaajn", "L(5,2)"),
        ("cMcabbgqw", "RP3"),
        ("cMcabbjaj", "S2 x S1"),
        ("cMcabbjqs", "L(8,3)"),
        ("eLAkbcbddhxwqs", "L(21,8)"),
        ("eLAkbccddemken", "SFS [S2: (2,1) (2,1) (2,1)]"),
        ("eLAkbccddemkij", "SFS [S2: (2,1) (2,1) (3,-1)]"),
        ("gLALQbccefffemkbemi", "SFS [S2: (2,1) (2,1) (2,1) (2,-1)]"),
        ("gLALQbccefffemkbtli", "SFS [RP2/n2: (2,1) (2,1)]"),
        ("gLALQbcceffflpkkeux", "SFS [RP2/n2: (2,1) (2,-1)]"),
        ("gLALQbcceffflpkktua", "KB/n2 x~ S1"),
        ("gvLQQcdefeffncnhchx", "KB/n2 x~ S1"),
        ("gvLQQedfedffrwawrhh", "T x S1"),
        ("hLALAkbcceffggemkbemfr", "SFS [S2: (2,1) (2,1) (2,1) (2,1)]"),
        ("jLALLAQcbceghgiiiuijjiocatd", "SFS [KB/n2: (2,-1)]"),
        ("jLLLLQQbcgfhiihihtsmgwnkbsf", "SFS [T: (2,-3)]"),
        ("jLLLLQQbcgihfihihtsmbwsbbsf", "SFS [T: (2,-1)]"),
        ("jLALALQbcceffhiiiemkbemaenj", "SFS [RP2/n2: (2,1) (2,1) (2,1)]"),
        ("jLALALQbcceffhiiiemkbematkj", "SFS [S2: (2,1) (2,1) (2,1) (2,1) (2,-1)]"),
    ];

    fn name(table: &GluingTable, attempts: usize) -> Option<String> {
        named_space(table, &table.faces().unwrap(), attempts).unwrap().map(|space| space.name().to_string())
    }

    fn table(signature: &str) -> GluingTable {
        GluingTable::from_isomorphism_signature(signature, 3).unwrap()
    }

    #[test]
    fn names_are_those_of_the_census() {
        for (signature, expected) in CENSUS {
            assert_eq!(name(&table(signature), 20).as_deref(), Some(expected), "{signature}");
        }
    }

    /// Moves keep the space: whatever other triangulation has a name, it is the same one.
    #[test]
    fn names_do_not_depend_on_the_triangulation() {
        let mut named = 0;
        for (signature, expected) in CENSUS {
            let mut other = table(signature);
            for step in 0..4 {
                let places = (0..other.simplex_count()).flat_map(|t| (0..4).map(move |f| (t, f)));
                let moved = places.skip(3 * step).find_map(|(tetrahedron, facet)| {
                    moved(&other, GluingMove::TwoToThree { tetrahedron, facet }).unwrap()
                });
                let Some(next) = moved else { break };
                other = next;
                if let Some(found) = name(&other, 10) {
                    assert_eq!(found, expected, "{signature} after {step} moves");
                    named += 1;
                }
            }
        }
        assert!(named > 40, "{named}");
    }

    #[test]
    fn a_ball_is_a_sphere_without_a_ball() {
        let tetrahedron = GluingTable::unglued(3, 1).unwrap();
        assert_eq!(name(&tetrahedron, 20).as_deref(), Some("B3"));
        let apart = GluingTable::unglued(3, 2).unwrap();
        assert_eq!(name(&apart, 20), None);
    }

    /// Ideal vertices, folded edges, a hyperbolic manifold, a Poincare sphere with its fibers.
    #[test]
    fn what_is_not_proved_has_no_name() {
        assert_eq!(name(&table("cPcbbbiht"), 5), None);
        let mut folded = GluingTable::unglued(3, 1).unwrap();
        folded.glue(0, 3, 0, &[1, 0, 3, 2]).unwrap();
        assert_eq!(name(&folded, 5), None);
        assert_eq!(name(&table("jLLLzQQcdfeghihiiqceqgvlkuq"), 5), None);
    }

    /// The quotients of the 3-sphere by Q8, SL(2,3) and SL(2,5), two prism spaces, the twisted bundle of spheres, the product of projective plane and circle.
    #[test]
    fn groups_name_what_triangulations_do_not_show() {
        for (signature, expected) in [
            ("cPcbbbqxh", "SFS [S2: (2,1) (2,1) (2,-1)]"),
            ("fvPQcdecedekrsnrs", "SFS [S2: (2,1) (3,1) (5,-4)]"),
            ("eLPkbcdddhrrnk", "SFS [S2: (2,1) (3,1) (3,-2)]"),
            ("dLQbccchhrw", "SFS [S2: (2,1) (2,1) (3,-2)]"),
            ("cPcbbbajs", "S2 x~ S1"),
            ("dLQbcccajqs", "RP2 x S1"),
        ] {
            assert_eq!(name(&table(signature), 20).as_deref(), Some(expected), "{signature}");
        }
    }

    /// The same table with its tetrahedra the other way round and the vertices of each moved on by its number.
    fn renumbered(table: &GluingTable) -> GluingTable {
        let count = table.simplex_count();
        let mut other = GluingTable::unglued(3, count).unwrap();
        let new = |tetrahedron: usize, vertex: usize| (vertex + tetrahedron + 1) % 4;
        for tetrahedron in 0..count {
            for facet in 0..4 {
                let (next, images) = table.neighbor(tetrahedron, facet).unwrap();
                let mut moved = [0; 4];
                for (vertex, &image) in images.iter().enumerate() {
                    moved[new(tetrahedron, vertex)] = new(next, usize::from(image)) as u32;
                }
                let (from, to) = (count - 1 - tetrahedron, count - 1 - next);
                if other.neighbor(from, new(tetrahedron, facet)).is_none() {
                    other.glue(from, new(tetrahedron, facet), to, &moved).unwrap();
                }
            }
        }
        other
    }

    #[test]
    fn names_do_not_depend_on_numbers() {
        let more = ["gvLQQcdefeffbwnpghe", "kLLvMPQkcdffjgihijjhsajxscncmd"];
        for signature in CENSUS.iter().map(|entry| entry.0).chain(more) {
            let mut other = table(signature);
            let first = name(&other, 10);
            for _ in 0..3 {
                other = renumbered(&other);
                assert_eq!(
                    other.isomorphism_signature().unwrap(),
                    table(signature).isomorphism_signature().unwrap()
                );
                assert_eq!(name(&other, 10), first, "{signature}");
            }
        }
    }
}
