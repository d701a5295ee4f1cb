//! Whether the faces of a surface are sound in space.

use crate::answer::{Place, Remark, RemarkCode};
use crate::producer::Labels;
use coface_algebra::{Error, FaceId};
use coface_arrange::spatial::checks::{
    CheckedFaces, Fault, FaultCode, FaultPlace, FaultScope, GeometryChecks, GeometryFaults,
};
use coface_complexes::surface::PolygonMesh;
use coface_geometry::Positions;
use coface_io::StatedSurfaces;
use std::fmt;

/// Which surfaces have their geometry checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum GeometryCheck {
    /// Those of up to [`Self::USUAL_FACES`] faces.
    #[default]
    Usual,
    /// All.
    Always,
    /// None.
    Never,
}

impl GeometryCheck {
    /// Surfaces with more faces are checked only where that is asked for.
    pub const USUAL_FACES: usize = 200_000;
}

/// Why the geometry of a model is not checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum GeometryUnchecked {
    /// The surface has so many faces, and was to be checked only up to [`GeometryCheck::USUAL_FACES`].
    ManyFaces(usize),
    /// The check was not wanted.
    NotWanted,
    /// The points have so many coordinates.
    Coordinates(usize),
    /// Some coordinates are not finite.
    NotFinite,
    /// The model is a volume.
    Volume,
}

impl GeometryUnchecked {
    /// Whether asking for the check is enough to have it.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::GeometryUnchecked;
    /// assert!(GeometryUnchecked::ManyFaces(300_000).is_a_choice() && !GeometryUnchecked::Volume.is_a_choice());
    /// ```
    pub fn is_a_choice(self) -> bool {
        matches!(self, Self::ManyFaces(_) | Self::NotWanted)
    }
}

impl fmt::Display for GeometryUnchecked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ManyFaces(count) => {
                write!(f, "the surface has {count} faces, more than {}", GeometryCheck::USUAL_FACES)
            }
            Self::NotWanted => f.write_str("the check was not wanted"),
            Self::Coordinates(count) => write!(f, "the points have {count} coordinates, not 3"),
            Self::NotFinite => f.write_str("some coordinates are not finite"),
            Self::Volume => f.write_str("the model is a volume, and only surfaces are checked"),
        }
    }
}

/// What is known about the geometry of a model.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_answers::{GeometryFacts, Report};
/// let triangle = &b"OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"[..];
/// let report = Report::of(coface_io::read(triangle, coface_io::Format::Off)?)?;
/// let Some(GeometryFacts::Checked(found)) = report.geometry() else { panic!("a triangle has a place") };
/// assert!(found.is_sound_surface() && !found.is_valid_solid());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum GeometryFacts {
    /// The faces were checked; faces and vertices are those of the file.
    Checked(GeometryFaults),
    /// The faces were not checked, for this reason.
    Unchecked(GeometryUnchecked),
}

/// What a check is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub(crate) struct GeometryRequest {
    pub(crate) check: GeometryCheck,
    pub(crate) flatness: Option<f64>,
    pub(crate) places: usize,
}

impl GeometryFacts {
    /// Those of a mesh; `None` for one without positions.
    ///
    /// # Errors
    /// Those of a check.
    pub(crate) fn of(
        mesh: &PolygonMesh,
        positions: &Positions,
        labels: &Labels,
        request: &GeometryRequest,
        stated: Option<&StatedSurfaces>,
    ) -> Result<Option<Self>, Error> {
        if mesh.face_count() == 0 || positions.is_empty() {
            return Ok(None);
        }
        let count = mesh.face_count();
        let raised;
        let positions = match positions.dimension() {
            3 => positions,
            2 => {
                let flat =
                    positions.as_flat().chunks(2).flat_map(|point| [point[0], point[1], 0.0]).collect();
                raised = Positions::from_flat(3, flat)?;
                &raised
            }
            dimension => {
                return Ok(Some(Self::Unchecked(GeometryUnchecked::Coordinates(dimension))));
            }
        };
        match request.check {
            GeometryCheck::Never => return Ok(Some(Self::Unchecked(GeometryUnchecked::NotWanted))),
            GeometryCheck::Usual if count > GeometryCheck::USUAL_FACES => {
                return Ok(Some(Self::Unchecked(GeometryUnchecked::ManyFaces(count))));
            }
            _ => {}
        }
        let mut checks = GeometryChecks::new().places(request.places);
        if let Some(flatness) = request.flatness {
            checks = checks.flatness(flatness);
        }
        // Duplicates are surfaces of their own there.
        if let Some(stated) = stated.filter(|_| *labels == Labels::default()) {
            let found = checks.check(positions, stated.faces())?;
            let polygon = |face: u32| stated.polygon_of_face(face as usize);
            return Ok(Some(Self::Checked(found.renumbered(polygon, |vertex| vertex))));
        }
        let faces = CheckedFaces::from_polygons(mesh.polygons().clone());
        let mut found = checks.check(positions, &faces)?.renumbered(
            |face| mesh.polygon_of_face(FaceId::from_u32(face)) as u32,
            |vertex| labels.of(vertex),
        );
        let repeated = mesh.duplicate_faces();
        if !repeated.is_empty() {
            let place = |&(face, later): &(FaceId, usize)| {
                let mut place = FaultPlace::default();
                place.faces = vec![mesh.polygon_of_face(face) as u32, later as u32];
                place
            };
            let places = repeated.iter().take(request.places).map(place).collect();
            found = found.with_fault(FaultCode::FacesOverlap, FaultScope::Surface, repeated.len(), places);
        }
        Ok(Some(Self::Checked(found)))
    }

    /// The faults; none where the geometry was not checked.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GeometryFacts, GeometryUnchecked};
    /// assert!(GeometryFacts::Unchecked(GeometryUnchecked::Volume).faults().is_empty());
    /// ```
    pub fn faults(&self) -> &[Fault] {
        match self {
            Self::Checked(found) => found.faults(),
            Self::Unchecked(_) => &[],
        }
    }

    /// The same with what the reader of the file corrected: repeated corners, and faces with too few.
    pub(crate) fn with_corrections(self, remarks: &[Remark]) -> Self {
        let Self::Checked(mut found) = self else { return self };
        for remark in remarks {
            let code = match remark.code {
                RemarkCode::RepeatedVertex => FaultCode::RepeatedPoints,
                RemarkCode::CollapsedCell => FaultCode::TooFewPoints,
                _ => continue,
            };
            let place = |place: &Place| {
                let mut own = FaultPlace::default();
                own.vertices = place.cell.clone().unwrap_or_default();
                own
            };
            let places = remark.places.iter().filter(|place| place.cell.is_some()).map(place).collect();
            let count = usize::try_from(remark.count).unwrap_or(usize::MAX);
            found = found.with_fault(code, FaultScope::Surface, count.max(1), places);
        }
        Self::Checked(found)
    }

    /// A remark for each fault of the surface that the report does not state as a problem of its cells.
    pub(crate) fn remarks(&self) -> impl Iterator<Item = Remark> {
        self.faults().iter().filter(|fault| fault.scope() == FaultScope::Surface && !is_of_cells(fault)).map(
            |fault| {
                let places = fault.places().iter().map(|place| match place.point {
                    Some(point) => Place::point(&point),
                    None => Place::cell(&place.vertices),
                });
                Remark::new(RemarkCode::GeometryFault, sentence(fault)).at(fault.count(), places)
            },
        )
    }
}

/// Whether a fault is one of cells and not of their places, so that the report states it as a problem or a remark.
fn is_of_cells(fault: &Fault) -> bool {
    use FaultCode::{FaceOrientation, NonManifoldEdge, NonManifoldVertex};
    matches!(fault.code(), NonManifoldVertex | NonManifoldEdge | FaceOrientation)
}

/// What is wrong, with the code.
pub(crate) fn sentence(fault: &Fault) -> String {
    format!("{} (ISO 19107 code {})", fault.sentence(), fault.code().number())
}
