//! The report on a surface given by permutations of its halfedges.

use super::report::{Answer, Kind, Report};
use coface_algebra::HalfedgeId;
use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh, SurfaceComponent};
use coface_topology::homology;

/// The report on a mesh: any pair of permutations is a closed oriented surface, so only its numbers are open.
pub(crate) fn report(mesh: &HalfedgeMesh) -> Report {
    let complex = mesh.chain_complex().expect("a halfedge mesh has a chain complex");
    let map = mesh.two_skeleton().and_then(GeneralizedMap::new).expect("permutations are a surface");
    let surfaces = map.surface_components();
    let surface = match &surfaces[..] {
        [only] => only.surface(),
        _ => None,
    };
    let is_empty = mesh.halfedge_count() == 0;
    Report {
        kind: Kind::Surface,
        f_vector: if is_empty { Vec::new() } else { mesh.f_vector() },
        shapes: if is_empty { Vec::new() } else { vec![("polygon", mesh.face_count())] },
        components: mesh.component_count(),
        euler_characteristic: mesh.euler_characteristic(),
        manifold: Answer::Yes,
        boundary_loops: Some(Vec::new()),
        orientable: Some(true),
        coherently_oriented: Some(true),
        surface_type: surface,
        name: SurfaceComponent::names(&surfaces),
        surfaces,
        homology: homology(&complex).groups().to_vec(),
        permutations: if mesh.halfedge_count() <= MOST_HALFEDGES { permutations(mesh) } else { Vec::new() },
        ..Report::of_nothing()
    }
}

/// The permutations of more halfedges are not shown.
const MOST_HALFEDGES: usize = 60;

/// The permutations of the halfedges in cycles.
fn permutations(mesh: &HalfedgeMesh) -> Vec<[String; 3]> {
    let cycles = |image: &dyn Fn(HalfedgeId) -> HalfedgeId| {
        let mut seen = vec![false; mesh.halfedge_count()];
        let mut text = String::new();
        for start in 0..seen.len() {
            let mut at = HalfedgeId::new(start);
            let mut cycle = Vec::new();
            while !std::mem::replace(&mut seen[at.index()], true) {
                cycle.push(at.index().to_string());
                at = image(at);
            }
            if !cycle.is_empty() {
                text += &format!("({})", cycle.join(" "));
            }
        }
        text
    };
    [
        ("next", cycles(&|halfedge| mesh.next(halfedge)), "its cycles are the faces"),
        ("twin", cycles(&|halfedge| mesh.twin(halfedge)), "its cycles are the edges"),
        ("next of twin", cycles(&|halfedge| mesh.next(mesh.twin(halfedge))), "its cycles are the vertices"),
    ]
    .map(|(name, cycles, gloss)| [name.to_owned(), cycles, gloss.to_owned()])
    .to_vec()
}
