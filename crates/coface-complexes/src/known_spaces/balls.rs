//! Balls that cannot be taken apart one facet at a time.

use super::{from_orbits, from_rule};
use crate::simplicial::SimplicialComplex;
use coface_algebra::Error;

/// Rudin's ball: a convex 3-ball with 41 tetrahedra, all vertices on its boundary, from which no tetrahedron can be taken
/// so that a ball is left. The facets are the images of eleven under (0 1 2 3)(4 5 6 7)(8 9 10 11)(12 13).
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// M. E. Rudin, *An unshellable triangulation of a tetrahedron* (1958).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::rudin_ball()?.f_vector(), [14, 66, 94, 41]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn rudin_ball() -> Result<SimplicialComplex, Error> {
    from_orbits(
        &[
            &[0, 1, 4, 8],
            &[0, 1, 4, 9],
            &[0, 4, 9, 10],
            &[0, 6, 9, 10],
            &[0, 4, 10, 12],
            &[0, 6, 10, 12],
            &[1, 4, 8, 9],
            &[1, 5, 8, 9],
            &[4, 8, 9, 10],
            &[4, 8, 10, 12],
            &[8, 9, 10, 11],
        ],
        &[&[1, 2, 3, 0, 5, 6, 7, 4, 9, 10, 11, 8, 13, 12]],
    )
}

/// Ziegler's ball: a 3-ball with 10 vertices and 21 tetrahedra, from which no tetrahedron can be taken so that a ball is
/// left.
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// G. M. Ziegler, *Shelling polyhedral 3-balls and 4-polytopes* (1998); the list is his.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::ziegler_ball()?.f_vector(), [10, 38, 50, 21]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn ziegler_ball() -> Result<SimplicialComplex, Error> {
    const FACETS: [[u32; 4]; 21] = [
        [1, 2, 3, 4],
        [1, 2, 5, 6],
        [1, 5, 6, 9],
        [0, 2, 5, 6],
        [3, 6, 7, 8],
        [4, 5, 7, 8],
        [2, 3, 6, 7],
        [1, 2, 6, 9],
        [0, 2, 6, 7],
        [2, 3, 4, 8],
        [1, 3, 4, 7],
        [3, 4, 7, 8],
        [1, 2, 4, 9],
        [0, 2, 3, 7],
        [2, 3, 6, 8],
        [1, 4, 5, 7],
        [1, 4, 5, 8],
        [1, 4, 8, 9],
        [0, 1, 2, 3],
        [1, 5, 8, 9],
        [0, 1, 2, 5],
    ];
    from_rule(FACETS.map(|facet| facet.to_vec()))
}
