//! Projective planes and spaces over the real, complex and quaternionic numbers, and the K3 surface.

use super::{for_each_permutation, from_orbits, from_rule, require};
use crate::simplicial::SimplicialComplex;
use coface_algebra::Error;

/// The projective plane with 6 vertices: vertex 5 over the pentagon 0..5, and the triangles {i, i+1, i+3} modulo 5. Half
/// an icosahedron.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::projective_plane()?.f_vector(), [6, 15, 10]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
///
/// # Errors
/// None: the rule is sound.
pub fn projective_plane() -> Result<SimplicialComplex, Error> {
    from_rule((0..5).flat_map(|i| [vec![5, i, (i + 1) % 5], vec![i, (i + 1) % 5, (i + 3) % 5]]))
}

/// The complex projective plane with 9 vertices, the least possible: the images of {0,1,3,4,5} and {0,1,3,4,8} under the
/// group of order 54 that (036)(147)(258), (012)(354) and (01)(34)(67) generate.
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// W. Kuehnel, T. F. Banchoff, *The 9-vertex complex projective plane* (1983).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::complex_projective_plane()?.f_vector(), [9, 36, 84, 90, 36]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn complex_projective_plane() -> Result<SimplicialComplex, Error> {
    from_orbits(
        &[&[0, 1, 3, 4, 5], &[0, 1, 3, 4, 8]],
        &[&[3, 4, 5, 6, 7, 8, 0, 1, 2], &[1, 2, 0, 5, 3, 4, 6, 7, 8], &[1, 0, 2, 4, 3, 5, 7, 6, 8]],
    )
}

/// The quaternionic projective plane with 15 vertices, the least possible: the images of fourteen base simplices of
/// dimension 8 under the alternating group of order 60 that (0 1 2 3 4)(5 6 7 8 9)(10 11 12 13 14) and
/// (0 5 10)(1 14 13)(2 12 7)(3 6 4)(8 11 9) generate.
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// U. Brehm, W. Kuehnel, *15-vertex triangulations of an 8-manifold* (1992); that it is the projective plane: D.
/// Gorodkov, *A 15-vertex triangulation of the quaternionic projective plane* (2019).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// let plane = known_spaces::quaternionic_projective_plane()?;
/// assert_eq!(plane.f_vector(), [15, 105, 455, 1365, 3003, 4515, 4230, 2205, 490]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn quaternionic_projective_plane() -> Result<SimplicialComplex, Error> {
    from_orbits(
        &[
            &[0, 1, 2, 5, 7, 10, 12, 13, 14],
            &[0, 2, 5, 7, 8, 9, 10, 11, 12],
            &[0, 1, 5, 8, 9, 10, 11, 13, 14],
            &[0, 1, 2, 3, 6, 8, 11, 13, 14],
            &[0, 1, 3, 6, 8, 9, 11, 12, 13],
            &[0, 1, 5, 7, 8, 9, 10, 13, 14],
            &[0, 1, 2, 3, 4, 5, 8, 10, 12],
            &[0, 2, 4, 5, 7, 8, 9, 10, 11],
            &[0, 2, 4, 5, 6, 7, 8, 9, 10],
            &[0, 1, 2, 3, 4, 6, 9, 11, 14],
            &[0, 1, 2, 6, 7, 9, 11, 12, 13],
            &[1, 4, 5, 6, 7, 8, 9, 12, 13],
            &[2, 3, 5, 6, 10, 11, 12, 13, 14],
            &[2, 3, 5, 6, 9, 11, 12, 13, 14],
        ],
        &[
            &[1, 2, 3, 4, 0, 6, 7, 8, 9, 5, 11, 12, 13, 14, 10],
            &[5, 14, 12, 6, 3, 10, 4, 2, 11, 8, 0, 9, 7, 1, 13],
        ],
    )
}

/// The real projective space of this dimension with $2^{n+1} - 1$ vertices: the non-empty proper subsets of n + 2 things,
/// each one with its complement; simplices are chains of subsets. It is half the barycentric subdivision of the boundary
/// of a simplex.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless the dimension is 1 to 7.
///
/// # References
/// W. Kuehnel, *Minimal triangulations of Kummer varieties* (1987).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::real_projective_space(2)?.f_vector(), [7, 18, 12]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn real_projective_space(dimension: usize) -> Result<SimplicialComplex, Error> {
    require((1..=7).contains(&dimension), || {
        format!("a projective space of dimension {dimension} is not built; 1 to 7 are")
    })?;
    let mut facets = Vec::new();
    let all = (1u32 << (dimension + 2)) - 1;
    for_each_permutation(dimension + 2, &mut |order| {
        let mut subset = 0;
        let prefixes = order[..=dimension].iter().map(|&i| {
            subset |= 1 << i;
            // Of a subset and its complement the smaller number stands for both.
            subset.min(all ^ subset) - 1
        });
        facets.push(prefixes.collect::<Vec<u32>>());
    });
    from_rule(facets)
}

/// The K3 surface with 16 vertices, the least possible: the images of {0,1,2,4,8} and {0,1,2,10,13} under the affine
/// maps x -> ax + b of the field with 16 elements. An element is the number whose bits are the coefficients of a polynomial
/// modulo $x^4 + x + 1$.
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// M. Casella, W. Kuehnel, *A triangulated K3 surface with the minimum number of vertices* (2001), found again here by
/// trying all pairs of orbits; isomorphic to the list in the simpcomp library.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::k3_surface()?.f_vector(), [16, 120, 560, 720, 288]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn k3_surface() -> Result<SimplicialComplex, Error> {
    let times = |a: u32, b: u32| {
        let product = (0..4).filter(|i| b >> i & 1 == 1).fold(0, |sum, i| sum ^ a << i);
        (4..7).rev().fold(product, |sum, i| if sum >> i & 1 == 1 { sum ^ 0b1_0011 << (i - 4) } else { sum })
    };
    from_rule((1..16).flat_map(|a| (0..16).map(move |b| (a, b))).flat_map(|(a, b)| {
        [[0, 1, 2, 4, 8], [0, 1, 2, 10, 13]].map(|facet| facet.map(|x| times(a, x) ^ b).to_vec())
    }))
}
