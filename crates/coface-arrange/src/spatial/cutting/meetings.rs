//! Where sheets meet: pairs of sheets, decided by signs of given points alone.

use super::sheets::Sheets;
use crate::spatial::axis_view::PlaneView;
use coface_algebra::Error;
use coface_algebra::progress::stage;
use coface_geometry::BoxTree;
use coface_geometry::predicates::{PlaneFilter, SpatialPoint, orientation, spatial_orientation};
use rayon::prelude::*;
use std::cmp::Ordering;

/// A point by the lowest things that meet in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Place {
    /// A vertex.
    Corner(u32),
    /// The insides of two edges, the lower one first.
    Edges([u32; 2]),
    /// The inside of an edge and the inside of a sheet, in this order.
    EdgeAndSheet([u32; 2]),
    /// The insides of three sheets, rising.
    Sheets([u32; 3]),
}

impl Place {
    /// The point; for edges and sheets that are known to meet.
    pub(super) fn point(self, sheets: &Sheets) -> SpatialPoint {
        let found = match self {
            Self::Corner(vertex) => Some(SpatialPoint::given(sheets.point(vertex))),
            Self::Edges([d, e]) => SpatialPoint::of_lines(sheets.line(d), sheets.line(e)),
            Self::EdgeAndSheet([e, f]) => SpatialPoint::on_plane(sheets.line(e), sheets.plane(f)),
            Self::Sheets(three) => SpatialPoint::of_planes(three.map(|sheet| sheets.plane(sheet))),
        };
        found.expect("lines and planes that were found to cross do")
    }
}

/// The segment that two sheets have in common, within both of them but for its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Cut {
    /// Rising.
    pub(super) sheets: [u32; 2],
    pub(super) ends: [Place; 2],
}

/// The part of an edge of other sheets that runs inside a sheet, in its plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Run {
    pub(super) sheet: u32,
    pub(super) edge: u32,
    pub(super) ends: [Place; 2],
}

/// All places where the sheets of a soup meet otherwise than in common corners and edges; each list rises, nothing is
/// in it twice.
#[derive(Clone, Debug, Default)]
pub(super) struct Meetings {
    /// (edge, vertex): vertices inside edges.
    pub(super) vertices_on_edges: Vec<[u32; 2]>,
    /// (sheet, vertex): vertices inside sheets.
    pub(super) vertices_in_sheets: Vec<[u32; 2]>,
    /// Where the insides of two edges, or of an edge and a sheet, cross in one point.
    pub(super) places: Vec<Place>,
    pub(super) cuts: Vec<Cut>,
    pub(super) runs: Vec<Run>,
    /// Sheets that overlap others in their planes, or nearly.
    pub(super) overlapping: Vec<u32>,
}

/// How many groups of sheets are met between two looks at the size.
const BLOCK: usize = 1 << 6;

impl Meetings {
    /// The meetings of pairs of sheets, whose boxes are in the tree, that have one of these sheets.
    ///
    /// # Errors
    /// What `check` says of the number of places found so far.
    pub(super) fn new(
        sheets: &Sheets,
        tree: &BoxTree,
        is_wanted: impl Fn(u32) -> bool + Sync,
        check: impl Fn(usize) -> Result<(), Error>,
    ) -> Result<Self, Error> {
        let pairs = Pairs { sheets };
        let mut all = Self::default();
        let mut sorted_size = 0;
        let steps = stage("meeting pairs of sheets", tree.group_count());
        for start in (0..tree.group_count()).step_by(BLOCK) {
            let groups: Vec<usize> = (start..(start + BLOCK).min(tree.group_count())).collect();
            let found: Vec<Self> = groups
                .par_iter()
                .map(|&group| {
                    steps.advance(1);
                    let mut own = Self::default();
                    let mut plane: Option<Plane> = None;
                    tree.pairs_of_group(group, |f, g| {
                        if sheets.are_beside(f, g) || !(is_wanted(f) || is_wanted(g)) {
                            return;
                        }
                        // Many pairs have the same first sheet, one after the other.
                        let plane = match &mut plane {
                            Some(known) if known.sheet == f => known,
                            other => other.insert(Plane::new(sheets, f)),
                        };
                        pairs.meet(plane, g, &mut own);
                    });
                    own.sort();
                    own
                })
                .collect();
            for own in found {
                all.append(own);
            }
            // Things found twice do not count; sorting each time they may have doubled keeps the time near linear.
            if all.places.len() + all.cuts.len() > 2 * sorted_size {
                all.sort();
                sorted_size = all.places.len() + all.cuts.len();
                check(all.places.len() + all.cuts.len())?;
            }
        }
        all.sort();
        check(all.places.len() + all.cuts.len())?;
        Ok(all)
    }

    fn append(&mut self, mut other: Self) {
        self.vertices_on_edges.append(&mut other.vertices_on_edges);
        self.vertices_in_sheets.append(&mut other.vertices_in_sheets);
        self.places.append(&mut other.places);
        self.cuts.append(&mut other.cuts);
        self.runs.append(&mut other.runs);
        self.overlapping.append(&mut other.overlapping);
    }

    fn sort(&mut self) {
        sort_and_dedup(&mut self.vertices_on_edges);
        sort_and_dedup(&mut self.vertices_in_sheets);
        sort_and_dedup(&mut self.places);
        sort_and_dedup(&mut self.cuts);
        sort_and_dedup(&mut self.runs);
        sort_and_dedup(&mut self.overlapping);
    }
}

fn sort_and_dedup<T: Ord>(list: &mut Vec<T>) {
    list.sort_unstable();
    list.dedup();
}

/// A place where two sheets meet, with the edges of each that it lies on, a bit for each.
#[derive(Clone, Copy, Debug)]
struct Contact {
    place: Place,
    edges: [u8; 2],
}

/// At most a few contacts, none twice.
#[derive(Default)]
struct Contacts(Vec<Contact>);

impl Contacts {
    fn push(&mut self, place: Place, edges: [u8; 2]) {
        if self.0.iter().all(|known| known.place != place) {
            self.0.push(Contact { place, edges });
        }
    }

    /// The ends of a segment, and the edges that it lies along, a bit for each edge of either sheet; none for a single
    /// point.
    fn segment(&self) -> Option<([Place; 2], [u8; 2])> {
        debug_assert!(self.0.len() < 3, "convex sets meet in a segment");
        let [a, b] = self.0.first_chunk()?;
        let ends = if a.place < b.place { [a.place, b.place] } else { [b.place, a.place] };
        Some((ends, [0, 1].map(|i| a.edges[i] & b.edges[i])))
    }
}

/// The edges at a corner.
fn edges_at(corner: usize) -> u8 {
    1 << corner | 1 << ((corner + 2) % 3)
}

/// The meeting of the insides of two edges.
fn crossing(d: u32, e: u32) -> Place {
    Place::Edges([d.min(e), d.max(e)])
}

/// On which side of an edge of a sheet a vertex is, as it is seen from the front of the sheet: `Greater` for inside.
fn side_of_edge(sheets: &Sheets, sheet: u32, edge: usize, vertex: u32) -> Ordering {
    let view: PlaneView = sheets.views[sheet as usize];
    let corners = sheets.corners[sheet as usize];
    let [a, b, c] =
        [corners[edge], corners[(edge + 1) % 3], vertex].map(|vertex| view.seen(sheets.point(vertex)));
    view.seen_from_front(orientation(a, b, c))
}

/// Whether the other of two sheets is seen to be outside of an edge of one of them, but for ends of this edge: the sheets then have at most these in common. A
/// sheet is seen as a triangle from its own front, so that no other point of it is behind one of its corners.
fn are_seen_apart(sheets: &Sheets, pair: [u32; 2]) -> bool {
    (0..2).any(|own| {
        let [corners, others] = [pair[own], pair[1 - own]].map(|sheet| sheets.corners[sheet as usize]);
        (0..3).any(|edge| {
            let ends = [corners[edge], corners[(edge + 1) % 3]];
            others.iter().all(|&corner| {
                ends.contains(&corner) || side_of_edge(sheets, pair[own], edge, corner).is_lt()
            })
        })
    })
}

struct Pairs<'a> {
    sheets: &'a Sheets,
}

/// The plane of a sheet, made ready to tell on which side of it points are.
struct Plane {
    sheet: u32,
    corners: [u32; 3],
    filter: Filter,
}

/// What tells quickly on which side of the plane of a sheet most points are.
#[derive(Clone, Copy, Debug)]
enum Filter {
    /// A plane at right angles to the axis of the view, at this coordinate: all points are told.
    Level(f64),
    Slanted(PlaneFilter),
}

impl Filter {
    fn new(sheets: &Sheets, sheet: u32) -> Self {
        let axis = usize::from(sheets.views[sheet as usize].axis);
        let plane = sheets.plane(sheet);
        let [a, b, c] = plane.map(|corner| corner[axis]);
        if a == b && b == c { Self::Level(a) } else { Self::Slanted(PlaneFilter::new(plane)) }
    }
}

impl Plane {
    fn new(sheets: &Sheets, sheet: u32) -> Self {
        Self { sheet, corners: sheets.corners[sheet as usize], filter: Filter::new(sheets, sheet) }
    }

    /// The side that a point is on, unless it is too near to the plane to be told quickly.
    fn quick_side(&self, sheets: &Sheets, point: [f64; 3]) -> Option<Ordering> {
        match &self.filter {
            Filter::Level(level) => {
                let view = sheets.views[self.sheet as usize];
                let order = point[usize::from(view.axis)].partial_cmp(level);
                Some(view.seen_from_front(order.expect("coordinates are numbers")))
            }
            Filter::Slanted(filter) => filter.side_of(point),
        }
    }

    /// The sides that the corners of another sheet are on; `None` if they meet at most in common corners and edges, because all other corners are on one
    /// side, or because they are beside each other in nearly one plane.
    fn sides(&self, sheets: &Sheets, of: u32) -> Option<[Ordering; 3]> {
        let corners = sheets.corners[of as usize];
        let quick = corners.map(|corner| match self.corners.contains(&corner) {
            true => Some(Ordering::Equal),
            false => self.quick_side(sheets, sheets.point(corner)),
        });
        // What is told in the plane costs a fraction of what is told in space.
        if quick.contains(&None) && are_seen_apart(sheets, [self.sheet, of]) {
            return None;
        }
        let mut seen = [false; 3];
        let mut sides = [Ordering::Equal; 3];
        for ((side, quick), corner) in sides.iter_mut().zip(quick).zip(corners) {
            if self.corners.contains(&corner) {
                continue;
            }
            *side = quick.unwrap_or_else(|| {
                let [a, b, c] = sheets.plane(self.sheet);
                spatial_orientation(a, b, c, sheets.point(corner))
            });
            seen[(*side as i8 + 1) as usize] = true;
        }
        (seen[1] || seen[0] == seen[2]).then_some(sides)
    }
}

impl Pairs<'_> {
    /// Adds the meetings of a sheet, which has this plane, and another one.
    fn meet(&self, plane: &Plane, other: u32, found: &mut Meetings) {
        let Some(other_sides) = plane.sides(self.sheets, other) else { return };
        let [f, g] = [plane.sheet.min(other), plane.sheet.max(other)];
        if other_sides == [Ordering::Equal; 3] {
            self.meet_in_plane(f, g, found);
            return;
        }
        let Some(own_sides) = Plane::new(self.sheets, other).sides(self.sheets, plane.sheet) else { return };
        let [f_sides, g_sides] =
            if f == plane.sheet { [own_sides, other_sides] } else { [other_sides, own_sides] };
        let mut contacts = Contacts::default();
        self.meet_with([f, g], f_sides, 0, &mut contacts, found);
        self.meet_with([g, f], g_sides, 1, &mut contacts, found);
        let Some((ends, [along_f, along_g])) = contacts.segment() else { return };
        let edge =
            |sheet: u32, along: u8| self.sheets.edges_of[sheet as usize][along.trailing_zeros() as usize];
        match (along_f, along_g) {
            (0, 0) => found.cuts.push(Cut { sheets: [f, g], ends }),
            (0, along) => found.runs.push(Run { sheet: f, edge: edge(g, along), ends }),
            (along, 0) => found.runs.push(Run { sheet: g, edge: edge(f, along), ends }),
            _ => {}
        }
    }

    /// The places on the boundary of the first of two sheets that are on the second, given the sides of the second that
    /// its corners are on. `first` is the position of the first sheet in the contacts.
    fn meet_with(
        &self,
        [f, g]: [u32; 2],
        sides: [Ordering; 3],
        first: usize,
        contacts: &mut Contacts,
        found: &mut Meetings,
    ) {
        let [f_corners, g_corners] = [f, g].map(|sheet| self.sheets.corners[sheet as usize]);
        let [f_edges, g_edges] = [f, g].map(|sheet| self.sheets.edges_of[sheet as usize]);
        let pair = |own: u8, other: u8| if first == 0 { [own, other] } else { [other, own] };
        for i in 0..3 {
            let corner = f_corners[i];
            if sides[i].is_eq() {
                if let Some(j) = g_corners.iter().position(|&other| other == corner) {
                    contacts.push(Place::Corner(corner), pair(edges_at(i), edges_at(j)));
                } else if let Some(on) = self.edges_with(g, corner) {
                    contacts.push(Place::Corner(corner), pair(edges_at(i), on));
                    note_vertex(corner, g, g_edges, on, found);
                }
            }
            let next = (i + 1) % 3;
            if sides[i].is_ne() && sides[i] == sides[next].reverse() {
                let [a, b] = [i, next].map(|i| self.sheets.point(f_corners[i]));
                let turns = [0, 1, 2].map(|j| {
                    let [c, d] = [j, (j + 1) % 3].map(|j| self.sheets.point(g_corners[j]));
                    spatial_orientation(a, b, c, d)
                });
                let Some(on) = edges_through(turns) else { continue };
                let place = match on.count_ones() {
                    0 => Place::EdgeAndSheet([f_edges[i], g]),
                    1 => crossing(f_edges[i], g_edges[on.trailing_zeros() as usize]),
                    // A corner of the other sheet, which is found as such.
                    _ => continue,
                };
                contacts.push(place, pair(1 << i, on));
                found.places.push(place);
            }
        }
    }

    /// The edges of a sheet that a vertex in its plane, none of its corners, is on; `None` if it is outside.
    fn edges_with(&self, sheet: u32, vertex: u32) -> Option<u8> {
        let turns = [0, 1, 2].map(|edge| side_of_edge(self.sheets, sheet, edge, vertex));
        // Counterclockwise throughout: not outside on any.
        turns.iter().all(|turn| turn.is_ge()).then(|| bits(turns))
    }

    /// Adds the meetings of two sheets in one plane.
    fn meet_in_plane(&self, f: u32, g: u32, found: &mut Meetings) {
        let pair = [f, g];
        let corners = pair.map(|sheet| self.sheets.corners[sheet as usize]);
        let edges = pair.map(|sheet| self.sheets.edges_of[sheet as usize]);
        // For each of the two sheets and each edge of it, the sides of it that the corners of the other are on.
        let mut turns = [[[Ordering::Equal; 3]; 3]; 2];
        for own in 0..2 {
            for (edge, turns) in turns[own].iter_mut().enumerate() {
                let ends = [corners[own][edge], corners[own][(edge + 1) % 3]];
                for (turn, &corner) in turns.iter_mut().zip(&corners[1 - own]) {
                    if !ends.contains(&corner) {
                        *turn = side_of_edge(self.sheets, pair[own], edge, corner);
                    }
                }
                // Nothing on this side of the edge, and on its line nothing but its ends.
                let is_apart = turns
                    .iter()
                    .zip(&corners[1 - own])
                    .all(|(turn, corner)| turn.is_lt() || ends.contains(corner));
                if is_apart {
                    return;
                }
            }
        }
        found.overlapping.extend(pair);
        // The edges of one sheet that a corner of the other is on; none outside.
        let located = [0, 1].map(|own: usize| {
            [0, 1, 2].map(|corner| {
                let own_turns = [0, 1, 2].map(|edge| turns[own][edge][corner]);
                own_turns.iter().all(|turn| turn.is_ge()).then(|| bits(own_turns))
            })
        });
        for own in 0..2 {
            for (corner, on) in corners[1 - own].iter().zip(located[own]) {
                if let Some(on) = on.filter(|_| !corners[own].contains(corner)) {
                    note_vertex(*corner, pair[own], edges[own], on, found);
                }
            }
        }
        let crosses = |i: usize, j: usize| {
            let opposite = |x: Ordering, y: Ordering| x.is_ne() && x == y.reverse();
            opposite(turns[0][i][j], turns[0][i][(j + 1) % 3])
                && opposite(turns[1][j][i], turns[1][j][(i + 1) % 3])
        };
        for (i, j) in (0..9).map(|k| (k / 3, k % 3)).filter(|&(i, j)| crosses(i, j)) {
            found.places.push(crossing(edges[0][i], edges[1][j]));
        }
        for own in 0..2 {
            let other = 1 - own;
            for (j, &edge) in edges[other].iter().enumerate() {
                if edges[own].contains(&edge) {
                    continue;
                }
                let mut contacts = Contacts::default();
                for end in [j, (j + 1) % 3] {
                    if let Some(on) = located[own][end] {
                        contacts.push(Place::Corner(corners[other][end]), [on, 0]);
                    }
                }
                for (i, &corner) in corners[own].iter().enumerate() {
                    if located[other][i].is_some_and(|on| on & 1 << j != 0) {
                        contacts.push(Place::Corner(corner), [edges_at(i), 0]);
                    }
                    if if own == 0 { crosses(i, j) } else { crosses(j, i) } {
                        contacts.push(crossing(edges[own][i], edge), [1 << i, 0]);
                    }
                }
                if let Some((ends, [0, _])) = contacts.segment() {
                    found.runs.push(Run { sheet: pair[own], edge, ends });
                }
            }
        }
    }
}

/// Notes a vertex inside a sheet or inside one of its edges.
fn note_vertex(vertex: u32, sheet: u32, edges: [u32; 3], on: u8, found: &mut Meetings) {
    if on == 0 {
        found.vertices_in_sheets.push([sheet, vertex]);
    } else {
        found.vertices_on_edges.push([edges[on.trailing_zeros() as usize], vertex]);
    }
}

/// A bit for each sign that is zero.
fn bits(turns: [Ordering; 3]) -> u8 {
    (0..3).map(|i| u8::from(turns[i].is_eq()) << i).sum()
}

/// The edges of a triangle that a line passes through, given how it turns around each: none outside.
fn edges_through(turns: [Ordering; 3]) -> Option<u8> {
    let has = |order: Ordering| turns.contains(&order);
    (!has(Ordering::Less) || !has(Ordering::Greater)).then(|| bits(turns))
}
