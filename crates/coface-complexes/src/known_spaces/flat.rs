//! The ten closed flat manifolds of dimension 3.

use super::{from_rule, torus_bundle};
use crate::simplicial::SimplicialComplex;
use coface_algebra::Error;
use coface_algebra::UnionFind;

/// A closed flat manifold of dimension 3: a quotient of space by a crystallographic group without torsion. Six are
/// orientable, four are not; names after Wolf.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FlatManifold {
    /// The 3-torus.
    G1,
    /// The torus bundle with a half turn.
    G2,
    /// The torus bundle with a third of a turn.
    G3,
    /// The torus bundle with a quarter turn.
    G4,
    /// The torus bundle with a sixth of a turn.
    G5,
    /// The manifold of Hantzsche and Wendt, the only one with finite first homology group.
    G6,
    /// The Klein bottle times a circle: the torus bundle with the reflection along an axis.
    B1,
    /// The torus bundle with the reflection along the diagonal.
    B2,
    /// The Klein bottle bundle with first homology group Z + Z/2 + Z/2.
    B3,
    /// The Klein bottle bundle with first homology group Z + Z/4.
    B4,
}

impl FlatManifold {
    /// All ten.
    pub const ALL: [Self; 10] =
        [Self::G1, Self::G2, Self::G3, Self::G4, Self::G5, Self::G6, Self::B1, Self::B2, Self::B3, Self::B4];
}

/// A closed flat manifold, as a torus bundle ([`torus_bundle`]) or, for G6, B3 and B4, as a quotient of the 3-torus: a grid
/// of 4 x 4 x 4 cubes in barycentric subdivision, modulo maps that move every point by half the length of an axis or more.
///
/// # Errors
/// None: the rules are sound.
///
/// # References
/// J. A. Wolf, *Spaces of constant curvature* (1967), theorems 3.5.5 and 3.5.9; W. Hantzsche, H. Wendt, *Dreidimensionale
/// euklidische Raumformen* (1935).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces::{FlatManifold, flat_manifold};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let space = flat_manifold(FlatManifold::G6)?;
/// assert_eq!(space.f_vector(), [128, 896, 1536, 768]);
/// assert_eq!(space.chain_complex()?.euler_characteristic(), 0);
/// # Ok(()) }
/// ```
pub fn flat_manifold(manifold: FlatManifold) -> Result<SimplicialComplex, Error> {
    match manifold {
        FlatManifold::G1 => torus_bundle([[1, 0], [0, 1]]),
        FlatManifold::G2 => torus_bundle([[-1, 0], [0, -1]]),
        FlatManifold::G3 => torus_bundle([[0, -1], [1, -1]]),
        FlatManifold::G4 => torus_bundle([[0, -1], [1, 0]]),
        FlatManifold::G5 => torus_bundle([[1, -1], [1, 0]]),
        FlatManifold::G6 => quotient_of_torus(&[([1, -1, -1], [4, 4, 0]), ([-1, 1, -1], [0, 4, 4])]),
        FlatManifold::B1 => torus_bundle([[1, 0], [0, -1]]),
        FlatManifold::B2 => torus_bundle([[0, 1], [1, 0]]),
        FlatManifold::B3 => quotient_of_torus(&[([1, -1, -1], [4, 0, 0]), ([1, 1, -1], [0, 4, 0])]),
        FlatManifold::B4 => quotient_of_torus(&[([1, -1, -1], [4, 0, 0]), ([1, 1, -1], [0, 4, 4])]),
    }
}

/// The quotient of the 3-torus by the maps that multiply the coordinates by signs, then shift them. Lengths are in half
/// cubes, 8 to an axis: a point with k odd coordinates is the middle of a cell of dimension k.
fn quotient_of_torus(generators: &[([i32; 3], [i32; 3])]) -> Result<SimplicialComplex, Error> {
    let number = |point: [i32; 3]| point.iter().fold(0, |sum, x| 8 * sum + x.rem_euclid(8) as u32);
    let axis = |length: i32, step: usize| (0..length).step_by(step);
    let points = |step: usize| {
        axis(8, step)
            .flat_map(move |x| axis(8, step).flat_map(move |y| axis(8, step).map(move |z| [x, y, z])))
    };
    let mut classes = UnionFind::new(512);
    for point in points(1) {
        for (signs, shifts) in generators {
            classes.unite(number(point), number(std::array::from_fn(|i| signs[i] * point[i] + shifts[i])));
        }
    }
    let classes = classes.class_numbers();
    let mut facets = Vec::new();
    for corner in points(2) {
        for directions in 0..8 {
            for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
                let mut point = corner;
                let mut flag = vec![classes[number(point) as usize]];
                for i in order {
                    point[i] += if directions >> i & 1 == 1 { 1 } else { -1 };
                    flag.push(classes[number(point) as usize]);
                }
                facets.push(flag);
            }
        }
    }
    from_rule(facets)
}
