//! Signs of facets by propagation over the ridges that two facets of a cell share.

use super::CellCoherence;
use super::OrientedCells;
use super::pinched::{PinchedRidge, join_patches};
use crate::lar::parts::in_parts;
use crate::surface::dual_graph::DualGraph;
use crate::surface::dual_graph::coherence;
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{RaggedArray, SparseMatrix};

/// The cells with these facets, oriented: signs that make the boundary of each cell a cycle, with +1 for the lowest facet of
/// each component of it.
///
/// `lower` is the boundary matrix of the facets: its rows are ridges, its columns facets. `facets` has the facets of each
/// cell in any order. Where a ridge lies in two facets of a cell, the sign of one gives that of the other. At a **pinched**
/// ridge, in four or more, signs follow from what is known elsewhere, as at a vertex that the rim of a face passes twice: parts
/// that meet in pinched ridges only are components of their own when each is a cycle by itself.
///
/// # Errors
/// [`ErrorKind::NotACycle`] naming a cell and a ridge in an odd number of its facets; [`ErrorKind::NonManifold`] naming a
/// cell and a closed chain of its facets that cannot be oriented, or a pinched ridge where signs do not follow;
/// [`ErrorKind::InvalidInput`] naming a cell without facets, or with one that does not exist or repeats.
///
/// # Complexity
/// Linear in the ridges of all facets, where no ridge is pinched; in parallel over cells.
///
/// # References
/// A. Paoluzzi, V. Shapiro, A. DiCarlo, *Arrangements of cellular complexes* (2017), for orientation by the lowest facet.
///
/// # Examples
/// A triangle with the edges 0 1, 1 2 and 0 2:
/// ```
/// use coface_algebra::{RaggedArray, SparseMatrix};
/// use coface_complexes::lar::oriented_boundary;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let entries = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
/// let edges = SparseMatrix::from_entries(3, 3, entries)?;
/// let triangle = oriented_boundary(&edges, &RaggedArray::from_lists([[2, 1, 0]]))?;
/// assert_eq!(triangle.boundary().column(0).entries(), [1, 1, -1]);
/// let open = oriented_boundary(&edges, &RaggedArray::from_lists([[0, 1]])).unwrap_err();
/// assert_eq!(open.message(), "cell 0 is open: ridge 0 lies in facet 0 alone");
/// # Ok(()) }
/// ```
pub fn oriented_boundary(lower: &SparseMatrix, facets: &RaggedArray) -> Result<OrientedCells, Error> {
    let parts: Vec<Result<_, Error>> = in_parts(
        facets.len(),
        || Scratch::new(lower.row_count()),
        |scratch, cells| {
            let (mut rows, mut entries, mut components) = (Vec::new(), Vec::new(), Vec::new());
            let mut is_connected = true;
            for cell in cells {
                scratch.orient(lower, cell, facets.list(cell))?;
                rows.extend_from_slice(&scratch.facets);
                entries.extend_from_slice(&scratch.signs);
                components.extend_from_slice(&scratch.patches);
                is_connected &= scratch.patches.iter().all(|&patch| patch == 0);
            }
            Ok((rows, entries, components, is_connected))
        },
    );
    let (mut rows, mut entries) = (Vec::with_capacity(facets.item_count()), Vec::new());
    entries.reserve_exact(facets.item_count());
    let (mut components, mut all_connected) = (Vec::new(), true);
    for part in parts {
        let (part_rows, part_entries, part_components, is_connected) = part?;
        all_connected &= is_connected;
        components.push(part_components);
        rows.extend(part_rows);
        entries.extend(part_entries);
    }
    let starts = (0..=facets.len()).map(|cell| facets.start(cell) as u32).collect();
    let boundary = SparseMatrix::from_trusted_parts(lower.column_count(), starts, rows, entries)?;
    Ok(OrientedCells::from_parts(boundary, if all_connected { Vec::new() } else { components.concat() }))
}

/// A ridge in the boundary of one cell: how many of its facets have it, and the first two with their coefficients.
struct RidgeUse {
    ridge: u32,
    count: u32,
    facets: [u32; 2],
    coefficients: [i32; 2],
}

/// What is known of the cell at work. Facets are counted within the cell here, in rising order.
struct Scratch {
    /// Where each ridge stands in `uses`, if it does: entries of other cells are told by the ridge that stands there.
    places: Vec<u32>,
    uses: Vec<RidgeUse>,
    facets: Vec<u32>,
    signs: Vec<i32>,
    /// The component of each facet.
    patches: Vec<u32>,
    stack: Vec<u32>,
}

impl Scratch {
    fn new(ridge_count: usize) -> Self {
        Self {
            places: vec![0; ridge_count],
            uses: Vec::new(),
            facets: Vec::new(),
            signs: Vec::new(),
            patches: Vec::new(),
            stack: Vec::new(),
        }
    }

    /// Finds signs and components of the facets of a cell.
    fn orient(&mut self, lower: &SparseMatrix, cell: usize, facets: &[u32]) -> Result<(), Error> {
        self.facets.clear();
        self.facets.extend_from_slice(facets);
        self.facets.sort_unstable();
        check_facets(lower.column_count(), cell, &self.facets)?;
        self.collect_ridges(lower);
        if let Some(open) = self.uses.iter().find(|at| at.count == 1) {
            return Err(Error::new(
                ErrorKind::NotACycle,
                format!(
                    "cell {cell} is open: ridge {} lies in facet {} alone",
                    open.ridge, self.facets[open.facets[0] as usize]
                ),
            )
            .with_cure("add the facets that are missing"));
        }
        self.propagate(lower, cell)?;
        if self.uses.iter().any(|at| at.count > 2) {
            self.join_at_pinched_ridges(lower, cell)?;
        }
        Ok(())
    }

    fn use_of(&self, ridge: u32) -> Option<usize> {
        let place = self.places[ridge as usize] as usize;
        self.uses.get(place).filter(|at| at.ridge == ridge).map(|_| place)
    }

    fn collect_ridges(&mut self, lower: &SparseMatrix) {
        self.uses.clear();
        for position in 0..self.facets.len() {
            let column = lower.column(self.facets[position] as usize);
            for (&ridge, &coefficient) in column.rows().iter().zip(column.entries()) {
                let place = self.use_of(ridge).unwrap_or_else(|| {
                    self.places[ridge as usize] = self.uses.len() as u32;
                    self.uses.push(RidgeUse { ridge, count: 0, facets: [0; 2], coefficients: [0; 2] });
                    self.uses.len() - 1
                });
                let at = &mut self.uses[place];
                if at.count < 2 {
                    at.facets[at.count as usize] = position as u32;
                    at.coefficients[at.count as usize] = coefficient;
                }
                at.count += 1;
            }
        }
    }

    fn propagate(&mut self, lower: &SparseMatrix, cell: usize) -> Result<(), Error> {
        let count = self.facets.len();
        self.signs.clear();
        self.signs.resize(count, 0);
        self.patches.clear();
        self.patches.resize(count, 0);
        let mut patch = 0;
        for first in 0..count {
            if self.signs[first] != 0 {
                continue;
            }
            self.signs[first] = 1;
            self.patches[first] = patch;
            self.stack.push(first as u32);
            while let Some(position) = self.stack.pop() {
                for &ridge in lower.column(self.facets[position as usize] as usize).rows() {
                    let at = &self.uses[self.places[ridge as usize] as usize];
                    if at.count != 2 {
                        continue;
                    }
                    let own = usize::from(at.facets[1] == position);
                    let (next, [c, d]) =
                        (at.facets[1 - own] as usize, [own, 1 - own].map(|i| at.coefficients[i]));
                    if c.abs() != d.abs() {
                        self.stack.clear();
                        return Err(self.no_cycle(cell, ridge));
                    }
                    // sign * c + next sign * d = 0.
                    let sign =
                        if c == d { -self.signs[position as usize] } else { self.signs[position as usize] };
                    if self.signs[next] == 0 {
                        self.signs[next] = sign;
                        self.patches[next] = patch;
                        self.stack.push(next as u32);
                    } else if self.signs[next] != sign {
                        self.stack.clear();
                        return Err(self.odd_chain(lower, cell));
                    }
                }
            }
            patch += 1;
        }
        Ok(())
    }

    /// Relates the patches that propagation has found, where they are no cycles by themselves.
    fn join_at_pinched_ridges(&mut self, lower: &SparseMatrix, cell: usize) -> Result<(), Error> {
        let mut terms = Vec::new();
        for (position, &facet) in self.facets.iter().enumerate() {
            let column = lower.column(facet as usize);
            for (&ridge, &coefficient) in column.rows().iter().zip(column.entries()) {
                if self.uses[self.places[ridge as usize] as usize].count > 2 {
                    let value = i64::from(coefficient) * i64::from(self.signs[position]);
                    terms.push((ridge, self.patches[position], value));
                }
            }
        }
        let patch_count = self.patches.iter().max().map_or(0, |&last| last as usize + 1);
        match join_patches(patch_count, terms) {
            Ok(joined) => {
                for (sign, patch) in self.signs.iter_mut().zip(&mut self.patches) {
                    let (component, turn) = joined[*patch as usize];
                    *sign *= turn.to_i32();
                    *patch = component;
                }
                Ok(())
            }
            Err(PinchedRidge::Open(ridge)) => Err(self.no_cycle(cell, ridge)),
            Err(PinchedRidge::Undecided(ridge)) => Err(Error::new(
                ErrorKind::NonManifold,
                format!(
                    "the boundary of cell {cell} is pinched at ridge {ridge}, in {} of its facets, and signs do not follow there",
                    self.use_of(ridge).map_or(0, |place| self.uses[place].count)
                ),
            )
            .with_cure("split the cell, or give its boundary with signs")),
        }
    }

    fn no_cycle(&self, cell: usize, ridge: u32) -> Error {
        let count = self.use_of(ridge).map_or(0, |place| self.uses[place].count);
        Error::new(
            ErrorKind::NotACycle,
            format!("no signs close the boundary of cell {cell} at ridge {ridge}, which lies in {count} of its facets"),
        )
        .with_cure("look for facets that are missing or superfluous there")
    }

    /// The error for a cell whose facets cannot be oriented.
    fn odd_chain(&self, lower: &SparseMatrix, cell: usize) -> Error {
        let walls = self.uses.iter().map(|at| match at.count {
            2 => [0, 1].map(|i| at.facets[i] << 1 | u32::from(at.coefficients[i] < 0)).to_vec(),
            _ => Vec::new(),
        });
        let graph = FacetGraph {
            facets: &self.facets,
            lower,
            places: &self.places,
            walls: RaggedArray::from_lists(walls),
        };
        let found: CellCoherence = coherence(&graph);
        let chain = found.odd_cycle.map_or_else(Vec::new, |cycle| cycle.cells);
        let mut names: Vec<String> =
            chain.iter().take(16).map(|&position| self.facets[position.index()].to_string()).collect();
        if chain.len() > names.len() {
            names.push(format!("and {} more", chain.len() - names.len()));
        }
        Error::new(
            ErrorKind::NonManifold,
            format!(
                "the boundary of cell {cell} is not orientable: its facets {} are a closed chain that cannot agree",
                names.join(", ")
            ),
        )
        .with_cure("such a complex has no integral chains with these cells; subdivide the cell")
    }
}

fn check_facets(facet_count: usize, cell: usize, sorted: &[u32]) -> Result<(), Error> {
    let Some(&last) = sorted.last() else {
        return Err(Error::invalid(format!("cell {cell} has no facet")).with_cure("leave it out"));
    };
    if last as usize >= facet_count {
        return Err(Error::invalid(format!(
            "cell {cell} names the facet {last}, but there are {facet_count}"
        )));
    }
    match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(Error::invalid(format!("cell {cell} names the facet {} twice", pair[0]))
            .with_cure("a facet that a cell has on both sides is not part of its boundary: leave it out")),
        None => Ok(()),
    }
}

/// The facets of one cell as nodes, its ridges as walls.
struct FacetGraph<'a> {
    facets: &'a [u32],
    lower: &'a SparseMatrix,
    places: &'a [u32],
    /// For each ridge of the cell its facets; none at pinched ridges.
    walls: RaggedArray,
}

impl DualGraph for FacetGraph<'_> {
    fn node_count(&self) -> usize {
        self.facets.len()
    }

    fn facet_count(&self) -> usize {
        self.walls.len()
    }

    fn facets_of(&self, node: u32) -> impl Iterator<Item = u32> {
        let ridges = self.lower.column(self.facets[node as usize] as usize).rows();
        ridges.iter().map(|&ridge| self.places[ridge as usize])
    }

    fn nodes_at(&self, wall: usize) -> &[u32] {
        self.walls.list(wall)
    }
}
