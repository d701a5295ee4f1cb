//! The faces around each edge in their order.

use super::PolygonalComplex;
use super::face_planes::FacePlanes;
use super::polygonal_complex::sign_of;
use super::predicates::SpatialPredicates;
use coface_algebra::Error;
use coface_algebra::progress::Steps;
use coface_algebra::{RaggedArray, Sign};
use rayon::prelude::*;
use std::cmp::Ordering;

/// The sides at so many edges are sorted at a time.
const EDGES: usize = 1 << 10;

/// Sides by faces, and around edges.
#[derive(Clone, Debug)]
pub(super) struct RadialOrder {
    /// The sides at each edge, counterclockwise seen from its second end, each as `2 * face + against`.
    around: RaggedArray,
}

/// A side at an edge, as a half-plane that begins at the edge.
#[derive(Clone, Copy, Debug)]
struct Wing {
    /// The side as `2 * face + against`.
    side: u32,
    /// A vertex of the plane of the face that is not on the line of the edge.
    apex: u32,
    /// Plus when the apex is in the half-plane, minus when it is in the other half.
    apex_sign: Sign,
}

/// The half-planes around one edge, compared by signs only.
pub(super) struct EdgeView<'a, P> {
    predicates: &'a P,
    planes: &'a FacePlanes,
    ends: [u32; 2],
}

impl<'a, P: SpatialPredicates> EdgeView<'a, P> {
    pub(super) fn new(
        complex: &PolygonalComplex,
        predicates: &'a P,
        planes: &'a FacePlanes,
        edge: usize,
    ) -> Self {
        let ends = predicates.points_of_line(edge as u32).unwrap_or(complex.edges()[edge]);
        Self { predicates, planes, ends }
    }

    /// Two vertices on the line of the edge, in its direction.
    pub(super) fn ends(&self) -> [u32; 2] {
        self.ends
    }

    /// The half-plane of a side. The three corners of a face's plane are not on one line, so one of them is off the
    /// line of the edge; it is as good as a vertex next to the edge, once it is known in which half of the plane it is.
    /// So faces need not be convex, and holes need no care.
    fn wing(&self, side: u32) -> Wing {
        let plane = self.planes.of(self.predicates, (side >> 1) as usize);
        let [a, b] = self.ends;
        let (apex, turn) = plane
            .corners
            .iter()
            .map(|&corner| (corner, plane.turn(self.predicates, [a, b, corner])))
            .find(|(_, turn)| turn.is_ne())
            .expect("the corners of a plane are not on one line");
        // The face is to the left of the side, not of the edge.
        let left = if turn.is_gt() { Sign::Plus } else { Sign::Minus };
        Wing { side, apex, apex_sign: left.times(sign_of(side)) }
    }

    /// `Greater` when the second half-plane is less than a half turn counterclockwise of the first, `Less` when
    /// clockwise, `Equal` when they are the same or opposite.
    fn turn(&self, first: Wing, second: Wing) -> Ordering {
        if first.apex == second.apex {
            return Ordering::Equal;
        }
        let [a, b] = self.ends;
        let sign = self.predicates.orientation([a, b, first.apex, second.apex]);
        if first.apex_sign == second.apex_sign { sign } else { sign.reverse() }
    }

    /// Whether two half-planes in one plane are the same.
    fn is_same(&self, first: Wing, second: Wing) -> bool {
        if first.apex == second.apex {
            return first.apex_sign == second.apex_sign;
        }
        let [a, b] = self.ends;
        let plane = self.planes.of(self.predicates, (first.side >> 1) as usize);
        let [x, y] = [first, second].map(|wing| plane.turn_along_axis(self.predicates, [a, b, wing.apex]));
        (x == y) == (first.apex_sign == second.apex_sign)
    }

    /// How far the second half-plane is from the first: 0 the same, 1 less than a half turn, 2 a half turn, 3 more.
    fn quarter(&self, first: Wing, second: Wing) -> u8 {
        match self.turn(first, second) {
            Ordering::Greater => 1,
            Ordering::Less => 3,
            Ordering::Equal if self.is_same(first, second) => 0,
            Ordering::Equal => 2,
        }
    }

    /// Sorts the sides at the edge from the first of them on; `Err` with two of the same half-plane.
    fn sort(&self, sides: &mut [u32], wings: &mut Vec<(u8, Wing)>) -> Result<(), [u32; 2]> {
        let Some((&first, rest)) = sides.split_first() else { return Ok(()) };
        let reference = self.wing(first);
        wings.clear();
        wings.extend(rest.iter().map(|&side| {
            let wing = self.wing(side);
            (self.quarter(reference, wing), wing)
        }));
        wings.sort_by(|(p, x), (q, y)| p.cmp(q).then_with(|| self.turn(*x, *y).reverse()));
        if let Some((_, wing)) = wings.first().filter(|(quarter, _)| *quarter == 0) {
            return Err([first, wing.side]);
        }
        let same =
            wings.windows(2).find(|pair| pair[0].0 == pair[1].0 && self.turn(pair[0].1, pair[1].1).is_eq());
        if let Some(pair) = same {
            return Err([pair[0].1.side, pair[1].1.side]);
        }
        for (place, (_, wing)) in sides[1..].iter_mut().zip(&*wings) {
            *place = wing.side;
        }
        Ok(())
    }

    /// The last of the sides, counterclockwise, before a half-plane that none of them is in. `sign` gives, for a
    /// vertex, the sign of the determinant of the edge, the vertex from the edge, and the direction of that half-plane.
    pub(super) fn last_before(&self, sides: &[u32], sign: impl Fn(u32) -> Ordering) -> u32 {
        // Counterclockwise from the half-plane: those with it less than a half turn behind them, opposite, the others.
        let class = |wing: Wing| {
            let sign = sign(wing.apex);
            if wing.apex_sign == Sign::Plus { sign } else { sign.reverse() }
        };
        let mut wings = sides.iter().map(|&side| self.wing(side)).map(|wing| (class(wing), wing));
        let mut last = wings.next().expect("the edge has a face");
        for (class, wing) in wings {
            if class > last.0 || class == last.0 && self.turn(last.1, wing).is_gt() {
                last = (class, wing);
            }
        }
        last.1.side
    }
}

/// The sides at each edge by rising faces: those between consecutive starts.
pub(super) struct SidesAtEdges {
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl SidesAtEdges {
    pub(super) fn new(complex: &PolygonalComplex) -> Self {
        let sides = complex.packed_sides();
        let mut starts = vec![0u32; complex.edge_count() + 1];
        sides.items().iter().for_each(|&side| starts[(side >> 1) as usize + 1] += 1);
        for edge in 0..complex.edge_count() {
            starts[edge + 1] += starts[edge];
        }
        let mut next = starts.clone();
        let mut items = vec![0; sides.item_count()];
        for (face, own) in (0u32..).zip(sides.iter()) {
            for &side in own {
                let place = &mut next[(side >> 1) as usize];
                items[*place as usize] = face << 1 | side & 1;
                *place += 1;
            }
        }
        Self { starts, items }
    }
}

impl RadialOrder {
    /// Sorts the faces around each edge, given by their sides, by signs of determinants only.
    ///
    /// # Errors
    /// `InvalidInput` naming an edge and two faces that leave it in the same direction. Each edge is a step.
    pub(super) fn new(
        complex: &PolygonalComplex,
        predicates: &impl SpatialPredicates,
        planes: &FacePlanes,
        sides: SidesAtEdges,
        steps: &Steps,
    ) -> Result<Self, Error> {
        let SidesAtEdges { starts, mut items } = sides;
        let mut blocks = Vec::with_capacity(complex.edge_count() / EDGES + 1);
        let mut rest = &mut items[..];
        for first in (0..complex.edge_count()).step_by(EDGES) {
            let block = &starts[first..=(first + EDGES).min(complex.edge_count())];
            let (own, after) = rest.split_at_mut((block[block.len() - 1] - block[0]) as usize);
            blocks.push((first, block, own));
            rest = after;
        }
        let sort = |edge: usize, list: &mut [u32], wings: &mut Vec<(u8, Wing)>| {
            // Two sides have only one order.
            let is_sorted = list.len() == 2 && predicates.points_of_line(edge as u32).is_some();
            if list.len() < 2 || is_sorted || predicates.sort_around(edge as u32, list) {
                return None;
            }
            let view = EdgeView::new(complex, predicates, planes, edge);
            view.sort(list, wings).err().map(|sides| (edge, sides))
        };
        let faults: Vec<(usize, [u32; 2])> = blocks
            .into_par_iter()
            .map(|(first, block, own)| {
                steps.advance(block.len() - 1);
                let (mut wings, mut faults) = (Vec::new(), Vec::new());
                for (edge, ends) in (first..).zip(block.windows(2)) {
                    let range = (ends[0] - block[0]) as usize..(ends[1] - block[0]) as usize;
                    faults.extend(sort(edge, &mut own[range], &mut wings));
                }
                faults
            })
            .flatten()
            .collect();
        let around = RaggedArray::from_parts(starts, items).expect("starts rise to the number of sides");
        if let Some(&(edge, sides)) = faults.first() {
            let mut faces = sides.map(|side| side >> 1);
            faces.sort_unstable();
            let [f, g] = faces;
            return Err(Error::invalid(format!(
                "faces f{f} and f{g} leave edge e{edge} in the same direction: they overlap"
            ))
            .with_cure("cut the faces against each other first, and give faces that coincide once"));
        }
        Ok(Self { around })
    }

    /// The sides at all edges.
    pub(super) fn lists(&self) -> &RaggedArray {
        &self.around
    }

    /// The sides at an edge, counterclockwise seen from its second end.
    pub(super) fn at(&self, edge: usize) -> &[u32] {
        self.around.list(edge)
    }
}
