//! Cells that lost their shape become several cells.
//!
//! The boundary of a cell is a cycle of its **facets**; facets meet in **ridges**. Where a ridge is in two facets of
//! the cell, these go on into each other. Where it is in more, as many facets leave the ridge as arrive, and the inside
//! of the cell is a number of wedges between them. The two facets of a wedge go on into each other; what is connected
//! in this way bounds one piece.
//!
//! Wedges are found from positions, for faces in the plane of their area vector and for solids around each edge. A
//! piece of the other orientation that lies within another piece is a hole or a void of it. Without positions a face
//! falls into closed walks that meet no vertex twice, and other cells into what is connected through ridges.

mod plane;
mod space;
mod walks;

use super::CellClasses;
use super::mapped::{Mapped, Piece};
use coface_algebra::{Sign, SparseMatrix, UnionFind};
use coface_geometry::Positions;
use plane::Plane;
use rayon::prelude::*;
use space::Space;

/// Coefficients beyond this are of no cell that could be drawn.
const MOST: u32 = 64;

/// What a cell is made of in the quotient so far.
pub(super) struct Rewrapping<'a> {
    /// The boundary matrices before, of degrees 1 to that of the cells.
    pub(super) before: &'a [SparseMatrix],
    /// The classes of cells of degrees 0 to that of the facets.
    pub(super) classes: &'a [CellClasses],
    /// The boundary matrices of the classes, of degrees 1 to that of the facets.
    pub(super) boundaries: &'a [SparseMatrix],
    /// The positions of the classes of vertices.
    pub(super) positions: Option<&'a Positions>,
}

/// Where the sides of wedges around ridges are, and how pieces lie in each other.
enum Frame {
    Plane(Plane),
    Space(Space),
}

/// One side of a wedge: a copy of a facet at a ridge.
struct Side {
    ridge: u32,
    angle: f64,
    /// The copy of a facet: a facet with coefficient m has m copies.
    copy: u32,
    /// Whether the inside comes after it, counterclockwise.
    is_opening: bool,
}

impl Rewrapping<'_> {
    /// The cells that lost facets or were joined to themselves, with their pieces; those that stay whole are left out.
    ///
    /// The cells looked at are those whose boundary has fewer terms than before, those with a facet that is several,
    /// and those with two ridges that became one.
    pub(super) fn pieces(&self, mapped: &Mapped) -> Vec<(u32, Vec<Piece>)> {
        (0..mapped.column_count())
            .into_par_iter()
            .filter_map(|cell| {
                let (rows, entries) = mapped.column(cell);
                if rows.is_empty() || !self.is_touched(cell, rows.len()) {
                    return None;
                }
                let pieces = self.split(cell, rows, entries)?;
                (pieces.len() > 1).then_some((cell as u32, pieces))
            })
            .collect()
    }

    fn degree(&self) -> usize {
        self.before.len()
    }

    fn is_touched(&self, cell: usize, term_count: usize) -> bool {
        let degree = self.degree();
        let facets = self.before[degree - 1].column(cell).rows();
        if term_count != facets.len() {
            return true;
        }
        let of_facets = &self.classes[degree - 1];
        if facets.iter().any(|&facet| of_facets.image_lists(facet as usize).0.len() != 1) {
            return true;
        }
        let mut ridges: Vec<u32> = Vec::with_capacity(4 * facets.len());
        for &facet in facets {
            ridges.extend_from_slice(self.before[degree - 2].column(facet as usize).rows());
        }
        ridges.sort_unstable();
        ridges.dedup();
        let of_ridges = &self.classes[degree - 2];
        let mut images: Vec<u32> = Vec::with_capacity(ridges.len());
        for &ridge in &ridges {
            images.extend_from_slice(of_ridges.image_lists(ridge as usize).0);
        }
        images.sort_unstable();
        images.windows(2).any(|pair| pair[0] == pair[1])
    }

    /// Whether the boundary of a cell was connected through ridges.
    fn was_connected(&self, cell: usize) -> bool {
        let degree = self.degree();
        let facets = self.before[degree - 1].column(cell).rows();
        let of_facets = &self.before[degree - 2];
        let mut ends: Vec<(u32, u32)> = Vec::new();
        for (i, &facet) in (0..).zip(facets) {
            ends.extend(of_facets.column(facet as usize).rows().iter().map(|&ridge| (ridge, i)));
        }
        ends.sort_unstable();
        let mut partition = UnionFind::new(facets.len());
        for pair in ends.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            partition.unite(pair[0].1, pair[1].1);
        }
        partition.class_count() <= 1
    }

    /// The pieces of a cell; `None` for one that has no meaning as a figure: with a facet without boundary, with great
    /// coefficients, or of several shells that nothing tells apart.
    fn split(&self, cell: usize, rows: &[u32], entries: &[i32]) -> Option<Vec<Piece>> {
        let degree = self.degree();
        let of_facets = &self.boundaries[degree - 2];
        let mut copies: Vec<(u32, Sign)> = Vec::with_capacity(rows.len());
        for (&row, &entry) in rows.iter().zip(entries) {
            let column = of_facets.column(row as usize);
            let is_great = |entry: i32| entry.unsigned_abs() > MOST;
            if column.rows().is_empty() || is_great(entry) || column.entries().iter().any(|&e| is_great(e)) {
                return None;
            }
            let sign = if entry < 0 { Sign::Minus } else { Sign::Plus };
            copies.extend((0..entry.unsigned_abs()).map(|_| (row, sign)));
        }
        let frame = self.positions.and_then(|positions| match degree {
            2 => Plane::new(of_facets, positions, rows, entries).map(Frame::Plane),
            3 => Space::new(&self.boundaries[0], of_facets, positions, rows, entries).map(Frame::Space),
            _ => None,
        });
        match frame {
            Some(frame) => Some(wedges(of_facets, &copies, &frame)),
            None if !self.was_connected(cell) => None,
            None if degree == 2 => walks::closed_walks(of_facets, &copies),
            None => Some(connected(of_facets, &copies)),
        }
    }
}

/// What is connected through ridges.
fn connected(of_facets: &SparseMatrix, copies: &[(u32, Sign)]) -> Vec<Piece> {
    let mut ends: Vec<(u32, u32)> = Vec::new();
    for (i, &(facet, _)) in (0..).zip(copies) {
        ends.extend(of_facets.column(facet as usize).rows().iter().map(|&ridge| (ridge, i)));
    }
    ends.sort_unstable();
    let mut partition = UnionFind::new(copies.len());
    for pair in ends.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        partition.unite(pair[0].1, pair[1].1);
    }
    in_order(groups(&mut partition).iter().map(|group| piece(copies, group)).collect())
}

/// What is connected through wedges, each with its holes.
fn wedges(of_facets: &SparseMatrix, copies: &[(u32, Sign)], frame: &Frame) -> Vec<Piece> {
    let mut sides: Vec<Side> = Vec::new();
    for (copy, &(facet, sign)) in (0..).zip(copies) {
        for (ridge, entry) in of_facets.column(facet as usize).iter() {
            let incidence = entry * sign.to_i32() * frame.orientation().to_i32();
            let side = |_| Side { ridge: ridge as u32, angle: 0.0, copy, is_opening: incidence < 0 };
            sides.extend((0..entry.unsigned_abs()).map(side));
        }
    }
    sides.sort_unstable_by_key(|side| (side.ridge, side.copy));
    let mut partition = UnionFind::new(copies.len());
    let (mut open, mut unmatched) = (Vec::new(), Vec::new());
    for around in sides.chunk_by_mut(|a, b| a.ridge == b.ridge) {
        if around.len() > 2 {
            for side in &mut *around {
                side.angle = frame.angle(side.ridge, copies[side.copy as usize].0);
            }
            // Where angles are equal, facets are in the order of their numbers.
            around.sort_by(|a, b| a.angle.total_cmp(&b.angle).then(a.copy.cmp(&b.copy)));
        }
        // As brackets in a circle: each side where a wedge opens goes with the next one where it closes.
        for side in &*around {
            if side.is_opening {
                open.push(side.copy);
            } else if let Some(other) = open.pop() {
                partition.unite(other, side.copy);
            } else {
                unmatched.push(side.copy);
            }
        }
        for copy in unmatched.drain(..) {
            if let Some(other) = open.pop() {
                partition.unite(other, copy);
            }
        }
        open.clear();
    }
    let groups = groups(&mut partition);
    if groups.len() == 1 {
        return vec![piece(copies, &groups[0])];
    }
    let mut parts: Vec<(Vec<u32>, f64)> = groups
        .into_iter()
        .map(|group| {
            let measure = group.iter().map(|&copy| frame.measure(copies[copy as usize])).sum();
            (group, measure)
        })
        .collect();
    // The smallest first, so that a hole goes to the smallest part around it.
    parts.sort_by(|a, b| a.1.abs().total_cmp(&b.1.abs()).then_with(|| a.0.cmp(&b.0)));
    let mut partition = UnionFind::new(parts.len());
    for (i, (hole, measure)) in parts.iter().enumerate().filter(|(_, (_, measure))| *measure < 0.0) {
        let around = (i + 1..parts.len()).find(|&j| {
            let (whole, own) = &parts[j];
            *own > -measure && is_within(hole, whole, copies, frame)
        });
        if let Some(j) = around {
            partition.unite(i as u32, j as u32);
        }
    }
    let united = self::groups(&mut partition);
    let pieces = united.iter().map(|together| {
        let all: Vec<u32> =
            together.iter().flat_map(|&part| parts[part as usize].0.iter().copied()).collect();
        piece(copies, &all)
    });
    in_order(pieces.collect())
}

/// Whether a part lies within another one: the middle of that facet, of those that are not of both, whose middle is the
/// lowest by coordinates.
fn is_within(hole: &[u32], whole: &[u32], copies: &[(u32, Sign)], frame: &Frame) -> bool {
    let facet = |copy: &u32| copies[*copy as usize].0;
    let mut of_whole: Vec<u32> = whole.iter().map(facet).collect();
    of_whole.sort_unstable();
    let middles = hole
        .iter()
        .map(facet)
        .filter(|facet| of_whole.binary_search(facet).is_err())
        .map(|facet| frame.middle(facet));
    let lowest = middles.min_by(|p, q| {
        let [first, second, third] = [0, 1, 2].map(|axis| p[axis].total_cmp(&q[axis]));
        first.then(second).then(third)
    });
    lowest.is_some_and(|point| frame.contains(whole.iter().map(|&copy| copies[copy as usize]), point))
}

impl Frame {
    /// Minus if the boundary runs the other way than the frame.
    fn orientation(&self) -> Sign {
        match self {
            Self::Plane(_) => Sign::Plus,
            Self::Space(space) => space.orientation(),
        }
    }

    /// A number that grows with the angle of a facet around a ridge.
    fn angle(&self, ridge: u32, facet: u32) -> f64 {
        match self {
            Self::Plane(plane) => plane.angle(ridge, facet),
            Self::Space(space) => space.angle(ridge, facet),
        }
    }

    /// What a facet contributes to the area or volume.
    fn measure(&self, (facet, sign): (u32, Sign)) -> f64 {
        let measure = match self {
            Self::Plane(plane) => plane.measure(facet),
            Self::Space(space) => space.measure(facet),
        };
        measure * f64::from(sign.to_i32())
    }

    /// The middle of a facet; in the plane with a third coordinate of zero.
    fn middle(&self, facet: u32) -> [f64; 3] {
        match self {
            Self::Plane(plane) => plane.middle(facet),
            Self::Space(space) => space.middle(facet),
        }
    }

    /// Whether a point is within a closed boundary.
    fn contains(&self, boundary: impl Iterator<Item = (u32, Sign)>, point: [f64; 3]) -> bool {
        match self {
            Self::Plane(plane) => plane.contains(boundary, point),
            Self::Space(space) => space.contains(boundary, point),
        }
    }
}

/// A number that grows with the angle of a vector, counterclockwise from the negative first axis: -2 to 2. It needs no
/// more than sums and quotients, so it is the same on every machine.
fn pseudo_angle(x: f64, y: f64) -> f64 {
    let length = x.abs() + y.abs();
    if length == 0.0 {
        return 0.0;
    }
    let slope = x / length;
    if y < 0.0 { slope - 1.0 } else { 1.0 - slope }
}

/// The members of each class.
fn groups(partition: &mut UnionFind) -> Vec<Vec<u32>> {
    let mut groups = vec![Vec::new(); partition.class_count()];
    for (member, class) in (0..).zip(partition.class_numbers()) {
        groups[class as usize].push(member);
    }
    groups
}

/// Copies of facets as a boundary.
fn piece(copies: &[(u32, Sign)], group: &[u32]) -> Piece {
    let mut facets: Vec<(u32, i32)> =
        group.iter().map(|&copy| copies[copy as usize]).map(|(facet, sign)| (facet, sign.to_i32())).collect();
    facets.sort_unstable();
    let mut piece: Piece = Vec::with_capacity(facets.len());
    for (facet, sign) in facets {
        match piece.last_mut() {
            Some(last) if last.0 == facet => last.1 += sign,
            _ => piece.push((facet, sign)),
        }
    }
    piece
}

fn in_order(mut pieces: Vec<Piece>) -> Vec<Piece> {
    pieces.sort_unstable();
    pieces
}

/// Tail and head of an edge; `None` for what is no edge.
fn ends(edges: &SparseMatrix, edge: u32) -> Option<[u32; 2]> {
    let column = edges.column(edge as usize);
    match (column.rows(), column.entries()) {
        (&[tail, head], [-1, 1]) | (&[head, tail], [1, -1]) => Some([tail, head]),
        _ => None,
    }
}
