//! Connected sums of oriented manifolds.

use crate::simplicial::SimplicialComplex;
use coface_algebra::Sign;
use coface_algebra::{Error, VertexId};

/// The connected sum of two closed connected manifolds that keeps orientations: each is oriented so that its lowest facet,
/// in the rising order of its vertices, is positive, the second one opposite to that for [`Sign::Minus`]. These facets are
/// taken out. Vertices of the first keep their numbers.
///
/// If one of the two is not orientable, the sign does not matter.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] if a complex is empty, of dimension 0 or the dimensions differ;
/// [`coface_algebra::ErrorKind::TooLarge`] if vertex numbers run out.
///
/// # Examples
/// ```
/// use coface_algebra::Sign;
/// use coface_complexes::known_spaces::{complex_projective_plane, oriented_sum};
/// let plane = complex_projective_plane()?;
/// let sum = oriented_sum(&plane, &plane, Sign::Minus)?;
/// assert_eq!(sum.f_vector(), [13, 62, 158, 175, 70]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn oriented_sum(
    first: &SimplicialComplex,
    second: &SimplicialComplex,
    orientation: Sign,
) -> Result<SimplicialComplex, Error> {
    let lowest = |complex: &SimplicialComplex| -> Result<Vec<VertexId>, Error> {
        let top =
            complex.dimension().ok_or_else(|| Error::invalid("the empty complex has no connected sum"))?;
        let facet = complex.simplices(top).next().expect("a complex has a simplex of its dimension");
        Ok(facet.vertices().collect())
    };
    let (facet, mut other) = (lowest(first)?, lowest(second)?);
    // What is left of a manifold induces on the rim the opposite of what the facet does. The rims of both must cancel, so
    // the facets must be glued by a map that reverses orientation.
    if orientation == Sign::Plus && other.len() > 1 {
        other.swap(0, 1);
    }
    Ok(first.connected_sum(&facet, second, &other)?.into_complex())
}
