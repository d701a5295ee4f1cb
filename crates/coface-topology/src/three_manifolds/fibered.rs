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
//! Source: H. Seifert, *Topologie dreidimensionaler gefaserter Raeume* (1933); B. A. Burton, *Minimal triangulations and normal
//! surfaces* (2003), for the triangulations.

use super::layered::{Corners, Slope, SolidTorus, Torus, across, fold, folded_slope, layered_edge, step};
use super::seifert::SeifertSpace;
use super::stacks::{EDGES, Stacks, Standing};
use coface_algebra::{
    CellId, Integer, ParityUnion, ParityUnionFind, Sign, SparseMatrix, UnionFind, smith_form_with_transforms,
};
use coface_complexes::gluing::{FaceClasses, GluingTable};

/// The Seifert fibered space that a closed orientable table shows, if it does.
pub(super) fn seifert_space(table: &GluingTable, faces: &FaceClasses) -> Option<SeifertSpace> {
    let tori = SolidTorus::maximal(table);
    let orientation = table.orientation();
    let signs: Vec<i64> =
        (0..table.simplex_count()).map(|at| of_sign(orientation.sign(CellId::new(at)))).collect();
    Stacks::all(table, faces, &tori)
        .iter()
        .find_map(|stacks| Fibration::of(table, stacks, &tori).and_then(|fibration| fibration.space(&signs)))
}

fn of_sign(sign: Sign) -> i64 {
    if sign == Sign::Plus { 1 } else { -1 }
}

/// A hole of the bundle of circles, seen from the bundle, and the meridian of what closes it.
struct Hole {
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
    /// Whether some walk reverses the fibers.
    is_twisted: bool,
    side_count: usize,
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
            is_twisted: false,
            side_count: 0,
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
        (closed.iter().all(|&closed| closed) && found.side_count.is_multiple_of(2)).then_some(found)
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
        self.side_count += 1;
        match beyond? {
            Beyond::Side(other, across) if (other, across) == (stack, side) => {
                let torus = rolled_up(&triangles)?;
                let edge = fold(self.table, &torus)?;
                self.holes.push(Hole { torus, meridian: folded_slope(&[[1, 0], [0, 1]], edge) });
                self.side_count += 1;
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
                self.holes.push(Hole { torus, meridian });
                self.side_count += 1;
                self.close(stack, side);
                return Some(());
            }
            let edge @ [i, j, k] = layered_edge(&[one, two])?;
            // The vertical edge 01 stays.
            if k == 2 || !self.stacks.lying.contains(&one.tetrahedron) {
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
        let mut agrees = Vec::new();
        for corners in ends {
            let standing = *self.stacks.standing(corners.tetrahedron)?;
            let (lower, upper) = (standing.vertices[standing.raised], standing.upper);
            let labels = corners.labels;
            agrees.push(match (labels[0], labels[1]) {
                pair if pair == (lower, upper) => true,
                pair if pair == (upper, lower) => false,
                _ => return None,
            });
            let apex = (0..3).find(|&c| c != standing.raised && standing.vertices[c] == labels[2])?;
            images.push(Vertical { standing, apex });
        }
        let across = images[0].side();
        if again != other || images[1].side() != across || self.triangles(other, across).len() != 2 {
            return None;
        }
        let own = self.triangles(stack, side);
        for (triangle, image) in own.iter().zip(&images) {
            let (from, to) = (3 * stack + triangle.standing.raised, 3 * other + image.standing.raised);
            self.corners.unite(from as u32, to as u32);
        }
        // Edge 01 of the first triangle goes upwards here, and the one there is it or its reverse.
        let along = match edges[0] {
            [1, 0] => true,
            [-1, 0] => false,
            _ => return None,
        };
        let agrees = agrees[0] == along;
        let sign = if agrees { Sign::Plus } else { Sign::Minus };
        if self.fibers.unite(stack as u32, other as u32, sign) == ParityUnion::Contradicts {
            self.is_twisted = true;
        }
        self.chains.push(Chain { ends: [torus[0], ends[0]], edges, agrees });
        Some(())
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
            _ => return None,
        };
        let apex = (0..3).find(|&c| c != standing.raised && standing.vertices[c] == partner.labels[2])?;
        let image = Vertical { standing, apex };
        for (corner, other_corner) in [(triangle.standing.raised, standing.raised), (triangle.apex, apex)] {
            if (other, image.side()) != (stack, triangle.side()) {
                self.corners.unite((3 * stack + corner) as u32, (3 * other + other_corner) as u32);
            }
        }
        let sign = if agrees { Sign::Plus } else { Sign::Minus };
        if self.fibers.unite(stack as u32, other as u32, sign) == ParityUnion::Contradicts {
            self.is_twisted = true;
        }
        Some(Beyond::Side(other, image.side()))
    }

    /// The space that is fibered.
    fn space(mut self, signs: &[i64]) -> Option<SeifertSpace> {
        let (vertices, faces) = (self.corners.class_count(), self.stacks.stacks.len() + self.holes.len());
        let characteristic = vertices as i64 - (self.side_count / 2) as i64 + faces as i64;
        let rank = usize::try_from(2 - characteristic).ok()?;
        let is_orientable = !self.is_twisted;
        if is_orientable && rank % 2 == 1 {
            return None;
        }
        let cocycle = Cocycle::of(&mut self)?;
        let mut fibers = Vec::with_capacity(self.holes.len());
        for hole in &self.holes {
            let [one, _] = hole.torus;
            let standing = self.stacks.standing(one.tetrahedron)?;
            let value = |a: u8, b: u8| cocycle.value(one.tetrahedron, a, b);
            let labels = one.labels;
            let [x, y] = hole.meridian;
            let beta = x * value(labels[0], labels[1])? + y * value(labels[0], labels[2])?;
            // Edge 01 is the vertical one.
            let up = if labels[1] == standing.upper { 1 } else { -1 };
            let alpha = -y * up * signs[one.tetrahedron] * parity(labels);
            fibers.push(if alpha < 0 { (-alpha, -beta) } else { (alpha, beta) });
        }
        SeifertSpace::new(is_orientable, if is_orientable { rank / 2 } else { rank }, &fibers)
    }

    /// Whether a facet of a stack is at a hole, or at tetrahedra in no stack.
    fn is_open(&self, tetrahedron: usize, facet: u8) -> bool {
        let is_it = |corners: &Corners| (corners.tetrahedron, corners.labels[3]) == (tetrahedron, facet);
        let beyond = self.table.neighbor(tetrahedron, usize::from(facet)).map(|(next, _)| next);
        beyond.is_none_or(|next| self.stacks.places[next].is_none())
            || self.holes.iter().any(|hole| hole.torus.iter().any(is_it))
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
    fn solve(&mut self, bundle: &Fibration<'_>, core: &[usize]) -> Option<()> {
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
        for standing in bundle.stacks.stacks.first()?.iter().filter(|standing| standing.raised == 0) {
            add(&mut self.edges, row, standing.tetrahedron, [standing.vertices[0], standing.upper], 1)?;
        }
        let matrix = SparseMatrix::from_entries(row + 1, roots.len(), entries).ok()?;
        let smith = smith_form_with_transforms(&matrix);
        let mut wanted = vec![Integer::ZERO; row + 1];
        wanted[row] = Integer::ONE;
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
