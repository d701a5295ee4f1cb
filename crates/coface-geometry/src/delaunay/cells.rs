//! The cells of a triangulation while points are inserted.

use super::space::Space;
use crate::predicates::WeightedPoint;

/// The point at infinity.
const INFINITE: u32 = u32::MAX;
/// The first corner of a cell that is no more.
const GONE: u32 = u32::MAX - 1;
/// The most points: their numbers are below the two above.
pub(super) const MOST_POINTS: usize = GONE as usize;

/// The cells of a triangulation of a flat of dimension N - 1, and those that reach to infinity.
///
/// Corners of a cell are in positive order: with the point at infinity replaced by a point far beyond its facet too.
pub(super) struct Cells<'a, const N: usize> {
    space: &'a Space,
    corners: Vec<[u32; N]>,
    /// At i the cell across the facet that lacks corner i.
    neighbors: Vec<[u32; N]>,
    /// The round in which a cell was looked at: even numbers for cells that conflict with its point, odd ones for others.
    marks: Vec<u32>,
    round: u32,
    /// Cells that are no more.
    gone: Vec<u32>,
    /// A bounded cell near the point that was inserted last.
    last: u32,
    conflicts: Vec<u32>,
    facets: Vec<Facet<N>>,
    ridges: Ridges,
}

/// A facet between a cell that conflicts with a point and one that does not, with the cell that the point makes with it.
struct Facet<const N: usize> {
    corners: [u32; N],
    /// Which corner is the point.
    place: usize,
    /// The cell across, and which of its corners the facet lacks.
    across: u32,
    place_across: usize,
}

impl<'a, const N: usize> Cells<'a, N> {
    /// The triangulation of N points that are independent.
    pub(super) fn new(space: &'a Space, mut first: [u32; N]) -> Self {
        let at = |ids: &[u32; N]| ids.map(|id| space.points[id as usize]);
        if space.orientation(&at(&first)).is_lt() {
            first.swap(0, 1);
        }
        let mut corners = vec![first];
        for i in 0..N {
            let mut unbounded = first;
            unbounded[i] = INFINITE;
            unbounded.swap(0, 1);
            corners.push(unbounded);
        }
        // All of these share a facet, two by two; cell i + 1 lacks corner i of the first one.
        let missing = |cell: usize, other: usize| -> usize {
            let lacked = |corner: &u32| !corners[other].contains(corner);
            corners[cell].iter().position(lacked).expect("different cells have different corners")
        };
        let mut neighbors = vec![[0; N]; N + 1];
        for cell in 0..=N {
            for other in (0..=N).filter(|&other| other != cell) {
                neighbors[cell][missing(cell, other)] = other as u32;
            }
        }
        Self {
            space,
            corners,
            neighbors,
            marks: vec![0; N + 1],
            round: 0,
            gone: Vec::new(),
            last: 0,
            conflicts: Vec::new(),
            facets: Vec::new(),
            ridges: Ridges::default(),
        }
    }

    fn point(&self, id: u32) -> WeightedPoint {
        self.space.points[id as usize]
    }

    /// The corners of a cell with one replaced by a point; the others are not at infinity.
    fn with(&self, cell: u32, place: usize, point: WeightedPoint) -> [WeightedPoint; N] {
        let ids = self.corners[cell as usize];
        std::array::from_fn(|i| if i == place { point } else { self.point(ids[i]) })
    }

    fn infinite_place(&self, cell: u32) -> Option<usize> {
        self.corners[cell as usize].iter().position(|&id| id == INFINITE)
    }

    /// The cell that has a point, or one that reaches to infinity and has it beyond its facet.
    ///
    /// # References
    /// O. Devillers, S. Pion, M. Teillaud, *Walking in a triangulation* (2002): in a regular triangulation the walk ends.
    fn located(&self, point: WeightedPoint) -> u32 {
        let (mut here, mut before) = (self.last, INFINITE);
        'walk: loop {
            for place in 0..N {
                let next = self.neighbors[here as usize][place];
                if next == before {
                    continue;
                }
                if self.space.orientation(&self.with(here, place, point)).is_lt() {
                    (before, here) = (here, next);
                    if self.infinite_place(here).is_some() {
                        return here;
                    }
                    continue 'walk;
                }
            }
            return here;
        }
    }

    /// Whether a point lies inside the sphere of a cell; of one that reaches to infinity, beyond its facet, or in the flat of the facet and inside the
    /// sphere of the facet.
    fn conflicts_with(&self, cell: u32, id: u32) -> bool {
        let Some(place) = self.infinite_place(cell) else {
            return self.space.is_inside(self.corners[cell as usize], id);
        };
        match self.space.orientation(&self.with(cell, place, self.point(id))) {
            std::cmp::Ordering::Greater => true,
            std::cmp::Ordering::Less => false,
            std::cmp::Ordering::Equal => {
                let inner = self.neighbors[cell as usize][place];
                self.space.is_inside(self.corners[inner as usize], id)
            }
        }
    }

    /// Inserts a point: replaces the cells that conflict with it by those that it makes with their outer facets. Nothing happens to a point that is hidden.
    ///
    /// # References
    /// A. Bowyer, *Computing Dirichlet tessellations* (1981); D. Watson, *Computing the n-dimensional Delaunay tessellation* (1981).
    pub(super) fn insert(&mut self, id: u32) {
        let first = self.located(self.point(id));
        if !self.conflicts_with(first, id) {
            return;
        }
        self.find_conflicts(first, id);
        // New cells take the places of those that are no more.
        let (conflicts, facets) = (std::mem::take(&mut self.conflicts), std::mem::take(&mut self.facets));
        self.gone.extend(&conflicts);
        for &cell in &conflicts {
            self.corners[cell as usize][0] = GONE;
        }
        self.ridges.clear(facets.len() * (N - 1));
        for facet in &facets {
            let cell = self.gone.pop().unwrap_or_else(|| {
                self.corners.push([GONE; N]);
                self.neighbors.push([INFINITE; N]);
                self.marks.push(0);
                self.corners.len() as u32 - 1
            });
            self.corners[cell as usize] = facet.corners;
            self.neighbors[cell as usize][facet.place] = facet.across;
            self.neighbors[facet.across as usize][facet.place_across] = cell;
            for place in (0..N).filter(|&place| place != facet.place) {
                let ridge = ridge(&facet.corners, facet.place, place);
                if let Some((other, other_place)) = self.ridges.matched(ridge, (cell, place as u32)) {
                    self.neighbors[cell as usize][place] = other;
                    self.neighbors[other as usize][other_place as usize] = cell;
                }
            }
            if !facet.corners.contains(&INFINITE) {
                self.last = cell;
            }
        }
        (self.conflicts, self.facets) = (conflicts, facets);
    }

    /// Finds all cells that conflict with a point, from one of them on, and the facets around them.
    fn find_conflicts(&mut self, first: u32, id: u32) {
        self.round += 2;
        let (conflicting, other) = (self.round, self.round + 1);
        self.conflicts.clear();
        self.facets.clear();
        self.conflicts.push(first);
        self.marks[first as usize] = conflicting;
        let mut at = 0;
        while at < self.conflicts.len() {
            let cell = self.conflicts[at];
            at += 1;
            for place in 0..N {
                let across = self.neighbors[cell as usize][place];
                let mark = self.marks[across as usize];
                if mark == conflicting {
                    continue;
                }
                if mark != other {
                    if self.conflicts_with(across, id) {
                        self.marks[across as usize] = conflicting;
                        self.conflicts.push(across);
                        continue;
                    }
                    self.marks[across as usize] = other;
                }
                let mut corners = self.corners[cell as usize];
                corners[place] = id;
                let back = self.neighbors[across as usize].iter().position(|&back| back == cell);
                let place_across = back.expect("neighbors are mutual");
                self.facets.push(Facet { corners, place, across, place_across });
            }
        }
    }

    /// The corners of all bounded cells.
    pub(super) fn bounded(self) -> impl Iterator<Item = [u32; N]> {
        self.corners.into_iter().filter(|corners| corners[0] != GONE && !corners.contains(&INFINITE))
    }
}

/// The corners of a cell without two, of which there are at most two, as one number.
fn ridge<const N: usize>(corners: &[u32; N], first: usize, second: usize) -> u64 {
    let mut others = (0..N).filter(|&i| i != first && i != second).map(|i| u64::from(corners[i]));
    match (others.next(), others.next()) {
        (Some(a), Some(b)) => a.min(b) << 32 | a.max(b),
        (Some(a), None) => a,
        _ => 0,
    }
}

/// The ridges of new cells, each of which is met twice: a table with open addresses.
#[derive(Default)]
struct Ridges {
    /// The round, the ridge, and what has it.
    slots: Vec<(u32, u64, (u32, u32))>,
    round: u32,
}

impl Ridges {
    /// Forgets all ridges, and makes place for so many.
    fn clear(&mut self, count: usize) {
        let size = (2 * count).next_power_of_two().max(64);
        if self.slots.len() < size {
            self.slots = vec![(0, 0, (0, 0)); size];
            self.round = 0;
        }
        self.round += 1;
    }

    /// What else has this ridge; keeps what has it if nothing else does yet.
    fn matched(&mut self, ridge: u64, owner: (u32, u32)) -> Option<(u32, u32)> {
        let mask = self.slots.len() - 1;
        let spread = ridge.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mut at = (spread >> 32) as usize & mask;
        loop {
            let slot = &mut self.slots[at];
            if slot.0 != self.round {
                *slot = (self.round, ridge, owner);
                return None;
            }
            if slot.1 == ridge {
                return Some(slot.2);
            }
            at = (at + 1) & mask;
        }
    }
}
