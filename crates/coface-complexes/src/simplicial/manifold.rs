//! Whether a complex is a combinatorial manifold, with a certificate or a witness.
//!
//! A complex of dimension n is a **combinatorial manifold** when the link of every vertex is a sphere or a ball of
//! dimension n - 1 in the piecewise linear sense; then the link of every k-simplex is one of dimension n - k - 1. Up to
//! dimension 4 every triangulated topological manifold is combinatorial; from 5 on some are not (the double suspension of
//! the Poincare sphere is the 5-sphere), so there "no" speaks of combinatorial manifolds only.

use super::links::{Links, Recognition};
use super::orientation::maximal_below_top;
use super::{FrozenComplex, Simplex, SimplicialComplex};
use crate::verdict::{Decision, LinkFindings, Verdict};
use coface_algebra::Error;
use coface_algebra::UnionFind;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use rayon::prelude::*;
use std::fmt;

/// Whether a complex is a combinatorial manifold, with or without boundary: yes if every link is a sphere or a ball.
pub type ManifoldVerdict = Verdict<ManifoldWitness, LinkFindings>;

/// So many simplices of links of dimension 3 and more are looked at for a verdict, unless another bound is given: a few seconds' work.
pub const LINK_BUDGET: u64 = 200_000_000;

/// Why a test stops: no or unknown.
type Refusal = Box<Decision<ManifoldWitness>>;

/// What is wrong with a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum LinkFault {
    /// The first cell is a maximal simplex below the top dimension.
    NotPure,
    /// The first cell is a ridge in three facets or more, which follow.
    BranchingRidge,
    /// The link of the first cell falls apart; one facet of each part of the star follows.
    LinkNotConnected,
    /// The link of the first cell is a surface other than the sphere and the disk.
    LinkNotASphere,
    /// The link of the first cell has not the homology of a sphere or ball.
    LinkHomology,
    /// The link of the first cell has the homology of a sphere or ball, but was not seen to be one.
    LinkNotRecognized,
    /// The link of the first cell has the homology of a sphere or ball, but is not simply connected.
    LinkNotSimplyConnected,
    /// The complex is too large to be tested.
    TooLarge,
}

impl LinkFault {
    /// The word of the report.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::NotPure => "not_pure",
            Self::BranchingRidge => "branching_ridge",
            Self::LinkNotConnected => "link_not_connected",
            Self::LinkNotASphere => "link_not_a_sphere",
            Self::LinkHomology => "link_homology",
            Self::LinkNotRecognized => "link_not_recognized",
            Self::LinkNotSimplyConnected => "link_not_simply_connected",
            Self::TooLarge => "too_large",
        }
    }
}

/// Where a complex is no manifold, or is not seen to be one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ManifoldWitness {
    fault: LinkFault,
    cells: Vec<Simplex>,
    count: usize,
    message: String,
}

impl ManifoldWitness {
    /// For the verdicts of the crates above.
    #[doc(hidden)]
    pub fn new(fault: LinkFault, cells: Vec<Simplex>, count: usize, message: String) -> Self {
        Self { fault, cells, count, message }
    }

    /// What is wrong.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let verdict = SimplicialComplex::from_facets([[0, 1, 2], [2, 3, 4]])?.manifold_verdict()?;
    /// let witness = verdict.witness().expect("two triangles touch in a vertex");
    /// assert_eq!(witness.fault().as_str(), "link_not_connected");
    /// # Ok(()) }
    /// ```
    pub fn fault(&self) -> LinkFault {
        self.fault
    }

    /// The simplex whose link is meant, and after it those that [`LinkFault`] says.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let verdict = SimplicialComplex::from_facets([[0, 1, 2], [2, 3, 4]])?.manifold_verdict()?;
    /// let witness = verdict.witness().expect("two triangles touch in a vertex");
    /// assert_eq!(witness.cells()[0].dimension(), 0);
    /// # Ok(()) }
    /// ```
    pub fn cells(&self) -> &[Simplex] {
        &self.cells
    }

    /// How many simplices of the same dimension have the same fault; the one shown is the first.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let verdict = SimplicialComplex::from_facets([[0, 1, 2], [2, 3, 4]])?.manifold_verdict()?;
    /// let witness = verdict.witness().expect("two triangles touch in a vertex");
    /// assert_eq!(witness.count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn count(&self) -> usize {
        self.count
    }

    /// One sentence for people.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let verdict = SimplicialComplex::from_facets([[0, 1, 2], [2, 3, 4]])?.manifold_verdict()?;
    /// let witness = verdict.witness().expect("two triangles touch in a vertex");
    /// assert!(!witness.message().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for ManifoldWitness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// The simplices of a complex by degree and number, with the faces that a position leaves out.
pub(super) struct Cells<'a> {
    pub(super) complex: &'a FrozenComplex,
    pub(super) chains: &'a ChainComplex,
    pub(super) dimension: usize,
}

impl Cells<'_> {
    /// The face of a simplex that leaves out the vertex at a position. In lexicographic order of simplices, the facets
    /// of one come last position first.
    pub(super) fn face(&self, degree: usize, cell: usize, position: usize) -> usize {
        let matrix = self.chains.boundary_matrix(degree).expect("simplices above dimension 0 have faces");
        matrix.rows()[cell * (degree + 1) + degree - position] as usize
    }

    /// The face that leaves out several positions, given rising.
    pub(super) fn face_without(&self, degree: usize, cell: usize, positions: &[usize]) -> usize {
        let mut at = cell;
        for (step, &position) in positions.iter().rev().enumerate() {
            at = self.face(degree - step, at, position);
        }
        at
    }

    pub(super) fn facet_count(&self) -> usize {
        self.chains.cell_count(self.dimension)
    }

    pub(super) fn named(&self, degree: usize, cell: usize) -> Simplex {
        self.complex.simplex(degree, cell)
    }

    fn top(&self, facets: impl IntoIterator<Item = u32>) -> impl Iterator<Item = Simplex> {
        facets.into_iter().map(|facet| self.named(self.dimension, facet as usize))
    }
}

/// All ways to choose `size` of the positions `0..count`, each rising, in lexicographic order.
pub(super) fn subsets(count: usize, size: usize) -> Vec<Vec<usize>> {
    let mut all = Vec::new();
    fn extend(from: usize, count: usize, size: usize, chosen: &mut Vec<usize>, all: &mut Vec<Vec<usize>>) {
        if chosen.len() == size {
            return all.push(chosen.clone());
        }
        for i in from..count {
            chosen.push(i);
            extend(i + 1, count, size, chosen, all);
            chosen.pop();
        }
    }
    extend(0, count, size, &mut Vec::with_capacity(size), &mut all);
    all
}

/// Ridges and the one or two facets at each: facet number and position left out.
struct Ridges {
    /// For each ridge the first facet and, if there is one, the second.
    sides: Vec<[(u32, u32); 2]>,
    boundary_count: usize,
}

const NONE: u32 = u32::MAX;

impl Ridges {
    /// The facets at each ridge, or the first ridge in three facets and how many such ridges there are.
    fn new(cells: &Cells<'_>) -> Result<Self, (usize, usize)> {
        let n = cells.dimension;
        let mut sides = vec![[(NONE, 0); 2]; cells.chains.cell_count(n - 1)];
        let mut branching: Vec<usize> = Vec::new();
        for facet in 0..cells.facet_count() {
            for position in 0..=n {
                let ridge = cells.face(n, facet, position);
                match sides[ridge].iter_mut().find(|side| side.0 == NONE) {
                    Some(side) => *side = (facet as u32, position as u32),
                    None => branching.push(ridge),
                }
            }
        }
        branching.sort_unstable();
        branching.dedup();
        match branching.first() {
            Some(&first) => Err((first, branching.len())),
            None => {
                let boundary_count = sides.iter().filter(|side| side[1].0 == NONE).count();
                Ok(Self { sides, boundary_count })
            }
        }
    }

    /// The parts into which the star of each simplex of this codimension falls when facets meet in ridges only: as a
    /// partition of the corners, the pairs of a facet and such a face of it.
    fn corner_parts(&self, cells: &Cells<'_>, corners: &[Vec<usize>], codimension: usize) -> UnionFind {
        let n = cells.dimension;
        // corner_of[p][i]: the corner that leaves out p and, of the ridge opposite to p, the i-th choice of positions.
        let of_ridge = subsets(n, codimension - 1);
        let corner_of: Vec<Vec<u32>> = (0..=n)
            .map(|p| {
                let corner = |choice: &Vec<usize>| {
                    let mut left_out: Vec<usize> =
                        choice.iter().map(|&i| if i < p { i } else { i + 1 }).collect();
                    left_out.push(p);
                    left_out.sort_unstable();
                    corners.binary_search(&left_out).expect("all choices of positions are listed") as u32
                };
                of_ridge.iter().map(corner).collect()
            })
            .collect();
        let width = corners.len() as u32;
        let mut parts = UnionFind::new(cells.facet_count() * corners.len());
        for &[(f, p), (g, q)] in &self.sides {
            if g != NONE {
                for (a, b) in corner_of[p as usize].iter().zip(&corner_of[q as usize]) {
                    parts.unite(f * width + a, g * width + b);
                }
            }
        }
        parts
    }
}

impl SimplicialComplex {
    /// Whether this is a combinatorial manifold, with or without boundary: yes with a certificate, no with a witness, or
    /// unknown with the link that was not recognized.
    ///
    /// Exact up to dimension 3: there the links are points, circles, paths, and surfaces, which the Euler characteristic
    /// tells apart. From dimension 4 on a link of dimension 3 or more is a sphere if it collapses to a point once a facet
    /// is taken out, a ball if it collapses, and neither if its homology is wrong; a homology sphere that does not
    /// collapse in any of the orders tried leaves the verdict unknown. No algorithm decides all cases.
    ///
    /// The first fault is reported, in this order: a facet below the top dimension, a ridge in three facets, links of
    /// dimension 1, 2, 3, ...
    ///
    /// # Complexity
    /// Nearly linear in the number of simplices up to dimension 3; above, also in the sizes of all links.
    ///
    /// # References
    /// W. B. R. Lickorish, *Simplicial moves on complexes and manifolds* (1999); J. H. C. Whitehead, *Simplicial spaces,
    /// nuclei and m-groups* (1939).
    ///
    /// # Examples
    /// Two triangles that touch in a vertex only:
    /// ```
    /// use coface_complexes::simplicial::{LinkFault, Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let touching = SimplicialComplex::from_facets([[0, 1, 2], [2, 3, 4]])?;
    /// let verdict = touching.manifold_verdict()?;
    /// assert_eq!(verdict.as_str(), "no");
    /// let witness = verdict.witness().expect("no has a witness");
    /// assert_eq!(witness.fault(), LinkFault::LinkNotConnected);
    /// assert_eq!(witness.cells()[0], Simplex::from([2]));
    /// # Ok(()) }
    /// ```
    ///
    /// # Errors
    /// As the chain complex of the complex.
    pub fn manifold_verdict(&self) -> Result<ManifoldVerdict, Error> {
        self.freeze().manifold_verdict()
    }
}

impl FrozenComplex {
    /// Whether this is a combinatorial manifold: see [`SimplicialComplex::manifold_verdict`].
    ///
    /// # Errors
    /// As [`FrozenComplex::chain_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]))?;
    /// assert_eq!(disk.manifold_verdict()?.to_bool(), Some(true));
    /// # Ok(()) }
    /// ```
    pub fn manifold_verdict(&self) -> Result<ManifoldVerdict, Error> {
        Ok(self.manifold_verdict_with(&self.chain_complex()?))
    }

    /// The same verdict, when the chain complex of this complex has been made already.
    ///
    /// # Panics
    /// If `chains` has other numbers of cells than this complex.
    pub fn manifold_verdict_with(&self, chains: &ChainComplex) -> ManifoldVerdict {
        self.manifold_verdict_within(chains, LINK_BUDGET)
    }

    /// The same verdict, with another bound than [`LINK_BUDGET`] on the simplices of links to look at; `u64::MAX` is none. Beyond it the
    /// verdict is unknown, with the fault [`LinkFault::TooLarge`].
    ///
    /// # Panics
    /// If `chains` has other numbers of cells than this complex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::complex_projective_plane;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = complex_projective_plane()?.freeze();
    /// let chains = plane.chain_complex()?;
    /// assert_eq!(plane.manifold_verdict_within(&chains, u64::MAX).as_str(), "yes");
    /// assert_eq!(plane.manifold_verdict_within(&chains, 10).as_str(), "unknown");
    /// # Ok(()) }
    /// ```
    pub fn manifold_verdict_within(&self, chains: &ChainComplex, budget: u64) -> ManifoldVerdict {
        assert_eq!(chains.f_vector(), self.f_vector(), "the chain complex is that of this complex");
        let mut findings = LinkFindings { boundary_facet_count: 0, collapsed_link_count: 0 };
        // The empty complex is a manifold of every dimension.
        let Some(dimension) = self.dimension() else {
            return Verdict { decision: Decision::Yes, is_closed: true, findings };
        };
        findings.boundary_facet_count = boundary_ridge_count(chains, dimension);
        let decision = match test(&Cells { complex: self, chains, dimension }, &mut findings, budget) {
            Ok(()) => Decision::Yes,
            Err(refusal) => *refusal,
        };
        Verdict { decision, is_closed: findings.boundary_facet_count == 0, findings }
    }
}

/// The number of ridges in one facet only.
fn boundary_ridge_count(chains: &ChainComplex, dimension: usize) -> usize {
    let Some(boundary) = chains.boundary_matrix(dimension) else { return 0 };
    let mut degrees = vec![0u8; boundary.row_count()];
    for &ridge in boundary.rows() {
        let degree = &mut degrees[ridge as usize];
        *degree = degree.saturating_add(1);
    }
    degrees.iter().filter(|&&degree| degree == 1).count()
}

fn no(witness: ManifoldWitness) -> Refusal {
    Box::new(Decision::No(witness))
}

fn test(cells: &Cells<'_>, findings: &mut LinkFindings, budget: u64) -> Result<(), Refusal> {
    let n = cells.dimension;
    if n == 0 {
        return Ok(());
    }
    test_purity(cells)?;
    let ridges = Ridges::new(cells).map_err(|(ridge, count)| branching(cells, ridge, count))?;
    if n >= 2 {
        test_connected_links(cells, &ridges, 2)?;
    }
    if n >= 3 {
        test_connected_links(cells, &ridges, 3)?;
        test_surface_links(cells, &ridges)?;
    }
    if n >= 4 { test_high_links(cells, findings, budget) } else { Ok(()) }
}

/// The links of dimension 3 and more, when those of lower dimension are spheres and balls.
///
/// The links of the vertices decide: where moves or collapses show that they are spheres and balls, nothing else has to be looked at. If
/// some stay open, the links of all simplices are tested from the smallest on.
fn test_high_links(cells: &Cells<'_>, findings: &mut LinkFindings, budget: u64) -> Result<(), Refusal> {
    let n = cells.dimension;
    let steps = stage("recognizing links", 0);
    let mut spent = 0u64;
    if n > 4 {
        let links = Links::new(cells, n);
        spend(cells, &mut spent, links.work(), budget)?;
        let is_certified = |cell| {
            steps.advance(1);
            links.is_certified_by_moves(cells, cell)
        };
        if (0..links.count()).into_par_iter().all(is_certified) {
            findings.collapsed_link_count += links.count();
            return Ok(());
        }
    }
    // From here on the links to test are manifolds, as long as all links before were recognized.
    let mut unknown: Option<ManifoldWitness> = None;
    for codimension in 4..=n {
        let links = Links::new(cells, codimension);
        spend(cells, &mut spent, links.work(), budget)?;
        let seen: Vec<Recognition> = (0..links.count())
            .into_par_iter()
            .map(|cell| {
                steps.advance(1);
                links.recognize(cells, cell, unknown.is_none())
            })
            .collect();
        let all = |sought| (0..seen.len()).filter(|&cell| seen[cell] == sought).collect::<Vec<usize>>();
        let degree = n - codimension;
        let witness = |fault: LinkFault, found: Vec<usize>| links.witness(cells, degree, &found, fault);
        let wrong = all(Recognition::WrongHomology);
        if !wrong.is_empty() {
            return Err(no(witness(LinkFault::LinkHomology, wrong)));
        }
        let open = all(Recognition::Open);
        if !open.is_empty() {
            unknown.get_or_insert_with(|| witness(LinkFault::LinkNotRecognized, open));
        }
        findings.collapsed_link_count += links.count();
    }
    match unknown {
        Some(witness) => Err(Box::new(Decision::Unknown(witness))),
        None => Ok(()),
    }
}

/// Adds work to what is spent, and gives up when that is more than the budget.
fn spend(cells: &Cells<'_>, spent: &mut u64, work: u64, budget: u64) -> Result<(), Refusal> {
    *spent = spent.saturating_add(work);
    if *spent <= budget {
        return Ok(());
    }
    Err(Box::new(Decision::Unknown(ManifoldWitness {
        fault: LinkFault::TooLarge,
        cells: Vec::new(),
        count: 0,
        message: format!(
            "the links of a complex with {} facets of dimension {} have more than {budget} simplices to look at",
            cells.facet_count(),
            cells.dimension
        ),
    })))
}

fn test_purity(cells: &Cells<'_>) -> Result<(), Refusal> {
    let Some((degree, maximal)) = maximal_below_top(cells.chains) else { return Ok(()) };
    let simplex = cells.named(degree, maximal[0]);
    Err(no(ManifoldWitness {
        fault: LinkFault::NotPure,
        message: format!(
            "{simplex} is a face of no simplex of dimension {}: the complex is not pure",
            cells.dimension
        ),
        cells: vec![simplex],
        count: maximal.len(),
    }))
}

fn branching(cells: &Cells<'_>, ridge: usize, count: usize) -> Refusal {
    let n = cells.dimension;
    let facets: Vec<u32> = (0..cells.facet_count() as u32)
        .filter(|&facet| (0..=n).any(|position| cells.face(n, facet as usize, position) == ridge))
        .collect();
    let simplex = cells.named(n - 1, ridge);
    no(ManifoldWitness {
        fault: LinkFault::BranchingRidge,
        message: format!(
            "{simplex} lies in {} simplices of dimension {n}; a manifold allows two",
            facets.len()
        ),
        cells: std::iter::once(simplex).chain(cells.top(facets)).collect(),
        count,
    })
}

/// Each star of a simplex of this codimension is connected through ridges.
fn test_connected_links(cells: &Cells<'_>, ridges: &Ridges, codimension: usize) -> Result<(), Refusal> {
    let n = cells.dimension;
    let corners = subsets(n + 1, codimension);
    require_size(cells, corners.len())?;
    let mut parts = ridges.corner_parts(cells, &corners, codimension);
    let degree = n - codimension;
    let count = cells.chains.cell_count(degree);
    if parts.class_count() == count {
        return Ok(());
    }
    // Each simplex has a part at least, so some have more.
    let split = split_cells(cells, &corners, degree, &mut parts);
    let cell = split.iter().position(|&s| s).expect("more parts than simplices split one");
    let mut seen: Vec<(u32, u32)> = Vec::new();
    for facet in 0..cells.facet_count() {
        for (i, positions) in corners.iter().enumerate() {
            if cells.face_without(n, facet, positions) == cell {
                let root = parts.find((facet * corners.len() + i) as u32);
                if seen.iter().all(|&(_, r)| r != root) {
                    seen.push((facet as u32, root));
                }
            }
        }
    }
    let simplex = cells.named(degree, cell);
    Err(no(ManifoldWitness {
        fault: LinkFault::LinkNotConnected,
        message: format!(
            "the link of {simplex} falls into {} parts; that of a manifold is connected",
            seen.len()
        ),
        cells: std::iter::once(simplex).chain(cells.top(seen.iter().map(|&(facet, _)| facet))).collect(),
        count: split.iter().filter(|&&s| s).count(),
    }))
}

/// Which simplices of a degree have corners, one for each choice of positions left out of a facet, in several parts.
pub(super) fn split_cells(
    cells: &Cells<'_>,
    corners: &[Vec<usize>],
    degree: usize,
    parts: &mut UnionFind,
) -> Vec<bool> {
    let count = cells.chains.cell_count(degree);
    let (mut first_root, mut split) = (vec![NONE; count], vec![false; count]);
    for facet in 0..cells.facet_count() {
        for (i, positions) in corners.iter().enumerate() {
            let root = parts.find((facet * corners.len() + i) as u32);
            let cell = cells.face_without(cells.dimension, facet, positions);
            if first_root[cell] == NONE {
                first_root[cell] = root;
            }
            split[cell] |= first_root[cell] != root;
        }
    }
    split
}

/// More corners than a union-find holds cannot be told apart.
fn require_size(cells: &Cells<'_>, corners_of_facet: usize) -> Result<(), Refusal> {
    if cells.facet_count().saturating_mul(corners_of_facet) < 1 << 31 {
        return Ok(());
    }
    Err(Box::new(Decision::Unknown(ManifoldWitness {
        fault: LinkFault::TooLarge,
        cells: Vec::new(),
        count: 0,
        message: format!(
            "{} facets of dimension {} are too many to test",
            cells.facet_count(),
            cells.dimension
        ),
    })))
}

/// The links of codimension 3, which are connected surfaces by now, are spheres or disks.
fn test_surface_links(cells: &Cells<'_>, ridges: &Ridges) -> Result<(), Refusal> {
    let surfaces = SurfaceLinks::new(cells, ridges);
    let bad = surfaces.bad();
    let Some(&cell) = bad.first() else { return Ok(()) };
    let simplex = cells.named(cells.dimension - 3, cell as usize);
    let (has, wanted) = if surfaces.has_boundary[cell as usize] {
        ("a boundary and", "disk has 1")
    } else {
        ("no boundary and", "sphere has 2")
    };
    Err(no(ManifoldWitness {
        fault: LinkFault::LinkNotASphere,
        message: format!(
            "the link of {simplex} is a surface with {has} Euler characteristic {}; a {wanted}",
            surfaces.euler_characteristics[cell as usize]
        ),
        cells: vec![simplex],
        count: bad.len(),
    }))
}

/// The simplices whose links, known to be surfaces, are neither spheres nor disks; none if a ridge lies in three facets.
pub(super) fn bad_surface_links(cells: &Cells<'_>) -> Vec<u32> {
    Ridges::new(cells).map_or_else(|_| Vec::new(), |ridges| SurfaceLinks::new(cells, &ridges).bad())
}

/// What tells a sphere or disk from other surfaces, for the link of each simplex of codimension 3.
struct SurfaceLinks {
    euler_characteristics: Vec<i64>,
    has_boundary: Vec<bool>,
}

impl SurfaceLinks {
    fn new(cells: &Cells<'_>, ridges: &Ridges) -> Self {
        let n = cells.dimension;
        let degree = n - 3;
        let mut euler_characteristics = vec![0i64; cells.chains.cell_count(degree)];
        // A vertex, edge or triangle of the link is a simplex 1, 2 or 3 dimensions above.
        for (above, weight) in [(1, 1), (2, -1), (3, 1)] {
            let choices = subsets(degree + above + 1, above);
            for cell in 0..cells.chains.cell_count(degree + above) {
                for positions in &choices {
                    euler_characteristics[cells.face_without(degree + above, cell, positions)] += weight;
                }
            }
        }
        let mut has_boundary = vec![false; euler_characteristics.len()];
        if ridges.boundary_count > 0 {
            let choices = subsets(n, 2);
            for (ridge, side) in ridges.sides.iter().enumerate() {
                if side[1].0 == NONE {
                    for positions in &choices {
                        has_boundary[cells.face_without(n - 1, ridge, positions)] = true;
                    }
                }
            }
        }
        Self { euler_characteristics, has_boundary }
    }

    fn bad(&self) -> Vec<u32> {
        let of = self.euler_characteristics.iter().zip(&self.has_boundary);
        let is_bad =
            of.map(|(&characteristic, &has_boundary)| characteristic != if has_boundary { 1 } else { 2 });
        (0u32..).zip(is_bad).filter(|&(_, is_bad)| is_bad).map(|(cell, _)| cell).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::known_spaces;
    use proptest::prelude::*;

    #[derive(Clone, Copy, PartialEq, Eq)]
    enum Kind {
        Sphere,
        Ball,
        Neither,
    }

    /// The definition word for word, up to dimension 2: what a link is.
    fn kind(link: &SimplicialComplex, dimension: usize) -> Kind {
        if dimension == 0 {
            return match link.f_vector().as_slice() {
                [2] => Kind::Sphere,
                [1] => Kind::Ball,
                _ => Kind::Neither,
            };
        }
        if !is_manifold(link, dimension) || link.components().count() != 1 {
            return Kind::Neither;
        }
        let closed = vertex_kinds(link, dimension).all(|k| k == Kind::Sphere);
        match (closed, dimension, link.euler_characteristic()) {
            (true, 1, _) | (true, 2, 2) => Kind::Sphere,
            (false, 1, _) | (false, 2, 1) => Kind::Ball,
            _ => Kind::Neither,
        }
    }

    fn vertex_kinds(complex: &SimplicialComplex, dimension: usize) -> impl Iterator<Item = Kind> {
        complex.vertices().map(move |v| kind(&complex.link(Simplex::vertex(v)).unwrap(), dimension - 1))
    }

    fn is_manifold(complex: &SimplicialComplex, dimension: usize) -> bool {
        complex.facets().iter().all(|facet| facet.dimension() == dimension)
            && (dimension == 0 || vertex_kinds(complex, dimension).all(|k| k != Kind::Neither))
    }

    /// Some facets of a closed manifold, and sometimes a foreign one.
    fn part_of(whole: &SimplicialComplex) -> impl Strategy<Value = SimplicialComplex> + use<> {
        let facets = whole.facets();
        let (size, width) = (facets.len(), facets[0].vertex_count());
        let foreign = prop::option::weighted(0.2, prop::collection::btree_set(0u32..8, 1..=width));
        (prop::collection::vec(prop::bool::weighted(0.7), size), foreign).prop_map(
            move |(chosen, foreign)| {
                let kept = facets.iter().zip(chosen).filter(|(_, c)| *c).map(|(f, _)| f.numbers().to_vec());
                SimplicialComplex::from_facets(kept.chain(foreign.map(|f| f.into_iter().collect()))).unwrap()
            },
        )
    }

    fn any_part() -> impl Strategy<Value = SimplicialComplex> {
        let wholes = [
            known_spaces::circle(6),
            known_spaces::cross_polytope_boundary(2),
            known_spaces::cyclic_torus(2),
            known_spaces::projective_plane(),
            known_spaces::simplex_boundary(3),
            known_spaces::cross_polytope_boundary(3),
            known_spaces::projective_plane().and_then(|plane| Ok(plane.suspension()?.0)),
        ];
        prop::strategy::Union::new(wholes.map(|whole| part_of(&whole.unwrap()).boxed()))
    }

    proptest! {
        #[test]
        fn the_verdict_is_the_definition_up_to_dimension_3(complex in any_part()) {
            let expected = complex.dimension().is_none_or(|n| is_manifold(&complex, n));
            let verdict = complex.manifold_verdict().unwrap();
            prop_assert_eq!(verdict.to_bool(), Some(expected), "{:?}", verdict);
            let boundary_facet_count = verdict.findings().boundary_facet_count();
            prop_assert_eq!(verdict.is_closed(), boundary_facet_count == 0);
            match &verdict.decision {
                Decision::Yes => {
                    let boundary = complex.boundary_complex(&complex).unwrap();
                    prop_assert_eq!(verdict.is_closed(), boundary.is_empty());
                    if let Some(n) = boundary.dimension() {
                        prop_assert_eq!(boundary_facet_count, boundary.simplex_count(n));
                        prop_assert!(boundary.boundary_complex(&boundary).unwrap().is_empty());
                        prop_assert_eq!(boundary.manifold_verdict().unwrap().to_bool(), Some(true));
                    }
                }
                Decision::No(witness) => check_witness(&complex, witness),
                Decision::Unknown(_) => prop_assert!(false),
            }
        }
    }

    /// The cells of a witness have the fault it names.
    fn check_witness(complex: &SimplicialComplex, witness: &ManifoldWitness) {
        let n = complex.dimension().unwrap();
        let (first, rest) = witness.cells().split_first().unwrap();
        let link = complex.link(first).unwrap();
        assert!(rest.iter().all(|facet| first.is_face_of(facet) && facet.dimension() == n));
        match witness.fault() {
            LinkFault::NotPure => assert!(link.is_empty() && first.dimension() < n),
            LinkFault::BranchingRidge => assert!(rest.len() == link.len() && rest.len() > 2),
            LinkFault::LinkNotConnected => {
                let parts = link.components().members();
                assert!(parts.len() == rest.len() && rest.len() > 1);
                for facet in rest {
                    let own = facet.difference(first).unwrap().vertices().next().unwrap();
                    assert_eq!(parts.iter().filter(|part| part.contains(&own)).count(), 1);
                }
            }
            LinkFault::LinkNotASphere => {
                assert!(is_manifold(&link, 2) && kind(&link, 2) == Kind::Neither && rest.is_empty());
            }
            fault => panic!("{fault:?} cannot be up to dimension 3"),
        }
        assert!(witness.count() > 0 && !witness.message().is_empty());
    }

    fn witness_of(complex: &SimplicialComplex) -> ManifoldWitness {
        complex.manifold_verdict().unwrap().witness().unwrap().clone()
    }

    #[test]
    fn witnesses_name_the_cells() {
        let book = witness_of(&known_spaces::book(3).unwrap());
        assert_eq!(book.message(), "{0, 1} lies in 3 simplices of dimension 2; a manifold allows two");
        assert_eq!(book.cells()[1..], [[0, 1, 2], [0, 1, 3], [0, 1, 4]].map(Simplex::from));
        let pinched = witness_of(&known_spaces::pinched_torus_grid(6, 6).unwrap());
        assert_eq!(pinched.message(), "the link of {0} falls into 2 parts; that of a manifold is connected");
        let torus = known_spaces::cyclic_torus(2).unwrap();
        let cone = witness_of(&torus.cone().unwrap().0);
        assert_eq!(
            cone.message(),
            "the link of {7} is a surface with no boundary and Euler characteristic 0; a sphere has 2"
        );
        let suspension = witness_of(&torus.suspension().unwrap().0);
        assert_eq!((suspension.count(), suspension.fault().as_str()), (2, "link_not_a_sphere"));
        let rp3 = known_spaces::real_projective_space(3).unwrap();
        let bad = witness_of(&rp3.suspension().unwrap().0);
        assert_eq!(bad.fault(), LinkFault::LinkHomology);
        assert!(bad.message().contains("the Betti numbers 1 0 0 1, with torsion"), "{}", bad.message());
    }

    #[test]
    fn certificates_say_what_was_seen() {
        let verdict = |complex: SimplicialComplex| complex.manifold_verdict().unwrap();
        let ball = verdict(known_spaces::simplex(4).unwrap());
        assert!(ball.is_manifold() && !ball.is_closed());
        assert_eq!(ball.findings(), &LinkFindings { boundary_facet_count: 5, collapsed_link_count: 5 });
        let empty = verdict(SimplicialComplex::new());
        assert!(empty.is_manifold() && empty.is_closed());
        let plane = verdict(known_spaces::complex_projective_plane().unwrap());
        assert!(plane.is_manifold() && plane.is_closed());
        assert_eq!(plane.findings().collapsed_link_count(), 9);
        // Where the answer is no, the boundary is known all the same: a page has three free edges.
        let book = verdict(known_spaces::book(3).unwrap());
        assert_eq!((book.to_bool(), book.is_closed()), (Some(false), false));
        assert_eq!(book.findings().boundary_facet_count(), 6);
    }

    /// Tested by the links of all its simplices, a simplex of dimension 17 takes minutes; by those of its vertices no time at all.
    #[test]
    fn large_simplices_and_joins_of_spheres_are_seen() {
        let simplex = known_spaces::simplex(15).unwrap();
        assert!(simplex.manifold_verdict().unwrap().is_manifold());
        let sphere = known_spaces::cross_polytope_boundary(5).unwrap();
        let verdict = sphere.manifold_verdict().unwrap();
        assert_eq!((verdict.as_str(), verdict.findings().collapsed_link_count()), ("yes", 12));
    }

    #[test]
    fn the_budget_ends_in_unknown() {
        let plane = known_spaces::complex_projective_plane().unwrap().freeze();
        let verdict = plane.manifold_verdict_within(&plane.chain_complex().unwrap(), 10);
        assert_eq!((verdict.as_str(), verdict.witness().unwrap().fault()), ("unknown", LinkFault::TooLarge));
    }

    /// The homology sphere of Poincare is no sphere; nothing here may say it is.
    #[test]
    fn homology_spheres_stay_open() {
        let poincare = known_spaces::glued_solid(known_spaces::Solid::Dodecahedron, 2).unwrap();
        let chains = poincare.chain_complex().unwrap();
        assert_eq!(crate::simplicial::links::homology_sizes(&chains), [(1, 0), (0, 0), (0, 0), (1, 0)]);
        assert!(!crate::simplicial::collapse::is_seen_as_sphere(&chains));
        let witness = witness_of(&poincare.suspension().unwrap().0);
        assert_eq!(witness.fault(), LinkFault::LinkNotRecognized);
    }
}
