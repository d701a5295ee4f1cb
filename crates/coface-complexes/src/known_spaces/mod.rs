//! Known spaces, built by rule: the complexes whose topology the literature states, in every dimension that makes sense.
//!
//! Each function says its rule; lists of facets stand only where no shorter rule is known, mostly as a few base simplices
//! that a group moves around. Vertices are `0..n` in the order the rule names them. Spaces that are made of others are made by
//! [`SimplicialComplex::cone`], [`SimplicialComplex::suspension`], [`SimplicialComplex::join`],
//! [`SimplicialComplex::wedge`], [`SimplicialComplex::connected_sum`] and [`SimplicialComplex::product`].

mod attached_disk;
mod balls;
mod bundles;
mod combinatorial;
mod flat;
mod glued_solid;
mod grids;
mod house;
mod lens;
mod projective;
mod spheres;
mod sums;

pub use attached_disk::{dunce_hat, moore_space, presentation_complex};
pub use balls::{rudin_ball, ziegler_ball};
pub use bundles::{mapping_torus, sphere_bundle_over_circle, torus_bundle};
pub use combinatorial::{book, chessboard, matching_complex, sum_complex};
pub use flat::{FlatManifold, flat_manifold};
pub use glued_solid::{Solid, glued_solid, prism_manifold, truncated_cube_space};
pub use grids::{
    cyclic_torus, klein_grid, pinched_torus_grid, small_klein_bottle, torus_grid, triangle_strip,
};
pub use house::house_with_two_rooms;
pub use lens::lens_space;
pub use projective::{
    complex_projective_plane, k3_surface, projective_plane, quaternionic_projective_plane,
    real_projective_space,
};
pub use spheres::{
    barnette_sphere, bruckner_sphere, circle, cross_polytope_boundary, simplex, simplex_boundary,
};
pub use sums::oriented_sum;

use crate::simplicial::SimplicialComplex;
use coface_algebra::Error;
use std::collections::BTreeSet;

/// The complex of facets that a rule of this room has made: sorted by the rule or not, without repeated vertices.
fn from_rule(facets: impl IntoIterator<Item = Vec<u32>>) -> Result<SimplicialComplex, Error> {
    SimplicialComplex::from_facets(facets)
}

/// The complex of all images of some base facets under the group that some permutations generate; entry v of a permutation
/// is the image of vertex v.
fn from_orbits(bases: &[&[u32]], generators: &[&[u32]]) -> Result<SimplicialComplex, Error> {
    let mut facets: Vec<Vec<u32>> = Vec::new();
    let mut seen: BTreeSet<Vec<u32>> = BTreeSet::new();
    let mut add = |mut facet: Vec<u32>, facets: &mut Vec<Vec<u32>>| {
        facet.sort_unstable();
        if seen.insert(facet.clone()) {
            facets.push(facet);
        }
    };
    bases.iter().for_each(|base| add(base.to_vec(), &mut facets));
    let mut done = 0;
    while done < facets.len() {
        for generator in generators {
            let image = facets[done].iter().map(|&v| generator[v as usize]).collect();
            add(image, &mut facets);
        }
        done += 1;
    }
    from_rule(facets)
}

/// `Ok` if `holds`; else an error that says what the rule needs.
fn require(holds: bool, what: impl FnOnce() -> String) -> Result<(), Error> {
    if holds { Ok(()) } else { Err(Error::invalid(what())) }
}

/// Calls `visit` with every order of `0..count`.
fn for_each_permutation(count: usize, visit: &mut dyn FnMut(&[usize])) {
    fn extend(order: &mut Vec<usize>, count: usize, visit: &mut dyn FnMut(&[usize])) {
        if order.len() == count {
            return visit(order);
        }
        for i in 0..count {
            if !order.contains(&i) {
                order.push(i);
                extend(order, count, visit);
                order.pop();
            }
        }
    }
    extend(&mut Vec::with_capacity(count), count, visit);
}
