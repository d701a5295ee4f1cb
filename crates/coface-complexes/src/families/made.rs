//! What a family makes.

use crate::shapes::PlacedCells;
use crate::simplicial::{SimplexSet, SimplicialComplex};
use coface_algebra::Error;

/// What a family makes.
#[derive(Clone, Debug)]
pub enum FamilyModel {
    /// Cells with positions.
    Cells(PlacedCells),
    /// A complex without positions.
    Complex(SimplicialComplex),
}

impl FamilyModel {
    /// The facets of exactly one cell; `None` if there are none, as every facet lies in two cells.
    ///
    /// # Errors
    /// Those of [`PlacedCells::boundary`] and [`SimplexSet::boundary_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::{Family, FamilyModel};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let make = |name| Family::named(name).expect("there is such a family").make(&[]);
    /// assert!(matches!(make("ball")?.boundary()?, Some(FamilyModel::Cells(_))));
    /// assert!(make("sphere")?.boundary()?.is_none());
    /// # Ok(()) }
    /// ```
    pub fn boundary(self) -> Result<Option<Self>, Error> {
        Ok(match self {
            Self::Cells(cells) => {
                let boundary = cells.boundary()?.compacted();
                (boundary.cell_count() > 0).then_some(Self::Cells(boundary))
            }
            Self::Complex(complex) => {
                let boundary = SimplexSet::from(&complex).boundary_complex()?;
                (!boundary.is_empty()).then_some(Self::Complex(boundary))
            }
        })
    }

    /// The cells of this dimension.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) above the dimension of a complex, and the errors of
    /// [`PlacedCells::skeleton`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::families::{Family, FamilyModel};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = Family::named("rp2").expect("there is a projective plane").make(&[])?;
    /// let FamilyModel::Complex(edges) = plane.skeleton(1)? else { panic!("it has no positions") };
    /// assert_eq!(edges.f_vector(), [6, 15]);
    /// # Ok(()) }
    /// ```
    pub fn skeleton(self, dimension: usize) -> Result<Self, Error> {
        match self {
            Self::Cells(cells) => Ok(Self::Cells(cells.skeleton(dimension)?)),
            Self::Complex(complex) => {
                let top = complex.dimension().unwrap_or(0);
                if dimension > top {
                    let message = format!(
                        "there is no skeleton of dimension {dimension}; the complex has dimension {top}"
                    );
                    return Err(Error::invalid(message));
                }
                Ok(Self::Complex(complex.skeleton(dimension)?))
            }
        }
    }
}
