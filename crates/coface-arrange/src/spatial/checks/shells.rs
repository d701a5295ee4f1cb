//! The shells: whether each is a closed surface.

use super::edges::{Incidence, Use};
use super::faults::Collector;
use super::rings::Points;
use super::{CheckedFaces, CheckedPrimitive, FaultCode, FaultPlace, FaultScope};
use coface_algebra::Sign;

/// What is known of a shell.
#[derive(Clone, Debug)]
pub(super) struct Shell {
    pub(super) faces: Vec<u32>,
    /// Each edge lies in two faces, and each vertex has one fan.
    pub(super) is_manifold: bool,
    pub(super) is_closed: bool,
    pub(super) is_two_sided: bool,
    /// All of it could be examined, and each edge lies in an even number of faces: it has an inside by parity, pinched or not.
    pub(super) is_even: bool,
    /// All of it could be examined, and it bounds an inside: closed, manifold, two-sided, of four faces or more.
    pub(super) is_sound: bool,
}

/// All shells, and for each face its direction against that of the first face of its part.
pub(super) struct Shells {
    pub(super) shells: Vec<Shell>,
    pub(super) direction: Vec<Sign>,
}

/// Places on edges and vertices are listed by vertices of the file.
fn edge_place(faces: &CheckedFaces, own: &[Use]) -> FaultPlace {
    let items = faces.rings().items();
    let ends = [own[0].corner, own[0].next].map(|corner| items[corner as usize]);
    FaultPlace {
        faces: own.iter().map(|side| side.face).collect(),
        vertices: ends.to_vec(),
        ..FaultPlace::default()
    }
}

impl Shells {
    /// Examines edges and vertices.
    pub(super) fn examine(
        points: &Points<'_>,
        faces: &CheckedFaces,
        incidence: &Incidence,
        is_left_out: &[bool],
        faults: &mut Collector,
    ) -> Self {
        let is_given = faces.shell_of_face().is_some();
        let (direction, is_two_sided) = incidence.directions(faces.face_count());
        let mut shells: Vec<Shell> = is_two_sided
            .into_iter()
            .map(|is_two_sided| Shell {
                faces: Vec::new(),
                is_manifold: true,
                is_closed: true,
                is_two_sided,
                is_even: true,
                is_sound: true,
            })
            .collect();
        for (face, &shell) in incidence.shell_of_face.iter().enumerate() {
            if shell != u32::MAX {
                let shell = &mut shells[shell as usize];
                shell.faces.push(face as u32);
                shell.is_sound &= !is_left_out[face];
                shell.is_even &= !is_left_out[face];
            }
        }
        let shell_of = |face: u32| incidence.shell_of_face[face as usize] as usize;
        for own in incidence.edges() {
            let shell = &mut shells[shell_of(own[0].face)];
            shell.is_closed &= own.len() > 1;
            shell.is_manifold &= own.len() < 3;
            shell.is_even &= own.len().is_multiple_of(2);
        }
        let mut is_small = vec![false; shells.len()];
        for (number, shell) in shells.iter().enumerate() {
            let is_whole = is_given || incidence.shell_count == 1 || shell.is_closed;
            if is_whole && shell.faces.len() < 4 && faces.primitive_of_shell(number).is_solid() {
                is_small[number] = true;
                let place = FaultPlace {
                    faces: shell.faces.clone(),
                    shells: vec![number as u32],
                    ..FaultPlace::default()
                };
                faults.add(FaultCode::TooFewFaces, FaultScope::Solid, place);
            }
        }
        let scope = if is_given || !incidence.is_joined { FaultScope::Surface } else { FaultScope::Solid };
        let primitive_of = |face: u32| faces.primitive_of_shell(shell_of(face));
        for own in incidence.edges() {
            let (code, scope) = match own.len() {
                _ if primitive_of(own[0].face) == CheckedPrimitive::MultiSurface => continue,
                1 if !primitive_of(own[0].face).is_solid() => continue,
                1 => (FaultCode::ShellNotClosed, FaultScope::Solid),
                2 => continue,
                _ => (FaultCode::NonManifoldEdge, scope),
            };
            if code == FaultCode::NonManifoldEdge || !is_small[shell_of(own[0].face)] {
                faults.add_with(code, scope, || edge_place(faces, own));
            }
        }
        for [_, corner] in incidence.pinched_nodes(faces) {
            let vertex = faces.rings().items()[corner as usize];
            let face = incidence.face_of_corner[corner as usize];
            if primitive_of(face) == CheckedPrimitive::MultiSurface {
                continue;
            }
            shells[shell_of(face)].is_manifold = false;
            faults.add_with(FaultCode::NonManifoldVertex, scope, || FaultPlace {
                vertices: vec![vertex],
                point: Some(points.point(vertex)),
                ..FaultPlace::default()
            });
        }
        if !is_given {
            Self::split_pinches(points, faces, incidence, &shells, faults);
        }
        for (number, shell) in shells.iter_mut().enumerate() {
            shell.is_sound &= faces.primitive_of_shell(number).is_solid();
            shell.is_sound &=
                shell.is_closed && shell.is_manifold && shell.is_two_sided && shell.faces.len() >= 4;
        }
        Self { shells, direction }
    }

    /// Vertices and edges at which a closed shell touches itself with vertices of different numbers.
    fn split_pinches(
        points: &Points<'_>,
        faces: &CheckedFaces,
        incidence: &Incidence,
        shells: &[Shell],
        faults: &mut Collector,
    ) {
        let items = faces.rings().items();
        let is_double = |vertex: u32| points.place[vertex as usize] != vertex;
        if !items.iter().any(|&vertex| is_double(vertex)) {
            return;
        }
        let mut edges: Vec<([u32; 2], u32, [u32; 2])> = Vec::new();
        let mut vertices: Vec<(u32, u32, u32)> = Vec::new();
        for own in incidence.edges() {
            let shell = incidence.shell_of_face[own[0].face as usize];
            if !shells[shell as usize].is_closed {
                continue;
            }
            let ends = [own[0].corner, own[0].next].map(|corner| items[corner as usize]);
            let [a, b] = ends.map(|vertex| points.place[vertex as usize]);
            edges.push(([a.min(b), a.max(b)], shell, own[0].ends));
            for (vertex, node) in ends
                .into_iter()
                .zip([own[0].corner, own[0].next].map(|c| incidence.node_of_corner[c as usize]))
            {
                vertices.push((points.place[vertex as usize], shell, node));
            }
        }
        edges.sort_unstable();
        edges.dedup();
        let mut explained = Vec::new();
        for own in edges.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).filter(|own| own.len() > 1) {
            explained.extend(own[0].0);
            faults.add_with(FaultCode::NonManifoldEdge, FaultScope::Solid, || FaultPlace {
                vertices: own[0].0.to_vec(),
                ..FaultPlace::default()
            });
        }
        explained.sort_unstable();
        vertices.sort_unstable();
        vertices.dedup();
        for own in vertices.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).filter(|own| own.len() > 1) {
            if explained.binary_search(&own[0].0).is_err() {
                faults.add_with(FaultCode::NonManifoldVertex, FaultScope::Solid, || FaultPlace {
                    vertices: vec![own[0].0],
                    point: Some(points.point(own[0].0)),
                    ..FaultPlace::default()
                });
            }
        }
    }
}
