//! Halfedges in order around their vertices, and the orbits that they make around faces.

use coface_algebra::progress::stage;
use coface_algebra::{RaggedArray, UnionFind};
use coface_geometry::predicates::{PlanarLine, direction_turn};
use std::sync::atomic::AtomicU32;
use std::sync::atomic::Ordering::Relaxed;

/// No face, no orbit, no edge.
pub(crate) const NONE: u32 = u32::MAX;

/// How edges go around vertices and faces. Halfedge 2e goes along edge e from its lower to its upper end, 2e + 1 back.
#[derive(Clone, Debug, PartialEq)]
pub struct Orbits {
    /// The halfedges that leave each vertex, counterclockwise from straight down (exclusive).
    pub(crate) rotation: RaggedArray,
    /// The halfedge after each around the face on its left.
    pub(crate) next: Vec<u32>,
    /// The halfedges around each face side, each list from its lowest; by rising first halfedges.
    pub(crate) orbits: RaggedArray,
    /// The face side that each halfedge is on.
    pub(crate) orbit_of: Vec<u32>,
    /// The connected component of each vertex, by rising lowest vertices.
    pub(crate) component_of: Vec<u32>,
    /// The lowest vertex of each component.
    pub(crate) lowest_vertices: Vec<u32>,
    /// The orbit of each component that sees the outside; none for a vertex on its own.
    pub(crate) outer_orbits: Vec<u32>,
}

impl Orbits {
    /// The orbits of straight edges; `departure` is a line along which a halfedge leaves its vertex, in the direction
    /// of leaving.
    ///
    /// The orbits outside take vertices to be in lexicographic order and edges to be straight.
    pub(crate) fn new(
        vertex_count: usize,
        ends: &[[u32; 2]],
        departure: impl Fn(u32) -> PlanarLine + Sync,
    ) -> Self {
        Self::in_order(vertex_count, ends, |list, leaving: &mut Vec<(PlanarLine, u32)>| {
            leaving.clear();
            leaving.extend(list.iter().map(|&halfedge| (departure(halfedge), halfedge)));
            leaving.sort_unstable_by(|(s, a), (t, b)| {
                // First those to the right and straight up.
                let is_back = |line: &PlanarLine| line[0] > line[1];
                is_back(s).cmp(&is_back(t)).then_with(|| direction_turn(*t, *s)).then(a.cmp(b))
            });
            list.iter_mut().zip(leaving).for_each(|(halfedge, (_, sorted))| *halfedge = *sorted);
        })
    }

    /// The orbits of edges of any shape; `order` puts the halfedges that leave one vertex counterclockwise from
    /// straight down (exclusive); it is not asked about one alone. It may keep what it needs in its second argument.
    ///
    /// The orbits outside are right for vertices in lexicographic order that are the lowest points of their edges.
    #[doc(hidden)]
    pub fn in_order<Scratch: Default + Send>(
        vertex_count: usize,
        ends: &[[u32; 2]],
        order: impl Fn(&mut [u32], &mut Scratch) + Sync,
    ) -> Self {
        let tails = ends.iter().flat_map(|&ends| ends);
        let mut rotation = RaggedArray::grouped(vertex_count, tails);
        let next: Vec<AtomicU32> = (0..2 * ends.len()).map(|_| AtomicU32::new(0)).collect();
        let steps = stage("ordering edges around vertices", 0);
        rotation.change_lists(|leaving, scratch| {
            steps.pass(leaving.first().map_or(0, |&halfedge| halfedge as usize >> 1));
            if leaving.len() > 1 {
                order(leaving, scratch);
            }
            // Arriving opposite to a halfedge, a face on the left goes on clockwise. Each place is written once.
            let mut after = leaving.last().copied().unwrap_or(NONE);
            for &halfedge in &*leaving {
                next[(halfedge ^ 1) as usize].store(after, Relaxed);
                after = halfedge;
            }
        });
        drop(steps);
        let next: Vec<u32> = next.into_iter().map(AtomicU32::into_inner).collect();
        let _steps = stage("walking around faces", 0);
        let ((orbits, orbit_of), mut components) =
            rayon::join(|| walks(&next), || components(vertex_count, ends));
        let component_of = components.class_numbers();
        let mut lowest_vertices = Vec::with_capacity(components.class_count());
        for (vertex, &component) in component_of.iter().enumerate() {
            if component as usize == lowest_vertices.len() {
                lowest_vertices.push(vertex as u32);
            }
        }
        let mut found = Self {
            rotation,
            next,
            orbits,
            orbit_of,
            component_of,
            lowest_vertices,
            outer_orbits: Vec::new(),
        };
        found.outer_orbits =
            found.lowest_vertices.iter().map(|&vertex| found.orbit_outside(vertex)).collect();
        found
    }

    /// The same orbits with others on the outside, one for each component.
    #[doc(hidden)]
    #[must_use]
    pub fn with_outer_orbits(mut self, outer_orbits: Vec<u32>) -> Self {
        self.outer_orbits = outer_orbits;
        self
    }

    /// The halfedges that leave each vertex, counterclockwise from straight down (exclusive).
    #[doc(hidden)]
    pub fn rotation(&self) -> &RaggedArray {
        &self.rotation
    }

    /// The halfedges around each face side, each list from its lowest; by rising first halfedges.
    #[doc(hidden)]
    pub fn lists(&self) -> &RaggedArray {
        &self.orbits
    }

    /// The number of halfedges.
    #[doc(hidden)]
    pub fn halfedge_count(&self) -> usize {
        self.next.len()
    }

    /// The face side that each halfedge is on.
    #[doc(hidden)]
    pub fn orbit_of(&self) -> &[u32] {
        &self.orbit_of
    }

    /// The connected component of each vertex, by rising lowest vertices.
    #[doc(hidden)]
    pub fn component_of(&self) -> &[u32] {
        &self.component_of
    }

    /// The lowest vertex of each component.
    #[doc(hidden)]
    pub fn lowest_vertices(&self) -> &[u32] {
        &self.lowest_vertices
    }

    /// The orbit outside of a component whose lowest vertex this is; none for a vertex on its own.
    pub(crate) fn orbit_outside(&self, vertex: u32) -> u32 {
        // All edges of the lowest vertex go right or straight up: left of the last one is the outside.
        self.rotation.list(vertex as usize).last().map_or(NONE, |&h| self.orbit_of[h as usize])
    }
}

/// The orbits of a permutation of halfedges, and the one that each halfedge is in.
fn walks(next: &[u32]) -> (RaggedArray, Vec<u32>) {
    let mut orbit_of = vec![NONE; next.len()];
    let (mut starts, mut items) = (vec![0], Vec::with_capacity(next.len()));
    for first in 0..next.len() as u32 {
        if orbit_of[first as usize] != NONE {
            continue;
        }
        let orbit = starts.len() as u32 - 1;
        let mut at = first;
        while orbit_of[at as usize] == NONE {
            orbit_of[at as usize] = orbit;
            items.push(at);
            at = next[at as usize];
        }
        starts.push(items.len() as u32);
    }
    (RaggedArray::from_parts(starts, items).expect("each halfedge is in one orbit"), orbit_of)
}

/// The connected components.
fn components(vertex_count: usize, ends: &[[u32; 2]]) -> UnionFind {
    let mut components = UnionFind::new(vertex_count);
    for &[a, b] in ends {
        components.unite(a, b);
    }
    components
}

/// Which orbits bound which face.
#[derive(Clone, Debug, PartialEq)]
pub struct Faces {
    /// The face on the side of each orbit; none for the unbounded one.
    pub(crate) of_orbit: Vec<u32>,
    /// The orbits around each face: the outer one first, then those around its holes.
    pub(crate) orbits: RaggedArray,
    /// The orbits that bound the unbounded face.
    pub(crate) unbounded_orbits: Vec<u32>,
    /// The face around each component; none for the unbounded one.
    pub(crate) around_component: Vec<u32>,
}

impl Faces {
    /// The faces, given the halfedge directly below each component that has one, with the face on its left, and the
    /// components by rising lowest points.
    #[doc(hidden)]
    pub fn new(orbits: &Orbits, below: &[Option<u32>], components: impl Iterator<Item = usize>) -> Self {
        let mut is_outer = vec![false; orbits.orbits.len()];
        for &orbit in orbits.outer_orbits.iter().filter(|&&orbit| orbit != NONE) {
            is_outer[orbit as usize] = true;
        }
        let mut of_orbit = vec![NONE; is_outer.len()];
        let mut first_orbits = Vec::new();
        for (orbit, _) in is_outer.iter().enumerate().filter(|(_, is_outer)| !**is_outer) {
            of_orbit[orbit] = first_orbits.len() as u32;
            first_orbits.push(orbit as u32);
        }
        let mut around_component = vec![NONE; below.len()];
        for component in components {
            let outer = orbits.outer_orbits[component];
            // What is below starts further left, so its component comes before this one.
            let face = below[component]
                .map_or(NONE, |halfedge| of_orbit[orbits.orbit_of[halfedge as usize] as usize]);
            around_component[component] = face;
            if outer != NONE {
                of_orbit[outer as usize] = face;
            }
        }
        let holes = || orbits.outer_orbits.iter().copied().filter(|&orbit| orbit != NONE);
        let in_faces =
            holes().map(|orbit| (of_orbit[orbit as usize], orbit)).filter(|&(face, _)| face != NONE);
        let grouped = if in_faces.clone().next().is_none() {
            RaggedArray::uniform(1, first_orbits).expect("an orbit for each face")
        } else {
            let owners = (0..first_orbits.len() as u32).zip(first_orbits.iter().copied()).chain(in_faces);
            let (keys, members): (Vec<u32>, Vec<u32>) = owners.unzip();
            let mut grouped = RaggedArray::grouped(first_orbits.len(), keys.iter().copied());
            grouped.items_mut().iter_mut().for_each(|item| *item = members[*item as usize]);
            grouped
        };
        let unbounded_orbits = holes().filter(|&orbit| of_orbit[orbit as usize] == NONE).collect();
        Self { of_orbit, orbits: grouped, unbounded_orbits, around_component }
    }
}
