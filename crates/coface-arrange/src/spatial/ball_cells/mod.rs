//! Cells refined until each is a ball, so that boundary matrices have the homology of the space.
//!
//! A face with holes is no disk, and a cell with voids or tunnels is no ball: the boundary matrices of such cells forget
//! how the parts of a boundary are connected. Three things mend it, each only where it is needed:
//! * A **bridge** is an edge through the inside of a face or of a cell, from one part of its boundary to another. It has
//!   no place in space, but for its ends: a face or a cell without an arc between two parts of its boundary is one with
//!   a boundary in one piece, whatever arc it is.
//! * A **cut** is a rectangle across a cell with a tunnel. The arrangement is made once more with it; what lies in other
//!   cells is left out again.
//! * Where parts of the boundary touch in a vertex, the boundary is in one piece already.

mod building;
mod cutting_planes;
mod matching;
mod pieces;
mod touching;

use self::building::build;
use self::cutting_planes::{best_cuts, new_cut_through};
use self::matching::cells_of_cut;
use self::pieces::{Kept, Pieces};
use super::SpatialArrangement;
use coface_algebra::chains::{ChainComplex, ChainRefinement};
use coface_algebra::{CellId, Error, FaceId, Sign};
use coface_geometry::Positions;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;
/// Each round cuts every piece that is no ball, or not known to be one.
const MOST_ROUNDS: usize = 64;

/// Rectangles across pieces. Each is there in the piece that it was made for alone.
#[derive(Default)]
struct Cuts {
    rectangles: Vec<[[f64; 3]; 4]>,
    /// The round in which each was made, and the piece it is for.
    for_piece: Vec<(u32, u32)>,
    /// For each round the piece that each cell of the arrangement of today was part of then.
    rounds: Vec<Vec<u32>>,
}

impl Cuts {
    /// Adds a round with the pieces that it was made in.
    fn add(&mut self, next: Vec<(u32, [[f64; 3]; 4])>, piece_of_cell: Vec<u32>) {
        let round = self.rounds.len() as u32;
        self.rounds.push(piece_of_cell);
        for (piece, rectangle) in next {
            self.rectangles.push(rectangle);
            self.for_piece.push((round, piece));
        }
    }

    /// Goes on to an arrangement with more cuts, whose cells are parts of these.
    fn follow(&mut self, cells: &[u32]) {
        self.rounds.iter_mut().for_each(|pieces| *pieces = through(cells, pieces));
    }

    /// Whether a cut is there between two cells.
    fn is_between(&self, cut: usize, sides: [u32; 2]) -> bool {
        let (round, piece) = self.for_piece[cut];
        let pieces = &self.rounds[round as usize];
        sides.iter().all(|&cell| pieces.get(cell as usize) == Some(&piece))
    }
}

/// What cells have that are parts of others, from what those have; no number for parts of the exterior.
fn through(cells: &[u32], values: &[u32]) -> Vec<u32> {
    cells.iter().map(|&cell| values.get(cell as usize).copied().unwrap_or(NONE)).collect()
}

/// Parts of space, made of cells of an arrangement, as a complex whose cells are balls.
///
/// # Examples
/// A square frame, which is a square with a square hole, is an annulus:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = |low: f64, high: f64| [low, low, 0., high, low, 0., high, high, 0., low, high, 0.];
/// let positions = Positions::from_flat(3, [square(0., 3.), square(1., 2.)].concat())?;
/// let walks = RaggedArray::from_lists([[0, 1, 2, 3], [7, 6, 5, 4]]);
/// let frame = SpatialPolygons::new(positions, walks, vec![0, 0])?;
/// let arrangement = SpatialArrangement::new(&frame, &SpatialOptions::new())?;
/// assert_eq!(arrangement.f_vector(), [8, 8, 1, 0]);
/// // Eight triangles.
/// assert_eq!(arrangement.ball_complex()?.complex().f_vector(), [8, 16, 8, 0]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct BallComplex {
    pub(super) complex: ChainComplex,
    pub(super) positions: Positions,
    pub(super) refinement: ChainRefinement,
    /// Parts in which a piece is no ball after all.
    pub(super) others: Vec<u32>,
}

/// Which faces a complex of balls has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct BallRules {
    keep_faces: bool,
    triangles: bool,
}

impl BallRules {
    /// Faces with different parts, or nothing, on their two sides, cut into triangles only where they have holes.
    pub const fn new() -> Self {
        Self { keep_faces: false, triangles: false }
    }

    /// Whether faces with the same part, or nothing, on both sides are kept.
    #[must_use]
    pub const fn keep_faces(mut self, keep: bool) -> Self {
        self.keep_faces = keep;
        self
    }

    /// Whether all faces are cut into triangles.
    #[must_use]
    pub const fn triangles(mut self, triangles: bool) -> Self {
        self.triangles = triangles;
        self
    }
}

impl BallComplex {
    /// The boundary matrices. Cells of degree 3 run outward.
    pub fn complex(&self) -> &ChainComplex {
        &self.complex
    }

    /// Where the vertices are, rounded.
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// What each edge, face and cell is a piece of: of edge, face and part; the bridges and cuts of none.
    pub fn refinement(&self) -> &ChainRefinement {
        &self.refinement
    }

    /// The parts of which a piece is no ball, or not known to be one: homology may be wrong there.
    pub fn parts_left(&self) -> &[u32] {
        &self.others
    }

    /// The complex, the positions of the vertices and the refinement.
    pub fn into_parts(self) -> (ChainComplex, Positions, ChainRefinement) {
        (self.complex, self.positions, self.refinement)
    }
}

impl SpatialArrangement {
    /// Vertices, edges, faces and bounded cells, refined until each is a ball.
    ///
    /// # Errors
    /// Those of [`Self::new`] where the arrangement is made again with cuts.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n sides of faces; with cells that have tunnels, that of [`Self::new`] a few times.
    pub fn ball_complex(&self) -> Result<BallComplex, Error> {
        let parts: Vec<Option<u32>> = (0..self.fine().cell_count() as u32).map(Some).collect();
        self.ball_complex_of(&parts, BallRules::new().keep_faces(true))
    }

    /// The parts of space that cells are put together to, as a complex whose cells are balls. `part_of_cell` has the
    /// part of each bounded cell, numbered from 0, or `None` for cells that are left out.
    ///
    /// # Errors
    /// As [`Self::ball_complex`].
    ///
    /// # Panics
    /// If there are fewer entries than cells.
    pub fn ball_complex_of(
        &self,
        part_of_cell: &[Option<u32>],
        rules: BallRules,
    ) -> Result<BallComplex, Error> {
        let mut parts: Vec<u32> = part_of_cell.iter().map(|part| part.unwrap_or(NONE)).collect();
        let mut cuts = Cuts::default();
        let mut with_cuts: Option<Self> = None;
        let mut tries_slanted = true;
        loop {
            let arrangement = with_cuts.as_ref().unwrap_or(self);
            let kept = Kept::new(arrangement, self.polygon_count(), &parts, &cuts, rules.keep_faces);
            let pieces = Pieces::new(arrangement, &kept, &parts);
            let bad = pieces.doubtful();
            let round = cuts.rounds.len();
            let next: Vec<(u32, [[f64; 3]; 4])> = if round == MOST_ROUNDS {
                Vec::new()
            } else {
                let halves = kept.halves_of_pieces(arrangement);
                let cut = |&piece: &u32| {
                    let own = halves.list(piece as usize);
                    let found = if pieces.is_ball(piece) {
                        let through = |vertex| new_cut_through(arrangement, own, vertex, &cuts.rectangles);
                        pieces.unknown_at(piece).find_map(through).into_iter().collect()
                    } else {
                        let through = pieces.vertex_between(piece).filter(|_| round % 2 == 0);
                        let through = through.map(|vertex| (vertex, round / 2 % 3));
                        best_cuts(arrangement, own, through, &cuts.rectangles, tries_slanted)
                    };
                    found.into_iter().map(move |cut| (piece, cut))
                };
                bad.iter().flat_map(cut).collect()
            };
            if next.is_empty() {
                return build(self, arrangement, &kept, &pieces, rules.triangles);
            }
            let all: Vec<[[f64; 3]; 4]> =
                cuts.rectangles.iter().copied().chain(next.iter().map(|own| own.1)).collect();
            let further = self.with_cuts(&all)?;
            let Some(cells) = cells_of_cut(arrangement, &further) else {
                if tries_slanted {
                    // Slanted cuts may divide all edges of a cell where others do not.
                    tries_slanted = false;
                    continue;
                }
                // Where cells cannot be told in the arrangement with more cuts, the parts that have tunnels are named.
                return build(self, arrangement, &kept, &pieces, rules.triangles);
            };
            tries_slanted = true;
            cuts.add(next, kept.piece_of_cell);
            cuts.follow(&cells);
            parts = through(&cells, &parts);
            with_cuts = Some(further);
        }
    }

    /// The cell on a side of a face: behind for 0, in front for 1; no number for the exterior.
    fn packed_cell(&self, face: u32, side: u32) -> u32 {
        self.cell_at(FaceId::from_u32(face), Sign::power_of_minus_one(side as usize))
            .map_or(NONE, CellId::to_u32)
    }
}
