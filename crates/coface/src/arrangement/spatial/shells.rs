//! Shells: what the two sides of the faces close up to.

use super::PolygonalComplex;
use super::face_planes::{FacePlane, lexicographic};
use super::predicates::SpatialPredicates;
use super::radial_order::{EdgeView, RadialOrder};
use crate::algebra::UnionFind;
use std::cmp::Ordering;

/// The partition of half-faces into shells, and of faces into components that are joined by edges.
///
/// Half-face `2 * face` is the back of a face, the one that a cell behind it has as its boundary with the sign plus; half-face
/// `2 * face + 1` is its front.
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
    /// Unites half-faces that look at each other across the gaps around the edges.
    pub(super) fn new(
        complex: &PolygonalComplex,
        predicates: &impl SpatialPredicates,
        planes: &[FacePlane],
        order: &RadialOrder,
    ) -> Self {
        let mut half_faces = UnionFind::new(2 * complex.face_count());
        for edge in 0..complex.edge_count() {
            let sides = order.at(edge);
            for (i, &side) in sides.iter().enumerate() {
                // Counterclockwise of a side that runs with its edge is its front, clockwise its back.
                half_faces.unite(side ^ 1, sides[if i + 1 == sides.len() { 0 } else { i + 1 }]);
            }
        }
        let shell_of = half_faces.class_numbers();
        let shell_count = half_faces.class_count();
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
    /// From the least vertex v all of a component lies on one side of a plane: all directions u to it have $u \cdot X > 0$ for
    /// $X = (1, \varepsilon, \varepsilon^2)$. With a direction Y at right angles to X the edge at v of least slope
    /// $(u \cdot Y) / (u \cdot X)$ is outermost in the cone of the component, and the half-plane from it towards -Y is outside. Y is
    /// $X \times Z$ for $Z = (-\varepsilon - \varepsilon^2 \zeta, 1, \zeta)$ and $\varepsilon \ll \zeta \ll 1$, so that all signs are
    /// signs of single coordinates of normals and no direction is special.
    fn look_from_outside(
        &mut self,
        complex: &PolygonalComplex,
        predicates: &impl SpatialPredicates,
        planes: &[FacePlane],
        order: &RadialOrder,
        component_count: usize,
    ) {
        const NONE: u32 = u32::MAX;
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

/// How the slope of the direction from `v` to `a` compares with that to `b`: the sign of their product along Z.
fn slope(predicates: &impl SpatialPredicates, v: u32, a: u32, b: u32) -> Ordering {
    let product = |axis| predicates.normal_sign(axis, [v, a, b]);
    product(1).then_with(|| product(2)).then_with(|| product(0).reverse())
}
