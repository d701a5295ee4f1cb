//! Spaces that their fundamental group names.

use super::{NamedSpace, SeifertSpace, SpaceName, SpaceProof};
use crate::groups::{EdgePathGroups, Effort};
use crate::homology::{AbelianGroup, homology};
use crate::recognition::GroupName;
use coface_algebra::Error;
use coface_complexes::gluing::{FaceClasses, GluingTable};

/// The name of a connected closed 3-manifold whose fundamental group leaves one space, up to orientation.
///
/// A simply connected one is the sphere, and one with a finite group is spherical (G. Perelman). A spherical space whose group is not
/// cyclic is known by its group, and this by its order and the first homology: see [`spherical`]. A cyclic group of order 2, 3, 4 or 6 leaves one
/// lens space, other orders leave several. The group Z is that of the two bundles of spheres over the circle; of the product of a projective
/// plane and the circle it is Z x Z/2.
///
/// # References
/// P. Orlik, *Seifert manifolds* (1972), chapter 6; D. B. A. Epstein, *Projective planes in 3-manifolds* (1961); J. Hempel, *3-manifolds* (1976), chapter 5.
pub(super) fn space_of_group(
    table: &GluingTable,
    faces: &FaceClasses,
    effort: Effort,
) -> Result<Option<NamedSpace>, Error> {
    let groups = homology(&faces.chain_complex()?);
    let first = &groups.groups()[1];
    let is_orientable = table.orientation().odd_cycle().is_none();
    // What else the group is, the first homology tells before the group is looked for.
    if first.betti() > 1 || is_orientable && first.betti() == 1 && !first.torsion().is_empty() {
        return Ok(None);
    }
    let paths = EdgePathGroups::new(&faces.two_skeleton()?);
    let Some(group) = paths.presentation(0).recognized(effort) else { return Ok(None) };
    let name = match group {
        GroupName::Abelian(group) => abelian(&group, is_orientable),
        GroupName::Finite { order, .. } if is_orientable => {
            let space = torsion_order(first).and_then(|first| spherical(order as u64, first));
            // The first homology of the invariants has to be that of the table.
            let found = (first.torsion().iter().map(ToString::to_string).collect(), first.betti());
            space.filter(|space| space.first_homology() == Some(found)).map(SpaceName::Seifert)
        }
        _ => None,
    };
    Ok(name.map(|name| NamedSpace { name, proof: SpaceProof::FundamentalGroup }))
}

/// The space of an abelian group, if there is one alone.
fn abelian(group: &AbelianGroup, is_orientable: bool) -> Option<SpaceName> {
    match (group.betti(), torsion_order(group)?, is_orientable) {
        (0, 1, true) => Some(SpaceName::Sphere),
        (0, p @ (2 | 3 | 4 | 6), true) if group.torsion().len() == 1 => Some(SpaceName::Lens { p, q: 1 }),
        (1, 1, _) => Some(SpaceName::SphereBundle { is_orientable }),
        (1, 2, false) => Some(SpaceName::ProjectivePlaneTimesCircle),
        _ => None,
    }
}

/// The number of elements of finite order, if it is not beyond 64 bits.
fn torsion_order(group: &AbelianGroup) -> Option<u64> {
    group
        .torsion()
        .iter()
        .try_fold(1_u64, |product, order| product.checked_mul(order.to_string().parse().ok()?))
}

/// The spherical space whose fundamental group is not abelian, and has this order; `first` is the order of its first homology.
///
/// It is fibered over the sphere with fibers 2, 2, n (where 4 divides `first`), 2, 3, 3 (the group is 8 times as large), 2, 3, 4 (24 times) or
/// 2, 3, 5 (120 times). With `first` these multiplicities leave one space and its mirror image: `first` is their product times the Euler number.
fn spherical(order: u64, first: u64) -> Option<SeifertSpace> {
    let ratio = order.checked_div(first).filter(|ratio| ratio * first == order)?;
    let whole = i64::try_from(first).ok()?;
    if first.is_multiple_of(4) {
        let n = i64::try_from(ratio).ok().filter(|&n| n > 1)?;
        return SeifertSpace::new(true, 0, &[(2, 1), (2, -1), (n, whole / 4)]);
    }
    let last = match ratio {
        8 => 3,
        24 => 4,
        120 => 5,
        _ => return None,
    };
    // The Euler number is 1/2 + a/3 + c/last + b.
    let fibers = [1, 2].into_iter().flat_map(|a| (1..last).map(move |c| (a, c)));
    fibers.filter(|&(_, c)| last != 4 || c % 2 == 1).find_map(|(a, c)| {
        let rest = whole - 3 * last - 2 * last * a - 6 * c;
        (rest % (6 * last) == 0).then(|| {
            let b = rest / (6 * last);
            SeifertSpace::new(true, 0, &[(2, 1), (3, a), (last, c + last * b)])
        })?
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Spherical spaces with the orders of their groups (P. Orlik): a prism space has a group of order 4 n m and first homology of order 4 m.
    #[test]
    fn orders_leave_one_space() {
        let name = |order, first| spherical(order, first).map(|space| space.to_string());
        for (order, first, expected) in [
            (8, 4, "SFS [S2: (2,1) (2,1) (2,-1)]"),
            (12, 4, "SFS [S2: (2,1) (2,1) (3,-2)]"),
            (24, 8, "SFS [S2: (2,1) (2,1) (3,-1)]"),
            (24, 3, "SFS [S2: (2,1) (3,1) (3,-2)]"),
            (48, 2, "SFS [S2: (2,1) (3,1) (4,-3)]"),
            (120, 1, "SFS [S2: (2,1) (3,1) (5,-4)]"),
        ] {
            assert_eq!(name(order, first).as_deref(), Some(expected), "{order} {first}");
        }
        assert_eq!(spherical(60, 1), None);
        assert_eq!(spherical(7, 2), None);
    }

    /// All spaces over the sphere with these fibers and small Euler number come back from the orders of their groups.
    #[test]
    fn orders_of_fibrations_give_them_back() {
        let mut count = 0;
        for (last, ratio) in [(3, 8), (4, 24), (5, 120)] {
            for (a, c) in [1, 2].into_iter().flat_map(|a| (1..last).map(move |c| (a, c))) {
                for b in -6..6 {
                    let Some(space) = SeifertSpace::new(true, 0, &[(2, 1), (3, a), (last, c + last * b)])
                    else {
                        continue;
                    };
                    let first = (3 * last + 2 * last * a + 6 * (c + last * b)).unsigned_abs();
                    if last == 4 && c == 2 {
                        continue;
                    }
                    assert_eq!(spherical(ratio * first, first), Some(space.clone()), "{space}");
                    count += 1;
                }
            }
        }
        for n in 2..9_i64 {
            for m in (1..20_i64).filter(|&m| coface_algebra::Integer::from(n).gcd(&m.into()) == 1.into()) {
                let space = SeifertSpace::new(true, 0, &[(2, 1), (2, 1), (n, m - n)]).unwrap();
                assert_eq!(spherical(4 * (n * m) as u64, 4 * m as u64), Some(space.clone()), "{space}");
                count += 1;
            }
        }
        assert!(count > 200, "{count}");
    }
}
