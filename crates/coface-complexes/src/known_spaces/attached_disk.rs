//! Spaces made of disks that are glued along closed walks: Moore spaces, the dunce hat, presentations of groups.

use super::{from_rule, require};
use crate::simplicial::SimplicialComplex;
use coface_algebra::Error;

/// Disks glued along closed walks: the complex of a presentation. The walks run on vertices `0..` that are given first
/// numbers; each disk is a polygon whose outer ring is the walk and whose inside has vertices of its own.
///
/// Inner vertex x sees a run of successive outer vertices, all different; the last of a run is the first of the next.
/// So no two triangles coincide, whatever the walk repeats.
fn attach_disks(base_vertex_count: u32, walks: &[Vec<u32>]) -> Vec<Vec<u32>> {
    let mut facets = Vec::new();
    let mut next = base_vertex_count;
    for walk in walks {
        let n = walk.len();
        let at = |i: usize| walk[i % n];
        // Start positions of the runs, first to last, closed by the position n (the start again).
        let mut starts = vec![0];
        let mut end = 0;
        while end < n {
            let start = end;
            end = start + 1;
            // Three runs at least, so that the inner ring is a polygon.
            while end < n && (start..=end).all(|i| at(i) != at(end + 1)) && end - start < n.div_ceil(3) {
                end += 1;
            }
            starts.push(end);
        }
        let inner = starts.len() as u32 - 1;
        for (x, run) in starts.windows(2).enumerate() {
            let x = x as u32;
            for i in run[0]..run[1] {
                facets.push(vec![at(i), at(i + 1), next + x]);
            }
            facets.push(vec![at(run[1]), next + x, next + (x + 1) % inner]);
        }
        facets.extend((1..inner - 1).map(|x| vec![next, next + x, next + x + 1]));
        next += inner;
    }
    facets
}

/// The Moore space with $H_1 = \mathbb{Z}/n$: a disk whose rim runs n times around a circle of three vertices. n = 2 is
/// a projective plane.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless n is 2 or more and below 2^24.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::moore_space(3)?.f_vector(), [8, 24, 17]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn moore_space(order: u32) -> Result<SimplicialComplex, Error> {
    require((2..1 << 24).contains(&order), || {
        format!("a Moore space of order {order} is not built; 2 to 2^24 are")
    })?;
    from_rule(attach_disks(3, &[(0..3 * order).map(|i| i % 3).collect()]))
}

/// The dunce hat: a triangle whose three sides are glued as a, a, a backwards. Contractible, but no triangle has a free
/// edge to collapse from.
///
/// # Errors
/// None: the rule is sound.
///
/// # References
/// E. C. Zeeman, *On the dunce hat* (1963).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::dunce_hat()?.f_vector(), [8, 24, 17]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn dunce_hat() -> Result<SimplicialComplex, Error> {
    from_rule(attach_disks(3, &[vec![0, 1, 2, 0, 1, 2, 0, 2, 1]]))
}

/// The complex of a group presentation: a wedge of circles, one a generator, and a disk for each relator. Letters of
/// relators are ±1, ±2, ... for the generators and their inverses. Its fundamental group is the presented group.
///
/// Vertex 0 is the base point; generator g runs through 0, 2g - 1, 2g and back.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] if a letter is 0 or beyond the generators, or a relator is empty.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// // < a, b | a b a^-1 b^-1 >: a torus.
/// let torus = known_spaces::presentation_complex(2, &[vec![1, 2, -1, -2]])?;
/// assert_eq!(torus.euler_characteristic(), 0);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn presentation_complex(generator_count: u32, relators: &[Vec<i32>]) -> Result<SimplicialComplex, Error> {
    require(generator_count < 1 << 24, || {
        format!("{generator_count} generators are too many; the limit is 2^24")
    })?;
    let mut walks = Vec::new();
    for (i, relator) in relators.iter().enumerate() {
        require(!relator.is_empty(), || format!("relator {i} is empty"))?;
        let mut walk = Vec::with_capacity(3 * relator.len());
        for &letter in relator {
            let g = letter.unsigned_abs();
            require((1..=generator_count).contains(&g), || {
                format!("relator {i} has the letter {letter}; the generators are 1 to {generator_count}")
            })?;
            walk.extend(if letter > 0 { [0, 2 * g - 1, 2 * g] } else { [0, 2 * g, 2 * g - 1] });
        }
        walks.push(walk);
    }
    let mut facets = attach_disks(2 * generator_count + 1, &walks);
    facets.extend(
        (1..=generator_count).flat_map(|g| [vec![0, 2 * g - 1], vec![2 * g - 1, 2 * g], vec![0, 2 * g]]),
    );
    facets.push(vec![0]);
    from_rule(facets)
}
