//! The report on a surface given by permutations of its halfedges.

use super::report::{Answer, Kind, Report};
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
        ..Report::of_nothing()
    }
}
