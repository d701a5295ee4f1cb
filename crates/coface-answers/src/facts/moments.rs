//! Integrals of monomials over what a model encloses.

use coface_algebra::RaggedArray;
use coface_algebra::{Error, FaceId};
use coface_complexes::cell_mesh::CellMesh;
use coface_geometry::{MassProperties, Positions, enclosed_moment, surface_centroid, surface_moment};

/// The largest sum of exponents: beyond it numbers leave the range of floating point.
const LARGEST_DEGREE: u32 = 100;

/// The integrals of a monomial $x^a y^b z^c$ over a model.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Moment {
    pub(crate) exponents: [u32; 3],
    pub(crate) volume: Option<f64>,
    pub(crate) surface: Option<f64>,
}

impl Moment {
    /// The exponents a, b, c.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A tetrahedron of volume 1 with its corner at the origin.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let report = coface_answers::Report::with_moments(solid, &[[0, 0, 0]])?;
    /// assert_eq!(report.moments()[0].exponents(), [0, 0, 0]);
    /// # Ok(()) }
    /// ```
    pub fn exponents(&self) -> [u32; 3] {
        self.exponents
    }

    /// The integral over the solid that a closed, coherently oriented surface encloses, or over the cells of a volume mesh
    /// with the signs of their volumes; `None` without a solid in space.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A tetrahedron of volume 1 with its corner at the origin.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let report = coface_answers::Report::with_moments(solid, &[[0, 0, 0]])?;
    /// assert_eq!(report.moments()[0].volume(), Some(1.0));
    /// # Ok(()) }
    /// ```
    pub fn volume(&self) -> Option<f64> {
        self.volume
    }

    /// The integral over the faces of a surface, or over the boundary of a volume mesh, with respect to area; `None` without a
    /// surface in space.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A tetrahedron of volume 1 with its corner at the origin.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let report = coface_answers::Report::with_moments(solid, &[[0, 0, 0]])?;
    /// assert_eq!(report.moments()[0].surface(), report.area());
    /// # Ok(()) }
    /// ```
    pub fn surface(&self) -> Option<f64> {
        self.surface
    }
}

/// That the exponents are not too large.
pub(crate) fn check_exponents(exponents: &[[u32; 3]]) -> Result<(), Error> {
    for &[a, b, c] in exponents {
        let degree = u64::from(a) + u64::from(b) + u64::from(c);
        if degree > u64::from(LARGEST_DEGREE) {
            return Err(Error::invalid(format!(
                "the exponents {a}, {b}, {c} add up to {degree}; the limit is {LARGEST_DEGREE}"
            ))
            .with_cure("ask for moments of a lower degree"));
        }
    }
    Ok(())
}

/// What the integrals of a model are taken over.
pub(crate) struct Integrals<'a> {
    /// The surface.
    pub(crate) surface: Option<&'a RaggedArray>,
    /// The closed chain of polygons around the solid.
    pub(crate) around: Option<&'a RaggedArray>,
    pub(crate) positions: &'a Positions,
}

impl Integrals<'_> {
    pub(crate) fn surface_centroid(&self) -> Option<[f64; 3]> {
        surface_centroid(self.positions, self.surface?)
    }

    pub(crate) fn mass(&self) -> Option<MassProperties> {
        MassProperties::enclosed(self.positions, self.around?)
    }

    pub(crate) fn moments(&self, exponents: &[[u32; 3]]) -> Vec<Moment> {
        let moment = |&exponents: &[u32; 3]| Moment {
            exponents,
            volume: self.around.and_then(|around| enclosed_moment(self.positions, around, exponents)),
            surface: self.surface.and_then(|surface| surface_moment(self.positions, surface, exponents)),
        };
        exponents.iter().map(moment).collect()
    }
}

/// The boundary of the sum of all cells: each face as often as the cells have it in all, turned the way that they have it.
pub(crate) fn boundary_chain(mesh: &CellMesh) -> RaggedArray {
    let mut chain = RaggedArray::new();
    let mut turned = Vec::new();
    for face in (0..mesh.face_count()).map(FaceId::new) {
        let coefficient: i32 = mesh.cells_of_face(face).map(|(_, sign)| sign.to_i32()).sum();
        turned.clear();
        turned.extend_from_slice(mesh.skeleton().face(face));
        if coefficient < 0 {
            turned.reverse();
        }
        (0..coefficient.unsigned_abs()).for_each(|_| chain.push(&turned));
    }
    chain
}
