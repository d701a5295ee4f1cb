//! The check of all faces, shells and solids.

use super::divided_edges::vertices_inside_edges;
use super::edges::Incidence;
use super::faults::Collector;
use super::meetings::{Interest, MeetingFaces, meeting_faces};
use super::rings::{FoundFaces, Points, Triangles};
use super::shells::Shells;
use super::solids::Solids;
use super::triangle_pairs::{Meeting, TrianglePairs};
use super::{CheckedFaces, CheckedPrimitive, FaultCode, FaultPlace, FaultScope, GeometryFaults};
use crate::spatial::GivenPoints;
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind, RaggedArray};
use coface_geometry::Positions;
use rayon::prelude::*;

/// How many faces are examined in one piece of work.
const FACES_AT_ONCE: usize = 2048;

/// Options of a check.
///
/// # Examples
/// Two squares that cross in a cross:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::spatial::checks::{CheckedFaces, FaultCode, GeometryChecks};
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let corners = vec![
///     -1., 0., -1., 1., 0., -1., 1., 0., 1., -1., 0., 1.,
///     0., -1., -1., 0., 1., -1., 0., 1., 1., 0., -1., 1.,
/// ];
/// let squares = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]));
/// let found = GeometryChecks::new().check(&Positions::from_flat(3, corners)?, &squares)?;
/// let crossing = found.faults().iter().find(|fault| fault.code() == FaultCode::FacesCross).expect("they cross");
/// assert_eq!((crossing.count(), &crossing.places()[0].faces[..]), (1, &[0, 1][..]));
/// assert!(!found.is_sound_surface());
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeometryChecks {
    places: usize,
    flatness: Option<f64>,
}

impl Default for GeometryChecks {
    fn default() -> Self {
        Self { places: 100, flatness: None }
    }
}

impl GeometryChecks {
    /// Lists up to 100 places of each fault; a face is flat when its points are within a hundredth of its diameter
    /// from a plane.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::checks::GeometryChecks;
    /// assert_eq!(GeometryChecks::new(), GeometryChecks::default());
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Lists up to this many places of each fault; all are counted.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::checks::GeometryChecks;
    /// assert_ne!(GeometryChecks::new().places(3), GeometryChecks::new());
    /// ```
    #[must_use]
    pub fn places(mut self, most: usize) -> Self {
        self.places = most;
        self
    }

    /// A face is flat when its points are within this distance from a plane, in the unit of the coordinates.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::checks::GeometryChecks;
    /// assert_ne!(GeometryChecks::new().flatness(0.01), GeometryChecks::new());
    /// ```
    #[must_use]
    pub fn flatness(mut self, tolerance: f64) -> Self {
        self.flatness = Some(tolerance);
        self
    }

    /// Checks faces by the positions of their vertices.
    ///
    /// A check goes on where it can: faces whose rings are at fault are left out of what depends on them. Faces that
    /// only touch, and shells that do, are looked for where shells are closed.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the positions have three coordinates; [`ErrorKind::InvalidInput`] naming the first
    /// vertex without a position.
    ///
    /// # Complexity
    /// $O(n \log n + k)$ for n corners of faces and k pairs of triangles whose boxes meet; shells that touch are
    /// arranged, and a ray from each shell meets all boxes above it.
    ///
    /// # Examples
    /// A flat box: its top lies on its bottom.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::checks::{CheckedFaces, FaultCode, GeometryChecks};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.])?;
    /// let both = CheckedFaces::from_polygons(RaggedArray::from_lists([[0, 1, 2, 3], [3, 2, 1, 0]]));
    /// let found = GeometryChecks::new().check(&corners, &both)?;
    /// let codes: Vec<FaultCode> = found.faults().iter().map(|fault| fault.code()).collect();
    /// assert_eq!(codes, [FaultCode::TooFewFaces, FaultCode::ZeroThickness]);
    /// # Ok(()) }
    /// ```
    pub fn check(&self, positions: &Positions, faces: &CheckedFaces) -> Result<GeometryFaults, Error> {
        let predicates = GivenPoints::new(positions)?;
        if let Some(&vertex) =
            faces.rings().items().iter().find(|&&vertex| vertex as usize >= positions.len())
        {
            return Err(Error::new(
                ErrorKind::InvalidInput,
                format!("vertex v{vertex} of a ring has no position"),
            )
            .with_cure("give a position for each vertex"));
        }
        let points = Points {
            predicates,
            coordinates: positions.as_flat(),
            place: places(positions.as_flat()),
            flatness: self.flatness,
        };
        let mut faults = Collector::new(self.places);
        let running = stage("checking faces", faces.face_count());
        let found = found_faces(&points, faces)?;
        found.faults.into_iter().for_each(|(code, scope, place)| faults.add(code, scope, place));
        let triangles = found.triangles;
        let mut is_left_out = vec![true; faces.face_count()];
        triangles.face.iter().for_each(|&face| is_left_out[face as usize] = false);
        let incidence = Incidence::new(&points, faces, &found.without_ring);
        let mut shells = Shells::examine(&points, faces, &incidence, &is_left_out, &mut faults);
        vertices_inside_edges(&points, faces, &incidence, &mut faults);
        drop(running);
        let running = stage("looking for faces that meet", triangles.corners.len());
        let (meetings, is_complete) = {
            let solid_of_shell = faces.solid_of_shell();
            let is_whole: Vec<bool> =
                shells.shells.iter().map(|shell| shell.is_closed && shell.is_manifold).collect();
            let shell_of_face = &incidence.shell_of_face;
            meeting_faces(&points, &triangles, |face, other| {
                let [a, b] = [face, other].map(|face| shell_of_face[face as usize] as usize);
                let solid = |shell: usize| solid_of_shell.get(shell).copied();
                if solid(a) != solid(b) || faces.primitive_of_shell(a) == CheckedPrimitive::MultiSurface {
                    Interest::Nothing
                } else if !is_whole[a] || !is_whole[b] {
                    Interest::Crossings
                } else if a == b {
                    Interest::Touches
                } else {
                    Interest::Contacts
                }
            })
        };
        let shell = |face: u32| incidence.shell_of_face[face as usize] as usize;
        let (own, between): (Vec<MeetingFaces>, Vec<MeetingFaces>) =
            meetings.into_iter().partition(|pair| shell(pair.faces[0]) == shell(pair.faces[1]));
        let pairs = TrianglePairs::new(&points, &triangles);
        for pair in own {
            let code = match pair.meeting {
                Meeting::Cross => FaultCode::FacesCross,
                Meeting::Overlap => FaultCode::FacesOverlap,
                Meeting::OverlapReversed => FaultCode::ZeroThickness,
                Meeting::Touch => FaultCode::FacesTouch,
            };
            let scope = if pair.meeting == Meeting::Touch { FaultScope::Solid } else { FaultScope::Surface };
            if pair.meeting != Meeting::Touch {
                shells.shells[shell(pair.faces[0])].is_sound = false;
            }
            let [t, u] = pair.triangles.map(|triangle| triangle as usize);
            faults.add_with(code, scope, || FaultPlace {
                faces: pair.faces.to_vec(),
                point: Some(pairs.point_of(t, u)),
                ..FaultPlace::default()
            });
        }
        drop(running);
        self.contradictions(faces, &incidence, &shells, &mut faults);
        let shell_of_triangle = triangles.face.iter().map(|&face| incidence.shell_of_face[face as usize]);
        let triangles_of_shell = RaggedArray::grouped(incidence.shell_count, shell_of_triangle);
        let solids = Solids {
            points: &points,
            faces,
            triangles: &triangles,
            shell_of_face: &incidence.shell_of_face,
            pieces_of_shell: &incidence.pieces_of_shell,
            shells: &shells,
            meetings: &between,
            triangles_of_shell: &triangles_of_shell,
        };
        let shells_left_out = solids.examine(&mut faults);
        if !is_complete {
            use FaultCode::{FacesCross, FacesOverlap, FacesTouch, ShellsIntersect, ZeroThickness};
            faults.mark_incomplete(&[FacesCross, FacesOverlap, ZeroThickness, FacesTouch, ShellsIntersect]);
        }
        Ok(GeometryFaults {
            faults: faults.into_faults(),
            faces_left_out: found.left_out,
            shells_left_out,
            shell_count: (0..incidence.shell_count)
                .filter(|&shell| faces.primitive_of_shell(shell).is_solid())
                .count(),
        })
    }

    /// Faces that run against their neighbors, in shells that have no outside to say which of them are wrong: those
    /// that run against the larger part.
    fn contradictions(
        &self,
        faces: &CheckedFaces,
        incidence: &Incidence,
        shells: &Shells,
        faults: &mut Collector,
    ) {
        let mut is_against = vec![false; incidence.shell_count];
        for own in incidence.edges() {
            if let [a, b] = own
                && a.face != b.face
                && incidence.runs_up(a) == incidence.runs_up(b)
            {
                is_against[incidence.shell_of_face[a.face as usize] as usize] = true;
            }
        }
        for (number, shell) in shells.shells.iter().enumerate() {
            let is_checked = faces.primitive_of_shell(number) != CheckedPrimitive::MultiSurface;
            if !is_against[number] || shell.is_sound || !is_checked {
                continue;
            }
            let direction = |face: &u32| shells.direction[*face as usize];
            let (one, other): (Vec<u32>, Vec<u32>) =
                shell.faces.iter().partition(|face| direction(face) == coface_algebra::Sign::Plus);
            let wrong = if other.len() <= one.len() { other } else { one };
            debug_assert!(faces.face_count() > 0);
            let wrong = if wrong.is_empty() { shell.faces[..1].to_vec() } else { wrong };
            for face in wrong {
                faults.add_with(FaultCode::FaceOrientation, FaultScope::Surface, || FaultPlace {
                    faces: vec![face],
                    ..FaultPlace::default()
                });
            }
        }
    }
}

/// The lowest vertex with the same coordinates, for each vertex.
fn places(coordinates: &[f64]) -> Vec<u32> {
    let count = coordinates.len() / 3;
    // Zeros of both signs are one number.
    let bits = |vertex: u32| {
        let start = 3 * vertex as usize;
        [0, 1, 2].map(|axis| (coordinates[start + axis] + 0.0).to_bits())
    };
    let mut order: Vec<([u64; 3], u32)> =
        (0..count as u32).into_par_iter().map(|vertex| (bits(vertex), vertex)).collect();
    order.par_sort_unstable();
    let mut place: Vec<u32> = (0..count as u32).collect();
    for same in order.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() > 1) {
        same.iter().for_each(|&(_, vertex)| place[vertex as usize] = same[0].1);
    }
    place
}

/// What is found about each face by itself, and the triangles of all.
fn found_faces(points: &Points<'_>, faces: &CheckedFaces) -> Result<FoundFaces, Error> {
    let count = faces.face_count();
    let pieces: Vec<Result<FoundFaces, Error>> = (0..count.div_ceil(FACES_AT_ONCE))
        .into_par_iter()
        .map(|piece| {
            let mut found = FoundFaces::default();
            for face in piece * FACES_AT_ONCE..count.min((piece + 1) * FACES_AT_ONCE) {
                found.examine(points, faces, face)?;
            }
            Ok(found)
        })
        .collect();
    let mut whole = FoundFaces { triangles: Triangles::default(), ..FoundFaces::default() };
    for piece in pieces {
        let mut piece = piece?;
        whole.faults.append(&mut piece.faults);
        whole.triangles.append(&mut piece.triangles);
        whole.left_out += piece.left_out;
        whole.without_ring.append(&mut piece.without_ring);
    }
    Ok(whole)
}
