//! Signs across pinched ridges: where more than two facets of a cell meet.

use coface_algebra::{ParityUnionFind, Sign};

/// Why the patches of a boundary are not joined.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum PinchedRidge {
    /// No signs make the boundary vanish at this ridge.
    Open(u32),
    /// Several choices may, and nothing else decides.
    Undecided(u32),
}

/// The component of each patch and the sign that it gets, from the terms (ridge, patch, coefficient) of all facets at pinched
/// ridges. The first patch of each component keeps its sign.
///
/// At each ridge the sum over patches vanishes. Patches that cancel there by themselves are free; two that do not give each
/// the sign of the other and become one, which may cancel at other ridges. The rim of a face in the plane consists of
/// cycles of which two meet in one vertex at most, as branches of a tree; so some cycle is always at an end, and this goes
/// on until all are closed.
pub(super) fn join_patches(
    patch_count: usize,
    mut terms: Vec<(u32, u32, i64)>,
) -> Result<Vec<(u32, Sign)>, PinchedRidge> {
    terms.sort_unstable();
    let mut patches = ParityUnionFind::new(patch_count);
    let mut ridges: Vec<Vec<(u32, i64)>> = Vec::new();
    let mut names = Vec::new();
    for at in terms.chunk_by(|a, b| a.0 == b.0) {
        names.push(at[0].0);
        ridges.push(at.iter().map(|&(_, patch, coefficient)| (patch, coefficient)).collect());
    }
    let mut waiting: Vec<usize> = (0..ridges.len()).collect();
    loop {
        let mut is_waiting = Vec::new();
        for &ridge in &waiting {
            combine(&mut patches, &mut ridges[ridge]);
            match ridges[ridge][..] {
                [] => {}
                [(p, a), (q, b)] if a.abs() == b.abs() => {
                    // sign of p * a + sign of q * b = 0.
                    let relative = if a == b { Sign::Minus } else { Sign::Plus };
                    patches.unite(p, q, relative);
                }
                [_] | [_, _] => return Err(PinchedRidge::Open(names[ridge])),
                _ => is_waiting.push(ridge),
            }
        }
        match is_waiting.first() {
            None => break,
            Some(&ridge) if is_waiting.len() == waiting.len() => {
                let sum: i64 = ridges[ridge].iter().map(|term| term.1).sum();
                let name = names[ridge];
                return Err(if sum % 2 == 0 {
                    PinchedRidge::Undecided(name)
                } else {
                    PinchedRidge::Open(name)
                });
            }
            Some(_) => waiting = is_waiting,
        }
    }
    let mut of_root = vec![None; patch_count];
    let mut component_count = 0;
    Ok((0..patch_count as u32)
        .map(|patch| {
            let (root, sign) = patches.find(patch);
            let (component, first) = *of_root[root as usize].get_or_insert_with(|| {
                component_count += 1;
                (component_count - 1, sign)
            });
            (component, sign.times(first))
        })
        .collect())
}

/// Writes terms in the roots of their patches and leaves out what cancels.
fn combine(patches: &mut ParityUnionFind, terms: &mut Vec<(u32, i64)>) {
    for (patch, coefficient) in terms.iter_mut() {
        let (root, sign) = patches.find(*patch);
        *patch = root;
        *coefficient *= i64::from(sign.to_i32());
    }
    terms.sort_unstable_by_key(|term| term.0);
    terms.dedup_by(|next, kept| {
        let is_same = next.0 == kept.0;
        if is_same {
            kept.1 += next.1;
        }
        is_same
    });
    terms.retain(|term| term.1 != 0);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patches_that_close_by_themselves_are_free() {
        // Two loops at ridge 7.
        let joined = join_patches(2, vec![(7, 0, 1), (7, 0, -1), (7, 1, 1), (7, 1, -1)]).unwrap();
        assert_eq!(joined, [(0, Sign::Plus), (1, Sign::Plus)]);
    }

    /// A cycle through ridges 0 and 1, with a loop at each: paths 0 and 1 between them, loops 2 and 3.
    #[test]
    fn paths_between_pinches_are_joined() {
        let terms =
            vec![(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1), (0, 2, 1), (0, 2, -1), (1, 3, 1), (1, 3, -1)];
        let joined = join_patches(4, terms).unwrap();
        assert_eq!(joined, [(0, Sign::Plus), (0, Sign::Minus), (1, Sign::Plus), (2, Sign::Plus)]);
    }

    #[test]
    fn what_does_not_follow_is_refused() {
        // Three paths between two ridges.
        let odd = (0..3).flat_map(|path| [(4, path, 1), (5, path, -1)]).collect();
        assert_eq!(join_patches(3, odd), Err(PinchedRidge::Open(4)));
        let even = (0..4).flat_map(|path| [(4, path, 1), (5, path, -1)]).collect();
        assert_eq!(join_patches(4, even), Err(PinchedRidge::Undecided(4)));
    }
}
