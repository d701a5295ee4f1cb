//! The report on a surface given by permutations of its halfedges.

use super::report::{Answer, BoundaryPart, Kind, Report};
use crate::answer::HalfedgePointers;
use coface_algebra::{Error, FaceId, HalfedgeId};
use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh, HalfedgePermutations, SurfaceComponent};
use coface_io::{Model, Structure};
use coface_topology::homology;

/// The report on a mesh: any pair of permutations is an oriented surface, so only its numbers are open.
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
        closed: Some(mesh.is_closed()),
        boundary_loops: Some(boundary_loops(mesh)),
        orientable: Some(true),
        coherently_oriented: Some(true),
        surface_type: surface,
        name: SurfaceComponent::names(&surfaces),
        surfaces,
        homology: homology(&complex).groups().to_vec(),
        ..Report::of_nothing()
    }
}

/// The permutations of more halfedges are not shown.
const MOST_HALFEDGES: usize = 60;

/// The halfedges of a small surface as its file numbers them: their permutations in cycles, and what each one points to.
pub(crate) fn pointers(model: &Model) -> Result<(Vec<[String; 3]>, Vec<HalfedgePointers>), Error> {
    let Some(Structure::Halfedges { next, twin, outer }) = model.structure() else {
        return Ok(Default::default());
    };
    if next.len() > MOST_HALFEDGES {
        return Ok(Default::default());
    }
    let permutations = HalfedgePermutations::new(next.clone(), twin.clone(), outer.clone())?;
    let (mesh, numbers) = (permutations.mesh()?, permutations.halfedge_numbers()?);
    // The mesh has outer faces last; in the file they are orbits like all others.
    let mut face_of = vec![0; next.len()];
    let mut is_met = vec![false; next.len()];
    let mut faces = 0;
    for start in 0..next.len() {
        let mut at = start;
        while !std::mem::replace(&mut is_met[at], true) {
            face_of[at] = faces;
            at = next[at] as usize;
            if at == start {
                faces += 1;
            }
        }
    }
    let row = |halfedge: usize| {
        let own = HalfedgeId::new(numbers.image(halfedge));
        HalfedgePointers {
            halfedge,
            next: next[halfedge] as usize,
            twin: twin[halfedge] as usize,
            source: mesh.source(own).index(),
            target: mesh.target(own).index(),
            edge: mesh.edge(own).index(),
            face: face_of[halfedge],
            outer: mesh.is_outer_halfedge(own),
        }
    };
    let around = |h: usize| next[twin[h] as usize] as usize;
    let cycles = [
        ("next", cycles(next.len(), &|h| next[h] as usize), "its cycles are the faces"),
        ("twin", cycles(next.len(), &|h| twin[h] as usize), "its cycles are the edges"),
        ("next of twin", cycles(next.len(), &around), "its cycles are the vertices"),
    ];
    let cycles = cycles.map(|(name, cycles, gloss)| [name.to_owned(), cycles, gloss.to_owned()]);
    Ok((cycles.to_vec(), (0..next.len()).map(row).collect()))
}

/// A permutation in cycles.
fn cycles(count: usize, image: &dyn Fn(usize) -> usize) -> String {
    let mut seen = vec![false; count];
    let mut text = String::new();
    for start in 0..count {
        let mut at = start;
        let mut cycle = Vec::new();
        while !std::mem::replace(&mut seen[at], true) {
            cycle.push(at.to_string());
            at = image(at);
        }
        if !cycle.is_empty() {
            text += &format!("({})", cycle.join(" "));
        }
    }
    text
}

/// The boundary loops, each with its faces on its left.
fn boundary_loops(mesh: &HalfedgeMesh) -> Vec<BoundaryPart> {
    let part = |outer: FaceId| {
        let mut vertices: Vec<u32> = mesh.face_vertices(outer).map(|vertex| vertex.to_u32()).collect();
        vertices[1..].reverse();
        let walk = vertices.iter().chain(vertices.first()).copied().collect();
        BoundaryPart { edge_count: vertices.len(), vertices, walks: vec![walk], is_simple: true }
    };
    mesh.outer_faces().map(part).collect()
}
