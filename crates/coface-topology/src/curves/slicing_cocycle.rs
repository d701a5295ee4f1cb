//! Cocycles of closed walks on surfaces, and algebraic intersection numbers.

use super::ClosedWalk;
use coface_algebra::chains::Cochain;
use coface_algebra::progress::stage;
use coface_algebra::{CellId, EdgeId, Error, ErrorKind, HalfedgeId, VertexId};
use coface_algebra::{Integer, Sign};
use coface_complexes::surface::{FaceOrientation, GeneralizedMap};

/// The closed cochain that comes from slicing a surface along a closed walk.
///
/// On the sliced surface let f be the function that is 1 at the vertices of the left copy of the walk and 0 at all
/// others. It is not defined on the surface itself, but its coboundary is: f jumps by 1 everywhere along the walk. So
/// the value on an edge is -1 for each time that its source touches the walk from the left and 1 for each time that its
/// target does. At a corner of the walk the edges between the outgoing and the incoming step touch it from the left, so
/// that the walk may meet itself. Where it turns back on the same edge, all other edges there are to its left.
///
/// # Conventions
/// The left of a step is the face whose rim runs as the step does, turned as [`FaceOrientation::signs`] says. On a
/// component that is not orientable, left is chosen at the first step and carried along.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] for a walk that comes back with left and right exchanged: slicing along it leaves one
/// side only, and there is no jump. [`ErrorKind::NotInComplex`] for a walk that is not of this surface.
///
/// # Complexity
/// The sum of the degrees of the vertices that are met. [`Slicing`] keeps the orientation for many walks.
///
/// # References
/// J. Erickson, K. Whittlesey, *Greedy optimal homotopy and homology generators* (2005), for the loops; X. Gu, S.-T.
/// Yau, *Computational Conformal Geometry* (2008), for the cocycles.
///
/// # Examples
/// On the torus made of one square, with a loop along either side, slicing along one gives the cochain that is 1 or -1
/// on the other.
/// ```
/// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
/// use coface_topology::{ClosedWalk, slicing_cocycle};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
/// let first = ClosedWalk::new(torus.skeleton(), vec![0])?;
/// assert_eq!(slicing_cocycle(&torus, &first)?.to_string(), "-c1");
/// # Ok(()) }
/// ```
pub fn slicing_cocycle(map: &GeneralizedMap, walk: &ClosedWalk) -> Result<Cochain<Integer>, Error> {
    Slicing::new(map).cocycle(walk)
}

/// The algebraic intersection number of two closed walks: how often the second crosses the first from its right to its
/// left, less how often it does so from left to right. Common parts are pushed apart first.
///
/// It depends on the homology classes only, and is skew. On a component that is not orientable its sign depends on
/// where the walks start.
///
/// # Errors
/// As [`slicing_cocycle`] for the first walk; [`ErrorKind::NotInComplex`] for a second one that is not of this surface.
///
/// # Complexity
/// As [`slicing_cocycle`], and the length of the second walk times a logarithm.
///
/// # Examples
/// The two loops of the torus made of one square cross once.
/// ```
/// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
/// use coface_topology::{ClosedWalk, intersection_number};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
/// let walk = |step: u32| ClosedWalk::new(torus.skeleton(), vec![step]);
/// assert_eq!(intersection_number(&torus, &walk(0)?, &walk(2)?)?, 1);
/// assert_eq!(intersection_number(&torus, &walk(2)?, &walk(0)?)?, -1);
/// assert_eq!(intersection_number(&torus, &walk(0)?, &walk(0)?)?, 0);
/// # Ok(()) }
/// ```
pub fn intersection_number(
    map: &GeneralizedMap,
    first: &ClosedWalk,
    second: &ClosedWalk,
) -> Result<i64, Error> {
    let slicing = Slicing::new(map);
    slicing.check(second)?;
    let values = slicing.values(first)?;
    Ok(-second.steps().iter().map(|&step| value_on_step(&values, step)).sum::<i64>())
}

/// The value of a sparse cochain, sorted by edges, on a step.
fn value_on_step(values: &[(u32, i64)], step: u32) -> i64 {
    match values.binary_search_by_key(&(step >> 1), |&(edge, _)| edge) {
        Err(_) => 0,
        Ok(at) if step & 1 == 0 => values[at].1,
        Ok(at) => -values[at].1,
    }
}

/// A surface with an orientation, ready to be sliced along many walks.
#[derive(Clone, Debug)]
pub struct Slicing<'a> {
    map: &'a GeneralizedMap,
    orientation: FaceOrientation,
}

/// Where a step has its left: on a side of its edge, or outside.
#[derive(Clone, Copy, PartialEq)]
enum Left {
    Side(HalfedgeId),
    /// The edge is on the boundary and the surface is to the right.
    Outside,
}

impl<'a> Slicing<'a> {
    /// Orients the surface.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{ClosedWalk, Slicing};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let walk = |steps: &[u32]| ClosedWalk::new(torus.skeleton(), steps.to_vec());
    /// assert!(Slicing::new(&torus).cocycle(&walk(&[0])?).is_ok());
    /// # Ok(()) }
    /// ```
    pub fn new(map: &'a GeneralizedMap) -> Self {
        Self { map, orientation: map.orientation() }
    }

    /// See [`slicing_cocycle`].
    ///
    /// # Errors
    /// As [`slicing_cocycle`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{ClosedWalk, Slicing};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let walk = |steps: &[u32]| ClosedWalk::new(torus.skeleton(), steps.to_vec());
    /// // The other loop crosses this one once.
    /// let cocycle = Slicing::new(&torus).cocycle(&walk(&[0])?)?;
    /// assert_eq!(cocycle.pairing(&walk(&[2])?.chain())?.map(|x| x.abs()), Some(1.into()));
    /// # Ok(()) }
    /// ```
    pub fn cocycle(&self, walk: &ClosedWalk) -> Result<Cochain<Integer>, Error> {
        let terms = self.values(walk)?;
        let terms = terms.into_iter().map(|(edge, value)| (CellId::from_u32(edge), Integer::from(value)));
        Cochain::of_cells(1, terms)
    }

    fn check(&self, walk: &ClosedWalk) -> Result<(), Error> {
        let edge_count = self.map.skeleton().edge_count();
        match walk.steps().iter().find(|&&step| (step >> 1) as usize >= edge_count) {
            None => Ok(()),
            Some(step) => Err(Error::new(
                ErrorKind::NotInComplex,
                format!(
                    "the walk has the edge {}; the surface has {edge_count}",
                    EdgeId::from_u32(step >> 1)
                ),
            )),
        }
    }

    /// The values of the cocycle that are not zero, by rising edges.
    pub(super) fn values(&self, walk: &ClosedWalk) -> Result<Vec<(u32, i64)>, Error> {
        self.check(walk)?;
        let steps = walk.steps();
        let Some(&first) = steps.first() else { return Ok(Vec::new()) };
        let mut touching = Vec::new();
        let start = self.left_of(first);
        let mut left = start;
        let progress = stage("walking along a loop", steps.len());
        for (i, &step) in progress.each(steps.iter().enumerate()) {
            left = self.corner(step, left, steps[(i + 1) % steps.len()], &mut touching);
        }
        if left != start {
            return Err(one_sided(self.map, walk));
        }
        touching.sort_unstable_by_key(|step| step >> 1);
        let mut values: Vec<(u32, i64)> = Vec::new();
        for step in touching {
            let value = if step & 1 == 0 { -1 } else { 1 };
            match values.last_mut() {
                Some((edge, sum)) if *edge == step >> 1 => *sum += value,
                _ => values.push((step >> 1, value)),
            }
        }
        values.retain(|&(_, sum)| sum != 0);
        Ok(values)
    }

    /// The left of a step as the orientation of the faces tells it.
    fn left_of(&self, step: u32) -> Left {
        let first = self.map.first_side(EdgeId::from_u32(step >> 1));
        let is_left = |side: HalfedgeId| {
            let sign = self.orientation.signs()[self.map.face(side).index()];
            (self.map.step(side) == step) == (sign == Sign::Plus)
        };
        if is_left(first) {
            return Left::Side(first);
        }
        // Where mates do not agree, both or none of them would be left; the other one is taken.
        self.map.mate(first).map_or(Left::Outside, Left::Side)
    }

    /// The other side of the edge of a step, seen from its left.
    fn right(&self, step: u32, left: Left) -> Left {
        match left {
            Left::Outside => Left::Side(self.map.first_side(EdgeId::from_u32(step >> 1))),
            Left::Side(side) => self.map.mate(side).map_or(Left::Outside, Left::Side),
        }
    }

    /// Goes around the vertex where `incoming` ends, from its left, until `outgoing` or the boundary is met. Notes the
    /// steps out of the vertex in between. The side of `outgoing` on which it was met.
    fn sweep(&self, incoming: u32, from: Left, outgoing: u32, touching: &mut Vec<u32>) -> Option<Left> {
        let Left::Side(side) = from else { return None };
        // The flag at the end of the incoming step.
        let mut flag = side.to_u32() << 1 | u32::from(self.map.step(side) == incoming);
        loop {
            let turned = self.map.alpha(1, flag);
            let side = HalfedgeId::from_u32(turned >> 1);
            let leaving = self.map.step(side) ^ (turned & 1);
            if leaving == outgoing {
                return Some(Left::Side(side));
            }
            touching.push(leaving);
            flag = self.map.alpha(2, turned);
            if flag == turned {
                return None;
            }
        }
    }

    /// Notes the steps that leave the vertex to the left between two steps of a walk. The left of the outgoing one.
    fn corner(&self, incoming: u32, left: Left, outgoing: u32, touching: &mut Vec<u32>) -> Left {
        if let Some(found) = self.sweep(incoming, left, outgoing, touching) {
            return found;
        }
        // The boundary is in between. The right way around tells which side of the outgoing step is its left; what lies
        // between it and the boundary is then noted from there.
        let met = if outgoing == incoming ^ 1 {
            left
        } else {
            let right = self.right(incoming, left);
            self.sweep(incoming, right, outgoing, &mut Vec::new())
                .expect("the faces at a vertex are one fan, so that one way around leads to each edge")
        };
        let found = self.right(outgoing, met);
        // Backwards: from the outgoing step, reversed, to the incoming one, which the boundary is before.
        self.sweep(outgoing ^ 1, found, incoming ^ 1, touching);
        found
    }
}

fn one_sided(map: &GeneralizedMap, walk: &ClosedWalk) -> Error {
    const FEW: usize = 32;
    let ends = map.skeleton().edge_ends();
    let targets = walk.steps().iter().map(|&step| VertexId::from_u32(ends[(step ^ 1) as usize]));
    let vertices: Vec<VertexId> = std::iter::once(walk.start()).chain(targets).collect();
    let few: Vec<String> = vertices.iter().take(FEW).map(ToString::to_string).collect();
    let more = if vertices.len() > FEW { " .." } else { "" };
    Error::invalid(format!(
        "the closed walk through {}{more} is one-sided: left and right are exchanged along it, so that slicing there \
         leaves a single side and no jump",
        few.join(" ")
    ))
    .with_cells([vertices.into_iter().map(VertexId::to_u32).collect::<Vec<_>>()])
    .with_cure("take the cocycles by crossing, or run through the walk twice")
}
