//! Smaller triangulations of the same 3-manifold, found by moves.

use super::GluingMove;
use super::moves::{moved, moved_with};
use coface_algebra::Error;
use coface_complexes::gluing::{FaceClasses, GluingTable};

/// A triangulation with fewer tetrahedra, and the moves that lead to it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GluingSimplification {
    table: GluingTable,
    moves: Vec<GluingMove>,
}

impl GluingSimplification {
    /// The table after all moves.
    pub fn table(&self) -> &GluingTable {
        &self.table
    }

    /// The moves in order. Each is one of the table that the moves before it have made.
    pub fn moves(&self) -> &[GluingMove] {
        &self.moves
    }

    /// The table after all moves.
    pub fn into_table(self) -> GluingTable {
        self.table
    }

    /// Makes one move.
    fn step(&self, step: GluingMove) -> Result<Option<Self>, Error> {
        let Some(table) = moved(&self.table, step)? else { return Ok(None) };
        let mut moves = self.moves.clone();
        moves.push(step);
        Ok(Some(Self { table, moves }))
    }

    /// Makes moves that remove tetrahedra as long as there are some.
    fn reduced(mut self) -> Result<Self, Error> {
        loop {
            let faces = self.table.faces()?;
            let ideal = self.table.ideal_vertices(&faces)?;
            // The numbers of corners at vertices, and of tetrahedra around edges.
            let (vertices, edges) = (degrees(&self.table, &faces, 1), degrees(&self.table, &faces, 2));
            let of_degree = |counts: &[usize], degree: usize| -> Vec<usize> {
                (0..counts.len()).filter(|&at| counts[at] == degree).collect()
            };
            let [fours, twos, threes] = [of_degree(&vertices, 4), of_degree(&edges, 2), of_degree(&edges, 3)];
            let edges = 0..faces.class_counts().get(1).copied().unwrap_or(0);
            let steps = twos
                .into_iter()
                .map(|edge| GluingMove::TwoToZero { edge })
                .chain(edges.map(|edge| GluingMove::Collapse { edge }))
                .chain(fours.into_iter().map(|vertex| GluingMove::FourToOne { vertex }))
                .chain(threes.into_iter().map(|edge| GluingMove::ThreeToTwo { edge }));
            let mut found = None;
            for step in steps {
                if let Some(table) = moved_with(&self.table, (&faces, &ideal), step)? {
                    found = Some((table, step));
                    break;
                }
            }
            let Some((table, step)) = found else { return Ok(self) };
            self.table = table;
            self.moves.push(step);
        }
    }
}

/// How many faces of tetrahedra with so many vertices are in each class.
fn degrees(table: &GluingTable, faces: &FaceClasses, size: u32) -> Vec<usize> {
    let mut counts = vec![0; faces.class_counts().get(size as usize - 1).copied().unwrap_or(0)];
    for tetrahedron in 0..table.simplex_count() {
        for set in (1..16_u32).filter(|set| set.count_ones() == size) {
            counts[faces.of_face(tetrahedron, set).0] += 1;
        }
    }
    counts
}

/// Numbers that look random and are the same every time.
struct Dice(u64);

impl Dice {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % count.max(1) as u64) as usize
    }
}

/// So many moves that add a tetrahedron are made one after the other, before tetrahedra are removed again.
const CLIMB: usize = 4;

/// A triangulation of the same space with fewer tetrahedra, as far as moves find one: all that remove tetrahedra; then, `attempts` times, some
/// that add one, chosen by fixed dice, and those that remove again. The same table gives the same answer.
///
/// Of a table with boundary the boundary stays. Tables of other dimensions stay as they are.
///
/// # Errors
/// Those of [`GluingTable::faces`].
///
/// # Complexity
/// $O(n^2)$ for each attempt and for each removed tetrahedron of n.
///
/// # References
/// B. A. Burton, *Computational topology with Regina: algorithms, heuristics and implementations* (2013), section 2.4.
///
/// # Examples
/// The boundary of the 4-simplex has five tetrahedra; the 3-sphere has triangulations of one.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::gluing::GluingTable;
/// use coface_topology::simplified;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let facets = (0..5).map(|left| (0..5).filter(|&vertex| vertex != left).collect::<Vec<u32>>());
/// let sphere = GluingTable::from_simplices(&RaggedArray::from_lists(facets))?;
/// let simplified = simplified(&sphere, 20)?;
/// assert!(simplified.table().simplex_count() < 5 && simplified.table().is_closed());
/// # Ok(()) }
/// ```
pub fn simplified(table: &GluingTable, attempts: usize) -> Result<GluingSimplification, Error> {
    simplified_until(table, attempts, |table| table.simplex_count() < 2)
}

/// As [`simplified`], until a triangulation is enough: all are asked that have no more tetrahedra than those before.
///
/// # Errors
/// Those of [`GluingTable::faces`].
///
/// # Examples
/// ```
/// use coface_complexes::gluing::GluingTable;
/// use coface_topology::simplified_until;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let lens = GluingTable::from_isomorphism_signature("cMcabbjxr", 3)?;
/// assert_eq!(simplified_until(&lens, 10, |_| true)?.moves(), []);
/// # Ok(()) }
/// ```
pub fn simplified_until(
    table: &GluingTable,
    attempts: usize,
    mut is_enough: impl FnMut(&GluingTable) -> bool,
) -> Result<GluingSimplification, Error> {
    let mut best = GluingSimplification { table: table.clone(), moves: Vec::new() };
    if table.dimension() != 3 {
        return Ok(best);
    }
    best = best.reduced()?;
    if is_enough(&best.table) {
        return Ok(best);
    }
    let mut dice = Dice(0x9e37_79b9_7f4a_7c15);
    let mut at = best.clone();
    for attempt in 0..attempts {
        let mut next = at.clone();
        for _ in 0..=attempt % CLIMB {
            let (tetrahedron, facet) = (dice.below(next.table.simplex_count()), dice.below(4));
            if let Some(higher) = next.step(GluingMove::TwoToThree { tetrahedron, facet })? {
                next = higher;
            }
        }
        // The moves that remove go by the numbers of edges: where the new ones are the last, others come first.
        next = next.reduced()?;
        let (now, then) = (next.table.simplex_count(), best.table.simplex_count());
        if now <= then {
            at = next;
            if is_enough(&at.table) {
                return Ok(at);
            }
            if now < then {
                best = at.clone();
            }
        } else {
            at = best.clone();
        }
    }
    Ok(best)
}
