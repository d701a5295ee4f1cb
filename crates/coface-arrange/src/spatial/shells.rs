//! Shells: what the two sides of the faces close up to.

use super::PolygonalComplex;
use super::face_planes::{FacePlanes, lexicographic};
use super::predicates::SpatialPredicates;
use super::radial_order::{EdgeView, RadialOrder};
use coface_algebra::{ParityUnion, ParityUnionFind, RaggedArray, Sign, UnionFind};
use std::cmp::Ordering;

const NONE: u32 = u32::MAX;

/// The partition of half-faces into shells, and of faces into components that are joined by edges.
///
/// Half-face `2 * face` is the back of a face, the one that a cell behind it has as its boundary with the sign plus;
/// half-face `2 * face + 1` is its front.
#[derive(Clone, Debug)]
pub(super) struct Shells {
    /// The shell of each half-face; shells are numbered by their lowest half-faces.
    pub(super) shell_of: Vec<u32>,
    pub(super) shell_count: usize,
    /// The component of each shell; components are numbered by their lowest faces.
    pub(super) component_of_shell: Vec<u32>,
    /// The edge that each component is reached by first, from its lexicographically least vertex.
    pub(super) anchors: Vec<[u32; 2]>,
    /// The shell of each component that is seen from far away.
    pub(super) outer: Vec<u32>,
}

impl Shells {
    /// Unites half-faces that look at each other across the gaps around the edges: faces across edges with two sides
    /// first, then what is left of them at the other edges.
    pub(super) fn new(
        complex: &PolygonalComplex,
        predicates: &impl SpatialPredicates,
        planes: &FacePlanes,
        order: &RadialOrder,
    ) -> Self {
        let (mut half_faces, node_of_face) = patches(complex.face_count(), order.lists());
        // Half-face h of a face whose back is half-face 2p + s of patch p.
        let node = |half: u32| node_of_face[(half >> 1) as usize] ^ (half & 1);
        for sides in order.lists().iter().filter(|sides| sides.len() != 2) {
            for (i, &side) in sides.iter().enumerate() {
                // Counterclockwise of a side that runs with its edge is its front, clockwise its back.
                half_faces.unite(node(side ^ 1), node(sides[if i + 1 == sides.len() { 0 } else { i + 1 }]));
            }
        }
        let mut shell_of_node = vec![NONE; half_faces.len()];
        let mut shell_count = 0;
        let mut shell_of = Vec::with_capacity(2 * node_of_face.len());
        for half in 0..2 * node_of_face.len() as u32 {
            let shell = &mut shell_of_node[half_faces.find(node(half)) as usize];
            if *shell == NONE {
                *shell = shell_count as u32;
                shell_count += 1;
            }
            shell_of.push(*shell);
        }
        let mut joined = UnionFind::new(shell_count);
        for pair in shell_of.as_chunks::<2>().0 {
            joined.unite(pair[0], pair[1]);
        }
        let component_of_shell = joined.class_numbers();
        let mut shells =
            Self { shell_of, shell_count, component_of_shell, anchors: Vec::new(), outer: Vec::new() };
        shells.look_from_outside(complex, predicates, planes, order, joined.class_count());
        shells
    }

    pub(super) fn component_of_face(&self, face: usize) -> u32 {
        self.component_of_shell[self.shell_of[2 * face] as usize]
    }

    /// Finds the shell of each component that is seen from far away.
    ///
    /// From the least vertex v all of a component lies on one side of a plane: all directions u to it have $u \cdot X >
    /// 0$ for $X = (1, \varepsilon, \varepsilon^2)$. With a direction Y at right angles to X the edge at v of least
    /// slope $(u \cdot Y) / (u \cdot X)$ is outermost in the cone of the component, and the half-plane from it towards
    /// -Y is outside. Y is $X \times Z$ for $Z = (-\varepsilon - \varepsilon^2 \zeta, 1, \zeta)$ and $\varepsilon \ll
    /// \zeta \ll 1$, so that all signs are signs of single coordinates of normals and no direction is special.
    fn look_from_outside(
        &mut self,
        complex: &PolygonalComplex,
        predicates: &impl SpatialPredicates,
        planes: &FacePlanes,
        order: &RadialOrder,
        component_count: usize,
    ) {
        let component_at = |edge: usize| {
            let side = order.at(edge).first()?;
            Some(self.component_of_face((side >> 1) as usize) as usize)
        };
        let mut lowest = vec![NONE; component_count];
        // The component that each vertex was looked at in last: most are in one only.
        let mut seen_in = vec![NONE as usize; complex.vertex_count()];
        for (edge, ends) in complex.edges().iter().enumerate() {
            let Some(component) = component_at(edge) else { continue };
            for &end in ends {
                if std::mem::replace(&mut seen_in[end as usize], component) == component {
                    continue;
                }
                let known = &mut lowest[component];
                if *known == NONE || lexicographic(predicates, end, *known).is_lt() {
                    *known = end;
                }
            }
        }
        let mut anchors = vec![[NONE; 2]; component_count];
        let mut edges = vec![0; component_count];
        for (edge, &[a, b]) in complex.edges().iter().enumerate() {
            let Some(component) = component_at(edge) else { continue };
            let from = lowest[component];
            let to = if a == from {
                b
            } else if b == from {
                a
            } else {
                continue;
            };
            let best = anchors[component][1];
            if best == NONE || slope(predicates, from, to, best).is_lt() {
                anchors[component] = [from, to];
                edges[component] = edge;
            }
        }
        let outer = edges.iter().map(|&edge| {
            let view = EdgeView::new(complex, predicates, planes, edge);
            let ends = view.ends();
            let towards_outside = |apex: u32| {
                let normal = |axis| predicates.normal_sign(axis, [ends[0], ends[1], apex]);
                normal(2).reverse().then_with(|| normal(1)).then_with(|| normal(0).reverse())
            };
            let last = view.last_before(order.at(edge), towards_outside);
            self.shell_of[(last ^ 1) as usize]
        });
        self.outer = outer.collect();
        self.anchors = anchors;
    }
}

/// Faces joined across edges with two sides to patches, whose half-faces 2p and 2p + 1 are the two sides of patch p;
/// and the half-face of a patch that the back of each face is part of. The half-faces of a patch that has only one side
/// are one already.
fn patches(face_count: usize, around: &RaggedArray) -> (UnionFind, Vec<u32>) {
    let mut faces = ParityUnionFind::new(face_count);
    let mut one_sided = Vec::new();
    for sides in around.iter() {
        if let &[s, t] = sides {
            // Sides that run against each other have the same face in front.
            let sign = if (s ^ t) & 1 == 1 { Sign::Plus } else { Sign::Minus };
            if faces.unite(s >> 1, t >> 1, sign) == ParityUnion::Contradicts {
                one_sided.push(s >> 1);
            }
        }
    }
    let mut patch_of_root = vec![NONE; face_count];
    let mut count = 0;
    let node_of_face: Vec<u32> = (0..face_count as u32)
        .map(|face| {
            let (root, sign) = faces.find(face);
            let patch = &mut patch_of_root[root as usize];
            if *patch == NONE {
                *patch = count;
                count += 1;
            }
            2 * *patch + u32::from(sign == Sign::Minus)
        })
        .collect();
    let mut half_faces = UnionFind::new(2 * count as usize);
    for face in one_sided {
        let node = node_of_face[face as usize];
        half_faces.unite(node, node ^ 1);
    }
    (half_faces, node_of_face)
}

/// How the slope of the direction from `v` to `a` compares with that to `b`: the sign of their product along Z.
fn slope(predicates: &impl SpatialPredicates, v: u32, a: u32, b: u32) -> Ordering {
    let product = |axis| predicates.normal_sign(axis, [v, a, b]);
    product(1).then_with(|| product(2)).then_with(|| product(0).reverse())
}
