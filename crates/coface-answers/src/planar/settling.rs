//! Edges between rounded points, cut and bent until they meet in their ends only; and coordinates as they are asked for.

use super::ArrangementMethod;
use crate::answer::{CongruentPieces, JoinedFeatures, Remark, RemarkCode, RoundingRepair};
use crate::near::{ThinCells, assumed_tolerance};
use crate::text;
use coface_algebra::{EdgeId, Error, FaceId, VertexId};
use coface_arrange::planar::{PlanarArrangement, SnappedArrangement};
use coface_geometry::Positions;

/// Edges that were cut and bent, with how far.
#[derive(Clone, Debug)]
pub(super) struct Settled {
    /// Its segments are the edges.
    pub(super) snapped: SnappedArrangement,
    pub(super) movement: Movement,
}

/// What moved to make rounded coordinates valid.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Movement {
    /// How many times coordinates were rounded.
    pub(super) rounds: usize,
    /// The vertices that became one with others, or went to another place.
    pub(super) moved: usize,
    /// How often edges were given a vertex.
    pub(super) bends: usize,
    /// The longest way of a vertex, and of a point of an edge that was given a vertex.
    pub(super) largest: f64,
    /// The faces that are not there any more.
    pub(super) vanished: usize,
}

impl Settled {
    pub(super) fn new(positions: &Positions, edges: &[[u32; 2]]) -> Result<Self, Error> {
        let drawn = PlanarArrangement::new(positions, edges)?;
        let snapped = drawn.snapped()?;
        let arrangement = snapped.arrangement();
        let at = |positions: &Positions, vertex: VertexId| {
            let point = positions.point(vertex);
            [point[0], point[1]]
        };
        let mut movement = Movement { rounds: snapped.round_count() + 1, ..Movement::default() };
        let mut is_taken = vec![false; arrangement.vertex_count()];
        for vertex in 0..positions.len() {
            let first = drawn.vertex_of_point(vertex).expect("nothing was pruned");
            let place = snapped.place(first);
            let [from, to] = [at(positions, VertexId::new(vertex)), at(arrangement.positions(), place)];
            let way = (to[0] - from[0]).hypot(to[1] - from[1]);
            let is_joined = std::mem::replace(&mut is_taken[place.index()], true);
            movement.moved += usize::from(is_joined || way > 0.0);
            movement.largest = movement.largest.max(way);
        }
        for (edge, pieces) in snapped.segments_of_edges().transposed(edges.len()).iter().enumerate() {
            movement.bends += pieces.len().saturating_sub(1);
            if pieces.len() > 1 {
                let line = edges[edge].map(|end| at(positions, VertexId::from_u32(end)));
                for &piece in pieces {
                    for end in arrangement.ends(EdgeId::from_u32(piece)) {
                        movement.largest =
                            movement.largest.max(distance(at(arrangement.positions(), end), line));
                    }
                }
            }
        }
        Ok(Self { snapped, movement })
    }
}

impl Movement {
    pub(super) fn answer(&self) -> RoundingRepair {
        RoundingRepair {
            rounds: self.rounds,
            bends: self.bends,
            moved: self.moved,
            largest_movement: self.largest,
            vanished: self.vanished,
        }
    }

    /// Says that something moved so that these stay valid.
    pub(super) fn remark(&self, what: &str) -> Remark {
        let mut parts = Vec::new();
        if self.bends > 0 {
            let verb = if self.bends == 1 { "was" } else { "were" };
            parts.push(format!("{} {verb} added to edges", text::count(self.bends, "vertex")));
        }
        if self.moved > 0 {
            parts.push(format!("{} moved or became one with others", text::count(self.moved, "vertex")));
        }
        let way = match self.largest {
            0.0 => "no point moved".to_owned(),
            way => format!("points moved by at most {way:.1e}"),
        };
        if self.vanished > 0 {
            parts.push(format!("{} thinner than that vanished", text::count(self.vanished, what)));
        }
        let how = if parts.is_empty() { "parts that touch were joined".to_owned() } else { parts.join(", ") };
        let message =
            format!("rounding the coordinates of {what}s would make edges cross or overlap, so {how}; {way}");
        let count = self.bends + self.moved + self.vanished;
        Remark::new(RemarkCode::FeaturesJoined, message).at(count.max(1), [])
    }
}

/// Where vertices are to be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placing {
    pub(super) snap: bool,
    pub(super) grid: Option<f64>,
    pub(super) tolerance: Option<f64>,
    pub(super) method: ArrangementMethod,
}

/// An arrangement with vertices where they were asked to be.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub(super) snapped: SnappedArrangement,
    /// How often coordinates were rounded, if that was asked for.
    pub(super) snap_rounds: Option<usize>,
    /// What was put together within a tolerance.
    pub(super) joined: Option<JoinedFeatures>,
    /// What congruence glued.
    pub(super) congruence: Option<CongruentPieces>,
    /// What was assumed, and what became of faces.
    pub(super) remarks: Vec<Remark>,
}

impl Placing {
    pub(super) fn is_asked(&self) -> bool {
        self.snap
            || self.grid.is_some()
            || self.tolerance.is_some()
            || self.method == ArrangementMethod::Congruence
    }

    /// # Errors
    /// `InvalidInput` for a step or a tolerance that is none, for both at once, and for congruence with a step, or with a tolerance in
    /// which all segments collapse.
    pub(super) fn of(&self, exact: &PlanarArrangement) -> Result<Placed, Error> {
        let vanished = |snapped: &SnappedArrangement| {
            exact.face_count().saturating_sub(snapped.arrangement().face_count())
        };
        let mut remarks = Vec::new();
        let mut tolerance = self.tolerance;
        if self.method == ArrangementMethod::Congruence && tolerance.is_none() {
            let (assumed, remark) = assumed_tolerance(exact.positions().as_flat(), 2);
            tolerance = Some(assumed);
            remarks.push(remark);
        }
        match (tolerance, self.grid) {
            (Some(_), Some(_)) => {
                Err(Error::invalid("a tolerance and a grid are two ways to put points together")
                    .with_cure("give one of both"))
            }
            (Some(tolerance), None) => {
                let snapped = match self.method {
                    ArrangementMethod::Exact => exact.within(tolerance)?,
                    ArrangementMethod::Congruence => exact.by_congruence(tolerance)?,
                };
                let joined =
                    snapped.joined().map(|joined| JoinedFeatures::of(joined, Some(vanished(&snapped))));
                let mut remark = joined.as_ref().and_then(|joined| joined.remark(true, "face"));
                let congruence = snapped.stacked().map(|stacked| CongruentPieces {
                    tolerance,
                    stacked_f_vector: stacked.f_vector.to_vec(),
                    largest_class_diameter: stacked.largest_class_diameter,
                    glued_f_vector: Vec::new(),
                    collapsed: stacked.collapsed.len(),
                });
                if let Some(collapsed) =
                    congruence.as_ref().map(|own| own.collapsed).filter(|&count| count > 0)
                {
                    if snapped.arrangement().edge_count() == 0 {
                        return Err(Error::invalid(format!(
                            "all segments collapse within the tolerance {tolerance:e}"
                        ))
                        .with_cure("give a smaller --tolerance"));
                    }
                    if let Some(remark) = &mut remark {
                        let segments = text::count(collapsed, "segment");
                        remark.message += &format!("; {segments} collapsed, no longer than that");
                    }
                }
                let snap_rounds = self.snap.then(|| snapped.round_count());
                remarks.extend(remark);
                Ok(Placed { snapped, snap_rounds, joined, congruence, remarks })
            }
            (None, grid) => {
                let snapped = match grid {
                    Some(step) => exact.snapped_to_grid(step)?,
                    None => exact.snapped()?,
                };
                remarks.extend(grid.and_then(|_| vanished_faces(exact, &snapped)));
                let snap_rounds = Some(snapped.round_count());
                Ok(Placed { snap_rounds, snapped, joined: None, congruence: None, remarks })
            }
        }
    }
}

/// Tells of faces thinner than a part of the extent that nobody means, and what would remove them.
pub(super) fn thin_faces(arrangement: &PlanarArrangement, areas: &[f64]) -> Option<Remark> {
    let flat = arrangement.positions().as_flat();
    let bounds = ThinCells::of(flat, 2);
    let at = |end: VertexId| [flat[2 * end.index()], flat[2 * end.index() + 1]];
    let suspects = areas.iter().enumerate().filter(|(_, area)| **area < bounds.largest_measure(2));
    let thickness = |(face, area): (usize, &f64)| {
        let walks = arrangement.walks(Some(FaceId::new(face)));
        let around: f64 = walks
            .flatten()
            .map(|&halfedge| {
                let [a, b] = arrangement.ends(EdgeId::from_u32(halfedge / 2)).map(at);
                (b[0] - a[0]).hypot(b[1] - a[1])
            })
            .sum();
        // A strip has twice its length around it.
        2.0 * area / around
    };
    let thin: Vec<f64> = suspects.map(thickness).filter(|&own| own < bounds.least()).collect();
    bounds.remark(&thin, "face")
}

/// Says that faces vanished because their vertices were put on a grid.
fn vanished_faces(exact: &PlanarArrangement, snapped: &SnappedArrangement) -> Option<Remark> {
    let [before, after] = [exact, snapped.arrangement()].map(PlanarArrangement::face_count);
    let count = before.checked_sub(after).filter(|&count| count > 0)?;
    let faces = text::count(count, "face");
    let message = format!("on the grid the arrangement has {after} of {before} faces: {faces} vanished");
    Some(Remark::new(RemarkCode::FeaturesJoined, message).at(count, []))
}

/// The distance of a point from a segment.
fn distance([x, y]: [f64; 2], [[ax, ay], [bx, by]]: [[f64; 2]; 2]) -> f64 {
    let [dx, dy] = [bx - ax, by - ay];
    let square = dx * dx + dy * dy;
    if square == 0.0 {
        return (x - ax).hypot(y - ay);
    }
    let part = (((x - ax) * dx + (y - ay) * dy) / square).clamp(0.0, 1.0);
    if part == 0.0 || part == 1.0 {
        let [ex, ey] = if part == 0.0 { [ax, ay] } else { [bx, by] };
        return (x - ex).hypot(y - ey);
    }
    ((x - ax) * dy - (y - ay) * dx).abs() / square.sqrt()
}
