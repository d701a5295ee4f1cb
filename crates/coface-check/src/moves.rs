//! Bistellar moves: a link that they lead to the boundary of a simplex is a sphere, or without the cone over its boundary a ball.

use crate::Fault;
use crate::json::{field, index, list, optional};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

const STEP: &str = "links";

/// Follows the moves of the link of each vertex, by rising vertices. Where no step fails, all links are spheres or balls.
pub(crate) fn follow(logs: &Value, links: &BTreeMap<u32, Vec<Vec<u32>>>) -> Result<(), Fault> {
    let logs = list(logs, "\"links\"", STEP)?;
    if logs.len() != links.len() {
        let message = format!("there are moves of {} links, and {} vertices", logs.len(), links.len());
        return Err(Fault::new(STEP, message));
    }
    for (log, (vertex, link)) in logs.iter().zip(links) {
        let fault = |message: String| Fault::new(STEP, format!("the link of vertex {vertex}: {message}"));
        let mut facets = Facets::default();
        link.iter().for_each(|facet| facets.insert(&sorted(facet)));
        if let Some(apex) = optional(log, "apex") {
            let apex = index(apex, "an apex", STEP)?;
            if facets.0.contains_key(&apex) {
                return Err(fault(format!("the apex {apex} is a vertex of it")));
            }
            facets
                .rim()
                .into_iter()
                .for_each(|ridge| facets.insert(&sorted(&[&ridge[..], &[apex]].concat())));
        }
        let size = link[0].len();
        for (number, one) in list(field(log, "moves", STEP)?, "\"moves\"", STEP)?.iter().enumerate() {
            let [removed, added] = list(one, "a move", STEP)? else {
                return Err(fault(format!("move {number} is no pair of simplices")));
            };
            let (removed, added) = (simplex(removed)?, simplex(added)?);
            if !facets.replace(&removed, &added, size) {
                return Err(fault(format!("move {number}, from {removed:?} to {added:?}, is none")));
            }
        }
        if [facets.count(size), facets.0.len()] != [size + 1; 2] {
            return Err(fault("the moves do not end at the boundary of a simplex".to_owned()));
        }
    }
    Ok(())
}

/// Vertices, rising and different.
fn simplex(value: &Value) -> Result<Vec<u32>, Fault> {
    let vertices = list(value, "a simplex", STEP)?.iter().map(|vertex| index(vertex, "a vertex", STEP));
    let mut vertices = sorted(&vertices.collect::<Result<Vec<u32>, Fault>>()?);
    vertices.dedup();
    Ok(vertices)
}

fn sorted(vertices: &[u32]) -> Vec<u32> {
    let mut vertices = vertices.to_vec();
    vertices.sort_unstable();
    vertices
}

/// For each vertex the facets that have it.
#[derive(Default)]
struct Facets(BTreeMap<u32, BTreeSet<Vec<u32>>>);

impl Facets {
    fn insert(&mut self, facet: &[u32]) {
        for &vertex in facet {
            self.0.entry(vertex).or_default().insert(facet.to_owned());
        }
    }

    fn remove(&mut self, facet: &[u32]) {
        for vertex in facet {
            let star = self.0.get_mut(vertex);
            if star.is_some_and(|star| star.remove(facet) && star.is_empty()) {
                self.0.remove(vertex);
            }
        }
    }

    /// The number of facets of so many vertices.
    fn count(&self, size: usize) -> usize {
        self.0.values().map(BTreeSet::len).sum::<usize>() / size
    }

    /// The faces without one vertex that lie in one facet alone.
    fn rim(&self) -> Vec<Vec<u32>> {
        let mut counts: BTreeMap<Vec<u32>, usize> = BTreeMap::new();
        for (vertex, star) in &self.0 {
            for facet in star {
                let ridge = facet.iter().copied().filter(|other| other != vertex).collect();
                *counts.entry(ridge).or_default() += 1;
            }
        }
        counts.into_iter().filter(|(_, count)| *count == 1).map(|(ridge, _)| ridge).collect()
    }

    /// The facets around a simplex.
    fn around(&self, simplex: &[u32]) -> BTreeSet<Vec<u32>> {
        let star = simplex.first().and_then(|vertex| self.0.get(vertex)).into_iter().flatten();
        star.filter(|facet| simplex.iter().all(|vertex| facet.contains(vertex))).cloned().collect()
    }

    /// The join of a simplex with the boundary of another gives way to the join of the boundary of the first with the second, if that is a move:
    /// the first has just these facets around it, and the second is not there.
    fn replace(&mut self, removed: &[u32], added: &[u32], size: usize) -> bool {
        let joins = |whole: &[u32], rim: &[u32]| -> BTreeSet<Vec<u32>> {
            let without = |gone: u32| rim.iter().copied().filter(move |&vertex| vertex != gone);
            rim.iter().map(|&gone| sorted(&[whole, &without(gone).collect::<Vec<_>>()].concat())).collect()
        };
        let are_apart = removed.iter().all(|vertex| !added.contains(vertex));
        let is_move = are_apart
            && !removed.is_empty()
            && !added.is_empty()
            && removed.len() + added.len() == size + 1
            && self.around(removed) == joins(removed, added)
            && self.around(added).is_empty();
        if is_move {
            joins(removed, added).iter().for_each(|facet| self.remove(facet));
            joins(added, removed).iter().for_each(|facet| self.insert(facet));
        }
        is_move
    }
}
