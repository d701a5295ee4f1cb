//! Manifolds among complexes: the verdict by links, with the fundamental groups of those that look like spheres.

use super::GroupName;
use crate::groups::{EdgePathGroups, Effort};
use coface_algebra::Error;
use coface_algebra::chains::{ChainComplex, TwoSkeleton};
use coface_complexes::gluing::{FaceClasses, GluingFault, GluingTable, GluingVerdict, GluingWitness};
use coface_complexes::simplicial::{FrozenComplex, LinkFault, ManifoldVerdict, ManifoldWitness};

/// Steps for the name of the fundamental group of one link.
const STEPS: u64 = 2_000_000;

/// Whether a complex is a combinatorial manifold, as [`FrozenComplex::manifold_verdict_within`] says; a link that has the homology of a
/// sphere or ball but was not seen to be one is refuted where its fundamental group is known and not trivial.
///
/// # Errors
/// [`coface_algebra::ErrorKind::TooLarge`] for links beyond 32 bits.
///
/// # Panics
/// If `chains` has other numbers of cells than the complex.
///
/// # Examples
/// The suspension of the Poincare sphere has the homology of the 4-sphere, but the link of each apex is the Poincare sphere.
/// ```
/// use coface_complexes::known_spaces::{Solid, glued_solid};
/// use coface_complexes::simplicial::LINK_BUDGET;
/// use coface_topology::manifold_verdict;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let suspension = glued_solid(Solid::Dodecahedron, 2)?.suspension()?.0.freeze();
/// let verdict = manifold_verdict(&suspension, &suspension.chain_complex()?, LINK_BUDGET)?;
/// assert_eq!(verdict.as_str(), "no");
/// let witness = verdict.witness().expect("no has a witness");
/// assert!(witness.message().contains("SL(2,5)"), "{}", witness.message());
/// # Ok(()) }
/// ```
pub fn manifold_verdict(
    complex: &FrozenComplex,
    chains: &ChainComplex,
    budget: u64,
) -> Result<ManifoldVerdict, Error> {
    let verdict = complex.manifold_verdict_within(chains, budget);
    let Some(witness) = verdict.witness() else { return Ok(verdict) };
    if witness.fault() != LinkFault::LinkNotRecognized {
        return Ok(verdict);
    }
    let simplex = witness.cells()[0].clone();
    let link = complex.thaw().link(&simplex)?;
    let Some(name) = group_against(&link.freeze().two_skeleton()?) else { return Ok(verdict) };
    let message =
        format!("the link of {simplex} has the homology of a sphere, but the fundamental group {name}");
    Ok(verdict.refuted(ManifoldWitness::new(LinkFault::LinkNotSimplyConnected, vec![simplex], 1, message)))
}

/// Whether the space of a gluing table is a manifold, as [`GluingTable::manifold_verdict`] says; a link that has the homology of a
/// sphere or ball but was not seen to be one is refuted where its fundamental group is known and not trivial.
///
/// # Errors
/// Those of [`GluingTable::manifold_verdict`].
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::gluing::GluingTable;
/// use coface_complexes::known_spaces::{Solid, glued_solid};
/// use coface_topology::gluing_manifold_verdict;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let suspension = glued_solid(Solid::Dodecahedron, 2)?.suspension()?.0;
/// let facets: Vec<Vec<u32>> = suspension.facets().iter().map(|facet| facet.numbers().to_vec()).collect();
/// let table = GluingTable::from_simplices(&RaggedArray::from_lists(facets))?;
/// let verdict = gluing_manifold_verdict(&table, &table.faces()?)?;
/// assert!(verdict.witness().expect("no has a witness").message().contains("SL(2,5)"));
/// # Ok(()) }
/// ```
pub fn gluing_manifold_verdict(table: &GluingTable, faces: &FaceClasses) -> Result<GluingVerdict, Error> {
    let verdict = table.manifold_verdict(faces)?;
    let Some(witness) = verdict.witness() else { return Ok(verdict) };
    let first = witness.classes().first().map(|class| class.index());
    let (GluingFault::LinkNotRecognized, Some(vertex)) = (witness.fault(), first) else {
        return Ok(verdict);
    };
    let links = table.vertex_links(faces)?;
    let Some(name) = group_against(&links[vertex].table().faces()?.two_skeleton()?) else {
        return Ok(verdict);
    };
    let message =
        format!("the link of vertex {vertex} has the homology of a sphere, but the fundamental group {name}");
    Ok(verdict.refuted(GluingWitness::at_vertex(GluingFault::LinkNotSimplyConnected, vertex, message)))
}

/// The fundamental group of a link, where it is known and not trivial.
fn group_against(link: &TwoSkeleton) -> Option<GroupName> {
    let effort = Effort::new().max_steps(STEPS).time_limit(None);
    let name = EdgePathGroups::new(link).presentation(0).recognized(effort)?;
    (name.order().as_deref() != Some("1")).then_some(name)
}
