//! The codes of faults.

use std::fmt;

/// What a fault refutes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FaultScope {
    /// The faces are no surface in space that meets itself nowhere: they cross, overlap, or contradict each other.
    Surface,
    /// The surface may be sound, but it does not bound one solid.
    Solid,
}

impl FaultScope {
    /// The word for programs: `surface` or `solid`.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_arrange::spatial::checks::FaultScope::Solid.word(), "solid");
    /// ```
    pub const fn word(self) -> &'static str {
        match self {
            Self::Surface => "surface",
            Self::Solid => "solid",
        }
    }
}

/// What is wrong with faces in space. Several codes can have one number of ISO 19107: they tell apart what the
/// standard has in one class.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum FaultCode {
    /// 101: a ring has fewer than three different points.
    TooFewPoints,
    /// 102: two consecutive points of a ring are at one place.
    RepeatedPoints,
    /// 104: the sides of a ring cross each other.
    RingCrosses,
    /// 104: a ring runs through a point twice, or back along itself, without crossing itself.
    RingTouches,
    /// 104: all points of a ring are on one line.
    RingWithoutArea,
    /// 201: two rings of a face cross, overlap, or share a part of a side.
    RingsIntersect,
    /// 202: two rings of a face are the same.
    DuplicateRings,
    /// 203: a point of a face is farther from the plane of the face than the tolerance.
    NotFlat,
    /// 204: a face has a fold: a part of it is turned against the rest, although its points are near the plane.
    Folded,
    /// 205: the holes of a face cut its inside into pieces.
    FaceDisconnected,
    /// 206: a hole lies outside of the outer ring.
    HoleOutside,
    /// 207: a hole lies in another hole.
    HolesNested,
    /// 208: a hole runs around in the same direction as the outer ring.
    HoleOrientation,
    /// 301: a shell has fewer than four faces.
    TooFewFaces,
    /// 302: an edge belongs to one face only.
    ShellNotClosed,
    /// 302: a vertex lies inside an edge of one face, which has no vertex there.
    VertexInsideEdge,
    /// 303: the faces at a vertex form several fans.
    NonManifoldVertex,
    /// 304: an edge belongs to three or more faces.
    NonManifoldEdge,
    /// 305: a shell, or the outside of a solid, has several pieces.
    SeveralPieces,
    /// 306: faces of one shell cross.
    FacesCross,
    /// 306: faces of one shell overlap and look the same way, or are the same.
    FacesOverlap,
    /// 306: faces of one shell overlap and look opposite ways: there is no thickness between them.
    ZeroThickness,
    /// 306: faces of one shell touch where they have no vertex or edge in common.
    FacesTouch,
    /// 307: a face runs against its neighbors, or the surface has one side only.
    FaceOrientation,
    /// 401: shells cross, overlap, or share a part of a face.
    ShellsIntersect,
    /// 402: two shells are the same.
    DuplicateShells,
    /// 403: an inner shell lies outside of the outer shell.
    InnerShellOutside,
    /// 404: the inner shells cut the inside of the solid into pieces.
    SolidDisconnected,
    /// 405: the faces of a shell look the wrong way: an outer shell inwards, or the shell of a void away from the void.
    ShellOrientation,
    /// 501: two solids of a composite have a part of their insides in common.
    SolidsOverlap,
    /// 502: two solids of a composite are the same.
    DuplicateSolids,
    /// 503: the solids of a composite are not connected through faces.
    SolidsDisconnected,
}

impl FaultCode {
    /// All codes, in the order of their numbers.
    pub const ALL: [Self; 32] = [
        Self::TooFewPoints,
        Self::RepeatedPoints,
        Self::RingCrosses,
        Self::RingTouches,
        Self::RingWithoutArea,
        Self::RingsIntersect,
        Self::DuplicateRings,
        Self::NotFlat,
        Self::Folded,
        Self::FaceDisconnected,
        Self::HoleOutside,
        Self::HolesNested,
        Self::HoleOrientation,
        Self::TooFewFaces,
        Self::ShellNotClosed,
        Self::VertexInsideEdge,
        Self::NonManifoldVertex,
        Self::NonManifoldEdge,
        Self::SeveralPieces,
        Self::FacesCross,
        Self::FacesOverlap,
        Self::ZeroThickness,
        Self::FacesTouch,
        Self::FaceOrientation,
        Self::ShellsIntersect,
        Self::DuplicateShells,
        Self::InnerShellOutside,
        Self::SolidDisconnected,
        Self::ShellOrientation,
        Self::SolidsOverlap,
        Self::DuplicateSolids,
        Self::SolidsDisconnected,
    ];

    /// The number of ISO 19107 (of its validators; 303 and 304 are one number, 303, in some of them).
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::checks::FaultCode;
    /// assert_eq!(FaultCode::FacesCross.number(), 306);
    /// assert!(FaultCode::ALL.is_sorted_by_key(|code| code.number()));
    /// ```
    pub const fn number(self) -> u16 {
        match self {
            Self::TooFewPoints => 101,
            Self::RepeatedPoints => 102,
            Self::RingCrosses | Self::RingTouches | Self::RingWithoutArea => 104,
            Self::RingsIntersect => 201,
            Self::DuplicateRings => 202,
            Self::NotFlat => 203,
            Self::Folded => 204,
            Self::FaceDisconnected => 205,
            Self::HoleOutside => 206,
            Self::HolesNested => 207,
            Self::HoleOrientation => 208,
            Self::TooFewFaces => 301,
            Self::ShellNotClosed | Self::VertexInsideEdge => 302,
            Self::NonManifoldVertex => 303,
            Self::NonManifoldEdge => 304,
            Self::SeveralPieces => 305,
            Self::FacesCross | Self::FacesOverlap | Self::ZeroThickness | Self::FacesTouch => 306,
            Self::FaceOrientation => 307,
            Self::ShellsIntersect => 401,
            Self::DuplicateShells => 402,
            Self::InnerShellOutside => 403,
            Self::SolidDisconnected => 404,
            Self::ShellOrientation => 405,
            Self::SolidsOverlap => 501,
            Self::DuplicateSolids => 502,
            Self::SolidsDisconnected => 503,
        }
    }

    /// The word for programs: `faces_cross`.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::checks::FaultCode;
    /// assert_eq!(FaultCode::ShellNotClosed.name(), "shell_not_closed");
    /// ```
    pub const fn name(self) -> &'static str {
        match self {
            Self::TooFewPoints => "too_few_points",
            Self::RepeatedPoints => "repeated_points",
            Self::RingCrosses => "ring_crosses",
            Self::RingTouches => "ring_touches",
            Self::RingWithoutArea => "ring_without_area",
            Self::RingsIntersect => "rings_intersect",
            Self::DuplicateRings => "duplicate_rings",
            Self::NotFlat => "not_flat",
            Self::Folded => "folded",
            Self::FaceDisconnected => "face_disconnected",
            Self::HoleOutside => "hole_outside",
            Self::HolesNested => "holes_nested",
            Self::HoleOrientation => "hole_orientation",
            Self::TooFewFaces => "too_few_faces",
            Self::ShellNotClosed => "shell_not_closed",
            Self::VertexInsideEdge => "vertex_inside_edge",
            Self::NonManifoldVertex => "nonmanifold_vertex",
            Self::NonManifoldEdge => "nonmanifold_edge",
            Self::SeveralPieces => "several_pieces",
            Self::FacesCross => "faces_cross",
            Self::FacesOverlap => "faces_overlap",
            Self::ZeroThickness => "zero_thickness",
            Self::FacesTouch => "faces_touch",
            Self::FaceOrientation => "face_orientation",
            Self::ShellsIntersect => "shells_intersect",
            Self::DuplicateShells => "duplicate_shells",
            Self::InnerShellOutside => "inner_shell_outside",
            Self::SolidDisconnected => "solid_disconnected",
            Self::ShellOrientation => "shell_orientation",
            Self::SolidsOverlap => "solids_overlap",
            Self::DuplicateSolids => "duplicate_solids",
            Self::SolidsDisconnected => "solids_disconnected",
        }
    }

    /// One sentence about this many places.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::checks::FaultCode;
    /// assert_eq!(FaultCode::FacesCross.sentence(1), "1 pair of faces crosses");
    /// assert_eq!(FaultCode::FacesCross.sentence(7), "7 pairs of faces cross");
    /// ```
    pub fn sentence(self, count: usize) -> String {
        let (one, many) = match self {
            Self::TooFewPoints => {
                ("face has fewer than three different points", "faces have fewer than three different points")
            }
            Self::RepeatedPoints => {
                ("face has consecutive points at one place", "faces have consecutive points at one place")
            }
            Self::RingCrosses => {
                ("face has a ring that crosses itself", "faces have rings that cross themselves")
            }
            Self::RingTouches => {
                ("face has a ring that touches itself", "faces have rings that touch themselves")
            }
            Self::RingWithoutArea => ("face has no area: its points are on one line", "faces have no area"),
            Self::RingsIntersect => ("face has rings that intersect", "faces have rings that intersect"),
            Self::DuplicateRings => ("face has a ring twice", "faces have a ring twice"),
            Self::NotFlat => ("face is not flat", "faces are not flat"),
            Self::Folded => ("face has a fold", "faces have folds"),
            Self::FaceDisconnected => {
                ("face is cut into pieces by its holes", "faces are cut into pieces by their holes")
            }
            Self::HoleOutside => ("face has a hole outside of it", "faces have holes outside of them"),
            Self::HolesNested => ("face has a hole in a hole", "faces have holes in holes"),
            Self::HoleOrientation => (
                "face has a hole that runs the same way as its outer ring",
                "faces have holes that run the same way as their outer rings",
            ),
            Self::TooFewFaces => {
                ("shell has too few faces to bound a solid", "shells have too few faces to bound a solid")
            }
            Self::ShellNotClosed => {
                ("edge belongs to one face only: not closed", "edges belong to one face only: not closed")
            }
            Self::VertexInsideEdge => (
                "vertex lies inside an edge of a face that has no vertex there",
                "vertices lie inside edges of faces that have no vertex there",
            ),
            Self::NonManifoldVertex => {
                ("vertex has several fans of faces", "vertices have several fans of faces")
            }
            Self::NonManifoldEdge => {
                ("edge belongs to three or more faces", "edges belong to three or more faces")
            }
            Self::SeveralPieces => ("further piece beside the first", "further pieces beside the first"),
            Self::FacesCross => ("pair of faces crosses", "pairs of faces cross"),
            Self::FacesOverlap => ("pair of faces overlaps", "pairs of faces overlap"),
            Self::ZeroThickness => (
                "pair of faces has no thickness between them",
                "pairs of faces have no thickness between them",
            ),
            Self::FacesTouch => (
                "pair of faces touches without a common vertex or edge",
                "pairs of faces touch without a common vertex or edge",
            ),
            Self::FaceOrientation => ("face runs against its neighbors", "faces run against their neighbors"),
            Self::ShellsIntersect => ("pair of shells intersects", "pairs of shells intersect"),
            Self::DuplicateShells => {
                ("pair of shells is the same shell twice", "pairs of shells are the same")
            }
            Self::InnerShellOutside => {
                ("inner shell lies outside of the outer shell", "inner shells lie outside of the outer shell")
            }
            Self::SolidDisconnected => (
                "solid is cut into pieces by its inner shells",
                "solids are cut into pieces by their inner shells",
            ),
            Self::ShellOrientation => ("shell looks the wrong way", "shells look the wrong way"),
            Self::SolidsOverlap => {
                ("pair of solids of a composite overlaps", "pairs of solids of a composite overlap")
            }
            Self::DuplicateSolids => (
                "pair of solids of a composite is the same solid twice",
                "pairs of solids of a composite are the same",
            ),
            Self::SolidsDisconnected => (
                "solid of a composite has no face in common with the first ones",
                "solids of a composite have no face in common with the first ones",
            ),
        };
        format!("{count} {}", if count == 1 { one } else { many })
    }
}

impl fmt::Display for FaultCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.number(), self.name())
    }
}
