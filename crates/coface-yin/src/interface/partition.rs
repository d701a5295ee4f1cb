//! The arcs between the phases that sets are.

use super::DirectedEdge;
use super::graph::Arcs;
use super::overlaid::Overlaid;
use crate::boolean::first_covering;
use crate::{Curve, Order, YinSet};
use coface_algebra::{EdgeId, Error, Sign};
use coface_arrange::planar::RingCells;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// Where points go that several sets have in common.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Overlaps {
    /// Nowhere: sets that overlap are an error.
    #[default]
    Refused,
    /// To the set that comes first.
    ToTheFirst,
    /// To the set that comes last.
    ToTheLast,
}

/// The arcs between phases before anything is fitted.
pub(super) struct Partition {
    /// Without smooth pairs.
    pub(super) arcs: Arcs,
    pub(super) curves: Vec<Curve<'static>>,
    pub(super) around: Vec<Vec<DirectedEdge>>,
    /// The vertices through which nothing goes on smoothly.
    pub(super) is_kink: Vec<bool>,
    /// The order of the curves.
    pub(super) order: Order,
}

impl Partition {
    /// The partition in which each set is the phase with this number, or none.
    ///
    /// # Errors
    /// For sets that overlap, unless it is said to which of them their common points go; if the boundaries cannot be laid over each other.
    pub(super) fn new(sets: &[&YinSet], names: &[Option<u32>], overlaps: Overlaps) -> Result<Self, Error> {
        let overlaid = Overlaid::new(sets)?;
        let cells = overlaid.cells();
        let Some(owners) = phases_of_faces(cells, sets, overlaps) else { return Err(overlap(sets)?) };
        let phases: Vec<Option<u32>> = owners.into_iter().map(|set| names[set? as usize]).collect();
        let face_count = phases.len() - 1;
        let phase = |halfedge: u32| phases[(cells.face(halfedge) as usize).min(face_count)];
        let is_kept = |halfedge: u32| phase(halfedge) != phase(halfedge ^ 1);
        let leaving = |node: u32| {
            cells
                .orbits()
                .rotation()
                .list(node as usize)
                .iter()
                .copied()
                .filter(|&halfedge| is_kept(halfedge))
        };
        let node_is_kink = overlaid.kink_nodes();
        // The halfedge by which the way goes on smoothly where nothing else ends.
        let next = |halfedge: u32| {
            let node = cells.tail(halfedge ^ 1);
            if node_is_kink[node as usize] || leaving(node).count() != 2 {
                return None;
            }
            let after = leaving(node).find(|&after| after != halfedge ^ 1)?;
            overlaid.goes_on(halfedge, after).then_some(after)
        };
        let halfedge_count = 2 * cells.edges().ends().len() as u32;
        let mut is_used = vec![false; cells.edges().ends().len()];
        let mut found = Self {
            arcs: Arcs {
                vertices: Vec::new(),
                ends: Vec::new(),
                phases: Vec::new(),
                smooth_pairs: Vec::new(),
            },
            curves: Vec::new(),
            around: Vec::new(),
            is_kink: Vec::new(),
            order: sets.iter().map(|set| set.order()).max().unwrap_or(Order::LINEAR),
        };
        let mut vertex_of_node = vec![NONE; cells.orbits().rotation().len()];
        let mut edge_of_halfedge = vec![None; halfedge_count as usize];
        // First the ways that begin where others end, then what is closed.
        for is_closed in [false, true] {
            for first in 0..halfedge_count {
                if is_used[first as usize / 2] || !is_kept(first) || (!is_closed && next(first ^ 1).is_some())
                {
                    continue;
                }
                let mut way = vec![first];
                is_used[first as usize / 2] = true;
                while let Some(after) = next(way[way.len() - 1]).filter(|&after| after != first) {
                    is_used[after as usize / 2] = true;
                    way.push(after);
                }
                let last = way[way.len() - 1];
                let ends = [first, last ^ 1].map(|halfedge| {
                    let node = cells.tail(halfedge);
                    let vertex = &mut vertex_of_node[node as usize];
                    if *vertex == NONE {
                        *vertex = found.arcs.vertices.len() as u32;
                        found.arcs.vertices.push([0.0; 2]);
                        // At junctions phases have corners, though the way may go on smoothly.
                        found.is_kink.push(!is_closed && leaving(node).count() == 2);
                    }
                    *vertex
                });
                let edges = found.push(&overlaid, &way, ends, [phase(first), phase(first ^ 1)]);
                edge_of_halfedge[first as usize] = Some(DirectedEdge::along(EdgeId::from_u32(edges.start)));
                edge_of_halfedge[last as usize ^ 1] =
                    Some(DirectedEdge::against(EdgeId::from_u32(edges.end - 1)));
            }
        }
        found.around = vec![Vec::new(); found.arcs.vertices.len()];
        for (node, &vertex) in (0..).zip(&vertex_of_node).filter(|(_, vertex)| **vertex != NONE) {
            found.around[vertex as usize] =
                leaving(node).filter_map(|halfedge| edge_of_halfedge[halfedge as usize]).collect();
        }
        for edge in 0..found.curves.len() as u32 {
            for sign in [Sign::Plus, Sign::Minus] {
                let vertex = found.arcs.ends[edge as usize][usize::from(sign == Sign::Minus)] as usize;
                let own = DirectedEdge { edge: EdgeId::from_u32(edge), sign };
                if !found.around[vertex].contains(&own) && found.around[vertex].len() < 2 {
                    found.around[vertex].push(own);
                }
            }
        }
        Ok(found)
    }

    /// Adds the edges along a way, which ends at kinks.
    fn push(
        &mut self,
        overlaid: &Overlaid<'_>,
        way: &[u32],
        ends: [u32; 2],
        phases: [Option<u32>; 2],
    ) -> std::ops::Range<u32> {
        let (mut controls, mut knots, mut cuts) = (Vec::<[f64; 2]>::new(), vec![0.0], vec![0]);
        for &halfedge in way {
            let (arc, kinks) = overlaid.arc(halfedge / 2);
            let count = arc.piece_count();
            let first = knots.len() - 1;
            controls.pop();
            let own = arc.knots();
            let mut at: f64 = knots[first];
            if halfedge.is_multiple_of(2) {
                controls.extend_from_slice(arc.controls());
                cuts.extend(kinks.iter().map(|kink| first + kink));
            } else {
                controls.extend(arc.controls().iter().rev());
                cuts.extend(kinks.iter().rev().map(|kink| first + count - kink));
            }
            knots.extend((0..count).map(|piece| {
                let piece = if halfedge.is_multiple_of(2) { piece } else { count - 1 - piece };
                at = (at + (own[piece + 1] - own[piece])).max(at.next_up());
                at
            }));
        }
        cuts.push(knots.len() - 1);
        let degree = self.order.degree();
        let start = self.curves.len() as u32;
        for (number, cut) in cuts.windows(2).enumerate() {
            let [from, to] = [cut[0], cut[1]];
            let own_controls = controls[from * degree..=to * degree].to_vec();
            let own_knots: Vec<f64> = knots[from..=to].iter().map(|knot| knot - knots[from]).collect();
            let mut end = |at: usize, is_last: bool| {
                let vertex = if number == 0 && !is_last {
                    ends[0]
                } else if number + 2 == cuts.len() && is_last {
                    ends[1]
                } else {
                    // The end of one part is the beginning of the next.
                    if is_last {
                        self.arcs.vertices.push([0.0; 2]);
                        self.is_kink.push(true);
                    }
                    self.arcs.vertices.len() as u32 - 1
                };
                self.arcs.vertices[vertex as usize] = controls[at * degree];
                vertex
            };
            let own_ends = [end(from, false), end(to, true)];
            self.arcs.ends.push(own_ends);
            self.arcs.phases.push(phases);
            self.curves.push(Curve::from_trusted(self.order, own_controls, own_knots));
        }
        start..self.curves.len() as u32
    }

    /// The knots of the edges, none twice in a row.
    pub(super) fn points(&self) -> Vec<Vec<[f64; 2]>> {
        let knots = |curve: &Curve<'_>| {
            let mut points: Vec<[f64; 2]> =
                (0..=curve.piece_count()).map(|at| curve.knot_point(at)).collect();
            // Rounding may have brought points together.
            points.dedup();
            points
        };
        self.curves.iter().map(knots).collect()
    }
}

/// The set that each face is in, the unbounded one last; none if sets overlap and must not.
fn phases_of_faces(cells: &RingCells, sets: &[&YinSet], overlaps: Overlaps) -> Option<Vec<Option<u32>>> {
    let unbounded = unbounded(sets);
    let face_count = cells.face_count() as u32;
    let phase = |windings: &[(u32, i32)]| {
        let mut inside = inside(sets, &unbounded, windings);
        match overlaps {
            Overlaps::Refused => {
                let first = inside.next();
                if inside.next().is_some() { Err(()) } else { Ok(first) }
            }
            Overlaps::ToTheFirst => Ok(inside.min()),
            Overlaps::ToTheLast => Ok(inside.max()),
        }
    };
    let faces = (0..face_count).map(|face| phase(cells.windings().of_face(face)));
    faces.chain([phase(&[])]).collect::<Result<_, ()>>().ok()
}

fn unbounded(sets: &[&YinSet]) -> Vec<u32> {
    (0..).zip(sets).filter(|(_, set)| !set.is_bounded()).map(|(number, _)| number).collect()
}

/// The sets that a face is in, in no order.
fn inside<'a>(
    sets: &'a [&YinSet],
    unbounded: &'a [u32],
    windings: &'a [(u32, i32)],
) -> impl Iterator<Item = u32> + 'a {
    let wound =
        windings.iter().filter(|&&(set, winding)| winding >= i32::from(sets[set as usize].is_bounded()));
    let others = unbounded.iter().copied().filter(|set| windings.iter().all(|(own, _)| own != set));
    wound.map(|&(set, _)| set).chain(others)
}

/// The error for sets that overlap.
fn overlap(sets: &[&YinSet]) -> Result<Error, Error> {
    let unbounded = unbounded(sets);
    let found = first_covering(sets, |windings| inside(sets, &unbounded, windings).nth(1).is_some())?;
    let Some(found) = found else { return Ok(Error::invalid("sets overlap")) };
    let mut both: Vec<u32> = inside(sets, &unbounded, &found.windings).collect();
    both.sort_unstable();
    let place = match found.point {
        Some([x, y]) => format!(" at ({x}, {y})"),
        None => String::new(),
    };
    let area = match found.area {
        Some(area) => format!("an area of {area}"),
        None => "an infinite area".to_owned(),
    };
    Ok(Error::invalid(format!("sets {} and {} overlap{place}, in {area}", both[0], both[1]))
        .with_cure("give sets that do not overlap, or say to which of them common points go"))
}
