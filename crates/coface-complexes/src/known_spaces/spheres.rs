//! Spheres: boundaries of simplices and cross-polytopes, the circle, and two that are no boundaries of polytopes.

use super::{from_orbits, from_rule, require};
use crate::simplicial::SimplicialComplex;
use coface_algebra::Error;

/// The full simplex of this dimension, with all its faces: a ball.
///
/// # Errors
/// As [`SimplicialComplex::from_facets`] beyond the highest dimension a complex may have.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::simplex(2)?.f_vector(), [3, 3, 1]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn simplex(dimension: usize) -> Result<SimplicialComplex, Error> {
    from_rule([(0..=dimension as u32).collect()])
}

/// The sphere of this dimension as the boundary of the simplex one dimension higher: the fewest vertices possible.
///
/// # Errors
/// As [`SimplicialComplex::from_facets`] beyond the highest dimension a complex may have.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::simplex_boundary(2)?.f_vector(), [4, 6, 4]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn simplex_boundary(dimension: usize) -> Result<SimplicialComplex, Error> {
    let vertices = 0..dimension as u32 + 2;
    from_rule(vertices.clone().map(|left_out| vertices.clone().filter(|&v| v != left_out).collect()))
}

/// The sphere of this dimension as the boundary of the cross-polytope: vertices 2i and 2i + 1 are opposite, a facet
/// takes one of each pair. Dimension 2 is the octahedron.
///
/// # Errors
/// As [`SimplicialComplex::from_facets`] beyond the highest dimension a complex may have.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::cross_polytope_boundary(3)?.f_vector(), [8, 24, 32, 16]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn cross_polytope_boundary(dimension: usize) -> Result<SimplicialComplex, Error> {
    require(dimension < 24, || {
        format!("a cross-polytope of dimension {dimension} has too many facets; the limit is 23")
    })?;
    from_rule(
        (0..1u32 << (dimension + 1))
            .map(|choice| (0..=dimension as u32).map(|i| 2 * i + (choice >> i & 1)).collect()),
    )
}

/// The circle with this many vertices, each joined to the next.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] below 3 vertices.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::circle(5)?.f_vector(), [5, 5]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn circle(vertex_count: u32) -> Result<SimplicialComplex, Error> {
    require(vertex_count >= 3, || {
        format!("a circle of {vertex_count} vertices is not simplicial; it needs 3")
    })?;
    from_rule((0..vertex_count).map(|i| vec![i, (i + 1) % vertex_count]))
}

/// Barnette's sphere: a 3-sphere with 8 vertices and 19 facets that is the boundary of no convex polytope.
///
/// A prism over a triangle, 012 and 345, is filled with three tetrahedra around its axis, which turn its side diagonals;
/// the two sides are cones with the apexes 6 and 7. The facets are the images of nine under (0 1 2)(3 4 5).
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// D. W. Barnette, *Diagrams and Schlegel diagrams* (1970).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::barnette_sphere()?.f_vector(), [8, 27, 38, 19]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn barnette_sphere() -> Result<SimplicialComplex, Error> {
    let caps: [&[u32]; 2] = [&[0, 1, 2, 6], &[0, 1, 2, 7]];
    from_orbits(&[&BARNETTE_WITHOUT_CAPS[..], &caps].concat(), &[&TURN])
}

/// Brueckner's sphere: a 3-sphere with 8 vertices, all 28 edges and 20 facets that is the boundary of no convex polytope.
/// It is Barnette's sphere with its one missing edge put in: two tetrahedra with the triangle 012 become three around
/// the edge 67.
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// B. Gruenbaum, V. P. Sreedharan, *An enumeration of simplicial 4-polytopes with 8 vertices* (1967).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::bruckner_sphere()?.f_vector(), [8, 28, 40, 20]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn bruckner_sphere() -> Result<SimplicialComplex, Error> {
    let around_edge: [&[u32]; 1] = [&[0, 1, 6, 7]];
    from_orbits(&[&BARNETTE_WITHOUT_CAPS[..], &around_edge].concat(), &[&TURN])
}

/// The turn of Barnette's sphere.
const TURN: [u32; 8] = [1, 2, 0, 4, 5, 3, 6, 7];

/// Facets of Barnette's sphere, one of each orbit, but for the two with the triangle 012.
const BARNETTE_WITHOUT_CAPS: [&[u32]; 7] =
    [&[0, 1, 3, 4], &[0, 1, 3, 6], &[1, 3, 4, 6], &[0, 1, 4, 7], &[0, 3, 4, 7], &[3, 4, 5, 6], &[3, 4, 5, 7]];
