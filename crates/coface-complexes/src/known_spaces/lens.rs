//! Lens spaces.

use super::{from_rule, require};
use crate::simplicial::SimplicialComplex;
use coface_algebra::Error;

/// The lens space L(p, q) with $9p + 6$ vertices: two solid tori on one torus.
///
/// The torus is the plane grid (squares with a diagonal) modulo the lattice spanned by (3p, 0) and (3q, 3). One solid
/// torus has disks in the direction (0, 1), where walks close up after 3p steps, the other in the direction (1, 0). A
/// solid torus is three slices: a center for each disk, each disk times an interval cut into simplices.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless p and q are coprime, p is 1 to 2^20 and q below p (0 for p = 1).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// let space = known_spaces::lens_space(5, 2)?;
/// assert_eq!((space.dimension(), space.euler_characteristic(), space.f_vector()[0]), (Some(3), 0, 51));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn lens_space(p: u32, q: u32) -> Result<SimplicialComplex, Error> {
    require((1..1 << 20).contains(&p) && q < p.max(1) && greatest_common_divisor(p, q) == 1, || {
        format!("there is no lens space L({p}, {q}); p and q must be coprime, q below p")
    })?;
    let (p, q) = (u64::from(p), u64::from(q));
    // The vertex of the torus at (x, y): reduce y into 0..3 by the second lattice vector, then x into 0..3p.
    let vertex = |x: u64, y: u64| {
        let turns = y / 3;
        let x = (x + 3 * (p - q) * (turns % p)) % (3 * p);
        (x * 3 + y % 3) as u32
    };
    let mut facets = Vec::new();
    for swapped in [false, true] {
        // Disk `slice` is spanned by the walk (slice, 0), (slice, 1), ...; the other solid torus swaps the axes.
        let rim = |slice: u64, step: u64| if swapped { vertex(step, slice) } else { vertex(slice, step) };
        // Three disks. After three slices the walk is the first again, shifted: (3, y) is (0, y + shift) and the
        // prisms between slices close up by themselves, for the rim is a vertex of the torus.
        let center = |slice: u64| (9 * p + if swapped { 3 } else { 0 } + slice % 3) as u32;
        for slice in 0..3 {
            for step in 0..3 * p {
                let [c, d] = [center(slice), center(slice + 1)];
                let [a, b] = [rim(slice, step), rim(slice, step + 1)];
                let [e, f] = [rim(slice + 1, step), rim(slice + 1, step + 1)];
                facets.extend([vec![c, a, b, f], vec![c, a, e, f], vec![c, d, e, f]]);
            }
        }
    }
    from_rule(facets)
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
