//! Tetrahedra in stacks: products of a triangle and a circle.
//!
//! A tetrahedron **stands** on a base triangle when one of its edges is vertical, that is over one corner of the triangle. The two facets at
//! that edge are vertical, over sides of the triangle; the two others are horizontal. Through horizontal facets tetrahedra follow each
//! other upwards, each with the next of the vertical edges over the three corners. A **stack** is such a chain that comes back to where it
//! began, corner by corner: the product of the base triangle and a circle. A tetrahedron **lies** on a side of a triangle when two opposite
//! edges of it are vertical.

use super::layered::SolidTorus;
use coface_complexes::gluing::{FaceClasses, GluingTable};

/// The edges of a tetrahedron by their ends.
pub(super) const EDGES: [[u8; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

/// Choices of vertical edges that are followed at most.
const CHOICES: usize = 4096;

/// Stacks of three tetrahedra that are looked at, at most.
const CANDIDATES: usize = 64;

/// A tetrahedron in a stack.
#[derive(Clone, Copy, Debug)]
pub(super) struct Standing {
    pub(super) tetrahedron: usize,
    /// The corner of the base that the vertical edge is over.
    pub(super) raised: usize,
    /// For each corner of the base the vertex over it; over the raised one the lower.
    pub(super) vertices: [u8; 3],
    /// The upper vertex over the raised corner.
    pub(super) upper: u8,
}

/// A product of a triangle and a circle, its tetrahedra from below.
pub(super) type Stack = Vec<Standing>;

/// A core of tetrahedra that is made of stacks, between layered solid tori.
pub(super) struct Stacks {
    pub(super) stacks: Vec<Stack>,
    /// For each tetrahedron its stack and its place there; nothing for those that lie on sides, and in solid tori.
    pub(super) places: Vec<Option<(usize, usize)>>,
    /// The tetrahedra that lie on sides.
    pub(super) lying: Vec<usize>,
}

impl Stacks {
    pub(super) fn standing(&self, tetrahedron: usize) -> Option<&Standing> {
        self.places[tetrahedron].map(|(stack, place)| &self.stacks[stack][place])
    }

    /// Every way to see the tetrahedra outside of the solid tori as stacks, up to a number of choices.
    pub(super) fn all(table: &GluingTable, faces: &FaceClasses, tori: &[SolidTorus]) -> Vec<Self> {
        let mut core: Vec<usize> = (0..table.simplex_count()).collect();
        core.retain(|tetrahedron| !tori.iter().any(|torus| torus.tetrahedra.contains(tetrahedron)));
        let Some(&first) = core.first() else { return Vec::new() };
        let class =
            |tetrahedron: usize, ends: [u8; 2]| faces.of_face(tetrahedron, 1 << ends[0] | 1 << ends[1]).0;
        // Neighbors behind each other: choices fail early.
        let mut order = vec![first];
        let mut at = 0;
        while at < order.len() {
            for facet in 0..4 {
                if let Some((next, _)) = table.neighbor(order[at], facet)
                    && core.contains(&next)
                    && !order.contains(&next)
                {
                    order.push(next);
                }
            }
            at += 1;
        }
        if order.len() < core.len() {
            return Vec::new();
        }
        let classes: Vec<[usize; 6]> =
            order.iter().map(|&tetrahedron| EDGES.map(|ends| class(tetrahedron, ends))).collect();
        let count = faces.class_counts().get(1).copied().unwrap_or(0);
        let mut search = Search { classes: &classes, left: CHOICES, found: Vec::new() };
        search.choose(0, &vec![None; count]);
        search.found.into_iter().filter_map(|vertical| Self::of(table, &order, &classes, &vertical)).collect()
    }

    /// Sets of stacks of three tetrahedra each, outside of the solid tori, no two with a tetrahedron in common; all others lie between them. Stacks of
    /// one set may have different ideas of what is vertical.
    pub(super) fn apart(table: &GluingTable, tori: &[SolidTorus]) -> Vec<Self> {
        let count = table.simplex_count();
        let mut is_core = vec![true; count];
        for &tetrahedron in tori.iter().flat_map(|torus| &torus.tetrahedra) {
            is_core[tetrahedron] = false;
        }
        let candidates: Vec<Stack> = (0..count)
            .filter(|&tetrahedron| is_core[tetrahedron])
            .flat_map(|tetrahedron| short_stacks(table, &is_core, tetrahedron))
            .take(CANDIDATES)
            .collect();
        let mut sets = Vec::new();
        let mut chosen = Vec::new();
        collect_sets(&candidates, 0, &mut vec![false; count], &mut chosen, &mut sets);
        // Large sets first: they leave less in between.
        sets.sort_by_key(|set| std::cmp::Reverse(set.len()));
        let with_places = |set: Vec<usize>| {
            let stacks: Vec<Stack> = set.into_iter().map(|at| candidates[at].clone()).collect();
            let mut places = vec![None; count];
            for (number, stack) in stacks.iter().enumerate() {
                for (place, standing) in stack.iter().enumerate() {
                    places[standing.tetrahedron] = Some((number, place));
                }
            }
            let lying = (0..count).filter(|&at| is_core[at] && places[at].is_none()).collect();
            Self { stacks, places, lying }
        };
        sets.into_iter().map(with_places).collect()
    }

    /// The stacks with these vertical edges.
    fn of(table: &GluingTable, core: &[usize], classes: &[[usize; 6]], vertical: &[bool]) -> Option<Self> {
        let mut edges = vec![None; table.simplex_count()];
        let mut lying = Vec::new();
        for (at, &tetrahedron) in core.iter().enumerate() {
            let own: Vec<usize> = (0..6).filter(|&edge| vertical[classes[at][edge]]).collect();
            match own[..] {
                [only] => edges[tetrahedron] = Some(EDGES[only]),
                _ => lying.push(tetrahedron),
            }
        }
        let mut found = Self { stacks: Vec::new(), places: vec![None; table.simplex_count()], lying };
        for &tetrahedron in core {
            if edges[tetrahedron].is_none() || found.places[tetrahedron].is_some() {
                continue;
            }
            let stack = stack_from(table, &edges, tetrahedron)?;
            for (place, standing) in stack.iter().enumerate() {
                let slot = &mut found.places[standing.tetrahedron];
                if slot.replace((found.stacks.len(), place)).is_some() {
                    return None;
                }
            }
            // A vertical edge over each corner.
            if (0..3).any(|corner| stack.iter().all(|standing| standing.raised != corner)) {
                return None;
            }
            found.stacks.push(stack);
        }
        Some(found)
    }
}

/// The search for edges that are vertical: one in each tetrahedron, or two opposite ones.
struct Search<'a> {
    classes: &'a [[usize; 6]],
    left: usize,
    found: Vec<Vec<bool>>,
}

impl Search<'_> {
    fn choose(&mut self, at: usize, known: &[Option<bool>]) {
        if self.left == 0 {
            return;
        }
        self.left -= 1;
        let Some(classes) = self.classes.get(at) else {
            self.found.push(known.iter().map(|state| *state == Some(true)).collect());
            return;
        };
        for choice in 0..9 {
            // Edges i and 5 - i are opposite.
            let is_chosen =
                |edge: usize| edge == choice || choice > 5 && (edge == choice - 6 || edge == 11 - choice);
            let mut next = known.to_vec();
            let fits =
                (0..6).all(|edge| *next[classes[edge]].get_or_insert(is_chosen(edge)) == is_chosen(edge));
            if fits {
                self.choose(at + 1, &next);
            }
        }
    }
}

/// The stack from this tetrahedron upwards, if it comes back to it as it began.
fn stack_from(table: &GluingTable, edges: &[Option<[u8; 2]>], start: usize) -> Option<Stack> {
    let [lower, upper] = edges[start]?;
    let mut beside = (0..4).filter(|&vertex| vertex != lower && vertex != upper);
    let vertices = [lower, beside.next()?, beside.next()?];
    let first = Standing { tetrahedron: start, raised: 0, vertices, upper };
    let mut stack = vec![first];
    loop {
        let last = stack.last()?;
        // The facet on top is across the lower vertex.
        let (next, images) = table.neighbor(last.tetrahedron, usize::from(last.vertices[last.raised]))?;
        let mut top = last.vertices;
        top[last.raised] = last.upper;
        let vertices = top.map(|vertex| images[usize::from(vertex)]);
        if next == start {
            return (vertices == first.vertices).then_some(stack);
        }
        if stack.iter().any(|standing| standing.tetrahedron == next) {
            return None;
        }
        let ends = edges[next]?;
        let raised = vertices.iter().position(|vertex| ends.contains(vertex))?;
        let upper = if ends[0] == vertices[raised] { ends[1] } else { ends[0] };
        if vertices.contains(&upper) {
            return None;
        }
        stack.push(Standing { tetrahedron: next, raised, vertices, upper });
    }
}

/// The sets of candidates from one on, none with a tetrahedron in common, up to a number.
fn collect_sets(
    candidates: &[Stack],
    from: usize,
    is_taken: &mut Vec<bool>,
    chosen: &mut Vec<usize>,
    sets: &mut Vec<Vec<usize>>,
) {
    for at in from..candidates.len() {
        if sets.len() >= CHOICES {
            return;
        }
        let members = || candidates[at].iter().map(|standing| standing.tetrahedron);
        if members().any(|tetrahedron| is_taken[tetrahedron]) {
            continue;
        }
        members().for_each(|tetrahedron| is_taken[tetrahedron] = true);
        chosen.push(at);
        sets.push(chosen.clone());
        collect_sets(candidates, at + 1, is_taken, chosen, sets);
        chosen.pop();
        members().for_each(|tetrahedron| is_taken[tetrahedron] = false);
    }
}

/// The stacks of three tetrahedra, one vertical edge over each corner, of which this one is the first by number; each once.
fn short_stacks(table: &GluingTable, is_core: &[bool], start: usize) -> Vec<Stack> {
    let mut found = Vec::new();
    for [lower, upper] in EDGES {
        let mut beside = (0..4).filter(|&vertex| vertex != lower && vertex != upper);
        let (Some(one), Some(two)) = (beside.next(), beside.next()) else { continue };
        let first = Standing { tetrahedron: start, raised: 0, vertices: [lower, one, two], upper };
        'orders: for order in [[1, 2], [2, 1]] {
            let mut stack = vec![first];
            for raised in order.into_iter().map(Some).chain([None]) {
                let last = stack[stack.len() - 1];
                let Some((next, images)) =
                    table.neighbor(last.tetrahedron, usize::from(last.vertices[last.raised]))
                else {
                    continue 'orders;
                };
                let mut top = last.vertices;
                top[last.raised] = last.upper;
                let vertices = top.map(|vertex| images[usize::from(vertex)]);
                let Some(raised) = raised else {
                    if next == start && vertices == first.vertices {
                        found.push(stack);
                    }
                    continue 'orders;
                };
                if next <= start
                    || !is_core[next]
                    || stack.iter().any(|standing| standing.tetrahedron == next)
                {
                    continue 'orders;
                }
                // The vertex that is not below.
                let upper = 6 - vertices.iter().sum::<u8>();
                stack.push(Standing { tetrahedron: next, raised, vertices, upper });
            }
        }
    }
    found
}
