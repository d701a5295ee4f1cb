//! Repair, slicing and editing of real surfaces: those of the repository, and those of the folder that `COFACE_DATA` names.

use coface::algebra::UnionFind;
use coface::complexes::surface::{FacesAtEdge, HalfedgeMesh, MeshRepair, PolygonMesh};
use coface::io::{Model, read_path};
use coface::{EdgeId, FaceId, HalfedgeId, VertexId};
use std::path::{Path, PathBuf};

/// The polygon models of both folders with at most 40,000 faces, so that debug builds stay quick.
fn models() -> Vec<(PathBuf, Model)> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data")];
    if let Some(data) = std::env::var_os("COFACE_DATA") {
        folders.extend(["surfaces", "tricky"].map(|folder| Path::new(&data).join(folder)));
    }
    let mut found = Vec::new();
    for folder in folders {
        let entries = std::fs::read_dir(folder).expect("the folder is there");
        let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("a readable folder").path()).collect();
        paths.sort();
        for path in paths {
            let is_small = path.metadata().is_ok_and(|file| file.is_file() && file.len() < 2_000_000);
            if !is_small {
                continue;
            }
            // What is no model is the business of other tests.
            let Ok(model) = read_path(&path, None) else { continue };
            if !model.polygons().is_empty() && model.cells().is_empty() {
                found.push((path, model));
            }
        }
    }
    found
}

/// The same mesh as a surface: edges and vertices split, faces turned; `None` if it is not orientable.
fn repaired(model: &Model) -> Option<HalfedgeMesh> {
    let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &[]).ok()?;
    let mut repair = MeshRepair::new(mesh);
    repair.split_edges(FacesAtEdge::CoherentPairs).expect("small meshes have room");
    repair.split_vertices().expect("small meshes have room");
    assert!(repair.mesh().manifold_verdict().is_manifold());
    repair.orient().ok()?;
    Some(repair.mesh().halfedges().expect("an oriented surface"))
}

/// What no edit changes.
fn invariants(mesh: &HalfedgeMesh) -> (i64, usize, usize, usize) {
    (mesh.euler_characteristic(), mesh.component_count(), mesh.genus(), mesh.outer_face_count())
}

#[test]
fn repaired_surfaces_keep_their_faces() {
    let mut count = 0;
    for (path, model) in models() {
        let Ok(mesh) = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &[]) else {
            continue;
        };
        let (verdict, oriented) = (mesh.manifold_verdict(), mesh.orientation().is_coherent());
        let mut repair = MeshRepair::new(mesh.clone());
        repair.split_edges(FacesAtEdge::Apart).unwrap();
        repair.split_vertices().unwrap();
        let is_sound = verdict.is_manifold();
        assert_eq!(repair.vertices_split().is_empty(), is_sound, "{}", path.display());
        let orientable = repair.mesh().orientation().is_orientable() == Some(true);
        assert_eq!(repair.orient().is_ok(), orientable, "{}", path.display());
        if is_sound && orientable {
            assert_eq!(repair.faces_turned().is_empty(), oriented == Some(true), "{}", path.display());
        }
        for face in (0..mesh.face_count()).map(FaceId::new) {
            let mut back: Vec<usize> = repair
                .mesh()
                .face(face)
                .iter()
                .map(|&v| repair.vertex_sources()[VertexId::from_u32(v)].index())
                .collect();
            if repair.faces_turned().binary_search(&face).is_ok() {
                back.reverse();
            }
            assert!(back.iter().zip(mesh.face(face)).all(|(&a, &b)| a == b as usize), "{}", path.display());
        }
        count += 1;
    }
    assert!(count >= 4);
}

#[test]
fn real_surfaces_are_cut_to_disks_and_glued_again() {
    for (path, model) in models() {
        let Some(mesh) = repaired(&model) else { continue };
        // What a spanning forest of the faces does not cross.
        let mut forest = UnionFind::new(mesh.face_count() + mesh.outer_face_count());
        let is_cut = |&edge: &EdgeId| {
            let h = mesh.edge_halfedge(edge);
            mesh.is_boundary_edge(edge)
                || !forest.unite(mesh.face(h).to_u32(), mesh.face(mesh.twin(h)).to_u32())
        };
        let edges: Vec<EdgeId> = (0..mesh.edge_count()).map(EdgeId::new).filter(is_cut).collect();
        let slice = mesh.slice_edges(&edges).unwrap();
        let disks = slice.surface();
        disks.check().unwrap();
        let isolated = disks.vertex_count()
            - disks.halfedges().filter(|&h| disks.vertex_halfedge(disks.source(h)) == Some(h)).count();
        let count = disks.component_count() - isolated;
        assert_eq!((disks.genus(), disks.outer_face_count()), (0, count), "{}", path.display());
        let pairs: Vec<(HalfedgeId, HalfedgeId)> =
            slice.left().iter().copied().zip(slice.right().iter().copied()).collect();
        assert_eq!(disks.glue(&pairs).unwrap().surface(), &mesh, "{}", path.display());
    }
}

#[test]
fn real_surfaces_are_decimated() {
    for (path, model) in models() {
        let Some(mut mesh) = repaired(&model) else { continue };
        for face in (0..mesh.face_count()).map(FaceId::new) {
            if mesh.face_halfedges(face).count() > 3 {
                mesh.poke_face(face).unwrap();
            }
        }
        mesh.check().unwrap();
        let expected = invariants(&mesh);
        let wanted = mesh.face_count() / 4;
        let (mut number, mut refused) = (0, 0);
        while mesh.face_count() > wanted && refused < 2 * mesh.edge_count() {
            // Edges in an order that jumps about.
            number = (number + 7919) % mesh.edge_count();
            refused = match mesh.collapse_edge_simplicially(EdgeId::new(number)) {
                Ok(_) => 0,
                Err(_) => refused + 1,
            };
        }
        for edge in (0..mesh.edge_count()).map(EdgeId::new).filter(|edge| edge.index() % 3 == 0) {
            // The boundary is refused.
            mesh.flip_edge(edge).ok();
        }
        mesh.check().unwrap();
        assert_eq!(invariants(&mesh), expected, "{}", path.display());
    }
}
