//! Triangulations that show a Seifert fibration: stacks over triangles, glued along their sides and closed by layered solid tori.
//!
//! The base is made of a triangle for each stack, and of a disk for each solid torus, whose boundary is one side rolled up to a loop. A
//! side that is glued to itself with its ends exchanged is cut open: the fold is a solid torus without tetrahedra, and its middle a fiber of
//! multiplicity 2.
//!
//! Outside of the solid tori is a bundle of circles. A cocycle on it with value 1 on a fiber has a section as its kernel: so a meridian m has
//! the invariants that it meets a fiber α times, and that the cocycle is β on it. Where walks reverse fibers, the cocycle has its values in the
//! integers twisted along with them.
//!
//! A side that is rolled up may also be glued, directly or through layers, to another one on which other edges are vertical: there a piece ends, and
//! the section's boundary and a fiber on one side are given by those on the other.
//!
//! Source: H. Seifert, *Topologie dreidimensionaler gefaserter Raeume* (1933); B. A. Burton, *Minimal triangulations and normal
//! surfaces* (2003), for the triangulations.

use super::graph::{Fibered, GraphSpace, Matrix, Piece, TorusBundle};
use super::layered::{Corners, Slope, SolidTorus, Torus, across, fold, folded_slope, layered_edge, step};
use super::seifert::SeifertSpace;
use super::stacks::{EDGES, Stacks, Standing};
use coface_algebra::{
    CellId, Integer, ParityUnion, ParityUnionFind, Sign, SparseMatrix, UnionFind, smith_form_with_transforms,
};
use coface_complexes::gluing::{FaceClasses, GluingTable};

/// The fibered space that a closed orientable table shows, if it does, or the pieces.
pub(super) fn fibered_space(table: &GluingTable, faces: &FaceClasses) -> Option<Fibered> {
    let tori = SolidTorus::maximal(table);
    let orientation = table.orientation();
    let signs: Vec<i64> =
        (0..table.simplex_count()).map(|at| of_sign(orientation.sign(CellId::new(at)))).collect();
    let shown =
        |stacks: &Stacks| Fibration::of(table, stacks, &tori).and_then(|fibration| fibration.space(&signs));
    let whole = Stacks::all(table, faces, &tori);
    whole.iter().find_map(shown).or_else(|| Stacks::apart(table, &tori).iter().find_map(shown))
}

/// Larger entries are followed no farther: they are products of many layers, and products of them are still numbers of 64 bits.
const FARTHEST: i64 = 1 << 24;

fn of_sign(sign: Sign) -> i64 {
    if sign == Sign::Plus { 1 } else { -1 }
}

/// A hole of the bundle of circles, seen from the bundle, and the meridian of what closes it.
struct Hole {
    stack: usize,
    torus: Torus,
    meridian: [i64; 2],
}

/// Two sides with tetrahedra that lie between them.
struct Chain {
    /// The first triangle of a side, and that of the other, seen from their stacks.
    ends: [Corners; 2],
    /// Edges 01 and 02 of the other triangle in those of the first.
    edges: [Slope; 2],
    /// Whether upwards at one end is upwards at the other.
    agrees: bool,
}

/// A torus at which a piece ends: beyond it fibers are others.
struct Join {
    /// The stack and the side.
    stack: usize,
    side: usize,
    /// The torus, seen from the stack.
    torus: Torus,
    /// The stack and the side beyond.
    other_stack: usize,
    other_side: usize,
    /// The first triangle beyond, seen from its stack; its edges 01 and 02 in those of the torus.
    other: Corners,
    edges: [Slope; 2],
}

/// Where a side of a stack goes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Beyond {
    /// To a side of a stack.
    Side(usize, usize),
    /// To tetrahedra that are in no stack.
    Elsewhere,
}

/// A bundle of circles over stacks, with its holes.
struct Fibration<'a> {
    table: &'a GluingTable,
    stacks: &'a Stacks,
    holes: Vec<Hole>,
    /// The corners of the triangles of the base, three to a stack: those that are one.
    corners: UnionFind,
    /// The stacks, with signs where upwards is downwards in the next one.
    fibers: ParityUnionFind,
    chains: Vec<Chain>,
    /// The tetrahedra of chains, each from both ends.
    passed: Vec<usize>,
    joins: Vec<Join>,
    /// Stacks from which some walk reverses the fibers.
    twisted: Vec<usize>,
    /// The sides by their stacks: twice the edges of the base.
    side_counts: Vec<usize>,
}

/// A vertical triangle: a standing tetrahedron, the corner that is not over its side.
#[derive(Clone, Copy)]
struct Vertical {
    standing: Standing,
    /// The corner of the base beside the raised one that the triangle is over.
    apex: usize,
}

impl Vertical {
    /// The corner of the base across the side: the name of the side.
    fn side(self) -> usize {
        3 - self.standing.raised - self.apex
    }

    /// The vertices: lower, upper, apex, and the one across.
    fn corners(self) -> Corners {
        let Standing { tetrahedron, raised, vertices, upper } = self.standing;
        let labels = [vertices[raised], upper, vertices[self.apex], vertices[self.side()]];
        Corners { tetrahedron, labels }
    }
}

impl<'a> Fibration<'a> {
    fn of(table: &'a GluingTable, stacks: &'a Stacks, tori: &[SolidTorus]) -> Option<Self> {
        let count = 3 * stacks.stacks.len();
        let mut found = Self {
            table,
            stacks,
            holes: Vec::new(),
            chains: Vec::new(),
            passed: Vec::new(),
            corners: UnionFind::new(count),
            fibers: ParityUnionFind::new(stacks.stacks.len()),
            joins: Vec::new(),
            twisted: Vec::new(),
            side_counts: vec![0; stacks.stacks.len()],
        };
        let mut closed = vec![false; tori.len()];
        for stack in 0..stacks.stacks.len() {
            for side in 0..3 {
                found.add_side(stack, side, tori, &mut closed)?;
            }
        }
        // Each solid torus is beside the bundle, each side has another one beyond it, and each tetrahedron is somewhere.
        let lies_between = |tetrahedron| found.passed.contains(tetrahedron);
        if !stacks.lying.iter().all(lies_between) {
            return None;
        }
        closed.iter().all(|&closed| closed).then_some(found)
    }

    /// The vertical triangles over a side of a stack, from below.
    fn triangles(&self, stack: usize, side: usize) -> Vec<Vertical> {
        let of_side = |standing: &&Standing| standing.raised != side;
        let triangle =
            |standing: &Standing| Vertical { standing: *standing, apex: 3 - side - standing.raised };
        self.stacks.stacks[stack].iter().filter(of_side).map(triangle).collect()
    }

    fn add_side(
        &mut self,
        stack: usize,
        side: usize,
        tori: &[SolidTorus],
        closed: &mut [bool],
    ) -> Option<()> {
        let triangles = self.triangles(stack, side);
        let mut beyond = None;
        for triangle in &triangles {
            let next = self.beyond(stack, *triangle)?;
            if *beyond.get_or_insert(next) != next {
                return None;
            }
        }
        self.side_counts[stack] += 1;
        match beyond? {
            Beyond::Side(other, across) if (other, across) == (stack, side) => {
                let torus = rolled_up(&triangles)?;
                let edge = fold(self.table, &torus)?;
                self.holes.push(Hole { stack, torus, meridian: folded_slope(&[[1, 0], [0, 1]], edge) });
                self.side_counts[stack] += 1;
                self.close(stack, side);
            }
            Beyond::Side(..) => {}
            Beyond::Elsewhere => self.follow(stack, side, rolled_up(&triangles)?, tori, closed)?,
        }
        Some(())
    }

    /// Through tetrahedra that lie on a side, to a solid torus or to another side.
    fn follow(
        &mut self,
        stack: usize,
        side: usize,
        torus: Torus,
        tori: &[SolidTorus],
        closed: &mut [bool],
    ) -> Option<()> {
        let mut edges = [[1, 0], [0, 1]];
        let mut at = torus;
        loop {
            let [one, two] = [at[0].partner(self.table)?, at[1].partner(self.table)?];
            if self.stacks.places[one.tetrahedron].is_some() {
                return self.link(stack, side, torus, [one, two], edges);
            }
            if let Some(inner) = SolidTorus::inside(self.table, [one, two]) {
                let own = tori.iter().position(|torus| torus.tetrahedra.contains(&one.tetrahedron))?;
                if std::mem::replace(&mut closed[own], true)
                    || inner.tetrahedra.len() != tori[own].tetrahedra.len()
                {
                    return None;
                }
                // The meridian in the edges of the side.
                let [x, y] = inner.meridian;
                let meridian = [0, 1].map(|axis| x * edges[0][axis] + y * edges[1][axis]);
                self.holes.push(Hole { stack, torus, meridian });
                self.side_counts[stack] += 1;
                self.close(stack, side);
                return Some(());
            }
            let edge @ [i, j, k] = layered_edge(&[one, two])?;
            if !self.stacks.lying.contains(&one.tetrahedron)
                || edges.as_flattened().iter().any(|entry| entry.abs() > FARTHEST)
            {
                return None;
            }
            self.passed.push(one.tetrahedron);
            edges = [step(&edges, i, k), step(&edges, k, j)];
            at = across(&[one, two], edge);
        }
    }

    /// Another side behind tetrahedra that lie between: the first triangle there is over the same corner.
    fn link(
        &mut self,
        stack: usize,
        side: usize,
        torus: Torus,
        ends: Torus,
        edges: [Slope; 2],
    ) -> Option<()> {
        let places = ends.map(|corners| self.stacks.places[corners.tetrahedron]);
        let (Some((other, _)), Some((again, _))) = (places[0], places[1]) else { return None };
        let mut images = Vec::new();
        let mut fibers = Vec::new();
        for corners in ends {
            let standing = *self.stacks.standing(corners.tetrahedron)?;
            let label = |vertex: u8| corners.labels[..3].iter().position(|&label| label == vertex);
            let (lower, upper) = (label(standing.vertices[standing.raised])?, label(standing.upper)?);
            let apex = corners.labels[3 - lower - upper];
            let apex = (0..3).find(|&c| c != standing.raised && standing.vertices[c] == apex)?;
            fibers.push(step(&edges, lower, upper));
            images.push(Vertical { standing, apex });
        }
        let across = images[0].side();
        if again != other || images[1].side() != across || self.triangles(other, across).len() != 2 {
            return None;
        }
        self.close(stack, side);
        // Edge 01 of the first triangle goes upwards here.
        let agrees = match fibers[0] {
            [1, 0] => true,
            [-1, 0] => false,
            _ => {
                self.side_counts[stack] += 1;
                let (other_stack, other_side, other) = (other, across, ends[0]);
                self.joins.push(Join { stack, side, torus, other_stack, other_side, other, edges });
                return Some(());
            }
        };
        let own = self.triangles(stack, side);
        for (triangle, image) in own.iter().zip(&images) {
            let (from, to) = (3 * stack + triangle.standing.raised, 3 * other + image.standing.raised);
            self.corners.unite(from as u32, to as u32);
        }
        self.walk(stack, other, agrees);
        self.chains.push(Chain { ends: [torus[0], ends[0]], edges, agrees });
        Some(())
    }

    /// From a stack to another one, in which upwards is upwards or not.
    fn walk(&mut self, stack: usize, other: usize, agrees: bool) {
        let sign = if agrees { Sign::Plus } else { Sign::Minus };
        if self.fibers.unite(stack as u32, other as u32, sign) == ParityUnion::Contradicts {
            self.twisted.push(stack);
        }
    }

    /// A side that is rolled up has its two corners in one.
    fn close(&mut self, stack: usize, side: usize) {
        let [a, b] = [(side + 1) % 3, (side + 2) % 3];
        self.corners.unite((3 * stack + a) as u32, (3 * stack + b) as u32);
    }

    /// What a vertical triangle is glued to. Corners and fibers that are one become one.
    fn beyond(&mut self, stack: usize, triangle: Vertical) -> Option<Beyond> {
        let partner = triangle.corners().partner(self.table)?;
        let Some((other, _)) = self.stacks.places[partner.tetrahedron] else {
            return Some(Beyond::Elsewhere);
        };
        let standing = *self.stacks.standing(partner.tetrahedron)?;
        let (lower, upper) = (standing.vertices[standing.raised], standing.upper);
        let agrees = match partner.labels[..2] {
            [a, b] if (a, b) == (lower, upper) => true,
            [a, b] if (a, b) == (upper, lower) => false,
            _ => return Some(Beyond::Elsewhere),
        };
        let apex = (0..3).find(|&c| c != standing.raised && standing.vertices[c] == partner.labels[2])?;
        let image = Vertical { standing, apex };
        for (corner, other_corner) in [(triangle.standing.raised, standing.raised), (triangle.apex, apex)] {
            if (other, image.side()) != (stack, triangle.side()) {
                self.corners.unite((3 * stack + corner) as u32, (3 * other + other_corner) as u32);
            }
        }
        self.walk(stack, other, agrees);
        Some(Beyond::Side(other, image.side()))
    }

    /// The space that is fibered, or made of fibered pieces.
    fn space(mut self, signs: &[i64]) -> Option<Fibered> {
        let cocycle = Cocycle::of(&mut self)?;
        let roots: Vec<u32> = (0..self.stacks.stacks.len()).map(|at| self.fibers.find(at as u32).0).collect();
        let mut order = roots.clone();
        order.sort_unstable();
        order.dedup();
        let pieces: Option<Vec<Piece>> =
            order.iter().map(|&root| self.piece(&roots, root, &cocycle, signs)).collect();
        let mut pieces = pieces?;
        // A join is seen from both of its sides.
        let key = |join: &&Join| (join.stack, join.side) < (join.other_stack, join.other_side);
        let joins: Vec<&Join> = self.joins.iter().filter(key).collect();
        if 2 * joins.len() != self.joins.len() {
            return None;
        }
        match (&joins[..], pieces.len()) {
            ([], 1) => {
                let Piece { is_orientable, genus, fibers, .. } = pieces.remove(0);
                SeifertSpace::new(is_orientable, genus, &fibers).map(Fibered::Seifert)
            }
            (&[join], 2) => {
                let matrix = self.join_matrix(join, &cocycle, signs)?;
                if roots[join.stack] != order[0] {
                    pieces.swap(0, 1);
                }
                Fibered::of_two(pieces, matrix)
            }
            (&[join], 1) => {
                // Fibers in one direction along the whole piece.
                let direction = |stack: usize| of_sign(self.fibers.clone().find(stack as u32).1);
                let sign = direction(join.stack) * direction(join.other_stack);
                let matrix =
                    self.join_matrix(join, &cocycle, signs)?.map(|row| row.map(|entry| sign * entry));
                let piece = pieces.remove(0);
                if piece.is_orientable && piece.genus == 0 && piece.fibers.iter().all(|fiber| fiber.0 == 1) {
                    let total: i64 = piece.fibers.iter().map(|fiber| fiber.1).sum();
                    // Through the piece the second o is minus the first, and b fibers for a fiber (1, b).
                    let [one, two] = matrix;
                    let turned = [one, [total * one[0] - two[0], total * one[1] - two[1]]];
                    return TorusBundle::new(turned).map(Fibered::Bundle);
                }
                GraphSpace::new(vec![piece], matrix).map(Fibered::Graph)
            }
            _ => None,
        }
    }

    /// The stacks with one root.
    fn piece(&mut self, roots: &[u32], root: u32, cocycle: &Cocycle, signs: &[i64]) -> Option<Piece> {
        let own: Vec<usize> = (0..roots.len()).filter(|&stack| roots[stack] == root).collect();
        let mut vertices: Vec<u32> = own
            .iter()
            .flat_map(|stack| 3 * stack..3 * stack + 3)
            .map(|corner| self.corners.find(corner as u32))
            .collect();
        vertices.sort_unstable();
        vertices.dedup();
        let holes: Vec<&Hole> = self.holes.iter().filter(|hole| roots[hole.stack] == root).collect();
        let boundary_count = self.joins.iter().filter(|join| roots[join.stack] == root).count();
        let sides: usize = own.iter().map(|&stack| self.side_counts[stack]).sum();
        if !sides.is_multiple_of(2) {
            return None;
        }
        let characteristic = vertices.len() as i64 - (sides / 2) as i64 + (own.len() + holes.len()) as i64;
        let rank = usize::try_from(2 - characteristic - boundary_count as i64).ok()?;
        let is_orientable = !self.twisted.iter().any(|&stack| roots[stack] == root);
        if is_orientable && rank % 2 == 1 {
            return None;
        }
        let mut fibers = Vec::with_capacity(holes.len());
        for hole in holes {
            let [one, _] = hole.torus;
            let standing = self.stacks.standing(one.tetrahedron)?;
            let value = |a: u8, b: u8| cocycle.value(one.tetrahedron, a, b);
            let labels = one.labels;
            let [x, y] = hole.meridian;
            let beta = x * value(labels[0], labels[1])? + y * value(labels[0], labels[2])?;
            // Edge 01 is the vertical one.
            let up = if labels[1] == standing.upper { 1 } else { -1 };
            let alpha = -y * up * signs[one.tetrahedron] * parity(labels);
            if alpha == 0 {
                return None;
            }
            fibers.push(if alpha < 0 { (-alpha, -beta) } else { (alpha, beta) });
        }
        let genus = if is_orientable { rank / 2 } else { rank };
        Some(Piece { is_orientable, genus, boundary_count, fibers })
    }

    /// The fiber and the section's boundary beyond a join by those at it.
    fn join_matrix(&self, join: &Join, cocycle: &Cocycle, signs: &[i64]) -> Option<Matrix> {
        // At a torus with edges e from the lower end of a fiber h to its upper end, and f from there to the apex, the section's boundary is
        // o = c s h - s f, where c is the cocycle on f, and s the sign of the triangle.
        let one = join.torus[0];
        let [lower, upper, apex, _] = one.labels;
        let (sign, value) =
            (signs[one.tetrahedron] * parity(one.labels), cocycle.value(one.tetrahedron, lower, apex)?);
        if cocycle.value(one.tetrahedron, lower, upper)? != 1 {
            return None;
        }
        let by_own = |[x, y]: Slope| [x + value * y, -sign * y];
        let other = join.other;
        let standing = self.stacks.standing(other.tetrahedron)?;
        let label = |vertex: u8| other.labels[..3].iter().position(|&label| label == vertex);
        let (p, q) = (label(standing.vertices[standing.raised])?, label(standing.upper)?);
        let r = 3 - p - q;
        let [lower, upper, apex, across] = [p, q, r, 3].map(|place| other.labels[place]);
        let sign = signs[other.tetrahedron] * parity([lower, upper, apex, across]);
        let value = cocycle.value(other.tetrahedron, lower, apex)?;
        if cocycle.value(other.tetrahedron, lower, upper)? != 1 {
            return None;
        }
        let (fiber, side) = (step(&join.edges, p, q), step(&join.edges, p, r));
        let section = [0, 1].map(|axis| sign * value * fiber[axis] - sign * side[axis]);
        let matrix @ [[a, b], [c, d]] = [by_own(fiber), by_own(section)];
        (a * d - b * c == -1).then_some(matrix)
    }

    /// Whether a facet of a stack is at a hole, or at tetrahedra in no stack.
    fn is_open(&self, tetrahedron: usize, facet: u8) -> bool {
        let is_it = |corners: &Corners| (corners.tetrahedron, corners.labels[3]) == (tetrahedron, facet);
        let beyond = self.table.neighbor(tetrahedron, usize::from(facet)).map(|(next, _)| next);
        beyond.is_none_or(|next| self.stacks.places[next].is_none())
            || self.holes.iter().any(|hole| hole.torus.iter().any(is_it))
            || self.joins.iter().any(|join| join.torus.iter().any(is_it))
    }
}

/// The sign of an order of 0, 1, 2, 3.
fn parity(labels: [u8; 4]) -> i64 {
    let inversions = (0..4).flat_map(|i| (0..i).map(move |j| (j, i))).filter(|&(j, i)| labels[j] > labels[i]);
    if inversions.count().is_multiple_of(2) { 1 } else { -1 }
}

/// Two triangles over a side, rolled up to a torus: edge 01 is vertical, and the first triangle is below the second.
fn rolled_up(triangles: &[Vertical]) -> Option<Torus> {
    let &[below, above] = triangles else { return None };
    if below.standing.raised == above.standing.raised {
        return None;
    }
    let (one, mut two) = (below.corners(), above.corners());
    two.labels.swap(0, 1);
    Some([one, two])
}

/// A cocycle on the bundle that is 1 on a fiber, in the direction upwards of each tetrahedron.
struct Cocycle {
    edges: ParityUnionFind,
    /// The value on each edge of a tetrahedron that stands for its class.
    values: Vec<Option<i64>>,
}

/// The number of an edge of a tetrahedron, and its sign from a to b.
fn edge_number(tetrahedron: usize, a: u8, b: u8) -> Option<(u32, i64)> {
    let ends = [a.min(b), a.max(b)];
    let place = EDGES.iter().position(|edge| *edge == ends)?;
    Some(((6 * tetrahedron + place) as u32, if a < b { 1 } else { -1 }))
}

impl Cocycle {
    fn of(bundle: &mut Fibration<'_>) -> Option<Self> {
        let table = bundle.table;
        let mut found = Self {
            edges: ParityUnionFind::new(6 * table.simplex_count()),
            values: vec![None; 6 * table.simplex_count()],
        };
        let core: Vec<usize> =
            bundle.stacks.stacks.iter().flatten().map(|standing| standing.tetrahedron).collect();
        for &tetrahedron in &core {
            for facet in 0..4_u8 {
                if !bundle.is_open(tetrahedron, facet) {
                    found.unite_across(bundle, tetrahedron, facet)?;
                }
            }
        }
        found.solve(bundle, &core)?;
        Some(found)
    }

    /// Edges of a facet are those of its partner, with a sign where upwards is downwards there.
    fn unite_across(&mut self, bundle: &Fibration<'_>, tetrahedron: usize, facet: u8) -> Option<()> {
        let (other, images) = bundle.table.neighbor(tetrahedron, usize::from(facet))?;
        let (one, two) = (bundle.stacks.standing(tetrahedron)?, bundle.stacks.standing(other)?);
        let (lower, upper) = (one.vertices[one.raised], one.upper);
        let is_vertical = facet != lower && facet != upper;
        let agrees = !is_vertical || images[usize::from(upper)] == two.upper;
        for [a, b] in EDGES.into_iter().filter(|ends| !ends.contains(&facet)) {
            let (from, sign) = edge_number(tetrahedron, a, b)?;
            let (to, other_sign) = edge_number(other, images[usize::from(a)], images[usize::from(b)])?;
            let is_same = (sign == other_sign) == agrees;
            let relative = if is_same { Sign::Plus } else { Sign::Minus };
            if self.edges.unite(from, to, relative) == ParityUnion::Contradicts {
                return None;
            }
        }
        Some(())
    }

    /// The integers on edges whose sums around triangles are 0, and along a fiber 1.
    fn solve(&mut self, bundle: &mut Fibration<'_>, core: &[usize]) -> Option<()> {
        let mut columns = vec![None; self.values.len()];
        let mut roots = Vec::new();
        let mut entries: Vec<(usize, usize, i64)> = Vec::new();
        let mut row = 0;
        let mut add =
            |edges: &mut ParityUnionFind, row, tetrahedron, [a, b]: [u8; 2], times: i64| -> Option<()> {
                let (number, sign) = edge_number(tetrahedron, a, b)?;
                let (root, parity) = edges.find(number);
                let column = *columns[root as usize].get_or_insert_with(|| {
                    roots.push(root);
                    roots.len() - 1
                });
                entries.push((row, column, times * sign * of_sign(parity)));
                Some(())
            };
        for &tetrahedron in core {
            for facet in 0..4_u8 {
                let mut corners = (0..4).filter(|&vertex| vertex != facet);
                let [a, b, c] = [corners.next()?, corners.next()?, corners.next()?];
                for ends in [[a, b], [b, c], [c, a]] {
                    add(&mut self.edges, row, tetrahedron, ends, 1)?;
                }
                row += 1;
            }
        }
        for Chain { ends: [own, other], edges, agrees } in &bundle.chains {
            let sign = if *agrees { -1 } else { 1 };
            for (edge, corner) in edges.iter().zip([1, 2]) {
                let there = [other.labels[0], other.labels[corner]];
                add(&mut self.edges, row, other.tetrahedron, there, sign)?;
                for (times, corner) in edge.iter().zip([1, 2]) {
                    add(&mut self.edges, row, own.tetrahedron, [own.labels[0], own.labels[corner]], *times)?;
                }
                row += 1;
            }
        }
        // One fiber of each piece.
        let mut rows = Vec::new();
        for (stack, standings) in bundle.stacks.stacks.iter().enumerate() {
            if bundle.fibers.find(stack as u32).0 as usize != stack {
                continue;
            }
            for standing in standings.iter().filter(|standing| standing.raised == 0) {
                add(&mut self.edges, row, standing.tetrahedron, [standing.vertices[0], standing.upper], 1)?;
            }
            rows.push(row);
            row += 1;
        }
        let matrix = SparseMatrix::from_entries(row, roots.len(), entries).ok()?;
        let smith = smith_form_with_transforms(&matrix);
        let mut wanted = vec![Integer::ZERO; row];
        for row in rows {
            wanted[row] = Integer::ONE;
        }
        let right_side = smith.left().times_vector(&wanted).ok()?;
        let mut solution = vec![Integer::ZERO; roots.len()];
        for (at, value) in right_side.iter().enumerate() {
            match smith.form().diagonal().get(at) {
                Some(factor) if !factor.is_zero() => {
                    let (quotient, rest) = value.div_rem_floor(factor);
                    if !rest.is_zero() {
                        return None;
                    }
                    solution[at] = quotient;
                }
                _ if value.is_zero() => {}
                _ => return None,
            }
        }
        let solution = smith.right().times_vector(&solution).ok()?;
        for (&root, value) in roots.iter().zip(&solution) {
            self.values[root as usize] = Some(value.to_i64()?);
        }
        Some(())
    }

    /// The value from vertex a to vertex b of a tetrahedron, upwards as it is there.
    fn value(&self, tetrahedron: usize, a: u8, b: u8) -> Option<i64> {
        let (number, sign) = edge_number(tetrahedron, a, b)?;
        let (root, parity) = self.edges.clone().find(number);
        Some(sign * of_sign(parity) * self.values[root as usize]?)
    }
}
