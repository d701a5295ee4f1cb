//! Polygons of loops: their sides, and canonical loops drawn beside them.

use super::strands::Disks;
use coface_algebra::HalfedgeId;
use coface_complexes::surface::GeneralizedMap;

const NONE: u32 = u32::MAX;

/// A loop crosses an edge: at a point, out of the face of a side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub(super) point: u32,
    pub(super) side: HalfedgeId,
}

/// A loop that is still a side of the polygon.
#[derive(Clone, Debug)]
struct Loop {
    crossings: Vec<Crossing>,
    /// At each crossing whether the first flank of the loop is towards the end of the edge.
    flanks: Vec<bool>,
}

/// A side of the polygon: a loop, its direction, and on which flank of the loop the polygon lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct PolygonSide {
    number: usize,
    is_reversed: bool,
    is_second_flank: bool,
}

impl PolygonSide {
    fn reversed(self) -> Self {
        Self { is_reversed: !self.is_reversed, ..self }
    }
}

/// A surface cut along loops at one vertex, from which crosscaps and handles are cut off one by one.
///
/// What is left is a polygon; loops that are cut off stand before it. A loop crosses edges at points, which are in order along each edge.
/// A loop that is drawn beside sides of the polygon gets new points next to theirs, so that it lies between them and all that was
/// drawn before. So the points of any two loops tell how to draw them disjoint.
///
/// # References
/// G. Vegter, C. K. Yap, *Computational complexity of combinatorial surfaces* (1990); F. Lazarus, M. Pocchiola, G. Vegter,
/// A. Verroust, *Computing a canonical polygonal schema of an orientable triangulated surface* (2001). There, as here, the sides of
/// the polygon that is left never become longer.
#[derive(Debug)]
pub(super) struct Schema<'m> {
    map: &'m GeneralizedMap,
    loops: Vec<Loop>,
    polygon: Vec<PolygonSide>,
    /// For each point the points before and after it on its edge.
    neighbors: Vec<[u32; 2]>,
    /// The loops that were cut off.
    cut_off: Vec<Vec<Crossing>>,
}

/// How many of the sides are tried as the first one of a handle.
const TRIED: usize = 24;

impl<'m> Schema<'m> {
    /// One loop for each of the edges around a disk, crossing it once; `around` are their sides in order.
    pub(super) fn new(
        map: &'m GeneralizedMap,
        disks: &Disks<'_>,
        around: &[HalfedgeId],
        numbers: &[u32],
    ) -> Self {
        let number = |side: HalfedgeId| numbers[map.edge(side).index()] as usize;
        let mut places = vec![[NONE; 2]; around.len() / 2];
        for (place, &side) in around.iter().enumerate() {
            let own = &mut places[number(side)];
            own[usize::from(own[0] != NONE)] = place as u32;
        }
        let loops = (places.iter().zip(0..))
            .map(|(own, point)| Loop {
                crossings: vec![Crossing { point, side: around[own[0] as usize] }],
                flanks: vec![true],
            })
            .collect();
        // Around the polygon: out along the last loop end with the corner of all other faces to its left.
        let mut polygon = Vec::with_capacity(around.len());
        let count = around.len();
        let (mut place, mut is_left) = (count.wrapping_sub(1), true);
        while polygon.len() < count {
            let side = around[place];
            let own = places[number(side)].map(|place| place as usize);
            let is_towards_end = disks.runs_along(side) == is_left;
            polygon.push(PolygonSide {
                number: number(side),
                is_reversed: own[0] != place,
                is_second_flank: !is_towards_end,
            });
            let back = own[usize::from(own[0] == place)];
            // Coming back the left is at the start of the side.
            is_left = disks.runs_along(around[back]) != is_towards_end;
            place = if is_left { (back + count - 1) % count } else { (back + 1) % count };
        }
        let neighbors = vec![[NONE; 2]; places.len()];
        Self { map, loops, polygon, neighbors, cut_off: Vec::new() }
    }

    /// Cuts off all crosscaps, or all handles of an orientable surface.
    pub(super) fn normalize(&mut self) {
        let mates = self.mates();
        if (0..self.polygon.len()).any(|place| self.is_twisted(&mates, place)) {
            while self.cut_crosscap() {}
        } else {
            while self.cut_handle() {}
        }
    }

    /// For each place around the polygon that of the same loop.
    fn mates(&self) -> Vec<usize> {
        let mut first = vec![usize::MAX; self.loops.len()];
        let mut mates = vec![0; self.polygon.len()];
        for (place, side) in self.polygon.iter().enumerate() {
            let own = &mut first[side.number];
            if *own == usize::MAX {
                *own = place;
            } else {
                (mates[place], mates[*own]) = (*own, place);
            }
        }
        mates
    }

    fn is_twisted(&self, mates: &[usize], place: usize) -> bool {
        self.polygon[place].is_reversed == self.polygon[mates[place]].is_reversed
    }

    /// Whether a loop is left that reverses orientation when the one at this place is cut off: those that it separates change their kind.
    fn stays_twisted(&self, mates: &[usize], place: usize) -> bool {
        let (i, j) = (place, mates[place]);
        (0..self.polygon.len()).filter(|&k| k != i && k != j).any(|k| {
            let separates = (i < k && k < j) != (i < mates[k] && mates[k] < j);
            self.is_twisted(mates, k) != separates
        })
    }

    /// The crossings of a loop in a direction.
    fn crossings(&self, crossings: &[Crossing], is_reversed: bool) -> Vec<Crossing> {
        if !is_reversed {
            return crossings.to_vec();
        }
        let back = |crossing: &Crossing| Crossing {
            side: self.map.mate(crossing.side).expect("loops cross edges inside the surface"),
            ..*crossing
        };
        crossings.iter().rev().map(back).collect()
    }

    /// The loop of a side, in its direction.
    fn along(&self, side: PolygonSide) -> Vec<Crossing> {
        self.crossings(&self.loops[side.number].crossings, side.is_reversed)
    }

    /// A new point next to a point.
    fn point_beside(&mut self, point: u32, towards_end: bool) -> u32 {
        let new = self.neighbors.len() as u32;
        let slot = usize::from(towards_end);
        let other = std::mem::replace(&mut self.neighbors[point as usize][slot], new);
        let mut own = [point; 2];
        own[slot] = other;
        if other != NONE {
            self.neighbors[other as usize][1 - slot] = new;
        }
        self.neighbors.push(own);
        new
    }

    /// A strand beside sides of the polygon, in their direction; nearer to them than all others.
    fn beside(&mut self, sides: &[PolygonSide]) -> Vec<Crossing> {
        let mut strand = Vec::new();
        for &side in sides {
            let count = self.loops[side.number].crossings.len();
            for i in 0..count {
                let at = if side.is_reversed { count - 1 - i } else { i };
                let own = &self.loops[side.number];
                let (Crossing { point, side: out }, flank) = (own.crossings[at], own.flanks[at]);
                let point = self.point_beside(point, flank != side.is_second_flank);
                let mate = self.map.mate(out).expect("loops cross edges inside the surface");
                strand.push(Crossing { point, side: if side.is_reversed { mate } else { out } });
            }
        }
        strand
    }

    /// The same against their direction.
    fn back_beside(&mut self, sides: &[PolygonSide]) -> Vec<Crossing> {
        let strand = self.beside(sides);
        self.crossings(&strand, true)
    }

    /// Cuts off a crosscap: of Z b X b T the loop c = Z b X Z^-1 with c c, which leaves Z X^-1 T.
    fn cut_crosscap(&mut self) -> bool {
        let mates = self.mates();
        let count = self.polygon.len();
        let twisted = (0..count).filter(|&place| place < mates[place] && self.is_twisted(&mates, place));
        let mut cheap: Vec<(usize, usize)> = twisted.map(|place| (place + mates[place], place)).collect();
        cheap.sort_unstable();
        let Some(&(_, any)) = cheap.first() else { return false };
        let kept = cheap.iter().map(|&(_, place)| place).find(|&place| self.stays_twisted(&mates, place));
        let first = match kept {
            Some(first) => first,
            None if count == 2 => any,
            None => {
                self.merge(any, mates[any]);
                return true;
            }
        };
        let second = mates[first];
        let polygon = std::mem::take(&mut self.polygon);
        let (z, x, t) = (&polygon[..first], &polygon[first + 1..second], &polygon[second + 1..]);
        let out = self.beside(z);
        let back = self.back_beside(z);
        let across = self.beside(x);
        self.cut_off.push([out, self.along(polygon[first]), across, back].concat());
        let turned = x.iter().rev().map(|side| side.reversed());
        self.polygon = z.iter().copied().chain(turned).chain(t.iter().copied()).collect();
        true
    }

    /// Replaces a loop b that reverses orientation by r = b a, or a b, with a loop a next to it that does not: then both do.
    fn merge(&mut self, first: usize, second: usize) {
        let mut polygon = std::mem::take(&mut self.polygon);
        let count = polygon.len();
        // Where b is next to a, and the other b.
        let (at, other, is_after) = if first + 1 < second {
            (first, second, true)
        } else if second + 1 < count {
            (second, first, true)
        } else {
            (first, second, false)
        };
        let b = polygon[at];
        let a = polygon[if is_after { at + 1 } else { at - 1 }];
        let strand = self.beside(&[a]);
        let flank = |schema: &Self, side: PolygonSide| -> Vec<bool> {
            let flanks = schema.loops[side.number].flanks.iter().map(|&flank| flank != side.is_second_flank);
            if side.is_reversed { flanks.rev().collect() } else { flanks.collect() }
        };
        let (of_b, of_a) = (self.along(b), (strand, flank(self, a)));
        let of_b = (of_b, flank(self, b));
        let parts = if is_after { [of_b, of_a] } else { [of_a, of_b] };
        let [(mut crossings, mut flanks), (more, more_flanks)] = parts;
        crossings.extend(more);
        flanks.extend(more_flanks);
        self.loops[b.number] = Loop { crossings, flanks };
        let merged = PolygonSide { number: b.number, is_reversed: false, is_second_flank: false };
        polygon[at] = merged;
        polygon[other] = PolygonSide { is_second_flank: true, ..merged };
        // The other b is r a^-1, or a^-1 r.
        let gone = if is_after { at + 1 } else { at - 1 };
        polygon.remove(gone);
        let other = if gone < other { other - 1 } else { other };
        polygon.insert(if is_after { other + 1 } else { other }, a.reversed());
        self.polygon = polygon;
    }

    /// The handle that is cheap to cut off: places of a, b, a^-1, b^-1 in the polygon.
    fn cheap_handle(&self, mates: &[usize]) -> Option<[usize; 4]> {
        let mut best: Option<(usize, [usize; 4])> = None;
        for first in 0..self.polygon.len().min(TRIED) {
            let third = mates[first];
            let ends = mates.iter().copied().enumerate().take(third).skip(first + 1);
            for (second, fourth) in ends.filter(|&(_, fourth)| fourth > third) {
                let (z, p, q, s) = (first, second - first, third - second, fourth - third);
                let cost = 4 * z + p + 2 * q + 3 * s;
                if best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, [first, second, third, fourth]));
                }
            }
        }
        best.map(|(_, places)| places)
    }

    /// Cuts off a handle: of Z a P b Q a^-1 S b^-1 T the loops z = Z a Q^-1 S^-1 Z^-1 and v = Z S Q P b S^-1 Z^-1 with
    /// z v z^-1 v^-1, which leaves Z S Q P T.
    fn cut_handle(&mut self) -> bool {
        let mates = self.mates();
        let Some([first, second, third, fourth]) = self.cheap_handle(&mates) else {
            assert!(self.polygon.is_empty(), "all corners of the polygon are one vertex");
            return false;
        };
        let polygon = std::mem::take(&mut self.polygon);
        let (z, p, q) = (&polygon[..first], &polygon[first + 1..second], &polygon[second + 1..third]);
        let (s, t) = (&polygon[third + 1..fourth], &polygon[fourth + 1..]);
        // From far to near.
        let z_out = self.beside(z);
        let v_back = self.back_beside(z);
        let z_back = self.back_beside(z);
        let v_out = self.beside(z);
        let v_end = self.back_beside(s);
        let z_end = self.back_beside(s);
        let v_start = self.beside(s);
        let z_middle = self.back_beside(q);
        let v_middle = self.beside(q);
        let v_next = self.beside(p);
        let [a, b] = [first, second].map(|place| self.along(polygon[place]));
        self.cut_off.push([z_out, a, z_middle, z_end, z_back].concat());
        self.cut_off.push([v_out, v_start, v_middle, v_next, b, v_end, v_back].concat());
        self.polygon = [z, s, q, p, t].concat();
        true
    }

    /// For each loop of the beginning the points on its edge, from the start of the edge to its end.
    fn points(&self) -> Vec<Vec<u32>> {
        let along = |start: u32| {
            let mut first = start;
            while self.neighbors[first as usize][0] != NONE {
                first = self.neighbors[first as usize][0];
            }
            let next = |&point: &u32| Some(self.neighbors[point as usize][1]).filter(|&next| next != NONE);
            std::iter::successors(Some(first), next).collect()
        };
        (0..self.loops.len() as u32).map(along).collect()
    }

    /// The loops that were cut off, without turns at edges that they cross and cross back.
    pub(super) fn finish(mut self) -> CanonicalLoops {
        let points = self.points();
        let is_kept = self.straighten();
        let mut numbers = vec![NONE; is_kept.len()];
        let mut point_count = 0;
        for (number, _) in numbers.iter_mut().zip(&is_kept).filter(|(_, is_kept)| **is_kept) {
            *number = point_count;
            point_count += 1;
        }
        let kept = |&point: &u32| Some(numbers[point as usize]).filter(|&number| number != NONE);
        CanonicalLoops {
            points: points.iter().map(|list| list.iter().filter_map(kept).collect()).collect(),
            point_count: point_count as usize,
            loops: (self.cut_off.iter())
                .map(|own| {
                    let kept =
                        own.iter().filter_map(|crossing| Some((kept(&crossing.point)?, crossing.side)));
                    kept.map(|(point, side)| Crossing { point, side }).collect()
                })
                .collect(),
        }
    }

    /// Removes the two points of each turn at an edge: the innermost ones first, next to each other on the edge. Which points stay.
    fn straighten(&mut self) -> Vec<bool> {
        let mut is_kept = vec![true; self.neighbors.len()];
        let mut sides = vec![HalfedgeId::new(0); is_kept.len()];
        // The points before and after each point along its loop.
        let mut along = vec![[NONE; 2]; is_kept.len()];
        for own in &self.cut_off {
            own.iter().for_each(|crossing| sides[crossing.point as usize] = crossing.side);
            for pair in own.windows(2) {
                let [a, b] = [pair[0].point, pair[1].point];
                (along[a as usize][1], along[b as usize][0]) = (b, a);
            }
        }
        let link = |lists: &mut Vec<[u32; 2]>, [before, after]: [u32; 2]| {
            if before != NONE {
                lists[before as usize][1] = after;
            }
            if after != NONE {
                lists[after as usize][0] = before;
            }
        };
        let mut open: Vec<u32> = (0..is_kept.len() as u32).collect();
        while let Some(point) = open.pop() {
            let next = self.neighbors[point as usize][1];
            if next == NONE || !is_kept[point as usize] {
                continue;
            }
            let [a, b] = if along[point as usize][1] == next { [point, next] } else { [next, point] };
            let is_turn =
                along[a as usize][1] == b && self.map.mate(sides[a as usize]) == Some(sides[b as usize]);
            if !is_turn {
                continue;
            }
            (is_kept[a as usize], is_kept[b as usize]) = (false, false);
            let around = [along[a as usize][0], along[b as usize][1]];
            link(&mut along, around);
            let around = [self.neighbors[point as usize][0], self.neighbors[next as usize][1]];
            link(&mut self.neighbors, around);
            open.extend(around.into_iter().filter(|&point| point != NONE));
        }
        is_kept
    }
}

/// Canonical loops as they cross edges.
#[derive(Debug)]
pub(super) struct CanonicalLoops {
    /// For each edge that the first loops cross the points on it, from its start to its end.
    pub(super) points: Vec<Vec<u32>>,
    pub(super) point_count: usize,
    pub(super) loops: Vec<Vec<Crossing>>,
}
