//! Surfaces from three involutions of flags.

use super::GeneralizedMap;
use coface_algebra::RaggedArray;
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{Error, ErrorKind};

const UNSEEN: u32 = u32::MAX;

impl GeneralizedMap {
    /// The surface with these involutions of the flags `0..n`, and the number that each flag has in it.
    ///
    /// Involutions 0 and 1 move every flag; a flag that involution 2 leaves where it is lies on the boundary. Involutions 0
    /// and 2 commute and have no flag in common that they move alike. Vertices are the orbits of 1 and 2, edges of
    /// 0 and 2, faces of 0 and 1, all numbered by their smallest flags. A face and an edge run from their smallest flag
    /// to its image under 0.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if the three differ in length; [`ErrorKind::InvalidInput`] naming the flag where one of these
    /// rules is broken.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// The Moebius band: a square with two opposite sides glued as they run.
    /// ```
    /// use coface_complexes::surface::GeneralizedMap;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Flags 2s and 2s + 1 are the ends of side s; sides 0 and 2 are glued.
    /// let other_end = vec![1, 0, 3, 2, 5, 4, 7, 6];
    /// let corner = vec![7, 2, 1, 4, 3, 6, 5, 0];
    /// let mate = vec![4, 5, 2, 3, 0, 1, 6, 7];
    /// let (band, _) = GeneralizedMap::from_involutions(&[other_end, corner, mate])?;
    /// assert_eq!(band.surfaces()[0].to_string(), "Moebius band");
    /// # Ok(()) }
    /// ```
    pub fn from_involutions(involutions: &[Vec<u32>; 3]) -> Result<(Self, Vec<u32>), Error> {
        check(involutions)?;
        let [other_end, corner, mate] = involutions;
        let count = other_end.len();
        // Faces: sides in the order of a walk from the smallest flag.
        let mut numbers = vec![UNSEEN; count];
        let mut rims: Vec<Vec<u32>> = Vec::new();
        let mut sides = 0;
        for first in 0..count as u32 {
            let mut rim = Vec::new();
            let mut at = first;
            while numbers[at as usize] == UNSEEN {
                let end = other_end[at as usize];
                (numbers[at as usize], numbers[end as usize]) = (2 * sides, 2 * sides + 1);
                sides += 1;
                rim.push(at);
                at = corner[end as usize];
            }
            if !rim.is_empty() {
                rims.push(rim);
            }
        }
        let (vertex, vertex_count) = orbits(count, corner, mate);
        let (edge, edge_count) = orbits(count, other_end, mate);
        let mut ends = vec![UNSEEN; 2 * edge_count];
        // The flags at the source of each edge are its smallest one and the mate of that.
        let mut at_source = vec![false; count];
        for flag in 0..count {
            let ends = &mut ends[2 * edge[flag] as usize..][..2];
            if ends[0] == UNSEEN {
                (ends[0], ends[1]) = (vertex[flag], vertex[other_end[flag] as usize]);
                at_source[flag] = true;
                at_source[mate[flag] as usize] = true;
            }
        }
        let mut faces = RaggedArray::new();
        for rim in &rims {
            let steps =
                rim.iter().map(|&flag| 2 * edge[flag as usize] + u32::from(!at_source[flag as usize]));
            faces.push(&steps.collect::<Vec<u32>>());
        }
        let skeleton = TwoSkeleton::new(vertex_count, ends, faces)?;
        Ok((Self::new(skeleton)?, numbers))
    }
}

fn check(involutions: &[Vec<u32>; 3]) -> Result<(), Error> {
    let count = involutions[0].len();
    if involutions.iter().any(|involution| involution.len() != count) {
        let [a, b, c] = involutions.each_ref().map(Vec::len);
        return Err(Error::new(
            ErrorKind::Shape,
            format!("the involutions have {a}, {b} and {c} flags, not as many each"),
        ));
    }
    for (index, involution) in involutions.iter().enumerate() {
        for (flag, &image) in involution.iter().enumerate() {
            let Some(&back) = involution.get(image as usize) else {
                return Err(Error::invalid(format!(
                    "involution {index} takes flag {flag} to {image}, but there are {count} flags"
                ))
                .with_cure("number the flags from 0"));
            };
            if back as usize != flag {
                return Err(Error::invalid(format!(
                    "involution {index} takes flag {flag} to {image}, but {image} to {back}"
                ))
                .with_cure("flags must come in pairs"));
            }
            if index < 2 && image as usize == flag {
                return Err(Error::invalid(format!("involution {index} leaves flag {flag} where it is"))
                    .with_cure("only involution 2 may have fixed flags, on the boundary"));
            }
        }
    }
    let [other_end, _, mate] = involutions;
    for flag in 0..count {
        let (far, across) = (other_end[flag] as usize, mate[flag] as usize);
        if mate[far] != other_end[across] {
            return Err(Error::invalid(format!("involutions 0 and 2 do not commute at flag {flag}"))
                .with_cure("glue whole sides"));
        }
        if far == across {
            return Err(Error::invalid(format!("involutions 0 and 2 both take flag {flag} to {far}"))
                .with_cure("no side is glued to itself; cut it in two"));
        }
    }
    Ok(())
}

/// The number of the orbit of each flag under two involutions, by smallest flags, and how many there are.
fn orbits(count: usize, first: &[u32], second: &[u32]) -> (Vec<u32>, usize) {
    let mut orbit = vec![UNSEEN; count];
    let mut orbit_count = 0;
    let mut stack = Vec::new();
    for start in 0..count as u32 {
        if orbit[start as usize] != UNSEEN {
            continue;
        }
        stack.push(start);
        while let Some(flag) = stack.pop() {
            if orbit[flag as usize] == UNSEEN {
                orbit[flag as usize] = orbit_count;
                stack.extend([first[flag as usize], second[flag as usize]]);
            }
        }
        orbit_count += 1;
    }
    (orbit, orbit_count as usize)
}
