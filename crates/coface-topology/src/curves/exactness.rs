//! Closed and exact cochains of degree 1, with proofs.

use super::ClosedWalk;
use coface_algebra::chains::{Cochain, Coefficient, TwoSkeleton};
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, ErrorKind, FaceId, VertexId};
use coface_algebra::{Integer, RaggedArray};

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// Whether a cochain of degree 1 is closed, and whether it is exact: the coboundary of a function on the vertices.
///
/// Closed means that the sum around the rim of each face is zero. Every exact cochain is closed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Exactness<C> {
    /// It is exact.
    Exact {
        /// A cochain of degree 0 whose coboundary it is: zero at the first vertex of each component.
        potential: Cochain<C>,
    },
    /// It is closed, but not exact.
    Closed {
        /// A walk along which the sum is not zero.
        walk: ClosedWalk,
        /// The sum along the walk.
        period: C,
    },
    /// It is not closed.
    NotClosed {
        /// A face; the sum around its rim is not zero.
        face: FaceId,
        /// The sum around its rim.
        sum: C,
    },
}

/// Whether a cochain of degree 1 is closed and whether it is exact, with the potential, the walk or the face that shows
/// it.
///
/// # Errors
/// [`ErrorKind::Shape`] for a cochain of another degree; [`ErrorKind::NotInComplex`] naming an edge that is not there;
/// [`ErrorKind::Coefficient`] for coefficients of different rings.
///
/// # Complexity
/// Linear: one breadth-first tree.
///
/// # Examples
/// On the rim of a triangle everything is closed. A cochain that is 1 on edge 01 alone is not exact.
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::Integer;
/// use coface_algebra::chains::Cochain;
/// use coface_complexes::known_spaces;
/// use coface_topology::{Exactness, exactness};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let rim = known_spaces::circle(3)?.freeze();
/// let (skeleton, complex) = (rim.two_skeleton()?, rim.chain_complex()?);
/// let edge = Cochain::new(&complex, 1, [(CellId::new(0), Integer::ONE)])?;
/// let Exactness::Closed { walk, period } = exactness(&skeleton, &edge)? else { panic!() };
/// assert_eq!((walk.len(), period.abs()), (3, 1.into()));
/// // Up by 1 from vertex 0 to the others: the edges are 01, 02, 12.
/// let climb = Cochain::new(&complex, 1, [0, 1].map(|e| (CellId::new(e), Integer::ONE)))?;
/// let Exactness::Exact { potential } = exactness(&skeleton, &climb)? else { panic!() };
/// assert_eq!(potential.to_string(), "c1 + c2");
/// # Ok(()) }
/// ```
pub fn exactness(skeleton: &TwoSkeleton, cochain: &Cochain<Integer>) -> Result<Exactness<Integer>, Error> {
    decide(skeleton, cochain, &Integer::ZERO, Integer::is_zero)
}

/// As [`exactness`] for real cochains: sums of absolute value at most `tolerance` count as zero.
///
/// # Errors
/// As [`exactness`]; [`ErrorKind::InvalidInput`] for a tolerance that is negative or not a number.
///
/// # Examples
/// A rim of three edges, 01, 02, 12: a sum that is zero but for rounding.
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::chains::Cochain;
/// use coface_complexes::known_spaces;
/// use coface_topology::{Exactness, exactness_within};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let rim = known_spaces::circle(3)?.freeze();
/// let values = [(0, 0.1), (2, 0.2), (1, 0.3)].map(|(e, x)| (CellId::new(e), x));
/// let cochain = Cochain::new(&rim.chain_complex()?, 1, values)?;
/// let skeleton = rim.two_skeleton()?;
/// assert!(matches!(exactness_within(&skeleton, &cochain, 1e-12)?, Exactness::Exact { .. }));
/// assert!(matches!(exactness_within(&skeleton, &cochain, 0.0)?, Exactness::Closed { .. }));
/// # Ok(()) }
/// ```
pub fn exactness_within(
    skeleton: &TwoSkeleton,
    cochain: &Cochain<f64>,
    tolerance: f64,
) -> Result<Exactness<f64>, Error> {
    if tolerance.is_nan() || tolerance < 0.0 {
        return Err(Error::invalid(format!("the tolerance is {tolerance}"))
            .with_cure("give the largest absolute value of a sum that counts as zero"));
    }
    decide(skeleton, cochain, &0.0, |sum| sum.abs() <= tolerance)
}

fn decide<C: Coefficient>(
    skeleton: &TwoSkeleton,
    cochain: &Cochain<C>,
    zero: &C,
    is_zero: impl Fn(&C) -> bool,
) -> Result<Exactness<C>, Error> {
    let (vertex_count, edge_count, face_count) =
        (skeleton.vertex_count(), skeleton.edge_count(), skeleton.face_count());
    if cochain.degree() != 1 {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("a cochain of degree {} where one of degree 1 is asked for", cochain.degree()),
        ));
    }
    let mut values = vec![zero.clone(); edge_count];
    for (cell, value) in cochain.terms() {
        let Some(place) = values.get_mut(cell.index()) else {
            return Err(Error::new(
                ErrorKind::NotInComplex,
                format!("there is no edge {cell} of the cochain; there are {edge_count} edges"),
            ));
        };
        *place = value.clone();
    }
    let plus_step = |sum: &C, step: u32| {
        let value = &values[(step >> 1) as usize];
        if step & 1 == 0 { sum.plus(value) } else { sum.plus(&value.negated()) }
    };
    let summing = stage("summing around faces", face_count);
    for face in summing.each(0..face_count) {
        let rim = skeleton.faces().list(face).iter();
        let sum = rim.copied().try_fold(zero.clone(), |sum, step| plus_step(&sum, step))?;
        if !is_zero(&sum) {
            return Ok(Exactness::NotClosed { face: FaceId::new(face), sum });
        }
    }
    let ends = skeleton.edge_ends();
    let steps_at = RaggedArray::grouped(vertex_count, ends.iter().copied());
    let mut tree = vec![NONE; vertex_count];
    let mut potential: Vec<Option<C>> = vec![None; vertex_count];
    drop(summing);
    let mut queue = Vec::new();
    let steps = stage("spreading a potential", vertex_count);
    let mut reached = 0;
    for root in 0..vertex_count {
        if potential[root].is_some() {
            continue;
        }
        potential[root] = Some(zero.clone());
        queue.push(root as u32);
        let mut at = 0;
        while at < queue.len() {
            let vertex = queue[at] as usize;
            at += 1;
            reached += 1;
            steps.pass(reached);
            let here = potential[vertex].clone().expect("vertices of the queue have a potential");
            for &step in steps_at.list(vertex) {
                let there = ends[(step ^ 1) as usize] as usize;
                let through = plus_step(&here, step)?;
                match &potential[there] {
                    None => {
                        potential[there] = Some(through);
                        tree[there] = step;
                        queue.push(there as u32);
                    }
                    Some(known) => {
                        let period = through.plus(&known.negated())?;
                        if !is_zero(&period) {
                            let walk = closed_up(ends, &tree, step);
                            return Ok(Exactness::Closed { walk: ClosedWalk::new(skeleton, walk)?, period });
                        }
                    }
                }
            }
        }
        queue.clear();
    }
    let terms = potential.into_iter().enumerate();
    let terms = terms.filter_map(|(vertex, value)| Some((CellId::new(vertex), value?)));
    Ok(Exactness::Exact { potential: Cochain::of_cells(0, terms)? })
}

/// A step closed up along a tree: to its source, through it, and back, without the way in common.
fn closed_up(ends: &[u32], tree: &[u32], step: u32) -> Vec<u32> {
    let way_up = |vertex: u32| {
        let mut way = Vec::new();
        let mut at = VertexId::from_u32(vertex);
        while tree[at.index()] != NONE {
            let step = tree[at.index()];
            way.push(step);
            at = VertexId::from_u32(ends[step as usize]);
        }
        way
    };
    let (mut there, mut back) = (way_up(ends[step as usize]), way_up(ends[(step ^ 1) as usize]));
    while let (Some(a), Some(b)) = (there.last(), back.last())
        && a == b
    {
        there.pop();
        back.pop();
    }
    let mut steps = vec![step];
    steps.extend(back.into_iter().map(|step| step ^ 1));
    steps.extend(there.into_iter().rev());
    steps
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::homology::HomologyBasis;
    use coface_algebra::chains::ChainComplex;
    use coface_complexes::known_spaces;
    use proptest::prelude::*;

    fn check(skeleton: &TwoSkeleton, complex: &ChainComplex, cochain: &Cochain<Integer>) -> &'static str {
        match exactness(skeleton, cochain).unwrap() {
            Exactness::Exact { potential } => {
                assert_eq!(&complex.coboundary(&potential).unwrap(), cochain);
                "exact"
            }
            Exactness::Closed { walk, period } => {
                assert!(complex.is_closed(cochain).unwrap());
                assert!(complex.is_cycle(&walk.chain()).unwrap() && !period.is_zero());
                assert_eq!(cochain.pairing(&walk.chain()).unwrap(), Some(period));
                "closed"
            }
            Exactness::NotClosed { face, sum } => {
                let coboundary = complex.coboundary(cochain).unwrap();
                assert_eq!(coboundary.coefficient(CellId::new(face.index())), Some(&sum));
                "not closed"
            }
        }
    }

    #[test]
    fn verdicts_agree_with_cohomology() {
        let spaces = [
            known_spaces::cyclic_torus(2),
            known_spaces::small_klein_bottle(),
            known_spaces::projective_plane(),
            known_spaces::triangle_strip(5),
            known_spaces::triangle_strip(6),
            known_spaces::circle(3),
        ];
        for space in spaces {
            let space = space.unwrap().freeze();
            let (skeleton, complex) = (space.two_skeleton().unwrap(), space.chain_complex().unwrap());
            let basis = HomologyBasis::new(&complex);
            for cocycle in basis.cocycles(1).iter().filter(|cocycle| cocycle.order().is_none()) {
                assert_eq!(check(&skeleton, &complex, cocycle.cochain()), "closed");
            }
            let edge = Cochain::new(&complex, 1, [(CellId::new(0), Integer::ONE)]).unwrap();
            let expected = if skeleton.face_count() == 0 { "closed" } else { "not closed" };
            assert_eq!(check(&skeleton, &complex, &edge), expected);
            assert_eq!(check(&skeleton, &complex, &Cochain::zero(1)), "exact");
            let real = Cochain::new(&complex, 1, [(CellId::new(0), 0.5)]).unwrap();
            assert!(!matches!(exactness_within(&skeleton, &real, 0.1).unwrap(), Exactness::Exact { .. }));
            assert!(matches!(exactness_within(&skeleton, &real, 9.0).unwrap(), Exactness::Exact { .. }));
            assert_eq!(exactness_within(&skeleton, &real, -1.0).unwrap_err().kind(), ErrorKind::InvalidInput);
            let vertex = Cochain::new(&complex, 0, [(CellId::new(0), Integer::ONE)]).unwrap();
            assert_eq!(exactness(&skeleton, &vertex).unwrap_err().kind(), ErrorKind::Shape);
        }
    }

    proptest! {
        #[test]
        fn coboundaries_are_exact_and_sums_with_cocycles_are_not(
            values in prop::collection::vec(-5i64..5, 7), factors in prop::collection::vec(-2i64..3, 2),
        ) {
            let torus = known_spaces::cyclic_torus(2).unwrap().freeze();
            let (skeleton, complex) = (torus.two_skeleton().unwrap(), torus.chain_complex().unwrap());
            let heights = values.iter().enumerate().map(|(v, &z)| (CellId::new(v), Integer::from(z)));
            let mut sum = complex.coboundary(&Cochain::new(&complex, 0, heights).unwrap()).unwrap();
            let basis = HomologyBasis::unshortened(&complex);
            for (cocycle, &factor) in basis.cocycles(1).iter().zip(&factors) {
                sum = sum.plus(&cocycle.cochain().scaled(&factor.into()).unwrap()).unwrap();
            }
            let expected = if factors == [0, 0] { "exact" } else { "closed" };
            prop_assert_eq!(check(&skeleton, &complex, &sum), expected);
        }
    }
}
